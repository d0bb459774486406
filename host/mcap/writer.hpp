// SPDX-License-Identifier: MIT
// Writes an MCAP file (https://mcap.dev/spec) while its messages arise: chunks with checksums and message indexes, and
// at the end the summary that lets readers find everything without reading all of it. Foxglove, Lichtblick, Rerun and
// the official libraries open such files.
//
//   mcap::Writer writer("match.mcap", {.library = "regista 0.1.0"});
//   const auto schema = writer.add_schema("truth", "jsonschema", text);
//   const auto truth = writer.add_channel("/truth", "json", schema);
//   writer.write({.channel = truth, .sequence = 0, .log_time = 0, .publish_time = 0, .data = R"({"ball": [0, 0]})"});
//   writer.close();
//
// In memory stands one chunk, plain and compressed (two with a background), and about 100 bytes of index for every
// chunk written. A finished chunk is with the kernel (with a background: soon): a process that dies leaves a file whose
// chunks can all be read; so does a writer that is destroyed without close(). The bytes of the file depend on the calls
// and the version of zstd alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mcap/background.hpp"
#include "mcap/compression.hpp"
#include "mcap/encode.hpp"
#include "mcap/output_file.hpp"
#include "mcap/records.hpp"

namespace regista::mcap {

struct WriterOptions {
  std::string library = "regista";
  std::size_t chunk_size = std::size_t{256} << 10;  // bytes; the message that reaches it ends the chunk; at most 16 MiB
  bool replace = false;                             // a file of this name, instead of refusing it
  // Finished chunks are compressed and written by a thread of their own. Failures are then told a chunk later; the
  // bytes of the file are the same.
  bool background = false;
};

class Writer {
 public:
  // Every function throws Error when the file cannot be written (a full disk), from then on always, or when what it is
  // given cannot stand in an MCAP file: text that is not UTF-8, an item above 32 MiB, more than 65535 schemas or
  // channels. The latter leave the writer as it was.
  explicit Writer(const std::filesystem::path& file, const WriterOptions& options = {});
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  SchemaId add_schema(std::string_view name, std::string_view encoding, std::string_view data);
  // `schema` is one of this writer, or none.
  ChannelId add_channel(std::string_view topic, std::string_view message_encoding, SchemaId schema = SchemaId::none);
  // Messages may come in any order of time; readers are fastest when times rise.
  void write(const Message& message);
  void write(const Metadata& metadata);  // at once, outside of chunks

  // Ends the chunk before it is full, so that the file holds all that has been written so far; with a background: as
  // soon as that has come to it.
  void finish_chunk();
  // Ends the file with its summary. Nothing can be written afterwards; a second close() does nothing.
  void close();

 private:
  void check_open();
  void settle();  // waits for the background
  void check_text(std::string_view what, std::string_view text) const;
  void check_size(std::string_view what, std::size_t bytes) const;
  std::string summary() const;

  OutputFile file_;
  std::size_t chunk_size_;
  Compressor compressor_;

  struct Chunk {
    std::string records;
    std::vector<std::vector<MessagePlace>> places;  // by channel
    std::size_t messages = 0;
    std::uint64_t first_time = 0, last_time = 0;
  };
  void store(Chunk& chunk);  // in the file, and empties it
  Chunk filling_;
  Chunk finished_;     // in the background
  std::string bytes_;  // of the last chunk as they went to the file

  // Of the file.
  std::vector<Schema> schemas_;    // identifiers count from 1
  std::vector<Channel> channels_;  // likewise
  std::vector<ChunkIndex> chunks_;
  std::vector<MetadataIndex> metadata_;
  Statistics statistics_;
  bool closed_ = false;
  std::optional<Background> background_;  // last: it uses the others
};

}  // namespace regista::mcap
