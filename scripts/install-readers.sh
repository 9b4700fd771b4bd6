#!/usr/bin/env bash
# Makes the Python environment .venv in which the tests read results with the users' own tools.
set -euo pipefail
cd "$(dirname "$0")/.."

requirements=tests/readers/requirements.txt
stamp=.venv/installed-requirements.txt
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

rm -rf .venv
"$python" -m venv .venv
.venv/bin/python -m pip install --quiet --disable-pip-version-check --requirement "$requirements"
cp "$requirements" "$stamp"
