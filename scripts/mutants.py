#!/usr/bin/env python3
"""Whether the tests notice faults: seeded mutants of `cargo-mutants`, one after the other.

A mutant is tried against the tests of its own crate first, then against those of the crates above, until
one fails. What became of it is a line of tests/mutants.csv, so a list can be stopped and resumed. Works
in the tree it is started in, which must have no changes: use a worktree of its own.
Usage: scripts/mutants.py [--each 15] [--seed 1] [--part rawlog/src/], after `cargo install cargo-mutants`
"""

import argparse
import csv
import json
import os
import random
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RECORD = ROOT / "tests" / "mutants.csv"
# A mutant changes one function: with small units of code, the compiler makes the others once.
SMALL_UNITS = [
    f"--config=profile.dev.package.{name}.codegen-units=256"
    for name in ("lfpiv-core", "lfpiv-sim", "lfpiv-hw", "lfpiv-rawlog")
]
# A stage names its crate: `--workspace` would test all of them.
CARGO = ["cargo", *SMALL_UNITS, "test", "--locked"]
# What a property finds in a mutant is no case to keep.
ENVIRONMENT = {**os.environ, "PROPTEST_DISABLE_FAILURE_PERSISTENCE": "1"}
LONGEST_S = 300
# What becomes of a replacement that the compiler refuses.
NO_MUTANT = "does not compile"

# Parts of the code, and the tests that should notice: the quickest first.
PARTS = {
    "core/src/": ["-p lfpiv-core --lib", "-p lfpiv-core --test capabilities", "-p lfpiv-bench --test claims", "-p lfpiv --test commands"],
    "rawlog/src/": ["-p lfpiv-rawlog", "-p lfpiv --lib", "-p lfpiv --test recorded_run", "-p lfpiv --test adversary"],
    "hw/src/timing": ["-p lfpiv-hw --lib", "-p lfpiv-sim --test synchroniser", "-p lfpiv --lib", "-p lfpiv --test commands", "-p lfpiv --test laser"],
    "src/acquisition/": ["-p lfpiv --lib", "-p lfpiv --test recorded_run", "-p lfpiv --test laser", "-p lfpiv --test daemon", "-p lfpiv --test loopback"],
}


def mutants(seed, parts):
    """The mutants of these parts in a random order, the same for the same code and seed."""
    listed = subprocess.run(
        ["cargo", "mutants", "--list", "--json", "--workspace"],
        cwd=ROOT, stdout=subprocess.PIPE, check=True,
    )
    everything = sorted(json.loads(listed.stdout), key=lambda mutant: mutant["name"])
    for part in parts:
        inside = [mutant for mutant in everything if mutant["file"].startswith(part)]
        random.Random(f"{seed} {part}").shuffle(inside)
        yield inside, PARTS[part]


def mutated(text, mutant):
    """The file's text with the mutant's replacement in the place of its span."""
    lines = text.splitlines(keepends=True)

    def offset(place):
        return sum(len(line) for line in lines[: place["line"] - 1]) + place["column"] - 1

    span = mutant["span"]
    return text[: offset(span["start"])] + mutant["replacement"] + text[offset(span["end"]) :]


def cargo(arguments, longest_s=None):
    """Whether the command ended well, and in time where there is a limit."""
    command = [*CARGO, *arguments.split()]
    try:
        done = subprocess.run(
            command, cwd=ROOT, env=ENVIRONMENT, timeout=longest_s,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )
    except subprocess.TimeoutExpired:
        return False
    return done.returncode == 0


def outcome(mutant, stages):
    path = ROOT / mutant["file"]
    text = path.read_text()
    try:
        path.write_text(mutated(text, mutant))
        for stage in stages:
            if not cargo(f"{stage} --no-run"):
                return NO_MUTANT
            # Tests that do not end have noticed the mutant, too.
            if not cargo(stage, LONGEST_S):
                return f"caught by {stage}"
        return "survived"
    finally:
        path.write_text(text)


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--each", type=int, default=15, help="mutants of every part")
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--part", action="append", choices=list(PARTS), help="all when absent")
    chosen = arguments.parse_args()
    changes = ["git", "status", "--porcelain", "--", "*.rs"]
    if subprocess.run(changes, cwd=ROOT, stdout=subprocess.PIPE, check=True).stdout:
        sys.exit("The tree has changes: commit them, or use a worktree of its own.")
    known = {}
    if RECORD.is_file():
        known = dict(csv.reader(RECORD.open()))
    for inside, stages in mutants(chosen.seed, chosen.part or PARTS):
        tried = 0
        for mutant in inside:
            if tried == chosen.each:
                break
            became = known.get(mutant["name"]) or outcome(mutant, stages)
            tried += became != NO_MUTANT
            if mutant["name"] in known:
                continue
            print(f"{mutant['name']}: {became}", flush=True)
            with RECORD.open("a", newline="") as file:
                csv.writer(file).writerow([mutant["name"], became])


main()
