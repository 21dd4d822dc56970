#[coordinates(a)]
#[frame(A = rotate(N, z, a))]
#[point(P = O + l*A.x, Q = P + l*A.x)]
#[particle(bob = { at: Q, mass: m })]
#[release(pull = { point: P, along: N.x }, pull = { point: Q, along: N.x }, hold = { point: P, along: N.y })]
#[constraint(hold: velocity(P) == N.x*0)]
#[output(f = reaction(pull))]
pub struct Twice {
    pub m: f64,
    pub l: f64,
}
