// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/statusbar.h"

#include "app/footprint.h"
#include "widgets/common/clocktext.h"
#include "widgets/common/labels.h"
#include "widgets/common/losses.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/spoken.h"

namespace mb {
namespace {

constexpr std::chrono::seconds messageTime{8}, footprintTime{1};

} // namespace

StatusBar::StatusBar(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QStatusBar(parent)
    , m_workbench(workbench)
    , m_message(new ElidedLabel({}, this))
    , m_footprint(textLabel({}, TextRole::Caption, Tone::Dim, this))
{
    setSizeGripEnabled(false);
    setMinimumWidth(1);
    const int edge = theme.theme().u(12);
    m_message->setContentsMargins(edge, 0, 0, 0);
    m_footprint->setContentsMargins(0, 0, edge, 0);
    m_footprint->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    addWidget(m_message, 1);
    addPermanentWidget(m_footprint);
    m_messageTime.setSingleShot(true);
    connect(&m_messageTime, &QTimer::timeout, this, &StatusBar::forget);
    connect(&workbench, &Workbench::noticed, this, &StatusBar::showNotice);
    connect(&m_footprintTime, &QTimer::timeout, this, &StatusBar::showFootprint);
    m_footprintTime.start(footprintTime);
    showFootprint();
}

void StatusBar::forget()
{
    m_isGrave = false;
    m_message->clear();
    setSpoken(*m_message, {}, {});
}

void StatusBar::showNotice(const Notice &notice)
{
    if (m_isGrave && notice.severity != Severity::Danger)
        return; // the page Log has it
    m_isGrave = notice.severity == Severity::Danger;
    const QString time = clockText(momentOf(m_workbench, notice.time));
    const QString words = (notice.device.isEmpty() ? QString() : notice.device + QStringLiteral(": ")) + notice.text;
    m_message->setText(time + QLatin1Char(' ') + words);
    announce(*m_message, words);
    setTone(*m_message, m_isGrave ? Tone::Danger : notice.severity == Severity::Caution ? Tone::Caution : Tone::Text);
    if (m_isGrave)
        m_messageTime.stop();
    else
        m_messageTime.start(messageTime);
}

void StatusBar::showFootprint()
{
    const auto [samples, lost] = samplesOn(m_workbench.snapshot());
    m_footprint->setText(tr("samples %1   lost %2   memory %3")
                             .arg(formatCount(static_cast<qint64>(samples)), formatCount(static_cast<qint64>(lost)),
                                 formatBytes(residentBytes())));
}

} // namespace mb
