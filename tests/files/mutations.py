"""Session files with something wrong in them, drawn at random, the same for the same seed.

Bytes are changed as a bad disk or a broken transfer would change them; entries, arrays and fields
as another program would that does not keep to the format, or someone with bad intentions.
"""

import copy
import io
import json
import struct
import zipfile
from functools import cache
from random import Random
from typing import Any

import numpy as np

Entry = tuple[str, bytes]

_NAMES = ("../evil.npy", "/etc/passwd", "C:\\evil", "runs/", "", "x" * 5000, "tärget.npy", "a/b/c")
_FIELDS = (
    *(None, True, False, 0, -1, 1, 2, 3, 7, 1e-320, 1e308, -1e308, 0.5, 10**30, 2**63, -(2**63)),
    *(4096, 4097, 1_000_001, "", "x", "x" * 5000, "\x00", "nan", "../../x", "\u202e\n", [], {}),
    *([1], [1, 1], [0, 0], [4096, 4096], [1e308, 1e-308], [1, 2, 3], [[[[]]]], {"a": {"b": {}}}),
    *(float("nan"), float("inf"), list(range(3000)), {str(k): k for k in range(3000)}),
)
_UNKNOWN = ("new", "a\nb", "y" * 5000, "", "kind", "method", "version")
_HEADERS = (
    "{'descr': '<f8', 'fortran_order': False, 'shape': (1000000000000000000,), }",
    "{'descr': '<f8', 'fortran_order': False, 'shape': (-1, 8), }",
    "{'descr': '<f8', 'fortran_order': False, 'shape': (8.0, 8), }",
    "{'descr': '<f8', 'fortran_order': False, 'shape': (True, 8), }",
    "{'descr': '<f8', 'fortran_order': 1, 'shape': (8, 8), }",
    "{'descr': '|O', 'fortran_order': False, 'shape': (8, 8), }",
    "{'descr': [('a', '<f8'), ('b', '<f8')], 'fortran_order': False, 'shape': (8, 4), }",
    "{'descr': '<f8', 'fortran_order': False, 'shape': __import__('os').getcwd(), }",
    "{'descr': '<f8'}",
    "(" * 500,
    "{'descr': '<f8', 'fortran_order': False, 'shape': (8, 8)" + "," * 60_000,
    "-" * 900 + "1",
)


def mutated(content: bytes, seed: int) -> bytes:
    """The file with one to three things changed."""
    random = Random(seed)
    changes = [_bytes, _entries, _array, _array, _field, _field, _field]
    content = random.choice(changes)(content, random)
    for _ in range(random.choice([0, 0, 0, 1, 2])):
        try:
            content = random.choice(changes)(content, random)
        except Exception:  # no longer a zip that others can take apart, with whatever they raise
            content = _bytes(content, random)
    return content


def _bytes(content: bytes, random: Random) -> bytes:
    changed = bytearray(content)
    at = random.randrange(len(changed) + 1)
    end = min(len(changed), at + random.choice([1, 4, 30, 500]))
    match random.randrange(7):
        case 0:
            return content[:at]
        case 1:
            changed[at:end] = random.randbytes(end - at)
        case 2:
            changed[at:end] = bytes(end - at)
        case 3:
            del changed[at:end]
        case 4:
            changed[at:at] = content[at:end]
        case 5:
            changed += random.randbytes(40)
        case 6:
            for _ in range(random.choice([1, 3, 20])):
                if changed:
                    changed[random.randrange(len(changed))] ^= 1 << random.randrange(8)
    return bytes(changed)


def _entries(content: bytes, random: Random) -> bytes:
    entries = _unpacked(content)
    at = random.randrange(len(entries))
    name, body = entries[at]
    match random.randrange(9):
        case 0:
            entries.pop(at)
        case 1:
            entries.insert(at, (name, random.choice(entries)[1]))
        case 2:
            entries[at] = random.choice([*_NAMES, random.choice(entries)[0]]), body
        case 3:
            entries.append((random.choice(_NAMES), body))
        case 4:
            entries[at] = name, content  # a zip in the zip
        case 5:
            kind = random.choice([zipfile.ZIP_DEFLATED, zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
            return _packed(entries, {name: kind})
        case 6:
            return _packed([(n, _bomb() if n == name else b) for n, b in entries], {name: None})
        case 7:
            return _with_sizes(content, random)
        case 8:
            random.shuffle(entries)
            return _packed(entries, {}, comment=random.randbytes(random.choice([0, 1, 60_000])))
    return _packed(entries, {})


def _array(content: bytes, random: Random) -> bytes:
    entries = _unpacked(content)
    at = random.choice([k for k, (name, _) in enumerate(entries) if name.endswith(".npy")])
    name, body = entries[at]
    array = np.load(io.BytesIO(body), allow_pickle=False)
    file = io.BytesIO()
    match random.randrange(7):
        case 0:
            kind = random.choice(["<f4", ">f8", "<i8", "?", "<c16", "<U8", "O", "<f2", "<m8[s]"])
            np.save(file, array.astype(kind), allow_pickle=True)
        case 1:
            np.save(file, np.asfortranarray(array.reshape(array.shape or (1,))))
        case 2:
            shape = random.choice([array.shape[::-1], (-1,), (1, *array.shape), (*array.shape, 1)])
            np.save(file, array.reshape(shape))
        case 3:
            changed = array.copy()
            value = random.choice([np.nan, np.inf, -np.inf, 1e308, -1e308, 5e-324, -0.0, 0.0])
            changed.flat[random.randrange(max(1, changed.size)) if changed.size else 0 :] = value
            np.save(file, changed)
        case 4:
            np.save(file, array[: random.randrange(len(array) + 1)])
        case 5:
            text = random.choice(_HEADERS).encode()
            file.write(b"\x93NUMPY\x02\x00" + struct.pack("<I", len(text)) + text + body[-512:])
        case 6:
            file.write(_bytes(body, random))
    entries[at] = name, file.getvalue()
    return _packed(entries, {})


def _field(content: bytes, random: Random) -> bytes:
    entries = _unpacked(content)
    at = next(k for k, (name, _) in enumerate(entries) if name == "session.json")
    text = json.loads(entries[at][1])
    where = random.choice(_paths(text))
    parent = text
    for step in where[:-1]:
        parent = parent[step]
    value = copy.deepcopy(random.choice(_FIELDS))
    match random.randrange(8):
        case 0:
            del parent[where[-1]]
        case 1 if isinstance(parent, dict):
            parent[random.choice(_UNKNOWN)] = value
    return _packed(_replaced(entries, at, json.dumps(text).encode()), {})


def _replaced(entries: list[Entry], at: int, body: bytes) -> list[Entry]:
    return [(name, body if k == at else old) for k, (name, old) in enumerate(entries)]


def _paths(value: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """The ways to all fields and list items."""
    items: list[tuple[Any, Any]] = []
    if isinstance(value, dict):
        items = list(value.items())
    elif isinstance(value, list):
        items = list(enumerate(value))
    deeper = [each for key, inner in items for each in _paths(inner, (*path, key))]
    return [(*path, key) for key, _ in items] + deeper


def _unpacked(content: bytes) -> list[Entry]:
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        return [
            (info.filename, archive.read(info))
            for info in archive.infolist()
            if info.file_size < 1 << 20  # bombs stay packed
        ]


def _packed(entries: list[Entry], kinds: dict[str, int | None], comment: bytes = b"") -> bytes:
    """A zip; ``kinds`` are compressions other than none, None for the strongest."""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        archive.comment = comment
        for name, body in entries:
            kind = kinds.get(name, zipfile.ZIP_STORED)
            info = zipfile.ZipInfo(name)
            info.compress_type = zipfile.ZIP_DEFLATED if kind is None else kind
            archive.writestr(info, body)
    return file.getvalue()


def _with_sizes(content: bytes, random: Random) -> bytes:
    """Absurd numbers where local headers or the directory state sizes, offsets and flags."""
    changed = bytearray(content)
    mark, fields = random.choice(
        [(b"PK\x01\x02", (6, 8, 10, 16, 20, 24, 28, 30, 32, 42)), (b"PK\x03\x04", (6, 8, 18, 22))]
    )
    places = [k for k in range(len(changed)) if changed.startswith(mark, k)]
    at = random.choice(places) + random.choice(fields)
    changed[at : at + 4] = random.choice(
        [b"\xff\xff\xff\xff", bytes(4), b"\0\0\0\x7f", b"\1\0\0\0", random.randbytes(4)]
    )
    return bytes(changed)


@cache
def _bomb() -> bytes:
    return bytes(20_000_000)
