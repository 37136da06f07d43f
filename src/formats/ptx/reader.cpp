// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "base/error.h"
#include "formats/files/fast_number.h"
#include "formats/files/finish_cloud.h"
#include "formats/files/growing_cloud.h"
#include "formats/ptx/ptx.h"
#include "formats/text/line_reader.h"

namespace jalon {

namespace {

constexpr size_t kPtxTicks = 4096;       // points between two looks at the task
constexpr uint64_t kLeastLineBytes = 6;  // "0 0 0" and its end
// Matrices are written with six decimals and fewer: 1e-3 tells a rotation from a scale.
constexpr double kPtxRotation = 1e-3;

struct Scan {
  uint64_t columns = 0, rows = 0;
  Transform to_world;
};

class PtxReader {
 public:
  PtxReader(const ByteSource& source, Task& task) : source_(source), task_(task), lines_(source) {}

  Cloud run() {
    size_t scans = 0;
    while (next_line()) read_scan(++scans);
    if (scans == 0) refuse("there is no scan");
    return cloud_.finish(task_);
  }

 private:
  using Numbers = std::array<double, 7>;

  [[noreturn]] void refuse(const char* reason) const {
    fail(Status::kFormat, "%.400s: line %llu: %s", source_.path().c_str(),
         static_cast<unsigned long long>(lines_.number()), reason);
  }

  // The next line with anything on it.
  bool next_line() {
    while (lines_.next(line_))
      if (line_.find_first_not_of(" \t\f") != std::string_view::npos) return true;
    return false;
  }

  // The numbers of the line; refused where there are more than seven or anything else.
  size_t numbers_of_line(Numbers& out) const {
    const char* p = line_.data();
    const char* const end = p + line_.size();
    size_t n = 0;
    for (;;) {
      while (p < end && (*p == ' ' || *p == '\t')) ++p;
      if (p == end) return n;
      if (n == out.size()) refuse("more numbers than x y z intensity red green blue");
      ParsedNumber number;
      p = parse_number_at(p, end, number);
      if (p == nullptr || (p < end && *p != ' ' && *p != '\t')) refuse("this is no number");
      out[n++] = number.value;
    }
  }

  void need(const char* what, size_t count, Numbers& out) {
    if (!next_line()) refuse("the file ends inside the header of a scan");
    if (numbers_of_line(out) == count) return;
    const std::string reason = std::string("the ") + what +
                               " of a scan were expected: " + std::to_string(count) +
                               (count == 1 ? " number" : " numbers");
    refuse(reason.c_str());
  }

  uint64_t count_of(double number) const {
    if (!(number >= 0) || number > 4294967295.0 || number != std::floor(number))
      refuse("a count of columns or rows is no whole number that a grid can have");
    return static_cast<uint64_t>(number);
  }

  // The line of the columns has been read. The rows of the 4 x 4 matrix stand for columns: a point
  // is a row before it.
  Scan read_header() {
    Numbers numbers{};
    Scan scan;
    if (numbers_of_line(numbers) != 1) refuse("the number of columns of a scan was expected");
    scan.columns = count_of(numbers[0]);
    need("rows", 1, numbers);
    scan.rows = count_of(numbers[0]);
    for (int i = 0; i < 4; ++i) need("position and axes", 3, numbers);
    for (size_t i = 0; i < 4; ++i) {
      need("rows of the matrix", 4, numbers);
      for (size_t k = 0; k < 3; ++k) scan.to_world.m[4 * k + i] = numbers[k];
    }
    for (const double value : scan.to_world.m)
      if (!std::isfinite(value)) refuse("the matrix of a scan holds a number that is not finite");
    if (scan.columns != 0 && scan.rows > (source_.size() / kLeastLineBytes + 1) / scan.columns)
      refuse("the grid of a scan has more cells than the file has room for lines");
    return scan;
  }

  void read_scan(size_t number) {
    const Scan scan = read_header();
    Transform pose = scan.to_world;
    const bool rigid = make_rigid(pose, kPtxRotation);
    if (!rigid)
      task_.log(Task::kWarning,
                "%s: line %llu: the matrix of scan %zu scales or mirrors: its points are moved by "
                "it, its station has no pose",
                source_.path().c_str(), static_cast<unsigned long long>(lines_.number()), number);
    cloud_.begin_station("scan " + std::to_string(number), rigid ? &pose : nullptr);
    const uint64_t cells = scan.columns * scan.rows;
    for (uint64_t cell = 0; cell < cells; ++cell) {
      if (cell % kPtxTicks == 0) task_.checkpoint(lines_.fraction());
      if (!next_line()) {
        const std::string reason = "the file ends after " + std::to_string(cell) + " of the " +
                                   std::to_string(cells) + " lines of scan " +
                                   std::to_string(number);
        refuse(reason.c_str());
      }
      add_point(scan, cell);
    }
  }

  void add_point(const Scan& scan, uint64_t cell) {
    Numbers numbers{};
    const size_t n = numbers_of_line(numbers);
    if (n != 3 && n != 4 && n != 7) refuse("a point needs 3, 4 or 7 numbers");
    if (numbers[0] == 0 && numbers[1] == 0 && numbers[2] == 0) return;  // no return
    if (fields_[0] == kNoField) declare_grid();
    if (n > 3 && fields_[2] == kNoField)
      fields_[2] = cloud_.field({"intensity", ElementType::kFloat32, 1, "", ""});
    if (n == 7 && fields_[3] == kNoField) declare_colour();
    const double row = static_cast<double>(cell % scan.rows),
                 column = static_cast<double>(cell / scan.rows);
    const double values[6] = {row, column, numbers[3], numbers[4], numbers[5], numbers[6]};
    for (size_t k = 3; k < n - 1; ++k)
      if (!(values[k] >= 0 && values[k] <= 255)) refuse("a colour is not from 0 to 255");
    const size_t used = n == 3 ? 2 : n == 4 ? 3 : 6;
    cloud_.add(scan.to_world.point({numbers[0], numbers[1], numbers[2]}),
               std::span(fields_).first(used), std::span(values).first(used));
  }

  void declare_grid() {
    fields_[0] = cloud_.field({"row", ElementType::kUint32, 1, "", "line of the scan's grid"});
    fields_[1] = cloud_.field({"column", ElementType::kUint32, 1, "", "column of the scan's grid"});
  }
  void declare_colour() {
    static constexpr const char* kNames[] = {"red", "green", "blue"};
    for (size_t k = 0; k < 3; ++k)
      fields_[3 + k] = cloud_.field({kNames[k], ElementType::kUint8, 1, "", ""});
  }

  static constexpr size_t kNoField = ~size_t{0};
  const ByteSource& source_;
  Task& task_;
  LineReader lines_;
  std::string_view line_;
  GrowingCloud cloud_;
  std::array<size_t, 6> fields_{kNoField, kNoField, kNoField, kNoField, kNoField, kNoField};
};

}  // namespace

Cloud read_ptx(const ByteSource& source, const ReadSettings& settings, Task& task) {
  Cloud cloud;
  {
    ProgressSpan span(task, 0, 0.95, "reading PTX");
    cloud = PtxReader(source, task).run();
  }
  return finish_cloud(std::move(cloud), source, settings.drop_invalid, task);
}

}  // namespace jalon
