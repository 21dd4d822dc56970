//! Why a run does not pass a loss of rank.

use core::fmt;

/// What is in the way of a run where constraints lose their rank; in [`Error::Impassable`](super::Error::Impassable).
///
/// ```
/// use holonomy::Obstacle;
///
/// assert!(Obstacle::Jump.to_string().contains("velocity would jump"));
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Obstacle {
    /// The run starts there, where the motions that meet cannot be told apart.
    Start,
    /// No configuration beyond was found that satisfies the constraints: a dead end.
    Closed,
    /// The rank stays lost beyond.
    Lost,
    /// No motion was found that goes through and is smooth: the velocity would jump, or it vanishes.
    Jump,
}

impl fmt::Display for Obstacle {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Obstacle::Start => {
                "it starts there, where motions meet that a state does not tell apart; start beside it, on the branch that is meant"
            }
            Obstacle::Closed => {
                "beyond it no configuration was found that satisfies the constraints: a dead end; stop the run before it by an event"
            }
            Obstacle::Lost => {
                "beyond it they depend on each other as well; leave one out, or mark it `redundant` if it always depends on the others"
            }
            Obstacle::Jump => {
                "no smooth motion was found that goes through: the velocity would jump, or it vanishes there; stop the run before it by \
                 an event, or tighten the tolerance"
            }
        })
    }
}
