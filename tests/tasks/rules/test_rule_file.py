from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import ConfigError
from housefly.tasks.api.values import ParameterInfo, ServiceInfo
from housefly.tasks.rules.impossible import impossibilities
from housefly.tasks.rules.rule import MqttPattern, TimePattern
from housefly.tasks.rules.rule_file import (
    parse_rules,
    rule_problems,
    rules_of,
    shipped_rules,
)

RULE = "rules:\n  - name: r\n    when: {when}\n    then: {{service: look}}\n"


def test_the_shipped_rules_ask_and_the_night_round_is_off() -> None:
    rules = {rule.name: rule for rule in shipped_rules()}
    assert {name for name, rule in rules.items() if rule.enabled} == {
        "bell",
        "bell-webhook",
        "person-fallen",
    }
    assert all(rule.confirm == "ask" for rule in rules.values() if rule.enabled)
    assert rules["person-fallen"].priority == "alarm"


def test_a_rule_says_what_it_does_in_a_sentence() -> None:
    words = {rule.name: rule.words() for rule in shipped_rules()}
    assert words["bell"] == (
        "when bell pressed, if the house is in mode home or away or night: visitor after a yes"
    )
    assert words["night-round"].startswith("every day at 23:30, if the house is in mode night")


@pytest.mark.parametrize(
    ("when", "words"),
    [
        ("{mqtt: tele/stove/SENSOR, field: ENERGY.Power, above: 1000}",
         "when ENERGY.Power is above 1000 on the MQTT topic tele/stove/SENSOR: look after a yes"),
        ("{mqtt: a, value: true}", "when the value is true on the MQTT topic a: look"),
        ('{mqtt: a, value: "1"}', 'when the value is "1" on the MQTT topic a: look'),
        ("{mqtt: a, field: b}", "when a message with b comes on the MQTT topic a: look"),
        ("{mqtt: a/#}", "when any message comes on the MQTT topic a/#: look"),
        ("{event: door opened, thing: door, facts: {by: cat}}",
         'when door opened (door, by "cat"): look'),
    ],
)  # fmt: skip
def test_what_a_rule_waits_for_is_said_with_field_and_value(when: str, words: str) -> None:
    (rule,) = parse_rules(RULE.format(when=when))
    assert rule.words().startswith(words)


@pytest.mark.parametrize(
    ("rule", "words"),
    [
        ("when: {mqtt: a, above: 20, below: 10}", "never above 20 and below 10 at once"),
        ("when: {mqtt: a, field: b, value: open, above: 3}", "b is never 'open' and above or"),
        ("when: {mqtt: a, value: 5, above: 9}", "value is 5.0, which is not within"),
        ("when: {situation: window open}", "no situation 'window open'; there is: person present"),
        ("when: {event: bell presed}", "did you mean 'bell pressed'?"),
        ("when: {at: 07:30}\n    quiet: {from: 22:00, to: 08:00}", "only in its quiet hours"),
        ("when: {at: 07:30}\n    if: {between: {from: 08:00, to: 09:00}}", "never comes in if"),
        ("when: {webhook: a}\n    if: {between: {from: 08:00, to: 08:00}}", "is no time at all"),
        ("when: {webhook: a}\n    if: {is: [{thing: door, state: opened}]}",
         "nothing is ever 'opened'; did you mean 'open'?"),
    ],
)  # fmt: skip
def test_what_can_never_come_is_said_by_the_check(rule: str, words: str) -> None:
    look = ServiceInfo("look", "look", "", ())
    text = f"rules:\n  - name: r\n    {rule}\n    then: {{service: look}}\n"
    (problem,) = rule_problems(parse_rules(text), {"look": look})
    assert problem.startswith("rule r: ") and words in problem


def test_no_shipped_rule_waits_for_what_can_never_come() -> None:
    assert not [problem for rule in shipped_rules() for problem in impossibilities(rule)]


def test_on_is_a_text_and_a_time_of_day_is_no_number() -> None:
    rule = parse_rules(
        "rules:\n  - name: r\n    when: {at: 07:30, days: [sat, sun]}\n"
        "    if: {is: [{thing: stove, state: on}], between: {from: 06:00, to: 08:00}}\n"
        "    then: {service: look, parameters: {subject: stove, near: 2, quick: true}}\n"
        "    cooldown: 10 min\n"
    )[0]
    assert rule.conditions.states[0].state == "on"
    assert rule.when.kind == "time" and f"{rule.when.at[0]:%H:%M}" == "07:30"
    assert rule.cooldown == 600.0
    assert rule.then.parameters == {"subject": "stove", "near": 2.0, "quick": True}


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (RULE.format(when="{event: a, mqtt: b}"), "exactly one of"),
        (RULE.format(when="{}"), "exactly one of"),
        (RULE.format(when="{at: 25:00}"), "time of day such as 07:30"),
        (RULE.format(when="{every: 5 s}"), "60 s or more"),
        (RULE.format(when="{at: 07:00, every: 1 h}"), "not both"),
        (RULE.format(when="{at: 07:00, days: []}"), "no day"),
        (RULE.format(when="{mqtt: a/#/b}"), "# for the rest at the end"),
        (RULE.format(when="{mqtt: a/b+}"), "+ for one level"),
        (RULE.format(when="{mqtt: a, field: 'b[x]'}"), "is no path to a value"),
        (RULE.format(when="{webhook: '../x'}"), "when"),
        (RULE.format(when="{event: a, speed: 3}"), "not a known key"),
        (RULE.format(when="{event: a}") * 1 + "    cooldown: never\n", "cooldown"),
        (RULE.format(when="{event: a}") + "    confirm: maybe\n", "confirm"),
        (RULE.format(when="{webhook: a}") + "    if: {confidence: 0.5}\n", "if.confidence"),
        (RULE.format(when="{event: a}") + RULE.format(when="{event: b}")[7:], "the name 'r'"),
        ("rules: [", "line"),
        ("rules: &a []\n", "anchors"),
        ("- a", "rules"),
    ],
)
def test_what_is_wrong_with_a_file_is_said_in_words(text: str, words: str) -> None:
    with pytest.raises(ConfigError, match=words.replace("+", r"\+")):
        parse_rules(text, "own.yaml")


@pytest.mark.parametrize(
    ("when", "value"),
    [
        ("{event: a}", "$mqtt.value"),
        ("{event: a}", "$event.thing and more"),
        ("{event: a}", "$event.facts.x"),
        ("{mqtt: a}", "$mqtt.payload"),
        ("{webhook: a}", "$event.thing"),
        ("{at: 07:00}", "$event.at"),
    ],
)
def test_a_parameter_takes_only_whole_values_that_its_trigger_has(when: str, value: str) -> None:
    text = RULE.format(when=when).replace(
        "{service: look}", f'{{service: look, parameters: {{subject: "{value}"}}}}'
    )
    with pytest.raises(ConfigError, match=r"then\.parameters\.subject"):
        parse_rules(text)


def test_the_service_of_a_rule_is_never_taken_from_a_trigger() -> None:
    with pytest.raises(ConfigError, match="service"):
        parse_rules(RULE.format(when="{event: a}").replace("look", "$event.thing"))


def test_a_rule_of_ones_own_takes_the_place_of_its_namesake(tmp_path: Path) -> None:
    file = tmp_path / "rules.yaml"
    file.write_text(
        "rules:\n  - {name: bell, enabled: false, when: {event: a}, then: {service: b}}\n"
    )
    rules = {rule.name: rule for rule in rules_of(file)}
    assert set(rules) == {rule.name for rule in shipped_rules()}
    assert not rules["bell"].enabled
    with pytest.raises(ConfigError, match=r"tasks\.rules.*cannot be read"):
        rules_of(tmp_path / "none.yaml")


def test_what_a_rule_asks_for_is_checked_against_the_services() -> None:
    look = ServiceInfo("look", "Look", "", (ParameterInfo("subject", "text", "", required=True),))
    text = RULE.format(when="{event: a}")
    assert rule_problems(parse_rules(text), {"look": look}) == (
        "rule r: look needs the parameter 'subject'",
    )
    wrong = text.replace("look}", "look, parameters: {subject: a, height: 2}}")
    assert rule_problems(parse_rules(wrong), {"look": look}) == (
        "rule r: look has no parameter 'height'; it has: subject",
    )
    assert "there is no service 'look'" in rule_problems(parse_rules(text), {})[0]


@given(st.text(max_size=60))
def test_no_text_makes_the_reader_of_rules_fail_in_any_other_way(text: str) -> None:
    for whole in (text, RULE.format(when="{" + text + "}"), f"rules:\n  - {text}"):
        try:
            parse_rules(whole)
        except ConfigError:
            continue


def test_patterns_are_told_apart_by_their_key() -> None:
    kinds = [
        parse_rules(RULE.format(when=when))[0].when
        for when in ("{mqtt: a/+/c, field: x, above: 3}", "{every: 2 h}")
    ]
    assert isinstance(kinds[0], MqttPattern) and isinstance(kinds[1], TimePattern)
