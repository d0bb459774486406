// SPDX-License-Identifier: MIT
#include "report/configuration_difference.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "config/parse.hpp"

namespace regista::report {
namespace {

using config::Node;

struct Value {
  std::string path, text;
};

bool is_plain(const Node& node) {
  return node.kind() == Node::Kind::scalar || node.kind() == Node::Kind::null || node.kind() == Node::Kind::absent;
}

std::string plain_text(const Node& node) { return node.kind() == Node::Kind::scalar ? node.text() : "null"; }

// A value in one line.
std::string flow(const Node& node) {
  if (is_plain(node)) return plain_text(node);
  const bool map = node.kind() == Node::Kind::map;
  std::string out(1, map ? '{' : '[');
  const auto comma = [&out] {
    if (out.size() > 1) out += ", ";
  };
  for (const Node::Entry& entry : node.entries()) {
    comma();
    out += entry.key + ": " + flow(entry.value);
  }
  for (const Node& element : node.elements()) {
    comma();
    out += flow(element);
  }
  return out + (map ? '}' : ']');
}

// Every element is a map with a name of its own.
bool is_named(const Node& sequence) {
  std::set<std::string> names;
  return std::ranges::all_of(sequence.elements(), [&](const Node& element) {
    const Node name = element["name"];
    return name.kind() == Node::Kind::scalar && names.insert(name.text()).second;
  });
}

void collect(const Node& node, const std::string& path, std::vector<Value>& out) {
  if (node.kind() == Node::Kind::map && !node.entries().empty()) {
    for (const Node::Entry& entry : node.entries()) {
      collect(entry.value, path.empty() ? entry.key : path + '.' + entry.key, out);
    }
  } else if (node.kind() == Node::Kind::sequence && !node.elements().empty() && is_named(node)) {
    std::string order;
    for (const Node& element : node.elements()) {
      const std::string& name = element["name"].text();
      order += (order.empty() ? "" : ", ") + name;
      for (const Node::Entry& entry : element.entries()) {
        if (entry.key != "name") collect(entry.value, path + '[' + name + "]." + entry.key, out);
      }
    }
    out.push_back({path, order});
  } else {
    out.push_back({path, flow(node)});
  }
}

}  // namespace

std::vector<DifferingValue> differing_values(std::span<const std::string> documents) {
  std::vector<DifferingValue> rows;
  std::map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < documents.size(); ++i) {
    std::vector<Value> values;
    collect(config::parse_text(documents[i], "resolved document"), "", values);
    for (Value& each : values) {
      const auto [at, fresh] = known.try_emplace(each.path, rows.size());
      if (fresh) {
        rows.push_back({each.path, std::vector<std::optional<std::string>>(documents.size())});
      }
      rows[at->second].values[i] = std::move(each.text);
    }
  }
  std::erase_if(rows, [](const DifferingValue& row) {
    return std::ranges::all_of(row.values, [&](const auto& value) { return value == row.values.front(); });
  });
  return rows;
}

}  // namespace regista::report
