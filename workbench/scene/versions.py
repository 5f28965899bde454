"""Scene files; those of versions 1 and 2 are converted to version 3.

A refusal of a converted scene is given the path that the field has in the file.
"""

import json
import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any, Literal, Self

from pydantic import ValidationError
from pydantic_core import from_json

from workbench.errors import Refused, shown
from workbench.messages import Message
from workbench.refusals import SENTENCES, field_name, refusal
from workbench.scene.part import Part
from workbench.scene.turning import tilt_of, tilted, turned

Data = dict[str, Any]

_SCENE = (
    "far_field filter format further_images lens mirror regions run screen source target unit "
    "version"
)
_NET = "base control_points degree height_range"
_LENS = (
    f"absorption coating {_NET} entrance entrance_z half_width max_thickness min_thickness outline "
    "reflection refractive_index wavelength_um"
)
_MIRROR = f"{_NET} half_width outline reflectance thickness"
_KEPT_OF_LENS = [
    "half_width",
    "outline",
    "absorption",
    "coating",
    "max_thickness",
    "min_thickness",
    "reflection",
]
_KEPT_OF_MIRROR = ["half_width", "outline", "reflectance", "thickness"]
_MOST_FURTHER = 8
_KEPT_OF_FACE = ["control_points", "degree", "height_range"]


class _Versioned(Part, extra="ignore"):
    version: Literal[1, 2, 3] = 1


class SceneFile(Part):
    """What is read from scene files of all versions, and written as one of version 3."""

    @classmethod
    def from_json(cls, text: str | bytes) -> Self:
        """Read a scene from the text of a scene file.

        Raises `Refused` with the path of the field in the file, the value and what is allowed.
        """
        try:
            version = _Versioned.model_validate_json(text).version
            if version == 3:
                return cls.model_validate_json(text)
        except ValidationError as error:
            raise refusal(error, cls) from None
        data = from_json(text)
        converted = json.dumps(upgraded(data, version))
        try:
            return cls.model_validate_json(converted)
        except ValidationError as error:
            refused = refusal(error, cls)
            raise Refused(_old_path(refused.path, data), refused.reason) from None
        except Refused as refused:
            raise Refused(_old_path(refused.path, data), refused.reason) from None

    @classmethod
    def from_data(cls, data: dict[str, Any]) -> Self:
        """Read a scene from plain dictionaries and lists, as `json.loads` gives them."""
        return cls.from_json(json.dumps(data))

    def to_json(self) -> str:
        """The text of a scene file, indented."""
        return self.model_dump_json(indent=2, exclude_none=True) + "\n"

    def to_data(self) -> dict[str, Any]:
        """The scene as plain dictionaries and lists."""
        data: dict[str, Any] = self.model_dump(mode="json", exclude_none=True)
        return data


def upgraded(data: Data, version: int) -> Data:
    """Return a scene of version 1 or 2 as one of version 3.

    Raises `Refused` if a field that the conversion needs is missing, unknown or of a wrong type.
    """
    _check_known("", data, _SCENE)
    optic = _one_of(data, "lens", "mirror")
    new: Data = {
        name: data[name] for name in ("format", "unit", "filter", "regions") if name in data
    }
    source = _source("source", data["source"]) if "source" in data else None
    if optic == "lens":
        element, wavelength = _lens(_object("lens", data["lens"]), version)
        if isinstance(source, dict) and wavelength is not None:
            source["wavelength_um"] = wavelength
    else:
        element = _mirror(_object("mirror", data["mirror"]))
    if source is not None:
        new["source"] = source
    images = [_image("", data, {})]
    others = _list("further_images", data.get("further_images", []))
    if len(others) > _MOST_FURTHER:
        many = Message("{count} are given; at most {most}", count=len(others), most=_MOST_FURTHER)
        raise Refused("further_images", many)
    for number, further in enumerate(others):
        path = f"further_images[{number}]"
        kept = {k: v for k, v in _object(path, further).items() if k == "weight"}
        _check_known(path, further, "screen far_field target weight")
        images.append(_image(f"{path}.", further, kept))
    if "run" in data:
        new["run"] = _run(data["run"])
    return {**new, "version": 3, "elements": [element], "images": images}


def _lens(lens: Data, version: int) -> tuple[Data, Any]:
    """Element of version 3, and the wavelength."""
    _check_known("lens", lens, _LENS)
    front_z = _number("lens.entrance_z", lens.get("entrance_z", 0.0))
    height, face = _face("lens", lens)
    if height is None:
        half = lens.get("half_width")
        known = isinstance(half, list) and all(isinstance(r, int | float) for r in half)
        thickness = 0.5 * max(half, default=0.0) if known and half else 0.0
    else:
        thickness = float(_exact(height) - _exact(front_z)) if _finite(height, front_z) else height
    element = {name: lens[name] for name in _KEPT_OF_LENS if name in lens}
    element.setdefault("reflection", "fresnel" if version >= 2 else "schlick")
    element |= {"kind": "lens", "name": "lens", "position": [0.0, 0.0, front_z]}
    element |= {"thickness": thickness, "faces": [_entrance(lens.get("entrance")), face]}
    wavelength = lens.get("wavelength_um")
    if "refractive_index" in lens:
        material = lens["refractive_index"]
        if isinstance(material, str) and wavelength is None:
            reason = Message("missing; it goes with {material}", material=shown(material))
            raise Refused("lens.wavelength_um", reason)
        if isinstance(material, bool) or not isinstance(material, int | float | str):
            raise Refused(
                "lens.refractive_index",
                Message(
                    "{value} is neither a number nor a name; a number above 1 or a material name",
                    value=shown(material),
                ),
            )
        if not isinstance(material, str) and not 1 < material < float("inf"):
            reason = Message("{value}; a number greater than 1 is needed", value=shown(material))
            raise Refused("lens.refractive_index", reason)
        element["material"] = material if isinstance(material, str) else {"index": material}
    return element, wavelength


def _mirror(mirror: Data) -> Data:
    _check_known("mirror", mirror, _MIRROR)
    height, face = _face("mirror", mirror)
    element = {name: mirror[name] for name in _KEPT_OF_MIRROR if name in mirror}
    element |= {"kind": "mirror", "name": "mirror", "position": [0.0, 0.0, height or 0.0]}
    return element | {"face": face}


def _face(path: str, optic: Data) -> tuple[Any, Data]:
    """Z of the base where it is given, and the face."""
    face: Data = {name: optic[name] for name in _KEPT_OF_FACE if name in optic}
    if "control_points" not in face:
        raise Refused(f"{path}.control_points", Message(SENTENCES["missing"]))
    height = None
    if optic.get("base") is not None:
        base = dict(_object(f"{path}.base", optic["base"]))
        if "height" in base:
            height = _number(f"{path}.base.height", base.pop("height"))
        elif base.get("shape", "flat") in ("flat", "sphere"):
            raise Refused(f"{path}.base.height", Message(SENTENCES["missing"]))
        face["base"] = base
    return height, face | {"shape": "bspline"}


def _entrance(entrance: Any) -> Data:
    if entrance is None:
        return {"shape": "plane"}
    face = dict(_object("lens.entrance", entrance))
    match face.get("shape", "flat"):
        case "flat":
            return face | {"shape": "plane"}
        case "freeform":
            _check_known("lens.entrance", face, "control_points degree height_range shape")
            return face | {"shape": "bspline"}
    allowed = Message(
        SENTENCES["unknown_kind"], input=shown(face["shape"]), expected="'flat', 'freeform'"
    )
    raise Refused("lens.entrance.shape", allowed)


def _image(path: str, data: Data, image: Data) -> Data:
    kind = _one_of(data, "screen", "far_field", path)
    receiver = dict(_object(f"{path}{kind}", data[kind]))
    if kind == "screen":
        receiver = _plane(f"{path}screen", receiver)
    else:
        _check_known(f"{path}far_field", receiver, "center half_angle pixels")
        receiver["kind"] = "far_field"
    image = image | {"receiver": receiver}
    return image | ({"target": data["target"]} if "target" in data else {})


def _plane(path: str, screen: Data) -> Data:
    _check_known(path, screen, "center half_width pixels tilt z")
    if "z" not in screen:
        raise Refused(f"{path}.z", Message(SENTENCES["missing"]))
    z = _number(f"{path}.z", screen.pop("z"))
    x, y = _numbers(f"{path}.center", screen.pop("center", [0.0, 0.0]), 2)
    about_x, about_y = _numbers(f"{path}.tilt", screen.pop("tilt", [0.0, 0.0]), 2)
    for axis, angle in enumerate((about_x, about_y)):
        if not -180 <= angle <= 180:
            least = angle < -180
            end = {"ge": -180.0} if least else {"le": 180.0}
            sentence = SENTENCES["greater_than_equal" if least else "less_than_equal"]
            raise Refused(f"{path}.tilt[{axis}]", Message(sentence, input=shown(angle), **end))
    tilt = [about_x, about_y, 0.0]
    if about_x and about_y:
        tilt = list(tilt_of(turned((about_x, about_y))))
    return screen | {"kind": "plane", "position": [x, y, z], "tilt": tilt}


def _source(path: str, source: Any) -> Any:
    if not isinstance(source, dict):
        return source
    new = dict(source)
    if _centred(source):
        if "position" in new:
            raise _unknown(path, "position", sorted({*new, "center"} - {"position"}))
        if "center" in new:
            new["position"] = new.pop("center")
    if source.get("kind") in ("photometric", "ray_file") and "rotation" in source:
        angles = _numbers(f"{path}.rotation", source["rotation"], 3)
        if sum(angle != 0 for angle in angles) > 1 and _finite(*angles):
            about = [
                tilted([a if axis == k else 0.0 for k in range(3)]) for axis, a in enumerate(angles)
            ]
            new["rotation"] = list(tilt_of(about[2] @ about[1] @ about[0]))
    return new


def _centred(source: Any) -> bool:
    return isinstance(source, dict) and source.get("kind") in ("grid", "area")


def _run(run: Any) -> Any:
    if not (isinstance(run, dict) and isinstance(run.get("stages"), list)):
        return run
    stages = [
        stage | {"source": _source(f"run.stages[{number}].source", stage["source"])}
        if isinstance(stage, dict) and "source" in stage
        else stage
        for number, stage in enumerate(run["stages"])
    ]
    return run | {"stages": stages}


def _one_of(data: Data, one: str, other: str, path: str = "") -> str:
    given = [name for name in (one, other) if data.get(name) is not None]
    if not given:
        raise Refused(f"{path}{one}", Message("missing; it or {other} is required", other=other))
    if len(given) > 1:
        both = Message("is given together with a {one}; one of them is needed", one=one)
        raise Refused(f"{path}{other}", both)
    return given[0]


def _check_known(path: str, data: Mapping[str, Any], known: str) -> None:
    for name in data:
        if name not in known.split():
            raise _unknown(path, name, sorted(known.split()))


def _unknown(path: str, name: str, known: list[str]) -> Refused:
    whole = f"{path}.{field_name(name)}" if path else field_name(name)
    return Refused(whole, Message(SENTENCES["extra_forbidden"], fields=", ".join(known)))


def _object(path: str, value: Any) -> Data:
    if not isinstance(value, dict):
        raise Refused(path, Message(SENTENCES["model_type"], input=shown(value)))
    return value


def _list(path: str, value: Any) -> list[Any]:
    if not isinstance(value, list):
        raise Refused(path, Message(SENTENCES["tuple_type"], input=shown(value)))
    return value


def _number(path: str, value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise Refused(path, Message(SENTENCES["float_type"], input=shown(value)))
    if not _finite(value):
        raise Refused(path, Message(SENTENCES["finite_number"], input=shown(value)))
    return value


def _numbers(path: str, value: Any, count: int) -> list[float]:
    values = _list(path, value)
    if len(values) > count:
        sentence = Message(SENTENCES["too_long"], actual_length=len(values), max_length=count)
        raise Refused(path, sentence)
    if len(values) < count:
        raise Refused(f"{path}[{len(values)}]", Message(SENTENCES["missing"]))
    return [_number(f"{path}[{k}]", each) for k, each in enumerate(values)]


def _finite(*values: float) -> bool:
    return all(abs(value) < float("inf") for value in values)


def _exact(value: float) -> Fraction:
    """The number as it is written: 0.3 less 0.2 is 0.1."""
    return Fraction(repr(value))


def _old_path(path: str, data: Data) -> str:
    """Path of a field in a file of version 1 or 2, from the one that it has in version 3."""
    for new, old in _paths(data):
        path, done = re.subn(f"^{re.escape(new)}(?![A-Za-z_])", old, path)
        if done:
            break
    run = data.get("run")
    stages = run.get("stages") or [] if isinstance(run, dict) else []
    sources = {f"run.stages[{k}].source": stage.get("source") for k, stage in enumerate(stages)}
    for where, source in (sources | {"source": data.get("source")}).items():
        if _centred(source) and path.startswith(f"{where}.position"):
            path = path.replace(f"{where}.position", f"{where}.center")
    return path.removeprefix(".")


def _paths(data: Data) -> Iterator[tuple[str, str]]:
    """Paths in version 3 and in the file, longer ones before what they begin with."""
    optic, element = ("lens" if data.get("lens") is not None else "mirror"), "elements[0]"
    yield f"{element}.faces[1].base", f"{optic}.base"
    yield f"{element}.faces[1]", optic
    yield f"{element}.faces[0]", f"{optic}.entrance"
    yield f"{element}.face", optic
    if optic == "lens":
        yield f"{element}.thickness", "lens.base.height"
        yield f"{element}.material.index", "lens.refractive_index"
        yield f"{element}.material", "lens.refractive_index"
        yield "source.wavelength_um", "lens.wavelength_um"
    yield f"{element}.position[2]", "lens.entrance_z" if optic == "lens" else "mirror.base.height"
    yield element, optic
    further = data.get("further_images") or []
    for number, image in enumerate([data, *further]):
        old = f"further_images[{number - 1}]." if number else ""
        kind = "screen" if image.get("screen") is not None else "far_field"
        new = f"images[{number}]"
        yield f"{new}.receiver.position[2]", f"{old}{kind}.z"
        yield f"{new}.receiver.position", f"{old}{kind}.center"
        yield f"{new}.receiver", f"{old}{kind}"
        yield new, old.removesuffix(".")
    yield "images", "further_images"
