//! Runs a target on its corpus and on random changes of it, without instrumentation: `replay TARGET [SECONDS [SEED [FOLDER]]]`.
//! The corpus is that of the target in `fuzz/corpus`, or the files of the folder.
//!
//! Says how many inputs were run. An input that panics is written to `fuzz/crashes`; one that takes more than 10 seconds is an
//! error as well.

use std::error::Error;
use std::path::Path;
use std::time::{Duration, Instant, SystemTime};
use std::{env, fs, panic};

/// SplitMix64.
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % end.max(1) as u64) as usize
    }
}

/// A few changes of an input: bytes, words, pieces of it and of another one.
fn changed(input: &[u8], other: &[u8], words: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let mut new = input.to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(new.len() + 1);
        match random.below(7) {
            0 if !new.is_empty() => {
                let at = at.min(new.len() - 1);
                new[at] = random.below(256) as u8;
            }
            1 => drop(new.drain(at..(at + random.below(12)).min(new.len()))),
            2 => {
                let from = random.below(other.len() + 1);
                let piece = &other[from..(from + random.below(40)).min(other.len())];
                drop(new.splice(at..at, piece.iter().copied()));
            }
            3 => {
                let from = random.below(new.len() + 1);
                let piece = new[from..(from + random.below(40)).min(new.len())].to_vec();
                drop(new.splice(at..at, piece));
            }
            4 if !new.is_empty() => {
                let at = at.min(new.len() - 1);
                new[at] = new[at].wrapping_add([1, 255, 16][random.below(3)]);
            }
            _ if !words.is_empty() => {
                drop(new.splice(at..at, words[random.below(words.len())].iter().copied()));
            }
            _ => {}
        }
    }
    new
}

/// The word in a line of a dictionary: in quotation marks, each byte beyond ASCII as `\xNN`, as libFuzzer reads it.
fn word(line: &str) -> Option<Vec<u8>> {
    let mut parts = line.strip_prefix('"')?.strip_suffix('"')?.split("\\x");
    let mut word = parts.next()?.as_bytes().to_vec();
    for part in parts {
        let (byte, rest) = part.split_at_checked(2)?;
        word.push(u8::from_str_radix(byte, 16).ok()?);
        word.extend(rest.as_bytes());
    }
    Some(word)
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let name = arguments.first().ok_or("which target?")?;
    let (_, target) =
        basis_fuzz::TARGETS.into_iter().find(|(n, _)| n == name).ok_or("there is no such target")?;
    let seconds = arguments.get(1).map_or(Ok(0), |s| s.parse())?;
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH)?.as_secs();
    let seed = arguments.get(2).map_or(Ok(now), |s| s.parse())?;
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    // What is only read is of the same language.
    let language = if name == "parser" { "spec" } else { name };
    let mut corpus = Vec::new();
    let own = folder.join("corpus").join(language);
    let inputs = arguments.get(3).map_or(own.as_path(), Path::new);
    let mut paths: Vec<_> = fs::read_dir(inputs)?.collect::<Result<_, _>>()?;
    paths.sort_by_key(fs::DirEntry::path);
    for entry in paths {
        corpus.push(fs::read(entry.path())?);
    }
    let dictionary = fs::read_to_string(folder.join(format!("{language}.dict"))).unwrap_or_default();
    let words: Vec<Vec<u8>> = dictionary.lines().filter_map(word).collect();
    let random = &mut Random(seed);
    println!("{name}: seed {seed}");
    let (start, mut count, mut slowest) = (Instant::now(), 0_u64, Duration::ZERO);
    let mut run = |input: &[u8]| -> Result<(), Box<dyn Error>> {
        let before = Instant::now();
        let done = panic::catch_unwind(|| target(input));
        let took = before.elapsed();
        slowest = slowest.max(took);
        count += 1;
        if done.is_err() || took > Duration::from_secs(10) {
            let crash = folder.join("crashes").join(format!("{name}-{seed}-{count}"));
            fs::create_dir_all(folder.join("crashes"))?;
            fs::write(&crash, input)?;
            return Err(format!("an input panics or is too slow ({took:?}): {}", crash.display()).into());
        }
        Ok(())
    };
    for input in &corpus {
        run(input)?;
    }
    while start.elapsed() < Duration::from_secs(seconds) {
        let other = &corpus[random.below(corpus.len())];
        let input = changed(&corpus[random.below(corpus.len())], other, &words, random);
        run(&input)?;
    }
    println!("{name}: {count} inputs in {:?}, the slowest in {slowest:?}", start.elapsed());
    Ok(())
}
