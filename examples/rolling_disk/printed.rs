//! The paper's printed formulas beside what the compiler derived, as numbers at one state.

use crate::motion::{Disks, Posture};
use holonomy::{Matrix, Vector};

/// One quantity: where it stands, what it is, derived and printed value.
pub struct Line {
    pub equation: &'static str,
    pub quantity: &'static str,
    pub derived: f64,
    pub printed: f64,
}

impl Line {
    pub fn holds(&self) -> bool {
        (self.derived - self.printed).abs() <= 1e-10 * self.derived.abs().max(1.0)
    }
}

/// Every equation of section 6 that gives a formula, as the paper prints it. `params` is m, r, J, g.
pub fn lines(disks: &Disks, posture: &Posture, params: [f64; 4]) -> Vec<Line> {
    let mut table = Table { lines: Vec::new() };
    quasi_velocities(&mut table, disks, posture, params);
    generalised_coordinates(&mut table, disks, posture, params);
    independent_rates(&mut table, disks, posture, params);
    table.lines
}

struct Table {
    lines: Vec<Line>,
}

impl Table {
    fn add(&mut self, equation: &'static str, quantity: &'static str, derived: f64, printed: f64) {
        self.lines.push(Line { equation, quantity, derived, printed });
    }
}

fn quasi_velocities(table: &mut Table, disks: &Disks, posture: &Posture, [m, r, j, g]: [f64; 4]) {
    let s = posture.quasi();
    let disk = &disks.quasi;
    let (x, v) = (disk.coordinates(0.0, &s), disk.velocities(0.0, &s));
    let a = disk.kinematic_matrix(0.0, &x);
    let (sin, cos, tan) = (s.theta.sin(), s.theta.cos(), s.theta.tan());
    table.add("(6.2)", "A_1 (2,3)", a.entry(1, 2), -cos * s.phi.cos());
    table.add("(6.2)", "A_2 (3,2)", a.entry(5, 4), tan);
    table.add("(6.2)", "A_3 (1,2)", a.entry(0, 4), r * tan * s.phi.cos());
    table.add("(6.2)", "A_3 (3,1)", a.entry(2, 3), -r * s.phi.sin());
    let c = disk.constraint_matrix(0.0, &x, &v);
    table.add("(6.7)", "C (1,6)", c.entry(0, 5), r);
    table.add("(6.7)", "C (3,4)", c.entry(2, 3), -r);
    let d = disk.complement(0.0, &s);
    table.add("(6.8)", "D (1,1)", d.entry(0, 0), -r);
    table.add("(6.8)", "D (3,3)", d.entry(2, 2), r);
    let [v1, v2, v3, v4, v5, v6]: [f64; 6] = v.into();
    let h = disk.forces(0.0, &x, &v, &[]);
    let dh = |row: usize| (0..6).map(|i| d.entry(row, i) * h.get(&format!("v{}", i + 1)).unwrap_or(f64::NAN)).sum();
    table.add("(6.11)", "row 1", dh(0), -m * r * v5 * (v2 * tan - v3));
    table.add("(6.11)", "row 2", dh(1), j * v4 * (2.0 * v6 - v5 * tan));
    let row3 = m * r * (v5 * v1 - v4 * v2 - g * r * sin) + j * v5 * (v5 * tan - 2.0 * v6);
    table.add("(6.11)", "row 3", dh(2), row3);
    let lambda = disk.multipliers(0.0, &s, &[]);
    let (mu1, mu2) = (2.0 * m * j / (m * r * r + 2.0 * j), m * j / (m * r * r + j));
    table.add("(6.12)", "λ1", lambda.no_slip_along, mu1 * v5 * (v2 * tan - v3));
    table.add("(6.12)", "λ2", lambda.no_slip_across, m * (v4 * v3 - v5 * v1 * tan - g * cos));
    let third = mu2 * (v5 * v1 - v4 * v2 - g * sin - v5 / r * (v5 * tan - 2.0 * v6));
    table.add("(6.12)", "λ3", lambda.contact, third);
}

fn generalised_coordinates(table: &mut Table, disks: &Disks, posture: &Posture, [m, r, j, g]: [f64; 4]) {
    let s = posture.floor(disks.r);
    let disk = &disks.floor;
    let smooth = [0.0; 2].into();
    let (md, hu) = disk.mass_matrix_and_forcing(0.0, &s, &smooth);
    let ((st, ct), (sp, cp)) = (s.theta.sin_cos(), s.phi.sin_cos());
    let [phi, theta, psi] = posture.rates;
    table.add("(6.17)", "M_d (1,3)", md.entry(0, 2), -m * r * st * cp);
    table.add("(6.17)", "M_d (2,4)", md.entry(1, 3), m * r * ct * cp);
    table.add("(6.17)", "M_d (3,3)", md.entry(2, 2), (m * r * r + j) * st * st + j);
    table.add("(6.17)", "M_d (3,5)", md.entry(2, 4), 2.0 * j * st);
    let squares = phi * phi + theta * theta;
    let row1 = -m * r * (squares * st * sp - 2.0 * phi * theta * ct * cp);
    table.add("(6.18)", "h_u* row 1", hu[0], row1);
    let row3 = -2.0 * (m * r * r + j) * phi * theta * st * ct - 2.0 * j * psi * theta * ct;
    table.add("(6.18)", "h_u* row 3", hu[2], row3);
    let row4 = (m * r * r - j) * phi * phi * st * ct + 2.0 * j * phi * (psi + phi * st) * st + m * g * ct;
    table.add("(6.18)", "h_u* row 4", hu[3], row4);
    table.add("(6.18)", "h_u* row 5", hu[4], -2.0 * j * phi * theta * ct);
    let normal = -m * r * phi * (psi * ct + phi * st * ct) * st + m * g;
    table.add("(6.19)", "λ, smooth floor", disk.multipliers(0.0, &s, &smooth).contact, normal);
}

fn independent_rates(table: &mut Table, disks: &Disks, posture: &Posture, [m, r, j, g]: [f64; 4]) {
    let s = posture.staged();
    let (md, hu) = disks.staged.mass_matrix_and_forcing(0.0, &s, &[]);
    let (st, ct) = s.theta.sin_cos();
    let [w1, w2, w3] = posture.rates;
    table.add("(6.27)", "M_ω (1,1)", md.entry(0, 0), (m * r * r + j) * st * st + j);
    table.add("(6.27)", "M_ω (1,3)", md.entry(0, 2), (m * r * r + j) * st);
    table.add("(6.27)", "M_ω (2,2)", md.entry(1, 1), m * r * r + j);
    table.add("(6.27)", "M_ω (3,3)", md.entry(2, 2), m * r * r + 2.0 * j);
    table.add("(6.28)", "h_ω* row 1", hu[0], m * r * r * w2 * w3 * ct);
    let row2 = (m * r * r + j) * w1 * w1 * st * ct + (m * r * r + 2.0 * j) * w1 * w1 * ct + m * g * ct;
    table.add("(6.28)", "h_ω* row 2", hu[1], row2);
    table.add("(6.28)", "h_ω* row 3", hu[2], -m * r * r * w2 * w1 * ct);
}
