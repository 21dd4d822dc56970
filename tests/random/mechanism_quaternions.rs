//! Random mechanisms in which frames turn by quaternions: free bodies, joints in trees and on the way of loops, balls that roll.

use super::generate::RandomModel;
use super::mechanisms::{Tree, grown};

/// The kinds, in turn.
pub const QUATERNION_KINDS: [&str; 5] = [
    "quaternions in a tree",
    "free base by a quaternion",
    "rolling by a quaternion",
    "loop with quaternions",
    "speeds of its own beside quaternions",
];

/// The mechanism of that number in the series of the seed.
pub fn quaternion_mechanism(seed: u64, number: usize) -> RandomModel {
    grown(seed, number, QUATERNION_KINDS[number % QUATERNION_KINDS.len()], Tree::grow_by_quaternions)
}

impl Tree {
    fn grow_by_quaternions(&mut self) {
        match self.kind {
            "rolling by a quaternion" => self.rolling_ball(),
            "loop with quaternions" => self.loop_of_balls(),
            _ => self.tree_of_balls(),
        }
    }

    /// A link more whose frame turns by a quaternion, perhaps behind a rotation.
    fn ball(&mut self, parent: usize, point: &str) -> usize {
        let first = self.components.len();
        self.components.extend((0..4).map(|i| format!("e{}", first + i)));
        let components = self.components[first..].join(", ");
        let mut base = self.links[parent].0.clone();
        if self.chance(3) {
            self.class("quaternion behind a rotation");
            base = format!("rotate({base}, x, {})", self.between(0.2, 1.2));
        }
        let link = self.link(&format!("quaternion({base}, {components})"), point);
        self.class("quaternion");
        if first > 0 {
            self.class("several quaternions");
        }
        let turning = |axis: &str| format!("dot(angular_velocity(A{link}), A{link}.{axis})");
        self.speeds.extend(["x", "y", "z"].map(turning));
        link
    }

    /// A tree of up to four links, the first of them perhaps free, most of them balls.
    fn tree_of_balls(&mut self) {
        for number in 0..2 + self.writer.random.below(2) {
            let parent = match self.chance(3) {
                true => self.writer.random.below(self.links.len()),
                false => self.links.len() - 1,
            };
            let free = number == 0 && self.kind != "quaternions in a tree";
            let link = match self.writer.random.below(3) {
                _ if free => {
                    let [x, y, z] = [0; 3].map(|_| self.coordinate());
                    self.class("free base");
                    self.speeds.extend([&x, &y, &z].map(|q| format!("dot({q})")));
                    self.ball(0, &format!("O + {x}*N.x + {y}*N.y + {z}*N.z"))
                }
                0 | 1 if self.components.len() < 8 && number > 0 => {
                    self.class("ball joint on a link");
                    let place = self.place(parent);
                    self.ball(parent, &place)
                }
                2 if number > 0 => self.sliding(parent),
                _ => self.revolute(parent),
            };
            match self.components.is_empty() || !self.chance(3) {
                true => self.body(link),
                false => self.round(link),
            }
        }
        if self.kind == "quaternions in a tree" && self.components.is_empty() {
            let (parent, place) = (self.links.len() - 1, self.place(1));
            let link = self.ball(parent, &place);
            self.body(link);
        }
        if self.chance(5) {
            self.class("row on a tree with quaternions");
            self.held_anywhere();
        }
    }

    /// A body that looks the same however it is turned about its joint.
    fn round(&mut self, link: usize) {
        self.class("ball about its joint");
        let (name, (frame, point)) = (format!("body{}", self.bodies.len() + 1), self.links[link].clone());
        let (mass, r) = (self.between(0.5, 2.0), self.between(0.4, 0.9));
        self.text += &format!(
            "#[body({name} = {{ frame: {frame}, center: {point}, mass: {mass}, inertia: sphere({mass}, {r}) }})]\n"
        );
        self.bodies.push((name, link));
    }

    /// A ball on a plane that may turn, with a body that hangs on to it.
    fn rolling_ball(&mut self) {
        let r = self.between(0.4, 0.9);
        let [x, y] = [0; 2].map(|_| self.coordinate());
        let height = if self.chance(2) {
            self.class("height beside rolling");
            let z = self.coordinate();
            self.text += &format!("#[constraint(contact: {z} == {r})]\n");
            z
        } else {
            r.clone()
        };
        let link = self.ball(0, &format!("O + {x}*N.x + {y}*N.y + {height}*N.z"));
        let mass = self.between(0.5, 2.0);
        let inertia = match self.chance(2) {
            true => format!("sphere({mass}, {r})"),
            false => "diag(0.30, 0.40, 0.45)".to_string(),
        };
        self.text +=
            &format!("#[body(ball = {{ frame: A{link}, center: P{link}, mass: {mass}, inertia: {inertia} }})]\n");
        self.bodies.push(("ball".to_string(), link));
        let right = match self.chance(2) {
            true => {
                self.class("ground that turns");
                format!("{}*cross(N.z, P{link})", self.between(0.3, 1.0))
            }
            false => "0".to_string(),
        };
        // without a height the component across the plane vanishes, and three rows along other axes would depend on each other
        let expressed = if height != r && self.chance(3) { ", expressed = A1" } else { "" };
        self.text += &format!("#[constraint(roll: velocity(P{link} - {r}*N.z, ball) == {right}{expressed})]\n");
        self.class("ball rolls");
        if self.chance(2) {
            let hung = self.revolute(link);
            self.body(hung);
        }
    }

    /// Two chains whose ends meet, with balls in both.
    fn loop_of_balls(&mut self) {
        self.class("loop with balls");
        let first = self.revolute(0);
        self.body(first);
        let place = format!("P{first} + {}*A{first}.x", self.between(0.7, 1.1));
        let second = self.ball(first, &place);
        self.body(second);
        let third = self.ball(0, "O + N.x");
        self.body(third);
        let ends = [self.between(0.7, 1.1), self.between(0.7, 1.1)];
        self.text +=
            &format!("#[point(Q = P{second} + {}*A{second}.x, S = P{third} + {}*A{third}.x)]\n", ends[0], ends[1]);
        let row = match self.chance(3) {
            true => "#[constraint(strut: dot(Q - S, Q - S) == 1.40)]\n",
            false => "#[constraint(closure: Q == S)]\n",
        };
        self.text += row;
    }

    fn held_anywhere(&mut self) {
        let last = self.links.len() - 1;
        let place = self.place(last);
        let row = match self.writer.random.below(3) {
            0 => "dot(Held, 3/5*N.x + 4/5*N.y) == 0.30",
            1 => "dot(velocity(Held), N.x + N.z) == 0.30*sin(t)",
            _ => "dot(acceleration(Held), N.x + N.y) == 0.40",
        };
        self.text += &format!("#[point(Held = {place})]\n#[constraint(held: {row})]\n");
    }
}
