// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/banner.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/stateglyph.h"

#include <QApplication>
#include <QPainter>
#include <QPushButton>

#include <algorithm>
#include <utility>

namespace mb {
namespace {

constexpr int bannerHeight = 36; ///< units: a button, and air around it
constexpr int bannerAir = 2;     ///< above and below

QString kindWord(BannerKind kind)
{
    switch (kind) {
    case BannerKind::Caution: return QStringLiteral("caution");
    case BannerKind::Danger: return QStringLiteral("danger");
    case BannerKind::Ok: return QStringLiteral("ok");
    case BannerKind::Info: return QStringLiteral("info");
    case BannerKind::Ended: return QStringLiteral("ended");
    }
    return {};
}

GlyphState kindGlyph(BannerKind kind)
{
    switch (kind) {
    case BannerKind::Caution: return GlyphState::Warning;
    case BannerKind::Danger: return GlyphState::Fault;
    case BannerKind::Ok: return GlyphState::Done;
    case BannerKind::Info: return GlyphState::Busy;
    case BannerKind::Ended: return GlyphState::Fault;
    }
    return GlyphState::Warning;
}

void name(CommandButton &button, const QString &text)
{
    button.setRole(text);
    button.setVisible(!text.isEmpty());
}

} // namespace

Banner::Banner(const ThemeSource &theme, BannerKind kind, const QString &cause, const QString &remedy, QWidget *parent)
    : QFrame(parent)
    , m_theme(theme)
    , m_kind(kind)
{
    setProperty("banner", kindWord(kind));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    m_cause = new ElidedLabel({}, this);
    setTextRole(*m_cause, TextRole::Emphasis);
    m_remedy = new ElidedLabel({}, this);
    setTone(*m_remedy, Tone::Dim);
    m_remedy->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_action = new CommandButton(theme, {}, this);
    m_dismiss = linkButton(tr("Dismiss"), this);
    m_action->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    new QGridLayout(this);
    connect(m_action, &QPushButton::clicked, this, &Banner::actionTriggered);
    connect(m_dismiss, &QPushButton::clicked, this, [this] {
        if (!m_action->isFresh()) // else nobody has read it
            Q_EMIT dismissed();
    });
    connect(&theme, &ThemeSource::changed, this, &Banner::restyle);
    setText(cause, remedy);
    setAction({});
    restyle();
}

void Banner::setText(const QString &cause, const QString &remedy)
{
    m_cause->setText(cause);
    m_remedy->setText(remedy);
    setToolTip(remedy.isEmpty() ? cause : cause + QLatin1Char('\n') + remedy);
    setAccessibleName(cause);
    setAccessibleDescription(remedy);
}

void Banner::setAction(const QString &text)
{
    name(*m_action, text);
}

void Banner::setOther(const QString &text)
{
    if (!m_other && text.isEmpty())
        return;
    if (!m_other) {
        m_other = new CommandButton(m_theme, {}, this);
        m_other->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
        connect(m_other, &QPushButton::clicked, this, &Banner::otherTriggered);
        place();
    }
    name(*m_other, text);
}

void Banner::setTwoLines(bool on)
{
    if (std::exchange(m_twoLines, on) != on)
        restyle();
}

int Banner::heightOf(const Theme &theme, bool twoLines)
{
    const int line = QFontMetrics(theme.font(TextRole::Emphasis, QApplication::font())).height();
    return std::max(theme.u(bannerHeight), twoLines ? 2 * line + theme.u(2 * bannerAir) : 0);
}

/// In one line the remedy has what the cause leaves; in two the orders stand beside both.
void Banner::place()
{
    auto *grid = qobject_cast<QGridLayout *>(layout());
    const int below = m_twoLines ? 1 : 0;
    const int lines = below + 1;
    for (QWidget *part : std::initializer_list<QWidget *>{m_cause, m_remedy, m_action, m_dismiss})
        grid->removeWidget(part);
    if (m_other) {
        grid->removeWidget(m_other);
        grid->addWidget(m_other, 0, 3, lines, 1);
    }
    grid->addWidget(m_cause, 0, 0, 1, lines);
    grid->addWidget(m_remedy, below, 1 - below, 1, lines);
    grid->addWidget(m_action, 0, 2, lines, 1);
    grid->addWidget(m_dismiss, 0, 4, lines, 1);
    grid->setColumnStretch(1, 1);
}

void Banner::restyle()
{
    const Theme &theme = m_theme.theme();
    place();
    layout()->setContentsMargins(theme.u(12 + 18 + 10), theme.u(bannerAir), theme.u(12), theme.u(bannerAir));
    qobject_cast<QGridLayout *>(layout())->setHorizontalSpacing(theme.u(12));
    qobject_cast<QGridLayout *>(layout())->setVerticalSpacing(0);
    setFixedHeight(heightOf(theme, m_twoLines));
}

/// Where another stood a moment ago.
void Banner::showEvent(QShowEvent *event)
{
    QFrame::showEvent(event);
    for (CommandButton *button : {m_action, m_other}) {
        if (button)
            button->changeRole();
    }
}

void Banner::paintEvent(QPaintEvent *event)
{
    QFrame::paintEvent(event);
    const Theme &theme = m_theme.theme();
    const QColor color = m_kind == BannerKind::Info ? theme.accent
        : m_kind == BannerKind::Ended               ? theme.dim
                                                    : glyphColor(kindGlyph(m_kind), theme);
    const double side = theme.u(18);
    QPainter painter(this);
    paintGlyph(painter, QRectF(theme.u(12), (height() - side) / 2, side, side), kindGlyph(m_kind), color);
}

BannerStack::BannerStack(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    m_row = layoutIn<QHBoxLayout>(this, theme.theme().u(8));
    m_more = linkButton({}, this);
    m_more->setObjectName(QStringLiteral("moreNotices"));
    m_more->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    m_row->addWidget(m_more);
    connect(&theme, &ThemeSource::changed, this, [this] { setTwoLines(m_twoLines); });
    connect(m_more, &QPushButton::clicked, this, &BannerStack::allRequested);
    setTwoLines(false);
    arrange();
}

void BannerStack::setTwoLines(bool on)
{
    m_twoLines = on;
    for (const Entry &entry : m_entries)
        entry.banner->setTwoLines(on);
    m_more->setVisible(count() > 1 && !on); // there the words need the room, and the header counts them
    setFixedHeight(Banner::heightOf(m_theme.theme(), on));
}

BannerStack::Entry *BannerStack::find(const QString &key)
{
    const auto found = std::ranges::find(m_entries, key, &Entry::key);
    return found == m_entries.end() ? nullptr : &*found;
}

void BannerStack::post(const QString &key, BannerKind kind, const QString &cause, const QString &remedy,
    const QString &action, const QString &other)
{
    if (Entry *entry = find(key); entry && entry->banner->kind() == kind) {
        entry->banner->setText(cause, remedy);
        entry->banner->setAction(action);
        entry->banner->setOther(other);
        return;
    }
    clear(key);
    auto *banner = new Banner(m_theme, kind, cause, remedy, this);
    banner->setAction(action);
    banner->setOther(other);
    banner->setTwoLines(m_twoLines);
    connect(banner, &Banner::actionTriggered, this, [this, key] { Q_EMIT actionTriggered(key); });
    connect(banner, &Banner::otherTriggered, this, [this, key] { Q_EMIT otherTriggered(key); });
    connect(banner, &Banner::dismissed, this, [this, key] {
        if (Entry *entry = find(key))
            entry->dismissed = true;
        arrange();
    });
    m_entries.insert(m_entries.begin(), Entry{key, banner, false});
    const auto severity = [](const Entry &entry) { return entry.banner->kind() == BannerKind::Danger ? 0 : 1; };
    std::ranges::stable_sort(m_entries, [&](const Entry &a, const Entry &b) { return severity(a) < severity(b); });
    arrange();
}

void BannerStack::clear(const QString &key, bool forget)
{
    const auto found = std::ranges::find(m_entries, key, &Entry::key);
    if (found == m_entries.end() || (found->dismissed && !forget))
        return;
    found->banner->hide();
    found->banner->deleteLater();
    m_entries.erase(found);
    arrange();
}

int BannerStack::count() const
{
    return static_cast<int>(std::ranges::count_if(m_entries, [](const Entry &e) { return !e.dismissed; }));
}

void BannerStack::arrange()
{
    int standing = 0;
    for (const Entry &entry : m_entries) {
        const bool first = !entry.dismissed && standing == 0;
        m_row->removeWidget(entry.banner);
        if (first)
            m_row->insertWidget(0, entry.banner, 1);
        entry.banner->setVisible(first);
        standing += entry.dismissed ? 0 : 1;
    }
    m_more->setVisible(standing > 1 && !m_twoLines);
    m_more->setText(standing == 2 ? tr("1 more notice") : tr("%n more notices", nullptr, standing - 1));
    m_more->setAccessibleName(m_more->text());
    Q_EMIT countChanged(standing);
}

} // namespace mb
