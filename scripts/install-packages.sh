#!/usr/bin/env bash
# Installs the Debian packages named on the command line, those that are missing only.
# LFPIV_SKIP_PACKAGES=1 skips it, for systems where they are provided in another way.
set -euo pipefail

if [ "${LFPIV_SKIP_PACKAGES:-0}" = 1 ]; then
    exit 0
fi

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    echo "This system has no apt-get. Install what corresponds to these Debian packages:" >&2
    echo "    $*" >&2
    echo "and run make again with LFPIV_SKIP_PACKAGES=1." >&2
    exit 1
fi

missing=()
for package in "$@"; do
    status=$(dpkg-query --show --showformat='${Status}' "$package" 2>/dev/null || true)
    [ "$status" = "install ok installed" ] || missing+=("$package")
done
if [ "${#missing[@]}" -eq 0 ]; then
    exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    if command -v sudo >/dev/null && sudo --non-interactive true 2>/dev/null; then
        as_root=(sudo --non-interactive)
    else
        echo "These Debian packages are missing and only root may install them. Run:" >&2
        echo "    sudo apt-get install --no-install-recommends ${missing[*]}" >&2
        echo "and then make again." >&2
        exit 1
    fi
fi

install() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install --yes --quiet --no-install-recommends "${missing[@]}"
}

echo "Installing ${missing[*]}"
# The package lists of a fresh machine are empty or old; refresh them only when needed.
install || { "${as_root[@]}" apt-get update --quiet && install; } || {
    echo "apt-get could not install: ${missing[*]}" >&2
    exit 1
}
