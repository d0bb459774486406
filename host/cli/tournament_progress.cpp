// SPDX-License-Identifier: MIT
#include "cli/tournament_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "cli/end_of_program.hpp"
#include "cli/tournament_report.hpp"

namespace regista::cli {
namespace {

constexpr std::chrono::milliseconds between_drawings{200};

bool can_rewrite() {
  const char* const type = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && type != nullptr && std::string_view(type) != "dumb";
}

// What is lost of this is lost: it is no result.
void say(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace

TournamentProgress::TournamentProgress(std::array<std::string, 2> labels, std::uint64_t matches, bool wanted)
    : labels_(std::move(labels)), matches_(matches), wanted_(wanted), rewrite_(wanted && can_rewrite()) {}

TournamentProgress::~TournamentProgress() { clear(); }

void TournamentProgress::match(std::uint64_t index, const study::Fixture& fixture, const campaign::Decided& decided,
                               bool fresh, const study::Standing& standing) {
  ++(fresh ? played_ : stored_);
  if (!wanted_) return;
  if (rewrite_) {
    draw(standing);
    return;
  }
  if (!fresh) return;
  const std::size_t a = fixture.swapped ? 1 : 0;
  std::string line =
      fmt::format("match {} of {}, seed {}: {} {}:{} {}{}", index + 1, matches_, fixture.seed, labels_[0],
                  decided.score[a], decided.score[1 - a], labels_[1], fixture.swapped ? " at home" : "");
  if (decided.failure) {
    const bool by_a = static_cast<std::size_t>(decided.failure->side) == a;
    line += ", " + forfeit_text(labels_[by_a ? 0 : 1], *decided.failure);
  }
  say(line + '\n');
}

void TournamentProgress::draw(const study::Standing& standing) {
  const auto now = Clock::now();
  if (now - drawn_ < between_drawings) return;
  drawn_ = now;
  shown_ = true;
  const double rate = static_cast<double>(played_) / std::chrono::duration<double>(now - began_).count();
  const std::uint64_t done = stored_ + played_;
  const std::string left =
      played_ == 0 ? "" : fmt::format(", about {:.0f} s left", static_cast<double>(matches_ - done) / rate);
  say(fmt::format("\r\x1b[K{} of {} matches, {} W {} L {} D, goals {}:{}, {:.2f} matches/s{}", done, matches_,
                  standing.wins, standing.losses, standing.draws, standing.goals[0], standing.goals[1], rate, left));
}

void TournamentProgress::tell(std::string_view line) {
  clear();
  complain(line);
}

void TournamentProgress::clear() {
  if (!shown_) return;
  shown_ = false;
  say("\r\x1b[K");
}

}  // namespace regista::cli
