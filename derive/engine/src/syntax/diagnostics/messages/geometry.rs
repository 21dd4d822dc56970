//! Messages about frames, points and bodies.

use std::fmt::Display;

// The form of the statements.
messages! {
    element_form(statement, form) =
        "expected `{statement}(name = {{ {form} }})`";
    element_key(key, statement, known, did_you_mean) =
        "`{statement}` takes {known}, not `{key}`{did_you_mean}";
    element_key_twice(key) =
        "`{key}` is given twice";
    element_key_missing(key, name) =
        "`{name}` has no `{key}`";
    element_keys_exclude(name, first, second) =
        "`{name}` takes either {first} or {second}, not parts of both";
    expressed_form() =
        "`expressed = B` stands behind the constraint whose components it tells: `name: left == right, expressed = B`";
    body_inertia_form() =
        "expected a matrix `diag(ixx, iyy, izz)` or `matrix([ixx, ixy, ixz], [_, iyy, iyz], [_, _, izz])`, or one of \
         `rod(m, l, x)`, `disk(m, r, x)`, `cylinder(m, r, h, x)`, `sphere(m, r)`, `cuboid(m, a, b, c)`, `planar(i)`";
    mass_negative(name, figure) =
        "the mass of `{name}` is {figure} by the nominal values, below zero";
    inertia_of_no_body(name) =
        "no body has this inertia: by the nominal values a principal moment of `{name}` is greater than the two others \
         together; for motions in a plane write `planar(i)`";
    body_axis() =
        "expected an axis of the body's frame: `x`, `y` or `z`";
    acts_on_nothing(statement) =
        "this `{statement}` acts on nothing: the model has no `body` and no `particle`";
    inertia_and_bodies() =
        "the inertia of a model with bodies is that of the bodies; leave out `inertia`";
    kinetic_and_bodies() =
        "the kinetic energy of a model with bodies is that of the bodies; leave out `kinetic_energy`";
}

// Vectors.
messages! {
    frame_form() =
        "expected `rotate(base, axis, angle)`, such as `A = rotate(N, z, theta)`, or `quaternion(base, e0, e1, e2, e3)`";
    quaternion_form(function) =
        "expected `{function}(base, e0, e1, e2, e3)` with four coordinates, the scalar part first";
    joint_form(form) =
        "expected `{form}`";
    joint_axis() =
        "expected an axis of a frame, such as `A.z`";
    joint_expressed(joint) =
        "the rows of `{joint}` are components along the axes of its own frame; leave out `expressed`";
    joint_out_of_place(joint) =
        "`{joint}` stands alone, as the value of a frame, of a point or of a constraint: it is no part of an expression";
    quaternion_inside() =
        "a frame by a quaternion needs a name of its own, which its speeds take over: declare it, and turn the next one against it";
    quaternion_component() =
        "expected the name of a coordinate: the four numbers of a quaternion are coordinates of `coordinates` themselves";
    quaternion_component_twice(name) =
        "`{name}` stands twice in this quaternion; its four numbers are four coordinates";
    quaternion_component_taken(name, frame) =
        "`{name}` is a number of the quaternion of `{frame}` already; every quaternion has coordinates of its own";
    quaternions_beside(statement) =
        "`{statement}` cannot stand beside frames by quaternions, whose speeds are angular velocities; bodies, forces on them and \
         `generalized_force` can";
    quaternion_kinematics(name) =
        "`dot({name})` cannot be given beside frames by quaternions: let the kinematics give the speeds, such as \
         `u1 = dot(angular_velocity(B), B.x)`";
    quaternion_rate_independent(name, frame, angular) =
        "the rate of `{name}` is no speed: those of the quaternion of `{frame}` are {angular}";
    constraint_of_norm(name) =
        "the constraint `{name}` holds already: the numbers of a quaternion have the norm 1 without being told";
    norm_rate_independent(name) =
        "`{name}` is the rate of a quaternion's norm, which is zero";
    frame_expected(name, what) =
        "`{name}` is {what}; expected a frame";
    frame_unknown(name, did_you_mean) =
        "there is no frame `{name}`{did_you_mean}";
    frame_as_value(name) =
        "`{name}` is a frame; its axes are `{name}.x`, `{name}.y` and `{name}.z`";
    body_as_value(name) =
        "`{name}` is a body; `velocity(P, {name})` and `angular_velocity({name})` take it";
    element_as_value(name, what) =
        "`{name}` is {what} and has no value";
    frame_out_of_place(name, what, rule) =
        "the axes of `{name}` turn with {what}, but {rule}";
    point_out_of_place(name, what, rule) =
        "the point `{name}` depends on {what}, but {rule}";
    release_of_unknown(what) =
        "expected the name of a {what} that the model declares";
    generalized_of(name, what) =
        "`{name}` is {what}; a generalised force acts on a coordinate or a speed";
    body_expected(name, what) =
        "`{name}` is {what}; expected a body or a frame";
    momentum_of_no_body(name, what) =
        "`{name}` is {what}; expected the name of a body or a particle, which has a mass";
    body_unknown(name, did_you_mean) =
        "there is no body or frame `{name}`{did_you_mean}";
    frame_without_body(name, bodies) =
        "`{name}` is the frame of {bodies}; name the body whose material point is meant";
    axis_not_fixed(base) =
        "the axis of a rotation must be fixed in its base `{base}`: its components there may depend on parameters only";
    axis_not_unit(square) =
        "the axis is not a unit vector: its square is `{square}`; write `unit(..)` around it";
    vector_plus_scalar() =
        "a vector and a scalar cannot be added";
    vector_times_vector() =
        "two vectors cannot be multiplied so; write `dot(a, b)` or `cross(a, b)`";
    division_by_vector() =
        "nothing can be divided by a vector; divide by `norm(a)` or a component such as `dot(a, N.x)`";
    scalar_expected() =
        "expected a scalar, found a vector; write a component such as `dot(a, N.x)`, or `norm(a)`";
    vector_expected(function) =
        "`{function}` takes vectors, such as `A.x` or a point";
    vector_argument(function) =
        "`{function}` takes scalars; this is a vector";
    a_vector_expected() =
        "expected a vector such as `l*A.x`, found a scalar";
    branch_of_vectors() =
        "the branches of an `if` are scalars; write one `if` for each component";
    vector_equation_of_scalar() =
        "the left side is a scalar and the right side a vector";
    scalar_equation_of_vector() =
        "the left side is a vector and the right side a scalar; only 0 stands for a vector";
    zero_vector() =
        "the unit vector of a vector that vanishes";
    expressed_of_scalar(name) =
        "`{name}` is one equation of scalars, which has no components; leave out `expressed`";
    vector_equation_empty(name) =
        "the constraint `{name}` holds identically: none of its components binds anything";
}

/// What may occur where, as the second half of a sentence.
pub(crate) const RULE_GEOMETRY: &str =
    "frames, points and bodies may depend on parameters, coordinates of `coordinates` and `t` only";
pub(crate) const RULE_LINE: &str = "what springs, dampers and armatures are made of may depend on parameters, coordinates of `coordinates` and `t` only";
pub(crate) const RULE_BODY: &str = "the masses and inertias of bodies may depend on parameters only";
