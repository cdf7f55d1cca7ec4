//! One live picture as its window sees it.

use super::LiveImage;
use super::pool::{Job, Message, Order, first_in_row_order};
use crate::Region;
use lancer_scene::Invalid;
use lancer_trace::{Cancel, RayCounts, TraceError, World};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender};
use std::time::{Duration, Instant};

/// A picture that begins again at every change. Dropping it ends its work. No call of it waits.
#[derive(Debug)]
pub struct Session {
    id: u64,
    orders: Sender<Order>,
    news: Receiver<Message>,
    generation: u64,
    cancel: Cancel,
    image: LiveImage,
    world: Option<Arc<World>>,
    status: Status,
    begun: Option<Instant>,
}

/// How far a session is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Status {
    /// The rays of the current picture so far.
    pub counts: RayCounts,
    /// From the start of the current picture to its last pixel so far.
    pub elapsed: Duration,
    /// From the start to the moment when no pixel showed an earlier picture any more.
    pub first_complete: Option<Duration>,
    /// The first pixel, in row order, that has no colour.
    pub fault: Option<(u32, u32, TraceError)>,
    /// The rule that the view breaks: nothing is rendered.
    pub refused: Option<Invalid>,
    /// Whether the work rests.
    pub paused: bool,
}

impl Session {
    pub(super) fn new(id: u64, orders: Sender<Order>, news: Receiver<Message>) -> Session {
        Session {
            id,
            orders,
            news,
            generation: 0,
            cancel: Cancel::default(),
            image: LiveImage::default(),
            world: None,
            status: Status::default(),
            begun: None,
        }
    }

    /// Begins a picture, in place of the one before. What is shown stays until it is replaced.
    pub fn start(&mut self, job: Job) {
        self.cancel.cancel();
        self.cancel = Cancel::default();
        self.generation += 1;
        self.image.restart(job.view.width, job.view.height);
        self.status = Status { paused: self.status.paused, ..Status::default() };
        self.begun = Some(Instant::now());
        let job = Box::new(job);
        self.order(Order::Start { session: self.id, generation: self.generation, job, cancel: self.cancel.clone() });
    }

    /// Rests or goes on.
    pub fn pause(&mut self, paused: bool) {
        self.status.paused = paused;
        self.order(Order::Pause { session: self.id, paused });
    }

    /// Makes this the session that is served first.
    pub fn activate(&self) {
        self.order(Order::Activate { session: self.id });
    }

    /// Refines a rectangle before the rest; to be called before [`Session::start`].
    pub fn prioritise(&self, region: Option<Region>) {
        self.order(Order::Prioritise { session: self.id, region });
    }

    /// Takes what was finished since the last call; whether the picture changed.
    pub fn poll(&mut self) -> bool {
        let mut changed = false;
        for message in self.news.try_iter() {
            match message {
                Message::Unit { generation, unit, colors, counts, fault } if generation == self.generation => {
                    self.image.take(&unit, &colors);
                    self.status.counts += counts;
                    self.status.fault = first_in_row_order(self.status.fault, fault);
                    self.status.elapsed = self.begun.map_or(Duration::ZERO, |begun| begun.elapsed());
                    if !self.image.is_stale() && self.status.first_complete.is_none() {
                        self.status.first_complete = Some(self.status.elapsed);
                    }
                    changed = true;
                }
                // also of an earlier generation: the newest one there is
                Message::Compiled { world } => self.world = Some(world),
                Message::Refused { generation, rule } if generation == self.generation => {
                    self.status.refused = Some(rule);
                    changed = true;
                }
                // of an earlier generation
                Message::Unit { .. } | Message::Refused { .. } => {}
            }
        }
        changed
    }

    /// The picture as it is.
    pub fn image(&self) -> &LiveImage {
        &self.image
    }

    /// The scene that was compiled last for this session, to pick in: of the current job, or of an earlier one while
    /// that is not compiled yet; `None` before the first.
    pub fn world(&self) -> Option<&Arc<World>> {
        self.world.as_ref()
    }

    /// How far it is.
    pub fn status(&self) -> &Status {
        &self.status
    }

    /// The share of the pixels that are done, 0..=1.
    pub fn progress(&self) -> f32 {
        let pixels = self.image.bytes().len().max(1);
        self.image.exact() as f32 / pixels as f32
    }

    /// Whether the picture is done, or cannot be rendered.
    pub fn is_finished(&self) -> bool {
        self.image.is_finished() || self.status.refused.is_some()
    }

    fn order(&self, order: Order) {
        // a pool that is gone renders nothing any more
        let _ = self.orders.send(order);
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        self.cancel.cancel();
        self.order(Order::Close { session: self.id });
    }
}
