// SPDX-License-Identifier: MIT
#include "core/numbers/robust_fit.hpp"
#include "input/scene_parts.hpp"
#include "input/table_alignment.hpp"

namespace camopt::input {

namespace {

constexpr std::size_t most_aligned = 4000;  // rows: more do not change an offset

using Shape = std::function<std::array<double, 2>(double t)>;

/// A stretch of the motion: angles in rad, displacements in m or rad. No shape: a dwell.
struct ReferenceStroke {
    double begin = 0.0, angle = 0.0, from = 0.0, to = 0.0;
    bool free = false;      ///< a spline: with a law of the catalogue
    bool reversed = false;  ///< the law runs from its end
    Shape shape = {};
};

class ReferenceMotion {
 public:
    ReferenceMotion(const MotionSpec& motion, const KnownNames& known)
        : whole_(motion.length() * motion.unit_angle()), scale_(motion.lift) {
        if (motion.type == MotionType::program) {
            add_segments(motion, known);
        } else {
            add(motion.rise, motion.lift, true);
            if (motion.type == MotionType::rr) add(whole_ - motion.rise, 0.0, true);
        }
        closed_ = motion.type == MotionType::rr || (motion.periodic() && !motion.relative);
    }

    [[nodiscard]] bool closed() const { return closed_; }
    [[nodiscard]] bool has_free_strokes() const {
        return std::ranges::any_of(strokes_, &ReferenceStroke::free);
    }
    /// Every free stroke has its top where the motion turns back at once.
    [[nodiscard]] bool turns_back() const {
        const auto rises = [](const ReferenceStroke& stroke) { return stroke.to > stroke.from; };
        for (std::size_t i = 0; i < strokes_.size(); ++i) {
            if (!strokes_[i].free) continue;
            const bool up = rises(strokes_[i]);
            if (up ? i + 1 == strokes_.size() : i == 0) return false;
            const ReferenceStroke& other = strokes_[up ? i + 1 : i - 1];
            if (!other.free || rises(other) == up) return false;
        }
        return true;
    }
    void set_law(const Shape& shape) {
        for (ReferenceStroke& stroke : strokes_)
            if (stroke.free) stroke.shape = shape;
    }

    /// The displacement at an angle from the start, and its slope; a dwell at 0 goes to the row.
    [[nodiscard]] std::array<double, 2> at(double angle, AlignedRow& row) const {
        if (closed_) angle -= units::turn * std::floor(angle / units::turn);
        std::array<double, 2> found = {angle <= 0.0 ? 0.0 : strokes_.back().to, 0.0};
        for (const ReferenceStroke& stroke : strokes_) {
            const double t = (angle - stroke.begin) / stroke.angle;
            if (!(t > 0.0 && t <= 1.0)) continue;
            const std::array<double, 2> share =
                stroke.shape ? stroke.shape(stroke.reversed ? 1.0 - t : t) : std::array<double, 2>{0.0, 0.0};
            const double height = stroke.to - stroke.from;
            found = {stroke.from + height * (stroke.reversed ? 1.0 - share[0] : share[0]),
                     height * share[1] / stroke.angle};
            break;
        }
        row.base = std::max(std::abs(found[0]), std::abs(found[1])) < resting * scale_;
        return found;
    }

 private:
    double whole_, scale_;
    bool closed_ = false;
    std::vector<ReferenceStroke> strokes_;

    void add(double angle, double to, bool free, Shape shape = {}) {
        ReferenceStroke stroke{0.0, angle, 0.0, to, free, false, std::move(shape)};
        if (!strokes_.empty()) {
            stroke.begin = strokes_.back().begin + strokes_.back().angle;
            stroke.from = strokes_.back().to;
        }
        stroke.reversed = free && stroke.to < stroke.from;
        strokes_.push_back(std::move(stroke));
    }
    void add_segments(const MotionSpec& motion, const KnownNames& known) {
        for (std::size_t i = 0; i < motion.segments.size(); ++i) {
            const ProgramSegment& segment = motion.segments[i];
            const double before = strokes_.empty() ? 0.0 : strokes_.back().to;
            const bool last = i + 1 == motion.segments.size();
            if (segment.angle_range ||
                (segment.kind != SegmentKind::dwell && !segment.to && !(last && motion.closed)))
                throw SceneError({"measured.register", "a program whose angles or displacements are searched",
                                  "with numbers for all of them"});
            const bool law = segment.kind == SegmentKind::law;
            add(segment.angle,
                segment.kind == SegmentKind::dwell ? before : motion.lift * segment.to.value_or(0.0),
                segment.kind == SegmentKind::spline, law ? known.law_shape(segment.law) : Shape());
        }
    }
};

class Registration {
 public:
    Registration(ReferenceMotion reference, RegisterRequest request, const MeasuredMotion& measured)
        : reference_(std::move(reference)), request_(request) {
        const std::size_t stride = 1 + measured.angle.size() / most_aligned;
        for (std::size_t i = 0; i < measured.angle.size(); i += stride)
            rows_.emplace_back().given = {measured.angle[i], measured.displacement[i]};
        compare_ = [this](AlignedRow& row, const Eigen::Vector4d& alignment) {
            const std::array<double, 2> nominal = reference_.at(row.given.x() - alignment[1], row);
            row.angle = row.given.x();
            row.aligned = row.given.y() - nominal[0] - alignment[0];
            row.slope = {request_.radius ? -1.0 : 0.0, request_.angle ? nominal[1] : 0.0, 0.0, 0.0};
        };
    }
    Registration(const Registration&) = delete;
    Registration& operator=(const Registration&) = delete;

    /// With the law that leaves the least deviations; empty: there is nothing to choose.
    [[nodiscard]] std::string choose_law(const KnownNames& known) {
        std::string best;
        double least = std::numeric_limits<double>::infinity();
        for (const std::string& law : known.laws) {
            const auto is_in = [&](const auto& list) { return std::ranges::find(list, law) != list.end(); };
            if (!reference_.has_free_strokes() || is_in(known.moving_laws) ||
                (is_in(known.turning_laws) && !reference_.turns_back()))
                continue;
            reference_.set_law(known.law_shape(law));
            if (best.empty()) search();
            const TableAlignment found = aligned(false);
            double sum = 0.0;
            for (const AlignedRow& row : found.rows) sum += std::abs(row.aligned);
            if (sum < least) std::tie(least, best) = std::tie(sum, law);
        }
        if (best.empty()) search();
        if (!best.empty()) reference_.set_law(known.law_shape(best));
        return best;
    }

    [[nodiscard]] TableAlignment aligned(bool robust) const {
        TableAlignment found;
        found.rows = rows_;
        found.alignment = start_;
        align(found, compare_, robust);
        return found;
    }

 private:
    ReferenceMotion reference_;
    RegisterRequest request_;
    std::vector<AlignedRow> rows_;
    CompareRow compare_;
    Eigen::Vector4d start_ = Eigen::Vector4d::Zero();

    void search() {
        if (request_.angle) start_[1] = searched_offset(rows_, compare_);
        std::vector<double> off;
        for (AlignedRow& row : rows_) {
            compare_(row, start_);
            off.push_back(row.aligned);
        }
        if (request_.radius) start_[0] = median_of(std::move(off));
    }
};

}  // namespace

MeasuredPlace register_rows(const MotionSpec& motion, const KnownNames& known, RegisterRequest request,
                            MeasuredMotion& measured) {
    const auto refuse = [](const char* found, const char* allowed) {
        throw SceneError({"measured.register", found, allowed});
    };
    if (!known.law_shape) refuse("in a program that knows no laws", "without register");
    if (measured.angle.empty()) return {};
    const ReferenceMotion reference(motion, known);
    const auto [first, last] = std::ranges::minmax(measured.angle);
    if (request.angle && !reference.closed() && last - first > 0.75 * units::turn)
        refuse("a table of a whole revolution where the motion is a part of one",
               "a motion of the whole revolution, \"RR\" or \"program\"");
    Registration registration(reference, request, measured);
    MeasuredPlace place;
    place.law = registration.choose_law(known);
    const TableAlignment found = registration.aligned(true);
    if (request.radius) place.zero = {found.alignment[0], found.error[0]};
    if (request.angle) place.angle = {found.alignment[1], found.error[1]};
    for (double& angle : measured.angle) angle -= found.alignment[1];
    for (double& displacement : measured.displacement) displacement -= found.alignment[0];
    return place;
}

}  // namespace camopt::input
