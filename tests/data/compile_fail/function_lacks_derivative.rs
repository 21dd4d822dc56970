#[coordinates(x, y)]
#[function(road(x), derivatives = [slope])]
#[inertia(diag(m, m))]
#[forces(0, -m)]
#[constraint(ground: y == road(x))]
#[independent(dot(x))]
pub struct Particle {
    pub m: f64,
}
