// SPDX-License-Identifier: MIT
#include "config/read.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <system_error>

#include "config/document_files.hpp"
#include "config/overlay.hpp"
#include "config/renamed_keys.hpp"
#include "config/scalar.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

// Reads the value of one key. `what` is the path of the value.
struct Reader {
  const Node& node;
  const std::string& what;
  Mistakes& mistakes;

  void operator()(const Real& real) const {
    real.member.get() = real.scale * real_within(node, what, real.range, real.unit);
  }

  void operator()(const Integer& integer) const {
    integer.set(integer_within(node, what, integer.range, integer.unit));
  }
  void operator()(const Boolean& boolean) const { boolean.member.get() = to_boolean(node, what); }
  void operator()(const Name& name) const { name.member.get() = to_name(node, what); }
  void operator()(const File& file) const {
    std::error_code none;
    // A saved document leaves out the key if built-in values are used, so each name in it is a file name.
    const bool is_built_in = !file.built_in.empty() && node.text() == file.built_in && mistakes.looks_for_files() &&
                             !std::filesystem::exists(named_file(node, what), none);
    file.member.get() = is_built_in ? std::string() : file_of(node);
  }

  void operator()(const Paths& paths) const {
    const bool is_list = node.kind() != Node::Kind::scalar;
    paths.members->clear();
    for (const Node& each : is_list ? elements_of(node, what, "a list of paths") : std::span(&node, 1)) {
      mistakes.attempt(what, [&] {
        std::error_code none;
        const bool folder = mistakes.looks_for_files() && std::filesystem::is_directory(named_file(each, what), none);
        paths.members->push_back(
            {folder ? std::filesystem::absolute(named_file(each, what)).lexically_normal().string() : file_of(each),
             each.where()});
      });
    }
  }

  void operator()(const Choice& choice) const {
    const std::string asked = to_text(node, what);
    const auto found = std::ranges::find(choice.names, asked);
    if (found == choice.names.end())
      throw Error(node.where(), what + ": " + texts::unknown("value", asked, "", choice.names));
    choice.set(static_cast<std::size_t>(found - choice.names.begin()));
  }

  void operator()(const Numbers& numbers) const {
    const std::string wanted = fmt::format("a list of {} numbers", numbers.count);
    if (node.kind() != Node::Kind::sequence) refuse_kind(node, what, wanted);
    const std::span<const Node> elements = node.elements();
    if (elements.size() != numbers.count) {
      throw Error(node.where(), fmt::format("{}: {} elements; expected {}", what, elements.size(), wanted));
    }
    const std::vector<double*> values = numbers.get();
    attempt_each(node, what, mistakes, [&](const Node& element, const std::string& path, std::size_t i) {
      *values[i] = real_within(element, path, numbers.range, numbers.unit);
    });
    if (!numbers.ascending || mistakes.doubtful(what)) return;
    for (std::size_t i = 1; i < elements.size(); ++i) {
      if (*values[i - 1] <= *values[i]) continue;
      throw Error(node.where(),
                  fmt::format("{}: {} is more than {}", what, elements[i - 1].text(), elements[i].text()));
    }
  }

  void operator()(const Own& own) const { own.read(node, what, mistakes); }

  void operator()(const Free& free) const {
    if (node.kind() != Node::Kind::map) refuse_kind(node, what, "a map");
    *free.member = node;
  }

  void operator()(const Section& section) const {
    const Map map = section.open();
    if (node.kind() != Node::Kind::map) {
      const bool is_plugin = node.kind() == Node::Kind::scalar && !map.plugin_kind.empty();
      refuse_kind(node, what, is_plugin ? fmt::format("{{plugin: {}}}", node.text()) : "a map");
    }
    read(map, node, what, mistakes);
  }

  void operator()(const List& list) const {
    if (node.kind() != Node::Kind::sequence) refuse_kind(node, what, "a list");
    check_count(node.elements().size(), list.least, list.most);
    list.clear();
    attempt_each(node, what, mistakes, [&](const Node& element, const std::string& path, std::size_t) {
      const Map map = list.append();  // a wrong element is appended, too, so that later elements keep their index
      if (element.kind() != Node::Kind::map) refuse_kind(element, path, "a map");
      read(map, element, path, mistakes);
    });
    check_names();
  }

  void operator()(const Dictionary& dictionary) const {
    if (node.kind() != Node::Kind::map) refuse_kind(node, what, "a map");
    check_count(node.entries().size(), dictionary.least, dictionary.most);
    dictionary.clear();
    for (const Node::Entry& entry : node.entries()) {
      mistakes.attempt(inside(what, entry.key), [&] {
        const std::string name = to_name(Node::scalar(entry.key, true, entry.key_where), what);
        const Field field = dictionary.append(name);
        const std::string path = inside(what, name);
        if (std::holds_alternative<List>(field.kind)) refuse_change_of_nothing(entry);
        refuse_mistyped_name(entry);
        std::visit(Reader{entry.value, path, mistakes}, field.kind);
      });
    }
  }

  // Throws Error for an entry without plugin whose name is similar to the name of an entry with a plugin. The user
  // probably wanted to change the entry with the plugin and mistyped its name.
  void refuse_mistyped_name(const Node::Entry& entry) const {
    if (entry.value.kind() != Node::Kind::map || entry.value["plugin"]) return;
    std::vector<std::string> names;
    for (const Node::Entry& each : node.entries()) {
      if (each.value.kind() == Node::Kind::map && each.value["plugin"]) names.push_back(each.key);
    }
    if (!texts::nearest(entry.key, names).empty())
      throw Error(entry.key_where, texts::unknown("name", entry.key, what, names));
  }

  // Returns the absolute path of the named file. For a saved document, returns the name as written.
  std::string file_of(const Node& named) const {
    if (!mistakes.looks_for_files()) return to_text(named, what);
    return existing_file(named, what).string();
  }

  void check_count(std::size_t count, std::size_t least, std::size_t most) const {
    if (count >= least && count <= most) return;
    throw Error(node.where(), fmt::format("{}: {} elements; expected {} to {}", what, count, least, most));
  }

  // Throws Error for a map in place of a list. In a document with `extends`, such a map changes elements of the
  // extended list. If the map is still there after the merge, no extended document has this list.
  void refuse_change_of_nothing(const Node::Entry& entry) const {
    if (entry.value.kind() != Node::Kind::map) return;
    std::vector<std::string> lists;
    for (const Node::Entry& other : node.entries()) {
      if (other.value.kind() == Node::Kind::sequence) lists.push_back(other.key);
    }
    throw Error(entry.key_where, texts::unknown("list", entry.key, what, lists) +
                                     "; a map changes a list of the page that this one extends, a new one is a list");
  }

  // Throws Error if two elements have the same name, because names address the elements.
  void check_names() const {
    std::map<std::string, Location> seen;
    for (std::size_t i = 0; i < node.elements().size(); ++i) {
      const Node name = node.elements()[i]["name"];
      if (name.kind() != Node::Kind::scalar) continue;
      const auto [first, added] = seen.emplace(name.text(), name.where());
      if (added) continue;
      mistakes.add(Error(name.where(), fmt::format("{}: second element named {}; the first is at {}", what,
                                                   texts::in_quotes(name.text()), to_string(first->second))),
                   fmt::format("{}.{}.name", what, i));
    }
  }
};

// A known key without a colon (`assigner {plugin`) or without a space after it (`priority:10`). message: for the user.
struct Run {
  std::string key, message;
};
std::optional<Run> run_together(const std::string& written, const std::vector<std::string>& keys) {
  for (const std::string& key : keys) {
    if (!written.starts_with(key) || written.size() == key.size()) continue;
    if (written[key.size()] == ' ') return Run{key, fmt::format("':' is missing after {}", key)};
    if (written[key.size()] == ':') {
      return Run{key, fmt::format("{}: a space is missing after {}:", texts::in_quotes(written), key)};
    }
  }
  return std::nullopt;
}

void check_known(const Node& node, const std::string& what, const std::vector<std::string>& keys, Mistakes& mistakes) {
  for (const Node::Entry& entry : node.entries()) {
    if (std::ranges::find(keys, entry.key) != keys.end()) continue;
    if (const std::string_view present = present_name("", entry.key); std::ranges::find(keys, present) != keys.end()) {
      mistakes.add(Error(entry.key_where, fmt::format("{}.{} is now {}", what, entry.key, present)),
                   inside(what, entry.key));
      continue;
    }
    if (const std::optional<Run> run = run_together(entry.key, keys)) {
      mistakes.add(Error(entry.key_where, run->message), inside(what, run->key));
      continue;
    }
    mistakes.add(Error(entry.key_where, texts::unknown("key", entry.key, what, keys)), inside(what, entry.key));
    // A misspelt key, such as `lenght`, must not also be reported as the missing key `length`.
    if (const std::string_view meant = texts::nearest(entry.key, keys); !meant.empty()) {
      mistakes.doubt(inside(what, std::string(meant)));
    }
  }
}

// Chooses among keys of which a map may have only one. Returns the key that --set or an extending document has laid
// over the other keys, or null if all keys have the same source.
const Node::Entry* laid_over(const Node& node, const std::vector<const Node::Entry*>& keys) {
  const auto by_option = [](const Node::Entry* each) { return each->value.where().is_laid(); };
  const auto here = [&](const Node::Entry* each) { return each->value.where().file == node.where().file; };
  const auto typed = std::ranges::find_if(keys, by_option);
  if (typed != keys.end()) return std::ranges::all_of(keys, by_option) ? nullptr : *typed;
  const auto found = std::ranges::find_if(keys, here);
  return found == keys.end() || std::ranges::all_of(keys, here) ? nullptr : *found;
}

void check_exactly_one(const Map& map, const Node& node, const std::string& what, Mistakes& mistakes) {
  if (map.exactly_one.empty()) return;
  const std::string before = what.empty() ? "" : what + ": ";
  std::vector<const Node::Entry*> present;
  for (const std::string& key : map.exactly_one) {
    const auto found = std::ranges::find(node.entries(), key, &Node::Entry::key);
    if (found != node.entries().end()) present.push_back(&*found);
  }
  if (present.size() > 1) {
    std::string message = fmt::format("{}expected exactly one of {}", before, texts::join(map.exactly_one));
    const Node::Entry* const over = laid_over(node, present);
    if (over != nullptr) {
      const Node::Entry* const under = present[present.front() == over ? 1 : 0];
      message += fmt::format("; {0} is there already ({1}), and {0}: ~ takes it away", under->key,
                             to_string(under->key_where));
    }
    const Node::Entry& at = over != nullptr ? *over : *present[1];
    mistakes.add(Error(at.value.where(), message), inside(what, at.key));
  }
  const bool doubtful = std::ranges::any_of(
      map.exactly_one, [&](const std::string& key) { return mistakes.doubtful(inside(what, key)); });
  if (!present.empty() || doubtful) return;
  mistakes.add(Error(node.where(), fmt::format("{}expected one of {}", before, texts::join(map.exactly_one))),
               inside(what, map.exactly_one.front()));
}

// Checks the keys of a map: unknown keys, missing keys, groups that allow one key, and keys that need another key.
void check_keys(const Map& map, const Node& node, const std::string& what, Mistakes& mistakes) {
  check_known(node, what, texts::names_of(map.fields, &Field::key), mistakes);
  const std::string in = what.empty() ? "" : " in " + what;
  for (const Field& field : map.fields) {
    const std::string path = inside(what, field.key);
    if (!field.required || node[field.key] || mistakes.doubtful(path)) continue;
    mistakes.add(Error(node.where(), fmt::format("missing key \"{}\"{}", field.key, in)), path);
  }
  check_exactly_one(map, node, what, mistakes);
  for (const auto& [key, other] : map.needs) {
    if (!node[key] || node[other] || mistakes.doubtful(inside(what, other))) continue;
    mistakes.add(Error(node[key].where(), fmt::format("{}: makes sense only with {}", inside(what, key), other)),
                 inside(what, key));
  }
}

}  // namespace

void read(const Map& map, const Node& node, const std::string& what, Mistakes& mistakes) {
  check_keys(map, node, what, mistakes);
  for (const Field& field : map.fields) {
    const std::string path = inside(what, field.key);
    const Node value = node[field.key];
    if (!value) continue;
    mistakes.attempt(path, [&] { std::visit(Reader{value, path, mistakes}, field.kind); });
  }
  if (map.where) {
    // If the command line chose the plugin, the map gets the Location of the command line.
    const Node chosen = node["plugin"];
    *map.where = chosen && chosen.where().is_laid() ? chosen.where() : node.where();
    if (mistakes.doubtful(inside(what, "plugin")) || mistakes.doubtful(inside(what, "file"))) {
      mistakes.doubt_place(*map.where);
    }
  }
}

void refuse(const Node& document, std::initializer_list<std::string_view> paths, const std::string& reason) {
  for (const std::string_view path : paths) {
    if (const Node value = value_at(document, path)) throw Error(value.where(), reason);
  }
  throw Error(document.where(), reason);
}

}  // namespace regista::config
