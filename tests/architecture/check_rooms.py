#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds the arrows between the rooms: reads every #include and every link line of sdk/, host/, plugins/ and
league/.

    check_rooms.py ROOT

One line per violation, "file:line: includes X; room Y may not know Z". Tests may include anything: those in tests/ and
benchmarks/ are not read, nor are files named test*, *_test or *_benchmark beside a plugin.
"""
import posixpath
import re
import sys
from pathlib import Path

from rooms import (C_HEADERS, CHECKS_PLUGINS, CONFINED, HOST_SEES_EXTENSIONS, HOST_SEES_OF_SDK, KNOWS, LEAGUE_KNOWS,
                   PLUGINS_KNOW, SHARED_BY_A_KIND, TESTKIT)

SOURCES = {".h", ".hpp", ".hh", ".c", ".cc", ".cpp", ".inl", ".ipp", ".in"}
TEST = re.compile(r"(test|test_.*|tests|.*_test|.*_benchmark|benchmark.*)\.[a-z]+$")
# Comments and raw strings are blanked; ordinary literals are matched so that a // inside of one is not a comment.
BLANKED = re.compile(r'R"([^()\\\s]{0,16})\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*(?:include|include_next|import)\b[ \t]*([<"]?)([^>"\n]*)', re.M)
COMMAND = re.compile(r"(\w+)\s*\(([^()]*)\)")
NOT_A_LINK = {"add_test", "set_tests_properties", "gtest_discover_tests", "message"}


def room_of(path):
    """The part of the house that a file is in: a room of host/, "sdk", plugins/<kind>/<name> or league/<kind>/<name>, or
    plugins/<kind> for what the plugins of a kind share; None elsewhere."""
    parts = path.split("/")
    if parts[0] == "host" and len(parts) > 2:
        return parts[1]
    if parts[0] in ("plugins", "league") and len(parts) > 2:
        return "/".join(parts[:min(3, len(parts) - 1)])
    return "sdk" if parts[0] == "sdk" else None


def without_comments(text):
    def blank(match):
        literal = match[0]
        return literal if literal[0] in "\"'" else re.sub(r"[^\n]", " ", literal)
    return BLANKED.sub(blank, text)


def includes(text):
    """(line, quoted, target) of every include; target is "" where a macro names it."""
    code = without_comments(text)
    for match in INCLUDE.finditer(code):
        line = code.count("\n", 0, match.start()) + 1
        yield line, match[1] == '"', match[2].strip() if match[1] else ""


def destination(root, path, target, quoted):
    """The path in the tree that an include means, or None for something from outside of the tree."""
    beside = posixpath.normpath(posixpath.join(posixpath.dirname(path), target))
    if quoted and (root / beside).is_file():
        return beside
    if target.startswith("../"):
        return beside
    first = target.split("/")[0]
    if first in KNOWS and "/" in target:
        return "host/" + target
    if first in ("host", "plugins", "league", "sdk") and "/" in target:
        return target
    if first == "regista":
        return "sdk/include/" + target
    return None


def confined(path, names, name):
    """Why a library must not be known at `path`, or None."""
    for library in CONFINED:
        if not any(name.startswith(n) if n.endswith("/") else name == n for n in names(library)):
            continue
        if not path.startswith(library.place):
            return library.name
        if library.sources_only and path.endswith((".h", ".hpp", ".hh", ".inl", ".ipp")):
            return f"{library.name} outside of .cpp files"
        if library.only_file and not path.endswith("CMakeLists.txt") and path != library.only_file:
            return f"{library.name} outside of {library.only_file}"
    return None


def stranger(root, path, target, quoted):
    """What the file at `path` must not know but includes, or None."""
    room = room_of(path)
    library = confined(path, lambda l: l.headers, target)
    if library:
        return library
    found = destination(root, path, target, quoted)
    if path.startswith("host/"):
        if found is None:
            return None
        if found.startswith("sdk/"):
            if "sdk" not in KNOWS[room]:
                return "sdk"
            seen = found.removeprefix("sdk/include/")
            known = seen == HOST_SEES_OF_SDK or seen.startswith(HOST_SEES_EXTENSIONS) or (
                room == CHECKS_PLUGINS and seen.startswith(TESTKIT))
            return None if known else f"more of sdk than {HOST_SEES_OF_SDK} and {HOST_SEES_EXTENSIONS}"
        other = room_of(found)
        return None if other == room or other in KNOWS[room] else other or posixpath.dirname(found)
    if path.startswith(("plugins/", "league/")):
        if found is None:
            return "it by quotes, which are for its own files" if quoted else None
        kind = "/".join(room.split("/")[:2])
        other = room_of(found)
        own = found.startswith("sdk/include/regista/") or other in (room, kind) or other in PLUGINS_KNOW.get(room, ()) or (
            other in SHARED_BY_A_KIND and other.startswith(kind + "/")) or (
            path.startswith("league/") and not quoted and found.startswith(LEAGUE_KNOWS))
        return None if own else room_of(found) or posixpath.dirname(found)
    # sdk: author's headers know the standard library and each other; the testkit also GoogleTest and what it likes
    # from outside of the tree.
    if found is not None and not found.startswith("sdk/"):
        return room_of(found) or posixpath.dirname(found)
    if path.startswith("sdk/include/"):
        if found is not None and not found.startswith("sdk/include/"):
            return posixpath.dirname(found)
        if found is None and not (re.fullmatch(r"[a-z_0-9]+", target) or target in C_HEADERS):
            return target + ", which is not of the standard library"
    return None


def linked(path, text):
    """(line, token, room or library that `path` must not link) of every such token of a build file."""
    room = room_of(path)
    allowed = KNOWS.get(room, set()) | {room} if path.startswith("host/") else {"sdk", "testkit"}
    if room == CHECKS_PLUGINS:
        allowed = allowed | {"testkit"}
    code = re.sub(r"#[^\n]*", lambda m: " " * len(m[0]), text)
    for command in COMMAND.finditer(code):
        if command[1] in NOT_A_LINK or command[2].split()[:1] and command[2].split()[0].startswith("test_"):
            continue
        for token in re.finditer(r'[^\s;"]+', command[2]):
            line = code.count("\n", 0, command.start(2) + token.start()) + 1
            name = re.fullmatch(r"regista(?:_|::)(\w+)", token[0])
            other = name[1] if name and (name[1] in KNOWS or name[1] in ("sdk", "testkit")) else None
            if other and other not in allowed:
                yield line, token[0], other
            library = confined(path, lambda l: l.targets, token[0])
            if library:
                yield line, token[0], library


def violations(root):
    root = Path(root)
    for file in sorted(f for part in ("sdk", "host", "plugins", "league") for f in (root / part).rglob("*") if f.is_file()):
        path = file.relative_to(root).as_posix()
        if TEST.match(file.name) or "/test/" in path or "/tests/" in path:
            continue
        room = room_of(path)
        if path.startswith("host/") and file.suffix in SOURCES | {".txt"} and path != "host/CMakeLists.txt" and (
                room not in KNOWS):
            yield f"{path}:1: stands in no room; the rooms are {', '.join(KNOWS)}"
        elif file.suffix in SOURCES:
            text = file.read_text(encoding="utf-8", errors="replace")
            for line, quoted, target in includes(text):
                if not target:
                    yield f"{path}:{line}: includes what a macro names; write the header's name"
                    continue
                other = stranger(root, path, target, quoted)
                if other:
                    yield f"{path}:{line}: includes {target}; room {room} may not know {other}"
        elif room and file.name == "CMakeLists.txt":
            for line, token, other in linked(path, file.read_text(encoding="utf-8")):
                yield f"{path}:{line}: links {token}; room {room} may not know {other}"


def main(arguments):
    if len(arguments) != 1 or not (Path(arguments[0]) / "sdk/include/regista/abi.h").is_file():
        print("usage: check_rooms.py ROOT, the folder that holds sdk, host and plugins")
        return 2
    lines = list(violations(arguments[0]))
    print("\n".join(lines) if lines else "no room knows more than it may")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
