"""Media: [GUK17] Figure 8 and [UFK13] Figure 8."""
import xml.etree.ElementTree as xml

import renders

DISK_MAPS = ("area", "area_first", "rejection", "parallel", "radial", "ld_radial")
RECTANGLE_MAPS = ("area", "two_triangles", "spherical")


def make(context):
    size, reference = context.pick(("320x240", 256), ("160x120", 256))
    context.heading("Media: a one-sided disk (GUK17 Fig. 8)")
    disk = renders.compare(context, "media/disk", context.scene("medium.xml"), DISK_MAPS, 16, reference, size)
    renders.sheet(context, disk, "media/disk.png",
                  "16 samples a pixel, places by equiangular sampling about the light's centre; area_first: about the "
                  "place on the light that was sampled first. A rabbit of spheres and cubes takes the bunny's place.")
    renders.error_table(context, disk)
    context.heading("Media: a one-sided rectangle (UFK13 Fig. 8)")
    scene = context.directory("media") / "rectangle.xml"
    write_rectangle_scene(context.scene("medium.xml"), scene)
    rectangle = renders.compare(context, "media/rectangle", scene, RECTANGLE_MAPS, 9, reference, size, "--media",
                                "march", "--steps", 2)
    renders.sheet(context, rectangle, "media/rectangle.png",
                  "9 paths a pixel with 2 steps of ray marching each; the scene above with a rectangle for its disk.")
    renders.error_table(context, rectangle)


def write_rectangle_scene(source, path):
    """The scene with a rectangle that circumscribes its disk."""
    tree = xml.parse(source)
    light = next(shape for shape in tree.getroot().iter("shape") if shape.find("emitter") is not None)
    light.set("type", "rectangle")
    tree.write(path, encoding="utf-8", xml_declaration=True)
