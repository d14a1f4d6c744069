// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine.h"

#include <functional>
#include <future>
#include <memory>

namespace mb::test {

/// The answer of the engine thread; the caller's thread stands still meanwhile.
template <class T> [[nodiscard]] T askEngine(Engine &engine, const std::function<T(EngineCore &)> &question)
{
    auto answer = std::make_shared<std::promise<T>>();
    auto coming = answer->get_future();
    engine.post([answer, question](EngineCore &core) { answer->set_value(question(core)); });
    return coming.get();
}

} // namespace mb::test
