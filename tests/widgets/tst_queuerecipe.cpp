// SPDX-License-Identifier: GPL-3.0-or-later
// The recipe of a queue: it says what it does, and is changed beside the queue without disturbing units that are served.
#include "queuebench.h"
#include "support/windowtests.h"
#include "widgets/service/recipeform.h"

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
    bench.workbench.serve({bench.row(1, 1, RowState::Running)});
    type(*editor, "Name", "drive-base rev D");
    editor->save();
    QVERIFY(!editor->isUnsaved());
    QVERIFY(bench.says(QStringLiteral("drive-base rev C"))); // what they are served by
    bench.workbench.serve({bench.row(1, 1, RowState::Passed)}, false);
    QVERIFY(bench.says(QStringLiteral("drive-base rev D")));
}

MB_WINDOW_TEST(QueueRecipeTest);
#include "tst_queuerecipe.moc"
