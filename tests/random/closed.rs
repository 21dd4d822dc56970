//! Random closed mechanisms: one to four loops, in the plane and in space, with and without rows that depend on others.
//!
//! A mechanism is drawn in one configuration. To a base that moves come loops one by one: links between two bodies that are there
//! already, with as many coordinates as the closing joint has rows, or one more. The links are drawn as they like, and the
//! closing joint sits where their ends then are, to all digits: loops with more rows than they need close for no others: the start is as rough as that. So no loop takes from the
//! freedom of the base, and none of them is out of reach.

use super::closed_pose::{Pose, Vector, cross, less, norm, scaled};
use super::expression::Writer;
use super::generate::{RandomModel, with_functions};
use super::mechanisms::Tree;
use crate::support::splitmix::SplitMix;

/// What closes a loop in the plane, with its number of rows.
const IN_THE_PLANE: [(&str, usize); 6] =
    [("pin", 2), ("revolute", 2), ("pin in a slot", 1), ("prismatic", 2), ("gears", 1), ("strut", 1)];

/// The same in space.
const IN_SPACE: [(&str, usize); 7] = [
    ("spherical", 3),
    ("universal", 4),
    ("revolute", 5),
    ("prismatic", 5),
    ("weld", 6),
    ("strut", 1),
    ("point on a plane", 1),
];

/// The mechanism of that number in the series of the seed: planar and spatial in turn, in each with one to four loops, without
/// and then with redundancy.
pub fn closed_mechanism(seed: u64, number: usize) -> RandomModel {
    let (plane, loops, redundant) = (number.is_multiple_of(2), number / 2 % 4 + 1, number / 8 % 2 == 1);
    let mut random = SplitMix::new(seed.wrapping_add((number as u64).wrapping_mul(0x1000_0001)));
    random.bits();
    let parameters: Vec<String> = (1..=3).map(|i| format!("p{i}")).collect();
    let values: Vec<f64> = parameters.iter().map(|_| printed(random.between(0.6, 1.4), 2)).collect();
    let kind = if plane { "closed in the plane" } else { "closed in space" };
    let tree = Tree::new(Writer { random, parameters: parameters.clone() }, kind);
    let mut closed = Closed::new(tree, values.clone());
    match (redundant, plane) {
        (true, true) => closed.redundant_in_the_plane(loops),
        (true, false) => closed.redundant_in_space(loops),
        (false, _) => closed.base(),
    }
    while closed.loops < loops {
        closed.further(loops);
    }
    let with = if redundant { "with redundancy" } else { "without" };
    let place = if plane { "planar" } else { "spatial" };
    closed.tree.class(&format!("{place}, {loops} loops, {with}"));
    let start: Vec<String> = closed.start.iter().map(|(q, value)| format!("{q} = {value:.2}")).collect();
    closed.tree.text += &format!("#[start({})]\n", start.join(", "));
    let statements = with_functions(closed.tree.statements());
    let name = format!("Closed{number}");
    let field = |(p, value): (&String, &f64)| format!("    #[nominal({value:.2})]\n    pub {p}: f64,\n");
    let fields: String = parameters.iter().zip(&values).map(field).collect();
    let source = format!("#[derive(ConstrainedSystem, Clone, Debug)]\n{statements}pub struct {name} {{\n{fields}}}\n");
    RandomModel { name, source, parameters, classes: closed.tree.classes }
}

/// A number as it is written with so many digits.
pub(super) fn printed(value: f64, digits: usize) -> f64 {
    format!("{value:.digits$}").parse().expect("a number")
}

/// A closed mechanism in the making.
pub(super) struct Closed {
    pub(super) tree: Tree,
    /// The values of the parameters.
    pub(super) values: Vec<f64>,
    /// Where each link is.
    pub(super) poses: Vec<Pose>,
    /// The start.
    pub(super) start: Vec<(String, f64)>,
    /// Coordinates that are angles in the plane.
    pub(super) angles: Vec<String>,
    /// How many closing joints there are.
    pub(super) loops: usize,
    /// Whether the plane of the mechanism leans, so that N tells what happens in it by three rows.
    pub(super) leaning: bool,
}

impl Closed {
    fn new(mut tree: Tree, values: Vec<f64>) -> Self {
        // Releases stand in trees without speeds of their own: here in some of them.
        if !tree.chance(4) {
            tree.speeds.push("no release".to_owned());
        }
        let poses = vec![Pose::GROUND];
        Self { tree, values, poses, start: Vec::new(), angles: Vec::new(), loops: 0, leaning: false }
    }

    pub(super) fn plane(&self) -> bool {
        self.tree.kind == "closed in the plane"
    }

    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        printed(self.tree.writer.random.between(low, high), 2)
    }

    /// A number of either sign that is not small.
    pub(super) fn aside(&mut self, low: f64, high: f64) -> f64 {
        let value = self.between(low, high);
        if self.tree.chance(2) { -value } else { value }
    }

    /// A coordinate more, with its start.
    pub(super) fn coordinate(&mut self, start: f64) -> String {
        let q = self.tree.coordinate();
        self.start.push((q.clone(), printed(start, 2)));
        q
    }

    /// A link more, where its start has it, with a body on it.
    pub(super) fn link(&mut self, frame: &str, point: &str, pose: Pose) -> usize {
        let link = self.tree.link(frame, point);
        self.poses.push(pose);
        self.tree.body(link);
        link
    }

    /// A place in a link as a vector from O, and where it is.
    pub(super) fn place(&mut self, link: usize) -> (String, Vector) {
        let (frame, point) = self.tree.links[link].clone();
        let mut local = [self.between(0.6, 1.1), self.aside(0.1, 0.5), 0.0];
        let mut text = format!("{point} + {:.2}*{frame}.x + {:.2}*{frame}.y", local[0], local[1]);
        if !self.plane() {
            local[2] = self.aside(0.1, 0.5);
            text += &format!(" + {:.2}*{frame}.z", local[2]);
        }
        // one length in terms of a parameter
        if self.tree.chance(3) {
            let at = self.tree.writer.random.below(3);
            text = text.replacen(&format!("{:.2}*{frame}.x", local[0]), &format!("p{}*{frame}.x", at + 1), 1);
            local[0] = self.values[at];
        }
        (text.replace("+ -", "- "), self.poses[link].place(local))
    }

    /// A place of a link as a vector from O, to all digits: loops with more rows than they need close for no others.
    pub(super) fn at(&self, link: usize, place: Vector) -> String {
        let point = &self.tree.links[link].1;
        format!("{point} + {}", self.written(link, less(place, self.poses[link].origin)))
    }

    /// A vector by its components in a link, to all digits: loops with more rows than they need close for no others.
    pub(super) fn written(&self, link: usize, vector: Vector) -> String {
        let frame = &self.tree.links[link].0;
        let [x, y, z] = self.poses[link].local(vector);
        let across = if self.plane() { String::new() } else { format!(" + {z:.15}*{frame}.z") };
        format!("{x:.15}*{frame}.x + {y:.15}*{frame}.y{across}").replace("+ -", "- ")
    }

    /// A link that turns against another about axes one after the other, at a place of that one.
    pub(super) fn turning(&mut self, parent: usize, axes: &[&str]) -> usize {
        let (point, origin) = self.place(parent);
        self.turning_at(parent, axes, &point, origin)
    }

    /// The same at a given place.
    pub(super) fn turning_at(&mut self, parent: usize, axes: &[&str], point: &str, origin: Vector) -> usize {
        let mut frame = self.tree.links[parent].0.clone();
        let mut pose = Pose { origin, ..self.poses[parent] };
        if self.plane() && parent > 0 && self.tree.chance(3) {
            self.tree.class("angles against the ground");
            frame = self.tree.links[0].0.clone();
            pose = Pose { origin, ..self.poses[0] };
        }
        for (at, axis) in axes.iter().enumerate() {
            let angle = if self.plane() { self.between(-1.5, 1.5) } else { self.aside(0.3, 1.1) };
            let q = self.coordinate(angle);
            let (mut written, mut local) = ((*axis).to_owned(), unit(axis));
            if !self.plane() && at == 0 && self.tree.chance(4) {
                self.tree.class("axis as a vector");
                written = format!("(3/5*{frame}.x + 4/5*{frame}.z)");
                local = [0.6, 0.0, 0.8];
            }
            let ahead = if self.tree.chance(5) { self.between(0.1, 0.5) } else { 0.0 };
            let text = if ahead == 0.0 { q.clone() } else { format!("{q} + {ahead:.2}") };
            frame = format!("rotate({frame}, {written}, {text})");
            pose = pose.turned(local, angle + ahead);
            if self.plane() {
                self.angles.push(q);
            }
        }
        self.link(&frame, point, pose)
    }

    /// A link that slides along another.
    fn sliding(&mut self, parent: usize) -> usize {
        self.tree.class("slider in a loop");
        let (text, origin) = self.place(parent);
        let frame = self.tree.links[parent].0.clone();
        let axes: &[&str] = if self.plane() { &["x", "y"] } else { &["x", "y", "z"] };
        let axis = *self.tree.writer.random.one_of(axes);
        let distance = self.between(0.3, 0.9);
        let s = self.coordinate(distance);
        let turn = self.between(0.2, 1.2);
        let pose = Pose { origin, ..self.poses[parent] };
        let origin = pose.place(scaled(unit(axis), distance));
        let pose = Pose { origin, ..pose.turned(unit("z"), turn) };
        self.link(&format!("rotate({frame}, z, {turn:.2})"), &format!("{text} + {s}*{frame}.{axis}"), pose)
    }

    /// What moves before there is a loop.
    pub(super) fn base(&mut self) {
        match self.tree.writer.random.below(4) {
            0 => {
                self.tree.class("platform");
                let place = if self.plane() { 2 } else { 3 };
                let reach: Vec<f64> = (0..place).map(|_| self.aside(0.2, 1.2)).collect();
                let origin = std::array::from_fn(|i| reach.get(i).copied().unwrap_or(0.0));
                let frame = self.tree.links[0].0.clone();
                let terms: Vec<String> = ["x", "y", "z"]
                    .iter()
                    .zip(&reach)
                    .map(|(axis, value)| format!("{}*{frame}.{axis}", self.coordinate(*value)))
                    .collect();
                let axes: &[&str] = if self.plane() { &["z"] } else { &["z", "x", "y"] };
                let origin = self.poses[0].vector(origin);
                self.turning_at(0, axes, &format!("O + {}", terms.join(" + ")), origin);
            }
            1 if self.plane() => {
                let first = self.turning(0, &["z"]);
                self.turning(first, &["z"]);
            }
            1 => {
                self.turning(0, &["z", "x"]);
            }
            _ => {
                self.turning(0, &["z"]);
            }
        }
    }

    /// A loop more, by a closing joint at random.
    fn further(&mut self, loops: usize) {
        let joint = match self.plane() {
            true => *self.tree.writer.random.one_of(&IN_THE_PLANE),
            // joints of many rows where there are few loops
            false if self.loops == 0 && loops < 3 => *self.tree.writer.random.one_of(&IN_SPACE),
            false => IN_SPACE[[0, 0, 5, 6][self.tree.writer.random.below(4)]],
        };
        self.close(joint);
    }

    /// Links between two bodies, closed by a joint; gives both ends.
    pub(super) fn close(&mut self, (joint, rows): (&str, usize)) -> [usize; 2] {
        let order = self.tree.writer.random.shuffled(self.poses.len());
        let mut ends = [order[0], order[1]];
        let more = joint != "gears" && self.tree.chance(6);
        let (mut left, mut slid) = (rows + usize::from(more), joint == "prismatic" || joint == "weld");
        let mut first = true;
        while left > 0 {
            let side = if first { 0 } else { self.tree.writer.random.below(2) };
            ends[side] = match left {
                _ if !first && !slid && self.tree.chance(3) => {
                    slid = true;
                    left -= 1;
                    self.sliding(ends[side])
                }
                3.. if !self.plane() && self.tree.chance(2) => {
                    left -= 3;
                    let order = [["z", "x", "y"], ["x", "y", "z"], ["y", "z", "x"]];
                    let axes = *self.tree.writer.random.one_of(&order);
                    self.turning(ends[side], &axes)
                }
                2.. if !self.plane() => {
                    left -= 2;
                    let axes = *self.tree.writer.random.one_of(&[["z", "x"], ["x", "y"], ["y", "z"]]);
                    self.turning(ends[side], &axes)
                }
                _ => {
                    left -= 1;
                    let axis = if self.plane() { "z" } else { *self.tree.writer.random.one_of(&["x", "y", "z"]) };
                    self.turning(ends[side], &[axis])
                }
            };
            first = false;
        }
        self.joint(joint, ends);
        ends
    }

    /// A closing joint between two links, where the first has its end.
    fn joint(&mut self, joint: &str, [a, b]: [usize; 2]) {
        self.loops += 1;
        let number = self.loops;
        let moving = if self.plane() { "planar" } else { "spatial" };
        self.tree.class(&format!("{moving}: {joint}"));
        let (q, s) = (format!("Q{number}"), format!("S{number}"));
        let (end, at) = self.place(a);
        let [frame, other] = [a, b].map(|link| self.tree.links[link].0.clone());
        // across what holds it a point is anywhere
        let along = match joint {
            "prismatic" => scaled(self.poses[a].axes[0], self.aside(0.3, 0.8)),
            "pin in a slot" => scaled(self.poses[b].axes[0], self.aside(0.5, 0.9)),
            "point on a plane" => {
                let [x, y] = [0; 2].map(|_| self.aside(0.3, 0.8));
                self.poses[b].vector([x, y, 0.0])
            }
            _ => [0.0; 3],
        };
        let met = std::array::from_fn(|i| at[i] + along[i]);
        let mark = if self.leaning && matches!(joint, "pin" | "revolute" | "prismatic") { ", redundant" } else { "" };
        let points = format!("#[point({q} = {end}, {s} = {})]\n", self.at(b, met));
        let (frames, row) = match joint {
            "pin" | "spherical" if self.tree.chance(2) => (String::new(), format!("spherical({q}, {s})")),
            "pin" | "spherical" => {
                let expressed = if self.tree.chance(3) { format!(", expressed = {frame}") } else { String::new() };
                (String::new(), format!("{q} == {s}{expressed}"))
            }
            "revolute" => {
                let axis = match self.plane() {
                    true => format!("{other}.z"),
                    false => self.written(b, self.poses[a].axes[2]),
                };
                (String::new(), format!("revolute({q}, {s}, {frame}.z, {axis})"))
            }
            "universal" => {
                let beside = cross(self.poses[a].axes[0], [0.48, 0.6, 0.64]);
                let axis = self.written(b, scaled(beside, 1.0 / norm(beside)));
                (String::new(), format!("universal({q}, {s}, {frame}.x, {axis})"))
            }
            "prismatic" | "weld" => {
                let [z, y, x] = self.poses[b].angles_to(&self.poses[a]);
                let aligned = match self.plane() {
                    true => format!("rotate({other}, z, {z:.15})"),
                    false => format!("rotate(rotate(rotate({other}, z, {z:.15}), y, {y:.15}), x, {x:.15})"),
                };
                let frames = format!("#[frame(W{number} = {aligned})]\n");
                let along = if joint == "weld" { frame } else { format!("{frame}.x") };
                (frames, format!("{joint}({q}, {s}, {along}, W{number})"))
            }
            "pin in a slot" => (String::new(), format!("dot({q} - {s}, {other}.y) == 0")),
            "point on a plane" => (String::new(), format!("dot({q} - {s}, {other}.z) == 0")),
            "strut" => {
                let (far, place) = loop {
                    let (far, place) = self.place(b);
                    if norm(less(at, place)) > 0.4 {
                        break (far, place);
                    }
                };
                let length = norm(less(at, place));
                self.tree.text += &format!("#[point({q} = {end}, {s} = {far})]\n");
                let row = match self.tree.chance(2) {
                    true => format!("norm({q} - {s}) == {length:.15}"),
                    false => format!("dot({q} - {s}, {q} - {s}) == {:.15}", length * length),
                };
                self.tree.text += &format!("#[constraint(loop{number}: {row})]\n");
                return;
            }
            _ => {
                self.gears(number);
                return;
            }
        };
        self.tree.text += &format!("{frames}{points}#[constraint(loop{number}: {row}{mark})]\n");
    }

    /// A wheel that turns as another angle says; its own is the last one.
    fn gears(&mut self, number: usize) {
        let own = self.angles.last().expect("an angle").clone();
        let other = self.angles[self.tree.writer.random.below(self.angles.len() - 1)].clone();
        let value = |name: &String| self.start.iter().find(|(q, _)| q == name).expect("a coordinate").1;
        let (own_value, other_value) = (value(&own), value(&other));
        let ratio = self.aside(0.5, 1.5);
        let angle = own_value + ratio * other_value;
        self.tree.text +=
            &format!("#[constraint(loop{number}: {own} + {ratio:.2}*{other} == {angle:.15})]\n").replace("+ -", "- ");
    }
}

/// A coordinate axis as a unit vector.
pub(super) fn unit(axis: &str) -> Vector {
    ["x", "y", "z"].map(|name| f64::from(u8::from(name == axis)))
}
