//! Vectors and frames, everywhere by their components in the inertial frame.

use super::evaluate::Scope;
use super::geometry::Record;
use super::inertia::{central, in_the_world};
use super::number::Number;
use super::quaternions::turned;
use super::statements::plain;
use syn::{Expr, ExprUnary, Member, UnOp};

/// Components in the inertial frame.
pub type Vector<N> = [N; 3];

/// The three axes of a frame.
pub type Axes<N> = [Vector<N>; 3];

/// A scalar or a vector.
#[derive(Clone, Copy, Debug)]
pub enum Value<N> {
    /// A scalar.
    Scalar(N),
    /// A vector.
    Vector(Vector<N>),
}

impl<N: Number> Value<N> {
    /// The scalar that it is.
    ///
    /// # Panics
    /// On a vector.
    pub fn scalar(self) -> N {
        let Self::Scalar(value) = self else { panic!("a vector where a scalar belongs") };
        value
    }

    /// The vector that it is; the scalar 0 is the vector 0.
    ///
    /// # Panics
    /// On any other scalar.
    pub fn vector(self) -> Vector<N> {
        match self {
            Self::Vector(components) => components,
            Self::Scalar(zero) if zero.value() == 0.0 => [N::zero(); 3],
            Self::Scalar(_) => panic!("a scalar where a vector belongs"),
        }
    }

    fn both(self, other: Self, of: impl Fn(N, N) -> N) -> Self {
        match (self, other) {
            (Self::Scalar(a), Self::Scalar(b)) => Self::Scalar(of(a, b)),
            (a, b) => {
                let (a, b) = (a.vector(), b.vector());
                Self::Vector(std::array::from_fn(|i| of(a[i], b[i])))
            }
        }
    }

    /// The sum.
    pub fn plus(self, other: Self) -> Self {
        self.both(other, |a, b| a + b)
    }

    /// The difference.
    pub fn minus(self, other: Self) -> Self {
        self.both(other, |a, b| a - b)
    }

    /// A multiple.
    pub fn times(self, factor: N) -> Self {
        self.map(|x| factor * x)
    }

    /// A part.
    pub fn over(self, divisor: N) -> Self {
        self.map(|x| x / divisor)
    }

    /// The same with every component changed.
    pub fn map<M>(self, of: impl Fn(N) -> M) -> Value<M> {
        match self {
            Self::Scalar(x) => Value::Scalar(of(x)),
            Self::Vector(components) => Value::Vector(components.map(of)),
        }
    }
}

/// a·b
pub fn inner<N: Number>(a: &Vector<N>, b: &Vector<N>) -> N {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a×b
pub fn outer<N: Number>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// a + b
pub fn sum<N: Number>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    std::array::from_fn(|i| a[i] + b[i])
}

/// a - b
pub fn difference<N: Number>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    std::array::from_fn(|i| a[i] - b[i])
}

/// f a
pub fn scaled<N: Number>(f: N, a: &Vector<N>) -> Vector<N> {
    a.map(|x| f * x)
}

impl<N: Number> Scope<'_, N> {
    /// The value of an expression that is a vector.
    ///
    /// # Panics
    /// If it is none.
    pub fn vector(&self, e: &Expr) -> Vector<N> {
        self.evaluate(e).vector()
    }

    /// `A.x`
    pub(super) fn axis(&self, e: &Expr) -> Vector<N> {
        let Expr::Field(field) = e else { panic!("not an axis of a frame") };
        let Member::Named(member) = &field.member else { panic!("not an axis of a frame") };
        self.axes(&field.base)[index(&member.to_string()).expect("x, y or z")]
    }

    /// The axes of a frame: by its name, or by the name of the body that has it, or as a rotation.
    ///
    /// # Panics
    /// On what is no frame.
    pub fn axes(&self, e: &Expr) -> Axes<N> {
        let Some(name) = plain(e) else { return self.rotated(e) };
        if name == "N" {
            return std::array::from_fn(|i| std::array::from_fn(|j| N::constant(f64::from(u8::from(i == j)))));
        }
        if let Some(axes) = self.turned.borrow().get(name.as_str()) {
            return *axes;
        }
        let geometry = &self.model.geometry;
        let Some((name, frame)) = geometry.frames.get_key_value(&name) else {
            let body = geometry.body(&name).unwrap_or_else(|| panic!("`{name}` is no frame"));
            return self.axes(body.entry("frame"));
        };
        let axes = self.axes(frame);
        self.turned.borrow_mut().insert(name, axes);
        axes
    }

    /// `rotate(base, axis, angle)`: every axis of the base turned by Rodrigues' formula. `quaternion(base, e0, e1, e2, e3)`: an
    /// axis along those of the base.
    fn rotated(&self, e: &Expr) -> Axes<N> {
        let Expr::Call(call) = e else { panic!("not a frame") };
        let arguments: Vec<&Expr> = call.args.iter().collect();
        let function = plain(&call.func);
        if function.as_deref() == Some("quaternion") {
            let base = self.axes(arguments[0]);
            let e = [1, 2, 3, 4].map(|i| self.value(arguments[i]));
            return [0, 1, 2].map(|axis| {
                let unit = std::array::from_fn(|i| N::constant(f64::from(u8::from(i == axis))));
                let along = turned(e, &unit);
                let parts = [0, 1, 2].map(|i| scaled(along[i], &base[i]));
                sum(&sum(&parts[0], &parts[1]), &parts[2])
            });
        }
        assert_eq!(function.as_deref(), Some("rotate"));
        let [base, axis, angle] = arguments.as_slice() else { panic!("not a rotation") };
        let base = self.axes(base);
        let axis = self.direction(&base, axis);
        let (sin, cos) = self.value(angle).sin_cos();
        base.map(|old| {
            let along = scaled((N::one() - cos) * inner(&axis, &old), &axis);
            sum(&sum(&scaled(cos, &old), &scaled(sin, &outer(&axis, &old))), &along)
        })
    }

    /// An axis of the base by its bare name, its opposite, or a vector.
    fn direction(&self, base: &Axes<N>, e: &Expr) -> Vector<N> {
        let bare = |e: &Expr| plain(e).and_then(|name| index(&name));
        match e {
            Expr::Unary(ExprUnary { op: UnOp::Neg(_), expr, .. }) if bare(expr).is_some() => {
                base[bare(expr).expect("an axis")].map(|x| -x)
            }
            e => bare(e).map_or_else(|| self.vector(e), |i| base[i]),
        }
    }

    /// The functions of vectors.
    pub(super) fn of_vectors(&self, name: &str, arguments: &[&Expr]) -> Option<Value<N>> {
        let vector = |i: usize| self.vector(arguments[i]);
        Some(match (name, arguments.len()) {
            ("dot", 2) => Value::Scalar(inner(&vector(0), &vector(1))),
            ("dot", 1) => self.along(0).rate(arguments[0]),
            ("ddot", 1) => self.along(1).rate(arguments[0]),
            ("cross", 2) => Value::Vector(outer(&vector(0), &vector(1))),
            ("norm", 1) => Value::Scalar(inner(&vector(0), &vector(0)).sqrt()),
            ("unit", 1) => Value::Vector(vector(0)).over(inner(&vector(0), &vector(0)).sqrt()),
            ("velocity", 1) => self.along(0).rate(arguments[0]),
            ("velocity", 2) => Value::Vector(self.material_velocity(arguments[0], arguments[1])),
            ("angular_velocity", 1) => Value::Vector(self.along(0).turning(arguments[0])),
            ("momentum", 1) => Value::Vector(self.momentum(arguments[0])),
            ("angular_momentum", 2) => Value::Vector(self.angular_momentum(arguments[0], arguments[1])),
            ("acceleration", 1) => self.along(1).rate(arguments[0]),
            ("angular_acceleration", 1) => Value::Vector(self.along(1).turning(arguments[0])),
            _ => return None,
        })
    }

    fn mass_of(&self, body: &Expr) -> &Record {
        let name = plain(body).expect("the name of a body");
        let mut heavy = self.model.geometry.records.iter().filter(|record| record.has_mass());
        heavy.find(|record| record.name == name).expect("a body of that name")
    }

    /// m v of the mass centre.
    fn momentum(&self, body: &Expr) -> Vector<N> {
        let body = self.mass_of(body);
        scaled(self.value(body.entry("mass")), &self.along(0).rate(body.center()).vector())
    }

    /// That about a point, and I ω.
    fn angular_momentum(&self, name: &Expr, point: &Expr) -> Vector<N> {
        let body = self.mass_of(name);
        let arm = difference(&self.vector(body.center()), &self.vector(point));
        let orbital = outer(&arm, &self.momentum(name));
        if !body.entries.contains_key("inertia") {
            return orbital;
        }
        let axes = self.axes(body.entry("frame"));
        let inertia = in_the_world(&central(body, self, self.value(body.entry("mass")), &axes), &axes);
        let omega = self.along(0).turning(body.entry("frame"));
        sum(&orbital, &inertia.map(|row| inner(&row, &omega)))
    }

    /// The velocity of the material point of a body at a point.
    pub(super) fn material_velocity(&self, point: &Expr, body: &Expr) -> Vector<N> {
        let carrier = self.model.geometry.carrier(&plain(body).expect("the name of a body"));
        let center = self.along(0).rate(carrier.center()).vector();
        let arm = difference(&self.vector(point), &self.vector(carrier.center()));
        sum(&center, &outer(&self.along(0).turning(carrier.entry("frame")), &arm))
    }
}

/// x, y or z.
pub fn index(axis: &str) -> Option<usize> {
    ["x", "y", "z"].iter().position(|name| *name == axis)
}
