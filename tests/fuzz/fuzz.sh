#!/usr/bin/env bash
# fuzz.sh SECONDS [READER...]: fuzzes these readers of files, or all, for SECONDS each, as many at a
# time as there are cores; the targets are those of preset `fuzz`. What was interesting in earlier
# runs is in build/fuzz/corpus/ and where the next one begins. Exits with 1 on a finding, whose input
# is then in build/fuzz/findings/; once it is mended, it belongs into seeds/READER/. Exits with 2 if
# it can't begin.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
if [[ ! "${1:-}" =~ ^[0-9]+$ ]]; then
  echo "usage: tests/fuzz/fuzz.sh SECONDS [READER...]" >&2
  exit 2
fi
seconds="$1"
shift
readers=("$@")
if [[ ${#readers[@]} -eq 0 ]]; then
  for folder in tests/fuzz/seeds/*/; do readers+=("$(basename "$folder")"); done
fi
export FUZZ_SECONDS="$seconds" FUZZ_BUILD="$PWD/build/fuzz"
for reader in "${readers[@]}"; do
  if [[ ! -d "tests/fuzz/seeds/$reader" ]]; then
    echo "error: there is no reader '$reader'; there are: $(ls -m tests/fuzz/seeds)" >&2
    exit 2
  fi
  if [[ ! -x "$FUZZ_BUILD/tests/fuzz/${reader}_fuzz" ]]; then
    echo "error: ${reader}_fuzz is not built: cmake --preset fuzz &&" \
      "cmake --build --preset fuzz --target fuzz_targets" >&2
    exit 2
  fi
done
mkdir -p "$FUZZ_BUILD/findings"
# A file of the maker's is read in milliseconds, a robot in some hundred: with sanitizers, on a busy
# machine, these are far beyond.
export FUZZ_BOUNDS="-timeout=20 -rss_limit_mb=1024 -malloc_limit_mb=512"
export ASAN_OPTIONS="quarantine_size_mb=16:detect_leaks=${FUZZ_LEAKS:-0}"

fuzz_one() {
  local reader="$1" work status=0
  work="$(mktemp -d)"
  mkdir -p "$FUZZ_BUILD/corpus/$reader"
  # Words of the format, as its seeds have them.
  grep -aohE '[A-Za-z_][A-Za-z0-9_]{2,40}' "tests/fuzz/seeds/$reader"/* | sort -u |
    sed 's/.*/"&"/' >"$work/words.dict"
  # shellcheck disable=SC2086  # bounds are several words
  TMPDIR="$work" "$FUZZ_BUILD/tests/fuzz/${reader}_fuzz" -seed=1 -max_total_time="$FUZZ_SECONDS" \
    $FUZZ_BOUNDS -max_len=40000 -dict="$work/words.dict" -print_final_stats=1 -report_slow_units=1 \
    -artifact_prefix="$FUZZ_BUILD/findings/$reader-" \
    "$FUZZ_BUILD/corpus/$reader" "tests/fuzz/seeds/$reader" >"$work/log" 2>&1 || status=1
  local inputs
  inputs="$(sed -n 's/^stat::number_of_executed_units: *//p' "$work/log")"
  if [[ "$status" -eq 0 ]]; then
    echo "$reader: ${inputs} inputs, no finding"
  else
    echo "$reader: FINDING after ${inputs:-some} inputs" >&2
    local marks='^fuzz: |ERROR|runtime error|what\(\)|SUMMARY|Test unit written'
    marks+='|^ *#[0-9]+ .*/(models|controller|sim|tests)/'
    if grep -qaE "$marks" "$work/log"; then
      grep -aE "$marks" "$work/log" | head -40 >&2
    else
      tail -n 20 "$work/log" >&2
    fi
  fi
  rm -rf "$work"
  return "$status"
}
export -f fuzz_one
printf '%s\0' "${readers[@]}" | xargs -0 -n 1 -P "$(nproc)" bash -c 'fuzz_one "$1"' bash || exit 1
