// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of experiments: entered once for a unit, kept for the next time, under names too.
#include "support/windowtests.h"
#include "trialbench.h"
#include "widgets/control/envelopebook.h"
#include "widgets/control/envelopepanel.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <algorithm>

using namespace mb;
using namespace mb::test;

class TestEnvelopes : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatWasEnteredIsThereAtTheNextStart();
    void namedLimitsAreChosenAgain();
    void limitsGoAlongWhenAUnitTellsItsSerialNumber();
    void anotherFileIsSaidAndLeftAlone();
    void eachUnitHasItsOwn();
};

namespace {

void enter(TrialBench &bench, const char *field, const char *text)
{
    auto *edit = bench.find<QLineEdit>(field);
    edit->setText(s(text));
    Q_EMIT edit->textEdited(edit->text());
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

void TestEnvelopes::limitsGoAlongWhenAUnitTellsItsSerialNumber()
{
    const ThemeSource theme(lightTheme());
    EnvelopePanel panel(theme);
    const auto fields = panel.findChildren<QLineEdit *>();
    const auto current = std::find_if(fields.begin(), fields.end(),
        [](const QLineEdit *field) { return field->accessibleName() == s("Envelope: Current"); });
    QVERIFY(current != fields.end());
    QSignalSpy changes(&panel, &EnvelopePanel::changed);
    panel.choose("this place", false);
    QTest::keyClicks(*current, s("12"));
    panel.choose("serial 1", true);
    QCOMPARE(panel.entered().current, std::optional(12.0));
    changes.clear();
    panel.choose("another unit", false);
    QVERIFY(!panel.entered().current);
    QCOMPARE(changes.size(), 1); // what bounds the next experiment is another
    QVERIFY((*current)->text().isEmpty());
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
    QVERIFY(book.enter("unit", {1.0, {}, {}, {}}).has_value()); // for as long as the program runs
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("{\"recipe\":1}"));
}

void TestEnvelopes::eachUnitHasItsOwn()
{
    EnvelopeBook book;
    QVERIFY(book.enter("a", {100.0, {}, {}, {}}));
    QVERIFY(book.keep("a", s(" far "), {500.0, {}, {}, {}}));
    QVERIFY(!book.entered("b").travel);
    QVERIFY(book.names("b").isEmpty());
    QCOMPARE(book.names("a"), QStringList{s("far")});
    QCOMPARE(book.named("a", s("far")).travel, std::optional(500.0));
}

MB_WINDOW_TEST(TestEnvelopes);
#include "tst_envelopes.moc"
