// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/commandpalette.h"

#include "widgets/common/holdbutton.h"
#include "widgets/common/pagekeys.h"

#include <QAbstractButton>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPointer>
#include <QShortcut>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace mb {
namespace {

constexpr int startsWithIt = 3;
constexpr int startsAWord = 2;
constexpr int isOfPlace = 1;
constexpr int widestShare = 2; ///< of the window's width: half
constexpr int rowsSeen = 12;

QString withoutMarks(QString text)
{
    return text.remove(QLatin1Char('&')).remove(QStringLiteral("…")).simplified();
}

/// Whether a word of the text begins so.
bool hasWord(const QString &text, const QString &beginning)
{
    const QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    return std::ranges::any_of(
        words, [&](const QString &word) { return word.startsWith(beginning, Qt::CaseInsensitive); });
}

} // namespace

void addCommands(
    std::vector<Command> &into, const QString &place, const PageKeys &keys, const std::function<void()> &prepare)
{
    for (const PageKeys::Row &row : keys.rows()) {
        if (row.shortcuts.empty())
            continue; // the key is handled elsewhere
        const QPointer<QShortcut> shortcut = row.shortcuts.front();
        QString name = row.does;
        name[0] = name.at(0).toUpper();
        into.push_back({name, place, PageKeys::textOf(row), [shortcut, prepare] {
                            prepare();
                            if (shortcut)
                                Q_EMIT shortcut->activated();
                        }});
    }
}

void addCommands(std::vector<Command> &into, const QString &place, const QMenu &menu)
{
    for (QAction *action : menu.actions()) {
        if (action->isSeparator() || !action->isEnabled())
            continue;
        if (action->menu()) {
            addCommands(into, withoutMarks(action->text()), *action->menu());
            continue;
        }
        const QPointer<QAction> pointed = action;
        into.push_back(
            {withoutMarks(action->text()), place, action->shortcut().toString(QKeySequence::NativeText), [pointed] {
                 if (pointed)
                     pointed->trigger();
             }});
    }
}

void addButtons(std::vector<Command> &into, const QString &place, const QWidget &page)
{
    for (QAbstractButton *button : page.findChildren<QAbstractButton *>()) {
        const auto *held
            = qobject_cast<const HoldButton *>(button); // on purpose, as the arm button, which takes no focus
        if (!button->isVisible() || !button->isEnabled() || button->focusPolicy() == Qt::NoFocus
            || (held && held->isHoldNeeded()))
            continue;
        const QString name
            = withoutMarks(button->accessibleName().isEmpty() ? button->text() : button->accessibleName());
        if (name.isEmpty())
            continue;
        const QPointer<QAbstractButton> pointed = button;
        into.push_back({name, place, {}, [pointed] {
                            if (pointed && pointed->isEnabled())
                                pointed->click();
                        }});
    }
}

int matchOf(const Command &command, const QString &typed)
{
    const QStringList words = typed.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    int best = isOfPlace;
    for (const QString &word : words) {
        if (hasWord(command.name, word))
            best = std::max(best, startsAWord);
        else if (!hasWord(command.place, word))
            return 0;
    }
    return command.name.startsWith(typed.simplified(), Qt::CaseInsensitive) ? startsWithIt : best;
}

CommandPalette::CommandPalette(std::vector<Command> commands, QWidget *parent)
    : QDialog(parent)
    , m_commands(std::move(commands))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName(QStringLiteral("commands"));
    setWindowTitle(tr("Commands"));
    auto *column = new QVBoxLayout(this);
    m_text = new QLineEdit(this);
    m_text->setAccessibleName(tr("Command"));
    m_text->setPlaceholderText(tr("Type what you want to do"));
    m_text->setClearButtonEnabled(true);
    m_text->installEventFilter(this);
    m_list = new QListWidget(this);
    m_list->setAccessibleName(tr("Commands"));
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setTextElideMode(Qt::ElideRight);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    column->addWidget(m_text);
    column->addWidget(m_list, 1);
    connect(m_text, &QLineEdit::textChanged, this, &CommandPalette::list);
    connect(m_text, &QLineEdit::returnPressed, this, [this] { run(m_list->currentItem()); });
    connect(m_list, &QListWidget::itemClicked, this, &CommandPalette::run);
    list({});
    ensurePolished();
    m_list->ensurePolished(); // a row is as high as the style sheet says
    const QMargins margins = column->contentsMargins();
    const int rows = std::max(m_list->sizeHintForRow(0), 1) * rowsSeen + 2 * m_list->frameWidth();
    resize(parent->width() / widestShare,
        margins.top() + m_text->sizeHint().height() + column->spacing() + rows + margins.bottom());
}

bool CommandPalette::eventFilter(QObject *watched, QEvent *event)
{
    if (watched != m_text || event->type() != QEvent::KeyPress)
        return QDialog::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent *>(event)->key();
    const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
    if (step == 0 || !m_list->currentItem())
        return QDialog::eventFilter(watched, event);
    m_list->setCurrentRow(std::clamp(m_list->currentRow() + step, 0, m_list->count() - 1));
    return true;
}

void CommandPalette::list(const QString &typed)
{
    std::vector<std::pair<int, int>> found; // how well, which
    for (std::size_t i = 0; i < m_commands.size(); ++i) {
        if (const int match = matchOf(m_commands[i], typed); match > 0)
            found.emplace_back(-match, static_cast<int>(i));
    }
    std::ranges::sort(found);
    m_list->clear();
    for (const auto &[match, place] : found) {
        const Command &command = m_commands[static_cast<std::size_t>(place)];
        QString text = tr("%1: %2", "page: command").arg(command.place, command.name);
        if (!command.key.isEmpty())
            text += QStringLiteral("   ") + command.key;
        auto *item = new QListWidgetItem(text, m_list);
        item->setData(Qt::UserRole, place);
    }
    if (found.empty()) {
        auto *item = new QListWidgetItem(tr("No command begins so"), m_list);
        item->setFlags(Qt::NoItemFlags);
        return;
    }
    m_list->setCurrentRow(0);
}

/// After this dialog has gone: the command may open one of its own.
void CommandPalette::run(const QListWidgetItem *item)
{
    if (!item || !(item->flags() & Qt::ItemIsSelectable))
        return;
    const auto order = m_commands[static_cast<std::size_t>(item->data(Qt::UserRole).toInt())].run;
    close();
    QTimer::singleShot(0, parentWidget(), order);
}

} // namespace mb
