#!/usr/bin/env bash
# Installs what is missing, builds everything and runs all tests, then a few on a build without ROS. Exits non-zero when
# one fails or when none ran.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build

"$root/scripts/install_dependencies.sh" build exec test
"$root/scripts/build.sh" -DCATKIN_ENABLE_TESTING=ON -DFOURWIS_WERROR=ON all tests benchmarks

source "$root/scripts/environment.sh"
export ROS_HOME=$build/ros_home
rm -rf "$build/test_results"
cd "$build"
"$root/scripts/can_vm/run_in_can_vm.sh" --which || true  # the tests socketcan and vcan_drive are skipped then
ctest --output-on-failure --no-tests=error --timeout 300 --parallel "$(nproc)"

"$root/scripts/test_core.sh" -DFOURWIS_WERROR=ON
