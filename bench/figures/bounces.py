"""Global illumination: [GUK17]'s supplement, tabulated radial against area sampling."""
import renders


def make(context):
    size, reference = context.pick(("480x360", 64), ("240x180", 64))
    context.heading("Global illumination (GUK17, supplement)")
    report = renders.compare(context, "bounces", context.scene("spheres.xml"), ("area", "table"), 16, reference, size,
                             "--depth", 4)
    renders.sheet(context, report, "bounces/sheet.png",
                  "Paths of up to four surfaces, 16 a pixel; light is sampled at each of them. Paths are the same in "
                  "all pictures and in the reference, so errors are those of light sampling alone.")
    renders.error_table(context, report)
    context.text("GUK17's Figure 9, a production scene in a commercial renderer, is out of reach.")
