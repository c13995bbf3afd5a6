#!/usr/bin/env bash
# Sees a robot get shoved and step: installs missing packages, builds, runs the flagship scenario.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

cmake/install_packages.sh
echo "building (the first time takes a few minutes)"
cmake --preset release >/dev/null
cmake --build --preset release --parallel "$(nproc)" --target sidestep

# Prints the verdict and where video, plots and report are; its exit code is the verdict's.
build/release/sim/apps/sidestep run scenarios/hopper_push.yaml --out renders/demo --force
