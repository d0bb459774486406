// SPDX-License-Identifier: MIT
#include "plugin/shared_object.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <gelf.h>
#include <libelf.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "plugin/elf_file.hpp"
#include "plugin/fatal_signal.hpp"
#include "plugin/process_state.hpp"
#include "process/child.hpp"
#include "process/file_descriptor.hpp"
#include "texts/bytes.hpp"
#include "texts/message.hpp"

namespace regista::plugin {
namespace {

constexpr std::uint32_t most_descriptors = 1000;
constexpr const char* truncated = "is damaged: it ends too early";

std::string system_message(int code) { return std::generic_category().message(code); }

// Returns whether [offset, offset + size) is inside a file of `file_size` bytes.
bool inside(std::uint64_t offset, std::uint64_t size, std::uint64_t file_size) {
  return offset <= file_size && size <= file_size - offset;
}

// Returns whether the file contains all its segments. The loader does not check this; it would crash the process.
bool complete(Elf* elf, const GElf_Ehdr& header, std::uint64_t file_size) {
  if (!inside(header.e_phoff, std::uint64_t{header.e_phnum} * header.e_phentsize, file_size)) return false;
  if (!inside(header.e_shoff, std::uint64_t{header.e_shnum} * header.e_shentsize, file_size)) return false;
  for (int i = 0; i < header.e_phnum; ++i) {
    GElf_Phdr segment;
    if (gelf_getphdr(elf, i, &segment) == nullptr) return false;
    if (segment.p_type == PT_LOAD && !inside(segment.p_offset, segment.p_filesz, file_size)) return false;
  }
  return true;
}

bool exports(Elf* elf, std::string_view wanted) {
  return std::ranges::any_of(DynamicPart(elf).symbols(), [&](const DynamicPart::Symbol& each) {
    return each.name == wanted && each.entry.st_shndx != SHN_UNDEF && GELF_ST_TYPE(each.entry.st_info) == STT_FUNC;
  });
}

constexpr const char* remedy = "build it with -fvisibility=hidden, or -fno-gnu-unique";

bool is_writable(Elf* elf, std::uint64_t address) {
  GElf_Phdr segment;
  for (int i = 0; gelf_getphdr(elf, i, &segment) != nullptr; ++i) {
    if (segment.p_type == PT_LOAD && address >= segment.p_vaddr && address - segment.p_vaddr < segment.p_memsz)
      return (segment.p_flags & PF_W) != 0;
  }
  return false;
}

// Returns the name of a variable that all files of a process share (STB_GNU_UNIQUE), or "". With such a variable, the
// second of two builds of a plugin would use the variable of the first build. Ignores variables of the C++ library.
std::string variable_of_all_files(Elf* elf) {
  for (const DynamicPart::Symbol& each : DynamicPart(elf).symbols()) {
    if (GELF_ST_BIND(each.entry.st_info) != STB_GNU_UNIQUE || each.entry.st_shndx == SHN_UNDEF) continue;
    const bool of_thread = GELF_ST_TYPE(each.entry.st_info) == STT_TLS;  // the value of a thread variable is no address
    if (!of_thread && !is_writable(elf, each.entry.st_value)) continue;
    const std::string name = readable_name(each.name.c_str());
    std::string_view of = name;
    if (constexpr std::string_view guard = "guard variable for "; of.starts_with(guard)) of.remove_prefix(guard.size());
    if (!of.starts_with("std::") && !of.starts_with("__gnu_cxx::")) return name;
  }
  return {};
}

// Returns why the file cannot be a plugin; empty if the file may be a plugin. Does not run the file.
std::string why_no_plugin(const std::filesystem::path& path) {
  const process::FileDescriptor file = open_file(path);
  if (!file.is_open()) {
    return errno == ENOENT ? "does not exist" : fmt::format("cannot be read: {}", system_message(errno));
  }
  struct stat about {};
  if (::fstat(file.number, &about) != 0) return fmt::format("cannot be read: {}", system_message(errno));
  if (S_ISDIR(about.st_mode)) return "is a folder, not a shared object";
  if (!S_ISREG(about.st_mode)) return "is not a regular file";
  if (about.st_size == 0) return "is empty";
  if (elf_version(EV_CURRENT) == EV_NONE) return "cannot be checked: libelf is too old";
  const ElfFile elf(elf_begin(file.number, ELF_C_READ, nullptr), &elf_end);
  GElf_Ehdr header;
  if (elf == nullptr || elf_kind(elf.get()) != ELF_K_ELF) return "is not a shared object";
  if (gelf_getehdr(elf.get(), &header) == nullptr) return truncated;
  if (header.e_type != ET_DYN) return "is not a shared object";
  if (!complete(elf.get(), header, static_cast<std::uint64_t>(about.st_size))) return truncated;
  if (!exports(elf.get(), REGISTA_ENTRY_NAME)) return "is no Regista plugin: it does not export " REGISTA_ENTRY_NAME;
  if (const std::string name = variable_of_all_files(elf.get()); !name.empty()) {
    return fmt::format("shares a variable with every other build of it that is loaded: {} (STB_GNU_UNIQUE); {}", name,
                       remedy);
  }
  return {};
}

// Returns the loader's message without the path at its beginning, because the refusal already names the file.
std::string loader_message(const std::filesystem::path& path) {
  const char* const raw = ::dlerror();
  std::string_view text = raw != nullptr ? raw : "unknown error";
  const std::string prefix = path.string() + ": ";
  if (text.starts_with(prefix)) text.remove_prefix(prefix.size());
  return std::string(text);
}

bool share_a_kind(const regista_descriptor& a, const regista_descriptor& b) {
  for (int kind = 1; kind < REGISTA_KIND_END; ++kind) {
    if (a.table(kind) != nullptr && b.table(kind) != nullptr) return true;
  }
  return false;
}

// Returns whether the descriptor is in another shared object than `entry`: such a plugin would consist of two files.
// Returns false for memory outside of all shared objects, because the file itself has allocated this memory.
bool lies_elsewhere(const void* descriptor, const void* entry) {
  Dl_info there{}, here{};
  return ::dladdr(descriptor, &there) != 0 && ::dladdr(entry, &here) != 0 && there.dli_fbase != here.dli_fbase;
}

SharedObject refuse(const std::string& reason) { return {{}, texts::one_line(reason), {}}; }

SharedObject shake_hands(decltype(&regista_plugin_entry) entry) {
  SharedObject out;
  for (std::uint32_t i = 0; i <= most_descriptors; ++i) {
    const regista_descriptor* const next = entry(REGISTA_ABI_MAJOR, REGISTA_ABI_MINOR, i);
    if (next == nullptr) {
      if (out.descriptors.empty()) return refuse("contains no plugin");
      return out;
    }
    if (const std::string wrong = what_is_wrong(*next, i); !wrong.empty()) return refuse(wrong);
    if (lies_elsewhere(next, reinterpret_cast<const void*>(entry)))
      return refuse(fmt::format("its plugin \"{}\" lies in another file: {}", next->id, remedy));
    for (const regista_descriptor* other : out.descriptors) {
      if (std::string_view(other->id) == next->id && share_a_kind(*other, *next)) {
        return refuse(fmt::format("contains two plugins \"{}\" of the same kind", next->id));
      }
    }
    out.descriptors.push_back(next);
  }
  return refuse("its list of plugins has no end");
}

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int most_processor_seconds = 2;  // processor time for opening one file, s
constexpr std::uint64_t most_memory = std::uint64_t{2} << 30;
constexpr double most_idle_seconds = 2.0;  // time of sleep while a file is opened, s
constexpr double most_seconds = 10.0;      // wall time for opening one file, s; long, because the machine may be busy
constexpr int patience = 100;              // ms between two checks of a child that sends nothing
constexpr std::uint32_t most_bytes = 16u << 20;

// --- In the child ----------------------------------------------------------------------------------------------------

void put_frame(int pipe, const texts::BytesOut& frame) {
  const auto size = static_cast<std::uint32_t>(frame.bytes().size());
  std::array<std::uint8_t, sizeof size> head;
  std::memcpy(head.data(), &size, sizeof size);
  if (!process::write_all(pipe, head) || !process::write_all(pipe, frame.bytes())) ::_exit(1);
}

// Returns the number of writable memory mappings that forked copies of this process would share.
int shared_mappings() {
  int count = 0;
  std::ifstream maps("/proc/self/maps");
  for (std::string line, range, rights; std::getline(maps, line);) {
    std::istringstream(line) >> range >> rights;
    if (rights.size() == 4 && rights[1] == 'w' && rights[3] == 's') ++count;
  }
  return count;
}

// Describes shared memory, a thread or a timer that the opened file has left in the process; empty if there is none.
std::string left_running(int threads_before, int mappings_before) {
  // The robots of a match would share this memory: their processes are copies of the process that opens the file.
  if (shared_mappings() > mappings_before) return "maps memory that processes share when it is opened";
  // Waits, because the kernel may still list a thread that has just ended.
  for (int i = 0; std::max(1, running_threads()) > threads_before; ++i) {
    if (i == 20) return "starts a thread when it is opened";
    ::usleep(5000);
  }
  return interval_timers() > 0 ? "starts a timer when it is opened" : "";
}

// Examines the files from `first` on and sends the results. Runs in the child. Returns its exit code.
int look(std::span<const fs::path> files, std::size_t first, int pipe) {
  const int threads_before = std::max(1, running_threads());  // 1 if threads cannot be counted
  for (std::size_t i = first; i < files.size(); ++i) {
    texts::BytesOut frame;
    const auto begun = static_cast<std::uint32_t>(i);
    frame(begun);
    put_frame(pipe, frame);
    process::limit_processor_time(1 + most_processor_seconds);
    const int mappings_before = shared_mappings();
    const SharedObject object = open_shared_object(files[i]);
    const std::string running = object.refusal.empty() ? left_running(threads_before, mappings_before) : "";
    const std::string refusal = running.empty() ? object.refusal : running;
    frame.clear();
    const std::string remark = object.remark;
    const auto count = static_cast<std::uint32_t>(object.descriptors.size());
    frame(begun, refusal, remark, count);
    for (const regista_descriptor* each : object.descriptors) Description(*each).write(frame);
    put_frame(pipe, frame);
    if (!running.empty()) break;  // the threads and the memory must not be found again at the next file
  }
  return 0;
}

// --- In the parent ---------------------------------------------------------------------------------------------------

// A child process that examines the files from `first` on, and the messages that it sends.
class Looker {
 public:
  Looker(std::span<const fs::path> files, std::size_t first) {
    process::Pipe answer = process::make_pipe();
    const process::Setting setting{.limits = {.memory = most_memory}};
    child_ = process::Child::copy(setting, [&] {
      answer.read.reset();
      return look(files, first, answer.write.number);
    });
    pipe_ = std::move(answer.read);
  }

  // Returns the next message; nothing if no further message comes. why_not() then gives the reason.
  std::optional<std::vector<std::uint8_t>> frame() {
    const auto deadline = Clock::now() + std::chrono::duration<double>(most_seconds);
    process::IdleProcess idle(child_.process());
    for (;;) {
      std::uint32_t size = 0;
      if (said_.size() >= sizeof size) {
        std::memcpy(&size, said_.data(), sizeof size);
        if (size > most_bytes) return std::nullopt;
        if (said_.size() >= sizeof size + size) {
          const auto begin = said_.begin() + sizeof size;
          std::vector<std::uint8_t> out(begin, begin + size);
          said_.erase(said_.begin(), begin + size);
          return out;
        }
      }
      if (!pipe_.is_open()) return std::nullopt;
      pollfd watched{pipe_.number, POLLIN, 0};
      if (::poll(&watched, 1, patience) == 1) {
        process::read_available(pipe_, [this](std::string_view piece) {
          said_ += piece;
          spoke_ = true;
        });
        continue;
      }
      idle_ = idle.idle_seconds() > most_idle_seconds;
      late_ = idle_ || Clock::now() > deadline;
      if (late_) return std::nullopt;
    }
  }

  // Ends the child and describes its end. Throws std::system_error if the child process could not begin its work.
  std::string why_not() {
    const process::ProcessEnd end = ended();
    if (!spoke_ && end.exited_with(process::Child::never_began))
      throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again),
                              "no process can look at plugin files");
    hung_ = late_ || end.out_of_processor_time();
    killed_ = !ended_by_us_ && end.from_outside();
    if (idle_) return fmt::format("slept for {:.0f} s when it was opened", most_idle_seconds);
    if (late_) return fmt::format("could not be opened within {:.0f} s", most_seconds);
    if (end.out_of_processor_time())
      return process::used_processor_time(most_processor_seconds) + " when it was opened";
    if (end.signal_number()) return "died when it was opened: " + end.in_words();
    return fmt::format("ended the process when it was opened (exit code {})", WEXITSTATUS(end.status));
  }
  // Valid after why_not(). hung(): the child exceeded a time limit. killed(): a signal from outside killed the child.
  bool hung() const { return hung_; }
  bool killed() const { return killed_; }

 private:
  // Waits for the end of the child. A child that has closed its pipe gets one second to exit; then it is killed.
  process::ProcessEnd ended() {
    ended_by_us_ = late_;
    if (late_) child_.kill();
    for (const auto deadline = Clock::now() + std::chrono::seconds(1); Clock::now() < deadline;) {
      const std::optional<process::ProcessEnd> end = child_.look();
      if (end && !end->was_stopped()) return *end;
      ::poll(nullptr, 0, 1);
    }
    ended_by_us_ = true;
    child_.kill();
    return child_.wait();
  }

  process::Child child_;
  process::FileDescriptor pipe_;
  std::string said_;  // received bytes that frame() has not returned yet
  bool spoke_ = false, late_ = false, idle_ = false, hung_ = false, ended_by_us_ = false, killed_ = false;
};

ScannedFile refused(const std::string& why) { return {{}, texts::one_line(why), {}}; }

enum class Looked {
  at_all,               // the child examined all files
  until_one,            // the child failed at a file; this file or an earlier file is the cause
  until_one_that_hung,  // the child hung at a file; this file is the cause, because earlier files were sound
  until_killed,         // a signal from outside killed the child at a file; no file is the cause
};

// Examines the files from `first` on in one child. The result of a file at which the child ended has the reason.
Looked look_at(std::span<const fs::path> files, std::size_t first, std::vector<ScannedFile>& out) {
  Looker child(files, first);
  std::size_t next = first;
  try {
    while (next < files.size()) {
      std::uint32_t index = 0;
      const auto begun = child.frame();
      const auto told = begun ? child.frame() : std::nullopt;
      if (!told) break;
      texts::BytesIn bytes(*told);
      ScannedFile found;
      std::uint32_t count = 0;
      bytes(index, found.refusal, found.remark, count);
      if (index != next) throw std::out_of_range("another file");
      for (std::uint32_t i = 0; i < count; ++i) found.plugins.push_back(std::make_shared<const Description>(bytes));
      if (!found.refusal.empty()) found.plugins.clear();
      out[next++] = std::move(found);
    }
  } catch (const std::out_of_range&) {
    out[next] = refused("wrote to a file descriptor that is not its own when it was opened");
    return Looked::until_one;
  }
  if (next == files.size()) return Looked::at_all;
  const bool sound_so_far =
      std::ranges::all_of(std::span(out).first(next), [](const ScannedFile& each) { return each.refusal.empty(); });
  out[next] = refused(child.why_not());
  if (child.killed()) return Looked::until_killed;
  return child.hung() && sound_so_far ? Looked::until_one_that_hung : Looked::until_one;
}

// Examines all files in one child. If this child fails, examines each file in its own child.
void look_at_each(std::span<const fs::path> files, std::vector<ScannedFile>& out) {
  const Looked looked = look_at(files, 0, out);
  if (looked == Looked::at_all) return;
  // Does not examine again the file at which the child hung, so that the user waits only once.
  const auto hung = looked == Looked::until_one_that_hung
                        ? std::ranges::find_if(out, [](const ScannedFile& each) { return !each.refusal.empty(); })
                        : out.end();
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (out.begin() + static_cast<std::ptrdiff_t>(i) == hung) continue;
    std::vector<ScannedFile> one(1);
    if (look_at(files.subspan(i, 1), 0, one) == Looked::until_killed) look_at(files.subspan(i, 1), 0, one);
    out[i] = std::move(one.front());
  }
}

}  // namespace

SharedObject open_shared_object(const std::filesystem::path& file) {
  // Uses an absolute path, because the loader searches its own folders for a path without a slash.
  const std::filesystem::path path = std::filesystem::absolute(file);
  if (const std::string why = why_no_plugin(path); !why.empty()) return refuse(why);
  // Start-up code of a -ffast-math file changes the treatment of denormal numbers. restore() below undoes this change.
  const FloatingPointState before = FloatingPointState::now();
  void* const handle = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  const std::string changed = FloatingPointState::now().changed_from(before);
  before.restore();
  if (handle == nullptr) return refuse("cannot be opened: " + loader_message(path));
  note_address_range(handle);
  void* const entry = ::dlsym(handle, REGISTA_ENTRY_NAME);
  if (entry == nullptr) return refuse("cannot be opened: " + loader_message(path));
  try {
    SharedObject out = shake_hands(reinterpret_cast<decltype(&regista_plugin_entry)>(entry));
    if (!changed.empty()) out.remark = fmt::format("{} when it was opened; that was undone", changed);
    return out;
  } catch (const std::exception& exception) {
    return refuse(fmt::format("threw while it was asked for its plugins: {}", exception.what()));
  } catch (...) {
    return refuse("threw while it was asked for its plugins");
  }
}

FileStamp stamp_of(const std::filesystem::path& file) {
  struct stat about {};
  if (::stat(file.c_str(), &about) != 0) return {};
  return {about.st_dev, about.st_ino, about.st_size, about.st_mtim.tv_sec, about.st_mtim.tv_nsec};
}

PluginFile::PluginFile(std::filesystem::path file) : file_(std::move(file)), stamp_(stamp_of(file_)) {
  std::error_code error;
  absolute_ = std::filesystem::absolute(file_, error);
}

bool PluginFile::has_changed() const { return stamp_of(absolute_) != stamp_; }

const SharedObject& PluginFile::load() {
  if (!loaded_ && has_changed()) loaded_ = SharedObject{{}, "was changed after it had been looked at", {}};
  if (!loaded_) loaded_ = open_shared_object(absolute_);
  return *loaded_;
}

const regista_descriptor& PluginFile::descriptor(std::uint32_t index) {
  const SharedObject& object = load();
  if (!object.refusal.empty()) throw std::runtime_error(object.refusal);
  if (index >= object.descriptors.size()) throw std::runtime_error("has fewer plugins than when it was looked at");
  return *object.descriptors[index];
}

std::vector<ScannedFile> scan_files(std::span<const fs::path> files) {
  std::vector<ScannedFile> out(files.size());
  if (files.empty()) return out;
  const process::Descendants descendants;
  look_at_each(files, out);
  descendants.end_all();
  return out;
}

std::string content_hash(std::string_view bytes) {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits(bytes.data(), bytes.size()));
  std::string out;
  for (const unsigned char byte : canonical.digest) out += fmt::format("{:02x}", byte);
  return out;
}

std::uint32_t content_hash_32(std::string_view bytes) {
  return static_cast<std::uint32_t>(std::stoul(content_hash(bytes).substr(0, 8), nullptr, 16));
}

}  // namespace regista::plugin
