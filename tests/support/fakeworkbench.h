// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/owedgains.h"
#include "fakearchive.h"
#include "fakenotebook.h"
#include "fakevisits.h"
#include "widgets/common/serviceview.h"
#include "widgets/common/workbench.h"

namespace mb::test {

/// An order as a page gave it, with its own fields and with what ends it.
template <class O> struct Given : O {
    std::function<void(Result<AnswerOf<O>>)> finished; ///< call it to answer, later than the order itself
};

/// A workbench without devices: the test sets the snapshot and the time, and reads what was ordered.
class FakeWorkbench : public Workbench {
public:
    using Workbench::Workbench;

    struct Sent {
        Order order;
        Reply::Finished finished;
    };
    struct Stop {
        StopCause cause;
        std::size_t ordersBefore; ///< how many were given before it
    };

    std::vector<Sent> sent; ///< every order, oldest first
    std::vector<Stop> stops;
    FakeNotebook book;
    FakeArchive archive;
    FakeVisits visited;
    ServiceView served;
    JournalState kept;
    std::map<DeviceId, std::vector<tuning::OwedGains>> owed;
    Snapshot shot;
    Instant time{std::chrono::seconds(1000)};
    SleepLog slept;
    std::vector<LinkListing> links;
    std::vector<Notice> lines;

    /// Tells the pages of a new snapshot.
    void publish()
    {
        shot.time = time;
        Q_EMIT changed();
    }
    /// Tells the pages of units that are served, or were.
    void serve(const std::vector<service::QueueRow> &rows, bool running = true)
    {
        served.running = running;
        served.links = {"sim:can"};
        served.rows.assign(rows.begin(), rows.end());
        Q_EMIT serviceChanged();
    }
    /// The orders of one kind, oldest first.
    template <class O> [[nodiscard]] std::vector<Given<O>> given() const
    {
        std::vector<Given<O>> found;
        for (const Sent &one : sent) {
            if (const O *order = std::get_if<O>(&one.order))
                found.push_back({*order, answering<AnswerOf<O>>(one.finished)});
        }
        return found;
    }
    [[nodiscard]] DeviceView &device(std::size_t place) { return shot.devices.at(place); }

    const Snapshot &snapshot() const override { return shot; }
    Instant now() const override { return time; }
    Duration unixOffset() const override { return slept.sleptAt(time); }
    SleepLog sleeps() override { return slept; }
    const std::vector<LinkListing> &listings() const override { return links; }
    SettingsArchive &settings() override { return archive; }
    TrialNotebook &trials() override { return book; }
    VisitArchive &visits() override { return visited; }
    const JournalState &journal() const override { return kept; }
    const ServiceView &service() const override { return served; }
    const std::map<DeviceId, std::vector<tuning::OwedGains>> &owedGains() const override { return owed; }
    void stopAll(StopCause cause) override { stops.push_back({cause, sent.size()}); }
    void report(Severity severity, const QString &device, const QString &text) override
    {
        lines.push_back({time, severity, device, text});
        Q_EMIT noticed(lines.back());
    }
    const std::vector<Notice> &notices() const override { return lines; }

private:
    template <class T> static std::function<void(Result<T>)> answering(const Reply::Finished &finished)
    {
        if (finished)
            return Reply::to<T>(finished);
        return [](const Result<T> &) {};
    }
    void deliver(Order order, Reply::Finished finished) override
    {
        sent.push_back({std::move(order), std::move(finished)});
    }
};

} // namespace mb::test
