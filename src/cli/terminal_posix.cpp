// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal.h"

#include <csignal>

#include <unistd.h>

namespace jalon::cli {

bool prepare_terminal() { return ::isatty(STDERR_FILENO) != 0; }

void ignore_broken_pipes() { std::signal(SIGPIPE, SIG_IGN); }

}  // namespace jalon::cli
