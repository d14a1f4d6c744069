// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/keyspanel.h"

#include "widgets/common/labels.h"
#include "widgets/common/spoken.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace mb {
namespace {

constexpr int rowRole = Qt::UserRole;
constexpr int rowsSeen = 12;

enum Column { Does, Key };

QString textOf(const std::vector<QKeySequence> &keys)
{
    QStringList texts;
    for (const QKeySequence &key : keys)
        texts << key.toString(QKeySequence::NativeText);
    return texts.join(QStringLiteral(", "));
}

bool isModifier(int key)
{
    return key == Qt::Key_Control || key == Qt::Key_Shift || key == Qt::Key_Alt || key == Qt::Key_AltGr
        || key == Qt::Key_Meta || key == Qt::Key_unknown || key == 0;
}

/// What the form needs itself.
bool passes(const QKeyEvent &key)
{
    const bool plain = (key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == 0;
    return plain
        && (key.key() == Qt::Key_Tab || key.key() == Qt::Key_Backtab || key.key() == Qt::Key_Return
            || key.key() == Qt::Key_Enter || key.key() == Qt::Key_Escape);
}

} // namespace

KeyField::KeyField(QWidget *parent)
    : QLineEdit(parent)
{
    setReadOnly(true);
    setContextMenuPolicy(Qt::NoContextMenu);
    setPlaceholderText(tr("Press the new key here"));
    setAccessibleName(tr("New key"));
}

bool KeyField::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride && !passes(static_cast<QKeyEvent &>(*event))) {
        event->accept(); // it is a key press now, and no shortcut
        return true;
    }
    return QLineEdit::event(event);
}

void KeyField::keyPressEvent(QKeyEvent *event)
{
    if (passes(*event) || isModifier(event->key())) {
        event->ignore();
        return;
    }
    const int modifiers = static_cast<int>(event->modifiers() & ~Qt::KeypadModifier);
    Q_EMIT pressed(QKeySequence(event->key() | modifiers));
}

KeysPanel::KeysPanel(KeyBook book, QWidget *parent)
    : QWidget(parent)
    , m_book(std::move(book))
{
    build();
    fill();
    follow();
}

void KeysPanel::build()
{
    auto *column = new QVBoxLayout(this);
    auto *search = new QLineEdit(this);
    search->setPlaceholderText(tr("Search commands and keys"));
    search->setAccessibleName(search->placeholderText());
    search->setClearButtonEnabled(true);
    m_list = new QTreeWidget(this);
    m_list->setObjectName(QStringLiteral("keyList"));
    m_list->setAccessibleName(tr("Commands and their keys"));
    m_list->setHeaderLabels({tr("Command"), tr("Key")});
    m_list->setRootIsDecorated(false);
    m_list->setItemsExpandable(false);
    m_list->header()->setStretchLastSection(false);
    auto *row = new QHBoxLayout;
    m_field = new KeyField(this);
    m_factory = new QPushButton(tr("Default"), this);
    m_none = new QPushButton(tr("No key"), this);
    auto *all = new QPushButton(tr("All defaults"), this);
    row->addWidget(m_field, 1);
    for (QPushButton *button : {m_factory, m_none, all}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    m_answer = textLabel({}, TextRole::Body, Tone::Dim, this);
    m_answer->setObjectName(QStringLiteral("keyAnswer"));
    m_answer->setWordWrap(true);
    m_answer->setMinimumHeight(2 * m_answer->fontMetrics().lineSpacing());
    column->addWidget(search);
    column->addWidget(m_list, 1);
    column->addLayout(row);
    column->addWidget(m_answer);
    connect(search, &QLineEdit::textChanged, this, &KeysPanel::filter);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &KeysPanel::follow);
    connect(m_field, &KeyField::pressed, this, &KeysPanel::choose);
    connect(m_factory, &QPushButton::clicked, this, &KeysPanel::reset);
    connect(m_none, &QPushButton::clicked, this, [this] { choose({}); });
    connect(all, &QPushButton::clicked, this, [this] {
        m_book.resetAll();
        fill();
        say(tr("All keys are those they came with."), false);
    });
}

void KeysPanel::fill()
{
    const auto &rows = m_book.rows();
    if (m_list->topLevelItemCount() == 0) {
        QTreeWidgetItem *place = nullptr;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (!place || place->text(Does) != rows[i].place) {
                place = new QTreeWidgetItem(m_list, {rows[i].place});
                place->setFlags(Qt::ItemIsEnabled);
                place->setFirstColumnSpanned(true);
            }
            auto *item = new QTreeWidgetItem(place, {rows[i].does});
            item->setData(Does, rowRole, static_cast<int>(i));
            item->setToolTip(Does, rows[i].does);
        }
        m_list->expandAll();
        m_list->header()->setSectionResizeMode(Does, QHeaderView::Stretch);
        m_list->header()->setSectionResizeMode(Key, QHeaderView::ResizeToContents);
        m_list->setMinimumHeight(m_list->sizeHintForRow(0) * rowsSeen);
    }
    for (QTreeWidgetItemIterator it(m_list); *it; ++it) {
        if (!(*it)->parent())
            continue;
        const KeyBook::Row &row = rows[static_cast<std::size_t>((*it)->data(Does, rowRole).toInt())];
        QFont font = m_list->font();
        font.setBold(row.keys != row.factory);
        (*it)->setText(Key, row.keys.empty() ? tr("none") : textOf(row.keys));
        (*it)->setFont(Key, font);
        for (const Column column : {Does, Key}) {
            (*it)->setForeground(
                column, palette().brush(row.changeable ? QPalette::Active : QPalette::Disabled, QPalette::Text));
        }
    }
}

void KeysPanel::filter(const QString &text)
{
    for (int i = 0; i < m_list->topLevelItemCount(); ++i) {
        QTreeWidgetItem *place = m_list->topLevelItem(i);
        int left = 0;
        for (int j = 0; j < place->childCount(); ++j) {
            QTreeWidgetItem *item = place->child(j);
            const bool fits = item->text(Does).contains(text, Qt::CaseInsensitive)
                || item->text(Key).contains(text, Qt::CaseInsensitive)
                || place->text(Does).contains(text, Qt::CaseInsensitive);
            item->setHidden(!fits);
            left += fits ? 1 : 0;
        }
        place->setHidden(left == 0);
    }
}

std::optional<std::size_t> KeysPanel::row() const
{
    const QTreeWidgetItem *item = m_list->currentItem();
    if (!item || !item->parent())
        return std::nullopt;
    return static_cast<std::size_t>(item->data(Does, rowRole).toInt());
}

void KeysPanel::follow()
{
    const auto at = row();
    const KeyBook::Row *chosen = at ? &m_book.rows()[*at] : nullptr;
    const bool mine = chosen && chosen->changeable;
    for (QWidget *part : std::initializer_list<QWidget *>{m_field, m_factory, m_none})
        part->setEnabled(mine);
    m_field->setText(chosen ? textOf(chosen->keys) : QString());
    if (mine)
        say(tr("It came with: %1").arg(textOf(chosen->factory)), false);
    else
        say(chosen ? tr("This key cannot be changed.") : tr("Choose a command, then press its new key in the field."),
            false);
}

void KeysPanel::choose(const QKeySequence &key)
{
    const auto at = row();
    if (!at)
        return;
    const QString why = m_book.refusal(*at, key);
    if (!why.isEmpty())
        return say(why, true);
    m_book.choose(*at, key);
    fill();
    follow();
}

void KeysPanel::reset()
{
    const auto at = row();
    if (!at)
        return;
    if (const QString why = m_book.reset(*at); !why.isEmpty())
        return say(why, true);
    fill();
    follow();
}

void KeysPanel::say(const QString &words, bool refused)
{
    m_answer->setText(words);
    setTone(*m_answer, refused ? Tone::Danger : Tone::Dim);
    if (refused)
        announce(*m_answer, words);
    else
        setSpoken(*m_answer, words, {});
}

} // namespace mb
