// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz_targets.h"

#include "readers.h"

namespace fuzz {

namespace {

constexpr char kLas[] = "las", kLaz[] = "laz", kE57[] = "e57", kPly[] = "ply", kPcd[] = "pcd",
               kPng[] = "png", kPtx[] = "ptx", kPts[] = "pts", kXyz[] = "xyz", kCsv[] = "csv",
               kObj[] = "obj", kStl[] = "stl", kCity[] = "city.json", kDxf[] = "dxf";

template <const char* kExtension>
void cloud(const uint8_t* data, size_t size) {
  read_cloud(kExtension, data, size);
}
template <const char* kExtension, bool kAsFaces = false>
void model(const uint8_t* data, size_t size) {
  read_model(kExtension, kAsFaces, data, size);
}

constexpr Target kTargets[] = {
    {"las", cloud<kLas>},
    {"laz", cloud<kLaz>},
    {"copc.laz", read_copc},
    {"ept", read_ept},
    {"e57", cloud<kE57>, mend_pages},
    {"ply", cloud<kPly>},
    {"ply_model", model<kPly>},
    {"pcd", cloud<kPcd>},
    {"png", cloud<kPng>},
    {"ptx", cloud<kPtx>},
    {"pts", cloud<kPts>},
    {"xyz", cloud<kXyz>},
    {"csv", cloud<kCsv>},
    {"text_columns", read_text_columns},
    {"stations", read_stations},
    {"obj", model<kObj>},
    {"obj_faces", model<kObj, true>},
    {"stl", model<kStl>},
    {"city.json", model<kCity>},
    {"dxf", model<kDxf>},
    {"dxf_faces", model<kDxf, true>},
    {"trajectory_text", read_trajectory_text},
    {"trajectory_sbet", read_trajectory_sbet},
    {"smrmsg", read_smrmsg},
    {"m3c2_file", read_m3c2_file},
    {"bytes", read_objects, mend_object},
    {"clouds", run_clouds, mend_cloud},
    {"cloud_writers", write_clouds, mend_cloud},
    {"model_writers", write_models, mend_model},
    {"params", read_params},
    {"law", read_law},
    {"network", read_network},
    {"codes", read_codes},
    {"notes", read_notes},
};

}  // namespace

const Target* target(size_t i) {
  return i < sizeof kTargets / sizeof *kTargets ? &kTargets[i] : nullptr;
}

const Target* find_target(const std::string& name) {
  for (const Target& t : kTargets)
    if (name == t.name) return &t;
  return nullptr;
}

}  // namespace fuzz
