//! Arrays, families and sums, written out: `a[i + 1]` is the name `a_3`, `.. for i in 0..n` one entry for each i.

use super::statements::plain;
use std::collections::BTreeMap;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{
    BinOp, Block, Expr, ExprArray, ExprAssign, ExprBinary, ExprBlock, ExprCall, ExprField, ExprIf, ExprParen,
    ExprUnary, Ident, RangeLimits, Result, Stmt, Token, UnOp, bracketed,
};

/// Sizes and indices with their values.
pub type Indices = BTreeMap<String, i64>;

/// What stands once, or once for each value of its indices, the last of them running fastest.
pub struct Family<T> {
    what: T,
    clauses: Vec<(Ident, Expr)>,
}

impl<T: Parse> Parse for Family<T> {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let what = input.parse()?;
        let mut clauses = Vec::new();
        while input.parse::<Option<Token![for]>>()?.is_some() {
            let index = input.parse()?;
            input.parse::<Token![in]>()?;
            clauses.push((index, input.parse()?));
        }
        Ok(Self { what, clauses })
    }
}

impl<T> Family<T> {
    /// One of each member.
    pub fn members<U>(&self, indices: &Indices, member: &mut impl FnMut(&T, &Indices) -> U) -> Vec<U> {
        let mut all = vec![indices.clone()];
        for (index, values) in &self.clauses {
            let with = |indices: &Indices, value| {
                let mut indices = indices.clone();
                indices.insert(index.to_string(), value);
                indices
            };
            all = all.iter().flat_map(|known| range(values, known).map(move |value| with(known, value))).collect();
        }
        all.iter().map(|indices| member(&self.what, indices)).collect()
    }
}

/// `[a, b for i in 0..n]`
pub struct Row(Punctuated<Family<Expr>, Token![,]>);

impl Parse for Row {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let inner;
        bracketed!(inner in input);
        Punctuated::parse_terminated(&inner).map(Self)
    }
}

impl Row {
    /// Its entries.
    pub fn entries(&self, indices: &Indices) -> Vec<Expr> {
        self.0.iter().flat_map(|family| family.members(indices, &mut written)).collect()
    }
}

/// A name, or an entry of an array, or the array as it is declared.
pub struct Named {
    name: Ident,
    index: Option<Expr>,
}

impl Parse for Named {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let name: Ident = input.parse()?;
        let index = if input.peek(syn::token::Bracket) {
            let inner;
            bracketed!(inner in input);
            Some(inner.parse()?)
        } else {
            None
        };
        Ok(Self { name, index })
    }
}

impl Named {
    /// The entry's name.
    pub fn entry(&self, indices: &Indices) -> String {
        match &self.index {
            Some(index) => element(&self.name, integer(index, indices)),
            None => self.name.to_string(),
        }
    }

    /// The names that a declaration `a[n]` declares.
    pub fn declared(&self, sizes: &Indices) -> Vec<String> {
        match &self.index {
            Some(length) => (0..integer(length, sizes)).map(|i| element(&self.name, i)).collect(),
            None => vec![self.name.to_string()],
        }
    }
}

/// The name of an entry of an array.
pub fn element(array: &Ident, index: i64) -> String {
    format!("{array}_{index}")
}

/// The value of an expression in integers.
///
/// # Panics
/// On anything else.
pub fn integer(e: &Expr, indices: &Indices) -> i64 {
    match e {
        Expr::Paren(inner) => integer(&inner.expr, indices),
        Expr::Group(inner) => integer(&inner.expr, indices),
        Expr::Unary(u) if matches!(u.op, UnOp::Neg(_)) => -integer(&u.expr, indices),
        Expr::Lit(_) => super::statements::number(e) as i64,
        Expr::Path(_) => indices[&plain(e).expect("an index")],
        Expr::Binary(b) => {
            let (left, right) = (integer(&b.left, indices), integer(&b.right, indices));
            match b.op {
                BinOp::Add(_) => left + right,
                BinOp::Sub(_) => left - right,
                BinOp::Mul(_) => left * right,
                BinOp::Div(_) => left / right,
                BinOp::Rem(_) => left % right,
                _ => panic!("not an operation of integers"),
            }
        }
        Expr::Call(call) => {
            let values = call.args.iter().map(|e| integer(e, indices));
            let value = if plain(&call.func).as_deref() == Some("min") { values.min() } else { values.max() };
            value.expect("integers")
        }
        _ => panic!("not an integer"),
    }
}

fn range(e: &Expr, indices: &Indices) -> std::ops::Range<i64> {
    let Expr::Range(range) = e else { panic!("not a range") };
    let bound = |e: &Option<Box<Expr>>| integer(e.as_ref().expect("both ends of the range"), indices);
    let last = i64::from(matches!(range.limits, RangeLimits::Closed(_)));
    bound(&range.start)..bound(&range.end) + last
}

fn name(text: &str) -> Expr {
    syn::parse_str(text).expect("a name or a number")
}

/// An expression without indices and sums.
///
/// # Panics
/// On an index that has no value.
pub fn written(e: &Expr, indices: &Indices) -> Expr {
    let inner = |e: &Expr| Box::new(written(e, indices));
    let block = |block: &Block| match block.stmts.as_slice() {
        [Stmt::Expr(e, None)] => Block { stmts: vec![Stmt::Expr(written(e, indices), None)], ..block.clone() },
        _ => panic!("not an expression of a model"),
    };
    match e {
        Expr::Paren(p) => {
            Expr::Paren(ExprParen { attrs: Vec::new(), paren_token: p.paren_token, expr: inner(&p.expr) })
        }
        Expr::Group(group) => written(&group.expr, indices),
        Expr::Unary(u) => Expr::Unary(ExprUnary { attrs: Vec::new(), op: u.op, expr: inner(&u.expr) }),
        Expr::Binary(b) => {
            Expr::Binary(ExprBinary { attrs: Vec::new(), left: inner(&b.left), op: b.op, right: inner(&b.right) })
        }
        Expr::Assign(a) => Expr::Assign(ExprAssign {
            attrs: Vec::new(),
            left: inner(&a.left),
            eq_token: a.eq_token,
            right: inner(&a.right),
        }),
        Expr::Path(_) => match plain(e).and_then(|name| indices.get(&name).copied()) {
            Some(value) => name(&value.to_string()),
            None => e.clone(),
        },
        Expr::Index(entry) => {
            let array = plain(&entry.expr).expect("the name of an array");
            name(&format!("{array}_{}", integer(&entry.index, indices)))
        }
        Expr::If(choice) => Expr::If(ExprIf {
            attrs: Vec::new(),
            if_token: choice.if_token,
            cond: inner(&choice.cond),
            then_branch: block(&choice.then_branch),
            else_branch: choice.else_branch.as_ref().map(|(token, e)| (*token, inner(e))),
        }),
        Expr::Block(b) => Expr::Block(ExprBlock { attrs: Vec::new(), label: None, block: block(&b.block) }),
        Expr::Field(field) => Expr::Field(ExprField { base: inner(&field.base), ..field.clone() }),
        Expr::Array(array) => Expr::Array(ExprArray {
            attrs: Vec::new(),
            bracket_token: array.bracket_token,
            elems: array.elems.iter().map(|e| written(e, indices)).collect(),
        }),
        Expr::Call(call) => match plain(&call.func).as_deref() {
            Some("sum") => repeated(call, indices, "+", "0"),
            Some("product") => repeated(call, indices, "*", "1"),
            _ => Expr::Call(ExprCall {
                attrs: Vec::new(),
                func: call.func.clone(),
                paren_token: call.paren_token,
                args: call.args.iter().map(|e| written(e, indices)).collect(),
            }),
        },
        other => other.clone(),
    }
}

/// `sum(0..n, |j| ..)`
fn repeated(call: &ExprCall, indices: &Indices, sign: &str, nothing: &str) -> Expr {
    let arguments: Vec<&Expr> = call.args.iter().collect();
    let [values, Expr::Closure(closure)] = arguments.as_slice() else { panic!("not a range and what is repeated") };
    let Some(syn::Pat::Ident(index)) = closure.inputs.first() else { panic!("not an index") };
    let term = |value: i64| {
        let mut indices = indices.clone();
        indices.insert(index.ident.to_string(), value);
        written(&closure.body, &indices)
    };
    let op: BinOp = syn::parse_str(sign).expect("an operation");
    let both = |left: Expr, right: Expr| {
        Expr::Binary(ExprBinary { attrs: Vec::new(), left: Box::new(left), op, right: Box::new(right) })
    };
    range(values, indices).map(term).reduce(both).unwrap_or_else(|| name(nothing))
}
