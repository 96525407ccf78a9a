//! Small changes of valid files: cheap and reproducible.

/// Numbers at the limits of types and ranges.
const NUMBERS: [&str; 8] = ["0", "-1", "1e308", "4294967295", "9223372036854775807", "1e-320", "nan", "65536"];
/// Bytes at the limits of types and ranges.
const WORDS: [u32; 5] = [0, 1, 0x7fff_ffff, u32::MAX, 0x0001_0000];

/// The xorshift generator with 64 bits.
pub struct Random(u64);

impl Random {
    pub fn of(name: &str) -> Self {
        let hash = name
            .bytes()
            .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3));
        Self(hash | 1)
    }

    /// Returns a number below `end`, which is above 0.
    fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % end as u64) as usize
    }
}

/// Returns `bytes` with one to three changes; some insert pieces of another file.
pub fn mutated(bytes: &[u8], other: &[u8], random: &mut Random) -> Vec<u8> {
    let mut all = bytes.to_vec();
    for _ in 0..=random.below(3) {
        let at = random.below(all.len().max(1));
        match random.below(8) {
            _ if all.is_empty() => {}
            0 => all[at] ^= 1 << random.below(8),
            1 => all[at] = random.below(256) as u8,
            2 => all.truncate(at),
            3 | 4 => number(&mut all, at, NUMBERS[random.below(NUMBERS.len())]),
            5 => {
                let word = WORDS[random.below(WORDS.len())].to_le_bytes();
                all.iter_mut().skip(at).zip(word).for_each(|(byte, new)| *byte = new);
            }
            6 if !other.is_empty() => {
                let from = random.below(other.len());
                let to = (from + random.below(64)).min(other.len());
                all.splice(at..at, other[from..to].iter().copied());
            }
            _ => {
                let end = (at + random.below(32)).min(all.len());
                let piece = all[at..end].to_vec();
                if random.below(2) == 0 { _ = all.drain(at..end) } else { _ = all.splice(at..at, piece) }
            }
        }
    }
    all
}

/// Replaces the first number at or after `at` by another.
fn number(all: &mut Vec<u8>, at: usize, new: &str) {
    let is_part = |byte: &u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'-');
    let Some(start) = all[at..].iter().position(u8::is_ascii_digit).map(|from| at + from) else { return };
    let length = all[start..].iter().take_while(|byte| is_part(byte)).count();
    all.splice(start..start + length, new.bytes());
}
