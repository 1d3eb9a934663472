#!/usr/bin/env bash
# Checks what a compiler does not.
#   lint.sh           the format of all C++ files (clang-format) and the habits of the product's code (clang-tidy): minutes the
#                     first time, then seconds, as scripts/tidy.py knows what is clean
#   lint.sh --format  the format alone: seconds
#   lint.sh --all     clang-tidy in tests and examples too, and with the static analyzer (by night)
# Exits non-zero when something is found. Both tools are those of Debian 12, version 14: others format otherwise.
set -uo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit
by_night=bugprone-assert-side-effect,bugprone-multiple-statement-macro,bugprone-suspicious-string-compare
case ${1:-} in
  '') folders=(src) checks=() ;;
  --format) folders=() checks=() ;;
  --all) folders=(src test examples) checks=(--checks="clang-analyzer-*,$by_night") ;;
  *) sed -n '2,/^set/s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
status=0
git ls-files -z '*.cpp' '*.h' | xargs -0 clang-format --dry-run -Werror || status=1
[[ ${#folders[@]} -gt 0 ]] || exit "$status"

# Clang-tidy reads how each file is compiled, and the headers of the messages.
scripts/build.sh -DCATKIN_ENABLE_TESTING=ON fourwis_navigation_generate_messages_cpp >/dev/null || exit
/usr/bin/python3 scripts/tidy.py "${folders[@]}" -- "${checks[@]}" || status=1
exit "$status"
