#[coordinates(x, y)]
#[inertia(matrix([m, 0], [_]))]
#[forces(0, 0)]
#[complement(along = [1, 0, 0])]
pub struct Lengths {
    pub m: f64,
}
