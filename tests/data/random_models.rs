// Generated from tests/random: random models, and a macro that names them all.

use holonomy::ConstrainedSystem;

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
#[coordinates(x1, x2)]
#[inertia(diag((1.01 + 0.30*x1/(1 + powi(x1, 2))), (1.06 + 0.29*ln(1.60 + 0.92*cos(x1)))))]
#[forces(
    p1*exp(0.20*x1) + p1*1.15 + p1*dot(x1)*dot(x1)*tan(0.81*sin(x1))/2 + 1.04*powi(dot(x1), 2),
    0.82*powi(dot(x2), 2),
)]
#[potential_energy(sin(p1*x2 + 0.59))]
#[constraint(row1: (1.50 - 0.25*ln(1.60 + 0.92*cos(x1)))*dot(x2) - 0.23*sin(0.42*x1 - 0.80*x2 - 1.47)*dot(x1) == 0)]
pub struct Random1 {
    #[nominal(1.18)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    dot(x1) = 1.26*v1 + 0.23*0.74*sin(x1)/(1.50 + cos(x1)),
)]
#[define(l11 = (1.03 - 0.21*exp(-powi(t, 2)/2)))]
#[inertia(matrix(
    [l11*l11],
))]
#[forces(
    v1*sqrt(2 + powi(v1, 2)) - v1*v1/1.05 - 1.58*v1 - 1.05*v1/(1 + powi(x1, 2)),
)]
#[potential_energy(sin(1.08*x1))]
#[constraint(row1: 1.26*x1 + 0.11*sin(x1) + 0.30*sin(1.32*t) - 0.47 == 0)]
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
    v1 = dot(x1),
)]
#[inertia(diag(1.23))]
#[forces(
    1.58*v1,
)]
#[constraint(height: 1.72*x1 + 0.20*sin(x1) + 0.30*sin(0.95*t) + 0.28 == 0)]
#[constraint(height_rate: 1.72*dot(x1) + 0.20*cos(x1)*dot(x1) + 0.30*0.95*cos(0.95*t) == 0)]
pub struct Random4 {
    #[nominal(1.47)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inputs(tau)]
#[define(l11 = (1.15 - 0.20*sin(p1*t - 0.32)), l21 = 0.32*sin(0.81*x2 + 0.86*x1)*cos(0.55*x2 + 0.14), l22 = (1.35 + 0.14*cos(0.94*x2 - 0.65*x2 - 1.22)))]
#[inertia(matrix(
    [l11*l11, l11*l21],
    [_, l21*l21 + l22*l22],
))]
#[forces(
    dot(x1)*sqrt(2 + powi(dot(x2), 2)) - p1*exp(0.20*x2),
    0,
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
    v1 = (1.04 - 0.16*ln(1.60 + 0.57*cos(x2)))*dot(x1) + 0.30*exp(-powi(x2, 2)/2)*dot(x2),
    v2 = dot(x2),
)]
#[inertia(matrix(
    [((1.17 - 0.30*sin(0.71*x2)))*((1.17 - 0.30*sin(0.71*x2))), ((1.17 - 0.30*sin(0.71*x2)))*(0.35*0.69*sin(x2)/(1.50 + cos(x1)))],
    [_, (0.35*0.69*sin(x2)/(1.50 + cos(x1)))*(0.35*0.69*sin(x2)/(1.50 + cos(x1))) + (1.15)*(1.15)],
))]
#[forces(
    0.88*v2 + 0.62*v1,
    0.61*powi(v1, 2),
)]
#[potential_energy(cos(0.98*x2 - 0.60*x2 + 1.17))]
#[configuration(x1 = 0.85*sin(0.63*x2 - 1.00))]
pub struct Random6 {
    #[nominal(1.31)]
    pub p1: f64,
    #[nominal(0.90)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(matrix(
    [(1.37)*(1.37), (1.37)*(0.34*cos(0.68*x2))],
    [_, (0.34*cos(0.68*x2))*(0.34*cos(0.68*x2)) + ((1.15 + 0.24*tan(0.71*sin(x2))/2))*((1.15 + 0.24*tan(0.71*sin(x2))/2))],
))]
#[forces(
    1.00*dot(x1)/(1 + powi(x1, 2)) - 1.69*powi(dot(x1), 2) - 0.98*dot(x1)/(1 + powi(x2, 2)),
    p1*0.50 - 1.05*x2/(1 + powi(x2, 2)) - 1.41*dot(x1)/(1 + powi(x1, 2)) - p1*dot(x1)*dot(x1)*sin(0.48*x1 - 0.89*x2)*cos(0.71*x1),
)]
#[potential_energy(exp(-powi(x2, 2)/2))]
#[configuration(of(q1, q2), x1 = 1.25*q1, x2 = 1.25*q2)]
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
#[define(l11 = (1.36 - 0.32*sin(1.06*x2 - 0.62*x2)), l22 = (1.10 + 0.31*1/sqrt(1.50 + powi(x2, 2))))]
#[inertia(matrix(
    [l11*l11, 0],
    [_, l22*l22],
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
#[inertia(diag(1.39, (1.09 - 0.31*sin(0.87*x1)*cos(0.72*x2 - 0.53))))]
#[forces(
    0,
    0,
)]
#[potential_energy(cos(0.74*x1))]
#[constraint(row1: v2 + 0.21*sin(0.85*t)*v1 == 0)]
#[complement(
    w1 = [1.21, -1.21*(0.21*sin(0.85*t))],
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
#[define(l11 = (1.28 + 0.35*atan2(x2, 2 + cos(x1))/2), l21 = 0.26*sin(0.74*x1), l22 = 1.29)]
#[inertia(matrix(
    [l11*l11, l11*l21],
    [_, l21*l21 + l22*l22],
))]
#[forces(
    0.95*powi(cos(0.49*x1), 3) + 0.57*v2/(1 + powi(x2, 2)),
    p1*x2 - p2*x1 - 0.91*1/sqrt(1.50 + powi(x1, 2)) - 1.43*v1,
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
#[inertia(diag((1.14 - 0.26*ln(1.60 + 0.63*cos(x2))), (1.39 - 0.22*exp(-powi(x1, 2)/2))))]
#[forces(
    0,
    0,
)]
#[potential_energy(sin(0.46*x1 + 0.16))]
#[constraint(row1: 1.52*x1 + 0.10*sin(x1) + 0.69 == 0)]
#[constraint(row2: 1.30*x2 + 0.27*powi(x1, 2)/2 + 0.52 == 0)]
pub struct Random11 {
    #[nominal(1.33)]
    pub p1: f64,
    #[nominal(1.22)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag((1.04 - 0.14*ln(1.60 + 0.38*cos(x1))), (1.34 - 0.31*powi(cos(0.48*x1 + 0.25*x2), 3))))]
#[forces(
    1.14*sin(1.20*x2 - 1.14),
    1.08*0.58*sin(x1)/(1.50 + cos(x1)) + 1.44*dot(x2)/(1 + powi(x2, 2)),
)]
#[potential_energy(1/sqrt(1.50 + powi(x2, 2)))]
#[constraint(row1: (1.50 + 0.28*sin(p1*x2 + 0.69))*dot(x1) - 0.46*cos(0.80*x1 + 0.87*x1 + 1.33) == 0)]
#[constraint(row2: (1.50 + 0.11*sin(0.80*x1 - 0.88*x1))*dot(x2) - 0.23*sin(0.99*x2 + 0.69)*dot(x1) + 0.56*powi(cos(0.66*x2 - 0.75), 3) == 0)]
pub struct Random18 {
    #[nominal(1.24)]
    pub p1: f64,
    #[nominal(0.64)]
    pub p2: f64,
    #[nominal(0.55)]
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
#[inertia(diag((1.39 - 0.15*cos(0.76*x2 + 0.66*x2 - 0.99)), (1.02 + 0.14*0.46*sin(x2)/(1.50 + cos(t)))))]
#[forces(
    v1*v1/(1.30 + 0.13*cos(1.17*x1)) + 1.82*v1 + 0.92*v2/(1 + powi(x1, 2)) + v1*v1/1.38,
    p1*1.80 - 1.27*powi(cos(1.00*x2 - 0.42*x2), 3) - 1.34*powi(v1, 2) - p1*0.56,
)]
#[potential_energy(sin(0.45*x2))]
#[constraint(row1: (1.50 + 0.30*powi(cos(0.74*x2 + 0.31*t), 3))*v1 - 0.33*powi(cos(0.49*x1), 3)*v2 + 0.27*sin(0.61*t + 0.88) == 0)]
pub struct Random21 {
    #[nominal(1.27)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag((1.16 + 0.21*sin(1.01*x1)), 1.19))]
#[forces(
    0,
    p1*exp(0.20*x1),
)]
#[constraint(row1: 1.34*x1 + 0.18*sin(x1) + 0.21*x2*x2 + 0.48 == 0)]
#[independent(dot(x2))]
pub struct Random22 {
    #[nominal(0.85)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag((1.34 - 0.13*1/sqrt(1.50 + powi(x2, 2))), (1.25 + 0.23*0.95*sin(x2)/(1.50 + cos(x1)))))]
#[forces(
    0.87*dot(x2) - 1.79*dot(x2) - 1.66*cos(0.90*x1 - 0.72*x1) - p1*exp(0.20*x1),
    0,
)]
#[potential_energy(sin(1.08*x2))]
#[constraint(row1: 1.72*x1 - 0.45 == 0)]
#[constraint(row2: (1.50 + 0.13*sin(0.77*x2))*dot(x2) + 0.25*sin(0.92*x2)*cos(0.56*x2 - 0.32*x2)*dot(x1) == 0)]
pub struct Random23 {
    #[nominal(0.74)]
    pub p1: f64,
    #[nominal(0.63)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = (1.02 + 0.15*tan(0.56*sin(x1))/2)*dot(x1) - 0.33*ln(1.60 + 0.81*cos(x2))*dot(x2) + 0.47*1/sqrt(1.50 + powi(x1, 2)),
    v2 = dot(x2) - 0.53*ln(1.60 + 0.94*cos(x1)),
)]
#[inertia(diag((1.34 + 0.35*exp(-powi(x1, 2)/2)), 1.37))]
#[forces(
    1.60*v2/(1 + powi(x1, 2)) + v1*sqrt(2 + powi(v2, 2)),
    0,
)]
#[constraint(height: 1.62*x1 + 0.11*sin(x1) + 0.32*powi(x2, 2)/2 - 0.22 == 0)]
#[constraint(height_rate: 1.62*dot(x1) + 0.11*cos(x1)*dot(x1) + 0.32*x2*dot(x2) == 0)]
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
    v1 = dot(x1) + 0.35*x2/(1 + powi(x2, 2))*dot(x2) - 0.55*exp(-powi(x2, 2)/2),
    v2 = (1.11 + 0.14*0.68*sin(x2)/(1.50 + cos(x1)))*dot(x2) - 0.14*x1/(1 + powi(x1, 2))*dot(x1) - 0.47*cos(0.69*x2 + 0.37*x1),
)]
#[inertia(matrix(
    [((1.14 - 0.11*atan2(x1, 2 + cos(x1))/2))*((1.14 - 0.11*atan2(x1, 2 + cos(x1))/2)), ((1.14 - 0.11*atan2(x1, 2 + cos(x1))/2))*(0.39*tan(0.83*sin(x1))/2)],
    [_, (0.39*tan(0.83*sin(x1))/2)*(0.39*tan(0.83*sin(x1))/2) + ((1.24 - 0.27*cos(0.95*x2 + 0.50*x1 - 0.96)))*((1.24 - 0.27*cos(0.95*x2 + 0.50*x1 - 0.96)))],
))]
#[forces(
    v1*sqrt(2 + powi(v1, 2)) - p3*exp(0.20*x2) - 1.07*cos(0.87*x1 + 0.64*x1),
    0.94*v1/(1 + powi(x2, 2)) - p2*exp(0.20*x2) - 1.49*powi(v1, 2) - p3*x2,
)]
#[constraint(height: 1.69*x1 - 0.11 == 0)]
#[constraint(first: (1.50 + 0.13*sin(p2*x2 - 0.91))*v2 - 0.20*sin(1.14*x1)*v1 == 0)]
#[constraint(second: 1.69*dot(x1) - 0.50*0.51*sin(x2)/(1.50 + cos(x1))*((1.50 + 0.13*sin(p2*x2 - 0.91))*v2 - 0.20*sin(1.14*x1)*v1) == 0)]
pub struct Random25 {
    #[nominal(1.12)]
    pub p1: f64,
    #[nominal(0.58)]
    pub p2: f64,
    #[nominal(1.41)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(matrix(
    [(1.27)*(1.27), (1.27)*(0.12*exp(-powi(x1, 2)/2)), 0],
    [_, (0.12*exp(-powi(x1, 2)/2))*(0.12*exp(-powi(x1, 2)/2)) + ((1.39 - 0.30*ln(1.60 + 0.91*cos(x1))))*((1.39 - 0.30*ln(1.60 + 0.91*cos(x1)))), ((1.39 - 0.30*ln(1.60 + 0.91*cos(x1))))*(0.26*powi(cos(0.54*x1 - 0.75), 3))],
    [_, _, (0.26*powi(cos(0.54*x1 - 0.75), 3))*(0.26*powi(cos(0.54*x1 - 0.75), 3)) + (1.02)*(1.02)],
))]
#[forces(
    dot(x1)*dot(x1)/(1.15 - 0.14*sin(0.62*x1 - 0.52*x3 + 0.14)*cos(0.46*x3)),
    0,
    0.74*cos(0.81*x2 + 0.25*x3) + p2*x1 + 1.79*dot(x2),
)]
#[configuration(x1 = 1.49*ln(1.60 + 0.83*cos(x2)))]
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
    v2 = dot(x2) + tan(0.89*sin(x2))/2*dot(x1),
    v3 = dot(x3) + atan2(x1, 2 + cos(x2))/2*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - tan(0.89*sin(x2))/2*(v1),
    dot(x3) = v3 - atan2(x1, 2 + cos(x2))/2*(v2 - tan(0.89*sin(x2))/2*(v1)),
)]
#[inertia(matrix(
    [(1.27)*(1.27), 0, (1.27)*(0.22*exp(-powi(x1, 2)/2))],
    [_, ((1.29 + 0.24*0.95*sin(x1)/(1.50 + cos(t))))*((1.29 + 0.24*0.95*sin(x1)/(1.50 + cos(t)))), ((1.29 + 0.24*0.95*sin(x1)/(1.50 + cos(t))))*(0.10*ln(1.60 + 0.62*cos(t)))],
    [_, _, (0.22*exp(-powi(x1, 2)/2))*(0.22*exp(-powi(x1, 2)/2)) + (0.10*ln(1.60 + 0.62*cos(t)))*(0.10*ln(1.60 + 0.62*cos(t))) + (1.17)*(1.17)],
))]
#[forces(
    0.63*v3 + p1*exp(0.20*x2),
    p1*exp(0.20*x2) + 1.41*v1/(1 + powi(x2, 2)) + 1.73*v2/(1 + powi(x1, 2)) + v3*sqrt(2 + powi(v1, 2)),
    p1*x3,
)]
#[configuration(of(q1, q2), x2 = 1.25*q1, x3 = 1.25*q2, x1 = sin(0.74*q2))]
#[constraint(held_x1: x1 - (sin(0.74*(x3/1.25))) == 0)]
pub struct Random27 {
    #[nominal(1.05)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag(1.35, (1.39 + 0.26*0.36*sin(t)/(1.50 + cos(x2)))))]
#[forces(
    p1*0.92,
    dot(x2)*dot(x2)/1.04 + 1.31*x1/(1 + powi(x1, 2)) + dot(x2)*dot(x1)/1.38,
)]
#[potential_energy(powi(cos(1.12*x1 + 0.48*x1), 3))]
#[constraint(row1: dot(x2) + 0.59*tan(0.52*sin(x2))/2*dot(x1) + 0.40*1/sqrt(1.50 + powi(x1, 2)) == 0)]
#[complement(
    w1 = [1.26, -1.26*(0.59*tan(0.52*sin(x2))/2)],
)]
pub struct Random29 {
    #[nominal(1.20)]
    pub p1: f64,
    #[nominal(1.47)]
    pub p2: f64,
    #[nominal(1.26)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = (1.08 + 0.20*t/(1 + powi(t, 2)))*v1 + 0.31*tan(0.49*sin(x2))/2,
    dot(x2) = v2 - 0.39*atan2(x2, 2 + cos(x2))/2*v3 + 0.59*1/sqrt(1.50 + powi(x3, 2)),
    dot(x3) = 1.14*v3 + 0.16*exp(-powi(x2, 2)/2),
)]
#[inertia(diag(1.36, (1.24 + 0.17*0.92*sin(x3)/(1.50 + cos(x2))), (1.25 - 0.21*0.86*sin(x3)/(1.50 + cos(t)))))]
#[forces(
    1.27*cos(0.88*x1) - 0.98*powi(v1, 2) - 1.60*v2/(1 + powi(t, 2)) - 0.43*v1/(1 + powi(x3, 2)),
    1.89*v2 - 1.62*v1/(1 + powi(x3, 2)),
    1.96*v3/(1 + powi(x3, 2)),
)]
#[potential_energy(ln(1.60 + 0.69*cos(x2)))]
#[constraint(row1: 1.64*x2 + 0.23*powi(x1, 2)/2 + 0.30*sin(1.09*t) + 0.20 == 0)]
#[constraint(row2: 1.53*x3 + 0.25*powi(x1, 2)/2 + 0.23*x2 + 0.30*sin(1.28*t) + 0.54 == 0)]
#[independent(v1)]
pub struct Random30 {
    #[nominal(0.87)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.04 + 0.12*ln(1.60 + 0.99*cos(x2))), (1.14 + 0.20*cos(1.12*x3 - 0.21*x2 + 0.77)), (1.29 - 0.24*sin(0.55*x3 - 1.36))))]
#[forces(
    p2*dot(x3)*dot(x1)*x3/(1 + powi(x3, 2)) - p1*exp(0.20*x2) - 1.00*powi(dot(x3), 2) - dot(x2)*dot(x1)/(1.27 - 0.32*powi(cos(0.75*x3 - 0.90*x1), 3)),
    dot(x2)*dot(x1)/1.24 - 0.73*dot(x3)/(1 + powi(x3, 2)) - 1.75*dot(x2) - p1*x3,
    p2*exp(0.20*x1) - p1*x1,
)]
#[potential_energy(exp(-powi(x2, 2)/2))]
#[constraint(row1: 1.34*x1 + 0.20*sin(x1) + 0.66 == 0)]
#[constraint(row2: 1.34*x3 + 0.22*x1 + 0.21 == 0)]
#[constraint(row3: 1.94*dot(x2) - 0.17*sin(p2*x2 - 0.19)*dot(x1) + 0.23*x1/(1 + powi(x1, 2))*dot(x3) == 0)]
pub struct Random31 {
    #[nominal(0.80)]
    pub p1: f64,
    #[nominal(0.58)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = (1.32 - 0.24*sin(0.82*t + 0.39*x1))*dot(x1) - 0.31*sin(1.08*t)*cos(1.09*t)*dot(x2),
    v2 = (1.35 - 0.21*ln(1.60 + 0.34*cos(x2)))*dot(x2) + 0.29*exp(-powi(x1, 2)/2)*dot(x1),
)]
#[inertia(diag((1.08 + 0.31*sin(0.86*x2 - 0.70*t - 1.07)), (1.35 + 0.23*tan(0.54*sin(x2))/2)))]
#[forces(
    v2*sqrt(2 + powi(v1, 2)) - 0.53*cos(0.88*t) - 0.40*powi(v2, 2) - v1*sqrt(2 + powi(v2, 2)),
    v1*v2/(1.26 + 0.16*cos(0.56*x2)) - 1.62*v2/(1 + powi(t, 2)),
)]
#[constraint(row1: 1.29*x2 + 0.13*sin(x2) + 0.30*sin(1.11*t) - 0.48 == 0)]
#[constraint(row2: (1.50 + 0.19*sin(0.61*x2 - 0.38*t)*cos(0.47*x2 + 0.56*x2 - 0.67))*v1 + 0.35*1/sqrt(1.50 + powi(x2, 2))*v2 == 0)]
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
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    dot(x1) = v1 - 0.37*tan(0.87*sin(x2))/2*v2 - 0.32*0.54*sin(x4)/(1.50 + cos(x1)),
    dot(x2) = 1.34*v2 + 0.17*x3/(1 + powi(x3, 2))*v1 - 0.37*x1/(1 + powi(x1, 2)),
    dot(x3) = v3 - 0.53*atan2(x2, 2 + cos(x2))/2,
    dot(x4) = (1.39 - 0.23*powi(cos(0.79*x3 + 0.55*x3), 3))*v4 + 0.39*x4/(1 + powi(x4, 2))*v1 - 0.33*x1/(1 + powi(x1, 2)),
)]
#[inertia(matrix(
    [((1.18 + 0.16*cos(0.46*x3)))*((1.18 + 0.16*cos(0.46*x3))), 0, ((1.18 + 0.16*cos(0.46*x3)))*(0.11*cos(0.85*x3)), ((1.18 + 0.16*cos(0.46*x3)))*(0.11*tan(0.47*sin(x1))/2)],
    [_, (1.36)*(1.36), (1.36)*(0.35*x2/(1 + powi(x2, 2))), (1.36)*(0.14*exp(-powi(x2, 2)/2))],
    [_, _, (0.11*cos(0.85*x3))*(0.11*cos(0.85*x3)) + (0.35*x2/(1 + powi(x2, 2)))*(0.35*x2/(1 + powi(x2, 2))) + ((1.04 + 0.34*exp(-powi(x3, 2)/2)))*((1.04 + 0.34*exp(-powi(x3, 2)/2))), (0.11*cos(0.85*x3))*(0.11*tan(0.47*sin(x1))/2) + (0.35*x2/(1 + powi(x2, 2)))*(0.14*exp(-powi(x2, 2)/2)) + ((1.04 + 0.34*exp(-powi(x3, 2)/2)))*(0.40*sin(0.45*x1 - 0.36*x3))],
    [_, _, _, (0.11*tan(0.47*sin(x1))/2)*(0.11*tan(0.47*sin(x1))/2) + (0.14*exp(-powi(x2, 2)/2))*(0.14*exp(-powi(x2, 2)/2)) + (0.40*sin(0.45*x1 - 0.36*x3))*(0.40*sin(0.45*x1 - 0.36*x3)) + (1.29)*(1.29)],
))]
#[forces(
    v2*v1/(1.26 - 0.20*1/sqrt(1.50 + powi(x4, 2))),
    p1*1.40,
    0,
    1.15*powi(v1, 2),
)]
pub struct Random40 {
    #[nominal(0.87)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inputs(tau)]
#[inertia(diag(1.19, (1.11 - 0.16*tan(0.85*sin(x1))/2), (1.09 - 0.23*exp(-powi(x2, 2)/2)), 1.08))]
#[forces(
    1.64*dot(x3)/(1 + powi(x2, 2)) + 0.45*powi(dot(x1), 2),
    0.80*dot(x2),
    p2*dot(x4)*dot(x1)*atan2(x3, 2 + cos(x1))/2 - 1.29*dot(x3),
    dot(x1)*sqrt(2 + powi(dot(x2), 2)) - 1.30*powi(dot(x3), 2) - p3*dot(x1)*dot(x3)*0.32*sin(x2)/(1.50 + cos(x3)) - tau*1.62,
)]
#[constraint(row1: dot(x1) + 0.30*sin(p3*x4 - 0.49)*dot(x4) - 0.21*cos(0.74*x1 - 0.70*x3)*dot(x3) + 0.56*1/sqrt(1.50 + powi(x4, 2)) == 0)]
#[constraint(row2: dot(x2) + 0.29*sin(0.60*x4 - 0.87)*dot(x4) + 0.22*sin(0.72*x3 + 0.46*x1)*cos(0.41*x2 - 0.59*x4)*dot(x3) + 0.45*powi(cos(0.46*x3 - 0.32*x4), 3) == 0)]
pub struct Random41 {
    #[nominal(1.16)]
    pub p1: f64,
    #[nominal(0.55)]
    pub p2: f64,
    #[nominal(1.03)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(matrix(
    [((1.35 + 0.11*sin(0.58*x3 - 0.51*t)))*((1.35 + 0.11*sin(0.58*x3 - 0.51*t))), ((1.35 + 0.11*sin(0.58*x3 - 0.51*t)))*(0.31*ln(1.60 + 0.87*cos(x4))), ((1.35 + 0.11*sin(0.58*x3 - 0.51*t)))*(0.19*exp(-powi(x4, 2)/2)), ((1.35 + 0.11*sin(0.58*x3 - 0.51*t)))*(0.11*powi(cos(1.11*t), 3))],
    [_, (0.31*ln(1.60 + 0.87*cos(x4)))*(0.31*ln(1.60 + 0.87*cos(x4))) + ((1.27 + 0.28*1/sqrt(1.50 + powi(x1, 2))))*((1.27 + 0.28*1/sqrt(1.50 + powi(x1, 2)))), (0.31*ln(1.60 + 0.87*cos(x4)))*(0.19*exp(-powi(x4, 2)/2)) + ((1.27 + 0.28*1/sqrt(1.50 + powi(x1, 2))))*(0.21*powi(cos(0.41*t - 0.42*x3 + 0.45), 3)), (0.31*ln(1.60 + 0.87*cos(x4)))*(0.11*powi(cos(1.11*t), 3))],
    [_, _, (0.19*exp(-powi(x4, 2)/2))*(0.19*exp(-powi(x4, 2)/2)) + (0.21*powi(cos(0.41*t - 0.42*x3 + 0.45), 3))*(0.21*powi(cos(0.41*t - 0.42*x3 + 0.45), 3)) + ((1.31 - 0.34*sin(0.65*x3 + 0.21*x3)))*((1.31 - 0.34*sin(0.65*x3 + 0.21*x3))), (0.19*exp(-powi(x4, 2)/2))*(0.11*powi(cos(1.11*t), 3))],
    [_, _, _, (0.11*powi(cos(1.11*t), 3))*(0.11*powi(cos(1.11*t), 3)) + (1.15)*(1.15)],
))]
#[forces(
    1.04*x1/(1 + powi(x1, 2)) + dot(x3)*dot(x4)/(1.11 - 0.24*sin(1.00*x4 - 0.53*x1 + 0.97)) + p1*1.62 + 1.90*0.88*sin(x3)/(1.50 + cos(x1)),
    p1*1.20 + p1*dot(x1)*dot(x3)*sin(1.16*x2 + 0.58*x1),
    dot(x2)*dot(x3)/(1.16 + 0.20*powi(cos(0.40*t + 1.23), 3)) + p3*1.51 + p2*1.59,
    p3*x3,
)]
#[constraint(row1: 1.24*x1 + 0.22*sin(x1) + 0.32*powi(x2, 2)/2 + 0.24*x3*x2 + 0.30*sin(1.37*t) - 0.65 == 0)]
#[constraint(row2: 1.76*x4 + 0.23*sin(x4) + 0.33*x2*x2 + 0.30*sin(1.24*t) - 0.47 == 0)]
#[independent(dot(x3), dot(x2))]
pub struct Random42 {
    #[nominal(0.90)]
    pub p1: f64,
    #[nominal(0.83)]
    pub p2: f64,
    #[nominal(1.32)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(matrix(
    [((1.35 - 0.25*tan(0.35*sin(x2))/2))*((1.35 - 0.25*tan(0.35*sin(x2))/2)), ((1.35 - 0.25*tan(0.35*sin(x2))/2))*(0.14*sin(1.19*x3 - 0.52*x3 + 0.81)), ((1.35 - 0.25*tan(0.35*sin(x2))/2))*(0.36*cos(1.18*x3 + 0.42*x2))],
    [_, (0.14*sin(1.19*x3 - 0.52*x3 + 0.81))*(0.14*sin(1.19*x3 - 0.52*x3 + 0.81)) + ((1.04 + 0.17*cos(0.66*t + 0.73*x2 - 1.07)))*((1.04 + 0.17*cos(0.66*t + 0.73*x2 - 1.07))), (0.14*sin(1.19*x3 - 0.52*x3 + 0.81))*(0.36*cos(1.18*x3 + 0.42*x2)) + ((1.04 + 0.17*cos(0.66*t + 0.73*x2 - 1.07)))*(0.13*atan2(x2, 2 + cos(t))/2)],
    [_, _, (0.36*cos(1.18*x3 + 0.42*x2))*(0.36*cos(1.18*x3 + 0.42*x2)) + (0.13*atan2(x2, 2 + cos(t))/2)*(0.13*atan2(x2, 2 + cos(t))/2) + (1.07)*(1.07)],
))]
#[forces(
    dot(x2)*sqrt(2 + powi(dot(x2), 2)) + p1*exp(0.20*x1),
    1.19*powi(dot(x3), 2),
    0,
)]
#[potential_energy(sin(1.08*x3 + 0.82)*cos(0.56*x3 + 1.36))]
#[constraint(height: 1.35*x1 + exp(0.23*x3)/2 + 0.30*sin(0.98*t) - 0.50 == 0)]
#[constraint(height_rate: 1.26*(1.35*dot(x1) + 0.23*exp(0.23*x3)*dot(x3)/2 + 0.30*0.98*cos(0.98*t)) == 0)]
#[constraint(further: 1.34*dot(x2) - 0.13*1/sqrt(1.50 + powi(x2, 2))*dot(x3) + 0.36*sin(0.42*x3 - 0.58*x1) == 0)]
#[independent(dot(x3))]
pub struct Random44 {
    #[nominal(1.03)]
    pub p1: f64,
    #[nominal(1.09)]
    pub p2: f64,
    #[nominal(1.13)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + 1/sqrt(1.50 + powi(x3, 2))*dot(x1),
    v3 = dot(x3) + ln(1.60 + 0.36*cos(x2))*dot(x1),
    v4 = dot(x4) + atan2(x2, 2 + cos(x3))/2*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - 1/sqrt(1.50 + powi(x3, 2))*(v1),
    dot(x3) = v3 - ln(1.60 + 0.36*cos(x2))*(v1),
    dot(x4) = v4 - atan2(x2, 2 + cos(x3))/2*(v1),
)]
#[inertia(diag(1.00, 1.29, (1.13 - 0.18*sin(1.10*x2 - 0.54*x1)), 1.10))]
#[forces(
    v2*sqrt(2 + powi(v1, 2)) + 0.90*v4/(1 + powi(x2, 2)) + 1.67*v2 + v3*sqrt(2 + powi(v2, 2)),
    1.39*powi(v1, 2),
    v1*sqrt(2 + powi(v1, 2)) + 1.76*v1 + 1.94*v4,
    p1*t,
)]
#[constraint(height: 1.38*x3 + 0.25*sin(x3) + 0.37*x1*x1 + exp(0.18*x2)/2 + 0.30*sin(0.86*t) - 0.77 == 0)]
#[constraint(first: (1.50 + 0.11*powi(cos(1.17*x2), 3))*v4 - 0.32*powi(cos(1.06*x4 - 0.51*t), 3)*v1 + 0.30*exp(-powi(x3, 2)/2)*v2 == 0)]
#[constraint(second: 1.38*dot(x3) + 0.25*cos(x3)*dot(x3) + 0.37*(dot(x1)*x1 + x1*dot(x1)) + 0.18*exp(0.18*x2)*dot(x2)/2 + 0.30*0.86*cos(0.86*t) - 0.50*cos(0.49*x4)*((1.50 + 0.11*powi(cos(1.17*x2), 3))*v4 - 0.32*powi(cos(1.06*x4 - 0.51*t), 3)*v1 + 0.30*exp(-powi(x3, 2)/2)*v2) == 0)]
#[independent(v2, v1)]
pub struct Random45 {
    #[nominal(0.94)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(matrix(
    [((1.38 + 0.20*sin(p2*x1 - 0.93)))*((1.38 + 0.20*sin(p2*x1 - 0.93))), ((1.38 + 0.20*sin(p2*x1 - 0.93)))*(0.17*cos(0.70*x1 + 0.84*x2)), ((1.38 + 0.20*sin(p2*x1 - 0.93)))*(0.19*x2/(1 + powi(x2, 2)))],
    [_, (0.17*cos(0.70*x1 + 0.84*x2))*(0.17*cos(0.70*x1 + 0.84*x2)) + ((1.24 + 0.24*exp(-powi(t, 2)/2)))*((1.24 + 0.24*exp(-powi(t, 2)/2))), (0.17*cos(0.70*x1 + 0.84*x2))*(0.19*x2/(1 + powi(x2, 2)))],
    [_, _, (0.19*x2/(1 + powi(x2, 2)))*(0.19*x2/(1 + powi(x2, 2))) + ((1.33 + 0.24*tan(0.77*sin(x2))/2))*((1.33 + 0.24*tan(0.77*sin(x2))/2))],
))]
#[forces(
    1.87*dot(x3),
    dot(x1)*dot(x1)/(1.31 - 0.11*atan2(x2, 2 + cos(x1))/2) - 1.18*powi(dot(x2), 2),
    0,
)]
#[configuration(of(q1, q2, q3), x2 = 1.25*q1, x1 = 1.25*q2, x3 = 1.25*q3)]
pub struct Random47 {
    #[nominal(0.95)]
    pub p1: f64,
    #[nominal(0.98)]
    pub p2: f64,
    #[nominal(0.95)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + sin(p1*x2 - 0.63)*dot(x1),
    v3 = dot(x3) + sin(1.04*x3 - 0.65)*dot(x2),
    v4 = dot(x4) + 1/sqrt(1.50 + powi(x1, 2))*dot(x3),
    dot(x1) = v1,
    dot(x2) = v2 - sin(p1*x2 - 0.63)*(v1),
    dot(x3) = v3 - sin(1.04*x3 - 0.65)*(v2 - sin(p1*x2 - 0.63)*(v1)),
    dot(x4) = v4 - 1/sqrt(1.50 + powi(x1, 2))*(v3 - sin(1.04*x3 - 0.65)*(v2 - sin(p1*x2 - 0.63)*(v1))),
)]
#[inertia(matrix(
    [(1.39)*(1.39), 0, 0, 0],
    [_, ((1.12 + 0.13*1/sqrt(1.50 + powi(x3, 2))))*((1.12 + 0.13*1/sqrt(1.50 + powi(x3, 2)))), ((1.12 + 0.13*1/sqrt(1.50 + powi(x3, 2))))*(0.36*x1/(1 + powi(x1, 2))), 0],
    [_, _, (0.36*x1/(1 + powi(x1, 2)))*(0.36*x1/(1 + powi(x1, 2))) + ((1.38 + 0.16*0.35*sin(x3)/(1.50 + cos(x3))))*((1.38 + 0.16*0.35*sin(x3)/(1.50 + cos(x3)))), ((1.38 + 0.16*0.35*sin(x3)/(1.50 + cos(x3))))*(0.29*powi(cos(1.18*x3 + 0.79*x3 + 0.53), 3))],
    [_, _, _, (0.29*powi(cos(1.18*x3 + 0.79*x3 + 0.53), 3))*(0.29*powi(cos(1.18*x3 + 0.79*x3 + 0.53), 3)) + (1.19)*(1.19)],
))]
#[forces(
    1.68*v1/(1 + powi(x2, 2)) + p1*exp(0.20*x4) + 1.04*powi(v2, 2),
    v4*v3/(1.18 - 0.23*cos(0.57*x1 - 1.50)) - p1*exp(0.20*x2) - p1*x3 - p1*v4*v4*atan2(x1, 2 + cos(x4))/2,
    p1*x3 + 1.03*1/sqrt(1.50 + powi(x3, 2)) + p1*exp(0.20*x1) + v4*sqrt(2 + powi(v2, 2)),
    0.63*sin(0.77*x4 - 0.66*x1)*cos(0.91*x4),
)]
#[configuration(x1 = 0.90*1/sqrt(1.50 + powi(x2, 2)), x3 = 1.30*1/sqrt(1.50 + powi(x4, 2)))]
#[constraint(held_x1: x1 - (0.90*1/sqrt(1.50 + powi(x2, 2))) == 0)]
#[constraint(held_x3: x3 - (1.30*1/sqrt(1.50 + powi(x4, 2))) == 0)]
#[constraint(rolling: 1.30*dot(x4) + 0.30*atan2(x2, 2 + cos(x4))/2*dot(x2) == 0)]
pub struct Random48 {
    #[nominal(1.21)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(diag((1.31 - 0.32*ln(1.60 + 1.00*cos(x2))), (1.18 + 0.29*sin(0.51*x2)), 1.16, (1.27 + 0.24*atan2(x2, 2 + cos(x1))/2)))]
#[forces(
    p1*dot(x3)*dot(x3)*cos(0.97*x2 + 0.72*x4 - 0.47) + 1.55*powi(dot(x4), 2) + 0.42*dot(x3),
    dot(x1)*sqrt(2 + powi(dot(x3), 2)) - dot(x2)*dot(x2)/(1.01 + 0.29*sin(0.75*x3 + 0.22*x2 + 0.73)*cos(0.41*x3)),
    0,
    dot(x4)*sqrt(2 + powi(dot(x4), 2)) - dot(x1)*dot(x1)/1.03,
)]
#[potential_energy(ln(1.60 + 0.76*cos(x2)))]
#[constraint(row1: dot(x4) + 0.21*1/sqrt(1.50 + powi(x2, 2))*dot(x3) + 0.40*powi(cos(0.73*x3 + 0.62*x4 - 0.61), 3) == 0)]
#[constraint(row2: dot(x1) + 0.27*powi(cos(0.69*x1 + 0.87), 3)*dot(x3) == 0)]
#[constraint(row3: dot(x2) + 0.61*0.63*sin(x1)/(1.50 + cos(x1))*dot(x3) == 0)]
#[complement(
    w1 = [-(1.07 + 0.30*ln(1.60 + 0.39*cos(x2)))*(0.27*powi(cos(0.69*x1 + 0.87), 3)), -(1.07 + 0.30*ln(1.60 + 0.39*cos(x2)))*(0.61*0.63*sin(x1)/(1.50 + cos(x1))), (1.07 + 0.30*ln(1.60 + 0.39*cos(x2))), -(1.07 + 0.30*ln(1.60 + 0.39*cos(x2)))*(0.21*1/sqrt(1.50 + powi(x2, 2)))],
)]
pub struct Random49 {
    #[nominal(0.52)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    dot(x1) = 1.02*v1 + 0.59*tan(1.00*sin(x1))/2,
    dot(x2) = v2 + 0.28*cos(0.60*x1 + 0.22*x3 + 1.10)*v4 - 0.22*sin(p2*x1 + 0.26),
    dot(x3) = (1.20 - 0.24*cos(0.51*x1 - 0.46*x4))*v3 - 0.12*sin(1.17*x3)*v1 - 0.43*tan(0.44*sin(x4))/2,
    dot(x4) = v4 + 0.37*sin(0.91*x4 - 0.58*x3)*v3 - 0.47*cos(0.75*x3),
)]
#[inertia(diag(1.39, 1.28, (1.16 + 0.30*0.78*sin(x1)/(1.50 + cos(x2))), (1.05 + 0.21*exp(-powi(x4, 2)/2))))]
#[forces(
    0,
    p2*exp(0.20*x1),
    p2*x3 + 1.71*v2,
    p1*1.98 + p2*exp(0.20*x4) + 1.36*v3,
)]
#[potential_energy(atan2(x3, 2 + cos(x4))/2)]
#[constraint(row1: 1.09*v2 - 0.29*tan(0.66*sin(x4))/2*v1 == 0)]
#[constraint(row2: (1.50 + 0.25*sin(p1*x2 - 0.92))*v4 - 0.25*sin(0.43*x3 + 0.52*x3)*cos(0.49*x1)*v1 - 0.18*sin(p2*x3 - 0.11)*v2 == 0)]
#[constraint(row3: 1.04*v3 - 0.13*cos(0.61*x3 - 0.54*x3)*v1 + 0.11*ln(1.60 + 0.77*cos(x1))*v2 - 0.17*sin(0.54*x1 + 0.73*x1)*cos(0.99*x1 - 0.82*x2 - 0.21)*v4 == 0)]
#[independent(v1)]
pub struct Random50 {
    #[nominal(1.15)]
    pub p1: f64,
    #[nominal(0.92)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(matrix(
    [((1.27 - 0.30*ln(1.60 + 0.93*cos(t))))*((1.27 - 0.30*ln(1.60 + 0.93*cos(t)))), 0, 0, ((1.27 - 0.30*ln(1.60 + 0.93*cos(t))))*(0.25*cos(0.53*x1))],
    [_, (1.21)*(1.21), (1.21)*(0.12*0.80*sin(t)/(1.50 + cos(x4))), 0],
    [_, _, (0.12*0.80*sin(t)/(1.50 + cos(x4)))*(0.12*0.80*sin(t)/(1.50 + cos(x4))) + (1.06)*(1.06), (1.06)*(0.30*tan(0.81*sin(x1))/2)],
    [_, _, _, (0.25*cos(0.53*x1))*(0.25*cos(0.53*x1)) + (0.30*tan(0.81*sin(x1))/2)*(0.30*tan(0.81*sin(x1))/2) + ((1.39 - 0.13*x3/(1 + powi(x3, 2))))*((1.39 - 0.13*x3/(1 + powi(x3, 2))))],
))]
#[forces(
    p1*dot(x2)*dot(x4)*sin(0.61*t + 0.31*x2 - 1.47),
    dot(x4)*sqrt(2 + powi(dot(x2), 2)) + dot(x4)*dot(x3)/(1.05 + 0.34*sin(0.79*x3)) + 0.39*sin(0.64*t + 0.50*x1)*cos(1.05*x1 + 1.05),
    p2*exp(0.20*x2) - 1.72*powi(dot(x1), 2),
    dot(x3)*dot(x1)/1.39 + p2*0.59 + p2*0.79,
)]
#[constraint(row1: 1.69*x4 + 0.24*sin(x4) + 0.38*sin(x1) + 0.30*sin(0.81*t) - 0.38 == 0)]
#[constraint(row2: 1.45*x2 + 0.21*sin(x2) + 0.15*sin(x1) + 0.26*sin(x4) + 0.30*sin(0.57*t) + 0.78 == 0)]
#[constraint(row3: (1.50 + 0.12*0.33*sin(x1)/(1.50 + cos(x1)))*dot(x3) + 0.33*0.71*sin(x4)/(1.50 + cos(x3))*dot(x1) - 0.12*tan(0.95*sin(x4))/2*dot(x4) + 0.25*sin(p3*x4 - 0.24)*dot(x2) - 0.25*sin(p1*x1 - 0.18) == 0)]
#[independent(dot(x1))]
pub struct Random58 {
    #[nominal(1.35)]
    pub p1: f64,
    #[nominal(0.64)]
    pub p2: f64,
    #[nominal(1.34)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    dot(x1) = 1.20*v1 + 0.13*powi(cos(0.98*x4 + 0.31*x1), 3)*v5,
    dot(x2) = v2 + 0.27*sin(0.63*x4 - 0.65*x5)*cos(0.69*x2)*v5,
    dot(x3) = 1.04*v3,
    dot(x4) = v4 - 0.26*sin(1.16*x5 - 0.25*x1)*v3,
    dot(x5) = (1.26 + 0.17*sin(0.87*x3))*v5,
)]
#[inertia(diag((1.12 + 0.15*cos(0.47*x2 - 0.66*x1)), 1.17, (1.26 + 0.29*ln(1.60 + 0.49*cos(x1))), (1.27 - 0.27*sin(1.00*x5 - 0.32*x1)), (1.28 + 0.12*exp(-powi(x3, 2)/2))))]
#[forces(
    0,
    0.33*0.95*sin(x4)/(1.50 + cos(x1)) - v3*sqrt(2 + powi(v1, 2)) - p1*x4,
    p1*v2*v3*sin(p1*x2 - 0.96) + v1*sqrt(2 + powi(v2, 2)),
    1.26*v1/(1 + powi(x2, 2)),
    1.00*powi(v3, 2),
)]
pub struct Random60 {
    #[nominal(0.62)]
    pub p1: f64,
    #[nominal(0.77)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inputs(tau)]
#[inertia(matrix(
    [((1.04 - 0.25*1/sqrt(1.50 + powi(x3, 2))))*((1.04 - 0.25*1/sqrt(1.50 + powi(x3, 2)))), 0, ((1.04 - 0.25*1/sqrt(1.50 + powi(x3, 2))))*(0.15*ln(1.60 + 0.42*cos(x2))), ((1.04 - 0.25*1/sqrt(1.50 + powi(x3, 2))))*(0.17*0.57*sin(x3)/(1.50 + cos(x3)))],
    [_, (1.21)*(1.21), 0, (1.21)*(0.30*sin(p2*x2 - 0.37))],
    [_, _, (0.15*ln(1.60 + 0.42*cos(x2)))*(0.15*ln(1.60 + 0.42*cos(x2))) + (1.38)*(1.38), (0.15*ln(1.60 + 0.42*cos(x2)))*(0.17*0.57*sin(x3)/(1.50 + cos(x3))) + (1.38)*(0.28*cos(1.10*x3))],
    [_, _, _, (0.17*0.57*sin(x3)/(1.50 + cos(x3)))*(0.17*0.57*sin(x3)/(1.50 + cos(x3))) + (0.30*sin(p2*x2 - 0.37))*(0.30*sin(p2*x2 - 0.37)) + (0.28*cos(1.10*x3))*(0.28*cos(1.10*x3)) + ((1.24 + 0.31*exp(-powi(x3, 2)/2)))*((1.24 + 0.31*exp(-powi(x3, 2)/2)))],
))]
#[forces(
    p1*exp(0.20*x4) - tau*0.39,
    dot(x1)*sqrt(2 + powi(dot(x2), 2)) - p2*exp(0.20*x1),
    p1*x3 - p2*x4,
    p2*dot(x4)*dot(x3)*exp(-powi(x3, 2)/2) + 1.11*cos(0.81*x1 + 0.75*x3),
)]
#[potential_energy(sin(0.55*x1 - 0.29*x4))]
#[constraint(row1: 1.47*dot(x4) + 0.18*cos(0.59*x3 - 0.31*x3 + 0.77)*dot(x2) - 0.21*cos(1.05*x2)*dot(x3) == 0)]
#[constraint(row2: (1.50 - 0.17*x4/(1 + powi(x4, 2)))*dot(x1) + 0.12*powi(cos(1.10*x1), 3)*dot(x2) - 0.28*sin(p2*x1 - 0.28)*dot(x3) - 0.30*cos(0.44*x3 - 0.71*x2 + 0.43) == 0)]
#[independent(dot(x3), dot(x2))]
pub struct Random61 {
    #[nominal(1.42)]
    pub p1: f64,
    #[nominal(1.09)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + 0.75*sin(x3)/(1.50 + cos(x4))*dot(x1),
    v3 = dot(x3) + cos(0.55*x1)*dot(x1),
    v4 = dot(x4) + 1/sqrt(1.50 + powi(x4, 2))*dot(x3),
    v5 = dot(x5) + sin(p1*x4 + 0.18)*dot(x4),
    dot(x1) = v1,
    dot(x2) = v2 - 0.75*sin(x3)/(1.50 + cos(x4))*(v1),
    dot(x3) = v3 - cos(0.55*x1)*(v1),
    dot(x4) = v4 - 1/sqrt(1.50 + powi(x4, 2))*(v3 - cos(0.55*x1)*(v1)),
    dot(x5) = v5 - sin(p1*x4 + 0.18)*(v4 - 1/sqrt(1.50 + powi(x4, 2))*(v3 - cos(0.55*x1)*(v1))),
)]
#[inertia(diag(1.03, 1.15, 1.21, (1.35 + 0.17*sin(1.08*x4 + 0.76*x1 - 0.47)), (1.19 - 0.33*cos(0.93*x2 - 0.24*x3 - 0.77))))]
#[forces(
    0,
    tau*1.79 + tau*1.49 + v1*v3/1.06 + v4*sqrt(2 + powi(v5, 2)),
    1.41*v3/(1 + powi(x1, 2)),
    0,
    v3*sqrt(2 + powi(v4, 2)) + p1*v1*v4*tan(0.85*sin(x1))/2 + tau*1.43,
)]
#[constraint(row1: 1.78*x1 + exp(0.31*x3)/2 + exp(0.26*x5)/2 + 0.23 == 0)]
#[constraint(row2: 1.95*x2 + 0.37*powi(x3, 2)/2 + 0.31*sin(x5) + 0.12*powi(x1, 2)/2 - 0.27 == 0)]
#[constraint(row3: 1.77*x4 + 0.13*sin(x4) + 0.11*sin(x3) + 0.34*x5 + exp(0.20*x1)/2 + 0.65 == 0)]
#[independent(v5, v3)]
pub struct Random62 {
    #[nominal(0.80)]
    pub p1: f64,
    #[nominal(1.26)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = 1.06*dot(x1) - 0.21*sin(0.80*x3 - 0.78*x2 + 0.94)*dot(x4) + 0.15*0.47*sin(x1)/(1.50 + cos(x3)),
    v2 = dot(x2) - 0.34*sin(0.86*x3 + 0.24*x4),
    v3 = (1.03 + 0.33*x2/(1 + powi(x2, 2)))*dot(x3) - 0.31*atan2(x2, 2 + cos(x3))/2*dot(x4) + 0.22*atan2(x4, 2 + cos(x3))/2,
    v4 = dot(x4) + 0.36*cos(1.13*x2 - 0.67*x2)*dot(x3) - 0.23*0.68*sin(x3)/(1.50 + cos(x1)),
)]
#[define(l11 = (1.07 - 0.18*atan2(x4, 2 + cos(x2))/2), l22 = (1.11 + 0.14*tan(0.93*sin(x2))/2), l33 = 1.37, l41 = 0.36*atan2(x4, 2 + cos(x4))/2, l43 = 0.34*0.40*sin(x1)/(1.50 + cos(x2)), l44 = (1.37 - 0.34*exp(-powi(x4, 2)/2)))]
#[inertia(matrix(
    [l11*l11, 0, 0, l11*l41],
    [_, l22*l22, 0, 0],
    [_, _, l33*l33, l33*l43],
    [_, _, _, l41*l41 + l43*l43 + l44*l44],
))]
#[forces(
    1.52*v3/(1 + powi(x4, 2)) - v2*sqrt(2 + powi(v4, 2)) - v4*v4/(1.25 + 0.24*sin(1.15*x3)*cos(0.56*x4)),
    p2*1.12,
    p2*exp(0.20*x4) - 1.33*v2 - p1*1.30,
    p1*x4 - v4*v1/(1.16 + 0.27*sin(0.78*x1 + 0.83*x2)) - v4*sqrt(2 + powi(v3, 2)),
)]
#[constraint(height: 1.72*x1 + 0.26*sin(x1) + 0.28*x4*x4 + 0.20*sin(x2) - 0.26 == 0)]
#[constraint(height_rate: 1.72*dot(x1) + 0.26*cos(x1)*dot(x1) + 0.28*(dot(x4)*x4 + x4*dot(x4)) + 0.20*cos(x2)*dot(x2) == 0)]
#[constraint(further: v3 + 0.16*x3/(1 + powi(x3, 2))*v4 + 0.17*sin(1.17*x2 - 0.33*x1 + 1.47)*v2 - 0.33*sin(0.87*x1 - 0.84)*cos(1.03*x3 - 0.63*x3)*v1 == 0)]
pub struct Random64 {
    #[nominal(0.71)]
    pub p1: f64,
    #[nominal(1.44)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[define(l11 = (1.03 - 0.24*atan2(x2, 2 + cos(x4))/2), l21 = 0.30*x3/(1 + powi(x3, 2)), l22 = (1.26 + 0.22*tan(0.72*sin(x3))/2), l31 = 0.11*x3/(1 + powi(x3, 2)), l32 = 0.20*ln(1.60 + 0.90*cos(x4)), l33 = (1.08 + 0.27*powi(cos(0.46*x3 + 0.68), 3)), l41 = 0.36*1/sqrt(1.50 + powi(x4, 2)), l44 = (1.06 - 0.13*1/sqrt(1.50 + powi(x4, 2))))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, l11*l41],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l21*l41],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41],
    [_, _, _, l41*l41 + l44*l44],
))]
#[forces(
    p3*x3 - p1*exp(0.20*x1),
    1.41*dot(x2) - 0.95*powi(dot(x4), 2) - 1.41*powi(dot(x1), 2) - 0.80*dot(x1),
    0,
    p1*1.11 - p2*x4 - 0.97*dot(x3) - p1*x2,
)]
#[constraint(height: 1.49*x3 + 0.15*sin(x3) + exp(0.17*x2)/2 + exp(0.27*x1)/2 - 0.68 == 0)]
#[constraint(first: (1.50 - 0.22*cos(0.61*x2))*dot(x4) - 0.25*powi(cos(0.75*x1 + 0.37*x2), 3)*dot(x2) + 0.11*tan(0.92*sin(x1))/2*dot(x1) + 0.16*exp(-powi(x4, 2)/2)*dot(x3) - 0.57*sin(0.62*x1 - 0.53*x4) == 0)]
#[constraint(second: 1.49*dot(x3) + 0.15*cos(x3)*dot(x3) + 0.17*exp(0.17*x2)*dot(x2)/2 + 0.27*exp(0.27*x1)*dot(x1)/2 - 0.50*cos(0.64*x2 - 0.74*x2)*((1.50 - 0.22*cos(0.61*x2))*dot(x4) - 0.25*powi(cos(0.75*x1 + 0.37*x2), 3)*dot(x2) + 0.11*tan(0.92*sin(x1))/2*dot(x1) + 0.16*exp(-powi(x4, 2)/2)*dot(x3) - 0.57*sin(0.62*x1 - 0.53*x4)) == 0)]
#[independent(dot(x1), dot(x2))]
pub struct Random65 {
    #[nominal(1.19)]
    pub p1: f64,
    #[nominal(1.11)]
    pub p2: f64,
    #[nominal(1.10)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1) - 0.21*cos(0.47*x5 - 0.67*x5)*dot(x2) + 0.42*tan(0.82*sin(x3))/2,
    v2 = (1.27 - 0.30*sin(1.01*x5 + 0.76))*dot(x2) + 0.25*0.32*sin(x2)/(1.50 + cos(x5))*dot(x3) - 0.58*ln(1.60 + 0.34*cos(x3)),
    v3 = (1.25 + 0.23*tan(0.32*sin(x3))/2)*dot(x3) - 0.23*atan2(x3, 2 + cos(x2))/2,
    v4 = (1.21 - 0.31*sin(p2*x1 + 0.13))*dot(x4) + 0.56*1/sqrt(1.50 + powi(x5, 2)),
    v5 = 1.35*dot(x5) + 0.13*atan2(x3, 2 + cos(x5))/2*dot(x1) + 0.28*sin(1.20*x1 - 0.73*x2),
)]
#[inertia(matrix(
    [((1.24 - 0.32*sin(p3*x2 - 0.48)))*((1.24 - 0.32*sin(p3*x2 - 0.48))), ((1.24 - 0.32*sin(p3*x2 - 0.48)))*(0.34*tan(0.74*sin(x4))/2), 0, 0, ((1.24 - 0.32*sin(p3*x2 - 0.48)))*(0.22*atan2(x3, 2 + cos(x5))/2)],
    [_, (0.34*tan(0.74*sin(x4))/2)*(0.34*tan(0.74*sin(x4))/2) + ((1.17 - 0.17*x1/(1 + powi(x1, 2))))*((1.17 - 0.17*x1/(1 + powi(x1, 2)))), 0, 0, (0.34*tan(0.74*sin(x4))/2)*(0.22*atan2(x3, 2 + cos(x5))/2) + ((1.17 - 0.17*x1/(1 + powi(x1, 2))))*(0.22*cos(0.51*x5 + 0.85*x4))],
    [_, _, ((1.25 + 0.13*sin(0.61*x4 - 0.89*x2)))*((1.25 + 0.13*sin(0.61*x4 - 0.89*x2))), ((1.25 + 0.13*sin(0.61*x4 - 0.89*x2)))*(0.38*cos(0.60*x1 - 0.51*x4)), ((1.25 + 0.13*sin(0.61*x4 - 0.89*x2)))*(0.29*atan2(x5, 2 + cos(x3))/2)],
    [_, _, _, (0.38*cos(0.60*x1 - 0.51*x4))*(0.38*cos(0.60*x1 - 0.51*x4)) + (1.09)*(1.09), (0.38*cos(0.60*x1 - 0.51*x4))*(0.29*atan2(x5, 2 + cos(x3))/2)],
    [_, _, _, _, (0.22*atan2(x3, 2 + cos(x5))/2)*(0.22*atan2(x3, 2 + cos(x5))/2) + (0.22*cos(0.51*x5 + 0.85*x4))*(0.22*cos(0.51*x5 + 0.85*x4)) + (0.29*atan2(x5, 2 + cos(x3))/2)*(0.29*atan2(x5, 2 + cos(x3))/2) + ((1.30 - 0.24*tan(0.64*sin(x2))/2))*((1.30 - 0.24*tan(0.64*sin(x2))/2))],
))]
#[forces(
    v3*sqrt(2 + powi(v4, 2)) - p1*x3 - 1.95*powi(v3, 2) - v4*v4/(1.39 - 0.25*1/sqrt(1.50 + powi(x1, 2))),
    p3*v5*v4*ln(1.60 + 0.94*cos(x4)) + 1.62*v3,
    1.70*powi(v1, 2) - 0.64*v3 - p3*x4 - 1.70*powi(v1, 2),
    0,
    0.84*v1/(1 + powi(x3, 2)) - tau*1.97 - p1*x2 - p3*v2*v4*cos(0.87*x3 + 1.00),
)]
#[potential_energy(1/sqrt(1.50 + powi(x4, 2)))]
#[configuration(x4 = 0.65*x2/(1 + powi(x2, 2)))]
pub struct Random66 {
    #[nominal(0.95)]
    pub p1: f64,
    #[nominal(0.59)]
    pub p2: f64,
    #[nominal(1.29)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    dot(x1) = v1 - 0.10*x3/(1 + powi(x3, 2)),
    dot(x2) = (1.32 + 0.18*sin(0.77*x5 + 0.38))*v2 - 0.49*1/sqrt(1.50 + powi(x3, 2)),
    dot(x3) = v3 + 0.22*sin(p1*x5 - 0.69)*v1 - 0.19*cos(1.02*x2),
    dot(x4) = (1.02 + 0.31*cos(0.56*x1))*v4 - 0.25*tan(0.44*sin(x5))/2*v2 - 0.30*cos(0.54*x4 + 0.51*x1 + 0.52),
    dot(x5) = (1.28 - 0.13*ln(1.60 + 0.74*cos(x2)))*v5 - 0.12*1/sqrt(1.50 + powi(x5, 2)),
)]
#[define(l11 = 1.07, l21 = 0.25*0.37*sin(x4)/(1.50 + cos(x2)), l22 = (1.25 - 0.34*x1/(1 + powi(x1, 2))), l31 = 0.23*ln(1.60 + 0.64*cos(x2)), l33 = 1.29, l41 = 0.10*sin(p1*x5 - 0.24), l42 = 0.37*powi(cos(0.40*x1 - 0.55*x3 - 0.64), 3), l44 = 1.06, l51 = 0.24*cos(1.18*x3), l52 = 0.16*sin(0.52*x5 + 0.37*x4), l53 = 0.26*tan(0.32*sin(x1))/2, l54 = 0.20*exp(-powi(x3, 2)/2), l55 = (1.24 - 0.10*tan(0.72*sin(x2))/2))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, l11*l41, l11*l51],
    [_, l21*l21 + l22*l22, l21*l31, l21*l41 + l22*l42, l21*l51 + l22*l52],
    [_, _, l31*l31 + l33*l33, l31*l41, l31*l51 + l33*l53],
    [_, _, _, l41*l41 + l42*l42 + l44*l44, l41*l51 + l42*l52 + l44*l54],
    [_, _, _, _, l51*l51 + l52*l52 + l53*l53 + l54*l54 + l55*l55],
))]
#[forces(
    p1*exp(0.20*x4) - 0.80*v5 - p1*v1*v5*powi(cos(1.01*x5 + 0.42*x1 + 1.20), 3),
    p1*x2 - p1*x3 - v2*v3/1.39,
    p1*x3 - p1*v5*v4*cos(0.47*x5 - 1.27) - p1*1.28,
    p1*0.59 + p1*v2*v5*powi(cos(0.78*x5), 3) + 0.83*v1/(1 + powi(x3, 2)),
    1.69*1/sqrt(1.50 + powi(x1, 2)) - 1.11*1/sqrt(1.50 + powi(x3, 2)) - v4*v1/1.36 - 1.03*tan(0.48*sin(x1))/2,
)]
#[configuration(of(q1, q2, q3), x2 = 1.25*q1, x4 = 1.25*q2, x3 = 1.25*q3, x5 = cos(0.89*q1), x1 = cos(0.58*q3))]
#[constraint(held_x5: x5 - (cos(0.89*(x2/1.25))) == 0)]
#[constraint(held_x1: x1 - (cos(0.58*(x3/1.25))) == 0)]
pub struct Random67 {
    #[nominal(0.50)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + tan(0.81*sin(x5))/2*dot(x1),
    v3 = dot(x3) + exp(-powi(x3, 2)/2)*dot(x2),
    v4 = dot(x4) + cos(0.49*x4)*dot(x3),
    v5 = dot(x5) + powi(cos(0.91*x1 - 1.27), 3)*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - tan(0.81*sin(x5))/2*(v1),
    dot(x3) = v3 - exp(-powi(x3, 2)/2)*(v2 - tan(0.81*sin(x5))/2*(v1)),
    dot(x4) = v4 - cos(0.49*x4)*(v3 - exp(-powi(x3, 2)/2)*(v2 - tan(0.81*sin(x5))/2*(v1))),
    dot(x5) = v5 - powi(cos(0.91*x1 - 1.27), 3)*(v2 - tan(0.81*sin(x5))/2*(v1)),
)]
#[inertia(diag(1.16, 1.28, (1.18 - 0.27*sin(0.76*x5 + 0.24*x4 - 1.31)), (1.25 + 0.22*sin(0.63*x1 + 0.50*x3)), 1.23))]
#[forces(
    p2*1.49 - 0.56*v3/(1 + powi(x3, 2)) - 1.33*v3/(1 + powi(x4, 2)),
    p2*x5 + v3*v5/1.17,
    p2*exp(0.20*x3) - 1.17*powi(v3, 2),
    1.61*v4 + v1*v1/1.01 + p1*exp(0.20*x5),
    p3*1.94 + v5*sqrt(2 + powi(v3, 2)) + v1*v2/(1.01 + 0.13*ln(1.60 + 0.82*cos(x4))),
)]
#[constraint(row1: 1.25*x4 + 0.40*powi(x1, 2)/2 + 0.33 == 0)]
#[constraint(row2: 1.74*x3 + 0.24*powi(x1, 2)/2 + 0.21*x4*x4 + 0.70 == 0)]
#[constraint(row3: v5 - 0.11*sin(0.84*x2 - 0.42*x2 + 0.83)*v1 + 0.16*1/sqrt(1.50 + powi(x4, 2))*v4 + 0.28*ln(1.60 + 0.58*cos(x3))*v3 + 0.34*sin(1.13*x4 - 0.52) == 0)]
#[constraint(row4: 1.34*v2 + 0.30*exp(-powi(x2, 2)/2)*v1 + 0.15*sin(0.49*x5 - 0.14)*cos(0.94*x1)*v4 == 0)]
#[independent(v1)]
pub struct Random70 {
    #[nominal(0.78)]
    pub p1: f64,
    #[nominal(1.41)]
    pub p2: f64,
    #[nominal(1.01)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[define(l11 = (1.24 - 0.11*sin(p1*x2 - 0.10)), l21 = 0.16*sin(0.93*x3 + 0.34*x3 - 1.37)*cos(0.66*x3 + 0.70*x4), l22 = (1.05 + 0.23*cos(0.71*x5 - 0.34*x5)), l32 = 0.35*exp(-powi(x5, 2)/2), l33 = (1.34 - 0.27*atan2(x5, 2 + cos(x4))/2), l41 = 0.27*ln(1.60 + 0.76*cos(x4)), l42 = 0.27*sin(p1*x2 + 0.48), l43 = 0.40*1/sqrt(1.50 + powi(x4, 2)), l44 = (1.30 - 0.22*tan(0.70*sin(x3))/2), l51 = 0.34*exp(-powi(x1, 2)/2), l53 = 0.12*tan(0.75*sin(x5))/2, l54 = 0.38*powi(cos(0.40*x1 + 0.81*x5 + 1.13), 3), l55 = (1.40 - 0.29*powi(cos(0.98*x4 + 0.10), 3)))]
#[inertia(matrix(
    [l11*l11, l11*l21, 0, l11*l41, l11*l51],
    [_, l21*l21 + l22*l22, l22*l32, l21*l41 + l22*l42, l21*l51],
    [_, _, l32*l32 + l33*l33, l32*l42 + l33*l43, l33*l53],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44, l41*l51 + l43*l53 + l44*l54],
    [_, _, _, _, l51*l51 + l53*l53 + l54*l54 + l55*l55],
))]
#[forces(
    p1*x2 - 1.69*sin(1.01*x3) - p1*dot(x1)*dot(x2)*sin(p1*x4 - 0.34) - p1*dot(x1)*dot(x2)*1/sqrt(1.50 + powi(x1, 2)),
    p1*1.51 + p1*x4,
    0,
    dot(x1)*sqrt(2 + powi(dot(x1), 2)),
    1.41*dot(x4) + 1.68*dot(x3) + dot(x5)*sqrt(2 + powi(dot(x2), 2)) + 1.49*1/sqrt(1.50 + powi(x4, 2)),
)]
#[constraint(row1: 1.60*x3 - 0.58 == 0)]
#[constraint(row2: 1.89*x5 + 0.29*sin(x5) + exp(0.17*x3)/2 - 0.78 == 0)]
#[constraint(row3: 1.92*x1 + 0.10*sin(x1) + exp(0.36*x3)/2 + 0.30*x5 + 0.26 == 0)]
#[constraint(row4: (1.50 - 0.13*ln(1.60 + 0.69*cos(x3)))*dot(x2) - 0.22*cos(0.93*x4 - 0.74*x3)*dot(x3) - 0.29*sin(p1*x2 + 0.23)*dot(x5) == 0)]
#[constraint(row5: dot(x4) + 0.28*1/sqrt(1.50 + powi(x1, 2))*dot(x3) + 0.16*exp(-powi(x3, 2)/2)*dot(x5) + 0.32*exp(-powi(x1, 2)/2)*dot(x1) == 0)]
pub struct Random71 {
    #[nominal(0.54)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[inertia(matrix(
    [((1.36 + 0.26*atan2(x2, 2 + cos(x5))/2))*((1.36 + 0.26*atan2(x2, 2 + cos(x5))/2)), ((1.36 + 0.26*atan2(x2, 2 + cos(x5))/2))*(0.31*1/sqrt(1.50 + powi(x2, 2))), ((1.36 + 0.26*atan2(x2, 2 + cos(x5))/2))*(0.20*tan(0.60*sin(x2))/2), ((1.36 + 0.26*atan2(x2, 2 + cos(x5))/2))*(0.35*tan(0.95*sin(x5))/2), 0],
    [_, (0.31*1/sqrt(1.50 + powi(x2, 2)))*(0.31*1/sqrt(1.50 + powi(x2, 2))) + (1.27)*(1.27), (0.31*1/sqrt(1.50 + powi(x2, 2)))*(0.20*tan(0.60*sin(x2))/2), (0.31*1/sqrt(1.50 + powi(x2, 2)))*(0.35*tan(0.95*sin(x5))/2) + (1.27)*(0.11*1/sqrt(1.50 + powi(x1, 2))), (1.27)*(0.36*sin(0.46*x3))],
    [_, _, (0.20*tan(0.60*sin(x2))/2)*(0.20*tan(0.60*sin(x2))/2) + ((1.15 + 0.35*cos(0.92*x4 + 0.33*x1 + 0.57)))*((1.15 + 0.35*cos(0.92*x4 + 0.33*x1 + 0.57))), (0.20*tan(0.60*sin(x2))/2)*(0.35*tan(0.95*sin(x5))/2) + ((1.15 + 0.35*cos(0.92*x4 + 0.33*x1 + 0.57)))*(0.35*sin(0.84*x4 - 0.39)*cos(0.59*x2 - 0.41*x4)), 0],
    [_, _, _, (0.35*tan(0.95*sin(x5))/2)*(0.35*tan(0.95*sin(x5))/2) + (0.11*1/sqrt(1.50 + powi(x1, 2)))*(0.11*1/sqrt(1.50 + powi(x1, 2))) + (0.35*sin(0.84*x4 - 0.39)*cos(0.59*x2 - 0.41*x4))*(0.35*sin(0.84*x4 - 0.39)*cos(0.59*x2 - 0.41*x4)) + ((1.02 - 0.11*exp(-powi(x5, 2)/2)))*((1.02 - 0.11*exp(-powi(x5, 2)/2))), (0.11*1/sqrt(1.50 + powi(x1, 2)))*(0.36*sin(0.46*x3)) + ((1.02 - 0.11*exp(-powi(x5, 2)/2)))*(0.23*sin(1.09*x1))],
    [_, _, _, _, (0.36*sin(0.46*x3))*(0.36*sin(0.46*x3)) + (0.23*sin(1.09*x1))*(0.23*sin(1.09*x1)) + (1.21)*(1.21)],
))]
#[forces(
    dot(x1)*sqrt(2 + powi(dot(x1), 2)) + p3*1.52,
    0.91*dot(x1)/(1 + powi(x5, 2)),
    p1*x2,
    p2*x3 + 0.46*powi(dot(x1), 2) + p1*1.59 + p3*1.03,
    1.57*dot(x5)/(1 + powi(x1, 2)) + 1.51*dot(x2)/(1 + powi(x4, 2)) + 1.74*dot(x3) + dot(x5)*sqrt(2 + powi(dot(x5), 2)),
)]
#[potential_energy(tan(0.65*sin(x2))/2)]
#[constraint(row1: 1.64*x4 + 0.16*sin(x4) + 0.32*sin(x1) + exp(0.17*x3)/2 - 0.15 == 0)]
#[constraint(row2: 1.73*x5 + 0.15*sin(x5) + exp(0.28*x1)/2 + 0.30*x3*x2 + 0.27*x2*x3 - 0.55 == 0)]
pub struct Random78 {
    #[nominal(0.69)]
    pub p1: f64,
    #[nominal(1.41)]
    pub p2: f64,
    #[nominal(0.99)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + cos(0.59*x4 + 1.45)*dot(x1),
    v3 = dot(x3) + 1/sqrt(1.50 + powi(x4, 2))*dot(x1),
    v4 = dot(x4) + sin(1.17*x3 + 0.71*x2)*cos(0.83*x3 + 0.33*x3)*dot(x1),
    v5 = dot(x5) + atan2(x3, 2 + cos(x4))/2*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - cos(0.59*x4 + 1.45)*(v1),
    dot(x3) = v3 - 1/sqrt(1.50 + powi(x4, 2))*(v1),
    dot(x4) = v4 - sin(1.17*x3 + 0.71*x2)*cos(0.83*x3 + 0.33*x3)*(v1),
    dot(x5) = v5 - atan2(x3, 2 + cos(x4))/2*(v1),
)]
#[inertia(matrix(
    [((1.06 + 0.20*atan2(x5, 2 + cos(x4))/2))*((1.06 + 0.20*atan2(x5, 2 + cos(x4))/2)), 0, ((1.06 + 0.20*atan2(x5, 2 + cos(x4))/2))*(0.24*sin(1.06*x3)), 0, ((1.06 + 0.20*atan2(x5, 2 + cos(x4))/2))*(0.22*ln(1.60 + 0.54*cos(x5)))],
    [_, ((1.13 - 0.22*sin(0.62*x1 + 0.64*x2)))*((1.13 - 0.22*sin(0.62*x1 + 0.64*x2))), 0, ((1.13 - 0.22*sin(0.62*x1 + 0.64*x2)))*(0.32*cos(0.75*x2 - 0.80*x4 - 1.00)), ((1.13 - 0.22*sin(0.62*x1 + 0.64*x2)))*(0.22*atan2(x5, 2 + cos(x4))/2)],
    [_, _, (0.24*sin(1.06*x3))*(0.24*sin(1.06*x3)) + ((1.14 - 0.13*cos(1.19*x4)))*((1.14 - 0.13*cos(1.19*x4))), ((1.14 - 0.13*cos(1.19*x4)))*(0.20*sin(0.88*x3 + 0.38*x2)), (0.24*sin(1.06*x3))*(0.22*ln(1.60 + 0.54*cos(x5))) + ((1.14 - 0.13*cos(1.19*x4)))*(0.13*0.85*sin(x5)/(1.50 + cos(t)))],
    [_, _, _, (0.32*cos(0.75*x2 - 0.80*x4 - 1.00))*(0.32*cos(0.75*x2 - 0.80*x4 - 1.00)) + (0.20*sin(0.88*x3 + 0.38*x2))*(0.20*sin(0.88*x3 + 0.38*x2)) + ((1.02 + 0.13*1/sqrt(1.50 + powi(t, 2))))*((1.02 + 0.13*1/sqrt(1.50 + powi(t, 2)))), (0.32*cos(0.75*x2 - 0.80*x4 - 1.00))*(0.22*atan2(x5, 2 + cos(x4))/2) + (0.20*sin(0.88*x3 + 0.38*x2))*(0.13*0.85*sin(x5)/(1.50 + cos(t))) + ((1.02 + 0.13*1/sqrt(1.50 + powi(t, 2))))*(0.31*1/sqrt(1.50 + powi(t, 2)))],
    [_, _, _, _, (0.22*ln(1.60 + 0.54*cos(x5)))*(0.22*ln(1.60 + 0.54*cos(x5))) + (0.22*atan2(x5, 2 + cos(x4))/2)*(0.22*atan2(x5, 2 + cos(x4))/2) + (0.13*0.85*sin(x5)/(1.50 + cos(t)))*(0.13*0.85*sin(x5)/(1.50 + cos(t))) + (0.31*1/sqrt(1.50 + powi(t, 2)))*(0.31*1/sqrt(1.50 + powi(t, 2))) + ((1.39 - 0.22*sin(1.03*x3)))*((1.39 - 0.22*sin(1.03*x3)))],
))]
#[forces(
    p1*v2*v2*sin(0.86*t + 1.50) + 1.46*v2/(1 + powi(x1, 2)) + v2*v2/(1.16 - 0.25*1/sqrt(1.50 + powi(x1, 2))) + 1.46*powi(v5, 2),
    0,
    1.06*v1/(1 + powi(x2, 2)) - v4*sqrt(2 + powi(v3, 2)) - 0.56*powi(v1, 2) - 1.57*v2/(1 + powi(x1, 2)),
    p3*1.98 - p1*exp(0.20*x4) - v4*sqrt(2 + powi(v1, 2)),
    v5*sqrt(2 + powi(v5, 2)) - p3*x3,
)]
pub struct Random80 {
    #[nominal(1.25)]
    pub p1: f64,
    #[nominal(1.23)]
    pub p2: f64,
    #[nominal(1.40)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    dot(x1) = v1 - 0.16*0.50*sin(x2)/(1.50 + cos(x1))*v2 + 0.23*sin(p1*x4 + 0.20),
    dot(x2) = v2 - 0.59*sin(1.17*x4 + 0.53),
    dot(x3) = 1.22*v3 + 0.23*sin(0.69*x2 - 0.73*x2)*cos(0.46*x5 - 0.86*x4),
    dot(x4) = (1.08 + 0.29*sin(0.67*x1))*v4 - 0.17*sin(0.61*x1)*v1 - 0.16*atan2(x3, 2 + cos(x5))/2,
    dot(x5) = (1.07 + 0.27*tan(0.70*sin(x2))/2)*v5 + 0.10*1/sqrt(1.50 + powi(x5, 2))*v4 + 0.16*atan2(x1, 2 + cos(x2))/2,
)]
#[inertia(diag(1.29, (1.32 - 0.14*1/sqrt(1.50 + powi(x5, 2))), (1.07 + 0.23*exp(-powi(x3, 2)/2)), (1.18 - 0.22*ln(1.60 + 0.55*cos(x3))), (1.15 - 0.24*tan(0.42*sin(x1))/2)))]
#[forces(
    0,
    p2*v1*v4*1/sqrt(1.50 + powi(x5, 2)) + p3*exp(0.20*x5) + p1*v4*v2*x4/(1 + powi(x4, 2)),
    p2*exp(0.20*x5) + 0.98*v3/(1 + powi(x4, 2)) + p1*1.68 + p1*exp(0.20*x2),
    v3*sqrt(2 + powi(v1, 2)) + v3*sqrt(2 + powi(v4, 2)) + v5*sqrt(2 + powi(v3, 2)) + p1*v5*v5*ln(1.60 + 0.85*cos(x4)),
    0,
)]
#[potential_energy(1/sqrt(1.50 + powi(x4, 2)))]
#[constraint(row1: v1 - 0.12*atan2(x4, 2 + cos(x2))/2*v5 == 0)]
#[constraint(row2: v3 + 0.22*atan2(x3, 2 + cos(x3))/2*v5 - 0.19*sin(p3*x2 - 0.11)*v1 == 0)]
#[constraint(row3: v2 - 0.14*atan2(x4, 2 + cos(x5))/2*v5 - 0.23*sin(0.50*x5)*cos(0.63*x3 + 0.49*x4 + 1.07) == 0)]
#[constraint(row4: (1.50 + 0.18*1/sqrt(1.50 + powi(x2, 2)))*v4 + 0.25*cos(1.01*x5 + 0.32*x3)*v5 + 0.14*0.41*sin(x4)/(1.50 + cos(x5))*v1 + 0.21*tan(0.56*sin(x5))/2*v3 == 0)]
pub struct Random81 {
    #[nominal(1.48)]
    pub p1: f64,
    #[nominal(1.19)]
    pub p2: f64,
    #[nominal(1.35)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inertia(diag((1.26 - 0.15*sin(0.93*x2)), (1.32 - 0.23*tan(0.46*sin(x2))/2), (1.03 + 0.14*cos(0.78*x1 - 0.51*x4)), (1.11 - 0.21*cos(0.56*x2)), 1.18, (1.11 + 0.10*ln(1.60 + 0.37*cos(x2)))))]
#[forces(
    0.55*0.78*sin(x4)/(1.50 + cos(x5)) + p1*0.95,
    0.96*dot(x6) + dot(x3)*sqrt(2 + powi(dot(x2), 2)) + 1.71*atan2(x5, 2 + cos(x1))/2,
    0.41*ln(1.60 + 0.75*cos(x3)),
    0,
    dot(x3)*dot(x2)/(1.05 + 0.19*sin(0.58*x4 + 0.46*x1)) + dot(x2)*sqrt(2 + powi(dot(x6), 2)),
    p2*1.30 - 1.96*powi(dot(x2), 2),
)]
#[constraint(row1: 1.41*x3 + exp(0.35*x6)/2 + exp(0.32*x5)/2 + 0.14*x2*x5 + 0.30*sin(0.64*t) - 0.38 == 0)]
#[constraint(row2: 1.55*x1 + 0.25*powi(x6, 2)/2 + 0.21*x5 + 0.13*powi(x2, 2)/2 + 0.30*sin(0.97*t) + 0.19 == 0)]
#[independent(dot(x4), dot(x2), dot(x5), dot(x6))]
pub struct Random82 {
    #[nominal(1.04)]
    pub p1: f64,
    #[nominal(1.12)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + ln(1.60 + 0.94*cos(x1))*dot(x1),
    v3 = dot(x3) + tan(0.86*sin(x1))/2*dot(x2),
    v4 = dot(x4) + cos(0.48*x4)*dot(x3),
    v5 = dot(x5) + 0.45*sin(x5)/(1.50 + cos(x3))*dot(x3),
    dot(x1) = v1,
    dot(x2) = v2 - ln(1.60 + 0.94*cos(x1))*(v1),
    dot(x3) = v3 - tan(0.86*sin(x1))/2*(v2 - ln(1.60 + 0.94*cos(x1))*(v1)),
    dot(x4) = v4 - cos(0.48*x4)*(v3 - tan(0.86*sin(x1))/2*(v2 - ln(1.60 + 0.94*cos(x1))*(v1))),
    dot(x5) = v5 - 0.45*sin(x5)/(1.50 + cos(x3))*(v3 - tan(0.86*sin(x1))/2*(v2 - ln(1.60 + 0.94*cos(x1))*(v1))),
)]
#[inertia(diag(1.24, (1.24 - 0.18*sin(1.09*x1 + 0.46)*cos(0.51*x4 + 0.41*x1 - 1.32)), 1.29, (1.19 + 0.10*powi(cos(1.14*x4 + 0.19), 3)), 1.09))]
#[forces(
    0.62*1/sqrt(1.50 + powi(x2, 2)),
    p1*exp(0.20*x2) - 1.40*powi(v2, 2) - 0.62*v2 - p1*exp(0.20*x5),
    p1*v5*v4*sin(p1*x5 + 0.97),
    v4*v1/(1.21 - 0.21*ln(1.60 + 0.55*cos(x3))) - v5*v3/1.11 - v4*sqrt(2 + powi(v3, 2)) - v1*v2/1.30,
    p1*v2*v4*0.52*sin(x1)/(1.50 + cos(x4)) - p1*exp(0.20*x2) - p1*x4,
)]
#[constraint(row1: 1.53*x5 + exp(0.20*x3)/2 - 0.59 == 0)]
#[constraint(row2: (1.50 - 0.23*tan(0.73*sin(x5))/2)*v1 - 0.14*exp(-powi(x3, 2)/2)*v3 + 0.22*sin(0.66*x3 + 0.66*x1)*cos(0.61*x1 + 0.86*x3)*v2 - 0.18*cos(0.53*x4 - 0.17)*v5 + 0.37*atan2(x4, 2 + cos(x3))/2 == 0)]
#[constraint(row3: v4 - 0.27*ln(1.60 + 0.85*cos(x5))*v3 + 0.34*sin(1.05*x3 + 0.30)*cos(0.82*x1 - 0.64*x4)*v2 + 0.18*ln(1.60 + 0.94*cos(x2))*v5 == 0)]
#[independent(v2, v3)]
pub struct Random83 {
    #[nominal(0.65)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = 1.31*v1 + 0.23*atan2(x6, 2 + cos(x4))/2*v5,
    dot(x2) = (1.11 + 0.29*cos(1.03*x3))*v2,
    dot(x3) = v3 - 0.10*ln(1.60 + 0.38*cos(x3))*v1,
    dot(x4) = v4,
    dot(x5) = v5 + 0.16*sin(0.96*x5)*v2,
    dot(x6) = v6 + 0.34*1/sqrt(1.50 + powi(x5, 2))*v1,
)]
#[define(l11 = (1.16 - 0.29*ln(1.60 + 0.47*cos(x6))), l21 = 0.19*0.99*sin(x6)/(1.50 + cos(x6)), l22 = 1.21, l33 = (1.25 + 0.18*ln(1.60 + 0.68*cos(x5))), l41 = 0.37*sin(p2*x3 + 0.74), l42 = 0.38*sin(p1*x2 + 0.78), l43 = 0.13*powi(cos(0.76*x4 + 0.22*x3), 3), l44 = 1.01, l51 = 0.37*powi(cos(0.81*t + 0.85*x2), 3), l52 = 0.17*sin(0.83*x4 + 0.14), l53 = 0.19*sin(0.91*x4)*cos(1.13*x5), l54 = 0.22*sin(p1*t - 0.36), l55 = (1.23 - 0.23*tan(0.57*sin(x6))/2), l61 = 0.29*x1/(1 + powi(x1, 2)), l62 = 0.39*sin(1.15*x2 + 0.90*x2), l64 = 0.31*sin(1.05*x5), l65 = 0.27*sin(p2*x1 + 0.52), l66 = (1.09 + 0.18*0.40*sin(t)/(1.50 + cos(x5))))]
#[inertia(matrix(
    [l11*l11, l11*l21, 0, l11*l41, l11*l51, l11*l61],
    [_, l21*l21 + l22*l22, 0, l21*l41 + l22*l42, l21*l51 + l22*l52, l21*l61 + l22*l62],
    [_, _, l33*l33, l33*l43, l33*l53, 0],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44, l41*l51 + l42*l52 + l43*l53 + l44*l54, l41*l61 + l42*l62 + l44*l64],
    [_, _, _, _, l51*l51 + l52*l52 + l53*l53 + l54*l54 + l55*l55, l51*l61 + l52*l62 + l54*l64 + l55*l65],
    [_, _, _, _, _, l61*l61 + l62*l62 + l64*l64 + l65*l65 + l66*l66],
))]
#[forces(
    p2*t,
    1.76*powi(v1, 2) + v3*sqrt(2 + powi(v5, 2)) + 1.98*v4,
    1.61*v4,
    1.91*powi(v6, 2) + 0.32*v4 + 0.79*v3 + 0.70*powi(v4, 2),
    0.73*v4,
    0.80*v3/(1 + powi(x5, 2)) + 0.34*exp(-powi(x6, 2)/2) + p1*x1 + 1.67*powi(v5, 2),
)]
#[constraint(height: 1.62*x2 + 0.10*sin(x2) + exp(0.15*x4)/2 + 0.12*x5*x4 + 0.30*sin(1.07*t) - 0.19 == 0)]
#[constraint(height_rate: 1.62*dot(x2) + 0.10*cos(x2)*dot(x2) + 0.15*exp(0.15*x4)*dot(x4)/2 + 0.12*(dot(x5)*x4 + x5*dot(x4)) + 0.30*1.07*cos(1.07*t) == 0)]
#[constraint(further: v6 + 0.12*1/sqrt(1.50 + powi(x1, 2))*v4 - 0.13*0.70*sin(x1)/(1.50 + cos(x2))*v5 + 0.32*cos(0.45*x6 - 0.74*x4)*v3 == 0)]
pub struct Random84 {
    #[nominal(0.99)]
    pub p1: f64,
    #[nominal(0.94)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = 1.22*dot(x1),
    v2 = (1.35 + 0.21*powi(cos(0.81*x1 - 0.40*x2), 3))*dot(x2),
    v3 = (1.28 + 0.24*exp(-powi(x4, 2)/2))*dot(x3) - 0.22*tan(0.31*sin(x3))/2*dot(x5),
    v4 = dot(x4) + 0.27*1/sqrt(1.50 + powi(x3, 2))*dot(x5),
    v5 = (1.14 + 0.32*x3/(1 + powi(x3, 2)))*dot(x5) + 0.37*cos(0.98*x2)*dot(x4),
)]
#[inertia(diag(1.21, 1.27, (1.37 + 0.23*sin(1.04*x4)), 1.37, (1.31 - 0.13*atan2(x3, 2 + cos(x5))/2)))]
#[forces(
    1.93*v3/(1 + powi(x3, 2)) - p1*0.81 - p1*v2*v3*sin(0.74*x3),
    1.68*v4 + v4*v2/(1.02 + 0.28*sin(0.89*x1)*cos(0.78*x5 - 0.20*x5 + 0.48)) + p1*1.50,
    1.78*v2/(1 + powi(x1, 2)) + 1.98*v1 + v1*v3/(1.28 + 0.24*0.49*sin(x5)/(1.50 + cos(x1))),
    p1*v1*v1*1/sqrt(1.50 + powi(x3, 2)),
    v5*v5/1.11 + p1*exp(0.20*x3) + v3*v5/(1.02 + 0.20*0.98*sin(x3)/(1.50 + cos(x4))) + p1*v3*v2*0.71*sin(x5)/(1.50 + cos(x5)),
)]
#[potential_energy(sin(0.87*x3 + 0.61*x1))]
#[constraint(height: 1.73*x2 + 0.17*sin(x2) + 0.27*sin(x3) - 0.19 == 0)]
#[constraint(first: v5 + 0.12*atan2(x2, 2 + cos(x5))/2*v3 - 0.11*powi(cos(1.12*x5 + 0.61*x1 - 0.82), 3)*v1 - 0.18*x4/(1 + powi(x4, 2))*v4 == 0)]
#[constraint(second: 1.73*dot(x2) + 0.17*cos(x2)*dot(x2) + 0.27*cos(x3)*dot(x3) - 0.50*tan(0.63*sin(x3))/2*(v5 + 0.12*atan2(x2, 2 + cos(x5))/2*v3 - 0.11*powi(cos(1.12*x5 + 0.61*x1 - 0.82), 3)*v1 - 0.18*x4/(1 + powi(x4, 2))*v4) == 0)]
pub struct Random85 {
    #[nominal(1.27)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inertia(matrix(
    [((1.31 - 0.29*x1/(1 + powi(x1, 2))))*((1.31 - 0.29*x1/(1 + powi(x1, 2)))), 0, ((1.31 - 0.29*x1/(1 + powi(x1, 2))))*(0.32*1/sqrt(1.50 + powi(x6, 2))), 0, ((1.31 - 0.29*x1/(1 + powi(x1, 2))))*(0.24*sin(1.07*x3 + 0.37*x3)), ((1.31 - 0.29*x1/(1 + powi(x1, 2))))*(0.19*cos(0.98*x3 - 0.63*x4))],
    [_, ((1.24 + 0.14*sin(p1*x2 - 0.53)))*((1.24 + 0.14*sin(p1*x2 - 0.53))), ((1.24 + 0.14*sin(p1*x2 - 0.53)))*(0.24*sin(p3*x1 + 0.26)), ((1.24 + 0.14*sin(p1*x2 - 0.53)))*(0.35*x2/(1 + powi(x2, 2))), 0, ((1.24 + 0.14*sin(p1*x2 - 0.53)))*(0.26*sin(1.12*x1))],
    [_, _, (0.32*1/sqrt(1.50 + powi(x6, 2)))*(0.32*1/sqrt(1.50 + powi(x6, 2))) + (0.24*sin(p3*x1 + 0.26))*(0.24*sin(p3*x1 + 0.26)) + ((1.32 + 0.33*tan(0.70*sin(x2))/2))*((1.32 + 0.33*tan(0.70*sin(x2))/2)), (0.24*sin(p3*x1 + 0.26))*(0.35*x2/(1 + powi(x2, 2))) + ((1.32 + 0.33*tan(0.70*sin(x2))/2))*(0.30*1/sqrt(1.50 + powi(x4, 2))), (0.32*1/sqrt(1.50 + powi(x6, 2)))*(0.24*sin(1.07*x3 + 0.37*x3)) + ((1.32 + 0.33*tan(0.70*sin(x2))/2))*(0.24*cos(0.87*x6)), (0.32*1/sqrt(1.50 + powi(x6, 2)))*(0.19*cos(0.98*x3 - 0.63*x4)) + (0.24*sin(p3*x1 + 0.26))*(0.26*sin(1.12*x1)) + ((1.32 + 0.33*tan(0.70*sin(x2))/2))*(0.37*cos(0.49*x4 - 0.88*x3))],
    [_, _, _, (0.35*x2/(1 + powi(x2, 2)))*(0.35*x2/(1 + powi(x2, 2))) + (0.30*1/sqrt(1.50 + powi(x4, 2)))*(0.30*1/sqrt(1.50 + powi(x4, 2))) + ((1.09 - 0.25*tan(0.39*sin(x2))/2))*((1.09 - 0.25*tan(0.39*sin(x2))/2)), (0.30*1/sqrt(1.50 + powi(x4, 2)))*(0.24*cos(0.87*x6)), (0.35*x2/(1 + powi(x2, 2)))*(0.26*sin(1.12*x1)) + (0.30*1/sqrt(1.50 + powi(x4, 2)))*(0.37*cos(0.49*x4 - 0.88*x3))],
    [_, _, _, _, (0.24*sin(1.07*x3 + 0.37*x3))*(0.24*sin(1.07*x3 + 0.37*x3)) + (0.24*cos(0.87*x6))*(0.24*cos(0.87*x6)) + (1.37)*(1.37), (0.24*sin(1.07*x3 + 0.37*x3))*(0.19*cos(0.98*x3 - 0.63*x4)) + (0.24*cos(0.87*x6))*(0.37*cos(0.49*x4 - 0.88*x3))],
    [_, _, _, _, _, (0.19*cos(0.98*x3 - 0.63*x4))*(0.19*cos(0.98*x3 - 0.63*x4)) + (0.26*sin(1.12*x1))*(0.26*sin(1.12*x1)) + (0.37*cos(0.49*x4 - 0.88*x3))*(0.37*cos(0.49*x4 - 0.88*x3)) + (1.13)*(1.13)],
))]
#[forces(
    0,
    p1*1.59,
    p2*dot(x4)*dot(x2)*powi(cos(0.95*x3 + 0.24*x5 + 0.35), 3) + 0.55*dot(x2)/(1 + powi(x1, 2)) + dot(x6)*sqrt(2 + powi(dot(x4), 2)),
    1.94*powi(dot(x6), 2) + 0.34*dot(x5)/(1 + powi(x4, 2)),
    1.63*dot(x6) + p1*exp(0.20*x4),
    dot(x5)*dot(x1)/1.33 + dot(x3)*dot(x5)/(1.06 + 0.17*0.83*sin(x5)/(1.50 + cos(x1))) + 1.36*dot(x2)/(1 + powi(x4, 2)),
)]
#[configuration(x2 = 1.33*sin(0.54*x6), x5 = 0.71*sin(p2*x1 - 0.28))]
pub struct Random86 {
    #[nominal(1.33)]
    pub p1: f64,
    #[nominal(0.85)]
    pub p2: f64,
    #[nominal(1.42)]
    pub p3: f64,
}

macro_rules! every_random_model {
    ($then:ident) => {
        $then! {
            Random0(p1, p2)
            Random1(p1)
            Random2(p1, p2)
            Random4(p1)
            Random5(p1)
            Random6(p1, p2)
            Random7(p1)
            Random8(p1)
            Random9(p1, p2, p3)
            Random10(p1, p2)
            Random11(p1, p2)
            Random18(p1, p2, p3)
            Random21(p1)
            Random22(p1)
            Random23(p1, p2)
            Random24(p1, p2)
            Random25(p1, p2, p3)
            Random26(p1, p2)
            Random27(p1)
            Random29(p1, p2, p3)
            Random30(p1)
            Random31(p1, p2)
            Random38(p1, p2, p3)
            Random40(p1)
            Random41(p1, p2, p3)
            Random42(p1, p2, p3)
            Random44(p1, p2, p3)
            Random45(p1)
            Random47(p1, p2, p3)
            Random48(p1)
            Random49(p1)
            Random50(p1, p2)
            Random58(p1, p2, p3)
            Random60(p1, p2)
            Random61(p1, p2)
            Random62(p1, p2)
            Random64(p1, p2)
            Random65(p1, p2, p3)
            Random66(p1, p2, p3)
            Random67(p1)
            Random70(p1, p2, p3)
            Random71(p1)
            Random78(p1, p2, p3)
            Random80(p1, p2, p3)
            Random81(p1, p2, p3)
            Random82(p1, p2)
            Random83(p1)
            Random84(p1, p2)
            Random85(p1)
            Random86(p1, p2, p3)
        }
    };
}
pub(crate) use every_random_model;
