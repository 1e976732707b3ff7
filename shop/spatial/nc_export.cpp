// SPDX-License-Identifier: MIT
#include "report/spatial/indexing_body.hpp"
#include "report/view/shown_units.hpp"
#include "shop/nc/milling/groove_passes.hpp"
#include "shop/spatial/cam_export.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int checked_heights = 5;
constexpr int checked_angles = 360;
// Where the cutter has only begun, or has stopped, a flank is not finished: the roller's round end.
constexpr double end_share = 0.01;  // of the motion, left out at either end of an open path
constexpr double checked_step = 2.0 * units::degree, extension_step = 0.5 * units::degree;  // indexing cams

/// A point of the wanted surface, and the cam angle at which the roller leaves it.
struct LeftPoint {
    double theta = 0.0;
    Eigen::Vector3d point;
};

/// What is milled: a roller's way over the cam angle, all rollers of an index in one.
class MilledGroove {
 public:
    MilledGroove(const CamFlanks& cam, const FollowerMotion& motion, double floor)
        : cam_(cam), turn_(motion), way_(motion), floor_(floor) {
        if (!indexes(cam, motion)) return;
        indexing_.emplace(cam, motion, floor);
        way_ = indexing_->path();
    }

    [[nodiscard]] const FollowerMotion& way() const { return way_; }
    [[nodiscard]] RollerPath roller() const { return roller_path(cam_, way_); }
    [[nodiscard]] const std::optional<IndexingGroove>& indexing() const { return indexing_; }

    /// Both flanks at a height of the roller: those of an indexing cam as far as its body reaches.
    [[nodiscard]] std::vector<LeftPoint> flanks(double height) const {
        if (indexing_) return left_at({height / floor_, 5.0 - height / floor_});
        const RollerPath path = roller();
        const double radius = cam_.roller_radius, length = way_.end() - way_.begin();
        std::vector<LeftPoint> points;
        for (int k = 0; k <= checked_angles; ++k) {
            const double share = end_share + (1.0 - 2.0 * end_share) * k / checked_angles;
            const double theta = way_.begin() + share * length;
            const RollerPose at = path(theta, height);
            for (const int flank : {1, -1}) points.push_back({theta, at.center + flank * radius * at.normal});
        }
        return points;
    }
    /// Of an indexing cam.
    [[nodiscard]] std::vector<LeftPoint> floor() const { return left_at({1.5, 2.0, 2.5, 3.0, 3.5}); }

    /// From the groove's floor to where it leaves the body, along the cutter.
    [[nodiscard]] double greatest_depth() const {
        double depth = floor_;
        if (!indexing_) return depth;
        for (const double theta : angles_inside())
            for (const double near_end : {0.0, 5.0})
                if (indexing_->depth(indexing_->contact(theta, near_end)) > 0.0)
                    depth = std::max(depth, floor_ * (near_end == 0.0 ? 1.0 - indexing_->first(theta)
                                                                      : indexing_->last(theta) - 4.0));
        return depth;
    }

    [[nodiscard]] Blank extent() const {
        Blank extent{0.0, HUGE_VAL, -HUGE_VAL};
        if (indexing_) {
            const double lower = indexing_->lower(), upper = indexing_->upper();
            return {std::max(indexing_->outside(lower), indexing_->outside(upper)), lower, upper};
        }
        for (int i = 0; i < checked_heights; ++i)
            for (const LeftPoint& left : flanks(cam_.roller_length * i / (checked_heights - 1))) {
                extent.radius = std::max(extent.radius, left.point.head<2>().norm());
                extent.lower = std::min(extent.lower, left.point.z());
                extent.upper = std::max(extent.upper, left.point.z());
            }
        const DrumSize body = body_around({extent.radius, extent.lower, extent.upper}, cam_.body, 0.0);
        return {body.radius, body.lower, body.upper};
    }

    /// Of an indexing cam: the roller's way on to either side, to where a cutter stands clear of the blank.
    void extend_beyond(const Blank& blank, double distance) {
        const FollowerMotion all =
            rollers_as_one(turn_, way_.begin() - units::turn, way_.end() + units::turn);
        const RollerPath path = roller_path(cam_, all);
        const auto clear_from = [&](double begin, double step) {
            for (int k = 0; std::abs(k * step) < units::turn; ++k) {
                const RollerPose at = path(begin + k * step, floor_);
                if (distance_to_blank(blank, {at.center, at.axis}, cam_.roller_radius) > distance)
                    return begin + k * step;
            }
            throw InputError(
                fmt::format("milling: the cutter does not leave the blank ({}) by its ends; allowed: "
                            "a shorter blank",
                            words_of(blank)));
        };
        const double begin = clear_from(way_.begin(), -extension_step),
                     end = clear_from(way_.end(), extension_step);
        way_ = rollers_as_one(turn_, begin, end);
    }

 private:
    /// Of an indexing cam: evenly over the way of a roller through it.
    [[nodiscard]] std::vector<double> angles_inside() const {
        return even_angles(indexing_->path(),
                           1 + static_cast<int>(std::ceil(
                                   (indexing_->path().end() - indexing_->path().begin()) / checked_step)));
    }
    [[nodiscard]] std::vector<LeftPoint> left_at(const std::vector<double>& places) const {
        std::vector<LeftPoint> points;
        for (const double theta : angles_inside()) {
            for (const double t : places) {
                Eigen::Vector3d point = indexing_->contact(theta, t);
                // A near end outside of the body: where the flank begins.
                if (indexing_->depth(point) < 0.0)
                    point =
                        indexing_->contact(theta, t < 1.0 ? indexing_->first(theta) : indexing_->last(theta));
                if (point.z() > indexing_->lower() && point.z() < indexing_->upper())
                    points.push_back({theta, point});
            }
        }
        return points;
    }

    const CamFlanks& cam_;
    FollowerMotion turn_, way_;
    double floor_ = 0.0;
    std::optional<IndexingGroove> indexing_;
};

Blank blank_of(const MilledGroove& groove, const CamFlanks& cam, const BlankChoice& choice) {
    Blank extent = groove.extent();
    double deepest = HUGE_VAL;  // radius
    for (const LeftPoint& left : groove.flanks(cam.roller_length))
        deepest = std::min(deepest, left.point.head<2>().norm());
    extent.radius += choice.allowance;
    extent.lower -= choice.allowance;
    extent.upper += choice.allowance;
    Blank blank = chosen_blank(extent, choice);
    if (blank.radius <= deepest)
        throw InputError(fmt::format("blank: {} ends above the groove, whose least radius is {:.3f} mm",
                                     words_of(blank), millimetres_shown.of(deepest)));
    return blank;
}

/// What a cutter that stands where the roller leaves each point leaves of it at most.
double most_stock(const std::vector<LeftPoint>& points, const MilledGroove& groove, CutterLocation location,
                  const CutterShape& cutter) {
    const RollerPath roller = groove.roller();
    double most = 0.0;
    for (const LeftPoint& left : points) {
        double least = HUGE_VAL;
        for (const int flank : {1, -1}) {
            location.flank = flank;
            least =
                std::min(least, cutter_clearance(cutter_pose(roller(left.theta, location.station), location),
                                                 cutter, left.point));
        }
        most = std::max(most, least);
    }
    return most;
}

}  // namespace

std::unique_ptr<Machine> machine_for(const CamFlanks& cam, double z_offset) {
    if (cam.arc) return table_tilting_machine(z_offset);
    return rotary_table_machine();
}

NcWork nc_work(const CamFlanks& cam, const FollowerMotion& motion, const NcExportOptions& options) {
    const double working_length = cam.roller_length + options.tip_beyond;
    MilledGroove groove(cam, motion, working_length);
    CutterLocation location;
    location.roller_radius = cam.roller_radius;
    location.diameter = options.cutter_diameter.value_or(2.0 * location.roller_radius);
    location.stock = options.stock;
    location.station = cam.roller_length;
    location.tip_beyond = options.tip_beyond;

    NcWork work;
    NcJob& job = work.job;
    job = milling_job(options, blank_of(groove, cam, options.blank), location.diameter,
                      groove.greatest_depth());
    job.remarks = {"origin: the centre of the cam; turn 0: its cam angle 0"};
    if (cam.arc && options.z_offset != 0.0)
        job.remarks.push_back(
            fmt::format("offset: {} mm are subtracted from Z", millimetres_shown.of(options.z_offset)));
    job.rotary_speed = options.rotary_speed;
    if (groove.indexing()) {
        groove.extend_beyond(job.blank, options.safe_distance);
        job.remarks.push_back("finished cam: turned outside of the groove, " +
                              groove.indexing()->turned_words());
    }

    CuttingTask& task = work.task;
    add_groove(work, {groove.roller(), groove.way().breakpoints, location, groove.greatest_depth()}, options);
    task.blocks.count = options.blocks;
    const auto add_surface = [&](const std::string& name, const std::vector<LeftPoint>& points) {
        WantedSurface& surface = task.surfaces.emplace_back();
        surface.name = name;
        for (const LeftPoint& left : points) surface.points.push_back(left.point);
        surface.most_stock = most_stock(points, groove, location, task.cutter);
    };
    for (int i = 0; i < checked_heights; ++i) {
        const double height = cam.roller_length * i / (checked_heights - 1);
        add_surface(fmt::format("both flanks, {:.3f} mm from the near end of the roller",
                                millimetres_shown.of(height)),
                    groove.flanks(height));
        if (i > 0 && i + 1 < checked_heights) continue;
        for (const std::size_t flank : {std::size_t{0}, std::size_t{1}}) {
            std::vector<Eigen::Vector3d>& line = task.outlines.emplace_back();
            for (std::size_t k = flank; k < task.surfaces.back().points.size(); k += 2)
                line.push_back(task.surfaces.back().points[k]);
        }
    }
    if (groove.indexing()) add_surface("the floor of the groove", groove.floor());
    return work;
}

RollerPath roller_path(const CamFlanks& cam, const FollowerMotion& motion) {
    return [cam, motion](double theta, double station) {
        const FollowerState state = motion.state(theta);
        const FlankPoint point = cam.point(theta, state, {station, 1});
        return RollerPose{point.center, cam.axis(theta, state.s).direction, point.normal};
    };
}

}  // namespace camopt
