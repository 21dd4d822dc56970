//! The closed form of Chaplygin's sleigh (Neimark and Fufaev, Dynamics of Nonholonomic Systems, chapter II).
//!
//! With b² = (I + m a²)/m and V² = v0² + b² ω0²: v = V tanh(k (t − t0)) and ω = ± (V/b) sech(k (t − t0)), where k = a V/b².

/// One motion.
pub struct Exact {
    mass: f64,
    inertia: f64,
    a: f64,
    b: f64,
    top: f64,
    k: f64,
    t0: f64,
    sign: f64,
}

impl Exact {
    /// From mass, moment of inertia and distance of the mass centre, and the speeds at t = 0.
    pub fn new([mass, inertia, a]: [f64; 3], v: f64, omega: f64) -> Self {
        let b = ((inertia + mass * a * a) / mass).sqrt();
        let top = v.hypot(b * omega);
        let k = a * top / (b * b);
        Exact { mass, inertia, a, b, top, k, t0: -(v / top).atanh() / k, sign: omega.signum() }
    }

    pub fn forward(&self, t: f64) -> f64 {
        self.top * (self.k * (t - self.t0)).tanh()
    }

    pub fn turning(&self, t: f64) -> f64 {
        self.sign * self.top / self.b / (self.k * (t - self.t0)).cosh()
    }

    /// The angle turned since t = 0: the integral of sech is Gudermann's function.
    pub fn turned(&self, t: f64) -> f64 {
        let gudermann = |x: f64| 2.0 * (x / 2.0).tanh().atan();
        self.sign * self.b / self.a * (gudermann(self.k * (t - self.t0)) - gudermann(-self.k * self.t0))
    }

    /// m v ω I / (I + m a²), along the left normal of the body.
    pub fn force(&self, t: f64) -> f64 {
        let about = self.inertia + self.mass * self.a * self.a;
        self.mass * self.forward(t) * self.turning(t) * self.inertia / about
    }
}
