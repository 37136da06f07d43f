# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The figures of reliability: what is promised, which tests show it, in which run, and what is still missing.

A row: name, figure, the suites that show it with the name of the test (a regular expression that stands in few places of
tests/ and the Java tests, which page.py looks for), whether only the long run makes the whole of it, and what is missing ("" =
nothing: reached where the last run of its suites passed)."""

from collections import namedtuple

Figure = namedtuple("Figure", "name promise shown_by full missing")
LONG, EACH = True, False

FIGURES = [
    Figure("H1", "malformed files: 400 a binary format, 100 a text format, no crash, 2 s, 4 x file + 64 MiB",
           [("malformed", "%zu malformed files, %zu bad"), ("asan/malformed", "%zu malformed files, %zu bad"), ("release/reliability_malformed_trajectories_test", "trajectories__that_are_broken_are_refused_or_read")], EACH, ""),
    Figure("H2", "fuzzing: 10 million inputs a reader, or 2 processor hours, without a finding",
           [("fuzz", "FIGURE fuzzing")], LONG, "so far minutes a target; see the figures"),
    Figure("H3", "the inputs that fuzzing kept are read by every build", [("replay", "replay.sh BUILD_FOLDER"), ("asan/replay", "replay.sh BUILD_FOLDER"), ("valgrind", "FIGURE valgrind")], LONG, ""),
    Figure("H4", "5 million drawn sequences of 1 to 40 calls on all kinds of handles", [("release/capi_sequences", "FIGURE sequences"), ("asan/capi_sequences", "FIGURE sequences")], LONG,
           "20 000 in the long run, 2 000 of them under the address sanitizer"),
    Figure("H5", "differential reading of 300 files a format; whole on 2026-11-26: LAS, LAZ, E57, PLY and PCD, none differs",
           [("laspy", "FIGURE drawn files"), ("laspy", "of pye57 read by Jalon")], LONG, ""),
    Figure("H6", "lying counts allocate less than 1 MiB", [("release/unit_formats", "a_lying_count_is_refused_before_anything_is_allocated"), ("release/reliability_lying_counts_test", "counts__that_lie_take_less_than_a_mebibyte")], EACH, ""),
    Figure("H7", "text bombs: depth and length of tokens limited", [("release/reliability_lying_counts_test", "texts__without_end_are_refused")], EACH, ""),
    Figure("H8", "hostile names change no structure of an output", [("release/unit_formats", "hostile_names_never_leave_their_group"), ("release/unit_report", "hostile_names_stay_text"), ("cli_names", "FIGURE hostile names")], EACH, ""),
    Figure("H9", "layouts that are hard on an index cost at most 20 x a random cloud", [("bench", "sixteen clouds")], LONG, "by the clock of the benchmark, not by counted work"),
    Figure("F1", "allocation failure in at least 40 jobs, once and from then on, no leak",
           [("release/capi_allocation_test", "out_of_memory__is_an_ordinary_error_everywhere"),
            ("release/reliability_allocation_test", "out_of_memory__in_operations_and_files_is_an_ordinary_error")], LONG, "the long form has not been run; each run takes a part of the allocations"),
    Figure("F2", "a memory budget a task: what would exceed it is refused, at 1, 10, 50 and 90 % of what is needed",
           [("release/reliability_memory_limit_test", "memory_limit__below_what_a_call_needs_is_refused_in_words"),
            ("release/reliability_memory_limit_test", "memory_limit__is_kept_by_the_process")], EACH, "no estimate before a call: the peak of a run tells"),
    Figure("F3", "each call to the system fails, is short or interrupted: 500 faults, files stay whole", [("release/reliability_io_faults_test", "io__every_fault_is_an_error_or_nothing_and_leaves_whole_files")], EACH, ""),
    Figure("F4", "10 000 cycles of each handle keep no memory",
           [("release/reliability_cycles_test", "cycles__of_the_whole_surface_keep_no_memory"), ("bindings_python", "python__create_use_close_leaves_nothing")], LONG, "1 000 cycles in C, fewer in the bindings"),
    Figure("F5", "Valgrind: no error, nothing lost, over the C tests; whole on 2026-11-26: 65 programs, capi_cancel_test by itself", [("valgrind", "FIGURE valgrind")], LONG, ""),
    Figure("F6", "eight simulated hours of mixed calls, a million of them", [("release/reliability_soak_test", "soak__eight_hours_of_drawn_jobs_keep_no_memory")], LONG, ""),
    Figure("F7", "counts about 2^31, 2^32 and 2^63", [("malformed", "every header field at its limits")], EACH, "no pass over 2^32 points; no integer sanitizer"),
    Figure("F8", "every operation on a stack of 256 KiB, frames below 16 KiB; with 10^6 points on 2026-11-26: 196 runs", [("release/reliability_stack_test", "stack__of_256_kib_is_enough_for_every_operation")], LONG, ""),
    Figure("F9", "descriptors: none left after 1 000 failures, none inherited",
           [("release/reliability_descriptors_test", "descriptors__of_three_thousand_failures_are_closed"),
            ("release/reliability_descriptors_test", "descriptors__of_open_files_are_not_inherited")], EACH, ""),
    Figure("T1", "thread sanitizer: 8 threads x 1 000 x 6 kinds of work", [("tsan/capi_threads_test", "threads__may_all_query_one_cloud"), ("tsan/capi_threads_operations_test", "threads__run_every_operation_on_one_cloud"), ("tsan/unit_base", "pool__does_every_chunk_once_run_after_run")], LONG, "the long form, 24 rounds of 42 operations in each thread, has not been run under the sanitizer"),
    Figure("T2", "same bits with 1, 2, 3, 7, 16 threads, 12 operations, 5 seeds, by two compilers", [("bits", "bits.sh BUILD_FOLDER"), ("clang", "its results have the bits")], LONG, "the long form, with 3 and 16 threads and five seeds, has not been run"),
    Figure("T3", "cancel at 2 400 places, outputs untouched, nothing kept", [("release/capi_cancel_test", "cancel__at_any_moment_ends_any_call_without_an_output")], LONG, "fewer places in each run"),
    Figure("T4", "cancel: 99 in 100 within 100 ms", [("release/capi_cancel_test", "FIGURE cancel latency")], LONG, "measured up to 1 M points, reading and writing apart"),
    Figure("T5", "Ctrl-C in Python, 100 times in each of ten kinds of calls; whole on 2026-11-26: median 44 ms, worst 156",
           [("bindings_python", "python__ctrl_c_stops_ten_kinds_of_calls")], LONG, ""),
    Figure("T6", "processes by fork and by spawn, 100 each; whole on 2026-11-26: none fails",
           [("bindings_python", "python__forked_processes_work_as_their_parent"), ("bindings_python", "python__spawned_processes_work_as_their_parent"),
            ("release/capi_threads_test", "process__may_fork_after_use")], LONG, ""),
    Figure("T7", "what a host's callback throws comes back as itself",
           [("bindings_python", "FIGURE callbacks of Python"), ("bindings_java", "FIGURE callbacks of Java"), ("bindings_csharp", "FIGURE callbacks of C#"),
            ("bindings_python", "python__an_exception_of_the_callable_surfaces_as_itself")], EACH, ""),
    Figure("B1", "types and functions as committed", [("abi", "abi: the exported symbols equal the committed list")], EACH, "no release is tagged yet"),
    Figure("B2", "old consumers run", [], LONG, "there is no older release"),
    Figure("B3", "nothing but jalon_* leaves the library", [("abi", "only plain jalon_ functions of node")], EACH, ""),
    Figure("B4", "headers alone, by C99 to C++20, and by a 32-bit compiler", [("style", "headers: each compiles alone"), ("hardening", "headers: a 32-bit compiler takes them")], EACH, ""),
    Figure("B5", "every function is within the guard; 20 kinds of throws become codes", [("style", "every status from guard"), ("release/unit_capi", "guard__turns_every_kind_of_throw_into_a_status_and_one_line")], EACH, ""),
    Figure("B6", "1 000 loads and unloads leave no trace; two copies side by side",
           [("release/reliability_load_test", "load__a_thousand_times_leaves_the_process_as_it_was"), ("release/reliability_load_test", "load__two_copies_work_side_by_side")], EACH, ""),
    Figure("B7", "the host's rounding, flushing and traps change no bit and come back", [("release/reliability_arithmetic_test", "arithmetic__of_the_host_changes_no_bit_and_comes_back"), ("style", "no fast-math")], EACH, ""),
    Figure("B8", "German, French and Turkish: the same text", [("comma_locale", "the tool's .file is the same in .locale")], LONG, "the tool in all three, the C tests in German; the long form has not been run"),
    Figure("B9", "FORTIFY, stack protector, RELRO, no executable stack, CET", [("hardening", "libjalon: buffers of known size are checked"), ("abi", "full RELRO")], EACH, "the mark of CET stands in the objects of C++, not in the whole library (Rust's have none)"),
    Figure("B10", "the same build twice gives the same bytes", [("reproducible", "has the same bytes")], LONG, "library and tool are the same from two folders (2026-11-26); the wheel's are not compared"),
    Figure("B11", "misuse of bindings: 1 000 a language become exceptions",
           [("bindings_python", "FIGURE misuses of Python"), ("bindings_java", "FIGURE misuses of Java"), ("bindings_csharp", "FIGURE misuses of C#"),
            ("bindings_csharp", "Dispose__races_with_calls_and_never_crashes")], EACH, ""),
    Figure("B12", "native parts are found in every layout", [("bindings_python", "python__other_builds_of_its_libraries_in_the_process_are_not_met"), ("bindings_java", "errors__a_second_class_loader_has_its_own_library"), ("bindings_python", "python__masks_work_without_numpy"),
            ("bindings_csharp", "run as a copy in the host's cache"), ("bindings_csharp", "two in one process, each with a copy of its own")], EACH, ""),
    Figure("Q1", "distances as by brute force to 1e-12", [("release/reliability_distances_test", "distances__are_those_of_all_pairs_to_1e_12")], EACH, ""),
    Figure("Q2", "50 scenes of M3C2 against another program", [("bindings_python", "FIGURE M3C2 against NumPy")], EACH, ""),
    Figure("Q3", "ellipsoids of registration cover in 93 to 97 %", [("release/unit_registration", "icp__ellipsoids_cover_the_truth_as_often_as_they_say")], LONG, "the long form was run by itself on 2026-11-26: 93.4 to 96.8 % of 1 000 in each of six scenes"),
    Figure("Q4", "clouds that hold no surface end in the documented status", [("release/capi_degenerate_test", "every_method_and_choice__gives_the_documented_status")], EACH, ""),
    Figure("Q5", "1 000 round trips a format", [("release/reliability_round_trips_test", "round_trips__of_drawn_clouds_keep_what_each_format_promises")], LONG, ""),
    Figure("Q6", "coverage: 95 % of lines, 90 % of branches", [], LONG, "not measured"),
    Figure("Q7", "Clang, clang-tidy and cppcheck without a word", [("clang", "library and tool compile without a warning")], LONG, "Clang only"),
]
