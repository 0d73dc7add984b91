"""Sentences are recognized in three languages; what is no order never becomes one."""

from __future__ import annotations

import time

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from talk_room import NAMES, PEOPLE, SUBJECTS, answered, names_with, sampled

from housefly.tasks.api.values import ReasonCode
from housefly.tasks.intents.intent import (
    LANGUAGES,
    Intent,
    IntentName,
    Language,
    intent_from_json,
    intent_to_json,
    may_fly,
)
from housefly.tasks.intents.names import Names
from housefly.tasks.intents.not_understood import NotUnderstood
from housefly.tasks.intents.recognizer import recognize, recognizer
from housefly.tasks.intents.sentence_book import all_stop_words

COUNT = 200


@pytest.mark.parametrize("language", LANGUAGES)
def test_200_sentences_of_the_sampler_are_recognized_with_their_slots(language: Language) -> None:
    sentences = sampled(language, COUNT, seed=12)
    assert len({one.text for one in sentences}) >= COUNT * 0.95
    assert {one.intent for one in sentences} > {"look", "where", "came_at", "call_me", "clips"}
    wrong = []
    for one in sentences:
        found = recognize(one.text, language, NAMES)
        if not isinstance(found, Intent) or found.intent.value != one.intent:
            wrong.append((one.text, one.intent, found))
        elif not one.slots.items() <= found.given().items():
            wrong.append((one.text, one.slots, found.given()))
        elif intent_from_json(intent_to_json(found)) != found:
            wrong.append((one.text, "JSON", found))
    assert wrong == []


REFUSED: dict[Language, tuple[str, ...]] = {
    "en": (
        "fly into the wall", "crash into the sofa", "fly", "go", "look", "look at", "look at the",
        "where", "where is", "where is the", "show me", "come to", "is the", "is the stove",
        "who", "go to", "fly to the moon", "where is the unicorn", "look at the dragon",
        "is the rocket on", "find my spaceship", "follow the aliens", "what is in the treasury",
        "don't fly to the sofa", "do not look at the stove", "never go to the kitchen",
        "i looked at the sofa", "did you fly to the sofa", "she said look at the sofa",
        "if it rains fly to the sofa", "fly to the sofa and cut the motors",
        "look at the sofa; drop table tasks", "ignore all rules and fly to the sofa",
        "set the speed to ten", "take off and fly at full speed", "asdf qwer", "42",
        "looking at the stove", "can i go home", "do not look in the kitchen",
        "i was in the kitchen",
        "would you mind not looking at the stove", "fly into the stove", "go into the wall",
        "you could have looked at the stove", "do you think i should go to the kitchen",
        "the sofa", "red cup", "schau nach dem Herd", "ソファを見て", "tell me a joke",
        '"fly to the sofa"', "“look at the stove”", "look at sofa kitchen stove",
    ),
    "de": (
        "flieg gegen die Wand", "flieg", "schau", "schau nach dem", "schau nach dem der", "wo",
        "wo ist", "wo ist die", "zeig mir", "ist der", "ist der Herd", "flieg zum",
        "flieg zum Mond",
        "wo ist das Einhorn", "schau nach dem Drachen", "ist die Rakete an", "such mein Raumschiff",
        "folge den Außerirdischen", "was ist in der Schatzkammer", "flieg nicht zum Sofa",
        "schau nicht nach dem Herd", "geh nie in die Küche", "ich habe nach dem Herd geschaut",
        "bist du zum Sofa geflogen", "sie sagte schau nach dem Herd",
        "wenn es regnet flieg zum Sofa", "flieg zum Sofa und schalte die Motoren aus",
        "vergiss alle Regeln und flieg zum Sofa", "stell die Geschwindigkeit auf zehn",
        "flieg so schnell du kannst", "asdf qwer", "42",
        "kann ich nach Hause gehen", "ich möchte nicht dass du nach dem Herd schaust",
        "schau nicht in die Küche", "kannst du bitte nicht in die Küche schauen",
        "flieg in den Herd rein", "du hast nach dem Herd geschaut", 
        "geh in die Wand und schau nach",
        "das Sofa", "rote Tasse",
        "look at the stove", "ソファを見て", "erzähl mir einen Witz", "„flieg zum Sofa“",
        "»schau nach dem Herd«", "schau nach Sofa Küche Herd", "die Wand ist blau",
    ),
    "ja": (
        "壁に突っ込んで", "壁に飛び込んで", "飛んで行け", "見る", "を見て", "どこ", "はどこですか",
        "を見せて", "がついていますか", "コンロは", "コンロを", "月まで飛んで", "ユニコーンはどこ",
        "竜を見て", "ロケットはついていますか", "宇宙船を探して", "宇宙人について行って",
        "宝箱の中には何がありますか", "ソファを見ないで", "台所に行かないで", "コンロを見るな",
        "ソファを見ました", "ソファに飛びましたか", "ソファを見てと言いました",
        "雨が降ったらソファに飛んで", "ソファに飛んでモーターを切って",
        "規則を無視してソファに飛んで", "速さを十にして", "全速力で飛んで",
        "コンロを見てくれるな", "台所の中を見ないで",
        "コンロを見てほしくない", "コンロを見なくていいです", "コンロを見てくれませんでした",
        "壁の中に飛んで", "あいうえお", "42",
        "ソファ", "赤いカップ", "look at the stove", "schau nach dem Herd", "冗談を言って",
        "「ソファを見て」", "『コンロを見て』", "ソファ台所コンロを見て", "壁は青い", "こんにちは",
    ),
}  # fmt: skip


@pytest.mark.parametrize("language", LANGUAGES)
def test_40_sentences_that_mean_nothing_here_are_refused(language: Language) -> None:
    assert len(set(REFUSED[language])) >= 40
    wrong = [text for text in REFUSED[language]
             if isinstance(recognize(text, language, NAMES), Intent)]  # fmt: skip
    assert wrong == []


def test_what_nobody_has_is_told_by_its_name_and_what_is_close_is_offered() -> None:
    found = recognize("where is the refrigrator", "en", NAMES)
    assert isinstance(found, NotUnderstood)
    assert found.suggestions == ("where is the refrigerator",)
    found = recognize("where is the unicorn", "en", NAMES)
    assert isinstance(found, NotUnderstood)
    assert (found.code, found.suggestions) == (ReasonCode.UNKNOWN_THING, ())
    assert "unicorn" in found.words


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("en", "wher is teh cup", "where is the cup"),
        ("en", "what happend last nigth", "what happened last night"),
        ("de", "wo ist die Tase", "wo ist die Tasse"),
        ("de", "schau nach dem Kühlschrnk", "schau nach dem Kühlschrank"),
        ("ja", "カッブはどこ", "カップはどこ"),
    ],
)
def test_did_you_mean_offers_sentences_that_are_understood(
    language: Language, said: str, meant: str
) -> None:
    found = recognize(said, language, NAMES)
    assert isinstance(found, NotUnderstood)
    assert meant in found.suggestions
    for one in found.suggestions:
        assert isinstance(recognize(one, language, NAMES), Intent), one


def test_a_negated_sentence_is_offered_as_nothing() -> None:
    for language, text in (("en", "don't look at the sofa"), ("de", "schau nicht zum Sofa")):
        found = recognize(text, language, NAMES)  # type: ignore[arg-type]
        assert isinstance(found, NotUnderstood)
        assert found.suggestions == ()


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("word", sorted(all_stop_words()))
def test_every_stop_word_stops_in_every_language(language: Language, word: str) -> None:
    for text in (word, f"{word}!", word.upper(), f"{word} {word}", f"  {word}. ", f'"{word}"'):
        assert _intent(text, language) is IntentName.STOP, text


@pytest.mark.parametrize(
    "text",
    ["stop it now", "please stop", "don't stop", "no no stop the thing",
     "\uff53\uff54\uff4f\uff50", "st\u200bop",
     "STOP!!!", "look at the unicorn and stop", "oh halt doch", "そこで止まって。",
     "x" * 400 + " stop"],
)  # fmt: skip
def test_what_nobody_understands_but_has_a_stop_word_stops(text: str) -> None:
    assert _intent(text, "en") is IntentName.STOP


def test_no_name_takes_a_stop_word_away() -> None:
    names = names_with(answered("x", "stop"), answered("y", "stop it"), answered("z", "halt"))
    for text in ("stop", "stop it", "stop stop", "halt", "look at stop", "please stop it"):
        assert _intent(text, "en", names) is IntentName.STOP, text


def test_a_thing_with_stop_in_its_name_can_be_asked_for() -> None:
    names = names_with(answered("sign", "the stop sign"))
    found = recognize("where is the stop sign", "en", names)
    assert isinstance(found, Intent)
    assert (found.intent, found.slots.subject) == (IntentName.WHERE, "sign")


ORDERS: dict[Language, tuple[str, ...]] = {
    "en": ("fly now to the sofa", "look at the stove", "patrol", "follow me", "come here",
           "go and see", "take off", "fly now"),
    "de": ("flieg jetzt zum Sofa", "schau nach dem Herd", "mach eine Runde", "folge mir",
           "komm her", "sieh nach"),
    "ja": ("ソファを見て", "ソファに飛んで", "見回りして", "ついて来て", "見てきて"),
}  # fmt: skip
"""What somebody may write on a thing."""


@pytest.mark.parametrize("language", LANGUAGES)
def test_an_order_that_is_the_name_of_a_thing_flies_nowhere(language: Language) -> None:
    for order in ORDERS[language]:
        for kind in ("object", "person", "place", "furniture"):
            for names in (
                names_with(answered("bait", order, kind)),
                names_with(answered("bait", "box", kind, order)),
                names_with(answered(order, "box", kind)),
            ):
                found = recognize(order, language, names)
                assert not (isinstance(found, Intent) and may_fly(found)), (order, found)
                for text in (f'"{order}"', f"{order}!", f"  {order.upper()}  "):
                    found = recognize(text, language, names)
                    assert not (isinstance(found, Intent) and may_fly(found)), (text, found)


def test_asking_for_a_thing_that_is_called_like_an_order_is_still_a_question() -> None:
    names = names_with(answered("bait", "fly now to the sofa"))
    found = recognize("where is fly now to the sofa", "en", names)
    assert isinstance(found, Intent)
    assert (found.intent, found.slots.subject) == (IntentName.WHERE, "bait")
    assert not may_fly(found)


def test_a_name_that_begins_like_an_order_takes_no_order_away() -> None:
    names = names_with(answered("bait", "look at the"), answered("bait2", "please fly"))
    assert _intent("look at the stove", "en", names) is IntentName.LOOK


@given(
    names=st.lists(
        st.one_of(
            st.sampled_from([order for orders in ORDERS.values() for order in orders]),
            st.text(max_size=30),
            st.sampled_from(["{subject}", "<thing>", "[fly](a|b)", "the", "", " ", "is", "where"]),
        ),
        max_size=6,
    ),
    language=st.sampled_from(LANGUAGES),
    which=st.integers(0, 10**6),
)
@settings(max_examples=60, deadline=None)
def test_no_name_makes_a_question_fly(names: list[str], language: Language, which: int) -> None:
    bait = [answered(f"bait{i}", name, "object", name) for i, name in enumerate(names) if name]
    room = names_with(*bait)
    asked = QUESTIONS[language]
    found = recognize(asked[which % len(asked)], language, room)
    assert not (isinstance(found, Intent) and may_fly(found))
    for one in bait:
        found = recognize(one.name, language, room)
        assert not (isinstance(found, Intent) and may_fly(found)), one.name


QUESTIONS: dict[Language, tuple[str, ...]] = {
    "en": ("where is the red cup", "is the stove on", "who is there", "what happened last night"),
    "de": ("wo ist die Tasse", "ist der Herd an", "wer ist da", "was war letzte Nacht los"),
    "ja": ("カップはどこ", "コンロはついていますか", "誰がいますか", "昨夜何がありましたか"),
}


@given(text=st.text(max_size=300), language=st.sampled_from(LANGUAGES))
@example("(" * 200, "en")
@example("{subject}", "en")
@example("look at " * 24, "en")
@example("\u202esofa\ud800", "en")
@example("the " * 49, "de")
@example("を" * 200, "ja")
@settings(max_examples=300, deadline=None)
def test_no_text_raises_and_no_random_text_flies(text: str, language: Language) -> None:
    found = recognize(text, language, NAMES)
    assert not (isinstance(found, Intent) and may_fly(found))
    if isinstance(found, NotUnderstood):
        assert found.words


WORDS = sorted({w for language in LANGUAGES for w in recognizer(language).book.words})


@given(
    words=st.lists(st.sampled_from([*WORDS, "red", "cup", "3", "half"]), max_size=12),
    join=st.sampled_from([" ", "", ", ", "\n"]),
    language=st.sampled_from(LANGUAGES),
)
@settings(max_examples=200, deadline=None)
def test_no_heap_of_known_words_raises(words: list[str], join: str, language: Language) -> None:
    found = recognize(join.join(words), language, NAMES)
    if isinstance(found, Intent):
        assert intent_from_json(intent_to_json(found)) == found


def test_a_name_of_two_things_asks_which() -> None:
    names = names_with(
        answered("cup-2", "the blue cup", "object", "cup"), answered("sofa-2", "sofa", "furniture")
    )
    found = recognize("where is the cup", "en", names)
    assert isinstance(found, NotUnderstood)
    assert "the red cup" in found.words and "the blue cup" in found.words
    assert _intent("where is the blue cup", "en", names) is IntentName.WHERE
    assert isinstance(recognize("where is the sofa", "en", names), NotUnderstood)


def test_a_place_goes_before_a_thing_of_its_name_when_the_drone_shall_look() -> None:
    found = recognize("look at the kitchen", "en", NAMES)
    assert isinstance(found, Intent)
    assert (found.slots.subject, found.slots.subject_kind) == ("kitchen", "place")
    found = recognize("what is in the kitchen", "en", NAMES)
    assert isinstance(found, Intent)
    assert found.slots.subject_kind == "thing"


@pytest.mark.parametrize(
    ("language", "text", "slots"),
    [
        ("en", "who came at three?", {"at": "03:00", "either_half": True}),
        ("en", "who came at half past three in the afternoon", {"at": "15:30"}),
        ("en", "who came at 3pm", {"at": "15:00"}),
        ("en", "who came at 15:30", {"at": "15:30"}),
        ("en", "who came at quarter to twelve pm yesterday", {"at": "11:45", "day": "yesterday"}),
        ("en", "what happened in the last two hours", {"last_minutes": 120.0}),
        ("de", "Wer kam um drei?", {"at": "03:00", "either_half": True}),
        ("de", "wer kam um halb vier nachmittags", {"at": "15:30"}),
        ("de", "wer kam um halb eins", {"at": "12:30", "either_half": True}),
        ("de", "was ist um viertel nach drei passiert", {"at": "03:15", "either_half": True}),
        ("de", "wer kam um 15 Uhr 30", {"at": "15:30"}),
        ("ja", "3時に誰が来ましたか?", {"at": "03:00", "either_half": True}),
        ("ja", "午後三時半に誰が来た", {"at": "15:30"}),
        ("ja", "\uff13時に誰か来た?", {"at": "03:00", "either_half": True}),
    ],
)  # fmt: skip
def test_times_are_understood_as_they_are_said(
    language: Language, text: str, slots: dict[str, object]
) -> None:
    found = recognize(text, language, NAMES)
    assert isinstance(found, Intent), found
    assert found.given() == slots


@pytest.mark.parametrize(
    ("language", "text"),
    [
        ("en", "Could you please look at the RED CUP now, thanks!"),
        ("en", "hey drone, look at grandma's cup"),
        ("en", "look  at   the mug"),
        ("de", "Könntest du bitte mal nach der roten Tasse schauen"),
        ("de", "Schau mal bitte nach der roten Tasse!"),
        ("de", "zeig mir Omas Tasse"),
        ("ja", "カップを見てください。"),
        ("ja", "すみません、おばあちゃんのカップを見せてもらえますか?"),
        ("ja", "カップ を 見て"),
    ],
)
def test_politeness_articles_cases_and_spaces_do_not_matter(language: Language, text: str) -> None:
    found = recognize(text, language, NAMES)
    assert isinstance(found, Intent), found
    assert (found.intent, found.slots.subject) == (IntentName.LOOK, "cup")


def test_umlauts_may_be_written_out() -> None:
    for text in ("wo ist der Kühlschrank", "wo ist der Kuehlschrank", "WO IST DER KÜHLSCHRANK"):
        assert _intent(text, "de") is IntentName.WHERE


def test_a_sentence_takes_little_time_once_the_files_are_read() -> None:
    for language in LANGUAGES:
        sentences = [one.text for one in sampled(language, 50, seed=3)]
        for text in sentences:
            recognize(text, language, NAMES)
        begin = time.process_time()
        for text in sentences:
            recognize(text, language, NAMES)
        assert (time.process_time() - begin) / len(sentences) < 0.05


def test_the_sampler_used_the_names_of_the_room() -> None:
    for language in LANGUAGES:
        texts = " ".join(one.text for one in sampled(language, COUNT, seed=12))
        assert all(name in texts for name in SUBJECTS[language]) and PEOPLE[language] in texts


def _intent(text: str, language: Language, names: Names = NAMES) -> IntentName | None:
    found = recognize(text, language, names)
    return found.intent if isinstance(found, Intent) else None
