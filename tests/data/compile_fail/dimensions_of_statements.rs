#[coordinates(x, q)]
#[speeds(v, w)]
#[kinematics(v = l*dot(x), w = l*dot(q))]
#[inertia(diag(m, m*l*l))]
#[forces(m, m*powi(v, 2))]
#[potential_energy(m*l)]
#[define(still = cos(q))]
#[constraint(rail: l == x)]
#[constraint(turn: w == v)]
#[independent(s = v + w)]
#[output(pull = reaction(turn) + m*v)]
struct Model {
    #[unit(kg)]
    m: f64,
    #[unit(m)]
    l: f64,
}
