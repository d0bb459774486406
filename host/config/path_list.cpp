// SPDX-License-Identifier: MIT
#include "config/path_list.hpp"

#include <filesystem>
#include <system_error>

#include "config/file.hpp"
#include "config/scalar.hpp"

namespace regista::config {

Field paths(std::string key, std::vector<NamedPath>& paths, std::string doc) {
  return {
      std::move(key), std::move(doc),
      Own{"paths",
          [&paths](const Node& node, const std::string& what, Mistakes& mistakes) {
            const bool one = node.kind() == Node::Kind::scalar;
            const std::vector<Node> single{node};
            for (const Node& each : one ? std::span<const Node>(single) : elements_of(node, what, "a list of paths")) {
              mistakes.attempt(what, [&] {
                const std::filesystem::path path = named_file(each, what);
                std::error_code none;
                if (!std::filesystem::is_directory(path, none)) existing_file(each, what);
                paths.push_back({std::filesystem::absolute(path).lexically_normal().string(), each.where()});
              });
            }
          },
          [&paths] {
            std::vector<Node> out;
            for (const NamedPath& each : paths) out.push_back(Node::scalar(each.path, true, {}));
            return out.empty() ? Node() : Node::sequence(std::move(out), {});
          }}};
}

}  // namespace regista::config
