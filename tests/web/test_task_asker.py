"""What the server makes of a request: who asked, where, and whether it waits for a yes."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.tasks.api.questions import RequestTask, Sentence
from housefly.tasks.api.values import Confirm, Priority, RequestSurface
from housefly.web.roles import Role
from housefly.web.task_asker import OWN_SURFACES, TaskAsker, filled_in

_askers = st.builds(
    TaskAsker,
    st.text(max_size=10),
    st.sampled_from(Role),
    st.sampled_from(RequestSurface),
    st.just(""),
    st.just(""),
)


@given(
    _askers, st.sampled_from(Confirm), st.sampled_from(Priority), st.sampled_from(RequestSurface)
)
def test_whoever_may_not_fly_needs_a_yes_whatever_is_asked(
    asker: TaskAsker, confirm: Confirm, priority: Priority, surface: RequestSurface
) -> None:
    asked = RequestTask("look", {}, "somebody else", surface, "rule:bell", confirm, priority)
    told = filled_in(asked, asker)
    assert isinstance(told, RequestTask)
    assert (told.by, told.surface, told.cause) == (asker.name, asker.surface, asker.cause)
    may_fly = asker.role.includes(Role.FLY) and asker.surface is not RequestSurface.ASSISTANT
    assert told.confirm is (confirm if may_fly else Confirm.ASK)
    assert may_fly or told.priority is not Priority.ALARM
    said = filled_in(Sentence("look", confirm=confirm), asker)
    assert isinstance(said, Sentence) and (may_fly or said.confirm is Confirm.ASK)
    assert said.may_fly is may_fly
    assert set(OWN_SURFACES).isdisjoint({RequestSurface.CONSOLE, RequestSurface.RULE})
