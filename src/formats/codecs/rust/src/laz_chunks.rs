// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

//! LAZ read: the record of the compressor, the table of chunks, one chunk from memory to memory. All the
//! reading of files and all threads are the caller's.

use crate::layered::Within;
use crate::{guarded, layered, sequential, silence_panics, Message};
use laz::laszip::{ChunkTable, CompressorType};
use laz::record::{
    LayeredPointRecordDecompressor, RecordDecompressor, SequentialPointRecordDecompressor,
};
use laz::{LazItemType, LazVlr};
use std::io::Cursor;

/// As in ../codecs.h.
#[repr(C)]
pub struct Layout {
    record_bytes: u64,
    chunk_points: u64,
    has_chunks: i32,
}

const VARIABLE: u64 = 0;

pub unsafe fn vlr_of(bytes: *const u8, count: u64) -> Result<LazVlr, String> {
    let vlr = LazVlr::from_buffer(std::slice::from_raw_parts(bytes, count as usize))
        .map_err(|e| e.to_string())?;
    if vlr.items().is_empty() {
        return Err("the record of the compressor names no items".to_owned());
    }
    Ok(vlr)
}

pub fn record_bytes_of(vlr: &LazVlr) -> usize {
    vlr.items().iter().map(|i| usize::from(i.size())).sum()
}

fn compressor_of(bytes: &[u8]) -> u16 {
    u16::from_le_bytes([bytes[0], bytes[1]])
}

#[no_mangle]
pub unsafe extern "C" fn jc_laz_layout(
    vlr: *const u8,
    vlr_bytes: u64,
    out: *mut Layout,
    message: Message,
) -> i32 {
    silence_panics();
    guarded(&message, || {
        let parsed = vlr_of(vlr, vlr_bytes)?;
        let compressor = compressor_of(std::slice::from_raw_parts(vlr, vlr_bytes as usize));
        if compressor == CompressorType::None as u16 {
            return Err("the points are marked as compressed by no compressor".to_owned());
        }
        *out = Layout {
            record_bytes: parsed.items().iter().map(|item| u64::from(item.size())).sum(),
            chunk_points: if parsed.uses_variable_size_chunks() {
                VARIABLE
            } else {
                u64::from(parsed.chunk_size())
            },
            has_chunks: i32::from(compressor != CompressorType::PointWise as u16),
        };
        Ok(())
    })
}

/// table: from the version on; counts (of variable chunks alone) and sizes have `room` entries.
#[no_mangle]
pub unsafe extern "C" fn jc_laz_chunks(
    table: *const u8,
    table_bytes: u64,
    variable: i32,
    counts: *mut u64,
    sizes: *mut u64,
    room: u64,
    message: Message,
) -> i32 {
    silence_panics();
    guarded(&message, || {
        let bytes = std::slice::from_raw_parts(table, table_bytes as usize);
        let number = match bytes.get(4..8) {
            Some(b) => u64::from(u32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            None => return Err("the chunk table is cut off".to_owned()),
        };
        if number != room {
            return Err("the chunk table has another number of chunks".to_owned());
        }
        let read = ChunkTable::read(&mut Cursor::new(bytes), variable != 0)
            .map_err(|e| format!("the chunk table cannot be read: {e}"))?;
        for (i, entry) in (&read).into_iter().enumerate() {
            *counts.add(i) = entry.point_count;
            *sizes.add(i) = entry.byte_count;
        }
        Ok(())
    })
}

/// What the layers of a chunk claim must lie in it: the decoder allocates what they say.
fn check_layers(vlr: &LazVlr, packed: &[u8], record_bytes: usize) -> Result<(), String> {
    let mut layers = 0usize;
    for item in vlr.items() {
        layers += match item.item_type() {
            LazItemType::Point14 => 9,
            LazItemType::RGB14 | LazItemType::WavePacket14 => 1,
            LazItemType::RGBNIR14 => 2,
            LazItemType::Byte14(count) => count as usize,
            _ => 0,
        };
    }
    let sizes_at = record_bytes + 4; // behind the first point and the number of points
    let sizes = packed
        .get(sizes_at..sizes_at + 4 * layers)
        .ok_or("the chunk is cut off before its layers")?;
    let claimed: u64 = sizes
        .chunks_exact(4)
        .map(|b| u64::from(u32::from_le_bytes([b[0], b[1], b[2], b[3]])))
        .sum();
    if claimed > (packed.len() - sizes_at - 4 * layers) as u64 {
        return Err("the layers of the chunk are longer than it".to_owned());
    }
    Ok(())
}

/// Does the chunk hold so many points? None of them is kept.
#[no_mangle]
pub unsafe extern "C" fn jc_laz_check(
    vlr: *const u8,
    vlr_bytes: u64,
    packed: *const u8,
    packed_bytes: u64,
    points: u64,
    message: Message,
) -> i32 {
    silence_panics();
    guarded(&message, || {
        let vlr = vlr_of(vlr, vlr_bytes)?;
        let packed = std::slice::from_raw_parts(packed, packed_bytes as usize);
        decode(&vlr, packed, Wanted::Count(points)).map(|_| ())
    })
}

/// Fills `out` with whole records.
#[no_mangle]
pub unsafe extern "C" fn jc_laz_decode(
    vlr: *const u8,
    vlr_bytes: u64,
    packed: *const u8,
    packed_bytes: u64,
    out: *mut u8,
    out_bytes: u64,
    message: Message,
) -> i32 {
    silence_panics();
    guarded(&message, || {
        let vlr = vlr_of(vlr, vlr_bytes)?;
        let packed = std::slice::from_raw_parts(packed, packed_bytes as usize);
        let out = std::slice::from_raw_parts_mut(out, out_bytes as usize);
        decode(&vlr, packed, Wanted::Records(out, None)).map(|_| ())
    })
}

/// The same, but records behind the last one between the steps (least x, y, z, most x, y, z) need not be there; their
/// number to be looked at.
#[no_mangle]
pub unsafe extern "C" fn jc_laz_decode_within(
    vlr: *const u8,
    vlr_bytes: u64,
    packed: *const u8,
    packed_bytes: u64,
    steps: *const i32,
    out: *mut u8,
    out_bytes: u64,
    records: *mut u64,
    message: Message,
) -> i32 {
    silence_panics();
    guarded(&message, || {
        let vlr = vlr_of(vlr, vlr_bytes)?;
        let packed = std::slice::from_raw_parts(packed, packed_bytes as usize);
        let out = std::slice::from_raw_parts_mut(out, out_bytes as usize);
        let [a, b, c, d, e, f] = *(steps as *const [i32; 6]);
        let within = Within { least: [a, b, c], most: [d, e, f] };
        *records = decode(&vlr, packed, Wanted::Records(out, Some(&within)))? as u64;
        Ok(())
    })
}

enum Wanted<'a> {
    Records(&'a mut [u8], Option<&'a Within>),
    Count(u64),
}

/// How many records are there.
fn decode(vlr: &LazVlr, packed: &[u8], mut wanted: Wanted) -> Result<usize, String> {
    let record_bytes = record_bytes_of(vlr);
    let is_layered = vlr.items()[0].version() >= 3;
    if is_layered {
        check_layers(vlr, packed, record_bytes)?;
    }
    if let Wanted::Records(out, within) = &mut wanted {
        if let Some(done) = decode_usual(vlr, packed, out, *within) {
            return done;
        }
    }
    let cursor = Cursor::new(packed);
    if is_layered {
        run(LayeredPointRecordDecompressor::new(cursor), vlr, record_bytes, wanted)
    } else {
        run(SequentialPointRecordDecompressor::new(cursor), vlr, record_bytes, wanted)
    }
}

/// By our own decoders, which are faster; none where they do not know the items.
fn decode_usual(
    vlr: &LazVlr,
    packed: &[u8],
    out: &mut [u8],
    within: Option<&Within>,
) -> Option<Result<usize, String>> {
    const CUT_OFF: &str = "it ends before its points";
    let version = vlr.items()[0].version();
    let mut kinds = vlr.items().iter().map(|item| item.item_type()).peekable();
    if vlr.items().iter().any(|item| item.version() != version) {
        return None;
    }
    let mut has = |wanted: LazItemType| kinds.next_if_eq(&wanted).is_some();
    if version == 2 && has(LazItemType::Point10) {
        let has_time = has(LazItemType::GpsTime);
        let has_colour = has(LazItemType::RGB12);
        let extra_bytes = match kinds.next() {
            Some(LazItemType::Byte(count)) => usize::from(count),
            Some(_) => return None,
            None => 0,
        };
        let items = sequential::Items { has_time, has_colour, extra_bytes };
        if kinds.next().is_some() || items.record_bytes() != record_bytes_of(vlr) {
            return None;
        }
        let is_whole = sequential::decode(packed, &items, out);
        Some(if is_whole { Ok(out.len() / items.record_bytes()) } else { Err(CUT_OFF.to_owned()) })
    } else if matches!(version, 3 | 4) && has(LazItemType::Point14) {
        let has_infrared = has(LazItemType::RGBNIR14);
        let has_colour = has_infrared || has(LazItemType::RGB14);
        let extra_bytes = match kinds.next() {
            Some(LazItemType::Byte14(count)) => usize::from(count),
            Some(_) => return None,
            None => 0,
        };
        let items = layered::Items { has_colour, has_infrared, extra_bytes };
        if kinds.next().is_some() || items.record_bytes() != record_bytes_of(vlr) {
            return None;
        }
        match layered::decode(packed, &items, out, within) {
            layered::Decoded::OfSeveralChannels => None,
            layered::Decoded::Records(count) => Some(Ok(count)),
            layered::Decoded::CutOff => Some(Err(CUT_OFF.to_owned())),
        }
    } else {
        None
    }
}

fn run<'a>(
    mut decoder: impl RecordDecompressor<Cursor<&'a [u8]>>,
    vlr: &LazVlr,
    record_bytes: usize,
    wanted: Wanted,
) -> Result<usize, String> {
    decoder.set_fields_from(vlr.items()).map_err(|e| e.to_string())?;
    if record_bytes == 0 || decoder.record_size() != record_bytes {
        return Err("the items of the compressor have other sizes than their kinds".to_owned());
    }
    match wanted {
        Wanted::Records(out, _) => out
            .chunks_exact_mut(record_bytes)
            .try_for_each(|point| decoder.decompress_next(point))
            .map(|()| out.len() / record_bytes),
        Wanted::Count(points) => {
            let mut point = vec![0; record_bytes];
            (0..points)
                .try_for_each(|_| decoder.decompress_next(&mut point))
                .map(|()| points as usize)
        }
    }
    .map_err(|e| e.to_string())
}
