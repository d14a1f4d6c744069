// SPDX-License-Identifier: GPL-3.0-or-later
// The page as a user works with it: keys, fields, write, files, states.
#include "parameterbench.h"

#include "model/parameterfile.h"
#include "support/windowtests.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/banner.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/stateglyph.h"
#include "widgets/parameters/changespanel.h"
#include "widgets/parameters/columnwidths.h"
#include "widgets/parameters/parameterfilter.h"
#include "widgets/parameters/parameterview.h"
#include "widgets/parameters/readstatus.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QTemporaryDir>
#include <QTest>

using namespace mb;
using namespace mb::test;

class TestParametersPage : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatNobodyCanReadIsNotDoneAndHasAShape();
    void initTestCase();
    void enterOpensTypesAndCommits();
    void aDigitStartsEditing();
    void f2IsTheTablesWhereItHasTheFocus();
    void escapeKeepsTheOldValue();
    void tabGoesToTheNextField();
    void enterSwitchesWhatIsOnOrOff();
    void aDragThatSelectsRowsSwitchesNothing();
    void aFaultAppearsWhileTypingAndIsMendedByOneClick();
    void aSnapshotWhileTypingLosesNothing();
    void anotherSelectionKeepsTheEdits();
    void aVanishedDeviceKeepsTheEdits();
    void copyGivesKeyAndValue();
    void everyControlHasAName();
    void nothingIsCutAtTwiceTheFont();
    void namesGetTheRoomThatNoStateNeeds();
    void keysAndNamesAreWholeBeforeRawNumbersAreShown();
    void noKeyGoesWhileColumnsHaveRoomToGive();
    void onAWideScreenAValueStandsBesideItsName();
    void namesThatBeginAlikeDifferWhereTheyAreCut();
    void namesAreWholeWhileNothingIsStaged();
    void longWordsBesideTheTableTakeNoColumnFromIt();
};

void TestParametersPage::namesGetTheRoomThatNoStateNeeds()
{
    ParameterBench bench;
    bench.page->resize(1048, 640); // of 1280 beside the devices
    QCoreApplication::processEvents();
    ParameterView &view = bench.page->view();
    const auto textWidth = [&](ParameterModel::Column column, const QString &text) {
        QFont font = view.font();
        if (column == ParameterModel::State)
            font = bench.theme.theme().font(TextRole::Caption, font);
        return QFontMetrics(font).horizontalAdvance(text);
    };
    const int state = view.columnWidth(ParameterModel::State);
    QVERIFY(state < textWidth(ParameterModel::State, QStringLiteral("edited, was −32768")) + 44);
    QVERIFY(state > textWidth(ParameterModel::State, QStringLiteral("stored")) + 18);
    QVERIFY(view.columnWidth(ParameterModel::Label) + view.columnWidth(ParameterModel::Key) > 320);
    bench.page->resize(2400, 640);
    QCoreApplication::processEvents();
    QVERIFY(view.columnWidth(ParameterModel::State)
        > textWidth(ParameterModel::State, QStringLiteral("edited, was −32768")) + 18);
}

void TestParametersPage::keysAndNamesAreWholeBeforeRawNumbersAreShown()
{
    ParameterBench bench;
    const ParameterView &view = bench.page->view();
    const QFontMetrics raw(bench.theme.theme().font(TextRole::Raw, view.font()));
    const int longest = raw.horizontalAdvance(QStringLiteral("limit.forward.switch.normally_closed"));
    bool shown = false;
    for (int width = 1048; width < 1700; width += 20) {
        bench.page->resize(width, 640);
        QCoreApplication::processEvents();
        if (view.columnWidth(ParameterModel::Raw) == 0)
            continue;
        shown = true;
        QVERIFY2(view.columnWidth(ParameterModel::Key) >= longest + 16,
            qPrintable(QStringLiteral("%1 at %2").arg(view.columnWidth(ParameterModel::Key)).arg(width)));
        const int name = QFontMetrics(bench.theme.theme().font(TextRole::Body, view.font()))
                             .horizontalAdvance(QStringLiteral("Forward switch is normally closed"));
        QVERIFY2(view.columnWidth(ParameterModel::Label) >= name + 34 + 8,
            qPrintable(QStringLiteral("%1 at %2").arg(view.columnWidth(ParameterModel::Label)).arg(width)));
    }
    QVERIFY(shown);
}

/// Units, numbers and names have less room before keys have none.
void TestParametersPage::noKeyGoesWhileColumnsHaveRoomToGive()
{
    ParameterBench bench;
    const ParameterDelegate delegate(bench.theme, bench.model(), nullptr);
    const Theme &theme = bench.theme.theme();
    for (int room = 420; room < 1200; room += 10) {
        const ColumnWidths widths = columnWidthsFor(bench.model(), delegate, theme, bench.page->font(), room);
        if (widths[ParameterModel::Key] > 0)
            continue;
        QVERIFY2(widths[ParameterModel::Unit] + widths[ParameterModel::Label] < theme.u(44 + 110 + 110),
            qPrintable(QStringLiteral("%1 and %2 of %3")
                           .arg(widths[ParameterModel::Unit])
                           .arg(widths[ParameterModel::Label])
                           .arg(room)));
    }
}

void TestParametersPage::onAWideScreenAValueStandsBesideItsName()
{
    ParameterBench bench;
    bench.page->resize(3400, 640);
    QCoreApplication::processEvents();
    ParameterView &view = bench.page->view();
    QVERIFY2(view.columnViewportPosition(ParameterModel::Reference) < 1000,
        qPrintable(QString::number(view.columnViewportPosition(ParameterModel::Reference))));
    const QFontMetricsF plain(bench.theme.theme().font(TextRole::Body, view.font()));
    for (std::uint16_t i = 0; i < bench.model().family()->parameters.size(); ++i) {
        const QString text = bench.model().indexOf({i}, ParameterModel::Reference).data().toString();
        const int room = view.columnWidth(ParameterModel::Reference) - 2 * bench.theme.theme().u(8);
        QVERIFY2(room >= plain.horizontalAdvance(text), qPrintable(QStringLiteral("%1 in %2").arg(text).arg(room)));
    }
    ParameterReference other{QStringLiteral("long"), {}};
    other.raws.resize(bench.model().family()->parameters.size());
    other.raws[named("slot1.i_zone").value] = 2'000'000'000;
    bench.model().setReference(other);
    const QString text = bench.model().indexOf(named("slot1.i_zone"), ParameterModel::Reference).data().toString();
    const QFontMetrics metrics(bench.theme.theme().font(TextRole::Body, view.font()));
    const QString found = QStringLiteral("%1: %2, %3")
                              .arg(text)
                              .arg(view.columnWidth(ParameterModel::Reference))
                              .arg(metrics.horizontalAdvance(text));
    QVERIFY2(view.columnWidth(ParameterModel::Reference) >= metrics.horizontalAdvance(text),
        qPrintable(found)); // a number that is cut says nothing
}

void TestParametersPage::namesThatBeginAlikeDifferWhereTheyAreCut()
{
    ParameterBench bench;
    bench.page->resize(395, 400);
    QCoreApplication::processEvents();
    ParameterView &view = bench.page->view();
    const auto picture = [&](const char *key) {
        const QModelIndex index = bench.model().indexOf(named(key), ParameterModel::Label);
        view.goTo(named("slot1.d"));
        view.scrollTo(index, QAbstractItemView::PositionAtCenter);
        QCoreApplication::processEvents();
        return view.viewport()->grab(view.visualRect(index)).toImage();
    };
    QVERIFY(picture("limit.forward.switch.normally_closed") != picture("limit.forward.switch.disabled"));
}

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

void TestParametersPage::f2IsTheTablesWhereItHasTheFocus()
{
    ParameterBench bench;
    QKeyEvent announced(QEvent::ShortcutOverride, Qt::Key_F2, Qt::NoModifier);
    announced.ignore();
    QApplication::sendEvent(&bench.page->view(), &announced);
    QVERIFY(announced.isAccepted()); // no shortcut of the window takes it
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

void TestParametersPage::aDragThatSelectsRowsSwitchesNothing()
{
    ParameterBench bench;
    ParameterView &view = bench.view();
    view.goTo(named("current_limit.enabled"));
    const auto at = [&](const char *key, int column) {
        return view.visualRect(bench.model().indexOf(named(key), column)).center();
    };
    const QPoint end = at("current_limit.enabled", ParameterModel::ValueColumn);
    QTest::mousePress(view.viewport(), Qt::LeftButton, Qt::NoModifier, at("current_limit.peak", ParameterModel::Label));
    QMouseEvent move(QEvent::MouseMove, end, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(view.viewport(), &move);
    QTest::mouseRelease(view.viewport(), Qt::LeftButton, Qt::NoModifier, end);
    QVERIFY(view.selectionModel()->selectedRows().size() > 1);
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
    QCoreApplication::processEvents(); // the line is laid out
    QTest::mouseClick(button(bench, QStringLiteral("Use 32767")), Qt::LeftButton);
    QCOMPARE(bench.edits().toWrite().front().raw, 32767);
    QTRY_VERIFY(!button(bench, QStringLiteral("Use 32767")));
    QTRY_VERIFY(!field(bench));
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
    QCOMPARE(bench.shown("slot1.p", ParameterModel::State), QStringLiteral("edited, was 7.000"));
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
    QCOMPARE(bench.shown("slot1.p", ParameterModel::ValueColumn), QStringLiteral("9.000"));
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

void TestParametersPage::copyGivesKeyAndValue()
{
    ParameterBench bench;
    bench.stage("slot1.p", "1.5");
    bench.view().setFocus();
    bench.view().goTo(named("slot1.p"));
    QTest::keyClick(&bench.view(), Qt::Key_Down, Qt::ShiftModifier);
    QTest::keyClick(&bench.view(), Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("slot1.p=1.5\nslot1.i=0"));
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German)); // what is copied is as in a file
    QTest::keyClick(&bench.view(), Qt::Key_C, Qt::ControlModifier);
    QLocale::setDefault(before);
    QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("slot1.p=1.5\nslot1.i=0"));
}

void TestParametersPage::everyControlHasAName()
{
    ParameterBench bench;
    bench.stage("slot1.p", "2");
    bench.stage("slot1.max_forward", "40000");
    bench.set("slot0.p", 2, ParameterState::Ram);
    for (const auto *widget : bench.page->findChildren<QWidget *>()) {
        const bool control = qobject_cast<const QAbstractButton *>(widget) || qobject_cast<const QLineEdit *>(widget)
            || qobject_cast<const QComboBox *>(widget) || qobject_cast<const QAbstractItemView *>(widget)
            || qobject_cast<const QProgressBar *>(widget);
        const bool ours = !widget->objectName().startsWith(QStringLiteral("qt_"))
            && !qobject_cast<const QComboBox *>(widget->parentWidget());
        if (control && ours && widget->isVisibleTo(bench.page.get()) && !widget->inherits("QComboBoxListView"))
            QVERIFY2(!widget->accessibleName().isEmpty(),
                qPrintable(QLatin1String(widget->metaObject()->className()) + widget->objectName()));
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
        bench.page
            = std::make_unique<ParametersPage>(bench.workbench, bench.selection, bench.theme, bench.banners, nullptr);
        bench.page->resize(1208, 760);
        bench.page->show();
        bench.stage("slot1.p", "2");
        bench.stage("slot1.max_forward", "40000");
        bench.view().goTo(named("slot1.max_forward"));
        QCoreApplication::processEvents();
        for (const auto *label : bench.page->findChildren<QWidget *>()) {
            const bool text = qobject_cast<const QAbstractButton *>(label)
                || (qobject_cast<const QLabel *>(label) && !label->inherits("mb::ElidedLabel"));
            if (!text || !label->isVisible())
                continue;
            const QByteArray name = label->property("text").toByteArray();
            const QSize least = label->minimumSizeHint();
            QVERIFY2(label->width() >= least.width() && label->height() >= label->fontMetrics().height(), name);
        }
        const QRect cell = bench.view().visualRect(bench.model().indexOf(named("slot1.max_reverse")));
        const QFontMetrics metrics(large);
        QVERIFY(cell.width() > metrics.horizontalAdvance(QStringLiteral("−2147483648")));
        QVERIFY(cell.height() > metrics.height());
    }
    QApplication::setFont(before);
    applyTheme(*qApp, lightTheme());
}

void TestParametersPage::namesAreWholeWhileNothingIsStaged()
{
    ParameterBench bench(readDrive(), {1048, 640}); // of 1280 beside the devices
    const auto *panel = bench.page->findChild<ChangesPanel *>();
    QVERIFY(!panel->isVisible());
    const ParameterDelegate delegate(bench.theme, bench.model(), nullptr);
    for (std::uint16_t i = 0; i < dmc60c().parameters.size(); ++i) {
        const QModelIndex cell = bench.model().indexOf({i}, ParameterModel::Label);
        const QString name = cell.data().toString();
        const int needed
            = QFontMetrics(delegate.cellFont(ParameterModel::Label, bench.view().font())).horizontalAdvance(name)
            + delegate.labelIndent() + delegate.padding();
        QVERIFY2(bench.view().columnWidth(ParameterModel::Label) >= needed, qPrintable(name));
    }
    bench.stage("slot0.p", "0.5");
    QVERIFY(panel->isVisible());
}

void TestParametersPage::longWordsBesideTheTableTakeNoColumnFromIt()
{
    ParameterBench bench;
    bench.page->resize(1048, 640);
    bench.stage("slot0.p", "0.5");
    auto *panel = bench.page->findChild<ChangesPanel *>();
    for (auto *label : panel->findChildren<QLabel *>()) {
        if (label->wordWrap())
            label->setText(QString(90, QChar(0x5909))); // as in Japanese: no spaces
    }
    bench.page->show();
    QCoreApplication::processEvents();
    QVERIFY2(panel->width() <= 300, qPrintable(QString::number(panel->width())));
    QVERIFY(bench.page->view().columnWidth(ParameterModel::Key) > 0);
}

void TestParametersPage::whatNobodyCanReadIsNotDoneAndHasAShape()
{
    DeviceView board = readDrive();
    const auto all = families();
    board.family = *std::find_if(all.begin(), all.end(), [](const Family *one) { return one->capabilities.axes > 1; });
    board.parameters.edit().assign(board.family->parameters.size(), {});
    int known = 0;
    for (std::size_t i = 0; i < board.family->parameters.size(); ++i) {
        if (board.family->parameters[i].access != Access::WriteOnly) {
            board.parameters.edit()[i] = {0, ParameterState::Volatile};
            ++known;
        }
    }
    ParameterBench bench(board);
    bench.selection.select({1}, 2);
    bench.workbench.publish();
    const auto *const status = bench.page->findChild<ReadStatus *>();
    QVERIFY(status->findChild<StateGlyph *>()->state() != GlyphState::Done);
    QCOMPARE(status->findChild<QLabel *>()->text(),
        QStringLiteral("%1 of %2 known").arg(known).arg(board.parameters->size()));
    const ParameterCounts counts = countParameters(bench.model(), 2);
    QCOMPARE(counts.notKept, counts.all); // as the head of the group says: nothing is kept over a power cycle
    QCOMPARE(glyphOf(ParameterState::Unknown), GlyphState::Gone); // a ring, as on Tune
}

MB_WINDOW_TEST(TestParametersPage);
#include "tst_parameterspage.moc"
