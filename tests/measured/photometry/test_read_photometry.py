import io
import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
import photompy
import pyldt
import pytest

from tests.measured.photometry.files import GAMMA, candela, ies, ldt
from workbench.errors import Refused
from workbench.measured.photometry import IntensityTable, read_photometry

VERSIONS = [
    "",
    "IESNA91",
    "IESNA:LM-63-1995",
    "IESNA:LM-63-2002",
    "IES:LM-63-2019",
    "LM-63-1986",
    "A series of 1980",
]
FULL = np.linspace(0.0, 360.0, 25)
AROUND = FULL[:-1]


def read(text: str | bytes, name: str = "lamp.ies") -> IntensityTable:
    content = text if isinstance(text, bytes) else text.encode()
    return read_photometry(Path(name), io.BytesIO(content))


def direction(c: np.ndarray, gamma: np.ndarray) -> np.ndarray:
    c, gamma = np.radians(c), np.radians(gamma)
    parts = np.sin(gamma) * np.cos(c), -np.sin(gamma) * np.sin(c), np.cos(gamma)
    return np.stack(np.broadcast_arrays(*parts), axis=-1)


@pytest.mark.parametrize("version", VERSIONS)
def test_each_version_of_ies_files_is_read(version: str) -> None:
    table = read(ies(FULL, GAMMA, candela(FULL, GAMMA), version))

    assert np.allclose(table.candela, candela(FULL, GAMMA), rtol=1e-9)
    assert (table.c == FULL).all() and (table.gamma == GAMMA).all()


@pytest.mark.parametrize("last", [0.0, 90.0, 180.0, 360.0])
def test_symmetric_ies_files_shine_as_another_reader_says(last: float, tmp_path: Path) -> None:
    c = np.linspace(0.0, last, 7) if last else np.zeros(1)
    path = tmp_path / "lamp.ies"
    path.write_text(ies(c, GAMMA, candela(c, GAMMA), multiplier=2.5))

    ours = read(path.read_bytes())

    theirs = photompy.IESFile.read(path).photometry.expanded()
    around, gamma = np.random.default_rng(1).random((2, 500)) * [[360.0], [90.0]]
    stated = np.array([theirs.get_intensity(g, p) for g, p in zip(gamma, around, strict=True)])
    assert np.allclose(ours.at(direction(around, gamma)), stated.ravel(), rtol=1e-9)


@pytest.mark.parametrize("symmetry", range(5))
def test_symmetric_ldt_files_hold_what_another_reader_says(symmetry: int, tmp_path: Path) -> None:
    stored = {0: AROUND, 1: AROUND[:1], 2: AROUND[:13], 4: AROUND[:7]}
    stored[3] = np.roll(AROUND, 6)[:13]
    path = tmp_path / "lamp.ldt"
    values = candela(stored[symmetry], GAMMA)
    path.write_text(ldt(symmetry, AROUND, GAMMA, values), newline="")

    ours = read(path.read_bytes(), "lamp.ldt")

    theirs = np.array(pyldt.LdtReader.read(path).intensities)
    seen = direction(AROUND[:, None], GAMMA[None, :])
    assert np.allclose(ours.at(seen), theirs, rtol=1e-9)


def test_flux_is_that_of_another_reader(tmp_path: Path) -> None:
    gamma = np.linspace(0, 90, 361)
    path = tmp_path / "lamp.ies"
    path.write_text(ies([0], gamma, 100 * np.cos(np.radians(gamma))[None]))

    assert read(path.read_bytes()).lumens == pytest.approx(100 * np.pi, rel=1e-5)
    other = photompy.IESFile.read(path).photometry.total_optical_power()
    assert read(path.read_bytes()).lumens == pytest.approx(other, rel=1e-3)


def test_factors_of_lamp_and_ballast_count() -> None:
    values = candela(FULL, GAMMA)

    table = read(ies(FULL, GAMMA, values, multiplier=3, ballast=0.5))

    assert np.allclose(table.candela, 1.5 * values)


@pytest.mark.parametrize(
    ("first", "counts"),
    [
        ("IESNA86", True),
        ("IESNA91", True),
        ("A lamp", True),
        ("IES file of lab 12", True),
        ("IESNA:LM-63-95", False),
        ("IES:LM-63-2019", False),
    ],
)
def test_the_ballast_lamp_factor_counts_in_files_of_1986_and_1991(first: str, counts: bool) -> None:
    values = candela(FULL, GAMMA)
    text = ies(FULL, GAMMA, values, first, ballast=0.5).replace("\n0.5 1 10\n", "\n0.5 0.8 10\n")

    assert np.allclose(read(text).candela, (0.4 if counts else 0.5) * values)


def _lines(change: Callable[[list[str]], list[str]]) -> Callable[[str], str]:
    return lambda text: "\r\n".join(change(text.splitlines()))


# As programs write files: what is changed of a plain file, which keeps its intensities.
WRITTEN: dict[str, tuple[str, Callable[[str], str | bytes]]] = {
    "spaces at the tilt": ("ies", lambda text: text.replace("TILT=NONE", "TILT =\tnone ")),
    "quotes at the tilt": ("ies", lambda text: text.replace("TILT=NONE", 'TILT="NONE"')),
    "factors of a tilted lamp": (
        "ies",
        lambda text: text.replace("TILT=NONE", "TILT=INCLUDE\n1\n3\n0 45 90\n1 0.9 0.8"),
    ),
    "one number a line": (
        "ies",
        lambda text: "TILT=NONE\n" + "\n".join(text.partition("TILT=NONE")[2].split()),
    ),
    "Fortran's exponents": ("ies", lambda text: text.replace("\n1.0 1 10", "\n1.0D+00 1D0 10")),
    "a little below zero": ("ies", lambda text: text.rstrip()[:-1].rsplit(" ", 1)[0] + " -0.02\n"),
    "text behind the numbers of IES": ("ies", lambda text: text + "END OF FILE\n"),
    "the mark of CP/M": ("ies", lambda text: text + "\x1a\0rubbish 5\n"),
    "a comment behind LDT": ("ldt", lambda text: text + "; by X, 1.5\r\n"),
    "no direct ratios": ("ldt", _lines(lambda lines: lines[:32] + [""] * 10 + lines[42:])),
    "marks of thousands": ("ldt", _lines(lambda lines: [*lines[:28], "1,000", *lines[29:]])),
} | {
    f"{ending} in {encoding}{' with a mark' * bool(mark)}": (
        ending,
        lambda text, encoding=encoding, mark=mark: (mark + text).encode(encoding),
    )
    for ending in ("ies", "ldt")
    for encoding, mark in [
        ("utf-16", ""),
        ("utf-16-le", ""),
        ("utf-16-be", ""),
        ("utf-16-be", "\ufeff"),
        ("utf-8-sig", ""),
        ("latin-1", ""),
    ]
}


@pytest.mark.parametrize(("ending", "written"), WRITTEN.values(), ids=WRITTEN.keys())
def test_files_as_programs_write_them_are_read(
    ending: str, written: Callable[[str], str | bytes]
) -> None:
    values = candela(FULL, GAMMA)
    text = (
        ies(FULL, GAMMA, values, keywords="[OTHER] Straße 5°")
        if ending == "ies"
        else ldt(0, AROUND, GAMMA, values[:-1]).replace("nobody", "Straße 5°")
    )

    table = read(written(text), f"lamp.{ending}")

    assert np.allclose(table.candela, values, atol=1e-9)


@pytest.mark.parametrize("symmetry", [1, 2, 3, 4])
def test_ldt_files_may_list_the_stored_planes_alone(symmetry: int) -> None:
    stored = {1: AROUND[:1], 2: AROUND[:13], 3: np.roll(AROUND, 6)[:13], 4: AROUND[:7]}[symmetry]
    text = ldt(symmetry, AROUND, GAMMA, candela(stored, GAMMA))
    lines = text.splitlines()
    listed = lines[:42] + [f"{c:g}" for c in stored] + lines[42 + len(AROUND) :]

    assert np.allclose(read("\n".join(listed), "a.ldt").candela, read(text, "a.ldt").candela)


@pytest.mark.parametrize("value", [1e39, 1e300, 1e-46, 1e-320])
@pytest.mark.parametrize("ending", ["ies", "ldt"])
def test_intensities_beyond_all_lamps_are_refused_without_a_warning(
    value: float, ending: str
) -> None:
    values = np.array([[value, value]])
    text = ies([0], [0, 90], values) if ending == "ies" else ldt(1, [0.0], [0, 90], values)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(Refused, match="its largest intensity is"):
            read(text, f"lamp.{ending}")


def good() -> str:
    return ies([0], [0, 45, 90], np.array([[100.0, 50.0, 0.0]]))


@pytest.mark.parametrize(
    ("text", "stated"),
    [
        (good()[:-8], "is cut off: its header makes 20 numbers"),
        (good() + "7 7\n", "goes on behind its end"),
        (good().replace("50", "nan"), "'nan' stands where a finite number is needed"),
        (good().replace("50", "-50"), "an intensity of -50 cd; none can be negative"),
        (good().replace("100 50 0", "0 0 0"), "gives no light"),
        (good().replace("0 45 90", "0 90 45"), "angles γ do not ascend"),
        (good().replace("0 45 90", "0 45 270"), "γ go from 0° to 270°"),
        (good().replace(" 3 1 1 ", " 999999999 1 1 "), "from 1 to 16384"),
        (good().replace(" 3 1 1 ", " 2.5 1 1 "), "a whole number"),
        (good().replace("LM-63-2002", "LM-63-2050"), "its version is"),
        (good().replace("IESNA:LM-63-2002", "LM-63-3000"), "its version is 'LM-63-3000'"),
        (good().replace("=NONE", "=other.tlt"), "TILT is in another file, 'OTHER.TLT'"),
        (good().replace("TILT=NONE", ""), "no line that begins with TILT="),
        ("", "no line that begins with TILT="),
        ("TILT=NONE", "is cut off"),
        ("TILT=INCLUDE\n1", "is cut off within its TILT"),
    ],
)
def test_ies_files_that_are_wrong_are_refused_in_a_sentence(text: str, stated: str) -> None:
    with pytest.raises(Refused, match=r"^lamp\.ies: cannot be used: ") as refused:
        read(text)

    assert stated in str(refused.value)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("name", ["lamp.ies", "lamp.ldt"])
def test_files_that_are_cut_or_damaged_anywhere_are_read_or_refused(name: str) -> None:
    c, values = AROUND, candela(AROUND, GAMMA)
    text = (
        ldt(0, c, GAMMA, values) if name.endswith("ldt") else ies(FULL, GAMMA, candela(FULL, GAMMA))
    )
    content = text.encode()
    generator = np.random.default_rng(3)
    for cut in generator.integers(0, len(content) - 3, 60):
        with pytest.raises(Refused):
            read(content[:cut], name)
    for place, byte in generator.integers(0, [[len(content)], [256]], (2, 300)).T:
        damaged = bytearray(content)
        damaged[place] = byte
        try:
            assert np.isfinite(read(bytes(damaged), name).lumens)
        except Refused as refused:
            assert str(refused).startswith(f"{name}: cannot be used: ")


def turned(kind: int, h: float, v: float) -> np.ndarray:
    """The direction of H to the right of the beam axis, which is −x, and V upwards."""
    h, v = np.radians(h), np.radians(v)
    if kind == 3:
        return np.array([-np.cos(v) * np.sin(h), np.sin(v), np.cos(v) * np.cos(h)])
    return np.array([-np.sin(h), np.cos(h) * np.sin(v), np.cos(h) * np.cos(v)])


@pytest.mark.parametrize("kind", [2, 3])
@pytest.mark.parametrize("peak", [(20.0, 0.0), (-30.0, 10.0), (0.0, 40.0), (50.0, -60.0)])
def test_the_peak_of_types_a_and_b_is_where_their_angles_say(
    kind: int, peak: tuple[float, float]
) -> None:
    h = v = np.linspace(-90.0, 90.0, 37)
    values = np.exp(-((h[:, None] - peak[0]) ** 2 + (v - peak[1]) ** 2) / 2 / 12**2)

    table = read(ies(h, v, 1000 * values, kind=kind))

    i, j = np.unravel_index(table.candela.argmax(), table.candela.shape)
    found = direction(table.c[i], table.gamma[j])
    assert np.degrees(np.arccos(found @ turned(kind, *peak))) < 0.5
    assert table.at(turned(kind, *peak)) == pytest.approx(1000, rel=0.01)
    for aside in (5, 12):  # a node, and a place between nodes
        there = turned(kind, peak[0] + aside, peak[1])
        stated = np.interp(peak[0] + aside, h, values[:, v == peak[1]].ravel())
        assert table.at(there) == pytest.approx(1000 * stated, rel=0.01)


@pytest.mark.parametrize("kind", [2, 3])
def test_the_flux_of_types_a_and_b_is_the_closed_form(kind: int) -> None:
    """An even patch of 40° × 20°: the difference of a sine times an angle."""
    h, v = np.linspace(-20.0, 20.0, 41), np.linspace(-10.0, 10.0, 21)
    wide, high = (20.0, 10.0) if kind == 3 else (10.0, 20.0)

    table = read(ies(h, v, np.full((41, 21), 100.0), kind=kind))

    flux = 100 * 2 * np.radians(wide) * 2 * np.sin(np.radians(high))
    assert table.lumens == pytest.approx(flux, rel=1e-9)
    assert table.at(turned(kind, 12.3, -4.5)) == pytest.approx(100, rel=0.01)
    assert table.at(turned(kind, 21.0, 0.0)) == 0
    half = read(ies(h[20:], v, np.full((21, 21), 100.0), kind=kind))
    assert np.allclose(half.candela, table.candela, rtol=1e-6)
