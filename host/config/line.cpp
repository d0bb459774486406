// SPDX-License-Identifier: MIT
#include "config/line.hpp"

#include "config/scalar.hpp"

namespace regista::config {

std::string to_line(const Node& node, const std::string& what) {
  std::string text = to_text(node, what);
  if (text.find('\n') != std::string::npos) throw Error(node.where(), what + ": expected one line");
  return text;
}

Field line(std::string key, std::string& text, std::string doc) {
  return {std::move(key), std::move(doc),
          Own{"line", [&text](const Node& node, const std::string& what, Mistakes&) { text = to_line(node, what); },
              [&text] { return text.empty() ? Node() : Node::scalar(text, true, {}); }}};
}

Field lines(std::string key, std::vector<Node>& texts, std::string doc) {
  return {std::move(key), std::move(doc),
          Own{"lines",
              [&texts](const Node& node, const std::string& what, Mistakes& mistakes) {
                const auto elements = elements_of(node, what, "a list of texts");
                for (const Node& each : elements) mistakes.attempt(what, [&] { to_line(each, what); });
                texts.assign(elements.begin(), elements.end());
              },
              [&texts] { return texts.empty() ? Node() : Node::sequence(texts, {}); }}};
}

}  // namespace regista::config
