"""An assistant asks a house that really runs, and flies only after a yes; scored on the truth."""

from __future__ import annotations

import base64
import importlib.util
import io
import json
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import anyio
import pytest
from mcp import Client
from mcp_types import ElicitResult
from PIL import Image

from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import discovery_entry, new_runtime
from housefly.app.readiness import Readiness
from housefly.bus.zenoh_bus import ZenohBus
from housefly.errors import LinkError
from housefly.hub.client.discovery import announced
from housefly.record.truth import TrueFlight, read_truth
from housefly.tasks.api.values import ENDED, TaskStage
from housefly.tasks.assistants.assistant_reply import MARKED
from housefly.tasks.assistants.assistant_room import FoundRoom
from housefly.tasks.assistants.mcp_server import room_server

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.interop, pytest.mark.timeout(400)]

_FILE = Path(__file__).with_name("test_task_wires.py")
_spec = importlib.util.spec_from_file_location("task_wires", _FILE)
assert _spec is not None and _spec.loader is not None
wires: Any = importlib.util.module_from_spec(_spec)
sys.modules[_spec.name] = wires
_spec.loader.exec_module(wires)

FLIGHT = {"service": "look", "parameters": {"subject": wires.PLACE}}
_ENDED = {stage.value for stage in ENDED}


@dataclass(frozen=True)
class Running:
    truth_file: Path

    def truth(self) -> TrueFlight:
        time.sleep(1.0)  # it is written in batches
        found = read_truth(self.truth_file)
        assert found is not None
        return found


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Running]:
    folder = tmp_path_factory.mktemp("assistant")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_RUNTIME_DIR", str(folder))
        site = wires.site_of(folder)
        runtime = new_runtime(site, folder, web=True)
        truth = folder / "truth.jsonl"
        processes = tuple(
            wires.replace(spec, arguments=(*spec.arguments, "--truth", str(truth)))
            if spec.name == "twin"
            else spec
            for spec in processes_of(runtime)
        )
        with (
            Launcher(runtime, folder, processes),
            announced(discovery_entry(runtime)),
            ZenohBus(connect=runtime.bus) as bus,
        ):
            assert Readiness(site, bus, web=True, video=False).wait(90.0) == ""
            assert wires.until(_answers, 60.0), (folder / "tasks.log").read_text()
            yield Running(truth)


def _answers() -> bool:
    from housefly.tasks.api.questions import BoardQuestion

    try:
        return "ready" in FoundRoom().ask_tasks(BoardQuestion()).drone
    except LinkError:
        return False


async def told(client: Client, tool: str, **arguments: Any) -> dict[str, Any]:
    found = await client.call_tool(tool, arguments)
    assert not found.is_error, found
    content: dict[str, Any] = found.structured_content or json.loads(found.content[0].text)
    return content


async def ended(client: Client, task: int) -> dict[str, Any]:
    with anyio.fail_after(150.0):
        while (status := await told(client, "task_status", task=task))["state"] not in _ENDED:
            await anyio.sleep(0.2)
    return status


async def test_an_assistant_asks_rehearses_and_flies_only_after_a_yes(house: Running) -> None:
    asked = []

    async def person(context: Any, question: Any) -> ElicitResult:
        asked.append(question.message)
        return ElicitResult(action="accept", content={"fly": True})

    server = room_server(FoundRoom())
    async with Client(server) as alone:
        where = await told(alone, "where_is", thing="sofa")
        assert where[MARKED]["thing"] == "sofa"
        text, _ = (await alone.call_tool("map", {})).content
        assert "ardrone" in {
            one["name"] for one in json.loads(text.text)[MARKED]["legend"].values()
        }
        found = await told(alone, "rehearse", **FLIGHT)
        assert found["may_fly"], found
        waiting = await told(alone, "request_flight", **FLIGHT)
        assert waiting["state"] == TaskStage.WAITING.value, waiting
        await anyio.sleep(5.0)
        still = await told(alone, "task_status", task=waiting["task"])
        assert still["state"] == TaskStage.WAITING.value
        assert not house.truth().airborne.any(), "nobody said yes"
        await told(alone, "cancel_task", task=waiting["task"])
    async with Client(server, elicitation_callback=person) as asking:
        flying = await told(asking, "request_flight", **FLIGHT)
        done = await ended(asking, flying["task"])
        assert done["state"] == TaskStage.DONE.value, done
        assert len(asked) == 1 and "look" in asked[0]
        _, picture = (await asking.call_tool("last_picture", {})).content
        assert Image.open(io.BytesIO(base64.b64decode(picture.data))).format == "JPEG"
    truth = house.truth()
    assert truth.airborne.any() and not truth.airborne[-1]
    assert not [contact for contact in truth.contacts if contact.motors_turned]
