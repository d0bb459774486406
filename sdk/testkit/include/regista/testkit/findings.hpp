// SPDX-License-Identifier: MIT
// What a check found, one line each, in the words of the person who has to repair it. No findings: sound.
#pragma once

#include <cstddef>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace regista::testkit {

class Findings {
 public:
  // Hears of each place before it is played: what says so when a plugin takes the process with it.
  using Underway = std::function<void(const std::string& corner, const std::string& scene)>;

  Findings() = default;
  explicit Findings(Underway underway) : underway_(std::move(underway)) {}

  // Texts before every finding that follows: which parameters, which scene.
  void where(std::string corner, std::string scene);
  // The same text is kept once, with the first place where it was seen.
  template <class... Parts>
  void say(const Parts&... parts) {
    add(text_of(parts...), found_);
  }
  // What may be meant, and may be a mistake. It is no finding.
  template <class... Parts>
  void doubt(const Parts&... parts) {
    add(text_of(parts...), doubts_);
  }
  // What is worth knowing of a sound plugin too. It is no finding.
  template <class... Parts>
  void remark(const Parts&... parts) {
    remarks_.push_back(text_of(parts...));
  }
  bool empty() const { return found_.lines.empty(); }
  // Of each a readable number; a last line tells how many there are beside.
  std::vector<std::string> doubts() const { return doubts_.told(); }
  const std::vector<std::string>& remarks() const { return remarks_; }
  std::vector<std::string> lines() const { return found_.told(); }
  std::string text() const;

 private:
  template <class... Parts>
  static std::string text_of(const Parts&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
  }
  struct List {
    std::vector<std::string> lines;
    std::size_t left_out = 0;
    std::vector<std::string> told() const;
  };
  void add(const std::string& text, List& list);
  std::string place() const;  // " (low = 0; one robot)", or nothing

  static constexpr std::size_t most = 20;
  List found_, doubts_;
  std::vector<std::string> seen_, remarks_;
  Underway underway_;
  std::string corner_, scene_;
};

}  // namespace regista::testkit
