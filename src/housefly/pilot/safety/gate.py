"""The safety gate, the last before the drone: it may only make a command smaller.

What holds the drone or lands it is flown by our setpoint or by the drone's own hover
(``control_source``). A landing, once begun here, is kept until the drone says that it stands; then
nothing moves without a fresh order. One thing is added: what a drone lacks in lean whose attitude
hangs.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import dist, hypot, inf, isfinite

from housefly.config.airframe import Ability, Airframe
from housefly.config.limits import LimitsConfig
from housefly.geometry import Vec2
from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, Phase, Severity
from housefly.messages.sensing import AIRBORNE_STATUSES, DroneStatus
from housefly.messages.steering import (
    Action,
    Clearing,
    Command,
    PositionSetpoint,
    SafetyMode,
    Setpoint,
    SetpointForm,
    VelocitySetpoint,
    flying,
)
from housefly.messages.words import UNSAID, Words, joined
from housefly.numeric import clipped
from housefly.pilot.control.forms import NOT_FORMED, FormedCommand
from housefly.pilot.safety.control_source import (
    ControlSource,
    knows_place,
    lands_on_floor,
    source_for_hold,
    source_for_landing,
)
from housefly.pilot.safety.fallbacks import can_wait_to_land, possible_mode
from housefly.pilot.safety.inputs import GateInputs, Geofence
from housefly.pilot.safety.limits import GatedCommand
from housefly.pilot.safety.observer import FlightObserver
from housefly.pilot.safety.rule import IN_SCOPE, RuleContext, SafetyRule
from housefly.pilot.safety.rule_words import holding_itself
from housefly.pilot.safety.rules import MODE_SEVERITY, SAFETY_RULES

A, M = Action, SafetyMode

_FLOWN = {A.RESET: A.HOVER}
_HELD = {A.FLY: A.HOVER, A.TAKE_OFF: A.HOVER, A.RESET: A.HOVER}
KEPT_SLACK = 0.5
"""Who is held by our setpoint and comes to rest this much farther away is not kept by it [m]."""
_LANDINGS = (M.LAND, M.DESCEND)
_BY_CONTROL_SOURCE = (M.HOLD, M.STOPPED, M.LAND)
_LANDED = dict.fromkeys((A.FLY, A.HOVER, A.TAKE_OFF, A.IDLE, A.RESET), A.LAND)

AIRBORNE_ACTIONS: dict[SafetyMode, dict[Action, Action]] = {
    M.NOMINAL: _FLOWN,
    M.WARN: _FLOWN,
    M.SLOW: _FLOWN,
    M.HOLD: {A.FLY: A.HOVER, A.RESET: A.HOVER},
    M.RETURN: _FLOWN,
    M.STOPPED: _HELD,
    M.LAND: _LANDED,
    M.DESCEND: dict.fromkeys((A.FLY, A.HOVER, A.TAKE_OFF, A.IDLE, A.RESET, A.LAND), A.FLY),
    M.CUT: dict.fromkeys(Action, A.CUT),
}
"""What becomes of an action in the air, by safety mode; an action that is not listed passes."""

_STANDING = dict.fromkeys((A.FLY, A.HOVER, A.RESET), A.IDLE)
_KEPT_DOWN = {**_STANDING, A.TAKE_OFF: A.IDLE}

GROUND_ACTIONS: dict[SafetyMode, dict[Action, Action]] = {
    M.NOMINAL: _STANDING,
    M.WARN: _STANDING,
    M.SLOW: _STANDING,
    M.HOLD: _KEPT_DOWN,
    M.RETURN: _KEPT_DOWN,
    M.STOPPED: _KEPT_DOWN,
    M.LAND: _KEPT_DOWN,
    M.DESCEND: _KEPT_DOWN,
    M.CUT: dict.fromkeys(Action, A.CUT),
}
"""The same on the ground. The emergency command is a toggle: it is never sent in the emergency
state, and RESET only there.
"""


@dataclass(frozen=True, slots=True)
class BrokenRule:
    """One rule that is broken now.

    Attributes:
        code: of the rule.
        mode: what is done about it, knowledge permitting.
        words: for people.
        steered: the pilot may steer the hold or the landing.
        clears: what ends the answer.
        waits: the landing waits for the floor below to be clear.
    """

    code: EventCode
    mode: SafetyMode
    words: Words
    steered: bool = False
    clears: Clearing = Clearing.ITSELF
    waits: bool = False


@dataclass(frozen=True, slots=True)
class GateAssessment:
    """What the rules found in one step, before any command is looked at.

    Attributes:
        mode: the worst that was found.
        code, reason: of the deciding rule; None and "" when nothing is wrong.
        status: the drone's own status.
        broken: every broken rule, worst first.
        control_source: by what a hold or a landing is flown.
        lands: a landing is under way, of the gate or of the mission.
        to_floor: our setpoint has to sink to the floor: the drone's own last bit is in doubt.
        knows_place: tracking is believed.
        knows_speed: the drone's own hover is.
        knows_motion: tracking does not show the opposite of how the drone leans.
        missing_lean: as in ``GateInputs``, within ``tilt_max``, the largest tilt [rad].
        form: of the setpoints that the drone is steered by.
        hovers: the drone has a hover of its own.
    """

    mode: SafetyMode
    code: EventCode | None
    reason: Words
    status: DroneStatus
    broken: tuple[BrokenRule, ...] = ()
    control_source: ControlSource = ControlSource.ONBOARD_HOVER
    lands: bool = False
    to_floor: bool = False
    knows_place: bool = False
    knows_speed: bool = True
    knows_motion: bool = True
    missing_lean: Vec2 | None = None
    tilt_max: float = 0.0
    form: SetpointForm = SetpointForm.TILT_AND_CLIMB
    hovers: bool = True

    @property
    def airborne(self) -> bool:
        """Whether the propellers carry the drone, by its last word."""
        return self.status in AIRBORNE_STATUSES

    @property
    def steered(self) -> bool:
        """Whether our setpoint flies the landing that is under way."""
        is_ours = self.control_source is not ControlSource.ONBOARD_HOVER
        return self.lands and is_ours and self.mode not in (SafetyMode.DESCEND, SafetyMode.CUT)

    @property
    def held(self) -> bool:
        """Whether the drone is to stay where it is."""
        return not self.lands and self.motion in (SafetyMode.HOLD, SafetyMode.STOPPED)

    @property
    def kept(self) -> bool:
        """Whether our setpoint keeps the place of a drone that is held."""
        return self.held and self.control_source is not ControlSource.ONBOARD_HOVER

    @property
    def waits(self) -> bool:
        """Whether the landing that is under way waits, and the pilot holds the drone."""
        return self.mode is SafetyMode.LAND and any(rule.waits for rule in self.broken[:1])

    @property
    def motion(self) -> SafetyMode:
        """What the drone may do now: one that is called home waits for whatever holds it."""
        if self.mode is not SafetyMode.RETURN:
            return self.mode
        is_held = any(rule.mode is SafetyMode.HOLD for rule in self.broken)
        return SafetyMode.HOLD if is_held else SafetyMode.RETURN

    @property
    def words(self) -> Words:
        """Why, for people; a return that waits says for what, too."""
        if self.motion is self.mode:
            return self.reason
        holding = next(rule.words for rule in self.broken if rule.mode is SafetyMode.HOLD)
        return joined("; ", (self.reason, holding))

    @property
    def severity(self) -> int:
        """What the compiled gate is told: what our setpoint holds or lands, or waits, is flown."""
        is_flown = self.steered or self.kept or self.waits
        return MODE_SEVERITY[SafetyMode.RETURN if is_flown else self.motion]


@dataclass(frozen=True, slots=True)
class GateVerdict:
    """What leaves the gate.

    Attributes:
        command: for the driver.
        mode: the worst that was found.
        code, reason: of the deciding rule; None and "" when nothing is wrong. A return that waits
            says for what, too.
        broken: every broken rule, worst first.
    """

    command: Command
    mode: SafetyMode
    code: EventCode | None = None
    reason: Words = UNSAID
    broken: tuple[BrokenRule, ...] = ()

    @property
    def clears(self) -> Clearing:
        """What ends what is done."""
        deciding = (rule.clears for rule in self.broken if rule.code == self.code)
        return next(deciding, Clearing.ITSELF)


class Gate:
    """Judges every step; remembers how long each rule is broken, and a landing that it began.

    Args:
        limits: of the site.
        fence: of the room.
        airframe: of the drone; a rule that needs what it lacks does not count.
        rules: what counts; fewer than all are for negative controls only.
    """

    def __init__(
        self,
        limits: LimitsConfig,
        fence: Geofence,
        airframe: Airframe,
        rules: tuple[SafetyRule, ...] = SAFETY_RULES,
    ) -> None:
        self._limits = limits
        self._fence = fence
        self._airframe = airframe
        self._form, self._hovers = airframe.capabilities.form, airframe.capabilities.hovers
        rules = tuple(rule for rule in rules if not rule.needs & airframe.lacks)
        self._rules = tuple((rule, list(IN_SCOPE).index(rule.scope)) for rule in rules)
        self._waiting = frozenset(rule.code for rule in rules if rule.may_wait)
        tells_speed = Ability.VELOCITY not in airframe.lacks
        self._observer = FlightObserver(limits, tells_speed=tells_speed)
        self._since: dict[EventCode, float] = {}
        self._until: dict[EventCode, float] = {}
        self._landing: BrokenRule | None = None
        self._held = False
        self._kept_from: tuple[Vec2, float] | None = None
        self._returning = False
        self._standing_height = 0.0
        self._gauge_stuck = False

    @property
    def landing(self) -> bool:
        """Whether a forced landing is under way."""
        return self._landing is not None

    @property
    def landing_waits(self) -> bool:
        """Whether that landing waits for the floor below to be clear."""
        return self._landing is not None and self._landing.waits

    @property
    def returning(self) -> bool:
        """Whether the drone is to come home: once it is to, until it stands."""
        return self._returning

    @property
    def standing_height(self) -> float:
        """Tracked height of the drone when it stood [m]."""
        return self._standing_height

    @property
    def gauge_stuck(self) -> bool:
        """Whether the charge stood still in the air, and has not changed since."""
        return self._gauge_stuck

    def assess(self, inputs: GateInputs) -> GateAssessment:
        """Return what the rules find now."""
        context = self._context(inputs)
        broken = self._broken(context)
        if inputs.status in (DroneStatus.LANDED, DroneStatus.EMERGENCY):
            self._landing = None
        else:
            broken = self._land(broken, context)
        worst = broken[0] if broken else None
        is_called_home = worst is not None and worst.mode is SafetyMode.RETURN
        self._returning = inputs.airborne and (is_called_home or self._returning)
        is_held = any(rule.mode is SafetyMode.HOLD for rule in broken)
        self._held = is_held and not self.landing_waits
        lands = self._landing is not None or inputs.phase is Phase.LANDING
        return GateAssessment(
            mode=worst.mode if worst else SafetyMode.NOMINAL,
            code=worst.code if worst else None,
            reason=worst.words if worst else UNSAID,
            status=inputs.status,
            broken=broken,
            control_source=self._control_source(broken, context, lands),
            lands=lands,
            to_floor=lands_on_floor(context),
            knows_place=knows_place(context),
            knows_speed=inputs.consistency.flow_believed,
            knows_motion=not context.seen.leans_mirrored,
            missing_lean=inputs.missing_lean,
            tilt_max=self._limits.tilt_max,
            form=self._form,
            hovers=self._hovers,
        )

    def _control_source(
        self, broken: tuple[BrokenRule, ...], c: RuleContext, lands: bool
    ) -> ControlSource:
        is_steered = all(rule.steered for rule in broken if rule.mode in _BY_CONTROL_SOURCE)
        if lands:
            return source_for_landing(c, is_steered)
        is_held = any(rule.mode in (M.HOLD, M.STOPPED) for rule in broken)
        return source_for_hold(c, is_steered and self._keeps_place(c.inputs, is_held))

    def _keeps_place(self, now: GateInputs, is_held: bool) -> bool:
        """Return whether a drone that is held has stayed where it could come to rest."""
        if not is_held or now.position is None:
            self._kept_from = None
            return True
        place = now.position[:2]
        if self._kept_from is None:
            speed = hypot(*now.velocity[:2]) if now.velocity else 0.0
            self._kept_from = place, self._airframe.braking.way_to_rest(speed) + KEPT_SLACK
        begun, reach = self._kept_from
        return dist(place, begun) <= reach

    def _land(self, broken: tuple[BrokenRule, ...], c: RuleContext) -> tuple[BrokenRule, ...]:
        """Begin a landing, or keep one; once the pilot cannot steer it, the drone lands itself."""
        due = [rule for rule in broken if rule.mode in _LANDINGS]
        before = self._landing
        landing = due[0] if broken and broken[0] in due else before
        if landing is None:
            return broken
        reasons = (landing, *due, *filter(None, (before,)))
        is_steered = all(rule.steered for rule in reasons)
        may_wait = all(rule.code in self._waiting for rule in reasons)
        is_ours = source_for_landing(c, is_steered) is ControlSource.TRACKING
        landing = replace(
            landing,
            steered=is_steered and is_ours,
            waits=may_wait and can_wait_to_land(c),
        )
        self._landing = landing
        if landing.waits:
            landing = replace(landing, words=_once_it_can(landing.words, c.inputs.landing_blocker))
        if landing.code not in (rule.code for rule in due):
            landing = replace(landing, mode=possible_mode(SafetyMode.LAND, c))
        others = (rule for rule in broken if rule.code != landing.code)
        return tuple(
            sorted((landing, *others), key=lambda rule: MODE_SEVERITY[rule.mode], reverse=True)
        )

    def _context(self, inputs: GateInputs) -> RuleContext:
        seen = self._observer.observe(inputs, self._held, self.landing, self.landing_waits)
        self._standing_height = seen.standing_height
        self._gauge_stuck = seen.energy.gauge_stuck
        return RuleContext(inputs, seen, self._limits, self._fence, self._airframe)

    def _broken(self, context: RuleContext) -> tuple[BrokenRule, ...]:
        in_scope = [is_in_scope(context) for is_in_scope in IN_SCOPE.values()]
        remembered = self._since.keys() | self._until.keys()
        found = [
            BrokenRule(
                rule.code,
                possible_mode(rule.mode, context),
                rule.words(context),
                rule.may_steer,
                rule.clears,
            )
            for rule, scope in self._rules
            if (
                (is_wrong := in_scope[scope] and rule.is_broken(context))
                or (remembered and rule.code in remembered)
            )
            and self._debounced(rule, is_wrong, context)
        ]
        return tuple(sorted(found, key=lambda rule: MODE_SEVERITY[rule.mode], reverse=True))

    def _debounced(self, rule: SafetyRule, is_wrong: bool, context: RuleContext) -> bool:
        now = context.inputs.now
        if not is_wrong:
            self._since.pop(rule.code, None)
            return now < self._until.get(rule.code, -inf) and context.inputs.airborne
        if now - self._since.setdefault(rule.code, now) < rule.debounce:
            return False
        if rule.lasts:
            self._until[rule.code] = now + rule.lasts
        return True


def _once_it_can(why: Words, below: Words) -> Words:
    return Words("{why}, once it can: {what}", why=why, what=below)


def gate_verdict(
    action: Action,
    gated: GatedCommand,
    assessment: GateAssessment,
    formed: FormedCommand = NOT_FORMED,
) -> GateVerdict:
    """Return the verdict on one step.

    Args:
        action: what the pilot wants.
        gated: the numbers that left the compiled gate.
        assessment: what the rules found in this step.
        formed: the same as a drone is asked for it that is not steered by tilt.
    """
    mode, code, reason = assessment.mode, assessment.code, assessment.words
    motion = assessment.motion
    is_finite = gated.mode == assessment.severity
    is_ours = assessment.steered or assessment.kept or assessment.waits
    if is_ours and action is Action.FLY and is_finite and gated.flown:
        return GateVerdict(_flown(gated, formed, assessment), mode, code, reason, assessment.broken)
    if not (is_finite or is_ours):
        mode = motion = SafetyMode.HOLD
        code = EventCode.NOT_FINITE
        reason = holding_itself(Words("the command was not a number"))
    allowed = _allowed(action, motion, assessment)
    broken = assessment.broken
    if allowed is not Action.FLY:
        return GateVerdict(Command(allowed), mode, code, reason, broken)
    return GateVerdict(_flown(gated, formed, assessment), mode, code, reason, broken)


def _flown(gated: GatedCommand, formed: FormedCommand, assessment: GateAssessment) -> Command:
    """Return the command that flies the numbers in the form that the drone takes."""
    if assessment.form is SetpointForm.VELOCITY:
        return flying(VelocitySetpoint(formed.forward, formed.left, gated.vz, gated.yaw_rate))
    if assessment.form is SetpointForm.POSITION:
        place = PositionSetpoint(formed.x, formed.y, formed.z, gated.yaw_rate)
        return flying(place) if formed.flown else Command(Action.LAND)
    theta, phi, tilt_max = gated.theta, gated.phi, assessment.tilt_max
    missing = assessment.missing_lean
    if missing is not None and all(map(isfinite, missing)):
        more_theta, more_phi = missing
        theta = clipped(theta + more_theta, tilt_max)
        phi = clipped(phi + more_phi, tilt_max)
    return Command(Action.FLY, Setpoint(theta, phi, gated.vz, gated.yaw_rate))


def _allowed(action: Action, mode: SafetyMode, assessment: GateAssessment) -> Action:
    if assessment.status is DroneStatus.EMERGENCY:
        return Action.RESET if action is Action.RESET else Action.IDLE
    table = AIRBORNE_ACTIONS if assessment.airborne else GROUND_ACTIONS
    allowed = table[mode].get(action, action)
    # one without a hover would do anything, or nothing: its own landing is what is left
    is_left = allowed is Action.HOVER and assessment.airborne and not assessment.hovers
    return Action.LAND if is_left else allowed


CLEAR_AFTER = 1.0
"""Trouble that returns sooner than this is the same trouble [s]: a lossy tracking system would fill
the log otherwise.
"""


class GateNotices:
    """Remembers which troubles were told."""

    def __init__(self) -> None:
        self._seen: dict[EventCode, float] = {}

    def update(self, verdict: GateVerdict, now: float) -> tuple[Event, ...]:
        """Return the events of one verdict at a time [s]: each trouble once, and the end of all."""
        was_told = bool(self._seen)
        self._seen = {
            code: at for code, at in self._seen.items() if now - at < CLEAR_AFTER or now < at
        }
        events = tuple(
            Event(now, _severity(trouble.mode), trouble.code, trouble.words)
            for trouble in _troubles(verdict)
            if self._seen.setdefault(trouble.code, inf) == inf
        )
        self._seen.update({trouble.code: now for trouble in _troubles(verdict)})
        if was_told and not self._seen:
            text = Words("nothing holds the drone back any more")
            return (Event(now, Severity.INFO, EventCode.SAFETY_CLEAR, text),)
        return events


def _troubles(verdict: GateVerdict) -> tuple[BrokenRule, ...]:
    """Return every trouble of a verdict, the deciding one first."""
    if verdict.code is None or any(rule.code == verdict.code for rule in verdict.broken):
        return verdict.broken
    return (BrokenRule(verdict.code, verdict.mode, verdict.reason), *verdict.broken)


def _severity(mode: SafetyMode) -> Severity:
    is_fault = MODE_SEVERITY[mode] >= MODE_SEVERITY[SafetyMode.LAND]
    return Severity.FAULT if is_fault else Severity.WARNING
