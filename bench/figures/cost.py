"""Cost: how the time of a sample changes with lanes, samples a point, lights in a set and threads."""
import matplotlib.pyplot as plt
from matplotlib.ticker import FixedLocator, NullLocator, ScalarFormatter

from context import read_json

LANES = {"scalar": 1, "sse4_2": 4, "neon": 4, "avx2": 8, "avx512": 16}
MAPS = (("disk", "ld_radial"), ("disk", "area"), ("rectangle", "spherical"), ("rectangle", "area"))
STYLES = ("-", "--")  # of the widest instruction set and the next


def make(context):
    context.heading("Cost")
    path = context.directory("cost") / "report.json"
    repetitions, seconds = context.pick((15, 0.005), (5, 0.002))
    context.run("hatbox_bench", "--benchmark_filter=/growth/", "--repetitions", repetitions, "--min-time", seconds,
                "--report", path)
    report = read_json(path)
    rows = report["rows"]
    context.text("Nanoseconds a sample, medians of interleaved runs. Where nothing else is said: one sample a point, "
                 "one thread, 16384 samples a call, whose arrays the second-level cache holds. Sets: as many disks as "
                 "ellipses, rectangles and triangles (one light: a disk); each of 4096 points a call has one of them, "
                 "at random. Threads: 2^20 points a call, whose arrays no cache holds. Dotted: the time of one lane or "
                 "thread divided by their number. SSE4.2 has no fused multiply-add; it is done in double there, for "
                 f"the same bits. Measured on: {report['machine']}. Trust the ratios.")
    figure, axes = plt.subplots(1, 4, figsize=(19, 4.8))
    over_lanes(axes[0], rows)
    over_samples(axes[1], rows)
    over_lights(axes[2], rows)
    over_threads(axes[3], rows)
    for axis in axes:
        axis.set_ylabel("ns a sample")
        axis.grid(alpha=0.3)
    figure.tight_layout()
    context.figure(figure, "cost/growth.png",
                   "Time of a sample over lanes, samples a point, lights in a set and threads; colours of the second "
                   "and the last as in the first.")
    table(context, rows)


def isas(rows):
    """Widest first."""
    return sorted({row["isa"] for row in rows}, key=LANES.get, reverse=True)


def select(rows, x, **wanted):
    """The places and heights of a line."""
    some = sorted((row[x], row["ns_per_sample"]) for row in rows
                  if all(row[key] == value for key, value in wanted.items()))
    return [place for place, _ in some], [height for _, height in some]


def in_cache(rows):
    return [row for row in rows if not row["light"].startswith("set_") and row["points"] < 2**20]


def over_lanes(axis, rows):
    some = [row | {"lanes": LANES[row["isa"]]} for row in in_cache(rows) if row["samples_per_point"] == 1]
    for light, map_name in MAPS:
        lanes, cost = select(some, "lanes", light=light, map=map_name)
        line, = axis.loglog(lanes, cost, ".-", label=f"{light}, {map_name}")
        axis.loglog(lanes, [cost[0] / n for n in lanes], ":", color=line.get_color(), linewidth=1)
    names = {LANES[isa]: isa for isa in isas(rows)}
    ticks(axis, names, [f"{n}\n{name}" for n, name in names.items()])
    axis.set_xlabel("lanes")
    axis.legend(fontsize=8)


def over_samples(axis, rows):
    for isa, style in zip(isas(rows), STYLES):
        for colour, (light, map_name) in enumerate(MAPS):
            counts, cost = select(in_cache(rows), "samples_per_point", light=light, map=map_name, isa=isa)
            axis.semilogx(counts, cost, "." + style, color=f"C{colour}", label=isa if colour == 0 else None)
    ticks(axis, counts)
    axis.set_ylim(bottom=0)
    axis.set_xlabel("samples a point")
    axis.legend(fontsize=8)


def over_lights(axis, rows):
    some = [row | {"lights": int(row["light"][4:])} for row in rows if row["light"].startswith("set_")]
    for isa, style in zip(isas(rows), STYLES):
        for colour, (map_name, label) in enumerate((("best", "uniform in solid angle"), ("area", "area"))):
            lights, cost = select(some, "lights", map=map_name, isa=isa)
            axis.semilogx(lights, cost, "." + style, color=f"C{colour}", label=f"{label}, {isa}")
    axis.set_ylim(bottom=0)
    axis.set_xlabel("lights in a set")
    axis.legend(fontsize=8)


def over_threads(axis, rows):
    some = [row for row in rows if row["points"] == 2**20]
    for isa, style in zip(isas(some), STYLES):
        for colour, (light, map_name) in enumerate(MAPS):
            threads, cost = select(some, "threads", light=light, map=map_name, isa=isa)
            axis.loglog(threads, cost, "." + style, color=f"C{colour}", label=isa if colour == 0 else None)
            axis.loglog(threads, [cost[0] / n for n in threads], ":", color=f"C{colour}", linewidth=1)
    ticks(axis, threads)
    axis.set_xlabel("threads")
    axis.legend(fontsize=8)


def ticks(axis, places, labels=None):
    axis.set_xticks(list(places), labels or [str(place) for place in places])
    axis.xaxis.set_minor_locator(NullLocator())
    if axis.get_yscale() == "log":
        low, high = axis.get_ylim()
        steps = [step * 10**power for power in range(-1, 4) for step in (1, 2, 5)]
        axis.yaxis.set_major_locator(FixedLocator([step for step in steps if low <= step <= high]))
        axis.yaxis.set_minor_locator(NullLocator())
        axis.yaxis.set_major_formatter(ScalarFormatter())


def table(context, rows):
    widest = isas(rows)[0]
    lines = []
    for light, map_name in MAPS:
        counts, cost = select(in_cache(rows), "samples_per_point", light=light, map=map_name, isa=widest)
        lines.append((f"{light}, {map_name}", *(f"{ns:.2f}" for ns in cost)))
    context.text(f"Samples a point on {widest}, ns a sample.")
    context.table(("light and map", *(f"k = {k}" for k in counts)), lines)
