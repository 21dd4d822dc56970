//! The statements of a model, one attribute each.

use super::declaration::{Chosen, Configuration, Constraint, Declaration, Level};
use super::families::{Family, Indices, Named, Row, integer, written};
use super::geometry::NamedRecord;
use super::joints;
use quote::ToTokens;
use std::collections::BTreeMap;
use syn::parse::{Parse, ParseStream, Parser};
use syn::punctuated::Punctuated;
use syn::{Attribute, BinOp, Error, Expr, ExprAssign, ExprCall, Ident, Lit, Result, Token, UnOp, parenthesized};

/// Reads one attribute into the declaration; attributes that say nothing about the mechanics are passed over.
pub fn read(model: &mut Declaration, name: &str, attribute: &Attribute) -> Result<()> {
    let sizes = &model.sizes.clone();
    let expression = || attribute.parse_args::<Expr>().map(|e| written(&e, sizes));
    let list = || -> Result<Vec<Expr>> {
        let families = entries::<Family<Expr>>(attribute)?;
        Ok(families.iter().flat_map(|family| family.members(sizes, &mut written)).collect())
    };
    match name {
        "coordinates" => model.coordinates = names(attribute, sizes)?,
        "speeds" => model.speeds = names(attribute, sizes)?,
        "inputs" => model.inputs.extend(names(attribute, sizes)?),
        "kinematics" => kinematics(model, list()?)?,
        "inertia" => model.inertia = attribute.parse_args_with(|input: ParseStream<'_>| inertia(input, sizes))?,
        "forces" => model.forces = list()?,
        "kinetic_energy" => model.kinetic_energy = Some(expression()?),
        "potential_energy" => model.potential_energy = Some(expression()?),
        "constraint" => model.constraints.extend(constraints(&entries(attribute)?, sizes)),
        "configuration" => model.configuration = Some(configuration(&entries(attribute)?, sizes)?),
        "independent" => model.charts.push(list()?.into_iter().map(chosen).collect::<Result<_>>()?),
        "velocities" => model.gives_velocities = true,
        "complement" => {
            for family in entries::<Family<NamedRow>>(attribute)? {
                let row = |row: &NamedRow, indices: &Indices| (row.name.entry(indices), row.row.entries(indices));
                model.complement.extend(family.members(sizes, &mut { row }));
            }
        }
        "frame" => {
            let frames = assignments(list()?)?;
            model.geometry.frames.extend(frames.into_iter().map(|(name, value)| (name, joints::frame(value))));
        }
        "point" => {
            let points = assignments(list()?)?;
            model.geometry.points.extend(points.into_iter().map(|(name, value)| (name, joints::point(value))));
        }
        "release" => {
            for family in entries::<Family<NamedRecord>>(attribute)? {
                let record = |said: &NamedRecord, indices: &Indices| said.record(name, indices);
                model.geometry.releases.extend(family.members(sizes, &mut { record }));
            }
        }
        "gravity" => model.geometry.gravity.extend(list()?),
        "generalized_force" => model.geometry.generalized.extend(assignments(list()?)?),
        "body" | "particle" | "force" | "torque" | "spring" | "damper" | "armature" => {
            for family in entries::<Family<NamedRecord>>(attribute)? {
                let record = |said: &NamedRecord, indices: &Indices| said.record(name, indices);
                model.geometry.records.extend(family.members(sizes, &mut { record }));
            }
        }
        "define" => model.definitions.extend(assignments(list()?)?),
        "output" => {
            let output = |output: &Output, indices: &Indices| {
                let name = output.name.entry(indices);
                let value = output.value.as_ref().map(|e| written(e, indices));
                (name.clone(), value.unwrap_or_else(|| self::expression(&name)))
            };
            for family in entries::<Family<Output>>(attribute)? {
                model.outputs.extend(family.members(sizes, &mut { output }));
            }
        }
        "start" => {
            let start = assignments(list()?)?;
            model.start.extend(start.into_iter().map(|(name, value)| (name, number(&value))));
        }
        "function" => {
            let first = entries::<Expr>(attribute)?.into_iter().next();
            let Some(Expr::Call(call)) = first else { return Err(Error::new_spanned(attribute, "not a function")) };
            model.functions.insert(plain(&call.func).ok_or_else(|| Error::new_spanned(&call, "not a name"))?);
        }
        _ => {}
    }
    Ok(())
}

/// Reads `size(n = 20, m = n - 1)`; sizes are known before anything else is read.
pub fn sizes(model: &mut Declaration, attribute: &Attribute) -> Result<()> {
    for (name, value) in assignments(entries(attribute)?)? {
        let value = integer(&value, &model.sizes);
        model.sizes.insert(name, value);
    }
    Ok(())
}

/// What stands between the commas.
fn entries<T: Parse>(attribute: &Attribute) -> Result<Vec<T>> {
    Ok(attribute.parse_args_with(Punctuated::<T, Token![,]>::parse_terminated)?.into_iter().collect())
}

/// The number that a literal spells, with its sign.
pub fn number(e: &Expr) -> f64 {
    match e {
        Expr::Unary(u) if matches!(u.op, UnOp::Neg(_)) => -number(&u.expr),
        Expr::Lit(l) => match &l.lit {
            Lit::Int(i) => i.base10_digits().parse().expect("an integer"),
            Lit::Float(f) => f.base10_digits().parse().expect("a float"),
            _ => panic!("not a number"),
        },
        _ => panic!("not a number"),
    }
}

/// `dot(x)` as the name x.
pub fn rate_of(e: &Expr) -> Option<String> {
    plain(argument(e, "dot")?)
}

/// `ddot(x)` or `dot(dot(x))` as the name x.
pub fn second_rate_of(e: &Expr) -> Option<String> {
    match argument(e, "ddot") {
        Some(x) => plain(x),
        None => rate_of(argument(e, "dot")?),
    }
}

/// The argument of a call of that name, where it has one.
fn argument<'a>(e: &'a Expr, function: &str) -> Option<&'a Expr> {
    let Expr::Call(ExprCall { func, args, .. }) = e else {
        return None;
    };
    // `dot` with two arguments is the scalar product
    if plain(func)? == function && args.len() == 1 { args.first() } else { None }
}

/// A path of one segment.
pub fn plain(e: &Expr) -> Option<String> {
    let Expr::Path(p) = e else { return None };
    p.path.get_ident().map(ToString::to_string)
}

fn names(attribute: &Attribute, sizes: &Indices) -> Result<Vec<String>> {
    struct Documented(Named);
    impl Parse for Documented {
        fn parse(input: ParseStream<'_>) -> Result<Self> {
            Attribute::parse_outer(input)?;
            input.parse().map(Self)
        }
    }
    let names = entries::<Documented>(attribute)?;
    Ok(names.iter().flat_map(|name| name.0.declared(sizes)).collect())
}

/// `u1 = [..]`
struct NamedRow {
    name: Named,
    row: Row,
}

impl Parse for NamedRow {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let name = input.parse()?;
        input.parse::<Token![=]>()?;
        Ok(Self { name, row: input.parse()? })
    }
}

/// `power = ..` or `mu`, with doc comments before it.
struct Output {
    name: Named,
    value: Option<Expr>,
}

impl Parse for Output {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        Attribute::parse_outer(input)?;
        let name = input.parse()?;
        let value = if input.parse::<Option<Token![=]>>()?.is_some() { Some(input.parse()?) } else { None };
        Ok(Self { name, value })
    }
}

/// `reaction(rod)` as the name of the constraint.
pub fn reaction_of(e: &Expr) -> Option<String> {
    plain(argument(e, "reaction")?)
}

fn assignment(e: Expr) -> Result<(Expr, Expr)> {
    match e {
        Expr::Assign(ExprAssign { left, right, .. }) => Ok((*left, *right)),
        other => Err(Error::new_spanned(other, "not an assignment")),
    }
}

fn assignments(list: Vec<Expr>) -> Result<Vec<(String, Expr)>> {
    let named = |e| {
        let (left, right) = assignment(e)?;
        let name = plain(&left).ok_or_else(|| Error::new_spanned(&left, "not a name"))?;
        Ok((name, right))
    };
    list.into_iter().map(named).collect()
}

/// A speed, the rate of a coordinate, or `name = combination`.
fn chosen(e: Expr) -> Result<Chosen> {
    if !matches!(e, Expr::Assign(_)) {
        return Ok(Chosen { name: None, value: e });
    }
    let (left, value) = assignment(e)?;
    let name = plain(&left).ok_or_else(|| Error::new_spanned(&left, "not a name"))?;
    Ok(Chosen { name: Some(name), value })
}

/// Either direction; the order is that of x or of v, so both must have been declared above.
fn kinematics(model: &mut Declaration, list: Vec<Expr>) -> Result<()> {
    let (mut rates, mut speeds) = (BTreeMap::new(), BTreeMap::new());
    for e in list {
        let (left, right) = assignment(e)?;
        match (rate_of(&left), plain(&left)) {
            (Some(x), _) => rates.insert(x, right),
            (_, Some(v)) => speeds.insert(v, right),
            _ => return Err(Error::new_spanned(left, "neither a speed nor dot(x)")),
        };
    }
    let ordered = |names: &[String], mut map: BTreeMap<String, Expr>| -> Option<Vec<Expr>> {
        names.iter().map(|name| map.remove(name)).collect()
    };
    model.rates = ordered(&model.coordinates, rates);
    model.speeds_by_rates = ordered(&model.speeds, speeds);
    Ok(())
}

/// `diag(..)` or `matrix([..], ..)`
fn inertia(input: ParseStream<'_>, sizes: &Indices) -> Result<Vec<Vec<Option<Expr>>>> {
    let form: Ident = input.parse()?;
    let inner;
    parenthesized!(inner in input);
    input.parse::<Option<Token![,]>>()?;
    if form == "diag" {
        let families = Punctuated::<Family<Expr>, Token![,]>::parse_terminated(&inner)?;
        let diagonal: Vec<Expr> = families.iter().flat_map(|family| family.members(sizes, &mut written)).collect();
        let n = diagonal.len();
        let row = |i: usize| (0..n).map(|j| (i == j).then(|| diagonal[i].clone())).collect();
        return Ok((0..n).map(row).collect());
    }
    let families = Punctuated::<Family<Row>, Token![,]>::parse_terminated(&inner)?;
    let entry = |e: Expr| (!matches!(e, Expr::Infer(_))).then_some(e);
    let row = |row: &Row, indices: &Indices| row.entries(indices).into_iter().map(entry).collect();
    Ok(families.iter().flat_map(|family| family.members(sizes, &mut { row })).collect())
}

/// `name: left == right`, or a word about the equation before.
enum Said {
    Equation(Box<(Named, Expr, Expr)>),
    Joint(Box<(Named, ExprCall)>),
    Word(Ident),
    Expressed(Box<Expr>),
}

impl Parse for Said {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        if input.peek(Ident) && input.peek2(Token![=]) {
            let word: Ident = input.parse()?;
            input.parse::<Token![=]>()?;
            assert_eq!(word, "expressed");
            return input.parse().map(|frame| Self::Expressed(Box::new(frame)));
        }
        if input.peek(Ident) && !input.peek2(Token![:]) && !input.peek2(syn::token::Bracket) {
            return input.parse().map(Self::Word);
        }
        let name = input.parse()?;
        input.parse::<Token![:]>()?;
        match input.parse()? {
            Expr::Binary(e) if matches!(e.op, BinOp::Eq(_)) => Ok(Self::Equation(Box::new((name, *e.left, *e.right)))),
            Expr::Call(call) if joints::equations(&call).is_some() => Ok(Self::Joint(Box::new((name, call)))),
            other => Err(Error::new_spanned(other, "not an equation")),
        }
    }
}

/// The constraints of one statement.
fn constraints(families: &[Family<Said>], sizes: &Indices) -> Vec<Constraint> {
    let mut rows: Vec<Constraint> = Vec::new();
    // where the constraints of the last equation begin
    let mut first = 0;
    for family in families {
        let member = |said: &Said, indices: &Indices| match said {
            Said::Equation(row) => Ok(vec![Constraint {
                name: row.0.entry(indices),
                left: written(&row.1, indices),
                right: written(&row.2, indices),
                level: Level::Position,
                redundant: false,
                expressed: expression("N"),
                in_short: false,
            }]),
            Said::Joint(joint) => {
                let of = |(suffix, left, right): (String, Expr, Expr)| Constraint {
                    name: joint.0.entry(indices) + &suffix,
                    left: written(&left, indices),
                    right: written(&right, indices),
                    level: Level::Position,
                    redundant: false,
                    expressed: expression("N"),
                    in_short: true,
                };
                Ok(joints::equations(&joint.1).expect("it was one when it was read").into_iter().map(of).collect())
            }
            Said::Word(word) => {
                assert_eq!(word, "redundant");
                Err(None)
            }
            Said::Expressed(frame) => Err(Some(Box::new(written(frame, indices)))),
        };
        let members: std::result::Result<Vec<Vec<Constraint>>, Option<Box<Expr>>> =
            family.members(sizes, &mut { member }).into_iter().collect();
        match members {
            Ok(members) => {
                first = rows.len();
                rows.extend(members.into_iter().flatten());
            }
            Err(None) => rows[first..].iter_mut().for_each(|row| row.redundant = true),
            Err(Some(frame)) => rows[first..].iter_mut().for_each(|row| row.expressed = (*frame).clone()),
        }
    }
    rows
}

fn configuration(families: &[Family<Expr>], sizes: &Indices) -> Result<Configuration> {
    let names = |call: &ExprCall| -> Result<Vec<String>> {
        let named = |e: &Expr| Ok(syn::parse2::<Named>(e.to_token_stream())?.declared(sizes));
        Ok(call.args.iter().map(named).collect::<Result<Vec<_>>>()?.concat())
    };
    let mut configuration = Configuration::default();
    let mut quasi = Vec::new();
    let mut given = Vec::new();
    for family in families {
        for (e, indices) in family.members(sizes, &mut |e, indices| (e.clone(), indices.clone())) {
            match e {
                Expr::Call(call) if plain(&call.func).as_deref() == Some("speeds") => quasi.extend(names(&call)?),
                Expr::Call(call) => configuration.coordinates.extend(names(&call)?),
                other => given.push(assignment(written(&other, &indices))?),
            }
        }
    }
    for (left, right) in given {
        match plain(&left) {
            Some(x) if !quasi.contains(&x) => {
                configuration.map.insert(x, right);
            }
            _ => configuration.quasi.push((left, right)),
        }
    }
    configuration.speeds = quasi;
    Ok(configuration)
}

/// An expression from text, for tests of the evaluator itself.
pub fn expression(text: &str) -> Expr {
    Expr::parse.parse_str(text).expect("an expression")
}
