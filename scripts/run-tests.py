#!/usr/bin/env python3
"""Builds the tests in Rust and runs their programs, twice as many at once as there are cores.

With --readers, also those of the readers, in Python; with --build, builds only.

Many tests wait for instruments that keep time, so programs side by side take a third of the time of
one after the other. A program that passed before with the same inputs is skipped, unless the
environment variable CI is set. What a test prints is shown when its program fails.
"""

import hashlib
import json
import os
import re
import subprocess
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
STAMPS = ROOT / "target" / "test-stamps"
CARGO = ["cargo", "test", "--workspace", "--locked"]
# Clippy takes the compiler's place: everything is compiled once, and examined as it is.
ENVIRONMENT = {**os.environ, "RUSTC_WORKSPACE_WRAPPER": "clippy-driver"}

# Number of programs at once, and of tests at once in a program of WAIT.
SIDE_BY_SIDE = 2 * (os.cpu_count() or 1)
# Property tests draw the same input in each run: one that failed can be repeated. A seed that is set
# outside goes before this one.
PROPTEST_SEED = {"PROPTEST_RNG_SEED": "1"}
# By their titles, the longest first: the last to begin should be short.
LONGEST = [
    "cluster", "page", "recorded_run", "capabilities", "loopback", "readers", "lfpiv-core, unit tests", "laser",
    "daemon", "lfpiv, unit tests", "adversary", "commands", "validation", "synchroniser", "gige", "claims",
]
# Their input is the source text, which no compiled program shows.
READ_SOURCES = {"module_order"}
# Tests of these crates start programs, but for those by this name, and read documents.
WHOLE_PROGRAM = {"lfpiv", "lfpiv-bench"}
START_NO_PROGRAM = {"claims", "validation"}
# Their tests mostly wait for instruments.
WAIT = {"laser", "daemon", "synchroniser", "gige"}

RESULT = re.compile(r"^test result: \w+\. (\d+) passed; (\d+) failed; (\d+) ignored", re.MULTILINE)
READERS_RESULT = re.compile(r"^(?:(\d+) failed, )?(\d+) passed", re.MULTILINE)


@dataclass
class Program:
    """A test program: a compiled one, or Python with the tests of the readers."""

    crate: str
    name: str
    path: Path
    folder: Path
    arguments: tuple = ()

    @property
    def title(self):
        return self.name if self.name != "unit" else f"{self.crate}, unit tests"


@dataclass
class Outcome:
    program: Program
    passed: int
    failed: int
    seconds: float
    processor_s: float
    output: str
    ok: bool


READERS = Program(
    "tests", "readers", ROOT / ".venv/bin/python", ROOT, ("-m", "pytest", "--quiet", "tests/readers")
)


def build():
    """Compiles every test and examines all code; ends where the compiler has anything to say.

    Returns the test programs, and the programs that they start.
    """
    command = [*CARGO, "--all-targets", "--no-run", "--message-format=json-diagnostic-rendered-ansi"]
    compiler = subprocess.Popen(command, cwd=ROOT, env=ENVIRONMENT, stdout=subprocess.PIPE, text=True)
    tests, programs, complaints = [], [], 0
    for line in compiler.stdout:
        message = json.loads(line)
        if message["reason"] == "compiler-message":
            complaints += 1
            print(message["message"]["rendered"], file=sys.stderr)
        elif message["reason"] == "compiler-artifact" and message.get("executable"):
            sort_in(message, tests, programs)
    if compiler.wait() != 0 or complaints:
        sys.exit("The compiler has complained; see above.")
    return tests, sorted(programs)


def sort_in(artifact, tests, programs):
    """Adds an executable to the test programs, or to those that they start."""
    path, target = Path(artifact["executable"]), artifact["target"]
    kind = target["kind"][0]
    if not artifact["profile"]["test"]:
        if kind == "bin":
            programs.append(path)
        return
    if kind not in ("lib", "test"):
        return
    folder = Path(artifact["manifest_path"]).parent
    crate = "lfpiv" if folder == ROOT else f"lfpiv-{folder.name}"
    tests.append(Program(crate, target["name"] if kind == "test" else "unit", path, folder))


def digest_of(paths):
    digest = hashlib.sha256()
    for path in paths:
        digest.update(str(path).encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()


def inputs(programs):
    """Digests of what tests read beside themselves: files of data, documents, the programs they
    start, and the tests of the readers. None where the files cannot be listed."""
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT, stdout=subprocess.PIPE, text=True, check=False,
    )
    if listed.returncode != 0:
        return None
    files = [ROOT / name for name in sorted(set(listed.stdout.splitlines()))]
    data = [file for file in files if file.is_file() and file.suffix not in (".rs", ".py", ".md")]
    documents = [file for file in files if file.is_file() and file.suffix == ".md"]
    readers = [file for file in files if file.is_file() and file.suffix == ".py"]
    return tuple(digest_of(paths) for paths in (data, documents, programs, readers))


class Stamps:
    """Which programs passed with which inputs."""

    def __init__(self, programs):
        self.inputs = None if os.environ.get("CI") else inputs(programs)

    def of(self, program):
        if self.inputs is None or program.name in READ_SOURCES:
            return None
        data, documents, started, readers = self.inputs
        if program is READERS:
            return "\n".join(self.inputs)
        beside = data
        if program.crate in WHOLE_PROGRAM:
            beside += documents
        if program.crate in WHOLE_PROGRAM and program.name not in START_NO_PROGRAM:
            beside += started
        return digest_of([program.path]) + beside

    def file(self, program):
        return STAMPS / f"{program.crate}-{program.name}"

    def passed_before(self, program):
        stamp, file = self.of(program), self.file(program)
        return stamp is not None and file.is_file() and file.read_text() == stamp

    def keep(self, outcome):
        stamp, file = self.of(outcome.program), self.file(outcome.program)
        file.unlink(missing_ok=True)
        if outcome.ok and stamp is not None:
            STAMPS.mkdir(parents=True, exist_ok=True)
            file.write_text(stamp)


class Progress:
    """What runs, on one line of a terminal; what is done, a line each."""

    def __init__(self, programs):
        self.left, self.running, self.lock = programs, {}, threading.Lock()
        self.live = sys.stdout.isatty()

    def begin(self, program):
        with self.lock:
            self.running[program.title] = time.monotonic()

    def end(self, outcome):
        with self.lock:
            self.running.pop(outcome.program.title)
            self.left -= 1
            word = "ok    " if outcome.ok else "FAILED"
            self.say(
                f"{word} {outcome.program.title}: {outcome.passed} passed, {outcome.failed} failed, "
                f"{outcome.seconds:.0f} s ({outcome.processor_s:.0f} s of processors)"
            )
            if not outcome.ok:
                print(outcome.output, flush=True)

    def say(self, line):
        print(f"\r\033[K{line}" if self.live else line, flush=True)

    def show(self):
        with self.lock:
            now = time.monotonic()
            running = ", ".join(f"{name} {now - t:.0f} s" for name, t in self.running.items())
            print(f"\r\033[K{self.left} to go; running {running}"[:160], end="", flush=True)


def counted(program, output):
    """Tests passed and failed. Programs that start themselves print results of their own between."""
    if program is READERS:
        failed, passed = (READERS_RESULT.findall(output) or [("1", "0")])[-1]
        return int(passed), int(failed or 0)
    results = RESULT.findall(output)
    last = results[-1] if results else ("0", "1", "0")
    return int(last[0]), int(last[1])


def run(program):
    began = time.monotonic()
    environment = {
        **PROPTEST_SEED,
        **os.environ,
        "CARGO_MANIFEST_DIR": str(program.folder),
        "LFPIV": str(ROOT / "target/debug/lfpiv"),
    }
    if program.name in WAIT:
        environment["RUST_TEST_THREADS"] = str(SIDE_BY_SIDE)
    with tempfile.TemporaryFile() as captured:
        process = subprocess.Popen(
            [program.path, *program.arguments], cwd=program.folder, env=environment,
            stdin=subprocess.DEVNULL, stdout=captured, stderr=subprocess.STDOUT,
        )
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        captured.seek(0)
        output = captured.read().decode(errors="replace")
    passed, failed = counted(program, output)
    seconds, processor_s = time.monotonic() - began, used.ru_utime + used.ru_stime
    ok = process.returncode == 0 and failed == 0
    return Outcome(program, passed, failed, seconds, processor_s, output, ok)


def run_all(programs, stamps):
    """What became of each program, and of the examples in the documentation."""
    order = {title: place for place, title in enumerate(LONGEST)}
    programs = sorted(programs, key=lambda program: order.get(program.title, len(order)))
    progress = Progress(len(programs))

    def one(program):
        progress.begin(program)
        outcome = run(program)
        stamps.keep(outcome)
        progress.end(outcome)
        return outcome

    with ThreadPoolExecutor(SIDE_BY_SIDE) as lanes:
        waiting = [lanes.submit(one, program) for program in programs]
        examples = lanes.submit(documented_examples)
        while progress.live and not all(future.done() for future in [*waiting, examples]):
            progress.show()
            time.sleep(0.5)
        return [future.result() for future in waiting], examples.result()


def documented_examples():
    """Examples in the documentation of the crates: the compiler runs these itself."""
    ran = subprocess.run(
        [*CARGO, "--doc", "--quiet"],
        cwd=ROOT, env=ENVIRONMENT, capture_output=True, text=True, check=False,
    )
    output = ran.stdout + ran.stderr
    results = RESULT.findall(output)
    if ran.returncode != 0:
        print(output)
    print(f"{'ok    ' if ran.returncode == 0 else 'FAILED'} examples in the documentation", flush=True)
    return sum(int(passed) for passed, _, _ in results), int(ran.returncode != 0)


def main():
    tests, programs = build()
    if "--build" in sys.argv:
        return
    if "--readers" in sys.argv:
        tests.append(READERS)
    stamps = Stamps(programs)
    due = [program for program in tests if not stamps.passed_before(program)]
    skipped = [program.title for program in tests if program not in due]
    if skipped:
        print(f"Unchanged since they passed: {', '.join(skipped)}. CI=1 runs them too.", flush=True)
    outcomes, (passed, failed) = run_all(due, stamps)
    passed += sum(outcome.passed for outcome in outcomes)
    failed += sum(max(outcome.failed, int(not outcome.ok)) for outcome in outcomes)
    used = os.times()
    print(f"{(used.children_user + used.children_system) / 60:.1f} minutes of processors")
    print(f"{passed} passed, {failed} failed")
    sys.exit(failed != 0)


if __name__ == "__main__":
    main()
