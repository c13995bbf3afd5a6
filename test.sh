#!/usr/bin/env bash
# Every test of the repository: installs missing packages, checks the format, builds three times, runs
# three times.
#   dev      asserts and sanitizers: unit and layering tests
#   release  what users run: the QP again, allocations, the MPC's recorded problems, closed loops,
#            pages in a browser, a sweep on a cluster
#   fuzz     readers of files, with clang: half a minute of libFuzzer
# Clean clone to verdict in minutes; a second time only what changed is built.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
jobs="$(nproc)"

step() { printf '\n== %s\n' "$*"; }
trap 'printf "\n== FAILED: %s\n" "$current" >&2' ERR

current="installing packages"
cmake/install_packages.sh

current="format (cmake/format.sh mends it)"
step "$current"
cmake/format.sh --check

# build <preset> <targets...>
build() {
  current="building $*"
  step "$current"
  cmake --preset "$1" >/dev/null
  cmake --build --preset "$1" --parallel "$jobs" --target "${@:2}"
}
build dev unit_tests layering_tests
build release sidestep unit_tests closed_loop_tests browser_tests
build fuzz fuzz_targets

current="unit and layering tests with sanitizers (preset dev)"
step "$current"
ctest --preset dev --parallel "$jobs" --no-tests=error --label-regex 'unit|layering'

current="QP, MPC, allocation and closed-loop tests (preset release)"
step "$current"
ctest --preset release --parallel "$jobs" --no-tests=error --label-regex 'unit|closed_loop'

current="pages in a browser (preset release)"
step "$current"
ctest --preset release --no-tests=error --label-regex browser

current="a sweep on a real Slurm (preset release; skipped where it can't be installed)"
step "$current"
ctest --preset release --no-tests=error --label-regex slurm --verbose

current="readers of files under libFuzzer (preset fuzz)"
step "$current"
tests/fuzz/fuzz.sh 3

step "all tests passed"
