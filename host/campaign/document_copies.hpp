// SPDX-License-Identifier: MIT
// The files that a study was begun with, taken into its file of results and laid out again: so that one of its matches
// is set up as then, though the files were edited since.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/stored_documents.hpp"
#include "process/temporary_folder.hpp"

namespace regista::campaign {

// What these files contain, by path, each once. Of shared objects, of files above 16 MiB and of what comes after 64 MiB
// in all only the path: whether they are what they were is seen from the inputs of the match.
std::vector<Document> documents_in(std::span<const std::filesystem::path> files);

// The job as it is read where copies of its files stand below `root`, as they stand below the root of the file system:
// what it names by an absolute path is the copy, where there is one; what it names otherwise is the copy where it is
// read in the copy of `given_in`, the folder in which it was named. Folders of plugins become absolute.
Job in_copies(Job job, const std::filesystem::path& root, const std::filesystem::path& given_in);

// The documents in a folder of their own, which stands for the root of the file system: a relative name in a document
// or a job finds the copy, an absolute name in a document finds the file itself.
class DocumentCopies {
 public:
  // Those without content are links to what stands there now. Throws std::system_error; std::invalid_argument for paths
  // that are not absolute and normal, or lead through one another: nobody has written such a file of results.
  explicit DocumentCopies(std::vector<Document> documents);

  const std::filesystem::path& root() const { return root_.path(); }

  // The folder in which the names of a job are to be read that were given in this one, an absolute path. It is there.
  std::filesystem::path folder(const std::filesystem::path& given_in) const;

  // The job to be read in folder(given_in): what it names by an absolute path is the copy, where there is one. Folders
  // of plugins become absolute, as there are no copies of them.
  Job job(Job job, const std::filesystem::path& given_in) const;

 private:
  std::filesystem::path at(const std::filesystem::path& path) const;
  process::TemporaryFolder root_;
};

}  // namespace regista::campaign
