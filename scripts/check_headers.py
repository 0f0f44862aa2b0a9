#!/usr/bin/env python3
"""Compiles each header of src/ and experiments/ alone, with the flags of a build folder:

    scripts/check_headers.py build/release

Prints the compiler's messages. Headers that include number/traits.hpp or number/rational.hpp,
directly or not, share a precompiled header of its Boost includes, which they begin with anyway:
that is where most of the time would go."""

import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
# The more of them first: a header takes the first one that it reaches.
SHARED = {
    "number/traits.hpp": ("cpp_bin_float", "gmp", "mpfr"),
    "number/rational.hpp": ("gmp",),
}


def flags_of(build):
    """The flags of a file of the program, which sees every include folder, without its output."""
    commands = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    words = next(shlex.split(c["command"]) for c in commands if c["file"].endswith("cli/main.cpp"))
    words = words[: words.index("-o")]
    if "-include" in words:  # the program's own precompiled header
        at = words.index("-include")
        del words[at : at + 2]
    return [word for word in words if word not in ("-Winvalid-pch", "-fpch-instantiate-templates")]


def path_of(included):
    return next((p for p in (ROOT / "src" / included, ROOT / included) if p.is_file()), None)


def reaches(header, target, seen):
    """Does the header include the target, directly or not?"""
    seen.add(header)
    for included in INCLUDE.findall(header.read_text(encoding="utf-8")):
        file = path_of(included)
        if included == target or (file and file not in seen and reaches(file, target, seen)):
            return True
    return False


def main():
    flags = flags_of(Path(sys.argv[1]))
    headers = sorted(h for top in ("src", "experiments") for h in (ROOT / top).rglob("*.hpp"))
    with tempfile.TemporaryDirectory() as folder:
        precompiled = {}
        for header, includes in SHARED.items():
            file = Path(folder) / header.replace("/", "_")
            file.write_text(
                "".join(f"#include <boost/multiprecision/{name}.hpp>\n" for name in includes),
                encoding="utf-8",
            )
            subprocess.run([*flags, "-x", "c++-header", file, "-o", f"{file}.gch"], check=True)
            precompiled[header] = file

        def errors_in(header):
            alone = Path(folder) / ("_".join(header.relative_to(ROOT).parts) + ".cpp")
            alone.write_text(f'#include "{header}"\n', encoding="utf-8")
            shared = next((file for name, file in precompiled.items()
                           if header == path_of(name) or reaches(header, name, set())), None)
            prefix = ["-include", shared] if shared else []
            command = [*flags, *prefix, "-fsyntax-only", alone]
            return subprocess.run(command, capture_output=True, text=True).stderr

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            messages = [message for message in pool.map(errors_in, headers) if message]
    print("".join(messages), end="")
    print(f"{len(headers)} headers, {len(messages)} with messages")
    return 1 if messages else 0


if __name__ == "__main__":
    sys.exit(main())
