import io
import warnings
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
HALF = np.linspace(0.0, 180.0, 13)
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
    said = np.array([theirs.get_intensity(g, p) for g, p in zip(gamma, around, strict=True)])
    assert np.allclose(ours.at(direction(around, gamma)), said.ravel(), rtol=1e-9)


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


def test_ldt_files_tell_intensity_for_each_kilolumen_of_their_lamps() -> None:
    values = candela(AROUND, GAMMA)

    table = read(ldt(0, AROUND, GAMMA, values, lumens=4000, factor=0.5), "lamp.LDT")

    assert np.allclose(table.candela[:-1], 2 * values)


def test_of_several_sets_of_lamps_in_an_ldt_file_the_first_one_shines() -> None:
    """The others are lamps that the luminaire may have instead, as LED modules of other flux."""
    values = candela(AROUND, GAMMA)
    lines = ldt(0, AROUND, GAMMA, values, lumens=2000).splitlines()
    lines[25] = "2"
    lines[32:32] = ["1", "stronger LED", "5000", "3000", "1B", "20"]

    table = read("\r\n".join(lines), "lamp.ldt")

    assert np.allclose(table.candela[:-1], 2 * values)


def test_symmetry_about_c90_is_read_in_ies_files_as_well() -> None:
    c = np.linspace(90.0, 270.0, 13)

    table = read(ies(c, GAMMA, candela(c, GAMMA)))

    seen, mirrored = (table.at(direction(np.full(19, c), GAMMA)) for c in (80.0, 100.0))
    assert np.allclose(seen, mirrored)
    assert np.allclose(
        table.at(direction(np.full(19, 105.0), GAMMA))[:-1], candela(c, GAMMA)[1][:-1]
    )
    assert table.c[0] == 0 and table.c[-1] == 360


def test_flux_of_an_even_lamp_is_its_solid_angle() -> None:
    table = read(ies([0], [0, 10, 60], np.full((1, 3), 100.0)))

    assert table.lumens == pytest.approx(100 * 2 * np.pi * 0.5, rel=1e-12)


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


def test_tilt_factors_of_a_lamp_are_skipped() -> None:
    tilt = "TILT=INCLUDE\n1\n3\n0 45 90\n1 0.9 0.8"

    table = read(ies(FULL, GAMMA, candela(FULL, GAMMA), tilt=tilt))

    assert np.allclose(table.candela, candela(FULL, GAMMA))


@pytest.mark.parametrize("end", ["\r\n", "\r", "\n"])
def test_line_ends_of_any_system_are_read(end: str) -> None:
    text = ies(FULL, GAMMA, candela(FULL, GAMMA))

    table = read(text.replace("\n", end).encode() + b"\x1a")

    assert np.allclose(table.candela, candela(FULL, GAMMA))


def test_text_in_latin_1_is_read() -> None:
    text = ies([0], [0, 90], np.array([[2.0, 1.0]]), keywords="[OTHER] 5°, Straße")

    assert read(text.encode("latin-1")).candela.max() == 2


def test_commas_are_read_between_numbers_and_within() -> None:
    text = ies([0], [0, 45, 90], np.array([[100.5, 50.25, 0.5]]), keywords="[TEST] x")
    head, _, numbers = text.partition("TILT=NONE")

    between = read(head + "TILT=NONE" + numbers.replace(" ", ", "))
    within = read(head + "TILT=NONE" + numbers.replace(".", ","))

    assert np.allclose(between.candela[0], [100.5, 50.25, 0.5])
    assert np.allclose(within.candela[0], [100.5, 50.25, 0.5])
    assert read(ldt(1, AROUND, GAMMA, candela(AROUND[:1], GAMMA)).replace(".", ","), "a.ldt")


def good() -> str:
    return ies([0], [0, 45, 90], np.array([[100.0, 50.0, 0.0]]))


@pytest.mark.parametrize(
    ("text", "said"),
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
        (good().replace("LM-63-2002", "LM-63-2050"), "says to be of version"),
        (good().replace("IESNA:LM-63-2002", "LM-63-3000"), "says to be of version 'LM-63-3000'"),
        (good().replace("=NONE", "=other.tlt"), "TILT is in another file, 'OTHER.TLT'"),
        (good().replace("TILT=NONE", ""), "no line that begins with TILT="),
        ("", "no line that begins with TILT="),
        ("TILT=NONE", "is cut off"),
        ("TILT=INCLUDE\n1", "is cut off within its TILT"),
    ],
)
def test_ies_files_that_are_wrong_are_refused_in_a_sentence(text: str, said: str) -> None:
    with pytest.raises(Refused, match=r"^lamp\.ies: cannot be used: ") as refused:
        read(text)

    assert said in str(refused.value)
    assert "\n" not in str(refused.value)


def test_planes_of_no_known_symmetry_are_refused() -> None:
    with pytest.raises(Refused, match="from 0° to 70°, which is no known symmetry"):
        read(ies([0, 70], [0, 90], np.ones((2, 2))))


def test_other_files_are_refused() -> None:
    with pytest.raises(Refused, match=r"is no photometric file; \.ies or \.ldt is needed"):
        read(good(), "lamp.txt")
    with pytest.raises(Refused, match="has more than 16 MB"):
        read_photometry(Path("lamp.ies"), io.BytesIO(bytes((1 << 24) + 1)))


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


@pytest.mark.parametrize(
    "first", ["IESNA86", "IESNA91", "LM-63-1991", "A lamp", "IES file of lab 12"]
)
def test_the_lamp_factor_of_1986_and_1991_counts(first: str) -> None:
    values = candela(FULL, GAMMA)
    text = ies(FULL, GAMMA, values, first, ballast=0.5).replace("\n0.5 1 10\n", "\n0.5 0.8 10\n")

    assert np.allclose(read(text).candela, 0.4 * values)


@pytest.mark.parametrize("first", ["IESNA:LM-63-95", "IESNA:LM-63-1995", "IES:LM-63-2019"])
def test_later_numbers_at_its_place_do_not_count(first: str) -> None:
    values = candela(FULL, GAMMA)
    text = ies(FULL, GAMMA, values, first).replace("\n1.0 1 10\n", "\n1.0 1.00001 10\n")

    assert np.allclose(read(text).candela, values, rtol=1e-8)
    assert np.allclose(read(text.replace("1.00001", "0.8")).candela, values)


@pytest.mark.parametrize("value", [1e39, 1e300, 1e-46, 1e-300, 1e-320])
@pytest.mark.parametrize("name", ["lamp.ies", "lamp.ldt"])
def test_intensities_beyond_all_lamps_are_refused(value: float, name: str) -> None:
    values = np.array([[value, value]])
    text = (
        ies([0], [0, 90], values)
        if name.endswith("ies")
        else ldt(1, [0.0], [0, 90], values, lumens=1000)
    )
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(Refused, match=r"its largest intensity is 1e|9\.\d+e-321"):
            read(text, name)
        with pytest.raises(Refused, match=r"its largest intensity is inf cd"):
            read(ies([0], [0, 90], np.array([[1e200, 1e200]]), multiplier=1e200))


@pytest.mark.parametrize(
    "encoding", ["utf-16", "utf-16-le", "utf-16-be", "utf-8-sig", "utf-32", "latin-1"]
)
@pytest.mark.parametrize("name", ["lamp.ies", "lamp.ldt"])
def test_text_of_any_encoding_is_read(name: str, encoding: str) -> None:
    values = candela(FULL, GAMMA)
    text = (
        ies(FULL, GAMMA, values, keywords="[OTHER] Straße 5°")
        if name.endswith("ies")
        else ldt(0, AROUND, GAMMA, values[:-1]).replace("nobody", "Straße 5°")
    )
    for mark in ("", "\ufeff") if encoding.endswith("e") else ("",):
        table = read((mark + text).encode(encoding), name)
        assert np.allclose(table.candela, values)


@pytest.mark.parametrize(
    "tilt", ["TILT=NONE", "TILT = NONE", "tilt= none ", "TILT =\tNone", 'TILT="NONE"']
)
def test_spaces_in_the_line_of_the_tilt_are_read(tilt: str) -> None:
    assert read(ies([0], [0, 90], np.array([[2.0, 1.0]]), tilt=tilt)).candela.max() == 2


@pytest.mark.parametrize("end", ["END OF FILE\n", "; by X, 1.5\r\n", "\x1a\0\0rubbish 5\n", "\f\n"])
@pytest.mark.parametrize("name", ["lamp.ies", "lamp.ldt"])
def test_text_behind_the_numbers_is_ignored_and_said(name: str, end: str) -> None:
    text = good() if name.endswith("ies") else ldt(1, AROUND, GAMMA, candela(AROUND[:1], GAMMA))

    table, plain = read(text + end, name), read(text, name)

    assert np.allclose(table.candela, plain.candela)
    assert ("behind the last number" in table.note) == (end[0] in "E;")
    with pytest.raises(Refused, match="goes on behind its end"):
        read(text + "7 7\n" + end, name)


def test_small_negative_intensities_count_as_none() -> None:
    table = read(good().replace("100 50 0", "100 50 -0.02"))

    assert table.candela.min() == 0
    assert "below 0 count as 0: 1, the least is -0.02 cd" in table.note
    with pytest.raises(Refused, match="intensity of -2 cd"):
        read(good().replace("100 50 0", "100 50 -2"))


def test_marks_of_thousands_are_read() -> None:
    ies_text = good().replace("100 50 0", "1,000.5 50 0")
    values = candela(AROUND, GAMMA)

    assert read(ies_text).candela.max() == 1000.5
    for point, mark in ((".", ","), (",", ".")):
        text = ldt(0, AROUND, GAMMA, values).replace(".", point)
        lines = text.splitlines()
        lines[28] = f"3{mark}000"
        table = read("\r\n".join(lines), "lamp.ldt")
        assert np.allclose(table.candela[:-1], 3 * values, rtol=1e-6)


def test_exponents_of_fortran_are_read() -> None:
    assert read(good().replace("100 50 0", "1.0D+02 5D1 0")).candela.max() == 100


@pytest.mark.parametrize("per_line", [1, 3, 1000])
@pytest.mark.parametrize("tilt", ["TILT=NONE", "TILT=INCLUDE\n1\n2\n0 90\n1 0.9"])
def test_lines_may_end_anywhere(per_line: int, tilt: str) -> None:
    values = candela(FULL, GAMMA)
    head, _, numbers = ies(FULL, GAMMA, values, tilt=tilt).partition(tilt)
    words = numbers.split()
    lines = [" ".join(words[k : k + per_line]) for k in range(0, len(words), per_line)]

    assert np.allclose(read(head + tilt + "\n" + "\n".join(lines)).candela, values)


def test_planes_between_which_c0_is_are_read() -> None:
    c = np.arange(7.5, 360, 15)

    table = read(ies(c, GAMMA, candela(c, GAMMA)))

    assert table.c[0] == 0 and table.c[-1] == 360
    assert np.allclose(table.at(direction(c[:, None], GAMMA)), candela(c, GAMMA))
    assert np.allclose(table.candela[0], candela(c, GAMMA)[[0, -1]].mean(axis=0))


@pytest.mark.parametrize("symmetry", [1, 2, 3, 4])
def test_ldt_files_may_list_the_stored_planes_alone(symmetry: int) -> None:
    stored = {1: AROUND[:1], 2: AROUND[:13], 3: np.roll(AROUND, 6)[:13], 4: AROUND[:7]}[symmetry]
    values = candela(stored, GAMMA)
    text = ldt(symmetry, AROUND, GAMMA, values)
    lines = text.splitlines()
    listed = lines[:42] + [f"{c:g}" for c in stored] + lines[42 + len(AROUND) :]

    assert np.allclose(read("\n".join(listed), "a.ldt").candela, read(text, "a.ldt").candela)


@pytest.mark.parametrize("blank", [range(32, 42), [35], [32, 41]])
def test_ldt_files_may_leave_ratios_empty(blank: range) -> None:
    text = ldt(0, AROUND, GAMMA, candela(AROUND, GAMMA))
    lines = text.splitlines()
    for k in blank:
        lines[k] = ""

    assert np.allclose(read("\n".join(lines), "a.ldt").candela, read(text, "a.ldt").candela)


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
        said = np.interp(peak[0] + aside, h, values[:, v == peak[1]].ravel())
        assert table.at(there) == pytest.approx(1000 * said, rel=0.01)


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


def test_angles_of_types_a_and_b_that_are_impossible_are_refused() -> None:
    with pytest.raises(Refused, match="angles V go from -100° to 100°"):
        read(ies([-10, 10], [-100, 100], np.ones((2, 2)), kind=3))
    with pytest.raises(Refused, match="a single angle H"):
        read(ies([0], [-10, 10], np.ones((1, 2)), kind=2))
