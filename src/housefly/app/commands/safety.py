"""``housefly safety``: the safety case."""

from __future__ import annotations

import os
import platform
import time
from argparse import ArgumentParser, Namespace
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console
from housefly.errors import ConfigError

if TYPE_CHECKING:
    from housefly.lab.safety_case.plan import SafetyPlan
    from housefly.lab.safety_case.trial import TrialResult
    from housefly.lab.safety_case.wired_flight import WiredResult

_DESCRIPTION = """\
Fly every fault of the matrix (docs/faults.md) in every phase of a service, in the simulated room, \
hundreds of
times with different seeds, and judge each flight on the truth: contacts, fence, commands, motors, \
and whether
it ends. The same flights without guards show that the faults do harm. What was flown is kept: \
Ctrl-C and the
same command go on, as long as it is the same source of Housefly; a folder of another one is \
refused. The
result is one page, safety-case.html."""
_EPILOG = """\
examples:
  housefly safety                              all of it (about two hours on two cores)
  housefly safety --quick                      a few flights of each row
  housefly safety --model crazyflie            a cut of it, flown by another drone
  housefly safety --wires 1                    and one of each in real processes, over real wires
  housefly safety --seeds 0 --wires 10         ten of each in real processes only
  housefly safety --seeds 0                    only the page, of what was flown before
  housefly safety --rows F13 F05 --seeds 40    two rows only
  housefly safety --again F13/2cm --seed 7     one flight again, with what was told"""
_MAX_WORKERS = 256
_AT_ONCE_MAX = 64
_QUICK_SEEDS, _QUICK_CONTROLS, _QUICK_CALM = 16, 4, 12
_SEEDS, _SEEDS_OF_MODEL, _CALM_OF_MODEL = 300, 5, 12


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--out", metavar="DIR", help="where to write (default: safety-case, or safety-case-MODEL)"
    )
    parser.add_argument(
        "--model", default="", help="of the drone: a cut, few flights of each row and no controls"
    )
    parser.add_argument("--rows", nargs="+", default=[], metavar="ROW", help="only these: F01 ...")
    parser.add_argument(
        "--seeds", type=int, metavar="N",
        help="flights of each row (default: 300, with --model 5); with 0 only those of --wires are"
        " flown, and the page shows what was flown before",
    )  # fmt: skip
    parser.add_argument(
        "--crossed", type=int, default=50, metavar="N",
        help="flights of each row that is crossed with a person's orders (default: 50)",
    )  # fmt: skip
    parser.add_argument("--quick", action="store_true", help="few flights of each row, no pairs")
    parser.add_argument(
        "--workers", type=int, default=0, metavar="N", help="processes (default: one per core)"
    )
    parser.add_argument(
        "--wires", type=int, default=0, metavar="N",
        help="also N flights of each row in real processes and real time, about 40 s each"
        " (default: 0)",
    )  # fmt: skip
    parser.add_argument(
        "--at-once", type=int, default=1, metavar="N",
        help="so many flights of --wires at the same time (default: 1): a machine that is too slow"
        " for them makes late pilots, and other flights",
    )  # fmt: skip
    parser.add_argument("--again", metavar="ROW", help="fly one flight and say how it went")
    parser.add_argument("--seed", type=int, default=0, help="of --again (default: 0)")
    parser.add_argument(
        "--order", choices=("nothing", "stop", "land", "resume", "dead pilot"), default="nothing",
        help="of --again: what a person does (default: nothing)",
    )  # fmt: skip
    parser.add_argument("--unguarded", action="store_true", help="of --again: without guards")


def _run(options: Namespace) -> int:
    """Fly; 0 when no flight was unsafe, and each harmful row did harm without guards."""
    from housefly.app.compiling import CompiledPart, compile_once
    from housefly.app.disk_space import why_unwritable
    from housefly.config.airframe import airframe_names, is_model
    from housefly.lab.safety_case.plan import flown_rows
    from housefly.lab.safety_case.wired_flight import wired_rows

    if options.model and not is_model(options.model):
        allowed = ", ".join(airframe_names())
        raise ConfigError("--model", f"is {options.model!r}; allowed: {allowed}")
    if options.seeds is None:
        options.seeds = _SEEDS_OF_MODEL if options.model else _SEEDS
    options.out = options.out or "-".join(filter(None, ("safety-case", options.model)))
    known = sorted({row.number for row in (*flown_rows(), *wired_rows())})
    for row in options.rows:
        if row not in known:
            raise ConfigError("--rows", f"{row!r} is not flown here; there are {', '.join(known)}")
    if not 0 <= options.seeds <= 100_000:
        raise ConfigError("--seeds", f"is {options.seeds}; allowed: 0 to 100000")
    if not 0 <= options.crossed <= 100_000:
        raise ConfigError("--crossed", f"is {options.crossed}; allowed: 0 to 100000")
    if not 0 <= options.wires <= 1000:
        raise ConfigError("--wires", f"is {options.wires}; allowed: 0 to 1000")
    if not 1 <= options.at_once <= _AT_ONCE_MAX:
        raise ConfigError("--at-once", f"is {options.at_once}; allowed: 1 to {_AT_ONCE_MAX}")
    if not 0 <= options.seed < 2**31 - 1:
        raise ConfigError("--seed", f"is {options.seed}; allowed: 0 to {2**31 - 2}")
    if not 0 <= options.workers <= _MAX_WORKERS:
        raise ConfigError("--workers", f"is {options.workers}; allowed: 0 to {_MAX_WORKERS}")
    row = None if options.again is None else _row_again(options.again)
    if row is None and (problem := why_unwritable(Path(options.out))):
        raise ConfigError("--out", f"{options.out} cannot be written to: {problem}")
    if row is None and (options.seeds or options.wires):
        _claim(options)
    if row is not None or options.seeds or options.wires:
        compile_once(CompiledPart.CHAIN, console.print)
    if row is not None:
        return _fly_again(row, options)
    try:
        return _fly_all(options)
    except KeyboardInterrupt:
        words = f"what was flown is kept in {options.out}: run the same again to go on"
        console.print(words, markup=False, soft_wrap=True)
        raise


def _claim(options: Namespace) -> None:
    """Refuse to go on with the flights of another source."""
    from housefly.lab.safety_case.campaign import flown_results, wired_results
    from housefly.lab.safety_case.flown_by import claim_folder

    out = Path(options.out)
    claim_folder(out, has_flights=bool(flown_results(out) or wired_results(out)))


def _plan(options: Namespace) -> SafetyPlan:
    from housefly.lab.safety_case.plan import SafetyPlan

    rows = tuple(options.rows)
    if not options.seeds:
        return SafetyPlan(0, 0, 0, 0, 0, rows)
    if options.model:
        cut = options.seeds
        return SafetyPlan(cut, 0, 0, _CALM_OF_MODEL, cut, rows, options.model)
    if options.quick:
        return SafetyPlan(_QUICK_SEEDS, _QUICK_CONTROLS, 0, _QUICK_CALM, _QUICK_SEEDS, rows)
    return SafetyPlan(seeds=options.seeds, crossed=options.crossed, rows=rows)


def _fly_all(options: Namespace) -> int:
    from housefly.app.safety_progress import SafetyProgress
    from housefly.lab.safety_case.campaign import (
        flown_results,
        fly_plan,
        fly_wired_plan,
        wired_results,
    )
    from housefly.lab.safety_case.outcome_bounds import missed_bounds
    from housefly.lab.safety_case.page import write_safety_case
    from housefly.lab.safety_case.statistics import harmless_controls
    from housefly.lab.safety_case.wired_flight import wired_keys
    from housefly.twin.faults.catalogue import FAULT_CATALOGUE

    out, keys, began = Path(options.out), _plan(options).keys(), time.monotonic()
    workers = options.workers or len(os.sched_getaffinity(0))
    there = {result.key for result in flown_results(out)}
    with SafetyProgress("flights", len(keys), sum(key in there for key in keys)) as progress:
        results = fly_plan(
            keys,
            out,
            workers,
            lambda r: progress.advance(_unsafe_words(r) if r.key.guarded else ""),
        )
    results = results or flown_results(out)
    wired_wanted = wired_keys(options.wires, tuple(options.rows))
    wired_there = {result.key for result in wired_results(out)}
    done = sum(key in wired_there for key in wired_wanted)
    if wired_wanted:
        _claim(options)  # each is flown by the files as they are now, maybe hours later
    with SafetyProgress("in real time", len(wired_wanted), done) as progress:
        wired = fly_wired_plan(
            wired_wanted, out, options.at_once, lambda r: progress.advance(_unsafe_words(r))
        )
    wired = wired or ([] if options.seeds else wired_results(out))
    made = _made(options, results, wired, time.monotonic() - began)
    page = write_safety_case(out, results, wired, made)
    guarded = [result for result in results if result.key.guarded]
    bad = sum(r.unsafe for r in guarded) + sum(r.unsafe for r in wired)
    total = len(guarded) + len(wired)
    missed = sum(bool(missed_bounds(r)) for r in guarded if not r.unsafe)
    if missed:
        console.print(f"{missed} safe flights missed what their row promises: the page has them")
    harmless = harmless_controls(results, FAULT_CATALOGUE)
    if harmless:
        console.print(f"without guards no harm came of {', '.join(harmless)}: they show nothing")
    words = f"{bad} of {total} flights unsafe; the page: {page}"
    console.print(words, markup=False, soft_wrap=True)
    return 1 if bad or (harmless and not options.quick) else 0


def _unsafe_words(result: TrialResult | WiredResult) -> str:
    """Return which flight was unsafe and how, or "" for a safe one."""
    if not result.unsafe:
        return ""
    order = getattr(result.key, "order", None)
    ordered = f" {order.value}" if order is not None and order.value != "nothing" else ""
    where = f"{result.key.row or 'calm'}{ordered} seed {result.key.seed}"
    return f"{where}: {'; '.join(result.violations)}"


def _row_again(text: str) -> str:
    """Return the row of ``--again`` as flights name it; raises ConfigError naming those known."""
    from housefly.lab.safety_case.plan import flown_rows

    if text == "calm":
        return ""
    rows = {row.number: row for row in flown_rows()}
    for name in text.split("+"):
        number, slash, wanted = name.partition("/")
        if number not in rows:
            known = f"calm, {', '.join(rows)}"
            words = f"{number!r} is not flown in lock step; there are {known}"
            raise ConfigError("--again", words)
        variants = [variant.name for variant in rows[number].variants if not variant.wires_only]
        if slash and wanted not in variants:
            known = ", ".join(f"{number}/{variant}" for variant in variants)
            raise ConfigError("--again", f"{name!r} is no variant; there are {known}")
    return text


def _fly_again(row: str, options: Namespace) -> int:
    from housefly.lab.safety_case.faulty_flight import fly_trial
    from housefly.lab.safety_case.trial import PersonOrder, TrialKey

    order = PersonOrder(options.order)
    key = TrialKey(row, options.seed, not options.unguarded, order, options.model)
    result = fly_trial(key)
    for name, words in result.to_json().items():
        console.print(f"{name:<18}{words}", markup=False, soft_wrap=True)
    return 1 if result.unsafe else 0


def _made(
    options: Namespace,
    results: Sequence[TrialResult],
    wired: Sequence[WiredResult],
    seconds: float,
) -> dict[str, str]:
    from importlib import metadata

    from housefly.lab.safety_case.flown_by import flown_by_words

    rows = f" --rows {' '.join(options.rows)}" if options.rows else ""
    seeds = options.seeds or _of_each(r.key.row for r in results if r.key.guarded)
    how = " --quick" if options.quick else f" --seeds {seeds}"
    wires = options.wires or _of_each(r.key.row for r in wired)
    how += f" --wires {wires}" if wires else ""
    flights, flown_by = len(results) + len(wired), flown_by_words(Path(options.out))
    took = f"{seconds / 60:.1f} min, {len(os.sched_getaffinity(0))} cores"
    return {
        "made by": f"housefly safety{how}{rows}",
        "on": time.strftime("%Y-%m-%d %H:%M"),
        **({"flown by": flown_by} if flights else {}),
        "flights": f"{flights:,}".replace(",", " "),
        **({"time of this run": took} if options.seeds or options.wires else {}),
        "versions": f"Housefly {metadata.version('housefly')}, Python {platform.python_version()}",
    }


def _of_each(rows: Iterable[str]) -> int:
    """Return how many flights there are of a row, without pairs and those of no fault."""
    single = (row.partition("/")[0] for row in rows if row and "+" not in row)
    return max(Counter(single).values(), default=0)


SAFETY_COMMAND = Subcommand(
    name="safety",
    help="fly every fault in every phase, and judge each flight on the truth",
    description=_DESCRIPTION,
    add_arguments=_add_arguments,
    run=_run,
    epilog=_EPILOG,
)
