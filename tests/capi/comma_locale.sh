#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The C tests of a build through which text passes, and the tool, as a host with a decimal comma, and with the Turkish i:
# comma_locale.sh BUILD_FOLDER. The tests in German, with JALON_FULL in French and Turkish too; the tool in all three.
# The locales are made inside the build folder; nothing of the system changes.
set -uo pipefail
build=$(cd "$1" && pwd)
here=$(dirname "$0")
export LOCPATH=$build/locales
locales="de_DE.UTF-8 fr_FR.UTF-8 tr_TR.UTF-8"
passed=0 failed=0 skipped=0
mkdir -p "$LOCPATH"
for locale in $locales; do
  [ -d "$LOCPATH/$locale" ] || localedef -i "${locale%.*}" -f UTF-8 "$LOCPATH/$locale" || { echo "0 passed, 1 failed, 0 skipped"; exit 1; }
  if [ "$(LC_ALL=$locale locale decimal_point)" != , ]; then
    echo "not ok - comma locale: $locale has a decimal comma"
    failed=$((failed + 1))
  fi
done

# A locale changes what numbers look like in text: JSON, files, logs, messages. Programs whose source names none of these, such as
# cancels, threads and fault injection, have run already; and as few tries as under a sanitizer are enough for text, in the long
# run too.
tests_in() {
  local source name program output
  for source in $(grep -liE 'json|\{\\"|_read\(|_write|_text\(|set_log' "$here"/*_test.c); do
    name=capi_$(basename "$source" .c) program=$build/tests/capi_$(basename "$source" .c)
    [ -x "$program" ] || continue
    output=$(LC_ALL=$1 JALON_SANITIZED=1 env -u JALON_FULL "$program" 2>&1 </dev/null)
    case $? in
      0) passed=$((passed + 1)); echo "ok - comma locale: $name in $1" ;;
      77) skipped=$((skipped + 1)); echo "skipped - comma locale: $name in $1" ;;
      *) failed=$((failed + 1)); echo "not ok - comma locale: $name in $1"; tail -n 15 <<<"$output" ;;
    esac
  done
}
for locale in $locales; do
  [ "$locale" != de_DE.UTF-8 ] && [ -z "${JALON_FULL:-}" ] || tests_in "$locale"
done

# The tool: what it reads from options and text, and what it writes, is the same.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for locale in C $locales; do
  mkdir "$work/$locale"
  (cd "$work/$locale" && export LC_ALL=$locale &&
    "$build/src/jalon" scan --scene facade -o scan.xyz --quiet --set horizontal_step_rad=0.006 --set vertical_step_rad=0.006 &&
    "$build/src/jalon" facade scan.xyz -o . --quiet --set distance_tolerance_m=0.02)
  # The reports tell how long each step took.
  sed -i -E 's/[0-9.]+ s</</g' "$work/$locale/report.html"
  sed -i -E '/"times_s"/,/}/d' "$work/$locale/report.json"
done
for path in "$work"/C/*; do
  file=$(basename "$path")
  for locale in $locales; do
    if cmp -s "$path" "$work/$locale/$file"; then
      passed=$((passed + 1)); echo "ok - comma locale: the tool's $file is the same in $locale"
    else
      failed=$((failed + 1)); echo "not ok - comma locale: the tool's $file is the same in $locale"
    fi
  done
done
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]
