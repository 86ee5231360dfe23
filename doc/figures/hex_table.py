# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints README's table of hexahedral meshes of the paper's five parts, from what the program reports:

    python3 doc/figures/hex_table.py build/test/ccsweep
"""
import json
import pathlib
import subprocess
import sys
import tempfile

DATA = pathlib.Path(__file__).parents[2] / "test" / "data"
PARTS = ["cylinder", "tapered_protrusion", "piston_section", "bulkhead", "brake"]
# The paper's own: twice the smallest feature, a step of 2, and 0.15 units.
OWN_SIZES = [("piston_section", 4), ("bulkhead", 0.15)]


def facts(name):
    return json.loads((DATA / f"{name}.json").read_text())


def direction(name):
    return ",".join(map(repr, facts(name)["sweep_direction"]))


def extent(name):
    low, high = facts(name)["bbox"]
    return max(b - a for a, b in zip(low, high))


def row(program, folder, name, size, label):
    report = folder / "report.json"
    subprocess.run([program, "mesh", DATA / f"{name}.ply", "--direction", direction(name), "--size", repr(size),
                    "--quiet", "--out", folder / "mesh.vtu", "--report", report], check=True)
    found = json.loads(report.read_text())
    quality = found["scaled_jacobian"]
    seconds = sum(found["seconds"].values())
    print(f"| {name} | {label} | {found['hexahedra']} | {quality['minimum']:.2f} | {quality['mean']:.2f} "
          f"| {seconds:.2f} s |")


def main():
    print("| part | size | hexahedra | least scaled Jacobian | mean | time |\n|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as scratch:
        for name in PARTS:
            row(sys.argv[1], pathlib.Path(scratch), name, extent(name) / 20, "extent / 20")
        for name, size in OWN_SIZES:
            row(sys.argv[1], pathlib.Path(scratch), name, size, f"{size}, as in the paper")


if __name__ == "__main__":
    main()
