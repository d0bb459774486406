// SPDX-License-Identifier: MIT
#include "campaign/stored_documents.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

#include "campaign/row_checksum.hpp"
#include "mcap/compression.hpp"
#include "mcap/decode.hpp"

namespace regista::campaign {
namespace {

std::int64_t checksum_of(std::string_view path, std::int64_t size, std::string_view content) {
  return RowChecksum().bytes(path).whole(size).bytes(content).value();
}

}  // namespace

void StoredDocuments::keep(std::span<const Document> documents) {
  database_.exec(tables);
  database_.exec("DELETE FROM documents");
  SQLite::Statement add(database_, "INSERT OR IGNORE INTO documents(path, size, content, checksum) VALUES(?, ?, ?, ?)");
  mcap::Compressor compressor;
  for (const Document& each : documents) {
    std::string frame;
    std::int64_t size = 0;
    add.bindNoCopy(1, each.path);
    if (each.content) {
      compressor.append(frame, *each.content);
      size = static_cast<std::int64_t>(each.content->size());
      add.bind(2, size);
      add.bindNoCopy(3, frame.data(), static_cast<int>(frame.size()));
    } else {
      add.bind(2);
      add.bind(3);
    }
    add.bind(4, checksum_of(each.path, size, frame));
    add.exec();
    add.reset();
  }
}

std::vector<Document> StoredDocuments::all() {
  std::vector<Document> out;
  if (!database_.tableExists("documents")) return out;
  SQLite::Statement each(database_, "SELECT path, size, content, checksum FROM documents ORDER BY path");
  mcap::Decompressor decompressor;
  while (each.executeStep()) {
    Document& document = out.emplace_back();
    document.path = each.getColumn(0).getString();
    const bool kept = !each.getColumn(2).isNull();
    const std::int64_t size = each.getColumn(1).getInt64();  // 0 of null
    const SQLite::Column column = each.getColumn(2);
    const std::string_view frame(static_cast<const char*>(column.getBlob()),
                                 static_cast<std::size_t>(column.getBytes()));
    if (checksum_of(document.path, size, frame) != each.getColumn(3).getInt64()) {
      throw std::invalid_argument(fmt::format("the checksum of the document {} does not fit", document.path));
    }
    if (!kept) continue;
    try {
      decompressor.decompress(frame, static_cast<std::uint64_t>(size), document.content.emplace());
    } catch (const mcap::Malformed& error) {
      throw std::invalid_argument(fmt::format("the document {}: {}", document.path, error.why));
    }
  }
  return out;
}

}  // namespace regista::campaign
