#[coordinates(a, b)]
#[frame(A = rotate(N, z, a), B = rotate(N, z, b))]
#[particle(bob = { at: O + l*A.x + l*B.x, mass: m })]
#[constraint(level: dot(l*A.x + l*B.x, N.y) == 0)]
#[holonomy(elimination = recursive)]
pub struct Tied {
    pub m: f64,
    pub l: f64,
}
