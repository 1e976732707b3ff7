// SPDX-License-Identifier: MIT
#include "motions/laws/derived_laws.hpp"

#include "core/errors.hpp"

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

LawInfo reversed_info(const Law& law) {
    LawInfo info = law.info();
    info.key = std::string(kReversed) + info.key;
    return info;
}

/// From its end to its begin.
class ReversedLaw final : public Law {
 public:
    explicit ReversedLaw(std::shared_ptr<const Law> base)
        : Law(reversed_info(*base)), base_(std::move(base)), base_places_(base_->breakpoints()) {
        std::ranges::reverse(base_places_);
        for (const double place : base_places_) places_.push_back(1.0 - place);
    }

    [[nodiscard]] std::vector<double> breakpoints() const override { return places_; }
    [[nodiscard]] std::optional<std::array<Interval, 5>> ranges(const Interval& x) const override {
        const auto base = base_->ranges({1.0 - x.upper, 1.0 - x.lower});
        if (!base) return {};
        return reversed(*base);
    }

 private:
    [[nodiscard]] LawDerivatives evaluate(double x, Side side) const override {
        std::size_t piece = 0;
        while (piece + 2 < places_.size() &&
               (side == Side::right ? x >= places_[piece + 1] : x > places_[piece + 1]))
            ++piece;
        // Rounding of 1 - x must not lead to a neighbouring piece of f.
        const double end = base_places_[piece], u = std::clamp(1.0 - x, base_places_[piece + 1], end);
        return reversed(base_->derivatives(u, u == end ? Side::left : Side::right));
    }
    template <class T>
    [[nodiscard]] static std::array<T, 5> reversed(const std::array<T, 5>& y) {
        return {T(1.0) - y[0], y[1], -y[2], y[3], -y[4]};
    }

    std::shared_ptr<const Law> base_;
    std::vector<double> places_, base_places_;  ///< breakpoints, and those of f that they are made of
};

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

std::unique_ptr<Law> make_reversed(std::shared_ptr<const Law> law) {
    return std::make_unique<ReversedLaw>(std::move(law));
}

}  // namespace camopt
