"""Fuzzes every parser of bytes from outside, guided by coverage; `make fuzz`.

What it tried lies in ``.fuzz`` and is gone on with in the next run. What covers most goes to
``tests/fuzz/corpus``, what broke a parser to ``tests/fuzz/crashes``: both are replayed by
``test_corpus.py``.
"""

from __future__ import annotations

import argparse
import hashlib
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Iterable, Sequence
from pathlib import Path

HERE = Path(__file__).resolve().parent
CORPUS, CRASHES, WORK = HERE / "corpus", HERE / "crashes", HERE.parents[1] / ".fuzz"
FILES_MAX, BYTES_MAX = 48, 14_000
"""Most files, and bytes, that are kept of one target; one file is always kept."""
_TIMEOUT, _MEMORY_MB = 10, 2048
_INSTRUMENTED = [
    *(f"housefly.{name}" for name in ("wires", "tracking", "sensors", "drones", "config")),
    *(f"housefly.{name}" for name in ("record", "bus", "room", "web", "hub", "ros2")),
    *(f"housefly.tasks.{name}" for name in ("api", "document", "intents", "rules")),
    *("housefly.lab.campaigns.spec", "housefly.lab.campaigns.draws"),
    *("housefly.twin.people", "housefly.twin.hands", "housefly.twin.faults"),
    "housefly.lab.safety_case",
    *("tomllib", "yaml", "mcap", "rosbags.serde", "hassil"),
]
_COMPILED = ["housefly.room.distance", "housefly.room.reach", "housefly.room.sight"]
_STATISTIC = re.compile(r"stat::number_of_executed_units:\s+(\d+)")
_PULSE = re.compile(r"^#(\d+)\s.*?cov: (\d+)")

sys.path.insert(0, str(HERE.parent / "support"))


def fuzz_one(name: str, arguments: Sequence[str]) -> None:
    """Hand this process to the fuzzer; ends with it."""
    import atheris

    with atheris.instrument_imports(include=_INSTRUMENTED, exclude=_COMPILED):
        from fuzz_targets import TARGETS
    target = TARGETS[name]
    for seed in target.seeds():
        target.run(seed)
    atheris.Setup([str(_itself(name)), *arguments], target.run)
    atheris.Fuzz()


def fuzzed(name: str, seconds: int) -> tuple[int, bool]:
    """Fuzz a target for so long; return how many inputs were tried, and whether all were fine."""
    from fuzz_targets import TARGETS

    target, tried = TARGETS[name], WORK / name
    crashes = CRASHES / name
    crashes.mkdir(parents=True, exist_ok=True)
    _fill(tried, (*target.seeds(), *_contents(CORPUS / name)))
    words = WORK / f"{name}.dict"
    words.write_text("".join(f'"{_escaped(word)}"\n' for word in target.words), encoding="ascii")
    started = time.monotonic()
    process = _child(
        name,
        str(tried),
        f"-max_total_time={seconds}",
        f"-max_len={target.length_max}",
        f"-timeout={_TIMEOUT}",
        f"-rss_limit_mb={_MEMORY_MB}",
        f"-artifact_prefix={crashes}/",
        "-print_final_stats=1",
        *([f"-dict={words}"] if target.words else []),
    )
    inputs, covered, said = 0, 0, []
    assert process.stdout is not None
    for line in process.stdout:
        if found := _PULSE.match(line):
            inputs, covered = int(found[1]), int(found[2])
            _show(f"{name}: {time.monotonic() - started:.0f} s, {inputs} inputs, {covered} edges")
        else:
            inputs = int(found[1]) if (found := _STATISTIC.search(line)) else inputs
            said += [] if line.startswith("INFO") else [line]
    is_fine = process.wait() == 0
    with (WORK / f"{name}.log").open("w", encoding="utf-8", errors="replace") as log:
        log.writelines(said)
    _show(f"{name}: {inputs} inputs, {covered} edges, {'fine' if is_fine else 'BROKEN'}", end="\n")
    if not is_fine:
        print("".join(said[-60:]))
    if not any(crashes.iterdir()):
        crashes.rmdir()
    return inputs, is_fine


def keep(name: str) -> None:
    """Replace the kept corpus of a target by the smallest files that cover most."""
    merged = WORK / f"{name}.merged"
    shutil.rmtree(merged, ignore_errors=True)
    merged.mkdir(parents=True)
    process = _child(name, "-set_cover_merge=1", "-max_len=65536", str(merged), str(WORK / name))
    process.communicate()
    if process.returncode:
        print(f"{name}: the corpus stays as it is, because some of it breaks the parser")
        return
    shutil.rmtree(CORPUS / name, ignore_errors=True)
    room = BYTES_MAX
    kept: list[bytes] = []
    for data in sorted(_contents(merged), key=len)[:FILES_MAX]:
        if not kept or len(data) <= room:
            kept.append(data)
            room -= len(data)
    _fill(CORPUS / name, kept)


def _child(name: str, *arguments: str) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, __file__, "--child", name, *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
    )


def _itself(name: str) -> Path:
    """Return a program that the fuzzer starts anew when it compares inputs."""
    program = WORK / f"{name}.sh"
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" "{__file__}" --child {name} "$@"\n')
    program.chmod(0o700)
    return program


def _fill(folder: Path, contents: Iterable[bytes]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for data in contents:
        (folder / hashlib.sha256(data).hexdigest()[:12]).write_bytes(data)


def _contents(folder: Path) -> list[bytes]:
    return [path.read_bytes() for path in sorted(folder.iterdir())] if folder.is_dir() else []


def _escaped(word: bytes) -> str:
    return "".join(f"\\x{byte:02x}" for byte in word)


def _show(text: str, end: str = "") -> None:
    is_terminal = sys.stdout.isatty()
    if is_terminal or end:
        print(f"\r\033[K{text}" if is_terminal else text, end=end, flush=True)


def main() -> int:
    """Fuzz the targets that are named, or all; return 1 when one broke."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("targets", nargs="*", help="their names; all when none is given")
    parser.add_argument("--seconds", type=int, default=30, help="for each target [s]")
    options = parser.parse_args()
    try:
        import atheris  # noqa: F401
    except ImportError:
        print("atheris is missing; install it with: pip install -e '.[fuzz]'")
        return 1
    from fuzz_targets import TARGETS

    if unknown := set(options.targets) - set(TARGETS):
        known = ", ".join(TARGETS)
        parser.error(f"no such target: {', '.join(sorted(unknown))}; there are {known}")
    WORK.mkdir(exist_ok=True)
    names = options.targets or list(TARGETS)
    total, broken = 0, []
    for number, name in enumerate(names, start=1):
        print(f"[{number}/{len(names)}] ", end="", flush=True)
        inputs, is_fine = fuzzed(name, options.seconds)
        total += inputs
        broken += [] if is_fine else [name]
        keep(name)
    print(f"{total} inputs to {len(names)} parsers; broken: {', '.join(broken) or 'none'}")
    return 1 if broken else 0


if __name__ == "__main__":
    if sys.argv[1:2] == ["--child"]:
        fuzz_one(sys.argv[2], sys.argv[3:])
    else:
        sys.exit(main())
