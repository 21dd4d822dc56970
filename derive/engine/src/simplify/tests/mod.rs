mod disk;
mod random;
mod support;
