#[coordinates(a, b)]
#[inertia(matrix([m, m], [_, m]))]
#[forces(0, 0)]
pub struct Singular {
    pub m: f64,
}
