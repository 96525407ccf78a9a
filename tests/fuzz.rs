//! Every reader of files accepts or rejects each file of `tests/fuzz/corpus` and slightly changed copies: without a panic,
//! quickly, and with little memory.
//!
//! The corpus has valid files of each kind, and all files that `make fuzz` found.

#[path = "fuzz/src/bounds.rs"]
mod bounds;
#[path = "fuzz/src/mutate.rs"]
mod mutate;
#[path = "fuzz/src/readers.rs"]
mod readers;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

use bentray::assets::{Field, Spacetime};
use bentray::glam::DMat3;
use bentray::scene::{LineElement, Mesh, Picture, Profile};
use mutate::{Random, mutated};
use readers::{READERS, Reader};

/// The file that receives the current input, for inspection after a crash.
fn last() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("fuzz-last")
}

fn corpus(reader: &Reader) -> Vec<(String, Vec<u8>)> {
    let folder = readers::folder().join("corpus").join(reader.name);
    let entries = folder.read_dir().unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths.iter().map(|path| (path.display().to_string(), std::fs::read(path).unwrap())).collect()
}

/// The environment variable of the process that reads.
const READS: &str = "BENTRAY_TEST_READS";

/// Memory is counted per process, so this test starts itself again in a separate process, and reports if that process ends early.
#[test]
fn readers_bear_the_corpus_and_what_is_near_it() {
    if std::env::var_os(READS).is_some() {
        return replay();
    }
    let own = "fuzz::readers_bear_the_corpus_and_what_is_near_it";
    let mut command = Command::new(std::env::current_exe().unwrap());
    let ran = command.args(["--exact", own, "--nocapture", "--test-threads=1"]).env(READS, "1").output().unwrap();
    let words = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let (out, err) = (words(&ran.stdout), words(&ran.stderr));
    assert!(ran.status.success(), "{out}{err}\nthe last input is in {}", last().display());
    assert!(out.contains("1 passed"), "{out}");
}

fn replay() {
    for reader in READERS {
        let files = corpus(reader);
        let mut random = Random::of(reader.name);
        let read = |name: &str, bytes: &[u8]| {
            std::fs::write(last(), bytes).unwrap();
            println!("{name}");
            bounds::within(reader, bytes);
        };
        for (name, bytes) in &files {
            read(name, bytes);
        }
        for i in 0..reader.changes {
            let [(name, bytes), (_, other)] = [i, i / files.len() * 7 + 1].map(|k| &files[k % files.len()]);
            read(&format!("{name}, change {i}"), &mutated(bytes, other, &mut random));
        }
    }
}

#[test]
fn every_reader_has_a_corpus() {
    let folders = readers::folder().join("corpus").read_dir().unwrap();
    let folders: BTreeSet<String> = folders.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    assert_eq!(folders, READERS.iter().map(|reader| reader.name.to_owned()).collect());
    for reader in READERS {
        let bytes: usize = corpus(reader).iter().map(|(_, bytes)| bytes.len()).sum();
        assert!((1..=25_000).contains(&bytes), "{} has {bytes} bytes", reader.name);
    }
}

/// Checks the error messages of files that the fuzzer found.
#[test]
fn what_was_found_is_refused_in_words() {
    let path = |name: &str| readers::folder().join("corpus").join(name);
    let [gif, exr] = ["picture/frame.gif", "picture/wide_data_window.exr"].map(|name| Picture::load(&path(name)));
    let mesh = |name: &str| Mesh::load(&path(name)).unwrap_err().to_string();
    let profile = Profile::load(&path("profile/near.csv"));
    let long = mesh("obj/long_word.obj");
    for (said, expected) in [
        (gif.unwrap_err().to_string(), "the image is in the format GIF: convert it to PNG, JPEG, EXR or HDR"),
        (exr.unwrap_err().to_string(), "pixels of 12 bytes, which do not fit into the 1534 bytes of the file"),
        (mesh("gltf/repeated.gltf"), "the file has 140000000 triangle corners, counting each instance"),
        (mesh("gltf/repeated.gltf"), "the limit is 67108864; use one object per node, as `bentray import` does"),
        (profile.unwrap_err().to_string(), "near.csv:3:1: the height 1e-320 is too close to the previous height, 0e0"),
        (long.clone(), "expected a number, found `9a9a9a"),
    ] {
        assert!(said.contains(expected), "{said}");
    }
    assert!(long.len() < 3000 && long.contains(" … "), "{long}");
    let written = Spacetime {
        line_element: "-dt^2 + dx^2 + dy^2 + dz^2".to_owned(),
        parameters: vec![("a".to_owned(), 1.0)],
        terms: (0..200).map(|k| (format!("b{k}"), "1".to_owned())).collect(),
        scale: "1".to_owned(),
        captured: None,
        throat: None,
        axes: DMat3::IDENTITY,
    };
    let (field, error) = LineElement::parse(written).unwrap_err();
    assert_eq!(field, Field::TermName(199));
    assert_eq!(error.problem, "201 parameters and terms exceed the limit of 200");
}
