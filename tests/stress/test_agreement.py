"""Random tasks of all kinds: a run, cells and random rays say the same of each.

``pytest -m slow tests/stress/test_agreement.py -n 2`` traces 400 tasks in 40 parts. With
``--last-failed`` the parts that failed are traced again, ``-k part_7`` takes one part, and
FREEFORM_STRESS_SEED draws other tasks.
"""

import os

import pytest

from tests.stress.agreement import disagreements

SEED = int(os.environ.get("FREEFORM_STRESS_SEED", "1"))
PARTS, EACH = 40, 10
# Some that are traced fast; together of all kinds of sources, optics and receivers.
FEW = (3, 4, 18, 43, 44, 45, 48, 57)


@pytest.mark.parametrize("number", FEW)
def test_some_tasks(number):
    traced, said = disagreements(1, number)
    assert traced
    assert not said, "\n".join(said)


@pytest.mark.slow
@pytest.mark.timeout(3600)
@pytest.mark.parametrize("part", range(PARTS), ids=lambda part: f"part_{part}")
def test_many_tasks(part):
    found = [disagreements(SEED, EACH * part + number) for number in range(EACH)]
    assert any(traced for traced, _ in found)  # most tasks are no refusals
    said = [each for _, some in found for each in some]
    assert not said, "\n".join(said)
