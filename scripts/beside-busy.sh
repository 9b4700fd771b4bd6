#!/bin/sh
# Runs a command some times in a row beside four processes that compute without end, as on a machine
# that is used for other things. Stops at the first failure.
# Usage: scripts/beside-busy.sh TIMES COMMAND [ARGUMENT...]
set -eu

times=$1
shift
busy=""
trap 'kill $busy 2>/dev/null || true' EXIT
trap 'exit 130' INT TERM
for _ in 1 2 3 4; do
    sh -c 'while :; do :; done' &
    busy="$busy $!"
done
for n in $(seq "$times"); do
    began=$(date +%s)
    if ! "$@"; then
        echo "run $n of $times failed" >&2
        exit 1
    fi
    echo "run $n of $times passed in $(($(date +%s) - began)) s"
done
