// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of experiments: entered once for a unit, kept for the next time, under names too.
#include "designbench.h"
#include "support/windowtests.h"
#include "trialbench.h"
#include "widgets/control/envelopebook.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/experimentplan.h"

#include <QFile>
#include <QLabel>
#include <QLockFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace mb;
using namespace mb::test;

class TestEnvelopes : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatWasEnteredIsThereAtTheNextStart();
    void twoWindowsKeepWhatEachHasEntered();
    void whoTypesALimitWaitsForNoDisk();
    void limitsThatCannotBeKeptAreTold();
    void namedLimitsAreChosenAgain();
    void limitsGoAlongWhenAUnitTellsItsSerialNumber();
    void thoseOfStagedGainsBoundTheExperimentThatWritesThem();
    void whatWasEnteredForNobodyIsNotOfTheNextUnit();
    void anotherFileIsSaidAndLeftAlone();
    void eachUnitHasItsOwn();
    void theLimitsOfOneMotorAreNotThoseOfTheNext();
    void whatIsNoLimitIsNotTakenAndNothingRuns_data();
    void whatIsNoLimitIsNotTakenAndNothingRuns();
    void nothingIsTunedWithALimitThatIsNone();
    void whatIsNoLimitInAFileIsNotTaken();
    void whatIsTypedForOneUnitIsNotOfAnother();
    void fieldsStayWhereTheyAreWhileTheLineBelowChanges();
};

namespace {

void typeLimit(QLineEdit *edit, const QString &text)
{
    edit->setText(text);
    Q_EMIT edit->textEdited(edit->text());
}

void enter(TrialBench &bench, const char *field, const char *text)
{
    typeLimit(bench.find<QLineEdit>(field), s(text));
}

QLineEdit *limitField(const QWidget &place, const char *name)
{
    const auto fields = place.findChildren<QLineEdit *>();
    const auto found = std::find_if(
        fields.begin(), fields.end(), [name](const QLineEdit *field) { return field->accessibleName() == s(name); });
    return found == fields.end() ? nullptr : *found;
}

} // namespace

void TestEnvelopes::whatWasEnteredIsThereAtTheNextStart()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(s("deeper/limits.json"));
    {
        TrialBench bench;
        QVERIFY(bench.page->column().envelope().book().open(file));
        enter(bench, "Envelope: Speed", "70000");
        enter(bench, "Envelope: Duty", "40"); // %
    }
    EnvelopeBook again;
    QVERIFY(again.open(file));
    const Envelope read = again.entered(TrialBench().unit());
    QCOMPARE(read.speed, std::optional(70'000.0));
    QCOMPARE(read.duty, std::optional(0.4));
    QVERIFY(!read.travel && !read.current);
}

void TestEnvelopes::twoWindowsKeepWhatEachHasEntered()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(s("limits.json"));
    EnvelopeBook one;
    EnvelopeBook other;
    QVERIFY(one.open(file) && other.open(file));
    one.enter("x", {500.0, {}, {}, {}});
    one.keep("x", s("narrow"), {100.0, {}, {}, {}});
    other.enter("y", {{}, 70'000.0, {}, {}});
    one.forget("x", s("narrow"));
    one.finish();
    other.finish();
    EnvelopeBook again;
    QVERIFY(again.open(file));
    QCOMPARE(again.entered("x").travel, std::optional(500.0));
    QVERIFY(again.names("x").isEmpty());
    QCOMPARE(again.entered("y").speed, std::optional(70'000.0));
}

void TestEnvelopes::whoTypesALimitWaitsForNoDisk()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(s("limits.json"));
    EnvelopeBook book;
    QVERIFY(book.open(file));
    {
        QLockFile another(file + s(".lock")); // a window whose disk is slow
        QVERIFY(another.tryLock());
        for (const double travel : {5.0, 50.0, 500.0})
            book.enter("x", {travel, {}, {}, {}});
        QVERIFY2(!QFile::exists(file), "the window goes on before anything is written");
        QCOMPARE(book.entered("x").travel, std::optional(500.0));
    }
    book.finish();
    EnvelopeBook again;
    QVERIFY(again.open(file));
    QCOMPARE(again.entered("x").travel, std::optional(500.0));
}

void TestEnvelopes::limitsThatCannotBeKeptAreTold()
{
    const QTemporaryDir folder;
    const QString inTheWay = folder.filePath(s("file"));
    QVERIFY(QFile(inTheWay).open(QIODevice::WriteOnly));
    EnvelopeBook book;
    QVERIFY(book.open(inTheWay + s("/limits.json")));
    QSignalSpy failed(&book, &EnvelopeBook::failed);
    book.enter("x", {500.0, {}, {}, {}});
    book.finish();
    QCOMPARE(failed.count(), 1);
}

void TestEnvelopes::namedLimitsAreChosenAgain()
{
    TrialBench bench;
    bench.page->column().envelope().setOpen(true);
    auto *names = bench.find<QComboBox>("Kept limits");
    auto *keep = bench.find<QAbstractButton>("Keep these limits under this name");
    auto *forget = bench.find<QAbstractButton>("Forget the limits of this name");
    QVERIFY(names && keep && forget && !keep->isEnabled() && !forget->isEnabled());
    enter(bench, "Envelope: Speed", "70000");
    names->setEditText(s("on the bench"));
    keep->click();
    QCOMPARE(names->count(), 1);
    QVERIFY(forget->isEnabled());
    enter(bench, "Envelope: Speed", "20000");
    QCOMPARE(bench.page->column().envelope().entered().speed, std::optional(20'000.0));
    pick(names, 0);
    QCOMPARE(bench.page->column().envelope().entered().speed, std::optional(70'000.0));
    QCOMPARE(bench.find<QLineEdit>("Envelope: Speed")->text(), s("70000"));
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run(); // and they bound the next experiment
    QCOMPARE(bench.workbench.given<orders::RunTrial>().back().plan.limits.speed, std::optional(70'000.0));
    bench.finish(0.7);
    forget->click();
    QCOMPARE(names->count(), 0);
    QCOMPARE(bench.page->column().envelope().entered().speed, std::optional(70'000.0)); // what holds goes on holding
}

void TestEnvelopes::thoseOfStagedGainsBoundTheExperimentThatWritesThem()
{
    TrialBench bench;
    ExperimentWish wish;
    wish.stimulus.from = 800.0;
    wish.stimulus.to = 1000.0;
    wish.stimulus.seconds = 0.1;
    wish.gains = {{named("slot0.max_forward"), 6553}};
    const ExperimentCheck check = checkExperiment(bench.workbench.device(0), wish, {}, {});
    QVERIFY2(check.good, qPrintable(check.words));
    QVERIFY(std::abs(check.inForce.duty.value_or(1.0) - 0.2) < 1e-3);
    QVERIFY2(check.words.contains(s("at most 3.7 s")), qPrintable(check.words)); // on its way to 800 counts/s, too
}

void TestEnvelopes::limitsGoAlongWhenAUnitTellsItsSerialNumber()
{
    const ThemeSource theme(lightTheme());
    EnvelopePanel panel(theme);
    QLineEdit *const current = limitField(panel, "Envelope: Current");
    QVERIFY(current);
    QSignalSpy changes(&panel, &EnvelopePanel::changed);
    panel.choose("this place", false);
    QTest::keyClicks(current, s("12"));
    panel.choose("serial 1", true);
    QCOMPARE(panel.entered().current, std::optional(12.0));
    changes.clear();
    panel.choose("another unit", false);
    QVERIFY(!panel.entered().current);
    QCOMPARE(changes.size(), 1); // what bounds the next experiment is another
    QVERIFY(current->text().isEmpty());
}

void TestEnvelopes::whatWasEnteredForNobodyIsNotOfTheNextUnit()
{
    const ThemeSource theme(lightTheme());
    EnvelopePanel panel(theme);
    panel.choose("", false);
    QTest::keyClicks(limitField(panel, "Envelope: Current"), s("12"));
    panel.choose("", true); // it has not told yet
    QCOMPARE(panel.entered().current, std::optional(12.0));
    panel.choose("", false);
    QVERIFY(!panel.entered().current);
    panel.choose("another unit", true);
    QVERIFY(panel.book().entered("another unit") == Envelope());
}

void TestEnvelopes::anotherFileIsSaidAndLeftAlone()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(s("limits.json"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{\"recipe\":1}");
    file.close();
    EnvelopeBook book;
    const auto opened = book.open(path);
    QVERIFY(!opened);
    QVERIFY(opened.error().fault == Fault::OutOfRange);
    book.enter("unit", {1.0, {}, {}, {}}); // for as long as the program runs
    book.finish();
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("{\"recipe\":1}"));
}

void TestEnvelopes::eachUnitHasItsOwn()
{
    EnvelopeBook book;
    book.enter("a", {100.0, {}, {}, {}});
    book.keep("a", s(" far "), {500.0, {}, {}, {}});
    QVERIFY(!book.entered("b").travel);
    QVERIFY(book.names("b").isEmpty());
    QCOMPARE(book.names("a"), QStringList{s("far")});
    QCOMPARE(book.named("a", s("far")).travel, std::optional(500.0));
}

void TestEnvelopes::theLimitsOfOneMotorAreNotThoseOfTheNext()
{
    TrialBench bench;
    bench.workbench.shot.devices.push_back(tunableDrive(bench.recording.telemetry(), 2, 7));
    bench.workbench.publish();
    EnvelopePanel &panel = bench.page->column().envelope();
    enter(bench, "Envelope: Current", "20");
    bench.selection.select({2});
    bench.workbench.publish();
    QVERIFY(!panel.entered().current);
    QVERIFY(bench.find<QLineEdit>("Envelope: Current")->text().isEmpty());
    QVERIFY(panel.book().entered(bench.workbench.device(1).unit) == Envelope());
    bench.selection.select({1});
    QCOMPARE(panel.entered().current, std::optional(20.0));
}

void TestEnvelopes::whatIsNoLimitIsNotTakenAndNothingRuns_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("typed");
    QTest::newRow("a thousand times all of the duty") << s("Envelope: Duty") << s("100000");
    QTest::newRow("more than all of the duty") << s("Envelope: Duty") << s("100.1");
    QTest::newRow("a duty that cannot be read") << s("Envelope: Duty") << s("1e999");
    QTest::newRow("a travel that cannot be read") << s("Envelope: Travel ±") << s("1e999");
    QTest::newRow("a travel without an end") << s("Envelope: Travel ±") << s("1e13");
    QTest::newRow("a current that melts copper") << s("Envelope: Current") << s("10001");
    QTest::newRow("nothing at all") << s("Envelope: Speed") << s("0");
    QTest::newRow("two signs") << s("Envelope: Speed") << s("70000,0,");
}

void TestEnvelopes::whatIsNoLimitIsNotTakenAndNothingRuns()
{
    QFETCH(const QString, name);
    QFETCH(const QString, typed);
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    EnvelopePanel &panel = bench.page->column().envelope();
    panel.setOpen(true);
    auto *field = bench.find<QLineEdit>(name.toUtf8().constData());
    QVERIFY(field);
    for (int length = 1; length <= typed.size(); ++length) // "1" and "1e9" of "1e999" are numbers
        typeLimit(field, typed.left(length));
    QCOMPARE(field->property("state").toString(), s("error"));
    QVERIFY(panel.entered() == Envelope());
    QVERIFY(panel.book().entered(bench.unit()) == Envelope());
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    bench.page->run();
    QVERIFY(bench.workbench.given<orders::RunTrial>().empty());
    const QString words = bench.page->status().remedy;
    QVERIFY2(words.contains(typed) && words.contains(s("is no limit")), qPrintable(words));
    const auto lines = panel.findChildren<QLabel *>();
    QVERIFY(std::any_of(lines.begin(), lines.end(), [&words](const QLabel *line) { return line->text() == words; }));
    typeLimit(field, {});
    bench.page->run();
    QCOMPARE(bench.workbench.given<orders::RunTrial>().size(), 1U);
}

void TestEnvelopes::nothingIsTunedWithALimitThatIsNone()
{
    DesignBench bench;
    bench.arm();
    QLineEdit *const duty = limitField(*bench.page, "Envelope: Duty");
    QVERIFY(duty);
    typeLimit(duty, s("100000"));
    bench.page->identify();
    bench.page->autotune();
    QVERIFY(bench.workbench.given<orders::RunTuning>().empty());
    QVERIFY2(bench.page->status().remedy.contains(s("is no limit")), qPrintable(bench.page->status().remedy));
    typeLimit(duty, s("50"));
    bench.page->identify();
    QCOMPARE(bench.workbench.given<orders::RunTuning>().size(), 1U);
    QCOMPARE(bench.workbench.given<orders::RunTuning>().back().plan.limits.duty, std::optional(0.5));
}

void TestEnvelopes::whatIsNoLimitInAFileIsNotTaken()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(s("limits.json"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        R"({"motorbench":"experiment limits","units":{"a":{"entered":)"
        R"({"travel":1e99,"speed":1000,"current":-1,"duty":9.99e96},"named":{"far":{"travel":500,"duty":2}}}}})");
    file.close();
    EnvelopeBook book;
    QVERIFY(book.open(path));
    QVERIFY(book.entered("a") == (Envelope{{}, 1000.0, {}, {}}));
    QVERIFY(book.named("a", s("far")) == (Envelope{500.0, {}, {}, {}}));
}

void TestEnvelopes::whatIsTypedForOneUnitIsNotOfAnother()
{
    const ThemeSource theme(lightTheme());
    EnvelopePanel panel(theme);
    panel.setOpen(true);
    panel.show();
    QApplication::setActiveWindow(&panel);
    QLineEdit *const current = limitField(panel, "Envelope: Current");
    QVERIFY(current);
    panel.choose("one", false);
    current->setFocus();
    QVERIFY(current->hasFocus());
    QTest::keyClicks(current, s("1e999"));
    QVERIFY(!panel.fault().isEmpty());
    panel.choose("another", false);
    QVERIFY(current->text().isEmpty());
    QVERIFY(panel.fault().isEmpty());
}

void TestEnvelopes::fieldsStayWhereTheyAreWhileTheLineBelowChanges()
{
    const ThemeSource theme(lightTheme());
    QWidget page;
    page.resize(380, 600);
    auto *column = new QVBoxLayout(&page);
    auto *panel = new EnvelopePanel(theme, &page);
    auto *below = new QLineEdit(&page);
    column->addWidget(panel);
    column->addWidget(below);
    column->addStretch(1);
    panel->setOpen(true);
    page.show();
    QLineEdit *const travel = limitField(*panel, "Envelope: Travel ±");
    const auto placesOf = [&] {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        return QStringLiteral("%1 %2").arg(travel->mapTo(&page, QPoint()).y()).arg(below->mapTo(&page, QPoint()).y());
    };
    const QString before = placesOf();
    panel->setInForce({}, s("Nothing bounds the motor: enter travel, duty, and what else is empty here."));
    QCOMPARE(placesOf(), before);
    typeLimit(travel, s("1e999"));
    QCOMPARE(placesOf(), before);
    typeLimit(travel, s("1000"));
    panel->setInForce({1000.0, 1000.0, 10.0, 0.5}, {});
    QCOMPARE(placesOf(), before);
}

MB_WINDOW_TEST(TestEnvelopes);
#include "tst_envelopes.moc"
