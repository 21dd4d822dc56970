//! The emitted code among other names: what it names is what it means, whatever else has that name.
//!
//! Each module declares the same pendulum in other surroundings; all have the same motion.

#[macro_use]
mod surroundings;
mod support;

use surroundings::{check, expected};

/// Without a prelude there is no `Option`, no `Clone`, no `From` and no `Ok` by their short names.
#[no_implicit_prelude]
mod without_prelude {
    #[derive(::holonomy::ConstrainedSystem, ::core::clone::Clone)]
    #[coordinates(x, y)]
    #[inertia(diag(m, m))]
    #[forces(0, -m*g)]
    #[potential_energy(m*g*y)]
    #[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
    #[independent(dot(x))]
    #[output(pull = -l*reaction(rod), T = ddot(y), x = x*dot(x))]
    pub struct Pendulum {
        pub m: f64,
        pub l: f64,
        pub g: f64,
    }
}

#[test]
fn without_a_prelude() {
    check(without_prelude::Pendulum { m: 1.5, l: 0.5, g: 9.81 });
}

/// All that the prelude and the runtime name is something else here.
#[deny(warnings)]
mod among_namesakes {
    #![allow(dead_code, unused_macros, reason = "they only have to be in scope")]

    pub struct Option;
    pub struct Result;
    pub struct Vec;
    pub struct Default;
    pub struct Clone;
    pub struct From;
    pub struct Some;
    pub struct None;
    pub struct Ok;
    pub struct Err;
    pub struct T;
    pub struct Self_;
    pub struct Scalar;
    pub struct Vector;
    pub struct Matrix;
    pub struct Dual;
    pub struct Description;
    pub struct GuardKind;
    pub struct Level;
    pub struct ConstrainedSystem;
    pub mod core {}
    pub mod holonomy {}
    pub mod std {}
    pub mod nalgebra {}

    macro_rules! unreachable {
        () => {
            compile_error!("not this one")
        };
    }

    pendulum! {
        #[derive(::holonomy::ConstrainedSystem, ::core::clone::Clone)]
        pub struct Pendulum { m, l, g }
    }
}

#[test]
fn among_namesakes_of_everything() {
    check(among_namesakes::Pendulum { m: 1.5, l: 0.5, g: 9.81 });
}

/// The struct itself has a name that the emitted code uses.
mod with_a_name_of_ours {
    pub mod t {
        pendulum! {
            #[derive(::holonomy::ConstrainedSystem, Clone)]
            pub struct T { m, l, g }
        }
    }
    pub mod vector {
        pendulum! {
            #[derive(::holonomy::ConstrainedSystem, Clone)]
            pub struct Vector { m, l, g }
        }
    }
    pub mod option {
        pendulum! {
            #[derive(::holonomy::ConstrainedSystem, ::core::clone::Clone)]
            pub struct Option { m, l, g }
        }
    }
    pub mod scalar {
        pendulum! {
            #[derive(::holonomy::ConstrainedSystem, Clone)]
            pub struct Scalar { m, l, g }
        }
    }
}

#[test]
fn with_names_of_ours() {
    check(with_a_name_of_ours::t::T { m: 1.5, l: 0.5, g: 9.81 });
    check(with_a_name_of_ours::vector::Vector { m: 1.5, l: 0.5, g: 9.81 });
    check(with_a_name_of_ours::option::Option { m: 1.5, l: 0.5, g: 9.81 });
    check(with_a_name_of_ours::scalar::Scalar { m: 1.5, l: 0.5, g: 9.81 });
}

/// A constant cannot be shadowed: a pattern of its name compares with it. Parameters, inputs and coordinates keep their capitals
/// as fields only.
mod among_constants {
    #![allow(non_snake_case, dead_code, reason = "names as in the equations of mechanics")]

    pub const J: f64 = 1.0;
    pub const M: f64 = 1.0;
    pub const L: f64 = 1.0;
    pub const X: f64 = 1.0;
    pub const T: f64 = 1.0;
    pub const A1: f64 = 1.0;
    pub const ROD: f64 = 1.0;
    pub static Y: f64 = 1.0;
    pub struct F;

    #[derive(holonomy::ConstrainedSystem, Clone)]
    #[coordinates(X, Y)]
    #[inputs(F)]
    #[inertia(diag(M, M))]
    #[forces(F, -M*J)]
    #[potential_energy(M*J*Y)]
    #[constraint(ROD: (powi(X, 2) + powi(Y, 2) - powi(L, 2))/2 == 0)]
    #[independent(dot(X))]
    #[output(J = J*Y, A1 = -reaction(ROD), lambda = ddot(X), dw = F/M)]
    pub struct Pendulum {
        pub M: f64,
        pub L: f64,
        /// Gravity, by a name that constants have.
        pub J: f64,
    }
}

#[test]
fn among_constants_of_the_same_names() {
    check(among_constants::Pendulum { M: 1.5, L: 0.5, J: 9.81 });
}

/// Functions, methods and macros of the names that emitted code uses.
mod among_functions {
    #![allow(dead_code, unused_macros, reason = "they only have to be in scope")]

    pub fn x() {}
    pub fn a1() {}
    pub fn t() {}
    pub fn derivative() {}

    macro_rules! array {
        () => {
            compile_error!("not this one")
        };
    }

    /// Methods of the names of the scalar's, for every type.
    pub trait Everything: Sized {
        fn sin_cos(self) -> bool {
            true
        }
        fn sqrt(self) -> bool {
            true
        }
        fn from_f64(_: f64) -> bool {
            true
        }
        fn from(_: f64) -> bool {
            true
        }
    }
    impl<T> Everything for T {}

    #[derive(holonomy::ConstrainedSystem, Clone)]
    #[coordinates(x, y)]
    #[inertia(diag(m, m))]
    #[forces(0, -m*g)]
    #[potential_energy(m*g*y + 2*(sin(x) - sin(x)*sqrt(1 + x*x - powi(x, 2))))]
    #[constraint(rod: sqrt(powi(x, 2) + powi(y, 2)) == l)]
    #[independent(dot(x))]
    pub struct Pendulum {
        pub m: f64,
        pub l: f64,
        pub g: f64,
    }
}

#[test]
fn among_functions_of_the_same_names() {
    let model = holonomy::ConstrainedSystem::prepare(among_functions::Pendulum { m: 1.5, l: 0.5, g: 9.81 });
    let s = among_functions::PendulumState { x: 0.3, y: -0.4, dot_x: 0.5 };
    let model = model.expect("a pendulum");
    // this rod is as long as its multiplier is a force
    assert!((model.multipliers(0.0, &s, &[]).rod - 0.5 * expected()[3]).abs() < 1e-12);
    assert!((model.energy(0.0, &s) - expected()[4]).abs() < 1e-12);
}
