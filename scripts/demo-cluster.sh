#!/usr/bin/env bash
# A recorded run measured by three workers on this machine, by way of a NATS server of its own; one of them is
# killed in the middle. The results are then compared, bit for bit, with those of the run.
# Usage: scripts/demo-cluster.sh LFPIV CONFIG SHOTS
set -euo pipefail

lfpiv=$1
config=$2
shots=$3
out=results/cluster
broker=$(command -v nats-server || echo /usr/sbin/nats-server)

rm -rf "$out"
mkdir -p "$out"
started=()
stop_all() {
    for process in "${started[@]}"; do
        kill -TERM "$process" 2>/dev/null || true
    done
}
trap stop_all EXIT

fail() {
    echo "$1; see $out" >&2
    exit 1
}

# Waits until a command succeeds, as long as a process lives.
await() {
    local process=$1
    shift
    until "$@"; do
        kill -0 "$process" 2>/dev/null || return 1
        sleep 0.05
    done
}

echo "records $shots shots of $config"
"$lfpiv" run --config "$config" --shots "$shots" >"$out/run.txt" 2>"$out/run.log" || fail "the run has failed"
recorded=$(sed -n 's/^results: *//p' "$out/run.txt")
# Shots that were shed are measured later: then all of them have a result to compare with.
"$lfpiv" process "$recorded" >/dev/null 2>>"$out/run.log"
run=$out/$(basename "$recorded")
cp -a "$recorded" "$run"
rm -f "$run"/velocity* "$run"/shot_*

# It chooses a free port itself, and writes which.
"$broker" --addr 127.0.0.1 --port -1 --jetstream --store_dir "$out/broker" --ports_file_dir "$out" \
    >"$out/broker.log" 2>&1 &
started+=($!)
ports=$out/$(basename "$broker")_$!.ports
await $! test -s "$ports" || fail "the NATS server does not start"
url=$(grep -o 'nats://[^"]*' "$ports" | head -1)

declare -A workers
for name in one two three; do
    "$lfpiv" work --url "$url" --name "$name" >"$out/$name.log" 2>&1 &
    workers[$name]=$!
    started+=($!)
done
"$lfpiv" process "$run" --cluster "$url" --heartbeat-timeout 2 >"$out/cluster.txt" 2>"$out/cluster.log" &
coordinator=$!
started+=($coordinator)
echo "three workers and a coordinator share $shots shots by way of $url"

has_shots() {
    [ "$(find "$run" -name 'shot_*.vti' | wc -l)" -ge "$1" ]
}
if await "$coordinator" has_shots $((shots / 3)); then
    kill -KILL "${workers[two]}"
    wait "${workers[two]}" 2>/dev/null || true
    echo "worker two is killed after $(find "$run" -name 'shot_*.vti' | wc -l) shots"
fi
began=$SECONDS
wait "$coordinator" || fail "not every shot was measured"
echo "the others have measured the rest $((SECONDS - began)) s later"
echo
cat "$out/cluster.txt"
echo
"$lfpiv" compare "$recorded" "$run" | head -1
