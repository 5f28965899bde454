"""Opening a damaged file leaves the open design as it is; opening a good one replaces it whole."""

import pytest

from tests.files.mutations import mutated
from tests.files.test_golden import GOLDEN
from tests.ui.hands import move_screen
from ui.document.document import Document
from workbench.errors import Refused
from workbench.files.session import read_session

pytestmark = pytest.mark.filterwarnings("ignore:Duplicate name")
WHOLE = [file.read_bytes() for file in sorted(GOLDEN.iterdir())]


@pytest.fixture
def document(qapp, tmp_path):
    document = Document(read_session(GOLDEN / "compared.freeform"), "open")
    document.save(tmp_path / "open.freeform")
    move_screen(document, 7)
    yield document
    document.deleteLater()


def state(document):
    stack = document.undo_stack
    return document.session, document.path, document.name, document.dirty, stack.count()


def check(document, folder, seeds):
    received, opened = [], 0
    document.session_changed.connect(received.append)
    document.path_changed.connect(lambda: received.append(document.path))
    document.dirty_changed.connect(received.append)
    path = folder / "mutated.freeform"
    for seed in seeds:
        path.write_bytes(mutated(WHOLE[seed % len(WHOLE)], seed))
        before = state(document)
        received.clear()
        try:
            document.open(path)
        except Refused:
            assert state(document) == before, f"seed {seed}"
            assert received == []
        else:
            opened += 1
            assert document.path == path
            assert not document.dirty
            assert document.undo_stack.count() == 0
            assert document.session in received
    assert 0 < opened < len(seeds)


def test_some(document, tmp_path):
    check(document, tmp_path, range(100))


@pytest.mark.slow
@pytest.mark.timeout(3600)
def test_many(document, tmp_path):
    check(document, tmp_path, range(20_000, 30_000))
