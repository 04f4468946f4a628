"""Patterns: [GUK17] Figure 1 and [UFK13] Figure 5 for every light and map."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

from context import read_csv

LIGHTS = ("disk", "ellipse", "rectangle", "triangle")
POINTS_PER_LINE = 129


def make(context):
    context.heading("Patterns (GUK17 Fig. 1, UFK13 Fig. 5)")
    data = context.directory("patterns")
    context.run("figure_patterns", data)
    points, lines = read_csv(data / "points.csv"), read_csv(data / "lines.csv")
    for light in LIGHTS:
        draw_light(context, light, points, lines)
    continuity_table(context, read_csv(data / "continuity.csv"))


def draw_light(context, light, points, lines):
    maps = list(dict.fromkeys(row["map"] for row in points if row["light"] == light))
    figure, axes = plt.subplots(3, len(maps), figsize=(2.1 * len(maps), 6.4), squeeze=False, sharex="row",
                                sharey="row")
    view = plane_of_sight([row for row in points if row["light"] == light])
    for column, name in enumerate(maps):
        of_map = [row for row in points if (row["light"], row["map"]) == (light, name)]
        grid = [row for row in lines if (row["light"], row["map"]) == (light, name)]
        axes[0, column].set_title(name, fontsize=9)
        stratified = [row for row in of_map if row["set"] == "stratified"]
        hammersley = [row for row in of_map if row["set"] == "hammersley"]
        draw(axes[0, column], stratified, on_light, colours(stratified), 4)
        draw(axes[1, column], stratified, view, colours(stratified), 4)
        draw(axes[2, column], hammersley, view, "black", 3)
        if name != "rejection":
            draw_lines(axes[0, column], on_light(grid))
            draw_lines(axes[1, column], view(grid))
            draw_lines(axes[2, column], view(grid))
    for row, label in enumerate(("on the light", "on the sphere", "256 Hammersley points")):
        axes[row, 0].set_ylabel(label, fontsize=9)
    figure.tight_layout(pad=0.4)
    context.figure(figure, f"patterns/{light}.png",
                   f"A {light}: 32² stratified points, coloured by their place in the square, on the light and on the "
                   "sphere, and 256 Hammersley points on the sphere; lines are those of an 8 × 8 grid.")


def columns(rows, *names):
    return np.array([[row[name] for name in names] for row in rows])


def on_light(rows):
    return columns(rows, "s", "t")


def plane_of_sight(rows):
    """Orthographic projection along the mean direction: what the light looks like on the sphere."""
    centre = columns(rows, "x", "y", "z").mean(axis=0)
    centre /= np.linalg.norm(centre)
    right = np.cross(centre, (0, 0, 1))
    right /= np.linalg.norm(right)
    axes = np.stack((right, np.cross(right, centre)), axis=1)
    return lambda some: columns(some, "x", "y", "z") @ axes


def colours(rows):
    u, v = columns(rows, "u", "v").T
    return np.stack((u, v, 1 - u), axis=1) * 0.9


def draw(axis, rows, project, colour, size):
    places = project(rows)
    axis.scatter(*places.T, s=size, c=colour, linewidths=0)
    axis.set_aspect("equal")
    axis.set_xticks([])
    axis.set_yticks([])


def draw_lines(axis, places):
    """A line breaks where it jumps."""
    pieces = []
    for line in places.reshape(-1, POINTS_PER_LINE, 2):
        steps = np.linalg.norm(np.diff(line, axis=0), axis=1)
        pieces += np.split(line, np.flatnonzero(steps > 0.3 * np.ptp(places)) + 1)
    axis.add_collection(LineCollection(pieces, colors="0.35", linewidths=0.5))


def continuity_table(context, rows):
    context.text("Largest distance on the sphere between the images of neighbours in a lattice of n² points, over the "
                 "median. From n = 128 to 512 it stays for a map with bounded derivatives, doubles where a map goes "
                 "like a square root (the centre of a polar map), grows by 4^(2/3) = 2.5 where it goes like a cube "
                 "root (the ends of the parallel map's slices), and fourfold where a map tears neighbours apart.")
    coarse = {(row["light"], row["map"]): row for row in rows if row["n"] == 128}
    table = []
    for row in rows:
        if row["n"] == 512:
            first = coarse[row["light"], row["map"]]["largest_over_median"]
            last = row["largest_over_median"]
            table.append((f"{row['light']} {row['map']}", f"{first:.2f}", f"{last:.2f}", f"{last / first:.2f}",
                          f"{row['largest_over_ideal']:.2f}"))
    context.table(("light and map", "n = 128", "n = 512", "growth", "n = 512, over √Ω/n"), table)
