// SPDX-License-Identifier: MIT
// Laws made from other laws: with unequal parts, and for cams with one dwell.
#include "core/errors.hpp"
#include "motions/laws/harmonic_law.hpp"
#include "motions/laws/law_catalogue.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// Tolerance on a sum of symmetric derivatives, or on a jump of one, as a part of the law's largest
/// derivative of that order: closed forms have round-off of some 1e-14.
constexpr double same_split = 1e-10;
/// Samples in a half for the test of symmetry; the fastest wave of the catalogue has 10 half waves.
constexpr int kPlaces = 128;

/// Largest magnitude of each derivative of the law, from both sides of the samples.
LawDerivatives scales(const Law& law) {
    LawDerivatives scale{};
    for (int i = 0; i <= 2 * kPlaces; ++i) {
        for (const Side side : {Side::left, Side::right}) {
            const LawDerivatives y = law.derivatives(0.5 * i / kPlaces, side);
            for (std::size_t r = 0; r < scale.size(); ++r) scale[r] = std::max(scale[r], std::abs(y[r]));
        }
    }
    return scale;
}

bool is_antisymmetric(const Law& law, const LawDerivatives& scale) {
    for (int i = 0; i <= kPlaces; ++i) {
        const double x = 0.5 * i / kPlaces;
        const LawDerivatives low = law.derivatives(x, Side::left);
        const LawDerivatives high = law.derivatives(1.0 - x, Side::right);
        if (std::abs(low[0] + high[0] - 1.0) > same_split) return false;
        for (std::size_t r = 1; r < 3; ++r) {
            const double mirrored = r == 1 ? low[r] - high[r] : low[r] + high[r];
            if (std::abs(mirrored) > same_split * scale[r]) return false;
        }
        if (low[2] < -same_split * scale[2]) return false;
    }
    return true;
}

void require_suitable(const std::unique_ptr<Law>& law, double split) {
    if (!law) throw InputError("asymmetric law: no law found, allowed an antisymmetric law");
    if (law->info().top != TopEnd::dwell || !is_antisymmetric(*law, scales(*law)))
        throw InputError(fmt::format(
            "asymmetric law: {} found, allowed a rise between dwells with y(x) + y(1 - x) = 1 and y'' >= 0 "
            "on its first half",
            law->key()));
    if (!(split >= kNarrowestPart && split <= 1.0 - kNarrowestPart))
        throw InputError(fmt::format("asymmetric_{}: split = {} found, allowed {} <= split <= {}", law->key(),
                                     split, kNarrowestPart, 1.0 - kNarrowestPart));
}

/// y, y', … of a part whose x and y are `stretch` times those of f, except for the constant of y.
template <class T>
std::array<T, 5> stretched(std::array<T, 5> y, double stretch) {
    double factor = stretch;
    for (T& value : y) {
        value = value * T(factor);
        factor /= stretch;
    }
    return y;
}

/// The highest derivative that is continuous where the parts meet, at most that of the law itself.
int continuity_of(const Law& law, double split) {
    const LawDerivatives before = stretched(law.derivatives(0.5, Side::left), 2.0 * split);
    const LawDerivatives after = stretched(law.derivatives(0.5, Side::right), 2.0 * (1.0 - split));
    const LawDerivatives scale = scales(law);
    for (int r = 2; r <= law.continuity(); ++r) {
        const auto i = static_cast<std::size_t>(r);
        if (std::abs(after[i] - before[i]) > same_split * scale[i]) return r - 1;
    }
    return law.continuity();
}

LawInfo asymmetric_info(const std::unique_ptr<Law>& law, double split) {
    require_suitable(law, split);
    LawInfo info = law->info();
    info.key = "asymmetric_" + info.key;
    // The law's own parameters, in brackets in its title, stand among the parameters.
    info.title = fmt::format("{}, split {:.4g}/{:.4g}", info.title.substr(0, info.title.find(" (")), split,
                             1.0 - split);
    info.source = fmt::format("standard construction from the law of {}", info.source);
    info.continuity = continuity_of(*law, split);
    info.parameters.push_back({"split", split});
    return info;
}

using std::numbers::pi;
using std::numbers::sqrt2;

constexpr double kWidestSine = 1.0 - 0.5 * sqrt2;
constexpr double kWidestTrapezoid = pi / (3.0 * pi + 2.0);

LawInfo one_dwell(const char* key, std::string title) {
    LawInfo info;
    info.key = key;
    info.title = std::move(title);
    info.source = "standard construction";
    info.continuity = 2;
    info.top = TopEnd::turning_point;
    return info;
}

LawInfo one_dwell(const char* key, const char* title, double ta, double widest) {
    if (!(ta >= kNarrowestPiece && ta <= widest))
        throw InputError(
            fmt::format("{}: Ta = {} found, allowed {} <= Ta <= {}", key, ta, kNarrowestPiece, widest));
    LawInfo info = one_dwell(key, fmt::format("{} (one dwell, Ta = {})", title, ta));
    info.parameters = {{"Ta", ta}};
    return info;
}

}  // namespace

AsymmetricLaw::AsymmetricLaw(std::unique_ptr<Law> base, double split)
    : Law(asymmetric_info(base, split)), base_(std::move(base)), split_(split) {
    std::vector<double> places = base_->breakpoints();
    const auto middle = std::lower_bound(places.begin(), places.end(), 0.5);
    if (*middle != 0.5) places.insert(middle, 0.5);
    const auto place_of = [split](double u) {
        return u <= 0.5 ? 2.0 * split * u : 1.0 - 2.0 * (1.0 - split) * (1.0 - u);
    };
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const double begin = pieces_.empty() ? 0.0 : pieces_.back().end;
        pieces_.push_back({begin, place_of(places[i + 1]), places[i], places[i + 1]});
    }
}

std::vector<double> AsymmetricLaw::breakpoints() const {
    std::vector<double> result{0.0};
    for (const Piece& piece : pieces_) result.push_back(piece.end);
    return result;
}

LawDerivatives AsymmetricLaw::evaluate(double x, Side side) const {
    const auto holds = [x, side](const Piece& piece) {
        return side == Side::right ? x < piece.end : x <= piece.end;
    };
    const auto found = std::find_if(pieces_.begin(), pieces_.end(), holds);
    const Piece& piece = found == pieces_.end() ? pieces_.back() : *found;
    const double u = base_place(piece, x);
    // Rounding of u must not lead to the neighbouring piece of the base law.
    return of_base(piece, base_->derivatives(u, u == piece.base_end ? Side::left : Side::right));
}

std::optional<std::array<Interval, 5>> AsymmetricLaw::ranges(const Interval& x) const {
    const double middle = 0.5 * (x.lower + x.upper);
    const auto found =
        std::ranges::find_if(pieces_, [middle](const Piece& piece) { return middle < piece.end; });
    const Piece& piece = found == pieces_.end() ? pieces_.back() : *found;
    const auto base = base_->ranges({base_place(piece, x.lower), base_place(piece, x.upper)});
    if (!base) return {};
    return of_base(piece, *base);
}

double AsymmetricLaw::base_place(const Piece& piece, double x) const {
    const double stretch = stretch_of(piece);
    return std::clamp(accelerates(piece) ? x / stretch : 1.0 - (1.0 - x) / stretch, piece.base_begin,
                      piece.base_end);
}

template <class T>
std::array<T, 5> AsymmetricLaw::of_base(const Piece& piece, std::array<T, 5> y) const {
    if (accelerates(piece)) return stretched(y, stretch_of(piece));
    y[0] = y[0] - T(1.0);
    y = stretched(y, stretch_of(piece));
    y[0] = y[0] + T(1.0);
    return y;
}

std::unique_ptr<Law> make_asymmetric(std::unique_ptr<Law> law, double split) {
    return std::make_unique<AsymmetricLaw>(std::move(law), split);
}

std::unique_ptr<Law> make_one_dwell_modified_sine(double ta) {
    LawInfo info = one_dwell("one_dwell_modified_sine", "Modified sine", ta, kWidestSine);
    const double zero = 1.0 / (2.0 - ta), deceleration = 1.0 / (1.0 - ta);
    return std::make_unique<HarmonicLaw>(
        std::move(info),
        std::vector<AccelerationPiece>{quarter_sine_up(0.0, ta, 1.0), quarter_cosine_down(ta, zero, 1.0),
                                       quarter_sine_up(zero, 1.0, -deceleration)});
}

std::unique_ptr<Law> make_one_dwell_cycloidal() {
    const double zero = 2.0 - sqrt2;
    return std::make_unique<HarmonicLaw>(
        one_dwell("one_dwell_cycloidal", "Cycloidal (one dwell)"),
        std::vector<AccelerationPiece>{half_sine(0.0, zero, 1.0), quarter_sine_up(zero, 1.0, -sqrt2)});
}

std::unique_ptr<Law> make_one_dwell_modified_trapezoid(double ta) {
    LawInfo info = one_dwell("one_dwell_modified_trapezoid", "Modified trapezoid", ta, kWidestTrapezoid);
    // A width within the narrowest piece of the maximum is set to the maximum.
    const bool flat = kWidestTrapezoid - ta >= kNarrowestPiece;
    if (!flat) ta = kWidestTrapezoid;
    const double zero = flat ? 0.5 + ta * (0.5 - 1.0 / pi) : 2.0 * ta;
    const double ramp = flat ? zero - ta : ta;
    std::vector<AccelerationPiece> pieces{quarter_sine_up(0.0, ta, 1.0)};
    if (flat) pieces.push_back(constant_piece(ta, ramp, 1.0));
    pieces.push_back(half_cosine(ramp, zero + ta, 1.0));
    pieces.push_back(constant_piece(zero + ta, 1.0, -1.0));
    return std::make_unique<HarmonicLaw>(std::move(info), std::move(pieces));
}

std::unique_ptr<Law> make_one_dwell_polynomial_345() {
    const double third = 1.0 / 3.0;
    return std::make_unique<PolynomialLaw>(
        one_dwell("one_dwell_polynomial_345", "3-4-5 polynomial (one dwell)"),
        std::vector<double>{0, 0, 0, 20 * third, -25 * third, 8 * third},
        std::vector<double>{1, 0, -10 * third, 0, 5, -8 * third});
}

std::unique_ptr<Law> make_one_dwell_polynomial_3456() {
    return std::make_unique<PolynomialLaw>(
        one_dwell("one_dwell_polynomial_3456", "3-4-5-6 polynomial (one dwell)"),
        std::vector<double>{0, 0, 0, 8, -12, 6, -1}, std::vector<double>{1, 0, -3, 0, 3, 0, -1});
}

}  // namespace camopt
