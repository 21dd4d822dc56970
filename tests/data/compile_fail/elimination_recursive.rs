#[coordinates(a, b)]
#[frame(A = rotate(N, z, a), B = rotate(N, z, b))]
#[particle(bob = { at: O + l*A.x + l*B.x, mass: m })]
#[constraint(pace: powi(dot(a), 2) + powi(dot(b), 2) == 1)]
#[holonomy(elimination = recursive)]
pub struct Tied {
    pub m: f64,
    pub l: f64,
}
