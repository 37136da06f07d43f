// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "formats/files/endian.h"
#include "formats/files/utf8.h"
#include "formats/las/layout.h"

namespace jalon::las {

namespace {

constexpr ElementType kTypes[] = {ElementType::kUint8,  ElementType::kInt8,   ElementType::kUint16,
                                  ElementType::kInt16,  ElementType::kUint32, ElementType::kInt32,
                                  ElementType::kUint64, ElementType::kInt64,  ElementType::kFloat32,
                                  ElementType::kFloat64};
constexpr size_t kMaxDimensions = 1024;  // real files have a dozen
constexpr uint8_t kHasScale = 8, kHasOffset = 16;

// One descriptor of the extra bytes VLR (LAS 1.4 R15, table 24): types 1-10 scalars, 11-30 the old
// pairs and triples, 0 plain bytes.
ExtraDimension dimension_of(const std::byte* descriptor, size_t number) {
  const auto data_type = static_cast<unsigned>(descriptor[2]);
  const auto options = static_cast<uint8_t>(descriptor[3]);
  ExtraDimension out;
  out.descriptor.assign(descriptor, descriptor + kDescriptorBytes);
  out.field.name = name_from_file(text_field(descriptor + 4, 32), numbered("extra", number + 1));
  out.field.meaning = text_field(descriptor + 160, 32);
  if (data_type == 0 || data_type > 30) {
    out.field.components = data_type == 0 ? options : 0;
  } else {
    out.raw_type = kTypes[(data_type - 1) % 10];
    out.field.components = (data_type - 1) / 10 + 1;
    out.scaled = (options & (kHasScale | kHasOffset)) != 0;
    for (size_t i = 0; i < out.field.components; ++i) {
      if ((options & kHasScale) != 0) out.scale[i] = load<double>(descriptor + 112 + 8 * i);
      if ((options & kHasOffset) != 0) out.shift[i] = load<double>(descriptor + 136 + 8 * i);
      if (!std::isfinite(out.scale[i]) || !std::isfinite(out.shift[i]) || out.scale[i] == 0)
        out.scaled = false;
    }
  }
  out.field.type = out.scaled ? ElementType::kFloat64 : out.raw_type;
  return out;
}

void make_names_unique(std::vector<ExtraDimension>& dimensions) {
  UniqueNames unique;
  for (ExtraDimension& dimension : dimensions)
    dimension.field.name = unique.add(dimension.field.name);
}

// NormalX, NormalY, NormalZ side by side become the field "normal".
void join_normals(std::vector<ExtraDimension>& dimensions) {
  for (size_t i = 0; i + 2 < dimensions.size(); ++i) {
    bool joined = true;
    for (size_t k = 0; k < 3; ++k) {
      const ExtraDimension& d = dimensions[i + k];
      joined = joined && d.field.name == kNormalNames[k] && d.field.type == ElementType::kFloat32 &&
               d.field.components == 1;
    }
    if (!joined) continue;
    ExtraDimension& normal = dimensions[i];
    normal.field = {"normal", ElementType::kFloat32, 3, "", "unit normal"};
    normal.descriptor.insert(normal.descriptor.end(), dimensions[i + 1].descriptor.begin(),
                             dimensions[i + 1].descriptor.end());
    normal.descriptor.insert(normal.descriptor.end(), dimensions[i + 2].descriptor.begin(),
                             dimensions[i + 2].descriptor.end());
    dimensions.erase(dimensions.begin() + static_cast<ptrdiff_t>(i) + 1,
                     dimensions.begin() + static_cast<ptrdiff_t>(i) + 3);
  }
}

}  // namespace

std::vector<ExtraDimension> extra_dimensions(const std::vector<Record>& vlrs,
                                             const std::vector<Record>& evlrs, size_t extra_bytes,
                                             Task& task) {
  std::vector<ExtraDimension> out;
  size_t used = 0;
  bool fits = true;
  for (const auto* list : {&vlrs, &evlrs})
    for (const Record& record : *list) {
      if (!record.is(kSpecUser, kExtraBytes)) continue;
      for (size_t at = 0; at + kDescriptorBytes <= record.size() && fits; at += kDescriptorBytes) {
        ExtraDimension dimension = dimension_of(record.data() + at, out.size());
        fits = out.size() < kMaxDimensions && dimension.bytes() > 0 &&
               dimension.bytes() <= extra_bytes - used;
        if (!fits) break;
        dimension.offset = used;
        used += dimension.bytes();
        out.push_back(std::move(dimension));
      }
    }
  if (!fits)
    task.log(Task::kWarning,
             "the extra bytes VLR describes more than the %zu extra bytes of a point", extra_bytes);
  if (used < extra_bytes) {
    ExtraDimension rest;
    rest.field = {"extra_bytes", ElementType::kUint8, static_cast<uint32_t>(extra_bytes - used), "",
                  "bytes that the file does not describe"};
    rest.offset = used;
    out.push_back(std::move(rest));
  }
  make_names_unique(out);
  join_normals(out);
  return out;
}

std::vector<std::byte> descriptor_of(const FieldInfo& field, const std::string& name) {
  std::vector<std::byte> out(kDescriptorBytes);
  size_t type = 0;
  while (kTypes[type] != field.type) ++type;
  out[2] = static_cast<std::byte>(type + 1 + 10 * (field.components - 1));
  std::memcpy(out.data() + 4, name.data(), std::min<size_t>(32, name.size()));
  const std::string_view meaning = utf8_prefix(field.meaning, 32);
  std::memcpy(out.data() + 160, meaning.data(), meaning.size());
  return out;
}

}  // namespace jalon::las
