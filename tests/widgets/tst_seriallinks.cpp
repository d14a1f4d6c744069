// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameterbench.h"
#include "support/fakeworkbench.h"
#include "support/utf8.h"
#include "support/windowtests.h"
#include "widgets/common/selection.h"
#include "widgets/common/valuelabel.h"
#include "widgets/connection/deviceactions.h"
#include "widgets/connection/devicecard.h"
#include "widgets/connection/devicetree.h"
#include "widgets/connection/linkchoices.h"
#include "widgets/connection/overviewpage.h"
#include "widgets/connection/scanstrip.h"

#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QTest>
#include <QTreeView>

using namespace mb;
using namespace mb::test;
using namespace std::chrono_literals;

namespace {

LinkView serialLink()
{
    LinkView link;
    link.address = "serial:/dev/ttyUSB0";
    link.name = "ttyUSB0";
    link.kind = LinkKind::Serial;
    link.state = LinkState::Open;
    link.bitrate = 57600;
    link.load = 0.42;
    link.roundTrip = 2340us;
    return link;
}

} // namespace

class TestSerialLinks : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theCardShowsRateAndRoundTrip();
    void theDialogOffersPortsWithWhatTheyAreAndSaysWhyOneCannotBeUsed();
    void anAddedPortIsRememberedOnlyOnceItIsOpen();
    void aLongScanShowsHowFarItIsAndCanBeCancelled();
    void everyRateAndAddressCanBeSearched();
    void cardsStandInTheOrderOfTheTree();
};

void TestSerialLinks::cardsStandInTheOrderOfTheTree()
{
    FakeWorkbench workbench;
    Selection selection;
    const ThemeSource theme{darkTheme()};
    workbench.shot.links.push_back(serialLink());
    for (const auto &[id, address] : {std::pair{2U, 3}, std::pair{1U, 4}, std::pair{3U, 5}}) { // #4 was found first
        DeviceView device = readDrive(id, address);
        device.link = workbench.shot.links[0].address;
        device.telemetry = std::make_shared<Telemetry>(device.family->channels);
        workbench.shot.devices.push_back(device);
    }
    OverviewPage page(workbench, selection, theme);
    page.resize(1600, 700);
    page.show();
    workbench.publish();
    std::vector<std::pair<QPoint, QString>> cards;
    const auto order = [&] {
        QCoreApplication::processEvents();
        cards.clear();
        for (const DeviceCard *card : page.findChildren<DeviceCard *>())
            cards.emplace_back(card->pos(), card->accessibleName());
        std::sort(cards.begin(), cards.end(), [](const auto &a, const auto &b) {
            return std::pair(a.first.y(), a.first.x()) < std::pair(b.first.y(), b.first.x());
        });
        QStringList numbers;
        for (const auto &[place, name] : cards)
            numbers << name.mid(name.indexOf(QLatin1Char('#')), 2);
        return numbers;
    };
    QTRY_COMPARE(order(), (QStringList{s("#3"), s("#4"), s("#5")}));
}

void TestSerialLinks::aLongScanShowsHowFarItIsAndCanBeCancelled()
{
    FakeWorkbench workbench;
    const ThemeSource theme{darkTheme()};
    QWidget parent;
    ScanStrip strip(workbench, theme, &parent);
    parent.show();
    workbench.shot.links.push_back(serialLink());
    workbench.publish();
    QVERIFY(!strip.isVisible());
    LinkView &link = workbench.shot.links[0];
    link.scanning = true;
    link.scanStep = say("Looking for Supermodified nodes at 9600 bit/s");
    link.scanDone = 40;
    link.scanTotal = 127;
    workbench.publish();
    QVERIFY(strip.isVisible());
    const auto *progress = strip.findChild<QProgressBar *>();
    QCOMPARE(progress->value(), 40);
    QCOMPARE(progress->maximum(), 127);
    QVERIFY(!progress->accessibleName().isEmpty());
    auto *cancel = strip.findChild<QPushButton *>(s("cancelScan"));
    QVERIFY(!cancel->accessibleName().isEmpty());
    QTest::mouseClick(cancel, Qt::LeftButton);
    QCOMPARE(workbench.given<orders::CancelScan>().at(0).link, std::string("serial:/dev/ttyUSB0"));
    link.scanning = false;
    workbench.publish();
    QVERIFY(!strip.isVisible());
}

void TestSerialLinks::everyRateAndAddressCanBeSearched()
{
    FakeWorkbench workbench;
    Selection selection;
    const ThemeSource theme{darkTheme()};
    workbench.shot.links.push_back(serialLink());
    DeviceTree tree(workbench, selection, theme);
    tree.show();
    workbench.publish();
    auto *view = tree.findChild<QTreeView *>();
    Q_EMIT view->customContextMenuRequested(view->visualRect(view->model()->index(0, 0)).center());
    auto *menu = tree.findChild<QMenu *>();
    QVERIFY(menu);
    for (QAction *action : menu->actions()) {
        if (action->objectName() == s("searchEverything"))
            action->trigger();
    }
    QCOMPARE(workbench.given<orders::ScanEverything>().at(0).link, std::string("serial:/dev/ttyUSB0"));
}

void TestSerialLinks::theCardShowsRateAndRoundTrip()
{
    FakeWorkbench workbench;
    Selection selection;
    const ThemeSource theme{darkTheme()};
    OverviewPage page(workbench, selection, theme);
    workbench.shot.links.push_back(serialLink());
    page.resize(800, 300);
    page.show();
    workbench.publish();
    const auto roundTrip = [&page] {
        for (ValueLabel *label : page.findChildren<ValueLabel *>()) {
            if (label->accessibleName().contains(s("round trip")) && label->isVisible())
                return label->value();
        }
        return s("absent");
    };
    QTRY_COMPARE(roundTrip(), s("2.3"));
    workbench.shot.links[0].roundTrip.reset();
    workbench.publish();
    QVERIFY(roundTrip() != s("2.3"));
    workbench.shot.links[0].kind = LinkKind::Can;
    workbench.publish();
    QCOMPARE(roundTrip(), s("absent"));
}

void TestSerialLinks::theDialogOffersPortsWithWhatTheyAreAndSaysWhyOneCannotBeUsed()
{
    FakeWorkbench workbench;
    workbench.links.push_back({{"serial", "/dev/ttyUSB0", {}}, LinkKind::Serial, ListingState::Available,
        Message::verbatim("FTDI FT232R USB UART, serial number A50285BI, 0403:6001"), true});
    workbench.links.push_back({{"serial", "/dev/ttyUSB1", {}}, LinkKind::Serial, ListingState::NoPermission,
        Message::verbatim(
            "no permission to use /dev/ttyUSB1; become a member of its group: sudo usermod -aG dialout $USER"),
        false});
    const std::vector<LinkChoice> choices = linkChoices(workbench.links, {});
    QCOMPARE(choices[0].name, s("ttyUSB0 · FTDI FT232R USB UART, serial number A50285BI, 0403:6001"));
    QVERIFY(choices[0].openable);
    QVERIFY(!choices[1].openable);
    QVERIFY(choices[1].words.contains(s("usermod -aG dialout")));
}

void TestSerialLinks::anAddedPortIsRememberedOnlyOnceItIsOpen()
{
    FakeWorkbench workbench;
    QStringList remembered;
    openAddress(workbench, s("serial:/dev/ttyUSB0?baud=57600"),
        [&remembered](const QString &address) { remembered << address; });
    const auto opened = workbench.given<orders::OpenLink>();
    QCOMPARE(opened.size(), std::size_t{1});
    QCOMPARE(QString::fromStdString(opened[0].address.text()), s("serial:/dev/ttyUSB0?baud=57600"));
    opened[0].finished(fail(Fault::LinkLost, say("ttyUSB0 is in use")));
    QVERIFY(remembered.isEmpty());
    opened[0].finished({});
    QCOMPARE(remembered, QStringList(s("serial:/dev/ttyUSB0?baud=57600")));
}

MB_WINDOW_TEST(TestSerialLinks);
#include "tst_seriallinks.moc"
