"""One's own documents while the house runs: a wrong one is told, all others go on."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from housefly.errors import TaskError
from housefly.tasks.document.library import load_library
from housefly.tasks.document.open_library import OpenLibrary

GOOD = "name: {name}\ntitle: Mine\nsteps:\n  - land\n"
BROKEN = {
    "a step that there is not": "name: mine\ntitle: x\nsteps:\n  - dance\n",
    "no YAML": "name: mine\ntitle: [\n",
    "no text": b"\xff\xfe\x00",
    "too large": "# " + "x" * 10**6,
    "empty": "",
    "a call of what there is not": "name: mine\ntitle: x\nsteps:\n  - call: {task: nothing}\n",
}


def write(folder: Path, name: str, text: str | bytes) -> None:
    (folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())


@pytest.mark.parametrize("text", BROKEN.values(), ids=BROKEN)
def test_a_wrong_document_is_told_with_its_file_and_all_others_go_on(
    tmp_path: Path, text: str | bytes
) -> None:
    write(tmp_path, "mine.yaml", text)
    write(tmp_path, "other.yaml", GOOD.format(name="other"))
    library = OpenLibrary(tmp_path)
    assert set(library) == {*load_library(), "other"}
    (problem,) = library.problems
    assert "mine.yaml, line " in problem
    assert [one.problem for one in library.services() if one.problem] == [problem]
    with pytest.raises(TaskError, match=r"mine\.yaml"):
        library.document("mine")


def test_what_calls_a_wrong_document_is_wrong_itself(tmp_path: Path) -> None:
    write(tmp_path, "mine.yaml", BROKEN["a step that there is not"])
    write(tmp_path, "caller.yaml", "name: caller\ntitle: x\nsteps:\n  - call: {task: mine}\n")
    library = OpenLibrary(tmp_path)
    assert {one.name for one in library.services() if one.problem} == {"mine", "caller"}
    write(tmp_path, "mine.yaml", GOOD.format(name="mine"))
    assert not [one for one in library.services() if one.problem]
    assert {"mine", "caller"} <= set(library)


def test_documents_that_call_in_a_ring_are_wrong_and_the_others_go_on(tmp_path: Path) -> None:
    for one, other in (("ping", "pong"), ("pong", "ping")):
        text = f"name: {one}\ntitle: x\nsteps:\n  - call: {{task: {other}}}\n"
        write(tmp_path, f"{one}.yaml", text)
    library = OpenLibrary(tmp_path)
    assert set(library) == set(load_library()) and len(library.problems) == 2


def test_a_wrong_document_that_replaces_a_shipped_one_leaves_neither(tmp_path: Path) -> None:
    write(tmp_path, "v.yaml", "name: visitor\noverrides: true\ntitle: x\nsteps:\n  - dance\n")
    library = OpenLibrary(tmp_path)
    assert "visitor" not in library
    with pytest.raises(TaskError, match=r"v\.yaml, line 5"):
        library.document("visitor")


def test_a_document_of_a_shipped_name_takes_no_place_without_saying_so(tmp_path: Path) -> None:
    write(tmp_path, "look.yaml", GOOD.format(name="look"))
    library = OpenLibrary(tmp_path)
    assert library["look"] == load_library()["look"]
    assert "overrides: true" in library.problems[0]
    assert [one.name for one in library.services() if one.problem] == ["look.yaml"]


def test_of_two_of_one_name_the_first_counts_and_the_second_is_told(tmp_path: Path) -> None:
    for file in ("a.yaml", "b.yaml"):
        write(tmp_path, file, GOOD.format(name="mine"))
    library = OpenLibrary(tmp_path)
    assert library["mine"].source == "a.yaml" and "b.yaml, line 1" in library.problems[0]


def test_no_folder_is_told_and_the_shipped_services_go_on(tmp_path: Path) -> None:
    library = OpenLibrary(tmp_path / "none")
    assert set(library) == set(load_library()) and "no such folder" in library.problems[0]


def test_only_what_changed_is_read_again(tmp_path: Path) -> None:
    write(tmp_path, "mine.yaml", GOOD.format(name="mine"))
    library = OpenLibrary(tmp_path)
    before = library["mine"]
    library.refresh()
    assert library["mine"] is before
    os.utime(tmp_path / "mine.yaml", (1.0, 1.0))
    library.refresh()
    assert library["mine"] is not before and library["mine"] == before


def test_without_a_drone_nothing_that_flies_is_offered_or_given(tmp_path: Path) -> None:
    write(tmp_path, "greet.yaml", "name: greet\ntitle: Mine\nsteps:\n  - say: hello\n")
    library = OpenLibrary(tmp_path, has_drone=False)
    assert [one.name for one in library.services()] == ["greet"]
    assert library.document("greet").name == "greet"
    with pytest.raises(TaskError, match=r"^look needs a drone, and this room has none$") as refused:
        library.document("look")
    assert refused.value.code == "no_drone"


def test_without_a_camera_nothing_that_looks_is_offered_or_given(tmp_path: Path) -> None:
    write(tmp_path, "hop.yaml", "name: hop\ntitle: Mine\nsteps:\n  - take_off\n  - return_home\n")
    write(tmp_path, "calls.yaml", "name: calls\ntitle: x\nsteps:\n  - call: {task: panorama}\n")
    library = OpenLibrary(tmp_path, has_camera=False)
    assert "hop" in {one.name for one in library.services()}
    assert library.document("hop").flies and not library.document("hop").looks
    assert not {"look", "calls"} & {one.name for one in library.services()}
    with pytest.raises(
        TaskError, match=r"^look needs a camera, and the drone has none$"
    ) as refused:
        library.document("look")
    assert refused.value.code == "no_camera"
