// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/geopackage/plan.h"

#include <algorithm>
#include <cmath>

#include "formats/facade_views.h"
#include "model/chords.h"

namespace jalon::gpkg {

namespace {

constexpr double kShortest_m = 1e-6;  // of a line: below it corners are one

bool is_upright(const Vec3& normal) {
  return squared_norm(normal) > 0 && std::fabs(normal.z) <= kUpright;
}

struct Crossing {
  double along_m;
  Vec3 at;
};

/// Cuts one face.
class Cut {
 public:
  Cut(const Model& model, const Vec3& normal, double level_m)
      : model_(model), level_m_(level_m), along_(normalized(cross({0, 0, 1}, normal))) {}

  // An edge that ends on the level counts at one of its ends alone, so that crossings come in pairs.
  void add(const Ring& ring) {
    for (uint64_t i = 0; i < ring.count; ++i) {
      const Vec3 a = corner(ring, i), b = corner(ring, (i + 1) % ring.count);
      if ((a.z < level_m_) == (b.z < level_m_)) continue;
      const double share = (level_m_ - a.z) / (b.z - a.z);
      Vec3 p = a + (b - a) * share;
      p.z = level_m_;
      crossings_.push_back({dot(p - corner(ring, 0), along_) + offset_m(ring), p});
    }
  }

  void lines(SectionLine like, std::vector<SectionLine>& out) {
    std::ranges::sort(crossings_, {}, &Crossing::along_m);
    for (size_t i = 0; i + 1 < crossings_.size(); i += 2) {
      if (crossings_[i + 1].along_m - crossings_[i].along_m < kShortest_m) continue;
      like.from = crossings_[i].at;
      like.to = crossings_[i + 1].at;
      out.push_back(like);
    }
    crossings_.clear();
  }

 private:
  const Vec3& corner(const Ring& ring, uint64_t i) const {
    return model_.vertices[model_.corners[ring.first + i]];
  }
  // Of the ring's first corner from that of the first ring: map coordinates lose nothing.
  double offset_m(const Ring& ring) {
    if (!has_origin_) origin_ = corner(ring, 0), has_origin_ = true;
    return dot(corner(ring, 0) - origin_, along_);
  }

  const Model& model_;
  double level_m_;
  Vec3 along_, origin_;
  bool has_origin_ = false;
  std::vector<Crossing> crossings_;
};

}  // namespace

double section_level_m(const Model& model, const std::vector<uint32_t>& faces, double height_m) {
  double lowest_m = kNaN;
  for (const uint32_t f : faces) {
    const Face& face = model.faces[f];
    if (face.ring_count == 0 || !is_upright(normal_of(model, face))) continue;
    const Ring& outline = model.rings[face.first_ring];
    for (uint64_t i = 0; i < outline.count; ++i)
      lowest_m = std::fmin(lowest_m, model.vertices[model.corners[outline.first + i]].z);
  }
  return lowest_m + height_m;
}

std::vector<SectionLine> section_of(const Model& model, const std::vector<uint32_t>& faces,
                                    double level_m) {
  std::vector<SectionLine> out;
  for (const uint32_t f : faces) {
    const Face& face = model.faces[f];
    const Vec3 normal = normal_of(model, face);
    if (!is_upright(normal)) continue;
    Cut cut(model, normal, level_m);
    const auto ring = [&](uint64_t r) { return model.rings[face.first_ring + r]; };
    for (uint64_t r = 0; r < face.ring_count; ++r) cut.add(ring(r));
    cut.lines({.face = f, .part = face.part}, out);
    for (uint64_t r = 1; r < face.ring_count; ++r) {
      cut.add(ring(r));
      cut.lines({.face = f, .part = ring(r).part, .is_opening = true}, out);
    }
  }
  return out;
}

}  // namespace jalon::gpkg
