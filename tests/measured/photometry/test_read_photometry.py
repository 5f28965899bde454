import io
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
        (good().replace(" 3 1 1 ", " 3 1 2 "), "photometric type B; type C is needed"),
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
