#[coordinates(e0, e1, e2, e3)]
#[frame(B = quaternion(N, e0, e1, e2, e3))]
#[body(rock = { frame: B, center: O, mass: m, inertia: sphere(m, r) })]
#[constraint(norm_B: omega_B_x == 0)]
#[output(pull = reaction(norm_B))]
pub struct Names {
    pub m: f64,
    pub r: f64,
    pub omega_B_y: f64,
}
