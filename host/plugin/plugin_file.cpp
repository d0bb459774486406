// SPDX-License-Identifier: MIT
#include "plugin/plugin_file.hpp"

#include <sys/stat.h>

#include <stdexcept>
#include <system_error>

namespace regista::plugin {

FileStamp stamp_of(const std::filesystem::path& file) {
  struct stat about {};
  if (::stat(file.c_str(), &about) != 0) return {};
  return {about.st_dev, about.st_ino, about.st_size, about.st_mtim.tv_sec, about.st_mtim.tv_nsec};
}

PluginFile::PluginFile(std::filesystem::path file) : file_(std::move(file)), stamp_(stamp_of(file_)) {
  std::error_code error;
  absolute_ = std::filesystem::absolute(file_, error);
}

bool PluginFile::has_changed() const { return stamp_of(absolute_) != stamp_; }

const SharedObject& PluginFile::load() {
  if (!loaded_ && has_changed()) loaded_ = SharedObject{{}, "was changed after it had been looked at", {}};
  if (!loaded_) loaded_ = open_shared_object(absolute_);
  return *loaded_;
}

const regista_descriptor& PluginFile::descriptor(std::uint32_t index) {
  const SharedObject& object = load();
  if (!object.refusal.empty()) throw std::runtime_error(object.refusal);
  if (index >= object.descriptors.size()) throw std::runtime_error("has fewer plugins than when it was looked at");
  return *object.descriptors[index];
}

}  // namespace regista::plugin
