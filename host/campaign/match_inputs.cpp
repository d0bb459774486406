// SPDX-License-Identifier: MIT
#include "campaign/match_inputs.hpp"

#include <fmt/format.h>
#include <gnu/libc-version.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "config/documents.hpp"
#include "config/overlay.hpp"
#include "config/values.hpp"
#include "plugin/info.hpp"
#include "plugin/shared_object.hpp"

namespace regista::campaign {

std::vector<std::string> differences(std::span<const Input> before, std::span<const Input> now) {
  std::vector<std::string> out;
  const auto add = [&](const std::string& text) {
    if (std::ranges::find(out, text) == out.end()) out.push_back(text);
  };
  // An input with the same content under another name, such as another spelling of a path, counts as unchanged.
  const auto elsewhere = [](std::span<const Input> inputs, const Input& wanted) {
    return std::ranges::find(inputs, wanted.hash, &Input::hash) != inputs.end();
  };
  // "plugin greedy (lib/greedy.so)" and "plugin greedy (/home/me/lib/greedy.so)" name the same input.
  const auto named_as = [](std::span<const Input> inputs, const std::string& name) {
    const auto subject = [](const std::string& of) { return of.substr(0, of.find(" (")); };
    const auto found = std::ranges::find(inputs, name, &Input::name);
    if (found != inputs.end()) return found;
    return std::ranges::find_if(inputs, [&](const Input& each) { return subject(each.name) == subject(name); });
  };
  for (const Input& old : before) {
    if (elsewhere(now, old)) continue;
    const auto found = named_as(now, old.name);
    if (found == now.end())
      add(old.name + " is no longer used");
    else if (found->hash != old.hash)
      add(old.name + " has changed");
  }
  for (const Input& input : now) {
    if (elsewhere(before, input)) continue;
    if (named_as(before, input.name) == before.end()) add(input.name + " is new");
  }
  return out;
}

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

// Makes inputs of home and away different, even if their contents are equal.
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
    // used.hash is the hash of the content when the parameters were read. The file may have changed since.
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
  opening.summary.clear();  // the summary is for people, like a comment
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

std::string mathematics_fingerprint() {
  using Function = double (*)(double);
  constexpr std::array<Function, 10> functions{[](double x) { return std::sin(x); },
                                               [](double x) { return std::cos(x); },
                                               [](double x) { return std::tan(x); },
                                               [](double x) { return std::atan(x); },
                                               [](double x) { return std::exp(x); },
                                               [](double x) { return std::log(1.0 + std::abs(x)); },
                                               [](double x) { return std::asin(x / 8.0); },
                                               [](double x) { return std::tanh(x); },
                                               [](double x) { return std::atan2(x, 1.5 - x); },
                                               [](double x) { return std::pow(1.0 + std::abs(x), 0.37 * x); }};
  std::vector<double> results;
  for (int i = -300; i <= 300; ++i) {
    // x is volatile, so that the compiler does not compute the results at compile time.
    volatile double x = 0.0257 * i;
    for (const Function function : functions) {
      const double value = function(x);
      results.push_back(std::isnan(value) ? 0.0 : value);
      results.push_back(static_cast<double>(std::sin(static_cast<float>(x))));
    }
  }
  const std::string_view bytes(reinterpret_cast<const char*>(results.data()), results.size() * sizeof(double));
  return std::string(gnu_get_libc_version()) + ' ' + plugin::content_hash(bytes);
}

}  // namespace regista::campaign
