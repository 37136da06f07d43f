// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/files/byte_source.h"

namespace jalon {

/// What all cloud readers do last: refuses the first point that is not finite, naming it, or drops
/// all of them.
Cloud finish_cloud(Cloud cloud, const ByteSource& source, bool drop_invalid, Task& task);

}  // namespace jalon
