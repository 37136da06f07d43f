// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/pictures/orthoimage.h"

namespace jalon {

/// The points of a cloud that an orthoimage of a facade shows: in its box on the sheet, near its front plane.
class OrthoPoints {
 public:
  /// Error(kInsufficientData) where there are none, or where the cloud has not what the settings want to see.
  OrthoPoints(const Cloud& cloud, const PlacedFacade& facade, const OrthoimageSettings& settings,
              Task& task);

  OrthoContent content() const { return content_; }
  /// Mean spacing on the part of the facade that they cover.
  double spacing_m(Task& task) const;
  /// Fills the pixels of an image that is laid out.
  void draw(Orthoimage& image, Task& task) const;

 private:
  const Column* column(const char* name) const;
  bool has_colour() const;
  void find_inside(double in_front_m, double behind_m, Task& task);
  template <class F>
  void for_each(double from, double to, Task& task, F&& use) const;
  template <class F>
  void for_each_of(size_t together, F&& use) const;

  const Cloud& cloud_;
  const PlacedFacade& facade_;
  OrthoContent content_;
  std::vector<std::vector<uint16_t>> inside_;  ///< of each 65 536 points in turn
  uint64_t count_ = 0;
};

}  // namespace jalon
