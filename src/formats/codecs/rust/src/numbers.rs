// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

//! What LASzip's items have in common (M. Isenburg: LASzip, 2013): whole numbers that differ little from what was
//! foretold, running medians, GPS times, colours.

use crate::coder::{boxed, bytes_of, Bytes, Decoder, Kinds, Lazy, Multiples};
use std::hint::select_unpredictable;

const WHOLE_BITS: u32 = 8; // of a correction, foretold by a model; those below are as they are

/// Numbers of 16 or 32 bits: how many bits a correction has, by context, then the correction.
pub struct Integers {
    pub bits: u32, // of the last correction
    most_bits: u32,
    kinds: Vec<Lazy<Kinds>>,
    corrections: [Lazy<Bytes>; 33],
}

impl Integers {
    pub fn new(most_bits: u32, contexts: usize) -> Self {
        Integers {
            bits: 0,
            most_bits,
            kinds: (0..contexts).map(|_| None).collect(),
            corrections: [const { None }; 33],
        }
    }

    /// Of 16 bits the caller takes the lower ones.
    #[inline(always)]
    pub fn next(&mut self, decoder: &mut Decoder, foretold: i32, context: usize) -> i32 {
        let symbols = self.most_bits as usize + 1;
        let kind = self.kinds[context].get_or_insert_with(|| boxed(symbols));
        let bits = decoder.symbol(kind) as u32;
        self.bits = bits;
        if bits >= 32 {
            return foretold.wrapping_add(i32::MIN);
        }
        let model = self.corrections[bits as usize].get_or_insert_with(|| {
            if bits == 0 {
                Box::new(Bytes::bit())
            } else {
                boxed(1 << bits.min(WHOLE_BITS))
            }
        });
        let mut correction = decoder.symbol_or_bit(model) as u32;
        if bits > WHOLE_BITS {
            correction = correction << (bits - WHOLE_BITS) | decoder.bits(bits - WHOLE_BITS);
        }
        // Of so many bits are -(2^bits - 1) to -2^(bits - 1) and 2^(bits - 1) + 1 to 2^bits.
        let correction = correction as i32;
        let is_upper = correction >= (1u32 << bits >> 1) as i32;
        let below = (((1u64 << bits) - 1) as i32).wrapping_neg();
        let moved = select_unpredictable(is_upper, i32::from(bits != 0), below);
        foretold.wrapping_add(correction.wrapping_add(moved))
    }
}

/// The middle one of five, to which numbers come one by one; those at either end fall out by turns.
#[derive(Clone, Copy)]
pub struct Median {
    values: [i32; 5],
    is_low: bool,
}

impl Median {
    pub fn new() -> Self {
        Median { values: [0; 5], is_low: false }
    }
    pub fn get(&self) -> i32 {
        self.values[2]
    }
    #[inline(always)]
    pub fn add(&mut self, value: i32) {
        let low = usize::from(self.is_low);
        let [a, b, c, d] = if self.is_low {
            [self.values[1], self.values[2], self.values[3], self.values[4]]
        } else {
            [self.values[0], self.values[1], self.values[2], self.values[3]]
        };
        self.is_low = i64::from(value) >= i64::from(self.values[2]) + low as i64;
        self.values = [
            a.min(value),
            a.max(b.min(value)),
            b.max(c.min(value)),
            c.max(d.min(value)),
            d.max(value),
        ];
    }
}

const MOST_MULTIPLE: usize = 500; // of the last step of time; those below are negative
const LEAST_MULTIPLE: i32 = -10;
const END_OF_MULTIPLES: usize = 511;

/// Times, by four sequences of them that go on by turns.
pub struct Times {
    last: usize,
    next: usize,
    times: [i64; 4],
    steps: [i32; 4],
    extremes: [i32; 4],
    multiples: Lazy<Multiples>,
    without_step: Lazy<Kinds>,
    integers: Integers,
    tells_equal: bool,
}

impl Times {
    /// tells_equal: the codes tell that a time is the last one, as those of the older point formats do.
    pub fn new(first: [u8; 8], tells_equal: bool) -> Self {
        Times {
            last: 0,
            next: 0,
            times: [i64::from_le_bytes(first), 0, 0, 0],
            steps: [0; 4],
            extremes: [0; 4],
            multiples: None,
            without_step: None,
            integers: Integers::new(32, 9),
            tells_equal,
        }
    }

    #[inline(always)]
    pub fn next(&mut self, decoder: &mut Decoder) -> [u8; 8] {
        self.step(decoder);
        self.times[self.last & 3].to_le_bytes()
    }

    #[inline(always)]
    fn step(&mut self, decoder: &mut Decoder) {
        let equal = usize::from(self.tells_equal);
        while !decoder.is_past() {
            let last = self.last & 3;
            let others = if self.steps[last] == 0 {
                let model =
                    self.without_step.get_or_insert_with(|| boxed(5 + equal));
                match decoder.symbol(model) {
                    0 if self.tells_equal => return,
                    code if code == equal => return self.new_step(decoder),
                    code if code == equal + 1 => return self.new_sequence(decoder),
                    code => code - equal - 1,
                }
            } else {
                let symbols = END_OF_MULTIPLES + 4 + equal;
                let model = self.multiples.get_or_insert_with(|| boxed(symbols));
                match decoder.symbol(model) {
                    code if code < END_OF_MULTIPLES => return self.multiple(decoder, code),
                    END_OF_MULTIPLES if self.tells_equal => return,
                    code if code == END_OF_MULTIPLES + equal => return self.new_sequence(decoder),
                    code => code - END_OF_MULTIPLES - equal,
                }
            };
            self.last = (last + others) & 3;
        }
    }

    fn new_step(&mut self, decoder: &mut Decoder) {
        let last = self.last & 3;
        self.steps[last] = self.integers.next(decoder, 0, 0);
        self.times[last] = self.times[last].wrapping_add(i64::from(self.steps[last]));
        self.extremes[last] = 0;
    }

    #[cold]
    fn new_sequence(&mut self, decoder: &mut Decoder) {
        self.next = (self.next + 1) & 3;
        let high = self.integers.next(decoder, (self.times[self.last & 3] >> 32) as i32, 8);
        self.times[self.next] = i64::from(high) << 32 | i64::from(decoder.whole());
        self.last = self.next;
        self.steps[self.last] = 0;
        self.extremes[self.last] = 0;
    }

    #[inline(always)]
    fn multiple(&mut self, decoder: &mut Decoder, code: usize) {
        let last = self.last & 3;
        let step = self.steps[last];
        let code_number = code as i32;
        let (foretold, context) = match code {
            1 => (step, 1),
            0 => (0, 7),
            2..=9 => (step.wrapping_mul(code_number), 2),
            10..=499 => (step.wrapping_mul(code_number), 3),
            MOST_MULTIPLE => (step.wrapping_mul(code_number), 4),
            501..=509 => (step.wrapping_mul(MOST_MULTIPLE as i32 - code_number), 5),
            _ => (step.wrapping_mul(LEAST_MULTIPLE), 6),
        };
        let found = self.integers.next(decoder, foretold, context);
        if code == 1 {
            self.extremes[last] = 0;
        } else if matches!(context, 7 | 4 | 6) {
            self.extremes[last] += 1;
            if self.extremes[last] > 3 {
                self.steps[last] = found;
                self.extremes[last] = 0;
            }
        }
        self.times[last] = self.times[last].wrapping_add(i64::from(found));
    }
}

/// Red, green and blue of 16 bits: which of their bytes changed, and by how much.
pub struct Colours {
    last: [u16; 3],
    changed: Lazy<Bytes>,
    bytes: [Lazy<Bytes>; 6],
}

impl Colours {
    pub fn new(first: [u8; 6]) -> Self {
        let last = [0, 2, 4].map(|at| u16::from_le_bytes([first[at], first[at + 1]]));
        Colours { last, changed: None, bytes: [const { None }; 6] }
    }

    #[inline(always)]
    pub fn next(&mut self, decoder: &mut Decoder) -> [u8; 6] {
        let changed = decoder.symbol(bytes_of(&mut self.changed, 128));
        let last = self.last.map(|value| value.to_le_bytes().map(i32::from));
        let mut now = last;
        let mut corrected = |bit: usize, foretold: i32| {
            let model = bytes_of(&mut self.bytes[bit], 256);
            (foretold + decoder.symbol(model) as i32) & 255
        };
        for half in 0..2 {
            if changed >> half & 1 != 0 {
                now[0][half] = corrected(half, last[0][half]);
            }
        }
        if changed & 64 == 0 {
            now[1] = now[0];
            now[2] = now[0];
        } else {
            for half in 0..2 {
                let red = now[0][half] - last[0][half];
                if changed >> (2 + half) & 1 != 0 {
                    now[1][half] = corrected(2 + half, (red + last[1][half]).clamp(0, 255));
                }
                if changed >> (4 + half) & 1 != 0 {
                    let both = (red + now[1][half] - last[1][half]) / 2;
                    now[2][half] = corrected(4 + half, (both + last[2][half]).clamp(0, 255));
                }
            }
        }
        self.last = now.map(|halves| (halves[0] | halves[1] << 8) as u16);
        let [red, green, blue] = self.last.map(u16::to_le_bytes);
        [red[0], red[1], green[0], green[1], blue[0], blue[1]]
    }
}
