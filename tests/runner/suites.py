# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The suites: what each runs, of which build, what must be built for it, and whether it may have company."""

import os
from dataclasses import dataclass, field

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BUILDS = ("release", "asan", "tsan")
SANITIZED = {
    "release": {},
    "asan": {"JALON_SANITIZED": "1", "ASAN_OPTIONS": "detect_leaks=1:allocator_may_return_null=1",
             "UBSAN_OPTIONS": "print_stacktrace=1"},
    "tsan": {"JALON_SANITIZED": "1", "TSAN_OPTIONS": "halt_on_error=1"},
}
# Those whose figures are worth something only on a quiet machine, in the long run: nothing else runs beside them. fresh_root has the
# time of the tests from a clean clone.
ALONE = {"release/capi_cancel_test", "bench", "fresh_root"}
# What takes more than about 20 s of processor, as measured (tests/README.md): started first, so that none ends alone.
LONGEST_FIRST = ["fresh_root", "bindings_from_source", "validators", "release/unit_registration", "accuracy", "bindings_python",
                 "bindings_java", "release/unit_modelling", "bits", "release/unit_segment",
                 "release/capi_cancel_test", "bindings_csharp", "comma_locale", "cli", "asan/capi_null_wild", "asan/cli",
                 "asan/capi_cancel_test", "asan/malformed", "tsan/unit_base"]
# What also runs under the thread sanitizer: the room of the pool, of which all threads of the library come, in every run; what
# needs the whole library built once more (520 s of processor) in the long one.
THREADED = ["unit_base"]
THREADED_FULL = ["capi_threads_test", "capi_threads_operations_test", "capi_search_test", "unit_spatial", "unit_cloud", "unit_segment",
                 "unit_scan", "unit_modelling"]

# Run in each build by the long run, in a short one only where the address sanitizer looks on, which sees more.
ASAN_ALONE = ["capi_null_wild", "capi_sequences"]


@dataclass
class Suite:
    name: str
    command: list
    build: str = "release"
    targets: list = field(default_factory=list)  # of ninja; none: only the build's configuration
    full: bool = False  # too long for every change
    packages: list = field(default_factory=list)  # of Debian, beyond those of run.sh

    @property
    def is_alone(self):
        return self.name in ALONE and "JALON_FULL" in os.environ

    @property
    def environment(self):
        return SANITIZED[self.build]


def folder(build):
    return os.path.join(ROOT, "build", build)


def unit_programs():
    """A doctest program for each room with tests."""
    unit = os.path.join(ROOT, "tests", "unit")
    rooms = (r for r in sorted(os.listdir(unit)) if os.path.isdir(os.path.join(unit, r)))
    return ["unit_" + r for r in rooms if any(n.endswith("_test.cpp") for _, _, names in os.walk(os.path.join(unit, r)) for n in names)]


def c_programs():
    def of(folder):
        return [folder + "_" + n[:-2] for n in sorted(os.listdir(os.path.join(ROOT, "tests", folder))) if n.endswith("_test.c")]
    return of("capi") + ["capi_null_wild", "capi_sequences"] + of("reliability")


def program(name, build, full=False):
    return Suite(build + "/" + name, [os.path.join(folder(build), "tests", name)], build, [name], full)


def script(name, path, targets, arguments=None, full=False, packages=(), build="release"):
    interpreter = "python3" if path.endswith(".py") else "bash"
    return Suite(name, [interpreter, path] + ([folder(build)] if arguments is None else arguments), build, targets, full,
                 list(packages))


def release_suites():
    tool = os.path.join(folder("release"), "src", "jalon")
    everything = ["bindings", "examples/all", "jalon_cli"]
    return [program(name, "release", full=name in ASAN_ALONE) for name in unit_programs() + c_programs()] + [
        script("style", "tests/style/check.py", []),
        script("abi", "tests/abi/check.sh", ["jalon"]),
        script("install", "tests/install/check.sh", ["jalon", "jalon_cli"]),
        script("libccd", "tests/install/single_ccd.sh", [], []),
        script("missing", "tests/install/missing.sh", [], full=True),
        script("comma_locale", "tests/capi/comma_locale.sh", ["c_tests", "jalon_cli"]),
        script("bits", "tests/scenarios/bits.sh", ["bits"]),
        script("cli", "tests/scenarios/cli.sh", ["jalon_cli"], [tool]),
        script("cli_stations", "tests/scenarios/cli_stations.sh", ["jalon_cli"], [tool]),
        script("cli_compare", "tests/scenarios/cli_compare.sh", ["jalon_cli"], [tool]),
        script("cli_mistakes", "tests/scenarios/cli_mistakes.sh", ["jalon_cli"], [tool]),
        script("cli_names", "tests/scenarios/hostile_names.py", ["jalon_cli"], [tool]),
        script("cli_facades", "tests/scenarios/cli_facades.sh", ["jalon_cli"], [tool]),
        script("malformed", "tests/fuzz/malformed.sh", ["malformed_files"]),
        script("hardening", "tests/reliability/hardening.sh", ["jalon", "jalon_cli"]),
        script("replay", "tests/fuzz/replay.sh", ["fuzz_replay"]),
        script("reliability_page", "tests/reliability/page.py", [], []),
        script("reliability_states", "tests/reliability/page_test.py", [], []),
        script("laspy", "tests/fuzz/laspy.sh", ["jalon"]),
        script("laspy_offline", "tests/offline.sh", [], ["tests/fuzz/laspy.sh", "laspy"]),
        script("validators", "tests/formats/validators.sh", ["jalon_cli", "house_files", "scan_files"]),
        script("validators_offline", "tests/offline.sh", [], ["tests/formats/validators.sh", "ezdxf.*"]),
        Suite("accuracy", [os.path.join(folder("release"), "tests", "accuracy", "accuracy")], targets=["accuracy"]),
        script("examples", "tests/scenarios/examples.sh", ["jalon_cli", "examples/all"]),
        script("runner", "tests/runner/schedule_test.py", [], []),
        script("bench_verdicts", "tests/bench/verdicts_test.py", [], []),
        script("bindings", "tests/bindings/reachable.py", ["bindings"]),
        script("bindings_python", "tests/bindings/python.sh", everything),
        script("bindings_offline", "tests/offline.sh", [], ["tests/bindings/python.sh", "numpy and scikit-build-core"]),
        script("bindings_csharp", "tests/bindings/csharp.sh", everything),
        script("bindings_java", "tests/bindings/java.sh", everything),
    ]


def sanitized_suites():
    """Every change runs what sees the whole library through its C surface; --full adds the unit tests."""
    asan = [program(name, "asan") for name in c_programs()] + [
        script("asan/cli", "tests/scenarios/cli.sh", ["jalon_cli"], [os.path.join(folder("asan"), "src", "jalon")], build="asan"),
        script("asan/malformed", "tests/fuzz/malformed.sh", ["malformed_files"], build="asan"),
        script("asan/replay", "tests/fuzz/replay.sh", ["fuzz_replay"], build="asan")]
    asan += [program(name, "asan", full=True) for name in unit_programs()]
    tsan = [program(name, "tsan") for name in THREADED]
    return asan + tsan + [program(name, "tsan", full=True) for name in THREADED_FULL]


def full_suites():
    return [
        script("bindings_from_source", "tests/bindings/from_source.sh", ["bindings", "examples/all", "jalon_cli"], full=True,
               packages=["maven"]),
        script("bindings_asan", "tests/bindings/python_asan.sh", ["bindings"], full=True),
        script("cppcheck", "tests/style/cppcheck.sh", [], [], full=True, packages=["cppcheck"]),
        script("tidy", "tests/style/tidy.sh", [], [], full=True, packages=["clang-14", "clang-tidy-14"]),
        script("clang", "tests/install/clang.sh", ["bits"], full=True, packages=["clang-14", "clang-19"]),
        script("fuzz", "tests/fuzz/fuzz.sh", [], ["300"], full=True, packages=["clang-14", "libclang-rt-14-dev"]),
        script("reproducible", "tests/install/reproducible.sh", ["jalon", "jalon_cli"], full=True),
        script("valgrind", "tests/reliability/valgrind.sh", ["c_tests", "fuzz_replay"], full=True, packages=["valgrind"]),
        script("integer", "tests/reliability/integer.sh", [], [], full=True, packages=["clang-14", "libclang-rt-14-dev"]),
        script("hostile", "tests/reliability/hostile.sh", ["counted_calls"], full=True, packages=["valgrind"]),
        script("mutation", "tests/reliability/mutation.py", [], [os.path.join(ROOT, "build", "work", "mutation", "copy")], full=True),
        script("coverage", "tests/reliability/coverage.sh", [], [os.path.join(ROOT, "build", "work", "coverage")], full=True,
               packages=["gcovr"]),
        script("mingw", "tests/install/mingw.sh", [], [], full=True, packages=["g++-mingw-w64-x86-64-posix", "libz-mingw-w64-dev", "wine64"]),
        script("viewer", "tests/viewer/check.py", ["jalon_cli"], full=True, packages=["chromium"]),
        script("cloudcompare", "tests/formats/check_cloudcompare.py", ["jalon_cli"], full=True, packages=["cloudcompare"]),
        script("static", "tests/install/static.sh", [], [], full=True),
        script("new_method", "tests/scenarios/new_method.sh", [], [], full=True),
        script("fresh_root", "tests/install/fresh_root.sh", [], [], full=True),
        script("bench", "tests/bench/run.sh", [], [], full=True),
    ]


def all_suites():
    return release_suites() + sanitized_suites() + full_suites()
