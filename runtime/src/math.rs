//! The elementary functions of f64 and f32, from std or from libm.

/// Writes the functions of one float type, from its std methods or from the named functions of libm.
macro_rules! elementary {
    ($module:ident, $float:ty, $sqrt:ident, $sin_cos:ident, $atan2:ident, $exp:ident, $ln:ident, $pow:ident) => {
        #[cfg(feature = "std")]
        pub(crate) mod $module {
            #[inline(always)]
            pub(crate) fn sqrt(x: $float) -> $float {
                x.sqrt()
            }
            #[inline(always)]
            pub(crate) fn sin_cos(x: $float) -> ($float, $float) {
                x.sin_cos()
            }
            #[inline(always)]
            pub(crate) fn atan2(y: $float, x: $float) -> $float {
                y.atan2(x)
            }
            #[inline(always)]
            pub(crate) fn exp(x: $float) -> $float {
                x.exp()
            }
            #[inline(always)]
            pub(crate) fn ln(x: $float) -> $float {
                x.ln()
            }
            #[inline(always)]
            #[allow(dead_code)]
            pub(crate) fn pow(x: $float, exponent: $float) -> $float {
                x.powf(exponent)
            }
        }

        #[cfg(all(feature = "libm", not(feature = "std")))]
        pub(crate) mod $module {
            pub(crate) fn sqrt(x: $float) -> $float {
                libm::$sqrt(x)
            }
            pub(crate) fn sin_cos(x: $float) -> ($float, $float) {
                libm::$sin_cos(x)
            }
            pub(crate) fn atan2(y: $float, x: $float) -> $float {
                libm::$atan2(y, x)
            }
            pub(crate) fn exp(x: $float) -> $float {
                libm::$exp(x)
            }
            pub(crate) fn ln(x: $float) -> $float {
                libm::$ln(x)
            }
            #[allow(dead_code)]
            pub(crate) fn pow(x: $float, exponent: $float) -> $float {
                libm::$pow(x, exponent)
            }
        }
    };
}

elementary!(double, f64, sqrt, sincos, atan2, exp, log, pow);
elementary!(single, f32, sqrtf, sincosf, atan2f, expf, logf, powf);
