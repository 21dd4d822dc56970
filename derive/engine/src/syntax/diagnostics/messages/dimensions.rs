//! Messages about units and dimensions.

use std::fmt::Display;

messages! {
    unit_unknown(name, did_you_mean) =
        "there is no unit `{name}` (units are products and quotients of m, kg, s, A, K, mol, cd, N, J, W, Pa, Hz, rad, V, Ohm, C, F, H, \
         T and Wb, with prefixes){did_you_mean}";
    unit_refused(name, instead) =
        "`{name}` is no power of ten of the other units, and numbers are not converted; {instead}";
    /// The sum and the like of what does not fit.
    dimensions_differ(left, relation, right, hint) =
        "{left} {relation} {right}{hint}";
    dimension_expected(what, expected, found, hint) =
        "{what} must be {expected}, and this is {found}{hint}";
    dimension_argument(function, found, hint) =
        "`{function}` of {found}: its argument must be a pure number{hint}";
    dimension_of_base(found, hint) =
        "{found} to a power that is no constant: the base must be a pure number{hint}";
    dimensions_apart(what, factor, hint) =
        "{what} differ by {factor}{hint}";
    hint_scale() =
        "; numbers are not converted, so give both in one unit";
    hint_origin(name, origin) =
        "; the unit of `{name}` follows from {origin}";
}
