/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Small steps of the generated calls; read inside namespace jalon_binding, after the boxes have their names. */

inline std::string text_of(const char* text) {
  return text == nullptr ? std::string() : std::string(text);
}

/** Names of one kind, none of them empty. */
typedef std::vector<std::string> Texts;
inline Texts texts_of(const char* const* texts, std::uint64_t count) {
  return Texts(texts, texts + count);
}
/** Each with a zero behind it: how they cross to a language that takes them as one block. */
inline std::string block_of(const Texts& texts) {
  std::string block;
  for (const std::string& text : texts) block.append(text.c_str(), text.size() + 1);
  return block;
}

inline std::uint64_t count_of(const jalon_cloud* cloud) {
  std::uint64_t count = 0;
  check(jalon_cloud_count(cloud, &count));
  return count;
}

/** The corners of all rings. */
inline std::uint64_t sum_of(const Packed<std::uint64_t>& rings) {
  std::uint64_t sum = 0;
  for (std::uint64_t i = 0; i < rings.count(); ++i) sum += rings.data()[i];
  return sum;
}

/** The bytes, which keep their handle. */
inline Octets* octets_of(const Owned<jalon_bytes>& bytes) {
  jalon_array_view view = {};
  check(jalon_bytes_view(bytes.get(), &view));
  return view_of<jalon_bytes>(view, bytes.get());
}

template <class H>
void move_into(Owned<H>& to, Owned<H>& from) {
  *to.slot() = from.give();
  to.count();
}
