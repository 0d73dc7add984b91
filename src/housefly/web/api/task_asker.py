"""Who asks something of the tasks, and what the server makes of it: name, surface, a yes first."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from housefly.tasks.api.questions import CancelTask, RequestTask, Sentence, TaskQuestion
from housefly.tasks.api.values import Confirm, Priority, RequestSurface
from housefly.web.access.roles import Role

OWN_SURFACES = (RequestSurface.HTTP, RequestSurface.COMMAND_LINE, RequestSurface.ASSISTANT)
"""What a program with the key of the run may say that it is; without a word it is the first."""
MAX_NAME = 200
PROGRAM = "program"
"""Id of whoever has the key of the run: what programs say of themselves proves nothing."""


@dataclass(frozen=True, slots=True)
class TaskAsker:
    """Somebody who asks.

    Attributes:
        name: shown to everybody and kept with the task.
        role: what they may do.
        surface: where they ask.
        session: name of their session, for the audit log; "" for a program.
        counted_as: id of whose requests and tasks are counted together; two people of the same
            name have two.
        cause: what made them ask, where a program says so.
    """

    name: str
    role: Role
    surface: RequestSurface
    session: str
    counted_as: str
    cause: str = ""


def program_asking(given: dict[str, Any]) -> TaskAsker:
    """Return who asks with the key of this run, and take what it says of itself from the body.

    Raises:
        ValueError: it says what no program is.
    """
    name, surface = given.pop("by", ""), given.pop("surface", OWN_SURFACES[0].value)
    cause = given.pop("cause", "")
    for field, what, text in (("by", "who asks", name), ("cause", "what made it ask", cause)):
        if not isinstance(text, str) or len(text) > MAX_NAME or not text.isprintable():
            raise ValueError(f"{field}: {what}, as text of up to {MAX_NAME} letters")
    own = {one.value: one for one in OWN_SURFACES}
    if surface not in own:
        raise ValueError(f"surface: one of {', '.join(own)}")
    return TaskAsker(name or "a program", Role.ADMIN, own[surface], "", PROGRAM, cause)


def filled_in(question: TaskQuestion, asker: TaskAsker) -> TaskQuestion:
    """Return a question with who asks; whoever may not fly, and every assistant, needs a yes."""
    known: dict[str, Any] = {
        "by": asker.name,
        "surface": asker.surface,
        "cause": asker.cause,
        "may_fly": not needs_a_yes(asker),
        "owner": asker.counted_as,
    }
    fields = {name: value for name, value in known.items() if hasattr(question, name)}
    told = replace(question, **fields) if fields else question
    if isinstance(told, RequestTask | Sentence) and needs_a_yes(asker):
        told = replace(told, confirm=Confirm.ASK)
        if isinstance(told, RequestTask) and told.priority is Priority.ALARM:
            told = replace(told, priority=Priority.PERSON)
    if isinstance(told, CancelTask) and not asker.role.includes(Role.FLY):
        told = replace(told, only_of=asker.counted_as)
    return told


def needs_a_yes(asker: TaskAsker) -> bool:
    """Return whether what somebody asks for flies only after a person has said yes."""
    return asker.surface is RequestSurface.ASSISTANT or not asker.role.includes(Role.FLY)
