// SPDX-License-Identifier: MIT
// Where matches are taken over from one file of results into another, an error of the database may be of either; this
// is one of the file that is read.
#pragma once

#include <SQLiteCpp/Exception.h>

#include <stdexcept>

namespace regista::campaign {

class OtherFile : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  // Does `work`, which reads the other file. Throws OtherFile for SQLite::Exception, and what else `work` throws.
  template <class Work>
  static auto reading(Work work) {
    try {
      return work();
    } catch (const SQLite::Exception& error) {
      throw OtherFile(error.what());
    }
  }
};

}  // namespace regista::campaign
