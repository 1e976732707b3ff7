// SPDX-License-Identifier: MIT
// A cam with the formulas of another one: what every study of a direct cam needs of it, without its drawing.
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
    bool binds(MechanismQuantity which, int station) const override { return own_->binds(which, station); }
    int roller_radius() const override { return own_->roller_radius(); }
    int roller_radius_at(int station) const override { return own_->roller_radius_at(station); }
    double surface_offset(std::span<const double> dimensions, int station) const override {
        return own_->surface_offset(dimensions, station);
    }
    bool planar() const override { return own_->planar(); }
    bool is_direct() const override { return own_->is_direct(); }
    bool has_pitch_curve() const override { return own_->has_pitch_curve(); }
    int base_radius_index() const override { return own_->base_radius_index(); }
    std::optional<double> pushed_offset(std::span<const double> dimensions) const override {
        return own_->pushed_offset(dimensions);
    }
    std::vector<std::vector<SignedIndex>> reach() const override { return own_->reach(); }
    double length(std::span<const double> dimensions) const override { return own_->length(dimensions); }
    std::string fault(std::span<const double> dimensions, double least, double most) const override {
        return own_->fault(dimensions, least, most);
    }
    double face_turn() const override { return own_->face_turn(); }
    MechanismValue quantity(MechanismQuantity which, const MechanismState& state, int station,
                            std::span<const int> active) const override {
        return own_->quantity(which, state, station, active);
    }
    MechanismPoint point(double theta, const MechanismState& state, int station) const override {
        return own_->point(theta, state, station);
    }
    std::vector<MechanismShape> shapes(const MechanismState& state) const override {
        return own_->shapes(state);
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
