// SPDX-License-Identifier: MIT
#include "core/numbers/robust_fit.hpp"
#include "input/scene_parts.hpp"
#include "input/table_alignment.hpp"

namespace camopt::input {

namespace {

constexpr std::size_t most_aligned = 4000;  // rows: more do not change an offset

using Shape = std::function<std::array<double, 2>(double t)>;

/// A stretch of the motion: angles in rad, displacements in m or rad. No shape: a dwell, or a free stroke.
struct ReferenceStroke {
    double begin = 0.0, angle = 0.0, from = 0.0, to = 0.0;
    bool free = false;  ///< a spline: with a law of the catalogue, of a fall run from its end
    Shape shape = {};
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

    /// The displacement at an angle from the start, and its slope.
    [[nodiscard]] std::array<double, 2> at(double angle) const {
        if (closed) angle -= units::turn * std::floor(angle / units::turn);
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
    const TableAlignment found = aligned(true);
    if (request.radius) place.zero = {found.alignment[0], found.error[0]};
    if (request.angle) place.angle = {found.alignment[1], found.error[1]};
    for (double& angle : measured.angle) angle -= found.alignment[1];
    for (double& displacement : measured.displacement) displacement -= found.alignment[0];
    return place;
}

}  // namespace camopt::input
