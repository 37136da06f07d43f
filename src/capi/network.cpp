// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/network.h"

#include "capi/support/guard.h"
#include "capi/support/network_handles.h"
#include "registration/network/network_tables.h"
#include "registration/network/survey_text.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

// What a getter of a table does.
void give_network_table(const jalon_network* network, jalon_fields** out,
                        FieldTable (*table)(const NetworkAdjustment&)) {
  require(network, "network");
  require(out, "out");
  *out = new_fields(table(network->network));
}

}  // namespace

jalon_status jalon_network_adjust(const char* observations, const char* points,
                                  const jalon_params* options, jalon_task* task,
                                  jalon_network** out) {
  return guard([&] {
    require(observations, "observations");
    require(out, "out");
    const ParamSet values = options_or_default(options, "network");
    const auto settings = settings_from<NetworkSettings>(values);
    auto handle = std::make_unique<jalon_network>();
    handle->parameters = values.to_json();
    with_task(task, [&](Task& t) {
      Survey survey =
          read_survey(points == nullptr ? "" : points, observations, settings.angle_unit);
      handle->network = adjust_network(std::move(survey), settings, t);
      handle->codes = network_codes(handle->network);
    });
    *out = handle.release();
  });
}

jalon_network* jalon_network_retain(jalon_network* network) { return retain(network); }
void jalon_network_release(jalon_network* network) { release(network); }

jalon_status jalon_network_summary(const jalon_network* network, jalon_fields** out) {
  return guard([&] { give_network_table(network, out, network_summary); });
}
jalon_status jalon_network_points(const jalon_network* network, jalon_fields** out) {
  return guard([&] { give_network_table(network, out, network_points); });
}
jalon_status jalon_network_observations(const jalon_network* network, jalon_fields** out) {
  return guard([&] { give_network_table(network, out, network_observations); });
}

jalon_status jalon_network_point_name(const jalon_network* network, uint64_t i, const char** out) {
  return guard([&] {
    require(network, "network");
    require(out, "out");
    const auto& points = network->network.survey.points;
    if (i >= points.size())
      fail(Status::kInvalidArgument, "point %llu of %llu", static_cast<unsigned long long>(i),
           static_cast<unsigned long long>(points.size()));
    *out = points[i].id.c_str();
  });
}

jalon_status jalon_network_codes(const jalon_network* network, const char** out) {
  return guard([&] {
    require(network, "network");
    require(out, "out");
    *out = network->codes.c_str();
  });
}

jalon_status jalon_network_parameters(const jalon_network* network, const char** out) {
  return guard([&] {
    require(network, "network");
    require(out, "out");
    *out = network->parameters.c_str();
  });
}
