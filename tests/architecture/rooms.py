# SPDX-License-Identifier: MIT
"""Who may know whom: the arrows of docs/architecture.md as data. A change here is a change of the architecture.

    cli -> cluster -> results -> command -> output -> report -> study -> campaign -> recording -> match -> mind -> plugin -> process, sdk
    texts, statistics, mcap are leaves; config knows texts

An arrow may skip rooms (match may include plugin), never run backwards or sideways.
"""

# room of host/ -> the rooms it may include or link. "sdk" stands for <regista/abi.h> and <regista/extensions/...>, all
# that host and plugins share.
KNOWS = {
    "texts": set(),
    "config": {"texts"},
    "statistics": set(),
    "mcap": set(),
    "process": set(),
    "plugin": {"sdk", "texts", "config", "process"},
    "mind": {"sdk", "texts", "config", "plugin"},
    "match": {"sdk", "texts", "config", "plugin", "mind"},
    "recording": {"sdk", "texts", "config", "plugin", "mind", "match", "mcap"},
    "campaign": {"sdk", "texts", "config", "process", "plugin", "mind", "match", "statistics", "recording", "mcap"},
    "check": {"sdk", "texts", "config", "process", "plugin"},
    "study": {"sdk", "texts", "config", "plugin", "mind", "match", "statistics", "campaign"},
    "report": {"sdk", "texts", "config", "process", "plugin", "match", "statistics", "campaign", "study", "recording"},
    "output": {"texts", "config", "plugin", "mcap", "recording", "study", "report"},
    "command": {"texts", "config", "plugin", "output"},
    "results": {"texts", "config", "process", "plugin", "mind", "match", "mcap", "recording", "campaign", "study", "report", "output",
                "command"},
    "cluster": {"texts", "config", "process", "plugin", "campaign", "study", "report", "output", "command", "results"},
    "cli": {"sdk", "texts", "config", "process", "plugin", "mind", "match", "statistics", "campaign", "study", "report", "recording",
            "mcap", "output", "command", "results", "cluster", "check"},
}

# What of the SDK the host may include: the interface, and the extensions of it.
HOST_SEES_OF_SDK = "regista/abi.h"
HOST_SEES_EXTENSIONS = "regista/extensions/"
# What plugins may include beside their own folder and what their kind shares: a published system often is another one with
# something added.
PLUGINS_KNOW = {
    "league/assigners/negotiation": {"league/assigners/static_partition"},
    "league/assigners/precedence_auction": {"league/assigners/distributed_auction"},
}
# Folders that are no plugin, and are shared by those of their kind.
SHARED_BY_A_KIND = {"league/assigners/negotiation"}
# What an installation has of the plugins' headers: the target regista::algorithms.
LEAGUE_KNOWS = ("plugins/assigners/", "plugins/utilities/")

# The room that checks plugins plays the testkit's checks, which know nothing of the host.
CHECKS_PLUGINS, TESTKIT = "check", "regista/testkit/"


class Library:
    """A library that only one place of the tree may know, and there perhaps only its .cpp files."""

    def __init__(self, name, place, headers, targets, sources_only=False, only_file=None):
        self.name, self.place, self.sources_only = name, place, sources_only
        self.only_file = only_file  # that may include it
        self.headers = headers  # how an include of it begins
        self.targets = targets  # how a build file names it


CONFINED = [
    Library("CLI11", "host/command/", ("CLI/",), ("CLI11", "CLI11::CLI11"), only_file="host/command/command.cpp"),
    Library("Boost", "host/statistics/", ("boost/",), ("Boost::headers", "Boost::boost", "Boost"), sources_only=True),
    Library("box2d", "host/match/", ("box2d/", "Box2D/"), ("box2d", "box2d::box2d")),
    Library("CGAL", "plugins/positioners/voronoi/", ("CGAL/",), ("CGAL", "CGAL::CGAL")),
    Library("nlopt", "host/study/", ("nlopt.h", "nlopt.hpp"), ("nlopt", "nlopt_cxx", "NLopt", "NLopt::nlopt",
                                                                "NLopt::nlopt_cxx")),
    Library("csv", "host/study/", ("csv.h",), ("csv",), sources_only=True),
    Library("utf8proc", "host/study/", ("utf8proc.h",), ("utf8proc",), sources_only=True),
    Library("zstd", "host/mcap/", ("zstd.h", "zstd_errors.h", "zdict.h"),
            ("zstd", "zstd::libzstd", "zstd::libzstd_shared", "zstd::libzstd_static"), sources_only=True),
    Library("LZ4", "host/mcap/", ("lz4.h", "lz4frame.h", "lz4hc.h", "lz4file.h", "lz4frame_static.h"),
            ("lz4", "${LZ4_LIBRARY}", "LZ4::lz4"), sources_only=True),
    Library("yaml-cpp", "host/config/", ("yaml-cpp/",), ("yaml-cpp", "yaml-cpp::yaml-cpp"), sources_only=True),
    Library("sqlite", "host/campaign/", ("sqlite3.h", "sqlite3ext.h", "SQLiteCpp/"),
            ("sqlite3", "SQLiteCpp", "SQLite3", "SQLite::SQLite3"), sources_only=True),
]

# Headers of C that the C++ headers of the SDK may name besides those without extension.
C_HEADERS = {"assert.h", "errno.h", "float.h", "inttypes.h", "limits.h", "math.h", "stdalign.h", "stdarg.h",
             "stdbool.h", "stddef.h", "stdint.h", "stdio.h", "stdlib.h", "string.h"}
