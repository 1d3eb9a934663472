#!/usr/bin/env bash
# Checks that take too long for every change.
set -uo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
parts=(sanitize threads fuzz flood figures tidy core)

usage()
{
  cat <<'END'
usage: nightly.sh [PART]... [quick]   all parts, or those given; quick: figures with a tenth of everything, in a few minutes
  sanitize  AddressSanitizer and UndefinedBehaviorSanitizer: the tests of all stages but ros, 300 random problems
  threads   ThreadSanitizer: planner, map store, buses, the bridge's thread
  fuzz      the fuzz loops of the tests with FOURWIS_FUZZ_FACTOR (20) times their rounds
  flood     1,000 random problems against a flood of the exact rectangle
  figures   what is asked of the planner beside what is measured: random problems against floods of the exact rectangle, random
            robots, a car that parks, streets; CPU time. FOURWIS_SHARED: folder of third-party maps/ and problems/ (../shared);
            FOURWIS_CASES: folder to write the cases that fail or are slow to
  tidy      lint.sh --all: tests as well, and with the static analyzer
  core      the build without ROS, and all its tests
Ends with a line for each part: whether it passed, and how long it took. Exit status: 1 when a part failed.
END
}

# Configures and builds targets with sanitizers, in a folder of their own: instrumented FOLDER SANITIZERS OPTION... -- TARGET...
# With the assertions of Eigen and of the standard library. -g1 has the lines of a report; following the variables of inlined
# Eigen as well takes minutes and 3 GB a file.
instrumented()
{
  local folder=$1 sanitizers=$2
  shift 2
  local options=()
  while [[ $1 != -- ]]; do options+=("$1") && shift; done
  shift
  cmake -S "$root" -B "$folder" -DCMAKE_BUILD_TYPE=None -DPYTHON_EXECUTABLE=/usr/bin/python3 \
    -DCMAKE_CXX_FLAGS="-O1 -g1 -fno-omit-frame-pointer -D_GLIBCXX_ASSERTIONS -fsanitize=$sanitizers -fno-sanitize-recover=all" \
    "${options[@]}" &&
    cmake --build "$folder" --parallel "$(nproc)" --target "$@"
}

# Runs the tests of a build whose names match.
run_tests()
{
  (cd "$1" && ctest --output-on-failure --no-tests=error --timeout 3000 --parallel "$(nproc)" "${@:2}")
}

program() { find "$1" -type f -name "$2" -perm -u+x | head -n 1; }

# Problems on random grids, and as many more on each of the project's maps: flood BUILD RANDOM ON_EACH_MAP
flood()
{
  local maps=("$root"/config/env?.yaml)
  "$(program "$1" nightly_flood)" --problems "$2" && "$(program "$1" nightly_flood)" --problems "$3" "${maps[@]}"
}

part_sanitize()
{
  local build=$root/build_asan
  export UBSAN_OPTIONS=print_stacktrace=1
  instrumented "$build" address,undefined -DFOURWIS_ROS=OFF -DFOURWIS_IPOPT=ON -DBUILD_TESTING=ON -- tests nightly_flood &&
    run_tests "$build" --exclude-regex '^(socketcan|examples|layering)$' &&
    flood "$build" 260 10
}

part_threads()
{
  local build=$root/build_tsan
  local tests='planner_planner(_refusals)?|ros_map_store|can_bus_[a-z_]+|drives_bridge_(thread|load)'
  local targets=(planner_planner planner_planner_refusals ros_map_store drives_bridge_thread drives_bridge_load)
  targets+=($(cd "$root/test/can/bus" && ls test_*.cpp | sed 's/^test_\(.*\)\.cpp$/can_bus_\1/'))
  instrumented "$build" thread -DCATKIN_ENABLE_TESTING=ON -- "${targets[@]}" &&
    run_tests "$build" --tests-regex "($tests)\$"
}

part_fuzz()
{
  export FOURWIS_FUZZ_FACTOR=${FOURWIS_FUZZ_FACTOR:-20}
  local names
  names=$(cd "$root/test" && grep -rl fuzz_rounds --include='test_*.cpp' | sed 's|/test_|_|; s|/|_|g; s|\.cpp$||')
  "$root/scripts/build.sh" -DCATKIN_ENABLE_TESTING=ON $names &&
    run_tests "$root/build" --tests-regex "(^|_)($(paste -sd '|' <<<"$names"))\$"
}

part_flood()
{
  "$root/scripts/build.sh" -DCATKIN_ENABLE_TESTING=ON nightly_flood && flood "$root/build" 900 25
}

# On maps of its own, and those of third parties where they lie beside the project.
part_figures()
{
  local options=(--share "$share" --beside "${FOURWIS_SHARED:-$root/../shared}")
  [[ -z ${FOURWIS_CASES:-} ]] || options+=(--cases "$FOURWIS_CASES")
  "$root/scripts/build.sh" -DCATKIN_ENABLE_TESTING=ON nightly_figures &&
    "$(program "$root/build" nightly_figures)" "${options[@]}"
}

part_tidy() { "$root/scripts/lint.sh" --all; }
part_core() { "$root/scripts/test_core.sh" --all; }

share=1
if [[ ${*: -1} == quick ]]; then
  share=0.1
  set -- "${@:1:$#-1}"
fi
[[ $# -gt 0 ]] || set -- "${parts[@]}"
for part in "$@"; do
  [[ $part != *" "* && " ${parts[*]} " == *" $part "* ]] || { usage >&2; exit 2; }
done
source "$root/scripts/environment.sh"
summary=()
status=0
for part in "$@"; do
  echo "=== $part"
  begin=$SECONDS
  if ("part_$part"); then verdict=passed; else verdict=FAILED status=1; fi
  summary+=("$(printf '%-9s %s after %d min %02d s' "$part" "$verdict" $(((SECONDS - begin) / 60)) $(((SECONDS - begin) % 60)))")
done
printf '%s\n' "${summary[@]}"
exit "$status"
