#[coordinates(e0, e1, e2, e3)]
#[frame(B = quaternion(N, e0, e1, e2, e3))]
#[body(rock = { frame: B, center: O, mass: m, inertia: sphere(m, r) })]
#[constraint(still: omega_B_z == 0)]
#[independent(dot(e1), norm_rate_B)]
pub struct Rates {
    pub m: f64,
    pub r: f64,
}
