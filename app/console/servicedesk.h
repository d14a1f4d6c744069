// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/progressline.h"
#include "app/console/stage.h"
#include "async/event.h"
#include "async/mailbox.h"
#include "async/noncopyable.h"
#include "service/servicequeue.h"
#include "storage/settingsbook.h"
#include "storage/sharedjournal.h"
#include "storage/trialbook.h"
#include "transport/workerthreads.h"

#include <QSocketNotifier>

namespace mb::console {

/// The books that a queue writes: of this computer, and the journal that stations share, if there is one.
class ServiceDesk : NonCopyable {
public:
    /// OutOfRange, Usage: the file cannot be written, or `url` is none.
    [[nodiscard]] static Result<std::unique_ptr<ServiceDesk>> open(
        Console &console, const std::string &station, const std::string &url);

    [[nodiscard]] service::ServiceJournal &journal();
    [[nodiscard]] ServiceBook &book() { return m_book; }
    [[nodiscard]] SettingsBook &settings() { return m_settings; }
    [[nodiscard]] TrialBook &trials() { return m_trials; }
    /// Waits until the server has what it has not got yet, or says that it does not take it.
    [[nodiscard]] Task<void> handOver();

private:
    ServiceDesk(Console &console, std::unique_ptr<Database> database, const std::string &station);
    void share(JournalServer server);

    Console &m_console;
    std::unique_ptr<Database> m_database;
    ServiceBook m_book;
    SettingsBook m_settings;
    TrialBook m_trials;
    Mailbox m_mailbox;
    std::unique_ptr<WorkerThreads> m_workers;
    std::unique_ptr<QSocketNotifier> m_mail;
    std::unique_ptr<SharedJournal> m_shared;
};

/// Says before each self-test what will move, and waits for 3 s; at once where nothing real moves. Whoever has given the order
/// at the terminal has armed it.
class SpokenPermit final : public service::MotionPermit {
public:
    explicit SpokenPermit(Console &console)
        : m_console(console)
    {
    }
    [[nodiscard]] Task<void> beforeMotion(
        const Device &device, const service::SelfTest &test, Progress &progress) override;

private:
    Console &m_console;
};

} // namespace mb::console
