//! What the search for cheaper forms does to rounding: the emitted code of the reference models, and what is emitted without a
//! search, against an evaluation with 77 digits.
//!
//! The programs of both forms are walked over any number. Over doubles the walk gives bit for bit what the emitted code gives,
//! at every state; over long floats both give the same, which proves once more that the search changed no equation, and tells
//! what the doubles should have been. At 1,000 states the search may lose at most twice of what is lost without it.

#[path = "models/bicycle.rs"]
mod bicycle;
#[path = "models/chains.rs"]
mod chains;
#[path = "models/linkages.rs"]
mod linkages;
#[path = "models/particles.rs"]
mod particles;
mod precise;
#[path = "models/rolling_disk.rs"]
mod rolling_disk;
mod support;

use holonomy::ConstrainedSystem;
use precise::Choice::{Between, Further};
use precise::{Big, Choice, Draw, Number, Subject};
use serde_json::Value;
use support::golden::{list, parse, picked, text};
use support::splitmix::SplitMix;

/// A model from its parameters in the order of its fields.
macro_rules! subject {
    ($source:literal, $module:ident::$model:ident($($field:ident),*)) => {
        Subject::new(include_str!($source), |p| {
            let mut p = p.iter().copied();
            $module::$model { $($field: p.next().expect("a parameter")),* }
        })
    };
}

const ANY: Choice = Between(-3.2, 3.2);

/// cos theta, by which the kinematics divide, is at least 0.36.
const LEANING: Choice = Between(-1.2, 1.2);

#[test]
fn the_rolling_disk_in_three_formulations() {
    let all = [("x", ANY), ("y", ANY), ("phi", ANY), ("theta", LEANING), ("psi", ANY)];
    let draw = Draw { coordinates: &all, speeds: &[(-5.0, 5.0); 3] };
    subject!("models/rolling_disk.rs", rolling_disk::RollingDisk(m, r, j, g)).examine(&draw);
    subject!("models/rolling_disk.rs", rolling_disk::RollingDiskInStages(m, r, j, g)).examine(&draw);
    let draw = Draw { speeds: &[(-5.0, 5.0); 5], ..draw };
    subject!("models/rolling_disk.rs", rolling_disk::SlidingDisk(m, r, j, g)).examine(&draw);
}

#[test]
fn chains_of_pendulums() {
    let draw = Draw { coordinates: &[("a1", ANY), ("a2", ANY)], speeds: &[(-5.0, 5.0); 2] };
    subject!("models/particles.rs", particles::DoublePendulum(m1, m2, l1, l2, g)).examine(&draw);
    const ANGLES: [&str; 10] = ["a_0", "a_1", "a_2", "a_3", "a_4", "a_5", "a_6", "a_7", "a_8", "a_9"];
    let draw = Draw { coordinates: &ANGLES.map(|a| (a, ANY)), speeds: &[(-5.0, 5.0); 10] };
    subject!("models/chains.rs", chains::TenPendulums(m, l, g)).examine(&draw);
}

fn four_bar() -> Subject<linkages::FourBar> {
    subject!("models/linkages.rs", linkages::FourBar(l1, l2, l3, d, m1, m2, m3, g, tau))
}

fn andrews() -> Subject<linkages::Andrews> {
    subject!(
        "models/linkages.rs",
        linkages::Andrews(
            m1, m2, m3, m4, m5, m6, m7, i1, i2, i3, i4, i5, i6, i7, xa, ya, xb, yb, xc, yc, d, da, e, ea, zf, zt, fa,
            rr, ra, ss, sa, sb, sc, sd, ta, tb, u, ua, ub, c0, l0, mom
        )
    )
}

#[test]
fn loops_in_the_plane() {
    four_bar().examine(&Draw { coordinates: &[("q1", Further(0.2))], speeds: &[(-10.0, 10.0)] });
    andrews().examine(&Draw { coordinates: &[("beta", Further(0.2))], speeds: &[(-200.0, 200.0)] });
}

#[test]
fn the_bicycle() {
    let leaning = [("psi", ANY), ("phi", Between(-0.4, 0.4)), ("delta", Between(-0.5, 0.5))];
    let draw = Draw { coordinates: &leaning, speeds: &[(-1.0, 1.0), (-1.0, 1.0), (-25.0, -5.0)] };
    subject!(
        "models/bicycle.rs",
        bicycle::Bicycle(
            g, rr, rf, d1, d2, d3, l1, l2, l3, l4, mr, mb, mh, mf, irx, iry, ibx, iby, ibz, ibxz, ihx, ihy, ihz, ihxz,
            ifx, ify
        )
    )
    .examine(&draw);
}

/// The long floats are what they are said to be, their sines and cosines among them.
#[test]
fn long_floats_have_their_digits() {
    let close = |a: Big, b: Big| assert!((a.clone() - b.clone()).to_double().abs() < 1e-58, "{a:?} {b:?}");
    let one = Big::from_double(1.0);
    // to 60 digits by mpmath
    close(one.turn().0, Big::from_digits("0.841470984807896506652502321630298999622563060798371065672752"));
    close(
        Big::from_double(2.0).root(),
        Big::from_digits("1.41421356237309504880168872420969807856967187537694807317668"),
    );
    let (sin, cos) = Big::from_double(1000.0).turn();
    close(sin, Big::from_digits("0.826879540532002560255887429109218141212724967847788320908123"));
    close(cos, Big::from_digits("0.562379076290702991078249226605395968755811821738196917702825"));
    let random = &mut SplitMix::new(1);
    for _ in 0..100 {
        let x = Big::from_double(random.between(-10.0, 10.0));
        let (sin, cos) = x.turn();
        close(sin.clone() * sin + cos.clone() * cos, one.clone());
        close(x.clone() / Big::from_double(3.0) * Big::from_double(3.0), x);
    }
    // A double is exactly itself, a decimal is not a double.
    close(Big::from_digits("0.1000000000000000055511151231257827021181583404541015625"), Big::from_double(0.1));
    assert_ne!(Big::from_digits("0.1"), Big::from_double(0.1));
}

/// Accelerations over long floats, against golden data of 25 digits.
fn all_digits<M: ConstrainedSystem>(subject: &Subject<M>, golden: &Value, speed: &str) {
    for row in list(&golden["states"]) {
        let point = picked(row, &["q", speed]);
        let expected: Vec<Big> = list(&row["qdd_digits"]).iter().map(|digits| Big::from_digits(text(digits))).collect();
        let size = expected.iter().fold(0.0, |most: f64, x| most.max(x.to_double().abs()));
        for (form, _, bigs) in &subject.forms {
            let rates = form.run("velocity_rates", bigs, &point);
            assert_eq!(rates.len(), expected.len());
            for (a, b) in rates.iter().zip(&expected) {
                let off = (a.clone() - b.clone()).to_double().abs();
                assert!(off <= 1e-24 * size, "{}: {off:e} of {size:e} at {point:?}", M::MODEL.name);
            }
        }
    }
}

#[test]
fn all_digits_of_golden_data_are_met() {
    all_digits(&four_bar(), &parse(include_str!("data/four_bar.json")), "u1");
    all_digits(&andrews(), &parse(include_str!("data/andrews_states.json")), "v1");
}
