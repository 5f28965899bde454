import io
from pathlib import Path

import numpy as np
import pytest

from tests.measured.rays.files import dat, rays, text, tm25
from workbench.errors import Refused
from workbench.measured.rays import RaySet, read_rays

TABLE = rays(1000)


def read(content: bytes, name: str = "led.tm25ray") -> RaySet:
    return read_rays(Path(name), io.BytesIO(content))


def holds(found: RaySet, table: np.ndarray) -> bool:
    whole = np.column_stack([found.position, found.direction, found.flux])
    return np.allclose(whole, table[:, :7], rtol=1e-6, atol=1e-7) and found.in_file == len(table)


def test_tm25_files_hold_their_rays_in_millimetres() -> None:
    found = read(tm25(TABLE))

    assert holds(found, TABLE)
    assert found.unit == "mm"
    assert found.total == pytest.approx(TABLE[:, 6].sum())


def test_optional_columns_of_tm25_files_are_at_their_places() -> None:
    stokes, luminous, index = np.zeros((1000, 6)), 2 * TABLE[:, 6:], np.ones((1000, 1))
    flags = (1, 1, 1, 1, 1, 1, 0, 1)
    index[::2] = 2
    table = np.hstack([TABLE, np.full((1000, 1), 555), luminous, stokes, index, np.ones((1000, 2))])
    spectra = np.array([[400, 1.0], [500, 2], [600, 1]]), np.array([[450, 1.0], [650, 1]])

    found = read(tm25(table, flags, spectra, names=("phase", "field"), text="by hand!"))

    assert np.allclose(found.flux, luminous[:, 0])
    assert found.wavelength_nm is not None and (found.wavelength_nm == 555).all()
    assert found.spectrum is not None
    assert (found.spectrum == index[:, 0] - 1).all()
    assert all((a == b).all() for a, b in zip(found.spectra, spectra, strict=True))


@pytest.mark.parametrize(("number", "unit"), list(enumerate(("m", "inch", "cm", "feet", "mm"))))
def test_opticstudio_files_hold_their_rays_and_unit(number: int, unit: str) -> None:
    found = read(dat(TABLE, number), "led.DAT")

    assert holds(found, TABLE)
    assert found.unit == unit


OPTICSTUDIO = "led.dat", "mm"  # the head of such text has the number of a unit
WRITTEN = {
    "tabs at the end of lines": ("led.csv", None, text(TABLE, "\t", "\t\n")),
    "commas at the end of lines": ("led.csv", None, text(TABLE, ",", ",\r\n")),
    "decimal commas": ("led.csv", None, text(TABLE, ";").replace(b".", b",")),
    "names of columns": ("led.txt", None, text(TABLE, "\t", "\t\n", "x\ty\t\n")),
    "a head": (*OPTICSTUDIO, text(TABLE, " ", head="1000 4\n")),
    "a head of 7 numbers": (*OPTICSTUDIO, text(TABLE, " ", head="1000.0 4.0 0 0 0 0 0\n")),
    "a head with tabs": (*OPTICSTUDIO, text(TABLE, head="\n  1000\t4\t0\t0\t0\t0\t0\t\n")),
    "a head in a text file": ("led.txt", "mm", text(TABLE, " ", head="1000 4\n")),
} | {
    f"{name} in {encoding}": (name, "cm", text(TABLE, " ", "\r\n", head).decode().encode(encoding))
    for name, head in (("led.csv", "x [cm],y,z\n"), ("led.dat", "1000 2\n"))
    for encoding in ("utf-16", "utf-16-le", "utf-16-be", "utf-8-sig")
}


@pytest.mark.parametrize(("name", "unit", "content"), WRITTEN.values(), ids=WRITTEN.keys())
def test_text_as_programs_write_it_is_read(name: str, unit: str | None, content: bytes) -> None:
    found = read(content, name)

    assert holds(found, TABLE)
    assert found.unit == unit


def with_value(row: int, column: int, value: float) -> np.ndarray:
    table = TABLE.copy()
    table[row, column] = value
    return table


@pytest.mark.parametrize(
    ("content", "stated"),
    [
        (b"", "is cut off within its header"),
        (tm25(TABLE)[:5000], "is cut off within its header"),
        (tm25(TABLE)[:-10], "header says 1000 rays of 7 numbers, and the 27990 bytes"),
        (tm25(TABLE) + b"more", "header says 1000 rays"),
        (tm25(TABLE, count=1 << 62), "header says 4611686018427387904 rays"),
        (tm25(TABLE, version=2020), "of version 2020; 2013 is known"),
        (tm25(TABLE).replace(b"TM25", b"TM26"), "does not begin with TM25"),
        (tm25(TABLE, flags=(1, 0, 1, 0, 0, 0, 0, 0)), "flags of its columns"),
        (tm25(TABLE, flags=(1, 1, 7, 0, 0, 0, 0, 0)), "flags of its columns"),
        (tm25(TABLE[:0]), "has no rays"),
        (tm25(with_value(5, 0, np.nan)), "ray 6 has a value that is no finite number"),
        (tm25(with_value(5, 6, -1)), "ray 6 has a negative flux"),
        (tm25(with_value(5, 3, 2)), "ray 6 has a direction that is no unit vector"),
        (tm25(np.hstack([TABLE[:, :6], np.zeros((1000, 1))])), "none of its rays has any flux"),
        (
            tm25(np.hstack([TABLE, np.full((1000, 1), 3)]), (1, 1, 1, 0, 0, 0, 0, 1)),
            "none of the 0",
        ),
    ],
)
def test_tm25_files_that_are_wrong_are_refused_in_a_sentence(content: bytes, stated: str) -> None:
    with pytest.raises(Refused, match=r"^led\.tm25ray: cannot be used: ") as refused:
        read(content)

    assert stated in str(refused.value)


@pytest.mark.parametrize(
    ("content", "stated"),
    [
        (b"", "begins neither"),
        (dat(TABLE)[:100], "is cut off within its header"),
        (dat(TABLE)[:-1], "header says 1000 rays, and the 27999 bytes"),
        (dat(TABLE, identifier=1009), "begins neither"),
        (dat(TABLE, unit=9), "its unit is 9"),
        (dat(TABLE, count=7), "header says 7 rays"),
        (text(TABLE, " ", head="999 4\n"), "says 999 rays, and there are 1000"),
    ],
)
def test_opticstudio_files_that_are_wrong_are_refused(content: bytes, stated: str) -> None:
    with pytest.raises(Refused, match=r"^led\.dat: cannot be used: ") as refused:
        read(content, "led.dat")

    assert stated in str(refused.value)


@pytest.mark.parametrize(
    ("content", "stated"),
    [
        (b"", "has no rays"),
        (b"x,y,z,l,m,n,flux\n", "has no rays"),
        (b"0,0,0,0,0,1\n", "first ray has 6 numbers"),
        (text(TABLE) + b"1,2,3\n", "has no rays"),
        (text(TABLE) + b"one,2,3,4,5,6,7\n", "has no rays"),
        (text(TABLE)[:-30].rpartition(b",")[0], "behind ray 999 it has 4 columns; 7 as above"),
        (b"\0" * 5000, "has"),
        (text(TABLE, ", ").replace(b".", b","), "first ray has"),
    ],
)
def test_text_that_is_wrong_is_refused(content: bytes, stated: str) -> None:
    with pytest.raises(Refused, match=r"^led\.csv: cannot be used: ") as refused:
        read(content, "led.csv")

    assert stated in str(refused.value)
    assert len(str(refused.value)) < 200


@pytest.mark.parametrize("name", ["led.tm25ray", "led.dat", "led.csv"])
def test_files_that_are_cut_or_damaged_anywhere_are_read_or_refused(name: str) -> None:
    table = rays(50)
    content = {"led.tm25ray": tm25, "led.dat": dat, "led.csv": text}[name](table)
    generator = np.random.default_rng(4)
    places = generator.integers(0, len(content), 400)
    if name == "led.tm25ray":  # where it is not zero
        places = np.concatenate([places % 300, 36288 + places % 1400])
    for place in places[:150]:
        try:
            found = read(content[:place], name)
        except Refused as refused:
            assert str(refused).startswith(f"{name}: cannot be used: ")
        else:  # a line of text may end sooner, and others be missing
            assert name == "led.csv" and found.in_file <= 50
    for place in places:
        damaged = bytearray(content)
        damaged[place] = generator.integers(256)
        try:
            assert np.isfinite(read(bytes(damaged), name).total)
        except Refused as refused:
            assert str(refused).startswith(f"{name}: cannot be used: ")
