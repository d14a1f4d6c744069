// SPDX-License-Identifier: GPL-3.0-or-later
// What devices tell of their limits and pins stands where one looks: list, line, card, and under the line on Tune.
#include "parameterbench.h"
#include "support/utf8.h"
#include "support/windowtests.h"
#include "tunebench.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/valuelabel.h"
#include "widgets/connection/devicecard.h"
#include "widgets/connection/deviceline.h"
#include "widgets/connection/devicemodel.h"
#include "widgets/connection/inspector.h"
#include "widgets/connection/livestatebar.h"
#include "widgets/plots/signallist.h"

#include <QListWidget>

#include <map>

using namespace mb;
using namespace mb::test;

class LiveStatesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aLimitThatHoldsIsSaidEverywhere();
    void aHaltIsNoAlert();
    void pinsChangeWhatIsDrawn();
    void thePinsAreThoseOfTheAxisThatIsSelected();
    void aMoveThatIsKeptIsSaidWithItsGlyph();
    void whereThereIsLittleRoomTheBarIsShownWhileSomethingHolds();
    void theBarKeepsItsHeightAndHidesForFamiliesThatTellNothing();
    void oneSampleReadsTheSameEverywhere_data();
    void oneSampleReadsTheSameEverywhere();
    void aNameThatIsTheFamilysLeavesItsRoomToTheFirmware();
    void aDeviceThatIsGoneTakesItsLineAndItsNumbersAlong();

private:
    ThemeSource m_theme{lightTheme()};
};

namespace {

DeviceView drive()
{
    DeviceView device = readDrive();
    device.telemetry = std::make_shared<Telemetry>(dmc60c().channels);
    return device;
}

StateIndex state(const char *key)
{
    return findState(dmc60c().states, key).value();
}

/// Whether something is painted from now on.
class Painted : public QObject {
public:
    Painted(QWidget &part, bool &seen)
        : m_seen(seen)
    {
        part.installEventFilter(this);
    }
    bool eventFilter(QObject *, QEvent *event) override
    {
        m_seen = m_seen || event->type() == QEvent::Paint;
        return false;
    }

private:
    bool &m_seen;
};

bool shows(const QWidget &part, const QString &words)
{
    const auto labels = part.findChildren<QLabel *>();
    return std::any_of(
        labels.begin(), labels.end(), [&](const QLabel *label) { return label->text().contains(words); });
}

} // namespace

void LiveStatesTest::aLimitThatHoldsIsSaidEverywhere()
{
    FakeWorkbench workbench;
    Selection selection;
    workbench.shot.devices.push_back(drive());
    selection.select({1});
    DeviceLine line(workbench, selection, m_theme);
    line.resize(1100, 40);
    line.setWanted(true);
    DeviceCard card(m_theme, nullptr);
    const QString words = QStringLiteral("forward limit switch holds");
    QVERIFY(!lineOf(workbench.device(0)).contains(words));
    QVERIFY(shows(line, QStringLiteral("no faults")));
    workbench.device(0).states.set(state("limit.forward.switch"), true);
    workbench.publish();
    card.show(workbench.device(0), {}, false);
    QVERIFY(lineOf(workbench.device(0)).contains(words));
    QVERIFY(tooltipOf(workbench.device(0)).contains(words));
    QVERIFY(shows(line, words));
    QVERIFY(shows(card, words));
    workbench.device(0).liveness.faults = {"over_temperature"};
    workbench.publish();
    QVERIFY(shows(line, QStringLiteral("over-temperature"))); // a fault matters more
    workbench.device(0).liveness.faults.clear();
    workbench.device(0).liveness.heard = false;
    workbench.publish();
    card.show(workbench.device(0), {}, false);
    for (const QWidget *part : {static_cast<QWidget *>(&line), static_cast<QWidget *>(&card)})
        QVERIFY2(shows(*part, QStringLiteral("no answer")), "what it said last is not true for ever");
}

void LiveStatesTest::aHaltIsNoAlert()
{
    DeviceView device = drive();
    device.states.set(state("halted"), true);
    QCOMPARE(conditionsText(device), QStringList{QStringLiteral("halted")});
    QVERIFY(alertsOf(device).isEmpty());
}

void LiveStatesTest::pinsChangeWhatIsDrawn()
{
    FakeWorkbench workbench;
    Selection selection;
    workbench.shot.devices.push_back(drive());
    selection.select({1});
    LiveStateBar bar(workbench, selection, m_theme);
    bar.setWanted(LiveStateBar::Wanted::Always);
    bar.resize(1100, bar.height());
    QVERIFY(bar.isVisible());
    workbench.device(0).states.set(state("input.encoder.a"), false);
    workbench.publish();
    const QImage off = bar.grab().toImage();
    QVERIFY(bar.accessibleDescription().contains(QStringLiteral("Encoder pin A: off")));
    workbench.device(0).states.set(state("input.encoder.a"), true);
    workbench.publish();
    QVERIFY(bar.grab().toImage() != off);
    QVERIFY(bar.accessibleDescription().contains(QStringLiteral("Encoder pin A: on")));
    QVERIFY(bar.accessibleDescription().contains(QString::fromUtf8("Encoder pin B: –")));
}

void LiveStatesTest::thePinsAreThoseOfTheAxisThatIsSelected()
{
    FakeWorkbench workbench;
    Selection selection;
    workbench.shot.devices.push_back(boardAt("sim:spi"));
    selection.select({2}, 1);
    LiveStateBar bar(workbench, selection, m_theme);
    bar.setWanted(LiveStateBar::Wanted::Always);
    bar.resize(1100, bar.height());
    const QImage first = bar.grab().toImage();
    QCoreApplication::processEvents();
    bool painted = false;
    const Painted watch(bar, painted);
    selection.select({2}, 3);
    QTRY_VERIFY(painted);
    QVERIFY(bar.grab().toImage() != first);
}

void LiveStatesTest::aMoveThatIsKeptIsSaidWithItsGlyph()
{
    FakeWorkbench workbench;
    Selection selection;
    workbench.shot.devices.push_back(drive());
    selection.select({1});
    LiveStateBar bar(workbench, selection, m_theme);
    bar.setWanted(LiveStateBar::Wanted::Always);
    QVERIFY(!bar.words().contains(QStringLiteral("keeps a move")));
    workbench.device(0).kept.state = KeptMove::State::Stale;
    workbench.publish();
    QVERIFY(bar.words().contains(QStringLiteral("keeps a move")));
    workbench.device(0).states.set(state("halted"), true);
    workbench.publish();
    QCOMPARE(bar.words(), QStringLiteral("keeps a move, halted"));
}

void LiveStatesTest::whereThereIsLittleRoomTheBarIsShownWhileSomethingHolds()
{
    FakeWorkbench workbench;
    Selection selection;
    workbench.shot.devices.push_back(drive());
    selection.select({1});
    LiveStateBar bar(workbench, selection, m_theme);
    bar.setWanted(LiveStateBar::Wanted::IfSomethingHolds);
    workbench.device(0).states.set(state("halted"), true);
    workbench.publish();
    QVERIFY(bar.isHidden());
    workbench.device(0).states.set(state("limit.forward.switch"), true);
    workbench.publish();
    QVERIFY(!bar.isHidden());
    workbench.device(0).states.set(state("limit.forward.switch"), false);
    workbench.publish();
    QVERIFY(!bar.isHidden()); // the page stays where it is
    bar.setWanted(LiveStateBar::Wanted::Never);
    QVERIFY(bar.isHidden());
    bar.setWanted(LiveStateBar::Wanted::IfSomethingHolds);
    QVERIFY(bar.isHidden());
    workbench.device(0).kept.state = KeptMove::State::Acknowledged;
    workbench.publish();
    QVERIFY(!bar.isHidden());
}

void LiveStatesTest::theBarKeepsItsHeightAndHidesForFamiliesThatTellNothing()
{
    FakeWorkbench workbench;
    Selection selection;
    workbench.shot.devices.push_back(drive());
    DeviceView other = drive();
    other.id = {2};
    other.family = findFamily(families(), "abstractdc");
    workbench.shot.devices.push_back(other);
    selection.select({1});
    LiveStateBar bar(workbench, selection, m_theme);
    QVERIFY(bar.isHidden());
    bar.setWanted(LiveStateBar::Wanted::Always);
    const QSize size = bar.sizeHint();
    for (std::uint16_t i = 0; i < dmc60c().states.size(); ++i) {
        workbench.device(0).states.set({i}, true);
        workbench.publish();
        QCOMPARE(bar.sizeHint(), size);
        QVERIFY(bar.isVisible());
    }
    selection.select({2});
    QVERIFY(bar.isHidden());
}

void LiveStatesTest::oneSampleReadsTheSameEverywhere_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<double>("amount");
    QTest::addColumn<QString>("current");
    QTest::newRow("amperes") << s("dmc60c") << -0.062 << s("−0.06 A");
    QTest::newRow("of a converter, until somebody said what a count is") << s("abstractdc") << 17.0 << s("17 ADC");
}

void LiveStatesTest::oneSampleReadsTheSameEverywhere()
{
    QFETCH(QString, family);
    QFETCH(double, amount);
    QFETCH(QString, current);
    FakeWorkbench workbench;
    Selection selection;
    addLink(workbench.shot, "can0");
    DeviceView device = drive();
    device.link = "can0";
    device.family = findFamily(families(), family.toStdString());
    device.identity.edit().family = family.toStdString();
    device.parameters.edit().assign(device.family->parameters.size(), {});
    const auto telemetry = std::make_shared<Telemetry>(device.family->channels);
    const std::map<QString, std::pair<double, QString>> samples{{s("velocity"), {-59987.4, s("−59 987 counts/s")}},
        {s("current"), {amount, current}}, {s("duty"), {0.1834, s("18.3 %")}}};
    for (const auto &[channel, sample] : samples)
        telemetry->append({*telemetry->find(channel.toStdString()), workbench.time, sample.first});
    telemetry->commit();
    device.telemetry = telemetry;
    workbench.shot.devices.push_back(device);
    selection.select({1});
    DeviceLine line(workbench, selection, m_theme);
    line.resize(1100, 40);
    line.setWanted(true);
    Inspector inspector(workbench, selection, m_theme);
    inspector.show();
    const DeviceModel tree(workbench);
    SignalList plots(m_theme);
    plots.setDevices(workbench.shot.devices);
    workbench.publish();
    DeviceCard card(m_theme, nullptr);
    card.show(workbench.device(0), workbench.time, false);
    const auto plain
        = [](QString text) { return text.replace(QChar::Nbsp, QLatin1Char(' ')).replace(ThinSpace, QLatin1Char(' ')); };
    QVERIFY(plain(lineOf(workbench.device(0))).endsWith(samples.at(s("velocity")).second));
    for (const auto &[channel, sample] : samples) {
        const QString &expected = sample.second;
        for (const QWidget *part : std::initializer_list<const QWidget *>{&line, &card, &inspector}) {
            const auto labels = part->findChildren<ValueLabel *>();
            const auto label = std::find_if(labels.begin(), labels.end(),
                [&channel = channel](const ValueLabel *one) { return one->accessibleName() == channel; });
            QVERIFY(label != labels.end());
            QTRY_COMPARE(plain((*label)->accessibleDescription()), expected); // told once a second
        }
        const ChannelIndex index = *telemetry->find(channel.toStdString());
        const QModelIndex row = tree.index(index.value, 0, tree.indexOf({1}));
        QCOMPARE(plain(row.data(DeviceModel::DetailRole).toString()), expected);
        const auto listed = plots.list().findItems(s("#5 ") + channel, Qt::MatchExactly);
        QCOMPARE(listed.size(), 1);
        QCOMPARE(listed.first()->data(SignalList::UnitRole).toString(), expected.section(QLatin1Char(' '), -1));
    }
}

void LiveStatesTest::aNameThatIsTheFamilysLeavesItsRoomToTheFirmware()
{
    FakeWorkbench workbench;
    Selection selection;
    workbench.shot.devices.push_back(drive());
    workbench.device(0).identity.edit().name = dmc60c().title;
    selection.select({1});
    DeviceLine line(workbench, selection, m_theme);
    line.resize(1048, 40);
    line.setWanted(true);
    const auto tells = [&line](const QString &name) {
        const auto labels = line.findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(),
            [&name](const QLabel *label) { return label->isVisible() && label->text() == name; });
    };
    QVERIFY(!tells(QStringLiteral("DMC60C")));
    workbench.device(0).identity.edit().name = "left drive";
    workbench.publish();
    QVERIFY(tells(QStringLiteral("left drive")));
}

void LiveStatesTest::aDeviceThatIsGoneTakesItsLineAndItsNumbersAlong()
{
    FakeWorkbench workbench;
    Selection selection;
    DeviceLine line(workbench, selection, m_theme);
    Inspector inspector(workbench, selection, m_theme);
    line.setWanted(true);
    inspector.show();
    const auto told = [&inspector] {
        QStringList values;
        for (const ValueLabel *label : inspector.findChildren<ValueLabel *>()) {
            if (const QString value = label->value(); value != QString(UnknownMark))
                values << value;
        }
        return values;
    };
    QVERIFY(!line.isVisible());
    workbench.shot.devices.push_back(drive());
    selection.select({1});
    QVERIFY(line.isVisible());
    QVERIFY(told().contains(QStringLiteral("2103343A79F2")));
    workbench.shot.devices.clear();
    workbench.publish();
    QVERIFY(!line.isVisible());
    QCOMPARE(told(), QStringList());
}

MB_WINDOW_TEST(LiveStatesTest);
#include "tst_livestates.moc"
