"""Program that unpacks the OpenEXR file of its first argument into the file's folder.

It runs as its own process: the library prints errors to standard output, and damaged files may end
the process. The folder gets ``header.json``, and each channel as ``0.npy``, ``1.npy`` and so on,
unless the second argument is less than the number of pixels.
"""

import json
import sys
from pathlib import Path

import numpy as np

HEADER = "header.json"


def chosen(names: list[str]) -> list[str]:
    """Return the channels of a picture: R, G and B, Y, or the only one; empty if there is none."""
    layers = sorted((name[:-1] for name in names if name.endswith("R")), key=len)
    for group in ([f"{layer}{colour}" for colour in "RGB"] for layer in layers):
        if set(group) <= set(names):
            return group
    if "Y" in names:
        return ["Y"]
    return names if len(names) == 1 else []


def main(path: str, most: int) -> None:
    """Unpack the file."""
    import OpenEXR  # only here: the caller imports `chosen`

    folder = Path(path).parent
    with OpenEXR.File(path, separate_channels=True, header_only=True) as file:
        header = dict(file.header())  # the library empties its own when it closes the file
        names = [channel.name for channel in header["channels"]]
    windows = {
        name: np.asarray(header[name], dtype=int).tolist()
        for name in ("displayWindow", "dataWindow")
    }
    stated = header.get("chromaticities")
    (left, top), (right, bottom) = windows["dataWindow"]
    content = {
        "names": names,
        "deep": "deep" in str(header.get("type", "")),
        "aspect": float(header.get("pixelAspectRatio", 1.0)),
        "chromaticities": None if stated is None else np.asarray(stated, float).ravel().tolist(),
        **windows,
    }
    (folder / HEADER).write_text(json.dumps(content), "utf-8")
    if (right - left + 1) * (bottom - top + 1) > most or content["deep"]:
        return
    with OpenEXR.File(path, separate_channels=True) as file:
        channels = file.channels()
        for number, name in enumerate(chosen(names)):
            np.save(folder / f"{number}.npy", channels[name].pixels)


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
