// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/result.h"

#include <functional>

namespace mb {

class EngineLog;
class Operations;
class Session;

/// Tells whoever gave an order what came of it; never empty where a part of the engine is handed one by EngineCore.
using Finished = std::function<void(Result<void>)>;

/// What the parts of the engine share. Outlives them; engine thread.
struct EngineContext {
    Clock &clock;
    Session &session;
    EngineLog &log;
    Operations &operations;
};

} // namespace mb
