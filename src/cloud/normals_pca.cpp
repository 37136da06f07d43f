// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/normals_pca.h"

#include <algorithm>
#include <limits>

#include "cloud/plane_lanes.h"
#include "geometry/symmetric_eigen.h"

namespace jalon {

namespace {

PcaNormals new_result(size_t count, bool with_curvature) {
  PcaNormals out;
  out.normal =
      std::make_shared<Column>(FieldInfo{"normal", ElementType::kFloat32, 3, "", "unit normal of the local plane"}, count);
  if (with_curvature)
    out.curvature = std::make_shared<Column>(
        FieldInfo{"curvature", ElementType::kFloat32, 1, "", "surface variation lambda_0 / (lambda_0 + lambda_1 + lambda_2)"},
        count);
  return out;
}

/// Takes neighbourhoods one after the other and writes normals and curvatures in the caller's order, four at a time.
class PlaneWriter {
 public:
  PlaneWriter(const Octree& tree, const PcaNormals& out)
      : order_(tree.order()),
        x_(tree.grid_x()),
        y_(tree.grid_y()),
        z_(tree.grid_z()),
        normal_(out.normal->values<float>().data()),
        curvature_(out.curvature ? out.curvature->values<float>().data() : nullptr) {}
  PlaneWriter(const PlaneWriter&) = delete;
  PlaneWriter& operator=(const PlaneWriter&) = delete;

  /// The neighbours of the point at a sorted position. Grid coordinates relative to the point are exact, so the sums are the same
  /// wherever the cloud lies.
  void add(size_t centre, const uint32_t* neighbours, size_t count) {
    double sx = 0, sy = 0, sz = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    const int32_t cx = x_[centre], cy = y_[centre], cz = z_[centre];
    for (size_t j = 0; j < count; ++j) {
      const uint32_t i = neighbours[j];
      const double dx = x_[i] - cx, dy = y_[i] - cy, dz = z_[i] - cz;
      sx += dx, sy += dy, sz += dz;
      xx += dx * dx, xy += dx * dy, xz += dx * dz, yy += dy * dy, yz += dy * dz, zz += dz * dz;
    }
    const double inverse = 1 / static_cast<double>(count);
    Symmetric3& m = covariance_[filled_];
    m = {xx - sx * sx * inverse, xy - sx * sy * inverse, xz - sx * sz * inverse,
         yy - sy * sy * inverse, yz - sy * sz * inverse, zz - sz * sz * inverse};
    four_.set(filled_, m[0], m[1], m[2], m[3], m[4], m[5]);
    count_[filled_] = count;
    target_[filled_] = order_[centre];
    if (++filled_ == 4) flush();
  }

  void flush() {
    if (filled_ == 0) return;
    for (int i = filled_; i < 4; ++i) four_.set(i, 1, 0, 0, 2, 0, 3);
    four_.solve();
    for (int i = 0; i < filled_; ++i) {
      if (count_[i] < 3)
        write(i, nullptr, 0);
      else if (four_.ok[i])
        write(i, four_.normal[i], four_.variation[i]);
      else
        solve_with_care(i);
    }
    filled_ = 0;
  }

 private:
  void solve_with_care(int i) {
    const Eigen3 e = symmetric_eigen(covariance_[i]);
    // All on a line: the second eigenvalue is what rounding leaves of the largest.
    constexpr double kLine = 1e-12;
    if (!(e.values[1] > kLine * e.values[2])) return write(i, nullptr, 0);
    const double normal[3] = {e.vectors[0].x, e.vectors[0].y, e.vectors[0].z};
    write(i, normal, std::max(0.0, e.values[0]) / (e.values[0] + e.values[1] + e.values[2]));
  }
  void write(int i, const double* normal, double variation) {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    float* to = normal_ + 3 * target_[i];
    for (int c = 0; c < 3; ++c) to[c] = normal == nullptr ? kNone : static_cast<float>(normal[c]);
    if (curvature_ != nullptr) curvature_[target_[i]] = normal == nullptr ? kNone : static_cast<float>(variation);
  }

  std::span<const uint32_t> order_;
  const int32_t *x_, *y_, *z_;
  float *normal_, *curvature_;
  FourPlanes four_;
  Symmetric3 covariance_[4];
  size_t count_[4], target_[4];
  int filled_ = 0;
};

}  // namespace

PcaNormals pca_normals(const Octree& tree, uint32_t k, bool with_curvature, Task& task) {
  const PcaNormals out = new_result(tree.size(), with_curvature);
  const size_t used = std::min<size_t>(k, tree.size());  // the places behind are empty
  tree.for_each_knn(k, task, [&](const Octree::Batch& b) {
    PlaneWriter writer(tree, out);
    for (size_t i = 0; i < b.count; ++i) writer.add(b.first + i, b.neighbours + i * b.k, used);
    writer.flush();
  });
  return out;
}

PcaNormals pca_normals_radius(const Octree& tree, double radius_m, bool with_curvature, Task& task) {
  const PcaNormals out = new_result(tree.size(), with_curvature);
  tree.for_each_ball(radius_m, task, [&](const Octree::BallBatch& b) {
    PlaneWriter writer(tree, out);
    for (size_t i = 0; i < b.count; ++i)
      writer.add(b.first + i, b.neighbours + b.offsets[i], b.offsets[i + 1] - b.offsets[i]);
    writer.flush();
  });
  return out;
}

}  // namespace jalon
