// SPDX-License-Identifier: MIT
// Reads a document into the object of a declaration.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "config/declaration.hpp"
#include "config/errors.hpp"
#include "config/node.hpp"

namespace regista::config {

// Fills the declared object and reports every value that contradicts its declaration. `what` is the path of the map, ""
// for the whole document. A member keeps its value if the document's value is missing or wrong. A list gets one element
// for each element of the document's list, even for a wrong element.
void read(const Map& map, const Node& node, const std::string& what, Mistakes& mistakes);

// Returns the path of a key inside of a map.
inline std::string inside(const std::string& map, const std::string& key) {
  return map.empty() ? key : map + '.' + key;
}

// Runs step(element, path, index) for each element of a list. With After::go_on, a mistake does not end the loop.
template <class Step>
void attempt_each(const Node& list, std::string_view what, Mistakes& mistakes, Step step) {
  for (std::size_t i = 0; i < list.elements().size(); ++i) {
    const std::string path = fmt::format("{}.{}", what, i);
    mistakes.attempt(path, [&] { step(list.elements()[i], path, i); });
  }
}

// Throws Error for values that are valid alone but contradict each other. The place of the Error is the first path of
// `paths` that exists in the document, otherwise the document.
[[noreturn]] void refuse(const Node& document, std::initializer_list<std::string_view> paths,
                         const std::string& reason);

// Reports contradicting values at the place that refuse() chooses, but not if the value at one of the paths is wrong or
// unknown: the contradiction may then follow from that mistake.
class Refusals {
 public:
  Refusals(const Node& document, Mistakes& mistakes) : document_(document), mistakes_(mistakes) {}

  template <class... Values>
  void operator()(std::initializer_list<std::string_view> paths, fmt::format_string<Values...> reason,
                  Values&&... values) const {
    if (std::ranges::any_of(paths, [&](std::string_view path) { return mistakes_.doubtful(path); })) return;
    const std::string message = fmt::format(reason, std::forward<Values>(values)...);
    mistakes_.attempt(*paths.begin(), [&] { refuse(document_, paths, message); });
  }

 private:
  const Node& document_;
  Mistakes& mistakes_;
};

}  // namespace regista::config
