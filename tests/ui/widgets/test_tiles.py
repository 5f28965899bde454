"""Tiles are as high as their longest sentence."""

import pytest

from ui.widgets.tiles import Shape, Tile, Tiles

SENTENCE = "An LED and its lens make a round beam of given angles, as of a torch."


@pytest.fixture
def tiles(qtbot):
    made = Tiles("jobs", Shape(200, 0.5))
    qtbot.addWidget(made)
    made.show()
    return made


def texts(tiles):
    """Rows of pixels of the first tile below its picture, as sets of colours."""
    size, image = tiles.gridSize(), tiles.grab().toImage()
    wide = size.width() - 20  # without the rounded corners
    first = round(0.5 * wide) + 10
    return [{image.pixel(x, y) for x in range(10, wide)} for y in range(first, size.height() - 10)]


@pytest.mark.parametrize("times", [1, 3, 6])
def test_no_sentence_is_cut(tiles, times):
    tiles.resize(640, 600)
    tiles.put([Tile("Beam", " ".join(times * [SENTENCE])), Tile("Empty", "A square lens.")])
    rows = texts(tiles)
    written = [number for number, colours in enumerate(rows) if len(colours) > 2]
    assert written
    assert written[-1] < len(rows) - 1  # there is space below the last line
    assert len(rows) - written[-1] < 20  # and no more than below any text


def test_a_wider_tile_needs_less_height(tiles):
    tiles.put([Tile("Beam", 3 * SENTENCE)])
    tiles.resize(210, 600)
    narrow = tiles.gridSize().height() - tiles.gridSize().width() / 2
    tiles.resize(390, 600)
    assert tiles.gridSize().height() - tiles.gridSize().width() / 2 < narrow
