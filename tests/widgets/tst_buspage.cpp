// SPDX-License-Identifier: GPL-3.0-or-later
// The Bus page as a person uses it: tables, filter, search, copies, files, its two arrangements.
#include "buspagebench.h"
#include "support/windowtests.h"
#include "widgets/common/emptystate.h"
#include "widgets/monitor/framemodel.h"
#include "widgets/monitor/logpage.h"
#include "widgets/monitor/noticemodel.h"
#include "widgets/monitor/recordstrip.h"

#include <QHeaderView>

#include <QFileDialog>
#include <QScrollBar>
#include <QTableView>
#include <QTemporaryDir>
#include <set>
#include <utility>

using namespace mb;
using namespace mb::test;

namespace {

QString stateOf(const BusBench &bench)
{
    QString state;
    for (const QLabel *label : bench.page->bar().findChildren<QLabel *>())
        state += label->text();
    return state;
}

} // namespace

class BusPageTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void scrollingBackPausesAndKeepsCounting();
    void theFilterReachesBothTables();
    void aMistakeIsShownAndTheFilterBeforeStays();
    void findMarksAndGoesThere();
    void selectedFramesAreCopiedAsCandumpText();
    void exportReportsWhatItDid();
    void stateShowsLoadAndLoss();
    void aLineOfBytesIsNotCountedInFrames();
    void aLoadThatIsNotKnownIsNotZero();
    void theDetailMovesBesideTheIdentifiersWhenNarrow();
    void theDetailIsShortUntilAFrameIsSelected();
    void theLogStaysWhereSomebodyReadsIt();
    void theOrdersStandInOneLineBesideTheDevices();
    void someFramesAreInSightAtTwiceTheFont();
    void theBusiestIdentifierStandsFirst();
    void aTimeOfTheLogIsWhole();
    void withoutALinkItSaysHowToGetOne();
    void whatALinkLeftStaysWhenItIsClosed();
    void everyControlSpeaks();
    void closingALinkMovesTheViewToNoOther();
    void aLinkThatIsClosedIsSaidAndNothingIsSentOnAnother();
    void aRecordingIsOfTheLinkThatItWasAskedFor();
};

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
    const QString state = stateOf(bench);
    QVERIFY2(state.contains(QString::fromUtf8(">6\u00A0%<")), qPrintable(state));
    QVERIFY2(state.contains(QStringLiteral(">7<")), qPrintable(state));
}

void BusPageTest::aLineOfBytesIsNotCountedInFrames()
{
    BusBench bench;
    bench.workbench.shot.links[0].kind = LinkKind::Spi;
    bench.traffic.now += 5s;
    bench.publish();
    const QString state = stateOf(bench);
    QVERIFY2(!state.contains(QStringLiteral("frames/s")), qPrintable(state));
    QVERIFY2(state.contains(QStringLiteral("bytes/s")), qPrintable(state));
}

void BusPageTest::aLoadThatIsNotKnownIsNotZero()
{
    BusBench bench;
    bench.workbench.shot.links[0].kind = LinkKind::Spi;
    bench.workbench.shot.links[0].bitrate = 0; // as of a socket
    bench.workbench.shot.links[0].load.reset();
    bench.traffic.now += 5s;
    bench.publish();
    const QString state = stateOf(bench);
    QVERIFY2(!state.contains(QStringLiteral("%")), qPrintable(state));
}

void BusPageTest::theDetailMovesBesideTheIdentifiersWhenNarrow()
{
    BusBench bench;
    auto *detail = bench.named<QWidget>("Selected frame");
    const auto right = [&] { return detail->mapTo(bench.page.get(), QPoint(0, 0)); };
    bench.page->resize(1600, 900);
    QTest::qWait(0);
    const QPoint wide = right();
    bench.page->resize(1000, 640);
    QTest::qWait(0);
    QVERIFY(right().y() > wide.y() + 100);
    bench.page->resize(1600, 900);
    QTest::qWait(0);
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

void BusPageTest::aTimeOfTheLogIsWhole()
{
    BusBench bench;
    bench.workbench.report(Severity::Info, QStringLiteral("DMC60C #5"), QStringLiteral("something"));
    LogPage log(bench.workbench, bench.theme, nullptr);
    log.resize(1048, 640);
    log.show();
    const auto *table = log.findChild<QTableView *>();
    const QModelIndex time = table->model()->index(0, NoticeModel::Time);
    QVERIFY(time.isValid());
    QVERIFY(table->columnWidth(NoticeModel::Time) >= table->sizeHintForIndex(time).width());
    log.resize(395, 400); // at twice the font, beside the devices
    QVERIFY(table->isColumnHidden(NoticeModel::Device));
    QVERIFY(table->columnWidth(NoticeModel::Text) > 180);
    QCOMPARE(table->model()->index(0, NoticeModel::Text).data().toString(), QStringLiteral("DMC60C #5: something"));
}

void BusPageTest::theLogStaysWhereSomebodyReadsIt()
{
    BusBench bench;
    const auto say = [&bench] { bench.workbench.report(Severity::Info, {}, QStringLiteral("something")); };
    LogPage log(bench.workbench, bench.theme, nullptr);
    log.resize(1048, 300);
    log.show();
    for (int i = 0; i < 100; ++i)
        say();
    QScrollBar &bar = *log.findChild<QTableView *>()->verticalScrollBar();
    QVERIFY(bar.maximum() > 0);
    QCOMPARE(bar.value(), bar.maximum());
    bar.setValue(5);
    say();
    QCOMPARE(bar.value(), 5);
    bar.setValue(bar.maximum());
    say();
    QCOMPARE(bar.value(), bar.maximum());
    log.resize(1048, 200); // a bar above it came
    QCoreApplication::processEvents();
    QCOMPARE(bar.value(), bar.maximum());
    say();
    QCOMPARE(bar.value(), bar.maximum());
}

/// The page of a window of 1280×800.
void BusPageTest::theOrdersStandInOneLineBesideTheDevices()
{
    QFont font = QApplication::font();
    font.setPointSizeF(darkTheme().bodyPointSize);
    QApplication::setFont(font);
    BusBench bench;
    for (const char *name : {"serial", "spi"}) {
        LinkView other = bench.workbench.shot.links.front();
        other.address = "sim:" + std::string(name);
        other.name = other.address;
        bench.workbench.shot.links.push_back(other);
    }
    bench.page->resize(1092, 640); // at 100 dpi
    bench.publish();
    QCoreApplication::processEvents();
    std::set<int> lines;
    for (const auto *button : bench.page->bar().findChildren<QPushButton *>()) {
        if (button->isVisible()
            && (button->text() == QLatin1String("Pause") || button->text().startsWith(QLatin1String("Send"))))
            lines.insert(button->mapTo(bench.page.get(), QPoint()).y());
    }
    QVERIFY2(*lines.rbegin() - *lines.begin() < 8, qPrintable(QString::number(*lines.rbegin() - *lines.begin())));
}

/// And at twice the font, in units of it.
void BusPageTest::someFramesAreInSightAtTwiceTheFont()
{
    BusBench bench;
    bench.page->resize(395, std::max(247, bench.page->minimumSizeHint().height()));
    QCoreApplication::processEvents();
    auto *frames = bench.named<TrafficView>("Frames");
    const int top = frames->viewport()->mapTo(bench.page.get(), QPoint()).y();
    QVERIFY2((247 - top) / frames->verticalHeader()->defaultSectionSize() >= 3, qPrintable(QString::number(top)));
    QVERIFY(frames->viewport()->height() >= 5 * frames->verticalHeader()->defaultSectionSize());
    const int message = frames->columnViewportPosition(FrameModel::Message) + frames->columnWidth(FrameModel::Message);
    QVERIFY2(message <= frames->viewport()->width(), qPrintable(QString::number(message)));
}

void BusPageTest::theBusiestIdentifierStandsFirst()
{
    BusBench bench;
    bench.page->hide();
    bench.traffic.add("023#00"); // once, and of the smallest identifier
    for (int i = 0; i < 100; ++i) {
        bench.traffic.add(generalOf7);
        if (i % 10 == 0)
            bench.traffic.add(generalOf5);
    }
    bench.past = {};
    bench.publish();
    bench.page->show();
    bench.past = {};
    bench.publish();
    const auto &model = *bench.named<TrafficView>("Identifiers")->model();
    QStringList order;
    for (int row = 0; row < model.rowCount(); ++row)
        order += model.index(row, IdModel::Id).data().toString();
    QCOMPARE(order, QStringList({QStringLiteral("02061407"), QStringLiteral("02061405"), QStringLiteral("023")}));
}

void BusPageTest::withoutALinkItSaysHowToGetOne()
{
    BusBench bench;
    const std::vector<LinkView> links = std::exchange(bench.workbench.shot.links, {});
    const auto page = std::make_unique<BusPage>(bench.workbench, bench.arming, bench.theme);
    page->show();
    bench.publish();
    const auto buttons = page->findChildren<QPushButton *>();
    const auto send = std::find_if(buttons.begin(), buttons.end(),
        [](const QPushButton *button) { return button->text() == QStringLiteral("Send frame…"); });
    QVERIFY(send != buttons.end());
    QVERIFY(page->findChild<EmptyState *>()->isVisible());
    QVERIFY(!page->findChild<TrafficView *>()->isVisible());
    QVERIFY(!(*send)->isEnabled());
    bench.workbench.shot.links = links;
    bench.publish();
    QVERIFY(!page->findChild<EmptyState *>()->isVisible());
    QVERIFY(page->findChild<TrafficView *>()->isVisible());
    QVERIFY((*send)->isEnabled());
}

void BusPageTest::whatALinkLeftStaysWhenItIsClosed()
{
    BusBench bench;
    bench.traffic.add(generalOf5);
    bench.publish();
    bench.page->bar().setSendShown(true);
    QVERIFY(bench.panel().isVisible());
    bench.workbench.shot.links.clear();
    bench.publish();
    QVERIFY(bench.page->findChild<TrafficView *>()->isVisible());
    QVERIFY(!bench.panel().isVisible()); // there is nothing to send on
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

void BusPageTest::closingALinkMovesTheViewToNoOther()
{
    BusBench bench;
    const auto named = [&bench](const char *address) {
        LinkView link = bench.workbench.shot.links.front();
        link.address = address;
        link.name = address;
        return link;
    };
    bench.workbench.shot.links = {named("sim:a"), bench.workbench.shot.links.front(), named("sim:c")};
    bench.publish();
    bench.page->showLink("sim:can");
    bench.publish();
    bench.workbench.shot.links.erase(bench.workbench.shot.links.begin());
    bench.publish();
    bench.type("7FF", "01");
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    QCOMPARE(bench.sent(), std::size_t{1});
    QCOMPARE(bench.workbench.given<orders::SendFrame>().front().link, std::string("sim:can"));
}

void BusPageTest::aLinkThatIsClosedIsSaidAndNothingIsSentOnAnother()
{
    BusBench bench;
    bench.traffic.add(generalOf5);
    LinkView other = bench.workbench.shot.links.front();
    other.address = other.name = "sim:c";
    other.traffic = std::make_shared<TrafficLog>();
    bench.workbench.shot.links.push_back(other);
    bench.publish();
    QCOMPARE(bench.page->model().rowCount(), 1);
    bench.page->bar().setSendShown(true);
    bench.type("7FF", "01");
    bench.workbench.shot.links.erase(bench.workbench.shot.links.begin());
    bench.publish();
    QCOMPARE(bench.page->model().rowCount(), 1); // what it left stays
    QVERIFY(!bench.panel().isVisible());
    bench.sendButton().click();
    QCOMPARE(bench.sent(), std::size_t{0});
    QString words;
    for (const QLabel *label : bench.page->bar().findChildren<QLabel *>())
        words += label->text();
    QVERIFY2(words.contains(QStringLiteral("sim:can is not open")), qPrintable(words));
    const QTemporaryDir folder;
    bench.page->exportTo(folder.filePath(QStringLiteral("left.log")), true);
    QFile file(folder.filePath(QStringLiteral("left.log")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().contains("sim:can"));
    bench.named<Segmented>("Link")->setCurrent(0); // the other is chosen by hand
    bench.publish();
    QCOMPARE(bench.page->model().rowCount(), 0);
    bench.workbench.shot.links.push_back(canLink(bench.traffic.log));
    bench.page->showLink("sim:can");
    bench.publish();
    QCOMPARE(bench.page->model().rowCount(), 1);
}

void BusPageTest::aRecordingIsOfTheLinkThatItWasAskedFor()
{
    BusBench bench;
    LinkView other = bench.workbench.shot.links.front();
    other.address = other.name = "sim:c";
    bench.workbench.shot.links.push_back(other);
    bench.publish();
    QTest::mouseClick(&bench.page->recordStrip().button(), Qt::LeftButton);
    auto *dialog = bench.page->findChild<QFileDialog *>();
    QVERIFY(dialog);
    bench.page->showLink("sim:c");
    bench.publish();
    Q_EMIT dialog->fileSelected(QStringLiteral("/logs/run.log"));
    QCOMPARE(bench.workbench.given<orders::StartRecording>().size(), std::size_t{1});
    QCOMPARE(bench.workbench.given<orders::StartRecording>().front().link, std::string("sim:can"));
    dialog->close();
}

MB_WINDOW_TEST(BusPageTest);
#include "tst_buspage.moc"
