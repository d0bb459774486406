// SPDX-License-Identifier: MIT
#include "plugin/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <system_error>

#include "texts/message.hpp"

namespace regista::plugin {
namespace {

namespace fs = std::filesystem;

// Returns the shared objects in a folder, by name. For an unreadable folder, writes the reason to `reason`.
std::vector<fs::path> shared_objects(const fs::path& folder, std::string& reason) {
  std::vector<fs::path> out;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() == ".so") out.push_back(it->path());
  }
  if (error && error != std::errc::no_such_file_or_directory) {
    reason = fmt::format("cannot be searched: {}", error.message());
  }
  std::ranges::sort(out, {}, &fs::path::native);
  return out;
}

// Returns the ids of the plugins of this kind, sorted and without duplicates.
std::vector<std::string> names_of_kind(std::span<const Found> plugins, int kind) {
  std::vector<std::string> out;
  for (const Found& plugin : plugins) {
    if (plugin.description->implements(kind)) out.emplace_back(plugin.descriptor->id);
  }
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

// Returns text such as `unknown assigner "gredy"; nearest: "greedy"; known: greedy, hungarian`.
std::string unknown(const std::string& id, int kind, const std::vector<std::string>& known) {
  return texts::unknown(kind_name(kind), id, "", known) + (known.empty() ? "; there is none at all" : "");
}

// Returns text such as `plugin "voronoi" is a positioner, not an assigner`.
std::string another_kind(const Found& plugin, int kind) {
  std::vector<std::string> kinds;
  for (const int each : plugin.description->kinds()) {
    if (each != REGISTA_KIND_MAILBOX) kinds.push_back(texts::with_article(kind_name(each)));
  }
  return fmt::format("plugin \"{}\" is {}, not {}", plugin.descriptor->id, fmt::join(kinds, " and "),
                     texts::with_article(kind_name(kind)));
}

ScannedFile looked_at_here(PluginFile& file) {
  const SharedObject& object = file.load();
  ScannedFile out{{}, object.refusal, object.remark};
  for (const regista_descriptor* each : object.descriptors) {
    out.plugins.push_back(std::make_shared<const Description>(*each));
  }
  return out;
}

}  // namespace

Catalogue::Catalogue(std::vector<fs::path> folders) : folders_(std::move(folders)) {
  std::vector<std::vector<fs::path>> files_of;
  std::vector<std::string> reasons;
  std::vector<fs::path> all;
  for (const fs::path& folder : folders_) {
    files_of.push_back(shared_objects(folder, reasons.emplace_back()));
    all.insert(all.end(), files_of.back().begin(), files_of.back().end());
  }
  look_at(all);
  std::vector<const PluginFile*> added;
  for (std::size_t i = 0; i < folders_.size(); ++i) {
    if (!reasons[i].empty()) refused_.push_back({folders_[i], reasons[i]});
    for (const fs::path& path : files_of[i]) {
      const PluginFile* const file = known(path)->object.get();
      if (std::ranges::find(added, file) != added.end()) continue;  // the file was added under another name
      added.push_back(file);
      add(path);
    }
  }
}

Catalogue Catalogue::of_files(std::span<const fs::path> files, Looking looking) {
  Catalogue out(std::vector<fs::path>{});
  out.looking_ = looking;
  out.look_at(files);
  for (const fs::path& file : files) out.add(file);
  return out;
}

void Catalogue::add(const fs::path& path) {
  const File& file = *known(path);
  plugins_.insert(plugins_.end(), file.plugins.begin(), file.plugins.end());
  if (!file.reason.empty()) refused_.push_back({file.object->file(), file.reason});
  if (!file.remark.empty()) remarked_.push_back({file.object->file(), file.remark});
}

std::vector<fs::path> Catalogue::search_path(std::span<const fs::path> options, const char* environment_variable_value,
                                             const fs::path& built_in) {
  std::vector<fs::path> out;
  for (const fs::path& folder : options) {
    std::error_code error;
    if (!fs::exists(folder, error)) {
      throw config::Error({"--plugins " + folder.string(), 0, 0}, "there is no such folder");
    }
    if (!fs::is_directory(folder, error)) {
      throw config::Error({"--plugins " + folder.string(), 0, 0}, "is not a folder");
    }
    out.push_back(folder);
  }
  std::string_view rest = environment_variable_value != nullptr ? environment_variable_value : "";
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    if (!folder.empty()) out.emplace_back(folder);
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
  }
  if (!built_in.empty()) out.push_back(built_in);
  return out;
}

// Returns the examined file at this path, or null if the file has not been examined. Also finds a file that was
// examined under another name. A file that does not exist has only one name.
Catalogue::File* Catalogue::known(const fs::path& path) const {
  const FileStamp now = stamp_of(path);
  for (File& file : files_) {
    const FileStamp& then = file.object->stamp();
    const bool exists = now.bytes >= 0 && then.bytes >= 0;
    if (exists && then.device == now.device && then.number == now.number) return &file;
    if (file.object->file() == path) return &file;
  }
  return nullptr;
}

void Catalogue::look_at(std::span<const fs::path> paths) const {
  std::vector<fs::path> unknown;
  const std::size_t before = files_.size();
  for (const fs::path& path : paths) {
    if (known(path) != nullptr) continue;
    files_.emplace_back().object = std::make_shared<PluginFile>(path);
    unknown.push_back(path);
  }
  std::vector<ScannedFile> found;
  if (looking_ == Looking::in_a_child) {
    found = scan_files(unknown);
  } else {
    for (std::size_t i = 0; i < unknown.size(); ++i) found.push_back(looked_at_here(*files_[before + i].object));
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    File& file = files_[before + i];
    file.reason = found[i].refusal;
    file.remark = found[i].remark;
    std::uint32_t index = 0;
    for (const auto& description : found[i].plugins) {
      file.plugins.push_back({unknown[i], &description->declared(), description, file.object, index++});
    }
  }
}

const Found& Catalogue::find(const config::PluginUse& use, int kind, std::uint32_t subject) const {
  const Found& found = use.file.empty() ? find_searched(use, kind) : find_pinned(use, kind);
  const std::uint32_t subjects = found.description->subjects();
  if (subject != 0 && (subjects & subject) == 0) {
    throw config::Error(use.where, fmt::format("predictor \"{}\" models {}, not {}", use.plugin,
                                               subject_names(subjects), subject_names(subject)));
  }
  return found;
}

const Found& Catalogue::find_pinned(const config::PluginUse& use, int kind) const {
  if (known(use.file) == nullptr) look_at(std::vector<fs::path>{use.file});
  const File& file = *known(use.file);
  if (!file.reason.empty()) throw config::Error(use.where, to_string(Refused{use.file, file.reason}));
  const Found* other = nullptr;
  for (const Found& plugin : file.plugins) {
    if (plugin.descriptor->id != use.plugin) continue;
    if (plugin.description->implements(kind)) return plugin;
    other = &plugin;
  }
  const std::string reason =
      other != nullptr ? another_kind(*other, kind) : unknown(use.plugin, kind, names_of_kind(file.plugins, kind));
  throw config::Error(use.where, use.file + ": " + reason);
}

const Found& Catalogue::find_searched(const config::PluginUse& use, int kind) const {
  std::vector<const Found*> found;
  const Found* other = nullptr;
  for (const Found& plugin : plugins_) {
    if (plugin.descriptor->id != use.plugin) continue;
    if (plugin.description->implements(kind)) {
      found.push_back(&plugin);
    } else {
      other = &plugin;
    }
  }
  if (found.size() == 1) {
    used_.insert(found.front()->file.string());
    return *found.front();
  }

  std::string message;
  if (found.size() > 1) {
    message = fmt::format("plugin \"{}\" exists {} times:", use.plugin, found.size());
    for (const Found* plugin : found) {
      const regista_descriptor& d = *plugin->descriptor;
      message += fmt::format(" {} ({}, {}),", plugin->file.string(), d.version, d.build_tag);
    }
    message.back() = ';';
    message += fmt::format(" pin one by its file: {{plugin: {}, file: {}}}", use.plugin, found.front()->file.string());
    throw config::Error(use.where, message);
  }
  const std::vector<std::string> names = names_of_kind(plugins_, kind);
  if (other != nullptr) {
    message = another_kind(*other, kind);
    if (!names.empty()) message += "; known: " + texts::join(names);
  } else {
    message = unknown(use.plugin, kind, names);
  }
  message +=
      fmt::format("; searched: {}", folders_.empty() ? "no folder" : fmt::format("{}", fmt::join(searched(), ", ")));
  if (!refused_.empty()) {
    message += "; refused:";
    for (const Refused& refused : refused_) message += fmt::format(" {},", to_string(refused));
    message.pop_back();
  }
  throw config::Error(use.where, message);
}

std::vector<std::string> Catalogue::used_files() const { return {used_.begin(), used_.end()}; }

std::vector<std::string> Catalogue::searched() const {
  std::vector<std::string> out;
  for (const fs::path& folder : folders_) {
    std::error_code error;
    out.push_back(folder.string() + (fs::exists(folder, error) ? "" : " (does not exist)"));
  }
  return out;
}

}  // namespace regista::plugin
