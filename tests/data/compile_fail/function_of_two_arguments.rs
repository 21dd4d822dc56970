#[coordinates(x, y)]
#[function(height(x, y))]
#[inertia(diag(m, m))]
#[forces(0, -m*height(x))]
pub struct Hill {
    pub m: f64,
}
