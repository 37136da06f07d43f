// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/evidence_diagnosis.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "compare/changes/change_confidence.h"
#include "compare/changes/change_pieces.h"

namespace jalon {

namespace {

// Of the changed points: less than that on one side is its edge.
constexpr double kOneSided = 0.1;
constexpr double kMovedSurface = 0.5;  // of the points of a change: it is a surface that moved
constexpr double kEvidenceTwinShare = 0.97;  // of the points of twins explained by a motion

// What moved whole has points in both epochs, if not as many, and much of it changed: what does not costs no search.
constexpr double kLikeCount = 0.25, kChangedOfWhole = 0.1;

// The points of two planes that share none (see SurfaceCore): at the edges of pipes chance leaves fewer.
constexpr size_t kLeastToldPoints = 64;

struct Group {
  ChangedObject object;
  std::vector<const ChangePiece*> pieces;
  double before_m2 = 0, after_m2 = 0;
  double moved_share = 0;
  size_t points() const { return object.before.size() + object.after.size(); }
  bool only_after() const { return before_m2 <= kOneSided * after_m2; }
  bool only_before() const { return after_m2 <= kOneSided * before_m2; }
};

Group group_of(const ObjectMotionJob& job, const std::vector<ChangePiece>& pieces,
               const std::vector<size_t>& members) {
  Group out;
  double moved = 0, points = 0;
  for (const size_t k : members) {
    const ChangePiece& piece = pieces[k];
    out.pieces.push_back(&piece);
    const Epoch& epoch = piece.is_after ? job.after : job.before;
    const ChangeRegion& region = epoch.regions.regions[piece.label - 1];
    auto& indices = piece.is_after ? out.object.after : out.object.before;
    indices.insert(indices.end(), region.indices.begin(), region.indices.end());
    (piece.is_after ? out.object.regions_after : out.object.regions_before).push_back(piece.label);
    (piece.is_after ? out.after_m2 : out.before_m2) += region.area_m2;
    moved += piece.moved_share * static_cast<double>(piece.points);
    points += static_cast<double>(piece.points);
  }
  out.moved_share = points > 0 ? moved / points : 0;
  std::sort(out.object.before.begin(), out.object.before.end());
  std::sort(out.object.after.begin(), out.object.after.end());
  return out;
}

size_t changed_points_of(const Epoch& epoch, const std::vector<uint32_t>& points) {
  return static_cast<size_t>(std::count_if(
      points.begin(), points.end(), [&](uint32_t i) { return epoch.regions.labels[i] != 0; }));
}

Change change_of(Group&& group, ChangeClass change_class) {
  Change out;
  out.object = std::move(group.object);
  out.change_class = change_class;
  return out;
}

// Step 2: is the group a part of a thing that moved whole?
bool moved_with(const ObjectMotionJob& job, const ChangedObject& changed, Change& out) {
  ChangedObject whole =
      whole_object(job.before, job.after, changed.before, changed.after, job.tolerance_m, job.task);
  if (whole.supports.empty()) return false;
  const auto was = static_cast<double>(whole.before.size()),
             is = static_cast<double>(whole.after.size());
  const auto part = static_cast<double>(changed.before.size() + changed.after.size());
  if (std::min(was, is) < kLikeCount * std::max(was, is) || part < kChangedOfWhole * (was + is))
    return false;
  return moved_whole(job, std::move(whole), out);
}

size_t common(const std::vector<uint32_t>& part, const std::vector<uint32_t>& whole) {
  return static_cast<size_t>(std::count_if(part.begin(), part.end(), [&](uint32_t i) {
    return std::binary_search(whole.begin(), whole.end(), i);
  }));
}

bool lies_in(const ChangedObject& part, const ChangedObject& whole) {
  const size_t all = part.before.size() + part.after.size();
  return 2 * (common(part.before, whole.before) + common(part.after, whole.after)) > all;
}

// Takes what such things hold out of the groups, the largest first.
void take_moved_wholes(const ObjectMotionJob& job, std::vector<Group>& groups,
                       std::vector<Change>& changes) {
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.points() > b.points(); });
  for (size_t k = 0; k < groups.size();) {
    job.task.checkpoint(static_cast<double>(k) / static_cast<double>(groups.size()));
    Change moved;
    if (groups[k].points() < kLeastToldPoints || !moved_with(job, groups[k].object, moved)) {
      ++k;
      continue;
    }
    std::erase_if(groups, [&](const Group& group) {
      if (!lies_in(group.object, moved.object)) return false;
      const auto add = [](std::vector<uint32_t>& to, const std::vector<uint32_t>& from) {
        to.insert(to.end(), from.begin(), from.end());
      };
      add(moved.object.regions_before, group.object.regions_before);
      add(moved.object.regions_after, group.object.regions_after);
      return true;
    });
    if (moved.object.regions_before.empty() && moved.object.regions_after.empty()) ++k;
    else changes.push_back(std::move(moved));
  }
}

// Step 4.
Change changed_in_both(const ObjectMotionJob& job, Group&& group) {
  return moved_or_deformed(job, std::move(group.object));
}

Vec3 middle(const Epoch& epoch, const std::vector<uint32_t>& points, double& size_m) {
  Box3 box;
  for (const uint32_t i : points) box.add(epoch.local(i));
  size_m = norm(box.max - box.min);
  return (box.min + box.max) * 0.5;
}

bool is_within_reach(const ObjectMotionJob& job, const ChangedObject& gone,
                     const ChangedObject& come, double reach) {
  double size_gone = 0, size_come = 0;
  const Vec3 from = middle(job.before, gone.before, size_gone),
             to = middle(job.after, come.after, size_come);
  return norm(to - from) <= reach * std::max(size_gone, size_come);
}

// Step 4: twins, the best explained first.
void pair_moved(const ObjectMotionJob& job, double reach, std::vector<Group>& gone,
                std::vector<Group>& come, std::vector<Change>& changes) {
  struct Pair {
    size_t gone, come;
    Change change;
  };
  std::vector<Pair> pairs;
  for (size_t g = 0; g < gone.size(); ++g)
    for (size_t c = 0; c < come.size(); ++c)
      if (is_within_reach(job, gone[g].object, come[c].object, reach) &&
          are_twins(job, extents_of(job.before_of(gone[g].object), gone[g].object),
                    extents_of(job.after_of(come[c].object), come[c].object))) {
        Change change = moved_or_deformed(job, joined(gone[g].object, come[c].object));
        if (change.match.found && change.match.explained >= kEvidenceTwinShare)
          pairs.push_back({g, c, std::move(change)});
      }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return a.change.match.explained > b.change.match.explained;
  });
  for (Pair& pair : pairs) {
    if (gone[pair.gone].object.before.empty() || come[pair.come].object.after.empty()) continue;
    gone[pair.gone].object = {};
    come[pair.come].object = {};
    changes.push_back(std::move(pair.change));
  }
}

}  // namespace

bool has_evidence(const Comparison& forward, const Comparison& reverse) {
  return forward.points.find("evidence") != nullptr && reverse.points.find("evidence") != nullptr;
}

std::vector<Change> classes_by_evidence(const ObjectMotionJob& job, double twin_reach) {
  const std::vector<ChangePiece> pieces = change_pieces(job.before, job.after, job.task);
  const auto groups = group_pieces(job.before, job.after, pieces, job.cell_m, job.task);
  std::vector<Change> out;
  std::vector<Group> all, gone, come;
  for (const auto& members : groups) all.push_back(group_of(job, pieces, members));
  take_moved_wholes(job, all, out);
  for (Group& group : all) {
    if (group.moved_share >= kMovedSurface) {
      out.push_back(change_of(std::move(group), ChangeClass::kDeformationOverlap));
    } else if (group.only_after()) {
      come.push_back(std::move(group));
    } else if (group.only_before()) {
      gone.push_back(std::move(group));
    } else {
      out.push_back(changed_in_both(job, std::move(group)));
    }
  }
  pair_moved(job, twin_reach, gone, come, out);
  for (Group& group : come)
    if (!group.object.after.empty())
      out.push_back(change_of(std::move(group), ChangeClass::kAppearance));
  for (Group& group : gone)
    if (!group.object.before.empty())
      out.push_back(change_of(std::move(group), ChangeClass::kDisappearance));
  std::erase_if(out, [&](const Change& change) {
    return changed_points_of(job.before, change.object.before) +
               changed_points_of(job.after, change.object.after) <
           kLeastToldPoints;
  });
  set_features(job, out);
  for (Change& change : out) change.confidence = confidence_of(change);
  return out;
}

}  // namespace jalon
