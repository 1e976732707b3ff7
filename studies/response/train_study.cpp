// SPDX-License-Identifier: MIT
#include "studies/response/train_study.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "objectives/scene_family.hpp"
#include "scene/limit_table.hpp"
#include "studies/delivered/solution_parts.hpp"
#include "studies/least/least_value.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

constexpr int default_speed_count = 61;
constexpr int lift_off_bisections = 50;
// Lift-off is looked for up to this many times the highest speed of the study.
constexpr double farthest_speed = 2.0;
constexpr int history_instants = 401;
// Of the slowest period: what a history shows of the dwell after the rise.
constexpr double shown_periods = 3.0;

class TrainStudyRun {
 public:
    TrainStudyRun(const Scene& scene, const SpeedSweep& speeds) : scene_(scene) {
        study_.natural_frequencies = train_of(scene).natural_frequencies();
        for (int k = 0; k < speeds.count; ++k) {
            const double part = speeds.count == 1 ? 0.0 : static_cast<double>(k) / (speeds.count - 1);
            study_.speeds.push_back(speeds.from + part * (speeds.to - speeds.from));
        }
        study_.strokes = motion_events(scene.motion);
        if (study_.strokes.empty()) study_.strokes = {{{{0.0, scene.motion.length()}}, {}}};
    }

    void add(const std::string& key, const std::string& title, const Motion& motion, bool with_history) {
        study_.motions.emplace_back(key, title);
        pieces_.push_back(train_of(scene_).pieces(motion));
        if (with_history) add_history(key, pieces_of_event(pieces_.back(), study_.strokes.front()));
    }
    void add_rows() {
        for (std::size_t stroke = 0; stroke < study_.strokes.size(); ++stroke)
            for (std::size_t i = 0; i < pieces_.size(); ++i) {
                const EventPieces pieces = pieces_of_event(pieces_[i], study_.strokes[stroke]);
                for (const double speed : study_.speeds) {
                    study_.rows.push_back(row(pieces, speed));
                    study_.rows.back().motion = study_.motions[i].first;
                    study_.rows.back().stroke = static_cast<int>(stroke) + 1;
                }
                study_.lift_off_speeds.push_back(lift_off(pieces));
            }
    }
    /// A train whose springs and dampers all are so much stiffer, in lifts and x, is the given one at a speed
    /// that is so much lower.
    void add_detuned() {
        if (!train_of(scene_).vibrates()) return;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            DetunedRow& row = study_.detuned.emplace_back(DetunedRow{study_.motions[i].first, {}});
            for (std::size_t k = 0; k < detuning.size(); ++k) {
                const auto train = train_at(scene_, scene_.motion.speed.value() / detuning[k]);
                for (const MotionEvent& stroke : study_.strokes) {
                    const EventPieces pieces = pieces_of_event(pieces_[i], stroke);
                    row.residual[k] = std::max(row.residual[k], EventResponse(*train, pieces).residual());
                }
            }
        }
    }
    void add_steady(const Motion& turn) {
        const std::vector<SlopePiece> pieces = train_of(scene_).pieces(turn);
        for (const double speed : study_.speeds) {
            const auto train = train_at(scene_, speed);
            const Eigen::VectorXd start = train->steady_start(pieces);
            if (!start.allFinite()) continue;
            const auto states = train->states_along(pieces, start, pieces.back().slope.sum());
            const auto largest = [&](const TrainAtSpeed::Reading& reading, double sign) {
                double best = -infinity;
                for (std::size_t i = 0; i < pieces.size(); ++i)
                    for (const Extremum& one : train->maxima(reading, sign, states[i], pieces[i], best))
                        best = std::max(best, one.value);
                return best;
            };
            const auto magnitude = [&](const TrainAtSpeed::Reading& reading) {
                return std::max(largest(reading, 1.0), largest(reading, -1.0));
            };
            SteadyRow row{speed, magnitude(train->deflection()), magnitude(train->acceleration()), {}};
            if (scene_.dynamics->pressed()) row.least_force = -largest(train->contact_force(), -1.0);
            study_.steady.push_back(row);
        }
    }

    TrainStudy finished() { return std::move(study_); }

 private:
    void add_history(const std::string& key, const EventPieces& pieces) {
        const double speed = scene_.motion.speed.value();
        const auto train = train_at(scene_, speed);
        const double period =
            units::turn / study_.natural_frequencies.front() * speed / scene_.motion.unit_angle();
        TrainHistory history{key, speed, {}};
        std::vector<SlopePiece> run = pieces.moving;
        double length = 0.0, dwell = 0.0;
        for (const SlopePiece& piece : pieces.moving) length += piece.width;
        for (SlopePiece piece : pieces.dwell) {
            piece.width = std::min(piece.width, shown_periods * period - dwell);
            if (piece.width <= 0.0) break;
            dwell += piece.width;
            run.push_back(std::move(piece));
        }
        const std::vector<Eigen::VectorXd> states =
            train->states_along(run, Eigen::VectorXd::Zero(train->states()), 0.0);
        double begin = 0.0;
        for (std::size_t i = 0; i < run.size(); ++i) {
            const SlopePiece& piece = run[i];
            const int count =
                std::max(2, static_cast<int>(std::ceil(history_instants * piece.width / (length + dwell))));
            for (int k = 0; k < count + (i + 1 == run.size() ? 1 : 0); ++k) {
                const double t = static_cast<double>(k) / count;
                const Eigen::VectorXd state = train->state_inside(states[i], piece, t);
                double y = piece.displacement, v = 0.0, a = 0.0;
                for (Eigen::Index j = piece.slope.size(); j-- > 0;) v = v * t + piece.slope[j];
                for (Eigen::Index j = piece.slope.size() - 1; j >= 1; --j)
                    a = a * t + static_cast<double>(j) * piece.slope[j];
                a /= piece.width;
                for (Eigen::Index j = 0; j < piece.slope.size(); ++j)
                    y += piece.width * piece.slope[j] * std::pow(t, j + 1) / static_cast<double>(j + 1);
                const auto read = [&](const TrainAtSpeed::Reading& reading) {
                    return reading.state.dot(state) + reading.motion[0] * y + reading.motion[1] * v +
                           reading.motion[2] * a + reading.constant;
                };
                history.instants.push_back({begin + t * piece.width, y, y + read(train->deflection()), a,
                                            read(train->acceleration()), read(train->contact_force())});
            }
            begin += piece.width;
        }
        study_.histories.push_back(std::move(history));
    }
    [[nodiscard]] TrainRow row(const EventPieces& pieces, double speed) const {
        const auto train = train_at(scene_, speed);
        const EventResponse response(*train, pieces);
        TrainRow row;
        row.speed = speed;
        double length = 0.0;
        for (const SlopePiece& piece : pieces.moving) length += piece.width;
        row.frequency_ratio =
            length * scene_.motion.unit_angle() / speed * study_.natural_frequencies.front() / units::turn;
        row.residual = response.residual();
        row.peak_deflection = response.largest_magnitude(train->deflection(), false).value;
        row.peak_acceleration = response.largest_magnitude(train->acceleration(), false).value;
        if (scene_.dynamics->pressed())
            row.least_force = -response.largest(train->contact_force(), -1.0, true).value;
        return row;
    }
    [[nodiscard]] double least_force(const EventPieces& pieces, double speed) const {
        const auto train = train_at(scene_, speed);
        return -EventResponse(*train, pieces).largest(train->contact_force(), -1.0, true).value;
    }
    /// Contact may be lost in resonance and found again: the first loss on a fine grid, then its border.
    [[nodiscard]] std::optional<double> lift_off(const EventPieces& pieces) const {
        if (!scene_.dynamics->pressed()) return std::nullopt;
        const double highest = farthest_speed * study_.speeds.back();
        constexpr int steps = 120;
        const auto keeps = [&](double speed) { return least_force(pieces, speed) >= 0.0; };
        for (int k = 1; k <= steps; ++k) {
            const double speed = highest * k / steps;
            if (keeps(speed)) continue;
            return bisected(keeps, {highest * (k - 1) / steps, speed}, lift_off_bisections).without;
        }
        return std::nullopt;
    }

    const Scene& scene_;
    TrainStudy study_;
    std::vector<std::vector<SlopePiece>> pieces_;  ///< by motion
};

bool is_damped(const DynamicsSpec& spec) {
    return spec.output().damping > 0.0 &&
           std::ranges::all_of(spec.stages, [](const TrainStage& stage) { return stage.damping > 0.0; });
}

bool asks_train(const Scene& scene) {
    return scene.prescribes_output() || weighs_response(scene.objective) ||
           std::ranges::any_of(limit_rows(), [&](const LimitRow& row) {
               return row.needs_dynamics && row.in(scene.limits).has_value();
           });
}

void require_train(const Scene& scene) {
    if (!scene.dynamics)
        throw SceneError({"dynamics", "a scene without a [dynamics] table", "a scene with one"});
}

/// A polynomial on [0, 1] by powers from the left of each of equal parts: its derivatives at x = 1 by powers
/// of x lose what the terms cancel.
Eigen::MatrixXd in_parts(const Eigen::VectorXd& polynomial, int parts) {
    Eigen::MatrixXd local(polynomial.size(), parts);
    for (int i = 0; i < parts; ++i) {
        const long double x = static_cast<long double>(i) / parts;
        Eigen::Matrix<long double, Eigen::Dynamic, 1> own = polynomial.cast<long double>();
        for (Eigen::Index k = 0; k < own.size(); ++k)  // synthetic division by t - x, once for each power
            for (Eigen::Index j = own.size() - 1; j-- > k;) own[j] += x * own[j + 1];
        local.col(i) = own.cast<double>();
    }
    return local;
}

/// The classical polydyne cam: the polynomial of least degree that rests to order 4 at both ends as the
/// output's motion of every stroke. None: the output is not prescribed, or a stroke's ends are not its own.
std::optional<MotionChain> polydyne_motion(const Solution& optimum) {
    if (!optimum.output) return std::nullopt;
    const LawMotion placed = law_in_place(optimum, "polynomial_56789");
    if (!placed.motion) return std::nullopt;
    const Eigen::VectorXd law{{0.0, 0.0, 0.0, 0.0, 0.0, 126.0, -420.0, 540.0, -315.0, 70.0}};
    const DerivativeCombination of = cam_of_output(optimum.scene);
    constexpr int pieces = 8;
    std::vector<double> breakpoints;
    for (int i = 0; i <= pieces; ++i) breakpoints.push_back(static_cast<double>(i) / pieces);
    const Eigen::MatrixXd local = in_parts(law, pieces);
    std::vector<ChainPart> parts = placed.motion->parts();
    for (ChainPart& part : parts) {
        DerivativeCombination own = of;  // of the part's own variable
        own.weights[1] /= part.x_scale;
        own.weights[2] /= part.x_scale * part.x_scale;
        part.y0 *= of.weights[0];
        if (part.shape)
            part.shape = std::make_shared<SplineCurve>(SplineSpace(9, 8, breakpoints), combined(local, own));
    }
    return MotionChain(std::move(parts));
}

}  // namespace

SpeedSweep default_speeds(const Scene& scene) {
    require_train(scene);
    const auto [low, high] = response_speeds(scene);
    return {0.5 * low, 2.0 * high, default_speed_count};
}

Scene without_train(const Scene& scene) {
    Scene rigid = scene;
    rigid.dynamics.value().prescribe = PrescribedMotion::cam;
    for (const PeakLimitRow& row : peak_limit_rows())
        if (row.of_cam) row.in(rigid.limits).reset();
    for (const ResponseTerm& term : response_terms())
        if (term.needs_dynamics()) rigid.objective.*term.weight = 0.0;
    for (const LimitRow& row : limit_rows())
        if (row.needs_dynamics) row.in(rigid.limits).reset();
    return rigid;
}

TrainStudy train_study_of(Solution optimum, std::optional<Solution> static_optimum,
                          const SpeedSweep& speeds) {
    const Scene scene = optimum.scene;
    require_train(scene);
    if (speeds.count < 1 || !(speeds.from > 0.0) || !(speeds.to >= speeds.from))
        throw InputError(
            fmt::format("speeds: found {} from {:.6g} to {:.6g} rpm; allowed: at least 1, speeds > 0 "
                        "that ascend",
                        speeds.count, speeds.from / units::revolution_per_minute,
                        speeds.to / units::revolution_per_minute));
    TrainStudyRun run(scene, speeds);
    if (optimum.motion) run.add("optimum", "optimum", *optimum.motion, true);
    if (static_optimum && static_optimum->motion)
        run.add("static_optimum", "optimum of a rigid follower", *static_optimum->motion, true);
    for (const LawInfo& info : law_catalogue()) {
        if (!info.rests) continue;
        const LawMotion placed = law_in_place(optimum, info.key);
        if (placed.motion)
            run.add(info.key, info.title, *placed.motion, info.key == scene.objective.reference.law);
    }
    if (const std::optional<MotionChain> polydyne = polydyne_motion(optimum))
        run.add("polydyne", "polydyne 5-6-7-8-9 polynomial", *polydyne, true);
    run.add_rows();
    run.add_detuned();
    if (optimum.motion && is_damped(*scene.dynamics) &&
        (scene.motion.type != MotionType::program || scene.motion.closed)) {
        const MotionChain turn = optimum.whole_turn();
        const bool returns = std::abs(turn.at(turn.end(), Side::left).derivative[0] -
                                      turn.at(turn.begin()).derivative[0]) < 1e-9;
        if (returns) run.add_steady(turn);
    }
    TrainStudy study = run.finished();
    study.scene = scene;
    study.optimum = std::move(optimum);
    study.static_optimum = std::move(static_optimum);
    return study;
}

TrainStudy train_study(const Scene& scene, const SpeedSweep& speeds, const SolveControl& control) {
    require_train(scene);
    Solution optimum = solve_asked(scene, control);
    std::optional<Solution> rigid;
    if (asks_train(scene)) rigid = solve_asked(without_train(scene), control);
    return train_study_of(std::move(optimum), std::move(rigid), speeds);
}

}  // namespace camopt
