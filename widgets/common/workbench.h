// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/wallclock.h"
#include "model/snapshot.h"
#include "transport/linkcatalog.h"
#include "widgets/orders/reply.h"

#include <QObject>
#include <QString>

#include <functional>
#include <map>
#include <typeindex>

namespace mb {

namespace tuning {
struct OwedGains;
} // namespace tuning
class SettingsArchive;
class TrialNotebook;
class VisitArchive;
struct JournalState;
struct ServiceView;

namespace service {
struct Visit;
} // namespace service

/// One line of the log of the window.
struct Notice {
    Instant time{};
    Severity severity = Severity::Info;
    QString device; ///< "DMC60C #5", or of a link "can0"; empty when it is about none
    QString text;
};

/// The door between the window and the devices, as pages see it: orders go in, snapshots come out, nothing waits.
/// Everything on the GUI thread; answers too, later, never from inside the call. The program's is app/engine.
class Workbench : public QObject {
    Q_OBJECT
public:
    using Finished = std::function<void(Result<void>)>;
    using TrialMeasured = std::function<void(const tuning::Trial &)>;
    using TrialFinished = std::function<void(const Result<tuning::Trial> &)>;
    using TuningFinished = std::function<void(const Result<tuning::TuneReport> &)>;
    using SweepFinished = std::function<void(const Result<tuning::FrequencyResponse> &)>;

    using QObject::QObject;

    /// Gives an order (widgets/orders). `finished` is called exactly once, with what came of it or why nothing did: an order that
    /// is dropped on its way (the device is gone, the program ends) has failed. Whoever may be gone by then holds a QPointer.
    template <class O> void send(O order, std::function<void(Result<AnswerOf<O>>)> finished = {})
    {
        deliver(Order(std::move(order)), Reply::from<AnswerOf<O>>(std::move(finished)));
    }
    /// STOP: every motor on every link, in a lane of its own before all orders that wait, whatever the engine is busy with; of
    /// whom `cause` decides. Not answered: what became of it is in the snapshot.
    virtual void stopAll(StopCause cause) = 0;

    [[nodiscard]] virtual const Snapshot &snapshot() const = 0;
    /// The present time on the line of all time stamps, and what to add to get Unix time.
    [[nodiscard]] virtual Instant now() const = 0;
    [[nodiscard]] virtual Duration unixOffset() const = 0;
    /// When the computer slept since the program began.
    [[nodiscard]] virtual SleepLog sleeps() { return {}; }
    /// Both, for time stamps of earlier too: those of this link, since a recording has times of its own, or of no link.
    [[nodiscard]] WallClock wallClock(const std::string &link = {})
    {
        const LinkView *view = snapshot().link(link);
        if (view && view->replay)
            return {view->replay->start + view->replay->position - view->time.time_since_epoch(), {}};
        const SleepLog log = sleeps();
        return {unixOffset() - log.sleptAt(now()), log};
    }
    [[nodiscard]] virtual const std::vector<LinkListing> &listings() const = 0;
    /// Snapshots and writes of earlier.
    [[nodiscard]] virtual SettingsArchive &settings() = 0;
    [[nodiscard]] virtual TrialNotebook &trials() = 0;
    /// What was done to which unit, and where that is kept.
    [[nodiscard]] virtual VisitArchive &visits() = 0;
    [[nodiscard]] virtual const JournalState &journal() const = 0;
    /// The queue of units that is served, or was last.
    [[nodiscard]] virtual const ServiceView &service() const = 0;
    /// Gains that an experiment before has changed in a unit that is here, and that nobody has put back for certain.
    [[nodiscard]] virtual const std::map<DeviceId, std::vector<tuning::OwedGains>> &owedGains() const = 0;
    /// What pages know that goes with no window: the one T of this workbench, made when it is first asked for. Not in the constructor of T.
    template <class T> [[nodiscard]] T &kept()
    {
        std::shared_ptr<void> &one = m_kept[typeid(T)];
        if (!one)
            one = std::make_shared<T>();
        return *static_cast<T *>(one.get());
    }
    /// The present on the time line of a link: of a recording, where it stands; now() for others.
    [[nodiscard]] Instant presentOf(const std::string &link) const
    {
        const LinkView *view = snapshot().link(link);
        return view && view->replay ? view->time : now();
    }

    /// A line for the log and, for 8 s, the status bar.
    virtual void report(Severity severity, const QString &device, const QString &text) = 0;
    [[nodiscard]] virtual const std::vector<Notice> &notices() const = 0;

Q_SIGNALS:
    /// snapshot() is a new one; at most 30 times a second.
    void changed();
    void noticed(const mb::Notice &notice);
    /// service() or journal() is another.
    void serviceChanged();
    /// Its row is in the journal.
    void unitEnded(const mb::service::Visit &visit);

private:
    virtual void deliver(Order order, Reply::Finished finished) = 0;

    std::map<std::type_index, std::shared_ptr<void>> m_kept;
};

} // namespace mb
