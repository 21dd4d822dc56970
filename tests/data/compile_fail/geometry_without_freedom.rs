#[coordinates(a, b)]
#[frame(A = rotate(N, z, a), B = rotate(A, z, b))]
#[point(P = O + l*A.x, Q = P + l*B.x)]
#[particle(bob = { at: Q, mass: m })]
#[constraint(pinned: Q == O + l*N.x)]
pub struct Truss {
    pub m: f64,
    pub l: f64,
}
