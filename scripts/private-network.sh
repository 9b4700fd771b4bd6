#!/bin/sh
# Runs a command in a network of its own whose loopback interface has the addresses 127.0.0.1 and
# 127.0.0.2: two simulated cameras need two. As root it takes no user namespace, in which nobody may
# raise the priority of the threads that receive frames.
# Usage: scripts/private-network.sh COMMAND [ARGUMENT...]
set -eu

for options in -n -rn; do
    if unshare $options true 2>/dev/null; then
        # A line's rate: without it a frame larger than the receive buffer arrives faster than
        # anybody can take it. Not every kernel has it.
        exec unshare $options sh -c '
            ip link set lo up && ip addr add 127.0.0.2/8 dev lo || exit 1
            tc qdisc add dev lo root tbf rate 2500mbit burst 256kb limit 64mb 2>/dev/null || true
            exec "$@"' sh "$@"
    fi
done
echo "A private network cannot be made: install util-linux (unshare) and iproute2 (ip), and either" >&2
echo "allow user namespaces (sysctl kernel.unprivileged_userns_clone=1) or run as root." >&2
exit 1
