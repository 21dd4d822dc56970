//! Andrews' squeezing mechanism from geometry: x = [the seven angles, the rate of the first], p = the constants of the test set.

#[path = "../../common.rs"]
mod common;
#[path = "../../../../examples/andrews/models.rs"]
#[allow(dead_code)]
mod models;

use common::{Kept, Peer, rate};
use models::Squeezer;

impl Peer for Squeezer {
    const PARAMETERS: usize = 42;

    #[rustfmt::skip]
    fn read(p: &[f64]) -> (Self, Vec<f64>) {
        let &[m1, m2, m3, m4, m5, m6, m7, i1, i2, i3, i4, i5, i6, i7, xa, ya, xb, yb, xc, yc, d, da, e, ea, zf, zt, fa, rr, ra, ss, sa, sb, sc, sd, ta, tb, u, ua, ub, c0, l0, mom] = p else { panic!("42 parameters") };
        (Squeezer { m1, m2, m3, m4, m5, m6, m7, i1, i2, i3, i4, i5, i6, i7, xa, ya, xb, yb, xc, yc, d, da, e, ea, zf, zt, fa, rr, ra, ss, sa, sb, sc, sd, ta, tb, u, ua, ub, c0, l0, mom }, Vec::new())
    }
}

static KEPT: Kept<Squeezer> = Kept::new();

/// # Safety
///
/// x and out have eight entries, p 42.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn rhs(x: *const f64, p: *const f64, out: *mut f64) {
    unsafe { rate(&KEPT, x, p, out) }
}
