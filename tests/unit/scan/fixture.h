// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "scan/scanner.h"
#include "scan/scene.h"

namespace jalon::test {

struct Options {
  std::vector<std::pair<const char*, double>> numbers;
  std::vector<std::pair<const char*, const char*>> texts;
};

inline ParamSet filled(const char* owner, std::span<const ParamRow> rows, const Options& options) {
  ParamSet params(owner, rows);
  for (const auto& [name, value] : options.numbers) params.set_number(name, value);
  for (const auto& [name, value] : options.texts) params.set_text(name, value);
  return params;
}

inline Model scene(const char* name, std::vector<std::pair<const char*, double>> numbers = {}) {
  Task task;
  const ParamSet params = filled("scene", scene_rows(), {std::move(numbers), {{"name", name}}});
  return build_scene(settings_from<SceneSettings>(params), task);
}

/// Steps of half a degree unless told otherwise, no noise.
inline StaticSettings quiet_settings(double step_rad = 0.01, StaticSettings settings = {}) {
  settings.horizontal_step_rad = settings.vertical_step_rad = step_rad;
  settings.range_noise_m = settings.angle_noise_rad = 0;
  return settings;
}

inline Cloud scanned(const Model& model, const StaticSettings& settings,
                     std::span<const ScanStation> stations = {}, unsigned threads = 0) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return scan_static(model, stations, settings, task);
}

inline ScanStation station_at(const Vec3& p) {
  ScanStation station;
  station.pose.m[3] = p.x;
  station.pose.m[7] = p.y;
  station.pose.m[11] = p.z;
  return station;
}

inline Cloud sampled(const Model& model, const SampleSettings& settings = {},
                     unsigned threads = 0) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return scan_sample(model, {}, settings, task);
}

inline bool same_bits(std::span<const double> a, std::span<const double> b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

inline bool same_clouds(const Cloud& a, const Cloud& b) {
  if (a.size() != b.size() || a.fields.size() != b.fields.size() || !same_bits(a.xyz(), b.xyz()))
    return false;
  for (const ColumnPtr& column : a.fields) {
    const Column& other = b.fields.require(column->info().name);
    if (column->bytes() != other.bytes() ||
        std::memcmp(column->raw(), other.raw(), other.bytes()) != 0)
      return false;
  }
  return true;
}

/// Share k of n draws of probability p, within five standard deviations.
inline bool is_binomial(size_t k, size_t n, double p) {
  const double expected = p * static_cast<double>(n);
  return std::abs(static_cast<double>(k) - expected) <= 5 * std::sqrt(expected * (1 - p)) + 1e-9;
}

/// Squares of n standard normal draws add up to n, within four standard deviations.
inline bool is_chi_squared(double squares, double n) {
  return std::abs(squares - n) < 4 * std::sqrt(2 * n);
}

template <class T>
std::span<const T> values(const Cloud& cloud, const char* name) {
  return cloud.fields.require(name).values<T>();
}

inline Vec3 true_point(const Cloud& cloud, size_t i) {
  const auto xyz = values<double>(cloud, "true_xyz");
  return {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
}

/// Faces of each id: several where panes share one.
inline std::map<uint32_t, std::vector<const Face*>> faces_by_id(const Model& model) {
  std::map<uint32_t, std::vector<const Face*>> out;
  for (const Face& face : model.faces) out[face.id].push_back(&face);
  return out;
}

/// Corners of a ring in the face's own plane.
inline std::vector<Vec2> flat_ring(const Model& model, const Face& face, size_t ring) {
  const Vec3 n = face.plane.normal;
  const Vec3 u = normalized(std::abs(n.z) < 0.9 ? cross(Vec3{0, 0, 1}, n)
                                                : cross(Vec3{0, 1, 0}, n)),
             v = cross(n, u);
  const Ring& r = model.rings[face.first_ring + ring];
  std::vector<Vec2> out;
  for (uint64_t k = r.first; k < r.first + r.count; ++k) {
    const Vec3& p = model.vertices[model.corners[k]];
    out.push_back({dot(p, u), dot(p, v)});
  }
  return out;
}

inline Vec2 flat_point(const Face& face, const Vec3& p) {
  const Vec3 n = face.plane.normal;
  const Vec3 u = normalized(std::abs(n.z) < 0.9 ? cross(Vec3{0, 0, 1}, n)
                                                : cross(Vec3{0, 1, 0}, n)),
             v = cross(n, u);
  return {dot(p, u), dot(p, v)};
}

inline double signed_area(const std::vector<Vec2>& ring) {
  double twice = 0;
  for (size_t i = 0; i < ring.size(); ++i) twice += cross(ring[i], ring[(i + 1) % ring.size()]);
  return twice / 2;
}

/// Even-odd over all rings; points within tolerance of an edge count as inside.
inline bool is_inside(const Model& model, const Face& face, const Vec3& p, double tolerance) {
  const Vec2 q = flat_point(face, p);
  bool inside = false;
  for (size_t r = 0; r < face.ring_count; ++r) {
    const auto ring = flat_ring(model, face, r);
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()], d = b - a;
      const double t = std::clamp(dot(q - a, d) / dot(d, d), 0.0, 1.0);
      if (norm(q - a - d * t) <= tolerance) return true;
      if ((a.v > q.v) != (b.v > q.v) && q.u < a.u + (q.v - a.v) / (b.v - a.v) * (b.u - a.u))
        inside = !inside;
    }
  }
  return inside;
}

}  // namespace jalon::test
