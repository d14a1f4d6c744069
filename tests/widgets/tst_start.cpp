// SPDX-License-Identifier: GPL-3.0-or-later
// The start page, its stories, and the unit that is selected first.
#include "support/fakeworkbench.h"
#include "support/longwords.h"
#include "support/windowtests.h"
#include "tunebench.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/card.h"
#include "widgets/common/devicetext.h"
#include "widgets/connection/firstselection.h"
#include "widgets/connection/overviewpage.h"
#include "widgets/connection/startpage.h"
#include "widgets/start/guide.h"
#include "widgets/start/guidestrip.h"
#include "widgets/start/storycard.h"

#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include <set>

using namespace mb;
using namespace mb::test;

namespace {

constexpr const char *heldAt = "lost at its end";

DeviceView unit(std::uint32_t id, int address)
{
    DeviceView device = readDrive(id, address);
    device.link = "sim:can";
    device.selector = "sim:can/dmc60c:" + std::to_string(address);
    device.mayNotMove = {};
    device.identity.edit().state = DeviceState::Online;
    return device;
}

OperationView ended(std::uint32_t id, DeviceId device)
{
    OperationView operation;
    operation.id = {id};
    operation.device = device;
    operation.status.state = OperationStatus::State::Done;
    return operation;
}

KeptTrial stepOf(const DeviceView &device, std::int64_t number, double overshoot)
{
    KeptTrial row;
    row.number = number;
    row.trial.unit = device.unit;
    row.trial.mode = Mode::Velocity;
    row.trial.reason = tuning::EndReason::Done;
    row.trial.metrics.overshoot = overshoot;
    return row;
}

/// Of its position loop, to a place that is not reached by this share of the way.
KeptTrial moveOf(const DeviceView &device, std::int64_t number, double to, double missed)
{
    KeptTrial row = stepOf(device, number, 0.0);
    row.trial.mode = Mode::Position;
    row.trial.stimulus.to = to;
    row.trial.metrics.sse = missed;
    return row;
}

/// The one who is told of.
const Story &taming()
{
    return stories().front();
}

/// The unit on which a story plays.
DeviceView actor(std::uint32_t id, const Story &story)
{
    DeviceView device = unit(id, storyFamily(story)->demo->*story.unit);
    device.family = storyFamily(story);
    device.parameters.edit().clear();
    return device;
}

const Story &arriving()
{
    const auto all = stories();
    return *std::find_if(all.begin(), all.end(), [](const Story &story) { return story.key == "arrive"; });
}

struct GuideBench {
    FakeWorkbench workbench;
    Selection selection;
    Arming arming{workbench};
    Guide guide{workbench, selection, arming};

    GuideBench() { workbench.shot.devices = {unit(1, 5), unit(2, 7)}; }
    DeviceView &seven() { return workbench.device(1); }
    void settle()
    {
        workbench.publish();
        QTest::qWait(0); // the notebook answers with the next turn
        workbench.publish();
    }
    void stepEnds(std::uint32_t operation, std::int64_t trial, double overshoot)
    {
        workbench.book.kept.push_back(stepOf(seven(), trial, overshoot));
        workbench.shot.operations = {ended(operation, seven().id)};
        settle();
    }
    void setRam(ParameterState state)
    {
        seven().parameters.edit().front().state = state;
        settle();
    }
};

/// Of labels that wrap and are lower than their text, and of buttons narrower than theirs.
QStringList cutTexts(const QWidget &page)
{
    QStringList cut;
    for (const QLabel *label : page.findChildren<QLabel *>()) {
        if (label->wordWrap() && label->isVisible() && label->height() < label->heightForWidth(label->width()))
            cut += label->text();
    }
    for (const QPushButton *button : page.findChildren<QPushButton *>()) {
        if (button->isVisible() && button->width() < button->minimumSizeHint().width())
            cut += button->text();
    }
    return cut;
}

} // namespace

class StartTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aStoryGoesOnWhenItsStepsHaveReallyHappened();
    void whatTheNotebookHadBeforeIsNoStep();
    void anInterruptedStepIsNone();
    void aMotorHasArrivedWhenItRestsAtItsTarget();
    void aStoryThatIsDismissedLeavesNothing();
    void theOfferIsMadeOnceAndNotInTheMiddleOfAStory();
    void whoHasTriedTheMotorHasBegun();
    void theOffersButtonsLieOverNothingInItsFirstPicture();
    void aUnitThatNobodyNamedIsNotCalledByItsFamilyTwice();
    void threeLinksStandInOneRowBesideTheInspector();
    void everyStepSaysWhatToDo();
    void theFirstUnitThatCanBeTunedIsSelected();
    void whatSomebodyChoseOrWorksWithStays();
    void aRowOfTheStartPageCanBeOpened();
    void nothingIsCutAtTwiceTheFont_data();
    void nothingIsCutAtTwiceTheFont();
};

void StartTest::aStoryGoesOnWhenItsStepsHaveReallyHappened()
{
    GuideBench bench;
    bench.guide.begin(taming());
    bench.settle();
    QCOMPARE(bench.guide.step(), std::size_t(0));
    bench.selection.select(bench.seven().id);
    QCOMPARE(bench.guide.step(), std::size_t(1));
    bench.arming.arm(bench.seven().id);
    QCOMPARE(bench.guide.step(), std::size_t(2));
    bench.stepEnds(1, 1, 0.21);
    QCOMPARE(bench.guide.step(), std::size_t(3));
    QVERIFY(bench.guide.result().contains(QStringLiteral("21")));
    bench.stepEnds(2, 2, 0.12); // better, and not tame
    QCOMPARE(bench.guide.step(), std::size_t(3));
    bench.setRam(ParameterState::Ram);
    bench.stepEnds(3, 3, 0.03);
    QCOMPARE(bench.guide.step(), std::size_t(4));
    bench.settle();
    QVERIFY(!bench.guide.isDone()); // RAM is not flash
    bench.setRam(ParameterState::Stored);
    QVERIFY(bench.guide.isDone());
    QVERIFY(bench.guide.result().contains(QStringLiteral("3 %")));
}

void StartTest::whatTheNotebookHadBeforeIsNoStep()
{
    GuideBench bench;
    bench.workbench.book.kept = {stepOf(bench.seven(), 1, 0.21), stepOf(bench.seven(), 2, 0.01)};
    bench.guide.begin(taming());
    bench.settle();
    bench.selection.select(bench.seven().id);
    bench.arming.arm(bench.seven().id);
    bench.settle();
    QCOMPARE(bench.guide.step(), std::size_t(2));
    QVERIFY(bench.guide.result().isEmpty());
}

void StartTest::anInterruptedStepIsNone()
{
    GuideBench bench;
    bench.guide.begin(taming());
    bench.settle();
    bench.selection.select(bench.seven().id);
    bench.arming.arm(bench.seven().id);
    KeptTrial cut = stepOf(bench.seven(), 1, 0.0);
    cut.trial.reason = tuning::EndReason::Interrupted;
    cut.trial.detail = Message::verbatim(heldAt);
    bench.workbench.book.kept = {cut};
    bench.workbench.shot.operations = {ended(1, bench.seven().id)};
    bench.settle();
    QCOMPARE(bench.guide.step(), std::size_t(2));
}

void StartTest::aMotorHasArrivedWhenItRestsAtItsTarget()
{
    GuideBench bench;
    bench.workbench.shot.devices.push_back(actor(3, arriving()));
    DeviceView &device = bench.workbench.device(2);
    const auto moves = [&](std::uint32_t operation, double to, double missed) {
        bench.workbench.book.kept.push_back(moveOf(device, operation, to, missed));
        bench.workbench.shot.operations = {ended(operation, device.id)};
        bench.settle();
    };
    bench.guide.begin(arriving());
    bench.settle();
    bench.selection.select(device.id);
    bench.arming.arm(device.id);
    QCOMPARE(bench.guide.step(), std::size_t(2));
    moves(1, 4000.0, 0.0005); // there by luck: nothing to mend is seen
    QCOMPARE(bench.guide.step(), std::size_t(2));
    moves(2, 200.0, 0.1);
    QCOMPARE(bench.guide.step(), std::size_t(3));
    QVERIFY2(bench.guide.result().contains(QStringLiteral("20")), qPrintable(bench.guide.result()));
    moves(3, 60.0, 0.01); // too short a way to tell
    QCOMPARE(bench.guide.step(), std::size_t(3));
    moves(4, 200.0, 0.04); // nearer, and not there
    QCOMPARE(bench.guide.step(), std::size_t(3));
    moves(5, 200.0, -0.01);
    QVERIFY(bench.guide.isDone());
    QVERIFY2(bench.guide.result().endsWith(QStringLiteral("2 now")), qPrintable(bench.guide.result()));
}

void StartTest::aStoryThatIsDismissedLeavesNothing()
{
    GuideBench bench;
    ThemeSource theme{darkTheme()};
    GuideStrip strip(GuideStrip::Shows::Steps, bench.guide, theme);
    QVERIFY(!strip.isVisibleTo(nullptr));
    bench.guide.begin(taming());
    QVERIFY(strip.isVisibleTo(nullptr));
    bench.guide.end();
    QVERIFY(!strip.isVisibleTo(nullptr));
    bench.settle(); // an answer that comes late
    QVERIFY(!bench.guide.story());
}

void StartTest::theOfferIsMadeOnceAndNotInTheMiddleOfAStory()
{
    GuideBench bench;
    ThemeSource theme{darkTheme()};
    GuideStrip strip(GuideStrip::Shows::Offers, bench.guide, theme);
    QSignalSpy refused(&strip, &GuideStrip::refused);
    QSignalSpy wanted(&strip, &GuideStrip::wanted);
    strip.offer(&taming());
    QVERIFY(strip.isVisibleTo(nullptr));
    const auto buttons = strip.findChildren<QPushButton *>();
    QCOMPARE(buttons.at(0)->text(), QStringLiteral("Begin"));
    for (const QPushButton *button : buttons)
        QCOMPARE(button->accessibleName(), button->text());
    buttons.at(0)->click();
    QCOMPARE(wanted.count(), 1);
    bench.guide.begin(taming());
    QVERIFY(!strip.isVisibleTo(nullptr));
    bench.guide.end();
    buttons.at(1)->click();
    QCOMPARE(refused.count(), 1);
    QVERIFY(!strip.isVisibleTo(nullptr));
}

void StartTest::whoHasTriedTheMotorHasBegun()
{
    GuideBench bench;
    QVERIFY(!Guide::isBegun(taming(), bench.workbench.shot));
    OperationView operation = ended(4, bench.workbench.device(0).id);
    operation.status.kind = OperationKind::Trial;
    bench.workbench.shot.operations = {operation};
    QVERIFY(!Guide::isBegun(taming(), bench.workbench.shot)); // another unit
    bench.workbench.shot.operations.front().device = bench.seven().id;
    QVERIFY(Guide::isBegun(taming(), bench.workbench.shot));
}

/// The picture is taken without a turn of the event loop: as it is seen first.
void StartTest::theOffersButtonsLieOverNothingInItsFirstPicture()
{
    GuideBench bench;
    ThemeSource theme{darkTheme()};
    for (const std::initializer_list<int> widths : {std::initializer_list<int>{420}, {900}, {900, 420}, {420, 900}}) {
        QWidget page;
        auto *column = new QVBoxLayout(&page);
        auto *strip = new GuideStrip(GuideStrip::Shows::Offers, bench.guide, theme, &page);
        strip->offer(&taming());
        column->addWidget(strip);
        column->addStretch(1);
        for (const int width : widths) {
            page.resize(width, 600);
            (void)page.grab();
        }
        const auto *words = strip->findChild<QLabel *>(QStringLiteral("guideWords"));
        const auto place = [&page](const QWidget &part) { return QRect(part.mapTo(&page, QPoint()), part.size()); };
        QVERIFY(words->height() >= words->heightForWidth(words->width()));
        for (const auto *button : strip->findChildren<QPushButton *>()) {
            QVERIFY(!place(*button).intersects(place(*words)));
            QVERIFY(place(*strip).contains(place(*button)));
        }
    }
}

void StartTest::aUnitThatNobodyNamedIsNotCalledByItsFamilyTwice()
{
    DeviceView device = unit(1, 5);
    device.telemetry = std::make_shared<Telemetry>(dmc60c().channels);
    device.identity.edit().name = device.family->title;
    QVERIFY2(!lineOf(device).contains(qt(device.family->title)), qPrintable(lineOf(device)));
    device.identity.edit().name = "shooter";
    QVERIFY(lineOf(device).startsWith(QStringLiteral("shooter")));
}

void StartTest::threeLinksStandInOneRowBesideTheInspector()
{
    FakeWorkbench workbench;
    Selection selection;
    ThemeSource theme{darkTheme()};
    for (const auto &[name, kind, rate] : {std::tuple("sim:can", LinkKind::Can, 1'000'000),
             std::tuple("sim:serial", LinkKind::Serial, 57'600), std::tuple("sim:spi", LinkKind::Spi, 0)}) {
        LinkView link;
        link.address = link.name = name;
        link.kind = kind;
        link.state = LinkState::Open;
        link.bitrate = rate;
        workbench.shot.links.push_back(link);
    }
    OverviewPage page(workbench, selection, theme, nullptr);
    page.resize(787, 640); // of a window of 1280
    page.show();
    workbench.publish();
    QCoreApplication::processEvents();
    std::set<int> rows;
    for (const auto *card : page.findChildren<Card *>()) {
        if (card->isVisible())
            rows.insert(card->mapTo(&page, QPoint()).y());
    }
    QCOMPARE(rows.size(), std::size_t(1));
    LinkView fourth = workbench.shot.links.front();
    fourth.address = "sim:can?loss=0.1";
    workbench.shot.links.push_back(fourth);
    page.resize(1300, 640);
    workbench.publish();
    page.resize(787, 640); // the inspector came
    QCoreApplication::processEvents();
    for (const auto *card : page.findChildren<Card *>())
        QVERIFY(!card->isVisible() || card->mapTo(&page, QPoint(card->width(), 0)).x() <= page.width());
    QCOMPARE(bitrateText(workbench.shot.links[0]), QStringLiteral("1 Mbit/s"));
    QCOMPARE(bitrateText(workbench.shot.links[1]), QStringLiteral("57.6 kbit/s"));
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German));
    const QString german = bitrateText(workbench.shot.links[1]);
    QLocale::setDefault(before);
    QCOMPARE(german, QStringLiteral("57,6 kbit/s"));
}

void StartTest::everyStepSaysWhatToDo()
{
    GuideBench bench;
    ThemeSource theme{darkTheme()};
    for (const Story &story : stories()) {
        bench.workbench.shot.devices = {actor(9, story)};
        QVERIFY(Guide::deviceOf(story, bench.workbench.shot));
        QVERIFY(!storyMotor(story).isEmpty());
        for (const QString &shown : {storyText(story, story.title), storyParts(story), storyText(story, story.words)}) {
            QVERIFY2(!shown.contains(QLatin1Char('%')) || shown.contains(QStringLiteral(" %")), qPrintable(shown));
        }
        for (const StoryStep &step : story.steps) {
            QVERIFY(QString::fromUtf8(step.words).size() > 20);
            QVERIFY(!QString::fromUtf8(step.name).isEmpty());
        }
    }
    bench.workbench.shot.devices = {unit(1, 5), unit(2, 7)};
    GuideStrip strip(GuideStrip::Shows::Steps, bench.guide, theme);
    bench.guide.begin(taming());
    const auto *words = strip.findChild<QLabel *>(QStringLiteral("guideWords"));
    QVERIFY(words->text().contains(QStringLiteral("#7")));
    QSignalSpy shown(&strip, &GuideStrip::placeWanted);
    strip.findChildren<QPushButton *>().at(0)->click();
    QCOMPARE(shown.count(), 1);
}

void StartTest::theFirstUnitThatCanBeTunedIsSelected()
{
    Selection selection;
    FirstSelection first(selection);
    Snapshot shot;
    DeviceView boot = unit(1, 5);
    boot.identity.edit().state = DeviceState::Bootloader;
    shot.devices = {boot};
    first.follow(shot);
    QCOMPARE(selection.device(), boot.id); // better than nothing
    shot.devices = {boot, unit(2, 7), unit(3, 8)};
    first.follow(shot);
    QCOMPARE(selection.device(), DeviceId{2});
    shot.devices.insert(shot.devices.begin(), unit(4, 1)); // late: what is worked with stays
    first.follow(shot);
    QCOMPARE(selection.device(), DeviceId{2});
}

void StartTest::whatSomebodyChoseOrWorksWithStays()
{
    for (const auto act : {+[](Selection &s) { s.select({2}); }, +[](Selection &s) { s.select({1}); }, // the same one
             +[](Selection &s) { s.keep(); }}) {
        Selection selection;
        FirstSelection first(selection);
        Snapshot shot;
        shot.devices = {unit(1, 5)};
        shot.devices[0].identity.edit().state = DeviceState::Bootloader;
        first.follow(shot);
        act(selection);
        const DeviceId kept = selection.device();
        shot.devices.push_back(unit(3, 7));
        first.follow(shot);
        QCOMPARE(selection.device(), kept);
    }
}

void StartTest::aRowOfTheStartPageCanBeOpened()
{
    FakeWorkbench bench;
    ThemeSource theme{lightTheme()};
    StartPage page(bench, theme);
    page.setFirmware(
        {{Symbol::Chip, QStringLiteral("a.hex"), QStringLiteral("1 kB · checked"), QStringLiteral("Details"), {}},
            {Symbol::Chip, QStringLiteral("b.hex"), QStringLiteral("2 kB · checked"), QStringLiteral("Details"), {}}});
    QSignalSpy opened(&page, &StartPage::firmwareWanted);
    auto *card = page.findChild<ListCard *>(QStringLiteral("firmwareOnDisk"));
    for (QPushButton *button : card->findChildren<QPushButton *>()) {
        if (button->accessibleName() == QStringLiteral("Details: b.hex"))
            button->click();
    }
    QCOMPARE(opened.count(), 1);
    QCOMPARE(opened.at(0).at(0).toInt(), 1);
}

void StartTest::nothingIsCutAtTwiceTheFont_data()
{
    QTest::addColumn<double>("points");
    QTest::addColumn<int>("width");
    QTest::addColumn<bool>("longer");
    QTest::newRow("100 %, 1280") << 10.0 << 1072 << false;
    QTest::newRow("200 %, 1280") << 20.0 << 1000 << false;
    QTest::newRow("100 %, 640") << 10.0 << 640 << false;
    QTest::newRow("longer words") << 10.0 << 1072 << true;
}

void StartTest::nothingIsCutAtTwiceTheFont()
{
    QFETCH(double, points);
    QFETCH(int, width);
    QFETCH(bool, longer);
    LongWords words;
    if (longer)
        QCoreApplication::installTranslator(&words);
    const QFont before = QApplication::font();
    QFont font = before;
    font.setPointSizeF(points);
    QApplication::setFont(font);
    {
        FakeWorkbench bench;
        const Diagnosis down{Ailment::Down, say("can0 is off"), say("bring it up"), "sudo ip link set can0 up"};
        const LinkAddress can0{"socketcan", "can0", {}};
        bench.links = {{can0, LinkKind::Can, ListingState::Down, down.message(), false, down, false}};
        ThemeSource theme{lightTheme(points)};
        applyTheme(*qApp, theme.theme());
        QScrollArea scroll;
        scroll.setWidgetResizable(true);
        scroll.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        auto *page = new StartPage(bench, theme);
        page->follow();
        scroll.setWidget(page);
        scroll.resize(width, 700);
        scroll.show();
        QTRY_VERIFY(page->width() <= scroll.viewport()->width());
        QTRY_COMPARE(cutTexts(*page), QStringList());
        const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
        if (!folder.isEmpty())
            scroll.grab().save(folder + QStringLiteral("/start-%1-%2.png").arg(points).arg(width));
    }
    QApplication::setFont(before);
    QCoreApplication::removeTranslator(&words);
}

MB_WINDOW_TEST(StartTest);
#include "tst_start.moc"
