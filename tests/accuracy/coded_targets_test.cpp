// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdio>
#include <chrono>

#include "coded_target_walls.h"
#include "registration/targets/recognition.h"
#include "unit/registration/target_scenes.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("coded_targets__dev") {
  const char* set = std::getenv("SET");
  const auto& kinds = set && *set == 'r' ? kReportedWalls : kDevelopedWalls;
  const uint64_t first = set && *set == 'r' ? 1000 : 0;
  const int n = std::atoi(std::getenv("N") ? std::getenv("N") : "4");
  for (const auto& kind : kinds)
    for (int d = 0; d < n; ++d) {
      const TargetWall wall = any_wall(kind, first + d);
      const Cloud cloud = scan_of(wall, first + d);
      Task task;
      const auto t0 = std::chrono::steady_clock::now();
      const auto found = recognised_targets(cloud, target_catalogue_from_json(kWallCatalogue), MeasuringSettings{}, task);
      const double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
      std::printf("SCENE %s %d dist %.1f sp %.4f obl %.0f noise %.3f points %zu time %.1f\n", kind.name.c_str(), d, wall.distance_m, wall.spacing_m, wall.oblique_rad * 57.3, wall.brightness_noise, cloud.size(), s);
      std::vector<bool> used(found.size());
      for (const auto& sheet : wall.sheets) {
        const Vec3 p = place_of(wall, sheet);
        int hit = -1;
        for (size_t i = 0; i < found.size(); ++i)
          if (!used[i] && norm(found[i].centre() - p) < (sheet.kind == TargetKind::kPatch ? sheet.half_m * 1.5 : 0.03)) { hit = (int)i; break; }
        const bool target = sheet.kind != TargetKind::kPatch;
        if (hit < 0) { if (target) {
          const double per = sheet.size_m * sheet.size_m / (wall.spacing_m * wall.spacing_m) * std::pow(std::cos(wall.oblique_rad), 2);
          std::printf("  MISS kind %d size %.3f pts %.0f\n", (int)sheet.kind, sheet.size_m, per);} continue; }
        used[hit] = true;
        const auto& f = found[hit];
        const Vec3 e = f.centre() - p;
        std::printf("  %s kind %d/%d size %.3f/%.4f +- %.4f z %.1f misfit %.3f cnr %.1f pc %.3f conf %.3f verdict %d entry %d err %.2f mm m2 %.1f pts %lu\n", target ? "HIT" : "FALSE", (int)sheet.kind, (int)f.measured.kind, sheet.size_m, f.size_m, f.size_sigma_m, (f.size_m - sheet.size_m) / std::hypot(f.size_sigma_m, 0.001), f.misfit, f.contrast_to_noise, f.pattern_confidence, f.confidence, (int)f.verdict, f.entry, norm(e) * 1e3, squared_length<3>(f.measured.covariance, {e.x, e.y, e.z}), (unsigned long)f.measured.points);
      }
      for (size_t i = 0; i < found.size(); ++i) if (!used[i]) { const auto& f = found[i];
        std::printf("  EXTRA at %.3f %.3f kind %d size %.4f misfit %.3f cnr %.1f pc %.3f conf %.3f verdict %d entry %d\n", f.centre().x, f.centre().z, (int)f.measured.kind, f.size_m, f.misfit, f.contrast_to_noise, f.pattern_confidence, f.confidence, (int)f.verdict, f.entry); }
    }
}
