"""The simulated devices and the driver at one broker: what happens in the room is what we hear."""

from __future__ import annotations

import asyncio
import sys
import time
from math import hypot

import aiomqtt
import pytest

from housefly.config.devices import MqttConfig
from housefly.twin.people import Scene, load_scene
from housefly.twin.sensors.devices import SimulatedDevices
from housefly.twin.sensors.mqtt_publisher import MqttPublisher

pytestmark = pytest.mark.wire

SPEED = 20.0
"""The scene runs this much faster than time."""
TAGS = tuple({"tag": thing.tag, "thing": thing.name} for thing in load_scene("bsen").script.things)


class Playing:
    """A scene at a broker, in quick motion."""

    def __init__(self, port: int, scene: Scene, speed: float = SPEED) -> None:
        self.began, self.speed, self.lines = time.monotonic(), speed, list[str]()
        config = MqttConfig(broker="127.0.0.1", port=port)
        self.link = MqttPublisher(
            config, SimulatedDevices(scene, config.site), self.now, self.lines.append
        )
        self.task = asyncio.create_task(self.link.run())

    def now(self) -> float:
        return (time.monotonic() - self.began) * self.speed

    async def stop(self) -> None:
        self.task.cancel()
        await asyncio.wait({self.task})


async def test_a_whole_afternoon_is_heard_as_it_happens(broker, listen, until):
    scene = load_scene("bsen")
    async with listen(broker.port, tags=TAGS, rate_max_hz=1000.0) as heard:
        playing = Playing(broker.port, scene)
        await until(lambda: playing.now() > scene.length, 30.0)
        await until(lambda: len([h for h in heard.events if h.kind == "door closed"]) >= 3)
        await playing.stop()
        kinds = [told.kind for told in heard.events]
        for kind in ("bell pressed", "door opened", "door closed", "object taken", "object put"):
            assert kind in kinds
        assert kinds.count("bell pressed") == 1
        taken = next(told for told in heard.events if told.kind == "object taken")
        assert (taken.thing, taken.source) == ("cup", "cabinet")
        watts = [dict(row.facts)["power"] for row in heard.observations if row.thing == "stove"]
        assert min(watts) < 20.0 and max(watts) == pytest.approx(1420.0, abs=30.0)
        assert {row.kind for row in heard.sensors.health()} == {
            "mqtt", "floor", "cabinet", "refrigerator", "bed", "door", "doorbell", "motion",
            "power", "contact",
        }  # fmt: skip
        assert all("malformed" not in dict(row.counts) for row in heard.sensors.health())


async def test_people_on_the_floor_are_where_they_are(broker, listen, until):
    scene = load_scene("bsen")
    async with listen(broker.port) as heard:
        playing = Playing(broker.port, scene, speed=1.0)
        await until(
            lambda: len([row for row in heard.observations if row.thing == "person-2"]) > 20
        )
        await playing.stop()
        seats = [
            row.position for row in heard.observations if row.thing == "person-2" and row.position
        ]
        assert all(hypot(x - 5.70, y - 2.28) < 0.15 for x, y, _ in seats)


async def test_the_devices_find_a_broker_that_comes_back_and_leave_their_wills(
    broker, listen, until
):
    playing = Playing(broker.port, load_scene("bsen"), speed=1.0)
    async with listen(broker.port) as heard:
        await until(lambda: heard.knows("floor-1") and heard.health("floor-1").connected)
        await broker.kill()
        await until(lambda: playing.lines)
        await broker.start()
        await until(lambda: heard.knows("floor-1") and heard.health("floor-1").connected)
        await until(lambda: len(playing.lines) >= 2)
        assert playing.lines[-1].endswith("is there again")
        await playing.stop()
        await until(lambda: heard.health("floor-1").problem)
        assert (
            "sends its state" in heard.health("floor-1").problem
            or "offline" in heard.health("floor-1").problem
        )


async def test_devices_that_are_told_to_end_while_their_connection_is_lost_end(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    scene = load_scene("bsen")
    link = MqttPublisher(MqttConfig(), SimulatedDevices(scene, "bsen"), lambda: 0.0)

    met = set[object]()

    async def lost(address: object) -> None:
        """As the library leaves a connection whose broker does not answer any more."""
        try:
            await asyncio.sleep(60.0)
        except asyncio.CancelledError:
            if address in met:
                raise
            met.add(address)
            raise aiomqtt.MqttError("Operation timed out") from None

    monkeypatch.setattr(link, "_publish_once_connected", lost)
    task = asyncio.create_task(link.run())
    await asyncio.sleep(0.05)
    task.cancel()
    done, _ = await asyncio.wait({task}, timeout=20.0)
    assert done and task.cancelled() and met


@pytest.mark.slow
async def test_the_twin_as_a_process_plays_its_scene_at_the_sites_broker(
    broker, listen, until, loopback, tmp_path
):
    site = tmp_path / "site.toml"
    site.write_text(
        f'[drone]\naddress = "{loopback}"\n[tracking]\naddress = "{loopback}"\n[twin]\nvideo ='
        f' false\nscene = "bsen"\n[mqtt]\nbroker = "127.0.0.1"\nport = {broker.port}\n'
    )
    async with listen(broker.port) as heard:
        twin = await asyncio.create_subprocess_exec(
            sys.executable, "-m", "housefly.twin.process", "--site", str(site)
        )
        try:
            await until(
                lambda: heard.knows("floor-1") and heard.health("floor-1").rate_hz > 5.0, 60.0
            )
            await until(lambda: heard.health("bed").connected)
        finally:
            twin.kill()
            await twin.wait()
        await until(lambda: "offline" in heard.health("floor-1").problem)


@pytest.mark.slow
async def test_the_twin_does_not_send_simulated_readings_to_other_machines(tmp_path):
    site = tmp_path / "site.toml"
    site.write_text('[twin]\nvideo = false\nscene = "bsen"\n[mqtt]\nbroker = "192.0.2.1"\n')
    command = (sys.executable, "-m", "housefly.twin.process", "--site", str(site))
    twin = await asyncio.create_subprocess_exec(*command, stderr=asyncio.subprocess.PIPE)
    _, told = await asyncio.wait_for(twin.communicate(), 60.0)
    assert twin.returncode == 1
    assert b"mqtt.broker: is 192.0.2.1" in told
