"""What came out of a design: a sentence, a level and a cure for each finding."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

from workbench.analysis.regions import light_of_lit_area
from workbench.arrays import Array
from workbench.design.checks import HIGH, coarse_net
from workbench.design.loss import relative_error
from workbench.design.session import Session, VerifiedError, verified_error
from workbench.design.snapshot import LOCKED, MET, Result, has_converged
from workbench.extended.bound import percent
from workbench.messages import Message
from workbench.optics.account import Account, loss_of
from workbench.optics.paths import total_reflection
from workbench.scene import Scene
from workbench.scene.losses import kind_and_element

Level = Literal["good", "attention", "bad"]

_LOW = 0.01  # error below which nothing else that a finding names has spoilt the image

# A smaller part of the light that is totally reflected is no finding: it is 0 % when rounded.
_NAMED = 5e-3


class Cure(NamedTuple):
    """What mends a finding: edits of fields by path, a command of the window, or both in turn."""

    text: Message
    changes: Mapping[str, object] = {}
    command: str = ""


@dataclass(frozen=True, eq=False)
class Finding:
    """One finding of a design."""

    key: str
    level: Level
    sentence: Message
    cure: Cure | None = None
    places: Array | None = None  # (n, 3), where it happens, scene units


class Goal(NamedTuple):
    """A limit that a person may set for a finding: field of the run, and how a person reads it."""

    field: str
    at_most: bool
    percent: bool

    @property
    def path(self) -> str:
        """Path of the field in the scene."""
        return f"run.{self.field}"

    def of(self, scene: Scene) -> float | None:
        """The limit of a scene, as a fraction; None where there is none."""
        value: float | None = getattr(scene.run, self.field)
        return value

    def judged(self, scene: Scene, value: float, otherwise: Level) -> Level:
        """Whether a value meets the limit; ``otherwise`` without a limit."""
        limit = self.of(scene)
        if limit is None:
            return otherwise
        return "good" if (value <= limit if self.at_most else value >= limit) else "bad"


GOALS: Mapping[str, Goal] = {
    "error": Goal("max_error", at_most=True, percent=True),
    "light": Goal("min_light", at_most=False, percent=True),
    "uniformity": Goal("min_uniformity", at_most=False, percent=False),
}
"""Limits by the keys of findings."""


class Attainable(NamedTuple):
    """What any lens can reach: least relative L2 error, and most light; None if not known."""

    error: float | None = None
    light: float | None = None


UNKNOWN = Attainable()
"""Before the bounds of a task are computed."""


def findings(
    session: Session,
    result: Result,
    verified: VerifiedError | None = None,
    attainable: Attainable = UNKNOWN,
    *,
    search: bool = False,
) -> tuple[Finding, ...]:
    """Return what came out, the error first.

    `result`: the lens, or a snapshot of its run; `verified`: of a check of this lens; `attainable`:
    bounds of the task; `search`: whether to trace where light is totally reflected.

    Examples
    --------
    >>> from resources import path
    >>> from workbench.design.run import run
    >>> from workbench.design.snapshot import History
    >>> from workbench.files.session import open_design
    >>> task, history = open_design(path("examples", "tophat.json")), History()
    >>> for snapshot in run(task.scene, task.target):
    ...     history.add(snapshot)
    ...     if snapshot.iteration == 2:
    ...         break
    >>> [found.key for found in findings(task, history.result())]
    ['error', 'light', 'uniformity']
    """
    if session.heights is None and not result.iterations:
        start = Cure(Message("Start"), command="start")
        nothing = Message("There is no {optic} yet.", optic=session.scene.optic.called)
        return (Finding("lens", "attention", nothing, start),)
    obstacles = tuple(filter(None, (_shortfall(session, result), _coarse(session, result))))
    light = _light(session, result, attainable)
    reflected = _reflected(session, result, search)
    hindered = bool(obstacles) or light.level == "attention"
    error, level = _error(session, result, verified, attainable, hindered)
    even = _uniformity(session, result, level)
    return tuple(filter(None, (error, light, even, *obstacles, reflected)))


def _error(
    session: Session,
    result: Result,
    verified: VerifiedError | None,
    attainable: Attainable,
    hindered: bool,
) -> tuple[Finding, Level]:
    """The finding of the error, and its level without a goal."""
    lowest, made = attainable.error, bool(session.scene.processes)
    if verified is None:
        error = relative_error(result.state, session.target)
        found = percent(error)
        designed = Message("{error} computed error, not verified yet", error=found)
        as_made = Message("{error} computed error as made, not verified yet", error=found)
    else:
        error = verified.relative_l2_corrected
        found = verified_error(verified)
        designed = Message("{error} verified error", error=found)
        as_made = Message("{error} verified error as made", error=found)
    sentence = as_made if made else designed
    if lowest is None:
        sentence = Message("{sentence}.", sentence=sentence)
    else:
        sentence = Message(
            "{error}; no {optic} gets below {lowest}.",
            error=sentence,
            optic=session.scene.optic.called,
            lowest=percent(lowest),
        )
    met = _ended_by(MET, result.ended)
    settled = has_converged(result.ended) or _ended_by(LOCKED, result.ended)
    above = max(error**2 - (lowest or 0.0) ** 2, 0.0) ** 0.5
    fine = settled and above < (_LOW if hindered else HIGH)
    level: Level = "good" if fine else "attention"
    cure = None
    if verified is None and (settled or met):
        cure = Cure(Message("Check"), command="check")
    elif not settled and not met:
        cure = Cure(Message("Continue"), command="continue")
    judged = GOALS["error"].judged(session.scene, error, level)
    return Finding("error", judged, sentence, cure), level


def _ended_by(words: str, ended: str) -> bool:
    """Whether a run ended for a reason, which may be within another text."""
    if not isinstance(ended, Message):
        return False
    return ended.words == words or _ended_by(words, ended.values.get("ended", ""))


def _light(session: Session, result: Result, attainable: Attainable) -> Finding:
    """The image that gets the least light, and the largest loss."""
    scene = session.scene
    accounts = [light.account for light in result.state.lights]
    account = min(accounts, key=lambda each: each.efficiency)
    part, advice = account.efficiency, account.advice(scene)
    level = GOALS["light"].judged(scene, part, "good" if advice is None else "attention")
    return Finding("light", level, advice or _light_in_words(scene, account, attainable))


def _light_in_words(scene: Scene, account: Account, attainable: Attainable) -> Message:
    most = max(account.lost, key=account.lost.__getitem__)
    values: dict[str, Any] = {
        "part": 100 * account.efficiency,
        "place": Message(scene.receiver.place),
        "lost": 100 * account.lost[most] / account.emitted,
        "where": loss_of(most).goes,
    }
    if attainable.light is None:
        return Message("{part:.1f} % of the light lands {place}; {lost:.1f} % {where}.", **values)
    return Message(
        "{part:.1f} % of the light lands {place}, of at most {most:.1f} %; {lost:.1f} % {where}.",
        most=100 * attainable.light,
        **values,
    )


def _uniformity(session: Session, result: Result, level: Level) -> Finding | None:
    """The least uniform image, where all targets are even areas; None otherwise."""
    images = zip(session.scene.wanted(session.target), result.state.lights, strict=True)
    found = [light_of_lit_area(i.scene, i.target, light.irradiance) for i, light in images]
    areas = [area for area in found if area is not None]
    if len(areas) < len(found):
        return None
    worst = min(areas, key=lambda area: area.uniformity or 0.0)
    even, ends = worst.uniformity or 0.0, worst.least_over_most or 0.0
    sentence = Message(
        "{even:.2f} uniformity U₀ (minimum / average) on the {area}; U₁ (minimum / maximum) is "
        "{ends:.2f}.",
        even=even,
        area=worst.name,
        ends=ends,
    )
    if worst.unit.lumens is not None:
        average = worst.unit.density_in_words(worst.mean)
        sentence = Message("{sentence} Average: {average}.", sentence=sentence, average=average)
    return Finding("uniformity", GOALS["uniformity"].judged(session.scene, even, level), sentence)


def _shortfall(session: Session, result: Result) -> Finding | None:
    """Limits that are too narrow, with wider ones."""
    shortfall, scene = result.state.shortfall, session.scene
    if shortfall is None:
        return None
    wider = shortfall.wider_in(scene)
    if wider is not None:
        path, value = wider
        sentence = Message("{sentence}.", sentence=shortfall.sentence(scene))
        widen = Cure(Message("Widen and start over"), {path: value}, "start")
        return Finding("limits", "attention", sentence, widen)
    sentence = Message("{sentence}.", sentence=shortfall.in_full(scene))
    goes_on = shortfall.cause == "height_range"  # the next run takes a wider one by itself
    cure = Cure(Message("Continue"), command="continue") if goes_on else None
    return Finding("limits", "attention", sentence, cure)


def _coarse(session: Session, result: Result) -> Finding | None:
    """A net that is too coarse, with the automatic one."""
    coarse = coarse_net(session.scene, session.target, result)
    if coarse is None:
        return None
    sentence = Message(
        "{n_u} × {n_v} control points are too few for the detail of this target; {finer_u} × "
        "{finer_v} can show it.",
        n_u=coarse.shape[0],
        n_v=coarse.shape[1],
        finer_u=coarse.finer[0],
        finer_v=coarse.finer[1],
    )
    path = f"{session.scene.face_path()}.control_points"
    cure = Cure(Message("Refine and start over"), {path: "auto"}, "start")
    return Finding("net", "attention", sentence, cure)


def _reflected(session: Session, result: Result, search: bool) -> Finding | None:
    """Light that is totally reflected, where that is more than rounding."""
    lost = result.state.account.lost
    parts = {key: lost[key] for key in lost if kind_and_element(key)[0] == "total_reflection"}
    share = sum(parts.values()) / result.state.account.emitted
    if share < _NAMED:
        return None
    loss = loss_of(max(parts, key=parts.__getitem__))
    cure = loss.cure_in(session.scene)
    found = total_reflection(session.scene, result.state.heights) if search else None
    if found is None:
        sentence = Message(
            "{part:.2g} % of the light {goes}: {cure}.", part=100 * share, goes=loss.goes, cure=cure
        )
        return Finding("reflection", "attention", sentence)
    sentence = Message(
        "{where}, as marked in the 3D scene: {cure}.",
        where=found.sentence(session.scene),
        cure=cure,
    )
    return Finding("reflection", "attention", sentence, places=found.places)
