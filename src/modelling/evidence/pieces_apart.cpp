// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/pieces_apart.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "modelling/evidence/places.h"
#include "modelling/evidence/plane_roles.h"
#include "modelling/evidence/recesses.h"
#include "modelling/plane/coplanar.h"
#include "segment/labels/label_groups.h"

namespace jalon {

namespace {

constexpr double kPiecesSameWay = 0.985;  // cosine of 10 degrees
constexpr size_t kPiecePoints = 400;      // looked at, of a piece
constexpr double kBesidePiece_m = 0.5;    // what a surround, a sill, a quoin touches lies this near
constexpr double kReliefPieceShare = 0.6;  // of its points, before the wall and beside it
constexpr double kTouchingShare = 0.5;     // of its points, beside other pieces
constexpr double kEnclosing_m = 0.25;      // measured wall on a side of what it encloses: a pier
constexpr double kMixedShare = 0.1;  // of a segment's points: it is a wall and a larger one's panes
constexpr int kMostRounds = 3;       // a piece that comes apart may have hidden what another one is

// A house that stands forward passes for relief of the next one where pieces of that lie in its windows.
bool is_outer(PlaneRole role) { return role == PlaneRole::kWall || role == PlaneRole::kRelief; }

// Of as many points of a piece as are looked at.
template <class F>
double share_of(std::span<const uint32_t> points, F&& holds) {
  const size_t step = std::max<size_t>(1, points.size() / kPiecePoints);
  size_t looked = 0, held = 0;
  for (size_t i = step / 2; i < points.size(); i += step, ++looked) held += holds(points[i]);
  return looked > 0 ? static_cast<double>(held) / static_cast<double>(looked) : 0;
}

// Whether windows lie within what a piece reaches over: panes and leaves have none, wings have.
bool has_windows(const Cloud& cloud, std::span<const uint32_t> points, const WallEvidence& whole) {
  const size_t step = std::max<size_t>(1, points.size() / kPiecePoints);
  RingBox reach;
  for (size_t i = step / 2; i < points.size(); i += step)
    reach.add(whole.cells.frame.project(cloud.point(points[i])));
  return std::any_of(whole.openings.begin(), whole.openings.end(), [&](const auto& opening) {
    return opening.is_opening && is_framed(opening) && reach.holds(opening.shape.box().middle());
  });
}

bool looks_as(const WallEvidence& wall, const WallEvidence& whole) {
  return dot(wall.cells.frame.normal, whole.cells.frame.normal) >= kPiecesSameWay;
}

// What lies in panes' plane may outvote which way that looks where no station tells; the larger wall's way holds.
bool is_turned_from(const WallEvidence& wall, const WallEvidence& whole) {
  return dot(wall.cells.frame.normal, whole.cells.frame.normal) <= -kPiecesSameWay &&
         explained_m2(wall) > explained_m2(whole);
}

// Whether a place behind a wall has measured wall to its left, to its right and above it: it is seen through that wall,
// and what goes on beside it would lie behind what was measured.
bool is_enclosed_at(const WallCells& cells, const Vec3& p) {
  const Foot foot(cells, p);
  if (!foot.is_on_map || foot.depth_m <= cells.on_m / 2 || foot.depth_m > kFillingDepth_m)
    return false;
  const auto is_met = [&](int64_t right, int64_t up) {
    uint32_t met = 0;
    for (int64_t c = foot.column, r = foot.row;
         c >= 0 && r >= 0 && c < cells.columns && r < cells.rows; c += right, r += up)
      met += cells.at(static_cast<uint32_t>(c), static_cast<uint32_t>(r)) == WallState::kOn;
    return met * cells.cell_m >= kEnclosing_m;
  };
  return is_met(-1, 0) && is_met(1, 0) && is_met(0, 1);
}

enum class Enclosure : uint8_t {
  kNone,
  kBehind,   // by a wall's measured parts: seen through it, whatever opening that has there
  kOpening,  // by the frame of an opening
};

// What encloses most of a piece's points, of walls that explain more than the piece does.
Enclosure enclosure_of(const Cloud& cloud, std::span<const uint32_t> points, double explained,
                       const WallEvidence& whole, const std::vector<WallEvidence>& evidence) {
  std::vector<const WallEvidence*> walls;
  for (const WallEvidence& wall : evidence)
    if (&wall != &whole && !wall.empty() && is_outer(wall.role) && explained_m2(wall) > explained &&
        (looks_as(wall, whole) || is_turned_from(wall, whole)))
      walls.push_back(&wall);
  if (walls.empty()) return Enclosure::kNone;
  // Cornices and surrounds enclose wings as posts enclose panes.
  const bool by_border = !has_windows(cloud, points, whole);
  const auto is_mostly = [&](auto&& holds) {
    return share_of(points, [&](uint32_t i) {
             return std::any_of(walls.begin(), walls.end(),
                                [&](const auto* wall) { return holds(*wall, cloud.point(i)); });
           }) >= kFillingShare;
  };
  if (is_mostly([&](const WallEvidence& wall, const Vec3& p) {
        return is_filling_at(wall, p, by_border);
      }))
    return Enclosure::kOpening;
  return is_mostly(
             [](const WallEvidence& wall, const Vec3& p) { return is_enclosed_at(wall.cells, p); })
             ? Enclosure::kBehind
             : Enclosure::kNone;
}

// Whether a place of a wall fills an opening that a larger one frames.
class LargerWalls {
 public:
  LargerWalls(const WallEvidence& whole, const std::vector<WallEvidence>& evidence) {
    for (const WallEvidence& wall : evidence)
      if (&wall != &whole && wall.is_wall() && looks_as(wall, whole) &&
          explained_m2(wall) > explained_m2(whole))
        walls_.push_back(&wall);
  }
  bool have_filling_at(const Vec3& p) const {
    return std::any_of(walls_.begin(), walls_.end(),
                       [&](const WallEvidence* wall) { return is_filling_at(*wall, p, false); });
  }

 private:
  std::vector<const WallEvidence*> walls_;
};

// A segment less some of its points, and these as the last one: both on its plane.
void part_segment(std::span<const uint32_t> leaving, std::span<uint32_t> labels, size_t s,
                  Segmentation& out) {
  Segment &rest = out.segments[s], part = rest;
  const double share =
      static_cast<double>(leaving.size()) / static_cast<double>(rest.point_count());
  part.label = static_cast<uint32_t>(out.segments.size() + 1);
  part.fit.n = leaving.size();
  part.area_m2 *= share;
  rest.fit.n -= leaving.size();
  rest.area_m2 *= 1 - share;
  for (const uint32_t i : leaving) labels[i] = part.label;
  out.segments.push_back(part);
}

// Where a segmentation joined panes to a wall that stands back as deep as they do (the fronts of dormers over the
// eaves), as a jitter of its points decides: such segments in two.
Segmentation parted_segments(const Segmentation& given, const std::vector<uint32_t>& whole,
                             const std::vector<WallEvidence>& evidence, Task& task) {
  const auto before = given.labels->values<uint32_t>();
  const LabelGroups groups(before, given.segments.size(), task);
  Segmentation out = given;
  std::shared_ptr<Column> labels;
  for (size_t s = 0; s < given.segments.size(); ++s) {
    const WallEvidence& own = evidence[whole[s] - 1];
    if (!own.is_wall()) continue;
    task.checkpoint(0);
    const auto points = groups.of(given.segments[s].label);
    const LargerWalls larger(own, evidence);
    const auto fills = [&](uint32_t i) { return larger.have_filling_at(given.cloud->point(i)); };
    const double share = share_of(points, fills);
    if (share < kMixedShare || share >= kFillingShare) continue;
    std::vector<uint32_t> leaving;
    std::copy_if(points.begin(), points.end(), std::back_inserter(leaving), fills);
    if (leaving.empty() || leaving.size() == points.size()) continue;
    if (labels == nullptr) {
      labels = std::make_shared<Column>(given.labels->info(), before.size());
      std::copy(before.begin(), before.end(), labels->values<uint32_t>().begin());
    }
    part_segment(leaving, labels->values<uint32_t>(), s, out);
  }
  if (labels != nullptr) out.labels = std::move(labels);
  return out;
}

// Whether the wall was measured this near to a place before or behind it.
bool is_measured_near(const WallCells& cells, const Vec2& at) {
  const auto line = [&](double from, double origin, uint32_t most) {
    return static_cast<uint32_t>(
        std::clamp((from - origin) / cells.cell_m, 0.0, static_cast<double>(most)));
  };
  const uint32_t c0 = line(at.u - kBesidePiece_m, cells.origin.u, cells.columns),
                 c1 = line(at.u + kBesidePiece_m, cells.origin.u, cells.columns),
                 r0 = line(at.v - kBesidePiece_m, cells.origin.v, cells.rows),
                 r1 = line(at.v + kBesidePiece_m, cells.origin.v, cells.rows);
  for (uint32_t r = r0; r < r1; ++r)
    for (uint32_t c = c0; c < c1; ++c)
      if (cells.at(c, r) == WallState::kOn) return true;
  return false;
}

// Whether a piece lies a hand's breadth before a wall, most of it beside what was measured of that.
bool is_relief_on(const Cloud& cloud, std::span<const uint32_t> points, const WallEvidence& wall,
                  double relief_m) {
  const PlaneFrame& frame = wall.cells.frame;
  const double least = wall.cells.on_m / 2;
  return share_of(points, [&](uint32_t i) {
           const Vec3 p = cloud.point(i);
           const double out = dot(p - frame.origin, frame.normal) - frame.height;
           return out > least && out <= relief_m && is_measured_near(wall.cells, frame.project(p));
         }) >= kReliefPieceShare;
}

// Where pieces of a wall were measured, coarsely: by squares of half of what touches.
class Ground {
 public:
  explicit Ground(const WallCells& cells)
      : cells_(cells),
        columns_(count(cells.columns)),
        rows_(count(cells.rows)),
        has_(columns_ * rows_, 0) {}
  void add(const Vec2& p) {
    if (const auto at = square_of(p)) has_[at->second * columns_ + at->first] = 1;
  }
  bool is_near(const Vec2& p) const {
    const auto at = square_of(p);
    if (!at) return false;
    const size_t c1 = std::min(columns_, at->first + kReach + 1),
                 r1 = std::min(rows_, at->second + kReach + 1);
    for (size_t r = at->second - std::min(at->second, kReach); r < r1; ++r)
      for (size_t c = at->first - std::min(at->first, kReach); c < c1; ++c)
        if (has_[r * columns_ + c] != 0) return true;
    return false;
  }

 private:
  static constexpr size_t kReach = 2;  // squares
  static constexpr double kSquare_m = kBesidePiece_m / kReach;
  size_t count(uint32_t n) const { return static_cast<size_t>(n * cells_.cell_m / kSquare_m) + 1; }
  std::optional<std::pair<size_t, size_t>> square_of(const Vec2& p) const {
    const double u = (p.u - cells_.origin.u) / kSquare_m, v = (p.v - cells_.origin.v) / kSquare_m;
    if (!(u >= 0 && v >= 0)) return {};
    const std::pair at{static_cast<size_t>(u), static_cast<size_t>(v)};
    if (at.first >= columns_ || at.second >= rows_) return {};
    return at;
  }

  const WallCells& cells_;
  size_t columns_, rows_;
  std::vector<uint8_t> has_;
};

// Two explanations of a piece that lies in the plane of a house and before the one next door: what it touches tells.
// By index of the pieces: those that stand on another wall, apart from all pieces that do not.
std::vector<uint8_t> relief_pieces(const Segmentation& given, const LabelGroups& groups,
                                   std::span<const size_t> pieces, const WallEvidence& whole,
                                   const std::vector<WallEvidence>& evidence, double relief_m,
                                   Task& task) {
  const Cloud& cloud = *given.cloud;
  const auto points_of = [&](size_t k) { return groups.of(given.segments[pieces[k]].label); };
  std::vector<uint8_t> is_relief(pieces.size(), 0);
  for (size_t k = 0; k < pieces.size(); ++k) {
    task.checkpoint(0);
    is_relief[k] = std::any_of(evidence.begin(), evidence.end(), [&](const WallEvidence& wall) {
      return &wall != &whole && wall.is_wall() &&
             dot(wall.cells.frame.normal, whole.cells.frame.normal) >= kPiecesSameWay &&
             is_relief_on(cloud, points_of(k), wall, relief_m);
    });
  }
  // Beside a pier that is no relief itself a piece is of that wall.
  Ground ground(whole.cells);
  const auto add = [&](size_t k) {
    for (const uint32_t i : points_of(k)) ground.add(whole.cells.frame.project(cloud.point(i)));
  };
  for (size_t k = 0; k < pieces.size(); ++k)
    if (is_relief[k] == 0) add(k);
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (size_t k = 0; k < pieces.size(); ++k) {
      task.checkpoint(0);
      if (is_relief[k] == 0 || share_of(points_of(k), [&](uint32_t i) {
                                 return ground.is_near(whole.cells.frame.project(cloud.point(i)));
                               }) < kTouchingShare)
        continue;
      is_relief[k] = 0;
      is_changed = true;
      add(k);
    }
  }
  return is_relief;
}

// The pieces become those of their largest.
void join_to_largest(const std::vector<Segment>& segments, std::span<const size_t> pieces,
                     std::vector<uint32_t>& whole) {
  const size_t largest = *std::max_element(pieces.begin(), pieces.end(), [&](size_t a, size_t b) {
    return segments[a].point_count() < segments[b].point_count();
  });
  for (const size_t piece : pieces) whole[piece] = segments[largest].label;
}

}  // namespace

std::vector<uint32_t> pieces_apart(const Segmentation& given, const std::vector<uint32_t>& whole,
                                   const std::vector<WallEvidence>& evidence, double relief_m,
                                   Task& task) {
  const LabelGroups groups(given.labels->values<uint32_t>(), given.segments.size(), task);
  std::vector<std::vector<size_t>> pieces(given.segments.size());
  for (size_t s = 0; s < whole.size(); ++s) pieces[whole[s] - 1].push_back(s);
  std::vector<uint32_t> out = whole;
  for (size_t w = 0; w < pieces.size(); ++w) {
    if (pieces[w].size() < 2 || evidence[w].empty()) continue;
    std::vector<size_t> fillings, reliefs, others;
    const std::vector<uint8_t> is_relief =
        relief_pieces(given, groups, pieces[w], evidence[w], evidence, relief_m, task);
    for (size_t k = 0; k < pieces[w].size(); ++k) {
      const size_t s = pieces[w][k];
      task.checkpoint(0);
      const Enclosure enclosure = enclosure_of(*given.cloud, groups.of(given.segments[s].label),
                                               given.segments[s].area_m2, evidence[w], evidence);
      if (enclosure == Enclosure::kBehind) out[s] = given.segments[s].label;
      else
        (enclosure == Enclosure::kOpening ? fillings
         : is_relief[k] != 0              ? reliefs
                                          : others)
            .push_back(s);
    }
    for (const auto* group : {&fillings, &reliefs, &others})
      if (!group->empty()) join_to_largest(given.segments, *group, out);
  }
  return out;
}

std::vector<WallEvidence> gather_whole_walls(Segmentation& segmentation, double tolerance_m,
                                             const EvidenceSetting& setting, Task& task) {
  Segmentation given = segmentation;
  std::vector<uint32_t> whole;
  std::vector<WallEvidence> out;
  const auto look = [&] {
    whole = whole_walls(given, tolerance_m, task);
    segmentation = joined_pieces(given, whole, task);
    out = gather_evidence(segmentation, setting, task);
  };
  look();
  if (const std::vector<size_t> turned = turned_away(segmentation, out, task); !turned.empty()) {
    for (const size_t s : turned)
      for (size_t piece = 0; piece < whole.size(); ++piece)
        if (whole[piece] == whole[s]) turn_over(given.segments[piece].fit);
    look();
  }
  Segmentation parted = parted_segments(given, whole, out, task);
  if (parted.segments.size() > given.segments.size()) {
    given = std::move(parted);
    look();
  }
  for (int round = 0; round < kMostRounds; ++round) {
    const std::vector<uint32_t> apart =
        pieces_apart(given, whole, out, setting.cells.relief_m, task);
    if (apart == whole) break;
    std::vector<size_t> changed;
    for (size_t s = 0; s < whole.size(); ++s)
      if (apart[s] != whole[s])
        changed.push_back(s), changed.push_back(whole[s] - 1), changed.push_back(apart[s] - 1);
    // Surrounds that have come apart are no longer part of a wall: openings are settled again.
    for (size_t s = 0; s < out.size(); ++s)
      if (std::any_of(out[s].openings.begin(), out[s].openings.end(),
                      [](const OpeningCandidate& opening) { return opening.is_settled; }))
        changed.push_back(s);
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    whole = apart;
    segmentation = joined_pieces(given, whole, task);
    look_at_planes(segmentation, changed, setting, out, task);
    tell_planes(segmentation, setting, out, task);
  }
  end_behind_walls(out, setting.cells.relief_m, task);
  return out;
}

}  // namespace jalon
