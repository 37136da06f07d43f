// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/ortho_points.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kTogether = 1 << 16;  // points whose numbers among them have 16 bits
constexpr double kPointsAtLeast = 9;   // a cell: so that surfaces have no empty cells (e^-9)
constexpr double kMostCells = 1e6;
constexpr double kLeastSide_m = 0.01;
constexpr double kSameSurface_m =
    0.05;  // behind the nearest point of a pixel: noise and edges, no other surface

// Times kTogether: points whose values wait to be added up, 33 MB at most.
constexpr size_t kBatch = 16;

// Whatever thread comes first.
void keep_greatest(float& greatest, float value) {
  std::atomic_ref<float> at(greatest);
  float before = at.load(std::memory_order_relaxed);
  while (value > before && !at.compare_exchange_weak(before, value, std::memory_order_relaxed)) {
  }
}

// What makes 0 ... 255 of the values of colours: 16 bits in LAS, 8 elsewhere, or floats from 0 to 1.
double unit_of(const Column* const (&parts)[3]) {
  double most = 0;
  for (const Column* part : parts)
    for (size_t i = 0; i < part->count(); ++i) most = std::max(most, part->number(i));
  return most > 255 ? 1.0 / 256 : most > 1 ? 1 : 255;
}

// Files have the field where their scanner measured nothing, too.
bool varies(const Column& column) {
  double first = kNaN;
  for (size_t i = 0; i < column.count(); ++i) {
    const double value = column.number(i);
    if (!std::isfinite(value)) continue;
    if (std::isfinite(first) && value != first) return true;
    first = value;
  }
  return false;
}

}  // namespace

OrthoPoints::OrthoPoints(const Cloud& cloud, const PlacedFacade& facade,
                         const OrthoimageSettings& settings, Task& task)
    : cloud_(cloud), facade_(facade), content_(settings.content) {
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
  find_inside(settings.in_front_m, settings.behind_m, task);
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

void OrthoPoints::find_inside(double in_front_m, double behind_m, Task& task) {
  const ProgressSpan span(task, 0, 0.1);
  inside_.resize((cloud_.size() + kTogether - 1) / kTogether);
  parallel_for(task, cloud_.size(), kTogether, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = cloud_.point(i);
      const double depth_m = facade_.view.depth_m(p);  // first: it turns most points away
      if (!(depth_m <= in_front_m && depth_m >= -behind_m)) continue;
      const Vec3 q = facade_.on_sheet(p);
      if (q.x >= facade_.left_m && q.x <= facade_.right_m && q.y >= facade_.bottom_m &&
          q.y <= facade_.top_m)
        inside_[begin / kTogether].push_back(static_cast<uint16_t>(i - begin));
    }
  });
  for (const auto& some : inside_) count_ += some.size();
}

// use(i, q): q on the sheet. By all threads.
template <class F>
void OrthoPoints::for_each(double from, double to, Task& task, F&& use) const {
  const ProgressSpan span(task, from, to);
  parallel_chunks(task, inside_.size(), [&](size_t c) { for_each_of(c, use); });
}

// The same of those points that were found together.
template <class F>
void OrthoPoints::for_each_of(size_t together, F&& use) const {
  for (const uint16_t offset : inside_[together]) {
    const size_t i = together * kTogether + offset;
    use(i, facade_.on_sheet(cloud_.point(i)));
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
    std::atomic_ref<uint8_t>(covered[y * columns + x]).store(1, std::memory_order_relaxed);
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
    keep_greatest(nearest[pixel_of(q)], static_cast<float>(q.z));
  });
  const bool in_colour = content_ == OrthoContent::kColour;
  const size_t samples = in_colour ? 3 : 1;
  const Column* parts[3] = {column("red"), column("green"), column("blue")};
  const Column* intensity = column("intensity");
  const double unit = in_colour ? unit_of(parts) : 1;
  const auto value_of = [&](size_t i, const Vec3& q, size_t s) {
    return in_colour                              ? parts[s]->number(i) * unit
           : content_ == OrthoContent::kIntensity ? intensity->number(i)
                                                  : q.z;
  };
  // What some points show, by all threads; then their sums in the order of the points, the same for any number of them.
  struct Shown {
    std::vector<size_t> pixels;
    std::vector<double> values;  ///< as many a point as there are samples
  };
  const auto shown_of = [&](size_t together) {
    Shown shown;
    for_each_of(together, [&](size_t i, const Vec3& q) {
      const size_t at = pixel_of(q);
      if (q.z < double{nearest[at]} - kSameSurface_m) return;
      double values[3] = {0, 0, 0};
      for (size_t s = 0; s < samples; ++s)
        if (values[s] = value_of(i, q, s); !std::isfinite(values[s])) return;
      shown.pixels.push_back(at);
      shown.values.insert(shown.values.end(), values, values + samples);
    });
    return shown;
  };
  std::vector<double> sums(samples * image.size(), 0);
  std::vector<uint32_t> counts(image.size(), 0);
  const ProgressSpan span(task, 0.5, 0.9);
  for (size_t first = 0; first < inside_.size(); first += kBatch) {
    std::vector<Shown> batch(std::min(kBatch, inside_.size() - first));
    parallel_chunks(task, batch.size(), [&](size_t k) { batch[k] = shown_of(first + k); });
    for (const Shown& shown : batch)
      for (size_t k = 0; k < shown.pixels.size(); ++k) {
        const size_t at = shown.pixels[k];
        ++counts[at];
        for (size_t s = 0; s < samples; ++s)
          sums[samples * at + s] += shown.values[samples * k + s];
      }
  }
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
