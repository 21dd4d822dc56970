//! The symbols of a model, by their names, and what is lowered so far.

use super::geometry::{Geometry, Released, Turning};
use super::names::Names;
use super::value::{Lowered, Valued};
use crate::symbolic::{Expr, Function, Graph, Kind, Symbol};
use crate::syntax::{Declarations, Quaternion, Speed};
use proc_macro2::Span;

/// The symbols of a model, by their names.
pub(super) struct Vocabulary<'a> {
    pub declarations: &'a Declarations,
    pub graph: Graph,
    pub names: Names,
    pub time: Symbol,
    /// One for each field; only scalar ones are ever used.
    pub fields: Vec<Symbol>,
    /// Which fields some expression mentions.
    pub used: Vec<bool>,
    pub coordinates: Vec<Symbol>,
    pub further: Vec<Symbol>,
    pub speeds: Vec<Symbol>,
    /// What each of them is.
    pub kinds: Vec<Speed>,
    /// The rates of the initial coordinates; the speeds themselves where these have no names.
    pub rates: Vec<Symbol>,
    /// The rates of the speeds.
    pub accelerations: Vec<Symbol>,
    /// The second rates of the initial coordinates; the rates of the speeds themselves where these have no names.
    pub second_rates: Vec<Symbol>,
    /// The rates of `further`; those that nothing has mentioned come with the configuration.
    pub further_rates: Vec<Option<Symbol>>,
    /// The quasi-velocities of the configuration.
    pub quasi: Vec<Symbol>,
    /// The independent speeds of `velocities(of(..))`.
    pub free: Vec<Symbol>,
    /// The combinations of speeds of `independent(s = ..)`, through all lists.
    pub combinations: Vec<Symbol>,
    /// The second rates of `further`, where something has mentioned them.
    pub further_accelerations: Vec<Option<Symbol>>,
    /// The rates of the quasi-velocities, where something has mentioned them.
    pub quasi_rates: Vec<Option<Symbol>>,
    pub inputs: Vec<Symbol>,
    /// The reactions that are mentioned, by the names of their rows, and where they are first.
    pub reactions: Vec<(String, Symbol, Span)>,
    /// The outputs that are lowered so far; without a value where that failed.
    pub outputs: Vec<(String, Option<Lowered>)>,
    /// The functions of the user's.
    pub functions: Vec<Function>,
    /// `None` before a define is lowered, and where that failed.
    pub defines: Vec<Option<Valued>>,
    /// Frames, points and bodies.
    pub geometry: Geometry,
    /// What is released, in the order of the model's releases.
    pub released: Vec<Released>,
    /// Frames by quaternions, and their symbols.
    pub quaternions: Vec<Quaternion>,
    pub turnings: Vec<Turning>,
    /// What replaces components of angular velocities that are no speeds.
    pub turned: Vec<(Symbol, Expr)>,
    /// The generalised forces on rates that are no speeds: the coordinate and the force.
    pub forces_on_rates: Vec<(usize, Expr)>,
}

impl<'a> Vocabulary<'a> {
    pub fn new(declarations: &'a Declarations, names: Names) -> Self {
        let mut graph = Graph::new();
        let time = graph.symbol("t", Kind::Time);
        let mut symbols =
            |names: Vec<String>, kind| -> Vec<Symbol> { names.iter().map(|name| graph.symbol(name, kind)).collect() };
        let of = |names: &[crate::syntax::Name]| names.iter().map(|name| name.ident.to_string()).collect::<Vec<_>>();
        let coordinate_names = of(&declarations.coordinates);
        let rate_names = |format: fn(&String) -> String| coordinate_names.iter().map(format).collect::<Vec<_>>();
        let fields = symbols(declarations.fields.iter().map(|f| f.ident.to_string()).collect(), Kind::Parameter);
        let coordinates = symbols(coordinate_names.clone(), Kind::Coordinate);
        let further = match &declarations.configuration {
            Some(configuration) => symbols(of(&configuration.further), Kind::Coordinate),
            None => Vec::new(),
        };
        let second_rates = symbols(rate_names(|x| format!("ddot({x})")), Kind::Speed);
        let quaternions = declarations.quaternions();
        let kinds = declarations.all_speeds(&quaternions);
        let names_of_speeds = kinds.iter().map(|speed| declarations.speed_name(*speed, &quaternions)).collect();
        let speeds: Vec<Symbol> = symbols(names_of_speeds, Kind::Speed);
        let place = |wanted: Speed| kinds.iter().position(|speed| *speed == wanted);
        let rates: Vec<Symbol> = (0..coordinates.len())
            .map(|i| match place(Speed::Rate(i)) {
                Some(at) => speeds[at],
                None => symbols(vec![format!("dot({})", coordinate_names[i])], Kind::Speed)[0],
            })
            .collect();
        let accelerations: Vec<Symbol> = (0..speeds.len())
            .map(|at| match kinds[at] {
                Speed::Rate(i) => second_rates[i],
                speed => {
                    symbols(vec![format!("dot({})", declarations.speed_name(speed, &quaternions))], Kind::Speed)[0]
                }
            })
            .collect();
        // Where the model names speeds of its own, ω is given by these.
        let turnings: Vec<Turning> = (0..quaternions.len())
            .map(|at| {
                let mut symbol = |of: &[Symbol], axis: usize, order: &str| match place(Speed::Angular(at, axis)) {
                    Some(place) => of[place],
                    None => symbols(vec![format!("{order}{}", quaternions[at].angular(axis))], Kind::Speed)[0],
                };
                Turning {
                    coordinates: quaternions[at].coordinates,
                    omega: std::array::from_fn(|axis| symbol(&speeds, axis, "")),
                    omega_rates: std::array::from_fn(|axis| symbol(&accelerations, axis, "dot ")),
                    norm_rate: place(Speed::Norm(at)).map_or(time, |place| speeds[place]),
                }
            })
            .collect();
        let inputs = symbols(of(&declarations.inputs), Kind::Input);
        let quasi = declarations.configuration.as_ref().map_or(Vec::new(), |c| symbols(of(&c.speeds), Kind::Speed));
        let free = declarations.velocities.as_ref().map_or(Vec::new(), |v| symbols(of(&v.further), Kind::Speed));
        let combined = declarations.independent.iter().flat_map(|list| list.combinations());
        let combinations = symbols(combined.map(|(name, _)| name.ident.to_string()).collect(), Kind::Speed);
        let functions = declarations.functions.iter().map(|function| {
            let names: Vec<String> = function.orders.iter().map(last_name).collect();
            graph.give(&names)
        });
        let functions = functions.collect();
        for turning in &turnings {
            graph.on_sphere(turning.coordinates.map(|place| coordinates[place]));
        }
        let geometry = Geometry::new(&graph, declarations);
        let released = declarations.geometry.releases().map(|release| Released::new(release, &mut graph)).collect();
        Vocabulary {
            declarations,
            graph,
            names,
            time,
            used: vec![false; fields.len()],
            fields,
            coordinates,
            further_rates: vec![None; further.len()],
            further_accelerations: vec![None; further.len()],
            quasi_rates: vec![None; quasi.len()],
            further,
            speeds,
            kinds,
            rates,
            accelerations,
            second_rates,
            quasi,
            free,
            combinations,
            inputs,
            reactions: Vec::new(),
            outputs: Vec::new(),
            functions,
            defines: vec![None; declarations.defines.len()],
            geometry,
            released,
            quaternions,
            turnings,
            turned: Vec::new(),
            forces_on_rates: Vec::new(),
        }
    }
}

impl Vocabulary<'_> {
    /// The frame whose quaternion a coordinate belongs to, and the names of its speeds.
    pub fn quaternion_of(&self, coordinate: usize) -> Option<(String, String)> {
        let of = self.quaternions.iter().find(|quaternion| quaternion.coordinates.contains(&coordinate))?;
        let angular: Vec<String> = match self.declarations.speeds {
            None => (0..3).map(|axis| format!("`{}`", of.angular(axis))).collect(),
            Some(_) => vec!["among `speeds`".to_owned()],
        };
        Some((of.name.to_string(), angular.join(", ")))
    }
}

/// The last segment of a path.
fn last_name(path: &syn::Path) -> String {
    path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default()
}
