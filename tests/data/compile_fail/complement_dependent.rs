#[coordinates(x, y, phi)]
#[inertia(diag(m, m, i))]
#[forces(0, 0, 0)]
#[constraint(blade: -dot(x)*sin(phi) + dot(y)*cos(phi) == 0)]
#[complement(along = [cos(phi), sin(phi), 0], too = [2*cos(phi), 2*sin(phi), 0])]
pub struct Blade {
    pub m: f64,
    pub i: f64,
}
