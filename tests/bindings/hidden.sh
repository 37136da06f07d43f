#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# Runs a command where the system's FCL, libccd, OctoMap and SQLite are empty files, as on a machine without them: hidden.sh COMMAND ...
# 77 where this user may not make such a place (a mount namespace).
set -uo pipefail
if [ "${1:-}" != --inside ]; then
  user=()
  [ "$(id -u)" -eq 0 ] || user=(--map-root-user)
  unshare "${user[@]}" --mount true 2>/dev/null || { echo "hidden.sh: no mount namespace can be made here" >&2; exit 77; }
  exec unshare "${user[@]}" --mount bash "$0" --inside "$@"
fi
shift
empty=$(mktemp)
for library in $(/sbin/ldconfig -p | grep -oE '/\S*/lib(fcl|ccd|octomap|octomath|sqlite3)\.so\S*' | xargs -r readlink -f | sort -u); do
  mount --bind "$empty" "$library" || exit 77
done
rm "$empty"
exec "$@"
