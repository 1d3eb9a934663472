#!/usr/bin/env bash
# Installs what is missing, builds, plans across a real building (as a picture, whose file name is printed) and drives a
# simulated robot through it, from goal to goal: in rviz where there is a display, otherwise faster than real time.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build
picture=$build/demo.svg
if [[ -n ${DISPLAY:-${WAYLAND_DISPLAY:-}} ]]; then rviz=true speed=1; else rviz=false speed=6; fi

"$root/scripts/install_dependencies.sh" build exec
"$root/scripts/build.sh" -DCATKIN_ENABLE_TESTING=OFF
source "$root/scripts/environment.sh"

# OctoMap's documentation comes with a 3D laser map of building 079 of the university of Freiburg.
building=$(dpkg -L liboctomap-dev 2>/dev/null | grep '/geb079\.bt$' || true)
if [[ -e $building ]]; then
  # Its doors are half a metre wide: through two of them from one room into another, and back by way of the corridor, with
  # a robot that fits. Tight spots at either end take all three modes.
  map=(octomap "$building")
  robot=$root/config/robot_compact.yaml
  start=(2.44 -2.02 -1.5708)
  goals=(16.65,3.24,0 16.3,-0.3,180 9.4,0.3,-90 0.5,0.2,180 2.44,-4.1,90)
else
  echo "No laser map of a building here (liboctomap-dev without its documentation); using a map of ours instead."
  map=(map "$root/config/env2.yaml")
  robot=$root/config/robot.yaml
  start=(2 7.4 0)
  goals=(7.5,0.65,0 2,7.4,0)
fi

"$build/devel/lib/fourwis_navigation/plan" "--${map[0]}" "${map[1]}" --robot "$robot" \
  "--start=${start[0]},${start[1]},${start[2]}" "--goal=${goals[0]}" --svg "$picture"
echo "The plan: $picture"
if command -v rsvg-convert >/dev/null; then
  rsvg-convert --width 1600 "$picture" --output "${picture%.svg}.png"
  echo "          ${picture%.svg}.png"
fi

stay=()
if [[ $rviz == true ]]; then stay=(--stay); fi
echo
exec "$root/scripts/tour.sh" "${stay[@]}" "${goals[@]}" -- "$root/launch/simulation.launch" "${map[0]}:=${map[1]}" \
  "robot:=$robot" "x:=${start[0]}" "y:=${start[1]}" "yaw:=${start[2]}" "rviz:=$rviz" "real_time_factor:=$speed"
