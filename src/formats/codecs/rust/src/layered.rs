// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

//! A chunk of the point formats 6 to 8 as LASzip's third and fourth version pack it: each attribute in a stream of code
//! of its own, foretold by what the first of them tells of returns: here places and returns, attributes.rs has the
//! others. Points of one scanner channel, which nearly all files have; others are left to the crate.

use crate::attributes::fill_attributes;
use crate::coder::{bytes_of, Bytes, Decoder, Lazy};
use crate::numbers::{Integers, Median};

pub const CORE_BYTES: usize = 30;
pub const COLOUR_BYTES: usize = 6;
pub const INFRARED_BYTES: usize = 2;
const COUNT_BYTES: usize = 4; // behind the first record
const SIZE_BYTES: usize = 4; // of a layer
const CORE_LAYERS: usize = 9;

// Places in a record.
const Z_AT: usize = 8;
const RETURNS_AT: usize = 14;

/// What a record has behind what all have.
pub struct Items {
    pub has_colour: bool,
    pub has_infrared: bool,
    pub extra_bytes: usize,
}

impl Items {
    pub fn record_bytes(&self) -> usize {
        let colour = if self.has_colour { COLOUR_BYTES } else { 0 };
        let infrared = if self.has_infrared { INFRARED_BYTES } else { 0 };
        CORE_BYTES + colour + infrared + self.extra_bytes
    }
    fn layers(&self) -> usize {
        CORE_LAYERS
            + usize::from(self.has_colour)
            + usize::from(self.has_infrared)
            + self.extra_bytes
    }
}

/// Steps of x, y and z between which points are wanted.
pub struct Within {
    pub least: [i32; 3],
    pub most: [i32; 3],
}

impl Within {
    fn holds(&self, record: &[u8]) -> bool {
        record[..12].chunks_exact(4).enumerate().all(|(axis, bytes)| {
            let steps = i32::from_le_bytes(bytes.try_into().unwrap());
            (self.least[axis]..=self.most[axis]).contains(&steps)
        })
    }
}

pub enum Decoded {
    /// So many records, up to the last one that is wanted.
    Records(usize),
    CutOff,
    /// Nothing that was put counts.
    OfSeveralChannels,
}

/// LASzip's contexts of the number of returns (row) and of the return (column).
const CONTEXT_OF_RETURN: [[u8; 16]; 16] = [
    [0, 1, 2, 3, 4, 5, 3, 4, 4, 5, 5, 5, 5, 5, 5, 5],
    [1, 0, 1, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3],
    [2, 1, 2, 4, 4, 4, 4, 4, 4, 4, 4, 3, 3, 3, 3, 3],
    [3, 3, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4],
    [4, 3, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4],
    [5, 3, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4],
    [3, 3, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4],
    [4, 3, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4],
    [4, 3, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4],
    [5, 3, 4, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4],
    [5, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4],
    [5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 4, 4, 4],
    [5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 4, 4],
    [5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 4],
    [5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5],
    [5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5],
];
const MOST_LEVEL: usize = 7; // of returns between this one and the last

/// What the first layer tells of a point, which foretells its other attributes.
#[derive(Clone, Copy)]
pub struct Told {
    pub order: u8, // 2: the first return, 1: the last one, 3: both
    pub has_other_time: bool,
    pub has_other_angle: bool,
    pub has_other_source: bool,
}

/// The layers, each of which ends at its size.
pub struct Layers<'a> {
    sizes: &'a [u8],
    code: &'a [u8],
}

impl<'a> Layers<'a> {
    fn of(packed: &'a [u8], record_bytes: usize, layers: usize) -> Option<Self> {
        let heads = packed.get(record_bytes + COUNT_BYTES..)?;
        let (sizes, code) = heads.split_at_checked(layers * SIZE_BYTES)?;
        Some(Layers { sizes, code })
    }
    /// None where all points have what the first one has. That the layers lie in the chunk is known.
    pub fn next(&mut self) -> Option<Decoder<'a>> {
        let (size, sizes) = self.sizes.split_first_chunk::<SIZE_BYTES>()?;
        self.sizes = sizes;
        let (layer, code) = self.code.split_at_checked(u32::from_le_bytes(*size) as usize)?;
        self.code = code;
        (!layer.is_empty()).then(|| Decoder::new(layer))
    }
}

/// z, foretold by its last one of as many returns to the last one.
struct Heights<'a> {
    decoder: Option<Decoder<'a>>,
    integers: Integers,
    last: [i32; MOST_LEVEL + 1],
}

impl Heights<'_> {
    #[inline(always)]
    fn next(&mut self, level: usize, is_single: bool, place_bits: u32) -> i32 {
        let height = &mut self.last[level];
        if let Some(decoder) = &mut self.decoder {
            let context = usize::from(is_single) + (place_bits.min(18) & !1) as usize;
            *height = self.integers.next(decoder, *height, context);
        }
        *height
    }
    fn is_past(&self) -> bool {
        self.decoder.as_ref().is_some_and(Decoder::is_past)
    }
}

/// x, y, z and the numbers of returns of all points; None where another channel comes.
fn fill_places(
    decoder: &mut Decoder,
    heights: &mut Heights,
    records: &mut [u8],
    record_bytes: usize,
) -> Option<Vec<Told>> {
    let mut changed_models: [Lazy<Bytes>; 8] = [const { None }; 8];
    let mut returns_models: [Lazy<Bytes>; 16] = [const { None }; 16];
    let mut number_models: [Lazy<Bytes>; 16] = [const { None }; 16];
    let mut same_time_model: Lazy<Bytes> = None;
    let (mut steps_x, mut steps_y) = ([Median::new(); 12], [Median::new(); 12]);
    let (mut x_integers, mut y_integers) = (Integers::new(32, 2), Integers::new(32, 22));

    let (first, rest) = records.split_at_mut(record_bytes);
    let mut x = i32::from_le_bytes(first[0..4].try_into().unwrap());
    let mut y = i32::from_le_bytes(first[4..8].try_into().unwrap());
    let (mut number, mut returns) =
        (usize::from(first[RETURNS_AT] & 15), usize::from(first[RETURNS_AT] >> 4));
    let mut had_other_time = false;
    let mut all = Vec::new();
    if all.try_reserve_exact(rest.len() / record_bytes).is_err() {
        return Some(all); // the call fails as out of memory
    }
    for record in rest.chunks_exact_mut(record_bytes) {
        let context = usize::from(number == 1)
            + 2 * usize::from(number >= returns)
            + 4 * usize::from(had_other_time);
        let changed = decoder.symbol(bytes_of(&mut changed_models[context], 128));
        if changed & 64 != 0 {
            return None;
        }
        let has_other_time = changed & 16 != 0;
        if changed & 4 != 0 {
            returns = decoder.symbol(bytes_of(&mut returns_models[returns], 16));
        }
        number = match changed & 3 {
            0 => number,
            1 => (number + 1) % 16,
            2 => (number + 15) % 16,
            _ if has_other_time => decoder.symbol(bytes_of(&mut number_models[number], 16)),
            _ => (number + 2 + decoder.symbol(bytes_of(&mut same_time_model, 13))) % 16,
        };
        let is_single = returns == 1;
        let of_steps =
            usize::from(CONTEXT_OF_RETURN[returns][number]) << 1 | usize::from(has_other_time);
        let step = x_integers.next(decoder, steps_x[of_steps].get(), usize::from(is_single));
        x = x.wrapping_add(step);
        steps_x[of_steps].add(step);
        let of_y = usize::from(is_single) + (x_integers.bits.min(20) & !1) as usize;
        let step = y_integers.next(decoder, steps_y[of_steps].get(), of_y);
        y = y.wrapping_add(step);
        steps_y[of_steps].add(step);
        record[0..4].copy_from_slice(&x.to_le_bytes());
        record[4..8].copy_from_slice(&y.to_le_bytes());
        record[RETURNS_AT] = (number | returns << 4) as u8;
        let level = returns.abs_diff(number).min(MOST_LEVEL);
        let z = heights.next(level, is_single, (x_integers.bits + y_integers.bits) / 2);
        record[Z_AT..][..4].copy_from_slice(&z.to_le_bytes());
        all.push(Told {
            order: 2 * u8::from(number == 1) + u8::from(number >= returns),
            has_other_time,
            has_other_angle: changed & 8 != 0,
            has_other_source: changed & 32 != 0,
        });
        had_other_time = has_other_time;
        if decoder.is_past() {
            break; // which the caller sees
        }
    }
    Some(all)
}

/// Fills `out` with whole records, of which those behind the last one within the steps need not be.
pub fn decode(packed: &[u8], items: &Items, out: &mut [u8], within: Option<&Within>) -> Decoded {
    let record_bytes = items.record_bytes();
    let mut count = out.len() / record_bytes;
    if count == 0 {
        return Decoded::Records(0);
    }
    let Some(mut layers) = Layers::of(packed, record_bytes, items.layers()) else {
        return Decoded::CutOff;
    };
    out[..record_bytes].copy_from_slice(&packed[..record_bytes]);
    if let Some(mut places) = layers.next() {
        let first_z = i32::from_le_bytes(out[Z_AT..][..4].try_into().unwrap());
        let mut heights = Heights {
            decoder: layers.next(),
            integers: Integers::new(32, 20),
            last: [first_z; MOST_LEVEL + 1],
        };
        let Some(told) = fill_places(&mut places, &mut heights, out, record_bytes) else {
            return Decoded::OfSeveralChannels;
        };
        if places.is_past() || heights.is_past() {
            return Decoded::CutOff;
        }
        if let Some(within) = within {
            let mut all = out.chunks_exact(record_bytes);
            count = all.rposition(|record| within.holds(record)).map_or(0, |last| last + 1);
        }
        let told = &told[..count.saturating_sub(1)];
        if !fill_attributes(&mut layers, items, told, out, record_bytes) {
            return Decoded::CutOff;
        }
    } else if count > 1 {
        return Decoded::CutOff;
    }
    Decoded::Records(count)
}
