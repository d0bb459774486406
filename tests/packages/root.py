# SPDX-License-Identifier: MIT
"""A Debian root folder that holds nothing but what a package depends on, copied from this system."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile


def output(*command, **more):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True, **more).stdout


def dependencies(file_or_names):
    """The names in a Depends field; of alternatives the first that is installed here."""
    out = []
    for group in filter(None, (group.strip() for group in file_or_names.split(","))):
        names = [re.split(r"[ (:]", alternative.strip())[0] for alternative in group.split("|")]
        out.append(next((name for name in names if installed(name)), names[0]))
    return out


def installed(name):
    done = subprocess.run(["dpkg-query", "-W", "-f", "${db:Status-Status}\n", name], capture_output=True, text=True)
    return done.returncode == 0 and "installed" in done.stdout.split()


def closure(names):
    """The packages and all that they depend on."""
    out, open_ones = set(), list(names)
    while open_ones:
        name = open_ones.pop()
        if name in out:
            continue
        out.add(name)
        open_ones += dependencies(output("dpkg-query", "-W", "-f", "${Pre-Depends}, ${Depends}\n", name).splitlines()[0])
    return out


class Root:
    """In a temporary folder. dpkg holds the packages for installed; beside them there is only /bin/sh, for the scripts of
    packages, which needs libc6 alone."""

    def __init__(self, packages):
        self.path = pathlib.Path(tempfile.mkdtemp(prefix="regista-root-"))
        for folder in ("bin", "lib", "lib64", "sbin"):
            (self.path / "usr" / folder).mkdir(parents=True)
            (self.path / folder).symlink_to(f"usr/{folder}")
        for folder in ("usr/share/doc", "usr/local/bin", "usr/local/lib/cmake", "usr/local/include", "proc", "dev", "tmp",
                       "var/log", "var/lib/dpkg/info", "var/lib/dpkg/updates"):
            (self.path / folder).mkdir(parents=True, exist_ok=True)
        (self.path / "var/lib/dpkg/available").touch()
        database = ""
        for package in sorted(packages):
            database += output("dpkg-query", "-s", package) + "\n"
            # Whose folders are whose: dpkg leaves a folder that another package holds.
            for suffix in ("", ":" + output("dpkg", "--print-architecture").strip()):
                self.copy(pathlib.Path(f"/var/lib/dpkg/info/{package}{suffix}.list"))
            for file in map(pathlib.Path, output("dpkg-query", "-L", package).splitlines()):
                if not file.is_relative_to("/usr/share") and not file.is_dir():
                    self.copy(file)
        self.copy(pathlib.Path("/usr/bin/dash"))
        (self.path / "usr/bin/sh").symlink_to("dash")
        (self.path / "var/lib/dpkg/status").write_text(database)

    def copy(self, file):
        if not os.path.lexists(file):
            return
        to = self.path / file.relative_to("/")
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(file, to, follow_symlinks=False)

    def remove(self):
        shutil.rmtree(self.path)

    def dpkg(self, *arguments):
        return subprocess.run(["dpkg", f"--root={self.path}", *map(str, arguments)], capture_output=True, text=True,
                              env={**os.environ, "LC_ALL": "C.UTF-8"})

    def run(self, *command):
        """Inside of it, with processes and devices of this system."""
        return subprocess.run(
            ["unshare", "--mount", "sh", "-c",
             'mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" && exec chroot "$0" "$@"', self.path,
             *map(str, command)],
            capture_output=True, text=True, env={"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/tmp", "LC_ALL": "C.UTF-8"})

    def paths(self):
        """Everything there is but for the notes of dpkg."""
        out = set()
        for folder, folders, files in os.walk(self.path):
            place = pathlib.Path(folder).relative_to(self.path)
            if place.is_relative_to("var/lib/dpkg") or place.is_relative_to("var/log"):
                continue
            out |= {str(place / name) for name in folders + files}
        return out
