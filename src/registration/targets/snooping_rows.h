// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/setting_rows.h"
#include "registration/targets/settings.h"

namespace jalon {

/// Rows for whoever tests by SnoopingSettings.
inline constexpr auto kSnoopingRows = setting_rows(
    choice_row<&SnoopingSettings::sigma0>(
        "sigma0", "known|estimated", "",
        "Of unit weight: known, covariances are taken as they stand (Baarda's test); "
        "estimated, the residuals scale them, so that only their proportions count (Pope's "
        "test)."),
    number_row<&SnoopingSettings::significance>("significance", 1e-9, 0.5, "1", "",
                                                "Chance that the test of one good target or "
                                                "observation calls it an outlier (Baarda 1968)."),
    number_row<&SnoopingSettings::power>(
        "power", 0.5, 0.999, "1", "",
        "Chance that the test finds a blunder of the size given as detectable."));

}  // namespace jalon
