"""Compiled code is kept, and nothing about keeping it can make a call fail."""

import ast
import builtins
import importlib
import os
import resource
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from llvmlite.binding import Linkage

import workbench
from workbench import compiled

ROOT = Path(workbench.__file__).parent


def doubled(x):
    return 2 * x


@compiled.jit()
def fibonacci(n):  # calls itself, so it is never merged into what calls it
    return n if n < 2 else fibonacci(n - 1) + fibonacci(n - 2)


def compile_and_call():
    """As in a new process: whether code was taken from disk, and what it gives."""
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
    return two


def test_code_is_compiled_once_and_taken_from_disk_later(places):
    assert compile_and_call() == (False, 42)
    assert compile_and_call() == (True, 42)
    (file,) = places[0].iterdir()
    assert file.stat().st_mode & 0o044 == 0o044 & ~umask()  # set-up's is for all users
    assert not compiled.unkept()


_PROGRAM = """
import sys
import numpy as np
from workbench.compiled import jit

@jit()
def squares(count):
    if count < 0:
        raise ValueError("fewer than none")
    found = np.zeros(count)
    for k in range(count):
        found[k] = k * k
    return found

@jit()
def norm(values):
    return np.sqrt((values * values).sum())

def found():
    values = squares(4).tolist()
    try:
        squares(-1)
    except ValueError as error:
        return values, str(error)

print(found(), bool(squares.stats.cache_hits), "numba.np.arrayobj" in sys.modules)
if len(sys.argv) > 1:
    print(norm(np.array([3.0, 4.0])), bool(norm.stats.cache_hits))
"""


def test_code_from_disk_runs_without_the_compilers_modules_and_beside_new_code(tmp_path):
    program, kept = tmp_path / "program.py", tmp_path / "kept"
    program.write_text(_PROGRAM)

    def printed(*arguments):
        return subprocess.run(
            [sys.executable, program, *arguments],
            env={**os.environ, "NUMBA_CACHE_DIR": str(kept), "PYTHONPATH": str(ROOT.parent)},
            check=True,
            capture_output=True,
            text=True,
        ).stdout.splitlines()

    same = "([0.0, 1.0, 4.0, 9.0], 'fewer than none')"
    assert printed() == [f"{same} False True"]
    assert printed("both") == [f"{same} True False", "5.0 False"]
    assert printed("both") == [f"{same} True False", "5.0 True"]


def test_compiling_is_logged_once_and_loading_from_disk_is_not(places, caplog):
    caplog.set_level("INFO", logger="workbench")
    compiled._tell.cache_clear()
    for _ in range(2):
        assert compile_and_call()[1] == 42
        assert [record.message for record in caplog.records] == [
            "compiling, once after installing; this takes up to a minute"
        ]
    compiled._tell.cache_clear()
    assert compile_and_call() == (True, 42)
    assert len(caplog.records) == 1


def test_a_kernel_has_copies_of_its_own_of_what_it_calls(places):
    """Copies that others may replace by theirs would make results depend on what is loaded."""

    def total(n):
        return fibonacci(n) + fibonacci(n + 1)

    outer = compiled.jit()(total)
    assert outer(10) == 55 + 89
    (result,) = outer.overloads.values()
    shared = [
        function.name
        for function in result.library._final_module.functions
        if function.linkage == Linkage.linkonce_odr
    ]
    assert not [name for name in shared if not name.startswith("NRT_")]


def empty(file):
    file.write_bytes(b"")


def cut(file):
    file.write_bytes(file.read_bytes()[:-100])


def flip(file):
    data = bytearray(file.read_bytes())
    data[len(data) // 2] ^= 1
    file.write_bytes(data)


def replace_by_text(file):
    file.write_text("This is no code.")


@pytest.mark.parametrize("damage", [empty, cut, flip, replace_by_text])
def test_a_damaged_file_is_compiled_again_and_replaced(places, damage):
    compile_and_call()
    (file,) = places[0].iterdir()
    damage(file)
    assert compile_and_call() == (False, 42)
    assert compile_and_call() == (True, 42)


def test_a_folder_in_place_of_the_file_is_passed_over(places):
    compile_and_call()
    (file,) = places[0].iterdir()
    file.unlink()
    file.mkdir()
    assert compile_and_call() == (False, 42)
    assert compile_and_call() == (True, 42)
    assert [each.name for each in places[1].iterdir()] == [file.name]


def test_the_next_folder_is_taken_where_the_first_cannot_be_written_to(places):
    places[0].parent.write_text("a file where a folder should be")
    assert compile_and_call() == (False, 42)
    assert compile_and_call() == (True, 42)
    assert len(list(places[1].iterdir())) == 1
    assert not compiled.unkept()


def test_kernels_run_where_no_folder_can_be_written_to(places):
    for place in places:
        place.parent.write_text("a file where a folder should be")
    assert compile_and_call() == (False, 42)
    assert compile_and_call() == (False, 42)
    assert "Not a directory" in compiled.unkept()


def test_kernels_run_on_a_full_disk(places):
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, hard))  # bytes that a file may get
    try:
        found = compile_and_call()
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert found == (False, 42)
    assert "File too large" in compiled.unkept()
    assert not any(any(place.iterdir()) for place in places)  # nothing half written is left
    assert compile_and_call() == (False, 42)
    assert compile_and_call() == (True, 42)


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


@pytest.mark.skipif(os.getuid() != 0, reason="only root can give a folder to another user")
def test_a_temporary_folder_of_another_user_is_not_trusted(tmp_path, monkeypatch):
    monkeypatch.setattr(compiled.tempfile, "gettempdir", lambda: str(tmp_path))
    folder = compiled._private_folder()
    folder.mkdir(0o755)
    os.chown(folder, 12345, -1)
    assert compiled._private_folder() is None


def test_folders_are_named_after_the_text_of_all_compiled_files(tmp_path):
    """In a copy, an edit of any room that compiles changes the name in every place."""
    shutil.copytree(ROOT, tmp_path / "workbench", ignore=shutil.ignore_patterns("__pycache__"))

    def names():
        code = "from workbench import compiled; print(*{f.name for f in compiled.folders()})"
        command = [sys.executable, "-P", "-c", code]
        environment = os.environ | {"PYTHONPATH": str(tmp_path)}
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        return done.stdout.split()

    (before,) = names()
    rooms = [file.relative_to(ROOT) for file in compiled.rooms()]
    folders = {str(room.parent) for room in rooms}
    assert {"analysis/tracing/sources", "design/transport", "optics/kernels"} <= folders
    for room in (rooms[0], rooms[-1]):
        with open(tmp_path / "workbench" / room, "a") as file:
            file.write("# another version\n")
        (after,) = names()
        assert after != before
        before = after


def test_all_that_compiled_functions_use_is_in_files_that_name_the_folder():
    """A constant of any other file could change without the kernels being compiled again."""
    files = [file.relative_to(ROOT.parent).with_suffix("") for file in compiled.rooms()]
    rooms = {".".join(file.parts) for file in files}
    functions = 0
    for name in sorted(rooms - {"workbench.compiled"}):
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
            foreign = {each for each in elsewhere if each.startswith("workbench")} - rooms
            assert not foreign, f"{name}.{kernel.py_func.__name__} uses names of {foreign}"
    assert functions > 50


def test_nothing_compiles_with_numba_but_by_the_common_decorator():
    files = [file for file in ROOT.rglob("*.py") if "njit" in file.read_text()]
    assert [file.name for file in files] == ["compiled.py"]
