#!/usr/bin/env bash
# Builds Nineline and opens its window on the worked example; without a screen, works the example into out/demo.
set -euo pipefail
cd "$(dirname "$0")"

usage="Usage: ./run.sh [--headless]
  --headless  open no window: write the worked example's results into out/demo"
headless=0
for argument in "$@"; do
  case "$argument" in
    --headless) headless=1 ;;
    -h | --help) echo "$usage"; exit 0 ;;
    *) echo "Unknown option: $argument" >&2; echo "$usage" >&2; exit 2 ;;
  esac
done
[ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] || headless=1

bash installer/linux/install_packages.sh build run
cmake --preset release
cmake --build --preset release --parallel "$(nproc)"

if [ "$headless" = 1 ]; then
  build/release/app/cli/nineline-cli demo --out out/demo
  echo "The worked example's results are in $PWD/out/demo"
else
  exec build/release/app/gui/nineline --example
fi
