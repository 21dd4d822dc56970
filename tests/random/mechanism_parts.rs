//! How random mechanisms grow, what acts on them, and how they are bound.

use super::mechanisms::Tree;

impl Tree {
    /// All links and bodies, by kind, and the constraints between them.
    pub(super) fn grow(&mut self) {
        match self.kind {
            "rolling" => self.rolling(),
            "loop" => self.closed(),
            "knife edge" => self.knife(),
            "family" => self.family(),
            _ => {
                let count = 1 + self.writer.random.below(5);
                self.tree(count);
                self.class(&format!("{count} links"));
                if self.kind != "speeds as components" && self.chance(5) {
                    self.held();
                }
            }
        }
    }

    /// A tree of so many links with a body on each.
    fn tree(&mut self, count: usize) {
        for number in 0..count {
            let parent = match self.chance(3) {
                true => self.writer.random.below(self.links.len()),
                false => self.links.len() - 1,
            };
            // six coordinates at most before the last links, so that what comes out stays small
            let few = self.coordinates.len() < 4;
            let choice = self.writer.random.below(6);
            let link = match self.kind {
                "tree in the plane" if number == 0 && choice == 0 => self.floating_in_plane(),
                "speeds as components" if number == 0 && choice < 2 => self.floating(),
                "speeds as components" if few && choice == 2 => self.several(parent, 3),
                "tree with sliding joints" if choice < 3 => self.sliding(parent),
                "tree with chains of rotations" if few && choice < 4 => self.several(parent, 2 + choice % 2),
                "tree that time moves" if choice == 0 => self.sliding(parent),
                "tree that time moves" if choice == 1 && few => self.several(parent, 2),
                _ => self.revolute(parent),
            };
            self.body(link);
        }
        if self.bodies.len() > 1 {
            self.class("tree of several bodies");
        }
    }

    /// A row on a tree: a height, a distance, or an acceleration.
    fn held(&mut self) {
        if self.coordinates.len() < 3 {
            return;
        }
        let last = self.links.len() - 1;
        let place = self.place(last);
        self.text += &format!("#[point(Held = {place})]\n");
        self.class("scalar row of vectors");
        let height = self.between(0.2, 0.6);
        let row = match self.writer.random.below(3) {
            0 => format!("#[constraint(held: dot(Held, 3/5*N.x + 4/5*N.y) == {height})]\n"),
            1 => format!("#[constraint(held: norm(Held - {height}*N.y) == 1)]\n"),
            _ => {
                self.class("row of accelerations");
                format!("#[constraint(held: dot(acceleration(Held), N.x + N.y) == {height})]\n")
            }
        };
        self.text += &row;
    }

    /// A disk or a ball on a plane, with a body that hangs on to it.
    fn rolling(&mut self) {
        let r = self.between(0.4, 0.9);
        let [x, y, a, b, c] = [0; 5].map(|_| self.coordinate());
        let mut right = "0".to_string();
        let carrier = match self.writer.random.below(3) {
            // a disk by its contact, which has no rate across the plane
            0 => {
                self.class("rolling disk");
                self.text += &format!("#[point(P1 = O + {x}*N.x + {y}*N.y)]\n#[frame(Y = rotate(N, z, {a}))]\n");
                self.text += &format!("#[frame(L = rotate(Y, x, {b}), A1 = rotate(L, y, {c}))]\n");
                self.text += &format!("#[point(C1 = P1 + {r}*L.z)]\n");
                "L"
            }
            // a disk with its height, which a position row may hold as well
            1 => {
                self.class("rolling disk with a height");
                let z = self.coordinate();
                self.text +=
                    &format!("#[point(P1 = O + {x}*N.x + {y}*N.y + {z}*N.z)]\n#[frame(Y = rotate(N, z, {a}))]\n");
                self.text += &format!("#[frame(L = rotate(Y, x, {b}), A1 = rotate(L, y, {c}))]\n");
                self.text += &format!("#[point(C1 = P1 + {r}*L.z)]\n");
                if self.chance(2) {
                    self.class("height beside rolling");
                    self.text += "#[constraint(contact: dot(P1, N.z) == 0)]\n";
                }
                "L"
            }
            // a ball on a plane that may turn
            _ => {
                self.class("rolling ball");
                self.text += &format!("#[frame(A1 = rotate(rotate(rotate(N, z, {a}), x, {b}), y, {c}))]\n");
                self.text += &format!("#[point(C1 = O + {x}*N.x + {y}*N.y + {r}*N.z, P1 = C1 - {r}*N.z)]\n");
                if self.chance(2) {
                    self.class("ground that turns");
                    right = format!("{}*cross(N.z, P1)", self.between(0.3, 1.0));
                }
                "A1"
            }
        };
        let mass = self.between(0.5, 2.0);
        let inertia = if carrier == "L" { format!("disk({mass}, {r}, y)") } else { format!("sphere({mass}, {r})") };
        self.text += &format!("#[body(wheel = {{ frame: A1, center: C1, mass: {mass}, inertia: {inertia} }})]\n");
        self.links.push(("A1".to_string(), "C1".to_string()));
        self.bodies.push(("wheel".to_string(), 1));
        let expressed = if carrier == "L" && self.chance(2) { ", expressed = Y" } else { "" };
        self.class(if expressed.is_empty() { "vector row in N" } else { "vector row in a frame" });
        // the frame of one body alone stands for it
        let of = if self.chance(3) { "A1" } else { "wheel" };
        if of == "A1" {
            self.class("material point by its frame");
        }
        self.text += &format!("#[constraint(roll: velocity(P1, {of}) == {right}{expressed})]\n");
        self.class("vector row of velocities");
        if self.chance(2) {
            self.links.push((carrier.to_string(), "C1".to_string()));
            self.class("bodies on a wheel");
            let link = self.revolute(2);
            self.body(link);
        }
    }

    /// Two chains whose ends meet.
    fn closed(&mut self) {
        let plane = self.chance(2);
        self.class(if plane { "loop in the plane" } else { "loop in space" });
        let mut ends = Vec::new();
        for (chain, count) in [1 + self.writer.random.below(2) + usize::from(plane), 1].into_iter().enumerate() {
            let (mut frame, mut point) = ("N".to_string(), format!("O + {chain}*N.x"));
            for _ in 0..count {
                let axes = match plane {
                    true => vec!["z"],
                    false => [vec!["z", "x"], vec!["x", "y"], vec!["y", "z", "x"]][self.writer.random.below(3)].clone(),
                };
                for axis in axes {
                    let q = self.coordinate();
                    frame = format!("rotate({frame}, {axis}, {q})");
                }
                let link = self.link(&frame, &point);
                self.body(link);
                frame = format!("A{link}");
                point = format!("P{link} + {}*A{link}.x", self.between(0.7, 1.1));
            }
            ends.push(point);
        }
        self.text += &format!("#[point(Q = {}, S = {})]\n", ends[0], ends[1]);
        let expressed = if self.chance(3) { ", expressed = A1" } else { "" };
        match self.chance(4) {
            true => {
                self.class("distance row");
                self.text += "#[constraint(strut: dot(Q - S, Q - S) == 1.40)]\n";
            }
            false => {
                self.class("vector row of positions");
                self.text += &format!("#[constraint(closure: Q == S{expressed})]\n");
            }
        }
    }

    /// A blade on a base in the plane, with links on it.
    fn knife(&mut self) {
        let base = self.floating_in_plane();
        self.body(base);
        for _ in 0..self.writer.random.below(3) {
            let parent = self.links.len() - 1;
            let link = self.revolute(parent);
            self.body(link);
        }
        let blade = match self.chance(2) {
            true => base,
            false => self.links.len() - 1,
        };
        let place = self.place(blade);
        self.text += &format!("#[point(Blade = {place})]\n");
        let row = match self.chance(2) {
            true => format!("dot(velocity(Blade), A{blade}.y)"),
            false => format!("dot(velocity(Blade, {}), unit(A{blade}.x + 2*A{blade}.y))", self.bodies[blade - 1].0),
        };
        self.class("scalar row of velocities");
        self.text += &format!("#[constraint(blade: {row} == 0)]\n");
    }

    /// A chain by families.
    fn family(&mut self) {
        let n = 2 + self.writer.random.below(3);
        let spatial = self.chance(2);
        self.class(if spatial { "family in space" } else { "family in the plane" });
        let axis = if spatial { "unit(A[i - 1].y + i*A[i - 1].z)" } else { "z" };
        let (length, offset) = (self.between(0.6, 1.1), self.between(0.2, 0.5));
        self.text += &format!(
            "#[size(n = {n})]
#[frame(A[0] = rotate(N, z, q[0]), A[i] = rotate(A[i - 1], {axis}, q[i]) for i in 1..n)]
#[point(P[0] = O, P[i] = P[i - 1] + {length}*A[i - 1].x for i in 1..n)]
#[body(link[i] = {{
    frame: A[i], center: P[i] + {offset}*A[i].x, mass: 1 + i/2, inertia: cuboid(1 + i/2, 0.60, 0.30, 0.40)
}} for i in 0..n)]
#[particle(bead[i] = {{ at: P[i] + {offset}*A[i].y, mass: p1 }} for i in 1..n)]
#[damper(joint[i] = {{ of: q[i] - q[i - 1], coefficient: p2/2 }} for i in 1..n)]
#[spring(cord[i] = {{ from: O + 3*N.x + 2*N.y, to: P[i], stiffness: p3, length: i/4 }} for i in 1..n)]
#[armature(rotor[i] = {{ of: q[i], inertia: 0.10 }} for i in 0..n)]
#[generalized_force(q[i] = -0.20*dot(q[i]) for i in 0..n)]
"
        );
        for class in ["particle", "damper along a scalar", "spring between points", "armature", "generalised force"] {
            self.class(class);
        }
        for i in 0..n {
            self.coordinates.push(format!("q[{i}]"));
            self.links.push((format!("A[{i}]"), format!("P[{i}]")));
            self.bodies.push((format!("link[{i}]"), i + 1));
        }
    }
}
