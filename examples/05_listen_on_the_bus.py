"""Listen to a running Housefly from another process.

Needs: MuJoCo: the extra `twin`, which `make setup` brings.
Learns: pilot, hub and twin are processes that meet on a bus; whoever knows its address may listen,
    ask and order.
Prints: the topics, the answer to a planning question, then one line a second of the pilot's steps,
    a hundred a second.
"""

import sys
import threading

import housefly

ADDRESS = sys.argv[1] if len(sys.argv) > 1 else "127.44.0.5"
WIRES = {"drone__address": ADDRESS, "tracking__address": ADDRESS}
heard = 0
enough = threading.Event()


def on_step(step: housefly.PilotStep) -> None:
    """Print every hundredth step; runs on the bus's thread, so it is quick."""
    global heard
    heard += 1
    if heard % 100 == 0 and step.outputs.estimate is not None:
        x, y, z = step.outputs.estimate.position
        print(f"step {step.sequence}: {step.outputs.phase.value}, at ({x:.2f}, {y:.2f}, {z:.2f}) m")
    if heard >= 300:
        enough.set()


site = housefly.load_site("bsen", **WIRES, drone__has_video=False, twin__video=False)
with housefly.launch(site) as bus:
    drone = housefly.DroneTopics()  # the only one of its site; DroneTopics("red") of several
    print("topics:", ", ".join(topic.key for topic in (*housefly.ROOM_TOPICS, *drone.all)))
    answer = bus.ask(drone.plan, '{"place": "entrance"}')
    print("plan to the entrance:", answer[:100], "...")
    bus.subscribe(drone.step, on_step)
    enough.wait(20.0)
