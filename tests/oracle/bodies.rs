//! Bodies in maximal coordinates: every body has its own accelerations, and every joint is a constraint.
//!
//! For each element that has inertia, M ẇ = F + ρ with w its velocity (of the mass centre, and angular; components in the inertial
//! frame), F all that is applied and −ω × (I ω), and ρ the force of its joints. The joints say w = w(v, x, t), differentiated
//! ẇ = J v̇ + γ, and pass on −Jᵀ ρ to the speeds. Nothing is eliminated: [`super::kkt`] solves for ẇ, v̇, ρ and λ together.

use super::evaluate::Scope;
use super::geometry::Record;
use super::inertia::{central, in_the_world};
use super::linear::{along, fixed, seeded};
use super::loads::{acting, stretch};
use super::number::{Dual, Number};
use super::statements::plain;
use super::system::{Entry, System};
use super::vectors::{Vector, inner, outer, scaled, sum};
use nalgebra::{DMatrix, DVector};
use syn::Expr;

/// Everything about the bodies at one point.
pub struct Bodies {
    /// The inertia of the elements, block by block.
    pub mass: DMatrix<Entry>,
    /// Applied forces and forces of inertia on them.
    pub force: DVector<Entry>,
    /// w.
    pub velocity: DVector<Entry>,
    /// J = ∂w/∂v.
    pub jacobian: DMatrix<Entry>,
    /// γ = ẇ with v̇ = 0.
    pub bias: DVector<Entry>,
    /// Units in which the elements' velocities are of order one.
    pub scale: DVector<f64>,
    /// The inertia of the speeds that is no body's.
    pub inertia_of_speeds: DMatrix<Entry>,
    /// The forces on the speeds that act on no body.
    pub force_of_speeds: DVector<Entry>,
}

impl Bodies {
    /// With what is declared of the speeds themselves.
    pub(super) fn beside(mut self, m: &DMatrix<Entry>, h: &DVector<Entry>) -> Self {
        self.inertia_of_speeds.zip_apply(m, |own, other| *own = *own + other);
        self.force_of_speeds.zip_apply(h, |own, other| *own = *own + other);
        self
    }

    /// M = Jᵀ M_b J, and that of the speeds themselves.
    pub(super) fn reduced_inertia(&self) -> DMatrix<Entry> {
        let n = self.jacobian.ncols();
        let mj = product(&self.mass, &self.jacobian);
        let entry = |i: usize, j: usize| {
            self.jacobian.column(i).iter().zip(mj.column(j).iter()).fold(Entry::zero(), |sum, (a, b)| sum + *a * *b)
        };
        DMatrix::from_fn(n, n, |i, j| self.inertia_of_speeds[(i, j)] + entry(i, j))
    }

    /// h* = Jᵀ (F − M_b γ), and the forces on the speeds themselves.
    pub(super) fn reduced_forces(&self) -> DVector<Entry> {
        let bias = DMatrix::from_columns(std::slice::from_ref(&self.bias));
        let inertial = product(&self.mass, &bias);
        let entry = |i: usize| {
            let rest = self.force.iter().zip(inertial.iter()).map(|(f, m)| *f - *m);
            self.jacobian.column(i).iter().zip(rest).fold(self.force_of_speeds[i], |sum, (a, b)| sum + *a * b)
        };
        DVector::from_fn(self.jacobian.ncols(), |i, _| entry(i))
    }

    /// Half of wᵀ M_b w.
    pub(super) fn kinetic(&self) -> Entry {
        let momentum = product(&self.mass, &DMatrix::from_columns(std::slice::from_ref(&self.velocity)));
        let twice = self.velocity.iter().zip(momentum.iter()).fold(Entry::zero(), |sum, (a, b)| sum + *a * *b);
        Entry::constant(0.5) * twice
    }
}

fn product(a: &DMatrix<Entry>, b: &DMatrix<Entry>) -> DMatrix<Entry> {
    let entry = |i: usize, j: usize| (0..a.ncols()).fold(Entry::zero(), |sum, k| sum + a[(i, k)] * b[(k, j)]);
    DMatrix::from_fn(a.nrows(), b.ncols(), entry)
}

/// Something with a velocity on which forces do power.
pub(super) enum Place<'a> {
    /// Mass centre and angular velocity of a body.
    Body(&'a Record),
    /// A point.
    Point(&'a Expr),
    /// A frame that turns.
    Frame(&'a Expr),
    /// A scalar that changes.
    Scalar(&'a Expr),
    /// A coordinate that changes, or a speed.
    Named(&'a str),
}

/// A place with what acts there.
struct Element<'a> {
    place: Place<'a>,
    force: Vec<Entry>,
    mass: Option<DMatrix<Entry>>,
    /// Its unit of velocity, linear and angular.
    scale: [f64; 2],
}

impl Place<'_> {
    fn velocity<N: Number>(&self, scope: &Scope<'_, N>) -> Vec<N> {
        match self {
            Self::Body(body) => {
                let center = scope.along(0).rate(body.center()).vector();
                [center, scope.along(0).turning(body.entry("frame"))].concat()
            }
            Self::Point(point) => scope.along(0).rate(point).vector().to_vec(),
            Self::Frame(frame) => scope.along(0).turning(frame).to_vec(),
            Self::Scalar(e) => vec![scope.along(0).rate(e).scalar()],
            Self::Named(name) => {
                let coordinate = scope.model.coordinates.iter().any(|x| x == name);
                vec![if coordinate { scope.rates[name] } else { scope.names[name] }]
            }
        }
    }
}

impl<'a> System<'a> {
    /// The bodies with all that acts on them, or on the speeds by other ways; `None` where no geometry is declared.
    pub(super) fn bodies(&self, t: Entry, x: &[Entry], v: &[Entry], scope: &Scope<'a, Entry>) -> Option<Bodies> {
        let elements = self.elements(scope);
        if elements.is_empty() {
            return None;
        }
        let velocities = |scope: Scope<'_, Dual<Entry>>| -> Vec<Vec<Dual<Entry>>> {
            elements.iter().map(|element| element.place.velocity(&scope)).collect()
        };
        let column = |j: usize| velocities(self.moving(Dual::fixed(t), &fixed(x), &seeded(v, j)));
        let columns: Vec<_> = (0..v.len()).map(column).collect();
        let moved = velocities(self.moving(Dual::moving(t, Entry::one()), &along(x, &self.rates(t, x, v)), &fixed(v)));
        let n = v.len();
        let size = elements.iter().filter(|e| e.mass.is_some()).map(|e| e.force.len()).sum();
        let mut bodies = Bodies {
            mass: DMatrix::from_element(size, size, Entry::zero()),
            force: DVector::from_element(size, Entry::zero()),
            velocity: DVector::from_element(size, Entry::zero()),
            jacobian: DMatrix::from_element(size, n, Entry::zero()),
            bias: DVector::from_element(size, Entry::zero()),
            scale: DVector::from_element(size, 1.0),
            inertia_of_speeds: DMatrix::from_element(n, n, Entry::zero()),
            force_of_speeds: DVector::from_element(n, Entry::zero()),
        };
        // the norm of a quaternion has no inertia of its own, and counts with one
        for (i, _) in self.model.speeds.iter().enumerate().filter(|(_, speed)| speed.starts_with("norm_rate_")) {
            bodies.inertia_of_speeds[(i, i)] = Entry::one();
        }
        let mut start = 0;
        for (e, element) in elements.iter().enumerate() {
            let Some(mass) = &element.mass else {
                for (j, column) in columns.iter().enumerate() {
                    let power = column[e].iter().zip(&element.force).map(|(w, f)| w.rate * *f);
                    bodies.force_of_speeds[j] = power.fold(bodies.force_of_speeds[j], |sum, part| sum + part);
                }
                continue;
            };
            let count = element.force.len();
            bodies.mass.view_mut((start, start), (count, count)).copy_from(mass);
            for i in 0..count {
                bodies.force[start + i] = element.force[i];
                bodies.velocity[start + i] = moved[e][i].value;
                bodies.bias[start + i] = moved[e][i].rate;
                bodies.scale[start + i] = element.scale[usize::from(i >= 3)];
                (0..n).for_each(|j| bodies.jacobian[(start + i, j)] = columns[j][e][i].rate);
            }
            start += count;
        }
        Some(bodies)
    }

    /// Everything with inertia, then everything on which forces act by other ways.
    fn elements(&self, scope: &Scope<'a, Entry>) -> Vec<Element<'a>> {
        let geometry = &self.model.geometry;
        let gravity = self.gravity(scope);
        let heavy: Vec<&Record> = geometry.records.iter().filter(|r| r.has_mass() || r.kind == "armature").collect();
        let mut elements: Vec<Element<'_>> = heavy.iter().map(|record| inertial(record, scope, &gravity)).collect();
        let at = |name: &str| heavy.iter().position(|record| record.name == name).expect("a body");
        for record in &geometry.records {
            for (place, force) in acting(record, scope) {
                // what acts on a body stands in its own equations, a torque behind the force
                let own = match place {
                    Place::Body(body) => Some((at(&body.name), 0)),
                    Place::Frame(e) => plain(e).filter(|name| geometry.body(name).is_some()).map(|name| (at(&name), 3)),
                    _ => None,
                };
                match own {
                    Some((at, first)) => {
                        let sums = elements[at].force[first..].iter_mut();
                        sums.zip(&force).for_each(|(sum, part)| *sum = *sum + *part);
                    }
                    None => elements.push(Element { place, force, mass: None, scale: [1.0; 2] }),
                }
            }
        }
        for (name, value) in &geometry.generalized {
            let force = vec![scope.value(value)];
            elements.push(Element { place: Place::Named(name), force, mass: None, scale: [1.0; 2] });
        }
        elements
    }

    /// The acceleration of gravity.
    fn gravity<N: Number>(&self, scope: &Scope<'_, N>) -> Vector<N> {
        self.model.geometry.gravity.iter().fold([N::zero(); 3], |g, e| sum(&g, &scope.vector(e)))
    }

    /// The potential energy of gravity and of the springs; `None` where there is neither.
    pub(super) fn potential(&self, scope: &Scope<'_, Entry>) -> Option<Entry> {
        let geometry = &self.model.geometry;
        let half = Entry::constant(0.5);
        let springs = geometry.records.iter().filter(|record| record.kind == "spring").map(|spring| {
            let stretch = stretch(spring, scope);
            half * scope.value(spring.entry("stiffness")) * stretch * stretch
        });
        let gravity = self.gravity(scope);
        let weighs = geometry.records.iter().filter(|record| record.has_mass() && !geometry.gravity.is_empty());
        let weights =
            weighs.map(|record| -(scope.value(record.entry("mass")) * inner(&gravity, &scope.vector(record.center()))));
        springs.chain(weights).reduce(|sum, part| sum + part)
    }
}

/// A body, a particle or an armature.
fn inertial<'a>(record: &'a Record, scope: &Scope<'_, Entry>, gravity: &Vector<Entry>) -> Element<'a> {
    let zero = Entry::zero();
    let root = |size: f64| if size > 0.0 { 1.0 / size.sqrt() } else { 1.0 };
    if record.kind == "armature" {
        let inertia = scope.value(record.entry("inertia"));
        let mass = Some(DMatrix::from_element(1, 1, inertia));
        return Element {
            place: Place::Scalar(record.entry("of")),
            force: vec![zero],
            mass,
            scale: [root(inertia.value); 2],
        };
    }
    let mass = scope.value(record.entry("mass"));
    let weight = scaled(mass, gravity);
    let linear = |i: usize, j: usize| if i == j { mass } else { zero };
    if record.kind == "particle" {
        let mass_matrix = Some(DMatrix::from_fn(3, 3, linear));
        let place = Place::Point(record.entry("at"));
        return Element { place, force: weight.to_vec(), mass: mass_matrix, scale: [root(mass.value); 2] };
    }
    let axes = scope.axes(record.entry("frame"));
    let inertia = in_the_world(&central(record, scope, mass, &axes), &axes);
    let turning = scope.along(0).turning(record.entry("frame"));
    let momentum: Vector<Entry> = std::array::from_fn(|i| inner(&inertia[i], &turning));
    let gyroscopic = outer(&momentum, &turning);
    let entry = |i: usize, j: usize| match (i < 3, j < 3) {
        (true, true) => linear(i, j),
        (false, false) => inertia[i - 3][j - 3],
        _ => zero,
    };
    let trace = (0..3).map(|i| inertia[i][i].value).sum::<f64>() / 2.0;
    Element {
        place: Place::Body(record),
        force: [weight, gyroscopic].concat(),
        mass: Some(DMatrix::from_fn(6, 6, entry)),
        scale: [root(mass.value), root(if trace > 0.0 { trace } else { mass.value })],
    }
}
