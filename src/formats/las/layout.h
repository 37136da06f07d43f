// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/field.h"
#include "base/task.h"
#include "formats/files/byte_source.h"
#include "formats/units/length_units.h"
#include "geometry/vec.h"

// The parts of a LAS file (ASPRS LAS 1.4 R15 and its forerunners).
namespace jalon::las {

constexpr size_t kVlrHeader = 54, kEvlrHeader = 60;
constexpr size_t kDescriptorBytes = 192;  // one record of the extra bytes VLR
constexpr const char* kSpecUser = "LASF_Spec";
constexpr unsigned kExtraBytes = 4;
constexpr const char* kNormalNames[3] = {"NormalX", "NormalY",
                                         "NormalZ"};  ///< the names that other tools use

/// What a point format holds beyond its core; offsets of -1: not there. All formats start with X,
/// Y, Z (int32) and intensity.
struct PointFormat {
  uint16_t bytes;
  bool extended;  ///< formats 6-10: wider return numbers, flags, classes and angles
  int gps, rgb, nir, wave;
};
/// nullptr beyond format 10.
const PointFormat* point_format(unsigned id);

struct Header {
  uint8_t version_minor = 2;
  uint16_t global_encoding = 0;
  uint16_t size = 227;
  uint32_t point_offset = 227;
  uint32_t vlr_count = 0;
  uint8_t format = 0;       ///< of the points as they are when decompressed
  bool compressed = false;  ///< LAZ
  uint16_t record_bytes = 20;
  uint64_t count = 0;
  Vec3 scale{1, 1, 1}, offset;
  uint64_t evlr_offset = 0, evlr_count = 0;
  std::vector<std::byte> raw;  ///< as in the file
};

/// One VLR or EVLR, header included.
struct Record {
  std::string user;
  uint16_t id = 0;
  size_t header_bytes = kVlrHeader;
  std::vector<std::byte> bytes;
  const std::byte* data() const { return bytes.data() + header_bytes; }
  size_t size() const { return bytes.size() - header_bytes; }
  std::string text() const;  ///< the data as text
  bool is(const char* wanted_user, unsigned wanted_id) const {
    return user == wanted_user && id == wanted_id;
  }
};
Record make_record(const char* user, uint16_t id, const char* description, const void* data,
                   size_t bytes);
/// The same as an EVLR, however short.
Record make_extended_record(const char* user, uint16_t id, const char* description,
                            const void* data, size_t bytes);
/// From bytes kept as an attachment; an empty user when they are no record.
Record record_of(const std::vector<std::byte>& bytes, size_t header_bytes);

Header read_header(const ByteSource& source);
/// Whole records only; a broken one ends the list with a warning, for the points do not depend on
/// them.
std::vector<Record> read_vlrs(const ByteSource& source, const Header& header, Task& task);
std::vector<Record> read_evlrs(const ByteSource& source, const Header& header, Task& task);

/// CRS of the records: WKT, "EPSG:n", or "" when they say nothing usable.
std::string crs_text(const std::vector<Record>& vlrs, const std::vector<Record>& evlrs);
bool is_crs_record(const Record& record);
/// The length units that the records name; Error(kUnsupported) when they contradict each other or
/// name a unit that is none of length.
LengthUnits units_of(const std::vector<Record>& vlrs, const std::vector<Record>& evlrs,
                     const std::string& path);
/// The records that say this CRS; empty for "".
std::vector<Record> crs_records(const std::string& crs);
bool is_wkt(const std::string& crs);

/// A dimension of the extra bytes at the end of each point.
struct ExtraDimension {
  FieldInfo field;
  size_t offset = 0;    ///< in the extra bytes
  bool scaled = false;  ///< raw * scale + shift, as float64
  ElementType raw_type = ElementType::kUint8;
  double scale[3] = {1, 1, 1}, shift[3] = {0, 0, 0};
  std::vector<std::byte> descriptor;  ///< its 192 bytes; empty for bytes that nobody described
  size_t bytes() const { return size_of(raw_type) * field.components; }
};
/// The dimensions that the extra bytes VLR describes; what it leaves over becomes the field
/// "extra_bytes".
std::vector<ExtraDimension> extra_dimensions(const std::vector<Record>& vlrs,
                                             const std::vector<Record>& evlrs, size_t extra_bytes,
                                             Task& task);
/// A new descriptor of a field of 1, 2 or 3 components.
std::vector<std::byte> descriptor_of(const FieldInfo& field, const std::string& name);

}  // namespace jalon::las
