"""Where one run of the figures keeps its things: runs programs, collects what the page shows, tells how far it is."""
import csv
import json
import pathlib
import shlex
import subprocess
import time

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


class Context:
    def __init__(self, root, bin_directory, out, quick):
        self.root, self.bin, self.out, self.quick = root, bin_directory, out, quick
        self.items = []  # of the page, in order: (kind, content)
        self.start = time.monotonic()

    def pick(self, full, quick):
        return quick if self.quick else full

    def scene(self, name):
        return self.root / "bench/wavefront/scenes" / name

    def progress(self, what):
        print(f"[{time.monotonic() - self.start:5.0f} s] {what}", flush=True)

    def run(self, program, *arguments, show=True):
        """Runs one of the project's programs; its command is shown on the page."""
        command = [str(self.bin / program), *map(str, arguments)]
        shown = shlex.join(self.relative(word) for word in command)
        if show:
            self.items.append(("command", shown))
        self.progress(shown)
        result = subprocess.run(command, cwd=self.root, text=True, capture_output=True)
        if result.returncode != 0:
            raise RuntimeError(f"{shown}\n{result.stderr}")

    def relative(self, word):
        prefix = str(self.root) + "/"
        return word[len(prefix):] if word.startswith(prefix) else word

    def heading(self, text):
        self.items.append(("heading", text))
        self.progress(text)

    def text(self, text):
        self.items.append(("text", text))

    def table(self, header, rows):
        self.items.append(("table", (header, rows)))

    def picture(self, path, caption):
        self.items.append(("picture", (str(path.relative_to(self.out)), caption)))

    def figure(self, figure, name, caption):
        path = self.out / name
        path.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(path, dpi=110, bbox_inches="tight")
        plt.close(figure)
        self.picture(path, caption)

    def directory(self, name):
        path = self.out / name
        path.mkdir(parents=True, exist_ok=True)
        return path


def read_csv(path):
    """Rows as dictionaries; what looks like a number is one."""
    with open(path, newline="", encoding="utf-8") as file:
        return [{key: number(value) for key, value in row.items()} for row in csv.DictReader(file)]


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def read_json(path):
    return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
