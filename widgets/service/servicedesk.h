// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "service/servicequeue.h"

#include <QObject>

#include <memory>

namespace mb {

/// A queue of units that is served, as the window sees it at one moment.
struct ServiceView {
    bool running = false;   ///< units are served, or waited for
    bool pausing = false;   ///< after this unit
    bool armed = false;     ///< self-tests may turn the motor
    double armedLeft = 0.0; ///< s, without a unit
    bool announces = false; ///< a motor turns within three seconds
    std::string link;
    std::string trouble;                 ///< what ended it before its time
    std::vector<service::QueueRow> rows; ///< in the order in which units were found
    service::QueueCounts counts;
};

/// The door between the window and the service of units: orders go in, views come out, nothing waits. Everything on the GUI
/// thread. The program's is app/servicedoor.
class ServiceDesk : public QObject {
    Q_OBJECT
public:
    using Finished = std::function<void(Result<void>)>;
    struct Plan {
        std::shared_ptr<const service::RecipeMatter> matter;
        std::string link;         ///< address; it is open
        std::optional<int> units; ///< as QueueOptions::units
    };
    using QObject::QObject;

    [[nodiscard]] virtual const ServiceView &view() const = 0;
    /// Serves the units of a link, which nobody else uses meanwhile. Refused while another queue runs.
    virtual void begin(const Plan &plan, Finished finished) = 0;
    /// After this unit; or goes on.
    virtual void pause(bool on) = 0;
    virtual void skip(std::uint32_t row) = 0;
    /// One that failed, was refused or was left out, once more.
    virtual void retry(std::uint32_t row) = 0;
    /// No more units; ends when those that run have ended.
    virtual void finish() = 0;
    /// Self-tests may turn the motors of this recipe on this link, until it is stopped, fails, is left, has no unit for five
    /// minutes, or this takes it back.
    virtual void arm(bool on) = 0;
    /// The window is alive: ten times a second, while a motor may turn.
    virtual void renew() = 0;

Q_SIGNALS:
    void changed();
    /// Its row is in the journal.
    void unitEnded(const mb::service::Visit &visit);
};

} // namespace mb
