# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""--full in parts of like length; all parts together are the whole, whatever the times."""

# Minutes of the long forms, on two quiet cores (tests/README.md); what is not named takes less than one.
MINUTES = {"fresh_root": 45, "bench": 60, "fuzz": 95, "clang": 17, "cppcheck": 2, "tidy": 15, "mingw": 4, "static": 4,
           "reproducible": 11, "valgrind": 40, "hostile": 25, "mutation": 45, "integer": 15, "release/reliability_soak_test": 15,
           "release/capi_allocation_test": 40, "release/reliability_allocation_test": 8, "release/capi_sequences": 16, "asan/capi_sequences": 16}


def part_of(suites, part, parts):
    """The suites of one part: the longest first, each into the part that is shortest so far."""
    if not 1 <= part <= parts:
        raise SystemExit("tests/run.sh: there is no part %d of %d" % (part, parts))
    lengths, chosen = [0.0] * parts, []
    for suite in sorted(suites, key=lambda s: (-MINUTES.get(s.name, 1), s.name)):
        shortest = lengths.index(min(lengths))
        lengths[shortest] += MINUTES.get(suite.name, 1)
        if shortest == part - 1:
            chosen.append(suite.name)
    return [s for s in suites if s.name in chosen]
