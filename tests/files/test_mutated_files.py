"""A file with anything wrong in it is refused in a sentence, soon and without much memory."""

import resource
import time
from pathlib import Path

import pytest

from tests.files.mutations import mutated
from workbench.errors import Refused
from workbench.files.session import open_design, write_session

GOLDEN = sorted((Path(__file__).parent / "golden").glob("*.freeform"))
pytestmark = pytest.mark.filterwarnings("ignore:Duplicate name")

SECONDS = 2.0  # of the processor, which others do not lengthen
KIBIBYTES = 500_000
LONGEST_SENTENCE = 1000


def open_or_refuse(path):
    """Whether a file opens; if not, in a sentence that names it."""
    try:
        session = open_design(path)
    except Refused as refused:
        sentence = str(refused)
        assert sentence.startswith(str(path))
        assert "\n" not in sentence
        assert len(sentence) - len(str(path)) < LONGEST_SENTENCE
        return False
    again = path.with_suffix(".again")
    write_session(session, again)
    open_design(again)
    return True


def check(tmp_path, seeds):
    path = tmp_path / "mutated.freeform"
    whole = [file.read_bytes() for file in GOLDEN]
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    opened = 0
    for seed in seeds:
        path.write_bytes(mutated(whole[seed % len(whole)], seed))
        begin = time.process_time()
        try:
            opened += open_or_refuse(path)
        except Exception as error:
            raise AssertionError(f"seed {seed}: {error!r}") from error
        taken = time.process_time() - begin
        assert taken < SECONDS, f"seed {seed} takes {taken:.1f} s"
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    assert grown < KIBIBYTES, f"{grown} KiB more"
    # Some changes do no harm, most do: the generator does what it is for.
    assert 0.01 * len(seeds) < opened < 0.5 * len(seeds)


def test_some(tmp_path):
    check(tmp_path, range(300))


@pytest.mark.slow
@pytest.mark.timeout(3600)
def test_many(tmp_path):
    check(tmp_path, range(300, 10_300))
