// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/drawings/geotiff_writer.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "formats/files/endian.h"
#include "formats/files/zlib_stream.h"

namespace jalon {

namespace {

constexpr size_t kStripBytes = size_t{1} << 18;  // before deflation: readers take a strip at a time

enum Type : uint16_t { kAscii = 2, kShort = 3, kLong = 4, kRational = 5, kDouble = 12 };

/// An entry of the directory (TIFF 6.0, section 2); values of at most four bytes stand in it, others behind it.
struct Entry {
  uint16_t tag;
  Type type;
  uint32_t count;
  std::string bytes;
};

Entry shorts(uint16_t tag, std::initializer_list<uint16_t> values) {
  Entry entry{tag, kShort, static_cast<uint32_t>(values.size()), {}};
  for (const uint16_t value : values) append_stored(entry.bytes, value);
  return entry;
}

Entry longs(uint16_t tag, std::span<const uint32_t> values) {
  Entry entry{tag, kLong, static_cast<uint32_t>(values.size()), {}};
  for (const uint32_t value : values) append_stored(entry.bytes, value);
  return entry;
}

Entry doubles(uint16_t tag, std::initializer_list<double> values) {
  Entry entry{tag, kDouble, static_cast<uint32_t>(values.size()), {}};
  for (const double value : values) append_stored(entry.bytes, value);
  return entry;
}

Entry text(uint16_t tag, const std::string& value) {
  return {tag, kAscii, static_cast<uint32_t>(value.size() + 1), value + '\0'};
}

/// What differs between the two kinds of pixels.
struct Samples {
  uint16_t count, bits, format, photometric, predictor;
  size_t pixel_bytes() const { return size_t{count} * bits / 8; }
};
constexpr uint16_t kUnsigned = 1, kFloat = 3, kBlackIsZero = 1, kRgb = 2, kPlain = 1,
                   kDifferences = 2;

/// Strips of rows, deflated; the offsets count from the first strip.
struct Strips {
  uint32_t rows = 0;  ///< of each but the last
  std::vector<uint32_t> offsets, sizes;
  std::string bytes;
};

template <class AppendRow>
Strips strips_of(uint32_t width, uint32_t height, const Samples& samples, Task& task,
                 AppendRow&& append_row) {
  Strips out;
  const size_t row_bytes = samples.pixel_bytes() * width;
  out.rows = static_cast<uint32_t>(std::clamp<size_t>(kStripBytes / row_bytes, 1, height));
  for (uint32_t first = 0; first < height; first += out.rows) {
    task.checkpoint(static_cast<double>(first) / height);
    std::string plain;
    for (uint32_t y = first; y < std::min(height, first + out.rows); ++y) append_row(y, plain);
    const ProgressSpan span(task, 0, 0);
    const std::string packed = zlib_stream(plain, Redundancy::kAny, task);
    out.offsets.push_back(static_cast<uint32_t>(out.bytes.size()));
    out.sizes.push_back(static_cast<uint32_t>(packed.size()));
    out.bytes += packed;
    if (out.bytes.size() % 2 != 0) out.bytes += '\0';  // values begin at even offsets
  }
  return out;
}

// ModelPixelScale and the tie point of the outer corner.
std::vector<Entry> corner_entries(double left, double top, double width, double height) {
  return {doubles(33550, {width, height, 0}), doubles(33922, {0, 0, 0, left, top, 0})};
}

// GeoKeys (OGC 19-008r4, annex B): a projected system by its code, or a user-defined model in metres; pixels are areas,
// a citation.
std::vector<Entry> entries_of(const RasterPlace& place) {
  constexpr uint16_t kVersion = 1, kRevision = 1, kMinor = 1, kKeys = 4;
  constexpr uint16_t kModelType = 1024, kRasterType = 1025, kCitation = 1026, kLinearUnits = 3076;
  constexpr uint16_t kProjectedSystem = 3072, kProjected = 1, kUserDefined = 32767;
  constexpr uint16_t kPixelIsArea = 1, kMetre = 9001, kAsciiParams = 34737;
  const bool has_code = place.epsg != 0;
  const std::string citation = place.system + "|";
  const auto length = static_cast<uint16_t>(citation.size());
  std::vector<Entry> entries =
      corner_entries(place.left_m, place.top_m, place.pixel_m, place.pixel_m);
  entries.push_back(shorts(34735, {kVersion,
                                   kRevision,
                                   kMinor,
                                   kKeys,  //
                                   kModelType,
                                   0,
                                   1,
                                   has_code ? kProjected : kUserDefined,  //
                                   kRasterType,
                                   0,
                                   1,
                                   kPixelIsArea,  //
                                   kCitation,
                                   kAsciiParams,
                                   length,
                                   0,  //
                                   has_code ? kProjectedSystem : kLinearUnits,
                                   0,
                                   1,
                                   has_code ? place.epsg : kMetre}));
  entries.push_back(text(kAsciiParams, citation));
  return entries;
}

std::vector<Entry> entries_of(const AngularPlace& place) {
  constexpr uint16_t kDescription = 270;
  std::vector<Entry> entries =
      corner_entries(place.left_deg, place.top_deg, place.width_deg, place.height_deg);
  entries.push_back(text(kDescription, place.description));
  return entries;
}

// Header, directory, long values, strips.
std::string file_of(std::vector<Entry> entries, const Strips& strips) {
  constexpr size_t kHeader = 8, kEntry = 12;
  constexpr uint16_t kOffsetsTag = 273;
  const size_t directory = 2 + kEntry * entries.size() + 4;
  size_t behind = kHeader + directory;
  for (Entry& entry : entries) {
    if (entry.bytes.size() % 2 != 0) entry.bytes += '\0';
    if (entry.bytes.size() > 4) behind += entry.bytes.size();
  }
  for (Entry& entry : entries) {
    if (entry.tag != kOffsetsTag) continue;
    entry.bytes.clear();
    for (const uint32_t offset : strips.offsets)
      append_stored(entry.bytes, static_cast<uint32_t>(offset + behind));
  }
  std::string out = "II";
  append_stored(out, uint16_t{42});
  append_stored(out, uint32_t{kHeader});
  append_stored(out, static_cast<uint16_t>(entries.size()));
  std::string values;
  for (const Entry& entry : entries) {
    append_stored(out, entry.tag);
    append_stored(out, static_cast<uint16_t>(entry.type));
    append_stored(out, entry.count);
    std::string inside = entry.bytes;
    if (inside.size() > 4) {
      inside.clear();
      append_stored(inside, static_cast<uint32_t>(kHeader + directory + values.size()));
      values += entry.bytes;
    }
    inside.resize(4, '\0');
    out += inside;
  }
  append_stored(out, uint32_t{0});  // no other directory
  return out + values + strips.bytes;
}

std::string written(uint32_t width, uint32_t height, const Samples& samples, const Strips& strips,
                    const std::vector<Entry>& more, const std::vector<Entry>& place) {
  constexpr uint16_t kDeflate = 8, kChunky = 1, kNoUnit = 1;
  Entry bits{258, kShort, samples.count, {}}, formats{339, kShort, samples.count, {}};
  Entry unit{282, kRational, 1, {}};
  for (uint16_t s = 0; s < samples.count; ++s) {
    append_stored(bits.bytes, samples.bits);
    append_stored(formats.bytes, samples.format);
  }
  for (int k = 0; k < 2; ++k) append_stored(unit.bytes, uint32_t{1});
  Entry unit_y = unit;
  unit_y.tag = 283;
  std::vector<Entry> entries{longs(256, {{width}}),
                             longs(257, {{height}}),
                             bits,
                             shorts(259, {kDeflate}),
                             shorts(262, {samples.photometric}),
                             longs(273, strips.offsets),
                             shorts(277, {samples.count}),
                             longs(278, {{strips.rows}}),
                             longs(279, strips.sizes),
                             unit,
                             unit_y,
                             shorts(284, {kChunky}),
                             shorts(296, {kNoUnit}),
                             text(305, "Jalon"),
                             shorts(317, {samples.predictor}),
                             formats};
  entries.insert(entries.end(), more.begin(), more.end());
  entries.insert(entries.end(), place.begin(), place.end());
  std::ranges::sort(entries, {}, &Entry::tag);
  return file_of(std::move(entries), strips);
}

std::string numbers_file(const NumberImage& image, const std::vector<Entry>& place, Task& task) {
  constexpr uint16_t kGdalNoData = 42113;
  constexpr Samples kNumbers{1, 32, kFloat, kBlackIsZero, kPlain};
  const Strips strips =
      strips_of(image.width, image.height, kNumbers, task, [&](uint32_t y, std::string& out) {
        for (uint32_t x = 0; x < image.width; ++x) {
          const float value = image.pixels[size_t{y} * image.width + x];
          append_stored(out, std::isnan(value) ? kNoNumber : value);
        }
      });
  return written(image.width, image.height, kNumbers, strips, {text(kGdalNoData, "-9999")}, place);
}

}  // namespace

std::string geotiff_of(const RgbaImage& image, const RasterPlace& place, Task& task) {
  constexpr uint16_t kExtraSamples = 338, kUnassociatedAlpha = 2;
  constexpr Samples kRgba{4, 8, kUnsigned, kRgb, kDifferences};
  const size_t row_bytes = 4 * size_t{image.width};
  const Strips strips =
      strips_of(image.width, image.height, kRgba, task, [&](uint32_t y, std::string& out) {
        const uint8_t* row = image.pixels.data() + y * row_bytes;
        for (size_t i = 0; i < row_bytes; ++i)
          out += static_cast<char>(row[i] - (i >= 4 ? row[i - 4] : 0));
      });
  return written(image.width, image.height, kRgba, strips,
                 {shorts(kExtraSamples, {kUnassociatedAlpha})}, entries_of(place));
}

std::string geotiff_of(const NumberImage& image, const RasterPlace& place, Task& task) {
  return numbers_file(image, entries_of(place), task);
}

std::string geotiff_of(const NumberImage& image, const AngularPlace& place, Task& task) {
  return numbers_file(image, entries_of(place), task);
}

}  // namespace jalon
