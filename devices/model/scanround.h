// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/event.h"
#include "async/noncopyable.h"
#include "async/scope.h"
#include "model/device.h"
#include "model/family.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace mb {

struct ScanOptions {
    ScanExtent extent = ScanExtent::Quick;
    /// What is looked for, of families that take long; in the thread of the session.
    std::function<void(const Message &what, int done, int total)> progress;
};

/// Gathers what the families find in one scan of a link, all of them at once. Thread of the session.
class ScanRound : NonCopyable {
public:
    /// What a round asks of who began it, who outlives it.
    struct Surroundings {
        std::span<const Family *const> families;
        Clock &clock;     ///< of the session
        Clock &linkClock; ///< that devices of the link live on
        /// The device of what answered, known before or new; the second are those that this round has seen.
        std::function<Device &(const Family &, const Identity &, const std::vector<Device *> &)> adopt;
        std::function<std::vector<Identity>(const Family &)> remembered;
        std::function<std::vector<Identity>(const Family &)> known;
        std::function<void(const Message &)> leftOut; ///< unless only one is looked for
        std::function<void(const std::vector<Device *> &, bool complete)> ended;
    };

    ScanRound(Link &link, ScanOptions options, Surroundings surroundings);
    /// What was found is told, although the round was cut.
    ~ScanRound();

    void start();
    /// Only this one, where its family can ask for one.
    void startFor(const DeviceSelector &selector);
    /// Until all families have ended.
    [[nodiscard]] Event &done() { return m_done; }
    /// What one of them failed with; else who answered.
    [[nodiscard]] const std::optional<Error> &error() const { return m_error; }
    [[nodiscard]] const std::vector<Device *> &seen() const { return m_seen; }
    /// Nobody else answers.
    void setComplete() { m_complete = true; }

private:
    struct Sink;
    [[nodiscard]] bool speaks(const Family &family) const;
    [[nodiscard]] Sink &sinkOf(const Family &family);
    void spawn(Task<void> task);
    void found(const Family &family, const Identity &identity);

    Link &m_link;
    ScanOptions m_options;
    Surroundings m_around;
    std::optional<Identity> m_named; ///< who alone is looked for
    std::vector<Device *> m_seen;
    std::optional<Error> m_error;
    Event m_done;
    std::vector<std::unique_ptr<Sink>> m_sinks;
    int m_running = 0;
    bool m_complete = false;
    Scope m_scope;
};

} // namespace mb
