#!/usr/bin/env bash
# compare_programs.sh OLD_TREE NEW_TREE: whether two builds run every shipped scenario alike.
#
# Runs each scenario of OLD_TREE with OLD_TREE/build/release's program and OLD_TREE's robots, the
# scenario of the same name of NEW_TREE with the other's, and compares the verdicts and, bit for bit,
# the columns that both trajectory.csv have, but for wall-clock ones. Prints a line a scenario; exits
# with 1 if any differ.
set -euo pipefail
old="$(cd "$1" && pwd)" new="$(cd "$2" && pwd)"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

# Logs of every tick and digit; programs from before --log write no others.
full_log() {  # full_log <program>
  if "$1" run --help | grep -q -e --log; then echo "--log full"; fi
}

runs() {  # runs <tree> <folder>
  local program="$1/build/release/sim/apps/sidestep"
  find "$1/scenarios" -maxdepth 1 -name '*.yaml' -print0 |
    OMP_NUM_THREADS=1 SIDESTEP_DATA_DIR="$1" xargs -0 -P "$(nproc)" -I{} \
    sh -c '"$1" run "$4" $3 --no-video --no-plots --quiet --out "$2/$(basename "$4" .yaml)" >/dev/null 2>&1 || true' \
    sh "$program" "$2" "$(full_log "$program")" {}
}
runs "$old" "$work/old"
runs "$new" "$work/new"

# columns <trajectory.csv> <header of names to keep>: those columns, in that order.
columns() {
  awk -F, -v OFS=, -v keep="$2" 'NR == 1 { n = split(keep, name, ","); for (i = 1; i <= NF; ++i) at[$i] = i }
    { line = ""; for (k = 1; k <= n; ++k) line = line (k > 1 ? OFS : "") $at[name[k]]; print line }' "$1"
}
verdict() { sed -n 's/^  "verdict": "\(.*\)",$/\1/p' "$1/summary.json"; }

differ=0
for folder in "$work"/old/*/; do
  name="$(basename "$folder")"
  a="$work/old/$name" b="$work/new/$name"
  if [[ ! -f "$b/trajectory.csv" ]]; then
    echo "$name: only in the old tree"; differ=1; continue
  fi
  common="$(grep -Fxf <(head -1 "$b/trajectory.csv" | tr ',' '\n') <(head -1 "$a/trajectory.csv" | tr ',' '\n') |
            grep -v '^wall_' | paste -sd,)"
  count="$(tr ',' '\n' <<<"$common" | wc -l)"
  if cmp -s <(columns "$a/trajectory.csv" "$common") <(columns "$b/trajectory.csv" "$common"); then
    same="same in $count columns"
  else
    row="$(cmp <(columns "$a/trajectory.csv" "$common") <(columns "$b/trajectory.csv" "$common") 2>&1 |
           sed -n 's/.*line \([0-9]*\)$/\1/p' || true)"
    same="DIFFERS from row ${row:-?} on"; differ=1
  fi
  [[ "$(verdict "$a")" == "$(verdict "$b")" ]] || differ=1
  echo "$name: $(verdict "$a") -> $(verdict "$b"), $same"
done
exit "$differ"
