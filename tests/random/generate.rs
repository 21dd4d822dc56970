//! One random model.

use super::expression::Writer;
use super::statements::Direction;
use crate::support::splitmix::SplitMix;

/// The kinds of constraint systems, in turn.
pub const KINDS: [&str; 22] = [
    "free (k = n)",
    "velocity rows",
    "position rows",
    "position and velocity rows",
    "a velocity row merged with a position row",
    "two velocity rows merged with a position row",
    "configuration by named coordinates",
    "configuration of further coordinates",
    "configuration, then velocity rows",
    "complement given",
    "one speed (m = n - 1)",
    "prescribed (k = 0)",
    "nonlinear velocity rows",
    "acceleration rows",
    "position and nonlinear velocity rows",
    "linear and acceleration rows",
    "rows of every kind",
    "redundant rows",
    "no constant pivot",
    "configuration, then nonlinear and acceleration rows",
    "several charts",
    "families",
];

/// The kind that is stated by families.
const FAMILIES: usize = 21;

/// A model as text, with what it is a case of.
#[derive(Clone, Debug)]
pub struct RandomModel {
    /// Name of the struct.
    pub name: String,
    /// The struct with its attributes.
    pub source: String,
    /// Its parameters, in the order of the fields.
    pub parameters: Vec<String>,
    /// The classes that it belongs to.
    pub classes: Vec<String>,
}

/// The model of that number in the series of the seed.
pub fn generate(seed: u64, number: usize) -> RandomModel {
    let mut random = SplitMix::new(seed.wrapping_add((number as u64).wrapping_mul(0x1000_0001)));
    random.bits();
    let parameters: Vec<String> = (1..=1 + random.below(3)).map(|i| format!("p{i}")).collect();
    let values: Vec<String> = parameters.iter().map(|_| format!("{:.2}", random.between(0.5, 1.5))).collect();
    let kind = number % KINDS.len();
    let least = match kind {
        5 | 6 | 8 | 14 | 15 | 17 | 20 | 21 => 2,
        16 | 19 => 3,
        _ => 1,
    };
    let n = ((number / KINDS.len() + random.below(2)) % 6 + 1).max(least);
    let mut model = Builder::new(Writer { random, parameters: parameters.clone() }, n, kind);
    let (statements, arrays) = if kind == FAMILIES { model.families() } else { (model.statements(), String::new()) };
    let statements = with_functions(statements);
    let name = format!("Random{number}");
    let field = |(p, value): (&String, &String)| format!("    #[nominal({value})]\n    pub {p}: f64,\n");
    let fields = parameters.iter().zip(&values).map(field).collect::<String>() + &arrays;
    let named = |line: &str| Some(line.trim().strip_prefix("pub ")?.split_once(':')?.0.to_string());
    let parameters = fields.lines().filter_map(named).collect();
    let source = format!("#[derive(ConstrainedSystem, Clone, Debug)]\n{statements}pub struct {name} {{\n{fields}}}\n");
    RandomModel { name, source, parameters, classes: model.classes }
}

/// The statements, those about the functions of the user's that they use in front.
pub fn with_functions(statements: String) -> String {
    let used = ["wave", "bump"].into_iter().filter(|name| statements.contains(&format!("{name}(")));
    let declared = used.map(|f| format!("#[function({f}(s), derivatives = [{f}_1, {f}_2, {f}_3])]\n"));
    declared.collect::<String>() + &statements
}

/// A model in the making.
pub struct Builder {
    pub writer: Writer,
    pub n: usize,
    pub kind: usize,
    /// x1, …
    pub x: Vec<String>,
    /// Speeds as they are written in rows and forces: v1, …, or dot(x1), …
    pub v: Vec<String>,
    /// Coordinates, sometimes t.
    pub names: Vec<String>,
    /// The order in which coordinates and speeds serve as pivots.
    pub order: Vec<usize>,
    pub rheonomic: bool,
    /// Whether no entry of C may be a constant.
    pub varying: bool,
    pub classes: Vec<String>,
}

impl Builder {
    fn new(mut writer: Writer, n: usize, kind: usize) -> Self {
        let x: Vec<String> = (1..=n).map(|i| format!("x{i}")).collect();
        let rheonomic = writer.random.once_in(3);
        let names = if rheonomic { [x.clone(), vec!["t".to_string()]].concat() } else { x.clone() };
        let order = writer.random.shuffled(n);
        let classes = vec![format!("kind: {}", KINDS[kind]), format!("n = {n}")];
        Self { writer, n, kind, x, v: Vec::new(), names, order, rheonomic, varying: false, classes }
    }

    fn class(&mut self, name: &str, holds: bool) -> bool {
        if holds {
            self.classes.push(name.to_string());
        }
        holds
    }

    fn statements(&mut self) -> String {
        let directions =
            [Direction::Rates, Direction::Rates, Direction::FromSpeeds, Direction::FromRates, Direction::Both];
        let direction = *self.writer.random.one_of(&directions);
        self.classes.push(match direction {
            Direction::Rates => "kinematics: v = dot(x)".to_string(),
            Direction::FromSpeeds => "kinematics: dot(x) = A v + a0".to_string(),
            Direction::FromRates => "kinematics: v = B dot(x) + b0".to_string(),
            Direction::Both => "kinematics: both directions".to_string(),
        });
        let own = direction != Direction::Rates;
        self.v = (1..=self.n).map(|i| if own { format!("v{i}") } else { format!("dot(x{i})") }).collect();
        let biased = own && direction != Direction::Both && !self.writer.random.once_in(3);
        self.class("a0 or b0", biased);
        let dense = self.writer.random.once_in(2);
        let named = dense && self.writer.random.once_in(2);
        self.class(if dense { "M = L Lᵀ" } else { "M diagonal" }, true);
        self.class("define", named);
        let inputs: Vec<String> = if self.writer.random.once_in(4) { vec!["tau".to_string()] } else { Vec::new() };
        self.class("inputs", !inputs.is_empty());
        let potential = self.writer.random.once_in(3);
        self.class("potential energy", potential);

        let mut text = format!("#[coordinates({})]\n", self.x.join(", "));
        if own {
            text += &format!("#[speeds({})]\n", self.v.join(", "));
        }
        if !inputs.is_empty() {
            text += "#[inputs(tau)]\n";
        }
        let (x, names, v) = (self.x.clone(), self.names.clone(), self.v.clone());
        text += &self.writer.kinematics(direction, &x, &names, biased);
        let energetic = self.writer.random.once_in(5);
        text += &self.writer.inertia(self.n, &names, dense, named, energetic.then_some(&v));
        text += &self.writer.forces(self.n, &names, &v, &inputs);
        if potential {
            text += &format!("#[potential_energy({})]\n", self.writer.bounded(&x));
        }
        text += &self.constraints();
        let outputs = self.writer.random.once_in(2);
        if self.class("outputs", outputs) {
            text += &self.outputs(&text, own, &inputs);
        }
        text
    }

    /// Outputs of every level, the reactions of the constraints that stand in the text among them.
    fn outputs(&mut self, text: &str, own: bool, inputs: &[String]) -> String {
        let (x, names, v) = (self.x.clone(), self.names.clone(), self.v.clone());
        let rate = |i: usize| if own { format!("dot(v{})", i + 1) } else { format!("ddot({})", x[i]) };
        let mut lines = vec![format!("place = {}", self.writer.bounded(&names))];
        lines.push(format!("power = {}", self.writer.force(&names, &v, inputs)));
        let (i, j) = (self.writer.random.below(self.n), self.writer.random.below(self.n));
        lines.push(format!("push = {}*{} + {}*ddot({})", self.writer.bounded(&names), rate(i), v[j], x[j]));
        // the derivative of a position row may be carried by other rows, so that it has no reaction of its own
        let merged = matches!(self.kind, 4 | 5);
        let constraints = text.lines().filter_map(|line| line.strip_prefix("#[constraint("));
        let constraints: Vec<&str> = constraints.filter_map(|line| Some(line.split_once(':')?.0)).collect();
        if !constraints.is_empty() && !merged {
            let name = self.writer.random.one_of(&constraints).to_string();
            lines.push(format!("pull = {}*reaction({name}) - push", self.writer.positive(&names)));
            lines.push(format!("share = pull/({} + powi(reaction({name}), 2))", self.writer.decimal(1.0, 2.0)));
        }
        format!("#[output({})]\n", lines.join(", "))
    }
}
