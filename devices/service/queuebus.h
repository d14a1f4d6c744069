// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/event.h"
#include "async/noncopyable.h"
#include "model/operation.h"
#include "service/busrows.h"
#include "service/queuerun.h"

namespace mb::service {

/// One bus of a queue: who is on it, and the unit that is being served. Thread of the queue.
class QueueBus : NonCopyable {
public:
    /// All of them outlive it.
    QueueBus(QueueRun &run, Session &session, Link &link);
    ~QueueBus();

    /// Until there is nothing left to do here. LinkLost, or a journal that cannot be written, ends it.
    [[nodiscard]] Task<void> run();
    [[nodiscard]] bool isInLane() const { return m_isInLane; }
    void setInLane(bool is) { m_isInLane = is; }
    [[nodiscard]] bool isServing() const { return m_serving != nullptr; }
    /// Neither simulated nor a recording.
    [[nodiscard]] bool isReal() const { return !m_link.address().isSimulated() && !m_link.address().isRecording(); }
    void addRows(std::vector<Shared<QueueRow>> &rows) const;

    bool skip(std::uint32_t row);
    [[nodiscard]] bool has(std::uint32_t row) { return m_rows.find(row) != nullptr; }
    /// It waits again. Refused, with the reason: nothing comes of it.
    [[nodiscard]] Result<void> retry(std::uint32_t row);
    bool retryFailed();
    void stop();
    void renewLease();

private:
    using Row = BusRows::Row;
    class Telling;
    /// Given up where there is something better to do.
    [[nodiscard]] Task<void> look();
    [[nodiscard]] Task<void> checkAll();
    [[nodiscard]] Task<void> check(Row &row);
    class Serving;
    [[nodiscard]] Task<void> serve(Row &row);
    [[nodiscard]] Task<void> serveHere(Row &row, Device &device);
    [[nodiscard]] Result<void> isAlone(const Row &row) const;
    [[nodiscard]] Task<Visit> openVisit(Row &row, const Device &device);
    [[nodiscard]] Task<Visit> perform(Row &row, Device &device, Visit visit);
    [[nodiscard]] Task<void> refuse(Row &row, const Device &device, Error error);
    [[nodiscard]] Task<void> reachSilent(Visit visit);
    [[nodiscard]] Task<void> giveUpMissing();
    void ended(Row &row, const Visit &visit);
    void leftOut(Row &row, const Error &why);
    [[nodiscard]] ServiceSurroundings surroundings(Row &row, Telling &telling);

    QueueRun &m_run;
    Session &m_session;
    Link &m_link;
    BusRows m_rows;
    Row *m_serving = nullptr;
    SetPointStream *m_stream = nullptr; ///< of the unit that is being served
    std::unique_ptr<Operation> m_operation;
    std::unique_ptr<tuning::Interruption> m_interruption;
    bool m_isInLane = false;
    bool m_wantsSkip = false;
};

} // namespace mb::service
