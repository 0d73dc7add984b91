"""What the room answers: one frozen value a kind of answer.

Times are Unix time [s].
"""

from __future__ import annotations

from dataclasses import dataclass, field

from housefly.geometry import Vec3
from housefly.hub.api.feed_answers import FeedAnswer
from housefly.hub.api.questions import (
    CatalogueQuestion,
    ContentsQuestion,
    EventsQuestion,
    FeedQuestion,
    NearQuestion,
    NightsQuestion,
    PeopleQuestion,
    PictureQuestion,
    Question,
    SensorsQuestion,
    StateQuestion,
    TrajectoryQuestion,
    WhereQuestion,
)
from housefly.hub.api.state_answers import NightsAnswer, PeopleAnswer, StateAnswer
from housefly.messages.words import UNSAID, Words

_Scalar = str | float | bool


@dataclass(frozen=True, slots=True)
class SourceAnswer:
    """What one source last said: its position [m] and how long ago it said so [s]."""

    source: str
    age: float
    position: Vec3 | None
    inside: str
    valid: bool
    facts: dict[str, _Scalar] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class AlternativePlace:
    """Where else a thing may be: in words ("left on the sofa table"), on or in which thing (its id,
    or ""), where [m], confidence 0 to 1.
    """

    words: str
    thing: str
    position: Vec3 | None
    confidence: float


@dataclass(frozen=True, slots=True)
class WhereAnswer:
    """Where a thing is and how we know.

    Attributes:
        thing, name, kind: of the thing.
        words: the answer as a sentence.
        position: world [m]; None when nobody knows.
        yaw: heading [rad]; None when unknown.
        std: one sigma of the position, root of the mean variance [m]; None when unknown.
        inside: ids of what contains it, the closest first.
        by_container: id of the container whose position this is, or "".
        seen_at: Unix time [s]; None when only the catalogue speaks.
        age: time since [s]; None likewise.
        sources: whose word this is.
        said: what each source last said.
        confidence: that the first answer holds, 0 to 1.
        alternatives: where else it may be, the likeliest first; empty when nothing speaks for it.
    """

    thing: str
    name: str
    kind: str
    words: str
    position: Vec3 | None
    yaw: float | None
    std: float | None
    inside: tuple[str, ...]
    by_container: str
    seen_at: float | None
    age: float | None
    sources: tuple[str, ...]
    said: tuple[SourceAnswer, ...]
    confidence: float = 1.0
    alternatives: tuple[AlternativePlace, ...] = ()


@dataclass(frozen=True, slots=True)
class ViewpointAnswer:
    """A named pose from which a robot reaches or sees a thing: position [m], yaw [rad]."""

    name: str
    position: Vec3
    yaw: float
    robot: str


@dataclass(frozen=True, slots=True)
class ThingAnswer:
    """One thing of the catalogue."""

    thing: str
    name: str
    kind: str
    aliases: tuple[str, ...]
    position: Vec3 | None
    inside: str
    viewpoints: tuple[ViewpointAnswer, ...]


@dataclass(frozen=True, slots=True)
class ThingsAnswer:
    """Things of the catalogue."""

    things: tuple[ThingAnswer, ...]


@dataclass(frozen=True, slots=True)
class PlacedThing:
    """A thing with its place: position [m], yaw [rad], how far from the point asked for [m], how
    long ago it was seen [s].
    """

    thing: str
    name: str
    kind: str
    position: Vec3 | None
    yaw: float | None
    inside: str
    age: float | None
    distance: float | None = None


@dataclass(frozen=True, slots=True)
class PlacedAnswer:
    """Things with their places."""

    things: tuple[PlacedThing, ...]


@dataclass(frozen=True, slots=True)
class TrajectoryAnswer:
    """Where a thing was: rows of Unix time [s], x, y, z [m]."""

    thing: str
    rows: tuple[tuple[float, float, float, float], ...]


@dataclass(frozen=True, slots=True)
class EventAnswer:
    """Something that happened, as kept: Unix time [s], confidence 0 to 1, what is said of it."""

    kind: str
    thing: str
    at: float
    source: str
    cause: str
    confidence: float
    facts: dict[str, _Scalar]
    words: Words = UNSAID


@dataclass(frozen=True, slots=True)
class EventsAnswer:
    """What happened, by time."""

    events: tuple[EventAnswer, ...]


@dataclass(frozen=True, slots=True)
class SensorAnswer:
    """Health of one sensor: message rate [Hz], time since it was last heard [s], None for never."""

    sensor: str
    kind: str
    title: str
    connected: bool
    rate_hz: float
    age: float | None
    problem: Words
    counts: dict[str, int]


@dataclass(frozen=True, slots=True)
class SensorsAnswer:
    """How every sensor does, and what is wrong with the memory itself; "" when all is kept."""

    sensors: tuple[SensorAnswer, ...]
    memory: str


@dataclass(frozen=True, slots=True)
class SituationAnswer:
    """An active situation: since when [Unix time, s], confidence 0 to 1, evidence in words, the
    facts that last as long as it does, ids of the sources of the evidence, and what is said of
    its thing.
    """

    kind: str
    thing: str
    since: float
    confidence: float
    evidence: str
    facts: dict[str, _Scalar] = field(default_factory=dict)
    sources: tuple[str, ...] = ()
    words: Words = UNSAID


@dataclass(frozen=True, slots=True)
class ObstacleAnswer:
    """A live obstacle: world xy [m], velocity [m/s], confidence 0 to 1, time since it was seen [s].

    Its ground is all within ``radius`` [m] of it or, when ``length`` and ``width`` [m] are not 0,
    the rectangle with its length along ``yaw`` [rad].
    """

    obstacle: str
    x: float
    y: float
    radius: float
    vx: float
    vy: float
    confidence: float
    age: float
    source: str
    length: float = 0.0
    width: float = 0.0
    yaw: float = 0.0


@dataclass(frozen=True, slots=True)
class PictureAnswer:
    """The room at one time [Unix time, s]."""

    at: float
    things: tuple[PlacedThing, ...]
    situations: tuple[SituationAnswer, ...] = ()
    obstacles: tuple[ObstacleAnswer, ...] = ()


@dataclass(frozen=True, slots=True)
class News:
    """What changed since the last news: things with their places, what happened, what holds, what
    is in the way.
    """

    at: float
    things: tuple[PlacedThing, ...]
    events: tuple[EventAnswer, ...]
    situations: tuple[SituationAnswer, ...]
    obstacles: tuple[ObstacleAnswer, ...]


Answer = (
    WhereAnswer
    | ThingsAnswer
    | PlacedAnswer
    | TrajectoryAnswer
    | EventsAnswer
    | FeedAnswer
    | SensorsAnswer
    | PictureAnswer
    | StateAnswer
    | PeopleAnswer
    | NightsAnswer
)
ANSWER_TYPES: dict[type[Question], type[Answer]] = {
    WhereQuestion: WhereAnswer,
    CatalogueQuestion: ThingsAnswer,
    NearQuestion: PlacedAnswer,
    ContentsQuestion: PlacedAnswer,
    TrajectoryQuestion: TrajectoryAnswer,
    EventsQuestion: EventsAnswer,
    FeedQuestion: FeedAnswer,
    SensorsQuestion: SensorsAnswer,
    PictureQuestion: PictureAnswer,
    StateQuestion: StateAnswer,
    PeopleQuestion: PeopleAnswer,
    NightsQuestion: NightsAnswer,
}
"""What each question is answered with."""
