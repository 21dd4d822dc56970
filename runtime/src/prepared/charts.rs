//! The functions of charts and of the carriers.

use super::Prepared;
use crate::{ConstrainedSystem, Scalar};

impl<M: ConstrainedSystem, T: Scalar> Prepared<M, T> {
    /// The state's rate and the guards of a chart, where the speeds of `s` are those of the chart.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// // With the rod level, ẋ determines nothing, but ẏ does.
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let level = PendulumState { x: 0.5, y: 0.0, dot_x: -1.0 };     // in the chart 1 the speed is ẏ
    /// assert_eq!(pendulum.chart_velocities(1, 0.0, &level).dot_y, -1.0);
    /// let (rate, guards) = pendulum.chart_derivative(1, 0.0, &level, &[]);
    /// assert_eq!((rate.dot_x, guards), (-9.81, [0.5]));
    /// # Ok::<(), Error>(())
    /// ```
    #[inline]
    pub fn chart_derivative(
        &self,
        chart: usize,
        t: T,
        s: &M::State<T>,
        i: &M::Inputs<T>,
    ) -> (M::State<T>, M::ChartGuards<T>) {
        M::chart_derivative(chart, self.values(), t, s, i)
    }

    /// v where the speeds of `s` are those of a chart.
    #[inline]
    pub fn chart_velocities(&self, chart: usize, t: T, s: &M::State<T>) -> M::Velocities<T> {
        M::chart_velocities(chart, self.values(), t, s)
    }

    /// u of a chart from v; of `s` the coordinates are read.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let s = PendulumState { x: 0.3, y: -0.4, dot_x: 1.0 };
    /// let v = pendulum.velocities(0.0, &s);
    /// assert_eq!(pendulum.chart_speeds(0, 0.0, &s, &v), [s.dot_x]);
    /// assert_eq!(pendulum.chart_speeds(1, 0.0, &s, &v), [v.dot_y]);
    /// # Ok::<(), Error>(())
    /// ```
    #[inline]
    pub fn chart_speeds(&self, chart: usize, t: T, s: &M::State<T>, v: &M::Velocities<T>) -> M::Speeds<T> {
        M::chart_speeds(chart, self.values(), t, s, v)
    }

    /// v of the carriers w; of `s` the coordinates are read.
    ///
    /// ```
    /// # mod models {
    /// #     include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs"));
    /// #     include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/swing.rs"));
    /// # }
    /// # use models::{Swing, SwingState};
    /// use holonomy::prelude::*;
    ///
    /// // The swing's state is an angle: its rate is the only carrier, of which ẋ and ẏ follow.
    /// let swing = Swing { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// assert_eq!(Swing::MODEL.carriers, ["dot_alpha"]);
    /// let hanging = SwingState { alpha: 0.0, dot_alpha: 0.0 };
    /// assert_eq!(swing.carried_velocities(0.0, &hanging, &[3.0]).dot_x, 1.5);
    /// assert_eq!(swing.carried_rates(0.0, &hanging, &[3.0]), [3.0]);
    /// # Ok::<(), Error>(())
    /// ```
    #[inline]
    pub fn carried_velocities(&self, t: T, s: &M::State<T>, w: &M::Carriers<T>) -> M::Velocities<T> {
        M::carried_velocities(self.values(), t, s, w)
    }

    /// The rates of the state's coordinates for the carriers w; of `s` the coordinates are read.
    #[inline]
    pub fn carried_rates(&self, t: T, s: &M::State<T>, w: &M::Carriers<T>) -> M::StateCoordinates<T> {
        M::carried_rates(self.values(), t, s, w)
    }
}
