//! The implementation of the trait.

use super::charts::chosen;
use super::description::{bare, model};
use super::equations::Texts;
use super::functions::{docs, function, signature, tokens};
use super::recursive;
use super::shape::{Known, Types};
use super::target::{Target, ident};
use super::text::{Writer, user_function};
use super::types::{Structs, allowed, doc, placeholders, structs};
use crate::program::{Arguments, Programs, Shape};
use crate::projection::Equations;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The structs of a model and its `ConstrainedSystem`.
pub fn implementation(target: &Target, equations: &Equations, programs: &Programs) -> TokenStream {
    let types = Types::new(target, Known::of(equations), Some(&programs.names));
    let texts = Texts::new(equations);
    let structs = structs(target, &types, Some(programs));
    let mut functions = TokenStream::new();
    let mut parts = TokenStream::new();
    for program in &programs.charts {
        let emitted = function(target, &types, programs, program, &texts);
        parts.extend(emitted.function);
        parts.extend(emitted.parts);
    }
    for program in &programs.functions {
        let emitted = function(target, &types, programs, program, &texts);
        functions.extend(emitted.function);
        parts.extend(emitted.parts);
    }
    if equations.is_recursive() {
        functions.extend(recursive::functions(target, &types));
    }
    let model = model(target, &types, equations, programs, &texts);
    let prepare = prepare(target, &types, programs);
    let charts = chosen(target, &types);
    let implementation = block(target, &types, &model, &quote!(#prepare #functions #charts));
    let given = user_functions(target);
    whole(&structs, &quote!(#given #parts), &implementation)
}

/// The user's functions with their derivatives, one constant each: a function of another type is an error at its path.
fn user_functions(target: &Target) -> TokenStream {
    let constants = target.functions.iter().enumerate().map(|(i, orders)| {
        let name = ident(&user_function(i), proc_macro2::Span::call_site());
        quote!(const #name: &[fn(f64) -> f64] = &[#(#orders),*];)
    });
    quote!(#(#constants)*)
}

/// The structs and the trait of a model with errors, so that only those errors show: its functions diverge.
pub fn diverging(target: &Target, known: &Known) -> TokenStream {
    let types = Types::new(target, known.clone(), None);
    let mut structs = structs(target, &types, None);
    structs.definitions.extend(placeholders(target, &types));
    let krate = &target.krate;
    let scalar = &types.scalar;
    let speeds = known.state.len().saturating_sub(known.state_coordinates);
    let (k, n, m, x) = (known.reduced, known.velocities.len(), known.rows, known.coordinates.len());
    use Arguments::{
        Coordinates, CoordinatesVelocities, CoordinatesVelocitiesInputs, State, StateCarriers, StateInputs,
        StateVelocities,
    };
    let all: [(&str, Arguments, Vec<Shape>); 25] = [
        ("derivative", StateInputs, vec![Shape::State, Shape::Array(known.guards)]),
        ("accelerations", StateInputs, vec![Shape::Array(speeds)]),
        ("mass_matrix", State, vec![Shape::Matrix(k, k)]),
        ("forcing", StateInputs, vec![Shape::Array(k)]),
        ("mass_matrix_and_forcing", StateInputs, vec![Shape::Matrix(k, k), Shape::Array(k)]),
        ("coordinates", State, vec![Shape::Array(x)]),
        ("velocities", State, vec![Shape::Velocities]),
        ("complement", State, vec![Shape::Matrix(k, n)]),
        ("complement_bias", State, vec![Shape::Velocities]),
        ("velocity_rates", StateInputs, vec![Shape::Velocities]),
        ("multipliers", StateInputs, vec![Shape::Multipliers]),
        ("guards", State, vec![Shape::Array(known.guards)]),
        ("kinematic_matrix", Coordinates, vec![Shape::Matrix(n, n)]),
        ("kinematic_bias", Coordinates, vec![Shape::Array(x)]),
        ("inertia", Coordinates, vec![Shape::Matrix(n, n)]),
        ("forces", CoordinatesVelocitiesInputs, vec![Shape::Velocities]),
        ("constraint_matrix", CoordinatesVelocities, vec![Shape::Matrix(m, n)]),
        ("constraint_bias", CoordinatesVelocities, vec![Shape::Array(m)]),
        ("position_residual", Coordinates, vec![Shape::Array(known.position_rows)]),
        ("velocity_residual", CoordinatesVelocities, vec![Shape::Array(known.velocity_rows)]),
        ("kinetic_energy", CoordinatesVelocities, vec![Shape::Scalar]),
        ("potential_energy", Coordinates, vec![Shape::Optional(false)]),
        ("carried_velocities", StateCarriers, vec![Shape::Velocities]),
        ("carried_rates", StateCarriers, vec![Shape::Array(known.state_coordinates)]),
        ("chart_speeds", StateVelocities, vec![Shape::Array(speeds)]),
    ];
    let functions = all.iter().map(|(name, reads, shapes)| {
        let chart = (*name == "chart_speeds").then_some("chart");
        let signature = signature(target, &types, name, chart, *reads, shapes);
        quote!(#signature { loop {} })
    });
    let parameters = types.of(target, &types.parameters, &quote!(f64));
    let (given, values) =
        (types.of(target, &types.parameters, &quote!(#scalar)), types.of(target, &types.values, &quote!(#scalar)));
    let fields = &target.parameters;
    let prepare = quote! {
        fn parameters(&self) -> #parameters {
            // Read, so that no warning about unused fields joins the errors.
            let _ = (#(&self.#fields,)*);
            loop {}
        }
        fn values<#scalar: #krate::Scalar>(
            &self,
            p: &#given,
        ) -> ::core::result::Result<#values, #krate::Error> { loop {} }
    };
    let implementation = block(target, &types, &bare(target, &types), &quote!(#prepare #(#functions)*));
    whole(&structs, &TokenStream::new(), &implementation)
}

/// Structs stand beside the user's; everything else in a scope of its own, under one list of lints.
fn whole(structs: &Structs, parts: &TokenStream, implementation: &TokenStream) -> TokenStream {
    let allowed = allowed();
    let Structs { definitions, implementations } = structs;
    quote! {
        #definitions
        #allowed
        const _: () = {
            #implementations
            #parts
            #implementation
        };
    }
}

/// The `impl` with its types.
fn block(target: &Target, types: &Types, model: &TokenStream, functions: &TokenStream) -> TokenStream {
    let (krate, ident, scalar) = (&target.krate, &target.ident, &types.scalar);
    let known = &types.known;
    let (generics, arguments, clause) = target.generics.split_for_impl();
    let t = quote!(#scalar);
    let of = |record| types.of(target, record, &t);
    let (state, parameters, velocities) = (of(&types.state), of(&types.parameters), of(&types.velocities));
    let (multipliers, inputs, values) = (of(&types.multipliers), of(&types.inputs), of(&types.values));
    let outputs = of(&types.outputs);
    let array = |n: usize| {
        let n = Literal::usize_unsuffixed(n);
        quote!([#t; #n])
    };
    let matrix = |rows: usize, columns: usize| {
        let (rows, columns) = (Literal::usize_unsuffixed(rows), Literal::usize_unsuffixed(columns));
        quote!(#krate::__private::SMatrix<#t, #rows, #columns>)
    };
    let (k, n, m) = (known.reduced, known.velocities.len(), known.rows);
    let speeds = array(known.state.len().saturating_sub(known.state_coordinates));
    let (coordinates, reduced, guards) = (array(known.coordinates.len()), array(k), array(known.guards));
    let (rows, velocity_rows, positions) = (array(m), array(known.velocity_rows), array(known.position_rows));
    let (chart_guards, carriers) = (array(known.chart_guards), array(known.carriers.len()));
    let state_coordinates = array(known.state_coordinates);
    let (mass, system, constraint, complement) = (matrix(k, k), matrix(n, n), matrix(m, n), matrix(k, n));
    quote! {
        #[automatically_derived]
        impl #generics #krate::ConstrainedSystem for #ident #arguments #clause {
            const MODEL: &'static #krate::Description = #model;

            type State<#t: #krate::Scalar> = #state;
            type Parameters<#t: #krate::Scalar> = #parameters;
            type Velocities<#t: #krate::Scalar> = #velocities;
            type Multipliers<#t: #krate::Scalar> = #multipliers;
            type Inputs<#t: #krate::Scalar> = #inputs;
            type Outputs<#t: #krate::Scalar> = #outputs;
            type Coordinates<#t: #krate::Scalar> = #coordinates;
            type Speeds<#t: #krate::Scalar> = #speeds;
            type Reduced<#t: #krate::Scalar> = #reduced;
            type Guards<#t: #krate::Scalar> = #guards;
            type ChartGuards<#t: #krate::Scalar> = #chart_guards;
            type Carriers<#t: #krate::Scalar> = #carriers;
            type StateCoordinates<#t: #krate::Scalar> = #state_coordinates;
            type Rows<#t: #krate::Scalar> = #rows;
            type VelocityRows<#t: #krate::Scalar> = #velocity_rows;
            type PositionRows<#t: #krate::Scalar> = #positions;
            type Values<#t: #krate::Scalar> = #values;
            type MassMatrix<#t: #krate::Scalar> = #mass;
            type SystemMatrix<#t: #krate::Scalar> = #system;
            type ConstraintMatrix<#t: #krate::Scalar> = #constraint;
            type Complement<#t: #krate::Scalar> = #complement;

            #functions
        }
    }
}

/// `parameters` and `values`.
fn prepare(target: &Target, types: &Types, programs: &Programs) -> TokenStream {
    let (krate, scalar) = (&target.krate, &types.scalar);
    let fields = types.parameters.idents(target);
    let given = &target.parameters;
    let body = if fields.is_empty() {
        quote!([])
    } else {
        let name = target.type_name("Parameters");
        quote!(#name { #(#fields: ::core::convert::From::from(self.#given)),* })
    };
    let values = &programs.values;
    let text = scalar.to_string();
    let writer = Writer { code: &values.code, layout: &values.layout, names: &programs.names, scalar: &text };
    // However long, this stays one function: it runs once.
    let lets: String = values.layout.parts.iter().map(|part| writer.blocks(part)).collect();
    let lets = tokens(&lets);
    let (quantities, guards) = values.code.outputs.split_at(values.quantities.len() - values.parameters);
    let expression = |r: &u32| tokens(&writer.expression(*r));
    let finite = (!fields.is_empty()).then(|| {
        quote! {
            #krate::__private::check_parameters(
                <Self as #krate::ConstrainedSystem>::MODEL.parameters,
                &[#(p.#fields),*],
            )?;
        }
    });
    let guarded = (!guards.is_empty()).then(|| {
        let guards = guards.iter().map(expression);
        quote! {
            #krate::__private::check_parameter_guards(
                <Self as #krate::ConstrainedSystem>::MODEL.parameter_guards,
                &[#(#guards),*],
            )?;
        }
    });
    let result = if types.values.fields.is_empty() {
        quote!(::core::result::Result::Ok([]))
    } else {
        let name = target.type_name("Values");
        let all = types.values.fields.iter().map(|f| ident(f, proc_macro2::Span::call_site())).collect::<Vec<_>>();
        let (own, added) = all.split_at(values.parameters);
        let derived = added.iter().zip(quantities).map(|(field, r)| {
            let value = writer.expression(*r);
            if *field == value {
                quote!(#field)
            } else {
                let value = tokens(&value);
                quote!(#field: #value)
            }
        });
        let own = own.iter().map(|field| quote!(#field: p.#field));
        let fields = own.chain(derived);
        // A quotient or a root of parameters that the model itself writes has no guard.
        let texts = programs.graph.display_all(&values.quantities[values.parameters..]);
        let sound = (!added.is_empty())
            .then(|| quote!(#krate::__private::check_parameters(&[#(#texts),*], &[#(values.#added),*])?;));
        quote! {
            let values = #name { #(#fields),* };
            #sound
            ::core::result::Result::Ok(values)
        }
    };
    let parameters = types.of(target, &types.parameters, &quote!(f64));
    let given = types.of(target, &types.parameters, &quote!(#scalar));
    let prepared = types.of(target, &types.values, &quote!(#scalar));
    let about =
        docs("values", "Checks the parameters and does the work that depends on them alone.", &values.count, None);
    let own = doc("The parameters as they stand in the struct.");
    quote! {
        #own
        fn parameters(&self) -> #parameters {
            #body
        }
        #about
        fn values<#scalar: #krate::Scalar>(
            &self,
            p: &#given,
        ) -> ::core::result::Result<#prepared, #krate::Error> {
            #finite
            #lets
            #guarded
            #result
        }
    }
}
