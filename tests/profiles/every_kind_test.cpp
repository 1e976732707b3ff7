// SPDX-License-Identifier: MIT
// What every kind of cam that is registered must keep: its quantities are those of its point, their partials
// by the state and by every dimension those of differences, and enclosures over boxes and along stretches
// hold values, slopes and second derivatives at every place within. A kind, a follower or a linkage is tried
// as soon as an example scene has it; one that none has is a fault.
#include "core/errors.hpp"
#include "input/loading/load_scene.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "scene/cam_mechanism.hpp"
#include "tests/profiles/remote/tappet.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace camopt {
namespace every_kind_test {

using enum MechanismQuantity;

struct Case {
    std::string name;
    CamSpec spec;
    double lift = 0.0, unit_angle = 0.0;
};

void PrintTo(const Case& one, std::ostream* stream) {
    *stream << one.name;
}

/// "disk_grooved_oscillating_roller": the type and the choices.
std::string name_of(const CamSpec& spec) {
    std::string name = spec.type;
    for (const char* choice : {"form", "follower", "linkage"})
        if (const std::string word = spec.choice(choice); !word.empty()) name += "_" + word;
    return name;
}

void add(std::vector<Case>& all, const CamSpec& spec, double lift, double unit_angle) {
    const std::string name = name_of(spec);
    if (std::ranges::find(all, name, &Case::name) == all.end()) all.push_back({name, spec, lift, unit_angle});
}

/// The tappet's lever with the linkages that no example has.
void add_linkages(std::vector<Case>& all) {
    using enum RemoteLinkage;
    using enum RemoteDimension;
    for (const RemoteLinkage linkage : {lever, lever_coupler_slider, lever_coupler_lever}) {
        CamSpec spec = test::tappet();
        spec.choices["linkage"] = camopt::name_of(linkage);
        if (linkage == lever_coupler_lever) test::set(spec, output_angle, 185);
        if (linkage == lever) test::set(spec, output_angle, -5);
        if (linkage == lever_coupler_slider) {
            test::set(spec, slider_x, 110);
            test::set(spec, slider_y, 350);
        }
        for (int i = 0; i < remote_dimension_count; ++i)
            if (has_dimension(linkage, static_cast<RemoteDimension>(i)))
                spec.dimensions[static_cast<std::size_t>(i)].value.key = "given";
        add(all, spec, output_swings(linkage) ? 0.2 : 0.08, 1.5);
    }
}

/// Every drum once more, its groove wider than its roller.
void add_clearance(std::vector<Case>& all) {
    for (std::size_t i = 0, count = all.size(); i < count; ++i) {
        Case wide = all[i];
        if (!cam_kind(wide.spec.type)->knows("cam", "roller_length")) continue;
        wide.name += "_wide_groove";
        if (wide.spec.find("groove_clearance") == nullptr)
            wide.spec.dimensions.push_back({"groove_clearance", Dimension(4e-4), false});
        all.push_back(std::move(wide));
    }
}

/// One of each type, follower, form and linkage of the example scenes. Given cams are of kinds that other
/// scenes have: they are left out, since every test's process reads all scenes and fits their recordings
/// anew.
std::vector<Case> cases() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/scenes"))
        if (entry.path().extension() == ".toml" && !entry.path().stem().string().starts_with("given_"))
            files.push_back(entry.path());
    std::ranges::sort(files);
    std::vector<Case> all;
    for (const std::filesystem::path& file : files) {
        const Scene scene = load_scene(file);
        if (scene.cam) add(all, *scene.cam, scene.motion.lift, scene.motion.unit_angle());
    }
    add_linkages(all);
    add_clearance(all);
    return all;
}

/// Whether the spec is of this follower, this linkage of its kind.
bool is_of(const CamSpec& spec, const CamVariant& variant) {
    const CamKind& kind = *cam_kind(spec.type);
    return kind.choosing_key.empty() || std::ranges::any_of(spec.choices, [&](const auto& choice) {
               return choice.second == variant.word;
           });
}

class EveryKind : public testing::TestWithParam<Case> {};

TEST(EveryKind, CoversEveryFollowerAndLinkage) {
    const std::vector<Case> all = cases();
    for (const CamKind& kind : cam_kinds())
        for (const CamVariant& variant : kind.variants)
            EXPECT_TRUE(std::ranges::any_of(
                all,
                [&](const Case& one) {
                    const bool chosen = std::ranges::any_of(
                        one.spec.choices, [&](const auto& choice) { return choice.second == variant.word; });
                    return one.spec.type == kind.type && (chosen || kind.choosing_key.empty());
                }))
                << kind.type << " " << variant.word;
}

class Trial {
 public:
    Trial(const Case& one, unsigned seed) : case_(one), formulas_(one.spec.formulas()), random_(seed) {
        for (const CamVariant& variant : cam_kind(one.spec.type)->variants)
            if (is_of(one.spec, variant))
                for (const CamNumber& number : variant.numbers)
                    if (number.owned && number.index >= 0) own_.push_back(number.index);
    }

    [[nodiscard]] double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    [[nodiscard]] double within(const Interval& range) { return between(range.lower, range.upper); }
    /// Around a random place of [low, high]; as wide as a random power of ten of it.
    [[nodiscard]] Interval part(double low, double high, double width) {
        const double middle = between(low, high), half = 0.5 * width * (high - low);
        return {middle - half, middle + half};
    }
    [[nodiscard]] double random_width() { return std::pow(10.0, between(-4.0, -0.5)); }
    [[nodiscard]] int random_station() {
        return std::uniform_int_distribution<int>(0, formulas_->stations() - 1)(random_);
    }
    /// Dimensions that move: at most four, ascending.
    [[nodiscard]] std::vector<int> random_dimensions() {
        std::vector<int> all = own_;
        std::shuffle(all.begin(), all.end(), random_);
        all.resize(
            std::min<std::size_t>(all.size(), std::uniform_int_distribution<std::size_t>(0, 4)(random_)));
        std::ranges::sort(all);
        return all;
    }
    [[nodiscard]] double velocity() const { return 2.0 * case_.lift / case_.unit_angle; }
    [[nodiscard]] double acceleration() const { return 3.0 * velocity() / case_.unit_angle; }
    [[nodiscard]] const CamMechanism& formulas() const { return *formulas_; }
    [[nodiscard]] const Case& of() const { return case_; }

 private:
    const Case& case_;
    std::shared_ptr<const CamMechanism> formulas_;
    std::mt19937 random_;
    std::vector<int> own_;
};

/// Rounding is no violation; out of reach is one, unless the enclosure says nothing.
bool holds(const Interval& range, double value, double size) {
    if (!std::isfinite(range.lower) && !std::isfinite(range.upper)) return true;
    const double room = 1e-9 * (std::abs(value) + size);
    return value >= range.lower - room && value <= range.upper + room;
}

double magnitude(const Interval& range) {
    return std::max(std::abs(range.lower), std::abs(range.upper));
}

/// Those that the cam has.
std::vector<MechanismQuantity> quantities_of(const Trial& trial) {
    const std::vector<double> numbers = trial.of().spec.middle();
    const MechanismState state{numbers, {0.3 * trial.of().lift, 0.0, 0.0}, 0.0};
    std::vector<MechanismQuantity> all;
    for (const MechanismQuantity which :
         {pressure_numerator, pressure_denominator, pitch_curvature, cam_radius, regularity, contact_offset,
          normal_lever, contact_radius}) {
        try {
            if (std::isfinite(trial.formulas().quantity(which, state, 0, {}).value)) all.push_back(which);
        } catch (const ModelError&) {
            continue;
        }
    }
    return all;
}

/// One box: counts what its enclosure does not hold.
struct Box {
    Interval s, velocity, acceleration, theta;
    std::vector<int> moving;
    std::vector<Interval> numbers;  ///< of every dimension

    [[nodiscard]] MechanismStateOver over() const {
        MechanismStateOver state;
        state.s = RangeOver::variable(s, 0);
        state.velocity = RangeOver::variable(velocity, 1);
        state.acceleration = RangeOver::variable(acceleration, 2);
        state.theta = theta;
        for (const Interval& number : numbers) state.dimensions.emplace_back(number);
        for (std::size_t k = 0; k < moving.size(); ++k) {
            const auto i = static_cast<std::size_t>(moving[k]);
            state.dimensions[i] = RangeOver::variable(numbers[i], 3 + static_cast<int>(k));
        }
        return state;
    }
};

Box random_box(Trial& trial) {
    const Case& of = trial.of();
    const double width = trial.random_width();
    Box box{trial.part(0.0, of.lift, width),
            trial.part(-trial.velocity(), trial.velocity(), width),
            trial.part(-trial.acceleration(), trial.acceleration(), width),
            trial.part(0.0, of.unit_angle, width),
            trial.random_dimensions(),
            {}};
    for (const double number : of.spec.middle()) box.numbers.emplace_back(number);
    for (const int i : box.moving) {
        const double number = box.numbers[static_cast<std::size_t>(i)].lower;
        const double size = std::max(std::abs(number), 1e-3);
        box.numbers[static_cast<std::size_t>(i)] =
            trial.part(number - 0.02 * size, number + 0.02 * size, width);
    }
    return box;
}

/// The place of a violation; empty: there is none.
std::string violation(const RangeOver& range, const MechanismValue& value) {
    const double size = magnitude(range.value);
    if (!holds(range.value, value.value, size)) return "value";
    for (Eigen::Index i = 0; i < value.gradient.size(); ++i) {
        const int k = static_cast<int>(i);
        const Interval first = k < range.size() ? range.first(k) : Interval(0.0);
        if (!holds(first, value.gradient[i], magnitude(first))) return "slope " + std::to_string(i);
        for (Eigen::Index j = 0; j <= i; ++j) {
            const Interval second = k < range.size() ? range.second(k, static_cast<int>(j)) : Interval(0.0);
            if (!holds(second, value.hessian(i, j), magnitude(second)))
                return "second " + std::to_string(i) + " " + std::to_string(j);
        }
    }
    return {};
}

/// A place in the box.
struct Place {
    std::vector<double> numbers;
    FollowerState state;
    double theta = 0.0;

    [[nodiscard]] MechanismState mechanism() const { return {numbers, state, theta}; }
};

Place random_place(Trial& trial, const Box& box) {
    Place place;
    for (const Interval& number : box.numbers) place.numbers.push_back(trial.within(number));
    place.state = {trial.within(box.s), trial.within(box.velocity), trial.within(box.acceleration)};
    place.theta = trial.within(box.theta);
    return place;
}

constexpr int places = 3;

TEST_P(EveryKind, HasItsQuantitiesEnclosedOverBoxes) {
    Trial trial(GetParam(), 1);
    const int boxes = testing_support::scenes_to_try(150, 10000);
    for (const MechanismQuantity which : quantities_of(trial)) {
        for (int k = 0; k < boxes; ++k) {
            const Box box = random_box(trial);
            const int station = trial.random_station();
            const auto range = trial.formulas().enclosures()->quantity_over(which, box.over(), station);
            if (!range) {  // it has limits enclosed instead, in every box
                ASSERT_EQ(k, 0) << "quantity " << static_cast<int>(which);
                break;
            }
            for (int i = 0; i < places; ++i) {
                const Place place = random_place(trial, box);
                const MechanismValue value =
                    trial.formulas().quantity(which, place.mechanism(), station, box.moving);
                ASSERT_EQ(violation(*range, value), "")
                    << "quantity " << static_cast<int>(which) << ", box " << k << ", station " << station;
            }
        }
    }
}

/// A limit as a function that is at most 0 where it is kept; over a box times something positive.
struct LimitForm {
    const char* name;
    std::function<std::optional<RangeOver>(const MechanismStateOver& state, int station)> over;
    std::function<double(const MechanismState& state, int station)> at;
    bool exists = true;
};

std::vector<LimitForm> limit_forms(const CamMechanism& cam) {
    constexpr double angle = 0.5, margin = 0.2, shift = 2e-3;
    std::vector<LimitForm> all;
    for (const int sign : {1, -1})
        all.push_back({sign > 0 ? "pressure angle above" : "pressure angle below",
                       [&cam, sign](const MechanismStateOver& state, int station) {
                           return cam.enclosures()->pressure_over(angle, sign, state, station);
                       },
                       [&cam, sign](const MechanismState& state, int station) {
                           return cam.pressure_excess(angle, sign, state, station, {}).value;
                       }});
    all.push_back({"regularity",
                   [&cam](const MechanismStateOver& state, int station) {
                       return cam.enclosures()->regularity_over(margin, state, station);
                   },
                   [&cam](const MechanismState& state, int station) {
                       return margin - cam.quantity(regularity, state, station, {}).value;
                   }});
    all.push_back(
        {"radius",
         [&cam](const MechanismStateOver& state, int station) {
             const int roller = cam.roller_radius_at(station);
             RangeOver radius(shift);
             if (roller >= 0) radius = state.dimensions[static_cast<std::size_t>(roller)] + radius;
             return cam.enclosures()->radius_over(radius, state, station);
         },
         [&cam](const MechanismState& state, int station) {
             const int roller = cam.roller_radius_at(station);
             const double radius = roller < 0 ? 0.0 : state.dimensions[static_cast<std::size_t>(roller)];
             return (radius + shift) * cam.quantity(pitch_curvature, state, station, {}).value - 1.0;
         },
         cam.radius_quantity() == pitch_curvature});
    return all;
}

TEST_P(EveryKind, HasItsLimitsEnclosedOverBoxes) {
    constexpr double rounding = 1e-9;
    Trial trial(GetParam(), 3);
    const int boxes = testing_support::scenes_to_try(150, 10000);
    for (const LimitForm& limit : limit_forms(trial.formulas())) {
        if (!limit.exists) continue;
        int decided = 0;
        for (int k = 0; k < boxes; ++k) {
            const Box box = random_box(trial);
            const int station = trial.random_station();
            const auto range = limit.over(box.over(), station);
            ASSERT_TRUE(range) << limit.name;
            const bool kept = range->value.upper<0.0, passed = range->value.lower> 0.0;
            if (kept || passed) ++decided;
            for (int i = 0; (kept || passed) && i < places; ++i) {
                const Place place = random_place(trial, box);
                const double value = limit.at(place.mechanism(), station);
                ASSERT_TRUE(kept ? value <= rounding : value >= -rounding)
                    << limit.name << ", box " << k << ", station " << station << ": " << value << " in "
                    << range->value.lower << " to " << range->value.upper;
            }
        }
        EXPECT_GT(decided, boxes / 3) << limit.name;
    }
}

/// The place moved in one variable: s, s', s'', then the dimensions that move.
Place moved(Place place, const std::vector<int>& moving, std::size_t variable, double by) {
    double* const state[] = {&place.state.s, &place.state.velocity, &place.state.acceleration};
    if (variable < 3)
        *state[variable] += by;
    else
        place.numbers[static_cast<std::size_t>(moving[variable - 3])] += by;
    return place;
}

/// The cam turning either way, a linkage with its pressure angle at either place.
std::vector<Case> variants_of(const Case& one) {
    std::vector<Case> all;
    for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise})
        for (const char* const place : {"roller_center", "contact_point"}) {
            Case& variant = all.emplace_back(one);
            if (cam_kind(one.spec.type)->has_rotation) variant.spec.rotation = rotation;
            if (!one.spec.choice("linkage").empty()) variant.spec.choices["pressure_angle_at"] = place;
        }
    return all;
}

/// `body` at random places of each variant: the trial, a station, a place, the dimensions that move.
void at_random_places(
    unsigned seed,
    const std::function<void(Trial&, int station, const Place&, const std::vector<int>&)>& body) {
    const int boxes = testing_support::scenes_to_try(25, 250);
    for (const Case& variant : variants_of(EveryKind::GetParam())) {
        Trial trial(variant, ++seed);
        for (int k = 0; k < boxes; ++k) {
            const Box box = random_box(trial);
            const int station = trial.random_station();
            SCOPED_TRACE(std::to_string(k) + ", station " + std::to_string(station));
            body(trial, station, random_place(trial, box), box.moving);
        }
    }
}

TEST_P(EveryKind, HasTheQuantitiesOfItsPoint) {
    at_random_places(20, [](Trial& trial, int station, const Place& place, const std::vector<int>&) {
        const MechanismPoint point = trial.formulas().point(place.theta, place.mechanism(), station);
        const std::vector<MechanismQuantity> all = quantities_of(trial);
        const auto value = [&](MechanismQuantity which) {
            return trial.formulas().quantity(which, place.mechanism(), station, {}).value;
        };
        constexpr double room = 1e-13;
        const auto expect_same = [&](MechanismQuantity which, double of_point) {
            if (std::ranges::find(all, which) == all.end()) return;
            EXPECT_NEAR(value(which), of_point, room * (std::abs(of_point) + 1.0)) << static_cast<int>(which);
        };
        expect_same(regularity, point.regularity);
        expect_same(pitch_curvature, point.pitch_curvature);
        expect_same(cam_radius, point.cam_radius);
        expect_same(contact_offset, point.contact_offset);
        expect_same(contact_radius, point.contact_radius);
        const double n = value(pressure_numerator), d = value(pressure_denominator);
        const double across = n * std::cos(point.pressure_angle) - d * std::sin(point.pressure_angle);
        EXPECT_NEAR(across, 0.0, room * std::hypot(n, d));
    });
}

/// Central difference of fourth order at 0.
template <class Function>
auto difference(const Function& function, double step) {
    using Result = std::decay_t<decltype(function(0.0))>;
    return Result(
        (8.0 * (function(step) - function(-step)) - (function(2.0 * step) - function(-2.0 * step))) /
        (12.0 * step));
}

TEST_P(EveryKind, HasThePartialsOfItsDifferences) {
    const std::string& type = GetParam().spec.type;
    const bool linkage = type == "remote" || type == "inverse";  // bends more
    const double part = linkage ? 1e-4 : 5e-4;                   // of a variable's size
    const double room = linkage ? 1e-8 : 1e-9;                   // of a partial's
    at_random_places(4, [part, room](Trial& trial, int station, const Place& place,
                                     const std::vector<int>& moving) {
        std::vector<double> sizes = {GetParam().lift, trial.velocity(), trial.acceleration()};
        for (const int i : moving)
            sizes.push_back(std::max(std::abs(place.numbers[static_cast<std::size_t>(i)]), 1e-3));
        for (const MechanismQuantity which : quantities_of(trial)) {
            SCOPED_TRACE("quantity " + std::to_string(static_cast<int>(which)));
            const auto at = [&](const Place& there, const std::vector<int>& active) {
                return trial.formulas().quantity(which, there.mechanism(), station, active);
            };
            const MechanismValue value = at(place, moving), none = at(place, {});
            EXPECT_TRUE(value.hessian.isApprox(value.hessian.transpose(), 1e-13));
            EXPECT_LE((value.hessian.topLeftCorner(3, 3) - none.hessian).norm(), 1e-12 * none.hessian.norm());
            for (std::size_t v = 0; v < sizes.size(); ++v) {
                const double step = part * sizes[v];
                const auto beside = [&](double by) { return at(moved(place, moving, v, by), moving); };
                const auto row = static_cast<Eigen::Index>(v);
                const double size = (std::abs(value.value) + 1e-3) / sizes[v];
                ASSERT_NEAR(difference([&](double by) { return beside(by).value; }, step),
                            value.gradient[row], room * (std::abs(value.gradient[row]) + size))
                    << v;
                if (v < 3) {  // with every other quantity moving
                    ASSERT_NEAR(none.gradient[row], value.gradient[row],
                                1e-10 * (std::abs(value.gradient[row]) + size));
                }
                const Eigen::VectorXd second =
                    difference([&](double by) { return Eigen::VectorXd(beside(by).gradient); }, step);
                for (std::size_t w = 0; w < sizes.size(); ++w) {
                    const auto column = static_cast<Eigen::Index>(w);
                    const double exact = value.hessian(row, column);
                    ASSERT_NEAR(second[column], exact, room * (std::abs(exact) + size / sizes[w]))
                        << v << " " << w;
                }
            }
            const auto turned = [&](double by) {
                Place there = place;
                there.theta += by;
                return at(there, {}).value;
            };
            ASSERT_NEAR(difference(turned, part), none.by_angle,
                        room * (std::abs(none.by_angle) + std::abs(value.value) + 1e-3))
                << "by the cam angle";
        }
    });
}

/// s = s0 + v0 x + a0 x²/2 + j x³/6 over the cam angle x from 0 to `length`.
struct Stretch {
    double s, velocity, acceleration, jerk, theta, length;

    [[nodiscard]] FollowerState at(double x) const {
        return {s + x * (velocity + x * (0.5 * acceleration + x * jerk / 6.0)),
                velocity + x * (acceleration + 0.5 * x * jerk), acceleration + x * jerk};
    }
    [[nodiscard]] MechanismStateAlong along(std::span<const double> numbers) const {
        const Interval x(0.0, length), j(jerk);
        const Interval a = Interval(acceleration) + j * x;
        const Interval v = Interval(velocity) + Interval(acceleration) * x + Interval(0.5 * jerk) * (x * x);
        const Interval y = Interval(s) + v * x;
        return {numbers,
                {y, v, a},
                {v, a, j},
                {a, j, Interval(0.0)},
                {Interval(theta) + x, Interval(1.0), Interval(0.0)}};
    }
};

TEST_P(EveryKind, IsEnclosedAlongStretches) {
    Trial trial(GetParam(), 2);
    const int stretches = testing_support::scenes_to_try(150, 10000);
    const std::vector<double> numbers = GetParam().spec.middle();
    for (const MechanismQuantity which : quantities_of(trial)) {
        for (int k = 0; k < stretches; ++k) {
            const double v = trial.velocity(), a = trial.acceleration();
            const Stretch stretch{trial.between(0.1, 0.9) * GetParam().lift,
                                  trial.between(-v, v),
                                  trial.between(-a, a),
                                  trial.between(-a, a) / GetParam().unit_angle,
                                  trial.between(0.0, 0.8) * GetParam().unit_angle,
                                  0.1 * GetParam().unit_angle * trial.random_width()};
            const int station = trial.random_station();
            const auto range =
                trial.formulas().enclosures()->quantity_along(which, stretch.along(numbers), station);
            ASSERT_TRUE(range) << static_cast<int>(which);
            for (int place = 0; place < 3; ++place) {
                const double x = trial.between(0.0, stretch.length);
                const FollowerState y = stretch.at(x);
                const MechanismValue value =
                    trial.formulas().quantity(which, {numbers, y, stretch.theta + x}, station, {});
                const Eigen::Vector3d first(y.velocity, y.acceleration, stretch.jerk),
                    second(y.acceleration, stretch.jerk, 0.0);
                const double slope = value.gradient.dot(first) + value.by_angle;
                const double bend = value.gradient.dot(second) + first.dot(value.hessian * first);
                ASSERT_TRUE(holds(range->value, value.value, magnitude(range->value)))
                    << "quantity " << static_cast<int>(which) << ", stretch " << k;
                ASSERT_TRUE(holds(range->slope, slope, magnitude(range->slope)))
                    << "slope of quantity " << static_cast<int>(which) << ", stretch " << k;
                // No formula gives the second derivative by the angle alone.
                ASSERT_TRUE(value.by_angle != 0.0 || holds(range->bend, bend, magnitude(range->bend)))
                    << "second derivative of quantity " << static_cast<int>(which) << ", stretch " << k;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryKind, testing::ValuesIn(cases()),
                         [](const auto& one) { return one.param.name; });

}  // namespace every_kind_test
}  // namespace camopt
