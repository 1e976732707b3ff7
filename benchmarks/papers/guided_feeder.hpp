// SPDX-License-Identifier: MIT
// The whole machine of the paper on inverse cams: the roller pushes, the guide swings the body, the rocker
// moves the feeder.
#pragma once

#include "benchmarks/papers/guide.hpp"

namespace camopt {

// Strokes of the roller, one after the other. Errors: InputError where they do not follow one another in time
// or the roller jumps between them.
class RollerLaw {
 public:
    explicit RollerLaw(std::vector<RollerStroke> strokes);

    [[nodiscard]] double begin() const { return strokes_.front().begin; }
    [[nodiscard]] double end() const { return strokes_.back().end; }
    [[nodiscard]] const std::vector<RollerStroke>& strokes() const { return strokes_; }
    /// Where strokes meet, the one on `side`. Throws InputError outside [begin, end].
    [[nodiscard]] RollerState at(double time, Side side = Side::right) const;

 private:
    std::vector<RollerStroke> strokes_;
};

//   theta = -psi(L),  theta' = -psi' L',  theta'' = -(psi'' L'² + psi' L'')    (psi by L, the rest by time)

struct InverseState {
    InverseFault fault = InverseFault::none;
    RollerState roller;
    double pressure_angle = 0.0;  ///< mu, of the guide on the roller
    double curvature = 0.0;       ///< of the guide
    BodyMotion body;
    FeederMotion feeder;
};

/// At a joint of the guide the piece on `guide_side`, in the sense of growing L.
[[nodiscard]] InverseState inverse_state(const Guide& guide, const FeederLinkage& linkage,
                                         const RollerState& roller, Side guide_side = Side::right);

/// The body alone; the roller must be within the guide's reach (InputError).
[[nodiscard]] BodyMotion body_on_guide(const Guide& guide, const RollerState& roller,
                                       Side guide_side = Side::right);

}  // namespace camopt
