//! The four-bar from geometry: x = [crank, coupler, rocker, their independent speed], p = [a, b, c, d, m1, m2, m3, g, tau].

#[path = "../../common.rs"]
mod common;
#[path = "../../../../examples/four_bar/models.rs"]
#[allow(dead_code)]
mod models;

use common::{Kept, Peer, rate};
use models::FourBar;

impl Peer for FourBar {
    const PARAMETERS: usize = 9;

    fn read(p: &[f64]) -> (Self, Vec<f64>) {
        let &[a, b, c, d, m1, m2, m3, g, tau] = p else { panic!("nine parameters") };
        (FourBar { a, b, c, d, m1, m2, m3, g }, vec![tau])
    }
}

static KEPT: Kept<FourBar> = Kept::new();

/// # Safety
///
/// x and out have four entries, p nine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn rhs(x: *const f64, p: *const f64, out: *mut f64) {
    unsafe { rate(&KEPT, x, p, out) }
}
