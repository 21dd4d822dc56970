#[coordinates(e0, e1, e2, e3)]
#[frame(B = quaternion(N, e0, e1, e2, e3))]
#[body(rock = { frame: B, center: O, mass: m, inertia: sphere(m, r) })]
#[constraint(still: omega_B_z == 0)]
#[independent(omega_B_x)]
pub struct Number {
    pub m: f64,
    pub r: f64,
}
