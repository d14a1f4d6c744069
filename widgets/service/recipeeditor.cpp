// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/service/recipeeditor.h"

#include "files/filebytes.h"
#include "files/jsonlines.h"
#include "service/recipematter.h"
#include "service/reciperead.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/spoken.h"
#include "widgets/common/turningrow.h"
#include "widgets/service/recipeform.h"

#include <QDir>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QShortcut>
#include <QTextBlock>

namespace mb {
namespace {

constexpr int editorWidth = 1020; // u
constexpr int editorHeight = 660;
constexpr int widthForBoth = 836; // less: the file stands below the fields
constexpr int screenMargin = 48;  // for the frame
constexpr std::int64_t mostBytes = 1 << 20;

/// Each line with its number before it, as a mistake names it.
QString numbered(const QByteArray &text)
{
    QString out;
    int line = 0;
    for (const QString &each : QString::fromUtf8(text).trimmed().split(QLatin1Char('\n')))
        out += QStringLiteral("%1  %2\n").arg(++line, 3).arg(each);
    return out.trimmed().isEmpty() ? QString() : out;
}

} // namespace

RecipeEditor::RecipeEditor(
    std::span<const Family *const> families, const QString &folder, const ThemeSource &theme, QWidget *parent)
    : QDialog(parent)
    , m_families(families)
    , m_theme(theme)
    , m_folder(folder)
{
    setObjectName(QStringLiteral("recipeEditor"));
    setWindowTitle(tr("New recipe"));
    setModal(false);
    resize(QSize(theme.theme().u(editorWidth), theme.theme().u(editorHeight))
               .boundedTo(
                   screen()->availableSize() - QSize(theme.theme().u(screenMargin), theme.theme().u(screenMargin))));
    auto *column = new QVBoxLayout(this);
    column->setSpacing(theme.theme().u(12));
    buildBody();
    buildFoot();
    m_form->setFolder(folder);
    m_kept = m_form->text();
    connect(m_form, &RecipeForm::changed, this, &RecipeEditor::check);
    check();
}

void RecipeEditor::buildBody()
{
    auto *body = new TurningRow(m_theme, widthForBoth, this);
    auto *scroll = new QScrollArea(this);
    scroll->setAccessibleName(tr("Fields of the recipe"));
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(m_form = new RecipeForm(m_families, m_theme, scroll));
    m_text = new QPlainTextEdit(this);
    m_text->setAccessibleName(tr("The file that is saved, line by line"));
    m_text->setReadOnly(true);
    m_text->setTabChangesFocus(true);
    m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_text->setFont(m_theme.theme().font(TextRole::Raw, font()));
    body->parts().addWidget(scroll, 3);
    body->parts().addWidget(m_text, 2);
    static_cast<QVBoxLayout *>(layout())->addWidget(body, 1);
}

void RecipeEditor::buildFoot()
{
    m_words = textLabel({}, TextRole::Emphasis, Tone::Text, this);
    m_words->setAccessibleName(tr("What is wrong with the recipe"));
    m_words->setWordWrap(true);
    auto *close = new CommandButton(m_theme, tr("Close"), this);
    m_save = new CommandButton(m_theme, Symbol::Save, tr("Save recipe"), this);
    m_save->setPrimary(true);
    m_save->setKeyHint(QStringLiteral("Ctrl+S"));
    for (CommandButton *const button : {close, m_save})
        button->setAutoDefault(false);
    auto *row = new QHBoxLayout;
    row->addWidget(m_words, 1);
    row->addWidget(close);
    row->addWidget(m_save);
    static_cast<QVBoxLayout *>(layout())->addLayout(row);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_save, &QPushButton::clicked, this, &RecipeEditor::save);
    connect(new QShortcut(QKeySequence::Save, this), &QShortcut::activated, this, &RecipeEditor::save);
}

void RecipeEditor::changeEvent(QEvent *event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::StyleChange && m_text) // another theme
        mark();
}

bool RecipeEditor::isUnsaved() const
{
    return m_form->text() != m_kept;
}

void RecipeEditor::reject()
{
    if (!isUnsaved())
        QDialog::reject();
    else if (m_question)
        m_question->raise();
    else
        askToDiscard();
}

void RecipeEditor::askToDiscard()
{
    m_question = new QMessageBox(
        QMessageBox::Warning, windowTitle(), tr("This recipe is not saved."), QMessageBox::NoButton, this);
    m_question->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton *const leave = m_question->addButton(tr("Discard it"), QMessageBox::DestructiveRole);
    QPushButton *const stay = m_question->addButton(tr("Go on writing"), QMessageBox::RejectRole);
    for (QPushButton *const button : {leave, stay})
        button->setAccessibleName(button->text());
    m_question->setDefaultButton(stay);
    m_question->setEscapeButton(stay);
    connect(leave, &QPushButton::clicked, this, [this] { QDialog::reject(); });
    m_question->setModal(false); // STOP of the window behind can still be clicked
    m_question->show();
}

Result<void> RecipeEditor::openFile(const QString &path)
{
    MB_TRY(const auto text, loadFile(path.toStdString(), mostBytes));
    const auto recipe = service::parseRecipe(text, m_families);
    if (!recipe)
        return fail(recipe.error().about(path.toStdString()));
    m_path = QFileInfo(path).absoluteFilePath();
    setWindowTitle(tr("Recipe %1").arg(QFileInfo(path).fileName()));
    m_form->setFolder(folder());
    m_form->setText(text);
    m_kept = m_form->text();
    return {};
}

QString RecipeEditor::folder() const
{
    return m_path.isEmpty() ? m_folder : QFileInfo(m_path).absolutePath();
}

/// The first mistake: of the text, then of each file that it names, with the line that names it.
std::optional<Error> RecipeEditor::mistakeIn(const QByteArray &text, const QString &folder) const
{
    const auto recipe = service::parseRecipe(text, m_families);
    if (!recipe)
        return recipe.error();
    const auto lines = linesOf(text);
    const auto of = [&](service::Recipe part, const char *key) -> std::optional<Error> {
        const auto matter = service::gatherMatter(std::move(part), folder.toStdString());
        if (matter)
            return {};
        Error error = matter.error();
        error.detail = atLine(lines.of(key), error.detail);
        return error;
    };
    service::Recipe firmware = *recipe;
    firmware.parameters.reset();
    if (auto error = of(std::move(firmware), "firmware.file"))
        return error;
    return of(*recipe, "parameters.file");
}

void RecipeEditor::check()
{
    const QByteArray text = m_form->text();
    m_text->setPlainText(numbered(text));
    tell(mistakeIn(text, folder()));
}

void RecipeEditor::tell(const std::optional<Error> &problem)
{
    m_problem = problem;
    speak(problem);
    m_save->setEnabled(!problem);
    mark();
}

void RecipeEditor::mark()
{
    QList<QTextEdit::ExtraSelection> marks;
    if (const auto line = m_problem && !isUntouched() ? lineOf(m_problem->detail) : std::nullopt) {
        QTextEdit::ExtraSelection mark;
        mark.cursor = QTextCursor(m_text->document()->findBlockByNumber(*line - 1));
        mark.format.setProperty(QTextFormat::FullWidthSelection, true);
        mark.format.setForeground(m_theme.theme().tone(Tone::Danger));
        mark.format.setFontWeight(QFont::Bold);
        m_text->setTextCursor(mark.cursor);
        marks << mark;
    }
    m_text->setExtraSelections(marks);
}

void RecipeEditor::speak(const std::optional<Error> &problem)
{
    const bool untouched = problem && isUntouched(); // nobody has made a mistake yet
    m_words->setText(untouched ? tr("Give the recipe a name.") : problem ? errorText(*problem) : QString());
    setTone(*m_words, untouched ? Tone::Dim : problem ? Tone::Danger : Tone::Text);
    setSpoken(*m_words, problem ? m_words->text() : tr("No mistake in the recipe"), {});
}

QString RecipeEditor::problem() const
{
    return m_words->text();
}

void RecipeEditor::save()
{
    m_tried = true;
    if (!canSave())
        return tell(m_problem);
    if (m_path.isEmpty())
        ask();
    else
        saveAs(m_path);
}

void RecipeEditor::ask()
{
    askWhereToSave(
        *this, tr("Keep the recipe"), tr("Recipes (*.json)"), m_folder, [this](const QString &path) { saveAs(path); });
}

bool RecipeEditor::saveAs(const QString &path)
{
    const QByteArray text = m_form->text();
    if (const auto mistake = mistakeIn(text, QFileInfo(path).absolutePath())) {
        speak(mistake); // it may be none in another folder
        return false;
    }
    if (const auto written = saveFile(path.toStdString(), text); !written) {
        speak(written.error());
        return false;
    }
    m_kept = text;
    m_path = QFileInfo(path).absoluteFilePath();
    setWindowTitle(tr("Recipe %1").arg(QFileInfo(path).fileName()));
    m_form->setFolder(folder());
    tell({});
    if (m_question)
        m_question->close(); // nothing would be lost any more
    Q_EMIT saved(m_path);
    return true;
}

} // namespace mb
