#!/usr/bin/env bash
# Drives a simulated robot, planner, controller, bridge and drives, over vcan0, where candump of can-utils listens. To be run by
# scripts/can_vm/run_in_can_vm.sh. Fails unless the robot gets to its goals and candump sees targets for steering and driving change.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
frames=$root/build/vcan_drive.candump

# RPDO1 of the first steering and the first driving drive: controlword, mode, target; less than all, which would not be in time.
candump -L vcan0,201:7FF,205:7FF >"$frames" &
dump=$!
trap 'kill $dump 2>/dev/null || true' EXIT

"$root/scripts/tour.sh" 3,6.6,0 2.5,6,90 -- "$root/test/vcan/slow_simulation.launch" bus:=vcan0

# How many different targets, the last eight digits, a drive was sent.
targets()
{
  sed -nE "s/.* $1#[0-9A-F]+([0-9A-F]{8})\$/\1/p" "$frames" | sort -u | wc -l
}
angles=$(targets 201)
speeds=$(targets 205)
echo "candump saw $angles different angles for the front left wheel, and $speeds different speeds"
[[ $angles -gt 10 && $speeds -gt 10 ]]
