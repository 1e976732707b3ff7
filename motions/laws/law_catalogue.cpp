// SPDX-License-Identifier: MIT
#include "motions/laws/law_catalogue.hpp"

#include "core/errors.hpp"
#include "core/numbers/polynomial.hpp"
#include "core/open_registry.hpp"
#include "core/text/list_text.hpp"
#include "core/text/names.hpp"
#include "motions/laws/harmonic_law.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Validation of a law that a program added.

// Of the size of a derivative: the round-off of sums of a few hundred products.
constexpr double law_rounding = 1e-9;
// Intervals between two breakpoints, in each of which the integral is checked.
constexpr int law_stretches = 16;
constexpr std::array<const char*, 4> derivative_words = {"y", "y'", "y''", "y'''"};

[[noreturn]] void refuse_law(const Law& law, const std::string& found, const std::string& allowed) {
    throw InputError(fmt::format("add_law: \"{}\": found {}; allowed: {}", law.key(), found, allowed));
}

void check_key(const Law& law) {
    if (!is_plain_name(law.key())) refuse_law(law, "this key", "lower case letters, digits and _");
}

void check_end(const Law& law, double x, std::size_t order, double wanted) {
    const double found = law.derivatives(x)[order];
    if (std::abs(found - wanted) <= law_rounding) return;
    refuse_law(law, fmt::format("{} = {} at x = {}", derivative_words[order], found, x),
               fmt::to_string(wanted));
}

struct LawStretch {
    double begin, end;
};

/// y^(order) over an interval against the integral of the next derivative.
void check_stretch(const Law& law, std::size_t order, const LawStretch& stretch) {
    const double half = 0.5 * (stretch.end - stretch.begin), middle = stretch.begin + half;
    double size = 1.0, integral = 0.0;
    for (const QuadraturePoint& point : gauss_legendre) {
        const double next = law.derivatives(middle + half * point.place)[order + 1];
        size = std::max(size, std::abs(next));
        integral += half * point.weight * next;
    }
    const double grown =
        law.derivatives(stretch.end, Side::left)[order] - law.derivatives(stretch.begin, Side::right)[order];
    if (std::abs(grown - integral) <= law_rounding * size) return;
    refuse_law(
        law,
        fmt::format("{} that grows by {:.12g} from x = {:.6g} to {:.6g}, where the integral of {} is {:.12g}",
                    derivative_words[order], grown, stretch.begin, stretch.end, derivative_words[order + 1],
                    integral),
        "consistent derivatives, with a breakpoint wherever a formula changes");
}

/// Throws InputError naming what does not hold: a plain key, the ends of a rise from rest to rest, consistent
/// derivatives.
void check_own_law(const Law& law) {
    check_key(law);
    check_end(law, 0.0, 0, 0.0);
    check_end(law, 1.0, 0, 1.0);
    check_end(law, 0.0, 1, 0.0);
    check_end(law, 1.0, 1, 0.0);
    const std::vector<double> breakpoints = law.breakpoints();
    for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
        const double width = (breakpoints[i + 1] - breakpoints[i]) / law_stretches;
        for (int k = 0; k < law_stretches; ++k) {
            const LawStretch stretch{breakpoints[i] + k * width, k == law_stretches - 1
                                                                     ? breakpoints[i + 1]
                                                                     : breakpoints[i] + (k + 1) * width};
            for (std::size_t order = 0; order < 3; ++order) check_stretch(law, order, stretch);
        }
    }
}

using std::numbers::pi;

constexpr const char* kHandbook = "Norton, Cam Design and Manufacturing Handbook";
constexpr const char* kFreudenstein = "Freudenstein, Int. J. Mech. Sci. 1 (1960)";

LawInfo make_info(const char* key, std::string title, const char* source, int continuity) {
    LawInfo info;
    info.key = key;
    info.title = std::move(title);
    info.source = source;
    info.continuity = continuity;
    return info;
}

void require(const char* law, const char* name, double found, std::pair<double, double> allowed) {
    if (found >= allowed.first && found <= allowed.second) return;
    throw InputError(fmt::format("{}: {} = {} found, allowed {} <= {} <= {}", law, name, found, allowed.first,
                                 name, allowed.second));
}

/// The pieces of [0, 1/2] given, those of [1/2, 1] by antisymmetry: y''(1 - x) = -y''(x).
std::vector<AccelerationPiece> antisymmetric(std::vector<AccelerationPiece> pieces) {
    for (std::size_t i = pieces.size(); i-- > 0;) {
        const AccelerationPiece& from = pieces[i];
        AccelerationPiece mirrored{1.0 - from.end, 1.0 - from.begin, -from.constant, {}};
        for (const HarmonicTerm& term : from.terms) {
            // sin w(length - t) and cos w(length - t) by the addition theorems; the shapes used here end
            // where w·length is a quarter or a half turn, whose sine and cosine are exact integers.
            const double quarters = std::round(term.frequency * (from.end - from.begin) / (0.5 * pi));
            const double sine = quarters == 1.0 ? 1.0 : 0.0, cosine = quarters == 1.0 ? 0.0 : -1.0;
            const double frequency = quarters * 0.5 * pi / (mirrored.end - mirrored.begin);
            mirrored.terms.push_back({frequency, term.sine * cosine - term.cosine * sine,
                                      -term.sine * sine - term.cosine * cosine});
        }
        pieces.push_back(std::move(mirrored));
    }
    return pieces;
}

std::unique_ptr<Law> polynomial(LawInfo info, const std::vector<double>& coefficients) {
    return std::make_unique<PolynomialLaw>(std::move(info), coefficients);
}

std::unique_ptr<Law> harmonic(LawInfo info, std::vector<AccelerationPiece> pieces) {
    return std::make_unique<HarmonicLaw>(std::move(info), std::move(pieces));
}

/// y = x - Σ amplitude[k] sin(2π (2k + 1) x), so y'' = Σ amplitude (2π (2k + 1))² sin.
std::unique_ptr<Law> odd_harmonics(LawInfo info, const std::vector<double>& amplitudes) {
    AccelerationPiece piece{0.0, 1.0, 0.0, {}};
    double frequency = 2.0 * pi;
    for (const double amplitude : amplitudes) {
        piece.terms.push_back({frequency, amplitude * frequency * frequency, 0.0});
        frequency += 4.0 * pi;
    }
    return harmonic(std::move(info), {piece});
}

std::unique_ptr<Law> mcv(LawInfo info, double a, double b) {
    info.parameters = {{"a", a}, {"b", b}};
    return harmonic(std::move(info), antisymmetric({quarter_sine_up(0.0, a, 1.0),
                                                    quarter_cosine_down(a, b, 1.0), zero_piece(b, 0.5)}));
}

/// The classical laws, a row a law; parameters Ta have their customary value 1/8.
std::vector<LawMaker> classical_laws() {
    const auto info = [](const char* key, const char* title, int continuity) {
        return make_info(key, title, kHandbook, continuity);
    };
    const auto pieces = [](const LawInfo& law, const std::vector<AccelerationPiece>& all) -> LawMaker {
        return [=] { return harmonic(law, all); };
    };
    const auto coefficients = [](const LawInfo& law, const std::vector<double>& all) -> LawMaker {
        return [=] { return polynomial(law, all); };
    };
    const auto sines = [](const LawInfo& law, const std::vector<double>& amplitudes) -> LawMaker {
        return [=] { return odd_harmonics(law, amplitudes); };
    };
    const auto constant_velocity = [](const LawInfo& law, double a, double b) -> LawMaker {
        return [=] { return mcv(law, a, b); };
    };
    const auto of_an_eighth = [](const auto& make) -> LawMaker { return [=] { return make(0.125); }; };
    const auto asymmetric = [](const LawMaker& make) -> LawMaker {
        return [=] { return make_asymmetric(make(), kCatalogueSplit); };
    };
    // y = (1 - cos πx) / 2 - (1 - cos 2πx) / 8: a dwell at x = 0, a turning point with y'' = -π² at x = 1.
    LawInfo double_harmonic =
        make_info("double_harmonic", "Double harmonic (one dwell)", "Rothbart, Cams (1956)", 3);
    double_harmonic.top = TopEnd::turning_point;
    // y = x. Its ends do not rest: it occurs only in programs, between splines that take its velocity.
    LawInfo moving = info("constant_velocity", "Constant velocity (programs only: its ends move)", 0);
    moving.rests = false;
    // y = 2x³ − x⁴, y'(1) = 2, and backwards y = 2x − 2x³ + x⁴: to and from a constant velocity.
    const auto run = [](const char* key, const char* title, const std::vector<double>& from_below,
                        const std::vector<double>& from_top) -> LawMaker {
        LawInfo law = make_info(key, title, "Quartic with y'' = 0 at both ends", 0);
        law.rests = false;
        return [=] { return std::make_unique<PolynomialLaw>(law, from_below, from_top); };
    };
    const double first = 1125.0 / (2384.0 * pi);  // of Freudenstein 1-3-5
    const LawMaker parabolic = pieces(info("parabolic", "Parabolic (constant acceleration)", 1),
                                      {constant_piece(0.0, 0.5, 1.0), constant_piece(0.5, 1.0, -1.0)}),
                   cycloidal = sines(info("cycloidal", "Cycloidal", 2), {1.0 / (2.0 * pi)}),
                   polynomial_345 =
                       coefficients(info("polynomial_345", "3-4-5 polynomial", 2), {0, 0, 0, 10, -15, 6}),
                   modified_sine = of_an_eighth(make_modified_sine),
                   modified_trapezoid = of_an_eighth(make_modified_trapezoid);
    return {
        parabolic,
        pieces(info("simple_harmonic", "Simple harmonic", 1), {half_cosine(0.0, 1.0, 1.0)}),
        cycloidal,
        polynomial_345,
        coefficients(info("polynomial_4567", "4-5-6-7 polynomial", 3), {0, 0, 0, 0, 35, -84, 70, -20}),
        coefficients(info("polynomial_56789", "5-6-7-8-9 polynomial", 4),
                     {0, 0, 0, 0, 0, 126, -420, 540, -315, 70}),
        modified_sine,
        modified_trapezoid,
        constant_velocity(info("mcv_50", "Modified constant velocity, 50 %", 2), 1.0 / 16.0, 0.25),
        constant_velocity(info("mcv_33", "Modified constant velocity, 33 %", 2), 1.0 / 12.0, 1.0 / 3.0),
        constant_velocity(info("mcv_20", "Modified constant velocity, 20 %", 2), 0.1, 0.4),
        pieces(info("cycloidal_cv50", "Cycloidal with 50 % constant velocity", 2),
               antisymmetric({half_sine(0.0, 0.25, 1.0), zero_piece(0.25, 0.5)})),
        sines(make_info("gutman_13", "Gutman 1-3", "Gutman, Product Engineering 32 (1961)", 2),
              {15.0 / (32.0 * pi), 1.0 / (96.0 * pi)}),
        sines(make_info("freudenstein_13", "Freudenstein 1-3", kFreudenstein, 2),
              {27.0 / (56.0 * pi), 1.0 / (168.0 * pi)}),
        sines(make_info("freudenstein_135", "Freudenstein 1-3-5", kFreudenstein, 2),
              {first, first / 54.0, first / 1250.0}),
        pieces(double_harmonic, {{0.0, 1.0, 0.0, {{pi, 0.0, 1.0}, {2.0 * pi, 0.0, -1.0}}}}),
        asymmetric(parabolic),
        asymmetric(cycloidal),
        asymmetric(polynomial_345),
        asymmetric(modified_sine),
        asymmetric(modified_trapezoid),
        of_an_eighth(make_one_dwell_modified_sine),
        of_an_eighth(make_one_dwell_modified_trapezoid),
        make_one_dwell_cycloidal,
        make_one_dwell_polynomial_345,
        make_one_dwell_polynomial_3456,
        run("run_in", "Run-in from rest to constant velocity (programs only)", {0, 0, 0, 2, -1},
            {1, -2, 0, 2, -1}),
        run("run_out", "Run-out from constant velocity to rest (programs only)", {0, 2, 0, -2, 1},
            {1, 0, 0, -2, 1}),
        coefficients(moving, {0, 1}),
    };
}

using Laws = OpenRegistry<LawInfo, LawMaker>;

Laws& laws() {
    static Laws all(&LawInfo::key, [] {
        Laws::Lists classical;
        classical.makers = classical_laws();
        for (const LawMaker& make : classical.makers) classical.descriptions.push_back(make()->info());
        return classical;
    }());
    return all;
}

}  // namespace

std::span<const LawInfo> law_catalogue() {
    return laws().descriptions();
}

void add_law(const LawMaker& make) {
    const std::unique_ptr<Law> law = make ? make() : nullptr;
    if (!law) throw InputError("add_law: found an empty function; allowed: a function that returns a law");
    check_own_law(*law);
    laws().add(law->info(), make, [&] {
        throw InputError(fmt::format(
            "add_law: found the key \"{}\", which another law has; allowed: a new one", law->key()));
    });
}

std::unique_ptr<Law> make_law(std::string_view key) {
    const Laws::Lists& known = laws().lists();
    for (std::size_t i = 0; i < known.descriptions.size(); ++i)
        if (known.descriptions[i].key == key) return known.makers[i]();
    throw InputError(fmt::format("motion law: \"{}\" found, allowed {}", key,
                                 listed(known.descriptions, ", ", &LawInfo::key)));
}

std::unique_ptr<Law> make_modified_sine(double ta) {
    require("modified_sine", "Ta", ta, {kNarrowestPiece, 0.25});
    LawInfo info = make_info("modified_sine", fmt::format("Modified sine (Ta = {})", ta),
                             "Schmidt; Norton, Cam Design and Manufacturing Handbook", 2);
    info.parameters = {{"Ta", ta}};
    AccelerationPiece last = quarter_cosine_down(1.0 - ta, 1.0, -1.0);
    return harmonic(std::move(info), {quarter_sine_up(0.0, ta, 1.0), half_cosine(ta, 1.0 - ta, 1.0), last});
}

std::unique_ptr<Law> make_modified_trapezoid(double ta) {
    require("modified_trapezoid", "Ta", ta, {kNarrowestPiece, 0.25});
    LawInfo info = make_info("modified_trapezoid", fmt::format("Modified trapezoid (Ta = {})", ta),
                             "Neklutin; Norton, Cam Design and Manufacturing Handbook", 2);
    info.parameters = {{"Ta", ta}};
    std::vector<AccelerationPiece> half{quarter_sine_up(0.0, ta, 1.0)};
    if (ta < 0.5 - ta) half.push_back(constant_piece(ta, 0.5 - ta, 1.0));
    half.push_back(quarter_cosine_down(0.5 - ta, 0.5, 1.0));
    return harmonic(std::move(info), antisymmetric(std::move(half)));
}

std::unique_ptr<Law> make_modified_constant_velocity(double a, double b) {
    require("modified_constant_velocity", "b", b, {2.0 * kNarrowestPiece, 0.5 - kNarrowestPiece});
    require("modified_constant_velocity", "a", a, {kNarrowestPiece, b - kNarrowestPiece});
    return mcv(make_info("modified_constant_velocity",
                         fmt::format("Modified constant velocity ({}, {})", a, b), kHandbook, 2),
               a, b);
}

}  // namespace camopt
