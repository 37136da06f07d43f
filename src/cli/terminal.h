// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jalon::cli {

// The terminal that the tool runs in: terminal_posix.cpp (Linux, macOS) or terminal_windows.cpp is compiled.

/// True when a person sees standard error as it is written; from then on the codes of a progress bar work there.
bool prepare_terminal();

/// Writing to a pipe that nobody reads any longer is an error like others, not the end of the process.
void ignore_broken_pipes();

}  // namespace jalon::cli
