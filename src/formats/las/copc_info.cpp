// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "formats/files/endian.h"
#include "formats/las/copc.h"

namespace jalon::las {

namespace {

constexpr uint64_t kInfoPlace = 375 + kVlrHeader;  // of the first record of a LAS 1.4 file

}  // namespace

bool is_copc_record(const Record& record) { return record.user == kCopcUser; }

std::optional<CopcInfo> copc_info(const ByteSource& source, const std::vector<Record>& vlrs) {
  if (vlrs.empty() || !vlrs[0].is(kCopcUser, kCopcInfoRecord)) return std::nullopt;
  const Record& record = vlrs[0];
  if (record.size() < kCopcInfoBytes)
    source.refuse(kInfoPlace, "the record \"copc\" has %zu bytes; it needs %zu", record.size(),
                  kCopcInfoBytes);
  const std::byte* data = record.data();
  CopcInfo info;
  for (int k = 0; k < 3; ++k) info.centre[k] = load<double>(data + 8 * k);
  info.halfsize = load<double>(data + 24);
  info.spacing = load<double>(data + 32);
  info.page_offset = load<uint64_t>(data + 40);
  info.page_bytes = load<uint64_t>(data + 48);
  info.gps_min = load<double>(data + 56);
  info.gps_max = load<double>(data + 64);
  const auto is_length = [](double value) { return std::isfinite(value) && value > 0; };
  if (!std::isfinite(info.centre.x) || !std::isfinite(info.centre.y) ||
      !std::isfinite(info.centre.z) || !is_length(info.halfsize))
    source.refuse(kInfoPlace, "the cube of the octree is none");
  if (!is_length(info.spacing))
    source.refuse(kInfoPlace + 32, "the spacing of the octree is no length");
  return info;
}

std::vector<std::byte> info_bytes(const CopcInfo& info) {
  std::vector<std::byte> out(kCopcInfoBytes);
  for (int k = 0; k < 3; ++k) store<double>(out.data() + 8 * k, info.centre[k]);
  store<double>(out.data() + 24, info.halfsize);
  store<double>(out.data() + 32, info.spacing);
  store<uint64_t>(out.data() + 40, info.page_offset);
  store<uint64_t>(out.data() + 48, info.page_bytes);
  store<double>(out.data() + 56, info.gps_min);
  store<double>(out.data() + 64, info.gps_max);
  return out;
}

void put_entry(std::byte* to, const CopcEntry& entry) {
  store<int32_t>(to, entry.key.level);
  store<int32_t>(to + 4, entry.key.x);
  store<int32_t>(to + 8, entry.key.y);
  store<int32_t>(to + 12, entry.key.z);
  store<uint64_t>(to + 16, entry.offset);
  store<int32_t>(to + 24, entry.bytes);
  store<int32_t>(to + 28, entry.points);
}

int level_of(const CopcInfo& info, double spacing) {
  int level = 0;
  while (level < kMostCopcLevel && std::ldexp(info.spacing, -level) > spacing) ++level;
  return level;
}

}  // namespace jalon::las
