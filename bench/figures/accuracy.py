"""Accuracy maps: what the maps are off by over distance and elevation, ours and the papers' formulas in float."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

from context import read_csv

ROWS = (("disk", "ld_radial"), ("disk", "radial"), ("disk", "paper_float"), ("rectangle", "spherical"),
        ("rectangle", "paper_float"))
COLUMNS = (("cells", "cells' solid angles"), ("density", "density told · Ω − 1"), ("solid_angle", "solid angle told"),
           ("direction", "float against double"))


def make(context):
    context.heading("Accuracy maps")
    path = context.directory("accuracy") / "accuracy.csv"
    context.run("figure_accuracy", path, context.pick(9, 4))
    rows = read_csv(path)
    figure, axes = plt.subplots(len(ROWS), len(COLUMNS), figsize=(15, 2.6 * len(ROWS)), sharex=True, sharey=True)
    for row, (light, name) in enumerate(ROWS):
        some = [r for r in rows if (r["light"], r["map"]) == (light, name)]
        for column, (key, title) in enumerate(COLUMNS):
            mesh = heat_map(axes[row, column], some, key)
            if row == 0:
                axes[row, column].set_title(title)
        axes[row, 0].set_ylabel(f"{light}: {name}\nelevation, degrees")
    for axis in axes[-1]:
        axis.set_xlabel("distance, radii (half edges)")
    figure.colorbar(mesh, ax=axes, label="relative error, the largest of 289 samples", shrink=0.6)
    context.figure(figure, "accuracy/maps.png",
                   "Relative errors against references of more digits. Yellow and black: no digit right, or not a "
                   "number. The papers' formulas are differences of nearly equal numbers where the light is small; the "
                   "angle η (src/eta_series.h) and differences of arc tangents (src/rectangle_strips.h) are not.")
    quantile_table(context, rows)


def heat_map(axis, rows, key):
    distances = sorted({r["distance"] for r in rows})
    elevations = sorted({r["elevation"] for r in rows})
    value = {(r["distance"], r["elevation"]): r[key] for r in rows}
    errors = np.array([[value[d, e] for d in distances] for e in elevations])
    colours = plt.get_cmap("viridis").with_extremes(bad="black", over="black")
    mesh = axis.pcolormesh(distances, elevations, np.ma.masked_invalid(np.maximum(errors, 1e-8)), cmap=colours,
                           norm=LogNorm(1e-8, 1), shading="nearest")
    axis.set_xscale("log")
    axis.set_yscale("log")
    return mesh


def quantile_table(context, rows):
    table = []
    for light, name in ROWS:
        cells = [f"{light} {name}"]
        for key, _ in COLUMNS:
            errors = [r[key] for r in rows if (r["light"], r["map"]) == (light, name)]
            errors = np.nan_to_num(errors, nan=np.inf, posinf=np.inf)
            cells.append(" / ".join(f"{np.quantile(errors, q, method='lower'):.1e}" for q in (0.5, 0.95, 1)))
        table.append(cells)
    context.text("Median / 95 % / largest over the map.")
    context.table(("", *(title for _, title in COLUMNS)), table)
