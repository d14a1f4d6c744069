// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/service/servicedesk.h"

namespace mb::test {

/// The door to the service of units without any: the test sets what is seen, and reads what was ordered. It answers at once.
class FakeDesk final : public ServiceDesk {
public:
    [[nodiscard]] const ServiceView &view() const override { return shown; }
    void begin(const Plan &plan, Finished finished) override
    {
        begun.push_back(plan);
        finished(beginning);
    }
    void findCut(const service::RecipeMatter &, CutFound found) override { found(cut); }
    void pause(bool on) override { paused.push_back(on); }
    void skip(std::uint32_t row) override { skipped.push_back(row); }
    void retry(std::uint32_t row) override { retried.push_back(row); }
    void retryFailed() override { ++failedRetried; }
    void finish() override { ++finishes; }
    void cancel() override { ++cancelled; }
    void arm(bool on) override { armed.push_back(on); }
    void renew() override { ++renewed; }
    [[nodiscard]] const JournalState &journal() const override { return journalState; }
    void keepJournal(const std::string &server, const std::string &station, Finished finished) override
    {
        if (keeping) {
            journalState.server = server;
            journalState.station = station;
            Q_EMIT changed();
        }
        finished(keeping);
    }
    void list(const service::VisitFilter &, Listed listed) override { listed(entries); }
    void setNote(const std::string &visit, const QString &note, Finished finished) override
    {
        for (service::Visit &entry : entries) {
            if (entry.id == visit)
                entry.note = note.toStdString();
        }
        finished({});
    }
    void exportTo(const QString &path, std::vector<service::Visit> visits, Finished finished) override
    {
        exportedTo = path;
        exported = std::move(visits);
        finished({});
    }
    void show(std::vector<service::QueueRow> rows, bool running = true)
    {
        shown.running = running;
        shown.links = {"sim:can"};
        shown.rows = std::move(rows);
        Q_EMIT changed();
    }

    ServiceView shown;
    Result<void> beginning;
    CutRun cut;
    JournalState journalState;
    Result<void> keeping;
    std::vector<service::Visit> entries;
    std::vector<Plan> begun;
    std::vector<bool> paused;
    std::vector<std::uint32_t> skipped;
    std::vector<std::uint32_t> retried;
    std::vector<bool> armed;
    QString exportedTo;
    std::vector<service::Visit> exported;
    int failedRetried = 0;
    int finishes = 0;
    int cancelled = 0;
    int renewed = 0;
};

} // namespace mb::test
