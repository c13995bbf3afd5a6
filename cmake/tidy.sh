#!/usr/bin/env bash
# tidy.sh [FILE.cc...]: clang-tidy over these sources or over all of ours, a process a core.
#
# Reads .clang-tidy and the compile commands of preset `tools`, which it configures. Prints the
# warnings, and nothing else; exits with 1 if there are any.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

cmake --preset tools >/dev/null
if [[ $# -eq 0 ]]; then
  mapfile -t files < <(find models controller sim tests -name '*.cc' | sort)
  set -- "${files[@]}"
fi

# Each file's words come in one piece, without clang's count of what the headers of others have.
tidy_one() {
  local words status=0
  words="$(clang-tidy -p build/tools --quiet "$1" 2>&1)" || status=1
  words="$(grep -vE '^([0-9]+ (warning|error)s?( and [0-9]+ errors?)? generated\.|Error while processing .*|)$' \
           <<<"$words" || true)"
  [[ -z "$words" ]] || printf '%s\n' "$words"
  return "$status"
}
export -f tidy_one
printf '%s\0' "$@" | xargs -0 -n 1 -P "$(nproc)" bash -c 'tidy_one "$1"' bash || exit 1
