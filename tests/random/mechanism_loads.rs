//! What acts on random mechanisms, their speeds and outputs, and their text as a whole.

use super::mechanisms::Tree;

impl Tree {
    /// All statements, coordinates first.
    pub(super) fn statements(&mut self) -> String {
        let family = self.kind == "family";
        let own = !family
            && self.speeds.len() == self.coordinates.len() + self.components.len() / 4 * 3
            && match self.kind {
                "speeds as components" | "speeds of its own beside quaternions" => true,
                "tree in the plane" | "tree in space" | "knife edge" => self.chance(5),
                _ => false,
            };
        let names: Vec<String> = (1..=self.speeds.len()).map(|i| format!("u{i}")).collect();
        let mut head = match family {
            true => "#[coordinates(q[n])]\n".to_string(),
            false => format!("#[coordinates({})]\n", [&self.coordinates[..], &self.components].concat().join(", ")),
        };
        let inputs = self.chance(4);
        if inputs {
            self.class("inputs");
            head += "#[inputs(tau)]\n";
        }
        let mut tail = String::new();
        if own {
            self.class("speeds of its own");
            head += &format!("#[speeds({})]\n", names.join(", "));
            let given: Vec<String> = names.iter().zip(&self.speeds).map(|(u, e)| format!("    {u} = {e},\n")).collect();
            tail += &format!("#[kinematics(\n{})]\n", given.concat());
        }
        self.loads(inputs, if own { &names } else { &[] });
        if self.chance(2) {
            self.outputs();
        }
        // the size of a family stands before what it sizes
        let body = std::mem::take(&mut self.text);
        let (sizes, body): (Vec<&str>, Vec<&str>) =
            body.split_inclusive('\n').partition(|line| line.starts_with("#[size"));
        sizes.concat() + &head + &body.concat() + &tail
    }

    /// A link at random, never the ground.
    fn some_link(&mut self) -> (String, String) {
        let number = 1 + self.writer.random.below(self.links.len() - 1);
        self.links[number].clone()
    }

    fn loads(&mut self, inputs: bool, speeds: &[String]) {
        if !self.chance(4) {
            self.class("gravity");
            let g = ["-9.81*N.y", "-9.81*N.z", "p1*(3/5*N.x - 4/5*N.z)"][self.writer.random.below(3)];
            self.text += &format!("#[gravity({g})]\n");
        }
        if inputs {
            let (frame, _) = self.some_link();
            let from = self.some_link().0;
            let from = if from == frame { String::new() } else { format!(", from: {from}") };
            self.class(if from.is_empty() { "torque from the ground" } else { "torque with its reaction" });
            self.text += &format!("#[torque(drive = {{ on: {frame}, value: tau*{frame}.z{from} }})]\n");
        }
        for (load, chance) in [("force", 3), ("pair", 4), ("drag", 4), ("torque", 4), ("spring", 3), ("winding", 4)] {
            if self.chance(chance) {
                self.load(load);
            }
        }
        for (load, chance) in [("damper", 4), ("friction", 4), ("armature", 4), ("particle", 3), ("generalised", 4)] {
            if self.chance(chance) {
                self.load(load);
            }
        }
        if self.chance(6) {
            self.class("V beside bodies");
            let q = self.writer.random.one_of(&self.coordinates).clone();
            self.text += &format!("#[potential_energy(p2*sin({q}))]\n");
        }
        if self.kind != "family" && self.chance(8) && self.components.is_empty() {
            self.class("further forces");
            let forces = (0..self.coordinates.len()).map(|i| if i == 0 { "0.40*p1" } else { "0" });
            self.text += &format!("#[forces({})]\n", forces.collect::<Vec<_>>().join(", "));
        }
        if let Some(speed) = speeds.first().cloned()
            && self.chance(2)
        {
            self.class("force along a speed");
            self.text += &format!("#[generalized_force({speed} = -p1*{speed} + 0.30)]\n");
        }
    }

    fn load(&mut self, load: &str) {
        let (frame, point) = self.some_link();
        let c = self.between(0.5, 2.0);
        let q = self.writer.random.one_of(&self.coordinates).clone();
        let ground = format!("O{}*N.x{}*N.y", self.writer.signed(2.0, 3.0), self.writer.signed(2.0, 3.0));
        let offset = self.between(0.2, 0.6);
        let (body, of_body) = self.writer.random.one_of(&self.bodies).clone();
        let (own_frame, own_point) = self.links[of_body].clone();
        let text = match load {
            "force" => {
                self.class("force on a body");
                format!(
                    "#[force(push = {{ at: {own_point} + {offset}*{own_frame}.y, value: {c}*{frame}.x + p1*N.y, on: {body} }})]\n"
                )
            }
            "pair" => {
                self.class("force with its reaction");
                format!(
                    "#[force(pull = {{ at: {point} + {offset}*{frame}.z, value: {c}*sin({q})*N.x, from: {own_point} }})]\n"
                )
            }
            "drag" => {
                self.class("force in velocities");
                format!(
                    "#[force(drag = {{ at: {point}, value: -{c}*sqrt(0.20 + dot(velocity({point}), velocity({point})))*velocity({point}) }})]\n"
                )
            }
            "torque" => {
                self.class("torque in velocities");
                format!(
                    "#[torque(swirl = {{ on: {body}, value: -{c}*angular_velocity({own_frame}) + p2*{frame}.y }})]\n"
                )
            }
            "spring" => {
                self.class("spring between points");
                let length = if self.chance(4) { "" } else { ", length: p3" };
                format!(
                    "#[spring(band = {{ from: {ground}, to: {point} + {offset}*{frame}.x, stiffness: {c}{length} }})]\n"
                )
            }
            "winding" => {
                self.class("spring along a scalar");
                format!("#[spring(winding = {{ of: {q} + {offset}*sin({q}), stiffness: {c}, length: 0.30 }})]\n")
            }
            "damper" => {
                self.class("damper between points");
                format!("#[damper(oil = {{ from: {ground}, to: {point} + {offset}*{frame}.y, coefficient: {c} }})]\n")
            }
            "friction" => {
                self.class("damper along a scalar");
                format!("#[damper(friction = {{ of: {c}*{q}, coefficient: p1 }})]\n")
            }
            "armature" => {
                self.class("armature");
                format!("#[armature(motor = {{ of: {c}*{q} + {}/2, inertia: 0.20 }})]\n", self.coordinates[0])
            }
            "particle" => {
                self.class("particle");
                format!("#[particle(extra = {{ at: {point} + {offset}*{frame}.x - 0.30*{frame}.z, mass: p2 }})]\n")
            }
            _ => {
                self.class("generalised force");
                format!("#[generalized_force({q} = {c} - p1*dot({q}))]\n")
            }
        };
        self.text += &text;
    }

    /// Heights, speeds, accelerations and what turns.
    fn outputs(&mut self) {
        let (frame, point) = self.some_link();
        let body = self.bodies.last().map_or_else(String::new, |(name, _)| name.clone());
        self.class("outputs");
        // What holds a point along a direction, as if it were a joint of its own.
        let held = point != "O" && self.speeds.is_empty();
        if held {
            self.class("release");
            self.text += &format!("#[release(hook = {{ point: {point}, along: 3/5*N.x - 4/5*N.y }})]\n");
        }
        let hold = if held { "    hold = reaction(hook),\n" } else { "" };
        self.text += &format!(
            "#[define(upward = dot(N.z, {frame}.x), arm = {point} - 0.40*{frame}.y - O)]
#[output(
    height = dot({point}, N.z) + upward,
    speed = sqrt(1 + dot(velocity({point}), velocity({point}))) + dot(arm, {frame}.z),
    pull = dot(acceleration({point}), {frame}.x) + dot(angular_acceleration({frame}), N.y),
    swirl = dot(cross(arm, velocity({point})), angular_velocity({frame})),
    push = dot(momentum({body}), {frame}.y),
    spin = dot(angular_momentum({body}, {point}), N.x + {frame}.z),
{hold})]
"
        );
    }
}
