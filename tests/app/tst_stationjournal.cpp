// SPDX-License-Identifier: GPL-3.0-or-later
// The journal that this window shares with other stations: a real server, silent for a while.
#include "app/trialstore.h"
#include "support/postgresserver.h"
#include "support/windowtests.h"
#include "transport/qtclock.h"

#include <QTemporaryDir>
#include <QTest>

#include <mutex>
#include <set>

using namespace mb;

namespace {

constexpr int stationPatience = 30000; // ms

service::Visit visitOf(const char *id)
{
    service::Visit visit;
    visit.id = id;
    visit.run = "run";
    visit.time = 100.0;
    visit.station = "bench 2";
    visit.unit = id;
    return visit;
}

struct Station {
    QtClock clock;
    std::mutex mutex;
    int waiting = -1;
    Message trouble;
    int opened = 0;
    std::set<int> numbers;
    int asked = 0;
    TrialStore store;

    Station(const QTemporaryDir &folder, const std::string &url)
        : store(folder.filePath(QStringLiteral("motorbench.db")).toStdString(), clock, "anna")
    {
        store.followJournal([this](int count, const Message &why) {
            const std::lock_guard lock(mutex);
            waiting = count;
            trouble = why;
        });
        store.keepJournal({"bench 2", *JournalServer::parse(url)});
    }
    void open(const char *id)
    {
        store.askJournal<service::Visit>(
            [visit = visitOf(id)](service::ServiceJournal &journal) { return journal.open(visit); },
            [this](const Result<service::Visit> &visit) {
                const std::lock_guard lock(mutex);
                opened += visit ? 1 : 0;
            });
    }
    void takeNumber()
    {
        store.askJournal<std::optional<int>>(
            [unit = "unit " + std::to_string(++asked)](service::ServiceJournal &journal) {
                return journal.number({"dmc60c", unit, unit, 10, 62, {}});
            },
            [this](const Result<std::optional<int>> &number) {
                const std::lock_guard lock(mutex);
                numbers.insert(number ? number->value_or(-1) : -1);
            });
    }
    template <class T> [[nodiscard]] T read(T Station::*what)
    {
        const std::lock_guard lock(mutex);
        return this->*what;
    }
};

std::size_t countOn(const std::string &url)
{
    const auto visits = JournalServer::parse(url)->visits({});
    return visits ? visits->size() : 0;
}

} // namespace

class StationJournalTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void entriesReachTheServerOnceAlsoThoseOfTheTimeWhenItWasSilent();
};

void StationJournalTest::entriesReachTheServerOnceAlsoThoseOfTheTimeWhenItWasSilent()
{
    test::PostgresServer server;
    if (!server.isInstalled())
        QSKIP("postgresql is not installed");
    QVERIFY(server.start());
    QVERIFY(JournalServer::parse(server.url())->prepare());
    const QTemporaryDir folder;
    {
        Station station(folder, server.url());
        station.open("A");
        QTRY_COMPARE_WITH_TIMEOUT(countOn(server.url()), std::size_t(1), stationPatience);
        station.takeNumber();
        QTRY_COMPARE_WITH_TIMEOUT(station.read(&Station::numbers), std::set<int>{10}, stationPatience);
        server.stop();
        station.open("B");
        QTRY_COMPARE_WITH_TIMEOUT(station.read(&Station::opened), 2, stationPatience); // the station goes on without it
        QTRY_VERIFY_WITH_TIMEOUT(!station.read(&Station::trouble).empty(), stationPatience);
        QCOMPARE(station.read(&Station::waiting), 1);
        for (int i = 0; i < 4; ++i) // the rest of its block of five
            station.takeNumber();
        QTRY_COMPARE_WITH_TIMEOUT(
            station.read(&Station::numbers), (std::set<int>{10, 11, 12, 13, 14}), stationPatience);
        QVERIFY(server.start());
        QTRY_COMPARE_WITH_TIMEOUT(station.read(&Station::waiting), 0, stationPatience);
        QVERIFY(station.read(&Station::trouble).empty());
        QCOMPARE(countOn(server.url()), std::size_t(2));
        server.stop();
        station.open("C"); // and the program ends
        QTRY_COMPARE_WITH_TIMEOUT(station.read(&Station::opened), 3, stationPatience);
    }
    QVERIFY(server.start());
    QCOMPARE(countOn(server.url()), std::size_t(2));
    Station again(folder, server.url());
    QTRY_COMPARE_WITH_TIMEOUT(countOn(server.url()), std::size_t(3), stationPatience);
    QTRY_COMPARE_WITH_TIMEOUT(again.read(&Station::waiting), 0, stationPatience);
}

MB_WINDOW_TEST(StationJournalTest);
#include "tst_stationjournal.moc"
