#!/usr/bin/env python3
"""Writes carlson.inc and ellint.inc beside itself: golden values of the elliptic integrals for arguments that are exact
floats, by mpmath's own functions at 40 digits. Needs mpmath. Takes a few minutes.

Arguments of Carlson's: every combination of zero, extremes and equals in 1e-30 ... 1e30, log-uniform ones over 60, 20, 6
and 2 decades, and those that the incomplete integrals of the third kind bring about.
"""

import itertools
import math
import random
import re
import struct
from pathlib import Path

from mpmath import cos, ellipe, ellipf, ellippi, elliprc, elliprd, elliprf, elliprj, floor, mp, mpf, pi, sin

mp.dps = 40

SMALLEST_NORMAL, LARGEST = 2.0 ** -126, 3.4028234e38
QUARTER_TURN = struct.unpack("f", struct.pack("f", math.pi / 2))[0]


def to_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def literal(x):
    """A C++ literal that is exactly this float."""
    return re.sub(r"\.?0*p", "p", x.hex()) + "f"


def row(name, arguments, value):
    """None where the value is not a normal float."""
    if not SMALLEST_NORMAL <= abs(value) <= LARGEST:
        return None
    padded = list(arguments) + [0.0] * (4 - len(arguments))
    return "{Integral::%s, {%s}, %s}," % (name, ", ".join(map(literal, padded)), mp.nstr(value, 17, min_fixed=1, max_fixed=0))


def zeros_allowed(name, a):
    if name == "rc":
        return a[1] > 0
    if name == "rd":
        return a[2] > 0 and a[0] + a[1] > 0
    return sorted(a[:3])[1] > 0 and (name == "rf" or a[3] > 0)


FUNCTIONS = {"rf": (elliprf, 3), "rc": (elliprc, 2), "rd": (elliprd, 3), "rj": (elliprj, 4)}


def rj(x, y, z, p):
    """mpmath's duplication takes one step for every factor 4 of p; DLMF 19.21.12 brings a large p down to the others."""
    low, middle, high = sorted((x, y, z))
    if p < 1000 * high:
        return elliprj(x, y, z, p)
    q = high + (high - middle) * (high - low) / (p - high)
    first = elliprf(x, y, z) - elliprc(low * middle / high, p * q / high)
    return (3 * first - (q - high) * elliprj(x, y, z, q)) / (p - high)


def carlson(name, arguments):
    function = rj if name == "rj" else FUNCTIONS[name][0]
    exact = [mpf(x) for x in arguments]
    return row(name, arguments, function(*exact)) if zeros_allowed(name, arguments) else None


def third_kind_arguments(rng):
    """Those of R_J in Pi(n; phi | m), n -> 1 and n < 0 included."""
    phi = rng.uniform(0, math.pi / 2)
    m = rng.choice((rng.uniform(0, 1), 1 - 10 ** rng.uniform(-7, 0), -(10 ** rng.uniform(-3, 6))))
    n = rng.choice((1 - 10 ** rng.uniform(-7, 0), -(10 ** rng.uniform(-6, 6)), rng.uniform(0, 1)))
    s2, c2 = math.sin(phi) ** 2, math.cos(phi) ** 2
    return c2, c2 + (1 - m) * s2, 1.0, c2 + (1 - n) * s2


def carlson_rows():
    rng = random.Random(1995)
    extremes = {"rc": (0, 1e-30, 1e-15, 0.9999, 1, 1e15, 1e30), "rf": (0, 1e-30, 1e-15, 0.9999, 1, 1e15, 1e30),
                "rd": (0, 1e-30, 1e-15, 1, 1e15, 1e30), "rj": (0, 1e-30, 1, 1.001, 1e30)}
    for name, (_, count) in FUNCTIONS.items():
        for arguments in itertools.product(map(float, extremes[name]), repeat=count):
            yield carlson(name, [to_float(x) for x in arguments])
        for i in range(400):
            decades, middle = ((30, 0), (10, rng.uniform(-15, 15)), (3, rng.uniform(-5, 5)), (1, rng.uniform(-5, 5)))[i % 4]
            arguments = [to_float(10 ** (middle + rng.uniform(-decades, decades))) for _ in range(count)]
            if i % 16 == 5:
                arguments[0] = 0.0
            if i % 16 == 9:
                arguments[1] = arguments[count - 1]
            yield carlson(name, arguments)
    for _ in range(400):
        yield carlson("rj", [to_float(x) for x in third_kind_arguments(rng)])


def folded(phi, incomplete, complete):
    """The integral of an exact float phi, but for the one nearest to a quarter turn, which stands for that itself."""
    if abs(phi) == QUARTER_TURN:
        return mpf(math.copysign(1, phi)) * complete()
    turns = floor(mpf(phi) / pi + mpf(1) / 2)
    rest = incomplete(mpf(phi) - turns * pi)
    return rest + 2 * turns * complete() if turns else rest


def first_of(phi, m):
    s, c = sin(phi), cos(phi)
    return s * elliprf(c * c, 1 - m * s * s, 1)


def second_of(phi, m):
    s, c = sin(phi), cos(phi)
    return first_of(phi, m) - m * s ** 3 * elliprd(c * c, 1 - m * s * s, 1) / 3


def third_of(n, phi, m):
    s, c = sin(phi), cos(phi)
    return first_of(phi, m) + n * s ** 3 * rj(c * c, 1 - m * s * s, mpf(1), 1 - n * s * s) / 3


def legendre(phi, m, n):
    for name, function, complete, arguments in (
            ("f", first_of, lambda: first_of(pi / 2, mpf(m)), (phi, m)),
            ("e", second_of, lambda: second_of(pi / 2, mpf(m)), (phi, m)),
            ("pi", lambda p, q: third_of(mpf(n), p, q), lambda: third_of(mpf(n), pi / 2, mpf(m)), (n, phi, m))):
        yield row(name, arguments, folded(phi, lambda p, f=function: f(p, mpf(m)), complete))


def legendre_rows():
    rng = random.Random(1972)
    below_one = 1 - 2.0 ** -24
    for phi, m, n in itertools.product((1e-30, 0.5, QUARTER_TURN, -QUARTER_TURN, 3.0, 1000.0),
                                       (-1e6, -1.0, 0.0, 0.5, below_one), (-1e6, -1e-6, 0.0, 0.5, below_one)):
        yield from legendre(*map(to_float, (phi, m, n)))
    for i in range(500):
        phi = (rng.uniform(-1.57, 1.57), rng.uniform(-5, 5), rng.uniform(-1000, 1000), 10 ** rng.uniform(-8, 0))[i % 4]
        m = rng.choice((rng.uniform(0, 1), 1 - 10 ** rng.uniform(-7, 0), -(10 ** rng.uniform(-3, 6))))
        n = rng.choice((rng.uniform(0, 1), 1 - 10 ** rng.uniform(-7, 0), -(10 ** rng.uniform(-6, 6))))
        m, n = min(to_float(m), below_one), min(to_float(n), below_one)
        yield from legendre(to_float(phi), m, n)
    for _ in range(80):
        phi = to_float(rng.uniform(-1.5, 1.5))
        m = to_float(1 + (0.9 / math.sin(phi) ** 2 - 1) * rng.uniform(0, 1))
        if m * math.sin(phi) ** 2 < 0.9:
            yield from legendre(phi, m, to_float(rng.uniform(-2, 1)))


def write(name, comment, rows):
    text = "// Written by make_carlson_golden.py. %s\n" % comment + "\n".join(r for r in rows if r) + "\n"
    Path(__file__).with_name(name).write_text(text, encoding="ascii")


if __name__ == "__main__":
    # The forms used here are mpmath's own functions.
    assert mp.almosteq(ellipf(mpf(1) / 2, mpf(1) / 3), first_of(mpf(1) / 2, mpf(1) / 3))
    assert mp.almosteq(ellipe(mpf(1) / 2, mpf(1) / 3), second_of(mpf(1) / 2, mpf(1) / 3))
    assert mp.almosteq(ellippi(mpf(-2), mpf(1) / 2, mpf(1) / 3), third_of(mpf(-2), mpf(1) / 2, mpf(1) / 3))
    write("carlson.inc", "which, arguments (padded), value", carlson_rows())
    write("ellint.inc", "which, arguments (padded), value", legendre_rows())
