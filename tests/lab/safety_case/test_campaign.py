"""What was flown is kept, and a plan goes on where it ended."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from housefly.errors import RecordingError
from housefly.lab.safety_case import campaign
from housefly.lab.safety_case.campaign import (
    RESULTS_FILE,
    WIRED_RESULTS_FILE,
    flown_results,
    fly_plan,
    fly_wired_plan,
    wired_results,
)
from housefly.lab.safety_case.fault_phase import FaultPhase
from housefly.lab.safety_case.page import write_safety_case
from housefly.lab.safety_case.plan import SafetyPlan, flown_rows
from housefly.lab.safety_case.trial import TrialKey, TrialResult
from housefly.lab.safety_case.wired_flight import WiredKey, WiredResult, wired_keys


def landed(key: TrialKey) -> TrialResult:
    """Return the result of a flight that nobody flew."""
    bad = ("I1: touched wall at 0.5 m/s",) if key.seed == 3 else ()
    return TrialResult(
        key, FaultPhase.CRUISE, bad, "stands", 0.2, 6.0, 0.1, 0.4, None, 0.5, "lost <b>"
    )


KEYS = [TrialKey("F03/5s", seed) for seed in range(6)]
WIRED = [
    WiredResult(WiredKey("F24/killed", 0), 3.0, (), "landed"),
    WiredResult(WiredKey("F24/killed", 1), 4.0, ("I1: touched room wall",), "landed"),
]


def test_a_plan_that_was_cut_off_goes_on_and_flies_nothing_twice(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    flown: list[TrialKey] = []

    def fly(key: TrialKey) -> TrialResult:
        flown.append(key)
        return landed(key)

    monkeypatch.setattr(campaign, "fly_trial", fly)
    fly_plan(KEYS[:4], tmp_path, 1, lambda result: None)
    with (tmp_path / RESULTS_FILE).open("a") as file:
        file.write('{"key": {"row": "F03')
    results = fly_plan(KEYS, tmp_path, 1, lambda result: None)
    assert flown == KEYS
    assert results == [landed(key) for key in KEYS] == flown_results(tmp_path)


def test_a_flight_in_real_processes_is_kept_too(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    results = {result.key: result for result in WIRED}
    seats = set[int]()

    def fly(key: WiredKey, folder: Path, seat: int) -> WiredResult:
        seats.add(seat)
        return results[key]

    monkeypatch.setattr(campaign, "fly_wired", fly)
    fly_wired_plan([WIRED[1].key], tmp_path, 1, lambda result: None)
    fly_wired_plan(list(results), tmp_path, 2, lambda result: None)
    assert wired_results(tmp_path) == [WIRED[1], WIRED[0]]
    assert seats <= {0, 1}


def test_every_row_that_wires_can_carry_is_flown_in_real_processes() -> None:
    flown = {key.row.partition("/")[0] for key in wired_keys(1)}
    assert {"F02", "F13", "F19", "F24", "F25", "F30", "F34"} <= flown
    assert {key.row for key in wired_keys(4, ("F24",))} == {"F24/killed", "F24/stopped"}


@pytest.mark.parametrize("damaged", [b"{}\n{}\n", b"\xff\xfe", b"[" * 100_000, b"5", b"null\n"])
@pytest.mark.parametrize("file", [RESULTS_FILE, WIRED_RESULTS_FILE])
def test_a_damaged_line_is_told_with_its_number(file: str, damaged: bytes, tmp_path: Path) -> None:
    (tmp_path / file).write_bytes(damaged)
    with pytest.raises(RecordingError, match="line 1"):
        (flown_results if file == RESULTS_FILE else wired_results)(tmp_path)
    assert (tmp_path / file).read_bytes() == damaged


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("told_after", "a"),
        ("violations", [1]),
        ("violations", ["\ud800"]),
        ("key", {"row": [], "seed": 1}),
    ],
    ids=["text", "number", "surrogate", "list"],
)
@pytest.mark.parametrize("file", [RESULTS_FILE, WIRED_RESULTS_FILE])
def test_a_value_of_another_kind_is_told_with_its_line(
    file: str, name: str, value: object, tmp_path: Path
) -> None:
    good = landed(KEYS[0]) if file == RESULTS_FILE else WIRED[0]
    plain = good.to_json()
    own = "began_at" if name == "told_after" and name not in plain else name
    lines = [json.dumps(plain), json.dumps({**plain, own: value})]
    (tmp_path / file).write_text("\n".join([*lines, ""]))
    with pytest.raises(RecordingError, match=r"line 2: \S+ is .*; remove it to go on$"):
        (flown_results if file == RESULTS_FILE else wired_results)(tmp_path)


def test_a_plan_holds_every_row_its_control_and_every_pair_once() -> None:
    keys = SafetyPlan(seeds=8, controls=2, pairs=1, fault_free=3).keys()
    assert len(set(keys)) == len(keys)
    rows, crossed = flown_rows(), [row for row in flown_rows() if row.crossed]
    single = len(rows) - len(crossed)
    pairs = single * (single - 1) // 2
    harmful = sum(row.harmful for row in rows)
    with_orders = sum(key.row.split("/")[0] in {row.number for row in crossed} for key in keys)
    controls = 2 * sum(row.harmful for row in crossed)
    assert len(keys) == 8 * single + 2 * harmful + 3 + pairs + with_orders - controls
    assert with_orders - controls >= 5 * len(crossed)


def test_the_page_names_every_row_and_the_unsafe_flight_and_escapes_words(tmp_path: Path) -> None:
    path = write_safety_case(tmp_path, [landed(key) for key in KEYS], WIRED, {"on": "today"})
    page = path.read_text()
    assert all(f'id="F{number:02d}"' in page for number in range(1, 46))
    assert "2 of 8 flights unsafe" in page
    assert "lost &lt;b&gt;" in page
    assert "housefly safety --again F03/5s --seed 3" in page
