//! The elementary functions of f64 and f32, from std or from libm.

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
