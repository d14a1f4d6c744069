// SPDX-License-Identifier: GPL-3.0-or-later
// What is ordered of devices beside the pages: their names, and moves that several begin together.
#include "support/utf8.h"
#include "support/windowtests.h"
#include "tunebench.h"
#include "widgets/connection/deviceactions.h"
#include "widgets/control/movespanel.h"

#include <QCheckBox>
#include <QInputDialog>
#include <QTest>

using namespace mb;
using namespace mb::test;

namespace {

DeviceView nodeOf(std::uint32_t id)
{
    DeviceView node;
    node.id = {id};
    node.family = findFamily(families(), "supermodified");
    node.identity.edit().address = static_cast<int>(id);
    node.link = "sim:serial";
    node.liveness.heard = true;
    return node;
}

} // namespace

class TestDeviceOrders : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aNameIsSentAsItIsWritten_data();
    void aNameIsSentAsItIsWritten();
    void aNumberIsTakenByItsOwnFamilyOnly();
    void onlyWhatSomebodyTickedMovesTogetherAndStaysSo();
};

void TestDeviceOrders::aNameIsSentAsItIsWritten_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("of Latin-1") << s("F\u00F6rderband");
    QTest::newRow("of no Latin-1: the device refuses it") << s("\u03A91");
}

void TestDeviceOrders::aNameIsSentAsItIsWritten()
{
    QFETCH(QString, name);
    TuneBench bench;
    askRename(bench.workbench, {1}, *bench.page);
    auto *const dialog = bench.page->findChild<QInputDialog *>();
    QVERIFY(dialog);
    dialog->setTextValue(name);
    dialog->accept();
    QCOMPARE(QString::fromUtf8(bench.workbench.given<orders::Rename>().at(0).name.c_str()), name);
}

void TestDeviceOrders::aNumberIsTakenByItsOwnFamilyOnly()
{
    TuneBench bench;
    DeviceView own = nodeOf(4);
    DeviceView other = nodeOf(3);
    other.family = findFamily(families(), "abstractdc");
    bench.workbench.shot.devices = {own, other, nodeOf(6)};
    const auto assign = [&bench](int number) {
        askRenumber(bench.workbench, {4}, *bench.page);
        const auto dialogs = bench.page->findChildren<QInputDialog *>();
        dialogs.back()->setIntValue(number);
        dialogs.back()->accept();
        return bench.workbench.given<orders::Renumber>().size();
    };
    QCOMPARE(assign(6), std::size_t(0));
    QCOMPARE(assign(3), std::size_t(1));
}

void TestDeviceOrders::onlyWhatSomebodyTickedMovesTogetherAndStaysSo()
{
    FakeWorkbench workbench;
    Arming arming(workbench);
    ThemeSource theme(darkTheme());
    MovesPanel panel(workbench, arming, theme);
    workbench.shot.devices = {nodeOf(4), nodeOf(5)};
    const auto follow = [&] { panel.follow(workbench.shot.devices.front()); };
    const auto ticks = [&panel] {
        QStringList ticked;
        for (const QCheckBox *box : panel.findChildren<QCheckBox *>()) {
            if (box->isChecked() && box->text().startsWith(QLatin1Char('#')))
                ticked << box->text();
        }
        return ticked.join(QLatin1Char(' '));
    };
    const auto field = [&panel](const char *unit) {
        for (QLineEdit *one : panel.findChildren<QLineEdit *>()) {
            if (one->accessibleName().contains(s(unit)))
                return one;
        }
        return static_cast<QLineEdit *>(nullptr);
    };
    follow();
    QCOMPARE(ticks(), QString());
    for (QCheckBox *box : panel.findChildren<QCheckBox *>()) {
        if (box->text() == s("#4"))
            box->setChecked(true);
    }
    field("#4")->setText(s("500"));
    workbench.shot.devices.push_back(nodeOf(6));
    follow();
    QCOMPARE(ticks(), s("#4"));
    QCOMPARE(field("#4")->text(), s("500"));
    QCOMPARE(field("#6")->text(), s("0"));
    workbench.shot.devices.erase(workbench.shot.devices.begin()); // and back again
    follow();
    workbench.shot.devices.insert(workbench.shot.devices.begin(), nodeOf(4));
    follow();
    QCOMPARE(ticks(), s("#4"));
    QCOMPARE(field("#4")->text(), s("500"));
}

MB_WINDOW_TEST(TestDeviceOrders);
#include "tst_deviceorders.moc"
