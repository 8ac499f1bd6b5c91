#!/usr/bin/env bash
# correct_variants.sh BUILT OUT [RELEASE]: whether right programs are found fault with (docs/envelopes.md). Builds both independent examples with
# each change of conformance/mutants/correct, the C++ one in floats and by other compilers too, has them and plumb draw every image case of the
# built suite to OUT/PROGRAM/LABEL/CASE.png, and prints for each how many pixels are wrong. Labels that have pictures are left alone, so that a run
# can be taken up again. RELEASE: where the programs are, build/release/bin. The exit status is 1 if a pixel is wrong.
set -euo pipefail
built=$(realpath "$1")
mkdir -p "$2"
out=$(realpath "$2")
bin=$(realpath "${3:-build/release/bin}")
cd "$(dirname "$0")/../.."

# Every case as one scene file of its name, with what it refers to beside it.
scenes="$out/scenes"
rm -rf "$scenes"
mkdir "$scenes"
for case in "$built"/envelopes/*/; do
  id=$(basename "$case")
  for input in "$built/cases/$id"/*; do
    name=$(basename "$input")
    case $name in *.xml) name=$id.xml ;; esac
    cp "$input" "$scenes/$name"
  done
done

correct=conformance/mutants/correct
"$bin/plant_mistakes" "$correct/cpp" "$out/cpp" >/dev/null
"$bin/plant_mistakes" "$correct/java" "$out/java" >/dev/null
# In floats only without the cancellation of the plain discriminant: with it, far from a small solid, there is acne.
"$bin/plant_mistakes" "$correct/cpp" "$out/all-float" --single-precision >/dev/null
mkdir -p "$out/float"
cp -rn "$out/all-float/discriminant-by-minors-float" "$out/float/"
rm -rf "$out/all-float"
for program in cpp java float; do tools/developer/planted_pictures.sh "$out/$program" "$scenes"; done

# by LABEL COMPILER FLAGS
by() {
  mkdir -p "$out/by-$1/$1"
  cp "$out"/cpp/right/*.cpp "$out/by-$1/$1/"
  CXX=$2 CXXFLAGS=$3 tools/developer/planted_pictures.sh "$out/by-$1" "$scenes"
}
by clang-O0 clang++ -O0
# Without -fno-finite-math-only it is no right program: it counts on infinities and NaN.
by gcc-fast-math g++ "-O3 -ffast-math -fno-finite-math-only"
by clang-fma clang++ "-O2 -mfma -ffp-contract=fast"

for accel in linear bvh2 bvh8; do
  mkdir -p "$out/plumb/$accel"
  for scene in "$scenes"/*.xml; do
    picture="$out/plumb/$accel/$(basename "$scene" .xml).png"
    [ -f "$picture" ] || nice -n 5 "$bin/plumb" render "$scene" -o "$picture" --accel "$accel" --threads 1 >/dev/null
  done
done

"$bin/judge_pictures" "$built" "$out"/{cpp,java,float,by-*,plumb}/*/ --verbose
