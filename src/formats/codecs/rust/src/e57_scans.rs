// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

//! E57: scans with their poses, and their records as numbers, column by column of the prototype.

use crate::reserve::was_refused;
use crate::{guarded, silence_panics, Message};
use e57::{E57Reader, PointCloud, PointCloudReaderRaw, RecordDataType, RecordName, RecordValue};
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

type Input = BufReader<File>;

pub struct Document {
    records: Option<PointCloudReaderRaw<'static, Input>>, // of `reader`: goes before it
    current: Vec<RecordDataType>,
    scans: Vec<PointCloud>,
    texts: Vec<CString>, // that the caller looks at
    reader: Box<E57Reader<Input>>,
}

/// As in ../codecs.h.
#[repr(C)]
pub struct Scan {
    name: *const c_char,
    records: u64,
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
        let reader = Box::new(E57Reader::new(input).map_err(|e| e.to_string())?);
        let clouds = reader.pointclouds();
        *scans = clouds.len() as u64;
        *out = Box::into_raw(Box::new(Document {
            records: None,
            current: Vec::new(),
            scans: clouds,
            texts: Vec::new(),
            reader,
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
        let text = (*document).reader.coordinate_metadata().unwrap_or("").to_owned();
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

/// A record that takes no bits is there without bytes: with nothing else the file would hold any
/// number of points, and the decoder would never end.
fn takes_bits(kind: &RecordDataType) -> bool {
    match kind {
        RecordDataType::Integer { min, max } | RecordDataType::ScaledInteger { min, max, .. } => {
            min != max
        }
        _ => true,
    }
}

#[no_mangle]
pub unsafe extern "C" fn jc_e57_start(
    document: *mut Document,
    index: u64,
    message: Message,
) -> i32 {
    guarded(&message, || {
        let document = &mut *document;
        let cloud = document.scans.get(index as usize).ok_or("no such scan")?.clone();
        if cloud.records > 0 && !cloud.prototype.iter().any(|r| takes_bits(&r.data_type)) {
            return Err("Invalid E57 content: no column of the scan takes any bytes".to_owned());
        }
        document.records = None;
        document.current = cloud.prototype.iter().map(|r| r.data_type.clone()).collect();
        // SAFETY: the reader lives in a box of the same document, is touched by nothing else while
        // `records` is there, and goes after it.
        let reader: &'static mut E57Reader<Input> =
            &mut *(document.reader.as_mut() as *mut E57Reader<Input>);
        document.records = Some(reader.pointcloud_raw(&cloud).map_err(|e| e.to_string())?);
        Ok(())
    })
}

/// Up to `room` records as rows of doubles; *count: as many as there were.
#[no_mangle]
pub unsafe extern "C" fn jc_e57_read(
    document: *mut Document,
    rows: *mut f64,
    room: u64,
    count: *mut u64,
    message: Message,
) -> i32 {
    guarded(&message, || {
        let document = &mut *document;
        let records = document.records.as_mut().ok_or("no scan was started")?;
        let columns = document.current.len();
        *count = 0;
        while *count < room {
            let values = match records.next() {
                None => break,
                Some(read) => read.map_err(|e| e.to_string())?,
            };
            let row = rows.add(*count as usize * columns);
            for (i, value) in values.iter().enumerate() {
                *row.add(i) = number_of(value, &document.current[i]);
            }
            *count += 1;
        }
        Ok(())
    })
}

fn number_of(value: &RecordValue, kind: &RecordDataType) -> f64 {
    match (value, kind) {
        (RecordValue::Single(number), _) => f64::from(*number),
        (RecordValue::Double(number), _) => *number,
        (RecordValue::ScaledInteger(raw), RecordDataType::ScaledInteger { scale, offset, .. }) => {
            *raw as f64 * scale + offset
        }
        (RecordValue::ScaledInteger(raw), _) | (RecordValue::Integer(raw), _) => *raw as f64,
    }
}
