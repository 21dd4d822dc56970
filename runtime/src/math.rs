//! The elementary functions of f64 and f32, from std or from libm; the sine and cosine of a double are our own.

mod sincos;

/// Writes the functions of one float type, from its std methods or from the named functions of libm.
macro_rules! elementary {
    (
        $module:ident, $float:ty, sin_cos by $sin_cos:ident,
        [$($unary:ident by $unary_libm:ident),*],
        [$($binary:ident by $binary_std:ident or $binary_libm:ident),*]
    ) => {
        #[cfg(feature = "std")]
        pub(crate) mod $module {
            #[inline(always)]
            pub(crate) fn sin_cos(x: $float) -> ($float, $float) {
                x.sin_cos()
            }
            $(
                #[inline(always)]
                pub(crate) fn $unary(x: $float) -> $float {
                    x.$unary()
                }
            )*
            $(
                #[inline(always)]
                pub(crate) fn $binary(x: $float, y: $float) -> $float {
                    x.$binary_std(y)
                }
            )*
        }

        #[cfg(all(feature = "libm", not(feature = "std")))]
        pub(crate) mod $module {
            pub(crate) fn sin_cos(x: $float) -> ($float, $float) {
                libm::$sin_cos(x)
            }
            $(
                pub(crate) fn $unary(x: $float) -> $float {
                    libm::$unary_libm(x)
                }
            )*
            $(
                pub(crate) fn $binary(x: $float, y: $float) -> $float {
                    libm::$binary_libm(x, y)
                }
            )*
        }
    };
}

elementary!(
    double, f64, sin_cos by sincos,
    [
        sqrt by sqrt, exp by exp, ln by log, asin by asin, acos by acos, atan by atan, sinh by sinh, cosh by cosh,
        tanh by tanh
    ],
    [atan2 by atan2 or atan2, pow by powf or pow]
);
elementary!(
    single, f32, sin_cos by sincosf,
    [
        sqrt by sqrtf, exp by expf, ln by logf, asin by asinf, acos by acosf, atan by atanf, sinh by sinhf, cosh by coshf,
        tanh by tanhf
    ],
    [atan2 by atan2 or atan2f, pow by powf or powf]
);

/// (sin x, cos x) of a double, within 2 units in the last place.
#[inline(always)]
pub(crate) fn sin_cos(x: f64) -> (f64, f64) {
    if sincos::is_near(x) { sincos::near(x) } else { far(x) }
}

#[cold]
#[inline(never)]
fn far(x: f64) -> (f64, f64) {
    double::sin_cos(x)
}

/// The sines and cosines of several angles at once: what [`Scalar::sin_cos`](crate::Scalar::sin_cos) of a bundle of lanes should
/// call. Bit for bit it gives what the single function gives.
///
/// While no angle exceeds 2^20 in magnitude there is no branch and no call, so that the compiler takes as many lanes together as
/// the target has.
///
/// ```
/// use holonomy::{Scalar, sin_cos_lanes};
///
/// let (sines, cosines) = sin_cos_lanes([0.3, -1.2, 5.0e6, f64::NAN]);
/// assert_eq!((sines[1], cosines[1]), Scalar::sin_cos(-1.2));
/// assert_eq!((sines[2], cosines[2]), Scalar::sin_cos(5.0e6));
/// assert!(sines[3].is_nan() && cosines[3].is_nan());
/// ```
#[inline(always)]
pub fn sin_cos_lanes<const N: usize>(angles: [f64; N]) -> ([f64; N], [f64; N]) {
    let (mut sines, mut cosines) = ([0.0; N], [0.0; N]);
    // Not `all`, which stops at the first.
    if angles.iter().fold(true, |near, x| near & sincos::is_near(*x)) {
        for i in 0..N {
            (sines[i], cosines[i]) = sincos::near(angles[i]);
        }
    } else {
        for i in 0..N {
            (sines[i], cosines[i]) = sin_cos(angles[i]);
        }
    }
    (sines, cosines)
}
