// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/scan_output.h"

#include <cmath>

#include "base/error.h"

namespace jalon {

namespace {

void store(double* out, const Vec3& p) {
  out[0] = p.x;
  out[1] = p.y;
  out[2] = p.z;
}

}  // namespace

ScanOutput::ScanOutput(size_t n)
    : xyz(3 * n),
      face(std::make_shared<Column>(FieldInfo{"face", ElementType::kUint32, 1, "",
                                              "id of the face hit; 4294967295 for an outlier"},
                                    n)),
      segment(std::make_shared<Column>(
          FieldInfo{"segment", ElementType::kUint32, 1, "",
                    "number of the true plane; 0: none, an outlier or a mixed pixel"},
          n)),
      true_xyz(std::make_shared<Column>(
          FieldInfo{"true_xyz", ElementType::kFloat64, 3, "m", "the point without noise"}, n)) {}

void ScanOutput::set_point(size_t i, const Vec3& measured, const Vec3& exact, uint32_t face_id,
                           uint32_t true_segment) {
  store(xyz.data() + 3 * i, measured);
  store(true_xyz->values<double>().data() + 3 * i, exact);
  face->values<uint32_t>()[i] = face_id;
  segment->values<uint32_t>()[i] = true_segment;
}

Cloud ScanOutput::take() {
  Cloud cloud;
  cloud.xyz_buffer = std::make_shared<const Buffer<double>>(std::move(xyz));
  cloud.fields.set(std::move(face));
  cloud.fields.set(std::move(segment));
  cloud.fields.set(std::move(true_xyz));
  return cloud;
}

Vec3 stepped(Vec3 p, double step_m) {
  if (step_m > 0)
    for (int a = 0; a < 3; ++a) p[a] = std::nearbyint(p[a] / step_m) * step_m;
  return p;
}

Vec3 offset_of(std::span<const double> offset_m) {
  if (offset_m.size() != 3) fail(Status::kInvalidArgument, "offset_m takes three numbers");
  return {offset_m[0], offset_m[1], offset_m[2]};
}

}  // namespace jalon
