//! Joints in short, written out in the words that the rest of the reader knows.

use super::statements::plain;
use proc_macro2::Span;
use syn::visit_mut::{self, VisitMut};
use syn::{Expr, ExprCall, Ident, parse_quote};

/// The value of a frame with its joints as rotations: `revolute`, `universal`, `spherical` and `weld`.
pub(super) fn frame(e: Expr) -> Expr {
    let Expr::Call(call) = &e else { return e };
    let name = plain(&call.func).unwrap_or_default();
    let arguments: Vec<Expr> = call.args.iter().cloned().collect();
    let Some(base) = arguments.first().cloned().map(frame) else { return e };
    let rest = &arguments[1..];
    match (name.as_str(), rest) {
        ("rotate" | "revolute", [axis, angle]) => parse_quote!(rotate(#base, #axis, #angle)),
        ("universal", [first, a, second, b]) => parse_quote!(rotate(rotate(#base, #first, #a), #second, #b)),
        ("quaternion" | "spherical", [e0, e1, e2, e3]) => parse_quote!(quaternion(#base, #e0, #e1, #e2, #e3)),
        ("weld", []) => parse_quote!(rotate(#base, z, 0)),
        _ => e,
    }
}

/// The value of a point with `prismatic(P, direction, s)` as the sum that it is.
pub(super) fn point(mut e: Expr) -> Expr {
    struct Slides;
    impl VisitMut for Slides {
        fn visit_expr_mut(&mut self, e: &mut Expr) {
            visit_mut::visit_expr_mut(self, e);
            if let Expr::Call(call) = &e
                && plain(&call.func).as_deref() == Some("prismatic")
                && let [from, along, s] = call.args.iter().cloned().collect::<Vec<Expr>>().as_slice()
            {
                *e = parse_quote!(((#from) + (#s)*(#along)));
            }
        }
    }
    Slides.visit_expr_mut(&mut e);
    e
}

/// The equations of a joint that closes a loop: what their names have behind that of the joint, and both sides. `None` for a call that
/// is no joint.
pub(super) fn equations(call: &ExprCall) -> Option<Vec<(String, Expr, Expr)>> {
    let name = plain(&call.func)?;
    let arguments: Vec<Expr> = call.args.iter().cloned().collect();
    let meet = |p: &Expr, q: &Expr| (String::new(), p.clone(), q.clone());
    let right = |suffix: &str, a: Expr, b: Expr| (suffix.to_owned(), parse_quote!(dot(#a, #b)), parse_quote!(0));
    let axis = |frame: &Expr, axis: &str| -> Expr {
        let axis = Ident::new(axis, Span::call_site());
        parse_quote!(#frame.#axis)
    };
    let welded = |a: &Expr, b: &Expr| {
        [("x", "y"), ("y", "z"), ("z", "x")].map(|(i, j)| right(&format!("_axes_{i}{j}"), axis(a, i), axis(b, j)))
    };
    Some(match (name.as_str(), arguments.as_slice()) {
        ("spherical", [p, q]) => vec![meet(p, q)],
        ("revolute", [p, q, first, second]) => {
            let (frame, own, other) = match (of_frame(first), of_frame(second)) {
                (Some((frame, own)), _) => (frame, own, second),
                (None, Some((frame, own))) => (frame, own, first),
                (None, None) => return None,
            };
            let beside = ["x", "y", "z"].into_iter().filter(|axis| *axis != own);
            let parallel = beside.map(|i| right(&format!("_axes_{i}"), axis(&frame, i), other.clone()));
            std::iter::once(meet(p, q)).chain(parallel).collect()
        }
        ("universal", [p, q, first, second]) => vec![meet(p, q), right("_axes", first.clone(), second.clone())],
        ("weld", [p, q, a, b]) => std::iter::once(meet(p, q)).chain(welded(a, b)).collect(),
        ("prismatic", [p, q, along, b]) => {
            let (frame, own) = of_frame(along)?;
            let beside = ["x", "y", "z"].into_iter().filter(|axis| *axis != own);
            let slides = beside.map(|i| right(&format!("_{i}"), parse_quote!(#p - #q), axis(&frame, i)));
            slides.chain(welded(&frame, b)).collect()
        }
        ("rolling", [p, wheel]) => vec![(String::new(), parse_quote!(velocity(#p, #wheel)), parse_quote!(0))],
        ("rolling", [p, wheel, ground]) => {
            vec![(String::new(), parse_quote!(velocity(#p, #wheel)), parse_quote!(velocity(#p, #ground)))]
        }
        _ => return None,
    })
}

/// `A.z` as its frame and its axis.
fn of_frame(e: &Expr) -> Option<(Expr, String)> {
    let Expr::Field(field) = e else { return None };
    let syn::Member::Named(axis) = &field.member else { return None };
    Some(((*field.base).clone(), axis.to_string()))
}
