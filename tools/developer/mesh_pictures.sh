#!/usr/bin/env bash
# mesh_pictures.sh [DIR]: renders a picture of each generated family, docs/pictures/mesh-FAMILY.png or DIR/mesh-FAMILY.png, with the release build.
set -euo pipefail
project=$(cd "$(dirname "$0")/../.." && pwd)
pictures=$(realpath -m "${1:-$project/docs/pictures}")
plumb=$project/build/release/bin/plumb
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$pictures"

# every_second FILE.msh PARITY: the file with only those triangles, without normals. One word stands on a line.
every_second() {
  awk -v parity="$2" '
    NR == 2 { triangles = $1; print int((triangles + 1 - parity) / 2); next }
    $1 == "triangles" { first = NR + 1; print; next }
    $1 == "normals" || $1 == "texcoords" { exit }
    !first || int((NR - first) / 3) % 2 == parity' "$1"
}

# picture FAMILY TRIANGLES EYE AT WIDTH GROUND [SHADER]: seen from EYE towards the point AT; WIDTH is that of the view window one unit in front of the
# eye; the ground is at y = GROUND. The shader `two` gives triangles with an even and an odd number two colours and takes their normals away.
picture() {
  local family=$1 triangles=$2 eye=$3 at=$4 width=$5 ground=$6 shader=${7:-plum} surface
  "$plumb" mesh generate "$family" --triangles "$triangles" -o "$work/$family.msh" >/dev/null
  if [ "$shader" = two ]; then
    every_second "$work/$family.msh" 0 >"$work/even.msh"
    every_second "$work/$family.msh" 1 >"$work/odd.msh"
    surface='<surface type="Mesh"><shader ref="plum" /><data>even.msh</data></surface>
      <surface type="Mesh"><shader ref="cream" /><data>odd.msh</data></surface>'
  else
    surface="<surface type=\"Mesh\"><shader ref=\"$shader\" /><data>$family.msh</data></surface>"
  fi
  cat >"$work/$family.xml" <<XML
<scene>
  <camera>
    <viewPoint>$eye</viewPoint>
    <viewDir>$(awk -v e="$eye" -v a="$at" 'BEGIN { split(e, p); split(a, q); print q[1] - p[1], q[2] - p[2], q[3] - p[3] }')</viewDir>
    <viewUp>0 1 0</viewUp>
    <projDistance>1</projDistance>
    <viewWidth>$width</viewWidth>
    <viewHeight>$(awk -v w="$width" 'BEGIN { print w * 3 / 4 }')</viewHeight>
  </camera>
  <image>200 150</image>
  <samples>9</samples>
  <maxDepth>80</maxDepth>
  <shader name="chalk" type="Lambertian"><diffuseColor>.75 .73 .7</diffuseColor></shader>
  <shader name="plum" type="Phong">
    <diffuseColor>.55 .3 .6</diffuseColor><specularColor>.2 .2 .2</specularColor><exponent>30</exponent>
  </shader>
  <shader name="cream" type="Lambertian"><diffuseColor>.9 .85 .7</diffuseColor></shader>
  <shader name="grass" type="Lambertian"><diffuseColor>.45 .6 .3</diffuseColor></shader>
  <shader name="stone" type="Lambertian"><diffuseColor>.75 .55 .4</diffuseColor></shader>
  <shader name="glass" type="Glass"><refractiveIndex>1.1</refractiveIndex></shader>
  $surface
  <surface type="Box"><shader ref="chalk" /><minPt>-30 -20 -30</minPt><maxPt>30 $ground 30</maxPt></surface>
  <surface type="Box"><shader ref="chalk" /><minPt>-30 -20 -31</minPt><maxPt>30 40 -30</maxPt></surface>
  <light><position>3 6 4</position><intensity>.8 .8 .75</intensity></light>
  <light><position>-6 3 3</position><intensity>.25 .25 .3</intensity></light>
</scene>
XML
  "$plumb" render "$work/$family.xml" -o "$pictures/mesh-$family.png" >/dev/null
}

picture icosphere 1280 "0.8 1.1 3.2" "0 0 0" 0.85 -1 two
picture uv_sphere 800 "0.8 1.9 2.8" "0 0 0" 0.85 -1 two
picture displaced_sphere 81920 "0.8 1.1 3.2" "0 0 0" 0.95 -1.1 stone
picture torus_knot 10000 "0.6 1.2 4" "0 0 0" 1.05 -1.62
picture terrain 100000 "0.7 1.2 2.3" "0 -0.1 0" 0.95 -1 grass
picture lattice_cube 1200 "1.6 1.5 2.9" "0 0 0" 0.7 -0.625 two
picture needles 700 "1.2 1.6 3.1" "0 -0.1 0" 0.72 -0.9 stone
picture city 12288 "0.5 0.9 1.5" "0 0.12 0" 0.9 -0.01 stone
picture menger_sponge 36096 "1.8 1.9 3.3" "0 0 0" 0.95 -1
picture nested_shells 10240 "0.8 1.1 3.2" "0 0 0" 0.85 -1 glass
