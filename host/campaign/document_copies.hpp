// SPDX-License-Identifier: MIT
// The files that a study was begun with, taken into its file of results and laid out again: so that one of its matches
// is set up as then, though the files were edited since.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/stored_documents.hpp"
#include "campaign/temporary_folder.hpp"

namespace regista::campaign {

// What these files contain, by path, each once. Of shared objects and of files above 16 MiB only the path: whether they
// are what they were is told by the inputs of the match.
std::vector<Document> documents_in(std::span<const std::filesystem::path> files);

// The documents in a folder of their own, which stands for the root: what names another by a relative path finds it.
class DocumentCopies {
 public:
  // Those without content are links to what stands there now. Throws std::system_error and
  // std::filesystem::filesystem_error.
  explicit DocumentCopies(std::vector<Document> documents);

  // The folder in which the names of a job are to be read that were given in this one, an absolute path. It is there.
  std::filesystem::path folder(const std::filesystem::path& given_in) const;

  // The job with its documents here, where there are copies; given_in: where its names were given. Folders of plugins
  // are absolute then.
  Job job(Job job, const std::filesystem::path& given_in) const;

 private:
  std::filesystem::path at(const std::filesystem::path& path) const;
  std::vector<std::string> paths_;
  TemporaryFolder root_;
};

}  // namespace regista::campaign
