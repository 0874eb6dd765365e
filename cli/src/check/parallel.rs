//! Files on all cores, each on one; what is known is told on a terminal while a run takes long.

use std::collections::BTreeMap;
use std::io::IsTerminal as _;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use super::files::Entry;
use super::prove::{self, Outcome};
use crate::name::count;
use crate::output::complain;

/// The stack of a thread, as large as that of a process.
const STACK: usize = 8 << 20;

/// The time after which a run says how far it is, and then again.
const PAUSE: Duration = Duration::from_millis(400);

/// Checks files on all cores; what `keep` makes of each is handed to `done` in the order of the files.
pub(super) fn each<T: Send>(
    entries: Vec<Entry>,
    keep: &(dyn Fn(&Outcome) -> T + Sync),
    done: &mut dyn FnMut(T),
) {
    let progress = std::io::stderr().is_terminal();
    let threads = thread::available_parallelism().map_or(1, usize::from).min(entries.len());
    // Without a terminal nobody waits for a report, and one file needs one thread.
    if threads <= 1 && !progress {
        return entries.into_iter().for_each(|entry| done(keep(&prove::file(entry, prove::Formal::Left))));
    }
    let files = entries.len();
    let queue = Mutex::new(entries.into_iter().enumerate());
    let claims = AtomicUsize::new(0);
    let (sender, receiver) = channel();
    thread::scope(|scope| {
        let worker = || {
            let (sender, queue, claims) = (sender.clone(), &queue, &claims);
            move || {
                let decided = || {
                    claims.fetch_add(1, Ordering::Relaxed);
                };
                // A thread that holds the queue only takes from it.
                while let Some((k, entry)) = queue.lock().ok().and_then(|mut queue| queue.next()) {
                    let outcome = prove::watched(entry, prove::Formal::Left, &decided);
                    if sender.send((k, keep(&outcome))).is_err() {
                        return;
                    }
                }
            }
        };
        let start = || thread::Builder::new().stack_size(STACK).spawn_scoped(scope, worker()).is_ok();
        if (0..threads).filter(|_| start()).count() == 0 {
            // Where no thread can be had this one does the work.
            worker()();
        }
        drop(sender);
        // Files that are done before those in front of them.
        let mut waiting = BTreeMap::new();
        let mut next = 0;
        let mut shown = false;
        loop {
            match receiver.recv_timeout(PAUSE) {
                Ok((k, kept)) => {
                    waiting.insert(k, kept);
                    while let Some(kept) = waiting.remove(&next) {
                        erase(&mut shown);
                        done(kept);
                        next += 1;
                    }
                }
                Err(RecvTimeoutError::Timeout) if progress => {
                    erase(&mut shown);
                    let decided = count(claims.load(Ordering::Relaxed), "claim");
                    let of = if files > 1 { format!("{next} of {files} files, ") } else { String::new() };
                    complain(&format!("{of}{decided} decided…"));
                    shown = true;
                }
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => break,
            }
        }
        erase(&mut shown);
    });
}

/// Takes the line back that says how far a run is.
fn erase(shown: &mut bool) {
    if core::mem::take(shown) {
        complain("\r\x1b[2K");
    }
}
