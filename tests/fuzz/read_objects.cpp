// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Bytes of objects. What they give is used, since what reads them must have refused all that its users could not bear.
#include <algorithm>
#include <cstring>
#include <iterator>

#include <unistd.h>

#include "harness.h"
#include "readers.h"

namespace fuzz {

namespace {

template <class Handle>
using Table = jalon_status (*)(const Handle*, jalon_fields**);

template <class Handle>
void look_at(const Handle* object, std::initializer_list<Table<Handle>> tables) {
  for (const Table<Handle> table : tables) {
    jalon_fields* out = nullptr;
    succeeds(table(object, &out));
    jalon_fields_release(out);
  }
}

template <class Write>
void to_file(const char* extension, const Write& write) {
  const std::string path = place_of(extension);
  succeeds(write(path.c_str()));
  ::unlink(path.c_str());
  ::unlink(place_of("stations.json").c_str());  // what some formats have no place for
}

void use(const jalon_cloud* cloud) {
  jalon_box box;
  succeeds(jalon_cloud_bounds(cloud, &box));
  jalon_cloud* thinned = nullptr;
  succeeds(jalon_cloud_subsample(cloud, nullptr, one_thread(), &thinned, nullptr));
  jalon_cloud_release(thinned);
}

void use(const jalon_model* model) {
  to_file("dxf",
          [&](const char* path) { return jalon_model_write(model, path, nullptr, one_thread()); });
}

void use(const jalon_segmentation* segmentation) {
  look_at(segmentation, {jalon_segmentation_points, jalon_segmentation_segments});
  static jalon_params* const plan = [] {
    jalon_params* out = nullptr;
    must(jalon_params_create("picture", &out));
    must(jalon_params_set_string(out, "view", "plan"));
    return out;
  }();
  to_file("svg", [&](const char* path) {
    return jalon_report_write_picture(segmentation, path, plan, one_thread());
  });
  static jalon_modeller* const modeller = [] {
    jalon_modeller* out = nullptr;
    must(jalon_modeller_create("coded_objects", &out));
    return out;
  }();
  jalon_cloud* cloud = nullptr;
  jalon_model* model = nullptr;
  must(jalon_segmentation_cloud(segmentation, &cloud));
  if (succeeds(jalon_modeller_run(modeller, cloud, segmentation, one_thread(), &model))) use(model);
  jalon_model_release(model);
  jalon_cloud_release(cloud);
  to_file("json", [&](const char* path) {
    return jalon_report_write_json(segmentation, nullptr, nullptr, path, nullptr, one_thread());
  });
  to_file("html", [&](const char* path) {
    return jalon_report_write_html(segmentation, nullptr, nullptr, path, nullptr, one_thread());
  });
}

void use(const jalon_comparison* comparison) {
  look_at(comparison, {jalon_comparison_points, jalon_comparison_summary, jalon_comparison_parts});
  to_file("html", [&](const char* path) {
    return jalon_report_write_comparison(comparison, nullptr, nullptr, nullptr, path, nullptr,
                                         one_thread());
  });
}

void use(const jalon_registration* registration) {
  look_at(registration, {jalon_registration_summary, jalon_registration_iterations,
                         jalon_registration_residuals, jalon_registration_directions});
  to_file("html", [&](const char* path) {
    return jalon_report_write_registration(registration, nullptr, nullptr, nullptr, path, nullptr,
                                           one_thread());
  });
}

void use(const jalon_evaluation* evaluation) {
  look_at(evaluation, {jalon_evaluation_pairs, jalon_evaluation_automatic,
                       jalon_evaluation_reference, jalon_evaluation_totals});
}

void use(const jalon_noise_law* law) {
  const char* json = nullptr;
  succeeds(jalon_noise_law_json(law, &json));
}

void use(const void*) {}  // of the others only the bytes are read

struct Bytes {
  const uint8_t* data;
  uint64_t size;
};

template <class Handle>
Handle* made(jalon_status (*make)(const uint8_t*, uint64_t, jalon_task*, Handle**), Bytes bytes) {
  Handle* out = nullptr;
  succeeds(make(bytes.data, bytes.size, one_thread(), &out));
  return out;
}
template <class Handle>
Handle* made(jalon_status (*make)(const uint8_t*, uint64_t, Handle**), Bytes bytes) {
  Handle* out = nullptr;
  succeeds(make(bytes.data, bytes.size, &out));
  return out;
}

template <auto kMake, auto kRelease>
void take(Bytes bytes) {
  auto* const object = made(kMake, bytes);
  if (object != nullptr) use(object);
  kRelease(object);
}

constexpr uint32_t kCloud = 1, kModel = 3;  // kinds in the header

/// In the order of what the first byte of an input tells; the kinds are those of the header (bytes/envelope.h).
constexpr struct {
  uint32_t kind;
  void (*read)(Bytes);
} kKinds[] = {
    {kCloud, take<jalon_cloud_from_bytes, jalon_cloud_release>},
    {4, take<jalon_fields_from_bytes, jalon_fields_release>},
    {2, take<jalon_params_from_bytes, jalon_params_release>},
    {kModel, take<jalon_model_from_bytes, jalon_model_release>},
    {5, take<jalon_segmentation_from_bytes, jalon_segmentation_release>},
    {6, take<jalon_comparison_from_bytes, jalon_comparison_release>},
    {7, take<jalon_registration_from_bytes, jalon_registration_release>},
    {8, take<jalon_evaluation_from_bytes, jalon_evaluation_release>},
    {9, take<jalon_model_evaluation_from_bytes, jalon_model_evaluation_release>},
    {10, take<jalon_noise_law_from_bytes, jalon_noise_law_release>},
    {11, take<jalon_segmenter_from_bytes, jalon_segmenter_release>},
    {12, take<jalon_modeller_from_bytes, jalon_modeller_release>},
    {13, take<jalon_comparer_from_bytes, jalon_comparer_release>},
    {14, take<jalon_registrar_from_bytes, jalon_registrar_release>},
    {15, take<jalon_scanner_from_bytes, jalon_scanner_release>},
};

uint32_t crc32(uint32_t crc, const char* bytes, size_t count) {
  constexpr uint32_t kPolynomial = 0xedb88320;  // of ISO 3309
  crc = ~crc;
  for (size_t i = 0; i < count; ++i) {
    crc ^= static_cast<uint8_t>(bytes[i]);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? kPolynomial : 0u);
  }
  return ~crc;
}

/// What jalon/bytes.h says of the 32 bytes of a header; little-endian machines only.
void mend(std::string& bytes, uint32_t kind) {
  constexpr size_t kFrom = 1, kHeader = 32, kSummed = size_t{1} << 20;
  if (bytes.size() < kFrom + kHeader || bytes.size() > kSummed) return;
  char* const header = bytes.data() + kFrom;
  const uint64_t length = bytes.size() - kFrom - kHeader;
  const uint32_t layout = 1, spare = 0;
  std::memcpy(header, "\x89JLN\r\n\x1a\n", 8);
  std::memcpy(header + 8, &layout, 4);
  std::memcpy(header + 12, &kind, 4);
  std::memcpy(header + 16, &length, 8);
  const uint32_t sum = crc32(0, header + kHeader, length);
  const uint32_t whole =
      crc32(crc32(0, header, 24), reinterpret_cast<const char*>(&sum), length > 0 ? sizeof sum : 0);
  std::memcpy(header + 24, &whole, 4);
  std::memcpy(header + 28, &spare, 4);
}

constexpr const char* kCloudFormats[] = {"las", "laz", "e57", "ply", "pcd",
                                         "pts", "xyz", "csv", "png"};
constexpr const char* kModelFormats[] = {"dxf", "city.json", "obj",  "stl",    "ply",
                                         "glb", "ifc",       "gpkg", "geojson"};

}  // namespace

void read_objects(const uint8_t* data, size_t size) {
  if (size > 0) kKinds[data[0] % std::size(kKinds)].read({data + 1, size - 1});
}

void write_clouds(const uint8_t* data, size_t size) {
  if (size == 0) return;
  jalon_cloud* const cloud = made(jalon_cloud_from_bytes, {data + 1, size - 1});
  if (cloud == nullptr) return;
  to_file(kCloudFormats[data[0] % std::size(kCloudFormats)],
          [&](const char* path) { return jalon_cloud_write(cloud, path, nullptr, one_thread()); });
  jalon_cloud_release(cloud);
}

void write_models(const uint8_t* data, size_t size) {
  if (size == 0) return;
  jalon_model* const model = made(jalon_model_from_bytes, {data + 1, size - 1});
  if (model == nullptr) return;
  to_file(kModelFormats[data[0] % std::size(kModelFormats)],
          [&](const char* path) { return jalon_model_write(model, path, nullptr, one_thread()); });
  jalon_model_release(model);
}

void mend_object(std::string& bytes) {
  if (!bytes.empty()) mend(bytes, kKinds[static_cast<uint8_t>(bytes[0]) % std::size(kKinds)].kind);
}
void mend_cloud(std::string& bytes) { mend(bytes, kCloud); }
void mend_model(std::string& bytes) { mend(bytes, kModel); }

}  // namespace fuzz
