// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <new>
#include <string>

// LAZ and E57 read and written by the crates "laz" and "e57" (rust/), chunks of the usual point formats by decoders of
// our own beside them, an optional component: where it was not built absent.cpp stands in. All files are read and all
// threads are run by the callers.
namespace jalon {

/// Whether the component was built.
bool has_codecs();
/// Error(kUnsupported) that names what to install where it was not.
void require_codecs(const std::string& path, const char* format);

/// What a call gives that was refused memory.
constexpr int32_t kJcOutOfMemory = 2;
/// Whether the call failed with a line; throws where it was out of memory.
inline bool has_failed(int32_t status) {
  if (status == kJcOutOfMemory) throw std::bad_alloc();
  return status != 0;
}

extern "C" {

/// Where a call leaves one line when it fails; calls give 0, or 1, or kJcOutOfMemory.
struct JcMessage {
  char* bytes;
  uint64_t room;
};

struct JcLazLayout {
  uint64_t record_bytes;
  uint64_t chunk_points;  ///< 0: each chunk has its own number
  int32_t has_chunks;     ///< 0: all points are one
};
/// vlr: the data of the record "laszip encoded" 22204.
int32_t jc_laz_layout(const uint8_t* vlr, uint64_t vlr_bytes, JcLazLayout* out, JcMessage message);
/// table: the chunk table from its version on. counts (of chunks that have their own) and sizes: of
/// as many entries as the table says.
int32_t jc_laz_chunks(const uint8_t* table, uint64_t table_bytes, int32_t variable,
                      uint64_t* counts, uint64_t* sizes, uint64_t room, JcMessage message);
/// Whether a chunk holds so many points, which are not kept.
int32_t jc_laz_check(const uint8_t* vlr, uint64_t vlr_bytes, const uint8_t* packed,
                     uint64_t packed_bytes, uint64_t points, JcMessage message);
/// One chunk: fills out with whole records.
int32_t jc_laz_decode(const uint8_t* vlr, uint64_t vlr_bytes, const uint8_t* packed,
                      uint64_t packed_bytes, uint8_t* out, uint64_t out_bytes, JcMessage message);
/// The same, but records behind the last one between the steps (least x, y, z, most x, y, z) need not be there: so many
/// are to be looked at.
int32_t jc_laz_decode_within(const uint8_t* vlr, uint64_t vlr_bytes, const uint8_t* packed,
                             uint64_t packed_bytes, const int32_t* steps, uint8_t* out,
                             uint64_t out_bytes, uint64_t* records, JcMessage message);

/// Bytes that jc_bytes_free() takes back.
struct JcBytes {
  uint8_t* data;
  uint64_t count, room;
};
void jc_bytes_free(JcBytes bytes);
/// The data of the record "laszip encoded" of a point format, in chunks of so many points each; 0:
/// each chunk has its own number.
int32_t jc_laz_record(uint8_t format, uint16_t extra_bytes, uint32_t chunk_points, JcBytes* out,
                      JcMessage message);
/// One chunk of whole records. Any thread.
int32_t jc_laz_encode(const uint8_t* vlr, uint64_t vlr_bytes, const uint8_t* records,
                      uint64_t records_bytes, JcBytes* out, JcMessage message);
/// The chunk table, version first, of chunks of these sizes; counts: of their points where each has
/// its own number, else nullptr.
int32_t jc_laz_table(const uint8_t* vlr, uint64_t vlr_bytes, const uint64_t* counts,
                     const uint64_t* sizes, uint64_t count, JcBytes* out, JcMessage message);

struct JcE57;
struct JcSource {
  void* context;
  int64_t (*read)(void* context, uint64_t offset, uint8_t* out, uint64_t bytes);  ///< < 0: failed
  uint64_t size;
};
struct JcScan {
  const char* name;
  uint64_t records;
  uint64_t section;  ///< offset in the file of what holds the records
  uint64_t columns;
  int32_t has_pose;
  double rotation[4];  ///< w x y z
  double translation[3];
};
enum JcKind : int32_t { kJcInteger = 0, kJcScaled = 1, kJcSingle = 2, kJcDouble = 3 };
struct JcColumn {
  const char* name;  ///< as in the file: "cartesianX", "nor:normalX" ...
  int32_t kind;
  double min, max;       ///< of integers, scaled ones before they are
  double scale, offset;  ///< of scaled integers
};
/// How the values of a column stand in its stream of bits.
struct JcPacking {
  int64_t least;  ///< of integers: taken off
  uint32_t bits;  ///< of a value; 0: all are the least
};
/// Texts live as long as the document.
int32_t jc_e57_open(JcSource source, JcE57** out, uint64_t* scans, JcMessage message);
void jc_e57_close(JcE57* document);
int32_t jc_e57_crs(JcE57* document, const char** out, JcMessage message);
int32_t jc_e57_scan(JcE57* document, uint64_t scan, JcScan* out, JcMessage message);
int32_t jc_e57_column(JcE57* document, uint64_t scan, uint64_t column, JcColumn* out,
                      JcPacking* packing, JcMessage message);

struct JcE57Writing;
struct JcSink {
  void* context;
  int64_t (*read)(void* context, uint64_t offset, uint8_t* out, uint64_t bytes);  ///< < 0: failed
  int64_t (*write)(void* context, uint64_t offset, const uint8_t* bytes, uint64_t count);
};
/// Then each scan: begin, add ..., end; finish once, discard always.
int32_t jc_e57_create(JcSink sink, const char* guid, const char* crs, JcE57Writing** out,
                      JcMessage message);
/// pose: rotation w x y z, translation x y z, or nullptr. Names without colon are of the standard.
int32_t jc_e57_begin(JcE57Writing* writing, const char* guid, const char* name, const double* pose,
                     const JcColumn* columns, uint64_t count, JcMessage message);
/// Rows of doubles; of scaled integers the value that they stand for.
int32_t jc_e57_add(JcE57Writing* writing, const double* rows, uint64_t count, JcMessage message);
int32_t jc_e57_end(JcE57Writing* writing, JcMessage message);
int32_t jc_e57_finish(JcE57Writing* writing, JcMessage message);
void jc_e57_discard(JcE57Writing* writing);
}

}  // namespace jalon
