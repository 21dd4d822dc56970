//! Rows that depend on others only where the constraints hold: found at the start, taken out or told, never taken for a place that
//! happens to be singular.

use holonomy_engine::projection::Equations;
use proc_macro2::TokenStream;
use quote::quote;

fn analysed(tokens: TokenStream) -> Result<Equations, String> {
    let told = |errors: holonomy_engine::syntax::Diagnostics| {
        errors.iter().map(|error| error.message.clone()).collect::<Vec<_>>().join("; ")
    };
    holonomy_engine::analyse(tokens).map(|analysis| analysis.equations).map_err(told)
}

/// A coupler on three bars, the third of `length`, its foot at the middle. `mark` stands behind what holds the third.
fn parallel_bars(length: TokenStream, mark: TokenStream, start: TokenStream) -> TokenStream {
    parallel_bars_and(length, mark, start, quote! {})
}

/// The same with further coordinates.
fn parallel_bars_and(length: TokenStream, mark: TokenStream, start: TokenStream, further: TokenStream) -> TokenStream {
    quote! {
        #[coordinates(a, b, c, d #further)]
        #[frame(A = rotate(N, z, a), B = rotate(N, z, b), C = rotate(N, z, c), D = rotate(N, z, d))]
        #[point(P = O + l*A.x, Q = O + w*N.x + l*B.x, R = O + w/2*N.x + #length*C.x)]
        #[body(
            first = { frame: A, center: O + l/2*A.x, mass: m, inertia: rod(m, l, x) },
            second = { frame: B, center: O + w*N.x + l/2*B.x, mass: m, inertia: rod(m, l, x) },
            third = { frame: C, center: O + w/2*N.x + l/2*C.x, mass: m, inertia: rod(m, l, x) },
            coupler = { frame: D, center: P + w/2*D.x, mass: m, inertia: rod(m, w, x) },
        )]
        #[gravity(-g*N.y)]
        #[constraint(outer: P + w*D.x == Q)]
        #[constraint(inner: P + w/2*D.x == R #mark)]
        #start
        struct Bars { #[nominal(1.2)] l: f64, #[nominal(2.5)] w: f64, #[nominal(0.7)] m: f64, #[nominal(9.81)] g: f64 }
    }
}

#[test]
fn a_third_parallel_bar_holds_nothing_that_is_not_held() {
    let start = quote! { #[start(a = 0.8, b = 0.81, c = 0.79, d = 0.02)] };
    // The choice by pivots at generic points is told to be a bad one here, and what to write instead.
    let message = analysed(parallel_bars(quote! { l }, quote! { , redundant }, start.clone())).expect_err("bad speeds");
    assert!(message.contains("write `#[independent(dot(a))]`"), "{message}");
    let chosen = quote! { #start #[independent(dot(a))] };
    let equations = analysed(parallel_bars(quote! { l }, quote! { , redundant }, chosen)).expect("it moves");
    assert_eq!((equations.state_speeds.len(), equations.multipliers.len()), (1, 4));
    let note = |text: &str| equations.notes.iter().filter(|note| note.contains(text)).count();
    assert_eq!(note("depends on the other rows wherever these hold"), 1, "{:?}", equations.notes);
    // The other row of the third bar is one as any.
    assert_eq!(note("independent of the other rows"), 1, "{:?}", equations.notes);
}

/// With a bob on the coupler that swings in any case: without the mark the row is named, and how to mend it.
#[test]
fn an_unmarked_row_too_many_is_named() {
    let start = quote! {
        #[start(a = 0.8, b = 0.81, c = 0.79, d = 0.02, e = 0.5)]
        #[frame(E = rotate(N, z, e))]
        #[body(bob = { frame: E, center: Q + l*E.x, mass: m, inertia: sphere(m, l/5) })]
    };
    let message =
        analysed(parallel_bars_and(quote! { l }, quote! {}, start, quote! { , e })).expect_err("dependent rows");
    assert!(message.starts_with("constraint `inner_"), "{message}");
    let said = ["depends on the others wherever these hold: at the start its rates", "write `redundant` behind it"];
    assert!(said.iter().all(|said| message.contains(said)), "{message}");
}

/// Without a start the rank is that of a generic point, at which all rows are independent: four of them leave no motion.
#[test]
fn nothing_is_judged_without_a_start() {
    let message = analysed(parallel_bars(quote! { l }, quote! { , redundant }, quote! {})).expect_err("no freedom");
    assert!(message.contains("leave the mechanism no degree of freedom"), "{message}");
}

/// A third bar that is longer closes only where it holds the others: no motion is made of that.
#[test]
fn a_third_bar_of_another_length_is_an_error() {
    let start = quote! { #[start(a = 0.8, b = 0.81, c = 0.79, d = 0.02)] };
    let longer = quote! { (l + w/50) };
    let message = analysed(parallel_bars(longer, quote! { , redundant }, start)).expect_err("no motion");
    assert!(message.contains("no degree of freedom") || message.contains("does not close"), "{message}");
}

/// Two cylinders that touch: their rows depend on each other along the line of contact, and beside it one holds without the other.
#[test]
fn a_singular_start_is_no_redundancy() {
    let message = analysed(quote! {
        #[coordinates(x, y, z)]
        #[inertia(diag(m, m, m))]
        #[forces(0, 0, -m*g)]
        #[constraint(left: (x*x + y*y - 1)/2 == 0)]
        #[constraint(right: (powi(x - 3/2, 2) + y*y - 1/4)/2 == 0, redundant)]
        #[start(x = 1, y = 0, z = 0)]
        struct Touching { #[nominal(2)] m: f64, #[nominal(9.81)] g: f64 }
    })
    .expect_err("singular");
    assert!(
        message.contains("`right` depends on the others at the start") && message.contains("start elsewhere"),
        "{message}"
    );
}

/// Velocity rows of one gradient where a position row holds: they must bind it to one value as well.
#[test]
fn velocity_rows_that_agree_on_the_manifold() {
    let model = |speed: TokenStream| {
        quote! {
            #[coordinates(a, b, c, d)]
            #[inertia(diag(1, 1, 1, 1))]
            #[forces(0, 0, 1, 0)]
            #[constraint(together: b == a + k)]
            #[constraint(first: dot(c) + a*dot(d) == 1)]
            #[constraint(second: 2*dot(c) + 2*(b - k)*dot(d) + dot(b) - dot(a) == #speed, redundant)]
            #[start(a = 0.3, b = 0.6, c = 0, d = 0)]
            struct Belts { #[nominal(0.25)] k: f64 }
        }
    };
    let equations = analysed(model(quote! { 2 })).expect("consistent");
    assert_eq!(equations.state_speeds.len(), 2);
    let message = analysed(model(quote! { 3 })).expect_err("inconsistent");
    assert!(message.contains("`second` depends on the others at the start"), "{message}");
}
