//! The reader of `[image]`: the size of the image, and its sampling.

use crate::document::reader::TableReader;
use crate::document::values::{array, boolean, number_where, whole, word};
use crate::scene::{Image, SamplePattern};

/// The number of samples that an adaptive pixel takes before the first test; each later round doubles the total.
const FIRST_SAMPLES: u32 = 16;
/// The largest number of samples after which a pixel can continue.
const MOST_ADAPTIVE: u32 = 32_768;

/// Reads the table; `by_paths` is `true` for path tracing, to which later renders may add samples.
pub fn read(root: &TableReader, by_paths: bool) -> Image {
    let mut image = Image::default();
    if by_paths {
        image.sampler = SamplePattern::Progressive;
    }
    let Some(table) = root.subtable("image", "image") else { return image };
    let size = array("two whole numbers, [width, height]", whole(1..=65_536));
    image.size = table.or("size", image.size, size);
    let samples = table.optional("samples", whole(1..=1_048_576));
    let patterns = &[("multi-jittered", SamplePattern::MultiJittered), ("sobol", SamplePattern::Progressive)];
    let pattern = table.optional("sampler", word(patterns));
    let tolerance = number_where("a standard error above 0 and below 1, in display values", |x| x > 0.0 && x < 1.0);
    image.adaptive = table.optional("adaptive", tolerance);
    if table.gives("adaptive") {
        (image.samples, image.sampler) = (64, SamplePattern::Progressive);
        check_adaptive(&table, samples, pattern);
    }
    image.samples = samples.unwrap_or(image.samples);
    image.sampler = pattern.unwrap_or(image.sampler);
    image.footprints = table.or("footprints", false, boolean);
    if by_paths && image.footprints {
        let problem = "`footprints` cannot be combined with lighting = \"path-tracing\"".to_owned();
        table.fault(&["footprints"], problem, "remove one of the two");
    }
    table.finish();
    image
}

/// Checks the keys that depend on adaptive sampling.
fn check_adaptive(table: &TableReader, samples: Option<u32>, pattern: Option<SamplePattern>) {
    if let Some(samples) = samples.filter(|n| *n < FIRST_SAMPLES || *n > MOST_ADAPTIVE || !n.is_power_of_two()) {
        let problem = format!("adaptive sampling takes 16, 32, 64, … samples, and cannot stop at {samples}");
        table.fault(
            &["samples"],
            problem,
            "use a power of two from 16 to 32768, or remove `samples` to use at most 64",
        );
    }
    if pattern == Some(SamplePattern::MultiJittered) {
        let problem = "adaptive sampling cannot be combined with multi-jittered samples";
        table.fault(&["sampler"], problem, "remove `sampler`, or use sampler = \"sobol\"");
    }
}
