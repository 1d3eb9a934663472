#!/usr/bin/env bash
# Installs what package.xml asks for and this machine lacks, with sudo when not root.
#   install_dependencies.sh [build | exec | test]...      (default: all three)
# Debian 12: after the table packages_debian.txt; nothing is fetched when nothing is missing.
# Ubuntu 20.04 with ROS Noetic in /opt/ros: through rosdep, which knows no such choice and installs all.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
table=$root/scripts/packages_debian.txt

as_root()
{
  if [[ $EUID -eq 0 ]]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "$0: neither root nor sudo; run as root: $*" >&2
    return 1
  fi
}

# The packages of the table's rows whose first column is among the arguments.
packages()
{
  awk -v wanted=" $* " '!/^#/ && index(wanted, " " $1 " ") { for (i = 3; i <= NF; ++i) print $i }' "$table"
}

# Those of the arguments that are not installed.
missing()
{
  comm -23 <(printf '%s\n' "$@" | sort -u) \
    <(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "$@" 2>/dev/null | awk '$2 == "installed" { print $1 }' | sort -u)
}

apt_get()
{
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 "$@" </dev/null
}

# Refreshes the package lists only when they are absent or too old to install from.
install_missing()
{
  local -a lacking
  mapfile -t lacking < <(missing "$@")
  [[ ${#lacking[@]} -gt 0 ]] || return 0
  echo "Installing ${lacking[*]}"
  local -a install=(install --yes --no-install-recommends "${lacking[@]}")
  if ! apt-get --simulate "${install[@]}" >/dev/null 2>&1 || ! apt_get "${install[@]}"; then
    apt_get update
    apt_get "${install[@]}" && return 0
    echo "$0: these packages are those of Debian 12; on Ubuntu 20.04 install ROS Noetic in /opt/ros first" >&2
    return 1
  fi
}

install_with_rosdep()
{
  local distribution=$1
  command -v rosdep >/dev/null || install_missing python3-rosdep
  [[ -e /etc/ros/rosdep/sources.list.d/20-default.list ]] || as_root rosdep init
  local -a package=(--from-paths "$root" --ignore-src --rosdistro "$distribution")
  rosdep check "${package[@]}" >/dev/null 2>&1 && return 0
  rosdep update --rosdistro "$distribution"
  rosdep install "${package[@]}" -y </dev/null
}

[[ $# -gt 0 ]] || set -- build exec test
for when in "$@"; do
  [[ $when =~ ^(build|exec|test)$ ]] || { echo "$0: '$when' is none of build, exec, test" >&2; exit 2; }
done
command -v apt-get >/dev/null || { echo "$0: needs apt (Debian 12, or Ubuntu 20.04 with ROS Noetic)" >&2; exit 1; }

if [[ -e /opt/ros/noetic/setup.bash ]]; then
  install_missing build-essential cmake
  install_with_rosdep noetic
else
  mapfile -t required < <(packages "$@")
  install_missing "${required[@]}"
fi
