// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "segment/codes/coded_object.h"
#include "segment/codes_settings.h"

namespace jalon {

/// The spaces of surveyed objects, with their margins, behind a grid in plan: which object a point belongs to.
/// Pipes come first, since they stand where building and outside meet; then the shells of buildings, the inside
/// hollowed out; within a shell the openings, of two that hold a point the one later in the code table. Without any
/// building openings count everywhere. O(1) a point for the usual few objects about it.
class SurveySpace {
 public:
  SurveySpace(const CodeTable& table, const CodedObjects& objects,
              const SurveyCodeSettings& settings);

  /// p: relative to the objects' origin. 0: none, else number of the object, from 1.
  uint32_t object_at(const Vec3& p) const;

 private:
  struct Space {
    const CodeShape* shape;
    uint32_t object;    ///< number, from 1
    size_t rank;        ///< pipes, buildings, openings in the table's order
    double distance_m;  ///< of an opening's points from its plane
    Box3 box;           ///< with all margins
  };
  void add(const CodeTable& table, const CodedObject& object, uint32_t number);
  void lay_grid();
  template <class F>
  void for_cells_of(const Space& space, F&& f) const;
  size_t cell_of(double x, double y) const;  ///< SIZE_MAX outside
  bool holds(const Space& space, const Vec3& p) const;
  bool may_hold_in(const Space& space, const Vec2& middle, double reach) const;

  const SurveyCodeSettings& settings_;
  std::vector<Space> spaces_;  ///< by rank, then by number
  size_t pipes_ = 0, prisms_ = 0;
  Box3 box_;
  double cell_m_ = 0;
  size_t columns_ = 0, rows_ = 0;
  std::vector<uint32_t> first_;    ///< of each cell in members_
  std::vector<uint32_t> members_;  ///< indices of spaces, ascending within a cell
};

}  // namespace jalon
