"""Random task documents for property tests: values that make sense, of every kind of step."""

from __future__ import annotations

from hypothesis import strategies as st

from housefly.tasks.api.values import Confirm, OnPreempt
from housefly.tasks.document.argument_checks import UNIT_OF
from housefly.tasks.document.parameters import ParameterType, TaskParameter
from housefly.tasks.document.step_forms import CONDITION_FORMS, FORMS, ArgumentType, StepArgument
from housefly.tasks.document.steps import (
    ConditionKind,
    ParameterUse,
    StepKind,
    TaskCondition,
    TaskStep,
)
from housefly.tasks.document.task_document import TaskDocument
from housefly.tasks.document.templates import escaped

names = st.from_regex(r"[a-z][a-z0-9_]{0,8}", fullmatch=True).filter(lambda name: name != "each")
letters = st.characters(codec="utf-8", categories=("L", "N", "P", "S", "Zs"))
words = (
    st.text(letters, min_size=1, max_size=30)
    .map(lambda text: "".join(c for c in text if c.isprintable()))
    .filter(lambda text: text.strip() == text != "")
)
PARAMETERS = (
    TaskParameter("subject", ParameterType.PLACE_OR_THING, "what", required=True),
    TaskParameter("who", ParameterType.PERSON, default="the resident"),
    TaskParameter("time", ParameterType.NUMBER, unit="s", low=1.0, high=50.0, default=5.0),
    TaskParameter("how", ParameterType.CHOICE, of=("near", "yes"), default="yes"),
    TaskParameter("loud", ParameterType.FLAG, default=False),
    TaskParameter("rooms", ParameterType.PLACES, default="a, b"),
    TaskParameter("note", ParameterType.TEXT, required=False),
)
_MADE_OF = (ConditionKind.NOT, ConditionKind.ALL, ConditionKind.ANY)
_templates = st.one_of(
    words.map(escaped), st.just("$subject"), words.map(lambda text: f"{escaped(text)} $note")
)


def _number(argument: StepArgument) -> st.SearchStrategy[object]:
    low, high = argument.low, min(argument.high, 1000.0)
    if argument.type is ArgumentType.COUNT:
        return st.integers(int(low), int(high)).map(float)
    return st.floats(low, high, allow_nan=False)


def _value(argument: StepArgument) -> st.SearchStrategy[object]:
    kind = argument.type
    if kind is ArgumentType.CONDITION:
        return conditions
    if kind is ArgumentType.CHOICE:
        return st.sampled_from(argument.of)
    if kind is ArgumentType.TIME and argument.low <= 1.0:
        return st.one_of(_number(argument), st.just(ParameterUse("time")))
    if kind in UNIT_OF:
        return _number(argument)
    simple: dict[ArgumentType, st.SearchStrategy[object]] = {
        ArgumentType.SUBJECT: st.one_of(words.map(escaped), st.just("$subject")),
        ArgumentType.TEXT: _templates,
        ArgumentType.WORDS: st.lists(words.map(escaped), min_size=1, max_size=3).map(tuple),
        ArgumentType.NAME: names,
        ArgumentType.FLAG: st.booleans(),
        ArgumentType.NAMES: st.one_of(
            st.lists(words.map(escaped), min_size=1, max_size=3).map(tuple),
            st.just(ParameterUse("rooms")),
            st.just("every place"),
        ),
        ArgumentType.GIVEN: st.dictionaries(names, words.map(escaped), max_size=2),
        ArgumentType.POINT: st.tuples(*[st.floats(-20.0, 20.0)] * 2),
    }
    return simple[kind]


@st.composite
def _simple_conditions(draw: st.DrawFn) -> TaskCondition:
    kind = draw(st.sampled_from([ConditionKind.IS, ConditionKind.SET, ConditionKind.PARAMETER,
                                 ConditionKind.STALE, ConditionKind.DOUBTFUL]))  # fmt: skip
    if kind is ConditionKind.SET:
        return TaskCondition(kind, {"name": draw(st.sampled_from([p.name for p in PARAMETERS]))})
    if kind is ConditionKind.PARAMETER:
        return TaskCondition(
            kind, {"name": "how", "equals": draw(st.sampled_from(["near", "yes"]))}
        )
    given = {
        a.name: draw(_value(a)) for a in CONDITION_FORMS[kind] if a.required or draw(st.booleans())
    }
    return TaskCondition(kind, given)  # type: ignore[arg-type]


conditions: st.SearchStrategy[TaskCondition] = st.recursive(
    _simple_conditions(),
    lambda inner: st.builds(
        lambda kind, parts: TaskCondition(kind, parts=parts[:1] if kind is _MADE_OF[0] else parts),
        st.sampled_from(_MADE_OF),
        st.lists(inner, min_size=1, max_size=3).map(tuple),
    ),
    max_leaves=4,
)


@st.composite
def _leaf(draw: st.DrawFn) -> TaskStep:
    kinds = [k for k, form in FORMS.items() if not form.blocks and k is not StepKind.CALL]
    kind = draw(st.sampled_from(kinds))
    arguments = {
        each.name: draw(_value(each))
        for each in FORMS[kind].arguments
        if each.name != "otherwise" and (each.required or draw(st.booleans()))
    }
    if kind is StepKind.GO_TO:
        arguments = {"point": (1.5, 2.0)} if draw(st.booleans()) else {"subject": "$subject"}
    if kind is StepKind.RECORD:
        arguments["time"] = draw(st.floats(0.5, 100.0))
    return TaskStep(kind, arguments, **draw(_extras()))  # type: ignore[arg-type]


@st.composite
def _extras(draw: st.DrawFn) -> dict[str, object]:
    if draw(st.booleans()):
        return {}
    return {
        "name": draw(st.one_of(st.just(""), words)),
        "timeout": draw(st.one_of(st.none(), st.floats(0.1, 900.0))),
        "may_fail": draw(st.booleans()),
    }


@st.composite
def _composed(draw: st.DrawFn, inner: st.SearchStrategy[TaskStep]) -> TaskStep:
    kinds = [kind for kind, form in FORMS.items() if form.blocks and kind is not StepKind.PARALLEL]
    kind = draw(st.sampled_from(kinds))
    form = FORMS[kind]
    arguments = {a.name: draw(_value(a)) for a in form.arguments if a.required}
    block = st.lists(inner, min_size=1, max_size=3).map(tuple)
    words_ = [*form.blocks, *[word for word in form.more_blocks if draw(st.booleans())]]
    extras = draw(_extras())
    if kind is StepKind.TIMEOUT:
        extras.pop("timeout", None)
    return TaskStep(kind, arguments, {word: draw(block) for word in words_}, **extras)  # type: ignore[arg-type]


steps: st.SearchStrategy[TaskStep] = st.recursive(_leaf(), _composed, max_leaves=6)
documents: st.SearchStrategy[TaskDocument] = st.builds(
    TaskDocument,
    name=names,
    title=words,
    about=st.one_of(st.just(""), words),
    parameters=st.just(PARAMETERS),
    steps=st.lists(steps, min_size=1, max_size=4).map(tuple),
    on_cancel=st.lists(_leaf(), min_size=1, max_size=2).map(tuple),
    confirm=st.sampled_from(Confirm),
    on_preempt=st.sampled_from(OnPreempt),
    time_limit=st.one_of(st.none(), st.floats(1.0, 86400.0)),
    overrides=st.booleans(),
)
"""Documents whose steps use the parameters in PARAMETERS."""
