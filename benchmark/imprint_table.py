#!/usr/bin/env python3
# Copyright (c) 2026 The CCSweep authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the manual's table of the imprint beside its peers, and what it says in the mean.

usage: imprint_table.py benchmark_results/imprint.json
"""
import json
import sys
from collections import defaultdict
from statistics import geometric_mean

TITLES = {
    "apart": "two circles half a radius apart, 2 crossings",
    "root": "sqrt N crossings",
    "quarter": "N/4 crossings",
    "root_holes": "sqrt N crossings, four holes each",
    "quarter_holes": "N/4 crossings, four holes each",
    "layer": "layer of m x m turned squares",
}
# Columns: what is divided by what.
RATIOS = {
    "to the bound": ("ccsweep_rtree", "bound"),
    "with runs": ("ccsweep_runs", "bound"),
    "CGAL": ("cgal", "ccsweep_rtree"),
    "its overlay only": ("cgal_overlay", "ccsweep_rtree"),
    "Boost": ("boost", "ccsweep_rtree"),
    "Clipper": ("clipper", "ccsweep_rtree"),
}


def microseconds_by_scene(path):
    scenes = defaultdict(dict)
    with open(path) as file:
        for run in json.load(file)["benchmarks"]:
            _, family, size, peer = run["name"].split("/")
            if run.get("error_occurred"):
                sys.exit(f"{run['name']}: {run['error_message']}")
            scenes[family, int(size)][peer] = run["cpu_time"]
    return scenes


def ratios(times):
    return {title: times[a] / times[b] if a in times and b in times else None for title, (a, b) in RATIOS.items()}


def main():
    scenes = microseconds_by_scene(sys.argv[1])
    columns = defaultdict(list)
    print("| family | N or m | ms | " + " | ".join(RATIOS) + " |")
    print("|---" * (3 + len(RATIOS)) + "|")
    for (family, size), times in sorted(scenes.items(), key=lambda s: (list(TITLES).index(s[0][0]), s[0][1])):
        row = ratios(times)
        for title, ratio in row.items():
            if ratio:
                columns[title].append(ratio)
        cells = [f"{ratio:.1f}" if ratio else "" for ratio in row.values()]
        print(f"| {TITLES[family]} | {size} | {times['ccsweep_rtree'] / 1000:.3f} | " + " | ".join(cells) + " |")
    means = [f"{geometric_mean(columns[title]):.1f}" for title in RATIOS]
    print("| geometric mean | | | " + " | ".join(means) + " |")

    def each_crossing(peer):
        """What one of N / 4 crossings costs more than two do, in microseconds."""
        return (scenes["quarter", 100000][peer] - scenes["apart", 100000][peer]) / 25000

    for peer in ("ccsweep_rtree", "ccsweep_runs", "clipper", "boost"):
        print(f"{peer}: {each_crossing(peer):.2f} microseconds a crossing at N = 100000")


if __name__ == "__main__":
    main()
