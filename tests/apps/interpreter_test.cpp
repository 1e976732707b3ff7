// SPDX-License-Identifier: MIT
// Exported programs as another control reads them: LinuxCNC's interpreter alone (rs274, Debian's
// linuxcnc-uspace) prints the motions it would command; they are those that the verifier followed.
#include "core/text/text_file.hpp"
#include "program.hpp"
#include "shop/nc/cutter_compensation.hpp"
#include "shop/nc/nc_reader.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace camopt {
namespace interpreter_test {

using test::ProgramRun;
using test::run_camopt;

// Fewer segments and one start: what is solved does not matter here.
const std::string quick = " --set solver.starts=1";
const std::string quick_drum = " --set spline.segments=8 --set solver.starts=1 --chord-mm 0.01";

constexpr double printed_digits = 0.6e-4;  // rs274 prints four decimals
constexpr std::string_view letters = "XYZABC";

/// What rs274 prints of a motion: the unit of the program, deg.
struct CanonicalMotion {
    bool rapid = false, arc = false, clockwise = false;
    std::array<double, 6> end{};
    double center_x = 0.0, center_y = 0.0;
};

std::vector<double> numbers_of(const std::string& line) {
    std::istringstream words(line.substr(line.find('(') + 1));
    std::vector<double> numbers;
    for (double number = 0.0; words >> number; words.ignore(1)) numbers.push_back(number);
    return numbers;
}

std::vector<CanonicalMotion> canonical(const std::string& output) {
    std::vector<CanonicalMotion> motions;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        CanonicalMotion motion;
        motion.rapid = line.find(" STRAIGHT_TRAVERSE(") != std::string::npos;
        motion.arc = line.find(" ARC_FEED(") != std::string::npos;
        if (!motion.rapid && !motion.arc && line.find(" STRAIGHT_FEED(") == std::string::npos) continue;
        const std::vector<double> n = numbers_of(line);
        if (n.size() < 6) {
            ADD_FAILURE() << line;
            continue;
        }
        if (motion.arc) {  // x, y, centre, turns, z, a, b, c
            motion.end = {n[0], n[1], n[5], n.at(6), n.at(7), n.at(8)};
            motion.center_x = n[2];
            motion.center_y = n[3];
            motion.clockwise = n[4] < 0.0;
        } else {
            std::copy_n(n.begin(), 6, motion.end.begin());
        }
        motions.push_back(motion);
    }
    return motions;
}

struct Interpreted {
    int exit_code = -1;
    std::string errors;
    std::vector<CanonicalMotion> motions;
};

/// The tool table holds tool 1, its diameter in inches: those are the interpreter's own.
Interpreted interpreted(const std::string& folder, double cutter_mm) {
    std::ofstream(folder + "/tools.tbl") << "T1 P1 D" << std::to_string(cutter_mm / 25.4) << "\n";
    const std::string command =
        "cd '" + folder + "' && rs274 -g -t tools.tbl cam.nc > motions.txt 2> errors.txt < /dev/null";
    Interpreted result;
    result.exit_code = std::system(command.c_str());
    result.errors = read_text_file(folder + "/errors.txt");
    result.motions = canonical(read_text_file(folder + "/motions.txt"));
    return result;
}

struct Example {
    std::string scene, machine, options, post;
    double cutter_mm = 16.0;
};

struct Followed {
    std::unique_ptr<Machine> machine;
    PostProcessor post;
    std::vector<NcMove> printed_moves, moves;  // the text's; the cutter's centre

    /// Of an axis of the interpreter; NaN: no value yet, or no such axis.
    [[nodiscard]] double printed(const Eigen::VectorXd& values, char letter) const {
        for (std::size_t i = 0; i < machine->axes().size(); ++i) {
            const MachineAxis& axis = machine->axes()[i];
            const PostAxis& to = post_axis(post, axis);
            if (to.letter[0] == letter)
                return (to.sign * values(static_cast<Eigen::Index>(i)) + to.offset) /
                       printed_unit(post, axis.kind);
        }
        return NAN;
    }
};

Followed followed(const Example& one, const std::string& program) {
    Followed result;
    result.machine = one.machine == "plane"  ? plane_milling_machine()
                     : one.machine == "four" ? rotary_table_machine()
                                             : table_tilting_machine(0.12);
    result.post = generic_post(*result.machine);
    if (!one.post.empty()) result.post = read_post(source_folder() + "/docs/posts/" + one.post, result.post);
    result.printed_moves = read_nc_travel(program, *result.machine, result.post);
    result.moves = compensated(result.printed_moves, 0.5e-3 * one.cutter_mm);
    return result;
}

/// Motion by motion.
void expect_same(const Followed& ours, const std::vector<CanonicalMotion>& theirs) {
    ASSERT_EQ(ours.moves.size(), theirs.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < theirs.size(); ++i) {
        const NcMove& move = ours.moves[i];
        ASSERT_EQ(move.rapid, theirs[i].rapid) << "line " << move.line;
        ASSERT_EQ(move.arc.has_value(), theirs[i].arc) << "line " << move.line;
        for (std::size_t k = 0; k < letters.size(); ++k) {
            const double printed = ours.printed(move.values, letters[k]);
            if (std::isfinite(printed)) worst = std::max(worst, std::abs(printed - theirs[i].end[k]));
        }
        if (!move.arc) continue;
        EXPECT_EQ(move.arc->clockwise, theirs[i].clockwise);
        Eigen::VectorXd center = move.values;
        center.head<2>() = move.arc->center;
        worst = std::max({worst, std::abs(ours.printed(center, 'X') - theirs[i].center_x),
                          std::abs(ours.printed(center, 'Y') - theirs[i].center_y)});
    }
    EXPECT_LT(worst, printed_digits);
}

using Points = std::vector<Eigen::Vector2d>;

/// The feeds' way in X and Y, mm, round pieces in small steps.
Points way_of(const std::vector<CanonicalMotion>& motions) {
    Points way;
    std::array<double, 6> from{};
    for (const CanonicalMotion& motion : motions) {
        const Eigen::Vector2d begin(from[0], from[1]), end(motion.end[0], motion.end[1]);
        from = motion.end;
        if (motion.rapid) continue;
        const Eigen::Vector2d center(motion.center_x, motion.center_y);
        const int steps = motion.arc ? 400 : 1;
        double sweep = 0.0, angle = 0.0;
        if (motion.arc) {
            angle = std::atan2(begin.y() - center.y(), begin.x() - center.x());
            sweep = std::atan2(end.y() - center.y(), end.x() - center.x()) - angle;
            if (motion.clockwise && sweep > 0.0) sweep -= 2.0 * std::numbers::pi;
            if (!motion.clockwise && sweep < 0.0) sweep += 2.0 * std::numbers::pi;
        }
        way.push_back(begin);
        for (int k = 1; k <= steps; ++k) {
            const double a = angle + sweep * k / steps;
            way.push_back(motion.arc ? Eigen::Vector2d(center + (begin - center).norm() *
                                                                    Eigen::Vector2d(std::cos(a), std::sin(a)))
                                     : end);
        }
    }
    return way;
}
Points way_of(const std::vector<NcMove>& moves) {
    Points way;
    for (std::size_t i = 1; i < moves.size(); ++i) {
        if (moves[i].rapid) continue;
        const int steps = moves[i].arc ? 400 : 1;
        for (int k = 0; k <= steps; ++k)
            way.emplace_back(
                1e3 * values_along(moves[i - 1].values, moves[i], static_cast<double>(k) / steps).head<2>());
    }
    return way;
}

/// How far the points of one way are from the other.
double apart(const Points& points, const Points& way) {
    double worst = 0.0;
    for (const Eigen::Vector2d& point : points) {
        double least = HUGE_VAL;
        for (std::size_t i = 1; i < way.size(); ++i) {
            const Eigen::Vector2d along = way[i] - way[i - 1];
            const double square = along.squaredNorm();
            const double share =
                square > 0.0 ? std::clamp((point - way[i - 1]).dot(along) / square, 0.0, 1.0) : 0.0;
            least = std::min(least, (point - way[i - 1] - share * along).squaredNorm());
        }
        worst = std::max(worst, std::sqrt(least));
    }
    return worst;
}

/// The largest turn between two compensated lines, rad.
double largest_turn(const std::vector<NcMove>& printed) {
    double largest = 0.0;
    for (std::size_t i = 2; i < printed.size(); ++i) {
        if (printed[i].compensation == CompensationSide::none || printed[i].arc || printed[i - 1].arc)
            continue;
        if (printed[i - 1].compensation == CompensationSide::none) continue;
        const Eigen::Vector2d in = (printed[i - 1].values - printed[i - 2].values).head<2>();
        const Eigen::Vector2d out = (printed[i].values - printed[i - 1].values).head<2>();
        largest = std::max(largest, std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out))));
    }
    return largest;
}

/// What gtest prints of it.
void PrintTo(const Example& one, std::ostream* out) {
    *out << one.scene << one.options << " " << one.post;
}

class LinuxCnc : public ::testing::TestWithParam<Example> {};

TEST_P(LinuxCnc, CommandsTheMotionsThatWereChecked) {
    if (std::system("command -v rs274 > /dev/null 2>&1") != 0)
        GTEST_SKIP()
            << "*** rs274 is missing: NO PROGRAM IS RUN THROUGH ANOTHER INTERPRETER. It is part of Debian's "
               "linuxcnc-uspace.";
    const Example& one = GetParam();
    const test::TemporaryFolder folder;
    std::string options = one.options + " --tool-number 1 --spindle-rpm 2000";
    if (!one.post.empty()) options += " --post " + source_folder() + "/docs/posts/" + one.post;
    const ProgramRun run =
        run_camopt("export " + test::scene(one.scene) + " --out " + folder.path() + " --nc" + options);
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const Interpreted theirs = interpreted(folder.path(), one.cutter_mm);
    ASSERT_EQ(theirs.exit_code, 0) << theirs.errors;
    const Followed ours = followed(one, read_text_file(folder.path() + "/cam.nc"));
    ASSERT_GT(theirs.motions.size(), 50u);
    if (one.options.find("--compensation control") == std::string::npos)
        return expect_same(ours, theirs.motions);
    // It goes straight past corners that hardly turn, by radius * turn^2 / 2: the ways are compared.
    const double turn = largest_turn(ours.printed_moves);
    EXPECT_LT(turn, 0.03);
    const double corners = 0.5 * 0.5 * one.cutter_mm * turn * turn;
    EXPECT_EQ(std::ranges::count_if(ours.moves, &NcMove::rapid),
              std::ranges::count_if(theirs.motions, &CanonicalMotion::rapid));
    const Points our_way = way_of(ours.moves), their_way = way_of(theirs.motions);
    EXPECT_LT(apart(their_way, our_way), corners + printed_digits);
    EXPECT_LT(apart(our_way, their_way), corners + printed_digits);
}

const std::string roughing = " --rough-step-over-mm 5 --rough-step-down-mm 11";

INSTANTIATE_TEST_SUITE_P(
    Examples, LinuxCnc,
    ::testing::Values(
        Example{"cam_arm_flat", "plane", quick, ""}, Example{"cam_arm_roller", "plane", quick, ""},
        Example{"cam_clockwise", "plane", quick + " --direction conventional", ""},
        Example{"cam_drdrd", "plane", quick + " --cutter-mm 12" + roughing, "", 12.0},
        Example{"cam_flat", "plane", quick, ""}, Example{"cam_forces", "plane", quick + roughing, ""},
        Example{"cam_knife", "plane", quick, ""}, Example{"cam_laws_and_splines", "plane", quick, ""},
        Example{"cam_roller", "plane", quick, ""}, Example{"cam_undercut", "plane", quick, ""},
        Example{"cam_drdrd", "plane", quick + " --cutter-mm 12 --compensation control", "", 12.0},
        Example{"cam_roller", "plane", quick + " --compensation control --direction conventional", ""},
        Example{"cam_clockwise", "plane", quick + " --compensation control --lead-mm 12", ""},
        Example{"barrel_paper_cup", "four", quick_drum, ""},
        Example{"barrel_paper_cup", "four", quick_drum + " --cutter-mm 40 --rough-step-down-mm 25",
                "rotary_table_mm.toml", 40.0},
        Example{"barrel_smallest", "four", " --chord-mm 0.01 --set solver.starts=1", ""},
        Example{"cylinder_slide", "four", quick_drum + " --cutter-mm 12 --spindle counterclockwise", "",
                12.0},
        Example{"ocrf_indexing", "five", quick_drum + " --cutter-mm 10 --z-offset-mm 120", "", 10.0},
        Example{"ocrf_indexing", "five",
                quick_drum + " --cutter-mm 10 --z-offset-mm 120 --rough-step-down-mm 15",
                "table_tilting_inch.toml", 10.0}));

}  // namespace interpreter_test
}  // namespace camopt
