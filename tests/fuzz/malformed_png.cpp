// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "jalon/jalon.h"
#include "malformed_files.h"

namespace malformed {

namespace {

constexpr size_t kHeader =
    16;  // where the first chunk's content begins: width, height, bits, colours ...

// Depth image of a few points; "" where libpng was not built.
std::string seed_of_our_own() {
  const double xyz[] = {0, 0, 0, 1, 0, 0.5, 0, 1, 1, 1, 1, 2, 2, 2, 0.25};
  std::string folder = (std::filesystem::temp_directory_path() / "jalon-png-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) return "";
  const std::string path = folder + "/seed.png";
  jalon_cloud* cloud = nullptr;
  std::string bytes;
  if (jalon_cloud_create(xyz, JALON_FLOAT64, std::size(xyz) / 3, 0, 0, &cloud) == JALON_OK &&
      jalon_cloud_write(cloud, path.c_str(), nullptr, nullptr) == JALON_OK) {
    std::ifstream file(path, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), {});
  }
  jalon_cloud_release(cloud);
  std::filesystem::remove_all(folder);
  return bytes;
}

// ISO/IEC 15948, annex D.
uint32_t check_sum(const std::string& bytes) {
  uint32_t sum = 0xffffffffu;
  for (const char byte : bytes) {
    sum ^= static_cast<unsigned char>(byte);
    for (int k = 0; k < 8; ++k) sum = (sum & 1) != 0 ? sum >> 1 ^ 0xedb88320u : sum >> 1;
  }
  return ~sum;
}

uint32_t number_at(const std::string& bytes, size_t at) {
  uint32_t value = 0;
  for (size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}
void put_number(std::string& bytes, size_t at, uint32_t value) {
  for (size_t k = 0; k < 4; ++k) bytes[at + k] = static_cast<char>(value >> (24 - 8 * k) & 0xff);
}

// The check sums of all chunks anew, so that what is wrong inside them is looked at.
std::string mended(std::string bytes) {
  for (size_t at = 8; at + 12 <= bytes.size();) {
    const size_t length = number_at(bytes, at);
    if (length > bytes.size() - at - 12) break;
    put_number(bytes, at + 8 + length, check_sum(bytes.substr(at + 4, length + 4)));
    at += length + 12;
  }
  return bytes;
}

std::string chunk(const std::string& name, const std::string& content) {
  std::string out(4, '\0');
  put_number(out, 0, static_cast<uint32_t>(content.size()));
  return mended("12345678" + out + name + content + "none").substr(8);
}

}  // namespace

std::vector<File> png_files() {
  std::vector<File> out;
  const std::string seed = seed_of_our_own();
  if (seed.empty()) return out;
  for (size_t end = 0; end < seed.size(); ++end) out.push_back({"cut.png", seed.substr(0, end)});
  for (size_t at = 0; at < seed.size(); ++at)
    for (const char bad : {'\0', '\xff', '9', '\1'}) {
      std::string bytes = seed;
      bytes[at] = bad;
      out.push_back({"flip.png", bytes});
      out.push_back({"mended.png", mended(bytes)});
    }
  for (const size_t at : {kHeader, kHeader + 4})
    for (const uint32_t size :
         {0u, 1u, 2u, 65536u, 1000000u, 0x7fffffffu, 0x80000000u, 0xffffffffu}) {
      std::string bytes = seed;
      put_number(bytes, at, size);
      out.push_back({"size.png", mended(bytes)});
      put_number(bytes, kHeader, size);
      put_number(bytes, kHeader + 4, size);
      out.push_back({"both.png", mended(bytes)});
    }
  for (int bits = 0; bits < 33; ++bits)
    for (int colours = 0; colours < 8; ++colours)
      for (int interlaced = 0; interlaced < 2; ++interlaced) {
        std::string bytes = seed;
        bytes[kHeader + 8] = static_cast<char>(bits);
        bytes[kHeader + 9] = static_cast<char>(colours);
        bytes[kHeader + 12] = static_cast<char>(interlaced);
        out.push_back({"kind.png", mended(bytes)});
      }
  const size_t behind_header = kHeader + 17;
  const auto with_text = [&](const std::string& name, const std::string& content) {
    std::string bytes = seed;
    bytes.insert(behind_header, chunk(name, content));
    out.push_back({"text.png", bytes});
  };
  const std::string keyword("Depth image grid\0", 17);
  for (const char* grid :
       {"", "1", "nan 0 0 0 0 0 0 0 0 0 0 0", "1 2 3 4 5 6 7 8 9 10 11 1e999",
        "1e308 1e308 1e308 1e308 1e308 1e308 1e308 1e308 1e308 1e308 1e308 1e308"})
    with_text("tEXt", keyword + grid);
  with_text("tEXt", keyword + std::string(3000000, '1'));
  with_text("zTXt", keyword + std::string("\0not deflated", 13));
  with_text("iTXt", keyword + std::string("\0\0\0\0\xff\xfe", 6));
  with_text("tRNS", "");
  with_text("tRNS", std::string(600, '\xff'));
  std::string many;
  for (int k = 0; k < 2000; ++k) many += chunk("tEXt", keyword + "1");
  std::string bytes = seed;
  out.push_back({"many.png", bytes.insert(behind_header, many)});
  return out;
}

}  // namespace malformed
