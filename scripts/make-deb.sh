#!/usr/bin/env bash
# Makes a Debian package of built programs: make-deb.sh FOLDER_OF_PROGRAMS OUTPUT_FOLDER.
# The package has the programs, the systemd unit, which is not started by itself, the documentation and the
# example configurations.
set -euo pipefail
cd "$(dirname "$0")/.."

programs=$1
output=$2
version=$(sed -n '/^\[workspace.package\]/,/^\[/s/^version = "\(.*\)"/\1/p' Cargo.toml)
architecture=$(dpkg --print-architecture)

stage=$(mktemp --directory)
trap 'rm -rf "$stage"' EXIT
root=$stage/lfpiv
# What is in the package is for everyone, whatever the umask.
umask 022

install -D --mode 755 --strip "$programs/lfpiv" "$root/usr/bin/lfpiv"
if [ -x "$programs/lfpiv-bench" ]; then
    install -D --mode 755 --strip "$programs/lfpiv-bench" "$root/usr/bin/lfpiv-bench"
fi

mkdir -p "$root/usr/lib/systemd/system"
sed 's|/usr/local/bin/lfpiv|/usr/bin/lfpiv|' packaging/lfpiv.service \
    > "$root/usr/lib/systemd/system/lfpiv.service"

doc=$root/usr/share/doc/lfpiv
install -D --mode 644 --target-directory "$doc" README.md CHANGELOG.md ARCHITECTURE.md
install -D --mode 644 --target-directory "$doc/docs" docs/*
install -D --mode 644 --target-directory "$doc/config" config/*.toml
install -D --mode 644 --target-directory "$doc/examples" examples/*
if command -v mdbook >/dev/null; then
    mdbook build --dest-dir "$doc/html"
fi
cat > "$doc/copyright" <<COPYRIGHT
Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: lfpiv

Files: *
License: MIT or Apache-2.0
COPYRIGHT

# Which packages have the libraries that the programs need, dpkg-shlibdeps finds out; it wants a source
# package's control file.
mkdir -p "$stage/debian"
printf 'Source: lfpiv\n\nPackage: lfpiv\nArchitecture: any\n' > "$stage/debian/control"
depends=$(cd "$stage" && dpkg-shlibdeps -O --ignore-missing-info lfpiv/usr/bin/* 2>/dev/null)
depends=${depends#shlibs:Depends=}

mkdir -p "$root/DEBIAN"
cat > "$root/DEBIAN/control" <<CONTROL
Package: lfpiv
Version: $version
Architecture: $architecture
Maintainer: lfpiv <lfpiv@localhost>
Section: science
Priority: optional
Depends: $depends, adduser
Installed-Size: $(du --summarize --block-size=1024 "$root/usr" | cut --fields 1)
Description: light-field particle image velocimetry with two cameras
 Runs two plenoptic GigE Vision cameras and the synchroniser of a pulsed laser,
 measures velocity fields of three components from each pair of images, and
 serves them over HTTP while the bench runs.
CONTROL
cat > "$root/DEBIAN/postinst" <<'POSTINST'
#!/bin/sh
# The service's user and the folder of its configuration. Nothing is started: a laser is at the other end.
set -e
if [ "$1" = configure ]; then
    if ! getent passwd lfpiv >/dev/null; then
        adduser --system --group --home /var/lib/lfpiv --no-create-home lfpiv
    fi
    install -d -o root -g lfpiv -m 750 /etc/lfpiv
    if [ -d /run/systemd/system ]; then
        systemctl daemon-reload || true
    fi
fi
POSTINST
cat > "$root/DEBIAN/prerm" <<'PRERM'
#!/bin/sh
set -e
if [ "$1" = remove ] && [ -d /run/systemd/system ]; then
    systemctl disable --now lfpiv.service || true
fi
PRERM
chmod 755 "$root/DEBIAN/postinst" "$root/DEBIAN/prerm"

mkdir -p "$output"
package=$output/lfpiv_${version}_$architecture.deb
dpkg-deb --build --root-owner-group "$root" "$package" >/dev/null
echo "$package"
