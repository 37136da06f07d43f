// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/codes/coded_object.h"
#include "segment/codes_settings.h"
#include "segment/segmentation.h"

namespace jalon {

/// Warns of objects that hold no point, and of those with a point more than 10 m outside the cloud's box.
void warn_of_empty(const Cloud& cloud, std::span<const uint32_t> object_of_point,
                   CodedObjects& objects, Task& task);

/// The segmentation that the objects' points make: a segment each, largest first, its source_label the object's
/// number. The cloud gets (or has replaced) the field "classification"; the notes tell classes, objects and warnings.
/// object_of_point: 0 = none, else number of the object, from 1.
Segmentation coded_segmentation(const CloudPtr& cloud, std::vector<uint32_t> object_of_point,
                                const CodedObjects& objects, const CodeInput& input,
                                const char* method, Task& task);

}  // namespace jalon
