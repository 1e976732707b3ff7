// SPDX-License-Identifier: MIT
#include "studies/check/forward_check.hpp"

#include "core/deadline.hpp"
#include "core/errors.hpp"
#include "studies/check/point_curve.hpp"
#include "studies/check/touching_follower.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr int most_between = 64;   // places looked at between two points, however small the roller
constexpr int section_steps = 34;  // golden sections: to 1e-7 of a distance, of whose square the lift depends
constexpr int root_bisections = 60;  // down to neighbouring numbers
constexpr int search_whole = 16;     // every so many angles the whole curve is searched without need
constexpr double suspicious = 1e-6;  // relative: a deviation that has the whole curve searched

/// The cam in the fixed frame at one cam angle: turned, or moved along.
struct Turn {
    double cosine = 1.0, sine = 0.0;
    Vector2d shift = {0.0, 0.0};
    Turn(const ForwardCheckInput& input, double theta) {
        if (input.follower.slide) {
            shift = theta * *input.follower.slide;
            return;
        }
        cosine = std::cos(theta);
        sine = sense_of(input.rotation) * std::sin(theta);
    }
    [[nodiscard]] Vector2d operator()(const Vector2d& point) const {
        return {cosine * point.x() - sine * point.y() + shift.x(),
                sine * point.x() + cosine * point.y() + shift.y()};
    }
};

/// Where the follower stands: its lift, and whether the contact is the end of an open cam.
struct Contact {
    double lift = -infinity;
    bool at_end = false;
};

class Simulation {
 public:
    explicit Simulation(const ForwardCheckInput& input)
        : input_(input), curve_(input.points, input.breaks, input.closed), follower_(input.follower) {
        const std::vector<double>& nodes = curve_.nodes();
        double widest = 0.0;
        for (std::size_t i = 1; i < nodes.size(); ++i) widest = std::max(widest, nodes[i] - nodes[i - 1]);
        const int between =
            std::clamp(static_cast<int>(std::ceil(widest / follower_.widest_gap())), 1, most_between);
        for (std::size_t i = 1; i < nodes.size(); ++i)
            for (int k = 0; k < between; ++k)
                add_place(nodes[i - 1] + (nodes[i] - nodes[i - 1]) * k / between);
        if (!curve_.closed()) add_place(curve_.length());
    }

    [[nodiscard]] ForwardCheckResult run() {
        ForwardCheckResult result;
        result.points = static_cast<int>(input_.points.size());
        for (int i = 0; i < input_.angles; ++i) {
            const double theta = input_.begin + (input_.end - input_.begin) * (i + 0.5) / input_.angles;
            const Contact contact = contact_at(theta, i % search_whole == 0);
            if (input_.keep_found) result.found.push_back(std::nan(""));
            if (contact.at_end) {
                ++result.beyond;
                continue;
            }
            if (input_.keep_found) result.found.back() = output_of(contact);
            ++result.angles;
            const double deviation = deviation_of(contact, theta);
            if (deviation > result.deviation) {
                result.deviation = deviation;
                result.theta = theta;
            }
        }
        if (result.angles == 0) result.deviation = infinity;
        result.relative = relative(result.deviation);
        return result;
    }

 private:
    void add_place(double parameter) {
        parameters_.push_back(parameter);
        places_.push_back(curve_.at(parameter));
    }
    /// How high the follower is held by a point; inside a groove how low: what is searched for is the
    /// largest.
    [[nodiscard]] double held_by(const Vector2d& point) const {
        return input_.follower.from_inside ? -follower_.lift_under(point) : follower_.lift_on(point);
    }
    /// s of the output at a contact.
    [[nodiscard]] double output_of(const Contact& contact) const {
        const double position = input_.follower.from_inside ? -contact.lift : contact.lift;
        const double lift = position - follower_.start();
        return input_.output ? input_.output(lift) : lift;
    }
    [[nodiscard]] double deviation_of(const Contact& contact, double theta) const {
        const double found = std::abs(output_of(contact) - input_.designed(theta));
        if (found < infinity) return found;
        return infinity;  // NaN is no contact either
    }
    [[nodiscard]] double relative(double deviation) const { return deviation / input_.output_size; }
    [[nodiscard]] Contact contact_at(double theta, bool whole) {
        const Turn turn(input_, theta);
        if (input_.follower.contact == ContactKind::edge) return crossing(turn);
        if (!whole) {
            climb(turn);
            const Contact contact = refined(turn);
            if (relative(deviation_of(contact, theta)) < suspicious && !cuts_anywhere(turn, contact.lift))
                return contact;
        }
        search(turn);
        return refined(turn);
    }

    [[nodiscard]] double lift_at(const Turn& turn, double parameter) const {
        return held_by(turn(curve_.at(parameter)));
    }
    [[nodiscard]] std::size_t next(std::size_t index) const {
        return index + 1 < places_.size() ? index + 1 : curve_.closed() ? 0 : index;
    }
    [[nodiscard]] std::size_t previous(std::size_t index) const {
        return index > 0 ? index - 1 : curve_.closed() ? places_.size() - 1 : index;
    }

    /// From the place of the angle before to the highest one around.
    void climb(const Turn& turn) {
        double best = held_by(turn(places_[highest_]));
        for (std::size_t steps = 0; steps < places_.size(); ++steps) {
            std::size_t better = highest_;
            for (const std::size_t neighbour : {next(highest_), previous(highest_)}) {
                const double lift = held_by(turn(places_[neighbour]));
                if (lift > best) {
                    best = lift;
                    better = neighbour;
                }
            }
            if (better == highest_) return;
            highest_ = better;
        }
    }
    void search(const Turn& turn) {
        double best = -infinity;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const double lift = held_by(turn(places_[i]));
            if (lift > best) {
                best = lift;
                highest_ = i;
            }
        }
    }
    [[nodiscard]] bool cuts_anywhere(const Turn& turn, double lift) const {
        const StandingFollower standing = follower_.standing_at(input_.follower.from_inside ? -lift : lift);
        return std::any_of(places_.begin(), places_.end(),
                           [&](const Vector2d& place) { return standing.cuts(turn(place)); });
    }

    /// The largest lift between the neighbours of the highest place, by golden section.
    [[nodiscard]] Contact refined(const Turn& turn) const {
        const std::size_t before = previous(highest_), after = next(highest_);
        const double middle = parameters_[highest_];
        double low = before == highest_ ? middle : parameters_[before];
        double high = after == highest_ ? middle : parameters_[after];
        if (low > middle) low -= curve_.length();
        if (high < middle) high += curve_.length();
        const GoldenSection top = golden_maximum([&](double parameter) { return lift_at(turn, parameter); },
                                                 low, high, section_steps);
        const double end_lift = lift_at(turn, middle);
        const double lift = std::max(top.value(), end_lift);
        return {lift, (before == highest_ || after == highest_) && lift == end_lift};
    }

    /// The highest crossing of the curve with the knife edge's path.
    [[nodiscard]] Contact crossing(const Turn& turn) const {
        const auto across = [&](const Vector2d& point) { return turn(point).x() - follower_.path(); };
        Contact contact;
        std::optional<double> before;
        const std::size_t count = places_.size() + (curve_.closed() ? 1 : 0);
        for (std::size_t i = 0; i < count; ++i) {
            const double now = across(places_[i % places_.size()]);
            if (before && (*before > 0.0) != (now > 0.0)) {
                const double end = i < places_.size() ? parameters_[i] : curve_.length();
                const auto still_before = [&](double parameter) {
                    return (across(curve_.at(parameter)) > 0.0) == (*before > 0.0);
                };
                const double last = bisected(still_before, {parameters_[i - 1], end}, root_bisections).with;
                contact.lift = std::max(contact.lift, turn(curve_.at(last)).y());
            }
            before = now;
        }
        contact.at_end = !curve_.closed() && contact.lift == -infinity;
        return contact;
    }

    const ForwardCheckInput& input_;
    PointCurve curve_;
    TouchingFollower follower_;
    std::vector<double> parameters_;
    std::vector<Vector2d> places_;
    std::size_t highest_ = 0;
};

}  // namespace

void ForwardCheckInput::validate() const {
    if (!designed) throw InputError("a forward check needs the designed motion");
    if (angles < 1) throw InputError(fmt::format("a forward check of {} angles: at least 1", angles));
    if (!(end > begin)) throw InputError(fmt::format("a forward check from {} to {} rad", begin, end));
    for (const Vector2d& point : points)
        if (!point.allFinite()) throw InputError("a forward check takes finite points only, and one is not");
}

ForwardCheckResult forward_check(const ForwardCheckInput& input) {
    const Stopwatch watch;
    input.validate();
    ForwardCheckResult result = Simulation(input).run();
    result.seconds = watch.seconds();
    return result;
}

}  // namespace camopt
