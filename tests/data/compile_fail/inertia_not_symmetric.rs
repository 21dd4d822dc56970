#[coordinates(a, b)]
#[inertia(matrix([m, m*cos(a - b)], [m*cos(a + b), m]))]
#[forces(0, 0)]
pub struct Skew {
    pub m: f64,
}
