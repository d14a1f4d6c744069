// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/keybook.h"

#include <QCoreApplication>

#include <algorithm>

namespace mb {
namespace {

struct KeyWords {
    Q_DECLARE_TR_FUNCTIONS(mb::KeyBook)
};

/// Keys that move between controls and in them, whatever Shift says.
constexpr Qt::Key moving[] = {Qt::Key_Tab, Qt::Key_Backtab, Qt::Key_Return, Qt::Key_Enter, Qt::Key_Left, Qt::Key_Right,
    Qt::Key_Up, Qt::Key_Down, Qt::Key_Home, Qt::Key_End, Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Backspace,
    Qt::Key_Delete, Qt::Key_Space};

Qt::Key bare(const QKeySequence &key)
{
    return static_cast<Qt::Key>(key[0] & ~static_cast<int>(Qt::KeyboardModifierMask));
}

bool has(const std::vector<QKeySequence> &keys, const QKeySequence &key)
{
    return std::ranges::find(keys, key) != keys.end();
}

} // namespace

void KeyBook::add(const QString &place, bool everywhere, const PageKeys &keys)
{
    for (const PageKeys::Row &row : keys.rows())
        m_rows.push_back({place, everywhere, keys.idOf(row), row.does, row.factory, row.keys, row.isChangeable()});
}

QString KeyBook::refusal(std::size_t row, const QKeySequence &key) const
{
    if (!m_rows[row].changeable)
        return KeyWords::tr("This key cannot be changed.");
    if (key.isEmpty())
        return {};
    const QString text = key.toString(QKeySequence::NativeText);
    const QKeySequence taken
        = bare(key) == Qt::Key_Space ? QKeySequence(Qt::Key_Space) : key; // it stops with Shift, too
    if (bare(key) == Qt::Key_Escape || bare(key) == Qt::Key_Pause)
        return KeyWords::tr("%1 stops every motor, always.").arg(text);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const Row &other = m_rows[i];
        const bool together = other.everywhere || m_rows[row].everywhere || other.place == m_rows[row].place;
        if (i != row && together && has(other.keys, taken))
            return KeyWords::tr("%1 is taken, %2: %3. Give that another key first.").arg(text, other.place, other.does);
    }
    constexpr int modified = static_cast<int>(Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
    const bool moves = std::find(std::begin(moving), std::end(moving), bare(key)) != std::end(moving);
    if (moves && (key[0] & modified) == 0)
        return KeyWords::tr("%1 belongs to the control that has the focus.").arg(text);
    return {};
}

bool KeyBook::choose(std::size_t row, const QKeySequence &key)
{
    if (!refusal(row, key).isEmpty())
        return false;
    m_rows[row].keys.clear();
    if (!key.isEmpty())
        m_rows[row].keys.push_back(key);
    return true;
}

QString KeyBook::reset(std::size_t row)
{
    for (const QKeySequence &key : m_rows[row].factory) {
        if (const QString why = refusal(row, key);
            !why.isEmpty() && m_rows[row].changeable && !has(m_rows[row].keys, key))
            return why;
    }
    m_rows[row].keys = m_rows[row].factory;
    return {};
}

void KeyBook::resetAll()
{
    for (Row &row : m_rows)
        row.keys = row.factory;
}

KeyChoices KeyBook::choices() const
{
    KeyChoices choices;
    for (const Row &row : m_rows) {
        if (row.changeable && row.keys != row.factory)
            choices[row.id] = row.keys;
    }
    return choices;
}

void KeyBook::take(const KeyChoices &choices)
{
    resetAll();
    const auto chosenFor = [&choices](const Row &row) { return choices.find(row.id); };
    for (Row &row : m_rows) { // first what goes, so that two rows may have changed their keys
        if (row.changeable && chosenFor(row) != choices.end())
            row.keys.clear();
    }
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const auto chosen = chosenFor(m_rows[i]);
        if (!m_rows[i].changeable || chosen == choices.end())
            continue;
        const QKeySequence key = chosen->second.empty() ? QKeySequence() : chosen->second.front();
        if (!choose(i, key))
            m_rows[i].keys = m_rows[i].factory;
    }
}

} // namespace mb
