#!/usr/bin/env python3
"""Checks that includes point down the layers of src/README.md, and that third-party
numeric headers stay in src/number. Prints `file:line: message` for each violation."""

import re
import sys
from pathlib import Path

# From the bottom up: a file includes its own folder and those before it.
LAYERS = [
    "base",
    "number",
    "poly",
    "geometry",
    "surface",
    "csg",
    "scene",
    "method",
    "trace",
    "census",
    "report",
    "experiments",
    "cli",
]
NUMERIC = re.compile(r"(boost/multiprecision/|CGAL/|eigen3/|Eigen/|mpfr\.h|mpfi(_io)?\.h|gmp(xx)?\.h)")
INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')


def folder_of(path):
    """The layer of a path as it is written in an include, or None if it has none."""
    folder = Path(path).parts[0]
    return folder if folder in LAYERS and len(Path(path).parts) > 1 else None


def violations(root, file):
    """Yields (line number, message) for each include of a file that is not allowed."""
    folder = file.relative_to(root).parts[0]
    if folder == "src":
        folder = folder_of(file.relative_to(root / "src"))
        if folder is None:
            yield 1, f"not in a folder of the layer list ({', '.join(LAYERS)})"
            return
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), start=1):
        match = INCLUDE.match(line)
        if not match:
            continue
        bracket, included = match.groups()
        if bracket == "<":
            if NUMERIC.match(included) and folder != "number":
                yield number, f"<{included}> belongs in src/number only"
            continue
        target = folder_of(included)
        base = root if target == "experiments" else root / "src"
        if target is None or not (base / included).is_file():
            yield number, f'"{included}" is no file: write "folder/name.hpp" from src or experiments'
        elif LAYERS.index(target) > LAYERS.index(folder):
            yield number, f"{folder} must not include {included}: {target} is above it"


def main():
    root = Path(__file__).resolve().parent.parent
    files = [
        file
        for top in ("src", "experiments")
        for file in sorted((root / top).rglob("*"))
        if file.suffix in {".hpp", ".ipp", ".cpp"}
    ]
    count = 0
    for file in files:
        for number, message in violations(root, file):
            print(f"{file.relative_to(root)}:{number}: {message}")
            count += 1
    print(f"{len(files)} files, {count} violations", file=sys.stderr)
    return 1 if count or not files else 0


if __name__ == "__main__":
    sys.exit(main())
