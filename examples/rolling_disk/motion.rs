//! One motion through the three formulations: agreement, energy, drift, reactions.

use crate::models::{FloorDisk, RollingDisk, StagedDisk};
use holonomy::{Error, Prepared, State};

/// The three formulations of one disk.
pub struct Disks {
    pub quasi: Prepared<RollingDisk>,
    pub floor: Prepared<FloorDisk>,
    pub staged: Prepared<StagedDisk>,
    pub r: f64,
}

impl Disks {
    pub fn new(m: f64, r: f64, j: f64, g: f64) -> Result<Self, Error> {
        use holonomy::ConstrainedSystem;
        Ok(Disks {
            quasi: RollingDisk { m, r, j, g }.prepare()?,
            floor: FloorDisk { m, r, j, g }.prepare()?,
            staged: StagedDisk { m, r, j, g }.prepare()?,
            r,
        })
    }
}

/// Contact point, angles and rates: what all three formulations can tell.
#[derive(Copy, Clone, Debug)]
pub struct Posture {
    pub x: f64,
    pub y: f64,
    pub phi: f64,
    pub theta: f64,
    pub psi: f64,
    /// dφ/dt, dθ/dt, dψ/dt.
    pub rates: [f64; 3],
}

impl Posture {
    fn of_quasi(s: &State<RollingDisk>) -> Self {
        let (sin, cos) = s.theta.sin_cos();
        let phi_rate = s.v5 / cos;
        Posture {
            x: s.x,
            y: s.y,
            phi: s.phi,
            theta: s.theta,
            psi: s.psi,
            rates: [phi_rate, -s.v4, s.v6 - phi_rate * sin],
        }
    }

    fn of_floor(s: &State<FloorDisk>) -> Self {
        let rates = [s.dot_phi, s.dot_theta, s.dot_psi];
        Posture { x: s.x, y: s.y, phi: s.phi, theta: s.theta, psi: s.psi, rates }
    }

    fn of_staged(s: &State<StagedDisk>) -> Self {
        let rates = [s.dot_phi, s.dot_theta, s.dot_psi];
        Posture { x: s.x, y: s.y, phi: s.phi, theta: s.theta, psi: s.psi, rates }
    }

    pub fn quasi(&self) -> State<RollingDisk> {
        let (sin, cos) = self.theta.sin_cos();
        let [phi, theta, psi] = self.rates;
        State::<RollingDisk> {
            x: self.x,
            y: self.y,
            z: 0.0,
            phi: self.phi,
            theta: self.theta,
            psi: self.psi,
            v6: psi + phi * sin,
            v5: phi * cos,
            v4: -theta,
        }
    }

    pub fn floor(&self, r: f64) -> State<FloorDisk> {
        let (sin, cos) = self.phi.sin_cos();
        let [phi, theta, psi] = self.rates;
        State::<FloorDisk> {
            x: self.x,
            y: self.y,
            phi: self.phi,
            theta: self.theta,
            psi: self.psi,
            dot_x: -r * psi * cos,
            dot_y: -r * psi * sin,
            dot_phi: phi,
            dot_theta: theta,
            dot_psi: psi,
        }
    }

    pub fn staged(&self) -> State<StagedDisk> {
        let [dot_phi, dot_theta, dot_psi] = self.rates;
        State::<StagedDisk> {
            x: self.x,
            y: self.y,
            phi: self.phi,
            theta: self.theta,
            psi: self.psi,
            dot_phi,
            dot_theta,
            dot_psi,
        }
    }

    fn distance(&self, other: &Posture) -> f64 {
        let list = |p: &Posture| [p.x, p.y, p.phi, p.theta, p.psi, p.rates[0], p.rates[1], p.rates[2]];
        list(self).iter().zip(list(other)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }
}

/// A sample of the motion: time, posture, contact force on the disk along the fixed axes.
pub type Sample = (f64, Posture, [f64; 3]);

/// What the three runs say of each other.
pub struct Comparison {
    pub samples: Vec<Sample>,
    /// Largest difference between any two formulations in a coordinate or a rate.
    pub disagreement: f64,
    /// Largest relative change of the energy, by formulation.
    pub energy: [f64; 3],
    /// Largest height of the contact point (quasi-velocities), largest slip (smooth floor with the reactions as forces).
    pub drift: [f64; 2],
    /// Largest difference of the contact force between formulations, in newtons.
    pub force: f64,
    /// The coefficient of friction that the motion needs.
    pub friction: f64,
    /// Largest difference of that from the contact force of another formulation.
    pub friction_error: f64,
}

/// Runs one motion through all three for `end` seconds.
///
/// The floor of the second formulation is smooth, so it rolls only if the friction that the third formulation finds is
/// applied to it as a force: a reaction that were wrong would show as slip.
pub fn compare(disks: &Disks, start: &Posture, end: f64) -> Result<Comparison, Error> {
    let tolerance = (1e-12, 1e-12);
    let every = 0.02;
    let quasi = disks.quasi.simulate(start.quasi()).tolerance(tolerance.0, tolerance.1).every(every).until(end)?;
    let staged = disks.staged.simulate(start.staged()).tolerance(tolerance.0, tolerance.1).every(every).until(end)?;
    let friction = |t: f64, s: &State<FloorDisk>| {
        let force = disks.staged.multipliers(t, &Posture::of_floor(s).staged(), &[]);
        [force.rolling_x, force.rolling_y].into()
    };
    let floor = disks
        .floor
        .simulate(start.floor(disks.r))
        .tolerance(tolerance.0, tolerance.1)
        .every(every)
        .inputs(friction)
        .until(end)?;

    let mut comparison = Comparison {
        samples: Vec::new(),
        disagreement: 0.0,
        energy: [0.0; 3],
        drift: [0.0; 2],
        force: 0.0,
        friction: 0.0,
        friction_error: 0.0,
    };
    let first = [
        disks.quasi.energy(0.0, &start.quasi()),
        disks.floor.energy(0.0, &start.floor(disks.r)),
        disks.staged.energy(0.0, &start.staged()),
    ];
    for (((t, a), (_, b)), (_, c)) in quasi.iter().zip(floor.iter()).zip(staged.iter()) {
        let postures = [Posture::of_quasi(a), Posture::of_floor(b), Posture::of_staged(c)];
        for other in &postures[..2] {
            comparison.disagreement = comparison.disagreement.max(postures[2].distance(other));
        }
        let energies = [disks.quasi.energy(t, a), disks.floor.energy(t, b), disks.staged.energy(t, c)];
        for i in 0..3 {
            comparison.energy[i] = comparison.energy[i].max((energies[i] / first[i] - 1.0).abs());
        }
        let slip_x = b.dot_x + disks.r * b.dot_psi * b.phi.cos();
        let slip_y = b.dot_y + disks.r * b.dot_psi * b.phi.sin();
        comparison.drift[0] = comparison.drift[0].max(a.z.abs());
        comparison.drift[1] = comparison.drift[1].max(slip_x.hypot(slip_y));

        let own = disks.quasi.multipliers(t, a, &[]);
        let force = to_fixed_axes(a.phi, a.theta, [own.no_slip_along, own.no_slip_across, own.contact]);
        let lambda = disks.staged.multipliers(t, c, &[]);
        let other = [lambda.rolling_x, lambda.rolling_y, lambda.contact];
        for (p, q) in force.iter().zip(other) {
            comparison.force = comparison.force.max((p - q).abs());
        }
        let needed = disks.quasi.outputs(t, a, &[]).friction;
        let expected = lambda.rolling_x.hypot(lambda.rolling_y) / lambda.contact;
        comparison.friction = comparison.friction.max(needed);
        comparison.friction_error = comparison.friction_error.max((needed - expected).abs());
        let input = [lambda.rolling_x, lambda.rolling_y].into();
        let normal = disks.floor.multipliers(t, b, &input).contact;
        comparison.force = comparison.force.max((normal - lambda.contact).abs());
        comparison.samples.push((t, postures[2], other));
    }
    Ok(comparison)
}

/// Components along ξ, η, ζ to components along the fixed axes: A_1 of (6.2).
fn to_fixed_axes(phi: f64, theta: f64, f: [f64; 3]) -> [f64; 3] {
    let ((sp, cp), (st, ct)) = (phi.sin_cos(), theta.sin_cos());
    [cp * f[0] - st * sp * f[1] + ct * sp * f[2], sp * f[0] + st * cp * f[1] - ct * cp * f[2], ct * f[1] + st * f[2]]
}
