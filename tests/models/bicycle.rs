//! Whipple's bicycle: two frames and two wheels that roll on a plane without slipping, with all their angles.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// The bicycle by its rear contact (x, y), yaw psi, roll phi, the pitch theta of the steering axis, steer delta and the wheels' turns.
///
/// Axes: x ahead, y to the right, z down. The rear wheel's axes follow from the ground's by yaw and roll; the rear frame's by the
/// pitch theta about y, such that its z axis is the steering axis; the front frame's by delta about that. `e` and `h` are the frames'
/// angular velocities in their own axes, `a`, `c`, `s` and `f` the velocities of the rear wheel's centre (in the wheel's and in the
/// frame's axes), of the steering axis abreast of the front wheel's centre and of that centre, `k` is the direction down in the front
/// frame. The steering axis lies d1 ahead of the rear centre, d2 along it lies the front centre, d3 ahead of it; mass centres lie (l1,
/// l2) from the rear centre in the rear frame and (l3, l4) from the front centre in the front frame.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, psi, phi, theta, delta, rear, front)]
#[speeds(ahead, aside, turning, rolling, pitching, steering, spin_r, spin_f)]
#[kinematics(
    ahead = dot(x)*cos(psi) + dot(y)*sin(psi),
    aside = -dot(x)*sin(psi) + dot(y)*cos(psi),
    turning = dot(psi),
    rolling = dot(phi),
    pitching = dot(theta),
    steering = dot(delta),
    spin_r = dot(rear),
    spin_f = dot(front),
)]
#[define(
    sp = sin(phi), cp = cos(phi), st = sin(theta), ct = cos(theta), sd = sin(delta), cd = cos(delta),
    k1 = sd*sp - cd*st*cp,
    k3 = ct*cp,
    down = sqrt(powi(k1, 2) + powi(k3, 2)),
    z_rear = -rr*cp,
    z_front = z_rear + cp*(d2*ct - d1*st) + d3*k1,
)]
#[define(
    w2 = sp*turning,
    w3 = cp*turning,
    e1 = ct*rolling - st*w3,
    e2 = w2 + pitching,
    e3 = st*rolling + ct*w3,
    h1 = cd*e1 + sd*e2,
    h2 = -sd*e1 + cd*e2,
    h3 = e3 + steering,
)]
#[define(
    a1 = ahead - rr*w2,
    a2 = cp*aside + rr*rolling,
    a3 = -sp*aside,
    c1 = ct*a1 - st*a3,
    c3 = st*a1 + ct*a3,
    s1 = c1 + d2*e2,
    s2 = a2 + d1*e3 - d2*e1,
    f1 = cd*s1 + sd*s2,
    f2 = -sd*s1 + cd*s2 + d3*h3,
    f3 = c3 - d1*e2 - d3*h2,
)]
#[kinetic_energy(
    (mr*(powi(a1, 2) + powi(a2, 2) + powi(a3, 2))
    + irx*(powi(rolling, 2) + powi(w3, 2)) + iry*powi(w2 + spin_r, 2)
    + mb*(powi(c1 + l2*e2, 2) + powi(a2 + l1*e3 - l2*e1, 2) + powi(c3 - l1*e2, 2))
    + ibx*powi(e1, 2) + iby*powi(e2, 2) + ibz*powi(e3, 2) + 2*ibxz*e1*e3
    + mh*(powi(f1 + l4*h2, 2) + powi(f2 + l3*h3 - l4*h1, 2) + powi(f3 - l3*h2, 2))
    + ihx*powi(h1, 2) + ihy*powi(h2, 2) + ihz*powi(h3, 2) + 2*ihxz*h1*h3
    + mf*(powi(f1, 2) + powi(f2, 2) + powi(f3, 2))
    + ifx*(powi(h1, 2) + powi(h3, 2)) + ify*powi(h2 + spin_f, 2))/2
)]
#[potential_energy(
    -g*((mr + mb)*z_rear + mb*cp*(l2*ct - l1*st) + (mh + mf)*z_front + mh*(l3*k1 + l4*k3))
)]
#[constraint(rear_along: ahead + rr*spin_r == 0)]
#[constraint(rear_across: aside == 0)]
#[constraint(contact: z_front + rf*down == 0)]
#[constraint(front_across: f2 + rf*(h3*k1 - h1*k3)/down == 0)]
#[constraint(front_along: (f1*k3 - f3*k1)/down + rf*(h2 + spin_f) == 0)]
#[independent(rolling, steering, spin_r)]
#[start(theta = 0.3141592653589793)]
pub struct Bicycle {
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(0.3)]
    pub rr: f64,
    #[nominal(0.35)]
    pub rf: f64,
    #[nominal(0.953457)]
    pub d1: f64,
    #[nominal(0.267645)]
    pub d2: f64,
    #[nominal(0.032071)]
    pub d3: f64,
    #[nominal(0.470727)]
    pub l1: f64,
    #[nominal(-0.477929)]
    pub l2: f64,
    #[nominal(-0.005971)]
    pub l3: f64,
    #[nominal(-0.369952)]
    pub l4: f64,
    #[nominal(2)]
    pub mr: f64,
    #[nominal(85)]
    pub mb: f64,
    #[nominal(4)]
    pub mh: f64,
    #[nominal(3)]
    pub mf: f64,
    #[nominal(0.0603)]
    pub irx: f64,
    #[nominal(0.12)]
    pub iry: f64,
    #[nominal(7.17817)]
    pub ibx: f64,
    #[nominal(11)]
    pub iby: f64,
    #[nominal(4.82183)]
    pub ibz: f64,
    #[nominal(3.82255)]
    pub ibxz: f64,
    #[nominal(0.058413)]
    pub ihx: f64,
    #[nominal(0.06)]
    pub ihy: f64,
    #[nominal(0.007587)]
    pub ihz: f64,
    #[nominal(0.009119)]
    pub ihxz: f64,
    #[nominal(0.1405)]
    pub ifx: f64,
    #[nominal(0.28)]
    pub ify: f64,
}
