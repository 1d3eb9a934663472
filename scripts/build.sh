#!/usr/bin/env bash
# Configures and builds the package in build/, with plain CMake and no workspace; --core: without ROS, in build_core/.
#   build.sh [--core] [-DNAME=VALUE]... [TARGET]...
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build
options=(-DCMAKE_BUILD_TYPE=Release -DPYTHON_EXECUTABLE=/usr/bin/python3)
if [[ ${1:-} == --core ]]; then
  shift
  build=$root/build_core
  options=(-DCMAKE_BUILD_TYPE=Release -DFOURWIS_ROS=OFF)
fi
source "$root/scripts/environment.sh"

targets=()
for argument in "$@"; do
  if [[ $argument == -D* ]]; then options+=("$argument"); else targets+=("$argument"); fi
done

# A cache made for another checkout (copied, moved, mounted elsewhere) cannot be configured again.
if [[ -e $build/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; then
  echo "Removing $build: it was configured for other sources"
  rm -rf "$build"
fi
cmake -S "$root" -B "$build" "${options[@]}"
cmake --build "$build" --parallel "$(nproc)" --target "${targets[@]:-all}"
