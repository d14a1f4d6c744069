// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/recordstrip.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/stateglyph.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QHBoxLayout>
#include <QStandardPaths>

#include <algorithm>

namespace mb {

bool isRunning(const RecordingState &recording)
{
    return !recording.finished && recording.problem.empty();
}

RecordStrip::RecordStrip(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_theme(theme)
{
    build();
    hide();
    connect(&workbench, &Workbench::changed, this, &RecordStrip::follow);
}

void RecordStrip::build()
{
    m_button = new CommandButton(m_theme, Symbol::Record, tr("Record…"), this);
    m_button->setTextVariants({tr("Record…"), tr("End recording")});
    m_button->setToolTip(tr("Writes every frame of this link to a candump log or a Vector ASC file"));
    m_button->hide();
    m_glyph = new StateGlyph(m_theme, GlyphState::Recording, this);
    m_text = new ElidedLabel({}, this);
    m_dismiss = linkButton(tr("Dismiss"), this);
    auto *row = new QHBoxLayout(this);
    const int edge = m_theme.theme().u(12);
    row->setContentsMargins(edge, 0, edge, m_theme.theme().u(8));
    row->setSpacing(m_theme.theme().u(8));
    row->addWidget(m_glyph);
    row->addWidget(m_text, 1);
    row->addWidget(m_dismiss);
    connect(m_button, &QPushButton::clicked, this, &RecordStrip::toggle);
    connect(m_dismiss, &QPushButton::clicked, this, &RecordStrip::dismiss);
}

void RecordStrip::setLink(const std::string &link)
{
    m_link = link;
    follow();
}

void RecordStrip::toggle()
{
    const LinkView *link = m_workbench.snapshot().link(m_link);
    if (link && link->recording && isRunning(*link->recording))
        m_workbench.send(orders::StopRecording{m_link});
    else if (!m_button->isHidden())
        askWhereTo();
}

void RecordStrip::askWhereTo()
{
    const LinkView *link = m_workbench.snapshot().link(m_link);
    const QString name = QString::fromStdString(link->name);
    const QString file = QString(name).replace(QLatin1Char(':'), QLatin1Char('-'))
        + QDateTime::currentDateTime().toString(QStringLiteral("'-'yyyy-MM-dd-HHmmss'.log'"));
    askWhereToSave(*this, tr("Record the frames of %1").arg(name),
        tr("candump log (*.log)") + QStringLiteral(";;") + tr("Vector ASC log (*.asc)"),
        QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + QLatin1Char('/') + file,
        [this, address = m_link](const QString &path) {
            record(address, path); // another link may be shown meanwhile
        });
}

void RecordStrip::record(const std::string &address, const QString &path)
{
    const LinkView *link = m_workbench.snapshot().link(address);
    const QString name = link ? QString::fromStdString(link->name) : QString();
    m_dismissed.clear();
    m_workbench.send(orders::StartRecording{address, QFile::encodeName(path).toStdString()},
        [to = &m_workbench, name](const Result<void> &begun) {
            if (!begun)
                to->report(
                    Severity::Danger, name, tr("nothing is recorded: %1").arg(messageText(begun.error().message())));
        });
}

void RecordStrip::follow()
{
    const LinkView *link = m_workbench.snapshot().link(m_link);
    const bool running = link && link->recording && isRunning(*link->recording);
    m_button->setVisible(link && link->kind == LinkKind::Can && !link->replay);
    m_button->setText(running ? tr("End recording") : tr("Record…"));
    m_button->setSymbol(running ? Symbol::Stop : Symbol::Record, running ? Tone::Danger : Tone::Text);
    const QString problem = link && link->recording ? messageText(link->recording->problem) : QString();
    setVisible(running || (!problem.isEmpty() && problem != m_dismissed));
    if (isVisibleTo(parentWidget()))
        show(*link->recording);
}

void RecordStrip::show(const RecordingState &recording)
{
    const auto count = [](std::uint64_t number) { return formatCount(static_cast<qint64>(number)); };
    const bool running = isRunning(recording);
    m_glyph->setState(running ? GlyphState::Recording : GlyphState::Fault);
    m_dismiss->setVisible(!running);
    setTone(*m_text, !running ? Tone::Danger : recording.lost > 0 ? Tone::Caution : Tone::Text);
    if (!running) {
        m_text->setText(tr("The recording has ended: %1. %2 frames are missing in it.")
                            .arg(messageText(recording.problem), count(recording.lost)));
        return;
    }
    const Duration since = std::max(m_workbench.snapshot().time - recording.since, Duration::zero());
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(since).count();
    m_text->setText(
        tr("Recording  %1   %2 frames   %3   %4 lost   %5")
            .arg(formatClock(seconds), count(recording.frames), formatBytes(static_cast<qint64>(recording.bytes)),
                count(recording.lost), QDir::toNativeSeparators(QString::fromStdString(recording.path))));
}

void RecordStrip::dismiss()
{
    if (const LinkView *link = m_workbench.snapshot().link(m_link); link && link->recording)
        m_dismissed = messageText(link->recording->problem);
    hide();
}

} // namespace mb
