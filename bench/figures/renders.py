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


def sheet(context, report, name, caption, labels=None):
    """The maps above, their differences from the reference below."""
    maps = [row["map"] for row in report["rows"]]
    figure, axes = plt.subplots(2, len(maps), figsize=(3.2 * len(maps), 5), squeeze=False)
    for column, map_name in enumerate(maps):
        axes[0, column].imshow(plt.imread(report["directory"] / f"{map_name}.png"))
        axes[1, column].imshow(plt.imread(report["directory"] / f"{map_name}_error.png"))
        axes[0, column].set_title((labels or {}).get(map_name, map_name))
        axes[1, column].set_xlabel(f"MSE {mse(report, map_name):.3g}")
    for axis in axes.flat:
        axis.set_xticks([])
        axis.set_yticks([])
    figure.tight_layout(pad=0.3)
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
