#[coordinates(q, s)]
#[frame(A = rotate(N, z, l))]
#[frame(B = rotate(N, z, q))]
#[point(P = O + m*B.x)]
#[point(Q = prismatic(O, B.x, s))]
#[body(bar = { frame: B, center: Q, mass: l, inertia: rod(m, m, x) })]
#[body(plate = { frame: A, center: O, mass: m, inertia: diag(m, m, m) })]
#[gravity(-l*N.y)]
#[force(push = { at: Q, value: m*N.x })]
#[torque(drive = { on: B, value: m*g*N.z })]
#[spring(hold = { of: q, stiffness: m*g })]
#[damper(slow = { from: O, to: Q, coefficient: m })]
#[armature(rotor = { of: q, inertia: m })]
#[generalized_force(q = m*g, s = m*g)]
#[constraint(closure: velocity(Q) == l*B.y)]
#[output(turn = dot(angular_momentum(bar, O), N.z) + m*g)]
struct Model {
    #[unit(kg)]
    m: f64,
    #[unit(m)]
    l: f64,
    #[unit(m/s/s)]
    g: f64,
}
