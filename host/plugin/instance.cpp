// SPDX-License-Identifier: MIT
#include "plugin/instance.hpp"

#include <cassert>
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
                                      [](void*) -> std::uint32_t { return 0; },
                                      [](void*, const char*) -> const void* { return nullptr; }};

// Returns the plugin's error text in printable form. Reads a text without a terminating zero, too.
std::string said(const regista_error& error) {
  const std::string_view text(error.text, strnlen(error.text, sizeof error.text));
  return text.empty() ? "failed without saying why" : texts::visible(text);
}

constexpr std::string_view changed_its_input = "changed its input: ";

std::string where_it_wrote(Overflow overflow, const char* what) {
  return fmt::format("wrote {} of its answer: {}",
                     overflow == Overflow::past_the_end ? "past the end" : "before the beginning", what);
}

Inputs inputs_of_create(const regista_environment& environment, const regista_host& host,
                        const Parameters& parameters) {
  Inputs out;
  out.add("environment", &environment);
  out.add("host", &host);
  const std::span<const regista_value> values = parameters.values();
  out.add("values", values.data(), values.size_bytes());
  for (const regista_value& value : values)
    out.add("values.text", value.text, value.text == nullptr ? 0 : value.text_size + 1);
  return out;
}

}  // namespace

Instance::Instance(const Found& plugin, const Parameters& parameters, const regista_environment& environment,
                   const regista_host* host, const Caller* caller)
    : buffers_(caller == nullptr ? nullptr : caller->rooms),
      caller_(caller),
      compares_inputs_(caller != nullptr && caller->tracing.look >= Inspection::often),
      plugin_(plugin),
      environment_(environment),
      noted_id_(note_of_id(plugin.descriptor->id)) {
  if (caller != nullptr && caller->tracing.hides && plugin.descriptor->reads != REGISTA_READS_ALL) {
    declared_reads_ = std::make_unique<DeclaredReads>(plugin.descriptor->reads);
  }
  if (buffers_ == nullptr) {
    own_rooms_ = std::make_unique<AnswerBuffers>();
    buffers_ = own_rooms_.get();
  }
  note_ = caller != nullptr && caller->tracing.note != nullptr ? caller->tracing.note : &buffers_->unheard;
  note_->instance = nullptr;  // makes begin() write the id: an earlier instance may have had this address
  assert(parameters.values().size() == plugin.descriptor->parameter_count);
  environment_.size = sizeof environment_;
  if (caller != nullptr) caller->note();
  begin("open");
  try {
    descriptor_ = &loaded(plugin_);
  } catch (const std::runtime_error& error) {
    end();
    fail_with("open", error.what());
  }
  end();
  if (host == nullptr) host = &host_without_radio;
  const Inputs inputs = compares_inputs_ ? inputs_of_create(environment_, *host, parameters) : Inputs();
  mend();
  buffers_->error.data()->text[0] = '\0';
  begin("create");
  try {
    const std::span<const regista_value> values = parameters.values();
    raw_ = descriptor_->create(
        &environment_, host,
        {values.data(), static_cast<std::uint32_t>(values.size()), static_cast<std::uint32_t>(sizeof(regista_value))},
        buffers_->error.data());
  } catch (...) {
    threw("create");
  }
  end();
  std::string wrong = damage();
  if (const std::string changed = inputs.changed(); wrong.empty() && !changed.empty()) {
    wrong = fmt::format("{}{}", changed_its_input, changed);
  }
  if (!wrong.empty()) {
    if (raw_ != nullptr) destroy();
    fail_with("create", wrong);
  }
  if (raw_ != nullptr) return;
  // The host adds the names of parameter files to the message, because the plugin knows only the contents of the files.
  std::string message = said(*buffers_->error.data());
  for (const FileUsed& file : parameters.files())
    message += fmt::format("; {}: {}", file.parameter, file.path.string());
  fail_with("create", message);
}

Instance::~Instance() { destroy(); }

void Instance::destroy() {
  if (caller_ != nullptr) caller_->note();
  begin("destroy");
  descriptor_->destroy(raw_);
  end();
  damage();  // restores the floating-point state; this function ignores the returned description
}

void Instance::reset(std::uint64_t seed) {
  if (caller_ != nullptr) caller_->note();
  call("reset", descriptor_->reset, seed);
}

void Instance::fail_with(const char* call, std::string message) const {
  throw Failure(plugin_, caller_, call, std::move(message));
}

FloatingPointState Instance::restore_floating_point() const {
  const FloatingPointState left = FloatingPointState::now();
  if (left != floating_point_) floating_point_.restore();
  return left;
}

void Instance::mend() {
  restore_floating_point();
  buffers_->error.mend();
}

std::string Instance::damage() const {
  const FloatingPointState left = restore_floating_point();
  if (const Overflow overflow = buffers_->error.overflow(); overflow != Overflow::none) {
    return where_it_wrote(overflow, "the error's text");
  }
  return left.changed_from(floating_point_);
}

void Instance::check(const char* name, const Inputs& inputs) const {
  if (const std::string changed = inputs.changed(); !changed.empty()) fail(name, "{}{}", changed_its_input, changed);
}

void Instance::check(const char* call, Overflow overflow, const char* what) const {
  if (overflow != Overflow::none) fail_with(call, where_it_wrote(overflow, what));
}

void Instance::examine(const char* name, std::int32_t status) const {
  if (std::string what = damage(); !what.empty()) fail_with(name, std::move(what));
  if (status == REGISTA_OK) return;
  if (status != REGISTA_FAILED) fail(name, "returned {}, which means nothing", status);
  fail_with(name, said(*buffers_->error.data()));
}

void Instance::threw(const char* name) const {
  if (const std::string what = damage(); !what.empty()) fail_with(name, what);
  constexpr std::size_t longest = 500;  // characters
  try {
    throw;
  } catch (const std::exception& exception) {
    fail(name, "let an exception cross the plugin's boundary: {}", texts::visible_at_most(exception.what(), longest));
  } catch (...) {
    fail(name, "let an exception cross the plugin's boundary");
  }
}

}  // namespace regista::plugin
