// SPDX-License-Identifier: MIT
#include "config/reference.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cassert>
#include <set>
#include <string_view>
#include <vector>

#include "config/declaration.hpp"
#include "config/place.hpp"
#include "config/scalar.hpp"
#include "config/team_page.hpp"

namespace regista::config {
namespace {

struct Form {
  std::string_view name, text;
};

// What Own and Free refer to, but for those whose text is made below.
constexpr std::array forms{
    Form{"segment", "A list of two places: `[ball, own_goal]`."},
    Form{"line", "A text of one line."},
    Form{"lines", "A list of texts, each of one line."},
    Form{"pairs", "A list of pairs of texts: `[[a, b], [a, c]]`."},
    Form{"values", "A list of different values, of whatever the path leads to."},
    Form{"paths", "A file or a folder, or a list of these. Relative names begin at the folder of the document."},
    Form{"robots", "`all`, `any`, a shirt number, or a list of shirt numbers."},
    Form{"moments", "Seconds of the match, a number or a list of numbers."},
    Form{"settings", "A map from paths to values, as `--set` takes them: `{a.sender.params.reserve: 20}`."},
    Form{"measured",
         "The name of a number of a match ([metrics.md](metrics.md)), or a map from such names to weights."},
    Form{"tuned", "A list of paths, each as a text or as `{path: PATH, range: [least, largest]}`."},
    Form{"plugin",
         "`{plugin: ID, params: {NAME: VALUE}}`: a plugin of that kind with its parameters "
         "([plugin-reference.md](plugin-reference.md)). `file: FILE` beside it names a certain shared object, instead "
         "of "
         "the one that the search finds."},
    Form{"params", "A map from parameters of the plugin to their values ([plugin-reference.md](plugin-reference.md))."},
};

std::string text_of_form(const std::string& name) {
  if (name == "place") {
    std::vector<std::string> anchors;
    for (const std::string& each : anchor_names()) anchors.push_back('`' + each + '`');
    return fmt::format("A point of the field: {}, or `[x, y]` in metres.", fmt::join(anchors, ", "));
  }
  if (name == "use") {
    std::vector<std::string> keys;
    for (const std::string& each : usable_keys()) keys.push_back('`' + each + '`');
    return fmt::format(
        "A map from paths of the team, beginning with one of {}, to the values that hold instead; "
        "`roles` names a list of roles.",
        fmt::join(keys, ", "));
  }
  for (const Form& each : forms) {
    if (each.name == name) return std::string(each.text);
  }
  assert(false && "a form that nobody describes");
  return {};
}

std::string in_cell(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|') out += '\\';
    out += c;
  }
  return out;
}

std::string with_article(const std::string& kind) {
  return (std::string_view("aeio").find(kind.front()) == std::string_view::npos ? "a " : "an ") + kind;
}

// plugin, file and params.
constexpr std::size_t plugin_keys = 3;

class TableWriter {
 public:
  explicit TableWriter(std::set<std::string>& used) : used_(used) {}

  void map(const Map& declared, const std::string& prefix) {
    std::vector<std::string> keys;
    for (const Field& each : declared.fields) {
      if (!declared.plugin_kind.empty() && each.key == "plugin") {
        row(prefix + each.key, "id of " + with_article(declared.plugin_kind), each);
      } else {
        field(each, prefix);
      }
    }
    for (const std::string& key : declared.exactly_one) keys.push_back(fmt::format("`{}{}`", prefix, key));
    if (!keys.empty()) remarks_ += fmt::format("\nExactly one of {} must be given.\n", fmt::join(keys, ", "));
    for (const auto& [key, other] : declared.needs) {
      remarks_ += fmt::format("\n`{0}{1}` goes with `{0}{2}`.\n", prefix, key, other);
    }
  }

  std::string text() const { return "| key | value | default | meaning |\n|---|---|---|---|\n" + rows_ + remarks_; }

 private:
  void row(const std::string& path, const std::string& value, const Field& field, const std::string& initial = {}) {
    const std::string shown = field.required                ? "required"
                              : !field.default_from.empty() ? "from " + field.default_from
                              : initial.empty()             ? ""
                                                            : fmt::format("`{}`", initial);
    rows_ += fmt::format("| `{}` | {} | {} | {} |\n", path, in_cell(value), shown, in_cell(field.doc));
  }

  void field(const Field& field, const std::string& prefix) {
    std::visit([&](const auto& kind) { write(field, kind, prefix + field.key); }, field.kind);
  }

  void write(const Field& field, const Real& real, const std::string& path) {
    row(path, range_text(real.range, real.unit), field,
        real.member.present() ? fmt::format("{:.10g}", real.member.get() / real.scale) : "");
  }
  void write(const Field& field, const Integer& integer, const std::string& path) {
    row(path, "whole, " + range_text(integer.range, integer.unit), field,
        integer.present() ? fmt::format("{}", integer.get()) : "");
  }
  void write(const Field& field, const Boolean& boolean, const std::string& path) {
    row(path, "`true` or `false`", field, !boolean.member.present() ? "" : boolean.member.get() ? "true" : "false");
  }
  void write(const Field& field, const Name& name, const std::string& path) {
    row(path, "a name", field, name.member.present() ? name.member.get() : "");
  }
  void write(const Field& field, const File& file, const std::string& path) {
    row(path, "a file", field, file.built_in);
  }
  void write(const Field& field, const Paths&, const std::string& path) { form(field, "paths", path); }
  void write(const Field& field, const Choice& choice, const std::string& path) {
    row(path, fmt::format("`{}`", fmt::join(choice.names, "`, `")), field, choice.names[choice.get()]);
  }
  void write(const Field& field, const Numbers& numbers, const std::string& path) {
    std::vector<std::string> values;
    if (numbers.present()) {
      for (const double* each : numbers.get()) values.push_back(fmt::format("{:.10g}", *each));
    }
    row(path,
        fmt::format("a list of {}{} numbers, {}", numbers.count, numbers.ascending ? " ascending" : "",
                    range_text(numbers.range, numbers.unit)),
        field, values.empty() ? "" : fmt::format("[{}]", fmt::join(values, ", ")));
  }
  void write(const Field& field, const Own& own, const std::string& path) { form(field, own.definition, path); }
  void write(const Field& field, const Free& free, const std::string& path) { form(field, free.definition, path); }
  void form(const Field& field, const std::string& name, const std::string& path) {
    used_.insert(name);
    row(path, fmt::format("[{0}](#{0})", name), field);
  }
  void write(const Field& field, const Section& section, const std::string& path) {
    const Map inside = section.open();
    if (!inside.plugin_kind.empty() && inside.fields.size() == plugin_keys) {
      used_.insert("plugin");
      row(path, fmt::format("{}, a [plugin](#plugin)", with_article(inside.plugin_kind)), field);
      return;
    }
    row(path, "a map", field);
    map(inside, path + '.');
  }
  void write(const Field& field, const List& list, const std::string& path) {
    row(path, fmt::format("a list of {} to {} maps", list.least, list.most), field);
    map(list.append(), path + "[].");
  }
  void write(const Field& declared, const Dictionary& dictionary, const std::string& path) {
    row(path, fmt::format("a map of {} to {} names", dictionary.least, dictionary.most), declared);
    field(dictionary.append("NAME"), path + '.');
  }

  std::set<std::string>& used_;
  std::string rows_, remarks_;
};

}  // namespace

std::string reference_text(std::span<const DocumentKind> kinds) {
  std::string out =
      "# Documents\n\nWritten by `regista config reference` from the declarations by which documents are read. "
      "`roles.NAME[].target` is the key\n`target` of each element of the list that stands under a name of yours in "
      "`roles`.\n";
  std::set<std::string> used;
  for (const DocumentKind& kind : kinds) {
    TableWriter writer(used);
    kind.with_defaults([&](const Map& declared) { writer.map(declared, ""); });
    out += fmt::format("\n## {}\n\n{}\n\n{}", kind.name, kind.about, writer.text());
  }
  if (!used.empty()) out += "\n## Forms of values\n";
  for (const std::string& name : used) out += fmt::format("\n### {}\n\n{}\n", name, text_of_form(name));
  return out;
}

}  // namespace regista::config
