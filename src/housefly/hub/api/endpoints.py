"""The paths of the room's HTTP API: one question each, shared by server and client."""

from __future__ import annotations

from dataclasses import dataclass

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

API_PREFIX = "/api/v1"


@dataclass(frozen=True, slots=True)
class Endpoint:
    """One path of the API.

    Attributes:
        path: below the prefix, with its parameter in braces.
        question: its fields are the parameters.
        summary: one line.
    """

    path: str
    question: type[Question]
    summary: str


ENDPOINTS = (
    Endpoint("/where/{thing}", WhereQuestion, "Where a thing is, now or at a time"),
    Endpoint("/things", CatalogueQuestion, "The catalogue, of one kind or whole"),
    Endpoint("/near", NearQuestion, "What is near a point or a thing"),
    Endpoint("/contents/{thing}", ContentsQuestion, "What is in a thing, however deep"),
    Endpoint("/trajectory/{thing}", TrajectoryQuestion, "Where a thing was between two times"),
    Endpoint("/events", EventsQuestion, "What happened"),
    Endpoint("/feed", FeedQuestion, "What happened lately, grouped by what it is about"),
    Endpoint("/sensors", SensorsQuestion, "How every sensor does"),
    Endpoint("/picture", PictureQuestion, "Everything that has a place, now or at a time"),
    Endpoint("/is/{thing}", StateQuestion, "Whether it is on, open, up ...: yes, no or unknown"),
    Endpoint("/people", PeopleQuestion, "Who is there, in which posture, doing what"),
    Endpoint("/nights", NightsQuestion, "How often somebody was up at night"),
)
