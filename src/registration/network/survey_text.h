// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "registration/network/network_settings.h"
#include "registration/network/survey.h"

namespace jalon {

/// Reads a list of points and one of observations. The first line of either names the columns; cells are parted by ";",
/// tabs, "," or blanks, whichever the first line has; "-" or nothing stands for what is not known. Blank lines and
/// those that begin with # are passed over.
///
/// points: id, x, y, z, sx, sy, sz (m; 0: fixed), code. Only "id" must be there; may be "" as a whole.
/// observations: from, to, direction, zenith, distance, instrument_height, target_height, setup, sigma_direction,
/// sigma_zenith, sigma_distance, code. A setup ends where "from" or "setup" changes. Zenith angles beyond half a
/// circle are of the second face and are turned to the first one, with their directions.
///
/// Error(kFormat) names list, line and cell.
Survey read_survey(std::string_view points, std::string_view observations, AngleUnit unit);

}  // namespace jalon
