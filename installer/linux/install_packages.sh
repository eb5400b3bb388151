#!/usr/bin/env bash
# Installs the packages of the named sections of packages.txt that are not there yet.
# Usage: installer/linux/install_packages.sh build run test
set -euo pipefail
list="$(dirname "$0")/packages.txt"

packages_of() {
  awk -v wanted="[$1]" '/^\[/ { inside = ($0 == wanted); next } inside && NF && !/^#/ { print $1 }' "$list"
}

is_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

missing=()
for section in "$@"; do
  packages=$(packages_of "$section")
  [ -n "$packages" ] || { echo "packages.txt has no section [$section]" >&2; exit 2; }
  if ! command -v dpkg-query >/dev/null; then
    echo "This is not Debian. Needed for $section:" $packages >&2
    continue
  fi
  for package in $packages; do
    is_installed "$package" || missing+=("$package")
  done
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "Run as root, or install sudo: packages are missing: ${missing[*]}" >&2; exit 1; }
  as_root=(sudo)
fi
echo "Installing: ${missing[*]}" >&2
"${as_root[@]}" apt-get update -qq </dev/null
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}" </dev/null
