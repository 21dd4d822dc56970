//! Closed mechanisms with more rows than they need: rows that others repeat identically, and rows that do so only where the loops
//! are closed, as in a parallelogram with a third bar, a door on two ball joints, or the linkages of Bennett and Sarrus.
//!
//! These move because of what is exactly alike in them, so that this is told by parameters and frames, not by digits.

use super::closed::{Closed, unit};
use super::closed_pose::{Pose, dot, less, norm, sum};

impl Closed {
    /// A base in the plane with a row too many.
    pub(super) fn redundant_in_the_plane(&mut self, loops: usize) {
        match self.tree.writer.random.below(5) {
            0 => self.leaning_plane(),
            1 if loops > 2 => self.gear_ring(),
            1 | 2 if loops > 1 => self.parallel_bars(loops),
            3 => self.held_in_the_plane(),
            _ => {
                self.base();
                self.said_again("pin", 2);
            }
        }
    }

    /// A base in space with a row too many.
    pub(super) fn redundant_in_space(&mut self, loops: usize) {
        match self.tree.writer.random.below(6) {
            0 | 1 if loops > 1 => self.door(loops),
            0 | 2 => self.bennett(),
            3 => self.spherical_four_bar(),
            4 => self.sarrus(),
            _ => {
                self.base();
                self.said_again("spherical", 3);
            }
        }
    }

    /// A plane that leans: the rows of a pin in N are three, and of rank two identically.
    fn leaning_plane(&mut self) {
        self.tree.class("redundant identically: leaning plane");
        self.leaning = true;
        let lean = self.between(0.3, 0.9);
        self.tree.text += &format!("#[frame(T = rotate(N, x, {lean:.2}))]\n");
        self.tree.links[0].0 = "T".to_owned();
        self.poses[0] = Pose::GROUND.turned(unit("x"), lean);
        self.base();
        let joint = ["pin", "revolute"][self.tree.writer.random.below(2)];
        self.close((joint, 2));
    }

    /// Three wheels, each against each: the third pair says nothing new.
    fn gear_ring(&mut self) {
        self.tree.class("redundant identically: gear ring");
        for _ in 0..3 {
            self.turning(0, &["z"]);
        }
        let [a, b, c] = [0, 1, 2].map(|i| self.start[i].clone());
        for (name, rate, (one, first), (other, second), mark) in [
            ("mesh1", 2.0, &a, &b, ""),
            ("mesh2", 0.5, &b, &c, ""),
            // a + 2 b and b + c/2 leave a - c
            ("mesh3", -1.0, &a, &c, ", redundant"),
        ] {
            let value = first + rate * second;
            self.tree.text += &format!("#[constraint({name}: {one} + ({rate:.2})*{other} == {value:.15}{mark})]\n");
        }
        self.loops += 3;
        self.tree.class("planar: gears");
    }

    /// Bars of one length on two bodies alike: from the third on they hold nothing that is not held.
    fn parallel_bars(&mut self, loops: usize) {
        self.tree.class("redundant on the manifold: parallel bars");
        let bars = 3 + self.tree.writer.random.below(loops - 1);
        // on the ground, or on a body that moves
        let parent = if self.tree.chance(2) { 0 } else { self.turning(0, &["z"]) };
        let angle = self.between(-1.2, 1.2);
        let offsets: Vec<[f64; 2]> = (0..bars)
            .map(|i| if i == 0 { [0.0; 2] } else { [self.between(0.4, 0.8) * i as f64, self.aside(0.1, 0.6)] })
            .collect();
        let (base, point) = self.tree.links[parent].clone();
        let local =
            |frame: &str, [x, y]: [f64; 2]| format!("{x:.15}*{frame}.x + {y:.15}*{frame}.y").replace("+ -", "- ");
        let mut ends = Vec::new();
        for offset in &offsets {
            let q = self.coordinate(angle);
            let origin = self.poses[parent].place([offset[0], offset[1], 0.0]);
            let pose = Pose { origin, ..self.poses[parent] }.turned(unit("z"), angle);
            let link =
                self.link(&format!("rotate({base}, z, {q})"), &format!("{point} + {}", local(&base, *offset)), pose);
            ends.push((format!("P{link} + p1*A{link}.x"), pose.place([self.values[0], 0.0, 0.0])));
            self.angles.push(q);
        }
        // the coupler hangs on the first bar
        let q = self.coordinate(0.0);
        let pose = Pose { origin: ends[0].1, ..self.poses[parent] };
        let coupler = self.link(&format!("rotate({base}, z, {q})"), &ends[0].0, pose);
        self.angles.push(q);
        for (bar, offset) in offsets.iter().enumerate().skip(1) {
            let mark = if bar > 1 { ", redundant" } else { "" };
            self.tree.text += &format!(
                "#[constraint(bar{bar}: {} == P{coupler} + {}{mark})]\n",
                ends[bar].0,
                local(&format!("A{coupler}"), *offset)
            );
        }
        self.loops += bars - 1;
        self.tree.class("planar: pin");
    }

    /// A four-bar whose coupler could lean out of the plane: the hinge that closes it keeps it there, by more rows than that takes.
    fn held_in_the_plane(&mut self) {
        self.tree.class("redundant on the manifold: coupler held in the plane");
        let crank = self.turning(0, &["z"]);
        let (point, origin) = self.place(crank);
        let (turn, lean) = (self.between(-1.2, 1.2), self.coordinate(0.0));
        let q = self.coordinate(turn);
        let pose = Pose { origin, ..self.poses[crank] }.turned(unit("z"), turn);
        let coupler = self.link(&format!("rotate(rotate(A{crank}, z, {q}), x, {lean})"), &point, pose);
        let rocker = self.turning(0, &["z"]);
        let (end, at) = self.place(coupler);
        let met = self.at(rocker, at);
        self.tree.text += &format!(
            "#[point(Q = {end}, S = {met})]\n#[constraint(hinge: revolute(Q, S, A{coupler}.z, A{rocker}.z), redundant)]\n"
        );
        self.loops += 1;
        self.tree.class("planar: revolute");
    }

    /// A point held once more, along a direction that lies in a moving body.
    fn said_again(&mut self, joint: &str, rows: usize) {
        self.tree.class("redundant on the manifold: said again");
        let [a, b] = self.close((joint, rows));
        let [one, other] = [a, b].map(|link| self.tree.links[link].0.clone());
        let number = self.loops;
        self.tree.text += &format!(
            "#[constraint(again{number}: dot(Q{number} - S{number}, {one}.x + 2*{other}.y) == 0, redundant)]\n"
        );
    }

    /// A body that moves freely, held by two or three ball joints on one line.
    fn door(&mut self, loops: usize) {
        self.tree.class("redundant on the manifold: door");
        let post = if self.tree.chance(2) { 0 } else { self.turning(0, &["z"]) };
        let reach: [f64; 3] = std::array::from_fn(|_| self.aside(0.2, 1.0));
        let terms = [("x", reach[0]), ("y", reach[1]), ("z", reach[2])]
            .map(|(axis, value)| format!("{}*N.{axis}", self.coordinate(value)));
        let [first, second, third] = [0; 3].map(|_| self.aside(0.3, 1.0));
        let q = [first, second, third].map(|angle| self.coordinate(angle));
        let pose = Pose { origin: reach, ..Pose::GROUND };
        let pose = pose.turned(unit("z"), first).turned(unit("x"), second).turned(unit("z"), third);
        let frame = format!("rotate(rotate(rotate(N, z, {}), x, {}), z, {})", q[0], q[1], q[2]);
        let door = self.link(&frame, &format!("O + {}", terms.join(" + ")), pose);
        let (hinge, at) = self.place(door);
        let foot = self.at(post, at);
        let [turn, lean] = self.poses[post].angles_to_axis(pose.axes[2]);
        let base = self.tree.links[post].0.clone();
        self.tree.text += &format!("#[frame(Line = rotate(rotate({base}, z, {turn:.15}), x, {lean:.15}))]\n");
        self.tree.text += &format!("#[point(Hinge = {hinge}, Foot = {foot})]\n");
        self.tree.text += "#[constraint(hinge1: spherical(Hinge, Foot))]\n";
        let hinges = 2 + usize::from(loops > 2 && self.tree.chance(2));
        for number in 2..=hinges {
            let along = format!("{}*p1", number - 1);
            self.tree.text += &format!(
                "#[constraint(hinge{number}: Hinge + {along}*A{door}.z == Foot + {along}*Line.z, redundant)]\n"
            );
        }
        self.loops += hinges;
        self.tree.class("spatial: spherical");
    }

    /// Bennett's linkage: four hinges, opposite links alike, their lengths as the sines of their twists.
    fn bennett(&mut self) {
        self.tree.class("redundant on the manifold: Bennett");
        // sin(p2 + 1/2) and sin(p3/2) are apart whatever the parameters
        let (a, alpha, beta) = (self.values[0], self.values[1] + 0.5, self.values[2] / 2.0);
        let b = a * beta.sin() / alpha.sin();
        let (long, twist) = ("p1*sin(p3/2)/sin(p2 + 1/2)", ["p3/2", "p2 + 1/2"]);
        let links = [(b, beta, long, twist[0]), (a, alpha, "p1", twist[1]), (b, beta, long, twist[0])];
        let chain = |angles: [f64; 3]| {
            let mut pose = Pose::GROUND;
            let mut poses = Vec::new();
            for ((length, twist, ..), angle) in links.iter().zip(angles) {
                let turned = pose.turned(unit("z"), angle);
                poses.push(turned);
                let origin = turned.place([*length, 0.0, 0.0]);
                pose = Pose { origin, ..turned }.turned(unit("x"), *twist);
            }
            (poses, pose)
        };
        let ground = Pose { origin: [-a, 0.0, 0.0], ..Pose::GROUND }.turned(unit("x"), -alpha);
        // tan(θ1/2) tan(θ2/2) = ± sin((α + β)/2)/sin((α - β)/2), or its inverse, by which link is which
        let first = self.between(0.7, 1.5);
        let ratio = ((alpha + beta) / 2.0).sin() / ((alpha - beta) / 2.0).sin();
        let half = (first / 2.0).tan();
        let open = |angle: &f64| {
            let end = chain([first, *angle, -first]).1;
            norm(less(end.origin, ground.origin)) + 1.0 - dot(end.axes[2], ground.axes[2])
        };
        let angles = [ratio, -ratio, 1.0 / ratio, -1.0 / ratio].map(|k| 2.0 * (k / half).atan());
        let second = angles.into_iter().min_by(|a, b| open(a).total_cmp(&open(b))).expect("four angles");
        assert!(open(&second) < 1e-12, "Bennett's linkage is open by {:e}", open(&second));
        let (mut frame, mut point) = ("N".to_owned(), "O".to_owned());
        for ((_, _, long, twist), (angle, pose)) in
            links.iter().zip([first, second, -first].into_iter().zip(chain([first, second, -first]).0))
        {
            let q = self.coordinate(angle);
            let link = self.link(&format!("rotate({frame}, z, {q})"), &point, pose);
            (frame, point) = (format!("rotate(A{link}, x, {twist})"), format!("P{link} + {long}*A{link}.x"));
        }
        self.tree.text +=
            &format!("#[frame(Last = {frame}, Ground = rotate(N, x, -p2 - 1/2))]\n#[point(Q = {point})]\n");
        self.tree.text += "#[constraint(hinge: revolute(Q, O - p1*N.x, Last.z, Ground.z), redundant)]\n";
        self.loops += 1;
        self.tree.class("spatial: revolute");
    }

    /// Four hinges whose axes meet in a point.
    fn spherical_four_bar(&mut self) {
        self.tree.class("redundant on the manifold: spherical four-bar");
        let (mut frame, mut pose) = ("N".to_owned(), Pose::GROUND);
        for arc in 0..3 {
            let angle = self.aside(0.4, 1.2);
            let q = self.coordinate(angle);
            pose = pose.turned(unit("z"), angle);
            let link = self.link(&format!("rotate({frame}, z, {q})"), "O", pose);
            frame = format!("rotate(A{link}, x, p{})", arc + 1);
            pose = pose.turned(unit("x"), self.values[arc]);
        }
        let [turn, lean] = Pose::GROUND.angles_to_axis(pose.axes[2]);
        let ground = format!("rotate(rotate(N, z, {turn:.15}), x, {lean:.15})");
        self.tree.text += &format!("#[frame(Last = {frame}, Ground = {ground})]\n");
        self.tree.text +=
            "#[constraint(hinge: revolute(O + p1*Last.z, O + p1*Ground.z, Last.z, Ground.z), redundant)]\n";
        self.loops += 1;
        self.tree.class("spatial: revolute");
    }

    /// Sarrus' linkage: a plate on two chains of three parallel hinges each rises straight.
    fn sarrus(&mut self) {
        self.tree.class("redundant on the manifold: Sarrus");
        let [first, second] = [0; 2].map(|_| self.aside(0.4, 1.1));
        let mut ends = Vec::new();
        let lengths: [f64; 4] = std::array::from_fn(|_| self.between(0.7, 1.2));
        let across = self.between(0.5, 1.0);
        for (axis, foot, angles, lengths) in [
            ("x", [0.0, 0.0, 0.0], [first, second, -first - second], [lengths[0], lengths[1]]),
            ("y", [across, 0.0, 0.0], [self.aside(0.4, 1.1), self.aside(0.4, 1.1), 0.0], [lengths[2], lengths[3]]),
        ] {
            let mut point = if foot[0] == 0.0 { "O".to_owned() } else { format!("O + {across:.2}*N.x") };
            let mut frame = "N".to_owned();
            let mut pose = Pose { origin: foot, ..Pose::GROUND };
            // the second chain ends at the plate
            let count = if axis == "x" { 3 } else { 2 };
            for (at, angle) in angles.into_iter().take(count).enumerate() {
                let q = self.coordinate(angle);
                pose = pose.turned(unit(axis), angle);
                let link = self.link(&format!("rotate({frame}, {axis}, {q})"), &point, pose);
                if at < 2 {
                    point = format!("P{link} + {:.2}*A{link}.z", lengths[at]);
                    pose.origin = pose.place([0.0, 0.0, lengths[at]]);
                }
                frame = format!("A{link}");
            }
            ends.push((frame, point, pose));
        }
        let (plate, chain) = (self.poses.len() - 3, self.poses.len() - 1);
        let end = sum(ends[1].2.origin, [0.0, self.aside(0.2, 0.5), 0.0]);
        let y = end[1];
        let (frame, point, _) = &ends[1];
        let met = self.at(plate, end);
        self.tree.text += &format!("#[point(Q = {point} + ({y:.2})*{frame}.y, S = {met})]\n");
        self.tree.text += &format!("#[constraint(hinge: revolute(Q, S, A{chain}.y, A{plate}.y), redundant)]\n");
        self.loops += 1;
        self.tree.class("spatial: revolute");
    }
}
