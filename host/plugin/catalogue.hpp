// SPDX-License-Identifier: MIT
// Which plugins exist: looks at every shared object of the folders it is given, keeps what may be used, remembers why
// the rest may not, and finds the one that a team names. No code of a plugin runs in this process for that.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "config/team.hpp"
#include "plugin/found.hpp"
#include "plugin/plugin_file.hpp"

namespace regista::plugin {

class Catalogue {
 public:
  // Searches the folders in this order and looks at every *.so in them, by name; folders that do not exist are skipped.
  // A file reached twice (by two folders, or a link) counts once. Never throws for what is in a folder: see refused().
  explicit Catalogue(std::vector<std::filesystem::path> folders);

  // Where files are looked at.
  enum class Looking {
    in_a_child,  // see survey.hpp
    here,        // they are loaded into this process, by one that was started to be lost
  };
  // Of these files alone, in this order: what a search has found before.
  static Catalogue of_files(std::span<const std::filesystem::path> files, Looking looking);

  // The folders to search: those of `--plugins DIR`, then those of the environment variable REGISTA_PLUGIN_PATH (colon
  // separated; null when unset), then the built-in one. Throws config::Error for an option's folder that is none.
  static std::vector<std::filesystem::path> search_path(std::span<const std::filesystem::path> options,
                                                        const char* environment_variable_value,
                                                        const std::filesystem::path& built_in);

  std::span<const Found> plugins() const { return plugins_; }  // in the order of folders, then of file names
  std::span<const Refused> refused() const { return refused_; }
  std::span<const Refused> remarked() const { return remarked_; }  // used all the same; why their authors should look
  std::span<const std::filesystem::path> folders() const { return folders_; }

  // The files of all plugins that find() has found by searching, sorted: all that the same questions need.
  std::vector<std::string> used_files() const;

  // The folders in words: those that do not exist are marked so.
  std::vector<std::string> searched() const;

  // The plugin of this kind (REGISTA_KIND_*) that `use` names; looks at its pinned file on demand. A predictor must
  // model `subject` (REGISTA_SUBJECT_*), unless that is 0. The reference lives as long as the catalogue. Throws
  // config::Error at use.where when there is none, several, or the pinned file may not be used.
  const Found& find(const config::PluginUse& use, int kind, std::uint32_t subject = 0) const;

 private:
  struct File {
    std::shared_ptr<PluginFile> object;
    std::vector<Found> plugins;
    std::string reason;  // why it was refused; empty when it was not
    std::string remark;
  };

  File* known(const std::filesystem::path& path) const;
  void look_at(std::span<const std::filesystem::path> paths) const;
  void add(const std::filesystem::path& path);
  const Found& find_pinned(const config::PluginUse& use, int kind) const;
  const Found& find_searched(const config::PluginUse& use, int kind) const;
  std::string where_searched() const;

  Looking looking_ = Looking::in_a_child;
  std::vector<std::filesystem::path> folders_;
  std::vector<Found> plugins_;
  std::vector<Refused> refused_, remarked_;
  mutable std::set<std::string> used_;
  mutable std::deque<File> files_;  // all ever looked at; a deque, so that pinned plugins keep their places
};

}  // namespace regista::plugin
