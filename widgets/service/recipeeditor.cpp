// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/service/recipeeditor.h"

#include "service/jsonlines.h"
#include "service/recipematter.h"
#include "service/reciperead.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/service/recipeform.h"

#include <QAccessible>
#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QSaveFile>
#include <QScreen>
#include <QScrollArea>
#include <QShortcut>
#include <QTextBlock>

namespace mb {
namespace {

constexpr int editorWidth = 1020; // u
constexpr int editorHeight = 660;
constexpr int widthForBoth = 860; // less: the file stands below the fields
constexpr int screenMargin = 48;  // for the frame
constexpr qint64 mostBytes = 1 << 20;

/// Each line with its number before it, as a mistake names it.
QString numbered(const QByteArray &text)
{
    QString out;
    int line = 0;
    for (const QString &each : QString::fromUtf8(text).trimmed().split(QLatin1Char('\n')))
        out += QStringLiteral("%1  %2\n").arg(++line, 3).arg(each);
    return out.trimmed().isEmpty() ? QString() : out;
}

std::optional<int> lineOf(const Error &error)
{
    static const QRegularExpression line(QStringLiteral("line (\\d+):"));
    const auto found = line.match(QString::fromStdString(error.detail.english()));
    return found.hasMatch() ? std::optional(found.captured(1).toInt()) : std::nullopt;
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
    connect(m_form, &RecipeForm::changed, this, &RecipeEditor::check);
    check();
}

void RecipeEditor::buildBody()
{
    m_body = new QBoxLayout(QBoxLayout::LeftToRight);
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
    m_body->addWidget(scroll, 3);
    m_body->addWidget(m_text, 2);
    static_cast<QVBoxLayout *>(layout())->addLayout(m_body, 1);
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

void RecipeEditor::resizeEvent(QResizeEvent *event)
{
    const bool wide = width() >= m_theme.theme().u(widthForBoth);
    m_body->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    QDialog::resizeEvent(event);
}

Result<void> RecipeEditor::open(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return fail(Fault::OutOfRange, say("%1: %2", path.toStdString(), file.errorString().toStdString()));
    const QByteArray text = file.read(mostBytes);
    const auto recipe = service::parseRecipe(text, m_families);
    if (!recipe)
        return fail(recipe.error().about(path.toStdString()));
    m_path = QFileInfo(path).absoluteFilePath();
    setWindowTitle(tr("Recipe %1").arg(QFileInfo(path).fileName()));
    m_form->setFolder(folder());
    m_form->setText(text);
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
    const auto lines = service::linesOf(text);
    const auto of = [&](service::Recipe part, const char *key) -> std::optional<Error> {
        const auto matter = service::gatherMatter(std::move(part), folder.toStdString());
        if (matter)
            return {};
        Error error = matter.error();
        error.detail = say("line %1: %2", lines.of(key), error.detail);
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
    QList<QTextEdit::ExtraSelection> marks;
    if (const auto line = problem ? lineOf(*problem) : std::nullopt) {
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
    m_words->setText(problem ? errorText(*problem) : QString());
    setTone(*m_words, problem ? Tone::Danger : Tone::Text);
    QAccessibleEvent event(m_words, QAccessible::NameChanged);
    QAccessible::updateAccessibility(&event);
}

QString RecipeEditor::problem() const
{
    return m_words->text();
}

void RecipeEditor::save()
{
    if (!canSave())
        return;
    if (m_path.isEmpty())
        ask();
    else
        saveAs(m_path);
}

void RecipeEditor::ask()
{
    auto *dialog = new QFileDialog(this, tr("Keep the recipe"), m_folder, tr("Recipes (*.json)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("json"));
    connect(dialog, &QFileDialog::fileSelected, this, &RecipeEditor::saveAs);
    dialog->open();
}

bool RecipeEditor::saveAs(const QString &path)
{
    const QByteArray text = m_form->text();
    if (const auto mistake = mistakeIn(text, QFileInfo(path).absolutePath())) {
        speak(mistake); // it may be none in another folder
        return false;
    }
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit()) {
        speak(Error{Fault::OutOfRange, say("%1: %2", path.toStdString(), file.errorString().toStdString()), {}});
        return false;
    }
    m_path = QFileInfo(path).absoluteFilePath();
    setWindowTitle(tr("Recipe %1").arg(QFileInfo(path).fileName()));
    m_form->setFolder(folder());
    tell({});
    Q_EMIT saved(m_path);
    return true;
}

} // namespace mb
