// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/task.h"

namespace jalon {

/// What an object's bytes hold; a number is never given anew.
enum class BytesKind : uint32_t {
  kCloud = 1,
  kParams = 2,
  kModel = 3,
  kFields = 4,
  kSegmentation = 5,
  kComparison = 6,
  kRegistration = 7,
  kEvaluation = 8,
  kModelEvaluation = 9,
  kNoiseLaw = 10,
  kSegmenter = 11,
  kModeller = 12,
  kComparer = 13,
  kRegistrar = 14,
  kScanner = 15,
};
/// "a cloud"; "an object of a kind that this release does not know" for other numbers.
const char* name_of(BytesKind kind);

/// The layout of what stands behind the header. One that is read differently gets the next number.
constexpr uint32_t kBytesLayout = 1;

/// The header, which stays as it is for ever; little-endian:
///     byte  type      what
///     0     8 x byte  89 4A 4C 4E 0D 0A 1A 0A: not ASCII, "JLN", line ends that a text transfer would change
///     8     uint32    layout of the payload, kBytesLayout
///     12    uint32    BytesKind
///     16    uint64    bytes of the payload, which follows
///     24    uint32    checksum
///     28    uint32    0
/// The checksum is the CRC-32 of bytes 0 to 23 and then of the CRC-32 of each MiB of the payload, so that the MiB can
/// be summed side by side.
constexpr size_t kHeaderBytes = 32;

/// Writes the header of the payload that stands behind it in these bytes.
void write_header(std::span<uint8_t> whole, BytesKind kind, Task& task);
/// The payload of an object of this kind. Error(kFormat): no or damaged bytes; kUnsupported: of a later layout;
/// kInvalidArgument: of another kind.
std::span<const uint8_t> payload_of(std::span<const uint8_t> whole, BytesKind kind, Task& task);

}  // namespace jalon
