"""How each step is written: its arguments, what they may be, and the blocks inside it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from housefly.tasks.document.steps import ArgumentValue, ConditionKind, StepKind

TIME_MAX = 86_400.0
"""Longest time in a document [s]."""
COUNT_MAX = 1_000.0
"""Most rounds of a step."""
EVERY = ("every place", "every person", "whole floor")
"""What may stand for a list of names: the room's memory has them when the task runs."""
BLOCK_WORDS = ("do", "then", "else", "otherwise")
"""What the steps inside a step stand under."""


class ArgumentType(Enum):
    """What an argument takes, in words."""

    SUBJECT = "the name of a place, a thing or a person"
    TEXT = "a text"
    WORDS = "a list of texts"
    NAME = "a plain word (letters, digits, _)"
    TIME = "a time, such as 20 s or 2 min"
    LENGTH = "a length, such as 1.5 m"
    ANGLE = "an angle, such as 90 deg"
    COUNT = "a whole number"
    FLAG = "true or false"
    CHOICE = "a choice"
    NAMES = "a list of names, a parameter with names, every place, every person or whole floor"
    GIVEN = "parameters, such as {subject: $subject}"
    CONDITION = "a condition"
    POINT = "a point [x, y] in the room, in metres"


@dataclass(frozen=True, slots=True)
class StepArgument:
    """One argument of a step or a condition.

    Attributes:
        name, type, about: of the argument.
        default: its value when it is not given; None means that it is empty.
        required: whether it must be given.
        low, high: range of a number, in s, m, deg or 1.
        of: what a choice may be.
    """

    name: str
    type: ArgumentType
    about: str
    default: ArgumentValue | None = None
    required: bool = False
    low: float = 0.0
    high: float = TIME_MAX
    of: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class StepForm:
    """How one kind of step is written.

    Attributes:
        about: what it does, one sentence.
        arguments: the first may be written without its name.
        blocks: words under which steps must stand; "" is the value of the step itself.
        more_blocks: words under which steps may stand.
        flies: whether it moves the drone.
        looks: whether it is of no use without the drone's camera.
    """

    about: str
    arguments: tuple[StepArgument, ...] = ()
    blocks: tuple[str, ...] = ()
    more_blocks: tuple[str, ...] = ()
    flies: bool = False
    looks: bool = False


_T = ArgumentType
_A = StepArgument
_SUBJECT = _A("subject", _T.SUBJECT, "what to look at", required=True)
_SHOWN = _A("subject", _T.SUBJECT, "what the picture shows")
_SPEECH = _A("words", _T.TEXT, "what to say", required=True)

FORMS: dict[StepKind, StepForm] = {
    StepKind.TAKE_OFF: StepForm("Take off and hover above the pad.", flies=True),
    StepKind.GO_TO: StepForm(
        "Fly to where a place, a thing or a person is seen from; takes off when it must.",
        (
            _A("subject", _T.SUBJECT, "where to go"),
            _A("point", _T.POINT, "or a point instead", low=-1000.0, high=1000.0),
            _A("x", _T.LENGTH, "or its two numbers", low=-1000.0, high=1000.0),
            _A("y", _T.LENGTH, "likewise", low=-1000.0, high=1000.0),
        ),
        flies=True,
    ),
    StepKind.LOOK_AT: StepForm(
        "Fly to where the subject is seen from and face it; takes off when it must.",
        (
            _SUBJECT,
            _A("person_within", _T.LENGTH, "face whoever is so near to it instead", high=10.0),
            _A(
                "place",
                _T.CHOICE,
                "where memory says, or next best",
                "likeliest",
                of=("likeliest", "next"),
            ),
            _A("as", _T.NAME, "name for who is faced instead", "who"),
        ),
        flies=True,
        looks=True,
    ),
    StepKind.SWEEP: StepForm(
        "Turn on the spot and take a picture in each direction: a panorama.",
        (
            _A("views", _T.COUNT, "pictures of a whole turn", 8.0, low=2.0, high=36.0),
            _A("angle", _T.ANGLE, "how far to turn", 360.0, low=20.0, high=360.0),
            _A("subject", _T.SUBJECT, "what the pictures show"),
        ),
        flies=True,
        looks=True,
    ),
    StepKind.FOLLOW: StepForm(
        "Keep a person in view from a distance, never overhead.",
        (
            _A("person", _T.SUBJECT, "whom to follow", required=True),
            _A("time", _T.TIME, "for how long", 60.0, low=1.0, high=1800.0),
            _A(
                "lost_after",
                _T.TIME,
                "unseen for so long, they are lost",
                10.0,
                low=1.0,
                high=120.0,
            ),
            _A("search", _T.TIME, "then look where they were last for so long", 0.0, high=120.0),
        ),
        flies=True,
        looks=True,
    ),
    StepKind.RETURN_HOME: StepForm("Fly home and land on the pad.", flies=True),
    StepKind.LAND: StepForm("Land where the drone is.", flies=True),
    StepKind.RECORD: StepForm(
        "Record a clip for a time, or for as long as the steps inside take.",
        (
            _A("time", _T.TIME, "for how long", low=0.5, high=1800.0),
            _A("before", _T.TIME, "of the past before it", 5.0, high=30.0),
            _SHOWN,
        ),
        more_blocks=("do",),
        looks=True,
    ),
    StepKind.SNAPSHOT: StepForm("Keep one picture.", (_SHOWN,), looks=True),
    StepKind.SAY: StepForm("Tell people: on every screen and over MQTT.", (_SPEECH,)),
    StepKind.ANNOUNCE: StepForm(
        "Say it out loud in the room, over MQTT, and on every screen.",
        (_SPEECH, _A("topic", _T.TEXT, "of the loudspeaker", "housefly/announce")),
    ),
    StepKind.REPORT: StepForm(
        "Add a line to what the task found.", (_A("words", _T.TEXT, "the line", required=True),)
    ),
    StepKind.PUBLISH: StepForm(
        "Publish to a device of the room over MQTT: a light, a door, a loudspeaker.",
        (
            _A("topic", _T.TEXT, "of the device", required=True),
            _A("payload", _T.TEXT, "what to send", ""),
        ),
    ),
    StepKind.ASK: StepForm(
        "Ask people and wait for a reply; the drone hovers meanwhile.",
        (
            _A("question", _T.TEXT, "what to ask", required=True),
            _A("choices", _T.WORDS, "what may be replied", ("yes", "no")),
            _A("wait", _T.TIME, "for how long", 60.0, low=1.0, high=1800.0),
            _A("otherwise", _T.TEXT, "what counts when nobody replies: the last choice"),
            _A("as", _T.NAME, "name of the reply", "reply"),
        ),
    ),
    StepKind.WAIT: StepForm(
        "Wait for a time, or until something is so.",
        (
            _A("time", _T.TIME, "for how long, at most", 10.0),
            _A("until", _T.CONDITION, "or until this is so"),
        ),
    ),
    StepKind.FIND: StepForm(
        "Ask the room's memory where something is and report it; nothing flies.",
        (
            _A("subject", _T.SUBJECT, "what to look for", required=True),
            _A("say", _T.FLAG, "tell people, too", False),
        ),
    ),
    StepKind.SEARCH: StepForm(
        "Fly to where a lost thing shows most likely soonest; begun again, to the next best place.",
        (
            _A("subject", _T.SUBJECT, "what to look for", required=True),
            _A("time", _T.TIME, "for all looks together", 240.0, low=10.0, high=1800.0),
            _A("look", _T.TIME, "what each look takes beside the way", 10.0, high=600.0),
            _A("least", _T.COUNT, "percent from which a look is flown", 3.0, low=1.0, high=50.0),
            _A("reply", _T.NAME, "name of the reply, yes or no, to the last picture", "seen"),
            _A("as", _T.NAME, "name for what is looked at", "spot"),
            _A("ended", _T.NAME, "name that is set when the search is over", "ended"),
        ),
        flies=True,
        looks=True,
    ),
    StepKind.COVERAGE: StepForm(
        "Report how much of the floor the pictures of this task show, of what can be seen at all."
    ),
    StepKind.CONTENTS: StepForm(
        "Report what the room's memory knows to be in a thing.",
        (_A("thing", _T.SUBJECT, "a cabinet, a refrigerator", required=True),),
    ),
    StepKind.CHANGES: StepForm(
        "Report what came, went or moved since the service ended last, as the memory has it.",
        (
            _A("thing", _T.SUBJECT, "in it or within 2 m of it; without it, anywhere"),
            _A("since", _T.TIME, "so far back instead", low=1.0),
        ),
    ),
    StepKind.CHECK_PEOPLE: StepForm(
        "Report how everybody is; whoever may need help, or is missing at night, gets a name.",
        (
            _A("person", _T.SUBJECT, "one of them only"),
            _A("as", _T.NAME, "name for who may have fallen", "in_need"),
            _A("missing", _T.NAME, "name for who left their bed and is not seen", "missing"),
            _A("unsure", _T.NAME, "name for those of whom nobody knows how they are", "unsure"),
            _A("sure", _T.COUNT, "percent from which a fall counts", 30.0, low=1.0, high=100.0),
            _A("away", _T.TIME, "out of bed for longer than this is missed", 900.0, low=60.0),
        ),
    ),
    StepKind.CALL: StepForm(
        "Do what another task does.",
        (
            _A("task", _T.NAME, "its name", required=True),
            _A("with", _T.GIVEN, "its parameters"),
        ),
    ),
    StepKind.SEQUENCE: StepForm("One after the other.", blocks=("",)),
    StepKind.PARALLEL: StepForm(
        "All at the same time, until all are done or one fails; only one of them may fly.",
        blocks=("",),
    ),
    StepKind.FIRST_OF: StepForm("The first that succeeds; one after the other.", blocks=("",)),
    StepKind.RETRY: StepForm(
        "Try the steps again when they fail.",
        (_A("times", _T.COUNT, "tries in all", required=True, low=1.0, high=10.0),),
        blocks=("do",),
    ),
    StepKind.TIMEOUT: StepForm(
        "Give up the steps after a time, then do otherwise, or fail.",
        (_A("after", _T.TIME, "the time", required=True, low=0.1),),
        blocks=("do",),
        more_blocks=("otherwise",),
    ),
    StepKind.IF: StepForm(
        "Do then when the condition holds, else when it does not.",
        (_A("condition", _T.CONDITION, "what must hold", required=True),),
        blocks=("then",),
        more_blocks=("else",),
    ),
    StepKind.REPEAT: StepForm(
        "Do the steps several times, or until something is so.",
        (
            _A("times", _T.COUNT, "rounds, at most", required=True, low=1.0, high=COUNT_MAX),
            _A("until", _T.CONDITION, "or until this is so"),
        ),
        blocks=("do",),
    ),
    StepKind.FOR_EACH: StepForm(
        "Do the steps once for each name; it is $each inside. Names are a list, a parameter, or"
        " every place, every person.",
        (_A("of", _T.NAMES, "the names", required=True),),
        blocks=("do",),
    ),
    StepKind.FAIL: StepForm(
        "End the task as failed, for a reason.",
        (_A("words", _T.TEXT, "why", required=True),),
    ),
}
"""How each kind of step is written."""

CONDITION_FORMS: dict[ConditionKind, tuple[StepArgument, ...]] = {
    ConditionKind.IS: (
        _A("thing", _T.SUBJECT, "a thing, device or person", required=True),
        _A("state", _T.TEXT, "open, on, up, in bed, fallen ...", required=True),
        _A("answer", _T.CHOICE, "which answer", "yes", of=("yes", "no", "unknown")),
    ),
    ConditionKind.SET: (_A("name", _T.NAME, "a parameter, or what a step found", required=True),),
    ConditionKind.REPLY: (
        _A("to", _T.NAME, "name of the reply", "reply"),
        _A("equals", _T.TEXT, "the choice", required=True),
    ),
    ConditionKind.PARAMETER: (
        _A("name", _T.NAME, "a parameter", required=True),
        _A("equals", _T.TEXT, "its value", required=True),
    ),
    ConditionKind.DOUBTFUL: (
        _A("thing", _T.SUBJECT, "a thing that may as well be elsewhere", required=True),
    ),
    ConditionKind.STALE: (
        _A("thing", _T.SUBJECT, "a thing or a person", required=True),
        _A("older", _T.TIME, "than this", 300.0),
    ),
}
"""Arguments of each simple condition; not, all and any are made of conditions."""


def default_of(kind: StepKind, name: str) -> ArgumentValue | None:
    """Return the default of an argument."""
    return next(each.default for each in FORMS[kind].arguments if each.name == name)
