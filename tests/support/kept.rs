//! Texts that were read by a person and are kept beside the tests: `HOLONOMY_BLESS=1` writes them anew.

use std::fs;
use std::path::Path;

/// How a text differs from the one that is kept, by its first line that does; `None` where it does not.
pub fn changed(path: &Path, text: &str) -> Option<String> {
    if std::env::var_os("HOLONOMY_BLESS").is_some() {
        fs::create_dir_all(path.parent().expect("a folder")).expect("the folder is made");
        fs::write(path, text).expect("the text is written");
    }
    let kept = fs::read_to_string(path).unwrap_or_default();
    if text == kept {
        return None;
    }
    let mut lines = text.lines().zip(kept.lines().chain(std::iter::repeat("nothing")));
    Some(match lines.find(|(now, before)| now != before) {
        Some((now, before)) => format!("{}: `{}` where there was `{}`", path.display(), now.trim(), before.trim()),
        None => format!("{}: lines were left out", path.display()),
    })
}
