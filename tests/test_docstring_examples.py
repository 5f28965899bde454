"""The examples in docstrings run, and print what they say."""

import doctest
import inspect
from importlib import import_module
from pathlib import Path

import pytest

import workbench
from workbench import api

ROOT = Path(workbench.__file__).parents[1]
MODULES = sorted(
    ".".join(file.relative_to(ROOT).with_suffix("").parts)
    for file in (ROOT / "workbench").rglob("*.py")
    if "\n    >>> " in file.read_text() or "\n>>> " in file.read_text()
)


@pytest.mark.usefixtures("fewer_rays", "few_plans")
@pytest.mark.parametrize("name", MODULES)
def test_examples_print_what_they_say(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found = doctest.testmod(import_module(name), optionflags=doctest.NORMALIZE_WHITESPACE)
    assert found.attempted > 0
    assert found.failed == 0  # what was expected is printed


def test_what_can_be_called_has_an_example():
    for name in api.__all__:
        part = getattr(api, name)
        if inspect.isfunction(part) or name in ("DesignRun", "Scene", "Session"):
            assert "\n    >>> " in part.__doc__, name
