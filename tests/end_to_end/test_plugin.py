# SPDX-License-Identifier: MIT
"""`regista plugin list` and `regista plugin info`."""

import json
import os
import unittest

import program

# Of the plugins in contract_good.so, those that the team small uses.
IDS = {"first_free", "nearness", "ball_seen", "at_the_ball", "every_second", "last_news"}


class Plugin(program.Case):
    def listed(self, *arguments, **options):
        return json.loads(self.succeed("plugin", "list", "--json", *arguments, **options))

    def test_list(self):
        page = self.succeed("plugin", "list")
        for plugin in IDS:
            self.assertRegex(page, rf"(?m)^\w+ +{plugin} +1\.0\.0 ")
        self.assertIn(f"searched: {self.plugin_folder}\n", page)

    def test_list_for_programs(self):
        found = self.listed()
        self.assertLessEqual(IDS, {plugin["id"] for plugin in found["plugins"]})
        self.assertEqual((found["refused"], found["searched"]), ([], [str(self.plugin_folder)]))

    def test_folders_of_options_and_environment_come_first(self):
        for name in ("by_option", "by_variable", "by_variable_too"):
            (self.folder / name).mkdir()
        variable = {"REGISTA_PLUGIN_PATH": "by_variable:by_variable_too"}
        found = self.listed("--plugins", "by_option", environment=variable)
        self.assertEqual(found["searched"],
                         ["by_option", "by_variable", "by_variable_too", str(self.plugin_folder)])

    def test_what_is_no_plugin_is_refused_by_name(self):
        (self.plugin_folder / "text.so").write_text("no plugin\n")
        os.mkfifo(self.plugin_folder / "pipe.so")
        refused = self.listed()["refused"]
        self.assertEqual([os.path.basename(each["file"]) for each in refused], ["pipe.so", "text.so"])
        self.assertIn(f"refused: {self.plugin_folder}/text.so: ", self.succeed("plugin", "list"))

    def test_info(self):
        page = self.succeed("plugin", "info", "nearness")
        self.assertTrue(page.startswith("nearness 1.0.0: One over one plus distance\n"), page)
        for words in ("utility", "scale: real, 0.1 to 10 m; default: 1; tunable", "Distance at which half is left",
                      "squared: boolean; default: false", f"{self.plugin_folder}/contract_good.so"):
            self.assertIn(words, page)

    def test_info_for_programs(self):
        (about,) = json.loads(self.succeed("plugin", "info", "nearness", "--json"))
        self.assertEqual((about["id"], about["version"], about["kinds"]), ("nearness", "1.0.0", ["utility"]))
        self.assertEqual(about["file"], f"{self.plugin_folder}/contract_good.so")
        scale, squared = about["parameters"]
        self.assertEqual(scale, {"name": "scale", "type": "real", "minimum": 0.1, "maximum": 10.0, "unit": "m",
                                 "default": 1.0, "tunable": True, "log_scale": False,
                                 "doc": "Distance at which half is left"})
        self.assertEqual((squared["type"], squared["default"], squared["tunable"]), ("boolean", False, False))

    def test_info_names_the_nearest(self):
        self.assertEqual(self.refused("plugin", "info", "first_fre"),
                         'plugin info: unknown plugin "first_fre"; nearest: "first_free"; known: '
                         + ", ".join(self.ids()) + f"; searched: {self.plugin_folder}")


if __name__ == "__main__":
    unittest.main()
