#!/usr/bin/env bash
# Launches a simulated robot, on a ROS master of its own, and drives it from goal to goal (drive_tour.py). Of a package that
# is built.
#   tour.sh [--stay] GOAL... -- LAUNCH_FILE [NAME:=VALUE]...
# --stay: keeps the robot for more goals until Ctrl-C. Exits with 0 when all goals were reached. What the nodes say is in
# build/tour.log.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
log=$root/build/tour.log
stay=false
goals=()
while [[ $# -gt 0 && $1 != -- ]]; do
  if [[ $1 == --stay ]]; then stay=true; else goals+=("$1"); fi
  shift
done
if [[ $# -lt 2 || ${#goals[@]} -eq 0 ]]; then
  echo "usage: tour.sh [--stay] GOAL... -- LAUNCH_FILE [NAME:=VALUE]..." >&2
  exit 2
fi
shift

# The first free port: a robot's master and what an earlier tour has left keep theirs.
free_port()
{
  local port=11411
  while (exec 3<>"/dev/tcp/localhost/$port") 2>/dev/null; do ((++port)); done
  echo "$port"
}

launch=
tour=
end()
{
  trap '' INT TERM
  kill $tour $launch 2>/dev/null || true
  wait
}
trap end EXIT
trap 'exit 130' INT TERM

source "$root/scripts/environment.sh"
set +u
source "$root/build/devel/setup.bash"
set -u
port=$(free_port)
export ROS_MASTER_URI=http://localhost:$port ROS_HOME=$root/build/ros_home
roslaunch --port "$port" "$@" >"$log" 2>&1 &
launch=$!
"$root/scripts/drive_tour.py" "${goals[@]}" &
tour=$!
# Until the tour or the launch ends; the tour's own end is a good one only when it says so, the launch's never is.
if ! wait -n || kill -0 "$tour" 2>/dev/null; then
  echo "The tour ended early; what the nodes say: $log" >&2
  exit 1
fi
if [[ $stay == true ]]; then
  echo "Send it elsewhere with '2D Nav Goal'; Ctrl-C ends the demo."
  echo "(For other terminals: export ROS_MASTER_URI=$ROS_MASTER_URI)"
  wait "$launch"
fi
