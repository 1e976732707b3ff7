// SPDX-License-Identifier: MIT
#include "shop/plc/plc_formats.hpp"

#include "shop/plc/controller_rules.hpp"

#include <fmt/ranges.h>

namespace camopt {

const std::vector<PlcFormat>& plc_formats() {
    static const std::vector<PlcFormat> formats = {
        {.key = "codesys",
         .file = "codesys.st",
         .controller = "CODESYS SoftMotion, MC_CAM_REF of type XYVA",
         .rule = "a quintic between two points",
         .numbers = "LREAL (float64)",
         .element = "points",
         .limit = 128,
         .limit_words = "a cam read from a file",
         .limit_note = "library parameter gc_SMC_FILE_MAXCAMEL",
         .shared = 2,
         .text_file = "codesys.txt",
         .evaluate = quintics_between_points},
        {.key = "twincat",
         .file = "twincat.st",
         .controller = "Beckhoff TwinCAT 3 NC Camming, MC_MotionFunctionPoint",
         .rule = "POLYNOM5_MM, a quintic between two points",
         .numbers = "LREAL (float64)",
         .element = "points",
         .shared = 2,
         .evaluate = quintics_between_points},
        {.key = "twincat7",
         .file = "twincat7.st",
         .controller = "Beckhoff TwinCAT 3 NC Camming, MC_MotionFunctionPoint",
         .rule = "POLYNOM7_MM, a polynomial of degree 7 between two points",
         .numbers = "LREAL (float64)",
         .degree = 7,
         .element = "points",
         .shared = 3,
         .evaluate = septics_between_points},
        {.key = "siemens",
         .file = "siemens.scl",
         .controller = "Siemens S7-1500T, LCamHdl_CreateCamAdvanced",
         .rule = "each element a polynomial of degree 5 or a dwell",
         .numbers = "LREAL (float64)",
         .counted = PlcCount::pieces,
         .element = "segments",
         .limit = 50,
         .limit_words = "a technology object TO_Cam",
         .evaluate = siemens_elements,
         .prepare = siemens_table,
         .own_number = siemens_number},
        {.key = "br",
         .file = "br.st",
         .controller = "B&R ACP10, MC_CAMPROFILE_TYP",
         .rule = "each a polynomial of degree 6 with its own begin as zero",
         .numbers = "REAL (float32) coefficients, DINT (int32) periods",
         .degree = 6,
         .counted = PlcCount::pieces,
         .element = "polynomials",
         .limit = 128,
         .limit_words = "an MC_CAMPROFILE_TYP",
         .limit_note = "64 in older libraries",
         .relative = true,
         .whole_periods = true,
         .evaluate = polynomials,
         .master = br_master,
         .units = br_units},
        {.key = "rockwell",
         .file = "rockwell.st",
         .controller = "Rockwell Logix, CAM_PROFILE_EXTENDED",
         .rule = "a cubic from each element to the next",
         .numbers = "LREAL (float64)",
         .degree = 3,
         .element = "elements",
         .evaluate = polynomials},
        {.key = "omron",
         .file = "omron.st",
         .controller = "Omron NJ/NX/NY, MC_GenerateCamTable",
         .rule = "cubics between the nodes, made into a table of points with straight lines between them",
         .numbers = "REAL (float32)",
         .degree = 3,
         .counted = PlcCount::pieces,
         .element = "nodes",
         .limit = 360,
         .limit_words = "CamNodes",
         .shared = 1,
         .straight_lines = true,
         .relative = true,
         .evaluate = omron_points,
         .master = as_real,
         .own_number = omron_number},
        {.key = "lenze",
         .file = "lenze.txt",
         .controller = "Lenze Cam Loader, motion profile",
         .rule = "straight lines between the points (assumed)",
         .numbers = "decimal text",
         .degree = 1,
         .element = "points",
         .straight_lines = true,
         .points = 721,  // every half degree
         .evaluate = lines_between_points},
        {.key = "csv",
         .file = "plc.csv",
         .controller = "any controller, polynomial coefficients",
         .rule = "a polynomial of degree 7 in each row",
         .numbers = "decimal text of float64",
         .degree = 7,
         .counted = PlcCount::pieces,
         .element = "rows",
         .evaluate = polynomials}};
    return formats;
}

std::vector<std::string> plc_format_keys() {
    std::vector<std::string> keys;
    for (const PlcFormat& format : plc_formats()) keys.push_back(format.key);
    return keys;
}

const PlcFormat& plc_format(std::string_view key) {
    const auto found = std::ranges::find(plc_formats(), key, &PlcFormat::key);
    if (found != plc_formats().end()) return *found;
    throw InputError(
        fmt::format("--plc: found \"{}\"; allowed: {}", key, fmt::join(plc_format_keys(), ", ")));
}

}  // namespace camopt
