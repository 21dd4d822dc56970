//! Where bodies are in the configuration in which a random mechanism is drawn.

/// A vector by its components in N.
pub type Vector = [f64; 3];

/// The axes of a frame and the point from which what it carries goes on.
#[derive(Copy, Clone, Debug)]
pub struct Pose {
    /// The unit vectors of the frame.
    pub axes: [Vector; 3],
    /// The point.
    pub origin: Vector,
}

impl Pose {
    /// N at O.
    pub const GROUND: Self = Self { axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], origin: [0.0; 3] };

    /// The vector with these components in the frame.
    pub fn vector(&self, local: Vector) -> Vector {
        std::array::from_fn(|i| (0..3).map(|j| self.axes[j][i] * local[j]).sum())
    }

    /// Where this place of the frame is.
    pub fn place(&self, local: Vector) -> Vector {
        sum(self.origin, self.vector(local))
    }

    /// The components of a vector in the frame.
    pub fn local(&self, vector: Vector) -> Vector {
        self.axes.map(|axis| dot(axis, vector))
    }

    /// The frame turned about a unit vector that is given in it: Rodrigues' formula.
    pub fn turned(&self, axis: Vector, angle: f64) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let unit = |j: usize| -> Vector { std::array::from_fn(|i| f64::from(u8::from(i == j))) };
        let turn = |e: Vector| {
            let (along, across) = (scaled(axis, dot(axis, e) * (1.0 - cosine)), scaled(cross(axis, e), sine));
            sum(sum(scaled(e, cosine), across), along)
        };
        Self { axes: [0, 1, 2].map(|j| self.vector(turn(unit(j)))), ..*self }
    }

    /// Angles a, b, c with which rotate(rotate(rotate(self, z, a), y, b), x, c) has the axes of the other frame.
    pub fn angles_to(&self, other: &Self) -> [f64; 3] {
        let [x, y, z] = other.axes.map(|axis| self.local(axis));
        [x[1].atan2(x[0]), (-x[2]).atan2(x[0].hypot(x[1])), y[2].atan2(z[2])]
    }

    /// Angles a, b with which rotate(rotate(self, z, a), x, b) has its z-axis along a unit vector.
    pub fn angles_to_axis(&self, axis: Vector) -> [f64; 2] {
        let [x, y, z] = self.local(axis);
        [x.atan2(-y), x.hypot(y).atan2(z)]
    }
}

/// a + b.
pub fn sum(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] + b[i])
}

/// a - b.
pub fn less(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] - b[i])
}

/// s a.
pub fn scaled(a: Vector, s: f64) -> Vector {
    a.map(|a| s * a)
}

/// a · b.
pub fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

/// a × b.
pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The length.
pub fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}
