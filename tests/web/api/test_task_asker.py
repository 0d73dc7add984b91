"""What the server makes of a request: who asked, where, and whether it waits for a yes."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.tasks.api.questions import CancelTask, RehearseTask, RequestTask, Sentence
from housefly.tasks.api.values import Confirm, Priority, RequestSurface
from housefly.web.access.roles import Role
from housefly.web.api.task_asker import OWN_SURFACES, TaskAsker, filled_in, program_asking

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


@given(st.sampled_from(Role), st.text(max_size=10), st.text(max_size=10))
def test_two_people_of_one_name_are_two_whatever_they_say(
    role: Role, name: str, claimed: str
) -> None:
    console = RequestSurface.CONSOLE
    for owner in ("~kim", "a browser's session"):
        asker = TaskAsker(name, role, console, "", owner)
        for asked in (RequestTask("look", owner=claimed), Sentence("look", owner=claimed)):
            told = filled_in(asked, asker)
            assert isinstance(told, RequestTask | Sentence)
            assert (told.by, told.owner) == (name, owner)
        ended = filled_in(CancelTask(0, only_of=claimed), asker)
        assert isinstance(ended, CancelTask)
        assert role.includes(Role.FLY) or ended.only_of == owner
        rehearsed = filled_in(RehearseTask("look", surface=RequestSurface.RULE), asker)
        assert isinstance(rehearsed, RehearseTask) and rehearsed.surface is console


def test_what_a_program_says_of_itself_is_no_id() -> None:
    owners = {program_asking({"by": name}).counted_as for name in ("kim", "~kim", "")}
    assert len(owners) == 1 and not owners & {"", "kim", "~kim"}
