#!/usr/bin/env bash
# Installs what is missing, builds, plans across a real building and shows the plan: as a picture, whose file name is
# printed, and in rviz where there is a display.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build
picture=$build/demo.svg
display=${DISPLAY:-${WAYLAND_DISPLAY:-}}

"$root/scripts/install_dependencies.sh" build ${display:+exec}
"$root/scripts/build.sh" -DCATKIN_ENABLE_TESTING=OFF
source "$root/scripts/environment.sh"

# OctoMap's documentation comes with a 3D laser map of building 079 of the university of Freiburg.
building=$(dpkg -L liboctomap-dev 2>/dev/null | grep '/geb079\.bt$' || true)
if [[ -e $building ]]; then
  # Its doors are half a metre wide: through two of them from one room into another, with a robot that fits. Tight spots
  # at either end take all three modes.
  map=(octomap "$building")
  robot=$root/config/robot_compact.yaml
  start=2.44,-2.02,-1.5708
  goal=16.65,3.24,0
else
  echo "No laser map of a building here (liboctomap-dev without its documentation); using a map of ours instead."
  map=(map "$root/config/env2.yaml")
  robot=$root/config/robot.yaml
  start=2,7.4,0
  goal=7.5,0.65,0
fi

"$build/devel/lib/fourwis_navigation/plan" "--${map[0]}" "${map[1]}" --robot "$robot" \
  "--start=$start" "--goal=$goal" --svg "$picture"
echo "The plan: $picture"
if command -v rsvg-convert >/dev/null; then
  rsvg-convert --width 1600 "$picture" --output "${picture%.svg}.png"
  echo "          ${picture%.svg}.png"
fi

# X,Y,YAW as a geometry_msgs/Pose
pose()
{
  awk -F, '{ printf "{position: {x: %s, y: %s}, orientation: {z: %.9f, w: %.9f}}", $1, $2, sin($3 / 2), cos($3 / 2) }' <<<"$1"
}

show_in_rviz()
{
  set +u
  source "$build/devel/setup.bash"
  set -u
  roslaunch fourwis_navigation plan.launch "${map[0]}:=${map[1]}" "robot:=$robot" &
  local launch=$!
  trap 'kill "$launch" 2>/dev/null; wait "$launch"' EXIT
  trap 'exit 130' INT TERM
  until timeout --foreground 5 rostopic echo -n 1 /move_base/planner_status >/dev/null 2>&1; do
    kill -0 "$launch" || return 1
    sleep 0.5
  done
  rostopic pub -1 /initialpose geometry_msgs/PoseWithCovarianceStamped \
    "{header: {frame_id: map}, pose: {pose: $(pose "$start")}}"
  rostopic pub -1 /move_base_simple/goal geometry_msgs/PoseStamped "{header: {frame_id: map}, pose: $(pose "$goal")}"
  echo "Set another start with '2D Pose Estimate', another goal with '2D Nav Goal'; Ctrl-C ends the demo."
  echo "(For other terminals: export ROS_MASTER_URI=$ROS_MASTER_URI)"
  wait "$launch"
}

if [[ -n $display ]]; then
  show_in_rviz
else
  echo "There is no display for rviz."
fi
