// SPDX-License-Identifier: MIT
// Writes an MCAP file (https://mcap.dev/spec) message by message. Chunks have checksums and message indexes. The
// summary at the end lets readers find messages without reading the whole file. Foxglove, Lichtblick, Rerun and the
// official libraries can open the file.
//
//   mcap::Writer writer("match.mcap", {.library = "regista 0.1.0"});
//   const auto schema = writer.add_schema("truth", "jsonschema", text);
//   const auto truth = writer.add_channel("/truth", "json", schema);
//   writer.write({.channel = truth, .sequence = 0, .log_time = 0, .publish_time = 0, .data = R"({"ball": [0, 0]})"});
//   writer.close();
//
// The writer keeps one chunk in memory, plain and compressed (two chunks with WriterOptions::background), and about 100
// bytes of index for every written chunk. It passes a finished chunk to the kernel at once (with `background` a little
// later). If the process dies or the writer is destroyed without close(), all chunks in the file can be read. The bytes
// of the file depend only on the calls and the zstd version.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "mcap/encoding.hpp"
#include "mcap/file_io.hpp"

namespace regista::mcap {

// --- A thread that does one piece of work at a time, while the caller prepares the next piece.

class Background {
 public:
  // The destructor waits until the work is done.
  Background() : thread_([this](const std::stop_token& ending) { loop(ending); }) {}

  // Waits until the earlier work is done, and begins `work`. If earlier work threw an exception, throws it instead.
  void begin(std::function<void()> work) {
    wait();
    {
      const std::lock_guard lock(mutex_);
      work_ = std::move(work);
    }
    changed_.notify_all();
  }

  // Waits until there is no work; throws the exception of any earlier work.
  void wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !work_; });
    if (failure_) std::rethrow_exception(failure_);
  }

  // Throws the exception of any earlier work, without waiting.
  void throw_if_failed() {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void loop(const std::stop_token& ending) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, ending, [this] { return work_ != nullptr; })) {
      lock.unlock();
      std::exception_ptr failure;
      try {
        work_();
      } catch (...) {
        failure = std::current_exception();
      }
      lock.lock();
      if (failure) failure_ = failure;
      work_ = nullptr;
      changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::function<void()> work_;  // empty: nothing to do
  std::exception_ptr failure_;
  std::jthread thread_;  // the last member, because the thread uses the other members
};

struct WriterOptions {
  std::string library = "regista";
  std::size_t chunk_size = std::size_t{256} << 10;  // bytes, at most 16 MiB; a chunk that reaches this size ends
  bool replace = false;                             // true: replaces an existing file; false: such a file is an Error
  // true: a separate thread compresses and writes finished chunks. The writer then reports a failure one chunk later.
  // The bytes of the file are the same.
  bool background = false;
};

class Writer {
 public:
  // Every function throws Error if the file cannot be written (a full disk); all later calls then fail, too. Every
  // function also throws Error for content that MCAP does not allow: text that is not UTF-8, an item above 32 MiB, more
  // than 65535 schemas or channels. An Error for such content leaves the writer unchanged.
  explicit Writer(const std::filesystem::path& file, const WriterOptions& options = {});
  ~Writer();

  SchemaId add_schema(std::string_view name, std::string_view encoding, std::string_view data);
  // schema: a result of add_schema() of this writer, or SchemaId::none.
  ChannelId add_channel(std::string_view topic, std::string_view message_encoding, SchemaId schema = SchemaId::none);
  // Messages may come in any order of their times. Readers are fastest if the times increase.
  void write(const Message& message);
  void write(const Metadata& metadata);  // written at once, outside of chunks

  // Ends the chunk before it is full, so that the file contains all messages so far. With WriterOptions::background,
  // the file contains these messages only after the thread has written the chunk.
  void finish_chunk();
  // Writes the summary and ends the file. Only close() may be called afterwards; a second close() does nothing.
  void close();

 private:
  void check_open();
  void settle();  // waits until the background thread is idle
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
  void store(Chunk& chunk);  // writes the chunk into the file and empties it
  Chunk filling_;
  Chunk finished_;     // the chunk that the background thread writes
  std::string bytes_;  // the newest written chunk as bytes of the file

  // State of the whole file:
  std::vector<Schema> schemas_;    // element i has the identifier i + 1
  std::vector<Channel> channels_;  // element i has the identifier i + 1
  std::vector<ChunkIndex> chunks_;
  std::vector<MetadataIndex> metadata_;
  Statistics statistics_;
  bool closed_ = false;
  std::optional<Background> background_;  // the last member, because its thread uses the other members
};

}  // namespace regista::mcap
