"""The live view as a process on the bus, read by a client that knows only the protocol."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
import threading
import time
from importlib.resources import files
from pathlib import Path
from typing import Any

import pytest
from foxglove_client import watching
from foxglove_room import PATH, Talker

from housefly.bus.endpoint import endpoint_in
from housefly.bus.zenoh_bus import ZenohBus
from housefly.foxglove.channels import channels_of
from housefly.sites.loaded_site import LoadedSite

pytestmark = pytest.mark.wire


def layout() -> dict[str, Any]:
    text = files("housefly.foxglove").joinpath("layout.json").read_text(encoding="utf-8")
    return dict(json.loads(text))


def topics_of(told: Any) -> set[str]:
    """Return every topic that a layout names: as a value, before its first dot, or as a key."""
    if isinstance(told, dict):
        named = {key for key in told if key.startswith("/")}
        return named.union(*(topics_of(one) for one in told.values()), set())
    if isinstance(told, list):
        return set().union(*(topics_of(one) for one in told))
    return {told.partition(".")[0]} if isinstance(told, str) and told.startswith("/") else set()


def field_of(value: Any, path: str) -> Any:
    """Return what a message path of the layout names in a message."""
    for name in path.removesuffix("[:]").split("."):
        value = value[name] if isinstance(value, dict) else getattr(value, name)
    return value


def paths_of(told: Any) -> set[tuple[str, str]]:
    """Return the message paths of a layout's plots, states and tables."""
    return set(re.findall(r'"(/[\w/]+)\.([\w.]+)(?:\[:\])?"', json.dumps(told)))


async def test_every_channel_of_the_layout_comes_from_the_process_and_can_be_read(
    loaded: LoadedSite, tmp_path: Path
) -> None:
    site = loaded.site
    file = tmp_path / "site.json"
    file.write_text(site.model_dump_json(), encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder, ZenohBus(endpoint_in(Path(folder))) as bus:
        process = subprocess.Popen(
            [
                *(sys.executable, "-m", "housefly.foxglove.process", "--site", str(file)),
                *("--bus", endpoint_in(Path(folder))),
            ],
            stdout=subprocess.PIPE,
            text=True,
        )
        talker, end = Talker(bus, site), threading.Event()
        talking = threading.Thread(target=lambda: _tell(talker, end))
        try:
            assert process.stdout is not None
            ready = process.stdout.readline()
            found = re.search(r"foxglove ready: ws://127\.0\.0\.1:(\d+)", ready)
            assert found, ready
            talking.start()
            began = time.time()
            async with watching(int(found[1]), channels=len(channels_of(site))) as viewer:
                wanted = sorted(topics_of(layout()) | {"/tf"})
                assert set(wanted) <= viewer.channels.keys()
                await viewer.subscribe(*wanted)
                first = await viewer.first_of(wanted)
        finally:
            end.set()
            if talking.ident is not None:
                talking.join()
            process.terminate()
            process.wait()
    assert all(began - 5.0 < one.at < time.time() + 1.0 for one in first.values())
    for topic, path in sorted(paths_of(layout())):
        assert field_of(first[topic].value, path) is not None
    way = [one.pose.position for one in first["/drone/path"].value.poses]
    assert [(point.x, point.y) for point in way] == list(PATH.waypoints)
    assert first["/drone/camera"].value.data[:3] in (b"\0\0\0", b"\0\0\1")
    assert first["/tf"].value.transforms[0].child_frame_id == "drone"


def _tell(talker: Talker, end: threading.Event) -> None:
    while not end.wait(0.05):
        talker.tell()


def test_the_layout_shows_only_what_it_places_and_places_what_it_shows() -> None:
    def placed(node: Any) -> set[str]:
        return {node} if isinstance(node, str) else placed(node["first"]) | placed(node["second"])

    told = layout()
    assert placed(told["layout"]) == told["configById"].keys()
