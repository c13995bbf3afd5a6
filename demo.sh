#!/usr/bin/env bash
# Sees a robot get shoved and step, beside one that may not: installs missing packages, builds, runs two scenarios at
# once and joins their videos.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

# The same push with and without step adjustment.
with=icub_torque_push
without=icub_torque_push_no_adjustment

cmake/install_packages.sh
echo "building (the first time takes a few minutes)"
cmake --preset release >/dev/null
cmake --build --preset release --parallel "$(nproc)" --target sidestep

# run NAME FOLDER: prints the verdict and where video, plots and report are; its exit code is the verdict's.
out=renders/demo
sidestep=build/release/sim/apps/sidestep
run() { "$sidestep" run "scenarios/$1.yaml" --out "$out/$2" --force --jobs $((($(nproc) + 1) / 2)) "${@:3}"; }

echo "running $with and $without"
mkdir -p "$out"
run "$without" without --quiet >"$out/without.txt" &
run_without=$!
trap 'kill "$run_without" 2>/dev/null || true' EXIT
worst=0
run "$with" with || worst=$?
wait "$run_without" || worst=$(($? > worst ? $? : worst))
trap - EXIT
cat "$out/without.txt"
rm "$out/without.txt"

labels="with step adjustment,without"
"$sidestep" film "$out/with" "$out/without" --labels "$labels" -o "$out/film.mp4" --force
exit "$worst"
