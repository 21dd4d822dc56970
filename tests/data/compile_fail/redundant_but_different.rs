#[coordinates(x, y)]
#[inertia(diag(m, m))]
#[forces(0, 0)]
#[constraint(rail: dot(y) == dot(x))]
#[constraint(other: dot(y) == dot(x) + sin(t), redundant)]
pub struct Rails {
    pub m: f64,
}
