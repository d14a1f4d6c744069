// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/metrics.h"

namespace mb::tuning {

/// What a response cost over the hold [0, hold] after the edge: peak current, chatter of the duty, share of time at its
/// limit. `limit` is the largest duty that was allowed. Nothing for a signal without samples there.
void readEffort(Metrics &metrics, const Trace &current, const Trace &duty, double hold, double limit);

} // namespace mb::tuning
