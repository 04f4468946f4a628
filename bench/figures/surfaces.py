"""Surfaces: [GUK17] Figure 7 and [UFK13] Figure 4, and with MIS [UFK13] Figure 6."""
import renders

DISK_MAPS = ("area", "rejection", "parallel", "radial", "ld_radial", "table", "radial_carlson", "parallel_carlson")
RECTANGLE_MAPS = ("area", "two_triangles", "spherical")
# What Figure 7 prints, as far as the text at hand has it.
PAPER = {"area": 4.3451e-3, "radial": 3.1013e-6, "ld_radial": 1.2655e-5}


def make(context):
    size, reference = context.pick(("640x480", 256), ("320x240", 128))
    context.heading("Surfaces: a disk (GUK17 Fig. 7)")
    disk = renders.compare(context, "surfaces/disk", context.scene("spheres.xml"), DISK_MAPS, 16, reference, size)
    renders.sheet(context, disk, "surfaces/disk.png",
                  "16 samples a pixel, and below what they are off by (black 0, red most).")
    renders.error_table(context, disk, PAPER)
    for strategy, figure in (("light", "Fig. 4"), ("mis", "Fig. 6: with MIS")):
        context.heading(f"Surfaces: a rectangle (UFK13 {figure})")
        report = renders.compare(context, f"surfaces/rectangle-{strategy}", context.scene("spheres-rectangle.xml"),
                                 RECTANGLE_MAPS, 9, reference, size, "--strategy", strategy)
        renders.sheet(context, report, f"surfaces/rectangle-{strategy}.png",
                      "9 samples a pixel" + (" of the light and 9 of the surface's reflection." if strategy == "mis"
                                             else ".") + " The layout is ours, the paper's is not published.")
        renders.error_table(context, report)
