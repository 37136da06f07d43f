// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "base/random.h"
#include "formats/codecs/codecs.h"
#include "formats/e57/columns.h"
#include "formats/e57/e57.h"
#include "formats/files/atomic_file.h"
#include "formats/files/utf8.h"
#include "geometry/rotation.h"

namespace jalon {

namespace {

using namespace e57;

constexpr size_t kRowsAtOnce = 16384;  // between two looks at the task
constexpr size_t kRowGrain = 1024;     // of them, made on one thread
constexpr uint64_t kGuidStream = 57;   // of the dice that make the names of a file and its scans
constexpr double kMostSteps = 0x1p52;  // of a scaled coordinate, either way

/// Points that become a scan of the file.
struct ScanPart {
  std::string name;
  size_t first = 0, count = 0;
  std::optional<Transform> pose;
};

// The stations, and points between them that belong to none, as they follow each other.
std::vector<ScanPart> parts_of(const Cloud& cloud) {
  std::vector<ScanPart> parts;
  size_t at = 0;
  const auto loose = [&](size_t end) {
    if (end > at) parts.push_back({"points", at, end - at, std::nullopt});
    at = std::max(at, end);
  };
  for (const Station& station : cloud.stations) {
    loose(station.first);
    parts.push_back({station.name.str(), station.first, station.count, std::nullopt});
    if (station.has_pose) parts.back().pose = station.pose;
    at = std::max<size_t>(at, station.first + station.count);
  }
  loose(cloud.size());
  if (parts.empty()) parts.push_back({"points", 0, 0, std::nullopt});
  return parts;
}

class E57FileWriter {
 public:
  E57FileWriter(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
                Task& task)
      : cloud_(cloud), path_(path), settings_(settings), task_(task), file_(path) {}
  ~E57FileWriter() { jc_e57_discard(writing_); }
  E57FileWriter(const E57FileWriter&) = delete;
  E57FileWriter& operator=(const E57FileWriter&) = delete;

  void run() {
    columns_ = columns_of(cloud_, task_);
    const std::vector<ScanPart> parts = parts_of(cloud_);
    call(jc_e57_create({this, read_for_encoder, write_for_encoder}, guid(0).c_str(),
                       valid_utf8(std::string(cloud_.crs)).c_str(), &writing_, message()));
    size_t number = 0;
    for (const ScanPart& part : parts) {
      const auto share = [&](size_t points) {
        return static_cast<double>(points) /
               static_cast<double>(std::max<size_t>(1, cloud_.size()));
      };
      ProgressSpan span(task_, share(part.first), share(part.first + part.count));
      write_scan(part, ++number);
    }
    call(jc_e57_finish(writing_, message()));
    task_.checkpoint(1);  // the last chance to cancel before the old file goes
    file_.commit();
  }

 private:
  JcMessage message() {
    line_[0] = '\0';
    return {line_, sizeof line_};
  }

  void call(int32_t status) {
    if (!has_failed(status)) return;
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
    fail(Status::kInternal, "%.400s: the points cannot be told as E57: %s", path_.c_str(),
         valid_utf8(line_).c_str());
  }

  // Nothing is thrown through the encoder: what happens here is thrown when it has given up.
  template <class F>
  int64_t guarded(F&& work) {
    if (thrown_) return -1;
    try {
      return work();
    } catch (...) {
      thrown_ = std::current_exception();
      return -1;
    }
  }
  static int64_t read_for_encoder(void* self, uint64_t offset, uint8_t* out, uint64_t bytes) {
    auto& writer = *static_cast<E57FileWriter*>(self);
    return writer.guarded(
        [&] { return static_cast<int64_t>(writer.file_.read_back(offset, out, bytes)); });
  }
  static int64_t write_for_encoder(void* self, uint64_t offset, const uint8_t* in, uint64_t bytes) {
    auto& writer = *static_cast<E57FileWriter*>(self);
    return writer.guarded([&] {
      const uint64_t over = offset < writer.size_ ? std::min(bytes, writer.size_ - offset) : 0;
      if (over != 0) writer.file_.rewrite(offset, in, over);
      writer.file_.write(in + over, bytes - over);
      writer.size_ = std::max(writer.size_, offset + bytes);
      return int64_t{0};
    });
  }

  // The same cloud gives the same names, so that files are the same.
  std::string guid(uint64_t number) const {
    uint64_t seed = cloud_.size();
    for (const size_t i : {size_t{0}, cloud_.size() / 2, cloud_.size() - 1})
      if (i < cloud_.size())
        seed = RandomStream(seed, std::bit_cast<uint64_t>(cloud_.point(i).x)).bits();
    RandomStream random(seed, kGuidStream + number);
    constexpr char kDigits[] = "0123456789ABCDEF";
    std::string text = "{xxxxxxxx-xxxx-4xxx-8xxx-xxxxxxxxxxxx}";
    for (char& c : text)
      if (c == 'x') c = kDigits[random.bits() >> 60];
    return text;
  }

  // Coordinates in the scanner's frame, as the standard wants them.
  Vec3 local(const ScanPart& part, const Transform& back, size_t i) const {
    return part.pose ? back.point(cloud_.point(i)) : cloud_.point(i);
  }

  // Doubles, or steps of the scale that the user gave.
  std::vector<JcColumn> coordinates(const ScanPart& part, const Transform& back) {
    std::vector<JcColumn> out;
    for (const char* name : {"cartesianX", "cartesianY", "cartesianZ"})
      out.push_back({name, kJcDouble, 0, 0, 1, 0});
    const double scale = settings_.scale;
    if (scale == 0 || part.count == 0) return out;
    Vec3 low = local(part, back, part.first), high = low;
    for (size_t i = part.first; i < part.first + part.count; ++i) {
      if (i % kRowsAtOnce == 0) task_.checkpoint(0);
      const Vec3 p = local(part, back, i);
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    }
    for (int k = 0; k < 3; ++k) {
      JcColumn& column = out[static_cast<size_t>(k)];
      column.kind = kJcScaled;
      column.scale = scale;
      column.offset = std::floor(low[k] / 2 + high[k] / 2);
      column.min = std::floor((low[k] - column.offset) / scale);
      column.max = std::max(column.min + 1, std::ceil((high[k] - column.offset) / scale));
      if (std::fabs(column.min) > kMostSteps || column.max > kMostSteps)
        fail(Status::kLimit, "%s: coordinates of this size do not fit a scale of so small a step",
             path_.c_str());
    }
    return out;
  }

  void write_scan(const ScanPart& part, uint64_t number) {
    const Transform back = part.pose ? inverse(*part.pose) : Transform{};
    std::vector<JcColumn> columns = coordinates(part, back);
    for (const OutColumn& field : columns_.fields) columns.push_back(field.column);
    double pose[7];
    if (part.pose) {
      const auto& m = part.pose->m;
      Quaternion q = quaternion_of({{m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]}});
      if (q.w < 0) q = {-q.w, -q.x, -q.y, -q.z};  // the standard wants it so
      const Vec3 t = part.pose->translation();
      for (size_t k = 0; const double value : {q.w, q.x, q.y, q.z, t.x, t.y, t.z})
        pose[k++] = value;
    }
    call(jc_e57_begin(writing_, guid(number).c_str(), valid_utf8(part.name).c_str(),
                      part.pose ? pose : nullptr, columns.data(), columns.size(), message()));
    std::vector<double> rows(std::min(kRowsAtOnce, part.count) * columns.size());
    for (size_t done = 0; done < part.count; done += kRowsAtOnce) {
      const size_t count = std::min(kRowsAtOnce, part.count - done);
      ProgressSpan span(task_, static_cast<double>(done) / static_cast<double>(part.count),
                        static_cast<double>(done + count) / static_cast<double>(part.count));
      parallel_for(task_, count, kRowGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i)
          fill_row(part, back, part.first + done + i, rows.data() + i * columns.size());
      });
      call(jc_e57_add(writing_, rows.data(), count, message()));
    }
    call(jc_e57_end(writing_, message()));
  }

  void fill_row(const ScanPart& part, const Transform& back, size_t i, double* row) const {
    const Vec3 p = local(part, back, i);
    for (int k = 0; k < 3; ++k) *row++ = p[k];
    for (const OutColumn& out : columns_.fields) {
      double value = out.field->number(i, out.component);
      if (out.is_normal && part.pose)
        value = back.direction({out.field->number(i, 0), out.field->number(i, 1),
                                out.field->number(i, 2)})[static_cast<int>(out.component)];
      if (out.is_validity) value = std::isnan(value) ? 1 : 0;
      *row++ = value + out.shift;
    }
  }

  const Cloud& cloud_;
  const std::string& path_;
  const WriteSettings& settings_;
  Task& task_;
  AtomicFile file_;
  uint64_t size_ = 0;
  Columns columns_;
  JcE57Writing* writing_ = nullptr;
  char line_[400] = {};
  std::exception_ptr thrown_;
};

}  // namespace

void write_e57(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task) {
  require_codecs(path, "E57");
  ProgressSpan span(task, 0, 0.99, "writing E57");
  E57FileWriter(cloud, path, settings, task).run();
}

}  // namespace jalon
