// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <zlib.h>

#include <string>
#include <string_view>

/// A zlib stream read back whole: ok when it ends with its check sum and nothing follows.
class Inflated {
 public:
  explicit Inflated(std::string_view stream) {
    z_stream state = {};
    if (inflateInit(&state) != Z_OK) return;
    std::string in(stream), piece(size_t{1} << 16, '\0');
    state.next_in = reinterpret_cast<Bytef*>(in.data());
    state.avail_in = static_cast<uInt>(in.size());
    int status = Z_OK;
    while (status == Z_OK) {
      state.next_out = reinterpret_cast<Bytef*>(piece.data());
      state.avail_out = static_cast<uInt>(piece.size());
      status = inflate(&state, Z_NO_FLUSH);
      text.append(piece, 0, piece.size() - state.avail_out);
    }
    ok = status == Z_STREAM_END && state.avail_in == 0;
    inflateEnd(&state);
  }
  std::string text;
  bool ok = false;
};
