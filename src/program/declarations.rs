//! WGSL as top-level declarations, parsed just enough to link by name and to lower uniforms.
//!
//! WGSL has no order and only one scope at module level, so a declaration is identified by its name, and its dependencies are the
//! names in it. Statements and expressions are not parsed; naga parses them in the linked program.

use std::collections::BTreeSet;
use std::ops::Range;

use super::scopes::outer_names;
use super::signature::Signature;
use super::tokens::{Origin, Splice, Tokens, behind_spaces, comment};

/// One function, struct, alias, constant, override or variable of a module.
#[derive(Debug, Clone)]
pub(super) struct Declaration<'a> {
    pub(super) tokens: Tokens<'a>,
    /// The tokens that refer to names of module scope.
    pub(super) names: Vec<usize>,
    /// The token of the keyword.
    head: usize,
    /// The token of the name.
    named: usize,
}

/// The location at which a text cannot be split into declarations, and the reason.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Slip {
    /// The location.
    pub(super) origin: Origin,
    pub(super) message: String,
}

impl<'a> Declaration<'a> {
    fn new(mut tokens: Tokens<'a>, head: usize, named: usize) -> Self {
        if let Some(first) = tokens.0.first_mut() {
            first.gap = own_comment(&first.gap).to_owned().into();
        }
        let names = outer_names(&tokens, head);
        Self { tokens, names, head, named }
    }

    /// Returns the declared name.
    pub(super) fn name(&self) -> &str {
        self.tokens.word(self.named)
    }

    /// Returns the keyword: `fn`, `struct`, `alias`, `const`, `override` or `var`.
    pub(super) fn keyword(&self) -> &str {
        self.tokens.word(self.head)
    }

    /// Returns the module-scope names that the declaration contains.
    pub(super) fn used(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(|&i| self.tokens.word(i))
    }

    /// Returns the location of the name.
    pub(super) fn origin(&self) -> Origin {
        self.tokens.origin(self.named)
    }

    /// Returns the first of these names that the declaration contains, even as a local variable, with its location.
    pub(super) fn mentions(&self, names: &BTreeSet<String>) -> Option<(Origin, &str)> {
        let tokens = &self.tokens;
        let found = (0..tokens.len()).find(|&i| names.contains(tokens.word(i)) && tokens.before(i) != ".")?;
        Some((tokens.origin(found), tokens.word(found)))
    }

    /// Returns the declaration with some tokens replaced, all of them after its name or before its keyword.
    pub(super) fn spliced(self, splices: Vec<Splice<'a>>) -> Self {
        if splices.is_empty() {
            return self;
        }
        let before = || splices.iter().filter(|(range, _)| range.end <= self.head);
        let (added, lost) =
            before().fold((0, 0), |(added, lost), (range, new)| (added + new.len(), lost + range.len()));
        let (head, named) = (self.head + added - lost, self.named + added - lost);
        Self { head, named, ..self }.edited(|tokens| tokens.spliced(splices))
    }

    /// Returns the declaration with its tokens edited after its name.
    pub(super) fn edited(self, edit: impl FnOnce(Tokens<'a>) -> Tokens<'a>) -> Self {
        let tokens = edit(self.tokens);
        let names = outer_names(&tokens, self.head);
        Self { tokens, names, ..self }
    }

    /// Returns the parameters and the result of a function.
    pub(super) fn signature(&self) -> Option<Signature> {
        Signature::of(&self.tokens, self.head)
    }

    /// Returns the address space of a variable, if it is written.
    pub(super) fn space(&self) -> Option<&str> {
        (self.keyword() == "var" && self.tokens.word(self.head + 1) == "<").then(|| self.tokens.word(self.head + 2))
    }

    /// Returns `true` for a uniform.
    pub(super) fn is_uniform(&self) -> bool {
        self.space() == Some("uniform")
    }

    /// Returns `true` if attributes precede the keyword.
    pub(super) fn has_attributes(&self) -> bool {
        self.head > 0
    }

    /// Returns the tokens of a variable's type.
    pub(super) fn ty(&self) -> Option<Range<usize>> {
        let from = self.named + 2;
        (self.tokens.word(self.named + 1) == ":").then(|| from..self.up_to(from, &["=", ";"]))
    }

    /// Returns the tokens after the `=`.
    pub(super) fn value(&self) -> Option<Range<usize>> {
        let from = self.up_to(self.named, &["="]) + 1;
        (from < self.tokens.len()).then(|| from..self.up_to(from, &[";"]))
    }

    fn up_to(&self, from: usize, signs: &[&str]) -> usize {
        (from..self.tokens.len()).find(|&i| signs.contains(&self.tokens.word(i))).unwrap_or(self.tokens.len())
    }
}

const KEYWORDS: [&str; 6] = ["fn", "struct", "alias", "const", "override", "var"];

/// Returns the declarations of a unit, in order.
pub(super) fn declarations(tokens: Tokens<'_>) -> Result<Vec<Declaration<'_>>, Slip> {
    let mut places = Vec::new();
    let mut from = 0;
    while from < tokens.len() {
        if tokens.word(from) == ";" {
            from += 1;
            continue;
        }
        let (head, named) = head(&tokens, from)?;
        let end = end(&tokens, from).ok_or_else(|| Slip {
            origin: tokens.origin(head),
            message: format!(
                "`{} {}` is not closed: add the missing `}}` or `;`",
                tokens.word(head),
                tokens.word(named)
            ),
        })?;
        places.push((from..end + 1, head - from, named - from));
        from = end + 1;
    }
    let mut all = tokens.0.into_iter();
    let mut done = 0;
    let declaration = |(range, head, named): (Range<usize>, usize, usize)| {
        let own = all.by_ref().skip(range.start - done).take(range.len()).collect();
        done = range.end;
        Declaration::new(Tokens(own), head, named)
    };
    Ok(places.into_iter().map(declaration).collect())
}

/// Returns the keyword and the name of the declaration that starts with the token `from`.
fn head(tokens: &Tokens, from: usize) -> Result<(usize, usize), Slip> {
    let expected = |i: usize, what: &str| {
        let found = if i < tokens.len() { format!("`{}`", tokens.word(i)) } else { "the end of the file".to_owned() };
        Slip { origin: tokens.origin(i), message: format!("expected {what}, found {found}") }
    };
    let head = tokens.behind_attributes(from);
    if !KEYWORDS.contains(&tokens.word(head)) {
        return Err(expected(head, "`fn`, `struct`, `alias`, `const`, `override` or `var`"));
    }
    let space = (tokens.word(head) == "var" && tokens.word(head + 1) == "<").then(|| tokens.closing(head + 1));
    let named = space.flatten().unwrap_or(head) + 1;
    if tokens.is_name(named) { Ok((head, named)) } else { Err(expected(named, "a name")) }
}

/// Returns the `;` or the outermost `}` that closes the declaration that starts with the token `from`.
fn end(tokens: &Tokens, from: usize) -> Option<usize> {
    let mut depth = 0_usize;
    (from..tokens.len()).find(|&i| match tokens.word(i) {
        "{" => {
            depth += 1;
            false
        }
        "}" => {
            depth = depth.saturating_sub(1);
            depth == 0
        }
        sign => sign == ";" && depth == 0,
    })
}

/// Returns the comment directly above a declaration; a comment that is followed by an empty line belongs to no declaration.
fn own_comment(gap: &str) -> &str {
    let (mut at, mut start) = (0, None);
    loop {
        let next = behind_spaces(gap, at);
        if start.is_none() || gap[at..next].matches('\n').count() > 1 {
            start = Some(next);
        }
        match comment(&gap[next..]) {
            0 => return &gap[start.unwrap_or(next)..],
            length => at = next + length,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCE: &str = "// The contract.\n\n// Doc.\nstruct A {\n    b: f32, // b;\n}\n\nalias B = mat2x3f;\n\
        @group(0) @binding(1) var<storage, read> c: array<A>;\n/* } \n\n/* { */ */\nfn d(x: A) -> f32 {\n    if x.b > K { return c[0].b; }\n    return 1e-3;\n}\n";

    fn used(source: &str) -> Vec<String> {
        declarations(Tokens::of(source)).unwrap()[0].used().map(str::to_owned).collect()
    }

    #[test]
    fn splits_at_module_scope() {
        let found = declarations(Tokens::of(SOURCE)).unwrap();
        let line = |d: &Declaration| SOURCE[..d.origin().at].matches('\n').count();
        let names: Vec<_> = found.iter().map(|d| (d.keyword(), d.name(), line(d))).collect();
        assert_eq!(names, [("struct", "A", 3), ("alias", "B", 7), ("var", "c", 8), ("fn", "d", 12)]);
        assert_eq!(found[0].tokens.0[0].gap, "// Doc.\n");
    }

    #[test]
    fn members_are_no_names() {
        let found = declarations(Tokens::of(SOURCE)).unwrap();
        let used: Vec<_> = found[3].used().collect();
        assert!(used.contains(&"K") && used.contains(&"c") && used.contains(&"A"));
        assert!(!used.contains(&"b"));
        assert!(!found[0].used().any(|name| name == "b"));
    }

    #[test]
    fn attributes_and_address_spaces_name_nothing() {
        let source = "@compute @workgroup_size(SIZE) fn f(@builtin(position) at: vec4f) {}";
        assert_eq!(used(source), ["SIZE", "fn", "f", "vec4f"]);
        assert_eq!(used("@group(0) @binding(N) var<storage, read> a: T;"), ["N", "var", "a", "T"]);
    }

    #[test]
    fn local_names_hide_those_outside() {
        let source = "fn f(steps: u32) -> u32 {\n    let hit = hit(steps);\n    { var<function> law = law.a; law += 1.0; }\n    \
            for (var i = 0u; i < N; i++) { sum(i); }\n    i(law);\n    switch hit {\n        case HIT, MISS: {}\n        \
            default: {}\n    }\n    return other;\n}";
        let names = used(source);
        let count = |name: &str| names.iter().filter(|used| *used == name).count();
        assert_eq!(["hit", "law", "i", "steps", "HIT", "MISS", "other", "N"].map(count), [1, 2, 1, 0, 1, 1, 1, 1]);
    }

    #[test]
    fn what_cannot_be_split_is_refused() {
        for (source, at, message) in [
            ("fn f() {", 0, "`fn f` is not closed: add the missing `}` or `;`"),
            ("fn f() {}\n}", 10, "expected `fn`, `struct`, `alias`, `const`, `override` or `var`, found `}`"),
            ("enable f16;", 0, "expected `fn`, `struct`, `alias`, `const`, `override` or `var`, found `enable`"),
            (
                "@must_use",
                0,
                "expected `fn`, `struct`, `alias`, `const`, `override` or `var`, found the end of the file",
            ),
            ("const = 1;", 6, "expected a name, found `=`"),
        ] {
            let slip = declarations(Tokens::of(source)).unwrap_err();
            assert!(
                slip.message == message && (slip.origin.at == at || message.ends_with("file")),
                "{source}: {slip:?}"
            );
        }
    }
}
