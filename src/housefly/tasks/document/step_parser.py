"""Reads the steps and conditions of a document, and says what is wrong with them and where."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from difflib import get_close_matches

from housefly.errors import TaskError
from housefly.tasks.document.argument_checks import (
    FITTING,
    SPEECH_MAX,
    UNIT_OF,
    argument_of,
    number_fault,
    words_of_line,
)
from housefly.tasks.document.marked_yaml import MarkedValue, document_error
from housefly.tasks.document.parameters import TaskParameter
from housefly.tasks.document.step_forms import (
    BLOCK_WORDS,
    CONDITION_FORMS,
    FORMS,
    TIME_MAX,
    ArgumentType,
    StepArgument,
    StepForm,
    default_of,
)
from housefly.tasks.document.steps import (
    ArgumentValue,
    ConditionKind,
    ParameterUse,
    StepKind,
    TaskCondition,
    TaskStep,
)
from housefly.tasks.document.templates import lone_name, names_in, stray_dollar

STEP_WORDS = {kind.value: kind for kind in StepKind}
"""Words that begin a step."""
_CONDITION_WORDS = {kind.value: kind for kind in ConditionKind}
_EVERY_STEP = ("name", "timeout", "may_fail")
_TIMEOUT = StepArgument("timeout", ArgumentType.TIME, "of the step", low=0.1, high=TIME_MAX)
FOUND_NAMES = {
    "ask": ("as",),
    "look_at": ("as",),
    "search": ("as", "ended"),
    "check_people": ("as", "missing", "unsure"),
}
"""Arguments that name what a step finds."""
EACH = "each"
"""The name of the present one inside for_each."""
_GOALS = ({"subject"}, {"point"}, {"x", "y"})
"""What says where to go."""


@dataclass(frozen=True, slots=True)
class StepParser:
    """Reads steps that may use certain names.

    Attributes:
        source: name of the file, for messages.
        parameters: of the document.
        found: names that its steps give to what they find.
    """

    source: str
    parameters: dict[str, TaskParameter]
    found: frozenset[str] = frozenset()

    def steps(self, marked: MarkedValue) -> tuple[TaskStep, ...]:
        """Return a list of steps; raises TaskError BAD_PARAMETER with the line."""
        if not isinstance(marked.value, tuple) or not marked.value:
            raise self.error(marked, "expected a list of steps, each on a line with a dash")
        return tuple(self._step(item) for item in marked.value)

    def error(self, marked: MarkedValue, problem: str) -> TaskError:
        """Return the error for the line of a value."""
        return document_error(self.source, marked.line, problem)

    def unknown(
        self, marked: MarkedValue, what: str, word: str, allowed: Iterable[str]
    ) -> TaskError:
        """Return the error for a word that is not known, with the nearest that is."""
        words = list(allowed)
        near = get_close_matches(word, words, 1)
        hint = f"did you mean {near[0]}? " if near else ""
        known = ", ".join(words) or "none"
        return self.error(marked, f"{what} {word[:60]!r}; {hint}allowed: {known}")

    def _step(self, marked: MarkedValue) -> TaskStep:
        if isinstance(marked.value, tuple):
            return TaskStep(StepKind.SEQUENCE, {}, {"": self.steps(marked)}, line=marked.line)
        tree = marked.value
        if isinstance(tree, str):
            tree = {tree: MarkedValue(marked.line, None)}
        if not isinstance(tree, dict):
            raise self.error(marked, "expected a step, such as look_at: refrigerator")
        word = self._kind_word(marked, tree)
        kind = STEP_WORDS[word]
        form = FORMS[kind]
        others = {key: value for key, value in tree.items() if key != word}
        return self._checked(
            TaskStep(
                kind,
                self._arguments(form.arguments, tree[word], word, bool(form.blocks[:1] == ("",))),
                self._blocks(kind, form, tree[word], others),
                self._own_name(others.get("name")),
                self._timeout(others.get("timeout")),
                self._may_fail(others.get("may_fail")),
                marked.line,
            ),
            marked,
        )

    def _kind_word(self, marked: MarkedValue, tree: dict[str, MarkedValue]) -> str:
        words = [word for word in tree if word in STEP_WORDS]
        if len(words) == 2 and "timeout" in words:  # here it is the timeout of the other
            words.remove("timeout")
        if len(words) == 1:
            return words[0]
        if words:
            raise self.error(marked, f"two steps in one: {', '.join(words)}; give each a dash")
        strange = [w for w in tree if w not in _EVERY_STEP and w not in BLOCK_WORDS]
        raise self.unknown(marked, "there is no step", (strange or [""])[0], STEP_WORDS)

    def _blocks(
        self, kind: StepKind, form: StepForm, value: MarkedValue, others: dict[str, MarkedValue]
    ) -> dict[str, tuple[TaskStep, ...]]:
        inside = self
        if kind is StepKind.FOR_EACH:
            inside = StepParser(self.source, self.parameters, self.found | {EACH})
        blocks = {}
        if form.blocks == ("",):
            blocks[""] = self.steps(value)
        named = [word for word in (*form.blocks, *form.more_blocks) if word]
        for key, item in others.items():
            if key in _EVERY_STEP and not (key == "timeout" and kind is StepKind.TIMEOUT):
                continue
            if key not in named:
                raise self.unknown(item, f"{kind.value} has no", key, (*named, *_EVERY_STEP))
            blocks[key] = inside.steps(item)
        for word in form.blocks:
            if word not in blocks:
                raise self.error(value, f"{kind.value} needs steps under {word}:")
        return {word: blocks[word] for word in ("", *named) if word in blocks}

    def _arguments(
        self,
        known: tuple[StepArgument, ...],
        value: MarkedValue,
        word: str,
        is_block: bool,
    ) -> dict[str, ArgumentValue]:
        if is_block:
            return {}
        by_name = {argument.name: argument for argument in known}
        given: dict[str, MarkedValue] = {}
        main = known[0] if known else None
        if isinstance(value.value, dict) and not (main and main.type is ArgumentType.CONDITION):
            given = value.value
        elif value.value is not None or value.text:
            if main is None:
                raise self.error(value, f"{word} takes nothing")
            given = {main.name: value}
        for name, item in given.items():
            if name not in by_name:
                raise self.unknown(item, f"{word} has no", name, by_name)
        for argument in known:
            if argument.required and argument.name not in given:
                what = f"{argument.about}: {argument.type.value}"
                raise self.error(value, f"{word} needs {argument.name} ({what})")
        return {name: self._argument(by_name[name], item) for name, item in given.items()}

    def _argument(self, argument: StepArgument, marked: MarkedValue) -> ArgumentValue:
        if argument.type is ArgumentType.CONDITION:
            return self._condition(marked)
        value = argument_of(argument, marked)
        if value is None:
            allowed = ", ".join(argument.of) or argument.type.value
            limit = (
                f" of at most {SPEECH_MAX} letters" if argument.type is ArgumentType.TEXT else ""
            )
            raise self.error(marked, f"{argument.name}: expected {allowed}{limit}")
        self._check_names(argument, value, marked)
        if argument.type in UNIT_OF and isinstance(value, float):
            fault = number_fault(argument, value)
            if fault:
                raise self.error(marked, f"{argument.name}: {fault}")
        return value

    def _check_names(
        self, argument: StepArgument, value: ArgumentValue, marked: MarkedValue
    ) -> None:
        if isinstance(value, ParameterUse):
            self._check_use(argument, value.name, marked)
            return
        for text in _texts(value):
            if stray_dollar(text):
                raise self.error(marked, f"{argument.name}: write $$ for a dollar sign")
            is_name = argument.type is ArgumentType.SUBJECT and lone_name(text)
            for name in names_in(text):
                if is_name and name in self.parameters:
                    self._check_use(argument, name, marked)
                elif name not in self.parameters and name not in self.found:
                    raise self._no_name(name, marked)

    def _check_use(self, argument: StepArgument, name: str, marked: MarkedValue) -> None:
        if name not in self.parameters:
            raise self._no_name(name, marked)
        type_, fitting = self.parameters[name].type, FITTING.get(argument.type, frozenset())
        unit, wanted = self.parameters[name].unit, UNIT_OF.get(argument.type, "")
        if type_ not in fitting or (argument.type in UNIT_OF and unit != wanted):
            raise self.error(
                marked, f"{argument.name}: ${name} does not fit; expected {argument.type.value}"
            )

    def _no_name(self, name: str, marked: MarkedValue) -> TaskError:
        return self.unknown(
            marked, "there is no", f"${name}", [f"${n}" for n in (*self.parameters, *self.found)]
        )

    def _condition(self, marked: MarkedValue) -> TaskCondition:
        if not isinstance(marked.value, dict) or len(marked.value) != 1:
            words = ", ".join(_CONDITION_WORDS)
            raise self.error(
                marked, "expected one condition, such as {is: {thing: fridge, state: open}};"
                f" allowed: {words}",
            )  # fmt: skip
        ((word, value),) = marked.value.items()
        if word not in _CONDITION_WORDS:
            raise self.unknown(marked, "there is no condition", word, _CONDITION_WORDS)
        kind = _CONDITION_WORDS[word]
        if kind is ConditionKind.NOT:
            return TaskCondition(kind, parts=(self._condition(value),))
        if kind in (ConditionKind.ALL, ConditionKind.ANY):
            if not isinstance(value.value, tuple) or not value.value:
                raise self.error(value, f"{word}: expected a list of conditions")
            return TaskCondition(kind, parts=tuple(self._condition(i) for i in value.value))
        condition = TaskCondition(kind, self._arguments(CONDITION_FORMS[kind], value, word, False))
        self._check_condition(condition, value)
        return condition

    def _check_condition(self, condition: TaskCondition, marked: MarkedValue) -> None:
        arguments = condition.arguments
        if condition.kind is ConditionKind.SET:
            if (name := str(arguments["name"])) not in {*self.parameters, *self.found}:
                raise self._no_name(name, marked)
        elif condition.kind is ConditionKind.REPLY:
            if (name := str(arguments.get("to", "reply"))) not in self.found:
                raise self.unknown(marked, "no step asks for the reply", name, self.found)
        elif condition.kind is ConditionKind.PARAMETER:
            if (name := str(arguments["name"])) not in self.parameters:
                raise self._no_name(name, marked)
            try:
                self.parameters[name].checked(str(arguments["equals"]))
            except TaskError as error:
                raise self.error(marked, str(error)) from None

    def _checked(self, step: TaskStep, marked: MarkedValue) -> TaskStep:
        arguments = step.arguments
        if step.kind is StepKind.GO_TO and set(arguments) not in _GOALS:
            raise self.error(marked, "go_to needs a subject, a point, or x and y, one of them")
        if step.kind is StepKind.RECORD and not arguments.get("time") and not step.blocks:
            raise self.error(marked, "record needs a time, or steps under do:")
        if step.kind is StepKind.ASK:
            choices = arguments.get("choices", ("yes", "no"))
            otherwise = arguments.get("otherwise")
            if isinstance(choices, tuple) and otherwise is not None and otherwise not in choices:
                raise self.error(marked, f"otherwise: allowed: {', '.join(map(str, choices))}")
        if step.kind is StepKind.PARALLEL:
            branches = sum(_flies(branch) for branch in step.blocks[""])
            if branches > 1:
                raise self.error(marked, "only one of the parallel steps may move the drone")
            if name := shared_reply(step):
                raise self.error(marked, words_of_shared(name))
        return step

    def _own_name(self, marked: MarkedValue | None) -> str:
        if marked is None:
            return ""
        words = words_of_line(marked)
        if not words or len(words) > 80:
            raise self.error(marked, "name: expected at most 80 printable letters")
        return words

    def _timeout(self, marked: MarkedValue | None) -> float | ParameterUse | None:
        if marked is None:
            return None
        value = self._argument(_TIMEOUT, marked)
        return value if isinstance(value, (ParameterUse, float)) else None

    def _may_fail(self, marked: MarkedValue | None) -> bool:
        if marked is None:
            return False
        if not isinstance(marked.value, bool):
            raise self.error(marked, "may_fail: expected true or false")
        return marked.value


def names_found(marked: MarkedValue) -> frozenset[str]:
    """Return the names that the steps in a value give to what they find."""
    found: set[str] = set()
    if isinstance(marked.value, tuple):
        found.update(*(names_found(item) for item in marked.value))
    elif isinstance(marked.value, dict):
        for key, item in marked.value.items():
            found |= _given_by(key, item.value if isinstance(item.value, dict) else {})
            found |= names_found(item)
    else:
        found |= _given_by(marked.text, {})
    return frozenset(found)


def shared_reply(step: TaskStep) -> str:
    """Return a name that questions in two parallel blocks give to their replies, or ""."""
    usual = default_of(StepKind.ASK, "as")
    replies = [
        {str(each.arguments.get("as", usual)) for each in block.every_step() if _asks(each)}
        for block in step.blocks[""]
    ]
    found: set[str] = set()
    for names in replies:
        if both := found & names:
            return min(both)
        found |= names
    return ""


def words_of_shared(name: str) -> str:
    """Return what is wrong with parallel questions that share the name of their reply."""
    return f"two parallel questions name their reply {name!r}: give each its own as:"


def _given_by(word: str, tree: dict[str, MarkedValue]) -> set[str]:
    """Return the names that a step gives, its defaults included."""
    found = set()
    for name in FOUND_NAMES.get(word, ()):
        default = default_of(STEP_WORDS[word], name)
        found.add(tree[name].text if name in tree else str(default))
    return found


def _texts(value: ArgumentValue) -> tuple[str, ...]:
    if isinstance(value, dict):
        value = tuple(item for item in value.values() if isinstance(item, str))
    if isinstance(value, tuple):
        return tuple(item for item in value if isinstance(item, str))
    return (value,) if isinstance(value, str) else ()


def _asks(step: TaskStep) -> bool:
    return step.kind is StepKind.ASK


def _flies(step: TaskStep) -> bool:
    return any(FORMS[each.kind].flies or each.kind is StepKind.CALL for each in step.every_step())
