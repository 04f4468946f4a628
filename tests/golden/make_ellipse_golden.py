#!/usr/bin/env python3
"""Writes ellipse_solid_angle.inc beside itself: golden solid angles of an ellipse seen from a point.

By Green's theorem in the light's plane: with r from the point to the rim, h = |n.r| and R = |r|,
    Omega = integral of n.(r x dr) / (R (R + h))
around the rim, for inputs that are exact floats. Nothing of the library's method is in it. Needs mpmath. Takes a few
minutes.
"""

import math
import random
from pathlib import Path

from make_disk_golden import add, cross, dot, literal, place, scale, to_float, unit, w1, w2, w3
from make_disk_golden import CANONICAL, GENERAL
from mpmath import mp, mpf, quad

mp.dps = 60
ASPECTS = (1.0, 0.5, 0.1, 0.01)


def solid_angle(point, center, u, v):
    l = add(center, scale(point, -1))
    n = unit(cross(u, v))
    h = abs(dot(n, l))

    def rim(t):
        c, s = mp.cos(t), mp.sin(t)
        return add(l, add(scale(u, c), scale(v, s))), add(scale(u, -s), scale(v, c))

    def integrand(t):
        r, tangent = rim(t)
        R = mp.sqrt(dot(r, r))
        return dot(n, cross(r, tangent)) / (R * (R + h))

    # The integrand varies on the scale of the distance to the rim, about the nearest points of it.
    steps = 720
    distances = [dot(*(2 * (rim(mpf(i) * 2 * mp.pi / steps)[0],))) for i in range(steps)]
    near = [i for i in range(steps) if distances[i] <= distances[i - 1] and distances[i] < distances[(i + 1) % steps]] or [0]
    near = [refine(lambda t: dot(*rim(t)), (i - 1) * 2 * mp.pi / steps, (i + 1) * 2 * mp.pi / steps) for i in near]
    start = near[0]
    ends = {start, start + 2 * mp.pi}
    for t in near:
        for k in range(0, 24):
            for side in (-1, 1):
                ends.add(start + (t + side * mpf(2) ** -k - start) % (2 * mp.pi))
        ends.add(start + (t - start) % (2 * mp.pi))
    return abs(quad(integrand, sorted(ends), method="gauss-legendre", maxdegree=4))


def refine(slope, low, high):
    """The zero of a rising function between two points; the nearest rim need not be exact."""
    low, high = mpf(low), mpf(high)
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (low, middle) if slope(middle) > 0 else (middle, high)
    return low


def rotated(pose, local):
    """A vector given at the canonical ellipse, turned and scaled along with it."""
    if pose is CANONICAL:
        return tuple(to_float(c) for c in local)
    n = tuple(float(c) for c in unit(pose[1]))
    u = tuple(float(c) for c in unit(cross(n, (0.0, 1.0, 0.0))))
    v = cross(n, u)
    return tuple(to_float(pose[2] * (local[0] * a + local[1] * b)) for a, b in zip(u, v))


def hugging(rng, aspect):
    """Like w2, in units of each axis."""
    x, y, z = w2(rng)
    return x, aspect * y, aspect * z


def degenerate(aspect):
    focus = math.sqrt(1 - aspect * aspect)
    for z in (1e-6, 0.5, -20, 1e4):
        yield 0, 0, z  # on the axis
        yield focus, 0, z  # above a focal point
    for x in (1 - 1e-3, 1 + 1e-5):
        yield x, 0, 1e-3  # beside the ends of the axes
        yield 0, aspect * x, 1e-3
    yield 0.3, 0.2 * aspect, 1e-20
    yield 1.5, 0.2, 1e-10


def rows():
    rng = random.Random(20170616)
    for pose in (CANONICAL, GENERAL):
        for aspect in ASPECTS:
            axes = [(1.0, 0.0, 0.0), (0.0, aspect, 0.0)]
            if aspect == 0.1:
                axes.reverse()
            u, v = (rotated(pose, axis) for axis in axes)
            center = tuple(to_float(c) for c in pose[0])
            points = [f(rng) for f in (w1, w2, w3, lambda g: hugging(g, aspect)) for _ in range(8)]
            for local in points + list(degenerate(aspect)):
                point = place(pose, local)
                exact = [tuple(map(mpf, p)) for p in (point, center, u, v)]
                if dot(unit(cross(exact[2], exact[3])), add(exact[1], scale(exact[0], -1))) == 0:
                    continue
                braced = ["{%s}" % ", ".join(map(literal, p)) for p in (point, center, u, v)]
                yield "{%s, {%s, %s, %s}, %s}," % (*braced, mp.nstr(solid_angle(*exact), 18))


if __name__ == "__main__":
    text = "// Written by make_ellipse_golden.py. point, centre, semi-axes, solid angle\n" + "\n".join(rows()) + "\n"
    Path(__file__).with_name("ellipse_solid_angle.inc").write_text(text, encoding="ascii")
