// SPDX-License-Identifier: GPL-3.0-or-later
// An order whose link is closed meanwhile ends with an answer: no page waits for ever, every dialog can be closed.
#include "support/windowtests.h"
#include "widgets/connection/experimentdialog.h"
#include "widgets/control/tunepage.h"
#include "widgets/parameters/editdesk.h"
#include "windowbench.h"

#include <QLabel>
#include <QPointer>
#include <QPushButton>

using namespace mb;
using namespace mb::test;

class DroppedTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void tuneDoesNotWriteForEver();
    void anExperimentEndsAndItsDialogCanBeClosed();
};

namespace {

bool says(const QWidget &page, const QString &words)
{
    const auto labels = page.findChildren<QLabel *>();
    return std::any_of(labels.begin(), labels.end(),
        [&](const QLabel *label) { return label->isVisibleTo(&page) && label->text().contains(words); });
}

QPushButton *button(const QWidget &page, const QString &words)
{
    const auto buttons = page.findChildren<QPushButton *>();
    const auto found = std::find_if(buttons.begin(), buttons.end(),
        [&](const QPushButton *one) { return one->isVisibleTo(&page) && one->text().startsWith(words); });
    return found == buttons.end() ? nullptr : *found;
}

} // namespace

void DroppedTest::tuneDoesNotWriteForEver()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound() && bench.device(4, "supermodified"), patience);
    bench.select(WindowBench::tuned);
    auto &page = bench.page<TunePage>(PageId::Tune);
    QTRY_VERIFY_WITH_TIMEOUT(bench.isRead(WindowBench::tuned), patience);
    const DeviceView *view = bench.device(WindowBench::tuned);
    EditDesk::of(bench.engine())
        .editsOf(*view)
        .stage(*findParameter(view->family->parameters, "slot0.p"), QStringLiteral("1.5"));
    QPushButton *write = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT((write = button(page, QStringLiteral("Write P"))) && write->isEnabled(), patience);
    write->click();
    QVERIFY(says(page, QStringLiteral("Writing gains")));
    bench.engine().send(orders::CloseLink{"sim:can"});
    QTRY_VERIFY_WITH_TIMEOUT(!bench.device(WindowBench::tuned), patience);
    bench.window().selection().select(bench.device(4, "supermodified")->id);
    QTRY_VERIFY_WITH_TIMEOUT(!says(page, QStringLiteral("Writing gains")), patience);
}

void DroppedTest::anExperimentEndsAndItsDialogCanBeClosed()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound() && bench.device(0, "quadquad2drv"), patience);
    bench.window().selection().select(bench.device(0, "quadquad2drv")->id);
    bench.window().showPage(PageId::Overview);
    QPushButton *open = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT((open = bench.window().findChild<QPushButton *>(QStringLiteral("gain-scales"))), patience);
    open->click();
    const QPointer<ExperimentDialog> dialog = bench.window().findChild<ExperimentDialog *>();
    QVERIFY(dialog);
    dialog->start();
    QVERIFY(dialog->isRunning());
    bench.engine().send(orders::CloseLink{"sim:spi"});
    QTRY_VERIFY_WITH_TIMEOUT(!dialog || !dialog->isRunning(), patience);
    if (dialog) {
        QPushButton *close = button(*dialog, QStringLiteral("Close"));
        QVERIFY(close && close->isEnabled());
        close->click();
    }
    QTRY_VERIFY_WITH_TIMEOUT(!dialog || !dialog->isVisible(), patience);
}

MB_WINDOW_TEST(DroppedTest);
#include "tst_dropped.moc"
