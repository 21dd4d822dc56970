#[coordinates(e0, e1, e2, e3)]
#[frame(B = quaternion(N, e0, e1, e2, e3))]
#[body(rock = { frame: B, center: O, mass: m, inertia: sphere(m, r) })]
#[constraint(length: e0*e0 + e1*e1 + e2*e2 + e3*e3 == 1)]
pub struct Norm {
    pub m: f64,
    pub r: f64,
}
