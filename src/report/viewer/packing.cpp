// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/viewer/packing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "formats/files/zlib_stream.h"

namespace jalon {

namespace {

constexpr double kFinestStep_m = 0.001, kMostSteps = 65535;
constexpr double kStepsOfScale = 256;  // a value is told to half of one; the scale has 64 colours
constexpr double kMostValue = 32765;   // of 16 bits with a sign, beside the codes of none
constexpr size_t kGaps = 20000;        // between points, looked at
constexpr size_t kPackGrain = size_t{1} << 16;

// Sorted positions at even distances.
std::vector<uint32_t> chosen_points(const Octree& tree, size_t most) {
  const size_t n = tree.size(), kept = std::min(n, most);
  std::vector<uint32_t> out(kept);
  for (size_t i = 0; i < kept; ++i) out[i] = tree.order()[static_cast<uint64_t>(i) * n / kept];
  return out;
}

/// Planes of bytes of numbers of 16 or 8 bits.
class Planes {
 public:
  explicit Planes(size_t points) : points_(points) {}

  /// value(i): of point i, as the low bits of what it gives.
  template <class F>
  void add(size_t bytes, Task& task, F&& value, bool is_plain = false) {
    const size_t at = out_.size();
    out_.resize(at + bytes * points_);
    parallel_for(task, points_, kPackGrain, [&](size_t begin, size_t end) {
      uint32_t before = begin == 0 || is_plain ? 0 : static_cast<uint32_t>(value(begin - 1));
      for (size_t i = begin; i < end; ++i) {
        const auto now = static_cast<uint32_t>(value(i));
        const uint32_t z =
            bytes == 2 ? zigzag<int16_t>(now - before) : zigzag<int8_t>(now - before);
        before = is_plain ? 0 : now;
        out_[at + i] = static_cast<char>(z & 0xff);
        if (bytes == 2) out_[at + points_ + i] = static_cast<char>(z >> 8 & 0xff);
      }
    });
  }
  const std::string& bytes() const { return out_; }

 private:
  template <class T>
  static uint32_t zigzag(uint32_t difference) {
    const auto d = static_cast<int32_t>(static_cast<T>(difference));
    return static_cast<uint32_t>(d) << 1 ^ static_cast<uint32_t>(d >> 31);
  }
  size_t points_;
  std::string out_;
};

int32_t code_of(const ViewChannel& channel, double step, double value) {
  if (std::isnan(value)) return kViewNone;
  if (value == -std::numeric_limits<double>::infinity())
    return kViewNone + (channel.none.size() > 1 ? 1 : 0);
  return static_cast<int32_t>(std::lround(std::clamp(value / step, -kMostValue, kMostValue)));
}

// The middle one of the distances of points that follow each other: about that of neighbours.
double spacing_of(const Cloud& cloud, const std::vector<uint32_t>& points) {
  const size_t stride = points.size() / kGaps + 1;
  std::vector<double> apart;
  for (size_t i = 1; i < points.size(); i += stride)
    apart.push_back(norm(cloud.point(points[i]) - cloud.point(points[i - 1])));
  if (apart.empty()) return 0.01;
  const auto middle = apart.begin() + static_cast<std::ptrdiff_t>(apart.size() / 2);
  std::nth_element(apart.begin(), middle, apart.end());
  return std::max(*middle, 1e-4);
}

// Whether neighbours tell less of a value than nothing does: of noise they do.
bool is_noise(const ViewChannel& channel, const std::vector<uint32_t>& points) {
  double sizes = 0, differences = 0;
  const size_t stride = points.size() / kGaps + 1;
  for (size_t i = 1; i < points.size(); i += stride) {
    const double a = channel.value(points[i - 1]), b = channel.value(points[i]);
    if (!std::isfinite(a) || !std::isfinite(b)) continue;
    sizes += std::fabs(b);
    differences += std::fabs(b - a);
  }
  return sizes < differences;
}

void add_channel(Planes& planes, const ViewChannel& channel, double step, bool is_plain,
                 const std::vector<uint32_t>& points, Task& task) {
  const auto& value = channel.value;
  if (channel.kind == ViewChannel::Kind::kColour) {
    for (const uint32_t shift : {16u, 8u, 0u})
      planes.add(1, task,
                 [&](size_t i) { return static_cast<uint32_t>(value(points[i])) >> shift & 0xff; });
  } else if (channel.kind == ViewChannel::Kind::kLabel) {
    planes.add(2, task, [&](size_t i) { return std::min(value(points[i]), kMostSteps); });
  } else {
    planes.add(
        2, task, [&](size_t i) { return code_of(channel, step, value(points[i])); }, is_plain);
  }
}

}  // namespace

std::string text_of_bytes(std::string_view bytes) {
  // The 85 characters from "$" to "y" without "<".
  constexpr char kFirst = '$', kTag = '<';
  std::string out;
  out.reserve((bytes.size() + 3) / 4 * 5);
  for (size_t at = 0; at < bytes.size(); at += 4) {
    uint32_t word = 0;
    for (size_t k = 0; k < 4; ++k)
      word = word << 8 | (at + k < bytes.size() ? static_cast<unsigned char>(bytes[at + k]) : 0u);
    char digits[5];
    for (size_t k = 5; k-- > 0; word /= 85) {
      const auto c = static_cast<char>(kFirst + word % 85);
      digits[k] = static_cast<char>(c < kTag ? c : c + 1);
    }
    out.append(digits, 5);
  }
  return out;
}

PackedCloud pack_cloud(const ViewCloud& view, size_t most_points, Task& task) {
  const Cloud& cloud = *view.cloud;
  PackedCloud out;
  std::vector<uint32_t> points;
  if (cloud.size() != 0) points = chosen_points(*cloud.octree(task), most_points);
  out.points = points.size();
  Vec3 low, high;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec3 p = cloud.point(points[i]);
    if (i == 0) low = high = p;
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  out.low = low;
  out.size = high - low;
  out.step_m = std::max(kFinestStep_m, std::max({out.size.x, out.size.y, out.size.z}) / kMostSteps);
  out.spacing_m = spacing_of(cloud, points);
  Planes planes(points.size());
  for (int k = 0; k < 3; ++k)
    planes.add(2, task, [&](size_t i) {
      return std::lround((cloud.point(points[i])[k] - low[k]) / out.step_m);
    });
  for (const ViewChannel& channel : view.channels) {
    const double step = (channel.high - channel.low) / kStepsOfScale;
    out.channel_steps.push_back(step);
    const bool is_plain = channel.kind == ViewChannel::Kind::kScale && is_noise(channel, points);
    out.channel_is_plain.push_back(is_plain);
    add_channel(planes, channel, step, is_plain, points, task);
  }
  out.bytes = zlib_stream(planes.bytes(), Redundancy::kRuns, task);
  return out;
}

}  // namespace jalon
