#!/usr/bin/env bash
# planted_pictures.sh OUT SCENES: builds each program OUT/LABEL/*.cpp that plant_mistakes wrote and has it render every scene of the folder SCENES,
# to OUT/LABEL/CASE.png. A scene for which it writes nothing in 60 s has no picture. Labels that have pictures are left alone.
set -uo pipefail
out=$(realpath "$1")
scenes=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for folder in "$out"/*/; do
  if compgen -G "$folder*.png" >/dev/null; then continue; fi
  nice -n 5 g++ -O1 -std=c++17 -pthread -w -o "$work/program" "$folder"*.cpp || { echo "$folder does not compile" >&2; exit 1; }
  rm -rf "$work/scenes"
  cp -r "$scenes" "$work/scenes"
  find "$work/scenes" -name '*.png' -delete
  for scene in "$work"/scenes/*.xml; do
    timeout 60 nice -n 5 "$work/program" "$scene" >/dev/null 2>&1
    id=$(basename "$scene" .xml)
    if [ -f "$scene.png" ]; then mv "$scene.png" "$folder$id.png"; fi
  done
done
