// SPDX-License-Identifier: MIT
// NC programs with their check: machines as pure kinematics, post-processors as data, paths cut into blocks,
// printed, read back, and run against points of the wanted surface. m, rad, s inside, the program's units in
// the text. A program whose check fails is to be kept from machines: look at CheckedProgram before writing
// one.
#pragma once

#include "core/language.hpp"
#include "output/disk/disk_export.hpp"
#include "output/nc/checked_program.hpp"
#include "output/nc/machine.hpp"
#include "output/nc/post_processor.hpp"
#include "output/spatial/nc_export.hpp"
