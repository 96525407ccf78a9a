//! The samples of a pixel, and the image plane.

use std::collections::BTreeSet;

use bentray::model::Value::Uint2;
use glam::Vec4;

use crate::support::{gpu, probe::Probe};

/// `frame` as a private variable of the probe, so that one program takes every sample.
const FRAME: &str = "struct Frame {
    sample: u32,
}

var<private> frame: Frame;";

const SIDE: u32 = 8;

/// Multi-jittered samples (Kensler 2013): one in each of m × n cells, and one in each of N columns and N rows.
#[test]
fn multi_jittered_samples() {
    let gpu = gpu();
    for grid in [[4_u32, 4], [3, 2], [5, 5], [7, 1], [2, 8], [1, 1]] {
        let count = grid[0] * grid[1];
        let mut inputs = Vec::new();
        for pixel in 0..SIDE * SIDE {
            inputs.extend((0..count).map(|s| [Vec4::new((pixel % SIDE) as f32, (pixel / SIDE) as f32, s as f32, 0.0)]));
        }
        let probe = Probe::new(&[
            "state/loops",
            "camera/sample/multi_jittered",
            "camera/sample/point",
            "camera/sample/unseeded",
        ])
        .stub(FRAME)
        .bind("sampling", [vec![("grid", Uint2(grid))]]);
        let body = "frame.sample = u32(p0.z); put(0u, vec4f(sample_point(vec2u(p0.xy)), 0.0, 0.0));";
        let out = probe.run::<1, 1>(&gpu, body, &inputs);
        let mut patterns = BTreeSet::new();
        let mut means = [0.0; 2];
        for (input, samples) in inputs.chunks(count as usize).zip(out.chunks(count as usize)) {
            let (mut columns, mut rows, mut cells) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
            let mut pattern = Vec::new();
            for [point] in samples {
                let x = [point.x - input[0][0].x, point.y - input[0][0].y].map(f64::from);
                assert!(x.iter().all(|c| (0.0..1.0).contains(c)), "{x:?} of grid {grid:?} is outside its pixel");
                let slot = |c: f64, n: u32| (c * f64::from(n)).floor() as u32;
                columns.insert(slot(x[0], count));
                rows.insert(slot(x[1], count));
                cells.insert([slot(x[0], grid[0]), slot(x[1], grid[1])]);
                // Rounded to a thousandth, because positions in other pixels have other rounding errors.
                pattern.push(x.map(|c| (c * 1000.0) as u32));
                means = [means[0] + x[0], means[1] + x[1]];
            }
            let full = count as usize;
            assert_eq!(
                (columns.len(), rows.len(), cells.len()),
                (full, full, full),
                "grid {grid:?} at {}",
                input[0][0]
            );
            patterns.insert(pattern);
        }
        assert_eq!(patterns.len() as u32, SIDE * SIDE, "grid {grid:?}: two pixels have the same samples");
        // The mean of K samples is ½ within 1/√(12 K) even without strata; the bound is four times that.
        for mean in means.map(|sum| sum / inputs.len() as f64) {
            assert!(
                (mean - 0.5).abs() < 4.0 / (12.0 * inputs.len() as f64).sqrt(),
                "grid {grid:?}: samples lean to {mean}"
            );
        }
    }
}

/// Points 0 to N − 1 of the (0,2)-sequence by its generator matrices over the field of two: the identity and Pascal's triangle.
fn sobol(index: u32) -> [u32; 2] {
    let odd = |row: u32, column: u32| column & row == row; // the binomial coefficient (column, row), by Lucas's theorem
    let second = |row: u32| (0..32).filter(|&c| index >> c & 1 == 1 && odd(row, c)).count() as u32 % 2;
    [index.reverse_bits(), (0..32).map(|row| second(row) << (31 - row)).sum()]
}

/// Returns Owen scrambling bit by bit: the Laine–Karras hash carries only upward,
/// so that on reversed bits the flip of each bit depends only on the bits above it.
fn scrambled(x: u32, seed: u32) -> u32 {
    let hash = |v: u32| {
        let v = v ^ v.wrapping_mul(0x3d20_adea);
        let v = v.wrapping_add(seed).wrapping_mul((seed >> 16) | 1);
        let v = v ^ v.wrapping_mul(0x0552_6c56);
        v ^ v.wrapping_mul(0x53a2_2864)
    };
    let x = x.reverse_bits();
    let bit = |b: u32| hash(x & ((2_u64 << b) - 1) as u32) & (1 << b);
    (0..32).map(bit).sum::<u32>().reverse_bits()
}

/// Returns the output function of PCG.
fn hashed(seed: u32) -> u32 {
    let state = seed.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}

/// Every prefix of 2^k progressive samples has one sample in each of the 2^k boxes of any shape with sides that are powers
/// of two, and each agrees with the sequence.
#[test]
fn progressive_samples() {
    const COUNT: u32 = 64;
    let pixel = |i: u32| [i % SIDE, i / SIDE];
    let inputs: Vec<[Vec4; 1]> = (0..SIDE * SIDE)
        .flat_map(|i| (0..COUNT).map(move |s| [Vec4::new(pixel(i)[0] as f32, pixel(i)[1] as f32, s as f32, 0.0)]))
        .collect();
    let probe = Probe::new(&[
        "state/loops",
        "camera/sample/scrambled",
        "camera/sample/sobol",
        "camera/sample/point",
        "camera/sample/unseeded",
    ])
    .stub(FRAME);
    let body = "frame.sample = u32(p0.z); put(0u, vec4f(sample_point(vec2u(p0.xy)) - p0.xy, 0.0, 0.0));";
    let out = probe.run::<1, 1>(&gpu(), body, &inputs);
    let mut patterns = BTreeSet::new();
    for (i, samples) in (0..).zip(out.chunks(COUNT as usize)) {
        let seed = hashed(pixel(i)[0].wrapping_mul(0x9e37_79b1) ^ pixel(i)[1].wrapping_mul(0x85eb_ca77));
        let seeds = [seed, hashed(seed ^ 0x5163_3e2d)];
        for (s, [point]) in (0..).zip(samples) {
            let own = sobol(s);
            for (k, got) in [point.x, point.y].into_iter().enumerate() {
                let want = f64::from(scrambled(own[k], seeds[k])) / 4_294_967_296.0;
                // The sample was added to the position of the pixel in 32 bits, and subtracted again.
                assert!((f64::from(got) - want).abs() < 1e-6, "sample {s} of pixel {i}: {got} is not {want}");
            }
        }
        for k in 0..=6 {
            for across in 0..=k {
                let cell = |x: f32, bits: u32| (x * (1 << bits) as f32) as u32;
                let prefix = &samples[..1 << k];
                let cells: BTreeSet<_> = prefix.iter().map(|[p]| [cell(p.x, across), cell(p.y, k - across)]).collect();
                assert_eq!(cells.len(), prefix.len(), "{} of pixel {i} in 2^{across} columns", prefix.len());
            }
        }
        patterns.insert(samples.iter().map(|[p]| [p.x, p.y].map(|c| (c * 1000.0) as u32)).collect::<Vec<_>>());
    }
    assert_eq!(patterns.len() as u32, SIDE * SIDE, "two pixels have the same samples");
}

#[test]
fn image_plane_and_centre() {
    let inputs = [[0.0_f32, 0.0], [640.0, 480.0], [320.0, 240.0], [640.0, 0.0], [0.0, 480.0], [160.0, 120.0]]
        .map(|[x, y]| [Vec4::new(x, y, 0.0, 0.0)]);
    let probe = Probe::new(&["camera/ray", "camera/sample/center"]);
    let body = "put(0u, vec4f(image_plane(p0.xy, vec2u(640u, 480u)), nth_point(vec2u(p0.xy), 0u)));";
    let want = [[-1.0, 1.0], [1.0, -1.0], [0.0, 0.0], [1.0, 1.0], [-1.0, -1.0], [-0.5, 0.5]];
    for ((input, [got]), want) in inputs.iter().zip(probe.run::<1, 1>(&gpu(), body, &inputs)).zip(want) {
        // A division may err by 2.5 units in the last place.
        assert!((got.x - want[0]).abs().max((got.y - want[1]).abs()) <= 6e-7, "{got} for {input:?}");
        assert_eq!([got.z, got.w], [input[0].x + 0.5, input[0].y + 0.5]);
    }
}
