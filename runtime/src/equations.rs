//! The derived equations as formulas: read, written, in LaTeX, and with the feature `serde` in JSON and its like.
//!
//! [`Description::equations`] has every equation with its number in the paper, as text in the notation of models. An
//! equation may use parts, which stand before it as equations of their own, with symbols like `e1` and without a number.
//!
//! | from | comes |
//! |---|---|
//! | [`Description::latex`], [`Equation::latex`], [`Formula::latex`] | LaTeX for amsmath, nothing else: a document's fragment, an equation, a formula |
//! | [`Equation::formula`], [`str::parse`] | the [`Formula`], a tree |
//! | `Display` of a formula | the notation of models again |
//! | feature `serde`: `Serialize` of [`Description`] | all that is known of a model; formulas are read again by `Deserialize` |
//!
//! # The notation of models
//!
//! `+ - * /` and parentheses; whole and decimal numbers; names, which may be elements of arrays (`m[3]`) or rates (`dot(x)`,
//! `ddot(x)`); `powi(a, n)` with a whole n; functions of one or more arguments; `if c < 0 { a } else { b }`. A vector
//! `[a, b]` or a matrix `[[a, b], [c, d]]` stands outermost. A text whose formula would be higher than 64 floors is refused.
//!
//! # In LaTeX
//!
//! | name | LaTeX |
//! |---|---|
//! | `theta_1`, `theta1` | `\theta_{1}` |
//! | `v_B_N_x` | `v_{B,N,x}` |
//! | `mass` | `\mathrm{mass}` |
//! | `dot(x)`, `dot_x`, `dot(dot_x)` | `\dot{x}`, `\dot{x}`, `\ddot{x}` |
//! | `m[3]` | `m_{3}` |
//! | `lambda(rod)` | `\lambda_{\mathrm{rod}}` |
//! | `h_u*`, `c0*` | `h_{u}^{*}`, `c_{0}^{*}` |
//! | `PI` | `\pi` |
//!
//! # In JSON
//!
//! The fields of a [`Description`] and of what it holds stand under their names, levels and kinds as words (`"position"`,
//! `"pivot"`). An equation has its fields and `formula`: a formula, or null where the text is none. A formula is an object with one
//! entry, whose key says what it is:
//!
//! | formula | JSON, where F is a formula again |
//! |---|---|
//! | a number | `{"number": "981"}` |
//! | a name | `{"symbol": "theta"}` |
//! | −a | `{"negative": F}` |
//! | a + b + … | `{"sum": [F, F, …]}` |
//! | a b … | `{"product": [F, F, …]}` |
//! | a/b | `{"quotient": {"numerator": F, "denominator": F}}` |
//! | aⁿ | `{"power": {"base": F, "exponent": 2}}` |
//! | f(a, …) | `{"call": {"function": "sin", "arguments": [F, …]}}` |
//! | `if a < 0 { b } else { c }` | `{"select": {"condition": F, "negative": F, "otherwise": F}}` |
//! | a vector | `{"vector": [F, …]}` |
//! | a matrix | `{"matrix": [[F, …], …]}`, row after row |
//!
//! ```
//! # #[cfg(all(feature = "derive", feature = "serde"))] {
//! use holonomy::ConstrainedSystem;
//! use holonomy::equations::Formula;
//!
//! #[derive(ConstrainedSystem, Clone)]
//! #[coordinates(x)]
//! #[inertia(diag(m))]
//! #[forces(-k*x)]
//! struct Spring {
//!     m: f64,
//!     k: f64,
//! }
//!
//! let json = serde_json::to_value(Spring::MODEL).unwrap();
//! assert_eq!(json["parameters"], serde_json::json!(["m", "k"]));
//! let rate = json["equations"].as_array().unwrap().iter().find(|e| e["symbol"] == "dot(dot_x)").unwrap();
//! assert_eq!((&rate["source"], &rate["text"]), (&"(5.6)".into(), &"-k*x/m".into()));
//! assert_eq!(rate["formula"]["negative"]["quotient"]["denominator"], serde_json::json!({"symbol": "m"}));
//! let formula: Formula = serde_json::from_value(rate["formula"].clone()).unwrap();
//! assert_eq!(formula.latex(), r"-\frac{k x}{m}");
//! # }
//! ```

mod formula;
#[cfg(feature = "serde")]
pub(crate) mod json;
mod latex;
mod names;
mod read;
#[cfg(test)]
mod tests;

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use crate::{Description, Equation};

pub use formula::Formula;
pub use read::Unreadable;

impl Equation {
    /// The right side as a tree.
    ///
    /// # Errors
    /// If [`text`](Equation::text) is no formula. Those of the derive are, but for `…` where the equations of a model are together
    /// longer than anybody reads.
    ///
    /// ```
    /// # #[cfg(feature = "derive")] {
    /// use holonomy::ConstrainedSystem;
    /// use holonomy::equations::Formula;
    ///
    /// #[derive(ConstrainedSystem, Clone)]
    /// #[coordinates(x, y)]
    /// #[inertia(diag(m, m))]
    /// #[forces(0, -m*g)]
    /// #[constraint(slope: y == a*x)]
    /// #[independent(dot(x))]
    /// struct Slide {
    ///     m: f64,
    ///     g: f64,
    ///     a: f64,
    /// }
    ///
    /// let inertia = Slide::MODEL.equations.iter().find(|e| e.symbol == "M").unwrap();
    /// let Formula::Matrix(rows) = inertia.formula()? else { panic!("a matrix") };
    /// assert_eq!(rows[1][1], Formula::Symbol("m".into()));
    /// # }
    /// # Ok::<(), holonomy::equations::Unreadable>(())
    /// ```
    pub fn formula(&self) -> Result<Formula, Unreadable> {
        self.text.parse()
    }

    /// The equation in LaTeX, for math mode with amsmath. A text that is no formula stands as text.
    ///
    /// ```
    /// # #[cfg(feature = "derive")] {
    /// # use holonomy::ConstrainedSystem;
    /// # #[derive(ConstrainedSystem, Clone)]
    /// # #[coordinates(x, y)]
    /// # #[inertia(diag(m, m))]
    /// # #[forces(0, -m*g)]
    /// # #[constraint(slope: y == a*x)]
    /// # #[independent(dot(x))]
    /// # struct Slide {
    /// #     m: f64,
    /// #     g: f64,
    /// #     a: f64,
    /// # }
    /// // The slide of `formula`, above.
    /// let forces = Slide::MODEL.equations.iter().find(|e| e.symbol == "h*").unwrap();
    /// assert_eq!(forces.latex(), r"h^{*} = \begin{bmatrix} 0 \\ -m g \end{bmatrix}");
    /// # }
    /// ```
    pub fn latex(&self) -> String {
        format!("{} = {}", names::symbol(self.symbol), lines(self.text).concat())
    }
}

/// What stands between the lines of one equation.
const BREAK: &str = " \\\\\n&\\quad";

/// The formula of a text, or the text as such where it is none.
fn lines(text: &str) -> Vec<String> {
    match text.parse::<Formula>() {
        Ok(formula) => formula.latex_in_lines(),
        Err(_) => Vec::from([format!("\\text{{{}}}", names::escaped(text))]),
    }
}

/// The number in the paper as amsmath prints it beside the equation; empty without one.
fn tag(source: &str) -> String {
    match source.strip_prefix('(').and_then(|source| source.strip_suffix(')')) {
        Some(number) => format!(" \\tag{{{}}}", names::escaped(number)),
        None if source.is_empty() => String::new(),
        None => format!(" \\tag*{{{}}}", names::escaped(source)),
    }
}

impl Description {
    /// All equations in LaTeX, numbered as in the paper: a fragment for a document with amsmath, that may run over pages.
    ///
    /// ```
    /// # #[cfg(feature = "derive")] {
    /// use holonomy::ConstrainedSystem;
    ///
    /// #[derive(ConstrainedSystem, Clone)]
    /// #[coordinates(theta)]
    /// #[inertia(diag(m*powi(l, 2)))]
    /// #[forces(-m*g*l*sin(theta))]
    /// struct Swing {
    ///     m: f64,
    ///     g: f64,
    ///     l: f64,
    /// }
    ///
    /// let latex = Swing::MODEL.latex();
    /// assert!(latex.contains(r"\ddot{\theta} &= -\frac{g \sin\theta}{l} \tag{5.6}"), "{latex}");
    /// let document = [r"\documentclass{article} \usepackage{amsmath} \begin{document}", &latex, r"\end{document}"].join("\n");
    /// # }
    /// ```
    pub fn latex(&self) -> String {
        let line =
            |e: &Equation| format!("{} &= {}{}", names::symbol(e.symbol), lines(e.text).join(BREAK), tag(e.source));
        let lines: Vec<String> = self.equations.iter().map(line).collect();
        if lines.is_empty() {
            return String::new();
        }
        let lines = lines.join(" \\\\\n");
        format!("\\begingroup\\allowdisplaybreaks\n\\begin{{align*}}\n{lines}\n\\end{{align*}}\n\\endgroup\n")
    }
}
