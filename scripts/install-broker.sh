#!/usr/bin/env bash
# Installs the Debian packages named on the command line, those of the NATS server, without its service: tests
# and demonstrations start their own. A server that was installed before stays as it is.
set -euo pipefail

here=$(dirname "$0")
if [ "${LFPIV_SKIP_PACKAGES:-0}" = 1 ] || command -v nats-server >/dev/null || [ -x /usr/sbin/nats-server ]; then
    exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ] && command -v sudo >/dev/null && sudo --non-interactive true 2>/dev/null; then
    as_root=(sudo --non-interactive)
fi

# A masked service is neither started nor enabled while its package is installed.
mask=/etc/systemd/system/nats-server.service
masked=0
if [ -d /etc/systemd/system ] && [ ! -e "$mask" ] && [ ! -L "$mask" ]; then
    if "${as_root[@]}" ln -s /dev/null "$mask" 2>/dev/null; then
        masked=1
    fi
fi
unmask() {
    [ "$masked" = 1 ] || return 0
    "${as_root[@]}" rm -f "$mask" /etc/systemd/system/multi-user.target.wants/nats-server.service
}
trap unmask EXIT
"$here/install-packages.sh" "$@"
