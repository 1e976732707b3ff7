// SPDX-License-Identifier: MIT
#include "shop/nc/cutter_compensation.hpp"

#include "core/errors.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

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
            refuse(*next.move, "an inner corner next to an arc under G41 or G42 is not supported");
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

constexpr double least_way = 2e-6;   // m: below, printed digits decide
constexpr double least_sine = 0.05;  // the way must pass the flank, not lead to it
constexpr double small_step = 1e-3;  // of a block: for the tip's direction in its middle

/// (w × m) · v of unit vectors; 0 where there is no direction.
double sense_of(const Machine& machine, FinishedCam& cam, const Eigen::VectorXd& from, const NcMove& move,
                SpindleSense spindle) {
    const ToolPose middle = machine.pose(values_along(from, move, 0.5));
    const Eigen::Vector3d before = machine.pose(values_along(from, move, 0.5 - small_step)).tip;
    const Eigen::Vector3d after = machine.pose(values_along(from, move, 0.5 + small_step)).tip;
    const Eigen::Vector3d way = after - before;
    if (way.norm() < 2.0 * small_step * least_way) return 0.0;
    const Eigen::Vector3d turn =
        spindle == SpindleSense::clockwise ? middle.axis : Eigen::Vector3d(-middle.axis);
    return turn.cross(cam.towards_flank(middle)).dot(way.normalized());
}

constexpr double no_turn = 1e-12;  // rad: an arc that ends where it begins is a whole circle

struct RoundWay {
    double begin_angle, sweep;  // rad, signed
    double begin_radius, end_radius;
};

RoundWay round_way(const Eigen::VectorXd& from, const NcMove& move) {
    const Eigen::Vector2d begin = from.head<2>() - move.arc->center;
    const Eigen::Vector2d end = move.values.head<2>() - move.arc->center;
    const double begin_angle = std::atan2(begin.y(), begin.x());
    double sweep = std::atan2(end.y(), end.x()) - begin_angle;
    const double turn = 2.0 * std::numbers::pi, sense = move.arc->clockwise ? -1.0 : 1.0;
    while (sense * sweep <= no_turn) sweep += sense * turn;
    while (sense * sweep > turn + no_turn) sweep -= sense * turn;
    return {begin_angle, sweep, begin.norm(), end.norm()};
}

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

DirectionCheck check_direction(std::span<const NcMove> moves, const Machine& machine, FinishedCam& cam,
                               SpindleSense spindle, const CutterInBlank& cutter,
                               std::span<const FlankBlocks> blocks) {
    DirectionCheck check;
    std::size_t place = 0;
    for (std::size_t i = 1; i < moves.size() && place < blocks.size(); ++i) {
        while (place < blocks.size() && moves[i].line > blocks[place].last_line) ++place;
        if (place == blocks.size() || moves[i].line < blocks[place].first_line || moves[i].rapid) continue;
        if (distance_to_blank(cutter.blank, machine.pose(moves[i].values), cutter.radius) > 0.0) continue;
        const double sense = sense_of(machine, cam, moves[i - 1].values, moves[i], spindle);
        if (!(std::abs(sense) > least_sine)) continue;
        const bool climbs = sense < 0.0;
        ++(climbs ? check.climb : check.conventional);
        if (climbs != blocks[place].climbs && check.fault.empty())
            check.fault = fmt::format("line {}: the block is {}, not {}", moves[i].line,
                                      climbs ? "climb" : "conventional", climbs ? "conventional" : "climb");
    }
    return check;
}

Eigen::VectorXd values_along(const Eigen::VectorXd& from, const NcMove& move, double share) {
    Eigen::VectorXd values = from + share * (move.values - from);
    if (!move.arc) return values;
    const RoundWay way = round_way(from, move);
    const double angle = way.begin_angle + share * way.sweep;
    const double radius = way.begin_radius + share * (way.end_radius - way.begin_radius);
    values.head<2>() = move.arc->center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    return values;
}

double linear_length(const Eigen::VectorXd& from, const NcMove& move) {
    const Eigen::VectorXd way = move.values - from;
    if (!move.arc) return way.head<3>().norm();
    const RoundWay round = round_way(from, move);
    const double around = std::max(round.begin_radius, round.end_radius) * std::abs(round.sweep);
    return std::hypot(around + std::abs(round.end_radius - round.begin_radius), way(2));
}

}  // namespace camopt
