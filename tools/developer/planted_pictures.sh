#!/usr/bin/env bash
# planted_pictures.sh OUT SCENES: builds each program OUT/LABEL that plant_mistakes wrote, in C++ or Java, and has it render every scene of the
# folder SCENES, to OUT/LABEL/CASE.png. All scenes in one run; what is missing then has a run of its own, and no picture after 60 s of it. Labels
# that have pictures are left alone. $CXX and $CXXFLAGS in place of g++ and -O1.
set -uo pipefail
out=$(realpath "$1")
scenes=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# compile FOLDER: leaves what `run` runs in $work.
compile() {
  rm -rf "$work/program" "$work/classes"
  if compgen -G "$1*.cpp" >/dev/null; then
    # shellcheck disable=SC2086
    nice -n 5 ${CXX:-g++} ${CXXFLAGS:--O1} -std=c++17 -pthread -w -o "$work/program" "$1"*.cpp
  else
    find "$1" -name '*.java' -print0 | xargs -0 nice -n 5 javac -J-XX:TieredStopAtLevel=1 -J-XX:+UseSerialGC -nowarn -encoding UTF-8 -d "$work/classes"
  fi
}

# run SECONDS SCENE...
run() {
  local seconds=$1 program=("$work/program")
  shift
  if [ -d "$work/classes" ]; then program=(java -Xmx512m -XX:+UseSerialGC -XX:TieredStopAtLevel=1 -Djava.awt.headless=true -cp "$work/classes" ray.RayTracer); fi
  timeout "$seconds" nice -n 5 "${program[@]}" "$@" >/dev/null 2>&1
}

for folder in "$out"/*/; do
  if compgen -G "$folder*.png" >/dev/null; then continue; fi
  compile "$folder" || { echo "$folder does not compile" >&2; exit 1; }
  rm -rf "$work/scenes"
  cp -r "$scenes" "$work/scenes"
  find "$work/scenes" -name '*.png' -delete
  run 300 "$work"/scenes/*.xml
  for scene in "$work"/scenes/*.xml; do
    [ -f "$scene.png" ] || run 60 "$scene"
    if [ -f "$scene.png" ]; then mv "$scene.png" "$folder$(basename "$scene" .xml).png"; fi
  done
done
