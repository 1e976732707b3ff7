// SPDX-License-Identifier: MIT
#include "studies/search/program/solve_free_angles.hpp"

#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "scene/cost_table.hpp"
#include "scene/motion/set_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace camopt {

namespace {

// Boxes bounded at most; three ranges of a flat optimum would take thousands, and are left open.
constexpr int most_boxes = 400;
// Of a turn: the first step of a move, and the last one that must not help.
constexpr double first_angle_step = 1.0 / 64.0, last_angle_step = 1e-8;
constexpr int most_angle_moves = 400;
// Angles tried at random where those at hand allow no motion.
constexpr int random_angles = 24;
// Of a turn: a box narrower than this has nothing left to gain but rounding.
constexpr double narrowest_box = 1e-12;

/// Angles of the segments with a range.
using Angles = std::vector<double>;

struct AngleBox : ProvedBox {
    Angles least, most;
};

bool rests_at_joint(const ProgramSegment& neighbour, bool at_its_end) {
    if (neighbour.kind == SegmentKind::dwell) return true;
    if (neighbour.kind == SegmentKind::spline) return false;
    const auto law = make_law(neighbour.law);
    const MotionPoint point = at_its_end ? law->at(1.0, Side::left) : law->at(0.0, Side::right);
    constexpr double at_rest = 1e-9;  // of the mean velocity 1: less is rounding
    return std::abs(point.derivative[1]) < at_rest && std::abs(point.derivative[2]) < at_rest;
}

bool is_normalised(const SetPoint& point) {
    return point.units.place.empty() && point.units.velocity.empty() && point.units.acceleration.empty();
}

/// Whether the least objective can only fall where an angle grows (solve_free_angles.hpp).
bool falls_with_angles(const Scene& scene) {
    if (scene.cam || !scene.own_terms.empty() || !scene.own_limits.empty()) return false;
    // A mean over the turn weighs segments by their angles.
    for (const CostTerm& term : cost_terms())
        if (term.kind == CostTerm::Kind::rms && term.weight_in(scene.objective) > 0.0) return false;
    const std::vector<ProgramSegment>& segments = scene.motion.segments;
    const std::size_t count = segments.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (segments[i].kind != SegmentKind::spline) continue;
        if (!std::ranges::all_of(segments[i].via, is_normalised)) return false;
        if (!rests_at_joint(segments[(i + count - 1) % count], true) ||
            !rests_at_joint(segments[(i + 1) % count], false))
            return false;
    }
    return true;
}

class AngleSearch : public ProgramSearch {
 public:
    AngleSearch(const Scene& scene, const SolveGiven& solve_given, const SolveControl& control)
        : ProgramSearch(
              scene, solve_given, control,
              {"angles", "structured, the largest angles of each box", Reason::free_angles, two_ranges}),
          falls_(falls_with_angles(scene)) {
        for (std::size_t i = 0; i < scene.motion.segments.size(); ++i) {
            const ProgramSegment& segment = scene.motion.segments[i];
            if (!segment.angle_range) {
                fixed_ += segment.angle;
                continue;
            }
            searched_.push_back(i);
            whole_.least.push_back(segment.angle_range->least);
            whole_.most.push_back(segment.angle_range->most);
            given_.push_back(segment.angle);
        }
    }

    void run() {
        try_angles(given_, time_for_boxes);
        if (falls_) bound_boxes();
        if (!found() && !proved()) try_at_random();
        if (!proved() && found()) move_angles();
    }

    [[nodiscard]] Solution deliver();

 private:
    // Two ranges are one freedom: no step forth or back helps. Of more, a step along two at once might.
    static constexpr std::size_t two_ranges = 2;

    [[nodiscard]] bool proved() const {
        return !boxes_.empty() &&
               std::ranges::all_of(boxes_, [&](const AngleBox& box) { return is_closed(box); });
    }
    [[nodiscard]] bool counts(const Solution& solution) const override {
        return solution.certificate.verdict != Verdict::failed;
    }

    [[nodiscard]] std::vector<double> all_angles(const Angles& angles) const;
    [[nodiscard]] Scene given(const Values& angles) const override;
    [[nodiscard]] bool narrow(AngleBox& box) const;
    [[nodiscard]] Angles inside(const AngleBox& box) const;
    bool try_angles(const Angles& angles, double part_of_time);
    void bound(AngleBox& box);
    [[nodiscard]] std::vector<AngleBox> split(const AngleBox& box) const;
    void bound_boxes();
    void try_at_random();
    void move_angles();
    [[nodiscard]] std::string words(const AngleBox& box, std::size_t k) const;
    void judge_boxes(Solution& solution) const;
    void tell(Solution& solution) const;

    bool falls_;
    double fixed_ = 0.0;                 ///< rad, of the segments without a range
    std::vector<std::size_t> searched_;  ///< the others
    AngleBox whole_;
    Angles given_;
    std::vector<AngleBox> boxes_;  ///< together they hold everything
    int bounded_ = 0;
};

std::vector<double> AngleSearch::all_angles(const Angles& angles) const {
    std::vector<double> all;
    for (const ProgramSegment& segment : scene_.motion.segments) all.push_back(segment.angle);
    for (std::size_t k = 0; k < angles.size(); ++k) all[searched_[k]] = angles[k];
    return all;
}

/// Leaves of a box what can add up to the turn; false: nothing.
bool AngleSearch::narrow(AngleBox& box) const {
    const double rest = units::turn - fixed_, rounding = narrowest_box * units::turn;
    for (int sweep = 0; sweep < 2; ++sweep) {
        double least = 0.0, most = 0.0;
        for (const double angle : box.least) least += angle;
        for (const double angle : box.most) most += angle;
        if (least > rest + rounding || most < rest - rounding) return false;
        for (std::size_t k = 0; k < box.least.size(); ++k) {
            const double up = std::min(box.most[k], rest - (least - box.least[k]));
            const double down = std::max(box.least[k], rest - (most - box.most[k]));
            box.most[k] = std::max(up, box.least[k]);
            box.least[k] = std::min(down, box.most[k]);
        }
    }
    return true;
}

/// Angles of a box that add up.
Angles AngleSearch::inside(const AngleBox& box) const {
    double least = 0.0, most = 0.0;
    for (const double angle : box.least) least += angle;
    for (const double angle : box.most) most += angle;
    const double part =
        most > least ? std::clamp((units::turn - fixed_ - least) / (most - least), 0.0, 1.0) : 0.0;
    Angles angles;
    for (std::size_t k = 0; k < box.least.size(); ++k)
        angles.push_back(box.least[k] + part * (box.most[k] - box.least[k]));
    return angles;
}

Scene AngleSearch::given(const Values& angles) const {
    Scene scene = with_segment_angles(scene_, all_angles(angles));
    for (ProgramSegment& segment : scene.motion.segments) segment.angle_range.reset();
    return scene;
}

bool AngleSearch::try_angles(const Angles& angles, double part_of_time) {
    if (!try_values(angles, part_of_time)) return false;
    if (control_.progress) {
        const std::string line =
            fmt::format("{} sets of angles, objective {:.9g}", tried_.size(), objective());
        Progress progress(line);
        progress.incumbent = objective();
        control_.progress(progress);
    }
    return true;
}

void AngleSearch::bound(AngleBox& box) {
    ++bounded_;
    const double seconds = left(time_for_boxes);
    if (seconds <= 0.0) return;
    Certificate certificate = solve_given_(quick(box.most, seconds)).certificate;
    if (certificate.verdict == Verdict::infeasible && certificate.proof) {
        box.infeasible = true;
        box.proof = std::make_shared<DualityProof>(std::move(*certificate.proof));
    } else if (certificate.lower_bound && certificate.proof && *certificate.lower_bound > box.bound) {
        box.bound = *certificate.lower_bound;
        box.proof = std::make_shared<DualityProof>(std::move(*certificate.proof));
    }
}

std::vector<AngleBox> AngleSearch::split(const AngleBox& box) const {
    std::size_t widest = 0;
    for (std::size_t k = 1; k < box.least.size(); ++k)
        if (box.most[k] - box.least[k] > box.most[widest] - box.least[widest]) widest = k;
    if (box.most[widest] - box.least[widest] < narrowest_box * units::turn) return {};
    const double middle = 0.5 * (box.least[widest] + box.most[widest]);
    std::vector<AngleBox> parts;
    for (const bool upper : {false, true}) {
        AngleBox part = box;
        (upper ? part.least : part.most)[widest] = middle;
        if (narrow(part)) parts.push_back(std::move(part));
    }
    return parts;
}

void AngleSearch::bound_boxes() {
    AngleBox all = whole_;
    if (!narrow(all)) return;
    bound(all);
    boxes_.push_back(std::move(all));
    while (bounded_ < most_boxes && !proved() && !out_of_time(time_for_boxes)) {
        const auto next = std::ranges::min_element(boxes_, [&](const AngleBox& one, const AngleBox& other) {
            if (is_closed(one) != is_closed(other)) return !is_closed(one);
            return one.bound < other.bound;
        });
        std::vector<AngleBox> parts = split(*next);
        if (parts.empty()) return;
        boxes_.erase(next);
        for (AngleBox& part : parts) {
            if (!out_of_time(time_for_boxes)) {
                try_angles(inside(part), time_for_boxes);
                if (!is_closed(part)) bound(part);
            }
            boxes_.push_back(std::move(part));
        }
    }
}

void AngleSearch::try_at_random() {
    std::mt19937 engine(scene_.solver.seed);
    for (int k = 0; k < random_angles && !found() && !out_of_time(time_for_boxes); ++k) {
        // A box around random corners holds angles that add up, or is passed over.
        AngleBox box = whole_;
        for (std::size_t i = 0; i < box.least.size(); ++i) {
            const double part = static_cast<double>(engine()) / 4294967295.0;
            const double cut = box.least[i] + part * (box.most[i] - box.least[i]);
            (engine() % 2 == 0 ? box.least : box.most)[i] = cut;
        }
        if (narrow(box)) try_angles(inside(box), time_for_boxes);
    }
}

/// From each segment to each other, by steps that shrink where none helps.
void AngleSearch::move_angles() {
    double step = first_angle_step * units::turn;
    int moves = 0;
    while (step >= last_angle_step * units::turn) {
        bool helped = false;
        for (std::size_t from = 0; from < searched_.size() && !helped; ++from) {
            for (std::size_t to = 0; to < searched_.size() && !helped; ++to) {
                const double passed = std::min(
                    {step, best_values_[from] - whole_.least[from], whole_.most[to] - best_values_[to]});
                if (from == to || passed < last_angle_step * units::turn) continue;
                if (++moves > most_angle_moves || out_of_time(time_for_moves)) return;
                Angles angles = best_values_;
                angles[from] -= passed;
                angles[to] += passed;
                helped = try_angles(angles, time_for_moves);
            }
        }
        step = next_step(step, helped);
    }
    settled_ = true;
}

std::string AngleSearch::words(const AngleBox& box, std::size_t k) const {
    return fmt::format("{:.9g} deg <= angle of motion.segments[{}] <= {:.9g} deg",
                       box.least[k] / units::degree, searched_[k], box.most[k] / units::degree);
}

void AngleSearch::judge_boxes(Solution& solution) const {
    std::vector<CaseProof> proofs;
    for (const AngleBox& box : boxes_) {
        std::vector<std::string> region;
        for (std::size_t k = 0; k < searched_.size(); ++k) region.push_back(words(box, k));
        proofs.push_back({std::move(region), box.bound, box.infeasible, box.proof});
    }
    judge(solution, std::move(proofs), timed_out_);
}

/// Angles in rad, so that they come back as they are.
void AngleSearch::tell(Solution& solution) const {
    solution.notes.push_back(fmt::format("searched angles: {} boxes bounded, {} sets of angles tried{}",
                                         bounded_, tried_.size(),
                                         falls_ ? "" : "; no bound over angles is known for such a scene"));
    note_time(solution);
    if (!solution.motion) return;
    std::vector<std::string> names;
    for (const std::size_t segment : searched_)
        names.push_back(fmt::format("motion.segments[{}].angle_rad", segment));
    add_to_design(solution, std::move(names));
}

Solution AngleSearch::deliver() {
    const Angles& angles = found() ? best_values_ : given_;
    // Where there is no motion, the conflict of the given angles is told.
    Solution solution = found() ? best_solved() : solve_given_(given(angles));
    solution.scene = with_segment_angles(scene_, all_angles(angles));
    solution.seconds_solve = solution.seconds_total = watch_.seconds();
    solution.solver.convex = false;
    for (std::string& note : solution.notes) note = "for these angles: " + note;
    judge_boxes(solution);
    tell(solution);
    return solution;
}

}  // namespace

Scene with_segment_angles(const Scene& scene, const std::vector<double>& angles) {
    Scene changed = scene;
    for (std::size_t i = 0; i < angles.size(); ++i) changed.motion.segments[i].angle = angles[i];
    keep_written(changed, scene.motion);
    return changed;
}

Solution solve_free_angles(const Scene& scene, const SolveGiven& solve_given, const SolveControl& control) {
    AngleSearch search(scene, solve_given, control);
    search.run();
    return search.deliver();
}

}  // namespace camopt
