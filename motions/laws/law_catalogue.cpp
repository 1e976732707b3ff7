// SPDX-License-Identifier: MIT
#include "motions/laws/law_catalogue.hpp"

#include "core/errors.hpp"
#include "core/open_registry.hpp"
#include "core/text/list_text.hpp"
#include "core/text/parsing.hpp"
#include "motions/laws/own_law_check.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using std::numbers::pi;

constexpr const char* kHandbook = "Norton, Cam Design and Manufacturing Handbook";
constexpr const char* kFreudenstein = "Freudenstein, Int. J. Mech. Sci. 1 (1960)";
constexpr const char* kStandard = "standard construction";
/// The share of the acceleration part in the asymmetric laws: a softer, longer deceleration, which the return
/// spring has to supply. A choice of this catalogue.
constexpr double kCatalogueSplit = 0.4;

/// A row of the catalogue: how it is made of its parameters, of which these are customary.
struct LawRow {
    std::vector<double> customary;
    std::function<std::unique_ptr<Law>(std::span<const double> parameters)> make;
};

LawInfo info_of(const char* key, std::string title, int continuity, const char* source = kHandbook) {
    LawInfo info;
    info.key = key;
    info.title = std::move(title);
    info.source = source;
    info.continuity = continuity;
    return info;
}

void require(std::string_view law, const char* name, double found, std::pair<double, double> allowed) {
    if (found >= allowed.first && found <= allowed.second) return;
    throw InputError(fmt::format("{}: {} = {} found, allowed {} <= {} <= {}", law, name, found, allowed.first,
                                 name, allowed.second));
}

std::unique_ptr<Law> harmonic(LawInfo info, std::vector<AccelerationPiece> pieces) {
    return std::make_unique<HarmonicLaw>(std::move(info), std::move(pieces));
}

/// Without parameters.
LawRow pieces(const LawInfo& info, const std::vector<AccelerationPiece>& all) {
    return {{}, [=](std::span<const double>) { return harmonic(info, all); }};
}

LawRow scca(LawInfo info, const SccaParts& parts) {
    info.continuity = scca_continuity(parts);
    return pieces(info, scca_pieces(parts));
}

LawRow polynomial(const LawInfo& info, const std::vector<double>& from_below,
                  const std::vector<double>& from_top) {
    return {{}, [=](std::span<const double>) {
                return std::make_unique<PolynomialLaw>(info, from_below, from_top);
            }};
}

/// y(x) + y(1 - x) = 1.
LawRow polynomial(const LawInfo& info, const std::vector<double>& from_below) {
    return {{}, [=](std::span<const double>) { return std::make_unique<PolynomialLaw>(info, from_below); }};
}

/// y = x - Σ amplitude[k] sin(2π (2k + 1) x), so y'' = Σ amplitude (2π (2k + 1))² sin.
LawRow odd_harmonics(const LawInfo& info, const std::vector<double>& amplitudes) {
    AccelerationPiece piece{0.0, 1.0};
    double frequency = 2.0 * pi;
    for (const double amplitude : amplitudes) {
        piece.terms.push_back({frequency, amplitude * frequency * frequency, 0.0});
        frequency += 4.0 * pi;
    }
    return pieces(info, {piece});
}

/// SCCA with a sine of the width Ta: modified sine (the rest cosine; towards 0 simple harmonic), modified
/// trapezoid (a cosine as wide, between them constant; towards 0 parabolic). Both are cycloidal at 1/4.
LawRow modified(const char* key, const char* title, const char* source, SccaParts (*parts)(double ta)) {
    constexpr double customary = 0.125;
    return {{customary}, [=](std::span<const double> at) {
                const double ta = at[0];
                require(key, "Ta", ta, {kNarrowestPiece, 0.25});
                LawInfo info = info_of(key, fmt::format("{} (Ta = {})", title, ta), 2, source);
                info.parameters = {{"Ta", ta}};
                return harmonic(std::move(info), scca_pieces(parts(ta)));
            }};
}

/// SCCA with a sine up to a and a cosine down to 0 at b; the velocity is constant over the part 1 - 2b.
LawRow constant_velocity(const char* key, double customary_a, double customary_b) {
    const auto make = [key](std::span<const double> at) {
        const double a = at[0], b = at[1];
        require(key, "b", b, {2.0 * kNarrowestPiece, 0.5 - kNarrowestPiece});
        require(key, "a", a, {kNarrowestPiece, b - kNarrowestPiece});
        LawInfo info =
            info_of(key, fmt::format("Modified constant velocity, {:.0f} %", 100.0 * (1.0 - 2.0 * b)), 2);
        info.parameters = {{"a", a}, {"b", b}};
        return harmonic(std::move(info), scca_pieces({a, 0.0, b - a, 0.5 - b}));
    };
    return {{customary_a, customary_b}, make};
}

/// Any SCCA, by the proportions of its parts.
std::unique_ptr<Law> proportioned_scca(std::span<const double> at) {
    constexpr std::array<const char*, 4> names = {"sine", "constant", "cosine", "coast"};
    double whole = 0.0;
    LawInfo info = info_of("scca",
                           fmt::format("SCCA: sine {:.4g}, constant {:.4g}, cosine {:.4g}, coast {:.4g}",
                                       at[0], at[1], at[2], at[3]),
                           2, "Norton, Cam Design and Manufacturing Handbook");
    for (std::size_t i = 0; i < names.size(); ++i) {
        require("scca", names[i], at[i], {0.0, 1e9});
        info.parameters.push_back({names[i], at[i]});
        whole += at[i];
    }
    if (!(whole - at[3] > 0.0))
        throw InputError("scca: sine = constant = cosine = 0 found, allowed at least one of them above 0");
    std::array<double, 4> widths{};
    for (std::size_t i = 0; i < names.size(); ++i) {
        widths[i] = 0.5 * at[i] / whole;
        if (widths[i] != 0.0)
            require("scca", fmt::format("the width of the {}", names[i]).c_str(), widths[i],
                    {kNarrowestPiece, 0.5});
    }
    const SccaParts parts{widths[0], widths[1], widths[2], widths[3]};
    info.continuity = scca_continuity(parts);
    return harmonic(std::move(info), scca_pieces(parts));
}

/// Widths of acceleration and coast; the rest is deceleration. A third parameter is RampedParts::ramp.
std::unique_ptr<Law> ramped(LawInfo info, std::span<const double> at) {
    constexpr double narrowest_ramp = 1e-6;
    require(info.key, "acceleration", at[0], {kNarrowestPiece, 1.0 - kNarrowestPiece});
    require(info.key, "coast", at[1], {0.0, 1.0 - at[0] - kNarrowestPiece});
    info.parameters = {{"acceleration", at[0]}, {"coast", at[1]}};
    const bool ramps = at.size() > 2;
    if (ramps) {
        require(info.key, "ramp", at[2], {narrowest_ramp, 0.5});
        info.parameters.push_back({"ramp", at[2]});
    }
    return harmonic(std::move(info), ramped_pieces({at[0], at[1], ramps ? at[2] : 0.0}));
}

LawInfo turning(LawInfo info) {
    info.top = TopEnd::turning_point;
    return info;
}

std::unique_ptr<Law> one_dwell(const char* key, const char* title, std::pair<double, double> ta_and_widest,
                               std::vector<AccelerationPiece> (*shape)(double)) {
    const auto [ta, widest] = ta_and_widest;
    require(key, "Ta", ta, {kNarrowestPiece, widest});
    LawInfo info = turning(info_of(key, fmt::format("{} (one dwell, Ta = {})", title, ta), 2, kStandard));
    info.parameters = {{"Ta", ta}};
    return harmonic(std::move(info), shape(ta));
}

LawRow asymmetric(const LawRow& base) {
    std::vector<double> customary = base.customary;
    customary.push_back(kCatalogueSplit);
    return {customary, [make = base.make](std::span<const double> at) {
                return make_asymmetric(make(at.first(at.size() - 1)), at.back());
            }};
}

/// Between two dwells, and the odd harmonics.
std::vector<LawRow> laws_between_dwells() {
    constexpr double eighth = 0.125, third = 1.0 / 3.0;
    const double first = 1125.0 / (2384.0 * pi);  // of Freudenstein 1-3-5
    return {
        scca(info_of("parabolic", "Parabolic (constant acceleration)", 1), {.constant = 0.5}),
        scca(info_of("simple_harmonic", "Simple harmonic", 1), {.cosine = 0.5}),
        scca(info_of("cycloidal", "Cycloidal", 2), {.sine = 0.25, .cosine = 0.25}),
        polynomial(info_of("polynomial_345", "3-4-5 polynomial", 2), {0, 0, 0, 10, -15, 6}),
        polynomial(info_of("polynomial_4567", "4-5-6-7 polynomial", 3), {0, 0, 0, 0, 35, -84, 70, -20}),
        polynomial(info_of("polynomial_56789", "5-6-7-8-9 polynomial", 4),
                   {0, 0, 0, 0, 0, 126, -420, 540, -315, 70}),
        modified("modified_sine", "Modified sine", "Schmidt; Norton, Cam Design and Manufacturing Handbook",
                 [](double ta) { return SccaParts{.sine = ta, .cosine = 0.5 - ta}; }),
        modified("modified_trapezoid", "Modified trapezoid",
                 "Neklutin; Norton, Cam Design and Manufacturing Handbook",
                 [](double ta) {
                     return SccaParts{ta, 0.5 - 2.0 * ta, ta, 0.0};
                 }),
        constant_velocity("mcv_50", 1.0 / 16.0, 0.25),
        constant_velocity("mcv_33", 1.0 / 12.0, third),
        constant_velocity("mcv_20", 0.1, 0.4),
        scca(info_of("cycloidal_cv50", "Cycloidal with 50 % constant velocity", 2),
             {.sine = eighth, .cosine = eighth, .coast = 0.25}),
        // Degrees of a half rise of 180: the "modified cycloidal" law of Table 3 of paper 004.
        {{67.5, 33.3, 49.5, 29.7}, proportioned_scca},
        {{third, third},
         [](std::span<const double> at) {
             return ramped(info_of("trapezoid", "Trapezoidal velocity", 1, kStandard), at);
         }},
        {{third, third, 0.25},
         [](std::span<const double> at) {
             return ramped(info_of("s_curve", "S-curve (jerk-limited, seven phases)", 2, kStandard), at);
         }},
        odd_harmonics(info_of("gutman_13", "Gutman 1-3", 2, "Gutman, Product Engineering 32 (1961)"),
                      {15.0 / (32.0 * pi), 1.0 / (96.0 * pi)}),
        odd_harmonics(info_of("freudenstein_13", "Freudenstein 1-3", 2, kFreudenstein),
                      {27.0 / (56.0 * pi), 1.0 / (168.0 * pi)}),
        odd_harmonics(info_of("freudenstein_135", "Freudenstein 1-3-5", 2, kFreudenstein),
                      {first, first / 54.0, first / 1250.0}),
    };
}

/// The return follows at once: TopEnd::turning_point.
std::vector<LawRow> one_dwell_laws() {
    constexpr double eighth = 0.125, third = 1.0 / 3.0;
    return {
        {{eighth},
         [](std::span<const double> at) {
             return one_dwell("one_dwell_modified_sine", "Modified sine", {at[0], widest_one_dwell_sine},
                              one_dwell_sine_pieces);
         }},
        {{eighth},
         [](std::span<const double> at) {
             return one_dwell("one_dwell_modified_trapezoid", "Modified trapezoid",
                              {at[0], widest_one_dwell_trapezoid}, one_dwell_trapezoid_pieces);
         }},
        pieces(turning(info_of("one_dwell_cycloidal", "Cycloidal (one dwell)", 2, kStandard)),
               one_dwell_sine_pieces(widest_one_dwell_sine)),
        // The lowest degree with y = y' = y'' = 0 at 0, y = 1, y' = y''' = 0 at 1.
        polynomial(turning(info_of("one_dwell_polynomial_345", "3-4-5 polynomial (one dwell)", 2, kStandard)),
                   {0, 0, 0, 20 * third, -25 * third, 8 * third}, {1, 0, -10 * third, 0, 5, -8 * third}),
        // (1 - (1 - x)²)³: the lowest degree of a single polynomial over rise and return, with y = y' = y'' =
        // 0 at 0 and 2 and y = 1 at 1.
        polynomial(
            turning(info_of("one_dwell_polynomial_3456", "3-4-5-6 polynomial (one dwell)", 2, kStandard)),
            {0, 0, 0, 8, -12, 6, -1}, {1, 0, -3, 0, 3, 0, -1}),
    };
}

/// y = x, and quartics to and from it, y = 2x³ − x⁴ with y'(1) = 2. Their ends move: they occur only in
/// programs, between segments that take their velocity.
std::vector<LawRow> moving_laws() {
    const auto info = [](const char* key, const char* title, const char* source) {
        LawInfo law = info_of(key, title, 0, source);
        law.rests = false;
        return law;
    };
    constexpr const char* quartic = "Quartic with y'' = 0 at both ends";
    return {
        polynomial(info("run_in", "Run-in from rest to constant velocity (programs only)", quartic),
                   {0, 0, 0, 2, -1}, {1, -2, 0, 2, -1}),
        polynomial(info("run_out", "Run-out from constant velocity to rest (programs only)", quartic),
                   {0, 2, 0, -2, 1}, {1, 0, 0, -2, 1}),
        polynomial(info("constant_velocity", "Constant velocity (programs only: its ends move)", kHandbook),
                   {0, 1}),
        {{0.0, 0.0, 0.0, 0.0},
         [](std::span<const double> at) {
             return make_polynomial({at[0], at[2], at[1], at[3]});
         }},
    };
}

/// The classical laws.
std::vector<LawRow> classical_laws() {
    std::vector<LawRow> all = laws_between_dwells();
    std::vector<LawRow> split;
    const auto of = [&](const char* key) {
        return *std::ranges::find_if(
            all, [&](const LawRow& row) { return row.make(row.customary)->key() == key; });
    };
    // y'' = -π² at x = 1 and a jump of y'''' alone at 0: y = (1 - cos πx) / 2 - (1 - cos 2πx) / 8.
    split.push_back(
        pieces(turning(info_of("double_harmonic", "Double harmonic (one dwell)", 3, "Rothbart, Cams (1956)")),
               {{0.0, 1.0, 0.0, {{pi, 0.0, 1.0}, {2.0 * pi, 0.0, -1.0}}}}));
    for (const char* key :
         {"parabolic", "cycloidal", "polynomial_345", "modified_sine", "modified_trapezoid"})
        split.push_back(asymmetric(of(key)));
    for (const std::vector<LawRow>& more : {split, one_dwell_laws(), moving_laws()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

using Laws = OpenRegistry<LawInfo, LawRow>;

Laws& laws() {
    static Laws all(&LawInfo::key, [] {
        Laws::Lists classical;
        classical.makers = classical_laws();
        for (const LawRow& row : classical.makers)
            classical.descriptions.push_back(row.make(row.customary)->info());
        return classical;
    }());
    return all;
}

struct KnownLaw {
    const LawInfo& info;
    const LawRow& row;
};

KnownLaw known_law(std::string_view key) {
    const Laws::Lists& known = laws().lists();
    for (std::size_t i = 0; i < known.descriptions.size(); ++i)
        if (known.descriptions[i].key == key) return {known.descriptions[i], known.makers[i]};
    throw InputError(fmt::format("motion law: \"{}\" found, allowed {}", key,
                                 listed(known.descriptions, ", ", &LawInfo::key)));
}

/// Puts "0.2" or "Ta = 0.2", an argument of a name, in its place.
void take_argument(const LawInfo& law, std::string_view argument, std::size_t index,
                   std::vector<double>& parameters) {
    const auto refuse = [&law, argument] {
        const std::string names = listed(law.parameters, ", ", &LawParameter::name);
        throw InputError(fmt::format(
            "{}: \"{}\" found, allowed {}", law.key, argument,
            names.empty() ? "no numbers" : "numbers for " + names + ", in this order or by name"));
    };
    std::string_view number = argument;
    if (const std::size_t sign = argument.find('='); sign != std::string_view::npos) {
        const auto found =
            std::ranges::find(law.parameters, trimmed(argument.substr(0, sign)), &LawParameter::name);
        if (found == law.parameters.end()) refuse();
        index = static_cast<std::size_t>(found - law.parameters.begin());
        number = trimmed(argument.substr(sign + 1));
    }
    const std::optional<double> value = number_in(number);
    if (!value || index >= parameters.size()) refuse();
    parameters[index] = *value;
}

}  // namespace

std::span<const LawInfo> law_catalogue() {
    return laws().descriptions();
}

void add_law(const LawMaker& make) {
    const std::unique_ptr<Law> law = make ? make() : nullptr;
    if (!law) throw InputError("add_law: found an empty function; allowed: a function that returns a law");
    check_own_law(*law);
    laws().add(law->info(), {{}, [make](std::span<const double>) { return make(); }}, [&] {
        throw InputError(fmt::format(
            "add_law: found the key \"{}\", which another law has; allowed: a new one", law->key()));
    });
}

std::unique_ptr<Law> make_law(std::string_view key, std::span<const double> parameters) {
    const LawRow& row = known_law(key).row;
    if (parameters.size() > row.customary.size())
        throw InputError(fmt::format("{}: {} parameters found, allowed at most {}", key, parameters.size(),
                                     row.customary.size()));
    std::vector<double> all = row.customary;
    std::ranges::copy(parameters, all.begin());
    return row.make(all);
}

std::unique_ptr<Law> make_law(std::string_view name) {
    if (name.starts_with(kReversed)) return make_reversed(make_law(name.substr(kReversed.size())));
    const std::string_view key = law_key(name);
    if (key.size() == name.size()) return make_law(key, {});
    const KnownLaw law = known_law(key);
    const std::size_t begin = name.find('(') + 1, end = name.rfind(')');
    if (end != name.size() - 1 || end < begin)
        throw InputError(
            fmt::format("motion law: \"{}\" found, allowed \"{}(…)\" with numbers in brackets", name, key));
    std::vector<double> parameters = law.row.customary;
    const std::vector<std::string_view> arguments = split_text(name.substr(begin, end - begin), ',');
    for (std::size_t i = 0; i < arguments.size(); ++i) take_argument(law.info, arguments[i], i, parameters);
    return law.row.make(parameters);
}

std::string_view law_key(std::string_view name) {
    return trimmed(name.substr(0, name.find('(')));
}

std::string law_name(const LawInfo& law) {
    std::string_view key = law.key;
    if (key.starts_with(kReversed)) key.remove_prefix(kReversed.size());
    const std::vector<LawParameter>& customary = known_law(key).info.parameters;
    const bool plain =
        std::ranges::equal(law.parameters, customary, {}, &LawParameter::value, &LawParameter::value);
    if (plain) return law.key;
    return fmt::format("{}({})", law.key, listed(law.parameters, ", ", [](const LawParameter& parameter) {
                           return fmt::to_string(parameter.value);
                       }));
}

std::unique_ptr<Law> make_polynomial(const EndStates& ends) {
    EndPolynomial found = polynomial_between(ends);
    LawInfo info = info_of("polynomial", "Polynomial through the states of both ends (programs only)", 0,
                           "Hermite interpolation");
    info.rests = false;
    info.parameters = {{"start_velocity", ends.start_velocity},
                       {"start_acceleration", 2.0 * found.from_below[2]},
                       {"end_velocity", ends.end_velocity},
                       {"end_acceleration", 2.0 * found.from_top[2]}};
    for (const LawParameter& parameter : info.parameters)
        require("polynomial", parameter.name.c_str(), parameter.value, {-1e6, 1e6});
    return std::make_unique<PolynomialLaw>(std::move(info), std::move(found.from_below),
                                           std::move(found.from_top));
}

}  // namespace camopt
