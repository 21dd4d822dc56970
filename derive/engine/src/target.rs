//! What emission needs of the declarations.

use crate::dimensions::Units;
use crate::emit::{Declared, Known, Target};
use crate::projection::Equations;
use crate::syntax::{AXES, Declarations, IndependentEntry, Name, Quantity, Speed};
use proc_macro2::Ident;

/// The user's struct as emission sees it.
pub fn target(declarations: &Declarations, equations: Option<&Equations>, mut units: Units) -> Target {
    if let Some(e) = equations {
        for (name, row) in e.multiplier_names.iter().zip(&e.multiplier_rows) {
            // Rows that are one share λ.
            if let Some(row) = row.map(|row| &e.rows[row].name).filter(|row| *row != name) {
                units.share(name, row);
            }
        }
    }
    let is_used = |field: &Ident| match equations {
        Some(e) => e.parameters.iter().any(|p| field == e.graph.name(*p)),
        None => true,
    };
    let scalars = declarations.fields.iter().filter(|field| field.scalar);
    let parameters = scalars.filter(|field| is_used(&field.ident)).map(|field| field.member.clone()).collect();
    let speeds = declarations.speeds.iter().flat_map(|speeds| &speeds.names);
    let further = declarations.configuration.iter().flat_map(|c| &c.further);
    let quasi = declarations.configuration.iter().flat_map(|c| &c.speeds);
    let free = declarations.velocities.iter().flat_map(|v| &v.further);
    let combined = declarations.independent.iter().flat_map(|list| list.combinations()).map(|(name, _)| name);
    let names = declarations.coordinates.iter().chain(speeds).chain(further).chain(quasi).chain(free).chain(combined);
    let names = names.chain(&declarations.inputs);
    let mut declared: Vec<Declared> = names.map(|name| entry(&name.ident, &name.docs)).collect();
    declared.extend(declarations.fields.iter().map(|field| entry(&field.ident, &field.docs)));
    let rows = declarations.complement.iter().flat_map(|complement| &complement.rows);
    declared.extend(rows.map(|row| entry(&row.name, &[])));
    declared.extend(declarations.constraints.iter().map(|constraint| entry(&constraint.name, &[])));
    // The rows of vector equations stand where their constraint does.
    declared.extend(declarations.constraints.iter().flat_map(|constraint| {
        let name = &constraint.name;
        AXES.map(|axis| Declared { name: format!("{name}_{axis}"), span: name.span(), docs: Vec::new() })
    }));
    Target {
        ident: declarations.ident.clone(),
        vis: declarations.vis.clone(),
        generics: declarations.generics.clone(),
        parameters,
        declared,
        units,
        outputs: declarations.outputs.iter().map(|output| entry(&output.name.ident, &output.name.docs)).collect(),
        defines: declarations.defines.iter().map(|define| define.name.to_string()).collect(),
        functions: declarations.functions.iter().map(|f| f.orders.clone()).collect(),
        krate: declarations.options.krate.clone(),
    }
}

fn entry(ident: &Ident, docs: &[String]) -> Declared {
    let docs = docs.iter().map(|line| syn::parse_quote!(#[doc = #line])).collect();
    Declared { name: ident.to_string(), span: ident.span(), docs }
}

/// What a model with errors still tells of its types.
pub fn known(declarations: &Declarations) -> Known {
    let text = |names: &[Name]| -> Vec<String> { names.iter().map(|name| name.ident.to_string()).collect() };
    let coordinates = text(&declarations.coordinates);
    let rate = |name: &str| format!("dot_{name}");
    let quaternions = declarations.quaternions();
    let speeds = declarations.all_speeds(&quaternions);
    let name = |speed: &Speed| declarations.speed_name(*speed, &quaternions);
    let velocities: Vec<String> = speeds.iter().map(name).collect();
    let norms: Vec<String> = speeds.iter().filter(|speed| matches!(speed, Speed::Norm(_))).map(name).collect();
    let mut state = coordinates.clone();
    if let Some(configuration) = &declarations.configuration {
        state.retain(|x| configuration.map.iter().all(|given| given.name != x));
        state.extend(text(&configuration.further));
    }
    let state_coordinates = state.len();
    let carriers = match &declarations.configuration {
        Some(configuration) if !configuration.speeds.is_empty() => text(&configuration.speeds),
        Some(_) => state.iter().map(|q| rate(q)).collect(),
        None => velocities.clone(),
    };
    if let Some(given) = &declarations.velocities {
        let named = |left: &Quantity| match left {
            Quantity::Name(name) => name.to_string(),
            Quantity::Rate(name, _) => rate(&name.to_string()),
        };
        let kept = carriers.iter().filter(|name| given.map.iter().all(|(left, _)| named(left) != **name));
        state.extend(kept.cloned().chain(text(&given.further)));
    }
    match (&declarations.complement, declarations.independent.first()) {
        _ if declarations.velocities.is_some() => {}
        (Some(complement), _) => state.extend(complement.rows.iter().map(|row| row.name.to_string())),
        (None, Some(independent)) => state.extend(independent.entries.iter().map(|entry| match entry {
            IndependentEntry::Combination { name, .. } => name.ident.to_string(),
            IndependentEntry::Speed(Quantity::Name(name)) => name.to_string(),
            IndependentEntry::Speed(Quantity::Rate(name, _)) => rate(&name.to_string()),
        })),
        (None, None) => state.extend(carriers.iter().filter(|name| !norms.contains(name)).cloned()),
    }
    let mut seen = std::collections::BTreeSet::new();
    state.retain(|name| seen.insert(name.clone()));
    let scalars = declarations.fields.iter().filter(|field| field.scalar);
    Known {
        state_coordinates: state_coordinates.min(state.len()),
        state,
        coordinates,
        velocities,
        multipliers: declarations.constraints.iter().map(|constraint| constraint.name.to_string()).collect(),
        inputs: text(&declarations.inputs),
        outputs: declarations.outputs.iter().map(|output| output.name.ident.to_string()).collect(),
        parameters: scalars.map(|field| field.ident.to_string()).collect(),
        guards: 0,
        reduced: 0,
        rows: declarations.constraints.len(),
        velocity_rows: 0,
        position_rows: 0,
        carriers,
        charts: 1,
        chart_guards: 0,
    }
}
