# SPDX-License-Identifier: MIT
"""self_test.py: plants one violation of each kind in a small tree and demands that the check finds it; and that
the same tree without it passes."""

import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
SPDX = "// SPDX-License-Identifier: MIT\n"
CLEAN = {
    "core/a.hpp": SPDX + '#pragma once\n#include <Eigen/Core>\n#include <vector>\nint a();\n',
    "solvers/s.cpp": SPDX + '#include "core/a.hpp"\n',
    "core/numbers/n.hpp": SPDX + '#pragma once\n#include "core/a.hpp"\n',
    "core/text/t.hpp": SPDX + "#pragma once\n",
    "core/text/u.hpp": SPDX + '#pragma once\n#include "core/text/t.hpp"\n',
    "core/CMakeLists.txt": "# SPDX-License-Identifier: MIT\ncamopt_add_module(core\n  SOURCES\n    x.cpp\n    y.cpp)\n",
    "core/x.cpp": SPDX + "namespace {\nconstexpr int same = 1;\nint grown(int a) {\n    return a + same;\n}\n}\n",
    "core/y.cpp": SPDX + "namespace {\nint grown(double b) {\n    const int same = 2;\n    return same;\n}\n}\n",
    "apps/p.hpp": SPDX + "#pragma once\n",
    "report/o.cpp": SPDX + "double o();\n",
    "tests/apps/p_test.cpp": SPDX + '#include "apps/p.hpp"\n',
    "tests/core/c.hpp": SPDX + "#pragma once\ninline void expect_rest(int a) { EXPECT_EQ(a, 1); }\n",
    "tests/core/c_test.cpp": SPDX + '#include "tests/core/c.hpp"\nTEST(Rise, EndsAtRest) {\n    expect_rest(1);\n}\n',
    "tests.xml": "<testsuite><testcase name='Rise.EndsAtRest' status='run'/></testsuite>\n",
    "objectives/o.hpp": SPDX + '#pragma once\n#include "core/a.hpp"\n',
    "solvers/CMakeLists.txt": "# SPDX-License-Identifier: MIT\nlink(camopt::core)\n",
    "profiles/inverse/i.hpp": SPDX + '#pragma once\n#include "core/a.hpp"\n',
    "profiles/p.hpp": SPDX + "#pragma once\n",
    "benchmarks/papers/s.cpp": SPDX + '#include "profiles/inverse/i.hpp"\n',
    "CMakeLists.txt": "# SPDX-License-Identifier: MIT\nproject(camopt VERSION 0.2.0 LANGUAGES CXX)\n",
    "tests/pairs/pairs.py": '# SPDX-License-Identifier: MIT\nOUTPUTS = {"result": ("solve", [], ["motion.csv"])}\n'
                            'KINDS = {"rise": (["DRD", "disk"], "", [])}\nELSEWHERE = {}\n',
    "shop/plc/plc_formats.cpp": SPDX + 'auto b = {.key = "result"};\n',
    "CHANGELOG.md": "# Changelog\n## [Unreleased]\n## [0.2.0] – 2026-01-31\n## [0.1.0] – 2026-01-30\n",
    "CITATION.cff": "version: 0.2.0\ndate-released: 2026-01-31\n",
    "README.md": "# Title\nSee [a](core/a.hpp), [here](#title) and `core/a.hpp`.\n",
}
# check, file, its text, words that the message must hold
PLANTED = [
    ("include_rules", "solvers/s.cpp", SPDX + '#include "objectives/o.hpp"\n', "solvers/ must not include objectives/"),
    ("include_rules", "splines/c.cpp", SPDX + '#include "profiles/gone.hpp"\n', "does not exist"),
    ("include_rules", "splines/c.cpp", SPDX + '#include "profiles/p.hpp"\n', "splines/ must not include profiles/"),
    ("include_rules", "profiles/remote/r.cpp", SPDX + '#include "profiles/inverse/i.hpp"\n',
     "profiles/remote/ must not include profiles/inverse/"),
    ("include_rules", "profiles/inverse/i.cpp", SPDX + '#include "profiles/p.hpp"\n',
     "profiles/inverse/ must not include profiles/"),
    ("include_rules", "profiles/p.cpp", SPDX + '#include "profiles/inverse/i.hpp"\n',
     "profiles/ must not include profiles/inverse/"),
    ("include_rules", "studies/s.cpp", SPDX + '#include "profiles/inverse/i.hpp"\n',
     "studies/ must not include profiles/inverse/"),
    ("include_rules", "profiles/CMakeLists.txt", "link(camopt::profiles_inverse)\n",
     "profiles/ must not link camopt::profiles_inverse"),
    ("include_rules", "shop/nc/n.cpp", SPDX + '#include "profiles/p.hpp"\n', "shop/nc/ must not include profiles/"),
    ("include_rules", "core/b.cpp", SPDX + '#include "a.hpp"\n', "from the project's root"),
    ("include_rules", "core/b.cpp", SPDX + '#include "core/numbers/n.hpp"\n', "core -> core/numbers (core/b.cpp), core/numbers -> core"),
    ("include_rules", "core/text/t.cpp", SPDX + '#include "core/text/t.hpp"\n#include "core/text/u.hpp"\n',
     "files include each other in a circle: core/text/t -> core/text/u (core/text/t.cpp), core/text/u -> core/text/t"),
    ("include_rules", "core/a.cpp", SPDX + '#include <vector>\n#include "core/a.hpp"\n', "its own header must be the first"),
    ("include_rules", "bindings/b.cpp", SPDX + '#include "apps/p.hpp"\n', "bindings/ must not include apps/"),
    ("include_rules", "gears/g.cpp", SPDX, "has no line"),
    ("include_rules", "solvers/CMakeLists.txt", "link(camopt::splines)\n", "must not link camopt::splines"),
    ("view_rules", "report/json/b.cpp", SPDX + "double b = angle / units::degree;\n", "report/json/b.cpp:2: converts a unit"),
    ("view_rules", "report/page/b.cpp", SPDX + "auto b = cam.formulas->point(theta, state, 0);\n", "evaluates the cam"),
    ("one_place", "report/b.cpp", SPDX + "double b = feed * 60.0;\n", "report/b.cpp:2: a factor of a unit"),
    ("one_place", "studies/b.cpp", SPDX + 'auto b = name + "_mm_s2";\n', "studies/b.cpp:2: the suffix of a unit"),
    ("one_place", "input/b.cpp", SPDX + 'auto b = "missing; allowed: x_mm with y";\n', "input/b.cpp:2: a key with its unit"),
    ("one_place", "studies/b.cpp", SPDX + 'auto b = fmt::format("motion.segments[{}].to", i);\n', "studies/b.cpp:2: an entry of a list"),
    ("one_place", "apps/b.cpp", SPDX + 'void b() {\n    text += (text.empty() ? "" : ", ") + b;\n}\n', "apps/b.cpp:3: a list joined"),
    ("one_place", "splines/b.cpp", SPDX + 'auto b = {"displacement",\n          "velocity", "acceleration"};\n',
     "splines/b.cpp:2: names of derivatives"),
    ("one_unit", "core/y.cpp", SPDX + "namespace {\nconstexpr double same = 2;\n}\n", "core/y.cpp: same is defined in core/x.cpp too"),
    ("one_unit", "core/y.cpp", SPDX + "namespace {\nint grown(int b = 2) {\n    return b;\n}\n}\n", "grown is defined in core/x.cpp too"),
    ("one_unit", "core/y.cpp", SPDX + "namespace {\nstruct same {\n};\n}\n", "same is defined in core/x.cpp too"),
    ("locale_free", "core/b.cpp", SPDX + "double b = std::stod(text);\n", "core/b.cpp:2: reads a number"),
    ("locale_free", "apps/b.cpp", SPDX + "int b = atoi (text);\n", "reads a number"),
    ("locale_free", "report/b.cpp", SPDX + 'void b() {\n    std::snprintf(t, 9, "%.3f", 0.5);\n}\n', "writes a number"),
    ("locale_free", "report/b.cpp", SPDX + 'auto b = fmt::format("{:.3Lf}{:L}", 1, 2);\n', "no 'L'"),
    ("platform_seam", "core/b.cpp", SPDX + "#ifdef _WIN32\n#endif\n", "core/b.cpp:2: asks which system"),
    ("platform_seam", "apps/b.cpp", SPDX + "#if defined(__linux__)\n#endif\n", "asks which system"),
    ("platform_seam", "report/b.cpp", SPDX + "#include <unistd.h>\n", "report/b.cpp:2: includes a header of a system"),
    ("platform_seam", "input/b.cpp", SPDX + "#include <csignal>\n", "includes a header of a system"),
    ("platform_seam", "report/b.cpp", SPDX + "auto b = ::getpid();\n", "calls a function of a system"),
    ("checked_output", "report/b.cpp", SPDX + "void b() {\n    std::ofstream file(path);\n}\n", "report/b.cpp:3: writes unchecked"),
    ("checked_output", "apps/b.cpp", SPDX + 'void b() { std::cout << "b"; }\n', "writes unchecked"),
    ("checked_output", "apps/b.cpp", SPDX + 'void b() { std::FILE* b = std::fopen(path, "wb"); }\n', "writes unchecked"),
    ("whole_switches", "profiles/b.cpp", SPDX + "int b(K k) {\n    switch (k) {\n        default:\n            return 1;\n    }\n}\n",
     "profiles/b.cpp:4: a switch with a default"),
    ("plain_english", "core/b.cpp", SPDX + 'auto b = "no curve "\n         "whatever";\n', "core/b.cpp:2: 'whatever': write any"),
    ("plain_english", "report/page/assets/b.js", SPDX + "const b = 'a limit that bites';\n", "'bites': write active"),
    ("plain_english", "tests/core/b_test.cpp", SPDX + "TEST(Rise, IsMendedAtOnce) {}\n", "'Mended': write fix"),
    ("plain_english", "tests/core/b_test.cpp", SPDX + "TEST_F(Rise,\n       EndsAtRestInTheNextDwellToo) {}\n", "9 words; allowed: 8"),
    ("assertions", "tests/core/b_test.cpp", SPDX + "TEST(Rise, Ends) {\n    rise();  // EXPECT_EQ(\n}\n",
     "tests/core/b_test.cpp:2: Rise.Ends asserts nothing"),
    ("assertions", "tests/core/b_test.cpp", SPDX + "void expect_rest() {}\nTEST_P(Rise, Ends) {\n    expect_rest();\n}\n",
     "Rise.Ends asserts nothing"),
    ("assertions", "tests/b_test.py", "class Rise:\n    def test_ends(self):\n        rise()\n", "tests/b_test.py:2: test_ends asserts nothing"),
    ("assertions", "tests/core/b_test.cpp", SPDX + 'TEST(Rise, Ends) {\n    GTEST_SKIP() << "a";\n    EXPECT_TRUE(a());\n}\n',
     "tests/core/b_test.cpp:3: skips, and tests/skips.txt has no line"),
    ("assertions", "tests/b_test.py", "SKIPPED = 77\n", "tests/b_test.py:1: skips, and"),
    ("assertions", "tests/skips.txt", "tests/core/c_test.cpp - none\n", "tests/core/c_test.cpp skips nothing"),
    ("assertions", "tests/skips.txt", "tests/core/c_test.cpp\n", "tests/skips.txt:1: found 'tests/core/c_test.cpp'; allowed"),
    ("skips", "tests.xml", "<testsuite><testcase name='Rise.Ends' status='notrun'><skipped/></testcase></testsuite>\n",
     "Rise.Ends was skipped"),
    ("pairs", "report/b.cpp", SPDX + 'auto b = "new_chart.svg";\n', "the file new_chart.svg has no row"),
    ("pairs", "shop/plc/plc_formats.cpp", SPDX + 'auto b = {.key = "beckhoff"};\n', "the controller beckhoff has no row"),
    ("pairs", "profiles/kinds/kind_rows.hpp", SPDX + "auto b = {disk_kind(), linear_kind()};\n", "the type of cam linear has no row"),
    ("pairs", "apps/more_commands.cpp", SPDX + 'auto b = program.add_subcommand(\n        "tolerances", "What");\n',
     "the command tolerances has no row"),
    ("pairs", "scene/keys/motion_rows.cpp", SPDX + 'auto b = {"motion", "type", text, plain, any, {"DRD", "cycle"}, "required"};\n',
     "the type of motion cycle has no row"),
    ("pairs", "scene/follower.hpp", SPDX + "#pragma once\n", "names no follower"),
    ("pairs", "scene/follower.hpp", SPDX + '#pragma once\nauto b = {FollowerType::ball, "ball", true};\n', "the follower ball has no row"),
    ("spdx", "core/b.cpp", "int b() { return 1; }\n", "core/b.cpp:1: no line"),
    ("spdx", "scripts/x", "#!/bin/sh\n", "scripts/x:1: no line"),
    ("public_headers", "core/b.hpp", "#pragma once\n#ifdef HAVE_X\n#endif\n", "features select files"),
    ("public_headers", "core/b.hpp", "#pragma once\n#include <nlopt.h>\n", "must not include <nlopt.h>"),
    ("public_headers", "core/b.hpp", "#pragma once\n#include <fmt/core.h>\n", "must not include <fmt/core.h>"),
    ("public_headers", "core/b.hpp", "#pragma once\nnamespace Ipopt { } Ipopt::Index i;\n", "names another library"),
    ("public_headers", "core/b.hpp", "#pragma once\nstruct B { nlopt_opt handle; };\n", "names another library"),
    ("public_headers", "core/b.hpp", "#pragma once\n#include \"core/hidden.hpp\"\n", "which is not installed"),
    ("public_headers", "core/b.hpp", "int b();\n", "no '#pragma once'"),
    ("public_headers", "camopt/b.hpp", "#pragma once\n", "stands outside of camopt/"),
    ("doc_links", "docs/x.md", "[gone](gone.md)\n", "'gone.md' does not exist"),
    ("doc_links", "docs/x.md", "[a](../README.md#no-such)\n", "no such heading"),
    ("doc_links", "docs/x.md", "see `core/gone.hpp`\n", "`core/gone.hpp` does not exist"),
    ("versions", "docs/x.md", "```cmake\nfind_package(camopt 0.1 REQUIRED)\n```\n",
     "docs/x.md:2: 'find_package(camopt 0.1': CMakeLists.txt has version 0.2.0"),
    ("versions", "docs/x.md", "names stay within 0.1.x\n", "CMakeLists.txt has version 0.2.0"),
    ("versions", "docs/x.md", "open `camopt-0.1.0.html`\n", "CMakeLists.txt has version 0.2.0"),
    ("versions", "README.md", "apt-get install ./camopt_0.2.1_amd64.deb\n", "CMakeLists.txt has version 0.2.0"),
    ("versions", "notebooks_cpp/kernel.py", 'implementation_version = "0.1.0"\n', "CMakeLists.txt has version 0.2.0"),
    ("versions", "tests/package/CMakeLists.txt", "find_package(camopt 0.1 REQUIRED)\n", "CMakeLists.txt has version 0.2.0"),
    ("versions", "CHANGELOG.md", "## [0.1.0] – 2026-01-31\n", "its newest release is '0.1.0'"),
    ("versions", "CHANGELOG.md", "## [0.2.0] – unreleased\n", "has the date 'unreleased'"),
    ("versions", "CITATION.cff", "version: 0.1.0\ndate-released: 2026-01-31\n", "CITATION.cff: version is '0.1.0'"),
    ("versions", "CITATION.cff", "version: 0.2.0\n", "CITATION.cff: date-released is ''"),
    ("versions", "bindings/python/pyproject.toml", '[project]\nversion = "0.1.0"\n', "takes its version from CMakeLists.txt"),
]


def run(check, root):
    done = subprocess.run([sys.executable, str(HERE / f"{check}.py"), str(root)],
                          capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def tree(folder, contents):
    for name, text in contents.items():
        path = pathlib.Path(folder) / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return folder


def main():
    faults = 0
    for check in sorted({planted[0] for planted in PLANTED}):
        with tempfile.TemporaryDirectory() as folder:
            status, text = run(check, tree(folder, CLEAN))
            if status != 0:
                faults += 1
                print(f"{check} refuses a clean tree:\n{text}")
        with tempfile.TemporaryDirectory() as folder:
            status, text = run(check, folder)
            if status != 1:
                faults += 1
                print(f"{check} passes where there is nothing to check:\n{text}")
    for check, name, content, words in PLANTED:
        with tempfile.TemporaryDirectory() as folder:
            status, text = run(check, tree(folder, {**CLEAN, name: content}))
            if status != 1 or words not in text:
                faults += 1
                print(f"{check} misses '{words}' in {name}; it said:\n{text}")
    print(f"self_test: {faults} faults in {len(PLANTED)} planted violations")
    sys.exit(1 if faults else 0)


main()
