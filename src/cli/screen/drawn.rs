//! The content of the progress display, as a function of the given time.

use std::io::Write;
use std::time::Duration;

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::progress::{Estimate, State};

/// Advice about long work is printed if at least `LONG` remains, once `SURE` has passed and the estimate is reliable.
const LONG: Duration = Duration::from_secs(60);
const SURE: Duration = Duration::from_secs(5);
/// A shorter remaining time is not displayed.
const SHORT: Duration = Duration::from_secs(1);
/// The number of units of the bar.
const BAR: u64 = 1000;

/// A terminal or a log, and the current state of the work.
pub(in crate::cli) struct Screen {
    kind: LineKind,
    /// The current stage: its number, start time, and rate estimate.
    stage: (u64, Duration, Estimate),
    advice: Option<String>,
}

enum LineKind {
    Terminal { target: Box<dyn Fn() -> ProgressDrawTarget + Send>, patience: Duration, line: Option<ProgressBar> },
    Log { every: Duration, next: Duration },
}

impl Screen {
    /// Creates a display on a terminal, which draws nothing before `patience` has passed.
    pub fn terminal(target: impl Fn() -> ProgressDrawTarget + Send + 'static, patience: Duration) -> Self {
        Self::of(LineKind::Terminal { target: Box::new(target), patience, line: None })
    }

    /// Creates a display in a log, with one line per interval `every`.
    pub fn log(every: Duration) -> Self {
        Self::of(LineKind::Log { every, next: every })
    }

    fn of(kind: LineKind) -> Self {
        Self { kind, stage: (0, Duration::ZERO, Estimate::default()), advice: None }
    }

    pub fn advise(&mut self, advice: Option<String>) {
        self.advice = advice;
    }

    /// Removes the line from the terminal.
    pub fn clear(&mut self) {
        if let LineKind::Terminal { line, .. } = &mut self.kind
            && let Some(line) = line.take()
        {
            line.finish_and_clear();
        }
    }

    /// Draws the current work at time `now` since the start; lines of messages go to `out`.
    pub fn look(&mut self, now: Duration, state: Option<&State>, out: &mut dyn Write) {
        let Some(state) = state else { return };
        if self.stage.0 != state.number {
            self.stage = (state.number, now, Estimate::default());
        }
        let (_, begun, estimate) = &mut self.stage;
        let taken = now.saturating_sub(*begun);
        let left = state.done.and_then(|done| {
            estimate.see(taken, done);
            estimate.left(taken)
        });
        let advice = if taken >= SURE && left.is_some_and(|left| left >= LONG) { self.advice.take() } else { None };
        if let Some(advice) = advice {
            self.clear();
            // If the reader is gone, only this line is lost.
            let _ = writeln!(out, "{advice}");
        }
        let time = time(taken, left);
        match &mut self.kind {
            LineKind::Terminal { target, patience, line } if now >= *patience => {
                let line = line.get_or_insert_with(|| ProgressBar::with_draw_target(Some(BAR), target()));
                draw(line, state, time);
            }
            LineKind::Log { every, next } if now >= *next => {
                *next = now + *every;
                let done = state.done.map(|done| format!("{:.0} % done", 100.0 * done));
                let parts: Vec<String> = done.into_iter().chain(time).collect();
                let _ = writeln!(out, "{}: {}", state.words, parts.join(", "));
            }
            LineKind::Terminal { .. } | LineKind::Log { .. } => {}
        }
    }
}

/// Returns the remaining time, or the elapsed time if the remaining time is unknown.
fn time(taken: Duration, left: Option<Duration>) -> Option<String> {
    match left {
        Some(left) => Some(format!("about {} left", HumanDuration(left))),
        None => (taken >= SHORT).then(|| format!("{} so far", HumanDuration(taken))),
    }
}

fn draw(line: &ProgressBar, state: &State, time: Option<String>) {
    // An invalid template would fall back to the default style.
    let template = if state.done.is_some() { "[{bar:24}] {percent:>3} %  {wide_msg}" } else { "{spinner} {wide_msg}" };
    if let Ok(style) = ProgressStyle::with_template(template) {
        line.set_style(style.progress_chars("=> ").tick_chars("-\\|/-"));
    }
    line.update(|bar| bar.set_pos((state.done.unwrap_or(0.0) * BAR as f64) as u64));
    let parts: Vec<String> = std::iter::once(state.words.clone()).chain(time).collect();
    line.set_message(parts.join(", "));
    line.tick();
}

#[cfg(test)]
mod tests {
    use std::io;
    use std::sync::{Arc, Mutex};

    use indicatif::TermLike;

    use super::*;

    /// A terminal of one line: its current text, and every earlier text.
    #[derive(Debug, Clone, Default)]
    struct Line(Arc<Mutex<(String, Vec<String>)>>);

    impl Line {
        fn text(&self) -> String {
            self.0.lock().unwrap().0.trim_end().to_owned()
        }

        fn all(&self) -> Vec<String> {
            self.0.lock().unwrap().1.clone()
        }
    }

    impl TermLike for Line {
        fn width(&self) -> u16 {
            100
        }

        fn move_cursor_up(&self, _: usize) -> io::Result<()> {
            Ok(())
        }

        fn move_cursor_down(&self, _: usize) -> io::Result<()> {
            Ok(())
        }

        fn move_cursor_right(&self, _: usize) -> io::Result<()> {
            Ok(())
        }

        fn move_cursor_left(&self, _: usize) -> io::Result<()> {
            Ok(())
        }

        fn write_line(&self, text: &str) -> io::Result<()> {
            self.write_str(text)
        }

        fn write_str(&self, text: &str) -> io::Result<()> {
            let mut line = self.0.lock().unwrap();
            line.0.push_str(text);
            let whole = line.0.trim_end().to_owned();
            line.1.push(whole);
            Ok(())
        }

        fn clear_line(&self) -> io::Result<()> {
            self.0.lock().unwrap().0.clear();
            Ok(())
        }

        fn flush(&self) -> io::Result<()> {
            Ok(())
        }
    }

    fn state(number: u64, words: &str, done: impl Into<Option<f64>>) -> State {
        State { number, words: words.to_owned(), done: done.into() }
    }

    fn seconds(seconds: f64) -> Duration {
        Duration::from_secs_f64(seconds)
    }

    fn terminal() -> (Line, Screen) {
        let line = Line::default();
        let own = line.clone();
        let target = move || ProgressDrawTarget::term_like_with_hz(Box::new(own.clone()), 255);
        (line, Screen::terminal(target, seconds(0.7)))
    }

    #[test]
    fn a_terminal_shows_the_stage_the_percentage_and_the_time_left() {
        let (line, mut screen) = terminal();
        let mut out = Vec::new();
        screen.look(seconds(0.7), Some(&state(1, "reading bunny.ply", None)), &mut out);
        assert!(line.text().ends_with(" reading bunny.ply"), "{}", line.text());
        std::thread::sleep(seconds(0.01));
        for (now, done) in [(1.0, 0.0), (11.0, 0.25), (12.0, 0.25)] {
            screen.look(seconds(now), Some(&state(2, "rendering", done)), &mut out);
            std::thread::sleep(seconds(0.01));
        }
        assert_eq!(line.text(), "[======>                 ]  25 %  rendering, about 29 seconds left");
        // Messages replace the line.
        screen.clear();
        assert_eq!(line.text(), "");
        assert!(out.is_empty());
    }

    #[test]
    fn quick_work_draws_nothing() {
        let (line, mut screen) = terminal();
        for now in [0.1, 0.3, 0.6] {
            screen.look(seconds(now), Some(&state(1, "rendering", now)), &mut Vec::new());
        }
        screen.look(seconds(5.0), None, &mut Vec::new());
        screen.clear();
        assert!(line.all().is_empty(), "{:?}", line.all());
    }

    #[test]
    fn a_log_has_a_line_in_every_interval_even_within_one_unit() {
        let (mut screen, mut out) = (Screen::log(seconds(30.0)), Vec::new());
        for tenths in 0..1190_u32 {
            let now = f64::from(tenths) / 10.0;
            let done = f64::from(tenths.saturating_sub(400)) / 2500.0;
            let state =
                if tenths < 400 { state(1, "compiling pass 1 of 3", None) } else { state(2, "rendering", done) };
            screen.look(seconds(now), Some(&state), &mut out);
        }
        let text = String::from_utf8(out).unwrap();
        // 20 s and 50 s after its start, the second stage has 230 s and 200 s left.
        let expected = "compiling pass 1 of 3: 30 seconds so far\nrendering: 8 % done, about 4 minutes left\n\
                        rendering: 20 % done, about 3 minutes left\n";
        assert_eq!(text, expected);
    }

    #[test]
    fn advice_is_printed_once_and_only_for_long_work() {
        for (speed, printed) in [(0.1, ""), (0.001, "help: wait\n")] {
            let (_line, mut screen) = terminal();
            let mut out = Vec::new();
            screen.advise(Some("help: wait".to_owned()));
            for now in 1..9 {
                let now = f64::from(now);
                screen.look(seconds(now), Some(&state(1, "rendering", speed * now)), &mut out);
            }
            assert_eq!(String::from_utf8(out).unwrap(), printed);
        }
    }
}
