//! Joints in short: their names and forms.

use proc_macro2::{Delimiter, TokenTree};

/// Constraints that close loops: name, possible numbers of arguments, form.
pub(crate) const JOINTS: [(&str, &[usize], &str); 6] = [
    ("revolute", &[4], "revolute(P, Q, A.z, B.z)"),
    ("spherical", &[2], "spherical(P, Q)"),
    ("universal", &[4], "universal(P, Q, A.x, B.y)"),
    ("prismatic", &[4], "prismatic(P, Q, A.x, B)"),
    ("weld", &[4], "weld(P, Q, A, B)"),
    ("rolling", &[2, 3], "rolling(P, wheel)` or `rolling(P, wheel, ground)"),
];

/// Frames by rotations: name, number of arguments, form.
pub(crate) const ROTATIONS: [(&str, usize, &str); 6] = [
    ("rotate", 3, "rotate(base, axis, angle)"),
    ("revolute", 3, "revolute(base, axis, angle)"),
    ("universal", 5, "universal(base, axis, angle, axis, angle)"),
    ("weld", 1, "weld(base)"),
    ("quaternion", 5, "quaternion(base, e0, e1, e2, e3)"),
    ("spherical", 5, "spherical(base, e0, e1, e2, e3)"),
];

/// Whether a function is a frame by a quaternion.
pub(crate) fn is_quaternion(function: &str) -> bool {
    matches!(function, "quaternion" | "spherical")
}

/// Whether a function is a joint or a rotation, which stand alone.
pub(crate) fn names_a_joint(function: &str) -> bool {
    JOINTS.iter().any(|(joint, ..)| *joint == function) || ROTATIONS.iter().any(|(rotation, ..)| *rotation == function)
}

/// Whether tokens are the call of a joint, and nothing else.
pub(super) fn is_joint(tokens: &[TokenTree]) -> bool {
    match tokens {
        [TokenTree::Ident(name), TokenTree::Group(group)] if group.delimiter() == Delimiter::Parenthesis => {
            JOINTS.iter().any(|(joint, ..)| name == joint)
        }
        _ => false,
    }
}
