"""Tells the rules with what a person may set in them, and changes them beside their file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from housefly.errors import TaskError, ThingError
from housefly.hub.api.questions import WhereQuestion
from housefly.hub.client.room_queries import AskedRoom
from housefly.tasks.api.answers import RulesAnswer, RuleStatus
from housefly.tasks.api.questions import ChangeRule
from housefly.tasks.api.values import ParameterInfo, ReasonCode, ServiceInfo
from housefly.tasks.document.parameters import checked_parameters
from housefly.tasks.document.task_document import TaskDocument
from housefly.tasks.rules.rule import Rule
from housefly.tasks.rules.rule_change import RuleChange, changed, is_reference
from housefly.tasks.rules.rule_service import RuleService

_NAMES = ("place", "thing", "place_or_thing", "person")
"""Types of parameters whose value the room must know."""


class RuleDesk:
    """Answers about rules, and takes changes of people who run the house.

    Args:
        rules: the rules of the house.
        library: documents of the services, by name.
        room: knows places, things and people.
    """

    def __init__(
        self, rules: RuleService, library: Mapping[str, TaskDocument], room: AskedRoom
    ) -> None:
        self._rules, self._library, self._room = rules, library, room

    def answer(self, question: object = None) -> RulesAnswer:
        """Return the rules, with the title of each service and what may be set."""
        by_name = {rule.name: rule for rule in self._rules.engine.rules}
        return RulesAnswer(
            tuple(
                self._told(status, by_name[status.name]) if status.when else status
                for status in self._rules.rules_answer().rules
            )
        )

    def change(self, question: ChangeRule) -> RulesAnswer:
        """Change a rule, and keep that over a restart.

        Raises:
            TaskError: BAD_PARAMETER; there is no such rule, or it cannot be so.
            StoreError: the disk refuses.
        """
        rule = next((one for one in self._rules.written if one.name == question.rule), None)
        if rule is None:
            known = ", ".join(one.name for one in self._rules.written) or "none"
            words = f"there is no rule {question.rule!r}; there is: {known}"
            raise TaskError(words, ReasonCode.BAD_PARAMETER.value)
        if question.as_written:
            self._rules.change(rule.name, None)
            return self.answer()
        change = RuleChange(
            enabled=question.enabled,
            confirm=None if question.confirm is None else question.confirm.value,
            mode=None if question.mode is None else tuple(one.value for one in question.mode),
            parameters=dict(question.parameters),
            by=question.by,
        )
        self._check(changed(rule, change), change)
        self._rules.change(rule.name, change)
        return self.answer()

    def _check(self, rule: Rule, change: RuleChange) -> None:
        """Raise TaskError when the service does not take what is changed."""
        if not change.parameters:
            return
        document = self._library.get(rule.then.service)
        if document is None:
            words = f"there is no service {rule.then.service!r}"
            raise TaskError(words, ReasonCode.UNKNOWN_SERVICE.value)
        given = rule.then.parameters
        taken = {name for name, value in given.items() if is_reference(value)}
        needed = tuple(one for one in document.parameters if one.name not in taken)
        fixed = {name: value for name, value in given.items() if name not in taken}
        checked_parameters(needed, fixed)
        for one in document.info().parameters:
            if one.type in _NAMES and one.name in change.parameters:
                self._check_name(one, str(change.parameters[one.name]))

    def _check_name(self, parameter: ParameterInfo, name: str) -> None:
        """Raise TaskError for what the room does not know."""
        if name == "":
            return
        try:
            self._room.ask(WhereQuestion(name))
        except ThingError as error:
            words = f"{parameter.name}: {error}"
            raise TaskError(words, ReasonCode.UNKNOWN_THING.value) from error

    def _told(self, status: RuleStatus, rule: Rule) -> RuleStatus:
        document = self._library.get(rule.then.service)
        info: ServiceInfo | None = document.info() if document else None
        if info is None:
            return replace(status, title=rule.then.service)
        given = rule.then.parameters
        settable = tuple(
            replace(one, default=given.get(one.name, one.default))
            for one in info.parameters
            if not is_reference(given.get(one.name))
        )
        return replace(status, title=info.title, parameters=settable)
