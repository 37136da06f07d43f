// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/city/tree.h"

#include <algorithm>
#include <limits>

#include "formats/face_geometry.h"
#include "formats/files/utf8.h"

namespace jalon::city {

namespace {

using Kind = JsonCursor::Kind;

bool take_text(JsonCursor& cursor, std::string& out) {
  if (cursor.kind() != Kind::kText) return false;
  out = name_from_file(cursor.text(), "");
  return true;
}

bool take_number(JsonCursor& cursor, double& out) {
  if (cursor.kind() != Kind::kNumber) return false;
  out = cursor.number();
  return true;
}

bool take_count(JsonCursor& cursor, uint64_t& out) {
  double value = 0;
  if (!take_number(cursor, value)) return false;
  if (value >= 0 && value <= std::numeric_limits<uint32_t>::max())
    out = static_cast<uint64_t>(value);
  return true;
}

// One value, or one a face.
template <class Add>
bool take_list(JsonCursor& cursor, Add&& add) {
  double value = 0;
  if (cursor.kind() != Kind::kArray) {
    if (!take_number(cursor, value)) return false;
    add(value);
    return true;
  }
  for (cursor.begin_array(); cursor.next_element();)
    if (take_number(cursor, value)) add(value);
    else cursor.skip();
  return true;
}

bool take_evidence(JsonCursor& cursor, Part& part) {
  std::string word;
  if (!take_text(cursor, word)) return false;
  part.evidence = evidence_named(word);
  return true;
}

bool take_level(JsonCursor& cursor, Part& part) {
  uint64_t level = 0;
  if (!take_count(cursor, level)) return false;
  if (level <= 3) part.level_of_detail = static_cast<uint8_t>(level);
  return true;
}

}  // namespace

bool read_attribute(JsonCursor& cursor, const std::string& name, Draft& draft,
                    std::string& part_class) {
  if (name == "name") return take_text(cursor, draft.part.name);
  if (name == "class") return take_text(cursor, part_class);
  if (name == "part") return take_count(cursor, draft.number);
  if (name == "part_of") return take_count(cursor, draft.above);
  if (name == "copied_from") return take_count(cursor, draft.copied_from);
  if (name == "evidence") return take_evidence(cursor, draft.part);
  if (name == "level_of_detail") return take_level(cursor, draft.part);
  if (name == "width_m") return take_number(cursor, draft.part.width_m);
  if (name == "height_m") return take_number(cursor, draft.part.height_m);
  if (name == "depth_m") return take_number(cursor, draft.part.depth_m);
  if (name == "class_confidence") return take_number(cursor, draft.part.class_confidence);
  if (name == "sigma_m") return take_list(cursor, [&](double v) { draft.sigmas_m.push_back(v); });
  if (name == "face")
    return take_list(cursor, [&](double v) {
      const bool fits = v >= 0 && v <= std::numeric_limits<uint32_t>::max();
      draft.face_ids.push_back(fits ? static_cast<uint32_t>(v) : 0);
    });
  if (name == "closes_opening" && cursor.kind() == Kind::kBool) {
    draft.is_closing = cursor.flag();
    return true;
  }
  return false;
}

uint32_t Tree::add(Draft draft) {
  const auto index = static_cast<uint32_t>(drafts_.size());
  if (draft.number != kNoNumber) {
    const auto [entry, added] = by_number_.try_emplace(draft.number, index);
    if (!added) return entry->second;
  }
  drafts_.push_back(std::move(draft));
  return index;
}

bool Tree::is_numbered() const {
  if (by_number_.empty() || by_number_.rbegin()->first != by_number_.size() - 1) return false;
  return std::ranges::all_of(
      drafts_, [](const Draft& d) { return d.number != kNoNumber || d.faces_seen == 0; });
}

bool Tree::build(std::vector<Part>& parts, std::vector<uint32_t>& new_index) {
  const bool numbered = is_numbered();
  const size_t n = numbered ? by_number_.size() : drafts_.size();
  new_index.resize(drafts_.size());
  for (uint32_t d = 0; d < drafts_.size(); ++d)
    new_index[d] = !numbered                        ? d
                   : drafts_[d].number == kNoNumber ? kNoPart
                                                    : static_cast<uint32_t>(drafts_[d].number);
  const auto place_of = [&](uint64_t number) -> uint64_t {
    const auto found = by_number_.find(number);
    return number == kNoNumber || found == by_number_.end() ? kNoParent : new_index[found->second];
  };
  parts.resize(n);
  for (uint32_t d = 0; d < drafts_.size(); ++d) {
    Draft& draft = drafts_[d];
    if (new_index[d] == kNoPart) continue;
    Part& part = parts[new_index[d]];
    part = std::move(draft.part);
    part.parent = place_of(draft.above);
    part.copied_from = place_of(draft.copied_from);
    if (draft.above == kNoNumber && draft.number == kNoNumber && draft.parent != kNoPart)
      part.parent = new_index[draft.parent];
  }
  // Depth of each part, by walking up to one whose depth is known.
  std::vector<uint32_t> depth(n, 0);
  for (uint64_t p = 0; p < n; ++p) {
    std::vector<uint64_t> path;
    uint64_t at = p;
    for (; at != kNoParent && depth[at] == 0; at = parts[at].parent) {
      path.push_back(at);
      if (path.size() > kMaxPartLevels) return false;
    }
    uint32_t level = at == kNoParent ? 0 : depth[at];
    for (; !path.empty(); path.pop_back()) depth[path.back()] = ++level;
    if (level > kMaxPartLevels) return false;
  }
  return true;
}

}  // namespace jalon::city
