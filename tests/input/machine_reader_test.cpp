// SPDX-License-Identifier: MIT
// Machine files: what they say is what is read, and every fault is told with its place.
#include "input/machine/machine_reader.hpp"

#include "input/scene_reader.hpp"
#include "profiles/factory/cam_formulas.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/written_rows.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace camopt::input {
namespace machine_reader_test {

using testing_support::refusal;

const std::string slide = R"(title = "Slide"
[motion]
type = "program"
lift_mm = 50
[[motion.segments]]
kind = "spline"
angle_deg = 180
to_mm = 50
[[motion.segments]]
kind = "spline"
angle_deg = 180
to_mm = 0
[spline]
segments = 8
[objective]
acceleration = 1.0
[limits]
)";
const std::string machine = R"([machine]
speed_rpm = { min = 20, max = 600 }
[[axis]]
name = "one"
scene = "slide.toml"
[[axis]]
name = "other"
scene = "slide.toml"
phase_deg = 90
[[clearance]]
between = ["one", "other"]
factors = [1.0, -1.0]
at_least_mm = -40
from_deg = 300
to_deg = 60
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

class MachineFile : public testing::Test {
 protected:
    MachineFile() {
        write("slide.toml", slide);
        write("arm.toml",
              replaced(replaced(replaced(slide, "lift_mm", "lift_deg"), "to_mm = 50", "to_deg = 50"),
                       "to_mm = 0", "to_deg = 0") +
                  "velocity_deg_s = 400\n");
        write("stroke.toml", replaced(slide, "type = \"program\"", "type = \"DRD\""));
    }
    void write(const std::string& name, const std::string& text) {
        std::ofstream(path(name), std::ios::binary) << text;
    }
    [[nodiscard]] std::filesystem::path path(const std::string& name) const {
        return std::filesystem::path(folder_.path()) / name;
    }
    [[nodiscard]] static Scene load(const std::filesystem::path& file,
                                    std::span<const std::string> settings) {
        return read_scene_file(file, {.laws = {"modified_sine"}, .solvers = {}, .cam_formulas = cam_formulas},
                               settings);
    }
    [[nodiscard]] MachineSpec read(const std::string& text, std::span<const std::string> settings = {}) {
        write("machine.toml", text);
        return read_machine(path("machine.toml"), load, settings);
    }
    void expect_refusal(const std::string& what, const std::string& by, const std::string& words) {
        const std::string said = refusal([&] { (void)read(replaced(machine, what, by)); });
        EXPECT_NE(said.find(words), std::string::npos) << said << "\ninstead of " << words;
    }

 private:
    test::TemporaryFolder folder_;  // tests run beside one another
};

TEST_F(MachineFile, SettingsReachMachineAndAxes) {
    const std::vector<std::string> settings = {"clearance[0].at_least_mm=-30", "other.motion.lift_mm=60",
                                               "other.motion.segments[0].to_mm=60"};
    const MachineSpec found = read(machine, settings);
    EXPECT_DOUBLE_EQ(found.clearances[0].at_least, -0.03);
    EXPECT_DOUBLE_EQ(found.axes[0].scene.motion.lift, 0.05);
    EXPECT_DOUBLE_EQ(found.axes[1].scene.motion.lift, 0.06);
    EXPECT_TRUE(found.axes[0].settings.empty());
    EXPECT_EQ(found.axes[1].settings.size(), 2U);
    EXPECT_EQ(machine_settings(settings, found), std::vector{settings[0]});
    const std::vector<std::string> wrong = {"other.motion.lift_mm=-1"};
    EXPECT_NE(refusal([&] { (void)read(machine, wrong); }).find("motion.lift_mm"), std::string::npos);
}

TEST_F(MachineFile, IsReadInSiUnits) {
    const MachineSpec read_machine = read(machine);
    EXPECT_DOUBLE_EQ(read_machine.least_speed, 20.0 * units::revolution_per_minute);
    EXPECT_DOUBLE_EQ(read_machine.most_speed, 600.0 * units::revolution_per_minute);
    ASSERT_EQ(read_machine.axes.size(), 2U);
    EXPECT_DOUBLE_EQ(read_machine.axes[1].phase, 90.0 * units::degree);
    EXPECT_NEAR(*read_machine.axes[0].scene.motion.speed, read_machine.least_speed, 1e-12);
    ASSERT_EQ(read_machine.clearances.size(), 1U);
    EXPECT_DOUBLE_EQ(read_machine.clearances[0].at_least, -0.04);
    EXPECT_DOUBLE_EQ(read_machine.clearances[0].from, 300.0 * units::degree);
    EXPECT_EQ(read_machine.clearances[0].key, "clearance[0].at_least_mm");
}

TEST(MachineRows, AreReadAsTheyAreWritten) {
    const auto samples_of = [](const KeyRow& row) -> std::vector<KeyValue> {
        if (row.type == KeyType::number_or_range) return {0.25, KeyBounds{0.25, 0.5}};
        if (row.type == KeyType::number) return {0.25, 3.0};
        if (row.type == KeyType::numbers) return {std::vector<double>{-0.5}};
        if (row.type == KeyType::texts) return {std::vector<std::string>{"one"}};
        return {std::string("two")};
    };
    const auto file_of = [](const KeyRow& row, const std::string& line) {
        if (row.table.empty()) return line;
        if (row.table == "machine") return "[machine]\n" + line;
        if (row.table == "axis") return "[[axis]]\n" + line;
        return "[[axis]]\nname = 'one'\n[[clearance]]\n" + line +
               (row.name == "factors" ? "between = ['one']\n" : "");
    };
    EXPECT_EQ(
        testing_support::expect_rows_read_as_written(machine_rows(), MachineSpec(), samples_of, file_of), 31);
}

TEST_F(MachineFile, FaultsAreToldWithTheirPlace) {
    expect_refusal("\"other\"]", "\"othr\"]",
                   "machine.toml:11:19: clearance[0].between: found \"othr\"; allowed: one, "
                   "other; did you mean 'other'?");
    expect_refusal("name = \"other\"", "name = \"one\"",
                   "machine.toml:7:8: axis[1].name: found \"one\" a second time");
    expect_refusal("name = \"other\"", "name = \"a/b\"", "letters, digits");
    expect_refusal("phase_deg = 90", "phase_deg = 360",
                   "axis[1].phase_deg: found 360 deg; allowed: an angle above -360");
    expect_refusal("[1.0, -1.0]", "[1.0]", "clearance[0].factors: found 1 numbers; allowed: 2");
    expect_refusal("from_deg = 300", "from_deg = 60",
                   "found 60 deg to 60 deg; allowed: two different angles");
    expect_refusal("from_deg = 300", "from_deg = 400", "from 0 to 360 deg");
    expect_refusal("min = 20", "min = 900", "min below max");
    expect_refusal("speed_rpm = { min = 20, max = 600 }", "speed_rpm = -3", "a number > 0");
    expect_refusal("phase_deg", "phase_degr", "did you mean 'phase_deg'?");
    expect_refusal("phase_deg = 90", "phase_deg = 90\nphase_rad = 1", "which means the same");
    expect_refusal("at_least_mm = -40\n", "", "clearance[0].at_least_mm: missing");
    expect_refusal("\"slide.toml\"", "\"nowhere.toml\"", "nowhere.toml: cannot be read");
}

TEST_F(MachineFile, AxesAreWholePrograms) {
    expect_refusal("\"slide.toml\"", "\"stroke.toml\"", "stroke.toml:");
    write("free.toml",
          replaced(slide, "angle_deg = 180\nto_mm = 50",
                   "angle_deg = 160\nto_mm = 50\n[[motion.segments]]\nkind = \"spline\"\nangle_deg = 20"));
    expect_refusal("\"slide.toml\"", "\"free.toml\"", "no displacement at its end");
    write("cam.toml", slide +
                          "[cam]\ntype = \"disk\"\nfollower = \"translating_roller\"\nroller_radius_mm = 8\n"
                          "base_radius_mm = { min = 20, max = 60 }\n");
    expect_refusal("\"slide.toml\"", "\"cam.toml\"", "cam.base_radius_mm: found a range");
}

TEST_F(MachineFile, ClearancesHaveUnitOfAxes) {
    expect_refusal("at_least_mm", "at_least_deg", "found deg with \"one\", whose displacement is a length");
    expect_refusal("\"slide.toml\"", "\"arm.toml\"", "a sum of lengths and angles has no unit");
    const std::string swinging =
        replaced(replaced(machine, "slide.toml", "arm.toml"), "slide.toml", "arm.toml");
    const std::string said = refusal([&] { (void)read(swinging); });
    EXPECT_NE(said.find("whose displacement is an angle; allowed: at_least_deg"), std::string::npos) << said;
    EXPECT_NO_THROW((void)read(replaced(swinging, "at_least_mm", "at_least_deg")));
}

}  // namespace machine_reader_test
}  // namespace camopt::input
