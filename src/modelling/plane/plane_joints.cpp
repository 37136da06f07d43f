// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/plane_joints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>

#include "geometry/polygon2.h"
#include "modelling/plane/plane_lines.h"
#include "modelling/plane/ring_tools.h"
#include "modelling/plane/vertex_covariance.h"

namespace jalon {

namespace {

constexpr double kSamePoint_m = 1e-9;  // three planes' common point, from two of its lines
constexpr double kLeastCornerSine =
    0.17;                          // 10 degrees: flatter neighbours have no useful intersection
constexpr double kReachOfGap = 2;  // a corner may move so many gaps
constexpr double kChordOfSpacing = 0.1;  // of arcs, where only soundness is asked
// Beside its own line a corner has the rounding of national coordinates at most; no bar is so narrow.
constexpr double kNoWidth_m = 1e-6;

// A line in the plane.
struct Line2 {
  Vec2 p, d;
};

std::optional<Vec2> intersect(const Line2& a, const Line2& b) {
  const double sine = cross(a.d, b.d);
  if (std::fabs(sine) < kLeastCornerSine) return std::nullopt;
  return a.p + a.d * (cross(b.p - a.p, b.d) / sine);
}

Vec2 foot_on(const Line2& line, const Vec2& p) { return line.p + line.d * dot(p - line.p, line.d); }

Line2 in_plane(const PlaneFrame& frame, const PlaneLine& line) {
  return {frame.project(line.p), {dot(line.d, frame.axis_u), dot(line.d, frame.axis_v)}};
}

// A face's outline with its joints in place; fixed corners lie on two lines.
struct Joined {
  VectorFace face;
  std::vector<uint8_t> is_fixed;
};

// 1. Edges go onto their lines; a corner is where its two edges meet.
bool move_edges(const VectorPlane& plane, std::span<const EdgeJoint> joints, Joined& out) {
  const VectorRing before = out.face.outline;
  const size_t n = before.corners.size();
  std::vector<const EdgeJoint*> joint_of(n, nullptr);
  for (const EdgeJoint& joint : joints) joint_of[joint.edge] = &joint;
  const auto line_of = [&](size_t e) {
    if (joint_of[e] != nullptr) return in_plane(plane.frame, joint_of[e]->line);
    const Vec2 d = before.corners[(e + 1) % n] - before.corners[e];
    return Line2{before.corners[e], d * (1 / norm(d))};
  };
  out.is_fixed.assign(n, 0);
  for (size_t i = 0; i < n; ++i) {
    const size_t last = (i + n - 1) % n;
    const EdgeJoint *a = joint_of[last], *b = joint_of[i];
    if (a == nullptr && b == nullptr) continue;
    const double reach_m =
        kReachOfGap * std::max(a != nullptr ? a->reach_m : 0, b != nullptr ? b->reach_m : 0);
    const bool has_arc = before.edges[last].sagitta_m != 0 || before.edges[i].sagitta_m != 0;
    std::optional<Vec2> corner;
    if (!has_arc) corner = intersect(line_of(last), line_of(i));
    if (!corner || norm(*corner - before.corners[i]) > reach_m) {
      if (a != nullptr && b != nullptr) return false;
      corner = foot_on(line_of(a != nullptr ? last : i), before.corners[i]);
    }
    out.face.outline.corners[i] = *corner;
    out.is_fixed[i] = a != nullptr && b != nullptr;
  }
  return true;
}

// Two edges of one outline on the same line, as those of a bar that is narrower than the gap, run back over each other:
// whether they meet is then a matter of rounding.
bool runs_over_itself(const std::vector<Vec2>& outline) {
  const size_t n = outline.size();
  for (size_t i = 0; i < n; ++i)
    for (size_t e = (i + 1) % n; (e + 1) % n != i; e = (e + 1) % n)
      if (segment_distance(outline[i], outline[e], outline[(e + 1) % n]) < kNoWidth_m) return true;
  return false;
}

bool is_still_sound(const VectorFace& face, double chord_error_m) {
  return is_sound(face, chord_error_m) && !runs_over_itself(flattened(face.outline, chord_error_m));
}

// The line lies in this plane exactly; across it, it is as certain as the other plane is.
void tell_source(std::span<const VectorPlane> planes, std::span<const Segment> segments,
                 std::span<const EdgeJoint> joints, VectorRing& outline) {
  for (const EdgeJoint& joint : joints) {
    VectorEdge& edge = outline.edges[joint.edge];
    edge.source = EdgeSource::kPlanes;
    const PlaneFrame& frame = planes[joint.plane].frame;
    const size_t next = (joint.edge + 1) % outline.corners.size();
    const Vec2 middle = (outline.corners[joint.edge] + outline.corners[next]) * 0.5;
    const PlaneFit& fit = segments[joint.other_plane].fit;
    const double sine = norm(cross(frame.normal, fit.plane.normal));
    edge.sigma_m = plane_at(fit.plane, fit.covariance, frame.lift(middle)).sigma_m / sine;
  }
}

using FaceKey = std::pair<size_t, size_t>;                   // plane, face
using PairKey = std::tuple<size_t, size_t, size_t, size_t>;  // and the face it meets
using CornerKey = std::tuple<size_t, size_t, size_t>;        // and corner

// 2. Ends of edges on a common line become one vertex.
class Sharing {
 public:
  Sharing(std::vector<VectorPlane>& planes, std::map<FaceKey, Joined>& joined)
      : planes_(planes), joined_(joined) {}

  void share_ends(const EdgeJoint& a, const EdgeJoint& b) {
    const auto fa = joined_.find({a.plane, a.face}), fb = joined_.find({b.plane, b.face});
    if (fa == joined_.end() || fb == joined_.end()) return;
    const size_t na = fa->second.is_fixed.size(), nb = fb->second.is_fixed.size();
    for (const size_t ca : {a.edge, (a.edge + 1) % na})
      for (const size_t cb : {b.edge, (b.edge + 1) % nb})
        share(a, fa->second, ca, b, fb->second, cb);
  }

  // Vertices of two planes and more, in the order in which they were first met.
  std::vector<SharedCorner> corners() const {
    std::vector<SharedCorner> out;
    for (const auto& [root, members] : members_) {
      if (members.size() < 2) continue;
      SharedCorner corner;
      corner.position = position_.at(root);
      for (const auto& [plane, face, c] : members)
        corner.uses.push_back({plane, joined_.at({plane, face}).face.outline.corners[c]});
      out.push_back(std::move(corner));
    }
    return out;
  }

  // Faces of which two corners became one vertex: their outlines would meet themselves there.
  std::set<FaceKey> pinched() const {
    std::set<FaceKey> out;
    for (const auto& [root, members] : members_) {
      std::set<FaceKey> seen;
      for (const CornerKey& key : members) {
        const FaceKey face{std::get<0>(key), std::get<1>(key)};
        if (!seen.insert(face).second) out.insert(face);
      }
    }
    return out;
  }

 private:
  Vec3 place(const EdgeJoint& joint, const Joined& face, size_t corner) const {
    return planes_[joint.plane].frame.lift(face.face.outline.corners[corner]);
  }

  // What the place of a corner along the line is worth: 1 / variance of the edge that ends there.
  static double weight(const EdgeJoint& joint, const Joined& face, size_t corner) {
    const auto& edges = face.face.outline.edges;
    const size_t crossing =
        corner == joint.edge ? (corner + edges.size() - 1) % edges.size() : corner;
    const double sigma = edges[crossing].sigma_m > 0 ? edges[crossing].sigma_m : joint.reach_m;
    return 1 / (sigma * sigma);
  }

  void share(const EdgeJoint& a, Joined& fa, size_t ca, const EdgeJoint& b, Joined& fb, size_t cb) {
    const Vec3 pa = place(a, fa, ca), pb = place(b, fb, cb);
    const double ta = a.line.at(pa), tb = a.line.at(pb);
    // A corner moves no further than its own plane's gap allows, whatever the spacing of the other one.
    const double reach_m = fa.is_fixed[ca]   ? b.reach_m
                           : fb.is_fixed[cb] ? a.reach_m
                                             : a.reach_m + b.reach_m;
    if (std::fabs(ta - tb) > reach_m) return;
    const CornerKey ka{a.plane, a.face, ca}, kb{b.plane, b.face, cb};
    // A corner on two lines stays; where both do, they must be the same point already: faces are never bent.
    if (fa.is_fixed[ca] && fb.is_fixed[cb] && norm(pa - pb) > kSamePoint_m) return;
    const double wa = weight(a, fa, ca), wb = weight(b, fb, cb);
    const double t = fa.is_fixed[ca] ? ta : fb.is_fixed[cb] ? tb : (wa * ta + wb * tb) / (wa + wb);
    const Vec3 position = a.line.p + a.line.d * t;
    if (!fa.is_fixed[ca]) fa.face.outline.corners[ca] = planes_[a.plane].frame.project(position);
    if (!fb.is_fixed[cb]) fb.face.outline.corners[cb] = planes_[b.plane].frame.project(position);
    fa.is_fixed[ca] = fb.is_fixed[cb] = 1;
    unite(ka, kb, position);
  }

  CornerKey root_of(const CornerKey& key) const {
    const auto found = root_.find(key);
    return found == root_.end() ? key : found->second;
  }
  void unite(const CornerKey& a, const CornerKey& b, const Vec3& position) {
    const CornerKey ra = root_of(a), rb = root_of(b);
    if (members_[ra].empty()) members_[ra] = {ra};
    if (ra == rb) return;
    const std::vector<CornerKey> moved =
        members_.contains(rb) ? members_[rb] : std::vector<CornerKey>{rb};
    members_.erase(rb);
    for (const CornerKey& key : moved) {
      root_[key] = ra;
      members_[ra].push_back(key);
    }
    position_.try_emplace(ra, position);
  }

  std::vector<VectorPlane>& planes_;
  std::map<FaceKey, Joined>& joined_;
  std::map<CornerKey, CornerKey> root_;
  std::map<CornerKey, std::vector<CornerKey>> members_;
  std::map<CornerKey, Vec3> position_;
};

}  // namespace

std::vector<SharedCorner> join_planes(std::vector<VectorPlane>& planes,
                                      std::span<const Segment> segments,
                                      const JointSetting& setting, Task& task) {
  if (!setting.enabled) return {};
  const std::vector<EdgeJoint> joints = find_joints(planes, setting, task);
  // 1. Edges onto their lines, face by face.
  std::map<FaceKey, Joined> joined;
  for (size_t first = 0; first < joints.size();) {
    task.checkpoint(0);
    size_t end = first;
    const FaceKey key{joints[first].plane, joints[first].face};
    while (end < joints.size() && joints[end].plane == key.first && joints[end].face == key.second)
      ++end;
    const VectorPlane& plane = planes[key.first];
    Joined face{plane.faces[key.second], {}};
    const std::span own(joints.data() + first, end - first);
    if (move_edges(plane, own, face) &&
        is_still_sound(face.face, kChordOfSpacing * plane.spacing_m)) {
      tell_source(planes, segments, own, face.face.outline);
      joined.emplace(key, std::move(face));
    }
    first = end;
  }
  // 2. Common ends.
  Sharing sharing(planes, joined);
  std::map<PairKey, std::vector<size_t>> by_pair;
  for (size_t i = 0; i < joints.size(); ++i) {
    task.checkpoint(0);
    const EdgeJoint& a = joints[i];
    for (const size_t j : by_pair[{a.other_plane, a.other_face, a.plane, a.face}])
      sharing.share_ends(a, joints[j]);
    by_pair[{a.plane, a.face, a.other_plane, a.other_face}].push_back(i);
  }
  std::vector<SharedCorner> shared = sharing.corners();
  // 3. What is sound after all that is taken over; vertices of the rest are no longer shared.
  const std::set<FaceKey> pinched = sharing.pinched();
  for (auto& [key, face] : joined) {
    VectorPlane& plane = planes[key.first];
    if (!pinched.contains(key) && is_still_sound(face.face, kChordOfSpacing * plane.spacing_m))
      plane.faces[key.second] = face.face;
  }
  return shared;
}

}  // namespace jalon
