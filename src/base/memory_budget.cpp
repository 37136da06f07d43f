// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/memory_budget.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "base/text_number.h"

namespace jalon {

namespace {

constexpr double kMebibyte = 0x1p20;

// A thread's variable costs a call in a shared library: it is looked at only while there are budgets at all.
std::atomic<int> budgets_in_use{0};
constinit thread_local MemoryBudget* of_this_thread = nullptr;

}  // namespace

MemoryBudget::MemoryBudget(uint64_t limit_bytes)
    : limit_(static_cast<int64_t>(
          std::min<uint64_t>(limit_bytes, std::numeric_limits<int64_t>::max()))) {}

bool MemoryBudget::allows(size_t bytes) noexcept {
  if (is_lifted_.load(std::memory_order_relaxed)) return true;
  const int64_t left = limit_ - std::max<int64_t>(0, used_.load(std::memory_order_relaxed));
  if (left >= 0 && bytes <= static_cast<uint64_t>(left)) return true;
  uint64_t none = 0;
  if (refused_.compare_exchange_strong(none, std::max<uint64_t>(1, bytes)))
    used_then_ = limit_ - left;
  return false;
}

void MemoryBudget::add(ptrdiff_t bytes) noexcept {
  const int64_t now = used_.fetch_add(bytes, std::memory_order_relaxed) + bytes;
  int64_t peak = peak_.load(std::memory_order_relaxed);
  while (now > peak && !peak_.compare_exchange_weak(peak, now, std::memory_order_relaxed)) {
  }
}

void MemoryBudget::fail_refused() const {
  const auto mebibytes = [](auto bytes) {
    return text_of(static_cast<double>(bytes) / kMebibyte, 1);
  };
  fail(Status::kOutOfMemory,
       "the call had %s MiB in use and needed %s more; its memory limit is %s MiB",
       mebibytes(used_then_.load()).c_str(), mebibytes(refused_.load()).c_str(),
       mebibytes(limit_).c_str());
}

MemoryBudget* current_budget() noexcept {
  return budgets_in_use.load(std::memory_order_relaxed) == 0 ? nullptr : of_this_thread;
}

BudgetScope::BudgetScope(MemoryBudget* budget) noexcept : own_(budget), before_(of_this_thread) {
  if (own_ != nullptr) budgets_in_use.fetch_add(1);
  of_this_thread = own_;
}

BudgetScope::~BudgetScope() {
  of_this_thread = before_;
  if (own_ != nullptr) budgets_in_use.fetch_sub(1);
}

}  // namespace jalon
