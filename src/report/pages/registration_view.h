// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cloud/cloud.h"
#include "registration/registration.h"
#include "report/viewer/scene.h"

namespace jalon {

/// The reference, the moving cloud in its pose, and, hidden at first, as it came.
ViewScene registration_scene(const Registration& registration, const CloudPtr& reference,
                             const CloudPtr& moving);

}  // namespace jalon
