// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/lengths.h"
#include "cli/text_file.h"

namespace jalon::cli {

/// A list of codes or a code table; what no text editor would have saved as UTF-8 is a Failure that says so.
inline std::string read_code_file(const std::string& path) {
  std::string text = read_text_file(path);
  const bool is_utf16 = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  const size_t zero = text.find('\0');
  if (is_utf16 || zero != std::string::npos)
    throw Failure{JALON_ERROR_FORMAT,
                  path + (is_utf16 ? ": is UTF-16; save the file as UTF-8"
                                   : ": is no text: byte " + std::to_string(zero) + " is zero")};
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw Failure{JALON_ERROR_FORMAT, path + ": is empty"};
  return text;
}

using CodedPlace = std::array<double, 3>;

/// X, Y and Z of the lines of a list that have them; what is wrong with the others is told by who reads the codes.
inline std::vector<CodedPlace> places_of_codes(std::string_view text) {
  std::vector<CodedPlace> out;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    CodedPlace place{};
    size_t read = 0;
    for (; read < place.size(); ++read) {
      const size_t before = line.find_first_of(";\t");
      if (before == std::string_view::npos) break;
      line.remove_prefix(std::min(line.size(), line.find_first_not_of(' ', before + 1)));
      const auto end = std::from_chars(line.data(), line.data() + line.size(), place[read]);
      if (end.ec != std::errc()) break;
    }
    if (read == place.size()) out.push_back(place);
  }
  return out;
}

using CodedChange = std::function<CodedPlace(const CodedPlace&)>;

/// Whether a place lies in the box or within 10 m of it: those that do not are warned of one by one.
inline bool any_near(const std::vector<CodedPlace>& places, const jalon_box& box,
                     const CodedChange& mended) {
  constexpr double kNear_m = 10;
  for (const CodedPlace& place : places) {
    const CodedPlace p = mended(place);
    if (p[0] > box.min.x - kNear_m && p[0] < box.max.x + kNear_m && p[1] > box.min.y - kNear_m &&
        p[1] < box.max.y + kNear_m && p[2] > box.min.z - kNear_m && p[2] < box.max.z + kNear_m)
      return true;
  }
  return false;
}

/// Ends the command where the list of a segmenter's parameters lies elsewhere than its scan, with the slip that
/// explains it, if one does.
inline void require_near(const std::string& path, const Params& params, const Cloud& cloud) {
  const char *text = nullptr, *unit_text = nullptr;
  must(jalon_params_get_string(params.get(), "codes", &text));
  must(jalon_params_get_string(params.get(), "codes_unit", &unit_text));
  const std::vector<CodedPlace> places = places_of_codes(text);
  const std::string unit = unit_text;
  constexpr double kFoot_m = 0.3048, kUsFoot_m = 1200.0 / 3937.0;
  const auto times = [](double by) {
    return [by](const CodedPlace& p) { return CodedPlace{p[0] * by, p[1] * by, p[2] * by}; };
  };
  const double unit_m = unit == "ft"      ? kFoot_m
                        : unit == "us-ft" ? kUsFoot_m
                        : unit == "cm"    ? 0.01
                        : unit == "mm"    ? 0.001
                                          : 1;
  const auto exchanged = [unit_m](const CodedPlace& p) {
    return CodedPlace{p[1] * unit_m, p[0] * unit_m, p[2] * unit_m};
  };
  struct {
    const char* text;
    CodedChange mended;
  } const slips[] = {
      {"with X and Y exchanged they do", exchanged},
      {"taken for metres they do: see --set codes_unit=m", times(1)},
      {"taken for feet they do: see --set codes_unit=ft or us-ft", times(kFoot_m)},
      {"taken for millimetres they do: see --set codes_unit=mm", times(0.001)},
      {"taken for centimetres they do: see --set codes_unit=cm", times(0.01)},
      {"they do if the scan is in feet: see --unit ft", times(unit_m / kFoot_m)},
      {"they do if the scan is in millimetres: see --unit mm", times(unit_m * 1000)}};
  const jalon_box box = box_of(cloud);
  if (places.empty() || any_near(places, box, times(unit_m))) return;
  std::string why = "are both in one system?";
  for (const auto& slip : slips)
    if (any_near(places, box, slip.mended)) {
      why = slip.text;
      break;
    }
  throw Failure{JALON_ERROR_INSUFFICIENT_DATA,
                path + ": none of its points lies within 10 m of the scan; " + why};
}

}  // namespace jalon::cli
