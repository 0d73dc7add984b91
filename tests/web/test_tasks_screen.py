"""The console's TASKS screen in real Chromium, with tasks that fly nothing behind it."""

from __future__ import annotations

import asyncio
import re
import time
from collections.abc import AsyncIterator, Callable, Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from axe_audit import axe_findings
from playwright.async_api import Browser, Locator, Page, ViewportSize, expect
from stand_in_tasks import REHEARSAL, StandInTasks

from housefly.bus.local import LocalBus
from housefly.bus.simulated_room import (
    SIMULATION_QUERY,
    SimulatedDeed,
    SimulatedFault,
    SimulatedOutcome,
    act_from_json,
    outcome_to_json,
)
from housefly.bus.topics import HUB_QUERY
from housefly.config.house_mode import HouseMode
from housefly.errors import HouseflyError, TaskError
from housefly.evidence.clip_export import ClipExport
from housefly.evidence.clip_values import ClipInfo
from housefly.hub.api.feed_answers import FeedAnswer, FeedEntry
from housefly.hub.api.json import answer_to_json, question_from_json, refusal_to_json
from housefly.hub.api.questions import FeedQuestion
from housefly.messages.words import Words, figure, literal
from housefly.tasks.api.questions import RehearseTask, ReplyToTask, RequestTask, Sentence
from housefly.tasks.api.values import Confirm, ReasonCode, TaskStage
from housefly.web.access.page_routes import STATIC_FOLDER
from housefly.web.api.simulated_bell import BellView, SimulatedBell
from housefly.web.api.simulated_room import SimulatedRoom

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

DESKTOP: ViewportSize = {"width": 1280, "height": 800}
PHONE: ViewportSize = {"width": 375, "height": 812}
CLIP = "20261122-150102-7"
CHARGE = SimulatedDeed.CHARGE
PRESS_AT_ONCE = """() => new MutationObserver((_, watching) => {
    const all = [...document.querySelectorAll(".question button")];
    const ignore = all.find((one) => one.textContent === "Ignore");
    if (!ignore) return;
    watching.disconnect();
    ignore.click();
    window.pressed = true;
}).observe(document.body, { childList: true, subtree: true })"""
"""Presses "ignore" as soon as it is there, on however slow a machine."""


class OneClip:
    """A book of one snapshot, in memory but for its file."""

    def __init__(self, folder: Path) -> None:
        self.watched_by: list[tuple[str, str]] = []
        self._file = folder / f"{CLIP}.jpg"
        self._file.write_bytes(b"\xff\xd8" + bytes(range(256)) * 40)

    def file(self, name: str) -> Path:
        if name != CLIP:
            raise TaskError(f"there is no clip {name!r}", ReasonCode.BAD_PARAMETER.value)
        return self._file

    def log_access(self, name: str, who: str, what: str = "watched") -> None:
        self.file(name)
        self.watched_by.append((who, what))

    def export(self, names: Sequence[str], who: str) -> ClipExport:
        files = tuple(map(self.file, names))
        self.log_access(names[0], who, "exported")
        return ClipExport(files, b"[]")

    def close(self) -> None:
        pass


class QuietBell(SimulatedBell):
    """A bell that is pressed, and no rule cares."""

    def __init__(self) -> None:
        super().__init__(LocalBus())

    def press(self) -> BellView:
        return BellView(True, True, "a visitor comes to the door and rings; rule bell: it rests")


def room_that_tells() -> LocalBus:
    """Return the bus of a simulated room that does nothing but say what it would do."""

    def answer(text: str) -> str:
        act = act_from_json(text)
        faults = (SimulatedFault("F47", Words("the drone's sonar fails")),)
        failing = int(act.deed is SimulatedDeed.FAULT)
        words = Words("{what}, for {n} s", what=act.fault, n=figure(act.seconds, "g"))
        return outcome_to_json(SimulatedOutcome(act.deed is not CHARGE, words, faults, failing))

    bus = LocalBus()
    bus.answer(SIMULATION_QUERY, answer)
    return bus


@dataclass
class House:
    """Tasks, and the console before them."""

    console: Any
    tasks: StandInTasks
    book: OneClip


@pytest_asyncio.fixture(loop_scope="session")
async def house(serving: Any, loopback: str, tmp_path: Path) -> AsyncIterator[House]:
    book = OneClip(tmp_path)
    simulation = SimulatedRoom(room_that_tells())
    more = {"clips": book, "bell": QuietBell(), "simulation": simulation}
    async with serving(loopback, **more) as console:
        found = House(console, StandInTasks(console.bus.join()), book)
        found.tasks.tell()
        yield found


@pytest_asyncio.fixture(loop_scope="session")
async def page(house: House, chromium: Browser) -> AsyncIterator[Page]:
    """Yield the TASKS screen; fails on any error of the page and any request to another host."""
    context = await chromium.new_context(viewport=DESKTOP)
    page = await context.new_page()
    troubles: list[str] = []
    own = (house.console.origin + "/", house.console.origin.replace("http", "ws") + "/", "data:")
    page.on("pageerror", lambda error: troubles.append(str(error)))
    page.on(
        "request",
        lambda request: troubles.append(request.url) if not request.url.startswith(own) else None,
    )
    await page.goto(house.console.link + "#tasks")
    await expect(page.get_by_role("region", name="Services").get_by_role("listitem")).to_have_count(
        4
    )
    await page.get_by_role("tab", name="History").click()
    yield page
    await context.close()
    assert troubles == []


async def hold(page: Page, button: Locator, seconds: float = 0.9) -> None:
    await expect(button).to_be_enabled()
    box = await button.bounding_box()
    assert box is not None
    await page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    await page.mouse.down()
    await asyncio.sleep(seconds)
    await page.mouse.up()


def card(page: Page) -> Locator:
    return page.get_by_role("article")


def replies(house: House) -> list[str]:
    return [one.choice for one in house.tasks.asked if isinstance(one, ReplyToTask)]


def stage_of(house: House) -> TaskStage:
    return house.tasks.tasks[1].state


async def test_a_bell_is_a_card_on_every_screen_and_only_a_hold_flies(
    page: Page, house: House, until: Callable[..., Any]
) -> None:
    house.tasks.ring(seconds=90)
    for screen in ("Live", "Tasks"):
        await page.get_by_role("navigation").get_by_role("button", name=screen).click()
        await expect(card(page)).to_contain_text("The bell rings. See who is at the door?")
        await expect(card(page)).not_to_contain_text("rule bell")
        await expect(card(page)).to_contain_text(re.compile(r"counts as “ignore” in 1:\d\d"))
    look = card(page).get_by_role("button", name="Look")
    await look.click()
    await hold(page, look, 0.2)
    assert replies(house) == []
    await hold(page, look)
    await until(lambda: replies(house) == ["look"])
    await expect(card(page)).to_have_count(0)
    task = house.tasks.tasks[1]
    assert (task.state, task.words) == (TaskStage.QUEUED, "Viewer 1 said look")


async def test_a_bell_is_ignored_by_one_press_but_not_by_one_meant_for_what_was_there(
    page: Page, house: House, until: Callable[..., Any]
) -> None:
    await page.get_by_role("navigation").get_by_role("button", name="Live").click()
    await page.evaluate(PRESS_AT_ONCE)
    house.tasks.ring()
    ignore = card(page).get_by_role("button", name="Ignore")
    await expect(ignore).to_be_visible()
    await page.wait_for_function("window.pressed === true")
    await asyncio.sleep(0.8)
    assert replies(house) == []
    await ignore.click()
    await until(lambda: replies(house) == ["ignore"])
    await page.get_by_role("navigation").get_by_role("button", name="Tasks").click()
    await page.get_by_text("See who is at the door").last.click()
    await expect(page.get_by_role("listitem").filter(has_text="Trigger")).to_contain_text(
        "Viewer 1 said ignore"
    )


async def test_the_keyboard_answers_too_and_space_is_still_stop(
    page: Page, house: House, until: Callable[..., Any]
) -> None:
    house.tasks.ring()
    look = card(page).get_by_role("button", name="Look")
    await look.focus()
    await page.keyboard.down("Enter")
    await asyncio.sleep(0.9)
    await page.keyboard.up("Enter")
    await until(lambda: replies(house) == ["look"])
    await page.keyboard.press("Space")
    await expect(page.locator(".stop")).to_contain_text("STOPPED")
    assert not [order for order in house.console.pilot.orders if order.kind.value == "go"]


async def test_a_sentence_is_answered_and_what_flies_waits_for_a_yes(
    page: Page, house: House, until: Callable[..., Any]
) -> None:
    field = page.get_by_role("searchbox", name="Ask for something")
    answer = page.get_by_role("region", name="Ask").get_by_role("status")
    await field.fill("where is the cup")
    await page.keyboard.press("Enter")
    await expect(answer).to_contain_text("The cup is in the cabinet")
    await expect(answer).to_contain_text("“where is the cup”, answered now")
    await field.fill("fly me to the moon")
    await page.get_by_role("button", name="Ask", exact=True).click()
    await expect(answer).to_contain_text("I do not understand that.")
    await answer.get_by_role("button", name="look at the entrance").click()
    await expect(card(page)).to_contain_text("keeps 0.42 m away from everything")
    said = [one for one in house.tasks.asked if isinstance(one, Sentence)][-1]
    assert (said.text, said.by, said.language) == ("look at the entrance", "Viewer 1", "en")
    assert stage_of(house) is TaskStage.WAITING
    await expect(answer).to_contain_text("I go and look.")
    await hold(page, card(page).get_by_role("button", name="Yes"))
    await until(lambda: stage_of(house) is TaskStage.QUEUED)
    await expect(answer).to_have_count(0)  # somebody has said yes


async def test_an_answer_over_the_map_is_put_away_after_a_minute(page: Page, house: House) -> None:
    await page.get_by_role("button", name="Live").first.click()
    await page.get_by_role("combobox", name="Where is").fill("where is the cup")
    await page.keyboard.press("Enter")
    answer = page.locator(".answer")
    await expect(answer).to_contain_text("“where is the cup”, answered now")
    house.tasks.clock_ahead, house.tasks.notices = 70.0, ("somebody is at the door",)
    house.tasks.tell()
    await expect(answer).to_have_count(0)


async def test_a_service_asks_for_what_it_needs_and_is_rehearsed_before_the_yes(
    page: Page, house: House, until: Callable[..., Any]
) -> None:
    services = page.get_by_role("region", name="Services")
    await services.get_by_role("button", name="See who is at the door").click()
    await expect(services).to_contain_text("It flies 7.2 m in 41 s")
    await services.get_by_role("button", name="Look at a place or a thing").first.click()
    start = services.get_by_role("button", name="Start")
    await expect(services).to_contain_text("Say first: what to look at.")
    await expect(start).to_be_disabled()
    what = services.get_by_label("what to look at")
    await what.fill("the moon")
    await what.press("Enter")
    await expect(services).to_contain_text("There is no place 'the moon'.")
    await what.fill("refrigerator")
    await services.get_by_label("how long to look [s]").fill("8")
    await services.get_by_role("button", name="Rehearse").click()
    await expect(services).to_contain_text("It flies 7.2 m in 41 s")
    rehearsed = [one for one in house.tasks.asked if isinstance(one, RehearseTask)][-1]
    assert rehearsed.parameters == {"what": "refrigerator", "dwell": 8.0}
    await hold(page, start)
    await until(lambda: 1 in house.tasks.tasks)
    assert house.tasks.tasks[1].parameters == rehearsed.parameters
    await expect(page.get_by_role("listitem", name="Task 1")).to_contain_text("Refrigerator")


async def test_a_task_is_followed_paused_continued_and_ended(
    page: Page, house: House, until: Callable[..., Any]
) -> None:
    house.tasks._request(RequestTask("patrol", {}, "Anna"))
    house.tasks.advance(1, 2, records=True)
    task = page.get_by_role("listitem", name="Task 1")
    await expect(task).to_contain_text("asked for by Anna")
    await expect(task.locator("[aria-current=step]")).to_contain_text("Look at the visitor")
    for screen in ("Live", "Tasks"):
        await page.get_by_role("navigation").get_by_role("button", name=screen).click()
        await expect(page.get_by_role("banner")).to_contain_text("● recording")
        await expect(page.get_by_role("banner")).to_contain_text("Mode of the house: home")
    await task.get_by_role("button", name="Pause").click()
    await expect(task).to_contain_text("paused")
    await task.get_by_role("button", name="Go on").click()
    await expect(task).to_contain_text("running")
    await task.get_by_role("button", name="Cancel").click()
    await until(lambda: house.tasks.tasks[1].state is TaskStage.CANCELLED)
    await expect(task).to_have_count(0)
    house.tasks.records = False
    house.tasks.tell()
    await expect(page.get_by_role("banner")).not_to_contain_text("recording")


async def test_history_leads_from_the_trigger_to_the_clip_and_who_watched_is_known(
    page: Page, house: House, until: Callable[..., Any]
) -> None:
    begun = time.time() - 60
    house.tasks.keep_clip(
        ClipInfo(
            CLIP, "snapshot", 1, "visitor", "entrance", "", ("guest",), "bell", begun, 0.0, 10242
        )
    )
    task = house.tasks.ring()
    house.tasks.advance(task.id, 4)
    house.tasks.finish(task.id, "the visitor was seen", (CLIP,))
    await page.get_by_role("tabpanel").get_by_text("See who is at the door").click()
    chain = page.get_by_role("tabpanel")
    for words in (
        "Asked for by rule bell, because of bell pressed (doorbell).",
        REHEARSAL.words,
        "✓",
        "The visitor was seen.",
        "The visitor was in view for 9 s.",
    ):
        await expect(chain).to_contain_text(words)
    await chain.get_by_role("button", name="Show snapshot").click()
    sheet = page.get_by_role("dialog", name="Clip: guest, entrance")
    await expect(sheet).to_contain_text("until somebody deletes it")
    await until(lambda: ("Viewer 1", "watched") in house.book.watched_by)
    assert page.url.endswith(f"#clip/{CLIP}")
    await page.keyboard.press("?")
    await expect(page.get_by_role("dialog")).to_have_count(2)
    await page.go_back()  # what was opened last, one after another
    await expect(page.get_by_role("dialog")).to_have_count(1)
    await page.go_back()
    await expect(page.get_by_role("dialog")).to_have_count(0)
    assert page.url.endswith("#tasks")
    await chain.get_by_role("button", name="Show snapshot").click()
    await page.reload()
    await expect(page.get_by_role("dialog", name="Clip: guest, entrance")).to_be_visible()
    await page.get_by_role("dialog").get_by_role("button", name="Close").click()
    await page.get_by_role("tab", name="Clips").click()
    await page.get_by_role("tabpanel").get_by_label("person").fill("guest")
    await page.keyboard.press("Enter")
    await expect(page.get_by_role("tabpanel").get_by_role("listitem")).to_have_count(1)
    await page.get_by_role("navigation").get_by_role("button", name="Live").click()
    await page.locator(".on-picture").get_by_role("link", name="Clip").click()
    await expect(page.get_by_role("dialog", name="Clip: guest, entrance")).to_be_visible()


def happened(question: FeedQuestion) -> FeedAnswer:
    """Return what a resident and the drone did."""
    now = time.time()
    entries = (
        FeedEntry(
            *("people", "person-1", literal("the resident")),
            Words("{first}, then {next}", first="kitchen", next="sofa"),
            *(now - 100.0, now - 60.0),
        ),
        FeedEntry(
            *("tasks", "", literal("See who is at the door"), literal("the visitor was seen")),
            *(now - 190.0, now - 130.0, (CLIP,)),
        ),
    )
    of = [one for one in entries if question.of in ("all", one.of)]
    return FeedAnswer(tuple(of[: question.limit]))


async def test_what_happened_lately_is_told_by_person_and_task_with_pictures(
    page: Page, house: House
) -> None:
    house.book.file(CLIP).write_bytes((STATIC_FOLDER / "icon-192.png").read_bytes())

    def answer(text: str) -> str:
        question = question_from_json(text)
        if not isinstance(question, FeedQuestion):
            return refusal_to_json(HouseflyError("not here"))
        return answer_to_json(happened(question))

    with closing(house.console.bus.answer(HUB_QUERY, answer)):
        await page.get_by_role("tab", name="Lately").click()
        feed = page.get_by_role("region", name="Lately")
        lines = feed.get_by_role("listitem")
        await expect(lines).to_have_count(2)
        await expect(lines.first).to_contain_text("The resident")
        await expect(lines.first).to_contain_text("kitchen, then sofa")
        await expect(lines.first.get_by_role("time")).to_have_text(re.compile(r"^[56]\d s ago$"))
        assert await axe_findings(page, ((390, 844), (1440, 900))) == []
        await feed.get_by_role("button", name="Tasks").click()
        await expect(lines).to_have_count(1)
        await expect(lines).to_contain_text("the visitor was seen")
        await feed.get_by_role("link", name="Clip").click()
        await expect(page.get_by_role("dialog", name="Clip")).to_be_visible()
        await page.get_by_role("dialog").get_by_role("button", name="Close").click()
        await lines.get_by_role("button").click()
        await expect(page.get_by_text("Back to now")).to_be_visible()


async def test_a_rule_is_a_sentence_that_is_switched_and_set_and_taken_back(
    page: Page, house: House, until: Callable[..., Any]
) -> None:
    await page.get_by_role("tab", name="Rules").click()
    rule = page.get_by_role("listitem", name="When the bell rings")
    await expect(rule).to_contain_text(
        "When the bell rings ask me, then look at a place or a thing"
    )
    await expect(rule).to_contain_text("today: 00:00")
    await rule.get_by_role("switch").click()
    await until(lambda: not house.tasks.rule.enabled)
    await rule.locator("summary").click()
    await rule.get_by_role("combobox", name="When the bell rings").select_option("at once")
    await until(lambda: house.tasks.rule.confirm is Confirm.AUTO)
    await rule.get_by_role("button", name="night").click()
    await until(lambda: house.tasks.rule.modes[-1] is HouseMode.NIGHT)
    what = rule.get_by_label("what to look at")
    await expect(what).to_have_value("entrance")
    await what.fill("the moon")
    await what.press("Enter")
    await expect(rule).to_contain_text("△ What: there is no 'the moon'.")
    await expect(what).to_have_value("entrance")
    await what.fill("sofa")
    await what.press("Enter")
    await until(lambda: house.tasks.rule.parameters[0].default == "sofa")
    assert house.tasks.rule.changed_by == "Viewer 1"
    await rule.get_by_role("button", name="As written").click()
    await expect(what).to_have_value("entrance")
    await expect(rule.get_by_role("switch")).to_be_checked()


async def test_a_clip_comes_in_parts_and_only_to_who_is_in(house: House, page: Page) -> None:
    path = f"/api/v1/clips/{CLIP}"
    proof = await page.evaluate("localStorage.getItem('housefly proof')")
    proved = {"x-housefly-proof": proof}
    whole = await page.request.head(house.console.origin + path, headers=proved)
    assert (whole.status, whole.headers["content-type"]) == (200, "image/jpeg")
    assert whole.headers["accept-ranges"] == "bytes"
    assert whole.headers["cache-control"] == "no-store"
    part = await page.request.get(
        f"{house.console.origin}{path}?proof={proof}", headers={"Range": "bytes=2-5"}
    )
    assert (part.status, await part.body()) == (206, bytes(range(4)))
    assert house.book.watched_by == [("Viewer 1", "watched")], "whatever part"
    saved = await page.request.get(f"{house.console.origin}{path}?proof={proof}&download=1")
    assert saved.headers["content-disposition"] == f'attachment; filename="{CLIP}.jpg"'
    assert house.book.watched_by[1:] == [("Viewer 1", "exported")]
    for wrong in ("none", "..%2Fusers.json"):
        answer = await page.request.get(
            f"{house.console.origin}/api/v1/clips/{wrong}", headers=proved
        )
        assert answer.status == 404
    assert (await page.request.get(house.console.origin + path)).status == 401, "no proof"


async def test_who_said_yes_hears_on_every_screen_why_nothing_flies(
    page: Page, house: House
) -> None:
    await page.get_by_role("navigation").get_by_role("button", name="Live").click()
    task = house.tasks.ring()
    await expect(card(page)).to_be_visible()
    house.tasks.refuse(task.id, "no free way leads to the entrance")
    told = page.get_by_role("alert").filter(has_text="No free way leads to the entrance.")
    await expect(told).to_contain_text("ask again when it is free")
    await expect(told).to_contain_text("See who is at the door:")
    await expect(card(page)).to_have_count(0)
    await told.get_by_role("button", name="Try again").click()
    await expect(told).to_have_count(0)
    again = [one for one in house.tasks.asked if isinstance(one, RequestTask)][-1]
    assert (again.service, again.parameters) == (task.service, task.parameters)
    assert again.confirm is Confirm.ASK, "nothing flies again without a yes"
    again_refused = max(house.tasks.tasks)
    house.tasks.refuse(again_refused, "no free way leads to the entrance")
    await told.get_by_role("button", name="Close").click()
    await expect(told).to_have_count(0)


async def test_the_mode_is_set_and_shown(page: Page, house: House) -> None:
    modes = page.get_by_role("group", name="Mode")
    await modes.get_by_role("button", name="privacy").click()
    await expect(page.get_by_role("banner")).to_contain_text("privacy")
    await expect(modes.get_by_role("button", name="privacy")).to_have_attribute(
        "aria-pressed", "true"
    )
    assert house.tasks.mode is HouseMode.PRIVACY


async def test_nothing_is_shown_as_now_when_nobody_keeps_the_board(
    page: Page, house: House, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("housefly.web.status.task_feed.SILENCE", 1.5)
    house.tasks.ring()
    house.tasks.records = True
    house.tasks.tell()
    await expect(page.get_by_role("banner")).to_contain_text("● recording")
    house.tasks.close()
    silence = page.get_by_role("alert").filter(has_text="The services are not running")
    await expect(silence).to_contain_text("what was known", timeout=10_000)
    await expect(page.get_by_role("banner")).to_contain_text("services not running")
    await expect(page.get_by_role("banner")).not_to_contain_text("recording")
    await expect(card(page)).to_have_count(0)
    await expect(page.get_by_role("listitem", name="Task 1")).to_have_css("opacity", "1")
    await expect(page.locator(".now [data-old=true]")).to_have_css("opacity", "0.5")


async def test_on_a_phone_nothing_is_wider_than_the_screen_and_stop_is_free(
    page: Page, house: House
) -> None:
    house.tasks.ring()
    house.tasks._request(RequestTask("look", {"what": "the small refrigerator"}, "Anna"))
    house.tasks.advance(2, 1, records=True)
    await page.set_viewport_size(PHONE)
    for screen in ("Tasks", "Live"):
        await page.get_by_role("navigation").get_by_role("button", name=screen).click()
        await expect(card(page)).to_be_visible()
        assert await page.evaluate("document.documentElement.scrollWidth") <= PHONE["width"]
        stop = await page.locator(".stop").bounding_box()
        question = await card(page).bounding_box()
        assert stop is not None and question is not None
        assert question["y"] + question["height"] <= stop["y"], screen
        small = await page.evaluate(
            """() => [...document.querySelectorAll('.question button, .tasks-deck button')]
                .filter((one) => one.getBoundingClientRect().height < 43.5)
                .map((one) => one.textContent)"""
        )
        assert small == []


async def test_ideas_bell_and_yes_can_be_reached_above_stop_on_every_phone(
    page: Page, house: House
) -> None:
    stop = page.locator(".stop")
    idea = page.get_by_role("region", name="Ask").get_by_role("button", name="Who is at the door?")
    strip = page.get_by_role("region", name="Simulated room")
    bell = strip.get_by_role("button", name="Ring the doorbell")
    house.tasks.ring(seconds=90)
    yes = card(page).get_by_role("button").first
    for width, height in ((360, 740), (390, 844), (844, 390)):
        await page.set_viewport_size({"width": width, "height": height})
        await page.locator(".tasks-deck").evaluate("deck => (deck.scrollTop = 0)")
        for k, button in enumerate((idea, yes, bell)):
            if k > 0 or height < width:
                await button.scroll_into_view_if_needed()
            box, bar = await button.bounding_box(), await stop.bounding_box()
            assert box is not None and bar is not None
            assert box["y"] > 0 and box["x"] >= 0 and box["x"] + box["width"] <= width
            above = box["y"] + box["height"] <= bar["y"]
            assert above or box["x"] + box["width"] <= bar["x"], (width, height, k)
            assert bar["y"] + bar["height"] <= height
    await bell.click()
    await expect(strip.get_by_role("status")).to_contain_text("it rests.")
    await strip.get_by_label("For how long").select_option("30")
    await strip.get_by_role("button", name="Make it fail").click()
    await expect(strip.get_by_role("status")).to_have_text("F47, for 30 s.")
    await expect(strip.get_by_role("button", name="End the faults")).to_be_visible()
    await strip.get_by_role("button", name="Charge it").click()
    await expect(strip.get_by_role("status")).to_contain_text("△")


async def test_everything_that_can_be_used_has_a_name(page: Page, house: House) -> None:
    house.tasks.ring()
    await page.get_by_role("button", name="Look at a place or a thing").first.click()
    for tab in ("Lately", "Clips", "Rules", "History"):
        await page.get_by_role("tab", name=tab).click()
        nameless = await page.evaluate(
            """() => [...document.querySelectorAll('button, input, select, a, video, section')]
                .filter((one) => !(one.getAttribute('aria-label') || one.textContent.trim()
                    || one.labels?.length))
                .map((one) => one.outerHTML)"""
        )
        assert nameless == []
        repeated = await page.evaluate(
            """() => { const ids = [...document.querySelectorAll('[id]')].map((one) => one.id);
                return ids.filter((id, k) => ids.indexOf(id) !== k); }"""
        )
        assert repeated == []
