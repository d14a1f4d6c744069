// SPDX-License-Identifier: GPL-3.0-or-later
// Files of parameters: export, import, comparison, and what is refused.
#include "parameterbench.h"

#include "model/parameterfile.h"
#include "support/windowtests.h"
#include "widgets/parameters/comparisonbox.h"

#include <QComboBox>
#include <QFileDialog>

#include <algorithm>

using namespace mb;
using namespace mb::test;

class TestParameterFiles : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void exportAndImportAreARoundTrip();
    void exportIsTheFileOfTheConsole();
    void onlyWhatIsInTheFileIsCounted();
    void importNeverWrites();
    void anImportIsTakenBackByItsNoticeOnlyWhileItIsTheLastEdit();
    void aFileWithAnUnknownKeyIsRefusedAsAWhole();
    void aFileOfAnotherFamilyIsRefused();
    void aDamagedFileIsRefused();
    void comparisonShowsAFileBesideTheValues();
    void withoutADeviceAFileCanBeLookedAt();
    void aFileThatAUnitReplacedIsNotShownAfterIt();
    void aFileThatIsNotChosenLeavesWhatIsComparedWith();
};

void TestParameterFiles::exportAndImportAreARoundTrip()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("five.json"));
    ParameterBench first;
    first.set("slot1.p", 1.165, ParameterState::Stored);
    first.set("current_limit.enabled", 1, ParameterState::Stored);
    first.set("status.general.period", 20, ParameterState::Volatile);
    first.page->exportTo(path);
    QCOMPARE(first.workbench.lines.size(), std::size_t{1});
    first.page->importFrom(path);
    QVERIFY(says(first, QStringLiteral("says what the device has")));
    ParameterBench second;
    second.page->importFrom(path);
    QCOMPARE(second.edits().count(), 2); // the period is not kept, so a file does not bring it back
    QCOMPARE(second.edits().find(named("slot1.p"))->value.raw.value(), rawOf("slot1.p", 1.165));
    QTest::keyClick(second.page.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(second.edits().count(), 0);
}

void TestParameterFiles::onlyWhatIsInTheFileIsCounted()
{
    ParameterBench bench;
    const QTemporaryDir folder;
    DeviceView &drive = bench.workbench.device(0);
    drive.parameters.edit()[named("slot1.i").value] = {};
    ++drive.parameterRevision;
    bench.workbench.publish();
    const QString path = folder.filePath(QStringLiteral("part.json"));
    bench.page->exportTo(path);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonObject rows
        = QJsonDocument::fromJson(file.readAll()).object().value(QLatin1String("parameters")).toObject();
    const auto written = static_cast<int>(std::count_if(rows.begin(), rows.end(),
        [](const QJsonValue &row) { return row.toObject().value(QLatin1String("raw")).isDouble(); }));
    QVERIFY(written > 0 && written < static_cast<int>(drive.parameters->size()));
    const QString said = bench.workbench.lines.back().text;
    QVERIFY2(said.startsWith(QString::number(written) + QLatin1Char(' ')), qPrintable(said));
}

void TestParameterFiles::exportIsTheFileOfTheConsole()
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
    QCOMPARE(parsed->values.size(), std::size_t{55});
}

void TestParameterFiles::importNeverWrites()
{
    QTemporaryDir folder;
    ParameterBench bench;
    bench.page->importFrom(
        write(folder, QStringLiteral("a.json"), R"({"family":"dmc60c","parameters":{"slot1.p":{"value":2}}})"));
    QCOMPARE(bench.edits().count(), 1);
    QVERIFY(bench.workbench.given<orders::WriteParameters>().empty());
}

void TestParameterFiles::anImportIsTakenBackByItsNoticeOnlyWhileItIsTheLastEdit()
{
    QTemporaryDir folder;
    ParameterBench bench;
    const QString undo = QStringLiteral("Undo the import");
    const QString path
        = write(folder, QStringLiteral("a.json"), R"({"family":"dmc60c","parameters":{"slot1.p":{"value":2}}})");
    bench.stage("slot0.p", "3");
    bench.page->importFrom(path);
    bench.stage("slot0.i", "4");
    QVERIFY(says(bench, QStringLiteral("Staged from a.json")));
    QVERIFY2(!button(bench, undo), "it would take back the edit after it");
    QTest::keyClick(bench.page.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(button(bench, undo));
    button(bench, undo)->click();
    QVERIFY(!bench.edits().find(named("slot1.p")));
    QCOMPARE(bench.edits().count(), 1);

    bench.page->importFrom(path);
    QVERIFY(button(bench, undo));
    QTest::keyClick(bench.page.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY2(!button(bench, undo), "it is taken back, and the edit before it is not its business");
    QCOMPARE(bench.edits().count(), 1);
}

void TestParameterFiles::aFileWithAnUnknownKeyIsRefusedAsAWhole()
{
    QTemporaryDir folder;
    ParameterBench bench;
    bench.page->importFrom(write(folder, QStringLiteral("a.json"),
        R"({"family":"dmc60c","parameters":{"slot1.p":{"value":2},"unknown.key":{"value":1}}})"));
    QCOMPARE(bench.edits().count(), 0);
    QVERIFY(says(bench, QStringLiteral("unknown.key")));
}

void TestParameterFiles::aFileOfAnotherFamilyIsRefused()
{
    QTemporaryDir folder;
    ParameterBench bench;
    bench.page->importFrom(write(folder, QStringLiteral("s.json"), R"({"family":"toaster","parameters":{}})"));
    QCOMPARE(bench.edits().count(), 0);
    QVERIFY(says(bench, QStringLiteral("s.json is for family “toaster”, DMC60C #5 is of the family DMC60C.")));
}

void TestParameterFiles::aDamagedFileIsRefused()
{
    QTemporaryDir folder;
    ParameterBench bench;
    for (const char *text : {"", "{", "[]", "{\"family\":\"dmc60c\"}",
             R"({"family":"dmc60c","parameters":{"slot1.p":{"value":2},"slot1.i":{"value":1e9}}})"}) {
        bench.page->importFrom(write(folder, QStringLiteral("d.json"), text));
        QCOMPARE(bench.edits().count(), 0);
        QVERIFY2(says(bench, QStringLiteral("Nothing was changed.")), text);
    }
    bench.page->importFrom(folder.filePath(QStringLiteral("missing.json")));
    QVERIFY(says(bench, QStringLiteral("no such file")));
}

void TestParameterFiles::comparisonShowsAFileBesideTheValues()
{
    QTemporaryDir folder;
    ParameterBench bench;
    QCOMPARE(bench.shown("slot1.p", ParameterModel::Reference), QStringLiteral("0"));
    bench.page->compareWith(write(folder, QStringLiteral("c.json"),
        R"({"family":"dmc60c","parameters":{"slot1.p":{"value":2},"slot1.i":{"value":0}}})"));
    QCOMPARE(bench.shown("slot1.p", ParameterModel::Reference), QStringLiteral("2.000"));
    QCOMPARE(bench.shown("slot1.d", ParameterModel::Reference), QStringLiteral("–"));
    QCOMPARE(bench.model().headerData(ParameterModel::Reference, Qt::Horizontal).toString(), QStringLiteral("c.json"));
    QCOMPARE(countParameters(bench.model()).changed, 1);
    QCOMPARE(bench.edits().count(), 0);
}

void TestParameterFiles::withoutADeviceAFileCanBeLookedAt()
{
    QTemporaryDir folder;
    ParameterBench bench;
    bench.selection.select({});
    QVERIFY(says(bench, QStringLiteral("Select a device")));
    bench.page->openFile(
        write(folder, QStringLiteral("f.json"), R"({"family":"dmc60c","parameters":{"slot1.p":{"value":2}}})"));
    QCOMPARE(bench.shown("slot1.p", ParameterModel::ValueColumn), QStringLiteral("2.000"));
    QCOMPARE(bench.shown("slot1.p", ParameterModel::State), QStringLiteral("from a file"));
    QCOMPARE(countParameters(bench.model()).changed, 1);
    QVERIFY((bench.model().indexOf(named("slot1.p")).flags() & Qt::ItemIsEditable) == 0);
    bench.page->compareWith(
        write(folder, QStringLiteral("g.json"), R"({"family":"dmc60c","parameters":{"slot1.p":{"value":2}}})"));
    QCOMPARE(countParameters(bench.model()).changed, 0);
    bench.page->write();
    bench.workbench.publish();
    QVERIFY(bench.workbench.given<orders::WriteParameters>().empty());
    bench.selection.select({1});
    QCOMPARE(bench.shown("slot1.p", ParameterModel::State), QStringLiteral("stored"));
}

void TestParameterFiles::aFileThatAUnitReplacedIsNotShownAfterIt()
{
    QTemporaryDir folder;
    ParameterBench bench;
    bench.selection.select({});
    bench.page->openFile(
        write(folder, QStringLiteral("f.json"), R"({"family":"dmc60c","parameters":{"slot1.p":{"value":2}}})"));
    bench.workbench.device(0).identity.edit().state = DeviceState::Bootloader;
    bench.workbench.publish();
    bench.selection.select({1});
    QVERIFY(says(bench, QStringLiteral("has no application running")));
    bench.workbench.shot.devices.clear();
    bench.workbench.publish();
    QVERIFY(!says(bench, QStringLiteral("has no application running")));
    QVERIFY(says(bench, QStringLiteral("Select a device")));
}

void TestParameterFiles::aFileThatIsNotChosenLeavesWhatIsComparedWith()
{
    DeviceView board = readDrive();
    const auto all = families();
    board.family = *std::find_if(all.begin(), all.end(), [](const Family *one) { return one->capabilities.axes > 1; });
    board.parameters.edit().assign(board.family->parameters.size(), {0, ParameterState::Stored});
    ParameterBench bench(board);
    bench.selection.select({1}, 1);
    auto &box = *bench.page->findChild<ComparisonBox *>()->findChild<QComboBox *>();
    const auto choose = [&box](const char *words) {
        const int row = box.findText(QString::fromUtf8(words));
        QVERIFY2(row >= 0, words);
        box.setCurrentIndex(row);
        Q_EMIT box.activated(row);
    };
    choose("axis 2");
    const QString axis = bench.model().reference().title;
    choose("a file…");
    delete bench.page->findChild<QFileDialog *>();
    QCOMPARE(bench.model().reference().title, axis);
    bench.selection.select({1}, 2);
    QVERIFY2(bench.model().reference().title != axis, "it would be compared with itself");
    QCOMPARE(box.currentText(), QStringLiteral("defaults"));
}

MB_WINDOW_TEST(TestParameterFiles);
#include "tst_parameterfiles.moc"
