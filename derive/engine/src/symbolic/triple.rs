//! Three components, and what is done with them: the vectors and rotations of mechanics.

use super::{Expr, Graph};

/// The components of a vector along three axes.
pub type Triple = [Expr; 3];

/// A rotation by rows: it takes components in the turned frame to those in its base. Tensors have the same form.
pub type Rotation = [Triple; 3];

impl Graph {
    /// 0
    pub fn no_vector(&self) -> Triple {
        [self.zero(); 3]
    }

    /// The unit vector of an axis.
    pub fn axis(&self, axis: usize) -> Triple {
        std::array::from_fn(|i| if i == axis { self.one() } else { self.zero() })
    }

    /// a + b
    pub fn plus(&mut self, a: &Triple, b: &Triple) -> Triple {
        std::array::from_fn(|i| self.add(a[i], b[i]))
    }

    /// a - b
    pub fn minus(&mut self, a: &Triple, b: &Triple) -> Triple {
        std::array::from_fn(|i| self.sub(a[i], b[i]))
    }

    /// s a
    pub fn times(&mut self, s: Expr, a: &Triple) -> Triple {
        std::array::from_fn(|i| self.mul(s, a[i]))
    }

    /// a · b
    pub fn dot(&mut self, a: &Triple, b: &Triple) -> Expr {
        let terms: Vec<Expr> = (0..3).map(|i| self.mul(a[i], b[i])).collect();
        self.sum(&terms)
    }

    /// a × b
    pub fn cross(&mut self, a: &Triple, b: &Triple) -> Triple {
        std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let (first, second) = (self.mul(a[j], b[k]), self.mul(a[k], b[j]));
            self.sub(first, second)
        })
    }

    /// R a
    pub fn turned(&mut self, rotation: &Rotation, a: &Triple) -> Triple {
        std::array::from_fn(|i| self.dot(&rotation[i], a))
    }

    /// Rᵀ a
    pub fn turned_back(&mut self, rotation: &Rotation, a: &Triple) -> Triple {
        std::array::from_fn(|j| {
            let column = [rotation[0][j], rotation[1][j], rotation[2][j]];
            self.dot(&column, a)
        })
    }

    /// R I Rᵀ of a symmetric tensor.
    pub fn turned_tensor(&mut self, rotation: &Rotation, tensor: &Rotation) -> Rotation {
        if let Some(turned) = self.turned_about_axis(rotation, tensor) {
            return turned;
        }
        // Rows of R I.
        let half: Rotation = std::array::from_fn(|i| self.turned(tensor, &rotation[i]));
        let mut turned = [self.no_vector(); 3];
        for i in 0..3 {
            for j in 0..=i {
                turned[i][j] = self.dot(&half[i], &rotation[j]);
                turned[j][i] = turned[i][j];
            }
        }
        turned
    }

    /// R C Rᵀ of any tensor about a coordinate axis, by what its block across the axis differs from a multiple of one: with
    /// t = (a - d) cos - (b + e) sin the block [a b; e d] becomes [d + t cos, b + t sin; e + t sin, a - t cos]. `None` about
    /// other axes.
    pub fn turned_about_axis(&mut self, rotation: &Rotation, tensor: &Rotation) -> Option<Rotation> {
        let k =
            (0..3).find(|k| rotation[*k] == self.axis(*k) && (0..3).all(|i| rotation[i][*k] == self.axis(*k)[i]))?;
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let (cos, sin) = (rotation[i][i], rotation[j][i]);
        if rotation[j][j] != cos || rotation[i][j] != self.neg(sin) {
            return None;
        }
        let (a, d) = (tensor[i][i], tensor[j][j]);
        let (difference, sum) = (self.sub(a, d), self.add(tensor[i][j], tensor[j][i]));
        let (along, across) = (self.mul(difference, cos), self.mul(sum, sin));
        let t = self.sub(along, across);
        let (by_cos, by_sin) = (self.mul(t, cos), self.mul(t, sin));
        let mut turned = *tensor;
        turned[i][i] = self.add(d, by_cos);
        turned[j][j] = self.sub(a, by_cos);
        turned[i][j] = self.add(tensor[i][j], by_sin);
        turned[j][i] = self.add(tensor[j][i], by_sin);
        let mut vector = |x: Expr, y: Expr| {
            let terms = [self.mul(cos, x), self.mul(sin, y), self.mul(sin, x), self.mul(cos, y)];
            (self.sub(terms[0], terms[1]), self.add(terms[2], terms[3]))
        };
        (turned[i][k], turned[j][k]) = vector(tensor[i][k], tensor[j][k]);
        (turned[k][i], turned[k][j]) = vector(tensor[k][i], tensor[k][j]);
        Some(turned)
    }

    /// R C Rᵀ of any tensor.
    pub fn turned_both(&mut self, rotation: &Rotation, tensor: &Rotation) -> Rotation {
        if let Some(turned) = self.turned_about_axis(rotation, tensor) {
            return turned;
        }
        // Rows of R C.
        let half: Rotation = std::array::from_fn(|i| self.turned_back(tensor, &rotation[i]));
        std::array::from_fn(|i| std::array::from_fn(|j| self.dot(&half[i], &rotation[j])))
    }

    /// The vector, its components whole.
    pub fn whole_vector(&mut self, a: &Triple) -> Triple {
        a.map(|e| self.whole(e))
    }

    /// The rotation by an angle about a unit axis (Rodrigues): cos 1 + sin n× + (1 - cos) n nᵀ.
    pub fn rotation(&mut self, axis: &Triple, angle: Expr) -> Rotation {
        let (sin, cos) = (self.sin(angle), self.cos(angle));
        let one = self.one();
        let rest = self.sub(one, cos);
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let outer = self.mul(axis[i], axis[j]);
                if i == j {
                    // n_i² + (1 - n_i²) cos
                    let across = self.sub(one, outer);
                    let turned = self.mul(across, cos);
                    return self.add(outer, turned);
                }
                let along = self.mul(rest, outer);
                let k = 3 - i - j;
                let about = self.mul(axis[k], sin);
                // [n]× has -n_k above the diagonal where (i, j, k) is cyclic.
                if (i + 1) % 3 == j { self.sub(along, about) } else { self.add(along, about) }
            })
        })
    }
}
