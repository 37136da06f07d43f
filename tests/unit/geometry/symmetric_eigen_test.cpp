// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/symmetric_eigen.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"

using namespace jalon;

namespace {

Vec3 times(const Symmetric3& m, const Vec3& v) {
  return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[1] * v.x + m[3] * v.y + m[4] * v.z,
          m[2] * v.x + m[4] * v.y + m[5] * v.z};
}

// Values ascending, vectors a right-handed frame of eigenvectors, relative to the largest value.
void check_promises(const Symmetric3& m, const Eigen3& e) {
  double scale = 0;
  for (const double x : m) scale = std::max(scale, std::fabs(x));
  CHECK(e.values[0] <= e.values[1]);
  CHECK(e.values[1] <= e.values[2]);
  for (size_t i = 0; i < 3; ++i) {
    CHECK(norm(times(m, e.vectors[i]) - e.values[i] * e.vectors[i]) <= 1e-12 * scale);
    CHECK(std::fabs(norm(e.vectors[i]) - 1) < 2e-15);
  }
  CHECK(norm(cross(e.vectors[0], e.vectors[1]) - e.vectors[2]) < 4e-15);
}

}  // namespace

TEST_CASE("symmetric_eigen__random_matrices_of_all_sizes__values_and_frame") {
  RandomStream random(1, 4);
  for (int i = 0; i < 2000; ++i) {
    Symmetric3 m;
    const double size = std::pow(10, 200 * random.uniform() - 100);
    for (double& x : m) {
      const double share = random.below(3) == 0 ? 1e-9 : 1;
      x = size * random.normal() * share;
    }
    check_promises(m, symmetric_eigen(m));
  }
}

TEST_CASE("symmetric_eigen__known_values") {
  // 2 on the diagonal, 1 beside it: 2 - sqrt 2, 2, 2 + sqrt 2.
  const Symmetric3 chain{2, 1, 0, 2, 1, 2};
  const Eigen3 e = symmetric_eigen(chain);
  CHECK(e.values[0] == doctest::Approx(2 - std::sqrt(2.0)));
  CHECK(e.values[1] == doctest::Approx(2));
  CHECK(e.values[2] == doctest::Approx(2 + std::sqrt(2.0)));
  check_promises(chain, e);
}

TEST_CASE("symmetric_eigen__equal_values_zeros_and_singular_matrices") {
  for (const Symmetric3& m : {Symmetric3{}, Symmetric3{5, 0, 0, 5, 0, 5},
                              Symmetric3{3, 0, 0, 1, 0, 2}, Symmetric3{1, 1, 1, 1, 1, 1},
                              Symmetric3{-1, 0, 0, -1, 0, 4}, Symmetric3{1, 1e-17, 0, 1, 0, 1}})
    check_promises(m, symmetric_eigen(m));
  const Eigen3 ones = symmetric_eigen({1, 1, 1, 1, 1, 1});  // rank 1
  CHECK(ones.values[2] == doctest::Approx(3));
  CHECK(std::fabs(ones.values[1]) < 1e-15);
}
