//! What is done between two steps of a method of the other crate: judging, returning to the constraints, keeping.

use ::differential_equations::control::ControlFlag;
use ::differential_equations::interpolate::Interpolation;
use ::differential_equations::solout::Solout;
use ::differential_equations::solution::Solution;
use ::differential_equations::traits::State as Entered;

use super::{Entries, Equations, States, told};
use crate::manifold::Manifold;
use crate::simulate::InputSource;
use crate::{ConstrainedSystem, Error, GuardKind, Vector};

/// Outputs that differ from the end of a step by less than this part of it lie at the end.
const SAME_TIME: f64 = 1e-12;

/// A method starts again only where so many steps of the last size fit before the end: its first step is a guess, which must
/// not reach beyond.
const ROOM: f64 = 10.0;

/// A run on its way.
pub(super) struct Watched<'e, 'a, M: ConstrainedSystem, I> {
    equations: &'e Equations<'a, M, I>,
    manifold: Option<Manifold<M>>,
    /// The guards at the last accepted state.
    guards: M::Guards<f64>,
    from: f64,
    to: f64,
    direction: f64,
    last: (f64, M::State<f64>),
    pub(super) states: States<M>,
    pub(super) reached: f64,
    pub(super) error: Option<Error>,
}

impl<'e, 'a, M: ConstrainedSystem, I: InputSource<M>> Watched<'e, 'a, M, I>
where
    Entries<M>: Entered<f64>,
{
    pub(super) fn new(
        equations: &'e Equations<'a, M, I>,
        start: M::State<f64>,
        (from, to): (f64, f64),
    ) -> Result<Self, Error> {
        equations.check(from, &start)?;
        let model = equations.model;
        // With independent coordinates, f is identically zero.
        let dependent = M::MODEL.state_coordinates == M::MODEL.coordinates && !M::MODEL.position_rows.is_empty();
        Ok(Watched {
            equations,
            manifold: if dependent { Some(Manifold::new(model, from, &start)?) } else { None },
            guards: model.guards(from, &start),
            from,
            to,
            direction: if to < from { -1.0 } else { 1.0 },
            last: (from, start),
            states: alloc::vec![(from, start)],
            reached: from,
            error: None,
        })
    }

    /// Adds the end where no output lies on it.
    pub(super) fn finish(mut self, to: f64) -> Result<States<M>, Error> {
        let (t, s) = self.last;
        // The method may stop a rounding error before the end.
        if let Some(end) = self.states.last_mut().filter(|(at, _)| *at == t || *at == to) {
            end.0 = to;
        } else {
            self.states.push((to, s));
        }
        Ok(self.states)
    }

    fn restore(&mut self, t: f64, y: &Entries<M>) -> Result<M::State<f64>, Error> {
        let mut s = (*y).into();
        if let Some(manifold) = &mut self.manifold {
            manifold.restore(self.equations.model, t, &mut s)?;
        }
        Ok(s)
    }

    /// The guards may not change their sign between two accepted states; `check` judges them at each.
    fn judge(&mut self, t: f64, s: &M::State<f64>) -> Result<(), Error> {
        let guards = self.equations.model.guards(t, s);
        let (before, after) = (self.guards.into(), guards.into());
        for ((info, before), after) in M::MODEL.guards.iter().zip(before.as_ref()).zip(after.as_ref()) {
            if info.kind == GuardKind::Pivot && (*before < 0.0) != (*after < 0.0) {
                return Err(Error::ChartSingularity { guard: info.name, value: *after, time: t });
            }
        }
        self.guards = guards;
        self.equations.check(t, s)
    }

    fn step<P>(&mut self, (t, before): (f64, f64), y: &Entries<M>, method: &mut P) -> Result<Option<Entries<M>>, Error>
    where
        P: Interpolation<f64, Entries<M>> + ?Sized,
    {
        if let Some(at) = y.as_ref().iter().position(|entry| !entry.is_finite()) {
            let names = <M::State<f64> as Vector<f64>>::NAMES;
            return Err(Error::Diverged { name: names.get(at).copied().unwrap_or("state"), time: before });
        }
        let s = self.restore(t, y)?;
        self.judge(t, &s)?;
        let same = SAME_TIME * (t - before).abs();
        if let Some(every) = self.equations.every {
            loop {
                // From a count, so that the times do not gather rounding errors.
                let at = self.from + self.direction * every * self.states.len() as f64;
                let left = (t - at) * self.direction;
                if left < -same {
                    break;
                }
                let kept = match left <= same {
                    true => s,
                    false => {
                        let between = method.interpolate(at).map_err(|failure| told::<M>(&failure, before))?;
                        self.restore(at, &between)?
                    }
                };
                self.states.push((at, kept));
            }
        } else {
            self.states.push((t, s));
        }
        (self.last, self.reached) = ((t, s), t);
        let nearest: Entries<M> = s.into();
        let y = y.as_ref();
        let size = y.iter().fold(0.0, |size: f64, entry| size.max(entry.abs()));
        let drifted = y.iter().zip(nearest.as_ref()).any(|(y, s)| (y - s).abs() > self.equations.drift * size);
        let room = (self.to - t) * self.direction > ROOM * (t - before).abs();
        Ok((drifted && room).then_some(nearest))
    }
}

impl<M: ConstrainedSystem, I: InputSource<M>> Solout<f64, Entries<M>> for Watched<'_, '_, M, I>
where
    Entries<M>: Entered<f64>,
{
    fn solout<P>(
        &mut self,
        t: f64,
        before: f64,
        y: &Entries<M>,
        _: &Entries<M>,
        method: &mut P,
        _: &mut Solution<f64, Entries<M>>,
    ) -> ControlFlag<f64, Entries<M>>
    where
        P: Interpolation<f64, Entries<M>> + ?Sized,
    {
        // The first call tells the start.
        if t == self.reached {
            return ControlFlag::Continue;
        }
        match self.step((t, before), y, method) {
            Ok(None) => ControlFlag::Continue,
            Ok(Some(nearest)) => ControlFlag::ModifyState(t, nearest),
            Err(error) => {
                self.error = Some(error);
                ControlFlag::Terminate
            }
        }
    }
}
