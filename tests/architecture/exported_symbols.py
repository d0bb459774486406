#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that each shared object exports one symbol, regista_plugin_entry, and nothing else.

    exported_symbols.py FILE_OR_FOLDER...

A second symbol would be shared between plugins, or taken from one by another: hidden visibility alone leaves weak
symbols of the standard library and of templates visible (a plugin with CGAL: 107 of them). Of a folder, every *.so is
checked. One line per violation; no shared object at all is a violation too.
"""
import subprocess
import sys
from pathlib import Path

ENTRY = "regista_plugin_entry"


def exported(file):
    listing = subprocess.run(["nm", "-D", "--defined-only", "--format=posix", str(file)],
                             capture_output=True, text=True)
    if listing.returncode:
        raise ValueError(listing.stderr.strip() or "nm cannot read it")
    return [tuple(line.split()[:2]) for line in listing.stdout.splitlines() if line.strip()]


def violations(file):
    try:
        symbols = exported(file)
    except ValueError as problem:
        return [f"{file}: {problem}"]
    found = [f"{file}: exports {name} ({kind}); a plugin exports {ENTRY} alone"
             for name, kind in symbols if name != ENTRY]
    if (ENTRY, "T") not in symbols:
        found.append(f"{file}: does not export the function {ENTRY}")
    return found


def main(arguments):
    files = []
    for argument in map(Path, arguments):
        files += sorted(argument.glob("*.so")) if argument.is_dir() else [argument]
    files = list(dict.fromkeys(files))
    if not files:
        print("no shared object to check in: " + " ".join(arguments))
        return 1
    lines = [line for file in files for line in violations(file)]
    print("\n".join(lines) if lines else f"{len(files)} shared objects export {ENTRY} alone")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
