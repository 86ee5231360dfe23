#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Draws the paper's five parts before and after their decomposition, from what the program writes:
#
#     doc/figures/papers_parts.sh build/test/ccsweep
#
# Needs Debian's python3-vtk9 and xvfb.
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "$0")"
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT

draw() {
  "$program" decompose "../../test/data/$1.ply" --direction 0,0,1 --out "$scratch/$1" --quiet
  xvfb-run -a /usr/bin/python3 render.py "$scratch/$1" "$1.png" --before "../../test/data/$1.ply" --size 1600x640 "${@:2}"
}

draw cylinder
draw tapered_protrusion --view=-1.2,-2.0,0.9
draw piston_section --view=2.0,-1.6,1.1
draw bulkhead --explode 0.5 --view=-1.0,-1.8,1.4
draw brake --view=-1.2,-2.0,1.1
