"""``session.json``: all of a session but its arrays."""

import json
from collections.abc import Mapping
from typing import Annotated, Any, Final, Literal

from pydantic import Field, ValidationError

from workbench.design.session import LONGEST_NAME
from workbench.errors import Refused
from workbench.files.figures import Figures, VerifiedFigures
from workbench.files.scene import check_fields_once
from workbench.messages import Message
from workbench.refusals import refusal
from workbench.scene import AutoNet, Part, Scene
from workbench.scene.faces import NetShape

VERSION: Final = 3
"""Version of the newest session files that this program reads."""

MOST_RUNS = 64
"""Most kept runs in a session."""

LARGEST_VIEW = 1 << 16
"""Most bytes of a view as JSON without spaces."""

_DEEPEST_VIEW = 16


class RunHeader(Part):
    """A kept run; its scene is validated separately."""

    name: Annotated[str, Field(min_length=1, max_length=LONGEST_NAME)]
    scene: dict[str, Any]
    control_points: NetShape | None = None
    result: Figures
    verified: VerifiedFigures | None = None


class Header(Part):
    """``session.json``; its scene is validated separately."""

    format: Literal["freeform-session"] = "freeform-session"
    version: Literal[1, 2, 3]
    scene: dict[str, Any]
    control_points: NetShape | None = None  # chosen for "auto"
    result: Figures | None = None
    runs: tuple[RunHeader, ...] | None = None
    view: dict[str, Any] | None = None
    program: str


class _Kind(Part, extra="ignore"):
    """The fields that are checked first."""

    format: Literal["freeform-session"]
    version: Annotated[int, Field(ge=1)]


def read_header(text: bytes, where: str) -> Header:
    """Parse the header; raise Refused if it is invalid or of a newer program."""
    try:
        kind = _Kind.model_validate_json(text)
        if kind.version > VERSION:
            raise Refused(
                f"{where}: version",
                Message(
                    "{version} is of a newer Freeform Lens Workbench, at most {most} "
                    "can be read here; update the program",
                    version=kind.version,
                    most=VERSION,
                ),
            )
        header = Header.model_validate_json(text)
    except ValidationError as error:
        refused = refusal(error, Header, whole="text")
        raise Refused(f"{where}: {refused.path}", refused.reason) from None
    check_fields_once(text, f"{where}: ")
    runs = header.runs or ()
    if len(runs) > MOST_RUNS:
        raise Refused(
            f"{where}: runs",
            Message("{count} are given; at most {most} are kept", count=len(runs), most=MOST_RUNS),
        )
    plain_view(header.view, f"{where}: view")
    return header


def chosen_net(scene: Scene) -> NetShape | None:
    """Return the numbers of control points that were chosen for a scene with ``"auto"``."""
    auto = isinstance(scene.optic.control_points, AutoNet)
    return scene.optic.known_shape if auto else None


def read_part(scene: dict[str, Any], net: NetShape | None, where: str) -> Scene:
    """Read a scene of the header with its chosen net; raise Refused if it is not possible."""
    try:
        found = Scene.from_data(scene)
        return found if net is None else found.with_net(net)
    except Refused as refused:
        raise Refused(f"{where}: {refused.path}", refused.reason) from None


def plain_view(view: Mapping[str, Any] | None, where: str) -> dict[str, Any] | None:
    """Return a view after a round trip through JSON; raise Refused if too large or too deep."""
    try:
        text = json.dumps(view, allow_nan=False, ensure_ascii=False, separators=(",", ":"))
        size = len(text.encode())
    except (TypeError, ValueError, RecursionError) as error:
        raise Refused(where, Message("cannot be kept as JSON: {error}", error=error)) from None
    if size > LARGEST_VIEW:
        raise Refused(
            where,
            Message("takes {size} bytes; at most {most} are kept", size=size, most=LARGEST_VIEW),
        )
    plain: dict[str, Any] | None = json.loads(text)
    if _depth(plain) > _DEEPEST_VIEW:
        raise Refused(
            where,
            Message("is nested too deeply; at most {most} levels are kept", most=_DEEPEST_VIEW),
        )
    return plain


def _depth(value: object) -> int:
    if isinstance(value, dict):
        value = list(value.values())
    return 1 + max(map(_depth, value), default=0) if isinstance(value, list) else 0
