// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ifc/bodies.h"

#include <doctest/doctest.h>

#include <map>
#include <regex>
#include <sstream>
#include <utility>

#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::ifc;
using namespace jalon::test;

namespace {

constexpr Vec3 kCorner{652000.5, 6861000, 100.25}, kOrigin{652000, 6861000, 100};

// 4 m by 3 m, seen from the south, with a window of 1 m2 and a hole of 0.25 m2 that belongs to nothing.
Model wall() {
  Model model;
  model.parts = {{"wall", "wall"}, {"window", "window"}};
  Face face;
  face.plane = {{0, -1, 0}, 0};
  const auto at = [](double x, double z) { return kCorner + Vec3{x, 0, z}; };
  model.add_face(face, {{at(0, 0), at(4, 0), at(4, 3), at(0, 3)},
                        {at(1, 1), at(1, 2), at(2, 2), at(2, 1)},
                        {at(3, 1), at(3, 1.5), at(3.5, 1.5), at(3.5, 1)}});
  model.rings[1].part = 1;
  return model;
}

/// A face set of a file: whether each edge has its opposite, its volume, and the area of its faces.
struct Read {
  bool is_closed = true;
  double volume_m3 = 0, area_m2 = 0;
  size_t faces = 0;
};

template <class Write>
Read written(const Model& model, Write&& write) {
  const Folder folder;
  {
    AtomicFile file(folder.file("a.ifc"));
    StepFile step(file, "V", "n");
    Bodies bodies(model, kOrigin, step);
    REQUIRE(write(bodies).size() == 1);
    step.end();
    file.commit();
  }
  std::istringstream lines(slurp(folder.file("a.ifc")));
  std::vector<Vec3> places;
  std::map<std::pair<int, int>, int> edges;
  Read out;
  const std::regex number("-?[0-9]+\\.?[0-9]*(E[-+][0-9]+)?"), loops("\\(([0-9,]+)\\)");
  for (std::string line; std::getline(lines, line);) {
    const size_t values = line.find('(');
    if (line[0] != '#' || values == std::string::npos) continue;
    const std::string text = line.substr(values);
    if (line.find("=IFCCARTESIANPOINTLIST3D") != std::string::npos) {
      std::vector<double> all;
      for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end; ++i)
        all.push_back(std::stod(i->str()));
      for (size_t i = 0; i + 2 < all.size(); i += 3)
        places.push_back({all[i], all[i + 1], all[i + 2]});
    } else if (line.find("=IFCINDEXEDPOLYGONALFACE") != std::string::npos) {
      ++out.faces;
      Vec3 twice;
      for (std::sregex_iterator i(text.begin(), text.end(), loops), end; i != end; ++i) {
        std::vector<int> loop;
        std::istringstream items((*i)[1]);
        for (std::string item; std::getline(items, item, ',');) loop.push_back(std::stoi(item) - 1);
        for (size_t k = 0; k < loop.size(); ++k) {
          const int a = loop[k], b = loop[(k + 1) % loop.size()];
          ++edges[{a, b}];
          twice += cross(places[static_cast<size_t>(a)], places[static_cast<size_t>(b)]);
          if (k + 1 < loop.size() && k > 0) {
            const Vec3& p = places[static_cast<size_t>(loop[0])];
            out.volume_m3 +=
                dot(p, cross(places[static_cast<size_t>(a)], places[static_cast<size_t>(b)])) / 6;
          }
        }
      }
      out.area_m2 += norm(twice) / 2;
    }
  }
  for (const auto& [edge, count] : edges)
    out.is_closed = out.is_closed && count == 1 && edges.contains({edge.second, edge.first});
  return out;
}

}  // namespace

TEST_CASE("ifc_bodies__a_surface_keeps_its_holes_and_its_area") {
  const Model model = wall();
  const Read read = written(model, [](Bodies& bodies) { return bodies.items_of({{}, {0}, {}}); });
  CHECK(read.faces == 1);
  CHECK(read.area_m2 == doctest::Approx(12 - 1 - 0.25));
}

TEST_CASE("ifc_bodies__a_wall_of_a_thickness_is_closed_and_leaves_openings_to_their_cuts") {
  const Model model = wall();
  const Read body = written(model, [](Bodies& bodies) {
    return bodies.walls_of({{}, {0}, {}}, 0.3);
  });
  CHECK(body.is_closed);
  CHECK(body.volume_m3 == doctest::Approx((12 - 0.25) * 0.3));
  const Read cut = written(model, [](Bodies& bodies) { return bodies.cuts_of({{0, 1}}, 0.3); });
  CHECK(cut.is_closed);
  CHECK(cut.volume_m3 == doctest::Approx(1 * (0.3 + 0.1)));
  const Read outline = written(model, [](Bodies& bodies) { return bodies.outlines_of({{0, 1}}); });
  CHECK(outline.area_m2 == doctest::Approx(1));
}

TEST_CASE("ifc_bodies__rings_that_are_one_place_are_left_out") {
  Model model = wall();
  for (uint64_t i = 0; i < 4; ++i)
    model.vertices[model.corners[model.rings[2].first + i]] = kCorner + Vec3{3, 0, 1};
  const Read body = written(model, [](Bodies& bodies) {
    return bodies.walls_of({{}, {0}, {}}, 0.5);
  });
  CHECK(body.is_closed);
  CHECK(body.volume_m3 == doctest::Approx(12 * 0.5));
}
