// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Chunks of LAZ: what the crate packs must come out again, by our own decoders (formats 0 to 3, 6 to 8) and by its.
#include "formats/codecs/codecs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/random.h"
#include "formats/files/endian.h"
#include "formats/las/layout.h"

using namespace jalon;

namespace {

using Records = std::vector<uint8_t>;

bool lacks_codecs() {
  if (has_codecs()) return false;
  MESSAGE("skipped: built without JALON_WITH_RUST_FORMATS");
  return true;
}

struct Line {
  char text[300] = {};
  JcMessage message() { return {text, sizeof text}; }
};

Records taken(JcBytes bytes) {
  Records out(bytes.data, bytes.data + bytes.count);
  jc_bytes_free(bytes);
  return out;
}

/// A point format with extra bytes, and what packs its records.
struct Packer {
  Packer(unsigned point_format, unsigned extra_bytes)
      : format(point_format), record_bytes(las::point_format(point_format)->bytes + extra_bytes) {
    JcBytes bytes{};
    Line line;
    REQUIRE(jc_laz_record(static_cast<uint8_t>(format), static_cast<uint16_t>(extra_bytes), 0,
                          &bytes, line.message()) == 0);
    vlr = taken(bytes);
  }

  Records packed(const Records& records) const {
    JcBytes bytes{};
    Line line;
    REQUIRE(jc_laz_encode(vlr.data(), vlr.size(), records.data(), records.size(), &bytes,
                          line.message()) == 0);
    return taken(bytes);
  }
  int32_t unpack(const Records& chunk, Records& out) const {
    Line line;
    const int32_t status = jc_laz_decode(vlr.data(), vlr.size(), chunk.data(), chunk.size(),
                                         out.data(), out.size(), line.message());
    CHECK((status == 0) == (line.text[0] == '\0'));
    return status;
  }

  const unsigned format;
  const size_t record_bytes;
  Records vlr;
};

/// How the values of neighbours differ.
enum class Law { kSame, kSmooth, kWild };

uint64_t drawn(Law law, RandomStream& random, double phase, unsigned bits) {
  const uint64_t all = bits == 64 ? ~uint64_t{0} : (uint64_t{1} << bits) - 1;
  if (law == Law::kSame) return 0x5A5A5A5A5A5A5A5Au & all;
  if (law == Law::kWild) return random.bits() >> random.below(64) & all;
  return static_cast<uint64_t>(static_cast<int64_t>(1000 * std::sin(phase) + 3 * random.normal())) &
         all;
}

/// Numbers of returns and returns of format 0 to 5 have 3 bits, of others 4; the rest are bits of their own.
void put_record(uint8_t* to, unsigned format, Law law, RandomStream& random, size_t i,
                bool has_channels) {
  const double phase = 0.01 * static_cast<double>(i);
  auto* at = reinterpret_cast<std::byte*>(to);
  for (size_t k = 0; k < 3; ++k)
    store<uint32_t>(at + 4 * k, static_cast<uint32_t>(drawn(law, random, phase, 32)));
  store<uint16_t>(at + 12, static_cast<uint16_t>(drawn(law, random, phase, 16)));
  for (size_t k = 14; k < 20; ++k) to[k] = static_cast<uint8_t>(drawn(law, random, phase, 8));
  const bool is_layered = format >= 6;
  if (is_layered) {
    const auto channel = static_cast<unsigned>(has_channels ? random.below(4) : 2);
    to[15] = static_cast<uint8_t>((to[15] & ~0x30u) | channel << 4);
    store<uint16_t>(at + 20, static_cast<uint16_t>(drawn(law, random, phase, 16)));
  }
  if (!is_layered && format != 1 && format < 3) return;
  // Sequences of times that go on by even steps, stand, and jump.
  const uint64_t kind = law == Law::kWild ? random.below(12) : 0;
  const double time = 1000 + 0.001 * static_cast<double>(i * (law == Law::kSame ? 0 : 1)) +
                      (kind == 1   ? 0.0005
                       : kind == 2 ? 5e5
                       : kind == 3 ? -1e8
                                   : 0) *
                          random.uniform();
  const size_t time_at = is_layered ? 22 : 20;
  if (kind == 4) store<uint64_t>(at + time_at, random.bits());
  else store<double>(at + time_at, kind == 5 ? 1000 : time);
}

Records drawn_records(const Packer& packer, Law law, size_t count, uint64_t seed,
                      bool has_channels) {
  RandomStream random(seed, 1);
  Records records(count * packer.record_bytes);
  for (size_t i = 0; i < count; ++i) {
    uint8_t* record = records.data() + i * packer.record_bytes;
    const size_t core = las::point_format(packer.format)->bytes;
    for (size_t k = 20; k < packer.record_bytes; ++k)
      record[k] = static_cast<uint8_t>(drawn(k < core || k % 2 == 0 ? law : Law::kSame, random,
                                             0.02 * static_cast<double>(i), 8));
    // Now and then a colour is grey.
    put_record(record, packer.format, law, random, i, has_channels);
    if (packer.format == 2 || packer.format == 3 || packer.format >= 7) {
      const size_t colour = packer.format == 2 ? 20 : packer.format == 3 ? 28 : 30;
      if (i % 5 == 0)
        for (size_t k = 2; k < 6; ++k) record[colour + k] = record[colour + k % 2];
    }
  }
  return records;
}

}  // namespace

TEST_CASE("codecs__what_is_packed_comes_out_again_in_every_bit") {
  if (lacks_codecs()) return;
  for (const unsigned format : {0u, 1u, 2u, 3u, 6u, 7u, 8u})
    for (const unsigned extra : {0u, 1u, 5u}) {
      const Packer packer(format, extra);
      for (const Law law : {Law::kSame, Law::kSmooth, Law::kWild})
        for (const bool has_channels : {false, true})
          for (const size_t count : {1u, 2u, 40u, 9000u}) {
            if (has_channels && format < 6) continue;
            CAPTURE(format);
            CAPTURE(extra);
            CAPTURE(static_cast<int>(law));
            CAPTURE(count);
            CAPTURE(has_channels);
            const Records records =
                drawn_records(packer, law, count, 100 * format + extra, has_channels);
            Records out(records.size(), 0xAA);
            REQUIRE(packer.unpack(packer.packed(records), out) == 0);
            CHECK(out == records);
          }
    }
}

TEST_CASE("codecs__records_up_to_the_last_one_within_steps_are_those_of_the_whole") {
  if (lacks_codecs()) return;
  for (const unsigned format : {3u, 6u, 7u})
    for (const bool has_channels : {false, true}) {
      const Packer packer(format, 2);
      const Records records =
          drawn_records(packer, Law::kSmooth, 500, 3, has_channels && format > 5);
      const Records chunk = packer.packed(records);
      for (const int32_t least : {INT32_MIN, 900, 995, 1 << 20}) {
        const int32_t steps[] = {least, INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX, INT32_MAX};
        size_t last = 0;
        for (size_t i = 0; i < 500; ++i)
          if (load<int32_t>(reinterpret_cast<const std::byte*>(records.data()) +
                            i * packer.record_bytes) >= least)
            last = i + 1;
        Records out(records.size());
        uint64_t count = 0;
        Line line;
        REQUIRE(jc_laz_decode_within(packer.vlr.data(), packer.vlr.size(), chunk.data(),
                                     chunk.size(), steps, out.data(), out.size(), &count,
                                     line.message()) == 0);
        CAPTURE(format);
        CAPTURE(least);
        CHECK((count == last || (count == 500 && (format < 6 || has_channels))));
        const size_t bytes = count * packer.record_bytes;
        CHECK(
            std::equal(out.begin(), out.begin() + static_cast<ptrdiff_t>(bytes), records.begin()));
      }
    }
}

TEST_CASE("codecs__a_chunk_that_is_cut_off_anywhere_is_refused") {
  if (lacks_codecs()) return;
  for (const unsigned format : {3u, 7u}) {
    const Packer packer(format, 2);
    const Records records = drawn_records(packer, Law::kWild, 60, format, false);
    const Records chunk = packer.packed(records);
    Records out(records.size());
    for (size_t size = 0; size + 8 < chunk.size(); ++size) {
      CAPTURE(size);
      CHECK(packer.unpack({chunk.begin(), chunk.begin() + static_cast<ptrdiff_t>(size)}, out) == 1);
    }
  }
}

TEST_CASE("codecs__more_points_than_a_chunk_has_are_refused_or_made_of_its_end") {
  if (lacks_codecs()) return;
  for (const unsigned format : {1u, 6u}) {
    const Packer packer(format, 0);
    const Records records = drawn_records(packer, Law::kWild, 200, 7, false);
    Records out(1000 * packer.record_bytes);
    CHECK(packer.unpack(packer.packed(records), out) == 1);
  }
}

TEST_CASE("codecs__damaged_chunks_give_points_or_a_line") {
  if (lacks_codecs()) return;
  RandomStream random(41, 2);
  for (const unsigned format : {0u, 1u, 2u, 3u, 6u, 7u, 8u}) {
    const Packer packer(format, 3);
    const Records records = drawn_records(packer, Law::kWild, 300, format, false);
    const Records chunk = packer.packed(records);
    Records out(records.size()), again(records.size());
    for (int round = 0; round < 200; ++round) {
      Records damaged = chunk;
      for (uint64_t n = 1 + random.below(4); n > 0; --n)
        damaged[random.below(damaged.size())] =
            static_cast<uint8_t>(random.below(3) == 0 ? 255 : random.bits());
      const int32_t status = packer.unpack(damaged, out);
      CHECK((status == 0 || status == 1));
      CHECK(packer.unpack(damaged, again) == status);
      if (status == 0) CHECK(again == out);
    }
  }
}
