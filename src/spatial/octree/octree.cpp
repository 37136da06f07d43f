// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/octree/octree.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "spatial/octree/impl.h"

namespace jalon {

namespace {

constexpr int kSmallestEdge =
    -20;                          // 2^-20 m: squared steps stay normal numbers in single precision
constexpr int kLargestEdge = 60;  // squared distances likewise stay finite

}  // namespace

Cube enclosing_cube(const Box3& box) {
  if (box.empty()) return {};
  Vec3 extent = box.max - box.min;
  const double longest = std::max({extent.x, extent.y, extent.z});
  if (!(longest < std::ldexp(1.0, kLargestEdge - 1)))
    fail(Status::kLimit, "the cloud is too large for an octree: its longest side exceeds 2^59 m");
  // Half a metre and more: origin on whole metres. Smaller: on the grid of the cube itself, of which a metre is a
  // multiple.
  const bool whole = longest >= 0.5;
  Cube cube;
  cube.edge = whole ? 1.0 : std::ldexp(1.0, kSmallestEdge);
  for (;; cube.edge *= 2) {
    const double unit = whole ? 1.0 : std::ldexp(cube.edge, -kGridBits);
    bool fits = true;
    for (int i = 0; i < 3; ++i) {
      cube.origin[i] = std::floor(box.min[i] / unit) * unit;
      fits &= box.max[i] - cube.origin[i] < cube.edge;
    }
    if (fits) return cube;
  }
}

Octree::Octree() : impl_(std::make_unique<Impl>()) {}
Octree::~Octree() = default;

std::shared_ptr<const Octree> Octree::build(std::span<const double> xyz, const Cube& cube,
                                            Task& task) {
  std::shared_ptr<Octree> tree(new Octree());
  Impl& impl = *tree->impl_;
  impl.xyz = xyz;
  impl.cube = cube;
  impl.step = std::ldexp(cube.edge, -kGridBits);
  impl.inverse_step = 1 / impl.step;
  impl.count = xyz.size() / 3;
  if (impl.count >= kNoPoint)
    fail(Status::kLimit, "an octree holds at most 2^32 - 2 points; there are %zu", impl.count);
  if (impl.count == 0) return tree;
  {
    ProgressSpan span(task, 0, 0.9, "building the index");
    impl.sort_points(task);
  }
  ProgressSpan span(task, 0.9, 1);
  impl.order_crowds(task);
  impl.build_boxes(task);
  impl.build_exact_boxes(task);
  return tree;
}

size_t Octree::size() const { return impl_->count; }
const Cube& Octree::cube() const { return impl_->cube; }
std::span<const uint32_t> Octree::order() const {
  return {impl_->order.data(), impl_->order.size()};
}
uint64_t Octree::code(size_t i) const { return code_of(impl_->x[i], impl_->y[i], impl_->z[i]); }
const int32_t* Octree::grid_x() const { return impl_->x.data(); }
const int32_t* Octree::grid_y() const { return impl_->y.data(); }
const int32_t* Octree::grid_z() const { return impl_->z.data(); }
double Octree::grid_step() const { return impl_->step; }
Vec3 Octree::local(size_t i) const { return impl_->grid_point(i) * impl_->step; }

size_t Octree::memory_bytes() const {
  size_t bytes = impl_->count * 16 + impl_->leaf_first.size() * sizeof(uint32_t);
  for (const auto& level : impl_->levels) bytes += level.size() * sizeof(BoxBlock);
  for (const auto& level : impl_->exact_levels) bytes += level.size() * sizeof(ExactBlock);
  return bytes;
}

std::vector<uint64_t> Octree::cell_counts(Task& task) const {
  struct Counts {
    std::array<uint64_t, kMaxLevel + 1>
        begins{};  // cells that begin at this level and, so, at all deeper ones
    Counts& operator+=(const Counts& b) {
      for (size_t i = 0; i < begins.size(); ++i) begins[i] += b.begins[i];
      return *this;
    }
  };
  constexpr size_t kGrain = size_t{1} << 16;
  const Counts sum = parallel_reduce(task, size(), kGrain, Counts{}, [&](size_t begin, size_t end) {
    Counts counts;
    uint64_t before = begin == 0 ? 0 : code(begin - 1);
    for (size_t i = begin; i < end; ++i) {
      const uint64_t here = code(i), differing = here ^ before;
      if (i == 0) ++counts.begins[0];
      else if (differing !=
               0)  // 2.1 step 5: highest differing bit b: new cells from level N - b / 3 on
        ++counts.begins[static_cast<size_t>(kMaxLevel - (63 - std::countl_zero(differing)) / 3)];
      before = here;
    }
    return counts;
  });
  std::vector<uint64_t> out(sum.begins.begin(), sum.begins.end());
  for (size_t level = 1; level < out.size(); ++level) out[level] += out[level - 1];
  return out;
}

namespace {

void require_level(int level) {
  if (level < 0 || level > kMaxLevel)
    fail(Status::kInvalidArgument, "level %d is outside 0 ... %d", level, kMaxLevel);
}

}  // namespace

std::vector<Octree::Cell> Octree::cells(int level, Task& task) const {
  require_level(level);
  constexpr size_t kGrain = size_t{1} << 16;
  const int shift = 3 * (kMaxLevel - level);
  std::vector<std::vector<Cell>> parts((size() + kGrain - 1) / kGrain);
  parallel_for(task, size(), kGrain, [&](size_t begin, size_t end) {
    auto& part = parts[begin / kGrain];
    uint64_t before = begin == 0 ? ~uint64_t{0} : code(begin - 1) >> shift;
    for (size_t i = begin; i < end; ++i) {
      const uint64_t here = code(i) >> shift;
      if (here != before) part.push_back({here, i, 0});
      before = here;
    }
  });
  std::vector<Cell> out;
  size_t total = 0;
  for (const auto& part : parts) total += part.size();
  out.reserve(total);
  for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
  for (size_t c = 0; c < out.size(); ++c)
    out[c].count = (c + 1 < out.size() ? out[c + 1].first : size()) - out[c].first;
  return out;
}

Octree::Cell Octree::cell(int level, uint64_t wanted) const {
  require_level(level);
  if (level < kMaxLevel && wanted >> 3 * level != 0) return {wanted, 0, 0};
  const int shift = 3 * (kMaxLevel - level);
  const size_t first = impl_->lower_bound(wanted, shift, 0, size());
  const size_t last = impl_->lower_bound(wanted + 1, shift, first, size());
  return {wanted, first, last - first};
}

std::vector<uint64_t> Octree::neighbour_cells(int level, uint64_t centre, uint32_t reach) const {
  require_level(level);
  if (centre >> 3 * level != 0)
    fail(Status::kInvalidArgument, "code %llu has more than %d bits",
         static_cast<unsigned long long>(centre), 3 * level);
  const CellNumbers c = cell_numbers(centre);
  const int64_t side = int64_t{1} << level;
  const auto low = [&](uint32_t v) { return std::max<int64_t>(0, int64_t{v} - reach); };
  const auto high = [&](uint32_t v) { return std::min<int64_t>(side - 1, int64_t{v} + reach); };
  std::vector<uint64_t> out;
  const double volume = static_cast<double>(high(c.p) - low(c.p) + 1) *
                        static_cast<double>(high(c.q) - low(c.q) + 1) *
                        static_cast<double>(high(c.r) - low(c.r) + 1);
  const int shift = 3 * (kMaxLevel - level);
  if (volume > static_cast<double>(size())) {  // wide reach: look at the occupied cells instead
    uint64_t before = ~uint64_t{0};
    for (size_t i = 0; i < size(); ++i) {
      const uint64_t here = code(i) >> shift;
      if (here == before) continue;
      before = here;
      const CellNumbers n = cell_numbers(here);
      if (here != centre && n.p >= low(c.p) && n.p <= high(c.p) && n.q >= low(c.q) &&
          n.q <= high(c.q) && n.r >= low(c.r) && n.r <= high(c.r))
        out.push_back(here);
    }
    return out;
  }
  for (int64_t p = low(c.p); p <= high(c.p); ++p)
    for (int64_t q = low(c.q); q <= high(c.q); ++q)
      for (int64_t r = low(c.r); r <= high(c.r); ++r) {
        const uint64_t code = morton_code(static_cast<uint32_t>(p), static_cast<uint32_t>(q),
                                          static_cast<uint32_t>(r));
        if (code != centre && cell(level, code).count != 0) out.push_back(code);
      }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace jalon
