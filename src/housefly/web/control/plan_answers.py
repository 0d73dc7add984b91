"""Answers a viewer's questions for a path: the newest, for older ones are out of date."""

from __future__ import annotations

from housefly.errors import HouseflyError
from housefly.hub.api.pilot_queries import PlanRequest
from housefly.messages.words import Words
from housefly.web.control.pilot_link import PilotLink
from housefly.web.messages.server_messages import PlanReply, RefusedReply
from housefly.web.viewers.viewer import Viewer


async def answer_plans(viewer: Viewer, link: PilotLink) -> None:
    """Answer until there is no newer question; one at a time for each viewer."""
    if viewer.asking:
        return
    viewer.asking = True
    while (question := viewer.question) is not None:
        viewer.question = None
        try:
            answer = await link.plan(PlanRequest(question.place, question.goal))
        except HouseflyError as error:
            viewer.send(
                RefusedReply(
                    question.id, Words("no path could be asked for: {why}", why=str(error))
                )
            )
        else:
            viewer.send(PlanReply(question.id, answer))
    viewer.asking = False
