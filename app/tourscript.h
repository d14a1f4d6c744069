// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <chrono>
#include <functional>

namespace mb {

/// What the parts of a tour are planned with, step by step. GUI thread.
class TourScript {
public:
    virtual ~TourScript() = default;
    /// Waits until `done`.
    virtual void add(
        const QString &name, std::function<void()> act, std::function<bool()> done, std::chrono::milliseconds limit)
        = 0;
    void add(const QString &name, std::function<void()> act, std::function<bool()> done)
    {
        add(name, std::move(act), std::move(done), std::chrono::seconds(20));
    }
    /// Lets `time` pass, so that live pages have something to show.
    virtual void pause(std::chrono::milliseconds time) = 0;
    /// A picture of the window in both themes; `grey`: each without its colours, too.
    virtual void picture(const QString &name, bool grey) = 0;
    void picture(const QString &name) { picture(name, false); }
};

} // namespace mb
