"""What a wheel brings along, looked at from outside the checkout."""

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

pytestmark = pytest.mark.full

ROOT = Path(__file__).resolve().parent.parent
PACKAGES = ("workbench", "ui", "resources")


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """The project's wheel, built from a copy: setuptools leaves its traces beside the sources."""
    folder = tmp_path_factory.mktemp("wheel")
    source = folder / "source"
    for package in PACKAGES:
        shutil.copytree(
            ROOT / package, source / package, ignore=shutil.ignore_patterns("__pycache__")
        )
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, source)
    pip = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation"]
    done = subprocess.run(
        [*pip, "--wheel-dir", folder, source], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    (built,) = folder.glob("*.whl")
    return built


def resource_files():
    """All that the program reads; the README's pictures stay behind."""
    return {
        path.relative_to(ROOT).as_posix()
        for ending in ("json", "md", "png", "qm", "svg")
        for path in (ROOT / "resources").rglob(f"*.{ending}")
        if path.parent.name != "readme"
    }


def test_the_wheel_holds_every_module_and_every_resource(wheel):
    held = set(zipfile.ZipFile(wheel).namelist())
    modules = {
        path.relative_to(ROOT).as_posix()
        for package in PACKAGES
        for path in (ROOT / package).rglob("*.py")
    }
    known = ("examples/tophat.json", "scene.schema.json", "manual/index.md")
    assert {f"resources/{name}" for name in known} <= resource_files()
    assert modules | resource_files() <= held
    assert not any("readme" in name for name in held)


def test_an_installed_wheel_finds_its_resources(wheel, tmp_path):
    zipfile.ZipFile(wheel).extractall(tmp_path)
    script = (
        "import resources, workbench.files.scene, workbench.targets\n"
        "example = resources.path('examples', 'tophat.json')\n"
        "scene = workbench.files.scene.read_scene(example)\n"
        "target = workbench.targets.load_target(scene, example.parent)\n"
        "print(example, target.max() > 0)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == [str(tmp_path / "resources/examples/tophat.json"), "True"]
