#[coordinates(a, b, c, d)]
#[inertia(diag(m, m, m, m))]
#[forces(0, 0, 0, 0)]
#[constraint(together: b == a + k)]
#[constraint(first: dot(c) + a*dot(d) == 0)]
#[constraint(second: 2*dot(c) + 2*(b - k)*dot(d) + dot(b) - dot(a) == 0)]
#[start(a = 0.3, b = 0.6)]
pub struct Folded {
    pub m: f64,
    #[nominal(0.25)]
    pub k: f64,
}
