"""A hundred seeded visitor runs in lock step, scored on what the camera truly shows; then one over
real wires, from the bell to the picture.

    python benchmarks/visitor.py                            100 runs, about 8 minutes on a core
    python benchmarks/visitor.py --runs 10 --no-wires       a look
    python benchmarks/visitor.py --kept runs.jsonl          goes on where it was ended
    python benchmarks/visitor.py --people --no-wires        residents walk about meanwhile
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from dataclasses import asdict, fields
from pathlib import Path

from _bell import BellRun, ring
from _run import percentile, table
from scores.visitor_score import BEFORE, USEFUL_SHARE, VisitorScore, score_visitor

RUNS = 100
PLAN_GOAL = 1.3
AIRBORNE_GOAL = 3.0


def main() -> None:
    """Fly and print."""
    options = _options()
    scores = list(_scores(options.runs, options.people, options.kept))
    print("### The visitor service\n")
    _print_runs(scores, options.people)
    if not options.no_wires:
        with tempfile.TemporaryDirectory() as folder:
            _print_bell(ring(Path(folder)))


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=RUNS)
    parser.add_argument("--people", action="store_true")
    parser.add_argument("--kept", type=Path)
    parser.add_argument("--no-wires", action="store_true")
    return parser.parse_args()


def _scores(runs: int, among_people: bool, kept: Path | None) -> Iterator[VisitorScore]:
    """Yield the scores of the seeds; those that a file has already are taken from it."""
    known = {one.seed: one for one in _kept(kept)}
    for seed in range(1, runs + 1):
        score = known.get(seed) or score_visitor(seed, among_people=among_people)
        if kept is not None and seed not in known:
            with kept.open("a", encoding="utf-8") as file:
                file.write(json.dumps(asdict(score)) + "\n")
        print(f"{seed} of {runs}: {score.fault or 'well'}", file=sys.stderr, flush=True)
        yield score


def _kept(file: Path | None) -> Iterator[VisitorScore]:
    if file is None or not file.exists():
        return
    names = {one.name for one in fields(VisitorScore)}
    for line in file.read_text(encoding="utf-8").splitlines():
        try:
            row = json.loads(line)
        except ValueError:
            continue  # cut off when it was ended
        if set(row) == names:
            yield VisitorScore(**{**row, "clip": tuple(row["clip"])})


def _print_runs(scores: list[VisitorScore], among_people: bool) -> None:
    well = [one for one in scores if not one.fault]
    if not well:
        sys.exit(f"no run ended well: {Counter(one.fault for one in scores)}")
    where = "among residents who walk about" if among_people else "with nobody else at home"
    print(f"Seeds 1 to {len(scores)}, {where}; on the truth of the simulated room.\n")
    took = [one.useful_at / one.planned for one in well]
    useful = f"order to the first useful picture ({_percent(USEFUL_SHARE)} of it the visitor)"
    rows = [
        ("on the pad, untouched, the visitor in the whole clip", f"{len(well)} of {len(scores)}"),
        (f"in view in the {BEFORE:.0f} s before", _percent(min(o.in_before for o in well))),
        ("share of the picture in the visit, least", _percent(min(o.smallest for o in well))),
        ("turned away from the visitor in it, most", f"{max(o.facing for o in well):.2f} rad"),
        ("order to turning motors, median, longest", _two([o.motors_at for o in well], "s")),
        ("order to airborne, median, longest", _two([o.airborne_at for o in well], "s")),
        (f"{useful}, median, longest", _two([o.useful_at for o in well], "s")),
        (f"... over the time of `housefly plan --to entrance` (goal: {PLAN_GOAL})", _two(took, "")),
        ("stands again, median, longest", _two([o.ended_at for o in well], "s")),
        ("off the pad, most", f"{max(o.off_pad for o in well):.3f} m"),
        ("nearest to anything in the air", f"{min(o.clearance for o in well):.2f} m"),
    ]
    print(table(["what", "figure"], rows))
    for words, count in Counter(one.fault for one in scores if one.fault).most_common():
        print(f"\n{count} times: {words}.")


def _print_bell(run: BellRun) -> None:
    """Print the time line of one run over real wires."""
    rehearsed = run.task.rehearsal
    steps = (
        ("the room's memory tells of the bell", run.told),
        ("the task is asked for", run.asked),
        ("rehearsed, and begun", run.started),
        ("the pilot is given the order", run.ordered),
        ("the drone says that it takes off", run.motors),
        (f"airborne, in truth (goal: {AIRBORNE_GOAL:.0f} s)", run.airborne),
        ("first useful picture of the visitor", run.useful),
    )
    print("\nOnce over real wires, all processes on this machine, from a bell on MQTT:\n")
    pairs = [*zip(steps, (0.0, *(at for _, at in steps)), strict=False)]
    rows = [(what, f"{at:.2f}", f"{at - before:.2f}") for (what, at), before in pairs]
    print(table(["what", "since the bell [s]", "since the line above [s]"], rows))
    took = 0.0 if rehearsed is None else rehearsed.took
    print(
        f"\nThe rehearsal itself took {took:.2f} s. The picture came after"
        f" {run.useful / run.planned:.2f} times the flight time of `housefly plan --to entrance`"
        f" ({run.planned:.1f} s; goal: {PLAN_GOAL}). The task ended: {run.task.state.value}."
    )


def _two(values: list[float], unit: str) -> str:
    pair = (percentile(values, 0.5), max(values))
    return ", ".join(f"{value:.2f} {unit}".rstrip() for value in pair)


def _percent(share: float) -> str:
    return f"{100.0 * share:.1f} %"


if __name__ == "__main__":
    main()
