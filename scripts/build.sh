#!/usr/bin/env bash
# Configures and builds the package in build/, with plain CMake and no workspace.
#   build.sh [-DNAME=VALUE]... [TARGET]...
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build
source "$root/scripts/environment.sh"

options=()
targets=()
for argument in "$@"; do
  if [[ $argument == -D* ]]; then options+=("$argument"); else targets+=("$argument"); fi
done

# A cache made for another checkout (copied, moved, mounted elsewhere) cannot be configured again.
if [[ -e $build/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; then
  echo "Removing build/: it was configured for other sources"
  rm -rf "$build"
fi
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DPYTHON_EXECUTABLE=/usr/bin/python3 "${options[@]}"
cmake --build "$build" --parallel "$(nproc)" --target "${targets[@]:-all}"
