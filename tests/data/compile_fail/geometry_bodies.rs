#[coordinates(a)]
#[frame(A = rotate(N, z, a))]
#[body(one = { center: O, mass: m, inertia: sphere(m, r) })]
#[body(two = { frame: A, center: O + r*A.x, mass: a, inertia: ring(m, r), weight: 3 })]
#[body(three = { frame: two, center: O, mass: m, inertia: rod(m, r, w) })]
#[torque(drive = { on: motor, value: tau*A.z })]
#[spring(coil = { of: a, from: O, stiffness: m })]
#[inputs(tau)]
pub struct Bodies {
    pub m: f64,
    pub r: f64,
}
