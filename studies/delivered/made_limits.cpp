// SPDX-License-Identifier: MIT
#include "studies/delivered/made_limits.hpp"

#include "core/text/list_text.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "objectives/rules/made_cams.hpp"
#include "scene/limit_table.hpp"
#include "studies/delivered/cam_report.hpp"
#include "studies/delivered/scene_limits.hpp"

#include <map>
#include <set>

namespace camopt {

namespace {

// Relative to a limit: half of what the audit lets pass (figure_rounding).
constexpr double passing = 5e-9;
// A cam this close to the worst one differs from it by the square of this, and has a short name.
constexpr double parts_apart = 1000.0;

/// The motion of a made cam at its worst: every derivative is off by its error, everywhere.
class MadeMotion final : public Motion {
 public:
    /// errors: of y, y', y'', in lifts and units of x.
    MadeMotion(const Motion& drawn, const std::array<double, 3>& errors) : drawn_(drawn), errors_(errors) {}

    [[nodiscard]] double begin() const override { return drawn_.begin(); }
    [[nodiscard]] double end() const override { return drawn_.end(); }
    [[nodiscard]] std::vector<double> breakpoints() const override { return drawn_.breakpoints(); }
    [[nodiscard]] MotionPoint at(double x, Side side) const override {
        MotionPoint point = drawn_.at(x, side);
        for (std::size_t order = 0; order < errors_.size(); ++order)
            point.derivative[order] += errors_[order];
        return point;
    }

 private:
    const Motion& drawn_;
    std::array<double, 3> errors_;
};

std::array<double, 3> normalised(const std::array<double, 3>& errors, const MotionScale& scale) {
    std::array<double, 3> own{};
    for (std::size_t order = 0; order < own.size(); ++order)
        own[order] = errors[order] * std::pow(scale.unit_angle, static_cast<double>(order)) / scale.lift;
    return own;
}

/// By the key of a limit: the errors that move it somewhere, as the words of made cams name them.
std::map<std::string, std::set<std::string>> errors_of_limits(const Scene& scene, const CamVariables& drawn,
                                                              const Motion& motion) {
    constexpr int places = 24;
    const FreeCam free = with_free_numbers(scene, drawn);
    std::vector<std::string> numbers;
    for (const auto& entry : scene.tolerance->numbers) numbers.push_back(entry.first);
    std::map<std::string, std::set<std::string>> all;
    for (const auto& rule : cam_limits(free.scene, free.variables)) {
        std::set<std::string>& own = all[rule->name()];
        if (rule->highest_order() == 0) own.insert("s'");  // at rest the slope is that of the made cam
        const auto count = static_cast<Eigen::Index>(rule->parameters().size());
        for (const double x : even_places(motion.breakpoints(), places)) {
            const RuleValue here = rule->evaluate(motion_at(motion, x), Eigen::VectorXd::Zero(count));
            for (std::size_t order = 0; order < made_cam_marks.size(); ++order)
                if (here.gradient[static_cast<Eigen::Index>(order)] != 0.0) own.insert(made_cam_marks[order]);
            for (Eigen::Index k = 0; k < count; ++k)
                if (here.gradient[4 + k] != 0.0)
                    own.insert(numbers[free.places[static_cast<std::size_t>(k)]]);
        }
    }
    return all;
}

/// The name of a made cam without the errors that do not matter.
std::string with_errors(const std::string& cam, const std::set<std::string>& which) {
    std::string kept;
    for (std::size_t begin = cam.find(' ') + 1; begin != 0 && begin < cam.size();) {
        const std::size_t end = std::min(cam.find_first_of(" ,", begin), cam.size());
        const std::string word = cam.substr(begin, end - begin);
        if (which.contains(word.substr(0, word.find_first_of("+-")))) append_item(kept, word, " ");
        begin = std::min(cam.find_first_not_of(" ,", end), cam.size());
    }
    return kept;
}

void keep_worse(std::vector<ConstraintReport>& all, ConstraintReport one) {
    const auto same = std::ranges::find(all, one.key, &ConstraintReport::key);
    if (same == all.end())
        all.push_back(std::move(one));
    else if (limit_excess(one) > limit_excess(*same))
        *same = std::move(one);
}

/// What the error of a derivative adds to the peak that a limit holds, in its unit.
double error_of(const Scene& scene, const PeakLimitRow& row) {
    const PeakLimit& limit = *row.in(scene.limits);
    return scene.motion_error(row.order()) * limit.unit_per_normalised();
}

/// The cams that are the worst of some limit: at the ends of the tolerances by their names, and between them.
struct WorstCams {
    std::set<std::string> at_ends;
    std::vector<MadeParts> between;
};

WorstCams worst_cams(const std::vector<EnclosedLimit>& limits) {
    std::map<std::string, const EnclosedLimit*> worst;
    for (const EnclosedLimit& one : limits) {
        const EnclosedLimit*& own = worst.try_emplace(one.key, &one).first->second;
        if (one.worst > own->worst) own = &one;
    }
    WorstCams cams;
    for (const auto& entry : worst) {
        if (entry.second->between)
            cams.between.push_back(*entry.second->between);
        else
            cams.at_ends.insert(entry.second->made);
    }
    return cams;
}

/// limits: of the solution along its motion, with the tolerances of the scene.
std::vector<ConstraintReport> made_constraints(const Solution& solution, const Scene& scene,
                                               const std::vector<EnclosedLimit>& limits) {
    const WorstCams cams = worst_cams(limits);
    CamVariables drawn;
    drawn.cam = solution.cam->cam;
    drawn.scale = {scene.motion.lift, scene.motion.unit_angle()};
    std::vector<ConstraintReport> all;
    const auto report = [&](const Scene& own, const CamVariables& made) {
        const MadeMotion motion(*solution.motion, normalised(made.motion_error, made.scale));
        CamReport cam;
        cam.cam = made.cam;
        cam.summary = cam_summary(cam.cam, motion, own);
        for (ConstraintReport& one : cam_constraints(own, cam)) {
            one.made_at = one.at;
            one.made_cam = made.made;
            keep_worse(all, std::move(one));
        }
    };
    visit_made_cams(scene, drawn, [&](const Scene& own, const CamVariables& made) {
        if (cams.at_ends.contains(made.made)) report(own, made);
    });
    for (const MadeParts& parts : cams.between) visit_made_cam(scene, drawn, parts, report);
    return all;
}

}  // namespace

std::vector<ConstraintReport> made_constraints(const Solution& solution, const Scene& scene) {
    return made_constraints(solution, scene,
                            enclosed_limits(scene, solution.cam.value().cam, *solution.motion));
}

std::vector<MadeParts> passing_cams(const Solution& solution) {
    std::vector<MadeParts> all;
    if (!solution.cam || !solution.scene.tolerance) return all;
    const std::vector<MadeParts>& known = solution.scene.tolerance->between;
    for (const EnclosedLimit& one : solution.cam->limits_along) {
        if (!one.between || !(one.worst > std::max(solution.scene.solver.tolerance, passing))) continue;
        MadeParts parts = *one.between;
        const auto round = [](double& part) { part = std::round(part * parts_apart) / parts_apart + 0.0; };
        std::ranges::for_each(parts.motion, round);
        std::ranges::for_each(parts.numbers, round);
        const auto is_new = [&](const auto& others) {
            return std::ranges::find(others, parts) == others.end();
        };
        if (is_new(known) && is_new(all)) all.push_back(std::move(parts));
    }
    return all;
}

void hold_for_made_cams(Solution& solution) {
    const Scene& scene = solution.scene;
    for (const PeakLimitRow& row : peak_limit_rows())
        for (ConstraintReport& own : solution.constraints)
            if (row.in(scene.limits) && own.key == row.in(scene.limits)->key) {
                own.made = own.worst + (row.side < 0 ? -1.0 : 1.0) * error_of(scene, row);
                own.made_at = own.at;
            }
    if (!solution.cam) return;
    CamVariables drawn;
    drawn.cam = solution.cam->cam;
    drawn.scale = {scene.motion.lift, scene.motion.unit_angle()};
    const auto errors = errors_of_limits(scene, drawn, *solution.motion);
    for (const ConstraintReport& made : made_constraints(solution, scene, solution.cam->limits_along))
        for (ConstraintReport& own : solution.constraints)
            if (own.key == made.key) {
                own.made = made.worst;
                own.made_at = made.made_at;
                const auto which = errors.find(made.key);
                if (which != errors.end()) own.made_cam = with_errors(made.made_cam, which->second);
            }
}

}  // namespace camopt
