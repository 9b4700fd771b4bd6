# `make demo` and `make test` set up a Debian machine that has a Rust toolchain, and run.

.DEFAULT_GOAL := help
.PHONY: help demo demo-cluster cluster-scale loopback test soak bench bench-convection bench-peers deb packages network-tools broker emulator components readers page-tools page format lint test-rust test-readers clean

# The compiler's linker, the NetCDF library with what finds it, and Aravis for the cameras with
# the USB library that its package forgets to name.
BUILD_PACKAGES := gcc libc6-dev pkg-config libnetcdf-dev libaravis-dev libusb-1.0-0-dev
# Two simulated cameras run in a network of their own, and tests fill and break small disks of their
# own: unshare, ip, mount and mkfs.ext4.
NETWORK_PACKAGES := util-linux mount iproute2 e2fsprogs
# The bench page is tested in a browser, and built again by node; `cargo build` needs neither.
PAGE_PACKAGES := chromium

# Shots go to other machines by way of a NATS server; its service is not enabled.
BROKER_PACKAGES := nats-server
# A worker without this processor's vector instructions measures in an emulator.
EMULATOR_PACKAGES := qemu-user

DEMO_CONFIG := config/sim.toml
DEMO_SHOTS := 5
LOOPBACK_SHOTS := 10
CLUSTER_SHOTS := 24

# How long the adversary goes on, and what its random numbers are made from; CASE=flips:123 runs one
# case alone.
SECONDS := 600
SEED := 1
CASE :=

BENCH_OUT := results/bench
# Sets of bench/report.toml; all when empty. PEERS is a JSON file with rows of other programs.
SETS :=
PEERS :=

help:
	@echo "make demo    build, run the simulated bench for $(DEMO_SHOTS) shots, print a table"
	@echo "make loopback  the same over real wires: GigE Vision and serial drivers against simulated"
	@echo "               instruments, for $(LOOPBACK_SHOTS) shots; what crossed the wires is kept"
	@echo "make demo-cluster  a recorded run of $(CLUSTER_SHOTS) shots measured by three workers, of which one is killed"
	@echo "make cluster-scale  shots a second of 1 to 64 machines, forecast from what this one measures"
	@echo "make test    everything that continuous integration checks; what passed with the same inputs is"
	@echo "             skipped unless CI=1"
	@echo "make soak    kills, damage, failing disks, floods and malformed files against the program for"
	@echo "             $(SECONDS) s: SECONDS=3600 SEED=7 goes on longer, with other random numbers"
	@echo "make bench   speed against error in one report; SETS=\"speed ring\" takes a part"
	@echo "make bench-convection  error on particles of a direct numerical simulation"
	@echo "make bench-peers  seconds and error beside ASTRA, OpenPIV and SciPy"
	@echo "make deb     a Debian package in target/deb: programs, systemd unit, documentation"
	@echo "make page    build the bench page from web/bench, after a change there"
	@echo "make clean   remove build outputs, the Python environments and the packages of node"

demo: packages
	cargo build --release --locked --package lfpiv
	target/release/lfpiv run --config $(DEMO_CONFIG) --shots $(DEMO_SHOTS)

loopback: packages network-tools
	cargo build --release --locked --package lfpiv
	scripts/loopback.sh target/release/lfpiv $(LOOPBACK_SHOTS)

demo-cluster: packages broker
	cargo build --release --locked --package lfpiv
	scripts/demo-cluster.sh target/release/lfpiv $(DEMO_CONFIG) $(CLUSTER_SHOTS)

# A forecast for SCALE_CONFIG; it says so where this machine is too busy for its predictions.
SCALE_CONFIG := config/bench.toml
cluster-scale: packages broker
	cargo build --release --locked --package lfpiv
	scripts/cluster-scale.sh target/release/lfpiv $(SCALE_CONFIG) 3 results/scale

# The tests are compiled by clippy, which is a compiler with more to say: warnings fail them.
test: BESIDE := --readers
test: format readers test-rust

# The adversary of `tests/adversary`, of which a minute is part of the tests, and the long cases.
soak: packages network-tools broker emulator page-tools
	LFPIV_SOAK_SECONDS=$(SECONDS) LFPIV_SOAK_SEED=$(SEED) LFPIV_SOAK_CASE=$(CASE) \
		cargo test --release --locked --test adversary -- --nocapture the_adversary_finds_nothing
	cargo test --release --locked --package lfpiv --package lfpiv-core --test recorded_run \
		--test capabilities --test cluster --test page -- --ignored --nocapture long_

# The whole report: some twenty minutes on two cores, not part of the tests.
bench: packages
	cargo build --release --locked
	target/release/lfpiv bench --suite bench/report.toml --out $(BENCH_OUT) \
		$(addprefix --set ,$(SETS)) $(addprefix --peers ,$(PEERS))

# Particles of a direct numerical simulation, which takes five minutes the first time.
CONVECTION := target/convection.npy
bench-convection: packages $(CONVECTION)
	cargo build --release --locked --package lfpiv --package lfpiv-bench
	target/release/lfpiv bench --suite bench/convection.toml --out results/convection

$(CONVECTION): bench/flows/convection.py | readers
	@mkdir -p $(@D)
	.venv/bin/python $< $@

# Needs 13 GB of memory and 7 GB of disk for the largest explicit matrix. One case, one turn:
# make bench-peers PEER_CASES=paper-50 PEER_TURNS=1
PEER_CASES :=
PEER_TURNS :=
bench-peers: packages
	cargo build --release --locked
	@scripts/install-python.sh .venv-peers bench/peers/requirements.txt
	.venv-peers/bin/python bench/peers/compare.py $(PEER_TURNS:%=--turns %) $(PEER_CASES)

# dpkg-shlibdeps and strip, which are not on every machine that can install a package.
deb: packages
	@scripts/install-packages.sh dpkg-dev binutils
	cargo build --release --locked --package lfpiv --package lfpiv-bench
	scripts/make-deb.sh target/release target/deb

packages:
	@scripts/install-packages.sh $(BUILD_PACKAGES)

network-tools:
	@scripts/install-packages.sh $(NETWORK_PACKAGES)

broker:
	@scripts/install-broker.sh $(BROKER_PACKAGES)

emulator:
	@scripts/install-packages.sh $(EMULATOR_PACKAGES)

# A minimal toolchain lacks these two.
components:
	@cargo fmt --version >/dev/null 2>&1 || rustup component add rustfmt
	@cargo clippy --version >/dev/null 2>&1 || rustup component add clippy

readers: packages
	@scripts/install-python.sh .venv tests/readers/requirements.txt

format: components
	cargo fmt --all --check

# Node of the system where there is one, Debian's otherwise; the packages that web/bench/package-lock.json names.
page-tools:
	@scripts/install-packages.sh $(PAGE_PACKAGES)
	@command -v npm >/dev/null || scripts/install-packages.sh nodejs npm
	@scripts/install-node.sh web/bench

page: page-tools
	cd web/bench && node build.mjs

lint: packages components
	cargo clippy --workspace --all-targets --locked -- -D warnings

# Programs that passed with the same inputs are skipped, unless CI is set.
test-rust: packages network-tools broker emulator components page-tools
	@command -v python3 >/dev/null || scripts/install-packages.sh python3
	@python3 scripts/run-tests.py $(BESIDE)

# Reads what the binary of the Rust tests writes: built as they build it, or all would be built anew.
test-readers: packages readers
	python3 scripts/run-tests.py --build
	LFPIV=target/debug/lfpiv .venv/bin/python -m pytest --quiet tests/readers

clean:
	cargo clean
	rm -rf .venv .venv-peers web/bench/node_modules
