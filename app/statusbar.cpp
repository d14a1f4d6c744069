// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/statusbar.h"

#include "widgets/common/clocktext.h"
#include "widgets/common/labels.h"
#include "widgets/common/losses.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/spoken.h"

#include <fstream>

#include <unistd.h>

namespace mb {
namespace {

constexpr std::chrono::seconds messageTime{8}, footprintTime{1};

QString wordsOf(const Notice &notice)
{
    return (notice.device.isEmpty() ? QString() : notice.device + QStringLiteral(": ")) + notice.text;
}

/// Memory of this process that is in RAM now; 0 when the system does not tell.
std::int64_t residentBytes()
{
    std::ifstream statm("/proc/self/statm");
    std::int64_t total = 0;
    std::int64_t resident = 0;
    statm >> total >> resident;
    return statm ? resident * ::sysconf(_SC_PAGESIZE) : 0;
}

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
    m_messageTime.setObjectName(QStringLiteral("messageTime"));
    connect(&m_messageTime, &QTimer::timeout, this, &StatusBar::endMessage);
    connect(&workbench, &Workbench::noticed, this, &StatusBar::take);
    connect(&m_footprintTime, &QTimer::timeout, this, &StatusBar::showFootprint);
    m_footprintTime.start(footprintTime);
    showFootprint();
}

void StatusBar::forget()
{
    m_grave.reset();
    m_messageTime.stop();
    m_message->clear();
    setSpoken(*m_message, {}, {});
}

void StatusBar::take(const Notice &notice)
{
    write(notice);
    announce(*m_message, wordsOf(notice));
    m_messageTime.stop();
    if (notice.severity == Severity::Danger)
        m_grave = notice;
    else
        m_messageTime.start(messageTime);
}

/// What is grave stands again after what was told meanwhile.
void StatusBar::endMessage()
{
    if (!m_grave)
        return forget();
    write(*m_grave);
    setSpoken(*m_message, wordsOf(*m_grave), {});
}

void StatusBar::write(const Notice &notice)
{
    m_message->setText(clockText(momentOf(m_workbench, notice.time)) + QLatin1Char(' ') + wordsOf(notice));
    setTone(*m_message,
        notice.severity == Severity::Danger        ? Tone::Danger
            : notice.severity == Severity::Caution ? Tone::Caution
                                                   : Tone::Text);
}

void StatusBar::showFootprint()
{
    const auto [samples, lost] = samplesOn(m_workbench.snapshot());
    m_footprint->setText(tr("samples %1   lost %2   memory %3")
                             .arg(formatCount(static_cast<qint64>(samples)), formatCount(static_cast<qint64>(lost)),
                                 formatBytes(residentBytes())));
}

} // namespace mb
