// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/obj/notes.h"

#include <charconv>
#include <cmath>

#include "base/text_number.h"
#include "formats/face_geometry.h"
#include "formats/files/number_text.h"
#include "formats/files/utf8.h"

namespace jalon::obj {

namespace {

constexpr size_t kMaxCrsBytes = 65536;  // far more than any WKT has

std::string_view next_word(std::string_view& text) {
  const size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  const size_t end = std::min(text.find_first_of(" \t", begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

template <class T>
bool take(std::string_view word, T& out) {
  if constexpr (std::is_floating_point_v<T>) {
    return parse_number(word, out) && std::isfinite(out);
  } else {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), out);
    return error == std::errc() && end == word.data() + word.size();
  }
}

// One word, so that what follows stays readable.
std::string word_of(std::string_view text) {
  std::string out;
  for (const char c : text) out += static_cast<unsigned char>(c) <= 0x20 || c == 0x7f ? '_' : c;
  return out;
}

template <class T>
void append(std::string& out, const char* key, T value) {
  out.append(" ").append(key).append(" ");
  append_number(out, value);
}

void append_known(std::string& out, const char* key, double value) {
  if (std::isfinite(value)) append(out, key, value);
}

}  // namespace

void append_crs_note(std::string& out, const std::string& crs) {
  if (!crs.empty() && crs.find_first_of("\r\n") == std::string::npos && crs.size() < kMaxCrsBytes)
    out.append(kNote).append(" crs ").append(crs).append("\n");
}

void append_part_note(std::string& out, const Model& model, uint32_t index) {
  const Part& part = model.parts[index];
  out += kNote;
  append(out, "part", index);
  if (part.parent < model.parts.size()) append(out, "of", part.parent);
  if (!part.part_class.empty()) out.append(" class ").append(word_of(part.part_class));
  if (part.evidence != Evidence::kNone) out.append(" evidence ").append(name_of(part.evidence));
  if (part.copied_from < model.parts.size()) append(out, "copied_from", part.copied_from);
  if (part.level_of_detail != 0) append(out, "lod", part.level_of_detail);
  append_known(out, "width", part.width_m);
  append_known(out, "height", part.height_m);
  append_known(out, "depth", part.depth_m);
  append_known(out, "confidence", part.class_confidence);
  if (const std::string name = name_from_file(part.name, ""); !name.empty())
    out.append(" name ").append(name);
  out += '\n';
}

void append_face_note(std::string& out, const Face& face) {
  out.append(kNote).append(" face");
  append(out, "part", face.part);
  append(out, "id", face.id);
  append(out, "class", face.face_class);
  append_known(out, "sigma", face.sigma_m);
  out += '\n';
}

void append_hole_note(std::string& out, const Ring& ring) {
  out.append(kNote).append(" hole");
  append(out, "part", ring.part);
  out += '\n';
}

void append_solid_note(std::string& out, const Solid& solid) {
  out.append(kNote).append(" solid");
  append(out, "part", solid.part);
  append(out, "first", solid.first_face);
  append(out, "count", solid.face_count);
  out += '\n';
}

bool Notes::read_part(std::string_view text) {
  uint64_t index = 0;
  if (!take(next_word(text), index) || index != parts_.size()) return false;  // they stand in order
  Part part;
  for (std::string_view key = next_word(text); !key.empty(); key = next_word(text)) {
    if (key == "name") {
      part.name = name_from_file(text, "");
      break;
    }
    const std::string_view word = next_word(text);
    bool good = true;
    if (key == "of") good = take(word, part.parent);
    else if (key == "class") part.part_class = name_from_file(word, "");
    else if (key == "evidence") part.evidence = evidence_named(word);
    else if (key == "copied_from") good = take(word, part.copied_from);
    else if (key == "lod") good = take(word, part.level_of_detail);
    else if (key == "width") good = take(word, part.width_m);
    else if (key == "height") good = take(word, part.height_m);
    else if (key == "depth") good = take(word, part.depth_m);
    else if (key == "confidence") good = take(word, part.class_confidence);
    if (!good) return false;
  }
  parts_.push_back(std::move(part));
  return true;
}

bool Notes::read(std::string_view text, size_t triangles_so_far) {
  const std::string_view what = next_word(text);
  if (what == "part") return read_part(text);
  if (what == "crs") {
    crs_ = valid_utf8(text.substr(std::min(text.find_first_not_of(' '), text.size())));
    return true;
  }
  if (what == "mesh") {
    mesh_from_ = triangles_so_far;
    return true;
  }
  if (what != "face" && what != "hole" && what != "solid") return false;
  Face face;
  Solid solid;
  uint32_t part = kNoPart, face_class = 0;
  for (std::string_view key = next_word(text); !key.empty(); key = next_word(text)) {
    const std::string_view word = next_word(text);
    bool good = true;
    if (key == "part") good = take(word, part);
    else if (key == "id") good = take(word, face.id);
    else if (key == "class") good = take(word, face_class);
    else if (key == "sigma") good = take(word, face.sigma_m);
    else if (key == "first") good = take(word, solid.first_face);
    else if (key == "count") good = take(word, solid.face_count);
    if (!good) return false;
  }
  if (what == "solid") {
    solid.part = part;
    solids_.push_back(solid);
    return true;
  }
  wants_ring_ = true;
  hole_part_ = part;
  if (what == "hole") return !faces_.empty();
  face.part = part;
  face.face_class = static_cast<uint8_t>(face_class);
  face.first_ring = rings_.size();
  hole_part_ = kNoPart;
  faces_.push_back(face);
  return true;
}

void Notes::line(std::span<const uint32_t> vertices) {
  if (!wants_ring_) return;
  wants_ring_ = false;
  if (vertices.size() > 1 && vertices.front() == vertices.back())
    vertices = vertices.first(vertices.size() - 1);
  rings_.push_back({corners_.size(), vertices.size(), hole_part_});
  corners_.insert(corners_.end(), vertices.begin(), vertices.end());
  ++faces_.back().ring_count;
}

bool Notes::build(Model& model) {
  for (Part& part : parts_) {
    uint64_t at = part.parent;  // a walk upward must end
    for (size_t steps = 0; at < parts_.size() && steps < kMaxPartLevels; ++steps)
      at = parts_[at].parent;
    if (at < parts_.size()) return false;
  }
  for (Part& part : parts_) {
    if (part.parent >= parts_.size()) part.parent = kNoParent;
    if (part.copied_from >= parts_.size()) part.copied_from = kNoParent;
  }
  for (const Face& face : faces_)
    if (face.ring_count == 0 || (face.part >= parts_.size() && !parts_.empty())) return false;
  for (Ring& ring : rings_)
    if (ring.part >= parts_.size()) ring.part = kNoPart;
  for (const Solid& solid : solids_)
    if (solid.first_face > faces_.size() || solid.face_count > faces_.size() - solid.first_face)
      return false;
  model.crs = std::move(crs_);
  model.parts = std::move(parts_);
  model.rings = std::move(rings_);
  model.corners = std::move(corners_);
  model.solids = std::move(solids_);
  model.faces = std::move(faces_);
  for (Face& face : model.faces) measure_face(model, face);
  return true;
}

}  // namespace jalon::obj
