// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/field.h"
#include "formats/las/layout.h"

// The standard dimensions of LAS points as fields of a cloud, and where each lies in the record of
// each format.
namespace jalon::las {

/// Where a dimension lies: an integer of 1, 2, 4 or 8 bytes, or a float; of a byte, `bits` bits
/// from `shift` on (0 = all).
struct Place {
  ElementType type;
  int offset = -1;
  int shift = 0, bits = 0;
  double factor = 1;  ///< stored number times factor = field value
};

/// The fields of a wave packet, in the order of the record.
inline constexpr const char* kWaveNames[] = {"wavepacket_index",
                                             "wavepacket_offset",
                                             "wavepacket_size",
                                             "return_point_wave_location",
                                             "x_t",
                                             "y_t",
                                             "z_t"};

struct Dimension {
  FieldInfo field;
  Place place;
};

/// The dimensions of a point format in the order of the record.
std::vector<Dimension> dimensions(unsigned format_id);

/// What an extra dimension is called that holds the exact values of a field whose standard dimension
/// cannot: programs refuse two dimensions of one name. Read again it is the field.
std::string exact_name(const std::string& field);
/// The field that such a dimension of a file of this format is of, or the name as it is.
std::string field_of_exact(unsigned format_id, const std::string& name);

}  // namespace jalon::las
