// SPDX-License-Identifier: MIT
// Checks of the delivered motion: peaks, objective, conditions, joints, caps.
#include "tests/soak/relations/relation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt::soak {

namespace {

/// Exact arithmetic of the same numbers; a quintic's jerk loses digits on narrow segments.
constexpr double peak_digits = 1e-8;
constexpr double objective_digits = 1e-8;
/// What a condition may be missed by, relative to the peak of its derivative (docs/stability.md says 1e-9).
constexpr double condition_digits = 1e-8;
constexpr double joint_digits = 1e-6;
constexpr double cap_digits = 1e-7;

Finding beyond(const Miss& miss, double allowed, const Solved& solved) {
    if (miss.amount <= allowed) return holds;
    return fmt::format("{}: off by {:.3g} ({})", miss.what, static_cast<double>(miss.amount),
                       solved.outcome.verdict);
}

/// What deviations of y and its derivatives count by: the peaks, or what the published digits hold where that
/// is more.
std::array<long double, 4> scales_of(const MotionFigures& figures, std::array<long double, 4> peaks) {
    peaks[0] = 1;
    for (std::size_t order = 1; order <= 3; ++order)
        peaks[order] = std::max({peaks[order], 1e-3L, figures.rounding[order] / condition_digits});
    return peaks;
}

std::array<long double, 4> scales_of(const MotionFigures& figures) {
    return scales_of(figures, figures.whole);
}

/// By the larger peaks of the two segments of the motion that meet.
std::array<long double, 4> scales_between(const MotionFigures& figures, const Piece& left,
                                          const Piece& right) {
    std::array<long double, 4> peaks = figures.by_x[static_cast<std::size_t>(left.stretch)];
    const std::array<long double, 4>& others = figures.by_x[static_cast<std::size_t>(right.stretch)];
    for (std::size_t order = 1; order <= 3; ++order) peaks[order] = std::max(peaks[order], others[order]);
    return scales_of(figures, peaks);
}

void check_ends(const Solved& solved, Miss& worst) {
    const SceneNumbers& scene = solved.numbers;
    const auto scale = scales_of(solved.figures);
    const auto begin = solved.motion->pieces.front().at(0);
    const auto end = solved.motion->pieces.back().at(solved.motion->pieces.back().end);
    const bool returns = scene.type == "RR";
    for (std::size_t order = 0; order < 3; ++order) {
        worst.note(std::abs(begin[order]) / scale[order], fmt::format("begin, order {}", order));
        const long double target = order == 0 && !returns ? 1 : 0;
        worst.note(std::abs(end[order] - target) / scale[order], fmt::format("end, order {}", order));
    }
    if (returns) {
        const auto top = solved.motion->at(1);
        worst.note(std::abs(top[0] - 1), "top, order 0");
        worst.note(std::abs(top[1]) / scale[1], "top, order 1");
    }
    if (!scene.end_jerk_zero) return;
    worst.note(std::abs(begin[3]) / scale[3], "begin, jerk");
    worst.note(std::abs(end[3]) / scale[3], "end, jerk");
}

void check_points(const Solved& solved, Miss& worst) {
    const auto scale = scales_of(solved.figures);
    for (const ViaPoint& via : solved.numbers.via) {
        const auto state = solved.motion->at(via.at);
        for (std::size_t order = 0; order < 3; ++order)
            if (via.value[order])
                worst.note(std::abs(state[order] - *via.value[order]) / scale[order],
                           fmt::format("exact point at {}, order {}", via.at, order));
    }
    if (!solved.numbers.symmetric) return;
    const long double length = solved.numbers.length();
    for (int k = 0; k <= 64; ++k) {
        const long double x = length * k / 128;
        const long double left = solved.motion->at(x)[0];
        const long double right = solved.motion->at(length - x)[0];
        worst.note(solved.numbers.type == "DRD" ? std::abs(left + right - 1) : std::abs(left - right),
                   "symmetry");
    }
}

void check_program(const Solved& solved, Miss& worst) {
    const auto& segments = solved.numbers.segments;
    const auto& stretches = solved.motion->stretches;
    if (segments.size() != stretches.size()) {
        worst.note(HUGE_VALL, "number of segments");
        return;
    }
    for (std::size_t k = 0; k < segments.size(); ++k) {
        const Stretch& stretch = stretches[k];
        if (segments[k].to)
            worst.note(std::abs(stretch.to - *segments[k].to), fmt::format("segment {}, to", k));
        if (segments[k].kind == "dwell")
            worst.note(std::abs(stretch.to - stretch.from), fmt::format("segment {}, dwell", k));
        worst.note(std::abs(stretch.from - (k == 0 ? 0 : stretches[k - 1].to)),
                   fmt::format("segment {}, from", k));
    }
    for (const Piece& piece : solved.motion->pieces) {
        const Stretch& stretch = stretches[static_cast<std::size_t>(piece.stretch)];
        if (piece.begin == stretch.begin)
            worst.note(std::abs(piece.at(piece.begin)[0] - stretch.from), "curve, from");
        if (std::abs(piece.end - stretch.end) < 1e-12L)
            worst.note(std::abs(piece.at(piece.end)[0] - stretch.to), "curve, to");
    }
    if (solved.numbers.closed) worst.note(std::abs(stretches.back().to), "the end of a closed program");
}

/// Of a peak: that of the derivative, grown as the peak itself is by the segment's own measure.
long double rounding_of(const Solved& solved, std::size_t order) {
    const long double whole = solved.figures.whole[order];
    const long double growth = whole > 0 ? std::max(1.0L, solved.figures.peak[order] / whole) : 1;
    return growth * solved.figures.rounding[order];
}

/// A figure beside its own value; `rounding`: what the published digits leave open.
struct Figure {
    const char* name;
    double published = 0.0;
    long double own = 0, rounding = 0;
};

Finding differs(const Figure& figure) {
    if (std::abs(figure.published - figure.own) <= peak_digits * std::max(1.0L, figure.own) + figure.rounding)
        return holds;
    return fmt::format("{} {:.15g} published, {:.15g} of the curve", figure.name, figure.published,
                       static_cast<double>(figure.own));
}

/// Of a program: each spline segment by its own measure.
Finding segment_peaks_differ(const Solved& solved) {
    for (std::size_t k = 0; k < solved.outcome.segments.size(); ++k) {
        const PublishedSegment& segment = solved.outcome.segments[k];
        for (std::size_t order = 1; order <= 3 && segment.spline; ++order) {
            const long double own = solved.figures.of_stretch[k][order];
            const long double rounding = rounding_of(solved, order);
            const Finding wrong =
                differs({peak_names[order], segment.peaks.at(peak_names[order]), own, rounding});
            if (!wrong->empty()) return fmt::format("segment {}: {}", k, *wrong);
        }
    }
    return holds;
}

}  // namespace

Finding check_peaks(const Solved& solved) {
    if (!solved.motion) return no_case;
    const auto& published = solved.outcome.peaks;
    const auto& own = solved.figures;
    std::vector<Figure> figures;
    for (std::size_t order = 1; order <= 3; ++order)
        figures.push_back({peak_names[order], published.at(peak_names[order]), own.peak[order],
                           rounding_of(solved, order)});
    if (!solved.numbers.is_program()) {
        const long double product = own.peak[1] * own.rounding[2] + own.peak[2] * own.rounding[1];
        figures.push_back({"torque", published.at("torque"), own.torque, product});
        figures.push_back({"rms_jerk", published.at("rms_jerk"), own.rms[3], own.rounding[3]});
        figures.push_back(
            {"rms_acceleration", published.at("rms_acceleration"), own.rms[2], own.rounding[2]});
    }
    for (const Figure& figure : figures)
        if (const Finding wrong = differs(figure); !wrong->empty()) return wrong;
    return solved.numbers.is_program() ? segment_peaks_differ(solved) : holds;
}

Finding check_objective(const Solved& solved) {
    if (!solved.motion || !solved.outcome.objective) return no_case;
    const auto own = static_cast<double>(objective_of(solved.numbers, solved.figures, solved.dimensions));
    const double reported = *solved.outcome.objective;
    // The terms in proportion: each may be off by what the published digits leave open of its derivative.
    long double open = 0;
    for (std::size_t order = 1; order <= 3; ++order)
        if (solved.figures.peak[order] > 0)
            open = std::max(open, rounding_of(solved, order) / solved.figures.peak[order]);
    const double allowed = objective_digits * std::min(scale_of(own), 1e3 * std::abs(own)) +
                           static_cast<double>(open) * std::abs(own);
    if (std::abs(own - reported) <= allowed) return holds;
    return fmt::format("{:.12g} reported, {:.12g} by its definition ({})", reported, own,
                       solved.outcome.verdict);
}

Miss missed_conditions(const Solved& solved) {
    Miss worst;
    if (solved.numbers.is_program()) {
        check_program(solved, worst);
    } else {
        check_ends(solved, worst);
        check_points(solved, worst);
    }
    return worst;
}

Miss largest_jump(const Solved& solved, int first_order, int last_order) {
    const auto& pieces = solved.motion->pieces;
    Miss worst;
    for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
        const auto scale = scales_between(solved.figures, pieces[k], pieces[k + 1]);
        const auto left = pieces[k].at(pieces[k].end);
        const auto right = pieces[k + 1].at(pieces[k + 1].begin);
        const bool one_spline = pieces[k].stretch == pieces[k + 1].stretch;
        const Stretch& stretch = solved.motion->stretches[static_cast<std::size_t>(pieces[k].stretch)];
        const int smooth = one_spline && stretch.kind == "spline" ? std::min(stretch.continuity, 3) : 2;
        for (int order = first_order; order <= std::min(last_order, smooth); ++order) {
            const auto r = static_cast<std::size_t>(order);
            worst.note(
                std::abs(left[r] - right[r]) / scale[r],
                fmt::format("joint at x = {:.6g}, order {}", static_cast<double>(pieces[k].end), order));
        }
    }
    return worst;
}

Miss passed_caps(const Solved& solved) {
    const SceneNumbers& scene = solved.numbers;
    Miss worst;
    double per = scene.lift;
    for (std::size_t order = 1; order <= 3; ++order) {
        per *= scene.speed / solved.motion->unit_angle;
        if (!scene.caps[order]) continue;
        const Cap& cap = *scene.caps[order];
        const long double own = cap.in_time ? solved.figures.whole[order] * per : solved.figures.peak[order];
        const long double open = rounding_of(solved, order) / std::max(solved.figures.peak[order], 1e-3L);
        worst.note(own / cap.value - 1 - open, fmt::format("{} {:.12g}, limit {:.12g}", peak_names[order],
                                                           static_cast<double>(own), cap.value));
    }
    return worst;
}

Finding check_conditions(const Solved& solved) {
    if (!solved.motion || solved.outcome.verdict == "failed") return no_case;
    return beyond(missed_conditions(solved), condition_digits, solved);
}

Finding check_joints(const Solved& solved) {
    if (!solved.motion || solved.outcome.verdict == "failed") return no_case;
    return beyond(largest_jump(solved, 0, 3), joint_digits, solved);
}

Finding check_caps(const Solved& solved) {
    const auto& caps = solved.numbers.caps;
    if (!solved.motion || solved.outcome.verdict == "failed" ||
        std::ranges::none_of(caps, &std::optional<Cap>::has_value))
        return no_case;
    return beyond(passed_caps(solved), cap_digits, solved);
}

}  // namespace camopt::soak
