// SPDX-License-Identifier: MIT
// Options that several commands have: --plugins, and the options of commands that play a study.
#pragma once

#include <list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/engine.hpp"
#include "cli/command_line.hpp"
#include "config/documents.hpp"
#include "plugin/catalogue.hpp"

namespace regista::cli {

// --- The option `--plugins`, and messages about the files in its folders.

// Adds the option `--plugins DIR`, which may be repeated.
void add_plugin_folders(Command& command, std::vector<std::string>& folders);

using results::open_plugins;

// The arguments of simple commands. words: the arguments that are not options.
struct PlainOptions {
  std::vector<std::string> words, plugins, set;
  bool json = false;
};

// Returns the word if there is exactly one. Else throws BadInput "EXPECTED, N given ADVICE"; N is the number of words.
const std::string& the_only(const std::vector<std::string>& words, std::string_view expected,
                            std::string_view advice = "");

// Returns the folders that the catalogue has searched. A command must not write into these folders (output_files.hpp).
std::vector<std::string> folders_of(const plugin::Catalogue& catalogue);

// Prints a line on standard error for each file of these folders that the catalogue refused, and for each remark of the
// catalogue. A user who names a folder expects the program to use all plugins of the folder.
void tell_what_is_not_used(const plugin::Catalogue& catalogue, const std::vector<std::string>& folders);

// --- Options of commands that play a study. A document option (DocumentOption) replaces a value of the study's
// document. The other options say how the program plays the study and where it stores the results.

// An option whose value replaces the value at a path of the document.
struct DocumentOption {
  enum class Form {
    value,  // one value
    list,   // a list; the option may be repeated
    pair,   // a list of two numbers: "0,20"
    teams,  // a list of {team: FILE}; the option may be repeated
  };
  const char *name, *path;
  Form form = Form::value;
  const char* instead_of = nullptr;  // path of another value; the option removes this value
};

// Stores the values of document options as the user typed them.
class DocumentValues {
 public:
  // Adds the options `own` of one kind of document, then the options that every study has. Help, range and unit of an
  // option come from the declaration of the document. This object must outlive the parsing of the command line.
  void declare(Command& command, const config::DocumentKind& kind, std::span<const DocumentOption> own);
  config::Overrides overrides() const;

 private:
  struct Given {
    DocumentOption option;
    std::string value;
    std::vector<std::string> values;  // elements of a list
  };
  std::list<Given> given_;  // a list, because the addresses of its elements must stay valid
  bool play_once_ = false;
};

struct StudyOptions : campaign::Options {
  std::string file;
  std::vector<std::string> set;
  DocumentValues values;

  // Throws config::Error for an invalid value.
  config::StudyRequest asked() const { return {file, values.overrides(), set}; }
};

// Adds the options that change the study's document: DocumentValues and --set. whose: how the help names the document.
void add_document_options(Command& command, StudyOptions& options, const config::DocumentKind& kind,
                          std::span<const DocumentOption> own, std::string_view whose = "that document");

// Adds the options that a study may have anew each time it is gone on with: workers, time limit, recording, message at
// the end, page and report.
void add_playing_options(Command& command, campaign::Options& options);

// Adds these, and options for plugins and results. default_results: the default file, for help.
void add_campaign_options(Command& command, campaign::Options& options, const std::string& default_results);

}  // namespace regista::cli
