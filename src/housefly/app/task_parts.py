"""Puts the task service of a site together."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from housefly.app.live_task_room import LiveTaskRoom
from housefly.config.house_mode import HouseMode
from housefly.config.site import Site
from housefly.config.state import clips_folder, tasks_folder
from housefly.config.tasks import TasksConfig
from housefly.errors import ConfigError
from housefly.evidence.clip_recorder import ClipRecorder
from housefly.hub.api.questions import Question
from housefly.hub.client.room_queries import AskedRoom
from housefly.sites.loaded_site import LoadedSite
from housefly.tasks.document.open_library import OpenLibrary
from housefly.tasks.document.task_document import TaskDocument
from housefly.tasks.engine.task_actions import TaskActions
from housefly.tasks.engine.task_drones import TaskDrone, TaskDrones
from housefly.tasks.engine.task_engine import TaskEngine
from housefly.tasks.engine.task_outlet import TaskOutlet, TaskRehearser
from housefly.tasks.engine.task_rehearsals import TaskRehearsals
from housefly.tasks.engine.task_runs import TaskRuns
from housefly.tasks.execution.task_run import HOLD_PERIOD
from housefly.tasks.intents.names import names_of_room
from housefly.tasks.rules.change_store import ChangeStore
from housefly.tasks.rules.room_facts import AskedRoomFacts
from housefly.tasks.rules.rule import Rule
from housefly.tasks.rules.rule_engine import RuleEngine
from housefly.tasks.rules.rule_file import rule_problems, rules_of
from housefly.tasks.rules.rule_service import RuleService
from housefly.tasks.rules.rule_store import RuleStore
from housefly.tasks.scheduler.task_store import TASK_FILE, TaskStore
from housefly.tasks.scheduler.values import SchedulerLimits
from housefly.tasks.service.task_service import ServiceParts, TaskService

_HOLD_MARGIN = 5.0
_ASKING_PATIENCE = 8.0
"""How long a person waits for the memory [s]."""


def task_service(
    loaded: LoadedSite,
    rooms: Mapping[str, LiveTaskRoom],
    rehearser: TaskRehearser,
    outlet: TaskOutlet,
    clock: Callable[[], float],
    wall: Callable[[], float],
    recording: str = "",
) -> tuple[TaskService, ServiceParts, tuple[str, ...]]:
    """Return the service of a site, its parts, and what is wrong with what it read, in words.

    Args:
        loaded: the site.
        rooms: by drone: memory, people and viewpoints as of now.
        rehearser: flies in lock step.
        outlet: takes orders and events.
        clock: the pilot's [s].
        wall: Unix time [s].
        recording: folder into which the whole run is recorded, or "".

    Raises:
        StoreError: the queue or the clips cannot be opened.
    """
    site, folder = loaded.site, tasks_folder(loaded.site)
    config = site.tasks
    own, has_drone = config.documents, bool(site.drone_names)
    library = OpenLibrary(
        Path(own) if own else None, has_drone=has_drone, has_camera=site.has_camera
    )
    rules, wrong_rules = _rules(config)
    rules = rules if has_drone else rules_without_flight(rules, library)
    rule_store = RuleStore(folder, HouseMode(config.mode))
    store = TaskStore(folder / TASK_FILE)
    drones = TaskDrones(*(_drone(site, name, room) for name, room in rooms.items()))
    room = next(iter(rooms.values()))
    rehearsals = TaskRehearsals(rehearser)
    actions = TaskActions(outlet, drones)
    runs = TaskRuns(drones, rehearsals, actions)
    runs.recording = recording
    limits = SchedulerLimits(config.queue, config.beside, config.confirm_time, config.fresh_time)
    engine = TaskEngine(store, limits, runs, actions, drones)

    def ask(question: Question) -> object:
        return room.ask(question, _ASKING_PATIENCE)

    rule_service = RuleService(
        RuleEngine(rules),
        rule_store,
        AskedRoomFacts(room.ask),
        wrong_rules,
        ChangeStore(folder),
    )
    parts = ServiceParts(
        library,
        engine,
        store,
        rehearsals,
        actions,
        drones,
        rule_service,
        AskedRoom(ask),
        outlet,
        names_of_room(loaded.room),
        _own_sentences(config),
        has_drone,
    )
    services = {name: document.info() for name, document in library.items()}
    problems = (
        *library.problems,
        wrong_rules,
        *store.notices,
        rule_store.problem,
        *rule_service.problems,
        *rule_problems(rules, services),
        _hold_problem(site),
    )
    service = TaskService(parts, clock, wall)
    return service, parts, tuple(problem for problem in problems if problem)


def _drone(site: Site, name: str, room: LiveTaskRoom) -> TaskDrone:
    own = site.for_drone(name)
    recorder = ClipRecorder(clips_folder(site), site.tasks, own.drone)
    return TaskDrone(name, own.tracking.body, room, recorder)


def _rules(config: TasksConfig) -> tuple[tuple[Rule, ...], str]:
    """Return the rules, without one's own when their file is wrong, and what is wrong with it."""
    try:
        return rules_of(Path(config.rules) if config.rules else None), ""
    except ConfigError as error:
        return rules_of(None), str(error)


def rules_without_flight(
    rules: Iterable[Rule], documents: Mapping[str, TaskDocument]
) -> tuple[Rule, ...]:
    """Return the rules that ask for nothing that flies."""
    flying = {name for name, document in documents.items() if document.flies}
    return tuple(rule for rule in rules if rule.then.service not in flying)


def _hold_problem(site: Site) -> str:
    """Return that the pilot brings home whoever waits, when it does so too early for tasks."""
    least = HOLD_PERIOD + _HOLD_MARGIN
    if site.limits.hold_timeout >= least:
        return ""
    return (
        f"limits.hold_timeout is {site.limits.hold_timeout:g} s: a task that hovers for longer is"
        f" brought home and fails; allowed for such tasks: {least:g} s or more"
    )


def _own_sentences(config: TasksConfig) -> Path | None:
    """Return the folder of sentences beside a site's own documents, or None."""
    folder = Path(config.documents) / "sentences"
    return folder if config.documents and folder.is_dir() else None
