// SPDX-License-Identifier: MIT
#include "report/outline.hpp"

#include "report/match_remarks.hpp"
#include "texts/json.hpp"
#include "texts/visible.hpp"

namespace regista::report {

std::string plain(const Sentence& sentence) {
  std::string out;
  for (const Sentence::Piece& each : sentence.pieces()) {
    if (each.kind != Sentence::Kind::mark) out += texts::visible(each.text);
  }
  return out;
}

std::string question_of(const Outline& outline) {
  return outline.name.empty() || outline.question.empty() ? outline.question : outline.name + ": " + outline.question;
}

void Section::line(Sentence sentence, Readers readers) {
  if (sentence.empty()) return;
  // What follows each other is one block.
  auto* const last =
      items.empty() || items.back().readers != readers ? nullptr : std::get_if<Lines>(&items.back().what);
  if (last != nullptr && last->look == Lines::Look::paragraphs)
    last->lines.push_back(std::move(sentence));
  else
    items.push_back({Lines{{std::move(sentence)}, Lines::Look::paragraphs}, readers});
}

void Section::note(Sentence sentence, Readers readers) {
  if (!sentence.empty()) items.push_back({Lines{{std::move(sentence)}, Lines::Look::note}, readers});
}

void Section::list(std::vector<Sentence> sentences, Readers readers) {
  if (!sentences.empty()) items.push_back({Lines{std::move(sentences), Lines::Look::list}, readers});
}

void Section::table(Table table, Readers readers) {
  if (!table.rows.empty()) items.push_back({std::move(table), readers});
}

void Section::figures(std::vector<std::string> names, Figures::Look look) {
  items.push_back({Figures{std::move(names), look}, Readers::page});
}

void Section::listing(Sentence summary, std::string text) {
  if (!text.empty()) items.push_back({Listing{std::move(summary), std::move(text)}, Readers::page});
}

std::string outline_json(const Outline& outline) {
  nlohmann::ordered_json out{{"played", played_json(outline.played)}, {"headline", plain(outline.headline)}};
  std::vector<std::string> beside;
  for (const Sentence& each : outline.beside) beside.push_back(plain(each));
  out["beside"] = beside;
  out.update(outline.data());
  add_remarks(outline.remarks, out);
  return out.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

}  // namespace regista::report
