//! Sine and cosine of a double, together, in line.
//!
//! Beside the rest of a small model a pair of these is the largest cost, and as a call it keeps the compiler from mixing its
//! instructions with the others. Nothing here branches on the angle but for its size, so that it also runs on lanes.
//!
//! A build for machines that fuse products with sums does so here: a pair then waits for 45 cycles instead of 75. Its last bits are not
//! those of a build for all machines, but a build has the same bits wherever it runs.

use core::f64::consts::{FRAC_2_PI, FRAC_PI_2};

/// Beyond this angle the reduction below has too few bits, and the exact one of std or libm serves.
const FAR: f64 = 1_048_576.0;

/// 3/2 2⁵²: a double of this size has no bits after the point, so that adding it rounds to the nearest whole number, whose last
/// bits are those of the sum. It needs no `floor`, which is a call on targets without SSE4.1.
const TO_WHOLE: f64 = 6_755_399_441_055_744.0;

/// π/2 in parts of 33 bits, each the nearest to what those before it leave, and a rest: times a whole number of up to 20 bits
/// the parts are exact (W. J. Cody, W. Waite, Software Manual for the Elementary Functions, 1980, chapter 8). Of all doubles up
/// to [`FAR`] those nearest to a multiple of π/2 miss it by 2⁻⁶⁰; the rest carries the reduction to 2⁻¹³⁷.
const QUARTER: [f64; 4] =
    [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_711_166_5e-21, 8.478_427_660_368_9e-32];

/// π/2 in parts of 53 bits, each the nearest to what those before it leave, for fused products.
///
/// x − q P₁ is exact, since nothing of it is finer than x or P₁, and so is the product in each later step; both round once. Only where the
/// second step leaves less than its rounding does the third one tell.
const FUSED: [f64; 3] = [FRAC_PI_2, 6.123_233_995_736_766e-17, -1.497_384_904_859_169_8e-33];

/// Whether products are fused with sums: where it is an instruction.
const FUSES: bool = cfg!(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")));

/// sin r = r + r z S(z) with z = r², |r| ≤ π/4: the polynomial with the least relative error of the sine, by Remez' exchange
/// over (sin √z/√z − 1)/z with 60 digits, then rounded to doubles. It errs by 2⁻⁵⁷·⁹ before and 2⁻⁵⁶·³ after rounding.
const SINE: [f64; 6] = [
    -0.166_666_666_666_666_3,
    0.008_333_333_333_322_118,
    -0.000_198_412_698_295_895_28,
    2.755_731_362_138_279_6e-6,
    -2.505_074_776_244_754e-8,
    1.589_623_013_622_253e-10,
];

/// cos r = 1 − z/2 + z² C(z), likewise over (cos √z − 1 + z/2)/z². It errs by 2⁻⁶³·⁹ before and 2⁻⁵⁹·⁶ after rounding.
const COSINE: [f64; 6] = [
    0.041_666_666_666_666_595,
    -0.001_388_888_888_887_305_6,
    2.480_158_728_885_172_8e-5,
    -2.755_731_417_930_267e-7,
    2.087_570_084_272_279e-9,
    -1.135_853_655_749_938_8e-11,
];

/// Whether the reduction here serves; not for what is infinite or no number.
#[inline(always)]
pub(super) fn is_near(x: f64) -> bool {
    x.abs() <= FAR
}

/// (sin x, cos x) where x [is near](is_near), each within 2 units in the last place; sin −x = −sin x to the bit, zero included.
// Without optimisation copies would only cost time to compile.
#[cfg_attr(debug_assertions, inline)]
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn near(x: f64) -> (f64, f64) {
    let sign = x.to_bits() & SIGN;
    let (r, quarters, whole) = reduce(x.abs());
    let z = r * r;
    let s = fused(r * z, polynomial(&SINE, z), r);
    let c = fused(z * z, polynomial(&COSINE, z), 1.0 - 0.5 * z);
    // A comparison of floats selects without a branch; one of integers would not.
    let half = 0.5 * quarters;
    let is_even = (half + TO_WHOLE) - TO_WHOLE == half;
    let (sin, cos) = if is_even { (s, c) } else { (c, s) };
    // Quarters 2 and 3 turn the sine, 1 and 2 the cosine.
    let (sin_sign, cos_sign) = ((whole & 2) << 62, (whole.wrapping_add(1) & 2) << 62);
    (f64::from_bits(sin.to_bits() ^ sin_sign ^ sign), f64::from_bits(cos.to_bits() ^ cos_sign))
}

const SIGN: u64 = 1 << 63;

/// r = x − q π/2 with the nearest whole q, q, and a number whose last bits are those of q.
#[inline(always)]
fn reduce(x: f64) -> (f64, f64, u64) {
    let shifted = fused(x, FRAC_2_PI, TO_WHOLE);
    let q = shifted - TO_WHOLE;
    if FUSES {
        let r = FUSED.iter().fold(x, |r, part| fused(-q, *part, r));
        return (r, q, shifted.to_bits());
    }
    let [first, second, third, rest] = QUARTER;
    // Exact; so are the next two products. Their sum is not, and what it lost is taken off at last, so that r is rounded once
    // where it is large, and nowhere where nearly all cancels.
    let a = x - q * first;
    let (b, c) = (q * second, q * third);
    let small = b + c;
    let lost = ((b - small) + c) + q * rest;
    ((a - small) - lost, q, shifted.to_bits())
}

/// In pairs (G. Estrin, 1960), which wait less for each other than Horner's rule.
#[inline(always)]
fn polynomial(p: &[f64; 6], z: f64) -> f64 {
    let square = z * z;
    let [low, middle, high] = [fused(p[1], z, p[0]), fused(p[3], z, p[2]), fused(p[5], z, p[4])];
    fused(square, fused(square, high, middle), low)
}

/// a b + c, rounded once where that is an instruction.
#[inline(always)]
fn fused(a: f64, b: f64, c: f64) -> f64 {
    #[cfg(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")))]
    return a.mul_add(b, c);
    #[cfg(not(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64"))))]
    return a * b + c;
}
