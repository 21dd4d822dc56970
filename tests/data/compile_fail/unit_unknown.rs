#[coordinates(#[unit(meter)] x)]
#[inertia(diag(m))]
#[forces(-k*sin(alpha))]
#[output(#[unit(Nm)] torque = k)]
struct Model {
    #[unit(kilo*s)]
    m: f64,
    #[unit(N*furlong)]
    k: f64,
    #[unit(deg)]
    alpha: f64,
}
