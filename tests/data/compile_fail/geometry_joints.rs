#[coordinates(a, b, s, e0, e1, e2, e3)]
#[frame(A = revolute(N, z), B = universal(N, x, a, y), C = weld(N, x), D = spherical(N, e0, e1, e2))]
#[frame(E = universal(N, x, a, N.x + N.y, b), F = rotate(N, z, a), G = weld(a))]
#[point(P = prismatic(O, N.x + N.y, s), Q = prismatic(O, s), R = O + prismatic(O, N.x, s), S = prismatic(O, s, N.x))]
#[body(bar = { frame: F, center: O + F.x, mass: m, inertia: sphere(m, r) })]
#[constraint(one: revolute(O, O + F.x, F.z))]
#[constraint(two: revolute(O, O + F.x, unit(N.x + N.z), unit(F.x + F.z)))]
#[constraint(three: prismatic(O, O + F.x, unit(N.x + N.z), F))]
#[constraint(four: prismatic(O, O + F.x, F.x, F.y))]
#[constraint(five: weld(O, O + F.x, N, a))]
#[constraint(six: rolling(O + F.x, wheel))]
#[constraint(seven: spherical(O, O))]
#[constraint(eight: spherical(O, O + F.x) == 0)]
#[constraint(nine: spherical(O, s))]
#[constraint(eleven: prismatic(O, O + F.x, F.x, N), expressed = F)]
#[constraint(twelve: revolute(O, F.x, N.z, N.x))]
pub struct Joints {
    pub m: f64,
    pub r: f64,
}
