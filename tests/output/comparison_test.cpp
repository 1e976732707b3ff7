// SPDX-License-Identifier: MIT
// The texts of a comparison, against one made by hand: an optimum, a law that keeps its limit, one that
// breaks it with an infinite jerk, one that does not fit.
#include "output/chart/studies/study_svg.hpp"
#include "output/csv/study_csv.hpp"
#include "output/json/study_json.hpp"
#include "output/words/study_text.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace camopt {
namespace comparison_test {

using Json = nlohmann::json;

LimitOutcome angle(double worst) {
    return {{"pressure_angle", "limits.pressure_angle_deg", 30.0, worst, "deg", 0.5, worst >= 30.0},
            worst <= 30.0,
            worst - 30.0};
}

ComparisonRow row(const char* key, double jerk, double objective, double worst) {
    ComparisonRow made;
    made.key = key;
    made.title = std::string("The <") + key + "> law";
    made.peaks.velocity.value = 2.0;
    made.peaks.acceleration.value = 6.0;
    made.peaks.jerk.value = jerk;
    made.objective = objective;
    made.limits = {angle(worst)};
    made.feasible = made.limits[0].kept;
    made.base = NeededBase{worst * 1e-3, {}};
    return made;
}

Comparison sample() {
    Comparison comparison;
    Solution& solution = comparison.optimum;
    solution.scene.title = "Sample & scene";
    solution.scene.objective.jerk = 1.0;
    solution.reference_peaks.jerk.value = 69.0;
    solution.certificate.verdict = Verdict::optimal;
    solution.certificate.objective = 1.0 / 3.0;
    comparison.rows = {row("", 40.0, 1.0 / 3.0, 30.0),
                       row("good", 50.0, 0.5, 28.0),
                       row("bad", infinity, infinity, 33.5),
                       {}};
    comparison.rows[0].loss_percent = 0.0;
    comparison.rows[1].loss_percent = 50.0;
    comparison.rows[2].base = NeededBase{std::nullopt, "limits.velocity"};
    comparison.rows[3].key = "turning";
    comparison.rows[3].title = "Turning";
    comparison.rows[3].misfit = "turns back at its top";
    comparison.rows[3].objective = infinity;
    return comparison;
}

bool holds(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

TEST(ComparisonText, ReportsLossLimitsAndOmissions) {
    const std::string text = comparison_text(sample());
    for (const char* words : {"Sample & scene", "optimum", "+50.00 %", "∞",
                              "pressure angle 33.5 deg, 3.5 above 30", "left out: turns back at its top",
                              "The best law that satisfies every limit: The <good> law", "base mm"})
        EXPECT_TRUE(holds(text, words)) << words << "\n" << text;
}

TEST(ComparisonJson, HasNullForInfiniteAndAbsent) {
    const Json json = Json::parse(comparison_json(sample(), {"scene.toml", "camopt compare scene.toml"}));
    EXPECT_EQ(json["scene"], "scene.toml");
    EXPECT_EQ(json["best_law"], "good");
    ASSERT_EQ(json["rows"].size(), 4U);
    EXPECT_TRUE(json["rows"][0]["law"].is_null());
    EXPECT_EQ(json["rows"][0]["objective"], 1.0 / 3.0);
    EXPECT_TRUE(json["rows"][2]["objective"].is_null());
    EXPECT_TRUE(json["rows"][2]["peaks"]["jerk"]["value"].is_null());
    EXPECT_EQ(json["rows"][2]["limits"][0]["excess"], 3.5);
    EXPECT_FALSE(json["rows"][2]["limits"][0]["kept"]);
    EXPECT_EQ(json["rows"][2]["base_radius"]["stays_broken"], "limits.velocity");
    EXPECT_FALSE(json["rows"][3]["fits"]);
    EXPECT_TRUE(json["rows"][3]["peaks"].is_null());
}

/// A law whose cam is undercut: its pressure is no number, in any of the texts.
TEST(ComparisonTexts, UndercutLawHasNoContact) {
    Comparison comparison = sample();
    ComparisonRow& bad = comparison.rows[2];
    bad.objective = 0.1;
    bad.peaks.jerk.value = 30.0;
    ConstraintReport& hertz = bad.limits[0].reached;
    hertz.name = "hertz_pressure_max";
    hertz.unit = "MPa";
    hertz.worst = infinity;
    hertz.no_contact = true;
    bad.limits[0].excess = infinity;
    const std::string words = "hertz pressure max: undercut, no contact";
    EXPECT_TRUE(holds(comparison_text(comparison), words)) << comparison_text(comparison);
    const std::string csv = comparison_csv(comparison), svg = comparison_svg(comparison);
    EXPECT_TRUE(holds(csv, words)) << csv;
    EXPECT_FALSE(holds(csv, "inf")) << csv;
    EXPECT_TRUE(holds(svg, words));
    const Json json = Json::parse(comparison_json(comparison, {"scene.toml", "camopt compare scene.toml"}));
    EXPECT_TRUE(json["rows"][2]["limits"][0]["no_contact"]);
    EXPECT_TRUE(json["rows"][2]["limits"][0]["worst"].is_null());
    EXPECT_FALSE(json["rows"][1]["limits"][0]["no_contact"]);
}

TEST(ComparisonCsv, EveryLineHasEveryCell) {
    const std::string csv = comparison_csv(sample());
    EXPECT_TRUE(holds(csv, "limits.pressure_angle_deg"));
    EXPECT_TRUE(holds(csv, "0.3333333333333333"));
    EXPECT_FALSE(holds(csv, "inf"));
    EXPECT_TRUE(holds(csv, "\"pressure angle 33.5 deg, 3.5 above 30\""));
    std::size_t begin = 0, commas = 0;
    for (int line = 0; begin < csv.size(); ++line) {
        const std::size_t end = csv.find('\n', begin);
        bool quoted = false;
        std::size_t found = 0;
        for (std::size_t i = begin; i < end; ++i) {
            if (csv[i] == '"') quoted = !quoted;
            if (csv[i] == ',' && !quoted) ++found;
        }
        if (line == 0) commas = found;
        EXPECT_EQ(found, commas) << csv.substr(begin, end - begin);
        begin = end + 1;
    }
}

TEST(ComparisonSvg, DrawsFiniteLawsAndHatchesInfeasible) {
    Comparison comparison = sample();
    std::string svg = comparison_svg(comparison);
    EXPECT_TRUE(holds(svg, "The &lt;good&gt; law"));
    EXPECT_TRUE(holds(svg, "Sample &amp; scene"));
    EXPECT_TRUE(holds(svg, "turns back at its top"));
    EXPECT_FALSE(holds(svg, "nan"));
    EXPECT_FALSE(holds(svg, "inf"));
    const auto broken_bars = [](const std::string& text) {
        std::size_t count = 0;
        for (std::size_t at = 0; (at = text.find("class=\"broken-bar\"", at)) != std::string::npos; ++at)
            ++count;
        return count;
    };
    EXPECT_EQ(broken_bars(svg), 1U);  // in the key: the infinite one has no bar
    comparison.rows[2].objective = 40.0;
    EXPECT_EQ(broken_bars(comparison_svg(comparison)), 2U);
}

TEST(ComparisonSvg, OfNothingIsStillAPicture) {
    const std::string svg = comparison_svg({});
    EXPECT_TRUE(holds(svg, "</svg>"));
    EXPECT_FALSE(holds(svg, "nan"));
}

}  // namespace comparison_test
}  // namespace camopt
