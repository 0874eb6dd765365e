//! What JavaScript calls, and what a program without an operating system has to bring.
//!
//! JavaScript asks for `room`, writes there what is to be packed or unpacked, calls `packed` or `unpacked`, and reads as
//! many bytes as these say from the address that `room` gave.

use alloc::vec::Vec;
use core::alloc::{GlobalAlloc, Layout};
use core::arch::wasm32;
use core::cell::{Cell, RefCell};
use core::mem;
use core::panic::PanicInfo;
use core::ptr;

use crate::{Parts, pack};

/// Memory that is never given back: an instance packs or unpacks once.
struct Forward(Cell<usize>);

const PAGE: usize = 1 << 16;

// SAFETY: there is one thread.
#[allow(unsafe_code)]
unsafe impl Sync for Forward {}

// SAFETY: every block lies behind all blocks before it, in memory that was added for it.
#[allow(unsafe_code)]
unsafe impl GlobalAlloc for Forward {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        if self.0.get() == 0 {
            self.0.set(wasm32::memory_size(0) * PAGE);
        }
        let start = self.0.get().next_multiple_of(layout.align());
        let Some(end) = start.checked_add(layout.size()) else { return ptr::null_mut() };
        let more = end.div_ceil(PAGE).saturating_sub(wasm32::memory_size(0));
        if more > 0 && wasm32::memory_grow(0, more) == usize::MAX {
            return ptr::null_mut();
        }
        self.0.set(end);
        ptr::without_provenance_mut(start)
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's.
        unsafe { self.alloc(layout) } // nobody has written there
    }

    unsafe fn dealloc(&self, _: *mut u8, _: Layout) {}
}

#[global_allocator]
static MEMORY: Forward = Forward(Cell::new(0));

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    wasm32::unreachable()
}

/// What is packed or unpacked next, and then what became of it.
struct Room(RefCell<Vec<u8>>, RefCell<Option<Parts>>);

// SAFETY: there is one thread.
#[allow(unsafe_code)]
unsafe impl Sync for Room {}

static ROOM: Room = Room(RefCell::new(Vec::new()), RefCell::new(None));

/// The address of room for this number of bytes.
#[allow(unsafe_code)] // SAFETY: no other symbol of the page has the name; there is no unsafe block here
#[unsafe(no_mangle)]
pub(crate) extern "C" fn room(length: usize) -> *mut u8 {
    let mut room = ROOM.0.borrow_mut();
    room.resize(length, 0);
    room.as_mut_ptr()
}

/// Unpacks the first part of what is in the room, or the next one, and puts it there; the number of its bytes, 0 after the last
/// part and where there is an error.
#[allow(unsafe_code)] // SAFETY: as for `room`
#[unsafe(no_mangle)]
pub(crate) extern "C" fn unpacked() -> usize {
    let mut room = ROOM.0.borrow_mut();
    let mut parts = ROOM.1.borrow_mut();
    if parts.is_none() {
        *parts = Parts::new(mem::take(&mut room)).ok();
    }
    *room = parts.as_mut().and_then(|parts| parts.next().ok()).flatten().unwrap_or_default();
    room.len()
}

/// Packs what is in the room.
#[allow(unsafe_code)] // SAFETY: as for `room`
#[unsafe(no_mangle)]
pub(crate) extern "C" fn packed() -> usize {
    let mut room = ROOM.0.borrow_mut();
    *room = pack(&room).unwrap_or_default();
    room.len()
}

/// Where the result begins.
#[allow(unsafe_code)] // SAFETY: as for `room`
#[unsafe(no_mangle)]
pub(crate) extern "C" fn result() -> *const u8 {
    ROOM.0.borrow().as_ptr()
}
