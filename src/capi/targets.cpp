// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/targets.h"

#include "capi/support/guard.h"
#include "registration/targets/measure.h"
#include "registration/targets/recognition.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

constexpr uint64_t kMostPlaces = 1'000'000;

static_assert(JALON_TARGET_SPHERE == static_cast<int>(TargetKind::kSphere));
static_assert(JALON_TARGET_CHECKER == static_cast<int>(TargetKind::kChecker));
static_assert(JALON_TARGET_DISC == static_cast<int>(TargetKind::kDisc));
static_assert(JALON_TARGET_PATCH == static_cast<int>(TargetKind::kPatch));

static_assert(JALON_RECOGNISED_KNOWN == static_cast<int>(TargetVerdict::kKnown));
static_assert(JALON_RECOGNISED_AMBIGUOUS == static_cast<int>(TargetVerdict::kAmbiguous));
static_assert(JALON_RECOGNISED_FOREIGN == static_cast<int>(TargetVerdict::kForeign));
static_assert(JALON_RECOGNISED_UNCERTAIN == static_cast<int>(TargetVerdict::kUncertain));

std::vector<Vec3> places_from(const double* places, uint64_t count) {
  if (count > 0) require(places, "places");
  if (count > kMostPlaces)
    fail(Status::kLimit, "%llu places; at most a million", static_cast<unsigned long long>(count));
  std::vector<Vec3> out;
  for (uint64_t i = 0; i < count; ++i) {
    out.push_back({places[3 * i], places[3 * i + 1], places[3 * i + 2]});
    if (!is_finite(out.back()))
      fail(Status::kInvalidArgument, "place %llu is not finite",
           static_cast<unsigned long long>(i));
  }
  return out;
}

}  // namespace

jalon_status jalon_cloud_measure_targets(const jalon_cloud* cloud, const double* places,
                                         uint64_t count, const jalon_params* options,
                                         jalon_task* task, jalon_fields** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    const auto chosen = settings_from<MeasuringSettings>(options_or_default(options, "target"));
    const std::vector<Vec3> list = places_from(places, count);
    *out = with_task(task, [&](Task& t) {
             return own(new_fields(measure_targets(*cloud->cloud, list, chosen, t)));
           }).release();
  });
}
