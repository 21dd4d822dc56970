//! Arithmetic modulo a prime of 61 bits, with a square root of -1.

use super::Rational;
use num_traits::ToPrimitive;

/// The two primes: 2^61 - 1 and 2^61 - 45, both 3 modulo 4, so that -1 has no root and a residue a has a^((p+1)/4).
pub const PRIMES: [u64; 2] = [(1 << 61) - 1, (1 << 61) - 45];

/// A number of the field with p² elements, re + i·im with i² = -1 (p is 3 modulo 4). Almost all have no second part; it
/// is there so that every number of the smaller field has a square root.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Element {
    /// The part in the field with p elements.
    pub re: u64,
    /// The factor of i.
    pub im: u64,
}

impl Element {
    /// Zero.
    pub const ZERO: Element = Element::real(0);
    /// One.
    pub const ONE: Element = Element::real(1);

    /// A number of the field with p elements.
    pub const fn real(re: u64) -> Self {
        Element { re, im: 0 }
    }

    /// Whether this is zero.
    pub fn is_zero(self) -> bool {
        self == Element::ZERO
    }

    /// A key for drawing what depends on this value.
    pub fn key(self) -> u64 {
        if self.im == 0 { self.re } else { mix(self.re) ^ mix(!self.im) }
    }
}

/// The field with p² elements for a prime p of [`PRIMES`].
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Field(pub u64);

impl Field {
    /// a + b.
    pub fn add(self, a: Element, b: Element) -> Element {
        Element { re: self.plus(a.re, b.re), im: self.plus(a.im, b.im) }
    }

    /// -a.
    pub fn neg(self, a: Element) -> Element {
        Element { re: self.minus(a.re), im: self.minus(a.im) }
    }

    /// a·b.
    pub fn mul(self, a: Element, b: Element) -> Element {
        if a.im == 0 && b.im == 0 {
            return Element::real(self.times(a.re, b.re));
        }
        let re = self.plus(self.times(a.re, b.re), self.minus(self.times(a.im, b.im)));
        Element { re, im: self.plus(self.times(a.re, b.im), self.times(a.im, b.re)) }
    }

    /// a^n.
    pub fn pow(self, a: Element, mut n: u64) -> Element {
        let (mut result, mut square) = (Element::ONE, a);
        while n > 0 {
            if n & 1 == 1 {
                result = self.mul(result, square);
            }
            n >>= 1;
            if n > 0 {
                square = self.mul(square, square);
            }
        }
        result
    }

    /// 1/a; `None` for zero.
    pub fn recip(self, a: Element) -> Option<Element> {
        if a.im == 0 {
            return self.inverse(a.re).map(Element::real);
        }
        let norm = self.inverse(self.norm(a))?;
        Some(Element { re: self.times(a.re, norm), im: self.times(self.minus(a.im), norm) })
    }

    /// A square root, if there is one; there always is where a has no second part.
    pub fn sqrt(self, a: Element) -> Option<Element> {
        if a.im == 0 {
            return match self.root(a.re) {
                Some(root) => Some(Element::real(root)),
                None => self.root(self.minus(a.re)).map(|im| Element { re: 0, im }),
            };
        }
        // (re + i im)² = a: re² = (a.re ± √norm)/2, im = a.im/(2 re).
        let norm = self.root(self.norm(a))?;
        let half = self.inverse(2)?;
        let candidates = [self.plus(a.re, norm), self.plus(a.re, self.minus(norm))];
        let re = candidates.into_iter().find_map(|twice| self.root(self.times(twice, half)))?;
        let im = self.times(self.times(a.im, half), self.inverse(re)?);
        Some(Element { re, im })
    }

    /// An integer.
    pub fn integer(self, n: i64) -> Element {
        let r = n.unsigned_abs() % self.0;
        Element::real(if n < 0 { self.minus(r) } else { r })
    }

    /// A rational number; `None` where the prime divides its denominator.
    pub fn rational(self, value: &Rational) -> Option<Element> {
        match value {
            Rational::Small(n, 1) => Some(self.integer(*n)),
            Rational::Small(n, d) => Some(self.mul(self.integer(*n), self.recip(self.integer(*d))?)),
            Rational::Big(big) => {
                let p = num_bigint::BigInt::from(self.0);
                let residue = |x: &num_bigint::BigInt| (((x % &p) + &p) % &p).to_u64().map(Element::real);
                Some(self.mul(residue(big.numer())?, self.recip(residue(big.denom())?)?))
            }
        }
    }

    /// A number of the smaller field drawn from a key: splitmix64, the same on every machine.
    pub fn draw(self, key: u64) -> Element {
        Element::real(mix(key) % self.0)
    }

    fn plus(self, a: u64, b: u64) -> u64 {
        let sum = a + b;
        if sum >= self.0 { sum - self.0 } else { sum }
    }

    fn minus(self, a: u64) -> u64 {
        if a == 0 { 0 } else { self.0 - a }
    }

    /// Both primes are 2^61 - c with a small c, so the upper half folds back with a multiplication.
    fn times(self, a: u64, b: u64) -> u64 {
        let product = a as u128 * b as u128;
        let c = (1u64 << 61) - self.0;
        let folded = (product >> 61) * c as u128 + (product & ((1 << 61) - 1));
        let mut r = (folded >> 61) as u64 * c + (folded as u64 & ((1 << 61) - 1));
        while r >= self.0 {
            r -= self.0;
        }
        r
    }

    fn norm(self, a: Element) -> u64 {
        self.plus(self.times(a.re, a.re), self.times(a.im, a.im))
    }

    /// Extended Euclid.
    fn inverse(self, a: u64) -> Option<u64> {
        if a == 0 {
            return None;
        }
        let (mut r0, mut r1) = (self.0 as i64, a as i64);
        let (mut s0, mut s1) = (0i64, 1i64);
        while r1 != 0 {
            let q = r0 / r1;
            (r0, r1) = (r1, r0 - q * r1);
            (s0, s1) = (s1, s0 - q * s1);
        }
        Some(if s0 < 0 { (s0 + self.0 as i64) as u64 } else { s0 as u64 })
    }

    /// A root in the smaller field: a^((p+1)/4), if its square is a.
    fn root(self, a: u64) -> Option<u64> {
        let root = self.pow(Element::real(a), self.0.div_ceil(4)).re;
        (self.times(root, root) == a).then_some(root)
    }
}

/// One step of splitmix64.
pub fn mix(key: u64) -> u64 {
    let mut z = key.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_prime(n: u64) -> bool {
        // Miller-Rabin with the first twelve primes decides below 3.3e24.
        let (mut d, mut r) = (n - 1, 0);
        while d % 2 == 0 {
            d /= 2;
            r += 1;
        }
        let mul = |a: u64, b: u64| (a as u128 * b as u128 % n as u128) as u64;
        let pow = |mut a: u64, mut e: u64| {
            let mut x = 1;
            while e > 0 {
                if e & 1 == 1 {
                    x = mul(x, a);
                }
                a = mul(a, a);
                e >>= 1;
            }
            x
        };
        [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37].into_iter().all(|a| {
            let mut x = pow(a, d);
            if x == 1 || x == n - 1 {
                return true;
            }
            (1..r).any(|_| {
                x = mul(x, x);
                x == n - 1
            })
        })
    }

    #[test]
    fn the_moduli_are_primes_that_are_three_modulo_four() {
        for p in PRIMES {
            assert!(is_prime(p) && p % 4 == 3, "{p}");
        }
    }

    #[test]
    fn the_field_axioms_hold_on_samples() {
        for p in PRIMES {
            let f = Field(p);
            for k in 0..200u64 {
                let (a, b) = (f.draw(3 * k), f.draw(3 * k + 1));
                assert_eq!(f.mul(a, b).re, (a.re as u128 * b.re as u128 % p as u128) as u64);
                let c = Element { re: a.re, im: if k % 2 == 0 { 0 } else { b.re } };
                assert_eq!(f.mul(c, f.recip(c).unwrap()), Element::ONE);
                assert_eq!(f.add(c, f.neg(c)), Element::ZERO);
                let square = f.mul(c, c);
                let root = f.sqrt(square).unwrap();
                assert!(root == c || root == f.neg(c));
                // Residue or not, every number of the smaller field has a root.
                let root = f.sqrt(b).unwrap();
                assert_eq!(f.mul(root, root), b);
            }
            assert_eq!(f.rational(&Rational::Small(-1, 2)), Some(Element::real((p - 1) / 2)));
        }
    }
}
