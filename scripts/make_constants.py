#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: the page of tuning constants, room by room, from the comments
# that stand at them.
#
# usage: make_constants.py [--check]     --check says what the page or a comment lacks

import csv
import glob
import os
import re
import sys

PAGE = "doc/constants.md"
MEASURED = "doc/constants.csv"
HEAD = """# Tuning constants

Made by `scripts/make_constants.py` from the comments in the sources: every number of the two
libraries that was chosen rather than given, by room. What users choose is in the parameter headers
instead. Lengths are in the unit that the comment names; where it names none, a number is a count or
a share. Sentinels and sizes of registers are left out.

The column *half, twice* says how many of 13 results differ when a value is halved and doubled: a
femur and a woman's body, reconstructed from their points, and repaired after damage by slabs, balls
and patches; five meshes with holes, repaired as they are. Measured by `scripts/measure_constants.py`
and shown as long as the value stays. `0, 0` is no proof that a number does not matter: it may stand
for other input, or only for time.
"""
CONSTANT = re.compile(
    r"\s*(?:static |inline )*constexpr (?:std::array<[^>]*>|[\w:]+(?: int)?)\s+"
    r"([A-Z][A-Z0-9_]*) = ?([^;]*);\s*(?:(?://|/\*\*<)\s*(.*?)(?:\*/)?)?\s*$")
NO_TUNING = re.compile(r"numeric_limits|NONE|epsilon|sizeof|0x|^-\d+$|[A-Za-z]{3}")
SENTINEL = re.compile(r"^NO_|^NOWHERE|^UNDECIDED$|^NEXT$|LANES$|WIDTH$|^STATES$|_FLOATS$|^FAN_OUT$")


def constants_of(path):
    """Name, value and comment of each constant of a file; constants in a row share the
    comment above the first."""
    above, inside = "", False
    for line in open(path, encoding="utf-8"):
        text = line.strip()
        if inside or text.startswith("/**"):
            words = re.sub(r"^(/\*\*|\*(?!/))|\*/$", "", text).replace("\\brief", "").strip()
            above = f"{above} {words}".strip() if inside else words
            inside = not text.endswith("*/")
            continue
        found = CONSTANT.match(line.rstrip("\n"))
        if found is None:
            above = ""
            continue
        name, value, beside = found.groups()
        if not NO_TUNING.search(value) and not SENTINEL.search(name):
            yield name, value, " ".join(filter(None, [above, beside]))


def constants_in(room):
    """File, name, value and comment of each constant of a room."""
    for path in sorted(glob.glob(f"{room}**/*.h", recursive=True) +
                       glob.glob(f"{room}**/*.cpp", recursive=True)):
        for constant in constants_of(path):
            yield path, *constant


def measured():
    """What was measured of constants: by file, name and value."""
    with open(MEASURED, encoding="utf-8") as rows:
        return {tuple(row[:3]): row[3:] for row in csv.reader(rows)}


def rooms():
    return sorted(glob.glob("surface_*/src/*/"))


def page():
    """The text of the page, and the constants that say nothing about themselves."""
    text, silent, known = HEAD, [], measured()
    for room in rooms():
        rows = []
        for path, name, value, comment in constants_in(room):
            if not comment:
                silent.append(f"{path}: {name} has no comment")
            comment = re.sub(r"([|<>])", r"\\\1", comment)
            file = os.path.basename(path)
            differ = ", ".join(known.get((file, name, value), [])[:2])
            rows.append(f"| `{name}` | {value} | {comment} | {differ} | `{file}` |")
        if rows:
            text += f"\n## {room[:-1].replace('/src/', '/')}\n\n"
            text += "| constant | value | what it is | half, twice | in |\n|---|---|---|---|---|\n"
            text += "\n".join(rows) + "\n"
    return text, silent


def main():
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    text, faults = page()
    if "--check" not in sys.argv:
        open(PAGE, "w", encoding="utf-8").write(text)
    elif open(PAGE, encoding="utf-8").read() != text:
        faults.append(f"{PAGE} is out of date: run scripts/make_constants.py")
    print("\n".join(faults), file=sys.stderr, end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
