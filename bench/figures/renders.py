"""Pictures by the wavefront renderer: comparisons of maps with a reference, and sheets of them with labels."""
import matplotlib.pyplot as plt

from context import read_json


def compare(context, name, scene, maps, spp, reference_spp, size, *options, show=True):
    """Renders; returns the report with its directory in it."""
    directory = context.directory(name)
    context.run("wavefront", scene, "--compare", ",".join(maps), "--spp", spp, "--reference-spp", reference_spp,
                "--size", size, *options, "--out", directory, show=show)
    report = read_json(directory / "report.json")
    report["directory"] = directory
    return report


def mse(report, map_name):
    """Less what the reference itself is off by."""
    row = next(row for row in report["rows"] if row["map"] == map_name)
    return max(row["mse"] - report["reference"]["mse"], 0)


def sheet(context, report, name, caption):
    """The maps, at most four in a row, and below each its difference from the reference."""
    maps = [row["map"] for row in report["rows"]]
    columns = 3 if len(maps) % 3 == 0 else min(4, len(maps))
    rows = -(-len(maps) // columns)
    figure, axes = plt.subplots(2 * rows, columns, figsize=(3.2 * columns, 5.4 * rows), squeeze=False,
                                layout="compressed")
    for i, map_name in enumerate(maps):
        row, column = divmod(i, columns)
        picture, error = axes[2 * row:2 * row + 2, column]
        picture.imshow(plt.imread(report["directory"] / f"{map_name}.png"))
        error.imshow(plt.imread(report["directory"] / f"{map_name}_error.png"))
        picture.set_title(map_name)
        error.set_xlabel(f"MSE {mse(report, map_name):.3g}")
    for axis in axes.flat:
        axis.set_xticks([])
        axis.set_yticks([])
    context.figure(figure, name, caption)


def error_table(context, report, paper=None):
    """`paper`: the MSE that it prints, by map."""
    paper = paper or {}
    rows = []
    for row in report["rows"]:
        name = row["map"]
        rows.append((name, f"{mse(report, name):.4e}", f"{paper[name]:.4e}" if name in paper else "",
                     ratio(mse(report, "area"), mse(report, name)),
                     ratio(paper["area"], paper[name]) if name in paper else "",
                     f"{row['ns_per_light_sample']:.1f}", f"{100 * row['light_stage_share']:.1f} %"))
    context.table(("map", "MSE", "paper", "area / map", "paper", "ns a light sample", "share of the frame"), rows)


def ratio(a, b):
    return f"{a / b:.3g}" if b > 0 else "-"
