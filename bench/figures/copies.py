"""Reduced copies of the page's pictures, to be committed beside README.md."""
from PIL import Image

WIDTH, LARGEST = 1000, 200_000  # pixels, bytes
GREYS, COLOURS = 96, 160  # of the palette: rendered pictures are grey, and would get few among false colours


def write(context, directory):
    for kind, content in context.items:
        if kind == "picture":
            path = content[0]
            reduce(context.out / path, directory / path.replace("/", "-"))


def reduce(source, path):
    picture = Image.open(source).convert("RGB")
    width = WIDTH
    while True:
        small = picture.resize((width, round(width * picture.height / picture.width)), Image.LANCZOS)
        small.quantize(palette=palette_of(small), dither=Image.Dither.NONE).save(path, optimize=True)
        if path.stat().st_size < LARGEST:
            return
        width = int(0.9 * width)


def palette_of(picture):
    greys = [round(255 * i / (GREYS - 1)) for i in range(GREYS) for _ in "rgb"]
    palette = Image.new("P", (1, 1))
    palette.putpalette(greys + picture.quantize(COLOURS).getpalette()[:3 * COLOURS])
    return palette
