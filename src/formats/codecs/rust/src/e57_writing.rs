// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

//! E57 written: scans with their poses, from rows of numbers.

use crate::e57_scans::{ScanColumn, INTEGER, SCALED, SINGLE};
use crate::reserve::was_refused;
use crate::{guarded, silence_panics, Message};
use e57::{
    E57Writer, Extension, PointCloudWriter, Quaternion, Record, RecordDataType, RecordName,
    RecordValue, Transform, Translation,
};
use std::ffi::{c_char, c_void, CStr};
use std::io::{Error, ErrorKind, Read, Seek, SeekFrom, Write};

/// The caller's file: both give less than 0 when they fail.
#[repr(C)]
pub struct Sink {
    context: *mut c_void,
    read: extern "C" fn(*mut c_void, u64, *mut u8, u64) -> i64,
    write: extern "C" fn(*mut c_void, u64, *const u8, u64) -> i64,
}

struct File {
    sink: Sink,
    at: u64,
    size: u64,
}

impl Read for File {
    fn read(&mut self, out: &mut [u8]) -> std::io::Result<usize> {
        if was_refused() {
            return Err(Error::from(ErrorKind::OutOfMemory));
        }
        let wanted = (out.len() as u64).min(self.size.saturating_sub(self.at));
        if wanted == 0 {
            return Ok(0);
        }
        let count = (self.sink.read)(self.sink.context, self.at, out.as_mut_ptr(), wanted);
        if count < 0 {
            return Err(Error::from(ErrorKind::Other));
        }
        self.at += count as u64;
        Ok(count as usize)
    }
}

impl Write for File {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        if was_refused() {
            return Err(Error::from(ErrorKind::OutOfMemory));
        }
        let count = bytes.len() as u64;
        if (self.sink.write)(self.sink.context, self.at, bytes.as_ptr(), count) < 0 {
            return Err(Error::from(ErrorKind::Other));
        }
        self.at += count;
        self.size = self.size.max(self.at);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

impl Seek for File {
    fn seek(&mut self, to: SeekFrom) -> std::io::Result<u64> {
        let at = match to {
            SeekFrom::Start(at) => Some(at),
            SeekFrom::Current(by) => self.at.checked_add_signed(by),
            SeekFrom::End(by) => self.size.checked_add_signed(by),
        };
        self.at = at.ok_or_else(|| Error::from(ErrorKind::InvalidInput))?;
        Ok(self.at)
    }
}

pub struct Writing {
    scan: Option<PointCloudWriter<'static, File>>, // of `file`: goes before it
    kinds: Vec<RecordDataType>,
    file: Box<E57Writer<File>>,
}

/// What a column is called in a file: of the standard, or of the extensions "nor" and "jalon".
fn name_of(text: &str) -> RecordName {
    match text {
        "cartesianX" => RecordName::CartesianX,
        "cartesianY" => RecordName::CartesianY,
        "cartesianZ" => RecordName::CartesianZ,
        "intensity" => RecordName::Intensity,
        "isIntensityInvalid" => RecordName::IsIntensityInvalid,
        "colorRed" => RecordName::ColorRed,
        "colorGreen" => RecordName::ColorGreen,
        "colorBlue" => RecordName::ColorBlue,
        "rowIndex" => RecordName::RowIndex,
        "columnIndex" => RecordName::ColumnIndex,
        "returnCount" => RecordName::ReturnCount,
        "returnIndex" => RecordName::ReturnIndex,
        "timeStamp" => RecordName::TimeStamp,
        "isTimeStampInvalid" => RecordName::IsTimeStampInvalid,
        other => {
            let (namespace, name) = other.split_once(':').unwrap_or(("jalon", other));
            RecordName::Unknown { namespace: namespace.to_owned(), name: name.to_owned() }
        }
    }
}

fn kind_of(column: &ScanColumn) -> RecordDataType {
    let (min, max) = (column.min as i64, column.max as i64);
    match column.kind {
        INTEGER => RecordDataType::Integer { min, max },
        SCALED => {
            RecordDataType::ScaledInteger { min, max, scale: column.scale, offset: column.offset }
        }
        SINGLE => RecordDataType::F32,
        _ => RecordDataType::F64,
    }
}

unsafe fn text(bytes: *const c_char) -> String {
    // What stands in CDATA may not end it.
    CStr::from_ptr(bytes).to_string_lossy().replace("]]>", "]] >")
}

#[no_mangle]
pub unsafe extern "C" fn jc_e57_create(
    sink: Sink,
    guid: *const c_char,
    crs: *const c_char,
    out: *mut *mut Writing,
    message: Message,
) -> i32 {
    silence_panics();
    guarded(&message, || {
        let mut file = E57Writer::new(File { sink, at: 0, size: 0 }, &text(guid))
            .map_err(|e| e.to_string())?;
        let crs = text(crs);
        file.set_coordinate_metadata(if crs.is_empty() { None } else { Some(crs) });
        for (namespace, url) in [
            ("nor", "http://www.libe57.org/E57_NOR_surface_normals.txt"),
            ("jalon", "urn:jalon:fields"),
        ] {
            file.register_extension(Extension::new(namespace, url)).map_err(|e| e.to_string())?;
        }
        let file = Box::new(file);
        *out = Box::into_raw(Box::new(Writing { scan: None, kinds: Vec::new(), file }));
        Ok(())
    })
}

/// pose: w x y z of the rotation, then the translation; null where the scan has none.
#[no_mangle]
pub unsafe extern "C" fn jc_e57_begin(
    writing: *mut Writing,
    guid: *const c_char,
    name: *const c_char,
    pose: *const f64,
    columns: *const ScanColumn,
    count: u64,
    message: Message,
) -> i32 {
    guarded(&message, || {
        let writing = &mut *writing;
        let columns = std::slice::from_raw_parts(columns, count as usize);
        writing.kinds = columns.iter().map(kind_of).collect();
        let prototype = columns
            .iter()
            .map(|c| Record { name: name_of(&text(c.name)), data_type: kind_of(c) })
            .collect();
        // SAFETY: the writer lives in a box of the same object, is touched by nothing else while
        // `scan` is there, and goes after it.
        let file: &'static mut E57Writer<File> =
            &mut *(writing.file.as_mut() as *mut E57Writer<File>);
        let mut scan =
            file.add_pointcloud(&text(guid), prototype).map_err(|e| e.to_string())?;
        scan.set_name(Some(text(name)));
        if !pose.is_null() {
            let p = std::slice::from_raw_parts(pose, 7);
            scan.set_transform(Some(Transform {
                rotation: Quaternion { w: p[0], x: p[1], y: p[2], z: p[3] },
                translation: Translation { x: p[4], y: p[5], z: p[6] },
            }));
        }
        writing.scan = Some(scan);
        Ok(())
    })
}

/// Rows of doubles, as many numbers a row as there are columns; of scaled integers the real value.
#[no_mangle]
pub unsafe extern "C" fn jc_e57_add(
    writing: *mut Writing,
    rows: *const f64,
    count: u64,
    message: Message,
) -> i32 {
    guarded(&message, || {
        let writing = &mut *writing;
        let scan = writing.scan.as_mut().ok_or("no scan was begun")?;
        let kinds = &writing.kinds;
        let rows = std::slice::from_raw_parts(rows, count as usize * kinds.len());
        for row in rows.chunks_exact(kinds.len()) {
            let values = row.iter().zip(kinds).map(|(value, kind)| value_of(*value, kind));
            scan.add_point(values.collect()).map_err(|e| e.to_string())?;
        }
        Ok(())
    })
}

fn value_of(value: f64, kind: &RecordDataType) -> RecordValue {
    match kind {
        RecordDataType::Integer { .. } => RecordValue::Integer(value.round() as i64),
        RecordDataType::ScaledInteger { scale, offset, .. } => {
            RecordValue::ScaledInteger(((value - offset) / scale).round() as i64)
        }
        RecordDataType::Single { .. } => RecordValue::Single(value as f32),
        RecordDataType::Double { .. } => RecordValue::Double(value),
    }
}

#[no_mangle]
pub unsafe extern "C" fn jc_e57_end(writing: *mut Writing, message: Message) -> i32 {
    guarded(&message, || {
        let mut scan = (*writing).scan.take().ok_or("no scan was begun")?;
        scan.finalize().map_err(|e| e.to_string())
    })
}

#[no_mangle]
pub unsafe extern "C" fn jc_e57_finish(writing: *mut Writing, message: Message) -> i32 {
    guarded(&message, || (*writing).file.finalize().map_err(|e| e.to_string()))
}

#[no_mangle]
pub unsafe extern "C" fn jc_e57_discard(writing: *mut Writing) {
    if !writing.is_null() {
        let message = Message { bytes: std::ptr::null_mut(), room: 0 };
        guarded(&message, || {
            drop(Box::from_raw(writing));
            Ok(())
        });
    }
}
