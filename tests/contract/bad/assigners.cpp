// SPDX-License-Identifier: MIT
// Assigners that break one promise each.
#include <cstring>
#include <stdexcept>
#include <vector>

#include <regista/mailbox.hpp>

#include "bad.hpp"

namespace {

using regista::Assignment;
using regista::Frame;
using regista::UtilityMatrix;

// Sound: the first open column for each row, beginning at column `first`.
void first_free(const UtilityMatrix& u, const Assignment& out, std::size_t first = 0) {
  std::vector<char> taken(u.columns(), 0);
  for (std::size_t i = 0; i < u.rows(); ++i) {
    for (std::size_t k = 0; k < u.columns() && out[i] == Assignment::no_task; ++k) {
      const std::size_t j = (first + k) % u.columns();
      if (taken[j] || u(i, j) == UtilityMatrix::forbidden) continue;
      taken[j] = 1;
      out[i] = static_cast<std::int32_t>(j);
    }
  }
}

struct Throws : bad::Described {
  static constexpr auto id = "throws";
  void assign(const Frame&, UtilityMatrix, Assignment) { throw std::runtime_error("nothing works today"); }
};
struct ThrowsOddly : bad::Described {
  static constexpr auto id = "throws_oddly";
  void assign(const Frame&, UtilityMatrix, Assignment) { throw 7; }
};
struct Twice : bad::Described {
  static constexpr auto id = "twice";
  void assign(const Frame&, UtilityMatrix u, Assignment out) {
    for (std::size_t i = 0; i < u.rows(); ++i) {
      if (u.columns() > 0 && u(i, 0) != UtilityMatrix::forbidden) out[i] = 0;
    }
  }
};
struct Beyond : bad::Described {
  static constexpr auto id = "beyond";
  void assign(const Frame&, UtilityMatrix u, Assignment out) {
    if (u.rows() > 0) out[0] = static_cast<std::int32_t>(u.columns());
  }
};
struct TakesForbidden : bad::Described {
  static constexpr auto id = "takes_forbidden";
  void assign(const Frame&, UtilityMatrix u, Assignment out) {
    for (std::size_t i = 0; i < std::min(u.rows(), u.columns()); ++i) out[i] = static_cast<std::int32_t>(i);
  }
};
struct Idles : bad::Described {
  static constexpr auto id = "idles";
  void assign(const Frame&, UtilityMatrix, Assignment) {}
};
struct SaysUnknown : bad::Described {
  static constexpr auto id = "says_unknown";
  void assign(const Frame&, UtilityMatrix u, Assignment out) {
    for (std::size_t i = 0; i < u.rows(); ++i) out[i] = Assignment::unknown_task;
  }
};
struct Counts : bad::Described {
  static constexpr auto id = "counts";
  void assign(const Frame&, UtilityMatrix u, Assignment out) {
    static std::size_t calls = 0;
    first_free(u, out, calls++);
  }
};
struct Keeps : bad::Described {
  static constexpr auto id = "keeps";
  std::size_t calls = 0;
  void assign(const Frame&, UtilityMatrix u, Assignment out) { first_free(u, out, calls++); }
};
struct IgnoresStride : bad::Described {
  static constexpr auto id = "ignores_stride";
  void assign(const Frame&, UtilityMatrix u, Assignment out) {
    std::vector<char> taken(u.columns(), 0);
    for (std::size_t i = 0; i < u.rows(); ++i) {
      for (std::size_t j = 0; j < u.columns(); ++j) {
        if (taken[j] || u.data()[i * u.columns() + j] == UtilityMatrix::forbidden) continue;
        taken[j] = 1;
        out[i] = static_cast<std::int32_t>(j);
        break;
      }
    }
  }
};
struct Scribbles : bad::Described {
  static constexpr auto id = "scribbles";
  void assign(const Frame&, UtilityMatrix u, Assignment out) {
    first_free(u, out);
    if (u.rows() > 0 && u.columns() > 0) const_cast<double*>(u.data())[0] += 1.0;
  }
};
struct ScribblesTasks : bad::Described {
  static constexpr auto id = "scribbles_tasks";
  void assign(const Frame& frame, UtilityMatrix u, Assignment out) {
    first_free(u, out);
    if (!frame.tasks().empty()) const_cast<regista::Task&>(frame.tasks()[0]).priority += 1;
  }
};
struct ReadsBehind : bad::Described {
  static constexpr auto id = "reads_behind";
  void assign(const Frame& frame, UtilityMatrix u, Assignment out) {
    first_free(u, out);
    const regista_span& tasks = frame.raw().tasks;
    const auto* const end = static_cast<const char*>(tasks.data) + std::size_t{tasks.count} * tasks.stride;
    if (tasks.count > 0 && reinterpret_cast<const volatile regista_task*>(end)->priority < 0) return;  // is no task
  }
};
struct ReadsOneRowMore : bad::Described {
  static constexpr auto id = "reads_one_row_more";
  void assign(const Frame&, UtilityMatrix u, Assignment out) {
    first_free(u, out);
    const volatile double* const values = u.data();
    if (u.rows() > 0 && values[u.rows() * u.stride()] > 1.0) return;
  }
};
struct Overruns : bad::Described {
  static constexpr auto id = "overruns";
  static std::int32_t call(void*, const regista_frame*, const regista_matrix* u, std::int32_t* out, regista_error*) {
    out[u->rows] = 0;
    return REGISTA_OK;
  }
};
struct ThrowsAcross : bad::Described {
  static constexpr auto id = "throws_across";
  static std::int32_t call(void*, const regista_frame*, const regista_matrix*, std::int32_t*, regista_error*) {
    throw std::runtime_error("caught by nobody");
  }
};
struct FailsSilently : bad::Described {
  static constexpr auto id = "fails_silently";
  static std::int32_t call(void*, const regista_frame*, const regista_matrix*, std::int32_t*, regista_error*) {
    return REGISTA_FAILED;
  }
};
struct FailsAtLength : bad::Described {
  static constexpr auto id = "fails_at_length";
  static std::int32_t call(void*, const regista_frame*, const regista_matrix*, std::int32_t*, regista_error* error) {
    std::strcpy(error->text, "one line\nand another");
    return REGISTA_FAILED;
  }
};
struct FailsEndlessly : bad::Described {
  static constexpr auto id = "fails_endlessly";
  static std::int32_t call(void*, const regista_frame*, const regista_matrix*, std::int32_t*, regista_error* error) {
    std::memset(error->text, 'x', sizeof error->text);
    return REGISTA_FAILED;
  }
};
struct OddStatus : bad::Described {
  static constexpr auto id = "odd_status";
  static std::int32_t call(void*, const regista_frame*, const regista_matrix*, std::int32_t*, regista_error*) {
    return 7;
  }
};
struct NeverCreated : bad::Described {
  static constexpr auto id = "never_created";
  void setup(const regista::Environment&) { throw std::runtime_error("no such formation"); }
  void assign(const Frame&, UtilityMatrix, Assignment) {}
};
struct NeverReset : bad::Described {
  static constexpr auto id = "never_reset";
  void reset(std::uint64_t) { throw std::runtime_error("not again"); }
  void assign(const Frame&, UtilityMatrix, Assignment) {}
};
// Wrong only at one end of a parameter's range.
struct WrongInACorner : bad::Described {
  static constexpr auto id = "wrong_in_a_corner";
  double reach = 1.0;
  int depth = 1;
  static constexpr std::tuple parameters{
      regista::real("reach", &WrongInACorner::reach, {0.0, 2.0}, "m", "How far"),
      regista::integer("depth", &WrongInACorner::depth, {0.0, 3.0}, "1", "How deep")};
  void assign(const Frame&, UtilityMatrix u, Assignment out) {
    if (reach == 0.0 && depth == 3) throw std::runtime_error("not made for this");
    first_free(u, out);
  }
};
// A segment may hold anything.
struct ChokesOnMessages : bad::Described {
  static constexpr auto id = "chokes_on_messages";
  void assign(const Frame&, UtilityMatrix u, Assignment out) { first_free(u, out); }
};
struct unguarded_mailbox {
  static constexpr std::int32_t kind = REGISTA_KIND_MAILBOX;
  template <class>
  static const void* table() {
    static constexpr regista_mailbox calls{
        sizeof(regista_mailbox),
        0,
        [](void*, std::uint64_t, regista_error*) -> std::int32_t { return REGISTA_OK; },
        [](void*, std::uint64_t, regista_error*) -> std::int32_t { return REGISTA_OK; },
        [](void*, const regista_message* message, regista_error*) -> std::int32_t {
          if (message->count < 4) throw std::runtime_error("too short");
          return REGISTA_OK;
        },
        nullptr};
    return &calls;
  }
};

struct ReadsBehindMessages : bad::Described {
  static constexpr auto id = "reads_behind_messages";
  int ones = 0;
  void assign(const Frame&, UtilityMatrix u, Assignment out) { first_free(u, out); }
  void receive(const regista::Message& message) {
    const volatile std::uint8_t* const bytes = message.bytes().data();
    ones += bytes[message.bytes().size()] & 1;
  }
};
struct WritesToMessages : bad::Described {
  static constexpr auto id = "writes_to_messages";
  void assign(const Frame&, UtilityMatrix u, Assignment out) { first_free(u, out); }
  void receive(const regista::Message& message) {
    if (!message.bytes().empty()) const_cast<std::uint8_t&>(message.bytes()[0]) ^= 1;
  }
};

}  // namespace

REGISTA_PLUGINS(regista::Plugin<Throws, regista::assigner>, regista::Plugin<ThrowsOddly, regista::assigner>,
                regista::Plugin<Twice, regista::assigner>, regista::Plugin<Beyond, regista::assigner>,
                regista::Plugin<TakesForbidden, regista::assigner>, regista::Plugin<Idles, regista::assigner>,
                regista::Plugin<SaysUnknown, regista::assigner>, regista::Plugin<Counts, regista::assigner>,
                regista::Plugin<Keeps, regista::assigner>, regista::Plugin<IgnoresStride, regista::assigner>,
                regista::Plugin<Scribbles, regista::assigner>, regista::Plugin<ScribblesTasks, regista::assigner>,
                regista::Plugin<ReadsBehind, regista::assigner>, regista::Plugin<ReadsOneRowMore, regista::assigner>,
                regista::Plugin<Overruns, bad::bare_assigner>, regista::Plugin<ThrowsAcross, bad::bare_assigner>,
                regista::Plugin<FailsSilently, bad::bare_assigner>, regista::Plugin<FailsAtLength, bad::bare_assigner>,
                regista::Plugin<FailsEndlessly, bad::bare_assigner>, regista::Plugin<OddStatus, bad::bare_assigner>,
                regista::Plugin<NeverCreated, regista::assigner>, regista::Plugin<NeverReset, regista::assigner>,
                regista::Plugin<WrongInACorner, regista::assigner>,
                regista::Plugin<ChokesOnMessages, regista::assigner, unguarded_mailbox>,
                regista::Plugin<ReadsBehindMessages, regista::assigner>,
                regista::Plugin<WritesToMessages, regista::assigner>)
