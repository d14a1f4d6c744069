// SPDX-License-Identifier: GPL-3.0-or-later
// The Tune page in a real window: nothing is cut or scrolled away, in every language and at every font; F1 lists its keys.
#include "app/languages.h"
#include "support/windowtests.h"
#include "widgets/common/pagekeys.h"
#include "widgets/control/responseplot.h"
#include "widgets/control/trialsview.h"
#include "widgets/control/tuneframe.h"
#include "widgets/control/tunepage.h"
#include "widgets/service/productionpage.h"
#include "windowbench.h"

#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>

using namespace mb;
using namespace mb::test;

class TuneFitTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void nothingIsCut_data();
    void nothingIsCut();
    void f1ListsTheKeysOfThePageAndOfTheWindow();
    void theKeysOfTheWindowDoWhatTheySay();
};

void TuneFitTest::nothingIsCut_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<double>("fontScale");
    QTest::addColumn<QString>("language");
    const auto add = [](QSize size, double scale, const QString &language) {
        const QString name
            = QStringLiteral("%1x%2, font x%3, %4").arg(size.width()).arg(size.height()).arg(scale).arg(language);
        QTest::newRow(qUtf8Printable(name)) << size << scale << language;
    };
    const QStringList twice{QStringLiteral("en"), QStringLiteral("de")};
    for (const QSize size : {QSize(1280, 800), QSize(1366, 768), QSize(1440, 900)}) {
        for (const double scale : {1.0, 1.5, 2.0}) {
            for (const QString &language : twice)
                add(size, scale, language);
        }
    }
    for (const Language &language : languages()) {
        if (!twice.contains(language.code)) {
            add(QSize(1280, 800), 1.0, language.code);
            add(QSize(1280, 800), 2.0, language.code);
        }
    }
}

void TuneFitTest::nothingIsCut()
{
    QFETCH(QSize, size);
    QFETCH(double, fontScale);
    QFETCH(QString, language);
    WindowBench bench(fontScale, language);
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    bench.window().resize(size);
    auto &page = bench.page<TunePage>(PageId::Tune);
    QCoreApplication::processEvents();
    QCOMPARE(bench.window().size(), size);
    const QWidget &viewport = *page.parentWidget();
    QCOMPARE(page.size(), viewport.size()); // no scroll bars
    const auto *run = page.findChild<QPushButton *>(QStringLiteral("run"));
    QTRY_VERIFY_WITH_TIMEOUT(page.rect().contains(QRect(run->mapTo(&page, QPoint()), run->size())), patience);
    const QSize plot = page.trials().plot().size();
    const double share = 1.0 * plot.width() * plot.height() / (page.width() * page.height());
    qInfo("%s: page %d x %d, plot %d x %d, %.0f %%", QTest::currentDataTag(), page.width(), page.height(), plot.width(),
        plot.height(), share * 100.0);
    QVERIFY(page.trials().plot().isVisible());
    QVERIFY(share >= (fontScale > 1.0 ? 1.0 / 3.0 : 0.2));
    page.frame().show(TuneFrame::Part::Setup);
    QCoreApplication::processEvents();
    for (const QScrollArea *scroll : page.findChildren<QScrollArea *>()) {
        if (!scroll->isVisible() || !scroll->widget()->findChild<QLineEdit *>())
            continue; // the column of gains
        const int needed = scroll->widget()->minimumSizeHint().width();
        QVERIFY2(needed <= scroll->viewport()->width(),
            qPrintable(QStringLiteral("%1 needed, %2 there").arg(needed).arg(scroll->viewport()->width())));
    }
}

void TuneFitTest::f1ListsTheKeysOfThePageAndOfTheWindow()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    auto &page = bench.page<TunePage>(PageId::Tune);
    QTest::keyClick(&bench.window(), Qt::Key_F1);
    auto *dialog = bench.window().findChild<QDialog *>(QStringLiteral("keys"));
    QVERIFY(dialog && dialog->isVisible());
    QStringList texts;
    for (const auto *label : dialog->findChildren<QLabel *>())
        texts << label->text();
    int rows = 0;
    for (const PageKeys *keys :
        {page.findChild<PageKeys *>(), bench.window().findChild<PageKeys *>(QString(), Qt::FindDirectChildrenOnly)}) {
        QVERIFY(keys);
        for (const PageKeys::Row &row : keys->rows()) {
            QVERIFY2(texts.contains(row.does), qPrintable(row.does));
            ++rows;
        }
    }
    QVERIFY(rows >= 25);
    if (const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES"); !folder.isEmpty()) // for looking at it
        dialog->grab().save(QDir(folder).filePath(QStringLiteral("keys.png")));
    dialog->close();
}

void TuneFitTest::theKeysOfTheWindowDoWhatTheySay()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    MainWindow &window = bench.window();
    const auto *devices = window.findChild<QDockWidget *>(QStringLiteral("devicesDock"));
    const auto *inspector = window.findChild<QDockWidget *>(QStringLiteral("inspectorDock"));
    const auto *keys = window.findChild<PageKeys *>(QString(), Qt::FindDirectChildrenOnly);
    int pressed = 0;
    for (const PageKeys::Row &row : keys->rows()) {
        for (std::size_t i = 0; i < row.shortcuts.size(); ++i, ++pressed) {
            const int code = row.keys[i][0];
            const int key = code & ~static_cast<int>(Qt::KeyboardModifierMask);
            const bool seen[]{devices->isVisible(), inspector->isVisible()};
            QTest::keyClick(&window, static_cast<Qt::Key>(key),
                Qt::KeyboardModifiers(code & static_cast<int>(Qt::KeyboardModifierMask)));
            const QByteArray name = row.keys[i].toString().toLatin1();
            if (key >= Qt::Key_1 && key <= Qt::Key_9)
                QVERIFY2(window.page(static_cast<PageId>(key - Qt::Key_1))->isVisible(), name);
            else if (key == Qt::Key_F9)
                QVERIFY2(devices->isVisible() != seen[0], name);
            else if (key == Qt::Key_F10)
                QVERIFY2(inspector->isVisible() != seen[1], name);
            else if (key == Qt::Key_F1)
                QVERIFY2(window.findChild<QDialog *>(QStringLiteral("keys")), name);
            else if (key == Qt::Key_F2) {
                auto *const question = window.findChild<QInputDialog *>();
                QVERIFY2(question, name); // the first unit that can be tuned is selected
                delete question;
                QApplication::setActiveWindow(&window);
            } else if (key == Qt::Key_S) // see tst_history, tst_parameterorders
                continue;
            else if (key == Qt::Key_F11) {
                const auto *production = window.findChild<ProductionPage *>();
                QVERIFY2(production && production->isVisible(), name);
                QTest::keyClick(&window, Qt::Key_F11);
                QVERIFY2(!production->isVisible(), name);
            } else
                QFAIL("no test of " + name);
            if (auto *dialog = window.findChild<QDialog *>(QStringLiteral("keys"))) {
                delete dialog;
                QApplication::setActiveWindow(&window);
            }
        }
    }
    QVERIFY(pressed >= 10);
}

MB_WINDOW_TEST(TuneFitTest);
#include "tst_tunefit.moc"
