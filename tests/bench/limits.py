# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Limits that no peer sets: memory, and how times grow with the points."""

import subprocess

SEGMENTING = ["planes", "region_growing"]
MEMORY_NOW, MEMORY_PEAK = 60.0, 120.0  # bytes a point: coordinates + index + float normals
MEMORY_COMPARING = 60.0  # bytes a point of both clouds (and a triangle of the mesh) beyond the coordinates
GROWTH = 6.0  # segmenting five times the points may take so many times as long


def memory(build, prefix, threads):
    """Bytes a point of Jalon's cloud after each stage, and whether the limits hold."""
    program = build / "tests/bench/memory_jalon"
    if not program.exists():
        return None
    text = subprocess.run(
        [str(program), str(prefix), str(threads)], check=True, capture_output=True, text=True
    ).stdout
    stages = {}
    for line in text.splitlines()[1:]:
        _, stage, points, now, peak = line.split("|")
        stages[stage] = (float(now), float(peak) if peak else None)
    now = stages["normals"][0]
    peak = max(stages[stage][1] for stage in ("prepare", "normals", "ransac", "region_growing"))
    mark = "PASS" if now <= MEMORY_NOW and peak <= MEMORY_PEAK else "FAIL"
    print(
        f"memory, {points} points, {threads} threads: {now:.1f} B a point "
        f"(limit {MEMORY_NOW:.0f}), "
        f"peak {peak:.1f} (limit {MEMORY_PEAK:.0f}): {mark}; {stages}"
    )
    return {
        "points": int(points),
        "threads": threads,
        "now": now,
        "peak": peak,
        "mark": mark,
        "stages": stages,
    }


def growth(rows):
    """Time of the largest scene as a multiple of that of the smallest, which has a fifth of its points."""
    results = []
    for operation in SEGMENTING:
        for threads in sorted({row["threads"] for row in rows}):
            medians = {
                row["points"]: row["medians"]
                for row in rows
                if row["operation"] == operation and row["threads"] == threads
            }
            small, large = min(medians, default=0), max(medians, default=0)
            if large != 5 * small or large == 0 or "Jalon" not in medians[small] or "Jalon" not in medians[large]:
                continue
            ratios = {
                peer: medians[large][peer] / medians[small][peer]
                for peer in medians[small]
                if peer in medians[large]
            }
            mark = "PASS" if ratios["Jalon"] <= GROWTH else "FAIL"
            text = ", ".join(f"{peer} {ratio:.2f}" for peer, ratio in ratios.items())
            print(
                f"{operation}, {threads} threads, {large} points take so many times as long as {small}: {text} "
                f"(limit {GROWTH:.0f}): {mark}"
            )
            results.append(
                {"operation": operation, "threads": threads, "ratios": ratios, "mark": mark}
            )
    return results


def comparison_memory(build, prefix, threads):
    """Peak of each comparison in bytes a point of both clouds, and a triangle of the mesh, beyond the coordinates."""
    program = build / "tests/bench/memory_compare"
    if not program.exists():
        return []
    text = subprocess.run(
        [str(program), str(prefix), str(threads)], check=True, capture_output=True, text=True
    ).stdout
    results = []
    for line in text.splitlines()[1:]:
        _, operation, points, triangles, now, peak = line.split("|")
        mark = "PASS" if float(peak) <= MEMORY_COMPARING else "FAIL"
        print(
            f"memory of {operation}, {points} points, {triangles} triangles, {threads} threads, beyond the "
            f"coordinates: {now} B with the result, peak {peak} (limit {MEMORY_COMPARING:.0f}): {mark}"
        )
        results.append(
            {"operation": operation, "points": int(points), "triangles": int(triangles), "threads": threads,
             "now": float(now), "peak": float(peak), "mark": mark}
        )
    return results
