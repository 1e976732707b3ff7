// SPDX-License-Identifier: MIT
#include "objectives/response/train_figures.hpp"

namespace camopt {
namespace {

constexpr double no_dwell = 1e-9;  // of x: a shorter dwell is round-off of a full revolution

MotionEvent event_before_dwell(double end, double turn) {
    MotionEvent event;
    event.moving = {{0.0, end}};
    if (turn > end + no_dwell) event.dwell = {{end, turn}};
    return event;
}

/// Segment by segment from the one after a dwell on, cyclically.
std::vector<MotionEvent> program_events(const MotionSpec& motion) {
    const auto& segments = motion.segments;
    const std::size_t count = segments.size();
    const auto dwells = [&](std::size_t i) { return segments[i % count].kind == SegmentKind::dwell; };
    std::vector<double> begins(1, 0.0);
    double angle = 0.0;
    for (const ProgramSegment& segment : segments) {
        angle += segment.angle;
        begins.push_back(angle / motion.unit_angle());
    }
    std::vector<MotionEvent> events;
    for (std::size_t i = 0; i < count; ++i) {
        if (dwells(i)) continue;
        const bool first = i == 0 ? !motion.closed || dwells(count - 1) : dwells(i - 1);
        if (!first) continue;
        MotionEvent event;
        for (std::size_t k = i; k < i + count; ++k) {
            if (k >= count && !motion.closed) break;
            const MotionStretch stretch{begins[k % count], begins[k % count + 1]};
            if (!dwells(k) && !event.dwell.empty()) break;
            (dwells(k) ? event.dwell : event.moving).push_back(stretch);
        }
        events.push_back(std::move(event));
    }
    return events;
}

// Of x: tolerance on pieces that begin and end at the breakpoints of stretches.
constexpr double same_x = 1e-9;
// Samples of the speed: cycles of a mode over the motion between two, and bounds on their number.
constexpr double turns_between_speeds = 1.0 / 16.0;
constexpr int least_speeds = 9, most_speeds = 257;
// Narrows two steps of the speed to 1e-5 of them: the maximum is then accurate to 1e-11.
constexpr int golden_sections = 24;
// Local maxima below this part of the largest are not refined.
constexpr double near_largest = 0.8;

void add_pieces(std::vector<SlopePiece>& found, const std::vector<SlopePiece>& all,
                const std::vector<MotionStretch>& stretches) {
    for (const MotionStretch& stretch : stretches) {
        const std::size_t before = found.size();
        for (const SlopePiece& piece : all)
            if (piece.begin > stretch.begin - same_x && piece.begin + piece.width < stretch.end + same_x)
                found.push_back(piece);
        if (found.size() > before || all.empty()) continue;
        // Beyond the motion it rests at its end.
        const SlopePiece& last = all.back();
        double displacement = last.displacement;
        for (Eigen::Index k = 0; k < last.slope.size(); ++k)
            displacement += last.width * last.slope[k] / static_cast<double>(k + 1);
        found.push_back({stretch.begin, stretch.end - stretch.begin, displacement, Eigen::VectorXd::Zero(1)});
    }
}

}  // namespace

std::vector<MotionEvent> motion_events(const MotionSpec& motion) {
    if (motion.type == MotionType::program) return program_events(motion);
    return {event_before_dwell(motion.length(), units::turn / motion.unit_angle())};
}

MotionEvent single_rise(double unit_angle) {
    return event_before_dwell(1.0, units::turn / unit_angle);
}

EventPieces pieces_of_event(const std::vector<SlopePiece>& all, const MotionEvent& event) {
    EventPieces pieces;
    add_pieces(pieces.moving, all, event.moving);
    add_pieces(pieces.dwell, all, event.dwell);
    return pieces;
}

EventResponse::EventResponse(const TrainAtSpeed& train, const EventPieces& pieces)
    : train_(train), pieces_(pieces) {
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(train.states());
    states_ = train.states_along(pieces.moving, rest, 0.0);
    end_ = states_.back();
    if (!pieces.moving.empty()) end_ -= pieces.moving.back().slope.sum() * train.kick();
    states_.pop_back();
    const std::vector<Eigen::VectorXd> ringing = train.states_along(pieces.dwell, end_, 0.0);
    states_.insert(states_.end(), ringing.begin(), ringing.end() - 1);
}

std::vector<Extremum> EventResponse::maxima(const TrainAtSpeed::Reading& reading, double sign, double floor,
                                            bool with_dwell) const {
    std::vector<Extremum> all;
    const auto add = [&](const std::vector<SlopePiece>& pieces, std::size_t first) {
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const auto own = train_.maxima(reading, sign, states_[first + i], pieces[i], floor);
            all.insert(all.end(), own.begin(), own.end());
        }
    };
    add(pieces_.moving, 0);
    if (with_dwell) add(pieces_.dwell, pieces_.moving.size());
    std::vector<Extremum> local;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool above_left = k == 0 || all[k].value >= all[k - 1].value;
        const bool above_right = k + 1 == all.size() || all[k].value >= all[k + 1].value;
        if (above_left && above_right) local.push_back(all[k]);
    }
    return local;
}

Extremum EventResponse::largest(const TrainAtSpeed::Reading& reading, double sign, bool with_dwell) const {
    Extremum best{-infinity, 0.0, Side::right};
    const auto look = [&](const std::vector<SlopePiece>& pieces, std::size_t first) {
        for (std::size_t i = 0; i < pieces.size(); ++i)
            for (const Extremum& one :
                 train_.maxima(reading, sign, states_[first + i], pieces[i], best.value))
                if (one.value > best.value) best = one;
    };
    look(pieces_.moving, 0);
    if (with_dwell) look(pieces_.dwell, pieces_.moving.size());
    return best;
}

Extremum EventResponse::largest_magnitude(const TrainAtSpeed::Reading& reading, bool with_dwell) const {
    const Extremum above = largest(reading, 1.0, with_dwell), below = largest(reading, -1.0, with_dwell);
    return above.value >= below.value ? above : below;
}

const TrainFormulas& train_of(const Scene& scene) {
    if (!scene.dynamics.value().formulas)
        throw InputError(
            "dynamics: found a follower train without its formulas; allowed: a scene that complete_dynamics "
            "(dynamics/train_formulas.hpp) has completed");
    return *scene.dynamics->formulas;
}

std::unique_ptr<const TrainAtSpeed> train_at(const Scene& scene, double speed) {
    return train_of(scene).at(speed, scene.motion.unit_angle(), scene.motion.lift);
}

std::array<double, 2> response_speeds(const Scene& scene) {
    const double speed = scene.motion.speed.value();
    return scene.dynamics->speed_range.value_or(std::array{speed, speed});
}

std::vector<SpeedMaximum> maxima_over_speeds(const Scene& scene, double length,
                                             const std::function<double(double)>& function) {
    const auto [low, high] = response_speeds(scene);
    if (!(high > low)) return {{low, function(low)}};
    // Cycles of the slowest mode over the motion at either end of the range. Faster modes have more cycles
    // but smaller amplitudes; their samples follow from the same number.
    const double first = train_of(scene).natural_frequencies().front();
    const double turns = first * scene.motion.unit_angle() * length / units::turn * (1.0 / low - 1.0 / high);
    const int count = static_cast<int>(
        std::clamp(std::ceil(turns / turns_between_speeds) + 1.0, double{least_speeds}, double{most_speeds}));
    // Uniform in 1 / speed, to which phases are proportional.
    std::vector<SpeedMaximum> samples;
    for (int k = 0; k < count; ++k) {
        const double part = static_cast<double>(k) / (count - 1);
        const double speed = k == 0           ? low
                             : k + 1 == count ? high
                                              : 1.0 / (1.0 / low + part * (1.0 / high - 1.0 / low));
        samples.push_back({speed, function(speed)});
    }
    const double largest = std::ranges::max(samples, {}, &SpeedMaximum::value).value;
    std::vector<SpeedMaximum> found;
    for (int k = 0; k < count; ++k) {
        const SpeedMaximum& here = samples[k];
        const auto value = [&](int i) { return i < 0 || i >= count ? -infinity : samples[i].value; };
        if (here.value < value(k - 1) || here.value < value(k + 1)) continue;
        if (here.value < largest - (1.0 - near_largest) * std::abs(largest)) continue;
        found.push_back(here);
        const double from = samples[static_cast<std::size_t>(std::max(0, k - 1))].speed;
        const double to = samples[static_cast<std::size_t>(std::min(count - 1, k + 1))].speed;
        const GoldenSection top = golden_maximum(function, from, to, golden_sections);
        if (top.value() > here.value) found.back() = {top.place(), top.value()};
    }
    std::ranges::stable_sort(found, std::greater{}, &SpeedMaximum::value);
    return found;
}

}  // namespace camopt
