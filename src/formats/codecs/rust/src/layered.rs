// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

//! A chunk of the point formats 6 to 8 as LASzip's third and fourth version pack it: each attribute in a stream of code
//! of its own, foretold by what the first of them tells of returns. Points of one scanner channel, which nearly all
//! files have; others are left to the crate.

use crate::coder::{bytes_of, Bytes, Decoder, Lazy};
use crate::numbers::{Colours, Integers, Median, Times};

const CORE_BYTES: usize = 30;
const COLOUR_BYTES: usize = 6;
const INFRARED_BYTES: usize = 2;
const COUNT_BYTES: usize = 4; // behind the first record
const SIZE_BYTES: usize = 4; // of a layer
const CORE_LAYERS: usize = 9;

// Places in a record.
const Z_AT: usize = 8;
const INTENSITY_AT: usize = 12;
const RETURNS_AT: usize = 14;
const FLAGS_AT: usize = 15;
const CLASS_AT: usize = 16;
const USER_AT: usize = 17;
const ANGLE_AT: usize = 18;
const SOURCE_AT: usize = 20;
const TIME_AT: usize = 22;

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
struct Told {
    is_single: bool,
    order: u8, // 2: the first return, 1: the last one, 3: both
    level: u8,
    place_bits: u8, // of the steps of x and y, about
    has_other_time: bool,
    has_other_angle: bool,
    has_other_source: bool,
}

/// The layers, each of which ends at its size.
struct Layers<'a> {
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
    fn next(&mut self) -> Option<Decoder<'a>> {
        let (size, sizes) = self.sizes.split_first_chunk::<SIZE_BYTES>()?;
        self.sizes = sizes;
        let (layer, code) = self.code.split_at_checked(u32::from_le_bytes(*size) as usize)?;
        self.code = code;
        (!layer.is_empty()).then(|| Decoder::new(layer))
    }
}

/// All records, of which the first is there.
struct Records<'a> {
    bytes: &'a mut [u8],
    record_bytes: usize,
}

impl Records<'_> {
    /// One attribute of all: next(decoder, value before, what is told of the point), where there is code; else the first
    /// value stays. False where the code ends before them.
    #[inline(always)]
    fn fill<const BYTES: usize>(
        &mut self,
        at: usize,
        decoder: Option<Decoder>,
        told: &[Told],
        mut next: impl FnMut(&mut Decoder, [u8; BYTES], &Told) -> [u8; BYTES],
    ) -> bool {
        let mut records = self.bytes.chunks_exact_mut(self.record_bytes);
        let mut value: [u8; BYTES] = match records.next() {
            Some(first) => first[at..][..BYTES].try_into().unwrap(),
            None => return true,
        };
        let Some(mut decoder) = decoder else {
            records.for_each(|record| record[at..][..BYTES].copy_from_slice(&value));
            return true;
        };
        for (record, told) in records.zip(told) {
            value = next(&mut decoder, value, told);
            record[at..][..BYTES].copy_from_slice(&value);
            if decoder.is_past() {
                return false;
            }
        }
        true
    }
}

/// x, y and the numbers of returns of all points; None where another channel comes.
fn fill_places(
    decoder: &mut Decoder,
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
        all.push(Told {
            is_single,
            order: 2 * u8::from(number == 1) + u8::from(number >= returns),
            level: returns.abs_diff(number).min(MOST_LEVEL) as u8,
            place_bits: ((x_integers.bits + y_integers.bits) / 2) as u8,
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
    let mut records = Records { bytes: out, record_bytes };
    if let Some(mut places) = layers.next() {
        let Some(told) = fill_places(&mut places, records.bytes, record_bytes) else {
            return Decoded::OfSeveralChannels;
        };
        if places.is_past() || !fill_heights(&mut layers, &told, &mut records) {
            return Decoded::CutOff;
        }
        if let Some(within) = within {
            let mut all = records.bytes.chunks_exact(record_bytes);
            count = all.rposition(|record| within.holds(record)).map_or(0, |last| last + 1);
        }
        let told = &told[..count.saturating_sub(1)];
        if !fill_attributes(&mut layers, items, told, &mut records) {
            return Decoded::CutOff;
        }
    } else if count > 1 {
        return Decoded::CutOff;
    }
    Decoded::Records(count)
}

fn fill_heights(layers: &mut Layers, told: &[Told], records: &mut Records) -> bool {
    let mut integers = Integers::new(32, 20);
    let first = i32::from_le_bytes(records.bytes[Z_AT..][..4].try_into().unwrap());
    let mut heights = [first; MOST_LEVEL + 1];
    records.fill(Z_AT, layers.next(), told, |decoder, _: [u8; 4], told| {
        let height = &mut heights[usize::from(told.level)];
        let context = usize::from(told.is_single) + usize::from(told.place_bits.min(18) & !1);
        *height = integers.next(decoder, *height, context);
        height.to_le_bytes()
    })
}

fn models_of(count: usize) -> Vec<Lazy<Bytes>> {
    (0..count).map(|_| None).collect()
}

/// All but place and returns; false where a layer ends before its points.
fn fill_attributes(
    layers: &mut Layers,
    items: &Items,
    told: &[Told],
    records: &mut Records,
) -> bool {
    let first: [u8; CORE_BYTES] = records.bytes[..CORE_BYTES].try_into().unwrap();
    let mut models = models_of(64);
    let is_whole = records.fill(CLASS_AT, layers.next(), told, |decoder, [class], told| {
        let context = usize::from(class & 31) << 1 | usize::from(told.order == 3);
        [decoder.symbol(bytes_of(&mut models[context], 256)) as u8]
    });

    // As LASzip has them: edge, direction, four flags of the class; the channel stands between them in a record.
    let channel = first[FLAGS_AT] & 0x30;
    let mut models = models_of(64);
    let is_whole = is_whole
        && records.fill(FLAGS_AT, layers.next(), told, |decoder, [flags], _| {
            let context = usize::from(flags >> 2 & 0x30 | flags & 15);
            let symbol = decoder.symbol(bytes_of(&mut models[context], 64)) as u8;
            [(symbol & 0x20) << 2 | (symbol & 0x10) << 2 | channel | symbol & 15]
        });

    let mut integers = Integers::new(16, 4);
    let mut intensities = [u16::from_le_bytes([first[INTENSITY_AT], first[INTENSITY_AT + 1]]); 8];
    let is_whole = is_whole
        && records.fill(INTENSITY_AT, layers.next(), told, |decoder, _: [u8; 2], told| {
            let order = usize::from(told.order);
            let intensity = &mut intensities[order << 1 | usize::from(told.has_other_time)];
            *intensity = integers.next(decoder, i32::from(*intensity), order) as u16;
            intensity.to_le_bytes()
        });

    let mut integers = Integers::new(16, 2);
    let is_whole = is_whole
        && records.fill(ANGLE_AT, layers.next(), told, |decoder, angle: [u8; 2], told| {
            if !told.has_other_angle {
                return angle;
            }
            let foretold = i32::from(i16::from_le_bytes(angle));
            (integers.next(decoder, foretold, usize::from(told.has_other_time)) as i16)
                .to_le_bytes()
        });

    let mut models = models_of(64);
    let is_whole = is_whole
        && records.fill(USER_AT, layers.next(), told, |decoder, [user], _| {
            [decoder.symbol(bytes_of(&mut models[usize::from(user / 4)], 256)) as u8]
        });

    let mut integers = Integers::new(16, 1);
    let is_whole = is_whole
        && records.fill(SOURCE_AT, layers.next(), told, |decoder, source: [u8; 2], told| {
            if !told.has_other_source {
                return source;
            }
            let foretold = i32::from(u16::from_le_bytes(source));
            (integers.next(decoder, foretold, 0) as u16).to_le_bytes()
        });

    let mut times = Times::new(first[TIME_AT..].try_into().unwrap(), false);
    let is_whole = is_whole
        && records.fill(TIME_AT, layers.next(), told, |decoder, time: [u8; 8], told| {
            if told.has_other_time {
                times.next(decoder)
            } else {
                time
            }
        });

    is_whole && fill_rest(layers, items, told, records)
}

/// Colours, infrared and extra bytes.
fn fill_rest(layers: &mut Layers, items: &Items, told: &[Told], records: &mut Records) -> bool {
    let mut at = CORE_BYTES;
    if items.has_colour {
        let mut colours = Colours::new(records.bytes[at..][..COLOUR_BYTES].try_into().unwrap());
        if !records.fill(at, layers.next(), told, |decoder, _, _| colours.next(decoder)) {
            return false;
        }
        at += COLOUR_BYTES;
    }
    if items.has_infrared {
        let mut changed_model = None;
        let mut models = [None, None];
        let fill_infrared = |decoder: &mut Decoder, mut value: [u8; INFRARED_BYTES], _: &Told| {
            let changed = decoder.symbol(bytes_of(&mut changed_model, 4));
            for half in 0..INFRARED_BYTES {
                if changed >> half & 1 != 0 {
                    let step = decoder.symbol(bytes_of(&mut models[half], 256)) as u8;
                    value[half] = value[half].wrapping_add(step);
                }
            }
            value
        };
        if !records.fill(at, layers.next(), told, fill_infrared) {
            return false;
        }
        at += INFRARED_BYTES;
    }
    (at..records.record_bytes).all(|at| {
        let mut model = None;
        records.fill(at, layers.next(), told, |decoder, [value]: [u8; 1], _| {
            [value.wrapping_add(decoder.symbol(bytes_of(&mut model, 256)) as u8)]
        })
    })
}
