# SPDX-License-Identifier: MIT
"""Each element of the paper does what docs/fidelity.md says of it: configs/studies/paper_elements.yaml plays the paper's team
whole and without one element after the other, and the measure of each element moves in the direction of the page, with a
95 % interval of the paired difference that excludes zero.

    paper.py PROGRAM SOURCE FOLDER

The results stay in FOLDER, and are gone on with where they ended."""

import json
import pathlib
import re
import sys

import results


def elements(source):
    """Of docs/fidelity.md: name, what switches it off ("path=value" or "test Suite.Name"), measure and direction ("rises" or
    "falls"; both None where the page claims none)."""
    page = (pathlib.Path(source) / "docs" / "fidelity.md").read_text(encoding="utf-8")
    for line in page.split("<!-- elements -->")[1].strip().splitlines()[2:]:
        name, _, _, off, without = (cell.strip() for cell in line.strip("|").split("|"))
        claim = re.match(r"`([\w.]+)` (rises|falls)", without)
        yield name.replace("`", ""), off.replace("`", ""), *(claim.groups() if claim else (None, None))


def differences(study, measure):
    """Of the JSON of an experiment: by arm, what it has more than the whole team, and half of the interval. An arm without a
    value (nobody heard of a teammate) has none."""
    found = next(each for each in study["measures"] if each["measure"] == measure)
    return {each["second"]["arm"]: (-each["mean"], (each["interval"][1] - each["interval"][0]) / 2)
            for each in found["differences"] if each["mean"] is not None and each["interval"] is not None}


def means(study, measure):
    found = next(each for each in study["measures"] if each["measure"] == measure)
    return {each["arm"]: each["mean"] for each in found["conditions"]}


def line(study, arm, measure):
    with_all, without = means(study, measure)["whole"], means(study, measure)[arm]
    difference, half = differences(study, measure)[arm]
    return f"{measure} {with_all:.3g} -> {without:.3g} ({difference:+.3g} ± {half:.2g})"


def shown(study, arm):
    """The two measures that the arm changes most surely."""
    def sureness(measure):
        difference, half = differences(study, measure).get(arm, (0, 0))
        return abs(difference) / half if half > 0 else float("inf") if difference else 0.0
    moved = [each["measure"] for each in study["measures"] if sureness(each["measure"]) > 1]
    return "; ".join(line(study, arm, each) for each in sorted(moved, key=sureness, reverse=True)[:2]) or "nothing is found"


def main(program, source, folder):
    folder = pathlib.Path(folder) / "paper"
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "elements.db"
    study = json.loads(results.played(program, file, [pathlib.Path(source) / "configs/studies/paper_elements.yaml", "--json"],
                                      "experiment"))
    claimed, held = 0, 0
    for name, off, measure, direction in elements(source):
        if off.startswith("test "):
            continue
        if measure is None:
            print(f"{name}: no direction; {shown(study, name)}")
            continue
        difference, half = differences(study, measure)[name]
        holds = (difference > half) if direction == "rises" else (difference < -half)
        claimed += 1
        held += holds
        other = difference < -half if direction == "rises" else difference > half
        verdict = direction if holds else f"{'CONTRADICTED' if other else 'NOT FOUND'}: {direction}"
        print(f"{name}: {line(study, name, measure)}: {verdict}")
    print(f"{held} of {claimed} directions found, {study['pairs']} pairs of matches an arm")
    return 0 if held == claimed else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
