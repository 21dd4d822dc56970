//! The statements of a model, one attribute each.

use super::declaration::{Chosen, Configuration, Constraint, Declaration, Level};
use std::collections::BTreeMap;
use syn::parse::{Parse, ParseStream, Parser};
use syn::punctuated::Punctuated;
use syn::{Attribute, BinOp, Error, Expr, ExprAssign, ExprCall, Ident, Lit, Result, Token, UnOp};

/// Reads one attribute into the declaration; attributes that say nothing about the mechanics are passed over.
pub fn read(model: &mut Declaration, name: &str, attribute: &Attribute) -> Result<()> {
    let expressions = || attribute.parse_args_with(Punctuated::<Expr, Token![,]>::parse_terminated);
    let list = || expressions().map(|e| e.into_iter().collect::<Vec<_>>());
    match name {
        "coordinates" => model.coordinates = names(attribute)?,
        "speeds" => model.speeds = names(attribute)?,
        "inputs" => model.inputs = names(attribute)?,
        "kinematics" => kinematics(model, list()?)?,
        "inertia" => model.inertia = inertia(&attribute.parse_args()?)?,
        "forces" => model.forces = list()?,
        "kinetic_energy" => model.kinetic_energy = Some(attribute.parse_args()?),
        "potential_energy" => model.potential_energy = Some(attribute.parse_args()?),
        "constraint" => model.constraints.push(attribute.parse_args_with(constraint)?),
        "configuration" => model.configuration = Some(configuration(list()?)?),
        "independent" => model.charts.push(list()?.into_iter().map(chosen).collect::<Result<_>>()?),
        "velocities" => model.gives_velocities = true,
        "complement" => {
            for (name, row) in assignments(list()?)? {
                let Expr::Array(row) = row else {
                    return Err(Error::new_spanned(row, "not a row"));
                };
                model.complement.push((name, row.elems.into_iter().collect()));
            }
        }
        "define" => model.definitions.extend(assignments(list()?)?),
        "output" => {
            let outputs = attribute.parse_args_with(Punctuated::<Output, Token![,]>::parse_terminated)?;
            model.outputs.extend(outputs.into_iter().map(|output| (output.0, output.1)));
        }
        "start" => {
            let start = assignments(list()?)?;
            model.start.extend(start.into_iter().map(|(name, value)| (name, number(&value))));
        }
        _ => {}
    }
    Ok(())
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

/// The first argument of a call of that name.
fn argument<'a>(e: &'a Expr, function: &str) -> Option<&'a Expr> {
    let Expr::Call(ExprCall { func, args, .. }) = e else {
        return None;
    };
    if plain(func)? == function { args.first() } else { None }
}

/// A path of one segment.
pub fn plain(e: &Expr) -> Option<String> {
    let Expr::Path(p) = e else { return None };
    p.path.get_ident().map(ToString::to_string)
}

fn names(attribute: &Attribute) -> Result<Vec<String>> {
    struct Documented(Ident);
    impl Parse for Documented {
        fn parse(input: ParseStream<'_>) -> Result<Self> {
            Attribute::parse_outer(input)?;
            input.parse().map(Self)
        }
    }
    let names = attribute.parse_args_with(Punctuated::<Documented, Token![,]>::parse_terminated)?;
    Ok(names.into_iter().map(|n| n.0.to_string()).collect())
}

/// `power = ..` or `mu`, with doc comments before it.
struct Output(String, Expr);

impl Parse for Output {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        Attribute::parse_outer(input)?;
        let name: Ident = input.parse()?;
        match input.parse::<Option<Token![=]>>()? {
            Some(_) => Ok(Self(name.to_string(), input.parse()?)),
            None => Ok(Self(name.to_string(), Expr::parse.parse_str(&name.to_string())?)),
        }
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

fn inertia(e: &Expr) -> Result<Vec<Vec<Option<Expr>>>> {
    let Expr::Call(call) = e else {
        return Err(Error::new_spanned(e, "neither diag nor matrix"));
    };
    let arguments: Vec<Expr> = call.args.iter().cloned().collect();
    let n = arguments.len();
    if plain(&call.func).as_deref() == Some("diag") {
        let row = |i: usize| (0..n).map(|j| (i == j).then(|| arguments[i].clone())).collect();
        return Ok((0..n).map(row).collect());
    }
    let row = |e: &Expr| {
        let Expr::Array(row) = e else {
            return Err(Error::new_spanned(e, "not a row"));
        };
        let entry = |e: &Expr| (!matches!(e, Expr::Infer(_))).then(|| e.clone());
        Ok(row.elems.iter().map(entry).collect())
    };
    arguments.iter().map(row).collect()
}

fn constraint(input: ParseStream<'_>) -> Result<Constraint> {
    let name: Ident = input.parse()?;
    input.parse::<Token![:]>()?;
    let Expr::Binary(equation) = input.parse()? else {
        return Err(input.error("not an equation"));
    };
    if !matches!(equation.op, BinOp::Eq(_)) {
        return Err(Error::new_spanned(equation, "not an equation"));
    }
    let (left, right) = (*equation.left, *equation.right);
    // what follows an equation are words about it
    let words = match input.parse::<Option<Token![,]>>()? {
        Some(_) => Punctuated::<Ident, Token![,]>::parse_terminated(input)?.into_iter().collect(),
        None => Vec::new(),
    };
    let redundant = words.iter().any(|word| word == "redundant");
    Ok(Constraint { name: name.to_string(), left, right, level: Level::Position, redundant })
}

fn configuration(list: Vec<Expr>) -> Result<Configuration> {
    let names = |call: &ExprCall| call.args.iter().filter_map(plain).collect::<Vec<_>>();
    let mut configuration = Configuration::default();
    let mut quasi = Vec::new();
    let mut given = Vec::new();
    for e in list {
        match e {
            Expr::Call(call) if plain(&call.func).as_deref() == Some("speeds") => quasi.extend(names(&call)),
            Expr::Call(call) => configuration.coordinates.extend(names(&call)),
            other => given.push(assignment(other)?),
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
