"""Targets drawn from SVG files."""

import gzip
from base64 import b64encode
from io import BytesIO

import numpy as np
import pytest
from PIL import Image

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


def test_svg_keeps_its_aspect_and_stands_upright(save):
    read = read_image(save('<path d="M0 0H40V5H0Z" fill="white"/>', 'viewBox="0 0 40 10"'), 400)
    assert read.shape == (100, 400)
    np.testing.assert_array_equal(read[:50], 1)
    np.testing.assert_array_equal(read[50:], 0)


def test_colours_and_grounds_are_those_of_the_drawing(save):
    ground = '<rect width="10" height="10" fill="white"/>'
    read = read_image(save(ground + DISC.format('fill="#333"')), 100)
    assert (read[0, 0], read[50, 50]) == (1, pytest.approx(0.2))


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


@pytest.mark.parametrize(
    "link", ["white.png", "../a b.jpg", "https://example.org/a.png", "b.svg#c"]
)
@pytest.mark.parametrize("element", ["image", "use"])
def test_a_picture_in_another_file_is_named_and_refused(save, element, link):
    path = save(DISC.format("") + f'<{element} href="{link}" width="10" height="10"/>')
    with pytest.raises(Refused, match="embed") as caught:
        read_image(path, 32)
    assert link in caught.value.reason and str(path) in caught.value.reason


def test_a_link_to_a_page_does_not_matter(save):
    inside = f'<a href="https://example.org">{DISC.format("")}</a>'
    assert read_image(save(inside), 32)[16, 16] == 1


def test_a_picture_within_the_drawing_is_drawn(save):
    buffer = BytesIO()
    Image.new("L", (4, 4), 255).save(buffer, "PNG")
    data = b64encode(buffer.getvalue()).decode()
    inside = f'<image href="data:image/png;base64,{data}" width="10" height="10"/>'
    assert read_image(save(inside), 32).min() == 1


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be", "utf-8-sig"])
@pytest.mark.parametrize("declared", [True, False])
def test_encodings_of_the_web_are_read(tmp_path, encoding, declared):
    path = tmp_path / "a.svg"
    begin = f'<?xml version="1.0" encoding="{encoding[:6].rstrip("-")}"?>' if declared else ""
    text = begin + SVG.format('viewBox="0 0 10 10"', DISC.format(""))
    path.write_bytes(text.encode(encoding))
    assert read_image(path, 32)[16, 16] == 1


@pytest.mark.parametrize("prefix", ["", "xlink:"])
def test_a_drawing_of_a_page_needs_no_namespace(tmp_path, prefix):
    path = tmp_path / "a.svg"
    used = f'<circle id="c" cx="5" cy="5" r="4"/><use {prefix}href="#c"/>'
    path.write_text(f'<svg viewBox="0 0 10 10">{used}</svg>')
    assert read_image(path, 32)[16, 16] == 1


def test_a_packed_drawing_is_read_up_to_a_size(save, tmp_path):
    path = tmp_path / "a.svgz"
    path.write_bytes(gzip.compress(save(DISC.format("")).read_bytes()))
    assert read_image(path, 32)[16, 16] == 1
    path.write_bytes(gzip.compress(b"<svg>" + bytes(20 << 20)))
    with pytest.raises(Refused, match="more than 16 MB"):
        read_image(path)
    path.write_bytes(gzip.compress(b"words"))
    with pytest.raises(Refused, match="not an image"):
        read_image(path)
    path.write_bytes(b"\x1f\x8bwords")
    with pytest.raises(Refused, match="damaged"):
        read_image(path)


def test_a_letter_that_no_font_has_is_named(save):
    path = save('<text y="9">A\u0378</text>')
    with pytest.raises(Refused, match=r"U\+0378"):
        read_image(path, 32)


@pytest.mark.parametrize(
    "family", ["DejaVu Serif", "no such font", "serif", "Arial, sans-serif", ""]
)
def test_text_is_drawn_whichever_fonts_there_are(save, family):
    font = f'font-family="{family}"' if family else ""
    lit = (
        read_image(save(f'<text x="1" y="9" font-size="9" fill="white" {font}>M</text>'), 64) > 0.5
    )
    assert lit[20:58, 8:].mean() > 0.2 and not lit[:8].any()


@pytest.mark.parametrize(
    ("inside", "outline", "said"),
    [
        ("", 'width="0"', "invalid size"),
        ("<g>", "", "cannot be drawn"),
        ("<g>" * 700 + "</g>" * 700, 'viewBox="0 0 1 1"', "nested too deeply"),
        ("", 'viewBox="0 0 x 1"', "cannot be drawn"),
    ],
)
def test_a_drawing_that_cannot_be_rendered_is_refused_without_a_crash(save, inside, outline, said):
    path = save(inside, outline)
    with pytest.raises(Refused) as caught:
        read_image(path)
    assert str(path) in caught.value.reason and said in caught.value.reason
    assert "\n" not in caught.value.reason


def test_an_empty_drawing_is_black_all_over(save, make_scene):
    path = save("")
    with pytest.raises(Refused, match="is black all over"):
        load_target(make_scene({"target": {"image": str(path)}}), path.parent)
