// SPDX-License-Identifier: MIT
#include "shop/nc/milling/groove_passes.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace camopt {

namespace {

constexpr double same_place = 1e-9;                // m: the groove closes
constexpr double small_angle = 1e-5;               // rad: for the direction of travel
constexpr double ramp_step = 0.5 * units::degree;  // of the ramp's blocks, rad: 1 µm where 0.8° leave that
constexpr double ramp_diameters = 5.0;             // of one way to or fro
constexpr int most_ramp_ways = 40, lead_blocks = 24, height_samples = 360;
constexpr double most_lead_share = 0.1;  // of the groove
constexpr double over_cut_layer = 2e-4;  // m: the ramp begins so far above the layer cut before

struct GrooveTask : GrooveMilling {
    MillingChoice choice;
    Blank blank;
};

/// The groove as the tool runs along it; `stock` is measured from the flank that is cut.
class Groove {
 public:
    Groove(const GrooveTask& milling, int flank, bool forward)
        : milling_(milling), flank_(flank), sense_(forward ? 1.0 : -1.0) {
        const double begin = milling.knots.front(), end = milling.knots.back();
        const RollerPose first = milling.roller(begin, 0.0), last = milling.roller(end, 0.0);
        closed_ = std::abs(end - begin - 2.0 * std::numbers::pi) < same_place &&
                  (first.center - last.center).norm() < same_place &&
                  (first.axis - last.axis).norm() < same_place;
        for (const double theta : milling.knots) knots_.push_back(sense_ * theta);
        std::ranges::sort(knots_);
    }

    [[nodiscard]] ToolPose at(double u, double stock, double lift) const {
        CutterLocation location = milling_.location;
        location.flank = flank_;
        location.stock = stock;
        double theta = sense_ * u;
        const double begin = milling_.knots.front(), end = milling_.knots.back();
        if (closed_)
            theta = theta < begin ? theta + 2.0 * std::numbers::pi
                    : theta > end ? theta - 2.0 * std::numbers::pi
                                  : theta;
        ToolPose pose = cutter_pose(milling_.roller(theta, location.station), location);
        pose.tip -= lift * pose.axis;
        return pose;
    }
    /// In the middle of the groove.
    [[nodiscard]] double middle() const {
        return milling_.location.roller_radius - 0.5 * milling_.location.diameter;
    }
    [[nodiscard]] bool closed() const { return closed_; }
    [[nodiscard]] int flank() const { return flank_; }
    [[nodiscard]] const std::vector<double>& knots() const { return knots_; }
    [[nodiscard]] double begin() const { return knots_.front(); }
    [[nodiscard]] double end() const { return knots_.back(); }
    /// How far the tip goes, m per rad.
    [[nodiscard]] double speed(double u) const {
        return (at(u + small_angle, middle(), 0.0).tip - at(u, middle(), 0.0).tip).norm() / small_angle;
    }
    /// From the tip at its depth up to where the blank ends, as the table stands.
    [[nodiscard]] double height(double u) const {
        const ToolPose pose = at(u, middle(), 0.0);
        return milling_.blank.support(-pose.axis) + pose.axis.dot(pose.tip);
    }

 private:
    GrooveTask milling_;  // of its own: paths outlive the maker
    int flank_;
    double sense_;
    bool closed_ = false;
    std::vector<double> knots_;
};

/// Does the tool climb on this flank when the cam angle grows? In the middle of the motion
/// (cutter_compensation.hpp).
bool climbs_forward(const GrooveTask& milling, int flank) {
    const double theta = 0.5 * (milling.knots.front() + milling.knots.back());
    const auto at = [&](double angle) { return milling.roller(angle, milling.location.station); };
    const Eigen::Vector3d way = at(theta + small_angle).center - at(theta - small_angle).center;
    const RollerPose roller = at(theta);
    const double turn = milling.choice.spindle == SpindleSense::clockwise ? 1.0 : -1.0;
    return turn * roller.axis.cross(flank * roller.normal).dot(way) < 0.0;
}

/// What the cutter leaves on either side in the middle of the groove.
double most_allowance(const GrooveTask& milling) {
    return std::max(milling.location.roller_radius - 0.5 * milling.location.diameter - milling.location.stock,
                    0.0);
}

class GroovePassMaker {
 public:
    explicit GroovePassMaker(const GrooveTask& milling) : milling_(milling) {
        for (const int flank : is_slot() ? std::vector{1} : std::vector{1, -1}) {
            const bool forward = is_slot() || climbs_forward(milling, flank) == milling.choice.climbs();
            grooves_.emplace_back(milling, flank, forward);
        }
    }

    [[nodiscard]] MillingPasses made() {
        MillingPasses result;
        double cut_to = HUGE_VAL;  // lift of the deepest layer in the middle of the groove
        if (!milling_.choice.full_depth) cut_to = add_roughing(result);
        for (const Groove& groove : grooves_) {
            const std::string name = is_slot() ? "both flanks" : fmt::format("flank {:+d}", groove.flank());
            result.passes.push_back(pass(name, groove, milling_.location.stock, 0.0, cut_to));
        }
        warn_of_slots(result.passes.front());
        describe(result.remarks);
        return result;
    }

 private:
    [[nodiscard]] bool is_slot() const { return milling_.location.makes_both_flanks(); }

    [[nodiscard]] double greatest_height() const {
        const Groove& groove = grooves_.front();
        double height = 0.0;
        for (int k = 0; k <= height_samples; ++k)
            height = std::max(
                height, groove.height(groove.begin() + (groove.end() - groove.begin()) * k / height_samples));
        return height;
    }
    /// Every layer begins with a slot.
    void warn_of_slots(CuttingPass& first) const {
        const MillingChoice& choice = milling_.choice;
        const double diameter = milling_.location.diameter, height = greatest_height();
        const double depth = choice.full_depth ? height : height / choice.layers(height, diameter);
        if (choice.full_depth || depth > diameter)
            first.warning = "the first pass " + slot_words(depth, diameter);
    }

    void describe(std::vector<std::string>& remarks) const {
        const MillingChoice& choice = milling_.choice;
        const bool right_handed = choice.spindle == SpindleSense::clockwise;
        remarks.push_back(fmt::format("direction: {}, spindle {}clockwise {}",
                                      is_slot()         ? "both flanks at once, one climb, one conventional"
                                      : choice.climbs() ? "climb, inside the groove, on either flank"
                                                        : "conventional, inside the groove, on either flank",
                                      right_handed ? "" : "counter", right_handed ? "M3" : "M4"));
        remarks.push_back(fmt::format("in: down the middle of the groove, {:g} deg at most",
                                      choice.ramp_angle / units::degree));
        remarks.emplace_back("compensation: none, the program is the path of the cutter's centre");
    }

    /// Lift of the last layer.
    [[nodiscard]] double add_roughing(MillingPasses& result) const {
        const MillingChoice& choice = milling_.choice;
        const Groove& middle = grooves_.front();
        const double height = greatest_height(), diameter = milling_.location.diameter;
        const int layers = choice.layers(height, diameter);
        const double allowance = choice.allowance(most_allowance(milling_));
        const double stock = milling_.location.stock + allowance,
                     chords = MillingChoice::coarse_chords(allowance);
        const double room = std::max(middle.middle() - stock - chords, 0.0);
        const int rings = static_cast<int>(std::ceil(room / choice.step_over_of(diameter) - 1e-9));
        // What the last layer of a slot would cut is the finishing pass itself.
        const int last = is_slot() && allowance == 0.0 ? layers - 1 : layers;
        double above = HUGE_VAL;
        for (int layer = 1; layer <= last; ++layer) {
            const double lift = height * (layers - layer) / layers;
            const auto add = [&](const Groove& groove, double left, const std::string& what) {
                CuttingPass cut = pass(fmt::format("roughing, layer {} of {}, {}", layer, layers, what),
                                       groove, left, lift, above);
                cut.roughs = true;
                cut.stock = stock;
                if (left > stock + 0.5 * chords) cut.chord_tolerance = chords;
                if (left >= groove.middle()) cut.climbs.reset();
                result.passes.push_back(std::move(cut));
                above = lift;
            };
            add(middle, middle.middle(), "middle");
            for (int ring = 1; ring <= rings; ++ring)
                for (const Groove& groove : grooves_)
                    add(groove, middle.middle() - room * ring / rings,
                        fmt::format("{:.4g} mm towards flank {:+d}", room * ring / rings / units::millimetre,
                                    groove.flank()));
        }
        result.remarks.push_back(
            words_of({layers, last, height / layers, rings > 0 ? room / rings : 0.0, allowance}));
        return last > 0 ? height * (layers - last) / layers : HUGE_VAL;
    }

    /// above: lift of what is cut already in the middle of the groove.
    [[nodiscard]] CuttingPass pass(const std::string& name, const Groove& groove, double stock, double lift,
                                   double above) const {
        CuttingPass cut;
        cut.name = name;
        cut.path = [groove, stock, lift](double u) { return groove.at(u, stock, lift); };
        cut.knots = groove.knots();
        if (!is_slot()) cut.climbs = milling_.choice.climbs();
        const bool aside = stock < groove.middle() - same_place;
        const double length = aside && groove.closed() ? lead_angle(groove) : 0.0;
        cut.in.poses = ramp(groove, groove.begin() - length, lift, above);
        if (!aside) {
            cut.in.poses.pop_back();  // the path begins there
            return cut;
        }
        if (!groove.closed()) {
            cut.out.poses.push_back(groove.at(groove.end(), groove.middle(), lift));
            return cut;
        }
        const auto blend = [&](double share) { return stock + (groove.middle() - stock) * share * share; };
        for (int k = 1; k <= lead_blocks; ++k) {
            const double share = static_cast<double>(k) / lead_blocks;
            if (k < lead_blocks)
                cut.in.poses.push_back(
                    groove.at(groove.begin() - length * (1.0 - share), blend(1.0 - share), lift));
            cut.out.poses.push_back(groove.at(groove.end() + length * share, blend(share), lift));
        }
        return cut;
    }

    [[nodiscard]] double lead_angle(const Groove& groove) const {
        const double length = milling_.choice.lead_radius.value_or(0.5 * milling_.location.diameter);
        return std::min(length / groove.speed(groove.begin()),
                        most_lead_share * (groove.end() - groove.begin()));
    }

    /// Down to `lift` in the middle at `place`; the last pose is the one from which the cutter goes on.
    [[nodiscard]] std::vector<ToolPose> ramp(const Groove& groove, double place, double lift,
                                             double above) const {
        const ToolPose low = groove.at(place, groove.middle(), lift);
        if (above <= lift + same_place) return {low};
        if (distance_to_blank(milling_.blank, low, 0.5 * milling_.location.diameter) > 0.0)
            return {low};  // beside it
        const double from = std::min(above + over_cut_layer, groove.height(place)), drop = from - lift;
        const double slope = std::tan(milling_.choice.ramp_angle);
        if (!(drop > 0.0) || slope > 1e6) return {low};
        const double way = drop / slope, speed = groove.speed(place);
        const double room = std::min(ramp_diameters * milling_.location.diameter,
                                     0.5 * speed * (groove.end() - groove.begin()));
        const int ways = 2 * std::max(1, static_cast<int>(std::ceil(0.5 * way / room)));
        if (ways > most_ramp_ways)
            throw InputError(fmt::format(
                "milling: a ramp of {:g} deg takes {} passes to and fro down {:.3f} mm; allowed: "
                "{}, by a steeper one or layers",
                milling_.choice.ramp_angle / units::degree, ways, drop / units::millimetre, most_ramp_ways));
        const double turn = way / ways / speed;
        const int steps = std::max(2, static_cast<int>(std::ceil(turn / ramp_step)));
        std::vector<ToolPose> poses;
        for (int k = 0; k <= ways * steps; ++k) {
            const int within = k % (2 * steps);
            const double share = static_cast<double>(within <= steps ? within : 2 * steps - within) / steps;
            poses.push_back(
                groove.at(place + turn * share, groove.middle(), from - drop * k / (ways * steps)));
        }
        return poses;
    }

    const GrooveTask& milling_;
    std::vector<Groove> grooves_;
};

void check_groove(const GrooveTask& milling) {
    const MillingChoice& choice = milling.choice;
    choice.validate(milling.location.diameter);
    if (choice.compensation != CompensationWords::none)
        throw InputError(
            "milling: cutter compensation by the control is for plane cams; of a drum allowed: none");
    if (milling.location.makes_both_flanks() && choice.direction)
        throw InputError(
            "milling: the cutter is as large as the roller and cuts both flanks at once, one climb, one "
            "conventional; a direction is for a smaller cutter");
    const double most = most_allowance(milling), island = 2.0 * most - milling.location.diameter;
    if (choice.full_depth && island > same_place)
        throw InputError(
            fmt::format("milling: found full depth with a cutter that leaves {:.3f} mm in the middle of "
                        "the groove; allowed: roughing, or a larger cutter",
                        island / units::millimetre));
    if (choice.finish_allowance.value_or(0.0) > most + same_place)
        throw InputError(fmt::format(
            "milling: in the middle of the groove the cutter leaves {:g} mm, so roughing cannot leave {:g} "
            "mm for finishing; allowed: no more than that, or a smaller cutter",
            most / units::millimetre, *choice.finish_allowance / units::millimetre));
}

}  // namespace

void add_groove(NcWork& work, const GrooveMilling& milling, const MillingOptions& options) {
    const CutterLocation& location = milling.location;
    const GrooveTask groove{milling, options.milling, work.job.blank};
    location.validate();
    check_groove(groove);
    take_passes(work, GroovePassMaker(groove).made());
    CuttingTask& task = work.task;
    task.knots = milling.knots;
    task.blocks = {{}, options.chord_tolerance, location.station + location.tip_beyond};
    task.cutter = {location.diameter, milling.depth + location.diameter};
    task.gouge_tolerance = options.gouge_tolerance;
    GroovedBody body{milling.roller,         milling.knots.front(),      milling.knots.back(),
                     location.roller_radius, task.blocks.working_length, work.job.blank};
    body.poses = std::max(body.poses, static_cast<int>(body.poses * (body.end - body.begin) / units::turn));
    body.enough = 0.5 * (options.gouge_tolerance + options.chord_tolerance);
    task.finished = grooved_finished_cam(body);
}

}  // namespace camopt
