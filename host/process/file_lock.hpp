// SPDX-License-Identifier: MIT
// A lock on a whole file between processes, also of several machines. It is a lock of the open file (fcntl,
// F_OFD_SETLK) on one byte that SQLite has no lock on ("File Locking And Concurrency", sqlite.org): flock() would be in
// the way of SQLite's own locks on network file systems, where both kinds are the same.
#pragma once

#include <system_error>

namespace regista::process {

enum class FileLock { shared, exclusive };

// Without waiting; until the descriptor and its copies in other processes are closed. descriptor: open for reading, for
// an exclusive one for writing. operation_would_block: another holds it.
std::error_code lock_file(int descriptor, FileLock lock);
// At once, also for copies of the descriptor. Closing alone ends a lock somewhat later on some network file systems.
void unlock_file(int descriptor);

}  // namespace regista::process
