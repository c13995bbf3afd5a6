#!/usr/bin/env bash
# Every test of the repository: installs missing packages, builds twice, runs twice.
#   dev      asserts, sanitizers, warnings are errors: unit and layering tests
#   release  what users run: the numerical unit tests again, layering and the closed loops
# Clean clone to verdict in minutes; a second time only what changed is built.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
jobs="$(nproc)"

step() { printf '\n== %s\n' "$*"; }
trap 'printf "\n== FAILED: %s\n" "$current" >&2' ERR

current="installing packages"
cmake/install_packages.sh

for preset in dev release; do
  current="building preset $preset"
  step "$current"
  cmake --preset "$preset" >/dev/null
  cmake --build --preset "$preset" --parallel "$jobs"
done

current="unit and layering tests with sanitizers (preset dev)"
step "$current"
ctest --preset dev --parallel "$jobs" --no-tests=error --label-regex 'unit|layering'

current="unit, layering and closed-loop tests (preset release)"
step "$current"
ctest --preset release --parallel "$jobs" --no-tests=error --label-exclude 'cluster|bench'

step "all tests passed"
