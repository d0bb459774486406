// SPDX-License-Identifier: MIT
// The catalogue of all available plugins. The catalogue examines every shared object in some folders, keeps the usable
// files, records why it refused other files, and finds the plugin that a team names. Only a catalogue with
// Looking::here runs plugin code in this process.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "config/team.hpp"
#include "plugin/description.hpp"
#include "plugin/shared_object.hpp"

namespace regista::plugin {

class Catalogue {
 public:
  // Examines every *.so in the folders, in the given order of folders, then by name. Skips missing folders. Examines a
  // file once, even if two folders or a link lead to this file. Throws nothing for unusable files: see refused().
  explicit Catalogue(std::vector<std::filesystem::path> folders);

  enum class Looking {
    in_a_child,  // the catalogue examines files in a child process: see scan_files()
    here,        // the catalogue examines files in this process, and a bad file may end this process
  };
  // Makes a catalogue of exactly these files, in the given order.
  static Catalogue of_files(std::span<const std::filesystem::path> files, Looking looking);

  // Returns the folders to search: `options` (of `--plugins DIR`), the folders in the variable REGISTA_PLUGIN_PATH
  // (separated by colons; null: not set), and the built-in folder. Throws config::Error if an option is not a folder.
  static std::vector<std::filesystem::path> search_path(std::span<const std::filesystem::path> options,
                                                        const char* environment_variable_value,
                                                        const std::filesystem::path& built_in);

  std::span<const Found> plugins() const { return plugins_; }  // in the order of folders, then of file names
  std::span<const Refused> refused() const { return refused_; }
  std::span<const Refused> remarked() const { return remarked_; }  // usable files with remarks for their authors
  std::span<const std::filesystem::path> folders() const { return folders_; }

  // Returns the sorted files, in searched folders, of all plugins that find() has found. A catalogue of only these
  // files gives the same results for the same calls of find().
  std::vector<std::string> used_files() const;

  // Returns the searched folders as text, and marks folders that do not exist.
  std::vector<std::string> searched() const;

  // Finds the plugin of `kind` (REGISTA_KIND_*) that `use` names; examines a file that `use` names. A predictor must
  // model `subject` (REGISTA_SUBJECT_*), unless `subject` is 0. The reference lives as long as the catalogue. Throws
  // config::Error at use.where if no plugin or several plugins match, or if the named file must not be used.
  const Found& find(const config::PluginUse& use, int kind, std::uint32_t subject = 0) const;

 private:
  struct File {
    std::shared_ptr<PluginFile> object;
    std::vector<Found> plugins;
    std::string reason;  // why the file was refused; empty: the file may be used
    std::string remark;
  };

  File* known(const std::filesystem::path& path) const;
  void look_at(std::span<const std::filesystem::path> paths) const;
  void add(const std::filesystem::path& path);
  const Found& find_pinned(const config::PluginUse& use, int kind) const;
  const Found& find_searched(const config::PluginUse& use, int kind) const;

  Looking looking_ = Looking::in_a_child;
  std::vector<std::filesystem::path> folders_;
  std::vector<Found> plugins_;
  std::vector<Refused> refused_, remarked_;
  mutable std::set<std::string> used_;
  mutable std::deque<File> files_;  // all examined files; a deque, so that pinned plugins keep their addresses
};

}  // namespace regista::plugin
