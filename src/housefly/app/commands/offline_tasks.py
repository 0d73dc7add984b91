"""What ``housefly ask`` and ``housefly tasks`` can say while no room runs."""

from __future__ import annotations

import time
from argparse import Namespace
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from housefly.app.commands.asked_room import asked_site, remembered_room
from housefly.errors import TaskError

if TYPE_CHECKING:
    from housefly.tasks.api.answers import SentenceAnswer
    from housefly.tasks.api.questions import Sentence
    from housefly.tasks.api.values import ServiceInfo, TaskStatus

_NOTHING_FLIES = "that needs a running room, and none is running"


def answer_offline(options: Namespace, sentence: Sentence) -> SentenceAnswer:
    """Answer a question from the memory of a site.

    Raises TaskError for a wish: nothing can fly.
    """
    from housefly.hub.client.room_queries import AskedRoom
    from housefly.sites.loaded_site import open_site
    from housefly.tasks.api.json import task_question_from_json, task_question_to_json
    from housefly.tasks.intents.names import names_of_room
    from housefly.tasks.service.sentences import SentenceEffects, Sentences

    task_question_from_json(task_question_to_json(sentence))  # refuses what cannot be
    names = names_of_room(open_site(asked_site(options)).room)
    effects = SentenceEffects(_refuse, _refuse, _refuse, _refuse, _refuse)
    with remembered_room(options) as memory:
        room = AskedRoom(memory.ask)
        return Sentences(room, effects, time.time, names, has_drone=False).answer(sentence)


def shipped_services(options: Namespace) -> tuple[ServiceInfo, ...]:
    """Return what can be asked for in a site."""
    from housefly.tasks.document.open_library import OpenLibrary

    site = asked_site(options)
    own = Path(site.tasks.documents) if site.tasks.documents else None
    return OpenLibrary(own, has_drone=bool(site.drone_names), has_camera=site.has_camera).services()


def kept_tasks(options: Namespace, since: float) -> tuple[TaskStatus, ...]:
    """Return the tasks of a site that were asked for since a time [Unix time, s], newest first."""
    from housefly.config.state import tasks_folder
    from housefly.tasks.api.questions import TaskHistoryQuestion
    from housefly.tasks.scheduler.task_store import TASK_FILE, TaskStore

    file = tasks_folder(asked_site(options)) / TASK_FILE
    if not file.exists():
        return ()
    store = TaskStore(file)
    try:
        return store.history(TaskHistoryQuestion(since, limit=1000))
    finally:
        store.close()


def _refuse(*_: Any, **__: Any) -> NoReturn:
    from housefly.tasks.api.values import ReasonCode

    raise TaskError(_NOTHING_FLIES, ReasonCode.NOT_READY.value)
