// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstring>

#include "malformed_edits.h"
#include "malformed_files.h"

namespace malformed {

namespace {

std::string record(const char* user, uint16_t id, const std::string& data) {
  std::string out(54, '\0');
  std::memcpy(out.data() + 2, user, std::strlen(user));
  put<uint16_t>(out, 18, id);
  put<uint16_t>(out, 20, static_cast<uint16_t>(data.size()));
  return out + data;
}

// Eight points of format 0 with one extra byte, "station", which counts 1 1 2 2 ...
std::string las_with(const std::string& text) {
  constexpr size_t kPoints = 8, kRecord = 21;
  std::string dimension(192, '\0');
  dimension[2] = 1;
  std::memcpy(dimension.data() + 4, "station", 7);
  std::string out(227, '\0');
  std::memcpy(out.data(), "LASF", 4);
  out[24] = 1, out[25] = 2;
  put<uint16_t>(out, 94, 227);
  put<uint32_t>(out, 100, 2);
  put<uint16_t>(out, 105, kRecord);
  put<uint32_t>(out, 107, kPoints);
  for (size_t k = 0; k < 3; ++k) put<double>(out, 131 + 8 * k, 0.01);
  out += record("LASF_Spec", 4, dimension) + record("Jalon", 1, text.substr(0, 0xFFFF));
  put<uint32_t>(out, 96, static_cast<uint32_t>(out.size()));
  for (size_t i = 0; i < kPoints; ++i) {
    std::string point(kRecord, static_cast<char>(i));
    point[20] = static_cast<char>(i / 2 + 1);
    out += point;
  }
  return out;
}

std::string ply_with(const std::string& text) {
  std::string line = text;
  for (char& c : line)
    if (c == '\n') c = ' ';
  return "ply\nformat ascii 1.0\ncomment stations " + line +
         "\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
         "1 2 3\n1 2 4\n1 2 5\n1 2 6\n2 2 3\n2 2 4\n2 2 5\n2 2 6\n";
}

const std::string kPoints_xyz = "1 2 3\n1 2 4\n1 2 5\n1 2 6\n2 2 3\n2 2 4\n2 2 5\n2 2 6\n";

void add_everywhere(std::vector<File>& out, const std::string& text) {
  out.push_back({"stations.las", las_with(text)});
  out.push_back({"stations.ply", ply_with(text)});
  out.push_back({"stations.xyz", kPoints_xyz, text});
}

std::string of_stations(const std::string& before, const std::string& stations) {
  return "{\"jalon_stations\": 1, " + before + "\"stations\": [" + stations + "]}";
}

}  // namespace

std::vector<File> station_files() {
  std::vector<File> out;
  const std::string pose = "\"pose\": [1, 0, 0, 5, 0, 1, 0, -3, 0, 0, 1, 1.7]";
  const std::string ranges =
      of_stations("\"points\": 8, ", "{\"name\": \"a\", \"first\": 0, \"count\": 5, " + pose +
                                         "}, {\"name\": \"b\", \"first\": 5, \"count\": 3}");
  const std::string field =
      of_stations("\"field\": \"station\", ", "{\"value\": 1, " + pose + "}, {\"value\": 4}");
  for (const std::string& seed : {ranges, field})
    for (size_t at = 0; at < seed.size(); at += 2) {
      add_everywhere(out, seed.substr(0, at));
      for (const char bad : {'\xff', '9', '"'}) {
        std::string text = seed;
        text[at] = bad;
        add_everywhere(out, text);
      }
    }
  for (const char* number : {"-1", "0", "4294967296", "9223372036854775807", "18446744073709551615",
                             "1e308", "-1e308", "1e999", "nan", "null", "{}", "[[[[", "\"\""}) {
    const std::string n = number;
    add_everywhere(out, of_stations("", "{\"first\": " + n + ", \"count\": " + n + "}"));
    add_everywhere(out, of_stations("\"points\": " + n + ", ", "{\"count\": 8}"));
    add_everywhere(out, of_stations("", "{\"count\": 8, \"position\": [" + n + ", 0, " + n + "]}"));
    add_everywhere(out, of_stations("\"field\": \"z\", ", "{\"value\": " + n + "}"));
    add_everywhere(out, "{\"jalon_stations\": " + n + "}");
  }
  for (const char* piece : {"{},", "[", "{\"a\":", "{\"count\": 0},", "\"", "\\u0000", " "}) {
    std::string many;
    while (many.size() < 3000000) many += piece;
    add_everywhere(out, of_stations("", many));
    add_everywhere(out, many);
  }
  return out;
}

}  // namespace malformed
