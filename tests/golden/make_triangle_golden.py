#!/usr/bin/env python3
"""Writes triangle_solid_angle.inc and triangle_direction.inc beside itself: golden values of a triangle seen from a point.

Everything is Arvo 1995 as printed (Girard's area, the listing's u, v, s, t and q), for inputs that are exact floats, at so
many digits that nothing is lost where the formulas cancel. Only which vertex the listing calls A is hatbox's own choice:
the one opposite the smallest side. Needs mpmath. Takes a minute.
"""

import math
import random
from pathlib import Path

from make_disk_golden import CANONICAL, GENERAL, add, cross, dot, literal, place, scale, to_float, ulp, unit, w1, w2, w3
from mpmath import mp, mpf

mp.dps = 200

LIGHTS = (
    ((-0.5, -0.25), (0.5, -0.25), (-0.5, 0.75)),
    ((-0.5, 0.0), (0.5, 0.0), (-0.5, 0.001)),
    ((-0.5, 0.0), (0.5, 0.0), (0.1, 0.001)),
)


def minus(p, q):
    return add(p, scale(q, -1))


def orthogonal(p, q):
    """Arvo's [p|q]: the component of p at right angles to q, normalized."""
    return unit(minus(p, scale(q, dot(p, q))))


def angle_at(p, q, r):
    """The angle of the spherical triangle at p."""
    return mp.acos(dot(unit(cross(p, q)), unit(cross(p, r))))


def sides(vertices):
    return [mp.acos(dot(vertices[(i + 1) % 3], vertices[(i + 2) % 3])) for i in range(3)]


class SphericalTriangle:
    def __init__(self, point, light):
        self.point, self.light = point, light
        directions = [unit(minus(vertex, point)) for vertex in light]
        lengths = sides(directions)
        first = lengths.index(min(lengths))
        self.gap = sorted(lengths)[1] / min(lengths) - 1  # how clear the choice is
        self.A, self.B, self.C = directions[first:] + directions[:first]
        self.alpha = angle_at(self.A, self.B, self.C)
        self.beta = angle_at(self.B, self.C, self.A)
        self.gamma = angle_at(self.C, self.A, self.B)
        self.area = self.alpha + self.beta + self.gamma - mp.pi

    def direction(self, xi1, xi2):
        cos_alpha, sin_alpha, cos_c = mp.cos(self.alpha), mp.sin(self.alpha), dot(self.A, self.B)
        phi = xi1 * self.area - self.alpha
        s, t = mp.sin(phi), mp.cos(phi)
        u = t - cos_alpha
        v = s + sin_alpha * cos_c
        q = ((v * t - u * s) * cos_alpha - v) / ((v * s + u * t) * sin_alpha)
        C_hat = add(scale(self.A, q), scale(orthogonal(self.C, self.A), mp.sqrt(1 - q * q)))
        z = 1 - xi2 * (1 - dot(C_hat, self.B))
        return add(scale(self.B, z), scale(orthogonal(C_hat, self.B), mp.sqrt(1 - z * z)))

    def place_of(self, direction):
        """(s, t) by Cramer's rule in point + distance direction = a + s (b - a) + t (c - a)."""
        a, b, c = self.light
        e1, e2, o = minus(b, a), minus(c, a), minus(self.point, a)
        whole = dot(cross(e1, e2), scale(direction, -1))
        return dot(cross(o, e2), scale(direction, -1)) / whole, dot(cross(e1, o), scale(direction, -1)) / whole


def solid_angle(coordinates):
    vertices = [coordinates[i : i + 3] for i in (3, 6, 9)]
    return SphericalTriangle(coordinates[0:3], vertices).area


def conditioning(coordinates, step):
    """Sum of |df/dx_i| ulp(x_i) over the coordinates of point and vertices."""
    total = mpf(0)
    for i in range(12):
        ends = []
        for sign in (-1, 1):
            moved = list(coordinates)
            moved[i] += sign * step
            ends.append(solid_angle(moved))
        total += abs(ends[1] - ends[0]) / (2 * step) * ulp(float(coordinates[i]))
    return total


def degenerate(light):
    (ax, ay), (bx, by), _ = light
    for z in (1e-6, 1e-3, -0.5, 50, 1e4):
        yield ax, ay, z  # over a corner
        yield bx, by, z
        yield 0.25, by, z  # over an edge
        yield 2.5, by, z  # over its line
    for x in (bx - 1e-3, bx - 1e-5, bx + 1e-5, bx + 1e-3):
        for z in (1e-6, 1e-3, -0.1):
            yield x, by, z  # beside a corner
    for x in (-0.45, 2, 30):
        for z in (1e-4, -1e-7, 1e-20, 1e-26):
            yield x, 0.0005, z  # hugging the plane
    yield 1e6, 2e6, 3e6
    yield 1e9, 0, 1e9


def inputs(point, light):
    """A point and a Triangle as C++ initialisers."""
    point, a, b, c = ("{%s}" % ", ".join(map(literal, p)) for p in (point, *light))
    return "%s, {%s, %s, %s}" % (point, a, b, c)


def exact(p):
    return tuple(map(mpf, p))


def cases(rng, counts):
    """Points and lights, of floats."""
    for pose in (CANONICAL, GENERAL):
        for light in LIGHTS:
            vertices = [place(pose, (x, y, 0.0)) for x, y in light]
            points = [f(rng) for f in (w1, w2, w3) for _ in range(counts)]
            for local in points + (list(degenerate(light)) if counts > 6 else []):
                yield place(pose, local), vertices


def solid_angle_rows():
    for point, light in cases(random.Random(19950806), 12):
        a, b, c = map(exact, light)
        height = abs(dot(minus(exact(point), a), unit(cross(minus(b, a), minus(c, a)))))
        if height == 0:
            continue
        coordinates = exact(point) + a + b + c
        value, error = solid_angle(coordinates), conditioning(coordinates, height * mpf(10) ** -40)
        yield "{%s, %s, %s}," % (inputs(point, light), mp.nstr(value, 18), mp.nstr(error, 6))


def direction_rows():
    rng = random.Random(19950807)
    for point, light in cases(rng, 6):
        u, v = to_float(rng.uniform(0.01, 0.99)), to_float(rng.uniform(0.01, 0.99))
        triangle = SphericalTriangle(exact(point), [exact(vertex) for vertex in light])
        if triangle.gap < 1e-4:
            continue
        direction = triangle.direction(mpf(u), mpf(v))
        diameter = mp.nstr(max(sides([triangle.A, triangle.B, triangle.C])), 6)
        numbers = ", ".join(mp.nstr(x, 18) for x in direction), ", ".join(mp.nstr(x, 18) for x in triangle.place_of(direction))
        yield "{%s, %s, %s, {%s}, %s, %s}," % (inputs(point, light), literal(u), literal(v), *numbers, diameter)


def write(name, comment, rows):
    text = "// Written by make_triangle_golden.py. %s\n" % comment + "\n".join(rows) + "\n"
    Path(__file__).with_name(name).write_text(text, encoding="ascii")


if __name__ == "__main__":
    write("triangle_solid_angle.inc", "point, a, b, c, solid angle, sum of |df/dx| ulp(x)", solid_angle_rows())
    write("triangle_direction.inc", "point, a, b, c, u, v, direction, s, t, angular diameter", direction_rows())
