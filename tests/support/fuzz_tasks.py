"""Fuzz targets: task documents, rules, what is asked of the tasks, and sentences."""

from __future__ import annotations

import json
from collections.abc import Iterable
from datetime import UTC
from functools import cache

from fuzz_target import DEEP, HUGE, FuzzTarget, as_file, scratch
from rule_bench import KnownRoom, make_rule
from talk_room import NAMES

from housefly.config.house_mode import HouseMode
from housefly.config.tasks import TasksConfig
from housefly.errors import ConfigError, LinkError, TaskError, WireError
from housefly.evidence.clip_values import ClipsQuestion
from housefly.hub.api.answers import Answer
from housefly.hub.api.questions import Question
from housefly.hub.client.room_queries import AskedRoom
from housefly.tasks.api.json import (
    task_answer_from_json,
    task_answer_to_json,
    task_question_from_json,
    task_question_to_json,
)
from housefly.tasks.api.questions import (
    BoardQuestion,
    CancelTask,
    RequestTask,
    RulesQuestion,
    Sentence,
    ServicesQuestion,
    TaskHistoryQuestion,
)
from housefly.tasks.api.values import RequestSurface, ServiceInfo
from housefly.tasks.document.library import SHIPPED, bind, linked, load_library, read_task, text_of
from housefly.tasks.document.marked_yaml import SIZE_MAX
from housefly.tasks.document.open_library import OpenLibrary
from housefly.tasks.document.rpn_import import import_rpn
from housefly.tasks.document.task_document import TaskDocument
from housefly.tasks.document.writer import task_to_yaml
from housefly.tasks.intents.answering import answer_intent
from housefly.tasks.intents.intent import LANGUAGES, Intent, intent_from_json, intent_to_json
from housefly.tasks.intents.recognizer import recognize
from housefly.tasks.intents.sentence_book import sentence_book
from housefly.tasks.rules.mqtt_requests import mqtt_question
from housefly.tasks.rules.rule import Pattern
from housefly.tasks.rules.rule_engine import RuleEngine
from housefly.tasks.rules.rule_file import read_rules, rule_problems
from housefly.tasks.rules.rule_memory import RuleMemory, memory_from_json, memory_to_json
from housefly.tasks.rules.rule_store import RuleStore
from housefly.tasks.rules.trigger import MqttTrigger, WebhookTrigger, fits, value_of

_NOW = 1_763_812_800.0
_NESTED = DEEP[:100]
_ASKED = (BoardQuestion(), ServicesQuestion(), RulesQuestion(), ClipsQuestion(), CancelTask())
_TRUSTED = TasksConfig(mqtt_requests="auto", mqtt_clients=("panel",))
_CONFIGS = (TasksConfig(mqtt_requests="ask"), _TRUSTED)


@cache
def _library() -> dict[str, TaskDocument]:
    return load_library()


@cache
def _services() -> dict[str, ServiceInfo]:
    return {service.name: service for service in OpenLibrary().services()}


def _document(data: bytes) -> None:
    """A document of one's own, checked as ``housefly task check`` does, and asked for."""
    with as_file(data, "own.yaml") as path:
        document = read_task(text_of(path), path.name)
    document = linked(_library() | {document.name: document})[document.name]
    document.info()
    _written(document)
    bind(document, {one.name: one.default or "sofa" for one in document.parameters})


def _written(document: TaskDocument) -> None:
    """Write a document and read it again: that is refused only where it has grown too long."""
    _again(task_to_yaml(document))


def _again(text: str) -> None:
    try:
        read_task(text, "written.yaml")
    except TaskError as error:
        assert len(text) > SIZE_MAX, error


def _document_seeds() -> Iterable[bytes]:
    for path in sorted(SHIPPED.glob("*.yaml")):
        yield path.read_bytes()
    yield b"name: a\nparameters: {n: {type: number, unit: m, min: 0, max: 9 m, default: 1 m}}\n" + (
        b"steps: [wait: 5 s, {say: 'it is $n'}, {if: {set: n}, then: [land], else: [wait: 2 s]}]\n"
    )
    yield b"name: a\nsteps: [{call: {task: look, with: {subject: $n}}}]\nparameters: {n: place}\n"
    yield b"name: a\nsteps: [wait: " + HUGE + b"]"
    yield b"name: a\nsteps: " + _NESTED


def _rpn(data: bytes) -> None:
    """The first byte says whether people are told of what a drone cannot do."""
    tell, text = bool(data[:1] and data[0] % 2), data[1:].decode(errors="replace")
    document = import_rpn(text, "imported", "", {20001: "cup", 6011: "the $ sofa"}, tell)
    _again(document)


def _rpn_seeds() -> Iterable[bytes]:
    yield b"\x019001$oid 9002$oid + 9001$uid + 9003$uid +"
    yield b"\x009001$rid 9006$oid 9007$oid | +; 9001$20001 +"
    yield b"\x009001$-1$5500$2000$-90 9900$5 + 9200 +"
    yield b'\x009300${"announce": "hello"} 9001${"x": 1.5, "y": 2} + 9900${"sec": (a.b)} |'
    yield b'\x009900${"time": ' + HUGE + b"}"
    yield b'\x009001${"x": ' + HUGE + b', "y": 1}'
    yield "\x009001$² +".encode()
    yield b"\x009900$nan"


def _rules(data: bytes) -> None:
    """A file of rules, and what they make of some triggers."""
    with as_file(data, "rules.yaml") as path:
        rules = read_rules(path)
    tuple(rule_problems(rules, _services()))
    for rule in rules:
        _ = rule.words(), value_of(WebhookTrigger("bell", _NOW), "name", rule.when)
    engine, memory, room = RuleEngine(rules, UTC), RuleMemory(), KnownRoom()
    for trigger in (MqttTrigger("a/b", b'{"on": 5}', _NOW), WebhookTrigger("bell", _NOW)):
        memory, _ = engine.heard(trigger, HouseMode.HOME, _NOW, memory, room)
    memory, _ = engine.ticked(HouseMode.AWAY, _NOW, memory, room)
    engine.statuses(memory)
    engine.next_time(_NOW)


def _rule_seeds() -> Iterable[bytes]:
    yield b"rules:\n  - {name: a, when: {event: bell pressed}, then: {service: visitor}}\n"
    yield (
        b"rules:\n  - name: a\n    when: {mqtt: 'a/+', field: 'on', above: 1, below: 9}\n"
        b"    if: {mode: [home], between: {from: '22:00', to: '06:30'}, confidence: 0.5}\n"
        b"    then: {service: look, parameters: {subject: $mqtt.value}}\n"
        b"    confirm: auto\n    cooldown: 30 s\n    per_hour: 12\n    priority: alarm\n"
    )
    yield (
        b"rules:\n  - name: a\n    when: {at: ['07:00'], days: [mon, sun]}\n"
        b"    then: {service: patrol}\n  - name: b\n    when: {every: 90 min}\n"
        b"    then: {service: patrol}\n    if: {is: [{thing: bed, state: occupied}]}\n"
    )
    yield b"rules:\n  - {name: a, when: {webhook: bell}, then: {service: look}, cooldown: " + HUGE
    yield b"rules: " + _NESTED


@cache
def _patterns() -> tuple[Pattern, ...]:
    whens = ("{mqtt: 'a/#'}", "{mqtt: 'a/b', field: on}", "{mqtt: '+/b', above: 1, below: 5}")
    whens += ("{mqtt: a/b, field: on, value: true}", "{mqtt: a/b, value: 'yes'}")
    return tuple(make_rule(when).when for when in whens)


def _mqtt_trigger(data: bytes) -> None:
    """What somebody published on topics that rules wait for."""
    trigger = MqttTrigger("a/b", data, _NOW)
    for pattern in _patterns():
        fits(pattern, trigger, "bell")
        for field in ("value", "topic", "payload"):
            value_of(trigger, field, pattern)


def _mqtt_request(data: bytes) -> None:
    """The first byte chooses who may ask; what is let through goes on as JSON."""
    config = _CONFIGS[data[0] % 2] if data else _CONFIGS[0]
    question = mqtt_question("housefly/b/tasks/request/panel", data[1:], config)
    assert getattr(question, "surface", RequestSurface.MQTT) is RequestSurface.MQTT
    assert task_question_from_json(task_question_to_json(question)) == question


def _mqtt_request_seeds() -> Iterable[bytes]:
    for head in (b"\0", b"\1"):
        yield head + b'{"service": "look", "parameters": {"subject": "sofa", "n": 1, "on": true}}'
        yield head + b'{"ask": "sentence", "text": "halt", "language": "de", "fly": true}'
        yield head + b'{"ask": "cancel", "task": 5, "only_of": "me"}'
        yield head + b'{"ask": "mode", "mode": "away"}'
        yield head + b'{"service": "\\ud800", "deadline": 1e999, "parameters": {"a": NaN}}'
        yield head + DEEP


def _task_question(data: bytes) -> None:
    question = task_question_from_json(data.decode(errors="replace"))
    assert task_question_from_json(task_question_to_json(question)) == question


def _task_question_seeds() -> Iterable[bytes]:
    yield task_question_to_json(RequestTask("look", {"subject": "sofa", "on": True})).encode()
    yield task_question_to_json(Sentence("where is the cup", "ja")).encode()
    yield task_question_to_json(TaskHistoryQuestion(5.0, 9.0, "look", before=7)).encode()
    yield b'{"ask": "reply", "task": 1, "question": "confirm", "choice": "look"}'
    yield b'{"ask": "dry_run", "since": ' + HUGE + b"}"
    yield b'{"ask": "request", "service": "a", "parameters": {"a": ' + DEEP


def _task_answer(data: bytes) -> None:
    """The first byte chooses the question; what tasks say comes from another process."""
    question = _ASKED[data[0] % len(_ASKED)] if data else _ASKED[0]
    answer = task_answer_from_json(question, data[1:].decode(errors="surrogateescape"))
    task_answer_to_json(answer)


def _task_answer_seeds() -> Iterable[bytes]:
    yield b'\0{"at":1.0,"mode":"home","drone":"on the pad","records":false,"tasks":[],"ended":[]}'
    yield b'\4{"tasks":[]}'
    yield b'\1{"services":[{"name":"a","title":"a","about":"b","parameters":[]}]}'
    yield b'\2{"error":"a","code":"not_ready"}'
    yield b"\3" + DEEP


def _nobody(question: Question) -> Answer:
    raise LinkError("nobody remembers anything")


def _answered(meant: Intent) -> None:
    answer_intent(meant, NAMES, AskedRoom(_nobody), _NOW)


def _sentence(data: bytes) -> None:
    """The first byte chooses the language; no text that the edge lets in may raise anything."""
    language = LANGUAGES[data[0] % len(LANGUAGES)] if data else "en"
    told = {"ask": "sentence", "text": data[1:].decode(errors="replace"), "language": language}
    question = task_question_from_json(json.dumps(told))
    assert isinstance(question, Sentence)
    meant = recognize(question.text, question.language, NAMES)
    if isinstance(meant, Intent):
        _answered(meant)
        try:
            assert intent_from_json(intent_to_json(meant)) == meant
        except WireError as error:
            raise AssertionError(meant) from error


def _sentence_seeds() -> Iterable[bytes]:
    told = {
        0: ("where is the red cup?", "stop", "call me when grandma gets up", 'go to "sofa"'),
        1: ("Wo ist die Tasse?", "Was war um halb vier in der Küche los?", "zeig mir den Flur"),
        2: ("カップはどこ?", "止まれ", "三時半に何があった?"),
    }
    for number, texts in told.items():
        for text in texts:
            yield bytes([number]) + text.encode()


def _intent(data: bytes) -> None:
    _answered(intent_from_json(data))


def _intent_seeds() -> Iterable[bytes]:
    slots = {"subject": "cup", "subject_kind": "thing", "owner": "person-1", "go": True}
    yield json.dumps({"intent": "where", "slots": slots}).encode()
    when = {"at": "07:30", "either_half": True, "day": "monday", "period": "night"}
    yield json.dumps({"intent": "what_happened", "slots": when, "language": "de"}).encode()
    late = {"event": "time", "in_minutes": 5.0}
    yield json.dumps({"intent": "call_me", "slots": late, "language": "ja"}).encode()
    yield b'{"intent": "came_at", "slots": {"last_minutes": ' + HUGE + b"}}"
    yield b'{"intent": ' + DEEP


def _sentence_file(data: bytes) -> None:
    """A file of one's own beside those that are shipped."""
    folder = scratch() / "sentences"
    folder.mkdir(exist_ok=True)
    with as_file(data, "sentences/own.yaml"):
        sentence_book("en", folder)


def _sentence_file_seeds() -> Iterable[bytes]:
    yield (
        b"language: en\nintents: {look: {data: [{sentences: ['(peek|glance) [now] at {subject}'],"
        b" slots: {go: true}}]}}\nlists: {size: {values: [{in: big, out: 5}, small]}}\n"
        b"names: {cup: [beaker, mug]}\nskip_words: [please]\nexpansion_rules: {now: 'at once'}\n"
    )
    yield b"language: en\nlists: {n: {range: {from: 1, to: 5}}}\nstop_words: [whoa]\n"
    yield b"language: en\nintents: {stop: {data: [{sentences: ['{subject}']}]}}\n"
    yield b"language: 2001-99-99\n"
    yield b"language: &a [a]\nskip_words: [*a, *a]\n"
    yield b"language: en\nnames: {a: " + _NESTED


def _rule_memory(data: bytes) -> None:
    """What the tasks kept of the rules: the file, and the value in it."""
    with as_file(data, "rules.json"):
        kept = RuleStore(scratch(), HouseMode.HOME).load()
    assert kept.memory.settled(_NOW).firings("a", _NOW) is not None
    memory = memory_from_json(data.decode(errors="replace"))
    memory_from_json(memory_to_json(memory))


def _rule_memory_seeds() -> Iterable[bytes]:
    memory = RuleMemory({"a": (1.0, 2.0)}, {"a": 5.0}, {"a": 1}, {}, ("bell",))
    yield memory_to_json(memory).encode()
    yield b'{"mode": "away", "memory": ' + memory_to_json(memory).encode() + b"}"
    yield b'{"mode": "home", "memory": {"fired": {"a": [' + HUGE + b"]}}}"


TASKS: dict[str, FuzzTarget] = {
    "task_document": FuzzTarget(
        _document,
        _document_seeds,
        (TaskError,),
        words=(b"steps:", b"parameters:", b"for_each:", b"parallel:", b"if:", b"$each", b"on_fail"),
    ),
    "task_rpn": FuzzTarget(
        _rpn, _rpn_seeds, (TaskError,), 512, (b"9001$", b"9900$", b"${", b" +", b" |", b"$pid")
    ),
    "rules": FuzzTarget(
        _rules, _rule_seeds, (ConfigError,), words=(b"when:", b"then:", b"if:", b"mqtt:", b"every:")
    ),
    "rule_memory": FuzzTarget(_rule_memory, _rule_memory_seeds, (WireError,), 1024),
    "mqtt_trigger": FuzzTarget(
        _mqtt_trigger,
        lambda: (b'{"on": true}', b"yes", b"3.5", b'"a"', HUGE, DEEP, b"NaN", b"\xff\xfe1\0"),
        length_max=1024,
    ),
    "mqtt_request": FuzzTarget(
        _mqtt_request,
        _mqtt_request_seeds,
        (WireError, TaskError),
        1024,
        (b'"ask"', b'"service"', b'"parameters"', b'"confirm"', b"NaN", b"1e999", b"\\ud800"),
    ),
    "task_question": FuzzTarget(
        _task_question, _task_question_seeds, (WireError,), 1024, (b'"ask"', b'"sentence"')
    ),
    "task_answer": FuzzTarget(_task_answer, _task_answer_seeds, (TaskError, WireError), 1024),
    "sentence": FuzzTarget(
        _sentence,
        _sentence_seeds,
        (WireError,),
        240,
        (b"where is ", b" at ", b"half past ", b"wo ist "),
    ),
    "sentence_file": FuzzTarget(
        _sentence_file,
        _sentence_file_seeds,
        (ConfigError,),
        1024,
        (b"language: en", b"intents:", b"lists:", b"{subject}", b"[a]", b"(a|b)", b"<rule>"),
    ),
    "intent": FuzzTarget(_intent, _intent_seeds, (WireError,), 1024),
}
