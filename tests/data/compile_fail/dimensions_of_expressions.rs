#[coordinates(#[unit(m)] x, q)]
#[inputs(#[unit(N)] push)]
#[define(wrong = l + m, stretch = x - l)]
#[inertia(diag(m, m*l*l))]
#[forces(
    push - k*x + m*sin(l) + m*powf(l, q)*g,
    max(push, m)*l + if x < m { push*l } else { 0 } + atan2(x, m)*m*g*l,
)]
#[constraint(rail: x == l*q + tan(k))]
struct Model {
    #[unit(kg)]
    m: f64,
    #[unit(m)]
    l: f64,
    #[unit(N/m)]
    k: f64,
    #[unit(m/s/s)]
    g: f64,
}
