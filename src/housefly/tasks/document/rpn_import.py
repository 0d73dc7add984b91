"""Turns task strings of ROS-TMS into task documents (docs/tasks.md).

What a drone cannot do, such as grasping, is refused by name, or becomes words to people.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from math import isfinite

from housefly.errors import TaskError
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.document.argument_checks import NAME
from housefly.tasks.document.document_parser import read_task
from housefly.tasks.document.parameters import ParameterType, TaskParameter
from housefly.tasks.document.rpn_tree import (
    RpnGroup,
    RpnNode,
    RpnSubtask,
    read_rpn,
    rpn_error,
)
from housefly.tasks.document.step_forms import FORMS
from housefly.tasks.document.steps import (
    ArgumentValue,
    ConditionKind,
    StepKind,
    TaskCondition,
    TaskStep,
)
from housefly.tasks.document.task_document import TaskDocument
from housefly.tasks.document.templates import escaped
from housefly.tasks.document.writer import task_to_yaml

ROOM_MAX = 50.0
"""Coordinates beyond this are millimetres: no room of theirs is so many metres long."""
REQUEST_PARAMETERS: dict[str, TaskParameter] = {
    "oid": TaskParameter("thing", ParameterType.THING, "the object of the request"),
    "uid": TaskParameter("person", ParameterType.PERSON, "who asked"),
    "pid": TaskParameter("place", ParameterType.PLACE, "where to"),
    "rid": TaskParameter("robot", ParameterType.THING, "another robot"),
}
"""What a request of ROS-TMS fills in, and our parameter for it."""
UNABLE: dict[int, str] = {
    9002: "grasp something: a drone has no hand",
    9003: "put something down: a drone has no hand",
    9004: "open something: a drone has no hand",
    9005: "close something: a drone has no hand",
    **dict.fromkeys(range(9100, 9108), "move the nursing bed: no such bed is known here"),
}
"""Subtasks that cannot be done, and why, in words."""
LIGHT_TOPIC = "housefly/light/set"
"""Where a light of the room listens, until the document says otherwise."""


@dataclass(slots=True)
class RpnImport:
    """One conversion.

    Attributes:
        names: what the room calls an id of their database.
        tell: what cannot be done becomes words to people instead of a refusal.
        used: parameters that the task needs, by their word for them.
        notes: what was changed, in words.
    """

    names: Mapping[int, str] = field(default_factory=dict)
    tell: bool = False
    used: dict[str, TaskParameter] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)

    def document(self, text: str, name: str, title: str = "") -> TaskDocument:
        """Return the document of a task string.

        Args:
            text: of the task, as its ``etcdata`` has it.
            name: of the new task.
            title: for people.

        Raises:
            TaskError: BAD_PARAMETER; what cannot be read or done, and why.
        """
        if not NAME.fullmatch(name):
            raise rpn_error(f"{name[:40]!r} is no name of a task: small letters, digits and _")
        variants = read_rpn(text)
        steps = self._variants(variants)
        required = len(variants) == 1
        parameters = tuple(
            TaskParameter(each.name, each.type, each.about, required=required)
            for each in self.used.values()
        )
        document = TaskDocument(
            name=name,
            title=title or name.replace("_", " "),
            about="Imported from ROS-TMS",
            parameters=parameters,
            steps=(*_in_the_air(steps), *steps, TaskStep(StepKind.RETURN_HOME)),
        )
        return read_task(task_to_yaml(document), f"{name}.yaml")

    def _variants(self, variants: tuple[RpnNode, ...]) -> tuple[TaskStep, ...]:
        """The first variant is done whose first argument the request fills in."""
        steps = self._steps(variants[-1])
        for variant in reversed(variants[:-1]):
            inside = self._steps(variant)
            parameter = REQUEST_PARAMETERS.get(_first_word(variant))
            if parameter is None:
                return inside
            condition = TaskCondition(ConditionKind.SET, {"name": parameter.name})
            steps = (
                TaskStep(StepKind.IF, {"condition": condition}, {"then": inside, "else": steps}),
            )
        return steps

    def _steps(self, node: RpnNode) -> tuple[TaskStep, ...]:
        if isinstance(node, RpnSubtask):
            return (self._step(node),)
        parts = [self._steps(part) for part in node.parts]
        if not node.is_parallel:
            return tuple(step for part in parts for step in part)
        branches = tuple(p[0] if len(p) == 1 else _sequence(p) for p in parts)
        return (TaskStep(StepKind.PARALLEL, {}, {"": branches}),)

    def _step(self, subtask: RpnSubtask) -> TaskStep:
        if subtask.id in UNABLE:
            return self._unable(subtask.id)
        maker = _MAKERS.get(subtask.id)
        if maker is None:
            known = ", ".join(str(each) for each in sorted({*_MAKERS, *UNABLE}))
            raise rpn_error(f"there is no subtask {subtask.id}; known: {known}")
        return maker(self, subtask)

    def _unable(self, number: int) -> TaskStep:
        if not self.tell:
            raise TaskError(
                f"subtask {number} would {UNABLE[number]}; import it with --tell to ask people"
                " for it instead",
                ReasonCode.BAD_PARAMETER.value,
            )
        self.notes.append(f"subtask {number} is told to people: it would {UNABLE[number]}")
        what = UNABLE[number].partition(":")[0]
        return TaskStep(StepKind.SAY, {"words": f"Now somebody has to {what}"})

    def subject(self, word: str, subtask: int) -> str:
        """Return the subject that an argument means: a parameter, or a known id's name."""
        if word in REQUEST_PARAMETERS:
            self.used[word] = REQUEST_PARAMETERS[word]
            return f"${REQUEST_PARAMETERS[word].name}"
        if word.isdecimal() and int(word) in self.names:
            return escaped(self.names[int(word)])
        if word.isdecimal():
            raise rpn_error(
                f"subtask {subtask}: nobody says what {word} is called here; give its name"
            )
        raise rpn_error(
            f"subtask {subtask}: {word[:40]!r}; expected {', '.join(REQUEST_PARAMETERS)} or an id"
        )


def import_rpn(
    text: str,
    name: str,
    title: str = "",
    names: Mapping[int, str] | None = None,
    tell: bool = False,
) -> str:
    """Return a task string of ROS-TMS as the YAML of a task document.

    Args:
        text: such as ``9001$oid 9007$oid + 9001$uid +``.
        name: of the new task.
        title: of the new task, for people.
        names: what the room calls an id of their database.
        tell: what a drone cannot do becomes words to people instead of a refusal.

    Raises:
        TaskError: BAD_PARAMETER; what cannot be read or done, and why.
    """
    conversion = RpnImport(names or {}, tell)
    document = conversion.document(text, name, title)
    lines = ["# From ROS-TMS: " + text.strip(), *(f"# {note}" for note in conversion.notes)]
    return "\n".join(lines) + "\n" + task_to_yaml(document)


def _in_the_air(steps: tuple[TaskStep, ...]) -> tuple[TaskStep, ...]:
    """Return a take-off when the first flight would be a panorama, which is taken in the air."""
    every = (each for step in steps for each in step.every_step())
    first = next((each.kind for each in every if FORMS[each.kind].flies), None)
    return (TaskStep(StepKind.TAKE_OFF),) if first is StepKind.SWEEP else ()


def _sequence(steps: tuple[TaskStep, ...]) -> TaskStep:
    return TaskStep(StepKind.SEQUENCE, {}, {"": steps})


def _first_word(node: RpnNode) -> str:
    while isinstance(node, RpnGroup):
        node = node.parts[0]
    return node.arguments[0] if node.arguments else ""


def _move(task: RpnImport, subtask: RpnSubtask) -> TaskStep:
    """Move: to -1 with x, y and heading, or to whatever has an id; JSON has x and y."""
    words = subtask.arguments
    if subtask.named:
        x, y = _metres(subtask.argument("x")), _metres(subtask.argument("y"))
        return TaskStep(StepKind.GO_TO, {"point": (x, y)})
    if words and words[0] == "-1":
        if len(words) < 3:
            raise rpn_error(f"subtask {subtask.id}: expected -1$x$y$heading")
        if len(words) > 3:
            task.notes.append(f"subtask {subtask.id}: the heading {words[3][:20]} is left out")
        return TaskStep(StepKind.GO_TO, {"point": (_metres(words[1]), _metres(words[2]))})
    if not words or not words[0]:
        raise rpn_error(f"subtask {subtask.id}: expected where to move, such as 9001$pid")
    return TaskStep(StepKind.LOOK_AT, {"subject": task.subject(words[0], subtask.id)})


def _metres(value: str | float | bool | None) -> float:
    try:
        number = float(value) if isinstance(value, (str, int, float)) else float("nan")
    except (ValueError, OverflowError):
        number = float("nan")
    if str(value).startswith("("):
        raise rpn_error(f"{str(value)[:40]} is a value of their blackboard; write a number")
    if not isfinite(number) or abs(number) > 1e6:
        raise rpn_error(f"{str(value)[:40]!r} is no coordinate; expected metres or millimetres")
    return number / 1000.0 if abs(number) > ROOM_MAX else number


def _look_around(task: RpnImport, subtask: RpnSubtask) -> TaskStep:
    """Random move: where the robot drove about, the drone turns and looks about."""
    task.notes.append(f"subtask {subtask.id} (random move) became a panorama")
    return TaskStep(StepKind.SWEEP)


def _picture(task: RpnImport, subtask: RpnSubtask) -> TaskStep:
    words = [word for word in subtask.arguments if word in REQUEST_PARAMETERS]
    shown: dict[str, ArgumentValue] = {}
    if words:
        shown["subject"] = task.subject(words[0], subtask.id)
    return TaskStep(StepKind.SNAPSHOT, shown)


def _light(payload: str) -> Callable[[RpnImport, RpnSubtask], TaskStep]:
    def made(task: RpnImport, subtask: RpnSubtask) -> TaskStep:
        task.notes.append(f"subtask {subtask.id} publishes to {LIGHT_TOPIC}: name your light there")
        return TaskStep(StepKind.PUBLISH, {"topic": LIGHT_TOPIC, "payload": payload})

    return made


def _announce(task: RpnImport, subtask: RpnSubtask) -> TaskStep:
    words = subtask.argument("announce", "text", "words", "message", "data")
    said = str(words) if words is not None else " ".join(subtask.arguments)
    if not said.strip():
        raise rpn_error(f"subtask {subtask.id}: expected what to announce")
    return TaskStep(StepKind.ANNOUNCE, {"words": escaped(said)})


def _wait(task: RpnImport, subtask: RpnSubtask) -> TaskStep:
    given = subtask.argument("time", "sec", "seconds", "duration", "wait")
    word = given if given is not None else (subtask.arguments or ("",))[0]
    try:
        seconds = float(word)
    except (ValueError, OverflowError):
        seconds = -1.0
    if not 0.0 <= seconds <= 3600.0:
        raise rpn_error(f"subtask {subtask.id}: expected a time from 0 to 3600 s")
    return TaskStep(StepKind.WAIT, {"time": seconds})


_MAKERS: dict[int, Callable[[RpnImport, RpnSubtask], TaskStep]] = {
    9001: _move,
    9006: _look_around,
    9007: _picture,
    9200: _light("ON"),
    9201: _light("OFF"),
    9300: _announce,
    9900: _wait,
}
"""Subtasks that a drone or its room can do."""
