// SPDX-License-Identifier: MIT
// What host/mcap writes, read by @mcap/core as a stream and through the index, every checksum compared:
//   node official_reader.mjs WRITE_MCAP_EXAMPLES
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import crc from "@foxglove/crc";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { loadDecompressHandlers } from "@mcap/support";

const hex = (bytes) => Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength).toString("hex");
const schemaOf = (record) => ({ id: record.id, name: record.name, encoding: record.encoding, data: hex(record.data) });
const channelOf = (record) => ({
  id: record.id,
  schema: record.schemaId,
  topic: record.topic,
  encoding: record.messageEncoding,
});
const metadataOf = (record) => ({ name: record.name, pairs: Object.fromEntries(record.metadata) });
const messageOf = (record) => ({
  channel: record.channelId,
  sequence: record.sequence,
  log_time: String(record.logTime),
  publish_time: String(record.publishTime),
  data: hex(record.data),
});

const decompressHandlers = await loadDecompressHandlers();

// Bytes of a file in memory, as the indexed reader asks for them; it may keep none of them beyond the next call.
function readableOf(bytes) {
  return {
    size: async () => BigInt(bytes.length),
    read: async (offset, length) => {
      assert(offset + length <= BigInt(bytes.length), `asked for ${length} bytes at ${offset}`);
      return new Uint8Array(bytes.subarray(Number(offset), Number(offset + length)));
    },
  };
}

function readAsStream(bytes) {
  const reader = new McapStreamReader({ includeChunks: true, decompressHandlers, validateCrcs: true });
  const records = [];
  // In small pieces, as from a network.
  for (let at = 0; at < bytes.length; at += 1000) {
    reader.append(new Uint8Array(bytes.subarray(at, at + 1000)));
    for (let record; (record = reader.nextRecord()) != undefined; ) {
      records.push(record);
    }
  }
  return { records, done: reader.done() };
}

const all = (records, type) => records.filter((record) => record.type === type);

// Where each record outside of chunks stands, straight from the bytes.
function placesOf(bytes) {
  const places = [];
  for (let at = 8; at < bytes.length - 8; ) {
    const length = 9 + Number(bytes.readBigUInt64LE(at + 1));
    places.push({ opcode: bytes[at], offset: at, length });
    at += length;
  }
  return places;
}

function byTime(messages) {
  const later = (a, b) => Number(BigInt(a.log_time) > BigInt(b.log_time));
  const order = (a, b) => later(a, b) - later(b, a);
  return [...messages].sort(order);  // stable: messages of one time keep the file's order
}

function checkStream(records, expected) {
  const data = records.slice(0, records.findIndex((record) => record.type === "DataEnd"));
  const whole = data.length > 0 && records.some((record) => record.type === "DataEnd");
  const written = whole ? data : records;
  const header = all(records, "Header");
  assert.equal(header.length, 1);
  assert.deepEqual([header[0].profile, header[0].library], ["", expected.library]);
  assert.deepEqual(all(written, "Schema").map(schemaOf), expected.schemas);
  assert.deepEqual(all(written, "Channel").map(channelOf), expected.channels);
  assert.deepEqual(all(written, "Message").map(messageOf), expected.messages);
  assert.deepEqual(all(written, "Metadata").map(metadataOf), expected.metadata);
  assert(all(written, "Chunk").every((chunk) => chunk.compression === "zstd"));
  assert.equal(all(records, "Unknown").length, 0);
}

// The summary against the places and records that stand in the file.
function checkSummary(bytes, records, expected) {
  const places = placesOf(bytes);
  const at = (opcode) => places.filter((place) => place.opcode === opcode);
  const dataEnd = at(0x0f)[0].offset;
  const inData = (place) => place.offset < dataEnd;

  const chunks = at(0x06);
  const chunkRecords = all(records, "Chunk");
  const indexes = all(records, "ChunkIndex");
  assert.equal(indexes.length, chunks.length);
  for (const [i, index] of indexes.entries()) {
    assert.equal(index.chunkStartOffset, BigInt(chunks[i].offset));
    assert.equal(index.chunkLength, BigInt(chunks[i].length));
    assert.equal(index.compressedSize, BigInt(chunkRecords[i].records.byteLength));
    for (const field of ["messageStartTime", "messageEndTime", "uncompressedSize", "compression"]) {
      assert.equal(index[field], chunkRecords[i][field]);
    }
    assert.notEqual(chunkRecords[i].uncompressedCrc, 0);
    const end = chunks[i].offset + chunks[i].length;
    const past = end + Number(index.messageIndexLength);
    const after = at(0x07).filter((place) => place.offset >= end && place.offset < past);
    assert.deepEqual([...index.messageIndexOffsets.values()], after.map((place) => BigInt(place.offset)));
    assert.equal(after.reduce((sum, place) => sum + place.length, 0), Number(index.messageIndexLength));
  }
  const stored = all(records, "MetadataIndex").map((index) => [Number(index.offset), Number(index.length)]);
  assert.deepEqual(stored, at(0x0c).filter(inData).map((place) => [place.offset, place.length]));

  const statistics = all(records, "Statistics");
  assert.equal(statistics.length, 1);
  const times = byTime(expected.messages).map((message) => BigInt(message.log_time));
  const counts = new Map();
  for (const { channel } of [...expected.messages].sort((a, b) => a.channel - b.channel)) {
    counts.set(channel, (counts.get(channel) ?? 0n) + 1n);
  }
  assert.deepEqual(statistics[0], {
    type: "Statistics",
    messageCount: BigInt(expected.messages.length),
    schemaCount: expected.schemas.length,
    channelCount: expected.channels.length,
    attachmentCount: 0,
    metadataCount: expected.metadata.length,
    chunkCount: chunks.length,
    messageStartTime: times[0] ?? 0n,
    messageEndTime: times.at(-1) ?? 0n,
    channelMessageCounts: counts,
  });

  // Summary offsets: each group is exactly the records of its kind.
  const footer = all(records, "Footer")[0];
  const summary = places.filter((place) => place.offset >= Number(footer.summaryStart) && place.opcode !== 0x02);
  const groups = new Map();
  for (const { opcode, offset, length } of summary.filter((place) => place.opcode !== 0x0e)) {
    const group = groups.get(opcode) ?? { start: offset, length: 0 };
    assert.equal(group.start + group.length, offset, "records of one kind stand together");
    groups.set(opcode, { start: group.start, length: group.length + length });
  }
  const offsets = all(records, "SummaryOffset");
  assert.equal(footer.summaryOffsetStart, BigInt(summary.find((place) => place.opcode === 0x0e).offset));
  assert.deepEqual(
    new Map(offsets.map((o) => [o.groupOpcode, { start: Number(o.groupStart), length: Number(o.groupLength) }])),
    groups,
  );

  assert.equal(all(records, "DataEnd")[0].dataSectionCrc, crc.crc32(new Uint8Array(bytes.subarray(0, dataEnd))));
  assert.notEqual(footer.summaryCrc, 0);
}

async function checkIndexed(bytes, expected) {
  const reader = await McapIndexedReader.Initialize({ readable: readableOf(bytes), decompressHandlers });
  assert.deepEqual([...reader.schemasById.values()].map(schemaOf), expected.schemas);
  assert.deepEqual([...reader.channelsById.values()].map(channelOf), expected.channels);
  const collect = async (generator, convert) => {
    const found = [];
    for await (const record of generator) {
      found.push(convert(record));
    }
    return found;
  };
  assert.deepEqual(await collect(reader.readMessages({ validateCrcs: true }), messageOf), byTime(expected.messages));
  for (const { id, topic } of expected.channels) {
    const wanted = byTime(expected.messages.filter((message) => message.channel === id));
    assert.deepEqual(await collect(reader.readMessages({ topics: [topic], validateCrcs: true }), messageOf), wanted);
  }
  assert.deepEqual(await collect(reader.readMetadata(), metadataOf), expected.metadata);
}

const folder = mkdtempSync(join(tmpdir(), "regista-mcap-"));
try {
  execFileSync(process.argv[2], [folder], { stdio: "inherit" });
  const names = readdirSync(folder).filter((name) => name.endsWith(".mcap"));
  assert(names.length >= 8);
  for (const name of names) {
    const bytes = readFileSync(join(folder, name));
    const expected = JSON.parse(readFileSync(join(folder, name.replace(".mcap", ".json")), "utf8"));
    const { records, done } = readAsStream(bytes);
    checkStream(records, expected);
    const finished = name !== "unfinished.mcap";
    assert.equal(done, finished);
    if (finished) {
      checkSummary(bytes, records, expected);
      await checkIndexed(bytes, expected);
    }
    console.log(`${name}: ${bytes.length} bytes, ${expected.messages.length} messages as written`);
  }
  // The check can fail: one byte of a chunk's checksum changed, and the official reader refuses the file.
  const changed = readFileSync(join(folder, "small_chunks.mcap"));
  changed[placesOf(changed).find(({ opcode }) => opcode === 0x06).offset + 9 + 24] ^= 1;
  assert.throws(() => readAsStream(changed), /CRC/);
} finally {
  rmSync(folder, { recursive: true });
}
