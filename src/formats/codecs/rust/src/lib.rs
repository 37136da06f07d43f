// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

//! The functions of ../codecs.h. Nothing unwinds into C: every entry goes through `guarded`.

mod attributes;
mod coder;
mod e57_scans;
mod e57_writing;
mod layered;
mod laz_chunks;
mod laz_packing;
mod numbers;
mod reserve;
mod sequential;

use std::panic::{catch_unwind, AssertUnwindSafe};

#[global_allocator]
static MEMORY: reserve::WithReserve = reserve::WithReserve;

/// As in ../codecs.h.
const OUT_OF_MEMORY: i32 = 2;

/// Where a failed call leaves its line, NUL-terminated and cut to fit.
#[repr(C)]
pub struct Message {
    bytes: *mut u8,
    room: u64,
}

impl Message {
    fn put(&self, text: &str) {
        if self.bytes.is_null() || self.room == 0 {
            return;
        }
        let mut length = text.len().min(self.room as usize - 1);
        while !text.is_char_boundary(length) {
            length -= 1;
        }
        // SAFETY: the caller of every entry gives `room` writable bytes.
        unsafe {
            std::ptr::copy_nonoverlapping(text.as_ptr(), self.bytes, length);
            *self.bytes.add(length) = 0;
        }
    }
}

/// 0, or 1 with the reason in the message, or 2 where memory was refused. A panic is a reason too: of
/// damaged bytes, mostly.
fn guarded(message: &Message, work: impl FnOnce() -> Result<(), String>) -> i32 {
    reserve::forget();
    let done = catch_unwind(AssertUnwindSafe(work));
    if reserve::was_refused() {
        return OUT_OF_MEMORY;
    }
    match done {
        Ok(Ok(())) => 0,
        Ok(Err(text)) => {
            message.put(&text);
            1
        }
        Err(_) => {
            message.put("the bytes are damaged");
            1
        }
    }
}

/// The default hook would print what a panic says; a library prints nothing.
fn silence_panics() {
    static ONCE: std::sync::Once = std::sync::Once::new();
    ONCE.call_once(|| std::panic::set_hook(Box::new(|_| {})));
}
