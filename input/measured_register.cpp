// SPDX-License-Identifier: MIT
#include "core/numbers/extremum.hpp"
#include "core/numbers/robust_fit.hpp"
#include "input/scene_parts.hpp"
#include "input/table_alignment.hpp"

#include <Eigen/QR>
#include <fmt/format.h>

namespace camopt::input {

namespace {

constexpr std::size_t most_aligned = 4000;  // rows: more do not change an offset

using Shape = std::function<std::array<double, 2>(double t)>;

/// A stretch of the motion: angles in rad, displacements in m or rad. No shape: a dwell, or a free stroke.
struct ReferenceStroke {
    double begin = 0.0, angle = 0.0, from = 0.0, to = 0.0;
    bool free = false;  ///< a spline: with a law of the catalogue, of a fall run from its end
    Shape shape = {};

    /// By angle, at an end; of a free one 0: there two of them turn.
    [[nodiscard]] double slope_at(double t) const {
        return free || !shape ? 0.0 : (to - from) * shape(t)[1] / angle;
    }
};

struct ReferenceMotion {
    bool closed = false;
    std::vector<ReferenceStroke> strokes;
    Shape law;  ///< of free strokes

    ReferenceMotion(const MotionSpec& motion, const KnownNames& known)
        : closed(motion.type == MotionType::rr || (motion.periodic() && !motion.relative)) {
        if (motion.type != MotionType::program) add(motion.rise, motion.lift, true);
        if (motion.type == MotionType::rr) add((motion.length() - 1.0) * motion.rise, 0.0, true);
        for (const ProgramSegment& segment : motion.segments) {
            const bool dwells = segment.kind == SegmentKind::dwell;
            const bool returns = &segment == &motion.segments.back() && motion.closed;
            if (segment.angle_range || (!dwells && !segment.to && !returns))
                throw SceneError({"measured.register", "a program whose angles or displacements are searched",
                                  "with numbers for all of them"});
            const bool turns = std::ranges::any_of(
                known.turning_laws, [&](const std::string& name) { return segment.law.starts_with(name); });
            if (turns || segment.takes_states())
                throw SceneError({"measured.register",
                                  fmt::format("the law \"{}\" in the program", segment.law),
                                  "laws that rest at both ends"});
            const double before = strokes.empty() ? 0.0 : strokes.back().to;
            add(segment.angle, dwells ? before : motion.lift * segment.to.value_or(0.0),
                segment.kind == SegmentKind::spline,
                segment.kind == SegmentKind::law ? known.law_shape(segment.law) : Shape());
        }
    }
    void add(double angle, double to, bool free, Shape shape = {}) {
        const ReferenceStroke before = strokes.empty() ? ReferenceStroke() : strokes.back();
        strokes.push_back({before.begin + before.angle, angle, before.to, to, free, std::move(shape)});
    }

    /// The stroke after, or before, one; null: the motion rests there.
    [[nodiscard]] const ReferenceStroke* neighbour(std::size_t index, bool after) const {
        const std::size_t count = strokes.size();
        if (after ? index + 1 < count : index > 0) return &strokes[after ? index + 1 : index - 1];
        const bool whole = closed && is_whole_turn(strokes.back().begin + strokes.back().angle);
        return whole ? &strokes[after ? 0 : count - 1] : nullptr;
    }
    [[nodiscard]] double wrapped(double angle) const {
        return closed ? angle - units::turn * std::floor(angle / units::turn) : angle;
    }

    /// The displacement at an angle from the start, and its slope.
    [[nodiscard]] std::array<double, 2> at(double angle) const {
        angle = wrapped(angle);
        for (const ReferenceStroke& stroke : strokes) {
            const double t = (angle - stroke.begin) / stroke.angle, height = stroke.to - stroke.from;
            const Shape& shape = stroke.free ? law : stroke.shape;
            if (!(t > 0.0 && t <= 1.0)) continue;
            if (!shape || height == 0.0) return {stroke.to, 0.0};
            const bool reversed = stroke.free && height < 0.0;
            const std::array<double, 2> share = shape(reversed ? 1.0 - t : t);
            return {stroke.from + height * (reversed ? 1.0 - share[0] : share[0]),
                    height * share[1] / stroke.angle};
        }
        return {angle <= 0.0 ? 0.0 : strokes.back().to, 0.0};
    }
};

/// Rows with free strokes as smooth curves: from one end of the stroke to the other with the slopes of its
/// neighbours, and t^p (1 − t)^q times polynomials by least squares; p, q = 3 next to a dwell or a law, whose
/// acceleration it continues, 2 where two free strokes join.
class SmoothStrokes {
 public:
    SmoothStrokes(const ReferenceMotion& reference, const std::vector<AlignedRow>& rows, bool radius,
                  double zero)
        : reference_(reference), rows_(rows), radius_(radius), zero_(zero) {}

    /// Of the weighted residuals with the motion at this angle of the table.
    struct Fit {
        double squares = 0.0, zero = 0.0;
        double count = 0.0;  ///< rows less what was fitted
    };
    [[nodiscard]] Fit at(double offset) const {
        std::vector<Rows> of_stroke(reference_.strokes.size());
        Fit fit{0.0, zero_};
        double sum = 0.0, weights = 0.0;
        std::vector<std::array<double, 2>> given;  // residual and weight beside free strokes
        for (const AlignedRow& row : rows_) {
            if (!(row.weight > 0.0)) continue;
            const double angle = reference_.wrapped(row.given.x() - offset);
            const std::size_t stroke = stroke_at(angle);
            if (stroke < of_stroke.size() && reference_.strokes[stroke].free) {
                of_stroke[stroke].push_back({angle, row.given.y(), row.weight});
                continue;
            }
            given.push_back({row.given.y() - reference_.at(angle)[0], row.weight});
            sum += row.weight * given.back()[0];
            weights += row.weight;
        }
        if (radius_ && weights > 0.0) fit.zero = sum / weights;
        for (const auto& [residual, weight] : given) fit.squares += weight * std::pow(residual - fit.zero, 2);
        fit.count = weights - (radius_ ? 2.0 : 1.0);
        for (std::size_t s = 0; s < of_stroke.size(); ++s) add_stroke(fit, s, of_stroke[s]);
        return fit;
    }

 private:
    struct Row {
        double angle, displacement, weight;
    };
    using Rows = std::vector<Row>;

    [[nodiscard]] std::size_t stroke_at(double angle) const {
        std::size_t found = 0;
        for (const ReferenceStroke& stroke : reference_.strokes) {
            if (angle > stroke.begin && angle <= stroke.begin + stroke.angle) return found;
            ++found;
        }
        return found;
    }

    void add_stroke(Fit& fit, std::size_t index, const Rows& rows) const {
        constexpr Eigen::Index most = 10, rows_of_one = 6;
        const auto count = static_cast<Eigen::Index>(rows.size());
        if (count == 0) return;
        const ReferenceStroke& own = reference_.strokes[index];
        const ReferenceStroke *before = reference_.neighbour(index, false),
                              *after = reference_.neighbour(index, true);
        const std::array<double, 2> slopes = {before ? own.angle * before->slope_at(1.0) : 0.0,
                                              after ? own.angle * after->slope_at(0.0) : 0.0};
        const int p = before && before->free ? 2 : 3, q = after && after->free ? 2 : 3;
        const Eigen::Index terms = std::clamp<Eigen::Index>(count / rows_of_one, 1, most);
        Eigen::MatrixXd shapes(count, terms);
        Eigen::VectorXd residual(count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const Row& row = rows[static_cast<std::size_t>(i)];
            const double t = (row.angle - own.begin) / own.angle, root = std::sqrt(row.weight);
            residual[i] = root * (row.displacement - fit.zero - joined(own, slopes, t));
            double power = root * std::pow(t, p) * std::pow(1.0 - t, q), last = 0.0;
            for (Eigen::Index k = 0; k < terms; ++k) {  // Chebyshev's, well conditioned
                shapes(i, k) = power;
                const double next = (k == 0 ? 1.0 : 2.0) * (2.0 * t - 1.0) * power - last;
                last = std::exchange(power, next);
            }
            fit.count += row.weight;
        }
        const Eigen::VectorXd share = shapes.colPivHouseholderQr().solve(residual);
        fit.squares += (residual - shapes * share).squaredNorm();
        fit.count -= static_cast<double>(terms);
    }

    /// The quintic without acceleration at its ends.
    static double joined(const ReferenceStroke& own, const std::array<double, 2>& slopes, double t) {
        const double rest = t * t * t * (10.0 - t * (15.0 - 6.0 * t)), left = 1.0 - t;
        const double start = t * left * left * left * (1.0 + 3.0 * t),
                     end = -left * t * t * t * (1.0 + 3.0 * left);
        return own.from + (own.to - own.from) * rest + slopes[0] * start + slopes[1] * end;
    }

    const ReferenceMotion& reference_;
    const std::vector<AlignedRow>& rows_;
    bool radius_;
    double zero_;
};

constexpr double smooth_reach = 8.0 * units::degree;  // from where the nearest law places the motion
constexpr int smooth_steps = 64, smooth_sections = 60;

/// The offset of least squares, near one that a law found.
double smooth_offset(const SmoothStrokes& strokes, double near) {
    const double step = smooth_reach / smooth_steps;
    double best = near, least = infinity;
    for (int i = -smooth_steps; i <= smooth_steps; ++i) {
        const double tried = near + i * step, squares = strokes.at(tried).squares;
        if (squares < least) std::tie(best, least) = std::tie(tried, squares);
    }
    return golden_maximum([&](double at) { return -strokes.at(at).squares; }, best - step, best + step,
                          smooth_sections)
        .place();
}

/// Places the motion by smooth strokes; the standard error by the curvature of the sum of squares.
void place_smoothly(const ReferenceMotion& reference, RegisterRequest request, TableAlignment& found,
                    MeasuredPlace& place) {
    constexpr double least_free = 8.0, width = 0.05 * units::degree;
    const SmoothStrokes strokes(reference, found.rows, request.radius, found.alignment[0]);
    const double offset = smooth_offset(strokes, found.alignment[1]);
    const SmoothStrokes::Fit fit = strokes.at(offset);
    if (!(fit.count > least_free)) return;
    const double bend =
        (strokes.at(offset - width).squares - 2.0 * fit.squares + strokes.at(offset + width).squares) /
        (width * width);
    const double variance = fit.squares / fit.count;
    found.alignment[0] = fit.zero;
    found.alignment[1] = offset;
    found.error[1] = bend > 0.0 ? std::sqrt(2.0 * variance / bend) : infinity;
    place.residual = std::sqrt(variance);
    place.law.clear();
}

/// The law that leaves the least deviations from an offset; empty: the scene prescribes all strokes.
std::string nearest_law(const KnownNames& known, bool turns_back, ReferenceMotion& reference,
                        const std::function<TableAlignment(bool)>& aligned) {
    std::string best;
    double least = std::numeric_limits<double>::infinity();
    for (const std::string& law : known.laws) {
        const auto is_in = [&](const auto& list) { return std::ranges::find(list, law) != list.end(); };
        if (is_in(known.moving_laws) || (is_in(known.turning_laws) && !turns_back)) continue;
        reference.law = known.law_shape(law);
        double sum = 0.0;
        for (const AlignedRow& row : aligned(false).rows) sum += std::abs(row.aligned);
        if (sum < least) std::tie(least, best) = std::tie(sum, law);
    }
    if (!best.empty()) reference.law = known.law_shape(best);
    return best;
}

}  // namespace

MeasuredPlace register_rows(const MotionSpec& motion, const KnownNames& known, RegisterRequest request,
                            MeasuredMotion& measured) {
    if (!known.law_shape || known.laws.empty())
        throw SceneError({"measured.register", "a program without laws", "no register"});
    if (measured.angle.empty()) return {};
    ReferenceMotion reference(motion, known);
    const auto [first, last] = std::ranges::minmax(measured.angle);
    if (request.angle && !reference.closed && last - first > 0.75 * units::turn)
        throw SceneError({"measured.register",
                          "a table of a whole revolution where the motion is a part of one",
                          "a motion of the whole revolution, \"RR\" or \"program\""});
    const CompareRow compare = [&](AlignedRow& row, const Eigen::Vector4d& alignment) {
        const std::array<double, 2> nominal = reference.at(row.given.x() - alignment[1]);
        row.angle = row.given.x();
        row.aligned = row.given.y() - nominal[0] - alignment[0];
        row.base = std::max(std::abs(nominal[0]), std::abs(nominal[1])) < resting * motion.lift;
        row.slope = {request.radius ? -1.0 : 0.0, request.angle ? nominal[1] : 0.0, 0.0, 0.0};
    };
    TableAlignment start;
    for (std::size_t i = 0; i < measured.angle.size(); i += 1 + measured.angle.size() / most_aligned)
        start.rows.emplace_back().given = {measured.angle[i], measured.displacement[i]};
    reference.law = known.law_shape(known.laws.front());
    if (request.angle) start.alignment[1] = searched_offset(start.rows, compare);
    std::vector<double> off;
    for (AlignedRow& row : start.rows) {
        compare(row, start.alignment);
        off.push_back(row.aligned);
    }
    if (request.radius) start.alignment[0] = median_of(std::move(off));
    const auto aligned = [&](bool robust) {
        TableAlignment found = start;
        align(found, compare, robust);
        return found;
    };
    MeasuredPlace place;
    if (std::ranges::any_of(reference.strokes, &ReferenceStroke::free))
        place.law = nearest_law(known, motion.type == MotionType::rr, reference, aligned);
    TableAlignment found = aligned(true);
    place.noise = found.noise;
    double squares = 0.0, weights = 0.0;
    for (const AlignedRow& row : found.rows) {
        squares += row.weight * row.aligned * row.aligned;
        weights += row.weight;
    }
    place.residual = std::sqrt(squares / std::max(1.0, weights));
    // A law that describes the table places it best: smooth strokes could move along it.
    if (request.angle && !place.law.empty() && place.contradicted())
        place_smoothly(reference, request, found, place);
    // Residuals far above the noise are the model's: no statement on the errors of its parameters holds.
    if (place.contradicted()) found.error.setConstant(std::numeric_limits<double>::quiet_NaN());
    if (request.radius) place.zero = {found.alignment[0], found.error[0]};
    if (request.angle) place.angle = {found.alignment[1], found.error[1]};
    for (double& angle : measured.angle) angle -= found.alignment[1];
    for (double& displacement : measured.displacement) displacement -= found.alignment[0];
    for (double& at : measured.breaks) at -= found.alignment[1];
    return place;
}

}  // namespace camopt::input
