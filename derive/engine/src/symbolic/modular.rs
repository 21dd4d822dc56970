//! Arithmetic modulo a prime of 61 bits.

use super::Rational;
use num_traits::ToPrimitive;

/// The two primes: 2^61 - 1 and 2^61 - 45, both 3 modulo 4, so that a root of a residue a is a^((p+1)/4).
pub const PRIMES: [u64; 2] = [(1 << 61) - 1, (1 << 61) - 45];

/// The integers modulo a prime.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Field(pub u64);

impl Field {
    /// a + b.
    pub fn add(self, a: u64, b: u64) -> u64 {
        let sum = a + b;
        if sum >= self.0 { sum - self.0 } else { sum }
    }

    /// -a.
    pub fn neg(self, a: u64) -> u64 {
        if a == 0 { 0 } else { self.0 - a }
    }

    /// a·b: both primes are 2^61 - c with a small c, so the upper half folds back with a multiplication.
    pub fn mul(self, a: u64, b: u64) -> u64 {
        let product = a as u128 * b as u128;
        let c = (1u64 << 61) - self.0;
        let folded = (product >> 61) * c as u128 + (product & ((1 << 61) - 1));
        let again = (folded >> 61) as u64 * c + (folded as u64 & ((1 << 61) - 1));
        let mut r = again;
        while r >= self.0 {
            r -= self.0;
        }
        r
    }

    /// a^n.
    pub fn pow(self, a: u64, mut n: u64) -> u64 {
        let (mut result, mut square) = (1, a);
        while n > 0 {
            if n & 1 == 1 {
                result = self.mul(result, square);
            }
            square = self.mul(square, square);
            n >>= 1;
        }
        result
    }

    /// 1/a; `None` for zero. Extended Euclid.
    pub fn recip(self, a: u64) -> Option<u64> {
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

    /// A square root, if there is one.
    pub fn sqrt(self, a: u64) -> Option<u64> {
        let root = self.pow(a, (self.0 + 1) / 4);
        (self.mul(root, root) == a).then_some(root)
    }

    /// An integer.
    pub fn integer(self, n: i64) -> u64 {
        let r = n.unsigned_abs() % self.0;
        if n < 0 { self.neg(r) } else { r }
    }

    /// A rational number; `None` where the prime divides its denominator.
    pub fn rational(self, value: &Rational) -> Option<u64> {
        match value {
            Rational::Small(n, 1) => Some(self.integer(*n)),
            Rational::Small(n, d) => Some(self.mul(self.integer(*n), self.recip(self.integer(*d))?)),
            Rational::Big(big) => {
                let p = num_bigint::BigInt::from(self.0);
                let residue = |x: &num_bigint::BigInt| (((x % &p) + &p) % &p).to_u64();
                Some(self.mul(residue(big.numer())?, self.recip(residue(big.denom())?)?))
            }
        }
    }

    /// A residue drawn from a key: splitmix64, the same on every machine.
    pub fn draw(self, key: u64) -> u64 {
        mix(key) % self.0
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
                assert_eq!(f.mul(a, b), (a as u128 * b as u128 % p as u128) as u64);
                assert_eq!(f.mul(a, f.recip(a).unwrap()), 1);
                assert_eq!(f.add(a, f.neg(a)), 0);
                let square = f.mul(a, a);
                let root = f.sqrt(square).unwrap();
                assert!(root == a || root == f.neg(a));
            }
            assert_eq!(f.mul(p - 1, p - 1), 1);
            assert_eq!(f.rational(&Rational::Small(-1, 2)), Some((p - 1) / 2));
        }
    }
}
