// SPDX-License-Identifier: GPL-3.0-or-later
// What is being written is in sight until it is over, whatever is selected meanwhile.
#include "parameterbench.h"
#include "support/windowtests.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/stateglyph.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/firmware/pagemap.h"
#include "widgets/firmware/stepspanel.h"
#include "widgets/firmware/unitupdate.h"

#include <QCheckBox>
#include <QFile>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QPushButton>

using namespace mb;
using namespace mb::test;

class FirmwareTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anotherRowStillShowsWhatIsWrittenAndWhere();
    void nothingIsCalledSafeWhileAnotherUnitIsWritten();
    void whatAQueueWritesIsShownAsWhatThePageWrites();
    void whatAQueueHasWrittenIsNotGuessed();
    void pagesOfAnotherUnitAreNoStepsOfThisOne();
    void pagesOfAnImageThatIsNotWrittenAreNotGreen();
    void whenNothingIsWrittenNothingIsSaidOfACut();
    void inANarrowWindowWhatMayBeCutStandsBelowTheBar();
    void aSecondUpdateOnTheBusIsRefusedWithWords();
    void anotherBusMayBeUpdatedMeanwhile();
    void theButtonOfAnotherBusIsFreeMeanwhile();
    void withoutADeviceNothingIsSaidOfAMotor();
    void aCancelledUpdateSaysWhatIsKnownOfTheUnit();
    void aCancelAfterAllWasWrittenIsNotSaidToLeaveTheOldProgram();
    void aUnitThatHasTheVersionOfTheImageIsNotSaidToChange();
    void theCriticalPageIsOutlinedUntilItIsWritten();
    void anUpdateThatEndedBeforeItWroteSaysSo();
    void whatWasWrittenAndNotProvedIsNotCalledVerified();
    void anImageThatWasBuiltAnewIsReadAgainBeforeItIsWritten();
    void erasingIsChosenForOneUpdateOfOneUnit();
    void aUnitThatDoesNotAnswerIsNamedByItsLinkAndNumber();
};

namespace {

const QString imageFile = QStringLiteral(":/firmware/dmc60c-demo.hex");

struct FirmwareBench {
    FakeWorkbench workbench;
    Selection selection;
    ThemeSource theme{lightTheme()};
    std::unique_ptr<FirmwarePage> page;
    const Family *of = nullptr;

    explicit FirmwareBench(const std::string &secondLink = "sim:can", const Family *family = &dmc60c())
    {
        of = family;
        add(1, 5, "sim:can");
        add(2, 7, secondLink);
        selection.select({1});
        page = std::make_unique<FirmwarePage>(workbench, selection, families(), theme);
        page->resize(1000, 700);
        page->show();
        page->loadImage(imageFile);
    }
    void add(std::uint32_t id, int address, const std::string &link)
    {
        DeviceView device = readDrive(id, address);
        device.family = of;
        device.link = link;
        device.telemetry = std::make_shared<Telemetry>(of->channels);
        workbench.shot.devices.push_back(device);
        if (!workbench.shot.link(link)) {
            LinkView view;
            view.address = link;
            view.name = link;
            workbench.shot.links.push_back(view);
        }
    }
    [[nodiscard]] DeviceView &device() { return workbench.device(0); }
    void writing(bool mayInterrupt = true)
    {
        OperationView operation;
        operation.id = {3};
        operation.device = {1};
        operation.status.title = say("Update firmware");
        operation.status.kind = OperationKind::UpdateFirmware;
        operation.status.step = say("writing page");
        operation.status.done = 4;
        operation.status.total = 31;
        operation.status.mayInterrupt = mayInterrupt;
        workbench.shot.operations = {operation};
        workbench.publish();
    }
    void queueing(bool mayInterrupt, service::Step step = service::Step::Firmware, bool running = true)
    {
        service::QueueRow row;
        row.id = 7;
        row.device = {1};
        row.state = service::RowState::Running;
        row.visit.step = step;
        row.what = say("writing page");
        row.done = 4;
        row.total = 31;
        row.mayInterrupt = mayInterrupt;
        workbench.serve({row}, running);
        workbench.publish();
    }
    [[nodiscard]] bool says(const QString &part) const
    {
        const auto labels = page->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(),
            [&](const QLabel *label) { return label->isVisible() && label->text().contains(part); });
    }
    [[nodiscard]] QPushButton *start() const
    {
        for (auto *button : page->findChildren<QPushButton *>()) {
            if (button->text() == QStringLiteral("Update"))
                return button;
        }
        return nullptr;
    }
};

} // namespace

void FirmwareTest::anotherRowStillShowsWhatIsWrittenAndWhere()
{
    FirmwareBench bench;
    bench.writing();
    bench.selection.select({2});
    QVERIFY(bench.says(QStringLiteral("DMC60C #5 on sim:can: writing page, 4 of 31 written")));
    bench.workbench.shot.operations.front().status.state = OperationStatus::State::Done;
    bench.workbench.publish();
    QVERIFY(!bench.says(QStringLiteral("DMC60C #5 on sim:can")));
}

void FirmwareTest::nothingIsCalledSafeWhileAnotherUnitIsWritten()
{
    FirmwareBench bench;
    QVERIFY(bench.says(QStringLiteral("Nothing is written now")));
    bench.writing(false);
    bench.selection.select({2});
    QVERIFY(!bench.says(QStringLiteral("Nothing is written now")));
    QVERIFY(bench.says(QStringLiteral("Do not unplug: DMC60C #5 on sim:can")));
}

void FirmwareTest::whatAQueueWritesIsShownAsWhatThePageWrites()
{
    FirmwareBench bench;
    bench.queueing(false);
    QPushButton *start = bench.start();
    for (const DeviceId selected : {DeviceId{1}, DeviceId{2}}) {
        bench.selection.select(selected);
        bench.workbench.publish();
        QVERIFY(!bench.says(QStringLiteral("Nothing is written now")));
        QVERIFY(bench.says(QStringLiteral("Do not unplug: DMC60C #5 on sim:can")));
        QVERIFY(bench.says(QStringLiteral("DMC60C #5 on sim:can: writing page, 4 of 31 written")));
        QVERIFY(!start->isEnabled());
        QCOMPARE(start->toolTip(), QStringLiteral("One update a bus: DMC60C #5 on sim:can is being written."));
    }
    bench.queueing(false, service::Step::Parameters);
    QVERIFY(bench.says(QStringLiteral("Nothing is written now")));
    QVERIFY(!start->isEnabled()); // the bus is the queue's until it has ended
    QCOMPARE(start->toolTip(), QStringLiteral("Units are served on this link."));
    bench.queueing(false, service::Step::Parameters, false);
    QVERIFY(start->isEnabled());
}

void FirmwareTest::whatAQueueHasWrittenIsNotGuessed()
{
    FirmwareBench bench("sim:can", findFamily(families(), "abstractdc"));
    bench.queueing(true);
    for (const QPushButton *button : bench.page->findChildren<QPushButton *>())
        QVERIFY2(!button->toolTip().contains(QStringLiteral("Nothing is written")), qPrintable(button->toolTip()));
}

void FirmwareTest::pagesOfAnotherUnitAreNoStepsOfThisOne()
{
    FirmwareBench bench;
    bench.of = findFamily(families(), "quadquad2drv");
    bench.add(3, 0, "sim:spi");
    bench.writing();
    bench.workbench.shot.operations.front().status.parts
        = {{1, PartState::Done}, {2, PartState::Done}}; // 0 is the last
    bench.selection.select({3});
    bench.workbench.publish();
    const auto *steps = bench.page->unit().findChild<StepsPanel *>();
    QVERIFY(steps->isVisible());
    for (const StateGlyph *glyph : steps->findChildren<StateGlyph *>())
        QVERIFY(glyph->state() == GlyphState::Waiting);
}

void FirmwareTest::pagesOfAnImageThatIsNotWrittenAreNotGreen()
{
    FirmwareBench bench;
    const auto maps = bench.page->findChildren<PageMap *>(); // the queue has one, too
    const auto map = std::find_if(maps.begin(), maps.end(), [](const PageMap *each) { return each->isVisible(); });
    QVERIFY(map != maps.end());
    bench.writing();
    bench.workbench.shot.operations.front().status.parts = {{0, PartState::Done}, {1, PartState::Done}};
    bench.workbench.publish();
    QVERIFY((*map)->accessibleDescription().startsWith(QStringLiteral("2 of ")));
    bench.page->loadImage(imageFile);
    bench.workbench.publish();
    QVERIFY((*map)->accessibleDescription().isEmpty());
    bench.workbench.shot.operations.front().id = {4}; // an update with it
    bench.workbench.publish();
    QVERIFY((*map)->accessibleDescription().startsWith(QStringLiteral("2 of ")));
}

void FirmwareTest::whenNothingIsWrittenNothingIsSaidOfACut()
{
    FirmwareBench bench;
    const QString cut = tableText(updateWords(dmc60c()).cut);
    const QString safe = QStringLiteral("Safe to unplug: DMC60C #5 on sim:can");
    QVERIFY(!bench.says(cut));
    bench.writing();
    QVERIFY(bench.says(cut));
    OperationView &operation = bench.workbench.shot.operations.front();
    operation.status.state = OperationStatus::State::Done;
    for (const auto outcome : {UpdateOutcome::Failed, UpdateOutcome::Done}) { // the first page of one may be missing
        operation.update.emplace().outcome = outcome;
        bench.workbench.publish();
        QVERIFY(bench.says(safe) == (outcome == UpdateOutcome::Done) && !bench.says(cut));
    }
}

void FirmwareTest::inANarrowWindowWhatMayBeCutStandsBelowTheBar()
{
    FirmwareBench bench;
    bench.writing(false);
    bench.page->resize(600, 800);
    QCoreApplication::processEvents();
    QMap<int, QString> down; // what is read from the top to the bottom
    for (const QLabel *label : bench.page->findChildren<QLabel *>())
        down[label->mapTo(bench.page.get(), QPoint()).y()] += label->isVisible() ? label->text() : QString();
    const QString all = QStringList(down.values()).join(QString());
    const auto at = all.indexOf(QStringLiteral("Do not unplug"));
    QVERIFY2(at > all.indexOf(QStringLiteral("4 of 31 written")), qPrintable(all));
    QVERIFY2(at < all.indexOf(QStringLiteral("motor stopped")), qPrintable(all));
}

void FirmwareTest::aSecondUpdateOnTheBusIsRefusedWithWords()
{
    FirmwareBench bench;
    bench.selection.select({2});
    QVERIFY(bench.page->canStart());
    QPushButton *start = bench.start();
    bench.writing();
    QVERIFY(!bench.page->canStart());
    QVERIFY(!start->isEnabled());
    QCOMPARE(start->toolTip(), QStringLiteral("One update a bus: DMC60C #5 on sim:can is being written."));
    bench.page->startUpdate();
    QVERIFY(bench.workbench.given<orders::UpdateFirmware>().empty());
}

void FirmwareTest::anotherBusMayBeUpdatedMeanwhile()
{
    FirmwareBench bench("socketcan:can0");
    bench.writing();
    bench.selection.select({2});
    QVERIFY(bench.page->canStart());
    bench.page->startUpdate();
    QCOMPARE(bench.workbench.given<orders::UpdateFirmware>().size(), 1U);
    QVERIFY(bench.says(QStringLiteral("DMC60C #5 on sim:can"))); // until its own operation is there
}

void FirmwareTest::withoutADeviceNothingIsSaidOfAMotor()
{
    FirmwareBench bench;
    QVERIFY(bench.says(QStringLiteral("motor stopped")));
    bench.selection.select({});
    bench.workbench.shot.devices.clear();
    bench.workbench.publish();
    QVERIFY(!bench.says(QStringLiteral("motor stopped")));
    QVERIFY(bench.says(QStringLiteral("motor not known")));
    QVERIFY(bench.says(QStringLiteral("no device")));
}

void FirmwareTest::aUnitThatHasTheVersionOfTheImageIsNotSaidToChange()
{
    FirmwareBench bench;
    QVERIFY(bench.says(QStringLiteral(" → 1.25")));
    QVERIFY(bench.start()->property("primary").toBool());
    bench.workbench.shot.devices.front().identity.edit().firmware = "1.25";
    bench.workbench.publish();
    QVERIFY(!bench.says(QStringLiteral(" → 1.25")));
    QVERIFY(bench.says(QStringLiteral("1.25, as in the image")));
    QVERIFY(!bench.start()->property("primary").toBool()); // nothing calls for it
}

void FirmwareTest::theCriticalPageIsOutlinedUntilItIsWritten()
{
    FirmwareBench bench;
    const auto maps = bench.page->findChildren<PageMap *>(); // the queue has one, too
    const auto map = std::find_if(maps.begin(), maps.end(), [](const PageMap *each) { return each->isVisible(); });
    QVERIFY(map != maps.end());
    const auto outlined = [&] {
        const QImage image = (*map)->grab().toImage();
        const QColor danger = bench.theme.theme().danger;
        int red = 0; // its edges are smoothed
        for (int at = 0; at < image.width() * image.height(); ++at) {
            const QColor pixel = image.pixelColor(at % image.width(), at / image.width());
            red += qAbs(pixel.red() - danger.red()) + qAbs(pixel.green() - danger.green()) < 60 ? 1 : 0;
        }
        return red > 20;
    };
    QVERIFY(outlined());
    bench.writing();
    auto &parts = bench.workbench.shot.operations.front().status.parts;
    parts = {{0, PartState::Active}, {1, PartState::Done}};
    bench.workbench.publish();
    QVERIFY(outlined());
    parts[0] = PartState::Done;
    bench.workbench.publish();
    QVERIFY(!outlined());
}

void FirmwareTest::aCancelledUpdateSaysWhatIsKnownOfTheUnit()
{
    FirmwareBench bench;
    bench.writing();
    OperationView &operation = bench.workbench.shot.operations.front();
    operation.status.state = OperationStatus::State::Cancelled;
    operation.status.done = 0;
    operation.update = UpdateReport{};
    operation.update->outcome = UpdateOutcome::Cancelled;
    operation.update->evidence = say("cancelled");
    bench.workbench.publish();
    QVERIFY(bench.says(QStringLiteral("nothing was written")));
    operation.update->pages = 4;
    bench.workbench.publish();
    QVERIFY(!bench.says(QStringLiteral("nothing was written")));
    operation.update->evidence = say("page 4 is the last that was written");
    operation.update->remedy = say("run the update again");
    bench.workbench.publish();
    QVERIFY(bench.says(QStringLiteral("page 4 is the last that was written")));
}

/// Families whose flash a program beside this one writes: it is not to be cancelled before it has.
void FirmwareTest::aCancelAfterAllWasWrittenIsNotSaidToLeaveTheOldProgram()
{
    for (const Family *family : families()) {
        if (family->key != "abstractdc" && family->key != "supermodified")
            continue;
        FirmwareBench bench("sim:can", family);
        bench.writing();
        OperationView &operation = bench.workbench.shot.operations.front();
        operation.status.update.pages = 31;
        bench.workbench.publish();
        const auto buttons = bench.page->findChildren<QPushButton *>();
        QVERIFY(std::none_of(buttons.begin(), buttons.end(), [](const QPushButton *button) {
            return button->toolTip().contains(QStringLiteral("Nothing is written"));
        }));
        operation.status.state = OperationStatus::State::Cancelled;
        operation.update = UpdateReport{};
        operation.update->outcome = UpdateOutcome::Cancelled;
        operation.update->pages = 31;
        bench.workbench.publish();
        QVERIFY(bench.says(QStringLiteral("All of it is written")));
        QVERIFY(!bench.says(QStringLiteral("Nothing is written yet")));
    }
}

void FirmwareTest::theButtonOfAnotherBusIsFreeMeanwhile()
{
    FirmwareBench bench("socketcan:can0");
    QPushButton *start = bench.start();
    bench.writing();
    QVERIFY(!start->isEnabled());
    bench.selection.select({2});
    QVERIFY(start->isEnabled());
    start->click();
    QCOMPARE(bench.workbench.given<orders::UpdateFirmware>().size(), 1U);
}

/// Before the first page there are others to count: parameters of the backup, seconds until a unit has stored them.
void FirmwareTest::anUpdateThatEndedBeforeItWroteSaysSo()
{
    FirmwareBench bench;
    bench.writing();
    OperationView &operation = bench.workbench.shot.operations.front();
    operation.status.state = OperationStatus::State::Cancelled;
    operation.status.done = 3;
    operation.status.total = 20;
    operation.update = UpdateReport{};
    operation.update->outcome = UpdateOutcome::Cancelled;
    bench.workbench.publish();
    QVERIFY(bench.says(QStringLiteral("nothing was written")));
    bench.device().identity.edit().state = DeviceState::Bootloader; // for this
    bench.workbench.publish();
    QVERIFY(!bench.says(QStringLiteral("nothing was written")));
}

void FirmwareTest::whatWasWrittenAndNotProvedIsNotCalledVerified()
{
    FirmwareBench bench;
    bench.writing();
    OperationView &operation = bench.workbench.shot.operations.front();
    operation.status.state = OperationStatus::State::Done;
    operation.update = UpdateReport{};
    operation.update->outcome = UpdateOutcome::Done;
    operation.update->evidence = say("nothing proves the new firmware");
    bench.workbench.publish();
    QVERIFY(!bench.says(QStringLiteral("Verified")));
    QVERIFY(bench.says(QStringLiteral("Written, not proved: nothing proves the new firmware")));
    operation.update->verified = true;
    operation.update->evidence = say("it answers with 1.25");
    bench.workbench.publish();
    QVERIFY(bench.says(QStringLiteral("Verified: it answers with 1.25")));
}

void FirmwareTest::anImageThatWasBuiltAnewIsReadAgainBeforeItIsWritten()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("built.hex"));
    QVERIFY(QFile::copy(imageFile, path));
    QVERIFY(QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner));
    FirmwareBench bench;
    bench.page->loadImage(path);
    QFile file(path);
    QVERIFY(file.open(QIODevice::Append));
    file.write("\n");
    file.close();
    bench.page->startUpdate();
    QVERIFY(bench.workbench.given<orders::UpdateFirmware>().empty());
    QVERIFY(!bench.workbench.lines.empty());
    QVERIFY(bench.workbench.lines.back().text.contains(QStringLiteral("built.hex has changed")));
    bench.page->startUpdate();
    QCOMPARE(bench.workbench.given<orders::UpdateFirmware>().size(), 1U);
}

void FirmwareTest::erasingIsChosenForOneUpdateOfOneUnit()
{
    FirmwareBench bench("socketcan:can0", findFamily(families(), "abstractdc"));
    auto *erase = bench.page->findChild<QCheckBox *>(QStringLiteral("eraseSettings"));
    QVERIFY(erase && erase->isVisible());
    erase->setChecked(true);
    bench.selection.select({2});
    QVERIFY(!erase->isChecked());
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("drive.hex")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(":020000040800F2\n:0C0000000050002009000008FEE700BFCF\n:00000001FF\n");
    file.close();
    bench.page->loadImage(file.fileName());
    erase->setChecked(true);
    bench.page->startUpdate();
    const auto sent = bench.workbench.given<orders::UpdateFirmware>();
    QCOMPARE(sent.size(), 1U);
    QVERIFY(sent.front().options.eraseSettings);
    QVERIFY(!erase->isChecked());
}

void FirmwareTest::aUnitThatDoesNotAnswerIsNamedByItsLinkAndNumber()
{
    FirmwareBench bench;
    QMenu *menu = nullptr;
    for (const QPushButton *button : bench.page->findChildren<QPushButton *>())
        menu = button->menu() ? button->menu() : menu;
    QVERIFY(menu);
    Q_EMIT menu->aboutToShow();
    QVERIFY2(!menu->actions().constFirst()->isEnabled(), "no link is open");
    bench.workbench.shot.links.front().state = LinkState::Open;
    bench.page->showQueue(true);
    const auto name = [&](int number) {
        Q_EMIT menu->aboutToShow();
        QCOMPARE(menu->actions().size(), 1); // the bus leads to the units of the other family
        QCOMPARE(menu->actions().constFirst()->text(), QStringLiteral("Abstract DC on sim:can…"));
        menu->actions().constFirst()->trigger();
        auto *const dialog = bench.page->findChildren<QInputDialog *>().constLast();
        dialog->setIntValue(number);
        dialog->accept();
    };
    name(6);
    name(8);
    name(9);
    const auto ordered = bench.workbench.given<orders::FindMute>();
    QCOMPARE(ordered.size(), std::size_t(3));
    QCOMPARE(ordered[0].link, std::string("sim:can"));
    QCOMPARE(ordered[0].family, std::string("abstractdc"));
    QCOMPARE(ordered[0].address, 6);
    ordered[0].finished(DeviceId{2});
    QVERIFY(bench.selection.device() == DeviceId{2});
    QVERIFY2(!bench.page->isQueueShown(), "it is written by itself");
    ordered[1].finished(fail(Fault::Timeout, say("nothing")));
    QVERIFY(bench.workbench.lines.back().text.contains(QStringLiteral("nothing")));
    const std::size_t told = bench.workbench.lines.size();
    ordered[2].finished(fail(Fault::Cancelled));
    QCOMPARE(bench.workbench.lines.size(), told);
    QVERIFY(bench.selection.device() == DeviceId{2});
}

MB_WINDOW_TEST(FirmwareTest);
#include "tst_firmware.moc"
