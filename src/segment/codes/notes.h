// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include "segment/codes/coded_object.h"
#include "segment/segmentation.h"

namespace jalon {

/// What a segmentation by codes tells beside its tables, as JSON (jalon/segmenter.h says which); read_coded_notes()
/// reads it. labels: of the segments, by object; classes: points of each class that was written.
std::string coded_notes(const char* method, const CodedObjects& objects,
                        const std::vector<uint32_t>& labels, const std::vector<uint64_t>& points,
                        const std::map<int64_t, uint64_t>& classes);

}  // namespace jalon
