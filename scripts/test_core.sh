#!/usr/bin/env bash
# Builds the package in build_core/ without ROS, without catkin even where it is installed, and without Ipopt; shows that
# nothing of ROS is in it, and runs tests: a few, or all of them.
#   test_core.sh [--all] [-DNAME=VALUE]...            (-DFOURWIS_IPOPT=ON: with Ipopt)
# Exits non-zero when one fails.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build_core
few=(cli_plan_command planner_planner track_closed_loop)
if [[ ${1:-} == --all ]]; then
  shift
  targets=(tests)
  selected=()
else
  targets=("${few[@]}")
  selected=(-R "^($(IFS='|'; echo "${few[*]}")|examples|layering)\$")
fi

core=("$root/scripts/build.sh" --core -DFOURWIS_IPOPT=OFF -DCMAKE_DISABLE_FIND_PACKAGE_catkin=ON "$@")
"${core[@]}" -DBUILD_TESTING=OFF all  # what a user builds
"${core[@]}" -DBUILD_TESTING=ON "${targets[@]}"

ros='/(actionlib|catkin|[a-z]+_(msgs|srvs)|ros|rosgraph|tf2?|tf2_ros)/[A-Za-z_0-9]+\.h'
if grep -rlE --include='*.d' "/include$ros" "$build"; then
  echo "$0: compiled with headers of ROS" >&2
  exit 1
fi
if ldd "$build/plan" | grep -E '/lib(actionlib|cpp_common|ros[a-z_]+|tf2|xmlrpcpp)\.so'; then
  echo "$0: linked to ROS" >&2
  exit 1
fi

source "$root/scripts/environment.sh"
cd "$build"
ctest --output-on-failure --no-tests=error --timeout 300 --parallel "$(nproc)" "${selected[@]}"
