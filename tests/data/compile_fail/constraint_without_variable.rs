#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(closed: l == 2*m)]
pub struct Constant {
    pub m: f64,
    pub l: f64,
}
