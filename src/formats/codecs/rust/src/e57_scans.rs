// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

//! E57: scans with their poses and the columns of their records; the records are the caller's.

use crate::reserve::was_refused;
use crate::{guarded, silence_panics, Message};
use e57::{E57Reader, PointCloud, RecordDataType, RecordName};
use std::ffi::{c_char, c_void, CString};
use std::io::{BufReader, Error, ErrorKind, Read, Seek, SeekFrom};

/// The caller's file: reads up to n bytes at an offset, or gives less than 0.
#[repr(C)]
pub struct Source {
    context: *mut c_void,
    read: extern "C" fn(*mut c_void, u64, *mut u8, u64) -> i64,
    size: u64,
}

struct File {
    source: Source,
    at: u64,
}

impl Read for File {
    fn read(&mut self, out: &mut [u8]) -> std::io::Result<usize> {
        if was_refused() {
            return Err(Error::from(ErrorKind::OutOfMemory));
        }
        let count = (self.source.read)(
            self.source.context,
            self.at,
            out.as_mut_ptr(),
            out.len() as u64,
        );
        if count < 0 {
            return Err(Error::from(ErrorKind::Other));
        }
        self.at += count as u64;
        Ok(count as usize)
    }
}

impl Seek for File {
    fn seek(&mut self, to: SeekFrom) -> std::io::Result<u64> {
        let at = match to {
            SeekFrom::Start(at) => Some(at),
            SeekFrom::Current(by) => self.at.checked_add_signed(by),
            SeekFrom::End(by) => self.source.size.checked_add_signed(by),
        };
        self.at = at.ok_or_else(|| Error::from(ErrorKind::InvalidInput))?;
        Ok(self.at)
    }
}

pub struct Document {
    scans: Vec<PointCloud>,
    texts: Vec<CString>, // that the caller looks at
    crs: String,
}

/// As in ../codecs.h.
#[repr(C)]
pub struct Scan {
    name: *const c_char,
    records: u64,
    section: u64,
    columns: u64,
    has_pose: i32,
    rotation: [f64; 4],
    translation: [f64; 3],
}

#[repr(C)]
pub struct ScanColumn {
    pub name: *const c_char,
    pub kind: i32,
    pub min: f64,
    pub max: f64,
    pub scale: f64,
    pub offset: f64,
}

/// As in ../codecs.h.
#[repr(C)]
pub struct Packing {
    least: i64,
    bits: u32,
}

pub const INTEGER: i32 = 0;
pub const SCALED: i32 = 1;
pub const SINGLE: i32 = 2;
pub const DOUBLE: i32 = 3;

impl Document {
    fn keep(&mut self, text: &str) -> *const c_char {
        let clean: String = text.chars().filter(|c| *c != '\0').collect();
        self.texts.push(CString::new(clean).unwrap_or_default());
        self.texts[self.texts.len() - 1].as_ptr()
    }
}

#[no_mangle]
pub unsafe extern "C" fn jc_e57_open(
    source: Source,
    out: *mut *mut Document,
    scans: *mut u64,
    message: Message,
) -> i32 {
    silence_panics();
    guarded(&message, || {
        let input = BufReader::with_capacity(1 << 16, File { source, at: 0 });
        let reader = E57Reader::new(input).map_err(|e| e.to_string())?;
        let clouds = reader.pointclouds();
        *scans = clouds.len() as u64;
        *out = Box::into_raw(Box::new(Document {
            scans: clouds,
            texts: Vec::new(),
            crs: reader.coordinate_metadata().unwrap_or("").to_owned(),
        }));
        Ok(())
    })
}

#[no_mangle]
pub unsafe extern "C" fn jc_e57_close(document: *mut Document) {
    if !document.is_null() {
        let message = Message { bytes: std::ptr::null_mut(), room: 0 };
        guarded(&message, || {
            drop(Box::from_raw(document));
            Ok(())
        });
    }
}

/// The text lives as long as the document; "" where the file says nothing.
#[no_mangle]
pub unsafe extern "C" fn jc_e57_crs(
    document: *mut Document,
    out: *mut *const c_char,
    message: Message,
) -> i32 {
    guarded(&message, || {
        let text = (*document).crs.clone();
        *out = (*document).keep(&text);
        Ok(())
    })
}

#[no_mangle]
pub unsafe extern "C" fn jc_e57_scan(
    document: *mut Document,
    index: u64,
    out: *mut Scan,
    message: Message,
) -> i32 {
    guarded(&message, || {
        let document = &mut *document;
        let cloud = document.scans.get(index as usize).ok_or("no such scan")?.clone();
        let name = document.keep(cloud.name.as_deref().unwrap_or(""));
        let mut scan = Scan {
            name,
            records: cloud.records,
            section: cloud.file_offset,
            columns: cloud.prototype.len() as u64,
            has_pose: i32::from(cloud.transform.is_some()),
            rotation: [1.0, 0.0, 0.0, 0.0],
            translation: [0.0; 3],
        };
        if let Some(pose) = cloud.transform {
            let (q, t) = (pose.rotation, pose.translation);
            scan.rotation = [q.w, q.x, q.y, q.z];
            scan.translation = [t.x, t.y, t.z];
        }
        *out = scan;
        Ok(())
    })
}

#[no_mangle]
pub unsafe extern "C" fn jc_e57_column(
    document: *mut Document,
    index: u64,
    column: u64,
    out: *mut ScanColumn,
    packing: *mut Packing,
    message: Message,
) -> i32 {
    guarded(&message, || {
        let document = &mut *document;
        let cloud = document.scans.get(index as usize).ok_or("no such scan")?;
        let record = cloud.prototype.get(column as usize).ok_or("no such column")?.clone();
        let (kind, min, max, scale, offset) = match record.data_type {
            RecordDataType::Integer { min, max } => (INTEGER, min as f64, max as f64, 1.0, 0.0),
            RecordDataType::ScaledInteger { min, max, scale, offset } => {
                (SCALED, min as f64, max as f64, scale, offset)
            }
            RecordDataType::Single { .. } => (SINGLE, f64::NAN, f64::NAN, 1.0, 0.0),
            RecordDataType::Double { .. } => (DOUBLE, f64::NAN, f64::NAN, 1.0, 0.0),
        };
        let name = document.keep(&name_of(&record.name));
        *packing = packing_of(&record.data_type);
        *out = ScanColumn { name, kind, min, max, scale, offset };
        Ok(())
    })
}

fn name_of(name: &RecordName) -> String {
    match name {
        RecordName::CartesianX => "cartesianX".to_owned(),
        RecordName::CartesianY => "cartesianY".to_owned(),
        RecordName::CartesianZ => "cartesianZ".to_owned(),
        RecordName::CartesianInvalidState => "cartesianInvalidState".to_owned(),
        RecordName::SphericalRange => "sphericalRange".to_owned(),
        RecordName::SphericalAzimuth => "sphericalAzimuth".to_owned(),
        RecordName::SphericalElevation => "sphericalElevation".to_owned(),
        RecordName::SphericalInvalidState => "sphericalInvalidState".to_owned(),
        RecordName::Intensity => "intensity".to_owned(),
        RecordName::IsIntensityInvalid => "isIntensityInvalid".to_owned(),
        RecordName::ColorRed => "colorRed".to_owned(),
        RecordName::ColorGreen => "colorGreen".to_owned(),
        RecordName::ColorBlue => "colorBlue".to_owned(),
        RecordName::IsColorInvalid => "isColorInvalid".to_owned(),
        RecordName::RowIndex => "rowIndex".to_owned(),
        RecordName::ColumnIndex => "columnIndex".to_owned(),
        RecordName::ReturnCount => "returnCount".to_owned(),
        RecordName::ReturnIndex => "returnIndex".to_owned(),
        RecordName::TimeStamp => "timeStamp".to_owned(),
        RecordName::IsTimeStampInvalid => "isTimeStampInvalid".to_owned(),
        RecordName::Unknown { namespace, name } => format!("{namespace}:{name}"),
    }
}

/// Integers take the bits of the widest, less the least of them (ASTM E2807).
fn packing_of(kind: &RecordDataType) -> Packing {
    match *kind {
        RecordDataType::Single { .. } => Packing { least: 0, bits: 32 },
        RecordDataType::Double { .. } => Packing { least: 0, bits: 64 },
        RecordDataType::Integer { min, max } | RecordDataType::ScaledInteger { min, max, .. } => {
            let range = i128::from(max) - i128::from(min);
            Packing { least: min, bits: if range > 0 { range.ilog2() + 1 } else { 0 } }
        }
    }
}
