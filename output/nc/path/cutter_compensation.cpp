// SPDX-License-Identifier: MIT
#include "output/nc/path/cutter_compensation.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace camopt {

namespace {

constexpr double straight_on = 1e-9;  // rad: no corner
// An arc and its neighbour meet tangentially but for printed digits: then where the offsets meet is known to
// radius · turn² / 8.
constexpr double tangential = 0.05;

Eigen::Vector2d left_of(const Eigen::Vector2d& direction) {
    return {-direction.y(), direction.x()};
}

struct Element {
    const NcMove* move;
    Eigen::Vector2d begin, end;                      // programmed
    Eigen::Vector2d begin_direction, end_direction;  // of travel
};

class Compensation {
 public:
    Compensation(double radius, std::vector<NcMove>& result) : radius_(radius), result_(result) {}

    void begin(const Eigen::VectorXd& from, CompensationSide side) {
        from_ = from;
        side_ = static_cast<int>(side);
        elements_.clear();
    }
    void add(const NcMove& move) {
        const Eigen::Vector2d begin =
            elements_.empty() ? Eigen::Vector2d(from_.head<2>()) : elements_.back().end;
        const Eigen::Vector2d end = move.values.head<2>();
        if (move.values(2) != from_(2)) refuse(move, "Z moves under G41 or G42");
        if (begin == end && !move.arc) return;
        Element element{&move, begin, end, (end - begin).normalized(), (end - begin).normalized()};
        if (move.arc) {
            if (elements_.empty()) refuse(move, "G41 and G42 must begin with a line");
            const double sense = move.arc->clockwise ? -1.0 : 1.0;
            element.begin_direction = sense * left_of((begin - move.arc->center).normalized());
            element.end_direction = sense * left_of((end - move.arc->center).normalized());
            if (sense * side_ > 0.0 && (begin - move.arc->center).norm() <= radius_)
                refuse(move, "the cutter does not fit into the arc under G41 or G42");
        }
        elements_.push_back(element);
    }
    void finish() {
        Eigen::Vector2d place = from_.head<2>();
        for (std::size_t i = 0; i < elements_.size(); ++i) {
            const Element& element = elements_[i];
            const bool last = i + 1 == elements_.size();
            const Eigen::Vector2d end =
                last ? beside(element.end, element.end_direction) : end_before(element, elements_[i + 1]);
            if (i > 0 && !element.move->arc && (end - place).dot(element.end_direction) <= 0.0)
                refuse(*element.move, "the cutter does not fit between the blocks under G41 or G42");
            push(*element.move, end, element.move->arc);
            place = end;
            if (last || turn_between(element, elements_[i + 1]) * side_ >= -straight_on) continue;
            const Element& next = elements_[i + 1];
            place = beside(next.begin, next.begin_direction);
            push(*next.move, place, MoveArc{next.begin, side_ > 0});
        }
    }

 private:
    [[noreturn]] static void refuse(const NcMove& move, const char* what) {
        throw InputError(fmt::format("G-code, line {}: {}", move.line, what));
    }
    [[nodiscard]] Eigen::Vector2d beside(const Eigen::Vector2d& point,
                                         const Eigen::Vector2d& direction) const {
        return point + side_ * radius_ * left_of(direction);
    }
    [[nodiscard]] static double turn_between(const Element& one, const Element& next) {
        const Eigen::Vector2d &a = one.end_direction, &b = next.begin_direction;
        return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    /// Of the offset: at an inner corner where the two offsets meet.
    [[nodiscard]] Eigen::Vector2d end_before(const Element& one, const Element& next) const {
        const double turn = turn_between(one, next);
        if (turn * side_ <= straight_on) return beside(one.end, one.end_direction);
        if ((one.move->arc || next.move->arc) && turn * side_ > tangential)
            refuse(*next.move, "an inner corner beside an arc under G41 or G42 is not understood");
        const Eigen::Vector2d middle = (one.end_direction + next.begin_direction).normalized();
        return one.end + side_ * radius_ / std::cos(0.5 * turn) * left_of(middle);
    }
    void push(const NcMove& programmed, const Eigen::Vector2d& end, const std::optional<MoveArc>& arc) {
        NcMove move = programmed;
        move.values.head<2>() = end;
        move.arc = arc;
        result_.push_back(std::move(move));
    }

    double radius_;
    std::vector<NcMove>& result_;
    Eigen::VectorXd from_;
    int side_ = 0;
    std::vector<Element> elements_;
};

}  // namespace

std::vector<NcMove> compensated(std::span<const NcMove> moves, double radius) {
    std::vector<NcMove> result;
    Compensation compensation(radius, result);
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const CompensationSide side = moves[i].compensation;
        if (side == CompensationSide::none) {
            if (moves[i].arc && i > 0 && moves[i - 1].compensation != CompensationSide::none)
                throw InputError(fmt::format("G-code, line {}: G40 must end with a line", moves[i].line));
            result.push_back(moves[i]);
            continue;
        }
        if (i == 0) throw InputError("G-code: G41 or G42 before the first move");
        compensation.begin(moves[i - 1].values, side);
        for (; i < moves.size() && moves[i].compensation == side; ++i) compensation.add(moves[i]);
        compensation.finish();
        --i;
    }
    return result;
}

}  // namespace camopt
