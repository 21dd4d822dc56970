//! What is read and written, and what cannot be.

use alloc::string::{String, ToString};
use alloc::vec::Vec;
use alloc::{format, vec};

use super::Formula;

fn read(text: &str) -> Formula {
    text.parse().unwrap_or_else(|error| panic!("{text}: {error}"))
}

#[test]
fn operators_bind_as_in_models() {
    // What a text means, by parentheses that change nothing.
    for (text, same) in [
        ("a + b*c", "a + (b*c)"),
        ("-a*b", "-(a*b)"),
        ("a/b/c", "(a/b)/c"),
        ("a*b/c", "(a*b)/c"),
        ("a/b*c", "(a/b)*c"),
        ("-a/b - -c", "-(a/b) - (-c)"),
        ("--a", "-(-a)"),
        ("  a+b ", "a + b"),
        ("(if a < 0 { b } else { -c })*d", "((if (a) < 0 { (b) } else { (-c) }))*d"),
    ] {
        assert_eq!(read(text), read(same), "{text}");
    }
    // And by those that do.
    for (text, other) in [("a + (b + c)", "a + b + c"), ("a*(b/c)", "a*b/c"), ("(a*b)*c", "a*b*c"), ("a*(-b)", "-a*b")]
    {
        assert_ne!(read(text), read(other), "{text}");
        assert_eq!(read(text).to_string(), text);
    }
}

#[test]
fn names_are_whole() {
    let symbol = |name: &str| Formula::Symbol(name.to_string());
    for name in
        ["x", "m[3]", "m[3][0]", "dot(x)", "dot(dot_x)", "ddot(theta_1)", "r#type", "größe", "θ1", "if_open", "PI"]
    {
        assert_eq!(read(name), symbol(name));
        assert_eq!(read(&format!("2*{name}/y")).to_string(), format!("2*{name}/y"));
    }
    // A function that begins with a name of the language is one of its own.
    assert!(matches!(read("dots(x)"), Formula::Call { function, .. } if function == "dots"));
    assert!(matches!(read("dot(x + y)"), Formula::Call { .. }));
}

#[test]
fn numbers_keep_their_digits() {
    let digits = "170141183460469231731687303715884105727123456789";
    assert_eq!(read(digits), Formula::Number(digits.to_string()));
    for text in ["0", "9.81", "1.5e-3", "2e10", "981/100"] {
        assert_eq!(read(text).to_string(), text);
    }
    let Formula::Quotient { numerator, denominator } = read("981/100") else { panic!("a quotient") };
    assert_eq!([*numerator, *denominator], ["981", "100"].map(|n| Formula::Number(n.to_string())));
}

#[test]
fn vectors_and_matrices_stand_outermost() {
    assert_eq!(read("[]"), Formula::Vector(Vec::new()));
    assert_eq!(read("[[], []]"), Formula::Matrix(vec![Vec::new(), Vec::new()]));
    let Formula::Matrix(rows) = read("[[a, -b], [0, c/2]]") else { panic!("a matrix") };
    assert_eq!(rows.iter().map(Vec::len).collect::<Vec<_>>(), [2, 2]);
    assert_eq!(rows[1][1].to_string(), "c/2");
}

#[test]
fn what_cannot_be_read_is_told_with_its_place() {
    for (text, message) in [
        ("", "expected a number, a name or `(` at byte 0, found the end"),
        ("a +", "expected a number, a name or `(` at byte 3, found the end"),
        ("a b", "expected an operator or the end at byte 2, found `b`"),
        ("2x1", "expected an operator or the end at byte 1, found `x1`"),
        ("a*)", "expected a number, a name or `(` at byte 2, found `)`"),
        ("(a + b", "expected `)` at byte 6, found the end"),
        ("sin()", "expected a number, a name or `(` at byte 4, found `)`"),
        ("sin(a b)", "expected `,` or `)` at byte 6, found `b`"),
        ("powi(a, b)", "expected a whole exponent at byte 8, found `b`"),
        ("powi(a, 99999999999)", "expected a whole exponent at byte 8, found `99999999999`"),
        ("powi(a)", "expected `,` at byte 6, found `)`"),
        ("m[i]", "expected an index at byte 2, found `i`"),
        ("if a < 1 { b } else { c }", "expected `0` at byte 7, found `1`"),
        ("if a < 0 { b }", "expected `else` at byte 14, found the end"),
        ("[a, b", "expected `,` or `]` at byte 5, found the end"),
        ("[[a, b], [c]]", "expected a row as long as the first at byte 11, found `]`"),
        ("2*[a, b]", "expected a number, a name or `(` at byte 2, found `[`"),
        ("größe + …", "expected a number, a name or `(` at byte 10, found `…`"),
        ("a − b", "expected an operator or the end at byte 2, found `−`"),
    ] {
        assert_eq!(text.parse::<Formula>().map_err(|error| error.to_string()), Err(message.to_string()), "{text}");
    }
}

/// Whatever nests without end is refused, in a stack of 768 KiB without optimisation, and long sums and products are not nested.
#[test]
#[cfg(feature = "std")]
fn height_is_bounded() {
    let many = |text: &str| text.repeat(100_000);
    let deep = [
        many("("),
        many("-") + "a",
        "a".to_string() + &many("/a"),
        "a".to_string() + &many("/a*a"),
        many("sin("),
        many("a*(b + "),
        many("if "),
        many("powi("),
        "[".to_string() + &many("-(") + "a",
    ];
    let bounded = move || {
        for text in deep {
            let error = text.parse::<Formula>().unwrap_err();
            assert_eq!(error.expected, "a formula that is nested less deeply", "{}", &text[..8]);
        }
        let within = "(".repeat(60) + "a" + &")".repeat(60);
        assert_eq!(read(&within).to_string(), "a");
        let within = "sin(".repeat(60) + "a" + &")".repeat(60);
        assert_eq!(read(&within).to_string(), within);
        assert_eq!(read(&within).latex().matches("\\left(").count(), 59);
        for text in ["a".to_string() + &many(" + a"), "a".to_string() + &many("*a")] {
            assert_eq!(read(&text).to_string(), text);
        }
    };
    std::thread::Builder::new().stack_size(3 << 18).spawn(bounded).unwrap().join().unwrap();
}

/// Any formula that there can be, from a seed.
struct Random(u64);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }

    fn name(&mut self) -> String {
        ["x", "theta_1", "dot_x", "m[3]", "dot(v5)", "größe", "r#type", "e12"][self.below(8) as usize].to_string()
    }

    fn several(&mut self, least: u64, height: u64) -> Vec<Formula> {
        (0..least + self.below(3)).map(|_| self.formula(height)).collect()
    }

    fn formula(&mut self, height: u64) -> Formula {
        if height == 0 || self.below(6) == 0 {
            let number = self.below(1_000).to_string();
            return if self.below(3) == 0 { Formula::Number(number) } else { Formula::Symbol(self.name()) };
        }
        let below = height - 1;
        match self.below(7) {
            0 => Formula::Negative(self.formula(below).into()),
            1 => Formula::Sum(self.several(2, below)),
            2 => Formula::Product(self.several(2, below)),
            3 => {
                let [numerator, denominator] = [(); 2].map(|()| self.formula(below).into());
                Formula::Quotient { numerator, denominator }
            }
            4 => Formula::Power { base: self.formula(below).into(), exponent: self.below(9) as i32 - 4 },
            5 => {
                let function = ["sin", "road", "atan2", "f"][self.below(4) as usize].to_string();
                Formula::Call { function, arguments: self.several(1, below) }
            }
            _ => {
                let [condition, negative, otherwise] = [(); 3].map(|()| self.formula(below).into());
                Formula::Select { condition, negative, otherwise }
            }
        }
    }
}

#[test]
fn what_is_written_is_read_again() {
    let mut random = Random(7);
    for case in 0..3_000 {
        let formula = match random.below(8) {
            0 => Formula::Vector(random.several(0, 3)),
            1 => {
                let columns = random.below(4);
                let row = |r: &mut Random| (0..columns).map(|_| r.formula(2)).collect();
                Formula::Matrix((0..1 + random.below(3)).map(|_| row(&mut random)).collect())
            }
            _ => random.formula(5),
        };
        let text = formula.to_string();
        assert_eq!(text.parse().as_ref(), Ok(&formula), "case {case}: {text}");
        let latex = formula.latex();
        assert_eq!(latex.matches('{').count(), latex.matches('}').count(), "case {case}: {latex}");
        assert_eq!(latex.matches("\\left").count(), latex.matches("\\right").count(), "case {case}: {latex}");
        #[cfg(feature = "serde")]
        {
            let json = serde_json::to_string(&formula).unwrap();
            assert_eq!(serde_json::from_str::<Formula>(&json).unwrap(), formula, "case {case}: {json}");
        }
    }
}
