// SPDX-License-Identifier: MIT
#include "tests/soak/figures/motion.hpp"

#include "tests/soak/figures/law.hpp"

#include <algorithm>
#include <cmath>

namespace camopt::soak {

namespace {

/// Control points on clamped knots of the derivatives of a spline, evaluated by de Boor.
class DeBoor {
 public:
    explicit DeBoor(const PublishedSpline& spline)
        : degree_(spline.degree),
          knots_(spline.knots.begin(), spline.knots.end()),
          control_(spline.coefficients.begin(), spline.coefficients.end()) {}

    /// All derivatives at the left end of the span k, from its inside, as Taylor coefficients.
    [[nodiscard]] Polynomial taylor(int span) const {
        Polynomial polynomial;
        std::vector<long double> control(control_);
        std::vector<long double> knots(knots_);
        long double factorial = 1;
        for (int order = 0; order <= degree_; ++order) {
            const int p = degree_ - order;
            polynomial.push_back(value(knots, control, {p, span - order}) / factorial);
            factorial *= order + 1;
            std::vector<long double> next;
            for (std::size_t j = 0; j + 1 < control.size(); ++j) {
                const long double width = knots[j + static_cast<std::size_t>(p) + 1] - knots[j + 1];
                next.push_back(width > 0 ? p * (control[j + 1] - control[j]) / width : 0);
            }
            control = next;
            knots = std::vector<long double>(knots.begin() + 1, knots.end() - 1);
        }
        return polynomial;
    }

    [[nodiscard]] const std::vector<long double>& knots() const { return knots_; }

 private:
    struct Place {
        int degree, span;
    };
    [[nodiscard]] static long double value(const std::vector<long double>& t,
                                           const std::vector<long double>& c, Place place) {
        const auto [p, k] = place;
        const long double x = t[static_cast<std::size_t>(k)];
        std::vector<long double> d(c.begin() + k - p, c.begin() + k + 1);
        for (int level = 1; level <= p; ++level) {
            for (int j = p; j >= level; --j) {
                const long double left = t[static_cast<std::size_t>(j + k - p)];
                const long double width = t[static_cast<std::size_t>(j + 1 + k - level)] - left;
                const long double alpha = width > 0 ? (x - left) / width : 0;
                const auto here = static_cast<std::size_t>(j);
                d[here] = (1 - alpha) * d[here - 1] + alpha * d[here];
            }
        }
        return d[static_cast<std::size_t>(p)];
    }

    int degree_;
    std::vector<long double> knots_, control_;
};

void add_pieces(Motion& motion, const PublishedSpline& spline, int stretch) {
    motion.exact = true;
    for (std::size_t k = 0; k < spline.pieces.size(); ++k) {
        Piece piece;
        piece.begin = spline.breakpoints[k];
        piece.end = spline.breakpoints[k + 1];
        piece.y = Polynomial(spline.pieces[k].begin(), spline.pieces[k].end());
        piece.stretch = stretch;
        motion.pieces.push_back(piece);
    }
}

void add_spline(Motion& motion, const PublishedSpline& spline, int stretch) {
    if (!spline.pieces.empty()) return add_pieces(motion, spline, stretch);
    const DeBoor curve(spline);
    const auto& knots = curve.knots();
    for (int span = spline.degree; span + spline.degree + 1 < static_cast<int>(knots.size()); ++span) {
        const auto k = static_cast<std::size_t>(span);
        if (knots[k + 1] <= knots[k]) continue;
        Piece piece;
        piece.begin = knots[k];
        piece.end = knots[k + 1];
        piece.y = curve.taylor(span);
        piece.stretch = stretch;
        motion.pieces.push_back(piece);
    }
}

/// A law is cut at its eighths, where the modified sine's pieces meet.
void add_law(Motion& motion, const std::string& law, int stretch) {
    const Stretch& whole = motion.stretches[static_cast<std::size_t>(stretch)];
    for (int eighth = 0; eighth < 8; ++eighth) {
        Piece piece;
        piece.law_begin = whole.begin;
        piece.law_end = whole.end;
        piece.law_from = whole.from;
        piece.law_to = whole.to;
        const long double width = (whole.end - whole.begin) / 8;
        piece.begin = whole.begin + eighth * width;
        piece.end = eighth == 7 ? whole.end : whole.begin + (eighth + 1) * width;
        piece.law = law;
        piece.stretch = stretch;
        motion.pieces.push_back(piece);
    }
}

void add_dwell(Motion& motion, int stretch) {
    const Stretch& whole = motion.stretches[static_cast<std::size_t>(stretch)];
    Piece piece;
    piece.begin = whole.begin;
    piece.end = whole.end;
    piece.y = {whole.from};
    piece.stretch = stretch;
    motion.pieces.push_back(piece);
}

double unit_angle_of(const SceneNumbers& scene) {
    if (!scene.is_program()) return scene.rise;
    for (const Segment& segment : scene.segments)
        if (segment.kind == "spline") return segment.angle;
    return 1.0;
}

/// Whether the scene says the displacement at each joint of a program: with `to`, through a dwell, at the end
/// of a closed one.
std::vector<bool> given_levels(const SceneNumbers& scene) {
    const std::size_t count = scene.segments.size();
    std::vector<bool> given(count + 1, false);
    given.front() = true;
    for (std::size_t k = 0; k < count; ++k)
        given[k + 1] = scene.segments[k].kind == "dwell" ? given[k] : scene.segments[k].to.has_value();
    if (!scene.closed) return given;
    given.back() = true;
    for (std::size_t k = count; k > 0 && scene.segments[k - 1].kind == "dwell"; --k) given[k - 1] = true;
    return given;
}

/// Neighbouring splines are one stroke, but where one rises and the other falls between displacements of the
/// scene, or stands; of a closed program also the last and the first. One that never rests has no strokes.
void join_strokes(Motion& motion, bool closed, const std::vector<bool>& given) {
    std::vector<Stretch>& all = motion.stretches;
    const std::size_t count = all.size();
    const auto begins = [&](std::size_t k) {
        if (k == 0 && !closed) return true;
        const Stretch &own = all[k], &before = all[(k + count - 1) % count];
        if (own.kind != "spline" || before.kind != "spline") return true;
        const long double moved = own.to - own.from, earlier = before.to - before.from;
        return own.free || before.free ||
               (moved * earlier < 0 || std::min(std::abs(moved), std::abs(earlier)) < 1e-9L);
    };
    std::size_t first = 0;
    while (first < count && !begins(first)) ++first;
    for (std::size_t k = 0, size = 0; k < count; k += size) {
        const std::size_t begin = (first + k) % count;
        size = 1;
        while (first < count && k + size < count && !begins((begin + size) % count)) ++size;
        if (size == 1) continue;
        const std::size_t last = (begin + size - 1) % count;
        long double angle = 0;
        for (std::size_t i = 0; i < size; ++i)
            angle += all[(begin + i) % count].end - all[(begin + i) % count].begin;
        const bool known = given[begin] && given[last + 1];
        for (std::size_t i = 0; i < size; ++i) {
            all[(begin + i) % count].stroke_angle = angle;
            all[(begin + i) % count].stroke_rise = known ? std::abs(all[last].to - all[begin].from) : 1.0L;
        }
    }
}

}  // namespace

std::array<long double, 4> Piece::at(long double x) const {
    if (!law.empty()) {
        const long double length = law_end - law_begin;
        const bool at_end = x >= end;
        const auto t = static_cast<double>(std::clamp((x - law_begin) / length, 0.0L, 1.0L));
        const std::array<double, 4> s = law_at(law, t, at_end);
        const long double h = law_to - law_from;
        return {law_from + h * s[0], h * s[1] / length, h * s[2] / (length * length),
                h * s[3] / (length * length * length)};
    }
    std::array<long double, 4> state{};
    Polynomial polynomial = y;
    for (long double& value : state) {
        value = value_at(polynomial, x - begin);
        polynomial = derivative_of(polynomial);
    }
    return state;
}

std::array<long double, 4> Motion::at(long double x) const {
    for (const Piece& piece : pieces)
        if (x < piece.end) return piece.at(x);
    return pieces.back().at(x);
}

Motion delivered_motion(const SceneNumbers& scene, const Outcome& outcome) {
    Motion motion;
    motion.unit_angle = unit_angle_of(scene);
    motion.lift = scene.lift;
    if (outcome.spline) {
        motion.stretches.push_back(
            {"spline", 0, scene.length(), 0, scene.type == "RR" ? 0.0L : 1.0L, outcome.spline->continuity});
        add_spline(motion, *outcome.spline, 0);
        return motion;
    }
    const std::vector<bool> given = given_levels(scene);
    for (const PublishedSegment& segment : outcome.segments) {
        const long double begin = segment.start / motion.unit_angle;
        const auto index = static_cast<int>(motion.stretches.size());
        motion.stretches.push_back({segment.kind, begin, begin + segment.angle / motion.unit_angle,
                                    segment.from, segment.to, segment.spline ? segment.spline->continuity : 0,
                                    !given[index] || !given[index + 1]});
        if (segment.spline)
            add_spline(motion, *segment.spline, index);
        else if (segment.kind == "law")
            add_law(motion, segment.law, index);
        else
            add_dwell(motion, index);
    }
    join_strokes(motion, scene.closed, given);
    return motion;
}

Motion law_motion(const SceneNumbers& scene, const std::string& law) {
    Motion motion;
    motion.unit_angle = unit_angle_of(scene);
    motion.lift = scene.lift;
    const auto add = [&](Stretch stretch, const std::string& own) {
        const auto index = static_cast<int>(motion.stretches.size());
        motion.stretches.push_back(stretch);
        if (stretch.kind == "dwell" || stretch.from == stretch.to)
            add_dwell(motion, index);
        else
            add_law(motion, own, index);
    };
    if (!scene.is_program()) {
        add({"law", 0, 1, 0, 1, 0}, law);
        if (scene.type == "RR") add({"law", 1, scene.length(), 1, 0, 0}, law);
        return motion;
    }
    long double begin = 0;
    long double from = 0;
    for (std::size_t k = 0; k < scene.segments.size(); ++k) {
        const Segment& segment = scene.segments[k];
        const bool last = scene.closed && k + 1 == scene.segments.size();
        const long double to = segment.kind == "dwell" ? from
                               : segment.to            ? *segment.to
                                                       : (last ? 0.0L : from);
        const long double end = begin + segment.angle / motion.unit_angle;
        add({segment.kind == "dwell" ? "dwell" : "law", begin, end, from, to, 0},
            segment.law.empty() ? law : segment.law);
        begin = end;
        from = to;
    }
    return motion;
}

}  // namespace camopt::soak
