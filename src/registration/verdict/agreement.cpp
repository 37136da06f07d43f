// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/agreement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "geometry/nearest_axis.h"

namespace jalon {

namespace {

constexpr uint32_t kNeighbours = 6;  // near an edge some lie on the face around the corner
constexpr double kNear = 4;          // reaches: as far as a surface is followed beyond its points
constexpr double kBeside = 1.5;      // reaches sideways that a plane still holds for
constexpr double kLevel = 0.5;   // reaches of height at which it may just go on beside its points
constexpr double kFacing = 0.8;  // cosine of faces that are one
constexpr double kHeightNoises = 4;   // of both clouds, that a surfel may be above a surface
constexpr double kMisfits = 2;        // of the clouds at the pose: 19 of 20 residuals are within
constexpr double kMostMisfit = 0.25;  // reaches: a wrong pose does not excuse itself
constexpr double kUneven = 0.05;      // reaches, for surfaces that bend between the points
constexpr double kPiercedIncidence =
    0.25;  // cosine: flatter views may miss a narrow face, and see past it
constexpr double kLeastIncidence = 0.1;   // cosine: flatter views measure little
constexpr double kBehindIncidence = 0.2;  // ... that tell the sides of a surface apart
constexpr double kSightNoises = 5;
constexpr size_t kAbout = 9;       // surfels about one and itself; of a thing most ...
constexpr size_t kMostOfThem = 6;  // ... are contradicted, of an edge fewer
constexpr size_t kPrior =
    20;  // surfels of a direction that speak for the pose before any is looked at
constexpr size_t kGrain = 256;

enum class Said : uint8_t { kNothing, kExplained, kUnexplained, kPierced };

struct Answer {
  Said said = Said::kNothing;
  bool is_near = false, is_seen = false;
};

class Holding {
 public:
  Holding(const JudgedCloud& of, const JudgedCloud& with, const Transform& T_with_of)
      : of_(of),
        with_(with),
        T_with_of_(T_with_of),
        reach_m_(reach_of(of, with)),
        noise_m_(std::hypot(of.surface->noise_m, with.surface->noise_m)),
        height_m_(std::max(kHeightNoises * noise_m_,
                           kMisfits * std::min(of.misfit_m, kMostMisfit * reach_m_))) {}

  Answer ask(const Surfel& surfel) const {
    const Vec3 place = T_with_of_.point(surfel.place), normal = T_with_of_.direction(surfel.normal);
    const Sides sides = sides_of(surfel, place, normal);
    Answer out;
    out.is_seen = sides.seen == Sighted::kSurface || sides.seen == Sighted::kThrough;
    // Where the points lie farther apart than usual a surface is known as far between them.
    const double reach_m = std::max(reach_m_, surfel.radius_m);
    const Said near = ask_neighbours(place, normal, reach_m, out.is_near);
    if (sides.seen == Sighted::kThrough) out.said = Said::kPierced;
    // From the other side of the surface: a wall has two faces, and both clouds cannot have seen this one.
    else if (sides.is_behind && near == Said::kExplained) out.said = Said::kUnexplained;
    else if (sides.is_visible) out.said = near;
    return out;
  }

 private:
  struct Sides {
    Sighted seen = Sighted::kUnknown;
    bool is_visible =
        true;  ///< the other cloud could have seen the surfel: from its side and not too flat
    bool is_behind = false;  ///< ... only from its back
  };

  Sides sides_of(const Surfel& surfel, const Vec3& place, const Vec3& normal) const {
    Sides out;
    if (with_.sights.empty()) return out;
    double own = 0;
    if (surfel.sight >= 0)
      own = cosine(surfel.place - of_.sights[static_cast<size_t>(surfel.sight)].station(),
                   surfel.normal);
    out.is_visible = false;
    out.is_behind = surfel.sight >= 0 && of_.are_told && with_.are_told;
    bool is_hidden = true;
    for (const SightMap& sight : with_.sights) {
      const double other = cosine(place - sight.station(), normal);
      const bool is_same_side = own == 0 || own * other > 0;
      Sighted seen = sight.look(place, normal, kSightNoises * noise_m_);
      if (seen == Sighted::kThrough && std::abs(other) < kPiercedIncidence)
        seen = Sighted::kUnknown;
      is_hidden = is_hidden && seen == Sighted::kHidden;
      out.is_visible = out.is_visible || (is_same_side && std::abs(other) > kLeastIncidence);
      out.is_behind = out.is_behind && !is_same_side && std::abs(other) > kBehindIncidence &&
                      std::abs(own) > kBehindIncidence;
      // A surface that one station saw outweighs the beams of another: there may be panes.
      if (seen == Sighted::kSurface || out.seen == Sighted::kUnknown ||
          (seen == Sighted::kThrough && out.seen == Sighted::kHidden))
        out.seen = seen;
    }
    out.is_visible = out.is_visible && !is_hidden;
    return out;
  }

  Said ask_neighbours(const Vec3& place, const Vec3& normal, double reach_m, bool& is_near) const {
    const SurfacePlanes& surface = *with_.surface;
    std::array<Neighbour, kNeighbours> found;
    const size_t n =
        surface.tree->knn_positions(surface.tree->cube().origin + place, kNeighbours, found);
    is_near = n > 0 && std::sqrt(found[0].squared_distance) <= kNear * reach_m;
    if (!is_near) return Said::kNothing;
    bool is_beside = false;
    for (size_t i = 0; i < n; ++i) {
      const uint32_t position = found[i].index;
      if (!surface.flat(position)) continue;
      const SurfacePlane& plane = surface.planes[position];
      const Vec3 d = place - surface.place(position), unit = plane.unit();
      const double height = dot(unit, d) - double{plane.height_m};
      const double sideways = std::sqrt(std::max(0.0, squared_norm(d) - height * height));
      const double local_m = std::max(reach_m, double{plane.radius_m});
      const bool is_level = std::abs(height) <= kLevel * local_m;
      if (sideways > kBeside * local_m) {
        is_beside = is_beside || is_level;
      } else if (std::abs(dot(unit, normal)) >= kFacing &&
                 std::abs(height) <= height_m_ + kUneven * local_m) {
        return Said::kExplained;
      }
    }
    return is_beside ? Said::kNothing : Said::kUnexplained;
  }

  static double cosine(const Vec3& ray, const Vec3& normal) {
    const double length = norm(ray);
    return length > 0 ? dot(ray, normal) / length : 0;
  }

  const JudgedCloud& of_;
  const JudgedCloud& with_;
  const Transform& T_with_of_;
  double reach_m_, noise_m_;
  double height_m_;  ///< that a surfel may be above a flat surface
};

bool is_against(Said said) { return said == Said::kUnexplained || said == Said::kPierced; }

// Of each surfel, whether it speaks against the pose and so do most of those about it that say anything: at the edges
// of things single ones do at right poses too.
std::vector<bool> of_things(std::span<const Surfel* const> surfels, std::span<const Answer> answers,
                            Task& task) {
  std::vector<bool> out(surfels.size());
  std::vector<double> xyz;
  std::vector<size_t> saying;
  Box3 box;
  for (size_t i = 0; i < surfels.size(); ++i) {
    if (answers[i].said == Said::kNothing) continue;
    for (int axis = 0; axis < 3; ++axis) xyz.push_back(surfels[i]->place[axis]);
    saying.push_back(i);
    box.add(surfels[i]->place);
  }
  if (saying.size() < kAbout) return out;
  const auto tree = Octree::build(xyz, enclosing_cube(box), task);
  std::array<Neighbour, kAbout> about;
  for (const size_t i : saying) {
    if (!is_against(answers[i].said)) continue;
    const size_t n = tree->knn(surfels[i]->place, kAbout, about);
    size_t like = 0;
    for (size_t j = 0; j < n; ++j) like += is_against(answers[saying[about[j].index]].said);
    out[i] = like >= kMostOfThem;
  }
  return out;
}

}  // namespace

double reach_of(const JudgedCloud& a, const JudgedCloud& b) {
  return std::max(a.surface->radius_m, b.surface->radius_m);
}

Agreement agreement_of(const JudgedCloud& of, const JudgedCloud& with, const Transform& T_with_of,
                       Task& task, size_t every) {
  const Holding holding(of, with, T_with_of);
  std::vector<const Surfel*> asked;
  for (size_t i = 0; i < of.surfels.size(); i += every) asked.push_back(&of.surfels[i]);
  std::vector<Answer> answers(asked.size());
  parallel_for(task, answers.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) answers[i] = holding.ask(*asked[i]);
  });
  const std::vector<bool> is_thing = of_things(asked, answers, task);
  Agreement out;
  out.surfels = answers.size();
  out.has_sights = !with.sights.empty();
  size_t seen[3] = {kPrior, kPrior, kPrior}, pierced[3] = {};
  for (size_t i = 0; i < answers.size(); ++i) {
    const Answer& answer = answers[i];
    const int axis = nearest_axis(asked[i]->normal);
    const bool is_pierced = is_thing[i] && answer.said == Said::kPierced;
    out.near += answer.is_near;
    out.explained += answer.said == Said::kExplained;
    out.unexplained += answer.said == Said::kUnexplained;
    out.seen += answer.is_seen;
    out.pierced += is_pierced;
    out.judged += answer.said != Said::kNothing;
    out.contradicted += is_thing[i];
    seen[axis] += answer.is_seen;
    pierced[axis] += is_pierced;
  }
  for (int axis = 0; axis < 3; ++axis)
    out.worst_pierced = std::max(
        out.worst_pierced, static_cast<double>(pierced[axis]) / static_cast<double>(seen[axis]));
  return out;
}

}  // namespace jalon
