#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# What an installed library and its tool owe their host, beyond what tests/abi looks at: hardening.sh BUILD_FOLDER, a release build
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$(realpath "${1:?usage: hardening.sh BUILD_FOLDER}")
library=$build/src/libjalon.so tool=$build/src/jalon
passed=0 failed=0
check() { # check NAME COMMAND ...
  local name=$1
  shift
  if "$@" >/dev/null 2>&1; then passed=$((passed + 1)); echo "ok - hardening: $name"; else
    failed=$((failed + 1)); echo "not ok - hardening: $name"
  fi
}
# What is searched comes by no pipe: grep ends with the first line found, and what still writes would be said to have failed.
shows() { grep -qE -- "$3" <<<"$(readelf "$1" -W "$2")"; }
lacks() { ! shows "$@"; }
calls() { grep -qE -- "$2" <<<"$(nm -D --undefined-only "$1")"; }
all_enforced() {
  local objects=() object
  while read -r object; do objects+=("$object"); done < <(find "$build/src/CMakeFiles" -name '*.o')
  [ ${#objects[@]} -gt 0 ] && [ "$(readelf -nW "${objects[@]}" | grep -c 'x86 feature: IBT, SHSTK')" -eq ${#objects[@]} ]
}
read_by_32_bits() {
  local header
  for header in "$root"/include/jalon/*.h; do
    printf '#include <jalon/%s>\n' "$(basename "$header")" |
      cc -m32 -ffreestanding -std=c99 -Wall -Wextra -Werror -fsyntax-only -I"$root/include" -x c - || return 1
  done
}

check "jalon: addresses are read-only once they are known" shows -d "$tool" 'BIND_NOW|FLAGS.*NOW'
check "jalon: no segment is both written and executed" lacks -l "$tool" '(LOAD|GNU_STACK).*RWE'
check "jalon: overwritten stacks are noticed" calls "$tool" ' __stack_chk_fail'
check "libjalon: overwritten stacks are noticed" calls "$library" ' __stack_chk_fail'
check "libjalon: buffers of known size are checked (FORTIFY)" calls "$library" ' __[a-z]+_chk(@|$)'
# The whole library bears the mark of landing places (IBT) where all that is linked does; Rust's objects and the system's crti.o do not.
check "libjalon: return addresses may be kept on a shadow stack (CET)" shows -n "$library" 'x86 feature:.*SHSTK'
check "jalon: return addresses may be kept on a shadow stack (CET)" shows -n "$tool" 'x86 feature:.*SHSTK'
check "libjalon: each object of ours is made for control-flow enforcement (CET)" all_enforced
check "headers: a 32-bit compiler takes them" read_by_32_bits
echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ]
