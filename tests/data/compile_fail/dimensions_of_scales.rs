#[coordinates(#[unit(mm)] x)]
#[inertia(diag(m))]
#[forces(-k*(x - l))]
struct Model {
    #[unit(kg)]
    m: f64,
    #[unit(m)]
    l: f64,
    #[unit(N/m)]
    k: f64,
}
