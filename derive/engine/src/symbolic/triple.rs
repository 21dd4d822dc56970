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
