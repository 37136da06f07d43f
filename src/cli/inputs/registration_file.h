// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/handles.h"

namespace jalon::cli {

/// Sets "registration_covariance" and "registration_centre" from what "jalon register" wrote as registration.json.
void use_registration_file(const std::string& path, jalon_params* params);

}  // namespace jalon::cli
