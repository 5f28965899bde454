import pytest


@pytest.fixture(autouse=True)
def few_places(monkeypatch):
    """Figures of manufacture by fewer parts of each span, which are found sooner."""
    monkeypatch.setattr("workbench.analysis.manufacture._PARTS", 48)
