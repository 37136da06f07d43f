// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/change_groups.h"

#include <algorithm>

namespace jalon {

namespace {

// Of the changed area: less than that on one side is its edge.
constexpr double kOneSided = 0.1;

ChangeGroup group_of(const ObjectMotionJob& job, const std::vector<ChangePiece>& pieces,
                     const std::vector<size_t>& members) {
  ChangeGroup out;
  double moved = 0, points = 0;
  for (const size_t k : members) {
    const ChangePiece& piece = pieces[k];
    const Epoch& epoch = piece.is_after ? job.after : job.before;
    const ChangeRegion& region = epoch.regions.regions[piece.label - 1];
    auto& indices = piece.is_after ? out.object.after : out.object.before;
    indices.insert(indices.end(), region.indices.begin(), region.indices.end());
    (piece.is_after ? out.object.regions_after : out.object.regions_before).push_back(piece.label);
    (piece.is_after ? out.after_m2 : out.before_m2) += region.area_m2;
    moved += piece.moved_share * static_cast<double>(piece.points);
    points += static_cast<double>(piece.points);
    out.box.add(piece.box.min);
    out.box.add(piece.box.max);
  }
  out.moved_share = points > 0 ? moved / points : 0;
  std::sort(out.object.before.begin(), out.object.before.end());
  std::sort(out.object.after.begin(), out.object.after.end());
  return out;
}

size_t common(const std::vector<uint32_t>& part, const std::vector<uint32_t>& whole) {
  return static_cast<size_t>(std::count_if(part.begin(), part.end(), [&](uint32_t i) {
    return std::binary_search(whole.begin(), whole.end(), i);
  }));
}

}  // namespace

bool ChangeGroup::only_after() const { return before_m2 <= kOneSided * after_m2; }
bool ChangeGroup::only_before() const { return after_m2 <= kOneSided * before_m2; }

std::vector<ChangeGroup> change_groups(const ObjectMotionJob& job) {
  const std::vector<ChangePiece> pieces = change_pieces(job.before, job.after, job.task);
  std::vector<ChangeGroup> out;
  for (const auto& members : group_pieces(job.before, job.after, pieces, job.cell_m, job.task))
    out.push_back(group_of(job, pieces, members));
  return out;
}

bool lies_in(const ChangedObject& part, const ChangedObject& whole) {
  const size_t all = part.before.size() + part.after.size();
  return 2 * (common(part.before, whole.before) + common(part.after, whole.after)) > all;
}

}  // namespace jalon
