// SPDX-License-Identifier: MIT
#include "campaign/inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

#include "config/documents.hpp"
#include "config/file.hpp"
#include "config/profiles.hpp"
#include "config/show.hpp"
#include "plugin/content_hash.hpp"
#include "plugin/declarations.hpp"

namespace regista::campaign {
namespace {

std::string required_content(const std::filesystem::path& file) {
  errno = 0;
  std::optional<std::string> out = config::file_content(file);
  if (!out) throw std::system_error(errno == 0 ? EIO : errno, std::generic_category(), "cannot read " + file.string());
  return std::move(*out);
}

template <class Profile>
Input profile(const char* kind, Profile values) {
  const std::string shown = config::show(config::declare(values), config::Node(), {}, config::Remarks::without);
  return {fmt::format("{} {}", kind, values.name), plugin::content_hash(shown)};
}

// The same content is another input on the other side.
Input of_side(const char* side, const Input& input) {
  return {side + input.name, plugin::content_hash(side + input.hash)};
}

std::string without(const std::string& root, std::string text) {
  for (std::size_t at = 0; !root.empty() && (at = text.find(root + '/', at)) != std::string::npos;) {
    text.erase(at, root.size());
  }
  return text;
}

class Collected {
 public:
  explicit Collected(const std::string& root) : root_(root) {}

  void add(const mind::Part& part) {
    const std::filesystem::path& file = part.found->file;
    const std::string id = part.found->descriptor->id;
    put(fmt::format("plugin {} ({})", id, file.string()),
        [&] { return id + ' ' + plugin::content_hash(required_content(file)); });
    // Read when the parameters were: by now the file may be another.
    for (const plugin::FileUsed& used : part.parameters.files()) {
      put(fmt::format("file {} of plugin {}", without(root_, used.path.string()), id), [&] { return used.hash; });
    }
  }
  std::vector<Input> take() {
    std::ranges::stable_sort(inputs_, {}, [](const Input& input) { return input.hash; });
    return std::move(inputs_);
  }

 private:
  template <class Hash>
  void put(const std::string& name, Hash hash) {
    if (std::ranges::find(inputs_, name, &Input::name) == inputs_.end()) inputs_.push_back({name, hash()});
  }
  const std::string& root_;
  std::vector<Input> inputs_;
};

}  // namespace

std::vector<Input> team_inputs(const mind::TeamPlan& plan, const config::Node& document,
                               const plugin::Catalogue& catalogue, const std::string& root) {
  Collected plugins(root);
  for (const mind::Part* part : plan.parts()) plugins.add(*part);
  const std::string shown =
      without(root, config::show(document, plugin::declarations(catalogue.plugins()), config::Remarks::without));
  std::vector<Input> out{{"team " + without(root, plan.team().file), plugin::content_hash(shown)}};
  std::ranges::move(plugins.take(), std::back_inserter(out));
  return out;
}

std::vector<Input> common_inputs(const match::Setup& setup, const std::string& program,
                                 const std::string& mathematics) {
  const std::string limit = setup.limit ? fmt::format("{:a}", *setup.limit) : "none";
  std::vector<Input> out{profile("rules", setup.rules),
                         profile("robot", setup.robots[0]),
                         of_side("home ", profile("disturbance", setup.disturbances[0])),
                         of_side("away ", profile("disturbance", setup.disturbances[1])),
                         {"limit", plugin::content_hash(limit)},
                         {program_input, program},
                         {mathematics_input, mathematics}};
  if (setup.opening) out.push_back(opening_input(*setup.opening));
  return out;
}

Input opening_input(config::Opening opening) {
  opening.summary.clear();  // for people, as comments are
  return profile("opening", std::move(opening));
}

std::string fixture_key(std::span<const Input> home, std::span<const Input> away, std::span<const Input> common) {
  std::string all;
  for (const std::span<const Input> part : {home, away, common}) {
    for (const Input& input : part) all += input.hash + '\n';
    all += "--\n";
  }
  return plugin::content_hash(all);
}

std::string program_hash() { return plugin::content_hash(required_content("/proc/self/exe")); }

}  // namespace regista::campaign
