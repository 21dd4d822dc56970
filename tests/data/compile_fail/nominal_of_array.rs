#[coordinates(x, y)]
#[inertia(diag(m[0], m[1]))]
#[forces(0, -m[1]*g)]
pub struct Array {
    #[nominal(1, 2, 3)]
    pub m: [f64; 2],
    #[nominal(9.81, 10)]
    pub g: f64,
}
