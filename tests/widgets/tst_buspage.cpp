// SPDX-License-Identifier: GPL-3.0-or-later
// The Bus page as a person uses it; above all, that no click alone makes a motor move.
#include "busbench.h"
#include "widgets/common/segmented.h"
#include "widgets/monitor/busbar.h"
#include "widgets/monitor/buspage.h"
#include "widgets/monitor/holdbutton.h"
#include "widgets/monitor/idmodel.h"
#include "widgets/monitor/sendpanel.h"
#include "widgets/monitor/trafficview.h"

#include <QCheckBox>
#include <QClipboard>
#include <QScrollBar>
#include <QSpinBox>

using namespace mb;
using namespace mb::test;

namespace {

/// The page over a fake workbench with DMC60C 5 and 7 on one simulated link.
struct BusBench {
    FakeTraffic traffic;
    Duration past{}; ///< since the last frame
    FakeWorkbench workbench;
    ThemeSource theme{darkTheme()};
    Arming arming{workbench};
    std::unique_ptr<BusPage> page;

    BusBench()
    {
        applyTheme(*qApp, theme.theme());
        workbench.shot.links = {canLink(traffic.log)};
        workbench.shot.devices = {readDrive(1, 5), readDrive(2, 7)};
        for (DeviceView &device : workbench.shot.devices)
            device.link = "sim:can";
        page = std::make_unique<BusPage>(workbench, arming, theme);
        page->resize(1280, 760);
        page->show();
        publish();
    }
    void publish()
    {
        past += 250ms;
        workbench.time = traffic.now + past;
        workbench.publish();
        page->tick();
    }
    template <class T> [[nodiscard]] T *named(const char *name) const
    {
        for (T *child : page->findChildren<T *>()) {
            if (child->accessibleName() == QLatin1String(name))
                return child;
        }
        return nullptr;
    }
    [[nodiscard]] SendPanel &panel() const { return *page->findChild<SendPanel *>(); }
    [[nodiscard]] HoldButton &sendButton() const { return *page->findChild<HoldButton *>(); }
    void type(const char *id, const char *data)
    {
        panel().show();
        named<Segmented>("Length of the identifier")->setCurrent(qstrlen(id) > 3 ? 1 : 0);
        named<QLineEdit>("Identifier")->setText(QLatin1String(id));
        named<QLineEdit>("Data")->setText(QLatin1String(data));
    }
    /// Presses for so long.
    void hold(int milliseconds)
    {
        QTest::mousePress(&sendButton(), Qt::LeftButton);
        QTest::qWait(milliseconds);
        QTest::mouseRelease(&sendButton(), Qt::LeftButton);
    }
    /// Presses until it is so; false when that does not come.
    template <class Condition> [[nodiscard]] bool holdUntil(Condition reached)
    {
        QTest::mousePress(&sendButton(), Qt::LeftButton);
        const bool came = QTest::qWaitFor(reached);
        QTest::mouseRelease(&sendButton(), Qt::LeftButton);
        return came;
    }
    [[nodiscard]] QString panelText() const
    {
        QString text;
        for (const QLabel *label : panel().findChildren<QLabel *>())
            text += label->text() + QLatin1Char('\n');
        return text;
    }
    [[nodiscard]] std::size_t sent() const { return workbench.callsOf("sendFrame").size(); }
};

} // namespace

class BusPageTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anOrdinaryFrameGoesByAClick();
    void successIsSaidOnlyWhenTheLinkTookIt();
    void aControlFrameNeedsArmingAndAHeldButton();
    void aShortPressSendsNoControlFrame();
    void aControlFrameIsRefused_data();
    void aControlFrameIsRefused();
    void stopEndsARepetitionAndStopsTheMotor();
    void leavingThePageEndsARepetition();
    void aLinkThatDoesNotTakeFramesEndsARepetition();
    void typedFramesAreChecked_data();
    void typedFramesAreChecked();
    void aFrameFromTheTableIsSentAgain();
    void scrollingBackPausesAndKeepsCounting();
    void theFilterReachesBothTables();
    void aMistakeIsShownAndTheFilterBeforeStays();
    void findMarksAndGoesThere();
    void selectedFramesAreCopiedAsCandumpText();
    void exportReportsWhatItDid();
    void stateShowsLoadAndLoss();
    void theDetailMovesBesideTheIdentifiersWhenNarrow();
    void theDetailIsShortUntilAFrameIsSelected();
    void everyControlSpeaks();
};

void BusPageTest::anOrdinaryFrameGoesByAClick()
{
    BusBench bench;
    bench.type("240", "");
    QVERIFY(!bench.sendButton().isHoldNeeded());
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    QCOMPARE(bench.sent(), std::size_t{1});
    const auto call = bench.workbench.callsOf("sendFrame").front();
    QCOMPARE(call.text, std::string("sim:can"));
    QVERIFY(sameContent(call.frame, canFrameFromText("240#").value()));
    bench.type("02061805", "34 12 3D"); // PARAMREQ
    QVERIFY(bench.panelText().contains(QStringLiteral("PARAMREQ of DMC60C #5")));
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    QCOMPARE(bench.sent(), std::size_t{2});
}

void BusPageTest::successIsSaidOnlyWhenTheLinkTookIt()
{
    BusBench bench;
    bench.type("123", "01 02");
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    QVERIFY(!bench.panelText().contains(QStringLiteral("1 sent")));
    bench.workbench.callsOf("sendFrame").front().finished({});
    QVERIFY(bench.panelText().contains(QStringLiteral("1 sent")));
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    bench.workbench.callsOf("sendFrame").back().finished(fail(Fault::LinkLost, "can0 is down"));
    QVERIFY(bench.panelText().contains(QStringLiteral("can0 is down")));
}

void BusPageTest::aControlFrameNeedsArmingAndAHeldButton()
{
    BusBench bench;
    bench.type("02060005", "71 00 00 00 00 28 00 00");
    QVERIFY(bench.sendButton().isHoldNeeded());
    QVERIFY(!bench.sendButton().isEnabled());
    QVERIFY(bench.panelText().contains(QStringLiteral("DMC60C #5 is not armed")));
    bench.hold(50);
    bench.arming.arm({2}); // another one helps nothing
    QVERIFY(!bench.sendButton().isEnabled());
    bench.arming.arm({1});
    QVERIFY(bench.sendButton().isEnabled());
    QVERIFY(bench.panelText().contains(QStringLiteral("Makes a motor move: CANCTRL0 of DMC60C #5")));
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    QTest::keyClick(&bench.sendButton(), Qt::Key_Space);
    QTest::keyClick(&bench.sendButton(), Qt::Key_Return);
    bench.sendButton().click();
    bench.sendButton().animateClick(1);
    QTest::qWait(20);
    QCOMPARE(bench.sent(), std::size_t{0});
    QCOMPARE(bench.sendButton().holdMilliseconds(), 1000);
    bench.sendButton().setHoldMilliseconds(40);
    QVERIFY(bench.holdUntil([&bench] { return bench.sent() > 0; }));
    QCOMPARE(bench.sent(), std::size_t{1});
    QVERIFY(sameContent(bench.workbench.callsOf("sendFrame").front().frame, canFrameFromText(controlOf5).value()));
}

void BusPageTest::aShortPressSendsNoControlFrame()
{
    BusBench bench;
    bench.arming.arm({1});
    bench.type("02060005", "71 00 00 00 00 28 00 00");
    bench.sendButton().setHoldMilliseconds(400);
    bench.hold(40);
    QTest::mousePress(&bench.sendButton(), Qt::LeftButton);
    bench.arming.stopAll(QStringLiteral("test")); // STOP while it is held
    QTest::qWait(500);
    QTest::mouseRelease(&bench.sendButton(), Qt::LeftButton);
    QCOMPARE(bench.sent(), std::size_t{0});
}

void BusPageTest::aControlFrameIsRefused_data()
{
    QTest::addColumn<QString>("when");
    QTest::addColumn<QString>("says");
    for (const auto &[when, says] : std::initializer_list<std::pair<const char *, const char *>>{
             {"unknown", "No DMC60C #12 is known on this link"},
             {"duplicate", "Two units answer as #5"},
             {"driven", "This window drives DMC60C #5 already"},
             {"busy", "DMC60C #5 is busy: firmware update"},
             {"forbidden", "in its bootloader"},
             {"lost", "the adapter went away"},
             {"unguarded", "it has no watchdog"},
         })
        QTest::newRow(when) << QString::fromLatin1(when) << QString::fromLatin1(says);
}

void BusPageTest::aControlFrameIsRefused()
{
    QFETCH(QString, when);
    QFETCH(QString, says);
    static const Family unguarded = [] {
        Family family = dmc60c();
        family.capabilities.watchdog = false;
        return family;
    }();
    BusBench bench;
    bench.arming.arm({1});
    DeviceView &five = bench.workbench.device(0);
    if (when == QLatin1String("duplicate"))
        bench.workbench.shot.devices.push_back(readDrive(3, 5)), bench.workbench.shot.devices.back().link = "sim:can";
    else if (when == QLatin1String("driven"))
        five.motion.running = true;
    else if (when == QLatin1String("busy"))
        five.busy = "firmware update";
    else if (when == QLatin1String("forbidden"))
        five.mayNotMove = "it is in its bootloader";
    else if (when == QLatin1String("lost"))
        bench.workbench.shot.links[0].state = LinkState::Lost,
        bench.workbench.shot.links[0].reason = "the adapter went away";
    else if (when == QLatin1String("unguarded"))
        five.family = &unguarded;
    const CanFrame frame
        = canFrameFromText(when == QLatin1String("unknown") ? "0206000C#7100000000280000" : controlOf5).value();
    const SendVerdict verdict = judgeFrame(frame, "sim:can", bench.workbench.shot, bench.arming);
    QVERIFY(verdict.control);
    QVERIFY2(verdict.refusal.contains(says), qPrintable(verdict.refusal));
}

void BusPageTest::stopEndsARepetitionAndStopsTheMotor()
{
    BusBench bench;
    bench.arming.arm({1});
    bench.type("02060005", "71 00 00 00 00 28 00 00");
    bench.page->findChild<QCheckBox *>()->setChecked(true);
    bench.named<QSpinBox>("Period")->setValue(5);
    bench.sendButton().setHoldMilliseconds(1);
    std::size_t answered = 0;
    const auto someWent = [&] {
        const auto calls = bench.workbench.callsOf("sendFrame");
        for (; answered < calls.size(); ++answered) // else the panel gives up after fifty
            calls[answered].finished({});
        return answered > 3;
    };
    QVERIFY(bench.holdUntil(someWent));
    QVERIFY(bench.panel().isRepeating());
    QVERIFY(bench.workbench.callsOf("stopMotion").empty());
    bench.arming.stopAll(QStringLiteral("test"));
    QVERIFY(!bench.panel().isRepeating());
    QCOMPARE(bench.workbench.callsOf("stopMotion").size(), std::size_t{1});
    QCOMPARE(bench.workbench.callsOf("stopMotion").front().device.value, 1U);
}

void BusPageTest::leavingThePageEndsARepetition()
{
    BusBench bench;
    bench.type("123", "00");
    bench.page->findChild<QCheckBox *>()->setChecked(true);
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    QVERIFY(bench.panel().isRepeating());
    bench.page->hide();
    QVERIFY(!bench.panel().isRepeating());
    QVERIFY(bench.workbench.callsOf("stopMotion").empty()); // it moved nothing
}

void BusPageTest::aLinkThatDoesNotTakeFramesEndsARepetition()
{
    BusBench bench;
    bench.type("123", "00");
    bench.page->findChild<QCheckBox *>()->setChecked(true);
    bench.named<QSpinBox>("Period")->setValue(5);
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    QTRY_VERIFY(!bench.panel().isRepeating()); // the fake workbench never says that a frame went
    QCOMPARE(bench.sent(), std::size_t{50});
    QVERIFY(bench.panelText().contains(QStringLiteral("does not take frames")));
}

void BusPageTest::typedFramesAreChecked_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<bool>("extended");
    QTest::addColumn<QString>("data");
    QTest::addColumn<QString>("result");
    const auto row = [](const char *id, bool extended, const char *data, const char *result) {
        QTest::newRow(result) << QString::fromLatin1(id) << extended << QString::fromLatin1(data)
                              << QString::fromLatin1(result);
    };
    row("7FF", false, "", "7FF#");
    row("0x123", false, "0a 0B.0c", "123#0A0B0C");
    row("123", true, "00", "00000123#00");
    row("02061405#8125", false, "", "02061405#8125");
    row("(1.0) can0 123#R", true, "", "123#R");
    row("800", false, "", "has more than 11 bits: choose 29 bits");
    row("20000000", true, "", "has more than 29 bits");
    row("12G", false, "", "is hexadecimal");
    row("123", false, "123", "pairs of hexadecimal digits");
    row("123", false, "00 11 22 33 44 55 66 77 88", "at most 8");
    row("123#0", false, "", "is no frame such as");
}

void BusPageTest::typedFramesAreChecked()
{
    QFETCH(QString, id);
    QFETCH(bool, extended);
    QFETCH(QString, data);
    QFETCH(QString, result);
    const TypedFrame typed = readTypedFrame(id, extended, data);
    const QString got = typed.frame ? QString::fromStdString(toText(*typed.frame)) : typed.problem;
    QVERIFY2(typed.frame ? got == result : got.contains(result), qPrintable(got));
}

void BusPageTest::aFrameFromTheTableIsSentAgain()
{
    BusBench bench;
    bench.traffic.add("123#0A0B");
    bench.publish();
    auto *table = bench.named<TrafficView>("Frames");
    table->selectRow(0);
    for (QAbstractButton *button : bench.page->findChildren<QAbstractButton *>()) {
        if (button->text().startsWith(QStringLiteral("Send again")))
            button->click();
    }
    QVERIFY(bench.panel().isVisible());
    QCOMPARE(bench.named<QLineEdit>("Identifier")->text(), QStringLiteral("123"));
    QCOMPARE(bench.named<QLineEdit>("Data")->text(), QStringLiteral("0A 0B"));
    QCOMPARE(bench.sent(), std::size_t{0});
}

void BusPageTest::scrollingBackPausesAndKeepsCounting()
{
    BusBench bench;
    for (int i = 0; i < 500; ++i)
        bench.traffic.add(generalOf5);
    bench.publish();
    auto *table = bench.named<TrafficView>("Frames");
    QVERIFY(table->isAtEnd());
    table->verticalScrollBar()->triggerAction(QAbstractSlider::SliderPageStepSub);
    const int place = table->verticalScrollBar()->value();
    for (int i = 0; i < 500; ++i)
        bench.traffic.add(generalOf7);
    bench.publish();
    QCOMPARE(bench.page->model().rowCount(), 500);
    QCOMPARE(table->verticalScrollBar()->value(), place);
    QCOMPARE(bench.page->ids().rowCount(), 2);
    table->verticalScrollBar()->triggerAction(QAbstractSlider::SliderToMaximum);
    QCOMPARE(bench.page->model().rowCount(), 1000);
    QVERIFY(table->isAtEnd());
}

void BusPageTest::theFilterReachesBothTables()
{
    BusBench bench;
    for (const char *text : {generalOf5, generalOf7, encoderOf5, unknown})
        bench.traffic.add(text);
    bench.traffic.addError(0x08);
    bench.traffic.add(controlOf5, Direction::Sent);
    bench.publish();
    QCOMPARE(bench.page->model().rowCount(), 6);
    bench.page->bar().setFilterText(QStringLiteral("message:STS* device:5"));
    QCOMPARE(bench.page->model().rowCount(), 2);
    QCOMPARE(bench.page->ids().rowCount(), 2);
    auto *direction = bench.named<Segmented>("Direction");
    bench.page->bar().setFilterText({});
    direction->setCurrent(1);
    QCOMPARE(bench.page->model().rowCount(), 4);
    direction->setCurrent(2);
    QCOMPARE(bench.page->model().rowCount(), 1);
    direction->setCurrent(3);
    QCOMPARE(bench.page->model().rowCount(), 1);
    direction->setCurrent(0);
    QCOMPARE(bench.page->model().rowCount(), 6);
}

void BusPageTest::aMistakeIsShownAndTheFilterBeforeStays()
{
    BusBench bench;
    bench.traffic.add(generalOf5);
    bench.traffic.add(generalOf7);
    bench.publish();
    bench.page->bar().setFilterText(QStringLiteral("device:5"));
    bench.page->bar().setFilterText(QStringLiteral("device:5 or"));
    QCOMPARE(bench.page->model().rowCount(), 1);
    bool shown = false;
    for (const QLabel *label : bench.page->bar().findChildren<QLabel *>())
        shown |= label->isVisible() && label->text() == QStringLiteral("a term is missing after 'or'");
    QVERIFY(shown);
}

void BusPageTest::findMarksAndGoesThere()
{
    BusBench bench;
    for (int i = 0; i < 300; ++i)
        bench.traffic.add(i == 20 || i == 30 ? controlOf5 : generalOf5);
    bench.publish();
    bench.named<Segmented>("What the expression does")->setCurrent(1);
    bench.page->bar().setFilterText(QStringLiteral("is:control"));
    QCOMPARE(bench.page->model().rowCount(), 300);
    auto *table = bench.named<TrafficView>("Frames");
    QTest::keyClick(bench.page.get(), Qt::Key_F3);
    Q_EMIT bench.page->bar().findRequested(true);
    const int first = table->currentIndex().row();
    QVERIFY(first == 20 || first == 30); // F3 needs an active window, which offscreen may lack
    bench.page->setPaused(true);
    table->selectRow(25);
    Q_EMIT bench.page->bar().findRequested(true);
    QCOMPARE(table->currentIndex().row(), 30);
    Q_EMIT bench.page->bar().findRequested(false);
    QCOMPARE(table->currentIndex().row(), 20);
    QVERIFY(bench.page->model().isFrozen());
}

void BusPageTest::selectedFramesAreCopiedAsCandumpText()
{
    BusBench bench;
    bench.traffic.add(generalOf5);
    bench.traffic.add(generalOf7);
    bench.traffic.add("123#R");
    bench.publish();
    QCOMPARE(bench.page->selectedText(), QString());
    auto *table = bench.named<TrafficView>("Frames");
    table->selectAll();
    QCOMPARE(bench.page->selectedText(),
        QStringLiteral("(0000000000.000000) sim:can 02061405#A125110008070000\n(0000000000.010000) sim:can "
                       "02061407#FE04110010020000\n"
                       "(0000000000.020000) sim:can 123#R\n"));
}

void BusPageTest::exportReportsWhatItDid()
{
    BusBench bench;
    for (const char *text : {generalOf5, generalOf7, encoderOf5})
        bench.traffic.add(text);
    bench.publish();
    bench.page->bar().setFilterText(QStringLiteral("device:5"));
    QTemporaryDir folder;
    const auto lines = [&folder](const char *name) {
        QFile file(folder.filePath(QLatin1String(name)));
        return file.open(QIODevice::ReadOnly) ? file.readAll().count('\n') : -1;
    };
    bench.page->exportTo(folder.filePath(QStringLiteral("shown.log")), false);
    bench.page->exportTo(folder.filePath(QStringLiteral("all.log")), true);
    QCOMPARE(lines("shown.log"), 2);
    QCOMPARE(lines("all.log"), 3);
    QVERIFY(bench.workbench.lines.back().text.startsWith(QStringLiteral("3 frames written to ")));
    bench.page->exportTo(QStringLiteral("/nonexistent/all.log"), true);
    QCOMPARE(bench.workbench.lines.back().severity, Severity::Danger);
}

void BusPageTest::stateShowsLoadAndLoss()
{
    BusBench bench;
    bench.workbench.shot.links[0].counters = {1391, 0, 7, 0};
    bench.traffic.add(generalOf5);
    bench.traffic.now += 5s;
    bench.publish();
    QString state;
    for (const QLabel *label : bench.page->bar().findChildren<QLabel *>())
        state += label->text();
    QVERIFY2(state.contains(QString::fromUtf8(">6\u00A0%<")), qPrintable(state));
    QVERIFY2(state.contains(QStringLiteral(">7<")), qPrintable(state));
}

void BusPageTest::theDetailMovesBesideTheIdentifiersWhenNarrow()
{
    BusBench bench;
    auto *detail = bench.named<QWidget>("Selected frame");
    const auto right = [&] { return detail->mapTo(bench.page.get(), QPoint(0, 0)); };
    bench.page->resize(1600, 900);
    QTest::qWait(1);
    const QPoint wide = right();
    bench.page->resize(1000, 640);
    QTest::qWait(1);
    QVERIFY(right().y() > wide.y() + 100);
    bench.page->resize(1600, 900);
    QTest::qWait(1);
    QCOMPARE(right().y(), wide.y());
}

void BusPageTest::theDetailIsShortUntilAFrameIsSelected()
{
    BusBench bench;
    const auto *detail = bench.named<QWidget>("Selected frame");
    const auto *copy = detail->findChild<QPushButton *>();
    QVERIFY(!copy->isVisible());
    const int width = detail->minimumSizeHint().width();
    bench.traffic.add(generalOf5);
    bench.publish();
    bench.named<TrafficView>("Frames")->setCurrentIndex(bench.page->model().index(0, 0));
    QVERIFY(copy->isVisible());
    QVERIFY(detail->minimumSizeHint().width() <= std::max(width, detail->minimumWidth())); // nothing of it is cut
    Q_EMIT bench.page->bar().clearRequested();
    QVERIFY(!copy->isVisible());
}

void BusPageTest::everyControlSpeaks()
{
    BusBench bench;
    bench.panel().show();
    for (const QWidget *widget : bench.page->findChildren<QWidget *>()) {
        const bool control = qobject_cast<const QLineEdit *>(widget) || qobject_cast<const QAbstractButton *>(widget)
            || qobject_cast<const QAbstractItemView *>(widget) || qobject_cast<const QSpinBox *>(widget);
        if (!control || !widget->isVisible() || widget->objectName().startsWith(QLatin1String("qt_")))
            continue;
        const auto *button = qobject_cast<const QAbstractButton *>(widget);
        if (qobject_cast<const QAbstractSpinBox *>(widget->parentWidget()))
            continue;
        const QString name = widget->accessibleName().isEmpty() && button ? button->text() : widget->accessibleName();
        QVERIFY2(!name.isEmpty() || widget->inherits("QTableCornerButton"), widget->metaObject()->className());
    }
}

QTEST_MAIN(BusPageTest)
#include "tst_buspage.moc"
