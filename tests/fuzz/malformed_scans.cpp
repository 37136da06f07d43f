// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cstring>

#include "malformed_files.h"

namespace malformed {

namespace {

std::string times(const std::string& text, size_t n) {
  std::string out;
  for (size_t i = 0; i < n; ++i) out += text;
  return out;
}

// Cut at every byte; every byte turned into others.
void add_damage(std::vector<File>& out, const std::string& seed, const std::string& extension) {
  for (size_t end = 0; end < seed.size(); ++end)
    out.push_back({"cut" + extension, seed.substr(0, end)});
  for (size_t at = 0; at < seed.size(); ++at)
    for (const char bad : {'\0', '\xff', '9'}) {
      std::string bytes = seed;
      bytes[at] = bad;
      out.push_back({"flip" + extension, bytes});
    }
}

constexpr const char* kCounts[] = {"0",
                                   "1",
                                   "4",
                                   "65536",
                                   "4294967295",
                                   "4294967296",
                                   "9223372036854775807",
                                   "18446744073709551615",
                                   "18446744073709551616",
                                   "-1",
                                   "1e3",
                                   "nan",
                                   "x",
                                   ""};

void put_u32(std::string& out, uint32_t value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);  // little-endian machines only
}

const std::string kPose = "1 2 3\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 2 3 1\n";

}  // namespace

std::vector<File> ptx_files() {
  std::vector<File> out;
  const std::string points = "1 2 3 0.5 1 2 3\n0 0 0 0.5 0 0 0\n";
  add_damage(out, "1\n2\n" + kPose + points + "1\n1\n" + kPose + "4 5 6 1", ".ptx");
  for (const std::string count : kCounts) {
    out.push_back({"columns.ptx", count + "\n2\n" + kPose + points});
    out.push_back({"rows.ptx", "2\n" + count + "\n" + kPose + points});
    out.push_back({"both.ptx", count + "\n" + count + "\n" + kPose + points});
  }
  for (const char* bad : {"nan", "inf", "1e308", "1e-320", "1e999", "--1"})
    for (const char* good : {"1 2 3\n", "1 0 0 0\n", "1 2 3 1\n"}) {
      std::string pose = kPose;
      pose.replace(pose.rfind(good), 1, bad);
      out.push_back({"pose.ptx", "1\n1\n" + pose + "1 1 1 1\n"});
    }
  out.push_back({"line.ptx", "1\n1\n" + kPose + std::string(3000000, '1')});
  out.push_back({"blank.ptx", std::string(3000000, '\n')});
  out.push_back({"scans.ptx", times("0\n0\n" + kPose, 20000)});
  out.push_back({"empty.ptx", "1000\n1000\n" + kPose + times("0 0 0\n", 1000000)});
  out.push_back({"dense.ptx", "1000\n400\n" + kPose + times("1 1 1 0 1 1 1\n", 400000)});
  return out;
}

std::vector<File> pts_files() {
  std::vector<File> out;
  add_damage(out, "2\n1 2 3 -7 1 2 3\n4 5 6 7 8 9 10\n1\n7 8 9 1 2 3 4\n", ".pts");
  for (const std::string count : kCounts)
    out.push_back({"count.pts", count + "\n1 2 3\n" + count + "\n4 5 6\n"});
  out.push_back({"blocks.pts", "1\n1 2 3\n" + times("1\n1 2 3\n", 100000)});
  out.push_back({"counts.pts", "1\n1 2 3\n" + times("5\n", 300000)});
  return out;
}

std::vector<File> pcd_files() {
  std::vector<File> out;
  const std::string head =
      "VERSION 0.7\nFIELDS x y z rgb n\nSIZE 4 4 4 4 2\nTYPE F F F U I\nCOUNT 1 1 1 1 2\nWIDTH 2\n"
      "HEIGHT 1\nVIEWPOINT 0 0 1 1 0 0 0\nPOINTS 2\nDATA ";
  const std::string ascii = head + "ascii\n1 2 3 255 -1 1\n4 5 6 77 2 3\n";
  const std::string binary = head + "binary\n" + std::string(40, '\1');
  std::string packed;
  put_u32(packed, 8);
  put_u32(packed, 40);
  packed += std::string("\1\2\3\xE0\x1D\1\x00\5", 8);  // 2 + 38 bytes, and a literal too much
  const std::string compressed = head + "binary_compressed\n" + packed;
  for (const std::string& seed : {ascii, binary, compressed}) add_damage(out, seed, ".pcd");
  for (const std::string count : kCounts)
    for (const char* key : {"SIZE", "COUNT", "WIDTH", "HEIGHT", "POINTS"})
      for (const char* form : {"ascii", "binary", "binary_compressed"}) {
        const bool is_list = std::strcmp(key, "SIZE") == 0 || std::strcmp(key, "COUNT") == 0;
        const std::string value = is_list ? count + " " + count + " " + count : count;
        out.push_back({"count.pcd", std::string("FIELDS x y z\nWIDTH 1\n") + key + " " + value +
                                        "\nDATA " + form + "\n" + packed + packed});
      }
  for (const uint32_t size : {0u, 1u, 0x7FFFFFFFu, 0xFFFFFFFFu}) {
    std::string bytes = "FIELDS x y z\nWIDTH 178956970\nDATA binary_compressed\n";
    put_u32(bytes, size);
    put_u32(bytes, 178956970u * 12u);
    out.push_back({"size.pcd", bytes + std::string(3000000, '\xE0')});
  }
  out.push_back({"many.pcd", "FIELDS" + times(" a", 400000) + "\nWIDTH 1\nDATA ascii\n"});
  out.push_back({"wide.pcd", "FIELDS x y z" + times(" a", 4000) + "\nCOUNT 1 1 1" +
                                 times(" 4096", 4000) + "\nWIDTH 1\nDATA ascii\n1 2 3\n"});
  out.push_back({"line.pcd", "FIELDS x y z\nWIDTH 1\nDATA ascii\n" + std::string(3000000, '1')});
  out.push_back({"head.pcd", "FIELDS x y z\n" + std::string(3000000, '#')});
  return out;
}

}  // namespace malformed
