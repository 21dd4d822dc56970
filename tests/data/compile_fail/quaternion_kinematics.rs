#[coordinates(x, e0, e1, e2, e3)]
#[speeds(u1, u2, u3, u4, u5)]
#[frame(B = quaternion(N, e0, e1, e2, e3))]
#[body(rock = { frame: B, center: O, mass: m, inertia: sphere(m, r) })]
#[particle(bead = { at: O + x*N.x, mass: m })]
#[kinematics(dot(x) = u1, dot(e0) = u2, dot(e1) = u3, dot(e2) = u4, dot(e3) = u5)]
pub struct Kinematics {
    pub m: f64,
    pub r: f64,
}
