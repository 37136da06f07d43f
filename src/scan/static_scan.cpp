// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"
#include "base/random.h"
#include "scan/scanner.h"
#include "scan/static_settings.h"
#include "spatial/triangle_tree.h"

namespace jalon {

namespace {

constexpr size_t kRayGrain = 16384;               // rays a chunk: about 5 ms
constexpr size_t kMaxStations = size_t{1} << 26;  // (station, ray) is a random stream number of 64 bits
constexpr int kRayBits = 37;
static_assert(kMaxRays < double{size_t{1} << kRayBits});

/// One return, before noise: small, because all of a scan's are kept until their number is known.
struct Return {
  double range;
  uint32_t triangle;
  uint32_t ray;  ///< in its chunk; the top bit marks an outlier
};
constexpr uint32_t kOutlierBit = 1u << 31;

/// Columns of the cloud to be.
struct Output {
  Buffer<double> xyz;
  std::shared_ptr<Column> face, true_xyz, range, incidence;
};

class Scan {
 public:
  Scan(const Model& model, const StaticSettings& settings, const TriangleTree& tree, Task& task)
      : model_(model), settings_(settings), tree_(tree), directions_(settings, task) {}

  /// Returns of a station, chunk by chunk of its rays.
  using Returns = std::vector<std::vector<Return>>;
  Returns cast(const Transform& pose, size_t station, Task& task) const {
    Returns returns((settings_.rays() + kRayGrain - 1) / kRayGrain);
    parallel_for(task, settings_.rays(), kRayGrain, [&](size_t begin, size_t end) {
      std::vector<Return> found;
      for (uint64_t ray = begin; ray < end; ++ray) cast_one(pose, station, ray, begin, found);
      found.shrink_to_fit();
      returns[begin / kRayGrain] = std::move(found);
    });
    return returns;
  }

  void record(const Transform& pose, size_t station, const Returns& returns, size_t first, Output& out,
              Task& task) const {
    std::vector<size_t> start(returns.size());
    for (size_t c = 0; c < returns.size(); ++c) {
      start[c] = first;
      first += returns[c].size();
    }
    parallel_chunks(task, returns.size(), [&](size_t c) {
      for (size_t k = 0; k < returns[c].size(); ++k)
        record_one(pose, station, c * kRayGrain, returns[c][k], start[c] + k, out);
    });
  }

 private:
  /// A pure function of (seed, station, ray): threads may take rays in any order. One stream decides what comes back,
  /// the other is the noise, so that changing the noise changes no other decision.
  RandomStream decisions(size_t station, uint64_t ray) const {
    return {settings_.seed, (station << kRayBits | ray) * 2};
  }
  RandomStream noise(size_t station, uint64_t ray) const {
    return {settings_.seed, (station << kRayBits | ray) * 2 + 1};
  }

  /// A unit vector whatever the last digits of the pose, so that t along it is the range.
  Vec3 direction_of(const Transform& pose, uint64_t ray) const {
    return normalized(pose.direction(directions_.of(ray)));
  }

  void cast_one(const Transform& pose, size_t station, uint64_t ray, uint64_t first,
                std::vector<Return>& found) const {
    RayHit hit;
    // Range limits apply to what is first met: a surface too near shadows those behind it.
    if (!tree_.nearest({pose.translation(), direction_of(pose, ray)}, hit)) return;
    if (!(hit.t >= settings_.min_range && hit.t <= settings_.max_range)) return;
    RandomStream random = decisions(station, ray);
    if (random.uniform() < settings_.dropout) return;
    const uint32_t mark = random.uniform() < settings_.outliers ? kOutlierBit : 0;
    found.push_back({hit.t, hit.triangle, static_cast<uint32_t>(ray - first) | mark});
  }

  void record_one(const Transform& pose, size_t station, uint64_t first_ray, const Return& r, size_t i,
                  Output& out) const {
    const uint64_t ray = first_ray + (r.ray & ~kOutlierBit);
    const bool is_outlier = (r.ray & kOutlierBit) != 0;
    const Vec3 origin = tree_.origin(), from = pose.translation() - origin;
    const Vec3 direction = direction_of(pose, ray);
    RandomStream random = noise(station, ray);
    Vec3 exact, measured;  // relative to the tree's origin
    if (is_outlier) {
      exact = measured = outlier(random, from, direction, r.range);
    } else {
      exact = from + direction * r.range;
      measured = from + disturbed(random, pose, ray, direction, r.range);
    }
    const double range = is_outlier ? norm(exact - from) : r.range;
    store(out.xyz.data() + 3 * i, stepped(measured) + origin + settings_.offset);
    store(out.true_xyz->values<double>().data() + 3 * i, exact + origin + settings_.offset);
    out.face->values<uint32_t>()[i] = is_outlier ? kNoFace : model_.triangle_faces[r.triangle];
    out.range->values<float>()[i] = static_cast<float>(range);
    if (out.incidence)
      out.incidence->values<float>()[i] =
          is_outlier ? std::numeric_limits<float>::quiet_NaN() : incidence(direction, r.triangle);
  }

  /// Measured point as seen from the scanner: errors of the range, then of the two angles, then of the point itself.
  /// The field "range" stays the true one.
  Vec3 disturbed(RandomStream& random, const Transform& pose, uint64_t ray, const Vec3& direction,
                 double true_range) const {
    const StaticSettings& s = settings_;
    const double range = s.range_noise > 0 ? true_range + s.range_noise * random.normal() : true_range;
    Vec3 seen = direction;
    if (s.angle_noise > 0) {
      const double error_h = s.angle_noise * random.normal(), error_v = s.angle_noise * random.normal();
      seen = normalized(pose.direction(directions_.of(ray, error_h, error_v)));
    }
    Vec3 p = seen * range;
    if (s.point_noise > 0)
      for (int a = 0; a < 3; ++a) p[a] += s.point_noise * random.normal();
    return p;
  }

  /// Along the ray in front of the surface (dust, mixed returns), or anywhere in the model's box.
  Vec3 outlier(RandomStream& random, const Vec3& from, const Vec3& direction, double range) const {
    if (!settings_.outliers_in_box)
      return from + direction * (settings_.min_range + (range - settings_.min_range) * random.uniform());
    const Box3& box = tree_.local_bounds();
    Vec3 p;
    for (int a = 0; a < 3; ++a) p[a] = box.min[a] + (box.max[a] - box.min[a]) * random.uniform();
    return p;
  }

  float incidence(const Vec3& direction, uint32_t triangle) const {
    const auto& [a, b, c] = model_.triangles[triangle];
    const Vec3 normal =
        normalized(cross(model_.vertices[b] - model_.vertices[a], model_.vertices[c] - model_.vertices[a]));
    return static_cast<float>(std::acos(std::min(1.0, std::abs(dot(normal, direction)) / norm(direction))));
  }

  /// Relative to the tree's origin, a whole metre.
  Vec3 stepped(Vec3 p) const {
    if (settings_.step_m > 0)
      for (int a = 0; a < 3; ++a) p[a] = std::nearbyint(p[a] / settings_.step_m) * settings_.step_m;
    return p;
  }
  static void store(double* out, const Vec3& p) {
    out[0] = p.x;
    out[1] = p.y;
    out[2] = p.z;
  }

  const Model& model_;
  const StaticSettings& settings_;
  const TriangleTree& tree_;
  Directions directions_;
};

Output make_output(size_t n, bool with_incidence) {
  const auto column = [&](const char* name, ElementType type, uint32_t components, const char* unit,
                          const char* meaning) {
    return std::make_shared<Column>(FieldInfo{name, type, components, unit, meaning}, n);
  };
  Output out;
  out.xyz = Buffer<double>(3 * n);
  out.face = column("face", ElementType::kUint32, 1, "", "id of the face hit; 4294967295 for an outlier");
  out.true_xyz = column("true_xyz", ElementType::kFloat64, 3, "m", "the point without noise");
  out.range = column("range", ElementType::kFloat32, 1, "m", "distance from the scanner, without noise");
  if (with_incidence)
    out.incidence =
        column("incidence_angle", ElementType::kFloat32, 1, "rad", "between the ray and the face's normal");
  return out;
}

}  // namespace

Cloud scan_static(const Model& model, std::span<const ScanStation> stations, const ParamSet& params, Task& task) {
  // 1. What to do, and from where.
  const StaticSettings settings = static_settings(params);
  validate(model);
  std::vector<ScanStation> automatic;
  if (stations.empty()) {
    automatic = automatic_stations(model);
    stations = automatic;
  }
  if (stations.size() > kMaxStations) fail(Status::kLimit, "more than 2^26 stations");
  for (const ScanStation& station : stations) require_rigid(station.pose);

  // 2. The tree of the triangles.
  std::shared_ptr<const TriangleTree> tree;
  {
    const Span span(task, 0, 0.1, "indexing the model");
    tree = TriangleTree::build(model.vertices, model.triangles, task);
  }
  const Scan scan(model, settings, *tree, task);

  // 3. All rays: what they meet, without noise.
  std::vector<Scan::Returns> returns(stations.size());
  std::vector<size_t> first(stations.size() + 1, 0);
  for (size_t s = 0; s < stations.size(); ++s) {
    const double n = static_cast<double>(stations.size()), part = static_cast<double>(s);
    const Span span(task, 0.1 + 0.7 * part / n, 0.1 + 0.7 * (part + 1) / n, "scanning");
    if (tree->size() > 0) returns[s] = scan.cast(stations[s].pose, s, task);
    first[s + 1] = first[s];
    for (const auto& chunk : returns[s]) first[s + 1] += chunk.size();
  }

  // 4. Points with noise and truth.
  Output out = make_output(first.back(), settings.with_incidence);
  for (size_t s = 0; s < stations.size(); ++s) {
    const double n = static_cast<double>(stations.size()), part = static_cast<double>(s);
    const Span span(task, 0.8 + 0.2 * part / n, 0.8 + 0.2 * (part + 1) / n, "recording points");
    scan.record(stations[s].pose, s, returns[s], first[s], out, task);
    returns[s] = {};
  }

  // 5. The cloud.
  Cloud cloud;
  cloud.xyz_buffer = std::make_shared<const Buffer<double>>(std::move(out.xyz));
  cloud.fields.set(out.face);
  cloud.fields.set(out.true_xyz);
  cloud.fields.set(out.range);
  if (out.incidence) cloud.fields.set(out.incidence);
  for (size_t s = 0; s < stations.size(); ++s) {
    Station station{stations[s].name, true, stations[s].pose, first[s], first[s + 1] - first[s]};
    if (station.name.empty()) station.name = "station " + std::to_string(s + 1);
    for (int a = 0; a < 3; ++a) station.pose.m[static_cast<size_t>(4 * a + 3)] += settings.offset[a];
    cloud.stations.push_back(station);
  }
  return cloud;
}

}  // namespace jalon
