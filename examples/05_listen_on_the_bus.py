"""Listen to a running Housefly from another process.

Learns: pilot, twin and console are processes that meet on a bus; whoever knows its address may
    listen, ask and order.
Prints: the topics, the answer to a planning question, then one line a second of the pilot's steps,
    a hundred a second.
"""

import sys
import tempfile
import threading
from pathlib import Path

from housefly.app.launcher import Launcher, processes_of
from housefly.app.loaded_site import read_site
from housefly.app.readiness import Readiness
from housefly.app.runtime import new_runtime
from housefly.bus.topics import PLAN_QUERY, STEP_TOPIC, TOPICS
from housefly.bus.zenoh_bus import ZenohBus
from housefly.messages import PilotStep

ADDRESS = sys.argv[1] if len(sys.argv) > 1 else "127.44.0.5"
site = read_site(
    "bsen",
    drone__address=ADDRESS,
    drone__has_video=False,
    tracking__address=ADDRESS,
    twin__video=False,
)
heard = 0
enough = threading.Event()


def on_step(step: PilotStep) -> None:
    """Print every hundredth step; runs on the bus's thread, so it is quick."""
    global heard
    heard += 1
    estimate = step.outputs.estimate
    if heard % 100 == 0 and estimate is not None:
        x, y, z = estimate.position
        print(f"step {step.sequence}: {step.outputs.phase.value}, at ({x:.2f}, {y:.2f}, {z:.2f}) m")
    if heard >= 300:
        enough.set()


with tempfile.TemporaryDirectory() as folder:
    runtime = new_runtime(site, Path(folder))
    with (
        Launcher(runtime, Path(folder), processes_of(runtime, web=False)),
        ZenohBus(connect=runtime.bus) as bus,
    ):
        assert Readiness(site, bus, web=False, video=False).wait(60.0) == ""
        print("topics:", ", ".join(topic.key for topic in TOPICS))
        print("plan to the entrance:", bus.ask(PLAN_QUERY, '{"place": "entrance"}')[:100], "...")
        subscription = bus.subscribe(STEP_TOPIC, on_step)
        enough.wait(20.0)
        subscription.close()
