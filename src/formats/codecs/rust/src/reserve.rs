// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

//! Rust ends the process where memory is refused; a library may not. Here the call in flight goes on with
//! a reserve, reads and writes nothing any more, and fails as out of memory when it returns.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::{Cell, UnsafeCell};
use std::sync::{Mutex, MutexGuard};

/// What a chunk of points and a document of E57 need with room to spare. Pages that nothing touches are none.
const RESERVE_BYTES: usize = 32 << 20;

#[repr(align(4096))]
struct Room(UnsafeCell<[u8; RESERVE_BYTES]>);
// SAFETY: handed out in parts that do not overlap, under the lock.
unsafe impl Sync for Room {}
static ROOM: Room = Room(UnsafeCell::new([0; RESERVE_BYTES]));

struct Used {
    bytes: usize,
    blocks: usize,
}
static USED: Mutex<Used> = Mutex::new(Used { bytes: 0, blocks: 0 });

thread_local! {
    static REFUSED: Cell<bool> = const { Cell::new(false) };
}

/// Was this thread's call refused memory?
pub fn was_refused() -> bool {
    REFUSED.try_with(Cell::get).unwrap_or(false)
}
pub fn forget() {
    let _ = REFUSED.try_with(|flag| flag.set(false));
}

fn used() -> MutexGuard<'static, Used> {
    USED.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
}

fn begin() -> usize {
    ROOM.0.get() as usize
}

fn is_reserved(block: *mut u8) -> bool {
    (begin()..begin() + RESERVE_BYTES).contains(&(block as usize))
}

/// Null where the reserve is used up too.
fn take(layout: Layout) -> *mut u8 {
    let _ = REFUSED.try_with(|flag| flag.set(true));
    let mut used = used();
    let at = (begin() + used.bytes).next_multiple_of(layout.align());
    if layout.size() > begin() + RESERVE_BYTES - at.min(begin() + RESERVE_BYTES) {
        return std::ptr::null_mut();
    }
    used.bytes = at + layout.size() - begin();
    used.blocks += 1;
    at as *mut u8
}

/// All of it is free again when its last block is.
fn give_back() {
    let mut used = used();
    used.blocks -= 1;
    if used.blocks == 0 {
        used.bytes = 0;
    }
}

pub struct WithReserve;

// SAFETY: blocks are the system's or lie in ROOM, told apart by their address.
unsafe impl GlobalAlloc for WithReserve {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let block = System.alloc(layout);
        if block.is_null() {
            take(layout)
        } else {
            block
        }
    }

    // The system's pages are zero already.
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        let block = System.alloc_zeroed(layout);
        if !block.is_null() {
            return block;
        }
        let block = take(layout);
        if !block.is_null() {
            block.write_bytes(0, layout.size());
        }
        block
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        if is_reserved(block) {
            give_back();
        } else {
            System.dealloc(block, layout);
        }
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, bytes: usize) -> *mut u8 {
        if !is_reserved(block) {
            let grown = System.realloc(block, layout, bytes);
            if !grown.is_null() {
                return grown;
            }
        }
        let moved = self.alloc(Layout::from_size_align_unchecked(bytes, layout.align()));
        if !moved.is_null() {
            std::ptr::copy_nonoverlapping(block, moved, layout.size().min(bytes));
            self.dealloc(block, layout);
        }
        moved
    }
}
