// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/change_objects.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "compare/changes/epoch_window.h"

namespace jalon {

namespace {

constexpr int kWidenings = 6;  // of the window around a region ...
// For one change: where it was pushed most of it changed, and looking farther costs what the whole cloud does.
constexpr int kWideningsOfOne = 3;
constexpr double kWidening =
    1.5;  // ... each by this: objects up to eleven times the size of their change
constexpr double kWindow = 0.5;     // first margin in diagonals of the region
constexpr double kWindowCells = 6;  // and at least so many cells
constexpr int kTurns = 3;           // between the epochs, until nothing is added

using Indices = std::vector<uint32_t>;

double cell_of(const Epoch& before, const Epoch& after) {
  return std::max({before.regions.cell_m, after.regions.cell_m, 1e-6});
}

Box3 widened(const Box3& box, double margin) {
  const Vec3 d{margin, margin, margin};
  return {box.min - d, box.max + d};
}

bool reaches_edge(const Epoch& epoch, const Indices& points, const Box3& window, double margin) {
  const Box3 inner = widened(window, -margin);
  return std::any_of(points.begin(), points.end(),
                     [&](uint32_t i) { return !inner.contains(epoch.local(i)); });
}

class Grower {
 public:
  Grower(const Epoch& before, const Epoch& after, double tolerance_m, int widenings, Task& task)
      : before_(before),
        after_(after),
        tolerance_m_(tolerance_m),
        widenings_(widenings),
        cell_m_(cell_of(before, after)),
        task_(task),
        in_before_(before),
        in_after_(after) {}

  // The object that holds these changed points.
  ChangedObject object_of(Indices seeds_before, Indices seeds_after) {
    ChangedObject out;
    Box3 change;
    for (const uint32_t i : seeds_before) change.add(before_.local(i));
    for (const uint32_t i : seeds_after) change.add(after_.local(i));
    Box3 window =
        widened(change, std::max(kWindow * norm(change.max - change.min), kWindowCells * cell_m_));
    for (int k = 0; k <= widenings_; ++k) {
      fill(window, change, seeds_before, seeds_after, out);
      if (!goes_on_beyond(window, out)) return out;
      window =
          widened(window, (kWidening - 1) / 2 * norm(window.max - window.min) / std::sqrt(3.0));
    }
    out.before = std::move(seeds_before);
    out.after = std::move(seeds_after);
    out.supports.clear();
    return out;
  }

 private:
  void fill(const Box3& window, const Box3& change, const Indices& seeds_before,
            const Indices& seeds_after, ChangedObject& out) {
    both([&](EpochWindow& epoch) { epoch.look(window, task_); });
    out.supports = find_supports(unchanged_sample(), change, tolerance_m_, 0);
    grow_both(seeds_before, seeds_after, out);
    // Without one of its supports an object only grows: what goes on beyond the window will not fit in it.
    while (!goes_on_beyond(window, out) && drop_own_faces(out))
      grow_both(seeds_before, seeds_after, out);
  }

  bool goes_on_beyond(const Box3& window, const ChangedObject& object) const {
    return reaches_edge(before_, object.before, window, cell_m_) ||
           reaches_edge(after_, object.after, window, cell_m_);
  }

  void grow_both(const Indices& seeds_before, const Indices& seeds_after, ChangedObject& out) {
    both([&](EpochWindow& epoch) { epoch.part(out.supports, cell_m_, task_); });
    for (const uint32_t i : seeds_before) in_before_.take(i);
    for (const uint32_t i : seeds_after) in_after_.take(i);
    for (int turn = 0; turn < kTurns; ++turn) {
      const bool has_after = in_after_.take_counterparts(in_before_),
                 has_before = in_before_.take_counterparts(in_after_);
      if (!has_after && !has_before) break;
    }
    out.before = in_before_.whole();
    out.after = in_after_.whole();
  }

  // Of both epochs, for supports: a window may hold all points.
  std::vector<Vec3> unchanged_sample() const {
    size_t count = 0, at = 0;
    for (const EpochWindow* epoch : {&in_before_, &in_after_})
      epoch->for_each_unchanged([&](const Vec3&) { ++count; });
    const size_t step = support_step(count);
    std::vector<Vec3> out;
    for (const EpochWindow* epoch : {&in_before_, &in_after_})
      epoch->for_each_unchanged([&](const Vec3& p) {
        if (at++ % step == 0) out.push_back(p);
      });
    return out;
  }

  template <class F>
  void both(F&& f) {
    parallel_chunks(task_, 2, [&](size_t k) { f(k == 0 ? in_before_ : in_after_); });
  }

  // A plane that does not go on beyond the whole object, as it did beyond its change, is one of its own faces.
  bool drop_own_faces(ChangedObject& object) const {
    Box3 box;
    for (const uint32_t i : object.before) box.add(before_.local(i));
    for (const uint32_t i : object.after) box.add(after_.local(i));
    return !box.empty() && std::erase_if(object.supports,
                                         [&](const Support& s) { return !s.goes_beyond(box); }) > 0;
  }

  const Epoch &before_, &after_;
  double tolerance_m_;
  int widenings_;
  double cell_m_;
  Task& task_;
  EpochWindow in_before_, in_after_;
};

// Labels of the regions that an object holds and no object before it did; they are then done with.
std::vector<uint32_t> labels_in(const Epoch& epoch, const Indices& points,
                                std::vector<uint8_t>& done) {
  std::vector<uint32_t> out;
  for (const uint32_t i : points)
    if (const uint32_t label = epoch.regions.labels[i]; label > 0 && done[label - 1] == 0)
      out.push_back(label);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  for (const uint32_t label : out) done[label - 1] = 1;
  return out;
}

void take(const Epoch& before, const Epoch& after, ChangedObject& object,
          std::vector<uint8_t>& done_before, std::vector<uint8_t>& done_after) {
  object.regions_before = labels_in(before, object.before, done_before);
  object.regions_after = labels_in(after, object.after, done_after);
}

}  // namespace

std::vector<ChangedObject> single_regions(const Epoch& before, const Epoch& after,
                                          const ChangedObject& object, double cell_m) {
  std::vector<ChangedObject> out;
  const auto add = [&](const Epoch& epoch, const Indices& points,
                       const std::vector<uint32_t>& labels, bool is_after) {
    for (const uint32_t label : labels) {
      const ChangeRegion& region = epoch.regions.regions[label - 1];
      const Box3 beside =
          widened({region.box.min - epoch.origin, region.box.max - epoch.origin}, 2 * cell_m);
      ChangedObject& one = out.emplace_back();
      one.supports = object.supports;
      (is_after ? one.regions_after : one.regions_before) = {label};
      Indices& own = is_after ? one.after : one.before;
      for (const uint32_t i : points)
        if (epoch.regions.labels[i] == label ||
            (epoch.regions.changed[i] == 0 && beside.contains(epoch.local(i))))
          own.push_back(i);
    }
  };
  add(before, object.before, object.regions_before, false);
  add(after, object.after, object.regions_after, true);
  return out;
}

double changed_area(const Epoch& epoch, const std::vector<uint32_t>& labels) {
  double sum = 0;
  for (const uint32_t label : labels) sum += epoch.regions.regions[label - 1].area_m2;
  return sum;
}

double changed_volume(const Epoch& epoch, const std::vector<uint32_t>& labels) {
  double sum = 0;
  for (const uint32_t label : labels) sum += epoch.regions.regions[label - 1].volume_m3;
  return sum;
}

ChangedObject whole_object(const Epoch& before, const Epoch& after,
                           const std::vector<uint32_t>& changed_before,
                           const std::vector<uint32_t>& changed_after, double tolerance_m,
                           Task& task) {
  return Grower(before, after, tolerance_m, kWideningsOfOne, task)
      .object_of(changed_before, changed_after);
}

std::vector<ChangedObject> whole_objects(const Epoch& before, const Epoch& after,
                                         double tolerance_m, Task& task) {
  Grower grower(before, after, tolerance_m, kWidenings, task);
  std::vector<uint8_t> done_before(before.regions.regions.size(), 0),
      done_after(after.regions.regions.size(), 0);
  std::vector<ChangedObject> out;
  const size_t regions = done_before.size() + done_after.size();
  for (size_t k = 0; k < regions; ++k) {
    const bool is_after = k < done_after.size();
    const size_t r = is_after ? k : k - done_after.size();
    if ((is_after ? done_after : done_before)[r] != 0) continue;
    const ChangeRegion& region = is_after ? after.regions.regions[r] : before.regions.regions[r];
    ChangedObject object =
        is_after ? grower.object_of({}, region.indices) : grower.object_of(region.indices, {});
    // A region within its own support (a hole in a floor that was filled) is what it is.
    if (object.before.empty() && object.after.empty())
      (is_after ? object.after : object.before) = region.indices;
    take(before, after, object, done_before, done_after);
    (is_after ? done_after : done_before)[r] = 1;
    out.push_back(std::move(object));
    task.checkpoint(static_cast<double>(k + 1) / static_cast<double>(regions));
  }
  std::stable_sort(out.begin(), out.end(), [](const ChangedObject& a, const ChangedObject& b) {
    return a.before.size() + a.after.size() > b.before.size() + b.after.size();
  });
  return out;
}

}  // namespace jalon
