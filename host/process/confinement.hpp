// SPDX-License-Identifier: MIT
// Keeps a process to itself. From now on it cannot open files for writing, change names in the file system, open
// sockets, or ask for System V objects and queues: the ways on which processes usually share what they know. Such a
// call fails with "Permission denied", and is reported. Uses seccomp(2) with no new privileges. It is made for
// accidents, not for malice.
#pragma once

namespace regista::process {

// tried: called with what was tried, "open a file for writing", in a handler of signals; the text lives for ever.
// False where the system does not allow it: then nothing is confined.
bool confine(void (*tried)(const char* what));

}  // namespace regista::process
