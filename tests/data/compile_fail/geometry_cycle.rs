#[coordinates(a, b)]
#[frame(A = rotate(B, z, a), B = rotate(A, x, b))]
#[point(P = Q + A.x, Q = P + B.y)]
#[particle(bob = { at: P, mass: m })]
pub struct Round {
    pub m: f64,
}
