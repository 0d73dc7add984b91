"""Task strings of ROS-TMS become task documents, or a refusal that says which step and why."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import TaskError
from housefly.tasks.document.binding import bind
from housefly.tasks.document.document_parser import read_task
from housefly.tasks.document.rpn_import import UNABLE, import_rpn
from housefly.tasks.document.rpn_main import main
from housefly.tasks.document.rpn_tree import RpnGroup, RpnSubtask, read_rpn
from housefly.tasks.document.steps import StepKind
from housefly.tasks.document.task_document import TaskDocument

GET_OBJECT = "9001$oid 9002$oid + 9001$uid + 9003$uid +"
OLD_GET_OBJECT = "9001$oid 9002$oid + 9003$uid +"
PATROL = "9001$rid 9006$oid 9007$oid | +"
SCRIPT = "9001$-1$5500$2000$-90 9001$-1$2000$3000$90 + 9001$-1$5500$2000$-90 +"


def imported(text: str, tell: bool = False, **names: str) -> TaskDocument:
    known = {int(number.strip("n")): name for number, name in names.items()}
    return read_task(import_rpn(text, "t", names=known, tell=tell))


def kinds(document: TaskDocument) -> list[str]:
    return [step.kind.value for step in document.steps]


@pytest.mark.parametrize("text", [GET_OBJECT, OLD_GET_OBJECT])
def test_8001_get_object_is_refused_because_a_drone_has_no_hand(text: str) -> None:
    with pytest.raises(TaskError, match="subtask 9002 would grasp something: a drone has no hand"):
        imported(text)


def test_8001_get_object_may_ask_people_for_what_a_drone_cannot_do() -> None:
    document = imported(GET_OBJECT, tell=True)
    assert kinds(document) == ["look_at", "say", "look_at", "say", "return_home"]
    assert [p.name for p in document.parameters] == ["thing", "person"]
    task = bind(document, {"thing": "cup", "person": "Anna"})
    assert [step.arguments.get("subject") for step in task.steps] == [
        "cup",
        None,
        "Anna",
        None,
        None,
    ]


def test_8002_patrol_becomes_a_panorama_with_pictures() -> None:
    document = imported(PATROL)
    assert kinds(document) == ["look_at", "parallel", "return_home"]
    assert [step.kind for step in document.steps[1].blocks[""]] == [
        StepKind.SWEEP,
        StepKind.SNAPSHOT,
    ]


def test_8003_test_task_takes_off_before_it_looks_about() -> None:
    assert kinds(imported("9006$oid 9007$oid |")) == ["take_off", "parallel", "return_home"]


def test_8004_a_script_of_points_in_millimetres_becomes_metres() -> None:
    points = [step.arguments.get("point") for step in imported(SCRIPT).steps]
    assert points == [(5.5, 2.0), (2.0, 3.0), (5.5, 2.0), None]
    assert "# subtask 9001: the heading -90 is left out" in import_rpn(SCRIPT, "t")


def test_8007_go_and_8008_come() -> None:
    go, come = imported("9001$pid +"), imported("9001$uid +")
    assert [p.type.value for p in (*go.parameters, *come.parameters)] == ["place", "person"]
    assert kinds(go) == kinds(come) == ["look_at", "return_home"]


def test_of_variants_the_first_is_done_whose_id_the_request_has() -> None:
    document = imported("9001$pid + ; 9001$oid 9007$oid + ; 9001$uid +")
    for given_, subject in (({"place": "a"}, "a"), ({"thing": "b"}, "b"), ({"person": "c"}, "c")):
        task = bind(document, given_)
        truths = [
            step.blocks["then"][0].arguments["subject"]
            for first in task.steps
            for step in first.every_step()
            if step.kind is StepKind.IF and step.arguments["condition"].kind.value == "all"  # type: ignore[union-attr]
        ]
        last = [step.arguments.get("subject") for f in task.steps for step in f.every_step()]
        assert (truths or last[-1:] or [None])[0] in (subject, None)
        assert subject in last


def test_ids_of_their_database_need_a_name() -> None:
    with pytest.raises(TaskError, match="nobody says what 6011 is called here"):
        imported("9001$6011 +")
    assert imported("9001$6011 +", n6011="refrigerator").steps[0].arguments == {
        "subject": "refrigerator"
    }


def test_json_arguments_of_the_rewrite_are_read() -> None:
    text = '9300${"announce": "Tea; is + ready | now"} 9900${"time": 5} + 9001${"x": 1.5, "y": 2} +'
    document = imported(text)
    assert kinds(document) == ["announce", "wait", "go_to", "return_home"]
    assert document.steps[0].arguments["words"] == "Tea; is + ready | now"
    assert document.steps[2].arguments["point"] == (1.5, 2.0)
    assert kinds(imported("9200$ 9201$ +")) == ["publish", "publish", "return_home"]


def test_parallel_groups_keep_their_shape() -> None:
    (node,) = read_rpn("9001$a 9007$b 9007$c | + 9900$1 +")
    assert isinstance(node, RpnGroup) and not node.is_parallel
    assert [isinstance(part, RpnSubtask) for part in node.parts] == [True, False, True]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "there is no subtask"),
        ("+", "has nothing before it"),
        ("9001$pid 9001$uid", "2 parts are not joined"),
        ("walk$pid", "is no subtask"),
        ("9999$pid +", "there is no subtask 9999; known: 9001"),
        ("9001 +", "expected where to move"),
        ("9001$wid +", "expected oid, uid, pid, rid or an id"),
        ("9001$-1$5 +", "expected -1$x$y$heading"),
        ("9001$-1$a$b$c +", "is no coordinate"),
        ("9001$-1$nan$1$1 +", "is no coordinate"),
        ('9001${"x":(a.b)} +', "a value of their blackboard"),
        ('9300${"announce" +', "not closed"),
        ("9300${1: 2} +", "no JSON arguments"),
        ('9300${"a": [1]} +', "expected names with texts"),
        ("9300$ +", "expected what to announce"),
        ("9900$-1 +", "from 0 to 3600 s"),
        ("9001$pid 9001$uid |", "only one of the parallel"),
        ("9100$ +", "move the nursing bed"),
        ("9001$pid +\n", "printable"),
        ("9001$pid + " * 1000, "at most 4000"),
    ],
)
def test_what_cannot_be_read_or_done_is_refused_in_words(text: str, words: str) -> None:
    with pytest.raises(TaskError) as refused:
        imported(text)
    assert words in str(refused.value)


@given(st.text("90123$+|; oiudp{}\"'(),.:-a", max_size=60))
def test_any_string_is_imported_or_refused(text: str) -> None:
    try:
        document = imported(text, tell=True)
    except TaskError:
        return
    assert document.steps[-1].kind is StepKind.RETURN_HOME


def test_every_subtask_that_cannot_be_done_says_why() -> None:
    for number in UNABLE:
        with pytest.raises(TaskError, match=f"subtask {number} would .*--tell"):
            imported(f"{number}$oid +")


def test_the_command_prints_a_document(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["9001$6011 +", "--name", "go", "--call", "6011=fridge"]) == 0
    assert read_task(capsys.readouterr().out).steps[0].arguments == {"subject": "fridge"}
    for wrong in (["9002$oid +", "--name", "go"], ["9001$pid +", "--name", "Go"],
                  ["9001$6 +", "--name", "go", "--call", "fridge"]):  # fmt: skip
        assert main(wrong) == 2
        assert capsys.readouterr().err
