// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/setting_rows.h"
#include "scan/mobile/georeference_rows.h"
#include "scan/mobile/mobile_scan.h"

namespace jalon {

namespace {

constexpr auto kMobileRows = setting_rows(
    number_row<&MobileSettings::revolutions_per_s>("revolutions_per_s", 0.01, 1000, "1/s", "mobile",
                                                   "Turns of the mirror or head a second."),
    integer_row<&MobileSettings::pulses>("pulses", 1, 1e6, "", "mobile",
                                         "Pulses a revolution, of each beam."),
    integer_row<&MobileSettings::beams>("beams", 1, 256, "", "mobile",
                                        "1: a plane scanner, across the scanner's z axis; more: a "
                                        "rotating head with a fan of them."),
    number_row<&MobileSettings::fan_rad>("fan_rad", 0, 3, "rad", "mobile",
                                         "From the first to the last beam of the fan."),
    number_row<&MobileSettings::min_range_m>("min_range_m", 0, 1000, "m", "mobile",
                                             "Least range: nearer returns are lost."),
    number_row<&MobileSettings::max_range_m>("max_range_m", 0.1, 100000, "m", "mobile",
                                             "Greatest range: farther returns are lost."),
    number_row<&MobileSettings::noise_range_m>("noise_range_m", 0, 10, "m", "mobile",
                                               "Standard deviation of the ranges drawn."),
    number_row<&MobileSettings::noise_angle_rad>("noise_angle_rad", 0, 1, "rad", "mobile",
                                                 "Standard deviation of both angles drawn."),
    integer_row<&MobileSettings::seed>("seed", 0, 1e15, "", "mobile", "Of the noise."),
    nested_rows<&MobileSettings::mount, kGeoreferenceRows>());

}  // namespace

std::span<const ParamRow> mobile_scanner_rows() { return kMobileRows; }

}  // namespace jalon
