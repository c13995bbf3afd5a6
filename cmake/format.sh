#!/usr/bin/env bash
# format.sh [--check]: lays every source of ours out as .clang-format says; with --check it changes
# nothing, names what it would change, and exits with 1 if there is anything.
#
# Releases of clang-format differ in what they do: Debian 12's, 14, is the one that decides.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

version="$(clang-format --version | sed -E 's/.*version ([0-9]+).*/\1/')"
if [[ "$version" != 14 ]]; then
  echo "error: clang-format 14 is wanted, this is $version" >&2
  exit 1
fi
how=(-i)
[[ "${1:-}" != --check ]] || how=(--dry-run -Werror)
find cmake models controller sim tests \( -name '*.cc' -o -name '*.h' \) -print0 |
  xargs -0 -n 20 -P "$(nproc)" clang-format "${how[@]}" || exit 1
