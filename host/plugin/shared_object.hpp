// SPDX-License-Identifier: MIT
// Opens one shared object and shakes hands with it. What can be known without running its code is asked of libelf
// first, so that a broken file or a text file named .so is refused without running constructors. Whatever the file does
// when it is loaded happens in this process: survey.hpp looks at files that nobody trusts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <regista/abi.h>

namespace regista::plugin {

struct SharedObject {
  std::vector<const regista_descriptor*> descriptors;  // checked; they live for ever
  std::string refusal;                                 // one line; empty when the object may be used
  std::string remark;                                  // one line: what loading it did and was undone; mostly empty
};

// Never throws for what is wrong with the file: it says so in `refusal`.
SharedObject open_shared_object(const std::filesystem::path& file);

}  // namespace regista::plugin
