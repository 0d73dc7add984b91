"""The questions to the tasks as methods of asyncio: those of ``TaskQueries``, to be awaited."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

from housefly.tasks.api.answers import (
    RehearsalAnswer,
    SentenceAnswer,
    ServicesAnswer,
    TaskBoard,
    TasksAnswer,
)
from housefly.tasks.api.questions import (
    BoardQuestion,
    CancelTask,
    ContinueTask,
    PauseTask,
    RehearseTask,
    ReplyToTask,
    RequestTask,
    Sentence,
    ServicesQuestion,
    TaskHistoryQuestion,
    TaskQuestion,
)
from housefly.tasks.api.values import (
    ParameterValue,
    RehearsalReport,
    RequestSurface,
    ServiceInfo,
    TaskStatus,
)

_SURFACE = RequestSurface.COMMAND_LINE


class AsyncTaskQueries(ABC):
    """Asks the tasks of one room; ``by`` says who wants it, in words."""

    by: str = "a program"

    @abstractmethod
    async def ask_tasks(self, question: TaskQuestion) -> Any:
        """Return the answer; raises TaskError, with its reason code, when it is refused."""

    async def request(
        self, service: str, drone: str = "", /, **parameters: ParameterValue
    ) -> TaskStatus:
        """Ask for a service: ``request("look", subject="refrigerator")``; return its task.

        With the name of a drone behind the service it flies, else whichever is free and nearest.
        """
        asked = RequestTask(service, parameters, self.by, _SURFACE, drone=drone)
        answer: TasksAnswer = await self.ask_tasks(asked)
        return answer.tasks[0]

    async def rehearse(self, service: str, **parameters: ParameterValue) -> RehearsalReport:
        """Rehearse a service in lock step; nothing flies."""
        question = RehearseTask(service, parameters, surface=_SURFACE)
        answer: RehearsalAnswer = await self.ask_tasks(question)
        return answer.rehearsal

    async def say(self, text: str, language: str = "en") -> SentenceAnswer:
        """Say a sentence in "en", "de" or "ja": it is answered, or starts a task."""
        # The language is checked where the question is read.
        question = Sentence(text, language, self.by, _SURFACE)  # type: ignore[arg-type]
        answer: SentenceAnswer = await self.ask_tasks(question)
        return answer

    async def tasks(self) -> TaskBoard:
        """Return what flies, what waits and what ended lately."""
        board: TaskBoard = await self.ask_tasks(BoardQuestion())
        return board

    async def services(self) -> tuple[ServiceInfo, ...]:
        """Return what can be asked for."""
        answer: ServicesAnswer = await self.ask_tasks(ServicesQuestion())
        return answer.services

    async def task_history(
        self, since: float = 0.0, service: str = "", limit: int = 50
    ) -> tuple[TaskStatus, ...]:
        """Return the tasks asked for since a time [Unix time, s], the newest first."""
        answer: TasksAnswer = await self.ask_tasks(
            TaskHistoryQuestion(since, service=service, limit=limit)
        )
        return answer.tasks

    async def cancel(self, task: int = 0) -> tuple[TaskStatus, ...]:
        """End a task, by its number; 0 ends every open one. Return those that it concerned."""
        answer: TasksAnswer = await self.ask_tasks(CancelTask(task, self.by))
        return answer.tasks

    async def pause(self, task: int) -> TaskStatus:
        """Let the drone hover where it is until the task is continued."""
        answer: TasksAnswer = await self.ask_tasks(PauseTask(task, self.by))
        return answer.tasks[0]

    async def proceed(self, task: int) -> TaskStatus:
        """Go on with a paused task."""
        answer: TasksAnswer = await self.ask_tasks(ContinueTask(task, self.by))
        return answer.tasks[0]

    async def reply(self, task: int, choice: str, question: str = "confirm") -> TaskStatus:
        """Answer a question of a task; "confirm" is whether it may begin."""
        answer: TasksAnswer = await self.ask_tasks(ReplyToTask(task, question, choice, self.by))
        return answer.tasks[0]
