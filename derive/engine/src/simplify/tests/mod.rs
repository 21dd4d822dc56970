mod disk;
mod random;
mod rules;
mod support;
