// SPDX-License-Identifier: GPL-3.0-or-later
// The cards of links and devices: how many stand beside each other, and what each says.
#include "parameterbench.h"
#include "support/windowtests.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/chip.h"
#include "widgets/common/linkload.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/sparkline.h"
#include "widgets/common/valuelabel.h"
#include "widgets/connection/axiscells.h"
#include "widgets/connection/devicecard.h"
#include "widgets/connection/overviewpage.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace mb;
using namespace mb::test;

namespace {

DeviceView deviceOf(std::string_view family, std::uint32_t id, const std::string &link)
{
    DeviceView device = readDrive(id, static_cast<int>(id));
    device.family = findFamily(families(), family);
    device.identity.edit().family = std::string(family);
    device.link = link;
    device.telemetry = std::make_shared<Telemetry>(device.family->channels);
    return device;
}

struct OverviewBench {
    FakeWorkbench workbench;
    Selection selection;
    ThemeSource theme{darkTheme()};
    std::unique_ptr<OverviewPage> page;

    explicit OverviewBench(int width)
    {
        applyTheme(*qApp, theme.theme());
        LinkView link;
        link.address = link.name = "sim:can";
        link.state = LinkState::Open;
        link.bitrate = 1000000;
        link.load = 0.1;
        workbench.shot.links.push_back(link);
        page = std::make_unique<OverviewPage>(workbench, selection, theme);
        page->resize(width, 700);
        page->show();
        workbench.publish();
    }
    void add(std::string_view family, std::uint32_t id)
    {
        workbench.shot.devices.push_back(deviceOf(family, id, "sim:can"));
    }
    /// That of the link, which has no card of a device around it.
    [[nodiscard]] const Sparkline *loadLine() const
    {
        const auto all = page->findChildren<const Sparkline *>();
        const auto found = std::ranges::find_if(all,
            [](const Sparkline *each) { return !qobject_cast<DeviceCard *>(each->parentWidget()->parentWidget()); });
        return found == all.end() ? nullptr : *found;
    }
    [[nodiscard]] std::vector<DeviceCard *> cards() const
    {
        const auto all = page->findChildren<DeviceCard *>();
        return {all.begin(), all.end()};
    }
    [[nodiscard]] static bool says(const QWidget &card, const char *words)
    {
        const auto labels = card.findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(),
            [words](const QLabel *label) { return label->isVisible() && label->text() == QLatin1String(words); });
    }
};

} // namespace

class OverviewTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void cardsAreWholeInTheFirstPicture();
    void threeStandBesideEachOtherOnAScreenOf1440();
    void aBoardIsAsWideAsTwoAndShowsWhatItsAxesDid();
    void whatNothingStopsByItselfSaysSo();
    void aLinkShowsItsLoadOfTheLastMinute();
    void theLoadIsFollowedWhileAnotherPageIsShown();
    void aLoadThatWasNotMeasuredYetIsADash();
    void theCardOfWhatIsSelectedComesIntoSight();
};

void OverviewTest::theCardOfWhatIsSelectedComesIntoSight()
{
    OverviewBench bench(760);
    for (std::uint32_t id = 1; id <= 20; ++id)
        bench.add("dmc60c", id);
    bench.workbench.publish();
    for (const std::uint32_t id : {20U, 1U}) {
        bench.selection.select({id});
        QCoreApplication::processEvents();
        const DeviceCard *card = bench.cards().at(id - 1);
        QCOMPARE(card->visibleRegion().boundingRect(), card->rect());
    }
}

void OverviewTest::cardsAreWholeInTheFirstPicture()
{
    OverviewBench bench(760);
    QCoreApplication::processEvents();
    for (std::uint32_t id = 1; id <= 7; ++id)
        bench.add("dmc60c", id);
    bench.workbench.publish(); // and nothing else happens before it is painted
    QCOMPARE(bench.cards().size(), std::size_t{7});
    for (const DeviceCard *card : bench.cards())
        QVERIFY2(card->height() >= card->minimumSizeHint().height(),
            qPrintable(QStringLiteral("%1 of %2").arg(card->height()).arg(card->minimumSizeHint().height())));
}

void OverviewTest::threeStandBesideEachOtherOnAScreenOf1440()
{
    OverviewBench bench(940);
    for (std::uint32_t id = 1; id <= 6; ++id)
        bench.add(id <= 3 ? "dmc60c" : "abstractdc", id);
    bench.workbench.publish();
    std::set<int> places;
    for (const DeviceCard *card : bench.cards())
        places.insert(card->x());
    QCOMPARE(places.size(), std::size_t{3});
}

void OverviewTest::aBoardIsAsWideAsTwoAndShowsWhatItsAxesDid()
{
    OverviewBench bench(940);
    bench.add("dmc60c", 1);
    bench.add("quadquad2drv", 2);
    bench.workbench.publish();
    QCoreApplication::processEvents();
    const auto cards = bench.cards();
    QVERIFY2(cards[1]->width() > 2 * cards[0]->width() - 4, // what is left of a pixel goes to one of them
        qPrintable(QStringLiteral("%1 beside %2").arg(cards[1]->width()).arg(cards[0]->width())));
    const auto *cells = cards[1]->findChild<AxisCells *>();
    QVERIFY(cells);
    int lines = 0;
    for (const Sparkline *line : cells->findChildren<Sparkline *>())
        lines += line->isVisible() && line->height() >= 30 ? 1 : 0;
    QCOMPARE(lines, 4);
}

void OverviewTest::whatNothingStopsByItselfSaysSo()
{
    OverviewBench bench(940);
    bench.add("dmc60c", 1);
    bench.add("abstractdc", 2);
    bench.add("supermodified", 3);
    bench.workbench.publish();
    const auto cards = bench.cards();
    QVERIFY(OverviewBench::says(*cards[0], "no faults"));
    for (const std::size_t without : {std::size_t{1}, std::size_t{2}}) {
        QVERIFY(OverviewBench::says(*cards[without], "no watchdog"));
        QVERIFY(!OverviewBench::says(*cards[without], "no faults"));
    }
}

void OverviewTest::aLinkShowsItsLoadOfTheLastMinute()
{
    OverviewBench bench(940);
    bench.add("dmc60c", 1);
    for (const double load : {0.1, 0.3, 0.2}) {
        bench.workbench.time += std::chrono::seconds(1);
        bench.workbench.shot.links[0].load = load;
        bench.workbench.publish();
    }
    QVERIFY(bench.loadLine()->range().has_value());
    QCOMPARE(bench.loadLine()->range()->second, 0.3);
}

void OverviewTest::theLoadIsFollowedWhileAnotherPageIsShown()
{
    OverviewBench bench(940);
    bench.page->hide();
    for (const double load : {0.3, 0.2}) {
        bench.workbench.time += std::chrono::seconds(1);
        bench.workbench.shot.links[0].load = load;
        bench.workbench.publish();
    }
    bench.page->show();
    QVERIFY(bench.loadLine()->range().has_value());
    QCOMPARE(bench.loadLine()->range()->second, 0.3);
}

void OverviewTest::aLoadThatWasNotMeasuredYetIsADash()
{
    OverviewBench bench(940);
    bench.workbench.shot.links[0].load.reset();
    bench.workbench.publish();
    QVERIFY(std::isnan(loadOf(bench.workbench.shot.links[0])));
    const auto labels = bench.page->findChildren<ValueLabel *>();
    QVERIFY(!labels.isEmpty());
    QCOMPARE(labels.front()->value(), QString(UnknownMark));
    LinkChip chip(bench.theme);
    LinkStatus status;
    status.name = QStringLiteral("can0");
    status.load = loadOf(bench.workbench.shot.links[0]);
    chip.setStatus(status);
    QVERIFY2(!chip.accessibleDescription().contains(QLatin1Char('0')), qPrintable(chip.accessibleDescription()));
    QVERIFY(!chip.grab().isNull());
}

MB_WINDOW_TEST(OverviewTest);
#include "tst_overview.moc"
