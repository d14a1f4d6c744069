// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/context.h"
#include "app/engine/enginelog.h"
#include "experiment/interruption.h"
#include "model/snapshot.h"
#include "widgets/orders/firmwareorders.h"

#include <list>
#include <memory>
#include <optional>
#include <set>

namespace mb {

/// The jobs that have a device for themselves: one a device at a time, and those that ended last. Engine thread.
class Operations {
public:
    struct Job {
        OperationId id;
        DeviceId device;    ///< as it was called when the job began
        const Device *unit; ///< the same; only to compare with, it may be gone
        std::shared_ptr<tuning::Interruption>
            interruption; ///< of a trial, which puts back what it changed; it outlives it
        std::unique_ptr<Operation> operation;
        std::optional<UpdateReport> update;
        bool yields = false; ///< it began by itself and is done again later: an order ends it
    };
    /// What a job is called and, where somebody asks, what it does.
    struct Name {
        Name(Message what, OperationKind does = OperationKind::Other) // NOLINT(google-explicit-constructor)
            : title(std::move(what))
            , kind(does)
        {
        }
        Message title;
        OperationKind kind;
    };
    template <class T> using Make = std::function<Task<T>(Device &, Progress &)>;

    Operations(Clock &clock, Session &session, EngineLog &log);

    /// Starts a job that has the device for itself; refuses when another one has it, and yields nullptr. The maker runs at
    /// once.
    template <class T>
    Job *begin(DeviceId device, const Name &name, const Make<T> &make, std::function<void(Job &, Result<T>)> finished,
        const Finished &refused);
    /// The same where nothing comes of it but that it went well, or a line in the log.
    Job *begin(DeviceId device, const Name &name, const Make<void> &make, const Finished &finished);
    void carryOut(const orders::CancelOperation &order, const Finished &finished);

    /// Lends a link to whoever serves units there: no job begins on its devices until it is given back, and each counts as
    /// one that has a job. False where one runs that nobody began but a person.
    [[nodiscard]] bool lend(const Link &link);
    void takeBack(const Link &link) { m_lent.erase(&link); }
    [[nodiscard]] bool isLent(const Link &link) const { return m_lent.count(&link) > 0; }
    [[nodiscard]] bool has(DeviceId device) const;
    /// An experiment moves it, is about to, or still puts back what it has changed.
    [[nodiscard]] bool isTried(DeviceId device) const;
    /// Before something is written that was meant for one unit. Unsafe while it has restarted and not told again who it is: another one
    /// may stand there now.
    [[nodiscard]] Result<void> checkRecognised(DeviceId device) const;
    [[nodiscard]] bool hasOn(const Link &link) const;
    /// With a unit there.
    [[nodiscard]] bool runsOn(const Link &link, OperationKind kind) const;
    [[nodiscard]] bool isAnyRunning() const;
    /// Newest last; a part of those that have ended is kept.
    [[nodiscard]] const std::list<Job> &jobs() const { return m_jobs; }

    /// STOP: what moves, or is about to, ends; trials put back what they changed.
    void stopExperiments();
    /// Trials of one device, or all: each stops in this call, and then puts back what it has changed.
    void interruptTrials(std::optional<DeviceId> device);
    /// The devices of a link are about to go, or to begin anew: whoever gave an order is answered, though it will not be carried
    /// out.
    void forget(const Link &link);
    /// Ends everything; nobody is told but by Reply.
    void clear() { m_jobs.clear(); }

private:
    [[nodiscard]] Result<Device *> freeDevice(DeviceId device);
    Job &add(const Device &device, const Name &name);
    [[nodiscard]] bool isOf(const Job &job, DeviceId device) const;
    void makeWay(DeviceId device);
    void dismiss(const Device &device, const Error &error);
    void prune();

    Clock &m_clock;
    Session &m_session;
    EngineLog &m_log;
    std::list<Job> m_jobs;
    Timer m_pruning;
    std::set<const Link *> m_lent;
    std::uint32_t m_last = 0;
};

template <class T>
Operations::Job *Operations::begin(DeviceId id, const Name &name, const Make<T> &make,
    std::function<void(Job &, Result<T>)> finished, const Finished &refused)
{
    const Result<Device *> device = freeDevice(id);
    if (!device) {
        refused(fail(device.error()));
        return nullptr;
    }
    Job &job = add(**device, name);
    job.operation->run<T>(make(**device, *job.operation),
        [&job, finished = std::move(finished)](Result<T> result) { finished(job, std::move(result)); });
    return &job;
}

} // namespace mb
