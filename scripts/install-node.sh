#!/usr/bin/env bash
# Installs the packages of node that a folder's lock file names: install-node.sh FOLDER.
set -euo pipefail
cd "$(dirname "$0")/../$1"

stamp=node_modules/installed-lock.json
if cmp --silent package-lock.json "$stamp"; then
    exit 0
fi
npm ci --silent
cp package-lock.json "$stamp"
