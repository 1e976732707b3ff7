// SPDX-License-Identifier: MIT
// golden_texts FOLDER: texts of solutions, comparisons and papers made by hand, in states that no scene
// reaches in a moment: for tests/golden.
#include "benchmarks/papers/paper_json.hpp"
#include "core/text/text_file.hpp"
#include "report/chart/curve_chart.hpp"
#include "report/chart/studies/pareto_svg.hpp"
#include "report/chart/sweep/sweep_svg.hpp"
#include "report/compare/comparison_document.hpp"
#include "report/csv/sweep_csv.hpp"
#include "report/document/document_text.hpp"
#include "report/folders/result_folder.hpp"
#include "report/json/result_json.hpp"
#include "report/page/page_html.hpp"
#include "report/page/result_page.hpp"
#include "report/papers/paper_output.hpp"
#include "report/solve/cam_remarks.hpp"
#include "report/solve/infeasible_words.hpp"
#include "report/sweep/sweep_document.hpp"
#include "report/view/cam_words.hpp"
#include "report/view/key_words.hpp"
#include "report/view/verdict_words.hpp"
#include "studies/papers/reference_table.hpp"
#include "studies/search/plan.hpp"
#include "tests/report/sample_solution.hpp"
#include "tests/report/sample_sweeps.hpp"

#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace camopt {
namespace {

std::string folder;

void write(const std::string& name, const std::string& text) {
    write_text_file(folder + "/" + name, text);
}

std::string all_words(const Solution& solution) {
    std::string text = summary_text(solution) + "\n";
    std::vector<std::string> sentences;
    if (solution.cam) sentences = cam_remarks(solution);
    if (!solution.motion) sentences = infeasible_remarks(solution);
    for (const std::string& sentence : sentences) text += "- " + sentence + "\n";
    return text + "solver: " + solver_words(solution) + "\n";
}

void write_solution(const std::string& name, const Solution& solution) {
    const RunOrigin origin{"scene.toml", "camopt solve scene.toml", "title = \"x\"\n"};
    write(name + ".txt", all_words(solution));
    write(name + "_report.md", report_markdown(solution, origin));
    write(name + "_result.json", result_json(solution, origin));
    write(name + "_page.json", page_data(solution, origin));
    if (solution.motion) write(name + "_motion.svg", motion_svg(solution));
    if (solution.motion && solution.cam) write(name + "_cam.svg", cam_diagrams_svg(solution));
}

/// The sample on a cam, otherwise than it is, each in words alone.
void write_changed_cams() {
    std::string text;
    const auto say = [&](const char* title, const auto& change) {
        Solution solution = test::cam_solution();
        change(solution);
        text += std::string("## ") + title + "\n" + verdict_sentence(solution) + "\n" +
                objective_line(solution) + "\n";
        if (solution.motion)
            for (const std::string& remark : cam_remarks(solution)) text += "- " + remark + "\n";
        text += "solver: " + solver_words(solution) + "\n\n";
    };
    say("active limit, base radius at its least", [](Solution& s) {
        s.constraints.back().active = true;
        s.scene.cam->set(DimensionIndex::base_radius, Dimension(0.03, 0.06));
    });
    say("force just reaches 0", [](Solution& s) { s.cam->summary.forces->least_force = {-1e-9, 0.75}; });
    say("cusp", [](Solution& s) { s.cam->summary.regularity = {0.0, 0.5}; });
    say("undercut in a point", [](Solution& s) { s.cam->summary.regularity = {-1e-6, 0.5}; });
    for (const double relative : {3e-8, 0.02})
        say("forward check", [&](Solution& s) {
            s.cam->forward_check = ForwardCheckReport{1.2e-6, relative, 0.5, 2001, 0.1};
        });
    say("no contact found", [](Solution& s) {
        const double none = std::numeric_limits<double>::infinity();
        s.cam->forward_check = ForwardCheckReport{none, none, 0.5, 2001, 0.1};
    });
    say("return later", [](Solution& s) { s.scene.motion.type = MotionType::rr; });
    for (const double lifts : {-0.32, 0.1})
        say("moved", [&](Solution& s) {
            ChainPart part = s.motion->parts().front();
            part.y0 += lifts;
            s.motion = std::make_shared<const MotionChain>(std::vector<ChainPart>{part});
            text += summary_text(s);
        });
    for (const Verdict verdict : {Verdict::local, Verdict::feasible, Verdict::optimal, Verdict::failed})
        say("general", [&](Solution& s) {
            s.solver.convex = false;
            s.solver.starts = 8;
            s.certificate.verdict = verdict;
            s.certificate.reason =
                verdict == Verdict::failed ? Reason::no_feasible_point : Reason::time_limit;
            if (verdict == Verdict::failed) s.motion.reset();
            text += summary_text(s);
        });
    say("another solver was planned", [](Solution& s) {
        SolvePlan plan;
        plan.solver = "ipopt";
        s.plan = std::make_shared<const SolvePlan>(plan);
    });
    Solution local = test::cam_solution();
    local.solver.convex = false;
    local.certificate.verdict = Verdict::local;
    write("changed_cams.txt", text + report_markdown(local));
    for (const char* const law : {"parabolic", "simple_harmonic", "mcv_50"}) {
        Solution impulses = test::sample_solution();
        impulses.scene.objective.jerk = 0.0;
        impulses.scene.objective.reference.law = law;
        write(std::string("impulses_of_") + law + ".svg", motion_svg(impulses));
    }
    Solution program = test::program_solution();
    program.scene.limits.velocity = PeakLimit{2.5, "limits.velocity", 2.5, ""};
    write("limit_by_segment.svg", motion_svg(program));
    program.scene.limits.velocity = PeakLimit{4.0, "limits.velocity_mm_s", 800.0, "mm/s"};
    write("limit_in_time.svg", motion_svg(program));
}

/// Scenes without a motion, otherwise than they are.
void write_changed_conflicts() {
    std::string text;
    const auto say = [&](const char* title, Solution solution, const auto& change) {
        change(solution);
        text += std::string("## ") + title + "\n" + verdict_sentence(solution) + "\n" +
                conflict_sentence(solution) + "\n";
        for (const std::string& remark : infeasible_remarks(solution)) text += "- " + remark + "\n";
        text += "\n";
    };
    const Solution cam = test::infeasible_cam_solution();
    say("two limits", cam, [](Solution&) {});
    say("one limit", cam, [](Solution& s) { s.conflict.resize(1); });
    say("no places", cam, [](Solution& s) {
        for (ConflictReport& row : s.conflict) row.at = std::numeric_limits<double>::quiet_NaN();
    });
    say("any motion", cam, [](Solution& s) {
        s.conflict.resize(1);
        s.explanation.emplace().any_motion = {"limits.pressure_angle_deg"};
    });
    say("each alone", cam, [](Solution& s) {
        s.explanation.emplace().alone = {"limits.pressure_angle_deg", "limits.cam_radius_min_mm"};
    });
    for (const ExplanationEnd end :
         {ExplanationEnd::time_limit, ExplanationEnd::interrupted, ExplanationEnd::enough})
        for (const bool own_limit : {false, true})
            say("ended early", cam, [&](Solution& s) {
                Explanation& explanation = s.explanation.emplace();
                explanation.seconds = explanation.allowed = 30.0;
                explanation.finest = 32;
                explanation.unsettled = {"cam.offset_mm", "together"};
                explanation.end = end;
                explanation.own_limit = own_limit;
            });
    for (const double at : {3.75, 1.0})
        say("a law and a spline", test::program_solution(), [&](Solution& s) {
            s.conflict = {{"limits.velocity_mm_s", at, 1.0}};
        });
    say("a law whose displacement is free", test::program_solution(), [](Solution& s) {
        s.conflict = {{"limits.velocity_mm_s", 3.75, 1.0}};
        s.scene.motion.segments[1].to.reset();
    });
    say("prescribed", cam, [](Solution& s) {
        ProgramSegment law;
        law.kind = SegmentKind::law;
        law.law = "cycloidal";
        law.to = 1.0;
        law.angle = s.scene.motion.unit_angle();
        s.scene.motion.type = MotionType::program;
        s.scene.motion.segments = {law};
        SolvePlan plan;
        plan.dimensions = 1;
        s.plan = std::make_shared<const SolvePlan>(plan);
    });
    Solution free = cam;
    free.scene.cam->set(DimensionIndex::base_radius, Dimension(0.02, 0.06));
    text += all_words(free);
    for (const Verdict verdict : {Verdict::infeasible, Verdict::failed}) {
        Solution sure = cam;
        sure.certificate.verdict = verdict;
        sure.explanation.emplace().any_motion = {"limits.pressure_angle_deg"};
        SolvePlan plan;
        plan.convex = true;
        sure.plan = std::make_shared<const SolvePlan>(plan);
        text += report_markdown(sure);
    }
    Solution excursion = test::program_solution();
    excursion.segments[1].to = 0.9;
    text += summary_text(excursion);
    write("changed_conflicts.txt", text);
}

void write_words() {
    std::string text;
    for (const Verdict verdict :
         {Verdict::optimal, Verdict::local, Verdict::feasible, Verdict::infeasible, Verdict::failed})
        for (const double gap : {0.0, 6.7e-7, 4e-4}) {
            Certificate certificate;
            certificate.verdict = verdict;
            certificate.reason = Reason::time_limit;
            if (gap > 0.0) certificate.gap = gap;
            certificate.objective = gap > 1e-5 ? 0.010 : 1.0;
            certificate.lower_bound = certificate.objective - gap;
            text += verdict_sentence(certificate) + " | " + gap_words(certificate) + "\n";
        }
    for (const char* const key :
         {"limits.pressure_angle_deg", "limits.acceleration_mm_s2", "limits.contact_moment_min_nm",
          "limits.velocity", "cam.base_radius_mm", "cam.base_radius_mm.max", "motion.via[0].velocity_mm_deg",
          "motion.segments[2].via[1].acceleration_m_s2", "motion.segments[2].angle_deg",
          "motion.segments[2].end.velocity", "motion.via[1].to_deg", "motion.segments[2].via[0]",
          "motion.segments[2].to"}) {
        const KeyWords words = key_words(key, "a remark");
        text +=
            std::string(key) + ": " + words.words + " | " + words.unit + (words.limit ? " | limit\n" : "\n");
    }
    const std::vector<Relaxation> changes = {
        {"cam.base_radius_mm", 30.0, 31.41231},
        {"motion.start.velocity_mm_s", 1200.0, 799.99},
        {"spline.segments", 7.0, 14.0},
        {"spline.breakpoints", 7.0, 14.0},
        {"spline.breakpoints", 7.0, 28.0},
        {"cam.offset_mm", 0.0, -1.25},
        {"limits.pressure_angle_deg", 30.0, 33.1},
        {"limits.acceleration_rad_s2", 300.0, 323.3},
        {"limits.cam_radius_min_mm", 4.0, 2.50009},
        {"cam.roller_radius_mm", 30.0, std::nullopt},
        {"motion.via[1].displacement_mm", 0.35, 0.18},
        {"motion.speed_rpm", 300.0, 280.0},
        {"motion.segments[2].angle_deg",
         50.0,
         54.0,
         54.0,
         false,
         {{"motion.segments[3].angle_deg", 40.0, 36.0}}},
        {"motion.rise_deg", 75.0, 95.0, 95.0, false, {{"motion.return_deg", 75.0, 95.0}}}};
    for (const Relaxation& change : changes) text += change.key + ": " + change_words(change) + "\n";
    text += sufficient_changes(changes) + "\n" + hopeless_changes(changes) + "\n";
    write("words.txt", text);
}

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

/// An optimum, a law that keeps its limit, one that breaks it, one whose cam is undercut, one that does not
/// fit.
void write_comparison() {
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
                       row("undercut", 30.0, 0.1, infinity),
                       {}};
    comparison.rows[0].loss_percent = 0.0;
    comparison.rows[1].loss_percent = 50.0;
    comparison.rows[2].base = NeededBase{std::nullopt, "limits.velocity"};
    ConstraintReport& hertz = comparison.rows[3].limits[0].reached;
    hertz.name = "hertz_pressure_max";
    hertz.unit = "MPa";
    hertz.no_contact = true;
    comparison.rows[4].key = "turning";
    comparison.rows[4].title = "Turning";
    comparison.rows[4].misfit = "turns back at its top";
    comparison.rows[4].objective = infinity;
    const RunOrigin origin{"scene.toml", "camopt compare scene.toml"};
    const Document document = comparison_document(comparison, origin);
    write("comparison.txt", console_text(document));
    write("comparison.json", document_json(document));
    for (const FolderFile& file : text_files(document, origin)) write(file.name, file.text);
    write("comparison_of_nothing.svg", text_files(comparison_document({}), {}).back().text);
}

void write_paper(const std::string& name, const PaperReport& report) {
    const Document document = paper_document(report);
    write(name + ".txt", console_text(document));
    write(name + ".json", paper_report_json(report));
    for (const auto& [file, text] : text_files(document, {})) write(name + "_" + file, text);
}

void write_papers() {
    PaperReport report;
    report.id = "000";
    report.title = "A small report";
    report.source = "Nobody, \"Nothing\"";
    report.introduction = "Made by hand.";
    report.assumptions = {"a radius of 0.5 in"};
    report.tables = {{"table_1",
                      "Table 1",
                      "Of three rows.",
                      {{"time_s", "time", "s", 3}, {"words", "words", ""}, {"value_in", "value", "in", 4}},
                      {{1.0 / 3.0, std::string("as printed, \"rounded\""), 2.0},
                       {0.5, std::string("none"), PaperCell{}},
                       {0.75, std::string("not a number"), std::nan("")}}}};
    report.figures = {{"figure_1", "Fig. 1 <&>", "x", "y", {{"a line", {0, 1, 2}, {0, std::nan(""), 3}}}},
                      {"figure_2", "Fig. 2", "x", "y", {{"points", {1, 10, 0}, {1e-3, 1e2, 5}, true}}},
                      {"figure_3", "Empty", "x", "y", {}}};
    report.figures[1].logarithmic = true;
    report.notes = {"A note."};
    write_paper("paper", report);
    report.faults = {"a row is missing"};
    write("paper_with_fault.txt", console_text(paper_document(report)));

    ReferenceTable table;
    Solution proved, failed;
    Eigen::VectorXd control(7);
    control << 0, 0, 0, 0.5, 1, 1, 1;
    proved.curve = SplineCurve::from_coefficients(SplineSpace::uniform(3, 2, 4, 1.0), control);
    proved.peaks.velocity.value = 2.0;
    proved.peaks.acceleration.value = 8.0;
    proved.peaks.jerk.value = 32.0;
    proved.certificate.verdict = Verdict::optimal;
    proved.certificate.objective = 1.0 / 3.0;
    proved.certificate.lower_bound = 1.0 / 3.0 - 1e-12;
    proved.certificate.gap = 1e-12;
    failed.certificate.reason = Reason::time_limit;
    table.convergence.resize(2);
    table.convergence[0].segments = 12;
    table.convergence[0].printed = PeakFigures{2.0, 8.0, 32.0, 1.126};
    table.convergence[0].printed_points = {0.0, 0.25, 0.5, 0.75, 1.0};
    table.convergence[0].optimum = proved;
    table.convergence[0].optimum_points = {0.0, 0.125, 0.5, 0.875, 1.0};
    table.convergence[0].note = "as printed, \"rounded\"";
    table.convergence[1].segments = 6;
    table.convergence[1].optimum = failed;
    table.laws = {{"Parabolic",
                   "parabolic",
                   PeakFigures{2.0, 4.0, infinity, 0.0},
                   PeakFigures{2.0, 4.0, infinity, infinity},
                   {}},
                  {"Modified cycloidal", "", PeakFigures{1.76, 5.89, 67.0, 0.0}, {}, {}}};
    table.modified_sine_exact = {1.76, 5.53, 69.5, 1.0};
    table.limit = {0.9371963699, 1.7455851, 5.2837114, 54.609086};
    WeightEffectRow weight;
    weight.velocity = weight.acceleration = 0.4;
    weight.jerk = 0.2;
    weight.optimum = failed;
    table.weights = {weight};
    table.notes = {"A first note.", "A second one."};
    write("reference_table.json", reference_table_json(table));
    write_paper("reference", paper_004_report(table));
}

/// Over one key with an infeasible and a failed row, over two keys, over weights with laws.
void write_sweeps() {
    Scene scene;
    scene.title = "Sweep <of> all & sundry";
    SweepTable lines = test::key_table();
    write("sweep_lines.svg", sweep_svg({lines, scene}));
    write("sweep_lines.csv", sweep_csv(lines));
    SweepTable map = test::map_table();
    for (SweepTable* const table : {&lines, &map}) {
        table->rows[2].verdict = Verdict::failed;
        table->rows[2].reason = table->rows[3].reason;
        table->rows[2].objective.reset();
    }
    write("sweep_lines.txt", console_text(sweep_summary(lines, &scene)));
    map.columns.length_unit = LengthUnit::inch;
    write("sweep_map.svg", sweep_svg({map, scene}));
    const LawLosses losses = test::some_losses();
    write("sweep_weights.svg", sweep_svg({test::weight_table(), scene, &losses}));
}

int write_all(const std::filesystem::path& path) {
    folder = path.string();
    std::filesystem::create_directories(path);
    write_solution("sample", test::sample_solution());
    write_solution("cam", test::cam_solution());
    write_solution("undercut", test::undercut_solution());
    write_solution("program", test::program_solution());
    write_solution("infeasible", test::infeasible_solution());
    write_solution("infeasible_cam", test::infeasible_cam_solution());
    write_changed_cams();
    write_changed_conflicts();
    write_words();
    write_comparison();
    write_papers();
    write_sweeps();
    return 0;
}

}  // namespace
}  // namespace camopt

int main(int count, char** words) {
    return count == 2 ? camopt::write_all(words[1]) : 2;
}
