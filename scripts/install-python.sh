#!/usr/bin/env bash
# Makes a Python environment from a list of requirements: install-python.sh FOLDER REQUIREMENTS.
set -euo pipefail
cd "$(dirname "$0")/.."

environment=$1
requirements=$2
stamp=$environment/installed-requirements.txt
if cmp --silent "$requirements" "$stamp"; then
    exit 0
fi

can_make_environments() {
    "$1" -c 'import ensurepip, venv' 2>/dev/null
}

python=python3
if ! can_make_environments "$python"; then
    scripts/install-packages.sh python3 python3-venv
    python=/usr/bin/python3
fi
if ! can_make_environments "$python"; then
    echo "No Python that can make a virtual environment: install python3 with its venv module." >&2
    exit 1
fi

rm -rf "$environment"
"$python" -m venv "$environment"
"$environment/bin/python" -m pip install --quiet --disable-pip-version-check \
    --requirement "$requirements"
cp "$requirements" "$stamp"
