#!/usr/bin/env bash
# Draws the README's pictures of runs again, beside this script: draw.sh [SIDESTEP]
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
sidestep="$(realpath "${1:-$here/../../build/release/sim/apps/sidestep}")"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

# run SCENARIO [OPTION...]: into $work/SCENARIO
run() { "$sidestep" run "$1" -o "$work/$1" -q --no-plots "${@:2}"; }

# frames NAME SCENARIO SIZE TIME...: the run at these times, beside each other
frames() {
  local name="$1" scenario="$2" size="$3" inputs=() i=0
  for time in "${@:4}"; do
    "$sidestep" render "$work/$scenario" --quality fine --size "$size" --time "$time" --frame "$work/$((++i)).png" >/dev/null
    inputs+=(-i "$work/$i.png")
  done
  ffmpeg -v error -y "${inputs[@]}" -filter_complex "hstack=inputs=$i" "$here/$name.png"
}

run icub_torque_push
run icub_torque_push_no_adjustment
"$sidestep" film "$work/icub_torque_push" "$work/icub_torque_push_no_adjustment" -o "$work/film.mp4" \
  --labels "with step adjustment,without" --times 5.25,5.45,5.65,5.85,6.1,6.5,7.5 \
  --strip "$work/strip.png"
cp "$work/strip.png" "$here/icub_torque_push.png"

run icub_walk_right_arm_push --no-video
frames icub_push icub_walk_right_arm_push 480x420 7.6 8.6 9.8 11.4
run hopper_push --no-video
frames hopper_push hopper_push 480x360 1.98 2.45 2.78
run biped_walk_to_run_push --no-video
frames biped_push biped_walk_to_run_push 400x390 1.4 1.8 2.4 4.0
