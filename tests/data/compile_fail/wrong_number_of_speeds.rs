#[coordinates(x, y, phi)]
#[inertia(diag(m, m, i))]
#[forces(0, 0, 0)]
#[constraint(blade: -dot(x)*sin(phi) + dot(y)*cos(phi) == 0)]
#[independent(dot(phi))]
pub struct Blade {
    pub m: f64,
    pub i: f64,
}
