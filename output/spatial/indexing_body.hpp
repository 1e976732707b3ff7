// SPDX-License-Identifier: MIT
// The body of an indexing cam: the thread that two neighbouring rollers of the index hold between them, and
// the hub under it.
//
// While one roller moves from q to q + pitch the next one moves from q + pitch to q + 2 pitch, so the thread
// that leads into the dwell is the one that leads out of it a turn later: one body of more than a turn, in
// the cam frame. Its sides are flank points of both rollers. How far it reaches and how thick the hub is are
// choices of drawing, not of the mechanism. m, rad.
#pragma once

#include "output/surface/mesh_svg.hpp"
#include "output/surface/triangle_mesh.hpp"
#include "profiles/spatial/follower_motion.hpp"
#include "profiles/spatial/spatial_cam.hpp"

#include <vector>

namespace camopt {

struct IndexingBody {
    TriangleMesh thread, hub;  ///< two solids that overlap
    TriangleMesh rollers;      ///< those that hold the thread where the motion begins
};

struct IndexingBodyOptions {
    int angles = 160;     ///< sections over one turn; >= 16
    int heights = 5;      ///< along the roller; >= 2
    double reach = 0.45;  ///< part of a pitch that the thread goes beyond the dwell's rollers, 0 … 0.9
    /// The thread's foot lies within the hub, so that both are one solid; a picture wants it on its surface.
    bool foot_on_hub = false;

    void validate() const;  ///< throws InputError
};

/// motion: one whole turn over which s grows by the pitch of the rollers. Throws InputError for another.
[[nodiscard]] IndexingBody indexing_body(const SpatialCam& cam, const FollowerMotion& motion,
                                         const IndexingBodyOptions& options = {});

/// Coloured for mesh_svg.
[[nodiscard]] std::vector<PaintedMesh> painted(const IndexingBody& body);

}  // namespace camopt
