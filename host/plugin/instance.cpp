// SPDX-License-Identifier: MIT
#include "plugin/instance.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cstring>
#include <exception>
#include <stdexcept>

namespace regista::plugin {
namespace {

const regista_host host_without_radio{sizeof(regista_host),
                                      0,
                                      nullptr,
                                      [](void*, const std::uint8_t*, std::uint32_t, double, double, std::int32_t,
                                         std::uint64_t) -> std::uint64_t { return 0; },
                                      [](void*, std::uint64_t) {},
                                      [](void*) -> std::uint32_t { return 0; }};

// What a plugin wrote; it may lack its end.
std::string said(const regista_error& error) {
  const std::string text(error.text, strnlen(error.text, sizeof error.text));
  return text.empty() ? "failed without saying why" : text;
}

}  // namespace

Instance::Instance(const Found& plugin, const Parameters& parameters, const regista_environment& environment,
                   const regista_host* host, const Caller* caller)
    : plugin_(plugin),
      environment_(environment),
      caller_(caller),
      note_(caller == nullptr ? nullptr : caller->noting.note),
      noted_id_(note_of_id(plugin.descriptor->id)) {
  assert(parameters.values().size() == plugin.descriptor->parameter_count);
  environment_.size = sizeof environment_;
  if (note_ != nullptr) note_->instance = nullptr;  // an earlier one may have stood at this address
  begin("open");
  try {
    descriptor_ = &loaded(plugin_);
  } catch (const std::runtime_error& error) {
    end();
    fail("open", error.what());
  }
  end();
  begin("create");
  try {
    raw_ = descriptor_->create(&environment_, host != nullptr ? host : &host_without_radio,
                                     parameters.values().data(), &error_);
  } catch (...) {
    threw("create");
  }
  end();
  if (raw_ != nullptr) return;
  // A plugin never learns what its files are called.
  std::string message = said(error_);
  for (const FileUsed& file : parameters.files())
    message += fmt::format("; {}: {}", file.parameter, file.path.string());
  fail("create", message);
}

Instance::~Instance() {
  begin("destroy");
  descriptor_->destroy(raw_);
  end();
}

void Instance::reset(std::uint64_t seed) { call("reset", descriptor_->reset, seed); }

void Instance::fail(const char* call, std::string message) const {
  throw Failure(plugin_, caller_, call, std::move(message));
}

void Instance::failed(const char* name, std::int32_t status) const {
  if (status != REGISTA_FAILED) fail(name, fmt::format("returned {}, which means nothing", status));
  fail(name, said(error_));
}

void Instance::threw(const char* name) const {
  try {
    throw;
  } catch (const std::exception& exception) {
    fail(name, fmt::format("let an exception cross the plugin's boundary: {}", exception.what()));
  } catch (...) {
    fail(name, "let an exception cross the plugin's boundary");
  }
}

void Instance::has_no_table(int kind) const { fail("table", fmt::format("is not {}", kind_with_article(kind))); }

}  // namespace regista::plugin
