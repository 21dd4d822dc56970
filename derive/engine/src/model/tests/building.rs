use super::super::RowKind;
use super::{DISK, FIELDS, assert_all, assert_matrix, assert_unit, errors, system};

#[test]
fn the_disk_in_six_speeds() {
    let rows = "
        #[constraint(no_slip_along: v1 + r*v6 == 0)]
        #[constraint(no_slip_across: v2 == 0)]
        #[constraint(contact: v3 - r*v4 == 0)]
        #[constraint(height: z == 0)]
        #[independent(v6, v5, v4)]
        #[start(theta = PI/6, v6 = -6)]";
    let mut s = system(&format!("{DISK}{rows}{FIELDS}"));
    let kinematics = s.kinematics.clone();
    let product = kinematics.a.mul(&mut s.graph, &kinematics.b);
    assert_unit(&mut s, &product);
    // (6.2) with the two entries that the errata correct.
    assert_matrix(
        &mut s,
        &kinematics.a,
        &[
            &[
                "cos(phi)",
                "-sin(theta)*sin(phi)",
                "cos(theta)*sin(phi)",
                "-r*cos(theta)*sin(phi)",
                "r*tan(theta)*cos(phi)",
                "0",
            ],
            &[
                "sin(phi)",
                "sin(theta)*cos(phi)",
                "-cos(theta)*cos(phi)",
                "r*cos(theta)*cos(phi)",
                "r*tan(theta)*sin(phi)",
                "0",
            ],
            &["0", "cos(theta)", "sin(theta)", "-r*sin(theta)", "0", "0"],
            &["0", "0", "0", "0", "1/cos(theta)", "0"],
            &["0", "0", "0", "-1", "0", "0"],
            &["0", "0", "0", "0", "-tan(theta)", "1"],
        ],
    );
    // The rotation is inverted by its transpose: the only singularity is that of the chart.
    let pivots: Vec<String> = kinematics.pivots.iter().map(|pivot| s.graph.display(*pivot)).collect();
    assert_eq!(pivots, ["cos(theta)"]);
    let diagonal: Vec<_> = (0..6).map(|i| s.inertia.get(i, i)).collect();
    assert_all(&mut s, &diagonal, &["m", "m", "m", "j", "j", "2*j"]);
    let forces = s.forces.clone();
    assert_all(&mut s, &forces[2..4], &["m*(v5*v1 - v4*v2 - g*sin(theta))", "j*v5*(v5*tan(theta) - 2*v6)"]);
    let names: Vec<&str> = s.parameters.iter().map(|parameter| s.graph.name(*parameter)).collect();
    assert_eq!(names, ["m", "r", "j", "g"]);
    assert_eq!(s.rows.len(), 4);
    let RowKind::Velocity(contact) = s.rows[2].kind else { panic!("not a velocity row") };
    assert_all(&mut s, &[contact], &["v3 - r*v4"]);
    let RowKind::Position(height) = s.rows[3].kind else { panic!("not a position row") };
    assert_all(&mut s, &[height], &["z"]);
    let independent: Vec<_> = s.independent[0].speeds.iter().map(|speed| speed.expr).collect();
    assert_all(&mut s, &independent, &["v6", "v5", "v4"]);
    assert_eq!(s.start[0], (s.coordinates[4], std::f64::consts::PI / 6.0));
    assert_eq!(s.start[1], (s.speeds[5], -6.0));
    assert_eq!(s.nominal, [(s.parameters[3], 9.81)]);
}

#[test]
fn the_disk_in_five_coordinates() {
    let rows = "
        #[configuration(z = 0)]
        #[constraint(along: dot(x) + r*dot(psi)*cos(phi) == 0)]
        #[constraint(across: dot(y) + r*dot(psi)*sin(phi) == 0)]
        #[independent(dot(phi), dot(theta), dot(psi))]";
    let mut s = system(&format!("{DISK}{rows}{FIELDS}"));
    let configuration = s.configuration.clone().unwrap();
    let names = |symbols: &[crate::symbolic::Symbol]| {
        symbols.iter().map(|symbol| s.graph.name(*symbol).to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(names(&configuration.coordinates), ["x", "y", "phi", "theta", "psi"]);
    assert_eq!(names(&configuration.rates), ["dot_x", "dot_y", "dot_phi", "dot_theta", "dot_psi"]);
    assert_all(&mut s, &configuration.map, &["x", "y", "0", "phi", "theta", "psi"]);
    let independent: Vec<_> = s.independent[0].speeds.iter().map(|speed| speed.expr).collect();
    let rates = s.graph.vars(&configuration.rates[2..]);
    assert_eq!(independent, rates);
    // (6.1a) with dot(x) by (6.2).
    let RowKind::Velocity(along) = s.rows[0].kind else { panic!("not a velocity row") };
    let text = "cos(phi)*v1 - sin(theta)*sin(phi)*v2 + cos(theta)*sin(phi)*v3 - r*cos(theta)*sin(phi)*v4 \
                + r*tan(theta)*cos(phi)*v5 + r*cos(phi)*(v6 - tan(theta)*v5)";
    assert_all(&mut s, &[along], &[text]);
}

#[test]
fn without_speeds_the_rates_are_the_speeds() {
    let mut s = system(
        "#[coordinates(x, y)]
         #[inertia(matrix([m, m*a*cos(x)], [_, m + i]))]
         #[forces(-m*G*cos(w*t) + u, -d*dot(y))]
         #[define(a = b*c, c = b/2, G = g)]
         #[inputs(u)]
         #[constraint(rod: x*sin(w*t) == y*cos(w*t))]
         #[constraint(roll: dot(x) - dot(y) == 1e-1)]
         struct Bead<S> where f64: From<S> { m: f64, b: S, i: f64, g: f64, w: f64, d: f64 }",
    );
    let names: Vec<&str> = s.speeds.iter().map(|speed| s.graph.name(*speed)).collect();
    assert_eq!(names, ["dot_x", "dot_y"]);
    let (a, inertia, forces) = (s.kinematics.a.clone(), s.inertia.clone(), s.forces.clone());
    assert_unit(&mut s, &a);
    let coupling = "m*b*b*b*b*cos(x)/2/b/b";
    assert_matrix(&mut s, &inertia, &[&["m", coupling], &[coupling, "m + i"]]);
    assert_all(&mut s, &forces, &["u - m*g*cos(w*t)", "-d*dot_y"]);
    let kinds: Vec<bool> = s.rows.iter().map(|row| matches!(row.kind, RowKind::Velocity(_))).collect();
    assert_eq!(kinds, [false, true]);
    let RowKind::Velocity(roll) = s.rows[1].kind else { panic!("not a velocity row") };
    assert_all(&mut s, &[roll], &["dot_x - dot_y - 1/10"]);
}

#[test]
fn further_coordinates() {
    let mut s = system(
        "#[coordinates(x, y)]
         #[inertia(diag(m, m))]
         #[forces(0, -m*g)]
         #[configuration(of(alpha), x = l*sin(alpha), y = -l*cos(alpha))]
         #[constraint(rod: x*x + y*y == l*l)]
         #[independent(dot(alpha))]
         struct Pendulum { m: f64, l: f64, g: f64 }",
    );
    let configuration = s.configuration.clone().unwrap();
    assert_eq!(configuration.coordinates.len(), 1);
    assert_all(&mut s, &configuration.map, &["l*sin(alpha)", "-l*cos(alpha)"]);
    let independent = s.independent[0].speeds[0].expr;
    assert_all(&mut s, &[independent], &["dot_alpha"]);
}

#[test]
fn complement_by_rows() {
    let rows = "
        #[constraint(no_slip_along: v1 + r*v6 == 0)]
        #[constraint(no_slip_across: v2 == 0)]
        #[constraint(contact: v3 - r*v4 == 0)]
        #[complement(spin = [-r, 0, 0, 0, 0, 1], v5 = [0, 0, 0, 0, 1, 0], v4 = [0, 0, r, 1, 0, 0])]";
    let mut s = system(&format!("{DISK}{rows}{FIELDS}"));
    let complement = s.complement.clone().unwrap();
    assert_eq!(complement[0].name, "spin");
    assert_all(&mut s, &complement[2].entries, &["0", "0", "r", "1", "0", "0"]);
}

/// Every field counts for names, only those that are mentioned must be numbers.
#[test]
fn fields_that_pass_through() {
    let source = "
        #[coordinates(x)] #[inertia(diag(m))] #[forces(0)]
        struct Model<'a> { m: f64, track: &'a [f64], name: String }";
    assert_eq!(system(source).parameters.len(), 1);
    assert_eq!(
        errors(&source.replace("forces(0)", "forces(track)")),
        ["2:56 `track`: the field `track` has the type `& 'a [f64]`; equations need `f64` or a type parameter"]
    );
}

#[test]
fn raw_fields_pass_through_too() {
    let source = "#[coordinates(x)] #[inertia(diag(1))] #[forces(0)]
        struct Model { r#type: f64 }";
    assert!(system(source).parameters.is_empty());
    assert_eq!(
        errors(&source.replace("forces(0)", "forces(r#type)")),
        ["1:48 `r#type`: the raw identifier `r#type` cannot be a name in equations; choose another name"]
    );
}

/// A long sum is one node, whatever its length; nothing recurses over its terms.
#[test]
fn long_sums() {
    let sum = (0..20_000).map(|i| format!("{i}*x")).collect::<Vec<_>>().join(" - ");
    let s = system(&format!("#[coordinates(x)] #[inertia(diag(1))] #[forces({sum})] struct Model;"));
    assert_eq!(s.graph.display(s.forces[0]), "-199990000*x");
}

#[test]
fn the_same_model_gives_the_same_graph() {
    let source = format!("{DISK}{FIELDS}");
    let (one, two) = (system(&source), system(&source));
    assert_eq!(one.graph.len(), two.graph.len());
    assert_eq!(one.kinematics.a, two.kinematics.a);
    assert_eq!(one.forces, two.forces);
}
