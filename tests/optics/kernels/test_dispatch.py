"""Which tracer a plan takes, and that it makes no difference but speed."""

import threading
import time
from functools import partial

import numpy as np
import pytest
import torch

from workbench import compiled
from workbench.optics import plan as plans
from workbench.optics import ready
from workbench.optics.plan import Plan
from workbench.optics.samples import Corners
from workbench.optics.surfaces import BSplineSurface
from workbench.progress import Interrupted, given_up_when


def lens(scene, seed=3):
    noise = np.random.default_rng(seed).normal(size=scene.optic.net_shape)
    return torch.tensor(scene.optic.base.height + 0.01 * noise)


@pytest.fixture
def nothing_compiled(monkeypatch):
    """As in a new process, but for what numba has in memory."""
    monkeypatch.setattr(ready, "_compilations", {})


def test_a_plan_takes_the_kernel_and_gives_what_the_reference_gives(make_scene):
    scene = make_scene({"lens.base.height": 0.6})
    traced = [
        Plan(scene, dtype=torch.float64, fused=fused).trace({"lens.back": lens(scene)})
        for fused in (1, 0)
    ]
    assert torch.allclose(traced[0].flux, traced[1].flux, rtol=0, atol=1e-13)
    mine, theirs = (t.account.to_data() for t in traced)
    assert mine == pytest.approx(theirs, abs=1e-13)
    assert Plan(scene).notes[0].startswith("fused kernels")
    assert Plan(scene, fused=False).notes[0].startswith("reference in torch on cpu, float32")


def test_a_preview_does_not_wait_for_a_kernel(make_scene, nothing_compiled):
    scene = make_scene()
    plan = Plan(scene)
    with ready.without_waiting():
        assert plan.notes[0].startswith("reference")
        early = plan.trace({"lens.back": lens(scene)}).flux
    assert not ready.is_compiled()
    assert plan.notes[0].startswith("fused")
    assert torch.allclose(plan.trace({"lens.back": lens(scene)}).flux, early, atol=1e-6)
    with ready.without_waiting():
        assert plan.notes[0].startswith("fused")


def compiles_once_let(monkeypatch, name):
    """A kernel that is compiled while the first event is set and until the second one is."""
    began, goes_on = threading.Event(), threading.Event()

    def compile_for(dtype):
        began.set()
        assert goes_on.wait(60)

    monkeypatch.setitem(ready._COMPILERS, name, compile_for)
    return began, goes_on


def test_a_trace_waits_for_a_kernel_that_another_thread_compiles(
    make_scene, monkeypatch, nothing_compiled
):
    began, goes_on = compiles_once_let(monkeypatch, "other")
    plan, notes = Plan(make_scene()), []
    other = threading.Thread(target=ready.obtain, args=("other", torch.float32))
    thread = threading.Thread(target=lambda: notes.extend(plan.notes))
    other.start()
    assert began.wait(60)
    thread.start()
    thread.join(0.2)
    assert thread.is_alive()
    goes_on.set()
    thread.join()
    other.join()
    assert notes[0].startswith("fused kernels")


def test_work_that_is_given_up_does_not_wait_for_its_kernel(monkeypatch, nothing_compiled):
    _, goes_on = compiles_once_let(monkeypatch, "train")
    with given_up_when(lambda: True), pytest.raises(Interrupted):
        ready.obtain("train", torch.float32)
    goes_on.set()
    assert ready.obtain("train", torch.float32)
    assert ready.failure("train", torch.float32) is None


def test_a_kernel_that_is_needed_is_compiled_before_the_rest(monkeypatch, nothing_compiled):
    order = []
    kernels = {name: partial(lambda name, _: order.append(name), name) for name in "abc"}
    monkeypatch.setattr(ready, "_COMPILERS", kernels)
    began, goes_on = compiles_once_let(monkeypatch, "a")
    threads = [threading.Thread(target=ready.compile_all)]
    threads[0].start()
    assert began.wait(60)
    threads.append(threading.Thread(target=ready.obtain, args=("c", torch.float32)))
    threads[1].start()
    while ("c", torch.float32) not in ready._compilations:
        time.sleep(0.001)
    goes_on.set()
    for thread in threads:
        thread.join()
    assert order == ["c", "b"]


def test_a_program_alone_compiles_what_it_needs_at_once(make_scene, nothing_compiled):
    plan = Plan(make_scene(), dtype=torch.float64)
    assert plan.notes[0].startswith("fused kernels")
    assert plan.notes[0].endswith("float64")
    with ready.without_waiting():
        assert ready.obtain("train", torch.float64)


def test_compiling_ahead_can_be_interrupted(nothing_compiled):
    def compiled_so_far():
        with ready.without_waiting():
            return [name for name in ready._COMPILERS if ready.obtain(name, torch.float32)]

    ready.compile_all(lambda: False)
    assert compiled_so_far() == []
    answers = iter([True, False])
    ready.compile_all(lambda: next(answers))
    assert compiled_so_far() == ["train"]
    assert not ready.is_compiled()


@pytest.mark.parametrize("kernel", list(ready._COMPILERS))
def test_a_kernel_is_compiled_for_work_without_gradients(kernel, nothing_compiled):
    with torch.no_grad():
        assert ready.obtain(kernel, torch.float32)
    assert ready.failure(kernel, torch.float32) is None


def test_a_kernel_that_cannot_be_compiled_is_tried_once_and_the_run_says_so(
    make_scene, monkeypatch, nothing_compiled
):
    tried = []

    def fail(dtype):
        tried.append(dtype)
        raise ValueError("no such register")

    monkeypatch.setitem(ready._COMPILERS, "train", fail)
    with pytest.raises(ValueError, match="no such register"):
        ready.compile_all()
    assert all(ready.obtain(name, torch.float32) for name in ("beams", "boxes"))
    assert not ready.obtain("train", torch.float32)
    assert ready.is_compiled()  # nothing to wait for
    scene = make_scene()
    plan = Plan(scene)
    stated = "the kernel could not be compiled (ValueError: no such register)"
    assert plan.notes[0].startswith("reference in torch")
    assert any(note.startswith(stated) for note in plan.notes)
    reference = Plan(scene, fused=False)
    assert torch.equal(
        plan.trace({"lens.back": lens(scene)}).flux,
        reference.trace({"lens.back": lens(scene)}).flux,
    )
    assert not any("could not" in note for note in reference.notes)
    assert tried == [torch.float32]


def test_a_run_says_that_kernels_cannot_be_kept(make_scene, monkeypatch):
    assert not any("could not be kept" in note for note in Plan(make_scene()).notes)
    monkeypatch.setattr(compiled, "_folder", lambda: None)
    monkeypatch.setattr(compiled, "_failures", ["/disk: No space left on device"])
    stated = "compiled kernels could not be kept (/disk: No space left on device)"
    assert any(note.startswith(stated) for note in Plan(make_scene()).notes)


@pytest.mark.parametrize("source", [{}, {"source": {"kind": "point", "position": [0, 0, -4]}}])
@pytest.mark.parametrize("samples", [None, Corners(32, 32)])
def test_a_run_on_kernels_never_makes_the_reference(make_scene, monkeypatch, source, samples):
    def refuse(*_):
        raise AssertionError("the reference was made")

    scene = make_scene(source)
    plan = Plan(scene, samples=samples)
    monkeypatch.setattr(plans, "Reference", refuse)
    monkeypatch.setattr(BSplineSurface, "meet", refuse)
    assert plan.trace({"lens.back": lens(scene)}).account.on_screen > 0
    plan.next_iteration()
    with pytest.raises(AssertionError, match="was made"), ready.held_back():
        plan.trace({"lens.back": lens(scene)})


def test_kernels_are_used_again_after_they_were_held_back(make_scene):
    plan = Plan(make_scene())
    with ready.held_back():
        assert not any("fused" in note for note in plan.notes)
    assert any("fused" in note for note in plan.notes)


def test_samples_take_the_place_of_the_sources_rays(make_scene):
    few, many = make_scene({"source.rays": [20, 30]}), make_scene({"source.rays": [70, 80]})
    for fused in (True, False):
        plan = Plan(few, samples=(70, 80), dtype=torch.float64, fused=fused)
        flux = plan.trace({"lens.back": lens(few)}).flux
        assert torch.equal(
            flux, Plan(many, dtype=torch.float64, fused=fused).trace({"lens.back": lens(few)}).flux
        )


def test_a_mirrored_plan_says_so_and_gives_the_same(make_scene):
    scene = make_scene()
    heights = lens(scene)
    heights = (heights + heights.flip(0)) / 2
    half = Plan(scene, mirrored=(True, False), dtype=torch.float64)
    whole = Plan(scene, dtype=torch.float64)
    assert torch.allclose(
        half.trace({"lens.back": heights}).flux,
        whole.trace({"lens.back": heights}).flux,
        atol=1e-14,
    )
    assert "mirror symmetry: half of the rays" in half.notes
    heights = (heights + heights.flip(1)) / 2
    quarter = Plan(scene, mirrored=(True, True), dtype=torch.float64)
    assert torch.allclose(
        quarter.trace({"lens.back": heights}).flux,
        whole.trace({"lens.back": heights}).flux,
        atol=1e-14,
    )
    assert "mirror symmetry: a quarter of the rays" in quarter.notes
    assert not any("mirror" in note for note in whole.notes)


def test_notes_name_what_is_left_out(make_scene):
    notes = Plan(make_scene({"filter": {"kind": "box"}})).notes
    assert "collimated light: entrance refraction and intersection left out" in notes
    assert "box filter: one pixel a ray, no ghost pixels" in notes
    assert not any("box" in note for note in Plan(make_scene()).notes)
