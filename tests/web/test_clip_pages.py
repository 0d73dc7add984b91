"""Clips and history in real Chromium, with the real index and files behind the page."""

from __future__ import annotations

import asyncio
import io
import json
import time
import zipfile
from collections.abc import AsyncIterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from clip_rows import added, clip
from filming import video
from playwright.async_api import Browser, Page, ViewportSize, expect
from stand_in_tasks import StandInTasks

from housefly.config.tasks import TasksConfig
from housefly.evidence.clip_index import ClipIndex
from housefly.evidence.clip_writer import ClipWriter

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

DESKTOP: ViewportSize = {"width": 1280, "height": 800}
PHONE: ViewportSize = {"width": 375, "height": 812}
_HEARS = """window.notes = [];
const start = OscillatorNode.prototype.start;
OscillatorNode.prototype.start = function (when) {
  window.notes.push(this.frequency.value);
  return start.call(this, when);
};"""


@dataclass
class Cinema:
    """A console, the tasks behind it and the clips of the house."""

    console: Any
    tasks: StandInTasks
    index: ClipIndex
    folder: Path

    def filmed(self, seconds: float = 3.0, ago: float = 60.0, **known: object) -> str:
        """Keep a clip that plays."""
        row = clip(time.time() - ago, **known)
        writer = ClipWriter(self.folder / row.file_name)
        for frame in video(seconds):
            writer.add(frame)
        written = writer.finish()
        assert written is not None
        self.index.finish(replace(row, size=written.size, duration=written.duration))
        return row.id

    def flown(self, clips: tuple[str, ...] = (), flown: float = 30.0) -> int:
        """Let a task end."""
        task = self.tasks.ring()
        self.tasks.advance(task.id, 4)
        self.tasks.finish(task.id, "the visitor was seen", clips, flown)
        return task.id


@pytest_asyncio.fixture(loop_scope="session")
async def cinema(serving: Any, loopback: str, tmp_path: Path) -> AsyncIterator[Cinema]:
    index = ClipIndex(tmp_path / "clips", TasksConfig())
    async with serving(loopback, clips=index) as console:
        found = Cinema(console, StandInTasks(console.bus.join()), index, tmp_path / "clips")
        found.tasks.keep_evidence(index)
        found.tasks.tell()
        yield found


@pytest_asyncio.fixture(loop_scope="session")
async def page(cinema: Cinema, chromium: Browser) -> AsyncIterator[Page]:
    context = await chromium.new_context(viewport=DESKTOP)
    page = await context.new_page()
    troubles: list[str] = []
    page.on("pageerror", lambda error: troubles.append(str(error)))
    await page.add_init_script(_HEARS)
    await page.goto(cinema.console.link + "#tasks")
    await page.get_by_role("tab", name="History").click()
    yield page
    await context.close()
    assert troubles == []


async def test_a_clip_is_played_saved_kept_and_deleted_and_who_did_it_is_known(
    page: Page, cinema: Cinema
) -> None:
    name = cinema.filmed(place="entrance", people=("anna",), cut_off=True)
    await page.get_by_role("tab", name="Clips").click()
    await page.get_by_role("button", name="anna, entrance").click()
    sheet = page.get_by_role("dialog", name="Clip: anna, entrance")
    await expect(sheet).to_contain_text("a crash or a full disk cut it off")
    await until(page, "document.querySelector('.sheet video')?.currentTime > 0.3")
    await sheet.get_by_role("button", name="Keep", exact=True).click()
    await expect(sheet).to_contain_text("until somebody deletes it")
    async with page.expect_download() as begun:
        await sheet.get_by_role("link", name="Save").click()
    assert (await begun.value).suggested_filename == f"{name}.mp4"
    box = await sheet.get_by_role("button", name="Delete").bounding_box()
    assert box is not None and box["y"] + box["height"] <= 700, "seen without scrolling"
    await page.mouse.move(box["x"] + 10, box["y"] + 10)
    await page.mouse.down()
    await expect(sheet).to_have_count(0)
    await page.mouse.up()
    assert not (cinema.folder / f"{name}.mp4").exists()
    await expect(page.get_by_role("tabpanel")).to_contain_text("There is no such clip")
    did = [view.what for view in cinema.index.audit_log(name)]
    assert did.pop(0) == "seen small", "in the list"
    assert did[0] == "watched" and did[-1] == "deleted"
    assert sorted(did[1:-1]) == ["exported", "kept"]


async def test_a_picture_in_a_list_plays_while_it_is_pointed_at_and_is_no_watching(
    page: Page, cinema: Cinema
) -> None:
    name = cinema.filmed(place="entrance")
    await page.get_by_role("tab", name="Clips").click()
    picture = page.get_by_role("tabpanel").get_by_role("listitem").get_by_role("button")
    time_of = "document.querySelector('.clips video')?.currentTime"
    await until(page, "document.querySelector('.clips video')?.readyState > 0")
    assert await page.evaluate(time_of) == 0.0
    await picture.hover()
    await until(page, f"{time_of} > 0.1")
    await page.get_by_role("tab", name="Clips").hover()
    await until(page, f"{time_of} === 0")
    await page.emulate_media(reduced_motion="reduce")
    await picture.hover()
    await asyncio.sleep(0.4)
    assert await page.evaluate(time_of) == 0.0
    assert [(one.who, one.what) for one in cinema.index.audit_log(name)] == [
        ("Viewer 1", "seen small")
    ]


async def test_clips_are_found_by_person_place_thing_and_time_and_page_by_page(
    page: Page, cinema: Cinema
) -> None:
    day = 86400.0
    for n in range(120):
        person = "anna" if n % 2 else "ben"
        known = {"thing": "cup"} if n == 7 else {}
        at = time.time() - 60.0 - n * 0.5 * day
        added(cinema.index, cinema.folder, clip(at, people=(person,), place=f"place {n}", **known))
    await page.get_by_role("tab", name="Clips").click()
    panel = page.get_by_role("tabpanel")
    await expect(panel.get_by_role("listitem")).to_have_count(50)
    for count in (100, 120):
        await panel.get_by_role("button", name="Older clips").click()
        await expect(panel.get_by_role("listitem")).to_have_count(count)
    await expect(panel.get_by_role("button", name="Older clips")).to_have_count(0)
    for label, value, count in (("person", "anna", 50), ("thing", "cup", 1), ("place", "x", 0)):
        await panel.get_by_label(label).fill(value)
        await expect(panel.get_by_role("listitem")).to_have_count(count)
        if label != "person":
            await panel.get_by_label(label).fill("")
    await panel.get_by_label("time").select_option("this week")
    await expect(panel.get_by_role("listitem")).to_have_count(7)


async def test_all_clips_of_an_event_are_taken_away_at_once(page: Page, cinema: Cinema) -> None:
    task = cinema.flown()
    names = {cinema.filmed(task=task), cinema.filmed(ago=50.0, task=task)}
    cinema.filmed(ago=40.0, task=task + 1)
    await page.reload()
    await page.get_by_role("tab", name="History").click()
    await page.get_by_role("tabpanel").get_by_text("See who is at the door").click()
    await expect(page.get_by_role("button", name="Show clip")).to_have_count(2)
    async with page.expect_download() as begun:
        await page.get_by_role("button", name="Save all").click()
    saved = Path(await (await begun.value).path()).read_bytes()
    with zipfile.ZipFile(io.BytesIO(saved)) as archive:
        known = json.loads(archive.read("clips.json"))
    assert {one["id"] for one in known} == names
    for name in names:
        assert [(view.who, view.what) for view in cinema.index.audit_log(name)] == [
            ("Viewer 1", "exported")
        ]


async def test_history_says_what_flew_and_what_did_not_and_goes_back_to_the_first(
    page: Page, cinema: Cinema
) -> None:
    for n in range(130):
        cinema.flown(flown=72.0 if n == 129 else 0.0)
    panel = page.get_by_role("tabpanel")
    await expect(panel.get_by_role("listitem")).to_have_count(20)
    for count in (50, 100, 130):
        await panel.get_by_role("button", name="Older tasks").click()
        await expect(panel.get_by_role("listitem")).to_have_count(count)
    await expect(panel.get_by_role("button", name="Older tasks")).to_have_count(0)
    await expect(panel).to_contain_text("That is all.")
    newest, before = (panel.get_by_role("group").nth(place) for place in (0, 1))
    await newest.locator("summary").click()
    await expect(newest).to_contain_text("in the air for")
    await expect(newest).to_contain_text("housefly replay /home/kim/flight 1")
    await before.locator("summary").click()
    await expect(before).to_contain_text("It did not fly.")
    await expect(before).not_to_contain_text("replay")


async def test_what_people_should_know_of_the_clips_is_said(page: Page, cinema: Cinema) -> None:
    cinema.tasks.notices = ("clips take 3 GB, more than tasks.clip_space_gb = 2",)
    cinema.tasks.tell()
    memory = page.get_by_role("region", name="What was")
    await expect(memory).to_contain_text("△ Clips take 3 GB, more than tasks.clip_space_gb = 2.")
    cinema.tasks.notices = ()
    cinema.tasks.tell()
    await expect(memory).not_to_contain_text("3 GB")


async def test_where_the_picture_is_shown_a_soft_tone_says_that_recording_begins_and_ends(
    page: Page, cinema: Cinema
) -> None:
    await page.goto(cinema.console.link + "#fly")
    await page.get_by_role("region", name="Picture from the drone").click()
    for records, notes in ((True, [660, 880]), (False, [660, 880, 880, 660])):
        cinema.tasks.records = records
        cinema.tasks.tell()
        await until(page, f"window.notes.length === {len(notes)}")
        assert await page.evaluate("window.notes") == notes


@pytest.mark.parametrize("viewport", [DESKTOP, PHONE])
async def test_history_and_clips_are_no_wider_than_the_screen(
    page: Page, cinema: Cinema, viewport: ViewportSize, tmp_path: Path
) -> None:
    await page.set_viewport_size(viewport)
    task = cinema.flown()
    cinema.filmed(task=task, place="entrance", people=("anna", "a visitor with a long name"))
    cinema.tasks.notices = ("the clock went on by 40 days at once: no clip is deleted",)
    cinema.tasks.tell()
    await page.get_by_role("tabpanel").get_by_text("See who is at the door").click()
    await expect(page.get_by_role("button", name="Show clip")).to_be_visible()
    await look(page, tmp_path, f"history-{viewport['width']}")
    await page.get_by_role("tab", name="Clips").click()
    await expect(page.get_by_role("tabpanel").get_by_role("listitem")).to_have_count(1)
    await look(page, tmp_path, f"clips-{viewport['width']}")
    await page.get_by_role("tabpanel").get_by_role("listitem").get_by_role("button").click()
    await until(page, "document.querySelector('.sheet video')?.currentTime > 0.3")
    await look(page, tmp_path, f"clip-{viewport['width']}")


async def until(page: Page, holds: str) -> None:
    """Wait until an expression holds in the page, whose policy lets Playwright not wait itself."""
    end = time.monotonic() + 20.0
    while not await page.evaluate(holds):
        assert time.monotonic() < end, holds
        await asyncio.sleep(0.05)


async def look(page: Page, folder: Path, name: str) -> None:
    """Fail when something is wider than the screen; leave a picture for people."""
    await asyncio.sleep(0.1)
    await page.screenshot(path=folder / f"{name}.png", full_page=True)
    wide = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
    assert await page.evaluate(wide) <= 0, name
