#!/usr/bin/env bash
# install-packages.sh HEADING...
# Installs what scripts/packages.txt lists under the headings and this machine lacks.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

wanted=()
for heading in "$@"; do
  listed=$(awk -v heading="[$heading]" '
    /^[[:space:]]*(#|$)/ { next }
    /^\[/ { inside = ($0 == heading); next }
    inside { print $1 }' "$here/packages.txt")
  [ -n "$listed" ] || { echo "install-packages.sh: no heading [$heading] in packages.txt" >&2; exit 2; }
  mapfile -t -O "${#wanted[@]}" wanted <<<"$listed"
done

missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || {
    echo "These packages are missing and neither root nor sudo is at hand to install them:" >&2
    echo "  apt-get install ${missing[*]}" >&2
    exit 1
  }
  as_root=(sudo)
fi

echo "Installing ${#missing[@]} packages: ${missing[*]}"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends -o Dpkg::Use-Pty=0 "${missing[@]}" >/dev/null
