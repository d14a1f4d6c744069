// SPDX-License-Identifier: GPL-3.0-or-later
// A recipe is written in the window: fields make a file, a mistake has its line and is never saved, what was saved is a recipe again.
#include "model/family.h"
#include "model/registry.h"
#include "service/recipematter.h"
#include "support/timers.h"
#include "support/windowtests.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/iconbutton.h"
#include "widgets/service/recipeeditor.h"
#include "widgets/service/recipeform.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QStyleOptionGroupBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include <set>

using namespace mb;
using namespace mb::test;
using namespace std::chrono_literals;

namespace {

struct EditorBench {
    QTemporaryDir folder;
    ThemeSource theme;
    std::unique_ptr<RecipeEditor> editor;

    explicit EditorBench(double points = 10)
        : theme(darkTheme(points))
    {
        QFont font = QApplication::font(); // as the program does it
        font.setPointSizeF(points);
        QApplication::setFont(font);
        applyTheme(*qApp, theme.theme());
        editor = std::make_unique<RecipeEditor>(families(), folder.path(), theme, nullptr);
        editor->show();
        QApplication::setActiveWindow(editor.get());
    }
    [[nodiscard]] QString path(const QString &name) const { return folder.filePath(name); }
    void write(const QString &name, const QByteArray &text) const
    {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    [[nodiscard]] QByteArray read(const QString &name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    template <class Widget> [[nodiscard]] Widget &named(const char *name) const
    {
        for (auto *widget : editor->findChildren<Widget *>()) {
            if (widget->accessibleName() == QLatin1String(name))
                return *widget;
        }
        qFatal("no %s", name);
    }
    void type(const char *name, const char *text) const { named<QLineEdit>(name).setText(QLatin1String(text)); }
    void click(const char *text) const
    {
        for (auto *button : editor->findChildren<QPushButton *>()) {
            if (button->isVisible() && button->text() == QLatin1String(text))
                return QTest::mouseClick(button, Qt::LeftButton);
        }
        QFAIL(text);
    }
    [[nodiscard]] const QMessageBox *question() const
    {
        const auto *box = editor->findChild<QMessageBox *>();
        return box && box->isVisible() ? box : nullptr;
    }
    void closeQuestion(const char *answer) const
    {
        click(answer);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    [[nodiscard]] QTableWidget &accept() const { return named<QTableWidget>("What the self-test accepts"); }
    [[nodiscard]] QTableWidgetItem &cell(const char *key, int column) const
    {
        for (int row = 0; row < accept().rowCount(); ++row) {
            if (accept().item(row, 0)->text() == QLatin1String(key))
                return *accept().item(row, column);
        }
        qFatal("no %s", key);
    }
    void addFiles() const
    {
        QFile::copy(QStringLiteral(":/firmware/dmc60c-demo.hex"), path(QStringLiteral("demo.hex")));
        write(QStringLiteral("base.json"), R"({"family":"dmc60c","parameters":{"slot1.d":{"raw":77}}})");
    }
    /// All that a recipe can say.
    void fillIn() const
    {
        addFiles();
        type("Name", "drive-base rev C");
        named<QComboBox>("Family").setCurrentIndex(named<QComboBox>("Family").findData(QStringLiteral("dmc60c")));
        type("Firmware file", "demo.hex");
        type("Parameter file", "base.json");
        type("First number to give", "10");
        editor->findChild<QGroupBox *>()->setChecked(true);
        type("To", "8000");
        type("Time, s", "0,8"); // with a comma, as many people write it
        type("Travel at most, counts", "400000");
        type("Duty at most, 0 to 1", "0.9");
        cell("settle", 2).setText(QStringLiteral("0.6"));
        cell("friction", 1).setText(QStringLiteral("0.1"));
        cell("friction", 2).setText(QStringLiteral("0.4"));
        cell("encoder", 2).setCheckState(Qt::Checked);
    }
    void picture(const char *name) const
    {
        const QString pictures = qEnvironmentVariable("MOTORBENCH_PICTURES");
        if (pictures.isEmpty())
            return;
        const double points = theme.theme().bodyPointSize;
        for (const bool dark : {true, false}) {
            const_cast<ThemeSource &>(theme).setTheme(dark ? darkTheme(points) : lightTheme(points));
            applyTheme(*qApp, theme.theme());
            passTimers(100ms);
            editor->grab().save(QDir(pictures).filePath(
                QStringLiteral("%1-%2.png")
                    .arg(QLatin1String(name), dark ? QStringLiteral("dark") : QStringLiteral("light"))));
        }
    }
};

} // namespace

class RecipeEditorTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatIsFilledInIsARecipe();
    void anUntouchedRecipeIsNoMistake();
    void theBoxThatLetsTheMotorTurnIsSeen();
    void aSetPointHasTheUnitOfItsLoop();
    void aMistakeHasItsLineAndIsNeverSaved();
    void aFileThatIsNotThereHasTheLineThatNamesIt();
    void aRecipeIsOpenedChangedAndSavedInItsPlace();
    void aRecipeThatIsNotSavedAsksBeforeItIsClosed();
    void aSavedRecipeIsClosedWithoutAQuestion();
    void theMarkedLineFollowsTheTheme();
    void everyFamilyHasItsLoops();
    void noFieldIsCut_data();
    void noFieldIsCut();
    void whereAFileCannotBeWrittenAnotherCan();
    void everyControlHasANameAndTheKeyboardReachesIt();
};

void RecipeEditorTest::whatIsFilledInIsARecipe()
{
    const EditorBench bench;
    QVERIFY(!bench.editor->canSave()); // it has no name yet
    bench.picture("recipe-new");
    bench.fillIn();
    QVERIFY2(bench.editor->canSave(), qPrintable(bench.editor->problem()));
    bench.picture("recipe");
    const QSignalSpy saved(bench.editor.get(), &RecipeEditor::saved);
    QVERIFY(bench.editor->saveAs(bench.path(QStringLiteral("rev-c.json"))));
    QCOMPARE(saved.count(), 1);
    const auto matter = service::loadRecipe(bench.path(QStringLiteral("rev-c.json")).toStdString(), families());
    QVERIFY2(matter.has_value(), matter ? "" : matter.error().text().c_str());
    const service::Recipe &recipe = matter->recipe;
    QCOMPARE(recipe.name, std::string("drive-base rev C"));
    QCOMPARE(recipe.number->first, 10);
    QCOMPARE(matter->imageVersion, std::string("1.25"));
    QCOMPARE(recipe.test->to, 8000.0);
    QCOMPARE(*recipe.test->seconds, 0.8);
    QCOMPARE(*recipe.test->limits.duty, 0.9);
    QVERIFY(!recipe.test->limits.speed);
    QCOMPARE(recipe.test->accept.size(), std::size_t(3));
}

void RecipeEditorTest::anUntouchedRecipeIsNoMistake()
{
    const EditorBench bench;
    const auto marks = [&bench] {
        return bench.named<QPlainTextEdit>("The file that is saved, line by line").extraSelections().size();
    };
    QCOMPARE(bench.editor->problem(), QStringLiteral("Give the recipe a name."));
    QCOMPARE(marks(), 0);
    QVERIFY(!bench.editor->canSave());
    bench.editor->save(); // a try
    QVERIFY2(bench.editor->problem().contains(QStringLiteral("'name' must not be empty")),
        qPrintable(bench.editor->problem()));
    QCOMPARE(marks(), 1);
    bench.type("Name", "drive-base");
    QVERIFY2(bench.editor->canSave(), qPrintable(bench.editor->problem()));
}

void RecipeEditorTest::theBoxThatLetsTheMotorTurnIsSeen()
{
    struct Opened : QGroupBox {
        using QGroupBox::initStyleOption;
    };
    const EditorBench bench;
    auto *group = bench.editor->findChild<QGroupBox *>();
    QStyleOptionGroupBox option;
    (group->*&Opened::initStyleOption)(&option);
    const QRect box = group->style()->subControlRect(QStyle::CC_GroupBox, &option, QStyle::SC_GroupBoxCheckBox, group);
    const QImage picture = group->grab().toImage();
    const QColor ground = picture.pixelColor(box.left() - 2, box.center().y());
    double best = 0.0;
    for (int x = box.left(); x <= box.right(); ++x)
        best = std::max(best, contrast(picture.pixelColor(x, box.center().y()), ground));
    QVERIFY2(best >= 3.0, qPrintable(QString::number(best)));
}

void RecipeEditorTest::aSetPointHasTheUnitOfItsLoop()
{
    const EditorBench bench;
    const auto labelled = [&bench](const QString &text) {
        const auto labels = bench.editor->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel *label) { return label->text() == text; });
    };
    auto &loop = bench.named<QComboBox>("Loop");
    loop.setCurrentIndex(loop.findData(QStringLiteral("velocity")));
    QVERIFY(labelled(QStringLiteral("From, counts/s")));
    QVERIFY(labelled(QStringLiteral("To, counts/s")));
    loop.setCurrentIndex(loop.findData(QStringLiteral("position")));
    QVERIFY(labelled(QStringLiteral("To, counts")));
}

void RecipeEditorTest::aMistakeHasItsLineAndIsNeverSaved()
{
    const EditorBench bench;
    bench.fillIn();
    QVERIFY(bench.editor->saveAs(bench.path(QStringLiteral("rev-c.json"))));
    const QByteArray before = bench.read(QStringLiteral("rev-c.json"));
    bench.type("First number to give", "900"); // a DMC60C has 63 of them
    QVERIFY(!bench.editor->canSave());
    const QString words = bench.editor->problem();
    static const QRegularExpression pattern(QStringLiteral("line (\\d+):.*first"));
    const auto found = pattern.match(words);
    QVERIFY2(found.hasMatch(), qPrintable(words));
    const QString shown = bench.named<QPlainTextEdit>("The file that is saved, line by line").toPlainText();
    QVERIFY(shown.split(QLatin1Char('\n')).at(found.captured(1).toInt() - 1).contains(QLatin1String("\"first\": 900")));
    bench.picture("recipe-mistake");
    bench.editor->save();
    QVERIFY(!bench.editor->saveAs(bench.path(QStringLiteral("other.json"))));
    QCOMPARE(bench.read(QStringLiteral("rev-c.json")), before);
    QVERIFY(!QFile::exists(bench.path(QStringLiteral("other.json"))));
    bench.type("First number to give", "ten"); // a field for numbers takes no letters; a file may hold anything
    QVERIFY(!bench.editor->canSave());
    bench.type("First number to give", "12");
    QVERIFY2(bench.editor->canSave(), qPrintable(bench.editor->problem()));
    bench.cell("settle", 2).setText(QStringLiteral("fast"));
    QVERIFY2(bench.editor->problem().contains(QLatin1String("settle")), qPrintable(bench.editor->problem()));
    QVERIFY(!bench.editor->canSave());
}

void RecipeEditorTest::aFileThatIsNotThereHasTheLineThatNamesIt()
{
    const EditorBench bench;
    bench.fillIn();
    for (const auto &[field, text] :
        {std::pair("Firmware file", "none.hex"), std::pair("Parameter file", "none.json")}) {
        const QString before = bench.named<QLineEdit>(field).text();
        bench.type(field, text);
        QVERIFY2(bench.editor->problem().contains(QLatin1String(text)), qPrintable(bench.editor->problem()));
        QVERIFY2(bench.editor->problem().contains(QLatin1String("line ")), qPrintable(bench.editor->problem()));
        QVERIFY(!bench.editor->saveAs(bench.path(QStringLiteral("rev-c.json"))));
        bench.named<QLineEdit>(field).setText(before);
    }
    QTemporaryDir elsewhere; // its files do not lie there
    QVERIFY(!bench.editor->saveAs(elsewhere.filePath(QStringLiteral("rev-c.json"))));
    QVERIFY(bench.editor->problem().contains(QLatin1String("demo.hex")));
    QVERIFY(bench.editor->canSave());
    QVERIFY(bench.editor->saveAs(bench.path(QStringLiteral("rev-c.json"))));
}

void RecipeEditorTest::aRecipeIsOpenedChangedAndSavedInItsPlace()
{
    const EditorBench bench;
    bench.fillIn();
    const QString path = bench.path(QStringLiteral("rev-c.json"));
    QVERIFY(bench.editor->saveAs(path));
    const QByteArray before = bench.read(QStringLiteral("rev-c.json"));
    RecipeEditor other(families(), {}, bench.theme, nullptr);
    QVERIFY(other.openFile(path));
    QVERIFY2(other.canSave(), qPrintable(other.problem()));
    QCOMPARE(other.form().text(), before);
    for (auto *field : other.findChildren<QLineEdit *>()) {
        if (field->accessibleName() == QLatin1String("Name"))
            field->setText(QStringLiteral("rev D"));
    }
    bench.editor->hide();
    other.show();
    QApplication::setActiveWindow(&other);
    QTest::keyClick(&other, Qt::Key_S, Qt::ControlModifier);
    const auto matter = service::loadRecipe(path.toStdString(), families());
    QVERIFY(matter.has_value());
    QCOMPARE(matter->recipe.name, std::string("rev D"));
    bench.write(QStringLiteral("bad.json"), "{\n\"recipe\": 1,\n\"nmae\": 2}");
    const auto opened = other.openFile(bench.path(QStringLiteral("bad.json")));
    QVERIFY(!opened);
    QVERIFY(QString::fromStdString(opened.error().text()).contains(QLatin1String("line 3")));
}

void RecipeEditorTest::aRecipeThatIsNotSavedAsksBeforeItIsClosed()
{
    const EditorBench bench;
    bench.type("Name", "any");
    bench.click("Close");
    QVERIFY(bench.question());
    QVERIFY(!bench.question()->isModal()); // STOP of the window behind can be clicked
    QCOMPARE(bench.question()->text(), QStringLiteral("This recipe is not saved."));
    bench.closeQuestion("Go on writing");
    QVERIFY(bench.editor->isVisible());
    QVERIFY(!bench.question());
    QCOMPARE(bench.named<QLineEdit>("Name").text(), QStringLiteral("any"));
    QTest::keyClick(bench.editor.get(), Qt::Key_Escape);
    QVERIFY(bench.question());
    QTest::keyClick(bench.editor->findChild<QMessageBox *>(), Qt::Key_Escape); // keeps what is written
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QVERIFY(bench.editor->isVisible());
    QVERIFY(!bench.editor->close()); // the cross of its frame
    QVERIFY(bench.question());
    bench.closeQuestion("Discard it");
    QVERIFY(!bench.editor->isVisible());
}

void RecipeEditorTest::aSavedRecipeIsClosedWithoutAQuestion()
{
    const EditorBench bench;
    bench.type("Name", "any");
    QTest::keyClick(bench.editor.get(), Qt::Key_Escape);
    QVERIFY(bench.question());
    QVERIFY(bench.editor->saveAs(bench.path(QStringLiteral("any.json"))));
    QVERIFY(!bench.question()); // what it asks is answered
    QVERIFY(bench.editor->isVisible());
    bench.click("Close");
    QVERIFY(!bench.editor->isVisible());
    const EditorBench untouched;
    QTest::keyClick(untouched.editor.get(), Qt::Key_Escape);
    QVERIFY(!untouched.editor->isVisible());
}

void RecipeEditorTest::theMarkedLineFollowsTheTheme()
{
    EditorBench bench;
    bench.editor->save(); // its recipe has no name
    const auto colour = [&bench] {
        const auto marks = bench.named<QPlainTextEdit>("The file that is saved, line by line").extraSelections();
        return marks.size() == 1 ? marks.front().format.foreground().color() : QColor();
    };
    QCOMPARE(colour(), darkTheme().danger);
    bench.theme.setTheme(lightTheme());
    applyTheme(*qApp, bench.theme.theme());
    QTRY_COMPARE(colour(), lightTheme().danger);
    QVERIFY(darkTheme().danger != lightTheme().danger);
}

void RecipeEditorTest::everyFamilyHasItsLoops()
{
    const EditorBench bench;
    auto &chosen = bench.named<QComboBox>("Family");
    bench.type("Name", "any");
    for (const Family *const family : families()) {
        chosen.setCurrentIndex(chosen.findData(QString::fromStdString(std::string(family->key))));
        QCOMPARE(bench.named<QComboBox>("Loop").count(), static_cast<int>(family->modes.size()));
        QVERIFY2(bench.editor->canSave(), qPrintable(bench.editor->problem()));
        if (family->routes.empty())
            continue;
        bench.addFiles();
        bench.type("Firmware file", "demo.hex");
        QVERIFY2(bench.editor->problem().contains(QLatin1String("via")), qPrintable(bench.editor->problem()));
        bench.type("Firmware file", "");
    }
}

void RecipeEditorTest::noFieldIsCut_data()
{
    QTest::addColumn<double>("points");
    QTest::addColumn<QSize>("size");
    QTest::addColumn<QString>("name");
    QTest::newRow("as it opens") << 10.0 << QSize() << QStringLiteral("recipe-size");
    QTest::newRow("1280x800") << 10.0 << QSize(1280, 760) << QStringLiteral("recipe-1280");
    QTest::newRow("narrow") << 10.0 << QSize(640, 600) << QStringLiteral("recipe-narrow");
    QTest::newRow("200 %, 1280x800") << 20.0 << QSize(1280, 760) << QStringLiteral("recipe-200");
    QTest::newRow("200 %, 1024x768") << 20.0 << QSize(1024, 720) << QStringLiteral("recipe-200-narrow");
}

void RecipeEditorTest::noFieldIsCut()
{
    QFETCH(double, points);
    QFETCH(QSize, size);
    QFETCH(QString, name);
    const EditorBench bench(points);
    bench.fillIn();
    bench.type("First number to give", "900"); // a mistake, so that there are words below
    if (size.isValid())
        bench.editor->resize(size);
    QCoreApplication::processEvents();
    bench.picture(qPrintable(name));
    if (size.isValid())
        QCOMPARE(bench.editor->size(), size); // nothing in it needs more
    const auto *scroll = bench.editor->findChild<QScrollArea *>();
    scroll->verticalScrollBar()->setValue(scroll->verticalScrollBar()->maximum());
    bench.accept().scrollToBottom();
    bench.picture(qPrintable(name + QStringLiteral("-below")));
    const QFontMetrics letters(bench.accept().font());
    for (int row = 0; row < bench.accept().rowCount(); ++row) {
        QVERIFY(bench.accept().rowHeight(row) >= letters.height() + bench.theme.theme().u(8));
        for (int column = 0; column < bench.accept().columnCount(); ++column)
            QVERIFY2(letters.horizontalAdvance(bench.accept().item(row, column)->text())
                    < bench.accept().columnWidth(column),
                qPrintable(bench.accept().item(row, column)->text()));
    }
    QVERIFY2(scroll->widget()->width() <= scroll->viewport()->width(),
        qPrintable(QStringLiteral("%1 of %2").arg(scroll->widget()->width()).arg(scroll->viewport()->width())));
    for (const auto *edit : bench.editor->form().findChildren<QLineEdit *>())
        QVERIFY2(edit->width() >= bench.theme.theme().u(60), qPrintable(edit->accessibleName()));
}

void RecipeEditorTest::whereAFileCannotBeWrittenAnotherCan()
{
    const EditorBench bench;
    bench.addFiles();
    bench.type("Name", "any");
    const QString taken = bench.path(QStringLiteral("folder.json"));
    QVERIFY(QDir().mkdir(taken));
    QVERIFY(!bench.editor->saveAs(taken));
    QVERIFY2(bench.editor->problem().contains(taken), qPrintable(bench.editor->problem()));
    QVERIFY(bench.editor->canSave());
    QVERIFY(bench.editor->saveAs(bench.path(QStringLiteral("any.json"))));
    QVERIFY(bench.editor->problem().isEmpty());
}

void RecipeEditorTest::everyControlHasANameAndTheKeyboardReachesIt()
{
    const EditorBench bench;
    bench.fillIn();
    for (const QWidget *widget : bench.editor->findChildren<QWidget *>()) {
        const bool control = widget->inherits("QAbstractButton") || widget->inherits("QComboBox")
            || widget->inherits("QLineEdit") || widget->inherits("QAbstractItemView");
        if (control && widget->isVisible() && widget->accessibleName().isEmpty()
            && widget->property("text").toString().isEmpty()
            && !qobject_cast<QAbstractItemView *>(widget->parentWidget()))
            QFAIL(widget->metaObject()->className());
    }
    auto &name = bench.named<QLineEdit>("Name");
    name.setFocus();
    std::set<QWidget *> reached;
    for (int i = 0; i < 80; ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        reached.insert(QApplication::focusWidget());
    }
    for (const char *field : {"Firmware file", "First number to give", "To", "Duty at most, 0 to 1"})
        QVERIFY2(reached.count(&bench.named<QLineEdit>(field)) == 1, field);
    QVERIFY(reached.count(&bench.accept()) == 1);
}

MB_WINDOW_TEST(RecipeEditorTest);
#include "tst_recipeeditor.moc"
