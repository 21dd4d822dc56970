#[coordinates(a, b)]
#[frame(A = rotate(N, z, a), B = rotate(M, x, b), C = rotate(N, N.x + N.y, b))]
#[point(P = O + 3, Q = P + A.x*A.y, R = O + 1/A.x, S = O + A.w)]
#[particle(bob = { at: O + A.x, mass: m })]
#[constraint(level: P == 2)]
#[constraint(height: a == dot(A.x, N.y), expressed = A)]
pub struct Mixed {
    pub m: f64,
}
