// SPDX-License-Identifier: MIT
// A cam with the formulas of another one, without its enclosures.
#pragma once

#include "scene/cam_mechanism.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace camopt::testing_support {

class ForwardingCam : public CamMechanism {
 public:
    explicit ForwardingCam(std::shared_ptr<const CamMechanism> own) : own_(std::move(own)) {}

    std::string type() const override { return own_->type(); }
    bool swings() const override { return own_->swings(); }
    Rotation rotation() const override { return own_->rotation(); }
    int stations() const override { return own_->stations(); }
    std::string station_name(int station) const override { return own_->station_name(station); }
    int roller_radius_at(int station) const override { return own_->roller_radius_at(station); }
    double surface_offset(std::span<const double> dimensions, int station) const override {
        return own_->surface_offset(dimensions, station);
    }
    std::optional<MechanismQuantity> radius_quantity() const override { return own_->radius_quantity(); }
    const LimitStructure& limit_structure() const override { return own_->limit_structure(); }
    const PlaneMechanism* plane() const override { return own_->plane(); }
    const DirectCam* direct() const override { return own_->direct(); }
    double length(std::span<const double> dimensions) const override { return own_->length(dimensions); }
    std::string fault(std::span<const double> dimensions, double least, double most) const override {
        return own_->fault(dimensions, least, most);
    }
    MechanismValue quantity(MechanismQuantity which, const MechanismState& state, int station,
                            std::span<const int> active) const override {
        return own_->quantity(which, state, station, active);
    }
    MechanismPoint point(double theta, const MechanismState& state, int station) const override {
        return own_->point(theta, state, station);
    }
    std::optional<FollowerGeometry> follower(std::span<const double> dimensions, int station) const override {
        return own_->follower(dimensions, station);
    }

 protected:
    [[nodiscard]] const CamMechanism& own() const { return *own_; }

 private:
    std::shared_ptr<const CamMechanism> own_;
};

}  // namespace camopt::testing_support
