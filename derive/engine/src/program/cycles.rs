//! How long a program takes, in estimate: the longer of its work at the processor's rate and its longest chain of operations.

use super::operation::{Code, Operation};

/// Operations in a cycle.
const RATE: usize = 2;
/// Cycles until a sum is there,
const ADD: u32 = 4;
/// ... a product,
const MULTIPLY: u32 = 4;
/// ... a quotient or a root,
const DIVIDE: u32 = 13;
/// ... a sine and cosine, or another function.
const FUNCTION: u32 = 50;
/// Cycles until the next quotient or root can begin,
const BUSY: usize = 4;
/// ... and of a sine and cosine among others.
const CALL: usize = 20;

impl Code {
    /// Cycles of one run, in estimate.
    pub fn cycles(&self) -> usize {
        let count = self.count();
        let simple = count.additions + count.multiplications + count.selections;
        let work = work(simple, count.divisions + count.roots, count.sincos + count.others);
        let mut ready: Vec<u32> = Vec::with_capacity(self.operations.len());
        for operation in &self.operations {
            let operands = operation.operands().into_iter().map(|r| ready[r as usize]).max().unwrap_or(0);
            let own = match operation {
                Operation::Read(_) | Operation::Number(_) | Operation::Negate(_) => 0,
                Operation::Add(..) | Operation::Subtract(..) => ADD,
                Operation::Multiply(..) => MULTIPLY,
                Operation::Divide(..) | Operation::Root(_) => DIVIDE,
                Operation::Sine(_) | Operation::Cosine(_) | Operation::Call(..) => FUNCTION,
            };
            ready.push(operands + own);
        }
        let path = self.outputs.iter().map(|r| ready[*r as usize]).max().unwrap_or(0);
        work.max(path as usize)
    }
}

/// Cycles of an elimination of `pivots` speeds by so many simple operations, of which `deepest` hang on one another: a quotient, two
/// products and a difference each on the way inwards, a product and a difference on the way back.
pub fn eliminated(simple: usize, pivots: usize, deepest: usize) -> usize {
    let step = (DIVIDE + 2 * MULTIPLY + ADD) + (MULTIPLY + ADD);
    work(simple, pivots, pivots).max(deepest * step as usize + FUNCTION as usize)
}

/// Cycles that the operations take if none waits for another.
fn work(simple: usize, divisions: usize, functions: usize) -> usize {
    simple / RATE + divisions * BUSY + functions * CALL
}
