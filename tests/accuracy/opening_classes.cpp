// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "opening_classes.h"

#include <iomanip>
#include <map>

namespace jalon::test {

namespace {

constexpr double kSameIou = 0.5, kNothingIou = 0.1, kRow_m = 0.01, kChord_m = 0.005;
constexpr double kOwnWall_m = 0.3;
constexpr double kParallel = 0.9986;  // cosine of 3 degrees
constexpr size_t kBins = 10;

OpeningKind kind_of(OpeningClass truth) {
  switch (truth) {
    case OpeningClass::kWindow:
      return OpeningKind::kWindow;
    case OpeningClass::kDoor:
      return OpeningKind::kDoor;
    case OpeningClass::kGateway:
      return OpeningKind::kGateway;
    case OpeningClass::kShopFront:
      return OpeningKind::kShopFront;
    case OpeningClass::kVent:
      return OpeningKind::kVent;
    case OpeningClass::kRecess:
      return OpeningKind::kRecess;
    case OpeningClass::kOther:
      break;
  }
  return OpeningKind::kOpening;
}

struct Known {
  Region region;
  double out_m = 0;  ///< of its wall
  std::vector<OpeningKind> kinds;
};

/// The openings of a plan with what lies under them; those over nothing are `otherwise`, left out where that is empty.
std::vector<KnownOpening> matched(const FacadePlan& plan, const WallAxes& axes,
                                  const std::vector<Known>& known, const std::string& place,
                                  const std::vector<OpeningKind>& otherwise) {
  std::vector<KnownOpening> out;
  for (const PlannedFacade& facade : plan.facades) {
    const auto features = opening_features(plan, facade);
    for (size_t w = 0; w < facade.walls.size(); ++w) {
      const FacadeWall& wall = facade.walls[w].wall;
      if (std::fabs(dot(wall.frame.normal, axes.n)) < kParallel) continue;
      for (size_t k = 0; k < wall.openings.size(); ++k) {
        const FacadeOpening& opening = wall.openings[k];
        const std::vector<Vec2> corners = flattened(opening.outline, kChord_m);
        std::vector<Vec2> ring;
        for (const Vec2& p : corners) ring.push_back(axes.project(wall.frame.lift(p)));
        const double out_m = axes.height_m(wall.frame.lift(corners.front()));
        const Region region{{{ring}}};
        double best = 0;
        const Known* under = nullptr;
        for (const Known& candidate : known) {
          if (std::fabs(candidate.out_m - out_m) > kOwnWall_m ||
              !extent_of(region).meets(extent_of(candidate.region)))
            continue;
          const double iou = areas(region, candidate.region, kRow_m).iou();
          if (iou > best) best = iou, under = &candidate;
        }
        if (best > kNothingIou && best < kSameIou) continue;
        const auto& kinds = best >= kSameIou ? under->kinds : otherwise;
        if (!kinds.empty())
          out.push_back({place, kinds, opening.kind, opening.kind_confidence, features[w][k]});
      }
    }
  }
  return out;
}

/// Whether the likeliest class is right, told or not.
bool likeliest_is_right(const KnownOpening& o) {
  const auto p = class_probabilities(o.features);
  const auto kind = static_cast<OpeningKind>(std::max_element(p.begin(), p.end()) - p.begin());
  return std::find(o.truth.begin(), o.truth.end(), kind) != o.truth.end();
}

}  // namespace

std::vector<KnownOpening> known_openings(const FacadePlan& plan, const FacadeTruth& truth,
                                         const std::string& place) {
  WallAxes axes;
  const TruthWall& first = truth.walls.at(0);
  axes.origin = first.origin, axes.u = first.along, axes.v = first.up, axes.n = first.normal;
  std::vector<Known> known;
  for (const TruthOpening& o : truth.openings)
    known.push_back({drawn(o.contour).region,
                     axes.height_m(truth.walls[o.wall].origin),
                     {kind_of(o.opening_class)}});
  return matched(plan, axes, known, place, {OpeningKind::kOpening});
}

std::vector<KnownOpening> labelled_openings(const FacadePlan& plan,
                                            const std::vector<Drawn>& labels, const WallAxes& axes,
                                            const std::string& place) {
  std::vector<Known> known;
  for (const Drawn& label : labels) {
    if (label.part_class.starts_with("window"))
      known.push_back({label.region, 0, {OpeningKind::kWindow}});
    else
      known.push_back(
          {label.region, 0, {OpeningKind::kDoor, OpeningKind::kShopFront, OpeningKind::kGateway}});
  }
  return matched(plan, axes, known, place, {});  // what is not labelled may be anything
}

double share_right(const std::vector<KnownOpening>& openings) {
  double certain = 0, right = 0;
  for (const KnownOpening& o : openings) {
    certain += o.is_certain();
    right += o.is_certain() && o.is_right();
  }
  return certain > 0 ? right / certain : 1;
}

double brier_score(const std::vector<KnownOpening>& openings) {
  double sum = 0;
  for (const KnownOpening& o : openings) {
    const double d = o.confidence - (likeliest_is_right(o) ? 1 : 0);
    sum += d * d;
  }
  return openings.empty() ? 0 : sum / static_cast<double>(openings.size());
}

std::string reliability_of(const std::vector<KnownOpening>& openings) {
  struct Bin {
    size_t n = 0, right = 0;
    double sum = 0;
  };
  std::array<Bin, kBins> bins;
  for (const KnownOpening& o : openings) {
    Bin& bin = bins[std::min(kBins - 1, static_cast<size_t>(o.confidence * kBins))];
    ++bin.n;
    bin.right += likeliest_is_right(o);
    bin.sum += o.confidence;
  }
  std::ostringstream out;
  out << std::fixed << std::setprecision(3);
  for (const Bin& bin : bins)
    if (bin.n > 0)
      out << "\n  said " << bin.sum / static_cast<double>(bin.n) << ", right "
          << static_cast<double>(bin.right) / static_cast<double>(bin.n) << " of " << bin.n;
  return out.str();
}

std::string confusion_of(const std::vector<KnownOpening>& openings) {
  std::map<std::string, std::map<std::string, size_t>> counts;
  for (const KnownOpening& o : openings) ++counts[class_of(o.truth.front())][class_of(o.kind)];
  std::ostringstream out;
  for (const auto& [truth, taken] : counts) {
    out << "\n  " << std::left << std::setw(11) << truth << "told as";
    for (const auto& [kind, n] : taken) out << "  " << kind << " " << n;
  }
  return out.str();
}

}  // namespace jalon::test
