// SPDX-License-Identifier: GPL-3.0-or-later
// The recipe of a queue: it says what it does, is changed beside the queue without disturbing units that are served, and what is
// shown of those is by theirs.
#include "queuebench.h"
#include "support/windowtests.h"
#include "widgets/common/iconbutton.h"
#include "widgets/firmware/pagemap.h"
#include "widgets/firmware/queuebar.h"
#include "widgets/firmware/unitsteps.h"
#include "widgets/service/recipeform.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QPushButton>

using namespace mb;
using namespace mb::test;

namespace {

void type(const RecipeEditor &editor, const char *field, const char *text)
{
    for (auto *edit : editor.findChildren<QLineEdit *>()) {
        if (edit->accessibleName() == QLatin1String(field))
            return edit->setText(QLatin1String(text));
    }
    QFAIL(field);
}

void click(const RecipeEditor &editor, const char *text)
{
    for (auto *button : editor.findChildren<QPushButton *>()) {
        if (button->text() == QLatin1String(text))
            return QTest::mouseClick(button, Qt::LeftButton);
    }
    QFAIL(text);
}

} // namespace

class QueueRecipeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aRecipeSaysWhatItDoes();
    void aRecipeIsChangedByThePencil();
    void aRecipeThatIsSavedWhileUnitsAreServedWaitsForThem();
    void anImageOfAnotherKindIsRefusedWithWords();
    void aQueueThatProductionHasBegunIsShownByItsOwnRecipe();
    void whatWasServedIsShownByWhatItWasServedBy();
    void unitsOfAnotherRecipeAreNotTriedAgainByIt();
};

void QueueRecipeTest::aRecipeSaysWhatItDoes()
{
    QueueBench bench;
    const QString path = bench.write(R"({"recipe":1,"name":"drive-base rev C","family":"dmc60c","number":{"first":10},
"test":{"loop":"velocity","to":1500,"limits":{"travel":50000,"speed":2000,"duty":0.3},"accept":{"overshoot":0.4}}})");
    QVERIFY(bench.board().openRecipe(path));
    QVERIFY(bench.says(QStringLiteral("drive-base rev C")));
    QVERIFY(bench.says(QStringLiteral("next free from 10")));
    QVERIFY(bench.says(QStringLiteral("turns the motor"))); // before anybody can arm it
    QVERIFY(!bench.board().openRecipe(bench.write("{\"recipe\":1,\n\"name\":\"x\",\n\"colour\":3}")));
    QVERIFY(bench.workbench.lines.back().text.contains(QStringLiteral("3"))); // the line of the mistake
    QVERIFY(bench.says(QStringLiteral("drive-base rev C")));                  // what was there stays
}

void QueueRecipeTest::aRecipeIsChangedByThePencil()
{
    QueueBench bench;
    QVERIFY(bench.board().openRecipe(
        bench.write(R"({"recipe":1,"name":"drive-base rev C","family":"dmc60c","number":{"first":10}})")));
    RecipeEditor *editor = bench.openEditor();
    QVERIFY(editor);
    QVERIFY(editor->windowTitle().contains(QLatin1String("recipe.json")));
    QVERIFY(editor->form().text().contains("drive-base rev C"));
    QVERIFY(!editor->isUnsaved());
    QCOMPARE(bench.openEditor(), editor); // no second one beside it
    type(*editor, "Name", "drive-base rev D");
    type(*editor, "First number to give", "20");
    QVERIFY(bench.says(QStringLiteral("drive-base rev C"))); // nothing is saved yet
    click(*editor, "Save recipe");
    QVERIFY(!editor->isUnsaved());
    QVERIFY(bench.says(QStringLiteral("drive-base rev D")));
    QVERIFY(bench.says(QStringLiteral("next free from 20")));
    bench.model().tick({1}, true);
    bench.board().start();
    QCOMPARE(bench.workbench.given<orders::ServeUnits>().at(0).matter->recipe.name, std::string("drive-base rev D"));
}

void QueueRecipeTest::aRecipeThatIsSavedWhileUnitsAreServedWaitsForThem()
{
    QueueBench bench;
    QVERIFY(bench.board().openRecipe(bench.write(R"({"recipe":1,"name":"drive-base rev C","family":"dmc60c"})")));
    RecipeEditor *editor = bench.openEditor();
    QVERIFY(editor);
    bench.model().tick({1}, true);
    bench.board().start();
    bench.workbench.served.matter = bench.workbench.given<orders::ServeUnits>().at(0).matter;
    bench.workbench.serve({bench.row(1, 1, RowState::Running)});
    type(*editor, "Name", "drive-base rev D");
    editor->save();
    QVERIFY(!editor->isUnsaved());
    QVERIFY(bench.says(QStringLiteral("drive-base rev C"))); // what they are served by
    QVERIFY(bench.workbench.lines.back().text.startsWith(QStringLiteral("drive-base rev D waits")));
    bench.workbench.serve({bench.row(1, 1, RowState::Passed)}, false);
    QVERIFY(bench.says(QStringLiteral("drive-base rev D")));
}

void QueueRecipeTest::anImageOfAnotherKindIsRefusedWithWords()
{
    QueueBench bench;
    QFile file(bench.folder.filePath(QStringLiteral("other.hex")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(":00000001FF\n");
    file.close();
    QVERIFY(!bench.board().openImage(file.fileName()));
    QVERIFY(!bench.workbench.lines.empty());
    QVERIFY(!bench.board().openImage(QStringLiteral("/nowhere/at/all.hex")));
    QVERIFY(!bench.board().canStart());
}

void QueueRecipeTest::aQueueThatProductionHasBegunIsShownByItsOwnRecipe()
{
    QueueBench bench;
    QVERIFY(bench.board().openImage(demoImage));
    bench.add(4, 11, "sim:serial", "Q1");
    bench.workbench.shot.devices.back().family = findFamily(families(), "quadquad2drv");
    service::RecipeMatter other;
    other.recipe.name = "boards";
    other.recipe.family = bench.workbench.shot.devices.back().family;
    bench.workbench.served.matter = std::make_shared<const service::RecipeMatter>(other);
    QueueRow running = bench.row(1, 4, RowState::Running);
    running.mayInterrupt = false;
    bench.workbench.serve({running});
    QVERIFY(bench.says(QStringLiteral("Do not unplug: ")));
    QVERIFY(bench.says(QStringLiteral("boards")));
    QCOMPARE(bench.model().rowOf(1), 0);
    QCOMPARE(bench.board().steps().row(), 1U);
    running.state = RowState::Failed;
    bench.workbench.serve({running}, false);
    QVERIFY(!bench.says(QStringLiteral("boards")));
    QCOMPARE(bench.model().rowOf(1), 0); // what has failed is in sight until another queue begins
    QCOMPARE(bench.model().rowCount(), 4);
    bench.board().findChild<QCheckBox *>()->click();
    QCOMPARE(bench.model().ticked().size(), 3U); // it is none of them
    bench.workbench.serve({}, false);
    QCOMPARE(bench.model().rowCount(), 3);
}

void QueueRecipeTest::whatWasServedIsShownByWhatItWasServedBy()
{
    QueueBench bench;
    const auto serve = [&bench] {
        bench.model().tick({1}, true);
        bench.board().start();
        bench.workbench.served.matter = bench.workbench.given<orders::ServeUnits>().back().matter;
    };
    QVERIFY(bench.board().openImage(demoImage));
    serve();
    QueueRow row = bench.row(1, 1, RowState::Passed);
    row.parts = {{0, PartState::Done}, {1, PartState::Done}};
    bench.workbench.serve({row}, false);
    const PageMap &map = *bench.board().findChild<PageMap *>();
    const QString pages = map.accessibleDescription();
    QVERIFY2(pages.startsWith(QStringLiteral("2 of ")), qPrintable(pages));
    QVERIFY(bench.board().openRecipe(bench.write(
        R"({"recipe":1,"name":"drive-base rev C","family":"dmc60c","test":{"loop":"velocity","to":1500,
"limits":{"travel":50000,"speed":2000,"duty":0.3},"accept":{"overshoot":0.4}}})")));
    QCOMPARE(map.accessibleDescription(), pages);
    QVERIFY(!bench.says(QStringLiteral("Self-test")));
    QVERIFY(bench.says(QStringLiteral("turns the motor"))); // the next queue
    serve();
    row = bench.row(2, 1, RowState::Failed);
    row.visit.step = service::Step::Test;
    bench.workbench.serve({row}, false);
    QVERIFY(bench.says(QStringLiteral("Self-test")));
    QVERIFY(bench.board().openImage(demoImage));
    QVERIFY(bench.says(QStringLiteral("Self-test")));
    QCOMPARE(bench.cell(0, QueueModel::Versions), QStringLiteral("1.23"));
}

void QueueRecipeTest::unitsOfAnotherRecipeAreNotTriedAgainByIt()
{
    QueueBench bench;
    QVERIFY(bench.board().openImage(demoImage));
    service::RecipeMatter before;
    before.recipe.name = "the one before";
    before.recipe.family = &dmc60c();
    before.hash = "another";
    bench.workbench.served.matter = std::make_shared<const service::RecipeMatter>(before);
    bench.workbench.serve({bench.row(1, 1, RowState::Failed)});
    bench.board().bar().retry().click();
    QCOMPARE(bench.workbench.given<orders::RetryFailedUnits>().size(), 1U);
    bench.workbench.serve({bench.row(1, 1, RowState::Failed)}, false);
    bench.board().bar().retry().click();
    bench.board().steps().again().click();
    QCOMPARE(bench.workbench.given<orders::RetryFailedUnits>().size(), 1U);
    QVERIFY(bench.workbench.given<orders::RetryUnit>().empty());
    QVERIFY(bench.workbench.lines.back().text.contains(QStringLiteral("served by the one before")));
}

MB_WINDOW_TEST(QueueRecipeTest);
#include "tst_queuerecipe.moc"
