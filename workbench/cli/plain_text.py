"""Text for a terminal or pipe whose encoding lacks some of its characters."""

import re

# Signs of the field and of typography. Letters of other alphabets are escaped: they may be part of
# the name of a file.
_PLAIN = {
    "×": "x",
    "·": "*",
    "−": "-",
    "–": "-",
    "—": "-",
    "±": "+-",
    "°": " deg",
    "²": "^2",
    "³": "^3",
    "µ": "u",
    "μ": "u",
    "½": "1/2",
    "…": "...",
    "“": '"',
    "”": '"',
    "‘": "'",
    "’": "'",
    "«": '"',
    "»": '"',
    "→": "->",
    "←": "<-",
    "≤": "<=",
    "≥": ">=",
    "≈": "~",
    "≠": "!=",
    "∞": "inf",
    "√": "sqrt ",
    "∅": "diameter ",
    "Ø": "diameter ",
    "§": "section ",
    "α": "alpha",
    "β": "beta",
    "γ": "gamma",
    "δ": "delta",
    "Δ": "Delta",
    "η": "eta",
    "θ": "theta",
    "κ": "kappa",
    "λ": "lambda",
    "ν": "nu",
    "π": "pi",
    "ρ": "rho",
    "σ": "sigma",
    "τ": "tau",
    "φ": "phi",
    "ω": "omega",
    "Ω": "Ohm",
    "\u00a0": " ",
    "\u2009": " ",
    "\u202f": " ",
}
_HIGH = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
_DIGITS = str.maketrans(_HIGH, "-0123456789")
_POWER = re.compile(rf"(?:(?P<number>-?\d+(?:\.\d+)?) · )?10(?P<exponent>[{_HIGH}]+)")


def in_encoding(text: str, encoding: str) -> str:
    r"""Text in the characters that an encoding has, readable for people.

    Parameters
    ----------
    text : str
        What is printed.
    encoding : str
        Of the terminal, the pipe or the file.

    Examples
    --------
    >>> in_encoding("560 · 10⁻⁶ mm, 3 × 10⁻⁶, 90°, Maß", "ascii")
    '5.6e-4 mm, 3 x 1e-6, 90 deg, Ma\\xdf'
    >>> in_encoding("560 · 10⁻⁶ mm, 90°, Maß", "latin-1")
    '5.6e-4 mm, 90°, Maß'
    """
    if _has(encoding, text):
        return text
    if not _has(encoding, _HIGH):
        text = _POWER.sub(_with_exponent, text)
    return "".join(each if _has(encoding, each) else _plain(each) for each in text)


def _plain(character: str) -> str:
    return _PLAIN.get(character) or character.encode("ascii", "backslashreplace").decode("ascii")


def _with_exponent(power: re.Match[str]) -> str:
    """A number with a power of ten, as programs write it."""
    exponent = int(power["exponent"].translate(_DIGITS))
    number, _, shift = f"{float(power['number'] or 1):.15e}".partition("e")
    return f"{number.rstrip('0').rstrip('.')}e{exponent + int(shift)}"


def _has(encoding: str, text: str) -> bool:
    try:
        text.encode(encoding)
    except UnicodeEncodeError:
        return False
    return True
