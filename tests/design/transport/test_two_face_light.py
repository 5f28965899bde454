import torch

from workbench.design.transport.two_face_light import _whence

_CELLS = 160
# Light of so much of each half, up to the middle of a cell, goes eight times as far as before.
_DARK, _STRETCH = 17 / _CELLS, 8.0
_BRIGHT = (1 - _DARK * _STRETCH) / (1 - _DARK)


def test_light_spread_over_many_times_its_area_is_found():
    even = (2 * torch.arange(_CELLS, dtype=torch.float64) + 1) / _CELLS - 1
    own = torch.stack(torch.meshgrid(even, even, indexing="ij"))
    rim = _DARK * _STRETCH
    size = own.abs()
    dark = size < _DARK
    places = own.sign() * torch.where(dark, _STRETCH * size, rim + _BRIGHT * (size - _DARK))
    dark = size < rim
    expected = own.sign() * torch.where(dark, size / _STRETCH, _DARK + (size - rim) / _BRIGHT)
    off = (_whence(places, own, own) - expected).abs().amax(0) * _CELLS / 2
    known = expected.abs().amax(0) < 1 - 1 / _CELLS  # beyond the last light the nearest counts
    assert off[known].mean() < 0.02
