//! The same pendulum for every surrounding, and its motion by hand.

use holonomy::ConstrainedSystem as Model;

/// The pendulum, by ẋ at x = 0.3, y = −0.4, ẋ = 0.5, with m = 1.5, l = 0.5, g = 9.81: (ẋ, ẏ, ẍ), λ and the energy.
///
/// ẏ = −x ẋ/y; with C = [x, y], M = m, h* = (0, −m g): λ = −m (ẋ² + ẏ² − g y)/l², ẍ = λ x/m.
pub fn expected() -> [f64; 5] {
    let (x, y, dot_x, m, l, g): (f64, f64, f64, f64, f64, f64) = (0.3, -0.4, 0.5, 1.5, 0.5, 9.81);
    let dot_y = -x * dot_x / y;
    let squared = dot_x * dot_x + dot_y * dot_y;
    let lambda = -m * (squared - g * y) / (l * l);
    [dot_x, dot_y, lambda * x / m, lambda, 0.5 * m * squared + m * g * y]
}

/// What a pendulum in any surroundings says at that state.
pub fn check<M: Model>(model: M) {
    let model = model.prepare().expect("the parameters are good");
    let s = <M::State<f64> as holonomy::Vector<f64>>::from_fn(|i| [0.3, -0.4, 0.5][i]);
    let none = <M::Inputs<f64> as holonomy::Vector<f64>>::from_fn(|_| 0.0);
    let (rate, _) = model.derivative(0.0, &s, &none);
    let mut said = crate::support::running::entries(&rate);
    said.extend(crate::support::running::entries(&model.multipliers(0.0, &s, &none)));
    said.push(model.energy(0.0, &s));
    for (said, expected) in said.iter().zip(expected()) {
        assert!((said - expected).abs() < 1e-12, "{}: {said} instead of {expected}", M::MODEL.name);
    }
}

/// Writes a pendulum with the given head, so that each module shows only what is peculiar to it.
macro_rules! pendulum {
    ($(#[$attribute:meta])* $vis:vis struct $name:ident { $m:ident, $l:ident, $g:ident }) => {
        $(#[$attribute])*
        #[coordinates(x, y)]
        #[inertia(diag($m, $m))]
        #[forces(0, -$m*$g)]
        #[potential_energy($m*$g*y)]
        #[constraint(rod: (powi(x, 2) + powi(y, 2) - powi($l, 2))/2 == 0)]
        #[independent(dot(x))]
        #[output(pull = -$l*reaction(rod), rise = ddot(y), $m = 2*$m)]
        $vis struct $name {
            $vis $m: f64,
            $vis $l: f64,
            $vis $g: f64,
        }
    };
}
