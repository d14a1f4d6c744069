// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of the Tune page: each that F1 lists does what it says, and letters belong to who is written in.
#include "support/timers.h"
#include "support/windowtests.h"
#include "trialbench.h"
#include "widgets/common/pagekeys.h"
#include "widgets/control/batterydialog.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/jogpanel.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/tuneplot.h"

#include <QDialog>
#include <QFileDialog>
#include <QLabel>
#include <QSlider>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>
#include <array>

using namespace mb;
using namespace mb::test;
using namespace std::chrono_literals;

namespace {

/// Two trials were run, the page has the focus.
struct KeyBench : TrialBench {
    KeyBench()
    {
        choose(60'000.0);
        arm();
        for (const double damping : {0.5, 0.7}) {
            page->run();
            finish(damping);
        }
        page->setFocus();
    }
    [[nodiscard]] const PageKeys &keys() const { return *page->findChild<PageKeys *>(); }
    void press(const QKeySequence &key)
    {
        const int code = key[0];
        QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : page.get(),
            static_cast<Qt::Key>(code & ~static_cast<int>(Qt::KeyboardModifierMask)),
            Qt::KeyboardModifiers(code & static_cast<int>(Qt::KeyboardModifierMask)));
    }
    [[nodiscard]] PlotStack &stack() { return page->trials().plot().stack(); }
    [[nodiscard]] QLineEdit *gain() { return find<QLineEdit>("P"); }
    void editGain()
    {
        type(gain(), "1.5");
        QTest::keyClick(gain(), Qt::Key_Return);
        page->setFocus();
    }
    [[nodiscard]] std::size_t staged() { return page->column().gainsPanel().toWrite().size(); }
};

void turn(QWidget *over, int eighths)
{
    const QPointF at = over->rect().center();
    QWheelEvent event(
        at, over->mapToGlobal(at.toPoint()), {}, {0, eighths}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(over, &event);
}

bool madeAgain(KeyBench &b, const QKeySequence &k)
{
    b.editGain();
    b.page->gains().undo(false);
    b.press(k);
    return b.staged() == 1;
}

bool ran(KeyBench &b, const QKeySequence &k, int repeats)
{
    b.press(k);
    return b.workbench.given<orders::RunTrial>().size() == 3
        && b.workbench.given<orders::RunTrial>().back().plan.repeat == repeats;
}

/// What a key is seen to do.
struct Check {
    const char *key;
    bool (*isDone)(KeyBench &, const QKeySequence &);
};

const std::array checks{
    Check{"F5", [](KeyBench &b, const QKeySequence &k) { return ran(b, k, 1); }},
    Check{"Shift+F5", [](KeyBench &b, const QKeySequence &k) { return ran(b, k, 4); }},
    Check{"F7",
        [](KeyBench &b, const QKeySequence &k) {
            b.press(k);
            const auto *const battery = b.page->findChild<BatteryDialog *>();
            return battery && battery->isVisible() && b.workbench.given<orders::RunTrial>().size() == 2;
        }},
    Check{"G",
        [](KeyBench &b, const QKeySequence &k) {
            b.press(k);
            return b.gain()->hasFocus();
        }},
    Check{"S",
        [](KeyBench &b, const QKeySequence &k) {
            b.press(k);
            const ModePanel &modes = b.page->column().modePanel();
            return modes.runningSlot() == 1 && modes.editedSlot() == 1 && !b.arming.isArmed({1});
        }},
    Check{"B",
        [](KeyBench &b, const QKeySequence &k) {
            b.press(k);
            return b.page->trials().a()->number == 2 && b.page->trials().b()->number == 1;
        }},
    Check{"A",
        [](KeyBench &b, const QKeySequence &k) {
            b.press(k);
            return b.page->trials().a()->number == 2 && b.page->trials().b()->number == 2;
        }},
    Check{"L",
        [](KeyBench &b, const QKeySequence &k) {
            b.press(k);
            const bool shown = b.stack().cursorsShown() && b.stack().hasFocus();
            const double before = b.stack().cursorKeys().second;
            QTest::keyClick(&b.stack(), Qt::Key_Right);
            return shown && b.stack().cursorKeys().second > before;
        }},
    Check{"0",
        [](KeyBench &b, const QKeySequence &k) {
            b.stack().view().setRange(0.3, 0.4);
            b.press(k);
            return b.stack().view().range().second > 1.0;
        }},
    Check{"P",
        [](KeyBench &b, const QKeySequence &k) {
            b.page->showLive(true);
            b.press(k);
            return !b.page->plot().stack().view().isLive();
        }},
    Check{"I",
        [](KeyBench &b, const QKeySequence &k) {
            b.press(k);
            return b.workbench.given<orders::Identify>().size() == 1;
        }},
    Check{"Ctrl+P",
        [](KeyBench &b, const QKeySequence &k) {
            b.press(k);
            auto *const dialog = b.page->findChild<QFileDialog *>();
            if (!dialog || dialog->acceptMode() != QFileDialog::AcceptSave)
                return false;
            Q_EMIT dialog->fileSelected(s("/nonexistent/a.html"));
            const ReportWish wish = b.workbench.book.wishes.back();
            return wish.trials == std::vector<std::int64_t>{1, 2};
        }},
    Check{"Ctrl+Z",
        [](KeyBench &b, const QKeySequence &k) {
            b.editGain();
            const bool edited = b.staged() == 1;
            b.press(k);
            return edited && b.staged() == 0;
        }},
    Check{"Ctrl+Y", madeAgain},
    Check{"Ctrl+Shift+Z", madeAgain},
};

} // namespace

class TestTuneKeys : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyListedKeyDoesWhatItSays();
    void lettersBelongToEditorsTreesAndComboBoxes();
    void whatCannotBlinkIsNotTurnedInstead();
    void theListHasEveryRowInWords();
    void aClickNudgesForATenthOfASecond();
    void aButtonHeldDownMovesUntilItIsLetGo();
    void theWheelChangesAFocusedGainByTwoPercent();
    void theCursorsCanBeDraggedAndSayTimeAndValue();
};

void TestTuneKeys::everyListedKeyDoesWhatItSays()
{
    const auto rows = KeyBench().keys().rows().size();
    QVERIFY(rows > 10);
    for (std::size_t row = 0; row < rows; ++row) {
        const auto count = KeyBench().keys().rows()[row].shortcuts.size();
        for (std::size_t i = 0; i < count; ++i) {
            KeyBench bench;
            const QKeySequence key = bench.keys().rows()[row].keys[i];
            const auto *const check = std::find_if(
                checks.begin(), checks.end(), [&](const Check &c) { return key.toString() == s(c.key); });
            QVERIFY2(check != checks.end(), qPrintable(s("no test of ") + key.toString()));
            QVERIFY2(check->isDone(bench, key), qPrintable(key.toString() + s(": ") + bench.keys().rows()[row].does));
        }
    }
}

void TestTuneKeys::lettersBelongToEditorsTreesAndComboBoxes()
{
    KeyBench bench;
    for (QWidget *editor :
        {static_cast<QWidget *>(bench.gain()), static_cast<QWidget *>(bench.find<QComboBox>("Stimulus"))}) {
        editor->setFocus();
        QVERIFY(editor->hasFocus());
        QTest::keyClick(editor, Qt::Key_B);
        QTest::keyClick(editor, Qt::Key_S);
        QCOMPARE(bench.page->trials().b()->number, 2);
        QCOMPARE(bench.page->column().modePanel().runningSlot(), 0);
    }
    bench.page->setFocus();
    QTest::keyClick(bench.page.get(), Qt::Key_B);
    QCOMPARE(bench.page->trials().b()->number, 1);
}

void TestTuneKeys::whatCannotBlinkIsNotTurnedInstead()
{
    static Family lampless = dmc60c();
    lampless.capabilities.identify = false;
    KeyBench bench;
    bench.device().family = &lampless;
    bench.workbench.publish();
    bench.page->setFocus();
    QTest::keyClick(bench.page.get(), Qt::Key_I);
    QVERIFY(bench.workbench.given<orders::Identify>().empty());
}

void TestTuneKeys::theListHasEveryRowInWords()
{
    KeyBench bench;
    showKeys(*bench.page, s("Tune"), {&bench.keys()});
    auto *dialog = bench.page->findChild<QDialog *>(s("keys"));
    QVERIFY(dialog && dialog->isVisible());
    QStringList texts;
    for (const auto *label : dialog->findChildren<QLabel *>())
        texts << label->text();
    for (const PageKeys::Row &row : bench.keys().rows()) {
        QVERIFY2(texts.contains(row.does), qPrintable(row.does));
        QVERIFY2(texts.contains(PageKeys::textOf(row)), qPrintable(PageKeys::textOf(row)));
    }
    dialog->close();
}

void TestTuneKeys::aClickNudgesForATenthOfASecond()
{
    TrialBench bench;
    bench.page->showLive(true);
    auto *nudge = bench.find<QAbstractButton>("Nudge forwards");
    QVERIFY(nudge && !nudge->isEnabled()); // not armed
    bench.arm();
    QVERIFY(nudge->isEnabled());
    bool isEarly = false; // timers come in the order in which they are due
    QTimer before;
    before.setTimerType(Qt::PreciseTimer);
    before.callOnTimeout([&] { isEarly = !bench.workbench.given<orders::StopMotion>().empty(); });
    before.setSingleShot(true);
    before.start(95ms);
    QTest::mouseClick(nudge, Qt::LeftButton);
    QCOMPARE(bench.workbench.given<orders::StartMotion>().size(), 1U);
    QCOMPARE(bench.workbench.given<orders::StartMotion>().back().setPoint.target, 0.08);
    QVERIFY(bench.workbench.given<orders::StopMotion>().empty());
    QTRY_COMPARE(bench.workbench.given<orders::StopMotion>().size(), 1U);
    QVERIFY(!before.isActive() && !isEarly);
    QVERIFY(bench.arming.isArmed({1}) && !bench.arming.isMoving());
}

void TestTuneKeys::aButtonHeldDownMovesUntilItIsLetGo()
{
    TrialBench bench;
    bench.page->showLive(true);
    bench.arm();
    auto *nudge = bench.find<QAbstractButton>("Nudge backwards");
    QTest::mousePress(nudge, Qt::LeftButton);
    bench.workbench.publish();
    QVERIFY(nudge->isEnabled()); // it must hear that it is let go
    passTimers(150ms);           // longer than a click nudges
    QVERIFY(bench.workbench.given<orders::StopMotion>().empty());
    QTest::mouseRelease(nudge, Qt::LeftButton);
    QCOMPARE(bench.workbench.given<orders::StopMotion>().size(), 1U); // at once
    QTest::mousePress(nudge, Qt::LeftButton);
    bench.page->hide(); // nobody sees it any more
    QCOMPARE(bench.workbench.given<orders::StopMotion>().size(), 2U);
}

void TestTuneKeys::theWheelChangesAFocusedGainByTwoPercent()
{
    TrialBench bench;
    auto *field = bench.find<QLineEdit>("P");
    auto *slider = bench.find<QSlider>("P, one decade either way");
    QVERIFY(field && slider);
    const QString before = field->text();
    for (QWidget *part : {static_cast<QWidget *>(field), static_cast<QWidget *>(slider)}) {
        bench.page->setFocus();
        turn(part, 120); // it only passes
        QCOMPARE(field->text(), before);
    }
    QTest::mouseClick(field, Qt::LeftButton); // focuses, changes nothing
    QVERIFY(field->hasFocus());
    QCOMPARE(field->text(), before);
    QVERIFY(bench.page->column().gainsPanel().toWrite().empty());
    turn(field, 120);
    QCOMPARE(field->text().toDouble(), 1.165 * 1.02);
    turn(field, -60); // half a step of a fine wheel
    turn(field, -60);
    QVERIFY(std::abs(field->text().toDouble() - 1.165) < 1e-4);
    slider->setFocus();
    turn(slider, 120);
    QVERIFY(std::abs(field->text().toDouble() - 1.165 * 1.02) < 1e-4);
}

void TestTuneKeys::theCursorsCanBeDraggedAndSayTimeAndValue()
{
    KeyBench bench;
    PlotStack &stack = bench.stack();
    stack.setCursorsShown(true);
    stack.setCursorKeys(0.2, 0.6);
    stack.refresh(0.0);
    QCPAxis &keys = *stack.plot().axisRect(0)->axis(QCPAxis::atBottom);
    const auto at
        = [&](double key) { return QPoint(qRound(keys.coordToPixel(key)), stack.plot().axisRect(0)->center().y()); };
    QTest::mousePress(&stack.plot(), Qt::LeftButton, {}, at(0.6));
    QMouseEvent move(QEvent::MouseMove, at(0.8), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&stack.plot(), &move);
    QTest::mouseRelease(&stack.plot(), Qt::LeftButton, {}, at(0.8));
    QVERIFY2(std::abs(stack.cursorKeys().second - 0.8) < 0.01, qPrintable(QString::number(stack.cursorKeys().second)));
    stack.refresh(0.0);
    const QStringList said = stack.readings().cursorWords();
    QVERIFY2(said.size() >= 4, qPrintable(said.join(s(" | "))));
    QVERIFY2(said[0].contains(s("200")) && said[0].contains(s("→")), qPrintable(said[0]));
    QVERIFY2(said.filter(s("B #2")).size() == 1 && said.filter(s("B #2")).first().contains(s("→")),
        qPrintable(said.join(s(" | "))));
}

MB_WINDOW_TEST(TestTuneKeys);
#include "tst_tunekeys.moc"
