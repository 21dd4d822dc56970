//! What may occur where.

use super::names::Mentions;
use crate::syntax::messages;

/// What an expression may mention, by where it stands, and the rule as a clause of a message.
#[derive(Clone, Copy)]
pub(super) struct Context {
    pub allowed: Mentions,
    pub rule: &'static str,
}

const PLACE: Mentions = Mentions::PARAMETERS.and(Mentions::TIME).and(Mentions::COORDINATES);

/// All that is known of a state.
const STATE: Mentions = PLACE
    .and(Mentions::FURTHER)
    .and(Mentions::SPEEDS)
    .and(Mentions::RATES)
    .and(Mentions::FURTHER_RATES)
    .and(Mentions::QUASI)
    .and(Mentions::FREE)
    .and(Mentions::COMBINATIONS)
    .and(Mentions::INPUTS)
    .and(Mentions::ACCELERATIONS)
    .and(Mentions::FURTHER_ACCELERATIONS)
    .and(Mentions::REACTIONS);

impl Context {
    pub const SPEEDS: Context = Context { allowed: PLACE.and(Mentions::RATES), rule: messages::RULE_SPEEDS };
    pub const RATES: Context = Context { allowed: PLACE.and(Mentions::SPEEDS), rule: messages::RULE_RATES };
    pub const INERTIA: Context = Context { allowed: PLACE, rule: messages::RULE_INERTIA };
    pub const KINETIC: Context =
        Context { allowed: PLACE.and(Mentions::SPEEDS).and(Mentions::RATES), rule: messages::RULE_KINETIC };
    pub const POTENTIAL: Context = Context { allowed: PLACE, rule: messages::RULE_POTENTIAL };
    pub const FORCES: Context = Context {
        allowed: PLACE.and(Mentions::SPEEDS).and(Mentions::RATES).and(Mentions::INPUTS),
        rule: messages::RULE_FORCES,
    };
    pub const CONSTRAINT: Context = Context {
        allowed: PLACE.and(Mentions::SPEEDS).and(Mentions::RATES).and(Mentions::ACCELERATIONS),
        rule: messages::RULE_CONSTRAINT,
    };
    pub const CONFIGURATION: Context =
        Context { allowed: PLACE.and(Mentions::FURTHER), rule: messages::RULE_CONFIGURATION };
    pub const QUASI_SPEEDS: Context = Context {
        allowed: PLACE.and(Mentions::FURTHER).and(Mentions::RATES).and(Mentions::FURTHER_RATES),
        rule: messages::RULE_QUASI_SPEEDS,
    };
    pub const QUASI_RATES: Context =
        Context { allowed: PLACE.and(Mentions::FURTHER).and(Mentions::QUASI), rule: messages::RULE_QUASI_RATES };
    pub const VELOCITIES: Context = Context {
        allowed: PLACE.and(Mentions::SPEEDS).and(Mentions::RATES).and(Mentions::FREE),
        rule: messages::RULE_VELOCITIES,
    };
    pub const VELOCITIES_OF_RATES: Context = Context {
        allowed: PLACE
            .and(Mentions::FURTHER)
            .and(Mentions::RATES)
            .and(Mentions::FURTHER_RATES)
            .and(Mentions::QUASI)
            .and(Mentions::FREE),
        rule: messages::RULE_VELOCITIES,
    };
    pub const COMBINATION: Context =
        Context { allowed: PLACE.and(Mentions::SPEEDS).and(Mentions::RATES), rule: messages::RULE_COMBINATION };
    pub const COMBINATION_OF_RATES: Context = Context {
        allowed: PLACE
            .and(Mentions::FURTHER)
            .and(Mentions::SPEEDS)
            .and(Mentions::RATES)
            .and(Mentions::FURTHER_RATES)
            .and(Mentions::QUASI),
        rule: messages::RULE_COMBINATION,
    };
    pub const COMPLEMENT: Context = Context { allowed: PLACE, rule: messages::RULE_COMPLEMENT };
    pub const COMPLEMENT_OF_RATES: Context =
        Context { allowed: PLACE.and(Mentions::FURTHER), rule: messages::RULE_COMPLEMENT };
    pub const OUTPUT: Context = Context { allowed: STATE.and(Mentions::OUTPUTS), rule: "" };
    pub const GEOMETRY: Context = Context { allowed: PLACE, rule: messages::RULE_GEOMETRY };
    pub const LINE: Context = Context { allowed: PLACE, rule: messages::RULE_LINE };
    pub const BODY: Context = Context { allowed: Mentions::PARAMETERS, rule: messages::RULE_BODY };
    pub const NUMBER: Context = Context { allowed: Mentions::NONE, rule: messages::RULE_NUMBER };
    /// Where a define is used decides, not where it stands.
    pub const DEFINE: Context = Context { allowed: STATE, rule: "" };
}
