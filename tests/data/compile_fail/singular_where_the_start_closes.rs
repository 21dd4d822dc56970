#[coordinates(a, b, c, d)]
#[inertia(diag(m, m, m, m))]
#[forces(0, 0, 0, 0)]
#[constraint(together: b == a)]
#[constraint(slide: sin(b - a)*dot(c) + dot(d) == 0)]
#[start(a = 0.3, b = 0.31)]
#[independent(dot(a), dot(d))]
pub struct Folded {
    pub m: f64,
}
