#!/usr/bin/env bash
# Builds the checked preset and runs its tests on a virtual screen.
set -euo pipefail
cd "$(dirname "$0")"

usage="Usage: ./test.sh [--asan] [--campaign]
  --asan      build and test with the address and undefined-behaviour sanitizers
  --campaign  run the slow seeded campaigns too"
preset=dev
campaign=""
for argument in "$@"; do
  case "$argument" in
    --asan) preset=asan ;;
    --campaign) campaign=-campaign ;;
    -h | --help) echo "$usage"; exit 0 ;;
    *) echo "Unknown option: $argument" >&2; echo "$usage" >&2; exit 2 ;;
  esac
done

bash installer/linux/install_packages.sh build run test
cmake --preset "$preset"
cmake --build --preset "$preset" --parallel "$(nproc)"
# Mesa's software renderer: the same picture on every machine.
LIBGL_ALWAYS_SOFTWARE=1 xvfb-run --auto-servernum --server-args="-screen 0 1280x800x24" \
  ctest --preset "$preset$campaign"
