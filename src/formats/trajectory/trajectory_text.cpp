// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/trajectory/trajectory_text.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "base/error.h"
#include "base/text_number.h"
#include "formats/files/atomic_file.h"
#include "formats/text/line_reader.h"

namespace jalon {

namespace {

// The lists of a trajectory and their columns: time and six triples.
struct Triple {
  std::vector<Vec3> Trajectory::*list;
  std::array<const char*, 3> names;
  bool is_angle, is_sigma, is_needed;
};
constexpr Triple kTriples[] = {
    {&Trajectory::positions, {"x", "y", "z"}, false, false, true},
    {&Trajectory::attitudes_rad, {"roll", "pitch", "yaw"}, true, false, true},
    {&Trajectory::velocities_m_s, {"vx", "vy", "vz"}, false, false, false},
    {&Trajectory::position_sigmas_m, {"sx", "sy", "sz"}, false, true, false},
    {&Trajectory::velocity_sigmas_m_s, {"svx", "svy", "svz"}, false, true, false},
    {&Trajectory::attitude_sigmas_rad, {"sroll", "spitch", "syaw"}, true, true, false},
};
constexpr double kDegree_rad = std::numbers::pi / 180;

// What a column of the file is: triple -1 is the time, -2 nothing that is known.
struct TextColumn {
  int triple = -2, component = 0;
  double unit = 1;
  std::string name;
};

TextColumn column_named(std::string_view name) {
  TextColumn made;
  made.name = std::string(name);
  std::string bare = made.name;
  std::transform(bare.begin(), bare.end(), bare.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  if (bare == "time" || bare == "t") made.triple = -1;
  const bool in_degrees = bare.ends_with("_deg");
  if (in_degrees) bare.resize(bare.size() - 4);
  if (bare == "heading") bare = "yaw";
  if (bare == "sheading") bare = "syaw";
  for (size_t t = 0; t < std::size(kTriples); ++t)
    for (int k = 0; k < 3; ++k)
      if (bare == kTriples[t].names[static_cast<size_t>(k)] &&
          (!in_degrees || kTriples[t].is_angle)) {
        made.triple = static_cast<int>(t);
        made.component = k;
        made.unit = in_degrees ? kDegree_rad : 1;
      }
  return made;
}

// Cells by any of the separators.
std::vector<std::string_view> trajectory_cells(std::string_view line) {
  std::vector<std::string_view> cells;
  constexpr std::string_view kSeparators = " \t,;";
  for (size_t at = line.find_first_not_of(kSeparators); at != std::string_view::npos;) {
    const size_t end = std::min(line.find_first_of(kSeparators, at), line.size());
    cells.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kSeparators, end);
  }
  return cells;
}

class TrajectoryTextReader {
 public:
  TrajectoryTextReader(const std::string& path, AxesConvention axes, Task& task)
      : source_(path), lines_(source_), task_(task) {
    made_.axes = axes;
  }

  Trajectory read() {
    for (std::string_view line; lines_.next(line);) {
      constexpr uint64_t kTogether = 4096;
      if (lines_.number() % kTogether == 0) task_.checkpoint(lines_.fraction());
      const auto cells = trajectory_cells(line);
      if (cells.empty()) continue;
      if (cells[0][0] == '#') comment(trajectory_cells(line.substr(line.find('#') + 1)));
      else if (columns_.empty()) name_columns(cells);
      else epoch(cells);
    }
    if (columns_.empty())
      fail(Status::kFormat, "%s: no line names the columns: time x y z roll pitch yaw ...",
           source_.path().c_str());
    if (made_.size() < 2)
      fail(Status::kFormat, "%s: a trajectory of %zu epochs: two are needed",
           source_.path().c_str(), made_.size());
    return std::move(made_);
  }

 private:
  [[noreturn]] void refuse_line(const std::string& why) {
    fail(Status::kFormat, "%s: line %llu: %s", source_.path().c_str(),
         static_cast<unsigned long long>(lines_.number()), why.c_str());
  }

  void comment(const std::vector<std::string_view>& words) {
    if (words.size() == 2 && words[0] == "crs") made_.crs = std::string(words[1]);
    if (words.size() == 2 && words[0] == "axes") {
      if (words[1] != "enu" && words[1] != "ned")
        refuse_line("axes are enu or ned, not " + std::string(words[1]));
      made_.axes = words[1] == "enu" ? AxesConvention::kEnu : AxesConvention::kNed;
    }
    // A header may be a comment.
    if (columns_.empty() && std::find(words.begin(), words.end(), "time") != words.end())
      name_columns(words);
  }

  void name_columns(const std::vector<std::string_view>& cells) {
    for (const std::string_view cell : cells) columns_.push_back(column_named(cell));
    const auto count = [&](int triple, int component) {
      return std::count_if(columns_.begin(), columns_.end(), [&](const TextColumn& c) {
        return c.triple == triple && c.component == component;
      });
    };
    if (count(-1, 0) != 1) refuse_line("one column \"time\" is needed");
    for (size_t t = 0; t < std::size(kTriples); ++t) {
      int64_t there = 0;
      for (int k = 0; k < 3; ++k) {
        const int64_t n = count(static_cast<int>(t), k);
        const std::string name = kTriples[t].names[static_cast<size_t>(k)];
        if (n > 1) refuse_line("column \"" + name + "\" is there twice");
        there += n;
      }
      if (there != 3 && (there != 0 || kTriples[t].is_needed))
        refuse_line(std::string("columns \"") + kTriples[t].names[0] + "\", \"" +
                    kTriples[t].names[1] + "\", \"" + kTriples[t].names[2] +
                    "\" go together: " + std::to_string(there) + " of them are there");
      has_[t] = there == 3;
    }
    for (const TextColumn& column : columns_)
      if (column.triple == -2)
        task_.log(Task::kWarning, "%s: column \"%.100s\" is not known and passed over",
                  source_.path().c_str(), column.name.c_str());
  }

  void epoch(const std::vector<std::string_view>& cells) {
    if (cells.size() != columns_.size())
      refuse_line(std::to_string(cells.size()) + " values under " +
                  std::to_string(columns_.size()) + " names");
    Vec3 triples[std::size(kTriples)];
    double time = 0;
    for (size_t c = 0; c < cells.size(); ++c) {
      const TextColumn& column = columns_[c];
      if (column.triple == -2) continue;
      double value = 0;
      if (!parse_number(cells[c], value) || !std::isfinite(value))
        refuse_line("column \"" + column.name + "\": " + std::string(cells[c].substr(0, 100)) +
                    " is no number");
      if (column.triple == -1) {
        time = value;
        continue;
      }
      if (kTriples[column.triple].is_sigma && !(value > 0))
        refuse_line("column \"" + column.name + "\" is " + text_of(value) +
                    "; a standard deviation must be positive");
      triples[column.triple][column.component] = value * column.unit;
    }
    if (made_.size() > 0 && !(time > made_.times_s.back()))
      refuse_line("time " + text_of(time) + " is not after time " + text_of(made_.times_s.back()) +
                  " of the epoch before");
    made_.times_s.push_back(time);
    for (size_t t = 0; t < std::size(kTriples); ++t)
      if (has_[t]) (made_.*kTriples[t].list).push_back(triples[t]);
  }

  ByteSource source_;
  LineReader lines_;
  Task& task_;
  Trajectory made_;
  std::vector<TextColumn> columns_;
  bool has_[std::size(kTriples)] = {};
};

}  // namespace

Trajectory read_trajectory_text(const std::string& path, AxesConvention axes, Task& task) {
  return TrajectoryTextReader(path, axes, task).read();
}

void write_trajectory_text(const Trajectory& trajectory, const std::string& path, Task& task) {
  AtomicFile file(path);
  file.write(trajectory.axes == AxesConvention::kEnu ? "# axes enu\n" : "# axes ned\n");
  // Only what is one word comes back: WKT does not.
  const std::string& crs = trajectory.crs;
  if (!crs.empty() && crs.find_first_of(" \t\r\n,;") == std::string::npos)
    file.write("# crs " + crs + "\n");
  std::string line = "time";
  for (const Triple& triple : kTriples)
    if (!(trajectory.*triple.list).empty())
      for (const char* name : triple.names) line += std::string(" ") + name;
  file.write(line + "\n");
  for (size_t i = 0; i < trajectory.size(); ++i) {
    constexpr size_t kTogether = 4096;
    if (i % kTogether == 0)
      task.checkpoint(static_cast<double>(i) / static_cast<double>(trajectory.size()));
    line = text_of(trajectory.times_s[i]);
    for (const Triple& triple : kTriples)
      if (const std::vector<Vec3>& list = trajectory.*triple.list; !list.empty())
        for (int k = 0; k < 3; ++k) line += " " + text_of(list[i][k]);
    file.write(line + "\n");
  }
  file.commit();
}

}  // namespace jalon
