"""Steps that report what the room's memory says, and what the pictures of a task show."""

from __future__ import annotations

from housefly.hub.api.questions import ContentsQuestion, WhereQuestion
from housefly.tasks.execution.comparison import changes_between, last_time
from housefly.tasks.execution.people_check import PeopleCheck, check_people
from housefly.tasks.execution.step_behavior import StepBehavior
from housefly.tasks.execution.values import Report, Say

LINES_MAX = 20
"""Most lines that one step reports."""


class Find(StepBehavior):
    """Reports where something is, as the memory has it."""

    def begin(self) -> None:
        """Ask and report."""
        answer = self.context.room.ask(WhereQuestion(self.text("subject")))
        words = answer.words[:1].upper() + answer.words[1:]
        self.context.actions.append(Report(words))
        if self.argument("say") is True:
            self.context.actions.append(Say(words))


class Contents(StepBehavior):
    """Reports what is in a thing."""

    def begin(self) -> None:
        """Ask and report."""
        thing = self.text("thing")
        found = self.context.room.ask(ContentsQuestion(thing)).things
        title = self.context.title_of(thing)
        names = [each.name for each in found][:LINES_MAX]
        more = f" and {len(found) - LINES_MAX} more" if len(found) > LINES_MAX else ""
        words = f"In {title}: {', '.join(names)}{more}" if names else f"Nothing is in {title}"
        self.context.actions.append(Report(f"{words}, as far as the room knows"))


class Changes(StepBehavior):
    """Reports what came, went or moved since the last time."""

    def begin(self) -> None:
        """Ask and report."""
        now = self.context.inputs.unix
        since = self.argument("since")
        then = now - since if isinstance(since, float) else last_time(self.context)
        if then is None:
            lines = ["Done for the first time: there is nothing to compare with yet"]
        else:
            lines = changes_between(self.context, then, self.text("thing"))
        if then is not None and not lines:
            lines = [f"Nothing came, went or moved in the last {_duration(now - then)}"]
        self.context.actions += [Report(line) for line in lines[:LINES_MAX]]


def _duration(seconds: float) -> str:
    """Return a time in words [s]."""
    for unit, length in (("days", 86_400.0), ("h", 3600.0), ("min", 60.0)):
        if seconds >= 2.0 * length:
            return f"{seconds / length:.0f} {unit}"
    return f"{seconds:.0f} s"


class Coverage(StepBehavior):
    """Reports how much of the floor the pictures of this task show."""

    def begin(self) -> None:
        """Work it out and report."""
        poses = tuple(self.context.picture_poses)
        share = self.context.room.shown_share(poses)
        words = f"The pictures show {100.0 * share:.0f} % of the floor that can be seen"
        self.context.actions.append(Report(words))


class CheckPeople(StepBehavior):
    """Reports how everybody is; names who may need help, is missing, or is not known of."""

    def begin(self) -> None:
        """Ask, report, and remember whom it is about."""
        context = self.context
        check = PeopleCheck(self.number("sure") / 100.0, self.number("away"))
        found = check_people(context, self.text("person"), check)
        context.actions += [Report(line) for line in found.lines[:LINES_MAX]]
        for name, who in (("as", found.in_need), ("missing", found.missing)):
            context.results.pop(self.text(name), None)
            if who is not None:
                context.found(self.text(name), *who)
        context.results[self.text("unsure")] = found.unsure
