// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/recordingcontrol.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/workbench.h"
#include "widgets/plots/recorder.h"
#include "widgets/plots/telemetrysource.h"

#include <cmath>

namespace mb {

RecordingControl::RecordingControl(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_button(new CommandButton(theme, Symbol::Record, tr("Record"), this))
    , m_words(textLabel({}, TextRole::Caption, Tone::Dim, this))
{
    auto *row = layoutIn<QHBoxLayout>(this, theme.theme().u(8));
    m_button->setKeyHint(QStringLiteral("R"));
    m_button->setTextVariants({tr("Record"), tr("Save")});
    m_words->hide();
    row->addWidget(m_button);
    row->addWidget(m_words);
    hide();
    connect(m_button, &QPushButton::clicked, this, &RecordingControl::toggle);
}

void RecordingControl::setRecorder(Recorder *recorder, const QString &folder)
{
    m_recorder = recorder;
    m_folder = folder;
    setVisible(recorder != nullptr);
    if (!recorder)
        return;
    m_button->setToolTip(tr("Keeps everything that devices send, beginning with the last %1.\n"
                            "What was recorded lately is on disk all the time and outlives a crash.")
                             .arg(formatDuration(std::chrono::duration<double>(recorder->kept()).count())));
    connect(recorder, &Recorder::changed, this, &RecordingControl::follow);
    connect(recorder, &Recorder::saved, this, [this](const QString &path, const QString &error) {
        m_workbench.report(error.isEmpty() ? Severity::Good : Severity::Danger, {},
            error.isEmpty() ? tr("recording written to %1").arg(path) : error);
        follow();
    });
}

void RecordingControl::setWide(bool wide)
{
    m_words->setVisible(wide);
}

void RecordingControl::note(Instant time, const QString &text)
{
    if (m_recorder)
        m_recorder->note(time, text);
}

void RecordingControl::toggle()
{
    if (!m_recorder)
        return;
    if (!m_recorder->state().keeping)
        return m_recorder->startKeeping(m_folder);
    if (m_recorder->state().saving)
        return;
    m_recorder->save(recordingIn(m_folder));
}

void RecordingControl::follow()
{
    if (!m_recorder)
        return;
    const Recorder::State state = m_recorder->state();
    m_button->setRole(state.keeping ? tr("Save") : tr("Record"));
    m_button->setSymbol(Symbol::Record, state.keeping ? Tone::Danger : Tone::Text);
    m_button->setEnabled(!state.saving);
    if (!state.failure.isEmpty()) {
        m_words->setText(tr("not recorded: %1").arg(state.failure));
        return;
    }
    const double seconds = state.samples > 0 ? plotKey(m_workbench.now()) - state.since : 0.0;
    const QString length = formatDuration(std::floor(std::max(seconds, 0.0)));
    const QString size = formatBytes(static_cast<qint64>(state.bytes));
    m_words->setText(state.keeping
            ? tr("%1 · %2 · %3 samples").arg(length, size, formatCount(static_cast<qint64>(state.samples)))
            : tr("last %1 on disk · %2").arg(length, size));
    m_button->setAccessibleDescription(m_words->text());
}

} // namespace mb
