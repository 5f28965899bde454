"""``freeform plan``."""

import json

import pytest

from workbench.files.session import read_session


@pytest.mark.full
def test_the_written_session_is_made_by_the_cheapest_plan(tmp_path, lens, freeform):
    output = tmp_path / "made.freeform"
    status, printed, _ = freeform("plan", lens, "--error", "90", "-o", output, "--json")
    assert status == 0
    cheapest = json.loads(printed)["plans"][0]
    made = read_session(output)
    assert [each.kind for each in made.scene.processes] == [
        each["kind"] for each in cheapest["processes"]
    ]
    status, printed, _ = freeform("validate", output, "--rays", "20000", "--json")
    steps = json.loads(printed)["as_made"]
    assert [step["process"] for step in steps][:2] == [None, "Milling"]
