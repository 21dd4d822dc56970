//! Where and how a model may be declared: generic, under a renamed runtime, in functions, by macros, with raw names.
//!
//! It is the same pendulum everywhere, with the same motion.

#[macro_use]
mod surroundings;
mod support;

use holonomy::ConstrainedSystem as _;
use surroundings::{check, expected};

/// Keywords by their raw names, where no equation has them: the struct, and fields that pass through.
mod with_raw_names {
    pendulum! {
        #[derive(holonomy::ConstrainedSystem, Clone)]
        #[allow(non_camel_case_types, reason = "a keyword")]
        pub struct r#struct { m, l, g }
    }

    #[derive(holonomy::ConstrainedSystem, Clone)]
    #[coordinates(x, y)]
    #[inertia(diag(m, m))]
    #[forces(0, -m*g)]
    #[potential_energy(m*g*y)]
    #[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
    #[independent(dot(x))]
    pub struct Named<'r#type> {
        pub m: f64,
        pub r#fn: &'r#type str,
        pub l: f64,
        pub r#match: f64,
        pub g: f64,
    }
}

#[test]
fn with_raw_identifiers() {
    check(with_raw_names::r#struct { m: 1.5, l: 0.5, g: 9.81 });
    let named = with_raw_names::Named { m: 1.5, r#fn: "pendulum", l: 0.5, r#match: 2.0, g: 9.81 };
    assert_eq!((named.r#fn, named.r#match), ("pendulum", 2.0));
    check(named);
}

/// Scalars of a type parameter with a where-clause, a lifetime, a constant, fields that are no scalars.
mod generic {
    /// The scalar's usual name is taken.
    #[derive(holonomy::ConstrainedSystem, Clone, Debug)]
    #[coordinates(x, y)]
    #[inertia(diag(m, m))]
    #[forces(0, -m*g)]
    #[potential_energy(m*g*y)]
    #[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
    #[independent(dot(x))]
    pub struct Pendulum<'a, T, TT: Clone, const N: usize>
    where
        T: Copy,
        f64: From<T>,
        TT: AsRef<[f64]>,
    {
        pub m: T,
        pub l: T,
        pub g: f64,
        /// Not in any equation.
        pub track: &'a TT,
        pub name: &'a str,
        pub table: [f32; N],
        pub heights: Vec<Option<f64>>,
    }
}

#[test]
fn with_generics() {
    let heights = vec![Some(1.0), None];
    let single = generic::Pendulum {
        m: 1.5_f32,
        l: 0.5_f32,
        g: 9.81,
        track: &[1.0, 2.0],
        name: "by the window",
        table: [0.0; 3],
        heights: heights.clone(),
    };
    check(single.clone());
    let prepared = single.prepare().expect("a pendulum");
    let system = prepared.system();
    assert_eq!((system.name, system.track.as_ref()[1], system.table), ("by the window", 2.0, [0.0; 3]));
    assert_eq!(system.heights, heights);
    // the types of the state do not depend on the struct's parameters
    let s = generic::PendulumState { x: 0.3, y: -0.4, dot_x: 0.5 };
    assert!((prepared.velocities(0.0, &s).dot_y - expected()[1]).abs() < 1e-12);
    let weights = vec![0.5];
    check(generic::Pendulum { m: 1.5, l: 0.5, g: 9.81, track: &weights, name: "", table: [], heights });
}

/// The runtime under another name, as where it is re-exported.
mod renamed {
    pub mod facade {
        pub mod deep {
            pub use holonomy as mechanics;
        }
    }
    use facade::deep::mechanics as short;

    /// What a user who never heard of the crate's name has in scope.
    #[allow(dead_code, reason = "it only has to be in scope")]
    mod holonomy {}

    pendulum! {
        #[derive(short::ConstrainedSystem, Clone)]
        #[holonomy(crate = short)]
        pub struct Pendulum { m, l, g }
    }

    pub mod inner {
        pendulum! {
            #[derive(super::facade::deep::mechanics::ConstrainedSystem, Clone)]
            #[holonomy(crate = crate::renamed::facade::deep::mechanics)]
            pub struct Pendulum { m, l, g }
        }
    }

    pub mod relative {
        pendulum! {
            #[derive(super::facade::deep::mechanics::ConstrainedSystem, Clone)]
            #[holonomy(crate = super::facade::deep::mechanics, simplify = off)]
            pub struct Pendulum { m, l, g }
        }
    }
}

#[test]
fn with_a_renamed_runtime() {
    check(renamed::Pendulum { m: 1.5, l: 0.5, g: 9.81 });
    check(renamed::inner::Pendulum { m: 1.5, l: 0.5, g: 9.81 });
    check(renamed::relative::Pendulum { m: 1.5, l: 0.5, g: 9.81 });
}

/// Two models side by side, private and public in part.
mod together {
    pendulum! {
        #[derive(holonomy::ConstrainedSystem, Clone)]
        pub(crate) struct First { m, l, g }
    }
    pendulum! {
        #[derive(holonomy::ConstrainedSystem, Clone)]
        pub(super) struct Second { m, l, g }
    }
    pendulum! {
        #[derive(holonomy::ConstrainedSystem, Clone)]
        struct Third { m, l, g }
    }

    pub fn third() -> impl holonomy::ConstrainedSystem {
        Third { m: 1.5, l: 0.5, g: 9.81 }
    }
}

#[test]
fn two_models_in_one_module() {
    check(together::First { m: 1.5, l: 0.5, g: 9.81 });
    check(together::Second { m: 1.5, l: 0.5, g: 9.81 });
    check(together::third());
}

#[test]
fn a_model_inside_a_function() {
    let (m, l, g) = (1.5, 0.5, 9.81);
    pendulum! {
        #[derive(holonomy::ConstrainedSystem, Clone)]
        struct Pendulum { m, l, g }
    }
    check(Pendulum { m, l, g });
    let nested = || {
        pendulum! {
            #[derive(holonomy::ConstrainedSystem, Clone)]
            struct Pendulum { m, l, g }
        }
        check(Pendulum { m, l, g });
        PendulumState { x: 0.3, y: -0.4, dot_x: 0.5 }.dot_x
    };
    assert_eq!(nested(), 0.5);
}

/// A model whose every part is passed on by a macro: names, types, expressions, literals, lists.
macro_rules! made {
    (
        $name:ident of $scalar:ty, $x:ident $y:ident, mass $mass:expr, half $half:literal,
        row $rod:ident $left:expr => $right:expr, forces [$($force:expr),*], fields $($field:ident)*
    ) => {
        #[derive(holonomy::ConstrainedSystem, Clone)]
        #[coordinates($x, $y)]
        #[define(mass = $mass, weight = mass*g)]
        #[inertia(diag(mass, mass))]
        #[forces($($force),*)]
        #[potential_energy(weight*$y)]
        #[constraint($rod: $half*($left - $right) == 0)]
        #[independent(dot($x))]
        struct $name {
            $($field: $scalar,)*
        }
    };
}

made!(Made of f64, x y, mass m + m, half 0.5, row rod powi(x, 2) + powi(y, 2) => powi(l, 2), forces [0, -weight], fields m l g);

#[test]
fn a_model_made_by_a_macro() {
    check(Made { m: 0.75, l: 0.5, g: 9.81 });
}
