/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Arrays of a fixed shape on their way in: points, boxes, covariances, poses. The shape is checked where there is one;
 * flat numbers stand row by row. */
#ifndef JALON_BINDINGS_SMALL_ARRAYS_H
#define JALON_BINDINGS_SMALL_ARRAYS_H

#include "arrays.h"

namespace jalon_binding {

/** Whether the last row of a 4 x 4 matrix is 0 0 0 1. */
inline bool is_homogeneous(const double* matrix) {
  return matrix[12] == 0 && matrix[13] == 0 && matrix[14] == 0 && matrix[15] == 1;
}

/** So many rows and columns: a point (1 x 3), a box (2 x 3), a covariance (3 x 3), a map (3 x 4, or 4 x 4). */
class Numbers12 {
 public:
  Numbers12(const ArrayIn* array, std::uint32_t rows, std::uint32_t columns, const char* name)
      : given_(array != nullptr) {
    if (!given_) return;
    const std::uint64_t wanted = rows * columns;
    const std::uint64_t elements = array->count * array->components;
    const bool is_map = rows == 3 && columns == 4;
    if (elements != wanted && !(is_map && elements == 16)) {
      throw Failure{JALON_ERROR_INVALID_ARGUMENT, std::string(name) + " must have " +
                                                      std::to_string(wanted) + " numbers" +
                                                      (is_map ? " (3 x 4), or 16 (4 x 4)" : "") +
                                                      ", not " + std::to_string(elements)};
    }
    const bool has_shape = !array->flat && array->count > 1;
    if (has_shape && array->components != columns) {
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    std::string(name) + " must be " + std::to_string(rows) + " x " +
                        std::to_string(columns) + (is_map ? " or 4 x 4" : "") + ", not " +
                        std::to_string(array->count) + " x " + std::to_string(array->components)};
    }
    const Packed<double> packed(array, array->components, name);
    if (elements != wanted && !is_homogeneous(packed.data())) {
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    std::string(name) + " must have the last row 0 0 0 1"};
    }
    std::memcpy(values_, packed.data(), wanted * sizeof(double));
  }
  /** As one of the C structs of doubles; NULL where nothing was given. */
  template <class Struct>
  const Struct* as() const {
    return given_ ? reinterpret_cast<const Struct*>(values_) : nullptr;
  }

 private:
  bool given_;
  double values_[12] = {};
};

/**
 * Poses one behind the other, all 3 x 4 or all 4 x 4: a row a pose (12 or 16 numbers), their rows of four, or flat.
 * Where the shape does not tell which, they are 4 x 4 when every sixteenth number closes a row 0 0 0 1: the first row
 * of a rotation, which a 3 x 4 pose has at one of these places, is never 0 0 0.
 */
class Poses {
 public:
  Poses(const ArrayIn* array, const char* name) : given_(array != nullptr) {
    if (!given_) return;
    const std::uint64_t elements = array->count * array->components;
    const Packed<double> packed(array, array->components, name);
    const bool a_row_a_pose = !array->flat && (array->components == 12 || array->components == 16);
    const bool open = array->flat || array->components == 4;
    if (elements != 0 && !a_row_a_pose && !open) refuse(array, name);
    const bool square =
        a_row_a_pose ? array->components == 16 : are_square(packed.data(), elements);
    if (elements % (square ? 16 : 12) != 0) refuse(array, name);
    for (std::uint64_t i = 0; i < elements; i += square ? 16 : 12) {
      const double* pose = packed.data() + i;
      if (square && !is_homogeneous(pose)) {
        throw Failure{
            JALON_ERROR_INVALID_ARGUMENT,
            std::string(name) + "[" + std::to_string(i / 16) + "] must have the last row 0 0 0 1"};
      }
      values_.insert(values_.end(), pose, pose + 12);
    }
    values_.push_back(0);  // so that no poses are not taken for none given
  }
  const jalon_transform* data() const {
    return given_ ? reinterpret_cast<const jalon_transform*>(values_.data()) : nullptr;
  }
  std::uint64_t count() const { return values_.size() / 12; }

 private:
  static bool are_square(const double* numbers, std::uint64_t elements) {
    if (elements % 16 != 0) return false;
    bool square = true;
    for (std::uint64_t i = 0; square && i < elements; i += 16) square = is_homogeneous(numbers + i);
    return square || elements % 12 != 0;
  }
  [[noreturn]] static void refuse(const ArrayIn* array, const char* name) {
    const std::string shape =
        array->flat ? std::to_string(array->count) + " numbers"
                    : std::to_string(array->count) + " x " + std::to_string(array->components);
    throw Failure{
        JALON_ERROR_INVALID_ARGUMENT,
        std::string(name) + " must be 12 numbers a pose (3 x 4), or 16 (4 x 4), not " + shape};
  }

  bool given_;
  std::vector<double> values_;
};

}  // namespace jalon_binding

#endif
