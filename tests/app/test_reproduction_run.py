"""A flight that starves on a busy machine costs a note, not the run."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import Future
from pathlib import Path
from typing import Any, cast

import pytest

from housefly.app.reproduction_run import ATTEMPTS, Measured, Show, fly_wires_patiently
from housefly.app.reproduction_store import ReproductionStore
from housefly.app.reproduction_wires import WireService
from housefly.config.site import Site
from housefly.errors import LinkError

FLOWN = cast(WireService, object())
STARVED = "tracking lost for 0.3 s (limit 0.25 s): the drone holds itself"


class Attempts:
    """Flights over wires of which the first ones starve; whether the others had ended at each."""

    def __init__(self, starving: int, others: Future[Measured]) -> None:
        self.others_done: list[bool] = []
        self._starving, self._others = starving, others

    def __call__(self, site: Site, store: ReproductionStore, say: Callable[[str], None]) -> Any:
        self.others_done.append(self._others.done())
        say("ready")
        if len(self.others_done) <= self._starving:
            raise LinkError(STARVED)
        return FLOWN


@pytest.fixture
def store(tmp_path: Path) -> ReproductionStore:
    return ReproductionStore(tmp_path, "inputs")


@pytest.fixture
def others() -> Future[Measured]:
    """Return what flies beside the wires, and ends a little later."""
    future: Future[Measured] = Future()
    threading.Timer(0.2, lambda: future.set_result(cast(Measured, object()))).start()
    return future


def fly(
    store: ReproductionStore, others: Future[Measured], starving: int
) -> tuple[Any, tuple[str, ...], Attempts, list[str]]:
    words: list[str] = []
    attempts = Attempts(starving, others)
    show = Show(words.append, lambda part, share: None)
    found, troubles = fly_wires_patiently(Site(), store, show, others, attempts)
    return found, troubles, attempts, words


def test_a_flight_that_is_completed_is_not_repeated(
    store: ReproductionStore, others: Future[Measured]
) -> None:
    found, troubles, attempts, _ = fly(store, others, starving=0)
    assert (found, troubles, attempts.others_done) == (FLOWN, (), [False])


def test_a_flight_that_starved_is_flown_again_once_nothing_else_runs(
    store: ReproductionStore, others: Future[Measured]
) -> None:
    found, troubles, attempts, words = fly(store, others, starving=1)
    assert found is FLOWN and troubles == (STARVED,)
    assert attempts.others_done == [False, True]
    assert any(STARVED in said and "again, alone" in said for said in words)


def test_after_the_last_attempt_there_is_no_flight_but_every_reason(
    store: ReproductionStore, others: Future[Measured]
) -> None:
    found, troubles, attempts, _ = fly(store, others, starving=9)
    assert found is None and troubles == (STARVED,) * ATTEMPTS
    assert len(attempts.others_done) == ATTEMPTS


def test_ctrl_c_is_no_starved_flight(store: ReproductionStore, others: Future[Measured]) -> None:
    def interrupted(*_: object) -> Any:
        raise KeyboardInterrupt

    show = Show(lambda words: None, lambda part, share: None)
    with pytest.raises(KeyboardInterrupt):
        fly_wires_patiently(Site(), store, show, others, interrupted)


def test_a_failure_beside_the_wires_is_told(store: ReproductionStore) -> None:
    others: Future[Measured] = Future()
    others.set_exception(LinkError("the service in mode paper ended with: landed"))
    with pytest.raises(LinkError, match="mode paper"):
        fly(store, others, starving=1)
