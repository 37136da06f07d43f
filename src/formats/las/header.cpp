// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "base/error.h"
#include "formats/files/endian.h"
#include "formats/files/utf8.h"
#include "formats/las/copc.h"
#include "formats/las/layout.h"

namespace jalon::las {

namespace {

constexpr PointFormat kPointFormats[] = {
    {20, false, -1, -1, -1, -1}, {28, false, 20, -1, -1, -1}, {26, false, -1, 20, -1, -1},
    {34, false, 20, 28, -1, -1}, {57, false, 20, -1, -1, 28}, {63, false, 20, 28, -1, 34},
    {30, true, 22, -1, -1, -1},  {36, true, 22, 30, -1, -1},  {38, true, 22, 30, 36, -1},
    {59, true, 22, -1, -1, 30},  {67, true, 22, 30, 36, 38}};

constexpr unsigned kCompressedBits = 0xC0;  // of the byte of the point format (LASzip)

constexpr uint16_t kSmallestHeader[] = {227, 227, 227, 235, 375};  // by minor version

unsigned long long number(uint64_t n) { return n; }

void require_finite_scale(const ByteSource& source, const Header& header) {
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(header.scale[i]) || header.scale[i] == 0)
      source.refuse(131 + 8 * static_cast<uint64_t>(i),
                    "the scale of axis %d is zero or not finite", i + 1);
    if (!std::isfinite(header.offset[i]))
      source.refuse(155 + 8 * static_cast<uint64_t>(i), "the offset of axis %d is not finite",
                    i + 1);
  }
}

void require_points(const ByteSource& source, const Header& header) {
  const PointFormat* format = point_format(header.format);
  if (format == nullptr) source.refuse(104, "point format %u is not one of 0-10", header.format);
  if (header.record_bytes < format->bytes)
    source.refuse(105, "point records of %u bytes are too short for format %u, which needs %u",
                  header.record_bytes, header.format, format->bytes);
  if (header.point_offset < header.size)
    source.refuse(96, "the points would start inside the header");
  if (header.point_offset > source.size())
    source.refuse(96, "the points would start at offset %u, beyond the end of the file at %llu",
                  header.point_offset, number(source.size()));
  if (header.compressed) return;  // LazPoints looks
  const uint64_t room = source.size() - header.point_offset;
  if (header.count > room / header.record_bytes)
    source.refuse(
        header.point_offset,
        "the header promises %llu points of %u bytes, the file ends after %llu whole ones",
        number(header.count), header.record_bytes, number(room / header.record_bytes));
}

// The nodes of a COPC file are read where they are wanted, and are of use in no other file.
bool is_hierarchy(const std::byte* head) {
  return text_field(head + 2, 16) == kCopcUser && load<uint16_t>(head + 18) == kCopcHierarchyRecord;
}

std::vector<Record> read_records(const ByteSource& source, uint64_t at, uint64_t end,
                                 uint64_t count, size_t header_bytes, const char* what,
                                 Task& task) {
  std::vector<Record> records;
  for (uint64_t i = 0; i < count; ++i) {
    if (i % 256 == 0) task.checkpoint(0);
    std::byte head[kEvlrHeader];
    uint64_t size = 0;
    const bool has_head = at <= end && end - at >= header_bytes;
    if (has_head) {
      source.read(at, head, header_bytes);
      size = header_bytes == kVlrHeader ? load<uint16_t>(head + 20) : load<uint64_t>(head + 20);
    }
    if (!has_head || size > end - at - header_bytes) {
      task.log(Task::kWarning,
               "%s: offset %llu: %s %llu of %llu is broken; it and those behind it are left out",
               source.path().c_str(), number(at), what, number(i + 1), number(count));
      break;
    }
    if (is_hierarchy(head)) {
      at += header_bytes + size;
      continue;
    }
    std::vector<std::byte> bytes(header_bytes + size);
    source.read(at, bytes.data(), bytes.size());
    records.push_back(record_of(bytes, header_bytes));
    at += bytes.size();
  }
  return records;
}

Record record_of_size(size_t header_bytes, const char* user, uint16_t id, const char* description,
                      const void* data, size_t bytes) {
  std::vector<std::byte> all(header_bytes + bytes);
  std::memcpy(all.data() + 2, user, std::min<size_t>(16, std::strlen(user)));
  store<uint16_t>(all.data() + 18, id);
  std::memcpy(all.data() + header_bytes - 32, description,
              std::min<size_t>(32, std::strlen(description)));
  if (bytes != 0) std::memcpy(all.data() + header_bytes, data, bytes);
  return record_of(all, header_bytes);
}

}  // namespace

const PointFormat* point_format(unsigned id) {
  return id < std::size(kPointFormats) ? &kPointFormats[id] : nullptr;
}

std::string Record::text() const { return text_field(data(), size()); }

Record record_of(const std::vector<std::byte>& bytes, size_t header_bytes) {
  Record record;
  if (bytes.size() < header_bytes) return record;
  record.user = text_field(bytes.data() + 2, 16);
  record.id = load<uint16_t>(bytes.data() + 18);
  record.header_bytes = header_bytes;
  record.bytes = bytes;
  return record;
}

Record make_record(const char* user, uint16_t id, const char* description, const void* data,
                   size_t bytes) {
  // A VLR counts its bytes in 16 bits, an EVLR in 64.
  if (bytes > 0xFFFF) return make_extended_record(user, id, description, data, bytes);
  Record record = record_of_size(kVlrHeader, user, id, description, data, bytes);
  store<uint16_t>(record.bytes.data() + 20, static_cast<uint16_t>(bytes));
  return record;
}

Record make_extended_record(const char* user, uint16_t id, const char* description,
                            const void* data, size_t bytes) {
  Record record = record_of_size(kEvlrHeader, user, id, description, data, bytes);
  store<uint64_t>(record.bytes.data() + 20, bytes);
  return record;
}

Header read_header(const ByteSource& source) {
  std::byte fixed[375] = {};
  const size_t have = source.read_some(0, fixed, sizeof fixed);
  if (have < 227) source.refuse(have, "the file ends inside the LAS header of 227 bytes");
  Header header;
  const unsigned major = static_cast<unsigned>(fixed[24]);
  header.version_minor = static_cast<uint8_t>(fixed[25]);
  if (major != 1 || header.version_minor > 4)
    source.refuse(24, "LAS %u.%u is not one of 1.0-1.4", major, header.version_minor);
  header.global_encoding = load<uint16_t>(fixed + 6);
  header.size = load<uint16_t>(fixed + 94);
  if (header.size < kSmallestHeader[header.version_minor])
    source.refuse(94, "a header of %u bytes is too short for LAS 1.%u", header.size,
                  header.version_minor);
  if (header.size > source.size())
    source.refuse(94, "the header of %u bytes is longer than the file", header.size);
  header.point_offset = load<uint32_t>(fixed + 96);
  header.vlr_count = load<uint32_t>(fixed + 100);
  header.format = static_cast<uint8_t>(fixed[104]);
  header.compressed = (header.format & kCompressedBits) != 0;
  header.format = static_cast<uint8_t>(header.format & ~kCompressedBits);
  header.record_bytes = load<uint16_t>(fixed + 105);
  header.count = load<uint32_t>(fixed + 107);
  for (int i = 0; i < 3; ++i) {
    header.scale[i] = load<double>(fixed + 131 + 8 * i);
    header.offset[i] = load<double>(fixed + 155 + 8 * i);
  }
  if (header.version_minor == 4) {
    header.evlr_offset = load<uint64_t>(fixed + 235);
    header.evlr_count = load<uint32_t>(fixed + 243);
    if (const uint64_t extended = load<uint64_t>(fixed + 247)) header.count = extended;
  } else if (header.version_minor == 3 && (header.global_encoding & 2) != 0) {
    header.evlr_offset =
        load<uint64_t>(fixed + 227);  // waveforms inside the file: one extended record
    header.evlr_count = header.evlr_offset != 0 ? 1 : 0;
  }
  require_points(source, header);
  require_finite_scale(source, header);
  header.raw.resize(header.size);
  source.read(0, header.raw.data(), header.raw.size());
  header.raw[104] = static_cast<std::byte>(header.format);
  return header;
}

std::vector<Record> read_vlrs(const ByteSource& source, const Header& header, Task& task) {
  return read_records(source, header.size, header.point_offset, header.vlr_count, kVlrHeader, "VLR",
                      task);
}

std::vector<Record> read_evlrs(const ByteSource& source, const Header& header, Task& task) {
  if (header.evlr_count == 0) return {};
  if (header.evlr_offset < header.point_offset) {
    task.log(
        Task::kWarning,
        "%s: offset 235: the extended records would start inside the header; they are left out",
        source.path().c_str());
    return {};
  }
  return read_records(source, header.evlr_offset, source.size(), header.evlr_count, kEvlrHeader,
                      "EVLR", task);
}

}  // namespace jalon::las
