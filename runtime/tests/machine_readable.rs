//! `MODEL` in JSON: everything that it says, and formulas that are read back as they were.

#![cfg(all(feature = "serde", feature = "derive"))]

use holonomy::ConstrainedSystem;
use holonomy::equations::Formula;
use serde_json::{Value, json, to_value};

/// A pendulum on a slope that a force pushes, with something of everything in it.
#[derive(ConstrainedSystem, Clone)]
#[coordinates(x, y)]
#[inputs(push)]
#[inertia(diag(m, m))]
#[forces(push, -m*g)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
#[independent(dot(x))]
#[independent(dot(y))]
#[start(x = 0.6, y = -0.8)]
#[output(tension = -l*reaction(rod), bent = if y < 0 { y } else { sin(x)/2 }, slope = dot(y)/dot(x))]
struct Pendulum {
    #[nominal(2.0)]
    m: f64,
    #[nominal(1.0)]
    l: f64,
    #[nominal(9.81)]
    g: f64,
}

fn model() -> Value {
    to_value(Pendulum::MODEL).unwrap()
}

#[test]
fn fields_stand_under_their_names() {
    let json = model();
    let m = Pendulum::MODEL;
    assert_eq!(json["name"], "Pendulum");
    for (field, names) in [
        ("coordinates", m.coordinates),
        ("state_coordinates", m.state_coordinates),
        ("state_speeds", m.state_speeds),
        ("reduced_speeds", m.reduced_speeds),
        ("velocities", m.velocities),
        ("parameters", m.parameters),
        ("inputs", m.inputs),
        ("defines", m.defines),
        ("position_rows", m.position_rows),
        ("carriers", m.carriers),
        ("notes", m.notes),
    ] {
        assert_eq!(json[field], json!(names), "{field}");
    }
    assert_eq!(json["rows"], json!([{"name": "rod", "level": "position", "linear": true, "redundant": false}]));
    assert_eq!(json["multipliers"], json!([{"name": "rod", "row": 0}]));
    let slope = json!({"name": "slope", "level": "velocity", "inputs": false, "divisors": m.outputs[2].divisors});
    assert_eq!((&json["outputs"][0]["level"], &json["outputs"][2]), (&json!("acceleration"), &slope));
    let [along, up] = json["charts"].as_array().unwrap().as_slice() else { panic!("two charts") };
    assert_eq!((&along["speeds"], &up["speeds"]), (&json!(["dot_x"]), &json!(["dot_y"])));
    assert_eq!(up["relative_pivot"], json!(m.charts[1].relative_pivot.unwrap()));
    let guard = &json["guards"][0];
    assert_eq!((&guard["name"], &guard["kind"], &guard["start"]), (&json!("y"), &json!("pivot"), &json!(-0.8)));
    assert_eq!((&guard["origin"], &guard["rows"]), (&json!(m.guards[0].origin), &json!(["rod"])));
    assert_eq!(json["parameter_guards"].as_array().unwrap().len(), m.parameter_guards.len());
    let (costs, first) = (json["operations"].as_array().unwrap(), &m.operations[0]);
    assert_eq!(costs.len(), m.operations.len());
    let counts = [
        first.additions,
        first.multiplications,
        first.divisions,
        first.roots,
        first.sincos,
        first.selections,
        first.others,
    ];
    let names = ["additions", "multiplications", "divisions", "roots", "sincos", "selections", "others"];
    assert_eq!(costs[0]["function"], first.function);
    assert_eq!(names.map(|name| costs[0][name].as_u64().unwrap()), counts.map(|n| n as u64));
}

#[test]
fn equations_have_their_formulas() {
    let json = model();
    let equations = json["equations"].as_array().unwrap();
    assert_eq!(equations.len(), Pendulum::MODEL.equations.len());
    let mut kinds = Vec::new();
    for (json, equation) in equations.iter().zip(Pendulum::MODEL.equations) {
        assert_eq!((&json["symbol"], &json["source"]), (&json!(equation.symbol), &json!(equation.source)));
        assert_eq!((&json["text"], &json["function"]), (&json!(equation.text), &json!(equation.function)));
        let formula: Formula = serde_json::from_value(json["formula"].clone()).unwrap();
        assert_eq!(Ok(formula), equation.formula(), "{}", equation.text);
        kinds.extend(json["formula"].as_object().unwrap().keys().cloned());
    }
    for kind in ["matrix", "vector", "symbol", "negative", "select"] {
        assert!(kinds.iter().any(|known| known == kind), "no {kind} among {kinds:?}");
    }
    let bent = equations.iter().find(|e| e["symbol"] == "bent").unwrap();
    let half = json!({"quotient": {
        "numerator": {"call": {"function": "sin", "arguments": [{"symbol": "x"}]}},
        "denominator": {"number": "2"},
    }});
    let y = json!({"symbol": "y"});
    assert_eq!(bent["formula"], json!({"select": {"condition": y, "negative": y, "otherwise": half}}));
}

#[test]
fn a_text_that_is_no_formula_has_none() {
    let mut equation = Pendulum::MODEL.equations[0];
    equation.text = "what else there is";
    let json = to_value(equation).unwrap();
    assert_eq!((&json["symbol"], &json["formula"]), (&json!(equation.symbol), &Value::Null));
    assert_eq!(json["text"], "what else there is");
}
