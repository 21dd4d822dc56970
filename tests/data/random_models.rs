// Generated from tests/random: random models, and macros that name them all.

use holonomy::ConstrainedSystem;

pub fn wave(s: f64) -> f64 {
    s.sin() / 2.0
}
pub fn wave_1(s: f64) -> f64 {
    s.cos() / 2.0
}
pub fn wave_2(s: f64) -> f64 {
    -s.sin() / 2.0
}
pub fn wave_3(s: f64) -> f64 {
    -s.cos() / 2.0
}
pub fn bump(s: f64) -> f64 {
    1.0 / (1.0 + s * s)
}
pub fn bump_1(s: f64) -> f64 {
    -2.0 * s / (1.0 + s * s).powi(2)
}
pub fn bump_2(s: f64) -> f64 {
    (6.0 * s * s - 2.0) / (1.0 + s * s).powi(3)
}
pub fn bump_3(s: f64) -> f64 {
    24.0 * s * (1.0 - s * s) / (1.0 + s * s).powi(4)
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[inertia(diag(1.26))]
#[forces(
    1.93*powi(dot(x1), 2) + 1.50*dot(x1)/(1 + powi(x1, 2)) + 0.56*powi(dot(x1), 2),
)]
pub struct Random0 {
    #[nominal(0.52)]
    pub p1: f64,
    #[nominal(1.42)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2)]
#[inertia(diag((1.01 + 0.30*sin(p1*x1 + 0.80)), (1.25 + 0.18*powi(cos(0.57*x1 - 0.68*x2), 3))))]
#[forces(
    p1*dot(x1)*dot(x1)*cos(0.64*x2 - 0.79*x2) + 0.60*exp(-powi(x2, 2)/2) + dot(x1)*dot(x1)/(1.24 - 0.28*wave(0.83*x2)) + 0.42*dot(x1)/(1 + powi(x1, 2)),
    1.96*wave(0.81*x2) - 0.65*dot(x1),
)]
#[potential_energy(sin(0.93*x1))]
#[constraint(row1: dot(x2) + 0.20*cos(1.10*x2)*dot(x1) - 0.37*x1/(1 + powi(x1, 2)) == 0)]
pub struct Random1 {
    #[nominal(1.18)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    dot(x1) = 1.26*v1 + 0.23*cos(0.88*x1 - 0.52*t),
)]
#[define(l11 = (1.27 - 0.32*sin(p2*x1 + 0.25)))]
#[kinetic_energy(powi(l11*v1, 2)/2 - 0.49*sin(1.13*x1))]
#[forces(
    1.34*tan(0.49*sin(t))/2 - p2*v1*v1*atan2(t, 2 + cos(x1))/2 - 0.56*powi(v1, 2) - p2*v1*v1*sin(p2*t + 0.71),
)]
#[potential_energy(tan(0.69*sin(x1))/2)]
#[constraint(row1: 1.64*x1 + 0.30*sin(0.70*t) + 0.28 == 0)]
#[output(place = sin(0.58*x1 + 0.84*t), power = 1.87*v1 + p2*1.79 + 0.97*v1 + 1.12*v1, push = x1/(1 + powi(x1, 2))*dot(v1) + v1*ddot(x1), pull = (1.25 + 0.16*powi(cos(1.04*x1 - 0.89*x1), 3))*reaction(row1) - push, share = pull/(1.21 + powi(reaction(row1), 2)))]
pub struct Random2 {
    #[nominal(0.86)]
    pub p1: f64,
    #[nominal(1.37)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    dot(x1) = v1 - 0.32*cos(0.74*t),
)]
#[inertia(matrix(
    [((1.35 - 0.25*exp(-powi(t, 2)/2)))*((1.35 - 0.25*exp(-powi(t, 2)/2)))],
))]
#[forces(
    p2*0.97 + 1.75*v1 + 1.76*powi(v1, 2) + 0.57*v1/(1 + powi(x1, 2)),
)]
#[constraint(row1: 1.15*v1 + 0.40*(if x1 > -0.03 { sin(p2*x1 + 0.59) } else { powi(cos(0.40*x1 - 0.81*x1 + 0.90), 3) }) == 0)]
#[output(place = cos(0.88*x1 - 0.74*x1), power = 1.56*cos(1.09*x1 + 0.69*x1 + 0.61) - 1.66*v1/(1 + powi(x1, 2)) - 1.06*v1/(1 + powi(x1, 2)) - p2*exp(0.20*x1), push = exp(-powi(t, 2)/2)*dot(v1) + v1*ddot(x1), pull = (1.36 + 0.25*exp(-powi(t, 2)/2))*reaction(row1) - push, share = pull/(1.69 + powi(reaction(row1), 2)))]
pub struct Random3 {
    #[nominal(0.77)]
    pub p1: f64,
    #[nominal(1.16)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    v1 = dot(x1),
)]
#[inertia(diag(1.23))]
#[forces(
    1.58*v1,
)]
#[constraint(height: 1.72*x1 + 0.20*sin(x1) + 0.30*sin(0.95*t) + 0.28 == 0)]
#[constraint(height_rate: 1.72*dot(x1) + 0.20*cos(x1)*dot(x1) + 0.30*0.95*cos(0.95*t) == 0)]
#[output(place = cos(1.14*t), power = 0.85*sin(p1*x1 - 0.26) + p1*v1*v1*powi(cos(0.98*t), 3), push = cos(0.93*t + 0.91)*dot(v1) + v1*ddot(x1))]
pub struct Random4 {
    #[nominal(1.47)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[inputs(tau)]
#[define(l11 = (1.15 - 0.20*1/sqrt(1.50 + powi(t, 2))), l21 = 0.17*sin(0.72*t), l22 = 1.38)]
#[inertia(matrix(
    [l11*l11, l11*l21],
    [_, l21*l21 + l22*l22],
))]
#[forces(
    1.00*bump(0.94*x1 + 0.21*x1) + dot(x1)*sqrt(2 + powi(dot(x1), 2)),
    p1*exp(0.20*x1) + 0.55*dot(x2)/(1 + powi(x1, 2)) + p1*exp(0.20*t),
)]
#[constraint(height: 1.51*x1 + 0.24*sin(x1) + 0.30*sin(1.03*t) + 0.54 == 0)]
#[constraint(first: (1.50 - 0.24*sin(p1*t + 0.48))*dot(x2) + 0.32*wave(0.53*t - 0.66*x2 - 0.90)*dot(x1) - 0.47*(if x2 < -0.25 { t/(1 + powi(t, 2)) } else { cos(1.04*x2) }) == 0)]
#[constraint(second: 1.51*dot(x1) + 0.24*cos(x1)*dot(x1) + 0.30*1.03*cos(1.03*t) - 0.50*tan(0.34*sin(x1))/2*((1.50 - 0.24*sin(p1*t + 0.48))*dot(x2) + 0.32*wave(0.53*t - 0.66*x2 - 0.90)*dot(x1) - 0.47*(if x2 < -0.25 { t/(1 + powi(t, 2)) } else { cos(1.04*x2) })) == 0)]
#[output(place = cos(0.88*x2 + 0.67*x1), power = p1*dot(x1)*dot(x1)*sin(0.64*x2 + 0.55), push = 0.52*sin(x1)/(1.50 + cos(x1))*ddot(x1) + dot(x1)*ddot(x1))]
pub struct Random5 {
    #[nominal(1.25)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = (1.04 - 0.16*bump(1.09*x1 - 0.25*x1 + 1.29))*dot(x1) - 0.22*cos(0.83*x2)*dot(x2),
    v2 = (1.18 - 0.15*ln(1.60 + 0.56*cos(x2)))*dot(x2) + 0.26*tan(0.47*sin(x2))/2*dot(x1),
)]
#[inertia(matrix(
    [((1.38 + 0.29*sin(1.12*x2 + 0.67*x2 + 1.11)*cos(0.64*x1)))*((1.38 + 0.29*sin(1.12*x2 + 0.67*x2 + 1.11)*cos(0.64*x1))), ((1.38 + 0.29*sin(1.12*x2 + 0.67*x2 + 1.11)*cos(0.64*x1)))*(0.30*(if x2 >= 0.42 { 0.82*sin(x1)/(1.50 + cos(x2)) } else { 1/sqrt(1.50 + powi(x2, 2)) }))],
    [_, (0.30*(if x2 >= 0.42 { 0.82*sin(x1)/(1.50 + cos(x2)) } else { 1/sqrt(1.50 + powi(x2, 2)) }))*(0.30*(if x2 >= 0.42 { 0.82*sin(x1)/(1.50 + cos(x2)) } else { 1/sqrt(1.50 + powi(x2, 2)) })) + (1.18)*(1.18)],
))]
#[forces(
    p1*0.91 + v2*v2/1.00 + p1*v2*v2*tan(0.46*sin(x1))/2,
    v2*v2/1.04 - v2*sqrt(2 + powi(v1, 2)) - p1*v1*v1*sin(0.95*x1 - 0.36) - p2*x1,
)]
#[potential_energy(wave(0.69*x2 + 1.35))]
#[configuration(x1 = 0.56*sin(0.78*x2 - 0.79*x2)*cos(1.19*x2 + 0.53))]
#[constraint(held_x1: x1 - (0.56*sin(0.78*x2 - 0.79*x2)*cos(1.19*x2 + 0.53)) == 0)]
#[output(place = atan2(x1, 2 + cos(x2))/2, power = 1.38*powi(v2, 2) - v2*sqrt(2 + powi(v2, 2)) - p1*v1*v2*0.38*sin(x2)/(1.50 + cos(x2)) - 1.49*v2/(1 + powi(x2, 2)), push = sin(0.63*x1)*cos(0.41*x1 - 0.52*x2)*dot(v2) + v2*ddot(x2), pull = (1.29 - 0.29*atan2(x1, 2 + cos(x1))/2)*reaction(held_x1) - push, share = pull/(1.26 + powi(reaction(held_x1), 2)))]
pub struct Random6 {
    #[nominal(1.31)]
    pub p1: f64,
    #[nominal(0.90)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[inertia(matrix(
    [(1.37)*(1.37), (1.37)*(0.34*bump(0.78*x2 - 0.46*x1))],
    [_, (0.34*bump(0.78*x2 - 0.46*x1))*(0.34*bump(0.78*x2 - 0.46*x1)) + (1.16)*(1.16)],
))]
#[forces(
    0,
    1.40*powi(dot(x2), 2) - 0.74*dot(x1)/(1 + powi(x1, 2)) - dot(x2)*dot(x1)/1.39,
)]
#[potential_energy(powi(cos(0.52*x2 + 0.63*x1), 3))]
#[configuration(of(q1, q2), x1 = 1.25*q1, x2 = 1.25*q2)]
pub struct Random7 {
    #[nominal(1.36)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + wave(0.84*x1)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - wave(0.84*x1)*(v1),
)]
#[define(l11 = (1.24 - 0.31*sin(0.96*x1 + 0.40)), l21 = 0.21*sin(0.80*x1), l22 = (1.39 - 0.30*sin(0.51*t + 0.34)*cos(0.86*x1)))]
#[inertia(matrix(
    [l11*l11, l11*l21],
    [_, l21*l21 + l22*l22],
))]
#[forces(
    0,
    1.52*v2/(1 + powi(x1, 2)),
)]
#[configuration(x1 = 0.66*sin(1.05*t + 0.78*x2))]
#[output(place = bump(0.50*t + 0.43*t), power = 1.63*v1/(1 + powi(t, 2)) - p1*v1*v1*sin(0.84*t)*cos(1.16*x1 + 0.67*x1) - v1*v2/1.05, push = bump(0.76*x1 - 0.99)*dot(v2) + v2*ddot(x2))]
pub struct Random8 {
    #[nominal(0.54)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + exp(-powi(x2, 2)/2)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - exp(-powi(x2, 2)/2)*(v1),
)]
#[inertia(diag((1.18 + 0.34*ln(1.60 + 0.78*cos(x1))), 1.23))]
#[forces(
    0.97*(if x2 < -0.49 { atan2(x2, 2 + cos(t))/2 } else { 1/sqrt(1.50 + powi(t, 2)) }) - p3*t - v2*v2/1.08 - 1.36*powi(v2, 2),
    0.46*sin(1.17*t - 0.28*x1 - 1.24)*cos(0.95*t - 0.50*t),
)]
#[potential_energy(1/sqrt(1.50 + powi(x2, 2)))]
#[constraint(row1: v2 + 0*v1 == 0)]
#[complement(
    w1 = [(1.10 - 0.34*atan2(t, 2 + cos(t))/2), -(1.10 - 0.34*atan2(t, 2 + cos(t))/2)*(0)],
)]
pub struct Random9 {
    #[nominal(0.53)]
    pub p1: f64,
    #[nominal(1.37)]
    pub p2: f64,
    #[nominal(1.36)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + (if x2 <= -0.22 { cos(0.84*x2 + 1.31) } else { tan(0.88*sin(x1))/2 })*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - (if x2 <= -0.22 { cos(0.84*x2 + 1.31) } else { tan(0.88*sin(x1))/2 })*(v1),
)]
#[define(l11 = (1.17 - 0.21*x2/(1 + powi(x2, 2))), l21 = 0.23*cos(0.40*x1 + 0.57*x2), l22 = (1.39 - 0.13*x2/(1 + powi(x2, 2))))]
#[inertia(matrix(
    [l11*l11, l11*l21],
    [_, l21*l21 + l22*l22],
))]
#[forces(
    v1*v2/(1.06 - 0.19*sin(p1*x1 + 0.74)) - v1*v1/(1.16 + 0.34*1/sqrt(1.50 + powi(x1, 2))),
    1.86*v1/(1 + powi(x1, 2)) + v1*v1/1.40 + tau*1.37,
)]
#[potential_energy(sin(p2*x1 + 0.20))]
#[constraint(row1: 1.85*x1 + 0.24*sin(x1) + 0.18*x2*x2 - 0.68 == 0)]
#[output(place = cos(0.76*x2 + 0.57), power = p2*v2*v1*sin(0.47*x1 - 0.46*x1) - p2*exp(0.20*x2), push = x1/(1 + powi(x1, 2))*dot(v1) + v1*ddot(x1), pull = 1.12*reaction(row1) - push, share = pull/(1.60 + powi(reaction(row1), 2)))]
pub struct Random10 {
    #[nominal(1.09)]
    pub p1: f64,
    #[nominal(0.59)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[inertia(diag((1.14 - 0.26*sin(0.48*x2 + 0.29*x1)*cos(1.17*x1 + 0.59*x1)), (1.26 - 0.27*atan2(x1, 2 + cos(x1))/2)))]
#[forces(
    dot(x2)*sqrt(2 + powi(dot(x1), 2)) + p2*exp(0.20*x2) + 1.99*powi(dot(x2), 2),
    p1*exp(0.20*x2) - dot(x2)*dot(x2)/1.10,
)]
#[potential_energy(cos(0.85*x1 + 0.51))]
#[constraint(row1: 1.32*x1 + 0.25*sin(x1) - 0.29 == 0)]
#[constraint(row2: 1.78*x2 + 0.31*x1*x1 - 0.19 == 0)]
#[output(place = (if x1 > 0.02 { sin(p1*x2 - 0.11) } else { sin(0.58*x1 + 0.46) }), power = p1*exp(0.20*x2) - p1*x2, push = bump(1.16*x1)*ddot(x1) + dot(x1)*ddot(x1), pull = 1.23*reaction(row1) - push, share = pull/(1.22 + powi(reaction(row1), 2)))]
pub struct Random11 {
    #[nominal(1.33)]
    pub p1: f64,
    #[nominal(1.22)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[kinetic_energy(1.21*powi(dot(x1), 2)/2 + 0.62*sin(0.62*x1))]
#[forces(
    dot(x1)*sqrt(2 + powi(dot(x1), 2)) - dot(x1)*dot(x1)/(1.38 + 0.28*sin(1.12*x1)),
)]
#[constraint(row1: 1.93*dot(x1) + 0.25*sqrt(1.50 + powi(dot(x1), 2) + powi(dot(x1), 2)) - 0.51*0.41*sin(x1)/(1.50 + cos(x1)) == 0)]
#[output(place = x1/(1 + powi(x1, 2)), power = 0.32*powi(dot(x1), 2) - p1*dot(x1)*dot(x1)*x1/(1 + powi(x1, 2)), push = 1/sqrt(1.50 + powi(x1, 2))*ddot(x1) + dot(x1)*ddot(x1), pull = (1.22 - 0.14*sin(0.91*x1 + 0.29*x1))*reaction(row1) - push, share = pull/(1.46 + powi(reaction(row1), 2)))]
pub struct Random12 {
    #[nominal(0.51)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1)]
#[inertia(diag(1.26))]
#[forces(
    1.16*dot(x1)/(1 + powi(x1, 2)) - 0.39*dot(x1)/(1 + powi(x1, 2)),
)]
#[potential_energy(1/sqrt(1.50 + powi(x1, 2)))]
#[constraint(row1: ddot(x1) - 0.28*dot(x1) - 0.28*bump(1.12*x1 - 0.25*x1 - 1.04) == 0)]
#[independent(dot(x1))]
#[independent(s1 = 1.71*dot(x1) + 0.53*(if t <= -0.46 { powi(cos(0.65*x1 + 0.93), 3) } else { cos(0.81*x1 - 0.24*t) }))]
#[output(place = cos(0.53*x1), power = 0.70*dot(x1)/(1 + powi(x1, 2)) - 1.18*dot(x1)/(1 + powi(t, 2)), push = sin(p3*t - 0.94)*ddot(x1) + dot(x1)*ddot(x1), pull = 1.02*reaction(row1) - push, share = pull/(1.31 + powi(reaction(row1), 2)))]
pub struct Random13 {
    #[nominal(1.23)]
    pub p1: f64,
    #[nominal(1.19)]
    pub p2: f64,
    #[nominal(1.48)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag((1.33 - 0.13*cos(0.98*x2 + 0.86*x1 + 0.35)), (1.02 - 0.22*cos(0.92*x1))))]
#[forces(
    p1*dot(x1)*dot(x2)*sin(0.51*x2) - 0.42*powi(dot(x2), 2),
    dot(x2)*sqrt(2 + powi(dot(x2), 2)),
)]
#[constraint(row1: 1.43*x2 + 0.22*sin(x2) - 0.79 == 0)]
#[constraint(row2: 1.15*dot(x1) + 0.28*dot(x1)*dot(x2)*ln(1.60 + 0.42*cos(x1)) - 0.41*atan2(x2, 2 + cos(x1))/2 == 0)]
#[independent(dot(x1))]
#[independent(s1 = 1.05*dot(x1) - 0.11*sin(1.12*x2)*dot(x2))]
#[output(place = tan(0.40*sin(x1))/2, power = p2*exp(0.20*x2) + 1.37*dot(x1) + p1*0.72, push = exp(-powi(x2, 2)/2)*ddot(x2) + dot(x2)*ddot(x2), pull = (1.11 + 0.19*sin(0.80*x2))*reaction(row2) - push, share = pull/(1.06 + powi(reaction(row2), 2)))]
pub struct Random14 {
    #[nominal(1.20)]
    pub p1: f64,
    #[nominal(0.61)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = 1.32*v1 + 0.19*sin(0.41*x2 + 0.39)*cos(0.52*x2),
    dot(x2) = (1.13 - 0.33*wave(0.89*x1 + 0.79*x1))*v2 + 0.48*sin(0.98*x2),
)]
#[inertia(diag(1.05, (1.30 + 0.33*sin(0.54*x1 - 0.63))))]
#[forces(
    0,
    p2*exp(0.20*x1) + p1*1.06,
)]
#[constraint(row1: 1.38*x1 + 0.30*sin(1.41*t) + 0.54 == 0)]
#[constraint(row2: ddot(x2) - 0.22*sin(p1*x2 + 0.75)*dot(v1) - 0.29*v1 - 0.29*(if t <= 0.41 { sin(0.61*x1 + 0.30*x2) } else { sin(0.71*t + 0.81*x2 - 0.86) }) == 0)]
#[independent(s1 = v2 + 0.17*0.95*sin(x1)/(1.50 + cos(x2))*v1)]
#[independent(v2)]
pub struct Random15 {
    #[nominal(0.56)]
    pub p1: f64,
    #[nominal(0.77)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + x1/(1 + powi(x1, 2))*dot(x1),
    v3 = dot(x3) + 1/sqrt(1.50 + powi(x1, 2))*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - x1/(1 + powi(x1, 2))*(v1),
    dot(x3) = v3 - 1/sqrt(1.50 + powi(x1, 2))*(v1),
)]
#[inertia(matrix(
    [(1.27)*(1.27), 0, 0],
    [_, ((1.31 - 0.14*wave(0.86*x2 - 0.43*x3)))*((1.31 - 0.14*wave(0.86*x2 - 0.43*x3))), ((1.31 - 0.14*wave(0.86*x2 - 0.43*x3)))*(0.18*sin(0.93*x1 + 0.14))],
    [_, _, (0.18*sin(0.93*x1 + 0.14))*(0.18*sin(0.93*x1 + 0.14)) + (1.09)*(1.09)],
))]
#[forces(
    0,
    p1*v2*v3*sin(0.94*x1 + 1.46)*cos(0.99*x1) + 1.79*v1/(1 + powi(x2, 2)) + p2*exp(0.20*x3),
    v1*v3/(1.13 - 0.13*1/sqrt(1.50 + powi(x1, 2))) - 1.32*v1/(1 + powi(x3, 2)) - 1.70*(if x3 < 0.04 { sin(1.11*x2 - 1.18) } else { tan(0.59*sin(x1))/2 }),
)]
#[potential_energy((if x2 > 0.47 { cos(0.87*x1 - 0.21*x2) } else { bump(0.74*x1 + 0.22) }))]
#[constraint(row1: v1 == 0)]
#[constraint(row2: 1.09*v2 + 0.24*sin(v2 + sin(0.89*x3)*v1) + 0.33*tan(0.54*sin(x1))/2 == 0)]
#[constraint(row3: dot(v3) - 0.13*atan2(x2, 2 + cos(x1))/2*dot(v1) - 0.16*cos(0.59*x2 + 0.66*x3)*dot(v2) + 0.48*v3/sqrt(1.20 + powi(v1, 2)) == 0)]
#[output(place = sin(p3*x1 - 0.13), power = 1.79*powi(v2, 2) - 0.66*cos(1.14*x2 - 0.59*x3 + 1.11), push = sin(0.47*x1 + 0.36*x2 + 0.83)*dot(v1) + v3*ddot(x3), pull = (1.34 + 0.34*sin(p1*x3 + 0.13))*reaction(row2) - push, share = pull/(1.77 + powi(reaction(row2), 2)))]
pub struct Random16 {
    #[nominal(1.42)]
    pub p1: f64,
    #[nominal(0.95)]
    pub p2: f64,
    #[nominal(0.54)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[inputs(tau)]
#[inertia(diag(1.02, (1.07 - 0.17*cos(0.77*x1))))]
#[forces(
    0,
    1.05*dot(x1)/(1 + powi(x2, 2)) - 1.28*1/sqrt(1.50 + powi(x1, 2)) - 1.46*dot(x2)/(1 + powi(t, 2)),
)]
#[potential_energy((if x1 >= 0.15 { cos(1.10*x2 + 0.70*x1 - 0.37) } else { exp(-powi(x2, 2)/2) }))]
#[constraint(row1: dot(x1) - 0.35*powi(cos(1.03*x1 + 0.84), 3)*dot(x2) == 0)]
#[constraint(again1: (1.36 - 0.10*bump(0.79*x1))*(dot(x1) - 0.35*powi(cos(1.03*x1 + 0.84), 3)*dot(x2)) == 0, redundant)]
pub struct Random17 {
    #[nominal(1.15)]
    pub p1: f64,
    #[nominal(1.15)]
    pub p2: f64,
    #[nominal(1.17)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[inertia(diag((1.04 - 0.14*bump(1.06*x2)), (1.24 + 0.12*sin(p3*x1 + 0.88))))]
#[forces(
    dot(x1)*sqrt(2 + powi(dot(x2), 2)) - p2*x2 - 0.68*x2/(1 + powi(x2, 2)),
    p3*x2 + p3*1.37,
)]
#[potential_energy(cos(1.12*x2 - 0.56*x2 + 0.93))]
#[constraint(row1: 1.73*x1 + 0.14*sin(x1) + exp(0.25*x2)/2 + 0.77 == 0)]
pub struct Random18 {
    #[nominal(1.24)]
    pub p1: f64,
    #[nominal(0.64)]
    pub p2: f64,
    #[nominal(0.55)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + (if x2 < 0.22 { sin(p1*t - 0.26) } else { powi(cos(1.16*x3 + 0.57*x1), 3) })*dot(x1),
    v3 = dot(x3) + ln(1.60 + 0.62*cos(t))*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - (if x2 < 0.22 { sin(p1*t - 0.26) } else { powi(cos(1.16*x3 + 0.57*x1), 3) })*(v1),
    dot(x3) = v3 - ln(1.60 + 0.62*cos(t))*(v1),
)]
#[inertia(diag((1.18 - 0.27*(if x3 < -0.09 { ln(1.60 + 0.44*cos(t)) } else { ln(1.60 + 0.37*cos(t)) })), (1.35 + 0.14*sin(1.02*t)), (1.30 + 0.21*exp(-powi(t, 2)/2))))]
#[forces(
    p1*t - 1.91*v3 - p1*v3*v3*sin(0.76*t),
    p1*1.79,
    1.05*powi(v2, 2),
)]
#[configuration(x1 = 0.86*sin(0.65*t + 1.07), x2 = 1.27*sin(0.86*t - 0.32*t)*cos(0.92*x3 + 0.29*t))]
#[constraint(held_x1: x1 - (0.86*sin(0.65*t + 1.07)) == 0)]
#[constraint(held_x2: x2 - (1.27*sin(0.86*t - 0.32*t)*cos(0.92*x3 + 0.29*t)) == 0)]
#[constraint(bound: 1.58*v3 - 0.22*ln(1.60 + 0.94*cos(x1))*v2*v2 + 0.37*1/sqrt(1.50 + powi(x1, 2)) == 0)]
pub struct Random19 {
    #[nominal(1.28)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = (1.28 + 0.11*x2/(1 + powi(x2, 2)))*dot(x1) + 0.27*sin(p1*x2 - 0.56)*dot(x2),
    v2 = 1.03*dot(x2) - 0.26*(if x2 <= 0.54 { 0.56*sin(x1)/(1.50 + cos(x2)) } else { atan2(x2, 2 + cos(x2))/2 })*dot(x1),
)]
#[kinetic_energy((1.19 - 0.33*sin(0.89*x2 - 0.80*x1))*powi(v1, 2)/2 + 1.18*powi(v2, 2)/2 - 0.46*0.95*sin(x2)/(1.50 + cos(x2)))]
#[forces(
    0.86*x1/(1 + powi(x1, 2)),
    p2*x2 - 1.41*v1 - 1.33*powi(v2, 2),
)]
#[constraint(row1: (1.52 + 0.20*0.81*sin(x1)/(1.50 + cos(x1)))*v1 - 0.96*v2 - 0.35*powi(cos(0.85*x1 - 0.53*x1), 3) == 0)]
#[independent(v2)]
#[independent(v1)]
#[output(place = wave(0.93*x1 + 0.87*x2 + 1.09), power = p1*v2*v2*(if x2 > 0.09 { atan2(x2, 2 + cos(x2))/2 } else { 0.90*sin(x2)/(1.50 + cos(x1)) }) + p1*0.70, push = wave(0.62*x1)*dot(v1) + v1*ddot(x1), pull = (1.17 + 0.27*sin(0.88*x2))*reaction(row1) - push, share = pull/(1.72 + powi(reaction(row1), 2)))]
pub struct Random20 {
    #[nominal(1.44)]
    pub p1: f64,
    #[nominal(1.45)]
    pub p2: f64,
    #[nominal(0.71)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 2)]
#[coordinates(x[n])]
#[define(s[i] = sin(0.72*x[i] + i/2 - 0.72 + t/2) for i in 0..n)]
#[define(r[0] = s[0]/2, r[i] = (r[i - 1] + s[i])/2 for i in 1..n)]
#[inertia(diag((1.17 + k[i]*r[i]/4) for i in 0..n))]
#[forces(
    0.30*sum(0..n, |j| sin(x[i] - x[j])*dot(x[j])) - 0.70*k[i]*dot(x[i]) - product(0..=i, |j| s[j]) for i in 0..n,
)]
pub struct Random21 {
    #[nominal(1.27)]
    pub p1: f64,
    #[nominal(1.13)]
    pub k: [f64; 2],
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[inertia(diag((1.16 + 0.21*bump(0.80*x2 - 0.68*x1)), (1.22 + 0.26*sin(0.41*x1 - 0.46*x1))))]
#[forces(
    dot(x2)*dot(x1)/(1.05 - 0.10*(if x2 > 0.21 { sin(1.04*x2 - 0.39*x1) } else { sin(0.51*x2 + 0.59*x1) })) - p1*dot(x2)*dot(x2)*atan2(x1, 2 + cos(x1))/2,
    0.90*(if x1 <= 0.14 { exp(-powi(x2, 2)/2) } else { x1/(1 + powi(x1, 2)) }) + 1.58*sin(0.58*x2)*cos(1.14*x2 + 0.84*x1) + p1*1.64,
)]
#[output(place = wave(0.84*x1 - 0.60*x1 - 0.51), power = 1.87*sin(0.59*x1)*cos(0.79*x2 - 0.68*x2 + 0.96) - 0.34*cos(0.99*x2 - 0.76) - p1*exp(0.20*x1) - 0.45*dot(x2), push = bump(1.04*x2 + 0.84)*ddot(x2) + dot(x2)*ddot(x2))]
pub struct Random22 {
    #[nominal(0.85)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[inertia(diag((1.34 - 0.13*sin(0.56*x1)), 1.30))]
#[forces(
    dot(x2)*dot(x2)/1.32 - p1*dot(x2)*dot(x2)*wave(0.74*x2) - 1.36*powi(dot(x1), 2) - 0.90*dot(x1)/(1 + powi(x1, 2)),
    p2*x1,
)]
#[potential_energy((if x1 < 0.06 { ln(1.60 + 0.65*cos(x2)) } else { exp(-powi(x1, 2)/2) }))]
#[constraint(row1: (1.50 - 0.25*powi(cos(0.58*x2 - 0.27*x2), 3))*dot(x1) + 0.22*sin(0.75*x2 + 0.72*x1)*dot(x2) == 0)]
#[independent(dot(x2))]
#[independent(s1 = dot(x2) + 0.11*0.31*sin(x1)/(1.50 + cos(x2))*dot(x1) + 0.26*x2/(1 + powi(x2, 2)))]
#[output(place = x2/(1 + powi(x2, 2)), power = dot(x2)*dot(x1)/(1.22 + 0.18*x2/(1 + powi(x2, 2))) - p1*0.50 - dot(x1)*dot(x2)/1.18 - p2*x1, push = bump(1.05*x2 + 0.24*x1)*ddot(x1) + dot(x1)*ddot(x1), pull = 1.22*reaction(row1) - push, share = pull/(1.69 + powi(reaction(row1), 2)))]
pub struct Random23 {
    #[nominal(0.74)]
    pub p1: f64,
    #[nominal(0.63)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = (1.02 + 0.15*atan2(x1, 2 + cos(x2))/2)*dot(x1) + 0.32*cos(1.04*x1)*dot(x2) - 0.21*sin(p1*x2 - 0.86),
    v2 = (1.38 + 0.14*(if x1 >= 0.51 { wave(0.72*x1) } else { 0.72*sin(x1)/(1.50 + cos(x1)) }))*dot(x2) - 0.16*(if x2 < 0.04 { 1/sqrt(1.50 + powi(x2, 2)) } else { sin(0.44*x1) }),
)]
#[inertia(diag((1.31 + 0.16*1/sqrt(1.50 + powi(x2, 2))), 1.21))]
#[forces(
    p1*0.78 + 0.58*v2 + 1.47*powi(v1, 2) + 1.49*powi(v1, 2),
    1.26*sin(0.96*x1 + 0.79*x1)*cos(0.72*x1) - p2*1.91 - 0.88*v1/(1 + powi(x2, 2)),
)]
#[constraint(row1: 1.41*x1 + 0.14*sin(x1) + 0.33*x2 + 0.36 == 0)]
#[independent(s1 = 1.96*v2 - 0.25*sin(0.93*x2 - 0.47*x1 + 0.29)*v1)]
#[output(place = 1/sqrt(1.50 + powi(x2, 2)), power = 1.00*powi(v1, 2) - p2*v1*v2*cos(0.80*x1 - 1.48) - 0.73*powi(v2, 2), push = powi(cos(1.19*x1 + 1.13), 3)*dot(v1) + v1*ddot(x1), pull = 1.23*reaction(row1) - push, share = pull/(1.48 + powi(reaction(row1), 2)))]
pub struct Random24 {
    #[nominal(1.14)]
    pub p1: f64,
    #[nominal(1.09)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1) + 0.35*sin(p2*x1 - 0.30)*dot(x2) - 0.50*tan(0.31*sin(x1))/2,
    v2 = (1.15 - 0.27*sin(p3*x2 - 0.46))*dot(x2) - 0.37*exp(-powi(x1, 2)/2)*dot(x1) + 0.28*powi(cos(0.49*x1 + 0.61*x1), 3),
)]
#[inertia(matrix(
    [((1.16 - 0.30*sin(p2*x2 + 0.14)))*((1.16 - 0.30*sin(p2*x2 + 0.14))), ((1.16 - 0.30*sin(p2*x2 + 0.14)))*(0.38*0.86*sin(x1)/(1.50 + cos(x2)))],
    [_, (0.38*0.86*sin(x1)/(1.50 + cos(x2)))*(0.38*0.86*sin(x1)/(1.50 + cos(x2))) + (1.24)*(1.24)],
))]
#[forces(
    p3*x2,
    1.50*v1/(1 + powi(x1, 2)) - tau*1.52,
)]
#[constraint(row1: 1.65*x1 + 0.26*sin(x1) - 0.37 == 0)]
#[constraint(row2: 1.31*v2 - 0.30*(if x1 < -0.49 { exp(-powi(x1, 2)/2) } else { sin(0.70*x1)*cos(0.47*x2 - 0.63*x1) })*v1 - 0.52*powi(cos(0.53*x2 - 0.42*x2), 3) == 0)]
pub struct Random25 {
    #[nominal(1.12)]
    pub p1: f64,
    #[nominal(0.58)]
    pub p2: f64,
    #[nominal(1.41)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[inertia(matrix(
    [(1.27)*(1.27), (1.27)*(0.12*sin(1.18*x2 - 1.20)), (1.27)*(0.26*sin(0.66*x3 - 0.53*x2 - 0.59)*cos(0.87*x1 + 1.05))],
    [_, (0.12*sin(1.18*x2 - 1.20))*(0.12*sin(1.18*x2 - 1.20)) + (1.06)*(1.06), (0.12*sin(1.18*x2 - 1.20))*(0.26*sin(0.66*x3 - 0.53*x2 - 0.59)*cos(0.87*x1 + 1.05)) + (1.06)*(0.22*sin(1.03*x2 + 0.51*x2 + 1.19))],
    [_, _, (0.26*sin(0.66*x3 - 0.53*x2 - 0.59)*cos(0.87*x1 + 1.05))*(0.26*sin(0.66*x3 - 0.53*x2 - 0.59)*cos(0.87*x1 + 1.05)) + (0.22*sin(1.03*x2 + 0.51*x2 + 1.19))*(0.22*sin(1.03*x2 + 0.51*x2 + 1.19)) + ((1.01 + 0.11*exp(-powi(x1, 2)/2)))*((1.01 + 0.11*exp(-powi(x1, 2)/2)))],
))]
#[forces(
    dot(x1)*dot(x1)/(1.20 - 0.30*(if x2 >= -0.51 { cos(0.52*x3 + 0.69) } else { wave(0.45*x2 + 0.73*x2) })) - 1.82*dot(x1),
    0,
    0.39*cos(0.65*x2 - 0.20) + dot(x1)*sqrt(2 + powi(dot(x1), 2)),
)]
#[constraint(height: 1.86*x1 + exp(0.24*x3)/2 - 0.78 == 0)]
#[constraint(height_rate: 1.86*dot(x1) + 0.24*exp(0.24*x3)*dot(x3)/2 == 0)]
#[constraint(further: dot(x2) - 0.29*1/sqrt(1.50 + powi(x3, 2))*dot(x3) - 0.28*cos(0.76*x2 - 0.76*x3)*dot(x1) == 0)]
#[independent(s1 = 1.61*dot(x3) - 0.22*bump(0.76*x1 - 0.42*x1)*dot(x1) + 0.55*tan(0.44*sin(x3))/2)]
#[output(place = tan(0.84*sin(x1))/2, power = dot(x1)*sqrt(2 + powi(dot(x2), 2)) - p2*x1, push = bump(1.13*x3 + 0.87)*ddot(x2) + dot(x3)*ddot(x3))]
pub struct Random26 {
    #[nominal(0.87)]
    pub p1: f64,
    #[nominal(0.71)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + sin(0.94*x2)*dot(x1),
    v3 = dot(x3) + (if x2 > -0.45 { cos(0.85*x1) } else { sin(0.91*x3 - 0.21*t + 0.73)*cos(0.86*x1 + 0.59*x3) })*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - sin(0.94*x2)*(v1),
    dot(x3) = v3 - (if x2 > -0.45 { cos(0.85*x1) } else { sin(0.91*x3 - 0.21*t + 0.73)*cos(0.86*x1 + 0.59*x3) })*(v2 - sin(0.94*x2)*(v1)),
)]
#[inertia(matrix(
    [((1.30 - 0.14*cos(0.69*t + 1.41)))*((1.30 - 0.14*cos(0.69*t + 1.41))), 0, ((1.30 - 0.14*cos(0.69*t + 1.41)))*(0.21*sin(0.67*t - 0.69*x1)*cos(0.94*x2))],
    [_, (1.26)*(1.26), (1.26)*(0.35*x3/(1 + powi(x3, 2)))],
    [_, _, (0.21*sin(0.67*t - 0.69*x1)*cos(0.94*x2))*(0.21*sin(0.67*t - 0.69*x1)*cos(0.94*x2)) + (0.35*x3/(1 + powi(x3, 2)))*(0.35*x3/(1 + powi(x3, 2))) + ((1.37 - 0.12*atan2(x2, 2 + cos(t))/2))*((1.37 - 0.12*atan2(x2, 2 + cos(t))/2))],
))]
#[forces(
    p1*exp(0.20*x3) - p1*exp(0.20*x1),
    v1*v1/1.21,
    0.80*powi(v1, 2) - 0.87*powi(v3, 2),
)]
#[constraint(height: 1.69*x2 + 0.22*sin(x2) + 0.16*powi(x1, 2)/2 + 0.30*sin(1.15*t) - 0.57 == 0)]
#[constraint(first: 1.36*v3 + 0.33*atan2(x2, 2 + cos(x2))/2*v1 + 0.28*cos(1.17*x2 - 0.79*x3)*v2 == 0)]
#[constraint(second: 1.69*dot(x2) + 0.22*cos(x2)*dot(x2) + 0.16*x1*dot(x1) + 0.30*1.15*cos(1.15*t) - 0.50*sin(1.01*t - 1.15)*(1.36*v3 + 0.33*atan2(x2, 2 + cos(x2))/2*v1 + 0.28*cos(1.17*x2 - 0.79*x3)*v2) == 0)]
#[output(place = tan(0.75*sin(x1))/2, power = p1*0.63 + v2*v2/(1.08 + 0.25*sin(0.82*x2 + 0.77)) + p1*x2 + 2.00*powi(v2, 2), push = (if x3 < 0.05 { sin(0.90*x1)*cos(1.15*x3) } else { powi(cos(0.99*x1), 3) })*dot(v3) + v1*ddot(x1))]
pub struct Random27 {
    #[nominal(1.05)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[inputs(tau)]
#[kinetic_energy((1.39 + 0.19*ln(1.60 + 0.70*cos(x1)))*powi(dot(x1), 2)/2 + (1.09 + 0.28*sin(0.43*x2 - 0.91))*powi(dot(x2), 2)/2 - 0.48*sin(0.55*x2 + 0.57*x2 - 0.58)*dot(x1) + 0.27*bump(0.46*x1)*dot(x2) + 0.62*tan(0.90*sin(x1))/2)]
#[forces(
    tau*0.64 - p1*dot(x1)*dot(x2)*1/sqrt(1.50 + powi(x1, 2)) - p1*exp(0.20*x2),
    p1*exp(0.20*x2) + p1*x1,
)]
#[configuration(x2 = 1.24*1/sqrt(1.50 + powi(x1, 2)))]
#[constraint(held_x2: x2 - (1.24*1/sqrt(1.50 + powi(x1, 2))) == 0)]
pub struct Random28 {
    #[nominal(0.74)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2)]
#[inertia(diag(1.35, (1.39 + 0.26*sin(0.60*x2)*cos(0.59*x1 - 1.29))))]
#[forces(
    0.51*dot(x2) - 1.31*cos(0.92*t) - p2*dot(x2)*dot(x2)*exp(-powi(x1, 2)/2) - dot(x1)*sqrt(2 + powi(dot(x1), 2)),
    0.84*powi(dot(x2), 2),
)]
#[potential_energy(sin(0.87*x1)*cos(0.92*x1 - 0.84*x1))]
#[configuration(of(q1), x2 = 1.25*q1, x1 = sin(p1*q1 + 0.99))]
#[constraint(held_x1: x1 - (sin(p1*(x2/1.25) + 0.99)) == 0)]
#[output(place = wave(1.06*x2 - 0.55*t), power = dot(x1)*sqrt(2 + powi(dot(x2), 2)), push = sin(0.96*t - 1.27)*ddot(x1) + dot(x2)*ddot(x2), pull = (1.27 + 0.28*cos(0.59*t))*reaction(held_x1) - push, share = pull/(1.95 + powi(reaction(held_x1), 2)))]
pub struct Random29 {
    #[nominal(1.20)]
    pub p1: f64,
    #[nominal(1.47)]
    pub p2: f64,
    #[nominal(1.26)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = (1.08 + 0.20*tan(0.39*sin(t))/2)*v1 + 0.58*0.81*sin(x1)/(1.50 + cos(t)),
    dot(x2) = 1.27*v2 - 0.35*wave(1.17*x3 - 0.68*x1 - 1.48)*v1 + 0.59*cos(0.77*t - 0.82*t - 0.62),
    dot(x3) = v3 - 0.50*sin(0.70*x3 - 1.37)*cos(0.55*x2 + 0.28*x3),
)]
#[kinetic_energy(1.02*powi(v1, 2)/2 + 1.16*powi(v2, 2)/2 + (1.30 + 0.12*sin(1.10*x1 + 0.90*x2))*powi(v3, 2)/2)]
#[forces(
    1.73*v1/(1 + powi(x3, 2)) + 1.39*powi(v3, 2) + p1*0.31 + 0.95*v3/(1 + powi(x1, 2)),
    1.81*powi(v1, 2) - p1*v3*v1*(if x3 >= -0.35 { t/(1 + powi(t, 2)) } else { bump(0.77*x3 - 0.59*x1) }) - 0.45*(if x3 < 0.18 { bump(0.55*x3) } else { bump(0.70*t + 0.31*t) }),
    p1*v2*v1*exp(-powi(x1, 2)/2),
)]
#[potential_energy(atan2(x3, 2 + cos(x2))/2)]
#[configuration(x2 = 0.58*sin(p1*x1 + 0.64))]
#[constraint(held_x2: x2 - (0.58*sin(p1*x1 + 0.64)) == 0)]
#[constraint(rolling: (1.50 - 0.26*tan(0.63*sin(x1))/2)*dot(x3) + 0.18*(if x1 <= -0.03 { tan(0.57*sin(x1))/2 } else { sin(1.04*x1 + 0.84) })*dot(x1) == 0)]
#[independent(s1 = dot(x1) + 0.31*ln(1.60 + 0.92*cos(x3))*dot(x3) + 0.60*atan2(x1, 2 + cos(x1))/2)]
pub struct Random30 {
    #[nominal(0.87)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.04 + 0.12*0.31*sin(x2)/(1.50 + cos(x2))), (1.23 - 0.17*sin(0.59*x3)), (1.27 - 0.28*1/sqrt(1.50 + powi(x3, 2)))))]
#[forces(
    0.62*dot(x3)/(1 + powi(x1, 2)),
    dot(x1)*sqrt(2 + powi(dot(x2), 2)) - 0.51*powi(dot(x3), 2) - 1.68*dot(x1)/(1 + powi(x2, 2)) - p1*x2,
    p2*dot(x2)*dot(x3)*powi(cos(1.02*x2), 3) - dot(x3)*sqrt(2 + powi(dot(x3), 2)) - dot(x1)*sqrt(2 + powi(dot(x2), 2)),
)]
#[potential_energy(exp(-powi(x3, 2)/2))]
#[constraint(row1: dot(x1) + 0.66*0.64*sin(x1)/(1.50 + cos(x1))*dot(x2) == 0)]
#[constraint(row2: dot(x3) + 0.24*(if x1 >= -0.15 { 1/sqrt(1.50 + powi(x1, 2)) } else { tan(0.64*sin(x2))/2 })*dot(x2) + 0.40*cos(0.88*x3 - 0.32*x1) == 0)]
#[complement(
    w1 = [-1.36*(0.66*0.64*sin(x1)/(1.50 + cos(x1))), 1.36, -1.36*(0.24*(if x1 >= -0.15 { 1/sqrt(1.50 + powi(x1, 2)) } else { tan(0.64*sin(x2))/2 }))],
)]
#[output(place = sin(p1*x3 - 0.75), power = p2*exp(0.20*x1) - 1.38*powi(dot(x3), 2), push = sin(0.74*x2 - 0.53*x1 - 0.72)*cos(0.54*x3 + 0.21*x3)*ddot(x1) + dot(x3)*ddot(x3), pull = (1.03 + 0.32*sin(1.08*x2 - 0.67*x3 + 0.56))*reaction(row2) - push, share = pull/(1.98 + powi(reaction(row2), 2)))]
pub struct Random31 {
    #[nominal(0.80)]
    pub p1: f64,
    #[nominal(0.58)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = (1.18 - 0.22*powi(cos(1.14*x2), 3))*v1 - 0.22*wave(1.00*x2 - 0.71*x1)*v2 - 0.45*bump(0.48*x1 + 0.82*x1),
    dot(x2) = 1.35*v2 + 0.33*x2/(1 + powi(x2, 2))*v1 - 0.43*atan2(x1, 2 + cos(x1))/2,
)]
#[inertia(matrix(
    [(1.17)*(1.17), 0],
    [_, (1.35)*(1.35)],
))]
#[forces(
    p1*x1 - 1.49*wave(0.79*x2 + 0.97),
    p1*0.99 + p1*1.18 + 0.54*v2,
)]
#[constraint(row1: 1.27*x2 + 0.27*sin(x1) + 0.78 == 0)]
#[independent(v1)]
#[output(place = exp(-powi(x2, 2)/2), power = p1*v1*v2*powi(cos(1.13*x1 - 1.42), 3), push = (if x2 < -0.15 { atan2(x2, 2 + cos(x1))/2 } else { wave(0.86*x2) })*dot(v2) + v1*ddot(x1), pull = (1.21 - 0.24*(if x2 > -0.07 { 0.56*sin(x2)/(1.50 + cos(x2)) } else { wave(0.84*x2 + 0.50) }))*reaction(row1) - push, share = pull/(1.33 + powi(reaction(row1), 2)))]
pub struct Random32 {
    #[nominal(1.05)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = v1 - 0.32*wave(1.12*x3 + 0.19)*v2,
    dot(x2) = (1.33 + 0.20*tan(0.42*sin(x3))/2)*v2 - 0.18*exp(-powi(x1, 2)/2)*v1,
    dot(x3) = 1.17*v3,
)]
#[inertia(diag((1.18 + 0.13*exp(-powi(x3, 2)/2)), (1.31 - 0.31*wave(1.02*x1 + 0.55*x1 + 1.36)), 1.01))]
#[forces(
    v3*v1/(1.04 - 0.11*sin(p2*x3 + 0.74)) + p2*x1,
    0,
    0,
)]
#[constraint(row1: 1.33*x3 + 0.20*sin(x3) - 0.46 == 0)]
#[constraint(row2: 1.80*v2 - 0.22*cos(0.99*x2 - 0.49*x1)*v3 - 0.52*powi(cos(0.67*x3 - 1.03), 3) == 0)]
#[constraint(row3: (1.50 - 0.24*atan2(x2, 2 + cos(x3))/2)*v1 - 0.15*0.42*sin(x2)/(1.50 + cos(x1))*v3 + 0.34*1/sqrt(1.50 + powi(x3, 2))*v2 == 0)]
#[output(place = tan(0.59*sin(x1))/2, power = p1*0.81 - 0.96*powi(cos(1.03*x1 + 0.46), 3), push = x2/(1 + powi(x2, 2))*dot(v3) + v3*ddot(x3), pull = 1.26*reaction(row2) - push, share = pull/(1.99 + powi(reaction(row2), 2)))]
pub struct Random33 {
    #[nominal(0.79)]
    pub p1: f64,
    #[nominal(0.56)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.26 + 0.29*cos(0.67*x2)), 1.18, (1.28 - 0.27*powi(cos(0.68*x2 + 0.95), 3))))]
#[forces(
    1.66*powi(dot(x1), 2) + p3*1.24,
    1.49*dot(x1)/(1 + powi(x3, 2)) + p2*dot(x1)*dot(x2)*(if x2 <= 0.41 { sin(p1*x1 + 0.37) } else { cos(0.64*x1 - 0.13) }) + 1.15*dot(x3)/(1 + powi(x3, 2)),
    0.45*dot(x1) + 0.85*dot(x2) + 1.58*dot(x2)/(1 + powi(x3, 2)),
)]
#[constraint(row1: powi(dot(x2), 2) - 0.20*powi(dot(x2), 2) - (2 - 0.20*tan(0.75*sin(x3))/2) == 0)]
#[constraint(row2: 1.91*dot(x3) + 0.15*dot(x3)*dot(x2)*sin(0.88*x2) - 0.57*sin(1.15*x1 + 1.19)*cos(0.57*x3 + 0.79*x3 - 1.23) == 0)]
#[constraint(row3: 1.35*dot(x1) - 0.29*sqrt(1.50 + powi(dot(x3), 2) + powi(dot(x3), 2)) - 0.32*atan2(x1, 2 + cos(x3))/2 == 0)]
#[independent(s1 = (1.50 + 0.11*cos(0.97*x3))*dot(x1) + 0.23*1/sqrt(1.50 + powi(x1, 2)), s2 = (1.50 + 0.12*0.30*sin(x3)/(1.50 + cos(x3)))*dot(x3) - 0.19*sin(1.13*x2 - 0.77)*cos(1.10*x3 - 0.36*x2)*dot(x1), dot(x2))]
#[output(place = 1/sqrt(1.50 + powi(x1, 2)), power = 1.52*dot(x2)/(1 + powi(x3, 2)) + 1.70*dot(x1)/(1 + powi(x1, 2)) + 1.04*ln(1.60 + 0.42*cos(x3)) + 0.94*dot(x1)/(1 + powi(x2, 2)), push = sin(0.54*x2)*ddot(x2) + dot(x2)*ddot(x2), pull = (1.14 + 0.30*sin(1.15*x2 - 0.87*x2 - 1.00)*cos(0.96*x1))*reaction(row1) - push, share = pull/(1.84 + powi(reaction(row1), 2)))]
pub struct Random34 {
    #[nominal(0.80)]
    pub p1: f64,
    #[nominal(0.61)]
    pub p2: f64,
    #[nominal(1.04)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = (1.30 - 0.18*tan(0.81*sin(t))/2)*v1 - 0.46*exp(-powi(x2, 2)/2),
    dot(x2) = (1.19 + 0.35*(if x1 <= -0.11 { atan2(x1, 2 + cos(x1))/2 } else { wave(0.88*t - 0.52*t + 0.54) }))*v2 + 0.15*(if x2 > -0.47 { tan(0.89*sin(x3))/2 } else { sin(1.06*x2) })*v1 - 0.11*sin(0.70*t - 0.58*x1),
    dot(x3) = v3 - 0.38*sin(0.58*x2 + 0.57*t)*cos(0.73*x3 - 0.77*x3 - 0.75)*v1 - 0.27*wave(1.01*x1 + 0.89*x2 - 0.86),
)]
#[inertia(diag((1.26 + 0.32*cos(0.69*t)), (1.16 - 0.11*sin(0.46*x3 + 0.59*t)), (1.35 + 0.26*cos(1.02*t - 0.86*x2))))]
#[forces(
    0,
    1.42*powi(v1, 2),
    p1*x1,
)]
#[constraint(row1: ddot(x3) - 0.27*atan2(x2, 2 + cos(x3))/2*dot(v2) + 0.22*exp(-powi(t, 2)/2)*dot(v1) - 0.46*v2*v2*cos(0.77*t - 0.85*x2) == 0)]
#[independent(s1 = 1.79*v1 - 0.59*wave(0.92*x2), v2, s3 = 1.08*v3 + 0.20*(if x1 <= -0.58 { cos(0.54*x2) } else { x3/(1 + powi(x3, 2)) })*v1)]
#[output(place = (if x2 <= -0.23 { wave(1.04*t + 0.75*x2) } else { exp(-powi(t, 2)/2) }), power = 1.09*powi(v1, 2) + v2*v3/1.14 + p1*v1*v3*sin(0.48*t)*cos(0.62*x3 - 0.89*t) + 1.37*v1, push = sin(0.83*x2 - 0.44*x3 + 0.65)*cos(0.71*x3 - 0.53*t + 1.33)*dot(v2) + v3*ddot(x3), pull = (1.25 + 0.13*0.89*sin(x3)/(1.50 + cos(x3)))*reaction(row1) - push, share = pull/(1.52 + powi(reaction(row1), 2)))]
pub struct Random35 {
    #[nominal(1.15)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = 1.02*v1 - 0.22*sin(0.98*x2)*cos(0.89*x2 + 0.38*x2)*v3 + 0.23*sin(0.62*x1 - 0.47)*cos(0.79*x1),
    dot(x2) = v2 - 0.37*cos(1.11*x1)*v1 - 0.23*wave(0.55*x1),
    dot(x3) = (1.22 + 0.24*sin(p1*x1 + 0.46))*v3 - 0.18*powi(cos(0.63*x3 - 0.44), 3),
)]
#[define(l11 = 1.06, l21 = 0.18*sin(0.61*x3), l22 = (1.05 + 0.15*x1/(1 + powi(x1, 2))), l31 = 0.25*cos(0.44*x2 + 0.80*x2), l32 = 0.36*ln(1.60 + 0.47*cos(x3)), l33 = (1.15 + 0.34*cos(0.95*x1 + 0.51)))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32],
    [_, _, l31*l31 + l32*l32 + l33*l33],
))]
#[forces(
    v1*v2/(1.09 - 0.19*sin(0.41*x1 + 0.41*x3)) + v1*v2/1.20,
    p1*v1*v3*ln(1.60 + 0.95*cos(x2)) + p1*x2 + p1*exp(0.20*x3),
    p1*1.59 - p1*exp(0.20*x2) - 1.97*v2 - p1*1.62,
)]
#[constraint(row1: 1.23*x1 + 0.12*sin(x1) + exp(0.18*x2)/2 - 0.41 == 0)]
#[constraint(row2: 1.79*v3 + 0.29*sin(v3 + ln(1.60 + 0.78*cos(x2))*v2) + 0.35*(if x3 > 0.51 { ln(1.60 + 0.46*cos(x2)) } else { tan(0.34*sin(x1))/2 }) == 0)]
#[output(place = sin(0.58*x3 - 0.37*x1)*cos(0.73*x2 - 0.51), power = 1.71*(if x1 <= 0.39 { cos(1.19*x3 - 0.50*x3 + 0.38) } else { x1/(1 + powi(x1, 2)) }), push = powi(cos(0.85*x2 + 0.65*x1), 3)*dot(v3) + v1*ddot(x1), pull = (1.18 + 0.23*wave(1.14*x1 - 0.44*x1))*reaction(row2) - push, share = pull/(1.43 + powi(reaction(row2), 2)))]
pub struct Random36 {
    #[nominal(0.54)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = (1.11 - 0.14*1/sqrt(1.50 + powi(x2, 2)))*v1 - 0.28*x1/(1 + powi(x1, 2))*v2 - 0.14*(if t > -0.03 { sin(0.83*x1 + 0.64*t - 0.36) } else { sin(0.97*x2 - 0.62*t - 1.08) }),
    dot(x2) = v2 + 0.49*(if x2 > 0.07 { sin(p2*t - 0.38) } else { bump(1.08*x2) }),
)]
#[define(l11 = 1.15, l21 = 0.31*cos(0.66*x2 + 0.21), l22 = 1.19)]
#[inertia(matrix(
    [l11*l11, l11*l21],
    [_, l21*l21 + l22*l22],
))]
#[forces(
    1.41*cos(0.62*x1 - 0.83*t) - v1*v2/(1.01 - 0.24*t/(1 + powi(t, 2))) - p2*x2 - v1*sqrt(2 + powi(v1, 2)),
    p1*v2*v2*sin(p1*x2 - 0.48) - 1.55*v2 - p2*exp(0.20*x1) - 0.84*powi(v2, 2),
)]
#[constraint(row1: (1.50 - 0.23*powi(cos(1.15*x1), 3))*v2 == 0)]
#[constraint(row2: (1.50 - 0.24*1/sqrt(1.50 + powi(t, 2)))*dot(v1) + 0.12*1/sqrt(1.50 + powi(t, 2))*dot(v2) - 0.71*v1 - 0.71*bump(0.89*t) == 0)]
#[output(place = sin(p3*x1 + 0.33), power = p1*v1*v1*exp(-powi(t, 2)/2) - tau*0.56, push = powi(cos(1.20*t), 3)*dot(v1) + v1*ddot(x1), pull = 1.27*reaction(row2) - push, share = pull/(1.08 + powi(reaction(row2), 2)))]
pub struct Random37 {
    #[nominal(0.78)]
    pub p1: f64,
    #[nominal(1.26)]
    pub p2: f64,
    #[nominal(1.02)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.32 - 0.24*tan(0.64*sin(x3))/2), (1.29 + 0.17*x2/(1 + powi(x2, 2))), (1.28 + 0.29*(if t >= -0.33 { cos(0.53*x1) } else { sin(p3*x2 + 0.16) }))))]
#[forces(
    dot(x1)*dot(x1)/(1.08 + 0.31*sin(0.50*x3)),
    1.47*dot(x3) + 1.59*dot(x1)/(1 + powi(x1, 2)),
    1.02*cos(1.14*x1) - 0.47*powi(dot(x3), 2),
)]
#[constraint(row1: (1.50 + 0.29*x1/(1 + powi(x1, 2)))*dot(x1) == 0)]
#[constraint(row2: 1.93*dot(x2) + 0.23*sin(dot(x2) + bump(1.07*x3)*dot(x1)) - 0.33*t/(1 + powi(t, 2)) == 0)]
#[constraint(row3: ddot(x3) - 0.24*wave(0.83*x2 + 0.72)*ddot(x1) + 0.14*bump(1.00*x2)*ddot(x2) + 0.59*bump(1.19*t) == 0)]
#[independent(dot(x3), dot(x2))]
#[output(place = 0.89*sin(x3)/(1.50 + cos(t)), power = p3*dot(x2)*dot(x3)*sin(0.52*t)*cos(0.62*x1) + 1.20*1/sqrt(1.50 + powi(x3, 2)) + p2*t + 0.51*powi(dot(x3), 2), push = cos(0.70*x2)*ddot(x1) + dot(x3)*ddot(x3), pull = 1.00*reaction(row3) - push, share = pull/(1.67 + powi(reaction(row3), 2)))]
pub struct Random38 {
    #[nominal(0.99)]
    pub p1: f64,
    #[nominal(0.60)]
    pub p2: f64,
    #[nominal(0.73)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = v1 - 0.23*x2/(1 + powi(x2, 2))*v2,
    dot(x2) = (1.21 + 0.23*cos(1.02*t - 1.35))*v2 + 0.23*0.91*sin(x1)/(1.50 + cos(x1))*v1,
)]
#[inertia(diag(1.27, (1.20 - 0.11*ln(1.60 + 0.73*cos(x2)))))]
#[forces(
    v1*v2/(1.22 - 0.25*powi(cos(1.02*x2 + 0.73*x1), 3)),
    p2*v1*v2*cos(1.11*t + 0.19) - 1.27*v1 - 1.82*v1 - 0.54*powi(v2, 2),
)]
#[constraint(row1: 1.23*x1 + 0.28*x2 + 0.30*sin(0.86*t) + 0.63 == 0)]
#[constraint(again1: 0.77*(1.23*x1 + 0.28*x2 + 0.30*sin(0.86*t) + 0.63) == 0, redundant)]
#[constraint(again2: 0.85*(1.23*x1 + 0.28*x2 + 0.30*sin(0.86*t) + 0.63) == 0, redundant)]
#[independent(s1 = v2 - 0.20*atan2(x2, 2 + cos(x2))/2*v1 - 0.44*sin(1.08*x1))]
#[output(place = 1/sqrt(1.50 + powi(t, 2)), power = v2*v2/1.32, push = sin(0.75*x2 + 0.55*t)*cos(0.65*x1 + 0.72*t)*dot(v1) + v1*ddot(x1), pull = (1.17 - 0.12*cos(0.75*x1 - 0.31*x1))*reaction(again2) - push, share = pull/(1.29 + powi(reaction(again2), 2)))]
pub struct Random39 {
    #[nominal(1.14)]
    pub p1: f64,
    #[nominal(1.27)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.35 - 0.30*ln(1.60 + 0.55*cos(x2))), 1.33, (1.17 - 0.25*cos(0.95*x3 - 0.47*x3))))]
#[forces(
    1.21*dot(x2) - dot(x2)*sqrt(2 + powi(dot(x1), 2)),
    p1*1.27 + p1*exp(0.20*x3) + 1.43*dot(x2),
    dot(x1)*sqrt(2 + powi(dot(x3), 2)) + 0.47*dot(x2)/(1 + powi(x1, 2)) + p1*exp(0.20*x1) + dot(x1)*sqrt(2 + powi(dot(x2), 2)),
)]
#[potential_energy((if x2 < 0.14 { bump(0.62*x3 + 0.46*x3) } else { bump(1.03*x1 + 0.72*x2) }))]
#[constraint(row1: (1.50 - 0.13*x1/(1 + powi(x1, 2)))*dot(x1) - 0.40*powi(cos(1.05*x3), 3) == 0)]
#[constraint(row2: (1.50 + 0.18*sin(0.58*x2 - 0.26*x2)*cos(0.66*x3))*dot(x3) + 0.14*cos(0.70*x1 + 0.28*x1)*dot(x1) == 0)]
#[constraint(row3: (1.50 + 0.26*tan(0.87*sin(x3))/2)*dot(x2) - 0.23*sin(0.94*x2 + 0.30*x2)*dot(x1) - 0.19*0.66*sin(x3)/(1.50 + cos(x1))*dot(x3) == 0)]
#[output(place = sin(1.07*x3 - 0.77), power = 1.10*dot(x2) + 1.82*powi(dot(x3), 2), push = cos(0.76*x3 + 1.33)*ddot(x3) + dot(x3)*ddot(x3), pull = (1.12 + 0.21*(if x3 <= -0.26 { sin(0.96*x1) } else { ln(1.60 + 0.94*cos(x2)) }))*reaction(row3) - push, share = pull/(1.85 + powi(reaction(row3), 2)))]
pub struct Random40 {
    #[nominal(0.87)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1) - 0.11*x2/(1 + powi(x2, 2))*dot(x2) - 0.21*cos(1.17*x1 + 0.53*x3),
    v2 = (1.40 + 0.30*sin(1.09*x2 + 0.40*x1))*dot(x2) - 0.41*1/sqrt(1.50 + powi(x3, 2)),
    v3 = (1.28 - 0.23*(if x3 < -0.17 { sin(1.08*x3)*cos(0.91*x2) } else { ln(1.60 + 0.71*cos(x2)) }))*dot(x3) + 0.12*atan2(x3, 2 + cos(x2))/2*dot(x2) - 0.13*bump(0.77*x1 - 0.44*x2),
)]
#[inertia(diag((1.11 + 0.25*sin(p2*x2 - 0.50)), (1.12 + 0.33*atan2(x3, 2 + cos(x3))/2), (1.04 + 0.33*x2/(1 + powi(x2, 2)))))]
#[forces(
    v2*sqrt(2 + powi(v2, 2)) - 0.72*powi(v1, 2) - 1.13*powi(v2, 2) - 0.97*v3/(1 + powi(x3, 2)),
    1.64*v1 - tau*1.35,
    0,
)]
#[configuration(x1 = 1.27*(if x2 >= -0.04 { sin(0.48*x2 + 0.87*x2 + 1.49)*cos(0.49*x2 - 0.36*x2 + 1.42) } else { cos(0.72*x2 + 0.41*x2) }), x3 = 1.35*powi(cos(0.67*x2 + 0.42), 3))]
#[constraint(bound: 1.82*dot(v2) - 0.28*bump(0.92*x2 + 0.24*x2)*dot(v1) - 0.12*tan(0.76*sin(x3))/2*dot(v3) + 0.53*0.60*sin(x3)/(1.50 + cos(x2)) == 0)]
#[output(place = (if x2 > -0.20 { powi(cos(1.06*x1 + 0.23*x2), 3) } else { powi(cos(0.95*x3), 3) }), power = p2*v1*v2*bump(0.96*x1 - 0.48*x3) + 0.32*powi(v1, 2) + v2*sqrt(2 + powi(v2, 2)), push = x1/(1 + powi(x1, 2))*dot(v2) + v3*ddot(x3), pull = 1.02*reaction(bound) - push, share = pull/(1.12 + powi(reaction(bound), 2)))]
pub struct Random41 {
    #[nominal(1.16)]
    pub p1: f64,
    #[nominal(0.55)]
    pub p2: f64,
    #[nominal(1.03)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + tan(0.91*sin(t))/2*dot(x1),
    v3 = dot(x3) + cos(0.58*x2 - 0.51*x3)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - tan(0.91*sin(t))/2*(v1),
    dot(x3) = v3 - cos(0.58*x2 - 0.51*x3)*(v1),
)]
#[inertia(diag(1.28, (1.19 + 0.26*powi(cos(0.56*t), 3)), (1.12 - 0.23*(if x2 >= -0.16 { cos(0.54*x3 - 0.40) } else { bump(0.93*t + 0.80*x3) }))))]
#[forces(
    v1*v3/1.02 - p2*v3*v3*0.49*sin(x1)/(1.50 + cos(t)) - p2*v3*v3*1/sqrt(1.50 + powi(x3, 2)),
    1.64*v3/(1 + powi(x3, 2)),
    0.84*sin(0.53*t)*cos(0.86*t - 0.86*x3) + 1.40*powi(v2, 2),
)]
#[potential_energy(x1/(1 + powi(x1, 2)))]
#[constraint(row1: 1.57*x1 + 0.10*sin(x1) - 0.87*x3 + 0.10*cos(x3) + 0.20*0.53*sin(x2)/(1.50 + cos(x2)) + 0.30*sin(t) == 0)]
#[independent(v3, v2)]
#[independent(v1, v2)]
pub struct Random42 {
    #[nominal(0.90)]
    pub p1: f64,
    #[nominal(0.83)]
    pub p2: f64,
    #[nominal(1.32)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 2)]
#[coordinates(x[n])]
#[speeds(v[n])]
#[kinematics(
    v[i] = 1.13*k[i]*dot(x[i]) + 0.22*s[(i + 1) % n]*dot(x[(i + 1) % n]) - 0.35*s[i] for i in 0..n,
)]
#[define(s[i] = sin(0.87*x[i] + i/2 - 0.91) for i in 0..n)]
#[define(r[0] = s[0]/2, r[i] = (r[i - 1] + s[i])/2 for i in 1..n)]
#[inertia(matrix(
    [(1.29 + k[i]*r[i]/4)*(1.29 + k[j]*r[j]/4)/(1 + 2*powi(i - j, 2)) for j in 0..n] for i in 0..n,
))]
#[forces(
    0.31*sum(0..n, |j| sin(x[i] - x[j])*v[j]) - 0.53*k[i]*v[i] - product(0..=i, |j| s[j]) for i in 0..n,
)]
pub struct Random43 {
    #[nominal(1.33)]
    pub p1: f64,
    #[nominal(0.96)]
    pub k: [f64; 2],
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[inertia(matrix(
    [((1.35 - 0.25*cos(0.51*x2 + 0.38*x3)))*((1.35 - 0.25*cos(0.51*x2 + 0.38*x3))), ((1.35 - 0.25*cos(0.51*x2 + 0.38*x3)))*(0.12*sin(0.47*x1 - 1.41)*cos(0.41*x2 - 0.21*x3)), ((1.35 - 0.25*cos(0.51*x2 + 0.38*x3)))*(0.31*(if x1 < 0.25 { cos(1.18*x1) } else { x1/(1 + powi(x1, 2)) }))],
    [_, (0.12*sin(0.47*x1 - 1.41)*cos(0.41*x2 - 0.21*x3))*(0.12*sin(0.47*x1 - 1.41)*cos(0.41*x2 - 0.21*x3)) + (1.29)*(1.29), (0.12*sin(0.47*x1 - 1.41)*cos(0.41*x2 - 0.21*x3))*(0.31*(if x1 < 0.25 { cos(1.18*x1) } else { x1/(1 + powi(x1, 2)) })) + (1.29)*(0.39*bump(0.49*t))],
    [_, _, (0.31*(if x1 < 0.25 { cos(1.18*x1) } else { x1/(1 + powi(x1, 2)) }))*(0.31*(if x1 < 0.25 { cos(1.18*x1) } else { x1/(1 + powi(x1, 2)) })) + (0.39*bump(0.49*t))*(0.39*bump(0.49*t)) + ((1.20 + 0.28*(if x1 < -0.06 { wave(0.50*x2 + 0.54*x3) } else { sin(1.08*x1 + 0.82)*cos(0.56*x3 + 1.36) })))*((1.20 + 0.28*(if x1 < -0.06 { wave(0.50*x2 + 0.54*x3) } else { sin(1.08*x1 + 0.82)*cos(0.56*x3 + 1.36) })))],
))]
#[forces(
    0,
    1.04*powi(dot(x1), 2) - p1*dot(x1)*dot(x1)*(if x2 <= -0.46 { exp(-powi(x2, 2)/2) } else { 0.57*sin(x3)/(1.50 + cos(x1)) }) - p2*x1 - 0.30*dot(x2)/(1 + powi(x1, 2)),
    0.42*dot(x2) + p3*dot(x3)*dot(x3)*wave(1.01*x1 + 0.25*t),
)]
#[potential_energy(sin(1.10*x2 - 0.60*x1 + 0.78))]
pub struct Random44 {
    #[nominal(1.03)]
    pub p1: f64,
    #[nominal(1.09)]
    pub p2: f64,
    #[nominal(1.13)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + powi(cos(1.08*x4 + 0.53*x2 + 0.35), 3)*dot(x1),
    v3 = dot(x3) + wave(0.88*t - 0.41)*dot(x1),
    v4 = dot(x4) + x2/(1 + powi(x2, 2))*dot(x3),
    dot(x1) = v1,
    dot(x2) = v2 - powi(cos(1.08*x4 + 0.53*x2 + 0.35), 3)*(v1),
    dot(x3) = v3 - wave(0.88*t - 0.41)*(v1),
    dot(x4) = v4 - x2/(1 + powi(x2, 2))*(v3 - wave(0.88*t - 0.41)*(v1)),
)]
#[kinetic_energy(1.02*powi(v1, 2)/2 + (1.27 - 0.15*0.33*sin(x1)/(1.50 + cos(x2)))*powi(v2, 2)/2 + 1.14*powi(v3, 2)/2 + (1.26 - 0.12*0.46*sin(x3)/(1.50 + cos(t)))*powi(v4, 2)/2 - 0.32*cos(0.60*x2 + 0.58*x3 + 0.57)*v4 + 0.43*(if x1 < 0.43 { exp(-powi(x3, 2)/2) } else { tan(0.32*sin(x1))/2 }))]
#[forces(
    1.66*v3/(1 + powi(x2, 2)),
    0,
    1.20*v4/(1 + powi(t, 2)) - p1*v4*v3*atan2(x3, 2 + cos(x1))/2 - p1*0.42 - p1*1.06,
    p1*1.71 + v3*v1/(1.23 - 0.29*sin(1.06*t + 0.83*x4 + 1.21)*cos(0.55*x2 + 0.28*x1)) + v2*sqrt(2 + powi(v4, 2)),
)]
#[constraint(row1: 1.74*v3 + 0.30*bump(0.81*t)*v1 == 0)]
#[constraint(row2: v4 - 0.24*sin(0.55*x2 + 0.72)*v1 + 0.40*sin(1.12*x3) == 0)]
#[independent(s1 = (1.50 - 0.28*atan2(x3, 2 + cos(x1))/2)*v2 - 0.12*bump(0.56*x3 + 0.59*x3)*v3 + 0.16*t/(1 + powi(t, 2))*v4 + 0.23*(if x2 >= -0.50 { sin(0.78*t) } else { x3/(1 + powi(x3, 2)) }), v1)]
pub struct Random45 {
    #[nominal(0.94)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[kinetic_energy((1.00 + 0.16*(if x3 >= 0.08 { sin(1.02*x2 - 0.58*x2) } else { powi(cos(0.90*x2), 3) }))*powi(dot(x1), 2)/2 + (1.27 + 0.20*cos(0.48*x4 + 0.27*x3))*powi(dot(x2), 2)/2 + (1.00 + 0.11*bump(1.09*x4 - 0.23*x3))*powi(dot(x3), 2)/2 + (1.33 + 0.32*exp(-powi(x1, 2)/2))*powi(dot(x4), 2)/2 - 0.25*0.69*sin(x2)/(1.50 + cos(x1))*dot(x1) + 0.68*cos(0.57*x1)*dot(x3) - 0.20*(if x4 > 0.10 { x3/(1 + powi(x3, 2)) } else { ln(1.60 + 0.80*cos(x3)) }))]
#[forces(
    0,
    0.48*powi(dot(x2), 2),
    1.20*dot(x4)/(1 + powi(x4, 2)),
    p1*dot(x2)*dot(x4)*powi(cos(0.48*x1 + 0.64*x3 - 0.92), 3) + dot(x2)*dot(x2)/(1.06 - 0.25*sin(0.49*x1)) + p1*dot(x1)*dot(x1)*wave(0.50*x4 + 0.89),
)]
#[constraint(row1: 1.41*x4 + 0.20*x1*x2 + 0.27*x3 + 0.19*sin(x2) - 0.13 == 0)]
#[independent(dot(x2), dot(x3), dot(x1))]
#[independent(s1 = (1.50 + 0.26*powi(cos(1.07*x1 + 0.63*x1), 3))*dot(x2) - 0.13*tan(0.86*sin(x1))/2*dot(x4) + 0.41*wave(0.98*x3 - 0.75*x2 + 0.59), s2 = (1.50 - 0.21*1/sqrt(1.50 + powi(x1, 2)))*dot(x3) + 0.17*powi(cos(0.59*x3 + 0.45*x2 + 1.01), 3)*dot(x2) + 0.21*atan2(x3, 2 + cos(x3))/2*dot(x4), s3 = dot(x1) + 0.15*(if x2 < -0.59 { tan(0.43*sin(x2))/2 } else { sin(0.63*x1 - 0.54*x4 - 1.16) })*dot(x2))]
pub struct Random46 {
    #[nominal(0.85)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[inertia(matrix(
    [((1.38 + 0.20*bump(0.60*x1 + 0.78*x1 - 0.63)))*((1.38 + 0.20*bump(0.60*x1 + 0.78*x1 - 0.63))), ((1.38 + 0.20*bump(0.60*x1 + 0.78*x1 - 0.63)))*(0.38*(if x1 <= -0.30 { sin(0.85*t + 0.53) } else { sin(0.81*x1 + 0.64) })), 0],
    [_, (0.38*(if x1 <= -0.30 { sin(0.85*t + 0.53) } else { sin(0.81*x1 + 0.64) }))*(0.38*(if x1 <= -0.30 { sin(0.85*t + 0.53) } else { sin(0.81*x1 + 0.64) })) + ((1.02 - 0.29*x1/(1 + powi(x1, 2))))*((1.02 - 0.29*x1/(1 + powi(x1, 2)))), ((1.02 - 0.29*x1/(1 + powi(x1, 2))))*(0.14*wave(1.04*x1 + 0.74*x3))],
    [_, _, (0.14*wave(1.04*x1 + 0.74*x3))*(0.14*wave(1.04*x1 + 0.74*x3)) + ((1.26 - 0.24*cos(1.12*x1 - 0.25*x2)))*((1.26 - 0.24*cos(1.12*x1 - 0.25*x2)))],
))]
#[forces(
    0.82*dot(x1)/(1 + powi(x1, 2)) - p2*exp(0.20*x1) - 0.53*(if x2 <= 0.21 { sin(0.96*x1 + 0.34*x2) } else { bump(0.44*t - 0.59*x1 + 0.26) }) - p3*dot(x1)*dot(x2)*atan2(x1, 2 + cos(x2))/2,
    p1*1.13,
    p2*1.27 - p2*x3,
)]
#[constraint(row1: 1.71*x2 + 0.26*sin(x2) + exp(0.24*x3)/2 + 0.30*sin(0.91*t) - 0.27 == 0)]
#[constraint(row2: dot(x1) - 0.35*sin(p1*x3 - 0.30)*dot(x3) - 0.26*tan(0.67*sin(x2))/2*dot(x2) - 0.24*sin(p2*x2 - 0.48) == 0)]
#[independent(s1 = dot(x3) + 0.34*ln(1.60 + 0.34*cos(x1))*dot(x2))]
#[output(place = wave(0.87*t + 0.62*x2), power = p2*0.72 + dot(x3)*sqrt(2 + powi(dot(x3), 2)) + p3*dot(x2)*dot(x1)*sin(1.11*x2 + 0.31*t)*cos(0.58*x3) + 1.72*powi(dot(x1), 2), push = cos(1.08*x3 + 0.56*x1)*ddot(x2) + dot(x2)*ddot(x2), pull = (1.00 - 0.35*tan(0.33*sin(x1))/2)*reaction(row1) - push, share = pull/(1.73 + powi(reaction(row1), 2)))]
pub struct Random47 {
    #[nominal(0.95)]
    pub p1: f64,
    #[nominal(0.98)]
    pub p2: f64,
    #[nominal(0.95)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + bump(0.42*x3 - 1.16)*dot(x1),
    v3 = dot(x3) + x3/(1 + powi(x3, 2))*dot(x1),
    v4 = dot(x4) + cos(0.75*x1 - 0.32*x2)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - bump(0.42*x3 - 1.16)*(v1),
    dot(x3) = v3 - x3/(1 + powi(x3, 2))*(v1),
    dot(x4) = v4 - cos(0.75*x1 - 0.32*x2)*(v1),
)]
#[inertia(matrix(
    [((1.05 + 0.29*atan2(x1, 2 + cos(x4))/2))*((1.05 + 0.29*atan2(x1, 2 + cos(x4))/2)), ((1.05 + 0.29*atan2(x1, 2 + cos(x4))/2))*(0.38*powi(cos(0.59*x3 - 0.68*x2 - 0.99), 3)), ((1.05 + 0.29*atan2(x1, 2 + cos(x4))/2))*(0.39*ln(1.60 + 0.89*cos(x3))), ((1.05 + 0.29*atan2(x1, 2 + cos(x4))/2))*(0.34*0.61*sin(x2)/(1.50 + cos(x4)))],
    [_, (0.38*powi(cos(0.59*x3 - 0.68*x2 - 0.99), 3))*(0.38*powi(cos(0.59*x3 - 0.68*x2 - 0.99), 3)) + (1.12)*(1.12), (0.38*powi(cos(0.59*x3 - 0.68*x2 - 0.99), 3))*(0.39*ln(1.60 + 0.89*cos(x3))), (0.38*powi(cos(0.59*x3 - 0.68*x2 - 0.99), 3))*(0.34*0.61*sin(x2)/(1.50 + cos(x4))) + (1.12)*(0.14*wave(0.56*x2 - 0.49*x4))],
    [_, _, (0.39*ln(1.60 + 0.89*cos(x3)))*(0.39*ln(1.60 + 0.89*cos(x3))) + ((1.12 + 0.14*x3/(1 + powi(x3, 2))))*((1.12 + 0.14*x3/(1 + powi(x3, 2)))), (0.39*ln(1.60 + 0.89*cos(x3)))*(0.34*0.61*sin(x2)/(1.50 + cos(x4)))],
    [_, _, _, (0.34*0.61*sin(x2)/(1.50 + cos(x4)))*(0.34*0.61*sin(x2)/(1.50 + cos(x4))) + (0.14*wave(0.56*x2 - 0.49*x4))*(0.14*wave(0.56*x2 - 0.49*x4)) + ((1.20 - 0.12*sin(0.57*x1 - 1.50)))*((1.20 - 0.12*sin(0.57*x1 - 1.50)))],
))]
#[forces(
    0,
    p1*x1,
    p1*v4*v4*(if x4 > 0.56 { x3/(1 + powi(x3, 2)) } else { sin(p1*x2 - 0.44) }) - 1.86*x4/(1 + powi(x4, 2)),
    v4*sqrt(2 + powi(v2, 2)),
)]
#[constraint(height: 1.48*x1 + 0.22*sin(x1) + 0.24*x4*x2 + 0.23*sin(x2) + 0.39 == 0)]
#[constraint(height_rate: 1.48*dot(x1) + 0.22*cos(x1)*dot(x1) + 0.24*(dot(x4)*x2 + x4*dot(x2)) + 0.23*cos(x2)*dot(x2) == 0)]
#[constraint(further: (1.50 - 0.29*(if x2 <= -0.35 { exp(-powi(x4, 2)/2) } else { wave(0.89*x3 - 0.86*x2) }))*v3 + 0.17*sin(0.88*x4 + 1.16)*cos(0.73*x3 + 0.80*x4 + 1.00)*v4 - 0.27*bump(1.03*x2)*v2 + 0.12*bump(1.19*x2 + 0.21*x2)*v1 + 0.46*1/sqrt(1.50 + powi(x3, 2)) == 0)]
#[independent(v2, v4)]
#[output(place = (if x3 <= 0.22 { sin(p1*x2 + 0.42) } else { tan(0.81*sin(x1))/2 }), power = p1*v1*v2*sin(0.66*x1 + 0.71*x1)*cos(1.13*x3 + 0.28*x1 - 0.24) - v3*v3/(1.03 + 0.22*0.74*sin(x1)/(1.50 + cos(x4))) - v4*v3/(1.39 - 0.24*sin(1.03*x1)), push = wave(0.96*x1 + 0.83*x4 - 0.41)*dot(v1) + v1*ddot(x1))]
pub struct Random48 {
    #[nominal(1.21)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[inertia(diag((1.31 - 0.32*ln(1.60 + 0.35*cos(x3))), (1.33 - 0.11*wave(1.01*x1 + 0.26)), (1.05 - 0.13*1/sqrt(1.50 + powi(x1, 2))), 1.00))]
#[forces(
    p1*dot(x1)*dot(x4)*1/sqrt(1.50 + powi(x3, 2)) - 1.62*dot(x2)/(1 + powi(x1, 2)) - 1.96*dot(x1),
    p1*exp(0.20*x4),
    dot(x2)*dot(x2)/(1.01 + 0.29*tan(0.66*sin(x3))/2) - dot(x1)*sqrt(2 + powi(dot(x3), 2)) - dot(x1)*sqrt(2 + powi(dot(x3), 2)) - 1.28*ln(1.60 + 0.73*cos(x1)),
    p1*x4 - p1*x2 - dot(x4)*sqrt(2 + powi(dot(x4), 2)) - 0.38*dot(x1),
)]
#[potential_energy(sin(p1*x4 - 0.70))]
#[constraint(height: 1.90*x4 + 0.17*sin(x4) + 0.33*x2*x3 + 0.29*x3 - 0.58 == 0)]
#[constraint(first: dot(x1) - 0.10*wave(0.68*x1 + 0.56*x2)*dot(x2) - 0.32*(if x1 >= -0.43 { wave(1.06*x1 - 0.74*x2 + 0.36) } else { cos(0.56*x2) }) == 0)]
#[constraint(second: 1.90*dot(x4) + 0.17*cos(x4)*dot(x4) + 0.33*(dot(x2)*x3 + x2*dot(x3)) + 0.29*dot(x3) - 0.50*sin(0.80*x2)*cos(0.63*x3)*(dot(x1) - 0.10*wave(0.68*x1 + 0.56*x2)*dot(x2) - 0.32*(if x1 >= -0.43 { wave(1.06*x1 - 0.74*x2 + 0.36) } else { cos(0.56*x2) })) == 0)]
#[independent(s1 = 1.94*dot(x3) - 0.26*bump(0.92*x3 - 0.23*x4)*dot(x4), s2 = 1.19*dot(x2) + 0.11*cos(0.52*x1)*dot(x3) - 0.54*tan(0.40*sin(x2))/2)]
pub struct Random49 {
    #[nominal(0.52)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    dot(x1) = 1.02*v1 + 0.59*x2/(1 + powi(x2, 2)),
    dot(x2) = 1.14*v2 + 0.26*powi(cos(0.42*x3 - 0.29), 3)*v4 + 0.51*sin(0.54*x2 - 0.20*x4)*cos(0.48*x1),
    dot(x3) = v3 - 0.29*0.52*sin(x1)/(1.50 + cos(x1)),
    dot(x4) = 1.15*v4 - 0.38*1/sqrt(1.50 + powi(x3, 2))*v1 + 0.20*sin(1.11*x4 - 0.48*x4),
)]
#[inertia(diag((1.32 + 0.22*0.84*sin(x4)/(1.50 + cos(x1))), (1.04 + 0.27*1/sqrt(1.50 + powi(x4, 2))), (1.07 - 0.15*0.78*sin(x1)/(1.50 + cos(x2))), (1.05 + 0.21*sin(1.17*x1 + 0.83*x1 + 0.44))))]
#[forces(
    p2*x3 + 1.71*v2,
    p1*1.98 + p2*exp(0.20*x4) + 1.36*v3,
    1.95*v3 + p1*exp(0.20*x4) + 0.93*v3/(1 + powi(x1, 2)) + p1*1.18,
    v2*v3/(1.40 - 0.12*sin(0.79*x1 + 0.56*x2 - 0.12)) + 1.68*v3/(1 + powi(x2, 2)) + 1.58*v3 + 0.73*v2/(1 + powi(x3, 2)),
)]
#[potential_energy((if x4 < 0.21 { exp(-powi(x2, 2)/2) } else { powi(cos(0.88*x1 + 0.64*x1), 3) }))]
#[configuration(x2 = 1.38*wave(0.85*x3))]
#[output(place = (if x2 >= 0.14 { x1/(1 + powi(x1, 2)) } else { bump(0.98*x3 + 0.87*x2 + 1.40) }), power = p2*v1*v2*(if x1 >= 0.25 { powi(cos(0.74*x2 + 0.72*x4), 3) } else { bump(1.17*x3) }), push = exp(-powi(x1, 2)/2)*dot(v4) + v1*ddot(x1))]
pub struct Random50 {
    #[nominal(1.15)]
    pub p1: f64,
    #[nominal(0.92)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[inputs(tau)]
#[kinetic_energy(powi((1.11)*dot(x1) + (0.10*cos(0.98*x1))*dot(x2) + (0.40*(if x3 <= -0.06 { x1/(1 + powi(x1, 2)) } else { atan2(x2, 2 + cos(x3))/2 }))*dot(x3), 2)/2 + powi(((1.35 + 0.21*x2/(1 + powi(x2, 2))))*dot(x2) + (0.18*tan(0.80*sin(x2))/2)*dot(x3), 2)/2 + powi(((1.02 + 0.27*ln(1.60 + 0.45*cos(x2))))*dot(x3), 2)/2)]
#[forces(
    p1*x1 + dot(x2)*dot(x2)/1.15 + dot(x3)*sqrt(2 + powi(dot(x3), 2)) + 0.77*dot(x3)/(1 + powi(x1, 2)),
    p1*x1 + dot(x1)*sqrt(2 + powi(dot(x1), 2)),
    1.73*ln(1.60 + 0.39*cos(x1)) + 0.82*powi(cos(0.88*x3 - 0.55), 3) + 0.70*dot(x3)/(1 + powi(x2, 2)) + tau*1.16,
)]
#[configuration(of(q1), x3 = 1.25*q1, x2 = tan(0.72*sin(q1))/2, x1 = tan(0.56*sin(q1))/2)]
#[constraint(held_x2: x2 - (tan(0.72*sin((x3/1.25)))/2) == 0)]
#[constraint(held_x1: x1 - (tan(0.56*sin((x3/1.25)))/2) == 0)]
#[output(place = wave(0.99*x2 - 0.32*x2 - 1.46), power = tau*1.26, push = sin(1.02*x1)*ddot(x1) + dot(x1)*ddot(x1), pull = (1.18 - 0.24*exp(-powi(x3, 2)/2))*reaction(held_x2) - push, share = pull/(1.62 + powi(reaction(held_x2), 2)))]
pub struct Random51 {
    #[nominal(0.66)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[inertia(diag(1.15, 1.12, (1.01 - 0.13*1/sqrt(1.50 + powi(x3, 2))), (1.40 + 0.15*sin(0.68*t))))]
#[forces(
    p1*1.54 + 1.28*powi(dot(x2), 2) + 1.53*powi(dot(x3), 2),
    p1*exp(0.20*x3),
    0.74*dot(x3)/(1 + powi(x3, 2)) - dot(x1)*dot(x2)/(1.11 - 0.13*(if t >= 0.40 { bump(0.43*x2) } else { cos(0.65*t) })),
    0,
)]
#[configuration(x3 = 0.78*1/sqrt(1.50 + powi(x2, 2)), x4 = 1.05*bump(0.73*x1))]
#[constraint(rolling: 1.00*dot(x1) + 0.16*tan(0.86*sin(x1))/2*dot(x2) + 0.28*1/sqrt(1.50 + powi(x1, 2)) == 0)]
#[output(place = powi(cos(0.70*x3 - 0.70*x2), 3), power = dot(x2)*dot(x3)/1.32 - dot(x1)*sqrt(2 + powi(dot(x1), 2)) - 0.72*dot(x1), push = x2/(1 + powi(x2, 2))*ddot(x3) + dot(x3)*ddot(x3), pull = (1.36 + 0.29*wave(0.96*t - 0.73))*reaction(rolling) - push, share = pull/(1.89 + powi(reaction(rolling), 2)))]
pub struct Random52 {
    #[nominal(0.68)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[inertia(diag(1.09, (1.05 + 0.17*sin(1.10*x4)*cos(0.72*x2)), (1.05 + 0.19*sin(0.62*x3 - 0.43*x2)), (1.38 - 0.22*sin(0.99*t + 0.81*x1))))]
#[forces(
    dot(x1)*dot(x3)/(1.13 + 0.12*(if x4 <= -0.04 { powi(cos(1.18*x4), 3) } else { bump(1.18*x1 - 0.63*x4 + 1.09) })) - p1*1.19 - p1*dot(x1)*dot(x3)*exp(-powi(t, 2)/2) - dot(x3)*sqrt(2 + powi(dot(x2), 2)),
    1.64*1/sqrt(1.50 + powi(x2, 2)) - 1.90*dot(x1) - dot(x3)*sqrt(2 + powi(dot(x2), 2)),
    dot(x1)*sqrt(2 + powi(dot(x1), 2)) - 0.87*(if x3 <= -0.28 { bump(0.75*t - 0.50*x1) } else { cos(0.51*x3 - 0.35*x3 - 1.27) }) - p1*x2,
    0.51*dot(x2)/(1 + powi(t, 2)),
)]
#[potential_energy(bump(0.87*x3 - 0.71*x1))]
#[constraint(row1: dot(x3) + 0*dot(x4) + 0.63*bump(0.76*x2 + 0.18)*dot(x1) + 0.60*atan2(x2, 2 + cos(x2))/2*dot(x2) == 0)]
#[complement(
    w1 = [0, 0, -1.35*(0), 1.35],
    w2 = [(1.13 - 0.27*(if t < -0.16 { sin(p1*x4 + 0.57) } else { bump(0.79*x3 - 0.42) })), 0, -(1.13 - 0.27*(if t < -0.16 { sin(p1*x4 + 0.57) } else { bump(0.79*x3 - 0.42) }))*(0.63*bump(0.76*x2 + 0.18)), 0],
    w3 = [0, 1.24, -1.24*(0.60*atan2(x2, 2 + cos(x2))/2), 0],
)]
#[output(place = wave(0.47*x2), power = 1.27*dot(x4)/(1 + powi(x2, 2)) - 1.36*dot(x1) - p1*x1, push = ln(1.60 + 0.57*cos(x3))*ddot(x4) + dot(x2)*ddot(x2), pull = (1.24 + 0.30*cos(0.84*t + 0.89*x3 - 0.47))*reaction(row1) - push, share = pull/(1.39 + powi(reaction(row1), 2)))]
pub struct Random53 {
    #[nominal(0.57)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[inputs(tau)]
#[define(l11 = (1.35 - 0.22*tan(0.80*sin(x3))/2), l21 = 0.19*powi(cos(0.86*x3 + 0.77*x4), 3), l22 = (1.38 - 0.15*wave(1.08*x3 + 0.54*x2)), l32 = 0.29*ln(1.60 + 0.99*cos(x2)), l33 = (1.13 + 0.13*(if x4 >= 0.53 { sin(1.00*x1 + 0.34*x2) } else { cos(0.53*x1 + 0.89*x1) })), l41 = 0.12*tan(0.44*sin(x3))/2, l42 = 0.29*cos(0.74*x1 - 0.44*x1), l43 = 0.25*cos(0.78*x4 + 0.59*x3), l44 = (1.32 + 0.11*powi(cos(0.84*x1 + 1.29), 3)))]
#[kinetic_energy(powi(l11*dot(x1) + l21*dot(x2) + l41*dot(x4), 2)/2 + powi(l22*dot(x2) + l32*dot(x3) + l42*dot(x4), 2)/2 + powi(l33*dot(x3) + l43*dot(x4), 2)/2 + powi(l44*dot(x4), 2)/2 - 0.52*(if x4 < -0.54 { sin(1.19*x4 - 0.89*x2 + 0.87)*cos(1.19*x4 - 0.35*x3) } else { cos(1.00*x1) }))]
#[forces(
    1.50*bump(0.56*x1 + 0.35),
    1.84*dot(x2) + p1*dot(x2)*dot(x1)*wave(0.54*x2 - 0.37*x1) + 1.26*powi(dot(x3), 2),
    p1*exp(0.20*x4) - dot(x2)*sqrt(2 + powi(dot(x2), 2)),
    0.41*dot(x1)/(1 + powi(x3, 2)) - dot(x2)*sqrt(2 + powi(dot(x4), 2)) - p1*exp(0.20*x2),
)]
#[constraint(row1: 1.44*x3 + 0.14*x4 + 0.46 == 0)]
#[constraint(row2: 1.63*x1 + 0.27*sin(x1) + exp(0.36*x4)/2 + 0.31*sin(x3) + 0.37 == 0)]
#[constraint(row3: 1.05*dot(x2) + 0.21*sin(p1*x1 + 0.98)*dot(x4) - 0.32*1.00*sin(x4)/(1.50 + cos(x2))*dot(x3) - 0.28*tan(0.48*sin(x1))/2*dot(x1) == 0)]
#[output(place = cos(0.83*x3 - 0.56*x1), power = p1*dot(x4)*dot(x3)*cos(1.12*x1 - 0.68), push = sin(0.55*x4)*cos(1.05*x3 - 0.11)*ddot(x1) + dot(x2)*ddot(x2), pull = (1.01 + 0.30*x3/(1 + powi(x3, 2)))*reaction(row3) - push, share = pull/(1.92 + powi(reaction(row3), 2)))]
pub struct Random54 {
    #[nominal(1.03)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    v1 = (1.18 - 0.22*powi(cos(0.78*x3), 3))*dot(x1) + 0.24*bump(0.64*x1)*dot(x2),
    v2 = (1.07 + 0.18*x2/(1 + powi(x2, 2)))*dot(x2) - 0.22*(if x1 < -0.31 { sin(p2*x1 + 0.75) } else { sin(p1*x2 - 0.98) })*dot(x3),
    v3 = (1.29 - 0.14*bump(0.85*x1))*dot(x3),
)]
#[kinetic_energy((1.39 + 0.20*cos(0.72*x2 - 0.53*x3))*powi(v1, 2)/2 + (1.18 + 0.24*(if x1 < -0.07 { sin(1.09*x1 + 0.35*x1 + 1.12) } else { sin(p1*x1 + 0.79) }))*powi(v2, 2)/2 + (1.03 + 0.11*cos(0.62*x1 + 0.67*x2))*powi(v3, 2)/2 + 0.49*cos(0.67*x3 + 1.16)*v1 + 0.63*(if x1 > -0.27 { tan(0.44*sin(x2))/2 } else { x2/(1 + powi(x2, 2)) }))]
#[forces(
    0.63*v1/(1 + powi(x1, 2)) - v3*sqrt(2 + powi(v3, 2)) - 1.96*v1,
    p2*exp(0.20*x3) - 0.86*wave(0.90*x2 + 0.29*x2),
    p1*exp(0.20*x3) - tau*1.00 - 1.93*sin(1.05*x1)*cos(1.16*x2 - 0.84*x1),
)]
#[potential_energy(exp(-powi(x2, 2)/2))]
#[constraint(row1: 1.28*x2 + 0.31 == 0)]
#[constraint(row2: 1.59*x1 + 0.27*x2 - 0.31 == 0)]
#[constraint(row3: v3 + 0.24*1/sqrt(1.50 + powi(x2, 2))*v2 == 0)]
pub struct Random55 {
    #[nominal(0.77)]
    pub p1: f64,
    #[nominal(0.75)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.34 + 0.17*x1/(1 + powi(x1, 2))), (1.22 - 0.15*sin(p1*x3 - 0.98)), (1.21 - 0.13*tan(0.85*sin(x3))/2)))]
#[forces(
    p1*dot(x2)*dot(x1)*bump(0.70*x3 + 1.45),
    1.18*sin(0.83*x2 - 1.48)*cos(1.02*x3 + 0.66*t) + dot(x3)*dot(x2)/1.25 + p1*dot(x2)*dot(x2)*bump(0.82*x1 - 0.84*x1 - 0.99) + p1*x3,
    p1*t - p1*exp(0.20*x1) - p1*x1,
)]
#[constraint(row1: 1.94*dot(x3) + 0.19*sin(dot(x3) + sin(1.14*x1 + 0.27*x3)*dot(x3)) + 0.46*sin(1.06*t)*cos(1.07*x1 - 0.67) == 0)]
#[constraint(row2: powi(dot(x2), 2) - 0.10*powi(dot(x3), 2) - (2 - 0.10*sin(1.03*x1 + 0.26*t - 1.02)) == 0)]
#[constraint(row3: 1.12*dot(x1) - 0.23*dot(x1)*dot(x3)*cos(1.07*x1 - 0.89*x1 - 0.96) - 0.22*sin(0.71*x3 + 0.39*x1)*cos(0.64*x2 + 0.84*x2) == 0)]
#[independent(dot(x1), dot(x2), dot(x3))]
pub struct Random56 {
    #[nominal(0.94)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[kinetic_energy(powi((1.11)*dot(x1) + (0.31*cos(1.10*x2 - 0.60*x1))*dot(x2), 2)/2 + powi(((1.27 - 0.27*(if x1 > 0.46 { atan2(x1, 2 + cos(x3))/2 } else { 0.35*sin(x1)/(1.50 + cos(x1)) })))*dot(x2), 2)/2 + powi((1.28)*dot(x3), 2)/2 + 0.34*bump(1.04*x2 - 1.26)*dot(x2) - 0.22*sin(0.74*x1))]
#[forces(
    dot(x2)*sqrt(2 + powi(dot(x1), 2)) - 1.41*dot(x1)/(1 + powi(x3, 2)) - 0.78*(if x2 <= 0.59 { sin(0.49*x1 - 0.65) } else { wave(1.10*x1 + 0.79*x3 + 0.20) }),
    p1*exp(0.20*x1) - p2*x1 - p2*x2 - dot(x2)*sqrt(2 + powi(dot(x3), 2)),
    p2*exp(0.20*x3) + 1.91*dot(x2),
)]
#[potential_energy(0.87*sin(x1)/(1.50 + cos(x3)))]
#[constraint(row1: ddot(x1) + 0.20*atan2(x2, 2 + cos(x1))/2*ddot(x3) - 0.28*bump(0.67*x3)*ddot(x2) - 0.79*dot(x3)*dot(x3)*bump(1.14*x1) == 0)]
#[independent(dot(x2), dot(x3), dot(x1))]
#[output(place = ln(1.60 + 0.46*cos(x1)), power = dot(x1)*sqrt(2 + powi(dot(x2), 2)), push = 0.96*sin(x2)/(1.50 + cos(x2))*ddot(x1) + dot(x2)*ddot(x2), pull = 1.34*reaction(row1) - push, share = pull/(1.03 + powi(reaction(row1), 2)))]
pub struct Random57 {
    #[nominal(0.95)]
    pub p1: f64,
    #[nominal(0.53)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(matrix(
    [((1.27 - 0.30*0.87*sin(x2)/(1.50 + cos(t))))*((1.27 - 0.30*0.87*sin(x2)/(1.50 + cos(t)))), ((1.27 - 0.30*0.87*sin(x2)/(1.50 + cos(t))))*(0.26*exp(-powi(x3, 2)/2)), ((1.27 - 0.30*0.87*sin(x2)/(1.50 + cos(t))))*(0.14*sin(0.55*t)), ((1.27 - 0.30*0.87*sin(x2)/(1.50 + cos(t))))*(0.29*cos(0.76*x2 + 1.19))],
    [_, (0.26*exp(-powi(x3, 2)/2))*(0.26*exp(-powi(x3, 2)/2)) + (1.29)*(1.29), (0.26*exp(-powi(x3, 2)/2))*(0.14*sin(0.55*t)) + (1.29)*(0.36*(if t > 0.19 { 0.65*sin(x3)/(1.50 + cos(t)) } else { x2/(1 + powi(x2, 2)) })), (0.26*exp(-powi(x3, 2)/2))*(0.29*cos(0.76*x2 + 1.19)) + (1.29)*(0.14*tan(0.82*sin(x2))/2)],
    [_, _, (0.14*sin(0.55*t))*(0.14*sin(0.55*t)) + (0.36*(if t > 0.19 { 0.65*sin(x3)/(1.50 + cos(t)) } else { x2/(1 + powi(x2, 2)) }))*(0.36*(if t > 0.19 { 0.65*sin(x3)/(1.50 + cos(t)) } else { x2/(1 + powi(x2, 2)) })) + ((1.14 - 0.31*(if x1 >= 0.16 { 1/sqrt(1.50 + powi(x2, 2)) } else { sin(0.84*x3 + 0.26*x1 + 0.21) })))*((1.14 - 0.31*(if x1 >= 0.16 { 1/sqrt(1.50 + powi(x2, 2)) } else { sin(0.84*x3 + 0.26*x1 + 0.21) }))), (0.14*sin(0.55*t))*(0.29*cos(0.76*x2 + 1.19)) + (0.36*(if t > 0.19 { 0.65*sin(x3)/(1.50 + cos(t)) } else { x2/(1 + powi(x2, 2)) }))*(0.14*tan(0.82*sin(x2))/2) + ((1.14 - 0.31*(if x1 >= 0.16 { 1/sqrt(1.50 + powi(x2, 2)) } else { sin(0.84*x3 + 0.26*x1 + 0.21) })))*(0.11*powi(cos(1.06*x2 + 0.37*x1), 3))],
    [_, _, _, (0.29*cos(0.76*x2 + 1.19))*(0.29*cos(0.76*x2 + 1.19)) + (0.14*tan(0.82*sin(x2))/2)*(0.14*tan(0.82*sin(x2))/2) + (0.11*powi(cos(1.06*x2 + 0.37*x1), 3))*(0.11*powi(cos(1.06*x2 + 0.37*x1), 3)) + (1.23)*(1.23)],
))]
#[forces(
    0,
    p3*dot(x1)*dot(x2)*ln(1.60 + 0.54*cos(x1)) - 0.78*dot(x1)/(1 + powi(x1, 2)) - 1.82*dot(x4),
    1.64*dot(x2) - dot(x2)*dot(x4)/(1.09 - 0.17*(if x4 > -0.36 { cos(0.91*t - 0.70*x1) } else { sin(0.85*t)*cos(0.81*x1 + 0.72*x3) })) - dot(x4)*sqrt(2 + powi(dot(x3), 2)) - 0.38*powi(dot(x4), 2),
    p3*exp(0.20*x4) + 1.29*powi(dot(x4), 2),
)]
#[constraint(row1: 1.37*x4 + exp(0.13*x1)/2 + 0.30*sin(1.34*t) + 0.25 == 0)]
#[constraint(row2: 1.79*x2 + 0.14*x1*x1 + 0.20*x4*x1 + 0.30*sin(1.27*t) - 0.65 == 0)]
#[constraint(row3: 1.48*dot(x3) - 0.22*powi(cos(0.89*x4), 3)*dot(x2)*dot(x2) + 0.58*exp(-powi(x3, 2)/2) == 0)]
pub struct Random58 {
    #[nominal(1.35)]
    pub p1: f64,
    #[nominal(0.64)]
    pub p2: f64,
    #[nominal(1.34)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3, x4)]
#[kinetic_energy(powi(((1.04 - 0.21*tan(0.77*sin(x4))/2))*dot(x1) + (0.37*(if x3 > 0.15 { 1/sqrt(1.50 + powi(x1, 2)) } else { sin(p1*x1 + 0.32) }))*dot(x2) + (0.11*atan2(x3, 2 + cos(x3))/2)*dot(x3) + (0.23*1/sqrt(1.50 + powi(x4, 2)))*dot(x4), 2)/2 + powi(((1.24 - 0.10*sin(1.08*x4 - 0.68*x1)*cos(0.87*x1 - 0.68)))*dot(x2) + (0.33*wave(0.49*x1))*dot(x4), 2)/2 + powi(((1.39 - 0.19*1/sqrt(1.50 + powi(x2, 2))))*dot(x3), 2)/2 + powi(((1.20 + 0.27*x4/(1 + powi(x4, 2))))*dot(x4), 2)/2 - 0.69*sin(1.15*x1)*dot(x1))]
#[forces(
    0,
    p1*x3 - dot(x3)*sqrt(2 + powi(dot(x2), 2)),
    1.21*dot(x3)/(1 + powi(x3, 2)) + p1*dot(x4)*dot(x4)*cos(0.61*x2) + p1*x4,
    1.82*powi(dot(x1), 2) + 1.19*powi(dot(x3), 2),
)]
#[constraint(row1: 1.08*dot(x4) == 0)]
#[constraint(row2: 1.67*dot(x2) + 0.30*ln(1.60 + 0.91*cos(x1))*dot(x4) - 0.53*1/sqrt(1.50 + powi(x4, 2)) == 0)]
#[constraint(row3: (1.50 - 0.17*1/sqrt(1.50 + powi(x4, 2)))*dot(x1) - 0.19*x2/(1 + powi(x2, 2))*dot(x4) - 0.13*(if x4 >= -0.56 { atan2(x1, 2 + cos(x2))/2 } else { sin(p1*x4 + 0.87) })*dot(x2) == 0)]
#[constraint(row4: ddot(x3) + 0.12*powi(cos(0.54*x3), 3)*ddot(x4) - 0.12*sin(1.19*x3 + 0.72*x2 + 1.11)*cos(0.80*x4 + 1.02)*ddot(x2) + 0.57*dot(x1)/sqrt(1.20 + powi(dot(x2), 2)) == 0)]
#[independent(dot(x3))]
#[independent(s1 = dot(x3) + 0.27*sin(1.02*x3)*dot(x4) - 0.57*cos(0.68*x2 - 1.31))]
pub struct Random59 {
    #[nominal(1.44)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + cos(1.00*x3 + 0.63*x1)*dot(x1),
    v3 = dot(x3) + ln(1.60 + 0.41*cos(x1))*dot(x2),
    v4 = dot(x4) + sin(0.68*x1 + 0.47)*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - cos(1.00*x3 + 0.63*x1)*(v1),
    dot(x3) = v3 - ln(1.60 + 0.41*cos(x1))*(v2 - cos(1.00*x3 + 0.63*x1)*(v1)),
    dot(x4) = v4 - sin(0.68*x1 + 0.47)*(v2 - cos(1.00*x3 + 0.63*x1)*(v1)),
)]
#[inertia(diag((1.25 - 0.24*cos(0.48*x4 - 1.46)), 1.16, 1.08, (1.11 - 0.31*bump(0.78*x4))))]
#[forces(
    1.08*tan(0.51*sin(x2))/2,
    1.88*v3,
    0.80*powi(v1, 2) + p1*x3 + 2.00*v2/(1 + powi(x1, 2)) + 1.64*v1,
    p1*v3*v1*tan(0.54*sin(x1))/2 - 1.45*x3/(1 + powi(x3, 2)) - p2*v1*v3*bump(0.52*x2),
)]
#[constraint(row1: 1.89*x3 + 0.23 == 0)]
#[constraint(row2: 1.12*v1 - 0.14*tan(0.95*sin(x2))/2*v3 - 0.42*(if x4 >= -0.01 { cos(0.60*x1 - 0.45*x1) } else { exp(-powi(x3, 2)/2) }) == 0)]
#[constraint(row3: 1.29*v2 - 0.21*v2*v3*cos(0.63*x2 + 0.54*x4) + 0.25*tan(0.98*sin(x4))/2 == 0)]
#[constraint(row4: dot(v4) + 0.10*1/sqrt(1.50 + powi(x3, 2))*dot(v3) - 0.16*(if x2 <= -0.23 { ln(1.60 + 0.37*cos(x1)) } else { bump(1.05*x2 - 0.65*x4) })*dot(v1) - 0.64*v4*v1*exp(-powi(x3, 2)/2) == 0)]
#[independent(v4, v2)]
#[independent(s1 = 1.80*v4 + 0.28*wave(0.56*x2)*v3, s2 = v2 - 0.34*(if x2 <= 0.54 { wave(1.00*x4 + 0.42*x4) } else { 1/sqrt(1.50 + powi(x2, 2)) })*v4)]
#[output(place = sin(1.18*x2), power = 1.89*v3 - v1*sqrt(2 + powi(v2, 2)) - 0.78*powi(v3, 2), push = 1/sqrt(1.50 + powi(x2, 2))*dot(v4) + v3*ddot(x3), pull = (1.03 + 0.29*ln(1.60 + 0.71*cos(x4)))*reaction(row4) - push, share = pull/(1.79 + powi(reaction(row4), 2)))]
pub struct Random60 {
    #[nominal(0.62)]
    pub p1: f64,
    #[nominal(0.77)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = v1 - 0.37*(if x1 <= 0.34 { 1/sqrt(1.50 + powi(x1, 2)) } else { wave(0.48*x3 + 0.89*x1 + 0.44) })*v2 + 0.18*sin(0.66*x1 - 0.52),
    dot(x2) = (1.24 + 0.18*1/sqrt(1.50 + powi(x1, 2)))*v2 + 0.28*cos(1.06*x1),
    dot(x3) = 1.39*v3 - 0.32*exp(-powi(x3, 2)/2)*v1 + 0.53*wave(0.41*x2 - 0.83*x1),
)]
#[inertia(matrix(
    [(1.19)*(1.19), (1.19)*(0.11*powi(cos(0.77*x2), 3)), (1.19)*(0.37*sin(0.68*x1))],
    [_, (0.11*powi(cos(0.77*x2), 3))*(0.11*powi(cos(0.77*x2), 3)) + ((1.03 + 0.26*ln(1.60 + 0.42*cos(x2))))*((1.03 + 0.26*ln(1.60 + 0.42*cos(x2)))), (0.11*powi(cos(0.77*x2), 3))*(0.37*sin(0.68*x1)) + ((1.03 + 0.26*ln(1.60 + 0.42*cos(x2))))*(0.28*tan(0.52*sin(x1))/2)],
    [_, _, (0.37*sin(0.68*x1))*(0.37*sin(0.68*x1)) + (0.28*tan(0.52*sin(x1))/2)*(0.28*tan(0.52*sin(x1))/2) + ((1.36 - 0.11*cos(1.15*x2)))*((1.36 - 0.11*cos(1.15*x2)))],
))]
#[forces(
    0.78*v2/(1 + powi(x3, 2)) + 0.93*powi(v1, 2),
    1.64*powi(v3, 2) - p2*v3*v1*tan(0.87*sin(x2))/2 - 0.86*v3,
    0.50*v3 + v3*sqrt(2 + powi(v1, 2)),
)]
#[potential_energy(sin(p2*x3 - 0.10))]
#[constraint(row1: ddot(x1) - 0.25*x1/(1 + powi(x1, 2))*dot(v2) + 0.78*v3 + 0.78*exp(-powi(x3, 2)/2) == 0)]
#[constraint(row2: 1.52*dot(v3) + 0.14*(if x3 < -0.17 { sin(0.52*x2)*cos(0.87*x1) } else { exp(-powi(x1, 2)/2) })*dot(v2) - 0.18*sin(1.09*x2)*cos(1.15*x1 - 0.78*x2)*dot(v1) - 0.36*v1*v2*sin(0.80*x3 + 0.65*x3 - 0.55) == 0)]
#[constraint(again1: 1.33*(1.52*dot(v3) + 0.14*(if x3 < -0.17 { sin(0.52*x2)*cos(0.87*x1) } else { exp(-powi(x1, 2)/2) })*dot(v2) - 0.18*sin(1.09*x2)*cos(1.15*x1 - 0.78*x2)*dot(v1) - 0.36*v1*v2*sin(0.80*x3 + 0.65*x3 - 0.55)) == 0, redundant)]
#[constraint(again2: (1.14 - 0.26*0.58*sin(x1)/(1.50 + cos(x3)))*(1.52*dot(v3) + 0.14*(if x3 < -0.17 { sin(0.52*x2)*cos(0.87*x1) } else { exp(-powi(x1, 2)/2) })*dot(v2) - 0.18*sin(1.09*x2)*cos(1.15*x1 - 0.78*x2)*dot(v1) - 0.36*v1*v2*sin(0.80*x3 + 0.65*x3 - 0.55)) + 1.20*(ddot(x1) - 0.25*x1/(1 + powi(x1, 2))*dot(v2) + 0.78*v3 + 0.78*exp(-powi(x3, 2)/2)) == 0, redundant)]
pub struct Random61 {
    #[nominal(1.42)]
    pub p1: f64,
    #[nominal(1.09)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = (1.37 - 0.28*sin(0.55*x3))*v1 - 0.13*cos(0.92*x3 - 0.65*x3 + 0.13)*v3 - 0.52*tan(0.49*sin(x2))/2,
    dot(x2) = (1.14 + 0.23*tan(0.58*sin(x1))/2)*v2 + 0.33*atan2(x2, 2 + cos(x3))/2,
    dot(x3) = (1.24 + 0.13*1/sqrt(1.50 + powi(x3, 2)))*v3 - 0.30*ln(1.60 + 0.34*cos(x4))*v4 - 0.45*wave(0.74*x4 - 0.38*x1),
    dot(x4) = v4 - 0.34*sin(0.92*x2)*v2 + 0.20*sin(p1*x1 + 0.30),
)]
#[inertia(diag((1.12 - 0.12*tan(0.33*sin(x1))/2), (1.32 - 0.27*0.52*sin(x4)/(1.50 + cos(x2))), (1.12 + 0.15*tan(0.66*sin(x1))/2), (1.40 + 0.33*(if x2 > 0.46 { x2/(1 + powi(x2, 2)) } else { cos(0.60*x3 + 0.30*x3) }))))]
#[forces(
    p2*exp(0.20*x2),
    p2*v1*v1*sin(p2*x4 - 0.93) - p2*v2*v1*cos(1.06*x1 + 0.43*x3 - 1.48) - p1*v4*v2*1/sqrt(1.50 + powi(x3, 2)),
    1.86*v3 + 1.08*v1/(1 + powi(x4, 2)),
    p2*v4*v4*exp(-powi(x4, 2)/2),
)]
#[constraint(row1: 1.71*x4 + 0.28*sin(x4) + 0.26*x1*x1 + 0.26*sin(x2) + 0.22*powi(x3, 2)/2 - 0.15 == 0)]
#[independent(s1 = 1.81*v3 + 0.27*sin(0.88*x3 + 1.15)*v4, s2 = (1.50 + 0.11*ln(1.60 + 0.30*cos(x2)))*v2 + 0.31*tan(0.64*sin(x3))/2*v3, v1)]
#[output(place = ln(1.60 + 0.90*cos(x3)), power = 0.96*powi(v1, 2) + v1*sqrt(2 + powi(v3, 2)) + p2*exp(0.20*x1), push = sin(0.94*x4)*dot(v2) + v3*ddot(x3), pull = 1.00*reaction(row1) - push, share = pull/(1.56 + powi(reaction(row1), 2)))]
pub struct Random62 {
    #[nominal(0.80)]
    pub p1: f64,
    #[nominal(1.26)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[define(l11 = (1.08 - 0.34*sin(0.92*x2)), l22 = (1.07 + 0.32*exp(-powi(x3, 2)/2)), l32 = 0.28*(if x2 > 0.21 { sin(0.99*x2 - 0.55*x3) } else { sin(0.60*x2 + 0.17) }), l33 = (1.27 - 0.21*cos(0.63*x2)))]
#[inertia(matrix(
    [l11*l11, 0, 0],
    [_, l22*l22, l22*l32],
    [_, _, l32*l32 + l33*l33],
))]
#[forces(
    p1*exp(0.20*x3),
    0.84*dot(x3) + dot(x2)*dot(x3)/(1.04 - 0.33*sin(0.80*x1 - 0.43)),
    p1*exp(0.20*x3) + 1.75*powi(dot(x1), 2) + dot(x1)*sqrt(2 + powi(dot(x2), 2)) + p1*exp(0.20*x3),
)]
#[potential_energy(exp(-powi(x3, 2)/2))]
#[configuration(x1 = 0.52*sin(1.18*x2 - 0.21*x2 + 0.70))]
#[constraint(held_x1: x1 - (0.52*sin(1.18*x2 - 0.21*x2 + 0.70)) == 0)]
#[constraint(bound: 1.53*dot(x2) - 0.17*sqrt(1.50 + powi(dot(x3), 2) + powi(dot(x1), 2)) + 0.20*x1/(1 + powi(x1, 2)) == 0)]
#[output(place = atan2(x1, 2 + cos(x3))/2, power = 0.81*1/sqrt(1.50 + powi(x1, 2)) + 1.69*powi(dot(x3), 2) + dot(x2)*sqrt(2 + powi(dot(x2), 2)), push = 0.34*sin(x1)/(1.50 + cos(x2))*ddot(x1) + dot(x1)*ddot(x1), pull = (1.14 + 0.25*atan2(x1, 2 + cos(x1))/2)*reaction(bound) - push, share = pull/(1.82 + powi(reaction(bound), 2)))]
pub struct Random63 {
    #[nominal(1.20)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[define(l11 = (1.25 + 0.22*cos(0.96*x3 + 0.56*x2 - 0.94)), l21 = 0.28*(if x1 > 0.31 { wave(1.06*x1 - 0.81*x3 + 0.47) } else { exp(-powi(x3, 2)/2) }), l22 = (1.03 + 0.33*powi(cos(1.06*x2), 3)), l32 = 0.21*(if x3 > -0.01 { exp(-powi(x3, 2)/2) } else { sin(0.89*x2 + 0.76*x2)*cos(0.94*x1) }), l33 = 1.22)]
#[inertia(matrix(
    [l11*l11, l11*l21, 0],
    [_, l21*l21 + l22*l22, l22*l32],
    [_, _, l32*l32 + l33*l33],
))]
#[forces(
    p2*0.88 + p2*1.93 + 0.76*dot(x3)/(1 + powi(x1, 2)) + 1.83*dot(x3),
    p1*exp(0.20*x2) + p2*1.64 + 1.85*dot(x3) + 1.55*powi(dot(x2), 2),
    0.45*dot(x2),
)]
#[potential_energy(wave(1.18*x3 + 0.58*x2))]
#[constraint(row1: (1.57 + 0.20*sin(1.10*x2 - 0.66*x3))*dot(x1) + 0.83*dot(x2) - 0.22*sin(0.75*x2 - 0.70)*cos(1.05*x3)*dot(x3) + 0.21*ln(1.60 + 0.43*cos(x2)) == 0)]
#[independent(dot(x2), dot(x3))]
#[independent(dot(x1), dot(x3))]
#[output(place = 0.93*sin(x3)/(1.50 + cos(x1)), power = p2*1.03 + dot(x3)*dot(x2)/(1.07 - 0.22*tan(0.93*sin(x2))/2) + 0.63*atan2(x1, 2 + cos(x2))/2, push = 1/sqrt(1.50 + powi(x2, 2))*ddot(x1) + dot(x2)*ddot(x2), pull = (1.18 - 0.33*powi(cos(0.94*x2), 3))*reaction(row1) - push, share = pull/(1.46 + powi(reaction(row1), 2)))]
pub struct Random64 {
    #[nominal(0.71)]
    pub p1: f64,
    #[nominal(1.44)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 3)]
#[coordinates(x[n])]
#[speeds(v[n])]
#[kinematics(
    dot(x[i]) = 1.14*k[i]*v[i] + 0.24*s[(i + 1) % n]*v[(i + 1) % n] + 0.36*s[i] for i in 0..n,
)]
#[define(s[i] = sin(0.56*x[i] + i/2 - 0.28) for i in 0..n)]
#[define(r[0] = s[0]/2, r[i] = (r[i - 1] + s[i])/2 for i in 1..n)]
#[kinetic_energy(
    sum(0..n, |i| (0.93 + k[i]*r[i]/4)*powi(v[i] + 0.43*r[i]*v[(i + 1) % n], 2))/2 + 0.42*s[0]*v[n - 1] + r[n - 1]
)]
#[forces(
    0.43*sum(0..n, |j| sin(x[i] - x[j])*v[j]) - 0.42*k[i]*v[i] - product(0..=i, |j| s[j]) for i in 0..n,
)]
#[constraint(row[i]: 1.16*ddot(x[i]) - 0.21*r[i]*ddot(x[n - 1]) + 0.45*v[i]*v[n - 1] == 0 for i in 0..2)]
pub struct Random65 {
    #[nominal(1.19)]
    pub p1: f64,
    #[nominal(1.11)]
    pub p2: f64,
    #[nominal(1.10)]
    pub p3: f64,
    #[nominal(1.14)]
    pub k: [f64; 3],
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1) - 0.21*(if x1 <= -0.52 { cos(0.94*x5 + 1.01) } else { tan(0.65*sin(x2))/2 })*dot(x2) - 0.60*exp(-powi(x4, 2)/2),
    v2 = dot(x2) + 0.11*sin(0.65*x3 - 0.22*x2)*cos(1.17*x3 + 0.62*x2),
    v3 = (1.13 - 0.29*(if x4 >= 0.03 { powi(cos(1.10*x5 - 0.84*x4 - 0.99), 3) } else { 1/sqrt(1.50 + powi(x1, 2)) }))*dot(x3) + 0.56*cos(1.10*x2 + 0.55*x4),
    v4 = (1.14 + 0.19*powi(cos(0.94*x4), 3))*dot(x4) + 0.16*cos(0.58*x3)*dot(x1) - 0.31*exp(-powi(x3, 2)/2),
    v5 = dot(x5) + 0.27*0.63*sin(x1)/(1.50 + cos(x2))*dot(x2) + 0.35*0.44*sin(x2)/(1.50 + cos(x2)),
)]
#[inertia(matrix(
    [(1.14)*(1.14), (1.14)*(0.30*wave(0.45*x5 - 1.13)), (1.14)*(0.33*powi(cos(1.17*x4), 3)), (1.14)*(0.24*wave(0.86*x2)), (1.14)*(0.34*bump(0.63*x3 - 0.35*x2))],
    [_, (0.30*wave(0.45*x5 - 1.13))*(0.30*wave(0.45*x5 - 1.13)) + ((1.19 - 0.15*atan2(x4, 2 + cos(x4))/2))*((1.19 - 0.15*atan2(x4, 2 + cos(x4))/2)), (0.30*wave(0.45*x5 - 1.13))*(0.33*powi(cos(1.17*x4), 3)) + ((1.19 - 0.15*atan2(x4, 2 + cos(x4))/2))*(0.21*powi(cos(1.14*x4), 3)), (0.30*wave(0.45*x5 - 1.13))*(0.24*wave(0.86*x2)), (0.30*wave(0.45*x5 - 1.13))*(0.34*bump(0.63*x3 - 0.35*x2))],
    [_, _, (0.33*powi(cos(1.17*x4), 3))*(0.33*powi(cos(1.17*x4), 3)) + (0.21*powi(cos(1.14*x4), 3))*(0.21*powi(cos(1.14*x4), 3)) + (1.22)*(1.22), (0.33*powi(cos(1.17*x4), 3))*(0.24*wave(0.86*x2)), (0.33*powi(cos(1.17*x4), 3))*(0.34*bump(0.63*x3 - 0.35*x2)) + (1.22)*(0.32*atan2(x4, 2 + cos(x1))/2)],
    [_, _, _, (0.24*wave(0.86*x2))*(0.24*wave(0.86*x2)) + ((1.27 - 0.31*x1/(1 + powi(x1, 2))))*((1.27 - 0.31*x1/(1 + powi(x1, 2)))), (0.24*wave(0.86*x2))*(0.34*bump(0.63*x3 - 0.35*x2)) + ((1.27 - 0.31*x1/(1 + powi(x1, 2))))*(0.14*powi(cos(1.18*x4 + 1.37), 3))],
    [_, _, _, _, (0.34*bump(0.63*x3 - 0.35*x2))*(0.34*bump(0.63*x3 - 0.35*x2)) + (0.32*atan2(x4, 2 + cos(x1))/2)*(0.32*atan2(x4, 2 + cos(x1))/2) + (0.14*powi(cos(1.18*x4 + 1.37), 3))*(0.14*powi(cos(1.18*x4 + 1.37), 3)) + ((1.31 + 0.31*sin(p1*x1 - 1.00)))*((1.31 + 0.31*sin(p1*x1 - 1.00)))],
))]
#[forces(
    1.83*powi(v3, 2) + 2.00*v5,
    1.05*powi(v4, 2) - p1*x1 - 0.56*v2 - 0.38*v5/(1 + powi(x5, 2)),
    tau*0.65 - p2*v3*v3*x2/(1 + powi(x2, 2)) - tau*1.70 - p1*v2*v4*bump(1.08*x1 + 0.69*x1 - 0.74),
    0.36*x2/(1 + powi(x2, 2)),
    v1*v4/(1.38 - 0.31*cos(0.89*x5 + 0.57*x2)),
)]
#[potential_energy(x2/(1 + powi(x2, 2)))]
pub struct Random66 {
    #[nominal(0.95)]
    pub p1: f64,
    #[nominal(0.59)]
    pub p2: f64,
    #[nominal(1.29)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    dot(x1) = v1 - 0.10*sin(1.03*x4 + 0.60*x5 + 0.75)*cos(1.10*x5),
    dot(x2) = (1.13 + 0.18*cos(0.85*x5))*v2 - 0.28*sin(p1*x4 - 0.69)*v5 - 0.14*powi(cos(1.05*x3), 3),
    dot(x3) = v3 + 0.34*tan(0.94*sin(x3))/2*v4 + 0.17*powi(cos(0.64*x2 - 1.20), 3),
    dot(x4) = (1.18 - 0.16*(if x3 <= 0.25 { ln(1.60 + 0.91*cos(x1)) } else { wave(0.44*x5 - 0.98) }))*v4 - 0.28*wave(0.80*x1 + 0.62*x1),
    dot(x5) = v5 - 0.23*atan2(x3, 2 + cos(x1))/2*v4 - 0.46*sin(1.05*x5 - 0.31*x4),
)]
#[define(l11 = (1.28 - 0.11*(if x3 < -0.01 { sin(0.74*x4 + 0.53*x4) } else { sin(1.07*x4 + 0.81*x5)*cos(0.56*x2 + 0.70*x1 - 0.45) })), l21 = 0.13*tan(0.75*sin(x3))/2, l22 = (1.32 + 0.27*sin(1.03*x5)*cos(0.71*x5 + 0.45*x5 - 0.72)), l31 = 0.21*atan2(x1, 2 + cos(x4))/2, l32 = 0.31*exp(-powi(x1, 2)/2), l33 = 1.33, l42 = 0.22*(if x1 < 0.34 { cos(0.44*x2 - 0.50*x3) } else { 0.97*sin(x3)/(1.50 + cos(x3)) }), l43 = 0.35*bump(0.43*x2 + 0.68*x1), l44 = 1.37, l51 = 0.15*wave(0.65*x4 - 1.08), l52 = 0.35*bump(0.41*x3 + 1.05), l53 = 0.29*sin(1.01*x4), l54 = 0.25*(if x3 <= -0.48 { atan2(x3, 2 + cos(x3))/2 } else { cos(1.06*x3 + 0.14) }), l55 = 1.02)]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, 0, l11*l51],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l22*l42, l21*l51 + l22*l52],
    [_, _, l31*l31 + l32*l32 + l33*l33, l32*l42 + l33*l43, l31*l51 + l32*l52 + l33*l53],
    [_, _, _, l42*l42 + l43*l43 + l44*l44, l42*l52 + l43*l53 + l44*l54],
    [_, _, _, _, l51*l51 + l52*l52 + l53*l53 + l54*l54 + l55*l55],
))]
#[forces(
    0,
    1.11*sin(p1*x5 + 0.46) - 0.34*x4/(1 + powi(x4, 2)) - p1*x3 - 0.75*cos(0.58*x5),
    0.37*powi(v1, 2),
    v3*sqrt(2 + powi(v4, 2)),
    p1*v2*v5*cos(0.73*x2 - 1.29) + 0.72*v5 + v4*v4/1.32,
)]
#[constraint(row1: (1.50 + 0.30*exp(-powi(x5, 2)/2))*v2 - 0.20*sin(p1*x1 - 0.71)*v5 - 0.24*tan(0.53*sin(x4))/2*v1 + 0.58*0.33*sin(x2)/(1.50 + cos(x1)) == 0)]
#[constraint(row2: v4 - 0.17*cos(0.94*x1 + 0.88*x4)*v5 - 0.21*exp(-powi(x1, 2)/2)*v1 + 0.31*cos(0.94*x2)*v2 - 0.22*wave(0.86*x2) == 0)]
#[constraint(row3: (1.50 - 0.24*sin(0.85*x4 + 0.54*x2))*v3 - 0.25*cos(0.44*x5 + 0.76*x1 - 0.47)*v5 + 0.28*powi(cos(1.07*x1), 3)*v1 - 0.11*(if x1 >= 0.47 { sin(0.52*x2) } else { atan2(x5, 2 + cos(x1))/2 })*v2 == 0)]
#[output(place = cos(0.98*x1 - 0.87*x5), power = p1*x1 - p1*v1*v4*exp(-powi(x4, 2)/2) - 0.62*v5 - 1.86*v3/(1 + powi(x1, 2)), push = sin(p1*x4 - 0.65)*dot(v5) + v4*ddot(x4), pull = 1.01*reaction(row2) - push, share = pull/(1.43 + powi(reaction(row2), 2)))]
pub struct Random67 {
    #[nominal(0.50)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[inputs(tau)]
#[define(l11 = (1.26 + 0.27*sin(0.95*x3 - 0.84*x1 - 0.31)*cos(1.16*x1 + 0.30*x1)), l21 = 0.36*exp(-powi(x2, 2)/2), l22 = (1.30 - 0.34*1/sqrt(1.50 + powi(x2, 2))), l31 = 0.18*sin(0.56*x3), l33 = (1.24 + 0.29*sin(0.71*x1 + 0.51*x4)), l41 = 0.38*0.57*sin(x2)/(1.50 + cos(x1)), l42 = 0.22*(if x4 >= 0.35 { atan2(x3, 2 + cos(x2))/2 } else { powi(cos(0.64*x1 + 0.40*x1 - 1.42), 3) }), l43 = 0.27*sin(0.79*x1)*cos(0.97*x1 - 0.48*x2 - 0.50), l44 = (1.32 - 0.21*1/sqrt(1.50 + powi(x4, 2))))]
#[kinetic_energy(powi(l11*dot(x1) + l21*dot(x2) + l31*dot(x3) + l41*dot(x4), 2)/2 + powi(l22*dot(x2) + l42*dot(x4), 2)/2 + powi(l33*dot(x3) + l43*dot(x4), 2)/2 + powi(l44*dot(x4), 2)/2 + 0.49*bump(1.04*x3)*dot(x2))]
#[forces(
    0.88*(if x2 <= -0.20 { sin(1.02*x3 - 0.97)*cos(0.88*x3 + 0.56*x2) } else { sin(0.54*x1 - 0.40*x3) }) - tau*1.63 - 1.28*powi(dot(x4), 2) - p1*dot(x2)*dot(x3)*exp(-powi(x4, 2)/2),
    0,
    0,
    dot(x1)*dot(x3)/(1.23 + 0.30*atan2(x4, 2 + cos(x4))/2),
)]
#[constraint(row1: 1.91*x2 + 0.16*x4*x4 + 0.12 == 0)]
#[constraint(row2: 1.93*x3 + 0.28*sin(x3) + 0.31*x4 - 0.77 == 0)]
pub struct Random68 {
    #[nominal(0.96)]
    pub p1: f64,
    #[nominal(0.64)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[kinetic_energy(1.22*powi(dot(x1), 2)/2 + (1.33 - 0.12*sin(0.99*x4))*powi(dot(x2), 2)/2 + 1.22*powi(dot(x3), 2)/2 + 1.12*powi(dot(x4), 2)/2 - 0.43*cos(0.55*x2 + 0.41*x4 - 0.73)*dot(x2) - 0.69*wave(0.74*x3 - 0.64*x3 + 0.20))]
#[forces(
    dot(x2)*dot(x1)/(1.17 + 0.29*bump(0.82*x4 - 0.83*x3)) - p2*x2 - p2*dot(x1)*dot(x2)*atan2(x2, 2 + cos(x2))/2 - dot(x3)*dot(x3)/1.23,
    1.56*dot(x1)/(1 + powi(x2, 2)) - dot(x4)*dot(x2)/(1.09 + 0.32*ln(1.60 + 0.41*cos(x3))) - 1.87*tan(0.65*sin(x1))/2,
    p1*exp(0.20*x4) + 1.64*tan(0.41*sin(x3))/2 + dot(x3)*sqrt(2 + powi(dot(x3), 2)),
    p1*dot(x4)*dot(x4)*sin(p1*x4 - 0.60) + 1.77*dot(x3) + p2*x2 + dot(x1)*dot(x2)/(1.35 - 0.34*sin(1.18*x1)),
)]
#[constraint(row1: 1.66*x1 + 0.37*sin(x4) + 0.15*sin(x3) + 0.74 == 0)]
#[constraint(row2: (1.50 - 0.12*x4/(1 + powi(x4, 2)))*dot(x2) + 0.16*(if x3 >= -0.51 { cos(1.09*x3 - 0.80*x3) } else { powi(cos(1.08*x3 - 0.44*x1), 3) })*dot(x4) - 0.14*exp(-powi(x1, 2)/2)*dot(x3) + 0.26*(if x1 < -0.06 { x2/(1 + powi(x2, 2)) } else { cos(0.52*x2 - 0.66*x4) })*dot(x1) == 0)]
pub struct Random69 {
    #[nominal(0.52)]
    pub p1: f64,
    #[nominal(1.32)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + wave(0.42*x5 + 0.84*x5)*dot(x1),
    v3 = dot(x3) + wave(1.10*x2 + 0.99)*dot(x2),
    v4 = dot(x4) + sin(0.73*x1 - 1.37)*dot(x3),
    v5 = dot(x5) + (if x1 > -0.42 { sin(0.43*x2 - 1.31) } else { tan(0.79*sin(x5))/2 })*dot(x4),
    dot(x1) = v1,
    dot(x2) = v2 - wave(0.42*x5 + 0.84*x5)*(v1),
    dot(x3) = v3 - wave(1.10*x2 + 0.99)*(v2 - wave(0.42*x5 + 0.84*x5)*(v1)),
    dot(x4) = v4 - sin(0.73*x1 - 1.37)*(v3 - wave(1.10*x2 + 0.99)*(v2 - wave(0.42*x5 + 0.84*x5)*(v1))),
    dot(x5) = v5 - (if x1 > -0.42 { sin(0.43*x2 - 1.31) } else { tan(0.79*sin(x5))/2 })*(v4 - sin(0.73*x1 - 1.37)*(v3 - wave(1.10*x2 + 0.99)*(v2 - wave(0.42*x5 + 0.84*x5)*(v1)))),
)]
#[inertia(diag((1.26 - 0.17*wave(0.82*x1 + 1.08)), (1.02 + 0.20*powi(cos(0.82*x2), 3)), (1.28 + 0.12*sin(0.61*x5 + 0.52)), (1.14 - 0.28*x3/(1 + powi(x3, 2))), (1.34 + 0.32*exp(-powi(x5, 2)/2))))]
#[forces(
    1.42*wave(0.92*x1 - 0.78*x2 + 0.76) + v5*sqrt(2 + powi(v1, 2)) + p3*x1,
    1.59*v3 - p2*exp(0.20*x4),
    p1*v1*v1*(if x5 > 0.58 { cos(0.94*x1 + 0.61) } else { sin(0.79*x5 - 0.24*x4 - 1.28) }) + p3*v2*v1*exp(-powi(x3, 2)/2),
    p1*v3*v2*sin(0.46*x3 - 0.26*x5) - 0.81*v3/(1 + powi(x1, 2)) - 1.65*v2/(1 + powi(x2, 2)),
    0.85*v5 - p3*v5*v2*sin(0.90*x3 - 0.76*x2),
)]
#[constraint(height: 1.72*x4 + 0.31*powi(x5, 2)/2 + 0.15*powi(x2, 2)/2 - 0.43 == 0)]
#[constraint(height_rate: (1.05 - 0.32*sin(1.05*x3 - 0.96))*(1.72*dot(x4) + 0.31*x5*dot(x5) + 0.15*x2*dot(x2)) == 0)]
#[constraint(further: (1.50 + 0.29*powi(cos(0.79*x2 + 0.41*x4), 3))*v3 - 0.33*bump(0.45*x5 - 0.18)*v5 + 0.17*x4/(1 + powi(x4, 2))*v2 + 0.17*(if x1 > -0.37 { sin(0.99*x2 + 0.62*x1 - 0.42) } else { sin(1.07*x4) })*v1 - 0.27*(if x2 <= 0.15 { 0.50*sin(x5)/(1.50 + cos(x3)) } else { powi(cos(0.92*x1 + 0.46*x5), 3) }) == 0)]
#[independent(v1, v2, v5)]
pub struct Random70 {
    #[nominal(0.78)]
    pub p1: f64,
    #[nominal(1.41)]
    pub p2: f64,
    #[nominal(1.01)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[define(l11 = (1.24 - 0.11*x5/(1 + powi(x5, 2))), l22 = (1.38 + 0.16*(if x4 < 0.19 { sin(0.72*x3) } else { sin(0.76*x3 - 0.25*x4 - 0.37) })), l31 = 0.20*sin(p1*x5 - 0.61), l32 = 0.35*0.63*sin(x3)/(1.50 + cos(x5)), l33 = (1.25 + 0.29*exp(-powi(x3, 2)/2)), l41 = 0.11*x3/(1 + powi(x3, 2)), l43 = 0.17*sin(0.55*x5 - 0.65*x2)*cos(0.82*x4 - 0.60*x1), l44 = (1.07 - 0.15*cos(0.91*x4)), l51 = 0.22*sin(1.02*x3 + 1.13), l53 = 0.23*x2/(1 + powi(x2, 2)), l55 = (1.19 + 0.27*cos(0.98*x2 - 0.77*x5 - 0.90)))]
#[inertia(matrix(
    [l11*l11, 0, l11*l31, l11*l41, l11*l51],
    [_, l22*l22, l22*l32, 0, 0],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l33*l43, l31*l51 + l33*l53],
    [_, _, _, l41*l41 + l43*l43 + l44*l44, l41*l51 + l43*l53],
    [_, _, _, _, l51*l51 + l53*l53 + l55*l55],
))]
#[forces(
    dot(x3)*sqrt(2 + powi(dot(x2), 2)) + p1*1.26 + dot(x4)*dot(x3)/(1.23 - 0.28*sin(p1*x4 + 0.29)) + dot(x3)*dot(x2)/1.28,
    0.60*powi(dot(x4), 2) + p1*dot(x5)*dot(x2)*(if x1 <= -0.49 { sin(1.07*x5 + 0.78*x1) } else { cos(0.64*x1 - 0.69*x1) }) + 1.74*dot(x5) + p1*0.47,
    p1*exp(0.20*x3) + p1*dot(x2)*dot(x1)*wave(0.51*x5 - 0.71*x4 + 1.39) + 1.18*dot(x1)/(1 + powi(x2, 2)),
    1.42*powi(dot(x4), 2) + 0.95*powi(dot(x1), 2) + 1.05*powi(dot(x5), 2),
    p1*x3 + p1*x3 + dot(x3)*sqrt(2 + powi(dot(x4), 2)),
)]
#[constraint(height: 1.96*x3 + 0.14*x1 + 0.39*x2*x1 + 0.72 == 0)]
#[constraint(first: 1.69*dot(x5) + 0.25*bump(0.78*x2)*dot(x1) + 0.11*ln(1.60 + 0.97*cos(x3))*dot(x2) + 0.18*(if x5 >= -0.19 { cos(0.96*x3) } else { tan(0.72*sin(x3))/2 })*dot(x4) == 0)]
#[constraint(second: 1.96*dot(x3) + 0.14*dot(x1) + 0.39*(dot(x2)*x1 + x2*dot(x1)) - 0.50*ln(1.60 + 0.56*cos(x3))*(1.69*dot(x5) + 0.25*bump(0.78*x2)*dot(x1) + 0.11*ln(1.60 + 0.97*cos(x3))*dot(x2) + 0.18*(if x5 >= -0.19 { cos(0.96*x3) } else { tan(0.72*sin(x3))/2 })*dot(x4)) == 0)]
pub struct Random71 {
    #[nominal(0.54)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = 1.30*dot(x1) - 0.24*0.68*sin(x1)/(1.50 + cos(x4))*dot(x5) + 0.30*x3/(1 + powi(x3, 2)),
    v2 = dot(x2) + 0.17*cos(1.04*x5 - 0.40*x3)*dot(x4) + 0.12*sin(0.80*x3 + 0.90*x1)*cos(1.11*x5 + 0.41*x4),
    v3 = (1.23 - 0.11*powi(cos(1.19*x5 + 0.26*x4), 3))*dot(x3) + 0.29*(if x2 > -0.44 { sin(1.16*x5 - 0.37*x3 + 0.67) } else { 1/sqrt(1.50 + powi(x5, 2)) })*dot(x4) - 0.24*x5/(1 + powi(x5, 2)),
    v4 = (1.20 - 0.29*sin(0.89*x5))*dot(x4) - 0.19*cos(0.50*x4)*dot(x5) + 0.54*sin(0.84*x2 + 1.24),
    v5 = dot(x5) + 0.14*atan2(x4, 2 + cos(x5))/2*dot(x4) - 0.18*x4/(1 + powi(x4, 2)),
)]
#[inertia(matrix(
    [((1.12 + 0.27*sin(p1*x1 - 0.86)))*((1.12 + 0.27*sin(p1*x1 - 0.86))), ((1.12 + 0.27*sin(p1*x1 - 0.86)))*(0.19*(if x4 <= -0.13 { sin(0.96*x4)*cos(0.56*x4 - 0.30) } else { exp(-powi(x2, 2)/2) })), ((1.12 + 0.27*sin(p1*x1 - 0.86)))*(0.17*sin(0.42*x5 - 1.42)*cos(0.44*x1 + 1.49)), ((1.12 + 0.27*sin(p1*x1 - 0.86)))*(0.23*tan(0.89*sin(x5))/2), ((1.12 + 0.27*sin(p1*x1 - 0.86)))*(0.36*(if x2 >= 0.48 { bump(0.68*x2) } else { tan(0.53*sin(x4))/2 }))],
    [_, (0.19*(if x4 <= -0.13 { sin(0.96*x4)*cos(0.56*x4 - 0.30) } else { exp(-powi(x2, 2)/2) }))*(0.19*(if x4 <= -0.13 { sin(0.96*x4)*cos(0.56*x4 - 0.30) } else { exp(-powi(x2, 2)/2) })) + (1.34)*(1.34), (0.19*(if x4 <= -0.13 { sin(0.96*x4)*cos(0.56*x4 - 0.30) } else { exp(-powi(x2, 2)/2) }))*(0.17*sin(0.42*x5 - 1.42)*cos(0.44*x1 + 1.49)), (0.19*(if x4 <= -0.13 { sin(0.96*x4)*cos(0.56*x4 - 0.30) } else { exp(-powi(x2, 2)/2) }))*(0.23*tan(0.89*sin(x5))/2) + (1.34)*(0.34*sin(1.18*x5 + 0.51*x5)*cos(1.11*x3)), (0.19*(if x4 <= -0.13 { sin(0.96*x4)*cos(0.56*x4 - 0.30) } else { exp(-powi(x2, 2)/2) }))*(0.36*(if x2 >= 0.48 { bump(0.68*x2) } else { tan(0.53*sin(x4))/2 })) + (1.34)*(0.35*sin(0.61*x5)*cos(1.08*x5 - 0.51))],
    [_, _, (0.17*sin(0.42*x5 - 1.42)*cos(0.44*x1 + 1.49))*(0.17*sin(0.42*x5 - 1.42)*cos(0.44*x1 + 1.49)) + ((1.18 + 0.30*1/sqrt(1.50 + powi(x5, 2))))*((1.18 + 0.30*1/sqrt(1.50 + powi(x5, 2)))), (0.17*sin(0.42*x5 - 1.42)*cos(0.44*x1 + 1.49))*(0.23*tan(0.89*sin(x5))/2) + ((1.18 + 0.30*1/sqrt(1.50 + powi(x5, 2))))*(0.34*bump(0.80*x2 + 0.86*x1)), (0.17*sin(0.42*x5 - 1.42)*cos(0.44*x1 + 1.49))*(0.36*(if x2 >= 0.48 { bump(0.68*x2) } else { tan(0.53*sin(x4))/2 }))],
    [_, _, _, (0.23*tan(0.89*sin(x5))/2)*(0.23*tan(0.89*sin(x5))/2) + (0.34*sin(1.18*x5 + 0.51*x5)*cos(1.11*x3))*(0.34*sin(1.18*x5 + 0.51*x5)*cos(1.11*x3)) + (0.34*bump(0.80*x2 + 0.86*x1))*(0.34*bump(0.80*x2 + 0.86*x1)) + (1.38)*(1.38), (0.23*tan(0.89*sin(x5))/2)*(0.36*(if x2 >= 0.48 { bump(0.68*x2) } else { tan(0.53*sin(x4))/2 })) + (0.34*sin(1.18*x5 + 0.51*x5)*cos(1.11*x3))*(0.35*sin(0.61*x5)*cos(1.08*x5 - 0.51)) + (1.38)*(0.36*tan(0.68*sin(x4))/2)],
    [_, _, _, _, (0.36*(if x2 >= 0.48 { bump(0.68*x2) } else { tan(0.53*sin(x4))/2 }))*(0.36*(if x2 >= 0.48 { bump(0.68*x2) } else { tan(0.53*sin(x4))/2 })) + (0.35*sin(0.61*x5)*cos(1.08*x5 - 0.51))*(0.35*sin(0.61*x5)*cos(1.08*x5 - 0.51)) + (0.36*tan(0.68*sin(x4))/2)*(0.36*tan(0.68*sin(x4))/2) + ((1.15 - 0.17*sin(p3*x4 - 0.68)))*((1.15 - 0.17*sin(p3*x4 - 0.68)))],
))]
#[forces(
    0.87*v1/(1 + powi(x1, 2)),
    v5*sqrt(2 + powi(v4, 2)) - p1*exp(0.20*x1) - 1.70*sin(p2*x2 + 0.78),
    0,
    0.69*(if x5 <= -0.02 { sin(1.19*x5)*cos(0.53*x4 + 0.34*x4) } else { bump(0.45*x1 + 0.22*x2) }) + p3*0.98 + 1.94*(if x2 >= -0.25 { x3/(1 + powi(x3, 2)) } else { sin(p1*x5 - 0.10) }),
    0,
)]
#[configuration(x1 = 1.29*(if x3 <= 0.06 { 0.74*sin(x5)/(1.50 + cos(x3)) } else { ln(1.60 + 0.69*cos(x3)) }), x4 = 0.85*sin(p2*x2 + 0.35))]
#[output(place = exp(-powi(x1, 2)/2), power = p3*x4 + p2*x4 + p1*exp(0.20*x2), push = (if x5 < 0.24 { bump(0.96*x3 - 0.80*x1) } else { bump(0.62*x1 + 0.68*x4) })*dot(v3) + v5*ddot(x5))]
pub struct Random72 {
    #[nominal(0.68)]
    pub p1: f64,
    #[nominal(1.00)]
    pub p2: f64,
    #[nominal(0.95)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[inputs(tau)]
#[kinematics(
    v1 = (1.08 - 0.10*sin(0.86*x2 + 0.55*x1))*dot(x1) + 0.31*exp(-powi(x2, 2)/2)*dot(x4) + 0.38*tan(0.43*sin(x4))/2,
    v2 = dot(x2) - 0.21*x4/(1 + powi(x4, 2))*dot(x3) + 0.22*tan(0.93*sin(x4))/2,
    v3 = (1.30 - 0.19*ln(1.60 + 0.72*cos(x3)))*dot(x3) + 0.12*bump(0.66*x3),
    v4 = dot(x4) + 0.19*0.74*sin(x3)/(1.50 + cos(x3))*dot(x3) + 0.13*cos(0.64*x1),
)]
#[kinetic_energy(1.15*powi(v1, 2)/2 + (1.15 - 0.22*sin(0.43*x3 + 1.50))*powi(v2, 2)/2 + (1.27 + 0.20*1/sqrt(1.50 + powi(x4, 2)))*powi(v3, 2)/2 + 1.35*powi(v4, 2)/2 + 0.55*sin(0.55*x3 - 0.66)*cos(0.42*x4 - 0.73*x1)*v1)]
#[forces(
    v4*sqrt(2 + powi(v2, 2)) - v4*sqrt(2 + powi(v2, 2)),
    0,
    1.35*powi(v1, 2) + 0.48*(if x1 < 0.37 { cos(0.70*x1 + 1.05) } else { sin(0.61*x1) }) + v3*sqrt(2 + powi(v1, 2)),
    p1*v1*v2*0.87*sin(x2)/(1.50 + cos(x4)) + 0.77*v3/(1 + powi(x2, 2)),
)]
#[potential_energy(sin(0.50*x2 - 0.53))]
#[configuration(of(q1), x1 = 1.25*q1, x2 = sin(1.16*q1)*cos(0.70*q1 - 0.40*q1 - 0.69), x4 = wave(0.46*q1 + 0.51*q1), x3 = cos(0.92*q1 + 0.46))]
#[constraint(held_x2: x2 - (sin(1.16*(x1/1.25))*cos(0.70*(x1/1.25) - 0.40*(x1/1.25) - 0.69)) == 0)]
#[constraint(held_x4: x4 - (wave(0.46*(x1/1.25) + 0.51*(x1/1.25))) == 0)]
#[constraint(held_x3: x3 - (cos(0.92*(x1/1.25) + 0.46)) == 0)]
#[output(place = (if x1 > 0.10 { atan2(x4, 2 + cos(x2))/2 } else { tan(0.61*sin(x2))/2 }), power = 1.43*powi(v3, 2) - v3*sqrt(2 + powi(v2, 2)) - 1.92*sin(p1*x4 + 0.30), push = 0.73*sin(x2)/(1.50 + cos(x1))*dot(v1) + v1*ddot(x1), pull = (1.23 - 0.31*1/sqrt(1.50 + powi(x4, 2)))*reaction(held_x4) - push, share = pull/(1.85 + powi(reaction(held_x4), 2)))]
pub struct Random73 {
    #[nominal(1.38)]
    pub p1: f64,
    #[nominal(1.22)]
    pub p2: f64,
    #[nominal(0.50)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = (1.15 + 0.32*(if x1 < -0.20 { sin(p2*x1 - 0.35) } else { sin(p1*x3 - 0.63) }))*v1 + 0.18*sin(0.61*x2 + 0.34*x1 + 1.27)*v5 - 0.36*0.57*sin(x4)/(1.50 + cos(x4)),
    dot(x2) = (1.02 - 0.34*ln(1.60 + 0.83*cos(x3)))*v2 + 0.24*x5/(1 + powi(x5, 2)),
    dot(x3) = (1.29 - 0.25*ln(1.60 + 0.43*cos(x4)))*v3 - 0.27*exp(-powi(x3, 2)/2),
    dot(x4) = (1.35 + 0.30*bump(0.82*x2 - 0.28*x2))*v4 - 0.15*sin(0.40*x2),
    dot(x5) = (1.15 - 0.14*(if x5 >= 0.57 { sin(0.68*x5 - 0.38*x3) } else { x2/(1 + powi(x2, 2)) }))*v5 + 0.14*wave(0.89*x2 - 1.26)*v4 - 0.31*sin(0.50*x1)*cos(0.85*x1),
)]
#[inertia(matrix(
    [((1.08 + 0.13*tan(0.36*sin(x3))/2))*((1.08 + 0.13*tan(0.36*sin(x3))/2)), ((1.08 + 0.13*tan(0.36*sin(x3))/2))*(0.35*(if x4 < 0.56 { bump(0.75*x1 + 0.49*x2 - 0.32) } else { ln(1.60 + 0.84*cos(x4)) })), ((1.08 + 0.13*tan(0.36*sin(x3))/2))*(0.10*(if x2 <= -0.06 { tan(0.37*sin(x5))/2 } else { 1/sqrt(1.50 + powi(x1, 2)) })), ((1.08 + 0.13*tan(0.36*sin(x3))/2))*(0.25*atan2(x5, 2 + cos(x2))/2), ((1.08 + 0.13*tan(0.36*sin(x3))/2))*(0.16*exp(-powi(x1, 2)/2))],
    [_, (0.35*(if x4 < 0.56 { bump(0.75*x1 + 0.49*x2 - 0.32) } else { ln(1.60 + 0.84*cos(x4)) }))*(0.35*(if x4 < 0.56 { bump(0.75*x1 + 0.49*x2 - 0.32) } else { ln(1.60 + 0.84*cos(x4)) })) + ((1.35 - 0.14*sin(0.58*x2 - 0.62*x3)*cos(1.19*x1 - 0.30*x1)))*((1.35 - 0.14*sin(0.58*x2 - 0.62*x3)*cos(1.19*x1 - 0.30*x1))), (0.35*(if x4 < 0.56 { bump(0.75*x1 + 0.49*x2 - 0.32) } else { ln(1.60 + 0.84*cos(x4)) }))*(0.10*(if x2 <= -0.06 { tan(0.37*sin(x5))/2 } else { 1/sqrt(1.50 + powi(x1, 2)) })), (0.35*(if x4 < 0.56 { bump(0.75*x1 + 0.49*x2 - 0.32) } else { ln(1.60 + 0.84*cos(x4)) }))*(0.25*atan2(x5, 2 + cos(x2))/2) + ((1.35 - 0.14*sin(0.58*x2 - 0.62*x3)*cos(1.19*x1 - 0.30*x1)))*(0.29*sin(0.83*x1)), (0.35*(if x4 < 0.56 { bump(0.75*x1 + 0.49*x2 - 0.32) } else { ln(1.60 + 0.84*cos(x4)) }))*(0.16*exp(-powi(x1, 2)/2)) + ((1.35 - 0.14*sin(0.58*x2 - 0.62*x3)*cos(1.19*x1 - 0.30*x1)))*(0.13*sin(p1*x2 + 0.90))],
    [_, _, (0.10*(if x2 <= -0.06 { tan(0.37*sin(x5))/2 } else { 1/sqrt(1.50 + powi(x1, 2)) }))*(0.10*(if x2 <= -0.06 { tan(0.37*sin(x5))/2 } else { 1/sqrt(1.50 + powi(x1, 2)) })) + ((1.29 - 0.16*0.43*sin(x1)/(1.50 + cos(x5))))*((1.29 - 0.16*0.43*sin(x1)/(1.50 + cos(x5)))), (0.10*(if x2 <= -0.06 { tan(0.37*sin(x5))/2 } else { 1/sqrt(1.50 + powi(x1, 2)) }))*(0.25*atan2(x5, 2 + cos(x2))/2), (0.10*(if x2 <= -0.06 { tan(0.37*sin(x5))/2 } else { 1/sqrt(1.50 + powi(x1, 2)) }))*(0.16*exp(-powi(x1, 2)/2)) + ((1.29 - 0.16*0.43*sin(x1)/(1.50 + cos(x5))))*(0.12*sin(1.03*x1))],
    [_, _, _, (0.25*atan2(x5, 2 + cos(x2))/2)*(0.25*atan2(x5, 2 + cos(x2))/2) + (0.29*sin(0.83*x1))*(0.29*sin(0.83*x1)) + ((1.23 + 0.14*powi(cos(0.50*x4 - 0.25*x4), 3)))*((1.23 + 0.14*powi(cos(0.50*x4 - 0.25*x4), 3))), (0.25*atan2(x5, 2 + cos(x2))/2)*(0.16*exp(-powi(x1, 2)/2)) + (0.29*sin(0.83*x1))*(0.13*sin(p1*x2 + 0.90)) + ((1.23 + 0.14*powi(cos(0.50*x4 - 0.25*x4), 3)))*(0.11*1/sqrt(1.50 + powi(x2, 2)))],
    [_, _, _, _, (0.16*exp(-powi(x1, 2)/2))*(0.16*exp(-powi(x1, 2)/2)) + (0.13*sin(p1*x2 + 0.90))*(0.13*sin(p1*x2 + 0.90)) + (0.12*sin(1.03*x1))*(0.12*sin(1.03*x1)) + (0.11*1/sqrt(1.50 + powi(x2, 2)))*(0.11*1/sqrt(1.50 + powi(x2, 2))) + ((1.07 + 0.15*wave(0.84*x1)))*((1.07 + 0.15*wave(0.84*x1)))],
))]
#[forces(
    1.95*(if x4 <= -0.31 { tan(0.31*sin(x4))/2 } else { sin(0.85*x3 + 0.68*x5) }),
    0,
    0,
    1.40*v2/(1 + powi(x1, 2)) + 1.94*powi(v1, 2) + v5*v3/1.26,
    v1*sqrt(2 + powi(v1, 2)) - 1.43*v4/(1 + powi(x4, 2)) - 1.46*powi(v4, 2),
)]
#[configuration(x2 = 1.13*atan2(x5, 2 + cos(x1))/2)]
#[constraint(held_x2: x2 - (1.13*atan2(x5, 2 + cos(x1))/2) == 0)]
#[constraint(rolling: (1.50 + 0.24*exp(-powi(x4, 2)/2))*dot(x1) - 0.28*cos(1.15*x1 + 0.44)*dot(x5) + 0.25*ln(1.60 + 0.38*cos(x5))*dot(x4) + 0.23*atan2(x3, 2 + cos(x1))/2*dot(x3) == 0)]
#[output(place = sin(p1*x1 + 0.65), power = v4*sqrt(2 + powi(v1, 2)) + p2*x5 + 1.63*powi(v1, 2) + p2*exp(0.20*x5), push = sin(1.04*x5)*dot(v2) + v5*ddot(x5), pull = (1.08 - 0.13*powi(cos(0.83*x2 - 0.60*x5 - 1.06), 3))*reaction(rolling) - push, share = pull/(1.76 + powi(reaction(rolling), 2)))]
pub struct Random74 {
    #[nominal(0.71)]
    pub p1: f64,
    #[nominal(0.93)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(matrix(
    [((1.32 - 0.33*1/sqrt(1.50 + powi(x1, 2))))*((1.32 - 0.33*1/sqrt(1.50 + powi(x1, 2)))), ((1.32 - 0.33*1/sqrt(1.50 + powi(x1, 2))))*(0.15*(if x4 <= 0.17 { x1/(1 + powi(x1, 2)) } else { atan2(x4, 2 + cos(x3))/2 })), 0, 0],
    [_, (0.15*(if x4 <= 0.17 { x1/(1 + powi(x1, 2)) } else { atan2(x4, 2 + cos(x3))/2 }))*(0.15*(if x4 <= 0.17 { x1/(1 + powi(x1, 2)) } else { atan2(x4, 2 + cos(x3))/2 })) + ((1.02 + 0.21*tan(0.99*sin(x1))/2))*((1.02 + 0.21*tan(0.99*sin(x1))/2)), ((1.02 + 0.21*tan(0.99*sin(x1))/2))*(0.32*0.51*sin(x1)/(1.50 + cos(x4))), ((1.02 + 0.21*tan(0.99*sin(x1))/2))*(0.26*atan2(x1, 2 + cos(x3))/2)],
    [_, _, (0.32*0.51*sin(x1)/(1.50 + cos(x4)))*(0.32*0.51*sin(x1)/(1.50 + cos(x4))) + (1.01)*(1.01), (0.32*0.51*sin(x1)/(1.50 + cos(x4)))*(0.26*atan2(x1, 2 + cos(x3))/2)],
    [_, _, _, (0.26*atan2(x1, 2 + cos(x3))/2)*(0.26*atan2(x1, 2 + cos(x3))/2) + (1.23)*(1.23)],
))]
#[forces(
    0.73*powi(dot(x4), 2),
    p2*x1,
    p2*x4 - 1.91*1/sqrt(1.50 + powi(x1, 2)),
    1.55*powi(dot(x3), 2) + 1.64*ln(1.60 + 0.96*cos(x3)) + p1*exp(0.20*x4),
)]
#[potential_energy(atan2(x2, 2 + cos(x3))/2)]
#[constraint(row1: dot(x1) + 0.28*powi(cos(1.08*x2), 3)*dot(x2) + 0.53*ln(1.60 + 0.85*cos(x2))*dot(x3) == 0)]
#[constraint(row2: dot(x4) + 0*dot(x2) + 0.35*sin(0.47*x1)*dot(x3) == 0)]
#[complement(
    w1 = [-1.37*(0.28*powi(cos(1.08*x2), 3)), 1.37, 0, -1.37*(0)],
    w2 = [-1.33*(0.53*ln(1.60 + 0.85*cos(x2))), 0, 1.33, -1.33*(0.35*sin(0.47*x1))],
)]
pub struct Random75 {
    #[nominal(0.53)]
    pub p1: f64,
    #[nominal(0.98)]
    pub p2: f64,
    #[nominal(0.95)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(diag((1.04 + 0.17*1/sqrt(1.50 + powi(x3, 2))), (1.37 - 0.27*0.52*sin(x3)/(1.50 + cos(x3))), (1.29 + 0.22*0.43*sin(x4)/(1.50 + cos(x1))), (1.34 - 0.20*ln(1.60 + 0.49*cos(x4)))))]
#[forces(
    1.62*dot(x2)/(1 + powi(x4, 2)) + 0.44*dot(x3)/(1 + powi(x2, 2)) + 0.57*dot(x4) + p2*dot(x1)*dot(x3)*sin(p1*x1 - 0.63),
    0,
    1.18*dot(x4) - 0.72*powi(dot(x4), 2),
    p1*exp(0.20*x1) + dot(x3)*dot(x1)/(1.27 - 0.15*sin(0.62*x3)),
)]
#[potential_energy(sin(0.55*x4))]
#[constraint(row1: 1.95*x4 + 0.17*sin(x4) + 0.22*powi(x3, 2)/2 - 0.34 == 0)]
#[constraint(row2: 1.82*x2 + 0.34*sin(x3) + 0.25*x4*x3 - 0.27 == 0)]
#[constraint(row3: 1.37*x1 + 0.24*sin(x1) + 0.18*x3*x3 + 0.37*x4 + 0.37*sin(x2) - 0.78 == 0)]
#[independent(s1 = dot(x3) + 0.16*(if x2 >= 0.17 { sin(p1*x1 - 0.99) } else { ln(1.60 + 0.33*cos(x2)) })*dot(x4) - 0.22*sin(0.69*x3 - 0.59*x3)*dot(x2) - 0.38*sin(0.77*x4 - 0.55*x4 + 0.74))]
#[independent(dot(x3))]
pub struct Random76 {
    #[nominal(1.30)]
    pub p1: f64,
    #[nominal(1.05)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + atan2(x2, 2 + cos(x3))/2*dot(x1),
    v3 = dot(x3) + sin(0.86*t + 0.78*x4)*dot(x2),
    v4 = dot(x4) + powi(cos(1.06*x1 - 0.87*t), 3)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - atan2(x2, 2 + cos(x3))/2*(v1),
    dot(x3) = v3 - sin(0.86*t + 0.78*x4)*(v2 - atan2(x2, 2 + cos(x3))/2*(v1)),
    dot(x4) = v4 - powi(cos(1.06*x1 - 0.87*t), 3)*(v1),
)]
#[kinetic_energy((1.36 - 0.22*sin(0.80*x2)*cos(1.09*x2))*powi(v1, 2)/2 + (1.07 - 0.23*exp(-powi(x3, 2)/2))*powi(v2, 2)/2 + (1.26 + 0.18*(if x2 >= 0.44 { cos(0.51*x2 + 1.50) } else { bump(0.67*x3 + 1.32) }))*powi(v3, 2)/2 + (1.38 - 0.18*wave(0.87*x3 + 0.26*x3))*powi(v4, 2)/2 - 0.31*sin(1.19*t + 0.24*x3)*v4 + 0.30*sin(1.06*x1)*cos(0.63*t + 1.26))]
#[forces(
    0,
    0.88*powi(v4, 2),
    1.13*v3/(1 + powi(x2, 2)) - p1*exp(0.20*x2),
    p1*x4 + p1*exp(0.20*x2) + p2*exp(0.20*x2),
)]
#[constraint(row1: 1.94*x2 + 0.14*sin(x2) + 0.30*sin(1.10*t) + 0.17 == 0)]
#[constraint(row2: 1.39*x3 + 0.24*sin(x3) + 0.30*x2*x2 + 0.30*sin(1.18*t) - 0.69 == 0)]
#[constraint(row3: 1.69*v4 + 0.17*(if x3 > -0.11 { tan(0.41*sin(t))/2 } else { bump(0.91*x4 + 0.75*x2 + 0.20) })*v2 == 0)]
#[constraint(row4: v1 - 0.11*sin(1.05*x2 + 0.71*x1)*cos(0.95*x3 + 0.68*x2)*v2 + 0.28*(if x4 > -0.46 { x3/(1 + powi(x3, 2)) } else { 1/sqrt(1.50 + powi(x1, 2)) }) == 0)]
pub struct Random77 {
    #[nominal(1.32)]
    pub p1: f64,
    #[nominal(1.46)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[inertia(matrix(
    [((1.36 + 0.26*x5/(1 + powi(x5, 2))))*((1.36 + 0.26*x5/(1 + powi(x5, 2)))), ((1.36 + 0.26*x5/(1 + powi(x5, 2))))*(0.34*atan2(x4, 2 + cos(x5))/2), ((1.36 + 0.26*x5/(1 + powi(x5, 2))))*(0.20*(if x4 >= 0.37 { cos(1.02*x1 - 1.26) } else { exp(-powi(x3, 2)/2) })), ((1.36 + 0.26*x5/(1 + powi(x5, 2))))*(0.22*tan(0.94*sin(x3))/2), ((1.36 + 0.26*x5/(1 + powi(x5, 2))))*(0.17*x1/(1 + powi(x1, 2)))],
    [_, (0.34*atan2(x4, 2 + cos(x5))/2)*(0.34*atan2(x4, 2 + cos(x5))/2) + ((1.13 + 0.24*(if x5 < -0.48 { sin(1.16*x5 + 0.66*x4) } else { atan2(x4, 2 + cos(x2))/2 })))*((1.13 + 0.24*(if x5 < -0.48 { sin(1.16*x5 + 0.66*x4) } else { atan2(x4, 2 + cos(x2))/2 }))), (0.34*atan2(x4, 2 + cos(x5))/2)*(0.20*(if x4 >= 0.37 { cos(1.02*x1 - 1.26) } else { exp(-powi(x3, 2)/2) })) + ((1.13 + 0.24*(if x5 < -0.48 { sin(1.16*x5 + 0.66*x4) } else { atan2(x4, 2 + cos(x2))/2 })))*(0.17*x3/(1 + powi(x3, 2))), (0.34*atan2(x4, 2 + cos(x5))/2)*(0.22*tan(0.94*sin(x3))/2), (0.34*atan2(x4, 2 + cos(x5))/2)*(0.17*x1/(1 + powi(x1, 2))) + ((1.13 + 0.24*(if x5 < -0.48 { sin(1.16*x5 + 0.66*x4) } else { atan2(x4, 2 + cos(x2))/2 })))*(0.34*tan(0.41*sin(x2))/2)],
    [_, _, (0.20*(if x4 >= 0.37 { cos(1.02*x1 - 1.26) } else { exp(-powi(x3, 2)/2) }))*(0.20*(if x4 >= 0.37 { cos(1.02*x1 - 1.26) } else { exp(-powi(x3, 2)/2) })) + (0.17*x3/(1 + powi(x3, 2)))*(0.17*x3/(1 + powi(x3, 2))) + ((1.07 - 0.28*tan(0.71*sin(x3))/2))*((1.07 - 0.28*tan(0.71*sin(x3))/2)), (0.20*(if x4 >= 0.37 { cos(1.02*x1 - 1.26) } else { exp(-powi(x3, 2)/2) }))*(0.22*tan(0.94*sin(x3))/2), (0.20*(if x4 >= 0.37 { cos(1.02*x1 - 1.26) } else { exp(-powi(x3, 2)/2) }))*(0.17*x1/(1 + powi(x1, 2))) + (0.17*x3/(1 + powi(x3, 2)))*(0.34*tan(0.41*sin(x2))/2) + ((1.07 - 0.28*tan(0.71*sin(x3))/2))*(0.11*sin(p3*x5 - 0.93))],
    [_, _, _, (0.22*tan(0.94*sin(x3))/2)*(0.22*tan(0.94*sin(x3))/2) + (1.29)*(1.29), (0.22*tan(0.94*sin(x3))/2)*(0.17*x1/(1 + powi(x1, 2))) + (1.29)*(0.32*sin(0.62*x1 + 0.27))],
    [_, _, _, _, (0.17*x1/(1 + powi(x1, 2)))*(0.17*x1/(1 + powi(x1, 2))) + (0.34*tan(0.41*sin(x2))/2)*(0.34*tan(0.41*sin(x2))/2) + (0.11*sin(p3*x5 - 0.93))*(0.11*sin(p3*x5 - 0.93)) + (0.32*sin(0.62*x1 + 0.27))*(0.32*sin(0.62*x1 + 0.27)) + ((1.10 + 0.23*sin(0.79*x4)))*((1.10 + 0.23*sin(0.79*x4)))],
))]
#[forces(
    p2*x3 + 0.46*powi(dot(x1), 2) + p1*1.59 + p3*1.03,
    1.57*dot(x5)/(1 + powi(x1, 2)) + 1.51*dot(x2)/(1 + powi(x4, 2)) + 1.74*dot(x3) + dot(x5)*sqrt(2 + powi(dot(x5), 2)),
    1.15*dot(x4)/(1 + powi(x3, 2)) - dot(x2)*sqrt(2 + powi(dot(x2), 2)) - p1*0.61 - dot(x2)*dot(x5)/(1.23 - 0.15*atan2(x2, 2 + cos(x3))/2),
    1.83*dot(x1) - 1.66*sin(0.58*x4 - 0.45*x5),
    1.78*(if x4 < -0.02 { sin(0.62*x1 - 0.51*x1)*cos(0.81*x1 + 0.19) } else { sin(p1*x2 - 0.76) }) + p1*exp(0.20*x3),
)]
#[potential_energy((if x1 <= -0.48 { cos(0.86*x2 + 1.02) } else { sin(1.09*x5 + 0.83*x5) }))]
#[constraint(row1: 1.99*dot(x4) - 0.22*powi(cos(0.90*x3 - 0.85*x3 + 0.57), 3)*dot(x5)*dot(x5) + 0.29*powi(cos(0.93*x1), 3) == 0)]
pub struct Random78 {
    #[nominal(0.69)]
    pub p1: f64,
    #[nominal(1.41)]
    pub p2: f64,
    #[nominal(0.99)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = dot(x1) - 0.30*x1/(1 + powi(x1, 2))*dot(x5) - 0.29*bump(1.01*x1 - 0.53*x1),
    v2 = 1.10*dot(x2) - 0.20*ln(1.60 + 0.35*cos(x3))*dot(x3) - 0.34*sin(1.11*x3),
    v3 = 1.23*dot(x3) - 0.15*ln(1.60 + 0.90*cos(x1))*dot(x2) + 0.17*exp(-powi(x3, 2)/2),
    v4 = (1.05 + 0.29*0.41*sin(x1)/(1.50 + cos(x3)))*dot(x4) + 0.19*exp(-powi(x1, 2)/2)*dot(x1) + 0.43*wave(0.99*x5 - 0.27*x5 - 0.71),
    v5 = (1.01 + 0.14*ln(1.60 + 0.72*cos(x3)))*dot(x5) - 0.23*sin(0.89*x3 - 0.95)*dot(x2) + 0.16*exp(-powi(x3, 2)/2),
)]
#[inertia(diag((1.14 - 0.21*sin(0.45*x2 - 0.26*x1)*cos(0.59*x2)), 1.23, (1.38 - 0.13*ln(1.60 + 0.94*cos(x4))), 1.26, 1.06))]
#[forces(
    0,
    0.49*powi(v1, 2) - p2*1.00,
    0.62*powi(v4, 2) - p2*v2*v2*powi(cos(1.03*x5), 3),
    v1*sqrt(2 + powi(v1, 2)) + v5*v2/(1.16 - 0.26*exp(-powi(x2, 2)/2)) + p2*x5 + p2*v5*v5*tan(0.52*sin(x1))/2,
    p2*0.92 - 1.06*powi(v5, 2) - 1.27*v1 - p1*v1*v1*exp(-powi(x4, 2)/2),
)]
#[constraint(row1: ddot(x2) - 0.12*atan2(x2, 2 + cos(x5))/2*dot(v1) - 0.19*sin(0.60*x1)*dot(v5) + 0.58*v2*v2*sin(1.20*x3) == 0)]
#[constraint(row2: (1.50 - 0.23*tan(0.63*sin(x2))/2)*dot(v3) - 0.24*powi(cos(0.44*x3 - 0.85*x3), 3)*dot(v1) + 0.28*cos(0.98*x2)*dot(v5) + 0.41*v2 + 0.41*tan(0.96*sin(x3))/2 == 0)]
#[constraint(row3: dot(v4) - 0.15*cos(0.96*x3 + 0.42*x2)*dot(v1) - 0.25*sin(1.17*x2 + 0.53*x5 - 1.05)*dot(v5) + 0.53*wave(0.50*x1) == 0)]
#[output(place = (if x4 <= 0.43 { 0.88*sin(x5)/(1.50 + cos(x4)) } else { 1/sqrt(1.50 + powi(x5, 2)) }), power = 1.18*powi(v1, 2), push = powi(cos(0.82*x1), 3)*dot(v2) + v4*ddot(x4), pull = 1.18*reaction(row2) - push, share = pull/(1.78 + powi(reaction(row2), 2)))]
pub struct Random79 {
    #[nominal(0.72)]
    pub p1: f64,
    #[nominal(0.76)]
    pub p2: f64,
    #[nominal(1.26)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[inputs(tau)]
#[inertia(diag(1.34, (1.09 - 0.25*atan2(t, 2 + cos(x2))/2), (1.39 - 0.25*cos(1.18*x2)), (1.26 + 0.33*bump(0.55*x4 + 0.54))))]
#[forces(
    1.65*powi(dot(x4), 2),
    1.19*bump(0.62*x1 + 0.64*x4),
    p3*dot(x1)*dot(x3)*bump(0.43*t),
    dot(x4)*dot(x2)/1.03,
)]
#[constraint(row1: 1.80*x3 + 0.36*x2*x1 + 0.36*sin(x1) + 0.30*sin(0.78*t) - 0.61 == 0)]
#[constraint(row2: powi(dot(x4), 2) + 0.15*powi(dot(x2), 2) - (2 + 0.15*bump(0.98*x4 - 0.27*x1)) == 0)]
pub struct Random80 {
    #[nominal(1.25)]
    pub p1: f64,
    #[nominal(1.23)]
    pub p2: f64,
    #[nominal(1.40)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = (1.35 - 0.20*0.87*sin(x1)/(1.50 + cos(x4)))*dot(x2),
    v3 = (1.03 + 0.28*(if x4 >= 0.06 { sin(1.15*x1)*cos(1.17*x1) } else { powi(cos(0.61*x4 - 0.82*x1), 3) }))*dot(x3),
    v4 = 1.30*dot(x4) - 0.39*sin(p3*x4 - 0.91)*dot(x2),
)]
#[inertia(diag((1.13 + 0.32*1/sqrt(1.50 + powi(x2, 2))), 1.12, (1.09 + 0.30*ln(1.60 + 0.78*cos(x1))), (1.07 - 0.30*(if x1 >= 0.39 { cos(0.62*x2) } else { 1/sqrt(1.50 + powi(x4, 2)) }))))]
#[forces(
    0.44*1/sqrt(1.50 + powi(x4, 2)) - v4*v3/(1.10 + 0.11*sin(0.76*x1)),
    0.80*v2 + v4*v2/(1.02 - 0.10*x4/(1 + powi(x4, 2))),
    0.62*x4/(1 + powi(x4, 2)),
    p3*1.43 - p1*x2,
)]
#[constraint(row1: 1.74*x2 + 0.22*x1 + 0.32*sin(x3) - 0.21 == 0)]
#[constraint(row2: dot(v4) + 0.21*1/sqrt(1.50 + powi(x3, 2))*dot(v1) - 0.11*wave(1.14*x3 - 0.76*x2)*dot(v3) + 0.65*v3 + 0.65*0.56*sin(x4)/(1.50 + cos(x1)) == 0)]
#[output(place = sin(0.82*x4), power = v3*sqrt(2 + powi(v3, 2)) - 1.68*v1 - p3*x4, push = tan(0.95*sin(x2))/2*dot(v2) + v2*ddot(x2), pull = (1.05 + 0.31*atan2(x4, 2 + cos(x3))/2)*reaction(row2) - push, share = pull/(1.12 + powi(reaction(row2), 2)))]
pub struct Random81 {
    #[nominal(1.48)]
    pub p1: f64,
    #[nominal(1.19)]
    pub p2: f64,
    #[nominal(1.35)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + sin(p1*x2 - 0.76)*dot(x1),
    v3 = dot(x3) + bump(0.95*x4 + 0.62*x5)*dot(x2),
    v4 = dot(x4) + 0.58*sin(x5)/(1.50 + cos(x1))*dot(x1),
    v5 = dot(x5) + wave(0.75*t - 0.57*x4)*dot(x3),
    dot(x1) = v1,
    dot(x2) = v2 - sin(p1*x2 - 0.76)*(v1),
    dot(x3) = v3 - bump(0.95*x4 + 0.62*x5)*(v2 - sin(p1*x2 - 0.76)*(v1)),
    dot(x4) = v4 - 0.58*sin(x5)/(1.50 + cos(x1))*(v1),
    dot(x5) = v5 - wave(0.75*t - 0.57*x4)*(v3 - bump(0.95*x4 + 0.62*x5)*(v2 - sin(p1*x2 - 0.76)*(v1))),
)]
#[kinetic_energy((1.04 + 0.15*x4/(1 + powi(x4, 2)))*powi(v1, 2)/2 + (1.11 + 0.10*sin(p2*x2 + 0.25))*powi(v2, 2)/2 + (1.07 + 0.34*tan(0.88*sin(x3))/2)*powi(v3, 2)/2 + (1.12 + 0.27*atan2(x2, 2 + cos(x5))/2)*powi(v4, 2)/2 + (1.20 - 0.28*bump(0.85*x4 - 0.71*t))*powi(v5, 2)/2 - 0.33*(if t < -0.33 { sin(0.98*x4) } else { atan2(x4, 2 + cos(x1))/2 })*v2 - 0.36*exp(-powi(x1, 2)/2)*v4 + 0.54*exp(-powi(x3, 2)/2))]
#[forces(
    0,
    0,
    p1*t - v3*v5/(1.13 - 0.21*wave(1.00*x1)) - v1*sqrt(2 + powi(v5, 2)),
    1.81*v4/(1 + powi(t, 2)) - 1.03*v3/(1 + powi(x2, 2)),
    v3*sqrt(2 + powi(v1, 2)) - 0.45*v1 - 1.27*v2,
)]
#[constraint(row1: 1.38*x2 + 0.23*powi(x3, 2)/2 + 0.30*sin(0.47*t) + 0.62 == 0)]
#[constraint(row2: 1.15*v1 + 0.27*powi(cos(0.62*x1), 3)*v3 + 0.15*powi(cos(1.19*x5 + 0.41*x5 - 1.03), 3)*v2 == 0)]
#[constraint(row3: powi(v4, 2) + 0.28*powi(v2, 2) - (2 + 0.28*1/sqrt(1.50 + powi(x3, 2))) == 0)]
#[constraint(row4: 1.15*dot(v5) + 0.24*x1/(1 + powi(x1, 2))*dot(v3) + 0.20*tan(0.96*sin(x3))/2*dot(v2) + 0.49*sin(0.97*x5) == 0)]
pub struct Random82 {
    #[nominal(1.04)]
    pub p1: f64,
    #[nominal(1.12)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + wave(0.79*x2 - 0.39*x2 + 1.35)*dot(x1),
    v3 = dot(x3) + wave(1.14*x4)*dot(x2),
    v4 = dot(x4) + 0.32*sin(x3)/(1.50 + cos(x1))*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - wave(0.79*x2 - 0.39*x2 + 1.35)*(v1),
    dot(x3) = v3 - wave(1.14*x4)*(v2 - wave(0.79*x2 - 0.39*x2 + 1.35)*(v1)),
    dot(x4) = v4 - 0.32*sin(x3)/(1.50 + cos(x1))*(v1),
)]
#[inertia(matrix(
    [((1.07 - 0.17*bump(0.54*x3 - 0.79*x1)))*((1.07 - 0.17*bump(0.54*x3 - 0.79*x1))), ((1.07 - 0.17*bump(0.54*x3 - 0.79*x1)))*(0.32*bump(0.70*x4)), ((1.07 - 0.17*bump(0.54*x3 - 0.79*x1)))*(0.31*sin(p1*x1 + 0.15)), 0],
    [_, (0.32*bump(0.70*x4))*(0.32*bump(0.70*x4)) + ((1.29 - 0.11*(if x1 <= 0.03 { exp(-powi(x1, 2)/2) } else { 1/sqrt(1.50 + powi(x2, 2)) })))*((1.29 - 0.11*(if x1 <= 0.03 { exp(-powi(x1, 2)/2) } else { 1/sqrt(1.50 + powi(x2, 2)) }))), (0.32*bump(0.70*x4))*(0.31*sin(p1*x1 + 0.15)) + ((1.29 - 0.11*(if x1 <= 0.03 { exp(-powi(x1, 2)/2) } else { 1/sqrt(1.50 + powi(x2, 2)) })))*(0.34*cos(1.16*x1)), 0],
    [_, _, (0.31*sin(p1*x1 + 0.15))*(0.31*sin(p1*x1 + 0.15)) + (0.34*cos(1.16*x1))*(0.34*cos(1.16*x1)) + (1.38)*(1.38), (1.38)*(0.14*powi(cos(0.61*x1 + 0.69*x4 - 0.46), 3))],
    [_, _, _, (0.14*powi(cos(0.61*x1 + 0.69*x4 - 0.46), 3))*(0.14*powi(cos(0.61*x1 + 0.69*x4 - 0.46), 3)) + (1.23)*(1.23)],
))]
#[forces(
    p1*x3,
    1.94*cos(1.04*x1 + 0.43*x4),
    v3*v4/1.30 - v2*v3/(1.29 - 0.28*ln(1.60 + 0.68*cos(x2))),
    1.24*v4 - p1*0.59 - v1*v1/(1.06 - 0.26*0.68*sin(x4)/(1.50 + cos(x3))),
)]
#[constraint(row1: 1.89*x1 + 0.20*sin(x1) + 0.34*x4*x2 + 0.33*powi(x2, 2)/2 + 0.59 == 0)]
#[constraint(row2: 1.80*x3 + exp(0.18*x4)/2 + 0.23*powi(x2, 2)/2 + 0.13*sin(x1) - 0.70 == 0)]
#[constraint(again1: 1.43*(1.89*x1 + 0.20*sin(x1) + 0.34*x4*x2 + 0.33*powi(x2, 2)/2 + 0.59) == 0, redundant)]
#[constraint(again2: 0.70*(1.80*x3 + exp(0.18*x4)/2 + 0.23*powi(x2, 2)/2 + 0.13*sin(x1) - 0.70) + 0.35*(1.89*x1 + 0.20*sin(x1) + 0.34*x4*x2 + 0.33*powi(x2, 2)/2 + 0.59) == 0, redundant)]
#[output(place = wave(0.50*x4 - 0.55*x3), power = p1*exp(0.20*x3) - v2*v1/(1.23 - 0.26*sin(1.07*x2 - 0.83*x3)) - p1*exp(0.20*x2), push = sin(0.76*x1)*dot(v3) + v1*ddot(x1), pull = (1.21 - 0.27*sin(0.90*x2))*reaction(row1) - push, share = pull/(1.99 + powi(reaction(row1), 2)))]
pub struct Random83 {
    #[nominal(0.65)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + 1/sqrt(1.50 + powi(x3, 2))*dot(x1),
    v3 = dot(x3) + wave(0.77*t)*dot(x2),
    v4 = dot(x4) + cos(1.03*x2)*dot(x3),
    v5 = dot(x5) + wave(1.01*x3 + 0.44)*dot(x3),
    dot(x1) = v1,
    dot(x2) = v2 - 1/sqrt(1.50 + powi(x3, 2))*(v1),
    dot(x3) = v3 - wave(0.77*t)*(v2 - 1/sqrt(1.50 + powi(x3, 2))*(v1)),
    dot(x4) = v4 - cos(1.03*x2)*(v3 - wave(0.77*t)*(v2 - 1/sqrt(1.50 + powi(x3, 2))*(v1))),
    dot(x5) = v5 - wave(1.01*x3 + 0.44)*(v3 - wave(0.77*t)*(v2 - 1/sqrt(1.50 + powi(x3, 2))*(v1))),
)]
#[inertia(matrix(
    [((1.08 + 0.30*exp(-powi(x3, 2)/2)))*((1.08 + 0.30*exp(-powi(x3, 2)/2))), ((1.08 + 0.30*exp(-powi(x3, 2)/2)))*(0.25*1/sqrt(1.50 + powi(x3, 2))), ((1.08 + 0.30*exp(-powi(x3, 2)/2)))*(0.21*ln(1.60 + 0.73*cos(x2))), 0, ((1.08 + 0.30*exp(-powi(x3, 2)/2)))*(0.28*0.68*sin(x1)/(1.50 + cos(x1)))],
    [_, (0.25*1/sqrt(1.50 + powi(x3, 2)))*(0.25*1/sqrt(1.50 + powi(x3, 2))) + (1.06)*(1.06), (0.25*1/sqrt(1.50 + powi(x3, 2)))*(0.21*ln(1.60 + 0.73*cos(x2))), (1.06)*(0.10*ln(1.60 + 0.85*cos(x4))), (0.25*1/sqrt(1.50 + powi(x3, 2)))*(0.28*0.68*sin(x1)/(1.50 + cos(x1))) + (1.06)*(0.29*cos(0.57*x5))],
    [_, _, (0.21*ln(1.60 + 0.73*cos(x2)))*(0.21*ln(1.60 + 0.73*cos(x2))) + ((1.09 + 0.18*cos(0.82*x4 + 0.79*x1)))*((1.09 + 0.18*cos(0.82*x4 + 0.79*x1))), 0, (0.21*ln(1.60 + 0.73*cos(x2)))*(0.28*0.68*sin(x1)/(1.50 + cos(x1))) + ((1.09 + 0.18*cos(0.82*x4 + 0.79*x1)))*(0.31*sin(p1*x5 + 0.37))],
    [_, _, _, (0.10*ln(1.60 + 0.85*cos(x4)))*(0.10*ln(1.60 + 0.85*cos(x4))) + ((1.27 - 0.28*cos(0.55*t + 0.73*x5 - 0.81)))*((1.27 - 0.28*cos(0.55*t + 0.73*x5 - 0.81))), (0.10*ln(1.60 + 0.85*cos(x4)))*(0.29*cos(0.57*x5)) + ((1.27 - 0.28*cos(0.55*t + 0.73*x5 - 0.81)))*(0.15*bump(1.03*x5 - 0.31*x5))],
    [_, _, _, _, (0.28*0.68*sin(x1)/(1.50 + cos(x1)))*(0.28*0.68*sin(x1)/(1.50 + cos(x1))) + (0.29*cos(0.57*x5))*(0.29*cos(0.57*x5)) + (0.31*sin(p1*x5 + 0.37))*(0.31*sin(p1*x5 + 0.37)) + (0.15*bump(1.03*x5 - 0.31*x5))*(0.15*bump(1.03*x5 - 0.31*x5)) + (1.26)*(1.26)],
))]
#[forces(
    p1*1.85 + 0.85*cos(0.83*x3 - 0.94) + v1*sqrt(2 + powi(v2, 2)) + v3*v2/(1.14 + 0.35*(if x5 >= 0.10 { sin(0.88*x2)*cos(0.54*x3 + 0.55*t) } else { atan2(x2, 2 + cos(x3))/2 })),
    p2*v3*v5*(if x3 >= 0.53 { sin(0.57*x5 + 0.74*x4) } else { bump(0.92*x5 - 0.54) }),
    v4*sqrt(2 + powi(v4, 2)),
    1.88*v2 + p2*exp(0.20*x5) + 1.34*v4,
    0.70*powi(v3, 2) + 0.99*v3 + v1*sqrt(2 + powi(v1, 2)),
)]
#[constraint(row1: 1.59*x5 + 0.20*sin(x5) + 0.11*x4*x2 + 0.18*x2*x2 + 0.30*sin(1.21*t) - 0.61 == 0)]
#[constraint(row2: 1.78*x3 + 0.19*sin(x3) + 0.16*powi(x4, 2)/2 + 0.30*sin(1.37*t) + 0.41 == 0)]
#[constraint(row3: (1.50 + 0.28*tan(0.31*sin(x5))/2)*v1 + 0.31*wave(0.50*x1 + 0.66*x5)*v4 - 0.21*wave(0.79*x5)*v2 + 0.10*ln(1.60 + 0.34*cos(x5))*v5 == 0)]
pub struct Random84 {
    #[nominal(0.99)]
    pub p1: f64,
    #[nominal(0.94)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1) + 0.22*1/sqrt(1.50 + powi(x2, 2))*dot(x4) + 0.37*bump(0.81*x3),
    v2 = dot(x2) + 0.27*sin(1.18*x2)*dot(x1) + 0.24*powi(cos(0.60*x1 + 0.71*x2), 3),
    v3 = 1.15*dot(x3) - 0.29*exp(-powi(x4, 2)/2),
    v4 = dot(x4) + 0.20*(if x2 <= 0.42 { sin(0.56*x2 + 0.57*x2)*cos(0.82*x3 - 0.27*x1) } else { sin(0.48*x1 - 0.49*x4 + 0.76) })*dot(x1) + 0.44*(if x1 < -0.24 { x2/(1 + powi(x2, 2)) } else { sin(0.40*x2 + 0.58*x4)*cos(1.16*x2 + 0.36*x3) }),
)]
#[inertia(diag((1.29 - 0.17*sin(p1*x4 - 0.42)), 1.35, (1.02 - 0.13*ln(1.60 + 0.50*cos(x1))), (1.26 - 0.10*x3/(1 + powi(x3, 2)))))]
#[forces(
    p1*exp(0.20*x4) - 1.78*v2/(1 + powi(x2, 2)) - 1.98*v1,
    1.37*v3 + p1*x3,
    0,
    0.95*powi(v2, 2),
)]
#[configuration(x1 = 1.02*bump(1.17*x2 - 0.63*x2 + 0.18), x3 = 1.33*sin(0.64*x4))]
#[constraint(bound: (1.50 + 0.29*cos(0.58*x4 + 0.61*x4))*dot(v2) + 0.18*cos(1.06*x3)*dot(v4) + 0.23*(if x1 > 0.09 { 0.39*sin(x4)/(1.50 + cos(x2)) } else { 0.90*sin(x1)/(1.50 + cos(x4)) })*dot(v1) + 0.27*v1 + 0.27*cos(1.12*x1 + 0.61*x3 - 0.82) == 0)]
pub struct Random85 {
    #[nominal(1.27)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[inertia(diag(1.11, (1.28 - 0.17*1/sqrt(1.50 + powi(x5, 2))), (1.18 - 0.27*(if x1 < 0.23 { x5/(1 + powi(x5, 2)) } else { 1/sqrt(1.50 + powi(x1, 2)) })), 1.30, (1.38 + 0.25*sin(0.54*x4))))]
#[forces(
    p1*0.74 - dot(x4)*sqrt(2 + powi(dot(x2), 2)) - p3*1.42,
    1.34*powi(dot(x4), 2) + dot(x3)*dot(x5)/(1.30 + 0.16*ln(1.60 + 0.66*cos(x5))) + dot(x3)*sqrt(2 + powi(dot(x5), 2)) + dot(x1)*dot(x3)/(1.09 + 0.28*ln(1.60 + 0.35*cos(x1))),
    p2*dot(x5)*dot(x5)*(if x1 >= 0.29 { x5/(1 + powi(x5, 2)) } else { powi(cos(0.72*x5), 3) }) - p1*1.76,
    0,
    p1*1.59,
)]
#[constraint(row1: 1.59*x5 + 0.10*sin(x5) - 0.97*x4 + 0.10*cos(x4) + 0.20*x2/(1 + powi(x2, 2)) == 0)]
#[constraint(row2: (1.18 + 0.20*powi(cos(0.76*x1 - 0.30*x2 + 0.71), 3))*dot(x3) - 1.03*dot(x1) + 0.21*sin(0.71*x4)*dot(x2) - 0.19*bump(0.82*x3) == 0)]
#[independent(dot(x4), dot(x1), dot(x2))]
#[independent(dot(x5), dot(x1), dot(x2))]
#[independent(dot(x5), dot(x3), dot(x2))]
pub struct Random86 {
    #[nominal(1.33)]
    pub p1: f64,
    #[nominal(0.85)]
    pub p2: f64,
    #[nominal(1.42)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 4)]
#[coordinates(x[n])]
#[speeds(v[n])]
#[kinematics(
    dot(x[i]) = 1.03*k[i]*v[i] + 0.14*s[(i + 1) % n]*v[(i + 1) % n] + 0.32*s[i] for i in 0..n,
)]
#[define(s[i] = cos(0.48*x[i] + i/2 - 0.64 + t/2) for i in 0..n)]
#[define(r[0] = s[0]/2, r[i] = (r[i - 1] + s[i])/2 for i in 1..n)]
#[inertia(diag((1.14 + k[i]*r[i]/4) for i in 0..n))]
#[forces(
    0.61*sum(0..n, |j| sin(x[i] - x[j])*v[j]) - 0.74*k[i]*v[i] - product(0..=i, |j| s[j]) for i in 0..n,
)]
#[potential_energy(sum(1..n, |i| k[i]*powi(x[i] - x[i - 1], 2))/2 + 0.61*r[n - 1])]
pub struct Random87 {
    #[nominal(1.24)]
    pub p1: f64,
    #[nominal(1.01)]
    pub p2: f64,
    #[nominal(0.57)]
    pub p3: f64,
    #[nominal(1.08)]
    pub k: [f64; 4],
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + bump(1.17*x4)*dot(x1),
    v3 = dot(x3) + (if x4 <= 0.04 { exp(-powi(x4, 2)/2) } else { sin(0.84*x4) })*dot(x2),
    v4 = dot(x4) + cos(0.66*x4 - 0.75*x1)*dot(x1),
    v5 = dot(x5) + cos(1.08*x3 + 1.15)*dot(x3),
    v6 = dot(x6) + (if x3 < -0.55 { powi(cos(0.48*x6), 3) } else { powi(cos(0.83*x6), 3) })*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - bump(1.17*x4)*(v1),
    dot(x3) = v3 - (if x4 <= 0.04 { exp(-powi(x4, 2)/2) } else { sin(0.84*x4) })*(v2 - bump(1.17*x4)*(v1)),
    dot(x4) = v4 - cos(0.66*x4 - 0.75*x1)*(v1),
    dot(x5) = v5 - cos(1.08*x3 + 1.15)*(v3 - (if x4 <= 0.04 { exp(-powi(x4, 2)/2) } else { sin(0.84*x4) })*(v2 - bump(1.17*x4)*(v1))),
    dot(x6) = v6 - (if x3 < -0.55 { powi(cos(0.48*x6), 3) } else { powi(cos(0.83*x6), 3) })*(v2 - bump(1.17*x4)*(v1)),
)]
#[inertia(diag((1.35 - 0.31*cos(0.58*x6 - 1.33)), (1.20 - 0.12*bump(0.46*x1 - 0.65*x4 - 0.18)), (1.12 + 0.19*0.34*sin(x3)/(1.50 + cos(x3))), (1.11 + 0.28*(if x6 >= 0.58 { powi(cos(0.45*x1 + 0.44*x2), 3) } else { 0.40*sin(x3)/(1.50 + cos(x1)) })), (1.02 - 0.33*(if x4 <= -0.00 { cos(0.96*x1 - 0.33*x3 - 0.45) } else { atan2(x4, 2 + cos(x2))/2 })), (1.10 + 0.30*sin(0.79*x3))))]
#[forces(
    p2*exp(0.20*x1) - 1.99*0.42*sin(x2)/(1.50 + cos(x6)),
    0.64*sin(0.48*x5 - 0.34*x1) - p1*1.88 - p1*x3 - 1.32*v4/(1 + powi(x1, 2)),
    v4*v3/1.14 + p3*v1*v4*exp(-powi(x4, 2)/2) + 0.51*v1/(1 + powi(x2, 2)),
    p1*v1*v3*atan2(x2, 2 + cos(x4))/2 + p1*exp(0.20*x6),
    0,
    1.81*v3/(1 + powi(x1, 2)) - v1*v6/(1.28 + 0.20*sin(0.45*x5 - 0.55*x3)*cos(0.57*x1 - 0.68*x5 - 1.49)),
)]
#[output(place = sin(p2*x1 + 0.46), power = p2*v4*v3*cos(0.99*x3 + 0.21*x2 - 0.93), push = cos(1.00*x6 + 0.81*x5)*dot(v1) + v4*ddot(x4))]
pub struct Random88 {
    #[nominal(0.54)]
    pub p1: f64,
    #[nominal(0.66)]
    pub p2: f64,
    #[nominal(0.96)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = (1.30 - 0.21*exp(-powi(t, 2)/2))*dot(x1) - 0.10*bump(0.92*t),
    v2 = (1.10 - 0.29*powi(cos(0.75*x6 + 0.32*x4), 3))*dot(x2) - 0.28*cos(1.05*x3)*dot(x5) - 0.40*sin(0.87*x3)*cos(0.84*t - 1.14),
    v3 = dot(x3) + 0.29*cos(0.97*x4 - 0.58*x6 - 0.83)*dot(x6) - 0.11*sin(0.58*x6 - 1.19),
    v4 = dot(x4) + 0.28*tan(0.67*sin(x1))/2,
    v5 = 1.16*dot(x5) + 0.18*tan(0.47*sin(x1))/2*dot(x2) + 0.47*cos(0.83*x3),
    v6 = dot(x6) + 0.28*cos(1.07*x4 + 0.57)*dot(x4) - 0.20*0.90*sin(x2)/(1.50 + cos(x2)),
)]
#[define(l11 = (1.14 - 0.17*wave(0.47*x5)), l22 = 1.23, l31 = 0.24*sin(p1*x1 - 0.56), l33 = (1.04 - 0.12*exp(-powi(x2, 2)/2)), l41 = 0.16*atan2(x5, 2 + cos(x5))/2, l42 = 0.38*cos(0.55*x5), l43 = 0.28*sin(0.65*t), l44 = (1.01 + 0.22*wave(0.77*x4 + 0.73*t + 0.70)), l53 = 0.20*atan2(t, 2 + cos(x3))/2, l55 = (1.12 + 0.22*0.47*sin(x4)/(1.50 + cos(x2))), l61 = 0.35*0.32*sin(x1)/(1.50 + cos(x2)), l63 = 0.12*ln(1.60 + 0.45*cos(x6)), l65 = 0.26*exp(-powi(t, 2)/2), l66 = (1.26 - 0.22*sin(p2*x4 + 0.22)))]
#[inertia(matrix(
    [l11*l11, 0, l11*l31, l11*l41, 0, l11*l61],
    [_, l22*l22, 0, l22*l42, 0, 0],
    [_, _, l31*l31 + l33*l33, l31*l41 + l33*l43, l33*l53, l31*l61 + l33*l63],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44, l43*l53, l41*l61 + l43*l63],
    [_, _, _, _, l53*l53 + l55*l55, l53*l63 + l55*l65],
    [_, _, _, _, _, l61*l61 + l63*l63 + l65*l65 + l66*l66],
))]
#[forces(
    p1*x3 - v6*sqrt(2 + powi(v3, 2)) - p2*v3*v3*bump(0.46*t - 1.04) - p2*1.82,
    v6*v5/(1.31 - 0.10*sin(0.95*x1 + 0.86*x6)*cos(1.18*x3 + 0.85*x3)) - p1*exp(0.20*x3),
    p2*1.37 + 0.32*cos(1.00*x6 + 0.44*x3),
    p1*exp(0.20*x4) - p2*x1,
    v2*v5/(1.18 + 0.27*sin(1.05*x1 - 0.76)),
    p2*x6,
)]
#[constraint(row1: v1 - 0.33*sin(p2*x2 - 0.16)*v2 + 0.27*bump(0.54*x6 + 0.89*x4 + 0.76)*v3 + 0.15*cos(0.69*t)*v6 == 0)]
#[constraint(row2: (1.50 - 0.30*1/sqrt(1.50 + powi(x1, 2)))*v4 + 0.32*0.95*sin(t)/(1.50 + cos(x6))*v2 + 0.25*1/sqrt(1.50 + powi(x3, 2))*v3 - 0.29*exp(-powi(x3, 2)/2)*v6 + 0.36*bump(0.82*x5 + 0.31*x2 - 0.95) == 0)]
pub struct Random89 {
    #[nominal(1.42)]
    pub p1: f64,
    #[nominal(1.04)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + cos(0.42*x5 + 0.35*x1)*dot(x1),
    v3 = dot(x3) + ln(1.60 + 0.67*cos(x3))*dot(x2),
    v4 = dot(x4) + sin(0.52*x4 + 0.59*x6)*dot(x2),
    v5 = dot(x5) + sin(0.64*x3 - 0.40*x6)*dot(x4),
    v6 = dot(x6) + bump(0.56*x5 - 1.23)*dot(x4),
    dot(x1) = v1,
    dot(x2) = v2 - cos(0.42*x5 + 0.35*x1)*(v1),
    dot(x3) = v3 - ln(1.60 + 0.67*cos(x3))*(v2 - cos(0.42*x5 + 0.35*x1)*(v1)),
    dot(x4) = v4 - sin(0.52*x4 + 0.59*x6)*(v2 - cos(0.42*x5 + 0.35*x1)*(v1)),
    dot(x5) = v5 - sin(0.64*x3 - 0.40*x6)*(v4 - sin(0.52*x4 + 0.59*x6)*(v2 - cos(0.42*x5 + 0.35*x1)*(v1))),
    dot(x6) = v6 - bump(0.56*x5 - 1.23)*(v4 - sin(0.52*x4 + 0.59*x6)*(v2 - cos(0.42*x5 + 0.35*x1)*(v1))),
)]
#[define(l11 = (1.08 - 0.12*sin(0.90*x6 + 0.33*x6)), l22 = (1.17 + 0.25*1/sqrt(1.50 + powi(x1, 2))), l31 = 0.15*sin(0.68*x3 + 0.65*x1), l32 = 0.14*cos(0.92*x1 - 0.64*x1), l33 = (1.07 - 0.35*sin(1.15*x1 + 0.37*x5)), l42 = 0.39*ln(1.60 + 0.35*cos(x3)), l43 = 0.11*(if x4 <= -0.06 { wave(0.59*x3 - 0.21*x6 - 0.61) } else { sin(1.06*x4 + 0.80*x1) }), l44 = 1.01, l52 = 0.36*cos(0.87*x3 - 0.78), l55 = 1.13, l61 = 0.22*sin(0.71*x4 - 0.65*x4 - 0.70)*cos(0.80*x4), l63 = 0.37*sin(1.01*x5 - 0.88*x5), l66 = (1.30 + 0.18*tan(0.55*sin(x3))/2))]
#[kinetic_energy(powi(l11*v1 + l31*v3 + l61*v6, 2)/2 + powi(l22*v2 + l32*v3 + l42*v4 + l52*v5, 2)/2 + powi(l33*v3 + l43*v4 + l63*v6, 2)/2 + powi(l44*v4, 2)/2 + powi(l55*v5, 2)/2 + powi(l66*v6, 2)/2 + 0.38*(if x5 < 0.57 { powi(cos(0.56*x4 + 0.31*x4), 3) } else { 1/sqrt(1.50 + powi(x4, 2)) })*v2 - 0.26*exp(-powi(x1, 2)/2))]
#[forces(
    p2*exp(0.20*x5) + v2*v3/1.17,
    p2*exp(0.20*x3) + p1*v1*v3*bump(0.83*x1) + p2*x6 + p1*x1,
    tau*0.31 + 1.63*powi(v2, 2) + p1*exp(0.20*x4) + v3*sqrt(2 + powi(v4, 2)),
    0.53*v4 - v6*sqrt(2 + powi(v4, 2)),
    1.90*v4/(1 + powi(x2, 2)),
    0.49*v2/(1 + powi(x6, 2)) - 1.55*v6,
)]
#[potential_energy(bump(0.74*x4 + 0.56*x2))]
#[constraint(row1: 1.66*x4 + 0.19*sin(x4) + 0.16*powi(x2, 2)/2 + 0.36*x3*x2 + 0.26*x1*x2 - 0.46 == 0)]
#[output(place = (if x1 <= 0.13 { sin(0.80*x1 - 0.40*x6)*cos(0.96*x4) } else { wave(0.51*x3) }), power = p2*v3*v3*(if x6 < 0.29 { cos(1.13*x5 + 0.51*x3) } else { sin(0.88*x4 + 0.87*x1)*cos(0.77*x2) }) + 0.98*(if x5 >= -0.06 { cos(0.52*x1 - 0.65*x4 - 1.11) } else { atan2(x1, 2 + cos(x5))/2 }) + p1*exp(0.20*x1) + 0.69*v3, push = sin(0.71*x4 + 0.87*x5)*dot(v1) + v4*ddot(x4), pull = (1.24 - 0.24*1/sqrt(1.50 + powi(x6, 2)))*reaction(row1) - push, share = pull/(1.64 + powi(reaction(row1), 2)))]
pub struct Random90 {
    #[nominal(0.58)]
    pub p1: f64,
    #[nominal(0.95)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + atan2(x5, 2 + cos(x5))/2*dot(x1),
    v3 = dot(x3) + (if x4 >= -0.57 { bump(0.96*x2 + 0.76*x4) } else { sin(0.98*x4) })*dot(x1),
    v4 = dot(x4) + sin(0.59*x4 - 0.42*x3)*dot(x2),
    v5 = dot(x5) + cos(1.14*x2)*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - atan2(x5, 2 + cos(x5))/2*(v1),
    dot(x3) = v3 - (if x4 >= -0.57 { bump(0.96*x2 + 0.76*x4) } else { sin(0.98*x4) })*(v1),
    dot(x4) = v4 - sin(0.59*x4 - 0.42*x3)*(v2 - atan2(x5, 2 + cos(x5))/2*(v1)),
    dot(x5) = v5 - cos(1.14*x2)*(v2 - atan2(x5, 2 + cos(x5))/2*(v1)),
)]
#[define(l11 = (1.13 + 0.20*bump(1.06*x3 - 0.34*x5)), l22 = 1.25, l32 = 0.22*powi(cos(0.41*x2), 3), l33 = (1.17 + 0.20*sin(1.02*x3)), l41 = 0.30*t/(1 + powi(t, 2)), l43 = 0.15*wave(0.51*x1 + 0.26*x4), l44 = (1.26 - 0.14*ln(1.60 + 0.39*cos(x4))), l53 = 0.11*sin(0.93*x4 + 0.51*x4 - 0.24)*cos(0.95*t + 0.48*x2), l55 = (1.31 + 0.24*sin(0.95*x1 - 0.32*x5 + 0.67)))]
#[kinetic_energy(powi(l11*v1 + l41*v4, 2)/2 + powi(l22*v2 + l32*v3, 2)/2 + powi(l33*v3 + l43*v4 + l53*v5, 2)/2 + powi(l44*v4, 2)/2 + powi(l55*v5, 2)/2 + 0.22*(if x4 > -0.36 { sin(0.90*x1 - 0.32*x4)*cos(0.51*x3 + 0.37*t) } else { x1/(1 + powi(x1, 2)) })*v1 - 0.64*cos(0.66*x2)*v3 - 0.65*powi(cos(0.44*x4 - 0.80*x1), 3)*v4 - 0.46*ln(1.60 + 0.83*cos(x2)))]
#[forces(
    0,
    1.16*v5 - 1.07*powi(v2, 2) - v5*sqrt(2 + powi(v1, 2)) - 1.17*powi(v2, 2),
    0.67*v1 - p1*1.38,
    v4*v3/(1.29 + 0.23*cos(0.47*x3 - 1.40)) - 1.34*bump(0.80*x3),
    0.66*powi(v3, 2) - p1*x2 - 1.94*v1,
)]
#[constraint(row1: 1.77*x5 + 0.29*sin(x5) + 0.18*powi(x1, 2)/2 + 0.30*sin(1.30*t) - 0.53 == 0)]
#[constraint(row2: v3 - 0.27*ln(1.60 + 0.76*cos(x2))*v1 - 0.31*atan2(x1, 2 + cos(x2))/2*v4 - 0.18*exp(-powi(x2, 2)/2)*v5 == 0)]
#[constraint(row3: v2 - 0.29*sin(0.45*t - 0.81*x5 + 0.66)*v1 + 0.26*sin(0.74*x1 - 0.35*x5)*v4 - 0.24*sin(0.41*x4 - 1.41)*v5 == 0)]
pub struct Random91 {
    #[nominal(0.65)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = (1.34 + 0.33*powi(cos(0.54*x1 + 0.33*x5), 3))*dot(x1) + 0.26*cos(0.98*x5)*dot(x2) + 0.12*powi(cos(0.47*x6 - 0.29*x3 - 0.38), 3),
    v2 = dot(x2) - 0.14*tan(0.67*sin(x2))/2*dot(x1) - 0.60*powi(cos(1.11*x6), 3),
    v3 = dot(x3) + 0.17*sin(0.91*x3 + 0.30*x5)*dot(x5) - 0.24*(if x1 >= 0.39 { sin(0.88*x6) } else { bump(1.06*x6 - 0.31*x5 - 0.91) }),
    v4 = (1.06 - 0.17*sin(0.96*x5 - 0.78*x5))*dot(x4) - 0.40*sin(1.10*x3 + 0.47*x2)*cos(0.71*x1 - 0.57*x5),
    v5 = 1.15*dot(x5) - 0.14*powi(cos(0.67*x5 + 0.33*x6), 3),
    v6 = 1.00*dot(x6) - 0.38*sin(0.59*x2)*dot(x5) - 0.22*sin(0.94*x4 + 1.20),
)]
#[kinetic_energy((1.01 - 0.14*exp(-powi(x5, 2)/2))*powi(v1, 2)/2 + (1.37 - 0.27*0.63*sin(x5)/(1.50 + cos(x6)))*powi(v2, 2)/2 + (1.39 - 0.11*cos(1.08*x5))*powi(v3, 2)/2 + (1.40 - 0.30*sin(1.01*x2)*cos(1.03*x2 - 0.86))*powi(v4, 2)/2 + (1.19 + 0.29*exp(-powi(x1, 2)/2))*powi(v5, 2)/2 + (1.35 - 0.17*(if x3 < -0.43 { bump(0.94*x3 + 0.17) } else { exp(-powi(x3, 2)/2) }))*powi(v6, 2)/2 - 0.68*atan2(x6, 2 + cos(x5))/2*v2 + 0.34*cos(0.80*x2)*v4 + 0.55*x1/(1 + powi(x1, 2))*v6)]
#[forces(
    1.16*v2 + 1.27*powi(v3, 2),
    1.96*powi(v3, 2) - 0.80*sin(0.62*x4 - 0.81*x4)*cos(0.63*x5 + 0.58*x3) - 0.35*powi(v1, 2),
    0.69*powi(v4, 2) - v6*v2/(1.26 - 0.12*1/sqrt(1.50 + powi(x6, 2))) - p1*1.57,
    p1*exp(0.20*x5) - p1*1.06 - p1*0.75,
    p1*exp(0.20*x3) + 1.86*v1/(1 + powi(x5, 2)) + 1.57*powi(v3, 2) + 0.89*powi(v2, 2),
    1.34*powi(v6, 2) + v6*sqrt(2 + powi(v1, 2)) + 1.96*powi(v4, 2) + v6*sqrt(2 + powi(v6, 2)),
)]
#[potential_energy(sin(p1*x5 + 0.46))]
#[constraint(height: 1.45*x5 + 0.25*sin(x5) + 0.39*x6 + 0.38 == 0)]
#[constraint(height_rate: 1.45*dot(x5) + 0.25*cos(x5)*dot(x5) + 0.39*dot(x6) == 0)]
#[constraint(further: v2 + 0.24*ln(1.60 + 0.93*cos(x6))*v6 == 0)]
#[output(place = 1/sqrt(1.50 + powi(x4, 2)), power = v2*sqrt(2 + powi(v3, 2)) + v2*v3/(1.31 - 0.13*1/sqrt(1.50 + powi(x5, 2))), push = ln(1.60 + 0.99*cos(x6))*dot(v6) + v6*ddot(x6))]
pub struct Random92 {
    #[nominal(1.19)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[inputs(tau)]
#[kinematics(
    v1 = 1.33*dot(x1) + 0.30*sin(1.19*x6)*cos(0.85*x5 + 0.42*x5 - 0.86)*dot(x6) - 0.21*tan(1.00*sin(x5))/2,
    v2 = dot(x2) + 0.22*bump(0.50*x4)*dot(x3) + 0.56*(if x1 > 0.50 { sin(p1*x2 - 0.54) } else { 0.94*sin(x3)/(1.50 + cos(x6)) }),
    v3 = dot(x3) - 0.19*(if x5 < -0.49 { 0.72*sin(x6)/(1.50 + cos(x2)) } else { wave(0.69*x6 - 0.59*x2 + 0.58) }),
    v4 = dot(x4) + 0.21*sin(0.82*x3)*cos(0.86*x5 + 0.80*x3 - 0.55)*dot(x1) - 0.52*cos(0.97*x5 + 0.17),
    v5 = dot(x5) + 0.21*sin(0.94*x2)*cos(0.88*x2 - 0.75*x2 - 0.22)*dot(x4) + 0.54*cos(0.78*x4 + 0.71*x6 + 0.41),
    v6 = 1.25*dot(x6) - 0.18*exp(-powi(x3, 2)/2)*dot(x3) - 0.38*cos(0.93*x6 - 0.64),
)]
#[define(l11 = 1.22, l21 = 0.23*sin(p3*x4 - 0.22), l22 = 1.18, l31 = 0.38*(if x6 > -0.37 { sin(0.52*x6 - 0.68*x2)*cos(0.86*x6 - 1.41) } else { tan(0.90*sin(x2))/2 }), l32 = 0.26*atan2(x2, 2 + cos(x2))/2, l33 = (1.05 - 0.20*(if x1 > 0.35 { cos(1.16*x5 + 0.45*x3) } else { wave(0.44*x5) })), l42 = 0.16*ln(1.60 + 0.98*cos(x1)), l44 = (1.27 - 0.12*exp(-powi(x2, 2)/2)), l51 = 0.33*1/sqrt(1.50 + powi(x3, 2)), l52 = 0.34*sin(0.48*x3), l53 = 0.38*sin(0.66*x2 - 0.55*x4)*cos(1.19*x4), l54 = 0.13*sin(0.88*x4 - 0.62*x2), l55 = (1.16 + 0.34*1/sqrt(1.50 + powi(x1, 2))), l61 = 0.23*0.50*sin(x5)/(1.50 + cos(x3)), l62 = 0.32*wave(0.41*x2 - 0.20*x4 - 1.29), l64 = 0.14*x2/(1 + powi(x2, 2)), l66 = (1.30 + 0.22*1/sqrt(1.50 + powi(x3, 2))))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, 0, l11*l51, l11*l61],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l22*l42, l21*l51 + l22*l52, l21*l61 + l22*l62],
    [_, _, l31*l31 + l32*l32 + l33*l33, l32*l42, l31*l51 + l32*l52 + l33*l53, l31*l61 + l32*l62],
    [_, _, _, l42*l42 + l44*l44, l42*l52 + l44*l54, l42*l62 + l44*l64],
    [_, _, _, _, l51*l51 + l52*l52 + l53*l53 + l54*l54 + l55*l55, l51*l61 + l52*l62 + l54*l64],
    [_, _, _, _, _, l61*l61 + l62*l62 + l64*l64 + l66*l66],
))]
#[forces(
    0,
    v1*sqrt(2 + powi(v4, 2)) + tau*1.85,
    1.55*v1/(1 + powi(x3, 2)) + tau*0.49,
    0.39*v5 - 1.43*sin(0.70*x6 + 0.22),
    tau*1.72 - p1*v5*v2*(if x6 < 0.37 { cos(0.68*x2 - 0.81*x1) } else { cos(0.76*x2) }) - v3*v2/1.13,
    1.65*powi(v1, 2) + p1*exp(0.20*x4),
)]
#[potential_energy(wave(1.10*x6 - 0.78))]
#[constraint(height: 1.58*x2 + 0.14*sin(x2) + 0.33*x5*x1 + 0.39*powi(x4, 2)/2 + 0.21*x1 - 0.38 == 0)]
#[constraint(first: 1.03*v3 + 0.19*bump(1.13*x6)*v5 + 0.25*(if x5 >= -0.27 { bump(0.66*x1 - 0.63*x4) } else { cos(1.01*x6 - 0.70*x2) })*v4 - 0.52*(if x2 >= 0.54 { cos(0.91*x3 - 0.61*x5) } else { tan(0.86*sin(x6))/2 }) == 0)]
#[constraint(second: 1.58*dot(x2) + 0.14*cos(x2)*dot(x2) + 0.33*(dot(x5)*x1 + x5*dot(x1)) + 0.39*x4*dot(x4) + 0.21*dot(x1) - 0.50*1/sqrt(1.50 + powi(x6, 2))*(1.03*v3 + 0.19*bump(1.13*x6)*v5 + 0.25*(if x5 >= -0.27 { bump(0.66*x1 - 0.63*x4) } else { cos(1.01*x6 - 0.70*x2) })*v4 - 0.52*(if x2 >= 0.54 { cos(0.91*x3 - 0.61*x5) } else { tan(0.86*sin(x6))/2 })) == 0)]
pub struct Random93 {
    #[nominal(1.00)]
    pub p1: f64,
    #[nominal(1.12)]
    pub p2: f64,
    #[nominal(0.60)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = 1.39*dot(x1) + 0.31*0.41*sin(x3)/(1.50 + cos(t))*dot(x5) - 0.54*1/sqrt(1.50 + powi(x2, 2)),
    v2 = dot(x2) - 0.42*0.33*sin(x2)/(1.50 + cos(x1)),
    v3 = (1.30 + 0.29*powi(cos(0.40*x1 + 0.89*x2 - 0.25), 3))*dot(x3) + 0.26*cos(0.99*t + 1.39)*dot(x2) + 0.34*(if t >= -0.42 { cos(0.87*t + 0.42*x2) } else { cos(0.88*t + 0.97) }),
    v4 = dot(x4) + 0.35*wave(0.96*x5 - 0.22*x2),
    v5 = dot(x5) + 0.18*bump(0.89*x2)*dot(x4) + 0.42*sin(0.93*x3 + 0.59*t),
)]
#[inertia(diag(1.32, 1.05, (1.00 + 0.34*ln(1.60 + 0.77*cos(x1))), 1.31, (1.04 + 0.22*bump(0.91*x4))))]
#[forces(
    0,
    1.97*powi(v5, 2) - 1.90*v1/(1 + powi(x3, 2)) - 1.18*v2/(1 + powi(x2, 2)) - 0.49*v1,
    v1*sqrt(2 + powi(v2, 2)) - p2*x3 - v4*v2/1.20 - 1.17*v4,
    0.31*powi(v5, 2) - 1.68*v2 - p1*v5*v3*sin(1.08*x3 - 0.50*x4) - v4*sqrt(2 + powi(v2, 2)),
    p2*exp(0.20*t) + 1.28*v2 + v5*sqrt(2 + powi(v1, 2)),
)]
#[configuration(x1 = 1.14*sin(p1*t + 0.23))]
#[constraint(held_x1: x1 - (1.14*sin(p1*t + 0.23)) == 0)]
pub struct Random94 {
    #[nominal(1.02)]
    pub p1: f64,
    #[nominal(1.00)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = (1.11 + 0.24*(if x2 <= -0.18 { wave(1.00*x1 - 0.30*x2) } else { 1/sqrt(1.50 + powi(x5, 2)) }))*dot(x1) + 0.11*wave(0.74*x3 - 0.11)*dot(x4) + 0.58*wave(0.53*x5 + 0.49*x4),
    v2 = 1.10*dot(x2) - 0.15*tan(0.67*sin(x4))/2*dot(x1) + 0.35*sin(0.89*x1 - 0.23)*cos(0.64*x3 - 0.75*x2 + 0.29),
    v3 = dot(x3) - 0.32*powi(cos(0.48*x4), 3)*dot(x2) - 0.36*bump(0.93*x2),
    v4 = (1.04 + 0.32*0.64*sin(x1)/(1.50 + cos(x4)))*dot(x4) + 0.12*sin(0.56*x3 + 0.72*x5)*dot(x1) - 0.57*x4/(1 + powi(x4, 2)),
    v5 = (1.02 + 0.31*sin(0.95*x1 - 0.20*x2))*dot(x5) - 0.30*sin(0.43*x2 + 0.69*x2)*dot(x4) - 0.20*sin(0.64*x4),
)]
#[inertia(matrix(
    [((1.20 - 0.29*1/sqrt(1.50 + powi(x1, 2))))*((1.20 - 0.29*1/sqrt(1.50 + powi(x1, 2)))), ((1.20 - 0.29*1/sqrt(1.50 + powi(x1, 2))))*(0.24*sin(p1*x4 - 0.93)), ((1.20 - 0.29*1/sqrt(1.50 + powi(x1, 2))))*(0.31*powi(cos(1.20*x3 + 0.44*x3 + 0.60), 3)), ((1.20 - 0.29*1/sqrt(1.50 + powi(x1, 2))))*(0.34*cos(1.03*x3 - 0.68)), 0],
    [_, (0.24*sin(p1*x4 - 0.93))*(0.24*sin(p1*x4 - 0.93)) + ((1.12 + 0.20*ln(1.60 + 0.75*cos(x3))))*((1.12 + 0.20*ln(1.60 + 0.75*cos(x3)))), (0.24*sin(p1*x4 - 0.93))*(0.31*powi(cos(1.20*x3 + 0.44*x3 + 0.60), 3)) + ((1.12 + 0.20*ln(1.60 + 0.75*cos(x3))))*(0.18*x2/(1 + powi(x2, 2))), (0.24*sin(p1*x4 - 0.93))*(0.34*cos(1.03*x3 - 0.68)) + ((1.12 + 0.20*ln(1.60 + 0.75*cos(x3))))*(0.14*ln(1.60 + 0.38*cos(x3))), ((1.12 + 0.20*ln(1.60 + 0.75*cos(x3))))*(0.17*ln(1.60 + 0.73*cos(x4)))],
    [_, _, (0.31*powi(cos(1.20*x3 + 0.44*x3 + 0.60), 3))*(0.31*powi(cos(1.20*x3 + 0.44*x3 + 0.60), 3)) + (0.18*x2/(1 + powi(x2, 2)))*(0.18*x2/(1 + powi(x2, 2))) + ((1.13 - 0.27*sin(0.51*x2 - 0.90*x4 - 1.36)))*((1.13 - 0.27*sin(0.51*x2 - 0.90*x4 - 1.36))), (0.31*powi(cos(1.20*x3 + 0.44*x3 + 0.60), 3))*(0.34*cos(1.03*x3 - 0.68)) + (0.18*x2/(1 + powi(x2, 2)))*(0.14*ln(1.60 + 0.38*cos(x3))), (0.18*x2/(1 + powi(x2, 2)))*(0.17*ln(1.60 + 0.73*cos(x4)))],
    [_, _, _, (0.34*cos(1.03*x3 - 0.68))*(0.34*cos(1.03*x3 - 0.68)) + (0.14*ln(1.60 + 0.38*cos(x3)))*(0.14*ln(1.60 + 0.38*cos(x3))) + ((1.29 - 0.32*atan2(x2, 2 + cos(x5))/2))*((1.29 - 0.32*atan2(x2, 2 + cos(x5))/2)), (0.14*ln(1.60 + 0.38*cos(x3)))*(0.17*ln(1.60 + 0.73*cos(x4))) + ((1.29 - 0.32*atan2(x2, 2 + cos(x5))/2))*(0.30*ln(1.60 + 0.75*cos(x4)))],
    [_, _, _, _, (0.17*ln(1.60 + 0.73*cos(x4)))*(0.17*ln(1.60 + 0.73*cos(x4))) + (0.30*ln(1.60 + 0.75*cos(x4)))*(0.30*ln(1.60 + 0.75*cos(x4))) + ((1.21 + 0.28*ln(1.60 + 0.84*cos(x5))))*((1.21 + 0.28*ln(1.60 + 0.84*cos(x5))))],
))]
#[forces(
    p2*1.31 - p1*x1 - 0.31*bump(0.42*x2 + 0.21*x1),
    0,
    1.37*(if x5 < -0.56 { cos(1.03*x4) } else { sin(0.62*x2 + 1.29) }) - v2*sqrt(2 + powi(v4, 2)),
    p2*v1*v5*1/sqrt(1.50 + powi(x4, 2)) + p1*exp(0.20*x3),
    1.66*tan(0.96*sin(x2))/2 - v2*v4/(1.16 - 0.32*ln(1.60 + 0.58*cos(x2))) - p2*v4*v5*sin(0.79*x2 + 0.85*x3) - v3*v5/(1.32 - 0.16*1/sqrt(1.50 + powi(x5, 2))),
)]
#[configuration(of(q1), x5 = 1.25*q1, x1 = cos(0.73*q1 - 0.61*q1), x4 = (if q1 >= 0.04 { bump(1.06*q1) } else { cos(1.04*q1) }), x3 = sin(0.57*q1 + 0.83*q1)*cos(0.62*q1), x2 = cos(1.01*q1 - 0.23*q1))]
#[constraint(held_x1: x1 - (cos(0.73*(x5/1.25) - 0.61*(x5/1.25))) == 0)]
#[constraint(held_x4: x4 - ((if (x5/1.25) >= 0.04 { bump(1.06*(x5/1.25)) } else { cos(1.04*(x5/1.25)) })) == 0)]
#[constraint(held_x3: x3 - (sin(0.57*(x5/1.25) + 0.83*(x5/1.25))*cos(0.62*(x5/1.25))) == 0)]
#[constraint(held_x2: x2 - (cos(1.01*(x5/1.25) - 0.23*(x5/1.25))) == 0)]
#[output(place = sin(p1*x5 + 0.92), power = p1*exp(0.20*x4) + v5*sqrt(2 + powi(v1, 2)) + p2*v5*v4*sin(0.90*x5)*cos(0.63*x5 - 0.62), push = wave(0.84*x1 - 0.60*x2)*dot(v2) + v1*ddot(x1), pull = 1.36*reaction(held_x1) - push, share = pull/(1.30 + powi(reaction(held_x1), 2)))]
pub struct Random95 {
    #[nominal(1.09)]
    pub p1: f64,
    #[nominal(1.00)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[define(l11 = (1.26 - 0.20*(if x1 >= 0.40 { tan(0.93*sin(t))/2 } else { tan(0.69*sin(t))/2 })), l21 = 0.13*1/sqrt(1.50 + powi(x4, 2)), l22 = (1.08 - 0.17*1/sqrt(1.50 + powi(x1, 2))), l32 = 0.14*ln(1.60 + 0.57*cos(x1)), l33 = (1.26 - 0.14*0.94*sin(x2)/(1.50 + cos(x2))), l41 = 0.29*powi(cos(0.66*x1 + 1.12), 3), l42 = 0.20*tan(0.57*sin(x3))/2, l44 = (1.19 + 0.34*cos(1.07*x3)), l52 = 0.40*bump(0.54*t), l53 = 0.29*1/sqrt(1.50 + powi(x5, 2)), l55 = (1.38 + 0.30*cos(0.72*t)))]
#[inertia(matrix(
    [l11*l11, l11*l21, 0, l11*l41, 0],
    [_, l21*l21 + l22*l22, l22*l32, l21*l41 + l22*l42, l22*l52],
    [_, _, l32*l32 + l33*l33, l32*l42, l32*l52 + l33*l53],
    [_, _, _, l41*l41 + l42*l42 + l44*l44, l42*l52],
    [_, _, _, _, l52*l52 + l53*l53 + l55*l55],
))]
#[forces(
    p1*exp(0.20*x3),
    1.35*exp(-powi(x4, 2)/2) - 0.68*powi(dot(x1), 2),
    0.78*dot(x3) + 0.81*powi(dot(x2), 2) + p1*dot(x3)*dot(x1)*cos(0.53*x4),
    dot(x3)*sqrt(2 + powi(dot(x2), 2)) - p3*x1 - dot(x3)*dot(x3)/(1.18 + 0.22*1/sqrt(1.50 + powi(x1, 2))) - p2*dot(x3)*dot(x3)*ln(1.60 + 0.83*cos(x1)),
    p3*exp(0.20*x5) - p3*1.37 - 1.47*0.68*sin(x4)/(1.50 + cos(x2)) - 1.45*powi(dot(x1), 2),
)]
#[configuration(x1 = 0.94*tan(0.47*sin(x5))/2, x4 = 1.42*0.99*sin(t)/(1.50 + cos(x5)))]
#[constraint(rolling: dot(x5) - 0.29*sin(p2*x3 + 0.20)*dot(x3) - 0.30*sin(1.17*x5 + 0.73*x5)*cos(0.80*x5)*dot(x2) == 0)]
pub struct Random96 {
    #[nominal(1.36)]
    pub p1: f64,
    #[nominal(0.69)]
    pub p2: f64,
    #[nominal(0.68)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    dot(x1) = 1.05*v1 - 0.13*sin(p1*x2 + 0.21)*v5,
    dot(x2) = 1.30*v2 + 0.32*tan(0.83*sin(x2))/2*v5,
    dot(x3) = v3 + 0.36*x1/(1 + powi(x1, 2))*v1,
    dot(x4) = v4 - 0.24*x2/(1 + powi(x2, 2))*v2,
    dot(x5) = (1.36 - 0.18*bump(1.16*x2 + 0.74*x4))*v5,
)]
#[define(l11 = (1.23 + 0.35*powi(cos(0.76*x1), 3)), l21 = 0.21*sin(0.71*x3)*cos(0.62*x5 - 0.33*x5), l22 = 1.26, l31 = 0.14*wave(0.96*x4 + 0.88), l33 = 1.31, l41 = 0.38*wave(1.02*x5), l42 = 0.16*tan(0.43*sin(x4))/2, l43 = 0.27*tan(0.51*sin(x5))/2, l44 = (1.10 + 0.35*x4/(1 + powi(x4, 2))), l51 = 0.24*sin(0.87*x5), l53 = 0.23*(if x1 >= -0.12 { sin(0.45*x2 - 0.20*x4 + 0.85) } else { cos(1.07*x3 + 0.14) }), l54 = 0.20*sin(1.18*x5), l55 = (1.07 + 0.27*1/sqrt(1.50 + powi(x4, 2))))]
#[kinetic_energy(powi(l11*v1 + l21*v2 + l31*v3 + l41*v4 + l51*v5, 2)/2 + powi(l22*v2 + l42*v4, 2)/2 + powi(l33*v3 + l43*v4 + l53*v5, 2)/2 + powi(l44*v4 + l54*v5, 2)/2 + powi(l55*v5, 2)/2 - 0.46*sin(0.80*x2)*v2 + 0.70*cos(1.16*x1)*v3 + 0.35*cos(0.97*x4)*v4 - 0.44*powi(cos(1.14*x2 - 0.40), 3))]
#[forces(
    p1*0.51 - p1*x2 - 0.98*v4 - p1*exp(0.20*x1),
    p1*x1 + p1*x3,
    0.87*v5 + v2*v2/(1.39 + 0.33*ln(1.60 + 0.68*cos(x2))) + p1*1.08,
    0,
    v2*sqrt(2 + powi(v5, 2)) + v4*sqrt(2 + powi(v4, 2)) + p1*exp(0.20*x2),
)]
#[constraint(row1: v3 + 0.49*atan2(x5, 2 + cos(x4))/2*v5 == 0)]
#[constraint(row2: v1 + 0.46*ln(1.60 + 0.99*cos(x5))*v5 == 0)]
#[constraint(row3: v2 + 0*v5 == 0)]
#[constraint(row4: v4 + 0.61*bump(0.57*x3 - 0.71*x1 - 1.19)*v5 == 0)]
#[complement(
    w1 = [-(1.22 + 0.32*0.68*sin(x1)/(1.50 + cos(x1)))*(0.46*ln(1.60 + 0.99*cos(x5))), -(1.22 + 0.32*0.68*sin(x1)/(1.50 + cos(x1)))*(0), -(1.22 + 0.32*0.68*sin(x1)/(1.50 + cos(x1)))*(0.49*atan2(x5, 2 + cos(x4))/2), -(1.22 + 0.32*0.68*sin(x1)/(1.50 + cos(x1)))*(0.61*bump(0.57*x3 - 0.71*x1 - 1.19)), (1.22 + 0.32*0.68*sin(x1)/(1.50 + cos(x1)))],
)]
pub struct Random97 {
    #[nominal(0.61)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[kinetic_energy((1.17 + 0.31*sin(1.02*x3 - 0.78*x2))*powi(dot(x1), 2)/2 + (1.24 + 0.25*sin(0.66*x1 + 0.72*x3)*cos(1.12*x2 - 0.67))*powi(dot(x2), 2)/2 + (1.31 + 0.25*sin(0.95*x3 - 1.24))*powi(dot(x3), 2)/2 + (1.16 - 0.29*wave(0.94*x4 - 0.77*x1))*powi(dot(x4), 2)/2 + (1.24 - 0.22*wave(1.08*x2 - 0.34))*powi(dot(x5), 2)/2 + 1.38*powi(dot(x6), 2)/2 - 0.48*(if x6 <= 0.42 { tan(0.59*sin(x6))/2 } else { 0.81*sin(x2)/(1.50 + cos(x4)) })*dot(x1) - 0.41*sin(0.49*x3)*dot(x2) - 0.51*atan2(x3, 2 + cos(x4))/2*dot(x6) - 0.37*0.48*sin(x3)/(1.50 + cos(x3)))]
#[forces(
    0.43*dot(x4) + 1.90*cos(0.71*x3 + 0.43*x5) + 1.82*powi(dot(x2), 2),
    dot(x6)*sqrt(2 + powi(dot(x1), 2)),
    0.83*dot(x4),
    p1*dot(x1)*dot(x3)*(if x4 <= 0.51 { ln(1.60 + 0.97*cos(x3)) } else { sin(0.81*x6 - 0.52*x3) }) + dot(x1)*dot(x3)/(1.13 - 0.27*atan2(x3, 2 + cos(x6))/2),
    0.33*sin(0.84*x3 + 0.81*x5)*cos(0.57*x2),
    p1*x1 + 0.92*dot(x6)/(1 + powi(x5, 2)) + dot(x6)*dot(x2)/1.07 + dot(x1)*dot(x2)/(1.39 - 0.15*x4/(1 + powi(x4, 2))),
)]
#[constraint(row1: 1.39*x2 + 0.16*sin(x2) + 0.11*sin(x6) + 0.76 == 0)]
#[constraint(row2: 1.82*x3 + 0.30*x6 + 0.32*x2*x2 - 0.78 == 0)]
#[constraint(row3: dot(x4) + 0.35*exp(-powi(x5, 2)/2)*dot(x6) + 0.28*ln(1.60 + 0.87*cos(x4))*dot(x2) - 0.29*tan(0.55*sin(x1))/2*dot(x3) == 0)]
#[constraint(row4: dot(x5) - 0.13*(if x5 <= -0.31 { sin(1.11*x2)*cos(0.78*x5 + 0.50) } else { sin(p1*x5 + 0.13) })*dot(x6) + 0.21*sin(0.78*x4)*cos(1.11*x3)*dot(x2) + 0.30*ln(1.60 + 0.49*cos(x3))*dot(x3) == 0)]
#[constraint(row5: (1.50 + 0.15*(if x6 <= -0.10 { cos(0.72*x3 + 0.22*x4 - 0.35) } else { sin(p1*x5 + 0.52) }))*dot(x1) - 0.18*sin(0.49*x1 + 0.36*x3)*cos(0.92*x6 + 0.25*x2)*dot(x6) + 0.34*tan(0.97*sin(x5))/2*dot(x2) == 0)]
pub struct Random98 {
    #[nominal(1.11)]
    pub p1: f64,
    #[nominal(1.43)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + 0.52*sin(x6)/(1.50 + cos(x1))*dot(x1),
    v3 = dot(x3) + sin(p2*x2 + 0.18)*dot(x2),
    v4 = dot(x4) + bump(0.97*x3)*dot(x1),
    v5 = dot(x5) + powi(cos(1.18*x6 + 0.51*x6), 3)*dot(x4),
    v6 = dot(x6) + ln(1.60 + 0.78*cos(x3))*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - 0.52*sin(x6)/(1.50 + cos(x1))*(v1),
    dot(x3) = v3 - sin(p2*x2 + 0.18)*(v2 - 0.52*sin(x6)/(1.50 + cos(x1))*(v1)),
    dot(x4) = v4 - bump(0.97*x3)*(v1),
    dot(x5) = v5 - powi(cos(1.18*x6 + 0.51*x6), 3)*(v4 - bump(0.97*x3)*(v1)),
    dot(x6) = v6 - ln(1.60 + 0.78*cos(x3))*(v2 - 0.52*sin(x6)/(1.50 + cos(x1))*(v1)),
)]
#[inertia(diag((1.27 - 0.19*sin(p2*x6 + 0.78)), (1.19 + 0.19*cos(1.11*x6 - 0.86*x5 - 0.35)), 1.13, 1.37, 1.30, (1.16 + 0.12*powi(cos(0.61*x5), 3))))]
#[forces(
    1.27*v6/(1 + powi(x2, 2)) - p2*exp(0.20*x1) - 0.69*v2/(1 + powi(t, 2)),
    p2*0.33 - 0.30*v5/(1 + powi(t, 2)) - 0.93*1/sqrt(1.50 + powi(x2, 2)) - 1.06*powi(v4, 2),
    1.46*v2/(1 + powi(x2, 2)) + 1.25*powi(cos(0.64*x3 - 0.82*t), 3) + p1*v2*v2*ln(1.60 + 0.79*cos(x3)) + 0.52*v5/(1 + powi(x6, 2)),
    v6*v5/(1.16 - 0.16*exp(-powi(x1, 2)/2)) + 1.37*(if x5 <= -0.28 { sin(0.73*x5 - 0.85*x1 + 0.64)*cos(0.84*x1) } else { 1/sqrt(1.50 + powi(x5, 2)) }) + p2*v3*v2*wave(0.71*x3 - 0.67*x5 - 0.95),
    1.06*x4/(1 + powi(x4, 2)) + 1.65*v1 + p1*v5*v5*cos(0.41*x1 - 0.78*x6) + p1*exp(0.20*x6),
    p1*x6,
)]
#[constraint(row1: 1.77*x2 + 0.11*sin(x2) + 0.30*sin(1.14*t) - 0.27 == 0)]
#[constraint(row2: 1.30*x6 + 0.24*sin(x6) + 0.37*x2*x2 + 0.30*sin(1.22*t) - 0.13 == 0)]
#[constraint(row3: 1.79*x3 + 0.12*sin(x3) + 0.22*x2*x2 + 0.30*sin(1.15*t) + 0.13 == 0)]
#[constraint(row4: 1.82*x5 + 0.23*sin(x5) + 0.10*sin(x2) + exp(0.14*x6)/2 + 0.30*sin(0.53*t) - 0.33 == 0)]
#[constraint(row5: (1.50 + 0.15*0.38*sin(x2)/(1.50 + cos(x3)))*v4 + 0.31*tan(0.59*sin(x5))/2*v2 + 0.43*sin(0.43*x4) == 0)]
#[constraint(row6: (1.50 - 0.18*(if t <= 0.24 { exp(-powi(x4, 2)/2) } else { sin(1.01*x2) }))*v1 - 0.12*cos(1.08*x2 - 0.22*t + 0.36)*v2 + 0.25*exp(-powi(t, 2)/2)*v6 == 0)]
pub struct Random99 {
    #[nominal(1.01)]
    pub p1: f64,
    #[nominal(0.62)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = (1.36 - 0.16*exp(-powi(x3, 2)/2))*v1 + 0.26*(if x4 > -0.47 { sin(p1*x4 - 0.17) } else { sin(1.02*x1 + 0.24*x4) })*v5 - 0.47*sin(p2*x4 + 0.55),
    dot(x2) = v2 + 0.12*exp(-powi(x3, 2)/2)*v3 - 0.36*wave(0.73*x1 + 0.30*x5),
    dot(x3) = v3 - 0.55*sin(0.73*x4 + 0.72*x1 - 1.22),
    dot(x4) = (1.34 + 0.31*sin(0.84*x3))*v4 + 0.26*sin(1.05*x2 + 0.64*x2)*cos(0.60*x5 + 0.22*x5 + 0.65)*v3 + 0.16*wave(1.19*x3),
    dot(x5) = (1.07 - 0.13*(if x1 <= -0.25 { x1/(1 + powi(x1, 2)) } else { ln(1.60 + 0.34*cos(x2)) }))*v5 - 0.18*1/sqrt(1.50 + powi(x2, 2))*v2 + 0.20*cos(0.84*x1 - 0.60*x5 + 0.26),
)]
#[define(l11 = (1.07 + 0.14*atan2(x2, 2 + cos(x1))/2), l22 = (1.19 + 0.28*ln(1.60 + 0.98*cos(x5))), l32 = 0.13*ln(1.60 + 0.44*cos(x1)), l33 = 1.33, l41 = 0.31*ln(1.60 + 0.41*cos(x5)), l42 = 0.30*ln(1.60 + 0.45*cos(x1)), l43 = 0.32*exp(-powi(x1, 2)/2), l44 = 1.32, l51 = 0.29*sin(1.03*x5 + 0.33*x2), l52 = 0.12*powi(cos(1.20*x1 + 0.22*x3), 3), l53 = 0.14*sin(0.59*x5 + 0.63*x5)*cos(1.18*x3 + 0.77*x4), l54 = 0.35*wave(0.47*x2 - 0.48*x5 - 0.28), l55 = (1.03 - 0.18*(if x4 >= -0.02 { sin(p1*x1 + 0.80) } else { sin(p2*x1 + 0.49) })))]
#[kinetic_energy(powi(l11*v1 + l41*v4 + l51*v5, 2)/2 + powi(l22*v2 + l32*v3 + l42*v4 + l52*v5, 2)/2 + powi(l33*v3 + l43*v4 + l53*v5, 2)/2 + powi(l44*v4 + l54*v5, 2)/2 + powi(l55*v5, 2)/2 - 0.61*x2/(1 + powi(x2, 2))*v1 - 0.28*wave(0.87*x3)*v2 + 0.51*0.78*sin(x2)/(1.50 + cos(x3))*v3 + 0.62*bump(0.59*x3)*v5 - 0.28*sin(0.48*x2 + 0.68))]
#[forces(
    v3*sqrt(2 + powi(v4, 2)) - v3*sqrt(2 + powi(v5, 2)) - v4*v2/(1.39 + 0.19*0.36*sin(x3)/(1.50 + cos(x4))),
    p1*v5*v1*sin(0.84*x3 - 0.50*x1) + 1.40*v4/(1 + powi(x2, 2)) + 0.45*v2/(1 + powi(x3, 2)) + p2*v5*v1*sin(0.95*x5 - 0.48*x2),
    p1*v1*v2*powi(cos(0.79*x4 + 0.22*x5 + 0.13), 3) + v5*v1/1.36 + 1.16*powi(v2, 2) + 0.81*0.39*sin(x5)/(1.50 + cos(x1)),
    0.99*v5 - 0.40*(if x5 > -0.50 { x3/(1 + powi(x3, 2)) } else { 0.80*sin(x1)/(1.50 + cos(x3)) }),
    tau*1.60 - v1*sqrt(2 + powi(v3, 2)) - v3*v3/(1.08 + 0.34*bump(0.64*x5 - 0.47*x1)) - 1.85*powi(v3, 2),
)]
#[potential_energy(sin(1.03*x2)*cos(0.83*x4 - 0.60))]
#[constraint(row1: 1.14*v2 - 0.28*powi(cos(0.57*x5 + 0.55*x4 - 0.38), 3)*v3 + 0.24*sin(0.89*x2)*cos(0.64*x5) == 0)]
#[constraint(row2: 1.00*v1 - 0.26*sin(v1 + powi(cos(0.69*x5 - 0.46*x2), 3)*v2) - 0.40*sin(0.90*x4 - 0.88*x3) == 0)]
#[constraint(row3: 1.90*v5 + 0.16*sqrt(1.50 + powi(v3, 2) + powi(v2, 2)) + 0.45*1/sqrt(1.50 + powi(x4, 2)) == 0)]
#[constraint(row4: 1.70*v4 + 0.26*sqrt(1.50 + powi(v2, 2) + powi(v1, 2)) - 0.36*0.35*sin(x4)/(1.50 + cos(x4)) == 0)]
#[independent(v3, v4, v5, v1)]
#[output(place = sin(0.44*x4), power = 0.59*powi(v3, 2) - 1.34*v1 - 0.98*x4/(1 + powi(x4, 2)), push = sin(0.72*x3 + 1.09)*dot(v4) + v1*ddot(x1), pull = (1.37 - 0.23*(if x4 >= -0.32 { ln(1.60 + 0.77*cos(x1)) } else { powi(cos(0.90*x4 + 0.88*x4), 3) }))*reaction(row3) - push, share = pull/(1.72 + powi(reaction(row3), 2)))]
pub struct Random100 {
    #[nominal(1.41)]
    pub p1: f64,
    #[nominal(0.80)]
    pub p2: f64,
    #[nominal(1.32)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    dot(x1) = (1.06 + 0.18*0.46*sin(x4)/(1.50 + cos(x5)))*v1 + 0.39*powi(cos(0.70*t), 3)*v5,
    dot(x2) = v2,
    dot(x3) = (1.27 - 0.20*ln(1.60 + 0.72*cos(x1)))*v3 + 0.28*0.61*sin(t)/(1.50 + cos(x5))*v1,
    dot(x4) = (1.17 - 0.33*wave(0.51*x4 + 0.31*x5))*v4,
    dot(x5) = (1.25 - 0.21*0.51*sin(t)/(1.50 + cos(x3)))*v5 + 0.29*exp(-powi(x2, 2)/2)*v6,
    dot(x6) = (1.29 - 0.26*sin(1.14*x1 + 0.30*x1))*v6 + 0.17*(if x2 >= 0.51 { sin(0.80*x3 + 0.51*x5 - 0.76) } else { sin(0.57*x3 - 0.71*x6) })*v2,
)]
#[define(l11 = (1.03 + 0.20*atan2(x5, 2 + cos(t))/2), l22 = (1.22 - 0.19*tan(0.65*sin(x5))/2), l33 = (1.28 + 0.23*ln(1.60 + 0.68*cos(x1))), l42 = 0.13*tan(0.93*sin(x2))/2, l43 = 0.19*cos(0.41*t), l44 = (1.31 + 0.27*tan(0.59*sin(t))/2), l55 = (1.13 - 0.11*exp(-powi(x3, 2)/2)), l61 = 0.40*powi(cos(0.65*x6 - 0.68*x5), 3), l62 = 0.30*cos(1.08*x3 - 0.28*t), l65 = 0.35*atan2(x4, 2 + cos(x1))/2, l66 = (1.22 - 0.34*exp(-powi(x2, 2)/2)))]
#[inertia(matrix(
    [l11*l11, 0, 0, 0, 0, l11*l61],
    [_, l22*l22, 0, l22*l42, 0, l22*l62],
    [_, _, l33*l33, l33*l43, 0, 0],
    [_, _, _, l42*l42 + l43*l43 + l44*l44, 0, l42*l62],
    [_, _, _, _, l55*l55, l55*l65],
    [_, _, _, _, _, l61*l61 + l62*l62 + l65*l65 + l66*l66],
))]
#[forces(
    p1*0.91 - v1*sqrt(2 + powi(v3, 2)) - v6*v3/(1.14 - 0.16*tan(0.34*sin(x2))/2),
    p1*x3,
    p1*v3*v3*(if x3 <= -0.45 { ln(1.60 + 0.45*cos(x4)) } else { cos(0.57*x6 + 0.24*t) }) + 1.35*v6/(1 + powi(x4, 2)),
    p1*v5*v5*wave(0.53*x2 + 0.45*x5 - 0.24) - p1*1.20 - 0.66*v2,
    0.39*(if x4 <= -0.38 { ln(1.60 + 0.72*cos(x2)) } else { exp(-powi(x5, 2)/2) }) + p1*x6,
    p1*exp(0.20*x4),
)]
#[potential_energy(sin(0.73*x6 - 1.28)*cos(0.83*x3))]
#[constraint(row1: (1.50 - 0.19*1/sqrt(1.50 + powi(x5, 2)))*dot(v4) + 0.58*v6*v1*tan(0.67*sin(x6))/2 == 0)]
#[constraint(row2: ddot(x3) + 0.14*sin(0.69*x5)*dot(v4) + 0.33*v1*v4*x4/(1 + powi(x4, 2)) == 0)]
#[constraint(row3: 1.56*dot(v6) + 0.28*t/(1 + powi(t, 2))*dot(v4) + 0.27*(if x1 > 0.31 { powi(cos(0.96*x4), 3) } else { atan2(x6, 2 + cos(x2))/2 })*dot(v3) - 0.41*v5*v1*atan2(x1, 2 + cos(x2))/2 == 0)]
#[constraint(row4: (1.50 + 0.10*t/(1 + powi(t, 2)))*dot(v2) + 0.23*sin(1.04*x2 - 0.29*x1 - 0.78)*dot(v4) - 0.27*sin(0.58*x2 + 0.57)*dot(v3) + 0.54*v3 + 0.54*wave(0.46*x2) == 0)]
#[constraint(row5: ddot(x5) - 0.23*(if t < -0.16 { 1/sqrt(1.50 + powi(x1, 2)) } else { ln(1.60 + 0.65*cos(x1)) })*dot(v4) - 0.18*tan(0.62*sin(x4))/2*dot(v3) - 0.32*v6 - 0.32*cos(0.64*x6 + 0.32*x5 + 0.48) == 0)]
#[constraint(row6: ddot(x1) + 0.19*atan2(x1, 2 + cos(x4))/2*dot(v4) + 0.20*sin(p1*x4 + 0.32)*dot(v3) + 0.69*v2*v3*exp(-powi(x4, 2)/2) == 0)]
#[independent(s1 = 1.01*v1 + 0.24*sin(0.80*x6 + 0.78*t - 0.85), v5, s3 = 1.61*v2 + 0.26*sin(p1*t + 0.74)*v1 + 0.11*sin(0.69*x6 - 0.81*x4 + 1.42)*v5, s4 = 1.66*v6 + 0.20*powi(cos(1.04*x6 + 0.43*x4), 3)*v1, s5 = v3 - 0.31*(if x5 < 0.24 { ln(1.60 + 0.98*cos(x6)) } else { wave(1.06*t - 0.31*x6 + 1.10) })*v1 - 0.34*tan(0.71*sin(x5))/2*v5 + 0.24*(if t > -0.56 { 1/sqrt(1.50 + powi(x3, 2)) } else { 0.52*sin(x3)/(1.50 + cos(x6)) }), s6 = v4 + 0.12*(if x2 > -0.31 { wave(0.46*x3 + 0.54*x4) } else { 1/sqrt(1.50 + powi(x5, 2)) })*v1 - 0.27*sin(p1*x2 - 0.98)*v5)]
pub struct Random101 {
    #[nominal(0.64)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    dot(x1) = (1.28 + 0.30*(if x3 < -0.05 { atan2(x2, 2 + cos(x2))/2 } else { x4/(1 + powi(x4, 2)) }))*v1 + 0.48*0.94*sin(x4)/(1.50 + cos(x4)),
    dot(x2) = (1.21 + 0.15*powi(cos(0.92*x5 - 0.63*x1), 3))*v2 + 0.32*cos(0.87*x1)*v4 - 0.16*(if x2 <= 0.03 { 1/sqrt(1.50 + powi(x5, 2)) } else { sin(0.79*x5 + 0.26*x5) }),
    dot(x3) = (1.17 + 0.11*x2/(1 + powi(x2, 2)))*v3 - 0.36*cos(0.86*x1)*v2 - 0.47*powi(cos(0.48*x1 + 0.87*x1), 3),
    dot(x4) = v4 + 0.46*atan2(x3, 2 + cos(x1))/2,
    dot(x5) = 1.14*v5 - 0.13*ln(1.60 + 0.55*cos(x2)),
)]
#[inertia(diag((1.16 - 0.30*(if x1 < -0.13 { x2/(1 + powi(x2, 2)) } else { cos(1.14*x5) })), (1.25 + 0.15*powi(cos(0.95*x4 - 0.50*x4 + 1.30), 3)), (1.07 + 0.15*(if x1 >= -0.11 { sin(0.45*x4 + 0.25*x5) } else { cos(0.47*x1 - 0.49*x3 + 1.44) })), (1.11 + 0.34*bump(0.41*x4)), (1.00 - 0.27*1/sqrt(1.50 + powi(x2, 2)))))]
#[forces(
    p3*1.89 - p3*0.57 - p1*exp(0.20*x1) - 1.82*v5,
    0,
    1.88*v1/(1 + powi(x2, 2)) - 0.59*v1/(1 + powi(x3, 2)) - v4*sqrt(2 + powi(v5, 2)) - 1.06*powi(v5, 2),
    1.42*powi(v4, 2) - v3*sqrt(2 + powi(v2, 2)),
    v5*sqrt(2 + powi(v4, 2)),
)]
#[constraint(row1: 1.29*x3 + 0.27*powi(x2, 2)/2 + 0.41 == 0)]
#[constraint(row2: 1.97*x4 + 0.19*sin(x4) + 0.37*x2 + 0.34*x3*x2 - 0.61 == 0)]
#[constraint(row3: 1.83*x5 + 0.29*powi(x2, 2)/2 + 0.26*sin(x3) + exp(0.34*x4)/2 - 0.72 == 0)]
#[constraint(row4: 1.17*v1 + 0.11*sqrt(1.50 + powi(v3, 2) + powi(v2, 2)) - 0.43*exp(-powi(x3, 2)/2) == 0)]
#[output(place = ln(1.60 + 0.32*cos(x3)), power = p1*x4 - v1*sqrt(2 + powi(v2, 2)) - 0.92*powi(v5, 2), push = (if x4 < 0.44 { wave(0.84*x3 - 0.45) } else { tan(0.98*sin(x2))/2 })*dot(v5) + v3*ddot(x3), pull = 1.16*reaction(row4) - push, share = pull/(1.85 + powi(reaction(row4), 2)))]
pub struct Random102 {
    #[nominal(0.67)]
    pub p1: f64,
    #[nominal(0.88)]
    pub p2: f64,
    #[nominal(1.46)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inertia(matrix(
    [((1.23 + 0.29*cos(0.75*x2 + 0.85*x1 - 1.17)))*((1.23 + 0.29*cos(0.75*x2 + 0.85*x1 - 1.17))), ((1.23 + 0.29*cos(0.75*x2 + 0.85*x1 - 1.17)))*(0.25*atan2(x2, 2 + cos(x2))/2), ((1.23 + 0.29*cos(0.75*x2 + 0.85*x1 - 1.17)))*(0.14*sin(0.75*x1 + 0.86*x1)), ((1.23 + 0.29*cos(0.75*x2 + 0.85*x1 - 1.17)))*(0.33*wave(0.46*x1)), ((1.23 + 0.29*cos(0.75*x2 + 0.85*x1 - 1.17)))*(0.29*ln(1.60 + 0.66*cos(x6))), ((1.23 + 0.29*cos(0.75*x2 + 0.85*x1 - 1.17)))*(0.13*(if x1 <= -0.58 { wave(0.60*x4 + 0.34*x5 - 0.33) } else { exp(-powi(x2, 2)/2) }))],
    [_, (0.25*atan2(x2, 2 + cos(x2))/2)*(0.25*atan2(x2, 2 + cos(x2))/2) + (1.14)*(1.14), (0.25*atan2(x2, 2 + cos(x2))/2)*(0.14*sin(0.75*x1 + 0.86*x1)) + (1.14)*(0.20*0.50*sin(x2)/(1.50 + cos(x3))), (0.25*atan2(x2, 2 + cos(x2))/2)*(0.33*wave(0.46*x1)) + (1.14)*(0.23*sin(0.99*x1)), (0.25*atan2(x2, 2 + cos(x2))/2)*(0.29*ln(1.60 + 0.66*cos(x6))) + (1.14)*(0.27*bump(0.62*x3)), (0.25*atan2(x2, 2 + cos(x2))/2)*(0.13*(if x1 <= -0.58 { wave(0.60*x4 + 0.34*x5 - 0.33) } else { exp(-powi(x2, 2)/2) })) + (1.14)*(0.30*exp(-powi(x1, 2)/2))],
    [_, _, (0.14*sin(0.75*x1 + 0.86*x1))*(0.14*sin(0.75*x1 + 0.86*x1)) + (0.20*0.50*sin(x2)/(1.50 + cos(x3)))*(0.20*0.50*sin(x2)/(1.50 + cos(x3))) + (1.01)*(1.01), (0.14*sin(0.75*x1 + 0.86*x1))*(0.33*wave(0.46*x1)) + (0.20*0.50*sin(x2)/(1.50 + cos(x3)))*(0.23*sin(0.99*x1)) + (1.01)*(0.34*atan2(x5, 2 + cos(x6))/2), (0.14*sin(0.75*x1 + 0.86*x1))*(0.29*ln(1.60 + 0.66*cos(x6))) + (0.20*0.50*sin(x2)/(1.50 + cos(x3)))*(0.27*bump(0.62*x3)), (0.14*sin(0.75*x1 + 0.86*x1))*(0.13*(if x1 <= -0.58 { wave(0.60*x4 + 0.34*x5 - 0.33) } else { exp(-powi(x2, 2)/2) })) + (0.20*0.50*sin(x2)/(1.50 + cos(x3)))*(0.30*exp(-powi(x1, 2)/2)) + (1.01)*(0.36*tan(0.77*sin(x2))/2)],
    [_, _, _, (0.33*wave(0.46*x1))*(0.33*wave(0.46*x1)) + (0.23*sin(0.99*x1))*(0.23*sin(0.99*x1)) + (0.34*atan2(x5, 2 + cos(x6))/2)*(0.34*atan2(x5, 2 + cos(x6))/2) + (1.17)*(1.17), (0.33*wave(0.46*x1))*(0.29*ln(1.60 + 0.66*cos(x6))) + (0.23*sin(0.99*x1))*(0.27*bump(0.62*x3)) + (1.17)*(0.35*cos(0.95*x3 - 0.20*x2)), (0.33*wave(0.46*x1))*(0.13*(if x1 <= -0.58 { wave(0.60*x4 + 0.34*x5 - 0.33) } else { exp(-powi(x2, 2)/2) })) + (0.23*sin(0.99*x1))*(0.30*exp(-powi(x1, 2)/2)) + (0.34*atan2(x5, 2 + cos(x6))/2)*(0.36*tan(0.77*sin(x2))/2) + (1.17)*(0.13*x1/(1 + powi(x1, 2)))],
    [_, _, _, _, (0.29*ln(1.60 + 0.66*cos(x6)))*(0.29*ln(1.60 + 0.66*cos(x6))) + (0.27*bump(0.62*x3))*(0.27*bump(0.62*x3)) + (0.35*cos(0.95*x3 - 0.20*x2))*(0.35*cos(0.95*x3 - 0.20*x2)) + ((1.09 + 0.21*cos(0.62*x1)))*((1.09 + 0.21*cos(0.62*x1))), (0.29*ln(1.60 + 0.66*cos(x6)))*(0.13*(if x1 <= -0.58 { wave(0.60*x4 + 0.34*x5 - 0.33) } else { exp(-powi(x2, 2)/2) })) + (0.27*bump(0.62*x3))*(0.30*exp(-powi(x1, 2)/2)) + (0.35*cos(0.95*x3 - 0.20*x2))*(0.13*x1/(1 + powi(x1, 2))) + ((1.09 + 0.21*cos(0.62*x1)))*(0.39*powi(cos(0.66*x1 + 0.71*x5), 3))],
    [_, _, _, _, _, (0.13*(if x1 <= -0.58 { wave(0.60*x4 + 0.34*x5 - 0.33) } else { exp(-powi(x2, 2)/2) }))*(0.13*(if x1 <= -0.58 { wave(0.60*x4 + 0.34*x5 - 0.33) } else { exp(-powi(x2, 2)/2) })) + (0.30*exp(-powi(x1, 2)/2))*(0.30*exp(-powi(x1, 2)/2)) + (0.36*tan(0.77*sin(x2))/2)*(0.36*tan(0.77*sin(x2))/2) + (0.13*x1/(1 + powi(x1, 2)))*(0.13*x1/(1 + powi(x1, 2))) + (0.39*powi(cos(0.66*x1 + 0.71*x5), 3))*(0.39*powi(cos(0.66*x1 + 0.71*x5), 3)) + ((1.35 - 0.20*cos(1.14*x6 - 0.47*x4)))*((1.35 - 0.20*cos(1.14*x6 - 0.47*x4)))],
))]
#[forces(
    1.05*(if x3 <= 0.14 { bump(0.84*x5 - 0.87*x2 + 0.21) } else { sin(0.96*x1 - 0.67*x4) }),
    dot(x4)*dot(x5)/(1.13 + 0.15*sin(1.17*x3)),
    dot(x4)*sqrt(2 + powi(dot(x4), 2)) + p1*exp(0.20*x6) + 1.16*dot(x3),
    0.89*powi(dot(x1), 2) - 0.82*dot(x6) - p1*x1 - 1.32*powi(dot(x1), 2),
    1.63*dot(x3)/(1 + powi(x5, 2)) - 1.75*powi(dot(x3), 2) - 0.78*powi(cos(0.87*x2 - 0.53*x2), 3),
    p1*dot(x1)*dot(x6)*bump(0.48*x4 - 0.20),
)]
#[constraint(row1: 1.41*x6 + 0.69 == 0)]
#[constraint(row2: 1.51*x5 + 0.11*sin(x5) + exp(0.32*x6)/2 + 0.28 == 0)]
#[constraint(row3: 1.96*x4 + 0.30*sin(x4) + exp(0.11*x6)/2 + 0.35*powi(x5, 2)/2 - 0.41 == 0)]
#[constraint(row4: ddot(x2) - 0.23*bump(0.86*x6 - 1.48)*ddot(x6) + 0.28*cos(0.87*x2 - 0.96)*ddot(x5) - 0.51*dot(x1)/sqrt(1.20 + powi(dot(x5), 2)) == 0)]
#[constraint(row5: (1.50 + 0.23*sin(p1*x6 - 0.26))*ddot(x1) + 0.18*sin(1.15*x2 + 0.78*x5 + 0.35)*ddot(x6) - 0.29*atan2(x2, 2 + cos(x3))/2*ddot(x5) - 0.37*dot(x2) - 0.37*1/sqrt(1.50 + powi(x3, 2)) == 0)]
#[constraint(row6: (1.50 - 0.13*x5/(1 + powi(x5, 2)))*ddot(x3) - 0.16*0.95*sin(x4)/(1.50 + cos(x3))*ddot(x6) - 0.22*(if x2 >= -0.55 { tan(0.51*sin(x6))/2 } else { 1/sqrt(1.50 + powi(x2, 2)) })*ddot(x5) - 0.71*dot(x6) - 0.71*(if x3 < -0.01 { atan2(x3, 2 + cos(x2))/2 } else { 1/sqrt(1.50 + powi(x3, 2)) }) == 0)]
pub struct Random103 {
    #[nominal(0.82)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = 1.20*dot(x1) - 0.21*powi(cos(0.65*x2), 3)*dot(x2) + 0.19*atan2(x3, 2 + cos(x5))/2,
    v2 = (1.04 + 0.26*sin(p1*x4 + 1.00))*dot(x2) - 0.31*(if x5 >= -0.08 { powi(cos(0.41*x5 - 0.25*x1), 3) } else { ln(1.60 + 0.96*cos(x4)) })*dot(x4) - 0.56*0.47*sin(x4)/(1.50 + cos(x5)),
    v3 = 1.15*dot(x3) - 0.22*sin(1.10*x1 - 0.62)*cos(0.82*x4)*dot(x4) - 0.59*cos(0.93*x3 - 0.74),
    v4 = (1.03 + 0.15*bump(0.40*x5 - 0.25*x5))*dot(x4) - 0.22*sin(0.59*x5 + 0.78*x3),
    v5 = 1.00*dot(x5) - 0.11*wave(0.41*x4 - 0.55*x4)*dot(x1) + 0.50*powi(cos(1.10*x2), 3),
)]
#[inertia(matrix(
    [(1.33)*(1.33), 0, 0, (1.33)*(0.30*(if x1 >= -0.13 { atan2(x2, 2 + cos(x3))/2 } else { cos(0.84*x5 + 0.69*x5) })), (1.33)*(0.11*cos(0.94*x4 + 0.23*x5 + 1.18))],
    [_, ((1.04 - 0.24*tan(0.50*sin(x2))/2))*((1.04 - 0.24*tan(0.50*sin(x2))/2)), 0, ((1.04 - 0.24*tan(0.50*sin(x2))/2))*(0.17*x3/(1 + powi(x3, 2))), ((1.04 - 0.24*tan(0.50*sin(x2))/2))*(0.14*sin(p1*x4 + 0.86))],
    [_, _, (1.18)*(1.18), (1.18)*(0.37*cos(1.04*x4 - 0.70*x3)), 0],
    [_, _, _, (0.30*(if x1 >= -0.13 { atan2(x2, 2 + cos(x3))/2 } else { cos(0.84*x5 + 0.69*x5) }))*(0.30*(if x1 >= -0.13 { atan2(x2, 2 + cos(x3))/2 } else { cos(0.84*x5 + 0.69*x5) })) + (0.17*x3/(1 + powi(x3, 2)))*(0.17*x3/(1 + powi(x3, 2))) + (0.37*cos(1.04*x4 - 0.70*x3))*(0.37*cos(1.04*x4 - 0.70*x3)) + ((1.06 - 0.25*0.71*sin(x5)/(1.50 + cos(x5))))*((1.06 - 0.25*0.71*sin(x5)/(1.50 + cos(x5)))), (0.30*(if x1 >= -0.13 { atan2(x2, 2 + cos(x3))/2 } else { cos(0.84*x5 + 0.69*x5) }))*(0.11*cos(0.94*x4 + 0.23*x5 + 1.18)) + (0.17*x3/(1 + powi(x3, 2)))*(0.14*sin(p1*x4 + 0.86))],
    [_, _, _, _, (0.11*cos(0.94*x4 + 0.23*x5 + 1.18))*(0.11*cos(0.94*x4 + 0.23*x5 + 1.18)) + (0.14*sin(p1*x4 + 0.86))*(0.14*sin(p1*x4 + 0.86)) + ((1.21 + 0.28*cos(0.76*x2)))*((1.21 + 0.28*cos(0.76*x2)))],
))]
#[forces(
    1.55*v3/(1 + powi(x2, 2)) - p1*0.35 - v2*v5/(1.33 + 0.15*ln(1.60 + 0.48*cos(x1))) - 1.98*powi(v4, 2),
    0.54*v4,
    1.09*powi(v5, 2) + 1.41*exp(-powi(x1, 2)/2),
    p1*0.64,
    1.28*sin(0.61*x1 + 1.05)*cos(0.78*x5 - 0.35*x5) + 1.57*v3 + v2*v4/(1.19 - 0.11*cos(0.93*x3 + 0.43*x4 + 0.97)),
)]
#[constraint(row1: 1.63*x3 + 0.15*sin(x3) + 0.36*powi(x2, 2)/2 + 0.77 == 0)]
#[constraint(row2: v4 - 0.10*(if x2 <= -0.15 { 1/sqrt(1.50 + powi(x3, 2)) } else { sin(0.95*x2 + 0.50) })*v2 == 0)]
#[constraint(row3: 1.85*v5 + 0.18*sqrt(1.50 + powi(v4, 2) + powi(v2, 2)) - 0.54*(if x3 < -0.39 { sin(p1*x5 + 0.24) } else { exp(-powi(x1, 2)/2) }) == 0)]
#[constraint(row4: 1.90*dot(v1) - 0.11*sin(0.99*x4)*dot(v2) + 0.12*sin(p1*x5 - 0.65)*dot(v3) - 0.49*v1 - 0.49*exp(-powi(x3, 2)/2) == 0)]
#[output(place = 0.42*sin(x1)/(1.50 + cos(x3)), power = p1*exp(0.20*x3) - 0.66*v1/(1 + powi(x1, 2)) - v2*sqrt(2 + powi(v4, 2)) - p1*0.83, push = sin(p1*x1 + 0.36)*dot(v4) + v2*ddot(x2), pull = (1.02 - 0.25*ln(1.60 + 0.47*cos(x5)))*reaction(row4) - push, share = pull/(1.64 + powi(reaction(row4), 2)))]
pub struct Random104 {
    #[nominal(0.63)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1) + 0.19*cos(1.04*x4 - 0.22*x3 + 1.23)*dot(x2) + 0.28*sin(0.65*x4 - 0.74*x6),
    v2 = dot(x2) + 0.26*powi(cos(0.74*x2 - 0.85*x6), 3),
    v3 = 1.17*dot(x3) + 0.11*ln(1.60 + 0.80*cos(x3))*dot(x5) - 0.15*sin(0.84*x2),
    v4 = dot(x4) + 0.12*sin(p1*x6 - 0.23)*dot(x1) - 0.39*(if x6 >= -0.19 { sin(0.80*x1 - 0.71*x1)*cos(0.82*x3 - 0.86*x2 - 1.22) } else { tan(0.44*sin(x4))/2 }),
    v5 = (1.21 - 0.29*sin(0.75*x2 - 0.63*x5))*dot(x5) + 0.18*cos(0.84*x2 - 1.46)*dot(x4) + 0.12*sin(1.12*x2)*cos(0.72*x5 - 0.86*x4),
    v6 = dot(x6) + 0.15*(if x3 <= 0.26 { sin(1.08*x1 - 1.29)*cos(0.47*x5 - 0.30*x2) } else { tan(0.83*sin(x6))/2 })*dot(x1) - 0.42*atan2(x2, 2 + cos(x5))/2,
)]
#[define(l11 = 1.14, l22 = (1.40 + 0.20*sin(0.67*x3)), l33 = 1.32, l41 = 0.32*cos(0.66*x5 - 0.67*x4 - 0.99), l42 = 0.32*cos(0.71*x4 - 0.84), l43 = 0.18*tan(0.78*sin(x3))/2, l44 = (1.15 + 0.27*cos(0.79*x4 - 0.67*x4)), l52 = 0.25*1/sqrt(1.50 + powi(x3, 2)), l53 = 0.20*wave(1.07*x4 + 0.82*x5), l54 = 0.33*(if x5 < -0.05 { powi(cos(0.89*x1 - 0.23*x6), 3) } else { sin(0.45*x2) }), l55 = 1.09, l66 = (1.28 - 0.13*exp(-powi(x4, 2)/2)))]
#[inertia(matrix(
    [l11*l11, 0, 0, l11*l41, 0, 0],
    [_, l22*l22, 0, l22*l42, l22*l52, 0],
    [_, _, l33*l33, l33*l43, l33*l53, 0],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44, l42*l52 + l43*l53 + l44*l54, 0],
    [_, _, _, _, l52*l52 + l53*l53 + l54*l54 + l55*l55, 0],
    [_, _, _, _, _, l66*l66],
))]
#[forces(
    p2*x2,
    p1*x5,
    p2*exp(0.20*x6) - 0.37*v2/(1 + powi(x1, 2)) - 1.49*powi(v4, 2),
    0.85*v6 + 1.58*powi(v2, 2),
    0.47*v1,
    p3*1.01,
)]
#[constraint(row1: 1.26*dot(v1) + 0.14*1/sqrt(1.50 + powi(x6, 2))*dot(v6) - 0.13*powi(cos(0.52*x3 + 0.42*x6), 3)*dot(v3) - 0.71*bump(1.07*x2 + 0.31*x5) == 0)]
#[constraint(row2: ddot(x5) - 0.15*0.72*sin(x6)/(1.50 + cos(x6))*dot(v6) - 0.15*sin(1.09*x1 + 0.23*x4)*cos(0.53*x5 + 0.79*x3)*dot(v3) - 0.25*v3 - 0.25*sin(1.02*x4 + 0.58*x5 + 0.49) == 0)]
#[constraint(again1: (1.24 - 0.18*(if x2 > -0.27 { sin(0.94*x1) } else { tan(0.60*sin(x6))/2 }))*(ddot(x5) - 0.15*0.72*sin(x6)/(1.50 + cos(x6))*dot(v6) - 0.15*sin(1.09*x1 + 0.23*x4)*cos(0.53*x5 + 0.79*x3)*dot(v3) - 0.25*v3 - 0.25*sin(1.02*x4 + 0.58*x5 + 0.49)) + 0.47*(1.26*dot(v1) + 0.14*1/sqrt(1.50 + powi(x6, 2))*dot(v6) - 0.13*powi(cos(0.52*x3 + 0.42*x6), 3)*dot(v3) - 0.71*bump(1.07*x2 + 0.31*x5)) == 0, redundant)]
#[constraint(again2: (1.12 - 0.25*exp(-powi(x3, 2)/2))*(1.26*dot(v1) + 0.14*1/sqrt(1.50 + powi(x6, 2))*dot(v6) - 0.13*powi(cos(0.52*x3 + 0.42*x6), 3)*dot(v3) - 0.71*bump(1.07*x2 + 0.31*x5)) + 1.18*(ddot(x5) - 0.15*0.72*sin(x6)/(1.50 + cos(x6))*dot(v6) - 0.15*sin(1.09*x1 + 0.23*x4)*cos(0.53*x5 + 0.79*x3)*dot(v3) - 0.25*v3 - 0.25*sin(1.02*x4 + 0.58*x5 + 0.49)) == 0, redundant)]
pub struct Random105 {
    #[nominal(0.60)]
    pub p1: f64,
    #[nominal(1.34)]
    pub p2: f64,
    #[nominal(1.44)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[inputs(tau)]
#[kinetic_energy(1.09*powi(dot(x1), 2)/2 + (1.09 + 0.21*(if x5 >= -0.00 { powi(cos(0.81*x1 + 0.76*x5), 3) } else { sin(0.86*x3) }))*powi(dot(x2), 2)/2 + 1.07*powi(dot(x3), 2)/2 + (1.04 + 0.27*sin(0.46*x5 - 0.84*x1)*cos(0.51*x4 - 0.71*x5 - 1.25))*powi(dot(x4), 2)/2 + (1.09 + 0.29*1/sqrt(1.50 + powi(x3, 2)))*powi(dot(x5), 2)/2 - 0.59*sin(0.65*x2 - 0.49*x4)*dot(x1) - 0.41*wave(0.86*x4)*dot(x2) + 0.30*1/sqrt(1.50 + powi(x2, 2))*dot(x5))]
#[forces(
    0,
    0.56*dot(x2)/(1 + powi(x2, 2)) - dot(x4)*dot(x4)/(1.28 + 0.12*0.98*sin(x5)/(1.50 + cos(x5))) - tau*1.65 - dot(x3)*dot(x5)/(1.05 + 0.31*bump(0.42*x5 - 0.45*x3 - 1.35)),
    0,
    p1*x3 + 0.41*dot(x5) + 0.80*dot(x4),
    p1*x4 - dot(x4)*sqrt(2 + powi(dot(x1), 2)) - 1.96*sin(0.58*x5 - 0.18)*cos(0.82*x3) - dot(x4)*sqrt(2 + powi(dot(x4), 2)),
)]
#[constraint(row1: 1.82*x4 + 0.14*sin(x4) + 0.24*sin(x3) + 0.25*powi(x1, 2)/2 - 0.11 == 0)]
#[constraint(row2: 1.50*x2 + 0.20*sin(x2) + 0.13*sin(x3) + 0.18*powi(x1, 2)/2 + 0.20*x5*x1 - 0.77 == 0)]
#[independent(s1 = (1.50 - 0.24*wave(0.99*x1 - 0.27*x2))*dot(x5) - 0.35*0.66*sin(x3)/(1.50 + cos(x4))*dot(x4), s2 = 1.48*dot(x1) - 0.33*exp(-powi(x2, 2)/2)*dot(x5) + 0.58*cos(1.03*x2), dot(x3))]
#[independent(dot(x5), dot(x1), dot(x3))]
pub struct Random106 {
    #[nominal(0.54)]
    pub p1: f64,
    #[nominal(1.50)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + ln(1.60 + 0.85*cos(x3))*dot(x1),
    v3 = dot(x3) + (if x5 > 0.19 { sin(1.14*x2 + 0.29*x4)*cos(0.47*x4 + 0.87*x5) } else { 1/sqrt(1.50 + powi(x2, 2)) })*dot(x2),
    v4 = dot(x4) + sin(1.05*x1 + 0.43*x2 - 1.49)*cos(0.45*x5 - 0.50)*dot(x1),
    v5 = dot(x5) + 0.78*sin(x4)/(1.50 + cos(x5))*dot(x2),
    v6 = dot(x6) + (if x1 > 0.43 { powi(cos(1.07*x1 + 0.67*x4 - 0.32), 3) } else { powi(cos(0.74*x6 + 0.69*x4 + 1.22), 3) })*dot(x4),
    dot(x1) = v1,
    dot(x2) = v2 - ln(1.60 + 0.85*cos(x3))*(v1),
    dot(x3) = v3 - (if x5 > 0.19 { sin(1.14*x2 + 0.29*x4)*cos(0.47*x4 + 0.87*x5) } else { 1/sqrt(1.50 + powi(x2, 2)) })*(v2 - ln(1.60 + 0.85*cos(x3))*(v1)),
    dot(x4) = v4 - sin(1.05*x1 + 0.43*x2 - 1.49)*cos(0.45*x5 - 0.50)*(v1),
    dot(x5) = v5 - 0.78*sin(x4)/(1.50 + cos(x5))*(v2 - ln(1.60 + 0.85*cos(x3))*(v1)),
    dot(x6) = v6 - (if x1 > 0.43 { powi(cos(1.07*x1 + 0.67*x4 - 0.32), 3) } else { powi(cos(0.74*x6 + 0.69*x4 + 1.22), 3) })*(v4 - sin(1.05*x1 + 0.43*x2 - 1.49)*cos(0.45*x5 - 0.50)*(v1)),
)]
#[inertia(diag((1.35 - 0.28*x2/(1 + powi(x2, 2))), (1.31 - 0.35*1/sqrt(1.50 + powi(x6, 2))), 1.12, 1.19, (1.35 - 0.24*atan2(x2, 2 + cos(x6))/2), (1.29 + 0.27*sin(1.10*x5 + 0.82*x1)*cos(1.17*x6 + 0.25*x4 - 0.64))))]
#[forces(
    v4*v1/1.02 - p1*x2 - p1*0.37 - 1.66*tan(0.46*sin(x4))/2,
    1.64*v2 + v4*sqrt(2 + powi(v3, 2)),
    p1*x4 + p1*exp(0.20*x2) + v6*v6/(1.27 + 0.13*atan2(x5, 2 + cos(x6))/2) + v5*v6/(1.14 + 0.11*sin(0.95*x6 - 0.33*x2)),
    0.57*v5 + p1*x5,
    p1*v4*v5*sin(0.82*x2 - 0.88*x3 - 0.37) - p1*v6*v3*0.62*sin(x5)/(1.50 + cos(x6)) - 1.46*v6 - v6*sqrt(2 + powi(v4, 2)),
    0,
)]
#[configuration(x1 = 0.94*powi(cos(0.44*x3 - 0.75), 3), x4 = 1.10*1/sqrt(1.50 + powi(x2, 2)))]
#[constraint(held_x1: x1 - (0.94*powi(cos(0.44*x3 - 0.75), 3)) == 0)]
#[constraint(held_x4: x4 - (1.10*1/sqrt(1.50 + powi(x2, 2))) == 0)]
#[constraint(bound: 1.60*v2 - 0.21*v2*v3*sin(0.45*x4 - 0.38)*cos(0.90*x5) - 0.27*cos(1.20*x6 - 0.35*x6 + 0.46) == 0)]
#[output(place = bump(0.77*x4 - 0.65*x1), power = 1.58*powi(v6, 2) - v4*v5/(1.39 - 0.17*1/sqrt(1.50 + powi(x2, 2))) - 0.82*sin(p1*x2 - 0.76) - 0.76*v1/(1 + powi(x3, 2)), push = (if x5 <= 0.28 { atan2(x4, 2 + cos(x3))/2 } else { wave(0.62*x4 + 0.74*x1 - 0.12) })*dot(v1) + v2*ddot(x2), pull = 1.05*reaction(held_x4) - push, share = pull/(1.71 + powi(reaction(held_x4), 2)))]
pub struct Random107 {
    #[nominal(1.04)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[define(l11 = 1.38, l21 = 0.32*x6/(1 + powi(x6, 2)), l22 = 1.12, l32 = 0.18*cos(0.57*x5 - 0.57), l33 = (1.28 - 0.30*atan2(x5, 2 + cos(x1))/2), l41 = 0.17*sin(0.47*x4), l42 = 0.18*sin(0.68*x1)*cos(0.88*x3 - 0.45*x1), l43 = 0.11*exp(-powi(x6, 2)/2), l44 = (1.07 - 0.28*(if x3 <= 0.54 { 1/sqrt(1.50 + powi(x5, 2)) } else { 1/sqrt(1.50 + powi(x3, 2)) })), l51 = 0.38*(if x3 > -0.59 { powi(cos(0.63*x4 - 0.45*x3 - 1.22), 3) } else { sin(0.61*x4)*cos(0.46*x5 + 1.37) }), l52 = 0.13*bump(0.73*x5 + 0.61*x6), l53 = 0.28*bump(0.60*x6 + 0.75), l55 = (1.13 - 0.21*bump(0.56*x1 - 1.24)), l62 = 0.20*ln(1.60 + 0.40*cos(x6)), l63 = 0.19*0.46*sin(x2)/(1.50 + cos(x2)), l66 = (1.35 - 0.33*0.97*sin(x6)/(1.50 + cos(x1))))]
#[inertia(matrix(
    [l11*l11, l11*l21, 0, l11*l41, l11*l51, 0],
    [_, l21*l21 + l22*l22, l22*l32, l21*l41 + l22*l42, l21*l51 + l22*l52, l22*l62],
    [_, _, l32*l32 + l33*l33, l32*l42 + l33*l43, l32*l52 + l33*l53, l32*l62 + l33*l63],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44, l41*l51 + l42*l52 + l43*l53, l42*l62 + l43*l63],
    [_, _, _, _, l51*l51 + l52*l52 + l53*l53 + l55*l55, l52*l62 + l53*l63],
    [_, _, _, _, _, l62*l62 + l63*l63 + l66*l66],
))]
#[forces(
    p2*dot(x4)*dot(x1)*1/sqrt(1.50 + powi(x2, 2)) - 1.69*powi(dot(x4), 2) - 1.36*powi(cos(0.62*x4 - 0.31), 3) - p2*exp(0.20*x4),
    p2*exp(0.20*x2),
    1.61*dot(x5),
    0,
    1.80*powi(dot(x6), 2) + p1*exp(0.20*x5) + p1*x5,
    0,
)]
#[constraint(row1: 1.47*x2 + 0.10*sin(x2) + 0.88*x5 + 0.10*cos(x5) + 0.20*0.5 == 0)]
#[constraint(row2: 1.26*x6 + 0.10*sin(x6) - 0.90*x4 + 0.10*cos(x4) + 0.20*0.5 == 0)]
#[constraint(row3: 1.33*x3 + 0.10*sin(x3) - 0.88*x1 + 0.10*cos(x1) + 0.20*0.5 == 0)]
#[independent(dot(x5), dot(x4), dot(x1))]
#[independent(dot(x2), dot(x4), dot(x1))]
#[independent(dot(x2), dot(x6), dot(x3))]
#[output(place = sin(1.14*x2 - 0.54)*cos(0.47*x2 + 0.87*x5 - 0.67), power = p1*x6 + p2*exp(0.20*x6) + p1*x4 + p1*exp(0.20*x3), push = tan(0.56*sin(x5))/2*ddot(x2) + dot(x2)*ddot(x2), pull = (1.28 + 0.29*sin(1.11*x6 + 0.47))*reaction(row1) - push, share = pull/(1.91 + powi(reaction(row1), 2)))]
pub struct Random108 {
    #[nominal(0.51)]
    pub p1: f64,
    #[nominal(0.96)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 5)]
#[coordinates(x[n])]
#[define(s[i] = tanh(0.88*x[i] + i/2 - 0.55 + t/2) for i in 0..n)]
#[define(r[0] = s[0]/2, r[i] = (r[i - 1] + s[i])/2 for i in 1..n)]
#[inertia(diag((1.25 + k[i]*r[i]/4) for i in 0..n))]
#[forces(
    0.31*sum(0..n, |j| sin(x[i] - x[j])*dot(x[j])) - 0.55*k[i]*dot(x[i]) - product(0..=i, |j| s[j]) for i in 0..n,
)]
#[potential_energy(sum(1..n, |i| k[i]*powi(x[i] - x[i - 1], 2))/2 + 0.31*r[n - 1])]
#[constraint(row[i]: (1.30 - 0.26*s[i])*dot(x[i]) - 0.26*r[i]*dot(x[n - 1]) + 0.26*s[n - 1] == 0 for i in 0..2)]
pub struct Random109 {
    #[nominal(0.83)]
    pub p1: f64,
    #[nominal(1.07)]
    pub p2: f64,
    #[nominal(1.20)]
    pub p3: f64,
    #[nominal(0.97)]
    pub k: [f64; 5],
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[inertia(matrix(
    [((1.22 - 0.34*sin(0.46*x1)))*((1.22 - 0.34*sin(0.46*x1)))],
))]
#[forces(
    dot(x1)*dot(x1)/(1.18 + 0.29*cos(1.08*x1 - 0.84*x1)) + p1*dot(x1)*dot(x1)*powi(cos(1.04*x1), 3),
)]
#[potential_energy(powi(cos(0.97*x1), 3))]
#[output(place = exp(-powi(x1, 2)/2), power = 0.46*powi(dot(x1), 2) - p2*exp(0.20*x1), push = ln(1.60 + 0.81*cos(x1))*ddot(x1) + dot(x1)*ddot(x1))]
pub struct Random110 {
    #[nominal(1.28)]
    pub p1: f64,
    #[nominal(0.77)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[inputs(tau)]
#[inertia(diag((1.25 - 0.13*1/sqrt(1.50 + powi(x1, 2)))))]
#[forces(
    0,
)]
#[constraint(row1: dot(x1) + 0.27*(if x1 <= 0.16 { cos(1.02*x1) } else { 0.54*sin(x1)/(1.50 + cos(x1)) }) == 0)]
#[output(place = (if x1 >= 0.06 { cos(1.07*x1 - 0.46) } else { tan(0.68*sin(x1))/2 }), power = 1.22*powi(dot(x1), 2) - 1.62*powi(dot(x1), 2) - 1.75*sin(p1*x1 + 0.67), push = 1/sqrt(1.50 + powi(x1, 2))*ddot(x1) + dot(x1)*ddot(x1), pull = (1.12 + 0.22*powi(cos(0.92*x1 - 0.77*x1), 3))*reaction(row1) - push, share = pull/(1.50 + powi(reaction(row1), 2)))]
pub struct Random111 {
    #[nominal(1.12)]
    pub p1: f64,
    #[nominal(0.74)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1) + 0.36*(if x1 > 0.20 { powi(cos(0.73*x2), 3) } else { 0.51*sin(x1)/(1.50 + cos(x4)) }),
    v2 = dot(x2) - 0.22*sin(p2*x4 + 0.49)*dot(x4) + 0.28*cos(0.71*x2),
    v3 = 1.32*dot(x3) + 0.18*x6/(1 + powi(x6, 2))*dot(x4) - 0.39*tan(0.77*sin(x2))/2,
    v4 = dot(x4) + 0.29*sin(0.84*x2)*dot(x5) - 0.47*ln(1.60 + 0.85*cos(x6)),
    v5 = (1.08 - 0.28*cos(0.99*x2 - 1.48))*dot(x5) - 0.19*powi(cos(0.50*t - 1.12), 3)*dot(x2) - 0.27*1/sqrt(1.50 + powi(x5, 2)),
    v6 = dot(x6) + 0.31*cos(0.54*x6 - 0.48*x1)*dot(x3) - 0.50*sin(0.47*x3),
)]
#[inertia(matrix(
    [((1.19 + 0.34*1/sqrt(1.50 + powi(x1, 2))))*((1.19 + 0.34*1/sqrt(1.50 + powi(x1, 2)))), ((1.19 + 0.34*1/sqrt(1.50 + powi(x1, 2))))*(0.35*x2/(1 + powi(x2, 2))), 0, 0, ((1.19 + 0.34*1/sqrt(1.50 + powi(x1, 2))))*(0.14*t/(1 + powi(t, 2))), ((1.19 + 0.34*1/sqrt(1.50 + powi(x1, 2))))*(0.12*sin(0.44*x4 + 0.73*x1 + 1.48)*cos(1.13*x1 - 0.55*x2))],
    [_, (0.35*x2/(1 + powi(x2, 2)))*(0.35*x2/(1 + powi(x2, 2))) + ((1.23 + 0.21*sin(0.53*t + 0.69*x4 + 1.19)))*((1.23 + 0.21*sin(0.53*t + 0.69*x4 + 1.19))), ((1.23 + 0.21*sin(0.53*t + 0.69*x4 + 1.19)))*(0.32*sin(0.80*t + 0.93)), ((1.23 + 0.21*sin(0.53*t + 0.69*x4 + 1.19)))*(0.11*sin(p2*x2 - 0.61)), (0.35*x2/(1 + powi(x2, 2)))*(0.14*t/(1 + powi(t, 2))) + ((1.23 + 0.21*sin(0.53*t + 0.69*x4 + 1.19)))*(0.34*cos(1.12*x3)), (0.35*x2/(1 + powi(x2, 2)))*(0.12*sin(0.44*x4 + 0.73*x1 + 1.48)*cos(1.13*x1 - 0.55*x2)) + ((1.23 + 0.21*sin(0.53*t + 0.69*x4 + 1.19)))*(0.18*tan(0.37*sin(x6))/2)],
    [_, _, (0.32*sin(0.80*t + 0.93))*(0.32*sin(0.80*t + 0.93)) + (1.02)*(1.02), (0.32*sin(0.80*t + 0.93))*(0.11*sin(p2*x2 - 0.61)), (0.32*sin(0.80*t + 0.93))*(0.34*cos(1.12*x3)) + (1.02)*(0.18*(if x1 < -0.33 { sin(1.10*t) } else { atan2(x2, 2 + cos(x3))/2 })), (0.32*sin(0.80*t + 0.93))*(0.18*tan(0.37*sin(x6))/2)],
    [_, _, _, (0.11*sin(p2*x2 - 0.61))*(0.11*sin(p2*x2 - 0.61)) + ((1.31 + 0.13*atan2(x6, 2 + cos(x6))/2))*((1.31 + 0.13*atan2(x6, 2 + cos(x6))/2)), (0.11*sin(p2*x2 - 0.61))*(0.34*cos(1.12*x3)) + ((1.31 + 0.13*atan2(x6, 2 + cos(x6))/2))*(0.11*ln(1.60 + 0.69*cos(x2))), (0.11*sin(p2*x2 - 0.61))*(0.18*tan(0.37*sin(x6))/2)],
    [_, _, _, _, (0.14*t/(1 + powi(t, 2)))*(0.14*t/(1 + powi(t, 2))) + (0.34*cos(1.12*x3))*(0.34*cos(1.12*x3)) + (0.18*(if x1 < -0.33 { sin(1.10*t) } else { atan2(x2, 2 + cos(x3))/2 }))*(0.18*(if x1 < -0.33 { sin(1.10*t) } else { atan2(x2, 2 + cos(x3))/2 })) + (0.11*ln(1.60 + 0.69*cos(x2)))*(0.11*ln(1.60 + 0.69*cos(x2))) + ((1.04 + 0.30*wave(1.10*x3 - 0.65*x5)))*((1.04 + 0.30*wave(1.10*x3 - 0.65*x5))), (0.14*t/(1 + powi(t, 2)))*(0.12*sin(0.44*x4 + 0.73*x1 + 1.48)*cos(1.13*x1 - 0.55*x2)) + (0.34*cos(1.12*x3))*(0.18*tan(0.37*sin(x6))/2)],
    [_, _, _, _, _, (0.12*sin(0.44*x4 + 0.73*x1 + 1.48)*cos(1.13*x1 - 0.55*x2))*(0.12*sin(0.44*x4 + 0.73*x1 + 1.48)*cos(1.13*x1 - 0.55*x2)) + (0.18*tan(0.37*sin(x6))/2)*(0.18*tan(0.37*sin(x6))/2) + ((1.16 + 0.15*cos(0.78*x3 - 0.20*x3)))*((1.16 + 0.15*cos(0.78*x3 - 0.20*x3)))],
))]
#[forces(
    p1*v3*v6*powi(cos(0.49*x2), 3) + p1*exp(0.20*x3),
    0,
    1.60*powi(v2, 2) - v6*sqrt(2 + powi(v6, 2)) - p1*x1,
    p1*v4*v5*sin(0.85*x5 + 0.31*x2 + 0.75) - 1.33*powi(v4, 2) - 1.09*powi(v1, 2),
    p2*x3 - 1.28*v2 - 1.32*v5/(1 + powi(t, 2)) - p2*exp(0.20*x2),
    1.71*v5/(1 + powi(x6, 2)) + p1*v4*v3*0.96*sin(x4)/(1.50 + cos(t)),
)]
#[constraint(row1: 1.32*x5 + 0.13*sin(x5) + exp(0.39*x1)/2 + 0.14*x4*x4 + 0.30*sin(0.71*t) + 0.46 == 0)]
#[constraint(row2: 1.89*x6 + 0.33*x1 + 0.30*sin(0.63*t) - 0.58 == 0)]
#[constraint(row3: 1.29*x3 + exp(0.26*x1)/2 + 0.20*x4 + 0.37*x2*x2 + 0.30*sin(0.92*t) - 0.19 == 0)]
pub struct Random112 {
    #[nominal(1.26)]
    pub p1: f64,
    #[nominal(1.29)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inputs(tau)]
#[inertia(diag(1.37, (1.39 - 0.30*cos(0.57*x4 - 0.22*x5)), (1.33 + 0.23*x4/(1 + powi(x4, 2))), (1.33 - 0.14*cos(1.17*x6 - 0.22*x2)), 1.39, 1.32))]
#[forces(
    0,
    dot(x2)*sqrt(2 + powi(dot(x1), 2)) - 1.14*dot(x2)/(1 + powi(x2, 2)) - 0.84*0.97*sin(x6)/(1.50 + cos(x3)) - p1*exp(0.20*x3),
    1.11*dot(x1)/(1 + powi(x3, 2)) + 0.58*dot(x2) + p1*exp(0.20*x3),
    p1*exp(0.20*x6) + p1*exp(0.20*x1),
    p1*x5,
    1.38*(if x6 <= 0.24 { atan2(x4, 2 + cos(x6))/2 } else { sin(p1*x6 - 0.97) }),
)]
#[constraint(row1: 1.58*x5 + 0.20*x4 + 0.29*x1*x1 + 0.16*x3*x1 - 0.23 == 0)]
#[constraint(row2: 1.85*dot(x6) + 0.17*0.31*sin(x2)/(1.50 + cos(x1))*dot(x4) + 0.32*sin(p1*x5 - 0.26)*dot(x1) + 0.31*sin(1.07*x3)*cos(1.18*x5)*dot(x3) == 0)]
pub struct Random113 {
    #[nominal(1.42)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1)]
#[inertia(matrix(
    [((1.28 + 0.25*1/sqrt(1.50 + powi(x1, 2))))*((1.28 + 0.25*1/sqrt(1.50 + powi(x1, 2))))],
))]
#[forces(
    p1*dot(x1)*dot(x1)*(if x1 >= -0.10 { sin(0.61*x1 - 0.38*x1 - 0.51) } else { 0.82*sin(x1)/(1.50 + cos(x1)) }),
)]
#[potential_energy(tan(0.47*sin(x1))/2)]
#[constraint(height: 1.58*x1 + 0.11*sin(x1) - 0.28 == 0)]
#[constraint(height_rate: (1.12 - 0.26*(if x1 < 0.00 { 1/sqrt(1.50 + powi(x1, 2)) } else { sin(p1*x1 - 0.57) }))*(1.58*dot(x1) + 0.11*cos(x1)*dot(x1)) == 0)]
#[output(place = wave(0.68*x1), power = dot(x1)*sqrt(2 + powi(dot(x1), 2)) - dot(x1)*sqrt(2 + powi(dot(x1), 2)) - 1.45*atan2(x1, 2 + cos(x1))/2, push = tan(0.40*sin(x1))/2*ddot(x1) + dot(x1)*ddot(x1))]
pub struct Random114 {
    #[nominal(1.45)]
    pub p1: f64,
    #[nominal(1.49)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + wave(0.44*x1 - 0.65)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - wave(0.44*x1 - 0.65)*(v1),
)]
#[inertia(diag(1.21, (1.34 - 0.12*exp(-powi(x1, 2)/2))))]
#[forces(
    1.97*powi(v2, 2) - v2*sqrt(2 + powi(v1, 2)) - 1.66*v1 - 1.53*powi(v2, 2),
    1.26*v2/(1 + powi(x1, 2)) - tau*0.32 - v2*v2/(1.06 - 0.16*sin(0.78*x1 + 0.81)*cos(1.06*x2)),
)]
#[constraint(height: 1.25*x1 + 0.17*sin(x1) - 0.66 == 0)]
#[constraint(first: (1.50 + 0.10*(if x1 >= 0.08 { sin(p2*x2 - 0.54) } else { cos(1.11*x2) }))*v2 - 0.23*sin(0.59*x1 - 0.49*x1 + 0.89)*v1 == 0)]
#[constraint(second: 1.25*dot(x1) + 0.17*cos(x1)*dot(x1) - 0.50*sin(0.81*x1 - 1.46)*((1.50 + 0.10*(if x1 >= 0.08 { sin(p2*x2 - 0.54) } else { cos(1.11*x2) }))*v2 - 0.23*sin(0.59*x1 - 0.49*x1 + 0.89)*v1) == 0)]
pub struct Random115 {
    #[nominal(1.13)]
    pub p1: f64,
    #[nominal(0.97)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1) - 0.38*cos(0.49*x6 + 0.30*x3)*dot(x4),
    v2 = dot(x2),
    v3 = (1.05 - 0.14*sin(0.47*x2 - 0.72*x6))*dot(x3) - 0.20*(if x2 >= 0.58 { sin(p1*x1 + 0.56) } else { sin(0.52*x1 - 0.37) })*dot(x2),
    v4 = dot(x4) + 0.10*x1/(1 + powi(x1, 2))*dot(x3),
    v5 = (1.04 - 0.12*cos(0.82*x2))*dot(x5) - 0.28*ln(1.60 + 0.43*cos(x4))*dot(x1),
    v6 = (1.37 + 0.25*sin(1.09*x4 + 0.80*x4))*dot(x6) - 0.12*cos(0.43*x6 + 0.27*x6)*dot(x5),
)]
#[define(l11 = (1.25 - 0.33*(if x3 < 0.36 { ln(1.60 + 0.34*cos(x6)) } else { x2/(1 + powi(x2, 2)) })), l21 = 0.32*bump(0.60*x3 - 0.31*x5 + 1.24), l22 = (1.33 + 0.21*powi(cos(0.89*x5), 3)), l33 = 1.30, l41 = 0.32*1/sqrt(1.50 + powi(x4, 2)), l43 = 0.23*0.46*sin(x2)/(1.50 + cos(x6)), l44 = 1.11, l52 = 0.19*sin(0.58*x1 - 0.41), l53 = 0.17*wave(1.01*x5 + 0.65*x4 + 0.62), l54 = 0.18*tan(0.39*sin(x5))/2, l55 = 1.35, l61 = 0.19*cos(1.14*x4), l62 = 0.40*powi(cos(0.80*x2 + 0.41), 3), l63 = 0.20*(if x6 > 0.28 { 0.57*sin(x3)/(1.50 + cos(x6)) } else { bump(1.16*x4 + 0.74) }), l66 = (1.15 - 0.32*sin(0.83*x4 + 0.29)*cos(0.60*x4)))]
#[inertia(matrix(
    [l11*l11, l11*l21, 0, l11*l41, 0, l11*l61],
    [_, l21*l21 + l22*l22, 0, l21*l41, l22*l52, l21*l61 + l22*l62],
    [_, _, l33*l33, l33*l43, l33*l53, l33*l63],
    [_, _, _, l41*l41 + l43*l43 + l44*l44, l43*l53 + l44*l54, l41*l61 + l43*l63],
    [_, _, _, _, l52*l52 + l53*l53 + l54*l54 + l55*l55, l52*l62 + l53*l63],
    [_, _, _, _, _, l61*l61 + l62*l62 + l63*l63 + l66*l66],
))]
#[forces(
    p1*0.92 + 0.99*v2/(1 + powi(x2, 2)) + 0.60*v5/(1 + powi(x1, 2)) + v3*sqrt(2 + powi(v2, 2)),
    0.85*powi(v1, 2),
    p1*0.33 + p1*0.46 + p1*x1,
    1.12*v2 + p1*v2*v5*atan2(x3, 2 + cos(x2))/2 + 0.76*ln(1.60 + 0.66*cos(x3)),
    0,
    1.39*v5/(1 + powi(x1, 2)) - p1*exp(0.20*x4) - 0.64*powi(v2, 2) - p1*exp(0.20*x4),
)]
#[configuration(x2 = 1.11*1/sqrt(1.50 + powi(x5, 2)))]
pub struct Random116 {
    #[nominal(0.63)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    v1 = dot(x1) - 0.47*exp(-powi(x1, 2)/2),
)]
#[define(l11 = (1.26 + 0.29*sin(0.80*t)))]
#[inertia(matrix(
    [l11*l11],
))]
#[forces(
    p1*exp(0.20*x1),
)]
#[potential_energy(sin(1.14*x1)*cos(0.70*x1))]
#[configuration(of(q1), x1 = 1.25*q1)]
#[output(place = cos(0.64*x1 + 0.45*t + 1.27), power = v1*v1/(1.11 + 0.35*wave(1.09*x1 + 0.55*x1)) + p1*1.09 + v1*v1/1.08, push = sin(0.84*t + 0.38*t)*dot(v1) + v1*ddot(x1))]
pub struct Random117 {
    #[nominal(0.64)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + (if x5 > 0.05 { exp(-powi(x4, 2)/2) } else { ln(1.60 + 0.37*cos(x1)) })*dot(x1),
    v3 = dot(x3) + exp(-powi(x2, 2)/2)*dot(x2),
    v4 = dot(x4) + (if x4 < -0.47 { cos(0.48*x2 - 1.49) } else { exp(-powi(x3, 2)/2) })*dot(x3),
    v5 = dot(x5) + x1/(1 + powi(x1, 2))*dot(x2),
    v6 = dot(x6) + (if x1 <= -0.00 { sin(0.56*x2) } else { sin(0.70*x5 - 0.47*x3) })*dot(x3),
    dot(x1) = v1,
    dot(x2) = v2 - (if x5 > 0.05 { exp(-powi(x4, 2)/2) } else { ln(1.60 + 0.37*cos(x1)) })*(v1),
    dot(x3) = v3 - exp(-powi(x2, 2)/2)*(v2 - (if x5 > 0.05 { exp(-powi(x4, 2)/2) } else { ln(1.60 + 0.37*cos(x1)) })*(v1)),
    dot(x4) = v4 - (if x4 < -0.47 { cos(0.48*x2 - 1.49) } else { exp(-powi(x3, 2)/2) })*(v3 - exp(-powi(x2, 2)/2)*(v2 - (if x5 > 0.05 { exp(-powi(x4, 2)/2) } else { ln(1.60 + 0.37*cos(x1)) })*(v1))),
    dot(x5) = v5 - x1/(1 + powi(x1, 2))*(v2 - (if x5 > 0.05 { exp(-powi(x4, 2)/2) } else { ln(1.60 + 0.37*cos(x1)) })*(v1)),
    dot(x6) = v6 - (if x1 <= -0.00 { sin(0.56*x2) } else { sin(0.70*x5 - 0.47*x3) })*(v3 - exp(-powi(x2, 2)/2)*(v2 - (if x5 > 0.05 { exp(-powi(x4, 2)/2) } else { ln(1.60 + 0.37*cos(x1)) })*(v1))),
)]
#[inertia(diag((1.28 - 0.14*ln(1.60 + 0.41*cos(x3))), (1.23 + 0.21*sin(0.44*x2 + 0.88*x1)), (1.14 - 0.12*bump(0.85*x1)), 1.36, (1.35 + 0.16*atan2(x1, 2 + cos(x3))/2), (1.40 + 0.34*(if x1 >= -0.32 { ln(1.60 + 0.45*cos(x5)) } else { powi(cos(0.50*x5), 3) }))))]
#[forces(
    p1*x5 + p2*1.71 + 0.87*(if x4 >= -0.55 { cos(0.60*x5 - 0.60*x2) } else { sin(p2*x6 + 0.90) }) + p1*v6*v6*wave(0.86*x6 + 0.64*x3),
    p1*1.32,
    0,
    1.36*v4/(1 + powi(x5, 2)) + p1*1.88,
    0.95*v6 - 1.96*v6 - p2*exp(0.20*x2) - 0.60*v5/(1 + powi(x6, 2)),
    1.98*1/sqrt(1.50 + powi(x6, 2)) - p1*0.64,
)]
#[configuration(x4 = 0.62*sin(0.88*x5 - 0.77*x1))]
#[constraint(rolling: dot(x6) + 0.22*sin(0.74*x3 + 0.66*x3)*dot(x3) - 0.34*exp(-powi(x3, 2)/2)*dot(x2) + 0.27*(if x2 > -0.04 { cos(1.14*x6) } else { x1/(1 + powi(x1, 2)) })*dot(x5) == 0)]
#[independent(s1 = 1.85*dot(x3) - 0.15*x5/(1 + powi(x5, 2))*dot(x6), s2 = (1.50 - 0.23*0.82*sin(x6)/(1.50 + cos(x1)))*dot(x2) - 0.19*cos(0.42*x2 - 0.73*x3)*dot(x3) + 0.21*(if x5 <= -0.35 { 0.93*sin(x5)/(1.50 + cos(x2)) } else { sin(0.54*x3 - 0.89*x3) })*dot(x6) + 0.57*cos(1.12*x3), dot(x5), s4 = 1.05*dot(x1) - 0.26*(if x2 >= -0.58 { cos(0.74*x1) } else { 1/sqrt(1.50 + powi(x1, 2)) })*dot(x3) + 0.22*0.31*sin(x3)/(1.50 + cos(x1))*dot(x2))]
#[output(place = x1/(1 + powi(x1, 2)), power = p1*x4 + 0.55*v1/(1 + powi(x2, 2)), push = sin(0.47*x6 - 0.22)*dot(v4) + v6*ddot(x6), pull = (1.29 - 0.23*ln(1.60 + 0.94*cos(x3)))*reaction(rolling) - push, share = pull/(1.65 + powi(reaction(rolling), 2)))]
pub struct Random118 {
    #[nominal(0.96)]
    pub p1: f64,
    #[nominal(1.14)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[define(l11 = (1.38 + 0.13*exp(-powi(x4, 2)/2)), l22 = 1.32, l31 = 0.12*bump(0.78*x4), l32 = 0.27*(if x5 <= -0.54 { 0.50*sin(x2)/(1.50 + cos(x4)) } else { bump(0.42*x4) }), l33 = (1.33 + 0.10*wave(1.19*x6)), l42 = 0.10*ln(1.60 + 0.90*cos(x3)), l44 = (1.25 - 0.28*ln(1.60 + 0.76*cos(x6))), l51 = 0.34*sin(0.57*x2 - 0.71), l53 = 0.36*powi(cos(0.61*x5 + 0.40*x4), 3), l54 = 0.34*wave(0.67*x4 + 0.45), l55 = (1.04 - 0.19*sin(0.77*x4 - 0.49*x2)*cos(0.63*x1)), l61 = 0.22*1/sqrt(1.50 + powi(x2, 2)), l62 = 0.34*(if x2 < 0.49 { sin(0.91*x3) } else { sin(0.84*x2 + 0.42*x6 + 0.40) }), l63 = 0.28*tan(0.69*sin(x6))/2, l64 = 0.36*sin(0.96*x2 - 0.51*x5), l65 = 0.30*sin(p1*x2 - 0.23), l66 = (1.22 - 0.20*(if x4 <= 0.41 { powi(cos(0.60*x6 + 0.66*x6), 3) } else { sin(0.88*x6) })))]
#[inertia(matrix(
    [l11*l11, 0, l11*l31, 0, l11*l51, l11*l61],
    [_, l22*l22, l22*l32, l22*l42, 0, l22*l62],
    [_, _, l31*l31 + l32*l32 + l33*l33, l32*l42, l31*l51 + l33*l53, l31*l61 + l32*l62 + l33*l63],
    [_, _, _, l42*l42 + l44*l44, l44*l54, l42*l62 + l44*l64],
    [_, _, _, _, l51*l51 + l53*l53 + l54*l54 + l55*l55, l51*l61 + l53*l63 + l54*l64 + l55*l65],
    [_, _, _, _, _, l61*l61 + l62*l62 + l63*l63 + l64*l64 + l65*l65 + l66*l66],
))]
#[forces(
    p1*exp(0.20*x6) + 0.83*sin(1.10*x4 - 0.66*x4),
    1.58*dot(x2)/(1 + powi(x5, 2)) - p2*exp(0.20*x1) - 0.86*dot(x6),
    p3*0.95 - dot(x5)*sqrt(2 + powi(dot(x2), 2)),
    0,
    1.36*powi(dot(x6), 2) - dot(x1)*sqrt(2 + powi(dot(x1), 2)) - 1.63*powi(dot(x6), 2) - p3*1.77,
    0.97*0.64*sin(x6)/(1.50 + cos(x5)) + p3*x3 + p2*exp(0.20*x2) + p1*1.99,
)]
#[constraint(row1: dot(x6) + 0.52*wave(0.94*x3 - 0.36*x4 - 0.43)*dot(x3) + 0.37*(if x5 >= 0.26 { tan(0.57*sin(x5))/2 } else { bump(0.98*x2) })*dot(x5) == 0)]
#[constraint(row2: dot(x2) + 0.38*1/sqrt(1.50 + powi(x4, 2))*dot(x3) + 0.36*1/sqrt(1.50 + powi(x2, 2))*dot(x5) == 0)]
#[constraint(row3: dot(x1) + 0*dot(x3) + 0*dot(x5) + 0.40*sin(0.81*x2)*cos(0.87*x6) == 0)]
#[constraint(row4: dot(x4) + 0.68*wave(0.49*x1 + 1.39)*dot(x3) + 0.41*wave(0.64*x3 - 0.63*x3)*dot(x5) == 0)]
#[complement(
    w1 = [-(1.34 - 0.29*ln(1.60 + 0.88*cos(x4)))*(0), -(1.34 - 0.29*ln(1.60 + 0.88*cos(x4)))*(0.38*1/sqrt(1.50 + powi(x4, 2))), (1.34 - 0.29*ln(1.60 + 0.88*cos(x4))), -(1.34 - 0.29*ln(1.60 + 0.88*cos(x4)))*(0.68*wave(0.49*x1 + 1.39)), 0, -(1.34 - 0.29*ln(1.60 + 0.88*cos(x4)))*(0.52*wave(0.94*x3 - 0.36*x4 - 0.43))],
    w2 = [-(1.36 + 0.24*(if x4 > 0.52 { x1/(1 + powi(x1, 2)) } else { sin(0.66*x3 + 0.79*x6) }))*(0), -(1.36 + 0.24*(if x4 > 0.52 { x1/(1 + powi(x1, 2)) } else { sin(0.66*x3 + 0.79*x6) }))*(0.36*1/sqrt(1.50 + powi(x2, 2))), 0, -(1.36 + 0.24*(if x4 > 0.52 { x1/(1 + powi(x1, 2)) } else { sin(0.66*x3 + 0.79*x6) }))*(0.41*wave(0.64*x3 - 0.63*x3)), (1.36 + 0.24*(if x4 > 0.52 { x1/(1 + powi(x1, 2)) } else { sin(0.66*x3 + 0.79*x6) })), -(1.36 + 0.24*(if x4 > 0.52 { x1/(1 + powi(x1, 2)) } else { sin(0.66*x3 + 0.79*x6) }))*(0.37*(if x5 >= 0.26 { tan(0.57*sin(x5))/2 } else { bump(0.98*x2) }))],
)]
#[output(place = 0.52*sin(x6)/(1.50 + cos(x1)), power = p2*1.31 - 0.36*cos(0.53*x4 - 0.37*x3), push = sin(1.04*x5)*ddot(x2) + dot(x1)*ddot(x1), pull = 1.11*reaction(row3) - push, share = pull/(1.56 + powi(reaction(row3), 2)))]
pub struct Random119 {
    #[nominal(0.92)]
    pub p1: f64,
    #[nominal(1.38)]
    pub p2: f64,
    #[nominal(1.43)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = (1.03 + 0.18*sin(0.90*x2 - 0.52*x6))*dot(x1) - 0.40*0.59*sin(x5)/(1.50 + cos(x3)),
    v2 = dot(x2) - 0.12*sin(0.45*x4 + 0.90)*dot(x6) + 0.55*powi(cos(1.14*x2 - 0.24*x6), 3),
    v3 = (1.01 + 0.28*(if x3 < -0.25 { atan2(x4, 2 + cos(x1))/2 } else { 1.00*sin(x4)/(1.50 + cos(x4)) }))*dot(x3) + 0.15*sin(1.09*x1)*cos(0.50*x5 + 0.31*x3 - 0.86),
    v4 = (1.02 - 0.28*ln(1.60 + 0.52*cos(x2)))*dot(x4) + 0.53*(if x1 < 0.09 { powi(cos(0.43*x4 + 0.82*x1 - 0.17), 3) } else { bump(0.63*x4 - 0.57*x2 - 1.00) }),
    v5 = (1.14 + 0.30*cos(0.42*x1))*dot(x5) + 0.26*ln(1.60 + 0.30*cos(x5))*dot(x4) - 0.24*ln(1.60 + 0.67*cos(x6)),
    v6 = 1.30*dot(x6) - 0.34*atan2(x4, 2 + cos(x5))/2,
)]
#[define(l11 = (1.09 + 0.34*cos(1.18*x5 - 0.73*x6)), l21 = 0.12*cos(0.93*x2 + 0.78*x1), l22 = (1.05 + 0.16*ln(1.60 + 0.40*cos(x1))), l31 = 0.11*(if x6 >= 0.55 { tan(0.66*sin(x5))/2 } else { bump(0.54*x4 - 0.35*x3) }), l33 = (1.16 - 0.18*(if x5 <= 0.51 { sin(0.97*x4 + 0.34*x6 - 0.89)*cos(0.99*x6) } else { cos(0.97*x5 - 0.47*x2) })), l43 = 0.21*bump(0.46*x4), l44 = (1.13 - 0.23*ln(1.60 + 0.59*cos(x1))), l51 = 0.36*0.59*sin(x4)/(1.50 + cos(x1)), l52 = 0.23*1/sqrt(1.50 + powi(x1, 2)), l53 = 0.32*atan2(x6, 2 + cos(x5))/2, l54 = 0.25*powi(cos(0.42*x1 - 0.29*x6), 3), l55 = (1.38 + 0.15*bump(0.53*x2 + 0.44)), l62 = 0.21*1/sqrt(1.50 + powi(x3, 2)), l63 = 0.32*ln(1.60 + 0.78*cos(x6)), l64 = 0.33*bump(1.13*x3 - 0.66*x3), l65 = 0.18*tan(0.53*sin(x1))/2, l66 = 1.12)]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, 0, l11*l51, 0],
    [_, l21*l21 + l22*l22, l21*l31, 0, l21*l51 + l22*l52, l22*l62],
    [_, _, l31*l31 + l33*l33, l33*l43, l31*l51 + l33*l53, l33*l63],
    [_, _, _, l43*l43 + l44*l44, l43*l53 + l44*l54, l43*l63 + l44*l64],
    [_, _, _, _, l51*l51 + l52*l52 + l53*l53 + l54*l54 + l55*l55, l52*l62 + l53*l63 + l54*l64 + l55*l65],
    [_, _, _, _, _, l62*l62 + l63*l63 + l64*l64 + l65*l65 + l66*l66],
))]
#[forces(
    1.25*v3 - p1*x2 - 1.99*v1/(1 + powi(x2, 2)) - p2*v1*v6*sin(p2*x6 - 0.77),
    1.64*v6/(1 + powi(x6, 2)) + 1.64*v2 + v3*v6/(1.25 + 0.21*exp(-powi(x3, 2)/2)) + p1*exp(0.20*x1),
    p2*0.39 + 1.98*v6/(1 + powi(x5, 2)) + 0.57*(if x4 < 0.07 { 1/sqrt(1.50 + powi(x6, 2)) } else { sin(0.64*x4 - 0.28*x2 - 0.81) }) + 1.27*cos(0.90*x5 + 1.00),
    v1*sqrt(2 + powi(v2, 2)) - 0.60*sin(1.04*x5 + 0.75*x4) - 0.58*powi(v5, 2) - p2*x5,
    v6*sqrt(2 + powi(v3, 2)) + 0.97*v5/(1 + powi(x1, 2)),
    0.50*v4 + p1*x1 + 0.86*powi(v3, 2),
)]
#[constraint(row1: 1.41*x4 + 0.28*sin(x4) + exp(0.31*x6)/2 - 0.30 == 0)]
#[constraint(row2: (1.50 + 0.30*cos(0.42*x5))*v2 + 0.19*1/sqrt(1.50 + powi(x4, 2))*v6 - 0.13*(if x3 > -0.26 { sin(1.20*x2 + 0.66) } else { sin(0.58*x6 + 0.86*x2) })*v4 + 0.22*bump(0.92*x4 + 0.59*x5) == 0)]
#[constraint(row3: 1.29*v5 + 0.17*sin(0.72*x4 + 1.44)*v6 == 0)]
#[constraint(row4: (1.50 - 0.22*(if x5 <= -0.20 { sin(0.81*x1)*cos(0.92*x3) } else { sin(p2*x1 - 0.29) }))*v1 - 0.35*cos(0.60*x6 + 0.37*x2)*v6 + 0.30*ln(1.60 + 0.81*cos(x5))*v4 + 0.17*sin(0.88*x1 - 0.30*x1)*v2 == 0)]
#[constraint(row5: 1.84*v3 + 0.34*sin(1.01*x4)*v6 + 0.22*wave(0.42*x4 - 0.62*x3 + 0.45)*v4 == 0)]
#[independent(v6)]
pub struct Random120 {
    #[nominal(1.10)]
    pub p1: f64,
    #[nominal(1.48)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = 1.34*v1,
    dot(x2) = (1.20 + 0.23*(if x4 >= -0.18 { cos(1.00*x2 - 0.33*x5) } else { wave(0.52*x6 - 0.77*x1 + 0.78) }))*v2 + 0.19*ln(1.60 + 0.47*cos(x2))*v4,
    dot(x3) = v3 + 0.30*wave(1.12*x5)*v4,
    dot(x4) = v4 - 0.18*(if x1 < -0.32 { cos(0.51*x5) } else { cos(0.63*x3 - 0.57*x3) })*v1,
    dot(x5) = v5 - 0.25*atan2(x4, 2 + cos(x4))/2*v1,
    dot(x6) = 1.06*v6 + 0.39*sin(p1*x6 + 0.52)*v5,
)]
#[inertia(matrix(
    [(1.27)*(1.27), (1.27)*(0.26*cos(0.66*x5)), (1.27)*(0.38*atan2(x6, 2 + cos(t))/2), (1.27)*(0.12*sin(p2*x1 - 0.94)), (1.27)*(0.20*atan2(x4, 2 + cos(x5))/2), 0],
    [_, (0.26*cos(0.66*x5))*(0.26*cos(0.66*x5)) + ((1.03 - 0.17*(if x2 < -0.60 { exp(-powi(x4, 2)/2) } else { wave(0.50*x1 - 0.89*x5) })))*((1.03 - 0.17*(if x2 < -0.60 { exp(-powi(x4, 2)/2) } else { wave(0.50*x1 - 0.89*x5) }))), (0.26*cos(0.66*x5))*(0.38*atan2(x6, 2 + cos(t))/2), (0.26*cos(0.66*x5))*(0.12*sin(p2*x1 - 0.94)) + ((1.03 - 0.17*(if x2 < -0.60 { exp(-powi(x4, 2)/2) } else { wave(0.50*x1 - 0.89*x5) })))*(0.22*sin(0.87*x1)*cos(0.69*x5 - 0.61*x3)), (0.26*cos(0.66*x5))*(0.20*atan2(x4, 2 + cos(x5))/2) + ((1.03 - 0.17*(if x2 < -0.60 { exp(-powi(x4, 2)/2) } else { wave(0.50*x1 - 0.89*x5) })))*(0.19*powi(cos(0.58*x3 + 0.22), 3)), 0],
    [_, _, (0.38*atan2(x6, 2 + cos(t))/2)*(0.38*atan2(x6, 2 + cos(t))/2) + ((1.40 - 0.16*(if x3 <= -0.20 { atan2(x3, 2 + cos(x6))/2 } else { tan(0.74*sin(t))/2 })))*((1.40 - 0.16*(if x3 <= -0.20 { atan2(x3, 2 + cos(x6))/2 } else { tan(0.74*sin(t))/2 }))), (0.38*atan2(x6, 2 + cos(t))/2)*(0.12*sin(p2*x1 - 0.94)) + ((1.40 - 0.16*(if x3 <= -0.20 { atan2(x3, 2 + cos(x6))/2 } else { tan(0.74*sin(t))/2 })))*(0.27*cos(0.45*x4)), (0.38*atan2(x6, 2 + cos(t))/2)*(0.20*atan2(x4, 2 + cos(x5))/2), ((1.40 - 0.16*(if x3 <= -0.20 { atan2(x3, 2 + cos(x6))/2 } else { tan(0.74*sin(t))/2 })))*(0.19*1/sqrt(1.50 + powi(t, 2)))],
    [_, _, _, (0.12*sin(p2*x1 - 0.94))*(0.12*sin(p2*x1 - 0.94)) + (0.22*sin(0.87*x1)*cos(0.69*x5 - 0.61*x3))*(0.22*sin(0.87*x1)*cos(0.69*x5 - 0.61*x3)) + (0.27*cos(0.45*x4))*(0.27*cos(0.45*x4)) + ((1.29 - 0.32*tan(0.51*sin(x2))/2))*((1.29 - 0.32*tan(0.51*sin(x2))/2)), (0.12*sin(p2*x1 - 0.94))*(0.20*atan2(x4, 2 + cos(x5))/2) + (0.22*sin(0.87*x1)*cos(0.69*x5 - 0.61*x3))*(0.19*powi(cos(0.58*x3 + 0.22), 3)), (0.27*cos(0.45*x4))*(0.19*1/sqrt(1.50 + powi(t, 2)))],
    [_, _, _, _, (0.20*atan2(x4, 2 + cos(x5))/2)*(0.20*atan2(x4, 2 + cos(x5))/2) + (0.19*powi(cos(0.58*x3 + 0.22), 3))*(0.19*powi(cos(0.58*x3 + 0.22), 3)) + ((1.28 + 0.27*0.98*sin(x4)/(1.50 + cos(x4))))*((1.28 + 0.27*0.98*sin(x4)/(1.50 + cos(x4)))), ((1.28 + 0.27*0.98*sin(x4)/(1.50 + cos(x4))))*(0.24*0.44*sin(x3)/(1.50 + cos(x5)))],
    [_, _, _, _, _, (0.19*1/sqrt(1.50 + powi(t, 2)))*(0.19*1/sqrt(1.50 + powi(t, 2))) + (0.24*0.44*sin(x3)/(1.50 + cos(x5)))*(0.24*0.44*sin(x3)/(1.50 + cos(x5))) + ((1.17 + 0.25*0.87*sin(x1)/(1.50 + cos(x3))))*((1.17 + 0.25*0.87*sin(x1)/(1.50 + cos(x3))))],
))]
#[forces(
    v6*v5/(1.08 - 0.29*0.64*sin(t)/(1.50 + cos(x3))) + 1.06*v1 + tau*1.87 + p1*x4,
    1.24*powi(v1, 2) - tau*1.37,
    p1*x3,
    p2*exp(0.20*x2) + 2.00*powi(v1, 2) + 0.98*powi(cos(1.19*x1 + 0.81*x2), 3),
    0,
    p2*x2 + 1.38*v2/(1 + powi(x3, 2)) + p2*exp(0.20*x1),
)]
#[constraint(row1: 1.32*x3 + 0.27*sin(x3) + 0.30*sin(1.01*t) + 0.62 == 0)]
#[constraint(row2: (1.50 - 0.13*sin(0.78*x3 + 0.59*x4)*cos(0.83*x4 - 0.87*x1))*v2 + 0.16*(if x2 > 0.39 { powi(cos(0.64*x2), 3) } else { cos(0.94*x6 - 0.79*x4) })*v3 - 0.23*powi(cos(0.54*x3), 3) == 0)]
#[constraint(row3: v5 - 0.22*ln(1.60 + 0.43*cos(x3))*v3 + 0.28*1/sqrt(1.50 + powi(x3, 2))*v2 == 0)]
#[constraint(row4: 1.49*v1 + 0.11*atan2(x2, 2 + cos(x3))/2*v3 + 0.26*sin(0.74*x3 - 0.77*x5)*v2 + 0.25*tan(0.52*sin(x6))/2*v5 == 0)]
#[constraint(row5: 1.67*v4 + 0.13*0.63*sin(t)/(1.50 + cos(x5))*v3 + 0.11*sin(0.47*x4)*v2 - 0.22*ln(1.60 + 0.71*cos(x2))*v5 + 0.51*ln(1.60 + 0.78*cos(x3)) == 0)]
#[constraint(row6: 1.71*v6 - 0.12*sin(p2*x4 - 0.55)*v3 - 0.36*powi(cos(0.54*x3 - 1.23), 3) == 0)]
pub struct Random121 {
    #[nominal(1.12)]
    pub p1: f64,
    #[nominal(1.27)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    v1 = dot(x1) + 0.48*powi(cos(0.44*t), 3),
)]
#[inertia(diag((1.16 + 0.30*powi(cos(0.94*t), 3))))]
#[forces(
    1.88*sin(0.48*t + 0.68*x1 - 1.22) - p1*1.39,
)]
#[constraint(row1: 1.89*v1 + 0.17*sin(0.48*t + 0.21*x1)*v1*v1 - 0.26*(if t > -0.08 { sin(p2*t - 0.89) } else { bump(0.99*t + 0.66*x1) }) == 0)]
#[independent(v1)]
#[output(place = cos(0.49*t), power = 1.82*1/sqrt(1.50 + powi(x1, 2)) - 0.60*powi(v1, 2) - 1.12*v1, push = wave(1.07*t + 0.45*x1 - 1.32)*dot(v1) + v1*ddot(x1), pull = 1.37*reaction(row1) - push, share = pull/(1.46 + powi(reaction(row1), 2)))]
pub struct Random122 {
    #[nominal(1.36)]
    pub p1: f64,
    #[nominal(1.28)]
    pub p2: f64,
    #[nominal(0.92)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = 1.35*dot(x1) + 0.21*atan2(x3, 2 + cos(x4))/2*dot(x6) + 0.38*ln(1.60 + 0.42*cos(x3)),
    v2 = 1.33*dot(x2) + 0.34*tan(0.39*sin(x1))/2*dot(x6) + 0.16*sin(0.76*t - 0.12)*cos(0.83*x2 - 0.65*x3),
    v3 = dot(x3) + 0.14*x6/(1 + powi(x6, 2))*dot(x6) + 0.32*bump(0.58*x5 + 0.34*t),
    v4 = 1.32*dot(x4) + 0.16*bump(1.13*x6 - 0.93),
    v5 = 1.35*dot(x5) + 0.38*sin(1.14*x1 - 0.50*x2)*cos(1.04*t)*dot(x4) - 0.15*ln(1.60 + 0.32*cos(x5)),
    v6 = dot(x6) + 0.58*sin(1.07*t),
)]
#[define(l11 = (1.25 - 0.27*atan2(t, 2 + cos(x5))/2), l22 = (1.37 - 0.18*sin(0.82*t)), l31 = 0.13*cos(1.10*x5 - 0.37), l32 = 0.27*ln(1.60 + 0.99*cos(x2)), l33 = (1.07 + 0.34*cos(0.72*x6 - 0.44*x5)), l41 = 0.34*x5/(1 + powi(x5, 2)), l42 = 0.16*tan(0.79*sin(x3))/2, l43 = 0.40*powi(cos(0.43*x6 - 0.64*x6 + 1.41), 3), l44 = 1.33, l51 = 0.19*x1/(1 + powi(x1, 2)), l52 = 0.18*cos(0.88*x3 - 0.31), l55 = 1.22, l61 = 0.40*sin(0.53*x2 - 0.23), l62 = 0.16*0.98*sin(x3)/(1.50 + cos(x6)), l63 = 0.28*sin(0.60*x1)*cos(1.04*t), l64 = 0.28*cos(0.44*x5 + 0.50*x4), l65 = 0.32*tan(0.90*sin(t))/2, l66 = (1.09 + 0.26*sin(0.65*x3 + 0.53*t + 0.55)))]
#[inertia(matrix(
    [l11*l11, 0, l11*l31, l11*l41, l11*l51, l11*l61],
    [_, l22*l22, l22*l32, l22*l42, l22*l52, l22*l62],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l32*l42 + l33*l43, l31*l51 + l32*l52, l31*l61 + l32*l62 + l33*l63],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44, l41*l51 + l42*l52, l41*l61 + l42*l62 + l43*l63 + l44*l64],
    [_, _, _, _, l51*l51 + l52*l52 + l55*l55, l51*l61 + l52*l62 + l55*l65],
    [_, _, _, _, _, l61*l61 + l62*l62 + l63*l63 + l64*l64 + l65*l65 + l66*l66],
))]
#[forces(
    1.77*exp(-powi(x5, 2)/2) - 0.32*v1 - v2*v6/(1.11 + 0.30*sin(0.50*x2 - 0.39*x3 - 0.39)) - p1*v6*v4*(if x1 < 0.41 { 0.54*sin(x1)/(1.50 + cos(x5)) } else { sin(0.79*x1 + 0.37*x3) }),
    0.76*powi(v1, 2),
    p3*1.28 + p1*v5*v1*0.90*sin(t)/(1.50 + cos(t)) + 1.74*v2/(1 + powi(x5, 2)),
    0,
    p1*v3*v5*sin(0.52*x1)*cos(0.67*t + 0.70*x1) - p1*1.04 - p3*x4 - 1.47*sin(0.47*x2 + 1.08),
    p2*x3 - p2*0.74,
)]
#[constraint(row1: ddot(x2) - 0.17*cos(0.82*t + 1.28)*dot(v6) + 0.20*sin(0.48*x5 + 0.33*t)*dot(v4) + 0.56*x1/(1 + powi(x1, 2)) == 0)]
pub struct Random123 {
    #[nominal(0.79)]
    pub p1: f64,
    #[nominal(1.03)]
    pub p2: f64,
    #[nominal(1.40)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = v1 + 0.14*(if x2 < -0.02 { wave(1.14*x1) } else { sin(0.51*t + 0.23*x1) })*v2 - 0.36*bump(0.46*x2),
    dot(x2) = v2 - 0.15*cos(1.19*t)*v1 + 0.25*tan(0.85*sin(t))/2,
)]
#[inertia(matrix(
    [((1.10 + 0.28*cos(1.04*x2 - 0.47*t)))*((1.10 + 0.28*cos(1.04*x2 - 0.47*t))), 0],
    [_, ((1.33 + 0.23*sin(0.58*t + 0.22*x2)))*((1.33 + 0.23*sin(0.58*t + 0.22*x2)))],
))]
#[forces(
    0,
    0.74*v1 - tau*1.56 - tau*1.62,
)]
#[constraint(row1: 1.88*x1 + 0.24*sin(x1) + 0.30*sin(0.82*t) + 0.11 == 0)]
#[constraint(row2: 1.63*v2 - 0.12*sqrt(1.50 + powi(v1, 2) + powi(v1, 2)) + 0.51*sin(1.15*t + 0.23*x1) == 0)]
#[independent(s1 = 1.57*v2 - 0.33*1/sqrt(1.50 + powi(x2, 2))*v1)]
pub struct Random124 {
    #[nominal(0.68)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + 0.49*sin(x2)/(1.50 + cos(x3))*dot(x1),
    v3 = dot(x3) + 1/sqrt(1.50 + powi(x1, 2))*dot(x2),
    v4 = dot(x4) + (if x2 < 0.24 { ln(1.60 + 0.46*cos(x5)) } else { atan2(x6, 2 + cos(x4))/2 })*dot(x1),
    v5 = dot(x5) + 1/sqrt(1.50 + powi(x5, 2))*dot(x2),
    v6 = dot(x6) + sin(1.19*x1)*dot(x4),
    dot(x1) = v1,
    dot(x2) = v2 - 0.49*sin(x2)/(1.50 + cos(x3))*(v1),
    dot(x3) = v3 - 1/sqrt(1.50 + powi(x1, 2))*(v2 - 0.49*sin(x2)/(1.50 + cos(x3))*(v1)),
    dot(x4) = v4 - (if x2 < 0.24 { ln(1.60 + 0.46*cos(x5)) } else { atan2(x6, 2 + cos(x4))/2 })*(v1),
    dot(x5) = v5 - 1/sqrt(1.50 + powi(x5, 2))*(v2 - 0.49*sin(x2)/(1.50 + cos(x3))*(v1)),
    dot(x6) = v6 - sin(1.19*x1)*(v4 - (if x2 < 0.24 { ln(1.60 + 0.46*cos(x5)) } else { atan2(x6, 2 + cos(x4))/2 })*(v1)),
)]
#[inertia(diag(1.03, (1.19 + 0.13*tan(0.43*sin(x1))/2), 1.34, (1.30 + 0.34*x3/(1 + powi(x3, 2))), 1.13, (1.31 - 0.34*sin(1.02*x6))))]
#[forces(
    1.85*v2/(1 + powi(x6, 2)),
    0.39*ln(1.60 + 0.57*cos(x5)) - v1*v6/(1.38 + 0.11*cos(1.05*x3 + 0.25)),
    v2*sqrt(2 + powi(v1, 2)),
    p2*v2*v1*0.82*sin(x5)/(1.50 + cos(x1)) + p3*v5*v2*(if x1 < 0.37 { cos(0.95*x5 - 0.17) } else { 1/sqrt(1.50 + powi(x2, 2)) }) + p2*1.82 + v2*sqrt(2 + powi(v6, 2)),
    p1*0.88 - v1*sqrt(2 + powi(v2, 2)),
    1.13*v5 - p3*exp(0.20*x6),
)]
#[constraint(row1: 1.05*v4 + 0.21*cos(0.48*x6)*v2 + 0.33*sin(p2*x5 + 0.57)*v5 - 0.49*1/sqrt(1.50 + powi(x1, 2)) == 0)]
#[constraint(row2: ddot(x3) - 0.25*wave(0.56*x4 - 0.30*x6 - 1.08)*dot(v2) + 0.10*sin(1.01*x2)*cos(1.01*x2 + 0.53*x4)*dot(v5) + 0.33*v5*v6*sin(0.95*x4 - 0.81*x1) == 0)]
#[independent(v1, v6, v5, v2, v3)]
#[output(place = (if x2 >= 0.50 { 0.58*sin(x4)/(1.50 + cos(x1)) } else { sin(0.41*x5 - 0.44*x3 - 0.17)*cos(0.48*x5) }), power = 0.34*sin(1.03*x6 - 0.81)*cos(0.43*x3) - p1*v5*v1*sin(0.76*x6 + 0.34*x6) - p3*x5 - p1*exp(0.20*x6), push = wave(0.42*x4 + 0.67*x1 + 1.22)*dot(v5) + v6*ddot(x6), pull = (1.34 - 0.16*exp(-powi(x2, 2)/2))*reaction(row2) - push, share = pull/(1.67 + powi(reaction(row2), 2)))]
pub struct Random125 {
    #[nominal(1.06)]
    pub p1: f64,
    #[nominal(0.87)]
    pub p2: f64,
    #[nominal(1.46)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + (if x3 <= -0.39 { powi(cos(0.56*x2 - 0.29*x6), 3) } else { ln(1.60 + 0.49*cos(x2)) })*dot(x1),
    v3 = dot(x3) + exp(-powi(x6, 2)/2)*dot(x1),
    v4 = dot(x4) + sin(0.66*x1)*cos(0.66*x1 + 0.67*x2 - 1.06)*dot(x2),
    v5 = dot(x5) + (if x1 < 0.57 { sin(0.99*x6 + 0.52*x1) } else { sin(0.70*x1 - 0.62*x3) })*dot(x3),
    v6 = dot(x6) + exp(-powi(x6, 2)/2)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - (if x3 <= -0.39 { powi(cos(0.56*x2 - 0.29*x6), 3) } else { ln(1.60 + 0.49*cos(x2)) })*(v1),
    dot(x3) = v3 - exp(-powi(x6, 2)/2)*(v1),
    dot(x4) = v4 - sin(0.66*x1)*cos(0.66*x1 + 0.67*x2 - 1.06)*(v2 - (if x3 <= -0.39 { powi(cos(0.56*x2 - 0.29*x6), 3) } else { ln(1.60 + 0.49*cos(x2)) })*(v1)),
    dot(x5) = v5 - (if x1 < 0.57 { sin(0.99*x6 + 0.52*x1) } else { sin(0.70*x1 - 0.62*x3) })*(v3 - exp(-powi(x6, 2)/2)*(v1)),
    dot(x6) = v6 - exp(-powi(x6, 2)/2)*(v1),
)]
#[kinetic_energy(powi(((1.24 + 0.19*atan2(x4, 2 + cos(x4))/2))*v1 + (0.21*(if x6 <= -0.30 { 1/sqrt(1.50 + powi(x4, 2)) } else { sin(0.80*x5) }))*v4 + (0.12*cos(1.10*x3 + 0.26*x4 - 0.71))*v5 + (0.23*(if x6 > 0.01 { sin(1.03*x5 - 0.79*x2)*cos(0.56*x4 + 0.59*x5 - 1.25) } else { powi(cos(1.05*x6 - 0.32*x4), 3) }))*v6, 2)/2 + powi((1.24)*v2 + (0.32*(if x2 >= 0.13 { x4/(1 + powi(x4, 2)) } else { atan2(x5, 2 + cos(x3))/2 }))*v4 + (0.10*sin(0.67*x3 + 0.72*x6)*cos(0.86*x2))*v5, 2)/2 + powi(((1.10 - 0.30*1/sqrt(1.50 + powi(x3, 2))))*v3 + (0.40*sin(1.18*x2 - 0.48*x5 + 0.97))*v5 + (0.33*tan(0.70*sin(x2))/2)*v6, 2)/2 + powi(((1.18 - 0.24*(if x1 >= 0.21 { ln(1.60 + 0.72*cos(x2)) } else { bump(0.68*x3 + 0.75*x2 - 0.60) })))*v4 + (0.22*ln(1.60 + 0.35*cos(x4)))*v6, 2)/2 + powi(((1.01 + 0.26*x5/(1 + powi(x5, 2))))*v5 + (0.13*0.98*sin(x5)/(1.50 + cos(x2)))*v6, 2)/2 + powi((1.06)*v6, 2)/2 - 0.70*x3/(1 + powi(x3, 2))*v1 - 0.24*ln(1.60 + 0.62*cos(x4))*v2)]
#[forces(
    0,
    tau*0.86 - 0.93*powi(v4, 2) - p1*exp(0.20*x6),
    v3*v5/1.25 + v5*sqrt(2 + powi(v1, 2)) + tau*1.94,
    p3*x5,
    0,
    1.48*sin(1.05*x3 + 0.24*x4),
)]
#[constraint(row1: 1.86*x3 + 0.21*sin(x3) + 0.39*x4 + 0.35*x1 - 0.38 == 0)]
#[constraint(row2: 1.39*v5 + 0.33*tan(0.91*sin(x4))/2*v4 == 0)]
#[constraint(row3: powi(v6, 2) + 0.23*powi(v1, 2) - (2 + 0.23*sin(p2*x6 - 0.86)) == 0)]
#[constraint(row4: ddot(x2) - 0.19*1/sqrt(1.50 + powi(x6, 2))*dot(v4) - 0.25*(if x3 <= 0.52 { cos(0.56*x3) } else { sin(1.10*x6 - 0.94) })*dot(v1) + 0.48*v2*v4*sin(0.88*x4 + 0.89)*cos(1.06*x5) == 0)]
pub struct Random126 {
    #[nominal(1.11)]
    pub p1: f64,
    #[nominal(0.56)]
    pub p2: f64,
    #[nominal(0.79)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    dot(x1) = (1.17 - 0.30*(if t > 0.23 { x6/(1 + powi(x6, 2)) } else { exp(-powi(x6, 2)/2) }))*v1 - 0.27*1/sqrt(1.50 + powi(x2, 2))*v3 + 0.30*cos(0.85*x6 + 0.86*x4),
    dot(x2) = v2 + 0.28*wave(0.70*x3 - 0.16)*v6 + 0.12*(if x5 >= 0.12 { sin(p1*x4 + 0.41) } else { sin(1.00*t) }),
    dot(x3) = v3 + 0.37*x2/(1 + powi(x2, 2))*v5 - 0.18*powi(cos(0.64*x2 + 1.13), 3),
    dot(x4) = (1.11 - 0.22*sin(0.42*x3 - 1.10))*v4 - 0.16*ln(1.60 + 0.41*cos(x6))*v3 - 0.49*0.86*sin(t)/(1.50 + cos(x5)),
    dot(x5) = (1.15 + 0.20*(if x3 <= 0.38 { exp(-powi(x5, 2)/2) } else { 1/sqrt(1.50 + powi(x1, 2)) }))*v5 + 0.17*(if x6 <= 0.25 { 0.86*sin(x2)/(1.50 + cos(x2)) } else { 0.80*sin(x6)/(1.50 + cos(t)) })*v1 - 0.33*sin(0.54*x2 + 0.36),
    dot(x6) = (1.25 - 0.22*sin(1.19*x2)*cos(0.53*x3 - 0.28))*v6 - 0.37*ln(1.60 + 0.34*cos(x1))*v3 + 0.55*powi(cos(0.64*x3 + 0.88*x3), 3),
)]
#[inertia(matrix(
    [((1.13 - 0.28*sin(p2*x4 + 0.12)))*((1.13 - 0.28*sin(p2*x4 + 0.12))), 0, 0, ((1.13 - 0.28*sin(p2*x4 + 0.12)))*(0.21*sin(0.43*x5)), ((1.13 - 0.28*sin(p2*x4 + 0.12)))*(0.39*powi(cos(1.08*x6 + 0.85*x6), 3)), 0],
    [_, ((1.31 + 0.26*x1/(1 + powi(x1, 2))))*((1.31 + 0.26*x1/(1 + powi(x1, 2)))), 0, ((1.31 + 0.26*x1/(1 + powi(x1, 2))))*(0.29*x1/(1 + powi(x1, 2))), 0, 0],
    [_, _, ((1.16 - 0.17*cos(0.89*t - 0.59*x1)))*((1.16 - 0.17*cos(0.89*t - 0.59*x1))), ((1.16 - 0.17*cos(0.89*t - 0.59*x1)))*(0.39*sin(0.90*t)*cos(1.06*x6 + 0.22*x5)), ((1.16 - 0.17*cos(0.89*t - 0.59*x1)))*(0.30*(if x2 >= 0.39 { sin(p2*x2 - 0.24) } else { 0.97*sin(x5)/(1.50 + cos(t)) })), ((1.16 - 0.17*cos(0.89*t - 0.59*x1)))*(0.19*wave(1.01*x5 - 0.60*x1))],
    [_, _, _, (0.21*sin(0.43*x5))*(0.21*sin(0.43*x5)) + (0.29*x1/(1 + powi(x1, 2)))*(0.29*x1/(1 + powi(x1, 2))) + (0.39*sin(0.90*t)*cos(1.06*x6 + 0.22*x5))*(0.39*sin(0.90*t)*cos(1.06*x6 + 0.22*x5)) + ((1.01 - 0.19*atan2(x4, 2 + cos(x1))/2))*((1.01 - 0.19*atan2(x4, 2 + cos(x1))/2)), (0.21*sin(0.43*x5))*(0.39*powi(cos(1.08*x6 + 0.85*x6), 3)) + (0.39*sin(0.90*t)*cos(1.06*x6 + 0.22*x5))*(0.30*(if x2 >= 0.39 { sin(p2*x2 - 0.24) } else { 0.97*sin(x5)/(1.50 + cos(t)) })) + ((1.01 - 0.19*atan2(x4, 2 + cos(x1))/2))*(0.32*sin(p2*x1 - 0.99)), (0.39*sin(0.90*t)*cos(1.06*x6 + 0.22*x5))*(0.19*wave(1.01*x5 - 0.60*x1)) + ((1.01 - 0.19*atan2(x4, 2 + cos(x1))/2))*(0.16*wave(1.06*x2))],
    [_, _, _, _, (0.39*powi(cos(1.08*x6 + 0.85*x6), 3))*(0.39*powi(cos(1.08*x6 + 0.85*x6), 3)) + (0.30*(if x2 >= 0.39 { sin(p2*x2 - 0.24) } else { 0.97*sin(x5)/(1.50 + cos(t)) }))*(0.30*(if x2 >= 0.39 { sin(p2*x2 - 0.24) } else { 0.97*sin(x5)/(1.50 + cos(t)) })) + (0.32*sin(p2*x1 - 0.99))*(0.32*sin(p2*x1 - 0.99)) + ((1.21 - 0.32*sin(p2*t + 0.90)))*((1.21 - 0.32*sin(p2*t + 0.90))), (0.30*(if x2 >= 0.39 { sin(p2*x2 - 0.24) } else { 0.97*sin(x5)/(1.50 + cos(t)) }))*(0.19*wave(1.01*x5 - 0.60*x1)) + (0.32*sin(p2*x1 - 0.99))*(0.16*wave(1.06*x2)) + ((1.21 - 0.32*sin(p2*t + 0.90)))*(0.26*sin(p2*t - 0.43))],
    [_, _, _, _, _, (0.19*wave(1.01*x5 - 0.60*x1))*(0.19*wave(1.01*x5 - 0.60*x1)) + (0.16*wave(1.06*x2))*(0.16*wave(1.06*x2)) + (0.26*sin(p2*t - 0.43))*(0.26*sin(p2*t - 0.43)) + (1.24)*(1.24)],
))]
#[forces(
    p1*1.91 + 1.20*powi(v5, 2) + 0.52*v6/(1 + powi(x3, 2)) + 1.41*powi(v5, 2),
    v6*sqrt(2 + powi(v4, 2)),
    p1*exp(0.20*x2),
    1.47*v3/(1 + powi(x6, 2)) - 1.81*powi(v6, 2) - p1*v5*v6*ln(1.60 + 0.90*cos(x3)) - 1.65*v4,
    p2*v5*v1*sin(1.11*x4 + 0.58)*cos(0.42*x3 + 0.66*x1) + 1.41*powi(v3, 2) + 0.65*v2,
    1.81*v4/(1 + powi(t, 2)) + 0.64*powi(v3, 2) + 0.63*sin(1.07*x5 + 0.66),
)]
#[constraint(row1: v1 - 0.20*tan(0.46*sin(t))/2*v5 == 0)]
#[constraint(row2: v2 - 0.18*(if x5 >= 0.39 { powi(cos(0.49*x4), 3) } else { sin(0.96*x3)*cos(0.48*x1) })*v5 - 0.28*cos(0.40*x4)*v3 - 0.11*powi(cos(1.18*x6 - 0.26*x1 - 0.41), 3)*v6 == 0)]
#[constraint(row3: v4 + 0.16*(if x1 > 0.38 { cos(0.74*x4 + 0.26*x4) } else { 0.97*sin(t)/(1.50 + cos(x2)) })*v5 - 0.22*sin(0.57*x6 + 1.44)*v3 + 0.15*cos(0.62*x6 - 0.81*x1 - 0.67)*v6 == 0)]
#[constraint(again1: (1.36 - 0.33*sin(1.08*x3 - 0.27*x1))*(v4 + 0.16*(if x1 > 0.38 { cos(0.74*x4 + 0.26*x4) } else { 0.97*sin(t)/(1.50 + cos(x2)) })*v5 - 0.22*sin(0.57*x6 + 1.44)*v3 + 0.15*cos(0.62*x6 - 0.81*x1 - 0.67)*v6) == 0, redundant)]
#[constraint(again2: (1.33 + 0.25*(if x4 < 0.21 { sin(1.04*x5)*cos(0.99*x6) } else { 1/sqrt(1.50 + powi(t, 2)) }))*(v4 + 0.16*(if x1 > 0.38 { cos(0.74*x4 + 0.26*x4) } else { 0.97*sin(t)/(1.50 + cos(x2)) })*v5 - 0.22*sin(0.57*x6 + 1.44)*v3 + 0.15*cos(0.62*x6 - 0.81*x1 - 0.67)*v6) + 0.37*(v1 - 0.20*tan(0.46*sin(t))/2*v5) == 0, redundant)]
#[output(place = bump(0.54*t + 0.77*x1), power = p1*v3*v5*sin(0.40*x3 + 0.60*x1 + 1.11) + p2*v1*v3*sin(1.20*x2 + 0.75*x1) + v6*sqrt(2 + powi(v1, 2)), push = atan2(x5, 2 + cos(x5))/2*dot(v2) + v2*ddot(x2), pull = (1.19 + 0.26*sin(1.19*t))*reaction(row1) - push, share = pull/(1.05 + powi(reaction(row1), 2)))]
pub struct Random127 {
    #[nominal(0.68)]
    pub p1: f64,
    #[nominal(0.78)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1)]
#[inertia(matrix(
    [((1.34 + 0.26*tan(0.78*sin(x1))/2))*((1.34 + 0.26*tan(0.78*sin(x1))/2))],
))]
#[forces(
    dot(x1)*dot(x1)/1.36 + p1*exp(0.20*x1) + 1.74*powi(dot(x1), 2),
)]
#[constraint(row1: 1.48*x1 + 0.11*sin(x1) - 0.62 == 0)]
#[output(place = (if x1 > -0.58 { bump(0.64*x1 + 0.47) } else { cos(0.72*x1) }), power = p2*exp(0.20*x1) + 1.77*powi(dot(x1), 2) + dot(x1)*sqrt(2 + powi(dot(x1), 2)) + 1.35*dot(x1), push = sin(0.73*x1)*ddot(x1) + dot(x1)*ddot(x1), pull = (1.04 + 0.13*sin(0.61*x1))*reaction(row1) - push, share = pull/(1.59 + powi(reaction(row1), 2)))]
pub struct Random128 {
    #[nominal(0.70)]
    pub p1: f64,
    #[nominal(1.39)]
    pub p2: f64,
    #[nominal(1.25)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[kinetic_energy((1.06 + 0.19*sin(1.16*x6 + 0.74*x5)*cos(0.65*x5 + 0.76*x3 + 0.65))*powi(dot(x1), 2)/2 + 1.13*powi(dot(x2), 2)/2 + (1.01 - 0.13*sin(0.44*x3 + 0.47*x2 + 0.83)*cos(0.57*x2 - 1.49))*powi(dot(x3), 2)/2 + 1.01*powi(dot(x4), 2)/2 + (1.34 + 0.31*sin(0.47*x5))*powi(dot(x5), 2)/2 + (1.16 + 0.21*exp(-powi(x4, 2)/2))*powi(dot(x6), 2)/2 - 0.50*cos(0.54*x3 + 0.34*x4)*dot(x1) - 0.32*wave(0.97*x6 - 0.66*x2)*dot(x2) + 0.52*wave(1.09*x2 + 0.49*x3)*dot(x5))]
#[forces(
    0.72*powi(dot(x4), 2) + 1.84*dot(x6)/(1 + powi(x3, 2)),
    p2*dot(x4)*dot(x5)*1/sqrt(1.50 + powi(x5, 2)),
    0,
    p2*1.53,
    dot(x4)*sqrt(2 + powi(dot(x6), 2)) - p1*dot(x1)*dot(x2)*(if x2 > -0.43 { sin(0.97*x2 - 0.76*x3)*cos(0.69*x3 + 0.38*x5 + 1.05) } else { sin(0.86*x3) }) - dot(x6)*sqrt(2 + powi(dot(x5), 2)) - p1*dot(x4)*dot(x6)*sin(1.10*x5 - 0.42*x2),
    0,
)]
#[configuration(x5 = 1.34*cos(0.81*x6), x1 = 1.43*sin(1.13*x4))]
#[constraint(bound: ddot(x6) + 0.14*0.49*sin(x4)/(1.50 + cos(x5))*ddot(x4) + 0.12*(if x1 > -0.50 { atan2(x1, 2 + cos(x1))/2 } else { 0.59*sin(x6)/(1.50 + cos(x4)) })*ddot(x3) - 0.32*atan2(x4, 2 + cos(x2))/2 == 0)]
#[output(place = exp(-powi(x5, 2)/2), power = p2*dot(x2)*dot(x4)*powi(cos(1.00*x1 + 1.13), 3) - 1.30*powi(dot(x2), 2) - p2*x2 - dot(x2)*dot(x2)/(1.09 + 0.22*atan2(x3, 2 + cos(x5))/2), push = sin(0.69*x2 - 0.44*x6)*ddot(x6) + dot(x1)*ddot(x1), pull = 1.09*reaction(bound) - push, share = pull/(1.72 + powi(reaction(bound), 2)))]
pub struct Random129 {
    #[nominal(0.95)]
    pub p1: f64,
    #[nominal(1.32)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag(1.24, (1.01 - 0.25*cos(0.78*t - 0.87*x2))))]
#[forces(
    1.17*powi(dot(x1), 2),
    1.48*powi(dot(x2), 2) - p1*dot(x1)*dot(x2)*exp(-powi(x1, 2)/2),
)]
#[potential_energy(ln(1.60 + 0.39*cos(x2)))]
#[constraint(row1: 1.19*x1 + 0.10*sin(x1) + 0.99*x2 + 0.10*cos(x2) + 0.20*0.5 + 0.30*sin(t) == 0)]
#[independent(dot(x2))]
#[independent(dot(x1))]
pub struct Random130 {
    #[nominal(1.24)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 6)]
#[coordinates(x[n])]
#[speeds(v[n])]
#[kinematics(
    v[i] = 1.22*k[i]*dot(x[i]) + 0.20*s[(i + 1) % n]*dot(x[(i + 1) % n]) - 0.39*s[i] for i in 0..n,
)]
#[define(s[i] = sin(1.07*x[i] + i/2 - 0.87 + t/2) for i in 0..n)]
#[define(r[0] = s[0]/2, r[i] = (r[i - 1] + s[i])/2 for i in 1..n)]
#[inertia(matrix(
    [(1.28 + k[i]*r[i]/4)*(1.28 + k[j]*r[j]/4)/(1 + 2*powi(i - j, 2)) for j in 0..n] for i in 0..n,
))]
#[forces(
    0.66*sum(0..n, |j| sin(x[i] - x[j])*v[j]) - 0.66*k[i]*v[i] - product(0..=i, |j| s[j]) for i in 0..n,
)]
#[constraint(row[i]: 1.26*x[i] + sin(x[i])/8 - 0.12*powi(x[n - 1], 2) + 0.36*s[n - 1] == 0 for i in 0..4)]
#[independent(v[i] for i in 4..n)]
pub struct Random131 {
    #[nominal(0.63)]
    pub p1: f64,
    #[nominal(1.01)]
    pub k: [f64; 6],
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = (1.19 + 0.24*exp(-powi(x2, 2)/2))*v1 - 0.36*0.72*sin(x2)/(1.50 + cos(x2)),
    dot(x2) = 1.09*v2 + 0.38*tan(0.31*sin(x1))/2,
)]
#[kinetic_energy(1.40*powi(v1, 2)/2 + (1.14 + 0.22*wave(1.07*x2 + 0.34*x1))*powi(v2, 2)/2)]
#[forces(
    v2*v2/(1.40 - 0.31*wave(0.89*x2 + 0.72*x1)) + v2*v1/(1.22 - 0.23*(if x2 < -0.21 { powi(cos(1.08*x1 - 0.51*x1), 3) } else { sin(0.51*x1)*cos(1.14*x2 - 0.57*x1) })) + 1.30*v1,
    0.64*bump(0.94*x2 - 0.54*x1) + 1.82*v2/(1 + powi(x2, 2)),
)]
pub struct Random132 {
    #[nominal(0.62)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1)]
#[kinetic_energy(powi(((1.20 + 0.13*(if x1 > 0.51 { tan(0.90*sin(x1))/2 } else { sin(0.80*x1) })))*dot(x1), 2)/2 - 0.48*cos(1.01*x1))]
#[forces(
    1.04*powi(dot(x1), 2) - dot(x1)*sqrt(2 + powi(dot(x1), 2)) - p1*1.50,
)]
#[constraint(row1: (1.50 + 0.17*sin(0.42*x1)*cos(0.63*x1 + 0.34*x1))*dot(x1) == 0)]
#[output(place = wave(1.18*x1 - 0.79*x1 - 1.43), power = dot(x1)*dot(x1)/1.02 - p1*1.87, push = atan2(x1, 2 + cos(x1))/2*ddot(x1) + dot(x1)*ddot(x1), pull = 1.00*reaction(row1) - push, share = pull/(1.68 + powi(reaction(row1), 2)))]
pub struct Random133 {
    #[nominal(1.40)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = (1.17 - 0.34*sin(1.07*x1 + 0.53*x2)*cos(0.93*x2 + 0.55*x1))*v1 + 0.38*sin(1.09*x2),
    dot(x2) = (1.05 + 0.32*powi(cos(0.49*x1 - 0.81*x2 + 0.77), 3))*v2 - 0.23*cos(0.43*x2 - 0.66*x1 - 0.52)*v1 + 0.37*sin(0.91*x2 + 0.23*x1),
)]
#[inertia(diag((1.07 - 0.34*wave(1.07*x1)), (1.27 - 0.11*cos(0.76*x2))))]
#[forces(
    p1*v2*v1*1/sqrt(1.50 + powi(x1, 2)) + p1*x2 + v1*v1/1.16 + 1.78*wave(0.89*x2),
    1.45*v1,
)]
#[potential_energy((if x1 <= 0.36 { 0.93*sin(x1)/(1.50 + cos(x1)) } else { 1/sqrt(1.50 + powi(x1, 2)) }))]
#[constraint(row1: 1.46*x2 + 0.29*x1*x1 + 0.58 == 0)]
pub struct Random134 {
    #[nominal(1.32)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1)]
#[inertia(diag((1.34 + 0.17*bump(1.15*x1 - 0.22))))]
#[forces(
    p3*1.84 - dot(x1)*sqrt(2 + powi(dot(x1), 2)),
)]
#[constraint(row1: 1.32*dot(x1) == 0)]
pub struct Random135 {
    #[nominal(1.38)]
    pub p1: f64,
    #[nominal(1.23)]
    pub p2: f64,
    #[nominal(1.31)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    dot(x1) = v1,
)]
#[kinetic_energy((1.31 - 0.33*exp(-powi(x1, 2)/2))*powi(v1, 2)/2 + 0.54*sin(0.43*x1 + 0.87*x1)*cos(0.58*x1 + 0.69*x1)*v1 + 0.36*sin(1.05*x1)*cos(1.10*x1 + 0.22*x1 + 0.94))]
#[forces(
    1.85*v1/(1 + powi(x1, 2)),
)]
#[potential_energy((if x1 >= 0.35 { sin(1.18*x1 - 0.41*x1) } else { tan(0.73*sin(x1))/2 }))]
#[constraint(height: 1.27*x1 + 0.21*sin(x1) + 0.55 == 0)]
#[constraint(height_rate: 1.27*dot(x1) + 0.21*cos(x1)*dot(x1) == 0)]
pub struct Random136 {
    #[nominal(0.76)]
    pub p1: f64,
    #[nominal(1.26)]
    pub p2: f64,
    #[nominal(0.73)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = v1 + 0.38*sin(0.42*x2),
    dot(x2) = (1.15 + 0.28*x2/(1 + powi(x2, 2)))*v2 + 0.25*wave(0.98*x1 - 1.04)*v1 - 0.50*(if x2 < 0.37 { 1/sqrt(1.50 + powi(x1, 2)) } else { 1/sqrt(1.50 + powi(x2, 2)) }),
)]
#[define(l11 = (1.06 - 0.29*atan2(x2, 2 + cos(x2))/2), l22 = (1.16 - 0.24*powi(cos(0.43*x1), 3)))]
#[kinetic_energy(powi(l11*v1, 2)/2 + powi(l22*v2, 2)/2 - 0.50*powi(cos(0.50*x1 - 0.80), 3)*v1)]
#[forces(
    p3*exp(0.20*x2),
    1.09*v1,
)]
#[potential_energy(exp(-powi(x1, 2)/2))]
#[constraint(height: 1.38*x1 - 0.16 == 0)]
#[constraint(first: v2 + 0.32*sin(0.99*x1 + 0.34*x1 + 1.34)*v1 == 0)]
#[constraint(second: 1.38*dot(x1) - 0.50*bump(0.98*x2 - 0.68*x1)*(v2 + 0.32*sin(0.99*x1 + 0.34*x1 + 1.34)*v1) == 0)]
pub struct Random137 {
    #[nominal(1.14)]
    pub p1: f64,
    #[nominal(0.89)]
    pub p2: f64,
    #[nominal(1.16)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + cos(0.75*x2)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - cos(0.75*x2)*(v1),
)]
#[inertia(matrix(
    [((1.22 + 0.19*ln(1.60 + 0.42*cos(x1))))*((1.22 + 0.19*ln(1.60 + 0.42*cos(x1)))), 0],
    [_, (1.12)*(1.12)],
))]
#[forces(
    p1*v2*v1*wave(0.61*x1 - 0.72*x1) - p1*exp(0.20*x1),
    p1*v2*v1*bump(1.10*x1),
)]
#[potential_energy(bump(1.14*x1 + 0.73*x2))]
#[configuration(x2 = 1.11*wave(1.00*x1 + 0.41*x1))]
#[constraint(held_x2: x2 - (1.11*wave(1.00*x1 + 0.41*x1)) == 0)]
pub struct Random138 {
    #[nominal(1.18)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = 1.29*dot(x1) - 0.38*bump(0.77*x2 - 0.29*x2)*dot(x2) + 0.36*atan2(x2, 2 + cos(x1))/2,
    v2 = 1.25*dot(x2) - 0.21*sin(0.69*x1 + 1.33)*dot(x1) + 0.50*(if t >= -0.06 { atan2(x2, 2 + cos(x2))/2 } else { sin(0.52*x1 - 0.76*x1) }),
)]
#[inertia(diag(1.08, (1.15 - 0.21*powi(cos(0.70*t), 3))))]
#[forces(
    p1*x2,
    0,
)]
#[configuration(of(q1), x1 = 1.25*q1, x2 = 0.40*sin(q1)/(1.50 + cos(q1)))]
#[constraint(held_x2: x2 - (0.40*sin((x1/1.25))/(1.50 + cos((x1/1.25)))) == 0)]
#[output(place = bump(0.57*x1 + 0.57), power = p1*v2*v2*0.91*sin(x2)/(1.50 + cos(x1)) + v1*sqrt(2 + powi(v1, 2)), push = bump(1.10*x1)*dot(v2) + v2*ddot(x2), pull = 1.34*reaction(held_x2) - push, share = pull/(1.66 + powi(reaction(held_x2), 2)))]
pub struct Random139 {
    #[nominal(0.74)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[inputs(tau)]
#[kinematics(
    v1 = (1.13 - 0.34*cos(0.45*x1))*dot(x1) - 0.21*wave(1.18*x2 - 0.51*x2)*dot(x2) - 0.43*cos(0.52*x1 - 0.64),
    v2 = (1.23 + 0.19*wave(0.66*x2))*dot(x2) + 0.28*sin(0.70*x1 - 0.74)*dot(x1) - 0.11*(if x2 > -0.57 { cos(0.90*x1) } else { sin(1.00*x2 - 0.24) }),
)]
#[inertia(matrix(
    [((1.39 - 0.21*tan(0.97*sin(x2))/2))*((1.39 - 0.21*tan(0.97*sin(x2))/2)), ((1.39 - 0.21*tan(0.97*sin(x2))/2))*(0.17*1/sqrt(1.50 + powi(x2, 2)))],
    [_, (0.17*1/sqrt(1.50 + powi(x2, 2)))*(0.17*1/sqrt(1.50 + powi(x2, 2))) + ((1.06 - 0.28*sin(p3*x2 - 0.37)))*((1.06 - 0.28*sin(p3*x2 - 0.37)))],
))]
#[forces(
    1.72*v2 - v2*sqrt(2 + powi(v1, 2)),
    1.49*v1/(1 + powi(x1, 2)) + tau*0.34 + 1.45*sin(1.10*x2 - 0.74*x1 + 0.70)*cos(0.50*x1 - 0.84*x2) + p3*x2,
)]
#[potential_energy((if x1 <= -0.14 { cos(1.10*x2) } else { sin(1.08*x2) }))]
#[configuration(x2 = 0.93*sin(0.74*x1))]
pub struct Random140 {
    #[nominal(0.60)]
    pub p1: f64,
    #[nominal(0.73)]
    pub p2: f64,
    #[nominal(0.66)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1)]
#[define(l11 = (1.06 - 0.18*(if x1 > 0.19 { sin(0.51*x1) } else { wave(1.08*x1 - 0.63) })))]
#[inertia(matrix(
    [l11*l11],
))]
#[forces(
    p1*x1 - 0.99*powi(dot(x1), 2) - p2*dot(x1)*dot(x1)*(if x1 >= 0.18 { sin(0.87*x1 - 1.18)*cos(0.82*x1) } else { ln(1.60 + 0.67*cos(x1)) }) - 1.97*ln(1.60 + 0.59*cos(x1)),
)]
#[complement(
    w1 = [(1.32 + 0.17*1/sqrt(1.50 + powi(x1, 2)))],
)]
pub struct Random141 {
    #[nominal(1.27)]
    pub p1: f64,
    #[nominal(0.54)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[inertia(matrix(
    [(1.18)*(1.18)],
))]
#[forces(
    1.26*dot(x1) + dot(x1)*dot(x1)/(1.30 + 0.21*cos(0.55*x1)) + 0.72*powi(cos(0.47*t + 0.34*x1), 3) + 1.09*dot(x1),
)]
#[independent(s1 = (1.50 - 0.18*ln(1.60 + 0.39*cos(x1)))*dot(x1) - 0.54*sin(p1*x1 + 0.42))]
#[output(place = ln(1.60 + 0.92*cos(t)), power = 1.10*t/(1 + powi(t, 2)) + 1.77*dot(x1)/(1 + powi(x1, 2)) + 1.05*dot(x1) + p1*dot(x1)*dot(x1)*cos(0.96*t - 0.37*t - 0.69), push = (if t <= 0.15 { tan(0.64*sin(x1))/2 } else { atan2(t, 2 + cos(t))/2 })*ddot(x1) + dot(x1)*ddot(x1))]
pub struct Random142 {
    #[nominal(0.99)]
    pub p1: f64,
    #[nominal(1.03)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    dot(x1) = 1.37*v1 - 0.57*cos(0.80*x1 - 0.33*x1 - 0.15),
)]
#[kinetic_energy(powi(((1.13 - 0.23*exp(-powi(x1, 2)/2)))*v1, 2)/2 - 0.39*ln(1.60 + 0.66*cos(x1)))]
#[forces(
    p3*0.52 + p3*exp(0.20*x1),
)]
#[constraint(row1: 1.52*x1 + 0.47 == 0)]
#[output(place = tan(0.92*sin(x1))/2, power = 1.90*v1/(1 + powi(x1, 2)) - 0.36*v1, push = cos(0.50*x1 - 0.33*x1)*dot(v1) + v1*ddot(x1), pull = 1.40*reaction(row1) - push, share = pull/(1.38 + powi(reaction(row1), 2)))]
pub struct Random143 {
    #[nominal(0.93)]
    pub p1: f64,
    #[nominal(1.05)]
    pub p2: f64,
    #[nominal(0.92)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[inertia(diag(1.27, (1.20 - 0.15*sin(0.81*x1 - 0.44*x1)*cos(0.99*t))))]
#[forces(
    0,
    p2*exp(0.20*t),
)]
#[potential_energy(atan2(x2, 2 + cos(x2))/2)]
#[constraint(row1: dot(x1) + 0.29*(if t < -0.06 { powi(cos(1.05*x1), 3) } else { bump(0.81*x1) }) == 0)]
#[constraint(row2: powi(dot(x2), 2) - 0.20*powi(dot(x1), 2) - (2 - 0.20*atan2(t, 2 + cos(t))/2) == 0)]
pub struct Random144 {
    #[nominal(0.95)]
    pub p1: f64,
    #[nominal(1.47)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    v1 = dot(x1) - 0.11*exp(-powi(x1, 2)/2),
)]
#[inertia(matrix(
    [((1.15 - 0.21*(if x1 < -0.35 { 1/sqrt(1.50 + powi(x1, 2)) } else { powi(cos(0.96*x1), 3) })))*((1.15 - 0.21*(if x1 < -0.35 { 1/sqrt(1.50 + powi(x1, 2)) } else { powi(cos(0.96*x1), 3) })))],
))]
#[forces(
    p2*exp(0.20*x1) - 0.38*tan(0.53*sin(x1))/2 - v1*v1/1.02 - 0.37*sin(1.03*x1 + 0.72*x1),
)]
#[constraint(row1: 1.37*dot(v1) - 0.25*v1/sqrt(1.20 + powi(v1, 2)) == 0)]
#[output(place = 1/sqrt(1.50 + powi(x1, 2)), power = p1*v1*v1*0.69*sin(x1)/(1.50 + cos(x1)) - 0.99*v1, push = cos(0.96*x1)*dot(v1) + v1*ddot(x1), pull = 1.37*reaction(row1) - push, share = pull/(1.46 + powi(reaction(row1), 2)))]
pub struct Random145 {
    #[nominal(1.04)]
    pub p1: f64,
    #[nominal(0.85)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + atan2(x2, 2 + cos(x2))/2*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - atan2(x2, 2 + cos(x2))/2*(v1),
)]
#[inertia(diag((1.03 + 0.15*tan(0.70*sin(x2))/2), (1.25 - 0.13*1/sqrt(1.50 + powi(x1, 2)))))]
#[forces(
    0,
    1.58*powi(v1, 2) + v1*sqrt(2 + powi(v2, 2)) + 1.80*powi(v2, 2) + 1.54*ln(1.60 + 0.82*cos(x1)),
)]
#[constraint(row1: 1.73*x1 + 0.25*sin(x1) + 0.39 == 0)]
#[constraint(row2: powi(v2, 2) + 0.18*powi(v1, 2) - (2 + 0.18*atan2(x2, 2 + cos(x2))/2) == 0)]
pub struct Random146 {
    #[nominal(1.50)]
    pub p1: f64,
    #[nominal(0.64)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + atan2(x2, 2 + cos(x2))/2*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - atan2(x2, 2 + cos(x2))/2*(v1),
)]
#[inertia(matrix(
    [((1.36 + 0.25*powi(cos(0.85*x2), 3)))*((1.36 + 0.25*powi(cos(0.85*x2), 3))), ((1.36 + 0.25*powi(cos(0.85*x2), 3)))*(0.24*atan2(x1, 2 + cos(x1))/2)],
    [_, (0.24*atan2(x1, 2 + cos(x1))/2)*(0.24*atan2(x1, 2 + cos(x1))/2) + ((1.27 - 0.34*x1/(1 + powi(x1, 2))))*((1.27 - 0.34*x1/(1 + powi(x1, 2))))],
))]
#[forces(
    0,
    p1*exp(0.20*x1) - p1*x1 - 0.93*v1/(1 + powi(x1, 2)) - v2*v1/1.18,
)]
#[constraint(row1: 1.77*x1 + 0.16*sin(x1) - 0.13 == 0)]
#[constraint(row2: (1.50 - 0.28*sin(0.53*x1))*dot(v2) - 0.26*sin(0.98*x2)*dot(v1) + 0.76*v2 + 0.76*tan(0.43*sin(x2))/2 == 0)]
#[independent(v2)]
pub struct Random147 {
    #[nominal(1.30)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = 1.17*dot(x1) + 0.32*bump(0.88*x2 + 0.62*x3)*dot(x2),
    v2 = (1.10 - 0.32*powi(cos(0.60*x3), 3))*dot(x2) - 0.19*0.66*sin(x3)/(1.50 + cos(x1))*dot(x3),
    v3 = 1.18*dot(x3) - 0.16*sin(0.40*x3)*dot(x2),
)]
#[kinetic_energy(powi(((1.06 + 0.20*atan2(x2, 2 + cos(x1))/2))*v1 + (0.33*sin(1.20*x3 + 0.21*x2 - 0.90))*v2 + (0.28*(if x1 <= -0.36 { atan2(x1, 2 + cos(x1))/2 } else { sin(0.73*x1) }))*v3, 2)/2 + powi((1.32)*v2, 2)/2 + powi(((1.11 + 0.21*1/sqrt(1.50 + powi(x3, 2))))*v3, 2)/2)]
#[forces(
    1.16*powi(v3, 2) - 0.66*cos(0.77*x3) - p2*x2,
    p2*x1 + p1*0.86 + v1*v2/(1.24 - 0.31*(if x2 < -0.35 { powi(cos(1.13*x3 - 0.23*x1), 3) } else { sin(0.66*x1 - 0.34*x3) })),
    1.52*v1 + 1.43*v2/(1 + powi(x3, 2)) + 1.08*v2,
)]
#[constraint(row1: v3 - 0.51*sin(0.61*x2)*cos(0.78*x1 - 0.63*x1) == 0)]
#[constraint(row2: powi(v2, 2) - 0.12*powi(v3, 2) - (2 - 0.12*1/sqrt(1.50 + powi(x3, 2))) == 0)]
#[constraint(row3: dot(v1) + 0.22*tan(0.39*sin(x1))/2*dot(v3) - 0.29*bump(1.20*x2)*dot(v2) - 0.76*sin(1.00*x2) == 0)]
#[independent(v1, v2)]
#[independent(s1 = v1 - 0.13*(if x2 < 0.43 { cos(1.10*x1 - 0.34) } else { cos(0.81*x1 - 1.14) })*v3, s2 = (1.50 + 0.28*(if x2 > -0.10 { powi(cos(0.61*x3 - 0.48*x2), 3) } else { 0.45*sin(x3)/(1.50 + cos(x1)) }))*v2 - 0.27*1/sqrt(1.50 + powi(x2, 2))*v1 - 0.38*(if x3 < -0.13 { wave(0.84*x1) } else { sin(0.80*x3 - 1.00) }))]
#[output(place = cos(0.45*x3 + 0.39*x2), power = p2*exp(0.20*x1) + p2*v1*v2*sin(0.86*x1 + 0.57*x3)*cos(0.60*x3 + 0.39*x1) + 0.80*v3 + p2*x1, push = 1/sqrt(1.50 + powi(x1, 2))*dot(v3) + v2*ddot(x2), pull = (1.22 + 0.16*cos(0.44*x3))*reaction(row2) - push, share = pull/(1.59 + powi(reaction(row2), 2)))]
pub struct Random148 {
    #[nominal(1.31)]
    pub p1: f64,
    #[nominal(1.47)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + sin(0.44*t)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - sin(0.44*t)*(v1),
)]
#[inertia(diag((1.39 + 0.18*0.87*sin(t)/(1.50 + cos(x1))), (1.16 + 0.13*cos(0.98*x2))))]
#[forces(
    1.65*v1/(1 + powi(x2, 2)) + 1.01*v2,
    v2*v1/(1.35 + 0.18*powi(cos(1.09*t - 0.26*t - 0.33), 3)),
)]
#[potential_energy(cos(1.19*x1 + 0.37*x2 + 0.52))]
#[constraint(row1: 1.30*x1 + 0.26*sin(x1) + 0.13*sin(x2) + 0.30*sin(1.00*t) + 0.15 == 0)]
#[constraint(again1: 1.37*(1.30*x1 + 0.26*sin(x1) + 0.13*sin(x2) + 0.30*sin(1.00*t) + 0.15) == 0, redundant)]
#[independent(s1 = 1.07*v2 + 0.19*(if x1 < 0.21 { cos(0.78*t + 0.89*x2) } else { powi(cos(1.02*x1), 3) })*v1)]
pub struct Random149 {
    #[nominal(1.48)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[kinetic_energy(powi((1.14)*dot(x1), 2)/2 + 0.57*tan(0.48*sin(x1))/2)]
#[forces(
    0.63*dot(x1)/(1 + powi(x1, 2)) + dot(x1)*dot(x1)/(1.10 + 0.19*1/sqrt(1.50 + powi(x1, 2))) + p1*1.83 + 0.37*dot(x1),
)]
#[constraint(row1: 1.25*x1 + 0.28*sin(x1) + 0.47 == 0)]
pub struct Random150 {
    #[nominal(0.70)]
    pub p1: f64,
    #[nominal(1.14)]
    pub p2: f64,
    #[nominal(0.86)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + cos(0.68*x1)*dot(x1),
    v3 = dot(x3) + sin(1.10*x1 + 0.22*x1 - 1.05)*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - cos(0.68*x1)*(v1),
    dot(x3) = v3 - sin(1.10*x1 + 0.22*x1 - 1.05)*(v2 - cos(0.68*x1)*(v1)),
)]
#[define(l11 = 1.20, l21 = 0.16*1/sqrt(1.50 + powi(x1, 2)), l22 = 1.31, l31 = 0.39*powi(cos(0.56*x2 - 0.23*x3), 3), l33 = (1.25 - 0.29*sin(1.00*x1 + 0.51)))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31],
    [_, l21*l21 + l22*l22, l21*l31],
    [_, _, l31*l31 + l33*l33],
))]
#[forces(
    0.78*v3 - tau*1.45,
    1.29*v1/(1 + powi(x3, 2)) + v1*v1/(1.39 + 0.15*1/sqrt(1.50 + powi(x2, 2))),
    1.60*(if x2 <= -0.46 { 0.43*sin(x1)/(1.50 + cos(x2)) } else { tan(0.66*sin(x2))/2 }),
)]
#[configuration(x2 = 1.06*wave(0.61*x1 - 0.78*x1), x3 = 1.13*(if x1 >= -0.53 { sin(0.78*x1 - 0.99) } else { sin(1.17*x1) }))]
#[constraint(held_x2: x2 - (1.06*wave(0.61*x1 - 0.78*x1)) == 0)]
#[constraint(held_x3: x3 - (1.13*(if x1 >= -0.53 { sin(0.78*x1 - 0.99) } else { sin(1.17*x1) })) == 0)]
#[constraint(bound: powi(v1, 2) - 0.18*powi(v2, 2) - (2 - 0.18*1/sqrt(1.50 + powi(x1, 2))) == 0)]
pub struct Random151 {
    #[nominal(0.91)]
    pub p1: f64,
    #[nominal(1.47)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = (1.22 - 0.13*(if x2 > 0.52 { 0.78*sin(x2)/(1.50 + cos(x1)) } else { sin(0.77*x1 - 0.27)*cos(1.15*x1 + 0.82*x1 - 0.68) }))*v1 + 0.35*sin(0.94*x2 - 0.29*x1)*cos(0.43*x1 - 0.45)*v2 + 0.15*sin(0.95*x1 - 0.30*x2),
    dot(x2) = (1.34 + 0.16*sin(0.72*x2)*cos(0.56*x2))*v2 - 0.32*wave(0.89*x2 + 0.58*x1)*v1 - 0.39*(if x1 >= -0.48 { tan(0.86*sin(x2))/2 } else { exp(-powi(x2, 2)/2) }),
)]
#[kinetic_energy((1.32 - 0.31*0.94*sin(x1)/(1.50 + cos(x2)))*powi(v1, 2)/2 + 1.11*powi(v2, 2)/2 + 0.64*0.65*sin(x1)/(1.50 + cos(x2))*v1 + 0.36*wave(0.57*x2))]
#[forces(
    v2*v1/(1.21 - 0.22*bump(0.57*x2 - 1.27)),
    p2*x1,
)]
#[constraint(row1: (1.35 + 0.20*1/sqrt(1.50 + powi(x1, 2)))*v1 - 1.00*v2 + 0.21*tan(0.67*sin(x2))/2 == 0)]
#[independent(v2)]
#[independent(v1)]
pub struct Random152 {
    #[nominal(1.39)]
    pub p1: f64,
    #[nominal(0.79)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 2)]
#[coordinates(x[n])]
#[define(s[i] = tanh(1.05*x[i] + i/2 - 0.83) for i in 0..n)]
#[define(r[0] = s[0]/2, r[i] = (r[i - 1] + s[i])/2 for i in 1..n)]
#[inertia(matrix(
    [(1.08 + k[i]*r[i]/4)*(1.08 + k[j]*r[j]/4)/(1 + 2*powi(i - j, 2)) for j in 0..n] for i in 0..n,
))]
#[forces(
    0.72*sum(0..n, |j| sin(x[i] - x[j])*dot(x[j])) - 0.27*k[i]*dot(x[i]) - product(0..=i, |j| s[j]) for i in 0..n,
)]
#[constraint(row[i]: 1.14*ddot(x[i]) + 0.12*r[i]*ddot(x[n - 1]) + 0.58*dot(x[i])*dot(x[n - 1]) == 0 for i in 0..1)]
pub struct Random153 {
    #[nominal(1.32)]
    pub p1: f64,
    #[nominal(0.62)]
    pub p2: f64,
    #[nominal(1.16)]
    pub k: [f64; 2],
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[inertia(diag(1.11, 1.21, (1.40 - 0.25*atan2(x1, 2 + cos(x2))/2)))]
#[forces(
    p1*exp(0.20*x3) + p1*dot(x2)*dot(x2)*1/sqrt(1.50 + powi(x1, 2)),
    p1*x3,
    dot(x1)*sqrt(2 + powi(dot(x2), 2)) - 1.25*dot(x1)/(1 + powi(x2, 2)) - p1*x2 - dot(x3)*sqrt(2 + powi(dot(x2), 2)),
)]
#[potential_energy(exp(-powi(x1, 2)/2))]
#[output(place = 1/sqrt(1.50 + powi(x2, 2)), power = p1*dot(x2)*dot(x1)*bump(1.07*x1 - 0.78), push = sin(1.19*x2)*ddot(x1) + dot(x1)*ddot(x1))]
pub struct Random154 {
    #[nominal(0.77)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inputs(tau)]
#[define(l11 = 1.26, l21 = 0.17*(if x2 >= 0.03 { powi(cos(0.51*t), 3) } else { tan(0.55*sin(x3))/2 }), l22 = (1.04 + 0.20*powi(cos(0.95*x3 + 0.63), 3)), l33 = (1.06 + 0.24*exp(-powi(t, 2)/2)))]
#[inertia(matrix(
    [l11*l11, l11*l21, 0],
    [_, l21*l21 + l22*l22, 0],
    [_, _, l33*l33],
))]
#[forces(
    p1*dot(x1)*dot(x2)*sin(1.11*x2 + 0.72*t + 0.23) - 1.80*dot(x3),
    p2*x3 + 1.23*(if t > 0.39 { exp(-powi(x2, 2)/2) } else { cos(0.44*x2 + 0.63*x3) }) + 1.64*dot(x2),
    dot(x3)*dot(x3)/(1.09 - 0.14*(if x2 >= 0.09 { exp(-powi(x2, 2)/2) } else { tan(1.00*sin(x1))/2 })) - p2*dot(x3)*dot(x1)*exp(-powi(x2, 2)/2),
)]
#[constraint(row1: dot(x2) - 0.16*x3/(1 + powi(x3, 2))*dot(x3) + 0.32*powi(cos(1.05*x2 + 1.21), 3)*dot(x1) + 0.59*0.69*sin(x2)/(1.50 + cos(x3)) == 0)]
pub struct Random155 {
    #[nominal(0.96)]
    pub p1: f64,
    #[nominal(1.09)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = (1.14 + 0.21*1/sqrt(1.50 + powi(x1, 2)))*v1 - 0.35*tan(0.97*sin(x2))/2*v2 - 0.43*cos(0.54*t + 0.58*x2 + 0.44),
    dot(x2) = (1.20 + 0.10*bump(1.00*x2 - 0.88*x1))*v2 + 0.12*wave(0.48*x2 - 0.74),
)]
#[define(l11 = 1.40, l22 = (1.05 + 0.21*wave(1.08*x1 - 0.80*x1 - 0.21)))]
#[kinetic_energy(powi(l11*v1, 2)/2 + powi(l22*v2, 2)/2 - 0.53*ln(1.60 + 0.83*cos(x2))*v2 - 0.28*sin(0.95*t))]
#[forces(
    0.30*powi(v1, 2),
    1.87*v1 + p3*x2,
)]
#[potential_energy(1/sqrt(1.50 + powi(x1, 2)))]
#[constraint(row1: 1.61*x1 + 0.32*x2 + 0.30*sin(0.46*t) - 0.44 == 0)]
#[output(place = tan(0.91*sin(t))/2, power = p1*exp(0.20*x2) + tau*1.63, push = sin(1.15*t + 0.78*x2)*cos(1.15*t + 0.76)*dot(v2) + v1*ddot(x1), pull = (1.30 - 0.29*1/sqrt(1.50 + powi(x2, 2)))*reaction(row1) - push, share = pull/(1.50 + powi(reaction(row1), 2)))]
pub struct Random156 {
    #[nominal(1.20)]
    pub p1: f64,
    #[nominal(1.21)]
    pub p2: f64,
    #[nominal(1.22)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[inertia(diag(1.05, (1.10 + 0.32*cos(0.65*x1)), (1.16 - 0.16*wave(0.42*t))))]
#[forces(
    1.15*dot(x1)/(1 + powi(t, 2)) + 1.25*dot(x1) + dot(x3)*sqrt(2 + powi(dot(x2), 2)) + dot(x1)*sqrt(2 + powi(dot(x3), 2)),
    0,
    0.80*dot(x2)/(1 + powi(x2, 2)) + dot(x1)*sqrt(2 + powi(dot(x2), 2)) + 0.31*powi(dot(x3), 2),
)]
#[potential_energy(cos(0.68*x1))]
#[constraint(row1: 1.82*x3 + 0.22*sin(x3) + 0.19*powi(x2, 2)/2 + 0.30*sin(1.09*t) - 0.60 == 0)]
#[constraint(row2: (1.50 + 0.24*0.40*sin(t)/(1.50 + cos(x2)))*dot(x1) + 0.33*atan2(t, 2 + cos(x3))/2*dot(x2) + 0.31*exp(-powi(t, 2)/2)*dot(x3) - 0.54*1/sqrt(1.50 + powi(x2, 2)) == 0)]
#[independent(dot(x2))]
pub struct Random157 {
    #[nominal(0.50)]
    pub p1: f64,
    #[nominal(1.25)]
    pub p2: f64,
    #[nominal(0.65)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[inertia(matrix(
    [(1.27)*(1.27), (1.27)*(0.25*sin(0.91*x2 - 0.89*t))],
    [_, (0.25*sin(0.91*x2 - 0.89*t))*(0.25*sin(0.91*x2 - 0.89*t)) + (1.02)*(1.02)],
))]
#[forces(
    p1*exp(0.20*t) - dot(x2)*sqrt(2 + powi(dot(x2), 2)),
    1.52*bump(1.04*t - 0.33*x2 + 0.31) - 0.84*dot(x2)/(1 + powi(x1, 2)) - 0.47*powi(dot(x1), 2),
)]
#[constraint(height: 1.45*x1 + 0.25*x2 + 0.30*sin(0.63*t) - 0.21 == 0)]
#[constraint(height_rate: 1.26*(1.45*dot(x1) + 0.25*dot(x2) + 0.30*0.63*cos(0.63*t)) == 0)]
#[output(place = cos(0.55*x2 - 0.73*x2), power = p1*1.24 + 1.86*(if x1 < -0.12 { powi(cos(0.66*t - 0.79*x1), 3) } else { 0.71*sin(t)/(1.50 + cos(t)) }) + p1*exp(0.20*x1), push = (if x1 < -0.06 { sin(1.18*x1) } else { cos(1.07*x1 - 0.85*x1 - 0.57) })*ddot(x2) + dot(x2)*ddot(x2))]
pub struct Random158 {
    #[nominal(0.66)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = (1.12 + 0.22*atan2(x3, 2 + cos(x3))/2)*dot(x1) - 0.16*wave(0.83*x2 + 0.44*x3)*dot(x3) - 0.32*bump(0.55*x1),
    v2 = (1.39 - 0.12*sin(0.83*x2 - 0.69*x2))*dot(x2) - 0.24*bump(0.78*x2 - 0.42*x3),
    v3 = dot(x3) - 0.37*(if x3 <= -0.37 { atan2(x1, 2 + cos(x1))/2 } else { atan2(x1, 2 + cos(x3))/2 })*dot(x1) + 0.36*exp(-powi(x3, 2)/2),
)]
#[inertia(diag(1.36, (1.07 + 0.13*tan(0.65*sin(x2))/2), (1.03 - 0.25*sin(0.90*x3 + 0.83*x3))))]
#[forces(
    0,
    p2*v3*v3*exp(-powi(x2, 2)/2) - p2*0.62 - p1*0.40 - p2*1.61,
    v1*sqrt(2 + powi(v3, 2)) + 0.58*v2 + 0.85*powi(v1, 2),
)]
#[constraint(height: 1.94*x3 + 0.23*sin(x3) + 0.38*x2*x2 - 0.12 == 0)]
#[constraint(first: (1.50 - 0.10*sin(p1*x2 - 0.23))*v1 + 0.11*ln(1.60 + 0.61*cos(x2))*v2 - 0.24*(if x3 > 0.20 { 1/sqrt(1.50 + powi(x2, 2)) } else { powi(cos(1.20*x2 + 0.38*x1 - 0.32), 3) }) == 0)]
#[constraint(second: 1.94*dot(x3) + 0.23*cos(x3)*dot(x3) + 0.38*(dot(x2)*x2 + x2*dot(x2)) - 0.50*cos(1.17*x1)*((1.50 - 0.10*sin(p1*x2 - 0.23))*v1 + 0.11*ln(1.60 + 0.61*cos(x2))*v2 - 0.24*(if x3 > 0.20 { 1/sqrt(1.50 + powi(x2, 2)) } else { powi(cos(1.20*x2 + 0.38*x1 - 0.32), 3) })) == 0)]
#[independent(v2)]
pub struct Random159 {
    #[nominal(1.11)]
    pub p1: f64,
    #[nominal(1.39)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = v1 + 0.54*sin(0.43*x1 + 0.60*x1)*cos(1.01*x3 + 0.44*x1 + 1.07),
    dot(x2) = 1.15*v2 - 0.35*x1/(1 + powi(x1, 2))*v1 + 0.27*sin(1.12*x3 + 0.64*x3),
    dot(x3) = (1.03 + 0.14*cos(0.67*x1 + 1.41))*v3 + 0.26*exp(-powi(x1, 2)/2)*v2 + 0.28*(if x2 >= 0.19 { sin(p1*x2 + 0.61) } else { sin(0.95*x2 - 0.87*x2 - 1.09) }),
)]
#[kinetic_energy(1.23*powi(v1, 2)/2 + (1.21 - 0.30*tan(0.87*sin(x3))/2)*powi(v2, 2)/2 + 1.09*powi(v3, 2)/2 - 0.20*cos(1.17*x1)*v1 + 0.64*sin(0.76*x1)*cos(0.66*x1 + 0.40)*v3)]
#[forces(
    0,
    p1*exp(0.20*x1),
    p1*x2 - p1*x3 - v2*sqrt(2 + powi(v1, 2)) - p1*exp(0.20*x3),
)]
#[configuration(x2 = 0.92*x3/(1 + powi(x3, 2)), x1 = 1.19*0.51*sin(x3)/(1.50 + cos(x3)))]
#[constraint(held_x2: x2 - (0.92*x3/(1 + powi(x3, 2))) == 0)]
#[constraint(held_x1: x1 - (1.19*0.51*sin(x3)/(1.50 + cos(x3))) == 0)]
pub struct Random160 {
    #[nominal(1.01)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inputs(tau)]
#[kinetic_energy((1.39 + 0.28*sin(p1*x1 + 0.74))*powi(dot(x1), 2)/2 + (1.08 - 0.17*sin(1.05*x1 + 0.74*x2))*powi(dot(x2), 2)/2 + 0.45*1/sqrt(1.50 + powi(x2, 2))*dot(x2))]
#[forces(
    p1*exp(0.20*x2) - 0.97*dot(x2) - 0.85*dot(x2),
    1.47*sin(0.44*x2)*cos(0.43*x2),
)]
#[configuration(of(q1, q2), x2 = 1.25*q1, x1 = 1.25*q2)]
#[output(place = powi(cos(0.76*x2), 3), power = 0.85*dot(x1)/(1 + powi(x1, 2)) - 1.16*(if x2 > -0.46 { 0.50*sin(x1)/(1.50 + cos(x1)) } else { exp(-powi(x2, 2)/2) }), push = (if x1 >= 0.56 { cos(1.14*x1 - 0.64*x2) } else { sin(p1*x2 - 0.85) })*ddot(x2) + dot(x1)*ddot(x1))]
pub struct Random161 {
    #[nominal(0.70)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = (1.17 - 0.28*atan2(t, 2 + cos(x3))/2)*v1 - 0.30*tan(0.64*sin(x3))/2*v2 + 0.53*bump(0.43*x3),
    dot(x2) = (1.30 + 0.24*wave(0.95*t - 0.70*x2))*v2 + 0.39*1/sqrt(1.50 + powi(x1, 2))*v1 - 0.29*powi(cos(0.40*x2 - 0.86*x1), 3),
    dot(x3) = (1.22 + 0.26*(if t >= -0.36 { ln(1.60 + 0.37*cos(x1)) } else { x2/(1 + powi(x2, 2)) }))*v3 + 0.24*cos(0.45*x2 + 0.24*x2 - 0.84)*v1 - 0.34*cos(0.54*t + 0.82*x2),
)]
#[kinetic_energy(powi(((1.14 - 0.25*(if t < 0.23 { powi(cos(0.54*x1 + 0.22), 3) } else { x2/(1 + powi(x2, 2)) })))*v1 + (0.39*0.61*sin(x1)/(1.50 + cos(x2)))*v2 + (0.29*wave(0.45*x3 + 0.64*t - 1.10))*v3, 2)/2 + powi(((1.10 - 0.20*tan(0.68*sin(t))/2))*v2 + (0.24*sin(p1*x1 + 0.29))*v3, 2)/2 + powi(((1.11 - 0.28*sin(0.85*t)))*v3, 2)/2 + 0.27*cos(0.72*x1 - 0.37*x1)*v2 - 0.38*tan(0.62*sin(t))/2)]
#[forces(
    p2*exp(0.20*x1),
    0.71*v3 + p1*v3*v3*powi(cos(0.51*x1 + 0.40*x1), 3),
    p2*exp(0.20*x1) + 0.94*powi(v3, 2),
)]
#[configuration(x3 = 1.31*sin(p3*x2 - 0.10), x1 = 0.88*sin(p3*x2 + 0.53))]
#[constraint(held_x3: x3 - (1.31*sin(p3*x2 - 0.10)) == 0)]
#[constraint(held_x1: x1 - (0.88*sin(p3*x2 + 0.53)) == 0)]
#[output(place = sin(1.07*x3), power = 1.57*v3 + 1.15*v1/(1 + powi(x2, 2)) + v2*v2/(1.39 + 0.13*wave(0.47*x3 + 0.63*x3)) + p2*0.57, push = (if x1 >= -0.04 { sin(0.98*x3 + 0.34*x2) } else { wave(0.66*t) })*dot(v1) + v2*ddot(x2), pull = (1.32 - 0.34*(if x3 < -0.27 { ln(1.60 + 0.55*cos(x2)) } else { sin(p1*x2 + 0.55) }))*reaction(held_x3) - push, share = pull/(1.98 + powi(reaction(held_x3), 2)))]
pub struct Random162 {
    #[nominal(1.39)]
    pub p1: f64,
    #[nominal(0.57)]
    pub p2: f64,
    #[nominal(0.74)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = dot(x1),
    v2 = 1.18*dot(x2) + 0.26*x2/(1 + powi(x2, 2))*dot(x3),
    v3 = (1.23 - 0.23*powi(cos(1.15*x2), 3))*dot(x3) + 0.30*0.90*sin(x3)/(1.50 + cos(t))*dot(x1),
)]
#[inertia(diag((1.29 + 0.26*ln(1.60 + 0.49*cos(x2))), (1.12 - 0.32*sin(1.16*t + 0.69*x2 + 0.50)), 1.40))]
#[forces(
    p1*v3*v1*sin(p1*x3 + 0.23) - 1.70*(if x3 <= -0.26 { sin(1.11*t) } else { sin(0.80*x2) }) - 1.45*0.60*sin(t)/(1.50 + cos(x2)),
    p1*v3*v3*ln(1.60 + 0.94*cos(x3)) - p1*exp(0.20*t),
    v2*sqrt(2 + powi(v3, 2)) - 1.55*v2 - p1*exp(0.20*x3),
)]
#[constraint(row1: v3 + 0*v2 + 0.40*1/sqrt(1.50 + powi(x3, 2)) == 0)]
#[constraint(row2: v1 + 0.74*ln(1.60 + 0.99*cos(x3))*v2 + 0.40*ln(1.60 + 0.89*cos(x3)) == 0)]
#[complement(
    w1 = [-(1.22 - 0.30*cos(0.99*t))*(0.74*ln(1.60 + 0.99*cos(x3))), (1.22 - 0.30*cos(0.99*t)), -(1.22 - 0.30*cos(0.99*t))*(0)],
)]
pub struct Random163 {
    #[nominal(0.51)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + x2/(1 + powi(x2, 2))*dot(x1),
    v3 = dot(x3) + powi(cos(0.93*x1 - 0.58*x1), 3)*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - x2/(1 + powi(x2, 2))*(v1),
    dot(x3) = v3 - powi(cos(0.93*x1 - 0.58*x1), 3)*(v2 - x2/(1 + powi(x2, 2))*(v1)),
)]
#[inertia(diag(1.13, (1.37 + 0.28*powi(cos(0.65*x3 - 0.64), 3)), (1.23 + 0.32*powi(cos(0.46*x2), 3))))]
#[forces(
    tau*0.40,
    p2*exp(0.20*x3),
    v2*v3/(1.11 - 0.13*sin(1.17*x2)) + 1.89*cos(0.91*x1 + 0.90*x2 - 0.94),
)]
#[constraint(row1: v1 + 0.28*cos(0.45*x2 + 0.52*x1 + 1.26)*v2 == 0)]
#[constraint(row2: 1.21*v3 + 0.12*x2/(1 + powi(x2, 2))*v2 == 0)]
pub struct Random164 {
    #[nominal(0.91)]
    pub p1: f64,
    #[nominal(0.98)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.22 - 0.35*(if x1 > -0.29 { 1/sqrt(1.50 + powi(x3, 2)) } else { t/(1 + powi(t, 2)) })), (1.29 + 0.13*exp(-powi(t, 2)/2)), 1.01))]
#[forces(
    p1*x3 + p1*exp(0.20*t),
    0,
    dot(x1)*sqrt(2 + powi(dot(x3), 2)) - 0.83*dot(x3) - p1*dot(x3)*dot(x1)*(if t < -0.22 { ln(1.60 + 0.88*cos(x2)) } else { sin(0.67*x3) }),
)]
#[potential_energy(tan(0.51*sin(x3))/2)]
#[constraint(row1: 1.85*dot(x2) == 0)]
#[constraint(row2: (1.50 - 0.13*ln(1.60 + 0.79*cos(x2)))*dot(x1) + 0.34*0.84*sin(x2)/(1.50 + cos(x1))*dot(x2) == 0)]
#[constraint(row3: 1.69*dot(x3) - 0.34*(if t < 0.17 { exp(-powi(x3, 2)/2) } else { bump(0.51*x2 - 0.80*x1) })*dot(x2) - 0.21*ln(1.60 + 0.73*cos(x3))*dot(x1) + 0.38*wave(0.55*x3 - 0.73*x1 + 0.24) == 0)]
#[output(place = 1/sqrt(1.50 + powi(t, 2)), power = 0.73*dot(x3), push = powi(cos(0.53*x1 - 0.57*t), 3)*ddot(x2) + dot(x3)*ddot(x3), pull = (1.36 - 0.24*ln(1.60 + 0.85*cos(x2)))*reaction(row2) - push, share = pull/(1.23 + powi(reaction(row2), 2)))]
pub struct Random165 {
    #[nominal(1.35)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = (1.16 + 0.15*powi(cos(0.88*x2 + 0.51*x3), 3))*v1 + 0.29*(if x3 >= 0.27 { exp(-powi(x3, 2)/2) } else { bump(0.70*x2) }),
    dot(x2) = (1.18 - 0.14*(if x2 > -0.31 { cos(0.99*x3) } else { cos(1.00*x3 + 1.25) }))*v2 + 0.38*x1/(1 + powi(x1, 2))*v3 + 0.17*sin(0.84*x1),
    dot(x3) = v3 + 0.22*tan(0.46*sin(x3))/2,
)]
#[inertia(diag(1.07, (1.31 - 0.19*(if x2 < 0.17 { tan(0.58*sin(x2))/2 } else { 1/sqrt(1.50 + powi(x2, 2)) })), 1.20))]
#[forces(
    tau*1.14 - 1.98*v3,
    0.45*powi(v3, 2),
    tau*1.90 - v1*v1/(1.29 - 0.12*cos(0.88*x2 - 0.53*x3)),
)]
#[constraint(row1: 1.05*v1 + 0.28*sin(v1 + cos(1.15*x3 - 1.28)*v2) - 0.42*tan(0.53*sin(x2))/2 == 0)]
pub struct Random166 {
    #[nominal(1.45)]
    pub p1: f64,
    #[nominal(1.00)]
    pub p2: f64,
    #[nominal(1.18)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[inertia(diag(1.21, (1.16 - 0.30*(if x1 > -0.59 { sin(p1*x1 - 0.67) } else { x3/(1 + powi(x3, 2)) })), (1.37 - 0.31*exp(-powi(x3, 2)/2))))]
#[forces(
    p3*dot(x3)*dot(x2)*exp(-powi(x1, 2)/2) - p1*x3 - dot(x3)*dot(x1)/(1.33 + 0.32*cos(0.68*x2 + 1.19)) - 1.26*dot(x3),
    p3*1.38 + 0.44*dot(x1) + 0.75*sin(0.56*x1 - 0.78*x3)*cos(1.18*x2 - 0.85*x1) + 0.89*powi(dot(x2), 2),
    p3*x2 - dot(x1)*sqrt(2 + powi(dot(x3), 2)) - 1.55*(if x2 <= -0.37 { wave(0.52*x1 + 0.26*x3) } else { cos(0.96*x3) }),
)]
#[constraint(row1: 1.79*ddot(x3) - 0.31*dot(x2) - 0.31*x1/(1 + powi(x1, 2)) == 0)]
#[constraint(row2: ddot(x2) + 0.20*sin(0.49*x2 + 0.39*x2)*cos(0.70*x3)*ddot(x3) + 0.71*dot(x3) + 0.71*sin(1.03*x2 + 1.47) == 0)]
#[constraint(row3: 1.67*ddot(x1) + 0.13*cos(0.71*x2)*ddot(x3) - 0.12*sin(1.10*x3 - 0.52)*cos(0.61*x2)*ddot(x2) - 0.75*powi(cos(1.16*x2), 3) == 0)]
#[independent(s1 = (1.50 + 0.27*0.54*sin(x3)/(1.50 + cos(x3)))*dot(x1) - 0.27*sin(0.75*x3), s2 = dot(x2) - 0.20*cos(1.05*x2)*dot(x1) + 0.22*tan(0.45*sin(x1))/2, s3 = 1.70*dot(x3) + 0.29*0.97*sin(x3)/(1.50 + cos(x2))*dot(x1) + 0.20*sin(0.42*x1 - 0.25*x1 + 1.37)*cos(0.56*x2)*dot(x2) - 0.41*cos(0.80*x2 - 0.70*x3))]
#[independent(dot(x1), dot(x2), dot(x3))]
#[output(place = cos(0.50*x3 - 0.61*x3), power = p1*0.75 - p1*exp(0.20*x3) - dot(x1)*sqrt(2 + powi(dot(x1), 2)), push = wave(0.73*x2 + 0.65*x2)*ddot(x1) + dot(x2)*ddot(x2), pull = (1.01 - 0.30*0.59*sin(x2)/(1.50 + cos(x1)))*reaction(row3) - push, share = pull/(1.09 + powi(reaction(row3), 2)))]
pub struct Random167 {
    #[nominal(0.62)]
    pub p1: f64,
    #[nominal(0.87)]
    pub p2: f64,
    #[nominal(0.79)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag((1.37 - 0.27*atan2(x2, 2 + cos(x2))/2), (1.36 + 0.18*tan(0.47*sin(x2))/2)))]
#[forces(
    p3*dot(x2)*dot(x2)*sin(0.60*x2 + 0.47)*cos(0.74*x1 + 0.21*x2 - 1.28) - p3*exp(0.20*x2) - 1.74*powi(dot(x1), 2) - 0.60*dot(x2)/(1 + powi(x1, 2)),
    1.73*dot(x1)/(1 + powi(x1, 2)) + p2*exp(0.20*x2) + 1.66*dot(x1)/(1 + powi(x2, 2)) + dot(x2)*sqrt(2 + powi(dot(x2), 2)),
)]
#[constraint(row1: 1.46*x1 + 0.19*sin(x1) + 0.60 == 0)]
#[constraint(row2: 1.94*dot(x2) + 0.16*dot(x2)*dot(x1)*sin(1.09*x1) - 0.59*sin(1.01*x1) == 0)]
#[output(place = (if x1 <= -0.08 { sin(1.00*x1 - 0.46*x2 + 0.79) } else { sin(0.87*x2 - 0.31*x1) }), power = dot(x1)*dot(x2)/1.16 + p1*x2 + p3*x1 + dot(x2)*dot(x2)/(1.06 - 0.34*tan(0.57*sin(x1))/2), push = cos(1.02*x2)*ddot(x2) + dot(x1)*ddot(x1), pull = 1.36*reaction(row2) - push, share = pull/(1.09 + powi(reaction(row2), 2)))]
pub struct Random168 {
    #[nominal(1.00)]
    pub p1: f64,
    #[nominal(0.92)]
    pub p2: f64,
    #[nominal(1.04)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = (1.11 + 0.17*cos(0.66*t))*dot(x1) + 0.35*exp(-powi(t, 2)/2),
    v2 = 1.34*dot(x2) - 0.50*tan(0.84*sin(x2))/2,
)]
#[inertia(matrix(
    [((1.29 - 0.14*sin(0.43*t - 0.60*x2)*cos(0.64*t)))*((1.29 - 0.14*sin(0.43*t - 0.60*x2)*cos(0.64*t))), 0],
    [_, ((1.01 - 0.20*sin(0.64*t - 0.25)))*((1.01 - 0.20*sin(0.64*t - 0.25)))],
))]
#[forces(
    p1*x2 - v1*v2/(1.28 - 0.21*1/sqrt(1.50 + powi(t, 2))) - 0.79*v1,
    1.71*v2/(1 + powi(t, 2)) + 1.56*powi(v1, 2) + p1*v1*v1*(if t < -0.09 { cos(0.74*t) } else { tan(0.94*sin(x1))/2 }),
)]
#[constraint(row1: 1.75*x2 + 0.12*sin(x2) + 0.30*sin(1.15*t) + 0.55 == 0)]
#[constraint(row2: (1.50 + 0.12*cos(0.92*x1 - 0.15))*dot(v1) - 0.25*(if t > 0.02 { x1/(1 + powi(x1, 2)) } else { atan2(x2, 2 + cos(x1))/2 })*dot(v2) + 0.80*cos(0.90*x1 - 0.38*x2) == 0)]
#[output(place = sin(1.05*t), power = v2*v2/(1.02 - 0.19*cos(1.12*x1 - 1.02)), push = bump(0.73*t - 0.64*x2 - 0.34)*dot(v2) + v2*ddot(x2), pull = (1.15 + 0.26*sin(0.94*t))*reaction(row2) - push, share = pull/(1.89 + powi(reaction(row2), 2)))]
pub struct Random169 {
    #[nominal(1.34)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = v1 + 0.18*(if x3 > -0.38 { cos(1.05*x1 + 0.33*x2 - 1.48) } else { 1/sqrt(1.50 + powi(x1, 2)) })*v2,
    dot(x2) = 1.25*v2 + 0.30*x1/(1 + powi(x1, 2))*v1,
    dot(x3) = v3 - 0.33*wave(1.10*x1)*v1,
)]
#[inertia(matrix(
    [((1.02 - 0.22*bump(0.74*x2 - 1.09)))*((1.02 - 0.22*bump(0.74*x2 - 1.09))), 0, ((1.02 - 0.22*bump(0.74*x2 - 1.09)))*(0.16*ln(1.60 + 0.58*cos(x3)))],
    [_, ((1.04 + 0.32*cos(0.66*x1 + 0.24*x2 - 1.34)))*((1.04 + 0.32*cos(0.66*x1 + 0.24*x2 - 1.34))), ((1.04 + 0.32*cos(0.66*x1 + 0.24*x2 - 1.34)))*(0.36*0.37*sin(x1)/(1.50 + cos(x2)))],
    [_, _, (0.16*ln(1.60 + 0.58*cos(x3)))*(0.16*ln(1.60 + 0.58*cos(x3))) + (0.36*0.37*sin(x1)/(1.50 + cos(x2)))*(0.36*0.37*sin(x1)/(1.50 + cos(x2))) + (1.20)*(1.20)],
))]
#[forces(
    1.26*1/sqrt(1.50 + powi(x3, 2)) + p1*exp(0.20*x1) + 0.56*sin(p2*x3 - 0.44),
    1.61*v2 - 0.91*powi(v3, 2) - p1*v1*v2*cos(0.93*x1 + 0.18) - p1*x2,
    0,
)]
#[constraint(row1: 1.14*v1 == 0)]
#[constraint(row2: 1.28*v2 - 0.23*sqrt(1.50 + powi(v1, 2) + powi(v1, 2)) + 0.24*sin(p2*x1 - 0.57) == 0)]
#[constraint(row3: 1.39*dot(v3) + 0.24*1/sqrt(1.50 + powi(x1, 2))*dot(v1) - 0.14*exp(-powi(x1, 2)/2)*dot(v2) - 0.28*v1*v1*wave(1.12*x1 + 0.49*x2 + 0.62) == 0)]
pub struct Random170 {
    #[nominal(0.89)]
    pub p1: f64,
    #[nominal(1.22)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[define(l11 = 1.14, l21 = 0.25*(if x1 > -0.27 { ln(1.60 + 0.37*cos(x2)) } else { sin(p2*x1 - 0.43) }), l22 = (1.16 - 0.13*1/sqrt(1.50 + powi(x2, 2))))]
#[inertia(matrix(
    [l11*l11, l11*l21],
    [_, l21*l21 + l22*l22],
))]
#[forces(
    1.17*sin(0.85*x1 - 0.86*x2)*cos(0.68*x1 + 0.96),
    p2*exp(0.20*x1) + 1.56*dot(x2)/(1 + powi(x2, 2)),
)]
#[constraint(row1: dot(x1) + 0.13*x1/(1 + powi(x1, 2))*dot(x2) - 0.36*0.44*sin(x2)/(1.50 + cos(x1)) == 0)]
#[constraint(again1: (1.09 - 0.26*sin(0.69*x2 - 0.35*x1))*(dot(x1) + 0.13*x1/(1 + powi(x1, 2))*dot(x2) - 0.36*0.44*sin(x2)/(1.50 + cos(x1))) == 0, redundant)]
#[constraint(again2: (1.04 - 0.34*atan2(x1, 2 + cos(x2))/2)*(dot(x1) + 0.13*x1/(1 + powi(x1, 2))*dot(x2) - 0.36*0.44*sin(x2)/(1.50 + cos(x1))) == 0, redundant)]
#[output(place = sin(p2*x2 - 0.51), power = 0.66*dot(x1) - 0.76*dot(x1) - p2*exp(0.20*x2), push = 1/sqrt(1.50 + powi(x1, 2))*ddot(x1) + dot(x2)*ddot(x2), pull = (1.17 - 0.31*sin(0.86*x1))*reaction(again2) - push, share = pull/(1.73 + powi(reaction(again2), 2)))]
pub struct Random171 {
    #[nominal(1.21)]
    pub p1: f64,
    #[nominal(1.40)]
    pub p2: f64,
    #[nominal(1.07)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.39 + 0.29*tan(0.70*sin(x1))/2), (1.24 + 0.13*cos(0.68*x2 - 0.29*x3)), (1.36 + 0.24*(if x3 > 0.14 { 1/sqrt(1.50 + powi(x2, 2)) } else { sin(p1*x1 + 0.99) }))))]
#[forces(
    0,
    p1*dot(x1)*dot(x3)*sin(0.70*x2 + 0.75*x2) - 0.68*powi(dot(x2), 2) - 0.41*dot(x3)/(1 + powi(x1, 2)),
    p1*dot(x3)*dot(x1)*sin(0.69*x3)*cos(0.86*x1 + 0.71*x1),
)]
#[constraint(row1: (1.50 + 0.24*(if x2 >= -0.55 { x3/(1 + powi(x3, 2)) } else { 0.34*sin(x3)/(1.50 + cos(x3)) }))*dot(x1) == 0)]
#[constraint(row2: (1.50 + 0.19*atan2(x3, 2 + cos(x1))/2)*dot(x2) + 0.29*tan(0.93*sin(x3))/2*dot(x1) == 0)]
#[constraint(row3: (1.50 - 0.18*(if x2 < -0.00 { sin(1.10*x1 + 0.69*x3) } else { cos(0.63*x2 + 0.22*x1) }))*dot(x3) - 0.11*wave(1.20*x2)*dot(x1) - 0.36*(if x2 >= 0.53 { sin(p1*x1 - 0.62) } else { 1/sqrt(1.50 + powi(x2, 2)) }) == 0)]
#[output(place = x3/(1 + powi(x3, 2)), power = p1*dot(x1)*dot(x1)*powi(cos(0.53*x2 - 0.84*x3), 3), push = 1/sqrt(1.50 + powi(x1, 2))*ddot(x3) + dot(x1)*ddot(x1), pull = (1.30 - 0.23*(if x3 >= 0.02 { tan(0.98*sin(x1))/2 } else { atan2(x1, 2 + cos(x1))/2 }))*reaction(row1) - push, share = pull/(1.21 + powi(reaction(row1), 2)))]
pub struct Random172 {
    #[nominal(0.84)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + wave(0.57*t + 0.55*x2 + 0.47)*dot(x1),
    v3 = dot(x3) + (if x2 < -0.02 { x1/(1 + powi(x1, 2)) } else { ln(1.60 + 0.34*cos(t)) })*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - wave(0.57*t + 0.55*x2 + 0.47)*(v1),
    dot(x3) = v3 - (if x2 < -0.02 { x1/(1 + powi(x1, 2)) } else { ln(1.60 + 0.34*cos(t)) })*(v1),
)]
#[inertia(matrix(
    [((1.25 - 0.15*(if x1 <= -0.32 { sin(1.20*x2 - 0.63*x1)*cos(0.92*t + 0.23*x2) } else { exp(-powi(x2, 2)/2) })))*((1.25 - 0.15*(if x1 <= -0.32 { sin(1.20*x2 - 0.63*x1)*cos(0.92*t + 0.23*x2) } else { exp(-powi(x2, 2)/2) }))), ((1.25 - 0.15*(if x1 <= -0.32 { sin(1.20*x2 - 0.63*x1)*cos(0.92*t + 0.23*x2) } else { exp(-powi(x2, 2)/2) })))*(0.14*(if x1 > 0.23 { atan2(x3, 2 + cos(x2))/2 } else { atan2(x2, 2 + cos(x1))/2 })), ((1.25 - 0.15*(if x1 <= -0.32 { sin(1.20*x2 - 0.63*x1)*cos(0.92*t + 0.23*x2) } else { exp(-powi(x2, 2)/2) })))*(0.13*x1/(1 + powi(x1, 2)))],
    [_, (0.14*(if x1 > 0.23 { atan2(x3, 2 + cos(x2))/2 } else { atan2(x2, 2 + cos(x1))/2 }))*(0.14*(if x1 > 0.23 { atan2(x3, 2 + cos(x2))/2 } else { atan2(x2, 2 + cos(x1))/2 })) + ((1.35 + 0.30*sin(0.85*x3 - 0.88*t)*cos(0.95*t)))*((1.35 + 0.30*sin(0.85*x3 - 0.88*t)*cos(0.95*t))), (0.14*(if x1 > 0.23 { atan2(x3, 2 + cos(x2))/2 } else { atan2(x2, 2 + cos(x1))/2 }))*(0.13*x1/(1 + powi(x1, 2)))],
    [_, _, (0.13*x1/(1 + powi(x1, 2)))*(0.13*x1/(1 + powi(x1, 2))) + (1.04)*(1.04)],
))]
#[forces(
    p1*v2*v1*atan2(t, 2 + cos(x1))/2 - p1*x1 - p2*0.31 - 0.98*t/(1 + powi(t, 2)),
    p1*1.60,
    p2*exp(0.20*t) + p2*v2*v2*(if x3 >= 0.07 { sin(0.72*x2) } else { exp(-powi(t, 2)/2) }) + 0.75*wave(0.54*t + 0.49*x2 + 1.13) + 0.75*0.50*sin(t)/(1.50 + cos(x1)),
)]
#[configuration(x3 = 1.08*0.55*sin(x2)/(1.50 + cos(x1)))]
#[constraint(bound: 1.06*v1 + 0.24*v1*v2*exp(-powi(x2, 2)/2) - 0.39*sin(0.70*t - 0.45*x3) == 0)]
#[output(place = (if x2 >= -0.35 { sin(1.17*x3 + 0.22)*cos(0.58*x3 + 0.79*t + 1.41) } else { sin(0.42*x2 - 0.44*x3) }), power = 1.77*powi(v2, 2) + p2*v3*v1*bump(0.85*x3 - 0.30*x3 - 1.27) + v1*sqrt(2 + powi(v3, 2)), push = t/(1 + powi(t, 2))*dot(v2) + v3*ddot(x3), pull = (1.02 - 0.30*sin(0.80*x1 + 0.49*x3 + 0.16))*reaction(bound) - push, share = pull/(1.16 + powi(reaction(bound), 2)))]
pub struct Random173 {
    #[nominal(1.01)]
    pub p1: f64,
    #[nominal(0.89)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + powi(cos(0.56*x2 + 0.26*x1 + 0.42), 3)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - powi(cos(0.56*x2 + 0.26*x1 + 0.42), 3)*(v1),
)]
#[kinetic_energy(powi(((1.37 - 0.34*(if x2 > 0.27 { exp(-powi(x2, 2)/2) } else { powi(cos(1.16*x1 + 0.85*t + 0.15), 3) })))*v1 + (0.24*cos(0.70*x2))*v2, 2)/2 + powi((1.12)*v2, 2)/2 + 0.35*powi(cos(0.58*x2 + 0.57*x1 + 0.59), 3)*v1)]
#[forces(
    p2*1.41 - p1*exp(0.20*x2) - v1*sqrt(2 + powi(v2, 2)),
    0,
)]
#[constraint(row1: (1.38 + 0.20*bump(1.00*x2))*v2 + 0.87*v1 + 0.30*(if t <= 0.43 { sin(0.49*t)*cos(0.64*t) } else { x2/(1 + powi(x2, 2)) }) == 0)]
#[independent(v1)]
#[independent(v2)]
#[output(place = sin(p1*x2 - 0.34), power = p1*x2 + v1*v1/1.28 + v2*v1/1.11 + p1*t, push = powi(cos(0.53*x1 - 0.37), 3)*dot(v2) + v1*ddot(x1), pull = (1.19 + 0.23*tan(0.73*sin(x2))/2)*reaction(row1) - push, share = pull/(1.40 + powi(reaction(row1), 2)))]
pub struct Random174 {
    #[nominal(0.95)]
    pub p1: f64,
    #[nominal(1.37)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[size(n = 3)]
#[coordinates(x[n])]
#[define(s[i] = bump(0.89*x[i] + i/2 - 0.44) for i in 0..n)]
#[define(r[0] = s[0]/2, r[i] = (r[i - 1] + s[i])/2 for i in 1..n)]
#[inertia(diag((1.12 + k[i]*r[i]/4) for i in 0..n))]
#[forces(
    0.23*sum(0..n, |j| sin(x[i] - x[j])*dot(x[j])) - 0.29*k[i]*dot(x[i]) - product(0..=i, |j| s[j]) for i in 0..n,
)]
#[potential_energy(sum(1..n, |i| k[i]*powi(x[i] - x[i - 1], 2))/2 + 0.23*r[n - 1])]
#[configuration(x[i] = 0.91*sin(x[n - 1] + i) for i in 0..2)]
#[constraint(held_x[i]: x[i] == 0.91*sin(x[n - 1] + i) for i in 0..2)]
pub struct Random175 {
    #[nominal(0.89)]
    pub p1: f64,
    #[nominal(1.04)]
    pub k: [f64; 3],
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.06 - 0.23*cos(0.99*x2)), (1.15 - 0.20*cos(1.00*x2 + 1.17)), (1.36 + 0.27*x3/(1 + powi(x3, 2)))))]
#[forces(
    p1*dot(x1)*dot(x3)*cos(1.19*x1 - 0.50*x3 + 0.73) - 0.58*powi(dot(x3), 2) - p1*1.19 - p1*exp(0.20*x2),
    1.09*powi(dot(x2), 2) - p1*dot(x1)*dot(x2)*x2/(1 + powi(x2, 2)) - p1*x1,
    1.72*powi(dot(x3), 2) + p1*x1 + 0.80*dot(x1)/(1 + powi(x3, 2)) + dot(x3)*sqrt(2 + powi(dot(x3), 2)),
)]
pub struct Random176 {
    #[nominal(1.12)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = v1 + 0.18*exp(-powi(x2, 2)/2)*v2 + 0.59*tan(0.98*sin(x2))/2,
    dot(x2) = v2 - 0.39*atan2(x2, 2 + cos(x2))/2*v1 + 0.30*sin(0.73*x3),
    dot(x3) = (1.20 + 0.12*cos(1.13*x3 - 0.91))*v3 + 0.20*ln(1.60 + 0.40*cos(x3))*v1 + 0.30*cos(1.05*x1 + 0.47*x3),
)]
#[inertia(matrix(
    [(1.31)*(1.31), 0, (1.31)*(0.27*exp(-powi(x2, 2)/2))],
    [_, (1.06)*(1.06), (1.06)*(0.37*0.61*sin(x2)/(1.50 + cos(x2)))],
    [_, _, (0.27*exp(-powi(x2, 2)/2))*(0.27*exp(-powi(x2, 2)/2)) + (0.37*0.61*sin(x2)/(1.50 + cos(x2)))*(0.37*0.61*sin(x2)/(1.50 + cos(x2))) + ((1.39 - 0.20*exp(-powi(x2, 2)/2)))*((1.39 - 0.20*exp(-powi(x2, 2)/2)))],
))]
#[forces(
    0.37*v3 - v2*sqrt(2 + powi(v3, 2)) - p3*x3 - 1.63*powi(v1, 2),
    1.48*v1/(1 + powi(x1, 2)) - 1.50*x3/(1 + powi(x3, 2)) - 1.04*powi(v2, 2),
    p3*x2 + 1.28*v2 + p1*v3*v2*sin(0.57*x1 + 0.31) + 0.55*v1/(1 + powi(x2, 2)),
)]
#[constraint(row1: (1.50 + 0.25*sin(1.00*x3 - 0.24*x3)*cos(0.92*x1 + 0.85*x2 - 1.45))*v1 - 0.30*atan2(x2, 2 + cos(x2))/2*v2 - 0.23*sin(0.71*x3)*v3 + 0.30*x3/(1 + powi(x3, 2)) == 0)]
pub struct Random177 {
    #[nominal(0.70)]
    pub p1: f64,
    #[nominal(0.90)]
    pub p2: f64,
    #[nominal(1.12)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = dot(x1) - 0.14*cos(0.63*t - 0.29)*dot(x2),
    v2 = 1.18*dot(x2) + 0.32*tan(0.39*sin(x3))/2*dot(x1),
    v3 = 1.12*dot(x3),
)]
#[inertia(diag((1.39 - 0.19*cos(0.75*t)), (1.35 - 0.13*wave(0.52*x3 - 0.70*x3 + 0.95)), 1.33))]
#[forces(
    p3*x2 - 0.36*powi(v1, 2) - 1.94*v3 - p3*v3*v3*ln(1.60 + 0.35*cos(x2)),
    p3*v2*v3*(if t < 0.56 { tan(0.87*sin(x3))/2 } else { wave(1.11*x1 + 0.62*x3 - 0.78) }),
    0,
)]
#[constraint(row1: 1.21*x3 + 0.11*sin(x3) + 0.34*sin(x1) + 0.30*sin(0.82*t) + 0.18 == 0)]
#[constraint(row2: 1.65*x2 + 0.25*sin(x2) + 0.39*sin(x1) + 0.36*powi(x3, 2)/2 + 0.30*sin(0.74*t) + 0.30 == 0)]
pub struct Random178 {
    #[nominal(0.61)]
    pub p1: f64,
    #[nominal(1.16)]
    pub p2: f64,
    #[nominal(0.97)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = 1.13*dot(x1) + 0.23*sin(0.88*x1 - 0.39*x1)*dot(x2) - 0.23*bump(0.98*x3 + 0.91),
    v2 = 1.13*dot(x2) - 0.31*sin(0.48*x1)*dot(x3) + 0.24*(if x3 > 0.32 { sin(0.80*x2 + 0.25*x3 - 0.39) } else { sin(0.89*x1 + 0.61*x1) }),
    v3 = dot(x3) - 0.22*sin(0.47*x3)*dot(x1) + 0.24*(if x3 >= 0.27 { exp(-powi(x3, 2)/2) } else { cos(0.44*x1 - 0.74*x3) }),
)]
#[inertia(diag((1.30 - 0.10*powi(cos(1.03*x1), 3)), (1.16 - 0.17*(if x3 <= 0.12 { sin(0.92*x3 - 0.36*x1) } else { powi(cos(0.74*x1), 3) })), (1.34 - 0.18*cos(0.50*x2 + 0.69))))]
#[forces(
    0.40*powi(v1, 2) + p1*exp(0.20*x2) + p1*x2 + v3*v3/(1.22 + 0.33*powi(cos(1.06*x3 - 0.30), 3)),
    1.31*tan(0.38*sin(x1))/2 - p1*1.90,
    1.87*bump(0.96*x2) + v1*sqrt(2 + powi(v1, 2)),
)]
#[constraint(row1: 1.31*x1 + 0.37*sin(x3) - 0.69 == 0)]
#[constraint(row2: v2 - 0.12*1/sqrt(1.50 + powi(x2, 2))*v3 + 0.24*exp(-powi(x3, 2)/2)*v1 == 0)]
#[independent(v3)]
#[output(place = atan2(x3, 2 + cos(x3))/2, power = 1.67*v3/(1 + powi(x2, 2)), push = tan(0.37*sin(x3))/2*dot(v2) + v1*ddot(x1), pull = (1.21 + 0.27*sin(0.45*x3))*reaction(row2) - push, share = pull/(1.80 + powi(reaction(row2), 2)))]
pub struct Random179 {
    #[nominal(0.87)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = (1.15 + 0.26*exp(-powi(x3, 2)/2))*dot(x1) - 0.22*sin(1.11*x3 - 0.24*x3)*dot(x3) - 0.25*powi(cos(0.90*x3 - 0.26*x3), 3),
    v2 = (1.12 - 0.15*atan2(x1, 2 + cos(x1))/2)*dot(x2) + 0.48*(if x4 <= 0.03 { powi(cos(0.68*x4 - 0.68*x2), 3) } else { powi(cos(0.81*x4 - 0.85), 3) }),
    v3 = 1.37*dot(x3) + 0.13*atan2(x3, 2 + cos(x4))/2,
    v4 = 1.10*dot(x4) - 0.28*cos(0.82*x4)*dot(x3) - 0.21*wave(0.57*x3 - 0.43*x2 - 0.28),
)]
#[inertia(diag((1.09 - 0.15*x1/(1 + powi(x1, 2))), (1.19 - 0.24*(if x3 >= 0.18 { cos(0.67*x2 - 0.27*x3) } else { sin(1.03*x4 + 0.85*x3 + 0.17) })), 1.37, 1.04))]
#[forces(
    p1*1.67 - p1*x2 - p1*1.69 - p1*x2,
    p1*v3*v4*tan(0.74*sin(x2))/2 - 0.80*cos(1.02*x1 - 0.51*x3),
    p1*0.86 - 1.20*v2/(1 + powi(x3, 2)),
    1.67*v1/(1 + powi(x2, 2)) - p1*x3 - p1*v2*v2*sin(0.67*x1) - 0.98*powi(v2, 2),
)]
#[constraint(height: 1.97*x1 + 0.30*sin(x2) + exp(0.37*x4)/2 + 0.36 == 0)]
#[constraint(height_rate: (1.19 - 0.34*0.50*sin(x1)/(1.50 + cos(x4)))*(1.97*dot(x1) + 0.30*cos(x2)*dot(x2) + 0.37*exp(0.37*x4)*dot(x4)/2) == 0)]
#[constraint(further: v3 + 0.32*cos(1.05*x3 - 0.22*x3)*v2 - 0.20*(if x1 < -0.03 { sin(1.14*x3 + 0.48*x2) } else { bump(0.61*x4) })*v4 + 0.46*x3/(1 + powi(x3, 2)) == 0)]
#[independent(v4, v2)]
#[output(place = cos(1.18*x2 - 0.89), power = v4*sqrt(2 + powi(v4, 2)) - p1*x2 - p1*v4*v3*(if x3 <= -0.24 { bump(1.15*x2 - 0.86*x3) } else { 0.77*sin(x1)/(1.50 + cos(x3)) }) - 1.69*powi(v2, 2), push = powi(cos(0.84*x3), 3)*dot(v3) + v2*ddot(x2))]
pub struct Random180 {
    #[nominal(0.58)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = (1.30 + 0.21*cos(0.70*x2 - 0.88*t))*v1 - 0.30*x3/(1 + powi(x3, 2))*v3,
    dot(x2) = (1.10 - 0.27*(if t > 0.56 { exp(-powi(x3, 2)/2) } else { tan(0.98*sin(x3))/2 }))*v2,
    dot(x3) = (1.28 - 0.19*(if x2 <= -0.30 { sin(0.72*x2 - 0.60) } else { cos(0.94*x3) }))*v3 - 0.37*sin(0.57*t)*v2,
)]
#[kinetic_energy(powi(((1.14 - 0.12*cos(0.96*x3)))*v1 + (0.35*x1/(1 + powi(x1, 2)))*v2 + (0.25*sin(0.45*t)*cos(1.09*x3 + 0.45*x1))*v3, 2)/2 + powi((1.18)*v2 + (0.16*(if x2 > -0.04 { tan(0.87*sin(t))/2 } else { bump(1.12*t) }))*v3, 2)/2 + powi((1.06)*v3, 2)/2 + 0.55*exp(-powi(t, 2)/2)*v3 - 0.60*powi(cos(1.02*x3 - 0.41*x1), 3))]
#[forces(
    p2*1.34 + 0.67*tan(0.71*sin(x2))/2 + p2*0.65 + 0.76*v2,
    p2*v2*v3*tan(0.46*sin(x3))/2,
    1.19*powi(v2, 2) + 1.23*v1/(1 + powi(x1, 2)),
)]
#[potential_energy(x2/(1 + powi(x2, 2)))]
#[constraint(height: 1.28*x2 + exp(0.18*x3)/2 + 0.30*sin(0.71*t) - 0.27 == 0)]
#[constraint(first: (1.50 + 0.21*sin(0.97*x2 - 0.70*t + 1.12))*v1 + 0.30*exp(-powi(x2, 2)/2)*v3 - 0.19*(if x3 < -0.19 { tan(0.41*sin(t))/2 } else { cos(0.42*x1 + 0.85) })*v2 + 0.25*sin(p1*x3 + 0.62) == 0)]
#[constraint(second: 1.28*dot(x2) + 0.18*exp(0.18*x3)*dot(x3)/2 + 0.30*0.71*cos(0.71*t) - 0.50*x3/(1 + powi(x3, 2))*((1.50 + 0.21*sin(0.97*x2 - 0.70*t + 1.12))*v1 + 0.30*exp(-powi(x2, 2)/2)*v3 - 0.19*(if x3 < -0.19 { tan(0.41*sin(t))/2 } else { cos(0.42*x1 + 0.85) })*v2 + 0.25*sin(p1*x3 + 0.62)) == 0)]
#[independent(s1 = 1.00*v3 - 0.19*bump(0.57*x2 - 0.22*t)*v2)]
pub struct Random181 {
    #[nominal(0.70)]
    pub p1: f64,
    #[nominal(0.67)]
    pub p2: f64,
    #[nominal(1.11)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    dot(x1) = (1.22 - 0.11*sin(1.05*x4 + 0.21*x1))*v1 + 0.40*tan(0.75*sin(x3))/2*v3,
    dot(x2) = v2,
    dot(x3) = v3 - 0.26*1/sqrt(1.50 + powi(x2, 2))*v4,
    dot(x4) = v4,
)]
#[define(l11 = (1.09 - 0.16*cos(1.19*x2)), l22 = 1.34, l31 = 0.16*atan2(x4, 2 + cos(x1))/2, l32 = 0.23*sin(p1*x4 - 0.97), l33 = (1.23 + 0.28*cos(1.15*x3)), l43 = 0.15*exp(-powi(x1, 2)/2), l44 = (1.31 - 0.20*(if x2 < -0.25 { powi(cos(1.10*x4 + 0.65*x2), 3) } else { x2/(1 + powi(x2, 2)) })))]
#[inertia(matrix(
    [l11*l11, 0, l11*l31, 0],
    [_, l22*l22, l22*l32, 0],
    [_, _, l31*l31 + l32*l32 + l33*l33, l33*l43],
    [_, _, _, l43*l43 + l44*l44],
))]
#[forces(
    0.99*powi(v1, 2) + p1*x1 + 1.38*0.31*sin(x3)/(1.50 + cos(x3)),
    1.28*tan(0.41*sin(x2))/2 - p1*1.32 - v1*sqrt(2 + powi(v2, 2)) - p1*v4*v1*ln(1.60 + 0.94*cos(x1)),
    p1*v3*v2*wave(0.73*x2 - 0.22*x1) + 0.98*v4/(1 + powi(x4, 2)),
    v4*v2/(1.08 + 0.35*exp(-powi(x1, 2)/2)) + 0.53*v1/(1 + powi(x2, 2)),
)]
#[configuration(x1 = 1.32*cos(0.53*x2 - 0.43*x3))]
#[output(place = 1/sqrt(1.50 + powi(x2, 2)), power = 1.82*powi(v2, 2) + 1.34*powi(v4, 2) + p1*exp(0.20*x4), push = wave(0.93*x3)*dot(v2) + v4*ddot(x4))]
pub struct Random182 {
    #[nominal(1.46)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = (1.36 - 0.34*wave(1.16*x2 + 0.61*x3))*dot(x1) - 0.34*cos(1.15*x2 + 0.36*x1)*dot(x2),
    v2 = dot(x2) + 0.28*exp(-powi(x3, 2)/2)*dot(x3),
    v3 = dot(x3),
)]
#[inertia(matrix(
    [(1.23)*(1.23), 0, (1.23)*(0.27*cos(0.50*x3 - 0.62*x2))],
    [_, ((1.21 - 0.11*powi(cos(1.15*x2 - 0.49*x3), 3)))*((1.21 - 0.11*powi(cos(1.15*x2 - 0.49*x3), 3))), ((1.21 - 0.11*powi(cos(1.15*x2 - 0.49*x3), 3)))*(0.19*sin(p1*t - 0.79))],
    [_, _, (0.27*cos(0.50*x3 - 0.62*x2))*(0.27*cos(0.50*x3 - 0.62*x2)) + (0.19*sin(p1*t - 0.79))*(0.19*sin(p1*t - 0.79)) + (1.30)*(1.30)],
))]
#[forces(
    1.15*powi(v3, 2) - v2*v3/(1.13 - 0.23*cos(0.57*x1 + 0.58*x2 + 0.95)),
    0.59*(if t > 0.27 { tan(0.99*sin(x1))/2 } else { sin(0.45*x2 - 0.74) }) + 1.00*sin(1.06*x1 - 1.11)*cos(0.69*x2),
    0.94*sin(p1*x1 + 0.76) - p2*exp(0.20*x1) - v2*v3/(1.01 - 0.13*sin(1.00*x1 - 0.63*x2 - 0.15)) - p1*v2*v1*cos(0.92*t + 0.49*x3),
)]
#[potential_energy(exp(-powi(x2, 2)/2))]
#[configuration(of(q1, q2), x1 = 1.25*q1, x2 = 1.25*q2, x3 = wave(1.07*q1 - 0.63*q1))]
#[constraint(held_x3: x3 - (wave(1.07*(x1/1.25) - 0.63*(x1/1.25))) == 0)]
pub struct Random183 {
    #[nominal(0.96)]
    pub p1: f64,
    #[nominal(0.97)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + exp(-powi(t, 2)/2)*dot(x1),
    v3 = dot(x3) + bump(1.11*x4)*dot(x2),
    v4 = dot(x4) + powi(cos(1.04*x1), 3)*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - exp(-powi(t, 2)/2)*(v1),
    dot(x3) = v3 - bump(1.11*x4)*(v2 - exp(-powi(t, 2)/2)*(v1)),
    dot(x4) = v4 - powi(cos(1.04*x1), 3)*(v2 - exp(-powi(t, 2)/2)*(v1)),
)]
#[kinetic_energy((1.11 + 0.23*x1/(1 + powi(x1, 2)))*powi(v1, 2)/2 + 1.26*powi(v2, 2)/2 + (1.07 + 0.20*x2/(1 + powi(x2, 2)))*powi(v3, 2)/2 + (1.13 + 0.26*powi(cos(1.00*x4 - 0.22*x2), 3))*powi(v4, 2)/2 - 0.34*ln(1.60 + 0.85*cos(x3))*v3 + 0.65*1/sqrt(1.50 + powi(x2, 2)))]
#[forces(
    p1*0.91 + v1*sqrt(2 + powi(v4, 2)) + 0.68*ln(1.60 + 0.44*cos(t)) + v3*v1/(1.25 + 0.21*ln(1.60 + 0.47*cos(x3))),
    0.80*exp(-powi(x4, 2)/2) - p1*v1*v4*sin(0.60*x1 + 0.42*x1),
    p3*v4*v2*cos(0.50*t) + 1.75*v2 + 0.57*v2/(1 + powi(x4, 2)),
    1.38*v2/(1 + powi(x1, 2)) - 1.36*v1 - p2*v2*v1*(if x4 > -0.29 { sin(0.45*t) } else { 1/sqrt(1.50 + powi(x4, 2)) }) - p1*exp(0.20*x2),
)]
#[configuration(x3 = 1.18*1/sqrt(1.50 + powi(x4, 2)))]
#[constraint(held_x3: x3 - (1.18*1/sqrt(1.50 + powi(x4, 2))) == 0)]
#[constraint(rolling: (1.50 + 0.24*exp(-powi(x1, 2)/2))*dot(x2) + 0.13*sin(1.00*x2)*dot(x4) - 0.20*sin(0.51*x2)*dot(x1) - 0.44*1/sqrt(1.50 + powi(x4, 2)) == 0)]
pub struct Random184 {
    #[nominal(1.43)]
    pub p1: f64,
    #[nominal(0.65)]
    pub p2: f64,
    #[nominal(0.53)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = 1.29*dot(x1),
    v2 = (1.20 - 0.24*exp(-powi(x3, 2)/2))*dot(x2) + 0.27*(if x4 >= 0.24 { bump(0.50*x4 - 0.37*x1) } else { tan(0.95*sin(x4))/2 })*dot(x3),
    v3 = (1.08 + 0.19*bump(1.01*x4))*dot(x3) + 0.10*powi(cos(0.56*x4 + 0.52*x1), 3)*dot(x2),
    v4 = 1.38*dot(x4) - 0.16*sin(0.90*x1 + 0.35*x3 - 0.78)*cos(1.20*x1 - 0.46*x1 - 1.21)*dot(x2),
)]
#[inertia(diag((1.09 - 0.14*x3/(1 + powi(x3, 2))), 1.02, 1.23, 1.10))]
#[forces(
    1.99*1/sqrt(1.50 + powi(x3, 2)) - 1.51*v1/(1 + powi(x3, 2)) - 1.86*cos(0.77*x1) - 1.87*v3,
    p2*exp(0.20*x3) - p2*1.99 - p1*x3,
    v4*sqrt(2 + powi(v4, 2)) + p3*0.38,
    1.44*powi(v1, 2) - 0.85*v1/(1 + powi(x1, 2)) - v3*sqrt(2 + powi(v2, 2)) - p2*v1*v1*(if x1 > -0.38 { sin(1.12*x3)*cos(0.63*x1 + 0.72*x2 - 1.10) } else { cos(0.93*x3) }),
)]
#[potential_energy(atan2(x2, 2 + cos(x2))/2)]
#[constraint(row1: v1 + 0.47*x1/(1 + powi(x1, 2))*v2 == 0)]
#[constraint(row2: v4 + 0.50*(if x1 > -0.22 { tan(0.89*sin(x4))/2 } else { cos(0.66*x3 + 0.21*x3 + 0.12) })*v2 == 0)]
#[constraint(row3: v3 + 0.55*(if x3 <= 0.38 { bump(1.19*x1) } else { 1/sqrt(1.50 + powi(x1, 2)) })*v2 == 0)]
#[complement(
    w1 = [-(1.03 - 0.26*ln(1.60 + 0.58*cos(x1)))*(0.47*x1/(1 + powi(x1, 2))), (1.03 - 0.26*ln(1.60 + 0.58*cos(x1))), -(1.03 - 0.26*ln(1.60 + 0.58*cos(x1)))*(0.55*(if x3 <= 0.38 { bump(1.19*x1) } else { 1/sqrt(1.50 + powi(x1, 2)) })), -(1.03 - 0.26*ln(1.60 + 0.58*cos(x1)))*(0.50*(if x1 > -0.22 { tan(0.89*sin(x4))/2 } else { cos(0.66*x3 + 0.21*x3 + 0.12) }))],
)]
pub struct Random185 {
    #[nominal(1.50)]
    pub p1: f64,
    #[nominal(0.59)]
    pub p2: f64,
    #[nominal(0.75)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[define(l11 = 1.26, l21 = 0.16*sin(0.88*x4 + 0.48*x4 + 1.12)*cos(1.11*x3 + 0.75*x3 + 1.14), l22 = (1.21 - 0.21*sin(0.97*x3)*cos(0.68*x2)), l32 = 0.24*cos(0.72*x3 + 0.31*x2 - 0.25), l33 = (1.15 + 0.17*sin(0.88*x3)), l41 = 0.14*atan2(x3, 2 + cos(x2))/2, l42 = 0.21*0.80*sin(x2)/(1.50 + cos(x1)), l44 = (1.33 - 0.23*sin(p1*x1 - 0.98)))]
#[inertia(matrix(
    [l11*l11, l11*l21, 0, l11*l41],
    [_, l21*l21 + l22*l22, l22*l32, l21*l41 + l22*l42],
    [_, _, l32*l32 + l33*l33, l32*l42],
    [_, _, _, l41*l41 + l42*l42 + l44*l44],
))]
#[forces(
    0,
    p1*exp(0.20*x3),
    1.23*sin(1.14*x3 - 0.99),
    dot(x2)*sqrt(2 + powi(dot(x4), 2)) - dot(x2)*sqrt(2 + powi(dot(x2), 2)) - 0.70*(if x2 > -0.11 { bump(0.86*x1) } else { 1/sqrt(1.50 + powi(x2, 2)) }),
)]
#[constraint(row1: 1.58*x1 + 0.24*x3*x3 + 0.71 == 0)]
#[constraint(row2: (1.50 + 0.21*tan(0.49*sin(x4))/2)*dot(x4) - 0.31*x4/(1 + powi(x4, 2))*dot(x3) - 0.23*(if x3 < -0.35 { 1/sqrt(1.50 + powi(x4, 2)) } else { x3/(1 + powi(x3, 2)) })*dot(x1) == 0)]
#[constraint(row3: dot(x2) + 0.21*1/sqrt(1.50 + powi(x3, 2))*dot(x3) - 0.20*wave(0.87*x1 - 0.29*x4) == 0)]
#[independent(s1 = (1.50 - 0.21*0.96*sin(x1)/(1.50 + cos(x1)))*dot(x3) - 0.27*wave(1.07*x1)*dot(x1) - 0.22*cos(1.20*x1))]
pub struct Random186 {
    #[nominal(1.21)]
    pub p1: f64,
    #[nominal(1.01)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = (1.13 - 0.28*x2/(1 + powi(x2, 2)))*v1 + 0.12*(if x3 < -0.58 { x3/(1 + powi(x3, 2)) } else { atan2(x2, 2 + cos(x2))/2 })*v3 + 0.36*0.44*sin(x2)/(1.50 + cos(x3)),
    dot(x2) = 1.03*v2 + 0.16*cos(0.50*x3 + 0.75*x2 + 1.28)*v1 + 0.52*0.91*sin(x2)/(1.50 + cos(x1)),
    dot(x3) = (1.20 - 0.11*sin(0.68*x3 + 0.25))*v3 + 0.14*cos(0.50*x1 - 0.46*x2)*v1 + 0.35*ln(1.60 + 0.45*cos(x3)),
)]
#[define(l11 = 1.30, l22 = 1.08, l31 = 0.19*(if x3 >= -0.22 { sin(p1*x2 + 0.16) } else { ln(1.60 + 0.54*cos(x1)) }), l32 = 0.11*cos(0.87*x3), l33 = (1.01 + 0.34*(if x3 < 0.09 { 0.56*sin(x2)/(1.50 + cos(x1)) } else { ln(1.60 + 0.50*cos(x1)) })))]
#[kinetic_energy(powi(l11*v1 + l31*v3, 2)/2 + powi(l22*v2 + l32*v3, 2)/2 + powi(l33*v3, 2)/2 + 0.58*x1/(1 + powi(x1, 2)))]
#[forces(
    0.42*v2 - p1*exp(0.20*x1) - p1*exp(0.20*x1),
    p1*v1*v1*(if x3 > -0.48 { wave(0.90*x2 + 0.36*x2 - 1.43) } else { exp(-powi(x1, 2)/2) }) - p1*0.85,
    0,
)]
#[constraint(row1: 1.34*x1 + 0.19*sin(x1) - 0.60 == 0)]
#[constraint(row2: v2 - 0.20*tan(0.50*sin(x3))/2*v1 == 0)]
#[constraint(row3: (1.50 - 0.15*1/sqrt(1.50 + powi(x2, 2)))*v3 + 0.23*bump(1.08*x3)*v1 - 0.10*cos(0.70*x2)*v2 == 0)]
pub struct Random187 {
    #[nominal(0.61)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.29 + 0.31*powi(cos(0.65*x3), 3)), (1.20 - 0.31*cos(0.65*x1 - 0.30*x1)), (1.07 + 0.30*(if x1 > -0.09 { 0.87*sin(x3)/(1.50 + cos(x3)) } else { ln(1.60 + 0.52*cos(x2)) }))))]
#[forces(
    0.32*sin(0.69*x2)*cos(0.42*x1 + 0.54*x2 - 0.13) - 0.75*powi(dot(x2), 2),
    p1*0.49,
    0,
)]
#[potential_energy(cos(0.85*x3))]
#[constraint(row1: 1.70*dot(x3) + 0.26*dot(x3)*dot(x2)*powi(cos(0.98*x1 + 0.53*x1), 3) + 0.34*wave(0.87*x1 + 0.46*x3 - 0.43) == 0)]
#[output(place = (if x1 > 0.15 { powi(cos(0.56*x2), 3) } else { powi(cos(1.04*x3), 3) }), power = dot(x2)*sqrt(2 + powi(dot(x3), 2)) + dot(x1)*dot(x1)/1.25, push = sin(p1*x3 + 0.53)*ddot(x3) + dot(x3)*ddot(x3), pull = (1.04 + 0.18*1/sqrt(1.50 + powi(x3, 2)))*reaction(row1) - push, share = pull/(1.80 + powi(reaction(row1), 2)))]
pub struct Random188 {
    #[nominal(0.57)]
    pub p1: f64,
    #[nominal(1.43)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[define(l11 = (1.27 - 0.16*0.97*sin(x1)/(1.50 + cos(x3))), l21 = 0.23*0.50*sin(x4)/(1.50 + cos(x4)), l22 = (1.26 - 0.24*cos(1.01*x2 + 0.85*x3)), l31 = 0.31*tan(0.99*sin(x1))/2, l32 = 0.12*wave(0.48*x2 + 1.17), l33 = (1.03 - 0.29*sin(0.57*x1 + 0.80*x2 + 1.26)), l42 = 0.15*sin(0.46*x2 - 0.41*x3), l43 = 0.17*tan(0.48*sin(x4))/2, l44 = (1.05 + 0.11*(if x2 < -0.54 { sin(0.78*x2 - 0.49*x1) } else { cos(1.02*x1) })))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, 0],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l22*l42],
    [_, _, l31*l31 + l32*l32 + l33*l33, l32*l42 + l33*l43],
    [_, _, _, l42*l42 + l43*l43 + l44*l44],
))]
#[forces(
    dot(x2)*sqrt(2 + powi(dot(x4), 2)) - dot(x2)*sqrt(2 + powi(dot(x2), 2)),
    0,
    1.48*powi(dot(x2), 2) - 0.99*dot(x2)/(1 + powi(x4, 2)) - 0.42*powi(dot(x1), 2) - p1*x3,
    1.86*dot(x2) + p2*dot(x3)*dot(x4)*x2/(1 + powi(x2, 2)),
)]
#[constraint(row1: 1.96*ddot(x3) + 0.43*dot(x4)/sqrt(1.20 + powi(dot(x4), 2)) == 0)]
#[constraint(row2: ddot(x1) - 0.23*atan2(x4, 2 + cos(x4))/2*ddot(x3) + 0.45*dot(x4)/sqrt(1.20 + powi(dot(x3), 2)) == 0)]
#[constraint(row3: (1.50 + 0.11*(if x2 > -0.41 { bump(0.73*x3) } else { atan2(x3, 2 + cos(x2))/2 }))*ddot(x4) - 0.16*sin(0.65*x1 - 0.59*x2)*ddot(x3) - 0.20*bump(1.13*x3 + 0.54*x4)*ddot(x1) - 0.72*dot(x3)*dot(x1)*0.84*sin(x2)/(1.50 + cos(x2)) == 0)]
#[constraint(row4: 1.29*ddot(x2) + 0.17*powi(cos(1.12*x3 - 0.43*x2), 3)*ddot(x3) + 0.23*ln(1.60 + 0.57*cos(x4))*ddot(x1) + 0.64*exp(-powi(x1, 2)/2) == 0)]
#[independent(dot(x2), dot(x4), dot(x1), dot(x3))]
#[output(place = atan2(x4, 2 + cos(x1))/2, power = p2*x3 - 0.55*powi(dot(x3), 2) - 0.89*dot(x1), push = sin(0.68*x2 + 0.23*x1)*ddot(x1) + dot(x2)*ddot(x2), pull = (1.10 - 0.13*sin(p2*x1 + 0.45))*reaction(row2) - push, share = pull/(1.86 + powi(reaction(row2), 2)))]
pub struct Random189 {
    #[nominal(1.35)]
    pub p1: f64,
    #[nominal(1.37)]
    pub p2: f64,
    #[nominal(1.21)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + bump(0.81*x4)*dot(x1),
    v3 = dot(x3) + cos(0.86*x3 + 0.82*x1)*dot(x1),
    v4 = dot(x4) + atan2(x3, 2 + cos(x1))/2*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - bump(0.81*x4)*(v1),
    dot(x3) = v3 - cos(0.86*x3 + 0.82*x1)*(v1),
    dot(x4) = v4 - atan2(x3, 2 + cos(x1))/2*(v1),
)]
#[inertia(diag(1.22, (1.36 + 0.26*bump(0.79*x1)), 1.08, (1.03 + 0.24*exp(-powi(x4, 2)/2))))]
#[forces(
    v1*sqrt(2 + powi(v4, 2)) - p2*x3 - v1*sqrt(2 + powi(v1, 2)) - 0.87*v4,
    p1*v4*v1*ln(1.60 + 0.44*cos(x3)) + 1.03*wave(1.04*x4 - 0.47*x1) + v3*v2/(1.35 - 0.14*cos(0.62*x2)) + v2*v3/1.24,
    p1*exp(0.20*x1) + v1*v4/(1.40 + 0.15*x4/(1 + powi(x4, 2))),
    1.38*powi(v3, 2) - 1.48*1/sqrt(1.50 + powi(x1, 2)),
)]
#[constraint(row1: 1.36*x2 + 0.45 == 0)]
#[constraint(row2: powi(v3, 2) - 0.26*powi(v2, 2) - (2 - 0.26*x4/(1 + powi(x4, 2))) == 0)]
#[constraint(row3: 1.81*v4 - 0.28*sin(v4 + cos(1.10*x1 - 0.86*x4 + 0.90)*v2) - 0.24*sin(p2*x1 + 0.37) == 0)]
#[constraint(row4: 1.38*v1 - 0.13*sqrt(1.50 + powi(v4, 2) + powi(v3, 2)) - 0.27*sin(0.86*x4 - 0.85*x1) == 0)]
#[independent(v1, v4, v3)]
#[output(place = ln(1.60 + 0.44*cos(x1)), power = 1.31*powi(v2, 2) - 1.36*x1/(1 + powi(x1, 2)) - 0.67*v1, push = sin(p2*x1 - 0.68)*dot(v1) + v4*ddot(x4), pull = (1.08 + 0.22*sin(0.53*x1 + 0.68*x3)*cos(1.11*x2))*reaction(row1) - push, share = pull/(1.88 + powi(reaction(row1), 2)))]
pub struct Random190 {
    #[nominal(1.00)]
    pub p1: f64,
    #[nominal(1.16)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[kinetic_energy(1.18*powi(dot(x1), 2)/2 + 1.17*powi(dot(x2), 2)/2 + (1.31 - 0.26*wave(0.50*x3))*powi(dot(x3), 2)/2 + 0.52*bump(1.12*x3 + 0.39*x3 + 1.13)*dot(x2) + 0.35*sin(0.44*x1 - 1.28)*dot(x3) - 0.63*exp(-powi(x1, 2)/2))]
#[forces(
    p3*dot(x2)*dot(x2)*bump(0.56*x2 + 0.57*x2 - 0.12),
    p2*x3,
    p2*1.20 - 0.93*dot(x2),
)]
#[constraint(row1: dot(x3) - 0.21*(if x2 <= -0.35 { 0.89*sin(x3)/(1.50 + cos(x1)) } else { 0.73*sin(x3)/(1.50 + cos(x1)) })*dot(x2) == 0)]
#[constraint(row2: (1.50 + 0.12*atan2(x1, 2 + cos(x1))/2)*ddot(x1) + 0.13*(if x2 <= 0.19 { sin(0.79*x1 - 0.59*x1) } else { sin(p1*x1 + 0.56) })*ddot(x2) - 0.26*exp(-powi(x2, 2)/2)*ddot(x3) - 0.25*powi(cos(1.03*x1 - 0.34), 3) == 0)]
#[independent(dot(x2), dot(x1))]
pub struct Random191 {
    #[nominal(1.20)]
    pub p1: f64,
    #[nominal(0.78)]
    pub p2: f64,
    #[nominal(0.61)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = (1.04 - 0.29*ln(1.60 + 0.32*cos(x3)))*v1 + 0.28*atan2(x1, 2 + cos(x3))/2*v3,
    dot(x2) = (1.27 + 0.11*sin(1.04*x3 + 0.22*x3))*v2 - 0.18*(if x3 < -0.04 { powi(cos(0.71*x1 + 0.48*x2), 3) } else { tan(0.93*sin(x2))/2 })*v3,
    dot(x3) = (1.21 + 0.11*atan2(x3, 2 + cos(x1))/2)*v3,
)]
#[define(l11 = (1.24 - 0.11*x3/(1 + powi(x3, 2))), l22 = 1.34, l31 = 0.11*x3/(1 + powi(x3, 2)), l32 = 0.37*ln(1.60 + 0.87*cos(x1)), l33 = (1.02 + 0.10*sin(p1*x2 - 0.65)))]
#[inertia(matrix(
    [l11*l11, 0, l11*l31],
    [_, l22*l22, l22*l32],
    [_, _, l31*l31 + l32*l32 + l33*l33],
))]
#[forces(
    0.75*powi(v2, 2) - 0.63*0.92*sin(x3)/(1.50 + cos(x2)),
    p1*exp(0.20*x1),
    p1*exp(0.20*x2) - 1.34*v2 - p1*1.51 - p1*x1,
)]
#[constraint(row1: v1 == 0)]
#[constraint(row2: 1.90*v2 - 0.18*sqrt(1.50 + powi(v1, 2) + powi(v1, 2)) + 0.49*(if x2 < -0.51 { cos(0.89*x3 - 0.24*x2) } else { powi(cos(0.40*x2 - 0.88*x2), 3) }) == 0)]
#[constraint(row3: dot(v3) - 0.10*1/sqrt(1.50 + powi(x2, 2))*dot(v1) + 0.24*cos(0.72*x1)*dot(v2) + 0.28*v1 + 0.28*tan(0.62*sin(x3))/2 == 0)]
#[independent(s1 = 1.91*v3 + 0.31*sin(0.73*x3 + 0.66*x2)*v1, s2 = (1.50 + 0.25*cos(0.67*x2 + 0.47*x2 + 0.70))*v2 + 0.23*ln(1.60 + 0.57*cos(x2))*v3)]
pub struct Random192 {
    #[nominal(0.55)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[kinetic_energy(1.37*powi(dot(x1), 2)/2 + 1.36*powi(dot(x2), 2)/2 + 1.23*powi(dot(x3), 2)/2 + 1.22*powi(dot(x4), 2)/2 + 0.44*sin(0.40*x2)*cos(0.65*t - 0.31)*dot(x3) - 0.36*atan2(x3, 2 + cos(x2))/2*dot(x4) + 0.69*atan2(x1, 2 + cos(x1))/2)]
#[forces(
    dot(x3)*dot(x2)/(1.25 + 0.19*sin(p2*x1 - 0.56)),
    1.98*powi(dot(x1), 2) - p2*1.94 - dot(x3)*sqrt(2 + powi(dot(x4), 2)),
    p1*1.59 - dot(x3)*dot(x4)/(1.40 + 0.18*cos(0.74*t + 0.23)) - 1.32*ln(1.60 + 0.74*cos(x4)),
    p3*dot(x2)*dot(x4)*sin(0.89*x1 + 0.57) + p1*dot(x1)*dot(x4)*bump(1.12*x4 + 0.39*t + 1.48),
)]
#[constraint(row1: 1.40*dot(x1) + 0.24*dot(x1)*dot(x2)*sin(p2*t + 0.56) + 0.47*sin(p2*x2 + 0.83) == 0)]
#[constraint(row2: 1.06*dot(x4) + 0.12*sin(dot(x4) + exp(-powi(x3, 2)/2)*dot(x2)) - 0.59*wave(0.54*x4 - 0.48*x2 + 0.21) == 0)]
#[constraint(again1: (1.05 + 0.28*0.40*sin(t)/(1.50 + cos(x3)))*(1.40*dot(x1) + 0.24*dot(x1)*dot(x2)*sin(p2*t + 0.56) + 0.47*sin(p2*x2 + 0.83)) == 0, redundant)]
#[output(place = t/(1 + powi(t, 2)), power = 1.20*(if x4 <= 0.39 { sin(0.52*x3 - 0.89*x2) } else { 1/sqrt(1.50 + powi(t, 2)) }) - 1.29*dot(x3) - p3*0.47 - 0.64*powi(dot(x1), 2), push = cos(1.19*x2 + 0.83*x3 + 0.40)*ddot(x2) + dot(x1)*ddot(x1), pull = 1.36*reaction(row2) - push, share = pull/(1.10 + powi(reaction(row2), 2)))]
pub struct Random193 {
    #[nominal(1.09)]
    pub p1: f64,
    #[nominal(1.09)]
    pub p2: f64,
    #[nominal(1.46)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = 1.21*v1 - 0.32*sin(p3*x1 + 0.34),
    dot(x2) = (1.13 - 0.14*sin(0.80*t))*v2 - 0.31*tan(0.93*sin(x3))/2*v1 + 0.20*(if x3 < -0.03 { bump(1.19*t + 0.67) } else { 0.99*sin(x2)/(1.50 + cos(x1)) }),
    dot(x3) = 1.18*v3 - 0.30*powi(cos(0.96*x2 + 0.60*x3), 3),
)]
#[inertia(diag((1.17 + 0.11*ln(1.60 + 0.41*cos(x2))), (1.11 - 0.15*x3/(1 + powi(x3, 2))), (1.27 + 0.34*(if x2 < -0.20 { bump(1.08*x1 - 0.27*x2) } else { wave(0.95*x2) }))))]
#[forces(
    1.49*sin(1.06*t + 0.81) + v1*v1/(1.33 + 0.34*(if x1 < 0.33 { sin(p2*x3 + 0.55) } else { sin(0.65*t) })),
    0,
    0.36*v3 - p1*x1,
)]
#[constraint(row1: (1.50 - 0.30*1/sqrt(1.50 + powi(x1, 2)))*v3 + 0.17*ln(1.60 + 0.52*cos(x3))*v1 + 0.34*wave(0.98*x2)*v2 == 0)]
#[output(place = sin(1.03*x3), power = p1*1.25 - p3*v3*v1*(if x2 < -0.47 { 0.89*sin(x3)/(1.50 + cos(x1)) } else { ln(1.60 + 0.45*cos(x1)) }), push = 1/sqrt(1.50 + powi(x2, 2))*dot(v2) + v2*ddot(x2), pull = (1.19 - 0.11*exp(-powi(x1, 2)/2))*reaction(row1) - push, share = pull/(1.32 + powi(reaction(row1), 2)))]
pub struct Random194 {
    #[nominal(1.07)]
    pub p1: f64,
    #[nominal(1.07)]
    pub p2: f64,
    #[nominal(0.81)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = 1.06*v1 + 0.37*(if x2 < -0.31 { exp(-powi(x2, 2)/2) } else { 1/sqrt(1.50 + powi(x1, 2)) })*v2 - 0.28*sin(1.14*x2 - 0.40*x1)*cos(0.62*x2 + 0.28),
    dot(x2) = 1.31*v2 + 0.23*exp(-powi(x1, 2)/2)*v3 - 0.33*bump(0.68*x2 - 0.52*x1),
    dot(x3) = (1.03 + 0.13*sin(0.73*x3 + 0.50*x1)*cos(1.15*x1 + 0.78*x2))*v3 + 0.22*x2/(1 + powi(x2, 2))*v2 - 0.51*tan(0.61*sin(x2))/2,
)]
#[inertia(diag((1.03 - 0.19*sin(0.56*x3)), (1.16 + 0.23*(if x2 < -0.35 { sin(0.63*x2 - 0.35*x2) } else { wave(1.01*x1) })), (1.02 + 0.35*sin(0.74*x3)*cos(1.00*x3 + 0.70*x1 - 1.19))))]
#[forces(
    0.68*powi(v3, 2),
    1.70*v2/(1 + powi(x1, 2)) - p2*x2 - 1.08*v1,
    p1*v3*v3*x2/(1 + powi(x2, 2)) + 0.83*v2 + v1*sqrt(2 + powi(v3, 2)) + 1.96*wave(0.46*x3 - 0.75*x1),
)]
#[potential_energy(atan2(x2, 2 + cos(x3))/2)]
#[configuration(x3 = 0.54*wave(1.18*x1 + 0.94))]
#[constraint(bound: ddot(x2) + 0.25*(if x1 > -0.33 { 1/sqrt(1.50 + powi(x2, 2)) } else { sin(0.66*x2 + 0.73*x1 - 1.39)*cos(0.94*x2 - 1.45) })*dot(v1) + 0.23*sin(0.97*x1)*dot(v3) - 0.33*v1*v3*cos(0.93*x1) == 0)]
pub struct Random195 {
    #[nominal(0.53)]
    pub p1: f64,
    #[nominal(1.01)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[inertia(matrix(
    [((1.03 - 0.20*powi(cos(0.43*x2 - 0.55*x1), 3)))*((1.03 - 0.20*powi(cos(0.43*x2 - 0.55*x1), 3))), 0, 0, ((1.03 - 0.20*powi(cos(0.43*x2 - 0.55*x1), 3)))*(0.39*cos(0.65*x2 - 0.29))],
    [_, ((1.05 + 0.19*x2/(1 + powi(x2, 2))))*((1.05 + 0.19*x2/(1 + powi(x2, 2)))), ((1.05 + 0.19*x2/(1 + powi(x2, 2))))*(0.34*sin(0.54*x3 - 0.33*x3 + 1.20)), 0],
    [_, _, (0.34*sin(0.54*x3 - 0.33*x3 + 1.20))*(0.34*sin(0.54*x3 - 0.33*x3 + 1.20)) + ((1.16 - 0.12*wave(0.94*x2)))*((1.16 - 0.12*wave(0.94*x2))), 0],
    [_, _, _, (0.39*cos(0.65*x2 - 0.29))*(0.39*cos(0.65*x2 - 0.29)) + (1.39)*(1.39)],
))]
#[forces(
    dot(x1)*dot(x4)/1.10 - 1.39*powi(dot(x3), 2),
    p3*exp(0.20*x4),
    p3*dot(x3)*dot(x2)*(if x1 <= -0.29 { bump(0.80*x1) } else { cos(0.44*x4 + 0.41) }) + p2*1.76 + p2*exp(0.20*x3) + p1*0.46,
    p1*x4 + p3*exp(0.20*x3),
)]
#[potential_energy((if x1 >= -0.08 { sin(0.90*x4) } else { bump(1.08*x2 - 1.28) }))]
#[constraint(row1: 1.17*x1 + 0.10*sin(x1) - 0.93*x2 + 0.10*cos(x2) + 0.20*0.5 == 0)]
#[constraint(row2: 1.49*x4 + 0.10*sin(x4) + 0.86*x3 + 0.10*cos(x3) + 0.20*0.5 == 0)]
#[independent(dot(x2), dot(x3))]
#[independent(dot(x1), dot(x3))]
#[independent(dot(x1), dot(x4))]
pub struct Random196 {
    #[nominal(1.06)]
    pub p1: f64,
    #[nominal(0.84)]
    pub p2: f64,
    #[nominal(0.61)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 3)]
#[coordinates(x[n])]
#[define(s[i] = cos(1.11*x[i] + i/2 - 0.65) for i in 0..n)]
#[define(r[0] = s[0]/2, r[i] = (r[i - 1] + s[i])/2 for i in 1..n)]
#[inertia(matrix(
    [(1.28 + k[i]*r[i]/4)*(1.28 + k[j]*r[j]/4)/(1 + 2*powi(i - j, 2)) for j in 0..n] for i in 0..n,
))]
#[forces(
    0.25*sum(0..n, |j| sin(x[i] - x[j])*dot(x[j])) - 0.70*k[i]*dot(x[i]) - product(0..=i, |j| s[j]) for i in 0..n,
)]
#[potential_energy(sum(1..n, |i| k[i]*powi(x[i] - x[i - 1], 2))/2 + 0.25*r[n - 1])]
pub struct Random197 {
    #[nominal(0.93)]
    pub p1: f64,
    #[nominal(1.13)]
    pub p2: f64,
    #[nominal(0.56)]
    pub p3: f64,
    #[nominal(0.93)]
    pub k: [f64; 3],
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = 1.35*dot(x1) - 0.34*sin(0.66*x2),
    v2 = (1.03 - 0.16*cos(1.09*x2 + 0.87*x5 + 1.01))*dot(x2) - 0.34*exp(-powi(x1, 2)/2)*dot(x5) - 0.58*1/sqrt(1.50 + powi(x1, 2)),
    v3 = (1.13 - 0.24*(if x4 < 0.59 { 1/sqrt(1.50 + powi(x3, 2)) } else { sin(0.41*t)*cos(0.83*t) }))*dot(x3) + 0.12*atan2(x5, 2 + cos(t))/2*dot(x2) + 0.30*cos(1.12*x4 + 0.47*t - 0.97),
    v4 = 1.19*dot(x4) + 0.14*sin(0.99*x4)*cos(0.84*x5),
    v5 = 1.39*dot(x5) + 0.21*sin(1.12*t + 0.75*t - 0.81)*cos(0.64*x3 + 0.64),
)]
#[inertia(diag(1.27, (1.13 - 0.17*sin(0.89*x1)*cos(0.47*x3 - 0.67)), 1.08, (1.28 + 0.34*sin(0.77*x5 - 0.71*x3)), (1.16 - 0.18*sin(1.18*t + 0.42*x5))))]
#[forces(
    p2*v2*v5*exp(-powi(t, 2)/2),
    p1*exp(0.20*x3) + v1*v3/1.20 + p1*exp(0.20*x4) + p1*1.98,
    v3*v1/(1.34 - 0.30*1/sqrt(1.50 + powi(x4, 2))) + v2*sqrt(2 + powi(v1, 2)) + p1*0.54 + 0.47*exp(-powi(x2, 2)/2),
    0,
    0.84*powi(v3, 2),
)]
#[potential_energy(wave(0.59*x1 + 0.57*x3 + 1.50))]
pub struct Random198 {
    #[nominal(0.68)]
    pub p1: f64,
    #[nominal(0.93)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    dot(x1) = (1.20 - 0.11*x3/(1 + powi(x3, 2)))*v1 + 0.38*wave(0.97*x1 + 1.37),
    dot(x2) = v2 + 0.18*sin(p1*x1 - 0.96),
    dot(x3) = v3 - 0.29*cos(1.00*x2 - 0.59*x3),
    dot(x4) = (1.17 - 0.11*ln(1.60 + 0.36*cos(t)))*v4 - 0.60*sin(p1*x4 + 0.92),
)]
#[inertia(diag((1.03 - 0.34*atan2(x2, 2 + cos(x4))/2), 1.03, (1.24 - 0.11*1/sqrt(1.50 + powi(x2, 2))), 1.06))]
#[forces(
    p1*0.41 - v1*sqrt(2 + powi(v2, 2)),
    v4*sqrt(2 + powi(v3, 2)) - 2.00*v4,
    0.44*sin(p1*x4 - 0.81),
    p1*x1 - p1*1.59,
)]
#[potential_energy(sin(p1*x2 - 0.30))]
#[constraint(row1: v4 - 0.23*0.85*sin(x1)/(1.50 + cos(x4))*v3 + 0.14*cos(0.99*x2 + 0.46*x2)*v2 - 0.33*x1/(1 + powi(x1, 2)) == 0)]
#[independent(v1, v2, v3)]
#[output(place = powi(cos(1.04*x2), 3), power = p1*1.00 + p1*x4 + p1*0.72, push = cos(0.83*x2 + 0.62*x2)*dot(v3) + v4*ddot(x4), pull = (1.04 - 0.19*bump(0.71*x2 - 0.48*t + 1.15))*reaction(row1) - push, share = pull/(1.85 + powi(reaction(row1), 2)))]
pub struct Random199 {
    #[nominal(1.26)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = (1.04 - 0.16*bump(1.09*x1 - 0.25*x1 + 1.29))*dot(x1) - 0.22*cos(0.83*x2)*dot(x2),
    v2 = (1.18 - 0.15*ln(1.60 + 0.56*cos(x2)))*dot(x2) + 0.26*tan(0.47*sin(x2))/2*dot(x1),
)]
#[inertia(matrix(
    [((1.38 + 0.29*sin(1.12*x2 + 0.67*x2 + 1.11)*cos(0.64*x1)))*((1.38 + 0.29*sin(1.12*x2 + 0.67*x2 + 1.11)*cos(0.64*x1))), ((1.38 + 0.29*sin(1.12*x2 + 0.67*x2 + 1.11)*cos(0.64*x1)))*(0.30*(if x2 >= 0.42 { 0.82*sin(x1)/(1.50 + cos(x2)) } else { 1/sqrt(1.50 + powi(x2, 2)) }))],
    [_, (0.30*(if x2 >= 0.42 { 0.82*sin(x1)/(1.50 + cos(x2)) } else { 1/sqrt(1.50 + powi(x2, 2)) }))*(0.30*(if x2 >= 0.42 { 0.82*sin(x1)/(1.50 + cos(x2)) } else { 1/sqrt(1.50 + powi(x2, 2)) })) + (1.18)*(1.18)],
))]
#[forces(
    p1*0.91 + v2*v2/1.00 + p1*v2*v2*tan(0.46*sin(x1))/2,
    v2*v2/1.04 - v2*sqrt(2 + powi(v1, 2)) - p1*v1*v1*sin(0.95*x1 - 0.36) - p2*x1,
)]
#[potential_energy(wave(0.69*x2 + 1.35))]
#[constraint(held_x1: x1 - (0.56*sin(0.78*x2 - 0.79*x2)*cos(1.19*x2 + 0.53)) == 0)]
#[output(place = atan2(x1, 2 + cos(x2))/2, power = 1.38*powi(v2, 2) - v2*sqrt(2 + powi(v2, 2)) - p1*v1*v2*0.38*sin(x2)/(1.50 + cos(x2)) - 1.49*v2/(1 + powi(x2, 2)), push = sin(0.63*x1)*cos(0.41*x1 - 0.52*x2)*dot(v2) + v2*ddot(x2), pull = (1.29 - 0.29*atan2(x1, 2 + cos(x1))/2)*reaction(held_x1) - push, share = pull/(1.26 + powi(reaction(held_x1), 2)))]
pub struct Random6Whole {
    #[nominal(1.31)]
    pub p1: f64,
    #[nominal(0.90)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + (if x2 < 0.22 { sin(p1*t - 0.26) } else { powi(cos(1.16*x3 + 0.57*x1), 3) })*dot(x1),
    v3 = dot(x3) + ln(1.60 + 0.62*cos(t))*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - (if x2 < 0.22 { sin(p1*t - 0.26) } else { powi(cos(1.16*x3 + 0.57*x1), 3) })*(v1),
    dot(x3) = v3 - ln(1.60 + 0.62*cos(t))*(v1),
)]
#[inertia(diag((1.18 - 0.27*(if x3 < -0.09 { ln(1.60 + 0.44*cos(t)) } else { ln(1.60 + 0.37*cos(t)) })), (1.35 + 0.14*sin(1.02*t)), (1.30 + 0.21*exp(-powi(t, 2)/2))))]
#[forces(
    p1*t - 1.91*v3 - p1*v3*v3*sin(0.76*t),
    p1*1.79,
    1.05*powi(v2, 2),
)]
#[constraint(held_x1: x1 - (0.86*sin(0.65*t + 1.07)) == 0)]
#[constraint(held_x2: x2 - (1.27*sin(0.86*t - 0.32*t)*cos(0.92*x3 + 0.29*t)) == 0)]
#[constraint(bound: 1.58*v3 - 0.22*ln(1.60 + 0.94*cos(x1))*v2*v2 + 0.37*1/sqrt(1.50 + powi(x1, 2)) == 0)]
pub struct Random19Whole {
    #[nominal(1.28)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[inputs(tau)]
#[kinetic_energy((1.39 + 0.19*ln(1.60 + 0.70*cos(x1)))*powi(dot(x1), 2)/2 + (1.09 + 0.28*sin(0.43*x2 - 0.91))*powi(dot(x2), 2)/2 - 0.48*sin(0.55*x2 + 0.57*x2 - 0.58)*dot(x1) + 0.27*bump(0.46*x1)*dot(x2) + 0.62*tan(0.90*sin(x1))/2)]
#[forces(
    tau*0.64 - p1*dot(x1)*dot(x2)*1/sqrt(1.50 + powi(x1, 2)) - p1*exp(0.20*x2),
    p1*exp(0.20*x2) + p1*x1,
)]
#[constraint(held_x2: x2 - (1.24*1/sqrt(1.50 + powi(x1, 2))) == 0)]
pub struct Random28Whole {
    #[nominal(0.74)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2)]
#[inertia(diag(1.35, (1.39 + 0.26*sin(0.60*x2)*cos(0.59*x1 - 1.29))))]
#[forces(
    0.51*dot(x2) - 1.31*cos(0.92*t) - p2*dot(x2)*dot(x2)*exp(-powi(x1, 2)/2) - dot(x1)*sqrt(2 + powi(dot(x1), 2)),
    0.84*powi(dot(x2), 2),
)]
#[potential_energy(sin(0.87*x1)*cos(0.92*x1 - 0.84*x1))]
#[constraint(held_x1: x1 - (sin(p1*(x2/1.25) + 0.99)) == 0)]
#[output(place = wave(1.06*x2 - 0.55*t), power = dot(x1)*sqrt(2 + powi(dot(x2), 2)), push = sin(0.96*t - 1.27)*ddot(x1) + dot(x2)*ddot(x2), pull = (1.27 + 0.28*cos(0.59*t))*reaction(held_x1) - push, share = pull/(1.95 + powi(reaction(held_x1), 2)))]
pub struct Random29Whole {
    #[nominal(1.20)]
    pub p1: f64,
    #[nominal(1.47)]
    pub p2: f64,
    #[nominal(1.26)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = (1.08 + 0.20*tan(0.39*sin(t))/2)*v1 + 0.58*0.81*sin(x1)/(1.50 + cos(t)),
    dot(x2) = 1.27*v2 - 0.35*wave(1.17*x3 - 0.68*x1 - 1.48)*v1 + 0.59*cos(0.77*t - 0.82*t - 0.62),
    dot(x3) = v3 - 0.50*sin(0.70*x3 - 1.37)*cos(0.55*x2 + 0.28*x3),
)]
#[kinetic_energy(1.02*powi(v1, 2)/2 + 1.16*powi(v2, 2)/2 + (1.30 + 0.12*sin(1.10*x1 + 0.90*x2))*powi(v3, 2)/2)]
#[forces(
    1.73*v1/(1 + powi(x3, 2)) + 1.39*powi(v3, 2) + p1*0.31 + 0.95*v3/(1 + powi(x1, 2)),
    1.81*powi(v1, 2) - p1*v3*v1*(if x3 >= -0.35 { t/(1 + powi(t, 2)) } else { bump(0.77*x3 - 0.59*x1) }) - 0.45*(if x3 < 0.18 { bump(0.55*x3) } else { bump(0.70*t + 0.31*t) }),
    p1*v2*v1*exp(-powi(x1, 2)/2),
)]
#[potential_energy(atan2(x3, 2 + cos(x2))/2)]
#[constraint(held_x2: x2 - (0.58*sin(p1*x1 + 0.64)) == 0)]
#[constraint(rolling: (1.50 - 0.26*tan(0.63*sin(x1))/2)*dot(x3) + 0.18*(if x1 <= -0.03 { tan(0.57*sin(x1))/2 } else { sin(1.04*x1 + 0.84) })*dot(x1) == 0)]
pub struct Random30Whole {
    #[nominal(0.87)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[inputs(tau)]
#[kinetic_energy(powi((1.11)*dot(x1) + (0.10*cos(0.98*x1))*dot(x2) + (0.40*(if x3 <= -0.06 { x1/(1 + powi(x1, 2)) } else { atan2(x2, 2 + cos(x3))/2 }))*dot(x3), 2)/2 + powi(((1.35 + 0.21*x2/(1 + powi(x2, 2))))*dot(x2) + (0.18*tan(0.80*sin(x2))/2)*dot(x3), 2)/2 + powi(((1.02 + 0.27*ln(1.60 + 0.45*cos(x2))))*dot(x3), 2)/2)]
#[forces(
    p1*x1 + dot(x2)*dot(x2)/1.15 + dot(x3)*sqrt(2 + powi(dot(x3), 2)) + 0.77*dot(x3)/(1 + powi(x1, 2)),
    p1*x1 + dot(x1)*sqrt(2 + powi(dot(x1), 2)),
    1.73*ln(1.60 + 0.39*cos(x1)) + 0.82*powi(cos(0.88*x3 - 0.55), 3) + 0.70*dot(x3)/(1 + powi(x2, 2)) + tau*1.16,
)]
#[constraint(held_x2: x2 - (tan(0.72*sin((x3/1.25)))/2) == 0)]
#[constraint(held_x1: x1 - (tan(0.56*sin((x3/1.25)))/2) == 0)]
#[output(place = wave(0.99*x2 - 0.32*x2 - 1.46), power = tau*1.26, push = sin(1.02*x1)*ddot(x1) + dot(x1)*ddot(x1), pull = (1.18 - 0.24*exp(-powi(x3, 2)/2))*reaction(held_x2) - push, share = pull/(1.62 + powi(reaction(held_x2), 2)))]
pub struct Random51Whole {
    #[nominal(0.66)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[define(l11 = (1.08 - 0.34*sin(0.92*x2)), l22 = (1.07 + 0.32*exp(-powi(x3, 2)/2)), l32 = 0.28*(if x2 > 0.21 { sin(0.99*x2 - 0.55*x3) } else { sin(0.60*x2 + 0.17) }), l33 = (1.27 - 0.21*cos(0.63*x2)))]
#[inertia(matrix(
    [l11*l11, 0, 0],
    [_, l22*l22, l22*l32],
    [_, _, l32*l32 + l33*l33],
))]
#[forces(
    p1*exp(0.20*x3),
    0.84*dot(x3) + dot(x2)*dot(x3)/(1.04 - 0.33*sin(0.80*x1 - 0.43)),
    p1*exp(0.20*x3) + 1.75*powi(dot(x1), 2) + dot(x1)*sqrt(2 + powi(dot(x2), 2)) + p1*exp(0.20*x3),
)]
#[potential_energy(exp(-powi(x3, 2)/2))]
#[constraint(held_x1: x1 - (0.52*sin(1.18*x2 - 0.21*x2 + 0.70)) == 0)]
#[constraint(bound: 1.53*dot(x2) - 0.17*sqrt(1.50 + powi(dot(x3), 2) + powi(dot(x1), 2)) + 0.20*x1/(1 + powi(x1, 2)) == 0)]
#[output(place = atan2(x1, 2 + cos(x3))/2, power = 0.81*1/sqrt(1.50 + powi(x1, 2)) + 1.69*powi(dot(x3), 2) + dot(x2)*sqrt(2 + powi(dot(x2), 2)), push = 0.34*sin(x1)/(1.50 + cos(x2))*ddot(x1) + dot(x1)*ddot(x1), pull = (1.14 + 0.25*atan2(x1, 2 + cos(x1))/2)*reaction(bound) - push, share = pull/(1.82 + powi(reaction(bound), 2)))]
pub struct Random63Whole {
    #[nominal(1.20)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[inputs(tau)]
#[kinematics(
    v1 = (1.08 - 0.10*sin(0.86*x2 + 0.55*x1))*dot(x1) + 0.31*exp(-powi(x2, 2)/2)*dot(x4) + 0.38*tan(0.43*sin(x4))/2,
    v2 = dot(x2) - 0.21*x4/(1 + powi(x4, 2))*dot(x3) + 0.22*tan(0.93*sin(x4))/2,
    v3 = (1.30 - 0.19*ln(1.60 + 0.72*cos(x3)))*dot(x3) + 0.12*bump(0.66*x3),
    v4 = dot(x4) + 0.19*0.74*sin(x3)/(1.50 + cos(x3))*dot(x3) + 0.13*cos(0.64*x1),
)]
#[kinetic_energy(1.15*powi(v1, 2)/2 + (1.15 - 0.22*sin(0.43*x3 + 1.50))*powi(v2, 2)/2 + (1.27 + 0.20*1/sqrt(1.50 + powi(x4, 2)))*powi(v3, 2)/2 + 1.35*powi(v4, 2)/2 + 0.55*sin(0.55*x3 - 0.66)*cos(0.42*x4 - 0.73*x1)*v1)]
#[forces(
    v4*sqrt(2 + powi(v2, 2)) - v4*sqrt(2 + powi(v2, 2)),
    0,
    1.35*powi(v1, 2) + 0.48*(if x1 < 0.37 { cos(0.70*x1 + 1.05) } else { sin(0.61*x1) }) + v3*sqrt(2 + powi(v1, 2)),
    p1*v1*v2*0.87*sin(x2)/(1.50 + cos(x4)) + 0.77*v3/(1 + powi(x2, 2)),
)]
#[potential_energy(sin(0.50*x2 - 0.53))]
#[constraint(held_x2: x2 - (sin(1.16*(x1/1.25))*cos(0.70*(x1/1.25) - 0.40*(x1/1.25) - 0.69)) == 0)]
#[constraint(held_x4: x4 - (wave(0.46*(x1/1.25) + 0.51*(x1/1.25))) == 0)]
#[constraint(held_x3: x3 - (cos(0.92*(x1/1.25) + 0.46)) == 0)]
#[output(place = (if x1 > 0.10 { atan2(x4, 2 + cos(x2))/2 } else { tan(0.61*sin(x2))/2 }), power = 1.43*powi(v3, 2) - v3*sqrt(2 + powi(v2, 2)) - 1.92*sin(p1*x4 + 0.30), push = 0.73*sin(x2)/(1.50 + cos(x1))*dot(v1) + v1*ddot(x1), pull = (1.23 - 0.31*1/sqrt(1.50 + powi(x4, 2)))*reaction(held_x4) - push, share = pull/(1.85 + powi(reaction(held_x4), 2)))]
pub struct Random73Whole {
    #[nominal(1.38)]
    pub p1: f64,
    #[nominal(1.22)]
    pub p2: f64,
    #[nominal(0.50)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = (1.15 + 0.32*(if x1 < -0.20 { sin(p2*x1 - 0.35) } else { sin(p1*x3 - 0.63) }))*v1 + 0.18*sin(0.61*x2 + 0.34*x1 + 1.27)*v5 - 0.36*0.57*sin(x4)/(1.50 + cos(x4)),
    dot(x2) = (1.02 - 0.34*ln(1.60 + 0.83*cos(x3)))*v2 + 0.24*x5/(1 + powi(x5, 2)),
    dot(x3) = (1.29 - 0.25*ln(1.60 + 0.43*cos(x4)))*v3 - 0.27*exp(-powi(x3, 2)/2),
    dot(x4) = (1.35 + 0.30*bump(0.82*x2 - 0.28*x2))*v4 - 0.15*sin(0.40*x2),
    dot(x5) = (1.15 - 0.14*(if x5 >= 0.57 { sin(0.68*x5 - 0.38*x3) } else { x2/(1 + powi(x2, 2)) }))*v5 + 0.14*wave(0.89*x2 - 1.26)*v4 - 0.31*sin(0.50*x1)*cos(0.85*x1),
)]
#[inertia(matrix(
    [((1.08 + 0.13*tan(0.36*sin(x3))/2))*((1.08 + 0.13*tan(0.36*sin(x3))/2)), ((1.08 + 0.13*tan(0.36*sin(x3))/2))*(0.35*(if x4 < 0.56 { bump(0.75*x1 + 0.49*x2 - 0.32) } else { ln(1.60 + 0.84*cos(x4)) })), ((1.08 + 0.13*tan(0.36*sin(x3))/2))*(0.10*(if x2 <= -0.06 { tan(0.37*sin(x5))/2 } else { 1/sqrt(1.50 + powi(x1, 2)) })), ((1.08 + 0.13*tan(0.36*sin(x3))/2))*(0.25*atan2(x5, 2 + cos(x2))/2), ((1.08 + 0.13*tan(0.36*sin(x3))/2))*(0.16*exp(-powi(x1, 2)/2))],
    [_, (0.35*(if x4 < 0.56 { bump(0.75*x1 + 0.49*x2 - 0.32) } else { ln(1.60 + 0.84*cos(x4)) }))*(0.35*(if x4 < 0.56 { bump(0.75*x1 + 0.49*x2 - 0.32) } else { ln(1.60 + 0.84*cos(x4)) })) + ((1.35 - 0.14*sin(0.58*x2 - 0.62*x3)*cos(1.19*x1 - 0.30*x1)))*((1.35 - 0.14*sin(0.58*x2 - 0.62*x3)*cos(1.19*x1 - 0.30*x1))), (0.35*(if x4 < 0.56 { bump(0.75*x1 + 0.49*x2 - 0.32) } else { ln(1.60 + 0.84*cos(x4)) }))*(0.10*(if x2 <= -0.06 { tan(0.37*sin(x5))/2 } else { 1/sqrt(1.50 + powi(x1, 2)) })), (0.35*(if x4 < 0.56 { bump(0.75*x1 + 0.49*x2 - 0.32) } else { ln(1.60 + 0.84*cos(x4)) }))*(0.25*atan2(x5, 2 + cos(x2))/2) + ((1.35 - 0.14*sin(0.58*x2 - 0.62*x3)*cos(1.19*x1 - 0.30*x1)))*(0.29*sin(0.83*x1)), (0.35*(if x4 < 0.56 { bump(0.75*x1 + 0.49*x2 - 0.32) } else { ln(1.60 + 0.84*cos(x4)) }))*(0.16*exp(-powi(x1, 2)/2)) + ((1.35 - 0.14*sin(0.58*x2 - 0.62*x3)*cos(1.19*x1 - 0.30*x1)))*(0.13*sin(p1*x2 + 0.90))],
    [_, _, (0.10*(if x2 <= -0.06 { tan(0.37*sin(x5))/2 } else { 1/sqrt(1.50 + powi(x1, 2)) }))*(0.10*(if x2 <= -0.06 { tan(0.37*sin(x5))/2 } else { 1/sqrt(1.50 + powi(x1, 2)) })) + ((1.29 - 0.16*0.43*sin(x1)/(1.50 + cos(x5))))*((1.29 - 0.16*0.43*sin(x1)/(1.50 + cos(x5)))), (0.10*(if x2 <= -0.06 { tan(0.37*sin(x5))/2 } else { 1/sqrt(1.50 + powi(x1, 2)) }))*(0.25*atan2(x5, 2 + cos(x2))/2), (0.10*(if x2 <= -0.06 { tan(0.37*sin(x5))/2 } else { 1/sqrt(1.50 + powi(x1, 2)) }))*(0.16*exp(-powi(x1, 2)/2)) + ((1.29 - 0.16*0.43*sin(x1)/(1.50 + cos(x5))))*(0.12*sin(1.03*x1))],
    [_, _, _, (0.25*atan2(x5, 2 + cos(x2))/2)*(0.25*atan2(x5, 2 + cos(x2))/2) + (0.29*sin(0.83*x1))*(0.29*sin(0.83*x1)) + ((1.23 + 0.14*powi(cos(0.50*x4 - 0.25*x4), 3)))*((1.23 + 0.14*powi(cos(0.50*x4 - 0.25*x4), 3))), (0.25*atan2(x5, 2 + cos(x2))/2)*(0.16*exp(-powi(x1, 2)/2)) + (0.29*sin(0.83*x1))*(0.13*sin(p1*x2 + 0.90)) + ((1.23 + 0.14*powi(cos(0.50*x4 - 0.25*x4), 3)))*(0.11*1/sqrt(1.50 + powi(x2, 2)))],
    [_, _, _, _, (0.16*exp(-powi(x1, 2)/2))*(0.16*exp(-powi(x1, 2)/2)) + (0.13*sin(p1*x2 + 0.90))*(0.13*sin(p1*x2 + 0.90)) + (0.12*sin(1.03*x1))*(0.12*sin(1.03*x1)) + (0.11*1/sqrt(1.50 + powi(x2, 2)))*(0.11*1/sqrt(1.50 + powi(x2, 2))) + ((1.07 + 0.15*wave(0.84*x1)))*((1.07 + 0.15*wave(0.84*x1)))],
))]
#[forces(
    1.95*(if x4 <= -0.31 { tan(0.31*sin(x4))/2 } else { sin(0.85*x3 + 0.68*x5) }),
    0,
    0,
    1.40*v2/(1 + powi(x1, 2)) + 1.94*powi(v1, 2) + v5*v3/1.26,
    v1*sqrt(2 + powi(v1, 2)) - 1.43*v4/(1 + powi(x4, 2)) - 1.46*powi(v4, 2),
)]
#[constraint(held_x2: x2 - (1.13*atan2(x5, 2 + cos(x1))/2) == 0)]
#[constraint(rolling: (1.50 + 0.24*exp(-powi(x4, 2)/2))*dot(x1) - 0.28*cos(1.15*x1 + 0.44)*dot(x5) + 0.25*ln(1.60 + 0.38*cos(x5))*dot(x4) + 0.23*atan2(x3, 2 + cos(x1))/2*dot(x3) == 0)]
#[output(place = sin(p1*x1 + 0.65), power = v4*sqrt(2 + powi(v1, 2)) + p2*x5 + 1.63*powi(v1, 2) + p2*exp(0.20*x5), push = sin(1.04*x5)*dot(v2) + v5*ddot(x5), pull = (1.08 - 0.13*powi(cos(0.83*x2 - 0.60*x5 - 1.06), 3))*reaction(rolling) - push, share = pull/(1.76 + powi(reaction(rolling), 2)))]
pub struct Random74Whole {
    #[nominal(0.71)]
    pub p1: f64,
    #[nominal(0.93)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = 1.39*dot(x1) + 0.31*0.41*sin(x3)/(1.50 + cos(t))*dot(x5) - 0.54*1/sqrt(1.50 + powi(x2, 2)),
    v2 = dot(x2) - 0.42*0.33*sin(x2)/(1.50 + cos(x1)),
    v3 = (1.30 + 0.29*powi(cos(0.40*x1 + 0.89*x2 - 0.25), 3))*dot(x3) + 0.26*cos(0.99*t + 1.39)*dot(x2) + 0.34*(if t >= -0.42 { cos(0.87*t + 0.42*x2) } else { cos(0.88*t + 0.97) }),
    v4 = dot(x4) + 0.35*wave(0.96*x5 - 0.22*x2),
    v5 = dot(x5) + 0.18*bump(0.89*x2)*dot(x4) + 0.42*sin(0.93*x3 + 0.59*t),
)]
#[inertia(diag(1.32, 1.05, (1.00 + 0.34*ln(1.60 + 0.77*cos(x1))), 1.31, (1.04 + 0.22*bump(0.91*x4))))]
#[forces(
    0,
    1.97*powi(v5, 2) - 1.90*v1/(1 + powi(x3, 2)) - 1.18*v2/(1 + powi(x2, 2)) - 0.49*v1,
    v1*sqrt(2 + powi(v2, 2)) - p2*x3 - v4*v2/1.20 - 1.17*v4,
    0.31*powi(v5, 2) - 1.68*v2 - p1*v5*v3*sin(1.08*x3 - 0.50*x4) - v4*sqrt(2 + powi(v2, 2)),
    p2*exp(0.20*t) + 1.28*v2 + v5*sqrt(2 + powi(v1, 2)),
)]
#[constraint(held_x1: x1 - (1.14*sin(p1*t + 0.23)) == 0)]
pub struct Random94Whole {
    #[nominal(1.02)]
    pub p1: f64,
    #[nominal(1.00)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = (1.11 + 0.24*(if x2 <= -0.18 { wave(1.00*x1 - 0.30*x2) } else { 1/sqrt(1.50 + powi(x5, 2)) }))*dot(x1) + 0.11*wave(0.74*x3 - 0.11)*dot(x4) + 0.58*wave(0.53*x5 + 0.49*x4),
    v2 = 1.10*dot(x2) - 0.15*tan(0.67*sin(x4))/2*dot(x1) + 0.35*sin(0.89*x1 - 0.23)*cos(0.64*x3 - 0.75*x2 + 0.29),
    v3 = dot(x3) - 0.32*powi(cos(0.48*x4), 3)*dot(x2) - 0.36*bump(0.93*x2),
    v4 = (1.04 + 0.32*0.64*sin(x1)/(1.50 + cos(x4)))*dot(x4) + 0.12*sin(0.56*x3 + 0.72*x5)*dot(x1) - 0.57*x4/(1 + powi(x4, 2)),
    v5 = (1.02 + 0.31*sin(0.95*x1 - 0.20*x2))*dot(x5) - 0.30*sin(0.43*x2 + 0.69*x2)*dot(x4) - 0.20*sin(0.64*x4),
)]
#[inertia(matrix(
    [((1.20 - 0.29*1/sqrt(1.50 + powi(x1, 2))))*((1.20 - 0.29*1/sqrt(1.50 + powi(x1, 2)))), ((1.20 - 0.29*1/sqrt(1.50 + powi(x1, 2))))*(0.24*sin(p1*x4 - 0.93)), ((1.20 - 0.29*1/sqrt(1.50 + powi(x1, 2))))*(0.31*powi(cos(1.20*x3 + 0.44*x3 + 0.60), 3)), ((1.20 - 0.29*1/sqrt(1.50 + powi(x1, 2))))*(0.34*cos(1.03*x3 - 0.68)), 0],
    [_, (0.24*sin(p1*x4 - 0.93))*(0.24*sin(p1*x4 - 0.93)) + ((1.12 + 0.20*ln(1.60 + 0.75*cos(x3))))*((1.12 + 0.20*ln(1.60 + 0.75*cos(x3)))), (0.24*sin(p1*x4 - 0.93))*(0.31*powi(cos(1.20*x3 + 0.44*x3 + 0.60), 3)) + ((1.12 + 0.20*ln(1.60 + 0.75*cos(x3))))*(0.18*x2/(1 + powi(x2, 2))), (0.24*sin(p1*x4 - 0.93))*(0.34*cos(1.03*x3 - 0.68)) + ((1.12 + 0.20*ln(1.60 + 0.75*cos(x3))))*(0.14*ln(1.60 + 0.38*cos(x3))), ((1.12 + 0.20*ln(1.60 + 0.75*cos(x3))))*(0.17*ln(1.60 + 0.73*cos(x4)))],
    [_, _, (0.31*powi(cos(1.20*x3 + 0.44*x3 + 0.60), 3))*(0.31*powi(cos(1.20*x3 + 0.44*x3 + 0.60), 3)) + (0.18*x2/(1 + powi(x2, 2)))*(0.18*x2/(1 + powi(x2, 2))) + ((1.13 - 0.27*sin(0.51*x2 - 0.90*x4 - 1.36)))*((1.13 - 0.27*sin(0.51*x2 - 0.90*x4 - 1.36))), (0.31*powi(cos(1.20*x3 + 0.44*x3 + 0.60), 3))*(0.34*cos(1.03*x3 - 0.68)) + (0.18*x2/(1 + powi(x2, 2)))*(0.14*ln(1.60 + 0.38*cos(x3))), (0.18*x2/(1 + powi(x2, 2)))*(0.17*ln(1.60 + 0.73*cos(x4)))],
    [_, _, _, (0.34*cos(1.03*x3 - 0.68))*(0.34*cos(1.03*x3 - 0.68)) + (0.14*ln(1.60 + 0.38*cos(x3)))*(0.14*ln(1.60 + 0.38*cos(x3))) + ((1.29 - 0.32*atan2(x2, 2 + cos(x5))/2))*((1.29 - 0.32*atan2(x2, 2 + cos(x5))/2)), (0.14*ln(1.60 + 0.38*cos(x3)))*(0.17*ln(1.60 + 0.73*cos(x4))) + ((1.29 - 0.32*atan2(x2, 2 + cos(x5))/2))*(0.30*ln(1.60 + 0.75*cos(x4)))],
    [_, _, _, _, (0.17*ln(1.60 + 0.73*cos(x4)))*(0.17*ln(1.60 + 0.73*cos(x4))) + (0.30*ln(1.60 + 0.75*cos(x4)))*(0.30*ln(1.60 + 0.75*cos(x4))) + ((1.21 + 0.28*ln(1.60 + 0.84*cos(x5))))*((1.21 + 0.28*ln(1.60 + 0.84*cos(x5))))],
))]
#[forces(
    p2*1.31 - p1*x1 - 0.31*bump(0.42*x2 + 0.21*x1),
    0,
    1.37*(if x5 < -0.56 { cos(1.03*x4) } else { sin(0.62*x2 + 1.29) }) - v2*sqrt(2 + powi(v4, 2)),
    p2*v1*v5*1/sqrt(1.50 + powi(x4, 2)) + p1*exp(0.20*x3),
    1.66*tan(0.96*sin(x2))/2 - v2*v4/(1.16 - 0.32*ln(1.60 + 0.58*cos(x2))) - p2*v4*v5*sin(0.79*x2 + 0.85*x3) - v3*v5/(1.32 - 0.16*1/sqrt(1.50 + powi(x5, 2))),
)]
#[constraint(held_x1: x1 - (cos(0.73*(x5/1.25) - 0.61*(x5/1.25))) == 0)]
#[constraint(held_x4: x4 - ((if (x5/1.25) >= 0.04 { bump(1.06*(x5/1.25)) } else { cos(1.04*(x5/1.25)) })) == 0)]
#[constraint(held_x3: x3 - (sin(0.57*(x5/1.25) + 0.83*(x5/1.25))*cos(0.62*(x5/1.25))) == 0)]
#[constraint(held_x2: x2 - (cos(1.01*(x5/1.25) - 0.23*(x5/1.25))) == 0)]
#[output(place = sin(p1*x5 + 0.92), power = p1*exp(0.20*x4) + v5*sqrt(2 + powi(v1, 2)) + p2*v5*v4*sin(0.90*x5)*cos(0.63*x5 - 0.62), push = wave(0.84*x1 - 0.60*x2)*dot(v2) + v1*ddot(x1), pull = 1.36*reaction(held_x1) - push, share = pull/(1.30 + powi(reaction(held_x1), 2)))]
pub struct Random95Whole {
    #[nominal(1.09)]
    pub p1: f64,
    #[nominal(1.00)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + ln(1.60 + 0.85*cos(x3))*dot(x1),
    v3 = dot(x3) + (if x5 > 0.19 { sin(1.14*x2 + 0.29*x4)*cos(0.47*x4 + 0.87*x5) } else { 1/sqrt(1.50 + powi(x2, 2)) })*dot(x2),
    v4 = dot(x4) + sin(1.05*x1 + 0.43*x2 - 1.49)*cos(0.45*x5 - 0.50)*dot(x1),
    v5 = dot(x5) + 0.78*sin(x4)/(1.50 + cos(x5))*dot(x2),
    v6 = dot(x6) + (if x1 > 0.43 { powi(cos(1.07*x1 + 0.67*x4 - 0.32), 3) } else { powi(cos(0.74*x6 + 0.69*x4 + 1.22), 3) })*dot(x4),
    dot(x1) = v1,
    dot(x2) = v2 - ln(1.60 + 0.85*cos(x3))*(v1),
    dot(x3) = v3 - (if x5 > 0.19 { sin(1.14*x2 + 0.29*x4)*cos(0.47*x4 + 0.87*x5) } else { 1/sqrt(1.50 + powi(x2, 2)) })*(v2 - ln(1.60 + 0.85*cos(x3))*(v1)),
    dot(x4) = v4 - sin(1.05*x1 + 0.43*x2 - 1.49)*cos(0.45*x5 - 0.50)*(v1),
    dot(x5) = v5 - 0.78*sin(x4)/(1.50 + cos(x5))*(v2 - ln(1.60 + 0.85*cos(x3))*(v1)),
    dot(x6) = v6 - (if x1 > 0.43 { powi(cos(1.07*x1 + 0.67*x4 - 0.32), 3) } else { powi(cos(0.74*x6 + 0.69*x4 + 1.22), 3) })*(v4 - sin(1.05*x1 + 0.43*x2 - 1.49)*cos(0.45*x5 - 0.50)*(v1)),
)]
#[inertia(diag((1.35 - 0.28*x2/(1 + powi(x2, 2))), (1.31 - 0.35*1/sqrt(1.50 + powi(x6, 2))), 1.12, 1.19, (1.35 - 0.24*atan2(x2, 2 + cos(x6))/2), (1.29 + 0.27*sin(1.10*x5 + 0.82*x1)*cos(1.17*x6 + 0.25*x4 - 0.64))))]
#[forces(
    v4*v1/1.02 - p1*x2 - p1*0.37 - 1.66*tan(0.46*sin(x4))/2,
    1.64*v2 + v4*sqrt(2 + powi(v3, 2)),
    p1*x4 + p1*exp(0.20*x2) + v6*v6/(1.27 + 0.13*atan2(x5, 2 + cos(x6))/2) + v5*v6/(1.14 + 0.11*sin(0.95*x6 - 0.33*x2)),
    0.57*v5 + p1*x5,
    p1*v4*v5*sin(0.82*x2 - 0.88*x3 - 0.37) - p1*v6*v3*0.62*sin(x5)/(1.50 + cos(x6)) - 1.46*v6 - v6*sqrt(2 + powi(v4, 2)),
    0,
)]
#[constraint(held_x1: x1 - (0.94*powi(cos(0.44*x3 - 0.75), 3)) == 0)]
#[constraint(held_x4: x4 - (1.10*1/sqrt(1.50 + powi(x2, 2))) == 0)]
#[constraint(bound: 1.60*v2 - 0.21*v2*v3*sin(0.45*x4 - 0.38)*cos(0.90*x5) - 0.27*cos(1.20*x6 - 0.35*x6 + 0.46) == 0)]
#[output(place = bump(0.77*x4 - 0.65*x1), power = 1.58*powi(v6, 2) - v4*v5/(1.39 - 0.17*1/sqrt(1.50 + powi(x2, 2))) - 0.82*sin(p1*x2 - 0.76) - 0.76*v1/(1 + powi(x3, 2)), push = (if x5 <= 0.28 { atan2(x4, 2 + cos(x3))/2 } else { wave(0.62*x4 + 0.74*x1 - 0.12) })*dot(v1) + v2*ddot(x2), pull = 1.05*reaction(held_x4) - push, share = pull/(1.71 + powi(reaction(held_x4), 2)))]
pub struct Random107Whole {
    #[nominal(1.04)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + cos(0.75*x2)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - cos(0.75*x2)*(v1),
)]
#[inertia(matrix(
    [((1.22 + 0.19*ln(1.60 + 0.42*cos(x1))))*((1.22 + 0.19*ln(1.60 + 0.42*cos(x1)))), 0],
    [_, (1.12)*(1.12)],
))]
#[forces(
    p1*v2*v1*wave(0.61*x1 - 0.72*x1) - p1*exp(0.20*x1),
    p1*v2*v1*bump(1.10*x1),
)]
#[potential_energy(bump(1.14*x1 + 0.73*x2))]
#[constraint(held_x2: x2 - (1.11*wave(1.00*x1 + 0.41*x1)) == 0)]
pub struct Random138Whole {
    #[nominal(1.18)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = 1.29*dot(x1) - 0.38*bump(0.77*x2 - 0.29*x2)*dot(x2) + 0.36*atan2(x2, 2 + cos(x1))/2,
    v2 = 1.25*dot(x2) - 0.21*sin(0.69*x1 + 1.33)*dot(x1) + 0.50*(if t >= -0.06 { atan2(x2, 2 + cos(x2))/2 } else { sin(0.52*x1 - 0.76*x1) }),
)]
#[inertia(diag(1.08, (1.15 - 0.21*powi(cos(0.70*t), 3))))]
#[forces(
    p1*x2,
    0,
)]
#[constraint(held_x2: x2 - (0.40*sin((x1/1.25))/(1.50 + cos((x1/1.25)))) == 0)]
#[output(place = bump(0.57*x1 + 0.57), power = p1*v2*v2*0.91*sin(x2)/(1.50 + cos(x1)) + v1*sqrt(2 + powi(v1, 2)), push = bump(1.10*x1)*dot(v2) + v2*ddot(x2), pull = 1.34*reaction(held_x2) - push, share = pull/(1.66 + powi(reaction(held_x2), 2)))]
pub struct Random139Whole {
    #[nominal(0.74)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + cos(0.68*x1)*dot(x1),
    v3 = dot(x3) + sin(1.10*x1 + 0.22*x1 - 1.05)*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - cos(0.68*x1)*(v1),
    dot(x3) = v3 - sin(1.10*x1 + 0.22*x1 - 1.05)*(v2 - cos(0.68*x1)*(v1)),
)]
#[define(l11 = 1.20, l21 = 0.16*1/sqrt(1.50 + powi(x1, 2)), l22 = 1.31, l31 = 0.39*powi(cos(0.56*x2 - 0.23*x3), 3), l33 = (1.25 - 0.29*sin(1.00*x1 + 0.51)))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31],
    [_, l21*l21 + l22*l22, l21*l31],
    [_, _, l31*l31 + l33*l33],
))]
#[forces(
    0.78*v3 - tau*1.45,
    1.29*v1/(1 + powi(x3, 2)) + v1*v1/(1.39 + 0.15*1/sqrt(1.50 + powi(x2, 2))),
    1.60*(if x2 <= -0.46 { 0.43*sin(x1)/(1.50 + cos(x2)) } else { tan(0.66*sin(x2))/2 }),
)]
#[constraint(held_x2: x2 - (1.06*wave(0.61*x1 - 0.78*x1)) == 0)]
#[constraint(held_x3: x3 - (1.13*(if x1 >= -0.53 { sin(0.78*x1 - 0.99) } else { sin(1.17*x1) })) == 0)]
#[constraint(bound: powi(v1, 2) - 0.18*powi(v2, 2) - (2 - 0.18*1/sqrt(1.50 + powi(x1, 2))) == 0)]
pub struct Random151Whole {
    #[nominal(0.91)]
    pub p1: f64,
    #[nominal(1.47)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = v1 + 0.54*sin(0.43*x1 + 0.60*x1)*cos(1.01*x3 + 0.44*x1 + 1.07),
    dot(x2) = 1.15*v2 - 0.35*x1/(1 + powi(x1, 2))*v1 + 0.27*sin(1.12*x3 + 0.64*x3),
    dot(x3) = (1.03 + 0.14*cos(0.67*x1 + 1.41))*v3 + 0.26*exp(-powi(x1, 2)/2)*v2 + 0.28*(if x2 >= 0.19 { sin(p1*x2 + 0.61) } else { sin(0.95*x2 - 0.87*x2 - 1.09) }),
)]
#[kinetic_energy(1.23*powi(v1, 2)/2 + (1.21 - 0.30*tan(0.87*sin(x3))/2)*powi(v2, 2)/2 + 1.09*powi(v3, 2)/2 - 0.20*cos(1.17*x1)*v1 + 0.64*sin(0.76*x1)*cos(0.66*x1 + 0.40)*v3)]
#[forces(
    0,
    p1*exp(0.20*x1),
    p1*x2 - p1*x3 - v2*sqrt(2 + powi(v1, 2)) - p1*exp(0.20*x3),
)]
#[constraint(held_x2: x2 - (0.92*x3/(1 + powi(x3, 2))) == 0)]
#[constraint(held_x1: x1 - (1.19*0.51*sin(x3)/(1.50 + cos(x3))) == 0)]
pub struct Random160Whole {
    #[nominal(1.01)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = (1.17 - 0.28*atan2(t, 2 + cos(x3))/2)*v1 - 0.30*tan(0.64*sin(x3))/2*v2 + 0.53*bump(0.43*x3),
    dot(x2) = (1.30 + 0.24*wave(0.95*t - 0.70*x2))*v2 + 0.39*1/sqrt(1.50 + powi(x1, 2))*v1 - 0.29*powi(cos(0.40*x2 - 0.86*x1), 3),
    dot(x3) = (1.22 + 0.26*(if t >= -0.36 { ln(1.60 + 0.37*cos(x1)) } else { x2/(1 + powi(x2, 2)) }))*v3 + 0.24*cos(0.45*x2 + 0.24*x2 - 0.84)*v1 - 0.34*cos(0.54*t + 0.82*x2),
)]
#[kinetic_energy(powi(((1.14 - 0.25*(if t < 0.23 { powi(cos(0.54*x1 + 0.22), 3) } else { x2/(1 + powi(x2, 2)) })))*v1 + (0.39*0.61*sin(x1)/(1.50 + cos(x2)))*v2 + (0.29*wave(0.45*x3 + 0.64*t - 1.10))*v3, 2)/2 + powi(((1.10 - 0.20*tan(0.68*sin(t))/2))*v2 + (0.24*sin(p1*x1 + 0.29))*v3, 2)/2 + powi(((1.11 - 0.28*sin(0.85*t)))*v3, 2)/2 + 0.27*cos(0.72*x1 - 0.37*x1)*v2 - 0.38*tan(0.62*sin(t))/2)]
#[forces(
    p2*exp(0.20*x1),
    0.71*v3 + p1*v3*v3*powi(cos(0.51*x1 + 0.40*x1), 3),
    p2*exp(0.20*x1) + 0.94*powi(v3, 2),
)]
#[constraint(held_x3: x3 - (1.31*sin(p3*x2 - 0.10)) == 0)]
#[constraint(held_x1: x1 - (0.88*sin(p3*x2 + 0.53)) == 0)]
#[output(place = sin(1.07*x3), power = 1.57*v3 + 1.15*v1/(1 + powi(x2, 2)) + v2*v2/(1.39 + 0.13*wave(0.47*x3 + 0.63*x3)) + p2*0.57, push = (if x1 >= -0.04 { sin(0.98*x3 + 0.34*x2) } else { wave(0.66*t) })*dot(v1) + v2*ddot(x2), pull = (1.32 - 0.34*(if x3 < -0.27 { ln(1.60 + 0.55*cos(x2)) } else { sin(p1*x2 + 0.55) }))*reaction(held_x3) - push, share = pull/(1.98 + powi(reaction(held_x3), 2)))]
pub struct Random162Whole {
    #[nominal(1.39)]
    pub p1: f64,
    #[nominal(0.57)]
    pub p2: f64,
    #[nominal(0.74)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[size(n = 3)]
#[coordinates(x[n])]
#[define(s[i] = bump(0.89*x[i] + i/2 - 0.44) for i in 0..n)]
#[define(r[0] = s[0]/2, r[i] = (r[i - 1] + s[i])/2 for i in 1..n)]
#[inertia(diag((1.12 + k[i]*r[i]/4) for i in 0..n))]
#[forces(
    0.23*sum(0..n, |j| sin(x[i] - x[j])*dot(x[j])) - 0.29*k[i]*dot(x[i]) - product(0..=i, |j| s[j]) for i in 0..n,
)]
#[potential_energy(sum(1..n, |i| k[i]*powi(x[i] - x[i - 1], 2))/2 + 0.23*r[n - 1])]
#[constraint(held_x[i]: x[i] == 0.91*sin(x[n - 1] + i) for i in 0..2)]
pub struct Random175Whole {
    #[nominal(0.89)]
    pub p1: f64,
    #[nominal(1.04)]
    pub k: [f64; 3],
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(wave(s), derivatives = [wave_1, wave_2, wave_3])]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = (1.36 - 0.34*wave(1.16*x2 + 0.61*x3))*dot(x1) - 0.34*cos(1.15*x2 + 0.36*x1)*dot(x2),
    v2 = dot(x2) + 0.28*exp(-powi(x3, 2)/2)*dot(x3),
    v3 = dot(x3),
)]
#[inertia(matrix(
    [(1.23)*(1.23), 0, (1.23)*(0.27*cos(0.50*x3 - 0.62*x2))],
    [_, ((1.21 - 0.11*powi(cos(1.15*x2 - 0.49*x3), 3)))*((1.21 - 0.11*powi(cos(1.15*x2 - 0.49*x3), 3))), ((1.21 - 0.11*powi(cos(1.15*x2 - 0.49*x3), 3)))*(0.19*sin(p1*t - 0.79))],
    [_, _, (0.27*cos(0.50*x3 - 0.62*x2))*(0.27*cos(0.50*x3 - 0.62*x2)) + (0.19*sin(p1*t - 0.79))*(0.19*sin(p1*t - 0.79)) + (1.30)*(1.30)],
))]
#[forces(
    1.15*powi(v3, 2) - v2*v3/(1.13 - 0.23*cos(0.57*x1 + 0.58*x2 + 0.95)),
    0.59*(if t > 0.27 { tan(0.99*sin(x1))/2 } else { sin(0.45*x2 - 0.74) }) + 1.00*sin(1.06*x1 - 1.11)*cos(0.69*x2),
    0.94*sin(p1*x1 + 0.76) - p2*exp(0.20*x1) - v2*v3/(1.01 - 0.13*sin(1.00*x1 - 0.63*x2 - 0.15)) - p1*v2*v1*cos(0.92*t + 0.49*x3),
)]
#[potential_energy(exp(-powi(x2, 2)/2))]
#[constraint(held_x3: x3 - (wave(1.07*(x1/1.25) - 0.63*(x1/1.25))) == 0)]
pub struct Random183Whole {
    #[nominal(0.96)]
    pub p1: f64,
    #[nominal(0.97)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[function(bump(s), derivatives = [bump_1, bump_2, bump_3])]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + exp(-powi(t, 2)/2)*dot(x1),
    v3 = dot(x3) + bump(1.11*x4)*dot(x2),
    v4 = dot(x4) + powi(cos(1.04*x1), 3)*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - exp(-powi(t, 2)/2)*(v1),
    dot(x3) = v3 - bump(1.11*x4)*(v2 - exp(-powi(t, 2)/2)*(v1)),
    dot(x4) = v4 - powi(cos(1.04*x1), 3)*(v2 - exp(-powi(t, 2)/2)*(v1)),
)]
#[kinetic_energy((1.11 + 0.23*x1/(1 + powi(x1, 2)))*powi(v1, 2)/2 + 1.26*powi(v2, 2)/2 + (1.07 + 0.20*x2/(1 + powi(x2, 2)))*powi(v3, 2)/2 + (1.13 + 0.26*powi(cos(1.00*x4 - 0.22*x2), 3))*powi(v4, 2)/2 - 0.34*ln(1.60 + 0.85*cos(x3))*v3 + 0.65*1/sqrt(1.50 + powi(x2, 2)))]
#[forces(
    p1*0.91 + v1*sqrt(2 + powi(v4, 2)) + 0.68*ln(1.60 + 0.44*cos(t)) + v3*v1/(1.25 + 0.21*ln(1.60 + 0.47*cos(x3))),
    0.80*exp(-powi(x4, 2)/2) - p1*v1*v4*sin(0.60*x1 + 0.42*x1),
    p3*v4*v2*cos(0.50*t) + 1.75*v2 + 0.57*v2/(1 + powi(x4, 2)),
    1.38*v2/(1 + powi(x1, 2)) - 1.36*v1 - p2*v2*v1*(if x4 > -0.29 { sin(0.45*t) } else { 1/sqrt(1.50 + powi(x4, 2)) }) - p1*exp(0.20*x2),
)]
#[constraint(held_x3: x3 - (1.18*1/sqrt(1.50 + powi(x4, 2))) == 0)]
#[constraint(rolling: (1.50 + 0.24*exp(-powi(x1, 2)/2))*dot(x2) + 0.13*sin(1.00*x2)*dot(x4) - 0.20*sin(0.51*x2)*dot(x1) - 0.44*1/sqrt(1.50 + powi(x4, 2)) == 0)]
pub struct Random184Whole {
    #[nominal(1.43)]
    pub p1: f64,
    #[nominal(0.65)]
    pub p2: f64,
    #[nominal(0.53)]
    pub p3: f64,
}

macro_rules! every_random_model {
    ($then:ident) => {
        $then! {
            Random0(p1, p2)
            Random1(p1)
            Random2(p1, p2)
            Random3(p1, p2)
            Random4(p1)
            Random5(p1)
            Random6(p1, p2)
            Random7(p1)
            Random8(p1)
            Random9(p1, p2, p3)
            Random10(p1, p2)
            Random11(p1, p2)
            Random12(p1)
            Random13(p1, p2, p3)
            Random14(p1, p2)
            Random15(p1, p2)
            Random16(p1, p2, p3)
            Random17(p1, p2, p3)
            Random18(p1, p2, p3)
            Random19(p1)
            Random20(p1, p2, p3)
            Random21(p1, k)
            Random22(p1)
            Random23(p1, p2)
            Random24(p1, p2)
            Random25(p1, p2, p3)
            Random26(p1, p2)
            Random27(p1)
            Random28(p1)
            Random29(p1, p2, p3)
            Random30(p1)
            Random31(p1, p2)
            Random32(p1)
            Random33(p1, p2)
            Random34(p1, p2, p3)
            Random35(p1)
            Random36(p1)
            Random37(p1, p2, p3)
            Random38(p1, p2, p3)
            Random39(p1, p2)
            Random40(p1)
            Random41(p1, p2, p3)
            Random42(p1, p2, p3)
            Random43(p1, k)
            Random44(p1, p2, p3)
            Random45(p1)
            Random46(p1)
            Random47(p1, p2, p3)
            Random48(p1)
            Random49(p1)
            Random50(p1, p2)
            Random51(p1)
            Random52(p1)
            Random53(p1)
            Random54(p1)
            Random55(p1, p2)
            Random56(p1)
            Random57(p1, p2)
            Random58(p1, p2, p3)
            Random59(p1)
            Random60(p1, p2)
            Random61(p1, p2)
            Random62(p1, p2)
            Random63(p1)
            Random64(p1, p2)
            Random65(p1, p2, p3, k)
            Random66(p1, p2, p3)
            Random67(p1)
            Random68(p1, p2)
            Random69(p1, p2)
            Random70(p1, p2, p3)
            Random71(p1)
            Random72(p1, p2, p3)
            Random73(p1, p2, p3)
            Random74(p1, p2)
            Random75(p1, p2, p3)
            Random76(p1, p2)
            Random77(p1, p2)
            Random78(p1, p2, p3)
            Random79(p1, p2, p3)
            Random80(p1, p2, p3)
            Random81(p1, p2, p3)
            Random82(p1, p2)
            Random83(p1)
            Random84(p1, p2)
            Random85(p1)
            Random86(p1, p2, p3)
            Random87(p1, p2, p3, k)
            Random88(p1, p2, p3)
            Random89(p1, p2)
            Random90(p1, p2)
            Random91(p1)
            Random92(p1)
            Random93(p1, p2, p3)
            Random94(p1, p2)
            Random95(p1, p2)
            Random96(p1, p2, p3)
            Random97(p1)
            Random98(p1, p2)
            Random99(p1, p2)
            Random100(p1, p2, p3)
            Random101(p1)
            Random102(p1, p2, p3)
            Random103(p1)
            Random104(p1)
            Random105(p1, p2, p3)
            Random106(p1, p2)
            Random107(p1)
            Random108(p1, p2)
            Random109(p1, p2, p3, k)
            Random110(p1, p2)
            Random111(p1, p2)
            Random112(p1, p2)
            Random113(p1)
            Random114(p1, p2)
            Random115(p1, p2)
            Random116(p1)
            Random117(p1)
            Random118(p1, p2)
            Random119(p1, p2, p3)
            Random120(p1, p2)
            Random121(p1, p2)
            Random122(p1, p2, p3)
            Random123(p1, p2, p3)
            Random124(p1)
            Random125(p1, p2, p3)
            Random126(p1, p2, p3)
            Random127(p1, p2)
            Random128(p1, p2, p3)
            Random129(p1, p2)
            Random130(p1)
            Random131(p1, k)
            Random132(p1)
            Random133(p1)
            Random134(p1)
            Random135(p1, p2, p3)
            Random136(p1, p2, p3)
            Random137(p1, p2, p3)
            Random138(p1)
            Random139(p1)
            Random140(p1, p2, p3)
            Random141(p1, p2)
            Random142(p1, p2)
            Random143(p1, p2, p3)
            Random144(p1, p2)
            Random145(p1, p2)
            Random146(p1, p2)
            Random147(p1)
            Random148(p1, p2)
            Random149(p1)
            Random150(p1, p2, p3)
            Random151(p1, p2)
            Random152(p1, p2)
            Random153(p1, p2, k)
            Random154(p1)
            Random155(p1, p2)
            Random156(p1, p2, p3)
            Random157(p1, p2, p3)
            Random158(p1)
            Random159(p1, p2)
            Random160(p1)
            Random161(p1)
            Random162(p1, p2, p3)
            Random163(p1)
            Random164(p1, p2)
            Random165(p1)
            Random166(p1, p2, p3)
            Random167(p1, p2, p3)
            Random168(p1, p2, p3)
            Random169(p1)
            Random170(p1, p2)
            Random171(p1, p2, p3)
            Random172(p1)
            Random173(p1, p2)
            Random174(p1, p2)
            Random175(p1, k)
            Random176(p1)
            Random177(p1, p2, p3)
            Random178(p1, p2, p3)
            Random179(p1)
            Random180(p1)
            Random181(p1, p2, p3)
            Random182(p1)
            Random183(p1, p2)
            Random184(p1, p2, p3)
            Random185(p1, p2, p3)
            Random186(p1, p2)
            Random187(p1)
            Random188(p1, p2)
            Random189(p1, p2, p3)
            Random190(p1, p2)
            Random191(p1, p2, p3)
            Random192(p1)
            Random193(p1, p2, p3)
            Random194(p1, p2, p3)
            Random195(p1, p2)
            Random196(p1, p2, p3)
            Random197(p1, p2, p3, k)
            Random198(p1, p2)
            Random199(p1)
            Random6Whole(p1, p2)
            Random19Whole(p1)
            Random28Whole(p1)
            Random29Whole(p1, p2, p3)
            Random30Whole(p1)
            Random51Whole(p1)
            Random63Whole(p1)
            Random73Whole(p1, p2, p3)
            Random74Whole(p1, p2)
            Random94Whole(p1, p2)
            Random95Whole(p1, p2)
            Random107Whole(p1)
            Random138Whole(p1)
            Random139Whole(p1)
            Random151Whole(p1, p2)
            Random160Whole(p1)
            Random162Whole(p1, p2, p3)
            Random175Whole(p1, k)
            Random183Whole(p1, p2)
            Random184Whole(p1, p2, p3)
        }
    };
}
pub(crate) use every_random_model;

macro_rules! every_random_pair {
    ($then:ident) => {
        $then! {
            Random6 Random6Whole(p1, p2)
            Random19 Random19Whole(p1)
            Random28 Random28Whole(p1)
            Random29 Random29Whole(p1, p2, p3)
            Random30 Random30Whole(p1)
            Random51 Random51Whole(p1)
            Random63 Random63Whole(p1)
            Random73 Random73Whole(p1, p2, p3)
            Random74 Random74Whole(p1, p2)
            Random94 Random94Whole(p1, p2)
            Random95 Random95Whole(p1, p2)
            Random107 Random107Whole(p1)
            Random138 Random138Whole(p1)
            Random139 Random139Whole(p1)
            Random151 Random151Whole(p1, p2)
            Random160 Random160Whole(p1)
            Random162 Random162Whole(p1, p2, p3)
            Random175 Random175Whole(p1, k)
            Random183 Random183Whole(p1, p2)
            Random184 Random184Whole(p1, p2, p3)
        }
    };
}
pub(crate) use every_random_pair;
