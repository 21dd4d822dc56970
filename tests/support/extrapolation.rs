//! An integrator that is not the runtime's: Gragg's extrapolated midpoint rule.

/// How many substeps the columns of the extrapolation take; order 16.
const SUBSTEPS: [usize; 8] = [2, 4, 6, 8, 10, 12, 14, 16];

/// The solution of y' = f(t, y) at the given times, in equal steps of about `step`; the first time is that of the start.
pub fn integrate(mut f: impl FnMut(f64, &[f64]) -> Vec<f64>, start: &[f64], times: &[f64], step: f64) -> Vec<Vec<f64>> {
    let mut states = vec![start.to_vec()];
    for span in times.windows(2) {
        let count = ((span[1] - span[0]) / step).ceil();
        let h = (span[1] - span[0]) / count;
        let mut y = states.last().expect("the start").clone();
        for k in 0..count as usize {
            y = extrapolated(&mut f, span[0] + k as f64 * h, &y, h);
        }
        states.push(y);
    }
    states
}

/// One step: the midpoint rule in ever smaller parts, extrapolated in the square of the part (Aitken, Neville).
fn extrapolated(f: &mut impl FnMut(f64, &[f64]) -> Vec<f64>, t: f64, y: &[f64], h: f64) -> Vec<f64> {
    let mut last_row: Vec<Vec<f64>> = Vec::new();
    for (j, &n) in SUBSTEPS.iter().enumerate() {
        let mut row = vec![midpoint(f, t, y, h, n)];
        for (k, coarser) in last_row.iter().enumerate() {
            let ratio = (n as f64 / SUBSTEPS[j - k - 1] as f64).powi(2) - 1.0;
            let better = row[k].iter().zip(coarser).map(|(fine, coarse)| fine + (fine - coarse) / ratio).collect();
            row.push(better);
        }
        last_row = row;
    }
    last_row.pop().expect("one entry per column")
}

fn midpoint(f: &mut impl FnMut(f64, &[f64]) -> Vec<f64>, t: f64, y: &[f64], h: f64, n: usize) -> Vec<f64> {
    let part = h / n as f64;
    let shifted =
        |y: &[f64], h: f64, rate: &[f64]| -> Vec<f64> { y.iter().zip(rate).map(|(y, rate)| y + h * rate).collect() };
    let mut before = y.to_vec();
    let mut now = shifted(y, part, &f(t, y));
    for k in 1..n {
        let next = shifted(&before, 2.0 * part, &f(t + k as f64 * part, &now));
        before = std::mem::replace(&mut now, next);
    }
    let end = f(t + h, &now);
    (0..y.len()).map(|i| 0.5 * (now[i] + before[i] + part * end[i])).collect()
}
