// SPDX-License-Identifier: MIT
// The table of kinds of cams: one row each, in the order of the manual. A row says where a kind describes
// itself and where its formulas are. Both are called where they are used (cam_kinds.cpp, ../factory), so that
// a program which reads every kind links the formulas of none.
#pragma once

#include "profiles/disk/disk_cam.hpp"
#include "profiles/disk/disk_spec.hpp"
#include "profiles/inverse/inverse_mechanism.hpp"
#include "profiles/inverse/inverse_spec.hpp"
#include "profiles/linear/linear_mechanism.hpp"
#include "profiles/linear/linear_spec.hpp"
#include "profiles/remote/remote_cam.hpp"
#include "profiles/remote/remote_spec.hpp"
#include "profiles/spatial/spatial_cam.hpp"
#include "profiles/spatial/spatial_spec.hpp"
#include "scene/cam_kind.hpp"

namespace camopt::kind_rows {

using Formulas = std::shared_ptr<const CamMechanism>;

// clang-format off
struct Disk { static CamKind kind() { return disk_kind(); } static Formulas formulas(const CamSpec& cam) { return disk_formulas(cam); } };
struct Remote { static CamKind kind() { return remote_kind(); } static Formulas formulas(const CamSpec& cam) { return remote_mechanism(cam); } };
struct Barrel { static CamKind kind() { return barrel_kind(); } static Formulas formulas(const CamSpec& cam) { return spatial_mechanism(cam); } };
struct Cylindrical { static CamKind kind() { return cylindrical_kind(); } static Formulas formulas(const CamSpec& cam) { return spatial_mechanism(cam); } };
struct Inverse { static CamKind kind() { return inverse_kind(); } static Formulas formulas(const CamSpec& cam) { return inverse_mechanism(cam); } };
struct Linear { static CamKind kind() { return linear_kind(); } static Formulas formulas(const CamSpec& cam) { return linear_mechanism(cam); } };
// clang-format on

template <class... Row>
struct Rows {
    static std::vector<CamKind> kinds() { return {Row::kind()...}; }
    /// By the row.
    static Formulas formulas(std::size_t row, const CamSpec& cam) {
        constexpr std::array makers = {&Row::formulas...};
        return makers.at(row)(cam);
    }
};
using All = Rows<Disk, Remote, Barrel, Cylindrical, Inverse, Linear>;

}  // namespace camopt::kind_rows
