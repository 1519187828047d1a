# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every filter of the plugin can be made, and every property of it set; the table of options is in the panel."""
import os
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import models
from paraview_program import run

XML_PROGRAM = os.environ["STIPPLE_XML_PROGRAM"]
TEMPLATE = os.environ["STIPPLE_XML_TEMPLATE"]
NAMES = """GeometryRemesher GeometryRemesherInBlocks ConformalAtlas GeometryMapRenderer ControlMap ErrorDiffusionSampler CDTRemesh RemeshOptimizer
    QuadRemesh SemiRegularSubdivision SurfaceQuality""".split()


def xml(*arguments):
    """The description that ParaView gets, as a tree."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "Stipple.xml")
        subprocess.run([XML_PROGRAM, TEMPLATE, path, *arguments], check=True)
        return ElementTree.parse(path).getroot()


def table():
    """The rows of the options' table that ParaView has, by name."""
    lines = subprocess.run([XML_PROGRAM, "--table"], check=True, capture_output=True, text=True).stdout.splitlines()
    keys = lines[0].split("\t")
    rows = (dict(zip(keys, line.split("\t"))) for line in lines[1:])
    # Files come by input ports; what draws the maps is not the user's to choose.
    return {row["name"]: row for row in rows if row["stage"] and row["name"] != "map_backend"}


class Proxies(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.found = run("proxies.py", models.labelled()).result

    def test_all_are_made(self):
        self.assertEqual(sorted(self.found), sorted(NAMES))
        for name, proxy in self.found.items():
            self.assertEqual(proxy["class"], "vtkPV" + name)
            self.assertTrue(proxy["menu"], name)
            self.assertEqual(re.sub("[ -]", "", proxy["label"]), name)
            self.assertTrue(all(proxy["ports"]), f"{name} has a port without a name")

    def test_all_is_documented(self):
        for name, proxy in self.found.items():
            for prop, (documented, _) in proxy["values"].items():
                self.assertTrue(documented, f"{name}.{prop}")

    def test_what_was_set_arrives(self):
        """A filter prints what it has."""
        options = {r["property"]: r for r in reversed(table().values())}
        tried = 0
        for name, proxy in self.found.items():
            lines = {line.strip() for line in proxy["print"].splitlines()}
            for prop, (_, value) in proxy["values"].items():
                if not isinstance(value, list) or prop in ("MapSelection", "MergeBlocks"):
                    continue
                option = "".join("_" + c.lower() if c.isupper() else c for c in prop)[1:]
                row = options.get(prop) or table().get(option)
                wanted = " ".join(f"{v:.15g}" if not isinstance(v, str) else v for v in value)
                if row and name in ("GeometryRemesher", "GeometryRemesherInBlocks", "ConformalAtlas"):
                    if row["kind"] == "choice":
                        wanted = row["choices"].split("|")[value[0]]
                    line = f"{row['name']}: {wanted}"
                else:
                    line = f"{row['property'] if row else prop}: {wanted}"
                said = {re.sub(r"\bOn$", "1", re.sub(r"\bOff$", "0", text)) for text in lines}
                self.assertIn(line, said, f"{name}.{prop}: {[l for l in lines if prop in l]}")
                tried += 1
        self.assertGreater(tried, 80)
        self.assertIn("MergeBlocks: 0", self.found["GeometryRemesher"]["print"])


class Table(unittest.TestCase):
    def properties(self, root, proxy):
        source = root.find(f".//SourceProxy[@name='{proxy}']")
        return {p.get("initial_string", p.get("name")): p for p in source if p.tag.endswith("Property")}

    def test_all_rows_are_there(self):
        rows = table()
        self.assertGreater(len(rows), 40)
        properties = self.properties(xml(), "GeometryRemesher")
        for name, row in rows.items():
            prop = properties.get(name, properties.get(row["property"]))
            self.assertIsNotNone(prop, f"{name} is missing")
            text = prop.find("Documentation").text
            self.assertTrue(text.lower().startswith(row["help"].lower()), name)
            if row["unit"]:
                self.assertIn(row["unit"], text, name)

    def test_blocks_have_what_they_obey(self):
        properties = self.properties(xml(), "GeometryRemesherInBlocks")
        self.assertEqual(
            set(properties),
            {"Input", "TrianglesPerBlock", "HealingRings", "MinimumNumberOfGhostLevels", "points", "importance", "importance_array", "gamma",
             "feature_angle", "minimum_feature_length", "region_array", "connectivity", "smoothing", "iterations"},
        )
        entries = [(e.get("text"), e.get("value")) for e in properties["importance"].iter("Entry")]
        self.assertEqual(entries, [("uniform", "0"), ("array", "8")])
        self.assertIn("half as many as the input has triangles", properties["points"].find("Documentation").text)

    def test_first_things_first(self):
        source = xml().find(".//SourceProxy[@name='GeometryRemesher']")
        names = [p.get("name") for p in source if p.tag.endswith("VectorProperty")]
        self.assertEqual(names[:4], ["NumberOfPoints", "EdgeLength", "Importance", "ImportanceArray"])
        domain = source.find(".//*[@name='NumberOfPoints']/IntRangeDomain")
        self.assertIsNone(domain.get("max"), "a slider over ten million is of no use")
        plain = [p.get("name") for p in source if p.tag.endswith("Property") and not p.get("panel_visibility")]
        self.assertLess(len(plain), 25)

    def test_a_new_row_is_a_property(self):
        self.assertNotIn("dummy_power", self.properties(xml(), "GeometryRemesher"))
        prop = self.properties(xml("--dummy"), "GeometryRemesher")["dummy_power"]
        self.assertEqual(prop.get("default_values"), "1.25")
        self.assertEqual(prop.get("panel_visibility"), "advanced")
        self.assertEqual(prop.find("DoubleRangeDomain").get("max"), "7.5")
        self.assertEqual(
            prop.find("Documentation").text,
            "What no one needs. Range: 0 to 7.5 dummies. Default: 1.25. (--dummy-power)",
        )

    def test_a_wrong_template_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "wrong.xml")
            with open(path, "w", encoding="utf-8") as file:
                file.write('<A><SourceProxy options="by name"><Option name="gama"/></SourceProxy></A>')
            done = subprocess.run([XML_PROGRAM, path, path + ".out"], capture_output=True, text=True)
            self.assertEqual(done.returncode, 1)
            self.assertIn("'gama'", done.stderr)
            self.assertFalse(os.path.exists(path + ".out"))


if __name__ == "__main__":
    unittest.main()
