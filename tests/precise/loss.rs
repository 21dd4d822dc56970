//! What two evaluations in doubles lose of one quantity, over many states.

use super::number::{Big, Number};

/// The errors of a list of components, as the search leaves the code and as it was before.
#[derive(Default)]
pub struct Loss {
    /// The largest component, and the largest error of each of the two: one entry for each state.
    states: Vec<(f64, [f64; 2])>,
}

/// The error with which two evaluations are equally good: a unit in the last place of the largest component. What is
/// written differently is rounded differently, and below this there is nothing but the last rounding.
const UNIT: f64 = 1.0;

impl Loss {
    /// Adds a state.
    pub fn add(&mut self, truth: &[Big], computed: [&[f64]; 2]) {
        let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |most: f64, x| most.max(x.abs()));
        let size = largest(&mut truth.iter().map(Big::to_double));
        let error = |values: &[f64]| {
            let off = values.iter().zip(truth).map(|(x, t)| (Big::from_double(*x) - t.clone()).to_double());
            largest(&mut off.collect::<Vec<_>>().into_iter())
        };
        self.states.push((size, computed.map(error)));
    }

    /// Root mean square, 99 % quantile and maximum of the errors of both, in units of the last place of the largest
    /// component at that state.
    ///
    /// Where the largest component is less than usual, in half of the states, the usual size takes its place: an acceleration
    /// that passes through zero is a difference of what drives a mechanism and what holds it back, each of them of the usual
    /// size, and is known to rounding of these, however it is written.
    fn spread(&self) -> [[f64; 3]; 2] {
        let mut sizes: Vec<f64> = self.states.iter().map(|(size, _)| *size).collect();
        sizes.sort_by(f64::total_cmp);
        let usual = sizes[sizes.len() / 2];
        [0, 1].map(|which| {
            let part = |(size, errors): &(f64, [f64; 2])| errors[which] / (size.max(usual) * f64::EPSILON);
            let mut parts: Vec<f64> = self.states.iter().map(part).collect();
            parts.sort_by(f64::total_cmp);
            let count = parts.len();
            let mean = parts.iter().map(|e| e * e).sum::<f64>() / count as f64;
            [mean.sqrt(), parts[count * 99 / 100], parts[count - 1]]
        })
    }

    /// Prints what the columns of the table are.
    pub fn header(model: &str) {
        println!("{model:23} rms, 99 % quantile, maximum with | without a search | ratio, in units of the last place");
    }

    /// Prints the figures as a row of a table, and gives those by which the first evaluation loses more than so many times
    /// what the second does.
    pub fn judge(&self, what: &str, times: f64) -> Vec<String> {
        let spread = self.spread();
        let ratios = [0, 1, 2].map(|i| spread[0][i] / spread[1][i].max(f64::MIN_POSITIVE));
        let row = |figures: &[f64]| figures.iter().map(|x| format!("{x:8.2}")).collect::<String>();
        println!("   {what:20} {} | {} | {}", row(&spread[0]), row(&spread[1]), row(&ratios));
        let named = ["rms", "99 %", "maximum"].into_iter().zip(spread[0]).zip(spread[1]);
        let worse = named.filter(|((_, simplified), plain)| *simplified > times * plain.max(UNIT));
        worse.map(|((name, simplified), plain)| format!("{what}, {name}: {simplified:.2} and {plain:.2}")).collect()
    }
}

/// The judgement can fail, in each of its figures, and only where the loss is more than allowed.
#[test]
fn a_loss_is_found() {
    let loss = |simplified: &dyn Fn(usize) -> f64| {
        let mut loss = Loss::default();
        for i in 0..1000 {
            let x = 1.0 + i as f64 * 1e-3;
            let off = |units: f64| [x + units * f64::EPSILON, 0.5];
            loss.add(&[Big::from_double(x), Big::from_double(0.5)], [&off(simplified(i)), &off(8.0)]);
        }
        loss.judge("a loss", 2.0)
    };
    assert_eq!(loss(&|_| 15.0), [""; 0]);
    assert_eq!(loss(&|_| 20.0).len(), 3);
    assert_eq!(loss(&|i| if i < 20 { 60.0 } else { 8.0 }).len(), 2);
    assert_eq!(loss(&|i| if i < 1 { 60.0 } else { 8.0 }).len(), 1);
}
