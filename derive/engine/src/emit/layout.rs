//! Matrices in text.

/// The columns that a text takes: a mark over a letter takes none.
fn columns(text: &str) -> usize {
    text.chars().filter(|c| !('\u{300}'..'\u{370}').contains(c)).count()
}

/// How wide a matrix would be.
pub fn width(rows: &[Vec<String>]) -> usize {
    let count = rows.first().map_or(0, Vec::len);
    let widest = |j: usize| rows.iter().map(|row| columns(&row[j])).max().unwrap_or(0);
    (0..count).map(widest).sum::<usize>() + 2 * count
}

/// The lines of a matrix in brackets behind what stands before its first row.
pub fn laid_out(before: &str, rows: &[Vec<String>]) -> Vec<String> {
    let count = rows.first().map_or(0, Vec::len);
    if count == 0 {
        return vec![format!("{before}[]")];
    }
    let widths: Vec<usize> =
        (0..count).map(|j| rows.iter().map(|row| columns(&row[j])).max().unwrap_or(0)).collect();
    let last = rows.len() - 1;
    let line = |(i, row): (usize, &Vec<String>)| {
        let (open, close) = match i {
            _ if last == 0 => ('[', ']'),
            0 => ('⎡', '⎤'),
            i if i == last => ('⎣', '⎦'),
            _ => ('⎢', '⎥'),
        };
        let indent = if i == 0 { before.to_owned() } else { " ".repeat(columns(before)) };
        let cells: Vec<String> =
            row.iter().zip(&widths).map(|(cell, width)| format!("{cell}{}", " ".repeat(width - columns(cell)))).collect();
        format!("{indent}{open}{}{close}", cells.join("  "))
    };
    rows.iter().enumerate().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_stands_in_columns() {
        let rows: Vec<Vec<String>> =
            [["J", "0"], ["−x\u{307}", "m·r²"]].iter().map(|row| row.map(str::to_owned).to_vec()).collect();
        assert_eq!(laid_out("M = ", &rows), ["M = ⎡J   0   ⎤", "    ⎣−x\u{307}  m·r²⎦"]);
        assert_eq!((width(&rows), width(&[])), (10, 0));
        assert_eq!(laid_out("D = ", &[]), ["D = []"]);
        assert_eq!(laid_out("D = ", &rows[..1]), ["D = [J  0]"]);
    }
}
