// SPDX-License-Identifier: MIT
// The body of an indexing cam as a solid: what is turned (indexing_groove.hpp), less the way of every roller.
//
// Vertices of flanks and floors lie on the true surface: they are points of lines along which a roller
// touches. Between them the solid is as far off as a chord. The bore is a choice of drawing. m, rad.
#pragma once

#include "output/spatial/indexing_groove.hpp"
#include "output/surface/triangle_mesh.hpp"

#include <optional>

namespace camopt {

struct IndexingBodyOptions {
    int angles = 720;  ///< sections over one turn; >= 16
    int points = 12;   ///< along a flank, half of those across a floor or a rib; >= 2

    void validate() const;  ///< throws InputError
};

/// motion: one whole turn over which s grows by the pitch of the rollers. Throws InputError for another, and
/// for rollers that do not leave the cam by its ends.
[[nodiscard]] TriangleMesh indexing_body(const CamFlanks& cam, const FollowerMotion& motion,
                                         const IndexingBodyOptions& options = {});

/// The same for pictures; none where rollers do not leave the cam by its ends.
[[nodiscard]] std::optional<TriangleMesh> drawn_indexing_body(const CamFlanks& cam,
                                                              const FollowerMotion& motion,
                                                              const IndexingBodyOptions& options);

/// The two rollers that hold the rib where the motion begins.
[[nodiscard]] TriangleMesh holding_rollers(const CamFlanks& cam, const FollowerMotion& motion);

}  // namespace camopt
