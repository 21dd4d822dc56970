#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, 0)]
#[constraint(floor: z == 0)]
#[constraint(floor: y == 0)]
pub struct Twice {
    pub m: f64,
}
