#[coordinates(a)]
#[frame(A = rotate(N, z, a))]
#[body(fine = { frame: A, center: O, mass: m, inertia: matrix([i, 0, -i/4], [_, 2*i, 0], [_, _, 2*i]) })]
#[body(long = { frame: A, center: O, mass: m, inertia: diag(i, i, 3*i) })]
#[body(skew = { frame: A, center: O, mass: m, inertia: matrix([i, 2*i, 0], [_, i, 0], [_, _, i]) })]
#[body(light = { frame: A, center: O, mass: -m, inertia: planar(i) })]
#[body(unknown = { frame: A, center: O, mass: m, inertia: diag(i, i, k) })]
pub struct Inertias {
    #[nominal(2)]
    pub m: f64,
    #[nominal(0.5)]
    pub i: f64,
    pub k: f64,
}
