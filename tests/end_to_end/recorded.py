# SPDX-License-Identifier: MIT
"""Reads MCAP files (https://mcap.dev/spec) for the tests: written for them alone, with Debian's zstandard, so that it
shares no mistake with the program. As far as the file goes: what a cut leaves behind is skipped, not guessed."""

import io
import json
import struct

import zstandard

MAGIC = b"\x89MCAP0\r\n"
SCHEMA, CHANNEL, MESSAGE, CHUNK, METADATA, DATA_END = 3, 4, 5, 6, 12, 15


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


class Recording:
    """messages: [(topic, parsed JSON)] in the order of the file; schemas: by topic; about: the metadata "match"."""

    def __init__(self, data):
        assert data.startswith(MAGIC), data[:8]
        self.messages, self.schemas, self.about, self.chunks, self.whole = [], {}, {}, 0, False
        self._schemas, self._topics = {}, {}
        for opcode, content in records(data, len(MAGIC)):
            if opcode == CHUNK:
                self.chunks += 1
                self._chunk(content)
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
                message = json.loads(record[22:])
                assert log_time == publish_time and abs(log_time / 1e9 - message["time"]) < 0.0006, message
                self.messages.append((self._topics[channel], message))

    def of(self, topic):
        return [message for each, message in self.messages if each == topic]


def read(path):
    with io.open(path, "rb") as file:
        return Recording(file.read())
