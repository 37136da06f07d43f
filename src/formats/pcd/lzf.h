// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace jalon::pcd {

/// How many bytes the tokens stand for; all bits set where they end too early.
uint64_t unpacked_lzf_bytes(std::span<const std::byte> packed);
/// What LZF packed (the format of liblzf, as in PCD's binary_compressed): fills `out` whole and
/// returns true; false where the bytes end too early, give more or less, or look back beyond their
/// beginning.
bool unpack_lzf(std::span<const std::byte> packed, std::span<std::byte> out);

}  // namespace jalon::pcd
