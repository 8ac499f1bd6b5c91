#!/usr/bin/env bash
# neon.sh [RAYS]: whether the 8-wide hierarchy finds the same hits on ARM's NEON as on this processor: cross-compiles same_hits,
# runs it under qemu-user and compares its hashes with those of the release build. Needs g++-aarch64-linux-gnu and qemu-user.
set -euo pipefail
cd "$(dirname "$0")/../.."
rays=${1:-20000}
build=build/neon
mkdir -p "$build"

# Highway's own library is not there for ARM: without dispatch at run time it is not needed, as every 64-bit ARM has NEON. Nor is MPFR, which
# only rotations need: the linker drops the function that makes one.
sources="tools/developer/same_hits.cpp meshes/generators/asked_size.cpp meshes/generators/icosphere.cpp meshes/generators/kinds/city.cpp
  renderer/accel/binary_tree.cpp renderer/accel/binned_split.cpp renderer/accel/bvh8.cpp renderer/accel/bvh8_builder.cpp
  renderer/accel/bvh8_walk.cpp renderer/accel/filter_ray.cpp renderer/accel/frame_vertices.cpp renderer/accel/group_partition.cpp
  renderer/accel/mapped_array.cpp renderer/accel/mesh_parts.cpp renderer/accel/triangle_groups.cpp renderer/accel/wide_gatherer.cpp
  renderer/accel/worker_pool.cpp
  renderer/math/affine_product.cpp renderer/math/bounds3.cpp renderer/math/dyadic.cpp renderer/math/exact_sum.cpp
  renderer/math/input_error.cpp renderer/math/placed_ray.cpp renderer/math/support.cpp renderer/math/transform.cpp
  renderer/surfaces/closest_triangle.cpp renderer/surfaces/exact_triangle.cpp renderer/surfaces/triangle.cpp"

# Of this machine's headers Highway's alone.
ln -sfn /usr/include/hwy "$build/hwy"
objects=()
for source in $sources; do
  object=$build/$(basename "$source" .cpp).o
  objects+=("$object")
  aarch64-linux-gnu-g++ -std=c++20 -O2 -ffp-contract=off -ffunction-sections -DHWY_COMPILE_ONLY_STATIC -I. -isystem "$build" -c "$source" -o "$object"
done
aarch64-linux-gnu-g++ -pthread -Wl,--gc-sections "${objects[@]}" -o "$build/same_hits"

ours=$(build/release/bin/same_hits "$rays")
arms=$(qemu-aarch64 -L /usr/aarch64-linux-gnu "$build/same_hits" "$rays")
printf '%s\n%s\n' "$ours" "$arms"

# field NAME: its different values in both answers, one a line.
field() { printf '%s\n%s\n' "$ours" "$arms" | sed -n "s/.* $1 \([0-9a-f]*\).*/\1/p" | sort -u; }
for name in hits blocked triangles; do
  [[ $(field $name | wc -l) == 1 ]] || { echo "$name differ" >&2; exit 1; }
done
[[ $(field numbers | wc -l) == 1 ]] || echo "some t, u or v differ: 64-bit significands are wider on ARM (docs/performance.md)"
