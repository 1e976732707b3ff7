// SPDX-License-Identifier: MIT
#include "linear/rank_revealing_qr.hpp"
