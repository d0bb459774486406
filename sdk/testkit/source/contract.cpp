// SPDX-License-Identifier: MIT
// The only file here that needs GoogleTest: a check becomes a test.
#include <regista/testkit/contract.hpp>

#include <gtest/gtest.h>

#include <exception>
#include <string>
#include <utility>

#include <regista/testkit/checks.hpp>

namespace regista::testkit::detail {

namespace {

class ContractTest : public ::testing::Test {
 public:
  ContractTest(std::string file, std::string id, Options options, Check check)
      : file_(std::move(file)), id_(std::move(id)), options_(std::move(options)), check_(std::move(check)) {}
  void TestBody() override {
    try {
      const Findings findings = check_.run(Loaded(file_, id_), options_);
      if (!findings.empty()) ADD_FAILURE() << id_ << " breaks: " << check_.promise << "\n" << findings.text();
    } catch (const std::exception& exception) {
      FAIL() << exception.what();
    }
  }

 private:
  std::string file_, id_;
  Options options_;
  Check check_;
};

// A plugin that cannot be opened gets every test: each says why it fails.
bool applies(const Check& check, const char* file, const char* id, const Options& options) {
  try {
    return check.applies(Loaded(file, id), options);
  } catch (const std::exception&) {
    return true;
  }
}

}  // namespace

bool Registration::contract(const char* id, const Options& options) const {
  for (const Check& check : testkit::contract(kind)) {
    if (!applies(check, file, id, options)) continue;
    const std::string name = std::string(id) + "_" + check.name;
    ::testing::RegisterTest(
        suite, name.c_str(), nullptr, nullptr, source, line,
        [=, from = file]() -> ::testing::Test* { return new ContractTest(from, id, options, check); });
  }
  return true;
}

}  // namespace regista::testkit::detail
