//! Random systems that are stated by families: arrays of parameters, coordinates and speeds, sums, repeated statements.

use super::generate::Builder;
use super::higher::Kind;

impl Builder {
    /// All statements of a model of n entries, and the fields of its struct.
    pub fn families(&mut self) -> (String, String) {
        let n = self.n;
        let own = self.writer.random.once_in(2);
        let v = |i: &str| if own { format!("v[{i}]") } else { format!("dot(x[{i}])") };
        let mut text = format!("#[size(n = {n})]\n#[coordinates(x[n])]\n");
        if own {
            text += "#[speeds(v[n])]\n#[kinematics(\n    ";
            let (c, b, a) = (self.factor(), self.writer.decimal(0.1, 0.3), self.writer.decimal(0.1, 0.4));
            let next = "(i + 1) % n";
            text += &match self.writer.random.once_in(2) {
                true => format!("dot(x[i]) = {c}*k[i]*v[i] + {b}*s[{next}]*v[{next}] + {a}*s[i] for i in 0..n"),
                false => format!("v[i] = {c}*k[i]*dot(x[i]) + {b}*s[{next}]*dot(x[{next}]) - {a}*s[i] for i in 0..n"),
            };
            text += ",\n)]\n";
        }
        text += &self.chains();
        text += &self.dynamics(&v);
        text += &self.bound(own);
        let value = self.writer.decimal(0.8, 1.2);
        (text, format!("    #[nominal({value})]\n    pub k: [f64; {n}],\n"))
    }

    fn factor(&mut self) -> String {
        self.writer.decimal(0.9, 1.3)
    }

    /// What is defined for each entry: s[i] by itself, r[i] by the ones before.
    fn chains(&mut self) -> String {
        let (a, b) = (self.writer.decimal(0.4, 1.2), self.writer.decimal(0.1, 1.0));
        let by_time = if self.rheonomic { " + t/2" } else { "" };
        let function = ["sin", "cos", "wave", "bump", "tanh"][self.writer.random.below(5)];
        format!(
            "#[define(s[i] = {function}({a}*x[i] + i/2 - {b}{by_time}) for i in 0..n)]\n\
             #[define(r[0] = s[0]/2, r[i] = (r[i - 1] + s[i])/2 for i in 1..n)]\n"
        )
    }

    /// M and h*, or T and the other forces.
    fn dynamics(&mut self, v: &dyn Fn(&str) -> String) -> String {
        let c = self.factor();
        let mass = format!("({c} + k[i]*r[i]/4)");
        let (b, d) = (self.writer.decimal(0.2, 0.8), self.writer.decimal(0.2, 0.8));
        let forces = format!(
            "#[forces(\n    {b}*sum(0..n, |j| sin(x[i] - x[j])*{}) - {d}*k[i]*{} - product(0..=i, |j| s[j]) for i in 0..n,\n)]\n",
            v("j"),
            v("i"),
        );
        let potential = match self.writer.random.once_in(2) {
            true => format!("#[potential_energy(sum(1..n, |i| k[i]*powi(x[i] - x[i - 1], 2))/2 + {b}*r[n - 1])]\n"),
            false => String::new(),
        };
        let of_mass = match self.writer.random.below(3) {
            0 => format!("#[inertia(diag({mass} for i in 0..n))]\n"),
            // positive definite: the samples of a positive function's transform, scaled
            1 => {
                let other = mass.replace("[i]", "[j]");
                format!(
                    "#[inertia(matrix(\n    [{mass}*{other}/(1 + 2*powi(i - j, 2)) for j in 0..n] for i in 0..n,\n))]\n"
                )
            }
            _ => format!(
                "#[kinetic_energy(\n    sum(0..n, |i| {mass}*powi({} + {b}*r[i]*{}, 2))/2 + {d}*s[0]*{} + r[n - 1]\n)]\n",
                v("i"),
                v("(i + 1) % n"),
                v("n - 1"),
            ),
        };
        of_mass + &forces + &potential
    }

    /// Constraints of the first entries, or these as functions of the others.
    fn bound(&mut self, own: bool) -> String {
        let n = self.n;
        let v = |i: &str| if own { format!("v[{i}]") } else { format!("dot(x[{i}])") };
        let (b, d) = (self.writer.signed(0.1, 0.3), self.writer.signed(0.1, 0.6));
        let c = self.factor();
        let kinds = [Kind::Position, Kind::Velocity, Kind::Nonlinear, Kind::Acceleration];
        let m = self.writer.random.below(n);
        let kind = *self.writer.random.one_of(&kinds);
        if m == 0 {
            return String::new();
        }
        if self.writer.random.once_in(4) {
            // the others move freely, and bind the first
            let last = "x[n - 1]";
            let time = if self.rheonomic { " + t" } else { "" };
            let reactions = match self.writer.random.once_in(2) {
                true => {
                    format!("#[constraint(held_x[i]: x[i] == {c}*sin({last} + i{time}) for i in 0..{m})]\n")
                }
                false => String::new(),
            };
            return format!("#[configuration(x[i] = {c}*sin({last} + i{time}) for i in 0..{m})]\n{reactions}");
        }
        let left = match kind {
            Kind::Position => format!("{c}*x[i] + sin(x[i])/8{b}*powi(x[n - 1], 2){d}*s[n - 1]"),
            Kind::Velocity => format!("({c}{b}*s[i])*{}{b}*r[i]*{}{d}*s[n - 1]", v("i"), v("n - 1")),
            Kind::Nonlinear => format!("{c}*{}{b}*sin({} - {}){d}*s[n - 1]", v("i"), v("i"), v("n - 1")),
            Kind::Acceleration => {
                format!("{c}*ddot(x[i]){b}*r[i]*ddot(x[n - 1]){d}*{}*{}", v("i"), v("n - 1"))
            }
        };
        let named = matches!(kind, Kind::Position | Kind::Velocity) && self.writer.random.once_in(2);
        let independent = if named { format!("#[independent({} for i in {m}..n)]\n", v("i")) } else { String::new() };
        let redundant = match kind == Kind::Velocity && !named && self.writer.random.once_in(2) {
            true => format!("#[constraint(again[i]: 2*({left}) == 0 for i in 0..{m}, redundant)]\n"),
            false => String::new(),
        };
        format!("#[constraint(row[i]: {left} == 0 for i in 0..{m})]\n{redundant}{independent}")
    }
}
