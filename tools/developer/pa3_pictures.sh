#!/usr/bin/env bash
# pa3_pictures.sh [FILE]: renders the grading scenes with the release build and lays them side by side, six in a row: docs/pictures/pa3.png or FILE.
set -euo pipefail
project=$(cd "$(dirname "$0")/../.." && pwd)
sheet=$(realpath -m "${1:-$project/docs/pictures/pa3.png}")
bin=$project/build/release/bin
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# In the order in which docs/pa3-suite.md names them.
scenes=(sphere sphere-inside camera camera-oblique gamma shadows
  two-lights phong defaults shared-names box box-inside
  cylinder cylinder-inside cone translate-scale rotations groups
  groups-nested normals-transformed group-shader shared-surface mesh-flat mesh-smooth
  mesh-transformed mesh-large bounds-many glazed glazed-deep glass
  glass-inside glass-total antialiasing antialiasing-rounded)

pictures=()
for scene in "${scenes[@]}"; do pictures+=("$work/$scene.xml.png"); done
"$bin/plumb" render "$project/scenes/pa3" -o "$work" >/dev/null
"$bin/contact_sheet" "$sheet" 6 "${pictures[@]}"
