//! Cuts an image into bands of rows that take about equally long.
//!
//! *Theory.* The cost of a band is its number of steps, plus a small cost per ray. Steps are counted, not timed, so that every machine with
//! the same device finds the same cuts, however busy it is.
//!
//! *Practice.* The image is rendered at a small size, strip by strip, by its own program, so nothing is compiled. All rows of a strip are
//! assumed to have equal costs.

use super::{RenderError, Renderer, Window};

/// The longer side of the small image, in pixels.
const SMALL: u32 = 192;
/// The maximum number of strips.
const STRIPS: u32 = 48;
/// The cost of a ray in addition to its steps, in steps.
const RAY: u64 = 8;

impl Renderer<'_> {
    /// Sets the window of the image to render, which must be inside it; `None` selects the whole image.
    pub fn set_window(&mut self, window: Option<Window>) {
        self.prepared.settings.window = window;
    }

    /// Returns the first row of each of `parts` bands, followed by the height of the image. Every band has at least one row, so `parts`
    /// must not exceed the number of rows.
    ///
    /// # Errors
    ///
    /// Returns an error if the device fails or has too little memory.
    pub fn cuts(&mut self, parts: u32) -> Result<Vec<u32>, RenderError> {
        let rows = self.prepared.scene.image.size[1];
        if parts < 2 {
            return Ok(vec![0, rows]);
        }
        let scene = self.prepared.scene.clone().into_owned();
        let mut small = scene.clone();
        let longer = scene.image.size.into_iter().max().unwrap_or(1);
        let side = |side: u32| u64::from(side) * u64::from(SMALL.min(longer)) / u64::from(longer);
        small.image.size = scene.image.size.map(|own| (side(own) as u32).max(1));
        if small.image.adaptive.is_none() {
            // One sample instead of several would require another program.
            small.image.samples = small.image.samples.min(2);
        }
        let window = self.prepared.settings.window;
        self.set_window(None);
        self.set_scene(small)?;
        let costs = self.strip_costs();
        self.set_window(None);
        self.set_scene(scene)?;
        self.set_window(window);
        Ok(equal_cuts(&costs?, rows, parts))
    }

    /// Returns the costs of strips of equal height, from the top.
    fn strip_costs(&mut self) -> Result<Vec<u64>, RenderError> {
        let [width, height] = self.prepared.scene.image.size;
        let strips = height.min(STRIPS);
        let mut costs = Vec::new();
        let _stage =
            self.prepared.gpu.progress.measured("dividing the image into parts of equal cost", f64::from(strips));
        for i in 0..strips {
            let [first, next] = [i, i + 1].map(|i| i * height / strips);
            self.set_window(Some(Window { origin: [0, first], size: [width, next - first] }));
            let totals = self.render_bands(&mut |_| Ok(()))?;
            costs.push((totals.steps + RAY * totals.rays) / u64::from(next - first));
        }
        Ok(costs)
    }
}

/// Returns the cuts of `rows` rows into `parts`, for strips with these costs.
fn equal_cuts(costs: &[u64], rows: u32, parts: u32) -> Vec<u32> {
    let all: u64 = costs.iter().sum();
    let row_of = |share: f64| {
        let mut left = share * all as f64;
        for (i, &cost) in costs.iter().enumerate() {
            if left <= cost as f64 {
                let within = if cost == 0 { 0.0 } else { left / cost as f64 };
                return ((i as f64 + within) / costs.len() as f64 * f64::from(rows)).round() as u32;
            }
            left -= cost as f64;
        }
        rows
    };
    let mut cuts = vec![0];
    for part in 1..parts {
        let least = cuts[cuts.len() - 1] + 1;
        cuts.push(row_of(f64::from(part) / f64::from(parts)).max(least).min(rows - (parts - part)));
    }
    cuts.push(rows);
    cuts
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn cuts_follow_the_cost() {
        assert_eq!(equal_cuts(&[1, 1], 10, 2), [0, 5, 10]);
        assert_eq!(equal_cuts(&[3, 1], 100, 2), [0, 33, 100]);
        assert_eq!(equal_cuts(&[0, 0, 5, 0], 100, 2), [0, 63, 100]);
        assert_eq!(equal_cuts(&[0, 0], 3, 3), [0, 1, 2, 3]);
    }

    proptest! {
        #[test]
        fn bands_have_rows_and_equal_shares(
            costs in prop::collection::vec(0_u64..1000, 1..20),
            (rows, parts) in (1_u32..500).prop_flat_map(|rows| (Just(rows), 1..=rows)),
        ) {
            let cuts = equal_cuts(&costs, rows, parts);
            prop_assert_eq!(cuts.len(), parts as usize + 1);
            prop_assert_eq!((cuts[0], cuts[parts as usize]), (0, rows));
            prop_assert!(cuts.windows(2).all(|ends| ends[0] < ends[1]));
        }
    }
}
