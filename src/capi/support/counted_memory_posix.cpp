// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "capi/support/counted_memory.h"

#ifdef JALON_COUNTS_MEMORY

#include <dlfcn.h>
#include <malloc.h>

#include <cerrno>
#include <cstdlib>
#include <exception>
#include <limits>
#include <new>
#include <string>

#include "base/memory_budget.h"

// The linker's --wrap leads the allocations of this library, and of no other, to the functions wrapped_...; real_...
// are those of the process, the host's own where it has some. So memory may be taken here and given back elsewhere.
#define JALON_WRAPPED(result, name, symbol, ...)                        \
  extern "C" result real_##name(__VA_ARGS__) __asm__("__real_" symbol); \
  extern "C" result wrapped_##name(__VA_ARGS__) __asm__("__wrap_" symbol);

JALON_WRAPPED(void*, malloc, "malloc", size_t)
JALON_WRAPPED(void*, calloc, "calloc", size_t, size_t)
JALON_WRAPPED(void*, realloc, "realloc", void*, size_t)
JALON_WRAPPED(void, free, "free", void*)
JALON_WRAPPED(void*, aligned_alloc, "aligned_alloc", size_t, size_t)
JALON_WRAPPED(int, posix_memalign, "posix_memalign", void**, size_t, size_t)
// Names of the C++ ABI of Itanium, 5.1.5.3, where size_t is unsigned long.
JALON_WRAPPED(void*, new, "_Znwm", size_t)
JALON_WRAPPED(void*, new_array, "_Znam", size_t)
JALON_WRAPPED(void*, new_quiet, "_ZnwmRKSt9nothrow_t", size_t, const std::nothrow_t&)
JALON_WRAPPED(void*, new_array_quiet, "_ZnamRKSt9nothrow_t", size_t, const std::nothrow_t&)
JALON_WRAPPED(void*, new_aligned, "_ZnwmSt11align_val_t", size_t, std::align_val_t)
JALON_WRAPPED(void*, new_array_aligned, "_ZnamSt11align_val_t", size_t, std::align_val_t)
JALON_WRAPPED(void, delete, "_ZdlPv", void*)
JALON_WRAPPED(void, delete_array, "_ZdaPv", void*)
JALON_WRAPPED(void, delete_sized, "_ZdlPvm", void*, size_t)
JALON_WRAPPED(void, delete_array_sized, "_ZdaPvm", void*, size_t)
JALON_WRAPPED(void, delete_quiet, "_ZdlPvRKSt9nothrow_t", void*, const std::nothrow_t&)
JALON_WRAPPED(void, delete_array_quiet, "_ZdaPvRKSt9nothrow_t", void*, const std::nothrow_t&)
JALON_WRAPPED(void, delete_aligned, "_ZdlPvSt11align_val_t", void*, std::align_val_t)
JALON_WRAPPED(void, delete_array_aligned, "_ZdaPvSt11align_val_t", void*, std::align_val_t)
JALON_WRAPPED(void, delete_sized_aligned, "_ZdlPvmSt11align_val_t", void*, size_t, std::align_val_t)
JALON_WRAPPED(void, delete_array_sized_aligned, "_ZdaPvmSt11align_val_t", void*, size_t,
              std::align_val_t)

#undef JALON_WRAPPED

#ifdef __GLIBCXX__
// Texts grow in functions that the standard library compiled for itself, out of the linker's reach: here are our own.
template class std::basic_string<char>;
#endif

namespace jalon::capi {

namespace {

bool may_take(size_t bytes) noexcept {
  MemoryBudget* const budget = current_budget();
  return budget == nullptr || budget->allows(bytes);
}

void* taken(void* memory) noexcept {
  if (MemoryBudget* const budget = current_budget())
    budget->add(static_cast<ptrdiff_t>(malloc_usable_size(memory)));
  return memory;
}

void* given_back(void* memory) noexcept {
  if (MemoryBudget* const budget = current_budget())
    budget->add(-static_cast<ptrdiff_t>(malloc_usable_size(memory)));
  return memory;
}

void* no_memory() noexcept {
  errno = ENOMEM;
  return nullptr;
}

void require_leave(size_t bytes) {
  if (!may_take(bytes)) throw std::bad_alloc();
}

// The file of the process that a function is of.
const void* home_of(const void* function) noexcept {
  Dl_info info;
  return dladdr(function, &info) != 0 ? info.dli_fbase : nullptr;
}

}  // namespace

// Only malloc knows how large its blocks are: a host whose operator new has memory of its own is not counted. Those of
// the standard library, and of allocators that bring malloc too, take theirs from malloc.
bool is_memory_counted() noexcept {
  const void* const home = home_of(reinterpret_cast<const void*>(&real_new));
  return home != nullptr && (home == home_of(reinterpret_cast<const void*>(&std::get_terminate)) ||
                             home == home_of(reinterpret_cast<const void*>(&malloc_usable_size)));
}

}  // namespace jalon::capi

using namespace jalon::capi;

extern "C" {

void* wrapped_malloc(size_t n) { return may_take(n) ? taken(real_malloc(n)) : no_memory(); }
void* wrapped_calloc(size_t n, size_t size) {
  const bool fits = size == 0 || n <= std::numeric_limits<size_t>::max() / size;
  return !fits || may_take(n * size) ? taken(real_calloc(n, size)) : no_memory();
}
void* wrapped_realloc(void* memory, size_t n) {
  const size_t before = malloc_usable_size(memory);
  if (n > before && !may_take(n - before)) return no_memory();
  jalon::MemoryBudget* const budget = jalon::current_budget();
  void* const out = real_realloc(memory, n);
  const bool has_moved = out != nullptr || n == 0;
  if (budget != nullptr && has_moved)
    budget->add(static_cast<ptrdiff_t>(malloc_usable_size(out)) - static_cast<ptrdiff_t>(before));
  return out;
}
void wrapped_free(void* memory) { real_free(given_back(memory)); }
void* wrapped_aligned_alloc(size_t alignment, size_t n) {
  return may_take(n) ? taken(real_aligned_alloc(alignment, n)) : no_memory();
}
int wrapped_posix_memalign(void** out, size_t alignment, size_t n) {
  if (!may_take(n)) return ENOMEM;
  const int status = real_posix_memalign(out, alignment, n);
  if (status == 0) (void)taken(*out);
  return status;
}

void* wrapped_new(size_t n) { return require_leave(n), taken(real_new(n)); }
void* wrapped_new_array(size_t n) { return require_leave(n), taken(real_new_array(n)); }
void* wrapped_new_quiet(size_t n, const std::nothrow_t& quiet) {
  return may_take(n) ? taken(real_new_quiet(n, quiet)) : nullptr;
}
void* wrapped_new_array_quiet(size_t n, const std::nothrow_t& quiet) {
  return may_take(n) ? taken(real_new_array_quiet(n, quiet)) : nullptr;
}
void* wrapped_new_aligned(size_t n, std::align_val_t alignment) {
  return require_leave(n), taken(real_new_aligned(n, alignment));
}
void* wrapped_new_array_aligned(size_t n, std::align_val_t alignment) {
  return require_leave(n), taken(real_new_array_aligned(n, alignment));
}

void wrapped_delete(void* memory) { real_delete(given_back(memory)); }
void wrapped_delete_array(void* memory) { real_delete_array(given_back(memory)); }
void wrapped_delete_sized(void* memory, size_t n) { real_delete_sized(given_back(memory), n); }
void wrapped_delete_array_sized(void* memory, size_t n) {
  real_delete_array_sized(given_back(memory), n);
}
void wrapped_delete_quiet(void* memory, const std::nothrow_t& quiet) {
  real_delete_quiet(given_back(memory), quiet);
}
void wrapped_delete_array_quiet(void* memory, const std::nothrow_t& quiet) {
  real_delete_array_quiet(given_back(memory), quiet);
}
void wrapped_delete_aligned(void* memory, std::align_val_t alignment) {
  real_delete_aligned(given_back(memory), alignment);
}
void wrapped_delete_array_aligned(void* memory, std::align_val_t alignment) {
  real_delete_array_aligned(given_back(memory), alignment);
}
void wrapped_delete_sized_aligned(void* memory, size_t n, std::align_val_t alignment) {
  real_delete_sized_aligned(given_back(memory), n, alignment);
}
void wrapped_delete_array_sized_aligned(void* memory, size_t n, std::align_val_t alignment) {
  real_delete_array_sized_aligned(given_back(memory), n, alignment);
}

}  // extern "C"

#else

namespace jalon::capi {

bool is_memory_counted() noexcept { return false; }

}  // namespace jalon::capi

#endif
