"""Typed numbers: 2.5, 2,5, 50/2, 5 cm, 3 * (1 mm + 200 µm)."""

import ast
import operator
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import isinf

from workbench.errors import shown
from workbench.units import WRITTEN

_LONGEST = 100
_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:[1-9]\d{0,2}(?:[ '’\u00a0\u2009\u202f]\d{3})+(?!\d)[\d.,]*"
    r"|\d[\d.,]*|[.,]\d+)(?:[eE][+-]?\d+)?)"
    r"|(?P<unit>[^\W\d_]+|[°\"%])"
    r"|(?P<sign>[-+*/()−×·÷]))\s*"
)
_SIGNS = str.maketrans("−×·÷", "-**/")
_SPACED = str.maketrans("", "", " '’\u00a0\u2009\u202f")
_THOUSANDS = re.compile(r"[1-9]\d{0,2},\d{3}")
# 1,234.5 and 1.234,5 and 1.234.567: the repeated or the first mark stands between thousands.
_GROUPED = re.compile(
    r"(?P<whole>[1-9]\d{0,2}(?P<mark>[.,])\d{3}(?:(?P=mark)\d{3})*)"
    r"(?P<rest>(?!(?P=mark))[.,]\d*(?:[eE][+-]?\d+)?)?"
)


@dataclass(frozen=True)
class _Quantity:
    """A number times a unit to some power."""

    number: Fraction
    power: int = 0


def read_number(text: str, unit: str = "") -> Fraction:
    """Evaluate a typed number or expression in the unit of its field; raise ValueError if invalid.

    The decimal mark is a point, or a comma where it cannot group thousands. Thousands may be
    grouped by spaces, apostrophes or the other mark. Expressions have + − * / and parentheses. A
    length may have any unit of `WRITTEN`, and a part ("of …") may be in percent.

    Examples
    --------
    >>> float(read_number("5 cm", "mm")), float(read_number("(2,5 + 0.5) / 2"))
    (50.0, 1.5)
    """
    if len(text) > _LONGEST:
        raise ValueError(f"has {len(text)} characters; at most {_LONGEST} are read")
    source, values = _source(text, _known(unit))
    try:
        found = _worked_out(ast.parse(source, mode="eval").body, values)
    except (SyntaxError, KeyError) as error:
        raise ValueError(f"{shown(text)} is not a number; a number is needed") from error
    except ZeroDivisionError as error:
        raise ValueError(f"{shown(text)} divides by zero") from error
    if found.power not in (0, 1):
        raise ValueError(f"{shown(text)} is no length, but one to the power of {found.power}")
    return found.number


def _known(unit: str) -> Mapping[str, Fraction]:
    """Units that may follow a number, in the field's unit."""
    if unit in WRITTEN:
        return {name: metres / WRITTEN[unit] for name, metres in WRITTEN.items()}
    if unit.startswith("of "):
        return {"%": Fraction(1, 100)}
    return {unit: Fraction(1)}


def _once(units: Mapping[str, Fraction]) -> list[str]:
    """First name of each unit."""
    first: dict[Fraction, str] = {}
    for name, size in units.items():
        first.setdefault(size, name)
    return [name for name in first.values() if name]


def _source(text: str, units: Mapping[str, Fraction]) -> tuple[str, dict[str, _Quantity]]:
    """Expression with names in place of numbers and units, and their values."""
    parts: list[str] = []
    values: dict[str, _Quantity] = {}
    at = 0
    while at < len(text):
        token = _TOKEN.match(text, at)
        if token is None:
            raise ValueError(f"{shown(text)} is not a number; a number is needed")
        at = token.end()
        name = f"v{len(values)}"
        if token["sign"]:
            parts.append(token["sign"].translate(_SIGNS))
        elif token["number"]:
            values[name] = _Quantity(_decimal(token["number"]))
            parts.append(name)
        elif not values:
            raise ValueError(f"{shown(text)} is not a number; a number is needed")
        elif token["unit"] not in units:
            here = ", ".join(_once(units)) or "no unit"
            raise ValueError(f"{shown(text)}: {token['unit']!r} is not known here; {here}")
        else:
            values[name] = _Quantity(units[token["unit"]], 1)
            parts.append(f"*{name}")
    return " ".join(parts), values


def _decimal(text: str) -> Fraction:
    text = text.translate(_SPACED)
    if _THOUSANDS.fullmatch(text):
        raise ValueError(
            f"{text} may be {text.replace(',', '.')} or {text.replace(',', '')}; "
            "write which of them"
        )
    if text.isdecimal():
        return Fraction(int(text))
    grouped = _GROUPED.fullmatch(text)
    if grouped and (grouped["rest"] or grouped["whole"].count(grouped["mark"]) > 1):
        text = grouped["whole"].replace(grouped["mark"], "") + (grouped["rest"] or "")
    plain = text.replace(",", ".")
    if plain.count(".") > 1:
        raise ValueError(f"{text} has more than one decimal point")
    number = float(plain)  # not Fraction(plain): a large exponent would need much memory
    if isinf(number):
        raise ValueError(f"{text} is too large")
    return Fraction(repr(number))


def _worked_out(node: ast.expr, values: Mapping[str, _Quantity]) -> _Quantity:
    match node:
        case ast.Name(id=name):
            return values[name]
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            found = _worked_out(operand, values)
            return _Quantity(-found.number, found.power)
        case ast.UnaryOp(op=ast.UAdd(), operand=operand):
            return _worked_out(operand, values)
        case ast.BinOp(left=left, op=ast.Add() | ast.Sub() as op, right=right):
            return _sum(_worked_out(left, values), _worked_out(right, values), op)
        case ast.BinOp(left=left, op=ast.Mult(), right=right):
            one, two = _worked_out(left, values), _worked_out(right, values)
            return _Quantity(one.number * two.number, one.power + two.power)
        case ast.BinOp(left=left, op=ast.Div(), right=right):
            one, two = _worked_out(left, values), _worked_out(right, values)
            return _Quantity(one.number / two.number, one.power - two.power)
    raise SyntaxError("a call, say: 2 (3)")


def _sum(one: _Quantity, two: _Quantity, op: ast.operator) -> _Quantity:
    if one.power != two.power:
        raise ValueError("a number with a unit and one without are added; give both a unit")
    add: Callable[[Fraction, Fraction], Fraction]
    add = operator.add if isinstance(op, ast.Add) else operator.sub
    return _Quantity(add(one.number, two.number), one.power)
