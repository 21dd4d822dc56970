#[coordinates(a)]
#[frame(A = rotate(N, z, a))]
#[point(P = O + l*A.x)]
#[body(bar = { frame: A, center: P, mass: m, inertia: rod(m, l, x) })]
#[output(p = norm(momentum(A)), q = norm(momentum(bra)), r = norm(angular_momentum(bar)), s = norm(angular_momentum(bar, m)))]
#[output(w = norm(momentum(A.x)))]
#[point(Q = O + momentum(bar))]
pub struct Pendulum {
    pub m: f64,
    pub l: f64,
}
