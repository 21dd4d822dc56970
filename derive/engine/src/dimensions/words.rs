//! Dimensions in words.

use super::dimension::{BASE, Dimension, TEN};
use super::units;
use crate::symbolic::Rational;

/// What has a name: powers of kg, m, s, A; the name; the unit, where it is not the product of powers.
const NAMED: [([i64; 4], &str, &str); 24] = [
    ([0, 0, 0, 0], "a pure number", ""),
    ([0, 1, 0, 0], "a length", ""),
    ([1, 0, 0, 0], "a mass", ""),
    ([0, 0, 1, 0], "a time", ""),
    ([0, 1, -1, 0], "a speed", ""),
    ([0, 1, -2, 0], "an acceleration", ""),
    ([0, 0, -1, 0], "an angular speed", ""),
    ([0, 0, -2, 0], "an angular acceleration", ""),
    ([1, 1, -2, 0], "a force", "N"),
    ([1, 2, -2, 0], "a torque or energy", "N*m"),
    ([1, 2, -3, 0], "a power", "W"),
    ([1, 2, 0, 0], "a moment of inertia", ""),
    ([1, 1, 0, 0], "a mass times a length", ""),
    ([1, 0, -2, 0], "a stiffness", "N/m"),
    ([1, 0, -1, 0], "a damping", "N*s/m"),
    ([1, 2, -1, 0], "an angular momentum or angular damping", "N*m*s"),
    ([1, 1, -1, 0], "a momentum", ""),
    ([1, -1, -2, 0], "a pressure", "Pa"),
    ([1, -3, 0, 0], "a density", ""),
    ([0, 2, 0, 0], "an area", ""),
    ([0, 3, 0, 0], "a volume", ""),
    ([0, -1, 0, 0], "a curvature", ""),
    ([0, 0, 0, 1], "a current", ""),
    ([1, 2, -3, -1], "a voltage", "V"),
];

fn name_of(dimension: &Dimension) -> Option<&'static ([i64; 4], &'static str, &'static str)> {
    NAMED.iter().find(|(powers, ..)| {
        (0..BASE.len()).all(|base| dimension.of(base) == Rational::integer(powers.get(base).copied().unwrap_or(0)))
    })
}

/// A known dimension as a unit: `m/s`.
pub fn unit(dimension: &Dimension) -> String {
    let ten = dimension.of(TEN);
    let only = |powers: &[i64; 4]| *powers == [0, 1, 0, 0];
    let (product, scale) = match name_of(dimension) {
        Some((powers, ..)) if only(powers) => match ten.as_integer() {
            Some(-3) => return "mm".to_owned(),
            Some(-2) => return "cm".to_owned(),
            Some(3) => return "km".to_owned(),
            _ => ("m".to_owned(), ten),
        },
        Some(([1, 0, 0, 0], ..)) if ten == Rational::integer(-3) => return "g".to_owned(),
        Some(([0, 0, 1, 0], ..)) if ten == Rational::integer(-3) => return "ms".to_owned(),
        Some((_, _, unit)) if !unit.is_empty() => ((*unit).to_owned(), ten),
        _ => {
            let factors = dimension.known().filter(|(factor, _)| *factor != TEN);
            (units::written(factors.map(|(factor, power)| (BASE[factor].to_owned(), power.clone()))), ten)
        }
    };
    if scale.is_zero() {
        return product;
    }
    let scale = power_of_ten(&scale);
    if product == "1" { scale } else { format!("{scale}*{product}") }
}

/// `10^-3`
fn power_of_ten(power: &Rational) -> String {
    let (over, under) = power.parts();
    if under == "1" { format!("10^{over}") } else { format!("10^({over}/{under})") }
}

/// A known dimension in words: "a speed (m/s)".
pub fn words(dimension: &Dimension) -> String {
    let unit = unit(dimension);
    match name_of(dimension) {
        Some((_, name, _)) if unit == "1" => (*name).to_owned(),
        Some((_, name, _)) => format!("{name} ({unit})"),
        None => format!("something in {unit}"),
    }
}
