// SPDX-License-Identifier: MIT
// Tables as instruments and programs write them (tests/input/tables): each gives the motion of the one cam it
// was made from, or says where it cannot be read and what to write.
#include "core/units.hpp"
#include "input/scene_parts.hpp"
#include "input/scene_reader.hpp"
#include "profiles/factory/cam_formulas.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace camopt::input {
namespace table_files_test {

const std::string scene = R"(
[motion]
type = "program"
lift_mm = 10
segments = [{ kind = "spline", angle_deg = 80, to = 1 }, { kind = "dwell", angle_deg = 40 },
            { kind = "spline", angle_deg = 120, to = 0 }, { kind = "dwell", angle_deg = 120 }]
[objective]
jerk = 1
[cam]
type = "disk"
follower = "translating_roller"
base_radius_mm = 40
roller_radius_mm = 10
rotation = "counterclockwise"
[measured]
)";

double lift_at(double degrees) {
    const auto share = [](double t) { return t - std::sin(units::turn * t) / units::turn; };
    degrees -= 360.0 * std::floor(degrees / 360.0);
    if (degrees < 80.0) return 0.01 * share(degrees / 80.0);
    if (degrees < 120.0) return 0.01;
    return degrees < 240.0 ? 0.01 * share((240.0 - degrees) / 120.0) : 0.0;
}

struct TableFile {
    std::string name, measured;
    std::size_t rows = 0;    ///< 0: it is refused
    double error = 0.0;      ///< m, of its digits
    std::string words = {};  ///< the refusal
    friend void PrintTo(const TableFile& one, std::ostream* out) { *out << one.name; }
};

class TableFiles : public ::testing::TestWithParam<TableFile> {};

TEST_P(TableFiles, IsReadOrSaysWhy) {
    const TableFile& one = GetParam();
    const test::TemporaryFolder folder;
    const std::filesystem::path file = std::filesystem::path(folder.path()) / "s.toml";
    std::filesystem::copy(source_folder() + "/tests/input/tables/" + one.name, folder.path());
    std::ofstream(file, std::ios::binary) << scene << "table = \"" << one.name << "\"\n" << one.measured;
    const KnownNames known = {.laws = {"modified_sine"}, .solvers = {}, .cam_formulas = cam_formulas};
    const std::string said = testing_support::refusal([&] {
        const Scene read = read_scene_file(file, known);
        const Scene alone = read_scene(whole_scene_text(file), "alone.toml", known);
        EXPECT_EQ(read.measured->displacement, alone.measured->displacement);
        EXPECT_EQ(read.measured->angle.size(), one.rows);
        for (std::size_t k = 0; k < read.measured->angle.size(); ++k)
            EXPECT_NEAR(read.measured->displacement[k], lift_at(read.measured->angle[k] / units::degree),
                        one.error)
                << read.measured->angle[k] / units::degree;
    });
    const std::string path = folder.path() + "/";
    EXPECT_EQ(said.starts_with(path) ? said.substr(path.size()) : said,
              one.rows > 0 ? "no refusal" : one.words);
}

INSTANTIATE_TEST_SUITE_P(
    Formats, TableFiles,
    testing::ValuesIn(std::vector<TableFile>{
        {"dial_gauge.csv", "columns = [\"crank_deg\", \"s_in\", \"-\"]\n", 91, 1.3e-6},
        {"measuring_machine.txt", "columns = [\"theta_deg\", \"s_in\"]\nzero = { deg = 100 }\n", 120, 1.3e-7},
        {"engine_program.lob", "columns = [\"s_in\"]\nstep_deg = 2\nskip_lines = 3\n", 181, 1.3e-8},
        {"decimal_comma.csv", "columns = [\"theta_deg\", \"s_mm\", \"-\"]\ndecimal = \",\"\n", 120, 5.1e-7},
        {"units_row.txt", "", 91, 5.1e-8},
        {"cmm_points.csv", "columns = [\"-\", \"x_mm\", \"y_mm\", \"-\", \"-\"]\ndecimal = \",\"\n", 180,
         1e-6},
        {"profile_polar.csv", "", 180, 1e-6},
        {"probe_centers.csv", "probe_radius_mm = 3\n", 180, 1e-6},
        {"comments_and_trailer.txt", "", 121, 5.1e-8},
        {"lifts_only.txt", "columns = [\"s_mm\"]\nstep_deg = 3\n", 121, 5.1e-9},
        {"past_the_end.csv", "", 120, 5.1e-8},
        {"missing_reading.csv", "", 0, 0.0,
         "missing_reading.csv:12: found \"--\" in the column s_mm; allowed: a finite number, or # before the "
         "line"},
        {"no_names.csv", "", 0, 0.0,
         "no_names.csv:1: found 2 columns, none of these; allowed: one of them named theta_deg, "
         "theta_rad, theta_crank_deg or "
         "crank_deg, or step_deg in [measured], or columns = [\"theta_deg\", \"s_mm\"] in [measured], in the "
         "order "
         "of the file"},
        {"total_below.txt", "", 0, 0.0,
         "total_below.txt:123: found 3 cells; allowed: 2, as the first line names columns, or # before a "
         "line that "
         "is no row"},
        {"thousandths.csv", "", 0, 0.0,
         "thousandths.csv:2: found \"0,000\" in the column s_mm; allowed: a finite number, written with a "
         "decimal "
         "point; with a comma where [measured] has decimal = \",\""},
        {"engine_program.lob", "columns = [\"s_in\"]\nstep_deg = 2\n", 0, 0.0,
         "engine_program.lob:2: s_in: found 4597.4 mm at 0 deg; allowed: 0 mm, to 0.5 mm: what the scene "
         "requires "
         "at 0 deg"},
    }),
    [](const auto& one) {
        std::string name = one.param.name.substr(0, one.param.name.find('.'));
        return one.param.rows == 0 ? name + "_refused" : name;
    });

}  // namespace table_files_test
}  // namespace camopt::input
