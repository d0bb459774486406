// SPDX-License-Identifier: MIT
#include "command/end_of_program.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

#include "config/node.hpp"
#include "output/output.hpp"
#include "plugin/failure.hpp"
#include "texts/message.hpp"

namespace regista::command {

void complain(std::string_view message) {
  // If standard error cannot be written to either, there is nobody left to tell.
  const std::string line = fmt::format("regista: {}\n", texts::one_line(message));
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fflush(stderr);
}

int explain_current_exception() {
  try {
    throw;
  } catch (const BadInput& error) {
    complain(error.what());
    return exit_bad_input;
  } catch (const config::Error& error) {
    complain(error.what());
    return exit_bad_input;
  } catch (const plugin::Failure& error) {
    complain(error.what());
    return exit_bad_input;
  } catch (const Interrupted& error) {
    complain(error.what());
    return exit_by_signal(error.signal_number());
  } catch (const output::ReaderGone&) {
    return exit_by_signal(SIGPIPE);  // who reads only the first lines knows it
  } catch (const output::WriteError& error) {
    complain(error.what());
    return exit_no;
  } catch (const std::filesystem::filesystem_error& error) {
    // What was there when it was looked at is there no longer: a folder was removed meanwhile.
    complain(fmt::format("{}{}: {}", error.path1().string(), error.path1().empty() ? "the working folder" : "",
                         error.code().message()));
    return exit_bad_input;
  } catch (const std::bad_alloc&) {
    complain("there is not enough memory");
    return exit_no;
  } catch (const std::system_error& error) {  // a limit of the system, such as of open files
    complain(error.what());
    return exit_no;
  } catch (const std::exception& error) {
    complain(fmt::format("internal error: {}", error.what()));
    return exit_internal;
  } catch (...) {
    complain("internal error: something that is no exception was thrown");
    return exit_internal;
  }
}

}  // namespace regista::command
