#[coordinates(a)]
#[frame(A = rotate(N, z, a))]
#[point(P = O + r*A.x)]
#[particle(bob = { at: P, mass: m })]
#[release(pull = { point: Q, along: A.x })]
#[release(turn = { frame: A, about: 2*A.z })]
#[release(half = { point: P })]
#[release(both = { point: P, along: A.x, frame: A, about: A.z })]
#[release(none = { points: P })]
#[output(tension = reaction(pul))]
pub struct Released {
    pub m: f64,
    pub r: f64,
}
