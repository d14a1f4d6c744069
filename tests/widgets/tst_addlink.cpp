// SPDX-License-Identifier: GPL-3.0-or-later
// Adding a link by choosing: what is listed, what its options make of the address, and what cannot be opened.
#include "support/utf8.h"
#include "support/windowtests.h"
#include "transport/backends/gpiolines.h"
#include "widgets/common/applytheme.h"
#include "widgets/connection/addlinkdialog.h"
#include "widgets/connection/linkoptions.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

using namespace mb;

namespace {

std::vector<LinkListing> listings()
{
    const Diagnosis down{Ailment::Down, say("can0 is switched off"), say("bring it up"), "sudo ip link set can0 up"};
    return {{{"socketcan", "can0", {}}, LinkKind::Can, ListingState::Down, down.message(), false, down, false},
        {{"socketcan", "can1", {}}, LinkKind::Can, ListingState::Up, Message::verbatim("gs_usb, 1 Mbit/s"), true, {},
            false},
        {{"serial", "/dev/ttyUSB0", {}}, LinkKind::Serial, ListingState::Available,
            Message::verbatim("FTDI FT232R USB UART, serial number A50285BI, 0403:6001"), true, {}, false},
        {{"spidev", "/dev/spidev0.0", {}}, LinkKind::Spi, ListingState::Available, {}, true, {}, false}};
}

struct DialogBench {
    ThemeSource theme{darkTheme()};
    AddLinkDialog dialog;

    DialogBench()
        : dialog(linkChoices(listings(), {"sim:can"}), theme)
    {
        dialog.setLines({{s("gpiochip0:24"), s("GPIO24")}, {s("gpiochip0:25"), s("GPIO25")}});
        dialog.show();
    }
    [[nodiscard]] QTreeWidgetItem *row(const QString &name)
    {
        auto *list = dialog.findChild<QTreeWidget *>();
        const auto found = list->findItems(name, Qt::MatchContains | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.constFirst();
    }
    void choose(const QString &name) { dialog.findChild<QTreeWidget *>()->setCurrentItem(row(name)); }
    [[nodiscard]] QLineEdit &address() { return *dialog.findChild<QLineEdit *>(); }
    [[nodiscard]] QComboBox &box(const char *name) { return *dialog.findChild<QComboBox *>(QLatin1String(name)); }
    [[nodiscard]] QPushButton &open()
    {
        auto *buttons = dialog.findChild<QDialogButtonBox *>();
        for (QAbstractButton *button : buttons->buttons()) {
            if (buttons->buttonRole(button) == QDialogButtonBox::AcceptRole)
                return *static_cast<QPushButton *>(button);
        }
        qFatal("there is no button that opens");
    }
};

} // namespace

class AddLinkTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyKindIsListedWithItsState();
    void noRowIsWithoutAName();
    void whatCanBeOpenedIsChosenFirst();
    void anInterfaceThatIsDownShowsItsCommand();
    void aSerialPortGetsItsRate();
    void aBoardGetsItsLines();
    void aLineCanBeTyped();
    void aSimulatedLinkCanLose();
    void theAddressLineWins();
    void anAddressThatIsNoneIsRefusedInWords();
    void aRecordingAsksForItsFile();
    void whatIsPluggedInMeanwhileIsListed();
    void everythingHasAName();
    void linesOfThisComputerAreListedWithoutOpeningOne();
    void nothingIsCut_data();
    void nothingIsCut();
};

void AddLinkTest::everyKindIsListedWithItsState()
{
    DialogBench bench;
    QCOMPARE(bench.row(s("can0"))->text(1), s("switched off"));
    QCOMPARE(bench.row(s("can1"))->text(1), s("up"));
    QVERIFY(bench.row(s("serial number A50285BI")));
    QVERIFY(bench.row(s("spidev0.0")));
    QCOMPARE(bench.row(s("Simulated CAN bus"))->text(1), s("open"));
    auto *list = bench.dialog.findChild<QTreeWidget *>();
    QCOMPARE(list->topLevelItemCount(), 5);
}

void AddLinkTest::noRowIsWithoutAName()
{
    const Diagnosis none{Ailment::NotThere, say("there is no CAN interface"), say("plug in an adapter"), {}};
    const std::vector<LinkListing> absent{
        {{"socketcan", {}, {}}, LinkKind::Can, ListingState::Absent, none.message(), false, none, false}};
    for (const LinkChoice &choice : linkChoices(absent, {}))
        QVERIFY2(!choice.name.isEmpty(), qPrintable(choice.words));
}

void AddLinkTest::whatCanBeOpenedIsChosenFirst()
{
    DialogBench bench;
    QCOMPARE(bench.address().text(), s("socketcan:can1"));
    QSignalSpy chosen(&bench.dialog, &AddLinkDialog::chosen);
    bench.open().click();
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen.at(0).at(0).toString(), s("socketcan:can1"));
    QCOMPARE(chosen.at(0).at(1).toBool(), true);
}

void AddLinkTest::anInterfaceThatIsDownShowsItsCommand()
{
    DialogBench bench;
    bench.choose(s("can0"));
    QStringList texts;
    for (const QLabel *label : bench.dialog.findChildren<QLabel *>()) {
        if (label->isVisible())
            texts += label->text();
    }
    QVERIFY(texts.contains(s("sudo ip link set can0 up")));
    QVERIFY(bench.open().isEnabled()); // it may be up by now
}

void AddLinkTest::aSerialPortGetsItsRate()
{
    DialogBench bench;
    bench.choose(s("ttyUSB0"));
    QCOMPARE(bench.address().text(), s("serial:/dev/ttyUSB0"));
    QComboBox &rate = bench.box("linkBaud");
    rate.setCurrentIndex(rate.findData(s("57600")));
    bench.dialog.findChild<LinkOptions *>()->findChild<QCheckBox *>()->setChecked(true);
    QCOMPARE(bench.address().text(), s("serial:/dev/ttyUSB0?baud=57600&rs485=1"));
}

void AddLinkTest::aBoardGetsItsLines()
{
    DialogBench bench;
    bench.choose(s("spidev0.0"));
    bench.box("linkReady").setCurrentIndex(2);
    bench.box("linkReset").setCurrentIndex(1);
    QCOMPARE(bench.address().text(), s("spidev:/dev/spidev0.0?ready=gpiochip0:25&reset=gpiochip0:24"));
    QVERIFY(LinkAddress::parse(bench.address().text().toStdString()));
}

void AddLinkTest::aLineCanBeTyped()
{
    DialogBench bench;
    bench.choose(s("spidev0.0"));
    bench.box("linkReady").setEditText(s("gpiochip4:7"));
    QCOMPARE(bench.address().text(), s("spidev:/dev/spidev0.0?ready=gpiochip4:7"));
}

void AddLinkTest::aSimulatedLinkCanLose()
{
    DialogBench bench;
    bench.choose(s("Simulated serial line"));
    bench.box("linkLoss").setCurrentIndex(2);
    QCOMPARE(bench.address().text(), s("sim:serial?loss=0.05"));
    bench.choose(s("can1")); // options of one kind are none of another
    QCOMPARE(bench.address().text(), s("socketcan:can1"));
}

void AddLinkTest::theAddressLineWins()
{
    DialogBench bench;
    bench.address().setText(s("qtcan:peakcan:usb0?bitrate=500000"));
    bench.dialog.findChildren<QCheckBox *>().constLast()->setChecked(false);
    QSignalSpy chosen(&bench.dialog, &AddLinkDialog::chosen);
    bench.open().click();
    QCOMPARE(chosen.at(0).at(0).toString(), s("qtcan:peakcan:usb0?bitrate=500000"));
    QCOMPARE(chosen.at(0).at(1).toBool(), false);
}

void AddLinkTest::anAddressThatIsNoneIsRefusedInWords()
{
    DialogBench bench;
    bench.address().setText(s("can0"));
    QVERIFY(!bench.open().isEnabled());
    QStringList texts;
    for (const QLabel *label : bench.dialog.findChildren<QLabel *>()) {
        if (label->isVisible())
            texts += label->text();
    }
    QVERIFY2(texts.join(QLatin1Char('\n')).contains(s("SCHEME:PATH")), qPrintable(texts.join(QLatin1Char('|'))));
}

void AddLinkTest::whatIsPluggedInMeanwhileIsListed()
{
    DialogBench bench;
    bench.choose(s("A50285BI"));
    const QString typed = bench.address().text() + s("0");
    bench.address().setText(typed);
    auto found = listings();
    found.insert(found.begin(), found[1]);
    found.front().link.path = "can7";
    bench.dialog.setChoices(linkChoices(found, {"sim:can", "socketcan:can1"}));
    QVERIFY(bench.row(s("can7")));
    QCOMPARE(bench.row(s("can1"))->text(1), s("open"));
    QCOMPARE(bench.address().text(), typed);
    QCOMPARE(bench.dialog.findChild<QTreeWidget *>()->currentItem(), bench.row(s("A50285BI")));
    found.erase(found.begin() + 3); // the port
    bench.dialog.setChoices(linkChoices(found, {}));
    QVERIFY(!bench.row(s("A50285BI")));
    QCOMPARE(bench.address().text(), typed);
    QVERIFY(!bench.dialog.findChild<QTreeWidget *>()->currentItem());
    auto none = linkChoices({}, {});
    none.resize(1); // a recording, which no address is of
    AddLinkDialog late(none, bench.theme);
    QCOMPARE(late.findChild<QLineEdit *>()->text(), QString());
    late.setChoices(linkChoices(found, {}));
    QCOMPARE(late.findChild<QLineEdit *>()->text(), s("socketcan:can7"));
}

void AddLinkTest::aRecordingAsksForItsFile()
{
    DialogBench bench;
    bench.choose(s("A recording of frames"));
    QCOMPARE(bench.open().text(), s("Choose the file…"));
    QSignalSpy wanted(&bench.dialog, &AddLinkDialog::recordingWanted);
    QSignalSpy chosen(&bench.dialog, &AddLinkDialog::chosen);
    bench.open().click();
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(chosen.count(), 0);
}

void AddLinkTest::everythingHasAName()
{
    DialogBench bench;
    for (const QWidget *widget : bench.dialog.findChildren<QWidget *>()) {
        if (widget->focusPolicy() == Qt::NoFocus || qobject_cast<const QAbstractButton *>(widget)
            || !widget->isVisible())
            continue;
        if (qobject_cast<const QComboBox *>(widget->parentWidget()) || widget->objectName().startsWith(s("qt_")))
            continue;
        QVERIFY2(!widget->accessibleName().isEmpty() || qstrcmp(widget->metaObject()->className(), "QHeaderView") == 0,
            widget->metaObject()->className());
    }
}

void AddLinkTest::linesOfThisComputerAreListedWithoutOpeningOne()
{
    for (const GpioLineListing &line : gpioLines())
        QVERIFY(line.name.find("gpiochip") == 0 && line.name.find(':') != std::string::npos);
}

void AddLinkTest::nothingIsCut_data()
{
    QTest::addColumn<double>("points");
    QTest::newRow("100 %") << 10.0;
    QTest::newRow("200 %") << 20.0;
}

void AddLinkTest::nothingIsCut()
{
    QFETCH(double, points);
    const QFont before = QApplication::font();
    QFont font = before;
    font.setPointSizeF(points);
    QApplication::setFont(font);
    for (const bool dark : {true, false}) {
        QWidget window;
        window.resize(1280, 800);
        const ThemeSource theme{dark ? darkTheme(points) : lightTheme(points)};
        applyTheme(*qApp, theme.theme());
        AddLinkDialog dialog(linkChoices(listings(), {}), theme, &window);
        dialog.show();
        dialog.findChild<QTreeWidget *>()->setCurrentItem(
            dialog.findChild<QTreeWidget *>()->findItems(s("spidev"), Qt::MatchContains | Qt::MatchRecursive).at(0));
        QTest::qWait(0);
        QVERIFY(dialog.width() <= 1280 && dialog.height() <= 800);
        const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
        if (!folder.isEmpty())
            dialog.grab().save(folder + s("/addlink-%1-%2.png").arg(points).arg(dark ? s("dark") : s("light")));
    }
    QApplication::setFont(before);
}

MB_WINDOW_TEST(AddLinkTest);
#include "tst_addlink.moc"
