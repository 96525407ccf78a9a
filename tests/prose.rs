//! Comments, pages and messages are in plain English: CONTRIBUTING.md, "How to write here".

use std::ops::Range;
use std::path::{Path, PathBuf};

use regex_lite::Regex;

/// A pattern that makes English hard to read.
struct Pattern {
    name: &'static str,
    regex: &'static str,
    /// Matches of this around a hit make it correct; empty if every hit is wrong.
    correct: &'static str,
    instead: &'static str,
    /// Whether only the start of a doc comment is searched.
    opens_docs: bool,
}

const fn anywhere(name: &'static str, regex: &'static str, correct: &'static str, instead: &'static str) -> Pattern {
    Pattern { name, regex, correct, instead, opens_docs: false }
}

const fn opening(name: &'static str, regex: &'static str, correct: &'static str, instead: &'static str) -> Pattern {
    Pattern { name, regex, correct, instead, opens_docs: true }
}

/// Some patterns are narrow, because wider ones mostly find correct English: "so far", "there is no", "a part of the file", a place
/// "where" something is, "its own", "the same for every ray". There is no pattern for "that of", nor for messages with two colons.
const PATTERNS: &[Pattern] = &[
    anywhere(
        "what",
        r"\b[Ww]hat [a-z]",
        r"\b[Ww]hat (?:(?:is|are) the|to|next|you (?:need|want))\b|\b[Pp]rints? what will\b|\bwhat [^.]* looks? like\b|\bWhat [^.?]*\?",
        "the noun: \"the capture region\"",
    ),
    anywhere("who", r"(?:^|[.;:] )(?:Who|Whoever|Whatever|Whose)\b", r"Who[^.]*\?", "a subject or a verb first"),
    opening(
        "fragment",
        r"^(?:(?:Of|By|As|With|And|From|Where|Whose)\b|That (?:a|an|the|it|they)\b)",
        r"^By default\b",
        "a sentence",
    ),
    opening("question", r"^[^.:]*\?", "", "\"Returns `true` if\""),
    anywhere(
        "where",
        r"(?:^|[.;:] )Where (?:a|an|the|no|there|it|they|one|that|nothing|some|several|all|any|both|only|light|pixels|each|neither|none)\b",
        "",
        "\"if\" or \"when\"",
    ),
    anywhere(
        "lie",
        r"\b(?:lies|lie|stands|stand)\b",
        r"\bstands? (?:for|up)\b|\bstands on the road\b|\blies on its side\b",
        "\"is\", \"is stored\", \"is located\"",
    ),
    anywhere(
        "say",
        r"\bsays?\b|\b(?:is|are|was|were) (?:said|told|let be|looked at|asked for)\b",
        "",
        "print, report, specify",
    ),
    anywhere("know", r"\b(?:knows|wants|tells|forgets|remembers)\b", "", "supports, requires, reports, stores"),
    anywhere(
        "so many",
        r"\bso (?:many|much|few|long|near)\b",
        r"\bso (?:many|much|few|long|near)\b[^.;:]*\b(?:that|as)\b",
        "the name of the parameter",
    ),
    anywhere(
        "name's",
        r"\b(?:Doppler|Beer|Lambert|Ellis|Kerr|Dormand|Prince|Schwarzschild|Fresnel|Lindquist|Thorne|Kutta|Phong|Luneburg)['’]s\b|\blight['’]s speed\b",
        "",
        "\"Doppler shift\", \"Ellis wormhole\", \"speed of light\"",
    ),
    anywhere(
        "go on",
        r"\bgo(?:es|ne|ing)? on\b|\bgoes? with\b|\bdo(?:es)? not go with\b",
        "",
        "continue, resume, \"cannot be combined with\"",
    ),
    anywhere("beside", r"\bbesides?\b", "", "\"next to\", \"in addition to\""),
    anywhere(
        "is no",
        r"\b(?:is|are) no [a-z]+",
        r"\b[Tt]here (?:is|are) no [a-z]+|\bno (?:longer|more|wider)\b",
        "\"is not a\"",
    ),
    anywhere("in parts of", r"\bin parts of\b|\bparts? of (?:light|something)\b", "", "\"as a fraction of\""),
    anywhere("for", r", for (?:it|they|there|nothing|he|we|what)\b", "", "because"),
    anywhere(
        "he",
        r"\b(?:of|to|by|for|as|than|from|past|with|at|and|or) who\b|\b(?:he|him|his|himself)\b",
        "",
        "\"an observer who\", \"they\"",
    ),
    anywhere(
        "the same",
        r"\b[Tt]he same (?:with|without|by|along|two|three|four)\b|[.:;|] The same[,.;:|]",
        "",
        "the noun",
    ),
    anywhere(
        "a pixel",
        r"\b(?:rays?|samples?|steps?|bytes|pixels?|evaluations?|times|bits|triangles|frames?|paths?|seconds?|degrees|units|turns?) a (?:pixel|ray|second|sample|step|segment|frame|pass|path|channel|vertex|voxel|minute|hour|unit|row|side|turn)\b",
        "",
        "\"per pixel\"",
    ),
    anywhere("but for", r"\bbut for\b|\b(?:all|none|nothing|anything|no \w+) but\b", "", "\"except\""),
    anywhere(
        "held against",
        r"\b(?:held|holds?) (?:\w+ ){0,4}(?:against|to)\b",
        "",
        "\"compared with\", \"a test checks that\"",
    ),
    anywhere("alike", r"\balike\b", "", "identical, \"in the same way\""),
    anywhere("in place of", r"\bin place of\b", "", "\"instead of\""),
    anywhere("mend", r"\b(?:bears?|borne|mend|mends|mended|shall|[Ww]hoever)\b", "", "tolerate, fix, must"),
    anywhere("of its own", r"\bof (?:its|their|our|one's) own(?:$|[.,;:)])", "", "custom, separate, local"),
    anywhere(
        "round",
        r"\bround (?:a|an|the|it|its|them|black|charged|another|both|each other)\b|\b(?:go|goes|going|went|ways?|all|turns?|bent|driven|moves?|orbits?|paths?) round\b",
        r"\b(?:each|first|last|next|this|a) round a\b",
        "around, orbits",
    ),
    anywhere(
        "unnamed source",
        r"\b(?:paper|rule|scheme|method|figures?|images?) (?:of|from) (?:2004|1995)\b|\b(?:2004|1995) paper\b",
        "",
        "the authors and the year",
    ),
    anywhere("thesis", r"\b[Tt]he thesis\b", r"\b[Tt]he thesis (?:by|of)\b", "the author"),
    anywhere("lamp", r"\b[Ll]amps?\b", "", "light, emitter"),
    anywhere(
        "British spelling",
        r"(?i)\b\w*(?:colour|centre|grey|behaviour|neighbour|catalogue|chequer)\w*|\b(?:kilo|centi|milli)?metres?\b",
        "",
        "the American spelling",
    ),
    anywhere(
        "how it is kept",
        r"\b(?:is|are) kept once\b|\bgiven up at random\b|\bshuts? out\b",
        "",
        "instancing, Russian roulette, occlusion",
    ),
];

/// Files in which a pattern is correct, with the reason.
const EXCEPTIONS: &[(&str, &str, &str)] =
    &[("manual/pages/tutorials/blender_room.md", "lamp", "the lamp is furniture")];

/// A text for people, without code: `_` replaces every byte between backticks, and a space every line break.
struct Prose {
    text: String,
    /// The offset in the text at which each line begins, and the number of the line, from 1.
    lines: Vec<(usize, usize)>,
    docs: bool,
}

impl Prose {
    fn new(docs: bool) -> Prose {
        Prose { text: String::new(), lines: Vec::new(), docs }
    }

    fn push(&mut self, number: usize, line: &str) {
        if !self.text.is_empty() {
            self.text.push(' ');
        }
        self.lines.push((self.text.len(), number));
        self.text.push_str(line);
    }

    fn line(&self, offset: usize) -> usize {
        let after = self.lines.partition_point(|(start, _)| *start <= offset);
        self.lines[after - 1].1
    }

    fn without_code(mut self) -> Prose {
        let mut is_code = false;
        let closed = self.text.matches('`').count() / 2 * 2;
        let mut ticks = 0;
        let hide = |c: char| {
            if c == '`' && ticks < closed {
                ticks += 1;
                is_code = !is_code;
                return "_".to_string();
            }
            if is_code { "_".repeat(c.len_utf8()) } else { c.to_string() }
        };
        self.text = self.text.chars().map(hide).collect();
        self
    }
}

/// A pattern, compiled.
struct Search {
    pattern: &'static Pattern,
    wrong: Regex,
    correct: Option<Regex>,
}

impl Search {
    fn all() -> Vec<Search> {
        let regex = |text: &str| Regex::new(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        let search = |pattern: &'static Pattern| Search {
            pattern,
            wrong: regex(pattern.regex),
            correct: (!pattern.correct.is_empty()).then(|| regex(pattern.correct)),
        };
        PATTERNS.iter().map(search).collect()
    }

    fn hits(&self, prose: &Prose) -> Vec<Range<usize>> {
        if self.pattern.opens_docs && !prose.docs {
            return Vec::new();
        }
        let find = |regex: &Regex| regex.find_iter(&prose.text).map(|found| found.range()).collect::<Vec<_>>();
        let mut hits = find(&self.wrong);
        if let Some(correct) = self.correct.as_ref().filter(|_| !hits.is_empty()) {
            let correct = find(correct);
            hits.retain(|hit| !correct.iter().any(|range| range.start < hit.end && hit.start < range.end));
        }
        hits
    }
}

/// Returns the paragraphs of lines of text: an empty line, a table's row, a heading or a list's entry begins a new one.
fn paragraphs<'a>(lines: impl Iterator<Item = (usize, &'a str)>, docs: bool) -> Vec<Prose> {
    let mut found: Vec<Prose> = Vec::new();
    let mut is_code = false;
    let mut continues = false;
    for (number, line) in lines {
        let line = line.trim();
        if line.starts_with("```") {
            is_code = !is_code;
        }
        if is_code || line.is_empty() || line.starts_with("```") {
            continues = false;
            continue;
        }
        let is_item = ["|", "#", "- ", "* "].iter().any(|start| line.starts_with(start));
        if !continues || is_item {
            found.push(Prose::new(docs && found.is_empty()));
        }
        found.last_mut().unwrap().push(number, line);
        continues = true;
    }
    found
}

fn markdown(text: &str) -> Vec<Prose> {
    let mut is_list_of_words = false;
    let mut is_between = true;
    let lines = text.lines().enumerate().map(|(i, line)| (i + 1, line)).map(move |(number, line)| {
        is_list_of_words = line.starts_with("| use | instead of |") || is_list_of_words && line.starts_with('|');
        is_between = line.is_empty() || is_between && line.starts_with("    ");
        (number, if is_list_of_words || is_between { "" } else { line })
    });
    paragraphs(lines, false)
}

fn toml(text: &str) -> Vec<Prose> {
    let comment = |line: &str| {
        let start = if line.starts_with('#') { Some(0) } else { line.find(" # ").map(|space| space + 1) };
        start.map_or(String::new(), |start| line[start..].trim_start_matches('#').to_string())
    };
    let comments: Vec<String> = text.lines().map(comment).collect();
    paragraphs(comments.iter().enumerate().map(|(i, line)| (i + 1, line.as_str())), false)
}

/// Returns the comments of a Rust or WGSL file and, if requested, its string literals.
fn code(text: &str, with_strings: bool) -> Vec<Prose> {
    let mut found = Vec::new();
    let mut comments: Vec<(usize, &str)> = Vec::new();
    let mut docs = false;
    let mut number = 1;
    let mut starts_line = true;
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            let comment = rest.lines().next().unwrap_or_default();
            let is_docs = comment.starts_with("///") || comment.starts_with("//!");
            let follows = starts_line && comments.last().is_some_and(|(last, _)| last + 1 == number);
            if !follows || is_docs != docs {
                found.extend(paragraphs(comments.drain(..), docs));
            }
            docs = is_docs;
            comments.push((number, comment.trim_start_matches(['/', '!'])));
            comment.len()
        } else if let Some((inside, length)) = literal(rest) {
            if with_strings && inside.contains(' ') {
                found.push(sentence(number, inside));
            }
            starts_line = false;
            length
        } else {
            starts_line = c == '\n' || starts_line && c.is_whitespace();
            let word = rest.len() - rest.trim_start_matches(|c: char| c.is_alphanumeric() || c == '_').len();
            character(rest).unwrap_or(if word > 0 { word } else { c.len_utf8() })
        };
        number += rest[..length].matches('\n').count();
        rest = &rest[length..];
    }
    found.extend(paragraphs(comments.drain(..), docs));
    found
}

/// Returns the contents of the string literal at the start of the text, and the length of the literal.
fn literal(text: &str) -> Option<(&str, usize)> {
    if let Some(inside) = text.strip_prefix('"') {
        let length = closing_quote(inside)?;
        return Some((&inside[..length], length + 2));
    }
    let raw = text.strip_prefix('r')?;
    let hashes = raw.len() - raw.trim_start_matches('#').len();
    let inside = raw[hashes..].strip_prefix('"')?;
    let length = inside.find(&format!("\"{}", "#".repeat(hashes)))?;
    Some((&inside[..length], length + 3 + 2 * hashes))
}

fn closing_quote(text: &str) -> Option<usize> {
    let mut escaped = false;
    text.bytes().position(|byte| {
        let closes = byte == b'"' && !escaped;
        escaped = byte == b'\\' && !escaped;
        closes
    })
}

/// Returns the length of the character literal at the start of the text, such as '"'; a lifetime is not one.
fn character(text: &str) -> Option<usize> {
    let inside = text.strip_prefix('\'')?;
    let length =
        if inside.starts_with('\\') { 2 + inside.get(2..)?.find('\'')? } else { inside.chars().next()?.len_utf8() };
    inside[length..].starts_with('\'').then_some(length + 2)
}

/// Returns the text of a string literal without the names of its values.
fn sentence(number: usize, literal: &str) -> Prose {
    let value = Regex::new(r"\{\w*(?::[^}]*)?\}").unwrap();
    let mut prose = Prose::new(false);
    for (i, line) in literal.lines().enumerate() {
        let line = value.replace_all(line.trim().trim_end_matches('\\').trim_end(), "_");
        prose.push(number + i, &line.replace("\\n", "  "));
    }
    prose
}

/// Returns the lines of a file's first comment.
fn module_docs(text: &str) -> String {
    text.split_inclusive('\n').take_while(|line| line.starts_with("//!")).collect()
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in folder.read_dir().unwrap().map(|entry| entry.unwrap().path()) {
        if entry.ends_with("target") {
            continue;
        }
        if entry.is_dir() {
            files(&entry, found);
        } else {
            found.push(entry);
        }
    }
}

#[test]
fn prose_is_plain_english() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut paths = vec![root.join("README.md"), root.join("CONTRIBUTING.md"), root.join("manual/SUMMARY.md")];
    for folder in ["src", "shaders", "scenes", "examples", "manual/pages", "tests"] {
        files(&root.join(folder), &mut paths);
    }
    paths.sort();
    let searches = Search::all();
    let mut wrong = Vec::new();
    let mut count = 0;
    for path in &paths {
        let name = path.strip_prefix(root).unwrap().display().to_string().replace('\\', "/");
        let read = || std::fs::read_to_string(path).unwrap();
        let is_test = name.starts_with("tests/");
        let proses = match path.extension().and_then(|extension| extension.to_str()) {
            // Of tests, only the documentation of modules is checked.
            Some("rs") if is_test => code(&module_docs(&read()), false),
            _ if is_test => continue,
            Some("md") => markdown(&read()),
            Some("toml") => toml(&read()),
            Some("wgsl") => code(&read(), false),
            // The strings of unit tests reach nobody.
            Some("rs") => code(&read(), name.starts_with("src/") && !name.contains("tests")),
            _ => continue,
        };
        count += proses.len();
        for prose in proses.into_iter().map(Prose::without_code) {
            for search in &searches {
                let Pattern { name: fault, instead, .. } = search.pattern;
                if EXCEPTIONS.iter().any(|(file, pattern, _)| (*file, *pattern) == (name.as_str(), *fault)) {
                    continue;
                }
                for hit in search.hits(&prose) {
                    let (line, words) = (prose.line(hit.start), &prose.text[hit]);
                    wrong.push(format!("{name}:{line}: \"{words}\" ({fault}): write {instead}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(count > 5000, "only {count} texts were found");
}

#[test]
fn wrong_prose_is_found() {
    let searches = Search::all();
    let found = |proses: Vec<Prose>| {
        let mut found = Vec::new();
        for prose in proses.into_iter().map(Prose::without_code) {
            for search in &searches {
                found.extend(search.hits(&prose).iter().map(|hit| (prose.line(hit.start), search.pattern.name)));
            }
        }
        found.sort_unstable();
        found
    };
    let page = "It is\nalike.\n\n```sh\nalike\n```\n\n| `alike` | stands for x | in place\n| use | instead of |\n| x | alike |\n\nWhat captures\nrays.";
    assert_eq!(found(markdown(page)), [(2, "alike"), (12, "what")]);
    let comments = "/// Of a node.\n/// By x.\nfn f<'a>(c: &'a str) {\n    x(\"no\\\" alike\", '\"'); // Is it?\n    // in\n    // place of\n}\n";
    assert_eq!(found(code(comments, false)), [(1, "fragment"), (5, "in place of")]);
    assert_eq!(found(code(comments, true)), [(1, "fragment"), (4, "alike"), (5, "in place of")]);
    assert_eq!(found(code("f(r#\"a \" alike\"#);\n// mend\n", true)), [(1, "alike"), (2, "mend")]);
    assert_eq!(found(toml("a = 1 # a lamp\n# the same with\n")), [(1, "lamp"), (2, "the same")]);
}
