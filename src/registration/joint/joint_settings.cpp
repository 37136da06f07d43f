// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/joint_settings.h"

#include "base/setting_rows.h"

namespace jalon {

namespace {

using S = JointSettings;
constexpr double kGreatestBias_rad = 0.2;  // 11 degrees: beyond, axes are mixed up
constexpr auto kJointRows = setting_rows(
    number_row<&S::sigma_block_x_m>("sigma_block_x_m", 0, 1000, "m", "",
                                    "Standard deviation of a block's place, east."),
    number_row<&S::sigma_block_y_m>("sigma_block_y_m", 0, 1000, "m", "",
                                    "Standard deviation of a block's place, north."),
    number_row<&S::sigma_facade_m>("sigma_facade_m", 0, 1000, "m", "",
                                   "Standard deviation of a facade along its normal: the eaves "
                                   "were digitised, the wall stands back."),
    number_row<&S::sigma_strip_m>("sigma_strip_m", 0, 1000, "m", "",
                                  "Standard deviation of a strip along the normal: relief."),
    choice_row<&S::set_back>(
        "set_back", "either|behind", "",
        "Where walls stand beside their facades as given: before or behind, or never before "
        "(behind), as where facades were digitised at the eaves."),
    number_row<&S::strip_correlation_m>(
        "strip_correlation_m", 0, 1000, "m", "",
        "Strips of a facade hang together: the correlation of their offsets is 1/e at this "
        "distance along it, less beyond; 0: not at all."),
    number_row<&S::sigma_roll_bias_rad>(
        "sigma_roll_bias_rad", 0, kGreatestBias_rad, "rad", "",
        "Standard deviation of a constant error of the attitudes about the vehicle's forward "
        "axis, which is adjusted with the rest; 0: there is none."),
    number_row<&S::sigma_pitch_bias_rad>("sigma_pitch_bias_rad", 0, kGreatestBias_rad, "rad", "",
                                         "The same about the axis across the vehicle."),
    number_row<&S::sigma_heading_bias_rad>("sigma_heading_bias_rad", 0, kGreatestBias_rad, "rad",
                                           "", "The same about the vehicle's upright axis."),
    number_row<&S::sigma_ground_m>(
        "sigma_ground_m", 0, 1000, "m", "",
        "Standard deviation of the model's ground, by which the drive's heights are adjusted; 0: "
        "they stay."),
    number_row<&S::ground_correlation_m>(
        "ground_correlation_m", 0.01, 1e5, "m", "",
        "The ground's errors hang together: distance driven after which their correlation is 1/e."),
    doubles_row<&S::control_points>(
        "control_points", -1e9, 1e9, "", "",
        "Points whose place is known, six numbers each: when it was seen (s), x and y that the "
        "cloud has (m), x and y that are right (m), standard deviation of a coordinate (m)."),
    number_row<&S::control_s>("control_s", 0.01, 3600, "s", "",
                              "From one control time of the trajectory to the next; between them "
                              "corrections are linear."),
    choice_row<&S::matches>(
        "matches", "rays|ids", "",
        "Which strip a point is on: the first that its own ray meets, or what the cloud's field "
        "\"strip\" says."),
    choice_row<&S::bound>("bound", "logarithm|normal", "",
                          "Greatest distance of a point from its strip, in standard deviations: "
                          "-log(refused_share), or "
                          "the normal distribution's for that share."),
    number_row<&S::refused_share>("refused_share", 1e-9, 0.5, "1", "",
                                  "Share of right matches that may be refused."),
    bool_row<&S::occluders>("occluders", "", "Roofs and ground of the model hide what is behind."),
    doubles_row<&S::lever_arm_m>(
        "lever_arm_m", -1e3, 1e3, "m", "",
        "Offset of the laser from the inertial unit, in the vehicle's frame; of clouds without "
        "beam_origin."),
    number_row<&S::thin_m>("thin_m", 0, 100, "m", "",
                           "One point a cube of this edge is matched; 0: all."),
    number_row<&S::least_score>(
        "least_score", 0, 1, "1", "",
        "Points that look less like a vertical wall are not matched; 0: all are."),
    number_row<&S::greatest_turn_rad>("greatest_turn_rad", 0, 1.6, "rad", "",
                                      "A point of a wall that is turned from the strip by more is "
                                      "not matched (needs least_score)."),
    integer_row<&S::least_points>("least_points", 1, 1e6, "", "",
                                  "A strip with fewer points is not adjusted."),
    number_row<&S::sigma_point_m>(
        "sigma_point_m", 0, 10, "m", "",
        "Noise of a single point along the normal; 0: a strip passes through "
        "the centroid of its points exactly."),
    choice_row<&S::kernel>(
        "kernel", "tukey|none", "",
        "Points off the median of their strip count less, and strips that contradict "
        "the others (tukey); or all alike (none)."),
    bool_row<&S::exchange>("exchange", "",
                           "A facade that stands on the wall of another makes room for it, and "
                           "where nothing tells whose wall it is neither is adjusted (kernel "
                           "tukey, matches by rays)."),
    integer_row<&S::most_passes>("most_passes", 1, 1000, "", "", "Greatest number of passes."),
    number_row<&S::tolerance_m>("tolerance_m", 0, 1, "m", "",
                                "A pass that moves nothing by a greater distance is the last; so "
                                "is one that matches as the "
                                "one before."),
    bool_row<&S::covariance>("covariance", "",
                             "Keep the whole covariance of what covariance_of says."),
    choice_row<&S::covariance_of>(
        "covariance_of", "places|all", "",
        "What \"covariance\" keeps: that of trajectory, blocks and turns (places), or facades and "
        "the strips that were adjusted as well (all)."));

}  // namespace

std::span<const ParamRow> joint_rows() { return kJointRows; }

}  // namespace jalon
