"""Benches with a design on them."""

import pytest

from tests.ui.lens.bench import Bench, Drag


@pytest.fixture
def at_bench(display, make_session, qtbot):
    def at_bench(changes=None):
        bench = Bench(make_session(changes))
        qtbot.addWidget(bench.window, before_close_func=lambda _: bench.close())
        with qtbot.waitExposed(bench.window):
            bench.window.show()
        # Until the first preview is drawn there is nothing to take hold of.
        view = bench.view
        qtbot.waitUntil(lambda: view.frame is not None and view.optic is not None, timeout=60_000)
        qtbot.waitUntil(lambda: not view._outdated)
        return bench

    return at_bench


@pytest.fixture
def bench(at_bench):
    return at_bench()


@pytest.fixture
def sculpting(bench, qtbot):
    bench.commands["sculpt"]()
    qtbot.waitUntil(lambda: bench.view.nets.picture._shown)
    return bench


@pytest.fixture
def drag(qtbot):
    return lambda view, start: Drag(qtbot, view, start)
