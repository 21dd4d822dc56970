//! The runtime's sine and cosine of doubles against 77 digits: at most 2 units in the last place, everywhere.

#[allow(dead_code, reason = "numbers for programs; sines are needed here")]
#[path = "precise/number.rs"]
mod number;
#[path = "support/splitmix.rs"]
#[allow(dead_code, reason = "not all distributions are needed here")]
mod splitmix;

use holonomy::{Scalar, sin_cos_lanes};
use number::{Big, Number};
use splitmix::SplitMix;

/// Above this the exact reduction serves.
const FAR: f64 = 1_048_576.0;

/// The distance of a result from the exact value, in units in the last place of that.
fn units(found: f64, exact: &Big) -> f64 {
    let nearest = exact.to_double().abs();
    let unit = f64::from_bits(nearest.to_bits() + 1) - nearest;
    (Big::from_double(found) - exact.clone()).to_double().abs() / unit
}

/// The larger error of the two, in units in the last place.
fn error(x: f64) -> f64 {
    let ((sin, cos), (exact_sin, exact_cos)) = (Scalar::sin_cos(x), Big::from_double(x).turn());
    units(sin, &exact_sin).max(units(cos, &exact_cos))
}

fn hold(angles: impl IntoIterator<Item = f64>) {
    let (worst, x) = angles.into_iter().fold((0.0, 0.0), |(worst, at), x| {
        let error = error(x);
        if error > worst || error.is_nan() { (error, x) } else { (worst, at) }
    });
    println!("{worst:.3} units at {x:e}");
    assert!(worst <= 2.0, "{worst} units in the last place at {x:e}");
}

#[test]
fn angles_of_every_size_are_right() {
    let random = &mut SplitMix::new(20);
    hold((0..1_200).map(|_| random.between(-3.2, 3.2)));
    hold((0..1_200).map(|_| random.between(-FAR, FAR)));
    hold((0..600).map(|_| random.between(-30.0, 20.0).exp2()));
    // Where the result is just above a power of two its units are finest relative to the reduced angle.
    hold((0..1_200).map(|i| 0.5 + 0.024 * f64::from(i) / 1_200.0 + std::f64::consts::PI));
}

#[test]
fn next_to_multiples_of_a_quarter_turn_no_digit_is_lost() {
    let multiple = |k: u32| {
        let half =
            Big::from_digits("1.570796326794896619231321691639751442098584699687552910487472296153908203143104499314");
        (half * Big::from_double(f64::from(k))).to_double()
    };
    // Of all doubles up to 2^20 that by 29 quarters comes nearest to a multiple, that by 204551 relative to its size.
    let mut quarters: Vec<u32> = vec![29, 204_551];
    quarters.extend(1..200);
    let random = &mut SplitMix::new(4);
    quarters.extend((0..800).map(|_| random.between(1.0, 667_544.0) as u32));
    hold(quarters.iter().map(|&k| multiple(k)));
    hold(quarters.iter().step_by(4).map(|&k| f64::from_bits(multiple(k).to_bits() + 1)));
    // And half way between them, where the quadrant changes.
    hold(quarters.iter().step_by(4).map(|&k| 0.5 * multiple(2 * k - 1)));
    hold(quarters.iter().step_by(4).map(|&k| -0.5 * multiple(2 * k + 1)));
}

#[test]
fn tiny_angles_and_the_border_of_the_reduction() {
    hold([1e-300, 1e-20, 1e-9, 2.0_f64.powi(-27), 1e-7, -3e-4]);
    let (below, above) = (f64::from_bits(FAR.to_bits() - 1), f64::from_bits(FAR.to_bits() + 1));
    hold([FAR, below, above, -FAR, -above, 3.0 * FAR, 1e15, 1e22]);
    let subnormal = f64::from_bits(3);
    assert_eq!(Scalar::sin_cos(subnormal), (subnormal, 1.0));
}

#[test]
fn signs_and_what_is_no_number() {
    let zeros = [0.0_f64, -0.0].map(|x| Scalar::sin_cos(x).0.to_bits());
    assert_eq!(zeros, [0.0_f64.to_bits(), (-0.0_f64).to_bits()]);
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (sin, cos) = Scalar::sin_cos(x);
        assert!(sin.is_nan() && cos.is_nan(), "{x}");
    }
    let random = &mut SplitMix::new(9);
    for _ in 0..1_000 {
        let x = random.between(0.0, 100.0);
        let ((sin, cos), mirrored) = (Scalar::sin_cos(x), Scalar::sin_cos(-x));
        assert_eq!((-sin, cos), mirrored, "{x:e}");
    }
}

#[test]
fn lanes_give_the_same_bits() {
    let random = &mut SplitMix::new(8);
    for round in 0..500 {
        let mut angles = [0.0_f64; 8].map(|_| random.between(-50.0, 50.0));
        if round % 5 == 0 {
            angles[round % 8] = 1e7;
        }
        let (sines, cosines) = sin_cos_lanes(angles);
        for i in 0..8 {
            assert_eq!((sines[i], cosines[i]), Scalar::sin_cos(angles[i]), "{:e}", angles[i]);
        }
    }
}
