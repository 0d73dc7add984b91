"""A picture on the screen is kept as a photo, found again, and taken along, in real Chromium."""

from __future__ import annotations

import asyncio
import time
from collections.abc import AsyncIterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import pytest_asyncio
from filming import number_of, video
from PIL import Image
from playwright.async_api import Browser, Page, expect
from stand_in_tasks import StandInTasks

from housefly.bus.topics import DroneTopics
from housefly.config.drone import DroneConfig
from housefly.config.house_mode import HouseMode
from housefly.config.tasks import TasksConfig
from housefly.evidence.clip_recorder import ClipRecorder
from housefly.evidence.clip_result import ClipOrigin
from housefly.evidence.clip_values import ClipsAnswer, TakeSnapshot
from housefly.messages import DroneStatus, VideoFrame
from housefly.tasks.api.questions import TakePhoto

TOPICS = DroneTopics()

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

SIZES = ((1280, 800), (1024, 768), (768, 1024), (390, 844), (844, 390))


@dataclass
class Darkroom:
    """A console with a picture, and the real recorder behind it."""

    console: Any
    tasks: StandInTasks
    recorder: ClipRecorder
    status: DroneStatus = DroneStatus.FLYING
    mode: HouseMode = HouseMode.HOME

    def answers(self, asked: TakePhoto) -> ClipsAnswer:
        """Keep a photo as the tasks do."""
        origin = ClipOrigin(cause=asked.by)
        name = self.recorder.snapshot(TakeSnapshot(), origin, asked.at or None)
        assert self.recorder.flush()
        return ClipsAnswer((self.recorder.index.info(name),))

    async def films(self) -> None:
        """Send pictures as the drone does."""
        bus = self.console.bus.join()
        frames = list(video(2.0, 0.0))
        for number in range(100_000):
            old = frames[number % len(frames)]
            now = time.monotonic()
            frame = VideoFrame(
                old.data, old.keyframe, old.width, old.height, number, received_at=now
            )
            self.recorder.tick(now, time.time(), self.status, self.mode)
            self.recorder.add(frame, None)
            bus.publish(TOPICS.video, frame)
            await asyncio.sleep(1 / 15)


@pytest_asyncio.fixture(loop_scope="session")
async def darkroom(serving: Any, loopback: str, tmp_path: Path) -> AsyncIterator[Darkroom]:
    recorder = ClipRecorder(tmp_path / "clips", TasksConfig(), DroneConfig())
    async with serving(loopback, clips=recorder.index) as console:
        room = Darkroom(console, StandInTasks(console.bus.join()), recorder)
        room.tasks.keep_evidence(recorder.index)
        room.tasks.answers_with(TakePhoto, room.answers)
        room.tasks.tell()
        filming = asyncio.create_task(room.films())
        yield room
        filming.cancel()
        with suppress(asyncio.CancelledError):
            await filming


@pytest_asyncio.fixture(loop_scope="session")
async def page(darkroom: Darkroom, chromium: Browser) -> AsyncIterator[Page]:
    context = await chromium.new_context(viewport={"width": 1280, "height": 800})
    page = await context.new_page()
    troubles: list[str] = []
    page.on("pageerror", lambda error: troubles.append(str(error)))
    await page.goto(darkroom.console.link)
    await expect(page.locator("canvas[data-picture]")).to_be_visible()
    yield page
    await context.close()
    assert troubles == []


async def test_snap_keeps_the_picture_that_is_shown_and_it_is_shown_and_saved(
    page: Page, darkroom: Darkroom
) -> None:
    shown = await page.evaluate(
        """() => {
          [...document.querySelectorAll("button")].find((b) => b.textContent.includes("Snap"))
            .click();
          return Number(document.querySelector("canvas").dataset.picture);
        }"""
    )
    kept = page.locator(".photo-kept")
    await expect(kept).to_contain_text("Photo kept in Tasks, Clips, until")
    async with page.expect_download() as begun:
        await kept.get_by_role("link", name="Save").click()
    saved = await begun.value
    assert saved.suggested_filename.endswith(".jpg")
    with Image.open(await saved.path()) as picture:
        assert number_of(np.asarray(picture)) == shown % 30
    await kept.get_by_role("link", name="Show").click()
    sheet = page.get_by_role("dialog")
    await expect(sheet).to_contain_text("Taken by")
    await expect(sheet).to_contain_text("Viewer 1")
    await expect(sheet.locator("img")).to_be_visible()


async def test_what_may_not_be_kept_is_not_and_it_says_why(page: Page, darkroom: Darkroom) -> None:
    snap = page.get_by_role("button", name="Snap")
    kept = page.locator(".photo-kept")
    darkroom.mode = HouseMode.PRIVACY
    await asyncio.sleep(0.2)
    await snap.click()
    await expect(kept).to_contain_text("Nothing is recorded in the mode privacy")
    darkroom.mode, darkroom.status = HouseMode.HOME, DroneStatus.LANDED
    await asyncio.sleep(0.2)
    await snap.click()
    await expect(kept).to_contain_text("records only in flight")
    await kept.get_by_role("button", name="Close").click()
    await expect(kept).to_have_count(0)


async def test_in_mode_privacy_the_picture_is_hidden_and_the_page_says_why(
    page: Page, darkroom: Darkroom
) -> None:
    picture, veil = page.locator(".video canvas"), page.locator(".video .veil")
    darkroom.mode = HouseMode.PRIVACY
    await asyncio.sleep(0.2)
    await page.get_by_role("button", name="Snap").click()
    kept = page.locator(".photo-kept")
    await expect(kept).to_contain_text("Nothing is recorded in the mode privacy")
    darkroom.tasks.mode = HouseMode.PRIVACY
    darkroom.tasks.tell()
    await expect(veil).to_have_text("Privacy")
    await expect(kept).to_have_count(0)  # it was said of the mode before
    await expect(picture).to_be_hidden()
    last = await picture.get_attribute("data-picture")
    await asyncio.sleep(0.5)
    assert await picture.get_attribute("data-picture") == last
    darkroom.tasks.mode = HouseMode.HOME
    darkroom.tasks.tell()
    await expect(picture).to_be_visible()
    await expect(picture).not_to_have_attribute("data-picture", last or "")


async def test_without_services_it_says_that_nothing_was_kept(
    serving: Any, loopback: str, chromium: Browser
) -> None:
    async with serving(loopback) as console:
        page = await chromium.new_page()
        await page.goto(console.link)
        await page.get_by_role("button", name="Snap").click()
        await expect(page.locator(".photo-kept")).to_contain_text("No services run here")
        await page.close()


async def test_on_no_screen_it_covers_stop_or_is_wider_than_the_picture(
    page: Page, darkroom: Darkroom, tmp_path: Path
) -> None:
    await page.get_by_role("button", name="Snap").click()
    for width, height in SIZES:
        await page.set_viewport_size({"width": width, "height": height})
        await asyncio.sleep(0.2)
        await page.screenshot(path=tmp_path / f"photo-{width}x{height}.png")
        view = await page.locator(".view.video").bounding_box()
        note = await page.locator(".photo-kept").bounding_box()
        if view is None or note is None:
            continue  # on a phone the picture may be behind the map
        assert note["x"] >= view["x"] - 1, (width, height)
        assert note["x"] + note["width"] <= view["x"] + view["width"] + 1, (width, height)
        assert note["y"] >= view["y"] - 1, (width, height)
