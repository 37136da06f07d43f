// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "formats/codecs/codecs.h"
#include "formats/e57/e57.h"
#include "formats/e57/normals.h"
#include "formats/e57/record_points.h"
#include "formats/e57/records.h"
#include "formats/files/endian.h"
#include "formats/files/finish_cloud.h"
#include "formats/files/growing_cloud.h"
#include "formats/files/utf8.h"
#include "geometry/rotation.h"

namespace jalon {

namespace {

constexpr size_t kE57Grain = 4096;
constexpr uint64_t kMostE57Columns = 256;  // the standard has 21
constexpr double kE57Quaternion = 1e-3;    // off the length 1

class E57Reader {
 public:
  E57Reader(const ByteSource& source, Task& task) : source_(source), task_(task) {}
  ~E57Reader() { jc_e57_close(document_); }
  E57Reader(const E57Reader&) = delete;
  E57Reader& operator=(const E57Reader&) = delete;

  Cloud run() {
    check_header();
    call(jc_e57_open({this, read_for_decoder, source_.size()}, &document_, &scans_, message()));
    if (scans_ == 0) source_.refuse(0, "the file holds no scan");
    const bool wide = has_wide_colours();
    for (uint64_t s = 0; s < scans_; ++s) {
      ProgressSpan span(task_, share(s), share(s + 1));
      read_scan(s, wide);
    }
    const char* crs = "";
    call(jc_e57_crs(document_, &crs, message()));
    Cloud cloud = cloud_.finish(task_);
    cloud.crs = valid_utf8(crs);
    join_normals(cloud);
    return cloud;
  }

 private:
  double share(uint64_t scan) const {
    return static_cast<double>(scan) / static_cast<double>(scans_);
  }

  // The decoder takes memory for the XML before it looks whether the file is that long.
  void check_header() const {
    constexpr uint64_t kHeader = 48, kXmlBytes = 32;
    std::byte header[kHeader];
    source_.read(0, header, sizeof header);
    if (load<uint64_t>(header + kXmlBytes) > source_.size())
      source_.refuse(kXmlBytes, "the XML section of %llu bytes is longer than the file",
                     static_cast<unsigned long long>(load<uint64_t>(header + kXmlBytes)));
  }

  JcMessage message() {
    line_[0] = '\0';
    return {line_, sizeof line_};
  }

  void call(int32_t status) {
    if (!has_failed(status)) return;
    task_.checkpoint(0);  // a cancel is told as such
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
    fail(Status::kFormat, "%.400s: %s", source_.path().c_str(), valid_utf8(line_).c_str());
  }

  // Nothing is thrown through the decoder: what happens here is thrown when it has given up.
  static int64_t read_for_decoder(void* self, uint64_t offset, uint8_t* out, uint64_t bytes) {
    auto& reader = *static_cast<E57Reader*>(self);
    try {
      if (reader.task_.cancelled()) return -1;
      return static_cast<int64_t>(reader.source_.read_some(offset, out, bytes));
    } catch (...) {
      reader.thrown_ = std::current_exception();
      return -1;
    }
  }

  std::vector<JcColumn> columns_of(uint64_t scan, const JcScan& info,
                                   std::vector<e57::RecordColumn>* packed = nullptr) {
    if (info.columns > kMostE57Columns)
      source_.refuse(0, "scan %llu has more than %llu columns",
                     static_cast<unsigned long long>(scan + 1),
                     static_cast<unsigned long long>(kMostE57Columns));
    std::vector<JcColumn> columns(info.columns);
    for (uint64_t c = 0; c < info.columns; ++c) {
      JcPacking packing{};
      call(jc_e57_column(document_, scan, c, &columns[c], &packing, message()));
      if (packed != nullptr)
        packed->push_back({columns[c].kind, columns[c].scale, columns[c].offset, packing});
    }
    return columns;
  }

  JcScan scan_info(uint64_t scan) {
    JcScan info{};
    call(jc_e57_scan(document_, scan, &info, message()));
    return info;
  }

  // One type for all scans: 16 bits where one of them has colours beyond 255.
  bool has_wide_colours() {
    bool wide = false;
    for (uint64_t s = 0; s < scans_; ++s)
      for (const JcColumn& column : columns_of(s, scan_info(s)))
        wide = wide || (std::string_view(column.name).starts_with("color") &&
                        column.kind == kJcInteger && column.max > 255);
    return wide;
  }

  static std::optional<size_t> find(const std::vector<JcColumn>& columns, std::string_view name) {
    for (size_t c = 0; c < columns.size(); ++c)
      if (name == columns[c].name) return c;
    return std::nullopt;
  }

  e57::ScanLayout layout_of(uint64_t scan, const std::vector<JcColumn>& columns, bool wide) const {
    static constexpr const char* kPlaces[2][4] = {
        {"cartesianX", "cartesianY", "cartesianZ", "cartesianInvalidState"},
        {"sphericalRange", "sphericalAzimuth", "sphericalElevation", "sphericalInvalidState"}};
    e57::ScanLayout layout;
    layout.spherical = !find(columns, kPlaces[0][0]).has_value();
    const auto& names = kPlaces[layout.spherical ? 1 : 0];
    for (size_t k = 0; k < 3; ++k) {
      const auto column = find(columns, names[k]);
      if (!column)
        fail(Status::kFormat, "%.400s: scan %llu has no column %s", source_.path().c_str(),
             static_cast<unsigned long long>(scan + 1), names[k]);
      layout.position[k] = *column;
    }
    layout.invalid = find(columns, names[3]);
    for (size_t c = 0; c < columns.size(); ++c)
      if (auto field = field_of(columns, c, wide)) layout.fields.push_back(*field);
    return layout;
  }

  static std::optional<e57::FieldColumn> field_of(const std::vector<JcColumn>& columns, size_t c,
                                                  bool wide) {
    static constexpr struct {
      const char *column, *field;
      ElementType type;
      const char *unit, *meaning, *invalid;
      double shift;
    } kFields[] = {
        {"rowIndex", "row", ElementType::kUint32, "", "line of the scan's grid", "", 0},
        {"columnIndex", "column", ElementType::kUint32, "", "column of the scan's grid", "", 0},
        {"intensity", "intensity", ElementType::kFloat32, "", "", "isIntensityInvalid", 0},
        {"returnIndex", "return_number", ElementType::kUint8, "", "", "", 1},
        {"returnCount", "number_of_returns", ElementType::kUint8, "", "", "", 0},
        {"timeStamp", "time", ElementType::kFloat64, "s", "", "isTimeStampInvalid", 0},
        {"colorRed", "red", ElementType::kUint8, "", "", "isColorInvalid", 0},
        {"colorGreen", "green", ElementType::kUint8, "", "", "isColorInvalid", 0},
        {"colorBlue", "blue", ElementType::kUint8, "", "", "isColorInvalid", 0}};
    const std::string_view name = columns[c].name;
    for (const auto& row : kFields) {
      if (name != row.column) continue;
      e57::FieldColumn out{c,
                           {row.field, row.type, 1, row.unit, row.meaning},
                           1,
                           row.shift,
                           find(columns, row.invalid)};
      if (name.starts_with("color")) {
        const double most = wide ? 65535 : 255;
        out.field.type = wide ? ElementType::kUint16 : ElementType::kUint8;
        if (columns[c].kind != kJcInteger) out.factor = most;  // of floats: from 0 to 1
      }
      return out;
    }
    const size_t colon = name.find(':');  // "nor:normalX" of an extension
    if (colon == std::string_view::npos || name.find("nvalid") != std::string_view::npos)
      return std::nullopt;
    const std::string own = name_from_file(name.substr(colon + 1), numbered("column", c + 1));
    return e57::FieldColumn{c, {own, type_of(columns[c]), 1, "", ""}, 1, 0, std::nullopt};
  }

  // The smallest type that holds all the column may.
  static ElementType type_of(const JcColumn& column) {
    if (column.kind == kJcSingle) return ElementType::kFloat32;
    if (column.kind != kJcInteger) return ElementType::kFloat64;
    for (const ElementType type : {ElementType::kUint8, ElementType::kInt8, ElementType::kUint16,
                                   ElementType::kInt16, ElementType::kUint32, ElementType::kInt32})
      if (visit(type, [&](auto zero) {
            using Limits = std::numeric_limits<decltype(zero)>;
            return column.min >= static_cast<double>(Limits::min()) &&
                   column.max <= static_cast<double>(Limits::max());
          }))
        return type;
    return column.min < 0 ? ElementType::kInt64 : ElementType::kUint64;
  }

  // E57 says T_world_scanner as a quaternion and a translation.
  std::optional<Transform> pose_of(const JcScan& info, uint64_t scan) const {
    if (info.has_pose == 0) return std::nullopt;
    Transform pose;
    const auto& q = info.rotation;
    const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    bool good = std::fabs(length - 1) <= kE57Quaternion;
    for (const double t : info.translation) good = good && std::isfinite(t);
    if (!good)
      fail(Status::kFormat,
           "%.400s: the pose of scan %llu is no rotation and translation of finite numbers",
           source_.path().c_str(), static_cast<unsigned long long>(scan + 1));
    const Matrix3 r = matrix_of({q[0] / length, q[1] / length, q[2] / length, q[3] / length});
    for (size_t i = 0; i < 3; ++i) {
      for (size_t k = 0; k < 3; ++k) pose.m[4 * i + k] = r.m[3 * i + k];
      pose.m[4 * i + 3] = info.translation[i];
    }
    return pose;
  }

  void read_scan(uint64_t scan, bool wide) {
    const JcScan info = scan_info(scan);
    std::vector<e57::RecordColumn> packed;
    const std::vector<JcColumn> columns = columns_of(scan, info, &packed);
    const e57::ScanLayout layout = layout_of(scan, columns, wide);
    const std::optional<Transform> pose = pose_of(info, scan);
    std::string name = name_from_file(info.name, "");
    if (name.empty()) name = "scan " + std::to_string(scan + 1);
    cloud_.begin_station(name, pose ? &*pose : nullptr);
    std::vector<size_t> numbers;
    for (const e57::FieldColumn& field : layout.fields)
      numbers.push_back(cloud_.field(field.field));
    e57::Records records(source_, info.section, info.records, std::move(packed), task_);
    double done = 0;
    while (const size_t count = records.next(task_)) {
      const auto all = static_cast<double>(info.records);
      ProgressSpan span(task_, done / all, (done + static_cast<double>(count)) / all);
      add_points(records, count, layout, pose, numbers);
      done += static_cast<double>(count);
    }
  }

  // The valid ones of these records.
  void add_points(const e57::Records& records, size_t count, const e57::ScanLayout& layout,
                  const std::optional<Transform>& pose, const std::vector<size_t>& numbers) {
    std::vector<size_t> firsts((count + kE57Grain - 1) / kE57Grain);  // points of each part
    parallel_for(task_, count, kE57Grain, [&](size_t begin, size_t end) {
      firsts[begin / kE57Grain] = e57::RecordPoints(records, layout, begin, end).count();
    });
    size_t valid = 0;
    for (size_t& first : firsts) valid += std::exchange(first, valid);
    const size_t before = cloud_.extend(valid, numbers);
    parallel_for(task_, count, kE57Grain, [&](size_t begin, size_t end) {
      const e57::RecordPoints part(records, layout, begin, end);
      const size_t first = before + firsts[begin / kE57Grain];
      cloud_.put(first, part.places(pose));
      for (size_t f = 0; f < numbers.size(); ++f)
        cloud_.put_field(numbers[f], first, part.values(layout.fields[f]));
    });
  }

  const ByteSource& source_;
  Task& task_;
  JcE57* document_ = nullptr;
  uint64_t scans_ = 0;
  char line_[400] = {};
  std::exception_ptr thrown_;
  GrowingCloud cloud_;
};

}  // namespace

bool is_e57(const ByteSource& source) {
  char start[8];
  return std::string_view(start, source.read_some(0, start, sizeof start)) == "ASTM-E57";
}

Cloud read_e57(const ByteSource& source, const ReadSettings& settings, Task& task) {
  require_codecs(source.path(), "E57");
  Cloud cloud;
  {
    ProgressSpan span(task, 0, 0.95, "reading E57");
    cloud = E57Reader(source, task).run();
  }
  return finish_cloud(std::move(cloud), source, settings.drop_invalid, task);
}

}  // namespace jalon
