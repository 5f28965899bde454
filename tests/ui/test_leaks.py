"""The check that guards all other tests finds each kind of thing left behind."""

import threading

from tests.ui.leftovers import left_behind, living

pytest_plugins = ["pytester"]


def test_finds_a_python_thread():
    before, release = living(), threading.Event()
    thread = threading.Thread(target=release.wait, name="forgotten")
    thread.start()
    assert left_behind(before) == ["thread forgotten"]
    release.set()
    thread.join()
    assert left_behind(before) == []


def test_fails_the_test_that_leaves_something(pytester):
    with open(__file__.replace("test_leaks.py", "conftest.py")) as source:
        pytester.makeconftest(source.read())
    pytester.makepyfile(
        """
        from PySide6.QtWidgets import QWidget
        kept = []
        def test_forgetful(qapp):
            kept.append(QWidget())
        def test_tidy(qapp):
            pass
        """
    )
    outcome = pytester.runpytest_inprocess("-p", "no:cacheprovider")
    outcome.assert_outcomes(passed=2, errors=1)
    outcome.stdout.fnmatch_lines(["*left behind: top-level widget*"])
