// SPDX-License-Identifier: MIT
// Until when: one value for everything done under one limit of time. Copies share whether it was ever felt.
// Seconds. Safe to ask from several threads.
#pragma once

#include "core/deadline.hpp"
#include "core/language.hpp"
