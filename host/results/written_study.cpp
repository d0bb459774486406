// SPDX-License-Identifier: MIT
#include "results/written_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include "command/end_of_program.hpp"
#include "config/documents.hpp"
#include "config/parse.hpp"
#include "config/values.hpp"
#include "output/new_folder.hpp"
#include "process/program.hpp"
#include "texts/message.hpp"

namespace regista::results {
namespace {

namespace fs = std::filesystem;

constexpr auto study_file = "study.yaml";

// The kind of study that a document asks for; null: it asks for no study.
const StudyKind* kind_of(const config::Node& document, std::span<const StudyKind> kinds) {
  const auto found =
      std::ranges::find_if(kinds, [&](const StudyKind& each) { return bool(document[each.document.name]); });
  return found == kinds.end() ? nullptr : &*found;
}

bool is_study(const std::string& content, std::span<const StudyKind> kinds) {
  try {
    return kind_of(config::parse_text(content, "a document"), kinds) != nullptr;
  } catch (const config::Error&) {
    return false;  // data of a plugin
  }
}

// The folder that all of them stand in.
fs::path folder_of(const std::vector<fs::path>& files) {
  fs::path out = files.empty() ? fs::path() : files.front().parent_path();
  for (const fs::path& each : files) {
    const auto [end, rest] = std::mismatch(out.begin(), out.end(), each.begin(), each.end());
    fs::path common;
    for (auto part = out.begin(); part != end; ++part) common /= *part;
    out = std::move(common);
  }
  return out;
}

class Laying {
 public:
  Laying(const report::WhatWasPlayed& played, const std::vector<campaign::Document>& documents,
         std::span<const StudyKind> kinds)
      : played_(played), kinds_(kinds) {
    std::vector<fs::path> files;
    for (const campaign::Document& each : documents) {
      // A file of results may come from anybody: nothing may be written but below the folder.
      const fs::path path = each.path;
      const bool plain = path.is_absolute() && path.has_filename() && path == path.lexically_normal();
      if (!plain || !each.content || is_study(*each.content, kinds)) continue;
      contents_.emplace(each.path, &*each.content);
      files.emplace_back(each.path);
    }
    root_ = folder_of(files);
    if (root_.has_relative_path() && contents_.contains((root_ / study_file).string())) root_ = root_.parent_path();
    for (const auto& [path, content] : contents_) {
      for (const auto& [other, unused] : contents_) {
        if (content->find(other) == std::string::npos) continue;
        left_out.push_back(fmt::format("{} names {} from the root of the file system, and goes on to read it there",
                                       texts::one_line(path), texts::one_line(other)));
      }
    }
    for (const std::string& each : played.plugins) {
      const std::string folder = absolute(each).string();
      left_out.push_back(fmt::format("plugins do not come along: `regista run study.yaml` needs {}",
                                     process::shell_line(std::vector<std::string>{"--plugins", folder})));
    }
  }

  std::vector<output::NewFile> files() {
    std::vector<output::NewFile> out{{study_file, study()}};
    for (const auto& [path, content] : contents_) out.push_back({fs::path(path).lexically_relative(root_), *content});
    return out;
  }

  std::vector<std::string> left_out;

 private:
  std::string study() {
    const config::Node document = with_own_names(config::parse_text(played_.document, study_file));
    config::Mistakes first(config::Mistakes::After::stop, config::Mistakes::Files::as_they_stand);
    std::string out;
    kind_of(document, kinds_)->document.with_values(document, first, [&](const config::Map& declared) {
      config::rename_files(declared, [this](const std::string& name) { return renamed(name); });
      out = config::document_text(declared);
    });
    return out;
  }

  // Values of the documents of matches, and those of a sweep, may name files, too; and what it was played with is what
  // it is compared with when it is played again.
  config::Node with_own_names(const config::Node& document) const {
    std::vector<config::Node::Entry> out;
    for (const config::Node::Entry& each : document.entries()) {
      if (each.key == "played_with") continue;
      out.push_back({each.key, each.key_where, with_names_below(each.key, each.value)});
    }
    std::vector<config::Node> lines;
    for (const std::string& each : report::played_with(played_)) lines.push_back(config::Node::scalar(each, true, {}));
    out.push_back({"played_with", {}, config::Node::sequence(std::move(lines), {})});
    return config::Node::map(std::move(out), document.where());
  }

  config::Node with_names_below(std::string_view key, const config::Node& node) const {
    if (key == "set" || key == "values") return with_names(node);
    if (node.kind() == config::Node::Kind::map) {
      std::vector<config::Node::Entry> out;
      for (const config::Node::Entry& each : node.entries())
        out.push_back({each.key, each.key_where, with_names_below(each.key, each.value)});
      return config::Node::map(std::move(out), node.where());
    }
    if (node.kind() == config::Node::Kind::sequence) {
      std::vector<config::Node> out;
      for (const config::Node& each : node.elements()) out.push_back(with_names_below("", each));
      return config::Node::sequence(std::move(out), node.where());
    }
    return node;
  }

  fs::path absolute(const std::string& name) const { return (fs::path(played_.folder) / name).lexically_normal(); }

  // Folders of scenes are taken as far as their files are.
  bool is_taken(const fs::path& path) const {
    const auto found = contents_.lower_bound(path.string());
    return found != contents_.end() && (found->first == path.string() || found->first.starts_with(path.string() + '/'));
  }

  std::string renamed(const std::string& name) {
    const fs::path path = absolute(name);
    if (is_taken(path)) return path.lexically_relative(root_).generic_string();
    left_out.push_back(
        fmt::format("{} is not in the results: it is named where it is", texts::one_line(path.string())));
    return path.string();
  }

  // Values that name a file of the study.
  config::Node with_names(const config::Node& node) const {
    switch (node.kind()) {
      case config::Node::Kind::scalar: {
        const fs::path path = absolute(node.text());
        if (node.text().empty() || !contents_.contains(path.string())) return node;
        return config::Node::scalar(path.lexically_relative(root_).generic_string(), true, {});
      }
      case config::Node::Kind::sequence: {
        std::vector<config::Node> out;
        for (const config::Node& each : node.elements()) out.push_back(with_names(each));
        return config::Node::sequence(std::move(out), {});
      }
      case config::Node::Kind::map: {
        std::vector<config::Node::Entry> out;
        for (const config::Node::Entry& each : node.entries()) out.push_back({each.key, {}, with_names(each.value)});
        return config::Node::map(std::move(out), {});
      }
      default:
        return node;
    }
  }

  const report::WhatWasPlayed& played_;
  std::span<const StudyKind> kinds_;
  std::map<std::string, const std::string*> contents_;  // by path
  fs::path root_;
};

}  // namespace

std::vector<std::string> write_study(const report::WhatWasPlayed& played,
                                     const std::vector<campaign::Document>& documents, std::span<const StudyKind> kinds,
                                     const fs::path& folder) {
  Laying laying(played, documents, kinds);
  output::write_new_folder(folder.has_filename() ? folder : folder.parent_path(), laying.files());
  return laying.left_out;
}

}  // namespace regista::results
