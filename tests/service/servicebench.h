// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "service/servicequeue.h"
#include "storage/servicebook.h"
#include "storage/settingsbook.h"
#include "storage/trialbook.h"
#include "support/coreapplication.h"
#include "support/simulatedsession.h"
#include "support/sourcetree.h"

#include <QTemporaryDir>

#include <QFile>

#include <functional>

namespace mb::test {

/// Simulated units of one family on one bus, in virtual time; each has its own supply, and is put on and off by its place.
class UnitRack {
public:
    /// With a clock of its own, or with that of another rack, which outlives it.
    explicit UnitRack(
        std::vector<std::string> units, const std::string &address = "sim:can", VirtualClock *shared = nullptr)
        : m_own(shared ? nullptr : std::make_unique<VirtualClock>())
        , clock(shared ? *shared : *m_own)
        , m_texts(std::move(units))
        , m_families(families().begin(), families().end())
    {
        for (const std::string &text : m_texts)
            m_units.emplace_back(text);
        for (const Family *&each : m_families) {
            const bool ours = m_texts.front().starts_with(std::string(each->key) + ':');
            m_copies.push_back(std::make_unique<Family>(*each));
            m_copies.back()->bench
                = ours ? std::span<const std::string_view>(m_units) : std::span<const std::string_view>();
            each = m_copies.back().get();
            family = ours ? each : family;
        }
        session = std::make_unique<Session>(clock, m_families);
        const auto opened = session->openLink(*LinkAddress::parse(address));
        EXPECT_TRUE(opened) << (opened ? "" : opened.error().text());
        link = opened ? *opened : nullptr;
    }
    [[nodiscard]] Simulator &unit(std::size_t place) const { return *session->bench(*link)->simulators()[place]; }
    /// Only this one is on the bus; nothing: none.
    void putOn(std::optional<std::size_t> place)
    {
        for (std::size_t i = 0; i < m_units.size(); ++i)
            unit(i).setPowered(place == i);
    }
    [[nodiscard]] std::span<const Family *const> list() const { return m_families; }

private:
    std::unique_ptr<VirtualClock> m_own;

public:
    VirtualClock &clock;
    std::unique_ptr<Session> session;
    Link *link = nullptr;
    const Family *family = nullptr;

private:
    std::vector<std::string> m_texts;
    std::vector<std::string_view> m_units;
    std::vector<std::unique_ptr<Family>> m_copies;
    std::vector<const Family *> m_families;
};

/// Lets motors turn, and counts how often.
class CountingPermit final : public service::MotionPermit {
public:
    [[nodiscard]] Task<void> beforeMotion(const Device &, const service::SelfTest &, Progress &) override
    {
        ++count;
        if (asked)
            asked();
        co_return {};
    }
    int count = 0;
    std::function<void()> asked;
};

/// The books of one station in a file of their own, and recipes beside it.
class ServiceBooks {
public:
    explicit ServiceBooks(const Clock &clock)
        : m_clock(clock)
    {
        needCoreApplication();
        open();
    }
    void open()
    {
        journal.reset();
        settings.reset();
        trials.reset();
        database.reset();
        auto opened = Database::open(path("motorbench.db"));
        ASSERT_TRUE(opened) << opened.error().text();
        database = std::move(*opened);
        trials = std::make_unique<TrialBook>(*database, m_clock);
        settings = std::make_unique<SettingsBook>(*database, m_clock, "anna");
        journal = std::make_unique<ServiceBook>(*database, m_clock, "bench 1", "anna");
    }
    [[nodiscard]] std::string path(const std::string &name) const { return folder.path().toStdString() + '/' + name; }
    void write(const std::string &name, const QByteArray &text) const
    {
        QFile file(QString::fromStdString(path(name)));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    [[nodiscard]] std::vector<service::Visit> visits(const service::VisitFilter &filter = {}) const
    {
        const auto all = journal->list(filter);
        EXPECT_TRUE(all) << (all ? "" : all.error().text());
        return all.value_or(std::vector<service::Visit>{});
    }

    QTemporaryDir folder;
    std::unique_ptr<Database> database;
    std::unique_ptr<TrialBook> trials;
    std::unique_ptr<SettingsBook> settings;
    std::unique_ptr<ServiceBook> journal;

private:
    const Clock &m_clock;
};

/// One queue over a rack from its start to its end.
class QueueRun {
public:
    QueueRun(UnitRack &rack, ServiceBooks &books, service::RecipeMatter matter, service::QueueOptions options = {},
        service::ServiceJournal *journal = nullptr)
        : m_rack(rack)
        , queue(rack.clock, std::move(matter),
              service::QueueSurroundings{
                  journal ? *journal : *books.journal, books.settings.get(), books.trials.get(), &permit, {}},
              std::move(options))
        , m_renewal(rack.clock)
    {
        queue.addBus(*rack.session, *rack.link);
        m_ended = queue.ended().add([this] { isEnded = true; });
        renew();
    }
    bool run(Duration limit = std::chrono::minutes(20))
    {
        isEnded = false;
        queue.start();
        return m_rack.clock.runUntil([this] { return isEnded; }, limit);
    }

private:
    void renew()
    {
        queue.renewLease();
        m_renewal.startIn(std::chrono::milliseconds(100), [this] { renew(); });
    }
    UnitRack &m_rack;

public:
    CountingPermit permit;
    service::ServiceQueue queue;
    bool isEnded = false;

private:
    Timer m_renewal;
    Subscription m_ended;
};

} // namespace mb::test
