#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Messages are plain English: no text that a user sees has the words that CONTRIBUTING.md forbids.

    check_words.py ROOT

It reads the string literals of C++ and TypeScript, and of pages all but fences and backticks. One line per violation: the
place, the words and what to write instead. A new kind of bad sentence goes into both lists.
"""
import re
import sys
from pathlib import Path

# What a text must not have, as an expression, and what to write instead. Each is a kind of the list in CONTRIBUTING.md.
FORBIDDEN = [(re.compile(rf"\b(?:{words})\b", re.I), instead) for words, instead in (
    (r"nought", "zero"),
    (r"(?:number|list|text|file|value|name) is wanted|wanted is", "expected"),
    (r"nothing more stands there|stands there; (?:expected|wanted)", "the line ends; expected ..."),
    (r"stands? there (?:twice|again)", "is given twice"),
    (r"is one word too many", "unexpected argument"),
    (r"(?:is|are|was|were|be|been)(?: not| never)? told(?! apart)", "reported, stored or shown"),
    (r"whoever", "the team, the robot or the reader that is meant"),
    (r"(?<=[.;] )who (?:has|holds|hears|needs|takes|shares|waits|changes|stands|stood|comes)(?=[^.;?]+[.;])",
     "a robot that, a plugin that, a reader that"),
    (r"of wh(?:om|ich) (?:the news|no|nothing)", "whose ..., without ..."),
    (r"who goes on with it", "you are asked to go on"),
    (r"what of the", "which part of the, which of the"),
    (r"whatever came of|what came of (?!it\?)", "the result, whatever the result"),
    (r"however (?:often|many|long)", "any number of, at any length"),
    (r"of before", "earlier"),
    (r"a \w+ more needs", "a new ... needs"),
    (r"(?<!there )(?<!\d )is none(?! of (?:its|the|them|these))|is none of Regista's", "is not a ..."),
    (r"that there is none", "there may still be a smaller difference"),
    (r"nobody can be blamed|blames? nobody|is nobody's", "no team is to blame"),
    (r"(?:a|the|this) deaths?|deaths over", "failure"),
    (r"does not come back", "cannot be reproduced"),
    (r"nobody has chosen", "held-out"),
    (r"promised nothing", "is no evidence"),
    (r"the innocent", "the other team"),
    (r"the harmful one", "the harmful weight"),
    (r"worth less by", "that the test found worse"),
    (r"in which nothing stands", "empty"),
)]

CODE = {".cpp", ".hpp", ".h", ".ts"}
FOLDERS = ("host", "plugins", "league", "sdk", "viewer/src")
# A comment, a raw string, a string, a template, the mark within a long number, a character. What comes first counts.
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\((?P<raw>.*?)\)\1"|"(?P<text>(?:\\.|[^"\\\n])*)"|`(?P<template>(?:\\.|[^`\\])*)`'
                   r"|(?<=\d)'(?=\d)|'(?:\\.|[^'\\\n])+'", re.S)
FENCE = re.compile(r"^```.*?^```|`[^`\n]*`", re.M | re.S)


def texts_of_code(source):
    """(offset, text): neighbouring string literals are one text, as for the compiler."""
    begun, end, whole = 0, -1, ""
    for token in TOKEN.finditer(source):
        text = next((token[name] for name in ("raw", "text", "template") if token[name] is not None), None)
        if text is None:
            continue
        if end >= 0 and source[end:token.start()].strip() == "":
            whole += text
        else:
            yield begun, whole
            begun, whole = token.start(), text
        end = token.end()
    yield begun, whole


def texts_of_page(source):
    """(offset, line). Code is blanked, so that offsets stay."""
    blanked = FENCE.sub(lambda code: re.sub(r"[^\n]", " ", code[0]), source)
    offset = 0
    for line in blanked.splitlines(keepends=True):
        yield offset, line
        offset += len(line)


def violations(root):
    root = Path(root)
    files = [file for folder in FOLDERS for file in (root / folder).rglob("*")
             if file.suffix in CODE and "test" not in file.name]
    pages = [root / "README.md", *(root / "docs").glob("*.md")]
    for file in sorted(files) + sorted(pages):
        source = file.read_text(encoding="utf-8", errors="replace")
        for offset, text in (texts_of_page if file.suffix == ".md" else texts_of_code)(source):
            for words, instead in FORBIDDEN:
                if found := words.search(text):
                    line = source.count("\n", 0, offset) + 1
                    yield f'{file.relative_to(root)}:{line}: "{found[0]}"; write: {instead}'


def main(arguments):
    if len(arguments) != 1:
        print("usage: check_words.py ROOT")
        return 2
    lines = list(violations(arguments[0]))
    print("\n".join(lines) if lines else "no text has a word that CONTRIBUTING.md forbids")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
