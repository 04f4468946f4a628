#!/usr/bin/env python3
"""Writes disk_solid_angle.inc and disk_direction.inc beside itself: golden values of a disk seen from a point.

Everything is equations 3-5 and 16-23 of Guillen et al. 2017 as printed (but for the misprints: y lies in the symmetry
plane, h = 1 is the centre), for inputs that are exact floats, at so many digits that nothing is lost where the formulas
cancel. Needs mpmath. Takes a few minutes.
"""

import math
import random
import re
import struct
from pathlib import Path

from mpmath import ellippi, findroot, mp, mpf

mp.dps = 150

CANONICAL = ((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), 1.0)
GENERAL = ((100.0, -50.0, 20.0), (0.36, 0.48, 0.8), 3.7)


def to_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def literal(x):
    """A C++ literal that is exactly this float."""
    return re.sub(r"\.?0*p", "p", x.hex()) + "f"


def ulp(x):
    return mpf(2) ** (max(math.frexp(x)[1] - 24, -149) if x else -149)


def add(p, q):
    return tuple(a + b for a, b in zip(p, q))


def scale(p, c):
    return tuple(a * c for a in p)


def dot(p, q):
    return sum(a * b for a, b in zip(p, q))


def unit(p):
    return scale(p, 1 / mp.sqrt(dot(p, p)))


def cross(p, q):
    return (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


class Ellipse:
    """The spherical ellipse of a disk (equations 3 to 5)."""

    def __init__(self, point, center, normal, radius):
        n = unit(normal)
        to_center = add(center, scale(point, -1))
        height = dot(to_center, n)
        if height < 0:
            n, height, self.side = scale(n, -1), -height, -1
        else:
            self.side = 1
        in_plane = add(to_center, scale(n, -height))
        d = mp.sqrt(dot(in_plane, in_plane))
        self.towards = scale(in_plane, 1 / d) if d else None  # on the axis any direction will do for the solid angle
        self.normal = n
        y0, y1 = d - radius, d + radius
        l0, l1 = mp.sqrt(y0**2 + height**2), mp.sqrt(y1**2 + height**2)
        y0, y1, z0, z1 = y0 / l0, y1 / l1, height / l0, height / l1
        yh, zh = (y0 + y1) / 2, (z0 + z1) / 2
        length = mp.sqrt(yh**2 + zh**2)
        self.center_y, self.center_z = yh / length, zh / length
        chord_y = height * yh / zh
        chord_x = mp.sqrt(radius**2 - (chord_y - d) ** 2)
        self.a = chord_x / mp.sqrt(chord_x**2 + chord_y**2 + height**2)
        self.b = mp.sqrt((y1 - y0) ** 2 + (z1 - z0) ** 2) / 2

    def quadrant(self, phi):
        """Equations 19 and 20."""
        a, b = self.a, self.b
        n = (a**2 - b**2) / (a**2 * (1 - b**2))
        m = (a**2 - b**2) / (1 - b**2)
        factor = b * (1 - a**2) / (a * mp.sqrt(1 - b**2))
        if phi == mp.pi / 2:
            return phi - factor * ellippi(n, m)
        tangent_ratio = a * mp.sqrt(1 - b**2) / (b * mp.sqrt(1 - a**2))
        return phi - factor * ellippi(n, mp.atan(tangent_ratio * mp.tan(phi)), m)

    def solid_angle(self):
        return 4 * self.quadrant(mp.pi / 2)

    def direction(self, theta, t):
        """Equations 21 to 23; t = 0 is the centre of the ellipse."""
        quarter = mp.pi / 2
        quadrant = int(mp.floor(theta / quarter))
        rest = theta - quadrant * quarter
        fold = rest / quarter if quadrant % 2 == 0 else 1 - rest / quarter
        whole = self.quadrant(quarter)
        guess = mp.atan(self.b / self.a * mp.tan(fold * quarter))
        phi = findroot(lambda p: self.quadrant(p) / whole - fold, (guess, guess * (1 + mpf(10) ** -6)))
        rim = self.a * self.b / mp.sqrt((self.a * mp.sin(phi)) ** 2 + (self.b * mp.cos(phi)) ** 2)
        h = 1 - t * (1 - mp.sqrt(1 - rim**2))
        x = mp.sqrt(1 - h**2) * mp.cos(phi) * (-1 if quadrant in (1, 2) else 1)
        y = mp.sqrt(1 - h**2) * mp.sin(phi) * (-1 if quadrant in (2, 3) else 1)
        axis_x = scale(cross(self.normal, self.towards), self.side)
        axis_y = add(scale(self.towards, self.center_z), scale(self.normal, -self.center_y))
        axis_z = add(scale(self.towards, self.center_y), scale(self.normal, self.center_z))
        return add(scale(axis_x, x), add(scale(axis_y, y), scale(axis_z, h)))


def radial(u, v):
    return 2 * mp.pi * u, v


def ld_radial(u, v):
    """Shirley and Chiu's concentric map; the radius is negative in two of the four triangles."""
    a, b = 2 * mpf(u) - 1, 2 * mpf(v) - 1
    r, phi = (a, mp.pi / 4 * b / a) if abs(a) > abs(b) else (b, mp.pi / 2 - mp.pi / 4 * a / b)
    return (phi + (mp.pi if r < 0 else 0)) % (2 * mp.pi), r**2


def solid_angle(coordinates, radius):
    return Ellipse(coordinates[0:3], coordinates[3:6], coordinates[6:9], radius).solid_angle()


def conditioning(coordinates, radius, step):
    """Sum of |df/dx_i| ulp(x_i) over the coordinates of point, centre and normal."""
    total = mpf(0)
    for i in range(9):
        ends = []
        for sign in (-1, 1):
            moved = list(coordinates)
            moved[i] += sign * step
            ends.append(solid_angle(moved, radius))
        total += abs(ends[1] - ends[0]) / (2 * step) * ulp(float(coordinates[i]))
    return total


def place(pose, local):
    """A point given in radii around the unit disk, moved along with the disk."""
    center, normal, radius = pose
    if pose is CANONICAL:
        return tuple(to_float(c) for c in local)
    n = tuple(float(c) for c in unit(normal))
    u = tuple(float(c) for c in unit(cross(n, (0.0, 1.0, 0.0))))
    v = cross(n, u)
    return tuple(to_float(c + radius * (local[0] * a + local[1] * b + local[2] * d)) for c, a, b, d in zip(center, u, v, n))


def w1(rng):
    return rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(0.05, 3.05)


def w2(rng):
    return rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5), 10 ** rng.uniform(-5, -1)


def w3(rng):
    distance, z, phi = 10 ** rng.uniform(1, 5), rng.uniform(-1, 1), rng.uniform(0, 2 * math.pi)
    s = math.sqrt(1 - z * z)
    return distance * s * math.cos(phi), distance * s * math.sin(phi), distance * z


def degenerate():
    for z in (1e-6, 1e-3, 0.5, 1, -2, 50, 1e4):
        yield 0, 0, z  # on the axis
    for x in (1 - 1e-3, 1 - 1e-5, 1, 1 + 1e-5, 1 + 1e-3):
        for z in (1e-6, 1e-3, -0.1):
            yield x, 0, z  # beside the rim
    for x in (0.3, 2, 30):
        for z in (1e-4, -1e-8, 1e-20, 1e-30):
            yield x, 0.1, z  # hugging the plane
    yield 1e6, 2e6, 3e6
    yield 1e9, 0, 1e9


def inputs(point, center, normal, radius):
    """A point and a Disk as C++ initialisers."""
    braced = ["{%s}" % ", ".join(map(literal, p)) for p in (point, center, normal)]
    return "%s, {%s, %s, %s}" % (*braced, literal(radius))


def solid_angle_rows():
    rng = random.Random(20170614)
    for pose in (CANONICAL, GENERAL):
        points = [f(rng) for f in (w1, w2, w3) for _ in range(60)] + list(degenerate())
        center = tuple(to_float(c) for c in pose[0])
        normal = tuple(to_float(c) for c in pose[1])
        radius = to_float(pose[2])
        for local in points:
            point = place(pose, local)
            exact = tuple(map(mpf, point + center + normal))
            height = abs(dot(add(exact[3:6], scale(exact[0:3], -1)), unit(exact[6:9])))
            if height == 0:
                continue
            value = solid_angle(exact, mpf(radius))
            error = conditioning(exact, mpf(radius), height * mpf(10) ** -30)
            yield "{%s, %s, %s}," % (inputs(point, center, normal, radius), mp.nstr(value, 18), mp.nstr(error, 6))


def direction_rows():
    rng = random.Random(20170615)
    maps = (("radial", radial), ("ld_radial", ld_radial))
    for pose in (CANONICAL, GENERAL):
        center = tuple(to_float(c) for c in pose[0])
        normal = tuple(to_float(c) for c in pose[1])
        radius = to_float(pose[2])
        for i in range(30):
            point = place(pose, (w1, w2, w3)[i % 3](rng))
            u, v = to_float(rng.uniform(0.01, 0.99)), to_float(rng.uniform(0.01, 0.99))
            exact = [tuple(map(mpf, p)) for p in (point, center, normal)]
            ellipse = Ellipse(*exact, mpf(radius))
            numbers = "%s, %s, %s" % (inputs(point, center, normal, radius), literal(u), literal(v))
            for name, square_to_polar in maps:
                direction = ellipse.direction(*square_to_polar(mpf(u), mpf(v)))
                words = ", ".join(mp.nstr(c, 18) for c in direction)
                yield "{DiskMap::%s, %s, {%s}}," % (name, numbers, words)


def write(name, comment, rows):
    text = "// Written by make_disk_golden.py. %s\n" % comment + "\n".join(rows) + "\n"
    Path(__file__).with_name(name).write_text(text, encoding="ascii")


if __name__ == "__main__":
    write("disk_solid_angle.inc", "point, centre, normal, radius, solid angle, sum of |df/dx| ulp(x)", solid_angle_rows())
    write("disk_direction.inc", "map, point, centre, normal, radius, u, v, direction", direction_rows())
