"""A stage for the ROS 2 node: the bus of a run with a pilot that answers every order, and a client.

The node is a process of its own; the client is a real rclpy node in this one.
"""

from __future__ import annotations

import importlib
import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Self

from stand_in_tasks import StandInTasks

from housefly.bus.bus import Bus
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.clock import RealClock
from housefly.messages import (
    Action,
    Command,
    DroneStatus,
    Estimate,
    Inputs,
    Order,
    OrderAnswer,
    OrderKind,
    OrderOutcome,
    OrderSource,
    Outputs,
    Phase,
    PilotStep,
    Pose,
    Sighting,
    Telemetry,
)
from housefly.sites.loaded_site import load_site

ROOM, DRONE = "/b_sen", "/b_sen/drone"
PATIENCE = 60.0
"""A machine three times slower than this one has the node up by then [s]."""
_STEP_PERIOD = 0.02


@dataclass
class AnsweringPilot:
    """Takes every order, but the kinds that it refuses; flies once it was told to.

    Attributes:
        bus: of the run.
        orders: all that came.
        refused: kinds of orders, with the words.
        status, phase, place: of the drone, as tests set them.
    """

    bus: Bus
    orders: list[Order] = field(default_factory=list)
    refused: dict[OrderKind, OrderOutcome] = field(default_factory=dict)
    status: DroneStatus = DroneStatus.LANDED
    phase: Phase = Phase.IDLE
    place: tuple[float, float, float] = (3.0, 2.0, 1.1)
    _new: list[Order] = field(default_factory=list)
    _ended: threading.Event = field(default_factory=threading.Event)
    _lock: threading.Lock = field(default_factory=threading.Lock)

    def __enter__(self) -> Self:
        self._subscription = self.bus.subscribe(DroneTopics().order, self.give)
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()
        self._thread.join()
        self._subscription.close()

    def give(self, order: Order) -> None:
        """Take an order, of the node or of somebody else."""
        with self._lock:
            self.orders.append(order)
            self._new.append(order)

    def flown_by(self, sender: str) -> None:
        """Let somebody fly the drone."""
        self.status = DroneStatus.FLYING
        self.give(Order(OrderKind.GO, sender=sender, source=OrderSource.PERSON, id="theirs"))

    def land(self) -> None:
        """Let it stand, in nobody's hands."""
        self.status, self.phase = DroneStatus.LANDED, Phase.IDLE
        self.place = (3.0, 2.0, 1.1)
        time.sleep(5 * _STEP_PERIOD)
        self.orders.clear()

    def _run(self) -> None:
        clock, sequence = RealClock(), 0
        while not self._ended.wait(_STEP_PERIOD):
            with self._lock:
                new, self._new = tuple(self._new), []
            now, sequence = clock.now(), sequence + 1
            pose = Pose(self.place)
            inputs = Inputs(
                sightings=(Sighting("ardrone", pose, now - 0.02, now),),
                telemetry=Telemetry(now, self.status, 0.8),
                orders=new,
            )
            answers = tuple(
                OrderAnswer(one.id, self.refused.get(one.kind, OrderOutcome.TAKEN)) for one in new
            )
            estimate = Estimate(now, pose.position, (0.0, 0.0, 0.0), 0.0, 0.02, 0.01)
            outputs = Outputs(Command(Action.IDLE), estimate, phase=self.phase, answers=answers)
            self.bus.publish(DroneTopics().step, PilotStep(sequence, now, inputs, outputs))


class RosClient:
    """A ROS 2 node as a user writes one.

    Args:
        domain: of ROS.
    """

    def __init__(self, domain: int) -> None:
        os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
        import rclpy

        self._rclpy = rclpy
        self._context = rclpy.Context()
        rclpy.init(domain_id=domain, context=self._context)
        self.node: Any = rclpy.create_node("somebody", context=self._context)
        self._executor = importlib.import_module("rclpy.executors").SingleThreadedExecutor(
            context=self._context
        )
        self._executor.add_node(self.node)

    def close(self) -> None:
        """Leave."""
        self._executor.shutdown()
        self.node.destroy_node()
        self._rclpy.try_shutdown(context=self._context)

    def spin(self, until: Callable[[], object], seconds: float = PATIENCE) -> bool:
        """Work until something holds; return whether it does."""
        deadline = time.monotonic() + seconds
        while not (held := until()) and time.monotonic() < deadline:
            self._executor.spin_once(timeout_sec=0.02)
        return bool(held)

    def heard(self, name: str, latched: bool = False) -> list[Any]:
        """Return a list that fills with the messages of a topic of the node."""
        assert self.spin(lambda: self._type_of(name)), f"{name} is not there"
        kind, qos = self._type_of(name), importlib.import_module("rclpy.qos")
        durability = qos.DurabilityPolicy
        profile = qos.QoSProfile(
            depth=10,
            reliability=(
                qos.ReliabilityPolicy.RELIABLE if latched else qos.ReliabilityPolicy.BEST_EFFORT
            ),
            durability=durability.TRANSIENT_LOCAL if latched else durability.VOLATILE,
        )
        found: list[Any] = []
        self.node.create_subscription(interface(kind), name, found.append, profile)
        return found

    def says(self, name: str, message: Any) -> None:
        """Publish a message once somebody subscribes."""
        publisher = self.node.create_publisher(type(message), name, 10)
        assert self.spin(publisher.get_subscription_count), f"nobody subscribes to {name}"
        publisher.publish(message)

    def calls(self, name: str) -> Any:
        """Return the response of a Trigger service."""
        from std_srvs.srv import Trigger

        client = self.node.create_client(Trigger, name)
        assert self.spin(client.service_is_ready), f"{name} is not served"
        future = client.call_async(Trigger.Request())
        assert self.spin(future.done), f"{name} does not answer"
        return future.result()

    def types(self) -> dict[str, str]:
        """Return the topics that are there, with their types."""
        return {name: kinds[0] for name, kinds in self.node.get_topic_names_and_types()}

    def _type_of(self, name: str) -> str:
        is_published = bool(self.node.get_publishers_info_by_topic(name))
        return self.types().get(name, "") if is_published else ""


def interface(name: str) -> Any:
    """Return a ROS type by its full name."""
    package, kind, type_name = name.split("/")
    return getattr(importlib.import_module(f"{package}.{kind}"), type_name)


@dataclass
class RosStage:
    """What a test has."""

    pilot: AnsweringPilot
    tasks: StandInTasks
    client: RosClient
    domain: int
    process: subprocess.Popen[bytes]


@contextmanager
def ros_stage(folder: Path, domain: int, **changes: Any) -> Iterator[RosStage]:
    """Run the node of a site beside a pilot and tasks that answer.

    Args:
        folder: for its files.
        domain: of ROS, of this test alone.
        changes: of the site.
    """
    loaded = load_site("bsen", ros2__domain=domain, hub__enabled=False, **changes)
    site_file, endpoint = folder / "site.json", f"unixsock-stream/{folder}/bus"
    site_file.write_text(loaded.site.model_dump_json())
    command = [sys.executable, "-m", "housefly.ros2.process", "--site", str(site_file)]
    with ExitStack() as stack:
        bus = stack.enter_context(ZenohBus(listen=endpoint))
        pilot = stack.enter_context(AnsweringPilot(bus))
        tasks = StandInTasks(bus)
        stack.callback(tasks.close)
        process = subprocess.Popen([*command, "--bus", endpoint])
        stack.callback(process.wait)
        stack.callback(process.terminate)
        client = RosClient(domain)
        stack.callback(client.close)
        yield RosStage(pilot, tasks, client, domain, process)
