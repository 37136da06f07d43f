// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

//! All attributes of a layered chunk but places and returns. Each layer is a chain in which a symbol waits for the one
//! before; so all of them go on point by point, and what one waits for the others fill.

use crate::coder::{bytes_of, Bytes, Decoder, Lazy};
use crate::layered::{Items, Layers, Told, COLOUR_BYTES, CORE_BYTES, INFRARED_BYTES};
use crate::numbers::{Colours, Integers, Times};

// Places in a record.
const INTENSITY_AT: usize = 12;
const FLAGS_AT: usize = 15;
const CLASS_AT: usize = 16;
const USER_AT: usize = 17;
const ANGLE_AT: usize = 18;
const SOURCE_AT: usize = 20;
const TIME_AT: usize = 22;

/// One attribute: its code, where it has any, and the value of the last point.
struct Attribute<'a, const BYTES: usize> {
    at: usize,
    decoder: Option<Decoder<'a>>,
    value: [u8; BYTES],
}

impl<'a, const BYTES: usize> Attribute<'a, BYTES> {
    fn new(at: usize, decoder: Option<Decoder<'a>>, first: &[u8]) -> Self {
        Attribute { at, decoder, value: first[at..][..BYTES].try_into().unwrap() }
    }

    /// Of the next point: next(decoder, value before), where there is code; else the value stays. False where the code
    /// ends before.
    #[inline(always)]
    fn put(
        &mut self,
        record: &mut [u8],
        next: impl FnOnce(&mut Decoder, [u8; BYTES]) -> [u8; BYTES],
    ) -> bool {
        let mut is_whole = true;
        if let Some(decoder) = &mut self.decoder {
            self.value = next(decoder, self.value);
            is_whole = !decoder.is_past();
        }
        record[self.at..][..BYTES].copy_from_slice(&self.value);
        is_whole
    }
}

fn models_of(count: usize) -> Vec<Lazy<Bytes>> {
    (0..count).map(|_| None).collect()
}

/// Of the points behind the first one that are told of; false where a layer ends before them.
pub fn fill_attributes(
    layers: &mut Layers,
    items: &Items,
    told: &[Told],
    records: &mut [u8],
    record_bytes: usize,
) -> bool {
    let (first, rest) = records.split_at_mut(record_bytes);
    let mut class = Attribute::new(CLASS_AT, layers.next(), first);
    let mut class_models = models_of(64);
    let mut flags = Attribute::new(FLAGS_AT, layers.next(), first);
    let mut flags_models = models_of(64);
    let channel = first[FLAGS_AT] & 0x30;
    let mut intensity = Attribute::<2>::new(INTENSITY_AT, layers.next(), first);
    let mut intensity_integers = Integers::new(16, 4);
    let mut intensities = [u16::from_le_bytes(intensity.value); 8];
    let mut angle = Attribute::<2>::new(ANGLE_AT, layers.next(), first);
    let mut angle_integers = Integers::new(16, 2);
    let mut user = Attribute::new(USER_AT, layers.next(), first);
    let mut user_models = models_of(64);
    let mut source = Attribute::<2>::new(SOURCE_AT, layers.next(), first);
    let mut source_integers = Integers::new(16, 1);
    let mut time = Attribute::<8>::new(TIME_AT, layers.next(), first);
    let mut times = Times::new(time.value, false);
    let mut rest_of = RestOfItems::new(layers, items, first);

    rest.chunks_exact_mut(record_bytes).zip(told).all(|(record, told)| {
        class.put(record, |decoder, [class]| {
            let context = usize::from(class & 31) << 1 | usize::from(told.order == 3);
            [decoder.symbol(bytes_of(&mut class_models[context], 256)) as u8]
        }) && flags.put(record, |decoder, [flags]| {
            // As LASzip has them: edge, direction, four flags of the class; the channel stands between them in a record.
            let context = usize::from(flags >> 2 & 0x30 | flags & 15);
            let symbol = decoder.symbol(bytes_of(&mut flags_models[context], 64)) as u8;
            [(symbol & 0x20) << 2 | (symbol & 0x10) << 2 | channel | symbol & 15]
        }) && intensity.put(record, |decoder, _| {
            let order = usize::from(told.order);
            let intensity = &mut intensities[order << 1 | usize::from(told.has_other_time)];
            *intensity = intensity_integers.next(decoder, i32::from(*intensity), order) as u16;
            intensity.to_le_bytes()
        }) && angle.put(record, |decoder, angle| {
            if !told.has_other_angle {
                return angle;
            }
            let foretold = i32::from(i16::from_le_bytes(angle));
            let context = usize::from(told.has_other_time);
            (angle_integers.next(decoder, foretold, context) as i16).to_le_bytes()
        }) && user.put(record, |decoder, [user]| {
            [decoder.symbol(bytes_of(&mut user_models[usize::from(user / 4)], 256)) as u8]
        }) && source.put(record, |decoder, source| {
            if !told.has_other_source {
                return source;
            }
            let foretold = i32::from(u16::from_le_bytes(source));
            (source_integers.next(decoder, foretold, 0) as u16).to_le_bytes()
        }) && time.put(record, |decoder, time| {
            if told.has_other_time {
                times.next(decoder)
            } else {
                time
            }
        }) && rest_of.put(record)
    })
}

/// Colours, infrared and extra bytes.
struct RestOfItems<'a> {
    colour: Option<(Attribute<'a, COLOUR_BYTES>, Colours)>,
    infrared: Option<(Attribute<'a, INFRARED_BYTES>, Infrared)>,
    extra: Vec<(Attribute<'a, 1>, Lazy<Bytes>)>,
}

/// Which of the two bytes changed, and by how much.
struct Infrared {
    changed: Lazy<Bytes>,
    bytes: [Lazy<Bytes>; INFRARED_BYTES],
}

impl Infrared {
    #[inline(always)]
    fn next(&mut self, decoder: &mut Decoder, mut value: [u8; INFRARED_BYTES]) -> [u8; 2] {
        let changed = decoder.symbol(bytes_of(&mut self.changed, 4));
        for (half, model) in self.bytes.iter_mut().enumerate() {
            if changed >> half & 1 != 0 {
                let step = decoder.symbol(bytes_of(model, 256)) as u8;
                value[half] = value[half].wrapping_add(step);
            }
        }
        value
    }
}

impl<'a> RestOfItems<'a> {
    fn new(layers: &mut Layers<'a>, items: &Items, first: &[u8]) -> Self {
        let mut at = CORE_BYTES;
        let colour = items.has_colour.then(|| {
            let colour = Attribute::new(at, layers.next(), first);
            let colours = Colours::new(colour.value);
            (colour, colours)
        });
        at += if items.has_colour { COLOUR_BYTES } else { 0 };
        let infrared = items.has_infrared.then(|| {
            let models = Infrared { changed: None, bytes: [const { None }; INFRARED_BYTES] };
            (Attribute::new(at, layers.next(), first), models)
        });
        at += if items.has_infrared { INFRARED_BYTES } else { 0 };
        let extra =
            (at..first.len()).map(|at| (Attribute::new(at, layers.next(), first), None)).collect();
        RestOfItems { colour, infrared, extra }
    }

    #[inline(always)]
    fn put(&mut self, record: &mut [u8]) -> bool {
        if let Some((colour, colours)) = &mut self.colour {
            if !colour.put(record, |decoder, _| colours.next(decoder)) {
                return false;
            }
        }
        if let Some((infrared, models)) = &mut self.infrared {
            if !infrared.put(record, |decoder, value| models.next(decoder, value)) {
                return false;
            }
        }
        self.extra.iter_mut().all(|(extra, model)| {
            extra.put(record, |decoder, [value]| {
                [value.wrapping_add(decoder.symbol(bytes_of(model, 256)) as u8)]
            })
        })
    }
}
