// SPDX-License-Identifier: MIT
// The papers that are computed again: one function a paper.
#pragma once

#include "studies/delivered/solution.hpp"
#include "studies/papers/paper_report.hpp"
#include "studies/papers/reference_table.hpp"

namespace camopt {

/// Hears in words of each part that is done, for progress; may be empty.
using PaperProgress = std::function<void(const std::string&)>;

struct PaperInfo {
    std::string_view id;     ///< "004"
    std::string_view title;  ///< one line for people
    PaperReport (*report)(const SolveControl& control, const PaperProgress& finished);
};

/// In the order of their ids.
[[nodiscard]] std::span<const PaperInfo> paper_catalogue();

/// Throws InputError naming the known ids.
[[nodiscard]] const PaperInfo& find_paper(std::string_view id);

// J.-H. Shin, Y.-H. Choi, C.-S. Rho, "Kinematic Analysis and Simulation of an Automatic Feeding Mechanism
// Subjected by a Curvilinear Inverse Cam (I)": Table 1 and Figs. 7, 9 and 10 from the scene files of the
// given guides, with the misprints, the approximate method against the exact one, forward simulations, and
// the guide that the paper does not ask for: the best one.

/// About a second.
[[nodiscard]] PaperReport paper_000(const SolveControl& control = {}, const PaperProgress& finished = {});

// B. K. Gu, J. H. Shin, D. W. Kang, S. W. Chang, "A Study On the Manufacturing process of Cylindrical Cam
// based on Relative Velocity Method and Inverse Kinematics": the open cylindrical cam with a rotating
// follower (OCRF). The paper holds no number; its formulas are put to the test on an example of ours.

/// About a second.
[[nodiscard]] PaperReport paper_001(const SolveControl& control = {}, const PaperProgress& finished = {});

// W. H. Kim and T. W. Park, "Development of Program for Designing Barrel Cam of Machine Making Paper Cups",
// 2011: the barrel cam with what the paper prints, checked by points that drive the index.

/// What the paper has, without a solve.
[[nodiscard]] PaperReport paper_002_as_printed(const PaperProgress& finished = {});

/// And what an optimised motion gains. Some seconds: two solves.
[[nodiscard]] PaperReport paper_002(const SolveControl& control = {}, const PaperProgress& finished = {});

// J. K. Shin, J. K. Lee, H. T. Ahn, "Design of a disk cam with remote follower in a tappet shedding device":
// its cams' pressure angles by two definitions beside its verdicts, profiles, forward simulations standing in
// for its experiment, and the motions that keep its dwells within its 30 deg. The paper prints no number of a
// cam and no dimension: what agrees with it agrees by the choice of ours.

/// Some ten seconds: two solves that are not convex.
[[nodiscard]] PaperReport paper_003(const SolveControl& control = {}, const PaperProgress& finished = {});

// T.-Y. Shon and M.-Y. Yang, "Synthesis of Optimum CAM Curve by Cubic Spline", 1994: Tables 1 to 4 and Figs.
// 1 to 8 beside the proved optima. The numbers are those of studies/papers/reference_table.hpp.

/// Some seconds: 15 solves.
[[nodiscard]] PaperReport paper_004(const SolveControl& control = {}, const PaperProgress& finished = {});

/// One quantity: printed | ours | difference | remark.
struct PaperComparison {
    std::string quantity, unit;
    std::optional<double> printed, ours;
    std::string remark;  ///< "misprint: …", "chosen", …
};

/// difference = ours − printed; none where one of them is.
[[nodiscard]] PaperTable comparison_table(const std::string& key, const std::string& title,
                                          const std::vector<PaperComparison>& rows);

}  // namespace camopt
