//! What JavaScript calls, and what a program without an operating system has to bring.
//!
//! JavaScript asks for `room`, writes there what is to be packed or unpacked, calls `packed` or `unpacked`, and reads as
//! many bytes as these say from the address that `room` gave.

use alloc::vec::Vec;
use core::alloc::{GlobalAlloc, Layout};
use core::arch::wasm32;
use core::cell::{Cell, RefCell};
use core::panic::PanicInfo;
use core::ptr;

use crate::{Damaged, pack, unpack};

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

    unsafe fn dealloc(&self, _: *mut u8, _: Layout) {}
}

#[global_allocator]
static MEMORY: Forward = Forward(Cell::new(0));

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    wasm32::unreachable()
}

/// What is packed or unpacked next, and then what became of it.
struct Room(RefCell<Vec<u8>>);

// SAFETY: there is one thread.
#[allow(unsafe_code)]
unsafe impl Sync for Room {}

static ROOM: Room = Room(RefCell::new(Vec::new()));

/// The address of room for this number of bytes.
#[allow(unsafe_code)] // SAFETY: no other symbol of the page has the name; there is no unsafe block here
#[unsafe(no_mangle)]
pub(crate) extern "C" fn room(length: usize) -> *mut u8 {
    let mut room = ROOM.0.borrow_mut();
    room.resize(length, 0);
    room.as_mut_ptr()
}

/// Puts what `turn` makes of the room's bytes in their place; the number of bytes, 0 where there is an error.
fn turned(turn: impl FnOnce(&[u8]) -> Result<Vec<u8>, Damaged>) -> usize {
    let mut room = ROOM.0.borrow_mut();
    *room = turn(&room).unwrap_or_default();
    room.len()
}

/// Unpacks what is in the room.
#[allow(unsafe_code)] // SAFETY: as for `room`
#[unsafe(no_mangle)]
pub(crate) extern "C" fn unpacked() -> usize {
    turned(unpack)
}

/// Packs what is in the room.
#[allow(unsafe_code)] // SAFETY: as for `room`
#[unsafe(no_mangle)]
pub(crate) extern "C" fn packed() -> usize {
    turned(pack)
}

/// Where the result begins.
#[allow(unsafe_code)] // SAFETY: as for `room`
#[unsafe(no_mangle)]
pub(crate) extern "C" fn result() -> *const u8 {
    ROOM.0.borrow().as_ptr()
}
