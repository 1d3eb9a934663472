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

# The 3D laser map of building 079 of the university of Freiburg comes with OctoMap's documentation.
building()
{
  local file
  file=$(dpkg -L liboctomap-dev 2>/dev/null | grep '/geb079\.bt$') && [[ -e $file ]] && echo "$file"
}
