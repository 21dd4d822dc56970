//! Every model of the repository that tests hold against the oracle and against the principles of mechanics, one line each.
//!
//! Write a new model's name and fields under its file, and all of that covers it; a model that is not here fails a test. Values of
//! parameters are the nominal ones, or one.

#[path = "../models/mod.rs"]
pub mod models;

pub use models::*;

#[path = "../models/arm.rs"]
pub mod arm;
#[path = "../models/bicycle.rs"]
pub mod bicycle;
#[path = "../models/bodies.rs"]
pub mod bodies;
#[path = "../models/bricard.rs"]
pub mod bricard;
#[path = "../models/chains.rs"]
pub mod chains;
#[path = "../models/combined.rs"]
pub mod combined;
#[path = "../models/coupled.rs"]
pub mod coupled;
#[path = "../models/linkages.rs"]
pub mod linkages;
#[path = "../models/meeting.rs"]
pub mod meeting;
#[path = "../models/spherical.rs"]
pub mod spherical;

// Mechanisms from geometry alone.
#[path = "../models/geometry/arms.rs"]
pub mod arms;
#[path = "../models/geometry/balls.rs"]
pub mod balls;
#[path = "../models/geometry/bobs.rs"]
pub mod bobs;
#[path = "../models/geometry/disc.rs"]
pub mod disc;
#[path = "../models/geometry/joints.rs"]
pub mod joints;
#[path = "../models/geometry/loops.rs"]
pub mod loops;
#[path = "../models/geometry/rods.rs"]
pub mod rods;
#[path = "../models/geometry/sleigh.rs"]
pub mod sleigh;
#[path = "../models/geometry/top.rs"]
pub mod top;
#[path = "../models/geometry/whipple.rs"]
pub mod whipple;

/// The disk of the example.
#[path = "../../examples/rolling_disk/models.rs"]
#[allow(dead_code, missing_docs, reason = "as the example has them")]
pub mod example_rolling_disk;

#[path = "../../examples/rolling_disk/geometry.rs"]
#[allow(dead_code, missing_docs, reason = "as the example has it")]
pub mod example_geometric_disk;

// The models of the other examples.
#[path = "../../examples/andrews/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_andrews;
#[path = "../../examples/appell_hamel/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_appell_hamel;
#[path = "../../examples/bicycle/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_bicycle;
#[path = "../../examples/bricard/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_bricard;
#[path = "../../examples/car_axis/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_car_axis;
#[path = "../../examples/cartesian_pendulum/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_cartesian_pendulum;
#[path = "../../examples/chain/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_chain;
#[path = "../../examples/chaplygin_sleigh/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_chaplygin_sleigh;
#[path = "../../examples/curvature/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_curvature;
#[path = "../../examples/flyball/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_flyball;
#[path = "../../examples/four_bar/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_four_bar;
#[path = "../../examples/heavy_top/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_heavy_top;
#[path = "../../examples/puma/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_puma;
#[path = "../../examples/rattleback/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_rattleback;
#[path = "../../examples/slider_crank/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_slider_crank;
#[path = "../../examples/spherical_pendulum/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_spherical_pendulum;
#[path = "../../examples/stewart/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_stewart;
#[path = "../../examples/turntable/models.rs"]
#[allow(dead_code, missing_docs, clippy::duplicated_attributes, reason = "as the example has them")]
pub mod example_turntable;

/// Calls a macro with all models: file, module, names and fields.
macro_rules! every_model {
    ($then:ident) => {
        $then! {
            "tests/models/arm.rs" arm:
                Puma(
                    g, a2, a3, d3, d4, m2, m3, m4, m5, m6, rx2, ry2, rz2, rx3, ry3, rz3, ry4, rz6, iy1, ix2, iy2, iz2,
                    ix3, iy3, iz3, ix4, iy4, iz4, ix5, iy5, iz5, ix6, iy6, iz6, motor
                );
            "tests/models/bicycle.rs" bicycle:
                Bicycle(
                    g, rr, rf, d1, d2, d3, l1, l2, l3, l4, mr, mb, mh, mf, irx, iry, ibx, iby, ibz, ibxz, ihx, ihy, ihz,
                    ihxz, ifx, ify
                );
            "tests/models/blades.rs" blades:
                Sleigh(m, i, a)
                SleighInPlane(m, i, a)
                KnifeEdge(m, i, g, incline);
            "tests/models/bodies.rs" bodies:
                HeavyTop(m, g, j1, j2, j3, l)
                Flyball(g, k, cd, l0, m_rod, l_rod, w_rod, off, m_ball, m_slider, b_slider)
                TriplePendulum(m, l, g);
            "tests/models/bricard.rs" bricard:
                Bricard(m, l, b, g);
            "tests/models/chains.rs" chains:
                TenPendulums(m, l, g)
                TwentyPendulums(m, l, g);
            "tests/models/coupled.rs" coupled:
                SixBar(l1, l2, l3, l4, l5, a, b, d, j1, j2, j3, j4, j5, w1, w2, w3, w4, w5, tau);
            "tests/models/energies.rs" energies:
                SleighByEnergy(m, i, a)
                RollingDiskByEnergy(m, r, j, g)
                HeavyBody(j1, j2, j3, m, g, l, d)
                BeadByEnergy(m, w, g)
                BeadInFrame(m, w, g)
                DoublePendulumByEnergy(m1, m2, l1, l2, g);
            "tests/models/geometry/arms.rs" arms:
                SevenJoints(g);
            "tests/models/geometry/balls.rs" balls:
                PivotedBall(m, g, j1, j2, j3, c1, c2, c3)
                BallTop(m, g, j1, j2, j3, c1, c2, c3)
                Rock(m, j1, j2, j3, k)
                KanesRock(m, j1, j2, j3, k)
                HangingRods(m, l, r, g)
                RollingBall(m, r, g, slope)
                Precession(m, g, j, l, rate);
            "tests/models/geometry/bobs.rs" bobs:
                ThreeBobs(m, l, g)
                TenBobs(m, l, g)
                TwentyBobs(m, l, g)
                ThreeTiedBobs(m, l, g);
            "tests/models/geometry/disc.rs" disc:
                Disc(m, r, g, d, a);
            "tests/models/geometry/joints.rs" joints:
                Hinged(m, l, w, g, f)
                OnARail(m, l, w, g, f, slope)
                Seamed(m, l, w, g)
                Cardan(r, bend)
                Turntable(m, r, omega)
                SpatialFourBar(a, b, c, d, w, m, g);
            "tests/models/geometry/loops.rs" loops:
                FourBarOfRods(l1, l2, l3, d, m1, m2, m3, g, tau)
                Squeezer(
                    m1, m2, m3, m4, m5, m6, m7, i1, i2, i3, i4, i5, i6, i7, xa, ya, xb, yb, xc, yc,
                    d, da, e, ea, zf, zt, fa, rr, ra, ss, sa, sb, sc, sd, ta, tb, u, ua, ub, c0, l0,
                    mom
                )
                CrankAndSlider(l, m1, m2, m3, g)
                Axle(eps, m, l, l0, r, w, g)
                SixHinges(m, l, b, g);
            "tests/models/geometry/rods.rs" rods:
                TwoRods(m, l, g)
                FiveRods(m, l, g)
                TenRods(m, l, g)
                TenRodsByJoints(m, l, g)
                TwentyRods(m, l, g)
                PinnedRodsByJoints(m, l, c, g)
                HeldRodsByJoints(m, l, r, g);
            "tests/models/geometry/sleigh.rs" sleigh:
                BladedSleigh(m, i, a);
            "tests/models/geometry/top.rs" top:
                PivotedTop(m, g, j1, j2, j3, l);
            "tests/models/geometry/whipple.rs" whipple:
                Whipple(
                    g, rr, rf, d1, d2, d3, l1, l2, l3, l4, mr, mb, mh, mf, irx, iry, ibx, iby, ibz, ibxz, ihx, ihy, ihz,
                    ihxz, ifx, ify
                );
            "tests/models/kinds.rs" kinds:
                TripleRod(m, g, l)
                ConstantSpeed(m, g, c)
                SteadySlope(m, g, a)
                AppellHamel(m1, m2, g, c)
                Pushed(m, g, k)
                CurvedPath(m, g, kappa)
                Prescribed(m, g, w);
            "tests/models/linkages.rs" linkages:
                CarAxis(eps, m, l, l0, r, w, g)
                FourBar(l1, l2, l3, d, m1, m2, m3, g, tau)
                SliderCrank(l, m1, m2, m3, g)
                SliderCrankOnBranch(l, m1, m2, m3, g)
                Andrews(
                    m1, m2, m3, m4, m5, m6, m7, i1, i2, i3, i4, i5, i6, i7, xa, ya, xb, yb, xc, yc,
                    d, da, e, ea, zf, zt, fa, rr, ra, ss, sa, sb, sc, sd, ta, tb, u, ua, ub, c0,
                    l0, mom
                );
            "tests/models/meeting.rs" meeting:
                Parallelogram(l, d, m1, m2, g)
                AsPendulum(l, m1, m2, g)
                CrankOnCart(l, m0, m1, m2, m3, g, k, l0)
                CrankOnCartAlone(l, m0, m1, m2, m3, g, k, l0)
                Wires(m, gap)
                Cusp(m)
                Kite(a, b, mp, m, g)
                KiteAlone(a, b, mp, m, g);
            "tests/models/particles.rs" particles:
                Pendulum(m, l, g)
                HangingPendulum(m, l, g)
                PendulumByAngle(m, l, g)
                BeadOnRod(m, w, g)
                BeadByDistance(m, w, g)
                ConicalPendulum(m, r, opening, g)
                Atwood(m1, m2, c, g)
                DoublePendulum(m1, m2, l1, l2, g);
            "tests/models/rolling_disc.rs" rolling_disc:
                RollingDisc(m, r, g, d, a);
            "tests/models/rolling_disk.rs" rolling_disk:
                RollingDisk(m, r, j, g)
                RollingDiskOnFloor(m, r, j, g)
                SlidingDisk(m, r, j, g)
                RollingDiskInStages(m, r, j, g)
                RollingDiskSecondStage(m, r, j, g);
            "tests/models/speeds.rs" speeds:
                ConstantSpeedByDirection(m, g, c)
                PendulumByMomentum(m, g, l)
                Clip(m1, m2, s, pull);
            "tests/models/spherical.rs" spherical:
                Spherical(m, l, g)
                SphericalInCharts(m, l, g)
                SphericalInAngles(m, l, g);
            "examples/andrews/models.rs" example_andrews:
                Squeezer(
                    m1, m2, m3, m4, m5, m6, m7, i1, i2, i3, i4, i5, i6, i7, xa, ya, xb, yb, xc, yc,
                    d, da, e, ea, zf, zt, fa, rr, ra, ss, sa, sb, sc, sd, ta, tb, u, ua, ub, c0, l0,
                    mom
                );
            "examples/appell_hamel/models.rs" example_appell_hamel:
                SteadySlope(m, g, a);
            "examples/bicycle/models.rs" example_bicycle:
                Bicycle(
                    w, c, lambda, g, r_rear, m_rear, rear_xx, rear_yy, bx, bz, mb, bxx, byy, bzz, bxz, hx, hz, mh, hxx, hyy,
                    hzz, hxz, r_front, m_front, front_xx, front_yy
                );
            "examples/bricard/models.rs" example_bricard:
                Bricard(m, l, b, g);
            "examples/car_axis/models.rs" example_car_axis:
                CarAxle(eps, m, l, l0, r, w, g);
            "examples/cartesian_pendulum/models.rs" example_cartesian_pendulum:
                CartesianPendulum(m, l, g);
            "examples/chaplygin_sleigh/models.rs" example_chaplygin_sleigh:
                Sleigh(m, i, a);
            "examples/curvature/models.rs" example_curvature:
                SteeredParticle(m, g, kappa);
            "examples/chain/models.rs" example_chain:
                Chain(m, l, g);
            "examples/flyball/models.rs" example_flyball:
                Governor(g, k, cd, l0, m_rod, l_rod, w_rod, off, m_ball, m_slider, b_slider);
            "examples/four_bar/models.rs" example_four_bar:
                FourBar(a, b, c, d, m1, m2, m3, g)
                ByRocker(a, b, c, d, m1, m2, m3, load, g);
            "examples/heavy_top/models.rs" example_heavy_top:
                AngledTop(m, g, l, axial, across)
                FreeTop(m, g, l, axial, across);
            "examples/puma/models.rs" example_puma:
                PumaArm(
                    g, a2, a3, d3, d4, m2, m3, m4, m5, m6, rx2, ry2, rz2, rx3, ry3, rz3, ry4, rz6, iy1, ix2, iy2, iz2,
                    ix3, iy3, iz3, ix4, iy4, iz4, ix5, iy5, iz5, ix6, iy6, iz6, motor_inertia
                );
            "examples/rattleback/models.rs" example_rattleback:
                Rattleback(m, a, b, c, h, ixx, iyy, izz, ixy, g);
            "examples/slider_crank/models.rs" example_slider_crank:
                SliderCrank(r, l, m1, m2, m3, g);
            "examples/spherical_pendulum/models.rs" example_spherical_pendulum:
                OneChart(m, l, g)
                ThreeCharts(m, l, g)
                InAngles(m, l, g);
            "examples/stewart/models.rs" example_stewart:
                Stewart(bx, by, px, py, m, r, mc, mr, l, k, s0, g);
            "examples/turntable/models.rs" example_turntable:
                Turntable(m, r, w, a, b);
            "examples/rolling_disk/geometry.rs" example_geometric_disk:
                Disk(m, r, j, g);
            "examples/rolling_disk/models.rs" example_rolling_disk:
                RollingDisk(m, r, j, g)
                FloorDisk(m, r, j, g)
                StagedDisk(m, r, j, g);
            "tests/models/combined.rs" combined:
                DiscByRates(m, r, g, d, a)
                SphericalByTurning(m, l, g)
                PacedBlade(m, i, g, tilt, drift, pace)
                SwungParticle(m, g, l, k, w);
        }
    };
}
pub(crate) use every_model;
