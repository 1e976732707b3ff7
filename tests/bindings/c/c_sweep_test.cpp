// SPDX-License-Identifier: MIT
// Sweeps through the C face: the rows of the C++ face, bit for bit; cancelling; errors.
#include "core/units.hpp"
#include "input/loading/load_scene.hpp"
#include "studies/sweep/sweep_run.hpp"
#include "tests/bindings/c/c_face.hpp"

#include <cmath>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace camopt {
namespace c_sweep_test {

using namespace testing_support;

/// What is kept of a row after its callback.
struct KeptRow {
    std::size_t number = 0, rows = 0;
    std::vector<double> settings, numbers, parameters;
    std::string verdict, reason;
    std::vector<std::string> active_limits;
    int iterations = 0;
};

KeptRow kept(const camopt_sweep_row& row) {
    EXPECT_EQ(row.size, sizeof(camopt_sweep_row));
    KeptRow copy{row.number, row.rows, {row.settings, row.settings + row.setting_count}, {}, {}, "", "",
                 {},         0};
    copy.numbers = {row.objective,    row.lower_bound, row.gap,    row.any_curve,        row.velocity,
                    row.acceleration, row.jerk,        row.torque, row.rms_acceleration, row.rms_jerk};
    for (std::size_t i = 0; i < row.parameter_count; ++i) copy.parameters.push_back(row.parameters[i].value);
    copy.verdict = camopt_verdict_name(row.verdict);
    copy.reason = row.reason;
    for (std::size_t i = 0; i < row.active_limit_count; ++i)
        copy.active_limits.emplace_back(row.active_limits[i]);
    copy.iterations = row.iterations;
    return copy;
}

struct Rows {
    std::vector<KeptRow> all;
    std::size_t enough = 1000;
    bool throws = false;
    int asked = 0, cancel_at = -1;
};

int take(const camopt_sweep_row* row, void* user) {
    Rows& rows = *static_cast<Rows*>(user);
    if (rows.throws) throw std::runtime_error("the disk is full");
    rows.all.push_back(kept(*row));
    return rows.all.size() >= rows.enough ? 1 : 0;
}

int cancel_sweep(void* user) {
    Rows& rows = *static_cast<Rows*>(user);
    return ++rows.asked == rows.cancel_at ? 1 : 0;
}

const char* const weight_keys[] = {"objective.velocity", "objective.jerk"};
const double weights[] = {0.1, 0.9, 0.5, 0.5, 0.9, 0.1};
const char* const segment_keys[] = {"spline.segments"};
const double segments[] = {8, 12, 16, 20};
const camopt_sweep_axis axes[] = {{weight_keys, 2, weights, 3}, {segment_keys, 1, segments, 4}};

double or_nan(const std::optional<double>& value) {
    return value.value_or(std::nan(""));
}

/// The same sweep of a file's scene without the C face.
std::vector<SweepRow> cpp_rows(const std::string& toml, const std::vector<SweepAxis>& cpp_axes) {
    const SweepPlan plan = sweep_grid(cpp_axes);
    SweepScenes scenes(
        plan, [&](std::span<const std::string> settings) { return scene_of_toml(toml, settings, "test"); });
    (void)check_rows(scenes);
    const Chunking chunks{plan.rows(), chunk_size_for(scenes)};
    std::vector<SweepRow> all;
    for (int chunk = 0; chunk < chunks.count(); ++chunk)
        for (SweepRow& row : solve_chunk(scenes, chunks.range(chunk))) all.push_back(std::move(row));
    return all;
}

void expect_same_rows(const std::vector<KeptRow>& c, const std::vector<SweepRow>& cpp) {
    ASSERT_EQ(c.size(), cpp.size());
    for (std::size_t i = 0; i < c.size(); ++i) {
        const SweepRow& row = cpp[i];
        EXPECT_EQ(c[i].number, i);
        EXPECT_EQ(c[i].rows, cpp.size());
        EXPECT_EQ(c[i].settings, row.settings);
        EXPECT_EQ(c[i].verdict, name_of(row.verdict));
        EXPECT_EQ(c[i].reason, row.reason);
        EXPECT_EQ(c[i].active_limits, row.active_limits);
        EXPECT_EQ(c[i].iterations, row.iterations);
        std::vector<double> numbers = {or_nan(row.objective), or_nan(row.lower_bound), or_nan(row.gap),
                                       or_nan(row.any_curve_limit)};
        for (const std::optional<double>& figure : row.figures) numbers.push_back(or_nan(figure));
        ASSERT_EQ(c[i].numbers.size(), numbers.size());
        for (std::size_t k = 0; k < numbers.size(); ++k)
            EXPECT_TRUE(c[i].numbers[k] == numbers[k] ||
                        (std::isnan(c[i].numbers[k]) && std::isnan(numbers[k])))
                << i << ' ' << k;
    }
}

TEST(CSweep, HasTheRowsOfCpp) {
    Rows rows;
    EXPECT_OK(camopt_sweep(c_scene(paper_toml).get(), axes, 2, nullptr, take, &rows));
    expect_same_rows(
        rows.all,
        cpp_rows(paper_toml, {{{"objective.velocity", "objective.jerk"}, {0.1, 0.9, 0.5, 0.5, 0.9, 0.1}},
                              {{"spline.segments"}, {8, 12, 16, 20}}}));
}

TEST(CSweep, ReportsLimitsDimensionsAndFailedRows) {
    const std::string toml =
        "[motion]\ntype = \"DRD\"\nlift_mm = 20\nrise_deg = 100\n[spline]\nsegments = 12\n"
        "[objective]\nacceleration = 1\nbase_radius = 0.1\n"
        "[cam]\ntype = \"disk\"\nfollower = \"translating_roller\"\nroller_radius_mm = 8\n"
        "base_radius_mm = { min = 14, max = 80 }\n[limits]\npressure_angle_deg = 30\n[solver]\nstarts = 1\n";
    const char* const keys[] = {"limits.pressure_angle_deg"};
    const double angles[] = {4, 25, 30};
    const camopt_sweep_axis axis{keys, 1, angles, 3};
    Rows rows;
    EXPECT_OK(camopt_sweep(c_scene(toml).get(), &axis, 1, nullptr, take, &rows));
    const std::vector<SweepRow> cpp = cpp_rows(toml, {{{"limits.pressure_angle_deg"}, {4, 25, 30}}});
    expect_same_rows(rows.all, cpp);
    ASSERT_EQ(rows.all.size(), 3U);
    EXPECT_EQ(rows.all[0].verdict, "infeasible");
    EXPECT_TRUE(std::isnan(rows.all[0].numbers[0]));
    EXPECT_TRUE(rows.all[0].parameters.empty());
    ASSERT_EQ(rows.all[2].parameters.size(), 1U);
    EXPECT_EQ(rows.all[2].parameters[0], *cpp[2].dimension(DimensionIndex::base_radius) / units::millimetre);
    EXPECT_GT(rows.all[1].parameters[0], rows.all[2].parameters[0]);
    EXPECT_EQ(rows.all[2].active_limits, std::vector<std::string>{"limits.pressure_angle_deg"});
}

TEST(CSweep, EndsWhereItsCallbackSaysSo) {
    Rows rows;
    rows.enough = 5;
    EXPECT_EQ(camopt_sweep(c_scene(paper_toml).get(), axes, 2, nullptr, take, &rows), CAMOPT_ERROR_CANCELLED);
    EXPECT_STREQ(camopt_error_text(), "the sweep was stopped by its caller after 5 of 12 rows");
    EXPECT_EQ(rows.all.size(), 5U);
    Rows last;
    last.enough = 12;  // nothing was left to be cancelled
    EXPECT_OK(camopt_sweep(c_scene(paper_toml).get(), axes, 2, nullptr, take, &last));
}

TEST(CSweep, StopsWithinRowOnCancel) {
    Rows all, rows;
    camopt_solve_options options{};
    options.size = sizeof options;
    options.cancel = cancel_sweep;
    options.user = &all;
    const CScene scene = c_scene(paper_toml);
    EXPECT_OK(camopt_sweep(scene.get(), axes, 2, &options, take, &all));
    EXPECT_EQ(all.all.size(), 12U);
    rows.cancel_at = all.asked / 2;
    options.user = &rows;
    EXPECT_EQ(camopt_sweep(scene.get(), axes, 2, &options, take, &rows), CAMOPT_ERROR_CANCELLED);
    EXPECT_EQ(rows.asked, rows.cancel_at);
    ASSERT_LT(rows.all.size(), all.all.size());
    for (std::size_t i = 0; i < rows.all.size(); ++i) EXPECT_EQ(rows.all[i].numbers, all.all[i].numbers) << i;
    Rows none;
    none.cancel_at = 1;
    options.user = &none;
    EXPECT_EQ(camopt_sweep(scene.get(), axes, 2, &options, take, &none), CAMOPT_ERROR_CANCELLED);
    EXPECT_TRUE(none.all.empty());
}

TEST(CSweep, ContainsExceptionsOfCallbacks) {
    Rows rows;
    rows.throws = true;
    EXPECT_EQ(camopt_sweep(c_scene(paper_toml).get(), axes, 2, nullptr, take, &rows), CAMOPT_ERROR_CALLBACK);
    EXPECT_STREQ(camopt_error_text(), "a callback threw: the disk is full");
}

TEST(CSweep, RefusesInvalidRowsBeforeSolving) {
    const CScene scene = c_scene(paper_toml);
    Rows rows;
    const char* const velocity[] = {"limits.velocity"};
    const double caps[] = {2, 1.9, -1};
    const camopt_sweep_axis wrong{velocity, 1, caps, 3};
    EXPECT_EQ(camopt_sweep(scene.get(), &wrong, 1, nullptr, take, &rows), CAMOPT_ERROR_INPUT);
    EXPECT_EQ(std::string_view(camopt_error_text()).substr(0, 58),
              "row 2 (limits.velocity=-1): limits.velocity: found -1; all");
    const char* const slip[] = {"objective.jrk"};
    const camopt_sweep_axis unknown{slip, 1, caps, 1};
    EXPECT_EQ(camopt_sweep(scene.get(), &unknown, 1, nullptr, take, &rows), CAMOPT_ERROR_INPUT);
    EXPECT_NE(std::string_view(camopt_error_text()).find("did you mean 'jerk'?"), std::string_view::npos);
    const camopt_sweep_axis twice[] = {axes[1], axes[1]};
    EXPECT_EQ(camopt_sweep(scene.get(), twice, 2, nullptr, take, &rows), CAMOPT_ERROR_INPUT);
    EXPECT_TRUE(rows.all.empty());
    EXPECT_EQ(toml_of(scene), paper_toml);
}

TEST(CSweep, RefusesNullsAndInvalidArguments) {
    const CScene scene = c_scene(paper_toml);
    Rows rows;
    const char* const no_key[] = {nullptr};
    const camopt_sweep_axis no_keys{nullptr, 1, segments, 4}, no_values{segment_keys, 1, nullptr, 4},
        null_key{no_key, 1, segments, 4};
    for (const camopt_sweep_axis& axis : {no_keys, no_values, null_key})
        EXPECT_EQ(camopt_sweep(scene.get(), &axis, 1, nullptr, take, &rows), CAMOPT_ERROR_NULL);
    EXPECT_EQ(camopt_sweep(nullptr, axes, 2, nullptr, take, &rows), CAMOPT_ERROR_NULL);
    EXPECT_EQ(camopt_sweep(scene.get(), nullptr, 2, nullptr, take, &rows), CAMOPT_ERROR_NULL);
    EXPECT_EQ(camopt_sweep(scene.get(), axes, 2, nullptr, nullptr, &rows), CAMOPT_ERROR_NULL);
    EXPECT_EQ(camopt_sweep(scene.get(), axes, 0, nullptr, take, &rows), CAMOPT_ERROR_ARGUMENT);
    const camopt_sweep_axis endless{segment_keys, 1, segments, 2'000'000},
        empty{segment_keys, 1, segments, 0}, nothing{segment_keys, 0, segments, 4};
    EXPECT_EQ(camopt_sweep(scene.get(), &endless, 1, nullptr, take, &rows), CAMOPT_ERROR_ARGUMENT);
    EXPECT_EQ(camopt_sweep(scene.get(), &empty, 1, nullptr, take, &rows), CAMOPT_ERROR_INPUT);
    EXPECT_EQ(camopt_sweep(scene.get(), &nothing, 1, nullptr, take, &rows), CAMOPT_ERROR_INPUT);
    EXPECT_TRUE(rows.all.empty());
}

}  // namespace c_sweep_test
}  // namespace camopt
