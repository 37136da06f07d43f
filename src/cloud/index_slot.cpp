// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <chrono>

#include "base/parallel.h"
#include "cloud/cloud.h"

namespace jalon {

namespace {

constexpr auto kCancelPoll =
    std::chrono::milliseconds(50);  // the API promises an answer to cancel within 100 ms
constexpr size_t kIndexSlotGrain = 1 << 16;

Box3 bounds_of(std::span<const double> xyz, Task& task) {
  return parallel_reduce(task, xyz.size() / 3, kIndexSlotGrain, Box3{},
                         [&](size_t begin, size_t end) {
                           Box3 box;
                           for (size_t i = begin; i < end; ++i)
                             box.add({xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]});
                           return box;
                         });
}

std::shared_ptr<const Octree> build_tree(std::span<const double> xyz, const Cube* cube,
                                         Task& task) {
  if (cube != nullptr) return Octree::build(xyz, *cube, task);
  if (xyz.empty()) return Octree::build(xyz, Cube{}, task);
  Cube own;
  {
    ProgressSpan span(task, 0, 0.05);
    own = enclosing_cube(bounds_of(xyz, task));
  }
  ProgressSpan span(task, 0.05, 1);
  return Octree::build(xyz, own, task);
}

}  // namespace

std::shared_ptr<const Octree> IndexSlot::get(std::span<const double> xyz, Task& task) {
  return build(xyz, nullptr, task);
}

std::shared_ptr<const Octree> IndexSlot::get_on(std::span<const double> xyz, const Cube& cube,
                                                Task& task) {
  return build(xyz, &cube, task);
}

void IndexSlot::drop() {
  std::shared_ptr<const Octree> last;  // freed without the lock
  const std::lock_guard lock(mutex_);
  last.swap(tree_);
}

void IndexSlot::remember(const std::shared_ptr<Remembered>& made) {
  const std::lock_guard lock(mutex_);
  remembered_ = made;
}

std::shared_ptr<IndexSlot::Remembered> IndexSlot::remembered() {
  const std::lock_guard lock(mutex_);
  return remembered_.lock();
}

std::shared_ptr<const Octree> IndexSlot::build(std::span<const double> xyz, const Cube* cube,
                                               Task& task) {
  // 1. Use what is there, or become the one builder, or wait for it.
  {
    std::unique_lock lock(mutex_);
    for (;;) {
      if (tree_ && (cube == nullptr || tree_->cube() == *cube)) return tree_;
      if (!building_) break;
      changed_.wait_for(lock, kCancelPoll);
      lock.unlock();  // the host's callback may come back to this cloud
      task.checkpoint(0);
      lock.lock();
    }
    building_ = true;
  }
  // 2. Build without the lock. Whatever happens, the next in line is told.
  struct Turn {
    IndexSlot& slot;
    std::shared_ptr<const Octree> tree;
    ~Turn() {
      {
        std::lock_guard lock(slot.mutex_);
        slot.building_ = false;
        if (tree) slot.tree_ = tree;
      }
      slot.changed_.notify_all();
    }
  } turn{*this, nullptr};
  turn.tree = build_tree(xyz, cube, task);
  return turn.tree;
}

}  // namespace jalon
