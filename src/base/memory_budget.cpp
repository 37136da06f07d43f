// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/memory_budget.h"

#include <algorithm>
#include <limits>
#include <new>

#include "base/error.h"
#include "base/text_number.h"

namespace jalon {

namespace {

constexpr double kMebibyte = 0x1p20;

constinit thread_local MemoryBudget* own_budget = nullptr;

}  // namespace

namespace budgets {

std::atomic<int> in_use{0};
MemoryBudget* of_this_thread() noexcept { return own_budget; }

}  // namespace budgets

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

BudgetScope::BudgetScope(MemoryBudget* budget) noexcept : own_(budget), before_(own_budget) {
  if (own_ != nullptr) budgets::in_use.fetch_add(1);
  own_budget = own_;
}

BudgetScope::~BudgetScope() {
  own_budget = before_;
  if (own_ != nullptr) budgets::in_use.fetch_sub(1);
}

void require_memory(uint64_t bytes) {
  MemoryBudget* const budget = current_budget();
  if (budget != nullptr && !budget->allows(bytes)) throw std::bad_alloc();
}

}  // namespace jalon
