#!/usr/bin/env bash
# clean_root_test.sh BUILD_DIR: whether the Debian packages of a build install and run on a Debian 12
# that has nothing else on it, no source tree either.
#
# Packs BUILD_DIR, bootstraps a minimal root from the mirror that this machine's apt uses, installs
# the packages there with apt, and runs them. Then builds controller/example there against
# sidestep-dev, and runs it, if the repository has one. Leaves nothing behind. Needs root and
# debootstrap.
set -euo pipefail
source_dir="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
build_dir="$(cd "$1" && pwd)"
suite=bookworm

fail() { printf 'FAILED: %s\n' "$*" >&2; exit 1; }
[[ "$(id -u)" -eq 0 ]] || fail "needs root"
command -v debootstrap >/dev/null || fail "needs debootstrap"

work="$(mktemp -d)"
root="$work/root"
clean_up() {
  ! mountpoint -q "$root/proc" || umount "$root/proc"
  rm -rf --one-file-system "$work"
}
trap clean_up EXIT
step() { printf '\n== %s\n' "$*"; }
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive "$@"; }
install() {
  inside apt-get install -y -qq --no-install-recommends "$@" >"$work/apt.log" 2>&1 ||
    { tail "$work/apt.log"; fail "apt-get install $*"; }
}

# from_folder FOLDER COMMAND...: in the root, as a user in a folder.
from_folder() { inside sh -c 'cd "$1" && shift && exec "$@"' sh "$@"; }

# expect EXIT_CODE WORDS COMMAND...: the command's exit code, and words that it says.
expect() {
  local code="$1" words="$2" status=0 said
  said="$("${@:3}" 2>&1)" || status=$?
  printf '%s\n' "$said" | tail -n 6
  [[ "$status" -eq "$code" ]] || fail "exit code $status, wanted $code: ${*:3}"
  [[ "$said" == *"$words"* ]] || fail "doesn't say '$words': ${*:3}"
}

step "packing"
(cd "$build_dir" && cpack -G DEB -B "$work/packages" >/dev/null 2>&1) || fail "cpack"

step "bootstrapping a minimal Debian 12"
mirror="$(apt-get indextargets --format '$(CODENAME) $(SITE)' 'Created-By: Packages' 2>/dev/null |
          awk -v suite="$suite" '$1 == suite { print $2; exit }')"
[[ -n "$mirror" ]] || fail "this machine's apt has no mirror of $suite"
debootstrap --variant=minbase "$suite" "$root" "$mirror" >"$work/debootstrap.log" 2>&1 ||
  { tail "$work/debootstrap.log"; fail "debootstrap"; }
mount -t proc proc "$root/proc"
mkdir "$root/packages" "$root/elsewhere"
cp "$work"/packages/sidestep_*.deb "$root/packages/sidestep.deb"
cp "$work"/packages/sidestep-dev_*.deb "$root/packages/sidestep-dev.deb"

step "installing sidestep"
inside apt-get update -qq
install /packages/sidestep.deb
[[ ! -e "$root$source_dir" ]] || fail "the root has a source tree"

step "running it without ffmpeg and gnuplot, from any folder"
expect 0 "hopper_push: PASS" from_folder / sidestep run hopper_push --no-video --no-plots -q
expect 0 "hopper_push: PASS" from_folder /elsewhere \
  sidestep run hopper_push.yaml --no-video --no-plots -q
expect 2 "did you mean 'hopper_push'?" from_folder /elsewhere sidestep run hoper_push
expect 0 "icub3" from_folder /elsewhere sidestep robots

step "running it with plots and video"
install gnuplot-nox ffmpeg
expect 0 "hopper_push: PASS" from_folder /elsewhere sidestep run hopper_push --no-video --force -q
[[ -s "$root/elsewhere/renders/hopper_push/plots/com.svg" ]] || fail "no plot"
expect 0 "video" from_folder /elsewhere sidestep run hopper_hop --set duration_s=1 --set expect={} -q
[[ -s "$root/elsewhere/renders/hopper_hop/video.mp4" ]] || fail "no video"

step "building against sidestep-dev"
install g++ cmake ninja-build /packages/sidestep-dev.deb
# build_and_run FOLDER: copies a CMake project of its own into the root, builds it there and runs
# each program that it makes.
build_and_run() {
  local there program
  there="/elsewhere/$(basename "$1")"
  cp -r "$1" "$root$there"
  from_folder "$there" cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null
  from_folder "$there" cmake --build build
  while IFS= read -r program; do
    expect 0 "" from_folder "$there" "./build/$(basename "$program")"
  done < <(find "$root$there/build" -maxdepth 1 -type f -perm -u+x)
}
build_and_run "$source_dir/tests/package/user_program"
[[ ! -d "$source_dir/controller/example" ]] || build_and_run "$source_dir/controller/example"

step "passed"
