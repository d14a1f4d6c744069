// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/busbar.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/searchfield.h"
#include "widgets/common/segmented.h"
#include "widgets/common/wraplayout.h"

#include <QLabel>
#include <QMenu>
#include <QShortcut>
#include <QWhatsThis>

#include <algorithm>
#include <array>

namespace mb {
namespace {

constexpr int foldedBelow = 560; ///< units
constexpr int sendWholeFrom = 1100;
constexpr int leastFilter = 110;
constexpr int usualFilter = 160;

} // namespace

BusBar::BusBar(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    auto *column = new QVBoxLayout(this);
    const int edge = theme.theme().u(12);
    column->setContentsMargins(edge, theme.theme().u(8), edge, theme.theme().u(8));
    column->setSpacing(theme.theme().u(6));
    buildState(*column);
    buildFilter(*column);
    m_problem = textLabel({}, TextRole::Body, Tone::Danger, this);
    m_problem->setWordWrap(true);
    m_problem->hide();
    column->addWidget(m_problem);
}

void BusBar::buildState(QVBoxLayout &column)
{
    auto *row = new WrapLayout;
    m_links = new Segmented(tr("Link"), this);
    m_links->hide();
    m_state = new QLabel(this);
    m_state->setTextFormat(Qt::RichText);
    setTone(*m_state, Tone::Dim);
    row->addWidget(m_links);
    row->addWidget(m_state);
    row->addSpring();
    m_pause = new CommandButton(m_theme, Symbol::Pause, tr("Pause"), this);
    m_pause->setTextVariants({tr("Pause"), tr("Go on")});
    m_pause->setKeyHint(QStringLiteral("P"));
    m_pause->setToolTip(tr("Holds the frames still; everything is counted and kept meanwhile"));
    auto *clear = new IconButton(m_theme, Symbol::Delete, tr("Clear the list"), this);
    auto *save = new IconButton(m_theme, Symbol::Export, tr("Export frames"), this);
    save->setPopupMode(QToolButton::InstantPopup);
    auto *menu = new QMenu(save);
    menu->addAction(tr("Frames that are shown…"), this, [this] { Q_EMIT exportRequested(false); });
    menu->addAction(tr("All frames that are kept…"), this, [this] { Q_EMIT exportRequested(true); });
    save->setMenu(menu);
    m_send = new CommandButton(m_theme, Symbol::FrameSend, tr("Send frame…"), this);
    m_send->setCheckable(true);
    auto *extra = new QWidget(this);
    m_extra = layoutIn<QHBoxLayout>(extra);
    row->addWidget(extra);
    for (QWidget *button : std::initializer_list<QWidget *>{m_pause, clear, save, m_send})
        row->addWidget(button);
    column.addLayout(row);
    connect(m_links, &Segmented::currentChanged, this, &BusBar::linkChosen);
    connect(m_pause, &QPushButton::clicked, this, &BusBar::pauseRequested);
    connect(clear, &QToolButton::clicked, this, &BusBar::clearRequested);
    connect(m_send, &QPushButton::toggled, this, &BusBar::sendToggled);
}

void BusBar::buildFilter(QVBoxLayout &column)
{
    auto *row = new WrapLayout;
    row->setSpacing(m_theme.theme().u(8));
    m_mode = new Segmented(tr("What the expression does"), {tr("Filter"), tr("Find")}, this);
    m_mode->setToolTip(tr("Filter hides what does not match; Find marks what does, Enter goes to the next"));
    m_filter = new SearchField(m_theme, tr("such as message:STS* device:5 not is:error"), this);
    m_filter->setSymbol(Symbol::Filter);
    m_filter->setKeyHint(QStringLiteral("Ctrl+F"));
    m_filter->setAccessibleName(tr("Filter frames"));
    m_filter->setToolTip(FrameFilter::help());
    auto *help = new IconButton(m_theme, Symbol::Help, tr("How to write a filter"), this);
    m_direction = new Segmented(tr("Direction"), {tr("All"), tr("rx"), tr("tx"), tr("errors")}, this);
    row->addWidget(m_mode);
    row->addWidget(m_filter);
    row->setStretched(m_filter);
    row->addWidget(help);
    row->addWidget(m_direction);
    column.addLayout(row);
    connect(help, &QToolButton::clicked, this, [this] {
        QWhatsThis::showText(m_filter->mapToGlobal(QPoint(0, m_filter->height())), FrameFilter::help(), m_filter);
    });
    connect(m_filter, &QLineEdit::textChanged, this, &BusBar::applyFilter);
    connect(m_filter, &QLineEdit::returnPressed, this, [this] { Q_EMIT findRequested(true); });
    connect(m_mode, &Segmented::currentChanged, this, &BusBar::applyFilter);
    connect(m_direction, &Segmented::currentChanged, this, &BusBar::applyFilter);
}

/// The choices fold to lists where they would take lines of the table.
void BusBar::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    const bool narrow = width() < m_theme.theme().u(foldedBelow);
    for (Segmented *choice : {m_links, m_mode, m_direction})
        choice->setFolded(narrow);
    m_filter->setMinimumWidth(m_theme.theme().u(narrow ? leastFilter : usualFilter));
    m_pause->setIconOnly(narrow);
    m_send->setIconOnly(width() < m_theme.theme().u(sendWholeFrom)); // alone in a line it would take one of the table
}

void BusBar::applyFilter()
{
    static const std::array<QString, 4> directions{
        QString(), QStringLiteral("is:rx not is:error"), QStringLiteral("is:tx"), QStringLiteral("is:error")};
    const FrameFilter typed(m_filter->text());
    m_problem->setText(typed.problem());
    m_problem->setVisible(!typed.problem().isEmpty());
    setStyleProperty(*m_filter, "state", typed.problem().isEmpty() ? QString() : QStringLiteral("error"));
    if (!typed.problem().isEmpty())
        return; // what was understood before goes on
    const FrameFilter side(directions.at(static_cast<std::size_t>(std::clamp(m_direction->current(), 0, 3))));
    const bool finds = m_mode->current() == 1;
    m_filter->setSymbol(finds ? Symbol::Search : Symbol::Filter);
    Q_EMIT filterChanged(finds ? side : FrameFilter::both(typed, side), finds ? typed : FrameFilter());
}

void BusBar::setLinks(const QStringList &names, int current)
{
    const QSignalBlocker quiet(m_links);
    while (m_links->count() < names.size())
        m_links->addSegment(names[m_links->count()]);
    while (m_links->count() > names.size())
        m_links->removeLast();
    for (int i = 0; i < names.size(); ++i)
        m_links->setText(i, names[i]);
    if (current >= 0)
        m_links->setCurrent(current);
    m_links->setVisible(names.size() > 1);
}

void BusBar::setSendable(bool sendable)
{
    m_send->setEnabled(sendable);
    m_send->setChecked(m_send->isChecked() && sendable);
}

void BusBar::addButton(QWidget &button)
{
    m_extra->addWidget(&button);
}

void BusBar::setState(const QString &richText)
{
    if (m_state->text() != richText)
        m_state->setText(richText);
}

void BusBar::setPaused(bool paused)
{
    m_pause->setText(paused ? tr("Go on") : tr("Pause"));
    m_pause->setSymbol(paused ? Symbol::Play : Symbol::Pause);
}

void BusBar::setResult(const QString &result)
{
    m_filter->setResult(result);
}

void BusBar::setSendShown(bool shown)
{
    m_send->setChecked(shown);
}

void BusBar::setFilterText(const QString &text)
{
    m_filter->setText(text);
}

void BusBar::focusFilter()
{
    m_filter->setFocus();
    m_filter->selectAll();
}

} // namespace mb
