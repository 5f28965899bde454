"""Targets drawn from SVG files."""

import gzip

import numpy as np
import pytest

from workbench.errors import Refused
from workbench.targets import load_target
from workbench.targets.image import read_picture


def read_image(path, *options, **tone):
    return read_picture(path, *options, **tone).light


SVG = '<svg xmlns="http://www.w3.org/2000/svg" {}>{}</svg>'
DISC = '<circle cx="5" cy="5" r="4" {}/>'


@pytest.fixture
def save(tmp_path):
    def save(inside, outline='viewBox="0 0 10 10"', name="a.svg", begin=""):
        path = tmp_path / name
        path.write_text(begin + SVG.format(outline, inside), encoding="utf-8")
        return path

    return save


@pytest.mark.parametrize("colour", ["", 'fill="white"', 'fill="#102030"'])
def test_a_drawing_of_one_colour_is_light_on_black(save, make_scene, colour):
    path = save(DISC.format(colour))
    target = {"image": str(path)}
    light = load_target(make_scene({"target": target, "screen.pixels": [40, 40]}), path.parent)
    assert light.sum() / 40**2 == pytest.approx(np.pi * 0.4**2, rel=2e-3)
    assert light[20, 20] == pytest.approx(1) and light[1, 1] == 0
    inverted = {**target, "invert": True}
    rest = load_target(make_scene({"target": inverted, "screen.pixels": [40, 40]}), path.parent)
    np.testing.assert_allclose(light + rest, 1, atol=1e-12)


@pytest.mark.parametrize("begin", ["\ufeff", '<?xml version="1.0"?>\n', "<!-- drawn -->\n"])
@pytest.mark.parametrize("name", ["a.svg", "a.png"])
def test_svg_is_recognised_by_its_content(save, begin, name):
    read = read_image(save(DISC.format(""), name=name, begin=begin), 64)
    assert read.shape == (64, 64) and read[32, 32] == 1


@pytest.mark.parametrize(
    ("outline", "shape"),
    [
        ('width="30mm" height="20mm"', (600, 900)),
        ('width="3.4" height="2.6"', (688, 900)),
        ('viewBox="0 0 3.4 2.6"', (688, 900)),
        ('width="100%" height="100%" viewBox="1,2 1e-3 2e-3"', (900, 450)),
        ('width="2in" height="144pt"', (900, 900)),
        ("", (900, 900)),  # that of the drawing itself
    ],
)
def test_all_of_the_drawing_is_seen_in_its_own_aspect(save, outline, shape):
    box = outline.partition("viewBox=")[2].strip('"').replace(",", " ").split()
    x, y = box[:2] or ("0", "0")
    size = 'width="7" height="7"' if not outline else 'width="100%" height="100%"'
    read = read_image(save(f'<rect x="{x}" y="{y}" {size} fill="white"/>', outline), 900)
    assert read.shape == shape
    assert read.mean() > 0.998


BARE = f'<svg viewBox="0 0 10 10">{DISC.format("")}</svg>'
LINKED = '<svg viewBox="0 0 10 10"><circle id="c" cx="5" cy="5" r="4"/><use {}href="#c"/></svg>'
WRITTEN = {
    "UTF-16": ("a.svg", BARE.encode("utf-16")),
    "UTF-16 that is declared": (
        "a.svg",
        ('<?xml version="1.0" encoding="utf-16"?>' + BARE).encode("utf-16"),
    ),
    "UTF-16 without a mark": ("a.svg", BARE.encode("utf-16-be")),
    "a link within": ("a.svg", LINKED.format("").encode()),
    "a link within of old": ("a.svg", LINKED.format("xlink:").encode()),
    "packed": ("a.svgz", gzip.compress(BARE.encode())),
}


@pytest.mark.parametrize(("name", "content"), WRITTEN.values(), ids=WRITTEN.keys())
def test_drawings_as_programs_write_them_are_read(tmp_path, name, content):
    path = tmp_path / name
    path.write_bytes(content)
    light = read_image(path, 32)
    assert light[16, 16] == 1 and light[0, 0] == 0


def test_a_letter_that_no_font_has_is_named(save):
    with pytest.raises(Refused, match=r"U\+0378"):
        read_image(save('<text y="9">A\u0378</text>'), 32)


@pytest.mark.parametrize(
    "link", ["white.png", "../a b.jpg", "https://example.org/a.png", "b.svg#c"]
)
@pytest.mark.parametrize("element", ["image", "use"])
def test_a_picture_in_another_file_is_named_and_refused(save, element, link):
    path = save(DISC.format("") + f'<{element} href="{link}" width="10" height="10"/>')
    with pytest.raises(Refused, match="embed") as caught:
        read_image(path, 32)
    assert link in caught.value.reason and str(path) in caught.value.reason


@pytest.mark.parametrize(
    ("inside", "outline", "stated"),
    [
        ("", 'width="0"', "invalid size"),
        ("<g>", "", "cannot be drawn"),
        ("<g>" * 700 + "</g>" * 700, 'viewBox="0 0 1 1"', "nested too deeply"),
        ("", 'viewBox="0 0 x 1"', "cannot be drawn"),
    ],
)
def test_a_drawing_that_cannot_be_rendered_is_refused_without_a_crash(
    save, inside, outline, stated
):
    path = save(inside, outline)
    with pytest.raises(Refused) as caught:
        read_image(path)
    assert str(path) in caught.value.reason and stated in caught.value.reason
    assert "\n" not in caught.value.reason
