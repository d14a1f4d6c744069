// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/queuebar.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/wraplayout.h"

#include <QHBoxLayout>
#include <QProgressBar>

#include <cmath>

#include <algorithm>

namespace mb {
namespace {

constexpr int shareSteps = 1000;
constexpr int progressBesideFrom = 820; ///< units

/// What there is none of is left out: there is little room beside the buttons.
QString countsOf(const QueueTotals &totals)
{
    QStringList parts{QueueBar::tr("%1 done").arg(totals.passed)};
    if (totals.waiting > 0)
        parts += QueueBar::tr("%1 waiting").arg(totals.waiting);
    if (totals.failed > 0)
        parts += QueueBar::tr("%1 failed").arg(totals.failed);
    if (totals.refused > 0)
        parts += QueueBar::tr("%1 refused").arg(totals.refused);
    if (totals.mean)
        parts += QueueBar::tr("mean %1").arg(formatValue(*totals.mean, 1, QStringLiteral("s")));
    return parts.join(QStringLiteral(" · "));
}

} // namespace

QueueBar::QueueBar(const ThemeSource &theme, QWidget *parent)
    : TurningRow(theme, progressBesideFrom, parent)
    , m_theme(theme)
{
    const int edge = theme.theme().u(8);
    parts().setContentsMargins(theme.theme().u(16), edge, theme.theme().u(16), edge);
    parts().setSpacing(edge);
    buildProgress();
    buildOrders();
    connect(this, &TurningRow::arranged, this, [this](bool turned) { // below the progress all but Start are symbols
        for (CommandButton *button : {m_pause, m_cancel, m_retry, m_export})
            button->setIconOnly(turned);
    });
}

void QueueBar::buildProgress()
{
    auto *box = new QVBoxLayout;
    box->setSpacing(m_theme.theme().u(2));
    auto *words = new QHBoxLayout;
    m_headline = textLabel({}, TextRole::Body, Tone::Text, this);
    m_headline->setWordWrap(true); // it may be a cause
    setTextRole(*m_headline, TextRole::Emphasis);
    m_headline->setAccessibleName(tr("State of the queue"));
    m_left = textLabel({}, TextRole::Body, Tone::Dim, this);
    words->addWidget(m_headline, 1);
    words->addWidget(m_left);
    m_share = new QProgressBar(this);
    m_share->setAccessibleName(tr("Progress of the queue"));
    m_share->setTextVisible(false);
    m_share->setRange(0, shareSteps);
    m_share->setFixedHeight(m_theme.theme().u(8));
    m_counts = new ElidedLabel({}, this);
    setTextRole(*m_counts, TextRole::Caption);
    setTone(*m_counts, Tone::Dim);
    box->addLayout(words);
    box->addWidget(m_share);
    box->addWidget(m_counts);
    parts().addLayout(box, 1);
}

void QueueBar::buildOrders()
{
    m_pause = new CommandButton(m_theme, Symbol::Pause, tr("Pause after this unit"), this);
    m_pause->setTextVariants({tr("Pause after this unit"), tr("Go on")});
    m_cancel = new CommandButton(m_theme, Symbol::Close, tr("Cancel"), this);
    m_retry = new CommandButton(m_theme, Symbol::Refresh, tr("Retry failed"), this);
    m_export = new CommandButton(m_theme, Symbol::Export, tr("Save CSV…"), this);
    m_start = new CommandButton(m_theme, Symbol::Play, tr("Start"), this);
    m_start->setKeyHint(QStringLiteral("F5"));
    m_start->setPrimary(true);
    auto *row = new WrapLayout;
    row->setSpacing(m_theme.theme().u(8));
    for (QWidget *button : std::initializer_list<QWidget *>{m_pause, m_cancel, m_retry, m_export, m_start})
        row->addWidget(button);
    parts().addLayout(row);
    connect(m_start, &QPushButton::clicked, this, &QueueBar::startWanted);
    connect(m_pause, &QPushButton::clicked, this, [this] { Q_EMIT pauseWanted(!m_pausing); });
    connect(m_cancel, &QPushButton::clicked, this, &QueueBar::cancelWanted);
    connect(m_retry, &QPushButton::clicked, this, &QueueBar::retryWanted);
    connect(m_export, &QPushButton::clicked, this, &QueueBar::exportWanted);
}

void QueueBar::follow(const ServiceView &view, const QueueTotals &totals, const QString &hindrance)
{
    m_pausing = view.pausing;
    const int now = std::min(totals.ended + std::max(totals.running, 1), totals.units);
    if (!view.trouble.empty())
        m_headline->setText(tr("Ended before its time: %1").arg(messageText(view.trouble)));
    else if (view.running && view.pausing)
        m_headline->setText(totals.running > 0 ? tr("Pauses after this unit") : tr("Paused"));
    else if (view.running)
        m_headline->setText(tr("Unit %1 of %2").arg(now).arg(totals.units));
    else if (totals.units > 0)
        m_headline->setText(totals.waiting > 0 ? tr("Ended with %n unit(s) to go", nullptr, totals.waiting)
                                               : tr("Ended: %1 of %2 units").arg(totals.ended).arg(totals.units));
    else
        m_headline->setText(tr("Nothing running"));
    setTone(*m_headline, view.trouble.empty() ? Tone::Text : Tone::Danger);
    m_left->setText(view.running && totals.secondsLeft
            ? tr("about %1 s left").arg(static_cast<int>(std::ceil(*totals.secondsLeft)))
            : QString());
    m_share->setValue(static_cast<int>(totals.share * shareSteps));
    setTone(*m_share, totals.units > 0 && totals.passed == totals.units ? Tone::Ok : Tone::Text);
    m_counts->setText(countsOf(totals));
    m_pause->setRole(view.pausing ? tr("Go on") : tr("Pause after this unit"));
    m_pause->setSymbol(view.pausing ? Symbol::Play : Symbol::Pause);
    m_pause->setEnabled(view.running);
    m_cancel->setEnabled(view.running);
    m_retry->setEnabled(totals.failed > 0);
    m_export->setEnabled(totals.ended > 0);
    m_start->setEnabled(hindrance.isEmpty());
    m_start->setToolTip(hindrance);
    m_start->setAccessibleDescription(hindrance);
}

QString QueueBar::headline() const
{
    return m_headline->text();
}

} // namespace mb
