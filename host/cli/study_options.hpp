// SPDX-License-Identifier: MIT
// The options of commands that play a study: those that lay values over its document, declared as the document is, and
// those that are no part of it, which say how it is played and where it is kept.
#pragma once

#include <list>
#include <span>
#include <string>
#include <vector>

#include "campaign/options.hpp"
#include "cli/common_names.hpp"
#include "config/documents.hpp"

namespace regista::cli {

// An option whose value takes the place of what stands at a path of the document.
struct DocumentOption {
  enum class Form {
    value,  // as it stands there
    list,   // given several times: a list of all
    pair,   // "0,20": a list
    teams,  // given several times: a list of {team: FILE}
  };
  const char *name, *path;
  Form form = Form::value;
  const char* instead_of = nullptr;  // a path whose value goes, too
};

// What such options were given, as they were typed.
class DocumentValues {
 public:
  // Of a document of this kind; help, range and unit are those of its declaration. Outlives the command's reading.
  void declare(Command& command, const config::DocumentKind& kind, std::span<const DocumentOption> options);
  // Those that every study's document has.
  void declare_common(Command& command, const config::DocumentKind& kind);
  config::Overrides overrides() const;

 private:
  struct Given {
    DocumentOption option;
    std::string value;
    std::vector<std::string> values;  // of a list
  };
  std::list<Given> given_;  // their places stay
  bool play_once_ = false;
};

struct StudyOptions : campaign::Options {
  std::string file;
  std::vector<std::string> set;
  DocumentValues values;

  // Throws config::Error for a value that is none.
  config::StudyRequest asked() const { return {file, values.overrides(), set}; }
};

// Workers, results, recording, page and form of the report. default_results: what the help says.
void add_campaign_options(Command& command, campaign::Options& options, const std::string& default_results);

}  // namespace regista::cli
