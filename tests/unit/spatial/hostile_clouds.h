// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "base/random.h"

namespace jalon::test {

/// Clouds that are hard on the grid of an octree; see hostile_clouds().
struct HostileCloud {
  const char* name;
  std::vector<double> xyz;
};

/// n points each: the grid of 2^31 steps tells few of them apart, or none.
inline std::vector<HostileCloud> hostile_clouds(int n) {
  RandomStream random(21, 0);
  std::vector<HostileCloud> out;
  const auto add = [&](const char* name, auto point) {
    std::vector<double> xyz;
    for (int i = 0; i < n; ++i) {
      double p[3] = {random.uniform(), random.uniform(), random.uniform()};
      point(i, p);
      xyz.insert(xyz.end(), p, p + 3);
    }
    out.push_back({name, std::move(xyz)});
  };
  const auto halves = [](int i, double* p, double sign) {
    p[0] = std::ldexp(sign, -(i % 900));
    p[1] = std::ldexp(sign, -(i % 600));
    p[2] = std::ldexp(sign * p[2], -(i % 300));
  };
  add("halving", [&](int i, double* p) { halves(i, p, 1); });
  add("halving on both sides of zero", [&](int i, double* p) { halves(i, p, i % 7 < 3 ? -1 : 1); });
  add("a line of geometric steps", [n](int i, double* p) {
    p[0] = std::exp(-700.0 * i / n);
    p[1] = p[2] = 0;
  });
  add("steps whose squares vanish", [n](int i, double* p) {
    p[0] = std::ldexp(1.0, -540 - 400 * i / n);
    p[1] = p[2] = 0;
  });
  add("two clusters far apart", [](int i, double* p) { p[0] += i % 2 == 1 ? 1e12 : 0; });
  add("a pile, and one far away",
      [](int i, double* p) { p[0] = p[1] = p[2] = i == 17 ? 1e9 : 0.3; });
  add("half in a pile, one far away", [](int i, double* p) {
    if (i % 2 == 1) p[0] = p[1] = p[2] = 0.25;
    if (i == 17) p[1] = 3e11;
  });
  add("a point at the origin of the national grid", [](int i, double* p) {
    if (i == 17) p[0] = p[1] = p[2] = 0;
    else p[0] += 652000, p[1] += 6861000;
  });
  add("micrometres on the national grid", [](int i, double* p) {
    p[0] = 652000 + 37 * (i % 20) + 1e-5 * p[0];
    p[1] = 6861000 + 1e-5 * p[1];
    p[2] = 1e-5 * p[2];
  });
  add("some sixteen points a step", [](int i, double* p) {
    for (int axis = 0; axis < 3; ++axis) p[axis] *= i == 17 ? 0x1p31 : 5;
  });
  return out;
}

}  // namespace jalon::test
