//! Every listing of the guide: specs are in the standard layout, commands print what is shown, pictures are what
//! `basis plot` draws. `BASIS_TESTS=overwrite` rewrites the outputs and the pictures.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::support::Folder;

/// A block of code in a page: what stands behind its marks, and its lines.
struct Block {
    info: String,
    text: String,
    /// The lines of the page, from the first mark to the last.
    lines: core::ops::Range<usize>,
}

fn blocks(page: &str) -> Vec<Block> {
    let mut all = Vec::new();
    let mut open: Option<(String, usize, String)> = None;
    for (k, line) in page.lines().enumerate() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(info)) => open = Some((info.to_string(), k, String::new())),
            (Some(_), Some(_)) => {
                if let Some((info, first, text)) = open.take() {
                    all.push(Block { info, text, lines: first..k + 1 });
                }
            }
            (Some((_, _, text)), None) => *text += &format!("{line}\n"),
            (None, None) => {}
        }
    }
    assert!(open.is_none(), "a block does not end");
    all
}

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../guide/src")
}

fn overwrites() -> bool {
    std::env::var("BASIS_TESTS").is_ok_and(|v| v == "overwrite")
}

/// What a line of a shell prints, standard error first.
fn shell(folder: &Folder, line: &str) -> String {
    let command = PathBuf::from(env!("CARGO_BIN_EXE_basis"));
    let home = command.parent().expect("it is in a folder").display().to_string();
    let path = format!("{home}:{}", std::env::var("PATH").unwrap_or_default());
    let mut shell = Command::new("sh");
    shell.args(["-c", line]).current_dir(folder.path()).env("PATH", path).stdin(Stdio::null());
    let output = shell.output().expect("there is a shell");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("it is a text");
    text(output.stderr) + &text(output.stdout)
}

#[test]
#[cfg(unix)] // the listings are for a shell
fn every_listing_is_true() {
    let mut seen = 0;
    for entry in fs::read_dir(source()).expect("the guide is there") {
        let path = entry.expect("it can be read").path();
        if path.extension().is_none_or(|e| e != "md") {
            continue;
        }
        let page = fs::read_to_string(&path).expect("it is a text");
        let mut lines: Vec<String> = page.lines().map(String::from).collect();
        let folder = Folder::new();
        let blocks = blocks(&page);
        let mut outputs: Vec<(core::ops::Range<usize>, String)> = Vec::new();
        for (k, block) in blocks.iter().enumerate() {
            seen += 1;
            match block.info.split_once(' ') {
                Some(("basis", file)) => {
                    folder.write(file, &block.text);
                    let run = folder.run(&["fmt", "--check", file]);
                    assert_eq!(run.code, 0, "{}: {file} is not in the standard layout", path.display());
                }
                _ if block.info == "sh" => {
                    // What a picture or a silent check says is not shown.
                    let printed: String = block.text.lines().map(|line| shell(&folder, line)).collect();
                    let shown: Vec<&str> = printed.lines().filter(|l| !l.starts_with("wrote ")).collect();
                    let shown = shown.join("\n");
                    let next = blocks.get(k + 1).filter(|next| next.info == "text");
                    let expected = next.map_or("", |next| next.text.as_str());
                    if overwrites() && next.is_some() {
                        outputs.push((next.map_or(0..0, |n| n.lines.clone()), shown.trim_end().to_string()));
                    } else {
                        assert_eq!(
                            shown.trim_end(),
                            expected.trim_end(),
                            "{}: {}",
                            path.display(),
                            block.text
                        );
                    }
                }
                // Outputs stand behind their commands; Rust is tested with the engine and beside the README, C and
                // Python with what is emitted.
                _ => {
                    assert!(["text", "rust", "c", "python"].contains(&block.info.as_str()), "{}", block.info);
                }
            }
        }
        for (range, text) in outputs.into_iter().rev() {
            let new = ["```text"].into_iter().chain(text.lines()).chain(["```"]).map(String::from);
            lines.splice(range, new.collect::<Vec<_>>());
        }
        if overwrites() {
            fs::write(&path, lines.join("\n") + "\n").expect("it can be written");
        }
        pictures(&folder, &page);
    }
    assert!(seen > 15, "the guide has listings");
}

/// The pictures of a page are those that its commands have drawn.
fn pictures(folder: &Folder, page: &str) {
    for part in page.split("](pictures/").skip(1) {
        let name = part.split(')').next().expect("the link ends");
        let drawn =
            fs::read_to_string(folder.path().join(name)).unwrap_or_else(|_| panic!("{name} is not drawn"));
        let kept = source().join("pictures").join(name);
        if overwrites() {
            fs::write(&kept, &drawn).expect("it can be written");
        }
        assert!(fs::read_to_string(&kept).is_ok_and(|k| k == drawn), "{name} is not what `basis plot` draws");
    }
}

/// Every page is in the table of contents.
#[test]
fn every_page_is_listed() {
    let summary = fs::read_to_string(source().join("SUMMARY.md")).expect("it is there");
    for entry in fs::read_dir(source()).expect("the guide is there") {
        let name = entry.expect("it can be read").file_name().to_string_lossy().into_owned();
        assert!(
            name == "SUMMARY.md" || name == "pictures" || summary.contains(&format!("({name})")),
            "{name}"
        );
    }
}
