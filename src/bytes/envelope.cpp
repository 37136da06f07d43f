// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/envelope.h"

#include <cstring>
#include <iterator>
#include <vector>

#include "base/crc32.h"
#include "base/error.h"
#include "base/parallel.h"
#include "formats/files/endian.h"

namespace jalon {

namespace {

constexpr uint8_t kMagic[8] = {0x89, 'J', 'L', 'N', '\r', '\n', 0x1a, '\n'};
// Where the parts of the header begin.
constexpr size_t kLayoutAt = 8, kKindAt = 12, kLengthAt = 16, kChecksumAt = 24, kSpareAt = 28;
constexpr size_t kSummedBytes = size_t{1} << 20;  // of the payload, one CRC each

uint32_t checksum_of(std::span<const uint8_t> whole, Task& task) {
  const auto payload = whole.subspan(kHeaderBytes);
  std::vector<uint8_t> sums((payload.size() + kSummedBytes - 1) / kSummedBytes * sizeof(uint32_t));
  parallel_for(task, payload.size(), kSummedBytes, [&](size_t begin, size_t end) {
    store(sums.data() + begin / kSummedBytes * sizeof(uint32_t),
          crc32(0, payload.data() + begin, end - begin));
  });
  return crc32(crc32(0, whole.data(), kChecksumAt), sums.data(), sums.size());
}

}  // namespace

const char* name_of(BytesKind kind) {
  static constexpr const char* kNames[] = {"",
                                           "a cloud",
                                           "parameters",
                                           "a model",
                                           "a table of fields",
                                           "a segmentation",
                                           "a comparison",
                                           "a registration",
                                           "an evaluation",
                                           "a model evaluation",
                                           "a noise law",
                                           "a segmenter",
                                           "a modeller",
                                           "a comparer",
                                           "a registrar",
                                           "a scanner"};
  const auto i = static_cast<size_t>(kind);
  return i > 0 && i < std::size(kNames) ? kNames[i]
                                        : "an object of a kind that this release does not know";
}

void write_header(std::span<uint8_t> whole, BytesKind kind, Task& task) {
  std::memcpy(whole.data(), kMagic, sizeof kMagic);
  store(whole.data() + kLayoutAt, kBytesLayout);
  store(whole.data() + kKindAt, static_cast<uint32_t>(kind));
  store(whole.data() + kLengthAt, static_cast<uint64_t>(whole.size() - kHeaderBytes));
  store(whole.data() + kSpareAt, uint32_t{0});
  store(whole.data() + kChecksumAt, checksum_of(whole, task));
}

std::span<const uint8_t> payload_of(std::span<const uint8_t> whole, BytesKind kind, Task& task) {
  const char* name = name_of(kind);
  if (whole.size() < kHeaderBytes)
    fail(Status::kFormat, "%zu bytes are too few for %s: the header alone has %zu", whole.size(),
         name, kHeaderBytes);
  if (std::memcmp(whole.data(), kMagic, sizeof kMagic) != 0)
    fail(Status::kFormat, "these are not the bytes of %s: they do not begin as Jalon's do", name);
  const auto length = load<uint64_t>(whole.data() + kLengthAt);
  if (length != whole.size() - kHeaderBytes)
    fail(Status::kFormat, "the bytes of %s are cut or too many: %zu behind the header, not %llu",
         name, whole.size() - kHeaderBytes, static_cast<unsigned long long>(length));
  if (load<uint32_t>(whole.data() + kChecksumAt) != checksum_of(whole, task) ||
      load<uint32_t>(whole.data() + kSpareAt) != 0)
    fail(Status::kFormat, "the bytes of %s are damaged: their checksum is another", name);
  const auto layout = load<uint32_t>(whole.data() + kLayoutAt);
  if (layout > kBytesLayout)
    fail(Status::kUnsupported,
         "these bytes are of layout %u, of a later release; this one reads up to %u: update Jalon "
         "here, "
         "or write them with the older one",
         layout, kBytesLayout);
  if (layout == 0) fail(Status::kFormat, "the bytes of %s are of layout 0, which never was", name);
  const auto found = static_cast<BytesKind>(load<uint32_t>(whole.data() + kKindAt));
  if (found != kind)
    fail(Status::kInvalidArgument, "these are the bytes of %s, not of %s", name_of(found), name);
  return whole.subspan(kHeaderBytes);
}

}  // namespace jalon
