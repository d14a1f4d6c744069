// SPDX-License-Identifier: GPL-3.0-or-later
// The two models of the Bus page: every frame in order, and a row for each identifier.
#include "busbench.h"
#include "support/windowtests.h"
#include "widgets/common/numberformat.h"
#include "widgets/monitor/frameexport.h"
#include "widgets/monitor/frametext.h"
#include "widgets/monitor/idmodel.h"
#include "widgets/monitor/trafficdelegate.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>

using namespace mb;
using namespace mb::test;

class BusModelsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void framesAppearDecodedInTheirOrder();
    void whatCameTooFastIsCounted();
    void theOldestLeaveWhenItIsFull();
    void filteringLooksAtWhatWasKept();
    void frozenRowsStayWhileFramesAreKept();
    void searchFindsBothWays();
    void bytesOfASerialLineHaveRowsToo();
    void packetsOfABoardAreDecodedWithWhatTheyAnswer();
    void errorFramesHaveRows();
    void aDialectDecidesHowADeviceIsRead();
    void aVoltageLogIsOfTheDriveThatWasAsked();
    void identifiersKeepTheirPlaces();
    void identifiersHaveExactNumbers();
    void aLongJitterIsWholeInItsColumn();
    void identifiersFollowTheFilter();
    void sortingMovesRowsOnlyWhenAsked();
    void theChosenFieldIsShownForAllOfItsMessage();
    void changedBytesAreMarkedForAWhile();
    void linesHoldFiveSeconds();
    void exportWritesWhatDecodeReads();
    void exportThatFailsSaysWhy();

private:
    QString cell(const QAbstractItemModel &model, int row, int column) const
    {
        return model.index(row, column).data().toString();
    }
    ThemeSource m_theme{darkTheme()};
};

void BusModelsTest::framesAppearDecodedInTheirOrder()
{
    FakeTraffic traffic;
    FrameModel model(m_theme);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    model.setDecoder(FrameDecoder(families()));
    model.setSource(traffic.log);
    QVERIFY(!model.fetch());
    traffic.add(generalOf5);
    traffic.add(controlOf5, Direction::Sent);
    traffic.add(unknown);
    traffic.add(generalOf5);
    QVERIFY(model.fetch());
    QCOMPARE(model.rowCount(), 4);
    QCOMPARE(cell(model, 0, FrameModel::Time), QStringLiteral("0.0000"));
    QCOMPARE(cell(model, 3, FrameModel::Time), QStringLiteral("0.0300"));
    QCOMPARE(cell(model, 0, FrameModel::Delta), QString::fromUtf8("–"));
    QCOMPARE(cell(model, 3, FrameModel::Delta), QStringLiteral("30.0"));
    QCOMPARE(cell(model, 0, FrameModel::Id), QStringLiteral("02061405"));
    QCOMPARE(cell(model, 0, FrameModel::Message), QStringLiteral("STSGENERAL"));
    QCOMPARE(cell(model, 0, FrameModel::Address), QStringLiteral("5"));
    QVERIFY(cell(model, 0, FrameModel::Decoded).startsWith(QString::fromUtf8("mode=velocity  duty=29.4\u00A0%  err=")));
    QCOMPARE(cell(model, 0, FrameModel::Data), QStringLiteral("A1 25 11 00 08 07 00 00"));
    QCOMPARE(cell(model, 1, FrameModel::Dir), QStringLiteral("tx"));
    QVERIFY(cell(model, 1, FrameModel::Decoded).contains(QString::fromUtf8("target=10\u202F240")));
    QCOMPARE(cell(model, 2, FrameModel::Message), QStringLiteral("unknown"));
    QCOMPARE(model.seen(), 4U);
    QCOMPARE(model.skipped(), 0U);
    model.clear();
    QCOMPARE(model.rowCount(), 0);
    traffic.add(generalOf5);
    QVERIFY(model.fetch());
    QCOMPARE(model.rowCount(), 1);
    QCOMPARE(model.seen(), 1U);
}

void BusModelsTest::whatCameTooFastIsCounted()
{
    FakeTraffic traffic;
    traffic.log = std::make_shared<TrafficLog>(100);
    FrameModel model(m_theme);
    model.setSource(traffic.log);
    for (int i = 0; i < 30; ++i)
        traffic.add(generalOf5);
    model.fetch();
    for (int i = 0; i < 250; ++i)
        traffic.add(generalOf5);
    model.fetch();
    QCOMPARE(model.rowCount(), 130);
    QCOMPARE(model.skipped(), 150U);
    QCOMPARE(model.seen(), 280U);
    for (int i = 0; i < 250; ++i)
        traffic.add(generalOf5);
    model.rejoin(); // the page was hidden
    model.fetch();
    QCOMPARE(model.skipped(), 150U);
}

void BusModelsTest::theOldestLeaveWhenItIsFull()
{
    FakeTraffic traffic;
    FrameModel model(m_theme);
    model.setSource(traffic.log);
    QSignalSpy removed(&model, &QAbstractItemModel::rowsRemoved);
    for (int round = 0; round < 3; ++round) {
        for (int i = 0; i < 40000; ++i)
            traffic.add(generalOf5, Direction::Received, 111us);
        model.fetch();
    }
    QCOMPARE(static_cast<std::size_t>(model.rowCount()), FrameModel::keptRows);
    QCOMPARE(removed.count(), 1);
    QCOMPARE(model.row(0).record.number, 20001U);
    QCOMPARE(model.row(model.rowCount() - 1).record.number, 120000U);
    QCOMPARE(model.skipped(), 0U);
}

void BusModelsTest::filteringLooksAtWhatWasKept()
{
    FakeTraffic traffic;
    FrameModel model(m_theme);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    model.setDecoder(FrameDecoder(families()));
    model.setSource(traffic.log);
    for (int i = 0; i < 10000; ++i)
        traffic.add(i % 100 == 0 ? controlOf5 : generalOf5);
    model.fetch();
    model.setFilter(FrameFilter(QStringLiteral("message:CANCTRL0")));
    QCOMPARE(model.rowCount(), 40); // the newest 4 000 at once
    QTRY_COMPARE(model.rowCount(), 100);
    for (int i = 1; i < model.rowCount(); ++i)
        QCOMPARE(model.row(i).record.number - model.row(i - 1).record.number, 100U);
    traffic.add(controlOf5);
    traffic.add(generalOf5);
    QVERIFY(model.fetch());
    QCOMPARE(model.rowCount(), 101);
    traffic.add(generalOf5);
    QVERIFY(!model.fetch());
    model.setFilter({});
    QCOMPARE(model.rowCount(), 10003);
}

void BusModelsTest::frozenRowsStayWhileFramesAreKept()
{
    FakeTraffic traffic;
    FrameModel model(m_theme);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    model.setSource(traffic.log);
    traffic.add(generalOf5);
    traffic.add(generalOf7);
    model.fetch();
    model.setFrozen(true);
    QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
    for (int round = 0; round < 3; ++round) {
        for (int i = 0; i < 40000; ++i)
            traffic.add(controlOf5);
        QVERIFY(!model.fetch());
    }
    QCOMPARE(model.rowCount(), 2);
    QCOMPARE(inserted.count(), 0);
    QCOMPARE(cell(model, 0, FrameModel::Id), QStringLiteral("02061405"));
    model.setFilter(FrameFilter(QStringLiteral("id:02061407")));
    QCOMPARE(model.rowCount(), 1); // a filter works on frozen rows
    model.setFilter({});
    model.setFrozen(false);
    QCOMPARE(static_cast<std::size_t>(model.rowCount()), FrameModel::keptRows);
    QCOMPARE(model.skipped(), 0U);
    QCOMPARE(model.row(model.rowCount() - 1).record.number, 120002U);
}

void BusModelsTest::searchFindsBothWays()
{
    FakeTraffic traffic;
    FrameModel model(m_theme);
    model.setDecoder(FrameDecoder(families()));
    model.setSource(traffic.log);
    for (const char *text : {generalOf5, controlOf5, generalOf7, controlOf5, generalOf5})
        traffic.add(text);
    model.fetch();
    QCOMPARE(model.findFrom(0, true), -1);
    model.setSearch(FrameFilter(QStringLiteral("is:control")));
    QCOMPARE(model.rowCount(), 5);
    QCOMPARE(model.findFrom(0, true), 1);
    QCOMPARE(model.findFrom(2, true), 3);
    QCOMPARE(model.findFrom(4, true), -1);
    QCOMPARE(model.findFrom(4, false), 3);
    QVERIFY(model.index(1, 0).data(Qt::BackgroundRole).isValid());
    QVERIFY(!model.index(2, 0).data(Qt::BackgroundRole).isValid());
}

void BusModelsTest::bytesOfASerialLineHaveRowsToo()
{
    FakeTraffic traffic;
    FrameModel model(m_theme);
    model.setSource(traffic.log);
    const std::array<std::uint8_t, 3> bytes{0x55, 0x04, 0xFF};
    traffic.log->append(Direction::Sent, traffic.now, bytes);
    model.fetch();
    QCOMPARE(model.rowCount(), 1);
    QCOMPARE(cell(model, 0, FrameModel::Data), QStringLiteral("55 04 FF"));
    QCOMPARE(cell(model, 0, FrameModel::Id), QString::fromUtf8("–"));
    QCOMPARE(cell(model, 0, FrameModel::Dir), QStringLiteral("tx"));
    model.setFilter(FrameFilter(QStringLiteral("data:55* is:tx")));
    QCOMPARE(model.rowCount(), 1);
    model.setFilter(FrameFilter(QStringLiteral("is:unknown")));
    QCOMPARE(model.rowCount(), 0);
    QCOMPARE(QString::fromStdString(trafficLine(model.kept().front().record, "ttyUSB0", WallClock{1s, {}})),
        QStringLiteral("(0000001001.000000) ttyUSB0 tx 5504FF"));
}

void BusModelsTest::packetsOfABoardAreDecodedWithWhatTheyAnswer()
{
    FakeTraffic traffic;
    FrameModel model(m_theme);
    model.setSource(traffic.log, LinkKind::Spi);
    const std::array<std::uint8_t, 4> question{0x02, 0x04, 0x01, 0xF9};
    const std::array<std::uint8_t, 12> answer{0x02, 0x08, 0x01, 0x00, 0x01, 0x03, 0x01, 0xF0, 0x00, 0x00, 0x00, 0x00};
    for (int i = 0; i < 2; ++i) {
        traffic.now += 10ms;
        traffic.log->append(Direction::Sent, traffic.now, question);
        traffic.log->append(Direction::Received, traffic.now, answer);
    }
    model.fetch();
    QCOMPARE(model.rowCount(), 4);
    QCOMPARE(cell(model, 0, FrameModel::Message), QStringLiteral("get version"));
    QCOMPARE(cell(model, 1, FrameModel::Message), QStringLiteral("get version"));
    const QString fields = cell(model, 1, FrameModel::Decoded);
    QVERIFY2(
        fields.contains(QStringLiteral("major=1")) && fields.contains(QStringLiteral("minor=3")), qPrintable(fields));
    QCOMPARE(cell(model, 3, FrameModel::Delta), QStringLiteral("10.0"));
    model.setFilter(FrameFilter(QStringLiteral("message:get* is:rx")));
    QCOMPARE(model.rowCount(), 2);
}

void BusModelsTest::errorFramesHaveRows()
{
    FakeTraffic traffic;
    FrameModel model(m_theme);
    model.setSource(traffic.log);
    model.setDecoder(FrameDecoder(families()));
    traffic.addError(0x20);
    model.fetch();
    QCOMPARE(cell(model, 0, FrameModel::Dir), QStringLiteral("err"));
    QVERIFY(cell(model, 0, FrameModel::Decoded).contains(QStringLiteral("nobody acknowledged")));
    QVERIFY(model.index(0, 0).data(Qt::BackgroundRole).isValid());
}

void BusModelsTest::aDialectDecidesHowADeviceIsRead()
{
    static std::string asked;
    static Family twoTongues = [] {
        Family family = dmc60c();
        family.decodeCan = [](const CanFrame &frame, std::string_view dialect) -> std::optional<DecodedFrame> {
            asked = dialect;
            const bool plain = dialect.empty();
            return DecodedFrame{"two", plain ? "PLAIN" : "OTHER", static_cast<int>(frame.id), !plain, {}};
        };
        return family;
    }();
    const std::array<const Family *, 1> known{&twoTongues};
    FrameDecoder decoder{std::span<const Family *const>(known)};
    decoder.addDialect(&twoTongues, 4, "L");
    QCOMPARE(decoder.decode(canFrameFromText("003#").value())->frame.message, std::string_view("PLAIN"));
    QCOMPARE(decoder.decode(canFrameFromText("004#").value())->frame.message, std::string_view("OTHER"));
    QCOMPARE(asked, std::string("L"));
    QVERIFY(decoder.control(canFrameFromText("003#").value())); // it moves a motor in a dialect that is spoken here
}

void BusModelsTest::aVoltageLogIsOfTheDriveThatWasAsked()
{
    FakeTraffic traffic;
    FrameModel model(m_theme);
    model.setDecoder(FrameDecoder(families()));
    model.setSource(traffic.log);
    traffic.add("680#9CFFFFFF"); // nobody was asked
    traffic.add("387#04", Direction::Sent);
    traffic.add("680#9CFFFFFF");
    QVERIFY(model.fetch());
    QCOMPARE(cell(model, 0, FrameModel::Message), QStringLiteral("voltage log"));
    QCOMPARE(cell(model, 0, FrameModel::Address), QString::fromUtf8("–"));
    QCOMPARE(cell(model, 1, FrameModel::Address), QStringLiteral("3"));
    QCOMPARE(cell(model, 2, FrameModel::Address), QStringLiteral("3"));
    model.setFilter(FrameFilter(QStringLiteral("device:3")));
    QCOMPARE(model.rowCount(), 2);
    model.setFilter(FrameFilter(QStringLiteral("device:0")));
    QCOMPARE(model.rowCount(), 0);
    IdModel ids(m_theme);
    ids.setDecoder(FrameDecoder(families()));
    ids.setSource(traffic.log);
    ids.refresh(traffic.now);
    for (int row = 0; row < ids.rowCount(); ++row) {
        if (cell(ids, row, IdModel::Id) == QStringLiteral("680"))
            QCOMPARE(cell(ids, row, IdModel::Address), QString::fromUtf8("–")); // one identifier of all drives
    }
}

void BusModelsTest::identifiersKeepTheirPlaces()
{
    FakeTraffic traffic;
    IdModel model(m_theme);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    model.setDecoder(FrameDecoder(families()));
    model.setSource(traffic.log);
    for (const char *text : {unknown, generalOf7, generalOf5})
        traffic.add(text);
    model.refresh(traffic.now);
    const QPersistentModelIndex seven = model.index(1, 0);
    QCOMPARE(seven.data().toString(), QStringLiteral("02061407"));
    traffic.add(controlOf5, Direction::Sent);
    traffic.add(controlOf5); // another master
    traffic.add("123#00");
    model.refresh(traffic.now);
    QStringList order;
    for (int i = 0; i < model.rowCount(); ++i)
        order += cell(model, i, IdModel::Id) + cell(model, i, IdModel::Dir);
    QCOMPARE(order,
        QStringList({QStringLiteral("123rx"), QStringLiteral("02060005rx"), QStringLiteral("02060005tx"),
            QStringLiteral("02061405rx"), QStringLiteral("02061407rx"), QStringLiteral("0206144Arx")}));
    QCOMPARE(seven.row(), 4);
}

void BusModelsTest::identifiersHaveExactNumbers()
{
    FakeTraffic traffic;
    traffic.log = std::make_shared<TrafficLog>(16); // the ring overruns, the counts do not
    IdModel model(m_theme);
    model.setDecoder(FrameDecoder(families()));
    model.setSource(traffic.log);
    for (int i = 0; i < 1000; ++i) {
        traffic.add(generalOf5, Direction::Received, i % 2 == 0 ? 4ms : 6ms);
        traffic.add(encoderOf5, Direction::Received, i % 2 == 0 ? 5ms : 5ms);
    }
    model.refresh(traffic.now + 1ms);
    QCOMPARE(model.rowCount(), 2);
    QCOMPARE(cell(model, 0, IdModel::Count), QString::fromUtf8("1\u202F000"));
    QCOMPARE(cell(model, 0, IdModel::Rate), QStringLiteral("100"));
    QCOMPARE(cell(model, 0, IdModel::Jitter), QStringLiteral("1.00"));
    QCOMPARE(cell(model, 0, IdModel::Value), QString::fromUtf8("duty 29.4\u00A0%"));
    QCOMPARE(cell(model, 1, IdModel::Message), QStringLiteral("STSENCODER"));
    QVERIFY(model.busiest() != nullptr);
    QCOMPARE(model.busiest()->rate, 100.0);
    model.refresh(traffic.now + 3s);
    QCOMPARE(cell(model, 0, IdModel::Rate), QStringLiteral("0"));
    QCOMPARE(cell(model, 0, IdModel::Jitter), QString(UnknownMark)); // of what comes no more
    QVERIFY(model.busiest() == nullptr);
}

void BusModelsTest::aLongJitterIsWholeInItsColumn()
{
    FakeTraffic traffic;
    IdModel model(m_theme);
    model.setDecoder(FrameDecoder(families()));
    model.setSource(traffic.log);
    for (int i = 0; i < 100; ++i)
        traffic.add(generalOf5, Direction::Received, i % 2 == 0 ? 1000ms : 26000ms);
    model.refresh(traffic.now + 1ms);
    QCOMPARE(cell(model, 0, IdModel::Jitter), QString::fromUtf8("12\u202F500"));
}

void BusModelsTest::identifiersFollowTheFilter()
{
    FakeTraffic traffic;
    IdModel model(m_theme);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    model.setDecoder(FrameDecoder(families()));
    model.setSource(traffic.log);
    for (const char *text : {unknown, generalOf7, generalOf5, controlOf5})
        traffic.add(text);
    model.refresh(traffic.now);
    QCOMPARE(model.rowCount(), 4);
    model.setFilter(FrameFilter(QStringLiteral("device:5")));
    QCOMPARE(model.rowCount(), 2);
    traffic.add(encoderOf5);
    model.refresh(traffic.now);
    QCOMPARE(model.rowCount(), 3);
    model.setFilter({});
    QCOMPARE(model.rowCount(), 5);
    model.setFilter(FrameFilter(QStringLiteral("field.dtcApplied>20%")));
    QCOMPARE(model.rowCount(), 1);
    traffic.add("02061405#0000110008070000");
    model.refresh(traffic.now);
    QCOMPARE(model.rowCount(), 1); // it passed once: a row that comes and goes helps nobody
}

void BusModelsTest::sortingMovesRowsOnlyWhenAsked()
{
    FakeTraffic traffic;
    IdModel model(m_theme);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    model.setDecoder(FrameDecoder(families()));
    model.setSource(traffic.log);
    traffic.add(generalOf5);
    traffic.add(generalOf7);
    traffic.add(generalOf7);
    model.refresh(traffic.now);
    const QPersistentModelIndex five = model.index(0, 0);
    model.sort(IdModel::Count, Qt::DescendingOrder);
    QCOMPARE(five.row(), 1);
    for (int i = 0; i < 5; ++i)
        traffic.add(generalOf5);
    model.refresh(traffic.now);
    QCOMPARE(five.row(), 1);
    model.sort(IdModel::Count, Qt::DescendingOrder);
    QCOMPARE(five.row(), 0);
    model.sort(IdModel::Id, Qt::AscendingOrder);
    QCOMPARE(five.row(), 0);
}

void BusModelsTest::theChosenFieldIsShownForAllOfItsMessage()
{
    FakeTraffic traffic;
    IdModel model(m_theme);
    model.setDecoder(FrameDecoder(families()));
    model.setSource(traffic.log);
    traffic.add(generalOf5);
    traffic.add(generalOf7);
    traffic.add(unknown);
    model.refresh(traffic.now);
    model.chooseField(0, QStringLiteral("modeSelect"));
    QCOMPARE(cell(model, 0, IdModel::Value), QStringLiteral("mode velocity"));
    QCOMPARE(cell(model, 1, IdModel::Value), QStringLiteral("mode position"));
    model.chooseField(2, QStringLiteral("modeSelect"));
    QCOMPARE(cell(model, 2, IdModel::Value), QString::fromUtf8("–"));
}

void BusModelsTest::changedBytesAreMarkedForAWhile()
{
    FakeTraffic traffic;
    IdModel model(m_theme);
    model.setSource(traffic.log);
    traffic.add("123#0102");
    traffic.add("123#0103");
    model.refresh(traffic.now);
    QCOMPARE(model.index(0, IdModel::Data).data(TrafficDelegate::BytesRole).toInt(), 2);
    model.refresh(traffic.now + 1s);
    QCOMPARE(model.index(0, IdModel::Data).data(TrafficDelegate::BytesRole).toInt(), 0);
}

void BusModelsTest::linesHoldFiveSeconds()
{
    FakeTraffic traffic;
    IdModel model(m_theme);
    model.setDecoder(FrameDecoder(families()));
    model.setSource(traffic.log);
    for (int i = 0; i < 20; ++i)
        traffic.add(i < 10 ? "02061405#0040110008070000" : "02061405#0020110008070000", Direction::Received, 100ms);
    model.refresh(traffic.now);
    auto values = model.index(0, IdModel::Spark).data(TrafficDelegate::SparkRole).value<QVector<double>>();
    QCOMPARE(values.size(), 100);
    QVERIFY(qIsNaN(values.front())); // 2 s of 5
    QCOMPARE(values[70], 16384.0);
    QCOMPARE(values.back(), 8192.0);
    traffic.add("02061405#0010110008070000", Direction::Received, 100ms);
    model.refresh(traffic.now);
    values = model.index(0, IdModel::Spark).data(TrafficDelegate::SparkRole).value<QVector<double>>();
    QCOMPARE(values.back(), 4096.0);
    QCOMPARE(values[98], 8192.0);
    model.chooseField(0, QStringLiteral("modeSelect"));
    values = model.index(0, IdModel::Spark).data(TrafficDelegate::SparkRole).value<QVector<double>>();
    QCOMPARE(values.back(), 1.0);
}

void BusModelsTest::exportWritesWhatDecodeReads()
{
    FakeTraffic traffic;
    traffic.add(generalOf5);
    traffic.add("123#R");
    traffic.add(controlOf5, Direction::Sent);
    std::vector<TrafficRecord> records;
    traffic.log->fetch(0, 100, records);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("bus.log"));
    const auto at = [&records](int i) -> const TrafficRecord & { return records[static_cast<std::size_t>(i)]; };
    QVERIFY(exportTraffic(path, 3, at, "can0", WallClock{500s, {}}));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(),
        QByteArray("(0000001500.010000) can0 02061405#A125110008070000\n(0000001500.020000) can0 123#R\n"
                   "(0000001500.030000) can0 02060005#7100000000280000\n"));
}

void BusModelsTest::exportThatFailsSaysWhy()
{
    const auto written = exportTraffic(
        QStringLiteral("/nonexistent/bus.log"), 0, [](int) -> const TrafficRecord & { abort(); }, "can0", {});
    QVERIFY(!written);
    QVERIFY(written.error().text().starts_with("/nonexistent/bus.log cannot be written: "));
}

MB_WINDOW_TEST(BusModelsTest);
#include "tst_busmodels.moc"
