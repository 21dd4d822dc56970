// Generated from tests/random: random models, and a macro that names them all.

use holonomy::ConstrainedSystem;

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[inertia(diag((1.22 + 0.30*0.68*sin(x1)/(1.50 + cos(x1)))))]
#[forces(
    p2*1.89 - dot(x1)*sqrt(2 + powi(dot(x1), 2)),
)]
pub struct Random0 {
    #[nominal(0.52)]
    pub p1: f64,
    #[nominal(1.42)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag((1.30 - 0.11*ln(1.60 + 0.87*cos(x2))), (1.03 + 0.25*powi(cos(0.66*x2), 3))))]
#[forces(
    0.65*1/sqrt(1.50 + powi(x2, 2)),
    0.65*ln(1.60 + 0.45*cos(x1)) - 1.90*tan(0.58*sin(x2))/2,
)]
#[potential_energy(sin(0.93*x1 + 0.35*x1)*cos(0.82*x2 + 0.42*x2 - 0.84))]
#[constraint(row1: (1.50 + 0.16*tan(0.90*sin(x1))/2)*dot(x2) - 0.12*sin(1.02*x2)*cos(0.78*x2)*dot(x1) == 0)]
#[independent(dot(x1))]
pub struct Random1 {
    #[nominal(1.18)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    dot(x1) = 1.26*v1,
)]
#[define(l11 = 1.10)]
#[inertia(matrix(
    [l11*l11],
))]
#[forces(
    0,
)]
#[potential_energy(exp(-powi(x1, 2)/2))]
#[constraint(row1: 1.31*x1 + 0.13*sin(x1) + 0.30*sin(1.15*t) - 0.40 == 0)]
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
    dot(x1) = v1,
)]
#[inertia(matrix(
    [(1.17)*(1.17)],
))]
#[forces(
    v1*v1/(1.21 - 0.12*tan(0.98*sin(t))/2) - 1.11*powi(v1, 2) - p2*v1*v1*t/(1 + powi(t, 2)) - 1.81*v1/(1 + powi(x1, 2)),
)]
#[constraint(row1: 1.81*v1 == 0)]
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
    v1 = dot(x1) - 0.39*sin(p1*t + 0.58),
)]
#[inertia(diag((1.39 - 0.17*sin(1.06*t + 0.22*t)*cos(0.87*x1 - 1.13))))]
#[forces(
    v1*v1/1.28,
)]
#[constraint(height: 1.96*x1 + 0.30*sin(0.60*t) - 0.71 == 0)]
#[constraint(height_rate: (1.12 - 0.35*ln(1.60 + 0.53*cos(x1)))*(1.96*dot(x1) + 0.30*0.60*cos(0.60*t)) == 0)]
pub struct Random4 {
    #[nominal(1.47)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inputs(tau)]
#[define(l11 = (1.02 + 0.20*t/(1 + powi(t, 2))), l21 = 0.18*sin(p1*t - 0.25), l22 = (1.21 + 0.34*sin(0.73*x1 + 0.22*t)))]
#[inertia(matrix(
    [l11*l11, l11*l21],
    [_, l21*l21 + l22*l22],
))]
#[forces(
    dot(x1)*dot(x2)/1.01 + p1*x1 + 1.12*dot(x2),
    p1*exp(0.20*t),
)]
#[constraint(height: 1.28*x1 + 0.30*sin(1.02*t) + 0.24 == 0)]
#[constraint(first: (1.50 + 0.24*powi(cos(1.06*t), 3))*dot(x2) - 0.32*sin(0.54*x2 - 0.82*x1)*cos(0.57*x2)*dot(x1) == 0)]
#[constraint(second: 1.28*dot(x1) + 0.30*1.02*cos(1.02*t) - 0.50*cos(0.63*t - 0.67*t)*((1.50 + 0.24*powi(cos(1.06*t), 3))*dot(x2) - 0.32*sin(0.54*x2 - 0.82*x1)*cos(0.57*x2)*dot(x1)) == 0)]
pub struct Random5 {
    #[nominal(1.25)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = (1.04 - 0.16*ln(1.60 + 0.57*cos(x2)))*dot(x1) + 0.30*exp(-powi(x2, 2)/2)*dot(x2) + 0.53*0.60*sin(x1)/(1.50 + cos(x2)),
    v2 = dot(x2) + 0.25*tan(0.30*sin(x2))/2*dot(x1) - 0.33*sin(0.55*x1 - 0.91)*cos(0.67*x2 - 0.64*x1 + 0.82),
)]
#[inertia(matrix(
    [((1.12 - 0.14*atan2(x1, 2 + cos(x1))/2))*((1.12 - 0.14*atan2(x1, 2 + cos(x1))/2)), ((1.12 - 0.14*atan2(x1, 2 + cos(x1))/2))*(0.32*tan(0.77*sin(x1))/2)],
    [_, (0.32*tan(0.77*sin(x1))/2)*(0.32*tan(0.77*sin(x1))/2) + ((1.35 - 0.25*powi(cos(0.70*x2 - 0.44*x2), 3)))*((1.35 - 0.25*powi(cos(0.70*x2 - 0.44*x2), 3)))],
))]
#[forces(
    0.79*powi(v1, 2) - 1.06*v1,
    p1*x2,
)]
#[potential_energy(sin(1.02*x2 - 0.43)*cos(1.02*x2))]
#[configuration(x1 = 0.74*cos(0.58*x2))]
pub struct Random6 {
    #[nominal(1.31)]
    pub p1: f64,
    #[nominal(0.90)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(matrix(
    [(1.37)*(1.37), 0],
    [_, ((1.32 - 0.28*x2/(1 + powi(x2, 2))))*((1.32 - 0.28*x2/(1 + powi(x2, 2))))],
))]
#[forces(
    0,
    1.97*dot(x1) + dot(x1)*dot(x1)/(1.13 + 0.30*ln(1.60 + 0.32*cos(x1))) + dot(x2)*dot(x1)/1.39 + 1.84*dot(x2),
)]
#[potential_energy(atan2(x2, 2 + cos(x1))/2)]
#[configuration(of(q1), x1 = 1.25*q1, x2 = ln(1.60 + 0.77*cos(q1)))]
#[constraint(held_x2: x2 - (ln(1.60 + 0.77*cos((x1/1.25)))) == 0)]
pub struct Random7 {
    #[nominal(1.36)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + 0.34*sin(x1)/(1.50 + cos(x1))*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - 0.34*sin(x1)/(1.50 + cos(x1))*(v1),
)]
#[define(l11 = 1.22, l21 = 0.18*0.72*sin(x2)/(1.50 + cos(x1)), l22 = (1.33 + 0.17*sin(1.08*x1 + 0.78*x2 - 1.30)))]
#[inertia(matrix(
    [l11*l11, l11*l21],
    [_, l21*l21 + l22*l22],
))]
#[forces(
    0,
    0,
)]
#[configuration(x1 = 0.54*cos(0.81*t + 1.45))]
pub struct Random8 {
    #[nominal(0.54)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + ln(1.60 + 0.77*cos(x1))*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - ln(1.60 + 0.77*cos(x1))*(v1),
)]
#[inertia(diag(1.19, (1.18 + 0.34*sin(0.52*t - 0.66)*cos(1.08*x1 - 0.42*x2))))]
#[forces(
    0.66*cos(0.54*t),
    p1*0.50 + 0.42*v1/(1 + powi(x1, 2)),
)]
#[potential_energy(sin(p2*x1 - 0.12))]
#[constraint(row1: v2 + 0.41*sin(p1*x2 - 0.20)*v1 + 0.40*1/sqrt(1.50 + powi(x1, 2)) == 0)]
#[complement(
    w1 = [(1.19 - 0.21*cos(0.72*t - 0.58*x1)), -(1.19 - 0.21*cos(0.72*t - 0.58*x1))*(0.41*sin(p1*x2 - 0.20))],
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
    v2 = dot(x2) + 1/sqrt(1.50 + powi(x1, 2))*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - 1/sqrt(1.50 + powi(x1, 2))*(v1),
)]
#[define(l11 = (1.29 + 0.24*powi(cos(1.09*x1 + 0.25*x1), 3)), l21 = 0.32*sin(0.73*x2), l22 = (1.37 + 0.28*powi(cos(0.49*x1), 3)))]
#[inertia(matrix(
    [l11*l11, l11*l21],
    [_, l21*l21 + l22*l22],
))]
#[forces(
    v2*v2/(1.14 - 0.28*0.73*sin(x2)/(1.50 + cos(x1))) + 1.29*v1/(1 + powi(x2, 2)),
    p2*x1 - 1.43*v1,
)]
#[potential_energy(exp(-powi(x1, 2)/2))]
#[constraint(row1: 1.16*v1 + 0.33*sin(p1*x1 + 0.55)*v2 == 0)]
pub struct Random10 {
    #[nominal(1.09)]
    pub p1: f64,
    #[nominal(0.59)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag((1.17 - 0.31*x2/(1 + powi(x2, 2))), (1.14 + 0.30*cos(0.92*x1 + 0.45*x2))))]
#[forces(
    1.16*powi(dot(x2), 2),
    0,
)]
#[potential_energy(tan(0.89*sin(x1))/2)]
#[constraint(row1: 1.66*x1 - 0.14 == 0)]
#[constraint(row2: 1.52*x2 + 0.23*x1*x1 + 0.41 == 0)]
pub struct Random11 {
    #[nominal(1.33)]
    pub p1: f64,
    #[nominal(1.22)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag(1.21, (1.03 + 0.31*sin(0.41*x2))))]
#[forces(
    1.42*dot(x2)/(1 + powi(x1, 2)) + p1*dot(x2)*dot(x2)*exp(-powi(x1, 2)/2) + dot(x1)*sqrt(2 + powi(dot(x2), 2)),
    p1*dot(x1)*dot(x2)*1/sqrt(1.50 + powi(x1, 2)) + p1*0.94 + dot(x2)*dot(x2)/(1.21 + 0.16*cos(0.93*x2)) + p1*exp(0.20*x2),
)]
pub struct Random12 {
    #[nominal(0.51)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + sin(0.91*x2 + 0.24*x1 + 0.22)*cos(0.72*x2 - 0.75*x2 + 1.49)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - sin(0.91*x2 + 0.24*x1 + 0.22)*cos(0.72*x2 - 0.75*x2 + 1.49)*(v1),
)]
#[define(l11 = (1.21 + 0.33*ln(1.60 + 0.92*cos(x1))), l21 = 0.37*sin(0.78*x1), l22 = 1.21)]
#[inertia(matrix(
    [l11*l11, l11*l21],
    [_, l21*l21 + l22*l22],
))]
#[forces(
    v2*sqrt(2 + powi(v1, 2)) + p2*exp(0.20*t),
    1.31*powi(v2, 2) - v1*sqrt(2 + powi(v2, 2)) - p1*x2,
)]
#[constraint(row1: v2 + 0.11*atan2(x1, 2 + cos(t))/2*v1 + 0.21*cos(0.66*t - 0.55*t + 0.87) == 0)]
#[independent(v1)]
pub struct Random13 {
    #[nominal(1.23)]
    pub p1: f64,
    #[nominal(1.19)]
    pub p2: f64,
    #[nominal(1.48)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.33 - 0.13*sin(0.68*x2)*cos(1.11*x2 - 0.23*x2)), 1.13, (1.19 - 0.15*exp(-powi(x3, 2)/2))))]
#[forces(
    0.99*dot(x1)/(1 + powi(x1, 2)),
    p2*dot(x2)*dot(x2)*sin(0.61*x1 + 0.83*x1 - 1.18) + dot(x2)*dot(x3)/(1.37 + 0.29*sin(0.42*x2 + 0.83*x2 - 0.34)*cos(0.55*x2 - 1.47)),
    0,
)]
#[potential_energy(1/sqrt(1.50 + powi(x1, 2)))]
#[constraint(row1: 1.24*x3 + 0.11*powi(x2, 2)/2 + 0.68 == 0)]
#[independent(dot(x1), dot(x2))]
pub struct Random14 {
    #[nominal(1.20)]
    pub p1: f64,
    #[nominal(0.61)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.14 - 0.31*sin(0.88*t + 0.47*x2 + 0.39)), (1.06 - 0.12*sin(p1*x1 + 0.57)), (1.37 - 0.25*0.50*sin(x3)/(1.50 + cos(x1)))))]
#[forces(
    1.90*powi(dot(x2), 2) + dot(x2)*sqrt(2 + powi(dot(x2), 2)),
    p2*dot(x3)*dot(x3)*cos(1.01*x2 - 0.47*x1 - 0.61) + 0.60*exp(-powi(x3, 2)/2),
    1.46*dot(x1)/(1 + powi(x1, 2)),
)]
#[constraint(row1: 1.40*x3 + 0.29*sin(x3) + 0.26*powi(x2, 2)/2 + 0.30*sin(1.50*t) + 0.44 == 0)]
#[constraint(row2: dot(x1) - 0.14*sin(0.94*x2)*dot(x2) + 0.16*sin(0.44*x3 + 0.72*x2 - 1.29)*cos(0.93*x3 - 0.75*x2)*dot(x3) == 0)]
pub struct Random15 {
    #[nominal(0.56)]
    pub p1: f64,
    #[nominal(0.77)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = 1.17*v1,
    dot(x2) = 1.11*v2 + 0.18*0.35*sin(x2)/(1.50 + cos(x2))*v1,
)]
#[inertia(matrix(
    [(1.32)*(1.32), (1.32)*(0.18*cos(0.46*x1))],
    [_, (0.18*cos(0.46*x1))*(0.18*cos(0.46*x1)) + ((1.08 + 0.33*atan2(x1, 2 + cos(x2))/2))*((1.08 + 0.33*atan2(x1, 2 + cos(x2))/2))],
))]
#[forces(
    v1*sqrt(2 + powi(v1, 2)) - 0.77*powi(v1, 2),
    p1*v1*v1*cos(0.95*x1 - 0.66*x1) + v2*v2/(1.27 + 0.25*cos(1.12*x1 + 0.62)) + p1*v2*v1*atan2(x2, 2 + cos(x2))/2,
)]
#[potential_energy(sin(p1*x1 + 0.90))]
#[constraint(height: 1.96*x1 + 0.19*sin(x1) + 0.24*sin(x2) - 0.64 == 0)]
#[constraint(height_rate: 1.96*dot(x1) + 0.19*cos(x1)*dot(x1) + 0.24*cos(x2)*dot(x2) == 0)]
pub struct Random16 {
    #[nominal(1.42)]
    pub p1: f64,
    #[nominal(0.95)]
    pub p2: f64,
    #[nominal(0.54)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inputs(tau)]
#[inertia(diag((1.09 - 0.15*sin(1.00*x1 - 0.95)*cos(0.92*x2 + 0.65*x1 - 1.42)), (1.21 + 0.14*sin(p1*x1 + 0.48))))]
#[forces(
    1.46*dot(x2)/(1 + powi(t, 2)) + p1*x1 + 1.02*dot(x1) + 2.00*dot(x1)/(1 + powi(x1, 2)),
    dot(x1)*dot(x1)/(1.19 + 0.16*tan(0.86*sin(x2))/2) - 0.96*powi(dot(x2), 2) - 0.50*0.81*sin(x2)/(1.50 + cos(t)),
)]
#[potential_energy(x1/(1 + powi(x1, 2)))]
#[constraint(height: 1.50*x1 + 0.30*sin(1.01*t) - 0.10 == 0)]
#[constraint(first: dot(x2) + 0.15*sin(p1*t + 0.88)*dot(x1) == 0)]
#[constraint(second: 1.50*dot(x1) + 0.30*1.01*cos(1.01*t) - 0.50*cos(0.41*x1 + 0.94)*(dot(x2) + 0.15*sin(p1*t + 0.88)*dot(x1)) == 0)]
pub struct Random17 {
    #[nominal(1.15)]
    pub p1: f64,
    #[nominal(1.15)]
    pub p2: f64,
    #[nominal(1.17)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1) - 0.13*tan(0.87*sin(x2))/2*dot(x2),
    v2 = dot(x2) + 0.18*sin(0.46*x2)*dot(x1),
    v3 = 1.20*dot(x3) - 0.29*sin(1.20*x3 - 1.14)*dot(x1),
)]
#[define(l11 = (1.38 - 0.26*tan(0.36*sin(x1))/2), l22 = 1.16, l31 = 0.39*sin(0.82*x1 + 0.37*x1 + 0.97), l32 = 0.25*0.47*sin(x1)/(1.50 + cos(x2)), l33 = 1.32)]
#[inertia(matrix(
    [l11*l11, 0, l11*l31],
    [_, l22*l22, l22*l32],
    [_, _, l31*l31 + l32*l32 + l33*l33],
))]
#[forces(
    p1*x3 - v1*sqrt(2 + powi(v2, 2)) - 1.95*v3 - 0.36*powi(v3, 2),
    1.96*v1/(1 + powi(x2, 2)) + p2*x1 + v1*v2/(1.22 + 0.18*sin(0.77*x2)) + p2*x1,
    tau*1.76 - p3*x3 - 1.92*v1 - v1*v1/1.00,
)]
#[configuration(x2 = 1.28*atan2(x3, 2 + cos(x3))/2, x1 = 0.96*powi(cos(1.18*x3 - 0.38*x3 + 0.25), 3))]
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
    v2 = dot(x2) + atan2(x1, 2 + cos(x2))/2*dot(x1),
    v3 = dot(x3) + powi(cos(0.68*x2 + 0.83*x1 + 1.39), 3)*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - atan2(x1, 2 + cos(x2))/2*(v1),
    dot(x3) = v3 - powi(cos(0.68*x2 + 0.83*x1 + 1.39), 3)*(v2 - atan2(x1, 2 + cos(x2))/2*(v1)),
)]
#[inertia(diag(1.10, (1.25 + 0.29*ln(1.60 + 0.62*cos(t))), 1.09))]
#[forces(
    1.49*sin(0.99*t - 0.85*x1) + 0.81*powi(v1, 2) + v3*v2/1.17 + 1.38*v3,
    1.40*powi(v2, 2) - p1*t - p1*exp(0.20*x2) - p1*v3*v1*sin(p1*x3 - 0.33),
    p1*exp(0.20*x1) - p1*exp(0.20*x2),
)]
#[configuration(of(q1, q2), x1 = 1.25*q1, x2 = 1.25*q2, x3 = 1/sqrt(1.50 + powi(q1, 2)))]
#[constraint(held_x3: x3 - (1/sqrt(1.50 + powi((x1/1.25), 2))) == 0)]
pub struct Random19 {
    #[nominal(1.28)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(diag(1.08, 1.33, (1.01 - 0.26*tan(0.36*sin(x3))/2)))]
#[forces(
    p1*exp(0.20*x3),
    p1*dot(x1)*dot(x3)*0.97*sin(x3)/(1.50 + cos(x1)) + p2*dot(x3)*dot(x3)*sin(p2*x1 - 0.91) + p3*exp(0.20*x1),
    p1*dot(x2)*dot(x2)*1/sqrt(1.50 + powi(x3, 2)) - p1*exp(0.20*x3),
)]
#[configuration(x2 = 0.84*sin(p3*x1 - 0.40), x3 = 1.06*atan2(x1, 2 + cos(x1))/2)]
pub struct Random20 {
    #[nominal(1.44)]
    pub p1: f64,
    #[nominal(1.45)]
    pub p2: f64,
    #[nominal(0.71)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + cos(0.46*x2)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - cos(0.46*x2)*(v1),
)]
#[inertia(diag((1.24 + 0.31*1/sqrt(1.50 + powi(x2, 2))), (1.01 - 0.26*1/sqrt(1.50 + powi(x1, 2)))))]
#[forces(
    0.38*v1/(1 + powi(x2, 2)) + 0.69*v2 + p1*x1 + 1.46*powi(cos(1.11*t), 3),
    p1*x1 + p1*exp(0.20*x2),
)]
#[potential_energy(1/sqrt(1.50 + powi(x2, 2)))]
#[constraint(row1: v1 + 0.73*exp(-powi(t, 2)/2)*v2 == 0)]
#[complement(
    w1 = [-(1.18 - 0.25*sin(p1*x2 + 0.59))*(0.73*exp(-powi(t, 2)/2)), (1.18 - 0.25*sin(p1*x2 + 0.59))],
)]
pub struct Random21 {
    #[nominal(1.27)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag((1.04 + 0.11*cos(0.57*x1 - 0.21*x2 + 0.14)), (1.22 + 0.26*0.35*sin(x1)/(1.50 + cos(x2)))))]
#[forces(
    0.60*sin(p1*x1 - 0.99),
    0,
)]
#[constraint(row1: dot(x1) - 0.27*sin(1.13*x2)*cos(0.69*x1 - 0.83*x1)*dot(x2) == 0)]
pub struct Random22 {
    #[nominal(0.85)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag((1.13 + 0.20*sin(0.69*x1)), (1.21 + 0.33*tan(0.81*sin(x2))/2)))]
#[forces(
    p2*x2 + 1.81*powi(dot(x1), 2),
    dot(x2)*dot(x2)/(1.02 + 0.29*ln(1.60 + 1.00*cos(x2))) + dot(x1)*sqrt(2 + powi(dot(x1), 2)),
)]
#[potential_energy(1/sqrt(1.50 + powi(x1, 2)))]
#[constraint(row1: 1.45*x1 + 0.29 == 0)]
#[constraint(row2: 1.77*dot(x2) - 0.15*tan(0.60*sin(x1))/2*dot(x1) - 0.38*powi(cos(0.87*x1), 3) == 0)]
pub struct Random23 {
    #[nominal(0.74)]
    pub p1: f64,
    #[nominal(0.63)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + sin(0.56*x1)*cos(0.65*x2)*dot(x1),
    v3 = dot(x3) + sin(1.00*x2 - 0.76*x1 - 1.29)*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - sin(0.56*x1)*cos(0.65*x2)*(v1),
    dot(x3) = v3 - sin(1.00*x2 - 0.76*x1 - 1.29)*(v2 - sin(0.56*x1)*cos(0.65*x2)*(v1)),
)]
#[inertia(diag((1.31 - 0.20*atan2(x2, 2 + cos(x2))/2), (1.40 + 0.25*sin(1.02*x2)*cos(0.98*x3 + 0.74*x3)), (1.22 - 0.16*0.31*sin(x3)/(1.50 + cos(x2)))))]
#[forces(
    0,
    1.77*v2/(1 + powi(x3, 2)) - 1.55*powi(v2, 2) - p2*0.71 - 1.19*0.44*sin(x3)/(1.50 + cos(x1)),
    0.92*powi(v1, 2) + p1*x1 + v1*v1/1.23,
)]
pub struct Random24 {
    #[nominal(1.14)]
    pub p1: f64,
    #[nominal(1.09)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = v1 + 0.35*x3/(1 + powi(x3, 2))*v3,
    dot(x2) = 1.36*v2 + 0.14*1/sqrt(1.50 + powi(x1, 2))*v1,
    dot(x3) = (1.15 - 0.27*ln(1.60 + 0.40*cos(x1)))*v3,
)]
#[inertia(diag(1.22, (1.16 - 0.34*0.56*sin(x1)/(1.50 + cos(x3))), (1.29 + 0.19*x3/(1 + powi(x3, 2)))))]
#[forces(
    p1*v2*v1*tan(0.58*sin(x2))/2 - p3*v3*v2*cos(0.95*x2 + 0.50*x2 - 0.96) - 0.56*v1 - p1*v3*v2*sin(0.90*x1),
    v1*v3/(1.31 + 0.32*sin(1.04*x2 - 0.33*x2)) - 1.83*v3/(1 + powi(x1, 2)) - tau*0.93,
    tau*0.92 + 1.73*powi(v3, 2) + v3*sqrt(2 + powi(v2, 2)),
)]
#[constraint(row1: 1.93*v3 + 0.15*tan(0.35*sin(x3))/2*v2 - 0.40*x3/(1 + powi(x3, 2)) == 0)]
pub struct Random25 {
    #[nominal(1.12)]
    pub p1: f64,
    #[nominal(0.58)]
    pub p2: f64,
    #[nominal(1.41)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = (1.22 - 0.19*x4/(1 + powi(x4, 2)))*dot(x1) - 0.34*ln(1.60 + 0.91*cos(x2))*dot(x3),
    v2 = dot(x2) - 0.16*1/sqrt(1.50 + powi(x3, 2))*dot(x3),
    v3 = (1.37 + 0.11*ln(1.60 + 0.55*cos(x4)))*dot(x3),
    v4 = dot(x4),
)]
#[define(l11 = (1.27 - 0.22*x4/(1 + powi(x4, 2))), l22 = 1.11, l31 = 0.13*sin(0.42*x3 - 0.89*x2), l32 = 0.21*0.49*sin(x2)/(1.50 + cos(x2)), l33 = 1.08, l41 = 0.25*sin(0.89*x4)*cos(0.70*x1 - 0.74*x4 + 0.69), l42 = 0.21*sin(p1*x1 + 0.78), l43 = 0.18*sin(1.08*x1 + 0.41*x2)*cos(0.91*x1), l44 = (1.15 - 0.22*1/sqrt(1.50 + powi(x3, 2))))]
#[inertia(matrix(
    [l11*l11, 0, l11*l31, l11*l41],
    [_, l22*l22, l22*l32, l22*l42],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l32*l42 + l33*l43],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44],
))]
#[forces(
    p2*exp(0.20*x1) + 1.51*sin(p1*x2 - 0.83) + p1*exp(0.20*x1) + p2*0.45,
    p2*x2 + p2*exp(0.20*x3) + 1.34*v4/(1 + powi(x3, 2)),
    0.86*v3 + p2*v3*v2*x2/(1 + powi(x2, 2)) + 0.31*v3,
    1.86*powi(v2, 2),
)]
#[constraint(row1: 1.35*x3 + 0.19*sin(x3) + 0.13*sin(x4) + 0.74 == 0)]
#[constraint(row2: 1.25*x1 + 0.13*sin(x1) + 0.27*powi(x4, 2)/2 + 0.29*x2*x3 + 0.10*sin(x3) + 0.51 == 0)]
pub struct Random26 {
    #[nominal(0.87)]
    pub p1: f64,
    #[nominal(0.71)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + tan(0.89*sin(x2))/2*dot(x1),
    v3 = dot(x3) + atan2(x2, 2 + cos(t))/2*dot(x2),
    v4 = dot(x4) + cos(0.89*x4 + 0.59*x1)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - tan(0.89*sin(x2))/2*(v1),
    dot(x3) = v3 - atan2(x2, 2 + cos(t))/2*(v2 - tan(0.89*sin(x2))/2*(v1)),
    dot(x4) = v4 - cos(0.89*x4 + 0.59*x1)*(v1),
)]
#[inertia(diag(1.37, 1.20, (1.06 + 0.17*sin(0.77*x3)), 1.19))]
#[forces(
    1.27*atan2(x1, 2 + cos(x3))/2 + p1*exp(0.20*x2) + 1.64*atan2(x4, 2 + cos(x3))/2,
    p1*exp(0.20*x3),
    0,
    p1*exp(0.20*x4) + p1*v2*v3*0.60*sin(x4)/(1.50 + cos(t)),
)]
#[constraint(row1: 1.62*x2 + 0.14*x4*x3 + exp(0.24*x3)/2 + 0.30*sin(0.93*t) + 0.63 == 0)]
#[constraint(row2: (1.50 + 0.24*powi(cos(1.10*x4 - 0.62), 3))*v1 - 0.17*0.38*sin(x2)/(1.50 + cos(x3))*v4 == 0)]
pub struct Random27 {
    #[nominal(1.05)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(matrix(
    [(1.18)*(1.18), 0, (1.18)*(0.14*0.33*sin(x2)/(1.50 + cos(x3)))],
    [_, ((1.37 + 0.16*exp(-powi(x2, 2)/2)))*((1.37 + 0.16*exp(-powi(x2, 2)/2))), 0],
    [_, _, (0.14*0.33*sin(x2)/(1.50 + cos(x3)))*(0.14*0.33*sin(x2)/(1.50 + cos(x3))) + ((1.33 + 0.14*ln(1.60 + 0.95*cos(x1))))*((1.33 + 0.14*ln(1.60 + 0.95*cos(x1))))],
))]
#[forces(
    p1*dot(x1)*dot(x3)*1/sqrt(1.50 + powi(x1, 2)) + 1.25*cos(0.44*x3 + 0.39*x1),
    1.85*powi(dot(x3), 2) + 0.50*sin(0.70*x3 - 0.37*x1 + 1.36) + 1.36*sin(0.60*x1),
    p1*1.57 - p1*x1 - p1*dot(x3)*dot(x1)*1/sqrt(1.50 + powi(x1, 2)),
)]
#[constraint(height: 1.88*x3 + 0.17*powi(x1, 2)/2 - 0.55 == 0)]
#[constraint(height_rate: 1.20*(1.88*dot(x3) + 0.17*x1*dot(x1)) == 0)]
#[constraint(further: (1.50 + 0.16*cos(0.96*x3 - 0.79*x1))*dot(x2) + 0.19*x2/(1 + powi(x2, 2))*dot(x1) + 0.53*exp(-powi(x3, 2)/2) == 0)]
#[independent(dot(x1))]
pub struct Random28 {
    #[nominal(0.74)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inputs(tau)]
#[inertia(diag(1.35, (1.39 + 0.26*0.36*sin(x2)/(1.50 + cos(x1))), (1.14 + 0.30*sin(p1*x1 - 0.86))))]
#[forces(
    0.51*dot(x3) + 1.31*t/(1 + powi(t, 2)) + dot(x1)*dot(x3)/1.38 + dot(x2)*dot(x2)/(1.27 + 0.20*sin(p2*x3 - 0.24)),
    p3*exp(0.20*x2) - dot(x3)*sqrt(2 + powi(dot(x2), 2)) - 1.67*dot(x2),
    p2*dot(x2)*dot(x2)*0.32*sin(x1)/(1.50 + cos(x3)),
)]
#[constraint(height: 1.46*x3 + 0.35*x2*x2 + 0.30*sin(0.76*t) - 0.37 == 0)]
#[constraint(first: (1.50 + 0.12*ln(1.60 + 0.65*cos(x2)))*dot(x1) + 0.30*1/sqrt(1.50 + powi(x2, 2))*dot(x2) + 0.28*1/sqrt(1.50 + powi(t, 2))*dot(x3) == 0)]
#[constraint(second: 1.46*dot(x3) + 0.35*(dot(x2)*x2 + x2*dot(x2)) + 0.30*0.76*cos(0.76*t) - 0.50*sin(p3*x3 - 0.57)*((1.50 + 0.12*ln(1.60 + 0.65*cos(x2)))*dot(x1) + 0.30*1/sqrt(1.50 + powi(x2, 2))*dot(x2) + 0.28*1/sqrt(1.50 + powi(t, 2))*dot(x3)) == 0)]
pub struct Random29 {
    #[nominal(1.20)]
    pub p1: f64,
    #[nominal(1.47)]
    pub p2: f64,
    #[nominal(1.26)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(diag((1.30 + 0.21*powi(cos(0.50*x1 + 0.88*t), 3)), 1.38, (1.16 - 0.34*atan2(x1, 2 + cos(t))/2), (1.05 + 0.20*ln(1.60 + 0.65*cos(x3)))))]
#[forces(
    dot(x2)*dot(x2)/(1.25 + 0.25*powi(cos(0.65*x4 - 0.62), 3)) + 1.07*dot(x3)/(1 + powi(t, 2)) + p1*1.52,
    0.62*dot(x2) - 0.98*powi(dot(x3), 2) - 1.60*dot(x3)/(1 + powi(x2, 2)) - 0.43*dot(x2)/(1 + powi(x4, 2)),
    1.89*dot(x1) - 1.62*dot(x1)/(1 + powi(x1, 2)),
    1.96*dot(x3)/(1 + powi(x3, 2)),
)]
#[potential_energy(ln(1.60 + 0.69*cos(x1)))]
#[configuration(x4 = 1.05*x2/(1 + powi(x2, 2)))]
#[constraint(held_x4: x4 - (1.05*x2/(1 + powi(x2, 2))) == 0)]
pub struct Random30 {
    #[nominal(0.87)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + sin(0.89*x4 - 0.59*x3)*dot(x1),
    v3 = dot(x3) + sin(0.75*x1)*dot(x2),
    v4 = dot(x4) + atan2(x2, 2 + cos(x1))/2*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - sin(0.89*x4 - 0.59*x3)*(v1),
    dot(x3) = v3 - sin(0.75*x1)*(v2 - sin(0.89*x4 - 0.59*x3)*(v1)),
    dot(x4) = v4 - atan2(x2, 2 + cos(x1))/2*(v2 - sin(0.89*x4 - 0.59*x3)*(v1)),
)]
#[inertia(diag((1.00 - 0.22*powi(cos(0.65*x2 - 0.83*x2), 3)), (1.18 - 0.12*sin(0.61*x4 + 0.85*x3 + 0.68)), (1.35 - 0.12*tan(0.94*sin(x1))/2), (1.40 + 0.27*0.93*sin(x4)/(1.50 + cos(x4)))))]
#[forces(
    p2*1.32,
    v4*sqrt(2 + powi(v1, 2)) - v1*v2/(1.30 - 0.26*powi(cos(0.41*x1 + 0.89*x3), 3)) - 0.40*powi(v1, 2),
    0.44*v4/(1 + powi(x2, 2)) + p2*exp(0.20*x4) + 1.07*powi(v4, 2) + 1.65*powi(v3, 2),
    p2*exp(0.20*x3) - p2*x4 - p1*0.48 - v3*v1/1.15,
)]
#[configuration(of(q1, q2, q3), x4 = 1.25*q1, x2 = 1.25*q2, x3 = 1.25*q3, x1 = cos(1.14*q2 + 0.68*q3 - 0.39))]
#[constraint(held_x1: x1 - (cos(1.14*(x2/1.25) + 0.68*(x3/1.25) - 0.39)) == 0)]
pub struct Random31 {
    #[nominal(0.80)]
    pub p1: f64,
    #[nominal(0.58)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(matrix(
    [((1.18 - 0.22*0.69*sin(x3)/(1.50 + cos(x2))))*((1.18 - 0.22*0.69*sin(x3)/(1.50 + cos(x2)))), 0, ((1.18 - 0.22*0.69*sin(x3)/(1.50 + cos(x2))))*(0.33*sin(0.98*x3))],
    [_, ((1.37 - 0.30*sin(p1*x2 - 0.91)))*((1.37 - 0.30*sin(p1*x2 - 0.91))), ((1.37 - 0.30*sin(p1*x2 - 0.91)))*(0.28*cos(0.96*x1 + 0.85*x3))],
    [_, _, (0.33*sin(0.98*x3))*(0.33*sin(0.98*x3)) + (0.28*cos(0.96*x1 + 0.85*x3))*(0.28*cos(0.96*x1 + 0.85*x3)) + ((1.05 + 0.26*sin(0.68*x2 + 1.43)))*((1.05 + 0.26*sin(0.68*x2 + 1.43)))],
))]
#[forces(
    1.90*x2/(1 + powi(x2, 2)),
    0,
    p1*x3 - p1*dot(x1)*dot(x2)*1/sqrt(1.50 + powi(x1, 2)) - dot(x1)*sqrt(2 + powi(dot(x3), 2)) - 0.97*exp(-powi(x1, 2)/2),
)]
#[configuration(x2 = 0.64*cos(0.76*x1))]
#[constraint(rolling: (1.50 + 0.27*1/sqrt(1.50 + powi(x3, 2)))*dot(x3) - 0.34*tan(0.44*sin(x3))/2*dot(x1) - 0.51*tan(0.46*sin(x3))/2 == 0)]
#[independent(dot(x1))]
pub struct Random32 {
    #[nominal(1.05)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(diag((1.13 + 0.17*1/sqrt(1.50 + powi(x4, 2))), 1.33, (1.36 - 0.16*sin(0.86*x3 + 0.75*x4 - 0.57)), (1.08 - 0.24*atan2(x2, 2 + cos(x4))/2)))]
#[forces(
    1.99*dot(x1)/(1 + powi(x3, 2)) - dot(x2)*dot(x4)/(1.31 - 0.31*powi(cos(0.51*x3), 3)),
    dot(x1)*sqrt(2 + powi(dot(x2), 2)) - p1*x4,
    p2*x2 + p1*x2 + p2*exp(0.20*x2) + 1.51*powi(cos(0.80*x4), 3),
    p1*x3,
)]
#[constraint(row1: dot(x2) + 0.78*powi(cos(0.84*x1), 3)*dot(x3) + 0.48*sin(0.59*x2)*cos(0.98*x3 + 0.31*x1 - 0.91)*dot(x1) + 0.56*sin(p2*x1 - 0.94)*dot(x4) == 0)]
#[complement(
    w1 = [0, -1.23*(0.78*powi(cos(0.84*x1), 3)), 1.23, 0],
    w2 = [(1.15 - 0.21*0.57*sin(x1)/(1.50 + cos(x2))), -(1.15 - 0.21*0.57*sin(x1)/(1.50 + cos(x2)))*(0.48*sin(0.59*x2)*cos(0.98*x3 + 0.31*x1 - 0.91)), 0, 0],
    w3 = [0, -(1.15 + 0.12*x2/(1 + powi(x2, 2)))*(0.56*sin(p2*x1 - 0.94)), 0, (1.15 + 0.12*x2/(1 + powi(x2, 2)))],
)]
pub struct Random33 {
    #[nominal(0.79)]
    pub p1: f64,
    #[nominal(0.56)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + powi(cos(1.02*x3 + 0.44*x2 + 0.73), 3)*dot(x1),
    v3 = dot(x3) + sin(1.05*x4 + 0.59)*dot(x2),
    v4 = dot(x4) + powi(cos(0.54*x2 - 0.74*x2), 3)*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - powi(cos(1.02*x3 + 0.44*x2 + 0.73), 3)*(v1),
    dot(x3) = v3 - sin(1.05*x4 + 0.59)*(v2 - powi(cos(1.02*x3 + 0.44*x2 + 0.73), 3)*(v1)),
    dot(x4) = v4 - powi(cos(0.54*x2 - 0.74*x2), 3)*(v2 - powi(cos(1.02*x3 + 0.44*x2 + 0.73), 3)*(v1)),
)]
#[inertia(diag((1.10 - 0.31*sin(p1*x2 + 0.73)), 1.07, (1.10 + 0.13*sin(0.60*x1)*cos(0.55*x1 - 0.62*x2)), (1.12 + 0.17*x4/(1 + powi(x4, 2)))))]
#[forces(
    0,
    1.15*v3/(1 + powi(x1, 2)) - 1.86*sin(p2*x2 + 0.79),
    p3*0.85 + 0.84*sin(0.66*x3 - 1.17) + v4*v3/(1.24 + 0.33*sin(0.83*x2)) + 0.85*atan2(x4, 2 + cos(x2))/2,
    v3*v3/(1.35 - 0.29*sin(p2*x2 - 0.41)) + 0.45*v2 + p3*v3*v3*sin(0.85*x1 - 0.71*x1)*cos(1.02*x4) + 0.54*sin(p1*x2 + 0.46),
)]
#[constraint(row1: 1.34*x2 + 0.19*sin(x1) - 0.23 == 0)]
#[constraint(row2: 1.85*x3 + 0.21*x1 + 0.59 == 0)]
#[constraint(row3: 1.93*x4 + 0.37*x1 - 0.71 == 0)]
#[independent(v1)]
pub struct Random34 {
    #[nominal(0.80)]
    pub p1: f64,
    #[nominal(0.61)]
    pub p2: f64,
    #[nominal(1.04)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(diag((1.32 - 0.12*tan(0.76*sin(x3))/2), (1.29 - 0.21*sin(0.67*x4)), (1.22 - 0.14*cos(1.12*x1 + 0.88*x3)), 1.24))]
#[forces(
    p1*dot(x4)*dot(x2)*ln(1.60 + 0.41*cos(x4)) - p1*exp(0.20*x1) - dot(x4)*sqrt(2 + powi(dot(x1), 2)) - p1*0.76,
    0.68*dot(x2)/(1 + powi(x3, 2)),
    0.97*sin(0.80*x2 - 0.81*t) - dot(x3)*sqrt(2 + powi(dot(x4), 2)) - 1.25*powi(dot(x2), 2),
    dot(x1)*sqrt(2 + powi(dot(x3), 2)) - dot(x2)*sqrt(2 + powi(dot(x4), 2)),
)]
#[constraint(row1: 1.72*x2 + 0.30*sin(0.83*t) + 0.36 == 0)]
#[constraint(row2: 1.53*x1 + 0.22*powi(x2, 2)/2 + 0.30*sin(0.44*t) - 0.59 == 0)]
#[constraint(row3: 1.46*x3 + 0.11*sin(x3) + 0.38*powi(x2, 2)/2 + 0.27*powi(x1, 2)/2 + 0.30*sin(1.35*t) - 0.44 == 0)]
#[constraint(row4: 1.92*x4 + 0.24*sin(x4) + 0.10*powi(x2, 2)/2 + 0.30*sin(0.99*t) + 0.36 == 0)]
pub struct Random35 {
    #[nominal(1.15)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = dot(x1) - 0.22*atan2(x3, 2 + cos(x1))/2*dot(x3),
    v2 = (1.29 - 0.22*powi(cos(0.60*x2 + 0.38*x1), 3))*dot(x2),
    v3 = (1.10 + 0.18*0.49*sin(x5)/(1.50 + cos(x5)))*dot(x3),
    v4 = 1.17*dot(x4) - 0.37*powi(cos(0.94*x1 - 0.62*x1), 3)*dot(x1),
    v5 = 1.36*dot(x5) + 0.17*powi(cos(0.52*x3 + 0.75*x2), 3)*dot(x2),
)]
#[define(l11 = (1.29 + 0.27*x3/(1 + powi(x3, 2))), l21 = 0.15*cos(0.64*x2 + 0.31), l22 = 1.22, l31 = 0.34*1/sqrt(1.50 + powi(x4, 2)), l32 = 0.33*sin(1.14*x5 + 0.79)*cos(0.81*x4), l33 = 1.34, l41 = 0.12*sin(p1*x3 - 0.96), l42 = 0.39*powi(cos(0.46*x5 + 0.86*x2), 3), l43 = 0.18*cos(0.42*x1 - 0.72*x1 - 0.45), l44 = 1.27, l51 = 0.35*1/sqrt(1.50 + powi(x1, 2)), l53 = 0.10*sin(p1*x4 - 0.32), l55 = (1.16 + 0.23*exp(-powi(x5, 2)/2)))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, l11*l41, l11*l51],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l21*l41 + l22*l42, l21*l51],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l32*l42 + l33*l43, l31*l51 + l33*l53],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44, l41*l51 + l43*l53],
    [_, _, _, _, l51*l51 + l53*l53 + l55*l55],
))]
#[forces(
    v3*v5/1.16 + p1*0.99 + p1*exp(0.20*x5) + 0.45*v2,
    p1*v3*v3*sin(0.67*x5 - 0.81*x3) - p1*v5*v3*cos(1.14*x5) - p1*0.73 - 1.73*v5,
    0,
    0.74*v3/(1 + powi(x5, 2)) + p1*exp(0.20*x2),
    1.74*x1/(1 + powi(x1, 2)) - v3*v2/(1.33 - 0.21*sin(p1*x1 - 0.75)) - 0.30*v4/(1 + powi(x2, 2)) - v5*v4/(1.13 - 0.12*sin(p1*x2 - 0.69)),
)]
pub struct Random36 {
    #[nominal(0.54)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inputs(tau)]
#[define(l11 = (1.22 - 0.34*tan(0.91*sin(x4))/2), l21 = 0.12*sin(p3*x2 - 0.69), l22 = 1.03, l31 = 0.24*tan(0.50*sin(x2))/2, l32 = 0.26*powi(cos(1.04*x2 - 0.34), 3), l33 = 1.08, l41 = 0.20*atan2(t, 2 + cos(t))/2, l43 = 0.31*cos(0.88*x3 + 0.87*x2), l44 = (1.16 - 0.14*x2/(1 + powi(x2, 2))))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, l11*l41],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l21*l41],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l33*l43],
    [_, _, _, l41*l41 + l43*l43 + l44*l44],
))]
#[forces(
    tau*1.73,
    p2*x1 - 1.86*x4/(1 + powi(x4, 2)) - dot(x4)*sqrt(2 + powi(dot(x4), 2)) - dot(x3)*sqrt(2 + powi(dot(x2), 2)),
    0,
    p3*x2 + 1.47*0.50*sin(x1)/(1.50 + cos(x4)) + dot(x1)*dot(x1)/1.01,
)]
#[constraint(row1: 1.17*dot(x1) - 0.29*1/sqrt(1.50 + powi(x1, 2))*dot(x3) == 0)]
#[constraint(row2: (1.50 - 0.26*cos(0.74*x3))*dot(x2) + 0.33*cos(0.65*t)*dot(x3) + 0.52*x4/(1 + powi(x4, 2)) == 0)]
#[constraint(row3: (1.50 - 0.23*sin(0.59*t))*dot(x4) + 0.22*sin(p2*x4 - 0.97)*dot(x3) == 0)]
pub struct Random37 {
    #[nominal(0.78)]
    pub p1: f64,
    #[nominal(1.26)]
    pub p2: f64,
    #[nominal(1.02)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inputs(tau)]
#[inertia(diag((1.32 - 0.24*sin(0.82*x4 + 0.39*t)), (1.09 - 0.28*sin(1.08*x3)*cos(1.09*x3)), (1.36 + 0.31*tan(0.46*sin(x1))/2), (1.29 + 0.11*atan2(x1, 2 + cos(x3))/2)))]
#[forces(
    0.65*cos(0.95*t) + 1.26*dot(x2) + 1.18*dot(x1)/(1 + powi(x1, 2)),
    0,
    p2*dot(x3)*dot(x4)*cos(0.96*x4 + 0.21*t) - 0.40*powi(dot(x2), 2) - dot(x1)*sqrt(2 + powi(dot(x2), 2)),
    dot(x1)*dot(x2)/(1.26 + 0.16*cos(0.56*x3)) - 1.62*dot(x4)/(1 + powi(x2, 2)),
)]
#[constraint(row1: 1.25*x4 + 0.13*sin(x4) + exp(0.29*x3)/2 + 0.30*sin(0.91*t) - 0.14 == 0)]
#[constraint(row2: 1.56*x2 + 0.14*sin(x2) + exp(0.40*x3)/2 + exp(0.12*x4)/2 + 0.30*sin(0.68*t) - 0.33 == 0)]
#[constraint(row3: 1.27*x1 + 0.23*sin(x1) + 0.25*x3 + 0.31*powi(x4, 2)/2 + exp(0.40*x2)/2 + 0.30*sin(1.47*t) - 0.60 == 0)]
pub struct Random38 {
    #[nominal(0.99)]
    pub p1: f64,
    #[nominal(0.60)]
    pub p2: f64,
    #[nominal(0.73)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[define(l11 = 1.26, l21 = 0.35*sin(0.82*x4 - 0.85*t + 0.40), l22 = (1.13 + 0.25*ln(1.60 + 0.93*cos(t))), l31 = 0.33*tan(0.91*sin(x3))/2, l32 = 0.30*1/sqrt(1.50 + powi(x1, 2)), l33 = (1.18 + 0.25*x2/(1 + powi(x2, 2))), l41 = 0.18*sin(1.11*x4 + 0.34), l42 = 0.21*sin(1.00*x2 + 0.57), l43 = 0.16*1/sqrt(1.50 + powi(x2, 2)), l44 = 1.06)]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, l11*l41],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l21*l41 + l22*l42],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l32*l42 + l33*l43],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44],
))]
#[forces(
    dot(x3)*dot(x4)/(1.23 + 0.30*atan2(t, 2 + cos(x1))/2) - 1.80*ln(1.60 + 0.60*cos(x1)) - 1.91*1/sqrt(1.50 + powi(x2, 2)),
    p1*exp(0.20*x2) - p1*dot(x3)*dot(x4)*powi(cos(0.95*x1), 3) - p2*exp(0.20*x3) - dot(x2)*sqrt(2 + powi(dot(x3), 2)),
    0,
    dot(x1)*sqrt(2 + powi(dot(x2), 2)) + 1.34*dot(x1) + p1*x4 + 0.81*powi(dot(x3), 2),
)]
#[constraint(row1: 1.70*x3 + 0.25*sin(x3) + exp(0.39*x4)/2 + 0.35*powi(x2, 2)/2 + 0.30*sin(0.76*t) + 0.33 == 0)]
#[constraint(row2: 1.50*dot(x1) + 0.22*cos(0.79*x3)*dot(x4) - 0.24*powi(cos(1.04*x1), 3)*dot(x2) + 0.19*cos(1.04*x4 + 0.46)*dot(x3) + 0.31*sin(0.96*x4 - 0.47*x3) == 0)]
#[independent(dot(x2), dot(x4))]
pub struct Random39 {
    #[nominal(1.14)]
    pub p1: f64,
    #[nominal(1.27)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    dot(x1) = v1 - 0.37*tan(0.87*sin(x4))/2*v5 - 0.32*0.54*sin(x2)/(1.50 + cos(x5)),
    dot(x2) = 1.34*v2 + 0.17*x4/(1 + powi(x4, 2))*v1 - 0.37*x1/(1 + powi(x1, 2)),
    dot(x3) = v3 - 0.53*atan2(x3, 2 + cos(x2))/2,
    dot(x4) = (1.39 - 0.23*powi(cos(0.79*x4 + 0.55*x3), 3))*v4 + 0.39*x1/(1 + powi(x1, 2))*v1 - 0.33*x3/(1 + powi(x3, 2)),
    dot(x5) = 1.32*v5 - 0.35*sin(0.51*x2 + 0.65*x1 + 0.15)*cos(0.89*x2 + 0.60*x5 - 1.24)*v1 + 0.29*atan2(x4, 2 + cos(x4))/2,
)]
#[inertia(diag((1.04 + 0.34*exp(-powi(x1, 2)/2)), (1.20 + 0.25*1/sqrt(1.50 + powi(x3, 2))), 1.07, (1.08 - 0.35*sin(0.45*x4 - 0.36*x2)), (1.01 + 0.21*powi(cos(0.78*x2 + 0.46*x5), 3))))]
#[forces(
    p1*x4 - v1*v5/1.34 - v5*v2/(1.31 + 0.33*0.82*sin(x5)/(1.50 + cos(x1))) - p1*v1*v1*ln(1.60 + 0.42*cos(x5)),
    v5*sqrt(2 + powi(v5, 2)) + p1*v2*v5*0.81*sin(x2)/(1.50 + cos(x5)) + 1.14*v1,
    p1*x2 - p1*v3*v2*atan2(x5, 2 + cos(x5))/2,
    1.80*powi(v3, 2) - p1*1.08,
    1.50*powi(v2, 2),
)]
#[constraint(height: 1.88*x3 + 0.16*sin(x3) + 0.18*sin(x1) + exp(0.26*x2)/2 + 0.13*sin(x5) - 0.75 == 0)]
#[constraint(height_rate: 1.88*dot(x3) + 0.16*cos(x3)*dot(x3) + 0.18*cos(x1)*dot(x1) + 0.26*exp(0.26*x2)*dot(x2)/2 + 0.13*cos(x5)*dot(x5) == 0)]
#[constraint(further: 1.58*v4 - 0.31*sin(1.00*x4 - 0.28*x3 + 1.09)*v1 + 0.29*x4/(1 + powi(x4, 2))*v2 + 0.29*cos(1.12*x2 - 0.87*x1) == 0)]
#[independent(v5, v2, v1)]
pub struct Random40 {
    #[nominal(0.87)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[inputs(tau)]
#[inertia(matrix(
    [((1.11 - 0.16*tan(0.85*sin(x1))/2))*((1.11 - 0.16*tan(0.85*sin(x1))/2)), ((1.11 - 0.16*tan(0.85*sin(x1))/2))*(0.24*1/sqrt(1.50 + powi(x3, 2))), ((1.11 - 0.16*tan(0.85*sin(x1))/2))*(0.36*1/sqrt(1.50 + powi(x5, 2))), ((1.11 - 0.16*tan(0.85*sin(x1))/2))*(0.31*powi(cos(1.06*x4 + 0.34*x4 + 1.32), 3)), ((1.11 - 0.16*tan(0.85*sin(x1))/2))*(0.24*x5/(1 + powi(x5, 2)))],
    [_, (0.24*1/sqrt(1.50 + powi(x3, 2)))*(0.24*1/sqrt(1.50 + powi(x3, 2))) + ((1.05 + 0.22*sin(1.14*x4 - 0.58*x5)))*((1.05 + 0.22*sin(1.14*x4 - 0.58*x5))), (0.24*1/sqrt(1.50 + powi(x3, 2)))*(0.36*1/sqrt(1.50 + powi(x5, 2))), (0.24*1/sqrt(1.50 + powi(x3, 2)))*(0.31*powi(cos(1.06*x4 + 0.34*x4 + 1.32), 3)) + ((1.05 + 0.22*sin(1.14*x4 - 0.58*x5)))*(0.21*sin(p2*x3 - 0.63)), (0.24*1/sqrt(1.50 + powi(x3, 2)))*(0.24*x5/(1 + powi(x5, 2))) + ((1.05 + 0.22*sin(1.14*x4 - 0.58*x5)))*(0.14*ln(1.60 + 0.49*cos(x5)))],
    [_, _, (0.36*1/sqrt(1.50 + powi(x5, 2)))*(0.36*1/sqrt(1.50 + powi(x5, 2))) + ((1.23 + 0.26*x1/(1 + powi(x1, 2))))*((1.23 + 0.26*x1/(1 + powi(x1, 2)))), (0.36*1/sqrt(1.50 + powi(x5, 2)))*(0.31*powi(cos(1.06*x4 + 0.34*x4 + 1.32), 3)) + ((1.23 + 0.26*x1/(1 + powi(x1, 2))))*(0.16*tan(0.34*sin(x5))/2), (0.36*1/sqrt(1.50 + powi(x5, 2)))*(0.24*x5/(1 + powi(x5, 2))) + ((1.23 + 0.26*x1/(1 + powi(x1, 2))))*(0.28*x1/(1 + powi(x1, 2)))],
    [_, _, _, (0.31*powi(cos(1.06*x4 + 0.34*x4 + 1.32), 3))*(0.31*powi(cos(1.06*x4 + 0.34*x4 + 1.32), 3)) + (0.21*sin(p2*x3 - 0.63))*(0.21*sin(p2*x3 - 0.63)) + (0.16*tan(0.34*sin(x5))/2)*(0.16*tan(0.34*sin(x5))/2) + ((1.20 + 0.14*0.32*sin(x4)/(1.50 + cos(x1))))*((1.20 + 0.14*0.32*sin(x4)/(1.50 + cos(x1)))), (0.31*powi(cos(1.06*x4 + 0.34*x4 + 1.32), 3))*(0.24*x5/(1 + powi(x5, 2))) + (0.21*sin(p2*x3 - 0.63))*(0.14*ln(1.60 + 0.49*cos(x5))) + (0.16*tan(0.34*sin(x5))/2)*(0.28*x1/(1 + powi(x1, 2)))],
    [_, _, _, _, (0.24*x5/(1 + powi(x5, 2)))*(0.24*x5/(1 + powi(x5, 2))) + (0.14*ln(1.60 + 0.49*cos(x5)))*(0.14*ln(1.60 + 0.49*cos(x5))) + (0.28*x1/(1 + powi(x1, 2)))*(0.28*x1/(1 + powi(x1, 2))) + (1.03)*(1.03)],
))]
#[forces(
    0,
    1.87*powi(dot(x3), 2),
    dot(x2)*sqrt(2 + powi(dot(x5), 2)),
    1.58*0.76*sin(x2)/(1.50 + cos(x5)) - tau*1.24 - p3*x4,
    0,
)]
#[constraint(height: 1.46*x4 + 0.23*sin(x4) + 0.27*x3*x5 + 0.40*x5*x5 + 0.60 == 0)]
#[constraint(first: (1.50 + 0.18*sin(0.78*x2 - 0.35*x4)*cos(0.52*x4 + 0.21*x4 + 0.26))*dot(x1) - 0.20*1/sqrt(1.50 + powi(x1, 2))*dot(x3) + 0.34*sin(0.72*x3 + 0.41*x3)*dot(x5) + 0.26*sin(0.67*x3 + 0.42)*cos(0.95*x3 - 0.85*x5)*dot(x2) - 0.35*cos(0.49*x3) == 0)]
#[constraint(second: 1.46*dot(x4) + 0.23*cos(x4)*dot(x4) + 0.27*(dot(x3)*x5 + x3*dot(x5)) + 0.40*(dot(x5)*x5 + x5*dot(x5)) - 0.50*sin(p3*x2 + 0.41)*((1.50 + 0.18*sin(0.78*x2 - 0.35*x4)*cos(0.52*x4 + 0.21*x4 + 0.26))*dot(x1) - 0.20*1/sqrt(1.50 + powi(x1, 2))*dot(x3) + 0.34*sin(0.72*x3 + 0.41*x3)*dot(x5) + 0.26*sin(0.67*x3 + 0.42)*cos(0.95*x3 - 0.85*x5)*dot(x2) - 0.35*cos(0.49*x3)) == 0)]
pub struct Random41 {
    #[nominal(1.16)]
    pub p1: f64,
    #[nominal(0.55)]
    pub p2: f64,
    #[nominal(1.03)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    dot(x1) = (1.35 + 0.11*sin(0.58*x4 - 0.51*x1))*v1 - 0.24*sin(p2*x2 + 0.76)*v2 + 0.20*cos(0.85*x2 + 0.22*x2),
    dot(x2) = v2 + 0.10*tan(0.43*sin(x2))/2,
    dot(x3) = (1.09 - 0.15*exp(-powi(x3, 2)/2))*v3 + 0.35*ln(1.60 + 0.71*cos(x5))*v1 - 0.52*tan(0.33*sin(x5))/2,
    dot(x4) = (1.13 + 0.24*x2/(1 + powi(x2, 2)))*v4 + 0.15*tan(0.71*sin(t))/2*v3 + 0.23*atan2(x2, 2 + cos(x3))/2,
    dot(x5) = v5 - 0.38*0.49*sin(x5)/(1.50 + cos(x3))*v3 - 0.37*sin(1.00*x4 - 0.53*t + 0.97),
)]
#[inertia(diag((1.31 - 0.14*cos(0.80*x3 - 1.10)), (1.33 - 0.33*tan(0.98*sin(t))/2), 1.26, 1.23, (1.19 + 0.10*tan(0.79*sin(x4))/2)))]
#[forces(
    p1*x5 - p2*exp(0.20*x2),
    0.97*cos(1.13*x1 + 0.70*x1) - v5*sqrt(2 + powi(v5, 2)) - 1.47*v5,
    p2*exp(0.20*x3) - p1*x1,
    p1*exp(0.20*x5) + p2*v3*v2*sin(1.11*t + 0.76*x3),
    0.31*0.74*sin(x4)/(1.50 + cos(x2)) + v3*sqrt(2 + powi(v5, 2)) + p3*exp(0.20*x1),
)]
#[configuration(x3 = 0.72*tan(0.36*sin(x4))/2)]
pub struct Random42 {
    #[nominal(0.90)]
    pub p1: f64,
    #[nominal(0.83)]
    pub p2: f64,
    #[nominal(1.32)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(diag((1.36 + 0.14*atan2(x1, 2 + cos(x4))/2), (1.03 + 0.28*sin(0.70*x3 - 0.55*x2)*cos(0.62*x2)), 1.40, (1.28 + 0.32*sin(0.86*x1)*cos(0.61*x1 + 0.21*x1))))]
#[forces(
    p1*dot(x4)*dot(x1)*1/sqrt(1.50 + powi(x4, 2)),
    p1*exp(0.20*x3) + p1*exp(0.20*x1) + dot(x1)*sqrt(2 + powi(dot(x2), 2)),
    0,
    p1*x3 + 0.84*ln(1.60 + 0.94*cos(x1)) + dot(x2)*sqrt(2 + powi(dot(x3), 2)) + 1.50*powi(dot(x4), 2),
)]
#[potential_energy(1/sqrt(1.50 + powi(x1, 2)))]
#[configuration(of(q1), x2 = 1.25*q1, x1 = cos(0.55*q1 - 0.65*q1), x3 = sin(0.94*q1 - 0.32), x4 = sin(p1*q1 + 0.69))]
#[constraint(held_x1: x1 - (cos(0.55*(x2/1.25) - 0.65*(x2/1.25))) == 0)]
#[constraint(held_x3: x3 - (sin(0.94*(x2/1.25) - 0.32)) == 0)]
#[constraint(held_x4: x4 - (sin(p1*(x2/1.25) + 0.69)) == 0)]
pub struct Random43 {
    #[nominal(1.33)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(diag((1.27 - 0.28*tan(0.51*sin(x4))/2), (1.03 + 0.14*sin(1.19*t - 0.52*x4 + 0.81)), 1.03, 1.01))]
#[forces(
    dot(x2)*dot(x3)/1.23,
    1.48*powi(cos(0.98*x1), 3) - dot(x1)*dot(x2)/(1.07 + 0.14*powi(cos(1.19*x1 - 0.74), 3)),
    0.67*exp(-powi(t, 2)/2),
    dot(x1)*sqrt(2 + powi(dot(x1), 2)) - dot(x1)*dot(x2)/(1.32 + 0.15*sin(0.82*x3 - 0.66*t)) - 1.77*cos(0.72*x1 - 0.64*t),
)]
#[potential_energy(cos(0.71*x1 + 0.40*x4))]
#[configuration(x1 = 0.62*exp(-powi(x4, 2)/2))]
#[constraint(rolling: (1.50 + 0.23*cos(0.40*x2 + 0.89*x3))*dot(x2) - 0.20*cos(1.11*x4)*dot(x3) + 0.29*atan2(x3, 2 + cos(x2))/2*dot(x4) == 0)]
pub struct Random44 {
    #[nominal(1.03)]
    pub p1: f64,
    #[nominal(1.09)]
    pub p2: f64,
    #[nominal(1.13)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = 1.37*dot(x1),
    v2 = dot(x2) + 0.24*atan2(x1, 2 + cos(x1))/2*dot(x5),
    v3 = 1.00*dot(x3),
    v4 = dot(x4) - 0.19*sin(1.10*x4 - 0.54*x3)*dot(x2),
    v5 = dot(x5),
)]
#[inertia(diag((1.27 + 0.21*tan(0.33*sin(x3))/2), 1.14, (1.26 - 0.12*0.44*sin(x2)/(1.50 + cos(t))), (1.23 + 0.30*tan(0.47*sin(x4))/2), (1.04 + 0.26*sin(0.83*t - 1.18)*cos(1.15*x2 - 0.80*x1 - 0.33))))]
#[forces(
    v2*sqrt(2 + powi(v1, 2)),
    0.66*ln(1.60 + 0.60*cos(t)) - p1*1.85,
    p1*v1*v5*sin(0.76*x4) + 1.79*v5/(1 + powi(t, 2)),
    p1*x5 - p1*v4*v3*0.63*sin(x2)/(1.50 + cos(x2)),
    p1*exp(0.20*x2) + p1*x5 + 0.62*v3/(1 + powi(x4, 2)),
)]
#[potential_energy(ln(1.60 + 0.76*cos(x1)))]
#[constraint(row1: v2 + 0.64*cos(0.75*x3 + 0.81*t)*v1 + 0*v3 + 0*v5 + 0.40*tan(0.96*sin(x2))/2 == 0)]
#[constraint(row2: v4 + 0*v1 + 0*v3 + 0.31*sin(0.76*x3)*cos(0.76*x5)*v5 == 0)]
#[complement(
    w1 = [1.31, -1.31*(0.64*cos(0.75*x3 + 0.81*t)), 0, -1.31*(0), 0],
    w2 = [0, -(1.34 + 0.13*sin(1.05*x3 + 0.63))*(0), (1.34 + 0.13*sin(1.05*x3 + 0.63)), -(1.34 + 0.13*sin(1.05*x3 + 0.63))*(0), 0],
    w3 = [0, -1.04*(0), 0, -1.04*(0.31*sin(0.76*x3)*cos(0.76*x5)), 1.04],
)]
pub struct Random45 {
    #[nominal(0.94)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[inertia(matrix(
    [(1.33)*(1.33), 0, (1.33)*(0.34*tan(0.56*sin(x4))/2), (1.33)*(0.27*exp(-powi(x5, 2)/2)), (1.33)*(0.32*sin(p1*x4 + 0.96))],
    [_, ((1.23 + 0.17*sin(0.42*x5 + 1.07)))*((1.23 + 0.17*sin(0.42*x5 + 1.07))), ((1.23 + 0.17*sin(0.42*x5 + 1.07)))*(0.30*atan2(x5, 2 + cos(x3))/2), ((1.23 + 0.17*sin(0.42*x5 + 1.07)))*(0.30*ln(1.60 + 0.46*cos(x5))), 0],
    [_, _, (0.34*tan(0.56*sin(x4))/2)*(0.34*tan(0.56*sin(x4))/2) + (0.30*atan2(x5, 2 + cos(x3))/2)*(0.30*atan2(x5, 2 + cos(x3))/2) + ((1.16 + 0.12*tan(0.41*sin(x5))/2))*((1.16 + 0.12*tan(0.41*sin(x5))/2)), (0.34*tan(0.56*sin(x4))/2)*(0.27*exp(-powi(x5, 2)/2)) + (0.30*atan2(x5, 2 + cos(x3))/2)*(0.30*ln(1.60 + 0.46*cos(x5))) + ((1.16 + 0.12*tan(0.41*sin(x5))/2))*(0.38*sin(p1*x4 - 0.67)), (0.34*tan(0.56*sin(x4))/2)*(0.32*sin(p1*x4 + 0.96)) + ((1.16 + 0.12*tan(0.41*sin(x5))/2))*(0.35*sin(0.96*x1 + 0.87*x2)*cos(0.99*x2 + 0.20*x4))],
    [_, _, _, (0.27*exp(-powi(x5, 2)/2))*(0.27*exp(-powi(x5, 2)/2)) + (0.30*ln(1.60 + 0.46*cos(x5)))*(0.30*ln(1.60 + 0.46*cos(x5))) + (0.38*sin(p1*x4 - 0.67))*(0.38*sin(p1*x4 - 0.67)) + ((1.24 - 0.15*atan2(x2, 2 + cos(x5))/2))*((1.24 - 0.15*atan2(x2, 2 + cos(x5))/2)), (0.27*exp(-powi(x5, 2)/2))*(0.32*sin(p1*x4 + 0.96)) + (0.38*sin(p1*x4 - 0.67))*(0.35*sin(0.96*x1 + 0.87*x2)*cos(0.99*x2 + 0.20*x4)) + ((1.24 - 0.15*atan2(x2, 2 + cos(x5))/2))*(0.33*cos(0.83*x3 - 0.91))],
    [_, _, _, _, (0.32*sin(p1*x4 + 0.96))*(0.32*sin(p1*x4 + 0.96)) + (0.35*sin(0.96*x1 + 0.87*x2)*cos(0.99*x2 + 0.20*x4))*(0.35*sin(0.96*x1 + 0.87*x2)*cos(0.99*x2 + 0.20*x4)) + (0.33*cos(0.83*x3 - 0.91))*(0.33*cos(0.83*x3 - 0.91)) + ((1.24 + 0.23*sin(p1*x2 - 0.83)))*((1.24 + 0.23*sin(p1*x2 - 0.83)))],
))]
#[forces(
    0.63*powi(dot(x1), 2) - 0.67*dot(x4),
    p1*1.70 - p1*x4 - dot(x1)*sqrt(2 + powi(dot(x1), 2)),
    dot(x4)*sqrt(2 + powi(dot(x3), 2)),
    p1*1.05 + p1*dot(x3)*dot(x2)*x4/(1 + powi(x4, 2)) + p1*dot(x4)*dot(x1)*exp(-powi(x3, 2)/2),
    p1*1.92 - p1*exp(0.20*x4),
)]
#[constraint(row1: 1.91*x3 + 0.14*powi(x4, 2)/2 + 0.66 == 0)]
#[constraint(row2: 1.82*x2 + 0.17*sin(x2) + exp(0.35*x4)/2 + 0.29*sin(x3) + 0.46 == 0)]
#[constraint(row3: dot(x1) + 0.19*atan2(x4, 2 + cos(x2))/2*dot(x4) - 0.23*powi(cos(0.49*x4), 3)*dot(x3) - 0.19*atan2(x5, 2 + cos(x1))/2*dot(x2) == 0)]
#[constraint(row4: dot(x5) - 0.13*cos(1.14*x3 + 0.55*x4)*dot(x4) == 0)]
pub struct Random46 {
    #[nominal(0.85)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[inputs(tau)]
#[kinematics(
    v1 = (1.38 + 0.20*sin(p2*x4 - 0.93))*dot(x1) + 0.34*sin(1.15*x2 - 0.41*x3 - 0.31)*dot(x3) + 0.43*1/sqrt(1.50 + powi(x2, 2)),
    v2 = dot(x2) - 0.26*sin(0.71*x3)*dot(x4) - 0.49*1/sqrt(1.50 + powi(t, 2)),
    v3 = (1.21 + 0.22*x4/(1 + powi(x4, 2)))*dot(x3) + 0.39*cos(0.43*t - 0.58*x2),
    v4 = dot(x4) + 0.35*cos(0.44*t)*dot(x2) - 0.18*cos(1.20*x3 - 0.32*x1),
)]
#[inertia(diag((1.13 - 0.26*cos(1.05*x3 + 0.69*x3)), (1.28 - 0.24*powi(cos(0.44*x2 - 0.59*x4 + 0.26), 3)), 1.36, 1.35))]
#[forces(
    0.85*powi(v1, 2) + p1*v1*v2*tan(0.90*sin(x2))/2 + 1.82*v3/(1 + powi(x4, 2)) + p2*t,
    p3*x3 + p1*exp(0.20*x4),
    tau*1.48 - 1.71*0.56*sin(x3)/(1.50 + cos(x1)) - p2*x3 - p1*exp(0.20*x1),
    1.96*powi(v2, 2) + 0.65*powi(cos(0.53*t), 3) + v1*sqrt(2 + powi(v3, 2)),
)]
#[constraint(row1: 1.28*x2 + 0.30*sin(0.68*t) - 0.27 == 0)]
#[constraint(row2: 1.95*x3 + 0.11*sin(x3) + 0.15*x2*x2 + 0.30*sin(0.74*t) + 0.60 == 0)]
#[constraint(row3: 1.95*x1 + 0.20*sin(x1) + 0.15*x2*x3 + 0.17*powi(x3, 2)/2 + 0.30*sin(1.25*t) + 0.22 == 0)]
#[constraint(row4: 1.35*x4 + 0.31*sin(x2) + 0.30*sin(0.91*t) - 0.48 == 0)]
pub struct Random47 {
    #[nominal(0.95)]
    pub p1: f64,
    #[nominal(0.98)]
    pub p2: f64,
    #[nominal(0.95)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    dot(x1) = (1.10 - 0.25*x6/(1 + powi(x6, 2)))*v1,
    dot(x2) = v2 + 0.16*x4/(1 + powi(x4, 2))*v6,
    dot(x3) = 1.20*v3 - 0.15*atan2(x2, 2 + cos(x3))/2*v6,
    dot(x4) = (1.19 - 0.11*exp(-powi(x1, 2)/2))*v4 - 0.12*sin(1.08*x1)*v2,
    dot(x5) = v5,
    dot(x6) = (1.26 + 0.13*sin(0.76*x1 + 0.78*x6)*cos(0.78*x4 + 0.77*x1))*v6 + 0.30*x2/(1 + powi(x2, 2))*v2,
)]
#[inertia(matrix(
    [((1.17 + 0.21*cos(0.49*x6)))*((1.17 + 0.21*cos(0.49*x6))), 0, 0, ((1.17 + 0.21*cos(0.49*x6)))*(0.26*powi(cos(1.11*x4 - 0.88*x3), 3)), ((1.17 + 0.21*cos(0.49*x6)))*(0.27*1/sqrt(1.50 + powi(x3, 2))), ((1.17 + 0.21*cos(0.49*x6)))*(0.16*exp(-powi(x3, 2)/2))],
    [_, ((1.20 - 0.12*1/sqrt(1.50 + powi(x2, 2))))*((1.20 - 0.12*1/sqrt(1.50 + powi(x2, 2)))), ((1.20 - 0.12*1/sqrt(1.50 + powi(x2, 2))))*(0.25*sin(0.49*x2 - 0.25*x3)), ((1.20 - 0.12*1/sqrt(1.50 + powi(x2, 2))))*(0.38*sin(0.88*x6 - 0.71)), 0, ((1.20 - 0.12*1/sqrt(1.50 + powi(x2, 2))))*(0.12*1/sqrt(1.50 + powi(x1, 2)))],
    [_, _, (0.25*sin(0.49*x2 - 0.25*x3))*(0.25*sin(0.49*x2 - 0.25*x3)) + (1.33)*(1.33), (0.25*sin(0.49*x2 - 0.25*x3))*(0.38*sin(0.88*x6 - 0.71)) + (1.33)*(0.36*1/sqrt(1.50 + powi(x3, 2))), (1.33)*(0.23*powi(cos(0.71*x4 + 0.65*x6), 3)), (0.25*sin(0.49*x2 - 0.25*x3))*(0.12*1/sqrt(1.50 + powi(x1, 2))) + (1.33)*(0.13*atan2(x5, 2 + cos(x5))/2)],
    [_, _, _, (0.26*powi(cos(1.11*x4 - 0.88*x3), 3))*(0.26*powi(cos(1.11*x4 - 0.88*x3), 3)) + (0.38*sin(0.88*x6 - 0.71))*(0.38*sin(0.88*x6 - 0.71)) + (0.36*1/sqrt(1.50 + powi(x3, 2)))*(0.36*1/sqrt(1.50 + powi(x3, 2))) + ((1.33 + 0.12*sin(0.54*x6 + 0.59)))*((1.33 + 0.12*sin(0.54*x6 + 0.59))), (0.26*powi(cos(1.11*x4 - 0.88*x3), 3))*(0.27*1/sqrt(1.50 + powi(x3, 2))) + (0.36*1/sqrt(1.50 + powi(x3, 2)))*(0.23*powi(cos(0.71*x4 + 0.65*x6), 3)) + ((1.33 + 0.12*sin(0.54*x6 + 0.59)))*(0.19*sin(p1*x6 - 0.66)), (0.26*powi(cos(1.11*x4 - 0.88*x3), 3))*(0.16*exp(-powi(x3, 2)/2)) + (0.38*sin(0.88*x6 - 0.71))*(0.12*1/sqrt(1.50 + powi(x1, 2))) + (0.36*1/sqrt(1.50 + powi(x3, 2)))*(0.13*atan2(x5, 2 + cos(x5))/2) + ((1.33 + 0.12*sin(0.54*x6 + 0.59)))*(0.32*powi(cos(0.92*x2), 3))],
    [_, _, _, _, (0.27*1/sqrt(1.50 + powi(x3, 2)))*(0.27*1/sqrt(1.50 + powi(x3, 2))) + (0.23*powi(cos(0.71*x4 + 0.65*x6), 3))*(0.23*powi(cos(0.71*x4 + 0.65*x6), 3)) + (0.19*sin(p1*x6 - 0.66))*(0.19*sin(p1*x6 - 0.66)) + (1.16)*(1.16), (0.27*1/sqrt(1.50 + powi(x3, 2)))*(0.16*exp(-powi(x3, 2)/2)) + (0.23*powi(cos(0.71*x4 + 0.65*x6), 3))*(0.13*atan2(x5, 2 + cos(x5))/2) + (0.19*sin(p1*x6 - 0.66))*(0.32*powi(cos(0.92*x2), 3)) + (1.16)*(0.17*tan(0.85*sin(x3))/2)],
    [_, _, _, _, _, (0.16*exp(-powi(x3, 2)/2))*(0.16*exp(-powi(x3, 2)/2)) + (0.12*1/sqrt(1.50 + powi(x1, 2)))*(0.12*1/sqrt(1.50 + powi(x1, 2))) + (0.13*atan2(x5, 2 + cos(x5))/2)*(0.13*atan2(x5, 2 + cos(x5))/2) + (0.32*powi(cos(0.92*x2), 3))*(0.32*powi(cos(0.92*x2), 3)) + (0.17*tan(0.85*sin(x3))/2)*(0.17*tan(0.85*sin(x3))/2) + ((1.34 - 0.14*ln(1.60 + 0.52*cos(x1))))*((1.34 - 0.14*ln(1.60 + 0.52*cos(x1))))],
))]
#[forces(
    1.87*v5 + v5*sqrt(2 + powi(v5, 2)),
    v3*sqrt(2 + powi(v3, 2)),
    p1*v1*v4*exp(-powi(x6, 2)/2) - p1*x2 - v5*v5/1.20 - 0.62*powi(v6, 2),
    0,
    0,
    v1*v3/(1.03 + 0.22*exp(-powi(x6, 2)/2)) - 0.79*powi(v6, 2) - v2*sqrt(2 + powi(v3, 2)),
)]
pub struct Random48 {
    #[nominal(1.21)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = 1.17*dot(x1) + 0.35*powi(cos(0.84*x4 - 0.73*x3), 3)*dot(x2) - 0.44*sin(p1*x3 + 0.36),
    v2 = 1.40*dot(x2) + 0.17*0.63*sin(x4)/(1.50 + cos(x1))*dot(x4) - 0.46*sin(1.02*x1 + 0.67)*cos(0.55*x2 + 0.25*x3),
    v3 = 1.21*dot(x3) - 0.47*1/sqrt(1.50 + powi(x4, 2)),
    v4 = 1.02*dot(x4) + 0.10*sin(1.01*x4 + 0.56*x2 + 1.27)*cos(0.42*x6)*dot(x5) + 0.10*exp(-powi(x1, 2)/2),
    v5 = (1.08 - 0.32*sin(p1*x6 + 0.59))*dot(x5) + 0.12*cos(0.92*x1)*dot(x3) - 0.40*sin(1.06*x2 + 0.49*x5 + 0.95),
    v6 = (1.19 - 0.32*sin(p1*x6 - 0.78))*dot(x6) + 0.26*powi(cos(0.77*x4), 3)*dot(x4) + 0.11*x5/(1 + powi(x5, 2)),
)]
#[define(l11 = (1.32 + 0.14*exp(-powi(x2, 2)/2)), l22 = 1.07, l32 = 0.23*0.54*sin(x5)/(1.50 + cos(x5)), l33 = 1.15, l41 = 0.16*tan(0.69*sin(x5))/2, l42 = 0.21*0.52*sin(x6)/(1.50 + cos(x6)), l44 = (1.24 - 0.17*1/sqrt(1.50 + powi(x5, 2))), l51 = 0.33*ln(1.60 + 0.41*cos(x3)), l52 = 0.12*sin(0.89*x1), l54 = 0.11*cos(0.53*x5 + 0.24*x6), l55 = (1.35 + 0.18*sin(0.84*x6 - 0.33*x6 - 0.73)), l61 = 0.36*cos(0.46*x5 - 1.44), l62 = 0.35*x4/(1 + powi(x4, 2)), l64 = 0.36*sin(1.03*x1 + 0.27*x1 - 1.15)*cos(1.07*x5 + 0.43*x2 + 0.52), l65 = 0.23*0.65*sin(x6)/(1.50 + cos(x3)), l66 = 1.10)]
#[inertia(matrix(
    [l11*l11, 0, 0, l11*l41, l11*l51, l11*l61],
    [_, l22*l22, l22*l32, l22*l42, l22*l52, l22*l62],
    [_, _, l32*l32 + l33*l33, l32*l42, l32*l52, l32*l62],
    [_, _, _, l41*l41 + l42*l42 + l44*l44, l41*l51 + l42*l52 + l44*l54, l41*l61 + l42*l62 + l44*l64],
    [_, _, _, _, l51*l51 + l52*l52 + l54*l54 + l55*l55, l51*l61 + l52*l62 + l54*l64 + l55*l65],
    [_, _, _, _, _, l61*l61 + l62*l62 + l64*l64 + l65*l65 + l66*l66],
))]
#[forces(
    p1*0.65 - p1*exp(0.20*x1),
    v2*sqrt(2 + powi(v3, 2)) + v5*sqrt(2 + powi(v2, 2)),
    0,
    p1*exp(0.20*x1) + v5*sqrt(2 + powi(v5, 2)) + p1*v5*v1*sin(0.75*x6 + 0.10)*cos(1.00*x5 - 0.46*x6) + 1.11*powi(v3, 2),
    0.91*v2 - v5*sqrt(2 + powi(v2, 2)) - v3*v1/1.10,
    p1*1.28,
)]
#[constraint(row1: (1.50 + 0.15*cos(0.71*x6 - 0.85*x1))*v6 - 0.21*x4/(1 + powi(x4, 2))*v4 - 0.17*ln(1.60 + 0.87*cos(x6))*v1 - 0.48*tan(0.79*sin(x5))/2 == 0)]
#[constraint(row2: 1.68*v2 - 0.30*0.68*sin(x5)/(1.50 + cos(x4))*v4 == 0)]
#[independent(v5, v3, v1, v4)]
pub struct Random49 {
    #[nominal(0.52)]
    pub p1: f64,
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
            Random21(p1)
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
            Random43(p1)
            Random44(p1, p2, p3)
            Random45(p1)
            Random46(p1)
            Random47(p1, p2, p3)
            Random48(p1)
            Random49(p1)
        }
    };
}
pub(crate) use every_random_model;
