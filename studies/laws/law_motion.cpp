// SPDX-License-Identifier: MIT
#include "studies/laws/law_motion.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "scene/motion/set_points.hpp"
#include "scene/part_names.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// A jump of y'' below this part of the motion's largest is rounding, of an optimized spline beside a law too;
// not an impulse.
constexpr double smallest_jump = 1e-7;
// In lifts: a stroke that the optimizer has chosen to be shorter stands still.
constexpr double smallest_rise = 1e-7;

double width_of(const LawStroke& stroke) {
    return stroke.end - stroke.begin;
}

double rise_of(const LawStroke& stroke) {
    return *stroke.to - *stroke.from;
}

/// Whether two neighbouring strokes of the law turn from one into the other without a rest.
bool turns(const LawStroke& before, const LawStroke& after) {
    const bool both_move = std::min(std::abs(rise_of(before)), std::abs(rise_of(after))) > smallest_rise;
    return both_move && before.kind == SegmentKind::spline && after.kind == SegmentKind::spline &&
           rise_of(before) * rise_of(after) < 0.0;
}

std::string free_displacement(std::span<const LawStroke> strokes) {
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        if (strokes[i].from && strokes[i].to) continue;
        return fmt::format(
            "the scene leaves a displacement of {} free, and there is no optimum to take it from",
            segment_words(i));
    }
    return {};
}

bool moves_on(const LawStroke& stroke) {
    return stroke.kind == SegmentKind::spline &&
           std::ranges::any_of(stroke.ends, [](const JointState& end) { return end.velocity != 0.0; });
}

/// A law from rest to rest does not take the velocity of what it joins. Where the whole motion begins or ends
/// in motion it misses a condition, which is judged as one.
std::string moving_joint(std::span<const LawStroke> strokes, bool closed) {
    const auto joins_in_motion = [&](std::size_t i) {
        const bool begins = (i > 0 || closed) && strokes[i].ends[0].velocity != 0.0;
        const bool ends = (i + 1 < strokes.size() || closed) && strokes[i].ends[1].velocity != 0.0;
        return strokes[i].kind == SegmentKind::spline && (begins || ends);
    };
    std::size_t joined = 0;
    while (joined < strokes.size() && !joins_in_motion(joined)) ++joined;
    if (joined == strokes.size()) return {};
    for (std::size_t i = 0; i < strokes.size(); ++i)
        if (strokes[i].kind == SegmentKind::law && !strokes[i].law->info().rests)
            return fmt::format("rests at its ends, where {} moves on", segment_words(i));
    return fmt::format("rests at its ends, where {} begins or ends in motion", segment_words(joined));
}

/// The law on a stroke; null: the polynomial, where the stroke does not rise or a velocity is free.
std::shared_ptr<const Law> placed_law(const LawStroke& stroke, const std::shared_ptr<const Law>& law,
                                      bool takes_states) {
    if (stroke.kind != SegmentKind::spline) return stroke.law;
    if (!takes_states) return law;
    const double rise = rise_of(stroke);
    const bool known = stroke.ends[0].velocity && stroke.ends[1].velocity;
    if (std::abs(rise) <= smallest_rise || !known) return nullptr;
    return polynomial_between(stroke.ends, rise, width_of(stroke));
}

/// Turns every stroke so that the law's top lies where the motion turns; says why where it cannot.
std::string turn_strokes(std::vector<LawStroke>& strokes, bool closed) {
    const std::size_t count = strokes.size();
    for (std::size_t i = 0; i < count; ++i) {
        LawStroke& stroke = strokes[i];
        if (stroke.kind != SegmentKind::spline) continue;
        const bool at_begin = (i > 0 || closed) && turns(strokes[(i + count - 1) % count], stroke);
        const bool at_end = (i + 1 < count || closed) && turns(stroke, strokes[(i + 1) % count]);
        if (at_begin && at_end) return "turns back at its top and needs a dwell at its foot";
        if (!at_begin && !at_end) return "turns back at its top, where this motion dwells";
        stroke.mirrored = at_begin;
    }
    return {};
}

MotionChain chain_of(std::span<const LawStroke> strokes,
                     const std::vector<std::shared_ptr<const Law>>& laws) {
    std::vector<ChainPart> parts;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const LawStroke& stroke = strokes[i];
        ChainPart part{stroke.begin, stroke.end, laws[i], stroke.begin, width_of(stroke), *stroke.from, 0.0};
        if (laws[i]) part.y_scale = rise_of(stroke);
        if (laws[i] && stroke.mirrored)
            part = {stroke.begin,      stroke.end, laws[i],         stroke.end,
                    -width_of(stroke), *stroke.to, -rise_of(stroke)};
        parts.push_back(std::move(part));
    }
    return MotionChain(std::move(parts));
}

/// x of a place of the law on its stroke.
double placed_at(const LawStroke& stroke, double own) {
    return stroke.mirrored ? stroke.end - width_of(stroke) * own : stroke.begin + width_of(stroke) * own;
}

/// Peaks of a law from inside, placed on its stroke.
Peaks stretched(const Law& law, const LawStroke& stroke) {
    Peaks peaks = scaled_peaks(find_peaks_without_impulses(law), std::abs(rise_of(stroke)), width_of(stroke));
    for (const auto member : {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk, &Peaks::torque}) {
        Extremum& peak = peaks.*member;
        peak.at = placed_at(stroke, peak.at);
        if (stroke.mirrored) peak.side = peak.side == Side::left ? Side::right : Side::left;
    }
    return peaks;
}

/// y'' beyond one end of a stroke: of its neighbour, at rest 0.
double acceleration_beyond(const MotionChain& motion, double x, bool closed, Side side) {
    const double edge = side == Side::left ? motion.begin() : motion.end();
    if (x != edge) return motion.at(x, side).derivative[2];
    if (!closed) return 0.0;
    return motion.at(side == Side::left ? motion.end() : motion.begin(), side).derivative[2];
}

/// The first place of a stroke, its ends included, where y'' jumps by more than `least`.
std::optional<double> impulse_of(const LawStroke& stroke, const Law& law, const MotionChain& motion,
                                 bool closed, double least) {
    const auto jump = [&](double left, double right) { return std::abs(left - right) > least; };
    const auto inside = [&](double x, Side side) { return motion.at(x, side).derivative[2]; };
    if (jump(acceleration_beyond(motion, stroke.begin, closed, Side::left),
             inside(stroke.begin, Side::right)))
        return stroke.begin;
    std::vector<double> points = law.breakpoints();
    if (stroke.mirrored) std::ranges::reverse(points);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const double x = placed_at(stroke, points[i]);
        if (jump(inside(x, Side::left), inside(x, Side::right))) return x;
    }
    if (jump(inside(stroke.end, Side::left), acceleration_beyond(motion, stroke.end, closed, Side::right)))
        return stroke.end;
    return {};
}

/// By x.
std::array<JointState, 2> ends_of(const MotionSpec& motion, std::size_t segment) {
    const double unit = motion.unit_angle();
    std::array<JointState, 2> ends = joint_states(motion, segment);
    for (JointState& end : ends) {
        if (end.velocity) *end.velocity *= unit;
        if (end.acceleration) *end.acceleration *= unit * unit;
    }
    return ends;
}

void add_peaks(LawMotion& result, std::span<const LawStroke> strokes,
               const std::vector<std::shared_ptr<const Law>>& laws, bool closed) {
    JoinedMeans means;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        if (!laws[i]) continue;
        const LawStroke& stroke = strokes[i];
        const Peaks peaks = law_peaks(stroke, *laws[i], *result.motion, closed);
        raise_peaks(result.motion_peaks, peaks);
        if (stroke.kind != SegmentKind::spline) continue;
        const Peaks own = normalised_peaks(peaks, stroke.scale);
        raise_peaks(result.peaks, own);
        means.add(own, width_of(stroke));
    }
    means.set(result.peaks);
}

}  // namespace

std::vector<LawStroke> strokes_of(const MotionSpec& motion) {
    std::vector<LawStroke> strokes(1);
    strokes[0].from = 0.0;
    strokes[0].to = 1.0;
    const auto given = [](const std::optional<SetPoint>& point) {
        return point ? JointState{point->velocity.value_or(0.0), point->acceleration.value_or(0.0)}
                     : JointState{};
    };
    if (motion.type != MotionType::rr) {
        strokes[0].ends = {given(motion.start), given(motion.end)};
        return strokes;
    }
    strokes[0].ends[0] = given(motion.start);
    LawStroke back = strokes[0];
    back.begin = 1.0;
    back.end = motion.length();
    std::swap(back.from, back.to);
    back.mirrored = true;
    back.ends = {JointState{}, given(motion.end)};
    strokes.push_back(back);
    return strokes;
}

bool any_moves_on(std::span<const LawStroke> strokes) {
    return std::ranges::any_of(strokes, moves_on);
}

std::vector<LawStroke> strokes_of(const Scene& scene, const CamModel& model, const Motion* optimum) {
    if (scene.motion.type != MotionType::program) return strokes_of(scene.motion);
    std::vector<LawStroke> strokes;
    for (std::size_t i = 0; i < scene.motion.segments.size(); ++i) {
        const ProgramSegment& written = scene.motion.segments[i];
        const MotionFamily::Stretch& stretch = model.design.stretches()[i];
        LawStroke stroke{written.kind,
                         written.kind == SegmentKind::law ? segment_law(scene.motion, i) : nullptr,
                         stretch.begin,
                         stretch.end,
                         known_displacement(stretch.from),
                         known_displacement(stretch.to),
                         model.stretch_scale(static_cast<int>(i)),
                         false};
        if (scene.motion.prescribed() && stroke.kind == SegmentKind::law) stroke.kind = SegmentKind::spline;
        if (stroke.kind == SegmentKind::spline && !scene.motion.prescribed())
            stroke.ends = ends_of(scene.motion, i);
        if (!stroke.from && optimum) stroke.from = optimum->at(stroke.begin, Side::right).derivative[0];
        if (!stroke.to && optimum) stroke.to = optimum->at(stroke.end, Side::left).derivative[0];
        strokes.push_back(std::move(stroke));
    }
    return strokes;
}

LawMotion law_motion(std::span<const LawStroke> strokes, bool closed, const std::shared_ptr<const Law>& law) {
    LawMotion result;
    result.misfit = free_displacement(strokes);
    if (!result.misfit.empty()) return result;
    const bool takes_states = law->key() == "polynomial";
    if (!takes_states) result.misfit = moving_joint(strokes, closed);
    if (!result.misfit.empty()) return result;
    std::vector<LawStroke> placed(strokes.begin(), strokes.end());
    if (law->info().top == TopEnd::turning_point) result.misfit = turn_strokes(placed, closed);
    if (!result.misfit.empty()) return result;
    std::vector<std::shared_ptr<const Law>> laws;
    for (const LawStroke& stroke : placed) {
        laws.push_back(placed_law(stroke, law, takes_states));
        if (laws.back() || stroke.kind != SegmentKind::spline) continue;
        result.misfit =
            fmt::format("rises between known states, which {} does not have", segment_words(laws.size() - 1));
        return result;
    }
    result.motion = std::make_shared<MotionChain>(chain_of(placed, laws));
    add_peaks(result, placed, laws, closed);
    return result;
}

Peaks law_peaks(const LawStroke& stroke, const Law& law, const MotionChain& motion, bool closed) {
    Peaks peaks = stretched(law, stroke);
    double least = peaks.acceleration.value;
    // The laws of other strokes have their peaks neither at breakpoints nor in the middle.
    const std::vector<double> points = motion.breakpoints();
    for (std::size_t i = 1; i < points.size(); ++i)
        least = std::max(least, std::abs(motion.at(std::lerp(points[i - 1], points[i], 0.3)).derivative[2]));
    if (const auto x = impulse_of(stroke, law, motion, closed, smallest_jump * least)) {
        peaks.jerk = {infinity, *x, Side::right};
        derivative_mean(peaks, 3) = infinity;
    }
    return peaks;
}

Peaks scaled_peaks(Peaks peaks, double size, double width) {
    for (const PeakFigure& figure : peak_figures) {
        const double sizes = figure.size_power == 2 ? size * size : size;
        figure.in(peaks) *= sizes / std::pow(width, figure.width_power);
    }
    return peaks;
}

Peaks normalised_peaks(const Peaks& peaks, const StretchScale& scale) {
    return scaled_peaks(peaks, 1.0 / scale.displacement, 1.0 / scale.angle);
}

void raise_peaks(Peaks& peaks, const Peaks& other) {
    for (const PeakFigure& figure : peak_figures)
        if (figure.extremum != nullptr) raise_to(peaks.*figure.extremum, other.*figure.extremum);
}

void JoinedMeans::add(const Peaks& part, double width) {
    for (int order = 1; order <= 3; ++order) {
        const double mean = derivative_mean(part, order);
        squares_[static_cast<std::size_t>(order) - 1] += width * mean * mean;
    }
    width_ += width;
}

void JoinedMeans::set(Peaks& whole) const {
    for (int order = 1; order <= 3; ++order)
        derivative_mean(whole, order) = std::sqrt(squares_[static_cast<std::size_t>(order) - 1] / width_);
}

}  // namespace camopt
