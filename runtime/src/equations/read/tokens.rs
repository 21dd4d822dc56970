//! What formulas are made of: marks, names, numbers.

use alloc::string::{String, ToString};

use super::{Reader, Unreadable};

impl<'a> Reader<'a> {
    pub(super) fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or_default()
    }

    /// The next character that is no space.
    pub(super) fn next(&mut self) -> Option<char> {
        self.at = self.text.len() - self.rest().trim_start().len();
        self.rest().chars().next()
    }

    /// The error that something else should stand here.
    pub(super) fn refuse(&mut self, expected: &'static str) -> Unreadable {
        let found = match self.next() {
            Some(c) if of_name(c) => word(self.rest()).to_string(),
            other => other.map(String::from).unwrap_or_default(),
        };
        Unreadable { at: self.at, expected, found }
    }

    /// Takes the token if it is the next.
    pub(super) fn eat(&mut self, token: char) -> bool {
        let found = self.next() == Some(token);
        if found {
            self.at += token.len_utf8();
        }
        found
    }

    pub(super) fn require(&mut self, token: char, expected: &'static str) -> Result<(), Unreadable> {
        if self.eat(token) { Ok(()) } else { Err(self.refuse(expected)) }
    }

    pub(super) fn require_else(&mut self) -> Result<(), Unreadable> {
        self.next();
        if word(self.rest()) != "else" {
            return Err(self.refuse("`else`"));
        }
        self.at += "else".len();
        Ok(())
    }

    /// The name that begins here.
    pub(super) fn name(&mut self) -> &'a str {
        let name = word(self.rest());
        self.at += name.len();
        name
    }

    /// The indices of an array's element, in their brackets.
    pub(super) fn indices(&mut self) -> Result<String, Unreadable> {
        let start = self.at;
        while self.rest().starts_with('[') {
            self.at += 1;
            let digits = self.rest().bytes().take_while(u8::is_ascii_digit).count();
            if digits == 0 {
                return Err(self.refuse("an index"));
            }
            self.at += digits;
            if !self.rest().starts_with(']') {
                return Err(self.refuse("`]`"));
            }
            self.at += 1;
        }
        Ok(self.text[start..self.at].to_string())
    }

    /// Digits, with a decimal point among them and an exponent if there are.
    pub(super) fn number(&mut self) -> String {
        let rest = self.rest();
        let digits = |from: usize| {
            let after = rest.get(from..).unwrap_or_default();
            from + after.bytes().take_while(u8::is_ascii_digit).count()
        };
        let mut end = digits(0);
        if rest[end..].starts_with('.') && digits(end + 1) > end + 1 {
            end = digits(end + 1);
        }
        if rest[end..].starts_with(['e', 'E']) {
            let sign = usize::from(rest[end + 1..].starts_with(['-', '+']));
            if digits(end + 1 + sign) > end + 1 + sign {
                end = digits(end + 1 + sign);
            }
        }
        self.at += end;
        rest[..end].to_string()
    }

    /// A whole number, which may be negative.
    pub(super) fn exponent(&mut self) -> Result<i32, Unreadable> {
        let sign = if self.eat('-') { "-" } else { "" };
        self.next();
        let digits = self.rest().bytes().take_while(u8::is_ascii_digit).count();
        let exponent = alloc::format!("{sign}{}", &self.rest()[..digits]).parse();
        let exponent = exponent.map_err(|_| self.refuse("a whole exponent"))?;
        self.at += digits;
        Ok(exponent)
    }
}

/// Whether a character may stand in a name: letters of any script with their marks, digits, `_`.
pub(super) fn of_name(c: char) -> bool {
    c.is_ascii_digit() || c == '_' || c.is_alphabetic() || ('\u{300}'..'\u{370}').contains(&c)
}

/// The name at the beginning, `r#` included.
fn word(text: &str) -> &str {
    let raw = if text.starts_with("r#") { 2 } else { 0 };
    let end = text[raw..].find(|c| !of_name(c)).map_or(text.len(), |at| at + raw);
    &text[..end]
}
