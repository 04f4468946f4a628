"""Makes all figures, from the programs that ./run figures builds."""
import argparse
import importlib
import pathlib
import sys

import copies
import page
from context import Context

FAMILIES = ("patterns", "surfaces", "media", "bounces", "curves", "accuracy", "cost")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("bin", type=pathlib.Path, help="where the programs are")
    parser.add_argument("out", type=pathlib.Path, help="where the page and the pictures go")
    parser.add_argument("--quick", action="store_true", help="smaller pictures, fewer samples")
    parser.add_argument("--only", choices=FAMILIES, help="one family of figures")
    parser.add_argument("--copies", type=pathlib.Path, help="put reduced copies of the pictures there as well")
    options = parser.parse_args()
    root = pathlib.Path(__file__).resolve().parents[2]
    context = Context(root, options.bin.resolve(), options.out.resolve(), options.quick)
    context.out.mkdir(parents=True, exist_ok=True)
    for family in [options.only] if options.only else FAMILIES:
        importlib.import_module(family).make(context)
    page.write(context, "The papers' figures, by hatbox" + (" (quick)" if options.quick else ""))
    if options.copies:
        copies.write(context, options.copies)
    context.progress(f"done: {context.out / 'index.html'}")


if __name__ == "__main__":
    try:
        main()
    except RuntimeError as error:
        sys.exit(f"figures: {error}")
