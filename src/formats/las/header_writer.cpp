// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/header_writer.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "formats/files/endian.h"
#include "formats/las/copc.h"

namespace jalon::las {

namespace {

constexpr unsigned kCompressed = 0x80;  // of the byte of the point format (LASzip)
constexpr uint16_t kWktBit = 16, kTimeTypeBit = 1, kSyntheticReturnsBit = 8;
// Where the samples of wave packets are: in this file, or in one of the same name ending in ".wdp".
constexpr uint16_t kWavesInsideBit = 2, kWavesBesideBit = 4;

void put_text(std::byte* to, const char* text) { std::memcpy(to, text, std::strlen(text)); }

// The record of the samples, which LAS 1.4 alone has room for among others.
std::vector<Record>::const_iterator waves_inside(const Plan& plan) {
  constexpr unsigned kWaveData = 65535;
  return std::ranges::find_if(plan.evlrs,
                              [](const Record& r) { return r.is(kSpecUser, kWaveData); });
}

void put_identity(std::byte* out, const Plan& plan) {
  if (!plan.old_header.empty()) {
    std::memcpy(out, plan.old_header.data(), 58);  // source id, encoding, project id, system
    std::memcpy(out + 90, plan.old_header.data() + 90, 4);                // date
    if (plan.old_header[25] == std::byte{0}) std::memset(out + 4, 0, 4);  // reserved in 1.0
  } else {
    put_text(out + 26, "OTHER");
  }
  put_text(out, "LASF");
  put_text(out + 58, "Jalon");
  bool wkt = false;
  for (const auto* list : {&plan.vlrs, &plan.evlrs})
    for (const Record& record : *list) wkt = wkt || record.is("LASF_Projection", 2112);
  uint16_t encoding = load<uint16_t>(out + 6) & (kTimeTypeBit | kSyntheticReturnsBit);
  if (point_format(plan.format)->wave >= 0)
    encoding |= waves_inside(plan) != plan.evlrs.end()
                    ? kWavesInsideBit
                    : static_cast<uint16_t>(load<uint16_t>(out + 6) & kWavesBesideBit);
  // COPC has no other texts of a CRS, and readers ask for the bit where it has none too.
  const bool is_copc = !plan.vlrs.empty() && is_copc_record(plan.vlrs[0]);
  if ((wkt && plan.version_minor == 4) || is_copc) encoding |= kWktBit;
  store<uint16_t>(out + 6, encoding);
}

void put_tally(std::byte* out, const Plan& plan, const Tally& tally, uint64_t count) {
  const bool extended = point_format(plan.format)->extended;
  if (!extended) {
    store<uint32_t>(out + 107, static_cast<uint32_t>(count));
    for (size_t r = 0; r < 5; ++r)
      store<uint32_t>(out + 111 + 4 * r, static_cast<uint32_t>(tally.by_return[r + 1]));
  }
  if (plan.version_minor == 4) {
    store<uint64_t>(out + 247, count);
    for (size_t r = 0; r < 15; ++r) store<uint64_t>(out + 255 + 8 * r, tally.by_return[r + 1]);
  }
  for (size_t k = 0; k < 3; ++k) {
    const int axis = static_cast<int>(k);
    const auto coordinate = [&](int64_t steps) {
      return count == 0 ? 0 : static_cast<double>(steps) * plan.scale[axis] + plan.offset[axis];
    };
    store<double>(out + 131 + 8 * k, plan.scale[axis]);
    store<double>(out + 155 + 8 * k, plan.offset[axis]);
    const double a = coordinate(tally.min[k]),
                 b = coordinate(tally.max[k]);  // a negative scale turns them round
    store<double>(out + 179 + 16 * k, std::max(a, b));
    store<double>(out + 187 + 16 * k, std::min(a, b));
  }
}

}  // namespace

size_t header_size(const Plan& plan) {
  return plan.version_minor == 4 ? 375 : plan.version_minor == 3 ? 235 : 227;
}

uint64_t point_offset_of(const Plan& plan) {
  uint64_t offset = header_size(plan);
  for (const Record& record : plan.vlrs) offset += record.bytes.size();
  return offset;
}

std::vector<std::byte> header_bytes(const Plan& plan, const Written& written, uint64_t count,
                                    bool compressed) {
  std::vector<std::byte> out(header_size(plan));
  put_identity(out.data(), plan);
  const uint64_t point_offset = point_offset_of(plan);
  if (point_offset > std::numeric_limits<uint32_t>::max())
    fail(Status::kLimit, "the records before the points take more than 4 GiB");
  out[24] = std::byte{1};
  out[25] = static_cast<std::byte>(plan.version_minor);
  store<uint16_t>(out.data() + 94, static_cast<uint16_t>(out.size()));
  store<uint32_t>(out.data() + 96, static_cast<uint32_t>(point_offset));
  store<uint32_t>(out.data() + 100, static_cast<uint32_t>(plan.vlrs.size()));
  out[104] = static_cast<std::byte>(plan.format | (compressed ? kCompressed : 0));
  store<uint16_t>(out.data() + 105, static_cast<uint16_t>(plan.record_bytes));
  put_tally(out.data(), plan, written.tally, count);
  if (!plan.evlrs.empty()) {
    store<uint64_t>(out.data() + 235, point_offset + written.bytes);
    store<uint32_t>(out.data() + 243, static_cast<uint32_t>(plan.evlrs.size()));
    const auto waves = waves_inside(plan);
    if (waves != plan.evlrs.end() && point_format(plan.format)->wave >= 0) {
      uint64_t at = point_offset + written.bytes;
      for (auto record = plan.evlrs.begin(); record != waves; ++record) at += record->bytes.size();
      store<uint64_t>(out.data() + 227, at);
    }
  }
  return out;
}

}  // namespace jalon::las
