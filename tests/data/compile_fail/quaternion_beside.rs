#[coordinates(x, e0, e1, e2, e3)]
#[frame(B = quaternion(N, e0, e1, e2, e3))]
#[point(P = O + x*N.x)]
#[body(rock = { frame: B, center: O, mass: m, inertia: sphere(m, r) })]
#[configuration(of(s), x = s)]
#[forces(1, 0, 0, 0, 0)]
pub struct Beside {
    pub m: f64,
    pub r: f64,
}
