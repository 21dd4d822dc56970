#[size(n = 3)]
#[coordinates(#[unit(m)] x[n])]
#[inertia(diag(m for i in 0..n))]
#[forces(m*x[i] for i in 0..n)]
#[constraint(tie[i]: x[i] - x[i + 1] == m for i in 0..n - 1)]
struct Model {
    #[unit(kg)]
    m: f64,
}
