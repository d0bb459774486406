// SPDX-License-Identifier: MIT
#include "report/gnuplot.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "config/file.hpp"
#include "process/program.hpp"
#include "process/temporary_folder.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds patience{60};
constexpr std::size_t longest_complaint = 4096;

bool write(const fs::path& file, const std::string& bytes) {
  std::ofstream out(file, std::ios::binary);
  out << bytes;
  out.close();
  return out.good();
}

process::ProgramEnd run_gnuplot(const fs::path& folder, const std::string& script) {
  const char* const path = std::getenv("PATH");
  process::ProgramCall call;
  call.words = {"gnuplot", "-d", script};  // -d: no files of settings
  call.folder = folder;
  // No locale, font or terminal of the user's: the same picture everywhere.
  call.environment = {
      {"LC_ALL=C.UTF-8", "HOME=" + folder.string(), fmt::format("PATH={}", path == nullptr ? "" : path)}};
  call.patience = patience;
  call.longest_text = longest_complaint;
  return process::run_program(call);
}

// What went wrong stands last, after warnings.
std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n^");
  if (end == std::string::npos) return "it does not say why";
  const std::size_t before = text.rfind('\n', end), begin = before == std::string::npos ? 0 : before + 1;
  return texts::visible_at_most(text.substr(begin, end + 1 - begin), 200);
}

// Into the named file of the folder. Empty: done.
std::string picture(const fs::path& folder, Drawing& drawing, Picture kind) {
  const std::string script = drawing.figure.name + (kind == Picture::svg ? ".gnuplot" : ".png.gnuplot");
  if (!write(folder / script, gnuplot_script(drawing.figure, kind))) return "temporary files cannot be written";
  const process::ProgramEnd ended = run_gnuplot(folder, script);
  if (!ended.found) {
    drawing.no_gnuplot = true;
    return "gnuplot is not installed";
  }
  if (!ended.in_time) return fmt::format("gnuplot took more than {} s", patience.count());
  if (ended.end.signal_number()) return "gnuplot: " + ended.end.in_words();
  if (!ended.succeeded()) return "gnuplot: " + last_line(ended.errors);
  std::string& bytes = kind == Picture::svg ? drawing.svg : drawing.png;
  bytes = config::file_content(folder / (drawing.figure.name + (kind == Picture::svg ? ".svg" : ".png"))).value_or("");
  return bytes.empty() ? "gnuplot wrote no picture" : "";
}

void draw_into(Drawing& out, Png png) {
  const process::TemporaryFolder folder;
  if (!write(folder.path() / (out.figure.name + ".csv"), out.figure.csv)) {
    out.why_not = "temporary files cannot be written";
    return;
  }
  out.why_not = picture(folder.path(), out, Picture::svg);
  if (out.why_not.empty() && png == Png::wanted) out.why_not = picture(folder.path(), out, Picture::png);
}

}  // namespace

Drawing draw(Figure figure, Png png) {
  Drawing out;
  out.figure = std::move(figure);
  try {
    draw_into(out, png);
  } catch (const std::system_error& error) {
    out.why_not = texts::visible(error.what());
  }
  return out;
}

}  // namespace regista::report
