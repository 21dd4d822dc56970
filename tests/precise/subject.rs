//! A model in both forms: as it is emitted, and as it is emitted without a search.

use super::form::{Form, Point};
use super::loss::Loss;
use super::number::Big;
use super::states::{Draw, regular};
use crate::support::declared;
use crate::support::running::entries;
use crate::support::splitmix::SplitMix;
use holonomy::{ConstrainedSystem, Prepared, Vector};
use holonomy_engine::simplify::Search;
use oracle::{Declaration, read_models};

/// States of each model, ...
const STATES: usize = 1000;
/// ... out of so many on its constraints, ...
const DRAWN: usize = 1500;
/// ... of those at which every guard of both forms is this part of the largest that it has.
const REGULAR: f64 = 0.1;
/// At one of so many states the cheaper form is evaluated with all digits as well.
const PROVEN: usize = 10;
/// How much more may be lost than without a search.
const TIMES: f64 = 2.0;

/// A declared model, prepared, and its programs.
pub struct Subject<M: ConstrainedSystem> {
    declared: Declaration,
    model: Prepared<M>,
    /// With the search and without, each with what it prepares over both numbers.
    pub forms: [(Form, Vec<f64>, Vec<Big>); 2],
}

impl<M: ConstrainedSystem> Subject<M> {
    /// The model of a source text with its nominal parameters.
    ///
    /// # Panics
    /// If it is not there, or if a parameter has no nominal value.
    pub fn new(source: &str, build: impl Fn(&[f64]) -> M) -> Self {
        let name = M::MODEL.name;
        let declared = read_models(source).into_iter().find(|d| d.name == name).expect("it is declared");
        let item = declared::models(source).into_iter().find(|item| item.ident == name).expect("it is declared");
        let model = build(&declared.nominal()).prepare().expect("the parameters are good");
        let value = |field: &str| {
            let found = declared.parameters.iter().find(|(parameter, _)| parameter == field);
            found.and_then(|(_, value)| *value).expect("a parameter with a nominal value")
        };
        let forms = [Search::Full, Search::Off].map(|search| {
            let form = Form::new(&item, search);
            let (doubles, bigs) = (form.prepared(&value), form.prepared(&value));
            (form, doubles, bigs)
        });
        Self { declared, model, forms }
    }

    /// The states that count.
    fn points(&self, draw: &Draw<'_>) -> Vec<Point> {
        let names = M::MODEL.state_coordinates;
        let start = names.iter().map(|x| self.declared.start.get(*x).copied().unwrap_or(0.0)).collect();
        let random = &mut SplitMix::new(50);
        let mut points: Vec<Point> = vec![start];
        for at in 0..DRAWN {
            points.push(draw.next(&self.model, &points[at][..names.len()], random));
        }
        points.remove(0);
        let figures =
            |p: &Point| self.forms.iter().flat_map(|(form, doubles, _)| form.run("guards", doubles, p)).collect();
        let mut points = regular(points, REGULAR, figures);
        assert!(points.len() >= STATES, "{}: {} regular states", M::MODEL.name, points.len());
        points.truncate(STATES);
        points
    }

    /// The results of a function of the emitted code.
    fn emitted(&self, function: &str, point: &Point) -> Vec<f64> {
        let s = M::State::<f64>::from_fn(|i| point[i]);
        let inputs = M::Inputs::from_fn(|_| 0.0);
        match function {
            "multipliers" => entries(&self.model.multipliers(0.0, &s, &inputs)),
            _ => {
                let (rate, guards) = self.model.derivative(0.0, &s, &inputs);
                [entries(&rate), entries(&guards)].concat()
            }
        }
    }

    /// Holds the two forms against each other, and prints what they lose.
    ///
    /// # Panics
    /// If the emitted code is not what the programs say, if the two forms are not one function, or if more is lost with the
    /// search than may be.
    pub fn examine(&self, draw: &Draw<'_>) {
        let name = M::MODEL.name;
        let (n, k) = (M::MODEL.state_coordinates.len(), M::MODEL.state_speeds.len());
        let quantities = [
            ("derivative", "rates of coordinates", 0..n),
            // Behind them there are the guards, which may differ: those of a divisor that cancelled are gone.
            ("derivative", "accelerations", n..n + k),
            ("multipliers", "reactions", 0..M::MODEL.multipliers.len()),
        ];
        Loss::header(name);
        let mut losses = [Loss::default(), Loss::default(), Loss::default()];
        let [(found, found_doubles, found_bigs), (plain, plain_doubles, plain_bigs)] = &self.forms;
        for (at, point) in self.points(draw).iter().enumerate() {
            for function in ["derivative", "multipliers"] {
                let emitted = self.emitted(function, point);
                let walked = found.run(function, found_doubles, point);
                assert!(
                    bits(&emitted) == bits(&walked),
                    "{name}, {function} at {point:?}: {emitted:?}, not {walked:?}"
                );
                let doubles = plain.run(function, plain_doubles, point);
                let truth = plain.run(function, plain_bigs, point);
                let same = (at % PROVEN == 0).then(|| found.run(function, found_bigs, point));
                let of_function = quantities.iter().zip(&mut losses).filter(|((of, ..), _)| *of == function);
                for ((_, _, part), loss) in of_function {
                    let truth = &truth[part.clone()];
                    loss.add(truth, [&emitted[part.clone()], &doubles[part.clone()]]);
                    if let Some(same) = &same {
                        identical(name, truth, &same[part.clone()]);
                    }
                }
            }
        }
        let judged = quantities.iter().zip(&losses);
        let worse: Vec<String> = judged.flat_map(|((_, what, _), loss)| loss.judge(what, TIMES)).collect();
        assert!(worse.is_empty(), "{name}, units of the last place with a search and without:\n{}", worse.join("\n"));
    }
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|v| v.to_bits()).collect()
}

/// Both forms are one function: 50 digits of the largest component agree.
fn identical(name: &str, one: &[Big], other: &[Big]) {
    let size = one.iter().fold(0.0, |most: f64, x| most.max(x.to_double().abs()));
    for (a, b) in one.iter().zip(other) {
        let off = (a.clone() - b.clone()).to_double().abs();
        assert!(off <= 1e-50 * size, "{name}: {off:e} of {size:e}");
    }
}
