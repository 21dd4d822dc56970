//! The names of units, and what they measure.

use super::dimension::{BASE, Dimension, TEN};
use crate::symbolic::Rational;
use crate::syntax::{Diagnostics, Unit, did_you_mean, messages, nearest};

/// Units by kg, m, s, A, and a power of ten, besides the base units.
const DERIVED: [(&str, [i64; 5]); 13] = [
    ("g", [1, 0, 0, 0, -3]),
    ("N", [1, 1, -2, 0, 0]),
    ("J", [1, 2, -2, 0, 0]),
    ("W", [1, 2, -3, 0, 0]),
    ("Pa", [1, -1, -2, 0, 0]),
    ("Hz", [0, 0, -1, 0, 0]),
    ("C", [0, 0, 1, 1, 0]),
    ("V", [1, 2, -3, -1, 0]),
    ("Ohm", [1, 2, -3, -2, 0]),
    ("F", [-1, -2, 4, 2, 0]),
    ("Wb", [1, 2, -2, -1, 0]),
    ("T", [1, 0, -2, -1, 0]),
    ("H", [1, 2, -2, -2, 0]),
];

/// Pure numbers.
const PURE: [&str; 2] = ["rad", "sr"];

/// Powers of ten before the name of a unit.
const PREFIXES: [(&str, i64); 9] =
    [("G", 9), ("M", 6), ("k", 3), ("h", 2), ("d", -1), ("c", -2), ("m", -3), ("u", -6), ("n", -9)];

/// Units that are no powers of ten of the others, with what to write.
const REFUSED: [(&str, &str); 11] = [
    ("deg", "angles are in radians: `rad`"),
    ("degree", "angles are in radians: `rad`"),
    ("degrees", "angles are in radians: `rad`"),
    ("rpm", "write `rad/s`"),
    ("min", "write `s`"),
    ("h", "write `s`"),
    ("day", "write `s`"),
    ("inch", "write `m`"),
    ("ft", "write `m`"),
    ("lb", "write `kg`"),
    ("lbf", "write `N`"),
];

/// What a name measures.
fn named(name: &str) -> Option<Dimension> {
    if let Some(base) = BASE.iter().position(|base| *base == name) {
        return Some(Dimension::base(base));
    }
    if PURE.contains(&name) {
        return Some(Dimension::pure());
    }
    DERIVED.iter().find(|(derived, _)| *derived == name).map(|(_, [mass, length, time, current, ten])| {
        let electric = Dimension::base(3).powi(*current).times(&Dimension::base(TEN).powi(*ten));
        Dimension::mechanical(*mass, *length, *time).times(&electric)
    })
}

/// The same, with a prefix perhaps.
fn measured(name: &str) -> Option<Dimension> {
    if REFUSED.iter().any(|(refused, _)| *refused == name) {
        return None;
    }
    named(name).or_else(|| {
        PREFIXES.iter().find_map(|(prefix, power)| {
            let rest = name.strip_prefix(prefix).filter(|rest| *rest != "kg" && !PURE.contains(rest))?;
            Some(named(rest)?.times(&Dimension::base(TEN).powi(*power)))
        })
    })
}

/// What a unit measures; `None` where a name in it is reported.
pub fn dimension(unit: &Unit, diagnostics: &mut Diagnostics) -> Option<Dimension> {
    let mut known = true;
    for (name, span) in &unit.names {
        if measured(name).is_none() {
            known = false;
            let message = match REFUSED.iter().find(|(refused, _)| refused == name) {
                Some((_, instead)) => messages::unit_refused(name, instead),
                None => messages::unit_unknown(name, did_you_mean(suggestion(name))),
            };
            diagnostics.report(*span, message);
        }
    }
    if !known {
        return None;
    }
    let factors = unit.factors.iter().filter_map(|(name, power)| Some(measured(name)?.powi(i64::from(*power))));
    Some(factors.fold(Dimension::pure(), |product, factor| product.times(&factor)))
}

/// The unit that was meant: by its full name, or by a slip.
fn suggestion(name: &str) -> Option<&'static str> {
    const SPELT: [(&str, &str); 20] = [
        ("meter", "m"),
        ("metre", "m"),
        ("meters", "m"),
        ("second", "s"),
        ("seconds", "s"),
        ("sec", "s"),
        ("kilogram", "kg"),
        ("kilo", "kg"),
        ("Kg", "kg"),
        ("newton", "N"),
        ("joule", "J"),
        ("watt", "W"),
        ("pascal", "Pa"),
        ("hertz", "Hz"),
        ("radian", "rad"),
        ("radians", "rad"),
        ("volt", "V"),
        ("ohm", "Ohm"),
        ("Nm", "N*m"),
        ("Ns", "N*s"),
    ];
    let spelt = SPELT.iter().find(|(spelt, _)| *spelt == name).map(|(_, unit)| *unit);
    let names =
        BASE.into_iter().chain(PURE).chain(DERIVED.iter().map(|(name, _)| *name)).chain(["mm", "cm", "km", "ms"]);
    spelt.or_else(|| nearest(name, names))
}

/// A unit as it is written: `kg*m/s/s`; high and broken powers as `m^(1/2)`.
pub fn written(factors: impl IntoIterator<Item = (String, Rational)>) -> String {
    let (mut above, mut below) = (Vec::new(), String::new());
    for (name, power) in factors {
        match power.as_integer() {
            Some(times @ 1..=3) => above.extend((0..times).map(|_| name.clone())),
            Some(times @ -3..=-1) => (times..0).for_each(|_| below.push_str(&format!("/{name}"))),
            Some(power @ 0..) => above.push(format!("{name}^{power}")),
            Some(power) => above.push(format!("{name}^({power})")),
            None => {
                let (over, under) = power.parts();
                above.push(format!("{name}^({over}/{under})"));
            }
        }
    }
    let above = if above.is_empty() { "1".to_owned() } else { above.join("*") };
    above + &below
}
