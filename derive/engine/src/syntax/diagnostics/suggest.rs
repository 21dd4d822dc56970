//! "did you mean": the nearest of the names that would have been right.

/// The candidate that `name` most probably stands for: the nearest by edit distance, if it is
/// within a third of the name's length and has a character in common, or the same but for upper and
/// lower case. Of equally near candidates the first wins.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let allowed = (name.chars().count() + 1).max(3) / 3;
    let lower = name.to_lowercase();
    candidates
        .into_iter()
        .filter(|candidate| *candidate != name)
        .map(
            |candidate| {
                if candidate.to_lowercase() == lower { (0, candidate) } else { (distance(name, candidate), candidate) }
            },
        )
        .filter(|(distance, candidate)| {
            let length = name.chars().count().max(candidate.chars().count());
            *distance <= allowed && *distance < length
        })
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// The suggestion as the end of a message; empty without one.
pub(crate) fn did_you_mean(candidate: Option<&str>) -> String {
    candidate.map_or_else(String::new, |name| format!("; did you mean `{name}`?"))
}

/// Edit distance with insertions, deletions, substitutions and swaps of neighbours, one each
/// (optimal string alignment).
pub(crate) fn distance(a: &str, b: &str) -> usize {
    let a: Vec<char> = a.chars().collect();
    let b: Vec<char> = b.chars().collect();
    // Rows i-2, i-1 and i of the table.
    let mut before = vec![0; b.len() + 1];
    let mut above: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i; b.len() + 1];
        for j in 1..=b.len() {
            let change = above[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            row[j] = change.min(above[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                row[j] = row[j].min(before[j - 2] + 1);
            }
        }
        before = std::mem::replace(&mut above, row);
    }
    above[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_edits() {
        assert_eq!(distance("theta", "theta"), 0);
        assert_eq!(distance("thtea", "theta"), 1);
        assert_eq!(distance("", "abc"), 3);
        assert_eq!(distance("kinematics", "kinetics"), 2);
    }

    #[test]
    fn suggests_only_what_is_near() {
        assert_eq!(nearest("tetha", ["phi", "theta", "psi"]), Some("theta"));
        assert_eq!(nearest("Theta", ["phi", "theta"]), Some("theta"));
        assert_eq!(nearest("q", ["alpha", "beta"]), None);
        assert_eq!(nearest("p", ["q", "r"]), None);
        assert_eq!(nearest("v", ["q", "v1"]), Some("v1"));
    }
}
