// SPDX-License-Identifier: MIT
#include "campaign/decision_trail.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "match/digest.hpp"
#include "texts/bytes.hpp"

namespace regista::campaign {
namespace {

constexpr std::size_t room = std::size_t{1} << 16;

struct Entry {
  double time = 0.0;
  std::int32_t side = 0, robot = 0;
  std::uint64_t outcome = 0;  // hash of the decision's outcome
  std::uint32_t answers = 0;
};

template <class Archive>
void visit(Archive& archive, Entry& entry) {
  archive(entry.time, entry.side, entry.robot, entry.outcome, entry.answers);
}

using Name = std::pair<std::string, std::string>;  // plugin and call

template <std::size_t N>
std::string text_of(const std::array<char, N>& raw) {
  return {raw.data(), strnlen(raw.data(), N)};
}

class TrailReader {
 public:
  explicit TrailReader(std::string_view trail)
      : bytes_({reinterpret_cast<const std::uint8_t*>(trail.data()), trail.size()}) {}
  bool at_end() const { return bytes_.empty(); }

  // Reads the next decision. The caller must then call answer() Entry::answers times.
  Entry entry() {
    Entry out;
    bytes_(out);
    return out;
  }
  std::pair<Name, std::uint64_t> answer() {
    std::uint32_t name = 0;
    std::uint64_t digest = 0;
    bytes_(name, digest);
    if (name == names_.size()) {
      Name& added = names_.emplace_back();
      bytes_(added.first, added.second);
    }
    return {names_.at(name), digest};
  }

 private:
  texts::BytesIn bytes_;
  std::vector<Name> names_;
};

constexpr bool is_use_of_the_host(std::string_view call) { return call == "offer" || call == "withdraw"; }

// Returns the first difference between two plays of the same decision, with the plugin; empty if all answers are equal.
std::string difference(TrailReader& first, const Entry& one, TrailReader& second, const Entry& other) {
  std::string out;
  for (std::uint32_t i = 0; i < std::max(one.answers, other.answers); ++i) {
    std::optional<std::pair<Name, std::uint64_t>> a, b;
    if (i < one.answers) a = first.answer();
    if (i < other.answers) b = second.answer();
    if (a == b || !out.empty()) continue;
    // If the two plays differ in their calls, the extra call is named: an "offer" or "withdraw" of one play only.
    const Name& name = a && (!b || a->first == b->first || is_use_of_the_host(a->first.second)) ? a->first : b->first;
    const auto& [plugin, call] = name;
    out = is_use_of_the_host(call)
              ? fmt::format("plugin {} made another {}", plugin, call == "offer" ? "offer" : "withdrawal")
              : fmt::format("plugin {} answered {} otherwise", plugin, call);
  }
  if (out.empty() && one.outcome != other.outcome) out = "what it did differed, though its plugins answered the same";
  return out;
}

}  // namespace

void TrailWriter::add(const match::Decision& decision, std::span<const plugin::CallAnswer> answers) {
  match::Digest outcome;
  match::add(outcome, decision.outcome);
  for (const mind::MetricReport& each : decision.outcome.metrics) {
    outcome.add(each.metric);
    outcome.add(each.count);
    outcome.add(each.sum);
    outcome.add(each.last);
  }
  texts::BytesOut bytes;
  Entry entry{decision.time, static_cast<std::int32_t>(match::index(decision.side)), decision.number, outcome.value(),
              static_cast<std::uint32_t>(answers.size())};
  bytes(entry);
  for (const plugin::CallAnswer& each : answers) {
    Name name{text_of(each.plugin), text_of(each.call)};
    const auto [known, is_new] = names_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
    bytes(known->second, each.digest);
    if (is_new) bytes(name.first, name.second);
  }
  waiting_.append(bytes.bytes().begin(), bytes.bytes().end());
  if (waiting_.size() >= room) flush();
}

void TrailWriter::flush() {
  process::write_all(descriptor_, waiting_);  // on an error the trail ends early, which first_difference() reports
  waiting_.clear();
}

process::FileDescriptor trail_file() {
  process::FileDescriptor out(memfd_create("regista-trail", MFD_CLOEXEC));
  if (!out.is_open()) throw std::system_error(errno, std::generic_category(), "cannot make a trail");
  return out;
}

void empty_trail(int descriptor) {
  if (ftruncate(descriptor, 0) == -1 || lseek(descriptor, 0, SEEK_SET) == -1)
    throw std::system_error(errno, std::generic_category(), "cannot begin a match anew");
}

std::string first_difference(std::string_view first, std::string_view second) {
  if (first == second) return {};
  TrailReader a(first), b(second);
  try {
    std::map<std::pair<std::int32_t, std::int32_t>, std::uint64_t> decisions;  // decisions so far, by side and robot
    while (!a.at_end() && !b.at_end()) {
      const Entry one = a.entry(), other = b.entry();
      const std::uint64_t tick = decisions[{one.side, one.robot}]++;
      const std::string who =
          fmt::format("{}, robot {}, tick {} ({:.2f} s)", one.side == 0 ? "home" : "away", one.robot, tick, one.time);
      if (one.time != other.time || one.side != other.side || one.robot != other.robot)
        return fmt::format("{}: it was not its turn in the second play", who);
      if (const std::string what = difference(a, one, b, other); !what.empty()) return fmt::format("{}: {}", who, what);
    }
  } catch (const std::out_of_range&) {
  }
  return "one of the plays ended earlier";
}

}  // namespace regista::campaign
