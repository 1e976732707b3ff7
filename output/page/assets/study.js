// SPDX-License-Identifier: MIT
// Pages of many motions: comparison, sweep, front.
'use strict';
