#[coordinates(a, e0, e1, e2, e3, f0, f1, f2, f3)]
#[frame(B = quaternion(N, e0, e1, e2, e3))]
#[frame(C = quaternion(B, 2*f0, -f1, dot(f2), f3))]
#[frame(D = quaternion(N, f0, f0, f2, f3))]
#[frame(E = quaternion(N, e0, f1, f2, e3))]
#[frame(F = quaternion(N, m, f1, f2, g9))]
#[frame(G = quaternion(N, f0, f1, f2))]
#[frame(H = rotate(quaternion(N, f0, f1, f2, f3), x, a))]
#[frame(I = quaternion(M, f0, f1, f2, f3))]
#[frame(J = quaternion(a, f0, f1, f2, f3))]
#[body(rock = { frame: B, center: O, mass: m, inertia: sphere(m, r) })]
pub struct Components {
    pub m: f64,
    pub r: f64,
}
