//! Whether a run passed a loss of rank between two points: the rows of C then come out turned over.
//!
//! No figure that is only positive shows it: rows that vanish at ż = 0, say, are as long on the other side. As long as C has full
//! rank, the determinant of its rows along the directions that they had a moment ago keeps its sign.

use alloc::collections::VecDeque;
use alloc::vec::Vec;

use crate::tangent::{Span, Tangent};

/// Two spans whose directions have this product of cosines can be compared.
const COMPARABLE: f64 = 0.3;
/// More points than any method evaluates in a step.
const REMEMBERED: usize = 24;
/// Times that differ by less than this part of a step are the same.
const SAME_TIME: f64 = 1e-9;

struct Mark {
    time: f64,
    span: Span,
    turned: bool,
}

/// The rows of C along a run.
#[derive(Default)]
pub(super) struct Orientation {
    accepted: Option<Mark>,
    recent: VecDeque<Mark>,
}

impl Orientation {
    /// Remembers an evaluation. Points within a step are compared with the last accepted one while they are near, and with the
    /// one before otherwise.
    pub(super) fn note(&mut self, time: f64, tangent: &Tangent) {
        let against = |mark: &Mark| {
            let (sign, cosine) = tangent.compare(&mark.span);
            (mark.turned != (sign < 0.0), cosine)
        };
        let turned = match (self.accepted.as_ref().map(against), self.recent.back().map(against)) {
            (Some((turned, cosine)), _) if cosine > COMPARABLE => turned,
            (_, Some((turned, _))) | (Some((turned, _)), None) => turned,
            (None, None) => false,
        };
        let mark = Mark { time, span: tangent.span(), turned };
        if self.accepted.is_none() {
            self.accepted = Some(mark);
            return;
        }
        if self.recent.len() == REMEMBERED {
            self.recent.pop_front();
        }
        self.recent.push_back(mark);
    }

    /// Judges the point at this time, which is to be accepted: the rows that came out turned over, if any did.
    pub(super) fn accept(&mut self, time: f64, tangent: &Tangent) -> Option<Vec<usize>> {
        let step = self.accepted.as_ref().map_or(0.0, |mark| (time - mark.time).abs());
        let same = |mark: &Mark| (mark.time - time).abs() <= SAME_TIME * step;
        let at = self.recent.iter().rposition(same)?;
        let mark = self.recent.remove(at)?;
        self.recent.clear();
        if let Some(before) = &self.accepted
            && before.turned != mark.turned
        {
            let rows = tangent.turned(&before.span);
            return Some(if rows.is_empty() { before.span.rows.clone() } else { rows });
        }
        self.accepted = Some(mark);
        None
    }
}
