// SPDX-License-Identifier: MIT
// Every row of the table of cost terms is read, refused out of its range, weighed, swept, traded and written:
// a row that is missing anywhere fails here, a new one is tested without an edit.
#include "scene/cost_table.hpp"

#include "objectives/scene_model.hpp"
#include "report/compare/comparison_document.hpp"
#include "report/document/document_text.hpp"
#include "report/folders/result_folder.hpp"
#include "report/json/result_json.hpp"
#include "report/view/number_text.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/delivered/solution_parts.hpp"
#include "studies/pareto/sweep_front.hpp"
#include "studies/solve/solve.hpp"
#include "studies/sweep/sweep_axis.hpp"
#include "studies/sweep/sweep_plan.hpp"
#include "table_scenes.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace camopt {
namespace cost_table_test {

using namespace tables;
using testing_support::says;
using Json = nlohmann::ordered_json;

std::string weighing(const CostTerm& term, double weight) {
    return scene_text(false, fmt::format("{} = {}", term.name(), weight), "");
}

/// All of them, against numbers that no law has.
std::string weighing_all() {
    std::string weights, numbers;
    for (const CostTerm& term : cost_terms()) {
        weights += fmt::format("{} = 0.1\n", term.name());
        numbers += fmt::format("{}{} = {}", numbers.empty() ? "" : ", ", term.name(), 1.25 * term.typical);
    }
    return scene_text(false, fmt::format("{}reference = {{ {} }}", weights, numbers), "");
}

TEST(CostTable, CoversEveryReferenceAndWeight) {
    // Members cannot be counted, but their size can: the law, the numbers, the flag behind them.
    EXPECT_EQ(sizeof(Reference),
              sizeof(std::string) +
                  (cost_terms().size() + response_terms().size()) * sizeof(std::optional<double>) +
                  alignof(double));
    ObjectiveSpec objective;
    std::set<const void*> members;
    std::set<std::string> names;
    for (const CostTerm& term : cost_terms()) {
        EXPECT_TRUE(members.insert(&(objective.*term.weight)).second) << term.name();
        EXPECT_TRUE(members.insert(&(objective.reference.*term.reference)).second) << term.name();
        EXPECT_TRUE(names.insert(term.name()).second) << term.name();
        EXPECT_EQ(&cost_term(term.figure), &term);
        EXPECT_STREQ(name_of(term.figure), term.name());
    }
}

TEST(CostTable, FiguresAreTheMembersOfPeaks) {
    EXPECT_EQ(sizeof(Peaks),
              static_cast<std::size_t>(std::ranges::count_if(
                  peak_figures, [](const PeakFigure& one) { return one.extremum != nullptr; })) *
                      sizeof(Extremum) +
                  static_cast<std::size_t>(std::ranges::count_if(
                      peak_figures, [](const PeakFigure& one) { return one.mean != nullptr; })) *
                      sizeof(double));
    Peaks peaks;
    double number = 1.0;
    for (const PeakFigure& figure : peak_figures) figure.in(peaks) = number++;
    number = 1.0;
    for (const PeakFigure& figure : peak_figures) EXPECT_EQ(figure.of(peaks), number++) << figure.name;
    EXPECT_EQ(derivative_peak(peaks, 3).value, peaks.jerk.value);
    EXPECT_EQ(derivative_mean(peaks, 1), peaks.rms_velocity);
}

TEST(CostTable, EveryRowReadsWeightAndReference) {
    for (const CostTerm& term : cost_terms()) {
        SCOPED_TRACE(term.name());
        const Scene scene = read(weighing(term, 0.25));
        for (const CostTerm& other : cost_terms())
            EXPECT_EQ(other.weight_in(scene.objective), &other == &term ? 0.25 : 0.0);
        const std::string numbers = fmt::format("{0} = 1\nreference = {{ {0} = 7.5 }}", term.name());
        const Scene numeric = read(scene_text(false, numbers, ""));
        EXPECT_EQ(numeric.objective.reference.*term.reference, 7.5);
        EXPECT_EQ(term.measured.of(reference_peaks(numeric)), 7.5);
    }
}

TEST(CostTable, EveryRowRefusesInvalidRange) {
    for (const CostTerm& term : cost_terms()) {
        SCOPED_TRACE(term.name());
        const std::string negative = refusal_of(weighing(term, -1.0));
        EXPECT_TRUE(
            says(negative, fmt::format("objective.{}: found -1; allowed: a number >= 0", term.name())));
        const std::string zero =
            refusal_of(scene_text(false, fmt::format("{0} = 1\nreference = {{ {0} = 0 }}", term.name()), ""));
        EXPECT_TRUE(
            says(zero, fmt::format("objective.reference.{}: found 0; allowed: a number > 0", term.name())));
        Scene scene = read(weighing(term, 1.0));
        scene.objective.reference.numeric = true;
        ASSERT_TRUE(find_fault(scene));
        EXPECT_EQ(find_fault(scene)->member, fmt::format("objective.reference.{}", term.name()));
        scene.objective.*term.weight = -1.0;
        EXPECT_EQ(find_fault(scene)->member, fmt::format("objective.{}", term.name()));
        scene.objective.*term.weight = 0.0;
        EXPECT_TRUE(says(find_fault(scene)->allowed, term.name()));
    }
}

TEST(CostTable, EveryRowIsAModelParameter) {
    for (const CostTerm& term : cost_terms()) {
        const Scene scene = read(weighing(term, 0.5));
        const CamModel model = scene_model(scene, DesignKind::states, reference_peaks(scene));
        const auto weighed = [](const Parameter& one) { return one.weight == 0.5; };
        EXPECT_EQ(std::ranges::count_if(model.parameters, weighed), 1) << term.name();
    }
}

TEST(CostTable, EveryRowIsSweptOrTraded) {
    std::string titles;
    for (const CostTerm& term : cost_terms()) {
        titles += fmt::format("{}{}", titles.empty() ? "" : ",", term.name());
        EXPECT_TRUE(is_weight_key(fmt::format("objective.{}", term.name())));
        Scene scene = read(weighing(term, 1.0));
        if (!term.traded) {
            EXPECT_THROW((void)front_goal(term.name(), scene), InputError);
            continue;
        }
        const FrontGoal goal = front_goal(term.name(), scene);
        EXPECT_EQ(name_of(goal), term.name());
        EXPECT_EQ(weight_of(scene, goal), 1.0);
        EXPECT_EQ(can_be_capped(scene, goal), term.limit != nullptr);
        EXPECT_EQ(reference_of(scene, goal), term.measured.of(reference_peaks(scene)));
        scale_weights(scene, 2.0);
        EXPECT_EQ(term.weight_in(scene.objective), 2.0);
    }
    std::string point;
    for (std::size_t i = 0; i < cost_terms().size(); ++i) point += i == 0 ? "1" : ",1";
    EXPECT_EQ(weights_of_csv(titles + "\n" + point, "w.csv").keys.size(), cost_terms().size());
}

TEST(CostTable, EveryRowIsPaidAndWritten) {
    const Solution solution = solve(read(weighing_all()));
    ASSERT_TRUE(solution.motion);
    double sum = 0.0;
    for (const CostTerm& term : cost_terms())
        sum += 0.1 * term.measured.of(solution.peaks) / (1.25 * term.typical);
    EXPECT_NEAR(defined_objective(solution), sum, 1e-12);
    EXPECT_NEAR(solution.certificate.objective, sum, 1e-7);
    const Json json = Json::parse(result_json(solution));
    const std::string report = report_markdown(solution);
    const SweepRow row = sweep_row(0, {}, solution);
    for (const CostTerm& term : cost_terms()) {
        SCOPED_TRACE(term.name());
        EXPECT_EQ(json["reference"][term.name()], 1.25 * term.typical);
        EXPECT_TRUE(json["peaks"].contains(term.name()));
        EXPECT_EQ(row.figure(term.figure), term.measured.of(solution.peaks));
        EXPECT_TRUE(says(report, fmt::format("| `objective.{}` | `0.1` |", term.name())));
    }
}

TEST(CostTable, EveryRowIsAComparisonColumn) {
    Scene scene = read(weighing_all());
    scene.cam.reset();
    scene.forces.reset();
    const Comparison comparison = compare(scene);
    const Document document = comparison_document(comparison);
    const Section& section = document.sections.front();
    std::string titles = table_csv(section.tables.back());
    titles.resize(titles.find('\n'));
    std::string words;
    for (const Sentence& sentence : section.sentences)
        if (sentence.key == "objective") words = sentence.text;
    for (const CostTerm& term : cost_terms()) {
        EXPECT_TRUE(says(("," + titles + ","), fmt::format(",{},", term.name())));
        EXPECT_TRUE(says(words, fmt::format("{}/", term.symbol)));
    }
}

}  // namespace cost_table_test
}  // namespace camopt
