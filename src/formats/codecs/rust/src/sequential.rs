// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

//! A chunk of the point formats 0 to 3 as LASzip's second version packs it: point by point, in one stream of code.

use crate::coder::{bytes_of, Bytes, Decoder, Lazy};
use crate::numbers::{Colours, Integers, Median, Times};

const CORE_BYTES: usize = 20;
const TIME_BYTES: usize = 8;
const COLOUR_BYTES: usize = 6;

/// What a record has behind what all have.
pub struct Items {
    pub has_time: bool,
    pub has_colour: bool,
    pub extra_bytes: usize,
}

impl Items {
    fn colour_at(&self) -> usize {
        CORE_BYTES + if self.has_time { TIME_BYTES } else { 0 }
    }
    fn extra_at(&self) -> usize {
        self.colour_at() + if self.has_colour { COLOUR_BYTES } else { 0 }
    }
    pub fn record_bytes(&self) -> usize {
        self.extra_at() + self.extra_bytes
    }
}

/// LASzip's contexts of the number of returns (row) and of the return (column).
const CONTEXT_OF_RETURN: [[u8; 8]; 8] = [
    [15, 14, 13, 12, 11, 10, 9, 8],
    [14, 0, 1, 3, 6, 10, 10, 9],
    [13, 1, 2, 4, 7, 11, 11, 10],
    [12, 3, 4, 5, 8, 12, 12, 11],
    [11, 6, 7, 8, 9, 13, 13, 12],
    [10, 10, 11, 12, 13, 14, 14, 13],
    [9, 10, 11, 12, 13, 14, 15, 14],
    [8, 9, 10, 11, 12, 13, 14, 15],
];

/// The attributes that all records have, as the last one has them, and what foretells the next.
struct Core {
    x: i32,
    y: i32,
    z: i32,
    intensity: u16,
    flags: u8,
    class: u8,
    angle: u8,
    user: u8,
    source: u16,
    intensities: [u16; 16],
    steps_x: [Median; 16],
    steps_y: [Median; 16],
    heights: [i32; 8],
    changed: Lazy<Bytes>,
    angle_models: [Lazy<Bytes>; 2],
    flags_models: Vec<Lazy<Bytes>>,
    class_models: Vec<Lazy<Bytes>>,
    user_models: Vec<Lazy<Bytes>>,
    intensity_integers: Integers,
    source_integers: Integers,
    x_integers: Integers,
    y_integers: Integers,
    z_integers: Integers,
}

fn models_of_bytes() -> Vec<Lazy<Bytes>> {
    (0..256).map(|_| None).collect()
}

impl Core {
    fn new(first: &[u8; CORE_BYTES]) -> Self {
        let whole = |at: usize| {
            i32::from_le_bytes([first[at], first[at + 1], first[at + 2], first[at + 3]])
        };
        Core {
            x: whole(0),
            y: whole(4),
            z: whole(8),
            intensity: 0, // LASzip's encoder begins so
            flags: first[14],
            class: first[15],
            angle: first[16],
            user: first[17],
            source: u16::from_le_bytes([first[18], first[19]]),
            intensities: [0; 16],
            steps_x: [Median::new(); 16],
            steps_y: [Median::new(); 16],
            heights: [0; 8],
            changed: None,
            angle_models: [None, None],
            flags_models: models_of_bytes(),
            class_models: models_of_bytes(),
            user_models: models_of_bytes(),
            intensity_integers: Integers::new(16, 4),
            source_integers: Integers::new(16, 1),
            x_integers: Integers::new(32, 2),
            y_integers: Integers::new(32, 22),
            z_integers: Integers::new(32, 20),
        }
    }

    #[inline(always)]
    fn next(&mut self, decoder: &mut Decoder, out: &mut [u8; CORE_BYTES]) {
        let changed = decoder.symbol(bytes_of(&mut self.changed, 64));
        if changed & 32 != 0 {
            let model = &mut self.flags_models[usize::from(self.flags)];
            self.flags = decoder.symbol(bytes_of(model, 256)) as u8;
        }
        let (of_pulse, returns) = (usize::from(self.flags & 7), usize::from(self.flags >> 3 & 7));
        let context = usize::from(CONTEXT_OF_RETURN[returns][of_pulse]);
        if changed != 0 {
            self.next_attributes(decoder, changed, context);
        }
        self.next_place(decoder, context, returns.abs_diff(of_pulse), usize::from(returns == 1));
        self.put(out);
    }

    #[inline(always)]
    fn next_attributes(&mut self, decoder: &mut Decoder, changed: usize, context: usize) {
        if changed & 16 != 0 {
            let foretold = i32::from(self.intensities[context]);
            self.intensities[context] =
                self.intensity_integers.next(decoder, foretold, context.min(3)) as u16;
        }
        self.intensity = self.intensities[context];
        if changed & 8 != 0 {
            let model = &mut self.class_models[usize::from(self.class)];
            self.class = decoder.symbol(bytes_of(model, 256)) as u8;
        }
        if changed & 4 != 0 {
            let model = &mut self.angle_models[usize::from(self.flags >> 6 & 1)];
            let step = decoder.symbol(bytes_of(model, 256)) as u8;
            self.angle = self.angle.wrapping_add(step);
        }
        if changed & 2 != 0 {
            let model = &mut self.user_models[usize::from(self.user)];
            self.user = decoder.symbol(bytes_of(model, 256)) as u8;
        }
        if changed & 1 != 0 {
            self.source = self.source_integers.next(decoder, i32::from(self.source), 0) as u16;
        }
    }

    #[inline(always)]
    fn next_place(&mut self, decoder: &mut Decoder, context: usize, level: usize, single: usize) {
        let step = self.x_integers.next(decoder, self.steps_x[context].get(), single);
        self.x = self.x.wrapping_add(step);
        self.steps_x[context].add(step);
        let bits = self.x_integers.bits;
        let of_y = single + (bits.min(20) & !1) as usize;
        let step = self.y_integers.next(decoder, self.steps_y[context].get(), of_y);
        self.y = self.y.wrapping_add(step);
        self.steps_y[context].add(step);
        let bits = (bits + self.y_integers.bits) / 2;
        let of_z = single + (bits.min(18) & !1) as usize;
        self.z = self.z_integers.next(decoder, self.heights[level], of_z);
        self.heights[level] = self.z;
    }

    #[inline(always)]
    fn put(&self, out: &mut [u8; CORE_BYTES]) {
        out[0..4].copy_from_slice(&self.x.to_le_bytes());
        out[4..8].copy_from_slice(&self.y.to_le_bytes());
        out[8..12].copy_from_slice(&self.z.to_le_bytes());
        out[12..14].copy_from_slice(&self.intensity.to_le_bytes());
        out[14..18].copy_from_slice(&[self.flags, self.class, self.angle, self.user]);
        out[18..20].copy_from_slice(&self.source.to_le_bytes());
    }
}

/// Fills `out` with whole records; false where the chunk ends before them.
pub fn decode(packed: &[u8], items: &Items, out: &mut [u8]) -> bool {
    let (time_at, colour_at, extra_at) = (CORE_BYTES, items.colour_at(), items.extra_at());
    let record_bytes = items.record_bytes();
    if packed.len() < record_bytes || out.len() < record_bytes {
        return out.is_empty();
    }
    let (first, code) = packed.split_at(record_bytes);
    out[..record_bytes].copy_from_slice(first);
    let mut core = Core::new(first[..CORE_BYTES].try_into().unwrap());
    let mut times = items
        .has_time
        .then(|| Times::new(first[time_at..][..TIME_BYTES].try_into().unwrap(), true));
    let mut colours = items
        .has_colour
        .then(|| Colours::new(first[colour_at..][..COLOUR_BYTES].try_into().unwrap()));
    let mut extra = first[extra_at..].to_vec();
    let mut extra_models: Vec<Lazy<Bytes>> = extra.iter().map(|_| None).collect();
    let mut decoder = Decoder::new(code);
    for record in out[record_bytes..].chunks_exact_mut(record_bytes) {
        core.next(&mut decoder, (&mut record[..CORE_BYTES]).try_into().unwrap());
        if let Some(times) = &mut times {
            record[time_at..][..TIME_BYTES].copy_from_slice(&times.next(&mut decoder));
        }
        if let Some(colours) = &mut colours {
            record[colour_at..][..COLOUR_BYTES].copy_from_slice(&colours.next(&mut decoder));
        }
        for (value, model) in extra.iter_mut().zip(&mut extra_models) {
            *value = value.wrapping_add(decoder.symbol(bytes_of(model, 256)) as u8);
        }
        record[extra_at..].copy_from_slice(&extra);
        if decoder.is_past() {
            return false;
        }
    }
    true
}
