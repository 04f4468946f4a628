"""Reduced copies of the page's pictures, to be committed beside README.md."""
from PIL import Image

WIDTH, COLOURS, LARGEST = 1000, 256, 200_000  # pixels, palette, bytes


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
        small.quantize(COLOURS).save(path, optimize=True)
        if path.stat().st_size < LARGEST:
            return
        width = int(0.9 * width)
