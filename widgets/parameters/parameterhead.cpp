// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameterhead.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/wraplayout.h"

#include <QMenu>
#include <QUndoStack>

#include <algorithm>

namespace mb {

ParameterHead::ParameterHead(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    build();
    connect(m_undo, &QToolButton::clicked, this, [this] { Q_EMIT undoRequested(false); });
    connect(m_redo, &QToolButton::clicked, this, [this] { Q_EMIT undoRequested(true); });
    connect(m_read, &QPushButton::clicked, this, &ParameterHead::readRequested);
    connect(m_import, &QPushButton::clicked, this, &ParameterHead::importRequested);
    connect(m_export, &QPushButton::clicked, this, &ParameterHead::exportRequested);
    connect(m_snapshot, &QPushButton::clicked, this, &ParameterHead::snapshotRequested);
    connect(m_history, &QPushButton::toggled, this, &ParameterHead::historyToggled);
    connect(m_menu, &QMenu::aboutToShow, this, &ParameterHead::fillMenu);
    setRoom(HeadRoom::Words);
}

void ParameterHead::build()
{
    m_row = new WrapLayout(this);
    m_status = new ReadStatus(m_theme, this);
    m_undo = new IconButton(m_theme, Symbol::Undo, tr("Undo the last edit or write"), this);
    m_undo->setKeyHint(QStringLiteral("Ctrl+Z"));
    m_redo = new IconButton(m_theme, Symbol::Redo, tr("Redo the edit or write"), this);
    m_redo->setKeyHint(QStringLiteral("Ctrl+Y"));
    m_read = new CommandButton(m_theme, Symbol::Refresh, tr("Read all"), this);
    m_read->setKeyHint(QStringLiteral("F5"));
    m_import = new CommandButton(m_theme, Symbol::Import, tr("Import…"), this);
    m_export = new CommandButton(m_theme, Symbol::Export, tr("Export…"), this);
    m_snapshot = new CommandButton(m_theme, Symbol::Camera, tr("Snapshot"), this);
    m_snapshot->setKeyHint(QStringLiteral("Ctrl+Shift+S"));
    m_history = new CommandButton(m_theme, Symbol::Clock, tr("History"), this);
    m_history->setKeyHint(QStringLiteral("Ctrl+H"));
    m_history->setCheckable(true);
    m_more = new IconButton(m_theme, Symbol::More, tr("More for the parameters"), this);
    m_menu = new QMenu(m_more);
    m_more->setMenu(m_menu);
    m_more->setPopupMode(QToolButton::InstantPopup);
    m_row->addWidget(m_status);
    m_row->addSpring();
    for (QWidget *widget :
        std::initializer_list<QWidget *>{m_undo, m_redo, m_read, m_import, m_export, m_snapshot, m_history, m_more})
        m_row->addWidget(widget);
}

void ParameterHead::setRoom(HeadRoom room)
{
    const Theme &t = m_theme.theme();
    const bool folded = room == HeadRoom::Menu;
    m_row->setContentsMargins(folded ? QMargins() : QMargins(t.u(12), t.u(8), t.u(12), t.u(4)));
    m_row->setSpacing(room == HeadRoom::Words ? 8 : t.u(4));
    m_status->setVisible(!folded);
    m_more->setVisible(folded);
    m_read->setIconOnly(room != HeadRoom::Words);
    for (CommandButton *button : inMenu()) {
        button->setIconOnly(room != HeadRoom::Words);
        button->setVisible(!folded);
    }
}

int ParameterHead::wordsWidth() const
{
    const int gap = 8;
    const int margins = m_theme.theme().u(24);
    int width = m_status->sizeHint().width() + m_undo->sizeHint().width() + m_redo->sizeHint().width() + 2 * gap;
    width += m_read->wordsSize().width() + gap;
    for (const CommandButton *button : inMenu())
        width += button->wordsSize().width() + gap;
    return width + margins;
}

/// What the buttons are that it stands for.
void ParameterHead::fillMenu()
{
    m_menu->clear();
    for (CommandButton *button : inMenu()) {
        const QString key = button->keyHint();
        QAction *action = m_menu->addAction(
            key.isEmpty() ? button->text() : button->text() + QLatin1Char('\t') + key, button, &QPushButton::click);
        action->setEnabled(button->isEnabled());
        action->setCheckable(button->isCheckable());
        action->setChecked(button->isChecked());
    }
    Q_EMIT menuFilled(m_menu);
}

void ParameterHead::showDevice(
    const DeviceView &device, const OperationView *operation, const ParameterCounts &counts, const QUndoStack &edits)
{
    m_status->showDevice(device, operation, counts);
    enable(&device, device.liveness.heard && !isUnderWay(operation), edits);
}

void ParameterHead::showFile(const QString &name, const QString &family, const QUndoStack &edits)
{
    m_status->showFile(name, family);
    enable(nullptr, false, edits);
}

void ParameterHead::enable(const DeviceView *device, bool free, const QUndoStack &edits)
{
    m_undo->setEnabled(free || edits.canUndo());
    m_redo->setEnabled(free || edits.canRedo());
    m_read->setEnabled(free);
    m_snapshot->setEnabled(free);
    m_history->setEnabled(device != nullptr);
    m_import->setEnabled(device != nullptr);
    m_export->setEnabled(device
        && std::any_of(device->parameters->begin(), device->parameters->end(),
            [](const auto &entry) { return entry.raw.has_value(); }));
}

bool ParameterHead::isHistoryChosen() const
{
    return m_history->isChecked();
}

void ParameterHead::chooseHistory(bool on)
{
    m_history->setChecked(on);
}

} // namespace mb
