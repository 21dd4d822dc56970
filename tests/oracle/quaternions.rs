//! Frames by quaternions: what they add to a declaration, said in the words of a model.
//!
//! The speeds of such a frame are components of its angular velocity against its base in its own axes, and the rate of the norm.
//! Both are written down as functions of the rates of the coordinates (2.2), and the axes are the base's, turned by e v ē with
//! Hamilton's product: no formula for the rates of e and no matrix stand anywhere here.

use super::declaration::{Constraint, Declaration, Level};
use super::number::Number;
use super::statements::plain;
use super::vectors::{Vector, inner};
use syn::{Expr, parse_quote};

/// `B = quaternion(base, e0, e1, e2, e3)`
struct Quaternion {
    frame: String,
    base: Expr,
    components: Vec<String>,
}

fn quaternions(model: &Declaration) -> Vec<Quaternion> {
    let of = |(frame, value): (&String, &Expr)| {
        let Expr::Call(call) = value else { return None };
        let arguments: Vec<&Expr> = call.args.iter().collect();
        let [base, components @ ..] = arguments.as_slice() else { return None };
        let components = components.iter().map(|e| plain(e)).collect::<Option<Vec<String>>>();
        (plain(&call.func)? == "quaternion").then(|| Quaternion {
            frame: frame.clone(),
            base: (*base).clone(),
            components: components.expect("four names"),
        })
    };
    let mut found: Vec<Quaternion> = model.geometry.frames.iter().filter_map(of).collect();
    found.sort_by_key(|q| model.coordinates.iter().position(|x| *x == q.components[0]));
    found
}

/// Adds the speeds, what they are, and the rows that hold the norms.
pub(super) fn complete(model: &mut Declaration) {
    let all = quaternions(model);
    if all.is_empty() {
        return;
    }
    let name = |text: &str| syn::Ident::new(text, proc_macro2::Span::call_site());
    let sum = |q: &Quaternion, of: &dyn Fn(&syn::Ident) -> Expr| -> Expr {
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| of(&name(&q.components[i])));
        parse_quote!(#a + #b + #c + #d)
    };
    let norm_rate = |q: &Quaternion| -> (String, Expr) {
        let (product, square) = (sum(q, &|e| parse_quote!(#e*dot(#e))), sum(q, &|e| parse_quote!(#e*#e)));
        (format!("norm_rate_{}", q.frame), parse_quote!((#product)/(#square)))
    };
    let mut speeds: Vec<(String, Expr)> = Vec::new();
    if model.speeds.is_empty() {
        for x in &model.coordinates {
            let Some(q) = all.iter().find(|q| q.components.contains(x)) else {
                let coordinate = name(x);
                speeds.push((format!("dot_{x}"), parse_quote!(dot(#coordinate))));
                continue;
            };
            if q.components[0] != *x {
                continue;
            }
            let (frame, base) = (name(&q.frame), &q.base);
            for axis in ["x", "y", "z"] {
                let along = name(axis);
                let value = parse_quote!(dot(angular_velocity(#frame) - angular_velocity(#base), #frame.#along));
                speeds.push((format!("omega_{}_{axis}", q.frame), value));
            }
            speeds.push(norm_rate(q));
        }
    } else {
        let given = model.speeds_by_rates.take().expect("speeds beside quaternions are given by rates");
        speeds.extend(model.speeds.iter().cloned().zip(given));
        speeds.extend(all.iter().map(norm_rate));
    }
    (model.speeds, model.speeds_by_rates) = {
        let (names, values) = speeds.into_iter().unzip();
        (names, Some(values))
    };
    for q in &all {
        let square = sum(q, &|e| parse_quote!(#e*#e));
        model.constraints.push(Constraint {
            name: format!("norm_{}", q.frame),
            left: parse_quote!((#square)/2),
            right: parse_quote!(1 / 2),
            level: Level::Position,
            redundant: false,
            expressed: parse_quote!(N),
            in_short: false,
        });
    }
}

/// e v ē/|e|², e by its scalar and vector parts.
pub(super) fn turned<N: Number>(e: [N; 4], v: &Vector<N>) -> Vector<N> {
    let conjugate = [e[0], -e[1], -e[2], -e[3]];
    let [_, x, y, z] = hamilton(hamilton(e, [N::zero(), v[0], v[1], v[2]]), conjugate);
    let square = e[0] * e[0] + inner(&[e[1], e[2], e[3]], &[e[1], e[2], e[3]]);
    [x / square, y / square, z / square]
}

/// i² = j² = k² = i j k = −1
fn hamilton<N: Number>(a: [N; 4], b: [N; 4]) -> [N; 4] {
    [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]
}
