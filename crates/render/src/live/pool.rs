//! The threads behind all sessions.
//!
//! A manager takes the sessions' orders in their order, compiles scenes and tells the workers; the workers ask
//! [`crate::schedule`] for units and send what they computed to the session that wants it.

use crate::schedule::{ViewState, next_unit, wake};
use crate::tracing::PixelTracer;
use crate::{Region, Tracing, Unit};
use lancer_scene::{Invalid, Scene, View};
use lancer_trace::{Camera, Cancel, RayCounts, Settings, TraceError, World};
use std::collections::BTreeMap;
use std::num::NonZeroUsize;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use thread_priority::{ThreadPriority, ThreadPriorityValue, set_current_thread_priority};

use super::Session;

/// What a session renders.
#[derive(Clone, Debug)]
pub struct Job {
    /// The scene.
    pub scene: Scene,
    /// The view of it, at the size of the picture.
    pub view: View,
    /// How many rays a pixel may cost.
    pub max_rays: u64,
}

/// A pool of threads for live sessions. Dropping it ends them.
pub struct Renderer {
    orders: Sender<Order>,
    threads: Vec<JoinHandle<()>>,
    desk: Arc<Desk>,
    next: u64,
}

impl std::fmt::Debug for Renderer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Renderer").field("threads", &self.threads.len()).finish_non_exhaustive()
    }
}

/// Called by a worker after it has sent something, so that the window looks.
type Wake = Arc<dyn Fn() + Send + Sync>;

/// What a session asks of the manager.
pub(super) enum Order {
    Open { session: u64, results: Sender<Message> },
    Start { session: u64, generation: u64, job: Box<Job>, cancel: Cancel },
    Pause { session: u64, paused: bool },
    Activate { session: u64 },
    Prioritise { session: u64, region: Option<Region> },
    Close { session: u64 },
    End,
}

/// What a session is told.
pub(super) enum Message {
    /// A unit is done.
    Unit { generation: u64, unit: Unit, colors: Vec<[u8; 3]>, counts: RayCounts, fault: Option<Fault> },
    /// The scene is compiled.
    Compiled { world: Arc<World> },
    /// The view cannot be rendered.
    Refused { generation: u64, rule: Invalid },
}

/// A pixel without a colour: its column, its row, and why.
pub(super) type Fault = (u32, u32, TraceError);

/// What workers compute for a session.
struct Task {
    tracer: PixelTracer<Arc<World>>,
    cancel: Cancel,
    generation: u64,
    results: Sender<Message>,
}

/// What the manager and the workers share. The window never takes this lock.
struct Desk {
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Default)]
struct State {
    /// Parallel lists: what the schedule sees of a session, and what the session is.
    views: Vec<ViewState>,
    seats: Vec<Seat>,
    ending: bool,
}

struct Seat {
    session: u64,
    results: Sender<Message>,
    task: Option<Arc<Task>>,
}

impl Desk {
    fn lock(&self) -> MutexGuard<'_, State> {
        // the state is whole between any two statements that could panic
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Renderer {
    /// A pool of `threads` workers, or as many as the machine offers. `wake` is called whenever a session has news.
    ///
    /// Threads that the system refuses to start are missing.
    pub fn new(threads: Option<NonZeroUsize>, tracing: Tracing, wake: impl Fn() + Send + Sync + 'static) -> Renderer {
        let threads = threads.or_else(|| std::thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get);
        let wake: Wake = Arc::new(wake);
        let desk = Arc::new(Desk { state: Mutex::default(), changed: Condvar::new() });
        let (orders, inbox) = channel();
        let manager = {
            let (desk, wake) = (Arc::clone(&desk), Arc::clone(&wake));
            thread::Builder::new().spawn(move || manage(&inbox, &desk, tracing, &*wake))
        };
        let workers = (0..threads).map(|_| {
            let (desk, wake) = (Arc::clone(&desk), Arc::clone(&wake));
            let worker = thread::Builder::new().stack_size(PixelTracer::<Arc<World>>::STACK);
            worker.spawn(move || work(&desk, &*wake))
        });
        let threads = workers.chain([manager]).filter_map(Result::ok).collect();
        Renderer { orders, threads, desk, next: 0 }
    }

    /// A session with nothing to render yet.
    pub fn open(&mut self) -> Session {
        self.next += 1;
        let (results, news) = channel();
        // the manager lives as long as this pool
        let _ = self.orders.send(Order::Open { session: self.next, results });
        Session::new(self.next, self.orders.clone(), news)
    }
}

impl Drop for Renderer {
    fn drop(&mut self) {
        let _ = self.orders.send(Order::End);
        {
            let mut state = self.desk.lock();
            state.ending = true;
            state.seats.iter().filter_map(|seat| seat.task.as_ref()).for_each(|task| task.cancel.cancel());
        }
        self.desk.changed.notify_all();
        for thread in self.threads.drain(..) {
            // a worker that panicked has nothing left to end
            let _ = thread.join();
        }
    }
}

/// The manager: takes all orders that are there, then carries them out; of several starts of a session only the last
/// one counts. The last world is kept, and the next one made from it.
fn manage(inbox: &Receiver<Order>, desk: &Desk, tracing: Tracing, wake_window: &dyn Fn()) {
    let mut world = Arc::new(World::default());
    while let Ok(first) = inbox.recv() {
        let mut starts: BTreeMap<u64, (u64, Box<Job>, Cancel)> = BTreeMap::new();
        for order in std::iter::once(first).chain(inbox.try_iter()) {
            match order {
                Order::Open { session, results } => {
                    let mut state = desk.lock();
                    state.views.push(ViewState::idle());
                    state.seats.push(Seat { session, results, task: None });
                }
                Order::Start { session, generation, job, cancel } => {
                    starts.insert(session, (generation, job, cancel));
                }
                Order::Pause { session, paused } => {
                    let mut state = desk.lock();
                    if let Some(place) = state.place(session) {
                        state.views[place].paused = paused;
                        wake(&mut state.views, place);
                    }
                }
                Order::Activate { session } => {
                    let mut state = desk.lock();
                    state.views.iter_mut().for_each(|view| view.active = false);
                    state.with(session, |view| view.active = true);
                }
                Order::Prioritise { session, region } => {
                    desk.lock().with(session, |view| view.prioritise(region));
                }
                Order::Close { session } => {
                    starts.remove(&session);
                    let mut state = desk.lock();
                    if let Some(place) = state.place(session) {
                        state.views.remove(place);
                        state.seats.remove(place);
                    }
                }
                Order::End => return,
            }
        }
        for (session, (generation, job, cancel)) in starts {
            let Job { scene, view, max_rays } = *job;
            if !world.is_of(&scene) {
                world = Arc::new(world.update(&scene));
            }
            let camera = Camera::new(&view);
            let settings = Settings { max_rays, ..Settings::of(&world, &view) };
            let mut state = desk.lock();
            let Some(place) = state.place(session) else { continue };
            // a session that is gone wants no news
            let _ = state.seats[place].results.send(Message::Compiled { world: Arc::clone(&world) });
            match camera {
                Err(rule) => {
                    // a session that is gone wants no news
                    let _ = state.seats[place].results.send(Message::Refused { generation, rule });
                    wake_window();
                }
                Ok(camera) => {
                    let tracer = PixelTracer::new(tracing, Arc::clone(&world), &camera, settings, &cancel);
                    let results = state.seats[place].results.clone();
                    state.seats[place].task = Some(Arc::new(Task { tracer, cancel, generation, results }));
                    state.views[place].restart(view.width, view.height);
                    wake(&mut state.views, place);
                }
            }
        }
        desk.changed.notify_all();
    }
}

impl State {
    fn place(&self, session: u64) -> Option<usize> {
        self.seats.iter().position(|seat| seat.session == session)
    }

    fn with(&mut self, session: u64, change: impl FnOnce(&mut ViewState)) {
        if let Some(place) = self.place(session) {
            change(&mut self.views[place]);
        }
    }
}

/// How eager the workers are, from 0 to 100; an ordinary thread is 50. On Linux this is a niceness of 10: whoever shows the
/// pictures gets a processor at once, and the workers get whatever is left over.
const EAGERNESS: u8 = 25;

/// A worker: takes a unit, computes it, sends it; sleeps where there is none.
fn work(desk: &Desk, wake_window: &dyn Fn()) {
    if let Ok(value) = ThreadPriorityValue::try_from(EAGERNESS) {
        // at an ordinary thread's priority the window is only less smooth
        let _ = set_current_thread_priority(ThreadPriority::Crossplatform(value));
    }
    loop {
        let (task, unit) = {
            let mut state = desk.lock();
            loop {
                if state.ending {
                    return;
                }
                match next_unit(&mut state.views).map(|(place, unit)| (state.seats[place].task.clone(), unit)) {
                    Some((Some(task), unit)) => break (task, unit),
                    Some((None, _)) => {}
                    None => state = desk.changed.wait(state).unwrap_or_else(PoisonError::into_inner),
                }
            }
        };
        if let Some(message) = compute(&task, unit)
            && task.results.send(message).is_ok()
        {
            wake_window();
        }
    }
}

/// What stands where a pixel has no colour: it cannot be overlooked.
const FAULT: [u8; 3] = [255, 0, 255];

/// The colours of a unit; `None` if it is not wanted any more.
fn compute(task: &Task, unit: Unit) -> Option<Message> {
    let mut pixels = Vec::new();
    unit.pixels().for_each(|pixel| pixels.push(pixel));
    let (mut colors, mut counts, mut fault) = (Vec::with_capacity(pixels.len()), RayCounts::default(), None);
    task.tracer.pixels(
        &pixels,
        &mut counts,
        |_| true,
        |(x, y), color| match color {
            Ok(color) => colors.push(color.to_bytes()),
            Err(error) => {
                fault = first_in_row_order(fault, Some((x, y, error)));
                colors.push(FAULT);
            }
        },
    )?;
    Some(Message::Unit { generation: task.generation, unit, colors, counts, fault })
}

/// Of two pixels without a colour the one that stands first.
pub(super) fn first_in_row_order(a: Option<Fault>, b: Option<Fault>) -> Option<Fault> {
    match (a, b) {
        (Some(a), Some(b)) if (b.1, b.0) < (a.1, a.0) => Some(b),
        (a, b) => a.or(b),
    }
}
