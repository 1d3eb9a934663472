#!/usr/bin/env bash
# Builds the benchmarks, runs all of them and writes their tables into doc/benchmarks.md, below its marker. Let nothing
# else run meanwhile.
#   benchmarks.sh FOLDER [RUNS]     FOLDER holds problems/ and maps/ as doc/benchmarks.md describes them
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
if [[ $# -lt 1 || ! -d $1/problems || ! -d $1/maps ]]; then
  echo "usage: $0 FOLDER [RUNS]; FOLDER holds problems/ and maps/" >&2
  exit 2
fi
data=$(cd "$1" && pwd)
runs=${2:-20}
few=$((runs < 3 ? runs : 3))
page=$root/doc/benchmarks.md
marker='<!-- Below: written by scripts/benchmarks.sh -->'
grep -qxF "$marker" "$page" || { echo "$0: $page lacks the line $marker" >&2; exit 1; }

"$root/scripts/build.sh" -DCATKIN_ENABLE_TESTING=ON benchmarks
program() { find "$root/build" -type f -name "$1" -perm -u+x | head -n 1; }
measure=("$(program benchmark_frontend)" --markdown --runs "$runs")
measure_backend=("$(program benchmark_backend)" --markdown --runs "$runs")
problems=(--problems "$data/problems/bit_4wis.csv" --problems "$data/problems/generated/problems.csv")

written=$(mktemp)
trap 'rm -f "$written"' EXIT
{
  sed "\|^$marker\$|q" "$page"
  echo
  echo "Measured on $(nproc) cores, $(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1), $runs runs each."
  echo
  "${measure[@]}" "${problems[@]}" --environments
  echo '### The environments in Ackermann motion only'
  echo
  "${measure[@]}" --environments --modes ackermann | tail -n +3
  "${measure[@]}" --walled-in "${problems[@]}" --environments
  "${measure[@]}" --ablation
  "${measure[@]}" --corner-to-corner --map "$data/maps/nav2/warehouse.yaml" --map "$data/maps/nav2/100by100_10.yaml"
  "${measure_backend[@]}" "${problems[@]}"
  "${measure_backend[@]}" "${problems[@]}" --modes ackermann
  "${measure_backend[@]}" --environments
  "${measure_backend[@]}" --backend-only "${problems[@]}"
  "$(program benchmark_can)" --markdown
  "$(program benchmark_tracking)" --markdown --runs 50
  # Slow ones: the paper's formulation, and hundreds of maps.
  "$(program benchmark_backend)" --markdown --runs "$few" --paper
  "$(program benchmark_frontend)" --markdown --runs "$few" --barn "$data/maps/barn"
} >"$written"
cp "$written" "$page"
