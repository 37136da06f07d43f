// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/inputs/pose_file.h"

#include <algorithm>
#include <charconv>

#include "cli/text_file.h"

namespace jalon::cli {

jalon_transform read_pose(const std::string& path) {
  std::vector<double> all;
  for (const NumberLine& row : read_number_lines(path))
    all.insert(all.end(), row.numbers.begin(), row.numbers.end());
  const bool has_last_row =
      all.size() == 16 && all[12] == 0 && all[13] == 0 && all[14] == 0 && all[15] == 1;
  if (all.size() != 12 && !has_last_row)
    throw Failure{JALON_ERROR_FORMAT,
                  path + ": a pose has 12 numbers, or 16 with 0 0 0 1 at the end; here are " +
                      std::to_string(all.size())};
  jalon_transform pose;
  std::copy_n(all.begin(), 12, pose.m);
  return pose;
}

std::string pose_text(const jalon_transform& pose) {
  std::string out;
  for (size_t i = 0; i < 12; ++i) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, pose.m[i]).ptr;
    out.append(digits, end);
    out += i % 4 == 3 ? '\n' : ' ';
  }
  return out + "0 0 0 1\n";
}

}  // namespace jalon::cli
