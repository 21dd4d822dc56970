//! Explicit Runge-Kutta methods as tables.

/// A method with room for S rates k. The last of the `stages` stands at the new state, so that its rate is the first of the
/// next step and its guards are those of the accepted state; further rows serve the dense output.
pub(super) struct Tableau<const S: usize> {
    /// The order of the method.
    pub(super) order: i32,
    /// The stages of a step, the one at the new state included.
    pub(super) stages: usize,
    /// Stage i stands at y + h Σ a[i][j] k_j.
    pub(super) a: [[f64; S]; S],
    /// Stage i stands at t + c[i] h.
    pub(super) c: [f64; S],
    /// How the error of a step is estimated.
    pub(super) error: Estimate<S>,
    /// The higher coefficients of the dense output: h Σ dense[i][j] k_j.
    pub(super) dense: &'static [[f64; S]],
    /// The exponent of the previous error in the step size control (0: no PI control).
    pub(super) beta: f64,
    /// A step changes by a factor between these.
    pub(super) factors: (f64, f64),
}

/// An error estimate as combinations of the rates.
pub(super) enum Estimate<const S: usize> {
    /// Fixed steps only.
    None,
    /// h Σ e_j k_j.
    One([f64; S]),
    /// The fifth-order and the third-order combination of DOP853, which estimate together.
    Two([f64; S], [f64; S]),
}

/// The classical method of order 4; the fifth stage stands at the new state.
pub(super) static RK4: Tableau<5> = Tableau {
    order: 4,
    stages: 5,
    a: [
        [0.0; 5],
        [1.0 / 2.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 1.0 / 2.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0, 0.0],
        [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0, 0.0],
    ],
    c: [0.0, 1.0 / 2.0, 1.0 / 2.0, 1.0, 1.0],
    error: Estimate::None,
    dense: &[],
    beta: 0.0,
    factors: (1.0, 1.0),
};

/// Dormand and Prince 5(4) with the continuous extension of Shampine (Hairer, Nørsett, Wanner, "Solving Ordinary Differential
/// Equations I", 2nd ed., table II.5.2 and section II.6).
pub(super) static DORMAND_PRINCE: Tableau<7> = Tableau {
    order: 5,
    stages: 7,
    a: [
        [0.0; 7],
        [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0, 0.0],
        [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0, 0.0],
        [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0, 0.0],
        [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0, 0.0],
    ],
    c: [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0],
    error: Estimate::One([
        71.0 / 57600.0,
        0.0,
        -71.0 / 16695.0,
        71.0 / 1920.0,
        -17253.0 / 339200.0,
        22.0 / 525.0,
        -1.0 / 40.0,
    ]),
    dense: &[[
        -12715105075.0 / 11282082432.0,
        0.0,
        87487479700.0 / 32700410799.0,
        -10690763975.0 / 1880347072.0,
        701980252875.0 / 199316789632.0,
        -1453857185.0 / 822651844.0,
        69997945.0 / 29380423.0,
    ]],
    beta: 0.04,
    factors: (0.2, 10.0),
};
