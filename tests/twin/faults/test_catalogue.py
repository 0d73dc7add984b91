"""The fault matrix as a table."""

from __future__ import annotations

from pathlib import Path

import pytest

from housefly.errors import ConfigError
from housefly.twin.faults.catalogue import FAULT_CATALOGUE, row_of
from housefly.twin.faults.fault_row import FaultRow
from housefly.twin.faults.parse import parse_fault
from housefly.twin.faults.vocabulary import Injection

ROOT = Path(__file__).resolve().parents[3]
TWIN = {Injection.LOCKSTEP, Injection.WIRES}


def test_every_row_of_the_matrix_is_there_once_and_in_order() -> None:
    assert [row.number for row in FAULT_CATALOGUE] == [f"F{n:02}" for n in range(1, 53)]


@pytest.mark.parametrize("row", FAULT_CATALOGUE, ids=lambda row: row.number)
def test_a_row_can_be_made_here_or_says_what_covers_it(row: FaultRow) -> None:
    assert row.title and row.safe_outcome and row.where
    assert bool(row.variants) == bool(row.where & TWIN)
    assert row.variants or row.covered_by
    assert not row.harmful or row.variants
    names = [variant.name for variant in row.variants]
    assert len(set(names)) == len(names)
    for variant in row.variants:
        assert parse_fault(f"{row.number}/{variant.name}@3s")
        assert min(fault.start for fault in variant.faults) == 0.0
        possible = frozenset.intersection(*(fault.type.where for fault in variant.faults))
        assert possible & row.where
        assert variant.wires_only == (Injection.LOCKSTEP not in possible)


@pytest.mark.parametrize(
    "reference",
    sorted(
        {
            word.rstrip(",")
            for row in FAULT_CATALOGUE
            for word in row.covered_by.split(" ")
            if word.startswith("tests/")
        }
    ),
)
def test_every_test_that_a_row_names_exists(reference: str) -> None:
    path, _, name = reference.partition("::")
    assert (ROOT / path).exists()
    assert not name or f"def {name}(" in (ROOT / path).read_text(encoding="utf-8")


def test_a_row_that_is_no_row_is_refused() -> None:
    with pytest.raises(ConfigError, match="F01 to F52"):
        row_of("F99")
