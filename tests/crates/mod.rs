//! Crates that a test writes, builds with the cargo that runs it, and runs.
#![allow(dead_code, reason = "every test file uses its own part")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The repository.
const TOP: &str = env!("CARGO_MANIFEST_DIR");
/// Where cargo lets tests write.
const SCRATCH: &str = env!("CARGO_TARGET_TMPDIR");

/// A crate outside of the workspace that depends on the runtime.
pub struct Crate {
    folder: PathBuf,
}

impl Crate {
    /// Writes a crate: its features of the runtime, further lines of its manifest, and its files below `src`.
    ///
    /// The lock file is the workspace's, so that the same versions are used and nothing is asked of a registry.
    ///
    /// # Panics
    /// If a file cannot be written.
    pub fn new(name: &str, features: &str, manifest: &str, sources: &[(&str, &str)]) -> Self {
        let folder = Path::new(SCRATCH).join(name);
        let runtime = Path::new(TOP).join("runtime");
        let head = format!(
            "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\npublish = false\n\n[workspace]\n\n\
             [dependencies]\nholonomy = {{ path = {runtime:?}, {features} }}\n\n{manifest}"
        );
        fs::create_dir_all(folder.join("src")).expect("the folder is made");
        fs::copy(Path::new(TOP).join("Cargo.lock"), folder.join("Cargo.lock")).expect("the lock file is copied");
        write(&folder.join("Cargo.toml"), &head);
        for (file, text) in sources {
            write(&folder.join("src").join(file), text);
        }
        Self { folder }
    }

    /// Runs a command of cargo on the crate and gives what it wrote to standard output.
    ///
    /// All crates of the tests share one target folder, so that what they depend on is built once.
    ///
    /// # Panics
    /// If the command fails, with what it said.
    pub fn cargo(&self, command: &str, arguments: &[&str]) -> String {
        let output = self.attempt(command, arguments);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "cargo {command} {arguments:?} in {}:\n{said}", self.folder.display());
        String::from_utf8(output.stdout).expect("text")
    }

    /// The same where the command may fail.
    ///
    /// # Panics
    /// If there is no cargo.
    pub fn attempt(&self, command: &str, arguments: &[&str]) -> Output {
        Command::new(env!("CARGO"))
            .arg(command)
            .args(["--quiet", "--offline", "--color", "never", "--target-dir"])
            .arg(Path::new(SCRATCH).join("crates"))
            .args(arguments)
            .current_dir(&self.folder)
            // what the workspace is built with is not the crate's business
            .env_remove("RUSTFLAGS")
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .output()
            .expect("cargo runs")
    }
}

/// Writes a file if it says something new: cargo builds again what is newer than its result.
fn write(path: &Path, text: &str) {
    if fs::read_to_string(path).ok().as_deref() != Some(text) {
        fs::write(path, text).expect("the file is written");
    }
}
