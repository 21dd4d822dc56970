#![allow(missing_docs)]
mod models {
    include!("models/pendulum.rs");
}
use holonomy::prelude::*;
use models::*;
#[test]
fn t() {
    let p = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let s = PendulumState { x: 0.0, y: -0.5, dot_x: 0.0 };
    println!("{:?} {}", p.derivative(0.0, &s, &[]), p.energy(0.0, &s));
}
