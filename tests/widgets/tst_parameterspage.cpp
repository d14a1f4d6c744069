// SPDX-License-Identifier: GPL-3.0-or-later
// The page as a user works with it: keys, fields, write, files, states.
#include "parameterbench.h"

#include "model/parameterfile.h"
#include "widgets/common/banner.h"
#include "widgets/common/emptystate.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QTemporaryDir>
#include <QTest>

using namespace mb;
using namespace mb::test;

namespace {

/// The field that is open in the table.
QLineEdit *field(ParameterBench &bench)
{
    return bench.view().viewport()->findChild<QLineEdit *>();
}

void open(ParameterBench &bench, const char *key)
{
    bench.view().setFocus();
    bench.view().goTo(named(key));
    QTest::keyClick(&bench.view(), Qt::Key_Return);
    QVERIFY(field(bench));
}

QAbstractButton *button(ParameterBench &bench, const QString &text)
{
    for (auto *candidate : bench.page->findChildren<QAbstractButton *>()) {
        if (candidate->isVisible() && candidate->text().startsWith(text))
            return candidate;
    }
    return nullptr;
}

bool says(ParameterBench &bench, const QString &part)
{
    for (const auto *label : bench.page->findChildren<QLabel *>()) {
        if (label->isVisible() && label->text().contains(part))
            return true;
    }
    return false;
}

QString write(const QTemporaryDir &folder, const QString &name, const QByteArray &text)
{
    const QString path = folder.filePath(name);
    QFile file(path);
    [[maybe_unused]] const bool open = file.open(QIODevice::WriteOnly);
    file.write(text);
    return path;
}

} // namespace

class TestParametersPage : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void enterOpensTypesAndCommits();
    void aDigitStartsEditing();
    void escapeKeepsTheOldValue();
    void tabGoesToTheNextField();
    void enterSwitchesWhatIsOnOrOff();
    void aFaultAppearsWhileTypingAndIsMendedByOneClick();
    void aSnapshotWhileTypingLosesNothing();
    void anotherSelectionKeepsTheEdits();
    void aVanishedDeviceKeepsTheEdits();
    void writeSendsExactlyWhatIsStaged();
    void writeIsRefusedWhileAnErrorIsStaged();
    void writeOfAnOpenFieldTakesItAlong();
    void aFailedWriteKeepsTheRestAndSaysWhy();
    void readBackEndsTheEditAndShowsRam();
    void storeIsOfferedAfterTheCountdown();
    void unknownValuesAreReadOnce();
    void progressOfReadingIsShown();
    void exportAndImportAreARoundTrip();
    void exportIsTheFileOfTheConsole();
    void importNeverWrites();
    void aFileOfAnotherFamilyIsRefused();
    void aDamagedFileIsRefused();
    void comparisonShowsAFileBesideTheValues();
    void withoutADeviceAFileCanBeLookedAt();
    void bootloaderHasNoParameters();
    void copyGivesKeyAndValue();
    void everyControlHasAName();
    void nothingIsCutAtTwiceTheFont();
};

void TestParametersPage::initTestCase()
{
    applyTheme(*qApp, lightTheme());
}

void TestParametersPage::enterOpensTypesAndCommits()
{
    ParameterBench bench;
    open(bench, "slot1.p");
    QTest::keyClicks(field(bench), QStringLiteral("1,25"));
    QCOMPARE(bench.shown("slot1.p", ParameterModel::State), QStringLiteral("edited, was 0"));
    QTest::keyClick(field(bench), Qt::Key_Return);
    QTRY_VERIFY(!field(bench));
    QCOMPARE(bench.edits().toWrite().front().raw, rawOf("slot1.p", 1.25));
    QTest::keyClick(bench.page.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench.edits().count(), 0);
    QTest::keyClick(bench.page.get(), Qt::Key_Y, Qt::ControlModifier);
    QCOMPARE(bench.edits().count(), 1);
}

void TestParametersPage::aDigitStartsEditing()
{
    ParameterBench bench;
    bench.view().setFocus();
    bench.view().goTo(named("slot1.i_zone"));
    QTest::keyClick(&bench.view(), Qt::Key_4);
    QVERIFY(field(bench));
    QTest::keyClick(field(bench), Qt::Key_2);
    QCOMPARE(field(bench)->text(), QStringLiteral("42"));
}

void TestParametersPage::escapeKeepsTheOldValue()
{
    ParameterBench bench;
    open(bench, "slot1.p");
    QTest::keyClicks(field(bench), QStringLiteral("9"));
    QTest::keyClick(field(bench), Qt::Key_Escape);
    QTRY_VERIFY(!field(bench));
    QCOMPARE(bench.edits().count(), 0);
    QVERIFY(!bench.edits().undoStack().canUndo());
}

void TestParametersPage::tabGoesToTheNextField()
{
    ParameterBench bench;
    open(bench, "slot1.p");
    QTest::keyClicks(field(bench), QStringLiteral("9"));
    QTest::keyClick(field(bench), Qt::Key_Tab);
    QVERIFY(bench.view().currentParameter() == named("slot1.i"));
    QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("8"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab);
    QVERIFY(bench.view().currentParameter() == named("slot1.p"));
    QCOMPARE(bench.edits().count(), 2);
}

void TestParametersPage::enterSwitchesWhatIsOnOrOff()
{
    ParameterBench bench;
    bench.view().setFocus();
    bench.view().goTo(named("current_limit.enabled"));
    QTest::keyClick(&bench.view(), Qt::Key_Return);
    QCOMPARE(bench.shown("current_limit.enabled", ParameterModel::State), QStringLiteral("edited, was off"));
    const QRect cell = bench.view().visualRect(bench.model().indexOf(named("current_limit.enabled")));
    QTest::mouseClick(bench.view().viewport(), Qt::LeftButton, Qt::NoModifier, cell.center());
    QCOMPARE(bench.edits().count(), 0);
}

void TestParametersPage::aFaultAppearsWhileTypingAndIsMendedByOneClick()
{
    ParameterBench bench;
    bench.set("slot1.max_forward", 18022, ParameterState::Stored);
    open(bench, "slot1.max_forward");
    QTest::keyClicks(field(bench), QStringLiteral("4000"));
    QVERIFY(!button(bench, QStringLiteral("Use 32767")));
    QTest::keyClicks(field(bench), QStringLiteral("0"));
    QCOMPARE(field(bench)->property("state").toString(), QStringLiteral("error"));
    QVERIFY(says(bench, QStringLiteral("40000 is above 32767 (100 %).")));
    QVERIFY(button(bench, QStringLiteral("Revert to 18022")));
    QTest::mouseClick(button(bench, QStringLiteral("Use 32767")), Qt::LeftButton);
    QCOMPARE(bench.edits().toWrite().front().raw, 32767);
    QTRY_VERIFY(!button(bench, QStringLiteral("Use 32767")));
    QVERIFY(!field(bench));
}

void TestParametersPage::aSnapshotWhileTypingLosesNothing()
{
    ParameterBench bench;
    open(bench, "slot1.p");
    QTest::keyClicks(field(bench), QStringLiteral("1.2"));
    QLineEdit *before = field(bench);
    bench.set("slot1.p", 7, ParameterState::Stored);
    bench.set("slot1.i", 3, ParameterState::Ram);
    QCOMPARE(field(bench), before);
    QVERIFY(before->hasFocus());
    QTest::keyClicks(before, QStringLiteral("5"));
    QCOMPARE(before->text(), QStringLiteral("1.25"));
    QTest::keyClick(before, Qt::Key_Return);
    QCOMPARE(bench.edits().toWrite().front().raw, rawOf("slot1.p", 1.25));
    QCOMPARE(bench.shown("slot1.p", ParameterModel::State), QStringLiteral("edited, was 7"));
}

void TestParametersPage::anotherSelectionKeepsTheEdits()
{
    ParameterBench bench;
    bench.workbench.shot.devices.push_back(readDrive(2, 7));
    bench.workbench.publish();
    open(bench, "slot1.p");
    QTest::keyClicks(field(bench), QStringLiteral("9"));
    bench.selection.select({2});
    QCOMPARE(bench.edits().count(), 0);
    bench.selection.select({1});
    QCOMPARE(bench.edits().count(), 1);
    QCOMPARE(bench.shown("slot1.p", ParameterModel::ValueColumn), QStringLiteral("9"));
}

void TestParametersPage::aVanishedDeviceKeepsTheEdits()
{
    ParameterBench bench;
    bench.stage("slot1.p", "9");
    const DeviceView device = bench.workbench.device(0);
    bench.workbench.shot.devices.clear();
    bench.workbench.publish();
    QVERIFY(says(bench, QStringLiteral("Select a device")));
    bench.workbench.shot.devices.push_back(device);
    bench.workbench.publish();
    QCOMPARE(bench.edits().count(), 1);
}

void TestParametersPage::writeSendsExactlyWhatIsStaged()
{
    ParameterBench bench;
    bench.stage("slot1.p", "2");
    bench.stage("current_limit.peak", "80");
    bench.stage("slot1.i", "3");
    bench.edits().setIncluded(named("slot1.i"), false);
    QTest::keyClick(bench.page.get(), Qt::Key_S, Qt::ControlModifier);
    const auto calls = bench.workbench.callsOf("writeParameters");
    QCOMPARE(calls.size(), std::size_t {1});
    QVERIFY(calls[0].device == DeviceId {1});
    QCOMPARE(calls[0].changes.size(), std::size_t {2});
    QVERIFY(calls[0].changes[0].index == named("current_limit.peak"));
    QCOMPARE(calls[0].changes[0].raw, rawOf("current_limit.peak", 80));
    QVERIFY(calls[0].changes[1].index == named("slot1.p"));
    calls[0].finished({});
    QCOMPARE(bench.edits().count(), 1);
    QVERIFY(bench.edits().find(named("slot1.i")));
}

void TestParametersPage::writeIsRefusedWhileAnErrorIsStaged()
{
    ParameterBench bench;
    bench.stage("slot1.p", "2");
    bench.stage("slot1.max_forward", "40000");
    QTest::keyClick(bench.page.get(), Qt::Key_S, Qt::ControlModifier);
    QVERIFY(bench.workbench.callsOf("writeParameters").empty());
    const auto *writing = bench.page->findChild<QAbstractButton *>(QStringLiteral("writeButton"));
    QVERIFY(!writing->isEnabled());
    QVERIFY(writing->accessibleName().contains(QStringLiteral("fix 1 value first")));
}

void TestParametersPage::writeOfAnOpenFieldTakesItAlong()
{
    ParameterBench bench;
    open(bench, "slot1.p");
    QTest::keyClicks(field(bench), QStringLiteral("2"));
    bench.page->write();
    const auto calls = bench.workbench.callsOf("writeParameters");
    QCOMPARE(calls.size(), std::size_t {1});
    QCOMPARE(calls[0].changes.size(), std::size_t {1});
    QCOMPARE(calls[0].changes[0].raw, rawOf("slot1.p", 2));
}

void TestParametersPage::aFailedWriteKeepsTheRestAndSaysWhy()
{
    ParameterBench bench;
    bench.stage("slot1.p", "2");
    bench.stage("current_limit.peak", "80");
    bench.page->write();
    bench.set("current_limit.peak", 80, ParameterState::Ram);
    bench.workbench.callsOf("writeParameters")[0].finished(fail(Fault::BadCheck, "slot1.p was written as 2 but reads 1"));
    QCOMPARE(bench.edits().count(), 1);
    QVERIFY(bench.edits().find(named("slot1.p")));
    QVERIFY(says(bench, QStringLiteral("slot1.p was written as 2 but reads 1")));
}

void TestParametersPage::readBackEndsTheEditAndShowsRam()
{
    ParameterBench bench;
    bench.stage("slot1.p", "2");
    bench.page->write();
    bench.set("slot1.p", 2, ParameterState::Ram);
    QCOMPARE(bench.edits().count(), 0);
    QCOMPARE(bench.shown("slot1.p", ParameterModel::State), QStringLiteral("RAM, not in flash"));
    QVERIFY(says(bench, QStringLiteral("0 → <b>2</b>")));
    bench.set("slot1.p", 2, ParameterState::Stored);
    QCOMPARE(bench.shown("slot1.p", ParameterModel::State), QStringLiteral("stored"));
    QVERIFY(!says(bench, QStringLiteral("0 → <b>2</b>")));
}

void TestParametersPage::storeIsOfferedAfterTheCountdown()
{
    ParameterBench bench;
    bench.set("slot1.p", 2, ParameterState::Ram);
    QVERIFY(says(bench, QStringLiteral("15 s to go")));
    QVERIFY(!button(bench, QStringLiteral("Store and prove")));
    bench.workbench.time += std::chrono::seconds(9);
    bench.set("slot0.p", 2, ParameterState::Ram); // starts it again
    bench.workbench.time += std::chrono::seconds(14);
    bench.set("slot0.i", 2, ParameterState::Volatile);
    QVERIFY(says(bench, QStringLiteral("1 s to go")));
    bench.workbench.time += std::chrono::seconds(1);
    bench.set("slot0.i", 3, ParameterState::Volatile);
    QAbstractButton *store = button(bench, QStringLiteral("Store and prove"));
    QVERIFY(store);
    QTest::mouseClick(store, Qt::LeftButton);
    QCOMPARE(bench.workbench.callsOf("storeParameters").size(), std::size_t {1});
}

void TestParametersPage::unknownValuesAreReadOnce()
{
    DeviceView device = readDrive();
    device.parameters.assign(device.parameters.size(), {});
    ParameterBench bench(device);
    QCOMPARE(bench.workbench.callsOf("readParameters").size(), std::size_t {1});
    QCOMPARE(bench.shown("slot1.p", ParameterModel::ValueColumn), QStringLiteral("–"));
    bench.workbench.publish();
    bench.page->hide();
    bench.page->show();
    QCOMPARE(bench.workbench.callsOf("readParameters").size(), std::size_t {1});
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QCOMPARE(bench.workbench.callsOf("readParameters").size(), std::size_t {2});
}

void TestParametersPage::progressOfReadingIsShown()
{
    ParameterBench bench;
    OperationView operation;
    operation.id = {4};
    operation.device = {1};
    operation.status.title = "Read parameters";
    operation.status.done = 23;
    operation.status.total = 55;
    bench.workbench.shot.operations.push_back(operation);
    bench.workbench.publish();
    QVERIFY(says(bench, QStringLiteral("Reading 23 of 55")));
    bench.stage("slot1.p", "2");
    bench.page->write();
    QVERIFY(bench.workbench.callsOf("writeParameters").empty()); // one thing at a time
    bench.workbench.shot.operations[0].status.state = OperationStatus::State::Done;
    bench.workbench.shot.operations[0].status.endedAt += std::chrono::milliseconds(70);
    bench.workbench.publish();
    QVERIFY(says(bench, QStringLiteral("all 55 read in 70")));
}

void TestParametersPage::exportAndImportAreARoundTrip()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("five.json"));
    ParameterBench first;
    first.set("slot1.p", 1.165, ParameterState::Stored);
    first.set("current_limit.enabled", 1, ParameterState::Stored);
    first.set("status.general.period", 20, ParameterState::Volatile);
    first.page->exportTo(path);
    QCOMPARE(first.workbench.lines.size(), std::size_t {1});
    first.page->importFrom(path);
    QVERIFY(says(first, QStringLiteral("says what the device has")));
    ParameterBench second;
    second.page->importFrom(path);
    QCOMPARE(second.edits().count(), 2); // the period is not kept, so a file does not bring it back
    QCOMPARE(second.edits().find(named("slot1.p"))->value.raw.value(), rawOf("slot1.p", 1.165));
    QTest::keyClick(second.page.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(second.edits().count(), 0);
}

void TestParametersPage::exportIsTheFileOfTheConsole()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("five.json"));
    ParameterBench bench;
    bench.page->exportTo(path);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const auto parsed = parseParameterFile(file.readAll(), dmc60c());
    QVERIFY(parsed);
    QCOMPARE(parsed->device, std::string("can:can0/dmc60c:5"));
    QCOMPARE(parsed->serial, std::string("2103343A79F2"));
    QCOMPARE(parsed->values.size(), std::size_t {55});
}

void TestParametersPage::importNeverWrites()
{
    QTemporaryDir folder;
    ParameterBench bench;
    bench.page->importFrom(write(folder, QStringLiteral("a.json"), R"({"family":"dmc60c","parameters":{"slot1.p":{"value":2},"unknown.key":{"value":1}}})"));
    QCOMPARE(bench.edits().count(), 1);
    QVERIFY(says(bench, QStringLiteral("unknown.key")));
    QVERIFY(bench.workbench.callsOf("writeParameters").empty());
}

void TestParametersPage::aFileOfAnotherFamilyIsRefused()
{
    QTemporaryDir folder;
    ParameterBench bench;
    bench.page->importFrom(write(folder, QStringLiteral("s.json"), R"({"family":"toaster","parameters":{}})"));
    QCOMPARE(bench.edits().count(), 0);
    QVERIFY(says(bench, QStringLiteral("s.json is for family “toaster”, DMC60C #5 is a DMC60C.")));
}

void TestParametersPage::aDamagedFileIsRefused()
{
    QTemporaryDir folder;
    ParameterBench bench;
    for (const char *text : {"", "{", "[]", "{\"family\":\"dmc60c\"}", R"({"family":"dmc60c","parameters":{"slot1.p":{"value":2},"slot1.i":{"value":1e9}}})"}) {
        bench.page->importFrom(write(folder, QStringLiteral("d.json"), text));
        QCOMPARE(bench.edits().count(), 0);
        QVERIFY2(says(bench, QStringLiteral("Nothing was changed.")), text);
    }
    bench.page->importFrom(folder.filePath(QStringLiteral("missing.json")));
    QVERIFY(says(bench, QStringLiteral("does not exist")));
}

void TestParametersPage::comparisonShowsAFileBesideTheValues()
{
    QTemporaryDir folder;
    ParameterBench bench;
    QCOMPARE(bench.shown("slot1.p", ParameterModel::Reference), QStringLiteral("0"));
    bench.page->compareWith(write(folder, QStringLiteral("c.json"), R"({"family":"dmc60c","parameters":{"slot1.p":{"value":2},"slot1.i":{"value":0}}})"));
    QCOMPARE(bench.shown("slot1.p", ParameterModel::Reference), QStringLiteral("2"));
    QCOMPARE(bench.shown("slot1.d", ParameterModel::Reference), QStringLiteral("–"));
    QCOMPARE(bench.model().headerData(ParameterModel::Reference, Qt::Horizontal).toString(), QStringLiteral("c.json"));
    QCOMPARE(countParameters(bench.model()).changed, 1);
    QCOMPARE(bench.edits().count(), 0);
}

void TestParametersPage::withoutADeviceAFileCanBeLookedAt()
{
    QTemporaryDir folder;
    ParameterBench bench;
    bench.selection.select({});
    QVERIFY(says(bench, QStringLiteral("Select a device")));
    bench.page->openFile(write(folder, QStringLiteral("f.json"), R"({"family":"dmc60c","parameters":{"slot1.p":{"value":2}}})"));
    QCOMPARE(bench.shown("slot1.p", ParameterModel::ValueColumn), QStringLiteral("2"));
    QCOMPARE(bench.shown("slot1.p", ParameterModel::State), QStringLiteral("from a file"));
    QCOMPARE(countParameters(bench.model()).changed, 1);
    QVERIFY((bench.model().indexOf(named("slot1.p")).flags() & Qt::ItemIsEditable) == 0);
    bench.page->compareWith(write(folder, QStringLiteral("g.json"), R"({"family":"dmc60c","parameters":{"slot1.p":{"value":2}}})"));
    QCOMPARE(countParameters(bench.model()).changed, 0);
    bench.page->write();
    bench.workbench.publish();
    QVERIFY(bench.workbench.callsOf("writeParameters").empty());
    bench.selection.select({1});
    QCOMPARE(bench.shown("slot1.p", ParameterModel::State), QStringLiteral("stored"));
}

void TestParametersPage::bootloaderHasNoParameters()
{
    DeviceView device = readDrive();
    device.parameters.assign(device.parameters.size(), {});
    device.identity.state = DeviceState::Bootloader;
    ParameterBench bench(device);
    QVERIFY(says(bench, QStringLiteral("No parameters in the bootloader")));
    QVERIFY(bench.workbench.callsOf("readParameters").empty());
}

void TestParametersPage::copyGivesKeyAndValue()
{
    ParameterBench bench;
    bench.stage("slot1.p", "1.5");
    bench.view().setFocus();
    bench.view().goTo(named("slot1.p"));
    QTest::keyClick(&bench.view(), Qt::Key_Down, Qt::ShiftModifier);
    QTest::keyClick(&bench.view(), Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("slot1.p=1.5\nslot1.i=0"));
}

void TestParametersPage::everyControlHasAName()
{
    ParameterBench bench;
    bench.stage("slot1.p", "2");
    bench.stage("slot1.max_forward", "40000");
    bench.set("slot0.p", 2, ParameterState::Ram);
    for (const auto *widget : bench.page->findChildren<QWidget *>()) {
        const bool control = qobject_cast<const QAbstractButton *>(widget) || qobject_cast<const QLineEdit *>(widget) || qobject_cast<const QComboBox *>(widget)
            || qobject_cast<const QAbstractItemView *>(widget) || qobject_cast<const QProgressBar *>(widget);
        const bool ours = !widget->objectName().startsWith(QStringLiteral("qt_")) && !qobject_cast<const QComboBox *>(widget->parentWidget());
        if (control && ours && widget->isVisibleTo(bench.page.get()) && !widget->inherits("QComboBoxListView"))
            QVERIFY2(!widget->accessibleName().isEmpty(), qPrintable(QLatin1String(widget->metaObject()->className()) + widget->objectName()));
    }
}

void TestParametersPage::nothingIsCutAtTwiceTheFont()
{
    const QFont before = QApplication::font();
    QFont large = before;
    large.setPointSizeF(20);
    QApplication::setFont(large);
    applyTheme(*qApp, lightTheme(20));
    {
        ParameterBench bench;
        bench.theme.setTheme(lightTheme(20));
        bench.page = std::make_unique<ParametersPage>(bench.workbench, bench.selection, bench.theme, nullptr);
        bench.page->resize(1208, 760);
        bench.page->show();
        bench.stage("slot1.p", "2");
        bench.stage("slot1.max_forward", "40000");
        bench.view().goTo(named("slot1.max_forward"));
        QCoreApplication::processEvents();
        for (const auto *label : bench.page->findChildren<QWidget *>()) {
            const bool text = qobject_cast<const QAbstractButton *>(label) || (qobject_cast<const QLabel *>(label) && !label->inherits("mb::ElidedLabel"));
            if (!text || !label->isVisible())
                continue;
            const QByteArray name = label->property("text").toByteArray();
            QVERIFY2(label->width() >= std::min(label->sizeHint().width(), label->minimumSizeHint().width()), name);
            QVERIFY2(label->width() >= label->minimumSizeHint().width() && label->height() >= label->minimumSizeHint().height(), name);
        }
        const QRect cell = bench.view().visualRect(bench.model().indexOf(named("slot1.max_reverse")));
        const QFontMetrics metrics(large);
        QVERIFY(cell.width() > metrics.horizontalAdvance(QStringLiteral("−2147483648")));
        QVERIFY(cell.height() > metrics.height());
    }
    QApplication::setFont(before);
    applyTheme(*qApp, lightTheme());
}

QTEST_MAIN(TestParametersPage)
#include "tst_parameterspage.moc"
