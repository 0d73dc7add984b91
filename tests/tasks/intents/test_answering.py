"""A carer's ten questions, and more, answered from a real memory in three languages."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from remembered_room import RememberedRoom, a_day_with_grandma, today_at

from housefly.config.house_mode import HouseMode
from housefly.errors import LinkError
from housefly.evidence.clip_values import ClipInfo, ClipsAnswer, ClipsQuestion
from housefly.hub.api.questions import Question
from housefly.hub.client.room_queries import RoomQueries
from housefly.messages import OrderKind
from housefly.tasks.api.answers import TaskBoard
from housefly.tasks.api.questions import BoardQuestion, SetMode
from housefly.tasks.api.values import TaskRequest
from housefly.tasks.document.binding import bind
from housefly.tasks.document.library import load_library
from housefly.tasks.intents.answer_tasks import words_of_answer
from housefly.tasks.intents.answering import SERVICES, answer_intent
from housefly.tasks.intents.intent import (
    INTENT_SLOTS,
    LANGUAGES,
    Intent,
    IntentSlots,
    Language,
    NameKind,
    may_fly,
)
from housefly.tasks.intents.intent_reply import IntentReply, TaskAct
from housefly.tasks.intents.names import names_of
from housefly.tasks.intents.recognizer import recognize

VISITOR = TaskRequest("visitor")
FIND_BOOK = TaskRequest("find", {"thing": "book"})
LIST_FRIDGE = TaskRequest("inventory", {"subject": "refrigerator"})
CARER: dict[
    Language, tuple[tuple[str, tuple[str, ...], TaskRequest | None, TaskRequest | None], ...]
]
CARER = {
    "en": (
        ("where is grandma's cup?", ("cup", "cabinet", "2 minutes ago"), None, None),
        ("who came at three?", ("visitor", "15:02", "rang"), None, None),
        ("has she got up?", ("Yes, grandma", "7:05"), None, None),
        ("is the fridge empty?", ("know of nothing in the refrigerator",), None, LIST_FRIDGE),
        ("who is at the door?", ("Somebody", "20 seconds ago"), None, VISITOR),
        ("go and see", ("I go",), VISITOR, None),
        ("what happened last night?", ("22:10", "stove", "1:10"), None, None),
        ("where did I leave the book?", ("near the sofa", "2 hours ago"), None, FIND_BOOK),
        ("is anybody in the room?", ("Grandma is sitting",), None, None),
        ("call me when the bell rings", ("I tell you",), None, None),
    ),
    "de": (
        ("Wo ist Omas Tasse?", ("Tasse", "im Schrank", "vor 2 Minuten"), None, None),
        ("Wer kam um drei?", ("Besucher", "15:02", "klingelte"), None, None),
        ("Ist sie schon aufgestanden?", ("Ja, Oma", "7:05"), None, None),
        ("Ist der Kühlschrank leer?", ("nichts im Kühlschrank",), None, LIST_FRIDGE),
        ("Wer ist an der Tür?", ("Jemand", "vor 20 Sekunden"), None, VISITOR),
        ("Geh und sieh nach!", ("Ich sehe nach",), VISITOR, None),
        ("Was war letzte Nacht los?", ("22:10", "der Herd", "1:10"), None, None),
        ("Wo habe ich das Buch gelassen?", ("beim Sofa", "vor 2 Stunden"), None, FIND_BOOK),
        ("Ist jemand im Raum?", ("Oma sitzt",), None, None),
        ("Ruf mich, wenn es klingelt.", ("Ich sage Bescheid",), None, None),
    ),
    "ja": (
        ("おばあちゃんのカップはどこ?", ("カップ", "戸棚", "2分前"), None, None),
        ("3時に誰が来ましたか?", ("訪問者", "15時02分", "ベル"), None, None),
        ("もう起きましたか?", ("はい", "おばあちゃん", "7時05分"), None, None),
        ("冷蔵庫は空ですか?", ("冷蔵庫",), None, LIST_FRIDGE),
        ("玄関に誰がいますか?", ("誰か", "20秒前"), None, VISITOR),
        ("見てきて。", ("見てきます",), VISITOR, None),
        ("昨夜何がありましたか?", ("22時10分", "コンロ", "1時10分"), None, None),
        ("本をどこに置いたっけ?", ("ソファの近く", "2時間前"), None, FIND_BOOK),
        ("部屋に誰かいますか?", ("おばあちゃんは座って",), None, None),
        ("ベルが鳴ったら教えてください。", ("お知らせします",), None, None),
    ),
}  # fmt: skip


@pytest.fixture
def room(tmp_path: Path) -> Iterator[RememberedRoom]:
    made = a_day_with_grandma(tmp_path / "room.db")
    yield made
    made.memory.close()


def asked(room: RememberedRoom, text: str, language: Language = "en") -> IntentReply:
    names = names_of(room.things())
    intent = recognize(text, language, names)
    assert isinstance(intent, Intent), intent
    return answer_intent(intent, names, room, room.now)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_carers_ten_questions_are_answered(room: RememberedRoom, language: Language) -> None:
    assert len(CARER[language]) == 10
    for text, parts, request, offer in CARER[language]:
        reply = asked(room, text, language)
        assert all(part in reply.words for part in parts), (text, reply.words)
        assert (reply.request, reply.offer) == (request, offer), text
    notice = asked(room, CARER[language][-1][0], language).notice
    assert notice is not None
    assert notice.is_due("bell pressed", "doorbell") and not notice.is_due("door opened", "door")


@pytest.mark.parametrize("language", LANGUAGES)
def test_only_what_asks_for_a_flight_requests_one(room: RememberedRoom, language: Language) -> None:
    names = names_of(room.things())
    for text, *_ in CARER[language]:
        intent = recognize(text, language, names)
        assert isinstance(intent, Intent)
        assert (answer_intent(intent, names, room, room.now).request is not None) == may_fly(intent)


def test_what_was_just_seen_is_told_without_an_offer_and_find_goes_at_once(
    room: RememberedRoom,
) -> None:
    assert asked(room, "where is the cup").offer is None
    found = asked(room, "find the cup")
    assert found.request == TaskRequest("where", {"thing": "cup", "look": "always"})
    assert "in the cabinet" in found.words and "go and look" in found.words


@pytest.mark.parametrize(
    ("language", "words"), [("en", "find the book"), ("de", "such das Buch"), ("ja", "本を探して")]
)
def test_what_may_be_elsewhere_is_searched_for(
    room: RememberedRoom, language: Language, words: str
) -> None:
    assert asked(room, words, language).request == FIND_BOOK


def test_what_nobody_has_ever_seen_is_said_to_be_so(room: RememberedRoom) -> None:
    reply = asked(room, "where are the glasses")
    assert "Nobody has seen" in reply.words
    assert reply.offer == TaskRequest("find", {"thing": "glasses"})


def test_a_refrigerator_that_lists_nothing_is_empty_and_one_with_a_cup_is_not(
    room: RememberedRoom,
) -> None:
    room.says("refrigerator", room.now - 3.0, ("contents", ""))
    reply = asked(room, "is the fridge empty")
    assert (reply.words, reply.offer) == ("Yes, the refrigerator is empty (3 seconds ago).", None)
    room.see("cup", room.now - 2.0, inside="refrigerator")
    assert asked(room, "is the fridge empty").words == "No, in the refrigerator there is the cup."
    assert asked(room, "ist der Kühlschrank leer", "de").words.startswith("Nein, im Kühlschrank")


def test_who_asks_for_three_means_the_last_three_o_clock_at_which_somebody_came(
    room: RememberedRoom,
) -> None:
    room.happens("bell pressed", "doorbell", today_at("03:10"))
    assert "15:02" in asked(room, "who came at three").words
    assert "3:10" in asked(room, "who came at 3am").words
    assert "Nobody came" in asked(room, "who came at five").words
    assert "Nobody came" in asked(room, "who came yesterday").words


def test_a_state_is_answered_yes_or_no_in_each_language(room: RememberedRoom) -> None:
    assert asked(room, "is the stove on").words.startswith("Yes: the stove draws 1 420 W")
    assert asked(room, "ist der Herd an", "de").words == "Ja, der Herd: an (vor 5 Sekunden)."
    assert asked(room, "ist der Herd aus", "de").words.startswith("Nein, der Herd")
    assert asked(room, "コンロはついていますか", "ja").words.startswith("はい、コンロ")


def test_the_night_is_told_with_each_time_up(room: RememberedRoom) -> None:
    words = asked(room, "how was the night").words
    assert "up once" in words and "1:10" in words
    assert "1:10" in asked(room, "how often was grandma up last night").words


@pytest.mark.parametrize(
    ("text", "request_"),
    [
        ("look at the book", TaskRequest("look", {"subject": "book"})),
        ("go to the entrance", TaskRequest("look", {"subject": "entrance"})),
        ("look around", TaskRequest("panorama")),
        ("patrol the room", TaskRequest("patrol")),
        ("come here", TaskRequest("come")),
        ("come over to grandma", TaskRequest("come", {"person": "person-1"})),
        ("follow grandma", TaskRequest("follow", {"person": "person-1"})),
        ("look what is in the cabinet", TaskRequest("inventory", {"subject": "cabinet"})),
        ("make the night round", TaskRequest("night_round")),
        ("is everything all right", TaskRequest("all_right")),
        ("is grandma ok", TaskRequest("all_right", {"person": "person-1"})),
    ],
)
def test_services_are_requested_with_what_was_named(
    room: RememberedRoom, text: str, request_: TaskRequest
) -> None:
    assert asked(room, text).request == request_


def test_every_requested_service_is_shipped_and_takes_its_parameter() -> None:
    library = load_library()
    for service, parameter in SERVICES.values():
        assert service in library
        known = {one.name for one in library[service].info().parameters}
        assert parameter in known | {""}
    bind(library["where"], FIND_BOOK.parameters)


def test_orders_and_acts_are_told_apart_from_services(room: RememberedRoom) -> None:
    assert asked(room, "stop").order is OrderKind.STOP
    assert asked(room, "land").order is OrderKind.LAND
    assert asked(room, "come home").order is OrderKind.HOME
    assert asked(room, "cancel").act is TaskAct.CANCEL
    assert asked(room, "wait").act is TaskAct.PAUSE
    assert asked(room, "go on").act is TaskAct.CONTINUE
    assert asked(room, "good night").question == SetMode(HouseMode.NIGHT)
    assert asked(room, "which mode is set").question == BoardQuestion()


def test_recordings_are_asked_for_by_what_they_show_and_told_in_words(
    room: RememberedRoom,
) -> None:
    names = names_of(room.things())
    intent = recognize("show me the clip of the visitor", "en", names)
    assert isinstance(intent, Intent)
    question = answer_intent(intent, names, room, room.now).question
    assert isinstance(question, ClipsQuestion)
    assert (question.person, question.thing, question.until) == ("visitor", "", room.now)
    clip = ClipInfo("1", "clip", 1, "visitor", "", "", (), "", room.now - 3480.0, 20.0, 1)
    told = words_of_answer(intent, ClipsAnswer((clip,)), names, room.now)
    assert told == "One recording, of 15:02."
    assert "no recording" in words_of_answer(intent, ClipsAnswer(()), names, room.now)
    board = TaskBoard(room.now, HouseMode.AWAY, "", False, (), ())
    assert words_of_answer(intent, board, names, room.now) == "The house is set to: away."


def test_who_wants_to_be_told_is_told_of_that_and_nothing_else(room: RememberedRoom) -> None:
    notice = asked(room, "tell me when grandma gets up").notice
    assert notice is not None
    assert notice.is_due("person lying ended", "person-1")
    assert not notice.is_due("person lying ended", "visitor")
    notice = asked(room, "tell me when the stove is off").notice
    assert notice is not None and notice.is_due("appliance on ended", "stove")
    notice = asked(room, "remind me in ten minutes").notice
    assert notice is not None and notice.at == room.now + 600.0
    assert not notice.is_due_at(room.now + 599.0) and notice.is_due_at(room.now + 600.0)
    notice = asked(room, "remind me at half past four").notice
    assert notice is not None and notice.at == today_at("16:30")
    assert asked(room, "tell me when the stove is hot").notice is None


class NobodyThere(RoomQueries):
    def ask(self, question: Question) -> object:
        raise LinkError("no hub")


@pytest.mark.parametrize("language", LANGUAGES)
def test_without_a_memory_the_answer_says_so_and_orders_still_pass(
    room: RememberedRoom, language: Language
) -> None:
    names = names_of(room.things())
    for text, *_ in CARER[language][:4]:
        intent = recognize(text, language, names)
        assert isinstance(intent, Intent)
        reply = answer_intent(intent, names, NobodyThere(), room.now)
        assert reply.words and reply.request is None
    stop = recognize("stop", language, names)
    assert isinstance(stop, Intent)
    assert answer_intent(stop, names, NobodyThere(), room.now).order is OrderKind.STOP


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_intent_is_answered_in_every_language(
    room: RememberedRoom, language: Language
) -> None:
    names = names_of(room.things())
    about = {"subject": "person-1", "subject_kind": NameKind.PERSON, "state": "here",
             "event": "bell", "service": "water_plants"}  # fmt: skip
    for name, slots in INTENT_SLOTS.items():
        for given in (slots.required, (slots.required | slots.optional) & set(about)):
            said = IntentSlots(**{slot: about[slot] for slot in given})  # type: ignore[arg-type]
            reply = answer_intent(Intent(name, said, "", language), names, room, room.now)
            assert reply.words, name
            assert "{" not in reply.words, reply.words
