// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/ortho_points.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace jalon {

namespace {

constexpr size_t kPointTicks = 1 << 16;  // points between two looks at the task
constexpr double kPointsAtLeast = 9;     // a cell: so that surfaces have no empty cells (e^-9)
constexpr double kMostCells = 1e6;
constexpr double kLeastSide_m = 0.01;
constexpr double kSameSurface_m =
    0.05;  // behind the nearest point of a pixel: noise and edges, no other surface

// What makes 0 ... 255 of the values of colours: 16 bits in LAS, 8 elsewhere, or floats from 0 to 1.
double unit_of(const Column* const (&parts)[3]) {
  double most = 0;
  for (const Column* part : parts)
    for (size_t i = 0; i < part->count(); ++i) most = std::max(most, part->number(i));
  return most > 255 ? 1.0 / 256 : most > 1 ? 1 : 255;
}

// Files have the field where their scanner measured nothing, too.
bool varies(const Column& column) {
  for (size_t i = 1; i < column.count(); ++i)
    if (column.number(i) != column.number(0)) return true;
  return false;
}

}  // namespace

OrthoPoints::OrthoPoints(const Cloud& cloud, const PlacedFacade& facade,
                         const OrthoimageSettings& settings, Task& task)
    : cloud_(cloud),
      facade_(facade),
      in_front_m_(settings.in_front_m),
      behind_m_(settings.behind_m),
      content_(settings.content) {
  const bool has_intensity = column("intensity") != nullptr;
  if (content_ == OrthoContent::kAuto)
    content_ = has_colour() && (varies(*column("red")) || varies(*column("green")))
                   ? OrthoContent::kColour
               : has_intensity && varies(*column("intensity")) ? OrthoContent::kIntensity
                                                               : OrthoContent::kDistance;
  if (content_ == OrthoContent::kColour && !has_colour())
    fail(Status::kInsufficientData, "the cloud has no colours (fields red, green, blue)");
  if (content_ == OrthoContent::kIntensity && !has_intensity)
    fail(Status::kInsufficientData, "the cloud has no field \"intensity\"");
  for_each(0, 0.1, task, [&](size_t, const Vec3&) { ++count_; });
  if (count_ == 0)
    fail(Status::kInsufficientData, "no point lies near the front plane of the facade");
}

const Column* OrthoPoints::column(const char* name) const {
  const Column* found = cloud_.fields.find(name);
  return found != nullptr && found->info().components == 1 ? found : nullptr;
}

bool OrthoPoints::has_colour() const {
  return column("red") != nullptr && column("green") != nullptr && column("blue") != nullptr;
}

// use(i, q): q on the sheet, x from the left end of the facade.
template <class F>
void OrthoPoints::for_each(double from, double to, Task& task, F&& use) const {
  const ProgressSpan span(task, from, to);
  for (size_t i = 0; i < cloud_.size(); ++i) {
    if (i % kPointTicks == 0)
      task.checkpoint(static_cast<double>(i) / static_cast<double>(cloud_.size()));
    const Vec3 q = facade_.on_sheet(cloud_.point(i));
    if (q.x >= facade_.left_m && q.x <= facade_.right_m && q.y >= facade_.bottom_m &&
        q.y <= facade_.top_m && q.z <= in_front_m_ && q.z >= -behind_m_)
      use(i, q);
  }
}

double OrthoPoints::spacing_m(Task& task) const {
  const double width_m = std::max(kLeastSide_m, facade_.right_m - facade_.left_m);
  const double height_m = std::max(kLeastSide_m, facade_.top_m - facade_.bottom_m);
  const double area_m2 = width_m * height_m, n = static_cast<double>(count_);
  const double cell_m = std::sqrt(area_m2 * std::max(kPointsAtLeast / n, 1 / kMostCells));
  const auto columns = static_cast<size_t>(width_m / cell_m) + 1;
  const auto rows = static_cast<size_t>(height_m / cell_m) + 1;
  std::vector<uint8_t> covered(columns * rows, 0);
  for_each(0.1, 0.2, task, [&](size_t, const Vec3& q) {
    const auto x = std::min(static_cast<size_t>((q.x - facade_.left_m) / cell_m), columns - 1);
    const auto y = std::min(static_cast<size_t>((q.y - facade_.bottom_m) / cell_m), rows - 1);
    covered[y * columns + x] = 1;
  });
  const auto cells = static_cast<double>(std::ranges::count(covered, uint8_t{1}));
  return cell_m * std::sqrt(cells / n);
}

void OrthoPoints::draw(Orthoimage& image, Task& task) const {
  const auto pixel_of = [&](const Vec3& q) {
    const auto x = static_cast<uint32_t>(std::max(0.0, (q.x - image.left_m) / image.pixel_m));
    const auto y = static_cast<uint32_t>(std::max(0.0, (image.top_m - q.y) / image.pixel_m));
    return size_t{std::min(y, image.rows - 1)} * image.columns + std::min(x, image.columns - 1);
  };
  std::vector<float> nearest(image.size(), -INFINITY);
  for_each(0.2, 0.5, task, [&](size_t, const Vec3& q) {
    float& at = nearest[pixel_of(q)];
    at = std::max(at, static_cast<float>(q.z));
  });
  // Sums in the order of the points: the same for any number of threads.
  const bool in_colour = content_ == OrthoContent::kColour;
  const size_t samples = in_colour ? 3 : 1;
  const Column* parts[3] = {column("red"), column("green"), column("blue")};
  const Column* intensity = column("intensity");
  const double unit = in_colour ? unit_of(parts) : 1;
  std::vector<double> sums(samples * image.size(), 0);
  std::vector<uint32_t> counts(image.size(), 0);
  for_each(0.5, 0.9, task, [&](size_t i, const Vec3& q) {
    const size_t at = pixel_of(q);
    if (q.z < double{nearest[at]} - kSameSurface_m) return;
    ++counts[at];
    if (in_colour)
      for (size_t s = 0; s < 3; ++s) sums[3 * at + s] += parts[s]->number(i) * unit;
    else sums[at] += content_ == OrthoContent::kIntensity ? intensity->number(i) : q.z;
  });
  image.has_data.assign(image.size(), 0);
  if (in_colour) image.colours.assign(3 * image.size(), 0);
  else image.values.assign(image.size(), 0);
  for (size_t at = 0; at < image.size(); ++at) {
    if (counts[at] == 0) continue;
    image.has_data[at] = 1;
    const double n = counts[at];
    if (in_colour)
      for (size_t s = 0; s < 3; ++s)
        image.colours[3 * at + s] =
            static_cast<uint8_t>(std::lround(std::clamp(sums[3 * at + s] / n, 0.0, 255.0)));
    else image.values[at] = static_cast<float>(sums[at] / n);
  }
}

}  // namespace jalon
