//! Random mechanisms by geometry: trees of bodies in space, some of them rolling, some closed to loops, some in speeds of their own.
//!
//! Every frame that turns carries a body that resists turning in every direction, so that M is regular; angles stay where the
//! sequences of rotations do not fail.

use super::expression::Writer;
use super::generate::RandomModel;
use super::generate::with_functions;
use crate::support::splitmix::SplitMix;

/// The kinds of mechanisms, in turn.
pub const MECHANISMS: [&str; 10] = [
    "tree in the plane",
    "tree in space",
    "tree with sliding joints",
    "tree with chains of rotations",
    "tree that time moves",
    "rolling",
    "loop",
    "speeds as components",
    "knife edge",
    "family",
];

/// The mechanism of that number in the series of the seed.
pub fn mechanism(seed: u64, number: usize) -> RandomModel {
    grown(seed, number, MECHANISMS[number % MECHANISMS.len()], Tree::grow)
}

/// A mechanism of a kind.
pub(super) fn grown(seed: u64, number: usize, kind: &'static str, grow: impl Fn(&mut Tree)) -> RandomModel {
    let mut random = SplitMix::new(seed.wrapping_add((number as u64).wrapping_mul(0x1000_0001)));
    random.bits();
    let parameters: Vec<String> = (1..=3).map(|i| format!("p{i}")).collect();
    let values: Vec<String> = parameters.iter().map(|_| format!("{:.2}", random.between(0.6, 1.4))).collect();
    let mut tree = Tree::new(Writer { random, parameters: parameters.clone() }, kind);
    grow(&mut tree);
    let statements = with_functions(tree.statements());
    let name = format!("Mechanism{number}");
    let field = |(p, value): (&String, &String)| format!("    #[nominal({value})]\n    pub {p}: f64,\n");
    let fields: String = parameters.iter().zip(&values).map(field).collect();
    let source = format!("#[derive(ConstrainedSystem, Clone, Debug)]\n{statements}pub struct {name} {{\n{fields}}}\n");
    RandomModel { name, source, parameters, classes: tree.classes }
}

/// A mechanism in the making.
pub(super) struct Tree {
    pub(super) writer: Writer,
    pub(super) kind: &'static str,
    /// q1, ..
    pub(super) coordinates: Vec<String>,
    /// Those that are numbers of quaternions, four by four.
    pub(super) components: Vec<String>,
    /// Names of frames with the point from which what they carry goes on; the first is the ground.
    pub(super) links: Vec<(String, String)>,
    /// Names of the bodies, with the number of their link.
    pub(super) bodies: Vec<(String, usize)>,
    /// What the speeds of its own are.
    pub(super) speeds: Vec<String>,
    pub(super) text: String,
    pub(super) classes: Vec<String>,
}

impl Tree {
    pub(super) fn new(writer: Writer, kind: &'static str) -> Self {
        Self {
            writer,
            kind,
            coordinates: Vec::new(),
            components: Vec::new(),
            links: vec![("N".to_string(), "O".to_string())],
            bodies: Vec::new(),
            speeds: Vec::new(),
            text: String::new(),
            classes: vec![format!("kind: {kind}")],
        }
    }

    pub(super) fn class(&mut self, name: &str) {
        if !self.classes.iter().any(|class| class == name) {
            self.classes.push(name.to_string());
        }
    }

    pub(super) fn chance(&mut self, n: usize) -> bool {
        self.writer.random.once_in(n)
    }

    pub(super) fn between(&mut self, low: f64, high: f64) -> String {
        self.writer.decimal(low, high)
    }

    /// A coordinate more.
    pub(super) fn coordinate(&mut self) -> String {
        let name = format!("q{}", self.coordinates.len() + 1);
        self.coordinates.push(name.clone());
        name
    }

    /// A link more: its frame and point, both declared here.
    pub(super) fn link(&mut self, frame: &str, point: &str) -> usize {
        let number = self.links.len();
        let (a, p) = (format!("A{number}"), format!("P{number}"));
        self.text += &format!("#[frame({a} = {frame})]\n#[point({p} = {point})]\n");
        self.links.push((a, p));
        number
    }

    /// A place in a link, as a vector from O; in the plane without a part across it.
    pub(super) fn place(&mut self, link: usize) -> String {
        let (frame, point) = self.links[link].clone();
        let mut text = format!("{point} + {}*{frame}.x", self.between(0.4, 1.0));
        if self.chance(2) {
            text += &format!("{}*{frame}.y", self.writer.signed(0.1, 0.5));
        }
        if !self.plane() && self.chance(2) {
            let parameter = self.writer.random.one_of(&self.writer.parameters).clone();
            text += &format!("{}*{parameter}*{frame}.z", self.writer.signed(0.1, 0.4));
        }
        text
    }

    pub(super) fn plane(&self) -> bool {
        matches!(self.kind, "tree in the plane" | "knife edge" | "closed in the plane")
    }

    /// An axis about which a frame may turn: by name, or as a unit vector fixed in it.
    fn axis(&mut self, frame: &str) -> (String, String) {
        if self.plane() {
            return ("z".to_string(), format!("{frame}.z"));
        }
        let plain = ["x", "y", "z", "-y", "z"][self.writer.random.below(5)].to_string();
        if !self.chance(3) {
            let vector =
                plain.strip_prefix('-').map_or(format!("{frame}.{plain}"), |axis| format!("(-{frame}.{axis})"));
            return (plain, vector);
        }
        self.class("axis as a vector");
        let vector = [
            format!("(3/5*{frame}.x + 4/5*{frame}.z)"),
            format!("unit({frame}.x + {frame}.y)"),
            format!("unit(3*{frame}.y - 4*{frame}.z)"),
            format!("(({frame}.x + 2*{frame}.y + 2*{frame}.z)/3)"),
        ][self.writer.random.below(4)]
        .clone();
        (vector.clone(), vector)
    }

    /// An angle in a coordinate, now and then in time.
    fn angle(&mut self, q: &str) -> String {
        if self.kind == "tree that time moves" && self.chance(2) {
            self.class("angle in time");
            return match self.writer.random.below(3) {
                0 => format!("{q} + {}*t", self.between(0.3, 1.0)),
                1 => format!("{q} + {}*sin(2*t)", self.between(0.2, 0.6)),
                _ => format!("(1 + {}*cos(t))*{q}", self.between(0.1, 0.3)),
            };
        }
        match self.writer.random.below(6) {
            0 => format!("{q} + {}", self.between(0.1, 0.5)),
            1 => format!("-{q}"),
            _ => q.to_string(),
        }
    }

    /// A joint turning about one axis.
    pub(super) fn revolute(&mut self, parent: usize) -> usize {
        let frame = self.links[parent].0.clone();
        let q = self.coordinate();
        let (axis, vector) = self.axis(&frame);
        let (mut angle, place) = (self.angle(&q), self.place(parent));
        // the angle against the ground, where the plane allows it
        if self.plane() && self.coordinates.len() > 1 && self.chance(4) {
            self.class("absolute or added angles");
            angle = format!("{angle} + {}", self.coordinates[0]);
        }
        let base = if self.plane() && self.chance(3) { "N".to_string() } else { frame };
        let link = self.link(&format!("rotate({base}, {axis}, {angle})"), &place);
        let turning = format!("dot(angular_velocity(A{link}), {vector})");
        let plain = self.chance(2);
        self.speeds.push(if plain { format!("dot({q})") } else { turning });
        link
    }

    /// A joint sliding along a direction, the frame perhaps turned once and for all.
    pub(super) fn sliding(&mut self, parent: usize) -> usize {
        self.class("coordinate in a point");
        let frame = self.links[parent].0.clone();
        let q = self.coordinate();
        let (axis, vector) = self.axis(&frame);
        let along = if self.plane() { format!("{frame}.x") } else { vector };
        let reach = self.writer.positive(std::slice::from_ref(&q));
        let offset = match self.writer.random.below(3) {
            0 => q.clone(),
            1 => format!("({q} + {})", self.between(0.2, 0.8)),
            _ => format!("{reach}*({q} + 3)"),
        };
        let fixed = self.between(0.2, 1.2);
        let place = format!("{} + {offset}*{along}", self.place(parent));
        self.speeds.push(format!("dot({q})"));
        if frame == "N" || self.chance(2) {
            self.class("frame turned once and for all");
            return self.link(&format!("rotate({frame}, {axis}, {fixed})"), &place);
        }
        let number = self.links.len();
        self.text += &format!("#[point(P{number} = {place})]\n");
        self.links.push((frame, format!("P{number}")));
        number
    }

    /// A joint of two or three rotations, one after the other.
    pub(super) fn several(&mut self, parent: usize, count: usize) -> usize {
        self.class(if count == 3 { "three rotations in a chain" } else { "two rotations in a chain" });
        let frame = self.links[parent].0.clone();
        let orders = [["z", "x", "y"], ["x", "y", "z"], ["y", "z", "x"], ["x", "z", "y"]];
        let order = orders[self.writer.random.below(4)];
        let mut turned = frame;
        let first = self.coordinates.len();
        for axis in order.iter().take(count) {
            let q = self.coordinate();
            let angle = self.angle(&q);
            turned = format!("rotate({turned}, {axis}, {angle})");
        }
        let place = self.place(parent);
        let link = self.link(&turned, &place);
        let turning = |axis: &str| format!("dot(angular_velocity(A{link}), A{link}.{axis})");
        // in a chain that time changes, or with two rotations, the components may not tell the rates
        if count == 3 && self.kind != "tree that time moves" {
            self.class("angular velocity by components");
            self.speeds.extend(["x", "y", "z"].map(turning));
        } else {
            self.speeds.extend(self.coordinates[first..].iter().map(|q| format!("dot({q})")));
        }
        link
    }

    /// A base that moves freely in the plane.
    pub(super) fn floating_in_plane(&mut self) -> usize {
        let [x, y, a] = [0; 3].map(|_| self.coordinate());
        let link = self.link(&format!("rotate(N, z, {a})"), &format!("O + {x}*N.x + {y}*N.y"));
        self.speeds.extend([
            format!("dot(velocity(P{link}), A{link}.x)"),
            format!("dot(velocity(P{link}), A{link}.y)"),
            format!("dot({a})"),
        ]);
        self.class("free base");
        link
    }

    /// A base that moves freely in space.
    pub(super) fn floating(&mut self) -> usize {
        let [x, y, z, a, b, c] = [0; 6].map(|_| self.coordinate());
        let frame = format!("rotate(rotate(rotate(N, z, {a}), x, {b}), y, {c})");
        let link = self.link(&frame, &format!("O + {x}*N.x + {y}*N.y + {z}*N.z"));
        for axis in ["x", "y", "z"] {
            self.speeds.push(format!("dot(velocity(P{link}), A{link}.{axis})"));
        }
        for axis in ["x", "y", "z"] {
            self.speeds.push(format!("dot(angular_velocity(A{link}), A{link}.{axis})"));
        }
        self.class("free base");
        link
    }

    /// A body on a link.
    pub(super) fn body(&mut self, link: usize) {
        let number = self.bodies.len() + 1;
        let name = format!("body{number}");
        let (frame, mass) = (self.links[link].0.clone(), self.mass());
        let center = self.place(link);
        let inertia = self.inertia(&mass);
        let about = match self.chance(6) {
            true => {
                self.class("inertia about another point");
                format!(", about: {}", self.links[link].1)
            }
            false => String::new(),
        };
        // about another point, an inertia must outweigh what Steiner takes away
        let inertia = if about.is_empty() { inertia } else { format!("diag(3*{mass}, 3.20*{mass}, 3.10*{mass})") };
        self.text += &format!(
            "#[body({name} = {{ frame: {frame}, center: {center}, mass: {mass}, inertia: {inertia}{about} }})]\n"
        );
        self.bodies.push((name, link));
    }

    fn mass(&mut self) -> String {
        match self.chance(3) {
            true => self.writer.random.one_of(&self.writer.parameters).clone(),
            false => self.between(0.5, 2.0),
        }
    }

    fn inertia(&mut self, mass: &str) -> String {
        let size = self.between(0.4, 0.8);
        match self.writer.random.below(if self.plane() { 9 } else { 7 }) {
            0 => format!("disk({mass}, {size}, z)"),
            1 => format!("cylinder({mass}, {size}, 0.90, y)"),
            2 => format!("sphere({mass}, {size})"),
            3 => format!("cuboid({mass}, {size}, 0.50, 0.70)"),
            4 => "diag(0.30, 0.40, 0.45)".to_string(),
            5 | 6 => {
                self.class("products of inertia");
                let product = |tree: &mut Self| tree.writer.signed(0.02, 0.08).replace("+ ", "").replace(' ', "");
                let [xy, xz, yz] = [0; 3].map(|_| product(self));
                format!("matrix([0.35, {xy}, {xz}], [_, 0.40, {yz}], [_, _, 0.45])")
            }
            7 => format!("planar({size})"),
            _ => {
                self.class("rod");
                format!("rod({mass}, {size}, x)")
            }
        }
    }
}
