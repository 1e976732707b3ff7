// SPDX-License-Identifier: MIT
// How reports present a cam: one row for each capability that decides it (scene/cam_capabilities.hpp), with
// the words for people, the words of its picture, and the names of its files. Reports ask for the row of a
// cam and for no kind.
#pragma once

#include "scene/cam_mechanism.hpp"

namespace camopt {

/// What a file shows.
enum class CamView { table, picture, diagram };

struct CamFileRow {
    CamView view = CamView::table;
    const char* name = nullptr;  ///< "profile.svg"
    const char* title = "";      ///< as the report names a picture: "The cam to scale"
    const char* curves = "";     ///< diagram: the keys of its curves begin with this
    int station = 0;             ///< table: whose points; left out if the cam has no such station
    bool both_walls = false;     ///< table: of stations 0 and 1, the walls of a slot, in one
};

/// What a picture to scale shows of the cam.
enum class CamOutline {
    round,  ///< the outline about the cam's centre, with circles, angles and the sense of rotation
    slot,   ///< a slot in a body, with its roller at both ends
    plate   ///< a body with the outline above, sides and a bottom, and the direction of its travel
};

/// Words of a picture to scale, and what it shows.
struct CamPictureRow {
    const char* untitled = "";                                       ///< title of a scene without one
    const char* frame = "";                                          ///< of its axes
    const char *links = "", *roller = "", *guide = "", *ghost = "";  ///< in its legend
    CamOutline outline = CamOutline::round;
};

/// Of a forward check, for the sentence that reports it.
struct CheckWords {
    int points = 0;
    std::string found;            ///< "moves as designed within 1e-9 mm"
    std::string relative, where;  ///< as a part of the prime radius; deg
};

struct CamPresentation {
    bool (*fits)(const DrivenMechanism& cam) = nullptr;
    const char* touching = "roller";  ///< what touches the cam
    /// Why undercut must be avoided, and a change that helps: "the cam intersects itself there; … . A smaller
    /// roller helps".
    std::string (*undercut)(const CamMechanism& cam) = nullptr;
    /// What the forward check ran and found: "lever and linkage run over 6000 points of the cam: the output
    /// moves as designed within 1e-9 mm (at 40 deg)"
    std::string (*check)(const DrivenMechanism& cam, const CheckWords& words) = nullptr;
    CamPictureRow picture = {};
    std::vector<CamFileRow> files = {};
};

/// The first row that fits.
[[nodiscard]] const CamPresentation& presentation_of(const DrivenMechanism& cam);
[[nodiscard]] std::span<const CamPresentation> cam_presentations();

/// How a direct cam holds its follower, after the follower's name: "in a groove"; empty: it is open.
[[nodiscard]] std::string form_words(const DirectCamDrawing& drawing);

}  // namespace camopt
