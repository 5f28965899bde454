"""Surface data by ISO 25178-72 (.x3p): a zip of main.xml and of binary points, in metres."""

import io
import zipfile
from xml.etree import ElementTree

import numpy as np

from workbench.arrays import Array
from workbench.measured.surfaces.points import (
    MOST_POINTS,
    MeasuredSurface,
    checked_size,
    surface_of,
)
from workbench.measured.text import count, number
from workbench.messages import Message

_MAIN, _LONGEST = "main.xml", 1 << 24
_TYPES = {"I": "<i2", "L": "<i4", "F": "<f4", "D": "<f8"}


def read_x3p(content: bytes) -> MeasuredSurface:
    """Read surface data; raise ValueError if it is invalid."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            root = ElementTree.fromstring(_entry(archive, _MAIN, _LONGEST))
            return _Reader(root, archive).surface()
    except (zipfile.BadZipFile, ElementTree.ParseError, KeyError) as error:
        raise ValueError(Message("it is damaged or incomplete: {why}", why=error)) from error


def _entry(archive: zipfile.ZipFile, name: str, most: int) -> bytes:
    if archive.getinfo(name).file_size > most:
        raise ValueError(Message("its entry {name} is too long", name=name))
    return archive.read(name)


class _Reader:
    def __init__(self, root: ElementTree.Element, archive: zipfile.ZipFile) -> None:
        self._root, self._archive = root, archive

    def _text(self, path: str, default: str | None = None) -> str:
        found = self._root.findtext(path, default)
        if found is None:
            raise ValueError(Message("its main.xml has no {path}", path=path))
        return found.strip()

    def surface(self) -> MeasuredSurface:
        columns, rows = checked_size(
            *(
                count(self._text(f"Record3/MatrixDimension/Size{axis}"), 1, MOST_POINTS)
                for axis in "XY"
            )
        )
        is_grid = self._text("Record1/FeatureType", "SUR") == "SUR"
        axes = [
            axis
            for axis in "XYZ"
            if self._text(f"Record1/Axes/C{axis}/AxisType", "A") == "A" or axis == "Z"
        ]
        stored = self._stored(axes, columns * rows)
        places = np.divmod(np.arange(columns * rows), columns) if is_grid else None
        points = np.empty((columns * rows, 3))
        for k, axis in enumerate("XYZ"):
            path = f"Record1/Axes/C{axis}"
            step = number(self._text(f"{path}/Increment", "1") or "1")
            offset = number(self._text(f"{path}/Offset", "0") or "0")
            if axis in axes:
                points[:, k] = stored[axis] * step + offset
            elif places is not None:
                points[:, k] = places[1 - k] * step + offset
            else:
                raise ValueError(Message("its axis {axis} has no values", axis=axis))
        return surface_of(points, "m")

    def _stored(self, axes: list[str], points: int) -> dict[str, Array]:
        """Values of each axis that has values of its own, as stored."""
        link = "Record3/DataLink/PointDataLink"
        if self._root.find(link) is None:
            data = [each.text or "" for each in self._root.iterfind("Record3/DataList/Datum")]
            rows = [[number(word) if word else np.nan for word in each.split(";")] for each in data]
            rows = [row or [np.nan] * len(axes) for row in rows]
            if len(rows) != points or {len(row) for row in rows} != {len(axes)}:
                raise ValueError(Message("it is cut off"))
            return dict(zip(axes, np.array(rows).T, strict=True))
        kinds = [self._text(f"Record1/Axes/C{axis}/DataType", "D") for axis in axes]
        if unknown := [kind for kind in kinds if kind not in _TYPES]:
            raise ValueError(
                Message("its DataType is {found!r}; I, L, F, D are known", found=unknown[0][:8])
            )
        record = np.dtype([(axis, _TYPES[kind]) for axis, kind in zip(axes, kinds, strict=True)])
        content = _entry(self._archive, self._text(link), 2 * points * record.itemsize)
        if len(content) < points * record.itemsize:
            raise ValueError(Message("it is cut off"))
        table = np.frombuffer(content, record, points)
        found = {axis: table[axis].astype(np.float64) for axis in axes}
        valid = self._root.findtext("Record3/DataLink/ValidPointsLink")
        if valid:
            bits = np.frombuffer(_entry(self._archive, valid.strip(), points + 8), np.uint8)
            there = np.unpackbits(bits, bitorder="little")[:points].astype(bool)
            if len(there) < points:
                raise ValueError(Message("it is cut off"))
            found[axes[-1]][~there] = np.nan
        return found
