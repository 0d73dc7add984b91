"""The bell on the page: what is told beside it is what the house did, or why nothing was done."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import pytest
from starlette.applications import Starlette
from starlette.testclient import TestClient

from housefly.bus.local import LocalBus
from housefly.bus.simulated_bell import BELL_QUERY, BellPress, press_to_json
from housefly.bus.topics import TASKS_QUERY
from housefly.tasks.api.answers import FiringsAnswer, RuleFiring, RulesAnswer, RuleStatus
from housefly.tasks.api.json import task_answer_to_json, task_question_from_json
from housefly.tasks.api.questions import Webhook
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.rules.rule_engine import ASKS_FIRST
from housefly.web.api import simulated_bell
from housefly.web.api.bell_routes import BellRoutes
from housefly.web.api.simulated_bell import SimulatedBell
from housefly.web.server import create_app

NOW = 1_790_000_000.0
RINGS = BellPress(True, "a visitor rings", NOW)
OLD = RuleStatus("bell", "when bell pressed", True, NOW - 5, "asked for", "bell pressed/doorbell/1")


@dataclass
class House:
    """A simulated room and its tasks on a bus."""

    press: BellPress | None = RINGS
    rules: tuple[RuleStatus, ...] | None = (OLD,)
    asked: list[object] = field(default_factory=list)

    def bell(self) -> SimulatedBell:
        bus = LocalBus()
        if self.press is not None:
            bus.answer(BELL_QUERY, lambda _: press_to_json(self.press))  # type: ignore[arg-type]
        if self.rules is not None:
            bus.answer(TASKS_QUERY, self._answer)
        moment = iter(NOW + 0.5 * k for k in range(100))
        return SimulatedBell(bus, lambda: next(moment))

    def _answer(self, text: str) -> str:
        question = task_question_from_json(text)
        self.asked.append(question)
        if isinstance(question, Webhook):
            firing = RuleFiring("bell-webhook", NOW, "", "visitor", ReasonCode.OK, "asked for")
            return task_answer_to_json(FiringsAnswer((firing,)))
        assert self.rules is not None
        return task_answer_to_json(RulesAnswer(self.rules))


@pytest.fixture(autouse=True)
def _no_waiting(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(simulated_bell, "_REACTION_PERIOD", 0.0)
    monkeypatch.setattr(simulated_bell, "_TWIN_TIMEOUT", 0.05)
    monkeypatch.setattr(simulated_bell, "_TASKS_TIMEOUT", 0.05)


def fired(words: str, cause: str = "bell pressed/doorbell/2", at: float = NOW + 0.2) -> RuleStatus:
    return RuleStatus("bell", "when bell pressed", True, at, words, cause)


@pytest.mark.parametrize("words", ["the house is in mode privacy, not home", "it rests 20 s more"])
def test_what_the_rule_did_or_why_it_did_nothing_is_told(words: str) -> None:
    view = House(rules=(fired(words),)).bell().press()
    assert view.rung and view.words == f"a visitor rings; rule bell: {words}"


@pytest.mark.parametrize(
    "rules",
    [(), (OLD,), (fired("asked for", "person fallen/person-1/2"),)],
    ids=["no rule", "an earlier ring", "something else"],
)
def test_silence_and_what_others_did_is_not_taken_for_an_answer(rules: tuple[Any, ...]) -> None:
    view = House(rules=rules).bell().press()
    assert view.rung and "no rule of the house has done anything" in view.words


def test_a_refusal_of_the_room_is_told_and_the_house_is_not_asked() -> None:
    house = House(press=BellPress(False, "a visitor is about to press the bell", NOW))
    view = house.bell().press()
    assert not view.rung and "about to press" in view.words and house.asked == []


def test_a_room_or_services_that_do_not_answer_are_told() -> None:
    gone = House(press=None).bell().press()
    assert not gone.rung and "simulated room does not answer" in gone.words
    silent = House(rules=None).bell().press()
    assert silent.rung and "the services of the house do not answer" in silent.words


@pytest.mark.parametrize("has_wire", [True, False])
def test_a_clock_that_is_set_back_meanwhile_holds_nobody_up(
    monkeypatch: pytest.MonkeyPatch, has_wire: bool
) -> None:
    slept: list[float] = []
    monkeypatch.setattr(simulated_bell, "_REACTION_TIMEOUT", 0.02)
    monkeypatch.setattr(simulated_bell.time, "sleep", slept.append)
    bus = LocalBus()
    press = BellPress(True, "a visitor rings", NOW, has_wire)
    bus.answer(BELL_QUERY, lambda _: press_to_json(press))
    view = SimulatedBell(bus, lambda: NOW - 86_400.0).press()
    assert view.rung and sum(slept) < 60.0


def test_a_rule_that_asks_somebody_says_so_without_its_name() -> None:
    view = House(rules=(fired(ASKS_FIRST),)).bell().press()
    assert view.words == "a visitor rings; somebody is asked first"


def test_a_bell_without_a_wire_calls_the_webhook() -> None:
    house = House(press=BellPress(True, "a visitor rings", NOW, has_wire=False))
    view = house.bell().press()
    assert view.words == "a visitor rings; rule bell-webhook: asked for"
    assert house.asked == [Webhook("bell", "the simulated doorbell")]


class _Everybody:
    """Sessions that let everybody in."""

    has_session = is_own_page = staticmethod(lambda request: True)


def client(bell: SimulatedBell | None) -> TestClient:
    return TestClient(Starlette(routes=BellRoutes(bell, _Everybody()).routes()))  # type: ignore[arg-type]


def test_a_real_room_has_no_bell_on_its_page() -> None:
    real = client(None)
    assert real.get("/bell").json()["simulated"] is False
    refused = real.post("/bell")
    assert refused.status_code == 404 and "real" in refused.text


def test_the_page_presses_it_and_a_stranger_does_not() -> None:
    page = client(House(rules=(fired("asked for"),)).bell())
    assert page.get("/bell").json()["simulated"] is True
    assert page.post("/bell").json()["rung"] is True
    app = create_app(LocalBus(), "token", lambda: None, bell=House().bell())
    stranger = TestClient(app, base_url="http://127.0.0.1")
    assert stranger.post("/bell").status_code in (401, 403)
    assert stranger.get("/bell").status_code == 401
