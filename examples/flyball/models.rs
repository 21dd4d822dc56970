//! A governor whose loops are closed by stiff springs, from geometry alone.

use holonomy::ConstrainedSystem;

/// The flyball governor of the benchmark library: a shaft, as high as a rod is long, that spins freely; a slider on it; two rods with
/// balls, hinged to its top; and from the slider to the middle of each rod a spring and a damper, so stiff that they are nearly rods.
///
/// The pulls of these, the power of the dampers, and the angular momentum about the shaft are outputs.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(ph, s, a1, a2)]
#[frame(S = revolute(N, z, ph), R1 = revolute(S, -y, a1), R2 = revolute(S, y, a2))]
#[point(
    Slider = prismatic(O, N.z, s),
    H1 = O + l_rod*N.z + off*S.x, M1 = H1 - l_rod/2*R1.z, B1 = H1 - l_rod*R1.z, E1 = Slider + off*S.x,
    H2 = O + l_rod*N.z - off*S.x, M2 = H2 - l_rod/2*R2.z, B2 = H2 - l_rod*R2.z, E2 = Slider - off*S.x,
)]
#[body(
    shaft = { frame: S, center: O + l_rod/2*N.z, mass: m_rod, inertia: cuboid(m_rod, w_rod, w_rod, l_rod) },
    slider = { frame: S, center: Slider, mass: m_slider, inertia: cuboid(m_slider, b_slider, b_slider, b_slider) },
    rod1 = { frame: R1, center: M1, mass: m_rod, inertia: cuboid(m_rod, w_rod, w_rod, l_rod) },
    rod2 = { frame: R2, center: M2, mass: m_rod, inertia: cuboid(m_rod, w_rod, w_rod, l_rod) },
)]
#[particle(ball1 = { at: B1, mass: m_ball }, ball2 = { at: B2, mass: m_ball })]
#[gravity(-g*N.z)]
#[spring(
    stiff1 = { from: E1, to: M1, stiffness: k, length: l0 },
    stiff2 = { from: E2, to: M2, stiffness: k, length: l0 },
)]
#[damper(slow1 = { from: E1, to: M1, coefficient: cd }, slow2 = { from: E2, to: M2, coefficient: cd })]
#[define(
    rate1 = dot(velocity(M1) - velocity(E1), unit(M1 - E1)),
    rate2 = dot(velocity(M2) - velocity(E2), unit(M2 - E2)),
)]
#[output(
    tension1 = k*(norm(M1 - E1) - l0) + cd*rate1,
    tension2 = k*(norm(M2 - E2) - l0) + cd*rate2,
    damping = -cd*(powi(rate1, 2) + powi(rate2, 2)),
    turning = dot(
        angular_momentum(shaft, O) + angular_momentum(slider, O) + angular_momentum(rod1, O) + angular_momentum(rod2, O)
            + angular_momentum(ball1, O) + angular_momentum(ball2, O),
        N.z
    ),
)]
pub struct Governor {
    /// Gravity.
    #[unit(m/s/s)]
    #[nominal(9.81)]
    pub g: f64,
    /// Stiffness of a spring.
    #[unit(N/m)]
    #[nominal(8e5)]
    pub k: f64,
    /// Coefficient of a damper.
    #[unit(N*s/m)]
    #[nominal(4e4)]
    pub cd: f64,
    /// Length of a spring at rest.
    #[unit(m)]
    #[nominal(0.5)]
    pub l0: f64,
    /// Mass of a rod, and of the shaft.
    #[unit(kg)]
    #[nominal(0.3)]
    pub m_rod: f64,
    /// Length of a rod, and height of the shaft.
    #[unit(m)]
    #[nominal(1)]
    pub l_rod: f64,
    /// The side of their square section.
    #[unit(m)]
    #[nominal(0.01)]
    pub w_rod: f64,
    /// Distance of hinges and of the springs' feet from the axis.
    #[unit(m)]
    #[nominal(0.05)]
    pub off: f64,
    /// Mass of a ball.
    #[unit(kg)]
    #[nominal(5)]
    pub m_ball: f64,
    /// Mass of the slider.
    #[unit(kg)]
    #[nominal(3)]
    pub m_slider: f64,
    /// Its side.
    #[unit(m)]
    #[nominal(0.1)]
    pub b_slider: f64,
}
