#[coordinates(theta)]
#[inertia(diag(m*powi(length, 2)))]
#[forces(-m*g*length*sin(thta))]
pub struct Pendulum {
    pub m: f64,
    pub length: f64,
    pub g: f64,
}
