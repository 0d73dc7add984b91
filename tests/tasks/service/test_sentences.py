"""Sentences of somebody who may only ask, said to the whole task service."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from task_stage import TaskStage

from housefly.bus.topics import HUB_QUERY
from housefly.config.house_mode import HouseMode
from housefly.errors import TaskError
from housefly.messages import DroneStatus, OrderKind, OrderSource
from housefly.tasks.api.questions import BoardQuestion, RequestTask, Sentence, SetMode
from housefly.tasks.api.values import Confirm, ReasonCode, RequestSurface
from housefly.tasks.api.values import TaskStage as Stage
from housefly.tasks.intents.intent import LANGUAGES, Language
from housefly.tasks.intents.phrases import phrases


@pytest.fixture
def stage(tmp_path: Path) -> Iterator[TaskStage]:
    stage = TaskStage(tmp_path)
    yield stage
    stage.close()


@pytest.mark.parametrize(
    "text", ["come home", "wait", "go on", "cancel", "set the house to home", "we are back"]
)
def test_who_may_not_fly_changes_nothing_by_a_sentence(stage: TaskStage, text: str) -> None:
    stage.ask(RequestTask("look", {"subject": "refrigerator"}, by="kim"))
    stage.ask(SetMode(HouseMode.AWAY, "kim"))
    before = stage.ask(BoardQuestion())
    answer = stage.ask(Sentence(text, by="eve", may_fly=False))
    assert answer.understood and "may fly" in answer.words
    after = stage.ask(BoardQuestion())
    assert (after.mode, after.tasks, after.ended) == (before.mode, before.tasks, before.ended)
    assert stage.orders == []


@pytest.mark.parametrize(("text", "kind"), [("stop", OrderKind.STOP), ("land", OrderKind.LAND)])
def test_who_may_not_fly_stops_and_lands(stage: TaskStage, text: str, kind: OrderKind) -> None:
    stage.stand()
    stage.ask(Sentence(text, by="eve", may_fly=False))
    assert [order.kind for order in stage.orders] == [kind]


def test_stop_waits_for_no_memory(stage: TaskStage, monkeypatch: pytest.MonkeyPatch) -> None:
    asked, ask = list[str](), stage.bus.ask

    def counted(query: str, *given: Any) -> str:
        asked.append(query)
        return ask(query, *given)

    monkeypatch.setattr(stage.bus, "ask", counted)
    stage.ask(Sentence("please stop!", by="eve"))
    assert [order.kind for order in stage.orders] == [OrderKind.STOP] and asked == []
    stage.ask(Sentence("land", by="eve"))
    assert asked == [HUB_QUERY]


def test_who_may_not_fly_ends_his_own_task(stage: TaskStage) -> None:
    for name, subject in (("kim", "refrigerator"), ("eve", "sofa")):
        stage.ask(RequestTask("look", {"subject": subject}, by=name, owner=f"~{name}"))
    answer = stage.ask(Sentence("cancel", by="eve", may_fly=False, owner="~eve"))
    assert answer.task is not None and answer.task.asked_by == "eve"
    assert answer.task.state is Stage.CANCELLED
    assert [task.asked_by for task in stage.ask(BoardQuestion()).tasks] == ["kim"]


def test_no_name_makes_the_order_of_a_sentence_one_of_a_task(stage: TaskStage) -> None:
    stage.stand()
    stage.ask(Sentence("come home", by="task 1: look"))
    (order,) = stage.orders
    assert order.kind is OrderKind.HOME and order.source is OrderSource.PERSON


ORDERED = {
    "en": ("stop", "STOP is ordered.", "land", "The order to land is given."),
    "de": ("stopp", "STOPP ist befohlen.", "lande", "Der Befehl zu landen ist gegeben."),
    "ja": ("止まって", "停止を命じました。", "着陸して", "着陸を命じました。"),
}
PLACES = {
    "en": ("is in the air now", "stands on the ground", "does not tell"),
    "de": ("jetzt in der Luft", "steht am Boden", "sagt ihr Pilot gerade nicht"),
    "ja": ("今飛んでいます", "地上にいます", "連絡がありません"),
}


@pytest.mark.parametrize("language", LANGUAGES)
def test_an_order_is_said_to_be_ordered_and_where_the_drone_truly_is(
    stage: TaskStage, language: Language
) -> None:
    stop, stopped, land, landed = ORDERED[language]
    air, ground, unknown = PLACES[language]
    for text, words in ((stop, stopped), (land, landed)):
        assert stage.ask(Sentence(text, language)).words.startswith(words)
    assert unknown in stage.ask(Sentence(land, language)).words
    stage.stand(1.0, DroneStatus.FLYING)
    assert air in stage.ask(Sentence(land, language)).words
    stage.stand(1.0)
    assert ground in stage.ask(Sentence(land, language)).words
    for surface in (RequestSurface.MQTT, RequestSurface.ASSISTANT):
        given = len(stage.orders)
        answer = stage.ask(Sentence(land, language, surface=surface, may_fly=False))
        assert len(stage.orders) == given and answer.code is ReasonCode.NOT_ALLOWED
        assert answer.words == phrases(language)("only_people")


@pytest.mark.parametrize(
    "text", ["look at the sofa", "land", "cancel", "set the house to away", "call me when it rings"]
)
def test_what_is_only_to_be_answered_is_not_said_to_be_done(stage: TaskStage, text: str) -> None:
    answer = stage.ask(Sentence(text, fly=False))
    assert answer.words == "Nothing was started: this was only to be answered.", answer
    assert stage.orders == [] and stage.ask(BoardQuestion()).mode is HouseMode.HOME


def test_a_question_is_answered_also_where_nothing_may_be_started(stage: TaskStage) -> None:
    assert "home" in stage.ask(Sentence("which mode is it", fly=False)).words
    assert "home" in stage.ask(Sentence("which mode is it", surface=RequestSurface.MQTT)).words


HARD = {
    "de": (
        "schau nach dem Sofa", "schau nach dem Einhorn", "lande", "stopp", "brich ab",
        "mach weiter", "warte", "komm zurück", "Wo ist das Einhorn?", "blaue Ideen schlafen",
        "Wer ist an der Tür?", "Welcher Modus ist an?", "gute Nacht", "zeig mir das Video",
        "Ruf mich, wenn es klingelt.", "Ist alles in Ordnung?", "hilfe", "Wo ist das Sofa?",
        "Ist der Kühlschrank leer?", "was war letzte Nacht los?", "Ist das Sofa an?",
    ),
    "ja": (
        "ソファを見て", "ユニコーンを見て", "着陸して", "止まって", "キャンセル", "続けて",
        "待って", "戻って", "ユニコーンはどこ?", "青い考えが眠る", "玄関に誰がいますか", "おやすみ",
        "動画を見せて", "ベルが鳴ったら教えて", "大丈夫ですか", "ヘルプ", "ソファはどこ?",
        "冷蔵庫は空ですか", "昨夜何がありましたか", "もう起きましたか", "3時に誰が来ましたか",
    ),
}  # fmt: skip
SURFACES = (RequestSurface.CONSOLE, RequestSurface.MQTT)
_ENGLISH = re.compile(
    r"\b(the|is|are|not|only|task|nobody|somebody|service|house|mode|there|may|waits?)\b", re.I
)


@pytest.mark.parametrize("surface", SURFACES)
@pytest.mark.parametrize("language", HARD)
@pytest.mark.parametrize("mode", [HouseMode.HOME, HouseMode.MAINTENANCE])
def test_who_asks_in_a_language_is_answered_in_it_whatever_the_answer_is(
    stage: TaskStage, language: Language, surface: RequestSurface, mode: HouseMode
) -> None:
    stage.ask(SetMode(mode))
    may_fly = surface is RequestSurface.CONSOLE
    for text in HARD[language]:
        try:
            answer = stage.ask(Sentence(text, language, surface=surface, may_fly=may_fly))
            words = " ".join((answer.words, *answer.suggestions))
        except TaskError as error:
            words = str(error)
            assert error.code in {code.value for code in ReasonCode}
        assert words and not _ENGLISH.search(words), (text, words)
        if language == "ja":
            assert not re.search(r"[a-z]{4,}", words), (text, words)
        stage.clock.advance(30.0)
        if text in ("gute Nacht", "おやすみ"):
            stage.ask(SetMode(mode))


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_reason_has_words_in_each_language(language: Language) -> None:
    texts = phrases(language).texts
    wanted = {f"reason {code.value}" for code in ReasonCode if code is not ReasonCode.OK}
    assert wanted == {key for key in texts if key.startswith("reason ")}


@pytest.mark.parametrize(
    ("said", "page", "language"),
    [
        ("wo ist der Kühlschrank?", "en", "de"),
        ("冷蔵庫はどこ", "en", "ja"),
        ("where is the refrigerator?", "ja", "en"),
        ("where is the refrigerator?", "de", "en"),
        ("冷蔵庫はどこ", "de", "ja"),
    ],
)
def test_who_speaks_another_language_than_the_page_is_answered_in_theirs(
    stage: TaskStage, said: str, page: Language, language: Language
) -> None:
    there = stage.ask(Sentence(said, page))
    own = stage.ask(Sentence(said, language))
    assert there.understood and (there.intent, there.words) == (own.intent, own.words)


def test_what_no_language_understands_is_answered_in_that_of_the_page(stage: TaskStage) -> None:
    for page in LANGUAGES:
        told = stage.ask(Sentence("xyzzy plugh 42", page))
        assert not told.understood and told.words == stage.ask(Sentence("plugh", page)).words


def test_the_question_before_a_flight_is_in_the_words_in_which_it_was_asked_for(
    stage: TaskStage,
) -> None:
    asked = stage.ask(Sentence("have a look at the refrigerator", by="Anna", confirm=Confirm.ASK))
    assert asked.task is not None and asked.task.question is not None
    words = asked.task.question.words
    assert words == "Fly 'have a look at the refrigerator'? Asked for by Anna."
    plain = stage.ask(RequestTask("look", {"subject": "tv"}, by="Anna", confirm=Confirm.ASK))
    assert "Look at a place or a thing: tv" in plain.tasks[0].question.words


def test_a_place_that_the_room_has_not_is_told_at_once_and_nobody_is_asked(
    stage: TaskStage,
) -> None:
    with pytest.raises(TaskError, match="no place called 'cellar'") as refused:
        stage.ask(RequestTask("visitor", {"door": "cellar"}, confirm=Confirm.ASK))
    assert refused.value.code == ReasonCode.UNKNOWN_PLACE.value
    board = stage.ask(BoardQuestion())
    assert not board.tasks and not board.ended
    assert stage.ask(RequestTask("visitor", {"door": "entrance"}, confirm=Confirm.ASK)).tasks
