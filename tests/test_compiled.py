"""Compiled code is kept, and nothing about keeping it can make a call fail."""

import ast
import builtins
import importlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import workbench
from workbench import compiled

ROOT = Path(workbench.__file__).parent


def doubled(x):
    return 2 * x


def compile_and_call():
    """As in a new process: whether code was loaded from disk, and what it returns."""
    compiled._folder.cache_clear()
    kernel = compiled.jit()(doubled)
    found = kernel(21)
    return bool(kernel.stats.cache_hits), found


def umask():
    mask = os.umask(0)
    os.umask(mask)
    return mask


@pytest.fixture
def places(tmp_path, monkeypatch):
    """Two folders in place of those of the program; none of them is there yet."""
    two = [tmp_path / "first" / "kernels-1", tmp_path / "second" / "kernels-1"]
    monkeypatch.setattr(compiled, "folders", lambda: iter(two))
    monkeypatch.setattr(compiled, "_failures", [])
    yield two
    compiled._folder.cache_clear()


def files_in(folder):
    return sorted(file for file in folder.rglob("*.nb?"))


def test_code_is_compiled_once_and_loaded_from_disk_later(places):
    assert compile_and_call() == (False, 42)
    assert compile_and_call() == (True, 42)
    files = files_in(places[0])
    assert [file.suffix for file in files] == [".nbc", ".nbi"]
    for file in files:
        assert file.stat().st_mode & 0o044 == 0o044 & ~umask()  # set-up's is for all users
    assert not compiled.unkept()


_PROGRAM = """
import sys
import numpy as np
from workbench.compiled import jit

@jit()
def squares(values):
    return (values * values).sum()

def twice(kernel):
    @jit(name="twice")
    def called(values):
        return 2 * kernel(values)
    return called

for kind in sys.argv[1:]:
    kernel = twice(squares)
    print(kernel(np.array([3, 4], kind)), bool(kernel.stats.cache_hits))
"""


@pytest.fixture
def start(tmp_path):
    """Starts a program that compiles, or loads, for types of numbers."""
    program = tmp_path / "program.py"
    program.write_text(_PROGRAM)
    environment = os.environ | {
        "NUMBA_CACHE_DIR": str(tmp_path / "kept"),
        "PYTHONPATH": str(ROOT.parent),
    }

    def start(*kinds):
        command = [sys.executable, program, *kinds]
        return subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True)

    return start


def printed(process):
    with process:
        return process.stdout.read().splitlines()


def test_processes_that_compile_at_once_do_not_mix_their_code_up(start):
    """What one process compiled another one loads, also of functions made by functions."""
    kinds = {"float64": "50.0", "int64": "50"}
    processes = [start(kind) for kind in kinds]
    assert [printed(process) for process in processes] == [[f"{n} False"] for n in kinds.values()]
    assert printed(start(*kinds)) == [f"{number} True" for number in kinds.values()]


def test_a_temporary_folder_is_not_trusted_if_others_can_write_to_it(tmp_path, monkeypatch):
    monkeypatch.setattr(compiled.tempfile, "gettempdir", lambda: str(tmp_path))
    folder = compiled._private_folder()
    assert folder.parent == tmp_path
    folder.mkdir(0o755)
    assert compiled._private_folder() == folder
    folder.chmod(0o777)
    assert compiled._private_folder() is None
    folder.rmdir()
    folder.symlink_to(tmp_path)
    assert compiled._private_folder() is None


def test_folders_are_named_after_the_text_of_all_compiled_files(tmp_path):
    """In a copy, an edit of any file that compiles changes the name in every place."""
    shutil.copytree(ROOT, tmp_path / "workbench", ignore=shutil.ignore_patterns("__pycache__"))

    def names():
        code = "from workbench import compiled; print(*{f.name for f in compiled.folders()})"
        command = [sys.executable, "-P", "-c", code]
        environment = os.environ | {"PYTHONPATH": str(tmp_path)}
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        return done.stdout.split()

    (before,) = names()
    compiled_modules = [file.relative_to(ROOT) for file in compiled.compiled_files()]
    folders = {str(kernels.parent) for kernels in compiled_modules}
    assert {"analysis/tracing", "design/transport", "optics/kernels"} <= folders
    for kernels in (compiled_modules[0], compiled_modules[-1]):
        with open(tmp_path / "workbench" / kernels, "a") as file:
            file.write("# another version\n")
        (after,) = names()
        assert after != before
        before = after


def test_all_that_compiled_functions_use_is_in_files_that_name_the_folder():
    """A constant of any other file could change without the kernels being compiled again."""
    files = [file.relative_to(ROOT.parent).with_suffix("") for file in compiled.compiled_files()]
    compiled_modules = {".".join(file.parts) for file in files}
    functions = 0
    for name in sorted(compiled_modules - {"workbench.compiled"}):
        module = importlib.import_module(name)
        imported = {
            alias.asname or alias.name: node.module
            for node in ast.walk(ast.parse(Path(module.__file__).read_text()))
            if isinstance(node, ast.ImportFrom)
            for alias in node.names
        }
        for kernel in vars(module).values():
            if not hasattr(kernel, "py_func") or kernel.py_func.__module__ != name:
                continue
            functions += 1
            used = set(kernel.py_func.__code__.co_names) - set(vars(builtins))
            elsewhere = {imported[each] for each in used if each in imported}
            foreign = {
                each for each in elsewhere if each.startswith("workbench")
            } - compiled_modules
            assert not foreign, f"{name}.{kernel.py_func.__name__} uses names of {foreign}"
    assert functions > 50
