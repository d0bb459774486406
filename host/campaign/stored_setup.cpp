// SPDX-License-Identifier: MIT
#include "campaign/stored_setup.hpp"

#include <filesystem>
#include <utility>

#include "campaign/inputs.hpp"
#include "campaign/job_setup.hpp"
#include "campaign/mathematics.hpp"
#include "config/bad_input.hpp"

namespace regista::campaign {

StoredSetup::StoredSetup(const Job& stored, const plugin::Catalogue& catalogue,
                         const std::function<std::vector<Document>()>& documents)
    : catalogue_(catalogue), job_(stored), changed_(set_up()), missing_(changed_) {
  if (changed_.empty()) return;
  std::vector<Document> begun_with = documents();
  if (begun_with.empty()) return;
  const std::filesystem::path given_in = std::filesystem::current_path();
  copies_.emplace(std::move(begun_with));
  job_ = copies_->job(stored, given_in);
  std::filesystem::current_path(copies_->folder(given_in));
  missing_ = set_up();
}

// What is not as it was; empty when nothing.
std::string StoredSetup::set_up() {
  try {
    prepared_ = match_setup(request_of(job_), catalogue_);
  } catch (const config::Error& error) {
    return error.what();
  } catch (const config::BadInput& error) {
    return error.what();
  }
  return what_changed(job_, prepared_, catalogue_, program_hash(), mathematics_fingerprint(),
                      copies_ ? copies_->root().string() : "");
}

}  // namespace regista::campaign
