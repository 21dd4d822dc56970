#[coordinates(x)]
#[inertia(diag(m))]
#[forces(if x < 0 { -x })]
pub struct Slack {
    pub m: f64,
}
