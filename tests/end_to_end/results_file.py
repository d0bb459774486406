# SPDX-License-Identifier: MIT
"""Reads files of results as docs/results.md describes them, and mends their checksums: written for the tests alone, so
that it shares no mistake with the program."""

import json
import struct
import zlib

import zstandard

SIDES = ("home", "away")


def _leb128(data):
    while data:
        number, shift = 0, 0
        while True:
            byte = data.pop(0)
            number |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                break
        if number == 0:
            yield None
        elif number == 1:
            yield struct.unpack("<d", bytes(data[:8]))[0]
            del data[:8]
        else:
            number -= 2
            yield (-(number + 1) // 2 if number % 2 else number // 2) / 1e6


def numbers(frame, size):
    plain = zstandard.ZstdDecompressor().decompress(frame, max_output_size=size)
    assert len(plain) == size
    return list(_leb128(bytearray(plain)))


def as_json(names, values):
    """The numbers as `regista match --json` has them: those of sides in lists of two."""
    assert len(names) == len(values)
    out = {}
    for name, value in zip(names, values):
        parts = name["name"].split(".")
        if "side" not in name:
            out[name["name"]] = value
            continue
        if "role" in name:
            parts = ["roles", name["role"], name["name"]]
        place = out.setdefault(parts[0], [{}, {}] if len(parts) > 1 else [None, None])
        key = SIDES.index(name["side"])
        for part in parts[1:]:
            place = place[key] if isinstance(place, list) else place.setdefault(key, {})
            key = part
        if "place" not in name:
            place[key] = value
            continue
        if isinstance(place, list) and place[key] is None:
            place[key] = []
        elements = place[key] if isinstance(place, list) else place.setdefault(key, [])
        assert len(elements) == name["place"] - 1
        elements.append(value)
    return out


def metrics(database):
    """By row, in their order."""
    names = {number: json.loads(text) for number, text in database.execute("SELECT id, names FROM metric_names")}
    return {row: as_json(names[number], numbers(frame, size)) for row, number, size, frame in
            database.execute("SELECT row, names, size, numbers FROM metrics ORDER BY row")}


def checksum(*columns):
    out = 0
    for column in columns:
        if isinstance(column, int):
            line = f"{column}\n".encode()
        elif isinstance(column, float):
            line = f"{struct.unpack('<Q', struct.pack('<d', column))[0]:016x}\n".encode()
        else:
            data = column.encode() if isinstance(column, str) else column or b""
            line = f"{len(data)} ".encode() + data + b"\n"
        out = zlib.crc32(line, out)
    return out


TABLES = {"meta": ("name", ("name", "value")),
          "fixtures": ("id", ("key", "job")),
          "matches": ("row", ("row", "fixture", "seed", "home_goals", "away_goals", "ended", "hash", "failure",
                              "seconds", "attempts")),
          "metric_names": ("id", ("names",)),
          "metrics": ("row", ("row", "names", "size", "numbers")),
          "packets": ("row", ("row", "numbers")),
          "remarks": ("row, kind", ("row", "kind", "text"))}


def unfit(database):
    """Rows whose checksum does not fit: [(table, key...)]."""
    out = []
    for table, (key, columns) in TABLES.items():
        for *keys, wanted in database.execute(f"SELECT {key}, checksum FROM {table}"):
            row = database.execute(f"SELECT {', '.join(columns)} FROM {table} WHERE ({key}) = "
                                   f"({', '.join('?' * len(keys))})", keys).fetchone()
            if checksum(*row) != wanted:
                out.append((table, *keys))
    return out


def mend(database):
    """Makes every checksum fit what stands in its row."""
    for table, *keys in unfit(database):
        key, columns = TABLES[table]
        where = f"WHERE ({key}) = ({', '.join('?' * len(keys))})"
        row = database.execute(f"SELECT {', '.join(columns)} FROM {table} {where}", keys).fetchone()
        database.execute(f"UPDATE {table} SET checksum = ? {where}", (checksum(*row), *keys))
