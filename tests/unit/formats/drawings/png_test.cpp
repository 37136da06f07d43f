// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Pictures: the stream is read back by an inflater of the fixed code (RFC 1951), written here for the test.
#include "formats/drawings/png_writer.h"

#include <doctest/doctest.h>

#include "base/random.h"
#include "formats/files/deflate.h"

using namespace jalon;

namespace {

class Inflater {
 public:
  explicit Inflater(std::string_view bytes) : bytes_(bytes) {}

  // The content of one block with the fixed code; "" with ok false when it is malformed.
  std::string run(bool& ok) {
    std::string out;
    ok = bits(1) == 1 && bits(2) == 1;
    for (uint32_t s = symbol(); ok && s != 256; s = symbol()) {
      if (s < 256) {
        out += static_cast<char>(s);
        continue;
      }
      static constexpr uint32_t kLength[] = {3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                             15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                             67, 83, 99, 115, 131, 163, 195, 227, 258};
      static constexpr uint32_t kDistance[] = {
          1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
          193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
      const uint32_t l = s - 257;
      ok = l < 29 && at_ < bytes_.size() * 8;
      if (!ok) break;
      const uint32_t length = kLength[l] + bits(l < 8 || l == 28 ? 0 : (l - 4) / 4);
      const uint32_t d = code(5);
      const uint32_t distance = kDistance[d] + bits(d < 4 ? 0 : (d - 2) / 2);
      ok = distance <= out.size();
      for (uint32_t i = 0; ok && i < length; ++i) out += out[out.size() - distance];
    }
    return out;
  }

 private:
  uint32_t bits(uint32_t n) {
    uint32_t out = 0;
    for (uint32_t i = 0; i < n; ++i, ++at_)
      if (at_ / 8 < bytes_.size())
        out |= (static_cast<unsigned char>(bytes_[at_ / 8]) >> (at_ % 8) & 1u) << i;
    return out;
  }
  uint32_t code(uint32_t n) {
    uint32_t out = 0;
    for (uint32_t i = 0; i < n; ++i) out = out << 1 | bits(1);
    return out;
  }
  uint32_t symbol() {
    if (at_ / 8 >= bytes_.size()) return 256;
    const uint32_t seven = code(7);
    if (seven < 24) return 256 + seven;
    const uint32_t eight = seven << 1 | bits(1);
    if (eight < 0xc0) return eight - 0x30;
    if (eight < 0xc8) return 280 + eight - 0xc0;
    return 144 + ((eight << 1 | bits(1)) - 0x190);
  }

  std::string_view bytes_;
  size_t at_ = 0;
};

std::string back(const std::string& stream) {
  REQUIRE(stream.size() >= 6);
  bool ok = false;
  const std::string out = Inflater(std::string_view(stream).substr(2, stream.size() - 6)).run(ok);
  CHECK(ok);
  return out;
}

uint32_t big_endian(std::string_view bytes) {
  uint32_t out = 0;
  for (size_t i = 0; i < 4; ++i) out = out << 8 | static_cast<unsigned char>(bytes[i]);
  return out;
}

}  // namespace

TEST_CASE("deflate: what was written comes back, noise, runs and rows") {
  RandomStream random(1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    const size_t n = random.below(3000), row = 1 + random.below(700),
                 colours = 1 + random.below(trial % 3 == 0 ? 256 : 3);
    std::string bytes;
    while (bytes.size() < n) {
      const char value = static_cast<char>(random.below(colours));
      bytes.append(1 + random.below(400), value);
      if (bytes.size() > row && random.uniform() < 0.5)
        bytes += bytes.substr(bytes.size() - row, random.below(600));
    }
    CAPTURE(trial);
    CHECK(back(zlib_of(bytes, row)) == bytes);
  }
  CHECK(back(zlib_of("", 0)).empty());
}

TEST_CASE("deflate: even rows shrink, noise grows by an eighth at most") {
  CHECK(zlib_of(std::string(1000000, 'x'), 1000).size() < 7000);
  RandomStream random(2, 1);
  std::string noise;
  for (int i = 0; i < 100000; ++i) noise += static_cast<char>(random.below(256));
  CHECK(zlib_of(noise, 1000).size() < 112600);
}

TEST_CASE("png: signature, chunks and their check sums") {
  const IndexedImage image{3, 2, {0, 1, 2, 2, 1, 0}, {{255, 255, 255}, {1, 2, 3}, {255, 0, 0}}};
  const std::string png = png_of(image);
  CHECK(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK(big_endian(std::string_view(png).substr(8)) == 13);
  CHECK(png.substr(12, 4) == "IHDR");
  CHECK(big_endian(std::string_view(png).substr(16)) == 3);
  CHECK(big_endian(std::string_view(png).substr(20)) == 2);
  CHECK(png.substr(37, 4) == "PLTE");
  CHECK(big_endian(std::string_view(png).substr(png.size() - 4)) == 0xae426082);  // of every IEND
  const size_t data = png.find("IDAT");
  REQUIRE(data != std::string::npos);
  const uint32_t length = big_endian(std::string_view(png).substr(data - 4));
  CHECK(back(png.substr(data + 4, length)) == std::string("\0\0\1\2\0\2\1\0", 8));
  CHECK(hex_of({255, 0, 16}) == "#ff0010");
}

TEST_CASE("base64: the examples of RFC 4648") {
  CHECK(base64_of("").empty());
  CHECK(base64_of("f") == "Zg==");
  CHECK(base64_of("fo") == "Zm8=");
  CHECK(base64_of("foo") == "Zm9v");
  CHECK(base64_of("foob") == "Zm9vYg==");
  CHECK(base64_of("fooba") == "Zm9vYmE=");
  CHECK(base64_of("foobar") == "Zm9vYmFy");
  CHECK(base64_of("\xff\xef") == "/+8=");
}
