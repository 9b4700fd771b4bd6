#!/usr/bin/env bash
# How many shots a second machines on a network would measure: records a short run, starts a NATS server of its own, and
# measures on this machine what the forecast is made of.
# Usage: scripts/cluster-scale.sh LFPIV CONFIG SHOTS OUT
set -euo pipefail

lfpiv=$1
config=$2
shots=$3
out=$4
broker=$(command -v nats-server || echo /usr/sbin/nats-server)

rm -rf "$out"
mkdir -p "$out"
"$lfpiv" run --config "$config" --shots "$shots" >"$out/run.txt" 2>"$out/run.log" || {
    echo "the run has failed; see $out" >&2
    exit 1
}
recorded=$(sed -n 's/^results: *//p' "$out/run.txt")

# It chooses a free port itself, and writes which.
"$broker" --addr 127.0.0.1 --port -1 --jetstream --store_dir "$out/broker" --ports_file_dir "$out" \
    >"$out/broker.log" 2>&1 &
server=$!
trap 'kill "$server" 2>/dev/null || true' EXIT
ports=$out/$(basename "$broker")_$server.ports
until test -s "$ports"; do
    kill -0 "$server" 2>/dev/null || {
        echo "the NATS server does not start; see $out/broker.log" >&2
        exit 1
    }
    sleep 0.05
done
url=$(grep -o 'nats://[^"]*' "$ports" | head -1)
"$lfpiv" scale "$recorded" --url "$url" --out "$out"
