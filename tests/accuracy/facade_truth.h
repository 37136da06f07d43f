// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// A model of a facade against the truth of the scene "grammar": openings, their classes and corners, wall area.
#pragma once

#include <string>
#include <vector>

#include "scan/facade_truth.h"
#include "wall_figures.h"

namespace jalon::test {

constexpr double kWantedSpacings = 5, kWantedSeen = 0.6;  ///< of openings that must be found
constexpr double kMatchIou = 0.7;
constexpr double kWellSeen = 0.9;  ///< of the outline of openings whose corners are measured
constexpr double kFillLimit_m2 =
    0.1;  ///< holes below may be filled: the chain's own min_opening_area_m2
constexpr double kFacadePlane_m =
    0.05;  ///< a face this near to a true wall's plane stands for that wall

/// An opening of the model in the frame of the truth's first wall: u along the facade, v up.
struct FoundOpening {
  std::string part_class;
  Drawn drawn;
  double out_m = 0;  ///< of its wall before that frame's plane
  /// Neither "opening" nor nothing: the chain says what it is.
  bool is_certain() const { return !part_class.empty() && part_class != "opening"; }
};

struct FoundFacade {
  std::vector<FoundOpening> openings;
  struct Face {
    Shape shape;
    double out_m = 0;
  };
  std::vector<Face> walls;
};

/// The faces of walls of a model and the openings in them. The truth's walls all look the same way.
FoundFacade found_facade(const Model& model, const FacadeTruth& truth);

/// Sums over facades.
struct FacadeFigures {
  size_t facades = 0;
  size_t wanted = 0, found = 0;  ///< of the truth
  size_t judged = 0, right = 0;  ///< of the model; those of unwanted true openings are not judged
  std::vector<double> ious;      ///< of those found
  size_t certain = 0, class_right = 0;
  double wall_m2 = 0;                        ///< of the true walls
  double invented_m2 = 0, elsewhere_m2 = 0;  ///< of the model's walls where none is: near a true
                                             ///< one's plane; in rooms and other planes
  double wall_seen_m2 = 0, lost_m2 = 0;      ///< of what was seen of them
  size_t corners = 0, paired = 0;
  double corner_squares = 0;            ///< of the paired ones, in spacings
  size_t straight = 0, false_arcs = 0;  ///< found openings without arcs; those drawn with one
  size_t round = 0, round_drawn = 0;    ///< found openings with arcs; those drawn with one
  std::string notes;                    ///< openings missed and invented

  double recall() const { return share(found, wanted); }
  double precision() const { return share(right, judged); }
  double class_share() const { return share(class_right, certain); }
  double median_iou() const;
  double invented_share() const { return wall_m2 > 0 ? invented_m2 / wall_m2 : 0; }
  double elsewhere_share() const { return wall_m2 > 0 ? elsewhere_m2 / wall_m2 : 0; }
  double lost_share() const { return wall_seen_m2 > 0 ? lost_m2 / wall_seen_m2 : 0; }
  double corner_rms() const {
    return paired > 0 ? std::sqrt(corner_squares / static_cast<double>(paired)) : 0;
  }
  FacadeFigures& operator+=(const FacadeFigures& o);

 private:
  static double share(size_t part, size_t of) {
    return of > 0 ? static_cast<double>(part) / static_cast<double>(of) : 1;
  }
};

bool is_wanted(const TruthOpening& opening);
/// The contour with its arcs, as a model's ring is drawn.
Drawn drawn(const TruthContour& contour);

FacadeFigures compare_facade(const FoundFacade& found, const FacadeTruth& truth);

/// One line of a table; the heads of its columns.
std::string row_of(const std::string& name, const FacadeFigures& f);
std::string heads_of_rows();

}  // namespace jalon::test
