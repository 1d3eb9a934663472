#!/usr/bin/env bash
# Checks what a compiler does not.
#   lint.sh           the format of all C++ files (clang-format): seconds, part of continuous integration
#   lint.sh --tidy    the habits of the product's code as well (clang-tidy, .clang-tidy)
#   lint.sh --all     clang-tidy in tests and examples too, and with the static analyzer (by night)
# Exits non-zero when something is found. Both tools are those of Debian 12, version 14: others format otherwise.
set -uo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit
case ${1:-} in
  '') folders='' checks=() ;;
  --tidy) folders=src checks=() ;;
  --all) folders='src|test|examples' checks=(--checks=clang-analyzer-*) ;;
  *) sed -n '2,/^set/s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
status=0
git ls-files -z '*.cpp' '*.h' | xargs -0 clang-format --dry-run -Werror || status=1
[[ -n $folders ]] || exit "$status"

# Clang-tidy reads how each file is compiled, and the headers of the messages.
scripts/build.sh -DCATKIN_ENABLE_TESTING=ON fourwis_navigation_generate_messages_cpp >/dev/null || exit
/usr/bin/python3 - "$PWD/($folders)/" <<'END' | xargs -0 -n 1 -P "$(nproc)" \
  clang-tidy -p build --quiet "${checks[@]}" 2> >(grep -vE '^[0-9]+ warnings? (generated|treated)' >&2) || status=1
import json, re, sys
files = {entry["file"] for entry in json.load(open("build/compile_commands.json"))}
print(*sorted(file for file in files if re.match(sys.argv[1], file)), sep="\0", end="")
END
exit "$status"
