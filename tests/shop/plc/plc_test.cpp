// SPDX-License-Identifier: MIT
// Electronic cams: pieces, what they lose, and the table of formats.
#include "shop/plc/plc_export.hpp"
#include "shop/plc/plc_template.hpp"
#include "tests/report/sample_solution.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace camopt {
namespace plc_test {

using testing_support::refusal;

MasterCurve curve_of(const Solution& solution) {
    return {solution.whole_turn(), solution.scene.motion};
}

PlcTable table_of(const PlcFormat& format, const MasterCurve& curve, const PlcOptions& options = {}) {
    return prepared_table(curve, options, format);
}

/// The sample's rise as y = x⁴ (35 − 84 x + 70 x² − 20 x³), which ends without jerk.
Solution septic_solution() {
    Solution solution = test::sample_solution();
    solution.scene.spline.degree = 7;
    solution.scene.spline.segments = 1;
    solution.curve = SplineCurve(SplineSpace(7, 6, {0.0, 1.0}),
                                 (Eigen::VectorXd(8) << 0, 0, 0, 0, 35, -84, 70, -20).finished());
    solution.motion = std::make_shared<MotionChain>(std::vector<ChainPart>{
        {0.0, 1.0, std::make_shared<SplineCurve>(*solution.curve), 0.0, 1.0, 0.0, 1.0}});
    return solution;
}

/// A motion that the format holds: points with one jerk for both sides do not hold the sample's.
Solution solution_for(const PlcFormat& format) {
    return format.shared == 3 ? septic_solution() : test::sample_solution();
}

/// Of the formats that hold any motion but jumps of the acceleration.
std::vector<std::string> keys_of_jumping_jerk() {
    std::vector<std::string> keys;
    for (const PlcFormat& format : plc_formats())
        if (format.shared < 3) keys.push_back(format.key);
    return keys;
}

TEST(MasterCurve, CoversCycleInMachineUnits) {
    // Four cubic segments over 90 deg, 10 mm: y''' = ±32, so V = 2 at the middle of the rise.
    const MasterCurve curve = curve_of(test::sample_solution());
    EXPECT_EQ(curve.end(), 360.0);
    EXPECT_EQ(curve.breakpoints(), (std::vector<double>{0.0, 22.5, 45.0, 67.5, 90.0, 360.0}));
    EXPECT_DOUBLE_EQ(curve.at(45.0, Side::right)[0], 5.0);
    EXPECT_DOUBLE_EQ(curve.at(45.0, Side::right)[1], 10.0 * 2.0 / 90.0);
    EXPECT_DOUBLE_EQ(curve.at(22.5, Side::left)[3], 10.0 * 32.0 / std::pow(90.0, 3));
    EXPECT_DOUBLE_EQ(curve.at(22.5, Side::right)[3], -10.0 * 32.0 / std::pow(90.0, 3));
    EXPECT_EQ(curve.polynomial(200.0, Side::right).size(), 1U);
    EXPECT_FALSE(curve.closes());
    EXPECT_DOUBLE_EQ(curve.travel(), 10.0);
}

TEST(CamPieces, ReproduceCubicsAndReportLoss) {
    const MasterCurve curve = curve_of(test::sample_solution());
    for (const int degree : {3, 5}) {
        std::vector<PolynomialPiece> pieces = fitted_pieces(curve, {.degree = degree});
        ASSERT_EQ(pieces.size(), 5U);
        EXPECT_LT(cam_loss(curve, pieces)[0].value, 3e-13);  // rounding included
        pieces[2].coefficients[1] += 1e-3;  // the error grows along the piece, which is 22.5 deg long
        const std::array<CamDifference, 4> loss = cam_loss(curve, pieces);
        EXPECT_NEAR(loss[0].value, 22.5e-3, 1e-12);
        EXPECT_NEAR(loss[0].at, 67.5, 1e-9);
        EXPECT_NEAR(loss[1].value, 1e-3, 1e-14);
        EXPECT_LT(loss[2].value, 1e-14);
    }
}

TEST(CamLoss, IsFoundInsidePieces) {
    const MasterCurve curve = curve_of(test::sample_solution());
    std::vector<PolynomialPiece> pieces = fitted_pieces(curve, {});
    // t (h − t) is 0 at both ends and h²/4 in the middle.
    pieces[4].coefficients = {pieces[4].coefficients[0], 1e-3 * 270.0, -1e-3};
    const std::array<CamDifference, 4> loss = cam_loss(curve, pieces);
    EXPECT_NEAR(loss[0].value, 1e-3 * 270.0 * 270.0 / 4.0, 1e-9);
    EXPECT_NEAR(loss[0].at, 225.0, 1e-6);
}

TEST(CamLoss, RefusesPiecesNotFormingACycle) {
    const MasterCurve curve = curve_of(test::sample_solution());
    std::vector<PolynomialPiece> pieces = fitted_pieces(curve, {});
    pieces.pop_back();
    EXPECT_THROW((void)cam_loss(curve, pieces), InputError);
    EXPECT_THROW((void)cam_loss(curve, {}), InputError);
}

TEST(CamPieces, FitsLawsToTheTolerance) {
    const MasterCurve curve = curve_of(test::program_solution());  // a modified sine returns
    EXPECT_TRUE(curve.closes());
    const std::vector<PolynomialPiece> pieces = fitted_pieces(curve, {});
    EXPECT_GT(pieces.size(), curve.breakpoints().size());
    EXPECT_LE(cam_loss(curve, pieces)[0].value, 1.001e-8 * curve.lift());
    EXPECT_GT(cam_loss(curve, fitted_pieces(curve, {.most = 9}))[0].value, 1e-8 * curve.lift());
}

TEST(PlcFormats, HaveRowsThatAreComplete) {
    ASSERT_EQ(plc_formats().size(), 9U);
    for (const PlcFormat& format : plc_formats()) {
        SCOPED_TRACE(format.key);
        EXPECT_EQ(&plc_format(format.key), &format);
        EXPECT_FALSE(format.file.empty() || format.controller.empty() || format.element.empty());
        EXPECT_TRUE(format.evaluate);
        EXPECT_EQ(format.limit.has_value(), !format.limit_words.empty());
    }
    EXPECT_EQ(refusal([] { (void)plc_format("bosch"); }),
              "--plc: found \"bosch\"; allowed: codesys, twincat, twincat7, siemens, br, rockwell, omron, "
              "lenze, csv");
}

TEST(PlcFormats, NoticeASpoiledFile) {
    for (const PlcFormat& format : plc_formats()) {
        SCOPED_TRACE(format.key);
        const MasterCurve curve = curve_of(solution_for(format));
        const PlcTable table = table_of(format, curve);
        const std::string text = written_file(format, format.file, table);
        const double good =
            plc_loss(format, read_file(format, format.file, text, table.units), curve)[0]->value;
        EXPECT_LT(good, 1e-3);
        // The last number that is 10 mm, 10000 units: one tenth of it.
        const std::string ten = format.key == "br" ? "10000.0" : "10.0";
        const std::size_t place = text.rfind(ten);
        ASSERT_NE(place, std::string::npos);
        std::string spoiled = text;
        spoiled[place] = '2';
        try {
            EXPECT_GT(plc_loss(format, read_file(format, format.file, spoiled, table.units), curve)[0]->value,
                      1.0);
        } catch (const InputError&) {  // the file contradicts itself
        }
        EXPECT_THROW((void)read_file(format, format.file, "", table.units), InputError);
    }
}

std::string sample_file(const PlcFormat& format, const std::string& file, PlcTable& table, int points) {
    table = table_of(format, curve_of(solution_for(format)), {.points = points});
    return written_file(format, file, table);
}

TEST(PlcTemplates, RefuseAnyOtherCharacter) {
    for (const PlcFormat& format : plc_formats()) {
        for (const std::string& file : format.files()) {
            SCOPED_TRACE(file);
            PlcTable table;
            const std::string text = sample_file(format, file, table, 3);
            EXPECT_NO_THROW((void)read_file(format, file, text, table.units));
            bool comment = false;
            for (std::size_t i = 0; i < text.size(); ++i) {
                comment = text[i] != '\n' && (comment || text.substr(i, 2) == "//");
                if (comment || text[i] == '\n' || text[i] == ' ') continue;
                std::string changed = text;
                changed[i] = '~';
                EXPECT_THROW((void)read_file(format, file, changed, table.units), InputError) << i;
            }
        }
    }
}

struct Spoiled {
    std::string format, find, with, words;
};

class PlcTemplate : public testing::TestWithParam<Spoiled> {};

TEST_P(PlcTemplate, ReportsWhatIsWrong) {
    const auto& [key, find, with, words] = GetParam();
    const PlcFormat& format = plc_format(key);
    PlcTable table;
    std::string text = sample_file(format, format.file, table, 5);
    const std::size_t place = text.find(find);
    ASSERT_NE(place, std::string::npos) << text;
    text.replace(place, find.size(), with);
    EXPECT_EQ(refusal([&] { (void)read_file(format, format.file, text, table.units); }),
              "an electronic cam: " + words);
}

INSTANTIATE_TEST_SUITE_P(
    Files, PlcTemplate,
    testing::Values(
        Spoiled{"twincat", "POLYNOM5_MM", "POLYNOM3",
                "line 7 of twincat: found \"Points[1].FunctionType := MOTIONFUNCTYPE_POLYNOM3\"; allowed: "
                "Points[1].FunctionType := MOTIONFUNCTYPE_POLYNOM5_MM"},
        Spoiled{"twincat7", "POLYNOM7_MM", "POLYNOM7",
                "line 7 of twincat7: found \"Points[1].FunctionType := MOTIONFUNCTYPE_POLYNOM7\"; allowed: "
                "Points[1].FunctionType := MOTIONFUNCTYPE_POLYNOM7_MM"},
        Spoiled{"codesys", "SMC_CAMXYVA", "SMC_CAMXYV",
                "line 3 of codesys: found \"Points : ARRAY[0..4] OF SMC_CAMXYV\"; allowed: Points : "
                "ARRAY[0..4] OF SMC_CAMXYVA"},
        Spoiled{"codesys", "nElements := 5", "nElements := 4",
                "line 16 of codesys: found \"Cam.nElements := 4\"; allowed: Cam.nElements := 5"},
        Spoiled{"codesys", "Points[2].dX", "Points[1].dX",
                "line 9 of codesys: found \"Points[1].dX := 180.0\"; allowed: Points[2].dX := {x}"},
        Spoiled{"codesys", "Points[0].dV := 0.0; ", "",
                "line 7 of codesys: found \"Points[0].dA := 0.0\"; allowed: Points[0].dV := {v}"},
        Spoiled{"codesys", "Cam.xEnd := 360.0", "Cam.xEnd := 350.0",
                "codesys: found 350 as {end.x}; allowed: 360, which follows from the other numbers"},
        Spoiled{"codesys", "dY := 10.0", "dY := ten",
                "line 8 of codesys: found \"Points[1].dY := ten\"; allowed: Points[1].dY := {s}"},
        Spoiled{"rockwell", "Profile[1].Slave := 10.0", "Profile[1].Slave := 11.0",
                "rockwell: found 11 as {s} of element 1; allowed: 10, which follows from the other numbers"},
        Spoiled{"br", "SlavePeriod := 10000", "SlavePeriod := 10002",
                "br: found 10.002 as {end.s:DINT}; allowed: 10, which follows from the other "
                "numbers"},
        Spoiled{"br", "[0].a := 0.0", "[0].a := 1.0",
                "br: found 0.001 as the first slave position; allowed: 0"},
        Spoiled{"lenze", "360.0 10.0\n", "360.0 10.0 5.0\n",
                "line 5 of lenze: found \"360.0 10.0 5.0\"; allowed: {x} {s}"},
        Spoiled{"csv", "c4,c5", "c5,c4",
                "line 1 of csv: found \"from_deg,to_deg,s,v,a,j,c0,c1,c2,c3,c5,c4,c6,c7\"; "
                "allowed: from_deg,to_deg,s,v,a,j,c0,c1,c2,c3,c4,c5,c6,c7"}),
    [](const auto& one) { return one.param.format + std::to_string(one.index); });

TEST(PlcExport, StatedLossIsUpperBound) {
    const Solution solution = test::program_solution();
    const MasterCurve curve = curve_of(solution);
    const PlcExport exported = plc_export(solution, keys_of_jumping_jerk(), {});
    ASSERT_EQ(exported.results.size(), 8U);
    for (const PlcResult& result : exported.results) {
        SCOPED_TRACE(result.format->key);
        EXPECT_FALSE(result.lossless);  // a modified sine is no polynomial
        const auto file =
            std::find_if(exported.files.begin(), exported.files.end(),
                         [&](const FolderFile& one) { return one.name == result.format->file; });
        ASSERT_NE(file, exported.files.end());
        const auto found =
            plc_loss(*result.format, read_file(*result.format, file->name, file->text, result.units), curve);
        for (std::size_t r = 0; r < found.size(); ++r) {
            ASSERT_EQ(found[r].has_value(), result.loss[r].has_value());
            if (!found[r]) continue;
            EXPECT_LE(found[r]->value, result.loss[r]->value);
            EXPECT_GE(found[r]->value, 0.98 * result.loss[r]->value);
        }
        EXPECT_NE(file->text.find("lossy: s "), std::string::npos);
    }
    EXPECT_EQ(exported.files.back().name, "plc.json");
}

// 10/3 mm is no whole number of units: the drive adds 3333 units of a micrometre each turn.
TEST(PlcExport, ReportsAccumulationPerCycle) {
    Solution solution = test::sample_solution();
    solution.scene.motion.lift = 0.01 / 3.0;
    const PlcExport exported = plc_export(solution, {"br"}, {});
    EXPECT_NEAR(exported.results[0].drift_per_turn, 3.333 - 10.0 / 3.0, 1e-12);
    EXPECT_NE(exported.text.find("the period of the slave is rounded to whole units: "), std::string::npos);
    EXPECT_NE(exported.files[0].text.find("Cam.SlavePeriod := 3333;"), std::string::npos);
    solution.scene.motion.lift = 0.01;
    EXPECT_EQ(plc_export(solution, {"br"}, {}).results[0].drift_per_turn, 0.0);
}

// An editor of a controller may know no letters but ASCII.
TEST(PlcExport, FilesAreAscii) {
    Solution solution = test::sample_solution();
    solution.scene.title = "Stößel\n// (* 10² *)";
    const PlcExport exported = plc_export(solution, keys_of_jumping_jerk(), {});
    for (const FolderFile& file : exported.files) {
        if (file.name.ends_with(".json")) continue;
        EXPECT_TRUE(std::ranges::all_of(file.text, [](char c) {
            return c == '\n' || (c >= ' ' && c <= '~');
        })) << file.name;
    }
    EXPECT_NE(exported.files[0].text.find("// St??el // (* 10^2 *)\n"), std::string::npos);
}

TEST(PlcExport, SomeFormatsHoldDegreeSeven) {
    for (const PlcResult& result : plc_export(septic_solution(), plc_format_keys(), {}).results) {
        EXPECT_EQ(result.lossless, result.format->degree == 7)
            << result.format->key << ": " << testing::PrintToString(result.of_peak);
        EXPECT_LE(result.of_peak[0], result.format->straight_lines ? 1e-3 : 1e-5) << result.format->key;
    }
}

// What a solver leaves of a stretch at rest: an element of degree 5 must not end where it began.
TEST(PlcExport, SiemensRestsWhereOnlyRoundingMoves) {
    Solution solution = test::sample_solution();
    const auto rounding = std::make_shared<SplineCurve>(
        SplineSpace(3, 2, {0.0, 1.0}), (Eigen::VectorXd(4) << 0, 1e-16, -2e-16, 1e-16).finished());
    const auto rise = std::make_shared<SplineCurve>(*solution.curve);
    solution.motion = std::make_shared<MotionChain>(std::vector<ChainPart>{
        {0.0, 0.5, rise, 0.0, 0.5, 0.0, 1.0}, {0.5, 1.0, rounding, 0.5, 0.5, 1.0, 1.0}});
    const PlcExport exported = plc_export(solution, {"siemens"}, {});
    EXPECT_TRUE(exported.results[0].lossless);
    EXPECT_NE(exported.files[0].text.find("camProfile[5].camProfileType := 2;"), std::string::npos);
}

TEST(PlcExport, RefusesByName) {
    const Solution solution = test::sample_solution();
    EXPECT_EQ(
        refusal([&] { (void)plc_export(solution, {"twincat7"}, {}); }),
        "--plc twincat7: the jerk jumps at 22.5 deg, and a point of this format has one jerk for both sides; "
        "allowed: codesys, twincat, siemens, br, rockwell, csv, or spline.degree = 7 with spline.end_jerk = "
        "\"zero\"");
    EXPECT_TRUE(testing_support::says(
        refusal([&] { (void)plc_export(solution, {"siemens"}, {.points = 100}); }),
        "--plc siemens: 99 segments, a technology object TO_Cam holds 50; allowed: --points 51 or fewer"));
    EXPECT_THROW((void)plc_export(test::infeasible_solution(), {"csv"}, {}), InputError);
}

}  // namespace plc_test
}  // namespace camopt
