// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/headerbar.h"

#include "widgets/common/icons.h"
#include "widgets/common/spoken.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>
#include <QStyleOptionToolButton>
#include <QToolButton>

namespace mb {
namespace {

/// Icon, name and a chevron when there is a menu. Plain QToolButton leaves no room between them.
class NameButton : public QToolButton {
public:
    NameButton(const ThemeSource &theme, QWidget *parent)
        : QToolButton(parent)
        , m_theme(theme)
    {
    }
    QSize sizeHint() const override
    {
        const Theme &theme = m_theme.theme();
        if (toolButtonStyle() == Qt::ToolButtonIconOnly)
            return {theme.u(6 + 20 + 6), theme.u(36)};
        const int chevron = menu() ? theme.u(8 + 12) : 0;
        return {theme.u(6 + 20 + 8 + 6) + fontMetrics().horizontalAdvance(text()) + chevron, theme.u(36)};
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        const Theme &theme = m_theme.theme();
        QStyleOptionToolButton option;
        initStyleOption(&option);
        option.text.clear();
        option.icon = {};
        QPainter painter(this);
        style()->drawComplexControl(QStyle::CC_ToolButton, &option, &painter, this);
        const int side = theme.u(20);
        applicationIcon().paint(&painter, QRect(theme.u(6), (height() - side) / 2, side, side));
        if (toolButtonStyle() == Qt::ToolButtonIconOnly)
            return;
        painter.setPen(theme.text);
        painter.drawText(rect().adjusted(theme.u(6 + 20 + 8), 0, 0, 0), Qt::AlignVCenter, text());
        const double small = theme.u(12);
        if (menu())
            paintSymbol(painter, QRectF(width() - theme.u(6) - small, (height() - small) / 2, small, small),
                Symbol::ChevronDown, theme.dim);
    }

private:
    const ThemeSource &m_theme;
};

} // namespace

HeaderBar::HeaderBar(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("header"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    auto *row = new QHBoxLayout(this);
    row->setSizeConstraint(QLayout::SetNoConstraint); // chips fold instead of holding the window wide
    buildName(*row);
    buildChips(*row);
    row->addStretch(1);
    buildSafety(*row);
    connect(&theme, &ThemeSource::changed, this, &HeaderBar::restyle);
    restyle();
    setNotices(0);
    setRecording({});
}

void HeaderBar::buildName(QHBoxLayout &row)
{
    m_name = new NameButton(m_theme, this);
    m_name->setText(tr("MotorBench"));
    m_name->setAccessibleName(tr("Program menu"));
    m_name->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_name->setPopupMode(QToolButton::InstantPopup);
    m_name->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    row.addWidget(m_name);
}

void HeaderBar::buildChips(QHBoxLayout &row)
{
    m_linkRow = new QHBoxLayout;
    row.addLayout(m_linkRow);
    m_folded = new Chip(m_theme, this);
    m_folded->hide();
    connect(m_folded, &Chip::clicked, this, &HeaderBar::linksActivated);
    row.addWidget(m_folded);
    m_notices = new Chip(m_theme, this);
    connect(m_notices, &Chip::clicked, this, &HeaderBar::noticesActivated);
    row.addWidget(m_notices);
    m_recording = new Chip(m_theme, this);
    m_recording->setGlyph(GlyphState::Recording);
    m_recording->setEdge(Tone::Danger);
    connect(m_recording, &Chip::clicked, this, &HeaderBar::recordingActivated);
    row.addWidget(m_recording);
}

void HeaderBar::buildSafety(QHBoxLayout &row)
{
    m_lamp = new Lamp(m_theme, this);
    m_stop = new StopButton(m_theme, this);
    row.addWidget(m_lamp);
    row.addWidget(m_stop);
}

void HeaderBar::restyle()
{
    const Theme &theme = m_theme.theme();
    auto *row = qobject_cast<QHBoxLayout *>(layout());
    row->setContentsMargins(theme.u(8), 0, theme.u(8), theme.u(2));
    row->setSpacing(theme.u(8));
    m_linkRow->setSpacing(theme.u(8));
    QFont bold = font();
    bold.setPointSizeF(theme.bodyPointSize * 1.08);
    bold.setBold(true);
    m_name->setFont(bold);
    setFixedHeight(theme.u(52));
    updateFolding();
    update();
}

void HeaderBar::setMenu(QMenu *menu)
{
    m_name->setMenu(menu);
    m_name->updateGeometry();
}

void HeaderBar::setLinks(const std::vector<LinkStatus> &links)
{
    while (m_links.size() > links.size()) {
        m_links.back()->deleteLater();
        m_links.back()->hide();
        m_links.pop_back();
    }
    while (m_links.size() < links.size()) {
        auto *chip = new LinkChip(m_theme, this);
        connect(chip, &Chip::clicked, this, [this, chip] { Q_EMIT linkActivated(chip->status().address); });
        m_linkRow->addWidget(chip);
        m_links.push_back(chip);
    }
    for (std::size_t i = 0; i < links.size(); ++i)
        m_links[i]->setStatus(links[i]);
    updateFolded();
    updateFolding();
}

void HeaderBar::updateFolded()
{
    const auto sick = std::ranges::find_if(m_links, [](const LinkChip *chip) { return !chip->status().healthy; });
    m_folded->setTitle(m_links.size() == 1 ? tr("1 link") : tr("%n links", nullptr, static_cast<int>(m_links.size())));
    m_folded->setGlyph(sick == m_links.end() ? GlyphState::Online : (*sick)->status().state);
    m_folded->setEdge(sick == m_links.end() ? std::nullopt : std::optional(Tone::Caution));
    setSpoken(*m_folded, tr("Links"), m_folded->accessibleDescription());
}

/// What gives way, in this order: "no alarms", the links' names, the program's name, the links, notices and recording. Lamp
/// and STOP come last: they become narrower, and are never cut.
void HeaderBar::updateFolding()
{
    const int gap = m_theme.theme().u(8);
    const auto room = [gap](const QWidget *widget) { return widget->sizeHint().width() + gap; };
    m_name->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    int needed = room(m_name) + room(m_lamp) + room(m_stop) + gap;
    int chips = 0;
    for (const LinkChip *chip : m_links)
        chips += room(chip);
    const int recording = m_hasRecording ? room(m_recording) : 0;
    const int notices = m_noticeCount > 0 ? room(m_notices) : 0;
    needed += recording + notices;
    const bool fold = needed + chips > width() && !m_links.empty();
    const int quiet = m_noticeCount == 0 && needed + chips + room(m_notices) <= width() ? room(m_notices) : 0;
    for (LinkChip *chip : m_links)
        chip->setVisible(!fold);
    const int folded = fold ? room(m_folded) : 0;
    if (needed + (fold ? folded : chips) > width()) {
        needed -= m_name->sizeHint().width();
        m_name->setToolButtonStyle(Qt::ToolButtonIconOnly);
        needed += m_name->sizeHint().width();
    }
    m_folded->setVisible(fold && needed + folded <= width());
    const int least = room(m_name) + m_lamp->minimumSizeHint().width() + m_stop->minimumSizeHint().width() + 3 * gap;
    m_notices->setVisible(quiet > 0 || (notices > 0 && least + notices <= width()));
    m_recording->setVisible(m_hasRecording && least + notices + recording <= width());
}

void HeaderBar::setNotices(int count)
{
    if (count == m_noticeCount)
        return;
    m_noticeCount = count;
    m_notices->setFlat(count == 0);
    m_notices->setGlyph(count == 0 ? GlyphState::Done : GlyphState::Warning);
    m_notices->setEdge(count == 0 ? std::nullopt : std::optional(Tone::Caution));
    const QString text = count == 0 ? tr("no alarms") : count == 1 ? tr("1 notice") : tr("%n notices", nullptr, count);
    m_notices->setTitle(text);
    setSpoken(*m_notices, text, m_notices->accessibleDescription());
    updateFolding();
}

void HeaderBar::setRecording(const QString &text)
{
    m_hasRecording = !text.isEmpty();
    m_recording->setTitle(text);
    setSpoken(*m_recording, tr("Recording"), m_recording->accessibleDescription());
    setSpokenLive(*m_recording, text);
    updateFolding();
}

void HeaderBar::setLampStatus(const LampStatus &status)
{
    if (m_lamp->status() == status)
        return;
    m_lamp->setStatus(status);
    updateFolding();
    update();
}

QSize HeaderBar::sizeHint() const
{
    return {m_theme.theme().u(1024), m_theme.theme().u(52)};
}

QSize HeaderBar::minimumSizeHint() const
{
    const Theme &theme = m_theme.theme();
    const int name = theme.u(6 + 20 + 6);
    return {name + m_lamp->minimumSizeHint().width() + m_stop->minimumSizeHint().width() + 5 * theme.u(8), theme.u(52)};
}

bool HeaderBar::event(QEvent *event)
{
    if (event->type() == QEvent::LayoutRequest)
        updateFolding();
    return QWidget::event(event);
}

void HeaderBar::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    painter.fillRect(rect(), theme.head);
    const LampState state = m_lamp->status().state;
    const bool energy = state == LampState::Armed || state == LampState::Moving || state == LampState::Stopping;
    const bool danger = state == LampState::MayTurn;
    const int edge = energy || danger ? theme.u(3) : 1;
    painter.fillRect(0, height() - edge, width(), edge, danger ? theme.stop : energy ? theme.armed : theme.line);
}

} // namespace mb
