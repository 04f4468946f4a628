"""Curves: [GUK17] Figure 6 and [UFK13] Figure 7: error and cost against samples, error against time."""
import csv
import math
import statistics

import matplotlib.pyplot as plt

import media
import renders
import surfaces
from context import read_json

SIZE = "128x96"


def make(context):
    context.heading("Curves (GUK17 Fig. 6, UFK13 Fig. 7)")
    context.text(f"wavefront SCENE --compare MAPS --spp N --reference-spp REFERENCE --size {SIZE}, for each N; "
                 "REFERENCE is 1024, or 4N if that is more. Errors are those of light sampling alone, less the "
                 "reference's own. Times are of this machine as busy as it was: compare them within one column.")
    maps = surfaces.DISK_MAPS + ("auto",)
    disk = measure(context, "disk", "spheres.xml", maps)
    plot(context, "disk", disk, "A disk on surfaces")
    cost_table(context, disk)
    fog = measure(context, "fog", "medium.xml", media.DISK_MAPS)
    plot(context, "fog", fog, "A disk in fog")
    light = measure(context, "rectangle", "spheres-rectangle.xml", surfaces.RECTANGLE_MAPS)
    plot(context, "rectangle", light, "A rectangle on surfaces")
    mis = measure(context, "rectangle-mis", "spheres-rectangle.xml", surfaces.RECTANGLE_MAPS, "--strategy", "mis")
    plot(context, "rectangle-mis", mis, "A rectangle on surfaces, with MIS")
    rectangle_table(context, light, mis)
    plot_distances(context)


def measure(context, name, scene, maps, *options):
    """{map: {spp: (RMS error, light stage seconds, frame seconds)}}; also written as a table of numbers."""
    results = {map_name: {} for map_name in maps}
    for exponent in range(context.pick(6, 4)):
        spp = 4**exponent
        report = compare(context, name, scene, maps, spp, max(1024, 4 * spp), options)
        # What takes little time is measured more often; all maps in turn, so that what else runs falls on all alike.
        more = 6 if spp <= 4 else 2 if spp <= 64 else 0
        again = [compare(context, name, scene, maps, spp, 1, options) for _ in range(more)]
        for row in report["rows"]:
            times = [time_of(some, row["map"]) for some in (report, *again)]
            results[row["map"]][spp] = (math.sqrt(renders.mse(report, row["map"])),
                                        statistics.median(light for light, _ in times),
                                        statistics.median(frame for _, frame in times))
    write(context.out / f"curves/{name}.csv", results)
    return results


def compare(context, name, scene, maps, spp, reference, options):
    return renders.compare(context, f"curves/{name}", context.scene(scene), maps, spp, reference, SIZE, *options,
                           show=False)


def time_of(report, map_name):
    row = next(row for row in report["rows"] if row["map"] == map_name)
    return row["light_stage_share"] * row["seconds"], row["seconds"]


def write(path, results):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(("map", "spp", "rms_error", "light_stage_seconds", "frame_seconds"))
        for map_name, by_spp in results.items():
            writer.writerows((map_name, spp, *values) for spp, values in by_spp.items())


def plot(context, name, results, title):
    figure, axes = plt.subplots(1, 4, figsize=(19, 4.5))
    for map_name, by_spp in results.items():
        samples = list(by_spp)
        error, light, frame = zip(*by_spp.values())
        axes[0].loglog(samples, error, ".-", label=map_name)
        axes[1].loglog(frame, error, ".-")
        axes[2].loglog(samples, light, ".-")
        axes[3].semilogx(samples, [100 * a / b for a, b in zip(light, frame)], ".-")
    labels = (("samples a pixel", "RMS error"), ("seconds a frame", "RMS error"),
              ("samples a pixel", "seconds of the light stage"), ("samples a pixel", "light stage, % of the frame"))
    for axis, (x, y) in zip(axes, labels):
        axis.set_xlabel(x)
        axis.set_ylabel(y)
        axis.grid(alpha=0.3)
    axes[0].legend(fontsize=8, loc="lower left")
    figure.suptitle(title)
    figure.tight_layout()
    context.figure(figure, f"curves/{name}.png", title)


def cost_table(context, results):
    """Cost of the light stage over area sampling's."""
    samples = [spp for spp in next(iter(results.values())) if spp >= 4]
    rows = []
    for map_name, by_spp in results.items():
        ratios = [by_spp[spp][1] / results["area"][spp][1] for spp in samples]
        rows.append((map_name, *(f"{ratio:.1f}" for ratio in ratios)))
    context.text("The light stage, its time over area sampling's (one sample a vertex, so nothing is shared).")
    context.table(("map", *(f"{spp} samples" for spp in samples)), rows)


def samples_for(error, by_spp):
    """How many samples a map needs for an error, between the measured counts by a power law."""
    counts = sorted(by_spp)
    for low, high in zip(counts, counts[1:]):
        first, last = by_spp[low][0], by_spp[high][0]
        if first >= error >= last > 0:
            return low * (high / low) ** (math.log(first / error) / math.log(first / last))
    return None


def rectangle_table(context, light, mis):
    rows = []
    for spp in light["spherical"]:
        cells = [spp]
        for results in (light, mis):
            for other in ("area", "two_triangles"):
                needed = samples_for(results[other][spp][0], results["spherical"])
                cells.append(f"{needed / spp:.2f}" if needed else "-")
        rows.append(cells)
    context.text("The samples that spherical needs for the error of the others, as a share of theirs. The paper tells "
                 "of 1024 samples: two_triangles 0.85 without and 0.91 with MIS, area about 0.5 with MIS.")
    context.table(("samples", "area", "two_triangles", "area, MIS", "two_triangles, MIS"), rows)


def plot_distances(context):
    report = context.directory("curves") / "distances.json"
    context.run("hatbox_bench", "--benchmark_filter=distance", "--report", report)
    rows = read_json(report)["distances"]
    figure, axes = plt.subplots(1, 2, figsize=(10, 4))
    for map_name in dict.fromkeys(row["map"] for row in rows):
        some = [row for row in rows if row["map"] == map_name]
        distances = [row["distance"] for row in some]
        axes[0].loglog(distances, [row["relative_error"] for row in some], ".-", label=map_name)
        axes[1].semilogx(distances, [row["ns_per_sample"] for row in some], ".-")
    axes[0].set_ylabel("RMS error of the irradiance, 16 samples, relative")
    axes[1].set_ylabel("ns a sample")
    for axis in axes:
        axis.set_xlabel("distance, radii")
        axis.grid(alpha=0.3)
    axes[0].legend()
    figure.tight_layout()
    context.figure(figure, "curves/distances.png",
                   "Over the distance of a patch that faces the centre of the disk, in all directions from it; auto: "
                   "area sampling below 1e-2 sr.")
