"""The gallery of examples in the real window, by keyboard and mouse."""

import pytest
from PySide6.QtCore import Qt

from resources import EXAMPLES
from ui.dialogs.gallery import Gallery


@pytest.fixture
def gallery(window, qtbot):
    window.commands["gallery"].trigger()
    found = window.findChild(Gallery)
    with qtbot.waitExposed(found):
        pass
    return found


def test_every_example_has_a_picture_of_its_target(gallery):
    items = [gallery._list.item(row) for row in range(gallery._list.count())]
    assert [item.text() for item in items] == [example.title for example in EXAMPLES]
    assert len({item.text() for item in items}) == len(items)
    size = gallery._list.iconSize()
    for item in items:
        picture = item.icon().pixmap(size).toImage()
        grey = {
            picture.pixelColor(x, y).lightness()
            for x in range(0, picture.width(), 4)
            for y in range(0, picture.height(), 4)
        }
        assert min(grey) < 30 and max(grey) > 200, item.text()


def test_typing_a_name_and_enter_open_it(window, gallery, qtbot):
    qtbot.keyClicks(gallery._list, "lett")
    letter = next(example for example in EXAMPLES if example.name == "letter")
    assert (
        letter.look in gallery._description.text() and letter.group in gallery._description.text()
    )
    qtbot.keyClick(gallery, Qt.Key.Key_Return)
    assert window.document.name == "letter"
    qtbot.waitUntil(lambda: window.findChild(Gallery) is None)
