"""Task documents: what is written is read, and what is wrong is told with its line."""

from __future__ import annotations

import pickle
import re
from pathlib import Path

import pytest
import yaml
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from task_documents import PARAMETERS, documents

from housefly.errors import TaskError
from housefly.tasks.api.values import Confirm, OnPreempt, ReasonCode
from housefly.tasks.document.binding import STEPS_MAX, bind
from housefly.tasks.document.document_parser import KEYS, read_task
from housefly.tasks.document.library import SHIPPED, linked, load_library
from housefly.tasks.document.marked_yaml import DEPTH_MAX, SIZE_MAX, read_marked_yaml
from housefly.tasks.document.parameters import ParameterType
from housefly.tasks.document.step_forms import FORMS
from housefly.tasks.document.steps import (
    ConditionKind,
    ParameterUse,
    StepKind,
    TaskCondition,
    TaskStep,
)
from housefly.tasks.document.task_document import RETURN_HOME, TaskDocument
from housefly.tasks.document.writer import task_to_yaml

FIVE_LINES = """\
name: peek
parameters: {subject: place_or_thing}
steps:
  - look_at: $subject
  - return_home
"""


def with_steps(steps: str, parameters: str = "{subject: place_or_thing}") -> str:
    return f"name: t\nparameters: {parameters}\nsteps:\n{steps}\n"


@settings(max_examples=50, suppress_health_check=[HealthCheck.too_slow], deadline=None)
@given(documents)
def test_what_is_written_is_read(document: TaskDocument) -> None:
    assert read_task(task_to_yaml(document)) == document


@settings(max_examples=25, suppress_health_check=[HealthCheck.too_slow], deadline=None)
@given(documents, st.floats(1.0, 30.0))
def test_a_bound_task_has_no_parameter_left_open(document: TaskDocument, time: float) -> None:
    task = bind(document, {"subject": "cup", "time": time})
    assert pickle.loads(pickle.dumps(task)) == task
    for step in (each for first in task.steps for each in first.every_step()):
        assert step.kind is not StepKind.CALL
        assert not isinstance(step.timeout, ParameterUse)
        assert not any(isinstance(value, ParameterUse) for value in step.arguments.values())
        texts = [value for value in step.arguments.values() if isinstance(value, str)]
        assert not any("$subject" in text.replace("$$", "") for text in texts)


@settings(max_examples=150, deadline=None)
@given(st.one_of(st.text(max_size=200), st.text("{}[]&*!-:#|>\"'%@`, \nab\t$01", max_size=80)))
def test_any_text_is_a_document_or_refused_in_words(text: str) -> None:
    try:
        read_task(text, "x.yaml")
    except TaskError as error:
        assert error.code == "bad_parameter"
        assert str(error).startswith("x.yaml, line ")


@settings(max_examples=60, deadline=None)
@given(st.data())
def test_a_shipped_document_with_a_line_spoilt_is_read_or_refused(data: st.DataObject) -> None:
    paths = sorted(SHIPPED.glob("*.yaml"))
    lines = data.draw(st.sampled_from(paths)).read_text(encoding="utf-8").splitlines()
    at = data.draw(st.integers(0, len(lines) - 1))
    lines[at] = data.draw(st.text("{}[]&*!-:#|>\"' ab$1", max_size=30))
    try:
        read_task("\n".join(lines))
    except TaskError as error:
        assert "line " in str(error)


def test_a_task_of_five_lines_is_a_task() -> None:
    document = read_task(FIVE_LINES)
    assert len(FIVE_LINES.splitlines()) == 5
    assert [step.kind for step in document.steps] == [StepKind.LOOK_AT, StepKind.RETURN_HOME]
    assert document.parameters[0].required
    assert document.on_cancel == RETURN_HOME
    assert document.flies
    assert bind(document, {"subject": "the $ cup"}).steps[0].arguments["subject"] == "the $$ cup"


def test_every_kind_of_step_has_a_form() -> None:
    assert set(FORMS) == set(StepKind)


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        ("", 1, "there is nothing in it"),
        ("- a", 1, "expected a task with name and steps"),
        ("name: t", 1, "a task needs steps"),
        ("name: T t\nsteps: [land]", 1, "small letters"),
        ("name: t\nstep: [land]", 2, "did you mean steps?"),
        ("name: t\nname: u\nsteps: [land]", 2, "stands here twice"),
        ("name: t\nsteps: []", 2, "expected a list of steps"),
        ("name: t\nsteps: [lnad]", 2, "did you mean land?"),
        ("name: t\nsteps:\n  - wait: 5 s\n  - wait: 5 parsec", 4, "a time, such as 20 s"),
        ("name: t\nsteps:\n  - wait: -1", 3, "allowed: 0 to 86400 s"),
        ("name: t\nsteps:\n  - wait: .inf", 3, "a time"),
        ("name: t\nsteps:\n  - wait: 1e400", 3, "a time"),
        ("name: t\nsteps:\n  - repeat: 2.5\n    do: [land]", 3, "a whole number"),
        ("name: t\nsteps:\n  - repeat: 2", 3, "repeat needs steps under do:"),
        ("name: t\nsteps:\n  - land: here", 3, "land takes nothing"),
        ("name: t\nsteps:\n  - land: {speed: 3}", 3, "land has no 'speed'"),
        ("name: t\nsteps:\n  - say", 3, "say needs words"),
        ("name: t\nsteps:\n  - say: a\n    land: b", 3, "two steps in one"),
        ("name: t\nsteps:\n  - say: a\n    do: [land]", 4, "say has no 'do'"),
        ("name: t\nsteps:\n  - say: $nobody", 3, "there is no '$nobody'"),
        ("name: t\nsteps:\n  - say: costs 5 $", 3, "write $$ for a dollar sign"),
        ('name: t\nsteps:\n  - say: "a\\u0007b"', 3, "expected a text"),
        ("name: t\nsteps:\n  - if: {is: {thing: a, state: open}}", 3, "if needs steps under then"),
        ("name: t\nsteps:\n  - if: {was: a}\n    then: [land]", 3, "there is no condition"),
        ("name: t\nsteps:\n  - if: {set: b}\n    then: [land]", 3, "there is no '$b'"),
        (
            "name: t\nsteps:\n  - if: {reply: {to: x, equals: a}}\n    then: [land]",
            3,
            "no step asks",
        ),
        ("name: t\nsteps:\n  - {parallel: [land, take_off]}", 3, "only one of the parallel"),
        (
            "name: t\nsteps:\n  - {parallel: [{ask: a}, [{wait: 1 s}, {ask: b}]]}",
            3,
            "two parallel questions name their reply 'reply'",
        ),
        ("name: t\nsteps:\n  - go_to: {}", 3, "a subject, a point, or x and y"),
        ("name: t\nsteps:\n  - go_to: {point: [1, nan]}", 3, "a point [x, y]"),
        ("name: t\nsteps:\n  - record: {}", 3, "record needs a time"),
        ("name: t\nsteps:\n  - ask: {question: a, otherwise: maybe}", 3, "allowed: yes, no"),
        ("name: t\nsteps: [land]\nconfirm: perhaps", 3, "allowed: auto, ask, never"),
        ("name: t\nsteps: [land]\ntime_limit: 2 d", 3, "from 1 s to 24 h"),
        ("name: t\nparameters: {a: colour}\nsteps: [land]", 2, "there is no 'colour'"),
        ("name: t\nparameters: {each: text}\nsteps: [land]", 2, "no name of a parameter"),
        ("name: t\nparameters: {a: {type: choice}}\nsteps: [land]", 2, "a choice needs of"),
        ("name: t\nparameters: {a: {type: number, min: 3, max: 1}}\nsteps: [land]", 2, "above max"),
        ("name: t\nparameters: {a: {type: number, default: x}}\nsteps: [land]", 2, "a number from"),
        ("name: t\nparameters: {a: {type: text, unit: km}}\nsteps: [land]", 2, "unit: allowed"),
        ("a: &x 1\nb: *x", 1, "anchors"),
        ("a: !!python/object:os.system 1", 1, "tags"),
        ("name: t\nsteps: [land]\n---\nname: u", 3, "a second document"),
        ("name: [", 1, "this is no YAML"),
        ('name: "\\U11111111"', 1, "this is no YAML"),
        ("? [a]\n: b", 1, "a key must be a plain word"),
    ],
)
def test_a_mistake_is_told_with_its_line_and_what_is_allowed(
    text: str, line: int, words: str
) -> None:
    with pytest.raises(TaskError) as refused:
        read_task(text, "x.yaml")
    assert words in str(refused.value)
    assert str(refused.value).startswith(f"x.yaml, line {line}:")


def test_bombs_are_refused_before_they_grow() -> None:
    laughs = "a: &a [x, x]\n" + "".join(
        f"{chr(98 + n)}: &{chr(98 + n)} [*{chr(97 + n)}, *{chr(97 + n)}]\n" for n in range(20)
    )
    deep, wide = "[" * 5000, "[" + "a," * 30_000 + "]"
    for text in (laughs, deep, wide, "a" * (SIZE_MAX + 1), "- " * 2000 + "a"):
        with pytest.raises(TaskError):
            read_marked_yaml(text)
    nested = "name: t\nsteps: " + "[" * (DEPTH_MAX + 2) + "land" + "]" * (DEPTH_MAX + 2)
    with pytest.raises(TaskError, match="nested more than"):
        read_task(nested)


def test_words_stay_words() -> None:
    """YAML 1.1 would read on, yes, 12:30 and 007 as something else."""
    steps = "  - if: {is: {thing: lamp, state: on}}\n    then: [{say: 12:30}, {say: 007}]"
    (step,) = read_task(with_steps(steps)).steps
    condition = step.arguments["condition"]
    assert isinstance(condition, TaskCondition)
    assert condition.arguments["state"] == "on"
    assert [each.arguments["words"] for each in step.blocks["then"]] == ["12:30", "007"]


@pytest.mark.parametrize(
    ("given_", "words"),
    [
        ({}, "subject is missing: the name of a place or a thing"),
        ({"subject": 3.0}, "is not the name of a place or a thing"),
        ({"subject": "a\nb"}, "is not the name"),
        ({"subject": "x" * 201}, "is not the name"),
        ({"subject": "a", "time": 51.0}, "a number from 1 to 50 s"),
        ({"subject": "a", "time": "2 min"}, "a number from 1 to 50 s"),
        ({"subject": "a", "time": True}, "a number"),
        ({"subject": "a", "time": float("nan")}, "a number"),
        ({"subject": "a", "how": "far"}, "one of near, yes"),
        ({"subject": "a", "loud": "maybe"}, "yes or no"),
        ({"subject": "a", "speed": 3.0}, "there is no parameter 'speed'; allowed:"),
    ],
)
def test_a_wrong_parameter_is_refused_in_one_sentence(
    given_: dict[str, str | float | bool], words: str
) -> None:
    document = TaskDocument("t", "t", "", PARAMETERS, (TaskStep(StepKind.LAND),))
    with pytest.raises(TaskError) as refused:
        bind(document, given_)
    assert words in str(refused.value)
    assert refused.value.code == "bad_parameter"


def test_units_are_understood() -> None:
    document = TaskDocument("t", "t", "", PARAMETERS, (TaskStep(StepKind.LAND),))
    task = bind(document, {"subject": "a", "time": "0.5 min", "loud": "on"})
    assert task.parameters["time"] == 30.0
    assert task.parameters["loud"] is True


def test_a_parameter_out_of_a_steps_range_is_refused_when_it_is_bound() -> None:
    document = read_task(
        with_steps("  - record: {time: $t}", "{t: {type: number, unit: s, max: 9000}}")
    )
    with pytest.raises(TaskError, match=r"t, line 4: time: 5000.0 given; allowed: 0.5 to 1800 s"):
        bind(document, {"t": 5000.0})


def test_a_number_without_the_unit_of_the_step_does_not_fit_it() -> None:
    with pytest.raises(TaskError, match=r"time: \$t does not fit; expected a time"):
        read_task(with_steps("  - record: {time: $t}", "{t: number}"))


def test_what_is_set_in_a_parameter_is_decided_when_it_is_bound() -> None:
    document = read_task(
        with_steps(
            "  - if: {set: place}\n    then: [land]", "{place: {type: place, required: false}}"
        )
    )
    empty, full = bind(document, {}), bind(document, {"place": "kitchen"})
    assert empty.steps[0].arguments["condition"].parts == ()  # type: ignore[union-attr]
    assert empty.steps != full.steps


def test_for_each_goes_through_a_list_and_leaves_every_place_to_the_room() -> None:
    text = with_steps("  - for_each: $where\n    do: [look_at: $each]", "{where: places}")
    task = bind(read_task(text), {"where": "a, b,"})
    subjects = [step.arguments.get("subject") for step in task.steps[0].every_step()]
    assert [each for each in subjects if each] == ["a", "b"]
    open_ = bind(read_task(text), {"where": "every place"})
    assert open_.steps[0].kind is StepKind.FOR_EACH
    assert open_.steps[0].blocks["do"][0].arguments["subject"] == "$each"


def test_too_many_steps_in_all_are_refused() -> None:
    block = "{for_each: $w, do: [{for_each: $w, do: [land, land]}]}"
    document = read_task(with_steps(f"  - {block}", "{w: places}"))
    with pytest.raises(TaskError, match=f"more than {STEPS_MAX} steps"):
        bind(document, {"w": ",".join("abcdefghijklmnopqrstuvwxyzabcdefg")})


def test_a_call_takes_the_parameters_of_the_called_task() -> None:
    library = {
        name: read_task(text)
        for name, text in {
            "inner": "name: inner\nparameters: {what: thing}\nsteps: [{look_at: $what}]",
            "outer": "name: outer\nparameters: {subject: thing}\nsteps:\n"
            "  - call: {task: inner, with: {what: $subject}}",
            "asks": "name: asks\nsteps:\n  - check_people\n"
            "  - call: {task: inner, with: {what: $in_need}}",
        }.items()
    }
    done = linked(library)
    assert done["outer"].flies
    task = bind(done["outer"], {"subject": "cup"})
    assert task.steps[0].blocks[""][0].arguments["subject"] == "cup"
    later = bind(done["asks"], {})
    assert later.steps[1].blocks[""][0].arguments["subject"] == "$in_need"


@pytest.mark.parametrize(
    ("steps", "words"),
    [
        ("[{call: nobody}]", "there is no task 'nobody'; allowed: a, b"),
        ("[{call: a}]", "tasks call in a ring: a -> a"),
        ("[{call: {task: b, with: {x: 1}}}]", "there is no parameter 'x'"),
        ("[{call: b}]", "what is missing"),
        ("[{call: {task: b, with: {what: 5}}}]", "is not the name of a thing"),
    ],
)
def test_a_call_that_cannot_be_is_refused_with_its_line(steps: str, words: str) -> None:
    library = {
        "a": read_task(f"name: a\nsteps: {steps}", "a.yaml"),
        "b": read_task("name: b\nparameters: {what: thing}\nsteps: [land]", "b.yaml"),
    }
    with pytest.raises(TaskError) as refused:
        linked(library)
    assert words in str(refused.value)
    assert "a.yaml, line 2" in str(refused.value)


def test_a_called_task_may_not_ask_beside_a_question_of_the_same_name() -> None:
    texts = {
        "inner": "name: inner\nsteps: [{ask: a}]",
        "outer": "name: outer\nsteps:\n  - {parallel: [{call: inner}, {ask: b}]}",
    }
    library = linked({name: read_task(text) for name, text in texts.items()})
    with pytest.raises(TaskError, match="line 3: two parallel questions"):
        bind(library["outer"], {})


def test_tasks_that_call_each_other_in_a_ring_are_refused() -> None:
    library = {
        name: read_task(f"name: {name}\nsteps: [{{call: {other}}}]")
        for name, other in (("a", "b"), ("b", "c"), ("c", "a"))
    }
    with pytest.raises(TaskError, match="a -> b -> c -> a"):
        linked(library)


def test_every_shipped_document_is_sound_and_says_what_it_is() -> None:
    library = load_library()
    assert set(library) == {
        *("visitor", "look", "where", "patrol", "come", "follow"),
        *("inventory", "night_round", "all_right", "panorama", "find", "fly_to"),
    }
    for name, document in library.items():
        info = document.info()
        assert info.title and info.about and info.flies, name
        assert all(parameter.about for parameter in info.parameters), name
        assert document.time_limit is not None, name
        needed = {p.name: "kitchen" for p in document.parameters if p.required}
        task = bind(document, needed)
        assert pickle.loads(pickle.dumps(task)) == task
        assert read_task(task_to_yaml(document)) == document
        assert yaml.safe_load((SHIPPED / f"{name}.yaml").read_text(encoding="utf-8"))


def test_a_folder_of_ones_own_adds_and_overrides_only_when_it_says_so(tmp_path: Path) -> None:
    (tmp_path / "peek.yaml").write_text(FIVE_LINES, encoding="utf-8")
    assert "peek" in load_library(tmp_path)
    mine = tmp_path / "look.yaml"
    mine.write_text("name: look\nsteps: [land]\n", encoding="utf-8")
    with pytest.raises(TaskError, match=r"look\.yaml, line 1: look ships.*overrides: true"):
        load_library(tmp_path)
    mine.write_text("name: look\nsteps: [land]\noverrides: true\n", encoding="utf-8")
    # The shipped task "where" calls look with a subject, which this one does not take.
    with pytest.raises(TaskError, match="there is no parameter 'subject'"):
        load_library(tmp_path)
    mine.write_text(
        "name: look\nparameters: {subject: place_or_thing}\nsteps: [land]\noverrides: true\n",
        encoding="utf-8",
    )
    assert load_library(tmp_path)["look"].steps == (TaskStep(StepKind.LAND),)


def test_a_folder_that_cannot_be_read_is_refused_in_words(tmp_path: Path) -> None:
    with pytest.raises(TaskError, match="no such folder"):
        load_library(tmp_path / "none")
    (tmp_path / "a.yaml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(TaskError, match="cannot be read as UTF-8"):
        load_library(tmp_path)
    (tmp_path / "a.yaml").write_text("x" * (5 * SIZE_MAX), encoding="utf-8")
    with pytest.raises(TaskError, match="larger than"):
        load_library(tmp_path)
    (tmp_path / "a.yaml").write_text(FIVE_LINES, encoding="utf-8")
    (tmp_path / "b.yml").write_text(FIVE_LINES, encoding="utf-8")
    with pytest.raises(TaskError, match=r"peek is the name of a\.yaml, too"):
        load_library(tmp_path)


def test_what_a_document_says_of_itself_is_kept() -> None:
    document = read_task(FIVE_LINES + "confirm: ask\non_preempt: end\ntime_limit: 2 min\n")
    task = bind(document, {"subject": "cup"})
    assert (task.confirm, task.on_preempt) == (Confirm.ASK, OnPreempt.END)
    assert task.time_limit == 120.0


def test_every_step_condition_service_and_reason_is_explained() -> None:
    page = (Path(__file__).parents[3] / "docs" / "tasks.md").read_text(encoding="utf-8")
    words = [kind.value for kind in (*StepKind, *ConditionKind, *ReasonCode, *ParameterType)]
    for word in (*words, *load_library(), *KEYS):
        assert re.search(rf"`[^`]*\b{word}\b[^`]*`", page), word


def test_the_task_of_five_lines_stands_in_the_documents() -> None:
    page = (Path(__file__).parents[3] / "docs" / "tasks.md").read_text(encoding="utf-8")
    assert FIVE_LINES in page
