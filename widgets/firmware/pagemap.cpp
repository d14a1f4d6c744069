// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/pagemap.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace mb {
namespace {

constexpr double cellWidth = 34;
constexpr double cellHeight = 26;
constexpr double gap = 4;

} // namespace

PageMap::PageMap(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setAccessibleName(tr("Flash pages"));
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    connect(&theme, &ThemeSource::changed, this, qOverload<>(&QWidget::update));
}

void PageMap::setParts(std::vector<int> parts, std::optional<int> critical)
{
    m_parts = std::move(parts);
    m_critical = critical;
    m_states.clear();
    m_repeated.clear();
    setAccessibleDescription({});
    setMinimumHeight(heightForWidth(width()));
    updateGeometry();
    update();
}

void PageMap::setStates(const std::map<int, PartState> &states)
{
    if (states == m_states)
        return;
    if (states.empty())
        m_repeated.clear();
    for (const auto &[part, state] : states) {
        if (state == PartState::Repeated)
            m_repeated[part] = true;
    }
    m_states = states;
    const auto done = std::ranges::count_if(states, [&](const auto &entry) { return entry.second == PartState::Done; });
    setAccessibleDescription(tr("%1 of %2 pages written").arg(done).arg(m_parts.size()));
    update();
}

int PageMap::columns(int width) const
{
    const Theme &theme = m_theme.theme();
    return std::max(1, (width + theme.u(gap)) / (theme.u(cellWidth) + theme.u(gap)));
}

int PageMap::heightForWidth(int width) const
{
    const int count = columns(width);
    const int rows = (static_cast<int>(m_parts.size()) + count - 1) / count;
    return rows * (m_theme.theme().u(cellHeight) + m_theme.theme().u(gap));
}

QSize PageMap::sizeHint() const
{
    const int width = 8 * (m_theme.theme().u(cellWidth) + m_theme.theme().u(gap));
    return {width, heightForWidth(width)};
}

QRectF PageMap::cell(std::size_t place) const
{
    const Theme &theme = m_theme.theme();
    const int count = columns(width());
    const int row = static_cast<int>(place) / count;
    const int column = static_cast<int>(place) % count;
    return {column * (theme.u(cellWidth) + theme.u(gap)) + 0.5, row * (theme.u(cellHeight) + theme.u(gap)) + 0.5,
        theme.u(cellWidth) - 1.0, theme.u(cellHeight) - 1.0};
}

PartState PageMap::stateOf(int part) const
{
    const auto state = m_states.find(part);
    return state == m_states.end() ? PartState::Waiting : state->second;
}

void PageMap::paintCell(QPainter &painter, std::size_t place) const
{
    const Theme &theme = m_theme.theme();
    const int part = m_parts[place];
    const PartState state = stateOf(part);
    const bool critical = mustNotCut(part);
    QColor fill = theme.control;
    QColor text = theme.dim;
    QPen edge(theme.line, 1);
    switch (state) {
    case PartState::Done:
        fill = theme.ok;
        text = theme.dark ? theme.onArmed : theme.onFill;
        break;
    case PartState::Active:
    case PartState::Repeated:
        fill = theme.accent;
        text = theme.dark ? theme.onArmed : theme.onFill;
        break;
    case PartState::Absent:
        fill = Qt::transparent;
        edge = QPen(theme.outline, 1, Qt::DashLine);
        break;
    case PartState::Waiting: break;
    }
    if (m_repeated.count(part) > 0)
        edge = QPen(theme.caution, 2);
    if (critical)
        edge = QPen(theme.danger, 2);
    painter.setPen(edge);
    painter.setBrush(fill);
    painter.drawRoundedRect(cell(place), theme.u(2), theme.u(2));
    painter.setPen(critical && state == PartState::Waiting ? theme.danger : text);
    painter.drawText(cell(place), Qt::AlignCenter, QString::number(part));
}

void PageMap::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(m_theme.theme().font(TextRole::Caption, font()));
    for (std::size_t i = 0; i < m_parts.size(); ++i)
        paintCell(painter, i);
}

QString PageMap::word(int part) const
{
    const QString critical = mustNotCut(part) ? tr(" · must not be interrupted") : QString();
    switch (stateOf(part)) {
    case PartState::Waiting: return tr("page %1: waiting").arg(part) + critical;
    case PartState::Active: return tr("page %1: being written").arg(part) + critical;
    case PartState::Done:
        return (m_repeated.count(part) > 0 ? tr("page %1: written after it was sent again") : tr("page %1: written"))
            .arg(part);
    case PartState::Repeated: return tr("page %1: sent again").arg(part) + critical;
    case PartState::Absent: return tr("page %1: not in the image").arg(part);
    }
    return {};
}

bool PageMap::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
        if (cell(i).contains(help->pos())) {
            QToolTip::showText(help->globalPos(), word(m_parts[i]), this);
            return true;
        }
    }
    QToolTip::hideText();
    return true;
}

} // namespace mb
