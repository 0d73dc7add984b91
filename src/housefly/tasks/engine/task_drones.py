"""The drones as the tasks have them: what each says, what it sees, who flies it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from housefly.errors import TaskError
from housefly.evidence.clip_recorder import ClipRecorder
from housefly.messages import Phase, PilotStep
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.engine.drone_state import TakeOffReadiness, drone_availability
from housefly.tasks.execution.step_inbox import StepInbox
from housefly.tasks.execution.task_room import TaskRoom
from housefly.tasks.scheduler.values import DroneAvailability


@dataclass(slots=True)
class TaskDrone:
    """One drone.

    Attributes:
        name: of the drone.
        body: its id in the room's memory, the name of its tracked body.
        room: as it sees it: viewpoints, people, memory.
        clips: recorder of its camera.
        inbox: its pilot's steps.
        readiness: what its pilot's pre-flight list says; whoever asks the pilot sets it.
    """

    name: str
    body: str
    room: TaskRoom
    clips: ClipRecorder
    inbox: StepInbox = field(default_factory=StepInbox)
    readiness: TakeOffReadiness = field(default_factory=TakeOffReadiness)

    def availability(self, now: float) -> DroneAvailability:
        """Return whether tasks may order it now, by the pilot's clock [s]."""
        found = drone_availability(self.inbox, self.readiness, now)
        step = self.inbox.newest
        estimate = None if step is None else step.outputs.estimate
        place = None if estimate is None else estimate.position[:2]
        return DroneAvailability(found.is_ready, found.words, self.name, place)

    @property
    def looking_step(self) -> PilotStep | None:
        """The newest step while it looks at something."""
        step = self.inbox.newest
        return step if step is not None and step.outputs.phase is Phase.LOOKING else None


class TaskDrones(Mapping[str, TaskDrone]):
    """The drones of a site by name; at least one, also where none is flown."""

    def __init__(self, *drones: TaskDrone) -> None:
        self._drones = {drone.name: drone for drone in drones}
        self.first = drones[0]

    def __getitem__(self, name: str) -> TaskDrone:
        return self._drones[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._drones)

    def __len__(self) -> int:
        return len(self._drones)

    def or_first(self, name: str) -> TaskDrone:
        """Return a drone by name; the first of the site for "", a task that has none yet."""
        return self._drones.get(name, self.first)

    def check(self, name: str) -> None:
        """Raise TaskError for a drone that there is not; "" is whichever is free."""
        if name and name not in self._drones:
            problem = f"there is no drone called {name!r}; allowed: {', '.join(self._drones)}"
            raise TaskError(problem, ReasonCode.BAD_PARAMETER.value)
