// SPDX-License-Identifier: MIT
// What can go wrong with a file of results.
#pragma once

#include <stdexcept>

namespace regista::campaign {

// The file cannot be used as it is: what() is one line that names it and says why.
class StoreRefusal : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Another process writes to the file now.
class StoreInUse : public StoreRefusal {
  using StoreRefusal::StoreRefusal;
};

// Writing or reading failed later on, such as on a full disk.
class StoreError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A StoreError that is the disk's: it is full, or fails.
class StoreDiskError : public StoreError {
  using StoreError::StoreError;
};

// A StoreError that no other try mends: what stands there is not what was written. what() names the matches.
class StoreDamaged : public StoreError {
  using StoreError::StoreError;
};

// A StoreError after which there is nothing to go on with: the file was deleted, replaced or moved while it was open.
class StoreGone : public StoreError {
  using StoreError::StoreError;
};

}  // namespace regista::campaign
