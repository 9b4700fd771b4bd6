#!/usr/bin/env bash
# The whole bench on one machine: simulated instruments at the ends of real wires, and the daemon
# that drives them; then the run that was recorded, once more over the same wires, with the same
# vectors. Two cameras need two addresses, so all of it runs in a network of its own.
# Usage: scripts/loopback.sh LFPIV SHOTS
set -euo pipefail

lfpiv=$1
shots=$2
out=results/loopback

if [ "${LFPIV_PRIVATE_NETWORK:-}" != 1 ]; then
    export LFPIV_PRIVATE_NETWORK=1
    exec "$(dirname "$0")/private-network.sh" "$0" "$@"
fi

# Switches the instruments on; what they are told goes to sim-bench.
switch_on() {
    rm -f "$out/synchroniser"
    "$lfpiv" sim-bench --config config/loopback-bench.toml --record "$out/sent.csv" "$@" \
        >"$out/sim-bench.txt" 2>&1 &
    bench=$!
    trap 'kill $bench 2>/dev/null || true' EXIT
    for _ in $(seq 100); do
        [ -e "$out/synchroniser" ] && return
        kill -0 $bench 2>/dev/null || break
        sleep 0.1
    done
    cat "$out/sim-bench.txt" >&2
    exit 1
}

switch_off() {
    kill -TERM $bench
    wait $bench || { cat "$out/sim-bench.txt" >&2; exit 1; }
    trap - EXIT
    cat "$out/sim-bench.txt"
}

# Every frame that was sent has arrived, pixel for pixel: camera, time of exposure and checksum.
compare_frames() {
    for camera in cam1 cam2; do
        cut -d, -f1,4,5 "$out/sent.csv" | grep "^$camera," | sort >"$out/$camera.sent"
        cut -d, -f1,3,6 "$out/received/$camera.csv" | grep "^$camera," | sort >"$out/$camera.received"
        if ! cmp -s "$out/$camera.sent" "$out/$camera.received"; then
            echo "$camera: frames sent and received differ; see $out/$camera.sent and .received" >&2
            exit 1
        fi
        echo "$camera: $(wc -l <"$out/$camera.sent") frames sent and received, pixel for pixel"
        rm "$out/$camera.sent" "$out/$camera.received"
    done
}

folder() {
    sed -n 's/^results: *//p' "$1"
}

rm -rf "$out"
mkdir -p "$out"
switch_on
"$lfpiv" run --config config/loopback.toml --shots "$shots" --truth config/loopback-bench.toml |
    tee "$out/run.txt"
switch_off
compare_frames
echo "serial transcript: $out/serial.txt, $(wc -l <"$out/serial.txt") lines"

echo
echo "The same run once more over the wires:"
run=$(folder "$out/run.txt")
switch_on --replay "$run"
"$lfpiv" run --config config/loopback.toml --shots "$shots" >"$out/again.txt"
switch_off
compare_frames
"$lfpiv" compare "$run" "$(folder "$out/again.txt")"
