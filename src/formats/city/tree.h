// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/json_cursor.h"
#include "model/model.h"

namespace jalon::city {

constexpr uint64_t kNoNumber = ~uint64_t{0};

/// What an object or a semantic surface says about a part and its faces.
struct Draft {
  Part part;
  uint64_t number = kNoNumber;  ///< "part": its place in the tree that the file was written from
  uint64_t above = kNoNumber;   ///< "part_of"
  uint64_t copied_from = kNoNumber;  ///< the number of the part it repeats
  uint32_t parent =
      kNoPart;  ///< without numbers: the draft above, an object or the surface of a wall
  bool is_closing = false;  ///< its surfaces were made to close the hole of a wall
  bool is_opening = false;  ///< window, door or closure
  std::vector<uint32_t> face_ids;
  std::vector<double> sigmas_m;
  size_t faces_seen = 0;  ///< faces that it has; so many of face_ids and sigmas_m are taken
};

/// Reads the attributes we know from an object at the cursor; class and numbers count only with "part", which files of
/// other programs do not have. Unknown members and kinds are skipped. rest(name) may take others: true when it did.
template <class F>
void read_attributes(JsonCursor& cursor, Draft& draft, F&& rest);
/// One member; false when it is none of ours (it has not been taken then).
bool read_attribute(JsonCursor& cursor, const std::string& name, Draft& draft,
                    std::string& part_class);

/// The parts of a file on their way to a tree.
class Tree {
 public:
  /// The draft's index; those of the same number are one.
  uint32_t add(Draft draft);
  Draft& at(uint32_t index) { return drafts_[index]; }
  size_t size() const { return drafts_.size(); }

  /// Parts in the order of their numbers where every draft has one, else as they came; new_index[draft] is where it
  /// went. An object without number and faces is no part then: it only held the others. False when the tree is no tree,
  /// or deeper than 64 levels.
  bool build(std::vector<Part>& parts, std::vector<uint32_t>& new_index);

 private:
  bool is_numbered() const;
  std::vector<Draft> drafts_;
  std::map<uint64_t, uint32_t> by_number_;
};

template <class F>
void read_attributes(JsonCursor& cursor, Draft& draft, F&& rest) {
  std::string part_class;
  cursor.begin_object();
  for (std::string name; cursor.next_member(name);)
    if (!read_attribute(cursor, name, draft, part_class) && !rest(name)) cursor.skip();
  if (draft.number != kNoNumber && !part_class.empty()) draft.part.part_class = part_class;
}

}  // namespace jalon::city
