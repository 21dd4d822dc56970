// Generated from tests/random: random models, and macros that name them all.

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
#[output(place = sin(0.44*t + 0.42), power = v1*v1/1.28, push = sin(0.56*t)*dot(v1) + v1*ddot(x1))]
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
#[output(place = sin(p1*t + 0.56), power = p1*x2 - 0.36*dot(x1)/(1 + powi(x2, 2)), push = ln(1.60 + 0.63*cos(x2))*ddot(x2) + dot(x2)*ddot(x2))]
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
#[output(place = powi(cos(0.44*x1), 3), power = p2*x1 + p1*v2*v2*x2/(1 + powi(x2, 2)), push = 0.96*sin(x2)/(1.50 + cos(x1))*dot(v2) + v2*ddot(x2))]
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
#[output(place = atan2(x2, 2 + cos(x2))/2, power = p1*exp(0.20*x2) + p1*x2, push = ln(1.60 + 0.67*cos(x1))*ddot(x2) + dot(x1)*ddot(x1))]
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
#[output(place = exp(-powi(x1, 2)/2), power = v2*v2/(1.02 + 0.26*ln(1.60 + 0.81*cos(x2))) - 0.31*v1/(1 + powi(t, 2)) - 1.11*v1, push = ln(1.60 + 0.99*cos(t))*dot(v1) + v1*ddot(x1))]
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
#[output(place = cos(1.15*x1 + 0.55*x1 - 0.75), power = p3*exp(0.20*x2) + 0.35*sin(0.95*t - 0.50*t) + 1.03*exp(-powi(x1, 2)/2) + p3*v2*v2*sin(1.00*x1), push = sin(1.02*t - 0.59*t)*dot(v2) + v1*ddot(x1), pull = (1.01 + 0.27*1/sqrt(1.50 + powi(x1, 2)))*reaction(row1) - push, share = pull/(1.07 + powi(reaction(row1), 2)))]
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
#[coordinates(x1)]
#[inertia(diag(1.26))]
#[forces(
    1.16*dot(x1)/(1 + powi(x1, 2)) - 0.39*dot(x1)/(1 + powi(x1, 2)),
)]
#[potential_energy(x1/(1 + powi(x1, 2)))]
#[constraint(row1: 1.99*ddot(x1) - 0.28*dot(x1) - 0.28*ln(1.60 + 0.92*cos(t)) == 0)]
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
#[inertia(diag((1.33 - 0.13*sin(0.68*x1)*cos(1.11*x1 - 0.23*x1)), 1.13))]
#[forces(
    1.33*dot(x2) + p1*exp(0.20*x2) + 0.81*dot(x1),
    0.53*ln(1.60 + 0.37*cos(x1)),
)]
#[constraint(row1: 1.82*x2 + 0.45 == 0)]
#[constraint(row2: powi(dot(x1), 2) + 0.16*powi(dot(x2), 2) - (2 + 0.16*exp(-powi(x1, 2)/2)) == 0)]
pub struct Random14 {
    #[nominal(1.20)]
    pub p1: f64,
    #[nominal(0.61)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + 1/sqrt(1.50 + powi(x3, 2))*dot(x1),
    v3 = dot(x3) + sin(0.60*x1)*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - 1/sqrt(1.50 + powi(x3, 2))*(v1),
    dot(x3) = v3 - sin(0.60*x1)*(v2 - 1/sqrt(1.50 + powi(x3, 2))*(v1)),
)]
#[inertia(matrix(
    [(1.32)*(1.32), (1.32)*(0.18*cos(0.46*x1)), (1.32)*(0.11*exp(-powi(x2, 2)/2))],
    [_, (0.18*cos(0.46*x1))*(0.18*cos(0.46*x1)) + ((1.08 + 0.33*atan2(x3, 2 + cos(x1))/2))*((1.08 + 0.33*atan2(x3, 2 + cos(x1))/2)), (0.18*cos(0.46*x1))*(0.11*exp(-powi(x2, 2)/2))],
    [_, _, (0.11*exp(-powi(x2, 2)/2))*(0.11*exp(-powi(x2, 2)/2)) + ((1.11 - 0.20*atan2(x3, 2 + cos(x1))/2))*((1.11 - 0.20*atan2(x3, 2 + cos(x1))/2))],
))]
#[forces(
    p3*exp(0.20*x1),
    1.48*v2 + p3*v1*v1*cos(0.87*x2),
    p1*x3,
)]
#[potential_energy(x2/(1 + powi(x2, 2)))]
#[constraint(row1: (1.50 - 0.18*sin(0.70*x3 + 0.76)*cos(0.78*x2 - 0.74*x3 + 0.22))*v1 == 0)]
#[constraint(row2: 1.89*v2 - 0.19*sin(v2 + 1/sqrt(1.50 + powi(x1, 2))*v1) - 0.37*sin(p1*x3 + 0.62) == 0)]
#[constraint(row3: (1.50 + 0.22*exp(-powi(x1, 2)/2))*dot(v3) + 0.20*powi(cos(0.74*x1 + 0.22), 3)*dot(v1) - 0.19*x1/(1 + powi(x1, 2))*dot(v2) - 0.56*v2/sqrt(1.20 + powi(v1, 2)) == 0)]
#[independent(v3, v2)]
#[output(place = cos(0.65*x2), power = p3*v1*v3*powi(cos(0.42*x1 + 0.38*x2), 3) - v2*sqrt(2 + powi(v3, 2)) - 1.65*v3 - 0.33*sin(p2*x3 + 0.91), push = atan2(x3, 2 + cos(x1))/2*dot(v2) + v1*ddot(x1), pull = (1.17 - 0.16*0.34*sin(x2)/(1.50 + cos(x3)))*reaction(row1) - push, share = pull/(1.72 + powi(reaction(row1), 2)))]
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
#[inertia(diag(1.02, (1.07 - 0.17*cos(1.11*x2 - 0.48*t + 0.72))))]
#[forces(
    dot(x1)*dot(x1)/1.25 - 0.59*atan2(x2, 2 + cos(x2))/2,
    dot(x1)*dot(x2)/1.35,
)]
#[potential_energy(atan2(x2, 2 + cos(x1))/2)]
#[constraint(row1: 1.83*dot(x1) + 0.22*sin(0.85*x2)*dot(x2)*dot(x2) + 0.56*t/(1 + powi(t, 2)) == 0)]
#[constraint(again1: (1.23 + 0.33*sin(0.66*t))*(1.83*dot(x1) + 0.22*sin(0.85*x2)*dot(x2)*dot(x2) + 0.56*t/(1 + powi(t, 2))) == 0, redundant)]
#[constraint(again2: (1.29 + 0.19*exp(-powi(t, 2)/2))*(1.83*dot(x1) + 0.22*sin(0.85*x2)*dot(x2)*dot(x2) + 0.56*t/(1 + powi(t, 2))) == 0, redundant)]
#[output(place = sin(0.87*t - 0.46), power = p3*exp(0.20*x2) + p1*x2, push = sin(1.16*t + 1.49)*cos(0.61*x1 - 0.71*x1)*ddot(x2) + dot(x1)*ddot(x1), pull = (1.01 + 0.27*powi(cos(0.40*x1), 3))*reaction(row1) - push, share = pull/(1.92 + powi(reaction(row1), 2)))]
pub struct Random17 {
    #[nominal(1.15)]
    pub p1: f64,
    #[nominal(1.15)]
    pub p2: f64,
    #[nominal(1.17)]
    pub p3: f64,
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
#[output(place = sin(0.73*x1 - 0.67*x2 + 0.61)*cos(0.94*x1 - 0.19), power = p1*1.46 + 1.46*powi(dot(x2), 2) + p1*exp(0.20*x2), push = atan2(x2, 2 + cos(x2))/2*ddot(x2) + dot(x1)*ddot(x1), pull = (1.35 - 0.23*0.92*sin(x2)/(1.50 + cos(x1)))*reaction(row2) - push, share = pull/(1.26 + powi(reaction(row2), 2)))]
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
#[inertia(diag((1.21 - 0.16*atan2(t, 2 + cos(t))/2), 1.39, (1.18 - 0.27*powi(cos(0.99*x1), 3))))]
#[forces(
    v1*v2/1.12 - p1*x1 - p1*v3*v3*atan2(t, 2 + cos(t))/2,
    p1*t + p1*x3,
    0.49*cos(0.63*x3 + 0.81*x2) + 0.74*v2 + 1.05*powi(v2, 2) + p1*v1*v3*1/sqrt(1.50 + powi(x1, 2)),
)]
#[configuration(x1 = 1.36*0.85*sin(x3)/(1.50 + cos(x3)), x2 = 0.93*sin(p1*t - 0.25))]
#[constraint(bound: ddot(x3) + 0.18*x1/(1 + powi(x1, 2))*dot(v1) + 0.16*powi(cos(1.05*x2), 3)*dot(v2) + 0.64*v1/sqrt(1.20 + powi(v3, 2)) == 0)]
pub struct Random19 {
    #[nominal(1.28)]
    pub p1: f64,
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
#[output(place = tan(0.77*sin(x1))/2, power = 1.51*powi(v2, 2) + v1*sqrt(2 + powi(v2, 2)), push = sin(0.62*x1 + 0.47*t)*dot(v2) + v1*ddot(x1), pull = (1.21 - 0.16*tan(0.80*sin(x1))/2)*reaction(row1) - push, share = pull/(1.99 + powi(reaction(row1), 2)))]
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
#[output(place = cos(0.42*x2), power = dot(x1)*dot(x1)/1.11 + 1.35*x2/(1 + powi(x2, 2)) + p1*0.90, push = powi(cos(0.85*x1 + 0.43*x2 + 0.56), 3)*ddot(x2) + dot(x2)*ddot(x2), pull = (1.35 + 0.32*sin(p1*x2 + 0.52))*reaction(row2) - push, share = pull/(1.46 + powi(reaction(row2), 2)))]
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
#[output(place = 0.71*sin(x1)/(1.50 + cos(x2)), power = 1.03*sin(0.50*x2 - 0.22*x1) - 0.83*v1/(1 + powi(x1, 2)) - p2*v1*v1*sin(p2*x1 + 0.11) - p1*x2, push = 0.88*sin(x2)/(1.50 + cos(x1))*dot(v1) + v2*ddot(x2))]
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
#[output(place = x1/(1 + powi(x1, 2)), power = 1.94*powi(dot(x1), 2), push = cos(0.77*x3 - 0.90*x1 - 0.26)*ddot(x1) + dot(x3)*ddot(x3))]
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
#[output(place = exp(-powi(t, 2)/2), power = 1.67*dot(x1) + dot(x2)*dot(x1)/(1.07 - 0.17*sin(p3*x1 + 0.24)) + p3*t + p1*0.97, push = tan(0.88*sin(x2))/2*ddot(x2) + dot(x1)*ddot(x1), pull = 1.39*reaction(row1) - push, share = pull/(1.71 + powi(reaction(row1), 2)))]
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
#[output(place = sin(0.70*x1 + 0.88*x2), power = 1.87*dot(x2) + dot(x3)*dot(x2)/(1.03 + 0.32*x1/(1 + powi(x1, 2))), push = powi(cos(0.95*x3 - 0.82*x2), 3)*ddot(x3) + dot(x1)*ddot(x1), pull = (1.28 + 0.17*x3/(1 + powi(x3, 2)))*reaction(row3) - push, share = pull/(1.32 + powi(reaction(row3), 2)))]
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
    dot(x1) = (1.18 - 0.22*0.69*sin(x2)/(1.50 + cos(x2)))*v1 + 0.57*cos(0.52*x1),
    dot(x2) = (1.36 - 0.17*ln(1.60 + 0.81*cos(x1)))*v2 + 0.31*sin(0.48*x1 + 0.82*x1)*v1 - 0.54*sin(1.02*x1),
)]
#[inertia(matrix(
    [(1.36)*(1.36), (1.36)*(0.38*ln(1.60 + 0.96*cos(x1)))],
    [_, (0.38*ln(1.60 + 0.96*cos(x1)))*(0.38*ln(1.60 + 0.96*cos(x1))) + (1.17)*(1.17)],
))]
#[forces(
    1.77*powi(v2, 2) - 0.38*sin(p1*x2 + 0.87) - v2*sqrt(2 + powi(v1, 2)),
    p1*1.01 + 0.39*powi(v2, 2) + p1*v2*v1*0.64*sin(x2)/(1.50 + cos(x1)),
)]
#[constraint(row1: 1.81*v2 == 0)]
#[constraint(row2: powi(v1, 2) + 0.27*powi(v2, 2) - (2 + 0.27*powi(cos(0.80*x1 - 0.65*x2), 3)) == 0)]
pub struct Random32 {
    #[nominal(1.05)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = v1 - 0.32*ln(1.60 + 0.56*cos(x2))*v2,
    dot(x2) = v2 - 0.17*sin(0.86*x1 + 0.75*x3 - 0.57)*v1,
    dot(x3) = 1.13*v3,
)]
#[inertia(diag((1.36 + 0.29*exp(-powi(x2, 2)/2)), (1.18 + 0.13*powi(cos(0.45*x2), 3)), (1.33 - 0.28*cos(0.42*x3 - 0.10))))]
#[forces(
    p1*x3 + p2*x2 + p2*x2,
    p2*x1 - 0.36*powi(v3, 2),
    p2*x2 - p2*exp(0.20*x3) - p1*1.55 - 0.69*v3/(1 + powi(x1, 2)),
)]
#[constraint(row1: dot(v3) - 0.36*v3/sqrt(1.20 + powi(v2, 2)) == 0)]
#[constraint(row2: dot(v2) + 0.15*sin(1.08*x2 - 0.34*x1)*dot(v3) - 0.27*v1 - 0.27*x3/(1 + powi(x3, 2)) == 0)]
#[constraint(row3: (1.50 + 0.22*sin(p2*x1 + 0.12))*dot(v1) - 0.16*sin(p2*x3 + 0.57)*dot(v3) - 0.14*exp(-powi(x2, 2)/2)*dot(v2) - 0.35*v2/sqrt(1.20 + powi(v1, 2)) == 0)]
#[output(place = tan(0.87*sin(x3))/2, power = v3*sqrt(2 + powi(v2, 2)) - p2*0.77 - p1*exp(0.20*x3) - p1*x3, push = exp(-powi(x3, 2)/2)*dot(v2) + v1*ddot(x1), pull = (1.04 - 0.32*ln(1.60 + 0.66*cos(x3)))*reaction(row3) - push, share = pull/(1.39 + powi(reaction(row3), 2)))]
pub struct Random33 {
    #[nominal(0.79)]
    pub p1: f64,
    #[nominal(0.56)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.26 + 0.29*exp(-powi(x3, 2)/2)), 1.22, 1.31))]
#[forces(
    0,
    p1*x3 - p2*x2,
    p1*0.59 - 0.31*ln(1.60 + 0.97*cos(x3)) - 0.81*powi(dot(x1), 2),
)]
#[constraint(row1: 1.58*x2 + 0.15*sin(x2) + 0.19 == 0)]
#[constraint(row2: 1.35*x3 + 0.23*sin(x3) + 0.13*x2*x2 + 0.31 == 0)]
#[constraint(row3: powi(dot(x1), 2) + 0.25*powi(dot(x2), 2) - (2 + 0.25*1/sqrt(1.50 + powi(x3, 2))) == 0)]
#[output(place = cos(0.84*x3), power = p2*exp(0.20*x1) - 1.11*dot(x3)/(1 + powi(x3, 2)) - p1*x1, push = sin(1.01*x3)*ddot(x3) + dot(x1)*ddot(x1), pull = (1.35 + 0.15*cos(0.45*x2 - 0.32*x3))*reaction(row3) - push, share = pull/(1.30 + powi(reaction(row3), 2)))]
pub struct Random34 {
    #[nominal(0.80)]
    pub p1: f64,
    #[nominal(0.61)]
    pub p2: f64,
    #[nominal(1.04)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = (1.30 - 0.18*0.98*sin(x2)/(1.50 + cos(t)))*v1 - 0.31*sin(1.13*x2)*v3 + 0.59*1/sqrt(1.50 + powi(x1, 2)),
    dot(x2) = (1.36 + 0.16*sin(0.55*x3 - 1.31))*v2 - 0.17*1/sqrt(1.50 + powi(x3, 2))*v3 + 0.56*0.89*sin(x3)/(1.50 + cos(x2)),
    dot(x3) = 1.02*v3 - 0.23*sin(0.52*x1 + 0.36*x2),
)]
#[inertia(diag((1.25 + 0.19*cos(1.14*t)), (1.21 + 0.23*sin(p1*x3 - 0.44)), (1.15 + 0.28*0.62*sin(t)/(1.50 + cos(t)))))]
#[forces(
    v3*v2/1.21 + p1*1.98 + v2*v3/(1.14 + 0.19*atan2(t, 2 + cos(t))/2) + p1*exp(0.20*x2),
    0,
    v2*v2/(1.26 + 0.33*sin(1.02*t - 0.86*x2)) - p1*x3 - 0.87*v3,
)]
#[constraint(row1: 1.33*x3 + 0.27*x1 + 0.30*sin(1.32*t) - 0.27 == 0)]
#[constraint(row2: 1.52*dot(v2) + 0.12*ln(1.60 + 0.38*cos(x2))*dot(v1) - 0.18*cos(0.42*x2 - 1.25)*dot(v3) + 0.45*v1 + 0.45*powi(cos(0.83*x3 - 0.88*t), 3) == 0)]
#[output(place = x2/(1 + powi(x2, 2)), power = 0.65*powi(v3, 2) - p1*v1*v3*cos(0.54*x2), push = exp(-powi(x2, 2)/2)*dot(v1) + v1*ddot(x1), pull = (1.12 + 0.28*sin(p1*x3 + 0.80))*reaction(row2) - push, share = pull/(1.95 + powi(reaction(row2), 2)))]
pub struct Random35 {
    #[nominal(1.15)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = 1.02*v1 - 0.22*atan2(x1, 2 + cos(x1))/2*v3 + 0.46*sin(0.72*x3 + 0.80*x2),
    dot(x2) = v2 + 0.30*1/sqrt(1.50 + powi(x3, 2))*v3 + 0.58*sin(0.74*x1 - 0.46*x3),
    dot(x3) = 1.05*v3 + 0.24*cos(1.12*x1)*v1 + 0.22*powi(cos(0.52*x1 + 0.75*x1), 3),
)]
#[define(l11 = (1.37 - 0.26*powi(cos(0.52*x2), 3)), l21 = 0.19*ln(1.60 + 0.66*cos(x2)), l22 = (1.08 + 0.18*atan2(x2, 2 + cos(x3))/2), l31 = 0.10*sin(0.97*x3 + 1.16), l32 = 0.25*powi(cos(1.09*x1 + 0.76*x3 - 1.19), 3), l33 = (1.38 - 0.34*exp(-powi(x2, 2)/2)))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32],
    [_, _, l31*l31 + l32*l32 + l33*l33],
))]
#[forces(
    0,
    p1*v3*v3*sin(1.08*x1 + 0.15),
    1.46*v1/(1 + powi(x1, 2)) - 0.33*sin(p1*x2 + 0.76) - p1*exp(0.20*x1) - 1.52*exp(-powi(x3, 2)/2),
)]
#[constraint(row1: 1.66*v1 + 0.53*cos(0.65*x1) == 0)]
#[constraint(row2: 1.37*v3 + 0.25*sqrt(1.50 + powi(v1, 2) + powi(v1, 2)) - 0.43*0.68*sin(x2)/(1.50 + cos(x2)) == 0)]
#[constraint(row3: 1.78*dot(v2) - 0.22*ln(1.60 + 0.95*cos(x3))*dot(v1) + 0.25*sin(0.60*x1 - 0.46)*dot(v3) + 0.79*v3*v3*tan(0.91*sin(x3))/2 == 0)]
#[output(place = sin(0.61*x2 + 0.97), power = 0.40*ln(1.60 + 0.89*cos(x1)) + p1*0.68, push = powi(cos(0.98*x3 - 0.51*x2 + 1.44), 3)*dot(v3) + v2*ddot(x2), pull = 1.34*reaction(row2) - push, share = pull/(1.00 + powi(reaction(row2), 2)))]
pub struct Random36 {
    #[nominal(0.54)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = (1.11 - 0.14*atan2(t, 2 + cos(x2))/2)*v1 + 0.27*cos(0.78*x2)*v2 + 0.53*sin(p3*t + 0.59),
    dot(x2) = v2 + 0.41*sin(0.87*t)*cos(0.97*x2 - 0.62*t - 1.08),
)]
#[define(l11 = (1.06 + 0.25*sin(1.04*t - 0.42*t)), l21 = 0.34*sin(1.07*t + 1.08)*cos(1.19*x2), l22 = (1.13 - 0.11*0.61*sin(x2)/(1.50 + cos(t))))]
#[inertia(matrix(
    [l11*l11, l11*l21],
    [_, l21*l21 + l22*l22],
))]
#[forces(
    tau*1.89 + 1.79*v2/(1 + powi(x1, 2)),
    1.86*powi(v1, 2) + 1.24*v1/(1 + powi(t, 2)) + v2*sqrt(2 + powi(v2, 2)),
)]
#[constraint(row1: ddot(x2) + 0.25*powi(cos(1.14*x1), 3)*dot(v1) - 0.66*v1 - 0.66*1/sqrt(1.50 + powi(x2, 2)) == 0)]
#[constraint(again1: 1.08*(ddot(x2) + 0.25*powi(cos(1.14*x1), 3)*dot(v1) - 0.66*v1 - 0.66*1/sqrt(1.50 + powi(x2, 2))) == 0, redundant)]
pub struct Random37 {
    #[nominal(0.78)]
    pub p1: f64,
    #[nominal(1.26)]
    pub p2: f64,
    #[nominal(1.02)]
    pub p3: f64,
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
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.17 - 0.21*sin(0.86*t - 0.44*x2)*cos(1.10*x3 - 0.74*x2)), (1.00 - 0.27*0.60*sin(x1)/(1.50 + cos(x3))), 1.00))]
#[forces(
    p2*x2 + 0.40*dot(x2)/(1 + powi(x1, 2)) + p2*0.68 + dot(x2)*sqrt(2 + powi(dot(x1), 2)),
    0,
    dot(x1)*sqrt(2 + powi(dot(x2), 2)) - 1.59*dot(x3),
)]
#[configuration(x3 = 0.68*cos(1.10*x2), x1 = 1.15*sin(0.99*x2 + 0.50*x2 - 1.40))]
#[constraint(held_x3: x3 - (0.68*cos(1.10*x2)) == 0)]
#[constraint(held_x1: x1 - (1.15*sin(0.99*x2 + 0.50*x2 - 1.40)) == 0)]
#[constraint(bound: powi(dot(x2), 2) + 0.19*powi(dot(x3), 2) - (2 + 0.19*sin(0.56*x1)*cos(1.00*x3)) == 0)]
#[output(place = cos(0.96*x1 + 0.25*x1), power = p2*x1, push = sin(0.66*x1 - 0.23*x1 + 1.20)*ddot(x2) + dot(x3)*ddot(x3), pull = 1.26*reaction(held_x3) - push, share = pull/(1.72 + powi(reaction(held_x3), 2)))]
pub struct Random39 {
    #[nominal(1.14)]
    pub p1: f64,
    #[nominal(1.27)]
    pub p2: f64,
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
#[output(place = 0.87*sin(x2)/(1.50 + cos(x1)), power = p1*v1*v2*ln(1.60 + 0.42*cos(x1)) + p1*exp(0.20*x2), push = 1/sqrt(1.50 + powi(x4, 2))*dot(v3) + v4*ddot(x4))]
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
#[independent(s1 = (1.50 - 0.20*exp(-powi(x1, 2)/2))*dot(x3) - 0.18*cos(0.93*x2)*dot(x1))]
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
#[independent(s1 = 1.70*v2 - 0.25*powi(cos(0.62*x3 + 0.59*x2), 3)*v3 + 0.45*ln(1.60 + 0.76*cos(x1)), s2 = 1.78*v1 + 0.29*sin(1.10*x4 + 0.80)*cos(1.17*t - 0.55)*v2)]
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
#[output(place = 1/sqrt(1.50 + powi(x3, 2)), power = p1*1.22 + p1*x1 + p1*exp(0.20*x1), push = tan(0.66*sin(x2))/2*ddot(x4) + dot(x4)*ddot(x4), pull = 1.32*reaction(row3) - push, share = pull/(1.81 + powi(reaction(row3), 2)))]
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
#[independent(s1 = (1.50 + 0.27*cos(0.75*x2))*v1 - 0.22*exp(-powi(x3, 2)/2)*v2)]
#[output(place = sin(0.99*x1 - 0.87*x4), power = p2*x2, push = tan(0.82*sin(x3))/2*dot(v1) + v2*ddot(x2), pull = 1.22*reaction(row3) - push, share = pull/(1.02 + powi(reaction(row3), 2)))]
pub struct Random50 {
    #[nominal(1.15)]
    pub p1: f64,
    #[nominal(0.92)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(diag(1.15, 1.12, (1.01 - 0.13*sin(0.84*x4)*cos(0.56*x2 + 0.25)), 1.14))]
#[forces(
    p1*dot(x3)*dot(x4)*0.70*sin(t)/(1.50 + cos(t)) - dot(x2)*dot(x4)/(1.14 - 0.22*ln(1.60 + 0.35*cos(t))) - dot(x3)*dot(x3)/1.30,
    1.10*exp(-powi(x2, 2)/2) + 1.28*powi(dot(x2), 2) + dot(x2)*sqrt(2 + powi(dot(x1), 2)) + p1*dot(x4)*dot(x3)*tan(0.59*sin(x2))/2,
    p1*x4,
    dot(x4)*dot(x1)/(1.08 + 0.24*cos(0.66*x1 - 0.89*x2)) - dot(x1)*sqrt(2 + powi(dot(x1), 2)),
)]
#[constraint(row1: 1.37*dot(x3) + 0.13*sin(0.50*x4)*dot(x2)*dot(x4) + 0.35*sin(1.16*x1 - 0.45) == 0)]
#[output(place = exp(-powi(x4, 2)/2), power = 1.55*x2/(1 + powi(x2, 2)) - 1.99*dot(x4)/(1 + powi(t, 2)) - p1*0.34, push = sin(p1*x1 - 0.72)*ddot(x1) + dot(x4)*ddot(x4), pull = 1.03*reaction(row1) - push, share = pull/(1.41 + powi(reaction(row1), 2)))]
pub struct Random52 {
    #[nominal(0.68)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(diag(1.09, (1.05 + 0.17*0.30*sin(t)/(1.50 + cos(x3))), (1.25 + 0.19*sin(1.19*x1 + 0.46*x4)), (1.02 + 0.17*1/sqrt(1.50 + powi(x3, 2)))))]
#[forces(
    p1*dot(x1)*dot(x2)*exp(-powi(x3, 2)/2) + dot(x3)*sqrt(2 + powi(dot(x3), 2)),
    p1*1.22 + p1*dot(x3)*dot(x3)*ln(1.60 + 0.74*cos(x2)) + 1.04*dot(x3)/(1 + powi(t, 2)) + 1.63*powi(dot(x2), 2),
    dot(x3)*dot(x2)/(1.10 - 0.25*ln(1.60 + 0.87*cos(x4))) - p1*exp(0.20*x3),
    1.91*powi(dot(x1), 2) + 1.64*cos(1.18*x4 + 0.81*x4),
)]
#[potential_energy(sin(0.80*x1 + 0.52*x1))]
#[constraint(row1: ddot(x3) - 0.17*sin(0.93*x3 - 0.14)*ddot(x1) - 0.25*sin(1.03*x4)*cos(0.43*x3 + 0.30*x3)*ddot(x2) + 0.71*dot(x4)*dot(x2)*0.70*sin(x3)/(1.50 + cos(x3)) == 0)]
#[constraint(row2: ddot(x4) + 0.30*x2/(1 + powi(x2, 2))*ddot(x1) - 0.12*sin(0.93*x1)*ddot(x2) + 0.69*dot(x3)*dot(x1)*1/sqrt(1.50 + powi(t, 2)) == 0)]
pub struct Random53 {
    #[nominal(0.57)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    v1 = (1.18 - 0.22*x3/(1 + powi(x3, 2)))*dot(x1) + 0.16*exp(-powi(x2, 2)/2)*dot(x2),
    v2 = dot(x2),
    v3 = (1.06 + 0.17*sin(0.53*x2 + 0.68*x2))*dot(x3) + 0.20*x2/(1 + powi(x2, 2))*dot(x2),
)]
#[inertia(diag(1.32, (1.02 - 0.18*sin(0.61*x1 - 0.88*x2 - 0.98)*cos(0.54*x2 - 0.59)), 1.22))]
#[forces(
    p1*v2*v2*x2/(1 + powi(x2, 2)),
    1.16*sin(0.41*x3 + 0.42*x2)*cos(1.09*x1 + 0.35*x1 + 1.12) - 1.49*v3 - 1.61*v1/(1 + powi(x3, 2)) - 0.58*v2/(1 + powi(x3, 2)),
    tau*1.68 - v3*sqrt(2 + powi(v1, 2)) - 0.31*v1/(1 + powi(x2, 2)),
)]
#[potential_energy(sin(p2*x1 + 0.86))]
#[constraint(row1: 1.08*v2 == 0)]
#[constraint(row2: (1.50 - 0.22*cos(0.89*x3 - 0.30*x3 + 0.97))*v1 + 0.22*sin(0.79*x1 - 0.60*x2)*v2 == 0)]
#[constraint(row3: ddot(x3) + 0.17*0.56*sin(x3)/(1.50 + cos(x2))*dot(v2) - 0.17*ln(1.60 + 0.84*cos(x1))*dot(v1) + 0.38*v3*v2*atan2(x1, 2 + cos(x2))/2 == 0)]
#[output(place = exp(-powi(x2, 2)/2), power = tau*1.50 - p2*v1*v3*sin(0.52*x2 - 1.37) - 1.49*powi(v2, 2) - p1*x1, push = ln(1.60 + 0.69*cos(x1))*dot(v2) + v3*ddot(x3), pull = 1.29*reaction(row1) - push, share = pull/(1.85 + powi(reaction(row1), 2)))]
pub struct Random55 {
    #[nominal(0.77)]
    pub p1: f64,
    #[nominal(0.75)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.34 + 0.17*sin(p1*x3 - 0.32)), (1.07 - 0.16*sin(0.76*x3 + 0.54*t)*cos(0.50*x3)), (1.03 - 0.27*x3/(1 + powi(x3, 2)))))]
#[forces(
    p1*x1 + p1*dot(x2)*dot(x1)*exp(-powi(t, 2)/2) + 1.20*dot(x2) + p1*t,
    dot(x1)*sqrt(2 + powi(dot(x3), 2)) + p1*dot(x2)*dot(x2)*x2/(1 + powi(x2, 2)) + 1.58*powi(dot(x1), 2),
    p1*exp(0.20*t) - 1.46*dot(x2) - 0.83*dot(x2)/(1 + powi(x2, 2)) - dot(x3)*dot(x3)/(1.37 + 0.34*exp(-powi(x3, 2)/2)),
)]
#[constraint(row1: (1.50 - 0.16*sin(p1*t - 0.82))*dot(x3) == 0)]
#[constraint(row2: 1.31*dot(x2) + 0.23*sin(dot(x2) + powi(cos(0.93*x3 - 0.77*x1), 3)*dot(x3)) - 0.58*sin(0.42*t) == 0)]
#[constraint(row3: ddot(x1) + 0.23*sin(0.63*x3)*ddot(x3) + 0.25*tan(0.99*sin(x1))/2*ddot(x2) + 0.20*powi(cos(1.02*t - 0.30*t), 3) == 0)]
#[output(place = 0.39*sin(x1)/(1.50 + cos(x3)), power = 1.00*dot(x3) - 0.63*dot(x1)/(1 + powi(t, 2)) - p1*x2 - dot(x1)*dot(x3)/(1.17 + 0.20*exp(-powi(x2, 2)/2)), push = sin(0.64*x2 - 0.55*t)*ddot(x3) + dot(x2)*ddot(x2), pull = 1.37*reaction(row3) - push, share = pull/(1.85 + powi(reaction(row3), 2)))]
pub struct Random56 {
    #[nominal(0.94)]
    pub p1: f64,
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
#[output(place = sin(0.71*x2 + 0.56*x1)*cos(0.84*x1 + 0.83*x1 + 0.30), power = 1.69*dot(x4)/(1 + powi(x3, 2)) - p2*dot(x1)*dot(x4)*sin(0.52*x1 - 1.42) - p1*dot(x3)*dot(x2)*sin(p2*x4 + 0.47), push = sin(0.92*x2)*ddot(x4) + dot(x1)*ddot(x1), pull = (1.08 - 0.31*0.89*sin(x4)/(1.50 + cos(x2)))*reaction(row2) - push, share = pull/(1.25 + powi(reaction(row2), 2)))]
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
#[independent(s1 = (1.50 - 0.25*cos(0.52*x4))*v5 - 0.33*0.32*sin(x2)/(1.50 + cos(x1))*v1 - 0.16*atan2(x3, 2 + cos(x5))/2*v2, v3)]
#[output(place = x4/(1 + powi(x4, 2)), power = 1.97*v2/(1 + powi(x3, 2)) - p2*x1, push = sin(0.59*x1 + 1.01)*dot(v1) + v2*ddot(x2), pull = (1.30 + 0.25*cos(1.02*x2))*reaction(row3) - push, share = pull/(1.55 + powi(reaction(row3), 2)))]
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
#[output(place = tan(0.56*sin(x1))/2, power = p2*x4 + p1*v2*v2*sin(p2*x3 + 0.98) + 0.70*powi(v2, 2), push = exp(-powi(x3, 2)/2)*dot(v2) + v3*ddot(x3))]
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
#[independent(s1 = dot(x1) + 0.33*cos(1.17*x1 - 0.57*x1)*dot(x3) - 0.31*sin(0.60*x1 + 0.84*x2 + 0.92)*cos(0.40*x3 + 0.57*x4 + 1.16)*dot(x4) + 0.36*1/sqrt(1.50 + powi(x1, 2)), s2 = 1.60*dot(x2) - 0.14*sin(1.03*x1 - 0.74*x4)*dot(x1))]
#[output(place = exp(-powi(x3, 2)/2), power = 0.87*dot(x4) - 0.39*tan(0.43*sin(x4))/2, push = 1/sqrt(1.50 + powi(x3, 2))*ddot(x2) + dot(x2)*ddot(x2))]
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
#[output(place = x2/(1 + powi(x2, 2)), power = tau*1.36 - p3*v2*v4*tan(0.45*sin(x1))/2, push = 1/sqrt(1.50 + powi(x4, 2))*dot(v5) + v4*ddot(x4))]
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
#[output(place = cos(0.88*x4 + 0.82*x3 - 0.38), power = 0.48*powi(v5, 2) - p1*v2*v5*tan(0.89*sin(x5))/2 - 0.73*0.48*sin(x1)/(1.50 + cos(x4)) - v3*v1/(1.10 + 0.30*0.56*sin(x2)/(1.50 + cos(x5))), push = cos(1.19*x2)*dot(v4) + v4*ddot(x4), pull = (1.36 + 0.32*1/sqrt(1.50 + powi(x2, 2)))*reaction(held_x5) - push, share = pull/(1.58 + powi(reaction(held_x5), 2)))]
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
#[independent(s1 = v1 - 0.34*exp(-powi(x5, 2)/2)*v4 + 0.19*atan2(x3, 2 + cos(x4))/2*v3 - 0.47*sin(p1*x2 - 0.21))]
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
#[output(place = tan(0.76*sin(x1))/2, power = 0.52*1/sqrt(1.50 + powi(x2, 2)) - 1.07*powi(dot(x4), 2) - dot(x1)*sqrt(2 + powi(dot(x3), 2)) - p1*dot(x4)*dot(x2)*ln(1.60 + 0.72*cos(x5)), push = 1/sqrt(1.50 + powi(x2, 2))*ddot(x5) + dot(x3)*ddot(x3), pull = (1.28 - 0.34*sin(0.95*x3))*reaction(row3) - push, share = pull/(1.54 + powi(reaction(row3), 2)))]
pub struct Random71 {
    #[nominal(0.54)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = 1.30*dot(x1) - 0.24*exp(-powi(x3, 2)/2)*dot(x5) - 0.41*1/sqrt(1.50 + powi(x4, 2)),
    v2 = 1.19*dot(x2) + 0.17*atan2(x2, 2 + cos(x5))/2*dot(x4) + 0.50*sin(1.09*x4 - 0.82*x1 - 0.62),
    v3 = dot(x3) + 0.26*sin(0.94*x1 - 0.63*x1),
    v4 = 1.26*dot(x4) + 0.33*0.99*sin(x5)/(1.50 + cos(x5))*dot(x2) + 0.58*1/sqrt(1.50 + powi(x5, 2)),
    v5 = (1.14 + 0.32*atan2(x2, 2 + cos(x3))/2)*dot(x5) - 0.58*1/sqrt(1.50 + powi(x5, 2)),
)]
#[inertia(matrix(
    [(1.32)*(1.32), 0, (1.32)*(0.28*0.73*sin(x3)/(1.50 + cos(x2))), (1.32)*(0.19*sin(0.48*x3 - 0.56*x4)*cos(0.97*x4)), (1.32)*(0.35*x5/(1 + powi(x5, 2)))],
    [_, ((1.03 - 0.17*cos(1.05*x3 - 0.75*x4)))*((1.03 - 0.17*cos(1.05*x3 - 0.75*x4))), 0, ((1.03 - 0.17*cos(1.05*x3 - 0.75*x4)))*(0.26*sin(1.05*x1 + 0.29)), ((1.03 - 0.17*cos(1.05*x3 - 0.75*x4)))*(0.36*powi(cos(0.96*x4), 3))],
    [_, _, (0.28*0.73*sin(x3)/(1.50 + cos(x2)))*(0.28*0.73*sin(x3)/(1.50 + cos(x2))) + (1.31)*(1.31), (0.28*0.73*sin(x3)/(1.50 + cos(x2)))*(0.19*sin(0.48*x3 - 0.56*x4)*cos(0.97*x4)) + (1.31)*(0.18*cos(0.53*x1 + 1.47)), (0.28*0.73*sin(x3)/(1.50 + cos(x2)))*(0.35*x5/(1 + powi(x5, 2))) + (1.31)*(0.33*0.78*sin(x3)/(1.50 + cos(x3)))],
    [_, _, _, (0.19*sin(0.48*x3 - 0.56*x4)*cos(0.97*x4))*(0.19*sin(0.48*x3 - 0.56*x4)*cos(0.97*x4)) + (0.26*sin(1.05*x1 + 0.29))*(0.26*sin(1.05*x1 + 0.29)) + (0.18*cos(0.53*x1 + 1.47))*(0.18*cos(0.53*x1 + 1.47)) + ((1.35 + 0.33*sin(p3*x5 - 0.56)))*((1.35 + 0.33*sin(p3*x5 - 0.56))), (0.19*sin(0.48*x3 - 0.56*x4)*cos(0.97*x4))*(0.35*x5/(1 + powi(x5, 2))) + (0.26*sin(1.05*x1 + 0.29))*(0.36*powi(cos(0.96*x4), 3)) + (0.18*cos(0.53*x1 + 1.47))*(0.33*0.78*sin(x3)/(1.50 + cos(x3)))],
    [_, _, _, _, (0.35*x5/(1 + powi(x5, 2)))*(0.35*x5/(1 + powi(x5, 2))) + (0.36*powi(cos(0.96*x4), 3))*(0.36*powi(cos(0.96*x4), 3)) + (0.33*0.78*sin(x3)/(1.50 + cos(x3)))*(0.33*0.78*sin(x3)/(1.50 + cos(x3))) + ((1.35 - 0.31*x1/(1 + powi(x1, 2))))*((1.35 - 0.31*x1/(1 + powi(x1, 2))))],
))]
#[forces(
    1.06*v5 - p3*v1*v4*exp(-powi(x4, 2)/2) - p3*1.07 - p1*exp(0.20*x5),
    v1*v2/(1.18 + 0.14*x2/(1 + powi(x2, 2))),
    p2*v5*v3*sin(1.19*x3 + 0.76*x3 - 0.98) - p3*v3*v5*atan2(x5, 2 + cos(x4))/2 - v2*v3/(1.13 - 0.31*atan2(x1, 2 + cos(x1))/2),
    p1*v2*v4*sin(1.09*x4 + 0.58*x2)*cos(0.71*x3 - 0.65) + v4*v3/(1.12 + 0.17*ln(1.60 + 0.90*cos(x4))) + v1*v1/(1.28 - 0.23*exp(-powi(x3, 2)/2)) + v2*sqrt(2 + powi(v4, 2)),
    1.20*powi(v2, 2) - p3*v3*v4*x1/(1 + powi(x1, 2)),
)]
#[constraint(row1: 1.47*v1 + 0.59*ln(1.60 + 0.61*cos(x5)) == 0)]
#[constraint(row2: 1.20*v4 + 0.31*sin(0.45*x1 + 0.22*x2)*v1 == 0)]
#[constraint(row3: 1.59*v5 - 0.21*atan2(x3, 2 + cos(x1))/2*v1 - 0.22*0.50*sin(x5)/(1.50 + cos(x2))*v4 + 0.25*1/sqrt(1.50 + powi(x2, 2)) == 0)]
#[constraint(row4: v3 - 0.10*0.58*sin(x4)/(1.50 + cos(x1))*v1 + 0.27*atan2(x1, 2 + cos(x3))/2*v4 == 0)]
#[constraint(row5: 1.92*v2 - 0.21*v2*v1*sin(1.14*x5) + 0.31*sin(0.87*x1 - 0.36*x2)*cos(0.74*x3 + 0.21*x4) == 0)]
#[independent(s1 = v2 + 0.28*cos(0.96*x5 - 0.65*x5)*v1)]
#[output(place = 1/sqrt(1.50 + powi(x1, 2)), power = 0.68*v1 - p2*v1*v4*powi(cos(1.10*x2 - 0.24*x2), 3) - 1.54*powi(v1, 2) - p2*1.66, push = x5/(1 + powi(x5, 2))*dot(v1) + v4*ddot(x4), pull = 1.29*reaction(row4) - push, share = pull/(1.92 + powi(reaction(row4), 2)))]
pub struct Random72 {
    #[nominal(0.68)]
    pub p1: f64,
    #[nominal(1.00)]
    pub p2: f64,
    #[nominal(0.95)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[inputs(tau)]
#[kinematics(
    v1 = (1.08 - 0.10*powi(cos(0.93*x2), 3))*dot(x1) + 0.13*0.89*sin(x3)/(1.50 + cos(x4))*dot(x4) - 0.26*powi(cos(0.85*x2), 3),
    v2 = 1.10*dot(x2) - 0.21*sin(p2*x4 + 0.31)*dot(x3) + 0.58*cos(1.01*x4),
    v3 = (1.28 - 0.31*1/sqrt(1.50 + powi(x2, 2)))*dot(x3) - 0.35*1/sqrt(1.50 + powi(x3, 2)),
    v4 = (1.06 - 0.31*ln(1.60 + 0.66*cos(x3)))*dot(x4) + 0.12*tan(0.37*sin(x4))/2*dot(x2) + 0.25*tan(0.97*sin(x1))/2,
)]
#[inertia(diag((1.36 + 0.19*atan2(x1, 2 + cos(x3))/2), (1.03 + 0.34*powi(cos(0.94*x1 - 0.52*x4), 3)), (1.03 - 0.29*cos(0.44*x1)), 1.08))]
#[forces(
    0.95*sin(0.53*x2)*cos(0.90*x4) + p1*v4*v2*sin(0.67*x4 - 0.47*x4 - 0.75) + 0.48*atan2(x1, 2 + cos(x1))/2 + 0.50*v2/(1 + powi(x3, 2)),
    tau*1.46,
    v3*sqrt(2 + powi(v1, 2)) + p2*v1*v2*0.71*sin(x1)/(1.50 + cos(x4)),
    v3*sqrt(2 + powi(v3, 2)) + v2*sqrt(2 + powi(v4, 2)),
)]
#[potential_energy(powi(cos(1.15*x3 - 0.85*x2), 3))]
#[constraint(row1: 1.30*dot(v1) - 0.18*1/sqrt(1.50 + powi(x2, 2))*dot(v2) - 0.25*cos(1.13*x3)*dot(v4) + 0.30*v1/sqrt(1.20 + powi(v3, 2)) == 0)]
#[output(place = cos(1.16*x4 - 0.78*x3), power = p2*v1*v1*sin(p1*x2 - 0.69) + 1.43*powi(v3, 2) + v3*sqrt(2 + powi(v2, 2)), push = exp(-powi(x1, 2)/2)*dot(v3) + v4*ddot(x4), pull = (1.11 - 0.18*atan2(x1, 2 + cos(x3))/2)*reaction(row1) - push, share = pull/(1.70 + powi(reaction(row1), 2)))]
pub struct Random73 {
    #[nominal(1.38)]
    pub p1: f64,
    #[nominal(1.22)]
    pub p2: f64,
    #[nominal(0.50)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(matrix(
    [((1.32 - 0.33*sin(p1*x4 - 0.26)))*((1.32 - 0.33*sin(p1*x4 - 0.26))), ((1.32 - 0.33*sin(p1*x4 - 0.26)))*(0.23*cos(0.96*x2)), ((1.32 - 0.33*sin(p1*x4 - 0.26)))*(0.39*sin(p2*x2 + 0.54)), ((1.32 - 0.33*sin(p1*x4 - 0.26)))*(0.23*1/sqrt(1.50 + powi(x2, 2)))],
    [_, (0.23*cos(0.96*x2))*(0.23*cos(0.96*x2)) + ((1.01 + 0.18*exp(-powi(x3, 2)/2)))*((1.01 + 0.18*exp(-powi(x3, 2)/2))), (0.23*cos(0.96*x2))*(0.39*sin(p2*x2 + 0.54)) + ((1.01 + 0.18*exp(-powi(x3, 2)/2)))*(0.34*sin(p2*x1 + 0.19)), (0.23*cos(0.96*x2))*(0.23*1/sqrt(1.50 + powi(x2, 2))) + ((1.01 + 0.18*exp(-powi(x3, 2)/2)))*(0.33*powi(cos(1.11*x1), 3))],
    [_, _, (0.39*sin(p2*x2 + 0.54))*(0.39*sin(p2*x2 + 0.54)) + (0.34*sin(p2*x1 + 0.19))*(0.34*sin(p2*x1 + 0.19)) + ((1.30 + 0.32*cos(0.74*x4 - 0.45)))*((1.30 + 0.32*cos(0.74*x4 - 0.45))), (0.39*sin(p2*x2 + 0.54))*(0.23*1/sqrt(1.50 + powi(x2, 2))) + (0.34*sin(p2*x1 + 0.19))*(0.33*powi(cos(1.11*x1), 3)) + ((1.30 + 0.32*cos(0.74*x4 - 0.45)))*(0.15*atan2(x2, 2 + cos(x1))/2)],
    [_, _, _, (0.23*1/sqrt(1.50 + powi(x2, 2)))*(0.23*1/sqrt(1.50 + powi(x2, 2))) + (0.33*powi(cos(1.11*x1), 3))*(0.33*powi(cos(1.11*x1), 3)) + (0.15*atan2(x2, 2 + cos(x1))/2)*(0.15*atan2(x2, 2 + cos(x1))/2) + ((1.33 - 0.25*ln(1.60 + 0.61*cos(x1))))*((1.33 - 0.25*ln(1.60 + 0.61*cos(x1))))],
))]
#[forces(
    1.55*powi(dot(x3), 2) - 1.64*sin(1.00*x3 - 0.68)*cos(0.92*x4) - p2*x4,
    dot(x1)*dot(x3)/(1.01 - 0.17*atan2(x4, 2 + cos(x3))/2) - 0.33*powi(dot(x1), 2),
    0,
    1.70*sin(p2*x2 + 0.85),
)]
#[potential_energy(cos(1.11*x3 + 1.23))]
#[constraint(row1: 1.90*dot(x1) + 0.25*sin(p3*x2 + 0.59)*dot(x3) == 0)]
#[constraint(row2: 1.15*dot(x4) - 0.27*cos(0.59*x4 + 0.89*x2)*dot(x3) + 0.24*exp(-powi(x3, 2)/2)*dot(x1) + 0.28*exp(-powi(x2, 2)/2) == 0)]
#[constraint(row3: 1.68*ddot(x2) - 0.22*powi(cos(1.10*x4), 3)*ddot(x3) - 0.15*x3/(1 + powi(x3, 2))*ddot(x1) + 0.40*dot(x2) + 0.40*cos(1.14*x2) == 0)]
#[independent(s1 = (1.50 + 0.26*tan(0.50*sin(x4))/2)*dot(x3) + 0.18*sin(1.13*x1 + 1.32)*dot(x1), s2 = 1.63*dot(x2) - 0.22*0.54*sin(x4)/(1.50 + cos(x2))*dot(x3))]
#[output(place = ln(1.60 + 0.44*cos(x2)), power = dot(x3)*sqrt(2 + powi(dot(x4), 2)) + p1*1.19 + 1.04*0.87*sin(x1)/(1.50 + cos(x3)) + p2*1.95, push = tan(0.62*sin(x1))/2*ddot(x1) + dot(x4)*ddot(x4), pull = (1.40 + 0.10*cos(1.00*x1 + 0.58*x3))*reaction(row3) - push, share = pull/(1.99 + powi(reaction(row3), 2)))]
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
#[inertia(diag((1.04 + 0.17*sin(1.12*x1 - 0.68*x2)*cos(0.43*x4)), (1.08 - 0.23*1/sqrt(1.50 + powi(x4, 2))), (1.34 - 0.20*1/sqrt(1.50 + powi(x2, 2))), (1.39 - 0.29*x2/(1 + powi(x2, 2)))))]
#[forces(
    1.28*dot(x3) - 1.88*tan(0.50*sin(x1))/2 - 1.62*x3/(1 + powi(x3, 2)) - dot(x4)*dot(x2)/(1.22 + 0.16*powi(cos(0.51*x1 - 0.77*x2), 3)),
    0,
    0.98*dot(x1) - dot(x4)*sqrt(2 + powi(dot(x4), 2)) - p2*x3 - dot(x3)*sqrt(2 + powi(dot(x3), 2)),
    1.90*tan(0.72*sin(x3))/2 - p1*exp(0.20*x2),
)]
#[potential_energy(0.31*sin(x1)/(1.50 + cos(x3)))]
#[constraint(row1: 1.50*x4 + 0.59 == 0)]
#[constraint(row2: 1.91*dot(x2) - 0.25*sin(p2*x4 - 0.40)*dot(x4) - 0.59*sin(1.07*x1)*cos(0.57*x2 - 1.48) == 0)]
#[constraint(row3: powi(dot(x1), 2) - 0.20*powi(dot(x2), 2) - (2 - 0.20*sin(0.91*x2 + 0.89*x4)) == 0)]
#[constraint(row4: ddot(x3) + 0.13*cos(0.88*x3 + 0.81)*ddot(x4) + 0.23*sin(0.60*x1 + 0.58*x4)*ddot(x2) + 0.62*dot(x3) + 0.62*x1/(1 + powi(x1, 2)) == 0)]
#[independent(s1 = 1.52*dot(x3) + 0.15*sin(0.83*x2 - 0.49*x4 - 0.42)*dot(x4) - 0.15*x3/(1 + powi(x3, 2))*dot(x2), s2 = (1.50 - 0.18*sin(0.81*x2 - 0.29*x3)*cos(0.53*x2))*dot(x1) + 0.32*tan(0.46*sin(x3))/2*dot(x3) - 0.30*sin(p1*x3 - 0.86)*dot(x4))]
#[independent(dot(x3), dot(x1))]
#[output(place = 1/sqrt(1.50 + powi(x4, 2)), power = dot(x2)*dot(x3)/(1.04 - 0.18*atan2(x2, 2 + cos(x3))/2), push = sin(0.76*x2)*ddot(x2) + dot(x1)*ddot(x1), pull = (1.25 + 0.18*atan2(x1, 2 + cos(x3))/2)*reaction(row3) - push, share = pull/(1.10 + powi(reaction(row3), 2)))]
pub struct Random76 {
    #[nominal(1.30)]
    pub p1: f64,
    #[nominal(1.05)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + exp(-powi(x3, 2)/2)*dot(x1),
    v3 = dot(x3) + sin(0.88*t + 0.83*x4)*dot(x1),
    v4 = dot(x4) + cos(0.51*x1 + 0.83*t - 1.20)*dot(x3),
    dot(x1) = v1,
    dot(x2) = v2 - exp(-powi(x3, 2)/2)*(v1),
    dot(x3) = v3 - sin(0.88*t + 0.83*x4)*(v1),
    dot(x4) = v4 - cos(0.51*x1 + 0.83*t - 1.20)*(v3 - sin(0.88*t + 0.83*x4)*(v1)),
)]
#[inertia(diag((1.17 - 0.22*powi(cos(0.59*t - 0.75*x1), 3)), (1.27 + 0.14*sin(0.49*t + 0.66*t)), (1.13 - 0.32*tan(0.75*sin(x2))/2), 1.08))]
#[forces(
    p1*1.34 - v2*v3/(1.35 + 0.22*ln(1.60 + 0.37*cos(x2))) - 1.19*v2 - p2*x2,
    p1*v3*v4*ln(1.60 + 0.73*cos(t)),
    v2*v2/1.06,
    0.79*v3,
)]
#[constraint(row1: 1.32*x2 + 0.26*powi(x4, 2)/2 + 0.25*powi(x1, 2)/2 + 0.30*sin(0.94*t) + 0.39 == 0)]
#[constraint(row2: 1.42*x3 + 0.19*sin(x3) + 0.19*sin(x4) + 0.12*powi(x1, 2)/2 + 0.30*sin(0.45*t) + 0.58 == 0)]
#[constraint(again1: 0.81*(1.32*x2 + 0.26*powi(x4, 2)/2 + 0.25*powi(x1, 2)/2 + 0.30*sin(0.94*t) + 0.39) == 0, redundant)]
#[independent(v1, v4)]
#[output(place = cos(0.95*x2 - 0.40*x1), power = p1*x1 - p1*x2 - p1*1.66 - p1*x3, push = 0.57*sin(x3)/(1.50 + cos(t))*dot(v3) + v2*ddot(x2), pull = 1.14*reaction(again1) - push, share = pull/(1.64 + powi(reaction(again1), 2)))]
pub struct Random77 {
    #[nominal(1.32)]
    pub p1: f64,
    #[nominal(1.46)]
    pub p2: f64,
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
#[independent(s1 = (1.50 + 0.28*powi(cos(0.47*x3), 3))*v2 - 0.12*0.97*sin(x2)/(1.50 + cos(x2))*v5, s2 = (1.50 - 0.24*atan2(x1, 2 + cos(x5))/2)*v3 - 0.26*0.32*sin(x3)/(1.50 + cos(x2))*v2)]
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
#[output(place = atan2(x5, 2 + cos(x5))/2, power = p1*v6*v3*0.46*sin(x6)/(1.50 + cos(x3)) - tau*0.67, push = sin(p2*x3 - 0.66)*dot(v6) + v4*ddot(x4))]
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
#[output(place = x5/(1 + powi(x5, 2)), power = p1*x4 - v2*v5/(1.10 - 0.18*cos(1.06*x1)), push = tan(0.51*sin(x2))/2*dot(v1) + v3*ddot(x3))]
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
#[output(place = 1/sqrt(1.50 + powi(x4, 2)), power = 1.14*ln(1.60 + 0.62*cos(x2)), push = tan(0.58*sin(x2))/2*ddot(x4) + dot(x6)*ddot(x6))]
pub struct Random86 {
    #[nominal(1.33)]
    pub p1: f64,
    #[nominal(0.85)]
    pub p2: f64,
    #[nominal(1.42)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + exp(-powi(x5, 2)/2)*dot(x1),
    v3 = dot(x3) + sin(0.87*x2 - 0.69*x4)*cos(0.48*x3 - 0.34)*dot(x1),
    v4 = dot(x4) + exp(-powi(x1, 2)/2)*dot(x3),
    v5 = dot(x5) + powi(cos(0.45*x2), 3)*dot(x4),
    dot(x1) = v1,
    dot(x2) = v2 - exp(-powi(x5, 2)/2)*(v1),
    dot(x3) = v3 - sin(0.87*x2 - 0.69*x4)*cos(0.48*x3 - 0.34)*(v1),
    dot(x4) = v4 - exp(-powi(x1, 2)/2)*(v3 - sin(0.87*x2 - 0.69*x4)*cos(0.48*x3 - 0.34)*(v1)),
    dot(x5) = v5 - powi(cos(0.45*x2), 3)*(v4 - exp(-powi(x1, 2)/2)*(v3 - sin(0.87*x2 - 0.69*x4)*cos(0.48*x3 - 0.34)*(v1))),
)]
#[inertia(matrix(
    [((1.18 - 0.32*cos(0.72*x3)))*((1.18 - 0.32*cos(0.72*x3))), ((1.18 - 0.32*cos(0.72*x3)))*(0.39*sin(0.50*x1)), 0, 0, ((1.18 - 0.32*cos(0.72*x3)))*(0.31*tan(0.58*sin(x2))/2)],
    [_, (0.39*sin(0.50*x1))*(0.39*sin(0.50*x1)) + ((1.09 - 0.34*powi(cos(0.96*x5 - 0.30*x3), 3)))*((1.09 - 0.34*powi(cos(0.96*x5 - 0.30*x3), 3))), ((1.09 - 0.34*powi(cos(0.96*x5 - 0.30*x3), 3)))*(0.16*tan(0.70*sin(x4))/2), ((1.09 - 0.34*powi(cos(0.96*x5 - 0.30*x3), 3)))*(0.38*atan2(t, 2 + cos(x3))/2), (0.39*sin(0.50*x1))*(0.31*tan(0.58*sin(x2))/2) + ((1.09 - 0.34*powi(cos(0.96*x5 - 0.30*x3), 3)))*(0.17*powi(cos(0.99*x5 - 0.34*x4), 3))],
    [_, _, (0.16*tan(0.70*sin(x4))/2)*(0.16*tan(0.70*sin(x4))/2) + (1.36)*(1.36), (0.16*tan(0.70*sin(x4))/2)*(0.38*atan2(t, 2 + cos(x3))/2) + (1.36)*(0.30*t/(1 + powi(t, 2))), (0.16*tan(0.70*sin(x4))/2)*(0.17*powi(cos(0.99*x5 - 0.34*x4), 3))],
    [_, _, _, (0.38*atan2(t, 2 + cos(x3))/2)*(0.38*atan2(t, 2 + cos(x3))/2) + (0.30*t/(1 + powi(t, 2)))*(0.30*t/(1 + powi(t, 2))) + ((1.13 + 0.22*atan2(x3, 2 + cos(x3))/2))*((1.13 + 0.22*atan2(x3, 2 + cos(x3))/2)), (0.38*atan2(t, 2 + cos(x3))/2)*(0.17*powi(cos(0.99*x5 - 0.34*x4), 3)) + ((1.13 + 0.22*atan2(x3, 2 + cos(x3))/2))*(0.28*tan(0.51*sin(x1))/2)],
    [_, _, _, _, (0.31*tan(0.58*sin(x2))/2)*(0.31*tan(0.58*sin(x2))/2) + (0.17*powi(cos(0.99*x5 - 0.34*x4), 3))*(0.17*powi(cos(0.99*x5 - 0.34*x4), 3)) + (0.28*tan(0.51*sin(x1))/2)*(0.28*tan(0.51*sin(x1))/2) + (1.11)*(1.11)],
))]
#[forces(
    1.48*exp(-powi(x3, 2)/2) + 0.82*v4,
    1.68*v5 + p3*exp(0.20*x2) + 1.58*powi(cos(0.57*x2 + 0.83*x2 + 0.35), 3) + p3*v4*v2*sin(0.41*x1 - 0.30*x4)*cos(0.99*x3 + 0.81),
    1.66*v2/(1 + powi(x4, 2)) - p2*x3 - 0.50*v3/(1 + powi(x2, 2)),
    v5*sqrt(2 + powi(v2, 2)) - p1*exp(0.20*x1) - p3*0.65,
    v2*v2/1.36,
)]
#[configuration(of(q1, q2, q3, q4, q5), x4 = 1.25*q1, x1 = 1.25*q2, x5 = 1.25*q3, x2 = 1.25*q4, x3 = 1.25*q5)]
#[output(place = exp(-powi(x5, 2)/2), power = 1.44*powi(v2, 2) - 0.86*powi(v1, 2), push = sin(0.56*x5 - 0.79*x4)*cos(0.74*x2 - 0.21)*dot(v4) + v3*ddot(x3))]
pub struct Random87 {
    #[nominal(1.24)]
    pub p1: f64,
    #[nominal(1.01)]
    pub p2: f64,
    #[nominal(0.57)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + tan(0.56*sin(x6))/2*dot(x1),
    v3 = dot(x3) + atan2(x6, 2 + cos(x4))/2*dot(x1),
    v4 = dot(x4) + tan(0.67*sin(x3))/2*dot(x3),
    v5 = dot(x5) + sin(0.81*x6 + 0.84*x6)*dot(x2),
    v6 = dot(x6) + sin(0.87*x6)*dot(x4),
    dot(x1) = v1,
    dot(x2) = v2 - tan(0.56*sin(x6))/2*(v1),
    dot(x3) = v3 - atan2(x6, 2 + cos(x4))/2*(v1),
    dot(x4) = v4 - tan(0.67*sin(x3))/2*(v3 - atan2(x6, 2 + cos(x4))/2*(v1)),
    dot(x5) = v5 - sin(0.81*x6 + 0.84*x6)*(v2 - tan(0.56*sin(x6))/2*(v1)),
    dot(x6) = v6 - sin(0.87*x6)*(v4 - tan(0.67*sin(x3))/2*(v3 - atan2(x6, 2 + cos(x4))/2*(v1))),
)]
#[inertia(diag(1.31, (1.37 + 0.21*1/sqrt(1.50 + powi(x4, 2))), (1.23 - 0.19*sin(0.43*x3 + 0.76*x5 - 1.38)), (1.29 + 0.28*tan(0.65*sin(x3))/2), (1.20 + 0.32*atan2(x2, 2 + cos(x5))/2), 1.20))]
#[forces(
    v4*sqrt(2 + powi(v1, 2)),
    v2*v3/(1.07 - 0.26*sin(0.64*x3 + 0.87*x3)),
    p3*v3*v1*1/sqrt(1.50 + powi(x2, 2)) - 0.54*powi(v4, 2) - p1*1.49,
    1.89*v1/(1 + powi(x4, 2)) + 1.64*v1/(1 + powi(x2, 2)),
    1.01*ln(1.60 + 0.79*cos(x1)) + 1.66*v4 + p1*1.12,
    1.97*v2/(1 + powi(x5, 2)) - v1*sqrt(2 + powi(v6, 2)),
)]
#[configuration(x6 = 0.95*sin(0.86*x1), x2 = 0.66*ln(1.60 + 0.81*cos(x4)))]
#[constraint(held_x6: x6 - (0.95*sin(0.86*x1)) == 0)]
#[constraint(held_x2: x2 - (0.66*ln(1.60 + 0.81*cos(x4))) == 0)]
#[constraint(rolling: (1.50 - 0.14*cos(0.96*x4 - 0.49*x5))*dot(x3) + 0.32*atan2(x5, 2 + cos(x3))/2*dot(x1) + 0.20*cos(1.20*x1 + 0.31*x4)*dot(x4) - 0.12*tan(0.65*sin(x4))/2*dot(x5) == 0)]
#[output(place = ln(1.60 + 0.96*cos(x4)), power = p3*x1 + v4*v5/1.24 + 1.02*v2/(1 + powi(x4, 2)) + 1.04*cos(0.50*x1 - 0.30*x6 - 0.22), push = x3/(1 + powi(x3, 2))*dot(v5) + v3*ddot(x3), pull = (1.23 + 0.12*exp(-powi(x5, 2)/2))*reaction(held_x2) - push, share = pull/(1.52 + powi(reaction(held_x2), 2)))]
pub struct Random88 {
    #[nominal(0.54)]
    pub p1: f64,
    #[nominal(0.66)]
    pub p2: f64,
    #[nominal(0.96)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = (1.30 - 0.21*tan(0.51*sin(x2))/2)*dot(x1) + 0.11*exp(-powi(x3, 2)/2),
    v2 = dot(x2) - 0.39*atan2(x1, 2 + cos(x5))/2,
    v3 = (1.33 - 0.28*ln(1.60 + 0.70*cos(x5)))*dot(x3) + 0.21*sin(0.50*x1 + 0.34*x2 - 1.23),
    v4 = (1.40 - 0.25*0.76*sin(x5)/(1.50 + cos(x2)))*dot(x4) - 0.42*sin(p2*t - 0.27),
    v5 = (1.30 + 0.32*ln(1.60 + 0.92*cos(x1)))*dot(x5) - 0.28*x4/(1 + powi(x4, 2))*dot(x3) + 0.25*sin(p2*x2 - 0.75),
    v6 = dot(x6) - 0.36*1/sqrt(1.50 + powi(t, 2))*dot(x2) + 0.28*sin(0.55*x3 - 1.29),
)]
#[define(l11 = (1.03 + 0.16*sin(0.86*x4 - 0.57*x3 + 0.36)), l21 = 0.10*cos(1.12*x6 - 0.62*x1 + 0.57), l22 = 1.08, l31 = 0.34*sin(p1*t - 0.27), l32 = 0.21*x2/(1 + powi(x2, 2)), l33 = (1.04 + 0.23*atan2(x1, 2 + cos(x5))/2), l41 = 0.39*sin(0.93*x1 - 0.25), l42 = 0.12*exp(-powi(t, 2)/2), l43 = 0.30*0.42*sin(t)/(1.50 + cos(t)), l44 = 1.01, l51 = 0.38*tan(0.68*sin(t))/2, l53 = 0.26*ln(1.60 + 0.63*cos(x5)), l55 = (1.17 - 0.18*atan2(t, 2 + cos(x4))/2), l61 = 0.25*exp(-powi(t, 2)/2), l62 = 0.29*ln(1.60 + 0.97*cos(x1)), l66 = (1.24 - 0.30*sin(p1*x5 - 0.63)))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, l11*l41, l11*l51, l11*l61],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l21*l41 + l22*l42, l21*l51, l21*l61 + l22*l62],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l32*l42 + l33*l43, l31*l51 + l33*l53, l31*l61 + l32*l62],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44, l41*l51 + l43*l53, l41*l61 + l42*l62],
    [_, _, _, _, l51*l51 + l53*l53 + l55*l55, l51*l61],
    [_, _, _, _, _, l61*l61 + l62*l62 + l66*l66],
))]
#[forces(
    p2*0.80,
    p1*exp(0.20*x1) - p2*0.58 - p2*v6*v1*sin(p1*x3 + 0.69) - 1.27*cos(0.51*x6),
    p1*exp(0.20*x3) + 0.68*powi(v2, 2),
    v4*v4/1.37 + p1*exp(0.20*x6) + p2*x1 + p1*0.53,
    v2*v3/(1.13 + 0.34*tan(0.98*sin(x6))/2),
    v5*sqrt(2 + powi(v4, 2)) - v5*v1/(1.32 + 0.18*sin(0.99*x2 - 0.98)*cos(1.07*x4)) - 1.46*1/sqrt(1.50 + powi(x5, 2)),
)]
#[constraint(row1: v1 + 0.39*sin(0.62*x6 - 0.39*x6)*v6 + 0.76*exp(-powi(x5, 2)/2)*v5 == 0)]
#[constraint(row2: v4 + 0.69*powi(cos(1.05*x1 - 0.76), 3)*v6 + 0.73*x1/(1 + powi(x1, 2))*v5 + 0.40*sin(p1*x2 - 0.75) == 0)]
#[constraint(row3: v2 + 0.74*powi(cos(1.00*x5 + 1.06), 3)*v6 + 0*v5 == 0)]
#[constraint(row4: v3 + 0.70*sin(0.71*x6 + 0.76)*v6 + 0.31*sin(0.53*x4 - 0.81*t - 0.38)*cos(1.20*x1 - 1.39)*v5 + 0.40*powi(cos(1.15*x5 + 0.41*x3), 3) == 0)]
#[complement(
    w1 = [-1.38*(0.39*sin(0.62*x6 - 0.39*x6)), -1.38*(0.74*powi(cos(1.00*x5 + 1.06), 3)), -1.38*(0.70*sin(0.71*x6 + 0.76)), -1.38*(0.69*powi(cos(1.05*x1 - 0.76), 3)), 0, 1.38],
    w2 = [-(1.16 - 0.33*cos(0.71*x4 + 0.71*x4 - 1.36))*(0.76*exp(-powi(x5, 2)/2)), -(1.16 - 0.33*cos(0.71*x4 + 0.71*x4 - 1.36))*(0), -(1.16 - 0.33*cos(0.71*x4 + 0.71*x4 - 1.36))*(0.31*sin(0.53*x4 - 0.81*t - 0.38)*cos(1.20*x1 - 1.39)), -(1.16 - 0.33*cos(0.71*x4 + 0.71*x4 - 1.36))*(0.73*x1/(1 + powi(x1, 2))), (1.16 - 0.33*cos(0.71*x4 + 0.71*x4 - 1.36)), 0],
)]
#[output(place = sin(p1*t + 0.49), power = v1*v2/(1.35 - 0.17*atan2(x6, 2 + cos(x4))/2) + 1.26*v5 + v5*sqrt(2 + powi(v3, 2)) + 1.61*powi(v2, 2), push = cos(0.94*x2)*dot(v3) + v3*ddot(x3), pull = 1.29*reaction(row3) - push, share = pull/(1.96 + powi(reaction(row3), 2)))]
pub struct Random89 {
    #[nominal(1.42)]
    pub p1: f64,
    #[nominal(1.04)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + x4/(1 + powi(x4, 2))*dot(x1),
    v3 = dot(x3) + exp(-powi(x1, 2)/2)*dot(x1),
    v4 = dot(x4) + 1/sqrt(1.50 + powi(x1, 2))*dot(x3),
    v5 = dot(x5) + powi(cos(0.66*x6 + 0.37*x6 + 0.75), 3)*dot(x3),
    v6 = dot(x6) + 1/sqrt(1.50 + powi(x6, 2))*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - x4/(1 + powi(x4, 2))*(v1),
    dot(x3) = v3 - exp(-powi(x1, 2)/2)*(v1),
    dot(x4) = v4 - 1/sqrt(1.50 + powi(x1, 2))*(v3 - exp(-powi(x1, 2)/2)*(v1)),
    dot(x5) = v5 - powi(cos(0.66*x6 + 0.37*x6 + 0.75), 3)*(v3 - exp(-powi(x1, 2)/2)*(v1)),
    dot(x6) = v6 - 1/sqrt(1.50 + powi(x6, 2))*(v2 - x4/(1 + powi(x4, 2))*(v1)),
)]
#[define(l11 = (1.06 + 0.16*0.50*sin(x1)/(1.50 + cos(x6))), l21 = 0.23*1/sqrt(1.50 + powi(x6, 2)), l22 = (1.08 - 0.18*atan2(x6, 2 + cos(x1))/2), l32 = 0.18*atan2(x4, 2 + cos(x5))/2, l33 = 1.36, l41 = 0.26*tan(0.44*sin(x5))/2, l44 = (1.30 + 0.13*x1/(1 + powi(x1, 2))), l51 = 0.15*tan(0.31*sin(x6))/2, l54 = 0.27*1/sqrt(1.50 + powi(x3, 2)), l55 = (1.06 - 0.29*powi(cos(0.53*x4 + 0.47*x3), 3)), l61 = 0.27*tan(0.39*sin(x1))/2, l62 = 0.29*exp(-powi(x2, 2)/2), l63 = 0.18*tan(0.90*sin(x2))/2, l64 = 0.40*sin(0.42*x1 - 1.31), l65 = 0.31*powi(cos(0.99*x1 - 0.61), 3), l66 = (1.04 + 0.31*powi(cos(0.93*x3), 3)))]
#[inertia(matrix(
    [l11*l11, l11*l21, 0, l11*l41, l11*l51, l11*l61],
    [_, l21*l21 + l22*l22, l22*l32, l21*l41, l21*l51, l21*l61 + l22*l62],
    [_, _, l32*l32 + l33*l33, 0, 0, l32*l62 + l33*l63],
    [_, _, _, l41*l41 + l44*l44, l41*l51 + l44*l54, l41*l61 + l44*l64],
    [_, _, _, _, l51*l51 + l54*l54 + l55*l55, l51*l61 + l54*l64 + l55*l65],
    [_, _, _, _, _, l61*l61 + l62*l62 + l63*l63 + l64*l64 + l65*l65 + l66*l66],
))]
#[forces(
    p1*v2*v3*cos(0.69*x6 + 1.40) + v4*v6/(1.32 + 0.20*0.41*sin(x4)/(1.50 + cos(x1))) + v4*sqrt(2 + powi(v6, 2)),
    0,
    v4*sqrt(2 + powi(v2, 2)) + 1.59*v5,
    0.82*powi(v2, 2) + tau*1.20 + 1.35*powi(v3, 2),
    1.70*powi(v3, 2),
    v5*sqrt(2 + powi(v6, 2)) + 1.36*v5,
)]
#[potential_energy(cos(1.00*x4))]
#[constraint(row1: 1.58*x4 + exp(0.19*x6)/2 + 0.40 == 0)]
#[constraint(row2: 1.52*x2 + 0.25*sin(x2) + 0.17*sin(x6) + exp(0.14*x4)/2 + 0.51 == 0)]
#[constraint(row3: 1.73*x3 + 0.12*sin(x3) + 0.12*x6*x6 + 0.78 == 0)]
#[constraint(row4: (1.50 - 0.16*sin(0.96*x4 - 0.84*x5))*v1 - 0.24*1/sqrt(1.50 + powi(x4, 2))*v6 + 0.23*sin(0.42*x5 - 0.64*x4 + 0.39)*cos(0.62*x3 - 0.41) == 0)]
#[constraint(row5: (1.50 + 0.14*sin(0.94*x6))*v5 + 0.32*sin(p2*x3 + 0.59)*v6 + 0.16*sin(p2*x6 - 0.94)*v4 + 0.45*sin(0.55*x1 - 0.76*x4) == 0)]
#[output(place = x4/(1 + powi(x4, 2)), power = tau*1.49 + 0.64*1/sqrt(1.50 + powi(x2, 2)) + p1*v1*v5*sin(p1*x6 - 0.67) + 1.26*v4, push = tan(0.94*sin(x3))/2*dot(v2) + v5*ddot(x5), pull = 1.29*reaction(row2) - push, share = pull/(1.07 + powi(reaction(row2), 2)))]
pub struct Random90 {
    #[nominal(0.58)]
    pub p1: f64,
    #[nominal(0.95)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + sin(0.89*x5 - 0.22*x2)*dot(x1),
    v3 = dot(x3) + tan(0.79*sin(t))/2*dot(x1),
    v4 = dot(x4) + atan2(x3, 2 + cos(x3))/2*dot(x1),
    v5 = dot(x5) + sin(0.43*t + 0.53*t + 0.64)*dot(x4),
    dot(x1) = v1,
    dot(x2) = v2 - sin(0.89*x5 - 0.22*x2)*(v1),
    dot(x3) = v3 - tan(0.79*sin(t))/2*(v1),
    dot(x4) = v4 - atan2(x3, 2 + cos(x3))/2*(v1),
    dot(x5) = v5 - sin(0.43*t + 0.53*t + 0.64)*(v4 - atan2(x3, 2 + cos(x3))/2*(v1)),
)]
#[define(l11 = (1.35 - 0.25*powi(cos(0.42*x4 - 0.58*t), 3)), l21 = 0.20*1/sqrt(1.50 + powi(x3, 2)), l22 = (1.01 - 0.23*sin(0.56*x5 + 0.50*x1 + 1.14)), l33 = (1.28 + 0.10*x2/(1 + powi(x2, 2))), l42 = 0.14*x4/(1 + powi(x4, 2)), l43 = 0.39*sin(1.13*x3 - 0.27*x3 - 1.36), l44 = 1.21, l51 = 0.24*cos(1.12*x1), l52 = 0.30*sin(0.80*x2 + 0.55*x4), l54 = 0.14*exp(-powi(x3, 2)/2), l55 = 1.35)]
#[inertia(matrix(
    [l11*l11, l11*l21, 0, 0, l11*l51],
    [_, l21*l21 + l22*l22, 0, l22*l42, l21*l51 + l22*l52],
    [_, _, l33*l33, l33*l43, 0],
    [_, _, _, l42*l42 + l43*l43 + l44*l44, l42*l52 + l44*l54],
    [_, _, _, _, l51*l51 + l52*l52 + l54*l54 + l55*l55],
))]
#[forces(
    0,
    0.30*v5/(1 + powi(t, 2)) - p1*v4*v3*powi(cos(1.01*x2 + 0.68*x1), 3) - 1.15*v4,
    1.83*exp(-powi(x4, 2)/2) - p1*v5*v3*sin(1.15*x5 + 0.73*x4) - 1.22*v4 - 0.30*sin(p1*x1 - 0.93),
    p1*v3*v3*x1/(1 + powi(x1, 2)) - v4*v1/(1.40 + 0.30*x1/(1 + powi(x1, 2))),
    v3*v1/(1.08 - 0.26*powi(cos(0.79*t + 0.63), 3)),
)]
#[constraint(row1: 1.60*v5 == 0)]
#[constraint(row2: v3 + 0.11*sin(0.87*x5 - 0.50*x5)*v5 - 0.59*tan(0.79*sin(x1))/2 == 0)]
#[constraint(row3: v2 - 0.33*sin(0.72*x2 - 0.79*t + 1.46)*cos(1.06*x2 - 0.42*x2 + 0.62)*v5 == 0)]
#[constraint(row4: v1 + 0.28*sin(1.15*x2 - 0.22*x3)*v5 + 0.28*sin(1.16*x5)*cos(0.81*x3 - 0.68*t)*v3 - 0.26*tan(0.89*sin(x1))/2*v2 == 0)]
#[constraint(row5: 1.43*v4 - 0.18*atan2(x4, 2 + cos(x2))/2*v5 + 0.24*sin(0.43*x3 + 0.19)*cos(0.54*x1)*v3 + 0.27*cos(0.74*t + 0.69)*v2 == 0)]
#[output(place = atan2(x1, 2 + cos(x2))/2, power = p1*exp(0.20*x1), push = x4/(1 + powi(x4, 2))*dot(v4) + v2*ddot(x2), pull = (1.28 + 0.30*cos(1.02*t + 0.83))*reaction(row1) - push, share = pull/(1.42 + powi(reaction(row1), 2)))]
pub struct Random91 {
    #[nominal(0.65)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[inputs(tau)]
#[kinematics(
    v1 = 1.33*dot(x1) + 0.30*atan2(x5, 2 + cos(x6))/2*dot(x6) + 0.59*sin(0.68*x5 - 0.64*x1),
    v2 = dot(x2) - 0.14*1/sqrt(1.50 + powi(x5, 2)),
    v3 = dot(x3) + 0.22*ln(1.60 + 0.41*cos(x3))*dot(x4) + 0.16*cos(1.13*x5 + 0.30*x2),
    v4 = 1.28*dot(x4) - 0.47*0.74*sin(x6)/(1.50 + cos(x1)),
    v5 = dot(x5) + 0.24*sin(p2*x3 - 0.20)*dot(x6) - 0.56*sin(1.02*x6 + 0.58)*cos(0.91*x5 + 0.45*x6),
    v6 = (1.27 + 0.20*exp(-powi(x6, 2)/2))*dot(x6) + 0.53*sin(1.18*x6 - 0.67*x2),
)]
#[define(l11 = 1.19, l21 = 0.12*powi(cos(0.69*x4 + 0.55*x1), 3), l22 = (1.08 + 0.10*0.85*sin(x3)/(1.50 + cos(x6))), l32 = 0.13*tan(0.56*sin(x5))/2, l33 = (1.12 - 0.29*cos(0.46*x1 + 0.64*x1)), l43 = 0.28*sin(0.87*x4 - 0.52*x4 + 0.70), l44 = 1.06, l51 = 0.32*sin(0.76*x2)*cos(0.80*x4), l52 = 0.11*sin(1.15*x6), l55 = (1.31 - 0.21*1/sqrt(1.50 + powi(x4, 2))), l61 = 0.28*cos(1.03*x1 - 0.53*x6 - 1.27), l62 = 0.13*0.42*sin(x6)/(1.50 + cos(x1)), l63 = 0.13*ln(1.60 + 0.62*cos(x1)), l64 = 0.18*atan2(x3, 2 + cos(x5))/2, l65 = 0.21*atan2(x3, 2 + cos(x2))/2, l66 = (1.39 + 0.30*powi(cos(0.86*x1 + 0.28*x1), 3)))]
#[inertia(matrix(
    [l11*l11, l11*l21, 0, 0, l11*l51, l11*l61],
    [_, l21*l21 + l22*l22, l22*l32, 0, l21*l51 + l22*l52, l21*l61 + l22*l62],
    [_, _, l32*l32 + l33*l33, l33*l43, l32*l52, l32*l62 + l33*l63],
    [_, _, _, l43*l43 + l44*l44, 0, l43*l63 + l44*l64],
    [_, _, _, _, l51*l51 + l52*l52 + l55*l55, l51*l61 + l52*l62 + l55*l65],
    [_, _, _, _, _, l61*l61 + l62*l62 + l63*l63 + l64*l64 + l65*l65 + l66*l66],
))]
#[forces(
    p2*v3*v2*x1/(1 + powi(x1, 2)) + 1.41*1/sqrt(1.50 + powi(x3, 2)),
    p3*exp(0.20*x4) + p2*exp(0.20*x5) + tau*0.36,
    0.48*sin(0.89*x2 - 0.48*x5) - v2*sqrt(2 + powi(v1, 2)) - 0.81*powi(v2, 2) - tau*0.38,
    tau*1.22 - p2*v2*v4*tan(0.39*sin(x2))/2,
    tau*1.66 + 0.75*powi(v2, 2) + 1.94*v4/(1 + powi(x1, 2)) + tau*1.48,
    1.30*cos(0.54*x2 - 0.24*x5 + 1.12),
)]
#[potential_energy(sin(p1*x3 - 0.58))]
#[constraint(row1: (1.50 - 0.18*x6/(1 + powi(x6, 2)))*dot(v2) + 0.12*tan(0.72*sin(x5))/2*dot(v3) - 0.20*cos(0.74*x2 - 1.14)*dot(v5) + 0.41*v6 + 0.41*sin(0.49*x6 + 0.80*x6) == 0)]
#[independent(v6, v1, v4, v5, v3, v2)]
pub struct Random93 {
    #[nominal(1.00)]
    pub p1: f64,
    #[nominal(1.12)]
    pub p2: f64,
    #[nominal(0.60)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = 1.39*dot(x1) + 0.31*cos(0.89*x2 - 0.65)*dot(x5) + 0.50*0.63*sin(x1)/(1.50 + cos(x1)),
    v2 = 1.09*dot(x2) - 0.11*exp(-powi(x3, 2)/2),
    v3 = (1.07 + 0.18*cos(1.19*x2))*dot(x3) - 0.25*cos(0.94*x1)*dot(x4) - 0.25*exp(-powi(x1, 2)/2),
    v4 = (1.22 - 0.33*ln(1.60 + 0.81*cos(x5)))*dot(x4) + 0.19*sin(p2*x2 - 0.64)*dot(x2) - 0.18*atan2(x4, 2 + cos(x1))/2,
    v5 = dot(x5) - 0.30*cos(1.19*x5 - 0.13)*dot(x2) - 0.32*tan(0.48*sin(t))/2,
)]
#[inertia(diag(1.31, (1.31 - 0.16*sin(1.15*x5 + 0.66*x3)), (1.06 - 0.14*cos(0.87*x2 + 0.87*t - 1.04)), (1.32 + 0.12*cos(0.78*t + 1.42)), (1.12 + 0.18*x4/(1 + powi(x4, 2)))))]
#[forces(
    p1*1.93 - v2*v2/1.12 - v1*v1/(1.07 - 0.11*1/sqrt(1.50 + powi(x5, 2))) - p2*x3,
    p1*1.43 - 0.79*v2 - p2*x5 - 1.68*powi(v3, 2),
    0,
    1.95*powi(v3, 2) + 1.23*v3,
    0,
)]
#[constraint(row1: 1.85*x1 + 0.24*x2 + 0.30*sin(0.73*t) + 0.12 == 0)]
#[constraint(row2: 1.22*v3 - 0.24*sin(v3 + tan(0.35*sin(x4))/2*v2) + 0.32*0.93*sin(x4)/(1.50 + cos(x4)) == 0)]
#[constraint(row3: 1.63*v4 + 0.23*sin(v4 + x2/(1 + powi(x2, 2))*v3) + 0.37*cos(0.55*t) == 0)]
#[output(place = atan2(x1, 2 + cos(t))/2, power = 0.73*v2/(1 + powi(t, 2)) + p1*x5 + 1.04*v5 + p2*exp(0.20*x3), push = exp(-powi(x1, 2)/2)*dot(v2) + v5*ddot(x5), pull = (1.01 - 0.34*0.73*sin(x1)/(1.50 + cos(x1)))*reaction(row1) - push, share = pull/(1.03 + powi(reaction(row1), 2)))]
pub struct Random94 {
    #[nominal(1.02)]
    pub p1: f64,
    #[nominal(1.00)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[define(l11 = (1.26 - 0.20*cos(0.93*t)), l21 = 0.34*exp(-powi(x1, 2)/2), l22 = 1.39, l31 = 0.16*t/(1 + powi(t, 2)), l33 = (1.18 + 0.11*sin(0.63*t)), l41 = 0.29*tan(0.40*sin(x3))/2, l42 = 0.34*x4/(1 + powi(x4, 2)), l43 = 0.11*ln(1.60 + 0.94*cos(x4)), l44 = 1.30, l51 = 0.32*cos(0.78*x5 + 0.77), l52 = 0.28*powi(cos(0.57*x3), 3), l53 = 0.37*atan2(x1, 2 + cos(x3))/2, l54 = 0.29*0.42*sin(t)/(1.50 + cos(x5)), l55 = (1.30 - 0.22*0.31*sin(x5)/(1.50 + cos(x5))))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, l11*l41, l11*l51],
    [_, l21*l21 + l22*l22, l21*l31, l21*l41 + l22*l42, l21*l51 + l22*l52],
    [_, _, l31*l31 + l33*l33, l31*l41 + l33*l43, l31*l51 + l33*l53],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44, l41*l51 + l42*l52 + l43*l53 + l44*l54],
    [_, _, _, _, l51*l51 + l52*l52 + l53*l53 + l54*l54 + l55*l55],
))]
#[forces(
    1.91*powi(dot(x3), 2),
    dot(x1)*dot(x4)/(1.21 + 0.13*tan(0.79*sin(x1))/2) + p1*dot(x3)*dot(x1)*cos(0.42*x1 - 0.68) + 0.69*cos(0.51*x2) + 1.37*dot(x2),
    p2*exp(0.20*t) + p1*1.94,
    1.12*dot(x3)/(1 + powi(x5, 2)),
    dot(x3)*dot(x3)/(1.18 + 0.22*cos(0.50*x4)) + dot(x5)*dot(x2)/(1.30 + 0.21*cos(1.09*t + 0.52*x3)) + 1.98*powi(dot(x5), 2) + dot(x4)*dot(x1)/(1.12 - 0.15*atan2(x4, 2 + cos(x1))/2),
)]
#[constraint(row1: 1.55*x1 + 0.13*sin(x1) + 0.25*powi(x2, 2)/2 + 0.30*sin(1.41*t) + 0.65 == 0)]
#[constraint(row2: (1.50 + 0.28*atan2(x2, 2 + cos(x5))/2)*dot(x4) + 0.30*sin(0.63*x3)*cos(1.01*x2 - 0.50*x1 - 0.16)*dot(x2) == 0)]
#[constraint(row3: powi(dot(x5), 2) + 0.28*powi(dot(x1), 2) - (2 + 0.28*powi(cos(0.56*x5 - 0.45*x3), 3)) == 0)]
#[constraint(row4: (1.50 - 0.14*sin(1.10*x1 + 0.45*x5))*ddot(x3) + 0.15*cos(0.94*x4 + 0.72*t)*ddot(x2) + 0.23*sin(0.79*t + 1.20)*ddot(x1) + 0.25*exp(-powi(x3, 2)/2) == 0)]
#[independent(dot(x2), dot(x3), dot(x5))]
pub struct Random96 {
    #[nominal(1.36)]
    pub p1: f64,
    #[nominal(0.69)]
    pub p2: f64,
    #[nominal(0.68)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    dot(x1) = 1.05*v1 - 0.13*atan2(x2, 2 + cos(x2))/2*v5,
    dot(x2) = (1.32 - 0.31*ln(1.60 + 0.45*cos(x2)))*v2 - 0.37*atan2(x4, 2 + cos(x1))/2*v3,
    dot(x3) = (1.30 - 0.27*0.63*sin(x1)/(1.50 + cos(x4)))*v3,
    dot(x4) = 1.25*v4 + 0.18*sin(0.42*x5 - 1.34)*v5,
    dot(x5) = (1.10 - 0.16*sin(0.71*x1 + 0.89))*v5,
)]
#[define(l11 = (1.31 + 0.21*powi(cos(0.69*x2 - 0.59), 3)), l21 = 0.25*sin(p1*x3 - 0.27), l22 = 1.21, l31 = 0.29*tan(0.83*sin(x1))/2, l32 = 0.13*sin(p1*x4 + 0.60), l33 = (1.00 + 0.20*sin(p1*x2 - 0.80)), l43 = 0.32*sin(0.55*x2 + 0.77*x5 - 0.65), l44 = (1.10 + 0.35*ln(1.60 + 0.34*cos(x2))), l51 = 0.28*exp(-powi(x4, 2)/2), l55 = (1.00 - 0.30*ln(1.60 + 0.59*cos(x3))))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, 0, l11*l51],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, 0, l21*l51],
    [_, _, l31*l31 + l32*l32 + l33*l33, l33*l43, l31*l51],
    [_, _, _, l43*l43 + l44*l44, 0],
    [_, _, _, _, l51*l51 + l55*l55],
))]
#[forces(
    1.82*powi(v3, 2) + p1*exp(0.20*x1) + p1*x1,
    0.34*v5,
    p1*x5,
    p1*x1 + v2*v4/1.12,
    p1*0.30 + 0.52*v3/(1 + powi(x1, 2)) + 1.68*1/sqrt(1.50 + powi(x2, 2)),
)]
#[constraint(row1: v3 + 0.19*cos(0.97*x5 - 0.35*x3)*v4 - 0.25*cos(0.81*x5)*v5 == 0)]
#[constraint(row2: (1.50 - 0.26*cos(1.14*x1))*v1 + 0.12*sin(0.94*x1 - 0.70*x2)*v4 + 0.29*exp(-powi(x3, 2)/2)*v5 == 0)]
#[constraint(row3: (1.50 - 0.29*atan2(x1, 2 + cos(x5))/2)*v2 - 0.18*ln(1.60 + 0.53*cos(x4))*v4 - 0.30*exp(-powi(x2, 2)/2)*v5 - 0.34*sin(p1*x3 + 0.55)*v3 == 0)]
#[constraint(again1: (1.08 + 0.31*ln(1.60 + 0.87*cos(x2)))*(v3 + 0.19*cos(0.97*x5 - 0.35*x3)*v4 - 0.25*cos(0.81*x5)*v5) + 0.78*((1.50 - 0.29*atan2(x1, 2 + cos(x5))/2)*v2 - 0.18*ln(1.60 + 0.53*cos(x4))*v4 - 0.30*exp(-powi(x2, 2)/2)*v5 - 0.34*sin(p1*x3 + 0.55)*v3) == 0, redundant)]
pub struct Random97 {
    #[nominal(0.61)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + ln(1.60 + 0.59*cos(t))*dot(x1),
    v3 = dot(x3) + x4/(1 + powi(x4, 2))*dot(x2),
    v4 = dot(x4) + cos(0.76*x5)*dot(x2),
    v5 = dot(x5) + x3/(1 + powi(x3, 2))*dot(x1),
    v6 = dot(x6) + x5/(1 + powi(x5, 2))*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - ln(1.60 + 0.59*cos(t))*(v1),
    dot(x3) = v3 - x4/(1 + powi(x4, 2))*(v2 - ln(1.60 + 0.59*cos(t))*(v1)),
    dot(x4) = v4 - cos(0.76*x5)*(v2 - ln(1.60 + 0.59*cos(t))*(v1)),
    dot(x5) = v5 - x3/(1 + powi(x3, 2))*(v1),
    dot(x6) = v6 - x5/(1 + powi(x5, 2))*(v2 - ln(1.60 + 0.59*cos(t))*(v1)),
)]
#[inertia(diag((1.10 - 0.34*cos(1.18*x2 - 0.68*x4)), (1.27 - 0.19*1/sqrt(1.50 + powi(x1, 2))), (1.02 + 0.29*sin(0.67*x3 + 0.31*x1 + 1.49)), (1.38 - 0.29*sin(0.62*x2 + 0.88)), (1.04 + 0.14*0.48*sin(x6)/(1.50 + cos(x5))), (1.34 - 0.23*atan2(x2, 2 + cos(x4))/2)))]
#[forces(
    p2*exp(0.20*x1),
    0.94*x1/(1 + powi(x1, 2)),
    p1*t,
    p2*v2*v6*powi(cos(1.08*x1 + 0.75*x4 - 0.74), 3) + v4*sqrt(2 + powi(v5, 2)) + v6*sqrt(2 + powi(v2, 2)) + p1*v3*v3*0.79*sin(t)/(1.50 + cos(t)),
    0.53*0.80*sin(x4)/(1.50 + cos(x3)),
    0,
)]
#[configuration(x2 = 1.16*sin(1.19*x6 + 0.88*x3))]
#[constraint(bound: dot(v6) - 0.20*atan2(x5, 2 + cos(t))/2*dot(v3) - 0.23*tan(0.92*sin(x6))/2*dot(v5) + 0.33*x2/(1 + powi(x2, 2)) == 0)]
pub struct Random99 {
    #[nominal(1.01)]
    pub p1: f64,
    #[nominal(0.62)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + sin(1.07*x6 - 0.65*x6 + 0.86)*dot(x1),
    v3 = dot(x3) + powi(cos(0.75*x1 - 0.21), 3)*dot(x1),
    v4 = dot(x4) + atan2(x1, 2 + cos(x6))/2*dot(x2),
    v5 = dot(x5) + sin(0.84*x2)*dot(x3),
    v6 = dot(x6) + cos(0.81*x2 - 0.55*x3 - 0.62)*dot(x4),
    dot(x1) = v1,
    dot(x2) = v2 - sin(1.07*x6 - 0.65*x6 + 0.86)*(v1),
    dot(x3) = v3 - powi(cos(0.75*x1 - 0.21), 3)*(v1),
    dot(x4) = v4 - atan2(x1, 2 + cos(x6))/2*(v2 - sin(1.07*x6 - 0.65*x6 + 0.86)*(v1)),
    dot(x5) = v5 - sin(0.84*x2)*(v3 - powi(cos(0.75*x1 - 0.21), 3)*(v1)),
    dot(x6) = v6 - cos(0.81*x2 - 0.55*x3 - 0.62)*(v4 - atan2(x1, 2 + cos(x6))/2*(v2 - sin(1.07*x6 - 0.65*x6 + 0.86)*(v1))),
)]
#[define(l11 = 1.36, l21 = 0.33*1/sqrt(1.50 + powi(x6, 2)), l22 = (1.04 + 0.13*sin(1.02*x1)*cos(0.91*x6 - 0.63*x3)), l31 = 0.17*sin(1.07*x2 + 0.78*x4 + 1.45), l32 = 0.32*sin(0.99*x2 - 0.78*x3), l33 = (1.10 + 0.26*sin(0.81*x1 + 0.69)), l41 = 0.21*powi(cos(0.69*x4), 3), l42 = 0.31*sin(p3*x2 + 0.59), l43 = 0.35*cos(0.98*x6 + 0.34*x4 + 0.64), l44 = (1.26 - 0.27*cos(0.78*x4 - 0.77*x2)), l51 = 0.26*cos(0.55*x5 - 0.87*x1), l52 = 0.25*tan(0.64*sin(x1))/2, l53 = 0.32*1/sqrt(1.50 + powi(x1, 2)), l55 = (1.13 - 0.26*1/sqrt(1.50 + powi(x2, 2))), l61 = 0.22*sin(p2*x3 - 0.16), l62 = 0.30*tan(0.37*sin(x4))/2, l64 = 0.32*sin(p1*x4 - 0.83), l66 = (1.25 - 0.35*powi(cos(0.69*x5), 3)))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, l11*l41, l11*l51, l11*l61],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l21*l41 + l22*l42, l21*l51 + l22*l52, l21*l61 + l22*l62],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l32*l42 + l33*l43, l31*l51 + l32*l52 + l33*l53, l31*l61 + l32*l62],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44, l41*l51 + l42*l52 + l43*l53, l41*l61 + l42*l62 + l44*l64],
    [_, _, _, _, l51*l51 + l52*l52 + l53*l53 + l55*l55, l51*l61 + l52*l62],
    [_, _, _, _, _, l61*l61 + l62*l62 + l64*l64 + l66*l66],
))]
#[forces(
    v2*v5/(1.40 + 0.16*0.69*sin(x5)/(1.50 + cos(x1))),
    p3*exp(0.20*x5) - 0.95*powi(v4, 2),
    1.50*exp(-powi(x2, 2)/2) + v1*v4/1.18 + 0.98*v6 + 1.94*powi(v3, 2),
    v1*sqrt(2 + powi(v1, 2)) + p2*v2*v1*0.81*sin(x5)/(1.50 + cos(x3)) + p1*v4*v5*sin(1.17*x2),
    0.53*powi(v3, 2) + 1.73*v3 + tau*0.70,
    1.59*x1/(1 + powi(x1, 2)) + v4*sqrt(2 + powi(v5, 2)),
)]
#[potential_energy(cos(0.92*x4 + 1.32))]
pub struct Random100 {
    #[nominal(1.41)]
    pub p1: f64,
    #[nominal(0.80)]
    pub p2: f64,
    #[nominal(1.32)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[inertia(matrix(
    [((1.10 - 0.33*exp(-powi(t, 2)/2)))*((1.10 - 0.33*exp(-powi(t, 2)/2)))],
))]
#[forces(
    dot(x1)*dot(x1)/(1.04 + 0.20*powi(cos(1.20*t - 0.57*t), 3)) - 1.39*dot(x1),
)]
#[potential_energy(powi(cos(0.88*x1 - 0.51*x1), 3))]
#[constraint(row1: 1.50*dot(x1) - 0.50*ln(1.60 + 0.40*cos(x1)) == 0)]
#[output(place = powi(cos(1.01*x1), 3), power = p1*dot(x1)*dot(x1)*x1/(1 + powi(x1, 2)) - p1*1.01 - p1*1.55 - dot(x1)*dot(x1)/1.04, push = exp(-powi(t, 2)/2)*ddot(x1) + dot(x1)*ddot(x1), pull = (1.37 + 0.10*cos(0.88*x1 - 1.40))*reaction(row1) - push, share = pull/(1.47 + powi(reaction(row1), 2)))]
pub struct Random101 {
    #[nominal(0.64)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inertia(diag((1.28 + 0.30*sin(1.17*x4)), 1.24, (1.35 + 0.18*ln(1.60 + 0.93*cos(x1))), 1.37, (1.36 + 0.30*sin(0.48*x3 + 0.45*x4)), (1.09 - 0.15*sin(1.16*x3 - 0.73*x4))))]
#[forces(
    1.97*powi(dot(x1), 2) - p1*1.25,
    1.46*dot(x6),
    0,
    p3*x4 - 1.89*dot(x5) - p2*dot(x1)*dot(x5)*ln(1.60 + 0.46*cos(x4)) - 1.67*dot(x5)/(1 + powi(x1, 2)),
    p1*x1 + dot(x6)*dot(x1)/(1.10 + 0.25*exp(-powi(x3, 2)/2)) + 0.86*dot(x3)/(1 + powi(x4, 2)) + 0.84*powi(dot(x5), 2),
    p3*1.40,
)]
#[constraint(row1: 1.36*x5 + 0.18*powi(x2, 2)/2 + 0.58 == 0)]
#[constraint(row2: 1.46*x1 + 0.23*sin(x2) + 0.25*sin(x3) - 0.59 == 0)]
#[output(place = 1/sqrt(1.50 + powi(x5, 2)), power = 0.94*powi(dot(x5), 2) - p3*x2 - p3*dot(x4)*dot(x3)*0.59*sin(x5)/(1.50 + cos(x1)) - 0.78*dot(x5), push = x4/(1 + powi(x4, 2))*ddot(x4) + dot(x1)*ddot(x1), pull = (1.33 + 0.21*sin(1.00*x4))*reaction(row2) - push, share = pull/(1.36 + powi(reaction(row2), 2)))]
pub struct Random102 {
    #[nominal(0.67)]
    pub p1: f64,
    #[nominal(0.88)]
    pub p2: f64,
    #[nominal(1.46)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = 1.38*v1 - 0.27*1/sqrt(1.50 + powi(x1, 2)),
)]
#[inertia(diag(1.30))]
#[forces(
    1.87*v1/(1 + powi(x1, 2)) + 1.88*powi(v1, 2),
)]
#[potential_energy(0.98*sin(x1)/(1.50 + cos(x1)))]
#[constraint(row1: v1 == 0)]
#[output(place = sin(0.50*x1 + 0.73), power = p1*x1 + 1.49*v1, push = x1/(1 + powi(x1, 2))*dot(v1) + v1*ddot(x1), pull = (1.07 - 0.33*sin(1.16*x1 - 0.36))*reaction(row1) - push, share = pull/(1.76 + powi(reaction(row1), 2)))]
pub struct Random103 {
    #[nominal(0.82)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inertia(matrix(
    [((1.18 + 0.32*cos(0.40*x5)))*((1.18 + 0.32*cos(0.40*x5))), ((1.18 + 0.32*cos(0.40*x5)))*(0.36*sin(p1*x5 + 0.89)), ((1.18 + 0.32*cos(0.40*x5)))*(0.34*1/sqrt(1.50 + powi(x6, 2))), ((1.18 + 0.32*cos(0.40*x5)))*(0.23*sin(1.03*x6 - 0.22*x3)), 0, ((1.18 + 0.32*cos(0.40*x5)))*(0.28*cos(0.87*x1 + 0.65*x3))],
    [_, (0.36*sin(p1*x5 + 0.89))*(0.36*sin(p1*x5 + 0.89)) + ((1.04 + 0.26*sin(1.05*x3 - 0.22*x4)))*((1.04 + 0.26*sin(1.05*x3 - 0.22*x4))), (0.36*sin(p1*x5 + 0.89))*(0.34*1/sqrt(1.50 + powi(x6, 2))) + ((1.04 + 0.26*sin(1.05*x3 - 0.22*x4)))*(0.33*cos(0.81*x1)), (0.36*sin(p1*x5 + 0.89))*(0.23*sin(1.03*x6 - 0.22*x3)) + ((1.04 + 0.26*sin(1.05*x3 - 0.22*x4)))*(0.36*0.57*sin(x2)/(1.50 + cos(x2))), ((1.04 + 0.26*sin(1.05*x3 - 0.22*x4)))*(0.24*atan2(x2, 2 + cos(x4))/2), (0.36*sin(p1*x5 + 0.89))*(0.28*cos(0.87*x1 + 0.65*x3))],
    [_, _, (0.34*1/sqrt(1.50 + powi(x6, 2)))*(0.34*1/sqrt(1.50 + powi(x6, 2))) + (0.33*cos(0.81*x1))*(0.33*cos(0.81*x1)) + ((1.01 + 0.14*tan(0.92*sin(x6))/2))*((1.01 + 0.14*tan(0.92*sin(x6))/2)), (0.34*1/sqrt(1.50 + powi(x6, 2)))*(0.23*sin(1.03*x6 - 0.22*x3)) + (0.33*cos(0.81*x1))*(0.36*0.57*sin(x2)/(1.50 + cos(x2))) + ((1.01 + 0.14*tan(0.92*sin(x6))/2))*(0.26*x4/(1 + powi(x4, 2))), (0.33*cos(0.81*x1))*(0.24*atan2(x2, 2 + cos(x4))/2), (0.34*1/sqrt(1.50 + powi(x6, 2)))*(0.28*cos(0.87*x1 + 0.65*x3))],
    [_, _, _, (0.23*sin(1.03*x6 - 0.22*x3))*(0.23*sin(1.03*x6 - 0.22*x3)) + (0.36*0.57*sin(x2)/(1.50 + cos(x2)))*(0.36*0.57*sin(x2)/(1.50 + cos(x2))) + (0.26*x4/(1 + powi(x4, 2)))*(0.26*x4/(1 + powi(x4, 2))) + ((1.27 - 0.28*1/sqrt(1.50 + powi(x5, 2))))*((1.27 - 0.28*1/sqrt(1.50 + powi(x5, 2)))), (0.36*0.57*sin(x2)/(1.50 + cos(x2)))*(0.24*atan2(x2, 2 + cos(x4))/2) + ((1.27 - 0.28*1/sqrt(1.50 + powi(x5, 2))))*(0.28*x5/(1 + powi(x5, 2))), (0.23*sin(1.03*x6 - 0.22*x3))*(0.28*cos(0.87*x1 + 0.65*x3)) + ((1.27 - 0.28*1/sqrt(1.50 + powi(x5, 2))))*(0.14*tan(0.47*sin(x6))/2)],
    [_, _, _, _, (0.24*atan2(x2, 2 + cos(x4))/2)*(0.24*atan2(x2, 2 + cos(x4))/2) + (0.28*x5/(1 + powi(x5, 2)))*(0.28*x5/(1 + powi(x5, 2))) + ((1.22 + 0.33*exp(-powi(x2, 2)/2)))*((1.22 + 0.33*exp(-powi(x2, 2)/2))), (0.28*x5/(1 + powi(x5, 2)))*(0.14*tan(0.47*sin(x6))/2) + ((1.22 + 0.33*exp(-powi(x2, 2)/2)))*(0.36*ln(1.60 + 0.59*cos(x4)))],
    [_, _, _, _, _, (0.28*cos(0.87*x1 + 0.65*x3))*(0.28*cos(0.87*x1 + 0.65*x3)) + (0.14*tan(0.47*sin(x6))/2)*(0.14*tan(0.47*sin(x6))/2) + (0.36*ln(1.60 + 0.59*cos(x4)))*(0.36*ln(1.60 + 0.59*cos(x4))) + (1.20)*(1.20)],
))]
#[forces(
    dot(x3)*dot(x5)/(1.35 - 0.16*powi(cos(0.42*x6 + 0.29*x2 - 1.12), 3)),
    1.82*dot(x1)/(1 + powi(x4, 2)) + p1*x4 + p1*1.05,
    0,
    p1*exp(0.20*x5),
    0,
    p1*dot(x6)*dot(x2)*powi(cos(0.84*x4), 3) + p1*dot(x5)*dot(x5)*sin(p1*x1 + 0.38),
)]
#[constraint(height: 1.31*x3 + 0.24*sin(x3) + 0.22*powi(x1, 2)/2 + 0.11*powi(x2, 2)/2 + exp(0.39*x4)/2 + 0.35 == 0)]
#[constraint(height_rate: (1.13 - 0.23*cos(0.45*x2 + 0.70*x3))*(1.31*dot(x3) + 0.24*cos(x3)*dot(x3) + 0.22*x1*dot(x1) + 0.11*x2*dot(x2) + 0.39*exp(0.39*x4)*dot(x4)/2) == 0)]
#[constraint(further: (1.50 + 0.15*1/sqrt(1.50 + powi(x2, 2)))*dot(x6) + 0.12*sin(0.42*x5)*cos(0.41*x6 - 0.44*x4)*dot(x1) + 0.31*sin(1.18*x3)*dot(x2) + 0.21*cos(0.74*x6 - 0.69*x4)*dot(x4) == 0)]
#[output(place = sin(0.92*x6), power = 1.41*sin(p1*x6 - 0.51), push = x6/(1 + powi(x6, 2))*ddot(x4) + dot(x6)*ddot(x6))]
pub struct Random104 {
    #[nominal(0.63)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = (1.13 - 0.31*powi(cos(0.65*x1 + 0.23*x2), 3))*dot(x1) + 0.49*atan2(x1, 2 + cos(x1))/2,
    v2 = 1.29*dot(x2) + 0.38*sin(0.63*x2)*cos(1.13*x2 + 0.33*x1)*dot(x1) - 0.21*x1/(1 + powi(x1, 2)),
)]
#[inertia(diag((1.36 - 0.21*sin(0.43*x2 + 0.70*x1 + 1.10)), (1.24 - 0.28*sin(0.63*x2))))]
#[forces(
    p1*1.12 + 0.54*v2 + v1*v2/1.10,
    p3*x1,
)]
#[constraint(height: 1.67*x1 + 0.24*sin(x1) - 0.24 == 0)]
#[constraint(first: (1.50 + 0.26*exp(-powi(x1, 2)/2))*v2 - 0.22*cos(0.90*x1 + 0.28*x1 + 1.07)*v1 == 0)]
#[constraint(second: 1.67*dot(x1) + 0.24*cos(x1)*dot(x1) - 0.50*tan(0.66*sin(x1))/2*((1.50 + 0.26*exp(-powi(x1, 2)/2))*v2 - 0.22*cos(0.90*x1 + 0.28*x1 + 1.07)*v1) == 0)]
pub struct Random105 {
    #[nominal(0.60)]
    pub p1: f64,
    #[nominal(1.34)]
    pub p2: f64,
    #[nominal(1.44)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1) - 0.40*sin(0.49*x2 + 0.62*x3),
    v2 = (1.21 - 0.34*0.90*sin(x2)/(1.50 + cos(x3)))*dot(x2) - 0.40*atan2(x1, 2 + cos(x1))/2*dot(x5) + 0.44*sin(0.57*x2),
    v3 = dot(x3) + 0.57*sin(0.98*x2),
    v4 = (1.09 + 0.29*tan(0.92*sin(x5))/2)*dot(x4) - 0.34*1/sqrt(1.50 + powi(x3, 2))*dot(x3) + 0.26*0.67*sin(x4)/(1.50 + cos(x1)),
    v5 = dot(x5) - 0.22*sin(0.91*x1 - 0.81*x6)*dot(x2) + 0.19*ln(1.60 + 0.70*cos(x3)),
    v6 = dot(x6) + 0.32*sin(0.43*x4 + 0.74*x1)*cos(1.03*x1 + 0.41*x5)*dot(x3) + 0.26*sin(0.40*x2 - 0.80*x6),
)]
#[inertia(diag((1.32 + 0.15*cos(1.02*x3 + 0.29*x3)), 1.14, 1.30, 1.36, (1.35 + 0.21*ln(1.60 + 0.87*cos(x4))), (1.26 + 0.18*sin(0.53*x5 + 0.35*x6))))]
#[forces(
    v6*v3/(1.16 + 0.15*cos(0.75*x5)) + p2*0.84 + 1.81*powi(v1, 2) + 0.94*powi(v2, 2),
    p1*exp(0.20*x1) - v5*sqrt(2 + powi(v6, 2)) - v5*sqrt(2 + powi(v1, 2)),
    0.94*atan2(x2, 2 + cos(x3))/2 - p1*v6*v1*powi(cos(1.05*x6 - 0.50), 3),
    p1*x6 + p2*v1*v2*cos(1.16*x2 - 0.56*x4) + 1.31*v4,
    p2*v2*v6*exp(-powi(x3, 2)/2),
    p2*x5 - p2*v2*v5*1/sqrt(1.50 + powi(x5, 2)) - v6*v4/(1.35 + 0.22*1/sqrt(1.50 + powi(x1, 2))),
)]
#[potential_energy(cos(1.13*x1))]
#[configuration(x1 = 0.87*cos(0.41*x4 + 0.60*x4 + 0.80), x2 = 1.04*cos(0.54*x6))]
pub struct Random106 {
    #[nominal(0.54)]
    pub p1: f64,
    #[nominal(1.50)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    dot(x1) = (1.30 - 0.33*powi(cos(0.64*x1 + 0.46*x1), 3))*v1,
)]
#[inertia(matrix(
    [((1.37 + 0.18*sin(1.12*x1 + 0.30*x1)))*((1.37 + 0.18*sin(1.12*x1 + 0.30*x1)))],
))]
#[forces(
    0.75*v1/(1 + powi(x1, 2)) + v1*sqrt(2 + powi(v1, 2)) + 0.34*v1/(1 + powi(x1, 2)) + p1*v1*v1*x1/(1 + powi(x1, 2)),
)]
#[configuration(of(q1), x1 = 1.25*q1)]
#[output(place = cos(0.50*x1 + 0.26*x1), power = p1*exp(0.20*x1) + 1.62*powi(v1, 2) + 1.96*atan2(x1, 2 + cos(x1))/2 + v1*v1/(1.33 - 0.13*1/sqrt(1.50 + powi(x1, 2))), push = x1/(1 + powi(x1, 2))*dot(v1) + v1*ddot(x1))]
pub struct Random107 {
    #[nominal(1.04)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = (1.39 - 0.33*0.33*sin(x5)/(1.50 + cos(x4)))*dot(x1) - 0.23*tan(0.53*sin(x2))/2*dot(x2) - 0.20*tan(0.45*sin(x1))/2,
    v2 = (1.01 - 0.12*1/sqrt(1.50 + powi(x5, 2)))*dot(x2) - 0.50*cos(0.40*x5 - 0.39*x5),
    v3 = (1.33 + 0.14*sin(0.72*x4))*dot(x3) + 0.10*tan(0.74*sin(x3))/2*dot(x1) + 0.52*0.98*sin(x3)/(1.50 + cos(x6)),
    v4 = dot(x4) - 0.14*tan(0.90*sin(x2))/2*dot(x3) - 0.32*t/(1 + powi(t, 2)),
    v5 = 1.38*dot(x5) + 0.18*cos(0.52*x1 + 0.24*x4)*dot(x3) + 0.40*atan2(x4, 2 + cos(x4))/2,
    v6 = 1.21*dot(x6) - 0.22*ln(1.60 + 0.55*cos(x5)),
)]
#[inertia(matrix(
    [(1.04)*(1.04), (1.04)*(0.35*ln(1.60 + 1.00*cos(x2))), 0, (1.04)*(0.38*sin(1.13*x6 - 1.28)), 0, 0],
    [_, (0.35*ln(1.60 + 1.00*cos(x2)))*(0.35*ln(1.60 + 1.00*cos(x2))) + ((1.20 + 0.10*sin(0.57*t + 0.71*x3 - 1.42)))*((1.20 + 0.10*sin(0.57*t + 0.71*x3 - 1.42))), 0, (0.35*ln(1.60 + 1.00*cos(x2)))*(0.38*sin(1.13*x6 - 1.28)) + ((1.20 + 0.10*sin(0.57*t + 0.71*x3 - 1.42)))*(0.16*sin(p2*x6 - 0.65)), ((1.20 + 0.10*sin(0.57*t + 0.71*x3 - 1.42)))*(0.19*exp(-powi(x1, 2)/2)), 0],
    [_, _, ((1.23 - 0.19*exp(-powi(x2, 2)/2)))*((1.23 - 0.19*exp(-powi(x2, 2)/2))), ((1.23 - 0.19*exp(-powi(x2, 2)/2)))*(0.26*0.70*sin(x5)/(1.50 + cos(t))), ((1.23 - 0.19*exp(-powi(x2, 2)/2)))*(0.38*cos(0.59*t - 0.78*x5)), 0],
    [_, _, _, (0.38*sin(1.13*x6 - 1.28))*(0.38*sin(1.13*x6 - 1.28)) + (0.16*sin(p2*x6 - 0.65))*(0.16*sin(p2*x6 - 0.65)) + (0.26*0.70*sin(x5)/(1.50 + cos(t)))*(0.26*0.70*sin(x5)/(1.50 + cos(t))) + ((1.17 - 0.35*sin(0.81*x3)*cos(1.12*t)))*((1.17 - 0.35*sin(0.81*x3)*cos(1.12*t))), (0.16*sin(p2*x6 - 0.65))*(0.19*exp(-powi(x1, 2)/2)) + (0.26*0.70*sin(x5)/(1.50 + cos(t)))*(0.38*cos(0.59*t - 0.78*x5)), ((1.17 - 0.35*sin(0.81*x3)*cos(1.12*t)))*(0.25*1/sqrt(1.50 + powi(x6, 2)))],
    [_, _, _, _, (0.19*exp(-powi(x1, 2)/2))*(0.19*exp(-powi(x1, 2)/2)) + (0.38*cos(0.59*t - 0.78*x5))*(0.38*cos(0.59*t - 0.78*x5)) + (1.28)*(1.28), (1.28)*(0.27*1/sqrt(1.50 + powi(x4, 2)))],
    [_, _, _, _, _, (0.25*1/sqrt(1.50 + powi(x6, 2)))*(0.25*1/sqrt(1.50 + powi(x6, 2))) + (0.27*1/sqrt(1.50 + powi(x4, 2)))*(0.27*1/sqrt(1.50 + powi(x4, 2))) + ((1.12 + 0.30*1/sqrt(1.50 + powi(x1, 2))))*((1.12 + 0.30*1/sqrt(1.50 + powi(x1, 2))))],
))]
#[forces(
    p3*exp(0.20*t) + p2*0.33,
    v6*v3/(1.11 + 0.18*sin(0.68*x6 + 1.14)),
    v2*sqrt(2 + powi(v5, 2)) - v6*sqrt(2 + powi(v1, 2)) - 0.95*v3/(1 + powi(x2, 2)) - 0.62*v2,
    0,
    p1*v4*v4*sin(0.55*x5 - 0.11)*cos(1.17*x3) - p2*0.42 - v2*v4/(1.39 + 0.26*tan(0.65*sin(x6))/2),
    0,
)]
#[potential_energy(ln(1.60 + 0.87*cos(x2)))]
#[constraint(row1: v1 + 0.58*sin(0.90*x2 + 0.19)*cos(0.85*x5)*v3 + 0.68*cos(1.20*t + 0.36)*v5 + 0.55*0.35*sin(x4)/(1.50 + cos(x5))*v2 == 0)]
#[constraint(row2: v4 + 0.51*sin(p3*x3 + 0.59)*v3 + 0.50*atan2(x3, 2 + cos(t))/2*v5 + 0.64*atan2(x2, 2 + cos(x6))/2*v2 + 0.40*powi(cos(0.64*x4 + 0.71*x4), 3) == 0)]
#[constraint(row3: v6 + 0*v3 + 0.52*sin(1.10*t + 0.68*x2)*cos(0.79*x4 - 1.28)*v5 + 0.69*cos(0.55*x6)*v2 == 0)]
#[complement(
    w1 = [-(1.27 + 0.12*sin(p1*x6 + 0.29))*(0.58*sin(0.90*x2 + 0.19)*cos(0.85*x5)), 0, (1.27 + 0.12*sin(p1*x6 + 0.29)), -(1.27 + 0.12*sin(p1*x6 + 0.29))*(0.51*sin(p3*x3 + 0.59)), 0, -(1.27 + 0.12*sin(p1*x6 + 0.29))*(0)],
    w2 = [-(1.37 + 0.34*ln(1.60 + 0.44*cos(x6)))*(0.68*cos(1.20*t + 0.36)), 0, 0, -(1.37 + 0.34*ln(1.60 + 0.44*cos(x6)))*(0.50*atan2(x3, 2 + cos(t))/2), (1.37 + 0.34*ln(1.60 + 0.44*cos(x6))), -(1.37 + 0.34*ln(1.60 + 0.44*cos(x6)))*(0.52*sin(1.10*t + 0.68*x2)*cos(0.79*x4 - 1.28))],
    w3 = [-(1.07 + 0.10*sin(0.69*x1 - 0.80*x6))*(0.55*0.35*sin(x4)/(1.50 + cos(x5))), (1.07 + 0.10*sin(0.69*x1 - 0.80*x6)), 0, -(1.07 + 0.10*sin(0.69*x1 - 0.80*x6))*(0.64*atan2(x2, 2 + cos(x6))/2), 0, -(1.07 + 0.10*sin(0.69*x1 - 0.80*x6))*(0.69*cos(0.55*x6))],
)]
pub struct Random109 {
    #[nominal(0.83)]
    pub p1: f64,
    #[nominal(1.07)]
    pub p2: f64,
    #[nominal(1.20)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[inertia(matrix(
    [((1.22 - 0.34*exp(-powi(x1, 2)/2)))*((1.22 - 0.34*exp(-powi(x1, 2)/2)))],
))]
#[forces(
    0,
)]
#[potential_energy(x1/(1 + powi(x1, 2)))]
#[independent(s1 = (1.50 - 0.23*sin(p2*x1 + 0.77))*dot(x1) + 0.48*1/sqrt(1.50 + powi(x1, 2)))]
#[output(place = 0.55*sin(x1)/(1.50 + cos(x1)), power = 1.92*dot(x1), push = sin(0.93*x1)*ddot(x1) + dot(x1)*ddot(x1))]
pub struct Random110 {
    #[nominal(1.28)]
    pub p1: f64,
    #[nominal(0.77)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[inputs(tau)]
#[inertia(diag((1.25 - 0.13*atan2(x1, 2 + cos(x1))/2)))]
#[forces(
    0.97*sin(0.51*x1),
)]
#[constraint(row1: dot(x1) == 0)]
pub struct Random111 {
    #[nominal(1.12)]
    pub p1: f64,
    #[nominal(0.74)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1) + 0.36*sin(1.18*x5 - 0.85),
    v2 = (1.31 + 0.18*sin(0.47*x1 - 1.08))*dot(x2) - 0.44*atan2(x5, 2 + cos(x6))/2,
    v3 = (1.10 - 0.20*tan(0.65*sin(x2))/2)*dot(x3) - 0.27*powi(cos(0.55*x4), 3)*dot(x2) + 0.59*sin(0.70*x5 + 0.64*x3 + 0.65),
    v4 = dot(x4) - 0.32*t/(1 + powi(t, 2))*dot(x6) - 0.50*powi(cos(0.77*x2 - 0.51*x4), 3),
    v5 = (1.07 - 0.26*1/sqrt(1.50 + powi(x6, 2)))*dot(x5) + 0.11*sin(p2*x2 - 0.37)*dot(x2) + 0.17*ln(1.60 + 0.51*cos(x1)),
    v6 = dot(x6) - 0.21*x1/(1 + powi(x1, 2))*dot(x1) - 0.43*sin(1.12*x2),
)]
#[inertia(matrix(
    [((1.23 + 0.23*sin(1.12*x4)))*((1.23 + 0.23*sin(1.12*x4))), ((1.23 + 0.23*sin(1.12*x4)))*(0.11*cos(0.43*x4 - 1.19)), ((1.23 + 0.23*sin(1.12*x4)))*(0.23*exp(-powi(x5, 2)/2)), ((1.23 + 0.23*sin(1.12*x4)))*(0.19*t/(1 + powi(t, 2))), ((1.23 + 0.23*sin(1.12*x4)))*(0.38*exp(-powi(x4, 2)/2)), 0],
    [_, (0.11*cos(0.43*x4 - 1.19))*(0.11*cos(0.43*x4 - 1.19)) + ((1.19 + 0.24*0.61*sin(x5)/(1.50 + cos(x4))))*((1.19 + 0.24*0.61*sin(x5)/(1.50 + cos(x4)))), (0.11*cos(0.43*x4 - 1.19))*(0.23*exp(-powi(x5, 2)/2)), (0.11*cos(0.43*x4 - 1.19))*(0.19*t/(1 + powi(t, 2))) + ((1.19 + 0.24*0.61*sin(x5)/(1.50 + cos(x4))))*(0.31*1/sqrt(1.50 + powi(x5, 2))), (0.11*cos(0.43*x4 - 1.19))*(0.38*exp(-powi(x4, 2)/2)) + ((1.19 + 0.24*0.61*sin(x5)/(1.50 + cos(x4))))*(0.13*x6/(1 + powi(x6, 2))), 0],
    [_, _, (0.23*exp(-powi(x5, 2)/2))*(0.23*exp(-powi(x5, 2)/2)) + ((1.28 - 0.32*exp(-powi(t, 2)/2)))*((1.28 - 0.32*exp(-powi(t, 2)/2))), (0.23*exp(-powi(x5, 2)/2))*(0.19*t/(1 + powi(t, 2))), (0.23*exp(-powi(x5, 2)/2))*(0.38*exp(-powi(x4, 2)/2)) + ((1.28 - 0.32*exp(-powi(t, 2)/2)))*(0.17*sin(p1*x2 + 0.64)), ((1.28 - 0.32*exp(-powi(t, 2)/2)))*(0.31*exp(-powi(t, 2)/2))],
    [_, _, _, (0.19*t/(1 + powi(t, 2)))*(0.19*t/(1 + powi(t, 2))) + (0.31*1/sqrt(1.50 + powi(x5, 2)))*(0.31*1/sqrt(1.50 + powi(x5, 2))) + ((1.32 - 0.34*0.36*sin(x2)/(1.50 + cos(x4))))*((1.32 - 0.34*0.36*sin(x2)/(1.50 + cos(x4)))), (0.19*t/(1 + powi(t, 2)))*(0.38*exp(-powi(x4, 2)/2)) + (0.31*1/sqrt(1.50 + powi(x5, 2)))*(0.13*x6/(1 + powi(x6, 2))) + ((1.32 - 0.34*0.36*sin(x2)/(1.50 + cos(x4))))*(0.34*atan2(x4, 2 + cos(x4))/2), ((1.32 - 0.34*0.36*sin(x2)/(1.50 + cos(x4))))*(0.38*sin(1.05*x5 - 0.88))],
    [_, _, _, _, (0.38*exp(-powi(x4, 2)/2))*(0.38*exp(-powi(x4, 2)/2)) + (0.13*x6/(1 + powi(x6, 2)))*(0.13*x6/(1 + powi(x6, 2))) + (0.17*sin(p1*x2 + 0.64))*(0.17*sin(p1*x2 + 0.64)) + (0.34*atan2(x4, 2 + cos(x4))/2)*(0.34*atan2(x4, 2 + cos(x4))/2) + ((1.36 - 0.34*1/sqrt(1.50 + powi(t, 2))))*((1.36 - 0.34*1/sqrt(1.50 + powi(t, 2)))), (0.17*sin(p1*x2 + 0.64))*(0.31*exp(-powi(t, 2)/2)) + (0.34*atan2(x4, 2 + cos(x4))/2)*(0.38*sin(1.05*x5 - 0.88)) + ((1.36 - 0.34*1/sqrt(1.50 + powi(t, 2))))*(0.22*ln(1.60 + 0.56*cos(x5)))],
    [_, _, _, _, _, (0.31*exp(-powi(t, 2)/2))*(0.31*exp(-powi(t, 2)/2)) + (0.38*sin(1.05*x5 - 0.88))*(0.38*sin(1.05*x5 - 0.88)) + (0.22*ln(1.60 + 0.56*cos(x5)))*(0.22*ln(1.60 + 0.56*cos(x5))) + ((1.12 + 0.14*sin(0.91*x5)))*((1.12 + 0.14*sin(0.91*x5)))],
))]
#[forces(
    p2*1.77 - p2*exp(0.20*x1) - 1.97*tan(0.58*sin(x2))/2,
    p2*v2*v1*sin(0.70*x1 + 0.77),
    0,
    v2*v5/(1.16 + 0.31*x6/(1 + powi(x6, 2))) + 0.84*v5,
    0.52*v5 - 1.60*powi(v2, 2) - v6*sqrt(2 + powi(v6, 2)) - p1*x1,
    p1*v4*v5*sin(0.56*x3 + 0.32) + p1*1.32 + 0.80*v5,
)]
#[constraint(row1: v5 - 0.22*tan(0.81*sin(x1))/2*v4 - 0.24*1/sqrt(1.50 + powi(x6, 2))*v2 == 0)]
#[constraint(row2: 1.62*v6 + 0.32*ln(1.60 + 0.38*cos(x3))*v4 == 0)]
#[constraint(row3: 1.09*v3 - 0.25*sqrt(1.50 + powi(v2, 2) + powi(v4, 2)) + 0.56*0.73*sin(x4)/(1.50 + cos(x4)) == 0)]
#[constraint(row4: 1.98*v1 + 0.11*sqrt(1.50 + powi(v4, 2) + powi(v2, 2)) + 0.40*cos(0.49*t - 0.68*t) == 0)]
pub struct Random112 {
    #[nominal(1.26)]
    pub p1: f64,
    #[nominal(1.29)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inputs(tau)]
#[inertia(diag(1.37, (1.39 - 0.30*atan2(x6, 2 + cos(x5))/2), (1.10 - 0.33*atan2(x4, 2 + cos(x6))/2), (1.33 + 0.23*1/sqrt(1.50 + powi(x6, 2))), (1.02 - 0.32*cos(0.64*x3 - 0.47*x2 - 0.45)), 1.39))]
#[forces(
    1.76*powi(dot(x6), 2),
    1.14*dot(x2)/(1 + powi(x2, 2)) + 0.84*sin(p1*x3 + 0.83),
    1.71*powi(dot(x3), 2) + p1*x5 + 0.30*powi(dot(x2), 2),
    p1*dot(x2)*dot(x1)*exp(-powi(x4, 2)/2) - p1*exp(0.20*x1) - 0.88*dot(x4)/(1 + powi(x1, 2)),
    tau*1.71 + dot(x6)*sqrt(2 + powi(dot(x6), 2)) + p1*dot(x4)*dot(x6)*1/sqrt(1.50 + powi(x6, 2)) + p1*dot(x3)*dot(x6)*sin(0.91*x2 + 0.25),
    p1*x3 - dot(x1)*sqrt(2 + powi(dot(x1), 2)) - p1*x2 - 1.45*tan(0.32*sin(x6))/2,
)]
#[constraint(row1: ddot(x5) + 0.22*cos(0.65*x6 - 0.75*x1)*ddot(x3) + 0.15*sin(0.42*x5 + 0.46*x2)*ddot(x2) + 0.68*dot(x3)/sqrt(1.20 + powi(dot(x5), 2)) == 0)]
#[constraint(row2: ddot(x6) + 0.26*0.44*sin(x3)/(1.50 + cos(x1))*ddot(x3) - 0.24*exp(-powi(x3, 2)/2)*ddot(x2) + 0.47*dot(x3)*dot(x3)*x4/(1 + powi(x4, 2)) == 0)]
#[constraint(row3: ddot(x4) + 0.12*ln(1.60 + 0.45*cos(x3))*ddot(x3) - 0.15*0.48*sin(x5)/(1.50 + cos(x6))*ddot(x2) + 0.27*dot(x2)*dot(x5)*0.54*sin(x6)/(1.50 + cos(x4)) == 0)]
#[constraint(row4: ddot(x1) + 0.23*powi(cos(0.68*x1 - 0.81*x3), 3)*ddot(x3) + 0.29*sin(1.08*x4 + 0.37*x1)*ddot(x2) + 0.79*dot(x2)*dot(x3)*powi(cos(0.84*x1 + 0.87*x3 - 0.76), 3) == 0)]
#[output(place = cos(0.87*x6 - 0.65), power = p1*exp(0.20*x2) - p1*exp(0.20*x2) - p1*dot(x4)*dot(x2)*atan2(x6, 2 + cos(x1))/2 - p1*exp(0.20*x2), push = sin(0.44*x3 + 0.51)*ddot(x3) + dot(x2)*ddot(x2), pull = (1.07 + 0.11*0.62*sin(x5)/(1.50 + cos(x5)))*reaction(row4) - push, share = pull/(1.42 + powi(reaction(row4), 2)))]
pub struct Random113 {
    #[nominal(1.42)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag((1.37 + 0.14*exp(-powi(x2, 2)/2)), 1.38))]
#[forces(
    p1*dot(x1)*dot(x2)*sin(0.99*x1 + 0.39*x1),
    0.48*powi(cos(1.08*x2 + 1.47), 3) + p1*dot(x2)*dot(x1)*sin(0.80*x1 - 0.71*x2 - 0.88),
)]
#[potential_energy(sin(0.71*x2 + 0.85*x1))]
#[constraint(row1: 1.91*x2 - 0.44 == 0)]
#[constraint(row2: 1.81*dot(x1) + 0.26*sqrt(1.50 + powi(dot(x2), 2) + powi(dot(x2), 2)) + 0.32*ln(1.60 + 0.64*cos(x1)) == 0)]
#[output(place = 0.64*sin(x2)/(1.50 + cos(x1)), power = 1.17*dot(x2) + 1.14*dot(x1)/(1 + powi(x1, 2)) + 1.21*dot(x2)/(1 + powi(x1, 2)) + dot(x1)*sqrt(2 + powi(dot(x1), 2)), push = cos(1.10*x2 + 0.85*x1)*ddot(x1) + dot(x2)*ddot(x2), pull = (1.36 + 0.22*x2/(1 + powi(x2, 2)))*reaction(row1) - push, share = pull/(1.40 + powi(reaction(row1), 2)))]
pub struct Random114 {
    #[nominal(1.45)]
    pub p1: f64,
    #[nominal(1.49)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + sin(0.74*x1 - 0.58*x2)*cos(0.79*x2 - 1.34)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - sin(0.74*x1 - 0.58*x2)*cos(0.79*x2 - 1.34)*(v1),
)]
#[inertia(diag((1.19 - 0.28*0.88*sin(x1)/(1.50 + cos(x2))), 1.11))]
#[forces(
    1.38*powi(v2, 2) - 1.28*v1/(1 + powi(x1, 2)) - tau*1.54,
    0,
)]
#[constraint(row1: (1.50 - 0.11*powi(cos(0.50*x2 - 0.97), 3))*v1 == 0)]
#[constraint(row2: dot(v2) + 0.13*0.46*sin(x2)/(1.50 + cos(x2))*dot(v1) + 0.50*sin(0.81*x1)*cos(1.01*x1 - 0.61*x1) == 0)]
#[output(place = sin(0.77*x1 - 0.38*x1)*cos(0.91*x2), power = 1.75*x2/(1 + powi(x2, 2)) - p1*exp(0.20*x1) - p2*exp(0.20*x1) - 1.26*v1, push = x1/(1 + powi(x1, 2))*dot(v1) + v2*ddot(x2), pull = (1.36 + 0.27*ln(1.60 + 0.69*cos(x2)))*reaction(row1) - push, share = pull/(1.71 + powi(reaction(row1), 2)))]
pub struct Random115 {
    #[nominal(1.13)]
    pub p1: f64,
    #[nominal(0.97)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1) - 0.38*sin(0.40*x2)*cos(0.82*x5 - 0.71*x1)*dot(x4),
    v2 = 1.31*dot(x2) - 0.23*tan(0.36*sin(x6))/2*dot(x5),
    v3 = dot(x3),
    v4 = (1.23 + 0.25*tan(0.96*sin(x6))/2)*dot(x4) + 0.37*sin(0.81*x3 + 0.28*x5 - 0.29)*cos(0.91*x6 - 0.59*x5)*dot(x5),
    v5 = 1.09*dot(x5) - 0.13*x3/(1 + powi(x3, 2))*dot(x1),
    v6 = 1.38*dot(x6) - 0.21*1/sqrt(1.50 + powi(x6, 2))*dot(x4),
)]
#[define(l11 = (1.38 - 0.30*sin(0.88*x6)*cos(0.47*x3 - 0.45*x5 - 1.22)), l21 = 0.23*ln(1.60 + 0.38*cos(x6)), l22 = (1.37 - 0.16*sin(p1*x5 + 0.40)), l31 = 0.22*sin(1.04*x1)*cos(0.44*x5 - 1.44), l32 = 0.32*atan2(x2, 2 + cos(x2))/2, l33 = (1.10 + 0.30*powi(cos(1.05*x1 - 0.72*x1), 3)), l41 = 0.35*cos(0.67*x2 - 1.13), l43 = 0.32*tan(0.86*sin(x4))/2, l44 = (1.03 - 0.19*sin(0.44*x2 + 0.26*x5 + 1.14)), l51 = 0.13*powi(cos(1.14*x1 + 0.43*x5), 3), l53 = 0.33*exp(-powi(x5, 2)/2), l55 = 1.18, l61 = 0.18*ln(1.60 + 0.62*cos(x6)), l62 = 0.20*cos(0.93*x3), l63 = 0.38*sin(1.20*x2)*cos(0.42*x3 - 0.88*x1 - 0.71), l64 = 0.22*sin(0.52*x3 + 1.33), l65 = 0.39*powi(cos(0.76*x1 - 0.46*x2), 3), l66 = 1.10)]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, l11*l41, l11*l51, l11*l61],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l21*l41, l21*l51, l21*l61 + l22*l62],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l33*l43, l31*l51 + l33*l53, l31*l61 + l32*l62 + l33*l63],
    [_, _, _, l41*l41 + l43*l43 + l44*l44, l41*l51 + l43*l53, l41*l61 + l43*l63 + l44*l64],
    [_, _, _, _, l51*l51 + l53*l53 + l55*l55, l51*l61 + l53*l63 + l55*l65],
    [_, _, _, _, _, l61*l61 + l62*l62 + l63*l63 + l64*l64 + l65*l65 + l66*l66],
))]
#[forces(
    v5*v4/1.05 - v4*v2/1.29 - p1*x3 - p1*v1*v5*tan(0.96*sin(x1))/2,
    v4*v6/(1.04 - 0.32*ln(1.60 + 0.55*cos(x5))) - p1*0.33,
    v2*v4/1.02 - v2*sqrt(2 + powi(v6, 2)) - p1*x5,
    v1*v3/(1.11 - 0.12*powi(cos(0.91*x3 - 0.39*x4), 3)) + 1.39*v5/(1 + powi(x1, 2)),
    v4*v5/(1.06 + 0.17*x3/(1 + powi(x3, 2))),
    0,
)]
#[constraint(row1: 1.44*x2 + 0.22*sin(x2) + exp(0.27*x5)/2 - 0.37 == 0)]
#[constraint(row2: (1.50 + 0.14*exp(-powi(x5, 2)/2))*v3 - 0.18*cos(0.94*x3 - 0.79*x3)*v5 - 0.20*exp(-powi(x4, 2)/2)*v6 == 0)]
#[constraint(row3: 1.41*v4 - 0.28*sqrt(1.50 + powi(v2, 2) + powi(v3, 2)) + 0.52*sin(0.87*x1)*cos(0.57*x1) == 0)]
#[constraint(row4: (1.50 + 0.22*powi(cos(0.40*x3 + 0.72), 3))*dot(v1) - 0.18*sin(0.58*x6 + 0.39*x4)*dot(v5) + 0.29*sin(0.72*x2 - 0.63)*dot(v6) + 0.39*v3*v6*x4/(1 + powi(x4, 2)) == 0)]
pub struct Random116 {
    #[nominal(0.63)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = 1.29*v1 + 0.31*sin(p1*x2 - 0.40)*v2,
    dot(x2) = v2 + 0.25*exp(-powi(x2, 2)/2)*v1,
)]
#[inertia(matrix(
    [((1.40 + 0.31*ln(1.60 + 0.75*cos(t))))*((1.40 + 0.31*ln(1.60 + 0.75*cos(t)))), ((1.40 + 0.31*ln(1.60 + 0.75*cos(t))))*(0.30*sin(0.88*x2 - 0.53*t))],
    [_, (0.30*sin(0.88*x2 - 0.53*t))*(0.30*sin(0.88*x2 - 0.53*t)) + ((1.07 - 0.22*exp(-powi(t, 2)/2)))*((1.07 - 0.22*exp(-powi(t, 2)/2)))],
))]
#[forces(
    0.75*powi(v1, 2) + p1*exp(0.20*x2) + 0.46*v2/(1 + powi(x1, 2)) + p1*v1*v1*atan2(x2, 2 + cos(x2))/2,
    0.85*v2/(1 + powi(x1, 2)) + p1*0.60 + 1.83*ln(1.60 + 0.59*cos(t)),
)]
#[potential_energy(ln(1.60 + 0.50*cos(x2)))]
#[constraint(row1: dot(v1) + 0.18*cos(0.81*x1 - 0.37*x2)*dot(v2) - 0.45*v2*v2*cos(0.67*x1 - 0.70*x2) == 0)]
#[constraint(again1: 1.19*(dot(v1) + 0.18*cos(0.81*x1 - 0.37*x2)*dot(v2) - 0.45*v2*v2*cos(0.67*x1 - 0.70*x2)) == 0, redundant)]
pub struct Random117 {
    #[nominal(0.64)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + cos(1.01*x4 + 0.59*x4 + 1.15)*dot(x1),
    v3 = dot(x3) + cos(0.79*x3 + 0.64)*dot(x2),
    v4 = dot(x4) + sin(0.46*x1)*dot(x1),
    v5 = dot(x5) + 0.73*sin(x5)/(1.50 + cos(x2))*dot(x3),
    v6 = dot(x6) + x1/(1 + powi(x1, 2))*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - cos(1.01*x4 + 0.59*x4 + 1.15)*(v1),
    dot(x3) = v3 - cos(0.79*x3 + 0.64)*(v2 - cos(1.01*x4 + 0.59*x4 + 1.15)*(v1)),
    dot(x4) = v4 - sin(0.46*x1)*(v1),
    dot(x5) = v5 - 0.73*sin(x5)/(1.50 + cos(x2))*(v3 - cos(0.79*x3 + 0.64)*(v2 - cos(1.01*x4 + 0.59*x4 + 1.15)*(v1))),
    dot(x6) = v6 - x1/(1 + powi(x1, 2))*(v1),
)]
#[inertia(diag(1.10, 1.20, (1.08 + 0.31*atan2(x3, 2 + cos(x2))/2), (1.13 + 0.15*0.41*sin(x2)/(1.50 + cos(x5))), (1.15 + 0.13*sin(1.02*x3 - 0.53*x5)*cos(0.44*x1 - 1.38)), (1.07 - 0.23*x1/(1 + powi(x1, 2)))))]
#[forces(
    1.77*v2 - 1.64*v3/(1 + powi(x6, 2)) - p2*x1,
    v3*v6/1.39,
    v3*v6/(1.05 - 0.18*cos(0.60*x5 - 0.78*x4)) + 0.96*v6/(1 + powi(x2, 2)) + p2*exp(0.20*x5) + p1*v3*v3*atan2(x5, 2 + cos(x5))/2,
    v1*v2/(1.38 - 0.18*0.51*sin(x5)/(1.50 + cos(x6))) - 1.19*v2/(1 + powi(x2, 2)),
    0,
    p2*v6*v3*sin(0.77*x6)*cos(1.07*x2 - 0.33*x5) - p2*x6 - 1.91*powi(v6, 2) - 0.33*powi(v2, 2),
)]
#[constraint(row1: 1.54*x4 + 0.26*sin(x4) + 0.37*x1*x1 - 0.21 == 0)]
#[constraint(row2: (1.50 + 0.19*sin(1.10*x6 - 0.53*x4 + 1.21))*v6 - 0.17*ln(1.60 + 0.85*cos(x1))*v1 - 0.13*0.49*sin(x6)/(1.50 + cos(x6))*v4 == 0)]
#[constraint(row3: (1.50 + 0.13*atan2(x3, 2 + cos(x6))/2)*v3 + 0.34*sin(0.47*x4 - 0.45*x5)*v1 + 0.19*exp(-powi(x2, 2)/2)*v4 - 0.42*cos(0.56*x6 - 0.27*x6) == 0)]
#[constraint(row4: (1.50 - 0.22*sin(1.15*x2))*v2 - 0.29*1/sqrt(1.50 + powi(x3, 2))*v1 - 0.41*sin(0.77*x2 - 1.13) == 0)]
#[constraint(row5: (1.50 - 0.23*cos(0.92*x1))*v5 - 0.27*x1/(1 + powi(x1, 2))*v1 + 0.24*0.93*sin(x2)/(1.50 + cos(x1))*v4 + 0.24*powi(cos(0.50*x6 + 0.64*x3), 3)*v6 == 0)]
#[output(place = atan2(x3, 2 + cos(x5))/2, power = 1.99*v6, push = ln(1.60 + 0.97*cos(x4))*dot(v1) + v4*ddot(x4), pull = 1.28*reaction(row2) - push, share = pull/(1.38 + powi(reaction(row2), 2)))]
pub struct Random118 {
    #[nominal(0.96)]
    pub p1: f64,
    #[nominal(1.14)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[define(l11 = (1.38 + 0.13*1/sqrt(1.50 + powi(x2, 2))), l21 = 0.12*1/sqrt(1.50 + powi(x2, 2)), l22 = 1.18, l31 = 0.32*tan(0.85*sin(x5))/2, l32 = 0.34*sin(0.70*x2 - 1.40)*cos(0.98*x5 + 0.61*x6), l33 = (1.33 + 0.10*sin(0.62*x1)), l41 = 0.24*sin(0.60*x4 + 0.31*x6), l42 = 0.32*sin(p3*x2 + 0.82), l44 = (1.39 + 0.15*1/sqrt(1.50 + powi(x2, 2))), l51 = 0.21*powi(cos(1.10*x5 - 0.78*x3), 3), l54 = 0.32*sin(0.95*x6 - 1.41)*cos(0.73*x3 - 0.47*x2 - 1.36), l55 = 1.31, l61 = 0.30*x1/(1 + powi(x1, 2)), l62 = 0.19*sin(0.72*x4), l63 = 0.11*tan(0.50*sin(x3))/2, l65 = 0.21*tan(0.50*sin(x6))/2, l66 = (1.07 - 0.31*1/sqrt(1.50 + powi(x6, 2))))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, l11*l41, l11*l51, l11*l61],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l21*l41 + l22*l42, l21*l51, l21*l61 + l22*l62],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l32*l42, l31*l51, l31*l61 + l32*l62 + l33*l63],
    [_, _, _, l41*l41 + l42*l42 + l44*l44, l41*l51 + l44*l54, l41*l61 + l42*l62],
    [_, _, _, _, l51*l51 + l54*l54 + l55*l55, l51*l61 + l55*l65],
    [_, _, _, _, _, l61*l61 + l62*l62 + l63*l63 + l65*l65 + l66*l66],
))]
#[forces(
    0.84*powi(dot(x6), 2),
    p2*exp(0.20*x2) - 0.35*atan2(x1, 2 + cos(x4))/2 - 0.97*dot(x6)/(1 + powi(x3, 2)) - dot(x6)*dot(x4)/(1.22 - 0.20*sin(p2*x5 + 0.48)),
    0.78*dot(x1)/(1 + powi(x6, 2)) + p3*dot(x2)*dot(x2)*tan(0.69*sin(x3))/2,
    p2*0.58 + 1.20*dot(x6),
    0,
    1.11*x3/(1 + powi(x3, 2)) - 1.68*powi(dot(x3), 2) - 1.77*dot(x5)/(1 + powi(x5, 2)),
)]
#[configuration(x6 = 1.03*tan(0.57*sin(x4))/2, x2 = 1.42*exp(-powi(x3, 2)/2))]
#[constraint(held_x6: x6 - (1.03*tan(0.57*sin(x4))/2) == 0)]
#[constraint(held_x2: x2 - (1.42*exp(-powi(x3, 2)/2)) == 0)]
#[constraint(bound: 1.60*dot(x1) + 0.29*cos(0.69*x6)*dot(x3)*dot(x3) + 0.25*tan(0.95*sin(x1))/2 == 0)]
pub struct Random119 {
    #[nominal(0.92)]
    pub p1: f64,
    #[nominal(1.38)]
    pub p2: f64,
    #[nominal(1.43)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    dot(x1) = 1.19*v1 + 0.38*powi(cos(0.66*x1), 3),
)]
#[define(l11 = (1.25 + 0.32*sin(0.44*x1)*cos(0.42*x1 - 1.01)))]
#[inertia(matrix(
    [l11*l11],
))]
#[forces(
    0.98*v1/(1 + powi(x1, 2)),
)]
pub struct Random120 {
    #[nominal(1.10)]
    pub p1: f64,
    #[nominal(1.48)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    dot(x1) = v1 + 0.42*x1/(1 + powi(x1, 2)),
)]
#[inertia(matrix(
    [(1.15)*(1.15)],
))]
#[forces(
    p2*1.21,
)]
#[potential_energy(atan2(x1, 2 + cos(x1))/2)]
#[constraint(row1: v1 == 0)]
pub struct Random121 {
    #[nominal(1.12)]
    pub p1: f64,
    #[nominal(1.27)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + sin(1.16*x2 + 0.85*t)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - sin(1.16*x2 + 0.85*t)*(v1),
)]
#[inertia(diag((1.16 + 0.30*exp(-powi(x1, 2)/2)), 1.13))]
#[forces(
    p3*exp(0.20*x2) - 1.50*powi(v2, 2),
    0,
)]
#[constraint(row1: 1.87*x2 + 0.24*sin(x2) + 0.15*powi(x1, 2)/2 + 0.30*sin(1.28*t) + 0.47 == 0)]
#[independent(v1)]
#[independent(s1 = 1.18*v1 - 0.33*sin(0.75*x2 + 0.27*t)*cos(0.51*x2 - 0.62*x1)*v2 - 0.37*x1/(1 + powi(x1, 2)))]
pub struct Random122 {
    #[nominal(1.36)]
    pub p1: f64,
    #[nominal(1.28)]
    pub p2: f64,
    #[nominal(0.92)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[inputs(tau)]
#[kinematics(
    v1 = (1.20 - 0.25*cos(0.80*x1))*dot(x1) + 0.58*sin(0.78*t + 0.23),
)]
#[define(l11 = (1.18 + 0.30*cos(0.80*x1 - 0.87*t)))]
#[inertia(matrix(
    [l11*l11],
))]
#[forces(
    1.29*v1,
)]
#[potential_energy(tan(0.75*sin(x1))/2)]
#[constraint(row1: (1.50 + 0.12*cos(0.60*x1))*v1 == 0)]
pub struct Random123 {
    #[nominal(0.79)]
    pub p1: f64,
    #[nominal(1.03)]
    pub p2: f64,
    #[nominal(1.40)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[define(l11 = (1.19 + 0.23*0.57*sin(x1)/(1.50 + cos(x1))), l21 = 0.34*powi(cos(0.65*x2 + 1.48), 3), l22 = (1.15 - 0.34*ln(1.60 + 0.92*cos(x1))))]
#[inertia(matrix(
    [l11*l11, l11*l21],
    [_, l21*l21 + l22*l22],
))]
#[forces(
    p3*x2 + 0.95*dot(x1)/(1 + powi(x2, 2)) + p3*dot(x1)*dot(x1)*ln(1.60 + 0.86*cos(x2)),
    1.57*powi(dot(x1), 2) + p1*0.35 + 1.41*powi(dot(x2), 2),
)]
#[constraint(height: 1.82*x2 - 0.72 == 0)]
#[constraint(first: 1.44*dot(x1) + 0.31*powi(cos(0.98*x1 + 0.89*x1), 3)*dot(x2) == 0)]
#[constraint(second: 1.82*dot(x2) - 0.50*atan2(x1, 2 + cos(x1))/2*(1.44*dot(x1) + 0.31*powi(cos(0.98*x1 + 0.89*x1), 3)*dot(x2)) == 0)]
#[output(place = sin(0.91*x1), power = p3*0.39 + p2*dot(x1)*dot(x2)*powi(cos(1.02*x1 - 0.71*x1), 3) + 0.65*dot(x2), push = cos(0.93*x2 - 0.38*x1 - 0.50)*ddot(x2) + dot(x1)*ddot(x1))]
pub struct Random125 {
    #[nominal(1.06)]
    pub p1: f64,
    #[nominal(0.87)]
    pub p2: f64,
    #[nominal(1.46)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = dot(x1) + 0.38*sin(0.43*x2 + 0.34*x2)*dot(x2) - 0.16*atan2(x2, 2 + cos(x2))/2,
    v2 = (1.23 + 0.14*ln(1.60 + 0.55*cos(x2)))*dot(x2) + 0.20*1/sqrt(1.50 + powi(x1, 2))*dot(x1) + 0.26*powi(cos(0.48*x2), 3),
)]
#[inertia(diag(1.01, (1.39 - 0.10*1/sqrt(1.50 + powi(x1, 2)))))]
#[forces(
    v1*sqrt(2 + powi(v1, 2)) - p1*x1 - p3*x2,
    p3*x1 - p1*exp(0.20*x1) - p2*v2*v1*1/sqrt(1.50 + powi(x2, 2)) - p2*1.73,
)]
#[configuration(x2 = 0.65*cos(0.62*x1 - 1.01))]
pub struct Random126 {
    #[nominal(1.11)]
    pub p1: f64,
    #[nominal(0.56)]
    pub p2: f64,
    #[nominal(0.79)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    v1 = dot(x1),
    dot(x1) = v1,
)]
#[inertia(diag((1.31 + 0.12*sin(0.61*t + 0.31*t - 1.27))))]
#[forces(
    1.62*v1/(1 + powi(x1, 2)) + 0.74*atan2(t, 2 + cos(x1))/2,
)]
#[configuration(of(q1), x1 = 1.25*q1)]
pub struct Random127 {
    #[nominal(0.68)]
    pub p1: f64,
    #[nominal(0.78)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag((1.05 - 0.11*cos(0.95*x2)), (1.39 - 0.17*cos(1.01*x1 - 0.55))))]
#[forces(
    p1*x1,
    0,
)]
#[configuration(x2 = 0.62*sin(p1*x1 + 0.33))]
#[output(place = 1/sqrt(1.50 + powi(x1, 2)), power = p2*x1 + dot(x2)*sqrt(2 + powi(dot(x1), 2)), push = sin(1.15*x1 + 0.84*x2)*ddot(x2) + dot(x2)*ddot(x2))]
pub struct Random128 {
    #[nominal(0.70)]
    pub p1: f64,
    #[nominal(1.39)]
    pub p2: f64,
    #[nominal(1.25)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[inertia(diag((1.33 + 0.22*sin(0.70*x1)*cos(0.83*x1))))]
#[forces(
    dot(x1)*dot(x1)/(1.08 + 0.17*cos(0.42*x1)) - p1*dot(x1)*dot(x1)*sin(1.01*x1 + 0.35*x1) - 0.85*sin(p2*x1 + 0.42),
)]
#[complement(
    w1 = [(1.37 + 0.20*1/sqrt(1.50 + powi(x1, 2)))],
)]
pub struct Random129 {
    #[nominal(0.95)]
    pub p1: f64,
    #[nominal(1.32)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag(1.24, (1.01 - 0.25*sin(0.49*t + 0.31*x1))))]
#[forces(
    1.50*powi(dot(x1), 2),
    0.98*dot(x2)/(1 + powi(x1, 2)) - 0.61*ln(1.60 + 0.85*cos(x1)),
)]
#[potential_energy(x1/(1 + powi(x1, 2)))]
#[constraint(row1: 1.75*x1 + 0.30*sin(x1) + 0.16*x2*x2 + 0.30*sin(1.32*t) - 0.54 == 0)]
#[independent(dot(x2))]
pub struct Random130 {
    #[nominal(1.24)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    v1 = (1.19 - 0.31*sin(p1*x1 - 0.89))*dot(x1) - 0.15*sin(0.90*x1 + 0.62*x1),
)]
#[define(l11 = (1.18 + 0.14*sin(p1*t - 0.80)))]
#[inertia(matrix(
    [l11*l11],
))]
#[forces(
    0.48*powi(v1, 2),
)]
#[constraint(row1: 1.43*x1 + 0.28*sin(x1) + 0.30*sin(1.49*t) - 0.13 == 0)]
#[output(place = ln(1.60 + 0.50*cos(t)), power = v1*v1/(1.01 + 0.24*ln(1.60 + 0.84*cos(x1))), push = powi(cos(0.79*t - 0.65*t - 0.63), 3)*dot(v1) + v1*ddot(x1), pull = 1.23*reaction(row1) - push, share = pull/(1.48 + powi(reaction(row1), 2)))]
pub struct Random131 {
    #[nominal(0.63)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = (1.19 + 0.24*sin(p1*x2 - 0.74))*v1 - 0.11*sin(p1*x2 + 0.50)*v2 - 0.48*tan(0.31*sin(x1))/2,
    dot(x2) = 1.40*v2 + 0.24*tan(0.59*sin(x2))/2*v1 - 0.52*atan2(x2, 2 + cos(x1))/2,
)]
#[inertia(diag((1.14 - 0.28*cos(0.58*x1)), (1.40 - 0.31*powi(cos(1.18*x2), 3))))]
#[forces(
    p1*exp(0.20*x2),
    0,
)]
#[constraint(row1: powi(v1, 2) - 0.18*powi(v2, 2) - (2 - 0.18*exp(-powi(x2, 2)/2)) == 0)]
#[independent(v2, v1)]
#[output(place = tan(0.85*sin(x1))/2, power = v1*v2/1.24 + 0.41*powi(v2, 2) + v2*sqrt(2 + powi(v2, 2)), push = powi(cos(1.11*x1), 3)*dot(v1) + v2*ddot(x2), pull = 1.06*reaction(row1) - push, share = pull/(1.81 + powi(reaction(row1), 2)))]
pub struct Random132 {
    #[nominal(0.62)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = (1.17 - 0.34*tan(0.80*sin(x2))/2)*v1 + 0.18*cos(0.62*x1 + 0.80),
    dot(x2) = v2 + 0.27*sin(1.12*x1)*cos(0.42*x2)*v1 + 0.54*sin(p1*x1 + 0.53),
)]
#[inertia(diag((1.30 - 0.20*sin(0.89*x1)), 1.03))]
#[forces(
    0.31*v1/(1 + powi(x2, 2)) + p1*0.82 + 1.96*powi(v1, 2) + 0.51*powi(v1, 2),
    1.25*v1 - p1*x2,
)]
#[potential_energy(sin(p1*x2 + 0.97))]
#[constraint(row1: 1.76*x2 - 0.61 == 0)]
#[constraint(row2: 1.57*v1 + 0.20*sin(v1 + tan(0.68*sin(x2))/2*v2) + 0.28*ln(1.60 + 0.55*cos(x1)) == 0)]
#[independent(v1)]
pub struct Random134 {
    #[nominal(1.32)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = (1.12 + 0.28*sin(0.95*x1 + 0.46)*cos(1.12*x1))*v1 + 0.27*1/sqrt(1.50 + powi(x1, 2))*v2 + 0.27*sin(0.58*x2 + 0.43*x1),
    dot(x2) = (1.07 - 0.20*sin(0.64*x1))*v2 + 0.25*ln(1.60 + 0.67*cos(x1)),
)]
#[inertia(matrix(
    [(1.15)*(1.15), (1.15)*(0.25*ln(1.60 + 0.66*cos(x2)))],
    [_, (0.25*ln(1.60 + 0.66*cos(x2)))*(0.25*ln(1.60 + 0.66*cos(x2))) + (1.10)*(1.10)],
))]
#[forces(
    v2*sqrt(2 + powi(v1, 2)) + p1*1.89 + v2*sqrt(2 + powi(v2, 2)),
    v2*sqrt(2 + powi(v1, 2)) - 1.61*v2,
)]
#[constraint(row1: v1 - 0.47*sin(0.61*x2 + 0.73)*cos(0.43*x2 - 0.70) == 0)]
#[constraint(row2: (1.50 - 0.24*exp(-powi(x2, 2)/2))*dot(v2) + 0.21*0.41*sin(x2)/(1.50 + cos(x2))*dot(v1) + 0.22*v1/sqrt(1.20 + powi(v1, 2)) == 0)]
pub struct Random135 {
    #[nominal(1.38)]
    pub p1: f64,
    #[nominal(1.23)]
    pub p2: f64,
    #[nominal(1.31)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inputs(tau)]
#[inertia(matrix(
    [((1.30 - 0.20*powi(cos(0.54*x3), 3)))*((1.30 - 0.20*powi(cos(0.54*x3), 3))), 0, 0],
    [_, (1.21)*(1.21), (1.21)*(0.13*x3/(1 + powi(x3, 2)))],
    [_, _, (0.13*x3/(1 + powi(x3, 2)))*(0.13*x3/(1 + powi(x3, 2))) + (1.07)*(1.07)],
))]
#[forces(
    1.60*0.36*sin(x2)/(1.50 + cos(x1)),
    dot(x2)*dot(x3)/(1.12 - 0.26*0.33*sin(x2)/(1.50 + cos(x3))) + p2*dot(x1)*dot(x2)*sin(0.68*x2 + 0.57) + 0.81*dot(x1),
    1.53*sin(0.43*x2 - 0.23) + tau*0.72,
)]
#[constraint(row1: 1.27*dot(x1) == 0)]
#[constraint(row2: 1.36*dot(x3) + 0.14*atan2(x2, 2 + cos(x2))/2*dot(x1)*dot(x1) + 0.48*0.67*sin(x3)/(1.50 + cos(x2)) == 0)]
#[constraint(row3: 1.34*ddot(x2) - 0.22*1/sqrt(1.50 + powi(x2, 2))*ddot(x1) + 0.18*sin(1.06*x3)*ddot(x3) - 0.76*dot(x3)/sqrt(1.20 + powi(dot(x2), 2)) == 0)]
#[independent(s1 = (1.50 + 0.21*sin(p1*x1 + 0.46))*dot(x2) + 0.29*tan(0.97*sin(x2))/2*dot(x1), dot(x3))]
pub struct Random136 {
    #[nominal(0.76)]
    pub p1: f64,
    #[nominal(1.26)]
    pub p2: f64,
    #[nominal(0.73)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = v1 + 0.38*powi(cos(0.49*x1), 3),
    dot(x2) = 1.20*v2 + 0.34*x2/(1 + powi(x2, 2))*v1 + 0.13*0.55*sin(x1)/(1.50 + cos(x2)),
)]
#[define(l11 = 1.02, l21 = 0.33*1/sqrt(1.50 + powi(x2, 2)), l22 = (1.05 + 0.30*x1/(1 + powi(x1, 2))))]
#[inertia(matrix(
    [l11*l11, l11*l21],
    [_, l21*l21 + l22*l22],
))]
#[forces(
    1.73*v2/(1 + powi(x2, 2)),
    0.93*v2 - 0.99*v1/(1 + powi(x2, 2)) - p1*v1*v1*0.94*sin(x2)/(1.50 + cos(x2)) - v1*sqrt(2 + powi(v2, 2)),
)]
#[potential_energy(cos(0.69*x2 + 0.23*x2 - 0.27))]
#[constraint(row1: 1.72*x1 + 0.29*sin(x1) + 0.34*powi(x2, 2)/2 + 0.42 == 0)]
#[constraint(again1: 0.61*(1.72*x1 + 0.29*sin(x1) + 0.34*powi(x2, 2)/2 + 0.42) == 0, redundant)]
pub struct Random137 {
    #[nominal(1.14)]
    pub p1: f64,
    #[nominal(0.89)]
    pub p2: f64,
    #[nominal(1.16)]
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
#[inertia(matrix(
    [((1.33 - 0.25*powi(cos(0.68*x2 - 0.32*x1 + 0.52), 3)))*((1.33 - 0.25*powi(cos(0.68*x2 - 0.32*x1 + 0.52), 3))), 0],
    [_, ((1.01 - 0.24*0.53*sin(x1)/(1.50 + cos(x1))))*((1.01 - 0.24*0.53*sin(x1)/(1.50 + cos(x1))))],
))]
#[forces(
    0,
    1.43*powi(v2, 2) + 0.70*v2/(1 + powi(x1, 2)) + p1*exp(0.20*x2) + p1*exp(0.20*x2),
)]
#[potential_energy(powi(cos(1.00*x2), 3))]
#[constraint(row1: (1.50 - 0.26*sin(0.74*x2 + 0.50*x2))*v2 == 0)]
#[constraint(row2: (1.50 - 0.14*sin(0.69*x1))*v1 - 0.35*1/sqrt(1.50 + powi(x1, 2))*v2 + 0.50*sin(1.11*x2 - 0.72*x2 + 1.00) == 0)]
#[output(place = 0.51*sin(x2)/(1.50 + cos(x1)), power = 1.94*cos(0.62*x1 - 0.81*x1 + 1.31), push = exp(-powi(x2, 2)/2)*dot(v1) + v1*ddot(x1), pull = (1.24 - 0.14*powi(cos(1.06*x1 + 1.06), 3))*reaction(row2) - push, share = pull/(1.47 + powi(reaction(row2), 2)))]
pub struct Random138 {
    #[nominal(1.18)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = dot(x1) - 0.38*sin(0.61*t + 0.73*x1)*dot(x2),
    v2 = 1.35*dot(x2) + 0.28*powi(cos(0.82*x3), 3)*dot(x3),
    v3 = (1.15 + 0.13*exp(-powi(t, 2)/2))*dot(x3),
)]
#[inertia(matrix(
    [(1.32)*(1.32), (1.32)*(0.23*exp(-powi(t, 2)/2)), 0],
    [_, (0.23*exp(-powi(t, 2)/2))*(0.23*exp(-powi(t, 2)/2)) + ((1.33 - 0.26*1/sqrt(1.50 + powi(x2, 2))))*((1.33 - 0.26*1/sqrt(1.50 + powi(x2, 2)))), 0],
    [_, _, (1.04)*(1.04)],
))]
#[forces(
    1.91*v2 - v2*sqrt(2 + powi(v1, 2)) - 1.53*v1,
    0.86*v3/(1 + powi(x1, 2)),
    0,
)]
#[configuration(x2 = 1.08*ln(1.60 + 0.45*cos(x3)))]
#[constraint(held_x2: x2 - (1.08*ln(1.60 + 0.45*cos(x3))) == 0)]
#[constraint(bound: (1.50 + 0.17*sin(p1*x2 - 0.23))*dot(v3) - 0.11*ln(1.60 + 0.44*cos(x1))*dot(v1) + 0.20*sin(p1*t - 0.19)*dot(v2) - 0.63*sin(p1*x2 + 0.69) == 0)]
pub struct Random139 {
    #[nominal(0.74)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inputs(tau)]
#[inertia(matrix(
    [(1.26)*(1.26), (1.26)*(0.39*exp(-powi(x2, 2)/2)), 0],
    [_, (0.39*exp(-powi(x2, 2)/2))*(0.39*exp(-powi(x2, 2)/2)) + ((1.17 - 0.31*sin(0.78*x3 - 0.98)*cos(0.94*x2 - 0.32*x1)))*((1.17 - 0.31*sin(0.78*x3 - 0.98)*cos(0.94*x2 - 0.32*x1))), 0],
    [_, _, (1.19)*(1.19)],
))]
#[forces(
    dot(x1)*dot(x2)/(1.08 + 0.29*sin(p3*x1 - 0.29)) + p1*x1 + 0.84*dot(x1)/(1 + powi(x3, 2)),
    p3*dot(x2)*dot(x2)*exp(-powi(x3, 2)/2) + 1.97*dot(x2) + p1*x2 + tau*1.47,
    p2*dot(x3)*dot(x3)*sin(0.56*x3 - 0.58)*cos(0.99*x3),
)]
#[potential_energy(sin(1.10*x1 - 0.24*x2))]
#[output(place = atan2(x3, 2 + cos(x3))/2, power = 0.74*dot(x3) + p1*x3 + 0.96*dot(x1) + p3*exp(0.20*x3), push = 1/sqrt(1.50 + powi(x1, 2))*ddot(x3) + dot(x3)*ddot(x3))]
pub struct Random140 {
    #[nominal(0.60)]
    pub p1: f64,
    #[nominal(0.73)]
    pub p2: f64,
    #[nominal(0.66)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = (1.06 - 0.18*powi(cos(0.82*x2 + 0.30*x1), 3))*v1 + 0.20*sin(p1*x2 - 0.44)*v2 - 0.50*1/sqrt(1.50 + powi(x2, 2)),
    dot(x2) = v2 + 0.37*sin(0.99*x2)*v1 - 0.56*sin(1.04*x2 + 0.41*x2 - 1.18),
)]
#[inertia(diag((1.12 - 0.22*ln(1.60 + 0.53*cos(x1))), (1.39 - 0.13*cos(0.73*x1 + 0.77*x2))))]
#[forces(
    p2*exp(0.20*x2) - 0.66*v2,
    0.84*v1/(1 + powi(x1, 2)),
)]
#[potential_energy(powi(cos(0.78*x1 - 1.09), 3))]
#[constraint(row1: 1.87*v1 - 0.18*powi(cos(0.40*x2 + 0.39*x1), 3)*v2 == 0)]
#[output(place = sin(1.06*x1 - 0.83*x1), power = v1*sqrt(2 + powi(v1, 2)) - v2*v2/(1.18 - 0.31*tan(0.76*sin(x2))/2) - p1*1.07, push = 1/sqrt(1.50 + powi(x2, 2))*dot(v1) + v2*ddot(x2), pull = (1.12 - 0.11*sin(p2*x1 - 0.68))*reaction(row1) - push, share = pull/(1.57 + powi(reaction(row1), 2)))]
pub struct Random141 {
    #[nominal(1.27)]
    pub p1: f64,
    #[nominal(0.54)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(diag((1.26 - 0.28*sin(1.17*x1 - 0.62*x1 - 0.22)), (1.30 + 0.21*1/sqrt(1.50 + powi(x2, 2)))))]
#[forces(
    0.74*powi(dot(x2), 2) + 1.45*dot(x1)/(1 + powi(t, 2)) + 0.45*dot(x1)/(1 + powi(x2, 2)) + dot(x1)*dot(x1)/(1.28 + 0.22*x1/(1 + powi(x1, 2))),
    p1*t + dot(x2)*sqrt(2 + powi(dot(x1), 2)) + dot(x1)*sqrt(2 + powi(dot(x2), 2)),
)]
#[constraint(row1: 1.73*x1 + 0.24*sin(x2) + 0.30*sin(1.44*t) + 0.32 == 0)]
#[independent(dot(x2))]
pub struct Random142 {
    #[nominal(0.99)]
    pub p1: f64,
    #[nominal(1.03)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(matrix(
    [(1.28)*(1.28), 0],
    [_, ((1.35 + 0.15*x1/(1 + powi(x1, 2))))*((1.35 + 0.15*x1/(1 + powi(x1, 2))))],
))]
#[forces(
    1.22*dot(x2)/(1 + powi(x1, 2)),
    1.04*dot(x2)/(1 + powi(x2, 2)),
)]
#[constraint(row1: 1.94*x1 + 0.46 == 0)]
#[constraint(row2: 1.13*dot(x2) - 0.13*atan2(x2, 2 + cos(x1))/2*dot(x1) == 0)]
pub struct Random143 {
    #[nominal(0.93)]
    pub p1: f64,
    #[nominal(1.05)]
    pub p2: f64,
    #[nominal(0.92)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inputs(tau)]
#[inertia(diag((1.30 + 0.33*0.99*sin(x2)/(1.50 + cos(x2))), (1.11 + 0.35*cos(0.78*t)), 1.11))]
#[forces(
    p2*exp(0.20*x3),
    p2*dot(x3)*dot(x3)*sin(0.62*x1) + tau*1.90,
    0,
)]
#[constraint(height: 1.96*x1 + 0.30*sin(x1) + 0.25*powi(x3, 2)/2 + 0.30*sin(1.07*t) - 0.55 == 0)]
#[constraint(height_rate: 1.96*dot(x1) + 0.30*cos(x1)*dot(x1) + 0.25*x3*dot(x3) + 0.30*1.07*cos(1.07*t) == 0)]
#[constraint(further: 1.99*dot(x2) + 0.25*atan2(t, 2 + cos(x1))/2*dot(x3) - 0.13*x1/(1 + powi(x1, 2))*dot(x1) == 0)]
pub struct Random144 {
    #[nominal(0.95)]
    pub p1: f64,
    #[nominal(1.47)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = v1 + 0.39*0.95*sin(x1)/(1.50 + cos(x1))*v2,
    dot(x2) = (1.15 - 0.21*ln(1.60 + 0.45*cos(x1)))*v2 + 0.27*powi(cos(0.96*x1), 3)*v1,
)]
#[inertia(diag(1.27, (1.26 + 0.22*atan2(x1, 2 + cos(x2))/2)))]
#[forces(
    v1*sqrt(2 + powi(v1, 2)) + v2*v1/1.02 + 0.37*exp(-powi(x2, 2)/2) + v2*sqrt(2 + powi(v1, 2)),
    1.23*ln(1.60 + 0.85*cos(x2)) - 1.98*powi(cos(0.87*x2 + 0.77*x1), 3) - 0.99*v2,
)]
#[constraint(height: 1.41*x1 + 0.13*sin(x1) + 0.69 == 0)]
#[constraint(first: (1.50 - 0.26*tan(0.66*sin(x2))/2)*v2 + 0.30*ln(1.60 + 0.49*cos(x1))*v1 == 0)]
#[constraint(second: 1.41*dot(x1) + 0.13*cos(x1)*dot(x1) - 0.50*sin(0.53*x1 - 0.62)*((1.50 - 0.26*tan(0.66*sin(x2))/2)*v2 + 0.30*ln(1.60 + 0.49*cos(x1))*v1) == 0)]
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
    v2 = dot(x2) + powi(cos(1.15*x2 + 0.70*x2), 3)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - powi(cos(1.15*x2 + 0.70*x2), 3)*(v1),
)]
#[inertia(diag((1.16 - 0.26*exp(-powi(x2, 2)/2)), (1.09 - 0.28*tan(0.35*sin(x1))/2)))]
#[forces(
    0,
    p2*v1*v2*sin(1.07*x1 + 0.71*x1 + 0.97),
)]
#[configuration(x1 = 1.14*x2/(1 + powi(x2, 2)))]
#[constraint(held_x1: x1 - (1.14*x2/(1 + powi(x2, 2))) == 0)]
#[output(place = exp(-powi(x1, 2)/2), power = 1.01*v1/(1 + powi(x1, 2)), push = powi(cos(0.59*x1 - 0.37*x2), 3)*dot(v1) + v2*ddot(x2), pull = 1.10*reaction(held_x1) - push, share = pull/(1.50 + powi(reaction(held_x1), 2)))]
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
    v2 = dot(x2) + exp(-powi(x2, 2)/2)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - exp(-powi(x2, 2)/2)*(v1),
)]
#[inertia(matrix(
    [((1.39 + 0.29*0.81*sin(x1)/(1.50 + cos(x1))))*((1.39 + 0.29*0.81*sin(x1)/(1.50 + cos(x1)))), ((1.39 + 0.29*0.81*sin(x1)/(1.50 + cos(x1))))*(0.22*tan(0.62*sin(x1))/2)],
    [_, (0.22*tan(0.62*sin(x1))/2)*(0.22*tan(0.62*sin(x1))/2) + (1.19)*(1.19)],
))]
#[forces(
    v1*sqrt(2 + powi(v1, 2)),
    p1*v2*v2*ln(1.60 + 0.46*cos(x2)) - 0.39*v1/(1 + powi(x2, 2)) - 0.44*powi(v2, 2),
)]
#[configuration(of(q1), x1 = 1.25*q1, x2 = q1/(1 + powi(q1, 2)))]
#[constraint(held_x2: x2 - ((x1/1.25)/(1 + powi((x1/1.25), 2))) == 0)]
pub struct Random147 {
    #[nominal(1.30)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[define(l11 = 1.11, l22 = (1.31 - 0.28*ln(1.60 + 0.69*cos(x1))))]
#[inertia(matrix(
    [l11*l11, 0],
    [_, l22*l22],
))]
#[forces(
    0.88*powi(dot(x1), 2),
    dot(x2)*dot(x1)/(1.10 - 0.19*exp(-powi(x1, 2)/2)) - 0.86*dot(x1)/(1 + powi(x1, 2)) - p2*x2 - p2*x1,
)]
#[potential_energy(sin(0.52*x2 + 0.87*x2 + 0.32))]
#[configuration(x1 = 1.26*ln(1.60 + 0.97*cos(x2)))]
#[constraint(held_x1: x1 - (1.26*ln(1.60 + 0.97*cos(x2))) == 0)]
pub struct Random148 {
    #[nominal(1.31)]
    pub p1: f64,
    #[nominal(1.47)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + exp(-powi(x3, 2)/2)*dot(x1),
    v3 = dot(x3) + 1/sqrt(1.50 + powi(x1, 2))*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - exp(-powi(x3, 2)/2)*(v1),
    dot(x3) = v3 - 1/sqrt(1.50 + powi(x1, 2))*(v2 - exp(-powi(x3, 2)/2)*(v1)),
)]
#[define(l11 = (1.29 + 0.14*sin(0.42*x1 - 0.67*x1 - 0.84)*cos(0.84*x1 - 0.27)), l21 = 0.31*x2/(1 + powi(x2, 2)), l22 = 1.39, l31 = 0.15*sin(0.43*x3 - 0.97), l32 = 0.40*1.00*sin(x2)/(1.50 + cos(x1)), l33 = (1.38 - 0.28*cos(0.69*x1 + 0.71*x2)))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32],
    [_, _, l31*l31 + l32*l32 + l33*l33],
))]
#[forces(
    0,
    0,
    v1*sqrt(2 + powi(v1, 2)) - p1*x3 - 0.37*sin(0.87*x3 - 0.60*x1 - 0.50),
)]
#[constraint(row1: 1.33*x2 + 0.23*sin(x2) + 0.34 == 0)]
#[constraint(row2: 1.86*x3 + 0.28*sin(x2) - 0.46 == 0)]
#[constraint(row3: 1.61*x1 + 0.21*sin(x1) + exp(0.29*x2)/2 + exp(0.12*x3)/2 - 0.68 == 0)]
pub struct Random151 {
    #[nominal(0.91)]
    pub p1: f64,
    #[nominal(1.47)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = (1.22 - 0.13*sin(0.92*x1 - 0.48*x2 + 0.75)*cos(0.48*x2))*v1 + 0.23*x1/(1 + powi(x1, 2))*v2 - 0.31*sin(0.87*x1),
    dot(x2) = (1.27 + 0.30*sin(0.69*x2 - 0.37*x1 - 1.45))*v2 + 0.31*exp(-powi(x1, 2)/2)*v1 - 0.34*atan2(x1, 2 + cos(x2))/2,
)]
#[inertia(diag((1.32 + 0.34*tan(0.98*sin(x1))/2), (1.20 - 0.21*x1/(1 + powi(x1, 2)))))]
#[forces(
    v1*sqrt(2 + powi(v1, 2)),
    v1*v2/(1.04 - 0.27*1/sqrt(1.50 + powi(x1, 2))) + p2*v1*v1*sin(p1*x2 - 0.35) + 0.71*powi(v2, 2),
)]
#[constraint(row1: (1.50 + 0.15*0.46*sin(x2)/(1.50 + cos(x1)))*v1 == 0)]
#[constraint(row2: 1.06*v2 - 0.26*v2*v1*sin(0.84*x1 - 0.67*x1)*cos(0.79*x2 + 0.34*x2 - 0.73) + 0.21*cos(0.63*x1) == 0)]
#[output(place = powi(cos(0.68*x2 - 0.37*x2), 3), power = 0.50*powi(cos(0.44*x2 + 0.39*x2 - 0.75), 3) + 1.04*powi(v1, 2), push = cos(0.76*x1)*dot(v2) + v1*ddot(x1), pull = (1.34 - 0.28*1/sqrt(1.50 + powi(x1, 2)))*reaction(row1) - push, share = pull/(1.90 + powi(reaction(row1), 2)))]
pub struct Random152 {
    #[nominal(1.39)]
    pub p1: f64,
    #[nominal(0.79)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + cos(0.48*x3 - 0.63)*dot(x1),
    v3 = dot(x3) + powi(cos(1.06*x2), 3)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - cos(0.48*x3 - 0.63)*(v1),
    dot(x3) = v3 - powi(cos(1.06*x2), 3)*(v1),
)]
#[inertia(diag((1.09 - 0.32*x1/(1 + powi(x1, 2))), 1.05, (1.18 - 0.11*cos(0.98*x3 - 1.31))))]
#[forces(
    v3*sqrt(2 + powi(v3, 2)) - p2*v1*v1*0.46*sin(x1)/(1.50 + cos(x1)) - p1*exp(0.20*x2) - 1.05*powi(v1, 2),
    p2*0.64,
    0.33*v1 - p2*exp(0.20*x1) - 1.90*powi(v3, 2) - p2*exp(0.20*x2),
)]
#[constraint(row1: (1.50 + 0.22*ln(1.60 + 0.64*cos(x3)))*dot(v3) - 0.26*sin(p1*x2 - 0.51)*dot(v1) + 0.42*v3*v2*sin(p1*x1 + 0.28) == 0)]
#[constraint(row2: 1.95*dot(v2) + 0.16*x2/(1 + powi(x2, 2))*dot(v1) + 0.20*tan(0.82*sin(x2))/2*dot(v3) + 0.65*v2*v2*1/sqrt(1.50 + powi(x1, 2)) == 0)]
#[independent(s1 = v1, s2 = v2 - 0.35*0.68*sin(x1)/(1.50 + cos(x2))*v1 + 0.46*sin(0.99*x2), s3 = 1.02*v3 - 0.30*x3/(1 + powi(x3, 2))*v1)]
#[output(place = 1/sqrt(1.50 + powi(x3, 2)), power = p1*v2*v3*x2/(1 + powi(x2, 2)) - p2*0.91, push = sin(0.96*x1)*dot(v3) + v1*ddot(x1), pull = 1.30*reaction(row2) - push, share = pull/(1.58 + powi(reaction(row2), 2)))]
pub struct Random153 {
    #[nominal(1.32)]
    pub p1: f64,
    #[nominal(0.62)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(diag(1.11, 1.21, (1.40 - 0.25*cos(1.04*x3 + 1.09))))]
#[forces(
    dot(x2)*dot(x2)/(1.19 + 0.17*1/sqrt(1.50 + powi(x3, 2))),
    p1*dot(x3)*dot(x1)*cos(1.09*x3) - 0.32*1/sqrt(1.50 + powi(x3, 2)) - dot(x3)*dot(x3)/(1.04 - 0.29*atan2(x2, 2 + cos(x2))/2) - dot(x2)*dot(x3)/(1.00 - 0.25*exp(-powi(x2, 2)/2)),
    p1*1.72 + p1*x2 + p1*exp(0.20*x2),
)]
#[potential_energy(cos(0.73*x1 + 0.74*x3 - 1.27))]
#[constraint(row1: 1.91*x3 + 0.19*x2 + 0.24 == 0)]
#[constraint(row2: 1.50*dot(x1) - 0.28*sin(0.62*x1)*dot(x2)*dot(x2) - 0.25*0.43*sin(x3)/(1.50 + cos(x2)) == 0)]
#[independent(dot(x2), dot(x1))]
pub struct Random154 {
    #[nominal(0.77)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inputs(tau)]
#[define(l11 = 1.26, l21 = 0.17*x1/(1 + powi(x1, 2)), l22 = (1.30 + 0.13*sin(0.63*t + 1.24)*cos(0.73*t)), l31 = 0.39*0.60*sin(x1)/(1.50 + cos(x1)), l33 = 1.15)]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31],
    [_, l21*l21 + l22*l22, l21*l31],
    [_, _, l31*l31 + l33*l33],
))]
#[forces(
    tau*0.55 + dot(x3)*sqrt(2 + powi(dot(x1), 2)),
    p2*exp(0.20*x1) + p1*x3 + tau*1.10,
    0.82*dot(x2) + 1.99*powi(dot(x3), 2),
)]
#[constraint(row1: (1.50 + 0.11*x2/(1 + powi(x2, 2)))*dot(x2) == 0)]
#[constraint(row2: (1.50 - 0.22*exp(-powi(x3, 2)/2))*dot(x3) + 0.30*sin(0.80*x2 + 0.67)*dot(x2) == 0)]
#[constraint(row3: (1.50 - 0.26*sin(p1*x3 + 0.22))*ddot(x1) + 0.27*exp(-powi(x2, 2)/2)*ddot(x2) + 0.21*0.50*sin(x2)/(1.50 + cos(x2))*ddot(x3) - 0.77*dot(x1)/sqrt(1.20 + powi(dot(x1), 2)) == 0)]
#[independent(s1 = dot(x1) + 0.22*sin(0.41*x3)*cos(0.43*x1 + 0.34)*dot(x2) + 0.35*tan(0.58*sin(t))/2)]
pub struct Random155 {
    #[nominal(0.96)]
    pub p1: f64,
    #[nominal(1.09)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(diag(1.05, (1.10 + 0.32*ln(1.60 + 0.94*cos(x3))), 1.39))]
#[forces(
    0,
    p3*dot(x2)*dot(x3)*sin(0.73*t - 0.73*x2 - 1.42),
    0.97*dot(x1)/(1 + powi(x3, 2)),
)]
#[potential_energy(tan(0.34*sin(x2))/2)]
#[constraint(row1: 1.70*dot(x3) - 0.13*sqrt(1.50 + powi(dot(x2), 2) + powi(dot(x2), 2)) - 0.39*tan(1.00*sin(x1))/2 == 0)]
#[constraint(row2: 1.00*dot(x1) + 0.18*dot(x1)*dot(x3)*0.65*sin(t)/(1.50 + cos(x2)) - 0.35*x1/(1 + powi(x1, 2)) == 0)]
#[constraint(again1: (1.05 + 0.25*powi(cos(0.75*x1 - 0.26*x1), 3))*(1.00*dot(x1) + 0.18*dot(x1)*dot(x3)*0.65*sin(t)/(1.50 + cos(x2)) - 0.35*x1/(1 + powi(x1, 2))) == 0, redundant)]
#[constraint(again2: (1.33 - 0.14*atan2(x1, 2 + cos(x3))/2)*(1.70*dot(x3) - 0.13*sqrt(1.50 + powi(dot(x2), 2) + powi(dot(x2), 2)) - 0.39*tan(1.00*sin(x1))/2) + 0.83*(1.00*dot(x1) + 0.18*dot(x1)*dot(x3)*0.65*sin(t)/(1.50 + cos(x2)) - 0.35*x1/(1 + powi(x1, 2))) == 0, redundant)]
#[output(place = exp(-powi(x2, 2)/2), power = dot(x2)*sqrt(2 + powi(dot(x1), 2)), push = 1/sqrt(1.50 + powi(x2, 2))*ddot(x2) + dot(x3)*ddot(x3), pull = (1.36 - 0.21*ln(1.60 + 0.51*cos(t)))*reaction(again2) - push, share = pull/(1.69 + powi(reaction(again2), 2)))]
pub struct Random157 {
    #[nominal(0.50)]
    pub p1: f64,
    #[nominal(1.25)]
    pub p2: f64,
    #[nominal(0.65)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[inertia(matrix(
    [(1.27)*(1.27), (1.27)*(0.25*exp(-powi(x2, 2)/2))],
    [_, (0.25*exp(-powi(x2, 2)/2))*(0.25*exp(-powi(x2, 2)/2)) + ((1.26 + 0.28*0.66*sin(x1)/(1.50 + cos(t))))*((1.26 + 0.28*0.66*sin(x1)/(1.50 + cos(t))))],
))]
#[forces(
    1.21*dot(x2),
    0,
)]
#[constraint(row1: 1.88*x1 + 0.20*sin(x1) + 0.30*sin(0.40*t) + 0.66 == 0)]
#[constraint(row2: (1.50 - 0.19*t/(1 + powi(t, 2)))*dot(x2) - 0.22*sin(0.89*x1 - 0.76*t - 1.06)*cos(0.89*x1 - 0.33*x2)*dot(x1) == 0)]
pub struct Random158 {
    #[nominal(0.66)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = (1.12 + 0.22*exp(-powi(x2, 2)/2))*dot(x1) - 0.24*cos(0.93*x2 - 0.36),
    v2 = (1.14 + 0.21*sin(0.82*x3 + 0.74*x3))*dot(x2) - 0.13*sin(p1*x2 + 0.92)*dot(x1) + 0.26*x1/(1 + powi(x1, 2)),
    v3 = (1.11 + 0.22*ln(1.60 + 0.64*cos(x2)))*dot(x3) + 0.35*powi(cos(1.10*x3 + 0.34*x1 + 1.09), 3)*dot(x2) + 0.37*cos(0.81*x1),
)]
#[inertia(diag((1.21 + 0.31*exp(-powi(x2, 2)/2)), (1.27 + 0.22*tan(0.35*sin(x3))/2), (1.24 - 0.12*tan(0.74*sin(x3))/2)))]
#[forces(
    p2*x1 - p2*v3*v3*powi(cos(0.93*x2 + 0.78*x3), 3) - p1*0.40,
    1.56*powi(v1, 2) - v1*sqrt(2 + powi(v3, 2)),
    0.89*sin(p2*x1 - 0.36),
)]
#[configuration(x3 = 1.42*tan(0.65*sin(x2))/2, x1 = 1.21*exp(-powi(x2, 2)/2))]
#[constraint(bound: 1.63*dot(v2) + 0.21*atan2(x2, 2 + cos(x2))/2*dot(v3) + 0.22*powi(cos(0.84*x3), 3)*dot(v1) + 0.25*v2*v3*sin(p2*x2 + 0.24) == 0)]
#[output(place = sin(0.47*x3), power = p2*1.94 + v2*sqrt(2 + powi(v1, 2)) + v1*sqrt(2 + powi(v2, 2)), push = powi(cos(1.01*x1 - 0.82*x2), 3)*dot(v3) + v3*ddot(x3), pull = (1.20 + 0.13*0.80*sin(x3)/(1.50 + cos(x2)))*reaction(bound) - push, share = pull/(1.14 + powi(reaction(bound), 2)))]
pub struct Random159 {
    #[nominal(1.11)]
    pub p1: f64,
    #[nominal(1.39)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[define(l11 = (1.30 + 0.32*atan2(x3, 2 + cos(x2))/2), l21 = 0.16*cos(0.62*x1 + 0.77*x2 + 1.17), l22 = (1.26 + 0.22*sin(0.68*x3 + 0.55)), l31 = 0.40*exp(-powi(x1, 2)/2), l33 = 1.08)]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31],
    [_, l21*l21 + l22*l22, l21*l31],
    [_, _, l31*l31 + l33*l33],
))]
#[forces(
    p1*exp(0.20*x1) + 0.97*powi(dot(x1), 2) + 1.48*dot(x2) + 1.55*dot(x1)/(1 + powi(x2, 2)),
    dot(x2)*sqrt(2 + powi(dot(x1), 2)) - 1.58*sin(0.79*x1 - 0.62*x2 + 0.70) - p1*exp(0.20*x2),
    1.65*dot(x3)/(1 + powi(x2, 2)) - 1.91*dot(x3),
)]
#[constraint(row1: (1.50 - 0.23*exp(-powi(x2, 2)/2))*dot(x3) - 0.33*0.88*sin(x1)/(1.50 + cos(x2))*dot(x1) - 0.30*0.79*sin(x2)/(1.50 + cos(x2))*dot(x2) == 0)]
pub struct Random161 {
    #[nominal(0.70)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(matrix(
    [((1.31 - 0.26*atan2(t, 2 + cos(x4))/2))*((1.31 - 0.26*atan2(t, 2 + cos(x4))/2)), ((1.31 - 0.26*atan2(t, 2 + cos(x4))/2))*(0.29*atan2(x2, 2 + cos(x1))/2), 0, ((1.31 - 0.26*atan2(t, 2 + cos(x4))/2))*(0.32*exp(-powi(x1, 2)/2))],
    [_, (0.29*atan2(x2, 2 + cos(x1))/2)*(0.29*atan2(x2, 2 + cos(x1))/2) + ((1.20 + 0.31*x3/(1 + powi(x3, 2))))*((1.20 + 0.31*x3/(1 + powi(x3, 2)))), ((1.20 + 0.31*x3/(1 + powi(x3, 2))))*(0.31*x1/(1 + powi(x1, 2))), (0.29*atan2(x2, 2 + cos(x1))/2)*(0.32*exp(-powi(x1, 2)/2)) + ((1.20 + 0.31*x3/(1 + powi(x3, 2))))*(0.32*sin(p3*x4 - 0.54))],
    [_, _, (0.31*x1/(1 + powi(x1, 2)))*(0.31*x1/(1 + powi(x1, 2))) + (1.05)*(1.05), (0.31*x1/(1 + powi(x1, 2)))*(0.32*sin(p3*x4 - 0.54)) + (1.05)*(0.16*sin(0.61*t))],
    [_, _, _, (0.32*exp(-powi(x1, 2)/2))*(0.32*exp(-powi(x1, 2)/2)) + (0.32*sin(p3*x4 - 0.54))*(0.32*sin(p3*x4 - 0.54)) + (0.16*sin(0.61*t))*(0.16*sin(0.61*t)) + ((1.03 + 0.15*atan2(t, 2 + cos(x2))/2))*((1.03 + 0.15*atan2(t, 2 + cos(x2))/2))],
))]
#[forces(
    1.23*ln(1.60 + 0.73*cos(x4)) + p3*x3 + 0.81*sin(0.50*x1 + 0.71*x2 + 1.13)*cos(0.78*x4),
    p2*dot(x1)*dot(x3)*atan2(x1, 2 + cos(x2))/2 - dot(x1)*dot(x1)/1.21,
    dot(x4)*sqrt(2 + powi(dot(x2), 2)),
    p2*1.56 + dot(x4)*sqrt(2 + powi(dot(x1), 2)),
)]
#[constraint(row1: 1.63*x1 + exp(0.21*x2)/2 + 0.30*sin(1.17*t) + 0.33 == 0)]
#[constraint(row2: 1.25*x4 + 0.27*sin(x4) + 0.13*x2*x1 + 0.15*sin(x1) + 0.30*sin(0.54*t) + 0.19 == 0)]
#[constraint(row3: 1.78*x3 + 0.21*sin(x3) + 0.35*x2 + 0.30*sin(1.49*t) - 0.16 == 0)]
#[independent(s1 = (1.50 - 0.20*atan2(x3, 2 + cos(x3))/2)*dot(x2) - 0.18*cos(0.66*t)*dot(x1) + 0.47*x3/(1 + powi(x3, 2)))]
#[output(place = tan(0.53*sin(x2))/2, power = dot(x2)*dot(x1)/(1.06 + 0.21*sin(0.83*x3 + 0.13)), push = sin(0.93*t + 0.26*x3 + 1.41)*ddot(x1) + dot(x2)*ddot(x2), pull = (1.01 - 0.15*tan(0.95*sin(x4))/2)*reaction(row3) - push, share = pull/(1.05 + powi(reaction(row3), 2)))]
pub struct Random162 {
    #[nominal(1.39)]
    pub p1: f64,
    #[nominal(0.57)]
    pub p2: f64,
    #[nominal(0.74)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(diag((1.32 - 0.14*ln(1.60 + 0.83*cos(x2))), (1.33 + 0.20*x3/(1 + powi(x3, 2))), (1.02 + 0.12*1/sqrt(1.50 + powi(t, 2))), (1.09 - 0.12*cos(0.89*x1 - 0.54*x1))))]
#[forces(
    0,
    p1*1.19 - dot(x1)*dot(x2)/1.10 - p1*exp(0.20*t) - dot(x3)*dot(x4)/(1.14 + 0.16*sin(0.79*x1)*cos(0.92*x4 - 0.31*x4 - 0.98)),
    0,
    p1*dot(x2)*dot(x2)*cos(1.10*x3 - 1.05) + p1*exp(0.20*t),
)]
#[constraint(row1: 1.76*x4 + 0.21*sin(x4) + exp(0.15*x3)/2 + 0.30*sin(0.62*t) - 0.42 == 0)]
#[constraint(row2: (1.50 + 0.28*t/(1 + powi(t, 2)))*dot(x2) - 0.32*sin(0.53*t - 0.35)*dot(x3) - 0.32*sin(1.06*x1)*dot(x4) == 0)]
#[constraint(row3: dot(x1) - 0.27*cos(0.98*x4 - 0.64*x2)*dot(x3) - 0.25*sin(1.07*x4)*cos(0.63*x1)*dot(x4) == 0)]
#[output(place = sin(0.74*t + 0.22*x1 + 1.40), power = 0.75*dot(x3), push = sin(0.47*t - 1.33)*cos(0.89*x4)*ddot(x3) + dot(x4)*ddot(x4), pull = (1.00 - 0.10*cos(0.85*x1))*reaction(row1) - push, share = pull/(1.45 + powi(reaction(row1), 2)))]
pub struct Random163 {
    #[nominal(0.51)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    dot(x1) = (1.18 - 0.26*exp(-powi(x3, 2)/2))*v1 + 0.23*ln(1.60 + 0.76*cos(x4))*v3 + 0.31*powi(cos(0.97*x1 - 0.26*x2), 3),
    dot(x2) = (1.25 + 0.33*0.58*sin(x2)/(1.50 + cos(x2)))*v2 - 0.22*sin(1.07*x3)*cos(0.95*x1 + 0.39*x1),
    dot(x3) = (1.32 - 0.27*1/sqrt(1.50 + powi(x1, 2)))*v3 + 0.34*sin(p3*x2 + 0.15),
    dot(x4) = 1.22*v4 - 0.35*sin(0.85*x4)*v2 + 0.60*atan2(x2, 2 + cos(x4))/2,
)]
#[inertia(matrix(
    [(1.26)*(1.26), (1.26)*(0.39*sin(0.90*x4 + 1.14)), (1.26)*(0.39*cos(1.15*x3 + 0.88*x1 - 0.64)), (1.26)*(0.40*tan(0.98*sin(x4))/2)],
    [_, (0.39*sin(0.90*x4 + 1.14))*(0.39*sin(0.90*x4 + 1.14)) + (1.20)*(1.20), (0.39*sin(0.90*x4 + 1.14))*(0.39*cos(1.15*x3 + 0.88*x1 - 0.64)), (0.39*sin(0.90*x4 + 1.14))*(0.40*tan(0.98*sin(x4))/2)],
    [_, _, (0.39*cos(1.15*x3 + 0.88*x1 - 0.64))*(0.39*cos(1.15*x3 + 0.88*x1 - 0.64)) + ((1.07 - 0.34*exp(-powi(x1, 2)/2)))*((1.07 - 0.34*exp(-powi(x1, 2)/2))), (0.39*cos(1.15*x3 + 0.88*x1 - 0.64))*(0.40*tan(0.98*sin(x4))/2) + ((1.07 - 0.34*exp(-powi(x1, 2)/2)))*(0.32*sin(p1*x2 - 0.17))],
    [_, _, _, (0.40*tan(0.98*sin(x4))/2)*(0.40*tan(0.98*sin(x4))/2) + (0.32*sin(p1*x2 - 0.17))*(0.32*sin(p1*x2 - 0.17)) + ((1.24 + 0.11*cos(1.07*x3 + 0.17)))*((1.24 + 0.11*cos(1.07*x3 + 0.17)))],
))]
#[forces(
    0,
    p1*0.60 - p2*x3 - 0.41*v2/(1 + powi(x3, 2)) - 0.71*powi(v4, 2),
    p3*exp(0.20*x2),
    0.66*x4/(1 + powi(x4, 2)) - v2*sqrt(2 + powi(v3, 2)),
)]
#[configuration(x4 = 1.43*tan(0.85*sin(x2))/2, x1 = 1.34*sin(0.61*x2 - 0.69*x2))]
#[constraint(held_x4: x4 - (1.43*tan(0.85*sin(x2))/2) == 0)]
#[constraint(held_x1: x1 - (1.34*sin(0.61*x2 - 0.69*x2)) == 0)]
pub struct Random166 {
    #[nominal(1.45)]
    pub p1: f64,
    #[nominal(1.00)]
    pub p2: f64,
    #[nominal(1.18)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = (1.21 - 0.15*sin(0.58*x3 - 0.99))*dot(x1) - 0.11*1/sqrt(1.50 + powi(x4, 2))*dot(x4),
    v2 = 1.04*dot(x2) - 0.34*x1/(1 + powi(x1, 2))*dot(x3),
    v3 = (1.25 - 0.17*exp(-powi(x4, 2)/2))*dot(x3) - 0.23*tan(0.66*sin(x2))/2*dot(x2),
    v4 = dot(x4) - 0.18*0.83*sin(x1)/(1.50 + cos(x2))*dot(x1),
)]
#[define(l11 = (1.14 - 0.26*atan2(x1, 2 + cos(x3))/2), l21 = 0.29*tan(0.34*sin(x2))/2, l22 = (1.25 - 0.27*sin(1.17*x4 - 0.61)), l31 = 0.38*atan2(x3, 2 + cos(x2))/2, l32 = 0.15*atan2(x1, 2 + cos(x4))/2, l33 = (1.33 + 0.34*sin(p1*x1 + 0.41)), l41 = 0.11*x4/(1 + powi(x4, 2)), l42 = 0.35*sin(0.50*x2 - 0.56), l43 = 0.26*cos(0.42*x2 + 0.34*x2), l44 = (1.18 - 0.22*cos(1.18*x4 - 0.32*x3)))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, l11*l41],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l21*l41 + l22*l42],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l32*l42 + l33*l43],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44],
))]
#[forces(
    p2*v4*v3*powi(cos(0.44*x2), 3) - 1.01*powi(v1, 2) - v1*v2/(1.11 + 0.19*1/sqrt(1.50 + powi(x2, 2))),
    0,
    v1*sqrt(2 + powi(v3, 2)) + 1.10*powi(v4, 2) + p3*v3*v2*sin(p1*x2 - 0.16) + p1*exp(0.20*x3),
    1.06*1/sqrt(1.50 + powi(x4, 2)) - 1.87*powi(v1, 2),
)]
#[potential_energy(sin(p2*x2 + 0.69))]
#[configuration(of(q1, q2), x1 = 1.25*q1, x3 = 1.25*q2, x2 = 0.99*sin(q1)/(1.50 + cos(q1)), x4 = 0.77*sin(q1)/(1.50 + cos(q2)))]
#[constraint(held_x2: x2 - (0.99*sin((x1/1.25))/(1.50 + cos((x1/1.25)))) == 0)]
#[constraint(held_x4: x4 - (0.77*sin((x1/1.25))/(1.50 + cos((x3/1.25)))) == 0)]
#[output(place = exp(-powi(x3, 2)/2), power = 1.04*0.75*sin(x2)/(1.50 + cos(x1)) - 0.30*v4, push = sin(p3*x3 + 0.68)*dot(v2) + v3*ddot(x3), pull = 1.16*reaction(held_x4) - push, share = pull/(1.64 + powi(reaction(held_x4), 2)))]
pub struct Random167 {
    #[nominal(0.62)]
    pub p1: f64,
    #[nominal(0.87)]
    pub p2: f64,
    #[nominal(0.79)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = (1.11 - 0.24*ln(1.60 + 0.63*cos(x1)))*v1 + 0.17*x3/(1 + powi(x3, 2))*v2 + 0.27*sin(p3*x2 - 0.85),
    dot(x2) = 1.17*v2 - 0.39*atan2(x2, 2 + cos(x1))/2,
    dot(x3) = (1.19 + 0.10*cos(0.87*x3 - 0.70*x2))*v3 - 0.48*x2/(1 + powi(x2, 2)),
)]
#[inertia(diag((1.36 + 0.31*cos(0.44*x1)), (1.35 - 0.16*atan2(x2, 2 + cos(x1))/2), (1.05 + 0.25*cos(0.65*x1))))]
#[forces(
    0.86*v2/(1 + powi(x1, 2)) + v1*sqrt(2 + powi(v1, 2)) + p2*exp(0.20*x2),
    0,
    p3*1.95,
)]
#[configuration(x3 = 0.66*powi(cos(0.75*x2), 3), x1 = 0.85*ln(1.60 + 0.74*cos(x2)))]
#[constraint(held_x3: x3 - (0.66*powi(cos(0.75*x2), 3)) == 0)]
#[constraint(held_x1: x1 - (0.85*ln(1.60 + 0.74*cos(x2))) == 0)]
pub struct Random168 {
    #[nominal(1.00)]
    pub p1: f64,
    #[nominal(0.92)]
    pub p2: f64,
    #[nominal(1.04)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(matrix(
    [(1.11)*(1.11), (1.11)*(0.24*sin(0.66*x1)), (1.11)*(0.34*atan2(x3, 2 + cos(t))/2)],
    [_, (0.24*sin(0.66*x1))*(0.24*sin(0.66*x1)) + (1.11)*(1.11), (0.24*sin(0.66*x1))*(0.34*atan2(x3, 2 + cos(t))/2)],
    [_, _, (0.34*atan2(x3, 2 + cos(t))/2)*(0.34*atan2(x3, 2 + cos(t))/2) + ((1.40 - 0.21*tan(0.84*sin(x1))/2))*((1.40 - 0.21*tan(0.84*sin(x1))/2))],
))]
#[forces(
    p1*t + 0.34*dot(x2),
    0.81*powi(dot(x2), 2) + 1.16*dot(x3) + p1*0.45,
    dot(x2)*dot(x2)/(1.11 - 0.12*1/sqrt(1.50 + powi(x3, 2))) - p1*exp(0.20*x2) - 1.89*dot(x3) - p1*1.23,
)]
#[constraint(row1: dot(x1) + 0*dot(x2) + 0.37*exp(-powi(x1, 2)/2)*dot(x3) + 0.40*ln(1.60 + 0.39*cos(x1)) == 0)]
#[complement(
    w1 = [-(1.20 + 0.34*powi(cos(0.40*x1), 3))*(0), (1.20 + 0.34*powi(cos(0.40*x1), 3)), 0],
    w2 = [-(1.17 + 0.11*cos(0.60*x2 + 0.61))*(0.37*exp(-powi(x1, 2)/2)), 0, (1.17 + 0.11*cos(0.60*x2 + 0.61))],
)]
#[output(place = cos(0.91*t - 0.44*x3), power = p1*1.86, push = exp(-powi(x1, 2)/2)*ddot(x1) + dot(x2)*ddot(x2), pull = (1.16 - 0.22*ln(1.60 + 0.72*cos(t)))*reaction(row1) - push, share = pull/(1.53 + powi(reaction(row1), 2)))]
pub struct Random169 {
    #[nominal(1.34)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = v1 + 0.18*sin(0.98*x3)*cos(1.05*x1 + 0.33*x2 - 1.48)*v2,
    dot(x2) = v2,
    dot(x3) = (1.23 - 0.22*cos(0.70*x1 - 0.28))*v3 - 0.33*sin(1.11*x3 - 1.19)*v1,
)]
#[inertia(matrix(
    [((1.01 - 0.14*powi(cos(0.74*x2 - 1.09), 3)))*((1.01 - 0.14*powi(cos(0.74*x2 - 1.09), 3))), 0, ((1.01 - 0.14*powi(cos(0.74*x2 - 1.09), 3)))*(0.39*sin(1.19*x3))],
    [_, ((1.04 + 0.32*cos(1.08*x1 + 0.18)))*((1.04 + 0.32*cos(1.08*x1 + 0.18))), 0],
    [_, _, (0.39*sin(1.19*x3))*(0.39*sin(1.19*x3)) + ((1.34 - 0.31*0.37*sin(x3)/(1.50 + cos(x1))))*((1.34 - 0.31*0.37*sin(x3)/(1.50 + cos(x1))))],
))]
#[forces(
    0.93*sin(1.12*x1 + 0.65*x1 + 0.31) + 1.63*x3/(1 + powi(x3, 2)),
    v3*sqrt(2 + powi(v1, 2)),
    0,
)]
#[constraint(row1: 1.23*x1 + 0.27*sin(x1) + 0.14*x3 - 0.33 == 0)]
#[constraint(row2: 1.91*x2 + 0.30*sin(x3) + 0.31*x1 - 0.67 == 0)]
#[independent(s1 = (1.50 - 0.21*ln(1.60 + 0.73*cos(x3)))*v3 - 0.21*1/sqrt(1.50 + powi(x2, 2))*v1 - 0.31*1/sqrt(1.50 + powi(x3, 2)))]
#[independent(v3)]
#[output(place = exp(-powi(x1, 2)/2), power = 1.95*v1/(1 + powi(x1, 2)) + p2*x2 + 0.33*v2/(1 + powi(x2, 2)) + p1*x1, push = ln(1.60 + 0.37*cos(x1))*dot(v1) + v2*ddot(x2), pull = (1.13 - 0.32*cos(0.57*x3 + 0.59*x2))*reaction(row2) - push, share = pull/(1.54 + powi(reaction(row2), 2)))]
pub struct Random170 {
    #[nominal(0.89)]
    pub p1: f64,
    #[nominal(1.22)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + powi(cos(0.72*x3 + 0.27*x1), 3)*dot(x1),
    v3 = dot(x3) + x1/(1 + powi(x1, 2))*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - powi(cos(0.72*x3 + 0.27*x1), 3)*(v1),
    dot(x3) = v3 - x1/(1 + powi(x1, 2))*(v1),
)]
#[inertia(matrix(
    [((1.14 + 0.21*cos(0.42*x1)))*((1.14 + 0.21*cos(0.42*x1))), 0, ((1.14 + 0.21*cos(0.42*x1)))*(0.33*x1/(1 + powi(x1, 2)))],
    [_, ((1.11 - 0.24*0.84*sin(x3)/(1.50 + cos(x1))))*((1.11 - 0.24*0.84*sin(x3)/(1.50 + cos(x1)))), 0],
    [_, _, (0.33*x1/(1 + powi(x1, 2)))*(0.33*x1/(1 + powi(x1, 2))) + (1.28)*(1.28)],
))]
#[forces(
    p1*v1*v3*ln(1.60 + 0.56*cos(x3)) - p3*x3 - p1*x2 - 1.64*v1/(1 + powi(x2, 2)),
    p3*x2 + 1.48*v3/(1 + powi(x2, 2)),
    p3*0.33 + v3*v2/1.03 + p2*1.92 + 0.53*cos(0.40*x2 - 0.52*x3),
)]
#[constraint(row1: (1.50 + 0.23*sin(1.15*x2 + 0.87*x3 + 0.61)*cos(0.80*x1 - 0.34*x2))*v1 == 0)]
#[constraint(row2: 1.43*v2 + 0.24*cos(0.90*x3)*v1 - 0.24*tan(0.93*sin(x3))/2 == 0)]
#[constraint(row3: v3 + 0.25*exp(-powi(x2, 2)/2)*v1 + 0.24*sin(p1*x3 - 0.92)*v2 + 0.51*x1/(1 + powi(x1, 2)) == 0)]
#[output(place = cos(0.49*x3), power = p1*v3*v3*tan(0.99*sin(x3))/2 - p3*1.24 - 1.79*powi(cos(0.49*x2 - 0.22*x2), 3) - 1.10*powi(v1, 2), push = atan2(x1, 2 + cos(x1))/2*dot(v2) + v1*ddot(x1), pull = (1.06 - 0.33*cos(0.45*x3 + 1.31))*reaction(row2) - push, share = pull/(1.47 + powi(reaction(row2), 2)))]
pub struct Random171 {
    #[nominal(1.21)]
    pub p1: f64,
    #[nominal(1.40)]
    pub p2: f64,
    #[nominal(1.07)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + sin(1.12*x2)*dot(x1),
    v3 = dot(x3) + cos(0.63*x2)*dot(x1),
    v4 = dot(x4) + cos(1.01*x4 + 0.59*x1)*dot(x2),
    dot(x1) = v1,
    dot(x2) = v2 - sin(1.12*x2)*(v1),
    dot(x3) = v3 - cos(0.63*x2)*(v1),
    dot(x4) = v4 - cos(1.01*x4 + 0.59*x1)*(v2 - sin(1.12*x2)*(v1)),
)]
#[define(l11 = (1.37 - 0.34*sin(p1*x2 + 0.99)), l21 = 0.16*cos(1.16*x3), l22 = 1.32, l31 = 0.21*sin(0.97*x4), l32 = 0.10*ln(1.60 + 0.35*cos(x4)), l33 = 1.33, l41 = 0.24*atan2(x4, 2 + cos(x1))/2, l43 = 0.29*x2/(1 + powi(x2, 2)), l44 = 1.06)]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, l11*l41],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l21*l41],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l33*l43],
    [_, _, _, l41*l41 + l43*l43 + l44*l44],
))]
#[forces(
    v4*sqrt(2 + powi(v2, 2)) - v2*sqrt(2 + powi(v2, 2)) - p1*1.48 - p1*0.37,
    0,
    p1*1.72 - p1*v2*v3*0.49*sin(x4)/(1.50 + cos(x4)) - 1.99*ln(1.60 + 0.65*cos(x1)) - p1*x2,
    p1*v4*v4*cos(0.43*x4 - 0.24*x2) + 1.52*sin(0.94*x4 + 0.22)*cos(0.53*x1),
)]
#[potential_energy(ln(1.60 + 0.77*cos(x4)))]
#[constraint(row1: v3 + 0.23*cos(0.68*x1 - 0.58*x1)*v4 == 0)]
#[constraint(row2: v1 - 0.25*sin(0.84*x2 - 0.21*x2)*v4 + 0.13*sin(p1*x4 - 0.28)*v3 - 0.42*atan2(x4, 2 + cos(x2))/2 == 0)]
#[constraint(row3: 1.80*v2 - 0.20*sqrt(1.50 + powi(v3, 2) + powi(v1, 2)) + 0.47*0.68*sin(x2)/(1.50 + cos(x1)) == 0)]
pub struct Random172 {
    #[nominal(0.84)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    dot(x1) = 1.07*v1 - 0.11*ln(1.60 + 0.98*cos(x3))*v3 - 0.23*ln(1.60 + 0.36*cos(x3)),
    dot(x2) = (1.23 - 0.29*exp(-powi(x4, 2)/2))*v2 - 0.26*atan2(x4, 2 + cos(x4))/2*v3 + 0.28*1/sqrt(1.50 + powi(x2, 2)),
    dot(x3) = 1.13*v3 + 0.25*powi(cos(0.79*x1 + 1.48), 3)*v1 - 0.29*cos(1.11*x4 + 0.78*x3),
    dot(x4) = 1.21*v4 - 0.33*atan2(x2, 2 + cos(x1))/2*v3 + 0.60*x1/(1 + powi(x1, 2)),
)]
#[inertia(matrix(
    [((1.22 - 0.27*powi(cos(0.70*x2 + 0.69*x2 + 0.64), 3)))*((1.22 - 0.27*powi(cos(0.70*x2 + 0.69*x2 + 0.64), 3))), ((1.22 - 0.27*powi(cos(0.70*x2 + 0.69*x2 + 0.64), 3)))*(0.22*1/sqrt(1.50 + powi(x3, 2))), ((1.22 - 0.27*powi(cos(0.70*x2 + 0.69*x2 + 0.64), 3)))*(0.30*sin(1.00*x3 - 0.44*x4 + 1.32)*cos(0.55*x1 + 0.67*x3 + 0.21)), 0],
    [_, (0.22*1/sqrt(1.50 + powi(x3, 2)))*(0.22*1/sqrt(1.50 + powi(x3, 2))) + ((1.26 + 0.15*x2/(1 + powi(x2, 2))))*((1.26 + 0.15*x2/(1 + powi(x2, 2)))), (0.22*1/sqrt(1.50 + powi(x3, 2)))*(0.30*sin(1.00*x3 - 0.44*x4 + 1.32)*cos(0.55*x1 + 0.67*x3 + 0.21)), 0],
    [_, _, (0.30*sin(1.00*x3 - 0.44*x4 + 1.32)*cos(0.55*x1 + 0.67*x3 + 0.21))*(0.30*sin(1.00*x3 - 0.44*x4 + 1.32)*cos(0.55*x1 + 0.67*x3 + 0.21)) + ((1.22 + 0.34*powi(cos(0.44*x1), 3)))*((1.22 + 0.34*powi(cos(0.44*x1), 3))), ((1.22 + 0.34*powi(cos(0.44*x1), 3)))*(0.14*sin(0.61*x2)*cos(0.42*x4 + 0.56*x1 - 1.32))],
    [_, _, _, (0.14*sin(0.61*x2)*cos(0.42*x4 + 0.56*x1 - 1.32))*(0.14*sin(0.61*x2)*cos(0.42*x4 + 0.56*x1 - 1.32)) + ((1.38 - 0.16*atan2(x2, 2 + cos(x2))/2))*((1.38 - 0.16*atan2(x2, 2 + cos(x2))/2))],
))]
#[forces(
    p1*exp(0.20*x1) + p1*x4 + 1.68*x4/(1 + powi(x4, 2)),
    0,
    1.17*v1 - p1*v2*v1*sin(0.56*x1 - 0.80*x3),
    1.97*v2,
)]
#[constraint(row1: (1.50 + 0.19*powi(cos(0.63*x3), 3))*v4 - 0.27*1/sqrt(1.50 + powi(x3, 2)) == 0)]
#[constraint(row2: 1.19*dot(v2) - 0.18*tan(0.37*sin(x1))/2*dot(v4) + 0.45*v2 + 0.45*powi(cos(1.10*x2), 3) == 0)]
#[constraint(row3: 1.28*dot(v3) + 0.15*sin(1.19*x2)*dot(v4) + 0.27*exp(-powi(x4, 2)/2)*dot(v2) - 0.55*v1*v1*cos(0.93*x4) == 0)]
#[constraint(row4: 1.90*dot(v1) - 0.29*atan2(x2, 2 + cos(x1))/2*dot(v4) + 0.19*1/sqrt(1.50 + powi(x1, 2))*dot(v2) + 0.47*ln(1.60 + 0.84*cos(x3)) == 0)]
pub struct Random175 {
    #[nominal(0.89)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.06 - 0.23*0.46*sin(x1)/(1.50 + cos(x2))), (1.11 + 0.31*tan(0.86*sin(x2))/2), (1.16 - 0.32*exp(-powi(x1, 2)/2))))]
#[forces(
    0.89*dot(x3)/(1 + powi(x2, 2)) - dot(x3)*dot(x2)/(1.32 + 0.17*0.69*sin(x1)/(1.50 + cos(x3))) - p1*x1,
    0.32*powi(dot(x1), 2) - 0.96*sin(p1*x1 - 0.23) - 0.62*powi(dot(x1), 2) - 1.09*powi(dot(x2), 2),
    p1*exp(0.20*x2) - p1*0.80 - p1*exp(0.20*x3),
)]
#[constraint(row1: dot(x2) == 0)]
#[constraint(row2: 1.71*dot(x3) + 0.28*dot(x3)*dot(x2)*sin(0.46*x3 - 0.56*x3) + 0.52*cos(0.75*x2 - 0.70*x3) == 0)]
#[constraint(row3: (1.50 + 0.11*atan2(x1, 2 + cos(x1))/2)*ddot(x1) - 0.14*exp(-powi(x3, 2)/2)*ddot(x2) - 0.28*0.87*sin(x2)/(1.50 + cos(x3))*ddot(x3) + 0.30*dot(x3)*dot(x2)*1/sqrt(1.50 + powi(x1, 2)) == 0)]
#[independent(s1 = dot(x1) + 0.15*sin(0.64*x1 + 0.47*x3 + 0.79)*cos(1.02*x2)*dot(x2), dot(x3))]
#[independent(dot(x1), dot(x3))]
pub struct Random176 {
    #[nominal(1.12)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[inputs(tau)]
#[kinematics(
    dot(x1) = v1 + 0.18*powi(cos(1.18*x3), 3)*v2 - 0.52*tan(0.66*sin(x3))/2,
    dot(x2) = v2 + 0.21*sin(0.87*x1 - 0.60)*cos(1.11*x3 - 0.84*x2),
    dot(x3) = (1.28 - 0.21*0.97*sin(x3)/(1.50 + cos(x3)))*v3 - 0.37*cos(0.67*x3 + 1.06)*v2 + 0.30*1/sqrt(1.50 + powi(x1, 2)),
)]
#[inertia(matrix(
    [((1.02 + 0.20*1/sqrt(1.50 + powi(x3, 2))))*((1.02 + 0.20*1/sqrt(1.50 + powi(x3, 2)))), ((1.02 + 0.20*1/sqrt(1.50 + powi(x3, 2))))*(0.21*atan2(x1, 2 + cos(x3))/2), ((1.02 + 0.20*1/sqrt(1.50 + powi(x3, 2))))*(0.22*1/sqrt(1.50 + powi(x3, 2)))],
    [_, (0.21*atan2(x1, 2 + cos(x3))/2)*(0.21*atan2(x1, 2 + cos(x3))/2) + (1.23)*(1.23), (0.21*atan2(x1, 2 + cos(x3))/2)*(0.22*1/sqrt(1.50 + powi(x3, 2))) + (1.23)*(0.25*cos(1.17*x3))],
    [_, _, (0.22*1/sqrt(1.50 + powi(x3, 2)))*(0.22*1/sqrt(1.50 + powi(x3, 2))) + (0.25*cos(1.17*x3))*(0.25*cos(1.17*x3)) + ((1.12 + 0.22*atan2(x2, 2 + cos(x2))/2))*((1.12 + 0.22*atan2(x2, 2 + cos(x2))/2))],
))]
#[forces(
    tau*1.43,
    1.69*sin(p3*x1 + 0.40) + p1*exp(0.20*x1) + p3*x3,
    p2*v2*v3*cos(0.48*x1 - 0.73*x2),
)]
#[constraint(row1: 1.53*x1 + 0.32*x3*x3 - 0.19 == 0)]
#[constraint(row2: 1.34*x2 + 0.29*powi(x3, 2)/2 + 0.28*powi(x1, 2)/2 - 0.42 == 0)]
#[constraint(again1: 0.77*(1.53*x1 + 0.32*x3*x3 - 0.19) + 0.58*(1.34*x2 + 0.29*powi(x3, 2)/2 + 0.28*powi(x1, 2)/2 - 0.42) == 0, redundant)]
#[output(place = sin(p3*x2 + 0.79), power = v3*v2/(1.05 + 0.11*powi(cos(0.52*x1 - 1.45), 3)) - v3*sqrt(2 + powi(v3, 2)) - 1.92*v3/(1 + powi(x2, 2)), push = sin(0.60*x2 + 0.36)*dot(v2) + v2*ddot(x2), pull = (1.06 + 0.27*ln(1.60 + 0.72*cos(x3)))*reaction(row1) - push, share = pull/(1.47 + powi(reaction(row1), 2)))]
pub struct Random177 {
    #[nominal(0.70)]
    pub p1: f64,
    #[nominal(0.90)]
    pub p2: f64,
    #[nominal(1.12)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = dot(x1) - 0.14*x2/(1 + powi(x2, 2))*dot(x2),
    v2 = dot(x2) - 0.21*sin(0.68*x3)*cos(1.00*x3 - 0.29*x2)*dot(x1),
    v3 = dot(x3),
)]
#[inertia(diag((1.38 + 0.21*sin(0.73*t - 0.41*t)*cos(1.04*t + 0.39)), 1.15, 1.06))]
#[forces(
    v2*sqrt(2 + powi(v1, 2)) + p3*0.38 + v3*v1/(1.10 + 0.34*powi(cos(0.56*x3 - 0.69*t), 3)) + 0.75*v2/(1 + powi(x2, 2)),
    p2*exp(0.20*x2) + p2*exp(0.20*x3) + p1*exp(0.20*t) + p3*v2*v1*atan2(x2, 2 + cos(x2))/2,
    0.62*v2/(1 + powi(x1, 2)) + 1.13*powi(cos(0.57*t - 0.83), 3) + p2*x2,
)]
#[constraint(row1: (1.50 + 0.23*1/sqrt(1.50 + powi(x3, 2)))*v3 + 0.16*exp(-powi(t, 2)/2)*v1 - 0.42*x3/(1 + powi(x3, 2)) == 0)]
#[constraint(row2: (1.50 + 0.21*sin(p1*x2 + 0.38))*v2 - 0.18*sin(0.59*x1 + 0.38*t)*v1 + 0.30*atan2(x3, 2 + cos(x3))/2*v3 == 0)]
#[output(place = ln(1.60 + 0.35*cos(t)), power = 0.71*powi(v2, 2) - 1.27*v3/(1 + powi(t, 2)), push = sin(0.56*t + 0.22*t - 1.22)*dot(v3) + v1*ddot(x1), pull = (1.35 + 0.30*powi(cos(1.14*x2 + 0.83*x1 + 1.32), 3))*reaction(row2) - push, share = pull/(1.37 + powi(reaction(row2), 2)))]
pub struct Random178 {
    #[nominal(0.61)]
    pub p1: f64,
    #[nominal(1.16)]
    pub p2: f64,
    #[nominal(0.97)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = 1.13*dot(x1) + 0.23*x2/(1 + powi(x2, 2))*dot(x2) - 0.40*atan2(x1, 2 + cos(x3))/2,
    v2 = dot(x2) - 0.16*exp(-powi(x3, 2)/2)*dot(x1) + 0.39*powi(cos(0.50*x3 + 0.84*x3 - 1.49), 3),
    v3 = dot(x3) - 0.20*cos(1.16*x3 + 0.33*x1 - 0.80)*dot(x1) + 0.45*sin(0.42*x2 + 0.77),
)]
#[inertia(diag((1.05 + 0.25*powi(cos(1.05*x3 + 0.31*x2 + 0.22), 3)), 1.21, (1.39 - 0.20*sin(1.11*x1 - 0.59*x1))))]
#[forces(
    1.33*tan(0.81*sin(x3))/2,
    p1*x1 - v2*sqrt(2 + powi(v2, 2)) - 1.32*tan(0.70*sin(x1))/2 - 0.70*v1/(1 + powi(x1, 2)),
    0.94*powi(v2, 2) + p1*exp(0.20*x1) + v1*v1/(1.04 - 0.18*sin(0.56*x2 + 0.53*x2)),
)]
#[configuration(x1 = 0.77*sin(0.97*x3)*cos(1.09*x3), x2 = 0.96*atan2(x3, 2 + cos(x3))/2)]
#[constraint(bound: dot(v3) - 0.13*powi(cos(0.91*x1), 3)*dot(v1) - 0.30*cos(1.15*x3)*dot(v2) + 0.79*v1*v2*tan(0.53*sin(x2))/2 == 0)]
pub struct Random179 {
    #[nominal(0.87)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = (1.30 + 0.21*sin(1.09*x1 - 1.45))*dot(x1) + 0.46*sin(0.40*t),
    v2 = (1.10 - 0.27*sin(0.60*x1 + 0.44*x1))*dot(x2) + 0.31*exp(-powi(x1, 2)/2)*dot(x3) - 0.23*exp(-powi(t, 2)/2),
    v3 = dot(x3) - 0.28*tan(0.77*sin(x3))/2*dot(x2) - 0.47*sin(0.46*x1),
    v4 = 1.19*dot(x4) - 0.27*tan(0.60*sin(x4))/2*dot(x1) - 0.52*cos(0.56*t),
)]
#[inertia(diag((1.01 - 0.31*ln(1.60 + 0.33*cos(x4))), 1.07, 1.18, (1.36 - 0.34*sin(0.77*x2))))]
#[forces(
    p3*x3,
    1.53*v4 + p2*t + p2*x4 + v1*sqrt(2 + powi(v1, 2)),
    1.72*v4,
    1.99*0.73*sin(t)/(1.50 + cos(x1)) - p1*exp(0.20*t) - p2*x1,
)]
#[potential_energy(x2/(1 + powi(x2, 2)))]
#[constraint(row1: v2 + 0.28*0.58*sin(t)/(1.50 + cos(x3))*v4 - 0.37*cos(0.55*x2 + 0.25*x4 - 0.50) == 0)]
#[independent(v1, v3, v4)]
#[independent(s1 = (1.50 + 0.28*sin(0.83*x2)*cos(1.05*x2))*v1 + 0.13*cos(0.62*t - 0.54)*v2, v3, s3 = (1.50 - 0.24*tan(0.63*sin(x2))/2)*v4 - 0.26*atan2(t, 2 + cos(x4))/2*v1)]
pub struct Random181 {
    #[nominal(0.70)]
    pub p1: f64,
    #[nominal(0.67)]
    pub p2: f64,
    #[nominal(1.11)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    dot(x1) = (1.10 - 0.14*ln(1.60 + 0.95*cos(x1)))*v1 + 0.25*cos(0.44*x2 + 0.45*x2 - 1.19)*v5 + 0.47*sin(1.00*x3)*cos(1.15*x5 + 0.75*x5),
    dot(x2) = (1.09 - 0.29*0.99*sin(x3)/(1.50 + cos(x4)))*v2 - 0.13*tan(0.81*sin(x3))/2*v1 + 0.26*sin(0.74*x2),
    dot(x3) = (1.06 - 0.34*exp(-powi(x2, 2)/2))*v3 - 0.20*ln(1.60 + 0.96*cos(x3))*v1 - 0.30*sin(0.97*x2 + 1.04),
    dot(x4) = 1.02*v4 - 0.19*tan(0.44*sin(x2))/2*v5 + 0.54*powi(cos(1.00*x2), 3),
    dot(x5) = (1.08 + 0.20*sin(0.97*x4 + 0.66*x5 + 1.24))*v5 - 0.31*sin(0.42*x5)*cos(0.58*x3 + 0.79*x2 - 0.60),
)]
#[inertia(matrix(
    [((1.36 - 0.20*exp(-powi(x4, 2)/2)))*((1.36 - 0.20*exp(-powi(x4, 2)/2))), ((1.36 - 0.20*exp(-powi(x4, 2)/2)))*(0.37*sin(0.59*x3 + 0.52*x2 + 1.37)), 0, ((1.36 - 0.20*exp(-powi(x4, 2)/2)))*(0.19*sin(p1*x4 + 0.47)), ((1.36 - 0.20*exp(-powi(x4, 2)/2)))*(0.35*tan(0.52*sin(x3))/2)],
    [_, (0.37*sin(0.59*x3 + 0.52*x2 + 1.37))*(0.37*sin(0.59*x3 + 0.52*x2 + 1.37)) + (1.29)*(1.29), (1.29)*(0.40*cos(0.46*x5 - 0.76*x4)), (0.37*sin(0.59*x3 + 0.52*x2 + 1.37))*(0.19*sin(p1*x4 + 0.47)), (0.37*sin(0.59*x3 + 0.52*x2 + 1.37))*(0.35*tan(0.52*sin(x3))/2)],
    [_, _, (0.40*cos(0.46*x5 - 0.76*x4))*(0.40*cos(0.46*x5 - 0.76*x4)) + (1.39)*(1.39), (1.39)*(0.16*tan(0.58*sin(x1))/2), 0],
    [_, _, _, (0.19*sin(p1*x4 + 0.47))*(0.19*sin(p1*x4 + 0.47)) + (0.16*tan(0.58*sin(x1))/2)*(0.16*tan(0.58*sin(x1))/2) + ((1.08 + 0.35*cos(1.17*x2 - 0.84*x2 - 0.35)))*((1.08 + 0.35*cos(1.17*x2 - 0.84*x2 - 0.35))), (0.19*sin(p1*x4 + 0.47))*(0.35*tan(0.52*sin(x3))/2) + ((1.08 + 0.35*cos(1.17*x2 - 0.84*x2 - 0.35)))*(0.20*sin(0.51*x3))],
    [_, _, _, _, (0.35*tan(0.52*sin(x3))/2)*(0.35*tan(0.52*sin(x3))/2) + (0.20*sin(0.51*x3))*(0.20*sin(0.51*x3)) + ((1.31 - 0.26*sin(0.89*x3 - 0.26*x3)))*((1.31 - 0.26*sin(0.89*x3 - 0.26*x3)))],
))]
#[forces(
    p1*x1 + 1.17*powi(v4, 2) + v4*v1/(1.24 - 0.32*tan(1.00*sin(x1))/2) + 1.86*v1/(1 + powi(x3, 2)),
    0,
    v5*sqrt(2 + powi(v1, 2)) - p1*v3*v1*atan2(x4, 2 + cos(x1))/2 - p1*x1 - v3*v5/1.16,
    1.18*v2/(1 + powi(x1, 2)) + p1*x3,
    1.49*v2/(1 + powi(x5, 2)) - v5*sqrt(2 + powi(v3, 2)),
)]
#[constraint(row1: 1.78*x4 + 0.24*sin(x4) + 0.19*powi(x5, 2)/2 - 0.33 == 0)]
#[constraint(row2: 1.53*x2 + 0.29*sin(x2) + 0.30*sin(x5) + exp(0.25*x4)/2 + 0.45 == 0)]
#[constraint(row3: 1.94*x3 + 0.35*sin(x5) + 0.20*x4*x2 + 0.11*powi(x2, 2)/2 + 0.61 == 0)]
#[constraint(row4: 1.54*x1 + 0.21*sin(x5) + exp(0.15*x4)/2 - 0.23 == 0)]
#[independent(s1 = v5 + 0.30*atan2(x2, 2 + cos(x4))/2*v4 + 0.54*x2/(1 + powi(x2, 2)))]
pub struct Random182 {
    #[nominal(1.46)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(matrix(
    [((1.38 - 0.21*1/sqrt(1.50 + powi(x3, 2))))*((1.38 - 0.21*1/sqrt(1.50 + powi(x3, 2)))), 0, 0, 0],
    [_, ((1.32 - 0.20*cos(1.03*x1 + 1.27)))*((1.32 - 0.20*cos(1.03*x1 + 1.27))), 0, ((1.32 - 0.20*cos(1.03*x1 + 1.27)))*(0.18*0.91*sin(x1)/(1.50 + cos(x4)))],
    [_, _, ((1.01 + 0.10*exp(-powi(x4, 2)/2)))*((1.01 + 0.10*exp(-powi(x4, 2)/2))), 0],
    [_, _, _, (0.18*0.91*sin(x1)/(1.50 + cos(x4)))*(0.18*0.91*sin(x1)/(1.50 + cos(x4))) + ((1.16 + 0.18*t/(1 + powi(t, 2))))*((1.16 + 0.18*t/(1 + powi(t, 2))))],
))]
#[forces(
    p1*x1 - 1.41*atan2(x2, 2 + cos(x3))/2 - p1*0.48 - dot(x2)*dot(x3)/(1.26 + 0.28*1/sqrt(1.50 + powi(x4, 2))),
    p2*t + p1*0.34 + p1*t,
    p1*1.65 + 1.49*dot(x1) + 0.96*dot(x2) + 1.39*powi(dot(x1), 2),
    p1*dot(x3)*dot(x3)*x2/(1 + powi(x2, 2)) - 1.00*0.75*sin(t)/(1.50 + cos(t)),
)]
#[potential_energy(sin(0.59*x2))]
#[constraint(row1: 1.88*x2 + 0.19*sin(x2) + 0.21*sin(x3) + 0.21*x4*x3 + 0.30*sin(1.33*t) + 0.76 == 0)]
#[constraint(row2: 1.51*dot(x1) - 0.30*tan(0.74*sin(x2))/2*dot(x3) == 0)]
#[output(place = sin(0.88*t), power = 1.65*dot(x1) - dot(x1)*sqrt(2 + powi(dot(x2), 2)) - p2*1.99, push = 1/sqrt(1.50 + powi(x4, 2))*ddot(x4) + dot(x4)*ddot(x4), pull = (1.38 + 0.20*sin(0.74*x4 + 0.34*x1)*cos(0.68*x3 - 1.08))*reaction(row1) - push, share = pull/(1.87 + powi(reaction(row1), 2)))]
pub struct Random183 {
    #[nominal(0.96)]
    pub p1: f64,
    #[nominal(0.97)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[inertia(diag((1.39 + 0.19*sin(p3*x2 + 0.90)), 1.23, (1.28 - 0.21*ln(1.60 + 0.74*cos(x5))), (1.22 + 0.13*powi(cos(1.05*x1 + 0.88*x4 + 0.68), 3)), 1.09))]
#[forces(
    1.70*powi(dot(x4), 2) - dot(x2)*dot(x1)/(1.30 + 0.10*sin(1.14*x4 + 0.29)*cos(1.00*x2 - 0.35*x5 + 1.22)) - 0.31*dot(x1)/(1 + powi(x3, 2)) - p3*x1,
    0.71*powi(dot(x1), 2) + p2*dot(x4)*dot(x4)*atan2(x3, 2 + cos(x3))/2,
    p2*x5,
    p1*exp(0.20*x2) - 1.96*dot(x5)/(1 + powi(x2, 2)) - p3*exp(0.20*x5),
    dot(x3)*sqrt(2 + powi(dot(x4), 2)) + dot(x5)*dot(x4)/1.19 + p3*dot(x1)*dot(x5)*powi(cos(0.65*x2 - 0.35*x1), 3) + 0.89*exp(-powi(x4, 2)/2),
)]
#[constraint(height: 2.00*x5 + 0.11*sin(x5) + 0.21*x3*x2 + 0.21*powi(x2, 2)/2 + 0.16*x1*x1 + 0.30*sin(0.56*t) + 0.48 == 0)]
#[constraint(height_rate: 2.00*dot(x5) + 0.11*cos(x5)*dot(x5) + 0.21*(dot(x3)*x2 + x3*dot(x2)) + 0.21*x2*dot(x2) + 0.16*(dot(x1)*x1 + x1*dot(x1)) + 0.30*0.56*cos(0.56*t) == 0)]
#[constraint(further: 1.94*dot(x4) - 0.16*sin(1.09*x1 + 1.06)*dot(x3) == 0)]
pub struct Random184 {
    #[nominal(1.43)]
    pub p1: f64,
    #[nominal(0.65)]
    pub p2: f64,
    #[nominal(0.53)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1) - 0.57*sin(p2*x1 + 0.92),
    v2 = dot(x2) - 0.17*sin(0.92*x3 + 0.88*x4 + 0.90)*dot(x4) - 0.59*cos(0.66*x5 + 0.46*x2),
    v3 = (1.11 + 0.29*exp(-powi(x4, 2)/2))*dot(x3) - 0.37*atan2(x2, 2 + cos(x1))/2*dot(x4) - 0.21*cos(0.76*x4 + 1.06),
    v4 = (1.08 - 0.28*atan2(x5, 2 + cos(x1))/2)*dot(x4) + 0.11*cos(0.59*x3 + 0.28)*dot(x5) - 0.50*0.73*sin(x3)/(1.50 + cos(x4)),
    v5 = dot(x5) + 0.22*sin(0.68*x2 - 1.49)*dot(x3) - 0.31*0.93*sin(x4)/(1.50 + cos(x5)),
)]
#[inertia(diag(1.10, (1.09 + 0.16*1/sqrt(1.50 + powi(x1, 2))), (1.22 - 0.16*cos(0.75*x2 - 0.10)), 1.37, 1.21))]
#[forces(
    p2*exp(0.20*x4),
    tau*1.99,
    0,
    p2*v3*v3*1/sqrt(1.50 + powi(x2, 2)) - v5*v2/(1.14 + 0.31*exp(-powi(x4, 2)/2)) - v3*v4/(1.38 - 0.16*sin(0.82*x2 - 0.71*x2 + 0.36)),
    v4*v1/(1.12 + 0.18*0.68*sin(x2)/(1.50 + cos(x1))),
)]
#[constraint(height: 1.88*x2 + 0.13*sin(x2) + exp(0.30*x3)/2 + 0.33*x1*x5 + exp(0.17*x5)/2 + 0.13 == 0)]
#[constraint(first: v4 + 0.19*1/sqrt(1.50 + powi(x5, 2))*v3 - 0.60*0.60*sin(x5)/(1.50 + cos(x4)) == 0)]
#[constraint(second: 1.88*dot(x2) + 0.13*cos(x2)*dot(x2) + 0.30*exp(0.30*x3)*dot(x3)/2 + 0.33*(dot(x1)*x5 + x1*dot(x5)) + 0.17*exp(0.17*x5)*dot(x5)/2 - 0.50*cos(0.57*x5 + 0.98)*(v4 + 0.19*1/sqrt(1.50 + powi(x5, 2))*v3 - 0.60*0.60*sin(x5)/(1.50 + cos(x4))) == 0)]
#[output(place = sin(0.69*x3 + 0.58*x1 - 0.92), power = p3*exp(0.20*x4) + 0.49*cos(0.40*x1 - 0.55*x2 - 0.99), push = cos(0.55*x4)*dot(v4) + v5*ddot(x5))]
pub struct Random185 {
    #[nominal(1.50)]
    pub p1: f64,
    #[nominal(0.59)]
    pub p2: f64,
    #[nominal(0.75)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[inertia(matrix(
    [((1.33 - 0.23*powi(cos(0.88*x2 + 0.48*x4 + 1.12), 3)))*((1.33 - 0.23*powi(cos(0.88*x2 + 0.48*x4 + 1.12), 3))), ((1.33 - 0.23*powi(cos(0.88*x2 + 0.48*x4 + 1.12), 3)))*(0.31*powi(cos(0.99*x3 - 0.58*x2 + 0.34), 3)), ((1.33 - 0.23*powi(cos(0.88*x2 + 0.48*x4 + 1.12), 3)))*(0.29*tan(0.84*sin(x3))/2), ((1.33 - 0.23*powi(cos(0.88*x2 + 0.48*x4 + 1.12), 3)))*(0.22*sin(p2*x1 - 0.31)), 0],
    [_, (0.31*powi(cos(0.99*x3 - 0.58*x2 + 0.34), 3))*(0.31*powi(cos(0.99*x3 - 0.58*x2 + 0.34), 3)) + ((1.27 + 0.28*exp(-powi(x2, 2)/2)))*((1.27 + 0.28*exp(-powi(x2, 2)/2))), (0.31*powi(cos(0.99*x3 - 0.58*x2 + 0.34), 3))*(0.29*tan(0.84*sin(x3))/2), (0.31*powi(cos(0.99*x3 - 0.58*x2 + 0.34), 3))*(0.22*sin(p2*x1 - 0.31)) + ((1.27 + 0.28*exp(-powi(x2, 2)/2)))*(0.16*x4/(1 + powi(x4, 2))), 0],
    [_, _, (0.29*tan(0.84*sin(x3))/2)*(0.29*tan(0.84*sin(x3))/2) + (1.29)*(1.29), (0.29*tan(0.84*sin(x3))/2)*(0.22*sin(p2*x1 - 0.31)) + (1.29)*(0.30*powi(cos(0.46*x1), 3)), (1.29)*(0.24*sin(1.18*x2 + 0.50*x3 + 0.33))],
    [_, _, _, (0.22*sin(p2*x1 - 0.31))*(0.22*sin(p2*x1 - 0.31)) + (0.16*x4/(1 + powi(x4, 2)))*(0.16*x4/(1 + powi(x4, 2))) + (0.30*powi(cos(0.46*x1), 3))*(0.30*powi(cos(0.46*x1), 3)) + ((1.03 - 0.28*sin(0.78*x2 - 0.71*x2 - 1.43)))*((1.03 - 0.28*sin(0.78*x2 - 0.71*x2 - 1.43))), (0.30*powi(cos(0.46*x1), 3))*(0.24*sin(1.18*x2 + 0.50*x3 + 0.33))],
    [_, _, _, _, (0.24*sin(1.18*x2 + 0.50*x3 + 0.33))*(0.24*sin(1.18*x2 + 0.50*x3 + 0.33)) + ((1.07 + 0.10*cos(1.07*x5)))*((1.07 + 0.10*cos(1.07*x5)))],
))]
#[forces(
    p1*dot(x4)*dot(x5)*sin(0.98*x1) + dot(x5)*sqrt(2 + powi(dot(x5), 2)),
    1.92*powi(dot(x5), 2) + p1*exp(0.20*x1) + p2*1.80 + p1*dot(x4)*dot(x4)*powi(cos(1.09*x2 - 0.58*x4 - 1.37), 3),
    p2*1.75 + 1.00*dot(x3),
    dot(x4)*dot(x1)/1.16 - p1*dot(x1)*dot(x1)*cos(0.73*x4 - 0.61*x1) - p2*exp(0.20*x3) - p2*exp(0.20*x3),
    1.20*powi(dot(x4), 2) + 1.82*powi(dot(x4), 2),
)]
#[potential_energy(sin(p1*x2 + 1.00))]
#[configuration(x2 = 1.24*x5/(1 + powi(x5, 2)))]
#[output(place = x5/(1 + powi(x5, 2)), power = p1*exp(0.20*x4) - 1.30*dot(x5)/(1 + powi(x1, 2)), push = sin(0.95*x1 + 1.34)*ddot(x3) + dot(x4)*ddot(x4))]
pub struct Random186 {
    #[nominal(1.21)]
    pub p1: f64,
    #[nominal(1.01)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1) - 0.29*sin(p1*x1 - 0.36)*dot(x4) - 0.49*powi(cos(0.99*x1), 3),
    v2 = 1.28*dot(x2) - 0.36*sin(p1*x4 + 0.75),
    v3 = (1.38 + 0.34*sin(0.50*x1 + 0.75*x2 + 1.28))*dot(x3) + 0.29*1/sqrt(1.50 + powi(x3, 2))*dot(x2) - 0.20*cos(0.66*x3 + 0.38*x2 + 0.25),
    v4 = (1.08 + 0.28*cos(0.50*x4 - 0.46*x1))*dot(x4) + 0.29*sin(p1*x2 + 0.54)*dot(x3) + 0.44*exp(-powi(x2, 2)/2),
)]
#[define(l11 = (1.13 - 0.33*cos(0.45*x1)), l21 = 0.15*sin(0.77*x4), l22 = (1.24 - 0.21*x3/(1 + powi(x3, 2))), l31 = 0.12*tan(0.56*sin(x1))/2, l33 = (1.11 + 0.21*ln(1.60 + 0.45*cos(x4))), l43 = 0.11*cos(0.42*x3 - 0.42*x3), l44 = (1.03 + 0.31*sin(p1*x1 + 0.49)))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, 0],
    [_, l21*l21 + l22*l22, l21*l31, 0],
    [_, _, l31*l31 + l33*l33, l33*l43],
    [_, _, _, l43*l43 + l44*l44],
))]
#[forces(
    0.73*v2 + p1*exp(0.20*x1),
    p1*v1*v2*ln(1.60 + 0.94*cos(x3)),
    p1*exp(0.20*x2) + v1*sqrt(2 + powi(v3, 2)) + 1.51*v3 + p1*v4*v4*exp(-powi(x4, 2)/2),
    p1*x1 + 1.94*atan2(x4, 2 + cos(x2))/2 + v3*sqrt(2 + powi(v4, 2)),
)]
#[configuration(of(q1, q2), x2 = 1.25*q1, x4 = 1.25*q2, x1 = sin(p1*q2 - 0.74), x3 = sin(0.41*q1 - 0.68*q1)*cos(1.12*q1 - 0.43*q2))]
#[constraint(held_x1: x1 - (sin(p1*(x4/1.25) - 0.74)) == 0)]
#[constraint(held_x3: x3 - (sin(0.41*(x2/1.25) - 0.68*(x2/1.25))*cos(1.12*(x2/1.25) - 0.43*(x4/1.25))) == 0)]
pub struct Random187 {
    #[nominal(0.61)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[inertia(diag((1.01 - 0.18*ln(1.60 + 0.99*cos(x3))), (1.12 - 0.35*sin(0.92*x1)), (1.14 + 0.23*sin(0.53*x1 + 0.65*x1)), (1.36 - 0.30*1/sqrt(1.50 + powi(x4, 2)))))]
#[forces(
    p2*x3 - dot(x4)*dot(x3)/(1.15 - 0.18*atan2(x2, 2 + cos(x3))/2),
    0.57*dot(x3)/(1 + powi(x1, 2)) - 1.69*exp(-powi(x1, 2)/2) - dot(x1)*sqrt(2 + powi(dot(x1), 2)) - p2*exp(0.20*x4),
    1.39*ln(1.60 + 0.89*cos(x3)) + dot(x1)*sqrt(2 + powi(dot(x3), 2)) + p2*exp(0.20*x4) + 1.67*powi(dot(x2), 2),
    dot(x4)*dot(x1)/(1.18 + 0.29*sin(1.06*x2 + 0.68*x2)) - p2*x2,
)]
#[potential_energy(x1/(1 + powi(x1, 2)))]
#[configuration(x3 = 1.08*powi(cos(1.13*x2 + 0.89*x1 + 1.38), 3), x4 = 0.82*x1/(1 + powi(x1, 2)))]
#[constraint(rolling: 1.32*dot(x1) + 0.34*cos(0.67*x1 + 0.26*x1)*dot(x2) == 0)]
pub struct Random188 {
    #[nominal(0.57)]
    pub p1: f64,
    #[nominal(1.43)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[inertia(matrix(
    [((1.06 - 0.18*sin(p2*x3 + 0.29)))*((1.06 - 0.18*sin(p2*x3 + 0.29))), ((1.06 - 0.18*sin(p2*x3 + 0.29)))*(0.15*powi(cos(0.74*x3 - 0.49*x5 - 1.16), 3)), ((1.06 - 0.18*sin(p2*x3 + 0.29)))*(0.37*1/sqrt(1.50 + powi(x5, 2))), ((1.06 - 0.18*sin(p2*x3 + 0.29)))*(0.33*sin(1.02*x3)), ((1.06 - 0.18*sin(p2*x3 + 0.29)))*(0.23*1/sqrt(1.50 + powi(x1, 2)))],
    [_, (0.15*powi(cos(0.74*x3 - 0.49*x5 - 1.16), 3))*(0.15*powi(cos(0.74*x3 - 0.49*x5 - 1.16), 3)) + ((1.09 - 0.17*atan2(x5, 2 + cos(x5))/2))*((1.09 - 0.17*atan2(x5, 2 + cos(x5))/2)), (0.15*powi(cos(0.74*x3 - 0.49*x5 - 1.16), 3))*(0.37*1/sqrt(1.50 + powi(x5, 2))) + ((1.09 - 0.17*atan2(x5, 2 + cos(x5))/2))*(0.15*0.41*sin(x1)/(1.50 + cos(x4))), (0.15*powi(cos(0.74*x3 - 0.49*x5 - 1.16), 3))*(0.33*sin(1.02*x3)) + ((1.09 - 0.17*atan2(x5, 2 + cos(x5))/2))*(0.14*exp(-powi(x1, 2)/2)), (0.15*powi(cos(0.74*x3 - 0.49*x5 - 1.16), 3))*(0.23*1/sqrt(1.50 + powi(x1, 2)))],
    [_, _, (0.37*1/sqrt(1.50 + powi(x5, 2)))*(0.37*1/sqrt(1.50 + powi(x5, 2))) + (0.15*0.41*sin(x1)/(1.50 + cos(x4)))*(0.15*0.41*sin(x1)/(1.50 + cos(x4))) + (1.28)*(1.28), (0.37*1/sqrt(1.50 + powi(x5, 2)))*(0.33*sin(1.02*x3)) + (0.15*0.41*sin(x1)/(1.50 + cos(x4)))*(0.14*exp(-powi(x1, 2)/2)) + (1.28)*(0.35*ln(1.60 + 0.88*cos(x1))), (0.37*1/sqrt(1.50 + powi(x5, 2)))*(0.23*1/sqrt(1.50 + powi(x1, 2))) + (1.28)*(0.13*sin(1.03*x2 + 0.82*x1 + 1.17))],
    [_, _, _, (0.33*sin(1.02*x3))*(0.33*sin(1.02*x3)) + (0.14*exp(-powi(x1, 2)/2))*(0.14*exp(-powi(x1, 2)/2)) + (0.35*ln(1.60 + 0.88*cos(x1)))*(0.35*ln(1.60 + 0.88*cos(x1))) + ((1.06 - 0.33*sin(0.68*x3 + 0.36*x2)))*((1.06 - 0.33*sin(0.68*x3 + 0.36*x2))), (0.33*sin(1.02*x3))*(0.23*1/sqrt(1.50 + powi(x1, 2))) + (0.35*ln(1.60 + 0.88*cos(x1)))*(0.13*sin(1.03*x2 + 0.82*x1 + 1.17)) + ((1.06 - 0.33*sin(0.68*x3 + 0.36*x2)))*(0.39*0.68*sin(x4)/(1.50 + cos(x2)))],
    [_, _, _, _, (0.23*1/sqrt(1.50 + powi(x1, 2)))*(0.23*1/sqrt(1.50 + powi(x1, 2))) + (0.13*sin(1.03*x2 + 0.82*x1 + 1.17))*(0.13*sin(1.03*x2 + 0.82*x1 + 1.17)) + (0.39*0.68*sin(x4)/(1.50 + cos(x2)))*(0.39*0.68*sin(x4)/(1.50 + cos(x2))) + ((1.31 - 0.21*sin(p1*x5 - 0.15)))*((1.31 - 0.21*sin(p1*x5 - 0.15)))],
))]
#[forces(
    dot(x2)*dot(x4)/(1.34 - 0.27*sin(0.91*x1 - 0.67)) - p1*dot(x4)*dot(x1)*cos(1.18*x1) - p3*exp(0.20*x2),
    0.94*dot(x4),
    dot(x1)*sqrt(2 + powi(dot(x3), 2)) - p1*x2,
    p3*exp(0.20*x1) - dot(x3)*dot(x1)/(1.11 + 0.16*sin(1.14*x1)*cos(0.93*x2 - 0.41*x5)) - 0.86*dot(x5) - 1.86*powi(dot(x2), 2),
    dot(x3)*dot(x4)/(1.20 - 0.25*sin(p3*x1 - 0.37)) - 1.61*powi(dot(x4), 2) - p3*x5,
)]
#[potential_energy(sin(p3*x3 + 0.69))]
#[constraint(row1: dot(x2) + 0*dot(x5) + 0*dot(x3) + 0*dot(x1) + 0.78*ln(1.60 + 0.81*cos(x1))*dot(x4) + 0.40*exp(-powi(x4, 2)/2) == 0)]
#[complement(
    w1 = [0, -1.17*(0), 0, 0, 1.17],
    w2 = [0, -1.06*(0), 1.06, 0, 0],
    w3 = [1.20, -1.20*(0), 0, 0, 0],
    w4 = [0, -1.08*(0.78*ln(1.60 + 0.81*cos(x1))), 0, 1.08, 0],
)]
#[output(place = sin(1.16*x5 + 0.55), power = dot(x3)*dot(x5)/1.20 - p3*x1 - 1.25*dot(x5) - 0.38*sin(0.88*x3), push = sin(1.14*x2 - 1.20)*ddot(x3) + dot(x3)*ddot(x3), pull = (1.04 + 0.27*sin(0.79*x2))*reaction(row1) - push, share = pull/(1.67 + powi(reaction(row1), 2)))]
pub struct Random189 {
    #[nominal(1.35)]
    pub p1: f64,
    #[nominal(1.37)]
    pub p2: f64,
    #[nominal(1.21)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[inputs(tau)]
#[inertia(diag(1.26, 1.03, (1.21 - 0.25*ln(1.60 + 0.90*cos(x3))), (1.01 + 0.14*cos(1.08*x1)), (1.19 + 0.23*cos(0.62*x4 + 0.81))))]
#[forces(
    p2*x1 - dot(x4)*dot(x3)/(1.36 + 0.32*sin(0.72*x1 - 0.44*x3)) - dot(x1)*sqrt(2 + powi(dot(x3), 2)) - dot(x2)*sqrt(2 + powi(dot(x4), 2)),
    1.84*powi(dot(x2), 2) + 1.97*powi(dot(x5), 2) + 1.03*cos(0.41*x1) + 0.46*dot(x2)/(1 + powi(x5, 2)),
    dot(x2)*dot(x1)/(1.31 - 0.17*sin(0.82*x5 - 0.65*x4 - 0.16)*cos(0.58*x5 - 0.95)),
    tau*1.31 + dot(x1)*dot(x4)/1.23 + tau*0.67,
    1.48*cos(1.13*x4 - 0.38),
)]
#[potential_energy(ln(1.60 + 0.87*cos(x3)))]
#[constraint(row1: 1.85*x1 + 0.21*x4*x4 + 0.51 == 0)]
#[constraint(row2: 1.29*x3 + exp(0.17*x4)/2 + 0.12*sin(x1) - 0.19 == 0)]
#[constraint(row3: 1.61*x2 + 0.19*sin(x2) + 0.37*x4*x4 + 0.24*x1 + exp(0.13*x3)/2 - 0.15 == 0)]
#[constraint(row4: 1.66*x5 + 0.13*x4 + 0.68 == 0)]
#[independent(dot(x4))]
pub struct Random190 {
    #[nominal(1.00)]
    pub p1: f64,
    #[nominal(1.16)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + sin(0.95*x2 - 0.79*x3)*cos(0.92*x4 - 0.67*x4 + 0.99)*dot(x1),
    v3 = dot(x3) + cos(1.12*x3 + 0.39*x2 + 1.13)*dot(x1),
    v4 = dot(x4) + powi(cos(0.41*x1 + 0.88*x4 - 1.28), 3)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - sin(0.95*x2 - 0.79*x3)*cos(0.92*x4 - 0.67*x4 + 0.99)*(v1),
    dot(x3) = v3 - cos(1.12*x3 + 0.39*x2 + 1.13)*(v1),
    dot(x4) = v4 - powi(cos(0.41*x1 + 0.88*x4 - 1.28), 3)*(v1),
)]
#[inertia(diag((1.37 + 0.12*x4/(1 + powi(x4, 2))), (1.28 + 0.33*sin(1.16*x3)*cos(0.56*x2 + 0.57*x4 - 0.12)), (1.01 + 0.35*tan(0.88*sin(x3))/2), (1.40 + 0.28*atan2(x2, 2 + cos(x3))/2)))]
#[forces(
    0.93*v4 + p3*x4,
    1.99*v3 + p2*1.73,
    v2*v2/(1.06 - 0.26*ln(1.60 + 0.44*cos(x2))) + 1.94*v4/(1 + powi(x3, 2)) + p1*v1*v1*0.66*sin(x2)/(1.50 + cos(x3)),
    p3*x3 + p1*v1*v3*x1/(1 + powi(x1, 2)) + 1.64*v2,
)]
#[constraint(row1: 1.32*x4 + 0.26*sin(x4) - 0.78 == 0)]
#[constraint(row2: 1.66*x2 + 0.26*sin(x2) + exp(0.15*x4)/2 + 0.30 == 0)]
#[constraint(row3: 1.22*x3 + 0.29*sin(x3) + 0.40*x4*x4 - 0.22 == 0)]
#[constraint(row4: 1.53*v1 - 0.19*atan2(x2, 2 + cos(x4))/2*v4 == 0)]
pub struct Random191 {
    #[nominal(1.20)]
    pub p1: f64,
    #[nominal(0.78)]
    pub p2: f64,
    #[nominal(0.61)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1) - 0.15*ln(1.60 + 0.32*cos(x1))*dot(x2) - 0.55*0.85*sin(x1)/(1.50 + cos(x4)),
    v2 = (1.08 - 0.27*exp(-powi(x1, 2)/2))*dot(x2) - 0.33*sin(0.48*x3),
    v3 = 1.12*dot(x3) + 0.15*exp(-powi(x4, 2)/2),
    v4 = (1.30 + 0.16*x3/(1 + powi(x3, 2)))*dot(x4) - 0.24*sin(0.42*x2 - 0.31*x1 - 0.37)*cos(0.88*x3)*dot(x2) + 0.43*sin(1.09*x2 + 0.22*x3),
)]
#[define(l11 = (1.26 - 0.17*ln(1.60 + 0.87*cos(x1))), l22 = 1.09, l31 = 0.17*1/sqrt(1.50 + powi(x3, 2)), l32 = 0.32*1/sqrt(1.50 + powi(x1, 2)), l33 = 1.15, l41 = 0.13*sin(0.48*x2 + 0.22*x4)*cos(0.55*x3 - 0.74*x1 + 0.53), l42 = 0.10*exp(-powi(x4, 2)/2), l43 = 0.30*0.81*sin(x1)/(1.50 + cos(x3)), l44 = (1.04 - 0.15*sin(p1*x3 + 0.96)))]
#[inertia(matrix(
    [l11*l11, 0, l11*l31, l11*l41],
    [_, l22*l22, l22*l32, l22*l42],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l32*l42 + l33*l43],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44],
))]
#[forces(
    0,
    0,
    1.56*v1/(1 + powi(x3, 2)),
    1.43*powi(v3, 2),
)]
#[constraint(row1: powi(v4, 2) - 0.16*powi(v1, 2) - (2 - 0.16*0.35*sin(x4)/(1.50 + cos(x1))) == 0)]
#[independent(v2, v3, v1, v4)]
pub struct Random192 {
    #[nominal(0.55)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = dot(x1) + 0.39*sin(0.90*x1 - 0.66*x5 + 0.11)*dot(x3) + 0.31*sin(p1*x2 - 0.24),
    v2 = dot(x2) + 0.30*sin(0.47*x4)*dot(x4) - 0.56*1/sqrt(1.50 + powi(x1, 2)),
    v3 = (1.18 - 0.14*x4/(1 + powi(x4, 2)))*dot(x3) + 0.34*sin(0.92*x3 + 0.64*x2)*dot(x5) + 0.18*x2/(1 + powi(x2, 2)),
    v4 = (1.16 + 0.30*sin(0.81*x5))*dot(x4) - 0.45*cos(0.73*x5 - 0.79*x1 + 1.34),
    v5 = (1.13 - 0.32*0.74*sin(t)/(1.50 + cos(x1)))*dot(x5) - 0.22*sin(1.01*x3 + 0.28*t - 0.30)*cos(1.10*t)*dot(x4) + 0.44*sin(1.05*x4 - 0.34*x3 + 1.07),
)]
#[inertia(diag(1.28, 1.19, 1.19, (1.11 + 0.17*cos(0.59*x5 - 0.65*t + 1.10)), 1.37))]
#[forces(
    0.35*v5/(1 + powi(x1, 2)),
    p1*x5,
    p1*v1*v1*cos(0.43*x5 + 0.35*x5) + v1*v1/(1.03 + 0.31*cos(0.96*x1)) + 0.53*powi(v5, 2) + 1.64*cos(0.49*x1 - 0.35),
    0,
    0,
)]
#[constraint(row1: dot(v3) + 0.20*powi(cos(1.10*x1 + 0.26*x3), 3)*dot(v4) + 0.30*x1/(1 + powi(x1, 2))*dot(v2) + 0.29*v2*v1*ln(1.60 + 0.64*cos(x5)) == 0)]
#[constraint(row2: dot(v5) - 0.23*powi(cos(0.57*x3 + 0.91), 3)*dot(v4) + 0.17*x5/(1 + powi(x5, 2))*dot(v2) - 0.54*v4/sqrt(1.20 + powi(v1, 2)) == 0)]
#[independent(v1, v2, v4, v5, v3)]
#[independent(s1 = v1 - 0.27*sin(1.10*x1 - 0.37*x1), s2 = (1.50 + 0.29*x5/(1 + powi(x5, 2)))*v2 - 0.17*exp(-powi(t, 2)/2)*v1, s3 = (1.50 - 0.19*cos(1.15*x5))*v4 - 0.11*sin(p3*x5 + 0.64)*v1 - 0.28*cos(0.98*x1 + 0.71*x5)*v2, v5, s5 = v3 - 0.11*powi(cos(0.83*x1 - 0.46*x3), 3)*v1)]
#[output(place = x2/(1 + powi(x2, 2)), power = p2*x2 - v3*sqrt(2 + powi(v4, 2)) - 1.92*powi(v2, 2) - v5*sqrt(2 + powi(v4, 2)), push = sin(0.82*x2 + 0.82*x1)*cos(0.69*x2)*dot(v1) + v1*ddot(x1), pull = (1.12 - 0.27*x1/(1 + powi(x1, 2)))*reaction(row2) - push, share = pull/(1.54 + powi(reaction(row2), 2)))]
pub struct Random193 {
    #[nominal(1.09)]
    pub p1: f64,
    #[nominal(1.09)]
    pub p2: f64,
    #[nominal(1.46)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    dot(x1) = v1 - 0.32*cos(1.02*t - 0.29*x2),
    dot(x2) = (1.07 - 0.28*0.65*sin(x1)/(1.50 + cos(x1)))*v2 + 0.33*cos(0.64*t)*v1 - 0.58*1/sqrt(1.50 + powi(x2, 2)),
    dot(x3) = v3 - 0.28*x2/(1 + powi(x2, 2))*v2 - 0.19*cos(0.46*x2 + 0.18),
    dot(x4) = 1.00*v4 - 0.51*exp(-powi(x3, 2)/2),
)]
#[define(l11 = 1.08, l21 = 0.15*cos(0.62*t), l22 = 1.34, l32 = 0.30*powi(cos(0.61*x3 + 0.49*x2), 3), l33 = (1.03 - 0.13*atan2(x4, 2 + cos(x1))/2), l41 = 0.17*powi(cos(0.93*x4 - 0.59), 3), l43 = 0.32*tan(0.79*sin(x3))/2, l44 = 1.01)]
#[inertia(matrix(
    [l11*l11, l11*l21, 0, l11*l41],
    [_, l21*l21 + l22*l22, l22*l32, l21*l41],
    [_, _, l32*l32 + l33*l33, l33*l43],
    [_, _, _, l41*l41 + l43*l43 + l44*l44],
))]
#[forces(
    p3*x1 - 1.30*powi(v1, 2) - v3*v1/(1.17 + 0.23*ln(1.60 + 0.46*cos(t))),
    0.35*powi(v2, 2) + p1*exp(0.20*x1),
    v4*sqrt(2 + powi(v3, 2)),
    p1*x2 - 1.33*v2/(1 + powi(x4, 2)) - 1.15*powi(v1, 2) - p2*1.62,
)]
#[potential_energy(powi(cos(1.15*x2 + 0.84*x3), 3))]
#[constraint(row1: 1.83*x4 + 0.38*x2 + 0.27*sin(x3) + 0.30*sin(0.96*t) + 0.35 == 0)]
#[constraint(row2: powi(v1, 2) + 0.16*powi(v4, 2) - (2 + 0.16*atan2(x4, 2 + cos(x3))/2) == 0)]
#[independent(s1 = 1.03*v3 - 0.33*exp(-powi(x1, 2)/2)*v4, s2 = (1.50 + 0.26*cos(0.87*t))*v2 + 0.33*sin(p3*x1 + 0.98)*v3, s3 = v1 + 0.18*cos(1.19*x2 - 0.21*x3)*v3 + 0.22*1/sqrt(1.50 + powi(x1, 2))*v2)]
pub struct Random194 {
    #[nominal(1.07)]
    pub p1: f64,
    #[nominal(1.07)]
    pub p2: f64,
    #[nominal(0.81)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + atan2(x2, 2 + cos(x1))/2*dot(x1),
    v3 = dot(x3) + sin(0.61*x3 + 1.09)*dot(x1),
    v4 = dot(x4) + powi(cos(0.61*x4 - 0.68*x3), 3)*dot(x3),
    dot(x1) = v1,
    dot(x2) = v2 - atan2(x2, 2 + cos(x1))/2*(v1),
    dot(x3) = v3 - sin(0.61*x3 + 1.09)*(v1),
    dot(x4) = v4 - powi(cos(0.61*x4 - 0.68*x3), 3)*(v3 - sin(0.61*x3 + 1.09)*(v1)),
)]
#[inertia(diag(1.06, (1.18 - 0.20*0.75*sin(x4)/(1.50 + cos(x1))), (1.15 + 0.24*ln(1.60 + 0.60*cos(x3))), (1.29 - 0.33*ln(1.60 + 0.61*cos(x2)))))]
#[forces(
    p2*exp(0.20*x3) - v3*v2/1.04 - v2*v1/1.11 - 1.02*v2/(1 + powi(x1, 2)),
    1.23*powi(v1, 2),
    p2*1.40 + p2*x1 + 0.89*v3,
    0.52*v2 + 1.19*ln(1.60 + 0.68*cos(x2)),
)]
#[potential_energy(sin(0.54*x3 + 0.31)*cos(0.56*x1 + 0.89*x2))]
#[constraint(row1: 1.43*x3 + exp(0.35*x2)/2 + 0.32*powi(x4, 2)/2 + 0.17 == 0)]
#[constraint(row2: (1.50 + 0.20*tan(0.54*sin(x1))/2)*dot(v1) - 0.21*atan2(x3, 2 + cos(x3))/2*dot(v2) - 0.19*atan2(x4, 2 + cos(x1))/2*dot(v4) - 0.34*v2 - 0.34*sin(0.45*x1 + 0.32*x4) == 0)]
#[independent(s1 = (1.50 + 0.25*0.39*sin(x1)/(1.50 + cos(x1)))*v4 + 0.35*atan2(x3, 2 + cos(x4))/2*v3 + 0.27*atan2(x4, 2 + cos(x2))/2, s2 = 1.45*v2 + 0.13*sin(0.49*x3)*v4, v1)]
pub struct Random195 {
    #[nominal(0.53)]
    pub p1: f64,
    #[nominal(1.01)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[inertia(diag((1.08 - 0.33*sin(p2*x1 + 0.14)), (1.14 - 0.22*atan2(x2, 2 + cos(x3))/2), (1.05 + 0.19*ln(1.60 + 0.78*cos(x4))), 1.07, 1.02))]
#[forces(
    0.63*dot(x2) + p2*0.68 + p3*0.40 + dot(x5)*sqrt(2 + powi(dot(x5), 2)),
    p3*1.93 - 0.84*powi(dot(x4), 2) - dot(x4)*sqrt(2 + powi(dot(x4), 2)) - dot(x1)*sqrt(2 + powi(dot(x5), 2)),
    1.39*powi(dot(x1), 2) + 1.05*dot(x5),
    p2*0.38,
    dot(x3)*dot(x5)/(1.04 - 0.15*x3/(1 + powi(x3, 2))) - p1*dot(x2)*dot(x2)*sin(0.70*x1 - 0.22*x5)*cos(1.08*x5 + 0.53*x3) - dot(x5)*dot(x5)/1.36 - 1.26*powi(dot(x4), 2),
)]
#[potential_energy(exp(-powi(x3, 2)/2))]
#[constraint(row1: 1.55*x3 + 0.16*sin(x1) + 0.53 == 0)]
#[constraint(row2: (1.50 - 0.27*1/sqrt(1.50 + powi(x4, 2)))*dot(x2) - 0.33*ln(1.60 + 0.57*cos(x2))*dot(x1) + 0.33*0.44*sin(x5)/(1.50 + cos(x4))*dot(x3) == 0)]
#[constraint(row3: 1.44*dot(x4) - 0.14*atan2(x1, 2 + cos(x3))/2*dot(x2)*dot(x3) - 0.42*tan(0.76*sin(x3))/2 == 0)]
#[constraint(row4: ddot(x5) - 0.13*sin(0.51*x4 - 1.41)*cos(1.10*x2 - 0.32*x5)*ddot(x1) + 0.12*tan(0.35*sin(x1))/2*ddot(x3) + 0.57*dot(x5) + 0.57*sin(0.70*x3 + 0.54*x3) == 0)]
#[output(place = exp(-powi(x2, 2)/2), power = dot(x3)*dot(x2)/1.01 + dot(x2)*dot(x4)/1.08, push = 0.52*sin(x2)/(1.50 + cos(x2))*ddot(x5) + dot(x5)*ddot(x5), pull = (1.09 - 0.23*1/sqrt(1.50 + powi(x3, 2)))*reaction(row1) - push, share = pull/(1.16 + powi(reaction(row1), 2)))]
pub struct Random196 {
    #[nominal(1.06)]
    pub p1: f64,
    #[nominal(0.84)]
    pub p2: f64,
    #[nominal(0.61)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[define(l11 = 1.13, l22 = (1.18 + 0.14*cos(0.81*x2 + 0.53*x2 - 1.24)), l32 = 0.23*sin(p2*x3 + 0.49), l33 = (1.24 + 0.19*tan(0.56*sin(x4))/2), l41 = 0.32*sin(0.42*x4 + 0.51*x1 + 0.19)*cos(0.87*x2 - 0.27*x1), l43 = 0.19*sin(0.56*x4)*cos(0.97*x1 + 0.38*x3), l44 = 1.27)]
#[inertia(matrix(
    [l11*l11, 0, 0, l11*l41],
    [_, l22*l22, l22*l32, 0],
    [_, _, l32*l32 + l33*l33, l33*l43],
    [_, _, _, l41*l41 + l43*l43 + l44*l44],
))]
#[forces(
    1.28*powi(dot(x3), 2) - p2*x4,
    0,
    p2*dot(x1)*dot(x4)*exp(-powi(x4, 2)/2),
    p2*0.38 - p1*exp(0.20*x2) - p2*0.88 - p3*dot(x3)*dot(x2)*0.31*sin(x2)/(1.50 + cos(x1)),
)]
#[potential_energy(powi(cos(0.52*x1 - 0.31*x1), 3))]
#[constraint(row1: 1.54*dot(x1) + 0.31*exp(-powi(x1, 2)/2)*dot(x4) + 0.19*cos(0.41*x1)*dot(x3) - 0.32*sin(p2*x1 - 0.54)*dot(x2) == 0)]
#[constraint(again1: (1.25 - 0.34*sin(0.81*x4 - 0.37*x3 - 0.84))*(1.54*dot(x1) + 0.31*exp(-powi(x1, 2)/2)*dot(x4) + 0.19*cos(0.41*x1)*dot(x3) - 0.32*sin(p2*x1 - 0.54)*dot(x2)) == 0, redundant)]
pub struct Random197 {
    #[nominal(0.93)]
    pub p1: f64,
    #[nominal(1.13)]
    pub p2: f64,
    #[nominal(0.56)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = 1.35*dot(x1) - 0.34*powi(cos(0.77*x3 + 0.60), 3),
    v2 = (1.00 - 0.25*1/sqrt(1.50 + powi(x2, 2)))*dot(x2) - 0.53*powi(cos(1.00*x5 + 0.85*x5 + 0.22), 3),
    v3 = (1.25 + 0.14*0.52*sin(x1)/(1.50 + cos(x1)))*dot(x3) + 0.26*sin(0.91*x3 - 0.83)*cos(0.63*x3 + 0.53*x2)*dot(x5) + 0.16*0.63*sin(x2)/(1.50 + cos(t)),
    v4 = 1.03*dot(x4) + 0.30*sin(p2*x3 + 0.73)*dot(x1) - 0.10*sin(p2*x5 - 0.66),
    v5 = 1.19*dot(x5) + 0.14*sin(0.91*x2),
)]
#[inertia(diag((1.22 - 0.16*sin(0.59*x5 - 0.68)), (1.06 - 0.10*powi(cos(0.52*x4), 3)), 1.29, (1.16 + 0.27*0.58*sin(x4)/(1.50 + cos(x2))), 1.11))]
#[forces(
    p2*exp(0.20*x1) - 0.44*powi(v5, 2),
    p1*exp(0.20*x2),
    0,
    v1*v5/1.28,
    0.71*powi(v3, 2) - p1*exp(0.20*t),
)]
#[potential_energy(sin(p2*x2 - 0.50))]
#[constraint(row1: (1.50 - 0.29*sin(0.49*x1 - 0.73*x2)*cos(0.80*x1))*v5 + 0.17*sin(0.42*x3 - 0.23*x5 - 0.11)*v2 == 0)]
#[constraint(row2: (1.50 + 0.27*cos(0.64*x2 - 0.67))*v1 + 0.17*0.40*sin(x5)/(1.50 + cos(x2))*v2 + 0.13*cos(1.06*t - 0.45*x2)*v5 == 0)]
#[constraint(row3: (1.50 + 0.12*ln(1.60 + 0.79*cos(x1)))*v4 + 0.13*cos(0.47*x2)*v2 + 0.16*sin(1.13*x2 + 1.16)*cos(0.60*t)*v5 == 0)]
#[constraint(row4: (1.50 - 0.27*1/sqrt(1.50 + powi(x3, 2)))*v3 + 0.25*sin(0.91*x3 - 0.30*x2)*v2 - 0.22*1/sqrt(1.50 + powi(x2, 2))*v5 + 0.29*x2/(1 + powi(x2, 2))*v1 - 0.49*sin(1.09*x3 - 0.72*x3)*cos(1.01*x1) == 0)]
#[independent(v2)]
pub struct Random198 {
    #[nominal(0.68)]
    pub p1: f64,
    #[nominal(0.93)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[define(l11 = (1.35 + 0.34*cos(0.66*x5 - 0.39)), l22 = 1.19, l32 = 0.18*1/sqrt(1.50 + powi(x1, 2)), l33 = (1.22 - 0.25*0.62*sin(x4)/(1.50 + cos(x3))), l41 = 0.39*cos(0.46*x3 + 0.75*x2 + 0.91), l44 = (1.21 + 0.35*ln(1.60 + 0.96*cos(x1))), l52 = 0.14*cos(0.67*x3 + 0.33*x5), l54 = 0.34*sin(p1*x1 + 0.40), l55 = 1.01)]
#[inertia(matrix(
    [l11*l11, 0, 0, l11*l41, 0],
    [_, l22*l22, l22*l32, 0, l22*l52],
    [_, _, l32*l32 + l33*l33, 0, l32*l52],
    [_, _, _, l41*l41 + l44*l44, l44*l54],
    [_, _, _, _, l52*l52 + l54*l54 + l55*l55],
))]
#[forces(
    p1*exp(0.20*x4) - 0.52*dot(x4) - dot(x3)*dot(x3)/1.14,
    p1*exp(0.20*x1),
    dot(x3)*dot(x2)/1.32 - dot(x2)*sqrt(2 + powi(dot(x4), 2)),
    1.48*exp(-powi(x4, 2)/2) - 1.64*atan2(x1, 2 + cos(x5))/2 - dot(x5)*sqrt(2 + powi(dot(x4), 2)) - 1.22*dot(x1)/(1 + powi(x5, 2)),
    1.50*dot(x4),
)]
#[output(place = cos(0.92*x5), power = 1.78*powi(cos(0.58*x4 - 0.67*x1), 3), push = sin(1.17*x2 + 0.39)*ddot(x5) + dot(x2)*ddot(x2))]
pub struct Random200 {
    #[nominal(1.39)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + cos(0.43*x1 + 0.42*x3)*dot(x1),
    v3 = dot(x3) + powi(cos(0.84*x1 - 0.35*x4 - 0.85), 3)*dot(x2),
    v4 = dot(x4) + tan(0.54*sin(x3))/2*dot(x2),
    v5 = dot(x5) + tan(0.73*sin(x5))/2*dot(x2),
    v6 = dot(x6) + tan(0.31*sin(x3))/2*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - cos(0.43*x1 + 0.42*x3)*(v1),
    dot(x3) = v3 - powi(cos(0.84*x1 - 0.35*x4 - 0.85), 3)*(v2 - cos(0.43*x1 + 0.42*x3)*(v1)),
    dot(x4) = v4 - tan(0.54*sin(x3))/2*(v2 - cos(0.43*x1 + 0.42*x3)*(v1)),
    dot(x5) = v5 - tan(0.73*sin(x5))/2*(v2 - cos(0.43*x1 + 0.42*x3)*(v1)),
    dot(x6) = v6 - tan(0.31*sin(x3))/2*(v1),
)]
#[inertia(diag(1.33, 1.02, 1.06, (1.01 + 0.32*tan(0.61*sin(x1))/2), (1.32 - 0.12*cos(0.44*x6)), (1.04 + 0.28*sin(p2*x6 + 0.61))))]
#[forces(
    0,
    0.97*cos(0.96*x4 - 0.33*x1) - tau*0.91 - p1*exp(0.20*x5) - p2*x6,
    v4*v5/1.04 - p3*x2 - 0.31*0.79*sin(x4)/(1.50 + cos(x5)),
    1.54*v1 - p2*x6,
    v2*sqrt(2 + powi(v5, 2)) - p1*x3,
    0.97*v3 - p2*x6 - v6*v5/(1.15 + 0.11*tan(0.37*sin(x3))/2),
)]
#[constraint(row1: 1.63*x3 + 0.30*x5 + 0.36*x6 - 0.44 == 0)]
#[constraint(row2: 1.21*x4 + 0.19*sin(x4) + 0.12*powi(x5, 2)/2 + 0.36*sin(x6) + 0.15 == 0)]
#[constraint(row3: 1.27*x1 + exp(0.25*x5)/2 + 0.37*sin(x6) + 0.19 == 0)]
#[independent(v2, v6, v5)]
#[output(place = atan2(x1, 2 + cos(x3))/2, power = 0.36*v2, push = 0.44*sin(x1)/(1.50 + cos(x3))*dot(v3) + v2*ddot(x2), pull = (1.28 + 0.31*0.63*sin(x2)/(1.50 + cos(x5)))*reaction(row1) - push, share = pull/(1.28 + powi(reaction(row1), 2)))]
pub struct Random202 {
    #[nominal(1.11)]
    pub p1: f64,
    #[nominal(0.64)]
    pub p2: f64,
    #[nominal(1.41)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inputs(tau)]
#[inertia(matrix(
    [((1.11 - 0.31*1/sqrt(1.50 + powi(x3, 2))))*((1.11 - 0.31*1/sqrt(1.50 + powi(x3, 2)))), ((1.11 - 0.31*1/sqrt(1.50 + powi(x3, 2))))*(0.14*cos(0.85*x1 + 0.41)), ((1.11 - 0.31*1/sqrt(1.50 + powi(x3, 2))))*(0.23*0.87*sin(x5)/(1.50 + cos(x3))), ((1.11 - 0.31*1/sqrt(1.50 + powi(x3, 2))))*(0.31*0.54*sin(x2)/(1.50 + cos(x1))), ((1.11 - 0.31*1/sqrt(1.50 + powi(x3, 2))))*(0.23*sin(0.73*x6 - 0.36*x5)*cos(0.61*x4 + 0.56*x4 + 0.49)), 0],
    [_, (0.14*cos(0.85*x1 + 0.41))*(0.14*cos(0.85*x1 + 0.41)) + (1.30)*(1.30), (0.14*cos(0.85*x1 + 0.41))*(0.23*0.87*sin(x5)/(1.50 + cos(x3))) + (1.30)*(0.34*cos(0.79*x2 - 0.84*x6)), (0.14*cos(0.85*x1 + 0.41))*(0.31*0.54*sin(x2)/(1.50 + cos(x1))) + (1.30)*(0.30*sin(0.44*x3)), (0.14*cos(0.85*x1 + 0.41))*(0.23*sin(0.73*x6 - 0.36*x5)*cos(0.61*x4 + 0.56*x4 + 0.49)), (1.30)*(0.13*ln(1.60 + 0.76*cos(x4)))],
    [_, _, (0.23*0.87*sin(x5)/(1.50 + cos(x3)))*(0.23*0.87*sin(x5)/(1.50 + cos(x3))) + (0.34*cos(0.79*x2 - 0.84*x6))*(0.34*cos(0.79*x2 - 0.84*x6)) + (1.16)*(1.16), (0.23*0.87*sin(x5)/(1.50 + cos(x3)))*(0.31*0.54*sin(x2)/(1.50 + cos(x1))) + (0.34*cos(0.79*x2 - 0.84*x6))*(0.30*sin(0.44*x3)) + (1.16)*(0.35*cos(1.13*x4 - 0.41*x2)), (0.23*0.87*sin(x5)/(1.50 + cos(x3)))*(0.23*sin(0.73*x6 - 0.36*x5)*cos(0.61*x4 + 0.56*x4 + 0.49)) + (1.16)*(0.13*tan(0.34*sin(x5))/2), (0.34*cos(0.79*x2 - 0.84*x6))*(0.13*ln(1.60 + 0.76*cos(x4)))],
    [_, _, _, (0.31*0.54*sin(x2)/(1.50 + cos(x1)))*(0.31*0.54*sin(x2)/(1.50 + cos(x1))) + (0.30*sin(0.44*x3))*(0.30*sin(0.44*x3)) + (0.35*cos(1.13*x4 - 0.41*x2))*(0.35*cos(1.13*x4 - 0.41*x2)) + (1.39)*(1.39), (0.31*0.54*sin(x2)/(1.50 + cos(x1)))*(0.23*sin(0.73*x6 - 0.36*x5)*cos(0.61*x4 + 0.56*x4 + 0.49)) + (0.35*cos(1.13*x4 - 0.41*x2))*(0.13*tan(0.34*sin(x5))/2) + (1.39)*(0.20*sin(p1*x1 + 0.26)), (0.30*sin(0.44*x3))*(0.13*ln(1.60 + 0.76*cos(x4))) + (1.39)*(0.28*ln(1.60 + 0.84*cos(x4)))],
    [_, _, _, _, (0.23*sin(0.73*x6 - 0.36*x5)*cos(0.61*x4 + 0.56*x4 + 0.49))*(0.23*sin(0.73*x6 - 0.36*x5)*cos(0.61*x4 + 0.56*x4 + 0.49)) + (0.13*tan(0.34*sin(x5))/2)*(0.13*tan(0.34*sin(x5))/2) + (0.20*sin(p1*x1 + 0.26))*(0.20*sin(p1*x1 + 0.26)) + (1.19)*(1.19), (0.20*sin(p1*x1 + 0.26))*(0.28*ln(1.60 + 0.84*cos(x4)))],
    [_, _, _, _, _, (0.13*ln(1.60 + 0.76*cos(x4)))*(0.13*ln(1.60 + 0.76*cos(x4))) + (0.28*ln(1.60 + 0.84*cos(x4)))*(0.28*ln(1.60 + 0.84*cos(x4))) + ((1.28 - 0.33*1/sqrt(1.50 + powi(x4, 2))))*((1.28 - 0.33*1/sqrt(1.50 + powi(x4, 2))))],
))]
#[forces(
    tau*0.48 - p1*dot(x1)*dot(x3)*atan2(x6, 2 + cos(x5))/2 - dot(x5)*sqrt(2 + powi(dot(x2), 2)),
    dot(x4)*dot(x5)/(1.10 + 0.14*exp(-powi(x6, 2)/2)) + p1*dot(x3)*dot(x2)*0.69*sin(x3)/(1.50 + cos(x5)) + dot(x2)*dot(x6)/(1.37 + 0.35*atan2(x6, 2 + cos(x1))/2) + p1*x1,
    p1*dot(x1)*dot(x1)*sin(p1*x4 + 0.66) - p1*dot(x4)*dot(x2)*sin(1.11*x1),
    dot(x1)*dot(x6)/1.12 - 1.82*dot(x6) - 1.50*dot(x6)/(1 + powi(x3, 2)) - 1.23*dot(x3)/(1 + powi(x2, 2)),
    0,
    tau*1.14,
)]
#[constraint(height: 1.48*x5 + 0.15*sin(x5) + 0.15*x6 + 0.25*powi(x3, 2)/2 + 0.53 == 0)]
#[constraint(first: 1.03*dot(x4) - 0.22*0.93*sin(x1)/(1.50 + cos(x3))*dot(x6) - 0.20*tan(0.60*sin(x6))/2*dot(x3) + 0.23*atan2(x6, 2 + cos(x6))/2*dot(x1) + 0.48*cos(0.43*x5 - 0.34*x4) == 0)]
#[constraint(second: 1.48*dot(x5) + 0.15*cos(x5)*dot(x5) + 0.15*dot(x6) + 0.25*x3*dot(x3) - 0.50*sin(1.19*x4 + 0.73*x6 + 0.66)*(1.03*dot(x4) - 0.22*0.93*sin(x1)/(1.50 + cos(x3))*dot(x6) - 0.20*tan(0.60*sin(x6))/2*dot(x3) + 0.23*atan2(x6, 2 + cos(x6))/2*dot(x1) + 0.48*cos(0.43*x5 - 0.34*x4)) == 0)]
#[output(place = atan2(x4, 2 + cos(x5))/2, power = dot(x1)*sqrt(2 + powi(dot(x2), 2)) + dot(x2)*dot(x2)/(1.25 + 0.29*1/sqrt(1.50 + powi(x5, 2))) + 1.30*dot(x4)/(1 + powi(x1, 2)), push = cos(0.73*x4 - 1.49)*ddot(x6) + dot(x6)*ddot(x6))]
pub struct Random205 {
    #[nominal(1.34)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[inertia(diag((1.11 + 0.27*sin(1.13*x4 - 0.58*x2)), (1.18 + 0.31*exp(-powi(t, 2)/2)), (1.21 - 0.12*1/sqrt(1.50 + powi(x3, 2))), 1.23, (1.31 + 0.24*tan(0.32*sin(t))/2)))]
#[forces(
    dot(x1)*sqrt(2 + powi(dot(x4), 2)) - p1*exp(0.20*t) - 0.46*exp(-powi(x5, 2)/2) - 0.37*powi(dot(x1), 2),
    p1*exp(0.20*x1) + 0.61*dot(x3)/(1 + powi(x1, 2)),
    1.27*dot(x2)/(1 + powi(t, 2)) - p2*1.42 - dot(x2)*dot(x1)/(1.37 + 0.19*powi(cos(1.10*x5 + 0.70), 3)) - dot(x2)*dot(x3)/1.37,
    p1*exp(0.20*x2) + dot(x3)*sqrt(2 + powi(dot(x5), 2)) + p1*x3,
    p2*exp(0.20*x1) + p1*dot(x1)*dot(x4)*tan(0.85*sin(x3))/2,
)]
#[configuration(of(q1, q2), x1 = 1.25*q1, x5 = 1.25*q2, x4 = q2/(1 + powi(q2, 2)), x2 = sin(1.18*q1 + 0.27*t - 0.46)*cos(1.06*t - 0.88*q1), x3 = exp(-powi(q2, 2)/2))]
#[constraint(held_x4: x4 - ((x5/1.25)/(1 + powi((x5/1.25), 2))) == 0)]
#[constraint(held_x2: x2 - (sin(1.18*(x1/1.25) + 0.27*t - 0.46)*cos(1.06*t - 0.88*(x1/1.25))) == 0)]
#[constraint(held_x3: x3 - (exp(-powi((x5/1.25), 2)/2)) == 0)]
#[output(place = cos(0.79*x1 - 0.72*x5), power = p2*dot(x2)*dot(x5)*powi(cos(1.08*x3 - 0.52), 3) - p1*dot(x2)*dot(x3)*tan(0.53*sin(t))/2, push = 0.59*sin(x1)/(1.50 + cos(x5))*ddot(x4) + dot(x2)*ddot(x2), pull = (1.37 - 0.24*tan(0.82*sin(x2))/2)*reaction(held_x2) - push, share = pull/(1.85 + powi(reaction(held_x2), 2)))]
pub struct Random207 {
    #[nominal(0.80)]
    pub p1: f64,
    #[nominal(0.76)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    dot(x1) = (1.03 - 0.19*0.35*sin(x1)/(1.50 + cos(x1)))*v1 - 0.39*0.62*sin(x3)/(1.50 + cos(x1))*v2,
    dot(x2) = (1.13 + 0.24*cos(0.70*x1))*v2 + 0.34*1/sqrt(1.50 + powi(x6, 2))*v3,
    dot(x3) = v3,
    dot(x4) = v4 + 0.25*sin(0.59*x3 - 0.28*x5)*v3,
    dot(x5) = v5 + 0.33*cos(0.90*x2)*v6,
    dot(x6) = (1.32 - 0.18*1/sqrt(1.50 + powi(x6, 2)))*v6,
)]
#[inertia(matrix(
    [((1.01 + 0.28*sin(p1*x6 - 0.67)))*((1.01 + 0.28*sin(p1*x6 - 0.67))), ((1.01 + 0.28*sin(p1*x6 - 0.67)))*(0.16*tan(0.91*sin(x5))/2), ((1.01 + 0.28*sin(p1*x6 - 0.67)))*(0.37*powi(cos(0.67*x4 - 0.19), 3)), ((1.01 + 0.28*sin(p1*x6 - 0.67)))*(0.19*exp(-powi(x4, 2)/2)), ((1.01 + 0.28*sin(p1*x6 - 0.67)))*(0.21*tan(0.44*sin(x2))/2), ((1.01 + 0.28*sin(p1*x6 - 0.67)))*(0.11*sin(0.92*x6 - 0.49*x5)*cos(0.82*x4 + 0.42*x3 + 0.59))],
    [_, (0.16*tan(0.91*sin(x5))/2)*(0.16*tan(0.91*sin(x5))/2) + ((1.33 + 0.13*tan(0.47*sin(x4))/2))*((1.33 + 0.13*tan(0.47*sin(x4))/2)), (0.16*tan(0.91*sin(x5))/2)*(0.37*powi(cos(0.67*x4 - 0.19), 3)) + ((1.33 + 0.13*tan(0.47*sin(x4))/2))*(0.24*atan2(x2, 2 + cos(x5))/2), (0.16*tan(0.91*sin(x5))/2)*(0.19*exp(-powi(x4, 2)/2)), (0.16*tan(0.91*sin(x5))/2)*(0.21*tan(0.44*sin(x2))/2) + ((1.33 + 0.13*tan(0.47*sin(x4))/2))*(0.14*x4/(1 + powi(x4, 2))), (0.16*tan(0.91*sin(x5))/2)*(0.11*sin(0.92*x6 - 0.49*x5)*cos(0.82*x4 + 0.42*x3 + 0.59)) + ((1.33 + 0.13*tan(0.47*sin(x4))/2))*(0.18*sin(1.11*x3))],
    [_, _, (0.37*powi(cos(0.67*x4 - 0.19), 3))*(0.37*powi(cos(0.67*x4 - 0.19), 3)) + (0.24*atan2(x2, 2 + cos(x5))/2)*(0.24*atan2(x2, 2 + cos(x5))/2) + ((1.25 - 0.23*1/sqrt(1.50 + powi(x3, 2))))*((1.25 - 0.23*1/sqrt(1.50 + powi(x3, 2)))), (0.37*powi(cos(0.67*x4 - 0.19), 3))*(0.19*exp(-powi(x4, 2)/2)) + ((1.25 - 0.23*1/sqrt(1.50 + powi(x3, 2))))*(0.10*powi(cos(1.08*x5 - 0.69*x3 + 0.61), 3)), (0.37*powi(cos(0.67*x4 - 0.19), 3))*(0.21*tan(0.44*sin(x2))/2) + (0.24*atan2(x2, 2 + cos(x5))/2)*(0.14*x4/(1 + powi(x4, 2))) + ((1.25 - 0.23*1/sqrt(1.50 + powi(x3, 2))))*(0.25*atan2(x3, 2 + cos(x2))/2), (0.37*powi(cos(0.67*x4 - 0.19), 3))*(0.11*sin(0.92*x6 - 0.49*x5)*cos(0.82*x4 + 0.42*x3 + 0.59)) + (0.24*atan2(x2, 2 + cos(x5))/2)*(0.18*sin(1.11*x3)) + ((1.25 - 0.23*1/sqrt(1.50 + powi(x3, 2))))*(0.38*sin(p1*x5 + 0.40))],
    [_, _, _, (0.19*exp(-powi(x4, 2)/2))*(0.19*exp(-powi(x4, 2)/2)) + (0.10*powi(cos(1.08*x5 - 0.69*x3 + 0.61), 3))*(0.10*powi(cos(1.08*x5 - 0.69*x3 + 0.61), 3)) + (1.20)*(1.20), (0.19*exp(-powi(x4, 2)/2))*(0.21*tan(0.44*sin(x2))/2) + (0.10*powi(cos(1.08*x5 - 0.69*x3 + 0.61), 3))*(0.25*atan2(x3, 2 + cos(x2))/2) + (1.20)*(0.35*sin(0.91*x4 + 1.48)), (0.19*exp(-powi(x4, 2)/2))*(0.11*sin(0.92*x6 - 0.49*x5)*cos(0.82*x4 + 0.42*x3 + 0.59)) + (0.10*powi(cos(1.08*x5 - 0.69*x3 + 0.61), 3))*(0.38*sin(p1*x5 + 0.40)) + (1.20)*(0.13*powi(cos(1.04*x2 - 0.42*x5 - 0.13), 3))],
    [_, _, _, _, (0.21*tan(0.44*sin(x2))/2)*(0.21*tan(0.44*sin(x2))/2) + (0.14*x4/(1 + powi(x4, 2)))*(0.14*x4/(1 + powi(x4, 2))) + (0.25*atan2(x3, 2 + cos(x2))/2)*(0.25*atan2(x3, 2 + cos(x2))/2) + (0.35*sin(0.91*x4 + 1.48))*(0.35*sin(0.91*x4 + 1.48)) + (1.06)*(1.06), (0.21*tan(0.44*sin(x2))/2)*(0.11*sin(0.92*x6 - 0.49*x5)*cos(0.82*x4 + 0.42*x3 + 0.59)) + (0.14*x4/(1 + powi(x4, 2)))*(0.18*sin(1.11*x3)) + (0.25*atan2(x3, 2 + cos(x2))/2)*(0.38*sin(p1*x5 + 0.40)) + (0.35*sin(0.91*x4 + 1.48))*(0.13*powi(cos(1.04*x2 - 0.42*x5 - 0.13), 3)) + (1.06)*(0.28*ln(1.60 + 0.84*cos(x3)))],
    [_, _, _, _, _, (0.11*sin(0.92*x6 - 0.49*x5)*cos(0.82*x4 + 0.42*x3 + 0.59))*(0.11*sin(0.92*x6 - 0.49*x5)*cos(0.82*x4 + 0.42*x3 + 0.59)) + (0.18*sin(1.11*x3))*(0.18*sin(1.11*x3)) + (0.38*sin(p1*x5 + 0.40))*(0.38*sin(p1*x5 + 0.40)) + (0.13*powi(cos(1.04*x2 - 0.42*x5 - 0.13), 3))*(0.13*powi(cos(1.04*x2 - 0.42*x5 - 0.13), 3)) + (0.28*ln(1.60 + 0.84*cos(x3)))*(0.28*ln(1.60 + 0.84*cos(x3))) + ((1.24 + 0.29*ln(1.60 + 0.78*cos(x3))))*((1.24 + 0.29*ln(1.60 + 0.78*cos(x3))))],
))]
#[forces(
    p1*v6*v5*sin(0.70*x2),
    0.45*powi(v4, 2),
    v4*v4/(1.12 - 0.26*sin(0.82*x4 - 0.23)) - 1.49*0.82*sin(x2)/(1.50 + cos(x1)),
    p1*exp(0.20*x3) - 1.18*v2/(1 + powi(x3, 2)) - p1*x6 - v2*sqrt(2 + powi(v3, 2)),
    p1*exp(0.20*x3) - 0.61*cos(0.96*x1) - p1*x2 - p1*exp(0.20*x4),
    1.48*v4 - v1*v1/(1.01 + 0.17*powi(cos(0.96*x4 - 0.43), 3)) - 0.91*v2/(1 + powi(x2, 2)),
)]
#[potential_energy(powi(cos(0.74*x6 - 0.47*x5), 3))]
#[configuration(x6 = 0.54*1/sqrt(1.50 + powi(x2, 2)))]
#[constraint(held_x6: x6 - (0.54*1/sqrt(1.50 + powi(x2, 2))) == 0)]
#[constraint(rolling: 1.06*dot(x3) - 0.28*sin(p1*x3 - 0.21)*dot(x5) - 0.15*sin(0.97*x2 - 0.68)*cos(0.69*x4 + 0.82*x2)*dot(x4) + 0.24*tan(0.66*sin(x1))/2*dot(x1) == 0)]
#[output(place = 1/sqrt(1.50 + powi(x2, 2)), power = p1*v2*v1*ln(1.60 + 0.82*cos(x1)) + 1.18*1/sqrt(1.50 + powi(x2, 2)), push = sin(0.81*x5 + 0.12)*cos(0.84*x1)*dot(v5) + v1*ddot(x1), pull = (1.33 - 0.16*sin(0.85*x6 + 0.64)*cos(0.50*x6))*reaction(held_x6) - push, share = pull/(1.11 + powi(reaction(held_x6), 2)))]
pub struct Random208 {
    #[nominal(0.57)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inertia(diag((1.39 + 0.25*0.56*sin(x6)/(1.50 + cos(x6))), (1.18 - 0.30*sin(p3*x3 - 0.91)), (1.14 - 0.35*sin(0.64*x5)*cos(0.79*x6 + 1.00)), 1.19, 1.07, (1.02 - 0.17*cos(0.50*x3 - 0.38*x3 + 0.22))))]
#[forces(
    p2*dot(x3)*dot(x4)*x5/(1 + powi(x5, 2)) - 1.65*powi(dot(x6), 2) - p3*x1,
    p2*x2 - 0.79*sin(1.03*x6 - 0.63) - dot(x2)*dot(x1)/(1.13 - 0.32*tan(0.41*sin(x4))/2),
    0,
    0,
    0.49*dot(x3),
    1.46*dot(x5)/(1 + powi(x3, 2)) - p2*1.67 - 1.88*powi(dot(x3), 2) - p3*0.39,
)]
#[potential_energy(ln(1.60 + 0.78*cos(x3)))]
#[constraint(row1: dot(x2) + 0*dot(x5) + 0.21*powi(cos(0.63*x4), 3)*dot(x3) == 0)]
#[constraint(row2: dot(x4) + 0*dot(x5) + 0.74*x5/(1 + powi(x5, 2))*dot(x3) == 0)]
#[constraint(row3: dot(x1) + 0.50*0.69*sin(x5)/(1.50 + cos(x1))*dot(x5) + 0.74*powi(cos(0.46*x4 + 0.81*x6 + 0.33), 3)*dot(x3) + 0.40*atan2(x5, 2 + cos(x3))/2 == 0)]
#[constraint(row4: dot(x6) + 0.79*sin(0.42*x1)*dot(x5) + 0.59*sin(0.65*x5)*dot(x3) == 0)]
#[complement(
    w1 = [-(1.37 - 0.32*sin(p2*x1 + 0.22))*(0.50*0.69*sin(x5)/(1.50 + cos(x1))), -(1.37 - 0.32*sin(p2*x1 + 0.22))*(0), 0, -(1.37 - 0.32*sin(p2*x1 + 0.22))*(0), (1.37 - 0.32*sin(p2*x1 + 0.22)), -(1.37 - 0.32*sin(p2*x1 + 0.22))*(0.79*sin(0.42*x1))],
    w2 = [-(1.15 - 0.31*exp(-powi(x5, 2)/2))*(0.74*powi(cos(0.46*x4 + 0.81*x6 + 0.33), 3)), -(1.15 - 0.31*exp(-powi(x5, 2)/2))*(0.21*powi(cos(0.63*x4), 3)), (1.15 - 0.31*exp(-powi(x5, 2)/2)), -(1.15 - 0.31*exp(-powi(x5, 2)/2))*(0.74*x5/(1 + powi(x5, 2))), 0, -(1.15 - 0.31*exp(-powi(x5, 2)/2))*(0.59*sin(0.65*x5))],
)]
pub struct Random209 {
    #[nominal(1.23)]
    pub p1: f64,
    #[nominal(0.96)]
    pub p2: f64,
    #[nominal(0.69)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inputs(tau)]
#[inertia(matrix(
    [((1.17 - 0.11*atan2(x1, 2 + cos(t))/2))*((1.17 - 0.11*atan2(x1, 2 + cos(t))/2)), ((1.17 - 0.11*atan2(x1, 2 + cos(t))/2))*(0.16*sin(0.68*t)*cos(0.71*x5)), ((1.17 - 0.11*atan2(x1, 2 + cos(t))/2))*(0.16*tan(0.39*sin(x5))/2), ((1.17 - 0.11*atan2(x1, 2 + cos(t))/2))*(0.26*sin(1.15*x4 - 0.40*x6)), 0, ((1.17 - 0.11*atan2(x1, 2 + cos(t))/2))*(0.25*sin(0.41*x3 + 0.99))],
    [_, (0.16*sin(0.68*t)*cos(0.71*x5))*(0.16*sin(0.68*t)*cos(0.71*x5)) + ((1.37 - 0.34*1/sqrt(1.50 + powi(x3, 2))))*((1.37 - 0.34*1/sqrt(1.50 + powi(x3, 2)))), (0.16*sin(0.68*t)*cos(0.71*x5))*(0.16*tan(0.39*sin(x5))/2) + ((1.37 - 0.34*1/sqrt(1.50 + powi(x3, 2))))*(0.35*1/sqrt(1.50 + powi(x6, 2))), (0.16*sin(0.68*t)*cos(0.71*x5))*(0.26*sin(1.15*x4 - 0.40*x6)), ((1.37 - 0.34*1/sqrt(1.50 + powi(x3, 2))))*(0.15*cos(0.99*x4 + 0.82*x2)), (0.16*sin(0.68*t)*cos(0.71*x5))*(0.25*sin(0.41*x3 + 0.99)) + ((1.37 - 0.34*1/sqrt(1.50 + powi(x3, 2))))*(0.21*tan(0.64*sin(x6))/2)],
    [_, _, (0.16*tan(0.39*sin(x5))/2)*(0.16*tan(0.39*sin(x5))/2) + (0.35*1/sqrt(1.50 + powi(x6, 2)))*(0.35*1/sqrt(1.50 + powi(x6, 2))) + (1.31)*(1.31), (0.16*tan(0.39*sin(x5))/2)*(0.26*sin(1.15*x4 - 0.40*x6)) + (1.31)*(0.26*sin(0.86*x6 + 0.52*x6)), (0.35*1/sqrt(1.50 + powi(x6, 2)))*(0.15*cos(0.99*x4 + 0.82*x2)), (0.16*tan(0.39*sin(x5))/2)*(0.25*sin(0.41*x3 + 0.99)) + (0.35*1/sqrt(1.50 + powi(x6, 2)))*(0.21*tan(0.64*sin(x6))/2)],
    [_, _, _, (0.26*sin(1.15*x4 - 0.40*x6))*(0.26*sin(1.15*x4 - 0.40*x6)) + (0.26*sin(0.86*x6 + 0.52*x6))*(0.26*sin(0.86*x6 + 0.52*x6)) + ((1.09 - 0.28*sin(0.70*x3)*cos(0.64*x6 - 1.04)))*((1.09 - 0.28*sin(0.70*x3)*cos(0.64*x6 - 1.04))), 0, (0.26*sin(1.15*x4 - 0.40*x6))*(0.25*sin(0.41*x3 + 0.99)) + ((1.09 - 0.28*sin(0.70*x3)*cos(0.64*x6 - 1.04)))*(0.15*x3/(1 + powi(x3, 2)))],
    [_, _, _, _, (0.15*cos(0.99*x4 + 0.82*x2))*(0.15*cos(0.99*x4 + 0.82*x2)) + ((1.17 + 0.14*sin(0.49*x1 - 1.22)*cos(1.11*x1)))*((1.17 + 0.14*sin(0.49*x1 - 1.22)*cos(1.11*x1))), (0.15*cos(0.99*x4 + 0.82*x2))*(0.21*tan(0.64*sin(x6))/2)],
    [_, _, _, _, _, (0.25*sin(0.41*x3 + 0.99))*(0.25*sin(0.41*x3 + 0.99)) + (0.21*tan(0.64*sin(x6))/2)*(0.21*tan(0.64*sin(x6))/2) + (0.15*x3/(1 + powi(x3, 2)))*(0.15*x3/(1 + powi(x3, 2))) + ((1.26 + 0.26*sin(1.18*x6)))*((1.26 + 0.26*sin(1.18*x6)))],
))]
#[forces(
    p1*x4 + 1.75*cos(0.52*x1 - 0.34*x6 + 1.34),
    tau*1.16 + p1*dot(x5)*dot(x3)*x3/(1 + powi(x3, 2)) + p1*exp(0.20*x2),
    0.40*dot(x5)/(1 + powi(x1, 2)) - p1*x4,
    0.47*dot(x6),
    p1*exp(0.20*x6),
    0,
)]
#[constraint(row1: 1.54*x2 + 0.25*sin(x2) + 0.38*powi(x1, 2)/2 + 0.30*sin(1.22*t) + 0.80 == 0)]
#[constraint(row2: 1.23*x3 + exp(0.33*x1)/2 + 0.33*x2*x1 + 0.30*sin(0.83*t) - 0.49 == 0)]
#[constraint(row3: 1.19*dot(x6) + 0.13*sin(0.83*x6 + 0.22)*cos(0.83*x2 - 0.46*t - 1.16)*dot(x1) + 0.21*sin(p1*x1 + 0.81)*dot(x2) - 0.24*exp(-powi(x1, 2)/2)*dot(x3) == 0)]
#[constraint(row4: 1.16*dot(x5) - 0.21*cos(1.17*x4 + 0.72*x2)*dot(x1) - 0.22*exp(-powi(x5, 2)/2)*dot(x2) == 0)]
#[constraint(row5: 1.60*dot(x4) + 0.35*cos(1.05*x2 - 0.81*t + 0.91)*dot(x1) + 0.17*ln(1.60 + 0.67*cos(x3))*dot(x2) == 0)]
#[independent(s1 = (1.50 - 0.20*exp(-powi(x3, 2)/2))*dot(x1) - 0.14*tan(0.84*sin(t))/2*dot(x2) + 0.29*cos(1.11*t)*dot(x3))]
pub struct Random210 {
    #[nominal(0.95)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inertia(diag((1.38 - 0.31*powi(cos(0.71*x1 + 0.27*x5), 3)), (1.24 - 0.19*sin(p1*x4 + 0.65)), (1.34 - 0.19*atan2(x3, 2 + cos(x3))/2), (1.37 + 0.10*1/sqrt(1.50 + powi(x4, 2))), (1.15 - 0.20*powi(cos(1.19*x3 - 1.23), 3)), 1.14))]
#[forces(
    1.13*dot(x5)/(1 + powi(x1, 2)) - p1*0.30,
    p1*exp(0.20*x3),
    p1*dot(x5)*dot(x6)*sin(0.85*x5 + 0.79*x1) - p2*x4 - dot(x3)*dot(x1)/1.25 - p2*dot(x5)*dot(x5)*1/sqrt(1.50 + powi(x5, 2)),
    p1*1.06 - 0.55*dot(x6)/(1 + powi(x6, 2)) - 0.70*ln(1.60 + 0.84*cos(x5)) - p1*1.48,
    0.47*sin(0.90*x6 + 0.55*x6) - p2*exp(0.20*x1) - p2*x4,
    dot(x5)*sqrt(2 + powi(dot(x3), 2)) + p1*exp(0.20*x1) + dot(x2)*sqrt(2 + powi(dot(x6), 2)) + p1*0.61,
)]
#[potential_energy(0.55*sin(x4)/(1.50 + cos(x3)))]
#[constraint(row1: 1.54*x3 + 0.19*sin(x3) + 0.35 == 0)]
#[constraint(row2: 1.62*x4 + 0.18*sin(x4) + 0.23*x3 + 0.68 == 0)]
#[constraint(row3: 1.05*dot(x5) + 0.29*sin(0.48*x2)*dot(x3) - 0.17*sin(0.60*x1 - 0.45*x3)*dot(x4) == 0)]
#[constraint(row4: dot(x2) - 0.12*sin(1.15*x1 + 0.25*x5)*cos(1.19*x5)*dot(x3) + 0.27*sin(p1*x2 - 0.96)*dot(x4) - 0.33*sin(p1*x3 + 0.75)*dot(x5) == 0)]
#[constraint(row5: (1.50 - 0.14*cos(0.75*x2 + 0.64*x2))*dot(x6) + 0.34*cos(0.95*x1 + 0.26*x2 + 0.91)*dot(x3) - 0.13*atan2(x3, 2 + cos(x1))/2*dot(x4) + 0.13*cos(0.99*x4 + 0.49*x4)*dot(x5) == 0)]
#[constraint(row6: 1.15*dot(x1) - 0.12*0.71*sin(x5)/(1.50 + cos(x4))*dot(x3) - 0.17*sin(0.61*x2)*dot(x4) - 0.21*sin(0.84*x1)*dot(x5) == 0)]
pub struct Random211 {
    #[nominal(0.95)]
    pub p1: f64,
    #[nominal(0.51)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + sin(p1*x6 - 0.30)*dot(x1),
    v3 = dot(x3) + 1/sqrt(1.50 + powi(x6, 2))*dot(x2),
    v4 = dot(x4) + sin(0.82*x2)*dot(x2),
    v5 = dot(x5) + 1/sqrt(1.50 + powi(x4, 2))*dot(x4),
    v6 = dot(x6) + sin(p1*x4 + 0.69)*dot(x4),
    dot(x1) = v1,
    dot(x2) = v2 - sin(p1*x6 - 0.30)*(v1),
    dot(x3) = v3 - 1/sqrt(1.50 + powi(x6, 2))*(v2 - sin(p1*x6 - 0.30)*(v1)),
    dot(x4) = v4 - sin(0.82*x2)*(v2 - sin(p1*x6 - 0.30)*(v1)),
    dot(x5) = v5 - 1/sqrt(1.50 + powi(x4, 2))*(v4 - sin(0.82*x2)*(v2 - sin(p1*x6 - 0.30)*(v1))),
    dot(x6) = v6 - sin(p1*x4 + 0.69)*(v4 - sin(0.82*x2)*(v2 - sin(p1*x6 - 0.30)*(v1))),
)]
#[inertia(diag((1.27 + 0.29*1/sqrt(1.50 + powi(x1, 2))), 1.21, 1.06, (1.20 + 0.16*powi(cos(0.53*t + 0.20), 3)), (1.21 - 0.14*sin(0.86*x4 + 0.67*x5)), (1.17 + 0.33*atan2(x2, 2 + cos(x2))/2)))]
#[forces(
    v6*sqrt(2 + powi(v3, 2)) + 1.13*v6/(1 + powi(x2, 2)),
    1.33*v5/(1 + powi(x3, 2)),
    p1*exp(0.20*t) - 1.36*v5/(1 + powi(x1, 2)) - 1.34*v3 - p1*x2,
    0,
    1.16*v2 - p1*x3,
    v3*v1/(1.15 - 0.21*exp(-powi(x2, 2)/2)) - 1.29*v6,
)]
#[potential_energy(sin(0.93*x6 - 0.48*x4 - 0.73))]
#[constraint(row1: 1.89*v6 + 0.26*t/(1 + powi(t, 2))*v4 == 0)]
#[constraint(row2: 1.17*v5 - 0.11*exp(-powi(x5, 2)/2)*v4 - 0.26*sin(0.57*x3)*cos(1.13*x1 - 0.10)*v6 - 0.30*1/sqrt(1.50 + powi(t, 2)) == 0)]
#[constraint(row3: 1.14*v3 - 0.15*sin(v3 + x5/(1 + powi(x5, 2))*v4) + 0.26*cos(0.58*x4 - 0.30*x6 + 0.87) == 0)]
#[constraint(row4: 1.19*v2 - 0.18*exp(-powi(x4, 2)/2)*v4*v4 - 0.29*1/sqrt(1.50 + powi(x2, 2)) == 0)]
#[constraint(row5: 1.10*v1 - 0.11*sin(v1 + exp(-powi(x2, 2)/2)*v4) - 0.44*sin(0.48*x2)*cos(1.03*x1 + 0.75*x2 - 0.63) == 0)]
#[output(place = exp(-powi(x3, 2)/2), power = p1*x4 - p1*x5, push = atan2(x2, 2 + cos(x2))/2*dot(v4) + v2*ddot(x2), pull = 1.37*reaction(row3) - push, share = pull/(1.86 + powi(reaction(row3), 2)))]
pub struct Random212 {
    #[nominal(1.30)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[speeds(v1, v2, v3, v4, v5)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + x5/(1 + powi(x5, 2))*dot(x1),
    v3 = dot(x3) + x3/(1 + powi(x3, 2))*dot(x2),
    v4 = dot(x4) + powi(cos(1.14*x4), 3)*dot(x2),
    v5 = dot(x5) + sin(p2*x2 + 0.96)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - x5/(1 + powi(x5, 2))*(v1),
    dot(x3) = v3 - x3/(1 + powi(x3, 2))*(v2 - x5/(1 + powi(x5, 2))*(v1)),
    dot(x4) = v4 - powi(cos(1.14*x4), 3)*(v2 - x5/(1 + powi(x5, 2))*(v1)),
    dot(x5) = v5 - sin(p2*x2 + 0.96)*(v1),
)]
#[inertia(matrix(
    [((1.32 - 0.16*sin(p2*x5 + 0.35)))*((1.32 - 0.16*sin(p2*x5 + 0.35))), ((1.32 - 0.16*sin(p2*x5 + 0.35)))*(0.35*1/sqrt(1.50 + powi(x3, 2))), ((1.32 - 0.16*sin(p2*x5 + 0.35)))*(0.20*sin(1.10*x3 - 0.46*x1 - 1.39)), ((1.32 - 0.16*sin(p2*x5 + 0.35)))*(0.34*0.51*sin(x4)/(1.50 + cos(x4))), 0],
    [_, (0.35*1/sqrt(1.50 + powi(x3, 2)))*(0.35*1/sqrt(1.50 + powi(x3, 2))) + ((1.33 - 0.27*ln(1.60 + 0.60*cos(x4))))*((1.33 - 0.27*ln(1.60 + 0.60*cos(x4)))), (0.35*1/sqrt(1.50 + powi(x3, 2)))*(0.20*sin(1.10*x3 - 0.46*x1 - 1.39)) + ((1.33 - 0.27*ln(1.60 + 0.60*cos(x4))))*(0.27*cos(1.00*x2 - 0.87)), (0.35*1/sqrt(1.50 + powi(x3, 2)))*(0.34*0.51*sin(x4)/(1.50 + cos(x4))), ((1.33 - 0.27*ln(1.60 + 0.60*cos(x4))))*(0.14*atan2(x2, 2 + cos(x3))/2)],
    [_, _, (0.20*sin(1.10*x3 - 0.46*x1 - 1.39))*(0.20*sin(1.10*x3 - 0.46*x1 - 1.39)) + (0.27*cos(1.00*x2 - 0.87))*(0.27*cos(1.00*x2 - 0.87)) + ((1.04 - 0.26*sin(1.10*x3)))*((1.04 - 0.26*sin(1.10*x3))), (0.20*sin(1.10*x3 - 0.46*x1 - 1.39))*(0.34*0.51*sin(x4)/(1.50 + cos(x4))) + ((1.04 - 0.26*sin(1.10*x3)))*(0.22*ln(1.60 + 0.68*cos(x4))), (0.27*cos(1.00*x2 - 0.87))*(0.14*atan2(x2, 2 + cos(x3))/2)],
    [_, _, _, (0.34*0.51*sin(x4)/(1.50 + cos(x4)))*(0.34*0.51*sin(x4)/(1.50 + cos(x4))) + (0.22*ln(1.60 + 0.68*cos(x4)))*(0.22*ln(1.60 + 0.68*cos(x4))) + ((1.26 + 0.11*sin(0.55*x5)*cos(0.50*x4 + 0.35*x4 + 1.00)))*((1.26 + 0.11*sin(0.55*x5)*cos(0.50*x4 + 0.35*x4 + 1.00))), ((1.26 + 0.11*sin(0.55*x5)*cos(0.50*x4 + 0.35*x4 + 1.00)))*(0.21*sin(1.00*x5 + 0.42*x2)*cos(0.92*x3 + 0.85))],
    [_, _, _, _, (0.14*atan2(x2, 2 + cos(x3))/2)*(0.14*atan2(x2, 2 + cos(x3))/2) + (0.21*sin(1.00*x5 + 0.42*x2)*cos(0.92*x3 + 0.85))*(0.21*sin(1.00*x5 + 0.42*x2)*cos(0.92*x3 + 0.85)) + ((1.01 - 0.33*ln(1.60 + 0.38*cos(x1))))*((1.01 - 0.33*ln(1.60 + 0.38*cos(x1))))],
))]
#[forces(
    0.38*cos(0.70*x2 + 0.23*x2 - 0.34) - p3*exp(0.20*x1) - p1*exp(0.20*x2),
    p1*x1,
    p1*v4*v3*sin(1.10*x5 + 1.38)*cos(1.12*x5 + 1.49) + v3*sqrt(2 + powi(v3, 2)) + 0.88*v2,
    p2*exp(0.20*x5) + v5*v2/(1.32 - 0.18*1/sqrt(1.50 + powi(x1, 2))) + 1.77*powi(v3, 2),
    1.52*v1/(1 + powi(x4, 2)) + p3*0.76,
)]
#[constraint(row1: 1.71*dot(v5) + 0.27*v2 + 0.27*sin(1.02*x3)*cos(1.00*x5 - 0.41) == 0)]
#[constraint(row2: ddot(x1) - 0.30*atan2(x1, 2 + cos(x2))/2*dot(v5) - 0.48*v1*v3*sin(0.41*x4 + 0.84*x1) == 0)]
#[constraint(row3: 1.47*dot(v4) + 0.15*sin(0.49*x2 + 1.14)*dot(v5) + 0.28*1/sqrt(1.50 + powi(x3, 2))*dot(v1) + 0.34*0.55*sin(x4)/(1.50 + cos(x2)) == 0)]
#[constraint(row4: ddot(x2) + 0.28*cos(0.59*x1 - 0.60*x4)*dot(v5) + 0.30*cos(0.54*x1)*dot(v1) + 0.61*v4*v5*sin(p1*x1 - 0.32) == 0)]
#[constraint(row5: (1.50 - 0.14*x1/(1 + powi(x1, 2)))*dot(v3) - 0.17*sin(p2*x2 - 0.65)*dot(v5) + 0.20*sin(0.54*x3)*dot(v1) + 0.29*v4 + 0.29*exp(-powi(x1, 2)/2) == 0)]
#[independent(s1 = v3 + 0.57*cos(0.99*x1), s2 = (1.50 - 0.12*sin(p3*x3 - 0.34))*v2 + 0.11*sin(0.56*x3 + 0.31*x4)*cos(0.67*x2 - 0.11)*v3, s3 = 1.39*v4 - 0.11*exp(-powi(x5, 2)/2)*v3 + 0.52*sin(0.94*x3), v1, s5 = 1.57*v5 - 0.14*atan2(x1, 2 + cos(x5))/2*v3 + 0.33*sin(0.57*x4 + 0.43*x5)*cos(1.00*x4 - 0.58*x2))]
#[independent(v3, v2, v4, v1, v5)]
pub struct Random213 {
    #[nominal(0.78)]
    pub p1: f64,
    #[nominal(0.77)]
    pub p2: f64,
    #[nominal(1.23)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inertia(diag((1.40 - 0.15*ln(1.60 + 0.50*cos(x2))), 1.26, (1.05 + 0.15*sin(p1*x4 + 0.93)), (1.09 + 0.31*cos(0.80*x4 + 0.40*x3 + 0.82)), (1.10 + 0.14*exp(-powi(x3, 2)/2)), (1.24 - 0.18*sin(1.10*x5 + 0.77*x1)*cos(0.62*x6 - 0.74*x1))))]
#[forces(
    1.49*powi(dot(x4), 2) - p1*dot(x2)*dot(x5)*tan(0.85*sin(x1))/2,
    p1*exp(0.20*x3) - 1.85*dot(x3) - 0.77*dot(x2) - dot(x4)*sqrt(2 + powi(dot(x4), 2)),
    p2*x5,
    p1*0.48 + 1.14*sin(1.04*x6 - 0.53*x6 + 0.50)*cos(0.43*x3 + 0.89*x1 + 0.37) + 0.70*powi(dot(x5), 2) + p1*x1,
    0.37*sin(1.12*x2 - 0.37*x6 - 1.23) + p2*dot(x2)*dot(x6)*exp(-powi(x1, 2)/2) + 1.07*dot(x2)/(1 + powi(x6, 2)),
    p1*0.99,
)]
#[potential_energy(atan2(x5, 2 + cos(x5))/2)]
#[constraint(row1: 1.60*x1 + 0.40*powi(x2, 2)/2 - 0.30 == 0)]
#[constraint(row2: ddot(x6) + 0.26*tan(0.45*sin(x6))/2*ddot(x2) + 0.16*1/sqrt(1.50 + powi(x3, 2))*ddot(x4) - 0.73*dot(x6)*dot(x3)*sin(0.50*x5) == 0)]
#[independent(dot(x5), dot(x3), dot(x4), dot(x2), dot(x6))]
#[independent(s1 = 1.13*dot(x5) + 0.21*sin(0.60*x2 + 0.79)*dot(x1), dot(x3), s3 = dot(x4) + 0.32*x5/(1 + powi(x5, 2))*dot(x5) - 0.27*sin(p1*x2 - 0.72)*dot(x3), s4 = 1.90*dot(x2) + 0.24*tan(0.86*sin(x1))/2*dot(x5) - 0.25*sin(1.09*x2)*dot(x3), dot(x6))]
#[output(place = powi(cos(0.70*x6), 3), power = dot(x4)*sqrt(2 + powi(dot(x2), 2)) + p2*1.05, push = ln(1.60 + 0.31*cos(x6))*ddot(x2) + dot(x6)*ddot(x6), pull = (1.25 + 0.23*ln(1.60 + 0.40*cos(x6)))*reaction(row2) - push, share = pull/(1.36 + powi(reaction(row2), 2)))]
pub struct Random215 {
    #[nominal(0.51)]
    pub p1: f64,
    #[nominal(0.66)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[inputs(tau)]
#[inertia(diag(1.02, (1.19 + 0.27*sin(1.09*x3 + 0.24*x4 - 0.49)*cos(0.81*x5 + 0.66*x1 + 0.61)), (1.36 + 0.13*cos(0.49*t)), 1.39, (1.31 - 0.27*cos(0.45*x4 + 0.33*x3 + 0.68))))]
#[forces(
    1.16*1/sqrt(1.50 + powi(x2, 2)) - p1*dot(x4)*dot(x2)*powi(cos(0.53*x2), 3) - dot(x1)*sqrt(2 + powi(dot(x3), 2)),
    dot(x5)*dot(x4)/(1.14 + 0.11*1/sqrt(1.50 + powi(x5, 2))) + dot(x4)*sqrt(2 + powi(dot(x4), 2)),
    1.15*powi(dot(x5), 2),
    p1*dot(x2)*dot(x5)*ln(1.60 + 0.63*cos(x2)) + 0.37*sin(0.85*x2) + dot(x1)*sqrt(2 + powi(dot(x5), 2)),
    0,
)]
#[potential_energy(sin(1.18*x2 + 0.49)*cos(1.07*x3 - 0.34*x5))]
#[constraint(row1: 1.88*x5 + 0.36*sin(x4) + 0.30*sin(1.36*t) + 0.10 == 0)]
#[constraint(row2: dot(x3) - 0.13*0.64*sin(x2)/(1.50 + cos(x4))*dot(x4) - 0.33*sin(0.81*t + 0.86*t)*dot(x5) == 0)]
#[constraint(row3: 1.35*dot(x1) - 0.21*sqrt(1.50 + powi(dot(x4), 2) + powi(dot(x5), 2)) - 0.21*cos(1.12*t + 0.86*x3 - 1.31) == 0)]
#[constraint(row4: (1.50 - 0.12*1/sqrt(1.50 + powi(x3, 2)))*ddot(x2) + 0.25*sin(p2*x1 - 0.75)*ddot(x4) + 0.25*1/sqrt(1.50 + powi(x4, 2))*ddot(x5) - 0.54*ln(1.60 + 0.52*cos(t)) == 0)]
#[output(place = atan2(t, 2 + cos(x5))/2, power = 0.63*powi(dot(x5), 2), push = 1/sqrt(1.50 + powi(x2, 2))*ddot(x4) + dot(x3)*ddot(x3), pull = 1.14*reaction(row2) - push, share = pull/(1.24 + powi(reaction(row2), 2)))]
pub struct Random216 {
    #[nominal(0.83)]
    pub p1: f64,
    #[nominal(0.83)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inertia(matrix(
    [((1.05 - 0.23*atan2(x3, 2 + cos(x6))/2))*((1.05 - 0.23*atan2(x3, 2 + cos(x6))/2)), ((1.05 - 0.23*atan2(x3, 2 + cos(x6))/2))*(0.34*cos(1.16*x2 + 0.37*x1 + 0.81)), 0, 0, 0, ((1.05 - 0.23*atan2(x3, 2 + cos(x6))/2))*(0.23*sin(1.20*x4 - 0.63)*cos(0.66*x1 + 0.53*x5))],
    [_, (0.34*cos(1.16*x2 + 0.37*x1 + 0.81))*(0.34*cos(1.16*x2 + 0.37*x1 + 0.81)) + ((1.01 + 0.28*sin(0.81*x3)))*((1.01 + 0.28*sin(0.81*x3))), ((1.01 + 0.28*sin(0.81*x3)))*(0.16*exp(-powi(x5, 2)/2)), ((1.01 + 0.28*sin(0.81*x3)))*(0.37*atan2(x3, 2 + cos(x5))/2), ((1.01 + 0.28*sin(0.81*x3)))*(0.38*sin(p1*x5 + 0.28)), (0.34*cos(1.16*x2 + 0.37*x1 + 0.81))*(0.23*sin(1.20*x4 - 0.63)*cos(0.66*x1 + 0.53*x5)) + ((1.01 + 0.28*sin(0.81*x3)))*(0.15*exp(-powi(x5, 2)/2))],
    [_, _, (0.16*exp(-powi(x5, 2)/2))*(0.16*exp(-powi(x5, 2)/2)) + ((1.18 - 0.27*1/sqrt(1.50 + powi(x3, 2))))*((1.18 - 0.27*1/sqrt(1.50 + powi(x3, 2)))), (0.16*exp(-powi(x5, 2)/2))*(0.37*atan2(x3, 2 + cos(x5))/2) + ((1.18 - 0.27*1/sqrt(1.50 + powi(x3, 2))))*(0.11*0.64*sin(x1)/(1.50 + cos(x6))), (0.16*exp(-powi(x5, 2)/2))*(0.38*sin(p1*x5 + 0.28)) + ((1.18 - 0.27*1/sqrt(1.50 + powi(x3, 2))))*(0.34*cos(0.44*x4)), (0.16*exp(-powi(x5, 2)/2))*(0.15*exp(-powi(x5, 2)/2))],
    [_, _, _, (0.37*atan2(x3, 2 + cos(x5))/2)*(0.37*atan2(x3, 2 + cos(x5))/2) + (0.11*0.64*sin(x1)/(1.50 + cos(x6)))*(0.11*0.64*sin(x1)/(1.50 + cos(x6))) + (1.02)*(1.02), (0.37*atan2(x3, 2 + cos(x5))/2)*(0.38*sin(p1*x5 + 0.28)) + (0.11*0.64*sin(x1)/(1.50 + cos(x6)))*(0.34*cos(0.44*x4)) + (1.02)*(0.33*sin(0.94*x4 + 0.44*x5 - 1.17)), (0.37*atan2(x3, 2 + cos(x5))/2)*(0.15*exp(-powi(x5, 2)/2))],
    [_, _, _, _, (0.38*sin(p1*x5 + 0.28))*(0.38*sin(p1*x5 + 0.28)) + (0.34*cos(0.44*x4))*(0.34*cos(0.44*x4)) + (0.33*sin(0.94*x4 + 0.44*x5 - 1.17))*(0.33*sin(0.94*x4 + 0.44*x5 - 1.17)) + ((1.28 - 0.19*1/sqrt(1.50 + powi(x4, 2))))*((1.28 - 0.19*1/sqrt(1.50 + powi(x4, 2)))), (0.38*sin(p1*x5 + 0.28))*(0.15*exp(-powi(x5, 2)/2))],
    [_, _, _, _, _, (0.23*sin(1.20*x4 - 0.63)*cos(0.66*x1 + 0.53*x5))*(0.23*sin(1.20*x4 - 0.63)*cos(0.66*x1 + 0.53*x5)) + (0.15*exp(-powi(x5, 2)/2))*(0.15*exp(-powi(x5, 2)/2)) + (1.17)*(1.17)],
))]
#[forces(
    0,
    p1*1.55 + dot(x3)*sqrt(2 + powi(dot(x6), 2)),
    dot(x3)*sqrt(2 + powi(dot(x6), 2)) + dot(x2)*dot(x5)/(1.25 + 0.27*0.32*sin(x5)/(1.50 + cos(x3))),
    p1*x4 + p1*exp(0.20*x6),
    p1*0.43 - dot(x6)*dot(x6)/1.39,
    p1*x3 - 0.99*powi(dot(x3), 2),
)]
#[potential_energy(ln(1.60 + 0.71*cos(x3)))]
#[constraint(row1: 1.76*x3 + 0.29*x5 + exp(0.14*x1)/2 + 0.39*x6 + 0.63 == 0)]
#[constraint(row2: 1.23*x2 + 0.21*sin(x2) + 0.14*sin(x5) - 0.74 == 0)]
#[constraint(row3: 1.52*x4 + 0.12*sin(x4) + 0.11*x5 - 0.14 == 0)]
#[constraint(again1: 1.05*(1.23*x2 + 0.21*sin(x2) + 0.14*sin(x5) - 0.74) - 1.09*(1.52*x4 + 0.12*sin(x4) + 0.11*x5 - 0.14) == 0, redundant)]
pub struct Random217 {
    #[nominal(1.39)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    dot(x1) = v1 - 0.20*ln(1.60 + 0.59*cos(x4))*v4 - 0.30*exp(-powi(x6, 2)/2),
    dot(x2) = v2 + 0.13*sin(0.91*x6 - 0.23*x2)*cos(1.14*x6 + 0.68*x5)*v5 - 0.47*sin(1.00*x1 + 0.64*x6),
    dot(x3) = v3 + 0.14*cos(1.00*x2)*v2 - 0.23*sin(1.18*x3 + 0.75*x2 - 0.35)*cos(0.69*x1 + 0.80*x3),
    dot(x4) = v4 - 0.23*powi(cos(0.90*x2), 3)*v5 - 0.46*powi(cos(0.46*x5 + 0.21*x3 + 0.36), 3),
    dot(x5) = v5 - 0.35*sin(1.07*x2),
    dot(x6) = 1.01*v6 - 0.25*powi(cos(1.13*x3 + 0.71*x3), 3),
)]
#[inertia(matrix(
    [((1.35 + 0.15*ln(1.60 + 0.64*cos(x1))))*((1.35 + 0.15*ln(1.60 + 0.64*cos(x1)))), ((1.35 + 0.15*ln(1.60 + 0.64*cos(x1))))*(0.22*1/sqrt(1.50 + powi(x2, 2))), ((1.35 + 0.15*ln(1.60 + 0.64*cos(x1))))*(0.34*0.80*sin(x2)/(1.50 + cos(x5))), 0, ((1.35 + 0.15*ln(1.60 + 0.64*cos(x1))))*(0.24*atan2(x6, 2 + cos(x2))/2), ((1.35 + 0.15*ln(1.60 + 0.64*cos(x1))))*(0.17*x4/(1 + powi(x4, 2)))],
    [_, (0.22*1/sqrt(1.50 + powi(x2, 2)))*(0.22*1/sqrt(1.50 + powi(x2, 2))) + (1.14)*(1.14), (0.22*1/sqrt(1.50 + powi(x2, 2)))*(0.34*0.80*sin(x2)/(1.50 + cos(x5))) + (1.14)*(0.17*sin(p1*x5 + 0.39)), 0, (0.22*1/sqrt(1.50 + powi(x2, 2)))*(0.24*atan2(x6, 2 + cos(x2))/2), (0.22*1/sqrt(1.50 + powi(x2, 2)))*(0.17*x4/(1 + powi(x4, 2))) + (1.14)*(0.26*sin(0.63*x1))],
    [_, _, (0.34*0.80*sin(x2)/(1.50 + cos(x5)))*(0.34*0.80*sin(x2)/(1.50 + cos(x5))) + (0.17*sin(p1*x5 + 0.39))*(0.17*sin(p1*x5 + 0.39)) + ((1.11 + 0.14*atan2(x2, 2 + cos(x4))/2))*((1.11 + 0.14*atan2(x2, 2 + cos(x4))/2)), ((1.11 + 0.14*atan2(x2, 2 + cos(x4))/2))*(0.17*atan2(x3, 2 + cos(x2))/2), (0.34*0.80*sin(x2)/(1.50 + cos(x5)))*(0.24*atan2(x6, 2 + cos(x2))/2) + ((1.11 + 0.14*atan2(x2, 2 + cos(x4))/2))*(0.22*cos(0.94*x1)), (0.34*0.80*sin(x2)/(1.50 + cos(x5)))*(0.17*x4/(1 + powi(x4, 2))) + (0.17*sin(p1*x5 + 0.39))*(0.26*sin(0.63*x1)) + ((1.11 + 0.14*atan2(x2, 2 + cos(x4))/2))*(0.18*powi(cos(0.75*x6 - 0.45*x4 + 0.93), 3))],
    [_, _, _, (0.17*atan2(x3, 2 + cos(x2))/2)*(0.17*atan2(x3, 2 + cos(x2))/2) + (1.04)*(1.04), (0.17*atan2(x3, 2 + cos(x2))/2)*(0.22*cos(0.94*x1)), (0.17*atan2(x3, 2 + cos(x2))/2)*(0.18*powi(cos(0.75*x6 - 0.45*x4 + 0.93), 3)) + (1.04)*(0.16*cos(0.53*x2))],
    [_, _, _, _, (0.24*atan2(x6, 2 + cos(x2))/2)*(0.24*atan2(x6, 2 + cos(x2))/2) + (0.22*cos(0.94*x1))*(0.22*cos(0.94*x1)) + ((1.24 + 0.21*cos(1.17*x1 - 0.60*x6 - 0.17)))*((1.24 + 0.21*cos(1.17*x1 - 0.60*x6 - 0.17))), (0.24*atan2(x6, 2 + cos(x2))/2)*(0.17*x4/(1 + powi(x4, 2))) + (0.22*cos(0.94*x1))*(0.18*powi(cos(0.75*x6 - 0.45*x4 + 0.93), 3)) + ((1.24 + 0.21*cos(1.17*x1 - 0.60*x6 - 0.17)))*(0.30*sin(p1*x5 - 0.81))],
    [_, _, _, _, _, (0.17*x4/(1 + powi(x4, 2)))*(0.17*x4/(1 + powi(x4, 2))) + (0.26*sin(0.63*x1))*(0.26*sin(0.63*x1)) + (0.18*powi(cos(0.75*x6 - 0.45*x4 + 0.93), 3))*(0.18*powi(cos(0.75*x6 - 0.45*x4 + 0.93), 3)) + (0.16*cos(0.53*x2))*(0.16*cos(0.53*x2)) + (0.30*sin(p1*x5 - 0.81))*(0.30*sin(p1*x5 - 0.81)) + (1.30)*(1.30)],
))]
#[forces(
    0.72*v2/(1 + powi(x3, 2)),
    p1*x5 + v2*sqrt(2 + powi(v4, 2)) + v1*v1/(1.02 - 0.11*tan(0.31*sin(x3))/2) + v5*sqrt(2 + powi(v2, 2)),
    p2*v5*v4*cos(0.80*x1) + p1*x5 + v1*v1/(1.15 - 0.25*sin(0.95*x6 + 0.61)) + v3*sqrt(2 + powi(v1, 2)),
    1.21*v2 - 0.87*sin(1.20*x6 - 0.72*x6)*cos(0.44*x6 + 0.57*x3) - p2*exp(0.20*x2),
    1.75*cos(0.78*x4),
    v5*sqrt(2 + powi(v2, 2)) - p2*x2,
)]
#[constraint(row1: (1.50 + 0.23*0.81*sin(x3)/(1.50 + cos(x1)))*v1 + 0.25*0.86*sin(x2)/(1.50 + cos(x1))*v5 - 0.27*sin(0.85*x3 + 0.36)*v4 - 0.32*1/sqrt(1.50 + powi(x3, 2))*v3 == 0)]
pub struct Random218 {
    #[nominal(1.08)]
    pub p1: f64,
    #[nominal(0.85)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[inputs(tau)]
#[define(l11 = (1.22 - 0.30*ln(1.60 + 0.88*cos(x3))), l22 = (1.06 + 0.17*ln(1.60 + 0.81*cos(x2))), l32 = 0.23*x2/(1 + powi(x2, 2)), l33 = (1.19 - 0.33*1.00*sin(x3)/(1.50 + cos(x1))), l42 = 0.29*sin(0.86*x5 - 0.56*x2), l43 = 0.34*sin(1.18*x2 + 0.77*x1 + 0.16)*cos(0.75*x5 + 0.87*x2), l44 = (1.11 - 0.18*powi(cos(1.02*x5 + 0.55), 3)), l51 = 0.25*0.77*sin(x1)/(1.50 + cos(x5)), l55 = 1.40)]
#[inertia(matrix(
    [l11*l11, 0, 0, 0, l11*l51],
    [_, l22*l22, l22*l32, l22*l42, 0],
    [_, _, l32*l32 + l33*l33, l32*l42 + l33*l43, 0],
    [_, _, _, l42*l42 + l43*l43 + l44*l44, 0],
    [_, _, _, _, l51*l51 + l55*l55],
))]
#[forces(
    1.25*dot(x1)/(1 + powi(x2, 2)) - 1.75*dot(x1) - tau*1.53 - dot(x5)*sqrt(2 + powi(dot(x3), 2)),
    tau*0.30 + 1.29*dot(x3),
    1.51*dot(x2) - dot(x1)*dot(x4)/(1.20 - 0.32*cos(1.09*x4)),
    p1*dot(x2)*dot(x5)*sin(0.85*x4 - 0.77*x3) + 0.51*tan(0.91*sin(x4))/2,
    p3*exp(0.20*x2) - p1*x4,
)]
#[potential_energy(tan(0.37*sin(x4))/2)]
#[configuration(x2 = 0.63*1/sqrt(1.50 + powi(x1, 2)), x4 = 1.14*sin(1.05*x1))]
#[constraint(bound: ddot(x1) + 0.11*exp(-powi(x1, 2)/2)*ddot(x5) - 0.15*tan(0.92*sin(x5))/2*ddot(x3) + 0.42*dot(x4)*dot(x3)*sin(0.90*x2 + 0.54*x5 - 1.00) == 0)]
#[output(place = sin(0.70*x5)*cos(0.77*x3), power = dot(x5)*dot(x2)/(1.25 - 0.27*sin(0.73*x5 + 0.28*x1)) + 1.23*tan(0.35*sin(x5))/2 + 0.35*dot(x1)/(1 + powi(x4, 2)) + 0.87*powi(dot(x4), 2), push = cos(0.69*x3)*ddot(x1) + dot(x4)*ddot(x4), pull = 1.36*reaction(bound) - push, share = pull/(1.89 + powi(reaction(bound), 2)))]
pub struct Random219 {
    #[nominal(1.29)]
    pub p1: f64,
    #[nominal(0.84)]
    pub p2: f64,
    #[nominal(1.22)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    dot(x1) = 1.19*v1 + 0.27*0.57*sin(x4)/(1.50 + cos(t))*v2 - 0.25*sin(0.56*x6),
    dot(x2) = (1.22 - 0.21*sin(0.58*x1))*v2 + 0.54*sin(p1*x5 + 0.48),
    dot(x3) = v3 + 0.34*powi(cos(0.84*x6 + 0.86*x1), 3)*v2 - 0.32*cos(0.64*x2 + 0.37*x2),
    dot(x4) = v4 + 0.38*cos(1.08*x1 - 1.36)*v3 - 0.29*0.56*sin(x2)/(1.50 + cos(x6)),
    dot(x5) = 1.28*v5 + 0.40*cos(0.56*x4 + 0.68*t)*v6 + 0.30*t/(1 + powi(t, 2)),
    dot(x6) = (1.17 - 0.32*atan2(x2, 2 + cos(x1))/2)*v6 - 0.25*0.66*sin(x5)/(1.50 + cos(t))*v2 + 0.10*sin(1.00*x2 - 0.24*x3),
)]
#[inertia(diag((1.02 + 0.34*sin(0.76*x2 + 0.57*x4 + 0.83)), (1.06 + 0.22*1/sqrt(1.50 + powi(x1, 2))), 1.38, 1.22, 1.24, (1.22 - 0.19*sin(0.79*x4))))]
#[forces(
    p1*exp(0.20*t) + p1*1.38,
    1.68*sin(1.20*x2) + v1*v6/(1.35 - 0.32*cos(1.19*x6 + 0.24*x2 + 0.85)) + p2*x3,
    v4*v1/1.02 + 0.98*powi(v4, 2) + p1*x5 + 1.97*powi(v3, 2),
    v4*sqrt(2 + powi(v6, 2)),
    1.52*v4/(1 + powi(x2, 2)) + 1.22*v6 + p2*v2*v1*atan2(x2, 2 + cos(x4))/2 + 0.62*sin(0.55*x5 + 0.87*x2 - 0.69)*cos(0.42*x2),
    0.74*sin(1.01*x2 - 1.18) + 1.49*v1,
)]
#[potential_energy(cos(0.91*x4 - 1.20))]
pub struct Random220 {
    #[nominal(1.33)]
    pub p1: f64,
    #[nominal(1.38)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    dot(x1) = v1,
    dot(x2) = 1.18*v2,
    dot(x3) = (1.38 - 0.26*sin(0.86*x3 - 0.53*x5 - 0.17)*cos(1.15*x1 + 0.65*x5 - 0.14))*v3 + 0.38*sin(0.74*x3)*cos(1.09*x1 + 0.14)*v6,
    dot(x4) = 1.34*v4,
    dot(x5) = (1.19 + 0.16*0.82*sin(x6)/(1.50 + cos(x2)))*v5 - 0.14*cos(0.73*x3 + 0.41*x3)*v2,
    dot(x6) = 1.21*v6 + 0.24*sin(0.71*x3 + 0.90)*v2,
)]
#[inertia(diag(1.39, (1.35 - 0.27*x3/(1 + powi(x3, 2))), 1.03, (1.06 - 0.35*atan2(x6, 2 + cos(x2))/2), (1.16 - 0.31*x2/(1 + powi(x2, 2))), (1.06 + 0.26*cos(1.03*x1))))]
#[forces(
    p1*v5*v3*sin(0.99*x6 - 0.63*x2)*cos(0.43*x3 - 0.66*x3),
    0,
    0.82*v6,
    0.64*powi(v4, 2) + p1*x5 + 0.87*v4,
    0,
    0,
)]
#[potential_energy(atan2(x2, 2 + cos(x4))/2)]
#[constraint(row1: (1.50 - 0.22*sin(1.01*x5 + 0.90*x6 + 0.59))*v1 - 0.20*sin(0.86*x5)*v4 + 0.33*tan(0.86*sin(x2))/2*v3 - 0.39*cos(0.79*x3 + 0.73) == 0)]
#[independent(v5, v6, v2, v3, v4)]
#[output(place = atan2(x6, 2 + cos(x6))/2, power = v1*sqrt(2 + powi(v6, 2)) + 0.87*powi(v1, 2) + p1*v5*v4*0.58*sin(x2)/(1.50 + cos(x2)), push = sin(p1*x3 - 0.51)*dot(v2) + v1*ddot(x1), pull = (1.14 + 0.19*sin(1.08*x6))*reaction(row1) - push, share = pull/(1.01 + powi(reaction(row1), 2)))]
pub struct Random221 {
    #[nominal(1.04)]
    pub p1: f64,
    #[nominal(1.31)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[inertia(matrix(
    [((1.30 + 0.27*cos(1.09*x1)))*((1.30 + 0.27*cos(1.09*x1)))],
))]
#[forces(
    1.55*dot(x1) - dot(x1)*dot(x1)/(1.33 - 0.17*sin(1.05*x1 - 1.24)) - dot(x1)*sqrt(2 + powi(dot(x1), 2)) - p1*dot(x1)*dot(x1)*exp(-powi(x1, 2)/2),
)]
#[potential_energy(sin(0.84*x1))]
#[constraint(row1: 1.60*x1 + 0.21*sin(x1) + 0.48 == 0)]
#[output(place = sin(0.73*x1 + 0.70*x1), power = p1*exp(0.20*x1) - 1.74*dot(x1)/(1 + powi(x1, 2)), push = ln(1.60 + 0.33*cos(x1))*ddot(x1) + dot(x1)*ddot(x1), pull = 1.03*reaction(row1) - push, share = pull/(1.03 + powi(reaction(row1), 2)))]
pub struct Random222 {
    #[nominal(1.37)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[inertia(diag(1.28))]
#[forces(
    1.82*powi(dot(x1), 2) + p1*dot(x1)*dot(x1)*sin(0.94*x1),
)]
#[constraint(row1: 1.74*dot(x1) == 0)]
pub struct Random223 {
    #[nominal(1.11)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = (1.21 + 0.24*1/sqrt(1.50 + powi(x2, 2)))*dot(x1) - 0.19*x2/(1 + powi(x2, 2))*dot(x2) + 0.38*powi(cos(1.20*x2 + 1.31), 3),
    v2 = (1.23 + 0.22*tan(0.59*sin(x2))/2)*dot(x2) + 0.12*atan2(t, 2 + cos(x1))/2,
)]
#[inertia(diag((1.03 - 0.30*x2/(1 + powi(x2, 2))), (1.30 + 0.28*x2/(1 + powi(x2, 2)))))]
#[forces(
    p1*1.85,
    p1*0.67 - 0.47*sin(0.88*t - 0.63) - v2*sqrt(2 + powi(v1, 2)) - 1.41*powi(cos(0.94*x2), 3),
)]
#[constraint(height: 1.45*x1 + 0.16*sin(x1) + 0.30*sin(0.90*t) - 0.53 == 0)]
#[constraint(first: (1.50 - 0.26*ln(1.60 + 0.81*cos(x2)))*v2 + 0.34*0.77*sin(x2)/(1.50 + cos(x1))*v1 == 0)]
#[constraint(second: 1.45*dot(x1) + 0.16*cos(x1)*dot(x1) + 0.30*0.90*cos(0.90*t) - 0.50*sin(1.19*x2 + 0.25*x2 + 0.24)*((1.50 - 0.26*ln(1.60 + 0.81*cos(x2)))*v2 + 0.34*0.77*sin(x2)/(1.50 + cos(x1))*v1) == 0)]
pub struct Random225 {
    #[nominal(1.23)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    dot(x1) = 1.17*v1 + 0.24*exp(-powi(x3, 2)/2)*v5 + 0.55*cos(1.16*x1),
    dot(x2) = 1.30*v2 - 0.27*sin(0.41*x4)*v4 + 0.44*sin(0.54*x3 - 0.77*x4 + 0.59)*cos(0.65*x3 + 0.50*x5),
    dot(x3) = v3 - 0.11*cos(0.97*x4)*v4 + 0.37*sin(0.59*x3 - 0.65),
    dot(x4) = 1.35*v4 + 0.17*tan(0.48*sin(x2))/2*v6 - 0.18*exp(-powi(x3, 2)/2),
    dot(x5) = (1.09 - 0.18*sin(p2*x6 - 0.57))*v5 - 0.27*0.59*sin(x2)/(1.50 + cos(x2))*v6 + 0.19*cos(0.78*x2),
    dot(x6) = v6 + 0.55*tan(0.50*sin(x3))/2,
)]
#[define(l11 = (1.03 - 0.15*sin(1.10*x2 - 0.64*x6)), l22 = (1.11 + 0.33*cos(1.06*x6 - 0.40*x3)), l32 = 0.16*cos(0.96*x6 - 0.22*x2 + 1.30), l33 = 1.37, l41 = 0.17*sin(0.84*x3 - 0.23*x3 + 0.33), l42 = 0.20*x5/(1 + powi(x5, 2)), l43 = 0.21*sin(0.64*x6 - 0.43*x4)*cos(1.19*x2 - 0.22*x2), l44 = (1.11 - 0.14*powi(cos(1.10*x4 - 0.23*x2), 3)), l52 = 0.12*sin(0.91*x2 - 0.50)*cos(1.01*x4 - 0.34*x4 + 0.97), l53 = 0.36*sin(p1*x1 - 0.78), l54 = 0.17*sin(p1*x3 + 0.94), l55 = (1.07 - 0.22*sin(0.51*x5 + 0.74*x1)), l61 = 0.31*0.63*sin(x1)/(1.50 + cos(x1)), l66 = (1.16 + 0.35*atan2(x4, 2 + cos(x3))/2))]
#[inertia(matrix(
    [l11*l11, 0, 0, l11*l41, 0, l11*l61],
    [_, l22*l22, l22*l32, l22*l42, l22*l52, 0],
    [_, _, l32*l32 + l33*l33, l32*l42 + l33*l43, l32*l52 + l33*l53, 0],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44, l42*l52 + l43*l53 + l44*l54, l41*l61],
    [_, _, _, _, l52*l52 + l53*l53 + l54*l54 + l55*l55, 0],
    [_, _, _, _, _, l61*l61 + l66*l66],
))]
#[forces(
    p1*exp(0.20*x6) + v1*sqrt(2 + powi(v2, 2)),
    p1*exp(0.20*x6) - p2*v1*v5*x6/(1 + powi(x6, 2)) - p2*x3,
    0.53*v5 - 1.57*powi(v4, 2) - 1.30*v1,
    p1*exp(0.20*x6) + 0.90*powi(v3, 2) + p1*v3*v3*atan2(x1, 2 + cos(x3))/2 + p2*1.00,
    1.54*powi(v2, 2),
    p1*x3 - 1.23*powi(v5, 2) - v2*v1/(1.23 + 0.25*0.61*sin(x4)/(1.50 + cos(x3))) - 1.97*v2/(1 + powi(x1, 2)),
)]
#[configuration(x2 = 1.00*x1/(1 + powi(x1, 2)))]
#[constraint(held_x2: x2 - (1.00*x1/(1 + powi(x1, 2))) == 0)]
pub struct Random226 {
    #[nominal(1.37)]
    pub p1: f64,
    #[nominal(1.25)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inputs(tau)]
#[inertia(matrix(
    [(1.21)*(1.21), (1.21)*(0.37*exp(-powi(x2, 2)/2)), (1.21)*(0.36*ln(1.60 + 0.46*cos(x1))), (1.21)*(0.25*sin(0.70*x2)*cos(0.45*x4 - 0.41*x1 + 1.04)), 0, (1.21)*(0.11*tan(0.71*sin(x4))/2)],
    [_, (0.37*exp(-powi(x2, 2)/2))*(0.37*exp(-powi(x2, 2)/2)) + (1.37)*(1.37), (0.37*exp(-powi(x2, 2)/2))*(0.36*ln(1.60 + 0.46*cos(x1))) + (1.37)*(0.15*exp(-powi(x1, 2)/2)), (0.37*exp(-powi(x2, 2)/2))*(0.25*sin(0.70*x2)*cos(0.45*x4 - 0.41*x1 + 1.04)), (1.37)*(0.11*ln(1.60 + 0.72*cos(x4))), (0.37*exp(-powi(x2, 2)/2))*(0.11*tan(0.71*sin(x4))/2)],
    [_, _, (0.36*ln(1.60 + 0.46*cos(x1)))*(0.36*ln(1.60 + 0.46*cos(x1))) + (0.15*exp(-powi(x1, 2)/2))*(0.15*exp(-powi(x1, 2)/2)) + (1.07)*(1.07), (0.36*ln(1.60 + 0.46*cos(x1)))*(0.25*sin(0.70*x2)*cos(0.45*x4 - 0.41*x1 + 1.04)), (0.15*exp(-powi(x1, 2)/2))*(0.11*ln(1.60 + 0.72*cos(x4))) + (1.07)*(0.37*ln(1.60 + 0.53*cos(x4))), (0.36*ln(1.60 + 0.46*cos(x1)))*(0.11*tan(0.71*sin(x4))/2) + (1.07)*(0.13*sin(1.04*x5 + 0.66*x4 - 1.37)*cos(0.44*x6 - 0.34*x6 - 0.98))],
    [_, _, _, (0.25*sin(0.70*x2)*cos(0.45*x4 - 0.41*x1 + 1.04))*(0.25*sin(0.70*x2)*cos(0.45*x4 - 0.41*x1 + 1.04)) + (1.04)*(1.04), (1.04)*(0.22*cos(1.14*x4)), (0.25*sin(0.70*x2)*cos(0.45*x4 - 0.41*x1 + 1.04))*(0.11*tan(0.71*sin(x4))/2) + (1.04)*(0.11*sin(0.84*x5))],
    [_, _, _, _, (0.11*ln(1.60 + 0.72*cos(x4)))*(0.11*ln(1.60 + 0.72*cos(x4))) + (0.37*ln(1.60 + 0.53*cos(x4)))*(0.37*ln(1.60 + 0.53*cos(x4))) + (0.22*cos(1.14*x4))*(0.22*cos(1.14*x4)) + ((1.36 + 0.14*ln(1.60 + 0.83*cos(x3))))*((1.36 + 0.14*ln(1.60 + 0.83*cos(x3)))), (0.37*ln(1.60 + 0.53*cos(x4)))*(0.13*sin(1.04*x5 + 0.66*x4 - 1.37)*cos(0.44*x6 - 0.34*x6 - 0.98)) + (0.22*cos(1.14*x4))*(0.11*sin(0.84*x5)) + ((1.36 + 0.14*ln(1.60 + 0.83*cos(x3))))*(0.30*1/sqrt(1.50 + powi(x4, 2)))],
    [_, _, _, _, _, (0.11*tan(0.71*sin(x4))/2)*(0.11*tan(0.71*sin(x4))/2) + (0.13*sin(1.04*x5 + 0.66*x4 - 1.37)*cos(0.44*x6 - 0.34*x6 - 0.98))*(0.13*sin(1.04*x5 + 0.66*x4 - 1.37)*cos(0.44*x6 - 0.34*x6 - 0.98)) + (0.11*sin(0.84*x5))*(0.11*sin(0.84*x5)) + (0.30*1/sqrt(1.50 + powi(x4, 2)))*(0.30*1/sqrt(1.50 + powi(x4, 2))) + ((1.00 + 0.29*atan2(x2, 2 + cos(x1))/2))*((1.00 + 0.29*atan2(x2, 2 + cos(x1))/2))],
))]
#[forces(
    p1*exp(0.20*x2) + 1.97*sin(p1*x5 - 0.10) + p1*exp(0.20*x5) + dot(x4)*sqrt(2 + powi(dot(x3), 2)),
    p2*exp(0.20*x2) - 1.43*dot(x5)/(1 + powi(x2, 2)) - 1.69*cos(0.48*x5 - 0.72*x5),
    tau*1.65,
    dot(x2)*dot(x4)/1.29 + p2*exp(0.20*x6) + dot(x1)*dot(x6)/1.01 + 0.38*dot(x5)/(1 + powi(x5, 2)),
    dot(x4)*sqrt(2 + powi(dot(x4), 2)) + 1.43*dot(x3)/(1 + powi(x3, 2)) + 1.73*dot(x5)/(1 + powi(x4, 2)),
    0.62*dot(x5)/(1 + powi(x5, 2)) + 1.82*tan(0.88*sin(x5))/2 + p2*exp(0.20*x4) + 0.67*dot(x6)/(1 + powi(x3, 2)),
)]
#[potential_energy(cos(0.74*x6 + 0.20*x3))]
#[configuration(of(q1, q2, q3), x5 = 1.25*q1, x6 = 1.25*q2, x3 = 1.25*q3, x1 = sin(0.72*q2 + 0.62*q1)*cos(0.98*q3 + 0.63*q2), x4 = tan(0.73*sin(q3))/2, x2 = 1/sqrt(1.50 + powi(q2, 2)))]
#[constraint(held_x1: x1 - (sin(0.72*(x6/1.25) + 0.62*(x5/1.25))*cos(0.98*(x3/1.25) + 0.63*(x6/1.25))) == 0)]
#[constraint(held_x4: x4 - (tan(0.73*sin((x3/1.25)))/2) == 0)]
#[constraint(held_x2: x2 - (1/sqrt(1.50 + powi((x6/1.25), 2))) == 0)]
pub struct Random227 {
    #[nominal(1.37)]
    pub p1: f64,
    #[nominal(1.16)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[define(l11 = (1.09 + 0.19*cos(0.90*x6)), l22 = (1.29 - 0.22*cos(0.65*x1 + 0.72*x5 - 0.24)), l32 = 0.26*atan2(x4, 2 + cos(x1))/2, l33 = (1.16 - 0.13*ln(1.60 + 0.44*cos(x5))), l42 = 0.13*tan(0.44*sin(x1))/2, l43 = 0.20*exp(-powi(x3, 2)/2), l44 = (1.23 - 0.29*exp(-powi(x2, 2)/2)), l51 = 0.13*exp(-powi(x6, 2)/2), l52 = 0.25*sin(0.78*x4 + 0.61*x4)*cos(0.43*x1), l53 = 0.32*exp(-powi(x3, 2)/2), l55 = (1.23 - 0.22*sin(0.67*x6 + 0.73*x1 - 1.07)), l61 = 0.34*sin(0.98*x1), l62 = 0.18*sin(0.90*x1 - 0.54), l63 = 0.16*sin(0.51*t)*cos(1.07*x5 + 0.78), l66 = 1.37)]
#[inertia(matrix(
    [l11*l11, 0, 0, 0, l11*l51, l11*l61],
    [_, l22*l22, l22*l32, l22*l42, l22*l52, l22*l62],
    [_, _, l32*l32 + l33*l33, l32*l42 + l33*l43, l32*l52 + l33*l53, l32*l62 + l33*l63],
    [_, _, _, l42*l42 + l43*l43 + l44*l44, l42*l52 + l43*l53, l42*l62 + l43*l63],
    [_, _, _, _, l51*l51 + l52*l52 + l53*l53 + l55*l55, l51*l61 + l52*l62 + l53*l63],
    [_, _, _, _, _, l61*l61 + l62*l62 + l63*l63 + l66*l66],
))]
#[forces(
    0,
    dot(x6)*sqrt(2 + powi(dot(x2), 2)) + 1.06*atan2(x6, 2 + cos(x6))/2,
    1.61*dot(x3)/(1 + powi(t, 2)),
    0.48*powi(dot(x3), 2) - dot(x4)*sqrt(2 + powi(dot(x4), 2)) - 1.07*dot(x3),
    0.98*dot(x5)/(1 + powi(x5, 2)),
    1.80*dot(x1)/(1 + powi(x3, 2)),
)]
#[configuration(x1 = 0.65*1/sqrt(1.50 + powi(t, 2)))]
#[constraint(held_x1: x1 - (0.65*1/sqrt(1.50 + powi(t, 2))) == 0)]
#[constraint(rolling: 1.57*dot(x6) - 0.26*tan(0.37*sin(x5))/2*dot(x5) - 0.26*exp(-powi(x3, 2)/2)*dot(x2) - 0.35*sin(1.06*x5 - 0.64*x6 + 0.34)*dot(x4) == 0)]
#[independent(dot(x5), dot(x2), dot(x4), dot(x3))]
pub struct Random228 {
    #[nominal(0.75)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    v1 = dot(x1),
    dot(x1) = v1,
)]
#[inertia(diag(1.29))]
#[forces(
    p1*x1,
)]
#[complement(
    w1 = [(1.35 - 0.15*atan2(x1, 2 + cos(x1))/2)],
)]
pub struct Random229 {
    #[nominal(1.48)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    dot(x1) = (1.37 - 0.21*x1/(1 + powi(x1, 2)))*v1 - 0.14*1/sqrt(1.50 + powi(x1, 2)),
)]
#[define(l11 = 1.13)]
#[inertia(matrix(
    [l11*l11],
))]
#[forces(
    1.36*v1/(1 + powi(x1, 2)),
)]
#[potential_energy(ln(1.60 + 0.90*cos(x1)))]
#[independent(v1)]
#[output(place = ln(1.60 + 0.32*cos(x1)), power = p1*exp(0.20*x1) + p3*x1 + 1.40*powi(v1, 2), push = 0.33*sin(x1)/(1.50 + cos(x1))*dot(v1) + v1*ddot(x1))]
pub struct Random230 {
    #[nominal(1.38)]
    pub p1: f64,
    #[nominal(0.96)]
    pub p2: f64,
    #[nominal(1.38)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1)]
#[speeds(v1)]
#[kinematics(
    v1 = (1.26 - 0.26*0.81*sin(x1)/(1.50 + cos(t)))*dot(x1),
)]
#[inertia(diag((1.04 - 0.10*cos(0.40*t - 0.74*x1))))]
#[forces(
    0.42*v1/(1 + powi(t, 2)) + 1.53*v1 + p1*exp(0.20*t),
)]
#[potential_energy(1/sqrt(1.50 + powi(x1, 2)))]
#[constraint(row1: 1.97*x1 + 0.30*sin(0.70*t) - 0.29 == 0)]
#[output(place = cos(0.54*t), power = p1*exp(0.20*x1) + 0.36*v1/(1 + powi(x1, 2)), push = sin(0.47*x1 + 0.47*t + 1.08)*dot(v1) + v1*ddot(x1), pull = 1.31*reaction(row1) - push, share = pull/(1.36 + powi(reaction(row1), 2)))]
pub struct Random231 {
    #[nominal(0.93)]
    pub p1: f64,
    #[nominal(1.32)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    dot(x1) = (1.02 - 0.33*x1/(1 + powi(x1, 2)))*v1 - 0.20*cos(0.65*x6 + 0.35*x1),
    dot(x2) = (1.31 + 0.23*sin(1.02*x2 - 0.66*x4))*v2 - 0.34*sin(0.91*x5 - 0.46*x4)*v4 + 0.36*cos(1.00*x1 + 0.83*x1 + 0.56),
    dot(x3) = (1.34 - 0.28*cos(1.01*x5 + 1.05))*v3 - 0.39*powi(cos(0.85*x6 - 0.92), 3)*v2 - 0.12*sin(1.03*x6),
    dot(x4) = (1.34 + 0.21*sin(1.00*x4))*v4 - 0.20*sin(1.04*x4 + 0.62*x4)*v3 - 0.56*cos(0.91*x3),
    dot(x5) = (1.39 + 0.25*x5/(1 + powi(x5, 2)))*v5 + 0.13*sin(p1*x5 + 0.88)*v6 - 0.19*cos(0.44*x3),
    dot(x6) = (1.23 + 0.30*x2/(1 + powi(x2, 2)))*v6 + 0.43*0.41*sin(x5)/(1.50 + cos(x6)),
)]
#[inertia(matrix(
    [((1.36 - 0.12*tan(0.90*sin(x2))/2))*((1.36 - 0.12*tan(0.90*sin(x2))/2)), 0, ((1.36 - 0.12*tan(0.90*sin(x2))/2))*(0.22*0.82*sin(x1)/(1.50 + cos(x5))), 0, 0, ((1.36 - 0.12*tan(0.90*sin(x2))/2))*(0.34*cos(1.18*x5))],
    [_, (1.26)*(1.26), (1.26)*(0.11*sin(p1*x1 - 0.95)), 0, (1.26)*(0.16*sin(0.51*x6)), 0],
    [_, _, (0.22*0.82*sin(x1)/(1.50 + cos(x5)))*(0.22*0.82*sin(x1)/(1.50 + cos(x5))) + (0.11*sin(p1*x1 - 0.95))*(0.11*sin(p1*x1 - 0.95)) + (1.09)*(1.09), (1.09)*(0.20*0.85*sin(x2)/(1.50 + cos(x5))), (0.11*sin(p1*x1 - 0.95))*(0.16*sin(0.51*x6)) + (1.09)*(0.11*0.31*sin(x3)/(1.50 + cos(x1))), (0.22*0.82*sin(x1)/(1.50 + cos(x5)))*(0.34*cos(1.18*x5)) + (1.09)*(0.30*x3/(1 + powi(x3, 2)))],
    [_, _, _, (0.20*0.85*sin(x2)/(1.50 + cos(x5)))*(0.20*0.85*sin(x2)/(1.50 + cos(x5))) + (1.30)*(1.30), (0.20*0.85*sin(x2)/(1.50 + cos(x5)))*(0.11*0.31*sin(x3)/(1.50 + cos(x1))), (0.20*0.85*sin(x2)/(1.50 + cos(x5)))*(0.30*x3/(1 + powi(x3, 2))) + (1.30)*(0.21*exp(-powi(x2, 2)/2))],
    [_, _, _, _, (0.16*sin(0.51*x6))*(0.16*sin(0.51*x6)) + (0.11*0.31*sin(x3)/(1.50 + cos(x1)))*(0.11*0.31*sin(x3)/(1.50 + cos(x1))) + ((1.03 + 0.24*sin(p1*x3 - 0.25)))*((1.03 + 0.24*sin(p1*x3 - 0.25))), (0.11*0.31*sin(x3)/(1.50 + cos(x1)))*(0.30*x3/(1 + powi(x3, 2))) + ((1.03 + 0.24*sin(p1*x3 - 0.25)))*(0.26*tan(0.91*sin(x1))/2)],
    [_, _, _, _, _, (0.34*cos(1.18*x5))*(0.34*cos(1.18*x5)) + (0.30*x3/(1 + powi(x3, 2)))*(0.30*x3/(1 + powi(x3, 2))) + (0.21*exp(-powi(x2, 2)/2))*(0.21*exp(-powi(x2, 2)/2)) + (0.26*tan(0.91*sin(x1))/2)*(0.26*tan(0.91*sin(x1))/2) + ((1.17 + 0.17*cos(0.63*x3 - 0.57)))*((1.17 + 0.17*cos(0.63*x3 - 0.57)))],
))]
#[forces(
    p1*x5 + p1*v2*v1*sin(1.10*x5 + 0.34) + v2*sqrt(2 + powi(v1, 2)),
    0,
    p1*exp(0.20*x4),
    0.63*v5 - p1*1.11,
    p1*v2*v4*exp(-powi(x3, 2)/2) + v1*v6/(1.00 + 0.26*x6/(1 + powi(x6, 2))),
    1.21*tan(0.64*sin(x1))/2 - v2*sqrt(2 + powi(v5, 2)) - 1.79*v4,
)]
#[potential_energy(tan(0.97*sin(x4))/2)]
#[constraint(row1: powi(v5, 2) + 0.26*powi(v3, 2) - (2 + 0.26*atan2(x6, 2 + cos(x2))/2) == 0)]
#[independent(v1, v6, v4, v2, v3, v5)]
#[independent(s1 = (1.50 + 0.28*1/sqrt(1.50 + powi(x1, 2)))*v1 - 0.32*sin(1.12*x3 - 0.21)*cos(0.42*x2 + 0.58*x1), v6, s3 = v4 - 0.29*x1/(1 + powi(x1, 2))*v1, s4 = 1.26*v2 + 0.34*sin(1.05*x6)*v1 + 0.15*powi(cos(1.08*x2), 3)*v6, s5 = (1.50 + 0.26*x5/(1 + powi(x5, 2)))*v3 - 0.23*cos(0.91*x6 - 0.34*x5)*v1 - 0.23*cos(0.98*x1)*v6 - 0.34*sin(p1*x4 - 0.65), v5)]
#[output(place = sin(0.83*x2 + 0.76*x4 - 1.12), power = p1*x5 + p1*x5 + 0.76*powi(v5, 2), push = 0.31*sin(x4)/(1.50 + cos(x5))*dot(v2) + v6*ddot(x6), pull = (1.30 + 0.32*powi(cos(0.57*x6 - 0.67*x1 + 1.10), 3))*reaction(row1) - push, share = pull/(1.47 + powi(reaction(row1), 2)))]
pub struct Random232 {
    #[nominal(1.29)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inertia(diag(1.36, 1.40, 1.21, (1.09 - 0.17*x3/(1 + powi(x3, 2))), (1.02 - 0.12*sin(0.46*x2 - 0.76*x4 + 0.91)), (1.36 + 0.14*atan2(x5, 2 + cos(x6))/2)))]
#[forces(
    0.39*dot(x3)/(1 + powi(x4, 2)),
    p1*dot(x5)*dot(x5)*0.92*sin(x5)/(1.50 + cos(x1)),
    p2*0.50 + p2*x2 + 1.96*dot(x5)/(1 + powi(x6, 2)) + 1.63*dot(x4)/(1 + powi(x3, 2)),
    1.03*atan2(x3, 2 + cos(x5))/2 + 0.66*powi(dot(x1), 2) + p1*x4,
    p1*dot(x1)*dot(x3)*exp(-powi(x4, 2)/2) + 1.73*dot(x6) + 1.99*cos(0.69*x1 - 0.55*x6),
    dot(x3)*sqrt(2 + powi(dot(x2), 2)) - p1*1.68 - 1.49*powi(dot(x5), 2) - p2*x2,
)]
#[constraint(row1: ddot(x3) + 0.27*ln(1.60 + 0.98*cos(x1))*ddot(x4) - 0.15*cos(1.11*x3 + 0.37*x5)*ddot(x1) - 0.61*dot(x1) - 0.61*cos(1.20*x2 + 0.36*x6 - 0.12) == 0)]
#[constraint(row2: ddot(x5) - 0.21*powi(cos(0.43*x6 - 0.85*x5 + 0.97), 3)*ddot(x4) + 0.19*sin(1.10*x4)*ddot(x1) + 0.73*atan2(x1, 2 + cos(x6))/2 == 0)]
#[constraint(row3: (1.50 + 0.12*ln(1.60 + 0.50*cos(x2)))*ddot(x6) - 0.22*tan(0.54*sin(x6))/2*ddot(x4) - 0.15*sin(0.77*x3 + 1.37)*ddot(x1) - 0.77*dot(x5) - 0.77*sin(0.45*x5 - 0.34*x3) == 0)]
#[constraint(row4: ddot(x2) - 0.22*atan2(x6, 2 + cos(x4))/2*ddot(x4) + 0.17*atan2(x4, 2 + cos(x6))/2*ddot(x1) - 0.53*dot(x5)/sqrt(1.20 + powi(dot(x6), 2)) == 0)]
pub struct Random233 {
    #[nominal(1.04)]
    pub p1: f64,
    #[nominal(0.59)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = 1.32*dot(x1) - 0.33*sin(0.56*x2 + 0.58*x2)*dot(x3),
    v2 = 1.34*dot(x2) + 0.16*sin(0.40*x2 + 0.56*x5 + 0.29)*dot(x4),
    v3 = dot(x3) + 0.12*sin(1.10*x4)*dot(x4),
    v4 = 1.31*dot(x4) + 0.26*sin(0.68*x6)*dot(x5),
    v5 = dot(x5) - 0.38*sin(0.59*x4 + 0.44*x2)*dot(x4),
    v6 = (1.15 + 0.20*sin(1.00*x5))*dot(x6),
)]
#[define(l11 = (1.12 + 0.27*sin(1.12*x4)*cos(0.51*x3 - 0.37*x5 - 0.11)), l21 = 0.39*cos(0.93*x1 - 0.57*x5), l22 = 1.36, l31 = 0.24*tan(0.98*sin(x1))/2, l32 = 0.32*atan2(x2, 2 + cos(x5))/2, l33 = (1.07 + 0.32*cos(0.78*x4 + 0.56)), l41 = 0.25*1/sqrt(1.50 + powi(x2, 2)), l43 = 0.24*sin(p1*x1 - 0.22), l44 = (1.00 - 0.19*0.64*sin(x2)/(1.50 + cos(x5))), l55 = 1.37, l62 = 0.36*sin(p2*x5 - 0.47), l63 = 0.33*1/sqrt(1.50 + powi(x6, 2)), l64 = 0.11*cos(0.57*x3), l65 = 0.29*atan2(x2, 2 + cos(x3))/2, l66 = 1.18)]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, l11*l41, 0, 0],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l21*l41, 0, l22*l62],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l33*l43, 0, l32*l62 + l33*l63],
    [_, _, _, l41*l41 + l43*l43 + l44*l44, 0, l43*l63 + l44*l64],
    [_, _, _, _, l55*l55, l55*l65],
    [_, _, _, _, _, l62*l62 + l63*l63 + l64*l64 + l65*l65 + l66*l66],
))]
#[forces(
    p1*1.43 - v4*v3/1.07,
    0.40*v1/(1 + powi(x5, 2)) + 1.39*powi(v5, 2) + v1*sqrt(2 + powi(v4, 2)),
    1.98*v1/(1 + powi(x1, 2)) - p1*1.40 - 1.64*v3,
    1.00*powi(v1, 2) + 1.12*0.70*sin(x6)/(1.50 + cos(x6)) + p1*1.10,
    p1*exp(0.20*x1),
    v5*v3/(1.01 + 0.15*sin(1.19*x3 - 0.39*x5 - 0.54)*cos(0.83*x6)) - p1*x1 - 0.69*atan2(x4, 2 + cos(x2))/2 - p2*exp(0.20*x5),
)]
#[constraint(row1: 1.79*x1 + exp(0.37*x4)/2 - 0.71 == 0)]
#[constraint(row2: 1.17*v6 - 0.29*sin(v6 + sin(0.40*x4 - 0.57*x3 + 0.93)*v4) + 0.49*ln(1.60 + 0.59*cos(x5)) == 0)]
#[output(place = x2/(1 + powi(x2, 2)), power = v4*v4/(1.29 + 0.23*atan2(x4, 2 + cos(x6))/2), push = 0.34*sin(x4)/(1.50 + cos(x6))*dot(v3) + v5*ddot(x5), pull = 1.04*reaction(row1) - push, share = pull/(1.39 + powi(reaction(row1), 2)))]
pub struct Random234 {
    #[nominal(1.13)]
    pub p1: f64,
    #[nominal(0.93)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    dot(x1) = (1.29 + 0.16*ln(1.60 + 0.73*cos(x1)))*v1 - 0.13*cos(0.45*x1 + 0.34*x1 + 0.73)*v2,
    dot(x2) = v2,
)]
#[define(l11 = 1.04, l21 = 0.35*sin(1.07*x2 + 0.71*x2 - 1.41), l22 = 1.10)]
#[inertia(matrix(
    [l11*l11, l11*l21],
    [_, l21*l21 + l22*l22],
))]
#[forces(
    1.24*v1/(1 + powi(x2, 2)),
    p2*x2 + 1.28*powi(v2, 2) + p2*1.30,
)]
#[potential_energy(sin(0.44*x2))]
#[constraint(row1: v1 == 0)]
#[constraint(row2: 1.55*dot(v2) + 0.28*cos(0.95*x1)*dot(v1) - 0.33*v2/sqrt(1.20 + powi(v1, 2)) == 0)]
pub struct Random235 {
    #[nominal(1.41)]
    pub p1: f64,
    #[nominal(1.11)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1) - 0.20*ln(1.60 + 0.84*cos(x4))*dot(x5) - 0.47*cos(1.14*x6 + 0.57*x2 - 0.83),
    v2 = dot(x2) + 0.40*x4/(1 + powi(x4, 2))*dot(x4) + 0.11*sin(p2*x3 - 0.37),
    v3 = (1.08 + 0.15*sin(p2*x1 - 0.60))*dot(x3) - 0.27*tan(0.82*sin(x1))/2,
    v4 = dot(x4) + 0.19*sin(p3*x3 + 0.39)*dot(x1) + 0.23*0.67*sin(x4)/(1.50 + cos(x6)),
    v5 = dot(x5) - 0.27*tan(0.81*sin(x3))/2,
    v6 = (1.31 + 0.30*cos(1.15*x3 - 0.46))*dot(x6) - 0.33*sin(1.01*x3 + 1.13)*cos(0.57*x2)*dot(x2) + 0.47*sin(p2*x3 - 0.98),
)]
#[inertia(diag(1.08, (1.30 + 0.16*sin(0.72*x4 - 0.10)*cos(0.72*x6 + 0.52*x1 + 0.17)), (1.21 - 0.16*sin(0.79*x6 + 0.83*x5)*cos(0.45*x4 + 0.42)), 1.20, (1.17 - 0.34*x4/(1 + powi(x4, 2))), (1.25 + 0.20*powi(cos(0.54*x4), 3))))]
#[forces(
    1.64*v3/(1 + powi(x4, 2)),
    p1*x6,
    p3*v4*v6*exp(-powi(x6, 2)/2) + p1*v1*v4*sin(0.72*x3 - 0.86*x3) + 0.44*v5/(1 + powi(x3, 2)) + v4*v4/(1.30 - 0.12*ln(1.60 + 0.30*cos(x6))),
    0,
    p3*1.63 + v4*v1/1.09 + v3*v4/(1.30 - 0.28*ln(1.60 + 0.56*cos(x6))),
    p1*exp(0.20*x4) + p3*x2 + 1.93*v1/(1 + powi(x4, 2)),
)]
#[constraint(row1: 1.43*x5 + 0.11*sin(x5) + 0.36*sin(x2) + 0.13*x4*x4 + 0.39 == 0)]
#[constraint(row2: 1.44*v6 + 0.16*sin(1.20*x4)*cos(0.68*x5 - 0.25*x3)*v2 - 0.25*exp(-powi(x6, 2)/2)*v4 == 0)]
#[constraint(row3: 1.33*v3 - 0.18*sin(v3 + atan2(x1, 2 + cos(x6))/2*v2) + 0.21*sin(1.11*x3 + 0.34*x3 + 1.35) == 0)]
#[constraint(row4: dot(v1) + 0.25*sin(0.77*x3)*dot(v2) + 0.19*cos(0.74*x2)*dot(v4) - 0.75*v2 - 0.75*sin(0.59*x5 + 0.22*x2) == 0)]
#[independent(v4, v2, v1, v3)]
#[independent(s1 = v4 + 0.32*ln(1.60 + 0.65*cos(x6))*v5 - 0.52*exp(-powi(x5, 2)/2), s2 = (1.50 - 0.12*atan2(x6, 2 + cos(x4))/2)*v2 + 0.15*ln(1.60 + 0.35*cos(x3))*v4, v1, s4 = 1.19*v3 - 0.18*atan2(x1, 2 + cos(x2))/2*v4 + 0.13*cos(0.75*x5)*v2)]
pub struct Random236 {
    #[nominal(0.87)]
    pub p1: f64,
    #[nominal(1.22)]
    pub p2: f64,
    #[nominal(1.45)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[inputs(tau)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + tan(0.33*sin(x1))/2*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - tan(0.33*sin(x1))/2*(v1),
)]
#[inertia(diag((1.36 - 0.22*cos(0.88*x1)), 1.24))]
#[forces(
    tau*0.35 - 1.43*v2 - p1*v1*v1*sin(0.63*x1),
    v1*v2/(1.30 - 0.19*cos(0.60*x2 - 0.76*x1)) + 0.85*v1/(1 + powi(x1, 2)),
)]
#[potential_energy(cos(1.06*x1 - 0.39*x1))]
#[constraint(row1: 1.63*x2 + 0.31*x1 + 0.46 == 0)]
#[constraint(again1: 0.64*(1.63*x2 + 0.31*x1 + 0.46) == 0, redundant)]
#[constraint(again2: 0.89*(1.63*x2 + 0.31*x1 + 0.46) == 0, redundant)]
pub struct Random237 {
    #[nominal(1.08)]
    pub p1: f64,
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
#[constraint(held_x1: x1 - (sin(0.74*(x3/1.25))) == 0)]
pub struct Random27Whole {
    #[nominal(1.05)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[inertia(diag((1.17 - 0.21*sin(0.86*t - 0.44*x2)*cos(1.10*x3 - 0.74*x2)), (1.00 - 0.27*0.60*sin(x1)/(1.50 + cos(x3))), 1.00))]
#[forces(
    p2*x2 + 0.40*dot(x2)/(1 + powi(x1, 2)) + p2*0.68 + dot(x2)*sqrt(2 + powi(dot(x1), 2)),
    0,
    dot(x1)*sqrt(2 + powi(dot(x2), 2)) - 1.59*dot(x3),
)]
#[constraint(held_x3: x3 - (0.68*cos(1.10*x2)) == 0)]
#[constraint(held_x1: x1 - (1.15*sin(0.99*x2 + 0.50*x2 - 1.40)) == 0)]
#[constraint(bound: powi(dot(x2), 2) + 0.19*powi(dot(x3), 2) - (2 + 0.19*sin(0.56*x1)*cos(1.00*x3)) == 0)]
#[output(place = cos(0.96*x1 + 0.25*x1), power = p2*x1, push = sin(0.66*x1 - 0.23*x1 + 1.20)*ddot(x2) + dot(x3)*ddot(x3), pull = 1.26*reaction(held_x3) - push, share = pull/(1.72 + powi(reaction(held_x3), 2)))]
pub struct Random39Whole {
    #[nominal(1.14)]
    pub p1: f64,
    #[nominal(1.27)]
    pub p2: f64,
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
#[constraint(held_x1: x1 - (0.90*1/sqrt(1.50 + powi(x2, 2))) == 0)]
#[constraint(held_x3: x3 - (1.30*1/sqrt(1.50 + powi(x4, 2))) == 0)]
#[constraint(rolling: 1.30*dot(x4) + 0.30*atan2(x2, 2 + cos(x4))/2*dot(x2) == 0)]
pub struct Random48Whole {
    #[nominal(1.21)]
    pub p1: f64,
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
#[constraint(held_x5: x5 - (cos(0.89*(x2/1.25))) == 0)]
#[constraint(held_x1: x1 - (cos(0.58*(x3/1.25))) == 0)]
#[output(place = cos(0.88*x4 + 0.82*x3 - 0.38), power = 0.48*powi(v5, 2) - p1*v2*v5*tan(0.89*sin(x5))/2 - 0.73*0.48*sin(x1)/(1.50 + cos(x4)) - v3*v1/(1.10 + 0.30*0.56*sin(x2)/(1.50 + cos(x5))), push = cos(1.19*x2)*dot(v4) + v4*ddot(x4), pull = (1.36 + 0.32*1/sqrt(1.50 + powi(x2, 2)))*reaction(held_x5) - push, share = pull/(1.58 + powi(reaction(held_x5), 2)))]
pub struct Random67Whole {
    #[nominal(0.50)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + tan(0.56*sin(x6))/2*dot(x1),
    v3 = dot(x3) + atan2(x6, 2 + cos(x4))/2*dot(x1),
    v4 = dot(x4) + tan(0.67*sin(x3))/2*dot(x3),
    v5 = dot(x5) + sin(0.81*x6 + 0.84*x6)*dot(x2),
    v6 = dot(x6) + sin(0.87*x6)*dot(x4),
    dot(x1) = v1,
    dot(x2) = v2 - tan(0.56*sin(x6))/2*(v1),
    dot(x3) = v3 - atan2(x6, 2 + cos(x4))/2*(v1),
    dot(x4) = v4 - tan(0.67*sin(x3))/2*(v3 - atan2(x6, 2 + cos(x4))/2*(v1)),
    dot(x5) = v5 - sin(0.81*x6 + 0.84*x6)*(v2 - tan(0.56*sin(x6))/2*(v1)),
    dot(x6) = v6 - sin(0.87*x6)*(v4 - tan(0.67*sin(x3))/2*(v3 - atan2(x6, 2 + cos(x4))/2*(v1))),
)]
#[inertia(diag(1.31, (1.37 + 0.21*1/sqrt(1.50 + powi(x4, 2))), (1.23 - 0.19*sin(0.43*x3 + 0.76*x5 - 1.38)), (1.29 + 0.28*tan(0.65*sin(x3))/2), (1.20 + 0.32*atan2(x2, 2 + cos(x5))/2), 1.20))]
#[forces(
    v4*sqrt(2 + powi(v1, 2)),
    v2*v3/(1.07 - 0.26*sin(0.64*x3 + 0.87*x3)),
    p3*v3*v1*1/sqrt(1.50 + powi(x2, 2)) - 0.54*powi(v4, 2) - p1*1.49,
    1.89*v1/(1 + powi(x4, 2)) + 1.64*v1/(1 + powi(x2, 2)),
    1.01*ln(1.60 + 0.79*cos(x1)) + 1.66*v4 + p1*1.12,
    1.97*v2/(1 + powi(x5, 2)) - v1*sqrt(2 + powi(v6, 2)),
)]
#[constraint(held_x6: x6 - (0.95*sin(0.86*x1)) == 0)]
#[constraint(held_x2: x2 - (0.66*ln(1.60 + 0.81*cos(x4))) == 0)]
#[constraint(rolling: (1.50 - 0.14*cos(0.96*x4 - 0.49*x5))*dot(x3) + 0.32*atan2(x5, 2 + cos(x3))/2*dot(x1) + 0.20*cos(1.20*x1 + 0.31*x4)*dot(x4) - 0.12*tan(0.65*sin(x4))/2*dot(x5) == 0)]
#[output(place = ln(1.60 + 0.96*cos(x4)), power = p3*x1 + v4*v5/1.24 + 1.02*v2/(1 + powi(x4, 2)) + 1.04*cos(0.50*x1 - 0.30*x6 - 0.22), push = x3/(1 + powi(x3, 2))*dot(v5) + v3*ddot(x3), pull = (1.23 + 0.12*exp(-powi(x5, 2)/2))*reaction(held_x2) - push, share = pull/(1.52 + powi(reaction(held_x2), 2)))]
pub struct Random88Whole {
    #[nominal(0.54)]
    pub p1: f64,
    #[nominal(0.66)]
    pub p2: f64,
    #[nominal(0.96)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[define(l11 = (1.38 + 0.13*1/sqrt(1.50 + powi(x2, 2))), l21 = 0.12*1/sqrt(1.50 + powi(x2, 2)), l22 = 1.18, l31 = 0.32*tan(0.85*sin(x5))/2, l32 = 0.34*sin(0.70*x2 - 1.40)*cos(0.98*x5 + 0.61*x6), l33 = (1.33 + 0.10*sin(0.62*x1)), l41 = 0.24*sin(0.60*x4 + 0.31*x6), l42 = 0.32*sin(p3*x2 + 0.82), l44 = (1.39 + 0.15*1/sqrt(1.50 + powi(x2, 2))), l51 = 0.21*powi(cos(1.10*x5 - 0.78*x3), 3), l54 = 0.32*sin(0.95*x6 - 1.41)*cos(0.73*x3 - 0.47*x2 - 1.36), l55 = 1.31, l61 = 0.30*x1/(1 + powi(x1, 2)), l62 = 0.19*sin(0.72*x4), l63 = 0.11*tan(0.50*sin(x3))/2, l65 = 0.21*tan(0.50*sin(x6))/2, l66 = (1.07 - 0.31*1/sqrt(1.50 + powi(x6, 2))))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, l11*l41, l11*l51, l11*l61],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l21*l41 + l22*l42, l21*l51, l21*l61 + l22*l62],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l32*l42, l31*l51, l31*l61 + l32*l62 + l33*l63],
    [_, _, _, l41*l41 + l42*l42 + l44*l44, l41*l51 + l44*l54, l41*l61 + l42*l62],
    [_, _, _, _, l51*l51 + l54*l54 + l55*l55, l51*l61 + l55*l65],
    [_, _, _, _, _, l61*l61 + l62*l62 + l63*l63 + l65*l65 + l66*l66],
))]
#[forces(
    0.84*powi(dot(x6), 2),
    p2*exp(0.20*x2) - 0.35*atan2(x1, 2 + cos(x4))/2 - 0.97*dot(x6)/(1 + powi(x3, 2)) - dot(x6)*dot(x4)/(1.22 - 0.20*sin(p2*x5 + 0.48)),
    0.78*dot(x1)/(1 + powi(x6, 2)) + p3*dot(x2)*dot(x2)*tan(0.69*sin(x3))/2,
    p2*0.58 + 1.20*dot(x6),
    0,
    1.11*x3/(1 + powi(x3, 2)) - 1.68*powi(dot(x3), 2) - 1.77*dot(x5)/(1 + powi(x5, 2)),
)]
#[constraint(held_x6: x6 - (1.03*tan(0.57*sin(x4))/2) == 0)]
#[constraint(held_x2: x2 - (1.42*exp(-powi(x3, 2)/2)) == 0)]
#[constraint(bound: 1.60*dot(x1) + 0.29*cos(0.69*x6)*dot(x3)*dot(x3) + 0.25*tan(0.95*sin(x1))/2 == 0)]
pub struct Random119Whole {
    #[nominal(0.92)]
    pub p1: f64,
    #[nominal(1.38)]
    pub p2: f64,
    #[nominal(1.43)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    v1 = dot(x1) - 0.38*sin(0.61*t + 0.73*x1)*dot(x2),
    v2 = 1.35*dot(x2) + 0.28*powi(cos(0.82*x3), 3)*dot(x3),
    v3 = (1.15 + 0.13*exp(-powi(t, 2)/2))*dot(x3),
)]
#[inertia(matrix(
    [(1.32)*(1.32), (1.32)*(0.23*exp(-powi(t, 2)/2)), 0],
    [_, (0.23*exp(-powi(t, 2)/2))*(0.23*exp(-powi(t, 2)/2)) + ((1.33 - 0.26*1/sqrt(1.50 + powi(x2, 2))))*((1.33 - 0.26*1/sqrt(1.50 + powi(x2, 2)))), 0],
    [_, _, (1.04)*(1.04)],
))]
#[forces(
    1.91*v2 - v2*sqrt(2 + powi(v1, 2)) - 1.53*v1,
    0.86*v3/(1 + powi(x1, 2)),
    0,
)]
#[constraint(held_x2: x2 - (1.08*ln(1.60 + 0.45*cos(x3))) == 0)]
#[constraint(bound: (1.50 + 0.17*sin(p1*x2 - 0.23))*dot(v3) - 0.11*ln(1.60 + 0.44*cos(x1))*dot(v1) + 0.20*sin(p1*t - 0.19)*dot(v2) - 0.63*sin(p1*x2 + 0.69) == 0)]
pub struct Random139Whole {
    #[nominal(0.74)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[speeds(v1, v2)]
#[kinematics(
    v1 = dot(x1),
    v2 = dot(x2) + powi(cos(1.15*x2 + 0.70*x2), 3)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - powi(cos(1.15*x2 + 0.70*x2), 3)*(v1),
)]
#[inertia(diag((1.16 - 0.26*exp(-powi(x2, 2)/2)), (1.09 - 0.28*tan(0.35*sin(x1))/2)))]
#[forces(
    0,
    p2*v1*v2*sin(1.07*x1 + 0.71*x1 + 0.97),
)]
#[constraint(held_x1: x1 - (1.14*x2/(1 + powi(x2, 2))) == 0)]
#[output(place = exp(-powi(x1, 2)/2), power = 1.01*v1/(1 + powi(x1, 2)), push = powi(cos(0.59*x1 - 0.37*x2), 3)*dot(v1) + v2*ddot(x2), pull = 1.10*reaction(held_x1) - push, share = pull/(1.50 + powi(reaction(held_x1), 2)))]
pub struct Random146Whole {
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
    v2 = dot(x2) + exp(-powi(x2, 2)/2)*dot(x1),
    dot(x1) = v1,
    dot(x2) = v2 - exp(-powi(x2, 2)/2)*(v1),
)]
#[inertia(matrix(
    [((1.39 + 0.29*0.81*sin(x1)/(1.50 + cos(x1))))*((1.39 + 0.29*0.81*sin(x1)/(1.50 + cos(x1)))), ((1.39 + 0.29*0.81*sin(x1)/(1.50 + cos(x1))))*(0.22*tan(0.62*sin(x1))/2)],
    [_, (0.22*tan(0.62*sin(x1))/2)*(0.22*tan(0.62*sin(x1))/2) + (1.19)*(1.19)],
))]
#[forces(
    v1*sqrt(2 + powi(v1, 2)),
    p1*v2*v2*ln(1.60 + 0.46*cos(x2)) - 0.39*v1/(1 + powi(x2, 2)) - 0.44*powi(v2, 2),
)]
#[constraint(held_x2: x2 - ((x1/1.25)/(1 + powi((x1/1.25), 2))) == 0)]
pub struct Random147Whole {
    #[nominal(1.30)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2)]
#[define(l11 = 1.11, l22 = (1.31 - 0.28*ln(1.60 + 0.69*cos(x1))))]
#[inertia(matrix(
    [l11*l11, 0],
    [_, l22*l22],
))]
#[forces(
    0.88*powi(dot(x1), 2),
    dot(x2)*dot(x1)/(1.10 - 0.19*exp(-powi(x1, 2)/2)) - 0.86*dot(x1)/(1 + powi(x1, 2)) - p2*x2 - p2*x1,
)]
#[potential_energy(sin(0.52*x2 + 0.87*x2 + 0.32))]
#[constraint(held_x1: x1 - (1.26*ln(1.60 + 0.97*cos(x2))) == 0)]
pub struct Random148Whole {
    #[nominal(1.31)]
    pub p1: f64,
    #[nominal(1.47)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    dot(x1) = (1.18 - 0.26*exp(-powi(x3, 2)/2))*v1 + 0.23*ln(1.60 + 0.76*cos(x4))*v3 + 0.31*powi(cos(0.97*x1 - 0.26*x2), 3),
    dot(x2) = (1.25 + 0.33*0.58*sin(x2)/(1.50 + cos(x2)))*v2 - 0.22*sin(1.07*x3)*cos(0.95*x1 + 0.39*x1),
    dot(x3) = (1.32 - 0.27*1/sqrt(1.50 + powi(x1, 2)))*v3 + 0.34*sin(p3*x2 + 0.15),
    dot(x4) = 1.22*v4 - 0.35*sin(0.85*x4)*v2 + 0.60*atan2(x2, 2 + cos(x4))/2,
)]
#[inertia(matrix(
    [(1.26)*(1.26), (1.26)*(0.39*sin(0.90*x4 + 1.14)), (1.26)*(0.39*cos(1.15*x3 + 0.88*x1 - 0.64)), (1.26)*(0.40*tan(0.98*sin(x4))/2)],
    [_, (0.39*sin(0.90*x4 + 1.14))*(0.39*sin(0.90*x4 + 1.14)) + (1.20)*(1.20), (0.39*sin(0.90*x4 + 1.14))*(0.39*cos(1.15*x3 + 0.88*x1 - 0.64)), (0.39*sin(0.90*x4 + 1.14))*(0.40*tan(0.98*sin(x4))/2)],
    [_, _, (0.39*cos(1.15*x3 + 0.88*x1 - 0.64))*(0.39*cos(1.15*x3 + 0.88*x1 - 0.64)) + ((1.07 - 0.34*exp(-powi(x1, 2)/2)))*((1.07 - 0.34*exp(-powi(x1, 2)/2))), (0.39*cos(1.15*x3 + 0.88*x1 - 0.64))*(0.40*tan(0.98*sin(x4))/2) + ((1.07 - 0.34*exp(-powi(x1, 2)/2)))*(0.32*sin(p1*x2 - 0.17))],
    [_, _, _, (0.40*tan(0.98*sin(x4))/2)*(0.40*tan(0.98*sin(x4))/2) + (0.32*sin(p1*x2 - 0.17))*(0.32*sin(p1*x2 - 0.17)) + ((1.24 + 0.11*cos(1.07*x3 + 0.17)))*((1.24 + 0.11*cos(1.07*x3 + 0.17)))],
))]
#[forces(
    0,
    p1*0.60 - p2*x3 - 0.41*v2/(1 + powi(x3, 2)) - 0.71*powi(v4, 2),
    p3*exp(0.20*x2),
    0.66*x4/(1 + powi(x4, 2)) - v2*sqrt(2 + powi(v3, 2)),
)]
#[constraint(held_x4: x4 - (1.43*tan(0.85*sin(x2))/2) == 0)]
#[constraint(held_x1: x1 - (1.34*sin(0.61*x2 - 0.69*x2)) == 0)]
pub struct Random166Whole {
    #[nominal(1.45)]
    pub p1: f64,
    #[nominal(1.00)]
    pub p2: f64,
    #[nominal(1.18)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = (1.21 - 0.15*sin(0.58*x3 - 0.99))*dot(x1) - 0.11*1/sqrt(1.50 + powi(x4, 2))*dot(x4),
    v2 = 1.04*dot(x2) - 0.34*x1/(1 + powi(x1, 2))*dot(x3),
    v3 = (1.25 - 0.17*exp(-powi(x4, 2)/2))*dot(x3) - 0.23*tan(0.66*sin(x2))/2*dot(x2),
    v4 = dot(x4) - 0.18*0.83*sin(x1)/(1.50 + cos(x2))*dot(x1),
)]
#[define(l11 = (1.14 - 0.26*atan2(x1, 2 + cos(x3))/2), l21 = 0.29*tan(0.34*sin(x2))/2, l22 = (1.25 - 0.27*sin(1.17*x4 - 0.61)), l31 = 0.38*atan2(x3, 2 + cos(x2))/2, l32 = 0.15*atan2(x1, 2 + cos(x4))/2, l33 = (1.33 + 0.34*sin(p1*x1 + 0.41)), l41 = 0.11*x4/(1 + powi(x4, 2)), l42 = 0.35*sin(0.50*x2 - 0.56), l43 = 0.26*cos(0.42*x2 + 0.34*x2), l44 = (1.18 - 0.22*cos(1.18*x4 - 0.32*x3)))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, l11*l41],
    [_, l21*l21 + l22*l22, l21*l31 + l22*l32, l21*l41 + l22*l42],
    [_, _, l31*l31 + l32*l32 + l33*l33, l31*l41 + l32*l42 + l33*l43],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44],
))]
#[forces(
    p2*v4*v3*powi(cos(0.44*x2), 3) - 1.01*powi(v1, 2) - v1*v2/(1.11 + 0.19*1/sqrt(1.50 + powi(x2, 2))),
    0,
    v1*sqrt(2 + powi(v3, 2)) + 1.10*powi(v4, 2) + p3*v3*v2*sin(p1*x2 - 0.16) + p1*exp(0.20*x3),
    1.06*1/sqrt(1.50 + powi(x4, 2)) - 1.87*powi(v1, 2),
)]
#[potential_energy(sin(p2*x2 + 0.69))]
#[constraint(held_x2: x2 - (0.99*sin((x1/1.25))/(1.50 + cos((x1/1.25)))) == 0)]
#[constraint(held_x4: x4 - (0.77*sin((x1/1.25))/(1.50 + cos((x3/1.25)))) == 0)]
#[output(place = exp(-powi(x3, 2)/2), power = 1.04*0.75*sin(x2)/(1.50 + cos(x1)) - 0.30*v4, push = sin(p3*x3 + 0.68)*dot(v2) + v3*ddot(x3), pull = 1.16*reaction(held_x4) - push, share = pull/(1.64 + powi(reaction(held_x4), 2)))]
pub struct Random167Whole {
    #[nominal(0.62)]
    pub p1: f64,
    #[nominal(0.87)]
    pub p2: f64,
    #[nominal(0.79)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3)]
#[speeds(v1, v2, v3)]
#[kinematics(
    dot(x1) = (1.11 - 0.24*ln(1.60 + 0.63*cos(x1)))*v1 + 0.17*x3/(1 + powi(x3, 2))*v2 + 0.27*sin(p3*x2 - 0.85),
    dot(x2) = 1.17*v2 - 0.39*atan2(x2, 2 + cos(x1))/2,
    dot(x3) = (1.19 + 0.10*cos(0.87*x3 - 0.70*x2))*v3 - 0.48*x2/(1 + powi(x2, 2)),
)]
#[inertia(diag((1.36 + 0.31*cos(0.44*x1)), (1.35 - 0.16*atan2(x2, 2 + cos(x1))/2), (1.05 + 0.25*cos(0.65*x1))))]
#[forces(
    0.86*v2/(1 + powi(x1, 2)) + v1*sqrt(2 + powi(v1, 2)) + p2*exp(0.20*x2),
    0,
    p3*1.95,
)]
#[constraint(held_x3: x3 - (0.66*powi(cos(0.75*x2), 3)) == 0)]
#[constraint(held_x1: x1 - (0.85*ln(1.60 + 0.74*cos(x2))) == 0)]
pub struct Random168Whole {
    #[nominal(1.00)]
    pub p1: f64,
    #[nominal(0.92)]
    pub p2: f64,
    #[nominal(1.04)]
    pub p3: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4)]
#[speeds(v1, v2, v3, v4)]
#[kinematics(
    v1 = dot(x1) - 0.29*sin(p1*x1 - 0.36)*dot(x4) - 0.49*powi(cos(0.99*x1), 3),
    v2 = 1.28*dot(x2) - 0.36*sin(p1*x4 + 0.75),
    v3 = (1.38 + 0.34*sin(0.50*x1 + 0.75*x2 + 1.28))*dot(x3) + 0.29*1/sqrt(1.50 + powi(x3, 2))*dot(x2) - 0.20*cos(0.66*x3 + 0.38*x2 + 0.25),
    v4 = (1.08 + 0.28*cos(0.50*x4 - 0.46*x1))*dot(x4) + 0.29*sin(p1*x2 + 0.54)*dot(x3) + 0.44*exp(-powi(x2, 2)/2),
)]
#[define(l11 = (1.13 - 0.33*cos(0.45*x1)), l21 = 0.15*sin(0.77*x4), l22 = (1.24 - 0.21*x3/(1 + powi(x3, 2))), l31 = 0.12*tan(0.56*sin(x1))/2, l33 = (1.11 + 0.21*ln(1.60 + 0.45*cos(x4))), l43 = 0.11*cos(0.42*x3 - 0.42*x3), l44 = (1.03 + 0.31*sin(p1*x1 + 0.49)))]
#[inertia(matrix(
    [l11*l11, l11*l21, l11*l31, 0],
    [_, l21*l21 + l22*l22, l21*l31, 0],
    [_, _, l31*l31 + l33*l33, l33*l43],
    [_, _, _, l43*l43 + l44*l44],
))]
#[forces(
    0.73*v2 + p1*exp(0.20*x1),
    p1*v1*v2*ln(1.60 + 0.94*cos(x3)),
    p1*exp(0.20*x2) + v1*sqrt(2 + powi(v3, 2)) + 1.51*v3 + p1*v4*v4*exp(-powi(x4, 2)/2),
    p1*x1 + 1.94*atan2(x4, 2 + cos(x2))/2 + v3*sqrt(2 + powi(v4, 2)),
)]
#[constraint(held_x1: x1 - (sin(p1*(x4/1.25) - 0.74)) == 0)]
#[constraint(held_x3: x3 - (sin(0.41*(x2/1.25) - 0.68*(x2/1.25))*cos(1.12*(x2/1.25) - 0.43*(x4/1.25))) == 0)]
pub struct Random187Whole {
    #[nominal(0.61)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5)]
#[inertia(diag((1.11 + 0.27*sin(1.13*x4 - 0.58*x2)), (1.18 + 0.31*exp(-powi(t, 2)/2)), (1.21 - 0.12*1/sqrt(1.50 + powi(x3, 2))), 1.23, (1.31 + 0.24*tan(0.32*sin(t))/2)))]
#[forces(
    dot(x1)*sqrt(2 + powi(dot(x4), 2)) - p1*exp(0.20*t) - 0.46*exp(-powi(x5, 2)/2) - 0.37*powi(dot(x1), 2),
    p1*exp(0.20*x1) + 0.61*dot(x3)/(1 + powi(x1, 2)),
    1.27*dot(x2)/(1 + powi(t, 2)) - p2*1.42 - dot(x2)*dot(x1)/(1.37 + 0.19*powi(cos(1.10*x5 + 0.70), 3)) - dot(x2)*dot(x3)/1.37,
    p1*exp(0.20*x2) + dot(x3)*sqrt(2 + powi(dot(x5), 2)) + p1*x3,
    p2*exp(0.20*x1) + p1*dot(x1)*dot(x4)*tan(0.85*sin(x3))/2,
)]
#[constraint(held_x4: x4 - ((x5/1.25)/(1 + powi((x5/1.25), 2))) == 0)]
#[constraint(held_x2: x2 - (sin(1.18*(x1/1.25) + 0.27*t - 0.46)*cos(1.06*t - 0.88*(x1/1.25))) == 0)]
#[constraint(held_x3: x3 - (exp(-powi((x5/1.25), 2)/2)) == 0)]
#[output(place = cos(0.79*x1 - 0.72*x5), power = p2*dot(x2)*dot(x5)*powi(cos(1.08*x3 - 0.52), 3) - p1*dot(x2)*dot(x3)*tan(0.53*sin(t))/2, push = 0.59*sin(x1)/(1.50 + cos(x5))*ddot(x4) + dot(x2)*ddot(x2), pull = (1.37 - 0.24*tan(0.82*sin(x2))/2)*reaction(held_x2) - push, share = pull/(1.85 + powi(reaction(held_x2), 2)))]
pub struct Random207Whole {
    #[nominal(0.80)]
    pub p1: f64,
    #[nominal(0.76)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    dot(x1) = (1.03 - 0.19*0.35*sin(x1)/(1.50 + cos(x1)))*v1 - 0.39*0.62*sin(x3)/(1.50 + cos(x1))*v2,
    dot(x2) = (1.13 + 0.24*cos(0.70*x1))*v2 + 0.34*1/sqrt(1.50 + powi(x6, 2))*v3,
    dot(x3) = v3,
    dot(x4) = v4 + 0.25*sin(0.59*x3 - 0.28*x5)*v3,
    dot(x5) = v5 + 0.33*cos(0.90*x2)*v6,
    dot(x6) = (1.32 - 0.18*1/sqrt(1.50 + powi(x6, 2)))*v6,
)]
#[inertia(matrix(
    [((1.01 + 0.28*sin(p1*x6 - 0.67)))*((1.01 + 0.28*sin(p1*x6 - 0.67))), ((1.01 + 0.28*sin(p1*x6 - 0.67)))*(0.16*tan(0.91*sin(x5))/2), ((1.01 + 0.28*sin(p1*x6 - 0.67)))*(0.37*powi(cos(0.67*x4 - 0.19), 3)), ((1.01 + 0.28*sin(p1*x6 - 0.67)))*(0.19*exp(-powi(x4, 2)/2)), ((1.01 + 0.28*sin(p1*x6 - 0.67)))*(0.21*tan(0.44*sin(x2))/2), ((1.01 + 0.28*sin(p1*x6 - 0.67)))*(0.11*sin(0.92*x6 - 0.49*x5)*cos(0.82*x4 + 0.42*x3 + 0.59))],
    [_, (0.16*tan(0.91*sin(x5))/2)*(0.16*tan(0.91*sin(x5))/2) + ((1.33 + 0.13*tan(0.47*sin(x4))/2))*((1.33 + 0.13*tan(0.47*sin(x4))/2)), (0.16*tan(0.91*sin(x5))/2)*(0.37*powi(cos(0.67*x4 - 0.19), 3)) + ((1.33 + 0.13*tan(0.47*sin(x4))/2))*(0.24*atan2(x2, 2 + cos(x5))/2), (0.16*tan(0.91*sin(x5))/2)*(0.19*exp(-powi(x4, 2)/2)), (0.16*tan(0.91*sin(x5))/2)*(0.21*tan(0.44*sin(x2))/2) + ((1.33 + 0.13*tan(0.47*sin(x4))/2))*(0.14*x4/(1 + powi(x4, 2))), (0.16*tan(0.91*sin(x5))/2)*(0.11*sin(0.92*x6 - 0.49*x5)*cos(0.82*x4 + 0.42*x3 + 0.59)) + ((1.33 + 0.13*tan(0.47*sin(x4))/2))*(0.18*sin(1.11*x3))],
    [_, _, (0.37*powi(cos(0.67*x4 - 0.19), 3))*(0.37*powi(cos(0.67*x4 - 0.19), 3)) + (0.24*atan2(x2, 2 + cos(x5))/2)*(0.24*atan2(x2, 2 + cos(x5))/2) + ((1.25 - 0.23*1/sqrt(1.50 + powi(x3, 2))))*((1.25 - 0.23*1/sqrt(1.50 + powi(x3, 2)))), (0.37*powi(cos(0.67*x4 - 0.19), 3))*(0.19*exp(-powi(x4, 2)/2)) + ((1.25 - 0.23*1/sqrt(1.50 + powi(x3, 2))))*(0.10*powi(cos(1.08*x5 - 0.69*x3 + 0.61), 3)), (0.37*powi(cos(0.67*x4 - 0.19), 3))*(0.21*tan(0.44*sin(x2))/2) + (0.24*atan2(x2, 2 + cos(x5))/2)*(0.14*x4/(1 + powi(x4, 2))) + ((1.25 - 0.23*1/sqrt(1.50 + powi(x3, 2))))*(0.25*atan2(x3, 2 + cos(x2))/2), (0.37*powi(cos(0.67*x4 - 0.19), 3))*(0.11*sin(0.92*x6 - 0.49*x5)*cos(0.82*x4 + 0.42*x3 + 0.59)) + (0.24*atan2(x2, 2 + cos(x5))/2)*(0.18*sin(1.11*x3)) + ((1.25 - 0.23*1/sqrt(1.50 + powi(x3, 2))))*(0.38*sin(p1*x5 + 0.40))],
    [_, _, _, (0.19*exp(-powi(x4, 2)/2))*(0.19*exp(-powi(x4, 2)/2)) + (0.10*powi(cos(1.08*x5 - 0.69*x3 + 0.61), 3))*(0.10*powi(cos(1.08*x5 - 0.69*x3 + 0.61), 3)) + (1.20)*(1.20), (0.19*exp(-powi(x4, 2)/2))*(0.21*tan(0.44*sin(x2))/2) + (0.10*powi(cos(1.08*x5 - 0.69*x3 + 0.61), 3))*(0.25*atan2(x3, 2 + cos(x2))/2) + (1.20)*(0.35*sin(0.91*x4 + 1.48)), (0.19*exp(-powi(x4, 2)/2))*(0.11*sin(0.92*x6 - 0.49*x5)*cos(0.82*x4 + 0.42*x3 + 0.59)) + (0.10*powi(cos(1.08*x5 - 0.69*x3 + 0.61), 3))*(0.38*sin(p1*x5 + 0.40)) + (1.20)*(0.13*powi(cos(1.04*x2 - 0.42*x5 - 0.13), 3))],
    [_, _, _, _, (0.21*tan(0.44*sin(x2))/2)*(0.21*tan(0.44*sin(x2))/2) + (0.14*x4/(1 + powi(x4, 2)))*(0.14*x4/(1 + powi(x4, 2))) + (0.25*atan2(x3, 2 + cos(x2))/2)*(0.25*atan2(x3, 2 + cos(x2))/2) + (0.35*sin(0.91*x4 + 1.48))*(0.35*sin(0.91*x4 + 1.48)) + (1.06)*(1.06), (0.21*tan(0.44*sin(x2))/2)*(0.11*sin(0.92*x6 - 0.49*x5)*cos(0.82*x4 + 0.42*x3 + 0.59)) + (0.14*x4/(1 + powi(x4, 2)))*(0.18*sin(1.11*x3)) + (0.25*atan2(x3, 2 + cos(x2))/2)*(0.38*sin(p1*x5 + 0.40)) + (0.35*sin(0.91*x4 + 1.48))*(0.13*powi(cos(1.04*x2 - 0.42*x5 - 0.13), 3)) + (1.06)*(0.28*ln(1.60 + 0.84*cos(x3)))],
    [_, _, _, _, _, (0.11*sin(0.92*x6 - 0.49*x5)*cos(0.82*x4 + 0.42*x3 + 0.59))*(0.11*sin(0.92*x6 - 0.49*x5)*cos(0.82*x4 + 0.42*x3 + 0.59)) + (0.18*sin(1.11*x3))*(0.18*sin(1.11*x3)) + (0.38*sin(p1*x5 + 0.40))*(0.38*sin(p1*x5 + 0.40)) + (0.13*powi(cos(1.04*x2 - 0.42*x5 - 0.13), 3))*(0.13*powi(cos(1.04*x2 - 0.42*x5 - 0.13), 3)) + (0.28*ln(1.60 + 0.84*cos(x3)))*(0.28*ln(1.60 + 0.84*cos(x3))) + ((1.24 + 0.29*ln(1.60 + 0.78*cos(x3))))*((1.24 + 0.29*ln(1.60 + 0.78*cos(x3))))],
))]
#[forces(
    p1*v6*v5*sin(0.70*x2),
    0.45*powi(v4, 2),
    v4*v4/(1.12 - 0.26*sin(0.82*x4 - 0.23)) - 1.49*0.82*sin(x2)/(1.50 + cos(x1)),
    p1*exp(0.20*x3) - 1.18*v2/(1 + powi(x3, 2)) - p1*x6 - v2*sqrt(2 + powi(v3, 2)),
    p1*exp(0.20*x3) - 0.61*cos(0.96*x1) - p1*x2 - p1*exp(0.20*x4),
    1.48*v4 - v1*v1/(1.01 + 0.17*powi(cos(0.96*x4 - 0.43), 3)) - 0.91*v2/(1 + powi(x2, 2)),
)]
#[potential_energy(powi(cos(0.74*x6 - 0.47*x5), 3))]
#[constraint(held_x6: x6 - (0.54*1/sqrt(1.50 + powi(x2, 2))) == 0)]
#[constraint(rolling: 1.06*dot(x3) - 0.28*sin(p1*x3 - 0.21)*dot(x5) - 0.15*sin(0.97*x2 - 0.68)*cos(0.69*x4 + 0.82*x2)*dot(x4) + 0.24*tan(0.66*sin(x1))/2*dot(x1) == 0)]
#[output(place = 1/sqrt(1.50 + powi(x2, 2)), power = p1*v2*v1*ln(1.60 + 0.82*cos(x1)) + 1.18*1/sqrt(1.50 + powi(x2, 2)), push = sin(0.81*x5 + 0.12)*cos(0.84*x1)*dot(v5) + v1*ddot(x1), pull = (1.33 - 0.16*sin(0.85*x6 + 0.64)*cos(0.50*x6))*reaction(held_x6) - push, share = pull/(1.11 + powi(reaction(held_x6), 2)))]
pub struct Random208Whole {
    #[nominal(0.57)]
    pub p1: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    dot(x1) = 1.17*v1 + 0.24*exp(-powi(x3, 2)/2)*v5 + 0.55*cos(1.16*x1),
    dot(x2) = 1.30*v2 - 0.27*sin(0.41*x4)*v4 + 0.44*sin(0.54*x3 - 0.77*x4 + 0.59)*cos(0.65*x3 + 0.50*x5),
    dot(x3) = v3 - 0.11*cos(0.97*x4)*v4 + 0.37*sin(0.59*x3 - 0.65),
    dot(x4) = 1.35*v4 + 0.17*tan(0.48*sin(x2))/2*v6 - 0.18*exp(-powi(x3, 2)/2),
    dot(x5) = (1.09 - 0.18*sin(p2*x6 - 0.57))*v5 - 0.27*0.59*sin(x2)/(1.50 + cos(x2))*v6 + 0.19*cos(0.78*x2),
    dot(x6) = v6 + 0.55*tan(0.50*sin(x3))/2,
)]
#[define(l11 = (1.03 - 0.15*sin(1.10*x2 - 0.64*x6)), l22 = (1.11 + 0.33*cos(1.06*x6 - 0.40*x3)), l32 = 0.16*cos(0.96*x6 - 0.22*x2 + 1.30), l33 = 1.37, l41 = 0.17*sin(0.84*x3 - 0.23*x3 + 0.33), l42 = 0.20*x5/(1 + powi(x5, 2)), l43 = 0.21*sin(0.64*x6 - 0.43*x4)*cos(1.19*x2 - 0.22*x2), l44 = (1.11 - 0.14*powi(cos(1.10*x4 - 0.23*x2), 3)), l52 = 0.12*sin(0.91*x2 - 0.50)*cos(1.01*x4 - 0.34*x4 + 0.97), l53 = 0.36*sin(p1*x1 - 0.78), l54 = 0.17*sin(p1*x3 + 0.94), l55 = (1.07 - 0.22*sin(0.51*x5 + 0.74*x1)), l61 = 0.31*0.63*sin(x1)/(1.50 + cos(x1)), l66 = (1.16 + 0.35*atan2(x4, 2 + cos(x3))/2))]
#[inertia(matrix(
    [l11*l11, 0, 0, l11*l41, 0, l11*l61],
    [_, l22*l22, l22*l32, l22*l42, l22*l52, 0],
    [_, _, l32*l32 + l33*l33, l32*l42 + l33*l43, l32*l52 + l33*l53, 0],
    [_, _, _, l41*l41 + l42*l42 + l43*l43 + l44*l44, l42*l52 + l43*l53 + l44*l54, l41*l61],
    [_, _, _, _, l52*l52 + l53*l53 + l54*l54 + l55*l55, 0],
    [_, _, _, _, _, l61*l61 + l66*l66],
))]
#[forces(
    p1*exp(0.20*x6) + v1*sqrt(2 + powi(v2, 2)),
    p1*exp(0.20*x6) - p2*v1*v5*x6/(1 + powi(x6, 2)) - p2*x3,
    0.53*v5 - 1.57*powi(v4, 2) - 1.30*v1,
    p1*exp(0.20*x6) + 0.90*powi(v3, 2) + p1*v3*v3*atan2(x1, 2 + cos(x3))/2 + p2*1.00,
    1.54*powi(v2, 2),
    p1*x3 - 1.23*powi(v5, 2) - v2*v1/(1.23 + 0.25*0.61*sin(x4)/(1.50 + cos(x3))) - 1.97*v2/(1 + powi(x1, 2)),
)]
#[constraint(held_x2: x2 - (1.00*x1/(1 + powi(x1, 2))) == 0)]
pub struct Random226Whole {
    #[nominal(1.37)]
    pub p1: f64,
    #[nominal(1.25)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[inputs(tau)]
#[inertia(matrix(
    [(1.21)*(1.21), (1.21)*(0.37*exp(-powi(x2, 2)/2)), (1.21)*(0.36*ln(1.60 + 0.46*cos(x1))), (1.21)*(0.25*sin(0.70*x2)*cos(0.45*x4 - 0.41*x1 + 1.04)), 0, (1.21)*(0.11*tan(0.71*sin(x4))/2)],
    [_, (0.37*exp(-powi(x2, 2)/2))*(0.37*exp(-powi(x2, 2)/2)) + (1.37)*(1.37), (0.37*exp(-powi(x2, 2)/2))*(0.36*ln(1.60 + 0.46*cos(x1))) + (1.37)*(0.15*exp(-powi(x1, 2)/2)), (0.37*exp(-powi(x2, 2)/2))*(0.25*sin(0.70*x2)*cos(0.45*x4 - 0.41*x1 + 1.04)), (1.37)*(0.11*ln(1.60 + 0.72*cos(x4))), (0.37*exp(-powi(x2, 2)/2))*(0.11*tan(0.71*sin(x4))/2)],
    [_, _, (0.36*ln(1.60 + 0.46*cos(x1)))*(0.36*ln(1.60 + 0.46*cos(x1))) + (0.15*exp(-powi(x1, 2)/2))*(0.15*exp(-powi(x1, 2)/2)) + (1.07)*(1.07), (0.36*ln(1.60 + 0.46*cos(x1)))*(0.25*sin(0.70*x2)*cos(0.45*x4 - 0.41*x1 + 1.04)), (0.15*exp(-powi(x1, 2)/2))*(0.11*ln(1.60 + 0.72*cos(x4))) + (1.07)*(0.37*ln(1.60 + 0.53*cos(x4))), (0.36*ln(1.60 + 0.46*cos(x1)))*(0.11*tan(0.71*sin(x4))/2) + (1.07)*(0.13*sin(1.04*x5 + 0.66*x4 - 1.37)*cos(0.44*x6 - 0.34*x6 - 0.98))],
    [_, _, _, (0.25*sin(0.70*x2)*cos(0.45*x4 - 0.41*x1 + 1.04))*(0.25*sin(0.70*x2)*cos(0.45*x4 - 0.41*x1 + 1.04)) + (1.04)*(1.04), (1.04)*(0.22*cos(1.14*x4)), (0.25*sin(0.70*x2)*cos(0.45*x4 - 0.41*x1 + 1.04))*(0.11*tan(0.71*sin(x4))/2) + (1.04)*(0.11*sin(0.84*x5))],
    [_, _, _, _, (0.11*ln(1.60 + 0.72*cos(x4)))*(0.11*ln(1.60 + 0.72*cos(x4))) + (0.37*ln(1.60 + 0.53*cos(x4)))*(0.37*ln(1.60 + 0.53*cos(x4))) + (0.22*cos(1.14*x4))*(0.22*cos(1.14*x4)) + ((1.36 + 0.14*ln(1.60 + 0.83*cos(x3))))*((1.36 + 0.14*ln(1.60 + 0.83*cos(x3)))), (0.37*ln(1.60 + 0.53*cos(x4)))*(0.13*sin(1.04*x5 + 0.66*x4 - 1.37)*cos(0.44*x6 - 0.34*x6 - 0.98)) + (0.22*cos(1.14*x4))*(0.11*sin(0.84*x5)) + ((1.36 + 0.14*ln(1.60 + 0.83*cos(x3))))*(0.30*1/sqrt(1.50 + powi(x4, 2)))],
    [_, _, _, _, _, (0.11*tan(0.71*sin(x4))/2)*(0.11*tan(0.71*sin(x4))/2) + (0.13*sin(1.04*x5 + 0.66*x4 - 1.37)*cos(0.44*x6 - 0.34*x6 - 0.98))*(0.13*sin(1.04*x5 + 0.66*x4 - 1.37)*cos(0.44*x6 - 0.34*x6 - 0.98)) + (0.11*sin(0.84*x5))*(0.11*sin(0.84*x5)) + (0.30*1/sqrt(1.50 + powi(x4, 2)))*(0.30*1/sqrt(1.50 + powi(x4, 2))) + ((1.00 + 0.29*atan2(x2, 2 + cos(x1))/2))*((1.00 + 0.29*atan2(x2, 2 + cos(x1))/2))],
))]
#[forces(
    p1*exp(0.20*x2) + 1.97*sin(p1*x5 - 0.10) + p1*exp(0.20*x5) + dot(x4)*sqrt(2 + powi(dot(x3), 2)),
    p2*exp(0.20*x2) - 1.43*dot(x5)/(1 + powi(x2, 2)) - 1.69*cos(0.48*x5 - 0.72*x5),
    tau*1.65,
    dot(x2)*dot(x4)/1.29 + p2*exp(0.20*x6) + dot(x1)*dot(x6)/1.01 + 0.38*dot(x5)/(1 + powi(x5, 2)),
    dot(x4)*sqrt(2 + powi(dot(x4), 2)) + 1.43*dot(x3)/(1 + powi(x3, 2)) + 1.73*dot(x5)/(1 + powi(x4, 2)),
    0.62*dot(x5)/(1 + powi(x5, 2)) + 1.82*tan(0.88*sin(x5))/2 + p2*exp(0.20*x4) + 0.67*dot(x6)/(1 + powi(x3, 2)),
)]
#[potential_energy(cos(0.74*x6 + 0.20*x3))]
#[constraint(held_x1: x1 - (sin(0.72*(x6/1.25) + 0.62*(x5/1.25))*cos(0.98*(x3/1.25) + 0.63*(x6/1.25))) == 0)]
#[constraint(held_x4: x4 - (tan(0.73*sin((x3/1.25)))/2) == 0)]
#[constraint(held_x2: x2 - (1/sqrt(1.50 + powi((x6/1.25), 2))) == 0)]
pub struct Random227Whole {
    #[nominal(1.37)]
    pub p1: f64,
    #[nominal(1.16)]
    pub p2: f64,
}

#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x1, x2, x3, x4, x5, x6)]
#[define(l11 = (1.09 + 0.19*cos(0.90*x6)), l22 = (1.29 - 0.22*cos(0.65*x1 + 0.72*x5 - 0.24)), l32 = 0.26*atan2(x4, 2 + cos(x1))/2, l33 = (1.16 - 0.13*ln(1.60 + 0.44*cos(x5))), l42 = 0.13*tan(0.44*sin(x1))/2, l43 = 0.20*exp(-powi(x3, 2)/2), l44 = (1.23 - 0.29*exp(-powi(x2, 2)/2)), l51 = 0.13*exp(-powi(x6, 2)/2), l52 = 0.25*sin(0.78*x4 + 0.61*x4)*cos(0.43*x1), l53 = 0.32*exp(-powi(x3, 2)/2), l55 = (1.23 - 0.22*sin(0.67*x6 + 0.73*x1 - 1.07)), l61 = 0.34*sin(0.98*x1), l62 = 0.18*sin(0.90*x1 - 0.54), l63 = 0.16*sin(0.51*t)*cos(1.07*x5 + 0.78), l66 = 1.37)]
#[inertia(matrix(
    [l11*l11, 0, 0, 0, l11*l51, l11*l61],
    [_, l22*l22, l22*l32, l22*l42, l22*l52, l22*l62],
    [_, _, l32*l32 + l33*l33, l32*l42 + l33*l43, l32*l52 + l33*l53, l32*l62 + l33*l63],
    [_, _, _, l42*l42 + l43*l43 + l44*l44, l42*l52 + l43*l53, l42*l62 + l43*l63],
    [_, _, _, _, l51*l51 + l52*l52 + l53*l53 + l55*l55, l51*l61 + l52*l62 + l53*l63],
    [_, _, _, _, _, l61*l61 + l62*l62 + l63*l63 + l66*l66],
))]
#[forces(
    0,
    dot(x6)*sqrt(2 + powi(dot(x2), 2)) + 1.06*atan2(x6, 2 + cos(x6))/2,
    1.61*dot(x3)/(1 + powi(t, 2)),
    0.48*powi(dot(x3), 2) - dot(x4)*sqrt(2 + powi(dot(x4), 2)) - 1.07*dot(x3),
    0.98*dot(x5)/(1 + powi(x5, 2)),
    1.80*dot(x1)/(1 + powi(x3, 2)),
)]
#[constraint(held_x1: x1 - (0.65*1/sqrt(1.50 + powi(t, 2))) == 0)]
#[constraint(rolling: 1.57*dot(x6) - 0.26*tan(0.37*sin(x5))/2*dot(x5) - 0.26*exp(-powi(x3, 2)/2)*dot(x2) - 0.35*sin(1.06*x5 - 0.64*x6 + 0.34)*dot(x4) == 0)]
pub struct Random228Whole {
    #[nominal(0.75)]
    pub p1: f64,
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
            Random13(p1, p2, p3)
            Random14(p1, p2)
            Random16(p1, p2, p3)
            Random17(p1, p2, p3)
            Random18(p1, p2, p3)
            Random19(p1)
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
            Random44(p1, p2, p3)
            Random45(p1)
            Random47(p1, p2, p3)
            Random48(p1)
            Random49(p1)
            Random50(p1, p2)
            Random52(p1)
            Random53(p1)
            Random55(p1, p2)
            Random56(p1)
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
            Random72(p1, p2, p3)
            Random73(p1, p2, p3)
            Random75(p1, p2, p3)
            Random76(p1, p2)
            Random77(p1, p2)
            Random78(p1, p2, p3)
            Random80(p1, p2, p3)
            Random81(p1, p2, p3)
            Random82(p1, p2)
            Random83(p1)
            Random84(p1, p2)
            Random85(p1)
            Random86(p1, p2, p3)
            Random87(p1, p2, p3)
            Random88(p1, p2, p3)
            Random89(p1, p2)
            Random90(p1, p2)
            Random91(p1)
            Random93(p1, p2, p3)
            Random94(p1, p2)
            Random96(p1, p2, p3)
            Random97(p1)
            Random99(p1, p2)
            Random100(p1, p2, p3)
            Random101(p1)
            Random102(p1, p2, p3)
            Random103(p1)
            Random104(p1)
            Random105(p1, p2, p3)
            Random106(p1, p2)
            Random107(p1)
            Random109(p1, p2, p3)
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
            Random125(p1, p2, p3)
            Random126(p1, p2, p3)
            Random127(p1, p2)
            Random128(p1, p2, p3)
            Random129(p1, p2)
            Random130(p1)
            Random131(p1)
            Random132(p1)
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
            Random151(p1, p2)
            Random152(p1, p2)
            Random153(p1, p2)
            Random154(p1)
            Random155(p1, p2)
            Random157(p1, p2, p3)
            Random158(p1)
            Random159(p1, p2)
            Random161(p1)
            Random162(p1, p2, p3)
            Random163(p1)
            Random166(p1, p2, p3)
            Random167(p1, p2, p3)
            Random168(p1, p2, p3)
            Random169(p1)
            Random170(p1, p2)
            Random171(p1, p2, p3)
            Random172(p1)
            Random175(p1)
            Random176(p1)
            Random177(p1, p2, p3)
            Random178(p1, p2, p3)
            Random179(p1)
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
            Random197(p1, p2, p3)
            Random198(p1, p2)
            Random200(p1)
            Random202(p1, p2, p3)
            Random205(p1)
            Random207(p1, p2)
            Random208(p1)
            Random209(p1, p2, p3)
            Random210(p1)
            Random211(p1, p2)
            Random212(p1)
            Random213(p1, p2, p3)
            Random215(p1, p2)
            Random216(p1, p2)
            Random217(p1)
            Random218(p1, p2)
            Random219(p1, p2, p3)
            Random220(p1, p2)
            Random221(p1, p2)
            Random222(p1)
            Random223(p1)
            Random225(p1)
            Random226(p1, p2)
            Random227(p1, p2)
            Random228(p1)
            Random229(p1)
            Random230(p1, p2, p3)
            Random231(p1, p2)
            Random232(p1)
            Random233(p1, p2)
            Random234(p1, p2)
            Random235(p1, p2)
            Random236(p1, p2, p3)
            Random237(p1)
            Random27Whole(p1)
            Random39Whole(p1, p2)
            Random48Whole(p1)
            Random67Whole(p1)
            Random88Whole(p1, p2, p3)
            Random119Whole(p1, p2, p3)
            Random139Whole(p1)
            Random146Whole(p1, p2)
            Random147Whole(p1)
            Random148Whole(p1, p2)
            Random166Whole(p1, p2, p3)
            Random167Whole(p1, p2, p3)
            Random168Whole(p1, p2, p3)
            Random187Whole(p1)
            Random207Whole(p1, p2)
            Random208Whole(p1)
            Random226Whole(p1, p2)
            Random227Whole(p1, p2)
            Random228Whole(p1)
        }
    };
}
pub(crate) use every_random_model;

macro_rules! every_random_pair {
    ($then:ident) => {
        $then! {
            Random27 Random27Whole(p1)
            Random39 Random39Whole(p1, p2)
            Random48 Random48Whole(p1)
            Random67 Random67Whole(p1)
            Random88 Random88Whole(p1, p2, p3)
            Random119 Random119Whole(p1, p2, p3)
            Random139 Random139Whole(p1)
            Random146 Random146Whole(p1, p2)
            Random147 Random147Whole(p1)
            Random148 Random148Whole(p1, p2)
            Random166 Random166Whole(p1, p2, p3)
            Random167 Random167Whole(p1, p2, p3)
            Random168 Random168Whole(p1, p2, p3)
            Random187 Random187Whole(p1)
            Random207 Random207Whole(p1, p2)
            Random208 Random208Whole(p1)
            Random226 Random226Whole(p1, p2)
            Random227 Random227Whole(p1, p2)
            Random228 Random228Whole(p1)
        }
    };
}
pub(crate) use every_random_pair;
