"""Binds a document to parameters: what is left is a task that can run."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from housefly.errors import TaskError
from housefly.tasks.api.values import ParameterValue, ReasonCode
from housefly.tasks.document.argument_checks import (
    FITTING,
    LIST_MAX,
    UNIT_OF,
    number_fault,
)
from housefly.tasks.document.parameters import TaskParameter, checked_parameters
from housefly.tasks.document.step_forms import (
    CONDITION_FORMS,
    EVERY,
    FORMS,
    ArgumentType,
    StepArgument,
)
from housefly.tasks.document.step_parser import EACH, shared_reply, words_of_shared
from housefly.tasks.document.steps import (
    ArgumentValue,
    ConditionKind,
    ParameterUse,
    StepKind,
    TaskCondition,
    TaskStep,
)
from housefly.tasks.document.task_document import BoundTask, TaskDocument
from housefly.tasks.document.templates import escaped, names_in, with_values

STEPS_MAX = 1_000
"""Most steps of a bound task, those of called tasks and of for_each counted each time."""
_TRUE, _FALSE = TaskCondition(ConditionKind.ALL), TaskCondition(ConditionKind.ANY)


def bind(document: TaskDocument, parameters: Mapping[str, ParameterValue]) -> BoundTask:
    """Return the task that a document is with these parameters.

    Raises:
        TaskError: BAD_PARAMETER; says which one and what is allowed.
    """
    values = checked_parameters(document.parameters, parameters)
    scope = {name: escaped(v) if isinstance(v, str) else v for name, v in values.items()}
    binder = _Binder(document, scope, _Budget())
    return BoundTask(
        service=document.name,
        title=document.title,
        parameters=values,
        steps=binder.steps(document.steps),
        on_cancel=binder.steps(document.on_cancel),
        flies=document.flies,
        confirm=document.confirm,
        on_preempt=document.on_preempt,
        time_limit=document.time_limit,
    )


@dataclass(slots=True)
class _Budget:
    left: int = STEPS_MAX


class _Binder:
    def __init__(
        self, document: TaskDocument, scope: dict[str, ParameterValue], budget: _Budget
    ) -> None:
        self._document, self._scope, self._budget = document, scope, budget
        self._parameters = {parameter.name: parameter for parameter in document.parameters}

    def steps(self, steps: tuple[TaskStep, ...]) -> tuple[TaskStep, ...]:
        return tuple(self._step(step) for step in steps)

    def _step(self, step: TaskStep) -> TaskStep:
        self._budget.left -= 1
        if self._budget.left < 0:
            raise self._error(step, f"more than {STEPS_MAX} steps in all")
        if step.kind is StepKind.CALL:
            return self._called(step)
        if step.kind is StepKind.FOR_EACH:
            return self._for_each(step)
        timeout = step.timeout
        if isinstance(timeout, ParameterUse):
            value = self._scope.get(timeout.name)
            timeout = value if isinstance(value, float) else None
        bound = replace(
            step,
            arguments=self._arguments(FORMS[step.kind].arguments, step.arguments, step),
            blocks={word: self.steps(block) for word, block in step.blocks.items()},
            name=step.name,
            timeout=timeout,
        )
        if step.kind is StepKind.PARALLEL and (name := shared_reply(bound)):
            raise self._error(step, words_of_shared(name))  # of called tasks
        return bound

    def _called(self, step: TaskStep) -> TaskStep:
        name = str(step.arguments["task"])
        called = self._document.calls.get(name)
        if called is None:
            raise self._error(step, f"there is no task {name!r} to call")
        given = step.arguments.get("with", {})
        assert isinstance(given, dict)
        scope = self._given_scope(called, given, step)
        inside = _Binder(called, scope, self._budget).steps(called.steps)
        return replace(step, kind=StepKind.SEQUENCE, arguments={}, blocks={"": inside})

    def _given_scope(
        self, called: TaskDocument, given: Mapping[str, ParameterValue], step: TaskStep
    ) -> dict[str, ParameterValue]:
        """Return the parameters of a called task; what a step finds later stays open."""
        texts = {n: self._filled(v) if isinstance(v, str) else v for n, v in given.items()}
        is_open = {n for n, v in texts.items() if isinstance(v, str) and names_in(v)}
        closed = {n: v for n, v in texts.items() if n not in is_open}
        known = tuple(replace(p, required=False) if p.name in is_open else p
                      for p in called.parameters)  # fmt: skip
        try:
            values = checked_parameters(known, closed)
            for parameter in called.parameters:
                if parameter.name in is_open:
                    _check_open(parameter)
        except TaskError as error:
            raise self._error(step, f"call {called.name}: {error}") from None
        scope = {n: escaped(v) if isinstance(v, str) else v for n, v in values.items()}
        return {**scope, **{name: texts[name] for name in is_open}}

    def _for_each(self, step: TaskStep) -> TaskStep:
        of = step.arguments["of"]
        text = str(self._scope.get(of.name, "")) if isinstance(of, ParameterUse) else of
        if text in EVERY:
            once = {"do": self.steps(step.blocks["do"])}
            return replace(step, arguments={"of": str(text)}, blocks=once)
        names: tuple[str, ...]
        if isinstance(text, str):
            names = tuple(name.strip() for name in text.split(",") if name.strip())
        else:
            names = tuple(self._filled(str(each)) for each in of) if isinstance(of, tuple) else ()
        if len(names) > LIST_MAX:
            raise self._error(step, f"of: {len(names)} names; allowed: {LIST_MAX}")
        rounds = []
        for name in names:
            inside = _Binder(self._document, {**self._scope, EACH: name}, self._budget)
            block = inside.steps(step.blocks["do"])
            rounds.append(TaskStep(StepKind.SEQUENCE, {}, {"": block}, line=step.line))
        return replace(step, kind=StepKind.SEQUENCE, arguments={}, blocks={"": tuple(rounds)})

    def _arguments(
        self,
        known: tuple[StepArgument, ...],
        given: dict[str, ArgumentValue],
        step: TaskStep,
    ) -> dict[str, ArgumentValue]:
        found: dict[str, ArgumentValue] = {}
        for argument in known:
            value = self._argument(argument, given.get(argument.name, argument.default), step)
            if value is not None:
                found[argument.name] = value
        return found

    def _argument(
        self, argument: StepArgument, value: ArgumentValue | None, step: TaskStep
    ) -> ArgumentValue | None:
        if isinstance(value, TaskCondition):
            return self._condition(value, step)
        if isinstance(value, ParameterUse):
            return self._used(argument, self._scope.get(value.name), step)
        if isinstance(value, str):
            return self._filled(value)
        if isinstance(value, tuple) and value and isinstance(value[0], str):
            return tuple(self._filled(str(each)) for each in value)
        return value

    def _used(
        self, argument: StepArgument, value: ParameterValue | None, step: TaskStep
    ) -> ArgumentValue | None:
        if value is None:
            return argument.default
        if argument.type in UNIT_OF:
            number = value if isinstance(value, float) else None
            if fault := number_fault(argument, number):
                raise self._error(step, f"{argument.name}: {value} given; {fault}")
        elif argument.type is ArgumentType.CHOICE and value not in argument.of:
            raise self._error(step, f"{argument.name}: allowed: {', '.join(argument.of)}")
        elif argument.type is ArgumentType.WORDS:
            return tuple(each.strip() for each in str(value).split(",") if each.strip())
        return value

    def _condition(self, condition: TaskCondition, step: TaskStep) -> TaskCondition:
        """Return the condition; what it asks of parameters is answered here."""
        kind, arguments = condition.kind, condition.arguments
        if condition.parts:
            return replace(
                condition, parts=tuple(self._condition(part, step) for part in condition.parts)
            )
        if kind is ConditionKind.SET and arguments["name"] in self._parameters:
            value = self._scope.get(str(arguments["name"]))
            is_open = isinstance(value, str) and bool(names_in(value))
            if is_open:
                return TaskCondition(kind, {"name": names_in(str(value))[0]})
            return _TRUE if value not in (None, "", False) else _FALSE
        if kind is ConditionKind.PARAMETER:
            name = str(arguments["name"])
            wanted = self._parameters[name].checked(str(arguments["equals"]))
            wanted = escaped(wanted) if isinstance(wanted, str) else wanted
            return _TRUE if self._scope.get(name) == wanted else _FALSE
        known = CONDITION_FORMS.get(kind, ())
        return replace(condition, arguments=self._arguments(known, arguments, step))

    def _filled(self, text: str) -> str:
        return with_values(text, self._value)

    def _value(self, name: str) -> str | None:
        if name in self._scope:
            return _words(self._scope[name])
        return "" if name in self._parameters else None

    def _error(self, step: TaskStep, problem: str) -> TaskError:
        where = f"{self._document.name}, line {step.line}" if step.line else self._document.name
        return TaskError(f"{where}: {problem}", ReasonCode.BAD_PARAMETER.value)


def _check_open(parameter: TaskParameter) -> None:
    """Raise TaskError when a parameter cannot take what is known only on the way."""
    if parameter.type not in FITTING[ArgumentType.SUBJECT]:
        raise TaskError(
            f"{parameter.name}: {parameter.allowed()}, known before it starts",
            ReasonCode.BAD_PARAMETER.value,
        )


def _words(value: ParameterValue) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:g}" if isinstance(value, float) else value
