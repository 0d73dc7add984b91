"""A real Home Assistant finds everything, presses everything, and runs the page's doorbell story.

Its program is ``HASS``, or that of ``make interop`` (2024.3.3, in an environment of its own).
"""

from __future__ import annotations

import asyncio
import json
import os
import re
import signal
import socket
import subprocess
import time
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import replace
from datetime import datetime
from io import BytesIO
from pathlib import Path
from typing import Any
from urllib.error import URLError
from urllib.parse import urlencode
from urllib.request import Request, urlopen

import numpy as np
import pytest
from fake_pilot import FakePilot
from fake_room import example_room
from filming import RATE_HZ, SIZE, striped
from mqtt_broker import Broker, running_broker, until
from PIL import Image

from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import new_runtime
from housefly.bus.bus import Bus
from housefly.bus.stop import StopListener
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import Site, site_from_tree
from housefly.evidence.frame_blanker import BLANK
from housefly.hub.situations.kinds import SituationKind
from housefly.messages import DroneStatus, OrderKind, Phase, VideoFrame
from housefly.room.files import load_room
from housefly.room.model import Place
from housefly.twin.camera.encoder import Encoder

ROOT = Path(__file__).resolve().parents[2]
HASS = Path(os.environ.get("HASS", ROOT / ".venv" / "homeassistant" / "bin" / "hass"))
PARTS = ("room", "hub", "tasks", "homeassistant")
DISCOVERY = os.environ.get("HASS_DISCOVERY", "entity")
"""How it discovers; newer ones take "device", too."""
PICTURE = os.environ.get("HASS_PICTURE", "")
"""Where a picture of its overview is kept, as PNG."""
DEVICES = {
    "door/entrance-door": b'{"open": true, "battery": 0.93}',
    "doorbell/doorbell": b"{}",
    "power/stove": b'{"power": 1420.0}',
}
WINDOW = {
    "id": "kitchen-window",
    "kind": "contact",
    "state_topic": "statestream/input_boolean/kitchen_window/state",
    "heartbeat": 86400.0,
}
"""A contact of Home Assistant's own, as a device of the room."""
NAME, PASSWORD = "house", "a long password"

pytestmark = [
    pytest.mark.interop,
    pytest.mark.wire,
    pytest.mark.realtime,
    pytest.mark.slow,
    pytest.mark.timeout(600),
]


class HomeAssistant:
    """A running Home Assistant, asked over its HTTP API."""

    def __init__(self, port: int) -> None:
        self.address, self._token = f"http://127.0.0.1:{port}", ""
        self._client = f"{self.address}/"

    def ask(self, path: str, body: Any = None, *, form: bool = False) -> Any:
        data = None
        if body is not None:
            data = (urlencode(body) if form else json.dumps(body)).encode()
        kind = "application/x-www-form-urlencoded" if form else "application/json"
        headers = {"Content-Type": kind}
        if self._token:
            headers["Authorization"] = f"Bearer {self._token}"
        with urlopen(Request(self.address + path, data, headers), timeout=30.0) as answer:
            return json.loads(answer.read() or b"null")

    def is_up(self) -> bool:
        try:
            return bool(self.ask("/api/onboarding"))
        except (URLError, OSError):
            return False

    def log_in(self) -> dict[str, Any]:
        """Take it into use as its first owner does; returns the tokens."""
        owner = {"name": "Kim", "username": "kim", "password": PASSWORD, "language": "en"}
        code = self.ask("/api/onboarding/users", {"client_id": self._client, **owner})
        tokens: dict[str, Any] = self.ask(
            "/auth/token",
            {
                "client_id": self._client,
                "grant_type": "authorization_code",
                "code": code["auth_code"],
            },
            form=True,
        )
        self._token = tokens["access_token"]
        return tokens

    def states(self) -> dict[str, dict[str, Any]]:
        return {one["entity_id"]: one for one in self.ask("/api/states")}

    def state(self, entity: str) -> str:
        try:
            return str(self.ask(f"/api/states/{entity}")["state"])
        except URLError:
            return ""

    def picture(self, entity: str) -> bytes:
        """Return the picture of a camera, b"" while there is none."""
        headers = {"Authorization": f"Bearer {self._token}"}
        try:
            path = f"{self.address}/api/camera_proxy/{entity}"
            with urlopen(Request(path, headers=headers), timeout=30.0) as answer:
                return bytes(answer.read())
        except URLError:
            return b""

    def call(self, service: str, entity: str) -> None:
        self.ask(f"/api/services/{service.replace('.', '/')}", {"entity_id": entity})

    async def shows(self, entity: str, state: str | Callable[[str], bool]) -> str:
        """Wait until an entity is in a state."""
        seen = ""

        async def holds() -> bool:
            nonlocal seen
            seen = await asyncio.to_thread(self.state, entity)
            await asyncio.sleep(0.05)
            return seen == state if isinstance(state, str) else state(seen)

        try:
            await until(holds, 90.0)
        except AssertionError as error:
            raise AssertionError(f"{entity} is {seen!r}") from error
        return seen


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def automations_of_the_page() -> str:
    page = (ROOT / "docs" / "homeassistant.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```yaml\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    return next(block for block in blocks if "Housefly asks" in block)


@asynccontextmanager
async def home_assistant(folder: Path, broker: Broker) -> AsyncIterator[HomeAssistant]:
    """Start one that knows the broker and has the page's automations."""
    if not HASS.exists():
        pytest.skip("Home Assistant is not installed: make interop")
    port = free_port()
    folder.joinpath(".storage").mkdir(parents=True)
    folder.joinpath("configuration.yaml").write_text(
        "homeassistant:\n  name: Home\n  time_zone: UTC\n"
        f"http:\n  server_host: 127.0.0.1\n  server_port: {port}\nfrontend:\n"
        "command_line:\n  - notify:\n      name: mobile_app_phone\n"
        f"      command: cat >> {folder / 'phone.txt'}\n"
        "input_boolean:\n  kitchen_window:\nmqtt_statestream:\n  base_topic: statestream\n"
        "  include:\n    domains: [input_boolean]\n"
        "automation: !include automations.yaml\nlogger:\n  default: warning\n"
    )
    folder.joinpath("automations.yaml").write_text(automations_of_the_page())
    known = {"broker": "127.0.0.1", "port": broker.port, "username": NAME, "password": PASSWORD}
    entry = {
        **{"entry_id": "mqtt", "version": 1, "minor_version": 1, "domain": "mqtt"},
        **{"title": "broker", "data": {**known, "discovery": True}, "options": {}},
        **{"source": "user", "unique_id": None, "disabled_by": None},
        **{"pref_disable_new_entities": False, "pref_disable_polling": False},
    }
    # What it would ask its first owner besides a name looks for a network that is not there.
    asked = {"done": ["core_config", "analytics", "integration"]}
    for key, version, data in (
        ("core.config_entries", 1, {"entries": [entry]}),
        ("onboarding", 4, asked),
    ):
        stored = {"version": version, "minor_version": 1, "key": key, "data": data}
        folder.joinpath(".storage", key).write_text(json.dumps(stored))
    with folder.joinpath("hass.log").open("wb") as log:
        process = subprocess.Popen(
            [HASS, "--skip-pip", "-c", folder], stdout=log, stderr=subprocess.STDOUT
        )
        home = HomeAssistant(port)
        try:
            await until(lambda: asyncio.to_thread(home.is_up), 240.0)
            yield home
        finally:
            process.send_signal(signal.SIGTERM)
            try:
                process.wait(30.0)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def shown_site(broker: Broker, folder: Path) -> Site:
    password = folder / "password"
    password.write_text(PASSWORD)
    mqtt = {"broker": "127.0.0.1", "port": broker.port, "username": NAME}
    return site_from_tree(
        {
            "mqtt": {**mqtt, "password_file": str(password), "sensors": [WINDOW]},
            "homeassistant": {
                **{"enabled": True, "answers": True, "pictures": True},
                "discovery": DISCOVERY,
            },
        }
    )


async def flown(pilot: FakePilot) -> None:
    while True:
        await asyncio.sleep(0.1)
        pilot.advance(0.1)


async def spoken(device: Any) -> None:
    """Let the devices of the room say how they are, as often as devices do."""
    while True:
        for kind, payload in DEVICES.items():
            await device.publish(f"housefly/bsen/{kind}/state", payload)
        await asyncio.sleep(1.0)


async def pictured(home: HomeAssistant, tokens: dict[str, Any], path: Path) -> None:
    """Keep a picture of the overview as its owner sees it."""
    from installed_chromium import chromium_path
    from playwright.async_api import async_playwright

    kept = {**tokens, "hassUrl": home.address, "clientId": f"{home.address}/"}
    kept["expires"] = int(1000 * (time.time() + tokens["expires_in"]))
    async with async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=chromium_path())
        page = await browser.new_page(viewport={"width": 1500, "height": 1400})
        await page.goto(f"{home.address}/manifest.json")
        await page.evaluate("kept => localStorage.setItem('hassTokens', kept)", json.dumps(kept))
        await page.goto(f"{home.address}/lovelace/0")
        await page.wait_for_selector("hui-view", timeout=90_000)
        await page.wait_for_timeout(8000)
        await page.screenshot(path=path)
        await browser.close()


@pytest.fixture
async def broker(tmp_path: Path) -> AsyncIterator[Broker]:
    async with running_broker(tmp_path) as started:
        await started.protect(NAME, PASSWORD)
        await started.kill()
        await started.start()
        yield started


async def test_it_sees_everything_presses_everything_and_the_doorbell_asks_the_phone(
    broker: Broker, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    site = shown_site(broker, tmp_path)
    runtime, room = new_runtime(site, tmp_path), load_room(site.room.model)
    parts = tuple(one for one in processes_of(runtime) if one.name in PARTS)
    stops: list[float] = []
    listener = StopListener(
        "127.0.0.1",
        runtime.stop_ports["drone"],
        runtime.secret,
        lambda: stops.append(time.time()),
        is_held=True,
    )
    await listener.start()
    phone = tmp_path / "home" / "phone.txt"
    async with home_assistant(tmp_path / "home", broker) as home:
        with Launcher(runtime, tmp_path, parts), ZenohBus(connect=runtime.bus) as bus:
            pilot = FakePilot(bus, replace(example_room(), home=room.home))
            working = [asyncio.create_task(flown(pilot))]
            client = broker.client(username=NAME, password=PASSWORD)
            try:
                tokens = await asyncio.to_thread(home.log_in)
                async with client as device:
                    working.append(asyncio.create_task(spoken(device)))
                    await _sees_everything(home, room.places)
                    await _is_read_by_the_room(home)
                    await _presses_everything(home, pilot, stops)
                    print(f"bell to state: {await _bell_times(home, device)} s")
                    await _rings(home, phone)
                    await _shows_a_picture(home, pilot, bus)
                if PICTURE:
                    await pictured(home, tokens, Path(PICTURE))
            finally:
                for work in working:
                    work.cancel()
                listener.close()
        await home.shows("vacuum.drone", "unavailable")


async def _sees_everything(home: HomeAssistant, places: tuple[Place, ...]) -> None:
    await home.shows("vacuum.drone", "docked")
    await home.shows("sensor.power_meter_stove_power", "1420")
    await home.shows("binary_sensor.door_contact_entrance_door_door", "on")
    await home.shows("sensor.door_contact_entrance_door_battery", "93")
    await home.shows("sensor.b_sen_mode", "home")
    seen = await asyncio.to_thread(home.states)
    for kind in SituationKind:
        assert f"binary_sensor.b_sen_{kind.value.replace(' ', '_')}" in seen
    for place in places:
        name = (place.title or place.name).lower().replace(" ", "_")
        assert f"button.drone_go_to_{name}" in seen or place.name == "home"
    for entity in ("event.doorbell_bell", "camera.drone_camera", "image.drone_last_picture"):
        assert entity in seen
    tracker = seen["device_tracker.drone_place"]["attributes"]
    assert {"x", "y", "z"} <= tracker.keys()
    assert seen["sensor.drone_battery"]["state"] == "86"


async def _is_read_by_the_room(home: HomeAssistant) -> None:
    """What Home Assistant knows is a device of the room, and comes back as one."""
    shown, own = "binary_sensor.contact_kitchen_window_open", "input_boolean.kitchen_window"
    for service, state in (("turn_on", "on"), ("turn_off", "off")):
        await asyncio.to_thread(home.call, f"input_boolean.{service}", own)
        await home.shows(shown, state)


async def _presses_everything(home: HomeAssistant, pilot: FakePilot, stops: list[float]) -> None:
    """Press every button and every command of the vacuum; each arrives as what it is."""
    for service, entity, kind in (
        ("button.press", "button.drone_stop", OrderKind.STOP),
        ("button.press", "button.drone_land", OrderKind.LAND),
        ("vacuum.pause", "vacuum.drone", OrderKind.HOVER),
        ("vacuum.stop", "vacuum.drone", OrderKind.HOVER),
        ("vacuum.return_to_base", "vacuum.drone", OrderKind.HOME),
    ):
        pilot.orders.clear()
        await asyncio.to_thread(home.call, service, entity)
        await until(lambda kind=kind: any(order.kind is kind for order in pilot.orders))
    assert stops
    for service, entity in (
        ("button.press", "button.drone_go_to_entrance"),
        ("vacuum.start", "vacuum.drone"),
    ):
        await asyncio.to_thread(home.call, service, entity)
        await home.shows("sensor.b_sen_question", lambda state: state != "none")
        await asyncio.to_thread(home.call, "button.press", "button.b_sen_no")
        await home.shows("sensor.b_sen_question", "none")


async def _bell_times(home: HomeAssistant, device: Any) -> list[float]:
    """Ring some times; returns from each press to the state of the event there [s]."""
    found = []
    for _ in range(5):
        before = await asyncio.to_thread(home.state, "event.doorbell_bell")
        pressed = time.time()
        await device.publish("housefly/bsen/doorbell/doorbell/event", b'{"event": "pressed"}')
        shown = await home.shows("event.doorbell_bell", lambda state, old=before: state != old)
        found.append(round(datetime.fromisoformat(shown).timestamp() - pressed, 3))
        await asyncio.sleep(1.0)
    return found


async def _rings(home: HomeAssistant, phone: Path) -> None:
    """The bell has rung: the phone is asked, its yes lets the drone fly."""
    await until(lambda: phone.exists() and "?" in phone.read_text(), 60.0)
    seen = await asyncio.to_thread(home.states)
    action = f"HOUSEFLY|{seen['sensor.b_sen_question']['attributes']['asks']}|yes"
    told = {"action": action}
    await asyncio.to_thread(home.ask, "/api/events/mobile_app_notification_action", told)
    await home.shows("sensor.b_sen_reply", lambda state: "queued" in state or "running" in state)
    assert "emplate" not in phone.with_name("hass.log").read_text(), "the page's automations"


async def _shows_a_picture(home: HomeAssistant, pilot: FakePilot, bus: Bus) -> None:
    """In flight there is a picture of the camera, afterwards a blank one."""
    encoder, pictures = Encoder(*SIZE, RATE_HZ, group=5), []
    pilot.phase, pilot.status = Phase.HOLDING, DroneStatus.FLYING
    for number in range(600):
        data, keyframe = encoder.encode(striped(number % 1000))
        at = pilot.clock.now()
        bus.publish(pilot.topics.video, VideoFrame(data, keyframe, *SIZE, number, at))
        await asyncio.sleep(0.1)
        if number % 10 == 0:
            pictures.append(await asyncio.to_thread(home.picture, "camera.drone_camera"))
        if number == 60:
            pilot.phase, pilot.status = Phase.IDLE, DroneStatus.LANDED
        if number > 60 and pictures[-1] and is_blank(pictures[-1]):
            break
    assert any(picture and not is_blank(picture) for picture in pictures)
    assert pictures[-1] and is_blank(pictures[-1])


def is_blank(jpeg: bytes) -> bool:
    shown = np.asarray(Image.open(BytesIO(jpeg)).convert("RGB")).astype(int)
    return bool(np.abs(shown - BLANK).max() < 25)
