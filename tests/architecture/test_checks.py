# SPDX-License-Identifier: MIT
"""The checks of this folder can fail: each kind of violation, put into a small tree, is reported with its exact line,
and a tree that uses every permitted arrow is not."""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import check_left_out
import check_licences
import check_paths
import check_rooms
import check_sizes
import check_words
import exported_symbols

GOOD = {
    "sdk/include/regista/abi.h": "#include <stdint.h>\n",
    "sdk/include/regista/plugin.hpp": "#include <span>\n#include <regista/abi.h>\n#include \"regista/abi.h\"\n",
    "sdk/testkit/include/regista/testkit/suite.hpp": "#include <gtest/gtest.h>\n#include <regista/plugin.hpp>\n",
    "host/CMakeLists.txt": "add_library(regista_${name} STATIC)\n",
    "host/config/node.hpp": "#include <string>\n",
    "host/config/node.cpp": "#include \"config/node.hpp\"\n#include <yaml-cpp/yaml.h>\n",
    "host/config/CMakeLists.txt": "regista_room(config SOURCES node.cpp LINKS yaml-cpp fmt::fmt)\n",
    "host/plugin/loader.cpp": "#include <regista/abi.h>\n#include \"config/node.hpp\"\n",
    "host/mind/mind.hpp": "#include \"plugin/loader.hpp\"\n#include \"config/node.hpp\"\n",
    "host/mind/world/fusion.cpp": "#include \"fusion.hpp\"\n#include \"../mind.hpp\"\n",
    "host/match/physics_world.cpp": "#include <box2d/box2d.h>\n#include \"mind/mind.hpp\"\n#include \"plugin/loader.hpp\"\n",
    "host/match/CMakeLists.txt": "regista_room(match SOURCES arena.cpp LINKS regista_mind box2d::box2d)\n",
    "host/statistics/elo.hpp": "#include <cmath>\n",
    "host/mcap/writer.cpp": "#include <zstd.h>\n",
    "host/mcap/CMakeLists.txt": "regista_room(mcap SOURCES writer.cpp LINKS zstd::libzstd_shared)\n",
    "host/campaign/store.cpp": "#include <sqlite3.h>\n#include \"match/physics_world.hpp\"\n#include \"statistics/elo.hpp\"\n",
    "host/study/tuner.cpp": "#include <nlopt.hpp>\n#include \"campaign/store.hpp\"\n",
    "host/texts/html.cpp": "#include <string>\n",
    "host/recording/writer.cpp":
        "#include \"mcap/writer.hpp\"\n#include \"mind/mind.hpp\"\n#include \"match/physics_world.hpp\"\n",
    "host/report/page.cpp": "#include \"campaign/store.hpp\"\n#include \"recording/writer.hpp\"\n",
    "host/output/files.cpp": "#include \"report/page.hpp\"\n#include \"config/node.hpp\"\n",
    "host/command/command.cpp": "#include <CLI/CLI.hpp>\n#include \"output/files.hpp\"\n",
    "host/cli/main.cpp": "#include \"report/page.hpp\"\n#include \"study/tuner.hpp\"\n#include \"config/node.hpp\"\n",
    "plugins/positioners/voronoi/plugin.cpp":
        "#include <CGAL/Delaunay.h>\n#include <regista/positioner.hpp>\n#include \"algorithm.hpp\"\n",
    "plugins/positioners/voronoi/algorithm.hpp": "#include <vector>\n#include <Eigen/Core>\n",
    "plugins/positioners/voronoi/test.cpp": "#include \"match/physics_world.hpp\"\n#include <box2d/box2d.h>\n",
    "plugins/positioners/voronoi/CMakeLists.txt":
        "regista_add_plugin(voronoi SOURCES plugin.cpp LINKS CGAL::CGAL TEST test.cpp)\n"
        "target_link_libraries(test_voronoi PRIVATE regista_match)\n",
    "tests/unit/mind/test.cpp": "#include \"match/physics_world.hpp\"\n",
}

# (file, its text, what is reported of it)
BAD_ROOMS = [
    ("host/command/bad.cpp", "#include <CLI/CLI.hpp>",
     "1: includes CLI/CLI.hpp; room command may not know CLI11 outside of host/command/command.cpp"),
    ("host/cli/bad.cpp", "#include <CLI/CLI.hpp>", "1: includes CLI/CLI.hpp; room cli may not know CLI11"),
    ("host/command/bad.cpp", '#include "study/tuner.hpp"',
     "1: includes study/tuner.hpp; room command may not know study"),
    ("host/report/bad.cpp", "#include <CLI/App.hpp>", "1: includes CLI/App.hpp; room report may not know CLI11"),
    ("host/output/bad.cpp", '#include "cli/match.hpp"', "1: includes cli/match.hpp; room output may not know cli"),
    ("host/config/bad.cpp", '#include "match/physics_world.hpp"', "1: includes match/physics_world.hpp; room config may not know match"),
    ("host/config/bad.cpp", "\n#include <mind/mind.hpp>", "2: includes mind/mind.hpp; room config may not know mind"),
    ("host/config/bad.cpp", "#include <regista/abi.h>", "1: includes regista/abi.h; room config may not know sdk"),
    ("host/config/bad.cpp", '#include "statistics/elo.hpp"',
     "1: includes statistics/elo.hpp; room config may not know statistics"),
    ("host/config/bad.hpp", "#include <yaml-cpp/mark.h>",
     "1: includes yaml-cpp/mark.h; room config may not know yaml-cpp outside of .cpp files"),
    ("host/statistics/bad.cpp", '#include "config/node.hpp"',
     "1: includes config/node.hpp; room statistics may not know config"),
    ("host/mcap/bad.cpp", '#include "config/node.hpp"', "1: includes config/node.hpp; room mcap may not know config"),
    ("host/mcap/bad.hpp", "#include <zstd.h>", "1: includes zstd.h; room mcap may not know zstd outside of .cpp files"),
    ("host/mcap/bad.hpp", "#include <lz4frame.h>",
     "1: includes lz4frame.h; room mcap may not know LZ4 outside of .cpp files"),
    ("host/match/bad.cpp", '#include "mcap/writer.hpp"', "1: includes mcap/writer.hpp; room match may not know mcap"),
    ("host/report/bad.cpp", "#include <zstd.h>", "1: includes zstd.h; room report may not know zstd"),
    ("host/recording/bad.cpp", "#include <lz4frame.h>", "1: includes lz4frame.h; room recording may not know LZ4"),
    ("host/plugin/bad.cpp", '#include "mind/mind.hpp"', "1: includes mind/mind.hpp; room plugin may not know mind"),
    ("host/plugin/bad.cpp", "#include <regista/plugin.hpp>",
     "1: includes regista/plugin.hpp; room plugin may not know more of sdk than regista/abi.h and regista/extensions/"),
    ("host/plugin/bad.cpp", '#include "../../plugins/positioners/voronoi/algorithm.hpp"',
     "1: includes ../../plugins/positioners/voronoi/algorithm.hpp; "
     "room plugin may not know plugins/positioners/voronoi"),
    ("host/mind/bad.hpp", '#include "match/physics_world.hpp"', "1: includes match/physics_world.hpp; room mind may not know match"),
    ("host/mind/world/bad.cpp", '#include "../../match/physics_world.cpp"',
     "1: includes ../../match/physics_world.cpp; room mind may not know match"),
    ("host/mind/bad.cpp", "#include <box2d/box2d.h>", "1: includes box2d/box2d.h; room mind may not know box2d"),
    ("host/mind/bad.cpp", "#include <yaml-cpp/yaml.h>", "1: includes yaml-cpp/yaml.h; room mind may not know yaml-cpp"),
    ("host/mind/bad.cpp", "#include <CGAL/Kernel.h>", "1: includes CGAL/Kernel.h; room mind may not know CGAL"),
    ("host/match/bad.cpp", '#include "campaign/store.hpp"',
     "1: includes campaign/store.hpp; room match may not know campaign"),
    ("host/match/bad.cpp", "#include <nlopt.hpp>", "1: includes nlopt.hpp; room match may not know nlopt"),
    ("host/match/bad.cpp", "#include <SQLiteCpp/Database.h>",
     "1: includes SQLiteCpp/Database.h; room match may not know sqlite"),
    ("host/campaign/bad.hpp", "#include <sqlite3.h>",
     "1: includes sqlite3.h; room campaign may not know sqlite outside of .cpp files"),
    ("host/campaign/bad.cpp", '#include "study/tuner.hpp"',
     "1: includes study/tuner.hpp; room campaign may not know study"),
    ("host/study/bad.cpp", '#include "report/page.hpp"', "1: includes report/page.hpp; room study may not know report"),
    ("host/report/bad.cpp", '#include "mcap/writer.hpp"', "1: includes mcap/writer.hpp; room report may not know mcap"),
    ("host/report/bad.cpp", '#include "mind/mind.hpp"', "1: includes mind/mind.hpp; room report may not know mind"),
    ("host/recording/bad.cpp", '#include "report/page.cpp"',
     "1: includes report/page.cpp; room recording may not know report"),
    ("host/report/bad.cpp", '#include "cli/main.hpp"', "1: includes cli/main.hpp; room report may not know cli"),
    ("host/match/bad.cpp", "/* a\n// */ #include HEADER",
     "2: includes what a macro names; write the header's name"),
    ("host/tools/bad.cpp", "int i;", "1: stands in no room; the rooms are texts, config, statistics, mcap, process, plugin, "
                                     "mind, match, recording, campaign, check, study, report, output, command, results, cluster, cli"),
    ("plugins/senders/bad/plugin.cpp", '#include "mind/mind.hpp"',
     "1: includes mind/mind.hpp; room plugins/senders/bad may not know mind"),
    ("plugins/senders/bad/plugin.cpp", "#include <config/node.hpp>",
     "1: includes config/node.hpp; room plugins/senders/bad may not know config"),
    ("plugins/senders/bad/plugin.cpp", '#include "../../positioners/voronoi/algorithm.hpp"',
     "1: includes ../../positioners/voronoi/algorithm.hpp; "
     "room plugins/senders/bad may not know plugins/positioners/voronoi"),
    ("league/senders/bad/plugin.cpp", "#include <plugins/positioners/voronoi/algorithm.hpp>",
     "1: includes plugins/positioners/voronoi/algorithm.hpp; "
     "room league/senders/bad may not know plugins/positioners/voronoi"),
    ("league/assigners/bad/plugin.cpp", '#include "../../../plugins/assigners/matrix.hpp"',
     "1: includes ../../../plugins/assigners/matrix.hpp; room league/assigners/bad may not know plugins/assigners"),
    ("plugins/senders/bad/plugin.cpp", '#include "elsewhere.hpp"',
     "1: includes elsewhere.hpp; room plugins/senders/bad may not know it by quotes, which are for its own files"),
    ("plugins/positioners/bad/plugin.cpp", "#  include <CGAL/Delaunay.h>",
     "1: includes CGAL/Delaunay.h; room plugins/positioners/bad may not know CGAL"),
    ("sdk/include/regista/bad.hpp", '#include "config/node.hpp"',
     "1: includes config/node.hpp; room sdk may not know config"),
    ("sdk/include/regista/bad.hpp", "#include <Eigen/Core>",
     "1: includes Eigen/Core; room sdk may not know Eigen/Core, which is not of the standard library"),
    ("sdk/testkit/include/regista/testkit/bad.hpp", '#include "../../../../../host/mind/mind.hpp"',
     "1: includes ../../../../../host/mind/mind.hpp; room sdk may not know mind"),
    ("host/config/CMakeLists.txt", "regista_room(config SOURCES node.cpp\n  LINKS regista_match)",
     "2: links regista_match; room config may not know match"),
    ("host/mind/CMakeLists.txt", "regista_room(mind LINKS box2d::box2d)",
     "1: links box2d::box2d; room mind may not know box2d"),
    ("plugins/senders/bad/CMakeLists.txt", "regista_add_plugin(bad SOURCES plugin.cpp LINKS regista_mind)",
     "1: links regista_mind; room plugins/senders/bad may not know mind"),
]

BAD_LICENCES = [
    ("host/config/bad.cpp", "int i;", "1: no SPDX-License-Identifier in the first three lines; here it is MIT"),
    ("host/config/bad.cpp", "\n// SPDX-License-Identifier: GPL-3.0-or-later\n",
     "2: licence GPL-3.0-or-later; here it is MIT (LICENSES/README.md)"),
    ("plugins/positioners/voronoi/bad.cpp", "// SPDX-License-Identifier: MIT\n",
     "1: licence MIT; here it is GPL-3.0-or-later (LICENSES/README.md)"),
    ("scripts/bad", "#!/bin/sh\n", "1: no SPDX-License-Identifier in the first three lines; here it is MIT"),
]


def write(root, path, text):
    file = Path(root) / path
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")


class Rooms(unittest.TestCase):
    def test_permitted_arrows_pass(self):
        with tempfile.TemporaryDirectory() as root:
            for path, text in GOOD.items():
                write(root, path, text)
            self.assertEqual(list(check_rooms.violations(root)), [])

    def test_every_kind_of_violation_is_reported(self):
        for path, text, expected in BAD_ROOMS:
            with self.subTest(path=path, text=text), tempfile.TemporaryDirectory() as root:
                for good_path, good_text in GOOD.items():
                    write(root, good_path, good_text)
                write(root, path, text)
                self.assertEqual(list(check_rooms.violations(root)), [f"{path}:{expected}"])

    def test_comments_and_text_include_nothing(self):
        text = ('// #include "match/a.hpp"\n/*\n#include "match/b.hpp"\n*/\nauto s = R"x(\n#include "match/c.hpp"\n)x";\n'
                'auto url = "https://host";\n#include "match/d.hpp"\n')
        self.assertEqual([(line, target) for line, _, target in check_rooms.includes(text)], [(9, "match/d.hpp")])


class Licences(unittest.TestCase):
    def test_every_kind_of_violation_is_reported(self):
        for path, text, expected in BAD_LICENCES:
            with self.subTest(path=path, text=text), tempfile.TemporaryDirectory() as root:
                write(root, "host/config/good.cpp", "// SPDX-License-Identifier: MIT\n")
                write(root, "plugins/positioners/voronoi/good.cpp", "// SPDX-License-Identifier: GPL-3.0-or-later\n")
                write(root, path, text)
                self.assertEqual(list(check_licences.violations(root)), [f"{path}:{expected}"])


class Sizes(unittest.TestCase):
    def violations(self, files):
        with tempfile.TemporaryDirectory() as root:
            for path, lines in files.items():
                write(root, path, "x\n" * lines)
            return list(check_sizes.violations(root))

    def test_every_kind_of_violation_is_reported(self):
        self.assertEqual(self.violations({"host/config/long.cpp": 501, "host/config/most.cpp": 500}),
                         ["host/config/long.cpp: has 501 lines; none has more than 500, but what LONGER in check_sizes.py lists"])
        self.assertEqual(self.violations({"host/config/node.hpp": 1, "host/match/node.hpp": 1, "plugins/node.hpp": 1}),
                         ["host/config/node.hpp: another header has its name: host/match/node.hpp"])
        self.assertEqual(self.violations({"host/match/metric_table.cpp": 500}),
                         ["host/match/metric_table.cpp: has at most 500 lines; take it off the list"])
        self.assertEqual(self.violations({"host/match/metric_table.cpp": 501}), [])


class Paths(unittest.TestCase):
    def test_every_kind_of_violation_is_reported(self):
        with tempfile.TemporaryDirectory() as root:
            write(root, "host/config/node.hpp", "// As gone.hpp says.\n#include <other.hpp>  // and node.hpp\n")
            write(root, "docs/where.md", "`host/config/node` `node.hpp` `host/none.cpp` `a/b` `tree.cpp` of `plugins/x/y`\n")
            self.assertEqual(list(check_paths.violations(root)),
                             [f"docs/where.md:1: names {name}, which is not there" for name in ("host/none.cpp", "tree.cpp",
                                                                                               "plugins/x/y")] +
                             ["host/config/node.hpp:1: names gone.hpp, which is not there"])


class Words(unittest.TestCase):
    def violations(self, path, text):
        with tempfile.TemporaryDirectory() as root:
            write(root, "README.md", "Regista plays matches.\n")
            write(root, path, text)
            return list(check_words.violations(root))

    def test_every_kind_of_text_is_read(self):
        for path, text, expected in [
            ("host/config/bad.cpp", '\nsay("a whole number is wanted");', '2: "number is wanted"; write: expected'),
            ("league/senders/bad/plugin.cpp", 'say("a number is "\n    "wanted");', '1: "number is wanted"; write: expected'),
            ("sdk/testkit/bad.cpp", 'say(R"(none\n or nought)");', '1: "nought"; write: zero'),
            ("plugins/senders/bad/plugin.cpp", "int i = 10'000; say(\"nought\", 'n');", '1: "nought"; write: zero'),
            ("host/report/bad.cpp", 'say("\\"Nought\\"");', '1: "Nought"; write: zero'),
            ("viewer/src/bad.ts", "const text = `${n} is nought`;", '1: "nought"; write: zero'),
            ("docs/bad.md", "```\nx\n```\nIt is `x`, or\nnought.\n", '5: "nought"; write: zero'),
            ("README.md", "The truth is told twice.\n", '1: "is told"; write: reported, stored or shown'),
        ]:
            with self.subTest(path=path, text=text):
                self.assertEqual(self.violations(path, text), [f"{path}:{expected}"])

    def test_comments_code_and_good_english_pass(self):
        for path, text in [
            ("host/config/good.cpp", '// nought "nought"\n/* "nought" */\nint nought = 0;\nsay("zero");'),
            ("host/config/test.cpp", 'say("nought");'),
            ("host/config/good.cpp", 'say("a number is "); say("wanted");'),
            ("docs/good.md", "```\nnought\n```\nThe parameter `nought` is zero.\n"),
            ("docs/good.md", "A home kit is told apart by its colour. Who has the ball? There is none; -1 is none.\n"),
        ]:
            with self.subTest(path=path, text=text):
                self.assertEqual(self.violations(path, text), [])


class ExportedSymbols(unittest.TestCase):
    ENTRY = "int regista_plugin_entry(void) { return 0; }\n"

    def violations(self, source):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "plugin.so"
            subprocess.run([os.environ.get("CC", "cc"), "-shared", "-fPIC", "-x", "c", "-", "-o", str(file)],
                           input=source, text=True, check=True)
            return [line.removeprefix(f"{file}: ") for line in exported_symbols.violations(file)]

    def test_one_entry_passes(self):
        self.assertEqual(self.violations(self.ENTRY), [])

    def test_a_second_symbol_is_reported(self):
        self.assertEqual(self.violations(self.ENTRY + "__attribute__((weak)) int leak(void) { return 1; }"),
                         ["exports leak (W); a plugin exports regista_plugin_entry alone"])

    def test_a_missing_entry_is_reported(self):
        self.assertEqual(self.violations("static int i;"), ["does not export the function regista_plugin_entry"])

    def test_an_empty_folder_is_a_violation(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(exported_symbols.main([folder]), 1)


class LeftOut(unittest.TestCase):
    def test_what_nobody_decided_is_named(self):
        listed = "# a remark\nend_to_end.tune 300 long\ndocs.tour 20 long\n"
        self.assertEqual(check_left_out.undecided(listed, "`end_to_end.tune` is long; docs.tour"), ["docs.tour"])


if __name__ == "__main__":
    unittest.main()
