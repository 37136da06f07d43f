// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace jalon {

/// What one call may have in use at once, beyond what was there before it. The allocator asks before and tells after;
/// no other code knows of it: a refusal looks like a machine without memory.
class MemoryBudget {
 public:
  explicit MemoryBudget(uint64_t limit_bytes);
  MemoryBudget(const MemoryBudget&) = delete;
  MemoryBudget& operator=(const MemoryBudget&) = delete;

  /// May so many bytes be taken now? A no is remembered.
  bool allows(size_t bytes) noexcept;
  /// Bytes that were taken, negative where they were given back.
  void add(ptrdiff_t bytes) noexcept;

  bool has_refused() const { return refused_ != 0; }
  /// One line: what was in use, what was wanted, what the limit is.
  [[noreturn]] void fail_refused() const;
  /// The most that was in use at once.
  uint64_t peak_bytes() const { return static_cast<uint64_t>(peak_.load()); }
  /// From here on all is allowed: for what a failure needs to be told.
  void lift() noexcept { is_lifted_ = true; }

 private:
  const int64_t limit_;
  std::atomic<int64_t> used_{0}, peak_{0}, used_then_{0};
  std::atomic<uint64_t> refused_{0};  ///< bytes of the first no, when used_then_ were in use
  std::atomic<bool> is_lifted_{false};
};

namespace budgets {
// A thread's variable costs a call in a shared library, and each allocation asks: it is looked at only while there are
// budgets at all.
extern std::atomic<int> in_use;
MemoryBudget* of_this_thread() noexcept;
}  // namespace budgets

/// That of this thread, or NULL.
inline MemoryBudget* current_budget() noexcept {
  return budgets::in_use.load(std::memory_order_relaxed) == 0 ? nullptr : budgets::of_this_thread();
}

/// While it lives this thread's allocations are the budget's; NULL: nobody's.
class BudgetScope {
 public:
  explicit BudgetScope(MemoryBudget* budget) noexcept;
  ~BudgetScope();
  BudgetScope(const BudgetScope&) = delete;
  BudgetScope& operator=(const BudgetScope&) = delete;

 private:
  MemoryBudget *own_, *before_;
};

/// Said before a call takes what it is sure to have in use at once: where this thread's budget is less it ends here
/// with std::bad_alloc, not after most of it was taken and filled. bytes: no more than will be taken, or calls that
/// could be done would be refused.
void require_memory(uint64_t bytes);

}  // namespace jalon
