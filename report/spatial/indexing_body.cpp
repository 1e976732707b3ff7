// SPDX-License-Identifier: MIT
// The groove's surface and the lands between its windings reach beyond both ends; planes cut them off.
#include "report/spatial/indexing_body.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "report/surface/mesh_cut.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector3d;
using Line = std::vector<Vector3d>;

constexpr int lines_to_bore = 4;    // sections for a corner of the bore
constexpr double bore_part = 0.35;  // of the groove's least radius
constexpr int roller_corners = 40;

/// A place of the body's outside, the polar angle unwound; the point itself where it is the top of a flank.
struct Place {
    double z = 0.0, polar = 0.0;
    std::optional<Vector3d> point = {};
};
Place between(const Place& a, const Place& b, double share) {
    return {a.z + share * (b.z - a.z), a.polar + share * (b.polar - a.polar), {}};
}
using Tops = std::array<Place, 2>;  // of the first and the last flank of a line

Place place_of(const Vector3d& point) {
    return {point.z(), std::atan2(point.y(), point.x()), point};
}

/// Lines of contact and lands at every angle, as strips of a surface that reaches beyond the body's ends.
class Surface {
 public:
    Surface(const IndexingGroove& groove, const FollowerMotion& motion, const IndexingBodyOptions& options)
        : groove_(groove), across_(2 * options.points) {
        const double begin = motion.begin(), step = units::turn / options.angles;
        std::vector<double> angles(motion.breakpoints.begin(), motion.breakpoints.end() - 1);
        for (int k = 0; k < options.angles; ++k) {
            const double angle = begin + units::turn * k / options.angles;
            if (std::ranges::none_of(motion.breakpoints,
                                     [&](double b) { return std::abs(b - angle) < least_step; }))
                angles.push_back(angle);
        }
        std::ranges::sort(angles);
        turn_ = static_cast<int>(angles.size());
        std::vector<double> parts;
        for (int k = 0; k <= options.points; ++k) parts.push_back(static_cast<double>(k) / options.points);
        for (int k = 1; k < across_; ++k) parts.push_back(1.0 + 3.0 * k / across_);
        for (int k = 0; k <= options.points; ++k)
            parts.push_back(4.0 + static_cast<double>(k) / options.points);
        const int first = static_cast<int>(std::floor((groove.path().begin() - step - begin) / units::turn));
        const int last = static_cast<int>(std::floor((groove.path().end() + step - begin) / units::turn));
        for (int turn = first; turn <= last; ++turn)
            for (const double angle : angles) {
                const double phi = angle + turn * units::turn;
                if (phi < groove.path().begin() - step || phi > groove.path().end() + step) continue;
                add_line(phi, parts);
            }
        if (count() <= turn_) throw InputError("indexing cam: a roller is in the cam for less than a turn");
    }

    [[nodiscard]] TriangleMesh mesh() const {
        TriangleMesh all;
        add_strip(all, lines_);
        // From where the groove came in, between its windings, to where it leaves.
        std::vector<Line> lands;
        const Tops &came = tops_.front(), &leaves = tops_.back();
        const double turned = std::copysign(units::turn, tops_[1].front().polar - came.front().polar);
        const Place came_later{came.back().z, came.back().polar + turned, {}};
        const Place leaves_before{leaves.front().z, leaves.front().polar - turned, {}};
        for (int n = -turn_; n < count(); ++n) {
            const int next = n + turn_, beyond = next - count() + 1;
            const Place from = n < 0 ? between(came.front(), came_later, share_of(next)) : tops_[n].back();
            const Place to =
                beyond > 0 ? between(leaves_before, leaves.back(), share_of(beyond)) : tops_[next].front();
            lands.push_back(land(from, to));
        }
        add_strip(all, lands);
        return all;
    }
    [[nodiscard]] double least_radius() const { return least_radius_; }

 private:
    static constexpr double least_step = 1e-6;  // rad

    [[nodiscard]] int count() const { return static_cast<int>(lines_.size()); }
    [[nodiscard]] double share_of(int steps) const { return static_cast<double>(steps) / turn_; }

    void add_line(double phi, const std::vector<double>& parts) {
        const double from = groove_.first(phi), to = groove_.last(phi);
        Line& line = lines_.emplace_back();
        for (const double t : parts) {
            // The whole flank below its top.
            const double place = t < 1.0   ? from + t * (1.0 - from)
                                 : t > 4.0 ? 4.0 + (t - 4.0) * (to - 4.0)
                                           : t;
            line.push_back(groove_.contact(phi, place));
            least_radius_ = std::min(least_radius_, line.back().head<2>().norm());
        }
        Tops tops{place_of(line.front()), place_of(line.back())};
        // Unwound: the first top from the one before, the last from the first.
        if (!tops_.empty())
            tops[0].polar += units::turn * std::round((tops_.back()[0].polar - tops[0].polar) / units::turn);
        tops[1].polar += units::turn * std::round((tops[0].polar - tops[1].polar) / units::turn);
        tops_.push_back(tops);
    }
    /// Along the body's outside, along the cam where it leaves a groove.
    [[nodiscard]] Line land(const Place& from, const Place& to) const {
        const double turned = std::remainder(to.polar - from.polar, units::turn);
        Line line;
        for (int k = 0; k <= across_; ++k) {
            const double share = static_cast<double>(k) / across_;
            const double z = from.z + share * (to.z - from.z), radius = groove_.outside(z);
            const double polar = from.polar + share * share * (3.0 - 2.0 * share) * turned;
            line.emplace_back(radius * std::cos(polar), radius * std::sin(polar), z);
        }
        line.front() = from.point.value_or(line.front());
        line.back() = to.point.value_or(line.back());
        return line;
    }
    static void add_strip(TriangleMesh& mesh, const std::vector<Line>& lines) {
        SurfaceGrid grid;
        for (std::size_t i = 0; i < lines.front().size(); ++i) grid.u.push_back(static_cast<double>(i));
        for (std::size_t k = 0; k < lines.size(); ++k) {
            grid.v.push_back(static_cast<double>(k));
            grid.points.insert(grid.points.end(), lines[k].begin(), lines[k].end());
        }
        append(mesh, mesh_of(grid));
    }

    const IndexingGroove& groove_;
    int across_ = 0;  // steps across a floor or a land
    int turn_ = 0;    // lines in a turn
    double least_radius_ = HUGE_VAL;
    std::vector<Line> lines_;
    std::vector<Tops> tops_;
};

}  // namespace

void IndexingBodyOptions::validate() const {
    if (angles < 16) throw InputError(fmt::format("indexing body: angles must be >= 16, found {}", angles));
    if (points < 2) throw InputError(fmt::format("indexing body: points must be >= 2, found {}", points));
}

TriangleMesh indexing_body(const CamFlanks& cam, const FollowerMotion& motion,
                           const IndexingBodyOptions& options) {
    options.validate();
    const IndexingGroove groove(cam, motion, cam.roller_length + floor_clearance);
    const Surface surface(groove, motion, options);
    const double bore = cam.body.bore ? 0.5 * *cam.body.bore : bore_part * surface.least_radius();
    return bored_solid(surface.mesh(),
                       {groove.lower(), groove.upper(), bore, options.angles / lines_to_bore});
}

std::optional<TriangleMesh> drawn_indexing_body(const CamFlanks& cam, const FollowerMotion& motion,
                                                const IndexingBodyOptions& options) {
    try {
        return indexing_body(cam, motion, options);
    } catch (const InputError&) {
        return {};
    }
}

TriangleMesh holding_rollers(const CamFlanks& cam, const FollowerMotion& motion) {
    const double theta = motion.begin(), pitch = motion.state(motion.end()).s - motion.state(theta).s;
    TriangleMesh all;
    for (const int index : {0, 1}) {
        const RollerAxis axis = cam.axis(theta, motion.state(theta).s + index * pitch);
        const Vector3d across = axis.direction.cross(axis.travel);
        std::vector<Line> sections;
        for (const double h : {-0.35, 0.0, 0.5, 1.0}) {
            Line circle;
            for (int i = 0; i < roller_corners; ++i) {
                const double angle = units::turn * i / roller_corners;
                circle.push_back(axis.foot + h * cam.roller_length * axis.direction +
                                 (cam.roller_radius - 0.5 * cam.clearance) *
                                     (std::cos(angle) * axis.travel + std::sin(angle) * across));
            }
            sections.push_back(circle);
        }
        append(all, swept_solid(sections, false));
    }
    return all;
}

}  // namespace camopt
