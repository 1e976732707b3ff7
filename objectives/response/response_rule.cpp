// SPDX-License-Identifier: MIT
#include "objectives/response/response_rule.hpp"

#include "motions/laws/law_catalogue.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

// In lifts: a law with less vibration than this at the worst speed has no residual to divide by.
constexpr double least_reference_residual = 1e-9;
// Further directions per speed: the rows form an octagon around the cone.
constexpr int directions = 8;
// Of the first grid: speeds per cycle of the slowest mode over the motion, and samples per stretch.
constexpr double speeds_a_turn = 6.0;
constexpr int first_places = 16;

/// The response that one rule limits.
struct Asked {
    ResponseKind kind = ResponseKind::residual;
    std::string name;
    bool limit = false;
    double level = 0.0;  ///< limit: lifts, or the least N or N m
    double size = 1.0;   ///< what a value of the rule is measured by
};

std::vector<SlopePiece> slope_pieces_of(const Scene& scene, const Motion& motion) {
    return train_of(scene).pieces(motion);
}

double length_of(const MotionEvent& event) {
    double length = 0.0;
    for (const MotionStretch& stretch : event.moving) length += stretch.end - stretch.begin;
    return length;
}

double end_of(const MotionEvent& event) {
    return event.moving.back().end;
}

/// The response to be limited, of one event at one speed; of the contact force its negative.
Extremum worst_of_event(const TrainAtSpeed& train, const EventPieces& pieces, ResponseKind kind, double end) {
    const EventResponse response(train, pieces);
    switch (kind) {
        case ResponseKind::residual:
            return {response.residual(), end, Side::left};
        case ResponseKind::acceleration:
            return response.largest_magnitude(train.acceleration(), true);
        case ResponseKind::contact_force:
            break;
    }
    return response.largest(train.contact_force(), -1.0, true);
}

/// Uniformly over the range, by the cycles of the slowest mode that it spans: the response is an entire
/// function of the speed, and varies little between so many speeds.
std::vector<double> first_speeds(const Scene& scene, double length) {
    const auto [low, high] = response_speeds(scene);
    if (!(high > low)) return {low};
    const double slowest = train_of(scene).natural_frequencies().front();
    const double turns =
        slowest * scene.motion.unit_angle() * length / units::turn * (1.0 / low - 1.0 / high);
    const int count = static_cast<int>(std::clamp(std::ceil(speeds_a_turn * turns) + 3.0, 3.0, 33.0));
    std::vector<double> speeds;
    speeds.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) speeds.push_back(low + (high - low) * k / (count - 1));
    return speeds;
}

bool same_pieces(const std::vector<SlopePiece>& one, const std::vector<SlopePiece>& other) {
    return std::ranges::equal(one, other, [](const SlopePiece& a, const SlopePiece& b) {
        return a.begin == b.begin && a.width == b.width && a.displacement == b.displacement &&
               a.slope.size() == b.slope.size() && a.slope == b.slope;
    });
}

/// The worst speeds of a motion. The optimizer asks for those of one motion several times in a row, by terms
/// and limits of one kind: the last motion is cached.
class WorstSpeeds {
 public:
    struct Event {
        EventPieces pieces;
        std::vector<SpeedMaximum> speeds;
    };
    WorstSpeeds(const Scene& scene, std::vector<MotionEvent> events)
        : scene_(scene), events_(std::move(events)) {}

    [[nodiscard]] std::shared_ptr<const std::vector<Event>> of(const Motion& motion, ResponseKind kind) {
        const std::vector<SlopePiece> slope = slope_pieces_of(scene_, motion);
        const std::lock_guard lock(mutex_);
        Known& known = known_[static_cast<std::size_t>(kind)];
        if (known.events && same_pieces(known.slope, slope)) return known.events;
        auto found = std::make_shared<std::vector<Event>>();
        for (const MotionEvent& event : events_) {
            EventPieces pieces = pieces_of_event(slope, event);
            const auto worst = [&](double speed) {
                return worst_of_event(*train_at(scene_, speed), pieces, kind, 0.0).value;
            };
            std::vector<SpeedMaximum> speeds = maxima_over_speeds(scene_, length_of(event), worst);
            found->push_back({std::move(pieces), std::move(speeds)});
        }
        known = {slope, found};
        return found;
    }

 private:
    struct Known {
        std::vector<SlopePiece> slope;
        std::shared_ptr<const std::vector<Event>> events;
    };
    Scene scene_;
    std::vector<MotionEvent> events_;
    std::mutex mutex_;
    std::array<Known, 3> known_;
};

AffineRow dense_row(const Eigen::RowVectorXd& weights) {
    AffineRow row;
    row.offset = weights[weights.size() - 1];
    for (Eigen::Index k = 0; k + 1 < weights.size(); ++k) {
        if (weights[k] == 0.0) continue;
        row.columns.push_back(static_cast<int>(k));
        row.weights.push_back(weights[k]);
    }
    return row;
}

/// The parts of a rule. setting: the speed of the cam, the event, the sign or the phases of the modes.
class AskedResponse {
 public:
    using Place = WholeMotionRule::Place;
    using Setting = WholeMotionRule::Setting;

    AskedResponse(const Scene& scene, Asked asked, std::shared_ptr<WorstSpeeds> speeds)
        : scene_(scene),
          asked_(std::move(asked)),
          events_(motion_events(scene.motion)),
          speeds_(std::move(speeds)) {}

    [[nodiscard]] std::vector<Place> maxima(const Motion& motion, double q) const {
        const auto events = speeds_->of(motion, asked_.kind);
        std::vector<Place> all;
        for (std::size_t event = 0; event < events->size(); ++event)
            for (const SpeedMaximum& at : (*events)[event].speeds)
                add_places(all, at.speed, event, (*events)[event].pieces, q);
        return all;
    }
    [[nodiscard]] AffineRow row(const MotionFamily& family, double at, Side side, Setting setting) const {
        const auto train = train_at(scene_, setting[0]);
        const EventRows& rows = rows_of(family, static_cast<std::size_t>(setting[1]));
        AffineRow row;
        double factor = 1.0 / asked_.size;
        if (asked_.kind == ResponseKind::residual) {
            row = residual_row(rows.state_at_end(*train), *train, setting);
        } else {
            const bool force = asked_.kind == ResponseKind::contact_force;
            const auto& reading = force ? train->contact_force() : train->acceleration();
            factor *= setting[2];
            row = dense_row(reading.state.transpose() * rows.state_at(*train, at));
            row.offset += reading.constant;
            const double inside = std::clamp(at, family.begin(), family.end());
            for (int order = 0; order < 3; ++order)
                if (const double weight = reading.motion[order]; weight != 0.0)
                    row = combined(row, weight, family.functional(inside, order, side));
        }
        row.offset *= factor;
        for (double& weight : row.weights) weight *= factor;
        if (asked_.limit)
            row.offset += asked_.kind == ResponseKind::contact_force ? asked_.level / asked_.size : -1.0;
        return row;
    }
    [[nodiscard]] std::vector<Place> first() const {
        const std::size_t modes =
            asked_.kind == ResponseKind::residual
                ? static_cast<std::size_t>(train_at(scene_, *scene_.motion.speed)->modes().rows())
                : 0;
        std::vector<Place> all;
        for (std::size_t event = 0; event < events_.size(); ++event) {
            const MotionEvent& one = events_[event];
            for (const double speed : first_speeds(scene_, length_of(one))) {
                const auto number = static_cast<double>(event);
                if (asked_.kind == ResponseKind::residual) {
                    std::vector<double> setting(2 + modes, 0.0);
                    setting[0] = speed;
                    setting[1] = number;
                    for (std::vector<double>& turned : beside(setting))
                        all.push_back({{0.0, end_of(one), Side::left}, std::move(turned)});
                    continue;
                }
                for (const MotionStretch& stretch : one.moving)
                    for (int k = 1; k <= first_places; ++k) {
                        const double at =
                            stretch.begin + (stretch.end - stretch.begin) * k / (first_places + 1);
                        all.push_back({{0.0, at, Side::right}, {speed, number, -1.0}});
                        if (asked_.kind == ResponseKind::acceleration)
                            all.push_back({{0.0, at, Side::right}, {speed, number, 1.0}});
                    }
            }
        }
        return all;
    }
    [[nodiscard]] std::vector<std::vector<double>> beside(Setting setting) const {
        std::vector<std::vector<double>> all;
        if (asked_.kind != ResponseKind::residual) return all;
        for (int k = 0; k < directions; ++k) {
            std::vector<double> turned(setting.begin(), setting.end());
            for (std::size_t m = 2; m < turned.size(); ++m) turned[m] = units::turn * k / directions;
            all.push_back(std::move(turned));
        }
        return all;
    }
    [[nodiscard]] std::string remark(Setting setting) const {
        const double rpm = setting[0] / units::revolution_per_minute;
        return events_.size() == 1 ? fmt::format("{:.6g} rpm", rpm)
                                   : fmt::format("{:.6g} rpm, motion {}", rpm, setting[1] + 1);
    }
    /// The event counts from 0.
    [[nodiscard]] static std::map<std::string, double> which(Setting setting) {
        return {{"rpm", setting[0] / units::revolution_per_minute}, {"event", setting[1]}};
    }

 private:
    void add_places(std::vector<Place>& all, double speed, std::size_t event, const EventPieces& pieces,
                    double q) const {
        const auto train = train_at(scene_, speed);
        const EventResponse response(*train, pieces);
        const auto number = static_cast<double>(event);
        if (asked_.kind == ResponseKind::residual) {
            const Eigen::VectorXcd modes = response.residual_modes();
            std::vector<double> setting = {speed, number};
            for (const std::complex<double>& mode : modes) setting.push_back(std::arg(mode));
            all.push_back({{value_of(modes.cwiseAbs().sum()), end_of(events_[event]), Side::left}, setting});
            return;
        }
        const bool force = asked_.kind == ResponseKind::contact_force;
        const auto& reading = force ? train->contact_force() : train->acceleration();
        for (const double sign : {1.0, -1.0}) {
            if (force && sign > 0.0) continue;
            std::vector<double> setting = {speed, number, sign};
            // All violations of the rule, and the largest value in any case.
            std::vector<Extremum> places = response.maxima(reading, sign, f_at(q), true);
            if (places.empty()) places.push_back(response.largest(reading, sign, true));
            for (const Extremum& place : places)
                all.push_back({{value_of(place.value), place.at, place.side}, setting});
        }
    }
    [[nodiscard]] AffineRow residual_row(const Eigen::MatrixXd& state, const TrainAtSpeed& train,
                                         Setting setting) const {
        Eigen::RowVectorXd direction = Eigen::RowVectorXd::Zero(state.rows());
        for (Eigen::Index k = 0; k < train.modes().rows(); ++k) {
            const double phase = setting[2 + static_cast<std::size_t>(k)];
            direction += (std::polar(1.0, -phase) * train.modes().row(k)).real();
        }
        return dense_row(direction * state);
    }
    [[nodiscard]] const EventRows& rows_of(const MotionFamily& family, std::size_t event) const {
        const std::lock_guard lock(mutex_);
        if (rows_.empty())
            for (const MotionEvent& one : events_) rows_.emplace_back(family, one, train_of(scene_));
        return rows_[event];
    }
    /// f of the train → the rule at q = 0: f / size, or f / level − 1, or (least + f) / size with f = −F.
    [[nodiscard]] double value_of(double f) const {
        if (!asked_.limit) return f / asked_.size;
        if (asked_.kind == ResponseKind::contact_force) return (asked_.level + f) / asked_.size;
        return f / asked_.size - 1.0;
    }
    /// The f at which the rule is 0.
    [[nodiscard]] double f_at(double q) const {
        if (!asked_.limit) return q * asked_.size;
        return asked_.kind == ResponseKind::contact_force ? -asked_.level : asked_.size;
    }

    Scene scene_;
    Asked asked_;
    std::vector<MotionEvent> events_;
    std::shared_ptr<WorstSpeeds> speeds_;  ///< shared by the rules of a model
    /// A rule belongs to one model and its copies, whose families are equal: computed once.
    mutable std::mutex mutex_;
    mutable std::vector<EventRows> rows_;
};

/// `parameters`: that of a term.
std::shared_ptr<const WholeMotionRule> response_rule(const Scene& scene, const Asked& asked,
                                                     std::vector<int> parameters,
                                                     std::shared_ptr<WorstSpeeds> speeds) {
    const auto response = std::make_shared<const AskedResponse>(scene, asked, std::move(speeds));
    WholeMotionRule::Parts parts;
    parts.maxima = [response](const Motion& motion, double q) { return response->maxima(motion, q); };
    parts.row = [response](const MotionFamily& family, double at, Side side, AskedResponse::Setting setting) {
        return response->row(family, at, side, setting);
    };
    parts.first = response->first();
    parts.beside = [response](AskedResponse::Setting setting) { return response->beside(setting); };
    parts.remark = [response](AskedResponse::Setting setting) { return response->remark(setting); };
    parts.which = AskedResponse::which;
    return std::make_shared<const WholeMotionRule>(
        RuleData{asked.name, 3, asked.limit, true, std::move(parameters)}, std::move(parts));
}

void add_response_rule(CamModel& model, const Scene& scene, const ResponseTerm& term,
                       const std::shared_ptr<WorstSpeeds>& speeds) {
    const int index = static_cast<int>(model.parameters.size());
    const double reference = response_reference(scene, term);
    const Asked asked{kind_of(term.figure), term.name, false, 0.0, reference};
    const auto rule = response_rule(scene, asked, {index}, speeds);
    Parameter peak{term.name, Parameter::Kind::response, 0, reference, term.weight_in(scene.objective)};
    peak.defined_by = rule;
    model.parameters.push_back(std::move(peak));
    model.rules.emplace_back(rule);
}

void add_response_limit(CamModel& model, const Scene& scene, LimitedFigure figure,
                        const std::shared_ptr<WorstSpeeds>& speeds) {
    const auto& limit = limit_on(scene.limits, figure);
    if (!limit) return;
    Asked asked{ResponseKind::residual, limit->key, true, limit->value / scene.motion.lift, 0.0};
    asked.size = asked.level;
    if (figure == LimitedFigure::dynamic_contact_force) {
        asked.kind = ResponseKind::contact_force;
        asked.level = limit->value;
        asked.size = std::max(limit->value, scene.dynamics->preload);
        if (asked.size == 0.0) asked.size = scene.dynamics->return_stiffness * scene.motion.lift;
    }
    model.rules.emplace_back(response_rule(scene, asked, {}, speeds));
}

WorstResponse worst_over(const Scene& scene, ResponseKind kind, const Motion& motion,
                         const std::vector<MotionEvent>& events) {
    const std::vector<SlopePiece> slope = slope_pieces_of(scene, motion);
    WorstResponse worst{-infinity, 0.0, 0.0};
    for (const MotionEvent& event : events) {
        const EventPieces pieces = pieces_of_event(slope, event);
        const auto value = [&](double speed) {
            return worst_of_event(*train_at(scene, speed), pieces, kind, end_of(event)).value;
        };
        const SpeedMaximum at = maxima_over_speeds(scene, length_of(event), value).front();
        if (at.value <= worst.value) continue;
        worst = {at.value, at.speed,
                 worst_of_event(*train_at(scene, at.speed), pieces, kind, end_of(event)).at};
    }
    if (kind == ResponseKind::contact_force) worst.value = -worst.value;
    return worst;
}

}  // namespace

WorstResponse worst_response(const Scene& scene, ResponseKind kind, const Motion& motion) {
    return worst_over(scene, kind, motion, motion_events(scene.motion));
}

WorstResponse worst_response_of_rise(const Scene& scene, ResponseKind kind, const Motion& law) {
    return worst_over(scene, kind, law, {single_rise(scene.motion.unit_angle())});
}

ResponseKind kind_of(ResponseFigure figure) {
    return figure == ResponseFigure::residual ? ResponseKind::residual : ResponseKind::acceleration;
}

double response_reference(const Scene& scene, const ResponseTerm& term) {
    const Reference& reference = scene.objective.reference;
    if (const std::optional<double>& number = reference.*term.reference) return *number;
    const double own = worst_response_of_rise(scene, kind_of(term.figure), *make_law(reference.law)).value;
    if (!(own > least_reference_residual))
        throw SceneError(
            {fmt::format("objective.{}", term.name),
             fmt::format("the reference law \"{}\" with a {} of {:.3g}", reference.law, term.name, own),
             fmt::format("a law that vibrates at these speeds, or a number, objective.reference.{}",
                         term.name)});
    return own;
}

void add_response_rules(CamModel& model, const Scene& scene) {
    if (!scene.dynamics) return;
    const auto speeds = std::make_shared<WorstSpeeds>(scene, motion_events(scene.motion));
    for (const ResponseTerm& term : response_terms())
        if (term.needs_dynamics() && term.weight_in(scene.objective) > 0.0)
            add_response_rule(model, scene, term, speeds);
    add_response_limit(model, scene, LimitedFigure::residual, speeds);
    add_response_limit(model, scene, LimitedFigure::dynamic_contact_force, speeds);
}

}  // namespace camopt
