#[coordinates(x)]
#[inertia(diag(m))]
#[forces(-label)]
pub struct Labelled {
    pub m: f64,
    pub label: String,
}
