// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

//! LAZ written: the record of the compressor, one chunk from memory to memory, the table of chunks.

use crate::laz_chunks::{record_bytes_of, vlr_of};
use crate::{guarded, silence_panics, Message};
use laz::laszip::{ChunkTable, ChunkTableEntry};
use laz::record::{
    LayeredPointRecordCompressor, RecordCompressor, SequentialPointRecordCompressor,
};
use laz::{LazItemRecordBuilder, LazVlr, LazVlrBuilder};

/// Bytes that the caller frees by jc_bytes_free().
#[repr(C)]
pub struct Bytes {
    data: *mut u8,
    count: u64,
    room: u64,
}

impl Bytes {
    fn of(bytes: Vec<u8>) -> Bytes {
        let mut bytes = std::mem::ManuallyDrop::new(bytes);
        Bytes {
            data: bytes.as_mut_ptr(),
            count: bytes.len() as u64,
            room: bytes.capacity() as u64,
        }
    }
}

#[no_mangle]
pub unsafe extern "C" fn jc_bytes_free(bytes: Bytes) {
    if !bytes.data.is_null() {
        drop(Vec::from_raw_parts(bytes.data, bytes.count as usize, bytes.room as usize));
    }
}

/// The record "laszip encoded" of a point format in chunks of one size; 0: each of its own.
#[no_mangle]
pub unsafe extern "C" fn jc_laz_record(
    format: u8,
    extra_bytes: u16,
    chunk_points: u32,
    out: *mut Bytes,
    message: Message,
) -> i32 {
    silence_panics();
    guarded(&message, || {
        let items = LazItemRecordBuilder::default_for_point_format_id(format, extra_bytes)
            .map_err(|e| e.to_string())?;
        let builder = LazVlrBuilder::new(items);
        let vlr = match chunk_points {
            0 => builder.with_variable_chunk_size().build(),
            points => builder.with_fixed_chunk_size(points).build(),
        };
        let mut bytes = Vec::new();
        vlr.write_to(&mut bytes).map_err(|e| e.to_string())?;
        *out = Bytes::of(bytes);
        Ok(())
    })
}

/// One chunk of whole records.
#[no_mangle]
pub unsafe extern "C" fn jc_laz_encode(
    vlr: *const u8,
    vlr_bytes: u64,
    records: *const u8,
    records_bytes: u64,
    out: *mut Bytes,
    message: Message,
) -> i32 {
    silence_panics();
    guarded(&message, || {
        let vlr = vlr_of(vlr, vlr_bytes)?;
        let record_bytes = record_bytes_of(&vlr);
        let records = std::slice::from_raw_parts(records, records_bytes as usize);
        let packed = if vlr.items()[0].version() >= 3 {
            pack(LayeredPointRecordCompressor::new(Vec::new()), &vlr, record_bytes, records)?
        } else {
            pack(SequentialPointRecordCompressor::new(Vec::new()), &vlr, record_bytes, records)?
        };
        *out = Bytes::of(packed);
        Ok(())
    })
}

fn pack<W>(
    mut encoder: impl RecordCompressor<W>,
    vlr: &LazVlr,
    record_bytes: usize,
    records: &[u8],
) -> Result<W, String> {
    encoder.set_fields_from(vlr.items()).map_err(|e| e.to_string())?;
    for point in records.chunks_exact(record_bytes) {
        encoder.compress_next(point).map_err(|e| e.to_string())?;
    }
    encoder.done().map_err(|e| e.to_string())?;
    Ok(encoder.into_inner())
}

/// The table of chunks, version first. counts: of the points of chunks that have each their own, else null.
#[no_mangle]
pub unsafe extern "C" fn jc_laz_table(
    vlr: *const u8,
    vlr_bytes: u64,
    counts: *const u64,
    sizes: *const u64,
    count: u64,
    out: *mut Bytes,
    message: Message,
) -> i32 {
    silence_panics();
    guarded(&message, || {
        let vlr = vlr_of(vlr, vlr_bytes)?;
        let mut table = ChunkTable::with_capacity(count as usize);
        for i in 0..count as usize {
            let point_count = if counts.is_null() { 0 } else { *counts.add(i) };
            table.push(ChunkTableEntry { point_count, byte_count: *sizes.add(i) });
        }
        let mut bytes = Vec::new();
        table.write_to(&mut bytes, &vlr).map_err(|e| e.to_string())?;
        *out = Bytes::of(bytes);
        Ok(())
    })
}
