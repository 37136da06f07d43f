// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal.h"

#include <windows.h>

namespace jalon::cli {

bool prepare_terminal() {
  const HANDLE console = ::GetStdHandle(STD_ERROR_HANDLE);
  DWORD mode = 0;
  if (::GetConsoleMode(console, &mode) == 0) return false;  // a file or a pipe
  ::SetConsoleOutputCP(CP_UTF8);
  return ::SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

void ignore_broken_pipes() {}  // Windows has no such signal

}  // namespace jalon::cli
