// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/zlib_stream.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <vector>

#include "base/error.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kBlockBytes = size_t{1} << 17;  // some milliseconds of work
constexpr char kHeader[] = "\x78\x9c";  // a window of 32 KiB, the usual level (RFC 1950, 2.2)

struct Block {
  std::string bytes;
  uLong sum = 0;  ///< Adler-32 of what it holds
};

/// zlib's state of one block: without the frame of a stream, so that blocks can be laid side by side.
class Deflation {
 public:
  explicit Deflation(Redundancy redundancy) {
    constexpr int kMostMemory = 9, kNoFrame = -MAX_WBITS;
    const bool is_of_runs = redundancy == Redundancy::kRuns;
    const int level = is_of_runs ? Z_BEST_SPEED : Z_DEFAULT_COMPRESSION;
    if (deflateInit2(&state_, level, Z_DEFLATED, kNoFrame, kMostMemory,
                     is_of_runs ? Z_RLE : Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  ~Deflation() { deflateEnd(&state_); }
  Deflation(const Deflation&) = delete;
  Deflation& operator=(const Deflation&) = delete;

  std::string run(std::string_view bytes, bool is_last) {
    constexpr size_t kSyncBytes =
        16;  // behind deflateBound(): an empty block that ends with a whole byte
    std::string out(deflateBound(&state_, static_cast<uLong>(bytes.size())) + kSyncBytes, '\0');
    state_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    state_.avail_in = static_cast<uInt>(bytes.size());
    state_.next_out = reinterpret_cast<Bytef*>(out.data());
    state_.avail_out = static_cast<uInt>(out.size());
    const int status = deflate(&state_, is_last ? Z_FINISH : Z_SYNC_FLUSH);
    if (status != (is_last ? Z_STREAM_END : Z_OK) || state_.avail_in != 0 || state_.avail_out == 0)
      fail(Status::kInternal, "zlib: deflate() ended with %d", status);
    out.resize(out.size() - state_.avail_out);
    return out;
  }

 private:
  z_stream state_ = {};
};

}  // namespace

std::string zlib_stream(std::string_view bytes, Redundancy redundancy, Task& task) {
  const size_t count = std::max<size_t>(1, (bytes.size() + kBlockBytes - 1) / kBlockBytes);
  std::vector<Block> blocks(count);
  const auto part = [&](size_t b) { return bytes.substr(b * kBlockBytes, kBlockBytes); };
  parallel_chunks(task, count, [&](size_t b) {
    const std::string_view plain = part(b);
    blocks[b].bytes = Deflation(redundancy).run(plain, b + 1 == count);
    blocks[b].sum = adler32_z(adler32_z(0, nullptr, 0),
                              reinterpret_cast<const Bytef*>(plain.data()), plain.size());
  });
  std::string out(kHeader, 2);
  uLong sum = adler32_z(0, nullptr, 0);
  for (size_t b = 0; b < count; ++b) {
    out += blocks[b].bytes;
    sum = adler32_combine(sum, blocks[b].sum, static_cast<z_off_t>(part(b).size()));
  }
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(sum >> shift & 0xff);
  return out;
}

}  // namespace jalon
