// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/banner.h"

#include "widgets/common/stateglyph.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace mb {
namespace {

QString kindWord(BannerKind kind)
{
    switch (kind) {
    case BannerKind::Caution: return QStringLiteral("caution");
    case BannerKind::Danger: return QStringLiteral("danger");
    case BannerKind::Ok: return QStringLiteral("ok");
    case BannerKind::Info: return QStringLiteral("info");
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
    }
    return GlyphState::Warning;
}

constexpr int narrow = 480; ///< below it the buttons stand under the words

QLabel *wrapped(TextRole role, Tone tone, QWidget *parent)
{
    QLabel *label = textLabel({}, role, tone, parent);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

Banner::Banner(const ThemeSource &theme, BannerKind kind, const QString &cause, const QString &remedy, QWidget *parent)
    : QFrame(parent)
    , m_theme(theme)
    , m_kind(kind)
{
    setProperty("banner", kindWord(kind));
    auto *row = new QHBoxLayout(this);
    auto *words = new QVBoxLayout;
    words->setSpacing(0);
    m_cause = wrapped(TextRole::Emphasis, Tone::Text, this);
    m_remedy = wrapped(TextRole::Body, Tone::Dim, this);
    words->addWidget(m_cause);
    words->addWidget(m_remedy);
    row->addLayout(words, 1);
    m_action = new QPushButton(this);
    m_action->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    m_dismiss = linkButton(tr("Dismiss"), this);
    row->addWidget(m_action);
    row->addWidget(m_dismiss);
    connect(m_action, &QPushButton::clicked, this, &Banner::actionTriggered);
    connect(m_dismiss, &QPushButton::clicked, this, &Banner::dismissed);
    connect(&theme, &ThemeSource::changed, this, &Banner::restyle);
    setText(cause, remedy);
    setAction({});
    restyle();
}

QString Banner::cause() const
{
    return m_cause->text();
}

void Banner::setText(const QString &cause, const QString &remedy)
{
    m_cause->setText(cause);
    m_remedy->setText(remedy);
    m_remedy->setVisible(!remedy.isEmpty());
    setAccessibleName(cause);
    setAccessibleDescription(remedy);
    fit();
}

void Banner::setAction(const QString &text)
{
    m_action->setText(text);
    m_action->setAccessibleName(text);
    m_action->setVisible(!text.isEmpty());
    fit();
}

/// Words are never cut, however large the font and narrow the window: what is below gets less room.
void Banner::fit()
{
    m_action->ensurePolished();
    m_action->setMinimumWidth(m_action->text().isEmpty() ? 0 : m_action->sizeHint().width());
    setToolTip(m_flat ? cause() + QLatin1Char('\n') + m_remedy->text() : QString());
    if (m_flat)
        setMinimumHeight(0);
    else if (width() > 0 && hasHeightForWidth())
        setMinimumHeight(heightForWidth(width()));
}

void Banner::resizeEvent(QResizeEvent *event)
{
    QFrame::resizeEvent(event);
    const bool beside = m_flat || width() >= m_theme.theme().u(narrow);
    qobject_cast<QBoxLayout *>(layout())->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    fit();
}

void Banner::setFlat(bool flat)
{
    m_flat = flat;
    for (QLabel *label : {m_cause, m_remedy}) {
        label->setWordWrap(!flat);
        label->setSizePolicy(flat ? QSizePolicy::Ignored : QSizePolicy::Preferred, QSizePolicy::Preferred);
    }
    restyle();
    fit();
}

void Banner::setDismissable(bool dismissable)
{
    m_dismiss->setVisible(dismissable);
}

void Banner::restyle()
{
    const Theme &theme = m_theme.theme();
    auto *row = qobject_cast<QHBoxLayout *>(layout());
    const int air = theme.u(m_flat ? 2 : 10);
    row->setContentsMargins(theme.u(12 + 20 + 12), air, theme.u(12), air);
    row->setSpacing(theme.u(12));
}

void Banner::paintEvent(QPaintEvent *event)
{
    QFrame::paintEvent(event);
    const Theme &theme = m_theme.theme();
    const QColor color = m_kind == BannerKind::Info ? theme.accent : glyphColor(kindGlyph(m_kind), theme);
    const double side = theme.u(18);
    QPainter painter(this);
    paintGlyph(painter, QRectF(theme.u(13), (height() - side) / 2, side, side), kindGlyph(m_kind), color);
}

BannerStack::BannerStack(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    m_column = new QVBoxLayout(this);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(theme.theme().u(8));
    m_more = linkButton({}, this);
    m_column->addWidget(m_more);
    connect(&theme, &ThemeSource::changed, this, &BannerStack::restyle);
    connect(m_more, &QPushButton::clicked, this, &BannerStack::allRequested);
    arrange();
}

void BannerStack::setReserved(bool on)
{
    m_reserved = on;
    m_column->setDirection(on ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_more->setSizePolicy(on ? QSizePolicy::Fixed : QSizePolicy::Preferred, QSizePolicy::Fixed);
    for (const Entry &entry : m_entries)
        entry.banner->setFlat(on);
    restyle();
    arrange();
}

void BannerStack::restyle()
{
    if (m_reserved)
        setFixedHeight(2 * fontMetrics().height() + m_theme.theme().u(12));
}

BannerStack::Entry *BannerStack::find(const QString &key)
{
    const auto found
        = std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry &entry) { return entry.key == key; });
    return found == m_entries.end() ? nullptr : &*found;
}

void BannerStack::post(
    const QString &key, BannerKind kind, const QString &cause, const QString &remedy, const QString &action)
{
    if (Entry *entry = find(key); entry && entry->banner->kind() == kind) {
        entry->banner->setText(cause, remedy);
        entry->banner->setAction(action);
        return;
    }
    clear(key);
    auto *banner = new Banner(m_theme, kind, cause, remedy, this);
    banner->setAction(action);
    banner->setFlat(m_reserved);
    connect(banner, &Banner::actionTriggered, this, [this, key] { Q_EMIT actionTriggered(key); });
    connect(banner, &Banner::dismissed, this, [this, key] {
        if (Entry *entry = find(key))
            entry->dismissed = true;
        arrange();
    });
    m_entries.insert(m_entries.begin(), Entry{key, banner, false});
    const auto severity = [](const Entry &entry) { return entry.banner->kind() == BannerKind::Danger ? 0 : 1; };
    std::stable_sort(
        m_entries.begin(), m_entries.end(), [&](const Entry &a, const Entry &b) { return severity(a) < severity(b); });
    arrange();
}

void BannerStack::clear(const QString &key)
{
    const auto found
        = std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry &entry) { return entry.key == key; });
    if (found == m_entries.end())
        return;
    found->banner->hide();
    found->banner->deleteLater();
    m_entries.erase(found);
    arrange();
}

int BannerStack::count() const
{
    return static_cast<int>(
        std::count_if(m_entries.begin(), m_entries.end(), [](const Entry &e) { return !e.dismissed; }));
}

void BannerStack::arrange()
{
    const int shown = m_reserved ? 1 : 2;
    int standing = 0;
    for (const Entry &entry : m_entries) {
        m_column->removeWidget(entry.banner);
        const bool visible = !entry.dismissed && standing < shown;
        if (visible)
            m_column->insertWidget(standing, entry.banner);
        entry.banner->setVisible(visible);
        standing += entry.dismissed ? 0 : 1;
    }
    m_more->setVisible(standing > shown);
    m_more->setText(standing == shown + 1 ? tr("1 more notice") : tr("%n more notices", nullptr, standing - shown));
    m_more->setAccessibleName(m_more->text());
    setVisible(standing > 0 || m_reserved);
    Q_EMIT countChanged(standing);
}

} // namespace mb
