// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The section of a page: its texts cannot leave it, its script is the one that the policy lets run, its pose is true.
#include "report/viewer/view_page.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "base/random.h"
#include "report/viewer/script.h"
#include "unit/report/markup.h"
#include "unit/report/viewer/viewed.h"

using namespace jalon;
using viewed::random_cloud;

namespace {

std::string section_of(const ViewScene& scene, int64_t most = 1000000) {
  Task task;
  Page page;
  add_viewer(page, scene, most, task);
  return page.html().take();
}

std::string script_of(const std::string& html, const std::string& id) {
  for (const auto& tag : markup::tags(html))
    if (tag.name == "script" && tag.attribute("id") == id) return tag.text_after;
  return {};
}

ViewScene scene_of(CloudPtr cloud) {
  ViewScene scene;
  scene.clouds.push_back({"scan", std::move(cloud), {}, {}, false, {}});
  return scene;
}

}  // namespace

TEST_CASE("view_page__hostile_names_stay_text") {
  ViewScene scene = scene_of(random_cloud(10, 1, {0, 0, 0}, 1));
  const std::string bad = "</script><script>alert(1)</script><!--\"\\'&\xff";
  scene.clouds[0].name = bad;
  scene.labels = {bad};
  scene.parts.push_back({bad, bad, {}, true, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}});
  const std::string html = section_of(scene);
  CHECK(markup::well_formed(html));
  size_t scripts = 0;
  for (const auto& tag : markup::tags(html)) scripts += tag.name == "script" ? 1 : 0;
  CHECK(scripts == 3);  // the scene, the points, the program
  const auto json = nlohmann::json::parse(script_of(html, "view-scene"));
  CHECK(json["parts"][0]["text"].get<std::string>().starts_with("</script><script>alert(1)"));
}

TEST_CASE("view_page__the_policy_lets_this_script_run_and_nothing_be_loaded") {
  const std::string html = section_of(scene_of(random_cloud(10, 1, {0, 0, 0}, 1)));
  CHECK(script_of(html, "") == kViewerScript);
  CHECK(std::string(kViewerScriptSha256).size() == 64);
  const std::string policy = content_policy();
  CHECK(policy.starts_with("default-src 'none';"));
  CHECK(policy.find("script-src 'sha256-") != std::string::npos);
  CHECK(policy.find("http") == std::string::npos);
  CHECK(policy.find("unsafe-eval") == std::string::npos);
  for (const char* word : {"fetch(", "XMLHttpRequest", "import(", "eval(", "innerHTML", "//"})
    CHECK_MESSAGE(std::string(kViewerScript).find(word) == std::string::npos, word);
}

TEST_CASE("view_page__the_pose_takes_steps_to_the_scene_in_coordinates_of_seven_digits") {
  ViewScene scene = scene_of(random_cloud(100, 2, {10, 20, 30}, 4));
  scene.clouds[0].pose.m = {0, -1, 0, 652000.25, 1, 0, 0, 6861000.5, 0, 0, 1, 100};
  const auto json = nlohmann::json::parse(script_of(section_of(scene), "view-scene"));
  const auto& cloud = json["clouds"][0];
  const std::vector<double> m = cloud["pose"], origin = json["origin"];
  for (const double v : origin) CHECK(v == std::floor(v));
  viewed::Reader reader{{}, 100};
  // The corner of the packed box, where the pose puts it.
  const auto& source = *scene.clouds[0].cloud;
  Vec3 low = source.point(0);
  for (size_t i = 1; i < source.size(); ++i)
    for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], source.point(i)[k]);
  const Vec3 placed = scene.clouds[0].pose.point(low);
  for (size_t k = 0; k < 3; ++k)
    CHECK(std::fabs(m[12 + k] + origin[k] - placed[static_cast<int>(k)]) <= 1e-6);
  CHECK(m[0] == 0);
  CHECK(m[1] == 1);  // x of the cloud is y of the world
  CHECK(m[4] == -1);
}

TEST_CASE("view_page__clouds_share_the_points_by_their_sizes_and_0_or_nothing_gives_no_section") {
  ViewScene scene = scene_of(random_cloud(3000, 1, {0, 0, 0}, 1));
  scene.clouds.push_back({"b", random_cloud(1000, 2, {0, 0, 0}, 1), {}, {}, false, {}});
  const std::string html = section_of(scene, 400);
  const auto json = nlohmann::json::parse(script_of(html, "view-scene"));
  CHECK(json["clouds"][0]["n"] == 300);
  CHECK(json["clouds"][1]["n"] == 100);
  CHECK(html.find("400 of 4 000 points") != std::string::npos);
  CHECK(section_of(scene, 0).empty());
  CHECK(section_of(scene_of(std::make_shared<const Cloud>())).empty());
  CHECK(section_of({}).empty());
}
