//! Parses text to a tree, by recursive descent:
//!
//! ```text
//! sum     = product { ("+" | "-") product }
//! product = minus { ("*" | "/") minus }
//! minus   = "-" minus | power
//! power   = whole [ "^" minus ]
//! whole   = number | name | function "(" sum { "," sum } ")" | "(" sum ")"
//! ```

use super::tokens::{Token, tokens, wrong};
use super::tree::{Extremum, Operator, Tree};
use super::{FormulaError, Function, Language};
use crate::document::values::suggest;
use std::ops::Range;

/// The largest length of a formula; code that reads trees is recursive, and its stack is limited.
const LONGEST: usize = 1000;
/// The largest depth of nested subexpressions.
const DEEPEST: usize = 100;

/// Parses a formula with these names to a tree.
pub fn parse(text: &str, language: &Language) -> Result<Tree, FormulaError> {
    if text.len() > LONGEST {
        return Err(wrong(0..text.len(), format!("the formula is longer than {LONGEST} characters"), ""));
    }
    let mut parser = Parser { tokens: tokens(text, language)?, at: 0, end: text.len(), depth: 0, language };
    let tree = parser.sum()?;
    match parser.tokens.get(parser.at) {
        None => Ok(tree),
        Some((token, place)) => Err(unexpected(*token, place.clone())),
    }
}

struct Parser<'a> {
    tokens: Vec<(Token<'a>, Range<usize>)>,
    at: usize,
    /// The end of the text.
    end: usize,
    depth: usize,
    language: &'a Language,
}

type Parsed = Result<Tree, FormulaError>;

/// Returns the error for a token after a complete formula.
fn unexpected(token: Token, place: Range<usize>) -> FormulaError {
    match token {
        Token::Sign(')') => wrong(place, "unmatched `)`", ""),
        Token::Number(_) | Token::Name(_) | Token::Sign('(') => {
            wrong(place, "expected an operator before this", "write products with *, such as 2 * x")
        }
        Token::Sign(sign) => wrong(place, format!("unexpected `{sign}`"), "expected one of + - * / ^, or the end"),
    }
}

impl<'a> Parser<'a> {
    fn peek(&self) -> Option<Token<'a>> {
        self.tokens.get(self.at).map(|(token, _)| *token)
    }

    fn take(&mut self, sign: char) -> bool {
        let found = self.peek() == Some(Token::Sign(sign));
        self.at += usize::from(found);
        found
    }

    /// Returns the range of the next token; the end of the text after the last one.
    fn place(&self) -> Range<usize> {
        self.tokens.get(self.at).map_or(self.end..self.end, |(_, place)| place.clone())
    }

    fn sum(&mut self) -> Parsed {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(wrong(self.place(), format!("the formula is nested more than {DEEPEST} levels deep"), ""));
        }
        let mut sum = self.product()?;
        while let Some(operator) = self.operator(&[('+', Operator::Plus), ('-', Operator::Minus)]) {
            sum = binary(operator, sum, self.product()?);
        }
        self.depth -= 1;
        Ok(sum)
    }

    fn product(&mut self) -> Parsed {
        let mut product = self.minus()?;
        while let Some(operator) = self.operator(&[('*', Operator::Times), ('/', Operator::Over)]) {
            product = binary(operator, product, self.minus()?);
        }
        Ok(product)
    }

    fn operator(&mut self, choices: &[(char, Operator)]) -> Option<Operator> {
        choices.iter().find(|(sign, _)| self.take(*sign)).map(|(_, operator)| *operator)
    }

    fn minus(&mut self) -> Parsed {
        // A sequence of minus signs and powers is nested like parentheses.
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(wrong(self.place(), format!("the formula is nested more than {DEEPEST} levels deep"), ""));
        }
        let tree = if self.take('-') { Tree::Negative(Box::new(self.minus()?)) } else { self.power()? };
        self.depth -= 1;
        Ok(tree)
    }

    fn power(&mut self) -> Parsed {
        let base = self.whole()?;
        if self.take('^') { Ok(binary(Operator::Power, base, self.minus()?)) } else { Ok(base) }
    }

    fn whole(&mut self) -> Parsed {
        let place = self.place();
        let token = self.peek();
        self.at += 1;
        match token {
            Some(Token::Number(value)) => Ok(Tree::Number(value)),
            Some(Token::Name(name)) => self.named(name, place),
            Some(Token::Sign('(')) => {
                let inside = self.sum()?;
                self.close(place)?;
                Ok(inside)
            }
            Some(Token::Sign(sign)) => Err(wrong(
                place,
                format!("expected a number, a name or (, found `{sign}`"),
                format!("for example {}", self.language.example),
            )),
            None if self.end == 0 || self.tokens.is_empty() => {
                Err(wrong(0..self.end, "the formula is empty", format!("for example {}", self.language.example)))
            }
            None => Err(wrong(place, "the formula is incomplete", "expected a number, a name or (")),
        }
    }

    fn close(&mut self, open: Range<usize>) -> Result<(), FormulaError> {
        if self.take(')') {
            return Ok(());
        }
        match self.peek() {
            None => Err(wrong(open, "unmatched `(`", "")),
            Some(Token::Sign(',')) => Err(wrong(self.place(), "unexpected `,`", "only min and max have two arguments")),
            Some(token) => Err(unexpected(token, self.place())),
        }
    }

    fn named(&mut self, name: &str, place: Range<usize>) -> Parsed {
        if let Some(tree) = self.language.named(name) {
            if self.peek() == Some(Token::Sign('(')) {
                let help = format!("write a product as {name} * (..)");
                return Err(wrong(place, format!("`{name}` is not a function"), help));
            }
            return Ok(tree);
        }
        let function = Function::WRITTEN.iter().find(|(text, _)| *text == name).map(|(_, function)| *function);
        let extreme = [Extremum::Min, Extremum::Max].into_iter().find(|extreme| extreme.name() == name);
        if function.is_none() && extreme.is_none() {
            return Err(unknown(name, place, self.language));
        }
        let open = self.place();
        if !self.take('(') {
            let example = if extreme.is_some() { "1, x" } else { "x" };
            return Err(wrong(place, format!("`{name}` is a function"), format!("write {name}({example})")));
        }
        let first = Box::new(self.sum()?);
        let tree = match (function, extreme) {
            (Some(function), _) => Tree::Call(function, first),
            (None, Some(extreme)) if self.take(',') => Tree::Extremum(extreme, first, Box::new(self.sum()?)),
            _ => {
                let help = format!("write {name}(1, x)");
                return Err(wrong(place, format!("`{name}` requires two arguments"), help));
            }
        };
        self.close(open)?;
        Ok(tree)
    }
}

fn unknown(name: &str, place: Range<usize>, language: &Language) -> FormulaError {
    let functions = Function::WRITTEN.iter().map(|(text, _)| *text);
    let names: Vec<&str> = language.known().chain(functions).chain(["min", "max"]).collect();
    let help = if name == "ln" { "use log, the natural logarithm".to_owned() } else { suggest(name, &names, "names") };
    wrong(place, format!("unknown name `{name}`"), help)
}

fn binary(operator: Operator, a: Tree, b: Tree) -> Tree {
    Tree::Binary(operator, Box::new(a), Box::new(b))
}
