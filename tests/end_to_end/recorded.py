# SPDX-License-Identifier: MIT
"""Reads MCAP files (https://mcap.dev/spec) for the tests: written for them alone, with Debian's zstandard, so that it
shares no mistake with the program. As far as the file goes: what a cut leaves behind is skipped, not guessed."""

import decimal
import io
import itertools
import json
import struct
import zlib

import zstandard

MAGIC = b"\x89MCAP0\r\n"
SCHEMA, CHANNEL, MESSAGE, CHUNK, METADATA, DATA_END, PACKED = 3, 4, 5, 6, 12, 15, 0x80


def _text(data, at):
    size = struct.unpack_from("<I", data, at)[0]
    return data[at + 4:at + 4 + size].decode(), at + 4 + size


def _pairs(data, at):
    end = at + 4 + struct.unpack_from("<I", data, at)[0]
    at += 4
    out = {}
    while at < end:
        key, at = _text(data, at)
        out[key], at = _text(data, at)
    return out


def records(data, at=0):
    """(opcode, content) of every record that is whole."""
    while at + 9 <= len(data):
        opcode, size = struct.unpack_from("<BQ", data, at)
        if at + 9 + size > len(data):
            return
        yield opcode, data[at + 9:at + 9 + size]
        at += 9 + size


def _unpacked(content):
    """[(topic, log time in ns, text)] of a record as a page has it (host/recording/packed_recording.hpp)."""
    size, checksum = struct.unpack_from("<QI", content)
    plain = io.BytesIO(zstandard.ZstdDecompressor().decompress(content[12:], max_output_size=size))
    assert zlib.crc32(plain.getvalue()) == checksum and len(plain.getvalue()) == size

    def whole():
        value = shift = 0
        while True:
            byte = plain.read(1)[0]
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value

    def signed(zigzag):
        return -(zigzag + 1) // 2 if zigzag % 2 else zigzag // 2

    def text():
        return plain.read(whole())

    def sums(count):
        return list(itertools.accumulate(signed(whole()) for _ in range(count)))

    def number(decimals, units):
        exact = f"{decimal.Decimal(units).scaleb(-decimals):f}"
        return (exact.rstrip("0").rstrip(".") if decimals else exact).encode()

    topics = [text().decode() for _ in range(whole())]
    times = sums(whole())
    forms = []
    for _ in range(whole()):
        columns = whole()
        pieces = [text() for _ in range(columns + 1)]
        forms.append((pieces, [whole() for _ in range(columns)], whole()))
    out, without = [None] * len(times), []
    for pieces, decimals, rows in forms:
        places, channels = sums(rows), sums(rows)
        parts = [[pieces[0]] for _ in range(rows)]
        for each, piece in zip(decimals, pieces[1:]):
            units = 0
            for row in parts:
                if (value := whole()) == 0:
                    without.append((row, len(row)))
                else:
                    units += signed(value - 1)
                row += [number(each, units), piece]
        for place, channel, row in zip(places, channels, parts):
            assert out[place] is None
            out[place] = (topics[channel], times[place], row)
    for row, place in without:
        row[place] = text()
    assert plain.read() == b""
    return [(topic, when, b"".join(row)) for topic, when, row in out]


class Recording:
    """messages: [(topic, parsed JSON)] in the order of the file; logged: [(topic, log time in ns, text)] of the same;
    schemas: by topic; about: the metadata "match". A page's recording has no schemas."""

    def __init__(self, data):
        assert data.startswith(MAGIC), data[:8]
        self.messages, self.logged, self.schemas, self.about, self.chunks, self.whole = [], [], {}, {}, 0, False
        self._schemas, self._topics = {}, {}
        for opcode, content in records(data, len(MAGIC)):
            if opcode == CHUNK:
                self.chunks += 1
                self._chunk(content)
            elif opcode == PACKED:
                for topic, when, text in _unpacked(content):
                    self._message(topic, when, text)
            elif opcode == METADATA:
                name, at = _text(content, 0)
                if name == "match":
                    self.about = _pairs(content, at)
            elif opcode == DATA_END:
                self.whole = True
                return

    def _chunk(self, content):
        size = struct.unpack_from("<Q", content, 16)[0]
        compression, at = _text(content, 28)
        assert compression == "zstd", compression
        plain = zstandard.ZstdDecompressor().decompress(content[at + 8:], max_output_size=size)
        assert len(plain) == size
        for opcode, record in records(plain):
            if opcode == SCHEMA:
                number = struct.unpack_from("<H", record)[0]
                _, at = _text(record, 2)
                encoding, at = _text(record, at)
                assert encoding == "jsonschema", encoding
                text, _ = _text(record, at)
                self._schemas[number] = json.loads(text)
            elif opcode == CHANNEL:
                number, schema = struct.unpack_from("<HH", record)
                topic, _ = _text(record, 4)
                self._topics[number] = topic
                self.schemas[topic] = self._schemas[schema]
            elif opcode == MESSAGE:
                channel, _, log_time, publish_time = struct.unpack_from("<HIQQ", record)
                assert log_time == publish_time
                self._message(self._topics[channel], log_time, record[22:])

    def _message(self, topic, log_time, text):
        message = json.loads(text)
        assert abs(log_time / 1e9 - message["time"]) < 0.0006, message
        self.messages.append((topic, message))
        self.logged.append((topic, log_time, text))

    def of(self, topic):
        return [message for each, message in self.messages if each == topic]


def read(path):
    with io.open(path, "rb") as file:
        return Recording(file.read())
