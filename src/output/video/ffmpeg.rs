//! Video encoding by `ffmpeg`: H.264 in an MP4, VP9 in a `WebM`.
//!
//! *Practice.* `ffmpeg` reads raw pixels from a pipe and writes the temporary file. The number of threads is fixed, because encoders split
//! images by it: one set of frames gives one file on every machine with the same `ffmpeg` version. Colors are BT.709, which players expect
//! of video without color metadata, and the metadata is also written. H.264 requires even sides, so that an odd side gets one more black
//! row or column.

use std::io::{ErrorKind, Write};
use std::process::{Child, Command, Stdio};

use super::{Frames, before_black};
use crate::output::{AtomicFile, OutputError};

const PROGRAM: &str = "ffmpeg";
/// The arguments for each container.
const CODECS: [(&str, &[&str]); 2] = [
    ("mp4", &["-c:v", "libx264", "-preset", "medium", "-crf", "16", "-movflags", "+faststart"]),
    ("webm", &["-c:v", "libvpx-vp9", "-b:v", "0", "-crf", "24", "-row-mt", "0"]),
];
const COLORS: &str = "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";

pub(super) fn problem() -> Option<&'static str> {
    let found = Command::new(PROGRAM).arg("-version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    found.is_err().then_some(
        ".mp4 and .webm require ffmpeg, which is not in the PATH; install it (on Debian and Ubuntu: apt-get install \
         ffmpeg), or write a .gif or an animated .png",
    )
}

pub(super) fn write(file: &mut AtomicFile, frames: &mut Frames, container: &'static str) -> Result<(), OutputError> {
    let path = file.path().to_owned();
    let failed = |problem: String| OutputError::Encode { path: path.clone(), problem };
    let mut child = start(file, frames, container).map_err(|error| failed(error.to_string()))?;
    let mut input = child.stdin.take();
    while let Some(picture) = frames.next()? {
        let Some(pipe) = &mut input else { break };
        let pixels: Vec<u8> = picture.pixels().flat_map(|pixel| before_black(*pixel)).collect();
        match pipe.write_all(&pixels) {
            // The program reports why it stops reading.
            Err(error) if error.kind() == ErrorKind::BrokenPipe => break,
            other => other.map_err(|error| failed(error.to_string()))?,
        }
    }
    drop(input);
    let ended = child.wait_with_output().map_err(|error| failed(error.to_string()))?;
    if ended.status.success() {
        return Ok(());
    }
    let said = String::from_utf8_lossy(&ended.stderr);
    let last = said.lines().last().unwrap_or("no reason given");
    Err(failed(format!("ffmpeg failed: {last}")))
}

fn start(file: &AtomicFile, frames: &Frames, container: &str) -> std::io::Result<Child> {
    let [width, height] = frames.size;
    let codec = CODECS.iter().find(|(name, _)| *name == container).map_or(&[][..], |(_, codec)| *codec);
    Command::new(PROGRAM)
        .args(["-y", "-nostdin", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24"])
        .args(["-s", &format!("{width}x{height}"), "-r", &frames.rate.to_string(), "-i", "-"])
        .args(["-vf", COLORS, "-threads", "4", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-map_metadata", "-1"])
        .args(["-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv"])
        .args(codec)
        .args(["-f", container])
        .arg(file.temporary())
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
}
