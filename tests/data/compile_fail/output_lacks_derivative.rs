#[coordinates(x)]
#[speeds(v)]
#[function(gear(x))]
#[kinematics(dot(x) = gear(x)*v)]
#[inertia(diag(m))]
#[forces(0)]
#[output(ratio = gear(x), jolt = ddot(x))]
pub struct Lacks {
    pub m: f64,
}
