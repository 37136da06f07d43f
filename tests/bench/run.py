#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""run.py: Jalon beside its peers, in paired runs; see README.md.

All drivers of one size and thread count stay alive and take turns: in each round each library does
each operation once, so that whatever the machine does in the meantime meets all of them alike. The
verdict is the median over the rounds of (time of the fastest peer) / (time of Jalon). Reading comes
first, with only its own drivers alive: it is decided by how fast fresh memory can be had, and of that
little is left once a dozen programs hold a large scene each."""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import time

import checks
import limits
from limits import SEGMENTING
from verdicts import ABSENT, CLOCK_TICK_S, summary, verdict

READING = ["las0", "las3", "laz0", "laz3"]
COMPARING = ["c2c", "c2c_plane", "c2c_quadric"]  # no peer here has local models
M3C2 = ["m3c2_100k", "m3c2_1m"]  # with drivers of their own
MESH = ["c2m_13k", "c2m_1m"]  # the same; name -> sides of the triangles below
MESH_CELLS_M = {"mesh13k": 1.2, "mesh1m": 0.081}
REGISTERING = ["icp"]  # the same
MODELLING = ["outlines", "facade_dxf"]  # no peer does them
OPERATIONS = READING + ["index", "knn16", "normals16", "voxel5cm"] + COMPARING + M3C2 + MESH + REGISTERING
OPERATIONS += SEGMENTING + MODELLING


def peer_commands(build, prefix):
    """Name -> command of every driver that was built or installed."""
    here = pathlib.Path(__file__).resolve().parent
    folder = build / "tests" / "bench"
    python = next((p for p in [build / "peers/venv/bin/python"] if p.exists()), sys.executable)
    commands = {
        "Jalon": [folder / "bench_jalon", prefix],
        "small_gicp": [folder / "bench_small_gicp", prefix],
        "nanoflann": [folder / "bench_nanoflann", prefix],
        "nanoflann-f64": [folder / "bench_nanoflann", prefix, "f64"],
        "PCL": [folder / "bench_pcl", prefix],
        "CGAL": [folder / "bench_cgal", prefix],
        "Open3D": [python, here / "bench_open3d.py", prefix],
        "Open3D-tensor": [python, here / "bench_open3d.py", prefix, "tensor"],
        "LASzip": [folder / "bench_laszip", prefix],
        "LASzip-all": [folder / "bench_laszip", prefix, "all"],
    }
    return runnable(commands)


def m3c2_commands(build, prefix):
    """The same of the drivers that compare surfaces."""
    here = pathlib.Path(__file__).resolve().parent
    commands = {"Jalon": [build / "tests/bench/bench_m3c2", prefix]}
    python = build / "peers/venv/bin/python"
    if next(build.glob("peers/venv/lib/python*/site-packages/py4dgeo"), None):
        commands["py4dgeo"] = [python, here / "bench_py4dgeo.py", prefix]
        commands["py4dgeo-median"] = [python, here / "bench_py4dgeo.py", prefix, "median"]
    return runnable(commands)


def mesh_commands(build, prefix):
    """The same of the drivers that measure distances from triangles."""
    here = pathlib.Path(__file__).resolve().parent
    commands = {
        "Jalon": [build / "tests/bench/bench_mesh", prefix],
        "CGAL": [build / "tests/bench/bench_cgal_mesh", prefix],
        "Open3D": [build / "peers/venv/bin/python", here / "bench_open3d_mesh.py", prefix],
    }
    return runnable(commands)


def icp_commands(build, prefix):
    """The same of the drivers that lay one scan onto another."""
    here, folder = pathlib.Path(__file__).resolve().parent, build / "tests/bench"
    open3d = [build / "peers/venv/bin/python", here / "bench_open3d_icp.py", prefix]
    commands = {
        "Jalon": [folder / "bench_icp", prefix],
        "small_gicp": [folder / "bench_small_gicp_icp", prefix],
        "small_gicp-gicp": [folder / "bench_small_gicp_icp", prefix, "gicp"],
        "small_gicp-cauchy": [folder / "bench_small_gicp_icp", prefix, "cauchy"],
        "PCL": [folder / "bench_pcl_icp", prefix],
        "Open3D": open3d,
        "Open3D-tukey": open3d + ["tukey"],
        "Open3D-scales": open3d + ["scales"],
    }
    return runnable(commands)


def runnable(commands):
    return {
        name: [str(part) for part in command]
        for name, command in commands.items()
        if pathlib.Path(command[0]).exists()
    }


class Driver:
    """A peer's process, pinned to as many processors as it has threads."""

    def __init__(self, name, command, threads, cpus):
        self.name, self.threads = name, threads
        environment = dict(os.environ, OMP_NUM_THREADS=str(threads), LC_ALL="C")
        self.process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env=environment,
            preexec_fn=lambda: os.sched_setaffinity(0, cpus[:threads]),
        )
        self.operations = []

    def wait_until_ready(self):
        self.operations = self._answer("ready|")[2].split(",")

    def run(self, operation, sample_path=""):
        """Seconds, how many results, and processor seconds (user and system, freeing included)."""
        before = self._processor_s()
        self.process.stdin.write(f"{operation} {self.threads} {sample_path}\n")
        self.process.stdin.flush()
        answer = self._answer(self.name + "|")
        return float(answer[4]), int(answer[5]), self._processor_s() - before

    def close(self):
        self.process.stdin.close()
        self.process.wait()

    def _processor_s(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) * CLOCK_TICK_S

    def _answer(self, start):
        for line in self.process.stdout:  # libraries may print lines of their own
            if line.startswith(start):
                return line.strip().split("|")
        raise SystemExit(f"{self.name}: its driver ended early")


def scene(build, data, size):
    prefix = data / f"street_{size}"
    if not (data / f"street_{size}.planes").exists():
        data.mkdir(parents=True, exist_ok=True)
        subprocess.run(
            [str(build / "tests/bench/street_scene"), str(prefix), str(size)],
            check=True,
            stdout=sys.stderr,
        )
    for part in ("pf0", "pf3"):
        if not (data / f"street_{size}_{part}.laz").exists():
            subprocess.run(
                [str(build / "src/jalon"), "convert", "--quiet", f"{prefix}_{part}.las", f"{prefix}_{part}.laz"],
                check=True,
                stdout=sys.stderr,
            )
    # The second scan, that is compared with it, and the same moved, that is laid onto it.
    for name, kind in (("second", "points"), ("moved", "moved")):
        second = data / f"street_{size}_{name}"
        if not second.with_name(second.name + ".f64").exists():
            subprocess.run(
                [str(build / "tests/bench/street_scene"), str(second), str(size), "2", kind],
                check=True,
                stdout=sys.stderr,
            )
    for name, cell_m in MESH_CELLS_M.items():
        if not (data / f"street_{size}_{name}.f64").exists():
            subprocess.run(
                [str(build / "tests/bench/street_mesh"), f"{prefix}_{name}", str(cell_m)],
                check=True,
                stdout=sys.stderr,
            )
    return prefix


def run_rounds(drivers, operations, rounds, pause_s):
    """times[operation][peer] = one number a round, and the same of processor seconds."""
    times = {operation: {} for operation in operations}
    processor = {operation: {} for operation in operations}
    for turn in range(rounds):
        order = drivers[turn % len(drivers) :] + drivers[: turn % len(drivers)]
        for operation in operations:
            for driver in order:
                if operation in driver.operations:
                    time.sleep(pause_s)  # lets the worker threads of the one before go to sleep
                    seconds, _, processor_s = driver.run(operation)
                    times[operation].setdefault(driver.name, []).append(seconds)
                    processor[operation].setdefault(driver.name, []).append(processor_s)
    return times, processor


def measure(arguments, operations, build, prefix, size, threads, cpus):
    """The rows of some operations of one group."""
    wanted = arguments.peers.split(",") if arguments.peers else None
    drivers = []
    own_drivers = {**dict.fromkeys(M3C2, m3c2_commands), **dict.fromkeys(MESH, mesh_commands)}
    own_drivers |= dict.fromkeys(REGISTERING, icp_commands)
    commands = own_drivers.get(operations[0], peer_commands)
    for name, command in commands(build, prefix).items():
        reads = name.startswith("LASzip")
        if name != "Jalon" and (reads != (operations[0] in READING) or (wanted and name not in wanted)):
            continue
        drivers.append(Driver(name, command, threads, cpus))
    for driver in drivers:
        driver.wait_until_ready()
    failures = checks.same_work(drivers, operations, prefix) if arguments.check else []
    times, processor = run_rounds(drivers, operations, arguments.rounds, arguments.pause)
    for driver in drivers:
        driver.close()
    rows = [
        dict(verdict(operation, times[operation], processor[operation], wanted), points=size, threads=threads)
        for operation in operations
    ]
    return rows, failures


def print_table(rows):
    print(
        "\n| points | threads | operation | Jalon s | fastest peer | s | peer / Jalon (range) | "
        "of processor s | | others s |"
    )
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    for row in rows:
        medians = row["medians"]
        best = row.get("best", "")
        others = ", ".join(
            f"{peer} {value:.3f}"
            for peer, value in sorted(medians.items(), key=lambda item: item[1])
            if peer not in ("Jalon", best)
        )
        jalon = f"{medians['Jalon']:.3f}" if "Jalon" in medians else "-"
        ratio = (
            f"{row['ratio']:.2f} ({row['lowest']:.2f}-{row['highest']:.2f})"
            if "ratio" in row
            else "-"
        )
        spent = f"{row['processor_ratio']:.2f}" if best else "-"
        peer_s = f"{medians[best]:.3f}" if best else "-"
        mark = row.get("mark", "")
        if mark == ABSENT:
            mark += ": " + ", ".join(row["absent"])
        print(
            f"| {row['points']} | {row['threads']} | {row['operation']} | {jalon} | "
            f"{best or '-'} | {peer_s} | {ratio} | {spent} | "
            f"{mark} | {others} |"
        )


def machine():
    model = "unknown processor"
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            model = line.split(":", 1)[1].strip()
    return {
        "processor": model,
        "processors": os.cpu_count(),
        "load_at_start": os.getloadavg()[0],
        "date": time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime()),
    }


def main():
    parser = argparse.ArgumentParser(description="Paired benchmarks of Jalon and its peers.")
    parser.add_argument(
        "--build", required=True, help="build folder made with JALON_BUILD_BENCHMARKS=ON"
    )
    parser.add_argument("--data", help="folder of the scenes (BUILD/bench-data)")
    parser.add_argument("--sizes", default="1e6,5e6")
    parser.add_argument("--threads", default="1,2")
    parser.add_argument(
        "--ops", default=",".join(OPERATIONS), help="among " + ", ".join(OPERATIONS)
    )
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--peers", default="", help="only these (default: all that were built)")
    parser.add_argument(
        "--pause", type=float, default=0.05, help="seconds between two measurements"
    )
    parser.add_argument(
        "--no-check", dest="check", action="store_false", help="skip the comparison of the results"
    )
    parser.add_argument(
        "--no-memory", dest="memory", action="store_false", help="skip the memory measurement"
    )
    parser.add_argument("--json", help="file for all numbers")
    arguments = parser.parse_args()
    arguments.operations = arguments.ops.split(",")
    build = pathlib.Path(arguments.build).resolve()
    data = pathlib.Path(arguments.data).resolve() if arguments.data else build / "bench-data"
    cpus = sorted(os.sched_getaffinity(0))
    result = {
        "machine": machine(),
        "rounds": arguments.rounds,
        "rows": [],
        "memory": [],
        "growth": [],
        "failures": [],
    }
    if result["machine"]["load_at_start"] > 0.5:
        print(
            f"note: the machine is busy (load {result['machine']['load_at_start']:.1f}); "
            "take the numbers as a hint",
            file=sys.stderr,
        )
    sizes = [int(float(text)) for text in arguments.sizes.split(",")]
    threads_wanted = [int(text) for text in arguments.threads.split(",")]
    group_of = {operation: 0 for operation in READING} | {operation: 2 for operation in M3C2}
    group_of |= {operation: 3 for operation in MESH} | {operation: 4 for operation in REGISTERING}
    groups = [
        [operation for operation in arguments.operations if group_of.get(operation, 1) == group]
        for group in range(5)
    ]
    for operations in filter(None, groups):
        for size in sizes:
            prefix = scene(build, data, size)
            for threads in threads_wanted:
                rows, failures = measure(arguments, operations, build, prefix, size, threads, cpus)
                result["rows"] += rows
                result["failures"] += failures
                print_table(rows)
                sys.stdout.flush()
    result["growth"] = limits.growth(result["rows"])
    if arguments.memory:
        for size in sizes:
            prefix = scene(build, data, size)
            result["memory"].append(limits.memory(build, prefix, max(threads_wanted)))
            result["memory"] += limits.comparison_memory(build, prefix, max(threads_wanted))
    if arguments.json:
        pathlib.Path(arguments.json).write_text(json.dumps(result, indent=1) + "\n")
    marks = [row.get("mark") for row in result["rows"] + result["growth"]]
    marks += [stage["mark"] for stage in result["memory"] if stage]
    text, is_good = summary(marks, len(result["failures"]))
    print(f"\n{result['machine']}\n{text}")
    sys.exit(0 if is_good else 1)


if __name__ == "__main__":
    main()
